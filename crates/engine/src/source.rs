//! The finished job from which a request begins.

use plateau_archive::{Archive, Lines};
use schemars::JsonSchema;
use serde::{Deserialize, Serialize};
use std::sync::Arc;

/// A finished job whose result the request begins with.
#[derive(Clone, Debug, PartialEq, Eq, Serialize, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub struct JobSource {
    /// Identifier of a job of the same owner that has succeeded.
    pub job: String,
}

/// JSON Pointer to the identifier in every request that has a source.
pub const POINTER: &str = "/source/job";

/// The result of a finished job.
#[derive(Clone, Debug)]
pub struct Source {
    archive: Arc<Archive>,
    key: Vec<u8>,
}

impl Source {
    /// `key` is the name by which the host finds the result again.
    #[must_use]
    pub fn new(archive: Archive, key: Vec<u8>) -> Self {
        Self { archive: Arc::new(archive), key }
    }

    #[must_use]
    pub fn archive(&self) -> &Archive {
        &self.archive
    }

    /// Returns the statistics of the job as JSON text.
    #[must_use]
    pub fn statistics(&self) -> &str {
        &self.archive.contents().statistics
    }

    #[must_use]
    pub fn key(&self) -> &[u8] {
        &self.key
    }

    /// Returns an estimate of the memory that the result takes, in bytes.
    #[must_use]
    pub fn memory_bytes(&self) -> u64 {
        let contents = self.archive.contents();
        let lines = contents.line_sets.iter().map(|set| match &set.lines {
            Lines::Polylines(polylines) => polylines.iter().map(|line| 4 * line.vertices.len()).sum(),
            Lines::Segments(pairs) => 8 * pairs.len(),
            Lines::Arrows(ends) => 48 * ends.len(),
        });
        let of_lines = contents.line_sets.iter().flat_map(|set| &set.attributes);
        let attributes = contents.vertex_attributes.iter().chain(&contents.triangle_attributes).chain(of_lines);
        let values: usize = attributes.map(|attribute| 8 * attribute.values.len()).sum();
        let mesh = 24 * contents.mesh.vertices.len() + 12 * contents.mesh.triangles.len();
        (mesh + lines.sum::<usize>() + values + contents.statistics.len()) as u64
    }
}

/// Function of the host that finds the result of the job with an identifier. If there is no result, it returns the
/// reason as a phrase without a subject, such as `is still running`.
pub type Find<'a> = &'a dyn Fn(&str) -> Result<Source, String>;

/// Finds no source, for hosts without jobs.
///
/// # Errors
/// Always returns the reason.
pub fn no_jobs(_: &str) -> Result<Source, String> {
    Err("names a job, and there are jobs only on a server: post the request to the server that has the job".into())
}
