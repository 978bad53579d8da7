//! Sends a signed message to a client's URL when its job or batch has ended, to public addresses only. The messages
//! follow Standard Webhooks (<https://github.com/standard-webhooks/standard-webhooks>, specification 1.0).
//!
//! The client chooses the URL, so the server must not trust it. Only https is allowed, redirects are not followed, and
//! no proxy is used. At every attempt the host name is resolved again. Each of its addresses must be public
//! ([`address`]) or in a network that the operator allows. The connection goes to the address that was checked, and the
//! certificate is checked for the name. Only the status of the response is read. The client who named the URL sees
//! whether the message was accepted, but not the status.
//!
//! Every key has its own signing secret, derived from the operator's secret. One client therefore cannot forge messages
//! for another.

pub mod address;

use crate::config::WebhooksConfig;
use address::Network;
use base64::Engine as _;
use base64::engine::general_purpose::STANDARD as BASE64;
use bytes::Bytes;
use hmac::{Hmac, KeyInit, Mac};
use http_body_util::Full;
use hyper::{Request, StatusCode, header};
use hyper_util::rt::TokioIo;
use rustls::pki_types::ServerName;
use rustls::{ClientConfig, RootCertStore};
use sha2::Sha256;
use std::fmt;
use std::net::{IpAddr, SocketAddr};
use std::sync::Arc;
use std::time::Duration;
use tokio::net::TcpStream;
use tokio_rustls::TlsConnector;
use url::{Host, Url};

const SECRET_PREFIX: &str = "whsec_";
/// Range of secret lengths that Standard Webhooks allows.
const SECRET_BYTES: std::ops::RangeInclusive<usize> = 24..=64;

/// The operator's secret, from which the secret of each key is derived, and an older one while it is being replaced.
/// Messages are signed with both, so that receivers can change to the newer one at any time meanwhile.
pub struct Secret(Vec<Vec<u8>>);

/// Largest number of secrets in the file.
const SECRETS_MAX: usize = 2;

// Logs must not contain the secret.
impl fmt::Debug for Secret {
    fn fmt(&self, formatter: &mut fmt::Formatter<'_>) -> fmt::Result {
        formatter.write_str("Secret")
    }
}

impl Secret {
    /// Reads the configured file. Returns `None` if no file is configured, which means that webhooks are off.
    ///
    /// # Errors
    /// Returns a message that names the setting.
    pub fn load(config: &WebhooksConfig) -> Result<Option<Self>, String> {
        let file = &config.secret_file;
        if file.as_os_str().is_empty() {
            return Ok(None);
        }
        let error = |reason: &str| format!("webhooks.secret_file {}: {reason}", file.display());
        let text = std::fs::read_to_string(file).map_err(|io| error(&io.to_string()))?;
        let mut secrets = Vec::new();
        for line in text.lines().map(str::trim).filter(|line| !line.is_empty()) {
            let encoded = line.strip_prefix(SECRET_PREFIX).unwrap_or(line);
            let secret = BASE64.decode(encoded).map_err(|_| error("expected whsec_ and base64"))?;
            if !SECRET_BYTES.contains(&secret.len()) {
                return Err(error("expected 24 to 64 bytes in base64"));
            }
            secrets.push(secret);
        }
        match secrets.len() {
            1..=SECRETS_MAX => Ok(Some(Self(secrets))),
            count => Err(error(&format!("expected one secret, or a new one and the one before it; it has {count}"))),
        }
    }

    fn mac(secret: &[u8], parts: &[&[u8]]) -> [u8; 32] {
        let mut mac = Hmac::<Sha256>::new_from_slice(secret).expect("HMAC takes keys of any length");
        parts.iter().for_each(|part| mac.update(part));
        mac.finalize().into_bytes().into()
    }

    /// Returns the secrets of a key, the newest first.
    fn bytes_of(&self, owner: Option<&str>) -> impl Iterator<Item = [u8; 32]> {
        let derived =
            move |secret: &Vec<u8>| Self::mac(secret, &[b"webhooks of ", owner.unwrap_or_default().as_bytes()]);
        self.0.iter().map(derived)
    }

