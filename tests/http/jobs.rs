//! Lists of jobs, identifiers, and the links and errors of failed jobs.

use crate::app::{MINIMAL, RULED, TestApp, UNIFORM, example, problem, small_film};
use reqwest::Method;
use serde_json::{Value, json};

#[tokio::test]
async fn jobs_are_listed_newest_first_page_by_page_and_filtered() {
    let app = TestApp::start_with(&[("PLATEAU_WORKERS", "0")]).await;
    let mut ids = Vec::new();
    for k in 0..5 {
        let job: Value = app.post(MINIMAL, &small_film(0.1 + f64::from(k))).await.json().await.unwrap();
        ids.push(job["id"].as_str().unwrap().to_owned());
    }
    let strip: Value = app.post(RULED, &example("wavy-strip")).await.json().await.unwrap();
    ids.push(strip["id"].as_str().unwrap().to_owned());
    ids.reverse();
    let mut seen = Vec::new();
    let mut path = "/v1/jobs?limit=4".to_owned();
    loop {
        let page = app.get_json(&path).await;
        seen.extend(page["jobs"].as_array().unwrap().iter().map(|job| job["id"].as_str().unwrap().to_owned()));
        match page["next_cursor"].as_str() {
            Some(cursor) => path = format!("/v1/jobs?limit=4&cursor={cursor}"),
            None => break,
        }
    }
    assert_eq!(seen, ids);
    let count = async |query: &str| app.get_json(&format!("/v1/jobs?{query}")).await["jobs"].as_array().unwrap().len();
    assert_eq!(count("kind=ruled_surface").await, 1);
    assert_eq!(count("status=queued").await, 6);
    assert_eq!(count("status=succeeded").await, 0);
    assert_eq!(count("status=queued&kind=minimal_surface&limit=200").await, 5);
}

#[tokio::test]
async fn a_list_has_statistics_only_on_request() {
    let app = TestApp::start().await;
    let job = app.solve(RULED, &example("wavy-strip")).await;
    let list = app.get_json("/v1/jobs").await;
    let mut summary = job.clone();
    assert!(summary.as_object_mut().unwrap().remove("statistics").is_some());
    assert_eq!(list["jobs"], json!([summary]));
    assert_eq!(app.get_json("/v1/jobs?statistics=false").await["jobs"], json!([summary]));
    assert_eq!(app.get_json("/v1/jobs?statistics=true").await["jobs"], json!([job]));
    problem(app.get("/v1/jobs?statistics=yes").await, 400).await;
}

#[tokio::test]
async fn a_job_can_be_found_by_its_idempotency_key() {
    let app = TestApp::start_with(&[("PLATEAU_WORKERS", "0")]).await;
    let post = |key: &'static str, height: f64| {
        app.request(Method::POST, MINIMAL).header("idempotency-key", key).json(&small_film(height)).send()
    };
    let job: Value = post("a&b=c/1", 0.1).await.unwrap().json().await.unwrap();
    post("other", 0.2).await.unwrap();
    app.post(MINIMAL, &small_film(0.3)).await;
    let list = app.get_json("/v1/jobs?idempotency_key=a%26b%3Dc%2F1").await;
    let ids: Vec<&Value> = list["jobs"].as_array().unwrap().iter().map(|found| &found["id"]).collect();
    assert_eq!(ids, [&job["id"]]);
    assert_eq!(app.get_json("/v1/jobs?idempotency_key=unknown").await["jobs"], json!([]));
    problem(app.get("/v1/jobs?idempotency_key=").await, 400).await;
}

#[tokio::test]
async fn an_id_may_be_written_in_lower_case() {
    let app = TestApp::start_with(&[("PLATEAU_WORKERS", "0")]).await;
    let job: Value = app.post(MINIMAL, &small_film(0.1)).await.json().await.unwrap();
    let lower = format!("/v1/jobs/{}", job["id"].as_str().unwrap().to_lowercase());
    assert_eq!(app.get_json(&lower).await, job);
    assert_eq!(app.request(Method::DELETE, &lower).send().await.unwrap().status(), 204);
}

fn names(links: &Value) -> Vec<&str> {
    links.as_object().unwrap().keys().map(String::as_str).collect()
}

