//! Creates and checks API keys, and limits the requests of each key and the failures of each address.
//!
//! A key is 32 random bytes and is shown once; the configuration holds only its SHA-256. A presented key is hashed and
//! compared with every known digest in full, so that the time taken reveals nothing. Without keys, every client may do
//! everything.
//!
//! A known key is admitted from every address, however often that address has presented unknown keys: behind a proxy
//! all clients have one address, and one client's failures must not lock the others out.

use crate::config::AuthConfig;
use crate::telemetry::metric;
use futures_util::FutureExt;
use futures_util::future::{BoxFuture, Shared};
use governor::clock::Clock;
use governor::middleware::StateInformationMiddleware;
use governor::{DefaultKeyedRateLimiter, Quota, RateLimiter};
use sha2::{Digest as _, Sha256};
use std::collections::BTreeMap;
use std::num::NonZeroU32;
use std::path::Path;
use std::sync::{Arc, PoisonError, RwLock};
use std::time::{Duration, SystemTime};
use subtle::ConstantTimeEq;
use tokio::sync::watch;

const PREFIX: &str = "plateau_";
const KEY_BYTES: usize = 32;
/// Interval at which the keys file is checked for changes.
const RELOAD_INTERVAL: Duration = Duration::from_secs(1);
/// Interval at which addresses without recent failures are forgotten. In between, each address that presents an unknown
/// key takes about a hundred bytes.
const FORGET_INTERVAL: Duration = Duration::from_secs(5);

/// Returns a new key and the digest that the configuration keeps of it.
///
/// # Errors
/// Fails if the system provides no random bytes.
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

/// Returns true for a name that is safe in logs, in the database and in a keys file.
#[must_use]
pub fn is_key_name(name: &str) -> bool {
    (1..=64).contains(&name.len()) && name.bytes().all(|byte| byte.is_ascii_alphanumeric() || b"-_.".contains(&byte))
}

/// Keys that this server accepts. The keys file is read again when it changes.
#[derive(Debug)]
pub struct Keys {
    config: AuthConfig,
    known: RwLock<Known>,
    /// Changes whenever the known keys have been replaced.
    replaced: watch::Sender<()>,
    /// Requests of each name, if they are limited.
    requests: Option<DefaultKeyedRateLimiter<Arc<str>, StateInformationMiddleware>>,
    /// Unknown keys that each address has presented, if they are limited.
    failures: Option<DefaultKeyedRateLimiter<String>>,
}

/// Returns the quota of a number of requests in a minute, all of which may come at once after a minute's pause, or
/// `None` for 0, which means no limit.
fn quota(per_minute: u32) -> Option<Quota> {
    NonZeroU32::new(per_minute).map(Quota::per_minute)
}

/// Future that completes when a key is no longer known.
pub type Removal = Shared<BoxFuture<'static, ()>>;

/// Content of the configuration and of the keys file when they were last read.
#[derive(Debug, Default)]
struct Known {
    keys: Vec<Key>,
    /// Whether requests need a key. The flag never goes back to false: emptying the keys file locks every client out.
    required: bool,
}

/// The keys of a name. While a key is replaced, the name has two.
#[derive(Debug)]
struct Key {
    name: Arc<str>,
    digests: Vec<Digest>,
}

/// The digest of a key, the time until which the key is valid, and what it may do.
#[derive(Clone, Copy, PartialEq, Eq)]
pub struct Digest {
    sha256: [u8; 32],
    until: Option<SystemTime>,
    scopes: Scopes,
}

/// One thing that a key may do.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Scope {
    /// Submit requests, and cancel and delete jobs.
    Submit,
    /// Read jobs, results and the catalogue.
    Read,
    /// Read `/metrics`.
    Metrics,
}

impl Scope {
    const ALL: [Self; 3] = [Self::Submit, Self::Read, Self::Metrics];

    /// Returns the word for this scope in a keys file.
    #[must_use]
    pub fn name(self) -> &'static str {
        match self {
            Self::Submit => "submit",
            Self::Read => "read",
            Self::Metrics => "metrics",
        }
    }
}

/// Everything that a key may do.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
struct Scopes([bool; Scope::ALL.len()]);

