//! Listing jobs.

use crate::app::{MINIMAL, RULED, TestApp, example, small_film};
use serde_json::Value;

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
