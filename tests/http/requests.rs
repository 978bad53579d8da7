//! `GET /v1/jobs/{id}/request`: requests are kept as long as their jobs.

use crate::app::{MINIMAL, RULED, TestApp, example, example_names, path_of, problem, small_film};
use reqwest::{Method, StatusCode};
use serde_json::{Value, json};

async fn request_of(app: &TestApp, job: &Value) -> Value {
    app.get_json(job["links"]["request"].as_str().expect("a link")).await
}

/// The request of a job is accepted again, and it means the same.
#[tokio::test]
async fn the_request_of_a_job_is_the_one_that_was_accepted() {
    let app = TestApp::start_with(&[("PLATEAU_WORKERS", "0")]).await;
    for name in example_names() {
        let example = example(&name);
        let kind = example["kind"].as_str().expect("a kind").to_owned();
        let mut without_kind = example.clone();
        without_kind.as_object_mut().expect("an object").remove("kind");
        without_kind["label"] = "mine".into();
        let mut kept = Vec::new();
        for request in [example, without_kind] {
            let job: Value = app.post(path_of(&kind), &request).await.json().await.expect("JSON");
            let found = request_of(&app, &job).await;
            assert_eq!(found["kind"], kind.as_str(), "{name}");
            assert!(found.get("label").is_none(), "{name}");
            let again = app.post(path_of(&kind), &found).await;
            assert_eq!(again.status(), StatusCode::ACCEPTED, "{name}");
            let again: Value = again.json().await.expect("JSON");
            assert_eq!(request_of(&app, &again).await, found, "{name}");
            kept.push(found);
        }
        assert_eq!(kept[0], kept[1], "{name}");
    }
}

#[tokio::test]
async fn a_request_is_kept_until_its_job_is_removed_however_the_job_ended() {
    let app = TestApp::start_with(&[("PLATEAU_JOBS__DEADLINE_MS", "1000")]).await;
    let solved = app.solve(RULED, &example("two-rails")).await;
    let shared = app.solve(RULED, &example("two-rails")).await;
    app.hold.at("claimed");
    let waiting: Value = app.post(MINIMAL, &small_film(0.1)).await.json().await.unwrap();
    let cancelled: Value = app.post(MINIMAL, &small_film(0.2)).await.json().await.unwrap();
    let cancel = cancelled["links"]["cancel"].as_str().unwrap();
    assert_eq!(app.request(Method::POST, cancel).send().await.unwrap().status(), 200);
    let failed = app.ended(waiting).await;
    assert_eq!(failed["error"]["type"], "/problems/deadline");
    for (job, field) in [(&solved, "directrices"), (&shared, "directrices"), (&failed, "boundaries")] {
        assert!(request_of(&app, job).await[field].is_array());
    }
    assert_eq!(request_of(&app, &cancelled).await["boundaries"][0][1], json!([1.0, 0.0, 0.2]));

    let link = failed["links"]["request"].as_str().unwrap().to_owned();
    let response = app.get(&link).await;
    assert_eq!(response.headers()["content-type"], "application/json");
    let name = format!("attachment; filename=\"{}.request.json\"", failed["id"].as_str().unwrap());
    assert_eq!(response.headers()["content-disposition"], name.as_str());
    let tag = response.headers()["etag"].clone();
    let unchanged = app.request(Method::GET, &link).header("if-none-match", tag).send().await.unwrap();
    assert_eq!(unchanged.status(), StatusCode::NOT_MODIFIED);
    problem(app.request(Method::GET, &link).header("accept", "text/html").send().await.unwrap(), 406).await;
    problem(app.get(&format!("{link}?format=json")).await, 400).await;
    let this = failed["links"]["self"].as_str().unwrap();
    assert_eq!(app.request(Method::DELETE, this).send().await.unwrap().status(), 204);
    problem(app.get(&link).await, 404).await;
    problem(app.get("/v1/jobs/00000000000000000000000000/request").await, 404).await;
}

#[tokio::test]
async fn a_batch_links_to_the_requests_of_its_jobs_and_they_link_to_the_batch() {
    let app = TestApp::start_with(&[("PLATEAU_WORKERS", "0")]).await;
    let strip = example("two-rails");
    let body = json!({ "requests": [strip, strip], "callback_url": null });
    let posted = app.request(Method::POST, "/v1/batches").header("idempotency-key", "one").json(&body);
    let batch: Value = posted.send().await.unwrap().json().await.unwrap();
    assert!(batch["links"].get("meshes").is_none() && batch["links"]["cancel"].is_string(), "{}", batch["links"]);
    let id = batch["id"].as_str().unwrap();
    let listed = app.get_json(&format!("/v1/jobs?batch={}", id.to_lowercase())).await;
    assert_eq!(listed["jobs"].as_array().unwrap().len(), 2);
    for job in batch["jobs"].as_array().unwrap() {
        assert!(request_of(&app, job).await["directrices"].is_array());
        assert_eq!(job["links"]["batch"], batch["links"]["self"]);
        assert_eq!(app.get_json(job["links"]["self"].as_str().unwrap()).await["links"], job["links"]);
    }
    // The same requests with members in another order are the same batch, and another request is not.
    let text = format!(r#"{{"requests":[{strip},{}]}}"#, serde_json::to_string_pretty(&strip).unwrap());
    let send = async |text: String| {
        let post = app.request(Method::POST, "/v1/batches").header("idempotency-key", "one");
        post.header("content-type", "application/json").body(text).send().await.unwrap()
    };
    assert_eq!(send(text).await.json::<Value>().await.unwrap()["id"], batch["id"]);
    problem(send(json!({ "requests": [strip] }).to_string()).await, 422).await;
}
