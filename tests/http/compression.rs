//! Long answers are compressed for clients that accept it.

use crate::app::{MINIMAL, TestApp, small_film};
use flate2::read::GzDecoder;
use reqwest::{Method, Response};
use serde_json::{Value, json};
use std::io::Read;

/// A film whose files are long enough to be compressed.
fn film() -> Value {
    json!({ "boundaries": [[[0, 0, 0], [1, 0, 0.3], [1, 1, 0], [0, 1, 0.3]]], "resolution": { "triangles": 2000 } })
}

async fn get(app: &TestApp, path: &str, headers: &[(&str, &str)]) -> Response {
    let request =
        headers.iter().fold(app.request(Method::GET, path), |request, (name, value)| request.header(*name, *value));
    request.send().await.unwrap()
}

fn header<'r>(response: &'r Response, name: &str) -> &'r str {
    response.headers().get(name).map_or("", |value| value.to_str().unwrap())
}

#[tokio::test]
async fn a_mesh_and_the_api_document_are_compressed_for_clients_that_accept_it() {
    let app = TestApp::start().await;
    let job = app.solve(MINIMAL, &film()).await;
    let mesh = format!("{}?format=obj", job["links"]["mesh"].as_str().unwrap());
    for path in [mesh.as_str(), "/openapi.json"] {
        let plain = get(&app, path, &[]).await;
        assert_eq!(header(&plain, "content-encoding"), "");
        let plain = plain.bytes().await.unwrap();
        let compressed = get(&app, path, &[("accept-encoding", "gzip")]).await;
        assert_eq!(header(&compressed, "content-encoding"), "gzip", "{path}");
        let vary: Vec<_> = compressed.headers().get_all("vary").iter().map(|value| value.to_str().unwrap()).collect();
        assert!(vary.join(",").contains("accept-encoding"), "{vary:?}");
        let bytes = compressed.bytes().await.unwrap();
        let mut read = Vec::new();
        GzDecoder::new(&bytes[..]).read_to_end(&mut read).unwrap();
        assert!(read == plain, "{path}");
        assert!(2 * bytes.len() < plain.len(), "{path}: {} of {} bytes", bytes.len(), plain.len());
    }
    // zstd is not offered, because building it takes longer than the bytes that it saves are worth.
    let both = get(&app, &mesh, &[("accept-encoding", "zstd, gzip;q=0.5")]).await;
    assert_eq!(header(&both, "content-encoding"), "gzip");
    let short = get(&app, "/v1/limits", &[("accept-encoding", "gzip")]).await;
    assert_eq!(header(&short, "content-encoding"), "");
}

#[tokio::test]
async fn a_compressed_file_has_a_weak_tag_and_a_part_of_it_is_never_compressed() {
    let app = TestApp::start().await;
    let job = app.solve(MINIMAL, &film()).await;
    let mesh = format!("{}?format=stl", job["links"]["mesh"].as_str().unwrap());
    let gzip = ("accept-encoding", "gzip");
    let strong = header(&get(&app, &mesh, &[]).await, "etag").to_owned();
    let weak = header(&get(&app, &mesh, &[gzip]).await, "etag").to_owned();
    assert_eq!(weak, format!("W/{strong}"));
    for tag in [&strong, &weak] {
        let unchanged = get(&app, &mesh, &[gzip, ("if-none-match", tag)]).await;
        assert_eq!(unchanged.status(), 304, "{tag}");
    }
    let part = get(&app, &mesh, &[gzip, ("range", "bytes=80-83"), ("if-range", &strong)]).await;
    assert_eq!((part.status().as_u16(), header(&part, "content-encoding")), (206, ""));
    let triangles = u32::from_le_bytes(part.bytes().await.unwrap()[..].try_into().unwrap());
    assert_eq!(job["statistics"]["triangles"], triangles);
    // A weak tag never matches in If-Range (RFC 9110, 13.1.5), so the answer is the whole file.
    let whole = get(&app, &mesh, &[gzip, ("range", "bytes=80-83"), ("if-range", &weak)]).await;
    assert_eq!(whole.status(), 200);
}

#[tokio::test]
async fn event_streams_are_not_compressed_and_compression_can_be_off() {
    let app = TestApp::start_with(&[("PLATEAU_HTTP__COMPRESSION", "false")]).await;
    let plain = get(&app, "/openapi.json", &[("accept-encoding", "gzip")]).await;
    assert_eq!(header(&plain, "content-encoding"), "");
    let app = TestApp::start().await;
    let job = app.solve(MINIMAL, &small_film(0.3)).await;
    let events = get(&app, job["links"]["events"].as_str().unwrap(), &[("accept-encoding", "gzip")]).await;
    assert_eq!((header(&events, "content-type"), header(&events, "content-encoding")), ("text/event-stream", ""));
}
