//! Reads requests with the fields that concern their jobs.

use super::envelope::{Envelope, MEMBERS};
use crate::config::LimitsConfig;
use plateau_engine::kind::Kind;
use plateau_engine::limits::{may_be_values, refuse_too_many_values, refuse_too_much_as_values};
use plateau_engine::request::{CheckedRequest, Request};
use plateau_engine::source::{Find, no_jobs};
use plateau_strict_json::json;
use plateau_strict_json::rejection::{MAX_ERRORS, Rejection};
use serde::Deserialize;
use serde_json::Value;
use std::borrow::Cow;

/// A parsed request with its envelope, the fields that concern the job and not the geometry.
#[derive(Debug)]
pub struct Incoming {
    pub request: Request,
    pub envelope: Envelope,
    /// The request without the members of the envelope, as [`CheckedRequest::text`].
    pub text: Vec<u8>,
}

/// A request that was read and is to be stored. Data that only the solver needs, such as a whole mesh, are not kept,
/// because the worker reads the stored request again.
#[derive(Debug)]
pub struct CheckedJob {
    pub kind: Kind,
    pub memory_bytes: u64,
    /// Key of the result from which the request begins.
    pub source: Option<Vec<u8>>,
    pub envelope: Envelope,
    pub text: Vec<u8>,
}

impl CheckedJob {
    #[must_use]
    pub fn of(request: &Request, envelope: Envelope, text: Vec<u8>) -> Self {
        let Request { memory_bytes, source, .. } = request;
        Self { kind: request.kind(), memory_bytes: *memory_bytes, source: source.clone(), envelope, text }
    }
}

impl Incoming {
    /// Reads a body of a known kind.
    ///
    /// # Errors
    /// Returns [`Rejection::TooLarge`] for a body with very many values, and the errors of [`json::parse`],
    /// [`Envelope::of`] and [`Request::from_value`].
    pub fn read(kind: Kind, body: &[u8], find: Find<'_>, limits: &LimitsConfig) -> Result<Self, Rejection> {
        let limits = limits.requests();
        refuse_too_many_values(body, &limits)?;
        if let Some((CheckedRequest { request, text }, members)) = Request::read(kind, body, &MEMBERS, find, &limits)
            && let Ok(envelope) = Envelope::of(members)
        {
            return Ok(Self { request, envelope, text });
        }
        if !may_be_values(body) {
            let (CheckedRequest { request, text }, members) =
                Request::read_tracked(kind, body, &MEMBERS, find, &limits)?;
            return Ok(Self { request, envelope: Envelope::of(members)?, text });
        }
        Self::of(json::parse(body)?, |value| Request::from_value(kind, value, find, &limits))
    }

    /// Reads a body that names its own kind, as [`Incoming::read`] does.
    ///
    /// # Errors
    /// Returns the errors of [`Incoming::read`]. A missing or unknown `kind` is an error at `/kind`.
    pub fn read_naming_kind(body: &[u8], find: Find<'_>, limits: &LimitsConfig) -> Result<Self, Rejection> {
        #[derive(Deserialize)]
        struct Named<'b> {
            #[serde(borrow)]
            kind: Cow<'b, str>,
        }
        let named: Option<Named<'_>> = serde_json::from_slice(body).ok();
        match named.and_then(|named| Kind::from_name(&named.kind)) {
            Some(kind) => Self::read(kind, body, find, limits),
            None => {
                refuse_too_many_values(body, &limits.requests())?;
                refuse_too_much_as_values(body)?;
                Self::from_value(json::parse(body)?, find, limits)
            }
        }
    }

    /// Reads a body that names its own kind, as `plateau solve` accepts it. The request cannot begin with the result of
    /// a job.
    ///
    /// # Errors
    /// Returns the errors of [`Incoming::read`]. A missing or unknown `kind` is an error at `/kind`.
    pub fn read_with_kind(body: &[u8], limits: &LimitsConfig) -> Result<Self, Rejection> {
        Self::from_value(json::parse(body)?, &no_jobs, limits)
    }

    /// Reads a JSON value that names its own kind.
    ///
    /// # Errors
    /// Returns the errors of [`Incoming::read_with_kind`].
    pub fn from_value(value: Value, find: Find<'_>, limits: &LimitsConfig) -> Result<Self, Rejection> {
        let limits = limits.requests();
        Self::of(value, |value| Request::read_with_kind(value, find, &limits))
    }

    fn of(mut value: Value, read: impl FnOnce(&Value) -> Result<CheckedRequest, Rejection>) -> Result<Self, Rejection> {
        let envelope = Envelope::take(&mut value);
        match (read(&value), envelope) {
            (Ok(CheckedRequest { request, text }), Ok(envelope)) => Ok(Self { request, envelope, text }),
            // The errors of the request and of the envelope are reported together, so that the client can correct all
            // of them at once.
            (Err(Rejection::Invalid(mut errors)), Err(Rejection::Invalid(others))) => {
                errors.splice(0..0, others);
                errors.truncate(MAX_ERRORS + 1);
                Err(Rejection::Invalid(errors))
            }
            (Err(rejection), _) | (_, Err(rejection)) => Err(rejection),
        }
    }
}
