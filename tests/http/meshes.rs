//! Formats, entity tags and ranges of the mesh.

use crate::app::{MINIMAL, RULED, TestApp, UNIFORM, example, problem, small_film};
use reqwest::{Method, Response};
use serde_json::{Value, json};

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
async fn a_mesh_is_coloured_by_what_is_asked_for() {
    let app = TestApp::start().await;
    let job = app.solve(MINIMAL, &small_film(0.26)).await;
    let mesh = job["links"]["mesh"].as_str().unwrap();
    let tag = async |query: &str| {
        let response = app.get(&format!("{mesh}?{query}")).await;
        assert_eq!(response.status(), 200, "{query}");
        response.headers()["etag"].to_str().unwrap().to_owned()
    };
    let document = async |query: &str| -> Value { app.get_json(&format!("{mesh}?format=gltf{query}")).await };
    let color = |gltf: &Value| gltf["meshes"][0]["primitives"][0]["attributes"].get("COLOR_0").cloned();
    let plain = document("").await;
    assert_eq!(color(&plain), None);
    assert!(plain["meshes"][0]["primitives"][0]["attributes"]["_MEAN_CURVATURE"].is_u64());
    let colored = document("&colors=mean_curvature&range=0.125").await;
    assert!(color(&colored).is_some());
    let scale = |gltf: &Value| gltf["asset"]["extras"]["color_range"]["max"].as_f64();
    assert_eq!((scale(&plain), scale(&colored)), (None, Some(0.125)));
    // The boundary's corners are 0.72 from their mean, so the default scale ends at 0.01 / 0.72 or above.
    assert!(scale(&document("&colors=mean_curvature").await).unwrap() > 0.0138);
    // Each colouring is a file of its own, and equal colourings share one file.
    let queries = ["", "colors=mean_curvature", "colors=mean_curvature&range=0.5", "colors=mean_curvature&range=0.25"];
    let mut tags = Vec::new();
    for query in queries {
        tags.push(tag(query).await);
    }
    for (a, b) in [(0, 1), (0, 2), (1, 2), (2, 3)] {
        assert_ne!(tags[a], tags[b], "{} and {}", queries[a], queries[b]);
    }
    assert_eq!(tag("range=5e-1&colors=mean_curvature").await, tags[2]);
    assert_eq!(tag("").await, tags[0]);

    let lattice = app.solve(UNIFORM, &example("floor-equal-members")).await;
    let path = format!("{}?format=gltf&colors=length", lattice["links"]["mesh"].as_str().unwrap());
    let gltf: Value = app.get_json(&path).await;
    assert_eq!(color(&gltf), None);
    assert!(gltf["meshes"][1]["primitives"][0]["attributes"]["COLOR_0"].is_u64());
}

/// Solves a strip of which some bridges are not locally convex.
async fn saddle_strip(app: &TestApp, points: usize) -> Value {
    let rail = |turn: f64, y: f64| -> Vec<[f64; 3]> {
        let height = |k: usize| turn * k as f64 / (points - 1) as f64;
        (0..points).map(|k| [4.0 * k as f64 / (points - 1) as f64, y * height(k).cos(), y * height(k).sin()]).collect()
    };
    app.solve(RULED, &json!({ "directrices": [rail(1.5, -1.0), rail(1.5, 1.0)], "objective": "minimal_twist" })).await
}

