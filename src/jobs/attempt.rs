//! One attempt at a job: its solver runs on a thread that stalls nobody, the claim is renewed, progress is stored, and the
//! outcome is stored when the solver has ended.

use super::Jobs;
use super::progress::{Line, Signal};
use super::solve::{self, Solved, Unsolved};
use crate::export::Archive;
use crate::status::Status;
use crate::store::{Claimed, Outcome, Renewed, StoreError};
use crate::telemetry::metric;
use crate::wire::job::JobError;
use crate::wire::{Kind, Rejection, Request};
use std::pin::Pin;
use std::sync::Arc;
use std::time::{Duration, Instant};
use tokio::sync::{OwnedSemaphorePermit, oneshot};
use tracing::{Instrument, Span};

/// Pause after the first failed try to store an outcome; each further one is twice as long, up to a third of the lease.
const FIRST_PAUSE: Duration = Duration::from_millis(50);
/// Tries to store an outcome that the store refuses for a defect. Other failures pass, so they are tried without end.
const DEFECT_TRIES: usize = 5;

/// An attempt under way: counted, known to cancels, and accounted for at its end.
#[derive(Debug)]
pub(super) struct Attempt {
    jobs: Jobs,
    id: String,
    kind: String,
    number: i64,
    started: Instant,
    line: Arc<Line>,
    span: Span,
    /// A shutdown waits for it.
    _under_way: Option<OwnedSemaphorePermit>,
}

/// How an attempt ended.
pub(super) enum End {
    Finished(Status),
    /// The job was cancelled, deleted or taken over, so nobody wants the outcome.
    Dropped,
    HandedBack,
}

/// How a solver ended.
enum Ended {
    Solved(Box<Solved>),
    Unsolved(Unsolved),
    Rejected(Rejection),
    Panicked,
}

/// Receives the outcome of a solver's thread; none if nobody wants it. A thread that ends without sending has panicked.
type Solver = oneshot::Receiver<Option<Outcome>>;

/// Attempts a claimed job.
pub(super) async fn run(jobs: Jobs, claimed: Claimed, slot: OwnedSemaphorePermit) {
    let attempt = Attempt::begin(&jobs, &claimed.id, &claimed.kind, claimed.attempt, claimed.waited_ms);
    let span = attempt.span.clone();
    let solver = attempt.spawn_solver(claimed);
    async {
        let end = attempt.supervise(solver, slot).await;
        attempt.end(end);
    }
    .instrument(span)
    .await;
}

impl Attempt {
    pub(super) fn begin(jobs: &Jobs, id: &str, kind: &str, number: i64, waited_ms: i64) -> Self {
        let line = Arc::new(Line::new(Duration::from_millis(jobs.config().jobs.deadline_ms)));
        jobs.running().insert(id, line.clone());
        metrics::gauge!(metric::RUNNING).increment(1.0);
        let waited_s = waited_ms as f64 / 1e3;
        metrics::histogram!(metric::WAIT_SECONDS, "kind" => kind.to_owned()).record(waited_s);
        let span = tracing::info_span!("job", job_id = %id, kind = %kind, attempt = number);
        span.in_scope(|| tracing::info!(waited_s, "started"));
        Self {
            jobs: jobs.clone(),
            id: id.to_owned(),
            kind: kind.to_owned(),
            number,
            started: Instant::now(),
            line,
            span,
            _under_way: jobs.under_way(),
        }
    }

    pub(super) fn end(self, end: End) {
        let status = match end {
            End::HandedBack => return,
            // A cancelled job was counted where it was cancelled; a job that another worker took over is counted there.
            End::Dropped => {
                self.span.in_scope(|| tracing::info!("ended without a result"));
                return;
            }
            End::Finished(status) => status.name(),
        };
        let elapsed = self.started.elapsed();
        self.span.in_scope(|| tracing::info!(status, elapsed_ms = elapsed.as_secs_f64() * 1e3, "ended"));
        metrics::counter!(metric::JOBS, "kind" => self.kind.clone(), "status" => status).increment(1);
        metrics::histogram!(metric::SOLVE_SECONDS, "kind" => self.kind.clone()).record(elapsed.as_secs_f64());
    }

    /// Solves on this thread. The caller has a share of the memory for it.
    pub(super) fn solve(&self, request: &Request) -> Option<Outcome> {
        let _entered = self.span.enter();
        outcome(guarded(|| solve(request, &self.line)))
    }

