//! PostgreSQL, shared by several machines. A few threads have a connection each, and one more listens for changes.

use std::sync::mpsc::{Receiver, RecvTimeoutError};
use std::time::{Duration, Instant};

use tokio::time::timeout;

use super::migrations::migrate;
use super::pool::Pool;
use super::session::{Connection, PATIENCE, STATEMENT_LIMIT, Server, Session};
use super::tx::{AfterCommit, Tx};
use super::{Result, StoreError, StoreOptions};

/// Maximum number of tries of a transaction that fails because of a deadlock, or because another transaction has just
/// inserted the same idempotency key.
const TRIES: usize = 5;
/// Time limit for each statement of a migration.
const MIGRATION_LIMIT: Duration = Duration::from_secs(600);
/// Interval at which the listening connection is tested. Without the test, a connection whose server no longer answers
/// would look like a connection without notifications.
const LISTEN_TEST_INTERVAL: Duration = Duration::from_secs(10);
const CHANNEL: &str = "plateau_changes";
const RECONNECT_DELAY: Duration = Duration::from_secs(1);
/// Interval at which the listening thread checks whether the store has been closed.
const LISTEN_STEP: Duration = Duration::from_millis(250);

#[derive(Debug)]
pub(super) struct Database {
    server: Server,
    sessions: Pool<Session>,
}

impl Database {
    /// Connects to `postgres://USER@HOST/DATABASE` and migrates its tables.
    pub(super) async fn open(url: &str, options: &StoreOptions) -> Result<Self> {
        let server = Server::at(url)?;
        let threads = options.connections.max(1) as usize;
        let session_server = server.clone();
        let open = move || Ok(Session::new(session_server.clone()));
        let sessions = Pool::start("postgres", threads, Some(PATIENCE), open)?;
        sessions.run(|session| session.migrate()).await?;
        Ok(Self { server, sessions })
    }

    /// Runs `work` in a transaction, and again if the transaction conflicts with another one.
    pub(super) async fn write<T: Send + 'static>(
        &self,
        work: impl Fn(&mut Tx<'_>) -> Result<T> + Send + 'static,
    ) -> Result<(T, AfterCommit)> {
        let transact = move |session: &mut Session| {
            let mut tries = 1;
            loop {
                match session.transact(&work) {
                    Err(StoreError::Contended(_)) if tries < TRIES => tries += 1,
                    result => return result,
                }
            }
        };
        self.sessions.run(transact).await
    }

    /// Runs `work`, which must only read.
    pub(super) async fn read<T: Send + 'static>(
        &self,
        work: impl Fn(&mut Tx<'_>) -> Result<T> + Send + 'static,
    ) -> Result<T> {
        self.sessions.run(move |session| session.read(&work)).await
    }

    /// Notifies every listening instance, including this one.
    pub(super) async fn notify(&self, payload: String) -> Result<()> {
        let text = "SELECT pg_notify($1, $2)";
        self.read(move |tx| tx.execute(text, &[CHANNEL.into(), payload.as_str().into()]).map(|_| ())).await
    }

    /// Starts a thread that listens for changes of all instances until the sender of `stopped` is dropped. It calls
    /// `heard` with every payload, and with `None` whenever notifications may have been lost.
    pub(super) fn listen(&self, stopped: Receiver<()>, heard: impl Fn(Option<&str>) + Send + 'static) -> Result<()> {
        let server = self.server.clone();
        let run = move || loop {
            if let Err(error) = listen_once(&server, &stopped, &heard) {
                tracing::warn!(%error, "cannot listen for changes; polling for them meanwhile");
            }
            if stopped.recv_timeout(RECONNECT_DELAY) == Err(RecvTimeoutError::Disconnected) {
                return;
            }
        };
        std::thread::Builder::new().name("postgres listener".into()).spawn(run)?;
        Ok(())
    }

    pub(super) async fn close(&self) {
        self.sessions.close().await;
    }
}

/// Listens until the connection breaks or the store is closed.
fn listen_once(server: &Server, stopped: &Receiver<()>, heard: &impl Fn(Option<&str>)) -> Result<()> {
    let mut connection = Connection::open(server)?;
    connection.run(STATEMENT_LIMIT, async |client| client.batch_execute(&format!("LISTEN {CHANNEL}")).await)?;
    // Notifications sent before this connection was opened are lost.
    heard(None);
    let mut tested_at = Instant::now();
    while stopped.recv_timeout(Duration::ZERO) != Err(RecvTimeoutError::Disconnected) {
        let Connection { runtime, notifications, .. } = &mut connection;
        match runtime.block_on(async { timeout(LISTEN_STEP, notifications.recv()).await }) {
            Ok(Some(payload)) => heard(Some(&payload)),
            Ok(None) => return Err(StoreError::Unavailable("the server closed the connection".into())),
            Err(_) if tested_at.elapsed() >= LISTEN_TEST_INTERVAL => {
                connection.run(STATEMENT_LIMIT, async |client| client.check_connection().await)?;
                tested_at = Instant::now();
            }
            Err(_) => {}
        }
    }
    Ok(())
}

impl Session {
    /// Migrates the tables. The time limit of a statement is longer meanwhile, because a new index over a long table
    /// takes longer than any other statement.
    fn migrate(&mut self) -> Result<()> {
        self.limit = MIGRATION_LIMIT;
        let migrated = self.transact(&|tx| {
            tx.script("SET LOCAL statement_timeout = 0")?;
            migrate(tx)
        });
        self.limit = STATEMENT_LIMIT;
        migrated.map(|((), _)| ())
    }

    fn transact<T>(&mut self, work: &impl Fn(&mut Tx<'_>) -> Result<T>) -> Result<(T, AfterCommit)> {
        if let Err(error) = self.script("BEGIN") {
            // The server may have closed the connection since the last statement, and nothing of this transaction has
            // happened.
            self.drop_broken();
            if self.connection.is_some() {
                return Err(error);
            }
            self.script("BEGIN")?;
        }
        self.in_transaction = true;
        let mut tx = Tx::postgres(self);
        let worked = work(&mut tx);
        let after_commit = tx.into_after_commit();
        let ended = worked.and_then(|value| self.script("COMMIT").map(|()| (value, after_commit)));
        if ended.is_err() && self.connection.is_some() && self.script("ROLLBACK").is_err() {
            // The server rolls back when the connection closes.
            self.connection = None;
        }
        self.in_transaction = false;
        ended
    }

    fn read<T>(&mut self, work: &impl Fn(&mut Tx<'_>) -> Result<T>) -> Result<T> {
        let read = work(&mut Tx::postgres(self));
        if read.is_err() {
            self.drop_broken();
            if self.connection.is_none() {
                return work(&mut Tx::postgres(self));
            }
        }
        read
    }
}
