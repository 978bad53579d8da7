//! Hooks for tests, compiled only with the cargo feature `test-hooks`. A release build with the
//! feature does not compile. Every hook is set by environment variables that begin with
//! `PLATEAU_TEST_`. CONTRIBUTING.md says how a test uses them.

use std::cell::{Cell, RefCell};
use std::io::Write;
use std::path::{Path, PathBuf};
use std::time::{Duration, Instant};

#[cfg(not(debug_assertions))]
compile_error!("the feature test-hooks is for tests only, so it cannot be built with --release");

/// Variable that names a folder. While it has a file `STAGE` or `STAGE.KIND`, a job that reaches
/// the stage is held there.
const HOLD_DIR: &str = "PLATEAU_TEST_HOLD_DIR";
/// Variable that gives a number of milliseconds by which every solve is delayed.
const DELAY_MS: &str = "PLATEAU_TEST_DELAY_MS";

/// Stages at which a job can be held, in the order in which it reaches them: before its solver
/// starts, after the solver's first report of progress, after its first report of a half or more,
/// and after its end, before the outcome is stored. A job whose solver reports no progress reaches
/// all of them at its end.
const STAGES: [&str; 4] = ["claimed", "first_progress", "half", "storing"];
/// Name of the file that makes a solver wait after each report of progress until the report has been taken to be
/// stored. Without this file, only the latest report of each interval is stored.
const EACH_PROGRESS: &str = "each_progress";
/// Name of the file that makes a solver wait before it starts, while the file exists. The solver does not check its
/// signal meanwhile, as if it were in an endless loop.
const STUBBORN: &str = "stubborn";
/// Name of the file with the fault of a statement of SQLite: the fault, the text of the statement before it in the
/// transaction, and the text of the statement, with [`BETWEEN`] between them. The file is removed when the fault
/// happens.
const FAULT: &str = "fault";
/// Name of a file to which every statement of SQLite is written: the text of the statement before it and its own, with
/// [`BETWEEN`] between them and [`END`] behind them.
const STATEMENTS: &str = "statements";
/// Separates the texts in the files [`FAULT`] and [`STATEMENTS`]. No statement contains this character or [`END`].
const BETWEEN: char = '\u{1}';
const END: char = '\u{2}';
/// Names of the files that make a child process misbehave in place of solving: it takes memory without end, aborts,
/// recurses without end, or writes bytes that are no answer.
const MISBEHAVIOURS: [&str; 4] = ["allocate", "abort", "overflow", "rubbish"];
/// Variable that makes every job run on a thread, as on a system without `/proc`.
const NO_CHILDREN: &str = "PLATEAU_TEST_NO_CHILDREN";
/// Interval at which a held job checks whether the file of its hold still exists.
const PAUSE: Duration = Duration::from_millis(5);

/// A job that can be held at each stage.
pub(crate) struct Holds<'a, F> {
    id: &'a str,
    kind: &'a str,
    /// Whether the job goes on. A job that was cancelled, or whose deadline has passed, is not held any longer.
    wanted: F,
    /// Number of stages that the job has passed.
    passed: Cell<usize>,
}

impl<'a, F: Fn() -> bool> Holds<'a, F> {
    /// Holds a job before its solver starts, and then delays it.
    pub(crate) fn claimed(id: &'a str, kind: &'a str, wanted: F) -> Self {
        let holds = Self { id, kind, wanted, passed: Cell::new(0) };
        holds.pass(1);
        while is_held(STUBBORN, kind) {
            std::thread::sleep(PAUSE);
        }
        let delay = std::env::var(DELAY_MS).ok().and_then(|text| text.parse().ok()).map(Duration::from_millis);
        if let Some(until) = delay.map(|delay| Instant::now() + delay) {
            while (holds.wanted)() && Instant::now() < until {
                std::thread::sleep(PAUSE.min(until.saturating_duration_since(Instant::now())));
            }
        }
        holds
    }

    /// Holds a job after its solver has reported this fraction. `is_taken` says whether the report has been taken.
    pub(crate) fn progress(&self, fraction: f64, is_taken: impl Fn() -> bool) {
        while (self.wanted)() && is_held(EACH_PROGRESS, self.kind) && !is_taken() {
            std::thread::sleep(PAUSE);
        }
        self.pass(if fraction < 0.5 { 2 } else { 3 });
    }

    /// Holds a job after its solver has ended.
    pub(crate) fn solved(&self) {
        self.pass(STAGES.len());
    }

    fn pass(&self, count: usize) {
        while self.passed.get() < count {
            self.hold(STAGES[self.passed.get()]);
            self.passed.set(self.passed.get() + 1);
        }
    }

