//! Reads a request's body, with checks of its media type, its size, its rate and the shared memory budget.

use crate::http::access::Caller;
use crate::http::budget::Share;
use crate::http::problem::Failure;
use crate::http::state::App;
use axum::body::Body;
use axum::extract::ConnectInfo;
use axum::http::{Extensions, HeaderMap, HeaderValue, Request, header};
use bytes::Bytes;
use http_body_util::BodyExt;
use std::net::SocketAddr;
use std::time::Duration;
use tokio::time::{Instant, timeout, timeout_at};

/// Number of bytes of each body that are not counted in the budget, so that small bodies never wait. The limit of
/// connections bounds their sum.
const UNCOUNTED_BYTES: usize = 16 << 10;

/// A request's body. It holds its share of the budget until it is dropped.
#[derive(Debug)]
pub struct Received {
    pub bytes: Bytes,
    _share: Share,
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
    let read = async {
        check_media_type(&parts.headers)?;
        read(app, &parts.headers, owner(&parts.extensions), body).await
    };
    // The body may not have been read to its end. The connection is closed, so that the rest is not parsed as another
    // request.
    read.await.map_err(|failure| failure.with_header(header::CONNECTION, HeaderValue::from_static("close")))
}

/// Returns the owner of a request's body: the name of its key or, on a server without keys, the client's address.
fn owner(extensions: &Extensions) -> String {
    let key = extensions.get().and_then(Caller::owner).map(str::to_owned);
    let address = || extensions.get().map(|ConnectInfo::<SocketAddr>(peer)| peer.ip().to_string());
    key.or_else(address).unwrap_or_default()
}

async fn read(app: &App, headers: &HeaderMap, owner: String, mut body: Body) -> Result<Received, Failure> {
    let (http, limit) = (&app.config.http, app.config.limits.body_bytes);
    let too_large = || Failure::too_large(format!("a body may have at most {limit} bytes; see GET /v1/limits"));
    let declared = headers.get(header::CONTENT_LENGTH).and_then(|value| value.to_str().ok()?.parse::<usize>().ok());
    if declared.is_some_and(|length| length > limit) {
        return Err(too_large());
    }
    let most = declared.unwrap_or(limit);
    let wait = Duration::from_millis(http.body_timeout_ms);
    let period = Duration::from_millis(http.body_rate_grace_ms);
    let period_bytes = http.body_rate_bytes_per_s.saturating_mul(http.body_rate_grace_ms) / 1000;
    let mut share = app.bodies.share(owner);
    let mut bytes = Vec::with_capacity(most.min(UNCOUNTED_BYTES));
    let mut deadline = Instant::now() + wait;
    let (mut period_end, mut arrived) = (Instant::now() + period, 0);
    loop {
        // `timeout_at` polls the body first. Bytes that have already arrived are therefore read even if the time has
        // passed, so that a request does not fail because the server is slow.
        let frame = match timeout_at(deadline.min(period_end), body.frame()).await {
            Ok(None) => break,
            Ok(Some(frame)) => frame.map_err(|_| Failure::malformed("the body ended before it was complete"))?,
            Err(_) if Instant::now() >= deadline => {
                return Err(Failure::body_timeout(format!("the body did not arrive within {} ms", wait.as_millis())));
            }
            Err(_) if arrived < period_bytes => {
                let rate = http.body_rate_bytes_per_s;
                return Err(Failure::body_timeout(format!("the body arrived at less than {rate} bytes a second")));
            }
            Err(_) => {
                (period_end, arrived) = (Instant::now() + period, 0);
                continue;
            }
        };
        let Ok(data) = frame.into_data() else { continue };
        let length = bytes.len() + data.len();
        if length > limit {
            return Err(too_large());
        }
        arrived += data.len() as u64;
        if length > bytes.capacity() {
            let capacity = length.max((2 * bytes.capacity()).min(most));
            let asked = Instant::now();
            if timeout(wait, share.grow_to(capacity.saturating_sub(UNCOUNTED_BYTES))).await.is_err() {
                return Err(Failure::unavailable(
                    "the bodies of other requests use up this server's budget; try again",
                ));
            }
            bytes.reserve_exact(capacity - bytes.len());
            // The client's time does not run while the body waits for room.
            deadline += asked.elapsed();
            period_end += asked.elapsed();
        }
        bytes.extend_from_slice(&data);
    }
    Ok(Received { bytes: bytes.into(), _share: share })
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
