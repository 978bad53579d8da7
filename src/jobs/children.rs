//! The child processes that solve large jobs ([`child`]). The system keeps their limits of memory, and a child that
//! crashes, does not answer or is killed costs only its own job.
//!
//! Only the audit can make a [`Solved`](plateau_engine::solved::Solved), but this law ends at the pipe: the service
//! believes a child that its result was audited, because both are the same program. The hash of the archive shows that
//! the bytes arrived whole.

use super::child::{self, Assignment, Message, frame};
use super::memory::Share;
use super::progress::SolverLink;
use super::solving::SolverEnd;
use crate::config::Config;
use crate::store::Claimed;
use crate::wire::job::JobFailure;
use plateau_archive::Archive;
use rustix::param::{clock_ticks_per_second, page_size};
use rustix::process::Signal;
use sha2::{Digest, Sha256};
use std::collections::BTreeSet;
use std::io;
use std::os::unix::process::ExitStatusExt;
use std::path::Path;
use std::process::{ExitStatus, Stdio};
use std::sync::{Mutex, MutexGuard, PoisonError};
use std::time::Duration;
use tokio::io::{AsyncRead, AsyncReadExt, AsyncWriteExt, BufReader};
use tokio::process::{ChildStdin, ChildStdout, Command};
use tokio::task::{JoinHandle, spawn_blocking};

/// Path of the running file itself. An upgrade may have put another version at the file's own path.
const PROGRAM: &str = "/proc/self/exe";
/// Environment of a child, so that its allocators take little address space in advance. By default mimalloc takes 1 GiB
/// at once, and the C library 64 MiB for each thread, which would be more than most jobs need.
const ENVIRONMENT: [(&str, &str); 2] = [("MIMALLOC_ARENA_RESERVE", "64M"), ("MALLOC_ARENA_MAX", "1")];
/// Signals that come from outside of a process. Other signals follow a fault of its own.
const FROM_OUTSIDE: [Signal; 5] = [Signal::HUP, Signal::INT, Signal::KILL, Signal::QUIT, Signal::TERM];
/// Time for a child to end after its output was closed.
const EXIT_PATIENCE: Duration = Duration::from_secs(10);
/// Length that a message may have however small the job is.
const LEAST_MOST_BYTES: u64 = 1 << 20;
/// Length of the end of a child's standard error that is logged.
const SAID_BYTES: usize = 2048;

/// Name and bytes of the result from which a job begins, or the reason why there is none.
pub(super) type SourceBytes = Result<(Vec<u8>, Vec<u8>), String>;

/// The children of this process.
#[derive(Debug)]
pub(super) struct Children {
    /// False if the system cannot start them, such as without `/proc`.
    pub possible: bool,
    ids: Mutex<BTreeSet<u32>>,
}

/// A child that has no job yet. It is killed when dropped.
#[derive(Debug)]
pub(super) struct Child {
    process: tokio::process::Child,
    input: ChildStdin,
    output: BufReader<ChildStdout>,
    /// Returns the end of what the child writes to standard error.
    said: JoinHandle<String>,
}

/// The first of two fields of `/proc/PID/stat` with processor time in user and in kernel mode.
#[derive(Clone, Copy)]
enum Ticks {
    Own = 14,
    OfEndedChildren = 16,
}

/// Reason why a child gave no answer.
#[derive(Debug)]
enum Silence {
    /// The output ended early.
    Ended,
    /// The output has what no child writes.
    Unreadable(String),
}

impl From<io::Error> for Silence {
    fn from(error: io::Error) -> Self {
        match error.kind() {
            io::ErrorKind::InvalidData => Self::Unreadable(error.to_string()),
            _ => Self::Ended,
        }
    }
}

impl Children {
    pub fn new() -> Self {
        let possible = Path::new(PROGRAM).exists();
        #[cfg(feature = "test-hooks")]
        let possible = possible && !crate::test_hooks::forbids_children();
        Self { possible, ids: Mutex::default() }
    }

    /// Sets the metrics of memory and processor time to the sums over the service and its children.
    pub fn note_usage(&self) {
        let own = metrics_process::collector::collect();
        let running: Vec<u32> = self.ids().iter().copied().collect();
        if let Some(bytes) = own.resident_memory_bytes {
            let resident = running.iter().filter_map(|id| resident_bytes(*id)).sum::<u64>();
            metrics::gauge!("process_resident_memory_bytes").set((bytes + resident) as f64);
        }
        if let Some(seconds) = own.cpu_seconds_total {
            let own_ticks = running.iter().filter_map(|id| ticks(&id.to_string(), Ticks::Own)).sum::<u64>();
            let all = own_ticks + ticks("self", Ticks::OfEndedChildren).unwrap_or(0);
            metrics::gauge!("process_cpu_seconds_total").set(seconds + all as f64 / clock_ticks_per_second() as f64);
        }
    }