impl Scopes {
    /// The scopes of a key without named ones.
    const EVERYTHING: Self = Self([true; Scope::ALL.len()]);

    /// Reads the names of scopes. No name means every scope.
    fn read(names: &[&str]) -> Result<Self, String> {
        if names.is_empty() {
            return Ok(Self::EVERYTHING);
        }
        let mut scopes = Self([false; Scope::ALL.len()]);
        for name in names {
            let known = Scope::ALL.into_iter().find(|scope| scope.name() == *name);
            let scope = known.ok_or_else(|| {
                let all = Scope::ALL.map(Scope::name).join(", ");
                format!("{name:?} is neither a time in UTC like 2026-12-31T00:00:00Z nor a scope ({all})")
            })?;
            scopes.0[scope as usize] = true;
        }
        Ok(scopes)
    }

    fn has(self, scope: Scope) -> bool {
        self.0[scope as usize]
    }
}

// Logs must not contain digests.
impl std::fmt::Debug for Digest {
    fn fmt(&self, formatter: &mut std::fmt::Formatter<'_>) -> std::fmt::Result {
        formatter.debug_struct("Digest").field("until", &self.until).finish_non_exhaustive()
    }
}

impl Digest {
    /// Reads `SHA256 [UNTIL] [SCOPE…]`, given as words.
    fn read(words: &[&str]) -> Result<Self, String> {
        let [sha256, rest @ ..] = words else { return Err("expected a SHA-256".into()) };
        let sha256 = from_hex(sha256).ok_or("expected a SHA-256 of 64 hex digits")?;
        let until = rest.first().and_then(|word| humantime::parse_rfc3339(word).ok());
        let scopes = Scopes::read(&rest[usize::from(until.is_some())..])?;
        Ok(Self { sha256, until, scopes })
    }

    fn is_valid_at(&self, now: SystemTime) -> bool {
        self.until.is_none_or(|until| now < until)
    }

    /// Returns the first of these scopes that the key does not have.
    #[must_use]
    pub fn lacks(&self, scopes: &[Scope]) -> Option<Scope> {
        scopes.iter().copied().find(|scope| !self.scopes.has(*scope))
    }
}

/// Requests that a key may still make.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Left {
    /// Number of requests that the key may make at once.
    pub requests: u32,
    /// Seconds until the key may make the requests of a whole minute at once.
    pub full_in_s: u64,
}

/// A request that may go on.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Admitted {
    /// Name and digest of the key, or `None` if the server requires no key.
    pub key: Option<(Arc<str>, Digest)>,
    /// Requests that the key may still make, if they are limited.
    pub left: Option<Left>,
}

/// Reason for refusing a request.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum AuthError {
    /// The server requires a key, and the request carries no known key.
    Unknown,
    /// The key is unknown, and its address has presented too many of them. One more counts as unknown after this time.
    TooManyUnknown { wait: Duration },
    /// The key has used up its requests. One more will be available after this time.
    TooMany { wait: Duration },
}

impl Keys {
    /// Reads the keys of the configuration and of its keys file, which has one `NAME SHA256 [UNTIL] [SCOPE…]` per line.
    ///
    /// # Errors
    /// Returns a message that names the setting and, for the keys file, the line.
    pub fn load(config: &AuthConfig) -> Result<Self, String> {
        let text = read_file(&config.keys_file)?;
        let keys = Self {
            config: config.clone(),
            known: RwLock::default(),
            replaced: watch::Sender::new(()),
            requests: quota(config.requests_per_minute).map(|quota| RateLimiter::keyed(quota).with_middleware()),
            failures: quota(config.failures_per_minute).map(RateLimiter::keyed),
        };
        keys.replace(&text)?;
        Ok(keys)
    }

    /// Replaces the known keys by those of the configuration and of `text`, the content of the keys file. If the text
    /// is invalid, the known keys stay as they were.
    fn replace(&self, text: &str) -> Result<(), String> {
        let digests = digests(&self.config, text)?;
        let mut known = self.known.write().unwrap_or_else(PoisonError::into_inner);
        let keys = digests.into_iter().map(|(name, digests)| Key { name: name.into(), digests });
        let keys: Vec<_> = keys.collect();
        known.required |= !keys.is_empty();
        known.keys = keys;
        drop(known);
        self.replaced.send_replace(());
        Ok(())
    }

