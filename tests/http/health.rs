//! Health checks, metrics and request identifiers.

use crate::app::{MINIMAL, TestApp, small_film};
use reqwest::Method;
use serde_json::Value;
use std::collections::BTreeSet;

#[tokio::test]
async fn a_started_server_is_live_and_ready() {
    let app = TestApp::start().await;
    assert_eq!(app.get_json("/health/live").await["status"], "live");
    assert_eq!(app.get_json("/health/ready").await["status"], "ready");
}

#[tokio::test]
async fn metrics_count_jobs_requests_and_the_queue() {
    let app = TestApp::start().await;
    app.solve(MINIMAL, &small_film(0.9)).await;
    app.get("/nowhere").await;
    let response = app.get("/metrics").await;
    assert!(response.headers()["content-type"].to_str().unwrap().starts_with("text/plain"));
    let text = response.text().await.unwrap();
    for line in [
        "plateau_jobs_total{kind=\"minimal_surface\",status=\"succeeded\"} 1",
        "plateau_submissions_total{kind=\"minimal_surface\",outcome=\"created\"} 1",
        "plateau_solve_seconds_count{kind=\"minimal_surface\"} 1",
        "plateau_queue_wait_seconds_count{kind=\"minimal_surface\"} 1",
        "plateau_queue_length 0",
        "plateau_jobs_running 0",
        "plateau_build_info{version=\"0.1.0\"} 1",
        "plateau_http_requests_total{method=\"GET\",route=\"unmatched\",status=\"404\"} 1",
        "plateau_http_requests_total{method=\"POST\",route=\"/v1/minimal-surfaces\",status=\"200\"} 1",
    ] {
        assert!(text.lines().any(|found| found == line), "{line} is not in\n{text}");
    }
    for name in [
        "process_cpu_seconds_total",
        "process_resident_memory_bytes",
        "process_virtual_memory_bytes",
        "process_open_fds",
        "process_max_fds",
        "process_threads",
        "process_start_time_seconds",
    ] {
        let value = text.lines().find_map(|line| line.strip_prefix(name)?.trim().parse::<f64>().ok());
        assert!(value.is_some_and(|value| value > 0.0), "{name} is not in\n{text}");
    }
}

/// Returns the time series of requests, without their values.
async fn request_series(app: &TestApp) -> BTreeSet<String> {
    let text = app.get("/metrics").await.text().await.unwrap();
    let lines = text.lines().filter(|line| line.starts_with("plateau_http_request"));
    lines.map(|line| line.rsplit_once(' ').expect("a value").0.to_owned()).collect()
}

#[tokio::test]
async fn invented_methods_and_unknown_paths_add_one_label_value_each() {
    let app = TestApp::start().await;
    let ask = async |method: &str, path: &str| {
        let method = Method::from_bytes(method.as_bytes()).unwrap();
        assert!(app.request(method, path).send().await.unwrap().status().is_client_error());
    };
    for method in ["PUT", "INVENTED"] {
        ask(method, "/v1/jobs").await;
        ask(method, "/nowhere").await;
    }
    let first = request_series(&app).await;
    let other = |route: &str| {
        let labels = format!("plateau_http_requests_total{{method=\"other\",route=\"{route}\",");
        first.iter().filter(|series| series.starts_with(&labels)).count()
    };
    assert_eq!((other("/v1/jobs"), other("unmatched")), (1, 1), "{first:#?}");
    for number in 0..50 {
        ask(&format!("INVENTED{number}"), "/v1/jobs").await;
        ask(&format!("INVENTED{number}"), &format!("/nowhere/{number}")).await;
    }
    // The first call of `request_series` was itself a request, which has been counted since.
    let counted_since = |series: &&String| !series.contains("route=\"/metrics\"");
    let later = request_series(&app).await;
    let new: Vec<_> = later.difference(&first).filter(counted_since).collect();
    assert!(new.is_empty(), "{} new series, such as {:?}", new.len(), new.first());
}

#[tokio::test]
async fn a_request_id_is_returned_and_an_invalid_one_is_replaced() {
    let app = TestApp::start().await;
    let ask = |id: &'static str| app.request(Method::GET, "/health/live").header("x-request-id", id).send();
    assert_eq!(ask("my-id-7").await.unwrap().headers()["x-request-id"], "my-id-7");
    let replaced = ask("with blanks").await.unwrap().headers()["x-request-id"].to_str().unwrap().to_owned();
    assert_eq!(replaced.len(), 26);
}

#[tokio::test]
async fn cancelled_jobs_are_counted_once_whether_they_ran_or_waited() {
    let app = TestApp::start_with(&[("PLATEAU_WORKERS", "1")]).await;
    app.hold.at("claimed");
    let running: Value = app.post(MINIMAL, &small_film(0.1)).await.json().await.unwrap();
    app.hold.reached("claimed", running["id"].as_str().unwrap()).await;
    let queued: Value = app.post(MINIMAL, &small_film(0.2)).await.json().await.unwrap();
    // The queued job is cancelled first: the worker would otherwise take it as soon as the running one has stopped.
    for job in [&queued, &running, &running] {
        app.request(Method::POST, job["links"]["cancel"].as_str().unwrap()).send().await.unwrap();
    }
    app.hold.release("claimed");
    // After this job has ended, the worker has finished with the first one.
    app.solve(MINIMAL, &small_film(0.3)).await;
    let text = app.get("/metrics").await.text().await.unwrap();
    let mut jobs: Vec<&str> = text.lines().filter(|line| line.starts_with("plateau_jobs_total{")).collect();
    jobs.sort_unstable();
    assert_eq!(
        jobs,
        [
            "plateau_jobs_total{kind=\"minimal_surface\",status=\"cancelled\"} 2",
            "plateau_jobs_total{kind=\"minimal_surface\",status=\"succeeded\"} 1",
        ]
    );
}
