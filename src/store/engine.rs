//! Opening either engine and running transactions on it.
//!
//! SQLite has one writer task: it takes whatever writes have queued up while the last commit was on its way to the disk
//! and commits them together (where one fails, all again, each inside a savepoint of its own), so that durability costs one disk
//! sync a group and not one a job. Readers have a pool of their own. PostgreSQL runs every write in a transaction from its pool and
//! repeats the ones that lost a race.

use std::str::FromStr;
use std::sync::atomic::{AtomicBool, Ordering};
use std::time::Duration;

use futures_util::future::BoxFuture;
use sqlx::migrate::{Migration, MigrationType, Migrator};
use sqlx::postgres::{PgConnectOptions, PgPoolOptions};
use sqlx::sqlite::{SqliteAutoVacuum, SqliteConnectOptions, SqliteJournalMode, SqlitePoolOptions, SqliteSynchronous};
use sqlx::{AssertSqlSafe, Connection as _, PgPool, SqlSafeStr, SqliteConnection, SqlitePool};
use tokio::sync::{mpsc, oneshot};

use super::sql::{Connection, Row, Value};
use super::{StoreError, StoreOptions};

pub(super) type Result<T> = std::result::Result<T, StoreError>;

/// Writes that share one commit at most.
const GROUP_SIZE: usize = 128;
/// Writes that may wait for the writer before callers wait for a place.
const WRITE_BACKLOG: usize = 1024;
/// The write-ahead log is cut back to this size when it has been copied into the database.
const WAL_KEPT_BYTES: &str = "67108864";
/// Pages in the write-ahead log after which it is copied into the database: pages of indexes that many jobs change are then
/// copied once.
const WAL_PAGES: &str = "2048";
const SQLITE_READERS: u32 = 4;
/// Pages that one `shrink` moves at most, so that it never holds up other writes for long.
const SHRINK_PAGES: u32 = 1000;
const BUSY_TIMEOUT: Duration = Duration::from_secs(10);
const CONNECT_TIMEOUT: Duration = Duration::from_secs(5);
/// Tries of a PostgreSQL transaction that loses a race (deadlock, or two equal idempotency keys at once).
const TRIES: usize = 5;

#[derive(Debug)]
pub(super) struct Engine {
    pub(super) kind: Kind,
    /// Whether the last write found no space.
    full: AtomicBool,
}

#[derive(Debug, Clone)]
pub(super) enum Kind {
    Sqlite { readers: SqlitePool, writer: mpsc::Sender<Write> },
    Postgres(PgPool),
}

impl Engine {
    pub(super) async fn open(url: &str, options: &StoreOptions) -> Result<Self> {
        Ok(Self { kind: Kind::open(url, options).await?, full: AtomicBool::new(false) })
    }

    pub(super) fn is_full(&self) -> bool {
        self.full.load(Ordering::Relaxed)
    }

    /// As [`Kind::write`], remembering whether there was space.
    pub(super) async fn write<T, F>(&self, work: F) -> Result<T>
    where
        T: Send + 'static,
        F: for<'a, 'c> Fn(&'a mut Connection<'c>) -> BoxFuture<'a, Result<T>> + Send + Sync + 'static,
    {
        let result = self.kind.write(work).await;
        match &result {
            Ok(_) => self.full.store(false, Ordering::Relaxed),
            Err(StoreError::NoSpace(_)) => self.full.store(true, Ordering::Relaxed),
            Err(_) => {}
        }
        result
    }

    pub(super) async fn rows(&self, text: &str, values: Vec<Value>) -> Result<Vec<Row>> {
        self.kind.rows(text, values).await
    }

    pub(super) async fn row(&self, text: &str, values: Vec<Value>) -> Result<Option<Row>> {
        Ok(self.rows(text, values).await?.into_iter().next())
    }

    pub(super) async fn shrink(&self) -> Result<()> {
        self.kind.shrink().await
    }

    pub(super) async fn close(&self) {
        self.kind.close().await;
    }
}

impl Kind {
    async fn open(url: &str, options: &StoreOptions) -> Result<Self> {
        if url.starts_with("postgres://") || url.starts_with("postgresql://") {
            Self::open_postgres(url, options).await
        } else if url.starts_with("sqlite:") {
            Self::open_sqlite(url, options).await
        } else {
            Err(StoreError::Url("expected sqlite://PATH or postgres://USER@HOST/DATABASE".into()))
        }
    }