    /// Reads the keys file again whenever its text changes, and never returns. An invalid file leaves the keys as they
    /// were. If the file itself is a mount and is replaced outside of the mount, this process keeps seeing the old
    /// file, which is logged.
    pub async fn follow_file(&self) {
        let path = &self.config.keys_file;
        if path.as_os_str().is_empty() {
            return std::future::pending().await;
        }
        let (mut last, mut detached) = (None, false);
        loop {
            if !std::mem::replace(&mut detached, is_detached(path)) && detached {
                tracing::error!(
                    "auth.keys_file {} was replaced outside of its mount and is never read again here: mount its \
                     folder",
                    path.display()
                );
            }
            let read = tokio::fs::read_to_string(path).await.map_err(|error| file_error(path, &error));
            if last.as_ref() != Some(&read) {
                // In the first round the text normally equals the one loaded at the start, so only later rounds are
                // logged.
                match read.as_deref().map_err(Clone::clone).and_then(|text| self.replace(text)) {
                    Ok(()) if last.is_some() => tracing::info!(keys = self.count(), "read the keys file again"),
                    Ok(()) => {}
                    Err(error) => tracing::error!(error, "the keys file cannot be used; the keys stay as they were"),
                }
                last = Some(read);
            }
            tokio::time::sleep(RELOAD_INTERVAL).await;
        }
    }

    /// Forgets the addresses and names whose failures and requests are long past, and never returns.
    pub async fn forget(&self) {
        loop {
            tokio::time::sleep(FORGET_INTERVAL).await;
            self.forget_now();
        }
    }

    fn forget_now(&self) {
        if let Some(requests) = &self.requests {
            requests.retain_recent();
        }
        if let Some(failures) = &self.failures {
            failures.retain_recent();
            failures.shrink_to_fit();
        }
    }

    /// Returns a future that completes when this key of this name is removed, is not valid any more, or may do other
    /// things.
    pub fn removal(self: &Arc<Self>, name: Arc<str>, digest: Digest) -> Removal {
        let keys = self.clone();
        let mut replaced = self.replaced.subscribe();
        let removed = async move {
            while let Some(digest) = keys.known_as(&name, &digest) {
                let now = SystemTime::now();
                if !digest.is_valid_at(now) {
                    break;
                }
                let end = async {
                    match digest.until {
                        // The clock may be set meanwhile, so the time is looked at again before long.
                        Some(until) => {
                            let left = until.duration_since(now).unwrap_or_default();
                            tokio::time::sleep(left.min(Duration::from_secs(60))).await;
                        }
                        None => std::future::pending().await,
                    }
                };
                tokio::select! {
                    // Waiting cannot fail, because `keys` owns the sender.
                    _ = replaced.changed() => {}
                    () = end => {}
                }
            }
        };
        removed.boxed().shared()
    }

    /// Returns this key of this name with its present end, if the name still has the key with the same scopes.
    fn known_as(&self, name: &str, digest: &Digest) -> Option<Digest> {
        let known = self.known.read().unwrap_or_else(PoisonError::into_inner);
        let key = known.keys.iter().find(|key| *key.name == *name)?;
        key.digests.iter().find(|known| known.sha256 == digest.sha256 && known.scopes == digest.scopes).copied()
    }

    /// Returns true if a keys file is configured, and neither it nor the configuration has a key.
    #[must_use]
    pub fn file_is_empty(&self) -> bool {
        !self.config.keys_file.as_os_str().is_empty() && !self.required()
    }

    fn count(&self) -> usize {
        self.known.read().unwrap_or_else(PoisonError::into_inner).keys.len()
    }

    /// Returns true if requests need a key.
    #[must_use]
    pub fn required(&self) -> bool {
        self.known.read().unwrap_or_else(PoisonError::into_inner).required
    }

