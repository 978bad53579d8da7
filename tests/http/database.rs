//! PostgreSQL over TLS, and the start of the server while the database cannot be used.

use crate::app::{MINIMAL, TestApp, binary, small_film};
use crate::hold::until;
use crate::postgres::Postgres;
use rcgen::{BasicConstraints, CertificateParams, CertifiedIssuer, IsCa, KeyPair};
use std::fmt::Write as _;
use std::fs;
use std::os::unix::fs::PermissionsExt;
use std::path::Path;
use std::process::Stdio;
use std::time::Duration;
use tempfile::TempDir;
use tokio::io::{AsyncBufReadExt, BufReader};

/// Time that is longer than any step takes, so that only a defect exceeds it.
const TOO_LONG: Duration = Duration::from_secs(60);
/// Host name in the server's certificate.
const HOST: &str = "db.example";
const PASSWORD: &str = "correct-horse";
const SCRAM: &str = "host all all 127.0.0.0/8 scram-sha-256";

/// Returns a loopback address that no other test process uses, so that the servers of all processes can have the usual
/// port.
fn address(number: u8) -> String {
    let [.., high, middle, low] = std::process::id().to_be_bytes();
    format!("127.{}.{middle}.{low}", 64 + 16 * number + high % 16)
}

/// A PostgreSQL server that listens on `address`, with users who have the same password.
struct Server {
    postgres: Postgres,
    address: String,
    /// `root.pem` has the authority that signed the server's certificate, and `other.pem` another one.
    roots: TempDir,
}

impl Server {
    /// Starts a server with these lines of `pg_hba.conf` for connections over TCP. Returns `None`
    /// if this machine has no PostgreSQL.
    async fn start(number: u8, with_tls: bool, lines: &str) -> Option<Self> {
        let (address, roots) = (address(number), tempfile::tempdir().unwrap());
        let postgres = Postgres::start_with(|folder| {
            fs::write(folder.join("pg_hba.conf"), format!("local all all trust\n{lines}\n")).unwrap();
            let mut arguments = format!("-c listen_addresses={address} -c hba_file={}/pg_hba.conf", folder.display());
            if with_tls {
                write_certificates(folder, roots.path());
                let folder = folder.display();
                write!(arguments, " -c ssl=on -c ssl_cert_file={folder}/cert.pem -c ssl_key_file={folder}/key.pem")
                    .unwrap();
            }
            arguments
        })?;
        let roles = ["anyone", "encrypted_only", "plain_only"];
        let roles = roles.map(|role| format!("CREATE ROLE {role} SUPERUSER LOGIN PASSWORD '{PASSWORD}';")).concat();
        postgres.execute(&roles).await;
        postgres.execute("CREATE DATABASE plateau").await;
        Some(Self { postgres, address, roots })
    }

    fn url(&self, user: &str, host: &str, parameters: &str) -> String {
        let parameters = parameters.replace("ROOTS", &self.roots.path().display().to_string());
        format!("postgres://{user}@{host}/plateau?hostaddr={}{parameters}", self.address)
    }
}

/// Writes a certificate for [`HOST`] with its key into the server's folder, and the certificates of
/// its authority and of another one into `roots`.
fn write_certificates(folder: &Path, roots: &Path) {
    let authority = || {
        let mut params = CertificateParams::default();
        params.is_ca = IsCa::Ca(BasicConstraints::Unconstrained);
        CertifiedIssuer::self_signed(params, KeyPair::generate().unwrap()).unwrap()
    };
    let (issuer, other) = (authority(), authority());
    let key = KeyPair::generate().unwrap();
    let certificate = CertificateParams::new([HOST.to_owned()]).unwrap().signed_by(&key, &issuer).unwrap();
    fs::write(folder.join("cert.pem"), certificate.pem()).unwrap();
    fs::write(folder.join("key.pem"), key.serialize_pem()).unwrap();
    fs::set_permissions(folder.join("key.pem"), fs::Permissions::from_mode(0o600)).unwrap();
    fs::write(roots.join("root.pem"), issuer.as_ref().pem()).unwrap();
    fs::write(roots.join("other.pem"), other.as_ref().pem()).unwrap();
}

/// Starts Plateau on a database that it cannot use, and returns what it said. It must end with
/// `status` without a second try.
async fn refused(url: &str, password: &str, status: i32) -> String {
    let folder = tempfile::tempdir().unwrap();
    let mut command = binary();
    command.args(["--listen", "127.0.0.1:0", "--database", url, "--data"]).arg(folder.path());
    command.env("PGPASSWORD", password).env("PLATEAU_LOG__LEVEL", "trace");
    let run = tokio::time::timeout(TOO_LONG, command.output()).await.expect("the program ends").unwrap();
    let text = String::from_utf8_lossy(&[run.stdout, run.stderr].concat()).into_owned();
    assert_eq!(run.status.code(), Some(status), "{url}: {text}");
    assert!(!text.contains("waiting for the database") && !text.contains("listening"), "{url}: {text}");
    assert!(status == 1 || text.contains("plateau: store.database"), "{url}: {text}");
    assert!(!text.contains(password), "{url}: the password is in {text}");
    text
}