    fn spawn_solver(&self, claimed: Claimed) -> Solver {
        let (sender, receiver) = oneshot::channel();
        let (jobs, line, span) = (self.jobs.clone(), self.line.clone(), self.span.clone());
        let run = move || {
            let _entered = span.enter();
            let ended = guarded(|| read_and_solve(&jobs, &claimed, &line));
            // Nobody listens any more if the server is going down.
            let _ = sender.send(outcome(ended));
        };
        // Runs on a thread that an earlier solver left, if there is one; there are as many as slots.
        tokio::task::spawn_blocking(run);
        receiver
    }

    /// Keeps the claim alive until the solver ends, and stores the outcome.
    async fn supervise(&self, mut solver: Solver, slot: OwnedSemaphorePermit) -> End {
        let grace = async {
            self.jobs.shutdown().await;
            tokio::time::sleep(Duration::from_millis(self.jobs.config().http.shutdown_grace_ms)).await;
        };
        let mut grace: Pin<&mut (dyn Future<Output = ()> + Send)> = std::pin::pin!(grace);
        let Some(ended) = self.renew_until_solved(&mut solver, &mut grace).await else {
            self.line.stop();
            let _ = (&mut solver).await;
            return self.hand_back().await;
        };
        // The disk need not keep the next solver waiting.
        drop(slot);
        match ended {
            Some(outcome) => self.store_outcome(outcome, &mut grace).await,
            None => End::Dropped,
        }
    }

    /// Renews the lease and stores progress until the solver has ended; `None` if a shutdown's grace time ended first.
    async fn renew_until_solved(
        &self,
        solver: &mut Solver,
        grace: &mut (impl Future<Output = ()> + Unpin),
    ) -> Option<Option<Outcome>> {
        let (store, lease) = (self.jobs.store(), self.lease());
        let mut renewal = tokio::time::interval_at(tokio::time::Instant::now() + lease / 3, lease / 3);
        let tick = Duration::from_millis(self.jobs.config().jobs.progress_interval_ms.max(10));
        let mut progress = tokio::time::interval_at(tokio::time::Instant::now() + tick, tick);
        progress.set_missed_tick_behavior(tokio::time::MissedTickBehavior::Delay);
        let mut held_until = Instant::now() + lease;
        loop {
            let renewed = tokio::select! {
                ended = &mut *solver => return Some(ended.unwrap_or_else(|_| outcome(Ended::Panicked))),
                _ = progress.tick() => match self.line.take() {
                    Some(progress) => {
                        // A progress is strings and finite numbers only.
                        let text = serde_json::to_string(&progress).unwrap_or_default();
                        store.progress(&self.id, self.number, &text).await
                    }
                    None => continue,
                },
                _ = renewal.tick() => {
                    let renewed = store.renew(&self.id, self.number, lease).await;
                    if matches!(renewed, Ok(Renewed::Held)) {
                        held_until = Instant::now() + lease;
                    }
                    renewed
                }
                () = &mut *grace => return None,
            };
            match renewed {
                Ok(Renewed::Held) => {}
                Ok(Renewed::Cancelled | Renewed::Lost) => self.line.stop(),
                Err(error) => {
                    tracing::warn!(%error, "cannot reach the store");
                    if Instant::now() > held_until {
                        // Another worker may have the job by now.
                        self.line.stop();
                    }
                }
            }
        }
    }

    /// Stores an outcome. A store that cannot be written costs no attempt: the outcome is held, the claim is renewed, and
    /// storing is tried again with growing pauses. The fence of the attempt makes trying again safe.
    async fn store_outcome(&self, outcome: Outcome, grace: &mut (impl Future<Output = ()> + Unpin)) -> End {
        let (store, lease) = (self.jobs.store(), self.lease());
        let status = outcome.status();
        let outcome = Arc::new(outcome);
        let (mut pause, mut defects, mut slot) = (FIRST_PAUSE, 0, None);
        loop {
            match store.finish(&self.id, self.number, outcome.clone()).await {
                Ok(true) => return End::Finished(status),
                Ok(false) => return End::Dropped,
                Err(error) => {
                    tracing::warn!(%error, "cannot store the outcome; it is held and tried again");
                    defects += usize::from(matches!(error, StoreError::Internal(_)));
                    if defects == DEFECT_TRIES {
                        return End::Dropped;
                    }
                }
            }
            // A held outcome takes a solver's slot, so that no more of them gather than there are solvers.
            let waited = async {
                let until = tokio::time::Instant::now() + pause;
                if slot.is_none() {
                    let slots = self.jobs.slots();
                    slot = tokio::time::timeout_at(until, slots.acquire_owned()).await.ok().and_then(Result::ok);
                }
                tokio::time::sleep_until(until).await;
            };
            tokio::select! {
                () = waited => {}
                () = &mut *grace => return self.hand_back().await,
            }
            match store.renew(&self.id, self.number, lease).await {
                Ok(Renewed::Cancelled | Renewed::Lost) => return End::Dropped,
                Ok(Renewed::Held) | Err(_) => {}
            }
            pause = (2 * pause).min(lease / 3);
        }
    }