    /// Returns the secrets that sign messages about this key's jobs, the newest first, in the form that a Standard
    /// Webhooks library takes. Without a name, returns those for the jobs of a server without keys.
    #[must_use]
    pub fn of(&self, owner: Option<&str>) -> Vec<String> {
        self.bytes_of(owner).map(|secret| format!("{SECRET_PREFIX}{}", BASE64.encode(secret))).collect()
    }

    fn signature(&self, message: &Message<'_>, timestamp_s: &str) -> String {
        let parts = [message.id.as_bytes(), b".", timestamp_s.as_bytes(), b".", message.body];
        let sign = |secret: [u8; 32]| format!("v1,{}", BASE64.encode(Self::mac(&secret, &parts)));
        self.bytes_of(message.owner).map(sign).collect::<Vec<_>>().join(" ")
    }
}

/// Message to send.
#[derive(Clone, Copy, Debug)]
pub struct Message<'m> {
    /// Identifier of the message. It is the same at every attempt, so that a receiver can drop repetitions.
    pub id: &'m str,
    /// Name of the key whose secret signs the message.
    pub owner: Option<&'m str>,
    pub body: &'m [u8],
}

/// Reason for a failed delivery.
#[derive(Debug, PartialEq, Eq)]
pub enum Undelivered {
    /// The receiver refused further attempts by answering 410.
    Unwanted,
    /// The attempt failed and may be repeated.
    Failed(String),
}

/// Sends messages.
pub struct Sender {
    secret: Secret,
    allowed: Vec<Network>,
    timeout: Duration,
    tls: TlsConnector,
}

impl fmt::Debug for Sender {
    fn fmt(&self, formatter: &mut fmt::Formatter<'_>) -> fmt::Result {
        formatter.debug_struct("Sender").field("allowed", &self.allowed).finish_non_exhaustive()
    }
}

impl Sender {
    /// Returns `None` if webhooks are off.
    ///
    /// # Errors
    /// Returns a message that names the setting if the secret cannot be read, a network is invalid, or the system has
    /// no root certificates.
    pub fn load(config: &WebhooksConfig) -> Result<Option<Self>, String> {
        let Some(secret) = Secret::load(config)? else { return Ok(None) };
        let allowed = allowed(config)?;
        let found = rustls_native_certs::load_native_certs();
        let mut roots = RootCertStore::empty();
        roots.add_parsable_certificates(found.certs);
        if roots.is_empty() {
            return Err(
                "webhooks.secret_file: webhooks need the system's root certificates, and there are none; install \
                        them or name a file in SSL_CERT_FILE"
                    .into(),
            );
        }
        let provider = Arc::new(rustls::crypto::ring::default_provider());
        let tls = ClientConfig::builder_with_provider(provider)
            .with_safe_default_protocol_versions()
            .map_err(|error| format!("webhooks.secret_file: {error}"))?
            .with_root_certificates(roots)
            .with_no_client_auth();
        let timeout = Duration::from_millis(config.timeout_ms);
        Ok(Some(Self { secret, allowed, timeout, tls: TlsConnector::from(Arc::new(tls)) }))
    }

