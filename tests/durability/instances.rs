//! Two HTTP instances and two workers on one PostgreSQL database, shutdown and restart.

use crate::cluster::{self, Cluster, Process};
use crate::postgres::Postgres;
use futures_util::StreamExt;
use reqwest::Client;
use serde_json::Value;
use std::time::{Duration, Instant};

/// Time that is longer than any step takes, so that only a defect exceeds it.
const TOO_LONG: Duration = Duration::from_secs(60);

/// Stream of the server-sent events of one job.
struct Events {
    stream: futures_util::stream::BoxStream<'static, reqwest::Result<bytes::Bytes>>,
    text: String,
}

impl Events {
    async fn open(server: &Process, client: &Client, id: &str) -> Self {
        let response = server.get(client, &format!("/v1/jobs/{id}/events")).await;
        assert_eq!(response.headers()["content-type"], "text/event-stream");
        Self { stream: response.bytes_stream().boxed(), text: String::new() }
    }

    /// Returns the name and data of the next event, or `None` at the end of the stream.
    async fn next(&mut self) -> Option<(String, Value)> {
        loop {
            if let Some((event, rest)) = self.text.split_once("\n\n") {
                let field = |name: &str| event.lines().find_map(|line| line.strip_prefix(name)).map(str::trim);
                let found = field("event:")
                    .zip(field("data:"))
                    .map(|(name, data)| (name.to_owned(), serde_json::from_str(data).expect("data is JSON")));
                self.text = rest.to_owned();
                match found {
                    Some(event) => return Some(event),
                    // An event without data is a comment.
                    None => continue,
                }
            }
            let chunk = tokio::time::timeout(TOO_LONG, self.stream.next()).await.expect("an event in time")?;
            self.text.push_str(std::str::from_utf8(&chunk.expect("the stream goes on")).expect("UTF-8"));
        }
    }

    /// Reads events until a status event has this status.
    async fn until_status(&mut self, status: &str) {
        while let Some((name, data)) = self.next().await {
            if name == "status" && data["status"] == status {
                return;
            }
        }
        panic!("the stream ended before {status}");
    }
}

#[tokio::test(flavor = "multi_thread", worker_threads = 2)]
async fn any_instance_shows_and_cancels_the_jobs_of_any_worker() {
    let Some(postgres) = Postgres::start() else { return };
    let cluster = Cluster::new(Some(postgres.database().await)).set("PLATEAU_JOBS__PROGRESS_INTERVAL_MS", 50);
    let (a, b) = (cluster.serve(0).await, cluster.serve(0).await);
    let client = cluster::client();

    // No worker runs yet, so the job waits.
    cluster.hold.at("first_progress");
    let long = a.post(&client, &cluster::film(100, 0)).await;
    let id = long["id"].as_str().unwrap();
    assert_eq!(long["status"], "queued");
    let mut events = Events::open(&b, &client, id).await;
    events.until_status("queued").await;
    let _workers = [cluster.worker(1), cluster.worker(1)];
    events.until_status("running").await;
    while events.next().await.expect("a running job reports").0 != "progress" {}
    let asked = Instant::now();
    let response = client.post(format!("{}/v1/jobs/{id}/cancel", a.url)).send().await.unwrap();
    assert_eq!(response.json::<Value>().await.unwrap()["status"], "cancelled");
    events.until_status("cancelled").await;
    println!("cancelled on A, seen on B after {} ms", asked.elapsed().as_millis());
    assert_eq!(events.next().await.map(|(name, _)| name), None, "the final event must be the last");
    assert_eq!(b.get_json(&client, &format!("/v1/jobs/{id}")).await["status"], "cancelled");

    cluster.hold.release("first_progress");
    // The workers take other jobs again, and every instance serves the results of any worker.
    let short = b.post(&client, &cluster::strip(30, 1)).await;
    let id = short["id"].as_str().unwrap();
    assert_eq!(a.ended_job(&client, id).await["status"], "succeeded");
    let (from_a, from_b) = (
        a.get(&client, &format!("/v1/jobs/{id}/mesh")).await.bytes().await.unwrap(),
        b.get(&client, &format!("/v1/jobs/{id}/mesh")).await.bytes().await.unwrap(),
    );
    assert!(!from_a.is_empty() && from_a == from_b);
}

#[tokio::test(flavor = "multi_thread", worker_threads = 2)]
async fn a_terminated_server_hands_back_its_jobs_and_the_next_server_finishes_them() {
    let cluster = Cluster::new(None).set("PLATEAU_HTTP__SHUTDOWN_GRACE_MS", 200).set("PLATEAU_JOBS__ATTEMPTS_MAX", 1);
    let mut first = cluster.serve(1).await;
    let client = cluster::client();
    cluster.hold.at("half");
    let running = first.post(&client, &cluster::film(100, 0)).await;
    let queued = first.post(&client, &cluster::strip(20, 1)).await;
    let id = running["id"].as_str().unwrap();
    cluster.hold.reached("half", id).await;
    first.terminate().await;
    assert!(first.ended().await.success());

    cluster.hold.release("half");
    let second = cluster.serve(1).await;
    for job in [&running, &queued] {
        // The jobs were handed back, because a single lost lease would have failed them.
        assert_eq!(second.ended_job(&client, job["id"].as_str().unwrap()).await["status"], "succeeded");
    }
    let events = second.get(&client, &format!("/v1/jobs/{id}/events")).await.text().await.unwrap();
    assert!(events.contains("id: 2.") || events.contains("id:2."), "a second attempt: {events}");
}
