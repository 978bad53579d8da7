//! Shutdown: readiness goes off while the listener still accepts connections. Waiting clients get an answer and do not
//! delay the end.

use crate::app::{MINIMAL, TestApp, problem, small_film};
use crate::hold::until;
use reqwest::{Method, StatusCode};
use serde_json::{Value, json};

/// Time that is longer than any test takes, so that only a defect makes a test wait for it.
const FOR_EVER_MS: &str = "3600000";

#[tokio::test]
async fn a_waiting_client_gets_the_current_state_of_its_job() {
    let settings = [
        ("PLATEAU_WORKERS", "0"),
        ("PLATEAU_HTTP__WAIT_MAX_S", "3600"),
        ("PLATEAU_HTTP__SHUTDOWN_NOTICE_MS", FOR_EVER_MS),
    ];
    let app = TestApp::start_with(&settings).await;
    let job: Value = app.post(MINIMAL, &small_film(0.1)).await.json().await.unwrap();
    let this = job["links"]["self"].as_str().unwrap();
    let wait = |method, path: &str| app.request(method, path).header("prefer", "wait=3600");
    let submission = wait(Method::POST, MINIMAL).json(&small_film(0.2)).send();
    let batch =
        json!({ "requests": [{ "kind": "minimal_surface", "boundaries": [[[0, 0, 0], [1, 0, 0], [0, 1, 1]]] }] });
    let batch = wait(Method::POST, "/v1/batches").json(&batch).send();
    let waiting = wait(Method::GET, this).send();
    let stop = async {
        // Both submissions wait once their jobs are listed.
        let listed = async || app.get_json("/v1/jobs").await["jobs"].as_array().unwrap().len();
        until("three jobs are listed", async || listed().await == 3).await;
        app.terminate().await;
    };
    let (submitted, batch, waited, ()) = tokio::join!(submission, batch, waiting, stop);
    for answer in [submitted.unwrap(), batch.unwrap()] {
        assert_eq!(answer.status(), StatusCode::ACCEPTED);
        assert_eq!(answer.json::<Value>().await.unwrap()["status"], "queued");
    }
    assert_eq!(waited.unwrap().json::<Value>().await.unwrap()["status"], "queued");
    app.kill().await;
}

#[tokio::test]
async fn a_watcher_does_not_delay_a_shutdown() {
    let app = TestApp::start_with(&[("PLATEAU_WORKERS", "0"), ("PLATEAU_HTTP__SHUTDOWN_GRACE_MS", FOR_EVER_MS)]).await;
    let job: Value = app.post(MINIMAL, &small_film(0.1)).await.json().await.unwrap();
    let events = app.get(job["links"]["events"].as_str().unwrap()).await;
    app.terminate().await;
    assert!(
        events.text().await.unwrap().contains("\"status\":\"queued\""),
        "the stream must end with a complete event"
    );
    let (status, _folder) = app.exited().await;
    assert_eq!(status.code(), Some(0));
}

#[tokio::test]
async fn readiness_goes_off_before_the_listener_closes() {
    let app = TestApp::start_with(&[("PLATEAU_HTTP__SHUTDOWN_NOTICE_MS", FOR_EVER_MS)]).await;
    assert_eq!(app.get("/health/ready").await.status(), StatusCode::OK);
    app.terminate().await;
    // Each check is a new connection, like those of a load balancer.
    let look = || async {
        let client = crate::app::client();
        client.get(format!("{}/health/ready", app.url)).send().await.expect("the listener is open")
    };
    until("the server is not ready", async || look().await.status() != StatusCode::OK).await;
    problem(look().await, 503).await;
    assert_eq!(app.get("/health/live").await.status(), StatusCode::OK);
    app.kill().await;
}
