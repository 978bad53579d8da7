//! SQLite, embedded: one thread that writes, and a few connections that read.
//!
//! The writer takes whatever writes have queued up while the last commit was on its way to the disk and commits them together
//! (where one fails, all again, each inside a savepoint of its own), so that durability costs one disk sync a group and not one a
//! job. Its statements run on its own thread, one after the other, without a way to another thread and back for each. Another
//! thread copies the write-ahead log into the database, so that writes need not wait for that either.

use std::cell::Cell;
use std::path::{Path, PathBuf};
use std::sync::mpsc::{SyncSender, sync_channel};
use std::sync::{Arc, Mutex, PoisonError};
use std::thread::JoinHandle;
use std::time::Duration;

use futures_util::FutureExt;
use futures_util::future::BoxFuture;
use rusqlite::{Connection as Sqlite, OpenFlags, OptionalExtension, params};
use tokio::sync::{Semaphore, mpsc, oneshot};

use super::engine::{Result, migrations};
use super::sql::{self, Connection, Row, Value};
use super::{StoreError, StoreOptions};

/// Writes that share one commit at most.
const GROUP_SIZE: usize = 128;
/// Writes that may wait for the writer before callers wait for a place.
const WRITE_BACKLOG: usize = 1024;
/// The write-ahead log is cut back to this size when it has been copied into the database.
const WAL_KEPT_BYTES: u32 = 64 << 20;
/// Pages that the write-ahead log has grown by when it is copied into the database, beside the writes: pages of indexes that
/// many jobs change are then copied once.
const COPIED_PAGES: u32 = 1024;
/// Pages in the write-ahead log at which the writer itself copies what is left. The log begins anew only where all of it has been
/// copied, and while writes come without a pause that is never so otherwise.
const MOST_PAGES: u32 = 16384;
/// What the writer keeps of the database in memory: hashes are indexed, so that writes touch pages anywhere.
const CACHE_KIB: u32 = 8 << 10;
const READERS: u32 = 4;
/// Statements that a connection keeps prepared; there are fewer than these in all.
const PREPARED: usize = 128;
const BUSY_TIMEOUT: Duration = Duration::from_secs(10);

/// A handle; clones share it.
#[derive(Debug, Clone)]
pub(super) struct Database {
    readers: Arc<Readers>,
    writer: mpsc::Sender<Write>,
}

impl Database {
    /// Opens `sqlite://PATH`, creating the file if it is missing, and brings its tables up to date.
    pub(super) async fn open(url: &str, options: &StoreOptions) -> Result<Self> {
        let path = url.strip_prefix("sqlite://").or_else(|| url.strip_prefix("sqlite:")).unwrap_or_default();
        if path.is_empty() || path.contains('?') || path.contains(":memory:") {
            return Err(StoreError::Url("expected sqlite://PATH, with the path of a file and no parameters".into()));
        }
        let path = PathBuf::from(path);
        let (writer, writes) = mpsc::channel(WRITE_BACKLOG);
        let (file, max_bytes) = (path.clone(), options.max_bytes);
        let (opened, opening) = oneshot::channel();
        let open = move || Result::Ok((open_writer(&file, max_bytes)?, Copier::start(&file)?));
        let run = move || match open() {
            Ok((connection, copier)) => {
                // Whoever asked may have gone away; then there is nobody to write for either.
                let _ = opened.send(Ok(()));
                write_in_groups(connection, copier, writes);
            }
            Err(error) => {
                let _ = opened.send(Err(error));
            }
        };
        std::thread::Builder::new().name("sqlite writer".into()).spawn(run)?;
        opening.await.map_err(|_| closed())??;
        Ok(Self { readers: Arc::new(Readers::new(path)), writer })
    }

    /// Runs `work` in one transaction, which it may share with others.
    pub(super) async fn write<T, F>(&self, work: F) -> Result<T>
    where
        T: Send + 'static,
        F: for<'a, 'c> Fn(&'a mut Connection<'c>) -> BoxFuture<'a, Result<T>> + Send + Sync + 'static,
    {
        let (answer, answered) = oneshot::channel();
        let pending = Pending { work, result: None, answer };
        self.writer.send(Write::Run(Box::new(pending))).await.map_err(|_| closed())?;
        answered.await.map_err(|_| closed())?
    }

    /// Rows of a statement that only reads.
    pub(super) async fn rows(&self, text: &str, values: Vec<Value>) -> Result<Vec<Row>> {
        let permit = Arc::clone(&self.readers.permits).acquire_owned().await.map_err(|_| closed())?;
        let (readers, text) = (Arc::clone(&self.readers), text.to_owned());
        let read = move || {
            let _permit = permit;
            readers.rows(&text, &values)
        };
        tokio::task::spawn_blocking(read).await.map_err(|error| StoreError::Internal(error.to_string()))?
    }

