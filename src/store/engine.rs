//! Opening either engine and running transactions on it.
//!
//! SQLite is `sqlite`. PostgreSQL runs every write in a transaction from its pool and repeats the ones that lost a race.

use std::str::FromStr;
use std::sync::atomic::{AtomicBool, Ordering};
use std::time::Duration;

use futures_util::future::BoxFuture;
use sqlx::migrate::{Migration, MigrationType, Migrator};
use sqlx::postgres::{PgConnectOptions, PgPoolOptions};
use sqlx::{PgPool, SqlSafeStr};

use super::sql::{Connection, Row, Value};
use super::sqlite::Database;
use super::{StoreError, StoreOptions};

pub(super) type Result<T> = std::result::Result<T, StoreError>;

/// Pages that one `shrink` moves at most, so that it never holds up other writes for long.
const SHRINK_PAGES: u32 = 50;
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
    Sqlite(Database),
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
            Ok(Self::Sqlite(Database::open(url, options).await?))
        } else {
            Err(StoreError::Url("expected sqlite://PATH or postgres://USER@HOST/DATABASE".into()))
        }
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
            Self::Sqlite(database) => database.write(work).await,
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
        match self {
            Self::Sqlite(database) => database.rows(text, values).await,
            Self::Postgres(pool) => Connection::Postgres(&mut *pool.acquire().await?).rows(text, values).await,
        }
    }

    /// Gives pages that nothing uses any more back to the file system. PostgreSQL does so by itself.
    async fn shrink(&self) -> Result<()> {
        match self {
            Self::Sqlite(_) => {
                let text = format!("PRAGMA incremental_vacuum({SHRINK_PAGES})");
                self.write(move |connection| {
                    let text = text.clone();
                    Box::pin(async move { connection.rows(&text, Vec::new()).await.map(|_| ()) })
                })
                .await
            }
            Self::Postgres(_) => Ok(()),
        }
    }

    /// Waits for running statements and closes every connection. Writes afterwards fail as `Unavailable`.
    async fn close(&self) {
        match self {
            Self::Sqlite(database) => database.close().await,
            Self::Postgres(pool) => pool.close().await,
        }
    }
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

pub(super) fn migrations() -> Migrator {
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
