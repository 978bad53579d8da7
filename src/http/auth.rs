//! Who is asking: API keys, what each may cost, and which names this server answers to.
//!
//! A key is 32 random bytes, shown once; configuration holds its SHA-256 only. A presented key is hashed and compared with
//! every known digest, all of them and whole, so that the time taken tells nothing. Without keys everybody is the same
//! nobody and sees every job.

use crate::app::App;
use crate::config::{AuthConfig, HttpConfig};
use crate::http::problem::Failure;
use axum::extract::{FromRequestParts, Request, State};
use axum::http::request::Parts;
use axum::http::{HeaderMap, HeaderValue, header};
use axum::middleware::Next;
use axum::response::{IntoResponse, Response};
use sha2::{Digest, Sha256};
use std::collections::BTreeMap;
use std::convert::Infallible;
use std::net::IpAddr;
use std::path::Path;
use std::sync::{Arc, Mutex, PoisonError};
use std::time::Instant;

const PREFIX: &str = "plateau_";
const KEY_BYTES: usize = 32;

/// A new key, and the digest that configuration keeps of it.
///
/// # Errors
/// The system gave no random bytes.
pub fn new_key() -> Result<(String, String), String> {
    let mut secret = [0; KEY_BYTES];
    getrandom::fill(&mut secret).map_err(|error| error.to_string())?;
    let key = format!("{PREFIX}{}", hex(&secret));
    let digest = hex(&Sha256::digest(key.as_bytes()));
    Ok((key, digest))
}

fn hex(bytes: &[u8]) -> String {
    bytes.iter().map(|byte| format!("{byte:02x}")).collect()
}

fn from_hex(text: &str) -> Option<[u8; 32]> {
    let mut bytes = [0; 32];
    if text.len() != 64 || !text.is_ascii() {
        return None;
    }
    for (index, byte) in bytes.iter_mut().enumerate() {
        *byte = u8::from_str_radix(&text[2 * index..2 * index + 2], 16).ok()?;
    }
    Some(bytes)
}

/// A name that may stand in logs, in the database and in a secrets file.
#[must_use]
pub fn is_key_name(name: &str) -> bool {
    (1..=64).contains(&name.len()) && name.bytes().all(|byte| byte.is_ascii_alphanumeric() || b"-_.".contains(&byte))
}

/// The keys that this server knows.
#[derive(Debug, Default)]
pub struct Keys {
    keys: Vec<Key>,
    /// Requests a minute that each key may make; 0: any number.
    requests_per_minute: u32,
}

struct Key {
    name: String,
    digest: [u8; 32],
    allowance: Mutex<Allowance>,
}

// Not even a digest belongs into a log.
impl std::fmt::Debug for Key {
    fn fmt(&self, formatter: &mut std::fmt::Formatter<'_>) -> std::fmt::Result {
        formatter.debug_struct("Key").field("name", &self.name).finish_non_exhaustive()
    }
}

/// A token bucket that holds one minute's requests and starts full.
#[derive(Debug)]
struct Allowance {
    requests: f64,
    at: Instant,
}

impl Allowance {
    /// Takes one request, or says after how many seconds there will be one.
    fn take(&mut self, per_minute: f64, now: Instant) -> Result<(), f64> {
        let per_second = per_minute / 60.0;
        let elapsed_s = now.saturating_duration_since(self.at).as_secs_f64();
        self.requests = (self.requests + elapsed_s * per_second).min(per_minute);
        self.at = now;
        if self.requests >= 1.0 {
            self.requests -= 1.0;
            Ok(())
        } else {
            Err((1.0 - self.requests) / per_second)
        }
    }
}

impl Keys {
    /// Reads the keys of the configuration and of its secrets file, which has one `NAME SHA256` a line.
    ///
    /// # Errors
    /// A message that names the setting and, in the file, the line.
    pub fn load(config: &AuthConfig) -> Result<Self, String> {
        let mut digests = BTreeMap::new();
        let mut add = |origin: String, name: &str, digest: &str| {
            if !is_key_name(name) {
                return Err(format!("{origin}: a key's name has 1 to 64 letters, digits, dots, dashes or underscores"));
            }
            let digest = from_hex(digest).ok_or_else(|| format!("{origin}: expected a SHA-256 of 64 hex digits"))?;
            match digests.insert(name.to_owned(), digest) {
                Some(_) => Err(format!("{origin}: the name {name} is used twice")),
                None => Ok(()),
            }
        };
        for (name, digest) in &config.keys {
            add(format!("auth.keys.{name}"), name, digest)?;
        }
        if !config.keys_file.as_os_str().is_empty() {
            for (number, line) in read_file(&config.keys_file)?.lines().enumerate() {
                let line = line.trim();
                if line.is_empty() || line.starts_with('#') {
                    continue;
                }
                let origin = format!("auth.keys_file {} line {}", config.keys_file.display(), number + 1);
                match line.split_whitespace().collect::<Vec<_>>()[..] {
                    [name, digest] => add(origin, name, digest)?,
                    _ => return Err(format!("{origin}: expected NAME SHA256")),
                }
            }
        }
        let now = Instant::now();
        let full = || Mutex::new(Allowance { requests: f64::from(config.requests_per_minute), at: now });
        let keys = digests.into_iter().map(|(name, digest)| Key { name, digest, allowance: full() }).collect();
        Ok(Self { keys, requests_per_minute: config.requests_per_minute })
    }

    /// True if nobody needs a key.
    #[must_use]
    pub fn is_empty(&self) -> bool {
        self.keys.is_empty()
    }