/// A job links only to resources that exist.
#[tokio::test]
async fn every_link_of_a_succeeded_job_leads_to_something() {
    let app = TestApp::start().await;
    let mut certified = small_film(0.1);
    certified["certify"] = json!({ "seconds": 0.1 });
    for (path, request, files) in [
        (MINIMAL, small_film(0.1), &["mesh"][..]),
        (MINIMAL, certified, &["certificate", "mesh"]),
        (RULED, example("wavy-strip"), &["mesh", "pattern"]),
        (RULED, example("contour-stack"), &["mesh", "pattern"]),
        (UNIFORM, example("floor-fewest-nodes"), &["mesh"]),
    ] {
        if request.get("certify").is_some() && cfg!(not(feature = "certificates")) {
            continue;
        }
        let job = app.solve(path, &request).await;
        let links: Vec<&str> =
            names(&job["links"]).into_iter().filter(|name| !["events", "request", "self"].contains(name)).collect();
        assert_eq!(links, files, "{path}");
        for name in names(&job["links"]) {
            if name == "events" {
                continue;
            }
            assert_eq!(app.get(job["links"][name].as_str().unwrap()).await.status(), 200, "{path}: {name}");
        }
        let listed = app.get_json("/v1/jobs?limit=1").await["jobs"][0].clone();
        assert_eq!(listed["links"], job["links"]);
    }
}

#[tokio::test]
async fn a_failed_job_links_to_an_explanation_and_to_no_mesh() {
    let settings = [("PLATEAU_JOBS__DEADLINE_MS", "1"), ("PLATEAU_HTTP__PUBLIC_BASE_PATH", "/plateau")];
    let app = TestApp::start_with(&settings).await;
    app.hold.at("claimed");
    let job: Value = app.post(MINIMAL, &small_film(0.1)).await.json().await.unwrap();
    assert_eq!(names(&job["links"]), ["cancel", "events", "request", "self"]);
    let job = app.ended(job).await;
    assert_eq!(
        (job["status"].as_str(), job["error"]["type"].as_str()),
        (Some("failed"), Some("/plateau/problems/deadline"))
    );
    let text = app.get(job["error"]["type"].as_str().unwrap()).await.text().await.unwrap();
    assert_eq!(text, "failed job: The deadline passed\n");
    assert_eq!(names(&job["links"]), ["events", "request", "self"]);
    let missing: Value = app.get("/plateau/nothing").await.json().await.unwrap();
    assert_eq!(missing["type"], "/plateau/problems/not-found");
    assert_eq!(app.get(missing["type"].as_str().unwrap()).await.status(), 200);
}

#[tokio::test]
async fn a_list_selects_by_label_time_and_several_states() {
    let app = TestApp::start_with(&[("PLATEAU_WORKERS", "0")]).await;
    let mut labelled = small_film(0.1);
    labelled["label"] = "roof + wall".into();
    let first: Value = app.post(MINIMAL, &labelled).await.json().await.unwrap();
    let second: Value = app.post(MINIMAL, &small_film(0.2)).await.json().await.unwrap();
    app.request(Method::POST, second["links"]["cancel"].as_str().unwrap()).send().await.unwrap();
    let ids = async |query: &str| -> Vec<String> {
        let list = app.get_json(&format!("/v1/jobs?{query}")).await;
        list["jobs"].as_array().unwrap().iter().map(|job| job["id"].as_str().unwrap().to_owned()).collect()
    };
    let (first, second) = (first["id"].as_str().unwrap(), second["id"].as_str().unwrap());
    let none: [&str; 0] = [];
    assert_eq!(ids("label=roof%20%2B%20wall").await, [first]);
    assert_eq!(ids("label=roof").await, none);
    assert_eq!(ids("status=queued,cancelled").await, [second, first]);
    assert_eq!(ids("status=cancelled").await, [second]);
    assert_eq!(ids("status=succeeded,failed").await, none);
    for before in ["2020-01-01T00:00:00Z", "2020-01-01T02:30:00.5+02:30", "2019-12-31t22:00:00-02:00"] {
        assert_eq!(ids(&format!("created_after={before}")).await, [second, first], "{before}");
    }
    assert_eq!(ids("created_after=2999-01-01T00:00:00Z").await, none);
    let now = humantime::format_rfc3339_millis(std::time::SystemTime::now());
    assert_eq!(ids(&format!("created_after={now}")).await, none);
    for wrong in [
        "status=",
        "status=queued,done",
        "batch=1",
        "created_after=yesterday",
        "created_after=",
        "created_after=2020-01-01",
        "created_after=2020-01-01T00:00:00",
        "created_after=Bsh\u{e7}\u{3223c}",
        "created_after=2020-01-01T00:00:00\u{e7}00:0",
        "label=a&label=b",
        "owner=me",
    ] {
        problem(app.get(&format!("/v1/jobs?{wrong}")).await, 400).await;
    }
}

