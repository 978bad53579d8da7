//! Reasons for which a request is refused.

use plateau_mesh::error::Step;
use plateau_mesh::{Error as GeometryError, InputError};
use serde_json::Value;

/// Maximum number of errors that are listed for one body.
pub const MAX_ERRORS: usize = 50;

/// One offending value of a body. Values are never echoed.
#[derive(Clone, Debug, PartialEq, Eq, serde::Serialize, serde::Deserialize, schemars::JsonSchema)]
pub struct FieldError {
    /// JSON Pointer (RFC 6901) to the offending value.
    pub pointer: String,
    /// Description of the error.
    pub detail: String,
}

impl FieldError {
    pub fn new(pointer: impl Into<String>, detail: impl Into<String>) -> Self {
        Self { pointer: pointer.into(), detail: detail.into() }
    }

    /// Adds this error to others, unless there are more than [`MAX_ERRORS`] already. A request may have a fault in each
    /// of a million values, whose errors would take many times the memory of the request.
    pub fn add_to(self, errors: &mut Vec<Self>) {
        if errors.len() <= MAX_ERRORS {
            errors.push(self);
        }
    }

    /// Refuses an object at `pointer` unless exactly one of its members is given.
    ///
    /// # Errors
    /// Returns an error that names the members.
    pub fn unless_one(pointer: &str, members: &[(&str, bool)]) -> Result<(), Self> {
        if members.iter().filter(|(_, given)| *given).count() == 1 {
            return Ok(());
        }
        let names: Vec<&str> = members.iter().map(|(name, _)| *name).collect();
        Err(Self::new(pointer, format!("must have exactly one of the members {}", names.join(", "))))
    }
}

/// Names of geometry options whose request fields have other names, because the request has angles in degrees.
const RENAMED: [(&str, &str); 2] =
    [("convexity_tolerance", "convexity_tolerance_deg"), ("degenerate_angle", "degenerate_angle_deg")];

impl From<&InputError> for FieldError {
    fn from(error: &InputError) -> Self {
        let step = |step: &Step| match *step {
            Step::Field(field) => {
                let name = RENAMED.iter().find(|(option, _)| *option == field).map_or(field, |(_, name)| name);
                format!("/{name}")
            }
            Step::Index(index) => format!("/{index}"),
        };
        Self::new(error.place.0.iter().map(step).collect::<String>(), error.detail.clone())
    }
}

/// Reason for refusing a body.
#[derive(Clone, Debug, PartialEq, Eq)]
pub enum Rejection {
    /// The body is not JSON, or an object repeats a key.
    Malformed(String),
    /// The body is JSON but not a valid request.
    Invalid(Vec<FieldError>),
    /// The request is valid but exceeds a limit.
    TooLarge(Vec<FieldError>),
}

impl Rejection {
    /// Prefixes each pointer, for a request that lies at `pointer` of a larger body.
    #[must_use]
    pub fn within(mut self, pointer: &str) -> Self {
        if let Self::Invalid(errors) | Self::TooLarge(errors) = &mut self {
            errors.iter_mut().for_each(|error| error.pointer.insert_str(0, pointer));
        }
        self
    }

    /// Truncates each pointer that leads through a member that the body lacks, so that it ends at the first missing
    /// member. The default of that member is then the wrong value.
    #[must_use]
    pub fn placed_in(mut self, body: &Value) -> Self {
        if let Self::Invalid(errors) | Self::TooLarge(errors) = &mut self {
            for error in errors {
                let ends = error.pointer.match_indices('/').map(|(at, _)| at).skip(1).chain([error.pointer.len()]);
                let lacking = ends.into_iter().find(|&end| body.pointer(&error.pointer[..end]).is_none());
                if let Some(end) = lacking {
                    error.pointer.truncate(end);
                }
            }
        }
        self
    }
}

impl From<FieldError> for Rejection {
    fn from(error: FieldError) -> Self {
        Self::Invalid(vec![error])
    }
}

impl From<GeometryError> for Rejection {
    fn from(error: GeometryError) -> Self {
        match error {
            GeometryError::Input(errors) => Self::Invalid(errors.iter().map(FieldError::from).collect()),
            other => Self::Invalid(vec![FieldError::new("", other.to_string())]),
        }
    }
}