    async fn open_sqlite(url: &str, options: &StoreOptions) -> Result<Self> {
        let base = SqliteConnectOptions::from_str(url)
            .map_err(|error| StoreError::Url(error.to_string()))?
            .busy_timeout(BUSY_TIMEOUT);
        let mut connection = SqliteConnection::connect_with(
            &base
                .clone()
                .create_if_missing(true)
                .auto_vacuum(SqliteAutoVacuum::Incremental)
                .journal_mode(SqliteJournalMode::Wal)
                .synchronous(SqliteSynchronous::Full)
                .pragma("journal_size_limit", WAL_KEPT_BYTES)
                .pragma("wal_autocheckpoint", WAL_PAGES),
        )
        .await?;
        if let Some(bytes) = options.max_bytes {
            // The engine refuses writes beyond this as on a full disk.
            let size: i64 = sqlx::query_scalar("PRAGMA page_size").fetch_one(&mut connection).await?;
            let pages = i64::try_from(bytes).unwrap_or(i64::MAX) / size.max(1);
            sqlx::query(AssertSqlSafe(format!("PRAGMA max_page_count = {pages}"))).execute(&mut connection).await?;
        }
        migrations().run(&mut connection).await.map_err(|error| StoreError::Migration(error.to_string()))?;
        let (writer, writes) = mpsc::channel(WRITE_BACKLOG);
        tokio::spawn(write_in_groups(connection, writes));
        let readers = SqlitePoolOptions::new().max_connections(SQLITE_READERS).connect_lazy_with(base.read_only(true));
        Ok(Self::Sqlite { readers, writer })
    }

    async fn open_postgres(url: &str, options: &StoreOptions) -> Result<Self> {
        let connect = PgConnectOptions::from_str(url)
            .map_err(|error| StoreError::Url(error.to_string()))?
            .application_name("plateau")
            .options([("statement_timeout", "60s"), ("idle_in_transaction_session_timeout", "60s")]);
        let pool = PgPoolOptions::new()
            .max_connections(options.connections)
            .acquire_timeout(CONNECT_TIMEOUT)
            .connect_with(connect)
            .await?;
        migrations().run(&pool).await.map_err(|error| StoreError::Migration(error.to_string()))?;
        Ok(Self::Postgres(pool))
    }

    /// Runs `work` in one transaction: all of it is durable when this returns `Ok`, none of it happened otherwise
    /// (but for a connection lost during the commit itself, which nobody can tell apart). `work` may run again after a
    /// lost race, so it must not act outside the database.
    async fn write<T, F>(&self, work: F) -> Result<T>
    where
        T: Send + 'static,
        F: for<'a, 'c> Fn(&'a mut Connection<'c>) -> BoxFuture<'a, Result<T>> + Send + Sync + 'static,
    {
        match self {
            Self::Sqlite { writer, .. } => {
                let (answer, answered) = oneshot::channel();
                writer
                    .send(Write::Run(Box::new(Pending { work, result: None, answer })))
                    .await
                    .map_err(|_| closed())?;
                answered.await.map_err(|_| closed())?
            }
            Self::Postgres(pool) => {
                let mut tries = 1;
                loop {
                    match transact(pool, &work).await {
                        Err(StoreError::Contended(_)) if tries < TRIES => tries += 1,
                        result => return result,
                    }
                }
            }
        }
    }

    /// Rows of a statement that only reads.
    async fn rows(&self, text: &str, values: Vec<Value>) -> Result<Vec<Row>> {
        Ok(match self {
            Self::Sqlite { readers, .. } => {
                Connection::Sqlite(&mut *readers.acquire().await?).rows(text, values).await?
            }
            Self::Postgres(pool) => Connection::Postgres(&mut *pool.acquire().await?).rows(text, values).await?,
        })
    }

    /// Gives pages that nothing uses any more back to the file system. PostgreSQL does so by itself.
    async fn shrink(&self) -> Result<()> {
        match self {
            Self::Sqlite { .. } => {
                let text = format!("PRAGMA incremental_vacuum({SHRINK_PAGES})");
                self.write(move |connection| {
                    let text = text.clone();
                    Box::pin(async move { Ok(connection.rows(&text, Vec::new()).await.map(|_| ())?) })
                })
                .await
            }
            Self::Postgres(_) => Ok(()),
        }
    }

    /// Waits for running statements and closes every connection. Writes afterwards fail as `Unavailable`.
    async fn close(&self) {
        match self {
            Self::Sqlite { readers, writer } => {
                let (answer, answered) = oneshot::channel();
                if writer.send(Write::Close(answer)).await.is_ok() {
                    // An error only says that the writer was gone already.
                    let _ = answered.await;
                }
                readers.close().await;
            }
            Self::Postgres(pool) => pool.close().await,
        }
    }
}

fn closed() -> StoreError {
    StoreError::Unavailable("the store is closed".into())
}

async fn transact<T, F>(pool: &PgPool, work: &F) -> Result<T>
where
    F: for<'a, 'c> Fn(&'a mut Connection<'c>) -> BoxFuture<'a, Result<T>> + Send + Sync,
{
    let mut transaction = pool.begin().await?;
    // Dropping the transaction after an error rolls it back.
    let value = work(&mut Connection::Postgres(&mut transaction)).await?;
    transaction.commit().await?;
    Ok(value)
}

pub(super) enum Write {
    Run(Box<dyn Run>),
    Close(oneshot::Sender<()>),
}

impl std::fmt::Debug for Write {
    fn fmt(&self, formatter: &mut std::fmt::Formatter<'_>) -> std::fmt::Result {
        formatter.write_str(match self {
            Self::Run(_) => "Run",
            Self::Close(_) => "Close",
        })
    }
}

