//! An attempt at a job. The solver runs on its own thread or in its own process, so that it does not stall the async
//! runtime. Meanwhile the attempt renews the claim and stores progress. When the solver has ended, the attempt stores
//! the outcome.

use super::children::Child;
use super::memory::Share;
use super::progress::SolverLink;
use super::solving::{self, SolverEnd, guarded, text_of};
use super::{Jobs, sources};
use crate::status::Status;
use crate::store::{Artefact, Claimed, Outcome, Renewed, StoreError};
use crate::telemetry::metric;
use plateau_engine::report::SolveError;
use plateau_engine::request::Request;
use plateau_engine::source::Source;
use sha2::{Digest, Sha256};
use std::pin::Pin;
use std::sync::Arc;
use std::time::{Duration, Instant};
use tokio::sync::{OwnedSemaphorePermit, oneshot};
use tracing::{Instrument, Span};

/// Pause after the first failed try to store an outcome. Each further pause is twice as long, up to a third of the
/// lease.
const FIRST_PAUSE: Duration = Duration::from_millis(50);
/// Time that a solver has to end after a shutdown's grace time.
const STOP_PATIENCE: Duration = Duration::from_secs(2);
/// Time for which a shutdown tries to hand a job back. A job that is not handed back loses an attempt.
const HAND_BACK_PATIENCE: Duration = Duration::from_secs(5);
/// Maximum number of tries to store an outcome if the store reports a defect. All other failures of the store are
/// temporary, so they are retried without limit.
const DEFECT_TRIES: usize = 5;

/// A running attempt. While it exists, a cancel reaches its solver and the metrics count it.
#[derive(Debug)]
pub(super) struct Attempt {
    jobs: Jobs,
    id: String,
    kind: String,
    number: i64,
    started: Instant,
    link: Arc<SolverLink>,
    span: Span,
    /// Permit that makes a shutdown wait for this attempt.
    _under_way: Option<OwnedSemaphorePermit>,
}

/// The job of an attempt that begins.
#[derive(Debug, Clone, Copy)]
pub(super) struct Start<'a> {
    pub id: &'a str,
    pub kind: &'a str,
    pub owner: Option<&'a str>,
    /// Number of the attempt.
    pub attempt: i64,
    pub waited_ms: i64,
    pub memory_bytes: u64,
}

/// How an attempt ended.
pub(super) enum AttemptEnd {
    Succeeded,
    Failed(SolveError),
    /// The job was cancelled, deleted or taken over, so the outcome is not stored.
    Dropped,
    HandedBack,
}

/// Reason why the wait for a solver ended.
enum WaitEnd {
    SolverEnded(SolverEnd),
    /// The solver did not end within [`JobsConfig::unresponsive_ms`](crate::config::JobsConfig::unresponsive_ms).
    Unresponsive,
    /// The shutdown's grace time is over.
    ShutDown,
}

/// A running solver.
struct Solver {
    /// Receives how the solver ended. A thread that ends without sending has panicked.
    ended: oneshot::Receiver<SolverEnd>,
    /// False for a solver in a child process, which is killed if it does not answer.
    is_thread: bool,
}

/// Runs one attempt at a claimed job, whose memory is reserved.
pub(super) async fn run(jobs: Jobs, claimed: Claimed, slot: OwnedSemaphorePermit, share: Share) {
    let start = Start {
        id: &claimed.id,
        kind: &claimed.kind,
        owner: claimed.owner.as_deref(),
        attempt: claimed.attempt,
        waited_ms: claimed.waited_ms,
        memory_bytes: claimed.memory_bytes,
    };
    let attempt = Attempt::begin(&jobs, start);
    let span = attempt.span.clone();
    let solver = attempt.spawn_solver(claimed, share);
    async {
        let end = attempt.supervise(solver, slot).await;
        attempt.end(end);
    }
    .instrument(span)
    .await;
}

/// Puts a job that was claimed but cannot be started back into the queue.
pub(super) async fn hand_back(jobs: &Jobs, claimed: &Claimed) {
    if let Err(error) = jobs.store().hand_back(&claimed.id, claimed.attempt).await {
        tracing::warn!(%error, job_id = claimed.id, "cannot hand the job back; its lease will run out");
    }
}

