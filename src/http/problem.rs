//! The only place that knows the status codes of failures. Every error is sent as a problem document (RFC 9457).

use crate::auth::Scope;
#[cfg(feature = "hops")]
use crate::hops::{self, answer::Answer};
#[cfg(feature = "hops")]
use crate::http::paths::is_message_of_hops;
use crate::jobs::JobsError;
use crate::wire::job::{Problem, WrongValue};
use axum::body::Body;
use axum::http::{HeaderName, HeaderValue, Response, StatusCode, header};
use axum::response::IntoResponse;
use plateau_drawing::{ParameterError, Refused};
use plateau_engine::report::SolveError;
use plateau_strict_json::rejection::{FieldError, MAX_ERRORS, Rejection};

/// A failed request. [`write_problem`] fills in `instance`.
#[derive(Debug)]
pub struct Failure {
    status: StatusCode,
    /// Last part of the type.
    kind: Box<str>,
    title: Box<str>,
    detail: Box<str>,
    errors: Vec<FieldError>,
    parameters: Box<[ParameterError]>,
    headers: Vec<(HeaderName, HeaderValue)>,
}

macro_rules! failures {
    ($($(#[$doc:meta])* $name:ident: $status:ident, $kind:literal, $title:literal;)*) => {
        impl Failure {
            $($(#[$doc])* pub fn $name(detail: impl Into<String>) -> Self {
                Self::new(StatusCode::$status, $kind, $title, detail.into())
            })*

            /// Every kind of problem that this server sends: `(status, last part of the type, title)`.
            pub const KINDS: &[(u16, &str, &str)] = &[$((StatusCode::$status.as_u16(), $kind, $title)),*];
        }
    };
}

failures! {
    malformed: BAD_REQUEST, "malformed-body", "The body is not well-formed JSON";
    bad_query: BAD_REQUEST, "bad-query", "A query parameter is invalid";
    bad_header: BAD_REQUEST, "bad-header", "A header is invalid";
    unauthorized: UNAUTHORIZED, "unauthorized", "A valid API key is required";
    foreign_page: FORBIDDEN, "foreign-page", "The request comes from a page of another origin";
    insufficient_scope: FORBIDDEN, "insufficient-scope", "The key may not do this";
    not_found: NOT_FOUND, "not-found", "The resource does not exist";
    method_not_allowed: METHOD_NOT_ALLOWED, "method-not-allowed", "This path does not support this method";
    not_acceptable: NOT_ACCEPTABLE, "not-acceptable", "None of the accepted media types is offered";
    body_timeout: REQUEST_TIMEOUT, "body-timeout", "The body did not arrive in time";
    no_mesh: CONFLICT, "no-mesh", "The job has no mesh";
    no_callback: CONFLICT, "no-callback", "The request named no callback URL";
    expired: GONE, "expired", "The job has expired";
    lost: GONE, "mesh-lost", "The stored mesh is lost";
    too_large: PAYLOAD_TOO_LARGE, "too-large", "The request is larger than this server accepts";
    range_not_satisfiable: RANGE_NOT_SATISFIABLE, "range-not-satisfiable", "The range lies outside the file";
    unsupported_media_type: UNSUPPORTED_MEDIA_TYPE, "unsupported-media-type", "The body is not plain application/json";
    no_such_part: NOT_FOUND, "no-such-part", "The result has no such schedule";
    unsuitable_pattern: UNPROCESSABLE_ENTITY, "unsuitable-pattern", "The pattern cannot be made with these values";
    unwritable: UNPROCESSABLE_ENTITY, "unwritable", "The mesh cannot be written in this format";
    invalid: UNPROCESSABLE_ENTITY, "invalid-request", "The request is invalid";
    key_conflict: UNPROCESSABLE_ENTITY, "idempotency-key-conflict", "The idempotency key was used with another body";
    rate_limited: TOO_MANY_REQUESTS, "rate-limited", "Too many requests with this key";
    too_many_failures: TOO_MANY_REQUESTS, "too-many-failures", "Too many requests with an unknown key";
    too_many_open: TOO_MANY_REQUESTS, "too-many-open-requests", "Too many requests of this client are open";
    misdirected: MISDIRECTED_REQUEST, "misdirected", "The request is for another host";
    queue_full: TOO_MANY_REQUESTS, "queue-full", "The queue is full";
    internal: INTERNAL_SERVER_ERROR, "internal", "The server failed";
    unavailable: SERVICE_UNAVAILABLE, "unavailable", "The server cannot accept this request now";
}

/// Error text after which Hops requests the description of a component again.
#[cfg(feature = "hops")]
const BAD_INPUTS: &str = "Bad inputs";

impl Failure {
    fn new(status: StatusCode, kind: &'static str, title: &'static str, detail: String) -> Self {
        let headers = match status {
            StatusCode::UNAUTHORIZED => vec![(header::WWW_AUTHENTICATE, HeaderValue::from_static("Bearer"))],
            StatusCode::TOO_MANY_REQUESTS | StatusCode::SERVICE_UNAVAILABLE => {
                vec![(header::RETRY_AFTER, HeaderValue::from_static("2"))]
            }
            _ => Vec::new(),
        };
        Self {
            status,
            kind: kind.into(),
            title: title.into(),
            detail: detail.into(),
            errors: Vec::new(),
            parameters: Box::default(),
            headers,
        }
    }

    /// Returns the failure for a key that lacks a scope.
    pub fn out_of_scope(scope: Scope) -> Self {
        let name = scope.name();
        // The form is that of RFC 6750, section 3.1.
        let challenge = HeaderValue::from_str(&format!("Bearer error=\"insufficient_scope\", scope=\"{name}\""));
        let failure = Self::insufficient_scope(format!("this key does not have the scope {name}"));
        match challenge {
            Ok(challenge) => failure.with_header(header::WWW_AUTHENTICATE, challenge),
            Err(_) => failure,
        }
    }

    /// Returns the failure for a query with a parameter that is not one of `known`.
    pub fn unknown_parameter<S: AsRef<str>>(known: &[S]) -> Self {
        let known: Vec<&str> = known.iter().map(AsRef::as_ref).collect();
        Self::bad_query(match known.is_empty() {
            true => "this path has no query parameters".into(),
            false => format!("known parameters are: {}", known.join(", ")),
        })
    }

    /// Returns the failure for the mesh of a job that failed with this error. Its type and title are the error's own.
    #[must_use]
    pub fn of_failed_job(error: SolveError) -> Self {
        let kind = error.kind.rsplit('/').next().unwrap_or_default().to_owned();
        let failure = Self::no_mesh(error.detail).with_errors(error.errors);
        Self { kind: kind.into(), title: error.title.into(), ..failure }
    }

    /// Returns the failure for a status that a library has chosen. Its text becomes the detail.
    #[cfg(feature = "mcp")]
    #[must_use]
    pub fn of_library(status: StatusCode, detail: String) -> Self {
        match status {
            StatusCode::NOT_ACCEPTABLE => Self::not_acceptable(detail),
            StatusCode::PAYLOAD_TOO_LARGE => Self::too_large(detail),
            // Libraries answer 415 to JSON that is not a message of their protocol.
            StatusCode::UNSUPPORTED_MEDIA_TYPE => Self::malformed(detail),
            status if status.is_client_error() => Self::bad_header(detail),
            _ => Self::internal(detail),
        }
    }

    #[must_use]
    pub fn with_errors(mut self, errors: Vec<FieldError>) -> Self {
        self.errors = errors;
        self
    }

    #[must_use]
    pub fn with_header(mut self, name: HeaderName, value: HeaderValue) -> Self {
        self.headers.retain(|(present, _)| *present != name);
        self.headers.push((name, value));
        self
    }
}

/// Text for clients that read no problem documents: title, detail, and a line for each offending value.
impl std::fmt::Display for Failure {
    fn fmt(&self, formatter: &mut std::fmt::Formatter<'_>) -> std::fmt::Result {
        write!(formatter, "{} ({}): {}", self.title, self.kind, self.detail)?;
        for FieldError { pointer, detail } in self.errors.iter().take(MAX_ERRORS) {
            let pointer = if pointer.is_empty() { "/" } else { pointer };
            write!(formatter, "\n{pointer}: {detail}")?;
        }
        if self.errors.len() > MAX_ERRORS { write!(formatter, "\nThere are more errors.") } else { Ok(()) }
    }
}

impl From<Rejection> for Failure {
    fn from(rejection: Rejection) -> Self {
        match rejection {
            Rejection::Malformed(detail) => Self::malformed(detail),
            Rejection::Invalid(errors) => Self::invalid(summary(&errors)).with_errors(errors),
            Rejection::TooLarge(errors) => {
                Self::too_large(format!("{}; see GET /v1/limits", summary(&errors))).with_errors(errors)
            }
        }
    }
}

impl From<JobsError> for Failure {
    fn from(error: JobsError) -> Self {
        match error {
            JobsError::Rejected(rejection) => rejection.into(),
            JobsError::QueueFull { own: false } => Self::queue_full("too many jobs wait; try again later"),
            JobsError::QueueFull { own: true } => Self::queue_full("too many of your jobs wait; try again later"),
            JobsError::NoSource { cause, errors } => Self::from(*cause).with_errors(errors),
            JobsError::KeyConflict => Self::key_conflict("this idempotency key was already used with another body"),
            JobsError::NotFound => Self::not_found("no such job"),
            JobsError::NoBatch => Self::not_found("no such batch"),
            JobsError::Expired => Self::expired(
                "the job and its mesh were removed: their retention time ended, or the server needed the place for \
                 newer jobs",
            ),
            JobsError::NoMesh(status) => Self::no_mesh(format!("the job is {}", status.name())),
            JobsError::Lost => Self::lost("the stored mesh was damaged and has been removed; submit the request again"),
            JobsError::NoCallback => {
                Self::no_callback("there is no message to send; name a `callback_url` in the request")
            }
            JobsError::NoCertificate => Self::not_found(
                "this result has no certificate; if the request asked for one, the job's warnings say why it is missing",
            ),
            JobsError::NoRequest => {
                Self::not_found("the job ended under an earlier version of this server, which did not keep requests")
            }
            JobsError::NoDrawing(refused) => refused.into(),
            JobsError::TooMuch(detail) => Self::unwritable(detail),
            JobsError::Unwritable(error) => Self::unwritable(error.to_string()),
            JobsError::Unavailable(detail) => Self::unavailable(detail),
            JobsError::Internal(detail) => Self::internal(detail),
        }
    }
}

impl From<Refused> for Failure {
    fn from(refused: Refused) -> Self {
        let detail = refused.to_string();
        match refused {
            Refused::BadQuery(parameters) => Self { parameters: parameters.into(), ..Self::bad_query(detail) },
            Refused::Unsuitable(parameters) => {
                Self { parameters: parameters.into(), ..Self::unsuitable_pattern(detail) }
            }
            Refused::NoPattern => Self::not_found(detail),
            Refused::NoPart(_) => Self::no_such_part(detail),
            Refused::TooLarge(_) => Self::unwritable(detail),
        }
    }
}

fn summary(errors: &[FieldError]) -> String {
    match errors {
        [only] if only.pointer.is_empty() => only.detail.clone(),
        [only] => format!("{} {}", only.pointer, only.detail),
        many if many.len() > MAX_ERRORS => format!("more than {MAX_ERRORS} values are invalid"),
        many => format!("{} values are invalid", many.len()),
    }
}

/// Marks a response as a problem document whose `instance` is not known yet.
#[derive(Clone, Debug)]
pub struct Unaddressed(Problem);

impl IntoResponse for Failure {
    fn into_response(mut self) -> Response<Body> {
        let fields = self.errors.drain(..).map(WrongValue::from);
        let mut errors: Vec<WrongValue> = fields.chain(self.parameters.into_iter().map(WrongValue::from)).collect();
        let errors_omitted = errors.len() > MAX_ERRORS;
        errors.truncate(MAX_ERRORS);
        let problem = Problem {
            kind: format!("/problems/{}", self.kind),
            title: self.title.into(),
            status: self.status.as_u16(),
            detail: self.detail.into(),
            instance: String::new(),
            errors,
            errors_omitted,
        };
        let mut response = Response::new(Body::empty());
        *response.status_mut() = self.status;
        for (name, value) in self.headers {
            response.headers_mut().insert(name, value);
        }
        response.headers_mut().insert(header::CONTENT_TYPE, HeaderValue::from_static("application/problem+json"));
        response.extensions_mut().insert(Unaddressed(problem));
        response
    }
}

#[cfg(feature = "hops")]
impl Failure {
    /// Returns the response to a message of Hops, which reads no problem documents. The answer's errors are the lines
    /// that Hops shows on the component.
    #[must_use]
    pub fn to_hops(&self, answer: &Answer<'_>) -> Response<Body> {
        let mut response = Response::new(Body::from(answer.to_json()));
        *response.status_mut() = self.status;
        for (name, value) in &self.headers {
            response.headers_mut().insert(name, value.clone());
        }
        response.headers_mut().insert(header::CONTENT_TYPE, HeaderValue::from_static("application/json"));
        response
    }

    /// Returns the failure for a refused message of Hops, and the lines of text that Hops shows for it.
    #[must_use]
    pub fn of_hops(refusal: hops::HopsError) -> (Self, Vec<String>) {
        match refusal {
            hops::HopsError::Malformed(line) => (Self::malformed(""), vec![line]),
            hops::HopsError::Unknown(line) => (Self::not_found(""), vec![line]),
            hops::HopsError::Invalid(lines) => (Self::invalid(""), lines),
            // Hops asks for the description again if the status is 500 and the first line has this text. It then shows
            // the component with its present inputs.
            hops::HopsError::Outdated(mut lines) => {
                lines.insert(0, BAD_INPUTS.into());
                (Self::internal(""), lines)
            }
        }
    }

    /// Returns this failure as the lines of text that Hops shows. `line` formats an offending value as a line.
    pub fn lines(&self, line: impl Fn(&FieldError) -> String) -> Vec<String> {
        match self.errors.as_slice() {
            [] if self.detail.is_empty() => vec![self.title.to_string()],
            [] => vec![format!("{}: {}", self.title, self.detail)],
            errors => errors.iter().take(MAX_ERRORS).map(line).collect(),
        }
    }
}

/// Error of a message without a key of this server, in Grasshopper's words. Hops sends the key in a header of its own.
#[cfg(feature = "hops")]
const HOPS_KEY: &str = "This server needs an API key, and Hops sent none that it knows. Enter a key in Grasshopper \
    under File > Preferences > Solver as the API key of Hops, and recompute";

/// Writes the problem document into a response marked by [`Failure`]. Other responses stay unchanged. Hops gets an
/// answer in its own form. `base` is the base path of this server, and `path` is the request's path below it.
pub fn write_problem(mut response: Response<Body>, base: &str, path: &str) -> Response<Body> {
    if let Some(Unaddressed(mut problem)) = response.extensions_mut().remove::<Unaddressed>() {
        #[cfg(feature = "hops")]
        if is_message_of_hops(path) {
            let line = match response.status() {
                StatusCode::UNAUTHORIZED => HOPS_KEY.into(),
                _ => format!("{}: {}", problem.title, problem.detail),
            };
            let answer = Answer::of_errors(vec![line]);
            *response.body_mut() = Body::from(answer.to_json());
            response.headers_mut().insert(header::CONTENT_TYPE, HeaderValue::from_static("application/json"));
            return response;
        }
        problem.kind.insert_str(0, base);
        problem.instance = base.chars().chain(path.chars()).take(300).collect();
        // Serialization cannot fail because a problem has only strings and numbers.
        let text = serde_json::to_vec(&problem).unwrap_or_default();
        *response.body_mut() = Body::from(text);
    }
    response
}
