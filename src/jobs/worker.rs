//! Workers: claim a job, run its solver on a thread that stalls nobody, renew the claim, store the outcome.

use super::Jobs;
use super::progress::{Line, Signal};
use super::solve::{self, Solved, Unsolved};
use crate::export::Archive;
use crate::store::{Claimed, Outcome, Renewed};
use crate::telemetry::metric;
use crate::wire::job::JobError;
use crate::wire::{Kind, Rejection, Request};
use std::sync::Arc;
use std::time::{Duration, Instant};
use tokio::sync::{OwnedSemaphorePermit, oneshot};
use tracing::Instrument;

/// The stack of the runtime's threads, which solvers run on, and of the converters: they may recurse (sparse orderings, Delaunay
/// walks), and address space is cheap.
pub const STACK_BYTES: usize = 64 << 20;
/// A worker that was told of no work looks for some this often.
const IDLE_POLL: Duration = Duration::from_secs(1);

/// Works until a shutdown is asked for. Any number of these may run, here and in other processes. What an attempt found is
/// stored while the next one is claimed and solved, so that the disk keeps no solver waiting.
pub async fn run(jobs: Jobs, name: String) {
    let Some(_working) = jobs.under_way() else { return };
    let lease = Duration::from_millis(jobs.0.config.jobs.lease_ms);
    let mut work = jobs.0.store.work_signal();
    loop {
        // Submissions that are waited for take turns with what waits in the queue.
        let Ok(slot) = jobs.0.slots.clone().acquire_owned().await else { return };
        if jobs.is_shutting_down() {
            return;
        }
        work.borrow_and_update();
        let pause = match jobs.0.store.claim(&name, lease).await {
            Ok(Some(claimed)) => {
                let span = span(&claimed.id, &claimed.kind, claimed.attempt);
                let jobs = jobs.clone();
                tokio::spawn(async move { attempt(&jobs, &claimed, slot).await }.instrument(span));
                continue;
            }
            Ok(None) => IDLE_POLL,
            Err(error) => {
                tracing::warn!(%error, worker = %name, "cannot claim a job");
                IDLE_POLL
            }
        };
        drop(slot);
        tokio::select! {
            _ = work.changed() => {}
            () = tokio::time::sleep(pause) => {}
            () = jobs.shutdown() => {}
        }
    }
}

/// How a solver's thread ended.
enum Ended {
    Solved(Box<Solved>),
    Unsolved(Unsolved),
    Rejected(Rejection),
    Panicked,
}

/// The span of a job's log lines.
pub(super) fn span(id: &str, kind: &str, attempt: i64) -> tracing::Span {
    tracing::info_span!("job", job_id = %id, kind = %kind, attempt)
}

async fn attempt(jobs: &Jobs, claimed: &Claimed, slot: OwnedSemaphorePermit) {
    let attempt = Attempt::begin(jobs, &claimed.id, &claimed.kind, claimed.waited_ms);
    let work = Work::Stored { kind: claimed.kind.clone(), request: claimed.request.clone() };
    let solver = spawn_solver(jobs, work, attempt.line.clone());
    let end = supervise(jobs, &claimed.id, claimed.attempt, &attempt.line, solver, slot).await;
    attempt.end(end);
}

/// A solver at work: counted, known to cancels, and accounted for at its end.
pub(super) struct Attempt<'j> {
    jobs: &'j Jobs,
    id: &'j str,
    kind: &'j str,
    started: Instant,
    pub(super) line: Arc<Line>,
    /// A shutdown waits for it.
    _under_way: Option<OwnedSemaphorePermit>,
}

impl<'j> Attempt<'j> {
    pub(super) fn begin(jobs: &'j Jobs, id: &'j str, kind: &'j str, waited_ms: i64) -> Self {
        let line = Arc::new(Line::new(Duration::from_millis(jobs.0.config.jobs.deadline_ms)));
        jobs.0.running.insert(id, line.clone());
        metrics::gauge!(metric::RUNNING).increment(1.0);
        let waited_s = waited_ms as f64 / 1e3;
        metrics::histogram!(metric::WAIT_SECONDS, "kind" => kind.to_owned()).record(waited_s);
        tracing::info!(waited_s, "started");
        Self { jobs, id, kind, started: Instant::now(), line, _under_way: jobs.under_way() }
    }

