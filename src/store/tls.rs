//! TLS for connections to PostgreSQL. The parameters `sslmode` and `sslrootcert` of the database's
//! URL mean what they mean to libpq:
//!
//! | `sslmode` | encrypted | certificate checked | host name checked |
//! | --- | --- | --- | --- |
//! | `disable` | no | no | no |
//! | `prefer` | if that works | no | no |
//! | `require` | yes | if there are root certificates | no |
//! | `verify-ca` | yes | yes | no |
//! | `verify-full` | yes | yes | yes |
//!
//! The connector is written here, because the crate that has one (`tokio-postgres-rustls`) brings six further crates,
//! which read certificates for channel binding.

use std::path::{Path, PathBuf};
use std::pin::Pin;
use std::sync::Arc;
use std::task::{Context, Poll};
use std::{env, io};

use rustls::client::WebPkiServerVerifier;
use rustls::client::danger::{HandshakeSignatureValid, ServerCertVerified, ServerCertVerifier};
use rustls::crypto::{WebPkiSupportedAlgorithms, ring, verify_tls12_signature, verify_tls13_signature};
use rustls::pki_types::pem::PemObject;
use rustls::pki_types::{CertificateDer, ServerName, UnixTime};
use rustls::{CertificateError, ClientConfig, DigitallySignedStruct, RootCertStore, SignatureScheme};
use tokio::io::{AsyncRead, AsyncWrite, ReadBuf};
use tokio_postgres::config::SslMode;
use tokio_postgres::tls::{ChannelBinding, MakeTlsConnect, TlsConnect, TlsStream};
use tokio_rustls::TlsConnector;
use url::form_urlencoded;

/// Value of `sslrootcert` for the certificates of the operating system.
const SYSTEM: &str = "system";

/// How strictly a connection is encrypted.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
enum Mode {
    Disable,
    Prefer,
    Require,
    VerifyCa,
    VerifyFull,
}

impl Mode {
    const NAMES: [(&str, Self); 5] = [
        ("disable", Self::Disable),
        ("prefer", Self::Prefer),
        ("require", Self::Require),
        ("verify-ca", Self::VerifyCa),
        ("verify-full", Self::VerifyFull),
    ];
}

/// The parameters of a URL that concern TLS.
#[derive(Debug, Default, PartialEq, Eq)]
pub(super) struct Parameters {
    mode: Option<String>,
    roots: Option<String>,
}

impl Parameters {
    /// Takes `sslmode` and `sslrootcert` out of a URL, because the driver does not know them. Returns the rest of the
    /// URL and the two values. A value that the URL lacks comes from the environment variable `PGSSLMODE` or
    /// `PGSSLROOTCERT`.
    pub(super) fn split(url: &str) -> (String, Self) {
        let mut own = Self::default();
        let (address, query) = url.split_once('?').unwrap_or((url, ""));
        let mut others = String::new();
        for parameter in query.split('&').filter(|parameter| !parameter.is_empty()) {
            match parameter.split_once('=') {
                Some(("sslmode", value)) => own.mode = Some(decoded(value)),
                Some(("sslrootcert", value)) => own.roots = Some(decoded(value)),
                _ => others.extend([if others.is_empty() { "?" } else { "&" }, parameter]),
            }
        }
        own.mode = own.mode.or_else(|| env::var("PGSSLMODE").ok());
        own.roots = own.roots.or_else(|| env::var("PGSSLROOTCERT").ok());
        (format!("{address}{others}"), own)
    }

    /// Returns the driver's mode, and the connector unless connections are not encrypted.
    ///
    /// # Errors
    /// Returns a message that names the parameter.
    pub(super) fn connector(&self) -> Result<(SslMode, Option<Connector>), String> {
        let from_system = self.roots.as_deref() == Some(SYSTEM);
        let mode = match self.mode.as_deref() {
            None if from_system => Mode::VerifyFull,
            None => Mode::Prefer,
            Some(name) => {
                let known = Mode::NAMES.iter().find(|(known, _)| *known == name);
                known.map(|(_, mode)| *mode).ok_or_else(|| {
                    let names = Mode::NAMES.map(|(name, _)| name).join(", ");
                    format!("sslmode must be one of {names}; it is {name:?}")
                })?
            }
        };
        if from_system && mode != Mode::VerifyFull {
            return Err("sslrootcert=system needs sslmode=verify-full, because it trusts every public authority".into());
        }
        let driver_mode = match mode {
            Mode::Disable => return Ok((SslMode::Disable, None)),
            Mode::Prefer => SslMode::Prefer,
            Mode::Require | Mode::VerifyCa | Mode::VerifyFull => SslMode::Require,
        };
        let roots = if mode == Mode::Prefer { None } else { self.roots()? };
        if roots.is_none() && matches!(mode, Mode::VerifyCa | Mode::VerifyFull) {
            return Err(
                "sslmode=verify-ca and verify-full need root certificates: name their file in sslrootcert".into()
            );
        }
        let config = client_config(roots, mode == Mode::VerifyFull)
            .map_err(|error| format!("sslmode or sslrootcert cannot be used: {error}"))?;
        Ok((driver_mode, Some(Connector(TlsConnector::from(Arc::new(config))))))
    }

