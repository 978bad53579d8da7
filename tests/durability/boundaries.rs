//! Faults at each boundary between two statements of everything that the service does with its database: on PostgreSQL
//! a connection that closes before the statement or before its answer, on SQLite a statement that fails and a process
//! that dies. At the end nothing is lost and nothing doubled, no file is without a row and no row without its file.
//! Each test takes some of the boundaries, or all of them with `PLATEAU_LONG=1`.

use crate::cluster::{Cluster, Process};
use crate::hold::until;
use crate::kills::{Load, every_job_ended_once, hardened};
use crate::postgres::Postgres;
use crate::proxy::{Boundary, Fault, Proxy};
use plateau::store::{Filter, Lookup, NewJob, Outcome, Store, StoreOptions};
use std::collections::{BTreeMap, BTreeSet};
use std::path::{Path, PathBuf};
use std::process::Stdio;
use std::sync::Arc;
use std::time::{Duration, Instant};

/// Time for which a fault waits for its statement. Some statements are rare, such as those of a submission that is
/// repeated.
const RARE: Duration = Duration::from_millis(1500);
/// Time for which a fault waits for a statement of an operation that has not been disturbed yet.
const NEEDED: Duration = Duration::from_secs(20);
/// Time for which the load runs while its statements are recorded.
const WATCHED: Duration = Duration::from_secs(4);

/// A run takes every boundary whose number is a multiple of this.
fn step() -> usize {
    match (std::env::var_os("PLATEAU_LONG").is_some(), crate::is_full()) {
        (true, _) => 1,
        (false, true) => 4,
        (false, false) => 32,
    }
}

/// Returns processes that keep every result in a file and solve so slowly that leases are renewed.
fn with_files(database: Option<String>, results: &Path) -> Cluster {
    hardened(database)
        .set("PLATEAU_STORE__INLINE_BYTES", 0)
        .set("PLATEAU_STORE__RESULTS", results.display())
        .set("PLATEAU_JOBS__PROGRESS_INTERVAL_MS", 10)
        .set("PLATEAU_TEST_DELAY_MS", 400)
}

/// Sweeps, and compares the files with the rows. `files` returns the names of the files that rows name.
async fn files_and_rows_are_equal(url: &str, results: &Path, files: impl AsyncFn() -> Vec<String>) {
    let options = StoreOptions {
        results: Some(results.display().to_string()),
        orphan_age: Duration::ZERO,
        ..StoreOptions::default()
    };
    let store = Store::open(url, options).await.unwrap();
    store.sweep().await.unwrap();
    store.close().await;
    let found = std::fs::read_dir(results).unwrap().map(|entry| entry.unwrap().file_name().into_string().unwrap());
    assert_eq!(found.collect::<BTreeSet<_>>(), files().await.into_iter().collect::<BTreeSet<_>>());
}

/// The operations of which each must be disturbed, as [`operation`] names them.
const OPERATIONS: [&str; 5] = ["submit", "claim", "renew", "progress", "finish"];

/// Returns the name of the operation to which a statement belongs, for the report.
fn operation(boundary: &Boundary) -> &'static str {
    let text = format!("{} {}", boundary.previous, boundary.statement);
    let marks = [
        ("UPDATE requests SET source", "finish"),
        ("INSERT INTO artefacts", "finish"),
        ("FROM artefacts", "finish"),
        ("statistics = $4", "finish"),
        ("INSERT INTO", "submit"),
        ("AS first_waiting", "submit"),
        ("SET lease_until", "renew"),
        ("SET progress", "progress"),
        ("worker = $1", "claim"),
        ("FROM requests", "claim"),
    ];
    marks.iter().find(|(mark, _)| text.contains(mark)).map_or("other", |(_, name)| name)
}

