//! Tests of requests from their JSON to their statistics and archives.

#![allow(
    clippy::disallowed_macros,
    clippy::disallowed_methods,
    clippy::disallowed_types,
    clippy::too_many_lines,
    reason = "tests"
)]

mod cases;
mod closed_forms;
mod exported_meshes;
mod frozen_examples;
mod mutated_requests;
#[path = "../../../archive/tests/it/sample.rs"]
mod sample;
#[path = "../../../../tests/skips/mod.rs"]
mod skips;
mod tensile_cases;

use plateau_forms::json;
use plateau_forms::limits::Limits;
use plateau_forms::rejection::Rejection;
use plateau_forms::request::Request;
use plateau_forms::source::no_jobs;
use std::path::{Path, PathBuf};

/// Limits of a server with default settings.
const LIMITS: Limits = Limits {
    points: 200_000,
    triangles: 2_000_000,
    grid_cells: 2_000_000_000,
    iterations: 1_000_000,
    memory_bytes: 4 << 30,
};

/// Reads a request that names its own kind.
fn read(body: &[u8]) -> Result<Request, Rejection> {
    Request::read_with_kind(&json::parse(body)?, &no_jobs, &LIMITS).map(|accepted| accepted.request)
}

/// Returns the folder of the repository.
fn root() -> PathBuf {
    Path::new(env!("CARGO_MANIFEST_DIR")).join("../..")
}
