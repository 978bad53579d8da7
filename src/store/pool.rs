//! A fixed number of threads, each with its own database connection, which is opened at the first use.

use std::fmt;
use std::panic::{AssertUnwindSafe, catch_unwind};
use std::sync::mpsc::{Receiver, Sender, channel};
use std::sync::{Arc, Mutex, MutexGuard, PoisonError};
use std::thread::JoinHandle;
use std::time::Duration;

use tokio::sync::{Semaphore, oneshot};

use super::{Result, StoreError};

/// Work that runs on one of the threads and gets that thread's connection.
type Work<C> = Box<dyn FnOnce(&mut Option<C>) + Send>;
type Open<C> = Arc<dyn Fn() -> Result<C> + Send + Sync>;

pub(super) struct Pool<C> {
    open: Open<C>,
    /// One permit for each thread.
    threads: Arc<Semaphore>,
    /// Time that a caller waits for a free thread. `None` means no limit.
    patience: Option<Duration>,
    running: Mutex<Option<Running<C>>>,
}

struct Running<C> {
    work: Sender<Work<C>>,
    threads: Vec<JoinHandle<()>>,
}

impl<C> fmt::Debug for Pool<C> {
    fn fmt(&self, formatter: &mut fmt::Formatter<'_>) -> fmt::Result {
        formatter.debug_struct("Pool").field("threads", &self.threads).finish_non_exhaustive()
    }
}

impl<C: 'static> Pool<C> {
    /// Starts `threads` threads whose connections come from `open`.
    pub(super) fn start(
        name: &str,
        threads: usize,
        patience: Option<Duration>,
        open: impl Fn() -> Result<C> + Send + Sync + 'static,
    ) -> Result<Self> {
        let (work, received) = channel::<Work<C>>();
        let received = Arc::new(Mutex::new(received));
        let start = |_| {
            let received = Arc::clone(&received);
            std::thread::Builder::new().name(name.into()).spawn(move || run(&received))
        };
        let handles = (0..threads).map(start).collect::<std::io::Result<Vec<_>>>()?;
        Ok(Self {
            open: Arc::new(open),
            threads: Arc::new(Semaphore::new(threads)),
            patience,
            running: Mutex::new(Some(Running { work, threads: handles })),
        })
    }

    /// Runs `work` on a free thread. The work is completed even if the caller goes away.
    pub(super) async fn run<T: Send + 'static>(
        &self,
        work: impl FnOnce(&mut C) -> Result<T> + Send + 'static,
    ) -> Result<T> {
        let permit = Arc::clone(&self.threads).acquire_owned();
        let permit = match self.patience {
            None => permit.await,
            Some(patience) => tokio::time::timeout(patience, permit).await.map_err(|_| {
                StoreError::Unavailable(format!("no database connection was free for {} s", patience.as_secs()))
            })?,
        };
        let permit = permit.map_err(|_| closed())?;
        let (answer, answered) = oneshot::channel();
        let open = Arc::clone(&self.open);
        let run = move |connection: &mut Option<C>| {
            let result = catch_unwind(AssertUnwindSafe(|| {
                if connection.is_none() {
                    *connection = Some(open()?);
                }
                connection.as_mut().map_or_else(|| Err(closed()), work)
            }));
            let result = result.unwrap_or_else(|_| {
                // The connection may have an open transaction. Closing it rolls the transaction back.
                *connection = None;
                Err(StoreError::Internal("a statement of the store panicked".into()))
            });
            drop(permit);
            // If the caller went away, the answer is dropped.
            let _ = answer.send(result);
        };
        match &*self.running() {
            Some(running) => running.work.send(Box::new(run)).map_err(|_| closed())?,
            None => return Err(closed()),
        }
        answered.await.map_err(|_| closed())?
    }

    /// Waits for running work and closes every connection. Later work fails with `Unavailable`.
    pub(super) async fn close(&self) {
        self.threads.close();
        let Some(Running { work, threads }) = self.running().take() else { return };
        drop(work);
        let join = move || threads.into_iter().for_each(|thread| drop(thread.join()));
        // This fails only while the runtime is shutting down. The threads then end by themselves.
        let _ = tokio::task::spawn_blocking(join).await;
    }
}

impl<C> Pool<C> {
    fn running(&self) -> MutexGuard<'_, Option<Running<C>>> {
        // No thread panics while it holds the lock.
        self.running.lock().unwrap_or_else(PoisonError::into_inner)
    }
}

pub(super) fn closed() -> StoreError {
    StoreError::Unavailable("the store is closed".into())
}

/// Runs work until the sender is dropped.
fn run<C>(received: &Mutex<Receiver<Work<C>>>) {
    let mut connection = None;
    loop {
        let next = received.lock().unwrap_or_else(PoisonError::into_inner).recv();
        let Ok(work) = next else { return };
        work(&mut connection);
    }
}
