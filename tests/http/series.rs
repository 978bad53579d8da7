//! Labels and metadata of jobs, series of which only the newest job counts, and jobs that end with their connection.

use crate::app::{MINIMAL, TestApp, pointers, problem, small_film};
use crate::hold::until;
use reqwest::Method;
use serde_json::{Value, json};

async fn submitted(app: &TestApp, request: &Value) -> Value {
    let response = app.post(MINIMAL, request).await;
    assert_eq!(response.status(), 202);
    response.json().await.unwrap()
}

async fn job(app: &TestApp, id: &Value) -> Value {
    app.get_json(&format!("/v1/jobs/{}", id.as_str().unwrap())).await
}

#[tokio::test]
async fn a_job_and_the_list_show_its_label_and_metadata() {
    let app = TestApp::start().await;
    let plain = app.solve(MINIMAL, &small_film(0.4)).await;
    assert_eq!((&plain["label"], &plain["metadata"]), (&Value::Null, &Value::Null));
    let mut request = small_film(0.4);
    request["label"] = "Façade 3".into();
    request["metadata"] = json!({ "layer": { "name": "roof" }, "revision": 7 });
    let marked = app.solve(MINIMAL, &request).await;
    assert_ne!(marked["id"], plain["id"]);
    // The label does not change the result, so the stored one is shared.
    assert_eq!(marked["statistics"], plain["statistics"]);
    let listed = app.get_json("/v1/jobs?limit=1").await["jobs"][0].clone();
    for shown in [&marked, &listed, &job(&app, &marked["id"]).await] {
        assert_eq!((&shown["label"], &shown["metadata"]), (&request["label"], &request["metadata"]));
    }
    for (name, value) in [
        ("label", json!("x".repeat(201))),
        ("label", json!("two\nlines")),
        ("metadata", json!([1])),
        ("metadata", json!({ "long": "x".repeat(4096) })),
        ("supersede", json!("")),
        ("supersede", json!("a\u{0}")),
    ] {
        let mut request = small_film(0.4);
        request[name] = value;
        let refused = problem(app.post(MINIMAL, &request).await, 422).await;
        assert_eq!(pointers(&refused), [format!("/{name}")]);
    }
}

#[tokio::test]
async fn a_newer_request_of_a_series_cancels_the_older_ones() {
    let app = TestApp::start_with(&[("PLATEAU_WORKERS", "1")]).await;
    let of = |series: &str, height: f64| {
        let mut film = small_film(height);
        film["supersede"] = series.into();
        film
    };
    app.hold.at("claimed");
    let running = submitted(&app, &of("drag-1", 0.1)).await;
    app.hold.reached("claimed", running["id"].as_str().unwrap()).await;
    let queued = submitted(&app, &of("drag-1", 0.2)).await;
    let other = submitted(&app, &of("drag-2", 0.3)).await;
    let mut last = small_film(0.4);
    last["supersede"] = "drag-1".into();
    let last = submitted(&app, &last).await;
    for stale in [&running, &queued] {
        assert_eq!(job(&app, &stale["id"]).await["status"], "cancelled");
    }
    assert_ne!(job(&app, &other["id"]).await["status"], "cancelled");
    let cancel = format!("{}/cancel", other["links"]["self"].as_str().unwrap());
    app.request(Method::POST, &cancel).send().await.unwrap();
    app.hold.release("claimed");
    assert_eq!(app.ended(last).await["status"], "succeeded");
    // A request that is solved at once supersedes too, and a batch has no series.
    let mut film = small_film(0.5);
    film["kind"] = "minimal_surface".into();
    for (name, value) in [("supersede", json!("drag-1")), ("cancel_on_disconnect", json!(true))] {
        let mut marked = film.clone();
        marked[name] = value;
        let refused = problem(app.post("/v1/batches", &json!({ "requests": [film, marked] })).await, 422).await;
        assert_eq!(pointers(&refused), [format!("/requests/1/{name}")]);
    }
}

#[tokio::test]
async fn a_job_is_cancelled_with_its_connection_if_the_client_asked_for_that() {
    let app = TestApp::start_with(&[("PLATEAU_WORKERS", "1")]).await;
    app.hold.at("claimed");
    // The job that has to stay comes first, so that a wrong cancel would be seen once the other job is cancelled.
    let mut kept = Value::Null;
    for (count, asked) in [(1, false), (2, true)] {
        let mut film = small_film(if asked { 0.6 } else { 0.7 });
        film["cancel_on_disconnect"] = asked.into();
        let waiting = app.request(Method::POST, MINIMAL).header("prefer", "wait=60").json(&film);
        tokio::select! {
            answer = waiting.send() => panic!("a held job was answered: {answer:?}"),
            () = app.submitted(count) => {}
        }
        let newest = app.get_json("/v1/jobs?limit=1").await["jobs"][0].clone();
        if asked {
            let cancelled = async || job(&app, &newest["id"]).await["status"] == "cancelled";
            until("the job is cancelled", cancelled).await;
        } else {
            kept = newest;
        }
    }
    app.hold.reached("claimed", kept["id"].as_str().unwrap()).await;
    assert_eq!(job(&app, &kept["id"]).await["status"], "running");
    app.request(Method::DELETE, kept["links"]["self"].as_str().unwrap()).send().await.unwrap();
    let mut film = small_film(0.8);
    film["cancel_on_disconnect"] = true.into();
    assert_eq!(pointers(&problem(app.post(MINIMAL, &film).await, 422).await), ["/cancel_on_disconnect"]);
    // The job outlives a wait that ends before it.
    let mut film = small_film(0.9);
    film["cancel_on_disconnect"] = true.into();
    let response = app.request(Method::POST, MINIMAL).header("prefer", "wait=1").json(&film).send().await.unwrap();
    assert_eq!(response.status(), 202);
    let kept: Value = response.json().await.unwrap();
    assert_ne!(job(&app, &kept["id"]).await["status"], "cancelled");
}
