//! Requests that begin with the result of a finished job, shown on the kind `enlargement`, which only builds for tests
//! have. Only its folder and its lines in the table of kinds name it.

use crate::app::{MINIMAL, TestApp, binary, pointers, problem, small_film};
use crate::hold::until;
use reqwest::{Method, StatusCode};
use serde_json::{Value, json};

pub const ENLARGEMENTS: &str = "/v1/enlargements";

pub fn enlargement(job: &Value, factor: f64) -> Value {
    json!({ "kind": "enlargement", "source": { "job": job["id"] }, "factor": factor })
}

async fn vertices(app: &TestApp, job: &Value) -> Vec<[f64; 3]> {
    let mesh = app.get_json(&format!("{}?format=json", job["links"]["mesh"].as_str().expect("a mesh"))).await;
    serde_json::from_value(mesh["vertices"].clone()).expect("points")
}

#[tokio::test]
async fn the_document_the_catalogue_and_lists_have_a_kind_that_only_the_table_names() {
    let app = TestApp::start().await;
    let document = app.get_json("/openapi.json").await;
    let post = &document["paths"][ENLARGEMENTS]["post"];
    assert_eq!(post["operationId"], "postEnlargement");
    assert!(post["responses"]["404"].is_object() && post["responses"]["410"].is_object());
    let schemas = &document["components"]["schemas"];
    assert_eq!(schemas["EnlargementRequest"]["required"], json!(["source"]));
    let names = schemas["Kind"]["enum"].as_array().expect("names");
    assert!(names.contains(&"enlargement".into()));
    for union in ["RequestWithKind", "Job"] {
        assert!(schemas[union]["discriminator"]["mapping"]["enlargement"].is_string(), "{union}");
    }
    let objectives = app.get_json("/v1/objectives").await;
    let of_kind = |objective: &&Value| objective["kind"] == "enlargement";
    assert_eq!(objectives["objectives"].as_array().expect("a list").iter().filter(of_kind).count(), 1);

    let film = app.solve(MINIMAL, &small_film(0.3)).await;
    let job = app.solve(ENLARGEMENTS, &enlargement(&film, 3.0)).await;
    let listed = app.get_json("/v1/jobs?kind=enlargement").await;
    assert_eq!(listed["jobs"].as_array().expect("a list").len(), 1);
    assert_eq!(listed["jobs"][0]["id"], job["id"]);
}

#[tokio::test]
async fn a_request_begins_with_the_mesh_and_the_statistics_of_its_source() {
    let app = TestApp::start().await;
    let (film, other) = (app.solve(MINIMAL, &small_film(0.3)).await, app.solve(MINIMAL, &small_film(0.4)).await);
    let job = app.solve(ENLARGEMENTS, &enlargement(&film, 3.0)).await;
    let given: Vec<[f64; 3]> = vertices(&app, &film).await.iter().map(|vertex| vertex.map(|part| 3.0 * part)).collect();
    assert_eq!(vertices(&app, &job).await, given);
    let area = |job: &Value| job["statistics"]["area"].as_f64().expect("an area");
    assert_eq!(area(&job), 9.0 * area(&film));

    // A repeated request reuses the result, and a request with another source has another result.
    let repeated: Value = app.post(ENLARGEMENTS, &enlargement(&film, 3.0)).await.json().await.expect("JSON");
    assert_eq!((&repeated["status"], &repeated["statistics"]), (&"succeeded".into(), &job["statistics"]));
    let from_other = app.solve(ENLARGEMENTS, &enlargement(&other, 3.0)).await;
    assert_eq!(area(&from_other), 9.0 * area(&other));
    // An enlargement is a finished job too.
    let twice = app.solve(ENLARGEMENTS, &enlargement(&job, 0.5)).await;
    assert_eq!(area(&twice), 0.25 * area(&job));
}

#[tokio::test]
async fn a_job_that_waits_keeps_the_result_from_which_it_begins() {
    let app = TestApp::start_with(&[("PLATEAU_WORKERS", "1")]).await;
    let film = app.solve(MINIMAL, &small_film(0.3)).await;
    app.hold.at("claimed.minimal_surface");
    let busy: Value = app.post(MINIMAL, &small_film(0.5)).await.json().await.expect("JSON");
    app.hold.reached("claimed", busy["id"].as_str().expect("an identifier")).await;
    let waiting: Value = app.post(ENLARGEMENTS, &enlargement(&film, 2.0)).await.json().await.expect("JSON");
    assert_eq!(waiting["status"], "queued");
    let this = film["links"]["self"].as_str().expect("a link");
    assert_eq!(app.request(Method::DELETE, this).send().await.expect("an answer").status(), StatusCode::NO_CONTENT);
    app.hold.release("claimed.minimal_surface");
    let job = app.ended(waiting).await;
    assert_eq!(job["status"], "succeeded", "{job:#}");
    assert_eq!(job["statistics"]["area"].as_f64(), film["statistics"]["area"].as_f64().map(|area| 4.0 * area));
    // The deleted job cannot be the source of a further request.
    let refused = problem(app.post(ENLARGEMENTS, &enlargement(&film, 2.0)).await, 404).await;
    assert_eq!(pointers(&refused), ["/source/job"]);
}