    async fn hand_back(&self) -> End {
        match self.jobs.store().hand_back(&self.id, self.number).await {
            Ok(true) => tracing::info!("handed back"),
            Ok(false) => return End::Dropped,
            Err(error) => tracing::warn!(%error, "cannot hand the job back; its lease will run out"),
        }
        End::HandedBack
    }

    fn lease(&self) -> Duration {
        Duration::from_millis(self.jobs.config().jobs.lease_ms)
    }
}

impl Drop for Attempt {
    fn drop(&mut self) {
        self.jobs.running().remove(&self.id, &self.line);
        metrics::gauge!(metric::RUNNING).decrement(1.0);
    }
}

fn read_and_solve(jobs: &Jobs, claimed: &Claimed, line: &Line) -> Ended {
    let Some(kind) = Kind::from_name(&claimed.kind) else {
        let detail = "this version does not know this kind of job";
        return Ended::Unsolved(Unsolved::Failed(JobError::new("unknown-kind", detail, Vec::new())));
    };
    let request = match Request::read_stored(kind, &claimed.request, &jobs.config().limits) {
        Ok(request) => request,
        Err(rejection) => return Ended::Rejected(rejection),
    };
    let wanted = || line.signal() == Signal::Continue;
    let Some(_share) = jobs.memory().share(request.memory_bytes, wanted) else {
        return Ended::Unsolved(match line.signal() {
            Signal::Deadline => Unsolved::deadline(),
            Signal::Cancel | Signal::Continue => Unsolved::Cancelled,
        });
    };
    solve(&request, line)
}

fn solve(request: &Request, line: &Line) -> Ended {
    match solve::solve(request, &|| line.signal(), &|progress| line.report(progress)) {
        Ok(solved) => Ended::Solved(Box::new(solved)),
        Err(unsolved) => Ended::Unsolved(unsolved),
    }
}

/// A solver's panic is a failed job, not a dead worker. Nothing that the solver touched is used afterwards.
fn guarded(solve: impl FnOnce() -> Ended) -> Ended {
    std::panic::catch_unwind(std::panic::AssertUnwindSafe(solve)).unwrap_or_else(|_| {
        tracing::error!("the solver panicked");
        Ended::Panicked
    })
}

/// The outcome to store; `None` if nobody wants one.
fn outcome(ended: Ended) -> Option<Outcome> {
    let error = match ended {
        Ended::Solved(solved) => match solved.archive.to_bytes() {
            Ok(artefact) => {
                return Some(Outcome::Succeeded {
                    statistics: solved.statistics,
                    // Warnings are strings only.
                    warnings: serde_json::to_string(&solved.warnings).unwrap_or_else(|_| "[]".into()),
                    artefact_hash: Archive::checksum(&artefact),
                    artefact,
                    reusable: solved.reproducible,
                });
            }
            Err(defect) => JobError::new("internal", defect.to_string(), Vec::new()),
        },
        Ended::Unsolved(Unsolved::Cancelled) => return None,
        Ended::Unsolved(Unsolved::Failed(error)) => error,
        Ended::Rejected(rejection) => {
            let errors = match rejection {
                Rejection::Malformed(_) => Vec::new(),
                Rejection::Invalid(errors) | Rejection::TooLarge(errors) => errors,
            };
            JobError::new("refused", "see errors", errors)
        }
        Ended::Panicked => {
            let detail = "the solver ran into a defect of this server; the request is not to blame";
            JobError::new("solver-panicked", detail, Vec::new())
        }
    };
    // An error is strings only.
    Some(Outcome::Failed { error: serde_json::to_string(&error).unwrap_or_default() })
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_solver_that_panics_is_a_failed_job_that_says_so() {
        let ended = guarded(|| panic!("a defect"));
        let Some(Outcome::Failed { error }) = outcome(ended) else { panic!("should have failed") };
        let error: JobError = serde_json::from_str(&error).unwrap();
        assert_eq!(error.kind, "/problems/solver-panicked");
    }

    #[test]
    fn a_cancelled_solver_has_no_outcome_and_one_past_its_deadline_a_failed_one() {
        assert!(outcome(Ended::Unsolved(Unsolved::Cancelled)).is_none());
        assert!(matches!(outcome(Ended::Unsolved(Unsolved::deadline())), Some(Outcome::Failed { .. })));
    }
}
