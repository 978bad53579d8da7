//! An accepted job is solved even if the server is shut down or killed.

use crate::app::{MINIMAL, TestApp, small_film};
use serde_json::Value;

#[tokio::test]
async fn a_restarted_server_finishes_jobs_that_a_shutdown_handed_back() {
    let settings = [("PLATEAU_WORKERS", "1"), ("PLATEAU_HTTP__SHUTDOWN_GRACE_MS", "50")];
    let app = TestApp::start_with(&settings).await;
    app.hold.at("half");
    let running: Value = app.post(MINIMAL, &small_film(0.3)).await.json().await.unwrap();
    app.hold.reached("half", running["id"].as_str().unwrap()).await;
    let queued: Value = app.post(MINIMAL, &small_film(0.31)).await.json().await.unwrap();
    let (status, folder) = app.stop().await;
    assert_eq!(status.code(), Some(0));
    let app = TestApp::start_in(folder, &[]).await;
    app.hold.release("half");
    for job in [running, queued] {
        assert_eq!(app.ended(job).await["status"], "succeeded");
    }
}

#[tokio::test]
async fn a_restarted_server_finishes_the_jobs_of_a_killed_one() {
    let settings = [("PLATEAU_WORKERS", "1"), ("PLATEAU_JOBS__LEASE_MS", "1000")];
    let app = TestApp::start_with(&settings).await;
    app.hold.at("storing");
    let jobs = [app.post(MINIMAL, &small_film(0.3)).await, app.post(MINIMAL, &small_film(0.32)).await];
    let mut accepted = Vec::new();
    for job in jobs {
        accepted.push(job.json::<Value>().await.unwrap());
    }
    app.hold.reached("storing", accepted[0]["id"].as_str().unwrap()).await;
    let folder = app.kill().await;
    let app = TestApp::start_in(folder, &settings).await;
    app.hold.release("storing");
    for job in accepted {
        assert_eq!(app.ended(job).await["status"], "succeeded");
    }
}
