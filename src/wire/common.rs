//! Types that requests of every kind share: points, and the fields that concern the job.

use super::{FieldError, Rejection};
use plateau_mesh::DVec3;
use schemars::JsonSchema;
use serde::Deserialize;
use serde_json::{Map, Value};

/// A point `[x, y, z]` in the client's axes and unit.
pub type Point = [f64; 3];

/// Whether the result of an equal earlier request may be returned. Results are deterministic, so it has the same bytes.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, Deserialize, JsonSchema)]
#[serde(rename_all = "snake_case")]
pub enum Cache {
    /// Return a stored result if there is one, and store this one for later requests.
    #[default]
    Reuse,
    /// Solve again, and do not store the result for later requests.
    Bypass,
}

/// Fields that requests of every kind have because they concern the job and not its result.
#[derive(Clone, Debug, Deserialize, JsonSchema)]
pub struct JobFields {
    /// Whether the stored result of an equal earlier request may be returned.
    #[serde(default)]
    pub cache: Cache,
    /// URL (https) that receives a signed POST when the job ends. Requires webhooks to be enabled on this server: see
    /// `webhooks` of `GET /v1/limits`.
    #[serde(default)]
    #[schemars(length(max = 2000))]
    pub callback_url: Option<String>,
    /// Name of the job for people. The job and lists of jobs show it.
    #[serde(default)]
    #[schemars(length(max = 200))]
    pub label: Option<String>,
    /// Any fields of the client, at most 4096 bytes as JSON text. The job and lists of jobs show them.
    #[serde(default)]
    pub metadata: Option<Map<String, Value>>,
    /// Key of a series of requests of which only the newest counts, such as those of one drag. Once this request is
    /// accepted, older jobs with the same key that have not ended are cancelled.
    #[serde(default)]
    #[schemars(length(min = 1, max = 200))]
    pub supersede: Option<String>,
    /// Cancel the job if the client closes the connection while it waits for the end. Requires `Prefer: wait`.
    #[serde(default)]
    pub cancel_on_disconnect: bool,
}

/// What a checked request says of its job.
#[derive(Clone, Debug, Default, PartialEq, Eq)]
pub struct Marks {
    pub label: Option<String>,
    /// A JSON object as text.
    pub metadata: Option<String>,
    pub supersede: Option<String>,
    pub cancel_on_disconnect: bool,
}

/// Largest length of a job's metadata as JSON text in bytes.
const METADATA_BYTES: usize = 4096;

impl Marks {
    /// Makes the checks that the schema cannot express.
    ///
    /// # Errors
    /// Returns every offending value.
    pub(super) fn new(job: &JobFields) -> Result<Self, Rejection> {
        let mut errors = Vec::new();
        for (pointer, text) in [("/label", &job.label), ("/supersede", &job.supersede)] {
            // PostgreSQL cannot store a NUL, and no other control character belongs on one line.
            if text.as_ref().is_some_and(|text| text.chars().any(char::is_control)) {
                errors.push(FieldError::new(pointer, "must not contain control characters"));
            }
        }
        let metadata = job.metadata.as_ref().map(|fields| Value::Object(fields.clone()).to_string());
        if let Some(text) = metadata.as_ref().filter(|text| text.len() > METADATA_BYTES) {
            let detail = format!("has {} bytes as JSON text, more than {METADATA_BYTES}", text.len());
            errors.push(FieldError::new("/metadata", detail));
        }
        if !errors.is_empty() {
            return Err(Rejection::Invalid(errors));
        }
        Ok(Self {
            label: job.label.clone(),
            metadata,
            supersede: job.supersede.clone(),
            cancel_on_disconnect: job.cancel_on_disconnect,
        })
    }
}

/// Converts points of the wire to points of the geometry.
#[must_use]
pub fn points(polyline: &[Point]) -> Vec<DVec3> {
    polyline.iter().map(|&point| DVec3::from_array(point)).collect()
}

#[must_use]
pub fn polylines(polylines: &[Vec<Point>]) -> Vec<Vec<DVec3>> {
    polylines.iter().map(|polyline| points(polyline)).collect()
}

/// Refuses polylines that together have more than `max_points` points.
///
/// # Errors
/// Returns [`Rejection::TooLarge`] at the field.
pub fn check_point_count(field: &str, polylines: &[Vec<Point>], max_points: usize) -> Result<(), Rejection> {
    check_count(field, polylines.iter().map(Vec::len).sum(), max_points, "points")
}

/// Refuses a field with more than `most` entries. `what` says in the plural what is counted.
///
/// # Errors
/// Returns [`Rejection::TooLarge`] at the field.
pub fn check_count(field: &str, count: usize, most: usize, what: &str) -> Result<(), Rejection> {
    if count > most {
        let detail = format!("has more {what} than this server accepts ({most}); see GET /v1/limits");
        return Err(Rejection::TooLarge(vec![FieldError::new(field, detail)]));
    }
    Ok(())
}

/// Refuses a number above `most`.
///
/// # Errors
/// Returns [`Rejection::TooLarge`] at the field.
pub fn check_number(field: &str, number: Option<u32>, most: usize) -> Result<(), Rejection> {
    if number.is_some_and(|number| number as usize > most) {
        let detail = format!("is more than this server allows ({most}); see GET /v1/limits");
        return Err(Rejection::TooLarge(vec![FieldError::new(field, detail)]));
    }
    Ok(())
}