    /// Reads the root certificates. Without `sslrootcert` they come from `~/.postgresql/root.crt`, if that file exists.
    fn roots(&self) -> Result<Option<RootCertStore>, String> {
        let mut roots = RootCertStore::empty();
        let usual = || Some(PathBuf::from(env::var_os("HOME")?).join(".postgresql/root.crt"));
        let file = match self.roots.as_deref() {
            Some(SYSTEM) => {
                roots.add_parsable_certificates(rustls_native_certs::load_native_certs().certs);
                let missing = || "sslrootcert=system: this system has no root certificates".into();
                return if roots.is_empty() { Err(missing()) } else { Ok(Some(roots)) };
            }
            Some(path) => PathBuf::from(path),
            None => match usual().filter(|path| path.exists()) {
                Some(path) => path,
                None => return Ok(None),
            },
        };
        let error = |reason: &dyn std::fmt::Display| format!("sslrootcert {}: {reason}", file.display());
        for certificate in certificates(&file).map_err(|io| error(&io))? {
            roots.add(certificate).map_err(|unusable| error(&unusable))?;
        }
        if roots.is_empty() { Err(error(&"the file has no certificate")) } else { Ok(Some(roots)) }
    }
}

fn certificates(file: &Path) -> Result<Vec<CertificateDer<'static>>, rustls::pki_types::pem::Error> {
    CertificateDer::pem_file_iter(file)?.collect()
}

/// Decodes a value of a URL's query. A plus sign stays a plus sign, unlike in the values of HTML forms.
fn decoded(value: &str) -> String {
    let pair = format!("={}", value.replace('+', "%2B"));
    form_urlencoded::parse(pair.as_bytes()).next().map_or_else(String::new, |(_, value)| value.into_owned())
}

fn client_config(roots: Option<RootCertStore>, check_name: bool) -> Result<ClientConfig, Box<dyn std::error::Error>> {
    let provider = Arc::new(ring::default_provider());
    let algorithms = provider.signature_verification_algorithms;
    let issuer = match roots {
        Some(roots) => Some(WebPkiServerVerifier::builder_with_provider(roots.into(), provider.clone()).build()?),
        None => None,
    };
    let verifier = Verifier { issuer, check_name, algorithms };
    let config = ClientConfig::builder_with_provider(provider).with_safe_default_protocol_versions()?;
    Ok(config.dangerous().with_custom_certificate_verifier(Arc::new(verifier)).with_no_client_auth())
}

/// Checks that the server has the key of its certificate, who issued the certificate (unless
/// `issuer` is `None`), and its host name (if `check_name` is true).
#[derive(Debug)]
struct Verifier {
    issuer: Option<Arc<WebPkiServerVerifier>>,
    check_name: bool,
    algorithms: WebPkiSupportedAlgorithms,
}

impl ServerCertVerifier for Verifier {
    fn verify_server_cert(
        &self,
        certificate: &CertificateDer<'_>,
        intermediates: &[CertificateDer<'_>],
        name: &ServerName<'_>,
        ocsp_response: &[u8],
        now: UnixTime,
    ) -> Result<ServerCertVerified, rustls::Error> {
        use CertificateError::{NotValidForName, NotValidForNameContext};
        let Some(issuer) = &self.issuer else { return Ok(ServerCertVerified::assertion()) };
        match issuer.verify_server_cert(certificate, intermediates, name, ocsp_response, now) {
            // The name is checked last, so everything else about the certificate is right.
            Err(rustls::Error::InvalidCertificate(NotValidForName | NotValidForNameContext { .. }))
                if !self.check_name =>
            {
                Ok(ServerCertVerified::assertion())
            }
            verified => verified,
        }
    }

    fn verify_tls12_signature(
        &self,
        message: &[u8],
        certificate: &CertificateDer<'_>,
        signed: &DigitallySignedStruct,
    ) -> Result<HandshakeSignatureValid, rustls::Error> {
        verify_tls12_signature(message, certificate, signed, &self.algorithms)
    }

    fn verify_tls13_signature(
        &self,
        message: &[u8],
        certificate: &CertificateDer<'_>,
        signed: &DigitallySignedStruct,
    ) -> Result<HandshakeSignatureValid, rustls::Error> {
        verify_tls13_signature(message, certificate, signed, &self.algorithms)
    }

    fn supported_verify_schemes(&self) -> Vec<SignatureScheme> {
        self.algorithms.supported_schemes()
    }
}

pub(super) type BoxError = Box<dyn std::error::Error + Sync + Send>;

/// The two sides do not agree on encryption, so a further attempt would fail too.
#[derive(Debug, thiserror::Error)]
#[error("{0}; see sslmode and sslrootcert")]
pub(super) struct Disagreement(String);

/// Encrypts connections to the server.
#[derive(Clone)]
pub(super) struct Connector(TlsConnector);

impl std::fmt::Debug for Connector {
    fn fmt(&self, formatter: &mut std::fmt::Formatter<'_>) -> std::fmt::Result {
        formatter.write_str("Connector")
    }
}

/// Encrypts one connection to a host.
pub(super) struct ToHost {
    connector: TlsConnector,
    host: String,
}

impl<S: AsyncRead + AsyncWrite + Unpin + Send + 'static> MakeTlsConnect<S> for Connector {
    type Stream = Encrypted<S>;
    type TlsConnect = ToHost;
    type Error = BoxError;