#[tokio::test(flavor = "multi_thread", worker_threads = 2)]
async fn a_connection_cut_at_any_statement_loses_and_doubles_nothing() {
    let Some(postgres) = Postgres::start() else { return };
    let url = postgres.database().await;
    let proxy = Proxy::start(&url);
    let results = tempfile::tempdir().unwrap();
    let cluster = with_files(Some(proxy.url()), results.path());
    // A solver that takes less than the interval between two reports would store no progress.
    cluster.hold.at("each_progress");
    let mut server = cluster.serve(2).await;
    let load = Load::start(&server.url);
    load.some_are_accepted().await;
    proxy.forget();
    tokio::time::sleep(WATCHED).await;
    let boundaries: Vec<Boundary> =
        proxy.seen().into_iter().filter(|boundary| boundary.statement != "ROLLBACK").collect();
    let (mut happened, mut missed) = (BTreeMap::<&str, usize>::new(), 0);
    for (number, boundary) in boundaries.iter().enumerate() {
        // Statements of the operations that the load consists of are never left out.
        if number % step() != 0 && operation(boundary) == "other" {
            continue;
        }
        for fault in [Fault::CutBefore, Fault::CutAfter] {
            let fired = proxy.disturb_at(boundary.clone(), fault, 1);
            let begun = Instant::now();
            let patience = if happened.contains_key(operation(boundary)) { RARE } else { NEEDED };
            while !fired.yet() && begun.elapsed() < patience {
                tokio::time::sleep(Duration::from_millis(5)).await;
            }
            proxy.calm();
            if fired.yet() {
                *happened.entry(operation(boundary)).or_default() += 1;
            } else {
                missed += 1;
            }
        }
    }
    cluster.hold.release("each_progress");
    let accepted = load.finish().await;
    println!("{} boundaries; cuts by operation: {happened:?}; {missed} did not come", boundaries.len());
    for name in OPERATIONS {
        assert!(happened.contains_key(name), "no statement of {name} was cut: {happened:?}");
    }
    every_job_ended_once(&server, &accepted, "connections cut").await;
    server.kill().await;
    let named = async || {
        let url = url.clone();
        let read = move || {
            let (server, folder) = url.split_once("?host=").unwrap();
            let mut config = ::postgres::Config::new();
            config.user("postgres").dbname(server.rsplit_once('/').unwrap().1).host_path(folder);
            let mut client = config.connect(::postgres::NoTls).unwrap();
            let rows = client.query("SELECT file FROM artefacts", &[]).unwrap();
            rows.iter().map(|row| row.get(0)).collect()
        };
        tokio::task::spawn_blocking(read).await.unwrap()
    };
    files_and_rows_are_equal(&url, results.path(), named).await;
}

/// Reads the statements of SQLite that the test hooks have recorded.
fn recorded(cluster: &Cluster) -> Vec<Boundary> {
    let text = std::fs::read_to_string(cluster.hold.folder.join("statements")).unwrap();
    let read =
        |(previous, statement): (&str, &str)| Boundary { previous: previous.into(), statement: statement.into() };
    let seen: BTreeSet<Boundary> = text.split('\u{2}').filter_map(|line| line.split_once('\u{1}')).map(read).collect();
    seen.into_iter().filter(|boundary| boundary.statement != "ROLLBACK").collect()
}

/// Sets a fault. Returns its file, which disappears when the fault happens.
fn set_fault(cluster: &Cluster, fault: &str, boundary: &Boundary) -> PathBuf {
    let file = cluster.hold.folder.join("fault");
    let text = [fault, &boundary.previous, &boundary.statement].join("\u{1}");
    // The file appears as a whole, because the hooks may look at any moment.
    std::fs::write(file.with_extension("new"), text).unwrap();
    std::fs::rename(file.with_extension("new"), &file).unwrap();
    file
}

/// Sets a fault and waits until it has happened. Returns false if its statement did not come.
async fn happens(cluster: &Cluster, fault: &str, boundary: &Boundary, patience: Duration) -> bool {
    let file = set_fault(cluster, fault, boundary);
    let begun = Instant::now();
    while file.exists() {
        if begun.elapsed() > patience {
            // The fault may happen at this moment, and its file is then already gone.
            return std::fs::remove_file(&file).is_err();
        }
        tokio::time::sleep(Duration::from_millis(5)).await;
    }
    true
}

