//! Many clients at once: no job is lost, every mesh is right, memory is bounded, and a full queue is answered with 429.
//!
//! The test of 64 clients runs for five seconds, because memory is observed over time.
//! `scripts/load` runs it for a minute (PLATEAU_LOAD_S).

use crate::app::{MINIMAL, RULED, TestApp, small_film};
use futures_util::StreamExt;
use reqwest::Method;
use serde_json::{Value, json};
use std::collections::BTreeMap;
use std::sync::Arc;
use std::sync::atomic::{AtomicU64, Ordering};
use std::time::{Duration, Instant};

const CLIENTS: u64 = 64;
const MEGABYTE: u64 = 1 << 20;

/// Returns a strip whose optimal area is known: a rectangle of 1 × `height` with `k + 1` points on each side.
fn rectangle(k: u64, height: f64) -> Value {
    let rail = |y: f64| -> Vec<[f64; 3]> { (0..=k).map(|i| [i as f64 / k as f64, y, 0.0]).collect() };
    json!({ "directrices": [rail(0.0), rail(height)] })
}

#[tokio::test(flavor = "multi_thread", worker_threads = 2)]
async fn sixty_four_clients_lose_nothing_and_memory_stays_flat() {
    let duration =
        Duration::from_secs(std::env::var("PLATEAU_LOAD_S").ok().and_then(|text| text.parse().ok()).unwrap_or(5));
    let app = Arc::new(TestApp::start_with(&[("PLATEAU_JOBS__QUEUE_LENGTH", "32")]).await);
    let (done, refused) = (Arc::new(AtomicU64::new(0)), Arc::new(AtomicU64::new(0)));
    let started = Instant::now();
    let clients: Vec<_> = (0..CLIENTS)
        .map(|client| {
            let (app, done, refused) = (app.clone(), done.clone(), refused.clone());
            tokio::spawn(async move {
                let mut ids = Vec::new();
                for round in 0.. {
                    if started.elapsed() > duration {
                        break;
                    }
                    // Every body is different, so that no request reuses a kept result.
                    let height = 1.0 + (client * 100_000 + round) as f64 * 1e-7;
                    let film = round % 8 == 0;
                    let (path, body) =
                        if film { (MINIMAL, small_film(height)) } else { (RULED, rectangle(20, height)) };
                    let response =
                        app.request(Method::POST, path).header("prefer", "wait=30").json(&body).send().await.unwrap();
                    if response.status() == 429 {
                        assert!(response.headers().contains_key("retry-after"));
                        refused.fetch_add(1, Ordering::Relaxed);
                        // A refused client comes back later, so that the refusals do not slow down the solvers.
                        tokio::time::sleep(Duration::from_millis(20)).await;
                        continue;
                    }
                    assert!(response.status().is_success(), "{}", response.status());
                    let job = app.ended(response.json().await.unwrap()).await;
                    assert_eq!(job["status"], "succeeded", "{job}");
                    if !film {
                        let area = job["statistics"]["area"].as_f64().unwrap();
                        assert!((area - height).abs() < 1e-12 * height, "{area} for {height}");
                        assert_eq!(job["statistics"]["triangles"], 40);
                    }
                    ids.push(job["id"].as_str().unwrap().to_owned());
                    done.fetch_add(1, Ordering::Relaxed);
                }
                ids
            })
        })
        .collect();
    // The final memory is compared with the memory after the first fifth of the time, when caches and pools have been
    // filled.
    tokio::time::sleep(duration / 5).await;
    let early = app.memory();
    let mut ids = Vec::new();
    for client in clients {
        ids.extend(client.await.unwrap());
    }
    let late = app.memory();
    let (done, refused) = (done.load(Ordering::Relaxed), refused.load(Ordering::Relaxed));
    println!("{done} jobs, {refused} refusals, memory {} -> {} MiB", early / MEGABYTE, late / MEGABYTE);
    assert!(done > 0);
    assert!(late < early + 96 * MEGABYTE, "memory grew from {early} to {late} bytes");

    // Every job is listed once and has succeeded.
    let mut statuses: BTreeMap<String, String> = BTreeMap::new();
    let mut path = "/v1/jobs?limit=200".to_owned();
    loop {
        let page = app.get_json(&path).await;
        for job in page["jobs"].as_array().unwrap() {
            let repeated = statuses.insert(job["id"].as_str().unwrap().into(), job["status"].as_str().unwrap().into());
            assert!(repeated.is_none(), "a job is listed twice");
        }
        match page["next_cursor"].as_str() {
            Some(cursor) => path = format!("/v1/jobs?limit=200&cursor={cursor}"),
            None => break,
        }
    }
    assert_eq!(statuses.len() as u64, done);
    assert!(ids.iter().all(|id| statuses.get(id).is_some_and(|status| status == "succeeded")));
}

#[tokio::test(flavor = "multi_thread", worker_threads = 2)]
async fn a_watcher_of_a_running_film_takes_little_memory() {
    const WATCHERS: u64 = 400;
    let app = TestApp::start_with(&[("PLATEAU_WORKERS", "1"), ("PLATEAU_JOBS__PROGRESS_INTERVAL_MS", "20")]).await;
    app.hold.at("first_progress");
    let job: Value = app.post(MINIMAL, &small_film(0.1)).await.json().await.unwrap();
    let events = job["links"]["events"].as_str().unwrap();
    // Returns a stream that has delivered the progress of the running film.
    let watch = || async {
        let mut stream = app.get(events).await.bytes_stream();
        let mut text = String::new();
        while !text.contains("event: progress") {
            text.push_str(std::str::from_utf8(&stream.next().await.unwrap().unwrap()).unwrap());
        }
        stream
    };
    let first = watch().await;
    let before = app.memory();
    let mut others = Vec::new();
    for _ in 0..WATCHERS {
        others.push(watch().await);
    }
    let each = app.memory().saturating_sub(before) / WATCHERS;
    println!("{each} bytes for each watcher");
    // A release build needs some 18 kB for each watcher. The bound is wider because a debug build needs more.
    assert!(each < 100_000, "{each} bytes for each watcher");
    drop((first, others));
}
