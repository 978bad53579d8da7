//! Sessions with a PostgreSQL server: the connection with its limits and its encryption, and the statements that are
//! prepared on it.

use std::borrow::Cow;
use std::collections::HashMap;
use std::error::Error as _;
use std::path::PathBuf;
use std::str::FromStr;
use std::time::Duration;

use futures_util::stream::{StreamExt, poll_fn};
use tokio::io::{AsyncRead, AsyncWrite};
use tokio::runtime::{Builder, Runtime};
use tokio::sync::mpsc::{UnboundedReceiver, UnboundedSender, unbounded_channel};
use tokio::time::timeout;
use tokio_postgres::config::{Host, SslMode};
use tokio_postgres::error::SqlState;
use tokio_postgres::tls::MakeTlsConnect;
use tokio_postgres::types::private::BytesMut;
use tokio_postgres::types::{IsNull, ToSql, Type, to_sql_checked};
use tokio_postgres::{AsyncMessage, Client, Config, NoTls, Socket, Statement};

use super::tls::{BoxError, Connector, Disagreement, Parameters};
use super::value::Value;

use super::{Result, StoreError};
pub(super) use tokio_postgres::Row;
pub(super) use tokio_postgres::types::FromSql;

/// Time limit for getting a free connection, and for opening a connection to the server.
pub(super) const PATIENCE: Duration = Duration::from_secs(5);
/// Two time limits that the server enforces: for a statement, and for a transaction whose client is silent. The second
/// one frees the rows that a client behind a broken network has locked.
const SESSION_OPTIONS: &str = "-c statement_timeout=8s -c idle_in_transaction_session_timeout=8s";
/// Time limit for the answer to a statement. The server's own limit is shorter, so that only a broken network or server
/// reaches this one. A lease of 15 s, the default, is renewed every 5 s: a renewal whose connection is silent fails
/// early enough to be repeated before the lease ends.
pub(super) const STATEMENT_LIMIT: Duration = Duration::from_secs(9);
/// Time after which the operating system gives up a connection whose data the server's machine does not acknowledge.
const UNACKNOWLEDGED_LIMIT: Duration = Duration::from_secs(9);
/// Time without traffic after which the operating system asks the server's machine for a sign of life, and the interval
/// and number of further questions.
const KEEPALIVE_IDLE: Duration = Duration::from_secs(10);
const KEEPALIVE_INTERVAL: Duration = Duration::from_secs(3);
const KEEPALIVE_RETRIES: u32 = 3;

/// Address of a server, with the settings for connecting to it.
#[derive(Clone, Debug)]
pub(super) struct Server {
    config: Config,
    /// Encrypts the connections. `None` if they are never encrypted.
    encryption: Option<Connector>,
}

impl Server {
    pub(super) fn at(url: &str) -> Result<Self> {
        let (url, tls) = Parameters::split(url);
        let mut config = config(&url)?;
        // Connections by a socket in the file system are plain, as libpq's are.
        if config.get_hosts().iter().all(|host| matches!(host, Host::Unix(_))) {
            config.ssl_mode(SslMode::Disable);
            return Ok(Self { config, encryption: None });
        }
        let (mode, encryption) = tls.connector().map_err(StoreError::Url)?;
        config.ssl_mode(mode);
        Ok(Self { config, encryption })
    }

    async fn connect(&self) -> Result<(Client, UnboundedReceiver<String>)> {
        let Some(encryption) = &self.encryption else { return connect(&self.config, NoTls).await.map_err(refusal) };
        match connect(&self.config, encryption.clone()).await {
            // The server offers TLS, but it does not work, or the server lets this user in only without it. `prefer`
            // then means a plain connection, as it does to libpq.
            Err(error) if self.config.get_ssl_mode() == SslMode::Prefer && needs_plain(&error) => {
                connect(self.config.clone().ssl_mode(SslMode::Disable), NoTls).await
            }
            connected => connected,
        }
        .map_err(refusal)
    }
}

/// Connects, and starts the task that drives the connection. Returns the client and the receiver of notifications.
async fn connect<T>(
    config: &Config,
    tls: T,
) -> std::result::Result<(Client, UnboundedReceiver<String>), tokio_postgres::Error>
where
    T: MakeTlsConnect<Socket>,
    T::Stream: Send + 'static,
{
    let (client, connection) = config.connect(tls).await?;
    let (sender, notifications) = unbounded_channel();
    tokio::spawn(carry(connection, sender));
    Ok((client, notifications))
}