    /// Checks that messages may be sent to a URL. The host name is resolved only when a message is sent.
    ///
    /// # Errors
    /// Returns what is wrong with the URL.
    pub fn check(&self, url: &str) -> Result<(), &'static str> {
        self.target(url).map(|_| ())
    }

    fn target(&self, text: &str) -> Result<Target, &'static str> {
        let url = Url::parse(text).map_err(|_| "is not a URL")?;
        if url.scheme() != "https" {
            return Err("must be https");
        }
        if !url.username().is_empty() || url.password().is_some() {
            return Err("must not carry a name or password");
        }
        let host = url.host().map(|host| host.to_owned()).ok_or("has no host")?;
        let address = match host {
            Host::Ipv4(address) => Some(IpAddr::from(address)),
            Host::Ipv6(address) => Some(IpAddr::from(address)),
            Host::Domain(_) => None,
        };
        if address.is_some_and(|address| !self.permits(address)) {
            return Err("is at an address that is not public");
        }
        let port = url.port_or_known_default().unwrap_or(443);
        let authority = url.port().map_or_else(|| host.to_string(), |port| format!("{host}:{port}"));
        let path = url[url::Position::BeforePath..url::Position::AfterQuery].to_owned();
        Ok(Target { host, port, authority, path })
    }

    fn permits(&self, address: IpAddr) -> bool {
        address::is_public(address) || self.allowed.iter().any(|network| network.contains(address))
    }

    /// Attempts once to deliver a message.
    ///
    /// # Errors
    /// Returns [`Undelivered`] unless the receiver answers 2xx in time.
    pub async fn send(&self, url: &str, message: Message<'_>, timestamp_s: i64) -> Result<(), Undelivered> {
        let attempt = async {
            let target = self.target(url).map_err(|reason| format!("the URL {reason}"))?;
            self.attempt(&target, message, timestamp_s).await
        };
        let status = match tokio::time::timeout(self.timeout, attempt).await {
            Ok(answered) => answered.map_err(Undelivered::Failed)?,
            Err(_) => return Err(Undelivered::Failed(format!("no answer within {} ms", self.timeout.as_millis()))),
        };
        match status.as_u16() {
            200..300 => Ok(()),
            410 => Err(Undelivered::Unwanted),
            status => Err(Undelivered::Failed(format!("the answer was {status}"))),
        }
    }

    async fn attempt(&self, target: &Target, message: Message<'_>, timestamp_s: i64) -> Result<StatusCode, String> {
        let address = self.resolve(target).await?;
        let message_of = |error: &dyn fmt::Display| error.to_string();
        let stream = TcpStream::connect(address).await.map_err(|error| message_of(&error))?;
        let name = match &target.host {
            Host::Domain(name) => ServerName::try_from(name.clone()).map_err(|error| message_of(&error))?,
            Host::Ipv4(address) => ServerName::from(IpAddr::from(*address)),
            Host::Ipv6(address) => ServerName::from(IpAddr::from(*address)),
        };
        let stream = self.tls.connect(name, stream).await.map_err(|error| message_of(&error))?;
        let (mut sender, connection) =
            hyper::client::conn::http1::handshake(TokioIo::new(stream)).await.map_err(|error| message_of(&error))?;
        let timestamp_s = timestamp_s.to_string();
        let request = Request::post(&target.path)
            .header(header::HOST, &target.authority)
            .header(header::CONTENT_TYPE, "application/json")
            .header(header::USER_AGENT, concat!("plateau/", env!("CARGO_PKG_VERSION")))
            .header("webhook-id", message.id)
            .header("webhook-timestamp", &timestamp_s)
            .header("webhook-signature", self.secret.signature(&message, &timestamp_s))
            .body(Full::new(Bytes::copy_from_slice(message.body)))
            .map_err(|error| message_of(&error))?;
        let mut answer = std::pin::pin!(sender.send_request(request));
        let mut connection = std::pin::pin!(connection);
        // The connection is dropped after the head of the response, because the body is not used. If the receiver
        // closes the connection right after its response, the response still counts.
        let answer = tokio::select! {
            answer = &mut answer => answer,
            _ = &mut connection => answer.await,
        };
        answer.map(|answer| answer.status()).map_err(|error| message_of(&error))
    }

    /// Returns the address to connect to: the first address of the host. If a host name resolves to both public and
    /// private addresses, the request is refused: the server never picks only the public one.
    async fn resolve(&self, target: &Target) -> Result<SocketAddr, String> {
        let found: Vec<SocketAddr> = match &target.host {
            Host::Ipv4(address) => vec![SocketAddr::from((*address, target.port))],
            Host::Ipv6(address) => vec![SocketAddr::from((*address, target.port))],
            Host::Domain(name) => {
                let found = tokio::net::lookup_host((name.as_str(), target.port)).await;
                found.map_err(|error| format!("the name does not resolve: {error}"))?.collect()
            }
        };
        if found.iter().any(|address| !self.permits(address.ip())) {
            return Err("the name resolves to an address that is not public".into());
        }
        found.first().copied().ok_or_else(|| "the name has no address".into())
    }
}

