//! A fixed number of threads, each with its own database connection, which is opened at the first use.

use std::sync::Arc;
use std::time::Duration;

use tokio::sync::Semaphore;

use super::{Result, StoreError};
use crate::threads::{Threads, WorkFailure};

type Open<C> = Arc<dyn Fn() -> Result<C> + Send + Sync>;

/// Stack size of the threads in bytes, which is the default of Rust's standard library.
const STACK_BYTES: usize = 2 << 20;

pub(super) struct Pool<C> {
    open: Open<C>,
    /// Has a permit for each free thread.
    permits: Arc<Semaphore>,
    /// Time that a caller waits for a free thread. `None` means no limit.
    patience: Option<Duration>,
    threads: Threads<Option<C>>,
}

impl<C> std::fmt::Debug for Pool<C> {
    fn fmt(&self, formatter: &mut std::fmt::Formatter<'_>) -> std::fmt::Result {
        formatter.debug_struct("Pool").field("permits", &self.permits).finish_non_exhaustive()
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
        Ok(Self {
            open: Arc::new(open),
            permits: Arc::new(Semaphore::new(threads)),
            patience,
            threads: Threads::start(name, threads, STACK_BYTES)?,
        })
    }

    /// Runs `work` on a free thread. The work is completed even if the caller goes away.
    pub(super) async fn run<T: Send + 'static>(
        &self,
        work: impl FnOnce(&mut C) -> Result<T> + Send + 'static,
    ) -> Result<T> {
        let permit = Arc::clone(&self.permits).acquire_owned();
        let permit = match self.patience {
            None => permit.await,
            Some(patience) => tokio::time::timeout(patience, permit).await.map_err(|_| {
                StoreError::Unavailable(format!("no database connection was free for {} s", patience.as_secs()))
            })?,
        };
        let permit = permit.map_err(|_| closed())?;
        let open = Arc::clone(&self.open);
        let run = move |connection: &mut Option<C>| {
            let _permit = permit;
            match connection {
                Some(connection) => work(connection),
                none => work(none.insert(open()?)),
            }
        };
        // After a panic the connection may have an open transaction. The thread closes it, which rolls it back.
        self.threads.run(run).await.unwrap_or_else(|lost| match lost {
            WorkFailure::Panicked => Err(StoreError::Internal("a statement of the store panicked".into())),
            WorkFailure::Closed => Err(closed()),
        })
    }

    /// Waits for running work and closes every connection. Later work fails with `Unavailable`.
    pub(super) async fn close(&self) {
        self.permits.close();
        self.threads.close().await;
    }
}

pub(super) fn closed() -> StoreError {
    StoreError::Unavailable("the store is closed".into())
}
