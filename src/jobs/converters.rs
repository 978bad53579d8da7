//! Threads for computations that take long but are no solvers: reading large bodies and writing meshes in a format.
//! Their number is small, so that conversions cannot take every core from the solvers and the server, nor much memory.
//! They are never replaced, because an allocator keeps for each thread the memory that the thread once needed.
//!
//! The owners who wait for a thread get one in turn. One more thread is only for short work, which therefore does not wait
//! for long work.

use super::JobsError;
use super::turns::{Turn, Turns};
use super::worker::STACK_BYTES;
use std::panic::{AssertUnwindSafe, catch_unwind};
use std::sync::mpsc::{Receiver, Sender, channel};
use std::sync::{Arc, Mutex, PoisonError};
use tokio::sync::oneshot;

type Work = Box<dyn FnOnce() + Send>;

#[derive(Debug)]
pub struct Converters {
    /// One permit for each thread, except for the one for short work.
    threads: Arc<Turns>,
    /// The permit of the thread for short work. `None` if no thread could be started.
    short: Option<Arc<Turns>>,
    /// Queue of work. A sender holds a permit, so the queue is never longer than the number of threads.
    work: Sender<Work>,
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
    permit: Turn,
    converters: &'c Converters,
}

impl Converters {
    /// Starts `threads` threads, and one for short work.
    #[must_use]
    pub fn new(threads: usize) -> Self {
        let (work, received) = channel();
        let received = Arc::new(Mutex::new(received));
        let started = (0..threads + 1).filter(|_| start(received.clone())).count();
        let turns = |permits: usize| Arc::new(Turns::new(permits));
        Self { threads: turns(started.saturating_sub(1)), short: (started > 0).then(|| turns(1)), work }
    }

    /// Waits for a free thread and reserves it.
    ///
    /// # Errors
    /// Returns [`JobsError::Internal`] if no thread could be started.
    pub async fn reserve(&self, owner: Option<&str>, length: Length) -> Result<Reservation<'_>, JobsError> {
        let owner = owner.unwrap_or_default();
        let short = self.short.as_ref().ok_or_else(no_threads)?;
        let permit = match length {
            Length::Long => self.threads.take(owner).await,
            Length::Short => tokio::select! {
                biased;
                permit = self.threads.take(owner) => permit,
                permit = short.take(owner) => permit,
            },
        };
        Ok(Reservation { permit: permit.ok_or_else(no_threads)?, converters: self })
    }
}

impl Reservation<'_> {
    /// Runs `work` on the reserved thread. The reservation lasts until the work has ended, even if the caller goes
    /// away. If the caller is gone before the work begins, the work is skipped.
    ///
    /// # Errors
    /// Returns [`JobsError::Internal`] if the work panics.
    pub async fn run<T: Send + 'static>(self, work: impl FnOnce() -> T + Send + 'static) -> Result<T, JobsError> {
        let (answer, answered) = oneshot::channel();
        let permit = self.permit;
        let run = move || {
            if !answer.is_closed() {
                // After a panic, data that the work touched is not used. If the caller went away, the answer is
                // dropped.
                let _ = answer.send(catch_unwind(AssertUnwindSafe(work)));
            }
            drop(permit);
        };
        self.converters.work.send(Box::new(run)).map_err(|_| no_threads())?;
        answered.await.map_err(|_| no_threads())?.map_err(|_| {
            tracing::error!("a conversion panicked");
            JobsError::Internal("a conversion ran into a defect of this server".into())
        })
    }
}

/// Starts a thread, which ends when the sender is dropped. Returns false if the system cannot start one.
fn start(received: Arc<Mutex<Receiver<Work>>>) -> bool {
    let next = move || received.lock().unwrap_or_else(PoisonError::into_inner).recv();
    let run = move || {
        while let Ok(work) = next() {
            work();
        }
    };
    let started = std::thread::Builder::new().name("converter".into()).stack_size(STACK_BYTES).spawn(run);
    started.inspect_err(|error| tracing::error!(%error, "starting a thread")).is_ok()
}

fn no_threads() -> JobsError {
    JobsError::Internal("this server has no thread for conversions".into())
}

#[cfg(test)]
mod tests {
    use super::*;
    use futures_util::FutureExt;

    #[tokio::test]
    async fn work_keeps_its_thread_reserved_when_its_caller_goes_away() {
        let converters = Converters::new(2);
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
        let converters = Converters::new(1);
        let panicked = converters.reserve(None, Length::Long).await.unwrap().run(|| panic!("as asked")).await;
        assert!(matches!(panicked, Err(JobsError::Internal(_))));
        assert_eq!(converters.reserve(None, Length::Long).await.unwrap().run(|| 7).await.unwrap(), 7);
    }
}