/// Parses the setting `webhooks.allowed_networks`.
///
/// # Errors
/// Returns a message that names the setting.
pub fn allowed(config: &WebhooksConfig) -> Result<Vec<Network>, String> {
    let networks = config.allowed_networks.iter().map(|text| {
        text.parse().map_err(|()| {
            format!("webhooks.allowed_networks: {text} is not a network such as 10.1.0.0/16 or fd00:1::/64")
        })
    });
    networks.collect()
}

/// Parsed address of a receiver.
#[derive(Debug)]
struct Target {
    host: Host,
    port: u16,
    authority: String,
    path: String,
}

#[cfg(test)]
mod tests {
    use super::*;

    fn sender(allowed_networks: &[&str]) -> Sender {
        let folder = tempfile::tempdir().unwrap();
        let secret_file = folder.path().join("secret");
        std::fs::write(&secret_file, "whsec_MfKQ9r8GKYqrTwjUPD8ILPZIo2LaLaSw\n").unwrap();
        let allowed_networks = allowed_networks.iter().map(|network| (*network).into()).collect();
        let config = WebhooksConfig { secret_file, allowed_networks, ..WebhooksConfig::default() };
        let tls = ClientConfig::builder_with_provider(Arc::new(rustls::crypto::ring::default_provider()))
            .with_safe_default_protocol_versions()
            .unwrap()
            .with_root_certificates(RootCertStore::empty())
            .with_no_client_auth();
        Sender {
            secret: Secret::load(&config).unwrap().unwrap(),
            allowed: allowed(&config).unwrap(),
            timeout: Duration::from_secs(5),
            tls: TlsConnector::from(Arc::new(tls)),
        }
    }