#[tokio::test]
async fn a_cancelled_job_says_why_and_links_to_its_successor() {
    let app = TestApp::start_with(&[("PLATEAU_WORKERS", "0")]).await;
    let in_series = |height: f64| {
        let mut film = small_film(height);
        film["supersede"] = "drag".into();
        film
    };
    let old: Value = app.post(MINIMAL, &in_series(0.1)).await.json().await.unwrap();
    let new: Value = app.post(MINIMAL, &in_series(0.2)).await.json().await.unwrap();
    assert_eq!((&old["cancelled_because"], &new["cancelled_because"]), (&Value::Null, &Value::Null));
    let old = app.get_json(old["links"]["self"].as_str().unwrap()).await;
    assert_eq!((&old["status"], &old["cancelled_because"]), (&json!("cancelled"), &json!("superseded")));
    assert_eq!(old["links"]["successor"], new["links"]["self"]);
    assert_eq!(names(&old["links"]), ["events", "request", "self", "successor"]);
    let cancel = app.request(Method::POST, new["links"]["cancel"].as_str().unwrap()).send().await.unwrap();
    assert_eq!(cancel.json::<Value>().await.unwrap()["cancelled_because"], "client");
    let listed = app.get_json("/v1/jobs").await;
    let reasons: Vec<_> = listed["jobs"].as_array().unwrap().iter().map(|job| &job["cancelled_because"]).collect();
    assert_eq!(reasons, ["client", "superseded"]);
}

/// A process of a newer version on the same database may have accepted a kind that this version does not know.
#[tokio::test]
async fn a_job_of_a_newer_kind_is_shown_and_waits_for_a_newer_worker() {
    let app = TestApp::start_with(&[("PLATEAU_WORKERS", "0"), ("PLATEAU_HTTP__SHUTDOWN_GRACE_MS", "0")]).await;
    let batch: Value =
        app.post("/v1/batches", &json!({ "requests": [example("two-rails")] })).await.json().await.unwrap();
    let job = batch["jobs"][0].clone();
    let (_, folder) = app.stop().await;
    let database = folder.path().join("data/plateau.sqlite");
    let change = |text: &str| rusqlite::Connection::open(&database).unwrap().execute_batch(text).unwrap();
    change("UPDATE jobs SET kind = 'soap_foam'");
    let app = TestApp::start_in(folder, &[("PLATEAU_WORKERS", "1"), ("PLATEAU_JOBS__UNREAD_S", "3")]).await;
    let this = job["links"]["self"].as_str().unwrap();
    let shown = app.get_json(this).await;
    assert_eq!((&shown["kind"], &shown["status"]), (&json!("soap_foam"), &json!("queued")));
    assert_eq!(app.get_json("/v1/jobs").await["jobs"][0]["kind"], "soap_foam");
    let of_batch = app.get_json(batch["links"]["self"].as_str().unwrap()).await;
    assert_eq!(of_batch["jobs"][0]["kind"], "soap_foam");
    problem(app.get(&format!("{this}/mesh")).await, 409).await;
    assert_eq!(app.get_json(&format!("{this}/request")).await["kind"], "soap_foam");
    // Other jobs are solved meanwhile. No worker of another version comes, so the job fails.
    app.solve(MINIMAL, &small_film(0.1)).await;
    let failed = app.ended(shown).await;
    assert_eq!(failed["error"]["type"], "/problems/refused");
    assert!(failed["started_at"].is_null(), "{failed:#}");
}

#[tokio::test]
async fn a_job_beyond_the_limits_of_a_worker_waits_for_another_worker() {
    let folder = tempfile::tempdir().unwrap();
    let url = format!("sqlite://{}/shared.sqlite", folder.path().display());
    let app = TestApp::start_with(&[("PLATEAU_WORKERS", "0"), ("PLATEAU_DATABASE", &url)]).await;
    let job: Value = app.post(MINIMAL, &small_film(0.1)).await.json().await.unwrap();
    app.stop().await;
    let lower = [("PLATEAU_WORKERS", "1"), ("PLATEAU_DATABASE", &*url), ("PLATEAU_LIMITS__TRIANGLES", "50")];
    let app = TestApp::start_with(&lower).await;
    app.solve(RULED, &example("two-rails")).await;
    let waiting = app.get_json(job["links"]["self"].as_str().unwrap()).await;
    assert_eq!((&waiting["status"], &waiting["error"]), (&json!("queued"), &Value::Null));
    app.stop().await;
    let app = TestApp::start_with(&[("PLATEAU_WORKERS", "1"), ("PLATEAU_DATABASE", &url)]).await;
    assert_eq!(app.ended(job).await["status"], "succeeded");
}
