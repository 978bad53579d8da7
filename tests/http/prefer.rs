//! `Prefer: wait` on POST and GET.

use crate::app::{MINIMAL, TestApp, problem, small_film};
use reqwest::Method;
use serde_json::{Value, json};

#[tokio::test]
async fn a_request_without_a_wait_is_answered_with_202() {
    let app = TestApp::start().await;
    let response = app.post(MINIMAL, &small_film(0.4)).await;
    assert_eq!(response.status(), 202);
    assert!(response.headers().contains_key("retry-after"));
    assert!(!response.headers().contains_key("preference-applied"));
    let location = response.headers()["location"].to_str().unwrap().to_owned();
    let job: Value = response.json().await.unwrap();
    assert_eq!(job["links"]["self"], location.as_str());
    let waited = app.request(Method::GET, &location).header("prefer", "wait=60").send().await.unwrap();
    assert_eq!(waited.headers()["preference-applied"], "wait=60");
    let job: Value = waited.json().await.unwrap();
    assert_eq!((job["status"].as_str(), job["progress"]["fraction"].as_f64()), (Some("succeeded"), Some(1.0)));
    for field in ["created_at", "started_at", "finished_at", "expires_at"] {
        assert!(job[field].as_str().unwrap().ends_with('Z'), "{field}");
    }
}

#[tokio::test]
async fn a_wait_that_ends_before_the_job_is_answered_with_202() {
    let app = TestApp::start().await;
    app.hold.at("claimed");
    let request = app.request(Method::POST, MINIMAL).header("prefer", "wait=0").json(&small_film(0.1));
    let response = request.send().await.unwrap();
    assert_eq!(
        (response.status().as_u16(), response.headers()["preference-applied"].to_str().unwrap()),
        (202, "wait=0")
    );
}

#[tokio::test]
async fn a_wait_beyond_the_servers_limit_is_cut_and_an_invalid_one_is_ignored() {
    let app = TestApp::start_with(&[("PLATEAU_HTTP__WAIT_MAX_S", "5")]).await;
    let post = |preference: &'static str, height: f64| {
        app.request(Method::POST, MINIMAL).header("prefer", preference).json(&small_film(height)).send()
    };
    let response = post("wait=100000", 0.5).await.unwrap();
    assert_eq!(
        (response.status().as_u16(), response.headers()["preference-applied"].to_str().unwrap()),
        (200, "wait=5")
    );
    let response = post("wait=soon", 0.6).await.unwrap();
    assert_eq!(response.status(), 202);
    assert!(!response.headers().contains_key("preference-applied"));
}

#[tokio::test]
async fn a_wait_that_accepts_a_mesh_gets_the_mesh_itself() {
    let app = TestApp::start().await;
    let post = async |request: &Value, wait: Option<&str>, accept: &str| {
        let post = app.request(Method::POST, MINIMAL).header("accept", accept).json(request);
        wait.into_iter().fold(post, |post, wait| post.header("prefer", wait)).send().await.unwrap()
    };
    let film = small_film(0.31);
    let response = post(&film, Some("wait=60"), "model/gltf-binary").await;
    assert_eq!(
        (response.status().as_u16(), &response.headers()["content-type"]),
        (200, &"model/gltf-binary".parse().unwrap())
    );
    let this = response.headers()["location"].to_str().unwrap().to_owned();
    assert_eq!(response.headers()["link"], format!("<{this}>; rel=\"describedby\""));
    assert_eq!(
        (&response.headers()["vary"], response.headers().contains_key("etag")),
        (&"Accept".parse().unwrap(), true)
    );
    let bytes = response.bytes().await.unwrap();
    assert!(bytes == app.get(&format!("{this}/mesh")).await.bytes().await.unwrap() && bytes.starts_with(b"glTF"));
    let ply = post(&film, Some("wait=60"), "application/x-ply, application/json;q=0.5").await;
    assert!(ply.bytes().await.unwrap().starts_with(b"ply\n"));
    // Other clients get the job: those that accept anything, those that do not wait, and those whose wait is over.
    for (request, wait, accept, status) in [
        (&film, Some("wait=60"), "*/*", 200),
        (&film, Some("wait=60"), "application/json, model/gltf-binary", 200),
        (&film, None, "model/gltf-binary", 202),
        (&small_film(0.32), Some("wait=1"), "model/gltf-binary", 202),
    ] {
        if wait == Some("wait=1") {
            app.hold.at("claimed");
        }
        let response = post(request, wait, accept).await;
        assert_eq!(
            (response.status().as_u16(), &response.headers()["content-type"]),
            (status, &"application/json".parse().unwrap())
        );
    }
    app.hold.release("claimed");
    // The outline crosses itself in the plane, which only the solver finds out.
    let mut tangled = small_film(0.33);
    tangled["boundaries"] = json!([[[0, 0, 0], [1, 1, 0], [1, 0, 0], [0, 1, 0]]]);
    tangled["initial_mesh"] = "planar".into();
    let answer = post(&tangled, Some("wait=60"), "model/gltf-binary").await;
    let job = app.get_json(answer.headers()["location"].to_str().unwrap()).await;
    let refused = problem(answer, 409).await;
    assert_eq!((&refused["type"], &job["status"]), (&job["error"]["type"], &json!("failed")));
}