/// Drives a connection until it ends, and passes its notifications on.
async fn carry<S>(mut connection: tokio_postgres::Connection<Socket, S>, notifications: UnboundedSender<String>)
where
    S: AsyncRead + AsyncWrite + Unpin,
{
    let mut messages = poll_fn(|context| connection.poll_message(context));
    // Every statement gets the error with which a connection ends, so it is not reported here.
    while let Some(Ok(message)) = messages.next().await {
        if let AsyncMessage::Notification(notification) = message {
            // Only the listening connection has a receiver that reads.
            let _ = notifications.send(notification.payload().to_owned());
        }
    }
}

fn needs_plain(error: &tokio_postgres::Error) -> bool {
    error.code() == Some(&SqlState::INVALID_AUTHORIZATION_SPECIFICATION)
        || error.source().is_some_and(|source| source.is::<Disagreement>())
}

/// Converts the error of an attempt to connect. An error that a later attempt would meet again becomes
/// `StoreError::Refused`.
fn refusal(error: tokio_postgres::Error) -> StoreError {
    match StoreError::from(error) {
        StoreError::Internal(text) => StoreError::Refused(text),
        other => other,
    }
}

/// An open connection. It reads and writes only while one of its statements or a notification is awaited. Dropping it
/// closes it without waiting for the server.
pub(super) struct Connection {
    /// Runs the task that drives the connection.
    pub(super) runtime: Runtime,
    client: Client,
    pub(super) notifications: UnboundedReceiver<String>,
}

impl Connection {
    pub(super) fn open(server: &Server) -> Result<Self> {
        let runtime = Builder::new_current_thread().enable_all().build()?;
        let opening = runtime.block_on(async { timeout(PATIENCE, server.connect()).await });
        let (client, notifications) = opening.map_err(|_| silent(PATIENCE))??;
        Ok(Self { runtime, client, notifications })
    }

    /// Runs one exchange with the server, which must answer within `limit`.
    pub(super) fn run<T>(
        &self,
        limit: Duration,
        exchange: impl AsyncFnOnce(&Client) -> std::result::Result<T, tokio_postgres::Error>,
    ) -> Result<T> {
        let answer = self.runtime.block_on(async { timeout(limit, exchange(&self.client)).await });
        Ok(answer.map_err(|_| silent(limit))??)
    }
}

fn silent(limit: Duration) -> StoreError {
    StoreError::Unavailable(format!("the server did not answer for {} s", limit.as_secs()))
}

/// A connection that opens at its first use, and opens again after a break.
pub(super) struct Session {
    server: Server,
    pub(super) connection: Option<Connection>,
    /// Prepared statements of this connection, by their text.
    statements: HashMap<String, Statement>,
    /// Time limit for the answer to a statement.
    pub(super) limit: Duration,
    /// True while a transaction is open. Its statements must not run on another connection.
    pub(super) in_transaction: bool,
}

impl std::fmt::Debug for Session {
    fn fmt(&self, formatter: &mut std::fmt::Formatter<'_>) -> std::fmt::Result {
        formatter.debug_struct("Session").field("connected", &self.connection.is_some()).finish_non_exhaustive()
    }
}

impl Session {
    pub(super) fn new(server: Server) -> Self {
        Self { server, connection: None, statements: HashMap::new(), limit: STATEMENT_LIMIT, in_transaction: false }
    }

    /// Runs one exchange with the server. A connection that did not answer in time is closed, because the late answer
    /// would be taken for the answer to the next statement.
    fn run<T>(
        &mut self,
        exchange: impl AsyncFnOnce(&Client) -> std::result::Result<T, tokio_postgres::Error>,
    ) -> Result<T> {
        let connection = match &mut self.connection {
            Some(connection) => connection,
            None if self.in_transaction => {
                return Err(StoreError::Unavailable("the connection of this transaction is closed".into()));
            }
            none => {
                self.statements.clear();
                none.insert(Connection::open(&self.server)?)
            }
        };
        let mut in_time = false;
        let ran = connection.run(self.limit, async |client| {
            let ran = exchange(client).await;
            in_time = true;
            ran
        });
        if !in_time {
            self.connection = None;
        }
        ran
    }

    /// Closes the connection if it is broken, so that the next statement opens another one. Callers use this only after
    /// an error, because the check sends a message to the server.
    pub(super) fn drop_broken(&mut self) {
        if self.connection.is_some() && self.run(async |client| client.check_connection().await).is_err() {
            self.connection = None;
        }
    }

    pub(super) fn script(&mut self, text: &str) -> Result<()> {
        self.run(async |client| client.batch_execute(text).await)
    }

