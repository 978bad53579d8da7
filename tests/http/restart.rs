//! An accepted job is solved even if the server is shut down or killed.

use crate::app::{MINIMAL, RULED, TestApp, large_strip, small_film};
use serde_json::Value;

#[tokio::test]
async fn a_restarted_server_finishes_jobs_that_a_shutdown_handed_back() {
    let settings = [("PLATEAU_WORKERS", "1"), ("PLATEAU_HTTP__SHUTDOWN_GRACE_MS", "50")];
    let app = TestApp::start_with(&settings).await;
    let running: Value = app.post(RULED, &large_strip(12_000)).await.json().await.unwrap();
    let queued: Value = app.post(MINIMAL, &small_film(0.31)).await.json().await.unwrap();
    let (status, folder) = app.stop().await;
    assert_eq!(status.code(), Some(0));
    let app = TestApp::start_in(folder, &[]).await;
    for job in [running, queued] {
        assert_eq!(app.ended(job).await["status"], "succeeded");
    }
}

#[tokio::test]
async fn a_restarted_server_finishes_the_jobs_of_a_killed_one() {
    let settings = [("PLATEAU_WORKERS", "1"), ("PLATEAU_JOBS__LEASE_MS", "1000")];
    let app = TestApp::start_with(&settings).await;
    let jobs = [app.post(RULED, &large_strip(12_000)).await, app.post(MINIMAL, &small_film(0.32)).await];
    let mut accepted = Vec::new();
    for job in jobs {
        accepted.push(job.json::<Value>().await.unwrap());
    }
    let folder = app.kill().await;
    let app = TestApp::start_in(folder, &settings).await;
    for job in accepted {
        assert_eq!(app.ended(job).await["status"], "succeeded");
    }
}