    /// Waits while the file of the stage exists. Meanwhile the folder has the file `held.STAGE.ID`.
    fn hold(&self, stage: &str) {
        let held = || (self.wanted)() && is_held(stage, self.kind);
        if !held() {
            return;
        }
        let Some(mark) = folder().map(|folder| folder.join(format!("held.{stage}.{}", self.id))) else { return };
        // A test that has ended removes its folder.
        let _ = std::fs::write(&mark, []);
        while held() {
            std::thread::sleep(PAUSE);
        }
        let _ = std::fs::remove_file(&mark);
    }
}

/// Returns true if a job of this kind that is submitted now would be held. A job that would be held is not solved
/// during its submission, because the hold would block a thread that serves requests.
pub(crate) fn holds(kind: &str) -> bool {
    STAGES.iter().chain([&EACH_PROGRESS, &STUBBORN]).any(|stage| is_held(stage, kind))
}

/// Returns true if no child process may be started.
pub(crate) fn forbids_children() -> bool {
    std::env::var_os(NO_CHILDREN).is_some()
}

/// Returns the variables of the hooks, which a child process needs too.
pub(crate) fn variables() -> impl Iterator<Item = (String, String)> {
    [HOLD_DIR, DELAY_MS].into_iter().filter_map(|name| Some((name.to_owned(), std::env::var(name).ok()?)))
}

/// Does what the folder asks of a child process that solves a job of this kind.
pub(crate) fn misbehave(kind: &str) {
    fn overflow(depth: u64) -> u64 {
        std::hint::black_box(if depth == u64::MAX { 0 } else { overflow(depth + 1) + 1 })
    }
    match MISBEHAVIOURS.into_iter().find(|name| is_held(name, kind)) {
        Some("allocate") => {
            let mut taken = Vec::new();
            loop {
                taken.push(vec![1_u8; 1 << 20]);
            }
        }
        Some("abort") => std::process::abort(),
        Some("overflow") => drop(overflow(0)),
        Some("rubbish") => {
            // The main thread holds the lock of the standard output, so the pipe is opened once more.
            let _ = std::fs::write("/proc/self/fd/1", [b'x'; 4096]);
        }
        _ => {}
    }
}

fn is_held(stage: &str, kind: &str) -> bool {
    folder().is_some_and(|folder| folder.join(stage).exists() || folder.join(format!("{stage}.{kind}")).exists())
}

fn folder() -> Option<PathBuf> {
    std::env::var_os(HOLD_DIR).map(PathBuf::from)
}

/// A point at which a statement of SQLite can fail.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) enum FailurePoint {
    /// Before the statement runs.
    Before,
    /// After the statement ran. After a COMMIT, the failure means that its answer is lost.
    After,
}

thread_local! {
    /// Text of the last statement of this thread's transaction. It is empty when the transaction begins.
    static PREVIOUS: RefCell<String> = const { RefCell::new(String::new()) };
}

/// Returns true if a statement of SQLite must fail at this point. The faults `fail_before` and `fail_after` make it
/// fail, and `die_before` and `die_after` end the process as a kill does. For a statement outside of a transaction, the
/// text of the statement before it is empty.
pub(crate) fn statement_fails(text: &str, point: FailurePoint, in_transaction: bool) -> bool {
    let Some(folder) = folder() else { return false };
    if text.starts_with("BEGIN") {
        PREVIOUS.set(String::new());
    }
    let previous = if in_transaction { PREVIOUS.with_borrow(Clone::clone) } else { String::new() };
    let fails = fails(&folder, &previous, text, point);
    if point == FailurePoint::Before && folder.join(STATEMENTS).exists() {
        let line = format!("{previous}{BETWEEN}{text}{END}");
        let written = std::fs::OpenOptions::new().append(true).open(folder.join(STATEMENTS));
        // A test that has ended removes its folder.
        let _ = written.and_then(|mut file| file.write_all(line.as_bytes()));
    }
    if point == FailurePoint::After {
        PREVIOUS.set(text.to_owned());
    }
    fails
}

fn fails(folder: &Path, previous: &str, text: &str, point: FailurePoint) -> bool {
    let file = folder.join(FAULT);
    let Ok(asked) = std::fs::read_to_string(&file) else { return false };
    let Some((fault, point_asked)) = asked.split_once(BETWEEN) else { return false };
    let name = if point == FailurePoint::Before { "before" } else { "after" };
    if point_asked.split_once(BETWEEN) != Some((previous, text)) || !fault.ends_with(name) {
        return false;
    }
    // Of several threads, the one that removes the file has the fault.
    if std::fs::remove_file(&file).is_err() {
        return false;
    }
    if fault.starts_with("die") {
        std::process::abort();
    }
    true
}
