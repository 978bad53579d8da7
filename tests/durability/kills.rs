//! Processes are killed at random moments under load. Every accepted job must end exactly once, with the mesh that an
//! undisturbed server makes of the same request. Each test kills four times in the first tier of
//! `scripts/test`, ten times in the second, and a hundred times with `PLATEAU_LONG=1`.

use crate::cluster::{self, Cluster, Process};
use crate::hold::until;
use crate::postgres::Postgres;
use reqwest::{Client, StatusCode};
use serde_json::Value;
use std::collections::{BTreeMap, BTreeSet};
use std::sync::atomic::{AtomicBool, Ordering};
use std::sync::{Arc, Mutex, RwLock};
use std::time::Duration;
use tokio::task::JoinSet;

const CLIENTS: usize = 6;
/// Number of different requests. Each mesh is compared with the reference mesh of its request.
const SHAPES: usize = 12;

fn kills() -> usize {
    match (std::env::var_os("PLATEAU_LONG").is_some(), crate::is_full()) {
        (true, _) => 100,
        (false, true) => 10,
        (false, false) => 4,
    }
}

/// Returns a small request: a strip or a film. The holds decide in which states a kill finds them.
fn shape(number: usize) -> Value {
    if number.is_multiple_of(2) { cluster::strip(20, number) } else { cluster::film(100, number) }
}

/// Returns the meshes of all shapes from an undisturbed server.
async fn references() -> Vec<Vec<u8>> {
    let cluster = Cluster::new(None);
    let server = cluster.serve(2).await;
    let client = cluster::client();
    let mut meshes = Vec::new();
    for number in 0..SHAPES {
        let job = server.post(&client, &shape(number)).await;
        let id = job["id"].as_str().unwrap();
        assert_eq!(server.ended_job(&client, id).await["status"], "succeeded");
        meshes.push(mesh(&server, &client, id).await);
    }
    assert_eq!(meshes.iter().collect::<BTreeSet<_>>().len(), SHAPES, "every shape has a mesh of its own");
    meshes
}

async fn mesh(server: &Process, client: &Client, id: &str) -> Vec<u8> {
    let response = server.get(client, &format!("/v1/jobs/{id}/mesh")).await;
    assert_eq!(response.status(), StatusCode::OK);
    response.bytes().await.unwrap().to_vec()
}

/// Clients that post until they are told to stop. Each submission has its own idempotency key and is repeated until it
/// is acknowledged.
pub struct Load {
    /// Current address of the server.
    url: Arc<RwLock<String>>,
    stop: Arc<AtomicBool>,
    /// Jobs that were accepted so far.
    accepted: Arc<Mutex<Vec<String>>>,
    clients: JoinSet<BTreeMap<String, (usize, String)>>,
}

impl Load {
    pub fn start(url: &str) -> Self {
        let url = Arc::new(RwLock::new(url.to_owned()));
        let stop = Arc::new(AtomicBool::new(false));
        let accepted = Arc::new(Mutex::new(Vec::new()));
        let mut clients = JoinSet::new();
        for number in 0..CLIENTS {
            clients.spawn(post_until_told(number, Arc::clone(&url), Arc::clone(&stop), Arc::clone(&accepted)));
        }
        Self { url, stop, accepted, clients }
    }

    pub fn moved_to(&self, url: &str) {
        url.clone_into(&mut self.url.write().unwrap());
    }

    /// Waits until a few more jobs have been accepted, however slow the machine is, so that a kill finds work to
    /// interrupt.
    pub async fn some_are_accepted(&self) {
        let seen = self.accepted().len();
        until("four more jobs are accepted", async || self.accepted().len() >= seen + 4).await;
    }

    fn accepted(&self) -> Vec<String> {
        self.accepted.lock().unwrap().clone()
    }

    /// Waits until every job that was accepted so far has ended. By default a job fails after five lost leases. Without
    /// this wait, every kill could hit the same job, because a job whose worker died goes back to the head of the
    /// queue.
    pub async fn all_have_ended(&self, server: &Process) {
        let client = cluster::client();
        for id in self.accepted() {
            server.ended_job(&client, &id).await;
        }
    }

    /// Returns the accepted submissions: shape and job identifier by idempotency key.
    pub async fn finish(mut self) -> BTreeMap<String, (usize, String)> {
        self.stop.store(true, Ordering::Relaxed);
        let mut accepted = BTreeMap::new();
        while let Some(client) = self.clients.join_next().await {
            accepted.extend(client.unwrap());
        }
        accepted
    }
}

