//! Reads requests with the fields that concern their jobs.

use super::envelope::{Envelope, MEMBERS};
use crate::config::LimitsConfig;
use plateau_forms::json;
use plateau_forms::kind::Kind;
use plateau_forms::limits::refuse_too_many_values;
use plateau_forms::rejection::{MAX_ERRORS, Rejection};
use plateau_forms::request::{Accepted, Request};
use serde_json::Value;

/// A request that was read, with what it says of its job.
#[derive(Debug)]
pub struct Incoming {
    pub request: Request,
    pub envelope: Envelope,
    /// The request without the members of the envelope, as [`Accepted::text`].
    pub text: Vec<u8>,
}

impl Incoming {
    /// Reads a body of a known kind.
    ///
    /// # Errors
    /// Returns [`Rejection::TooLarge`] for a body with very many values, and the errors of [`json::parse`],
    /// [`Envelope::of`] and [`Request::from_value`].
    pub fn read(kind: Kind, body: &[u8], limits: &LimitsConfig) -> Result<Self, Rejection> {
        let limits = limits.requests();
        refuse_too_many_values(body, &limits)?;
        if let Some((Accepted { request, text }, members)) = Request::read(kind, body, &MEMBERS, &limits)
            && let Ok(envelope) = Envelope::of(members)
        {
            return Ok(Self { request, envelope, text });
        }
        Self::of(json::parse(body)?, |value| Request::from_value(kind, value, &limits))
    }

    /// Reads a body that names its own kind, as `plateau solve` accepts it.
    ///
    /// # Errors
    /// Returns the errors of [`Incoming::read`]. A missing or unknown `kind` is an error at `/kind`.
    pub fn read_with_kind(body: &[u8], limits: &LimitsConfig) -> Result<Self, Rejection> {
        Self::from_value(json::parse(body)?, limits)
    }

    /// Reads a JSON value that names its own kind.
    ///
    /// # Errors
    /// Returns the errors of [`Incoming::read_with_kind`].
    pub fn from_value(value: Value, limits: &LimitsConfig) -> Result<Self, Rejection> {
        let limits = limits.requests();
        Self::of(value, |value| Request::read_with_kind(value, &limits))
    }

    fn of(mut value: Value, read: impl FnOnce(&Value) -> Result<Accepted, Rejection>) -> Result<Self, Rejection> {
        let envelope = Envelope::take(&mut value);
        match (read(&value), envelope) {
            (Ok(Accepted { request, text }), Ok(envelope)) => Ok(Self { request, envelope, text }),
            // Every wrong value is named at once, whoever reads it.
            (Err(Rejection::Invalid(mut errors)), Err(Rejection::Invalid(others))) => {
                errors.splice(0..0, others);
                errors.truncate(MAX_ERRORS + 1);
                Err(Rejection::Invalid(errors))
            }
            (Err(rejection), _) | (_, Err(rejection)) => Err(rejection),
        }
    }
}
