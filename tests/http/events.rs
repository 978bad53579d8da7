//! Server-sent events: status changes, progress, one final status, and replay after a reconnect.

use crate::app::{MINIMAL, TestApp, problem, small_film};
use futures_util::StreamExt;
use reqwest::Method;
use serde_json::Value;

#[derive(Debug)]
struct Event {
    id: String,
    name: String,
    data: Value,
}

fn parse(text: &str) -> Vec<Event> {
    let field = |block: &str, name: &str| {
        block.lines().find_map(|line| line.strip_prefix(name)?.strip_prefix(": ")).map(str::to_owned)
    };
    text.split("\n\n")
        .filter_map(|block| {
            let data = serde_json::from_str(&field(block, "data")?).unwrap();
            Some(Event { id: field(block, "id")?, name: field(block, "event")?, data })
        })
        .collect()
}

fn number(id: &str) -> (u64, u64) {
    let (attempt, sequence) = id.split_once('.').unwrap();
    (attempt.parse().unwrap(), sequence.parse().unwrap())
}

#[tokio::test]
async fn the_events_of_a_job_run_from_queued_to_its_end() {
    let app = TestApp::start_with(&[("PLATEAU_JOBS__PROGRESS_INTERVAL_MS", "20")]).await;
    app.hold.at("first_progress");
    let job: Value = app.post(MINIMAL, &small_film(0.6)).await.json().await.unwrap();
    let events = job["links"]["events"].as_str().unwrap();
    let response = app.get(events).await;
    assert_eq!(response.headers()["content-type"], "text/event-stream");
    assert_eq!(response.headers()["cache-control"], "no-cache");
    assert_eq!(response.headers()["x-accel-buffering"], "no");
    let mut stream = response.bytes_stream();
    let mut text = String::new();
    while let Some(chunk) = stream.next().await {
        let seen = text.contains("event: progress");
        text.push_str(std::str::from_utf8(&chunk.unwrap()).unwrap());
        if !seen && text.contains("event: progress") {
            app.hold.release("first_progress");
        }
    }
    assert!(text.contains("retry: "));
    let list = parse(&text);
    let last = list.last().unwrap();
    assert_eq!((last.name.as_str(), last.data["status"].as_str()), ("status", Some("succeeded")));
    assert!(last.data["statistics"]["area"].is_number());
    assert_eq!(list.iter().filter(|event| event.data["status"] == "succeeded").count(), 1);
    assert!(list.windows(2).all(|pair| number(&pair[0].id) < number(&pair[1].id)), "the ids must increase: {list:?}");
    let progress: Vec<f64> = list
        .iter()
        .filter(|event| event.name == "progress")
        .map(|event| event.data["progress"]["fraction"].as_f64().unwrap())
        .collect();
    assert!(!progress.is_empty() && progress.is_sorted(), "{progress:?}");

    // A reconnect replays the events after the given one. After the final event the answer is 204.
    let reconnect = |id: String| app.request(Method::GET, events).header("last-event-id", id).send();
    let replay = parse(&reconnect(list[0].id.clone()).await.unwrap().text().await.unwrap());
    assert_eq!(replay.last().unwrap().id, last.id);
    assert!(replay.iter().all(|event| number(&event.id) > number(&list[0].id)));
    assert_eq!(reconnect(last.id.clone()).await.unwrap().status(), 204);
}

#[tokio::test]
async fn the_events_of_a_finished_job_are_sent_at_once() {
    let app = TestApp::start().await;
    let job = app.solve(MINIMAL, &small_film(0.7)).await;
    let list = parse(&app.get(job["links"]["events"].as_str().unwrap()).await.text().await.unwrap());
    assert_eq!(list.last().unwrap().data, job);
    let statuses: Vec<&str> = list.iter().map(|event| event.data["status"].as_str().unwrap()).collect();
    assert_eq!(statuses, ["queued", "running", "succeeded"]);
    // Each status event has the job as it was then.
    for event in &list {
        let fields = |value: &Value| value.as_object().unwrap().keys().cloned().collect::<Vec<_>>();
        assert_eq!((&event.data["id"], fields(&event.data)), (&job["id"], fields(&job)), "{}", event.data);
    }
    assert!(list[0].data["started_at"].is_null() && list[1].data["started_at"].is_string());
    assert!(list[..2].iter().all(|event| event.data["finished_at"].is_null() && event.data["statistics"].is_null()));
}

