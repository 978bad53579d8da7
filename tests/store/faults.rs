//! The promises of the store on PostgreSQL behind a network that cuts, silences and delays connections.

use crate::postgres::Postgres;
use crate::proxy::{Fault, Proxy};
use std::sync::Arc;
use std::time::{Duration, Instant};

use plateau::status::Status;
use plateau::store::{Addition, Lookup, NewJob, Outcome, Renewed, Store, StoreOptions};
use sha2::{Digest, Sha256};
use tempfile::TempDir;

const LEASE: Duration = Duration::from_secs(60);

/// A store whose connections go through a proxy, and which keeps every result in a file.
struct Faulty {
    store: Store,
    proxy: Proxy,
    results: TempDir,
    _server: Postgres,
}

impl Faulty {
    /// Returns `None` if this machine has no PostgreSQL.
    async fn new() -> Option<Self> {
        let server = Postgres::start()?;
        let proxy = Proxy::start(&server.database().await);
        let results = tempfile::tempdir().unwrap();
        let options = StoreOptions {
            results: Some(results.path().display().to_string()),
            inline_bytes: 0,
            ..StoreOptions::default()
        };
        let store = Store::open(&proxy.url(), options).await.unwrap();
        Some(Self { store, proxy, results, _server: server })
    }

    fn files(&self) -> Vec<String> {
        let entries = std::fs::read_dir(self.results.path()).unwrap();
        entries.map(|entry| entry.unwrap().file_name().into_string().unwrap()).collect()
    }
}

fn job(number: usize) -> NewJob {
    NewJob {
        id: format!("{number:026}"),
        kind: "ruled_surface".into(),
        owner: None,
        request: b"{}".to_vec(),
        source: None,
        request_hash: [number as u8; 32],
        idempotency_key: Some(number.to_string()),
        body_hash: [number as u8; 32],
        callback_url: None,
        label: None,
        metadata: None,
        supersede: None,
        memory_bytes: 0,
        reuse: true,
    }
}

fn success(artefact: &[u8]) -> Arc<Outcome> {
    Arc::new(Outcome::Succeeded {
        statistics: "{}".into(),
        summary: "{}".into(),
        warnings: "[]".into(),
        artefact: artefact.to_vec(),
        artefact_hash: Sha256::digest(artefact).into(),
        reusable: true,
    })
}

async fn status(store: &Store, id: &str) -> Status {
    match store.get(id, None).await.unwrap() {
        Lookup::Found(row) => row.status,
        other => panic!("expected {id}, got {other:?}"),
    }
}

#[tokio::test(flavor = "multi_thread", worker_threads = 2)]
async fn an_outcome_whose_commit_was_not_acknowledged_is_stored_once_and_its_file_stays() {
    let Some(faulty) = Faulty::new().await else { return };
    let store = &faulty.store;
    assert!(matches!(store.add_job(job(1)).await, Ok(Addition::Created(..))));
    let claimed = store.claim("worker", LEASE).await.unwrap().unwrap();
    let lost = faulty.proxy.disturb_commit("UPDATE requests SET source", Fault::CutAfter);
    let renewal = faulty.proxy.disturb("SET lease_until", Fault::CutBefore);
    assert!(store.finish(&claimed.id, claimed.attempt, success(b"mesh")).await.is_err());
    assert!(lost.yet());
    // The worker does not learn from its renewal that the job has ended.
    assert!(store.renew(&claimed.id, claimed.attempt, LEASE).await.is_err());
    assert!(renewal.yet());
    assert!(store.finish(&claimed.id, claimed.attempt, success(b"mesh")).await.unwrap(), "the outcome is this one");
    assert_eq!(status(store, &claimed.id).await, Status::Succeeded);
    assert_eq!(store.artefact(&claimed.id, None).await.unwrap().unwrap().bytes, b"mesh");
    assert_eq!(faulty.files().len(), 1);
    // Another outcome of the same attempt is refused, and so is the outcome of another attempt.
    let failure = Arc::new(Outcome::Failed { error: "{}".into() });
    assert!(!store.finish(&claimed.id, claimed.attempt, failure).await.unwrap());
    assert!(!store.finish(&claimed.id, claimed.attempt + 1, success(b"mesh")).await.unwrap());
    assert_eq!(store.artefact(&claimed.id, None).await.unwrap().unwrap().bytes, b"mesh");
    assert_eq!(faulty.files().len(), 1);
}

#[tokio::test(flavor = "multi_thread", worker_threads = 2)]
async fn a_silent_connection_is_given_up_before_a_lease_ends() {
    let Some(faulty) = Faulty::new().await else { return };
    let store = &faulty.store;
    assert!(matches!(store.add_job(job(1)).await, Ok(Addition::Created(..))));
    let claimed = store.claim("worker", LEASE).await.unwrap().unwrap();
    for fault in [Fault::SilentBefore, Fault::SilentAfter] {
        let silent = faulty.proxy.disturb("SET lease_until", fault);
        let asked = Instant::now();
        let renewed = tokio::time::timeout(Duration::from_secs(14), store.renew(&claimed.id, claimed.attempt, LEASE));
        let renewed = renewed.await.expect("an answer before a lease of 15 s ends");
        println!("{fault:?}: {renewed:?} after {:.1} s", asked.elapsed().as_secs_f64());
        assert!(renewed.is_err() && silent.yet());
        // The server still locks the row for the silent connection, until its time limit ends that transaction.
        let renewed = tokio::time::timeout(Duration::from_secs(30), async {
            loop {
                if let Ok(renewed) = store.renew(&claimed.id, claimed.attempt, LEASE).await {
                    return renewed;
                }
            }
        });
        assert_eq!(renewed.await.expect("the row is free again"), Renewed::Held);
    }
    // Closing the store does not wait for a silent server.
    let silent = faulty.proxy.disturb("SET lease_until", Fault::SilentBefore);
    let renewing = tokio::spawn({
        let (store, claimed) = (store.clone(), claimed.clone());
        async move { store.renew(&claimed.id, claimed.attempt, LEASE).await }
    });
    while !silent.yet() {
        tokio::time::sleep(Duration::from_millis(5)).await;
    }
    tokio::time::timeout(Duration::from_secs(14), store.close()).await.expect("the store closes");
    assert!(renewing.await.unwrap().is_err());
}

#[tokio::test(flavor = "multi_thread", worker_threads = 2)]
async fn one_instance_at_a_time_leads_the_sweep() {
    let Some(server) = Postgres::start() else { return };
    let url = server.database().await;
    let open = async || Store::open(&url, StoreOptions::default()).await.unwrap();
    let (first, second) = (open().await, open().await);
    let long = Duration::from_secs(3600);
    assert!(first.leads_the_sweep(long).await.unwrap());
    assert!(!second.leads_the_sweep(long).await.unwrap());
    assert!(first.leads_the_sweep(long).await.unwrap(), "the leader stays");
    first.close().await;
    assert!(second.leads_the_sweep(Duration::ZERO).await.unwrap(), "a leader that leaves is replaced at once");
    let third = open().await;
    assert!(third.leads_the_sweep(long).await.unwrap(), "a leader that died is replaced later");
    assert!(!second.leads_the_sweep(long).await.unwrap());
}
