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

/// A job links only to files that exist, or that will exist once it has succeeded.
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
        let job = app.solve(path, &request).await;
        let links: Vec<&str> =
            names(&job["links"]).into_iter().filter(|name| !["cancel", "events", "self"].contains(name)).collect();
        assert_eq!(links, files, "{path}");
        for name in files {
            assert_eq!(app.get(job["links"][*name].as_str().unwrap()).await.status(), 200, "{path}: {name}");
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
    assert_eq!(names(&job["links"]), ["cancel", "events", "mesh", "self"]);
    let job = app.ended(job).await;
    assert_eq!(
        (job["status"].as_str(), job["error"]["type"].as_str()),
        (Some("failed"), Some("/plateau/problems/deadline"))
    );
    let text = app.get(job["error"]["type"].as_str().unwrap()).await.text().await.unwrap();
    assert_eq!(text, "failed job: The deadline passed\n");
    assert_eq!(names(&job["links"]), ["cancel", "events", "self"]);
    let missing: Value = app.get("/plateau/nothing").await.json().await.unwrap();
    assert_eq!(missing["type"], "/plateau/problems/not-found");
    assert_eq!(app.get(missing["type"].as_str().unwrap()).await.status(), 200);
}
