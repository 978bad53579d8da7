//! The promises of the store, tested on both engines. Every case runs on SQLite and, if a server can be started, on
//! PostgreSQL. A lease of zero runs out at once, so that no case waits for a clock.

use crate::postgres;
use crate::skips::skipped;
use std::collections::{BTreeMap, BTreeSet};
use std::sync::{Arc, Mutex, PoisonError};
use std::time::Duration;

use plateau::status::{CancelReason, Status};
use plateau::store::{
    Addition, BatchAddition, BatchLookup, BatchRow, Busy, Delivery, EarlyEnd, EventId, Filter, JobRow, Lookup,
    NewBatch, NewJob, Outcome, Preference, Renewed, Room, Store, StoreError, StoreOptions, Subject,
};
use sha2::{Digest, Sha256};
use tempfile::TempDir;

const LEASE: Duration = Duration::from_secs(60);
const NO_LEASE: Duration = Duration::ZERO;
/// Time that is longer than any case takes, so that only a defect exceeds it.
const TOO_LONG: Duration = Duration::from_secs(20);

#[derive(Clone, Copy, PartialEq)]
enum Engine {
    Sqlite,
    Postgres,
}

/// Database of one case.
struct Database {
    url: String,
    /// These fields keep the file or the server while the case runs.
    _folder: Option<TempDir>,
    _server: Option<Arc<postgres::Postgres>>,
}

impl Database {
    /// Returns a fresh database, or records a skip and returns `None` if PostgreSQL is not installed.
    async fn new(engine: Engine) -> Option<Self> {
        if engine == Engine::Sqlite {
            let folder = tempfile::tempdir().unwrap();
            let url = format!("sqlite://{}/plateau.db", folder.path().display());
            return Some(Self { url, _folder: Some(folder), _server: None });
        }
        // All cases share one server, which ends with this process.
        static SERVER: Mutex<Option<Arc<postgres::Postgres>>> = Mutex::new(None);
        let server = {
            let mut server = SERVER.lock().unwrap_or_else(PoisonError::into_inner);
            if server.is_none() {
                *server = Some(Arc::new(postgres::Postgres::start()?));
            }
            server.clone()?
        };
        Some(Self { url: server.database().await, _folder: None, _server: Some(server) })
    }

    /// Runs a statement without the store.
    async fn execute(&self, text: &'static str) {
        let url = self.url.clone();
        let run = move || match url.strip_prefix("sqlite://") {
            Some(path) => rusqlite::Connection::open(path).unwrap().execute_batch(text).unwrap(),
            None => {
                let (server, folder) = url.split_once("?host=").unwrap();
                let database = server.rsplit_once('/').unwrap().1;
                let mut config = ::postgres::Config::new();
                config.user("postgres").dbname(database).host_path(folder);
                config.connect(::postgres::NoTls).unwrap().batch_execute(text).unwrap();
            }
        };
        tokio::task::spawn_blocking(run).await.unwrap();
    }

    async fn open(&self, options: StoreOptions) -> Store {
        Store::open(&self.url, options).await.unwrap()
    }
}

/// Runs each case on both engines.
macro_rules! cases {
    ($($name:ident),* $(,)?) => {
        mod sqlite {
            $(#[tokio::test(flavor = "multi_thread", worker_threads = 2)]
            async fn $name() {
                super::$name(super::Database::new(super::Engine::Sqlite).await.unwrap()).await;
            })*
        }
        mod postgresql {
            $(#[tokio::test(flavor = "multi_thread", worker_threads = 2)]
            async fn $name() {
                if let Some(database) = super::Database::new(super::Engine::Postgres).await {
                    super::$name(database).await;
                }
            })*
        }
    };
}

cases! {
    a_job_runs_from_queue_to_result,
    a_worker_that_lost_its_lease_changes_nothing,
    a_job_whose_workers_keep_dying_fails_with_a_history,
    a_worker_that_returns_after_its_lease_costs_no_attempt,
    a_job_whose_request_no_worker_can_read_is_handed_back_and_fails_after_a_while,
    a_batch_is_never_first_in_line_twice,
    owners_who_come_later_are_served_after_all_others,
    a_request_is_kept_as_long_as_its_job,
    requests_of_finished_jobs_count_in_max_bytes,
    a_cancelled_job_says_why,
    a_list_selects_by_label_batch_time_and_several_states,
    a_database_without_a_table_refuses_submissions_until_it_is_back,
    a_job_that_was_handed_back_keeps_its_place_and_loses_no_lease,
    an_owner_with_many_jobs_does_not_delay_other_owners,
    a_job_that_does_not_fit_into_the_memory_is_overtaken_a_limited_number_of_times,
    a_worker_for_small_jobs_takes_them_in_order_and_overtakes_no_job_for_lack_of_memory,
    a_full_queue_refuses_further_jobs,
    a_full_share_refuses_only_its_owner,
    an_idempotency_key_makes_one_job,
    equal_submissions_at_once_make_one_job,
    a_cancel_takes_effect_at_once_and_is_final,
    a_newer_job_of_a_series_cancels_the_older_ones,
    of_many_submissions_of_a_series_at_once_one_remains,
    a_label_and_metadata_stay_with_the_job,
    a_deleted_job_is_missing_and_its_worker_is_told,
    an_owner_sees_no_job_of_another,
    a_list_pages_through_every_job_once,
    a_list_has_statistics_only_if_it_is_asked_for_them,
    equal_requests_share_a_result,
    a_result_is_not_shared_with_other_owners_versions_or_bypassing_requests,
    a_result_of_a_bypassing_request_is_not_shared,
    expired_jobs_are_remembered_as_expired_and_then_forgotten,
    finished_jobs_beyond_max_jobs_expire,
    an_owner_with_many_jobs_or_bytes_expires_no_result_of_another,
    a_shared_result_outlives_the_job_that_made_it,
    a_result_outlives_its_job_while_a_request_that_begins_with_it_waits,
    a_large_result_is_a_file_and_goes_with_its_job,
    a_file_without_a_job_is_swept,
    results_stay_within_max_bytes,
    a_database_of_small_results_takes_new_jobs_for_ever,
    a_sweep_of_many_steps_removes_everything_due,
    a_damaged_result_is_discarded_and_made_again,
    a_fresh_result_replaces_an_equal_one_that_is_damaged,
    a_missing_file_keeps_its_result_from_being_shared,
    an_unreadable_row_does_not_hide_other_rows,
    a_lease_from_a_clock_that_was_set_back_has_run_out,
    a_job_is_found_by_its_idempotency_key,
    watchers_see_every_status,
    a_watch_of_a_missing_job_returns_missing,
    another_instance_sees_changes_and_work,
    many_workers_finish_every_job_exactly_once,
    a_reopened_store_still_has_its_jobs,
    a_closed_store_returns_unavailable,
    the_queue_length_follows_the_queue,
    all_jobs_of_a_batch_are_stored_or_none,
    a_batch_is_hidden_from_other_owners_and_expires_with_its_last_job,
    cancelling_a_batch_cancels_every_unfinished_job,
    a_callback_is_due_from_the_end_until_it_is_settled,
    a_batchs_callback_is_due_after_its_last_job,
    concurrent_claimers_get_every_callback_once,
    callbacks_of_busy_owners_and_hosts_are_passed_over,
    a_settled_callback_has_a_log_and_can_be_sent_again,
    a_claim_whose_answer_was_lost_is_found_by_its_name,
}

fn job(number: usize) -> NewJob {
    NewJob {
        id: format!("{number:026}"),
        kind: "ruled_surface".into(),
        owner: None,
        request: format!("{{\"number\":{number}}}").into_bytes(),
        source: None,
        request_hash: std::array::from_fn(|byte| number.to_le_bytes()[byte % 8]),
        idempotency_key: None,
        body_hash: [number as u8; 32],
        callback_url: None,
        label: None,
        metadata: None,
        supersede: None,
        memory_bytes: 0,
        reuse: true,
    }
}

fn job_of(owner: &str, number: usize) -> NewJob {
    NewJob { owner: Some(owner.into()), ..job(number) }
}

/// Bytes of a result that is large enough to be named by its hash alone, so that equal results are stored only once.
static MANY_BYTES: [u8; 40_000] = [7; 40_000];

fn success(artefact: &[u8]) -> Arc<Outcome> {
    Arc::new(solved_as(artefact))
}

fn solved_as(artefact: &[u8]) -> Outcome {
    Outcome::Succeeded {
        statistics: "{\"area\":1.5}".into(),
        summary: "{\"iterations\":3}".into(),
        warnings: "[{\"code\":\"folds\"}]".into(),
        artefact: artefact.to_vec(),
        artefact_hash: Sha256::digest(artefact).into(),
        reusable: true,
    }
}

async fn create(store: &Store, job: NewJob) -> JobRow {
    match store.add_job(job).await.unwrap() {
        Addition::Created(row, _) => *row,
        other => panic!("expected a new job, got {other:?}"),
    }
}

async fn find(store: &Store, id: &str) -> JobRow {
    match store.get(id, None).await.unwrap() {
        Lookup::Found(row) => *row,
        other => panic!("expected {id}, got {other:?}"),
    }
}

/// Claims the next job and ends it with `artefact`. Returns its identifier.
async fn work_one(store: &Store, artefact: &[u8]) -> String {
    let claimed = store.claim("worker", LEASE).await.unwrap().expect("a job to claim");
    assert!(store.finish(&claimed.id, claimed.attempt, success(artefact)).await.unwrap());
    claimed.id
}

fn statuses(job: &JobRow) -> Vec<Status> {
    job.history.iter().map(|event| event.status).collect()
}

async fn a_job_runs_from_queue_to_result(database: Database) {
    let store = database.open(StoreOptions::default()).await;
    let queued = create(&store, job_of("me", 1)).await;
    assert_eq!((queued.status, queued.attempt, queued.warnings.as_str()), (Status::Queued, 0, "[]"));
    assert_eq!(queued.event_id().to_string(), "0.1");
    assert_eq!(store.artefact(&queued.id, None).await.unwrap(), None);

    let claimed = store.claim("worker", LEASE).await.unwrap().unwrap();
    assert_eq!(claimed.id, queued.id);
    assert_eq!((claimed.kind.as_str(), claimed.request.as_slice()), ("ruled_surface", &b"{\"number\":1}"[..]));
    assert_eq!(store.claim("worker", LEASE).await.unwrap(), None);

    assert_eq!(store.renew(&claimed.id, claimed.attempt, LEASE).await.unwrap(), Renewed::Held);
    let reported = store.progress(&claimed.id, claimed.attempt, "{\"fraction\":0.5}").await.unwrap();
    assert_eq!(reported, Renewed::Held);
    let running = find(&store, &queued.id).await;
    assert_eq!((running.status, running.progress.as_deref()), (Status::Running, Some("{\"fraction\":0.5}")));
    assert_eq!(running.progress_since(None).unwrap().0.to_string(), "1.3");
    assert_eq!(running.progress_since(Some(running.event_id())), None);
    assert!(running.started_at_ms.unwrap() >= running.created_at_ms);
    assert_eq!((running.finished_at_ms, running.expires_at_ms), (None, None));

    assert!(store.finish(&claimed.id, claimed.attempt, success(b"mesh")).await.unwrap());
    let ended = find(&store, &queued.id).await;
    assert_eq!((ended.status, ended.sequence), (Status::Succeeded, 4));
    assert_eq!(ended.statistics.as_deref(), Some("{\"area\":1.5}"));
    assert_eq!(ended.warnings, "[{\"code\":\"folds\"}]");
    assert_eq!(statuses(&ended), [Status::Queued, Status::Running, Status::Succeeded]);
    assert!(ended.history.is_sorted_by(|a, b| a.id < b.id && a.at_ms <= b.at_ms));
    let since: Vec<_> = ended.events_since(Some(EventId { attempt: 0, sequence: 1 })).collect();
    assert_eq!(since, [&ended.history[1], &ended.history[2]]);
    // PostgreSQL reads its clock for each of the two times.
    let kept_ms = ended.expires_at_ms.unwrap() - ended.finished_at_ms.unwrap() - 7 * 24 * 3_600_000;
    assert!((0..1000).contains(&kept_ms), "{kept_ms}");
    let artefact = store.artefact(&queued.id, None).await.unwrap().unwrap();
    assert_eq!((artefact.bytes.as_slice(), Some(artefact.hash)), (&b"mesh"[..], ended.artefact));
    assert!(!store.finish(&claimed.id, claimed.attempt, success(b"again")).await.unwrap());
    assert_eq!(store.artefact(&queued.id, None).await.unwrap().unwrap().bytes, b"mesh");
}