    fn make_tls_connect(&mut self, host: &str) -> Result<ToHost, BoxError> {
        Ok(ToHost { connector: self.0.clone(), host: host.into() })
    }
}

impl<S: AsyncRead + AsyncWrite + Unpin + Send + 'static> TlsConnect<S> for ToHost {
    type Stream = Encrypted<S>;
    type Error = BoxError;
    type Future = Pin<Box<dyn Future<Output = Result<Encrypted<S>, BoxError>> + Send>>;

    fn connect(self, stream: S) -> Self::Future {
        Box::pin(self.encrypt(stream))
    }
}

impl ToHost {
    async fn encrypt<S: AsyncRead + AsyncWrite + Unpin>(self, stream: S) -> Result<Encrypted<S>, BoxError> {
        let name = ServerName::try_from(self.host).map_err(|error| Disagreement(error.to_string()))?;
        match self.connector.connect(name, stream).await {
            Ok(stream) => Ok(Encrypted(stream)),
            // Only an error of TLS itself is a disagreement. All other errors come from the network.
            Err(error) if error.get_ref().is_some_and(|inner| inner.is::<rustls::Error>()) => {
                Err(Disagreement(error.to_string()).into())
            }
            Err(error) => Err(error.into()),
        }
    }
}

/// An encrypted connection.
pub(super) struct Encrypted<S>(tokio_rustls::client::TlsStream<S>);

impl<S: AsyncRead + AsyncWrite + Unpin> TlsStream for Encrypted<S> {
    fn channel_binding(&self) -> ChannelBinding {
        ChannelBinding::none()
    }
}

impl<S: AsyncRead + AsyncWrite + Unpin> AsyncRead for Encrypted<S> {
    fn poll_read(
        mut self: Pin<&mut Self>,
        context: &mut Context<'_>,
        buffer: &mut ReadBuf<'_>,
    ) -> Poll<io::Result<()>> {
        Pin::new(&mut self.0).poll_read(context, buffer)
    }
}

impl<S: AsyncRead + AsyncWrite + Unpin> AsyncWrite for Encrypted<S> {
    fn poll_write(mut self: Pin<&mut Self>, context: &mut Context<'_>, bytes: &[u8]) -> Poll<io::Result<usize>> {
        Pin::new(&mut self.0).poll_write(context, bytes)
    }

    fn poll_flush(mut self: Pin<&mut Self>, context: &mut Context<'_>) -> Poll<io::Result<()>> {
        Pin::new(&mut self.0).poll_flush(context)
    }

    fn poll_shutdown(mut self: Pin<&mut Self>, context: &mut Context<'_>) -> Poll<io::Result<()>> {
        Pin::new(&mut self.0).poll_shutdown(context)
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn parameters(mode: Option<&str>, roots: Option<&str>) -> Parameters {
        Parameters { mode: mode.map(str::to_owned), roots: roots.map(str::to_owned) }
    }

    #[test]
    fn the_parameters_of_tls_are_taken_out_of_the_url() {
        for (url, rest, mode, roots) in [
            ("postgres://me@db/x", "postgres://me@db/x", None, None),
            ("postgres://me@db/x?sslmode=require", "postgres://me@db/x", Some("require"), None),
            (
                "postgres://me@db/x?a=b&sslrootcert=%2Fetc%2Fmy+ca.pem&c=d&sslmode=verify-ca",
                "postgres://me@db/x?a=b&c=d",
                Some("verify-ca"),
                Some("/etc/my+ca.pem"),
            ),
        ] {
            assert_eq!(Parameters::split(url), (rest.into(), parameters(mode, roots)), "{url}");
        }
    }

    #[test]
    fn an_error_message_names_the_wrong_parameter() {
        for (mode, roots, named) in [
            (Some("allow"), None, "sslmode must be one of disable, prefer"),
            (Some("require"), Some(SYSTEM), "sslrootcert=system needs sslmode=verify-full"),
            (Some("require"), Some("/no/such/file.pem"), "sslrootcert /no/such/file.pem"),
            (Some("verify-full"), Some(concat!(env!("CARGO_MANIFEST_DIR"), "/Cargo.toml")), "has no certificate"),
        ] {
            let refused = parameters(mode, roots).connector().map(|_| ()).unwrap_err();
            assert!(refused.contains(named), "{refused}");
        }
        assert!(matches!(
            parameters(Some("disable"), Some("/no/such/file.pem")).connector(),
            Ok((SslMode::Disable, None))
        ));
    }
}