#[tokio::test]
async fn a_strip_is_coloured_by_convexity_and_lists_the_bridges_that_are_not_convex() {
    let app = TestApp::start().await;
    for (points, capped) in [(9, false), (150, true)] {
        let strip = saddle_strip(&app, points).await;
        let (statistics, mesh) = (&strip["statistics"], strip["links"]["mesh"].as_str().unwrap());
        let count = |name: &str| statistics[name].as_u64().unwrap() as usize;
        let concave = count("bridges") - count("convex_bridges");
        let listed = statistics["concave_bridges"].as_array().unwrap();
        assert!(concave > 0 && (concave > 200) == capped, "{concave} of {}", count("bridges"));
        assert_eq!(listed.len(), concave.min(200));
        // The list is the beginning of what the lines of the JSON mesh mark.
        let json = app.get_json(&format!("{mesh}?format=json")).await;
        let bridges = json["lines"].as_array().unwrap().iter().find(|lines| lines["name"] == "bridges").unwrap();
        let marks = bridges["values"]["values"].as_array().unwrap();
        assert_eq!((&bridges["values"]["name"], marks.len()), (&json!("concave"), count("bridges")));
        let marked: Vec<usize> = (0..marks.len()).filter(|&k| marks[k] == 1.0).collect();
        assert_eq!(marked.len(), concave);
        let mut deviation = 0f64;
        for (entry, &k) in listed.iter().zip(&marked) {
            assert_eq!((&entry["bridge"], &entry["vertices"]), (&json!(k), &bridges["paths"][k]));
            deviation = deviation.max(entry["fold_deg"].as_f64().unwrap());
        }
        if !capped {
            assert_eq!(Some(deviation), statistics["developability_deviation_deg"].as_f64());
        }
        let gltf = app.get_json(&format!("{mesh}?format=gltf&colors=convexity")).await;
        for mesh in ["surface", "bridges"] {
            let named = gltf["meshes"].as_array().unwrap().iter().find(|of| of["name"] == mesh).unwrap();
            assert!(named["primitives"][0]["attributes"]["COLOR_0"].is_u64(), "{mesh}");
        }
        let plain = app.get_json(&format!("{mesh}?format=gltf")).await;
        assert!(plain["meshes"][0]["primitives"][0]["attributes"].get("COLOR_0").is_none());
        assert_eq!(app.get(&format!("{mesh}?format=ply&colors=convexity")).await.status(), 200);
    }
    let flat = json!({ "directrices": [[[0, 0, 0], [1, 0, 0], [2, 0, 0]], [[0, 1, 0], [2, 1, 0]]] });
    assert_eq!(app.solve(RULED, &flat).await["statistics"]["concave_bridges"], json!([]));
}

#[tokio::test]
async fn colours_that_a_mesh_cannot_have_are_refused() {
    let app = TestApp::start().await;
    let film = app.solve(MINIMAL, &small_film(0.27)).await;
    let strip = app.solve(RULED, &example("wavy-strip")).await;
    let net = app.solve("/v1/cable-nets", &example("four-cables")).await;
    let lattice = app.solve(UNIFORM, &example("floor-equal-members")).await;
    let sail = app.solve("/v1/tensile-structures", &example("four-point-sail")).await;
    let [film, strip, net, lattice, sail] = [&film, &strip, &net, &lattice, &sail].map(|job| &job["links"]["mesh"]);
    for (mesh, query, status, detail) in [
        (film, "colors=heat", 400, "colors must be one of mean_curvature, lower_bound_slack, length, force, convexity"),
        (film, "colors=", 400, "colors must be one of mean_curvature, lower_bound_slack, length, force, convexity"),
        (film, "colors=mean_curvature&colors=force", 400, "colors is given twice"),
        (film, "colors=mean_curvature&range=0", 400, "range must be a number above 0"),
        (film, "colors=mean_curvature&range=-1", 400, "range must be a number above 0"),
        (film, "colors=mean_curvature&range=inf", 400, "range must be a number above 0"),
        (film, "colors=mean_curvature&range=NaN", 400, "range must be a number above 0"),
        (film, "colors=mean_curvature&range=1e999", 400, "range must be a number above 0"),
        (film, "colors=mean_curvature&range=0,1", 400, "range must be a number above 0"),
        (film, "range=1", 422, "range is only allowed with colors, whose scale it ends"),
        (film, "format=obj&colors=mean_curvature", 422, "colors is only allowed with glb, gltf, ply, not with obj"),
        (film, "format=json&colors=mean_curvature", 422, "colors is only allowed with glb, gltf, ply, not with json"),
        (film, "colors=force", 422, "this file has no force to be coloured by; it has mean_curvature"),
        (
            film,
            "colors=lower_bound_slack",
            422,
            "this file has no lower_bound_slack to be coloured by; it has mean_curvature",
        ),
        (strip, "colors=mean_curvature", 422, "this file has no mean_curvature to be coloured by; it has convexity"),
        (film, "colors=convexity", 422, "this file has no convexity to be coloured by; it has mean_curvature"),
        (net, "colors=convexity", 422, "this file has no convexity to be coloured by; it has force"),
        (lattice, "colors=convexity", 422, "this file has no convexity to be coloured by; it has length"),
        (sail, "colors=convexity", 422, "this file has no convexity to be coloured by; it has force"),
    ] {
        let problem = problem(app.get(&format!("{}?{query}", mesh.as_str().unwrap())).await, status).await;
        assert_eq!(problem["detail"], json!(detail), "{query}");
    }
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
    let gltf: Value = app.get(&format!("{mesh}?format=gltf")).await.json().await.unwrap();
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