async fn a_worker_that_lost_its_lease_changes_nothing(database: Database) {
    let store = database.open(StoreOptions::default()).await;
    let id = create(&store, job(1)).await.id;
    let stalled = store.claim("stalled", NO_LEASE).await.unwrap().unwrap();
    let second = store.claim("second", LEASE).await.unwrap().unwrap();
    assert_eq!((second.id.as_str(), second.attempt), (id.as_str(), stalled.attempt + 1));
    assert_eq!(second.request, stalled.request);

    assert_eq!(store.renew(&id, stalled.attempt, LEASE).await.unwrap(), Renewed::Lost);
    assert_eq!(store.progress(&id, stalled.attempt, "{\"late\":true}").await.unwrap(), Renewed::Lost);
    assert!(!store.hand_back(&id, stalled.attempt).await.unwrap());
    assert!(!store.finish(&id, stalled.attempt, success(b"late")).await.unwrap());
    let running = find(&store, &id).await;
    assert_eq!((running.status, running.attempt, &running.progress), (Status::Running, second.attempt, &None));
    assert_eq!(statuses(&running), [Status::Queued, Status::Running, Status::Queued, Status::Running]);

    assert!(store.finish(&id, second.attempt, success(b"right")).await.unwrap());
    assert!(!store.finish(&id, stalled.attempt, success(b"late")).await.unwrap());
    assert_eq!(store.artefact(&id, None).await.unwrap().unwrap().bytes, b"right");
}

async fn a_job_whose_workers_keep_dying_fails_with_a_history(database: Database) {
    let store = database.open(StoreOptions { max_attempts: 3, ..StoreOptions::default() }).await;
    let id = create(&store, job(1)).await.id;
    for attempt in 1..=3 {
        let claimed = store.claim(&format!("victim {attempt}"), LEASE).await.unwrap().unwrap();
        assert_eq!(claimed.attempt, attempt);
        store.progress(&id, attempt, "{\"phase\":\"smoothing\"}").await.unwrap();
        // The worker dies, so its lease runs out.
        store.renew(&id, attempt, NO_LEASE).await.unwrap();
    }
    assert_eq!(store.claim("survivor", LEASE).await.unwrap(), None);
    let failed = find(&store, &id).await;
    assert_eq!(failed.status, Status::Failed);
    let error: serde_json::Value = serde_json::from_str(failed.error.as_deref().unwrap()).unwrap();
    let detail = error["detail"].as_str().unwrap();
    for attempt in 1..=3 {
        assert!(detail.contains(&format!("attempt {attempt} on victim {attempt}")), "{detail}");
    }
    assert!(detail.contains("smoothing"), "{detail}");
    assert!(failed.expires_at_ms.is_some());
}

async fn a_worker_that_returns_after_its_lease_costs_no_attempt(database: Database) {
    let store = database.open(StoreOptions { max_attempts: 2, ..StoreOptions::default() }).await;
    let id = create(&store, job(1)).await.id;
    // Each worker is cut off until another one has taken its job, and then returns in another way.
    for attempt in 1..=6 {
        let cut_off = store.claim("cut off", NO_LEASE).await.unwrap().expect("the job has not failed");
        assert_eq!((cut_off.id.as_str(), cut_off.attempt), (id.as_str(), 2 * attempt - 1));
        let other = store.claim("other", LEASE).await.unwrap().unwrap();
        match attempt % 3 {
            0 => assert_eq!(store.renew(&id, cut_off.attempt, LEASE).await.unwrap(), Renewed::Lost),
            1 => assert_eq!(store.progress(&id, cut_off.attempt, "{}").await.unwrap(), Renewed::Lost),
            _ => assert!(!store.finish(&id, cut_off.attempt, success(b"late")).await.unwrap()),
        }
        // It returns only once.
        assert_eq!(store.renew(&id, cut_off.attempt, LEASE).await.unwrap(), Renewed::Lost);
        assert!(store.hand_back(&id, other.attempt).await.unwrap());
    }
    // A worker that does not return counts.
    for _ in 0..2 {
        store.claim("dead", NO_LEASE).await.unwrap().unwrap();
    }
    assert_eq!(store.claim("survivor", LEASE).await.unwrap(), None);
    assert_eq!(find(&store, &id).await.status, Status::Failed);
}

async fn a_job_that_was_handed_back_keeps_its_place_and_loses_no_lease(database: Database) {
    let store = database.open(StoreOptions { max_attempts: 1, ..StoreOptions::default() }).await;
    let first = create(&store, job(1)).await.id;
    create(&store, job(2)).await;
    for attempt in 1..=4 {
        let claimed = store.claim("leaving", LEASE).await.unwrap().unwrap();
        assert_eq!((claimed.id.as_str(), claimed.attempt), (first.as_str(), attempt));
        assert!(store.hand_back(&first, attempt).await.unwrap());
        assert!(!store.hand_back(&first, attempt).await.unwrap());
    }
    let job = find(&store, &first).await;
    assert_eq!((job.status, job.started_at_ms), (Status::Queued, None));
}