#[tokio::test]
async fn a_cancelled_job_ends_its_streams() {
    let app = TestApp::start_with(&[("PLATEAU_WORKERS", "1")]).await;
    app.hold.at("claimed");
    let job: Value = app.post(MINIMAL, &small_film(0.1)).await.json().await.unwrap();
    let mut stream = app.get(job["links"]["events"].as_str().unwrap()).await.bytes_stream();
    let mut text = String::from_utf8(stream.next().await.unwrap().unwrap().to_vec()).unwrap();
    app.request(Method::POST, job["links"]["cancel"].as_str().unwrap()).send().await.unwrap();
    while let Some(chunk) = stream.next().await {
        text.push_str(std::str::from_utf8(&chunk.unwrap()).unwrap());
    }
    assert_eq!(parse(&text).last().unwrap().data["status"], "cancelled");
}

#[tokio::test]
async fn the_last_event_of_a_deleted_job_says_so() {
    let app = TestApp::start_with(&[("PLATEAU_WORKERS", "0")]).await;
    let job: Value = app.post(MINIMAL, &small_film(0.1)).await.json().await.unwrap();
    let mut stream = app.get(job["links"]["events"].as_str().unwrap()).await.bytes_stream();
    let mut text = String::new();
    while parse(&text).is_empty() {
        text.push_str(std::str::from_utf8(&stream.next().await.unwrap().unwrap()).unwrap());
    }
    let deleted = app.request(Method::DELETE, job["links"]["self"].as_str().unwrap()).send().await.unwrap();
    assert_eq!(deleted.status(), 204);
    while let Some(chunk) = stream.next().await {
        text.push_str(std::str::from_utf8(&chunk.unwrap()).unwrap());
    }
    let list = parse(&text);
    assert_eq!(list.len(), 2, "{list:?}");
    assert_eq!((&list[1].data["status"], &list[1].data["cancelled_because"]), (&"cancelled".into(), &"deleted".into()));
    assert!(number(&list[0].id) < number(&list[1].id));
}

#[tokio::test]
async fn a_last_event_id_of_another_form_is_refused() {
    let app = TestApp::start_with(&[("PLATEAU_WORKERS", "0")]).await;
    let job: Value = app.post(MINIMAL, &small_film(0.1)).await.json().await.unwrap();
    let path = job["links"]["events"].as_str().unwrap();
    for id in ["abc", "1", "1.2.3", "-1.2", "1.x"] {
        let answer = app.request(Method::GET, path).header("last-event-id", id).send().await.unwrap();
        assert_eq!(problem(answer, 400).await["type"], "/problems/bad-header", "{id}");
    }
    // A browser without a last event sends none, and an empty one means the same.
    let answer = app.request(Method::GET, path).header("last-event-id", "").send().await.unwrap();
    assert_eq!(answer.status(), 200);
}

#[tokio::test]
async fn a_silent_stream_is_kept_open_by_comments() {
    let app = TestApp::start_with(&[("PLATEAU_WORKERS", "0"), ("PLATEAU_HTTP__EVENT_KEEP_ALIVE_MS", "50")]).await;
    let job: Value = app.post(MINIMAL, &small_film(0.8)).await.json().await.unwrap();
    let mut stream = app.get(job["links"]["events"].as_str().unwrap()).await.bytes_stream();
    let mut text = String::new();
    while !text.contains(": still here") {
        text.push_str(std::str::from_utf8(&stream.next().await.unwrap().unwrap()).unwrap());
    }
    drop(stream);

    // A stream without a new event sends the reconnection time at once, so a client that receives nothing knows that a
    // proxy buffers the stream.
    let seen = parse(&text).last().unwrap().id.clone();
    let events = app.request(Method::GET, job["links"]["events"].as_str().unwrap()).header("last-event-id", seen);
    let first = events.send().await.unwrap().bytes_stream().next().await.unwrap().unwrap();
    assert_eq!(std::str::from_utf8(&first).unwrap(), "retry: 2000\n\n");
    problem(app.get("/v1/jobs/01J00000000000000000000000/events").await, 404).await;
}