    /// Takes one request from the allowance of the presented key. `address` is where the request came from.
    ///
    /// # Errors
    /// Returns a [`AuthError`].
    pub fn admit(&self, presented: Option<&str>, address: &str) -> Result<Admitted, AuthError> {
        let found = {
            let known = self.known.read().unwrap_or_else(PoisonError::into_inner);
            if !known.required {
                return Ok(Admitted { key: None, left: None });
            }
            presented.and_then(|presented| known.find(presented, SystemTime::now()))
        };
        let Some((name, digest)) = found else { return Err(self.failure(presented, address)) };
        let mut left = None;
        if let Some(requests) = &self.requests {
            let taken = requests.check_key(&name);
            let taken =
                taken.map_err(|early| AuthError::TooMany { wait: early.wait_time_from(requests.clock().now()) })?;
            let (remaining, per_minute) = (taken.remaining_burst_capacity(), self.config.requests_per_minute);
            let full_in_s = (u64::from(per_minute - remaining) * 60).div_ceil(per_minute.into());
            left = Some(Left { requests: remaining, full_in_s });
        }
        Ok(Admitted { key: Some((name, digest)), left })
    }

    /// Counts a failure of an address. A request without a key is no guess, so it does not count.
    fn failure(&self, presented: Option<&str>, address: &str) -> AuthError {
        if presented.is_some() {
            metrics::counter!(metric::AUTH_FAILURES).increment(1);
            if let Some(failures) = &self.failures
                && let Err(early) = failures.check_key(&address.to_owned())
            {
                return AuthError::TooManyUnknown { wait: early.wait_time_from(failures.clock().now()) };
            }
        }
        AuthError::Unknown
    }
}

impl Known {
    /// Finds the key with this text. The time taken does not depend on which key matches, or whether one does.
    fn find(&self, presented: &str, now: SystemTime) -> Option<(Arc<str>, Digest)> {
        let sha256: [u8; 32] = Sha256::digest(presented.as_bytes()).into();
        let mut found = None;
        for key in &self.keys {
            for digest in &key.digests {
                if digest.sha256.ct_eq(&sha256).into() {
                    found = Some((key, digest));
                }
            }
        }
        found.filter(|(_, digest)| digest.is_valid_at(now)).map(|(key, digest)| (key.name.clone(), *digest))
    }
}

/// Number of keys that a name may have, so that one can replace the other.
const KEYS_OF_A_NAME: usize = 2;

/// Returns the digests of the keys of each name, read from the configuration and from the text of its keys file.
fn digests(config: &AuthConfig, text: &str) -> Result<BTreeMap<String, Vec<Digest>>, String> {
    let mut digests: BTreeMap<String, Vec<Digest>> = BTreeMap::new();
    let mut add = |origin: String, name: &str, words: &[&str]| {
        if !is_key_name(name) {
            return Err(format!("{origin}: a key's name has 1 to 64 letters, digits, dots, dashes or underscores"));
        }
        let digest = Digest::read(words).map_err(|reason| format!("{origin}: {reason}"))?;
        let of_name = digests.entry(name.to_owned()).or_default();
        if of_name.iter().any(|known| known.sha256 == digest.sha256) {
            return Err(format!("{origin}: this key of the name {name} is given twice"));
        }
        if of_name.len() == KEYS_OF_A_NAME {
            return Err(format!("{origin}: the name {name} has more than {KEYS_OF_A_NAME} keys"));
        }
        of_name.push(digest);
        Ok(())
    };
    for (name, keys) in &config.keys {
        for key in keys.split(',') {
            add(format!("auth.keys.{name}"), name, &key.split_whitespace().collect::<Vec<_>>())?;
        }
    }
    for (number, line) in text.lines().enumerate() {
        let line = line.trim();
        if line.is_empty() || line.starts_with('#') {
            continue;
        }
        let origin = format!("auth.keys_file {} line {}", config.keys_file.display(), number + 1);
        match line.split_whitespace().collect::<Vec<_>>()[..] {
            [name, ref words @ ..] if !words.is_empty() => add(origin, name, words)?,
            _ => return Err(format!("{origin}: expected NAME SHA256, and perhaps UNTIL and scopes")),
        }
    }
    Ok(digests)
}

/// Returns the text of the keys file, or an empty text if no file is configured.
fn read_file(path: &Path) -> Result<String, String> {
    if path.as_os_str().is_empty() {
        return Ok(String::new());
    }
    std::fs::read_to_string(path).map_err(|error| file_error(path, &error))
}