#[tokio::test]
async fn connections_to_postgresql_are_encrypted_as_sslmode_says() {
    let lines = format!("hostnossl all encrypted_only all reject\nhostssl all plain_only all reject\n{SCRAM}");
    let Some(server) = Server::start(0, true, &lines).await else { return };
    let accepted = [
        ("anyone", HOST, "", true),
        ("anyone", HOST, "&sslmode=disable", false),
        ("anyone", "other.example", "&sslmode=prefer", true),
        // The server lets this user in only without encryption.
        ("plain_only", HOST, "", false),
        ("anyone", "other.example", "&sslmode=require", true),
        ("anyone", "other.example", "&sslmode=require&sslrootcert=ROOTS/root.pem", true),
        ("anyone", "other.example", "&sslmode=verify-ca&sslrootcert=ROOTS/root.pem", true),
        ("encrypted_only", HOST, "&sslmode=verify-full&sslrootcert=ROOTS/root.pem", true),
    ];
    for (user, host, parameters, encrypted) in accepted {
        let url = server.url(user, host, parameters);
        let app = TestApp::start_with(&[("PLATEAU_DATABASE", &url), ("PGPASSWORD", PASSWORD)]).await;
        app.solve(MINIMAL, &small_film(0.1)).await;
        let connections = "SELECT DISTINCT ssl FROM pg_stat_ssl JOIN pg_stat_activity USING (pid) \
                           WHERE application_name = 'plateau'";
        assert_eq!(server.postgres.execute(connections).await, [if encrypted { "t" } else { "f" }], "{url}");
        app.kill().await;
        // The database takes a moment to notice that the connections are closed.
        until("no connection is left", async || server.postgres.execute(connections).await.is_empty()).await;
    }
    let refusals = [
        ("anyone", HOST, "&sslmode=require&sslrootcert=ROOTS/other.pem", "invalid peer certificate"),
        ("anyone", HOST, "&sslmode=verify-ca&sslrootcert=ROOTS/other.pem", "invalid peer certificate"),
        ("anyone", HOST, "&sslmode=verify-full&sslrootcert=ROOTS/other.pem", "invalid peer certificate"),
        ("anyone", "other.example", "&sslmode=verify-full&sslrootcert=ROOTS/root.pem", "not valid for name"),
        ("anyone", HOST, "&sslmode=verify-full", "sslrootcert"),
        ("anyone", HOST, "&sslmode=verify-full&sslrootcert=ROOTS/none.pem", "sslrootcert"),
        ("anyone", HOST, "&sslmode=full", "sslmode"),
        ("encrypted_only", HOST, "&sslmode=disable", "no encryption"),
        ("plain_only", HOST, "&sslmode=require", "pg_hba.conf"),
    ];
    for (user, host, parameters, named) in refusals {
        let url = server.url(user, host, parameters);
        let text = refused(&url, PASSWORD, 2).await;
        assert!(text.contains(named), "{url}: {named} is not in {text}");
    }
}

#[tokio::test]
async fn a_database_that_refuses_the_settings_ends_the_start_at_once() {
    let Some(server) = Server::start(1, false, SCRAM).await else { return };
    let there = |parameters: &str| server.url("anyone", HOST, parameters);
    let elsewhere = there("").replace("/plateau?", "/nowhere?");
    for (url, password, named) in [
        (there(""), "wrong-horse", "password authentication failed"),
        (there("").replace("anyone@", "anyone:wrong-horse@"), "wrong-horse", "password authentication failed"),
        (there("&password=wrong-horse"), "wrong-horse", "password authentication failed"),
        (there("").replace("anyone@", "nobody@"), PASSWORD, "password authentication failed"),
        (elsewhere, PASSWORD, "database \"nowhere\" does not exist"),
        (there("&sslmode=require"), PASSWORD, "server does not support TLS"),
    ] {
        let text = refused(&url, password, 2).await;
        assert!(text.contains(named), "{url}: {named} is not in {text}");
    }
    // The settings are right, but this user may not create tables.
    server.postgres.execute(&format!("CREATE ROLE powerless LOGIN PASSWORD '{PASSWORD}'")).await;
    let text = refused(&there("").replace("anyone@", "powerless@"), PASSWORD, 1).await;
    assert!(text.contains("permission denied for schema public"), "{text}");
}

#[tokio::test]
async fn a_database_that_is_not_up_yet_is_waited_for() {
    let Some(server) = Server::start(2, true, SCRAM).await else { return };
    server.postgres.stop();
    let folder = tempfile::tempdir().unwrap();
    let mut command = binary();
    let url = server.url("anyone", HOST, "&sslmode=verify-full&sslrootcert=ROOTS/root.pem");
    command.args(["--listen", "127.0.0.1:0", "--database", &url, "--data"]).arg(folder.path());
    command.env("PGPASSWORD", PASSWORD).env("PLATEAU_LOG__LEVEL", "warn");
    let mut child = command.stdout(Stdio::piped()).stderr(Stdio::piped()).spawn().unwrap();
    let mut log = BufReader::new(child.stderr.take().unwrap()).lines();
    let waiting = tokio::time::timeout(TOO_LONG, log.next_line()).await.expect("a line of the log").unwrap().unwrap();
    assert!(waiting.contains("waiting for the database") && !waiting.contains(PASSWORD), "{waiting}");
    server.postgres.start_again();
    let mut output = BufReader::new(child.stdout.take().unwrap()).lines();
    let line = tokio::time::timeout(TOO_LONG, output.next_line()).await.expect("the server starts").unwrap().unwrap();
    assert!(line.starts_with("listening on "), "{line}");
    child.kill().await.unwrap();
}