    /// Waits for running statements and closes every connection. Everything afterwards fails as `Unavailable`.
    pub(super) async fn close(&self) {
        // The writer's is the last connection, so that it leaves one file behind.
        let _all = self.readers.permits.acquire_many(READERS).await;
        self.readers.permits.close();
        self.readers.idle().clear();
        let (answer, answered) = oneshot::channel();
        if self.writer.send(Write::Close(answer)).await.is_ok() {
            // An error only says that the writer was gone already.
            let _ = answered.await;
        }
    }
}

fn closed() -> StoreError {
    StoreError::Unavailable("the store is closed".into())
}

/// Connections that read, opened when they are wanted.
#[derive(Debug)]
struct Readers {
    path: PathBuf,
    permits: Arc<Semaphore>,
    idle: Mutex<Vec<Sqlite>>,
}

impl Readers {
    fn new(path: PathBuf) -> Self {
        Self { path, permits: Arc::new(Semaphore::new(READERS as usize)), idle: Mutex::default() }
    }

    fn idle(&self) -> std::sync::MutexGuard<'_, Vec<Sqlite>> {
        // A list is never half changed.
        self.idle.lock().unwrap_or_else(PoisonError::into_inner)
    }

    fn rows(&self, text: &str, values: &[Value]) -> Result<Vec<Row>> {
        let idle = self.idle().pop();
        let connection = match idle {
            Some(connection) => connection,
            None => open(&self.path, OpenFlags::SQLITE_OPEN_READ_ONLY)?,
        };
        let rows = sql::sqlite_rows(&connection, text, values);
        self.idle().push(connection);
        rows
    }
}

fn open(path: &Path, access: OpenFlags) -> Result<Sqlite> {
    let connection = Sqlite::open_with_flags(path, access | OpenFlags::SQLITE_OPEN_NO_MUTEX)?;
    connection.busy_timeout(BUSY_TIMEOUT)?;
    connection.set_prepared_statement_cache_capacity(PREPARED);
    Ok(connection)
}

fn open_writer(path: &Path, max_bytes: Option<u64>) -> Result<Sqlite> {
    let mut connection = open(path, OpenFlags::SQLITE_OPEN_READ_WRITE | OpenFlags::SQLITE_OPEN_CREATE)?;
    // The first only works before the first table, so before the log.
    connection.execute_batch(&format!(
        "PRAGMA auto_vacuum = INCREMENTAL; PRAGMA journal_mode = WAL; PRAGMA synchronous = FULL; \
         PRAGMA journal_size_limit = {WAL_KEPT_BYTES}; PRAGMA cache_size = -{CACHE_KIB};"
    ))?;
    // In place of the engine's own copying, which every so many commits keeps one waiting.
    connection.wal_hook(Some(|_, pages| {
        LOG_PAGES.set(u32::try_from(pages).unwrap_or(u32::MAX));
        Ok(())
    }));
    if let Some(bytes) = max_bytes {
        // The engine refuses writes beyond this as on a full disk.
        let size: i64 = connection.query_row("PRAGMA page_size", [], |row| row.get(0))?;
        let pages = i64::try_from(bytes).unwrap_or(i64::MAX) / size.max(1);
        connection.execute_batch(&format!("PRAGMA max_page_count = {pages}"))?;
    }
    migrate(&mut connection)?;
    Ok(connection)
}

/// Makes the migrations that the database lacks, all or none. They are remembered where sqlx remembers PostgreSQL's.
fn migrate(connection: &mut Sqlite) -> Result<()> {
    let transaction = connection.transaction_with_behavior(rusqlite::TransactionBehavior::Immediate)?;
    transaction.execute_batch(
        "CREATE TABLE IF NOT EXISTS _sqlx_migrations (version BIGINT PRIMARY KEY, description TEXT NOT NULL, \
         installed_on TIMESTAMP NOT NULL DEFAULT CURRENT_TIMESTAMP, success BOOLEAN NOT NULL, checksum BLOB NOT NULL, \
         execution_time BIGINT NOT NULL)",
    )?;
    for migration in migrations().iter() {
        let known = "SELECT checksum FROM _sqlx_migrations WHERE version = ?1 AND success";
        let made: Option<Vec<u8>> = transaction.query_row(known, [migration.version], |row| row.get(0)).optional()?;
        match made {
            Some(checksum) if checksum == *migration.checksum => {}
            Some(_) => {
                let version = migration.version;
                let text = format!("migration {version} of this database is not the one that this program has");
                return Err(StoreError::Migration(text));
            }
            None => {
                transaction
                    .execute_batch(migration.sql.as_str())
                    .map_err(|error| StoreError::Migration(error.to_string()))?;
                transaction.execute(
                    "INSERT INTO _sqlx_migrations (version, description, success, checksum, execution_time) \
                     VALUES (?1, ?2, TRUE, ?3, 0)",
                    params![migration.version, &*migration.description, &*migration.checksum],
                )?;
            }
        }
    }
    Ok(transaction.commit()?)
}

