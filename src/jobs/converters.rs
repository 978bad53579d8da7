//! Threads for computations that take long but are no solvers: reading large bodies and writing meshes in a format.
//! Their number is small, so that conversions cannot take every core from the solvers and the server, nor much memory.
//! They are never replaced, because an allocator keeps for each thread the memory that the thread once needed.
//!
//! The owners who wait for a thread get one in turn. One more thread is only for short work, which therefore does not
//! wait for long work.

use super::JobsError;
use super::fair_permits::{FairPermit, FairPermits};
use crate::threads::{STACK_BYTES, Threads, WorkFailure};
use std::io;
use std::sync::Arc;

#[derive(Debug)]
pub struct Converters {
    /// Permits of the threads, except for the thread for short work.
    permits: Arc<FairPermits>,
    /// The permit of the thread for short work.
    short: Arc<FairPermits>,
    threads: Threads<()>,
}

/// Expected length of a computation.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Length {
    /// Up to some tenths of a second.
    Short,
    Long,
}

/// Reservation of one thread, until it is used or dropped.
#[derive(Debug)]
pub struct Reservation<'c> {
    permit: FairPermit,
    converters: &'c Converters,
}

impl Converters {
    /// Starts `threads` threads, and one for short work.
    ///
    /// # Errors
    /// Fails if the system cannot start a thread.
    pub fn start(threads: usize) -> io::Result<Self> {
        let turns = |permits: usize| Arc::new(FairPermits::new(permits));
        let started = Threads::start("converter", threads + 1, STACK_BYTES)?;
        Ok(Self { permits: turns(threads), short: turns(1), threads: started })
    }

    /// Waits for a free thread and reserves it.
    ///
    /// # Errors
    /// Returns [`JobsError::Internal`] if the process is ending.
    pub async fn reserve(&self, owner: Option<&str>, length: Length) -> Result<Reservation<'_>, JobsError> {
        let owner = owner.unwrap_or_default();
        let permit = match length {
            Length::Long => self.permits.take(owner).await,
            Length::Short => tokio::select! {
                biased;
                permit = self.permits.take(owner) => permit,
                permit = self.short.take(owner) => permit,
            },
        };
        Ok(Reservation { permit: permit.ok_or_else(ending)?, converters: self })
    }
}

impl Reservation<'_> {
    /// Runs `work` on the reserved thread. The reservation lasts until the work has ended, even if the caller goes
    /// away.
    ///
    /// # Errors
    /// Returns [`JobsError::Internal`] if the work panics.
    pub async fn run<T: Send + 'static>(self, work: impl FnOnce() -> T + Send + 'static) -> Result<T, JobsError> {
        let permit = self.permit;
        let run = move |_: &mut ()| {
            let _permit = permit;
            work()
        };
        self.converters.threads.run(run).await.map_err(|lost| match lost {
            WorkFailure::Panicked => {
                tracing::error!("a conversion panicked");
                JobsError::Internal("a conversion ran into a defect of this server".into())
            }
            WorkFailure::Closed => ending(),
        })
    }
}

fn ending() -> JobsError {
    JobsError::Internal("this process is ending".into())
}

#[cfg(test)]
mod tests {
    use super::*;
    use futures_util::FutureExt;
    use std::sync::Mutex;
    use std::sync::mpsc::channel;
    use tokio::sync::oneshot;

    #[tokio::test]
    async fn work_keeps_its_thread_reserved_when_its_caller_goes_away() {
        let converters = Converters::start(2).unwrap();
        let reserve = || converters.reserve(None, Length::Long);
        let (closed, gate) = channel::<()>();
        let gate = Arc::new(Mutex::new(gate));
        for _ in 0..2 {
            let (begun, beginning) = oneshot::channel();
            let gate = gate.clone();
            let run = reserve().await.unwrap().run(move || {
                begun.send(()).unwrap();
                gate.lock().unwrap().recv()
            });
            tokio::select! {
                _ = run => panic!("the gate is closed"),
                begun = beginning => begun.unwrap(),
            }
        }
        assert!(reserve().now_or_never().is_none());
        // Short work has a thread of its own.
        assert_eq!(converters.reserve(None, Length::Short).await.unwrap().run(|| 5).await.unwrap(), 5);
        drop(closed);
        assert_eq!(reserve().await.unwrap().run(|| 7).await.unwrap(), 7);
    }

    #[tokio::test]
    async fn a_panic_returns_an_error_and_leaves_the_thread_usable() {
        let converters = Converters::start(1).unwrap();
        let panicked = converters.reserve(None, Length::Long).await.unwrap().run(|| panic!("as asked")).await;
        assert!(matches!(panicked, Err(JobsError::Internal(_))));
        assert_eq!(converters.reserve(None, Length::Long).await.unwrap().run(|| 7).await.unwrap(), 7);
    }
}
