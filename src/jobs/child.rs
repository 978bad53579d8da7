//! The process of one large job. It is this program with the hidden command [`COMMAND`], which the service starts. The
//! job comes on standard input, and progress and the answer leave on standard output.
//!
//! The input stays open while the service wants the answer. Its end ends this process at once, so that nothing is
//! solved for a service that was killed.

use super::progress::SolverLink;
use super::solving::{self, SolverEnd, guarded};
use crate::config::LimitsConfig;
use crate::threads::STACK_BYTES;
use plateau_archive::Archive;
use plateau_engine::report::Progress;
use plateau_engine::source::Source;
use rustix::process::{Resource, Rlimit, Signal, getpid, getrlimit, kill_process, setrlimit};
use serde::de::DeserializeOwned;
use serde::{Deserialize, Serialize};
use std::io::{self, Read, Write};
use std::process::ExitCode;
use std::sync::Arc;
use std::sync::mpsc::{RecvTimeoutError, Sender, channel};
use std::thread::Builder;
use std::time::Duration;

/// Command of the command line that [`run`] implements.
pub(crate) const COMMAND: &str = "solver";

/// Value that is added to the system's measure of which process to kill when memory runs out, as thousandths of the
/// memory. A child then goes before the service unless the service has taken half of the memory more.
const OOM_SCORE: &str = "500";
/// Address space of a child beyond the program, its input, the stack of the solver and the estimate. The allocator
/// takes 64 MiB at once, and each of the three threads has blocks of its own.
const MARGIN_BYTES: u64 = 256 << 20;
/// Address space for a job, relative to its estimate, because address space is more than the memory that is touched, and
/// because a request of an unmeasured shape may take more than its estimate.
const ESTIMATE_FACTOR: f64 = 2.0;

/// A job as the service sends it. The request follows as bytes, and then the source.
#[derive(Debug, Serialize, Deserialize)]
pub(super) struct Assignment {
    pub id: String,
    pub kind: String,
    pub limits: LimitsConfig,
    /// Estimate of the memory that solving takes.
    pub memory_bytes: u64,
    /// Time until the deadline.
    pub deadline: Duration,
    /// Shortest interval between two messages of progress.
    pub progress_interval: Duration,
    pub request_bytes: u64,
    /// Name and length of the result from which the request begins, or the reason why there is none.
    pub source: Result<(Vec<u8>, u64), String>,
}

/// A message of a child.
#[derive(Debug, Serialize, Deserialize)]
pub(super) enum Message {
    /// The estimate of the job's memory by this version, if it is above the stored one.
    Estimate(u64),
    Progress(Progress),
    /// The last message. The archive of a solved job follows as bytes.
    Ended {
        end: SolverEnd,
        artefact_bytes: u64,
    },
}

/// Returns a value as JSON behind its length in four bytes.
pub(super) fn frame(value: &impl Serialize) -> io::Result<Vec<u8>> {
    let mut bytes = vec![0; 4];
    serde_json::to_writer(&mut bytes, value)?;
    let length = u32::try_from(bytes.len() - 4).map_err(io::Error::other)?;
    bytes[..4].copy_from_slice(&length.to_le_bytes());
    Ok(bytes)
}

/// Solves the job on standard input.
pub(crate) fn run() -> ExitCode {
    match work() {
        Ok(()) => ExitCode::SUCCESS,
        Err(error) => {
            eprintln!("{error}");
            ExitCode::FAILURE
        }
    }
}

fn work() -> io::Result<()> {
    // Without the file, the system chooses by the size alone.
    let _ = std::fs::write("/proc/self/oom_score_adj", OOM_SCORE);
    let mut memory = Memory::of_this_process();
    let mut input = io::stdin().lock();
    let assignment: Assignment = read_frame(&mut input)?;
    let request = read_bytes(&mut input, assignment.request_bytes)?;
    let source = match &assignment.source {
        Ok((key, length)) => Ok((key.clone(), read_bytes(&mut input, *length)?)),
        Err(reason) => Err(reason.clone()),
    };
    drop(input);
    let held = request.len() + source.as_ref().map_or(0, |(_, bytes)| bytes.len());
    memory.taken_bytes += held as u64;
    memory.limit(assignment.memory_bytes)?;
    Builder::new().name("input".into()).stack_size(1 << 16).spawn(end_with_the_input)?;

    let link = Arc::new(SolverLink::new(assignment.deadline));
    let (sender, messages) = channel();
    let (tick, solver_link) = (assignment.progress_interval, link.clone());
    let solve = move || {
        let end = guarded(|| solve(&assignment, &request, source, &solver_link, &memory, &sender));
        let artefact_bytes = if let SolverEnd::Solved(answer) = &end { answer.artefact.len() } else { 0 };
        // The receiver lives as long as this process.
        let _ = sender.send(Message::Ended { end, artefact_bytes: artefact_bytes as u64 });
    };
    Builder::new().name("solver".into()).stack_size(STACK_BYTES).spawn(solve)?;

    let mut output = io::stdout().lock();
    loop {
        let message = match messages.recv_timeout(tick) {
            Ok(message) => message,
            Err(RecvTimeoutError::Timeout) => match link.take() {
                Some(progress) => Message::Progress(progress),
                None => continue,
            },
            Err(RecvTimeoutError::Disconnected) => return Err(io::Error::other("the solver left nothing")),
        };
        output.write_all(&frame(&message)?)?;
        if let Message::Ended { end, .. } = message {
            if let SolverEnd::Solved(answer) = end {
                output.write_all(&answer.artefact)?;
            }
            return output.flush();
        }
        output.flush()?;
    }
}