/// Returns true if the file that this path leads to was removed or replaced in its folder, so that its link count is 0.
/// The path still leads to such a file if the file itself is mounted.
fn is_detached(path: &Path) -> bool {
    use std::os::unix::fs::MetadataExt;
    std::fs::metadata(path).is_ok_and(|file| file.nlink() == 0)
}

fn file_error(path: &Path, error: &std::io::Error) -> String {
    format!("auth.keys_file {}: {error}", path.display())
}

#[cfg(test)]
mod tests {
    use super::*;

    fn keys_of(pairs: &[(&str, &str)]) -> AuthConfig {
        let keys = pairs.iter().map(|(name, digest)| ((*name).into(), (*digest).into())).collect();
        AuthConfig { keys, ..AuthConfig::default() }
    }

    fn name_of(admitted: Result<Admitted, AuthError>) -> Option<Arc<str>> {
        admitted.ok()?.key.map(|(name, _)| name)
    }

    #[test]
    fn a_key_is_known_by_its_digest_only() {
        let (key, digest) = new_key().unwrap();
        let (other, other_digest) = new_key().unwrap();
        assert_ne!(key, other);
        let known = Keys::load(&keys_of(&[("me", &digest), ("you", &other_digest)])).unwrap();
        let admitted = |text: &str| name_of(known.admit(Some(text), ""));
        assert_eq!(admitted(&key).as_deref(), Some("me"));
        assert_eq!(admitted(&other).as_deref(), Some("you"));
        for wrong in [digest.clone(), format!("{key}0"), String::new()] {
            assert_eq!(known.admit(Some(&wrong), ""), Err(AuthError::Unknown), "{wrong}");
        }
        assert_eq!(known.admit(None, ""), Err(AuthError::Unknown));
        assert!(!format!("{known:?}").contains(&digest[..8]));
    }

    #[test]
    fn a_server_without_keys_admits_requests_without_an_owner() {
        let none = Keys::load(&AuthConfig::default()).unwrap();
        assert!(!none.required());
        assert_eq!(none.admit(None, ""), Ok(Admitted { key: None, left: None }));
    }

    #[test]
    fn an_error_message_names_the_wrong_key_setting() {
        let digest = "00".repeat(32);
        let error = |config: &AuthConfig| Keys::load(config).unwrap_err();
        assert!(error(&keys_of(&[("me", "12")])).contains("auth.keys.me"));
        assert!(error(&keys_of(&[("me", &"é".repeat(32))])).contains("auth.keys.me"));
        assert!(error(&keys_of(&[("a b", &digest)])).contains("auth.keys.a b"));
        let folder = tempfile::tempdir().unwrap();
        let file = folder.path().join("keys");
        std::fs::write(&file, format!("# ours\nme {digest}\n\nyou\n")).unwrap();
        let mut config = AuthConfig { keys_file: file.clone(), ..AuthConfig::default() };
        assert!(error(&config).contains("line 4"));
        std::fs::write(&file, format!("me {digest}\n")).unwrap();
        assert!(Keys::load(&config).unwrap().required());
        config.keys.insert("me".into(), digest);
        assert!(error(&config).contains("twice"));
    }

    #[test]
    fn an_address_with_many_unknown_keys_is_told_to_wait_and_its_known_keys_are_admitted() {
        let (key, digest) = new_key().unwrap();
        let config = AuthConfig { failures_per_minute: 3, ..keys_of(&[("me", &digest)]) };
        let keys = Keys::load(&config).unwrap();
        let from = |address: &str| keys.admit(Some("plateau_guess"), address).unwrap_err();
        for _ in 0..3 {
            assert_eq!(from("10.0.0.1"), AuthError::Unknown);
        }
        let AuthError::TooManyUnknown { wait } = from("10.0.0.1") else { panic!("the fourth is one too many") };
        assert!(wait <= Duration::from_secs(20), "{wait:?}");
        assert_eq!(from("10.0.0.2"), AuthError::Unknown);
        assert_eq!(keys.admit(None, "10.0.0.1"), Err(AuthError::Unknown), "no key is no guess");
        assert_eq!(name_of(keys.admit(Some(&key), "10.0.0.1")).as_deref(), Some("me"));
    }