async fn post_until_told(
    number: usize,
    url: Arc<RwLock<String>>,
    stop: Arc<AtomicBool>,
    total: Arc<Mutex<Vec<String>>>,
) -> BTreeMap<String, (usize, String)> {
    let client = cluster::client();
    let mut accepted = BTreeMap::new();
    for count in 0.. {
        if stop.load(Ordering::Relaxed) {
            break;
        }
        let (key, shape_number) = (format!("{number}-{count}"), (number + count) % SHAPES);
        let body = shape(shape_number);
        let id = loop {
            let to = format!("{}{}", url.read().unwrap(), cluster::path(&body));
            // Most submissions do not wait and some do, so that there is always work but never too much.
            let wait = if count % 4 == 3 { "wait=2" } else { "wait=0" };
            let request = client.post(to).header("idempotency-key", &key).header("prefer", wait).json(&body);
            let Ok(response) = request.send().await else {
                tokio::task::yield_now().await;
                continue;
            };
            match response.status() {
                StatusCode::OK | StatusCode::ACCEPTED => {
                    // If the server was killed between head and body, the job is not acknowledged yet.
                    let Ok(job) = response.json::<Value>().await else { continue };
                    break job["id"].as_str().unwrap().to_owned();
                }
                StatusCode::SERVICE_UNAVAILABLE | StatusCode::TOO_MANY_REQUESTS => tokio::task::yield_now().await,
                other => panic!("{other}: {}", response.text().await.unwrap_or_default()),
            }
        };
        total.lock().unwrap().push(id.clone());
        accepted.insert(key, (shape_number, id));
    }
    accepted
}

/// Moments for kills. Half of them find jobs that are held at a stage, at each stage in turn. The others are
/// pseudo-random, so that kills also fall between the stages and into writes.
struct Moments(u64);

impl Moments {
    /// Waits for the moment of a kill. `workers` is the number of jobs that can be held at once.
    async fn next(&mut self, cluster: &Cluster, number: usize, workers: usize) {
        let stages = ["claimed", "first_progress", "half", "storing"];
        if number.is_multiple_of(2) {
            let stage = stages[number / 2 % stages.len()];
            cluster.hold.at(stage);
            cluster.hold.reached_by(stage, workers).await;
        } else {
            self.pause().await;
        }
    }

    async fn pause(&mut self) {
        self.0 = self.0.wrapping_mul(6364136223846793005).wrapping_add(1442695040888963407);
        tokio::time::sleep(Duration::from_millis(50 + (self.0 >> 33) % 450)).await;
    }
}

