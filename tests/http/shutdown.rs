//! A shutdown: readiness goes off while the listener still takes connections, and nobody who waits holds it up or goes
//! unanswered.

use crate::app::{MINIMAL, TestApp, problem, small_film};
use reqwest::{Method, StatusCode};
use serde_json::{Value, json};

/// Longer than any test takes; only a defect waits for it.
const FOR_EVER_MS: &str = "3600000";

#[tokio::test]
async fn a_client_that_waits_gets_its_job_as_it_is() {
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
        // The two submissions wait once their jobs are there.
        while app.get_json("/v1/jobs").await["jobs"].as_array().unwrap().len() < 3 {}
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
async fn a_watcher_does_not_hold_up_a_shutdown() {
    let app = TestApp::start_with(&[("PLATEAU_WORKERS", "0"), ("PLATEAU_HTTP__SHUTDOWN_GRACE_MS", FOR_EVER_MS)]).await;
    let job: Value = app.post(MINIMAL, &small_film(0.1)).await.json().await.unwrap();
    let events = app.get(job["links"]["events"].as_str().unwrap()).await;
    app.terminate().await;
    assert!(events.text().await.unwrap().contains("\"status\":\"queued\""), "the stream ends whole");
    let (status, _folder) = app.exited().await;
    assert_eq!(status.code(), Some(0));
}

#[tokio::test]
async fn readiness_goes_off_before_the_listener_closes() {
    let app = TestApp::start_with(&[("PLATEAU_HTTP__SHUTDOWN_NOTICE_MS", FOR_EVER_MS)]).await;
    assert_eq!(app.get("/health/ready").await.status(), StatusCode::OK);
    app.terminate().await;
    // Each look is a new connection, as a load balancer's is.
    let look = || async {
        let client = crate::app::client();
        client.get(format!("{}/health/ready", app.url)).send().await.expect("the listener is open")
    };
    let refused = loop {
        let response = look().await;
        if response.status() != StatusCode::OK {
            break response;
        }
    };
    problem(refused, 503).await;
    assert_eq!(app.get("/health/live").await.status(), StatusCode::OK);
    app.kill().await;
}