#[tokio::test(flavor = "multi_thread", worker_threads = 2)]
async fn a_failure_or_a_death_at_any_statement_of_sqlite_loses_and_doubles_nothing() {
    let results = tempfile::tempdir().unwrap();
    let cluster = with_files(None, results.path());
    cluster.hold.at("each_progress");
    let mut server = cluster.serve(2).await;
    let load = Load::start(&server.url);
    load.some_are_accepted().await;
    std::fs::write(cluster.hold.folder.join("statements"), []).unwrap();
    tokio::time::sleep(WATCHED).await;
    // A busy machine needs longer until each operation has been seen.
    let all_seen = async || OPERATIONS.iter().all(|name| recorded(&cluster).iter().any(|at| operation(at) == *name));
    until("each operation is seen", all_seen).await;
    let boundaries = recorded(&cluster);
    std::fs::remove_file(cluster.hold.folder.join("statements")).unwrap();
    let (mut happened, mut missed, mut deaths) = (BTreeMap::<&str, usize>::new(), 0, 0);
    let (mut commits, mut met) = (BTreeSet::new(), BTreeSet::new());
    for (number, boundary) in boundaries.iter().enumerate() {
        let is_commit = boundary.statement == "COMMIT";
        // Writes that share a transaction make many boundaries. A short run takes the first of each operation and its
        // first COMMIT, because a write that always shares its transaction has no COMMIT of its own.
        let is_first_commit = is_commit && commits.insert(operation(boundary));
        let is_first = met.insert(operation(boundary));
        if number % step() != 0 && !is_first_commit && !is_first {
            continue;
        }
        // The process dies only at a COMMIT, because a death at any other statement leaves the database unchanged.
        let faults: &[&str] =
            if is_commit { &["fail_before", "fail_after", "die_before", "die_after"] } else { &["fail_before"] };
        for fault in faults {
            let patience = if happened.contains_key(operation(boundary)) { RARE } else { NEEDED };
            if happens(&cluster, fault, boundary, patience).await {
                *happened.entry(operation(boundary)).or_default() += 1;
            } else {
                missed += 1;
            }
            if fault.starts_with("die") && restarted(&cluster, &mut server, &load).await {
                deaths += 1;
                // A job may die four times in a row.
                if deaths % 4 == 0 {
                    load.all_have_ended(&server).await;
                }
            }
        }
    }
    cluster.hold.release("each_progress");
    let accepted = load.finish().await;
    println!(
        "{} boundaries; faults by operation: {happened:?}, {deaths} deaths; {missed} did not come",
        boundaries.len()
    );
    for name in OPERATIONS {
        assert!(happened.contains_key(name), "no statement of {name} failed: {happened:?}");
    }
    every_job_ended_once(&server, &accepted, "faults of SQLite").await;
    server.kill().await;
    let path = cluster.data().join("plateau.sqlite");
    let named = async || {
        let connection = rusqlite::Connection::open(&path).unwrap();
        let mut statement = connection.prepare("SELECT file FROM artefacts").unwrap();
        statement.query_map([], |row| row.get(0)).unwrap().map(Result::unwrap).collect()
    };
    files_and_rows_are_equal(&format!("sqlite://{}", path.display()), results.path(), named).await;
}

/// Waits up to a second for the server to die, and starts it again in that case. Returns true if it died.
async fn restarted(cluster: &Cluster, server: &mut Process, load: &Load) -> bool {
    for _ in 0..200 {
        if server.has_ended() {
            *server = cluster.serve(2).await;
            load.moved_to(&server.url);
            return true;
        }
        tokio::time::sleep(Duration::from_millis(5)).await;
    }
    false
}

fn identifier(number: usize) -> String {
    format!("{number:026}")
}

