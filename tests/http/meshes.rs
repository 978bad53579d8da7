//! Formats, entity tags and ranges of the mesh, and the flat pattern.

use crate::app::{MINIMAL, RULED, TestApp, example, problem, small_film};
use reqwest::{Method, Response};

async fn get_with(app: &TestApp, path: &str, headers: &[(&'static str, &str)]) -> Response {
    let request =
        headers.iter().fold(app.request(Method::GET, path), |request, (name, value)| request.header(*name, *value));
    request.send().await.unwrap()
}

#[tokio::test]
async fn format_beats_accept_and_glb_is_the_default() {
    let app = TestApp::start().await;
    let job = app.solve(MINIMAL, &small_film(0.21)).await;
    let mesh = job["links"]["mesh"].as_str().unwrap();
    let media_type = async |query: &str, accept: &str| {
        let response = get_with(&app, &format!("{mesh}{query}"), &[("accept", accept)]).await;
        assert_eq!(response.status(), 200);
        assert_eq!(response.headers()["vary"], "Accept");
        response.headers()["content-type"].to_str().unwrap().to_owned()
    };
    assert_eq!(media_type("", "*/*").await, "model/gltf-binary");
    assert_eq!(media_type("", "model/gltf+json").await, "model/gltf+json");
    assert_eq!(media_type("", "text/html, model/obj;q=0.5").await, "model/obj");
    assert_eq!(media_type("?format=ply", "model/gltf+json").await, "application/x-ply");
    assert_eq!(media_type("?format=stl", "*/*").await, "model/stl");
    let glb = app.get(mesh).await.bytes().await.unwrap();
    assert_eq!(&glb[..4], b"glTF");
    // Generated clients know no media type of a mesh, and take this one as bytes.
    let bytes = "application/octet-stream";
    for (query, accept, expected) in [
        ("", bytes, bytes),
        ("?format=obj", bytes, bytes),
        ("?format=obj", "*/*, application/octet-stream", "model/obj"),
        ("?format=obj", "text/html", "model/obj"),
        ("", "application/octet-stream;q=0.5, model/stl", "model/stl"),
    ] {
        assert_eq!(media_type(query, accept).await, expected, "{query} {accept}");
    }
    let same = get_with(&app, mesh, &[("accept", bytes)]).await.bytes().await.unwrap();
    assert!(same == glb);
}

#[tokio::test]
async fn a_known_entity_tag_gives_304_and_ranges_join_to_the_whole() {
    let app = TestApp::start().await;
    let job = app.solve(MINIMAL, &small_film(0.22)).await;
    let mesh = job["links"]["mesh"].as_str().unwrap();
    let whole = app.get(mesh).await;
    let tag = whole.headers()["etag"].to_str().unwrap().to_owned();
    let bytes = whole.bytes().await.unwrap();
    let unchanged = get_with(&app, mesh, &[("if-none-match", &tag)]).await;
    assert_eq!((unchanged.status().as_u16(), unchanged.headers()["etag"].to_str().unwrap()), (304, tag.as_str()));
    let obj = app.get(&format!("{mesh}?format=obj")).await;
    assert_ne!(obj.headers()["etag"], tag.as_str());
    let first = get_with(&app, mesh, &[("range", "bytes=0-99")]).await;
    assert_eq!(first.status(), 206);
    assert_eq!(first.headers()["content-range"], format!("bytes 0-99/{}", bytes.len()));
    let rest = get_with(&app, mesh, &[("range", "bytes=100-"), ("if-range", &tag)]).await;
    let joined = [first.bytes().await.unwrap(), rest.bytes().await.unwrap()].concat();
    assert!(joined == bytes);
    let beyond = get_with(&app, mesh, &[("range", "bytes=999999999-")]).await;
    assert_eq!(beyond.headers()["content-range"], format!("bytes */{}", bytes.len()));
    problem(beyond, 416).await;
}

#[tokio::test]
async fn only_an_open_strip_has_a_flat_pattern() {
    let app = TestApp::start().await;
    let job = app.solve(RULED, &example("wavy-strip")).await;
    let flat = &job["statistics"]["flat_pattern"];
    assert!(flat["edge_length_error_max"].as_f64().unwrap() < 1e-12 && flat["width"].as_f64().unwrap() > 5.0, "{flat}");
    let pattern = job["links"]["pattern"].as_str().unwrap();
    let svg = app.get(pattern).await;
    assert_eq!(svg.headers()["content-type"], "image/svg+xml");
    assert!(svg.text().await.unwrap().contains("<svg"));
    let dxf = app.get(&format!("{pattern}?format=dxf")).await;
    assert_eq!(dxf.headers()["content-type"], "image/vnd.dxf");
    let film = app.solve(MINIMAL, &small_film(0.23)).await;
    assert!(film["links"].get("pattern").is_none());
    problem(app.get(&format!("{}/pattern", film["links"]["self"].as_str().unwrap())).await, 404).await;
    let closed = app.solve(RULED, &example("contour-stack")).await;
    assert!(closed["statistics"]["flat_pattern"].is_null());
    problem(app.get(closed["links"]["pattern"].as_str().unwrap()).await, 404).await;
}

#[tokio::test]
async fn units_and_axes_are_the_clients_in_obj_and_metres_y_up_in_gltf() {
    let app = TestApp::start().await;
    let mut film = small_film(0.24);
    film["units"] = "mm".into();
    let offset = 1e7;
    for point in film["boundaries"][0].as_array_mut().unwrap() {
        point[0] = (point[0].as_f64().unwrap() + offset).into();
    }
    let job = app.solve(MINIMAL, &film).await;
    let mesh = job["links"]["mesh"].as_str().unwrap();
    let obj = app.get(&format!("{mesh}?format=obj")).await.text().await.unwrap();
    assert!(obj.lines().any(|line| line == "v 10000001.0 0.0 0.24"), "{obj}");
    let gltf: serde_json::Value = app.get(&format!("{mesh}?format=gltf")).await.json().await.unwrap();
    let (units, up) = (&gltf["asset"]["extras"]["unit"], &gltf["asset"]["extras"]["up"]);
    assert_eq!((units.as_str(), up.as_str()), (Some("mm"), Some("z")));
    let x = gltf["nodes"][0]["translation"][0].as_f64().unwrap();
    assert!((x - offset / 1000.0).abs() < 0.01, "{x}");
}

#[tokio::test]
async fn a_damaged_mesh_is_410_and_an_equal_request_is_solved_again() {
    let app = TestApp::start().await;
    let job = app.solve(MINIMAL, &small_film(0.77)).await;
    let path = app.folder.path().join("data/plateau.sqlite");
    let damage = move || rusqlite::Connection::open(path)?.execute_batch("UPDATE artefacts SET body = hash");
    tokio::task::spawn_blocking(damage).await.unwrap().unwrap();
    let mesh = job["links"]["mesh"].as_str().unwrap();
    for _ in 0..2 {
        let lost = problem(app.get(mesh).await, 410).await;
        assert_eq!(lost["type"], "/problems/mesh-lost");
    }
    let again = app.solve(MINIMAL, &small_film(0.77)).await;
    assert_ne!(again["id"], job["id"]);
    assert_eq!(app.get(again["links"]["mesh"].as_str().unwrap()).await.status(), 200);
}