#[tokio::test]
async fn a_source_that_has_expired_is_410_and_a_repetition_is_answered_all_the_same() {
    let app = TestApp::start().await;
    let film = app.solve(MINIMAL, &small_film(0.3)).await;
    let keyed = async |app: &TestApp, factor: f64| {
        let request = app.request(Method::POST, ENLARGEMENTS).json(&enlargement(&film, factor));
        request.header("idempotency-key", "once").header("prefer", "wait=60").send().await.expect("an answer")
    };
    let job: Value = keyed(&app, 2.0).await.json().await.expect("JSON");
    assert_eq!(job["status"], "succeeded", "{job:#}");
    // A server deletes surplus jobs when it starts. With a limit of one job the film expires, because it is the older
    // of the two.
    let (_, folder) = app.stop().await;
    let app = TestApp::start_in(folder, &[("PLATEAU_STORE__MAX_JOBS", "1")]).await;
    let this = film["links"]["self"].as_str().expect("a link");
    until("the film expires", async || app.get(this).await.status() == StatusCode::GONE).await;
    let refused = problem(app.post(ENLARGEMENTS, &enlargement(&film, 2.0)).await, 410).await;
    assert_eq!(pointers(&refused), ["/source/job"]);
    let again: Value = keyed(&app, 2.0).await.json().await.expect("JSON");
    assert_eq!(again["id"], job["id"]);
    problem(keyed(&app, 3.0).await, 422).await;
}

#[tokio::test]
async fn a_source_that_is_missing_or_has_not_ended_is_named() {
    let app = TestApp::start().await;
    for id in ["01J00000000000000000000000", "", "x'; --"] {
        let refused = problem(app.post(ENLARGEMENTS, &enlargement(&json!({ "id": id }), 2.0)).await, 404).await;
        assert_eq!(pointers(&refused), ["/source/job"]);
    }
    app.hold.at("claimed.minimal_surface");
    let film: Value = app.post(MINIMAL, &small_film(0.3)).await.json().await.expect("JSON");
    let request = enlargement(&film, 2.0);
    let refused = problem(app.post(ENLARGEMENTS, &request).await, 409).await;
    assert_eq!(pointers(&refused), ["/source/job"]);
    assert!(refused["errors"][0]["detail"].as_str().expect("a text").contains("must be of one that has succeeded"));
    // The schema is checked before the source is read, and the pointer of an error in a batch names the request.
    let wrong = json!({ "source": { "job": 7 }, "factor": 0 });
    let refused = problem(app.post(ENLARGEMENTS, &wrong).await, 422).await;
    assert_eq!(pointers(&refused), ["/factor", "/source/job"]);
    let mut other = small_film(0.2);
    other["kind"] = "minimal_surface".into();
    let refused = app.post("/v1/batches", &json!({ "requests": [other, request] })).await;
    assert_eq!(pointers(&problem(refused, 422).await), ["/requests/1/source/job"]);

    app.hold.release("claimed.minimal_surface");
    let film = app.ended(film).await;
    let requests = json!({ "requests": [other, enlargement(&film, 2.0), enlargement(&film, 3.0)] });
    let batch: Value = app.post_waiting("/v1/batches", &requests).await.json().await.expect("JSON");
    assert_eq!((&batch["status"], &batch["counts"]["succeeded"]), (&"succeeded".into(), &3.into()), "{batch:#}");
}

#[tokio::test]
async fn without_a_server_a_source_is_refused_at_its_pointer() {
    let folder = tempfile::tempdir().expect("a temporary folder");
    let file = folder.path().join("request.json");
    let request = enlargement(&json!({ "id": "01J00000000000000000000000" }), 2.0);
    std::fs::write(&file, request.to_string()).expect("the request is written");
    let output = binary().arg("solve").arg(&file).arg("-o").arg(folder.path().join("out.glb")).output().await;
    let output = output.expect("the program runs");
    assert!(!output.status.success());
    let text = String::from_utf8_lossy(&output.stderr);
    assert!(text.contains("/source/job: names a job, and there are jobs only on a server"), "{text}");
}