/// Stores a job with a result of its own.
async fn succeeded_job(store: &Store, number: usize) {
    let result = number.to_le_bytes();
    let job = NewJob {
        id: identifier(number),
        kind: "ruled_surface".into(),
        owner: None,
        request: b"{}".to_vec(),
        source: None,
        request_hash: [0; 32],
        idempotency_key: None,
        body_hash: [0; 32],
        callback_url: None,
        label: None,
        metadata: None,
        supersede: None,
        memory_bytes: 0,
        reuse: false,
    };
    store.add_job(job).await.unwrap();
    let claimed = store.claim("worker", Duration::from_secs(60)).await.unwrap().expect("the job");
    let outcome = Outcome::Succeeded {
        statistics: "{}".into(),
        summary: "{}".into(),
        warnings: "[]".into(),
        artefact: result.to_vec(),
        artefact_hash: std::array::from_fn(|byte| result[byte % result.len()]),
        reusable: false,
    };
    assert!(store.finish(&claimed.id, claimed.attempt, Arc::new(outcome)).await.unwrap());
}

/// Number of jobs that expire in each sweep of the tests below.
const EXPIRING: usize = 3;

/// Returns the options of a store whose sweep removes at once what exceeds `max_jobs`.
fn impatient(results: &Path, max_jobs: u64) -> StoreOptions {
    StoreOptions {
        results: Some(results.display().to_string()),
        inline_bytes: 0,
        orphan_age: Duration::ZERO,
        max_jobs,
        ..StoreOptions::default()
    }
}

/// Stores [`EXPIRING`] more jobs with results. `number` counts the jobs of a test.
async fn fill(store: &Store, number: &mut usize) {
    for _ in 0..EXPIRING {
        *number += 1;
        succeeded_job(store, *number).await;
    }
}

/// Sweeps until nothing is left to be removed. Then every job either is kept with its result or is known to have
/// expired, and every file is that of a kept job.
async fn the_next_sweep_completes(sweeping: &Store, results: &Path, number: usize, what: &str) {
    // PostgreSQL may hold the rows of a cut transaction for a moment longer, and a sweep leaves them out.
    let left = async || sweeping.list(Filter::default(), 100, None).await.unwrap().0;
    until(what, async || sweeping.sweep().await.is_ok() && left().await.len() == EXPIRING).await;
    sweeping.sweep().await.unwrap();
    for job in (1..=number).map(identifier) {
        match sweeping.get(&job, None).await.unwrap() {
            Lookup::Found(_) => assert!(sweeping.artefact(&job, None).await.unwrap().is_some(), "{job} {what}"),
            found => assert_eq!(found, Lookup::Expired, "{job} {what}"),
        }
    }
    assert_eq!(std::fs::read_dir(results).unwrap().count(), EXPIRING, "{what}");
}

#[tokio::test(flavor = "multi_thread", worker_threads = 2)]
async fn a_sweep_that_is_cut_at_any_statement_is_completed_by_the_next_one() {
    let Some(postgres) = Postgres::start() else { return };
    let url = postgres.database().await;
    let proxy = Proxy::start(&url);
    let results = tempfile::tempdir().unwrap();
    let filling = Store::open(&url, impatient(results.path(), u64::MAX)).await.unwrap();
    let sweeping = Store::open(&proxy.url(), impatient(results.path(), EXPIRING as u64)).await.unwrap();
    let mut number = 0;
    fill(&filling, &mut number).await;
    fill(&filling, &mut number).await;
    proxy.forget();
    sweeping.sweep().await.unwrap();
    let boundaries: Vec<Boundary> = proxy.seen().into_iter().collect();
    assert!(boundaries.iter().any(|boundary| boundary.statement.starts_with("DELETE FROM jobs")), "{boundaries:?}");
    let mut cuts = 0;
    for boundary in boundaries.iter().step_by(if crate::is_full() { 1 } else { 4 }) {
        for fault in [Fault::CutBefore, Fault::CutAfter] {
            fill(&filling, &mut number).await;
            let fired = proxy.disturb_at(boundary.clone(), fault, 1);
            let cut = sweeping.sweep().await;
            proxy.calm();
            cuts += usize::from(fired.yet());
            let what = format!("all but {EXPIRING} jobs are gone after {fault:?} at {boundary:?}, {cut:?}");
            the_next_sweep_completes(&sweeping, results.path(), number, &what).await;
        }
    }
    println!("{} boundaries of a sweep, {cuts} cuts", boundaries.len());
}