    #[test]
    fn addresses_and_names_are_forgotten() {
        let (key, digest) = new_key().unwrap();
        // Both are full again after a millisecond.
        let often =
            AuthConfig { failures_per_minute: 60_000, requests_per_minute: 60_000, ..keys_of(&[("me", &digest)]) };
        let keys = Keys::load(&often).unwrap();
        assert!(keys.admit(Some(&key), "").is_ok());
        for address in 0..100 {
            assert!(keys.admit(Some("plateau_guess"), &address.to_string()).is_err());
        }
        let kept = || [keys.requests.as_ref().unwrap().len(), keys.failures.as_ref().unwrap().len()];
        assert_eq!(kept(), [1, 100]);
        std::thread::sleep(Duration::from_millis(50));
        keys.forget_now();
        assert_eq!(kept(), [0, 0]);
    }

    #[test]
    fn a_key_may_do_what_its_line_says_or_everything() {
        let [(all, all_digest), (reader, reader_digest)] = [(); 2].map(|()| new_key().unwrap());
        let keys = Keys::load(&AuthConfig::default()).unwrap();
        let lines = format!("me {all_digest}\nme {reader_digest} 2999-12-31T00:00:00Z read metrics");
        keys.replace(&lines).unwrap();
        let lacks = |key: &str, scope: Scope| keys.admit(Some(key), "").unwrap().key.unwrap().1.lacks(&[scope]);
        for scope in Scope::ALL {
            assert_eq!(lacks(&all, scope), None);
            assert_eq!(lacks(&reader, scope), (scope == Scope::Submit).then_some(scope));
        }
        keys.replace(&format!("me {reader_digest} submit")).unwrap();
        assert_eq!((lacks(&reader, Scope::Submit), lacks(&reader, Scope::Read)), (None, Some(Scope::Read)));
        let both = [Scope::Submit, Scope::Read];
        assert_eq!(keys.admit(Some(&reader), "").unwrap().key.unwrap().1.lacks(&both), Some(Scope::Read));
        let error = keys.replace(&format!("me {reader_digest} write")).unwrap_err();
        assert!(error.contains("line 1") && error.contains("\"write\"") && error.contains("submit, read"), "{error}");
    }

    #[test]
    fn an_emptied_or_invalid_keys_file_does_not_open_the_server() {
        let (key, digest) = new_key().unwrap();
        let folder = tempfile::tempdir().unwrap();
        let file = folder.path().join("keys");
        std::fs::write(&file, format!("me {digest}\n")).unwrap();
        let keys = Keys::load(&AuthConfig { keys_file: file, ..AuthConfig::default() }).unwrap();
        assert!(keys.replace("me 12").is_err());
        assert!(keys.admit(Some(&key), "").unwrap().key.is_some());
        keys.replace("").unwrap();
        assert_eq!(
            (keys.admit(Some(&key), ""), keys.admit(None, "")),
            (Err(AuthError::Unknown), Err(AuthError::Unknown))
        );
    }

    #[tokio::test]
    async fn a_removal_ends_with_its_key_only() {
        let [(first_key, first), (second_key, second)] = [new_key().unwrap(), new_key().unwrap()];
        let keys = Arc::new(Keys::load(&AuthConfig::default()).unwrap());
        let removal = |key: &str| {
            let (name, digest) = keys.admit(Some(key), "").unwrap().key.unwrap();
            keys.removal(name, digest)
        };
        keys.replace(&format!("me {first}\nme {second}")).unwrap();
        let [one, other] = [&first_key, &second_key].map(|key| removal(key));
        keys.replace(&format!("me {second}")).unwrap();
        one.await;
        assert!(other.clone().now_or_never().is_none());
        let soon = SystemTime::now() + Duration::from_millis(1500);
        let soon = humantime::format_rfc3339_millis(soon);
        keys.replace(&format!("me {second} {soon}")).unwrap();
        assert!(keys.admit(Some(&second_key), "").is_ok());
        other.await;
        assert_eq!(keys.admit(Some(&second_key), ""), Err(AuthError::Unknown));
        assert!(keys.required());
        // A key whose scopes change ends what it has open too.
        keys.replace(&format!("me {second}")).unwrap();
        let narrowed = removal(&second_key);
        keys.replace(&format!("me {second} read")).unwrap();
        let ended = tokio::time::timeout(Duration::from_secs(60), narrowed).await;
        assert!(ended.is_ok(), "the key may do other things");
    }

