//! The hooks for tests (`src/test_hooks.rs`): they hold and delay jobs, and no release build has them.

use crate::app::{MINIMAL, RULED, TestApp, example, root, small_film};
use crate::skips::skipped;
use reqwest::Method;
use serde_json::Value;
use std::process::Command;

const STAGES: [&str; 4] = ["claimed", "first_progress", "half", "storing"];

async fn posted(app: &TestApp, height: f64) -> (Value, String) {
    let job: Value = app.post(MINIMAL, &small_film(height)).await.json().await.unwrap();
    let id = job["id"].as_str().unwrap().to_owned();
    (job, id)
}

#[tokio::test]
async fn a_job_is_held_at_each_stage_until_the_file_is_removed() {
    let app = TestApp::start_with(&[("PLATEAU_JOBS__PROGRESS_INTERVAL_MS", "10")]).await;
    for (number, stage) in STAGES.into_iter().enumerate() {
        app.hold.at(stage);
        let (job, id) = posted(&app, 0.1 + number as f64 / 10.0).await;
        app.hold.reached(stage, &id).await;
        let events = app.get(job["links"]["events"].as_str().unwrap()).await;
        let held = app.get_json(job["links"]["self"].as_str().unwrap()).await;
        assert_eq!(held["status"], "running", "{stage}");
        app.hold.release(stage);
        assert_eq!(app.ended(job).await["status"], "succeeded", "{stage}");
        assert!(!app.hold.is_held(stage, &id));
        let fractions: Vec<f64> = events
            .text()
            .await
            .unwrap()
            .lines()
            .filter_map(|line| serde_json::from_str::<Value>(line.strip_prefix("data: ")?).ok())
            .filter_map(|data| data["progress"]["fraction"].as_f64())
            .collect();
        assert!(fractions.is_sorted() && fractions.last() == Some(&1.0), "{stage}: {fractions:?}");
    }
}

#[tokio::test]
async fn a_hold_of_one_kind_holds_a_strip_whose_client_waits_and_leaves_a_film() {
    let app = TestApp::start_with(&[("PLATEAU_WORKERS", "2")]).await;
    app.hold.at("claimed.ruled_surface");
    let strip = example("two-rails");
    let post = app.request(Method::POST, RULED).header("prefer", "wait=1").json(&strip).send().await.unwrap();
    assert_eq!(post.status(), 202);
    let strip: Value = post.json().await.unwrap();
    app.hold.reached("claimed", strip["id"].as_str().unwrap()).await;
    app.solve(MINIMAL, &small_film(0.2)).await;
    app.hold.release("claimed.ruled_surface");
    assert_eq!(app.ended(strip).await["status"], "succeeded");
}

#[tokio::test]
async fn a_cancel_ends_a_hold_at_every_stage() {
    let app = TestApp::start_with(&[("PLATEAU_WORKERS", "1")]).await;
    for stage in STAGES {
        app.hold.at(stage);
        let (job, id) = posted(&app, 0.3).await;
        app.hold.reached(stage, &id).await;
        let cancel = job["links"]["cancel"].as_str().unwrap();
        let answer: Value = app.request(Method::POST, cancel).send().await.unwrap().json().await.unwrap();
        assert_eq!(answer["status"], "cancelled", "{stage}");
        // The only worker is free again although the file is still there.
        let (next, next_id) = posted(&app, 0.4).await;
        app.hold.reached(stage, &next_id).await;
        assert!(!app.hold.is_held(stage, &id), "{stage}");
        app.request(Method::DELETE, next["links"]["self"].as_str().unwrap()).send().await.unwrap();
        app.hold.release(stage);
    }
}

#[tokio::test]
async fn a_deadline_ends_a_hold() {
    let app = TestApp::start_with(&[("PLATEAU_JOBS__DEADLINE_MS", "100")]).await;
    app.hold.at("claimed");
    let (job, _) = posted(&app, 0.5).await;
    let job = app.ended(job).await;
    assert_eq!((&job["status"], &job["error"]["type"]), (&"failed".into(), &"/problems/deadline".into()));
}

#[tokio::test]
async fn a_shutdown_ends_a_hold_and_hands_the_job_back() {
    let app = TestApp::start_with(&[("PLATEAU_HTTP__SHUTDOWN_GRACE_MS", "0")]).await;
    app.hold.at("storing");
    let (job, id) = posted(&app, 0.6).await;
    app.hold.reached("storing", &id).await;
    let (status, folder) = app.stop().await;
    assert_eq!(status.code(), Some(0));
    let app = TestApp::start_in(folder, &[]).await;
    app.hold.reached("storing", &id).await;
    app.hold.release("storing");
    assert_eq!(app.ended(job).await["status"], "succeeded");
}

#[tokio::test]
async fn a_solver_waits_after_each_report_until_it_is_stored() {
    let app = TestApp::start_with(&[("PLATEAU_JOBS__PROGRESS_INTERVAL_MS", "100")]).await;
    app.hold.at("each_progress");
    let (job, _) = posted(&app, 0.8).await;
    let text = app.get(job["links"]["events"].as_str().unwrap()).await.text().await.unwrap();
    // A stream that begins late or is slow leaves reports out, but the last identifier counts all of them, the claim
    // and the end. Without the hold, the film is solved before the first report is stored.
    let last = text.lines().filter_map(|line| line.strip_prefix("id:")).next_back().unwrap().trim();
    let changes: u64 = last.split('.').nth(1).unwrap().parse().unwrap();
    assert!(changes >= 3 + 2, "{text}");
    app.hold.release("each_progress");
}

#[tokio::test]
async fn every_solve_is_delayed() {
    if !cfg!(feature = "test-hooks") {
        return skipped("hooks for tests", "this build is without the feature test-hooks");
    }
    let app = TestApp::start_with(&[("PLATEAU_TEST_DELAY_MS", "200")]).await;
    for (path, request) in [(MINIMAL, small_film(0.7)), (RULED, example("two-rails"))] {
        let started = std::time::Instant::now();
        app.solve(path, &request).await;
        assert!(started.elapsed().as_millis() >= 200, "{path}");
    }
}

#[test]
fn a_build_without_the_feature_has_no_hooks() {
    let program = std::fs::read(env!("CARGO_BIN_EXE_plateau")).unwrap();
    let name = b"PLATEAU_TEST_";
    let has_hooks = program.windows(name.len()).any(|bytes| bytes == name);
    assert_eq!(has_hooks, cfg!(feature = "test-hooks"));
}

/// Compiles only the file of the hooks, which takes a tenth of a second.
#[test]
fn a_release_build_with_the_feature_does_not_compile() {
    let folder = tempfile::tempdir().unwrap();
    let compiles = |debug_assertions: &str| {
        Command::new("rustc")
            .args(["--edition=2024", "--crate-type=lib", "--emit=metadata", "--cap-lints=allow"])
            .arg(format!("-Cdebug-assertions={debug_assertions}"))
            .args([root().join("src/test_hooks.rs").as_os_str(), "--out-dir".as_ref(), folder.path().as_os_str()])
            .output()
            .expect("rustc runs")
    };
    assert!(compiles("on").status.success());
    let release = compiles("off");
    assert!(!release.status.success());
    assert!(String::from_utf8_lossy(&release.stderr).contains("cannot be built with --release"));
}
