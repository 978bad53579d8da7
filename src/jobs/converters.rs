//! The threads that compute for more than a moment and are no solvers: they read large bodies and write meshes in the formats. A
//! few, so that neither can take every core from the solvers and the server, nor much memory; the same ones always, since an
//! allocator keeps for each thread what it once needed.

use super::JobsError;
use super::worker::STACK_BYTES;
use std::panic::{AssertUnwindSafe, catch_unwind};
use std::sync::mpsc::{Receiver, Sender, channel};
use std::sync::{Arc, Mutex, PoisonError};
use tokio::sync::{OwnedSemaphorePermit, Semaphore, oneshot};

type Work = Box<dyn FnOnce() + Send>;

#[derive(Debug)]
pub struct Converters {
    /// One for each thread.
    places: Arc<Semaphore>,
    /// As many waiting in it at most as there are places.
    work: Sender<Work>,
}

/// One of the threads, until it is used or dropped.
#[derive(Debug)]
pub struct Place<'c> {
    permit: OwnedSemaphorePermit,
    converters: &'c Converters,
}

impl Converters {
    #[must_use]
    pub fn new(threads: usize) -> Self {
        let (work, received) = channel();
        let received = Arc::new(Mutex::new(received));
        let started = (0..threads).filter(|_| start(received.clone())).count();
        let places = Semaphore::new(started);
        if started == 0 {
            places.close();
        }
        Self { places: Arc::new(places), work }
    }

    /// Waits for a thread that is free.
    ///
    /// # Errors
    /// [`JobsError::Internal`] if there is none at all.
    pub async fn place(&self) -> Result<Place<'_>, JobsError> {
        let permit = self.places.clone().acquire_owned().await.map_err(|_| gone())?;
        Ok(Place { permit, converters: self })
    }
}

impl Place<'_> {
    /// Runs `work` there. It keeps the place until it has ended, even if the caller goes away, and is not begun for one that has gone.
    ///
    /// # Errors
    /// [`JobsError::Internal`] if it panics.
    pub async fn run<T: Send + 'static>(self, work: impl FnOnce() -> T + Send + 'static) -> Result<T, JobsError> {
        let (answer, answered) = oneshot::channel();
        let permit = self.permit;
        let run = move || {
            if !answer.is_closed() {
                // Nothing that it touched is used after a panic. A caller that went away does not need the answer.
                let _ = answer.send(catch_unwind(AssertUnwindSafe(work)));
            }
            drop(permit);
        };
        self.converters.work.send(Box::new(run)).map_err(|_| gone())?;
        answered.await.map_err(|_| gone())?.map_err(|_| {
            tracing::error!("a conversion panicked");
            JobsError::Internal("a conversion ran into a defect of this server".into())
        })
    }
}

/// Starts a thread, which ends when the sender is gone. False if the machine gives no more.
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

fn gone() -> JobsError {
    JobsError::Internal("this server cannot compute any more".into())
}

#[cfg(test)]
mod tests {
    use super::*;
    use futures_util::FutureExt;

    #[tokio::test]
    async fn work_keeps_its_place_when_its_caller_goes_away() {
        let converters = Converters::new(2);
        let (closed, gate) = channel::<()>();
        let gate = Arc::new(Mutex::new(gate));
        for _ in 0..2 {
            let (begun, beginning) = oneshot::channel();
            let gate = gate.clone();
            let run = converters.place().await.unwrap().run(move || {
                begun.send(()).unwrap();
                gate.lock().unwrap().recv()
            });
            tokio::select! {
                _ = run => panic!("the gate is closed"),
                begun = beginning => begun.unwrap(),
            }
        }
        assert!(converters.place().now_or_never().is_none());
        drop(closed);
        assert_eq!(converters.place().await.unwrap().run(|| 7).await.unwrap(), 7);
    }

    #[tokio::test]
    async fn a_panic_is_an_error_and_the_thread_goes_on() {
        let converters = Converters::new(1);
        let panicked = converters.place().await.unwrap().run(|| panic!("as asked")).await;
        assert!(matches!(panicked, Err(JobsError::Internal(_))));
        assert_eq!(converters.place().await.unwrap().run(|| 7).await.unwrap(), 7);
    }
}
