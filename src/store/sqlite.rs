//! SQLite, embedded. One thread writes, and a few threads read.
//!
//! The writer commits together all writes that arrived during the last commit, so that durability costs one disk sync
//! per group instead of one per write. If a write of a group fails, the group is rolled back and each write is
//! committed by itself. A third kind of thread copies the write-ahead log into the database, so that writes need not
//! wait for that.

use std::cell::Cell;
use std::panic::{AssertUnwindSafe, catch_unwind};
use std::path::{Path, PathBuf};
use std::sync::mpsc::{SyncSender, sync_channel};
use std::thread::JoinHandle;
use std::time::Duration;

use rusqlite::{Connection as Sqlite, OpenFlags};
use tokio::sync::{mpsc, oneshot};

use super::migrations::migrate;
use super::pool::{Pool, closed};
#[cfg(feature = "test-hooks")]
use super::tx::fail_if_asked;
use super::tx::{AfterCommit, Tx};
use super::{Result, StoreError, StoreOptions};
#[cfg(feature = "test-hooks")]
use crate::test_hooks::FailurePoint;

/// Upper bound of the writes that share one commit.
const GROUP_SIZE: usize = 128;
/// Number of writes that may be queued for the writer. Further callers wait.
const WRITE_BACKLOG: usize = 1024;
/// Size in bytes to which SQLite shortens the write-ahead log after copying it into the database. The log hardly grows
/// beyond this size, because the writer copies it then.
const LOG_KEPT_BYTES: u32 = MAX_LOG_PAGES * 4096;
/// Number of pages by which the write-ahead log may grow before it is copied while writes continue. Index pages that
/// many jobs change are then copied only once.
const COPY_STEP_PAGES: u32 = 1024;
/// Length of the write-ahead log, in pages, at which the writer itself copies the rest of it. The log starts again from
/// its beginning only when all of it has been copied, which never happens during writes without a pause. A longer log
/// needs a larger ballast, because copying the log may extend the database by as much on a disk that is already full.
const MAX_LOG_PAGES: u32 = 4096;
/// Size of the writer's page cache in KiB. Hashes are indexed, so writes touch pages anywhere in the file.
const CACHE_KIB: u32 = 8 << 10;
/// Number of threads that read.
const READERS: usize = 4;
/// Number of prepared statements that a connection keeps. The store has fewer.
const PREPARED: usize = 128;
const BUSY_TIMEOUT: Duration = Duration::from_secs(10);

#[derive(Debug)]
pub(super) struct Database {
    readers: Pool<Sqlite>,
    writer: mpsc::Sender<Message>,
}

impl Database {
    /// Opens `sqlite://PATH`, creating the file if it is missing, and migrates its tables.
    pub(super) async fn open(url: &str, options: &StoreOptions) -> Result<Self> {
        let path = path(url)?;
        let (writer, messages) = mpsc::channel(WRITE_BACKLOG);
        let (file, max_bytes) = (path.clone(), options.max_bytes);
        let (opened, opening) = oneshot::channel();
        let open_both = move || Result::Ok((open_writer(&file, max_bytes)?, Copier::start(&file)?));
        let run = move || match open_both() {
            Ok((connection, copier)) => {
                // If the caller went away, its sender is gone too, so the writer ends at once.
                let _ = opened.send(Ok(()));
                write_in_groups(connection, copier, messages);
            }
            Err(error) => {
                let _ = opened.send(Err(error));
            }
        };
        std::thread::Builder::new().name("sqlite writer".into()).spawn(run)?;
        opening.await.map_err(|_| closed())??;
        let readers =
            Pool::start("sqlite reader", READERS, None, move || open(&path, OpenFlags::SQLITE_OPEN_READ_ONLY))?;
        Ok(Self { readers, writer })
    }

    /// Runs `work` in a transaction, which it may share with other writes. If one of the others fails, `work` runs
    /// again.
    pub(super) async fn write<T: Send + 'static>(
        &self,
        work: impl Fn(&mut Tx<'_>) -> Result<T> + Send + 'static,
    ) -> Result<(T, AfterCommit)> {
        let (answer, answered) = oneshot::channel();
        let pending = Pending { work, result: None, answer };
        self.writer.send(Message::Write(Box::new(pending))).await.map_err(|_| closed())?;
        answered.await.map_err(|_| closed())?
    }