    /// The secret, message and signature come from the specification's reference libraries.
    #[test]
    fn a_signature_equals_the_one_in_the_specification() {
        let secret = BASE64.decode("MfKQ9r8GKYqrTwjUPD8ILPZIo2LaLaSw").unwrap();
        let parts: [&[u8]; 5] =
            [b"msg_p5jXN8AQM9LWM0D4loKWxJek", b".", b"1614265330", b".", br#"{"test": 2432232314}"#];
        assert_eq!(BASE64.encode(Secret::mac(&secret, &parts)), "g0hM9SsE+OTPJTGt/tmIKtSyZlE3uFJELVlNIOLJ1OE=");
    }

    #[test]
    fn every_key_has_a_secret_of_its_own() {
        let secret = sender(&[]).secret;
        let secrets = [None, Some("alice"), Some("bob")].map(|owner| secret.of(owner));
        assert!(secrets[0] != secrets[1] && secrets[1] != secrets[2] && secrets[0] != secrets[2]);
        assert_eq!(secrets[1], secret.of(Some("alice")));
        assert!(!format!("{secret:?}").contains("MfKQ"));
    }

    #[test]
    fn while_a_secret_is_replaced_messages_are_signed_with_both() {
        let [old, new] = [[1_u8; 24], [2; 24]].map(|bytes| Secret(vec![bytes.to_vec()]));
        let both = Secret(vec![new.0[0].clone(), old.0[0].clone()]);
        let message = Message { id: "m", owner: Some("alice"), body: b"{}" };
        let signatures = [&new, &old].map(|secret| secret.signature(&message, "1614265330"));
        assert_eq!(both.signature(&message, "1614265330"), signatures.join(" "));
        assert_eq!(both.of(Some("alice")), [new.of(Some("alice")), old.of(Some("alice"))].concat());
    }

    #[test]
    fn only_https_urls_of_public_hosts_are_accepted() {
        let strict = sender(&[]);
        for good in ["https://example.org/hook?a=b", "https://93.184.216.34/", "https://[2606:2800:220:1::1]:8443/x"] {
            assert_eq!(strict.check(good), Ok(()), "{good}");
        }
        for (bad, why) in [
            ("http://example.org/", "https"),
            ("ftp://example.org/", "https"),
            ("example.org", "not a URL"),
            ("https://", "not a URL"),
            ("https://me:secret@example.org/", "password"),
            ("https://127.0.0.1/", "public"),
            // The next three hosts are other notations of loopback addresses.
            ("https://2130706433/", "public"),
            ("https://0x7f.1/", "public"),
            ("https://0177.0.0.1/", "public"),
            ("https://[::1]/", "public"),
            ("https://[::ffff:10.0.0.1]/", "public"),
            ("https://[64:ff9b::169.254.169.254]/", "public"),
        ] {
            let refused = strict.check(bad).unwrap_err();
            assert!(refused.contains(why), "{bad}: {refused}");
        }
        let lenient = sender(&["10.0.0.0/8"]);
        assert_eq!(lenient.check("https://10.1.2.3/"), Ok(()));
        assert!(lenient.check("https://[::ffff:10.0.0.1]/").is_err());
    }

    #[test]
    fn a_host_name_outside_ascii_becomes_its_ascii_form() {
        let strict = sender(&[]);
        for (url, host) in [
            ("https://b\u{fc}cher.example:8443/\u{e4}?a=b", "xn--bcher-kva.example"),
            ("https://B\u{dc}CHER.example/", "xn--bcher-kva.example"),
            ("https://xn--bcher-kva.example/", "xn--bcher-kva.example"),
        ] {
            let target = strict.target(url).unwrap_or_else(|reason| panic!("{url} {reason}"));
            assert_eq!(target.host, Host::<String>::Domain(host.into()), "{url}");
            assert!(target.authority.starts_with(host) && target.path.is_ascii(), "{target:?}");
        }
        // Full-width digits and dots are other notations of the ordinary ones.
        for (bad, why) in [
            ("https://\u{ff11}\u{ff12}\u{ff17}.0.0.1/", "public"),
            ("https://127\u{3002}0\u{3002}0\u{3002}1/", "public"),
            // This is the punycode of a character that host names cannot have.
            ("https://xn--a.example/", "not a URL"),
        ] {
            assert_eq!(strict.check(bad).map_err(|reason| reason.contains(why)), Err(true), "{bad}");
        }
    }

    #[tokio::test]
    async fn a_host_name_is_refused_if_it_resolves_to_a_private_address() {
        let message = Message { id: "m", owner: None, body: b"{}" };
        let refused = sender(&[]).send("https://localhost:9/", message, 0).await;
        let Err(Undelivered::Failed(why)) = refused else { panic!("{refused:?}") };
        assert!(why.contains("not public"), "{why}");
    }

    #[test]
    fn an_error_message_names_the_wrong_setting() {
        let folder = tempfile::tempdir().unwrap();
        let file = folder.path().join("secret");
        let load = |text: &str| {
            std::fs::write(&file, text).unwrap();
            Secret::load(&WebhooksConfig { secret_file: file.clone(), ..WebhooksConfig::default() })
        };
        assert!(load("whsec_AAAA").unwrap_err().contains("webhooks.secret_file"));
        assert!(load("whsec_?").unwrap_err().contains("base64"));
        assert!(load("\n").unwrap_err().contains("webhooks.secret_file"));
        let lines = |count: usize| "whsec_MfKQ9r8GKYqrTwjUPD8ILPZIo2LaLaSw\n".repeat(count);
        assert!(load(&lines(3)).unwrap_err().contains("it has 3"));
        assert_eq!(load(&lines(2)).unwrap().unwrap().of(None).len(), 2);
        let config = WebhooksConfig { allowed_networks: vec!["10.0.0.0/33".into()], ..WebhooksConfig::default() };
        assert!(allowed(&config).unwrap_err().contains("webhooks.allowed_networks"));
        assert!(Secret::load(&WebhooksConfig::default()).unwrap().is_none());
    }
}