impl Attempt {
    pub(super) fn begin(jobs: &Jobs, start: Start<'_>) -> Self {
        let Start { id, kind, owner, attempt: number, waited_ms, memory_bytes } = start;
        let link = Arc::new(SolverLink::new(Duration::from_millis(jobs.config().jobs.deadline_ms)));
        jobs.running().insert(id, link.clone(), owner, memory_bytes);
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
            link,
            span,
            _under_way: jobs.under_way(),
        }
    }

    pub(super) fn end(self, end: AttemptEnd) {
        let elapsed = self.started.elapsed();
        let elapsed_ms = elapsed.as_secs_f64() * 1e3;
        let status = match end {
            AttemptEnd::HandedBack => return,
            // A cancelled job was counted by its cancel. A job that another worker took over is counted by that worker.
            AttemptEnd::Dropped => {
                self.span.in_scope(|| tracing::info!("ended without a result"));
                return;
            }
            AttemptEnd::Succeeded => {
                self.span.in_scope(|| tracing::info!(status = Status::Succeeded.name(), elapsed_ms, "ended"));
                Status::Succeeded.name()
            }
            AttemptEnd::Failed(error) => {
                let error_type = error.kind.rsplit('/').next().unwrap_or_default().to_owned();
                self.span.in_scope(|| {
                    let status = Status::Failed.name();
                    tracing::info!(status, error_type, detail = error.detail, elapsed_ms, "ended");
                });
                metrics::counter!(metric::FAILURES, "kind" => self.kind.clone(), "type" => error_type).increment(1);
                Status::Failed.name()
            }
        };
        metrics::counter!(metric::JOBS, "kind" => self.kind.clone(), "status" => status).increment(1);
        metrics::histogram!(metric::SOLVE_SECONDS, "kind" => self.kind.clone()).record(elapsed.as_secs_f64());
    }

    /// Solves the request on this thread. The request must be `quick`, because its memory is not reserved.
    pub(super) fn solve(&self, request: &Request, request_hash: &[u8; 32]) -> Option<Outcome> {
        let _entered = self.span.enter();
        let ended = guarded(|| solving::solve(&self.id, request, &self.link));
        note_audit(&ended, &self.kind, || *request_hash);
        ended.outcome().ok()
    }

    fn spawn_solver(&self, claimed: Claimed, share: Share) -> Solver {
        if self.jobs.solves_in_a_child(&claimed) {
            match Child::start() {
                Ok(child) => return self.spawn_in(child, claimed, share),
                Err(error) => tracing::warn!(%error, "cannot start a process for the solver, which runs on a thread"),
            }
        }
        self.spawn_thread(claimed, share)
    }

    fn spawn_in(&self, child: Child, claimed: Claimed, mut share: Share) -> Solver {
        let (sender, ended) = oneshot::channel();
        let (jobs, link) = (self.jobs.clone(), self.link.clone());
        let run = async move {
            let source = sources::bytes(&jobs, &claimed, &link);
            let job = (&claimed, source);
            let end = child.solve(jobs.children(), jobs.config(), job, &link, &mut share).await;
            note_audit(&end, &claimed.kind, || Sha256::digest(&claimed.request).into());
            drop(share);
            // The receiver is gone if a shutdown did not wait for the child.
            let _ = sender.send(end);
        };
        tokio::spawn(run.instrument(self.span.clone()));
        Solver { ended, is_thread: false }
    }

    fn spawn_thread(&self, claimed: Claimed, mut share: Share) -> Solver {
        let (sender, ended) = oneshot::channel();
        let (jobs, link, span) = (self.jobs.clone(), self.link.clone(), self.span.clone());
        let run = move || {
            let _entered = span.enter();
            let ended = guarded(|| read_and_solve(&jobs, &claimed, &link, &mut share));
            note_audit(&ended, &claimed.kind, || Sha256::digest(&claimed.request).into());
            drop(share);
            // The receiver is gone if this solver was given up.
            if sender.send(ended).is_err() {
                tracing::warn!("a solver that was given up has ended");
                jobs.solver_came_back();
            }
        };
        // Tokio reuses idle blocking threads. The slots and the solvers that were given up bound the number that run
        // solvers.
        tokio::task::spawn_blocking(run);
        Solver { ended, is_thread: true }
    }

    /// Renews the claim until the solver ends, and then stores the outcome.
    async fn supervise(&self, mut solver: Solver, slot: OwnedSemaphorePermit) -> AttemptEnd {
        let grace = async {
            self.jobs.shutdown().await;
            tokio::time::sleep(Duration::from_millis(self.jobs.config().http.shutdown_grace_ms)).await;
        };
        let mut grace: Pin<&mut (dyn Future<Output = ()> + Send)> = std::pin::pin!(grace);
        let (ended, slot) = match self.renew_until_solved(&mut solver, &mut grace).await {
            WaitEnd::SolverEnded(ended) => (ended, Some(slot)),
            WaitEnd::Unresponsive => self.give_up(solver, slot),
            WaitEnd::ShutDown => {
                self.link.stop();
                let ended = tokio::time::timeout(STOP_PATIENCE, &mut solver.ended).await.is_ok();
                // A solver that checked the signal recently is not defective: a long factorisation may run for seconds
                // between two checks.
                if ended || !solver.is_thread || self.link.not_looked_for() < self.patience() {
                    return self.hand_back().await;
                }
                self.give_up(solver, slot)
            }
        };
        // The slot is released before the outcome is stored, so that the next solver need not wait for the disk.
        drop(slot);
        match ended.outcome() {
            Ok(outcome) => self.store_outcome(outcome, &mut grace).await,
            Err(SolverEnd::Unread(error)) => {
                let error = text_of(&error);
                tracing::warn!(error, "this version cannot read the request, which is handed back");
                self.jobs.cannot_read(&self.id);
                self.hand_back_as(Some(&error)).await
            }
            Err(SolverEnd::Killed) => self.lose().await,
            Err(_) if self.link.hands_back() => {
                tracing::info!("makes room for the job of another key");
                self.hand_back().await
            }
            Err(_) => AttemptEnd::Dropped,
        }
    }

    /// Gives up a solver that does not answer, unless it has just ended. Its thread goes on and keeps its memory.
    /// Returns the slot, unless the thread keeps it too.
    fn give_up(&self, mut solver: Solver, slot: OwnedSemaphorePermit) -> (SolverEnd, Option<OwnedSemaphorePermit>) {
        // It is counted first, because it may come back at any moment.
        let slot = self.jobs.give_up_solver(slot);
        solver.ended.close();
        if let Ok(ended) = solver.ended.try_recv() {
            self.jobs.solver_came_back();
            return (ended, slot);
        }
        let not_looked_for_ms = self.link.not_looked_for().as_millis() as u64;
        tracing::error!(not_looked_for_ms, "the solver does not answer, and is given up");
        (SolverEnd::unresponsive(), slot)
    }

    /// Ends an attempt whose solver was killed. The attempt counts, and the job is tried
    /// again.
    async fn lose(&self) -> AttemptEnd {
        tracing::warn!("the process of the solver was killed; the attempt counts as lost");
        // If this fails, the lease runs out a little later.
        let _ = self.jobs.store().renew(&self.id, self.number, Duration::ZERO).await;
        AttemptEnd::HandedBack
    }

    fn has_lost_patience(&self) -> bool {
        self.link.asked_to_end_for().is_some_and(|time| time > self.patience())
    }

    /// Time limit for a solver to end after it was asked to end.
    fn patience(&self) -> Duration {
        Duration::from_millis(self.jobs.config().jobs.unresponsive_ms)
    }

    /// Renews the lease and stores progress until the solver has ended, also during an outage of the store.
    async fn renew_until_solved(&self, solver: &mut Solver, grace: &mut (impl Future<Output = ()> + Unpin)) -> WaitEnd {
        let (store, lease) = (self.jobs.store(), self.lease());
        let mut renewal = tokio::time::interval_at(tokio::time::Instant::now() + lease / 3, lease / 3);
        let tick = Duration::from_millis(self.jobs.config().jobs.progress_interval_ms.max(10));
        let mut progress = tokio::time::interval_at(tokio::time::Instant::now() + tick, tick);
        progress.set_missed_tick_behavior(tokio::time::MissedTickBehavior::Delay);
        loop {
            let renewed = tokio::select! {
                ended = &mut solver.ended => {
                    return WaitEnd::SolverEnded(ended.unwrap_or_else(|_| SolverEnd::panicked()));
                }
                _ = progress.tick() => match self.link.take() {
                    _ if solver.is_thread && self.has_lost_patience() => {
                        return WaitEnd::Unresponsive;
                    }
                    Some(progress) => {
                        // Serialization cannot fail because a progress has only strings and finite numbers.
                        let text = serde_json::to_string(&progress).unwrap_or_default();
                        store.progress(&self.id, self.number, &text).await
                    }
                    None => continue,
                },
                _ = renewal.tick() => store.renew(&self.id, self.number, lease).await,
                () = &mut *grace => return WaitEnd::ShutDown,
            };
            match renewed {
                Ok(Renewed::Held) => {}
                Ok(Renewed::Cancelled | Renewed::Lost) => self.link.stop(),
                // The solver goes on even if the lease runs out, because the outage may affect all processes, so that
                // none takes the job over. If one has taken it over, the next renewal says so.
                Err(error) => tracing::warn!(%error, "cannot reach the store"),
            }
        }
    }

    /// Stores an outcome. If the store cannot be written, the attempt holds the outcome, renews the claim and tries
    /// again with growing pauses, so that no attempt is lost. Trying again is safe because the store checks the
    /// attempt's number. The store also says whether an earlier try was stored although its answer was lost.
    async fn store_outcome(&self, outcome: Outcome, grace: &mut (impl Future<Output = ()> + Unpin)) -> AttemptEnd {
        let (store, lease) = (self.jobs.store(), self.lease());
        let outcome = Arc::new(outcome);
        let (mut pause, mut defects, mut slot) = (FIRST_PAUSE, 0, None);
        loop {
            match store.finish(&self.id, self.number, outcome.clone()).await {
                Ok(true) => return AttemptEnd::of(&outcome),
                Ok(false) => return AttemptEnd::Dropped,
                Err(error) => {
                    tracing::warn!(%error, "cannot store the outcome; it is held and tried again");
                    defects += usize::from(matches!(error, StoreError::Internal(_)));
                    if defects == DEFECT_TRIES {
                        return AttemptEnd::Dropped;
                    }
                }
            }
            // A held outcome occupies a solver's slot, so that the number of held outcomes stays at most the number of
            // solvers.
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
            // The next try tells what became of the job, so the answer is not needed.
            let _ = store.renew(&self.id, self.number, lease).await;
            pause = (2 * pause).min(lease / 3);
        }
    }

    async fn hand_back(&self) -> AttemptEnd {
        self.hand_back_as(None).await
    }

    /// Hands the job back. `unread` is the error of a job that this version cannot read.
    async fn hand_back_as(&self, unread: Option<&str>) -> AttemptEnd {
        let (store, given_up) = (self.jobs.store(), Instant::now() + HAND_BACK_PATIENCE);
        loop {
            let handed_back = match unread {
                Some(error) => store.hand_back_unread(&self.id, self.number, error).await,
                None => store.hand_back(&self.id, self.number).await,
            };
            match handed_back {
                Ok(true) => tracing::info!("handed back"),
                Ok(false) => return AttemptEnd::Dropped,
                Err(error) if Instant::now() < given_up => {
                    tracing::warn!(%error, "cannot hand the job back; it is tried again");
                    tokio::time::sleep(FIRST_PAUSE).await;
                    continue;
                }
                Err(error) => tracing::warn!(%error, "cannot hand the job back; its lease will run out"),
            }
            return AttemptEnd::HandedBack;
        }
    }

    fn lease(&self) -> Duration {
        Duration::from_millis(self.jobs.config().jobs.lease_ms)
    }
}