    pub(super) fn rows(&mut self, text: &str, values: &[Value<'_>]) -> Result<Vec<Row>> {
        let statement = self.prepared(text, values)?;
        self.run(async |client| client.query(&statement, &parameters(values)).await)
    }

    pub(super) fn execute(&mut self, text: &str, values: &[Value<'_>]) -> Result<u64> {
        let statement = self.prepared(text, values)?;
        self.run(async |client| client.execute(&statement, &parameters(values)).await)
    }

    fn prepared(&mut self, text: &str, values: &[Value<'_>]) -> Result<Statement> {
        if self.connection.is_some()
            && let Some(statement) = self.statements.get(text)
        {
            return Ok(statement.clone());
        }
        let types: Vec<Type> = values.iter().map(Value::postgres_type).collect();
        let statement = self.run(async |client| client.prepare_typed(text, &types).await)?;
        self.statements.insert(text.to_owned(), statement.clone());
        Ok(statement)
    }
}

impl Value<'_> {
    fn postgres_type(&self) -> Type {
        match self {
            Self::Int(_) => Type::INT8,
            Self::Text(_) => Type::TEXT,
            Self::Bytes(_) => Type::BYTEA,
        }
    }
}

impl ToSql for Value<'_> {
    fn to_sql(&self, as_type: &Type, out: &mut BytesMut) -> std::result::Result<IsNull, BoxError> {
        match self {
            Self::Int(value) => value.to_sql(as_type, out),
            Self::Text(value) => value.to_sql(as_type, out),
            Self::Bytes(value) => value.to_sql(as_type, out),
        }
    }

    fn accepts(_: &Type) -> bool {
        // Statements are prepared with the types of their values, so every type fits.
        true
    }

    to_sql_checked!();
}

fn parameters<'v>(values: &'v [Value<'_>]) -> Vec<&'v (dyn ToSql + Sync)> {
    values.iter().map(|value| value as &(dyn ToSql + Sync)).collect()
}

impl From<tokio_postgres::Error> for StoreError {
    fn from(error: tokio_postgres::Error) -> Self {
        let text = match error.source() {
            Some(source) => format!("{error}: {source}"),
            None => error.to_string(),
        };
        match error.code().map(SqlState::code) {
            // 53100 is disk_full.
            Some("53100") => Self::NoSpace(text),
            // 40001 is serialization_failure, 40P01 is deadlock_detected, and 23505 is unique_violation.
            Some("40001" | "40P01" | "23505") => Self::Contended(text),
            // 25006 is read_only_sql_transaction, the answer of a standby server or of a database that was made
            // read-only.
            Some("25006") => Self::Unavailable(text),
            // These classes are connection exceptions, insufficient resources, operator intervention, system errors and
            // damaged data.
            Some(code) if ["08", "53", "57", "58", "XX"].contains(&code.get(..2).unwrap_or_default()) => {
                Self::Unavailable(text)
            }
            Some(_) => Self::Internal(text),
            None if error.is_closed() || error.source().is_none_or(|source| source.is::<std::io::Error>()) => {
                Self::Unavailable(text)
            }
            None => Self::Internal(text),
        }
    }
}

/// Reads the connection settings from the URL. As in other PostgreSQL clients, the parameter `host` overrides the host
/// before the path. A password that is not in the URL comes from `PGPASSWORD` or from the file `PGPASSFILE`
/// (`~/.pgpass`).
fn config(url: &str) -> Result<Config> {
    let unusable = |error: tokio_postgres::Error| {
        StoreError::Url(error.source().map_or_else(|| error.to_string(), ToString::to_string))
    };
    let mut config = Config::from_str(&with_one_host(url)).map_err(unusable)?;
    if config.get_user().is_none() {
        let user = std::env::var("PGUSER").or_else(|_| std::env::var("USER"));
        config.user(user.as_deref().unwrap_or("postgres"));
    }
    if config.get_password().is_none() {
        let password = std::env::var("PGPASSWORD").ok().or_else(|| stored_password(&config));
        password.map(|password| config.password(password));
    }
    let options = config.get_options().map_or(SESSION_OPTIONS.into(), |own| format!("{SESSION_OPTIONS} {own}"));
    config.application_name("plateau").options(&options).connect_timeout(PATIENCE);
    config.tcp_user_timeout(UNACKNOWLEDGED_LIMIT).keepalives_idle(KEEPALIVE_IDLE);
    config.keepalives_interval(KEEPALIVE_INTERVAL).keepalives_retries(KEEPALIVE_RETRIES);
    Ok(config)
}

/// Removes the host before the path from the URL if a parameter names another host.
fn with_one_host(url: &str) -> Cow<'_, str> {
    let Some((scheme, rest)) = url.split_once("://") else { return Cow::Borrowed(url) };
    let Some((path, query)) = rest.split_once('?') else { return Cow::Borrowed(url) };
    if !query.split('&').any(|parameter| parameter.starts_with("host=")) {
        return Cow::Borrowed(url);
    }
    let (authority, database) = path.split_once('/').unwrap_or((path, ""));
    let (user, host) = authority.rsplit_once('@').map_or((None, authority), |(user, host)| (Some(user), host));
    let user = user.map(|user| format!("{user}@")).unwrap_or_default();
    // An IPv6 address without a port ends with a bracket.
    let is_port = |port: &&str| !port.ends_with(']') && !query.contains("port=");
    let port = host.rsplit_once(':').map(|(_, port)| port).filter(is_port);
    let port = port.map(|port| format!("&port={port}")).unwrap_or_default();
    Cow::Owned(format!("{scheme}://{user}/{database}?{query}{port}"))
}

/// Returns the password for this server from the password file, or `None` if the file has none.
fn stored_password(config: &Config) -> Option<String> {
    let home = || Some(PathBuf::from(std::env::var_os("HOME")?).join(".pgpass"));
    let file = std::env::var_os("PGPASSFILE").map(PathBuf::from).or_else(home)?;
    let text = std::fs::read_to_string(file).ok()?;
    let host = match config.get_hosts().first() {
        Some(Host::Tcp(name)) => name.clone(),
        Some(Host::Unix(_)) | None => "localhost".into(),
    };
    let port = config.get_ports().first().copied().unwrap_or(5432).to_string();
    let user = config.get_user().unwrap_or_default();
    password_for(&text, [&host, &port, config.get_dbname().unwrap_or(user), user])
}

/// Returns the last field of the first line `host:port:database:user:password` that matches. A field `*` matches
/// everything, and a backslash makes the following colon or backslash an ordinary character.
fn password_for(text: &str, wanted: [&str; 4]) -> Option<String> {
    text.lines().filter(|line| !line.starts_with('#')).find_map(|line| {
        let (mut fields, mut characters) = (vec![String::new()], line.chars());
        while let Some(character) = characters.next() {
            if character == ':' && fields.len() < 5 {
                fields.push(String::new());
            } else if let Some(field) = fields.last_mut() {
                field.push(if character == '\\' { characters.next()? } else { character });
            }
        }
        let password = fields.pop().filter(|_| fields.len() == wanted.len())?;
        fields.iter().zip(wanted).all(|(field, wanted)| field == "*" || field == wanted).then_some(password)
    })
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_host_parameter_overrides_the_host_before_the_path() {
        for (url, host, port) in [
            ("postgres://me@db/plateau", Host::Tcp("db".into()), Some(5432)),
            ("postgres://me@db:6000/plateau", Host::Tcp("db".into()), Some(6000)),
            ("postgres://me@localhost/plateau?host=/run/pg", Host::Unix("/run/pg".into()), None),
            ("postgres://me@localhost:6000/plateau?host=%2Frun%2Fpg", Host::Unix("/run/pg".into()), Some(6000)),
            ("postgres://me@[::1]/plateau?host=/run/pg", Host::Unix("/run/pg".into()), None),
            ("postgres://me@[::1]:6000/plateau?host=/run/pg", Host::Unix("/run/pg".into()), Some(6000)),
            ("postgresql://me@a:1/plateau?port=2&host=b", Host::Tcp("b".into()), Some(2)),
        ] {
            let config = config(url).unwrap();
            assert_eq!((config.get_hosts(), config.get_ports().first().copied()), (&[host][..], port), "{url}");
            assert_eq!((config.get_user(), config.get_dbname()), (Some("me"), Some("plateau")), "{url}");
        }
        for url in ["postgres://me@db:x/plateau", "postgres://me@db/plateau?no_such=1"] {
            assert!(matches!(config(url), Err(StoreError::Url(_))), "{url}");
        }
    }

    #[test]
    fn the_password_comes_from_the_first_matching_line() {
        let text = "# db:5432:plateau:me:comment\ndb:5432:other:me:one\n\
            *:5432:plateau:me:t\\:w:o\\\\\n*:*:*:*:three\nshort:1\n";
        let password = |host, port, database, user| password_for(text, [host, port, database, user]);
        assert_eq!(password("db", "5432", "plateau", "me").as_deref(), Some("t:w:o\\"));
        assert_eq!(password("db", "5432", "other", "me").as_deref(), Some("one"));
        assert_eq!(password("db", "1", "other", "me").as_deref(), Some("three"));
        assert_eq!(password_for("db:1:a:b", ["db", "1", "a", "b"]), None);
    }
}
