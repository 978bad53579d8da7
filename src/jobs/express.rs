//! The short way of a submission that is waited for: where no job waits and a solver is free, the request is solved at once.
//!
//! What is solved within a moment is put on disk with its result in one write, so that durability costs one disk sync and not
//! three; what is not is put on disk then, as a running job with a lease like any other. Nothing is promised before: the client
//! has no answer yet, and nobody knows the job. A process that dies in that moment leaves no trace of the submission, as if it
//! had died while it read the body.
//!
//! What is solved within about a millisecond is solved where it was read: a way to another thread and back costs as much.
//!
//! Solvers' slots are given out in turn, to workers as to these; where a job waits, submissions queue up behind it.

use super::memory::Share;
use super::queue::{Submission, Submitted};
use super::worker::{Attempt, End, Work, outcome_of, solve_here, span, spawn_solver, supervise};
use super::{Jobs, JobsError};
use crate::store::{Begun, NewJob, Submitted as Stored};
use crate::wire::Request;
use std::sync::atomic::{AtomicUsize, Ordering};
use std::time::{Duration, Instant};
use tokio::sync::{OwnedSemaphorePermit, oneshot};
use tracing::Instrument;

/// How long a job may be solved, and before that wait for a solver, without being on disk.
const MOMENT: Duration = Duration::from_millis(25);
/// Submissions that may wait for a solver at once, for each solver; others queue up on disk.
const WAITING_PER_SOLVER: usize = 16;

/// Counts those that wait for a solver.
#[derive(Debug, Default)]
pub(super) struct Waiting(AtomicUsize);

/// One of them, until it is dropped.
struct Place<'w>(&'w AtomicUsize);

impl Waiting {
    fn place(&self, most: usize) -> Option<Place<'_>> {
        let taken = self.0.fetch_add(1, Ordering::Relaxed);
        let place = Place(&self.0);
        (taken < most).then_some(place)
    }
}

impl Drop for Place<'_> {
    fn drop(&mut self) {
        self.0.fetch_sub(1, Ordering::Relaxed);
    }
}

impl Jobs {
    /// A solver for a submission that is waited for; none if it must queue up.
    pub(super) async fn solver_at_once(&self, job: &NewJob) -> Result<Option<OwnedSemaphorePermit>, JobsError> {
        let Some(_place) = self.0.waiting.place(WAITING_PER_SOLVER * self.0.solvers) else { return Ok(None) };
        if self.is_shutting_down() || self.0.store.has_answer(job).await? {
            return Ok(None);
        }
        let slot = tokio::time::timeout(MOMENT, self.0.slots.clone().acquire_owned()).await;
        Ok(slot.ok().and_then(Result::ok))
    }

    /// Solves a job and puts it on disk: with its result, or as running if that takes longer than a moment.
    pub(super) async fn solve_at_once(
        &self,
        submission: Submission,
        request: Request,
        submitted_at: Instant,
        slot: OwnedSemaphorePermit,
    ) -> Result<Submitted, JobsError> {
        let span = span(&submission.job.id, &submission.job.kind, 1);
        // One that would have to wait for memory does so on a thread of its own.
        let share = if request.is_quick() { self.0.memory.share(request.memory_bytes(), || false) } else { None };
        if let Some(share) = share {
            return self.solve_here(submission, &request, submitted_at, (slot, share)).instrument(span).await;
        }
        let (answer, answered) = oneshot::channel();
        let jobs = self.clone();
        let work = async move { jobs.begin(submission, request, submitted_at, slot, answer).await };
        // Goes on when the caller goes away.
        tokio::spawn(work.instrument(span));
        answered
            .await
            .unwrap_or_else(|_| Err(JobsError::Internal("a submission ran into a defect of this server".into())))
    }

    /// Solves a job on this thread. Where the caller goes away afterwards, all of it comes to the disk or nothing.
    async fn solve_here(
        &self,
        submission: Submission,
        request: &Request,
        submitted_at: Instant,
        room: (OwnedSemaphorePermit, Share<'_>),
    ) -> Result<Submitted, JobsError> {
        let (id, kind) = (submission.job.id.clone(), submission.job.kind.clone());
        let started_at = Instant::now();
        let attempt = Attempt::begin(self, &id, &kind, milliseconds(started_at - submitted_at));
        let ended = solve_here(request, &attempt.line);
        // The disk need not keep the next one from being solved.
        drop(room);
        // Nobody can have cancelled it.
        let Some((status, outcome)) = ended else {
            return Err(JobsError::Internal("a submission was cancelled before anybody knew it".into()));
        };
        let begun = begun(submitted_at, started_at);
        let stored = self.0.store.submit_ended(submission.job, outcome, begun).await;
        // Refused, or a repetition that came at the same time was first.
        attempt.end(if matches!(stored, Ok(Stored::Created(_))) { End::Finished(status) } else { End::Dropped });
        self.submitted(stored)
    }

    async fn begin(
        &self,
        submission: Submission,
        request: Request,
        submitted_at: Instant,
        slot: OwnedSemaphorePermit,
        answer: oneshot::Sender<Result<Submitted, JobsError>>,
    ) {
        let (id, kind) = (submission.job.id.clone(), submission.job.kind.clone());
        let started_at = Instant::now();
        let attempt = Attempt::begin(self, &id, &kind, milliseconds(started_at - submitted_at));
        let mut solver = spawn_solver(self, Work::Read(Box::new(request)), attempt.line.clone());
        let ended = tokio::time::timeout(MOMENT, &mut solver).await;
        let begun = begun(submitted_at, started_at);
        let lease = Duration::from_millis(self.0.config.jobs.lease_ms);
        let mut slot = Some(slot);
        let (stored, ended) = match ended.ok().map(outcome_of) {
            Some(ended) => {
                slot.take();
                // As above; there would be nothing to keep.
                let Some((status, outcome)) = ended else { return };
                (self.0.store.submit_ended(submission.job, outcome, begun).await, Some(End::Finished(status)))
            }
            None => {
                let worker = format!("{}/at once", self.0.process);
                let stored = match self.off_runtime(|| submission.stored()).await {
                    Ok(Ok(job)) => self.0.store.submit_begun(job, &worker, lease, begun).await,
                    Ok(Err(error)) | Err(error) => {
                        attempt.line.stop();
                        let _ = answer.send(Err(error));
                        return;
                    }
                };
                (stored, None)
            }
        };
        let created = matches!(stored, Ok(Stored::Created(_)));
        // A client that went away does not need its answer.
        let _ = answer.send(self.submitted(stored));
        let end = match (created, ended, slot) {
            (true, Some(end), _) => end,
            (true, None, Some(slot)) => supervise(self, &id, 1, &attempt.line, solver, slot).await,
            _ => {
                attempt.line.stop();
                End::Dropped
            }
        };
        attempt.end(end);
    }
}

fn begun(submitted_at: Instant, started_at: Instant) -> Begun {
    Begun { submitted_ms: milliseconds(submitted_at.elapsed()), started_ms: milliseconds(started_at.elapsed()) }
}

fn milliseconds(duration: Duration) -> i64 {
    i64::try_from(duration.as_millis()).unwrap_or(i64::MAX)
}