/// One write in a group: first run, then answered once the group's commit is through or has failed.
pub(super) trait Run: Send {
    /// Whether the work succeeded and is to be kept.
    fn run<'a>(&'a mut self, connection: &'a mut Connection<'_>) -> BoxFuture<'a, Result<()>>;
    fn answer(self: Box<Self>, committed: Result<()>);
}

struct Pending<T, F> {
    work: F,
    result: Option<Result<T>>,
    answer: oneshot::Sender<Result<T>>,
}

impl<T, F> Run for Pending<T, F>
where
    T: Send,
    F: for<'a, 'c> Fn(&'a mut Connection<'c>) -> BoxFuture<'a, Result<T>> + Send + Sync,
{
    fn run<'a>(&'a mut self, connection: &'a mut Connection<'_>) -> BoxFuture<'a, Result<()>> {
        Box::pin(async move {
            let result = (self.work)(connection).await;
            let ended = result.as_ref().map(|_| ()).map_err(Clone::clone);
            self.result = Some(result);
            ended
        })
    }

    fn answer(self: Box<Self>, committed: Result<()>) {
        let result = match (self.result, committed) {
            (Some(Err(error)), _) | (_, Err(error)) => Err(error),
            (Some(Ok(value)), Ok(())) => Ok(value),
            (None, Ok(())) => Err(closed()),
        };
        // A caller that went away does not need its answer.
        let _ = self.answer.send(result);
    }
}

/// The writer task of SQLite. Ends when the last sender is gone or on `Close`.
async fn write_in_groups(mut connection: SqliteConnection, mut writes: mpsc::Receiver<Write>) {
    let mut group = Vec::with_capacity(GROUP_SIZE);
    let mut closing = None;
    while closing.is_none() && writes.recv_many(&mut group, GROUP_SIZE).await > 0 {
        let mut runs = Vec::with_capacity(group.len());
        for write in group.drain(..) {
            match write {
                Write::Run(run) => runs.push(run),
                Write::Close(done) => closing = Some(done),
            }
        }
        if runs.is_empty() {
            continue;
        }
        let committed = commit_group(&mut connection, &mut runs).await;
        if matches!(committed, Err(StoreError::NoSpace(_))) && runs.len() > 1 {
            // A full disk ends the whole transaction; alone, those that need no more space still succeed.
            for mut run in runs {
                let committed = commit_group(&mut connection, std::slice::from_mut(&mut run)).await;
                run.answer(committed);
            }
            continue;
        }
        for run in runs {
            run.answer(committed.clone());
        }
    }
    if let Err(error) = connection.close().await {
        tracing::warn!(%error, "closing the database");
    }
    if let Some(done) = closing {
        let _ = done.send(());
    }
}

/// Runs a group in one transaction. What failed by itself has kept its error and left no trace; an error here means that
/// nothing of the group happened.
async fn commit_group(connection: &mut SqliteConnection, runs: &mut [Box<dyn Run>]) -> Result<()> {
    let committed = match run_together(connection, runs).await {
        Err(_) if runs.len() > 1 => {
            let _ = execute(connection, "ROLLBACK").await;
            run_apart(connection, runs).await
        }
        committed => committed,
    };
    if committed.is_err() {
        // Fails if the engine has rolled back by itself, which is as good.
        let _ = execute(connection, "ROLLBACK").await;
    }
    committed
}

/// The whole group or nothing: each statement is a way to the connection's thread and back, and failures are rare.
async fn run_together(connection: &mut SqliteConnection, runs: &mut [Box<dyn Run>]) -> Result<()> {
    execute(connection, "BEGIN IMMEDIATE").await?;
    for run in runs {
        run.run(&mut Connection::Sqlite(connection)).await?;
    }
    execute(connection, "COMMIT").await
}

/// Each inside a savepoint, so that one that fails leaves the others alone.
async fn run_apart(connection: &mut SqliteConnection, runs: &mut [Box<dyn Run>]) -> Result<()> {
    execute(connection, "BEGIN IMMEDIATE").await?;
    for run in runs {
        execute(connection, "SAVEPOINT one").await?;
        if let Err(error) = run.run(&mut Connection::Sqlite(connection)).await {
            // A full disk can end the whole transaction by itself; then there is no savepoint and the group has failed.
            execute(connection, "ROLLBACK TO one").await.map_err(|_| error)?;
        }
        execute(connection, "RELEASE one").await?;
    }
    execute(connection, "COMMIT").await
}

async fn execute(connection: &mut SqliteConnection, text: &'static str) -> Result<()> {
    sqlx::query(text).execute(connection).await?;
    Ok(())
}

fn migrations() -> Migrator {
    let texts = [
        (1, "jobs", include_str!("../../migrations/0001_jobs.sql")),
        (2, "batches and callbacks", include_str!("../../migrations/0002_batches_and_callbacks.sql")),
    ];
    let mut migrator = Migrator::with_migrations(
        texts
            .into_iter()
            .map(|(version, name, text)| {
                Migration::new(version, name.into(), MigrationType::Simple, text.into_sql_str(), false)
            })
            .collect(),
    );
    // An older version keeps working on a database that a newer one has added to: migrations only ever add.
    migrator.set_ignore_missing(true);
    migrator
}