async fn a_job_whose_request_no_worker_can_read_is_handed_back_and_fails_after_a_while(database: Database) {
    let patience = Duration::from_millis(500);
    let store = database.open(StoreOptions { unread_patience: patience, ..StoreOptions::default() }).await;
    let (id, other) = (create(&store, job(1)).await.id, create(&store, job(2)).await.id);
    let claimed = store.claim("old", LEASE).await.unwrap().unwrap();
    assert_eq!(claimed.id, id);
    assert!(store.hand_back_unread(&id, claimed.attempt, r#"{"type":"/problems/refused"}"#).await.unwrap());
    assert!(!store.hand_back_unread(&id, claimed.attempt, "{}").await.unwrap(), "the worker has lost the job");
    // The same worker passes the job over, and another worker gets it.
    let except = Preference { except: vec![id.clone()], ..Preference::default() };
    let claimed = store.claim_within("old", LEASE, Room::ANY, except.clone()).await.unwrap().unwrap();
    assert_eq!(claimed.id, other);
    assert_eq!(store.claim_within("old", LEASE, Room::ANY, except.clone()).await.unwrap(), None);
    let claimed = store.claim("new", LEASE).await.unwrap().unwrap();
    assert_eq!(claimed.id, id);
    assert!(store.hand_back_unread(&id, claimed.attempt, r#"{"type":"/problems/refused"}"#).await.unwrap());
    assert_eq!(find(&store, &id).await.error, None);
    tokio::time::sleep(patience).await;
    assert_eq!(store.claim_within("old", LEASE, Room::ANY, except).await.unwrap(), None);
    let failed = find(&store, &id).await;
    assert_eq!((failed.status, failed.error.as_deref()), (Status::Failed, Some(r#"{"type":"/problems/refused"}"#)));
    assert!(failed.expires_at_ms.is_some());
}

async fn a_batch_is_never_first_in_line_twice(database: Database) {
    let store = database.open(StoreOptions::default()).await;
    for number in 0..20 {
        create(&store, job_of("batch", number)).await;
    }
    let claim = async || store.claim("worker", LEASE).await.unwrap().unwrap();
    let first = claim().await;
    assert_eq!(first.owner.as_deref(), Some("batch"));
    // While the first job runs, the single job of another owner is next.
    let single = create(&store, job_of("single", 100)).await.id;
    let pair = [create(&store, job_of("pair", 101)).await.id, create(&store, job_of("pair", 102)).await.id];
    let order = [claim().await.id, claim().await.id, claim().await.id, claim().await.id];
    assert_eq!(order, [single, pair[0].clone(), job(1).id, pair[1].clone()]);
}

async fn owners_who_come_later_are_served_after_all_others(database: Database) {
    let store = database.open(StoreOptions::default()).await;
    for (number, owner) in ["much", "much", "some", "none", "none"].into_iter().enumerate() {
        create(&store, NewJob { memory_bytes: 10 * (number as u64 + 1), ..job_of(owner, number) }).await;
    }
    let later = Preference { later_owners: vec!["some".into(), "much".into()], ..Preference::default() };
    let claim = async |free_bytes: u64| {
        let room = Room { free_bytes, most_bytes: u64::MAX };
        store.claim_within("worker", LEASE, room, later.clone()).await.unwrap().map(|claimed| claimed.id)
    };
    assert_eq!(claim(u64::MAX).await, Some(job(3).id));
    // The next job does not fit, and is overtaken by the next one in this order that does.
    assert_eq!(claim(40).await, Some(job(2).id));
    assert_eq!(claim(40).await, Some(job(0).id));
    assert_eq!(claim(40).await, Some(job(1).id));
    assert_eq!(claim(40).await, None);
    assert_eq!(claim(50).await, Some(job(4).id));
}

async fn a_request_is_kept_as_long_as_its_job(database: Database) {
    let options = StoreOptions { orphan_age: Duration::ZERO, ..StoreOptions::default() };
    let store = database.open(options.clone()).await;
    let kept = async |number: usize| {
        let request = store.request(&job(number).id, None).await.unwrap();
        request.map(|(kind, body)| (kind, String::from_utf8(body).unwrap()))
    };
    let expected = |number: usize| Some(("ruled_surface".to_owned(), format!("{{\"number\":{number}}}")));
    for number in [1, 2, 3] {
        create(&store, job_of("me", number)).await;
        assert_eq!(kept(number).await, expected(number));
    }
    work_one(&store, b"mesh").await;
    let claimed = store.claim("worker", LEASE).await.unwrap().unwrap();
    let failed = Outcome::Failed { error: "{}".into() };
    assert!(store.finish(&claimed.id, claimed.attempt, Arc::new(failed)).await.unwrap());
    store.cancel(&job(3).id, None, CancelReason::Client).await.unwrap();
    // Jobs that were solved before they were stored, and jobs with the result of another job, keep theirs too.
    let solved = EarlyEnd { outcome: solved_as(b"early"), submitted_ms: 2, started_ms: 1 };
    store.add_ended_job(job_of("me", 4), solved).await.unwrap();
    let shared = NewJob { id: job(5).id, request: job(5).request, ..job_of("me", 1) };
    assert_eq!(create(&store, shared).await.status, Status::Succeeded);
    for number in 1..=5 {
        assert_eq!(kept(number).await, expected(number), "{number}");
        assert!(find(&store, &job(number).id).await.has_request);
    }
    assert_eq!(store.request(&job(1).id, Some("other")).await.unwrap(), None);
    assert!(store.request(&job(1).id, Some("me")).await.unwrap().is_some());
    store.delete(&job(1).id, None).await.unwrap();
    assert_eq!(kept(1).await, None);
    // An older version on the same database removes jobs without their requests.
    database.execute("DELETE FROM jobs WHERE id LIKE '%2'").await;
    assert!(store.sweep().await.is_ok());
    store.close().await;
    let store = database.open(StoreOptions { retention: Duration::ZERO, ..options }).await;
    database.execute("UPDATE jobs SET expires_at = 1").await;
    assert_eq!(store.sweep().await.unwrap().expired, 3);
    // The number of requests that are left is the time in this row.
    database
        .execute("INSERT INTO expired_jobs (id, owner, expired_at) SELECT 'left', '', count(*) FROM requests")
        .await;
    database.execute("DELETE FROM expired_jobs WHERE id = 'left' AND expired_at = 0").await;
    assert_eq!(store.get("left", None).await.unwrap(), Lookup::Missing);
}

async fn requests_of_finished_jobs_count_in_max_bytes(database: Database) {
    let options = StoreOptions { orphan_age: Duration::ZERO, ..StoreOptions::default() };
    let store = database.open(options.clone()).await;
    let failed = Arc::new(Outcome::Failed { error: "{}".into() });
    for number in 0..30 {
        let request = vec![b' '; 100_000];
        create(&store, NewJob { request, ..job_of("large", number) }).await;
        let claimed = store.claim("worker", LEASE).await.unwrap().unwrap();
        assert!(store.finish(&claimed.id, claimed.attempt, failed.clone()).await.unwrap());
    }
    create(&store, job_of("small", 100)).await;
    work_one(&store, b"mesh").await;
    store.close().await;
    let store = database.open(StoreOptions { max_bytes: Some(2_500_000), ..options }).await;
    // Ten jobs expire at a time.
    assert!([10, 20].contains(&store.sweep().await.unwrap().expired));
    assert_eq!(store.get(&job(0).id, None).await.unwrap(), Lookup::Expired);
    assert_eq!(find(&store, &job(29).id).await.status, Status::Failed);
    assert_eq!(find(&store, &job(100).id).await.status, Status::Succeeded);
}

async fn a_cancelled_job_says_why(database: Database) {
    let store = database.open(StoreOptions::default()).await;
    let reasons = [CancelReason::Client, CancelReason::Disconnected];
    for (number, because) in reasons.into_iter().enumerate() {
        let id = create(&store, job(number)).await.id;
        assert_eq!(find(&store, &id).await.cancelled_because, None);
        store.cancel(&id, None, because).await.unwrap();
        assert_eq!(find(&store, &id).await.cancelled_because, Some(because));
        // A job that has ended keeps its reason.
        store.cancel(&id, None, CancelReason::Superseded).await.unwrap();
        assert_eq!(find(&store, &id).await.cancelled_because, Some(because));
    }
    let in_series = |number| NewJob { supersede: Some("drag".into()), ..job(number) };
    create(&store, in_series(10)).await;
    create(&store, in_series(11)).await;
    let old = find(&store, &job(10).id).await;
    assert_eq!((old.cancelled_because, old.successor), (Some(CancelReason::Superseded), Some(job(11).id)));
    let batch = create_batch(&store, batch_of(None, 1, 20..22)).await;
    store.cancel_batch(&batch.id, None).await.unwrap();
    let row = find(&store, &job(20).id).await;
    assert_eq!((row.cancelled_because, row.batch), (Some(CancelReason::Client), Some(batch.id)));
}

async fn a_list_selects_by_label_batch_time_and_several_states(database: Database) {
    let store = database.open(StoreOptions::default()).await;
    let labelled = |label: &str, number: usize| NewJob { label: Some(label.into()), ..job(number) };
    let id_at = |ms: u64| ulid::Ulid::from_parts(ms, 1).to_string();
    let created = create(&store, NewJob { id: id_at(1_700_000_000_000), ..labelled("roof", 1) }).await;
    create(&store, labelled("tent", 2)).await;
    create(&store, job(3)).await;
    create_batch(&store, batch_of(None, 1, 20..22)).await;
    store.cancel(&job(2).id, None, CancelReason::Client).await.unwrap();
    work_one(&store, b"mesh").await;
    let count = async |filter: Filter| store.list(filter, 100, None).await.unwrap().0.len();
    let all = Filter::default;
    assert_eq!(count(Filter { label: Some("roof".into()), ..all() }).await, 1);
    assert_eq!(count(Filter { label: Some("roo".into()), ..all() }).await, 0);
    assert_eq!(count(Filter { batch: Some(batch_of(None, 1, 20..22).id), ..all() }).await, 2);
    assert_eq!(count(Filter { statuses: vec![Status::Cancelled, Status::Succeeded], ..all() }).await, 2);
    assert_eq!(count(Filter { statuses: Status::ALL.to_vec(), ..all() }).await, 5);
    assert_eq!(count(Filter { created_after_ms: Some(created.created_at_ms + 60_000), ..all() }).await, 0);
    assert_eq!(count(Filter { created_after_ms: Some(1_699_999_000_000), ..all() }).await, 1);
}

async fn a_database_without_a_table_refuses_submissions_until_it_is_back(database: Database) {
    let store = database.open(StoreOptions::default()).await;
    store.check().await.unwrap();
    database.execute("ALTER TABLE requests RENAME TO away").await;
    assert!(store.add_job(job(1)).await.is_err());
    // A write to another table does not show that jobs can be stored.
    assert!(store.leads_the_sweep(Duration::ZERO).await.is_ok());
    assert!(store.check().await.is_err());
    database.execute("ALTER TABLE away RENAME TO requests").await;
    store.check().await.unwrap();
    assert_eq!(store.get(&job(1).id, None).await.unwrap(), Lookup::Missing);
    assert_eq!(store.queue_length().await.unwrap(), 0);
    create(&store, job(1)).await;
}

async fn an_owner_with_many_jobs_does_not_delay_other_owners(database: Database) {
    let store = database.open(StoreOptions::default()).await;
    for number in 0..50 {
        create(&store, job_of("flood", number)).await;
    }
    for _ in 0..10 {
        work_one(&store, b"flood").await;
    }
    let small = create(&store, job_of("small", 100)).await.id;
    let pair = [create(&store, job_of("pair", 101)).await.id, create(&store, job_of("pair", 102)).await.id];
    let mut order = Vec::new();
    for _ in 0..6 {
        order.push(work_one(&store, b"mesh").await);
    }
    let place = |id: &String| order.iter().position(|worked| worked == id).expect("started among the next few");
    assert!(place(&small) <= 2, "{order:?}");
    assert!(place(&pair[0]) <= 2 && place(&pair[1]) <= 4, "{order:?}");
    // The flood is still served, in its own order.
    let flood: Vec<_> = order.iter().filter(|id| **id != small && !pair.contains(id)).collect();
    assert_eq!(flood.len(), 3);
    assert!(flood.is_sorted());
}

async fn a_job_that_does_not_fit_into_the_memory_is_overtaken_a_limited_number_of_times(database: Database) {
    const FREE: u64 = 1000;
    let within = |free_bytes| Room { free_bytes, most_bytes: u64::MAX };
    let store = database.open(StoreOptions::default()).await;
    let large = create(&store, NewJob { memory_bytes: FREE + 1, ..job(1) }).await.id;
    let larger = create(&store, NewJob { memory_bytes: 2 * FREE, ..job(2) }).await.id;
    for number in 100..200 {
        create(&store, NewJob { memory_bytes: FREE, ..job(number) }).await;
    }
    for number in 100..116 {
        let claimed = store.claim_within("worker", LEASE, within(FREE), Preference::default()).await.unwrap().unwrap();
        assert_eq!((claimed.id, claimed.memory_bytes), (job(number).id, FREE));
    }
    assert_eq!(store.claim_within("worker", LEASE, within(FREE), Preference::default()).await.unwrap(), None);
    let claimed = store.claim_within("worker", LEASE, within(FREE + 1), Preference::default()).await.unwrap().unwrap();
    assert_eq!((claimed.id, claimed.memory_bytes), (large, FREE + 1));
    // The next job that does not fit is overtaken as often as the first one.
    for number in 116..132 {
        assert_eq!(
            store.claim_within("worker", LEASE, within(FREE), Preference::default()).await.unwrap().unwrap().id,
            job(number).id
        );
    }
    assert_eq!(store.claim_within("worker", LEASE, within(FREE), Preference::default()).await.unwrap(), None);
    assert_eq!(store.claim("worker", LEASE).await.unwrap().unwrap().id, larger);
}

async fn a_worker_for_small_jobs_takes_them_in_order_and_overtakes_no_job_for_lack_of_memory(database: Database) {
    let store = database.open(StoreOptions::default()).await;
    let room = Room { free_bytes: 1000, most_bytes: 10 };
    create(&store, NewJob { memory_bytes: 500, ..job(1) }).await;
    for number in 2..20 {
        create(&store, NewJob { memory_bytes: 10, ..job(number) }).await;
    }
    let later = create(&store, NewJob { memory_bytes: 2000, ..job(20) }).await.id;
    for number in 2..20 {
        assert_eq!(
            store.claim_within("small", LEASE, room, Preference::default()).await.unwrap().unwrap().id,
            job(number).id
        );
    }
    assert_eq!(store.claim_within("small", LEASE, room, Preference::default()).await.unwrap(), None);
    // Neither of the larger jobs has waited for memory so far, so small jobs still pass the last one.
    create(&store, NewJob { memory_bytes: 10, ..job(21) }).await;
    assert_eq!(store.claim_within("small", LEASE, room, Preference::default()).await.unwrap().unwrap().id, job(21).id);
    assert_eq!(store.claim("worker", LEASE).await.unwrap().unwrap().id, job(1).id);
    assert_eq!(store.claim("worker", LEASE).await.unwrap().unwrap().id, later);
}

async fn a_full_queue_refuses_further_jobs(database: Database) {
    let store = database.open(StoreOptions { queue_limit: 3, ..StoreOptions::default() }).await;
    for number in 0..3 {
        create(&store, job(number)).await;
    }
    assert_eq!(store.add_job(job(3)).await, Err(StoreError::QueueFull { own: false }));
    assert_eq!(store.get(&job(3).id, None).await.unwrap(), Lookup::Missing);
    work_one(&store, b"mesh").await;
    create(&store, job(3)).await;
    // A job that reuses a kept result needs no room in the queue.
    let shared = create(&store, NewJob { id: job(4).id, ..job(0) }).await;
    assert_eq!(shared.status, Status::Succeeded);
}

async fn a_full_share_refuses_only_its_owner(database: Database) {
    let store = database.open(StoreOptions { owner_queue_limit: 2, ..StoreOptions::default() }).await;
    create(&store, job_of("greedy", 1)).await;
    create(&store, job_of("greedy", 2)).await;
    assert_eq!(store.add_job(job_of("greedy", 3)).await, Err(StoreError::QueueFull { own: true }));
    create(&store, job_of("modest", 4)).await;
}

async fn an_idempotency_key_makes_one_job(database: Database) {
    let store = database.open(StoreOptions { queue_limit: 3, ..StoreOptions::default() }).await;
    let keyed = |number| NewJob { idempotency_key: Some("once".into()), body_hash: [7; 32], ..job_of("me", number) };
    let first = create(&store, keyed(1)).await;
    match store.add_job(keyed(2)).await.unwrap() {
        Addition::Existing(row) => assert_eq!(row.id, first.id),
        other => panic!("{other:?}"),
    }
    assert_eq!(store.add_job(NewJob { body_hash: [8; 32], ..keyed(3) }).await.unwrap(), Addition::KeyConflict);
    // The same key of another owner or kind is a different key.
    create(&store, NewJob { owner: Some("you".into()), ..keyed(4) }).await;
    create(&store, NewJob { kind: "minimal_surface".into(), ..keyed(5) }).await;
    // The key returns the same job in its current state, even if the queue is full.
    work_one(&store, b"mesh").await;
    create(&store, job(6)).await;
    match store.add_job(keyed(7)).await.unwrap() {
        Addition::Existing(row) => assert_eq!((row.id, row.status), (first.id.clone(), Status::Succeeded)),
        other => panic!("{other:?}"),
    }
    // The key is kept for as long as the job.
    store.cancel(&job(6).id, None, CancelReason::Client).await.unwrap();
    assert!(store.delete(&first.id, Some("me")).await.unwrap());
    create(&store, NewJob { reuse: false, ..keyed(8) }).await;
}

async fn equal_submissions_at_once_make_one_job(database: Database) {
    let store = database.open(StoreOptions::default()).await;
    let submissions = (0..24).map(|number| {
        let store = store.clone();
        tokio::spawn(async move {
            store.add_job(NewJob { idempotency_key: Some("k".into()), body_hash: [7; 32], ..job(number) }).await
        })
    });
    let mut ids = BTreeSet::new();
    let mut created = 0;
    for submission in submissions.collect::<Vec<_>>() {
        match submission.await.unwrap().unwrap() {
            Addition::Created(row, _) => {
                created += 1;
                ids.insert(row.id);
            }
            Addition::Existing(row) => {
                ids.insert(row.id);
            }
            Addition::KeyConflict => panic!("the bodies are equal"),
        }
    }
    assert_eq!((created, ids.len()), (1, 1));
}

async fn a_cancel_takes_effect_at_once_and_is_final(database: Database) {
    let store = database.open(StoreOptions::default()).await;
    let (queued, running, done) = (job(1).id, job(2).id, job(0).id);
    create(&store, job(0)).await;
    work_one(&store, b"mesh").await;
    create(&store, job(2)).await;
    let claimed = store.claim("worker", LEASE).await.unwrap().unwrap();
    create(&store, job(1)).await;
    for (id, expected) in [(&queued, Status::Cancelled), (&running, Status::Cancelled), (&done, Status::Succeeded)] {
        for _ in 0..2 {
            match store.cancel(id, None, CancelReason::Client).await.unwrap() {
                Lookup::Found(row) => assert_eq!((row.status, row.expires_at_ms.is_some()), (expected, true)),
                other => panic!("{other:?}"),
            }
        }
    }
    assert_eq!(store.claim("worker", LEASE).await.unwrap(), None);
    assert_eq!(store.renew(&running, claimed.attempt, LEASE).await.unwrap(), Renewed::Cancelled);
    assert_eq!(store.progress(&running, claimed.attempt, "{}").await.unwrap(), Renewed::Cancelled);
    assert!(!store.finish(&running, claimed.attempt, success(b"late")).await.unwrap());
    assert_eq!(find(&store, &running).await.status, Status::Cancelled);
    assert_eq!(store.cancel("nothing", None, CancelReason::Client).await.unwrap(), Lookup::Missing);
}

async fn a_newer_job_of_a_series_cancels_the_older_ones(database: Database) {
    let store = database.open(StoreOptions::default()).await;
    let of = |series: &str, owner: &str, number| NewJob { supersede: Some(series.into()), ..job_of(owner, number) };
    let done = create(&store, of("drag", "me", 1)).await.id;
    work_one(&store, b"mesh").await;
    let running = create(&store, of("drag", "me", 2)).await.id;
    let claimed = store.claim("worker", LEASE).await.unwrap().unwrap();
    let queued = create(&store, of("drag", "me", 3)).await.id;
    let mut others = Vec::new();
    for other in [of("drag", "you", 4), of("other", "me", 5), job_of("me", 6)] {
        others.push(create(&store, other).await.id);
    }
    // The identifier comes from a machine whose clock is behind, so it sorts before the others.
    let Addition::Created(newest, cancelled) = store.add_job(of("drag", "me", 0)).await.unwrap() else {
        panic!("a new job")
    };
    let cancelled: BTreeSet<String> = cancelled.into_iter().map(|row| row.id).collect();
    assert_eq!(cancelled, BTreeSet::from([queued.clone()]));
    for (id, status) in [(&done, Status::Succeeded), (&running, Status::Cancelled), (&queued, Status::Cancelled)] {
        assert_eq!(find(&store, id).await.status, status);
    }
    for id in others.iter().chain([&newest.id]) {
        assert_eq!(find(&store, id).await.status, Status::Queued);
    }
    assert_eq!(store.renew(&running, claimed.attempt, LEASE).await.unwrap(), Renewed::Cancelled);
}

async fn of_many_submissions_of_a_series_at_once_one_remains(database: Database) {
    let store = database.open(StoreOptions::default()).await;
    let submissions: Vec<_> = (0..24)
        .map(|number| {
            let (store, job) = (store.clone(), NewJob { supersede: Some("drag".into()), ..job_of("me", number) });
            tokio::spawn(async move { store.add_job(job).await })
        })
        .collect();
    let mut cancelled = 0;
    for submission in submissions {
        let Addition::Created(_, older) = submission.await.unwrap().unwrap() else { panic!("a new job") };
        cancelled += older.len();
    }
    assert_eq!((cancelled, store.queue_length().await.unwrap()), (23, 1));
}

async fn a_label_and_metadata_stay_with_the_job(database: Database) {
    let store = database.open(StoreOptions::default()).await;
    let (label, metadata) = (Some("Façade 3".to_owned()), Some(r#"{"a":[1,null,"\u0000"]}"#.to_owned()));
    let marked = NewJob { label: label.clone(), metadata: metadata.clone(), ..job(1) };
    let created = create(&store, marked).await;
    assert_eq!((&created.label, &created.metadata), (&label, &metadata));
    work_one(&store, b"mesh").await;
    let found = find(&store, &created.id).await;
    assert_eq!((&found.label, &found.metadata), (&label, &metadata));
    // A job that shares the result has its own label.
    let shared = create(&store, NewJob { id: job(2).id, label: None, metadata: None, ..job(1) }).await;
    assert_eq!((shared.status, shared.label, shared.metadata), (Status::Succeeded, None, None));
}

async fn a_deleted_job_is_missing_and_its_worker_is_told(database: Database) {
    let store = database.open(StoreOptions { orphan_age: Duration::ZERO, ..StoreOptions::default() }).await;
    create(&store, job(1)).await;
    let claimed = store.claim("worker", LEASE).await.unwrap().unwrap();
    assert!(store.delete(&claimed.id, None).await.unwrap());
    assert!(!store.delete(&claimed.id, None).await.unwrap());
    assert_eq!(store.get(&claimed.id, None).await.unwrap(), Lookup::Missing);
    assert_eq!(store.renew(&claimed.id, claimed.attempt, LEASE).await.unwrap(), Renewed::Lost);
    assert!(!store.finish(&claimed.id, claimed.attempt, success(b"late")).await.unwrap());

    create(&store, job(2)).await;
    let id = work_one(&store, b"mesh").await;
    assert!(store.delete(&id, None).await.unwrap());
    assert_eq!(store.artefact(&id, None).await.unwrap(), None);
    // The result of a deleted job is not reused, and the sweep removes its bytes.
    assert_eq!(create(&store, NewJob { id: job(3).id, ..job(2) }).await.status, Status::Queued);
    assert_eq!(store.sweep().await.unwrap().artefacts, 1);
}

async fn an_owner_sees_no_job_of_another(database: Database) {
    let store = database.open(StoreOptions::default()).await;
    create(&store, job_of("mine", 1)).await;
    let id = work_one(&store, b"mesh").await;
    let other = Some("other");
    assert_eq!(store.get(&id, other).await.unwrap(), Lookup::Missing);
    assert_eq!(store.cancel(&id, other, CancelReason::Client).await.unwrap(), Lookup::Missing);
    assert_eq!(store.artefact(&id, other).await.unwrap(), None);
    assert!(!store.delete(&id, other).await.unwrap());
    assert!(matches!(store.watch(&id, other).await.unwrap(), Err(Lookup::Missing)));
    let filter = Filter { owner: Some("other".into()), ..Filter::default() };
    assert_eq!(store.list(filter, 10, None).await.unwrap(), (Vec::new(), None));
    assert!(store.artefact(&id, Some("mine")).await.unwrap().is_some());
    assert!(store.watch(&id, Some("mine")).await.unwrap().is_ok());
    assert!(store.delete(&id, Some("mine")).await.unwrap());
}

async fn a_list_pages_through_every_job_once(database: Database) {
    let store = database.open(StoreOptions::default()).await;
    for number in 0..25 {
        let kind = if number % 2 == 0 { "ruled_surface" } else { "minimal_surface" };
        create(&store, NewJob { kind: kind.into(), ..job_of(["a", "b"][number % 5 / 3], number) }).await;
    }
    let mut seen = Vec::new();
    let mut cursor: Option<String> = None;
    loop {
        let (page, next) = store.list(Filter::default(), 10, cursor.as_deref()).await.unwrap();
        assert!(page.len() <= 10);
        seen.extend(page.into_iter().map(|job| job.id));
        // A job that is created between two pages is newer than any cursor.
        if cursor.is_none() {
            create(&store, job(99)).await;
        }
        cursor = next;
        if cursor.is_none() {
            break;
        }
    }
    let expected: Vec<_> = (0..25).rev().map(|number| job(number).id).collect();
    assert_eq!(seen, expected);
    // A page that ends with the last job has no next page.
    assert_eq!(store.list(Filter::default(), 26, None).await.unwrap().1, None);

    store.cancel(&job(4).id, None, CancelReason::Client).await.unwrap();
    let count = async |filter: Filter| store.list(filter, 100, None).await.unwrap().0.len();
    assert_eq!(count(Filter { kind: Some("minimal_surface".into()), ..Filter::default() }).await, 12);
    assert_eq!(count(Filter { owner: Some("b".into()), ..Filter::default() }).await, 10);
    assert_eq!(count(Filter { statuses: vec![Status::Cancelled], ..Filter::default() }).await, 1);
    let all = Filter {
        owner: Some("b".into()),
        kind: Some("ruled_surface".into()),
        statuses: vec![Status::Cancelled],
        ..Filter::default()
    };
    assert_eq!(store.list(all.clone(), 100, Some(&job(5).id)).await.unwrap().0[0].id, job(4).id);
    assert_eq!(store.list(all.clone(), 100, Some(&job(4).id)).await.unwrap().0, Vec::new());
}

async fn a_list_has_statistics_only_if_it_is_asked_for_them(database: Database) {
    let store = database.open(StoreOptions::default()).await;
    create(&store, job(1)).await;
    work_one(&store, b"mesh").await;
    // The second job ends with its submission and reuses the result.
    assert_eq!(create(&store, NewJob { id: job(2).id, ..job(1) }).await.status, Status::Succeeded);
    for statistics in [false, true] {
        let (listed, _) = store.list(Filter { statistics, ..Filter::default() }, 10, None).await.unwrap();
        assert_eq!(listed.len(), 2);
        for row in listed {
            assert_eq!(row.statistics.is_some(), statistics);
            assert_eq!(row.summary.as_deref(), Some("{\"iterations\":3}"));
        }
    }
}

async fn equal_requests_share_a_result(database: Database) {
    let store = database.open(StoreOptions::default()).await;
    create(&store, job(1)).await;
    let first = work_one(&store, b"mesh").await;
    let second = create(&store, NewJob { id: job(2).id, ..job(1) }).await;
    let first_row = find(&store, &first).await;
    assert_eq!(second.id, job(2).id);
    assert_eq!((second.status, &second.statistics), (Status::Succeeded, &first_row.statistics));
    assert_eq!((&second.warnings, &second.artefact), (&first_row.warnings, &first_row.artefact));
    assert_eq!(statuses(&second), [Status::Queued, Status::Succeeded]);
    assert!(second.started_at_ms.is_some() && second.expires_at_ms.is_some());
    assert_eq!(store.artefact(&second.id, None).await.unwrap().unwrap().bytes, b"mesh");
    // Equal large results of different jobs are stored only once too.
    let mut made_apart = Vec::new();
    for number in 3..5 {
        create(&store, job(number)).await;
        let id = work_one(&store, &MANY_BYTES).await;
        made_apart.push(find(&store, &id).await.artefact);
    }
    assert_eq!(made_apart[0], made_apart[1]);
    assert_eq!(store.claim("worker", LEASE).await.unwrap(), None);
}

/// Tests jobs that were queued and jobs that were solved before they were stored.
async fn a_result_of_a_bypassing_request_is_not_shared(database: Database) {
    let store = database.open(StoreOptions::default()).await;
    for (reuse, status) in [(false, Status::Queued), (true, Status::Succeeded)] {
        for way in 0..2 {
            let number = 10 * way + usize::from(reuse);
            let new = NewJob { reuse, ..job(number) };
            let id = match way {
                0 => {
                    create(&store, new).await;
                    work_one(&store, b"mesh").await
                }
                _ => {
                    let solved = EarlyEnd { outcome: solved_as(b"mesh"), submitted_ms: 2, started_ms: 1 };
                    match store.add_ended_job(new, solved).await.unwrap() {
                        Addition::Created(row, _) => row.id,
                        other => panic!("{other:?}"),
                    }
                }
            };
            assert_eq!(store.artefact(&id, None).await.unwrap().unwrap().bytes, b"mesh");
            let later = create(&store, NewJob { id: job(100 + number).id, ..job(number) }).await;
            assert_eq!(later.status, status, "way {way}");
            store.delete(&later.id, None).await.unwrap();
        }
    }
}

async fn a_result_is_not_shared_with_other_owners_versions_or_bypassing_requests(database: Database) {
    let store = database.open(StoreOptions::default()).await;
    create(&store, job_of("me", 1)).await;
    work_one(&store, b"mesh").await;
    let mut number = 10;
    let mut again = || {
        number += 1;
        NewJob { id: job(number).id, ..job_of("me", 1) }
    };
    let expect_queued = [
        NewJob { owner: Some("you".into()), ..again() },
        NewJob { reuse: false, ..again() },
        NewJob { kind: "minimal_surface".into(), ..again() },
        NewJob { request_hash: [2; 32], ..again() },
    ];
    for new in expect_queued {
        assert_eq!(create(&store, new).await.status, Status::Queued);
    }
    let newer = database.open(StoreOptions { result_version: "next".into(), ..StoreOptions::default() }).await;
    assert_eq!(create(&newer, again()).await.status, Status::Queued);
    // A result that depends on more than the request is not reused.
    create(&store, job(50)).await;
    while let Some(claimed) = store.claim("worker", LEASE).await.unwrap() {
        let outcome = Outcome::Succeeded {
            summary: "{}".into(),
            statistics: "{}".into(),
            warnings: "[]".into(),
            artefact: b"partial".to_vec(),
            artefact_hash: [7; 32],
            reusable: false,
        };
        store.finish(&claimed.id, claimed.attempt, Arc::new(outcome)).await.unwrap();
    }
    assert_eq!(create(&store, NewJob { id: job(51).id, ..job(50) }).await.status, Status::Queued);
}

async fn expired_jobs_are_remembered_as_expired_and_then_forgotten(database: Database) {
    let keep_nothing =
        StoreOptions { retention: Duration::ZERO, orphan_age: Duration::ZERO, ..StoreOptions::default() };
    let store = database.open(keep_nothing.clone()).await;
    create(&store, job_of("me", 1)).await;
    create(&store, job_of("me", 2)).await;
    let ended = work_one(&store, b"mesh").await;
    let swept = store.sweep().await.unwrap();
    assert_eq!((swept.expired, swept.artefacts), (1, 1));
    assert_eq!(store.get(&ended, None).await.unwrap(), Lookup::Expired);
    assert_eq!(store.get(&ended, Some("me")).await.unwrap(), Lookup::Expired);
    assert_eq!(store.get(&ended, Some("you")).await.unwrap(), Lookup::Missing);
    assert_eq!(store.cancel(&ended, None, CancelReason::Client).await.unwrap(), Lookup::Expired);
    assert_eq!(store.artefact(&ended, None).await.unwrap(), None);
    // Waiting jobs do not expire.
    assert_eq!(find(&store, &job(2).id).await.status, Status::Queued);
    assert_eq!(store.list(Filter::default(), 10, None).await.unwrap().0.len(), 1);
    let forgetful = database.open(StoreOptions { expired_retention: Duration::ZERO, ..keep_nothing }).await;
    // The identifier is forgotten in the first millisecond after the one in which the job expired.
    for _ in 0..1000 {
        forgetful.sweep().await.unwrap();
        if store.get(&ended, None).await.unwrap() != Lookup::Expired {
            break;
        }
    }
    assert_eq!(store.get(&ended, None).await.unwrap(), Lookup::Missing);
}

async fn finished_jobs_beyond_max_jobs_expire(database: Database) {
    let store = database.open(StoreOptions { max_jobs: 2, ..StoreOptions::default() }).await;
    let mut ended = Vec::new();
    for number in 0..5 {
        create(&store, job(number)).await;
        ended.push(work_one(&store, &[number as u8]).await);
    }
    create(&store, job(9)).await;
    assert_eq!(store.sweep().await.unwrap().expired, 3);
    let (left, _) = store.list(Filter::default(), 10, None).await.unwrap();
    assert_eq!(left.len(), 3);
    assert!(left.iter().any(|job| job.status == Status::Queued));
    assert_eq!(store.sweep().await.unwrap().expired, 0);
}

async fn an_owner_with_many_jobs_or_bytes_expires_no_result_of_another(database: Database) {
    let of = async |store: &Store, owner: &str| -> usize {
        let filter = Filter { owner: Some(owner.into()), ..Filter::default() };
        store.list(filter, 100, None).await.unwrap().0.len()
    };
    let store = database.open(StoreOptions { max_jobs: 10, ..StoreOptions::default() }).await;
    // The oldest results belong to an owner with few of them.
    for (owner, numbers) in [("few", 0..3), ("many", 10..30), ("more", 40..70)] {
        for number in numbers {
            create(&store, job_of(owner, number)).await;
            work_one(&store, &[number as u8; 1000]).await;
        }
    }
    store.sweep().await.unwrap();
    assert_eq!([of(&store, "few").await, of(&store, "many").await, of(&store, "more").await], [3, 3, 3]);

    for number in 100..108 {
        create(&store, job_of("large", number)).await;
        work_one(&store, &vec![number as u8; 300_000]).await;
    }
    store.close().await;
    let options = StoreOptions { max_bytes: Some(2_500_000), orphan_age: Duration::ZERO, ..StoreOptions::default() };
    let store = database.open(options).await;
    assert!(store.sweep().await.unwrap().expired >= 2);
    assert_eq!([of(&store, "few").await, of(&store, "many").await, of(&store, "more").await], [3, 3, 3]);
    assert!(of(&store, "large").await < 8);
}

async fn a_shared_result_outlives_the_job_that_made_it(database: Database) {
    let store = database.open(StoreOptions { orphan_age: Duration::ZERO, ..StoreOptions::default() }).await;
    create(&store, job(1)).await;
    let first = work_one(&store, b"mesh").await;
    let second = create(&store, NewJob { id: job(2).id, ..job(1) }).await.id;
    assert!(store.delete(&first, None).await.unwrap());
    assert_eq!(store.sweep().await.unwrap().artefacts, 0);
    assert_eq!(store.artefact(&second, None).await.unwrap().unwrap().bytes, b"mesh");
    assert!(store.delete(&second, None).await.unwrap());
    assert_eq!(store.sweep().await.unwrap().artefacts, 1);
}

async fn a_result_outlives_its_job_while_a_request_that_begins_with_it_waits(database: Database) {
    let store = database.open(StoreOptions { orphan_age: Duration::ZERO, ..StoreOptions::default() }).await;
    create(&store, job(1)).await;
    let source = work_one(&store, b"mesh").await;
    let name = store.artefact(&source, None).await.unwrap().unwrap().hash;
    let from_it = |number| NewJob { source: Some(name.clone()), ..job(number) };
    create(&store, from_it(2)).await;
    assert!(store.delete(&source, None).await.unwrap());
    assert_eq!(store.sweep().await.unwrap().artefacts, 0);
    let claimed = store.claim("worker", LEASE).await.unwrap().unwrap();
    assert_eq!(claimed.source.as_ref(), Some(&name));
    assert_eq!(store.artefact_named(&name).await.unwrap().unwrap().bytes, b"mesh");
    // Once its job has ended, the request needs the result no longer.
    assert!(store.finish(&claimed.id, claimed.attempt, success(b"other")).await.unwrap());
    assert_eq!(store.sweep().await.unwrap().artefacts, 1);
    assert_eq!(store.artefact_named(&name).await.unwrap(), None);
    assert!(matches!(store.add_job(from_it(3)).await, Err(StoreError::Contended(_))));
}

/// Returns options that put results of more than eight bytes into `folder`.
fn with_files(folder: &TempDir) -> StoreOptions {
    StoreOptions {
        results: Some(folder.path().display().to_string()),
        inline_bytes: 8,
        orphan_age: Duration::ZERO,
        ..StoreOptions::default()
    }
}

fn file_count(folder: &TempDir) -> usize {
    std::fs::read_dir(folder.path()).unwrap().count()
}

async fn a_large_result_is_a_file_and_goes_with_its_job(database: Database) {
    let folder = tempfile::tempdir().unwrap();
    let store = database.open(with_files(&folder)).await;
    for number in 0..3 {
        create(&store, job(number)).await;
    }
    let small = work_one(&store, b"8 bytes!").await;
    assert_eq!(file_count(&folder), 0);
    let large = work_one(&store, &MANY_BYTES).await;
    assert_eq!(file_count(&folder), 1);
    // Equal bytes are stored only once.
    let twin = work_one(&store, &MANY_BYTES).await;
    assert_eq!(file_count(&folder), 1);
    assert_eq!(store.artefact(&small, None).await.unwrap().unwrap().bytes, b"8 bytes!");
    assert_eq!(store.artefact(&large, None).await.unwrap().unwrap().bytes, MANY_BYTES);
    assert_eq!(store.artefact(&twin, None).await.unwrap(), store.artefact(&large, None).await.unwrap());

    // A worker that lost its lease leaves no file.
    create(&store, job(5)).await;
    let stalled = store.claim("stalled", NO_LEASE).await.unwrap().unwrap();
    store.sweep().await.unwrap();
    assert!(!store.finish(&stalled.id, stalled.attempt, success(b"late and large")).await.unwrap());
    assert_eq!(file_count(&folder), 1);

    store.delete(&large, None).await.unwrap();
    assert_eq!(store.sweep().await.unwrap().artefacts, 0);
    store.delete(&twin, None).await.unwrap();
    assert_eq!(store.sweep().await.unwrap().artefacts, 1);
    assert_eq!(file_count(&folder), 0);
}

async fn a_file_without_a_job_is_swept(database: Database) {
    let folder = tempfile::tempdir().unwrap();
    let store = database.open(with_files(&folder)).await;
    create(&store, job(1)).await;
    let id = work_one(&store, b"more than 8 bytes").await;
    // Workers that die before their row is committed leave files like these.
    std::fs::write(folder.path().join("0000000000000000000000000A-1"), b"orphan").unwrap();
    std::fs::write(folder.path().join("0000000000000000000000000B-1.part"), b"orp").unwrap();
    let patient = database.open(StoreOptions { orphan_age: TOO_LONG, ..with_files(&folder) }).await;
    assert_eq!(patient.sweep().await.unwrap().files, 0);
    assert_eq!(store.sweep().await.unwrap().files, 2);
    assert_eq!(store.artefact(&id, None).await.unwrap().unwrap().bytes, b"more than 8 bytes");
}

async fn a_database_of_small_results_takes_new_jobs_for_ever(database: Database) {
    // The results have 8 bytes each, and the rows fill the database twice.
    const MAX_BYTES: u64 = 2 << 20;
    const JOBS: usize = 1000;
    let store = database.open(StoreOptions { max_bytes: Some(MAX_BYTES), ..StoreOptions::default() }).await;
    let mut ids = Vec::new();
    for number in 0..JOBS {
        let metadata = Some(format!("{{\"text\":\"{}\"}}", "x".repeat(4000)));
        ids.push(create(&store, NewJob { metadata, ..job(number) }).await.id);
        work_one(&store, &number.to_le_bytes()).await;
        if number % 40 == 39 {
            store.sweep().await.unwrap();
        }
    }
    // No more than necessary is evicted.
    for id in &ids[JOBS - 250..] {
        find(&store, id).await;
    }
    if database.url.starts_with("sqlite") {
        assert_eq!(store.get(&ids[0], None).await.unwrap(), Lookup::Expired);
    }
}

async fn a_sweep_of_many_steps_removes_everything_due(database: Database) {
    // The number is larger than one step of every part of the sweep.
    const MANY: usize = 230;
    const KEPT: usize = 10;
    let store = database.open(StoreOptions { max_jobs: KEPT as u64, ..StoreOptions::default() }).await;
    let mut ended = Vec::new();
    for number in 0..MANY {
        create(&store, job(number)).await;
        ended.push(work_one(&store, &number.to_le_bytes()).await);
    }
    // The last job shares the result of the newest job that expires, so this result stays.
    let twin = create(&store, NewJob { id: job(MANY).id, ..job(MANY - KEPT) }).await.id;
    let swept = store.sweep().await.unwrap();
    assert_eq!((swept.expired, swept.artefacts), ((MANY + 1 - KEPT) as u64, 0), "young results must stay");
    let left: BTreeSet<String> =
        store.list(Filter::default(), 100, None).await.unwrap().0.into_iter().map(|job| job.id).collect();
    assert_eq!(left, ended[MANY + 1 - KEPT..].iter().cloned().chain([twin.clone()]).collect());
    assert_eq!(store.get(&ended[0], None).await.unwrap(), Lookup::Expired);

    let hasty =
        StoreOptions { orphan_age: Duration::ZERO, expired_retention: Duration::ZERO, ..StoreOptions::default() };
    let store = database.open(hasty).await;
    assert_eq!(store.sweep().await.unwrap().artefacts, (MANY - KEPT) as u64);
    for id in &left {
        assert!(store.artefact(id, None).await.unwrap().is_some());
    }
    assert_eq!(store.artefact(&twin, None).await.unwrap().unwrap().bytes, (MANY - KEPT).to_le_bytes());
    store.sweep().await.unwrap();
    for id in &ended[..MANY + 1 - KEPT] {
        assert_eq!(store.get(id, None).await.unwrap(), Lookup::Missing);
    }
}

async fn a_damaged_result_is_discarded_and_made_again(database: Database) {
    let store = database.open(StoreOptions::default()).await;
    create(&store, job(1)).await;
    let first = work_one(&store, &MANY_BYTES).await;
    let shared = create(&store, NewJob { id: job(2).id, ..job(1) }).await;
    assert_eq!(shared.status, Status::Succeeded);
    let damaged = store.artefact(&first, None).await.unwrap().unwrap();
    store.discard(&damaged).await.unwrap();
    assert_eq!(store.artefact(&first, None).await.unwrap(), None);
    assert_eq!(find(&store, &first).await.status, Status::Succeeded);
    // An equal request does not reuse the discarded result. Its own result is then also the earlier jobs' result.
    assert_eq!(create(&store, NewJob { id: job(3).id, ..job(1) }).await.status, Status::Queued);
    work_one(&store, &MANY_BYTES).await;
    for id in [&first, &shared.id] {
        assert_eq!(store.artefact(id, None).await.unwrap().unwrap().bytes, MANY_BYTES);
    }
    // Discarding the damaged bytes again must not remove the new, sound ones.
    store.discard(&damaged).await.unwrap();
    assert!(store.artefact(&first, None).await.unwrap().is_some());
}

async fn a_fresh_result_replaces_an_equal_one_that_is_damaged(database: Database) {
    let folder = tempfile::tempdir().unwrap();
    for options in [StoreOptions::default(), with_files(&folder)] {
        let store = database.open(options).await;
        create(&store, NewJob { reuse: false, ..job(1) }).await;
        let id = work_one(&store, &MANY_BYTES).await;
        for file in std::fs::read_dir(folder.path()).unwrap() {
            std::fs::write(file.unwrap().path(), b"damaged").unwrap();
        }
        database.execute("UPDATE artefacts SET body = hash WHERE body IS NOT NULL").await;
        assert_ne!(store.artefact(&id, None).await.unwrap().unwrap().bytes, MANY_BYTES);
        create(&store, NewJob { reuse: false, ..job(2) }).await;
        work_one(&store, &MANY_BYTES).await;
        assert_eq!(store.artefact(&id, None).await.unwrap().unwrap().bytes, MANY_BYTES);
        for number in [1, 2] {
            store.delete(&job(number).id, None).await.unwrap();
        }
        store.close().await;
    }
}

async fn a_missing_file_keeps_its_result_from_being_shared(database: Database) {
    let folder = tempfile::tempdir().unwrap();
    let store = database.open(with_files(&folder)).await;
    create(&store, job(1)).await;
    let id = work_one(&store, &MANY_BYTES).await;
    for file in std::fs::read_dir(folder.path()).unwrap() {
        std::fs::remove_file(file.unwrap().path()).unwrap();
    }
    assert!(matches!(store.artefact(&id, None).await, Err(StoreError::Unavailable(_))));
    assert_eq!(create(&store, NewJob { id: job(2).id, ..job(1) }).await.status, Status::Queued);
    work_one(&store, &MANY_BYTES).await;
    assert_eq!(store.artefact(&id, None).await.unwrap().unwrap().bytes, MANY_BYTES);
}

async fn an_unreadable_row_does_not_hide_other_rows(database: Database) {
    let store = database.open(StoreOptions::default()).await;
    for number in 0..5 {
        create(&store, job(number)).await;
    }
    database.execute("UPDATE jobs SET status = 'nonsense' WHERE id LIKE '%3'").await;
    let (first, next) = store.list(Filter::default(), 2, None).await.unwrap();
    let (rest, last) = store.list(Filter::default(), 4, next.as_deref()).await.unwrap();
    let ids: Vec<String> = first.into_iter().chain(rest).map(|job| job.id).collect();
    assert_eq!(ids, [4, 2, 1, 0].map(|number| job(number).id));
    assert_eq!(last, None);
}

async fn a_lease_from_a_clock_that_was_set_back_has_run_out(database: Database) {
    let store = database.open(StoreOptions::default()).await;
    create(&store, job(1)).await;
    let held = store.claim("before", LEASE).await.unwrap().unwrap();
    // Adding to the stored times has the same effect as setting the clock back. The first step, 50 s, is less than the
    // lease of 60 s, so the lease still holds. The second step is a day longer, so the lease has run out.
    database.execute("UPDATE jobs SET lease_until = lease_until + 50000, started_at = started_at + 50000").await;
    assert_eq!(store.claim("after", LEASE).await.unwrap(), None);
    database.execute("UPDATE jobs SET lease_until = lease_until + 86400000, started_at = started_at + 86400000").await;
    let again = store.claim("after", LEASE).await.unwrap().expect("the lease has run out");
    assert_eq!((again.id, again.attempt), (held.id, held.attempt + 1));
}

async fn a_job_is_found_by_its_idempotency_key(database: Database) {
    let store = database.open(StoreOptions::default()).await;
    for number in 0..4 {
        let owner = ["me", "you"][number % 2];
        create(&store, NewJob { idempotency_key: Some(format!("key {}", number / 2)), ..job_of(owner, number) }).await;
    }
    let key = Some("key 1".to_owned());
    let of = async |owner: Option<&str>| {
        let filter = Filter { owner: owner.map(str::to_owned), idempotency_key: key.clone(), ..Filter::default() };
        let (found, _) = store.list(filter, 10, None).await.unwrap();
        found.into_iter().map(|job| job.id).collect::<Vec<_>>()
    };
    assert_eq!(of(Some("me")).await, [job(2).id]);
    assert_eq!(of(None).await, [job(3).id, job(2).id]);
    assert_eq!(of(Some("nobody")).await, Vec::<String>::new());
}

/// A separate small file system, which is removed when this value is dropped.
struct SmallDisk(TempDir);

impl SmallDisk {
    /// Returns `None`, and records the skip, if this process may not mount a file system.
    fn mount(mib: u32) -> Option<Self> {
        let folder = tempfile::tempdir().unwrap();
        let mounted = std::process::Command::new("mount")
            .args(["-t", "tmpfs", "-o", &format!("size={mib}m"), "tmpfs"])
            .arg(folder.path())
            .status();
        if !mounted.is_ok_and(|status| status.success()) {
            skipped("full disk", "a small file system cannot be mounted, which takes root on Linux");
            return None;
        }
        Some(Self(folder))
    }
}

impl Drop for SmallDisk {
    fn drop(&mut self) {
        let _ = std::process::Command::new("umount").arg("-l").arg(self.0.path()).status();
    }
}

#[tokio::test(flavor = "multi_thread", worker_threads = 2)]
async fn a_full_disk_recovers_once_jobs_expire() {
    let Some(disk) = SmallDisk::mount(80) else { return };
    let url = format!("sqlite://{}/plateau.db", disk.0.path().display());
    let options = StoreOptions {
        retention: Duration::ZERO,
        orphan_age: Duration::ZERO,
        ballast_bytes: 24 << 20,
        ..StoreOptions::default()
    };
    let store = Store::open(&url, options).await.unwrap();
    store.check().await.unwrap();
    let mut accepted = 0;
    for round in 0..3 {
        // Results and the requests of waiting jobs fill the disk.
        let full = loop {
            accepted += 1;
            let new = NewJob { request: vec![b' '; 50_000], ..job(accepted) };
            if let Err(error) = store.add_job(new).await {
                break error;
            }
            // Claiming writes too, so it may be what finds the disk full. The job then waits until there is room again.
            let claimed = match store.claim("worker", LEASE).await {
                Ok(claimed) => claimed.expect("a job to claim"),
                Err(error) => break error,
            };
            let mut artefact = vec![round as u8; 300_000];
            artefact[..8].copy_from_slice(&accepted.to_le_bytes());
            // An accepted job can still end, at the latest after a part of the ballast has been given up.
            let mut finished = store.finish(&claimed.id, claimed.attempt, success(&artefact)).await;
            for _ in 0..100 {
                if finished.is_ok() {
                    break;
                }
                finished = store.finish(&claimed.id, claimed.attempt, success(&artefact)).await;
            }
            assert_eq!(finished, Ok(true));
        };
        assert!(matches!(full, StoreError::NoSpace(_)), "{full:?}");
        assert!(store.check().await.is_err());
        // The sweep is repeated, as a server does, because a sweep before the log is copied may find no space.
        for _ in 0..200 {
            let _ = store.sweep().await;
            if store.check().await.is_ok() {
                break;
            }
            // The pause lets the writer copy its log before the next sweep.
            tokio::time::sleep(Duration::from_millis(50)).await;
        }
        store.check().await.unwrap();
        create(&store, NewJob { request: vec![b' '; 50_000], ..job(100_000 + round) }).await;
        store.delete(&job(100_000 + round).id, None).await.unwrap();
    }
    assert!(accepted > 250, "{accepted} jobs on a disk that holds some two hundred results");
}

async fn results_stay_within_max_bytes(database: Database) {
    // Two results of 1 MB fit into four fifths of 2.5 MB.
    let options = StoreOptions { max_bytes: Some(2_500_000), orphan_age: Duration::ZERO, ..StoreOptions::default() };
    let store = database.open(StoreOptions { max_bytes: None, ..options.clone() }).await;
    let mut ended = Vec::new();
    for number in 0..4 {
        create(&store, job(number)).await;
        ended.push(work_one(&store, &vec![number as u8; 1_000_000]).await);
    }
    store.close().await;
    let store = database.open(StoreOptions { max_bytes: Some(2_500_000), ..options }).await;
    let swept = store.sweep().await.unwrap();
    assert!(swept.expired >= 2, "{swept:?}");
    assert_eq!(store.get(&ended[0], None).await.unwrap(), Lookup::Expired);
    create(&store, job(9)).await;
}

#[tokio::test]
async fn a_full_database_refuses_jobs_and_loses_none() {
    let database = Database::new(Engine::Sqlite).await.unwrap();
    let store = database
        .open(StoreOptions { max_bytes: Some(1 << 20), orphan_age: Duration::ZERO, ..StoreOptions::default() })
        .await;
    let large = |number| NewJob { request: vec![b' '; 100_000], ..job(number) };
    let mut accepted = Vec::new();
    // Several jobs are submitted at once, so that a whole group of writes finds the disk full.
    'filling: for group in 0..10 {
        let submissions: Vec<_> = (0..4).map(|member| store.add_job(large(group * 4 + member))).collect();
        for (member, result) in futures_util::future::join_all(submissions).await.into_iter().enumerate() {
            match result {
                Ok(Addition::Created(row, _)) => accepted.push(row.id),
                Err(StoreError::NoSpace(_)) => {
                    let id = job(group * 4 + member).id;
                    assert_eq!(
                        store.get(&id, None).await.unwrap(),
                        Lookup::Missing,
                        "a refused job must not be stored"
                    );
                    if member == 3 {
                        break 'filling;
                    }
                }
                other => panic!("{other:?}"),
            }
        }
    }
    assert!((1..40).contains(&accepted.len()), "{} accepted", accepted.len());
    // Every accepted job is stored, and freed space is used again.
    for id in &accepted {
        assert_eq!(find(&store, id).await.status, Status::Queued);
    }
    for id in &accepted {
        store.delete(id, None).await.unwrap();
    }
    create(&store, large(99)).await;
    assert_eq!(store.claim("worker", LEASE).await.unwrap().unwrap().request.len(), 100_000);
}

#[tokio::test(flavor = "multi_thread", worker_threads = 2)]
async fn a_store_survives_a_restart_of_postgresql() {
    let Some(server) = postgres::Postgres::start() else { return };
    let options = StoreOptions { poll_interval: Duration::from_millis(20), ..StoreOptions::default() };
    let store = Store::open(&server.database().await, options).await.unwrap();
    create(&store, job(1)).await;
    let claimed = store.claim("worker", LEASE).await.unwrap().unwrap();
    let mut watch = store.watch(&claimed.id, None).await.unwrap().unwrap();
    server.stop();
    for _ in 0..3 {
        let refused = store.add_job(job(2)).await;
        assert!(matches!(refused, Err(StoreError::Unavailable(_))), "{refused:?}");
    }
    server.start_again();
    // The store detects broken connections and replaces them.
    let finish = async {
        loop {
            match store.finish(&claimed.id, claimed.attempt, success(b"mesh")).await {
                Ok(finished) => return finished,
                Err(StoreError::Unavailable(_)) => {}
                Err(error) => panic!("{error:?}"),
            }
        }
    };
    assert!(tokio::time::timeout(TOO_LONG, finish).await.expect("an answer in time"));
    until(&mut watch, |job| job.status == Status::Succeeded).await;
    create(&store, job(2)).await;
}

/// Waits until the watched job satisfies `done`.
async fn until(watch: &mut plateau::store::JobWatch, done: impl Fn(&JobRow) -> bool) -> Arc<JobRow> {
    tokio::time::timeout(TOO_LONG, async {
        loop {
            let job = watch.current().expect("the job is there");
            if done(&job) {
                return job;
            }
            watch.changed().await;
        }
    })
    .await
    .expect("the watched job changes in time")
}

async fn watchers_see_every_status(database: Database) {
    let store = database.open(StoreOptions { poll_interval: TOO_LONG * 10, ..StoreOptions::default() }).await;
    let id = create(&store, job(1)).await.id;
    let mut watches = Vec::new();
    for _ in 0..50 {
        watches.push(store.watch(&id, None).await.unwrap().unwrap());
    }
    for watch in &mut watches {
        assert_eq!(watch.current().unwrap().status, Status::Queued);
    }
    let claimed = store.claim("worker", LEASE).await.unwrap().unwrap();
    for watch in &mut watches {
        until(watch, |job| job.status == Status::Running).await;
    }
    store.progress(&id, claimed.attempt, "{\"fraction\":0.25}").await.unwrap();
    for watch in &mut watches {
        until(watch, |job| job.progress.is_some()).await;
    }
    store.finish(&id, claimed.attempt, Arc::new(Outcome::Failed { error: "{}".into() })).await.unwrap();
    for watch in &mut watches {
        let ended = tokio::time::timeout(TOO_LONG, watch.ended()).await.unwrap().unwrap();
        assert_eq!((ended.status, ended.error.as_deref()), (Status::Failed, Some("{}")));
    }
    store.delete(&id, None).await.unwrap();
    for watch in &mut watches {
        tokio::time::timeout(TOO_LONG, watch.changed()).await.unwrap();
        assert_eq!(watch.current(), None);
        assert_eq!(watch.ended().await, None);
    }
}

async fn a_watch_of_a_missing_job_returns_missing(database: Database) {
    let store = database.open(StoreOptions::default()).await;
    assert!(matches!(store.watch("nothing", None).await.unwrap(), Err(Lookup::Missing)));
    // A job with the same identifier can still be created.
    let id = create(&store, job(1)).await.id;
    assert!(store.watch(&id, None).await.unwrap().is_ok());
}

async fn another_instance_sees_changes_and_work(database: Database) {
    // On SQLite other instances find changes by polling. On PostgreSQL polling is practically off in this case.
    let poll_interval = if database.url.starts_with("sqlite") { Duration::from_millis(20) } else { TOO_LONG * 10 };
    let options = StoreOptions { poll_interval, ..StoreOptions::default() };
    let (here, there) = (database.open(options.clone()).await, database.open(options).await);
    let mut work = there.work_signal();
    if database.url.starts_with("postgres") {
        // The listener signals once it is connected.
        tokio::time::timeout(TOO_LONG, work.wait_for(|count| *count > 0)).await.unwrap().unwrap();
    }
    let seen = *work.borrow_and_update();
    let id = create(&here, job(1)).await.id;
    let mut watch = there.watch(&id, None).await.unwrap().unwrap();
    if database.url.starts_with("postgres") {
        tokio::time::timeout(TOO_LONG, work.wait_for(|count| *count > seen)).await.unwrap().unwrap();
    }
    let claimed = there.claim("worker", LEASE).await.unwrap().unwrap();
    until(&mut watch, |job| job.status == Status::Running).await;
    here.cancel(&id, None, CancelReason::Client).await.unwrap();
    until(&mut watch, |job| job.status == Status::Cancelled).await;
    assert!(!there.finish(&id, claimed.attempt, success(b"late")).await.unwrap());
}

async fn many_workers_finish_every_job_exactly_once(database: Database) {
    const JOBS: usize = 120;
    let store = database.open(StoreOptions { max_attempts: 1000, ..StoreOptions::default() }).await;
    let submissions = (0..JOBS).map(|number| {
        let store = store.clone();
        tokio::spawn(async move { create(&store, NewJob { reuse: false, ..job(number) }).await })
    });
    for submission in submissions.collect::<Vec<_>>() {
        submission.await.unwrap();
    }
    let ended = Arc::new(Mutex::new(BTreeMap::<String, usize>::new()));
    let workers = (0..4).map(|worker| {
        let (store, ended) = (store.clone(), Arc::clone(&ended));
        tokio::spawn(async move {
            let mut late = Vec::new();
            let mut turn = 0;
            loop {
                turn += 1;
                // Every third claim outlives its lease and tries to finish much later.
                let stalls = (turn + worker) % 3 == 0;
                let lease = if stalls { NO_LEASE } else { LEASE };
                let Some(claimed) = store.claim(&format!("worker {worker}"), lease).await.unwrap() else { break };
                if stalls {
                    late.push(claimed);
                    continue;
                }
                let artefact = [claimed.request.as_slice(), b" solved"].concat();
                if store.finish(&claimed.id, claimed.attempt, success(&artefact)).await.unwrap() {
                    *ended.lock().unwrap().entry(claimed.id).or_default() += 1;
                }
            }
            late
        })
    });
    let mut late = Vec::new();
    for worker in workers.collect::<Vec<_>>() {
        late.extend(worker.await.unwrap());
    }
    assert!(!late.is_empty());
    // Stalled jobs of the last workers may still be left.
    while let Some(claimed) = store.claim("last", LEASE).await.unwrap() {
        let artefact = [claimed.request.as_slice(), b" solved"].concat();
        assert!(store.finish(&claimed.id, claimed.attempt, success(&artefact)).await.unwrap());
        *ended.lock().unwrap().entry(claimed.id).or_default() += 1;
    }
    for claimed in late {
        assert!(!store.finish(&claimed.id, claimed.attempt, success(b"late")).await.unwrap());
    }
    let ended = ended.lock().unwrap().clone();
    assert_eq!(ended.len(), JOBS);
    assert!(ended.values().all(|times| *times == 1));
    for number in 0..JOBS {
        let bytes = store.artefact(&job(number).id, None).await.unwrap().unwrap().bytes;
        assert_eq!(bytes, format!("{{\"number\":{number}}} solved").into_bytes());
    }
}

async fn a_reopened_store_still_has_its_jobs(database: Database) {
    let store = database.open(StoreOptions::default()).await;
    create(&store, job(1)).await;
    let ended = work_one(&store, b"mesh").await;
    create(&store, job(2)).await;
    store.close().await;
    let store = database.open(StoreOptions::default()).await;
    assert_eq!(store.artefact(&ended, None).await.unwrap().unwrap().bytes, b"mesh");
    assert_eq!(work_one(&store, b"other").await, job(2).id);
}

async fn a_closed_store_returns_unavailable(database: Database) {
    let store = database.open(StoreOptions::default()).await;
    store.check().await.unwrap();
    store.close().await;
    assert!(matches!(store.check().await, Err(StoreError::Unavailable(_))));
    assert!(matches!(store.add_job(job(1)).await, Err(StoreError::Unavailable(_))));
    store.close().await;
}

async fn the_queue_length_follows_the_queue(database: Database) {
    let store = database.open(StoreOptions::default()).await;
    for number in 0..3 {
        create(&store, job(number)).await;
    }
    store.claim("worker", LEASE).await.unwrap();
    assert_eq!(store.queue_length().await.unwrap(), 2);
}

#[tokio::test]
async fn a_refused_write_does_not_affect_the_others_of_its_group() {
    let database = Database::new(Engine::Sqlite).await.unwrap();
    let store = database.open(StoreOptions { queue_limit: 10, ..StoreOptions::default() }).await;
    let submissions: Vec<_> = (0..100).map(|number| store.add_job(job(number))).collect();
    let mut created = 0;
    for result in futures_util::future::join_all(submissions).await {
        match result {
            Ok(Addition::Created(..)) => created += 1,
            Err(StoreError::QueueFull { own: false }) => {}
            other => panic!("{other:?}"),
        }
    }
    assert_eq!(created, 10);
    assert_eq!(store.queue_length().await.unwrap(), 10);
}

#[tokio::test]
async fn a_url_of_another_database_is_refused() {
    for url in ["mysql://localhost/x", "plateau.db", ""] {
        assert!(matches!(Store::open(url, StoreOptions::default()).await, Err(StoreError::Url(_))), "{url}");
    }
}

fn batch_of(owner: Option<&str>, number: usize, jobs: std::ops::Range<usize>) -> NewBatch {
    let owner = owner.map(str::to_owned);
    NewBatch {
        id: format!("B{number:025}"),
        owner: owner.clone(),
        idempotency_key: Some(format!("key {number}")),
        body_hash: [number as u8; 32],
        callback_url: None,
        jobs: jobs.map(|number| NewJob { owner: owner.clone(), ..job(number) }).collect(),
    }
}

async fn create_batch(store: &Store, batch: NewBatch) -> BatchRow {
    match store.add_batch(batch).await.unwrap() {
        BatchAddition::Created(row) => row,
        other => panic!("expected a new batch, got {other:?}"),
    }
}

async fn found_batch(store: &Store, id: &str) -> BatchRow {
    match store.batch(id, None).await.unwrap() {
        BatchLookup::Found(row) => row,
        other => panic!("expected a batch, got {other:?}"),
    }
}

async fn all_jobs_of_a_batch_are_stored_or_none(database: Database) {
    let store = database.open(StoreOptions { queue_limit: 5, ..StoreOptions::default() }).await;
    let batch = create_batch(&store, batch_of(None, 1, 0..4)).await;
    let indices: Vec<(i64, &str)> = batch.jobs.iter().map(|job| (job.index, job.id.as_str())).collect();
    let expected: Vec<String> = (0..4).map(|number| job(number).id).collect();
    assert_eq!(indices, (0..4).zip(expected.iter().map(String::as_str)).collect::<Vec<_>>());
    // There is room for one more job but not for two.
    let refused = store.add_batch(batch_of(None, 2, 4..6)).await;
    assert!(matches!(refused, Err(StoreError::QueueFull { own: false })));
    assert_eq!(
        (store.queue_length().await.unwrap(), store.batch("B2", None).await.unwrap()),
        (4, BatchLookup::Missing)
    );
    // The same key and body return the same batch. The same key with another body is a conflict.
    let again = store.add_batch(NewBatch { id: "other".into(), ..batch_of(None, 1, 10..12) }).await.unwrap();
    assert_eq!(again, BatchAddition::Existing(batch));
    let conflict = NewBatch { body_hash: [9; 32], ..batch_of(None, 1, 10..12) };
    assert_eq!(store.add_batch(conflict).await.unwrap(), BatchAddition::KeyConflict);
    assert_eq!(store.queue_length().await.unwrap(), 4);
}

async fn a_batch_is_hidden_from_other_owners_and_expires_with_its_last_job(database: Database) {
    let store = database.open(StoreOptions { retention: Duration::ZERO, ..StoreOptions::default() }).await;
    let batch = create_batch(&store, batch_of(Some("me"), 1, 0..2)).await;
    assert_eq!(store.batch(&batch.id, Some("you")).await.unwrap(), BatchLookup::Missing);
    assert_eq!(store.delete_batch(&batch.id, Some("you")).await.unwrap(), None);
    assert!(store.cancel_batch(&batch.id, Some("you")).await.unwrap().1.is_empty());
    for _ in 0..2 {
        let claimed = store.claim("w", LEASE).await.unwrap().unwrap();
        assert!(store.finish(&claimed.id, claimed.attempt, success(b"mesh")).await.unwrap());
        store.sweep().await.unwrap();
    }
    assert_eq!(store.batch(&batch.id, Some("me")).await.unwrap(), BatchLookup::Expired);
    assert_eq!(store.batch(&batch.id, Some("you")).await.unwrap(), BatchLookup::Missing);
    // A deleted batch is not an expired one.
    let other = create_batch(&store, batch_of(Some("me"), 2, 2..4)).await;
    assert_eq!(store.delete_batch(&other.id, Some("me")).await.unwrap().map(|ids| ids.len()), Some(2));
    assert_eq!(store.batch(&other.id, Some("me")).await.unwrap(), BatchLookup::Missing);
    assert_eq!(store.queue_length().await.unwrap(), 0);
}

async fn cancelling_a_batch_cancels_every_unfinished_job(database: Database) {
    let store = database.open(StoreOptions::default()).await;
    let batch = create_batch(&store, batch_of(None, 1, 0..3)).await;
    let ended = store.claim("w", LEASE).await.unwrap().unwrap();
    assert!(store.finish(&ended.id, ended.attempt, success(b"mesh")).await.unwrap());
    let running = store.claim("w", LEASE).await.unwrap().unwrap();
    let (_, mut cancelled) = store.cancel_batch(&batch.id, None).await.unwrap();
    cancelled.sort();
    assert_eq!(cancelled, [job(1).id, job(2).id]);
    let statuses: Vec<Status> = found_batch(&store, &batch.id).await.jobs.iter().map(|job| job.status).collect();
    assert_eq!(statuses, [Status::Succeeded, Status::Cancelled, Status::Cancelled]);
    assert_eq!(store.renew(&running.id, running.attempt, LEASE).await.unwrap(), Renewed::Cancelled);
    assert!(store.claim("w", LEASE).await.unwrap().is_none());
    assert_eq!(store.batch_jobs(&batch.id).await.unwrap().len(), 3);
}

async fn a_callback_is_due_from_the_end_until_it_is_settled(database: Database) {
    let store = database.open(StoreOptions::default()).await;
    create(&store, NewJob { callback_url: Some("https://example.org".into()), ..job_of("me", 1) }).await;
    assert_eq!(store.claim_callback(LEASE, &Busy::default()).await.unwrap(), None, "it has not ended");
    let claimed = store.claim("w", LEASE).await.unwrap().unwrap();
    assert!(store.finish(&claimed.id, claimed.attempt, success(b"mesh")).await.unwrap());
    let first = store.claim_callback(NO_LEASE, &Busy::default()).await.unwrap().unwrap();
    assert_eq!(
        (first.subject, first.id.as_str(), first.owner.as_deref()),
        (Subject::Job, claimed.id.as_str(), Some("me"))
    );
    assert_eq!((first.url.as_str(), first.attempts), ("https://example.org", 1));
    // The first claimer died. The callback now belongs to the second, so the first cannot settle it any more.
    let second = store.claim_callback(LEASE, &Busy::default()).await.unwrap().unwrap();
    assert_eq!(second.attempts, 2);
    assert_eq!(store.claim_callback(LEASE, &Busy::default()).await.unwrap(), None);
    store.settle_callback(&first, Delivery::Delivered).await.unwrap();
    store.put_off_callback(&second, Duration::ZERO).await.unwrap();
    let third = store.claim_callback(LEASE, &Busy::default()).await.unwrap().unwrap();
    assert_eq!(third.attempts, 3);
    store.settle_callback(&third, Delivery::Delivered).await.unwrap();
    store.put_off_callback(&third, Duration::ZERO).await.unwrap();
    assert_eq!(store.claim_callback(LEASE, &Busy::default()).await.unwrap(), None);
    // A callback is also due after a reused result and after a cancel.
    create(
        &store,
        NewJob { callback_url: Some("https://a.example".into()), request_hash: job(1).request_hash, ..job_of("me", 2) },
    )
    .await;
    create(&store, NewJob { callback_url: Some("https://b.example".into()), ..job_of("me", 3) }).await;
    store.cancel(&job(3).id, None, CancelReason::Client).await.unwrap();
    let mut urls = Vec::new();
    while let Some(callback) = store.claim_callback(LEASE, &Busy::default()).await.unwrap() {
        urls.push(callback.url);
    }
    urls.sort();
    assert_eq!(urls, ["https://a.example", "https://b.example"]);
}

async fn a_batchs_callback_is_due_after_its_last_job(database: Database) {
    let store = database.open(StoreOptions::default()).await;
    let new = NewBatch { callback_url: Some("https://example.org".into()), ..batch_of(Some("me"), 1, 0..2) };
    let batch = create_batch(&store, new).await;
    for _ in 0..2 {
        assert_eq!(store.claim_callback(LEASE, &Busy::default()).await.unwrap(), None);
        let claimed = store.claim("w", LEASE).await.unwrap().unwrap();
        assert!(store.finish(&claimed.id, claimed.attempt, success(b"mesh")).await.unwrap());
    }
    let callback = store.claim_callback(LEASE, &Busy::default()).await.unwrap().unwrap();
    assert_eq!(
        (callback.subject, callback.id.as_str(), callback.owner.as_deref()),
        (Subject::Batch, batch.id.as_str(), Some("me"))
    );
    store.settle_callback(&callback, Delivery::Delivered).await.unwrap();
    assert_eq!(store.claim_callback(NO_LEASE, &Busy::default()).await.unwrap(), None);
}

async fn concurrent_claimers_get_every_callback_once(database: Database) {
    let store = database.open(StoreOptions::default()).await;
    for number in 0..40 {
        create(&store, NewJob { callback_url: Some(format!("https://{number}.example")), ..job(number) }).await;
        store.cancel(&job(number).id, None, CancelReason::Client).await.unwrap();
    }
    let mut claimers = tokio::task::JoinSet::new();
    for _ in 0..4 {
        let store = store.clone();
        claimers.spawn(async move {
            let mut taken = Vec::new();
            while let Some(callback) = store.claim_callback(LEASE, &Busy::default()).await.unwrap() {
                store.settle_callback(&callback, Delivery::Delivered).await.unwrap();
                taken.push(callback.url);
            }
            taken
        });
    }
    let mut taken: Vec<String> = claimers.join_all().await.concat();
    let count = taken.len();
    taken.sort();
    taken.dedup();
    assert_eq!((count, taken.len()), (40, 40));
}

async fn callbacks_of_busy_owners_and_hosts_are_passed_over(database: Database) {
    let store = database.open(StoreOptions::default()).await;
    let to = |owner: &str, number: usize, url: &str| NewJob { callback_url: Some(url.into()), ..job_of(owner, number) };
    for job in [
        to("many", 1, "https://a.example/1"),
        to("many", 2, "https://b.example/2"),
        to("few", 3, "https://Dead.example:8443?x"),
        to("few", 4, "https://c.example"),
    ] {
        let id = create(&store, job).await.id;
        store.cancel(&id, None, CancelReason::Client).await.unwrap();
    }
    let busy = Busy { owners: vec![Some("many".into())], hosts: vec!["dead.example:8443".into()] };
    let only = store.claim_callback(LEASE, &busy).await.unwrap().expect("one is left");
    assert_eq!((only.id.as_str(), only.host.as_str()), (job(4).id.as_str(), "c.example"));
    assert_eq!(store.claim_callback(LEASE, &busy).await.unwrap(), None);
    let mut others = BTreeSet::new();
    while let Some(callback) = store.claim_callback(LEASE, &Busy::default()).await.unwrap() {
        others.insert(callback.id);
    }
    assert_eq!(others, BTreeSet::from([job(1).id, job(2).id, job(3).id]));
    // The owner of a server without keys has no name.
    let unnamed = NewJob { callback_url: Some("https://a.example".into()), ..job(5) };
    let id = create(&store, unnamed).await.id;
    store.cancel(&id, None, CancelReason::Client).await.unwrap();
    let busy = Busy { owners: vec![None], hosts: Vec::new() };
    assert_eq!(store.claim_callback(LEASE, &busy).await.unwrap(), None);
}

async fn a_settled_callback_has_a_log_and_can_be_sent_again(database: Database) {
    let store = database.open(StoreOptions::default()).await;
    let (none, of_me) = (Busy::default(), Some("me"));
    let id = create(&store, NewJob { callback_url: Some("https://a.example".into()), ..job_of("me", 1) }).await.id;
    let log = async || {
        let row = store.callback(Subject::Job, &id, of_me).await.unwrap().unwrap();
        assert_eq!(row.url.as_deref(), Some("https://a.example"));
        (row.next_ms.is_some(), row.attempted.iter().map(|one| (one.number, one.delivery)).collect::<Vec<_>>())
    };
    assert_eq!(log().await, (true, Vec::new()));
    store.cancel(&id, None, CancelReason::Client).await.unwrap();
    let first = store.claim_callback(LEASE, &none).await.unwrap().unwrap();
    store.put_off_callback(&first, Duration::ZERO).await.unwrap();
    let second = store.claim_callback(LEASE, &none).await.unwrap().unwrap();
    assert_eq!(second.attempts, 2);
    store.settle_callback(&second, Delivery::GivenUp).await.unwrap();
    // An attempt that is late changes nothing.
    store.settle_callback(&first, Delivery::Delivered).await.unwrap();
    assert_eq!(log().await, (false, vec![(1, Delivery::Failed), (2, Delivery::GivenUp)]));
    assert_eq!(store.claim_callback(LEASE, &none).await.unwrap(), None);
    // Another owner neither sees nor sends it.
    assert_eq!(store.callback(Subject::Job, &id, Some("you")).await.unwrap(), None);
    assert!(!store.send_callback_again(Subject::Job, &id, Some("you")).await.unwrap());
    assert!(store.send_callback_again(Subject::Job, &id, of_me).await.unwrap());
    let third = store.claim_callback(LEASE, &none).await.unwrap().unwrap();
    assert_eq!((third.attempts, third.url.as_str()), (1, "https://a.example"), "all attempts are left again");
    store.settle_callback(&third, Delivery::Delivered).await.unwrap();
    let expected = vec![(1, Delivery::Failed), (2, Delivery::GivenUp), (3, Delivery::Delivered)];
    assert_eq!(log().await, (false, expected));
    let without = create(&store, job_of("me", 2)).await.id;
    assert!(!store.send_callback_again(Subject::Job, &without, of_me).await.unwrap());
}

async fn a_claim_whose_answer_was_lost_is_found_by_its_name(database: Database) {
    let store = database.open(StoreOptions::default()).await;
    create(&store, job(1)).await;
    assert_eq!(store.claimed_by("worker/1", LEASE).await.unwrap(), None);
    let claimed = store.claim("worker/1", LEASE).await.unwrap();
    assert!(claimed.is_some());
    let found = store.claimed_by("worker/1", LEASE).await.unwrap().unwrap();
    let claimed = claimed.unwrap();
    assert_eq!((&found.id, found.attempt, &found.request), (&claimed.id, claimed.attempt, &claimed.request));
    assert_eq!(store.claimed_by("worker/2", LEASE).await.unwrap(), None);
    assert!(store.finish(&found.id, found.attempt, success(b"mesh")).await.unwrap());
    assert_eq!(store.claimed_by("worker/1", LEASE).await.unwrap(), None);
}
