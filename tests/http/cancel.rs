//! Cancelling and deleting: the client sees the effect at once, and the solver, which would go on, stops soon.

use crate::app::{MINIMAL, TestApp, endless_film, problem, small_film};
use crate::hold::until;
use reqwest::Method;
use serde_json::Value;

async fn running(app: &TestApp) -> usize {
    let text = app.get("/metrics").await.text().await.unwrap();
    let line = text.lines().find(|line| line.starts_with("plateau_jobs_running "));
    line.map_or(0, |line| line.split(' ').nth(1).unwrap().parse::<f64>().unwrap() as usize)
}

async fn until_running(app: &TestApp, count: usize) {
    until(&format!("{count} jobs run"), async || running(app).await == count).await;
}

#[tokio::test]
async fn a_running_job_is_cancelled_at_once_and_its_solver_stops() {
    let app = TestApp::start_with(&[("PLATEAU_WORKERS", "1")]).await;
    let job: Value = app.post(MINIMAL, &endless_film(0.1)).await.json().await.unwrap();
    until_running(&app, 1).await;
    let cancel = format!("{}/cancel", job["links"]["self"].as_str().unwrap());
    let mesh = format!("{}/mesh", job["links"]["self"].as_str().unwrap());
    let answer = app.request(Method::POST, &cancel).send().await.unwrap();
    assert_eq!(answer.status(), 200);
    assert_eq!(answer.json::<Value>().await.unwrap()["status"], "cancelled");
    until_running(&app, 0).await;
    // Cancelling is idempotent, and the worker takes the next job.
    let again: Value = app.request(Method::POST, &cancel).send().await.unwrap().json().await.unwrap();
    assert_eq!(again["status"], "cancelled");
    problem(app.get(&mesh).await, 409).await;
    app.solve(MINIMAL, &small_film(0.1)).await;
}

#[tokio::test]
async fn a_queued_job_is_cancelled_and_never_runs() {
    let app = TestApp::start_with(&[("PLATEAU_WORKERS", "1")]).await;
    app.hold.at("claimed");
    let first: Value = app.post(MINIMAL, &small_film(0.1)).await.json().await.unwrap();
    until_running(&app, 1).await;
    let second: Value = app.post(MINIMAL, &small_film(0.2)).await.json().await.unwrap();
    assert_eq!(second["status"], "queued");
    let link = |job: &Value| job["links"]["cancel"].as_str().unwrap().to_owned();
    let cancelled: Value = app.request(Method::POST, &link(&second)).send().await.unwrap().json().await.unwrap();
    assert_eq!((cancelled["status"].as_str(), cancelled["started_at"].is_null()), (Some("cancelled"), true));
    app.request(Method::POST, &link(&first)).send().await.unwrap();
    until_running(&app, 0).await;
}

#[tokio::test]
async fn cancelling_leaves_a_finished_job_unchanged_and_deleting_removes_it() {
    let app = TestApp::start().await;
    let job = app.solve(MINIMAL, &small_film(0.3)).await;
    let this = job["links"]["self"].as_str().unwrap();
    let after: Value = app.request(Method::POST, &format!("{this}/cancel")).send().await.unwrap().json().await.unwrap();
    assert_eq!(after, job);
    assert_eq!(app.request(Method::DELETE, this).send().await.unwrap().status(), 204);
    for path in [this.to_owned(), format!("{this}/mesh"), format!("{this}/events")] {
        problem(app.get(&path).await, 404).await;
    }
    problem(app.request(Method::DELETE, this).send().await.unwrap(), 404).await;
}

#[tokio::test]
async fn deleting_a_running_job_stops_its_solver() {
    let app = TestApp::start_with(&[("PLATEAU_WORKERS", "1")]).await;
    app.hold.at("half");
    let job: Value = app.post(MINIMAL, &small_film(0.1)).await.json().await.unwrap();
    app.hold.reached("half", job["id"].as_str().unwrap()).await;
    let answer = app.request(Method::DELETE, job["links"]["self"].as_str().unwrap()).send().await.unwrap();
    assert_eq!(answer.status(), 204);
    until_running(&app, 0).await;
}

#[tokio::test]
async fn a_job_without_a_mesh_at_its_deadline_fails_with_the_type_deadline() {
    let app = TestApp::start_with(&[("PLATEAU_JOBS__DEADLINE_MS", "50"), ("PLATEAU_WORKERS", "1")]).await;
    app.hold.at("claimed");
    let job: Value = app.post_waiting(MINIMAL, &small_film(0.1)).await.json().await.unwrap();
    assert_eq!((job["status"].as_str(), job["error"]["type"].as_str()), (Some("failed"), Some("/problems/deadline")));
}