fn solve(
    assignment: &Assignment,
    request: &[u8],
    source: Result<(Vec<u8>, Vec<u8>), String>,
    link: &SolverLink,
    memory: &Memory,
    messages: &Sender<Message>,
) -> SolverEnd {
    let Assignment { id, kind, limits, memory_bytes, .. } = assignment;
    #[cfg(feature = "test-hooks")]
    crate::test_hooks::misbehave(kind);
    let source = source.and_then(|(key, bytes)| {
        let archive = Archive::from_bytes(&bytes).map_err(|defect| defect.to_string())?;
        Ok(Source::new(archive, key))
    });
    let request = match solving::read(kind, request, &limits.requests(), &|_| source.clone(), link) {
        Ok(request) => request,
        Err(end) => return end,
    };
    if request.memory_bytes > *memory_bytes {
        // The receiver lives as long as this process.
        let _ = messages.send(Message::Estimate(request.memory_bytes));
        if let Err(error) = memory.limit(request.memory_bytes) {
            tracing::warn!(%error, "cannot raise the limit of the memory");
        }
    }
    solving::solve(id, &request, link)
}

/// Kills this process when standard input ends. An exit in the usual way would wait for locks that a solver may hold.
fn end_with_the_input() {
    let mut rest = [0; 64];
    while matches!(io::stdin().read(&mut rest), Ok(1..)) {}
    let _ = kill_process(getpid(), Signal::KILL);
}

/// The limit of this process's address space.
#[derive(Debug)]
struct Memory {
    /// Address space without the solver.
    taken_bytes: u64,
    /// Limit that this process has inherited.
    inherited: Rlimit,
}

impl Memory {
    fn of_this_process() -> Self {
        Self { taken_bytes: address_space(), inherited: getrlimit(Resource::As) }
    }

    /// Limits the address space to what a job with this estimate may take. Memory beyond it is not given, so that the
    /// solver ends with a message about it.
    fn limit(&self, memory_bytes: u64) -> io::Result<()> {
        let needed = (memory_bytes as f64 * ESTIMATE_FACTOR) as u64;
        let limit = self.taken_bytes + STACK_BYTES as u64 + MARGIN_BYTES + needed;
        let current = self.inherited.current.map_or(limit, |inherited| inherited.min(limit));
        Ok(setrlimit(Resource::As, Rlimit { current: Some(current), ..self.inherited })?)
    }
}

/// Returns the address space of this process in bytes, or 0 if the system does not tell.
fn address_space() -> u64 {
    let status = std::fs::read_to_string("/proc/self/status").unwrap_or_default();
    let line = status.lines().find_map(|line| line.strip_prefix("VmSize:"));
    let kibibytes = line.and_then(|line| line.split_whitespace().next()).and_then(|text| text.parse::<u64>().ok());
    kibibytes.unwrap_or(0) << 10
}

fn read_frame<T: DeserializeOwned>(input: &mut impl Read) -> io::Result<T> {
    let mut length = [0; 4];
    input.read_exact(&mut length)?;
    let bytes = read_bytes(input, u64::from(u32::from_le_bytes(length)))?;
    Ok(serde_json::from_slice(&bytes)?)
}

fn read_bytes(input: &mut impl Read, length: u64) -> io::Result<Vec<u8>> {
    let mut bytes = Vec::new();
    input.take(length).read_to_end(&mut bytes)?;
    if bytes.len() as u64 == length { Ok(bytes) } else { Err(io::ErrorKind::UnexpectedEof.into()) }
}
