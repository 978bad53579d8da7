//! Batches: many requests at once, with one status and one file.

use crate::app::{TestApp, example, pointers, problem, root, small_film};
use crate::skips::skipped;
use reqwest::{Method, StatusCode};
use serde_json::{Value, json};
use std::process::Command;

const BATCHES: &str = "/v1/batches";

fn film(height: f64) -> Value {
    let mut film = small_film(height);
    film["kind"] = "minimal_surface".into();
    film
}

/// Returns a batch with requests of three kinds.
fn mixed() -> Value {
    json!({ "requests": [film(0.3), example("wavy-strip"), example("courtyard"), film(0.5)] })
}

async fn solved(app: &TestApp, body: &Value) -> Value {
    let response = app.post_waiting(BATCHES, body).await;
    let (status, batch) = (response.status(), response.json::<Value>().await.unwrap());
    assert_eq!((status, batch["status"].as_str()), (StatusCode::OK, Some("succeeded")), "{batch:#}");
    batch
}

#[tokio::test]
async fn a_batch_has_ordinary_jobs_and_one_status() {
    let app = TestApp::start().await;
    let response = app.post(BATCHES, &mixed()).await;
    assert_eq!(response.status(), StatusCode::ACCEPTED);
    let location = response.headers()["location"].to_str().unwrap().to_owned();
    let batch: Value = response.json().await.unwrap();
    assert_eq!(batch["links"]["self"], location.as_str());
    let ended: Value =
        app.request(Method::GET, &location).header("prefer", "wait=60").send().await.unwrap().json().await.unwrap();
    assert_eq!(
        (ended["status"].as_str(), ended["counts"]["succeeded"].as_u64()),
        (Some("succeeded"), Some(4)),
        "{ended:#}"
    );
    assert!(ended["finished_at"].as_str() >= ended["created_at"].as_str());
    for (index, job) in ended["jobs"].as_array().unwrap().iter().enumerate() {
        assert_eq!(job["index"], index);
        let whole = app.get_json(job["links"]["self"].as_str().unwrap()).await;
        assert_eq!((&whole["id"], &whole["kind"], &whole["status"]), (&job["id"], &job["kind"], &job["status"]));
    }
    // The jobs of a batch are listed like any other job.
    assert_eq!(app.get_json("/v1/jobs").await["jobs"].as_array().unwrap().len(), 4);
    assert_eq!(app.request(Method::DELETE, &location).send().await.unwrap().status(), StatusCode::NO_CONTENT);
    problem(app.get(&location).await, 404).await;
    assert_eq!(app.get_json("/v1/jobs").await["jobs"].as_array().unwrap().len(), 0);
}

#[tokio::test]
async fn the_meshes_come_as_one_archive() {
    let app = TestApp::start().await;
    let batch = solved(&app, &mixed()).await;
    let meshes = batch["links"]["meshes"].as_str().unwrap();
    let response = app.get(meshes).await;
    assert_eq!(response.headers()["content-type"], "application/zip");
    let tag = response.headers()["etag"].clone();
    let bytes = response.bytes().await.unwrap();
    let unchanged = app.request(Method::GET, meshes).header("if-none-match", &tag).send().await.unwrap();
    assert_eq!((unchanged.status(), &unchanged.headers()["etag"]), (StatusCode::NOT_MODIFIED, &tag));
    assert_eq!(app.get(meshes).await.bytes().await.unwrap(), bytes);

    // The archive is read by an independent implementation.
    let folder = tempfile::tempdir().unwrap();
    let path = folder.path().join("batch.zip");
    std::fs::write(&path, &bytes).unwrap();
    let script = "import sys, zipfile; z = zipfile.ZipFile(sys.argv[1]); assert z.testzip() is None; \
                  z.extractall(sys.argv[2]); print('\\n'.join(z.namelist()))";
    let output = Command::new("python3").args(["-c", script]).arg(&path).arg(folder.path()).output().expect("python3");
    assert!(output.status.success(), "{}", String::from_utf8_lossy(&output.stderr));
    let names = String::from_utf8(output.stdout).unwrap();
    let expected = [
        "0000-minimal_surface.glb",
        "0001-ruled_surface.glb",
        "0002-uniform_mesh.glb",
        "0003-minimal_surface.glb",
        "batch.json",
    ];
    assert_eq!(names.lines().collect::<Vec<_>>(), expected);
    let listing: Value = serde_json::from_slice(&std::fs::read(folder.path().join("batch.json")).unwrap()).unwrap();
    for (job, listed) in batch["jobs"].as_array().unwrap().iter().zip(listing["jobs"].as_array().unwrap()) {
        let file = std::fs::read(folder.path().join(listed["file"].as_str().unwrap())).unwrap();
        assert_eq!(app.get(job["links"]["mesh"].as_str().unwrap()).await.bytes().await.unwrap(), file);
        assert_eq!(listed["statistics"], app.get_json(job["links"]["self"].as_str().unwrap()).await["statistics"]);
    }
    let ply = app.get(&format!("{meshes}?mesh_format=ply")).await;
    assert_ne!(ply.headers()["etag"], tag);
    let ply = ply.bytes().await.unwrap();
    assert!(ply.windows(16).any(|window| window == b"0001-ruled_surfa"));
    problem(app.get(&format!("{meshes}?mesh_format=iges")).await, 400).await;
}

