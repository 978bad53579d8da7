//! Access checks: the host, the origin of the page and the API key.

use crate::auth::{AuthError, Left, Scope};
use crate::config::HttpConfig;
use crate::http::open_requests::{self, NoConnection};
use crate::http::paths::is_message_of_hops;
use crate::http::problem::Failure;
use crate::http::state::App;
use axum::extract::{FromRequestParts, Request, State};
use axum::http::request::Parts;
use axum::http::{HeaderMap, HeaderName, HeaderValue, Method, header};
use axum::middleware::Next;
use axum::response::{IntoResponse, Response};
use std::convert::Infallible;
use std::net::IpAddr;
use std::sync::Arc;
use std::time::Duration;

/// Name of the key that came with a request. `None` if this server has no keys.
#[derive(Clone, Debug, Default)]
pub struct Caller(Option<Arc<str>>);

impl Caller {
    /// Returns the owner whose jobs this caller may see. `None` means all jobs.
    #[must_use]
    pub fn owner(&self) -> Option<&str> {
        self.0.as_deref()
    }
}

impl<S: Sync> FromRequestParts<S> for Caller {
    type Rejection = Infallible;

    async fn from_request_parts(parts: &mut Parts, _: &S) -> Result<Self, Infallible> {
        Ok(parts.extensions.get().cloned().unwrap_or_default())
    }
}

/// Header in which Hops sends a key.
const RHINO_COMPUTE_KEY: HeaderName = HeaderName::from_static("rhinocomputekey");

/// Returns true for paths that need no key: the API document, its page, the studio, the health checks, and the
/// descriptions of the components of Hops.
#[must_use]
pub fn is_public(path: &str) -> bool {
    let below = |folder: &str| path.strip_prefix(folder).is_some_and(|rest| rest.is_empty() || rest.starts_with('/'));
    path == "/"
        || path == "/openapi.json"
        || ["/docs", "/health", "/problems", "/studio"].into_iter().any(below)
        || (below("/hops") && !is_message_of_hops(path))
}

/// Returns true for the paths of the health checks, to which no limit of requests applies.
#[must_use]
pub fn is_health(path: &str) -> bool {
    path.strip_prefix("/health/").is_some_and(|check| ["live", "ready"].contains(&check))
}

/// Returns what a key must be allowed to do for a request. The messages of MCP and Hops submit requests and read jobs.
fn needed_scopes(method: &Method, path: &str) -> &'static [Scope] {
    if path == "/metrics" {
        &[Scope::Metrics]
    } else if path == "/mcp" || is_message_of_hops(path) {
        &[Scope::Submit, Scope::Read]
    } else if [Method::GET, Method::HEAD, Method::OPTIONS].contains(method) {
        &[Scope::Read]
    } else {
        &[Scope::Submit]
    }
}

/// Header with the number of requests that a key has left and the seconds until it has all of a minute's requests
/// again, as in the IETF's draft-ietf-httpapi-ratelimit-headers-10.
pub const RATE_LIMIT: HeaderName = HeaderName::from_static("ratelimit");
/// Header with the number of requests that a key may make in a minute, as in the same draft.
pub const RATE_LIMIT_POLICY: HeaderName = HeaderName::from_static("ratelimit-policy");

/// Adds the headers that tell a client how many requests its key has left.
fn with_rate_limit(mut response: Response, per_minute: u32, left: Left) -> Response {
    let values = [
        (RATE_LIMIT_POLICY, format!("\"requests\";q={per_minute};w=60")),
        (RATE_LIMIT, format!("\"requests\";r={};t={}", left.requests, left.full_in_s)),
    ];
    for (name, value) in values {
        if let Ok(value) = HeaderValue::from_str(&value) {
            response.headers_mut().insert(name, value);
        }
    }
    response
}

/// Lets a request with a known key through. Otherwise answers 401 or 429 before the body is read.
pub async fn authenticate(State(app): State<App>, mut request: Request, next: Next) -> Response {
    if is_health(request.uri().path()) {
        return next.run(request).await;
    }
    if is_public(request.uri().path()) {
        let client = open_requests::address(request.extensions());
        return seated(&app, &client, request, next).await;
    }
    let presented = presented_key(request.headers(), request.uri().path());
    let per_minute = app.config.auth.requests_per_minute;
    let client = open_requests::address(request.extensions());
    match app.keys.admit(presented, &client) {
        Ok(admitted) => {
            if let Some((name, _)) = &admitted.key {
                tracing::Span::current().record("key", &**name);
            }
            let response = match admitted.key {
                None => seated(&app, &client, request, next).await,
                Some((name, digest)) => {
                    if let Some(scope) = digest.lacks(needed_scopes(request.method(), request.uri().path())) {
                        return Failure::out_of_scope(scope).into_response();
                    }
                    let removal = app.keys.removal(name.clone(), digest);
                    request.extensions_mut().insert(Caller(Some(name.clone())));
                    let mut response = tokio::select! {
                        response = seated(&app, &name, request, next) => response,
                        () = removal.clone() => Failure::unauthorized("the key was removed").into_response(),
                    };
                    response.extensions_mut().insert(removal);
                    response
                }
            };
            match admitted.left {
                Some(left) => with_rate_limit(response, per_minute, left),
                None => response,
            }
        }
        Err(AuthError::Unknown) => {
            Failure::unauthorized("send Authorization: Bearer with a key of this server").into_response()
        }
        Err(AuthError::TooManyUnknown { wait }) => {
            let detail = "this address has presented too many unknown keys; send Authorization: Bearer with a key of \
                          this server";
            Failure::too_many_failures(detail)
                .with_header(header::RETRY_AFTER, HeaderValue::from(whole_seconds(wait)))
                .into_response()
        }
        Err(AuthError::TooMany { wait }) => {
            let wait_s = whole_seconds(wait);
            let refused = Failure::rate_limited(format!("a key may make {per_minute} requests a minute"))
                .with_header(header::RETRY_AFTER, HeaderValue::from(wait_s))
                .into_response();
            with_rate_limit(refused, per_minute, Left { requests: 0, full_in_s: wait_s })
        }
    }
}