    fn ids(&self) -> MutexGuard<'_, BTreeSet<u32>> {
        // No thread panics while it holds the lock.
        self.ids.lock().unwrap_or_else(PoisonError::into_inner)
    }
}

/// Returns the resident memory of a process.
fn resident_bytes(id: u32) -> Option<u64> {
    let pages = std::fs::read_to_string(format!("/proc/{id}/statm")).ok()?;
    Some(pages.split(' ').nth(1)?.parse::<u64>().ok()? * page_size() as u64)
}

/// Returns the processor time of a process, or that of the process's ended children, in ticks.
fn ticks(process: &str, of: Ticks) -> Option<u64> {
    let stat = std::fs::read_to_string(format!("/proc/{process}/stat")).ok()?;
    // The name of the process is in parentheses. The third field follows.
    let fields = stat.rsplit(") ").next()?.split(' ').skip(of as usize - 3).take(2);
    fields.map(|field| field.parse::<u64>().ok()).sum()
}

impl Child {
    /// Starts a child. It has a process group of its own, so that Ctrl-C in a terminal reaches the service alone. It
    /// does not have the environment of the service, because that may have the password of the database.
    ///
    /// # Errors
    /// Returns the error of the system.
    pub fn start() -> io::Result<Self> {
        let mut command = Command::new(PROGRAM);
        command.arg0("plateau").arg(child::COMMAND).env_clear().envs(ENVIRONMENT).process_group(0).kill_on_drop(true);
        #[cfg(feature = "test-hooks")]
        command.envs(crate::test_hooks::variables());
        command.stdin(Stdio::piped()).stdout(Stdio::piped()).stderr(Stdio::piped());
        let mut process = command.spawn()?;
        let (Some(input), Some(output), Some(errors)) =
            (process.stdin.take(), process.stdout.take(), process.stderr.take())
        else {
            return Err(io::Error::other("the streams of the child are missing"));
        };
        Ok(Self { process, input, output: BufReader::new(output), said: tokio::spawn(last_words(errors)) })
    }

    /// Solves a job, and ends the child. A cancel kills the child at once, because a cancelled job has no result that
    /// would be worth waiting for.
    pub async fn solve(
        mut self,
        children: &Children,
        config: &Config,
        (claimed, source): (&Claimed, impl Future<Output = SourceBytes>),
        link: &SolverLink,
        share: &mut Share,
    ) -> SolverEnd {
        let id = self.process.id().unwrap_or_default();
        children.ids().insert(id);
        let patience = Duration::from_millis(config.jobs.unresponsive_ms);
        let conversation = async {
            let (assignment, source) = assignment(config, claimed, source.await, link);
            let parts = [&frame(&assignment)?, &claimed.request, &source];
            converse(&mut self.input, &mut self.output, parts, assignment.memory_bytes, link, share).await
        };
        let ended = tokio::select! {
            answer = conversation => answer,
            () = link.stopped() => Ok(SolverEnd::Stopped),
            () = tokio::time::sleep(link.remaining().saturating_add(patience)) => {
                tracing::error!("the solver does not answer, and its process is killed");
                Ok(SolverEnd::unresponsive())
            }
        };
        let status = match ended {
            Err(Silence::Ended) => tokio::time::timeout(EXIT_PATIENCE, self.process.wait()).await.ok(),
            _ => None,
        };
        if status.is_none()
            && let Err(error) = self.process.kill().await
        {
            tracing::warn!(%error, "cannot kill the process of a solver");
        }
        children.ids().remove(&id);
        match ended {
            Ok(end) => end,
            Err(silence) => {
                let said = self.said.await.unwrap_or_default();
                without_answer(silence, status.and_then(Result::ok), said.trim())
            }
        }
    }
}

/// Returns a job as it is sent, and the bytes of its source.
fn assignment(config: &Config, claimed: &Claimed, source: SourceBytes, link: &SolverLink) -> (Assignment, Vec<u8>) {
    let (source, bytes) = match source {
        Ok((name, bytes)) => (Ok((name, bytes.len() as u64)), bytes),
        Err(reason) => (Err(reason), Vec::new()),
    };
    let assignment = Assignment {
        id: claimed.id.clone(),
        kind: claimed.kind.clone(),
        limits: config.limits.clone(),
        memory_bytes: claimed.memory_bytes,
        deadline: link.remaining(),
        progress_interval: Duration::from_millis(config.jobs.progress_interval_ms.max(10)),
        request_bytes: claimed.request.len() as u64,
        source,
    };
    (assignment, bytes)
}