    pub(super) fn end(self, end: End) {
        let status = match end {
            End::HandedBack => return,
            // A cancelled job was counted where it was cancelled; a job that another worker took over is counted there.
            End::Dropped => {
                tracing::info!("ended without a result");
                return;
            }
            End::Finished(status) => status,
        };
        let elapsed = self.started.elapsed();
        tracing::info!(status, elapsed_ms = elapsed.as_secs_f64() * 1e3, "ended");
        metrics::counter!(metric::JOBS, "kind" => self.kind.to_owned(), "status" => status).increment(1);
        metrics::histogram!(metric::SOLVE_SECONDS, "kind" => self.kind.to_owned()).record(elapsed.as_secs_f64());
    }
}

impl Drop for Attempt<'_> {
    fn drop(&mut self) {
        self.jobs.0.running.remove(self.id, &self.line);
        metrics::gauge!(metric::RUNNING).decrement(1.0);
    }
}

pub(super) enum End {
    Finished(&'static str),
    /// The job was cancelled, deleted or taken over: its outcome is nobody's.
    Dropped,
    HandedBack,
}

/// Keeps the claim alive until the solver ends, which frees its slot, and stores what came out.
pub(super) async fn supervise(
    jobs: &Jobs,
    id: &str,
    number: i64,
    line: &Arc<Line>,
    mut solver: Solver,
    slot: OwnedSemaphorePermit,
) -> End {
    let config = &jobs.0.config;
    let store = &jobs.0.store;
    let lease = Duration::from_millis(config.jobs.lease_ms);
    let mut renewal = tokio::time::interval_at(tokio::time::Instant::now() + lease / 3, lease / 3);
    let tick = Duration::from_millis(config.jobs.progress_interval_ms.max(10));
    let mut progress = tokio::time::interval_at(tokio::time::Instant::now() + tick, tick);
    progress.set_missed_tick_behavior(tokio::time::MissedTickBehavior::Delay);
    let mut held_until = Instant::now() + lease;
    let grace = async {
        jobs.shutdown().await;
        tokio::time::sleep(Duration::from_millis(config.http.shutdown_grace_ms)).await;
    };
    let mut grace = std::pin::pin!(grace);
    let ended = loop {
        let renewed = tokio::select! {
            ended = &mut solver => break outcome_of(ended),
            _ = progress.tick() => match line.take() {
                // A progress is strings and finite numbers only.
                Some(progress) => store.progress(id, number, &serde_json::to_string(&progress).unwrap_or_default()).await,
                None => continue,
            },
            _ = renewal.tick() => {
                let renewed = store.renew(id, number, lease).await;
                if matches!(renewed, Ok(Renewed::Held)) {
                    held_until = Instant::now() + lease;
                }
                renewed
            }
            () = &mut grace => {
                line.stop();
                let _ = (&mut solver).await;
                return match store.hand_back(id, number).await {
                    Ok(true) => { tracing::info!("handed back"); End::HandedBack }
                    Ok(false) => End::Dropped,
                    Err(error) => { tracing::warn!(%error, "cannot hand the job back; its lease will run out"); End::HandedBack }
                };
            }
        };
        match renewed {
            Ok(Renewed::Held) => {}
            Ok(Renewed::Cancelled | Renewed::Lost) => line.stop(),
            Err(error) => {
                tracing::warn!(%error, "cannot reach the store");
                if Instant::now() > held_until {
                    // Another worker may have the job by now.
                    line.stop();
                }
            }
        }
    };
    drop(slot);
    let Some((status, outcome)) = ended else { return End::Dropped };
    // A result in hand is worth some patience with the store; the fence makes trying again safe.
    for pause_ms in [50, 200, 1000, 3000, 0] {
        match store.finish(id, number, outcome.clone()).await {
            Ok(true) => return End::Finished(status),
            Ok(false) => return End::Dropped,
            Err(error) => tracing::warn!(%error, "cannot store the outcome"),
        }
        tokio::time::sleep(Duration::from_millis(pause_ms)).await;
    }
    End::Dropped
}

/// What a solver is given.
pub(super) enum Work {
    /// As the store has it.
    Stored { kind: String, request: Vec<u8> },
    /// Read and checked already.
    Read(Box<Request>),
}

/// The outcome of a solver's thread, once it has one; none if nobody wants it.
pub(super) type Solver = oneshot::Receiver<Option<(&'static str, Outcome)>>;

/// What a solver's thread left behind: one that went without a word has panicked.
pub(super) fn outcome_of(
    received: Result<Option<(&'static str, Outcome)>, oneshot::error::RecvError>,
) -> Option<(&'static str, Outcome)> {
    received.unwrap_or_else(|_| outcome(Ended::Panicked))
}

pub(super) fn spawn_solver(jobs: &Jobs, work: Work, line: Arc<Line>) -> Solver {
    let (sender, receiver) = oneshot::channel();
    let limits = jobs.0.config.limits.clone();
    let span = tracing::Span::current();
    let jobs = jobs.clone();
    let run = move || {
        let _entered = span.enter();
        let work = || {
            let request = match work {
                Work::Read(request) => *request,
                Work::Stored { kind, request } => {
                    let Some(kind) = Kind::from_name(&kind) else {
                        let detail = "this version does not know this kind of job";
                        return Ended::Unsolved(Unsolved::Failed(JobError::new("unknown-kind", detail, Vec::new())));
                    };
                    match Request::read(kind, &request, &limits) {
                        Ok((request, _)) => request,
                        Err(rejection) => return Ended::Rejected(rejection),
                    }
                }
            };
            let wanted = || line.signal() == Signal::Continue;
            let Some(_share) = jobs.0.memory.share(request.memory_bytes(), wanted) else {
                return Ended::Unsolved(match line.signal() {
                    Signal::Deadline => Unsolved::deadline(),
                    Signal::Cancel | Signal::Continue => Unsolved::Cancelled,
                });
            };
            solve(&request, &line)
        };
        let ended = guarded(work);
        // Nobody listens any more if the server is going down.
        let _ = sender.send(outcome(ended));
    };
    // On a thread that an earlier solver left, if there is one; there are as many as slots.
    tokio::task::spawn_blocking(run);
    receiver
}

/// Solves on this thread. The caller has a share of the memory for it.
pub(super) fn solve_here(request: &Request, line: &Line) -> Option<(&'static str, Outcome)> {
    outcome(guarded(|| solve(request, line)))
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
fn outcome(ended: Ended) -> Option<(&'static str, Outcome)> {
    let error = match ended {
        Ended::Solved(solved) => {
            let solved = *solved;
            let artefact = solved.archive.to_bytes();
            let outcome = Outcome::Succeeded {
                statistics: solved.statistics,
                // Warnings are strings only.
                warnings: serde_json::to_string(&solved.warnings).unwrap_or_else(|_| "[]".into()),
                artefact_hash: Archive::checksum(&artefact),
                artefact,
                reusable: solved.reproducible,
            };
            return Some(("succeeded", outcome));
        }
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
    Some(("failed", Outcome::Failed { error: serde_json::to_string(&error).unwrap_or_default() }))
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_solver_that_panics_is_a_failed_job_that_says_so() {
        let ended = guarded(|| panic!("a defect"));
        let Some((status, Outcome::Failed { error })) = outcome(ended) else { panic!("should have failed") };
        let error: JobError = serde_json::from_str(&error).unwrap();
        assert_eq!((status, error.kind.as_str()), ("failed", "/problems/solver-panicked"));
    }

    #[test]
    fn a_cancelled_solver_has_no_outcome_and_one_past_its_deadline_a_failed_one() {
        assert!(outcome(Ended::Unsolved(Unsolved::Cancelled)).is_none());
        assert!(matches!(outcome(Ended::Unsolved(Unsolved::deadline())), Some(("failed", _))));
    }
}