/// Returns a time in seconds for `Retry-After`, rounded up.
fn whole_seconds(time: Duration) -> u64 {
    time.as_secs_f64().ceil() as u64
}

/// Passes a request on if its client may have one more request open. The seat stays with the response until its body
/// has ended.
async fn seated(app: &App, client: &str, request: Request, next: Next) -> Response {
    let Some(seat) = app.seats.take(client) else {
        let most = app.seats.most();
        return Failure::too_many_open(format!("one client may have {most} requests open; wait until one has ended"))
            .into_response();
    };
    let mut response = next.run(request).await;
    response.extensions_mut().insert(Arc::new(seat));
    response
}

/// Returns the key of a request: from `Authorization: Bearer` or, in a message of Hops, from Hops's own header.
fn presented_key<'r>(headers: &'r HeaderMap, path: &str) -> Option<&'r str> {
    let text = |name: &HeaderName| headers.get(name).and_then(|value| value.to_str().ok());
    let bearer = text(&header::AUTHORIZATION)
        .and_then(|value| value.split_once(' '))
        .filter(|(scheme, _)| scheme.eq_ignore_ascii_case("bearer"))
        .map(|(_, key)| key.trim());
    bearer.or_else(|| text(&RHINO_COMPUTE_KEY).filter(|_| is_message_of_hops(path)).map(str::trim))
}

const SEC_FETCH_SITE: HeaderName = HeaderName::from_static("sec-fetch-site");

/// Refuses requests that change something and come from a page of a foreign origin. A browser sends such requests with
/// all the access of its user, for example to a server on localhost. Browsers name the page's origin. Other clients
/// name none, and are let through.
pub async fn refuse_foreign_pages(State(app): State<App>, request: Request, next: Next) -> Response {
    let changes_state = ![Method::GET, Method::HEAD, Method::OPTIONS].contains(request.method());
    let host = request.uri().authority().map(|authority| authority.as_str());
    if changes_state && is_foreign(request.headers(), host, &app.config.http.cors_origins) {
        return Failure::foreign_page(
            "the page that sent this request belongs to another origin; see http.cors_origins",
        )
        .into_response();
    }
    next.run(request).await
}

/// Returns true if the request was sent by a page whose origin is neither this server's nor in `allowed`. `host` is the
/// host of the request's URI; if the URI has none, the header `Host` is used.
fn is_foreign(headers: &HeaderMap, host: Option<&str>, allowed: &[String]) -> bool {
    let text = |name: &HeaderName| headers.get(name).map(|value| value.to_str().unwrap_or_default());
    let origin = text(&header::ORIGIN);
    if allowed.iter().any(|allowed| allowed == "*" || origin == Some(allowed)) {
        return false;
    }
    // The browser itself knows best whether the page and the request have the same origin. It sends `Sec-Fetch-Site`
    // over https and to localhost.
    match (text(&SEC_FETCH_SITE), origin) {
        (Some(site), _) => !["same-origin", "none"].contains(&site),
        (None, Some(origin)) => {
            let own = host.or_else(|| text(&header::HOST)).unwrap_or_default();
            !origin.split_once("://").is_some_and(|(_, authority)| authority.eq_ignore_ascii_case(own))
        }
        (None, None) => false,
    }
}