    /// Runs `work`, which must only read.
    pub(super) async fn read<T: Send + 'static>(
        &self,
        work: impl Fn(&mut Tx<'_>) -> Result<T> + Send + 'static,
    ) -> Result<T> {
        self.readers.run(move |connection| work(&mut Tx::sqlite(connection))).await
    }

    /// Fails if no write can succeed any more, because the writer's thread has ended.
    pub(super) fn check_writer(&self) -> Result<()> {
        if self.writer.is_closed() { Err(closed()) } else { Ok(()) }
    }

    /// Copies the whole write-ahead log into the database and returns its space to the file system.
    pub(super) async fn cut_log(&self) -> Result<()> {
        let (answer, answered) = oneshot::channel();
        self.writer.send(Message::CutLog(answer)).await.map_err(|_| closed())?;
        answered.await.map_err(|_| closed())?
    }

    /// Waits for running statements and closes every connection. Later calls fail with `Unavailable`.
    pub(super) async fn close(&self) {
        // The writer's connection is closed last, so that SQLite leaves a single file.
        self.readers.close().await;
        let (answer, answered) = oneshot::channel();
        if self.writer.send(Message::Close(answer)).await.is_ok() {
            // An error means that the writer had already ended.
            let _ = answered.await;
        }
    }
}

/// Returns the path of the database file that a URL names.
pub(super) fn path(url: &str) -> Result<PathBuf> {
    let path = url.strip_prefix("sqlite://").or_else(|| url.strip_prefix("sqlite:")).unwrap_or_default();
    if path.is_empty() || path.contains('?') || path.contains(":memory:") {
        return Err(StoreError::Url("expected sqlite://PATH, with the path of a file and no parameters".into()));
    }
    Ok(path.into())
}

fn open(path: &Path, access: OpenFlags) -> Result<Sqlite> {
    let connection = Sqlite::open_with_flags(path, access | OpenFlags::SQLITE_OPEN_NO_MUTEX)?;
    connection.busy_timeout(BUSY_TIMEOUT)?;
    connection.set_prepared_statement_cache_capacity(PREPARED);
    Ok(connection)
}

fn open_writer(path: &Path, max_bytes: Option<u64>) -> Result<Sqlite> {
    let connection = open(path, OpenFlags::SQLITE_OPEN_READ_WRITE | OpenFlags::SQLITE_OPEN_CREATE)?;
    // `auto_vacuum` takes effect only before the first table exists.
    connection.execute_batch(&format!(
        "PRAGMA auto_vacuum = INCREMENTAL; PRAGMA journal_mode = WAL; PRAGMA synchronous = FULL; \
         PRAGMA journal_size_limit = {LOG_KEPT_BYTES}; PRAGMA cache_size = -{CACHE_KIB};"
    ))?;
    // This hook replaces SQLite's own copying of the log, which would delay a commit at regular intervals.
    connection.wal_hook(Some(|_, pages| {
        LOG_PAGES.set(u32::try_from(pages).unwrap_or(u32::MAX));
        Ok(())
    }));
    if let Some(bytes) = max_bytes {
        // SQLite refuses writes beyond this size with the same error as on a full disk.
        let size: i64 = connection.query_row("PRAGMA page_size", [], |row| row.get(0))?;
        let pages = i64::try_from(bytes).unwrap_or(i64::MAX) / size.max(1);
        connection.execute_batch(&format!("PRAGMA max_page_count = {pages}"))?;
    }
    transact(&connection, migrate)?;
    Ok(connection)
}

