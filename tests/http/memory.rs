//! The memory budget that all solvers of a process share.

use crate::app::{MINIMAL, TestApp, problem, small_film};
use reqwest::Method;
use serde_json::Value;

/// Returns a film that takes more than half of the budget that the test gives to all solvers.
fn large_film(height: f64) -> Value {
    let mut film = small_film(height);
    film["resolution"]["triangles"] = 20_000.into();
    film
}

/// Posts a film and returns the job.
async fn post(app: &TestApp, film: &Value) -> Value {
    let answer = app.post(MINIMAL, film).await;
    assert_eq!(answer.status(), 202);
    answer.json().await.unwrap()
}

async fn status(app: &TestApp, job: &Value) -> Value {
    app.get_json(job["links"]["self"].as_str().unwrap()).await["status"].clone()
}

/// Returns the number of bytes that the server says a film needs.
async fn needed_bytes(film: &Value) -> u64 {
    let app = TestApp::start_with(&[("PLATEAU_LIMITS__MEMORY_BYTES", "1"), ("PLATEAU_WORKERS", "0")]).await;
    let refused = problem(app.post(MINIMAL, film).await, 413).await;
    let detail = refused["errors"][0]["detail"].as_str().unwrap().to_owned();
    let words: Vec<&str> = detail.split(' ').collect();
    let mebibytes = words[words.iter().position(|word| *word == "MiB").unwrap() - 1];
    (mebibytes.parse::<u64>().unwrap() + 1) << 20
}

#[tokio::test]
async fn a_job_that_waits_for_memory_stays_queued_and_smaller_jobs_pass_it() {
    let (first, second) = (large_film(0.1), large_film(0.2));
    let budget = needed_bytes(&first).await.max(needed_bytes(&second).await).to_string();
    let app = TestApp::start_with(&[
        ("PLATEAU_WORKERS", "2"),
        ("PLATEAU_JOBS__MEMORY_BYTES", &budget),
        ("PLATEAU_LIMITS__MEMORY_BYTES", &budget),
    ])
    .await;
    app.hold.at("claimed");
    let first = post(&app, &first).await;
    app.hold.reached("claimed", first["id"].as_str().unwrap()).await;
    let second = post(&app, &second).await;
    // A small job gets past the second one. It needs the only other worker.
    let small = post(&app, &small_film(0.3)).await;
    app.hold.reached("claimed", small["id"].as_str().unwrap()).await;
    assert_eq!(status(&app, &second).await, "queued", "its deadline must not run");
    let cancel = app.request(Method::POST, small["links"]["cancel"].as_str().unwrap()).send().await.unwrap();
    assert_eq!(cancel.status(), 200);
    app.request(Method::POST, first["links"]["cancel"].as_str().unwrap()).send().await.unwrap();
    app.hold.reached("claimed", second["id"].as_str().unwrap()).await;
    app.hold.release("claimed");
    assert_eq!(app.ended(second).await["status"], "succeeded");
}

#[tokio::test]
async fn a_small_job_does_not_wait_for_long_ones() {
    let app = TestApp::start_with(&[("PLATEAU_JOBS__WORKERS", "1"), ("PLATEAU_JOBS__SMALL_WORKERS", "1")]).await;
    app.hold.at("claimed.minimal_surface");
    let long = post(&app, &large_film(0.1)).await;
    app.hold.reached("claimed", long["id"].as_str().unwrap()).await;
    let waiting = post(&app, &large_film(0.2)).await;
    let strip = app.solve(crate::app::RULED, &crate::app::example("two-rails")).await;
    assert_eq!(strip["status"], "succeeded");
    assert_eq!(status(&app, &waiting).await, "queued", "it is no small job");
    app.hold.release("claimed.minimal_surface");
}