#[tokio::test]
async fn the_meshes_come_as_one_scene() {
    let app = TestApp::start().await;
    let batch = solved(&app, &mixed()).await;
    let response = app.get(&format!("{}?format=glb", batch["links"]["meshes"].as_str().unwrap())).await;
    assert_eq!(response.headers()["content-type"], "model/gltf-binary");
    let bytes = response.bytes().await.unwrap();
    let length = u32::from_le_bytes(bytes[12..16].try_into().unwrap()) as usize;
    let document: Value = serde_json::from_slice(&bytes[20..20 + length]).unwrap();
    let roots = document["scenes"][0]["nodes"].as_array().unwrap();
    assert_eq!(roots.len(), 4);
    for (root, job) in roots.iter().zip(batch["jobs"].as_array().unwrap()) {
        let node = &document["nodes"][root.as_u64().unwrap() as usize];
        let expected = format!("{:04}-{}", job["index"].as_u64().unwrap(), job["kind"].as_str().unwrap());
        assert_eq!(node["name"], expected);
        let whole = app.get_json(job["links"]["self"].as_str().unwrap()).await;
        assert_eq!(node["extras"]["statistics"]["area"], whole["statistics"]["area"]);
        let surface = &document["nodes"][node["children"][0].as_u64().unwrap() as usize];
        let primitive = &document["meshes"][surface["mesh"].as_u64().unwrap() as usize]["primitives"][0];
        let indices = &document["accessors"][primitive["indices"].as_u64().unwrap() as usize];
        assert_eq!(indices["count"].as_u64().unwrap(), 3 * whole["statistics"]["triangles"].as_u64().unwrap());
    }
    if !root().join("scripts/node_modules/gltf-validator").exists() {
        skipped("Khronos validator of a batch", "npm has not installed gltf-validator in scripts");
        return;
    }
    let folder = tempfile::tempdir().unwrap();
    let path = folder.path().join("batch.glb");
    std::fs::write(&path, &bytes).unwrap();
    let output =
        Command::new("node").arg(root().join("scripts/validate-gltf.mjs")).arg(&path).output().expect("node runs");
    assert!(
        output.status.success(),
        "{}{}",
        String::from_utf8_lossy(&output.stdout),
        String::from_utf8_lossy(&output.stderr)
    );
}

#[tokio::test]
async fn all_requests_of_a_batch_are_accepted_or_none() {
    let app = TestApp::start_with(&[("PLATEAU_WORKERS", "0"), ("PLATEAU_JOBS__QUEUE_LENGTH", "3")]).await;
    let mut wrong = film(0.1);
    wrong["boundaries"][0][1][2] = "x".into();
    let refused = problem(app.post(BATCHES, &json!({ "requests": [film(0.1), wrong] })).await, 422).await;
    assert_eq!(pointers(&refused), ["/requests/1/boundaries/0/1/2"]);
    problem(app.post(BATCHES, &json!({ "requests": [film(0.1), film(0.2), film(0.3), film(0.4)] })).await, 429).await;
    assert_eq!(app.get_json("/v1/jobs").await["jobs"].as_array().unwrap().len(), 0);
    assert_eq!(app.post(BATCHES, &json!({ "requests": [film(0.1), film(0.2), film(0.3)] })).await.status(), 202);
}

#[tokio::test]
async fn cancelling_a_batch_cancels_all_its_jobs() {
    let app = TestApp::start_with(&[("PLATEAU_WORKERS", "1")]).await;
    app.hold.at("claimed.ruled_surface");
    let strip = example("two-rails");
    let batch: Value =
        app.post(BATCHES, &json!({ "requests": [strip, film(0.1), film(0.2)] })).await.json().await.unwrap();
    let meshes = format!("{}/meshes", batch["links"]["self"].as_str().unwrap());
    problem(app.get(&meshes).await, 409).await;
    let cancel = batch["links"]["cancel"].as_str().unwrap();
    let cancelled: Value = app.request(Method::POST, cancel).send().await.unwrap().json().await.unwrap();
    assert_eq!((cancelled["status"].as_str(), cancelled["counts"]["cancelled"].as_u64()), (Some("cancelled"), Some(3)));
    let links: Vec<&String> = cancelled["links"].as_object().unwrap().keys().collect();
    assert_eq!(links, ["self"]);
    problem(app.get(&meshes).await, 409).await;
    // The worker takes other jobs at once.
    app.solve("/v1/minimal-surfaces", &small_film(0.9)).await;
}

#[tokio::test]
async fn the_same_key_and_body_give_the_same_batch() {
    let app = TestApp::start().await;
    let post = async |body: Value| {
        app.request(Method::POST, BATCHES).header("idempotency-key", "k").json(&body).send().await.unwrap()
    };
    let first: Value = post(json!({ "requests": [film(0.1)] })).await.json().await.unwrap();
    let again: Value = post(json!({ "requests": [film(0.1)] })).await.json().await.unwrap();
    assert_eq!(first["id"], again["id"]);
    problem(post(json!({ "requests": [film(0.2)] })).await, 422).await;
}

#[tokio::test]
async fn the_error_for_a_missing_batch_names_a_batch() {
    let app = TestApp::start().await;
    for path in ["/v1/batches/01J00000000000000000000000", "/v1/batches/none"] {
        assert_eq!(problem(app.get(path).await, 404).await["detail"], "no such batch");
        let removal = app.request(Method::DELETE, path).send().await.unwrap();
        assert_eq!(problem(removal, 404).await["detail"], "no such batch");
    }
}