    /// The key that was presented, in a time that does not depend on which, if any.
    fn find(&self, presented: &str) -> Option<&Key> {
        let digest: [u8; 32] = Sha256::digest(presented.as_bytes()).into();
        let mut found = None;
        for key in &self.keys {
            let difference = key.digest.iter().zip(&digest).fold(0, |all, (a, b)| all | (a ^ b));
            if std::hint::black_box(difference) == 0 {
                found = Some(key);
            }
        }
        found
    }

    fn admit(&self, headers: &HeaderMap) -> Result<Caller, Failure> {
        if self.is_empty() {
            return Ok(Caller(None));
        }
        let key = headers
            .get(header::AUTHORIZATION)
            .and_then(|value| value.to_str().ok())
            .and_then(|value| value.split_once(' '))
            .filter(|(scheme, _)| scheme.eq_ignore_ascii_case("bearer"))
            .and_then(|(_, presented)| self.find(presented.trim()))
            .ok_or_else(|| Failure::unauthorized("send Authorization: Bearer with a key of this server"))?;
        if self.requests_per_minute > 0 {
            let mut allowance = key.allowance.lock().unwrap_or_else(PoisonError::into_inner);
            if let Err(wait_s) = allowance.take(f64::from(self.requests_per_minute), Instant::now()) {
                let wait_s = HeaderValue::from(wait_s.ceil() as u64);
                return Err(Failure::rate_limited(format!(
                    "a key may make {} requests a minute",
                    self.requests_per_minute
                ))
                .with_header(header::RETRY_AFTER, wait_s));
            }
        }
        Ok(Caller(Some(Arc::from(key.name.as_str()))))
    }
}

fn read_file(path: &Path) -> Result<String, String> {
    std::fs::read_to_string(path).map_err(|error| format!("auth.keys_file {}: {error}", path.display()))
}

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
    match app.keys.admit(request.headers()) {
        Ok(caller) => {
            if let Some(name) = caller.owner() {
                tracing::Span::current().record("key", name);
            }
            request.extensions_mut().insert(caller);
            next.run(request).await
        }
        Err(failure) => failure.into_response(),
    }
}

/// On a loopback address, only requests to a loopback name (or one that the operator added) are meant for this server: a page
/// of another site whose name was made to point here must not reach it.
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
    use std::time::Duration;

    fn keys(pairs: &[(&str, &str)]) -> AuthConfig {
        let keys = pairs.iter().map(|(name, digest)| ((*name).into(), (*digest).into())).collect();
        AuthConfig { keys, ..AuthConfig::default() }
    }

    fn bearer(text: &str) -> HeaderMap {
        HeaderMap::from_iter([(header::AUTHORIZATION, HeaderValue::from_str(text).unwrap())])
    }

    #[test]
    fn a_key_is_known_by_its_digest_only() {
        let (key, digest) = new_key().unwrap();
        let (other, other_digest) = new_key().unwrap();
        assert_ne!(key, other);
        let known = Keys::load(&keys(&[("me", &digest), ("you", &other_digest)])).unwrap();
        let admitted =
            |text: &str| known.admit(&bearer(text)).ok().and_then(|caller| caller.owner().map(str::to_owned));
        assert_eq!(admitted(&format!("Bearer {key}")).as_deref(), Some("me"));
        assert_eq!(admitted(&format!("bearer {other}")).as_deref(), Some("you"));
        for wrong in [
            format!("Bearer {digest}"),
            format!("Basic {key}"),
            key.clone(),
            format!("Bearer {key}0"),
            "Bearer ".into(),
        ] {
            assert!(known.admit(&bearer(&wrong)).is_err(), "{wrong}");
        }
        assert!(known.admit(&HeaderMap::new()).is_err());
        assert!(!format!("{known:?}").contains(&digest[..8]));
    }

    #[test]
    fn without_keys_everybody_is_nobody() {
        let none = Keys::load(&AuthConfig::default()).unwrap();
        assert!(none.is_empty());
        assert_eq!(none.admit(&HeaderMap::new()).unwrap().owner(), None);
    }

    #[test]
    fn a_wrong_key_setting_is_named() {
        let digest = "00".repeat(32);
        let error = |config: &AuthConfig| Keys::load(config).unwrap_err();
        assert!(error(&keys(&[("me", "12")])).contains("auth.keys.me"));
        assert!(error(&keys(&[("me", &"é".repeat(32))])).contains("auth.keys.me"));
        assert!(error(&keys(&[("a b", &digest)])).contains("auth.keys.a b"));
        let folder = tempfile::tempdir().unwrap();
        let file = folder.path().join("keys");
        std::fs::write(&file, format!("# ours\nme {digest}\n\nyou\n")).unwrap();
        let mut config = AuthConfig { keys_file: file.clone(), ..AuthConfig::default() };
        assert!(error(&config).contains("line 4"));
        std::fs::write(&file, format!("me {digest}\n")).unwrap();
        assert!(!Keys::load(&config).unwrap().is_empty());
        config.keys.insert("me".into(), digest);
        assert!(error(&config).contains("twice"));
    }

    #[test]
    fn an_allowance_refills_with_time() {
        let start = Instant::now();
        let mut allowance = Allowance { requests: 2.0, at: start };
        assert_eq!(allowance.take(2.0, start), Ok(()));
        assert_eq!(allowance.take(2.0, start), Ok(()));
        assert_eq!(allowance.take(2.0, start), Err(30.0));
        assert_eq!(allowance.take(2.0, start + Duration::from_secs(30)), Ok(()));
        assert!(allowance.take(2.0, start + Duration::from_secs(30)).is_err());
        // A long pause saves up one minute's requests and no more.
        let later = start + Duration::from_secs(3600);
        assert_eq!([(); 3].map(|()| allowance.take(2.0, later).is_ok()), [true, true, false]);
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