impl AttemptEnd {
    /// Returns the end of an attempt whose outcome was stored.
    pub(super) fn of(outcome: &Outcome) -> Self {
        match outcome {
            Outcome::Succeeded { .. } => Self::Succeeded,
            // Reading cannot fail, because this process wrote the error.
            Outcome::Failed { error } => Self::Failed(
                serde_json::from_str(error).unwrap_or_else(|defect| SolveError::internal(defect.to_string())),
            ),
        }
    }
}

impl Drop for Attempt {
    fn drop(&mut self) {
        self.jobs.running().remove(&self.id, &self.link);
        metrics::gauge!(metric::RUNNING).decrement(1.0);
    }
}

fn read_and_solve(jobs: &Jobs, claimed: &Claimed, link: &SolverLink, share: &mut Share) -> SolverEnd {
    let named = |archive, artefact: Artefact| Source::new(archive, artefact.hash);
    let find = |_: &str| sources::claimed(jobs, claimed.source.as_deref(), link, named);
    match solving::read(&claimed.kind, &claimed.request, &jobs.config().limits.requests(), &find, link) {
        Ok(request) => {
            share.raise_to(request.memory_bytes);
            solving::solve(&claimed.id, &request, link)
        }
        Err(end) => end,
    }
}

/// Logs and counts a result that the audit withheld. The log has the hash of the request as the store has it, never the
/// request itself.
fn note_audit(ended: &SolverEnd, kind: &str, request_hash: impl FnOnce() -> [u8; 32]) {
    let SolverEnd::Failed(error) = ended else { return };
    if !error.is_of_the_audit() {
        return;
    }
    let request_hash: String = request_hash().iter().map(|byte| format!("{byte:02x}")).collect();
    tracing::error!(request_hash, detail = error.detail, "the audit withheld the result");
    metrics::counter!(metric::AUDIT_FAILURES, "kind" => kind.to_owned()).increment(1);
}