/// Refuses requests to a foreign host name on a loopback address. An attacker can make the name of a site resolve to a
/// loopback address; pages of that site must not reach this server. Loopback names and the names of `http.hosts` are
/// allowed. Requests with several hosts are refused, because a proxy may have checked another one.
pub async fn check_host(State(app): State<App>, request: Request, next: Next) -> Response {
    if request.extensions().get::<NoConnection>().is_some() {
        return Failure::unavailable("all connections of this server are in use; try again")
            .with_header(header::CONNECTION, HeaderValue::from_static("close"))
            .into_response();
    }
    if request.headers().get_all(header::HOST).iter().count() > 1 {
        return Failure::bad_header("a request has one Host").into_response();
    }
    let http = &app.config.http;
    let named = request
        .uri()
        .authority()
        .map(|authority| authority.as_str().to_owned())
        .or_else(|| request.headers().get(header::HOST).and_then(|value| value.to_str().ok()).map(str::to_owned));
    if http.listen.ip().is_loopback() && !named.is_some_and(|host| is_own_name(&host, http)) {
        return Failure::misdirected("this server listens on a loopback address and does not answer to this Host")
            .into_response();
    }
    next.run(request).await
}

fn is_own_name(host: &str, http: &HttpConfig) -> bool {
    let name = match host.strip_prefix('[').and_then(|rest| rest.split_once(']')) {
        Some((address, _)) => address,
        None => host.rsplit_once(':').map_or(host, |(name, _)| name),
    };
    let name = name.strip_suffix('.').unwrap_or(name);
    name.eq_ignore_ascii_case("localhost")
        || name.parse::<IpAddr>().is_ok_and(|address| address.is_loopback())
        || http.hosts.iter().any(|own| own.eq_ignore_ascii_case(name))
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn foreign_pages_are_recognised_by_origin_and_sec_fetch_site() {
        let site = "sec-fetch-site";
        let allowed = ["https://cad.example".to_owned()];
        let foreign = |pairs: &[(&'static str, &'static str)]| {
            let headers: HeaderMap = pairs
                .iter()
                .map(|&(name, value)| (HeaderName::from_static(name), HeaderValue::from_static(value)))
                .collect();
            is_foreign(&headers, None, &allowed)
        };
        for own in [
            &[("host", "localhost:8080")][..],
            &[("host", "localhost:8080"), ("origin", "http://localhost:8080")],
            &[("host", "Plateau.Example"), ("origin", "https://plateau.example")],
            &[("host", "a"), ("origin", "http://a"), (site, "same-origin")],
            &[("host", "a"), (site, "none")],
            // A proxy may change the host, so `Sec-Fetch-Site` takes precedence.
            &[("host", "upstream"), ("origin", "https://plateau.example"), (site, "same-origin")],
            &[("host", "a"), ("origin", "https://cad.example"), (site, "cross-site")],
            &[("host", "a"), ("origin", "https://cad.example")],
        ] {
            assert!(!foreign(own), "{own:?}");
        }
        for other in [
            &[("host", "localhost:8080"), ("origin", "https://evil.example")][..],
            &[("host", "localhost:8080"), ("origin", "http://localhost:3000")],
            &[("host", "localhost:8080"), ("origin", "null")],
            &[("host", "localhost:8080"), ("origin", "")],
            &[("origin", "http://localhost:8080")],
            &[("host", "a"), (site, "cross-site")],
            &[("host", "a"), ("origin", "http://a"), (site, "same-site")],
            &[("host", "a"), ("origin", "http://cad.example"), (site, "cross-site")],
        ] {
            assert!(foreign(other), "{other:?}");
        }
        let any = HeaderMap::from_iter([(header::ORIGIN, HeaderValue::from_static("https://evil.example"))]);
        assert!(!is_foreign(&any, Some("a"), &["*".into()]));
        assert!(is_foreign(&any, Some("a"), &[]) && !is_foreign(&any, Some("evil.example"), &[]));
    }

    #[test]
    fn only_loopback_names_and_configured_names_are_accepted() {
        let http = HttpConfig { hosts: vec!["plateau.test".into()], ..HttpConfig::default() };
        for own in [
            "localhost",
            "localhost:8080",
            "LOCALHOST",
            "localhost.:1",
            "127.0.0.1:9",
            "127.1.2.3",
            "[::1]:8080",
            "[::1]",
            "plateau.test:80",
        ] {
            assert!(is_own_name(own, &http), "{own}");
        }
        for other in
            ["evil.test", "localhost.evil.test", "10.0.0.1:8080", "[2001:db8::1]", "", "127.0.0.1.evil.test:80"]
        {
            assert!(!is_own_name(other, &http), "{other}");
        }
    }

    #[test]
    fn only_pages_health_checks_and_the_api_document_are_public() {
        for path in [
            "/",
            "/openapi.json",
            "/docs",
            "/docs/",
            "/studio/main.js",
            "/health/live",
            "/problems/not-found",
            "/hops",
            "/hops/minimal-surface",
            "/hops/minimal-surface/",
        ] {
            assert!(is_public(path), "{path}");
        }
        for path in ["/v1/jobs", "/metrics", "/docsx", "/healthy", "//v1/jobs", "/v1/examples", "/solve", "/hopsx"] {
            assert!(!is_public(path), "{path}");
        }
    }

    #[cfg(feature = "hops")]
    #[test]
    fn messages_of_hops_are_not_public() {
        for path in ["/hops/solve", "/hops/minimal-surface/solve"] {
            assert!(!is_public(path), "{path}");
        }
    }
}
