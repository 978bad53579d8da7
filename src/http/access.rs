//! Which requests are let through: those with a key (where keys are configured), for this host, and not from foreign
//! pages.

use crate::auth::Refusal;
use crate::config::HttpConfig;
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

/// The name of the key that came with a request; none if this server has no keys.
#[derive(Clone, Debug, Default)]
pub struct Caller(Option<Arc<str>>);

impl Caller {
    /// Whose jobs this caller may see; everybody's without one.
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

/// True for what anybody may see: the API document, its page, the studio, and whether the server lives.
#[must_use]
pub fn is_public(path: &str) -> bool {
    let below = |folder: &str| path.strip_prefix(folder).is_some_and(|rest| rest.is_empty() || rest.starts_with('/'));
    path == "/" || path == "/openapi.json" || ["/docs", "/health", "/problems", "/studio"].into_iter().any(below)
}

/// Lets a request through with its caller, or answers 401 or 429 before anything of its body is read.
pub async fn authenticate(State(app): State<App>, mut request: Request, next: Next) -> Response {
    if is_public(request.uri().path()) {
        return next.run(request).await;
    }
    let presented = request
        .headers()
        .get(header::AUTHORIZATION)
        .and_then(|value| value.to_str().ok())
        .and_then(|value| value.split_once(' '))
        .filter(|(scheme, _)| scheme.eq_ignore_ascii_case("bearer"))
        .map(|(_, key)| key.trim());
    match app.keys.admit(presented) {
        Ok(name) => {
            if let Some(name) = &name {
                tracing::Span::current().record("key", &**name);
            }
            request.extensions_mut().insert(Caller(name));
            next.run(request).await
        }
        Err(Refusal::Unknown) => {
            Failure::unauthorized("send Authorization: Bearer with a key of this server").into_response()
        }
        Err(Refusal::TooMany { wait_s }) => {
            let per_minute = app.config.auth.requests_per_minute;
            Failure::rate_limited(format!("a key may make {per_minute} requests a minute"))
                .with_header(header::RETRY_AFTER, HeaderValue::from(wait_s.ceil() as u64))
                .into_response()
        }
    }
}

const SEC_FETCH_SITE: HeaderName = HeaderName::from_static("sec-fetch-site");

/// Refuses what a page of a foreign origin sends in order to change something. A browser sends such requests with
/// whatever access the person in front of it has: to a server on localhost, for example. Browsers name the page's
/// origin; other clients do not, and are let through.
pub async fn refuse_foreign_pages(State(app): State<App>, request: Request, next: Next) -> Response {
    let changes_something = ![Method::GET, Method::HEAD, Method::OPTIONS].contains(request.method());
    let host = request.uri().authority().map(|authority| authority.as_str());
    if changes_something && is_foreign(request.headers(), host, &app.config.http.cors_origins) {
        return Failure::foreign_page("the page that sends this is not one of this server's; see http.cors_origins")
            .into_response();
    }
    next.run(request).await
}

/// Whether a page of an origin that is neither this server's nor one of `allowed` sent a request. `host` is the host of
/// the request's URI if that has one; otherwise the header `Host` has it.
fn is_foreign(headers: &HeaderMap, host: Option<&str>, allowed: &[String]) -> bool {
    let text = |name: &HeaderName| headers.get(name).map(|value| value.to_str().unwrap_or_default());
    let origin = text(&header::ORIGIN);
    if allowed.iter().any(|allowed| allowed == "*" || origin == Some(allowed)) {
        return false;
    }
    // A browser says best itself whether the page's origin is the request's. It does so over https and to localhost.
    match (text(&SEC_FETCH_SITE), origin) {
        (Some(site), _) => !["same-origin", "none"].contains(&site),
        (None, Some(origin)) => {
            let own = host.or_else(|| text(&header::HOST)).unwrap_or_default();
            !origin.split_once("://").is_some_and(|(_, authority)| authority.eq_ignore_ascii_case(own))
        }
        (None, None) => false,
    }
}

/// On a loopback address, only requests to a loopback name (or one that the operator added) are meant for this server:
/// a page of another site whose name was made to point here must not reach it.
pub async fn check_host(State(app): State<App>, request: Request, next: Next) -> Response {
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
    fn foreign_pages_are_known_by_what_the_browser_says_of_them() {
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
            // A proxy may change the host; the browser knows better.
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
    fn only_loopback_names_and_added_ones_are_ours() {
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
    fn public_paths_are_exactly_these() {
        for path in ["/", "/openapi.json", "/docs", "/docs/", "/studio/main.js", "/health/live", "/problems/not-found"]
        {
            assert!(is_public(path), "{path}");
        }
        for path in ["/v1/jobs", "/metrics", "/docsx", "/healthy", "//v1/jobs", "/v1/examples"] {
            assert!(!is_public(path), "{path}");
        }
    }
}
