//! Reads a request's body, with checks of its media type, its size, the time it takes and the shared memory budget.

use crate::http::problem::Failure;
use crate::http::state::App;
use axum::body::Body;
use axum::http::{HeaderMap, Request, header};
use bytes::Bytes;
use http_body_util::{BodyExt, LengthLimitError, Limited};
use std::time::Duration;
use tokio::sync::OwnedSemaphorePermit;

/// Number of bytes for each permit of the budget for bodies.
const PERMIT_BYTES: usize = 1024;

/// Returns the number of permits for a budget of `bytes` bytes.
#[must_use]
pub fn permits(bytes: usize) -> usize {
    bytes.div_ceil(PERMIT_BYTES)
}

/// A request's body. It holds its share of the budget until it is dropped.
#[derive(Debug)]
pub struct Received {
    pub bytes: Bytes,
    _share: OwnedSemaphorePermit,
}

/// Lets [`Bytes::from_owner`] keep the share until the bytes are no longer used.
impl AsRef<[u8]> for Received {
    fn as_ref(&self) -> &[u8] {
        &self.bytes
    }
}

/// Reads a JSON body. The headers are checked before the first byte of the body is read.
///
/// # Errors
/// Returns 415 for another media type or any `Content-Encoding`, 413 for too many bytes, 408 if the client is too slow,
/// and 503 if the bodies of other requests use up the budget.
pub async fn read_json(app: &App, request: Request<Body>) -> Result<Received, Failure> {
    let (parts, body) = request.into_parts();
    check_media_type(&parts.headers)?;
    let limit = app.config.limits.body_bytes;
    let too_large = || Failure::too_large(format!("a body may have at most {limit} bytes; see GET /v1/limits"));
    let declared =
        parts.headers.get(header::CONTENT_LENGTH).and_then(|value| value.to_str().ok()?.parse::<usize>().ok());
    if declared.is_some_and(|length| length > limit) {
        return Err(too_large());
    }
    let wait = Duration::from_millis(app.config.http.body_timeout_ms);
    let wanted = permits(declared.unwrap_or(limit)).max(1);
    let wanted = u32::try_from(wanted).unwrap_or(u32::MAX);
    let share = tokio::time::timeout(wait, app.bodies.clone().acquire_many_owned(wanted)).await;
    let Ok(Ok(share)) = share else {
        return Err(Failure::unavailable("the bodies of other requests use up this server's budget; try again"));
    };
    let collected = tokio::time::timeout(wait, Limited::new(body, limit).collect()).await;
    let bytes = match collected {
        Err(_) => return Err(Failure::body_timeout(format!("the body did not arrive within {} ms", wait.as_millis()))),
        Ok(Err(error)) if error.is::<LengthLimitError>() => return Err(too_large()),
        Ok(Err(_)) => return Err(Failure::malformed("the body ended before it was complete")),
        Ok(Ok(collected)) => collected.to_bytes(),
    };
    Ok(Received { bytes, _share: share })
}

fn check_media_type(headers: &HeaderMap) -> Result<(), Failure> {
    if headers.contains_key(header::CONTENT_ENCODING) {
        return Err(Failure::unsupported_media_type("send the body without a Content-Encoding"));
    }
    let value = headers.get(header::CONTENT_TYPE).and_then(|value| value.to_str().ok()).unwrap_or_default();
    let mut parts = value.split(';').map(str::trim);
    let media_type = parts.next().unwrap_or_default().eq_ignore_ascii_case("application/json");
    let utf8 = parts.all(|parameter| match parameter.split_once('=') {
        Some((name, value)) if name.trim().eq_ignore_ascii_case("charset") => {
            value.trim().trim_matches('"').eq_ignore_ascii_case("utf-8")
        }
        _ => true,
    });
    if media_type && utf8 {
        Ok(())
    } else {
        Err(Failure::unsupported_media_type("send the body as Content-Type: application/json, in UTF-8"))
    }
}