pub async fn every_job_ended_once(server: &Process, accepted: &BTreeMap<String, (usize, String)>, what: &str) {
    let client = cluster::client();
    let references = references().await;
    let mut attempts = BTreeMap::<i64, usize>::new();
    for (key, (shape_number, id)) in accepted {
        let job = server.ended_job(&client, id).await;
        assert_eq!(job["status"], "succeeded", "{job:#}");
        assert!(mesh(server, &client, id).await == references[*shape_number], "{id}: another mesh");
        // The complete history must have one success at the end and nothing after it.
        let events = server.get(&client, &format!("/v1/jobs/{id}/events")).await.text().await.unwrap();
        let ids: Vec<&str> = events.lines().filter_map(|line| line.strip_prefix("id:")).map(str::trim).collect();
        assert_eq!(events.matches(r#""status":"succeeded""#).count(), 1, "{events}");
        let attempt = ids.last().unwrap().split('.').next().unwrap().parse().unwrap();
        *attempts.entry(attempt).or_default() += 1;
        // The key must still return this job.
        let body = shape(*shape_number);
        let request = client.post(format!("{}{}", server.url, cluster::path(&body))).header("idempotency-key", key);
        let again: Value = request.json(&body).send().await.unwrap().json().await.unwrap();
        assert_eq!(again["id"].as_str(), Some(id.as_str()), "{key}");
    }
    // Each submission has exactly one job: repetitions created none, and there are no others.
    let mut listed = BTreeSet::new();
    let mut cursor = String::new();
    loop {
        let page = server.get_json(&client, &format!("/v1/jobs?limit=200{cursor}")).await;
        listed.extend(page["jobs"].as_array().unwrap().iter().map(|job| job["id"].as_str().unwrap().to_owned()));
        match page["next_cursor"].as_str() {
            Some(next) => cursor = format!("&cursor={next}"),
            None => break,
        }
    }
    assert_eq!(listed, accepted.values().map(|(_, id)| id.clone()).collect());
    println!("{what}: {} jobs accepted, all ended once; by attempts needed: {attempts:?}", listed.len());
    assert!(accepted.len() > kills(), "there must be more jobs than kills");
}

/// Number of kills after which a test waits until every job has ended. It is below the five lost leases after which a
/// job fails.
const KILLS_IN_A_ROW: usize = 4;

pub fn hardened(database: Option<String>) -> Cluster {
    // A lease of one second is the shortest allowed.
    Cluster::new(database).set("PLATEAU_JOBS__LEASE_MS", 1000)
}

async fn server_killed(database: Option<String>, what: &str) {
    let cluster = hardened(database);
    let mut server = cluster.serve(2).await;
    let load = Load::start(&server.url);
    let mut moments = Moments(7);
    for number in 0..kills() {
        load.some_are_accepted().await;
        moments.next(&cluster, number, 2).await;
        server.kill().await;
        cluster.hold.release_all();
        server = cluster.serve(2).await;
        load.moved_to(&server.url);
        if number % KILLS_IN_A_ROW == KILLS_IN_A_ROW - 1 {
            load.all_have_ended(&server).await;
        }
    }
    let accepted = load.finish().await;
    every_job_ended_once(&server, &accepted, what).await;
}

#[tokio::test(flavor = "multi_thread", worker_threads = 2)]
async fn a_server_killed_on_sqlite_loses_nothing() {
    server_killed(None, "server on SQLite").await;
}

#[tokio::test(flavor = "multi_thread", worker_threads = 2)]
async fn a_server_killed_on_postgresql_loses_nothing() {
    let Some(postgres) = Postgres::start() else { return };
    server_killed(Some(postgres.database().await), "server on PostgreSQL").await;
}

/// Kills the processes of the jobs that run, every job of the queue being in one.
async fn children_killed(database: Option<String>, what: &str) {
    let cluster = hardened(database).set("PLATEAU_JOBS__THREAD_BYTES", 0);
    let server = cluster.serve(2).await;
    let load = Load::start(&server.url);
    let mut moments = Moments(17);
    for number in 0..kills() {
        load.some_are_accepted().await;
        moments.next(&cluster, number, 2).await;
        until("a child is killed", async || server.kill_children() > 0).await;
        cluster.hold.release_all();
        if number % KILLS_IN_A_ROW == KILLS_IN_A_ROW - 1 {
            load.all_have_ended(&server).await;
        }
    }
    let accepted = load.finish().await;
    every_job_ended_once(&server, &accepted, what).await;
}

#[tokio::test(flavor = "multi_thread", worker_threads = 2)]
async fn children_killed_while_the_server_lives_lose_nothing_on_sqlite() {
    children_killed(None, "children on SQLite").await;
}

#[tokio::test(flavor = "multi_thread", worker_threads = 2)]
async fn children_killed_while_the_server_lives_lose_nothing_on_postgresql() {
    let Some(postgres) = Postgres::start() else { return };
    children_killed(Some(postgres.database().await), "children on PostgreSQL").await;
}

#[tokio::test(flavor = "multi_thread", worker_threads = 2)]
async fn workers_killed_while_the_server_lives_lose_nothing() {
    let Some(postgres) = Postgres::start() else { return };
    let cluster = hardened(Some(postgres.database().await));
    let server = cluster.serve(0).await;
    let mut workers = [cluster.worker(1), cluster.worker(1)];
    let load = Load::start(&server.url);
    let mut moments = Moments(11);
    for number in 0..kills() {
        load.some_are_accepted().await;
        moments.next(&cluster, number, 2).await;
        let worker = &mut workers[number / 2 % 2];
        worker.kill().await;
        cluster.hold.release_all();
        *worker = cluster.worker(1);
        if number % KILLS_IN_A_ROW == KILLS_IN_A_ROW - 1 {
            load.all_have_ended(&server).await;
        }
    }
    let accepted = load.finish().await;
    every_job_ended_once(&server, &accepted, "workers on PostgreSQL").await;
}

#[tokio::test(flavor = "multi_thread", worker_threads = 2)]
async fn postgresql_stopped_and_started_again_loses_nothing() {
    let Some(postgres) = Postgres::start() else { return };
    let cluster = hardened(Some(postgres.database().await));
    let mut server = cluster.serve(1).await;
    let mut worker = cluster.worker(1);
    let load = Load::start(&server.url);
    let mut moments = Moments(13);
    for number in 0..kills() {
        load.some_are_accepted().await;
        moments.next(&cluster, number, 2).await;
        postgres.stop();
        // While the database is stopped, a process may be killed too.
        match number % 3 {
            1 => worker.kill().await,
            2 => server.kill().await,
            _ => {}
        }
        cluster.hold.release_all();
        // The database stays away for a while, so that the processes that are still alive try again.
        moments.pause().await;
        postgres.start_again();
        match number % 3 {
            1 => worker = cluster.worker(1),
            2 => server = cluster.serve(1).await,
            _ => {}
        }
        load.moved_to(&server.url);
        if number % KILLS_IN_A_ROW == KILLS_IN_A_ROW - 1 {
            load.all_have_ended(&server).await;
        }
    }
    let accepted = load.finish().await;
    every_job_ended_once(&server, &accepted, "PostgreSQL restarted").await;
}
