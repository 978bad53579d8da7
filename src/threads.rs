//! A fixed number of threads for work that would block the async runtime. Each thread has a state of its own, such as a
//! connection to a database, and takes one piece of work after the other.

use std::fmt;
use std::io;
use std::panic::{AssertUnwindSafe, catch_unwind};
use std::sync::mpsc::{Receiver, Sender, channel};
use std::sync::{Arc, Mutex, MutexGuard, PoisonError};
use std::thread::{Builder, JoinHandle};

use tokio::sync::oneshot;

/// Stack size of threads that run solvers or conversions. Sparse orderings and Delaunay walks may recurse deeply. A
/// large stack costs only address space.
pub const STACK_BYTES: usize = 64 << 20;

type Work<S> = Box<dyn FnOnce(&mut S) + Send>;

/// Threads that work until they are closed. The number of waiting pieces of work is not limited here, but by the
/// callers.
pub struct Threads<S>(Mutex<Option<Running<S>>>);

struct Running<S> {
    work: Sender<Work<S>>,
    threads: Vec<JoinHandle<()>>,
}

/// Reason for which work has no result.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum WorkFailure {
    Panicked,
    Closed,
}

impl<S> fmt::Debug for Threads<S> {
    fn fmt(&self, formatter: &mut fmt::Formatter<'_>) -> fmt::Result {
        formatter.debug_struct("Threads").finish_non_exhaustive()
    }
}

impl<S: Default + 'static> Threads<S> {
    /// Starts `count` threads with stacks of `stack_bytes`.
    ///
    /// # Errors
    /// Fails if the system cannot start a thread.
    pub fn start(name: &str, count: usize, stack_bytes: usize) -> io::Result<Self> {
        let (work, received) = channel::<Work<S>>();
        let received = Arc::new(Mutex::new(received));
        let start = |_| {
            let received = Arc::clone(&received);
            Builder::new().name(name.into()).stack_size(stack_bytes).spawn(move || run(&received))
        };
        let threads = (0..count).map(start).collect::<io::Result<_>>()?;
        Ok(Self(Mutex::new(Some(Running { work, threads }))))
    }

    /// Runs `work` on a free thread. The work is completed even if the caller goes away. If it panics, the thread gets
    /// a new state.
    pub async fn run<T: Send + 'static>(
        &self,
        work: impl FnOnce(&mut S) -> T + Send + 'static,
    ) -> Result<T, WorkFailure> {
        let (answer, answered) = oneshot::channel();
        let run = move |state: &mut S| {
            let done = catch_unwind(AssertUnwindSafe(|| work(state)));
            if done.is_err() {
                *state = S::default();
            }
            // If the caller went away, the answer is dropped.
            let _ = answer.send(done);
        };
        match &*self.running() {
            Some(running) => running.work.send(Box::new(run)).map_err(|_| WorkFailure::Closed)?,
            None => return Err(WorkFailure::Closed),
        }
        answered.await.map_err(|_| WorkFailure::Closed)?.map_err(|_| WorkFailure::Panicked)
    }

    /// Waits for running work and ends the threads. Later work is lost.
    pub async fn close(&self) {
        let Some(Running { work, threads }) = self.running().take() else { return };
        drop(work);
        let join = move || threads.into_iter().for_each(|thread| drop(thread.join()));
        // This fails only while the runtime is shutting down. The threads then end by themselves.
        let _ = tokio::task::spawn_blocking(join).await;
    }

    fn running(&self) -> MutexGuard<'_, Option<Running<S>>> {
        // No thread panics while it holds the lock.
        self.0.lock().unwrap_or_else(PoisonError::into_inner)
    }
}

/// Runs work until the sender is dropped.
fn run<S: Default>(received: &Mutex<Receiver<Work<S>>>) {
    let mut state = S::default();
    loop {
        let next = received.lock().unwrap_or_else(PoisonError::into_inner).recv();
        let Ok(work) = next else { return };
        work(&mut state);
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[tokio::test]
    async fn a_panic_is_told_and_leaves_the_thread_usable_with_a_new_state() {
        let threads = Threads::<u32>::start("test", 1, 1 << 20).unwrap();
        let count = |state: &mut u32| {
            *state += 1;
            *state
        };
        assert_eq!((threads.run(count).await, threads.run(count).await), (Ok(1), Ok(2)));
        assert_eq!(threads.run(|_| panic!("as asked")).await, Err::<(), _>(WorkFailure::Panicked));
        assert_eq!(threads.run(count).await, Ok(1));
        threads.close().await;
        assert_eq!(threads.run(count).await, Err(WorkFailure::Closed));
    }
}