/// Runs `work` in its own transaction.
fn transact<T>(connection: &Sqlite, work: impl FnOnce(&mut Tx<'_>) -> Result<T>) -> Result<T> {
    execute(connection, "BEGIN IMMEDIATE")?;
    let done = work(&mut Tx::sqlite(connection)).and_then(|value| execute(connection, "COMMIT").map(|()| value));
    if done.is_err() {
        // This fails if SQLite has already rolled back, which has the same effect.
        let _ = execute(connection, "ROLLBACK");
    }
    done
}

fn execute(connection: &Sqlite, text: &str) -> Result<()> {
    #[cfg(feature = "test-hooks")]
    fail_if_asked(connection, text, FailurePoint::Before)?;
    connection.prepare_cached(text)?.execute([])?;
    Ok(())
}

enum Message {
    Write(Box<dyn Write>),
    CutLog(oneshot::Sender<Result<()>>),
    Close(oneshot::Sender<()>),
}

/// A write and the caller that waits for its result.
trait Write: Send {
    fn run(&mut self, connection: &Sqlite) -> Result<()>;
    /// Sends the result of the work to the caller, after the commit has succeeded or failed.
    fn answer(self: Box<Self>, committed: Result<()>);
}

struct Pending<T, F> {
    work: F,
    result: Option<(T, AfterCommit)>,
    answer: oneshot::Sender<Result<(T, AfterCommit)>>,
}

impl<T: Send, F: Fn(&mut Tx<'_>) -> Result<T> + Send> Write for Pending<T, F> {
    fn run(&mut self, connection: &Sqlite) -> Result<()> {
        let mut tx = Tx::sqlite(connection);
        // A panic must not end the writer's thread. The changes that the work had made are rolled back.
        let worked = catch_unwind(AssertUnwindSafe(|| (self.work)(&mut tx)));
        let value = worked.unwrap_or_else(|_| Err(StoreError::Internal("a write of the store panicked".into())))?;
        self.result = Some((value, tx.into_after_commit()));
        Ok(())
    }

    fn answer(self: Box<Self>, committed: Result<()>) {
        let Self { result, answer, .. } = *self;
        // If the caller went away, the answer is dropped.
        let _ = answer.send(committed.and_then(|()| result.ok_or_else(closed)));
    }
}

/// Receives messages on the writer's thread, and commits the writes in groups. Ends when the last sender is dropped or
/// on `Close`.
fn write_in_groups(connection: Sqlite, copier: Copier, mut messages: mpsc::Receiver<Message>) {
    let mut received = Vec::with_capacity(GROUP_SIZE);
    let (mut cutting, mut closing) = (None, None);
    let mut copied_at = 0;
    while closing.is_none() && messages.blocking_recv_many(&mut received, GROUP_SIZE) > 0 {
        let mut group = Vec::with_capacity(received.len());
        for message in received.drain(..) {
            match message {
                Message::Write(write) => group.push(write),
                Message::CutLog(done) => cutting = Some(done),
                Message::Close(done) => closing = Some(done),
            }
        }
        if !group.is_empty() {
            commit(&connection, group);
            copied_at = copy(&connection, &copier, copied_at);
        }
        if let Some(done) = cutting.take() {
            let cut = connection.query_row("PRAGMA wal_checkpoint(TRUNCATE)", [], |_| Ok(()));
            let _ = done.send(cut.map_err(StoreError::from));
        }
    }
    // Writes fail from now on, and `check_writer` says so.
    drop(messages);
    drop(copier);
    if let Err((_, error)) = connection.close() {
        tracing::warn!(%error, "cannot close the database");
    }
    if let Some(done) = closing {
        let _ = done.send(());
    }
}

/// Commits a group of writes together, or each by itself if that fails, and sends the answers.
fn commit(connection: &Sqlite, mut group: Vec<Box<dyn Write>>) {
    let together = transact(connection, |_| group.iter_mut().try_for_each(|write| write.run(connection)));
    if together.is_ok() || group.len() == 1 {
        #[cfg(feature = "test-hooks")]
        let together = together.and_then(|()| fail_if_asked(connection, "COMMIT", FailurePoint::After));
        group.into_iter().for_each(|write| write.answer(together.clone()));
        return;
    }
    for mut write in group {
        let committed = transact(connection, |_| write.run(connection));
        #[cfg(feature = "test-hooks")]
        let committed = committed.and_then(|()| fail_if_asked(connection, "COMMIT", FailurePoint::After));
        write.answer(committed);
    }
}

/// Asks the copier to copy the log if it has grown enough since it was `copied_at` pages long. Returns the new
/// `copied_at`.
fn copy(connection: &Sqlite, copier: &Copier, copied_at: u32) -> u32 {
    let pages = LOG_PAGES.get();
    if pages >= MAX_LOG_PAGES {
        copy_log(connection);
        return 0;
    }
    // The steps become shorter shortly before the writer would have to copy the rest itself.
    let step = if pages < MAX_LOG_PAGES - COPY_STEP_PAGES { COPY_STEP_PAGES } else { COPY_STEP_PAGES / 8 };
    if pages >= copied_at && pages - copied_at < step {
        return copied_at;
    }
    copier.request();
    pages
}

thread_local! {
    /// Length of the write-ahead log in pages after the last commit of the writer on this thread.
    static LOG_PAGES: Cell<u32> = const { Cell::new(0) };
}

/// A thread that copies the write-ahead log into the database. It ends when this value is dropped.
struct Copier {
    requests: Option<SyncSender<()>>,
    thread: Option<JoinHandle<()>>,
}

impl Copier {
    fn start(path: &Path) -> Result<Self> {
        let connection = open(path, OpenFlags::SQLITE_OPEN_READ_WRITE)?;
        connection.execute_batch("PRAGMA synchronous = FULL")?;
        let (requests, received) = sync_channel(1);
        let run = move || {
            for () in received {
                copy_log(&connection);
            }
        };
        let thread = std::thread::Builder::new().name("sqlite copier".into()).spawn(run)?;
        Ok(Self { requests: Some(requests), thread: Some(thread) })
    }

    fn request(&self) {
        // A full channel means that the thread will copy anyway.
        let _ = self.requests.as_ref().map(|requests| requests.try_send(()));
    }
}

impl Drop for Copier {
    fn drop(&mut self) {
        self.requests = None;
        // A panic of that thread has already been reported, and the log is still complete.
        let _ = self.thread.take().map(JoinHandle::join);
    }
}

/// Copies the part of the log that no reader needs any more. The other connections need not wait for this copying.
fn copy_log(connection: &Sqlite) {
    let copied = connection.query_row("PRAGMA wal_checkpoint(PASSIVE)", [], |_| Ok(()));
    if let Err(error) = copied {
        tracing::warn!(%error, "cannot copy the write-ahead log");
    }
}

impl From<rusqlite::Error> for StoreError {
    fn from(error: rusqlite::Error) -> Self {
        use rusqlite::ErrorCode::{
            CannotOpen, DatabaseBusy, DatabaseCorrupt, DatabaseLocked, DiskFull, FileLockingProtocolFailed,
            NotADatabase, PermissionDenied, ReadOnly, SystemIoFailure,
        };
        let text = error.to_string();
        match error.sqlite_error_code() {
            Some(DiskFull) => Self::NoSpace(text),
            // The disk or the database is at fault, not the statement. A repair or a restored backup may help.
            Some(
                DatabaseBusy
                | DatabaseLocked
                | SystemIoFailure
                | DatabaseCorrupt
                | NotADatabase
                | ReadOnly
                | CannotOpen
                | PermissionDenied
                | FileLockingProtocolFailed,
            ) => Self::Unavailable(text),
            _ => Self::Internal(text),
        }
    }
}

#[cfg(test)]
mod tests {
    use std::task::{Context, Waker};

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
        change.execute_batch("UPDATE migrations SET checksum = x'00' WHERE version = 1").unwrap();
        drop(change);
        let opened = Database::open(&url, &StoreOptions::default()).await;
        assert!(matches!(opened, Err(StoreError::Migration(_))), "{opened:?}");
    }

    #[tokio::test]
    async fn a_file_with_the_tables_of_another_program_is_refused_and_left_alone() {
        let folder = tempfile::tempdir().unwrap();
        let path = folder.path().join("a.db");
        Sqlite::open(&path).unwrap().execute_batch("CREATE TABLE jobs (name TEXT)").unwrap();
        let opened = Database::open(&format!("sqlite://{}", path.display()), &StoreOptions::default()).await;
        let Err(StoreError::Migration(text)) = opened else { panic!("{opened:?}") };
        assert!(text.contains("table jobs already exists"), "{text}");
        let tables = "SELECT group_concat(name) FROM sqlite_master WHERE type = 'table'";
        let tables: String = Sqlite::open(&path).unwrap().query_row(tables, [], |row| row.get(0)).unwrap();
        assert_eq!(tables, "jobs");
    }

    #[tokio::test]
    async fn a_write_that_panics_fails_alone_and_the_next_one_succeeds() {
        let folder = tempfile::tempdir().unwrap();
        let url = format!("sqlite://{}/a.db", folder.path().display());
        let database = Database::open(&url, &StoreOptions::default()).await.unwrap();
        let insert = |tx: &mut Tx<'_>| {
            tx.insert("expired_jobs", &[("id", "a".into()), ("owner", "".into()), ("expired_at", 0.into())])
        };
        let panicked = database.write(move |tx| insert(tx).map(|()| panic!("as asked"))).await;
        assert!(matches!(panicked, Err(StoreError::Internal(_))), "{panicked:?}");
        assert!(!database.read(|tx| tx.exists("SELECT 1 FROM expired_jobs", &[])).await.unwrap(), "rolled back");
        database.check_writer().unwrap();
        database.write(insert).await.unwrap();
        database.close().await;
        assert!(matches!(database.check_writer(), Err(StoreError::Unavailable(_))));
    }

    #[tokio::test(flavor = "multi_thread", worker_threads = 2)]
    async fn a_failed_write_does_not_affect_the_others_of_its_group() {
        let folder = tempfile::tempdir().unwrap();
        let url = format!("sqlite://{}/a.db", folder.path().display());
        let database = std::sync::Arc::new(Database::open(&url, &StoreOptions::default()).await.unwrap());
        // The other writes queue up while the writer is blocked.
        let (begun, beginning) = oneshot::channel();
        let begun = std::sync::Mutex::new(Some(begun));
        let (release, released) = sync_channel::<()>(0);
        let released = std::sync::Mutex::new(released);
        let held = database.clone();
        let holding = tokio::spawn(async move {
            let hold = move |_: &mut Tx<'_>| {
                let _ = begun.lock().unwrap().take().map(|begun| begun.send(()));
                let _ = released.lock().unwrap().recv();
                Ok(())
            };
            held.write(hold).await
        });
        beginning.await.unwrap();
        let mut writes = Vec::new();
        for id in ["a", "b", "c", "d"] {
            let write = move |tx: &mut Tx<'_>| {
                tx.insert("expired_jobs", &[("id", id.into()), ("owner", "".into()), ("expired_at", 0.into())])?;
                if id == "c" { Err(StoreError::Contended("as asked".into())) } else { Ok(()) }
            };
            let mut write = Box::pin({
                let database = database.clone();
                async move { database.write(write).await }
            });
            // The first poll puts the write into the writer's channel.
            assert!(write.as_mut().poll(&mut Context::from_waker(Waker::noop())).is_pending());
            writes.push(write);
        }
        drop(release);
        holding.await.unwrap().unwrap();
        for (write, fails) in writes.into_iter().zip([false, false, true, false]) {
            assert_eq!(write.await.is_err(), fails);
        }
        let read = |tx: &mut Tx<'_>| {
            let rows = tx.rows("SELECT id FROM expired_jobs ORDER BY id", &[])?;
            rows.iter().map(|row| row.get("id")).collect::<Result<Vec<String>>>()
        };
        assert_eq!(database.read(read).await.unwrap(), ["a", "b", "d"]);
        database.close().await;
        let after = database.read(|tx| tx.exists("SELECT 1", &[])).await;
        assert!(matches!(after, Err(StoreError::Unavailable(_))));
        assert!(!folder.path().join("a.db-wal").exists(), "closing leaves one file");
    }
}