enum Write {
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
trait Run: Send {
    /// Whether the work succeeded and is to be kept.
    fn run(&mut self, connection: &mut Sqlite) -> Result<()>;
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
    fn run(&mut self, connection: &mut Sqlite) -> Result<()> {
        // A statement of this engine has ended when its future is first looked at, and a write awaits nothing else.
        let result = (self.work)(&mut Connection::Sqlite(connection)).now_or_never();
        let result = result.unwrap_or_else(|| Err(StoreError::Internal("a write awaited more than statements".into())));
        let ended = result.as_ref().map(|_| ()).map_err(Clone::clone);
        self.result = Some(result);
        ended
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

/// Pages by which the log may grow before it is copied again: few where the writer is about to copy the rest.
fn step(pages: u32) -> u32 {
    if pages < MOST_PAGES - COPIED_PAGES { COPIED_PAGES } else { COPIED_PAGES / 8 }
}

thread_local! {
    /// Pages in the write-ahead log after the last commit of the writer that this thread is.
    static LOG_PAGES: Cell<u32> = const { Cell::new(0) };
}

/// A thread that copies the write-ahead log into the database. Ends when this is dropped.
struct Copier {
    wanted: Option<SyncSender<()>>,
    thread: Option<JoinHandle<()>>,
}

impl Copier {
    fn start(path: &Path) -> Result<Self> {
        let connection = open(path, OpenFlags::SQLITE_OPEN_READ_WRITE)?;
        connection.execute_batch("PRAGMA synchronous = FULL")?;
        let (wanted, wishes) = sync_channel(1);
        let run = move || {
            for () in wishes {
                copy_log(&connection);
            }
        };
        let thread = std::thread::Builder::new().name("sqlite copier".into()).spawn(run)?;
        Ok(Self { wanted: Some(wanted), thread: Some(thread) })
    }

    fn want(&self) {
        // A full channel means that it is about to copy anyway.
        let _ = self.wanted.as_ref().map(|wanted| wanted.try_send(()));
    }
}

impl Drop for Copier {
    fn drop(&mut self) {
        self.wanted = None;
        // A panic of that thread has been reported, and the log is still there to be copied.
        let _ = self.thread.take().map(JoinHandle::join);
    }
}

/// Copies what no reader needs in the log any more, without keeping anybody waiting.
fn copy_log(connection: &Sqlite) {
    let copied = connection.query_row("PRAGMA wal_checkpoint(PASSIVE)", [], |_| Ok(()));
    if let Err(error) = copied {
        tracing::warn!(%error, "copying the write-ahead log");
    }
}

/// The writer. Ends when the last sender is gone or on `Close`.
fn write_in_groups(mut connection: Sqlite, copier: Copier, mut writes: mpsc::Receiver<Write>) {
    let mut group = Vec::with_capacity(GROUP_SIZE);
    let mut closing = None;
    let mut copied_at = 0;
    while closing.is_none() && writes.blocking_recv_many(&mut group, GROUP_SIZE) > 0 {
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
        let committed = commit_group(&mut connection, &mut runs);
        if matches!(committed, Err(StoreError::NoSpace(_))) && runs.len() > 1 {
            // A full disk ends the whole transaction; alone, those that need no more space still succeed.
            for mut run in runs {
                let committed = commit_group(&mut connection, std::slice::from_mut(&mut run));
                run.answer(committed);
            }
            continue;
        }
        for run in runs {
            run.answer(committed.clone());
        }
        let pages = LOG_PAGES.get();
        if pages >= MOST_PAGES {
            copy_log(&connection);
            copied_at = 0;
        } else if pages < copied_at || pages - copied_at >= step(pages) {
            copier.want();
            copied_at = pages;
        }
    }
    // The last connection to be closed leaves one file behind.
    drop(copier);
    if let Err((_, error)) = connection.close() {
        tracing::warn!(%error, "closing the database");
    }
    if let Some(done) = closing {
        let _ = done.send(());
    }
}

/// Runs a group in one transaction. What failed by itself has kept its error and left no trace; an error here means that
/// nothing of the group happened.
fn commit_group(connection: &mut Sqlite, runs: &mut [Box<dyn Run>]) -> Result<()> {
    let committed = match run_together(connection, runs) {
        Err(_) if runs.len() > 1 => {
            let _ = execute(connection, "ROLLBACK");
            run_apart(connection, runs)
        }
        committed => committed,
    };
    if committed.is_err() {
        // Fails if the engine has rolled back by itself, which is as good.
        let _ = execute(connection, "ROLLBACK");
    }
    committed
}

/// The whole group or nothing: failures are rare, and savepoints cost.
fn run_together(connection: &mut Sqlite, runs: &mut [Box<dyn Run>]) -> Result<()> {
    execute(connection, "BEGIN IMMEDIATE")?;
    for run in runs {
        run.run(connection)?;
    }
    execute(connection, "COMMIT")
}

/// Each inside a savepoint, so that one that fails leaves the others alone.
fn run_apart(connection: &mut Sqlite, runs: &mut [Box<dyn Run>]) -> Result<()> {
    execute(connection, "BEGIN IMMEDIATE")?;
    for run in runs {
        execute(connection, "SAVEPOINT one")?;
        if let Err(error) = run.run(connection) {
            // A full disk can end the whole transaction by itself; then there is no savepoint and the group has failed.
            execute(connection, "ROLLBACK TO one").map_err(|_| error)?;
        }
        execute(connection, "RELEASE one")?;
    }
    execute(connection, "COMMIT")
}

fn execute(connection: &Sqlite, text: &str) -> Result<()> {
    connection.prepare_cached(text)?.execute([])?;
    Ok(())
}

#[cfg(test)]
mod tests {
    use super::*;

    #[tokio::test]
    async fn a_url_without_a_file_or_with_parameters_is_refused() {
        for url in ["sqlite://", "sqlite:", "sqlite::memory:", "sqlite:///tmp/a.db?mode=ro"] {
            let opened = Database::open(url, &StoreOptions::default()).await;
            assert!(matches!(opened, Err(StoreError::Url(_))), "{url}");
        }
    }

    #[tokio::test]
    async fn a_database_with_another_first_migration_is_refused_and_left_alone() {
        let folder = tempfile::tempdir().unwrap();
        let path = folder.path().join("a.db");
        let url = format!("sqlite://{}", path.display());
        Database::open(&url, &StoreOptions::default()).await.unwrap().close().await;
        let change = Sqlite::open(&path).unwrap();
        change.execute_batch("UPDATE _sqlx_migrations SET checksum = x'00' WHERE version = 1").unwrap();
        drop(change);
        let opened = Database::open(&url, &StoreOptions::default()).await;
        assert!(matches!(opened, Err(StoreError::Migration(_))), "{opened:?}");
    }

    #[tokio::test]
    async fn a_write_that_fails_leaves_the_others_of_its_group_alone() {
        let folder = tempfile::tempdir().unwrap();
        let url = format!("sqlite://{}/a.db", folder.path().display());
        let database = Database::open(&url, &StoreOptions::default()).await.unwrap();
        let forget = |id: &'static str, fails: bool| {
            let database = database.clone();
            tokio::spawn(async move {
                database
                    .write(move |connection| {
                        Box::pin(async move {
                            let text = "INSERT INTO expired_jobs (id, owner, expired_at) VALUES ($1, '', 0)";
                            connection.execute(text, vec![id.into()]).await?;
                            if fails { Err(StoreError::Contended("as asked".into())) } else { Ok(()) }
                        })
                    })
                    .await
            })
        };
        // While the writer is held up, the others gather behind it.
        let held = database.clone();
        let holding = tokio::spawn(async move {
            held.write(|_| {
                std::thread::sleep(Duration::from_millis(200));
                Box::pin(async { Ok(()) })
            })
            .await
        });
        tokio::task::yield_now().await;
        let writes = ["a", "b", "c", "d"].map(|id| forget(id, id == "c"));
        holding.await.unwrap().unwrap();
        for (write, fails) in writes.into_iter().zip([false, false, true, false]) {
            assert_eq!(write.await.unwrap().is_err(), fails);
        }
        let rows = database.rows("SELECT id FROM expired_jobs ORDER BY id", Vec::new()).await.unwrap();
        let ids: Vec<String> = rows.iter().map(|row| row.text(0).unwrap()).collect();
        assert_eq!(ids, ["a", "b", "d"]);
        database.close().await;
        let after = database.rows("SELECT 1", Vec::new()).await;
        assert!(matches!(after, Err(StoreError::Unavailable(_))));
        assert!(!folder.path().join("a.db-wal").exists(), "closing leaves one file");
    }
}