/// Variables that name the database and the results of [`a_sweep_in_a_process_of_its_own`].
const SWEPT_DATABASE: &str = "PLATEAU_TEST_SWEPT_DATABASE";
const SWEPT_RESULTS: &str = "PLATEAU_TEST_SWEPT_RESULTS";

/// Sweeps once for the test below, whose faults end the process. Does nothing unless that test has set the two
/// variables.
#[tokio::test]
async fn a_sweep_in_a_process_of_its_own() {
    let (Ok(url), Ok(results)) = (std::env::var(SWEPT_DATABASE), std::env::var(SWEPT_RESULTS)) else { return };
    let store = Store::open(&url, impatient(results.as_ref(), EXPIRING as u64)).await.unwrap();
    // The test below looks at what is left, whether the sweep fails or not.
    let _ = store.sweep().await;
    store.close().await;
}

#[tokio::test(flavor = "multi_thread", worker_threads = 2)]
async fn a_sweep_that_fails_or_dies_at_any_statement_of_sqlite_is_completed_by_the_next_one() {
    let results = tempfile::tempdir().unwrap();
    let cluster = Cluster::new(None);
    let folder = &cluster.hold.folder;
    let url = format!("sqlite://{}", folder.join("plateau.sqlite").display());
    let store = Store::open(&url, impatient(results.path(), EXPIRING as u64)).await.unwrap();
    let mut number = 0;
    let sweep = async || {
        let this_test = std::env::current_exe().unwrap();
        let mut sweep = tokio::process::Command::new(this_test);
        sweep
            .args(["--exact", "boundaries::a_sweep_in_a_process_of_its_own"])
            .stdout(Stdio::null())
            .stderr(Stdio::null());
        sweep.env(SWEPT_DATABASE, &url).env(SWEPT_RESULTS, results.path()).env(crate::hold::VARIABLE, folder);
        sweep.status().await.unwrap()
    };
    fill(&store, &mut number).await;
    fill(&store, &mut number).await;
    std::fs::write(folder.join("statements"), []).unwrap();
    assert!(sweep().await.success());
    let boundaries = recorded(&cluster);
    std::fs::remove_file(folder.join("statements")).unwrap();
    assert!(boundaries.iter().any(|boundary| boundary.statement.starts_with("DELETE FROM jobs")), "{boundaries:?}");
    let (mut happened, mut deaths) = (0, 0);
    for boundary in &boundaries {
        let is_commit = boundary.statement == "COMMIT";
        let faults: &[&str] =
            if is_commit { &["fail_before", "fail_after", "die_before", "die_after"] } else { &["fail_before"] };
        for fault in faults {
            fill(&store, &mut number).await;
            set_fault(&cluster, fault, boundary);
            let ended = sweep().await;
            deaths += usize::from(!ended.success());
            happened += usize::from(std::fs::remove_file(folder.join("fault")).is_err());
            let what = format!("all but {EXPIRING} jobs are gone after {fault} at {boundary:?}, {ended}");
            the_next_sweep_completes(&store, results.path(), number, &what).await;
        }
    }
    assert!(
        deaths > 0 && happened >= boundaries.len(),
        "{happened} faults of {} boundaries, {deaths} deaths",
        boundaries.len()
    );
    println!("{} boundaries of a sweep, {happened} faults, {deaths} deaths", boundaries.len());
}
