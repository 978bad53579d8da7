//! Reads requests with the fields that concern their jobs.

use super::envelope::Envelope;
use crate::config::LimitsConfig;
use plateau_forms::body::Body;
use plateau_forms::json;
use plateau_forms::kind::Kind;
use plateau_forms::rejection::{MAX_ERRORS, Rejection};
use plateau_forms::request::Request;
use serde_json::Value;

/// A request that was read, with what it says of its job.
#[derive(Debug)]
pub struct Incoming {
    pub request: Request,
    pub envelope: Envelope,
    /// The request as JSON, without the members of the envelope.
    pub body: Body,
}

impl Incoming {
    /// Reads a body of a known kind.
    ///
    /// # Errors
    /// Returns the errors of [`Body::read`], [`Envelope::take`] and [`Request::read`].
    pub fn read(kind: Kind, body: &[u8], limits: &LimitsConfig) -> Result<Self, Rejection> {
        let limits = limits.requests();
        Self::of(Body::read(kind.point_fields(), body, &limits)?, |body| Request::read(kind, body, &limits))
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
        Self::of(value.into(), |body| Request::read_with_kind(body.outline(), &limits))
    }

    fn of(mut body: Body, read: impl FnOnce(&Body) -> Result<Request, Rejection>) -> Result<Self, Rejection> {
        let envelope = Envelope::take(&mut body);
        match (read(&body), envelope) {
            (Ok(request), Ok(envelope)) => Ok(Self { request, envelope, body }),
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