/// Sends a job to the child, and listens until it has answered. The budget counts what this process holds for the child
/// beside the estimate of the child's own memory.
async fn converse(
    input: &mut ChildStdin,
    output: &mut BufReader<ChildStdout>,
    parts: [&Vec<u8>; 3],
    mut estimate: u64,
    link: &SolverLink,
    share: &mut Share,
) -> Result<SolverEnd, Silence> {
    let held_bytes = parts.iter().map(|part| part.len() as u64).sum::<u64>();
    share.raise_to(estimate.saturating_add(held_bytes));
    for part in parts {
        input.write_all(part).await?;
    }
    loop {
        match read_message(output, estimate).await? {
            Message::Estimate(bytes) => {
                estimate = estimate.max(bytes);
                share.raise_to(estimate.saturating_add(held_bytes));
            }
            Message::Progress(progress) => link.report(progress),
            Message::Ended { mut end, artefact_bytes } => {
                if let SolverEnd::Solved(answer) = &mut end {
                    share.raise_to(estimate.saturating_add(held_bytes).saturating_add(artefact_bytes));
                    answer.artefact = whole(read_bytes(output, artefact_bytes, estimate).await?).await?;
                }
                return Ok(end);
            }
        }
    }
}

/// Returns the bytes of an archive if they have arrived whole.
async fn whole(artefact: Vec<u8>) -> Result<Vec<u8>, Silence> {
    let check = move || {
        let checksum = Archive::checksum(&artefact);
        let body = &artefact[..artefact.len().saturating_sub(checksum.len())];
        (Sha256::digest(body).as_slice() == checksum).then_some(artefact)
    };
    let checked = spawn_blocking(check).await.ok().flatten();
    checked.ok_or_else(|| Silence::Unreadable("the archive is damaged".into()))
}

async fn read_message(output: &mut BufReader<ChildStdout>, most_bytes: u64) -> Result<Message, Silence> {
    let length = output.read_u32_le().await?;
    let bytes = read_bytes(output, length.into(), most_bytes).await?;
    serde_json::from_slice(&bytes).map_err(|error| Silence::Unreadable(error.to_string()))
}

/// Reads bytes, which cannot be more than a job may take.
async fn read_bytes(output: &mut BufReader<ChildStdout>, length: u64, most_bytes: u64) -> Result<Vec<u8>, Silence> {
    if length > most_bytes.max(LEAST_MOST_BYTES) {
        return Err(Silence::Unreadable(format!("{length} bytes are announced")));
    }
    let mut bytes = Vec::new();
    output.take(length).read_to_end(&mut bytes).await?;
    if bytes.len() as u64 == length { Ok(bytes) } else { Err(Silence::Ended) }
}

/// Reads to the end, and returns the last bytes as text.
async fn last_words(mut errors: impl AsyncRead + Unpin) -> String {
    let (mut said, mut part) = (Vec::new(), [0; SAID_BYTES]);
    while let Ok(length @ 1..) = errors.read(&mut part).await {
        said.extend_from_slice(&part[..length]);
        said.drain(..said.len().saturating_sub(SAID_BYTES));
    }
    String::from_utf8_lossy(&said).into_owned()
}

/// Returns how a job ends whose child gave no answer.
fn without_answer(silence: Silence, status: Option<ExitStatus>, said: &str) -> SolverEnd {
    let signal = status.and_then(|status| status.signal());
    let reason = if let Silence::Unreadable(reason) = &silence { reason } else { "the output ended" };
    tracing::error!(reason, ?status, said, "the process of a solver gave no answer");
    if signal.is_some_and(|signal| FROM_OUTSIDE.iter().any(|outside| outside.as_raw() == signal)) {
        return SolverEnd::Killed;
    }
    // These are the words of Rust's library.
    if said.contains("memory allocation of ") {
        let detail = "solving took more memory than its estimate allows, which is a defect of this server; a coarser \
                      mesh takes less";
        return SolverEnd::failed(JobFailure::MemoryLimit, detail);
    }
    let cause = match silence {
        Silence::Unreadable(_) => "wrote what is no answer",
        Silence::Ended if said.contains("has overflowed its stack") => "overflowed its stack",
        Silence::Ended => "crashed",
    };
    let detail = format!("the solver {cause}, which is a defect of this server; the request is not the cause");
    SolverEnd::failed(JobFailure::SolverCrashed, detail)
}