    #[test]
    fn a_name_has_two_keys_with_an_end_and_one_allowance() {
        let [(old, old_digest), (new, new_digest), (_, third)] = [(); 3].map(|()| new_key().unwrap());
        let config = AuthConfig { requests_per_minute: 3, ..AuthConfig::default() };
        let keys = Keys::load(&config).unwrap();
        let lines = format!("me {old_digest} 2999-12-31T00:00:00Z\nme {new_digest}\n");
        keys.replace(&lines).unwrap();
        assert_eq!(name_of(keys.admit(Some(&old), "")).as_deref(), Some("me"));
        assert_eq!(name_of(keys.admit(Some(&new), "")).as_deref(), Some("me"));
        keys.replace(&format!("me {old_digest} 2020-01-01T00:00:00Z\nme {new_digest}\n")).unwrap();
        assert_eq!(keys.admit(Some(&old), ""), Err(AuthError::Unknown));
        assert_eq!(name_of(keys.admit(Some(&new), "")).as_deref(), Some("me"));
        assert!(matches!(keys.admit(Some(&new), ""), Err(AuthError::TooMany { .. })), "one allowance of a name");
        for (wrong, reason) in [
            (format!("{lines}me {third}"), "more than 2 keys"),
            (format!("{lines}me {new_digest}"), "twice"),
            (format!("me {old_digest} tomorrow"), "a time in UTC"),
            (format!("me {old_digest} 2999-12-31T00:00:00Z more"), "\"more\" is neither"),
        ] {
            assert!(keys.replace(&wrong).unwrap_err().contains(reason), "{wrong}");
        }
        let both = [("me", &*format!("{old_digest} 2020-01-01T00:00:00Z, {new_digest}"))];
        let configured = Keys::load(&keys_of(&both)).unwrap();
        assert_eq!(configured.admit(Some(&old), ""), Err(AuthError::Unknown));
        assert_eq!(name_of(configured.admit(Some(&new), "")).as_deref(), Some("me"));
    }

    #[test]
    fn an_empty_keys_file_is_noticed() {
        let folder = tempfile::tempdir().unwrap();
        let keys_file = folder.path().join("keys");
        std::fs::write(&keys_file, "# none yet\n").unwrap();
        let config = AuthConfig { keys_file: keys_file.clone(), ..AuthConfig::default() };
        assert!(Keys::load(&config).unwrap().file_is_empty());
        assert!(!Keys::load(&AuthConfig::default()).unwrap().file_is_empty());
        std::fs::write(&keys_file, format!("me {}", new_key().unwrap().1)).unwrap();
        assert!(!Keys::load(&config).unwrap().file_is_empty());
    }

    #[test]
    fn a_file_that_was_replaced_outside_of_its_mount_is_noticed() {
        let folder = tempfile::tempdir().unwrap();
        let path = folder.path().join("keys");
        let file = std::fs::File::create(&path).unwrap();
        // This path leads to the file whatever its name is, as a mount of a single file does.
        let mounted = std::path::PathBuf::from(format!("/proc/self/fd/{}", std::os::fd::AsRawFd::as_raw_fd(&file)));
        assert!(!is_detached(&mounted) && !is_detached(&path));
        std::fs::rename(folder.path().join("keys"), folder.path().join("other")).unwrap();
        assert!(!is_detached(&mounted));
        std::fs::remove_file(folder.path().join("other")).unwrap();
        assert!(is_detached(&mounted) && !is_detached(&path));
    }

    #[test]
    fn a_key_keeps_its_allowance_when_the_file_is_read_again() {
        let (key, digest) = new_key().unwrap();
        let keys = Keys::load(&AuthConfig { requests_per_minute: 1, ..AuthConfig::default() }).unwrap();
        keys.replace(&format!("me {digest}")).unwrap();
        assert!(keys.admit(Some(&key), "").is_ok());
        keys.replace(&format!("me {digest}\n# a comment\n")).unwrap();
        assert!(matches!(keys.admit(Some(&key), ""), Err(AuthError::TooMany { .. })));
    }
}
