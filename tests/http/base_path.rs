//! Operation behind a proxy. Every address that the server sends begins with the public base path, whether or not the
//! proxy removes it from requests.

use crate::app::{MINIMAL, TestApp, client_builder, is_built, problem, small_film};
use reqwest::{Method, StatusCode, redirect};
use serde_json::Value;

#[tokio::test]
async fn every_address_begins_with_the_base_path_and_works_with_and_without_it() {
    let app = TestApp::start_with(&[("PLATEAU_HTTP__PUBLIC_BASE_PATH", "/tools/plateau")]).await;
    for kept in ["", "/tools/plateau"] {
        let response = app.post_waiting(&format!("{kept}{MINIMAL}"), &small_film(0.4)).await;
        assert_eq!(response.status(), StatusCode::OK);
        let location = response.headers()["location"].to_str().unwrap().to_owned();
        let job: Value = response.json().await.unwrap();
        assert_eq!(location, job["links"]["self"].as_str().unwrap());
        let taken_off = location.strip_prefix("/tools/plateau").expect("the base path");
        assert!(taken_off.starts_with("/v1/jobs/"));
        for path in [location.as_str(), taken_off] {
            assert_eq!(app.get_json(path).await, job);
        }
        for link in job["links"].as_object().unwrap().values() {
            assert!(link.as_str().unwrap().starts_with("/tools/plateau/v1/jobs/"), "{link}");
        }
        let events = app.get(job["links"]["events"].as_str().unwrap()).await.text().await.unwrap();
        assert!(events.contains(&format!("\"self\":\"{location}\"")), "{events}");
        let document = app.get_json(&format!("{kept}/openapi.json")).await;
        assert_eq!(document["servers"][0]["url"], "/tools/plateau/");
        if is_built("/") {
            assert_eq!(app.get(&format!("{kept}/")).await.status(), StatusCode::OK);
        }
    }
    problem(app.get("/tools/plateau/v1/jobs/none").await, 404).await;
    assert_eq!(app.get("/tools/plateaux/v1/jobs").await.status(), StatusCode::NOT_FOUND);
    // The studio names its files relative to a folder, so the base path needs a slash at its end.
    let client = client_builder().redirect(redirect::Policy::none()).build().unwrap();
    let response = client.request(Method::GET, format!("{}/tools/plateau", app.url)).send().await.unwrap();
    assert_eq!(
        (response.status(), &response.headers()["location"]),
        (StatusCode::PERMANENT_REDIRECT, &"/tools/plateau/".parse().unwrap())
    );
}
