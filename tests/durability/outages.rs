//! Outages of PostgreSQL that last longer than a lease. They cost a job no attempt, whether all processes or only one
//! worker lose the database.

use crate::cluster::{self, Cluster};
use crate::hold::until;
use crate::postgres::Postgres;
use crate::proxy::Proxy;
use std::time::Duration;

/// Time that is longer than a lease of one second, which is the shortest allowed.
const LONGER_THAN_A_LEASE: Duration = Duration::from_millis(1600);
/// Number of outages in a row. It is larger than the five lost leases after which a job fails by default.
const OUTAGES: usize = 6;

/// Returns the number of the attempt that ended a job.
async fn last_attempt(server: &cluster::Process, id: &str) -> i64 {
    let events = server.get(&cluster::client(), &format!("/v1/jobs/{id}/events")).await.text().await.unwrap();
    let last = events.lines().filter_map(|line| line.strip_prefix("id:")).next_back().expect("an event");
    last.trim().split('.').next().unwrap().parse().unwrap()
}

#[tokio::test(flavor = "multi_thread", worker_threads = 2)]
async fn an_outage_everywhere_neither_stops_a_solver_nor_costs_an_attempt() {
    let Some(postgres) = Postgres::start() else { return };
    // A single lost lease would fail the job.
    let cluster = Cluster::new(Some(postgres.database().await))
        .set("PLATEAU_JOBS__LEASE_MS", 1000)
        .set("PLATEAU_JOBS__ATTEMPTS_MAX", 1);
    let server = cluster.serve(0).await;
    // The second worker is idle and would take over a job whose lease has run out.
    let _workers = [cluster.worker(1), cluster.worker(1)];
    let client = cluster::client();
    cluster.hold.at("first_progress");
    let job = server.post(&client, &cluster::film(100, 0)).await;
    let id = job["id"].as_str().unwrap();
    cluster.hold.reached("first_progress", id).await;
    for _ in 0..OUTAGES {
        postgres.stop();
        tokio::time::sleep(LONGER_THAN_A_LEASE).await;
        postgres.start_again();
        // Every process reaches the database again, and has enough time to treat the lease as lost.
        tokio::time::sleep(LONGER_THAN_A_LEASE).await;
    }
    cluster.hold.release("first_progress");
    assert_eq!(server.ended_job(&client, id).await["status"], "succeeded");
    assert_eq!(last_attempt(&server, id).await, 1, "the first attempt goes on through every outage");
}

#[tokio::test(flavor = "multi_thread", worker_threads = 2)]
async fn a_worker_killed_during_an_outage_costs_no_attempt() {
    let Some(postgres) = Postgres::start() else { return };
    // A single lost lease would fail the job.
    let cluster = Cluster::new(Some(postgres.database().await))
        .set("PLATEAU_JOBS__LEASE_MS", 1000)
        .set("PLATEAU_JOBS__ATTEMPTS_MAX", 1);
    let server = cluster.serve(0).await;
    let client = cluster::client();
    cluster.hold.at("first_progress");
    let job = server.post(&client, &cluster::film(100, 0)).await;
    let id = job["id"].as_str().unwrap();
    let status = async || {
        let job: Option<serde_json::Value> = match server.get(&client, &format!("/v1/jobs/{id}")).await {
            found if found.status().is_success() => found.json().await.ok(),
            _ => None,
        };
        job.map_or_else(String::new, |job| job["status"].as_str().unwrap().to_owned())
    };
    let mut worker = cluster.worker(1);
    cluster.hold.reached("first_progress", id).await;
    postgres.stop();
    worker.kill().await;
    tokio::time::sleep(LONGER_THAN_A_LEASE).await;
    postgres.start_again();
    until("the job has left the killed worker", async || !["", "running"].contains(&&*status().await)).await;
    assert_eq!(status().await, "queued");
    // Without an outage the loss counts.
    cluster.hold.release_all();
    cluster.hold.at("first_progress");
    let mut worker = cluster.worker(1);
    cluster.hold.reached("first_progress", id).await;
    // The worker renews its lease.
    tokio::time::sleep(LONGER_THAN_A_LEASE).await;
    worker.kill().await;
    assert_eq!(server.ended_job(&client, id).await["error"]["type"], "/problems/worker-lost");
}

#[tokio::test(flavor = "multi_thread", worker_threads = 2)]
async fn an_outage_of_one_worker_hands_its_job_over_and_costs_no_attempt() {
    let Some(postgres) = Postgres::start() else { return };
    let url = postgres.database().await;
    let proxy = Proxy::start(&url);
    let settings = [("PLATEAU_JOBS__LEASE_MS", 1000), ("PLATEAU_JOBS__ATTEMPTS_MAX", 2)];
    let cluster =
        |url| settings.iter().fold(Cluster::new(Some(url)), |cluster, (name, value)| cluster.set(name, value));
    let (cut_off, direct) = (cluster(proxy.url()), cluster(url));
    let server = direct.serve(0).await;
    let _worker = cut_off.worker(1);
    let client = cluster::client();
    direct.hold.at("first_progress");
    cut_off.hold.at("first_progress");
    let job = server.post(&client, &cluster::film(100, 0)).await;
    let id = job["id"].as_str().unwrap();
    cut_off.hold.reached("first_progress", id).await;
    let mut other = direct.worker(1);
    proxy.silence(true);
    direct.hold.reached("first_progress", id).await;
    proxy.silence(false);
    // The first worker returns, and learns that it has lost the job.
    until("the first worker gives the job up", async || !cut_off.hold.is_held("first_progress", id)).await;
    // The second worker dies, which would be the second loss.
    other.kill().await;
    cut_off.hold.reached("first_progress", id).await;
    cut_off.hold.release_all();
    assert_eq!(server.ended_job(&client, id).await["status"], "succeeded");
    assert_eq!(last_attempt(&server, id).await, 3);
}
