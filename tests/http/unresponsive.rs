//! Solvers that do not answer: their jobs fail, and others take their places, however many there are.

use crate::app::{MINIMAL, TestApp, example, small_film};
use crate::hold::until;
use reqwest::Method;
use serde_json::Value;
use tempfile::TempDir;

/// Name of the hold that makes the solver of a film loop before it starts.
const STUBBORN: &str = "stubborn.minimal_surface";
const UNIFORM: &str = "/v1/uniform-meshes";
const PATIENCE: (&str, &str) = ("PLATEAU_JOBS__UNRESPONSIVE_MS", "200");
const ONE_WORKER: (&str, &str) = ("PLATEAU_WORKERS", "1");

async fn stubborn_film(app: &TestApp) -> Value {
    app.hold.at(STUBBORN);
    let job: Value = app.post(MINIMAL, &small_film(0.1)).await.json().await.unwrap();
    let this = job["links"]["self"].as_str().unwrap().to_owned();
    until("the job runs", async || app.get_json(&this).await["status"] == "running").await;
    job
}

async fn given_up(app: &TestApp) -> u64 {
    let count = app.get_json("/health/ready").await["unresponsive_solvers"].as_u64().unwrap();
    let metrics = app.get("/metrics").await.text().await.unwrap();
    let metric = format!("plateau_solvers_unresponsive {count}");
    // The readiness was asked for before the metrics, so they may differ while the number changes.
    if metrics.lines().any(|line| line == metric) { count } else { u64::MAX }
}

/// Starts a server again on the same folder, and returns the job when it has ended there.
async fn after_restart(folder: TempDir, job: Value) -> Value {
    let app = TestApp::start_in(folder, &[ONE_WORKER]).await;
    app.hold.release_all();
    let this = job["links"]["self"].as_str().unwrap();
    let job = app.get_json(this).await;
    app.ended(job).await
}

#[tokio::test]
async fn the_only_worker_goes_on_after_a_cancelled_solver_did_not_answer() {
    let app = TestApp::start_with(&[ONE_WORKER, PATIENCE]).await;
    let job = stubborn_film(&app).await;
    let cancel = job["links"]["cancel"].as_str().unwrap();
    let cancelled: Value = app.request(Method::POST, cancel).send().await.unwrap().json().await.unwrap();
    assert_eq!(cancelled["status"], "cancelled");
    app.solve(UNIFORM, &example("floor-equal-members")).await;
    assert_eq!(given_up(&app).await, 1);
    assert_eq!(app.get_json(job["links"]["self"].as_str().unwrap()).await["status"], "cancelled");
    app.hold.release(STUBBORN);
    until("the solver is back", async || given_up(&app).await == 0).await;
}

#[tokio::test]
async fn a_solver_that_overlooks_its_deadline_makes_its_job_fail() {
    let app = TestApp::start_with(&[ONE_WORKER, PATIENCE, ("PLATEAU_JOBS__DEADLINE_MS", "100")]).await;
    let job = stubborn_film(&app).await;
    let job = app.ended(job).await;
    assert_eq!((&job["status"], &job["error"]["type"]), (&"failed".into(), &"/problems/unresponsive".into()));
    assert_eq!(app.get("/problems/unresponsive").await.status(), 200);
    app.hold.release(STUBBORN);
}

const DEADLINE: (&str, &str) = ("PLATEAU_JOBS__DEADLINE_MS", "100");
const ONE_AT_MOST: (&str, &str) = ("PLATEAU_JOBS__UNRESPONSIVE_MAX", "1");

/// Posts a film whose solver loops, and waits until it has failed for that reason.
async fn failed_film(app: &TestApp, height: f64) {
    let job: Value = app.post(MINIMAL, &small_film(height)).await.json().await.unwrap();
    let job = app.ended(job).await;
    assert_eq!(job["error"]["type"], "/problems/unresponsive", "{job:#}");
}

#[tokio::test]
async fn jobs_run_in_children_when_too_many_threads_do_not_answer() {
    let app = TestApp::start_with(&[ONE_WORKER, PATIENCE, DEADLINE, ONE_AT_MOST]).await;
    app.hold.at(STUBBORN);
    for number in 0..4 {
        failed_film(&app, 0.1 + f64::from(number)).await;
        assert_eq!(given_up(&app).await, 1, "the children were killed");
    }
    app.hold.release(STUBBORN);
    until("the solver is back", async || given_up(&app).await == 0).await;
}

/// Without `/proc`, the threads that do not answer are at most as many as the limit and the solvers. The process
/// lives.
#[tokio::test]
async fn without_children_a_thread_beyond_the_limit_keeps_its_slot() {
    let no_children = ("PLATEAU_TEST_NO_CHILDREN", "1");
    let app = TestApp::start_with(&[ONE_WORKER, PATIENCE, DEADLINE, ONE_AT_MOST, no_children]).await;
    app.hold.at(STUBBORN);
    failed_film(&app, 0.1).await;
    failed_film(&app, 0.2).await;
    assert_eq!(given_up(&app).await, 2);
    let waiting: Value = app.post(UNIFORM, &example("floor-equal-members")).await.json().await.unwrap();
    until("the metrics see no running job", async || {
        let metrics = app.get("/metrics").await.text().await.unwrap();
        metrics.lines().any(|line| line == "plateau_jobs_running 0")
    })
    .await;
    assert_eq!(app.get_json(waiting["links"]["self"].as_str().unwrap()).await["status"], "queued");
    app.hold.release(STUBBORN);
    until("the solvers are back", async || given_up(&app).await == 0).await;
    assert_ne!(app.ended(waiting).await["status"], "queued");
}

#[tokio::test]
async fn sigterm_ends_the_process_whatever_its_solvers_do() {
    let settings = [ONE_WORKER, PATIENCE, ("PLATEAU_HTTP__SHUTDOWN_GRACE_MS", "300")];
    let app = TestApp::start_with(&settings).await;
    let job = stubborn_film(&app).await;
    let (status, folder) = app.stop().await;
    assert_eq!(status.code(), Some(0));
    assert_eq!(after_restart(folder, job).await["error"]["type"], "/problems/unresponsive");
}

#[tokio::test]
async fn a_solver_that_is_only_slow_to_look_is_handed_back_at_sigterm() {
    let app = TestApp::start_with(&[ONE_WORKER, ("PLATEAU_HTTP__SHUTDOWN_GRACE_MS", "0")]).await;
    let job = stubborn_film(&app).await;
    let (status, folder) = app.stop().await;
    assert_eq!(status.code(), Some(0));
    assert_eq!(after_restart(folder, job).await["status"], "succeeded");
}
