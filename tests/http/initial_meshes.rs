//! Resolutions, the client's own initial mesh, fixed points and curves, and boundaries that cannot be spanned.

use crate::app::{MINIMAL, TestApp, example, pointers, problem};
use base64::Engine as _;
use serde_json::{Value, json};

fn square(height: f64) -> Value {
    json!([[0, 0, 0], [1, 0, height], [1, 1, 0], [0, 1, height]])
}

async fn refused(app: &TestApp, body: &Value) -> Vec<String> {
    let problem = problem(app.post(MINIMAL, body).await, 422).await;
    pointers(&problem).iter().map(|&pointer| pointer.to_owned()).collect()
}

#[tokio::test]
async fn resolutions_are_met_and_impossible_ones_get_an_error_with_their_pointer() {
    let app = TestApp::start().await;
    for (resolution, of) in [
        (json!({ "triangles": 900 }), "triangles"),
        (json!({ "interior_vertices": 400 }), "vertices"),
        (json!({ "edge_length": 0.05 }), "edge"),
    ] {
        let job = app.solve(MINIMAL, &json!({ "boundaries": [square(0.5)], "resolution": resolution })).await;
        let statistics = &job["statistics"];
        let reached = match of {
            "triangles" => statistics["triangles"].as_f64().unwrap() / 900.0,
            // The expected number of triangles follows from Euler's formula, with boundary edges of about the mean
            // length.
            "vertices" => statistics["triangles"].as_f64().unwrap() / 880.0,
            _ => statistics["edge_lengths"]["mean"].as_f64().unwrap() / 0.05,
        };
        assert!((reached - 1.0).abs() < 0.15, "{of}: {reached}");
        assert_eq!(statistics["initial_mesh"], "planar");
    }
    let rings = |triangles: u32| {
        json!({
            "boundaries": [square(0.5)], "initial_mesh": "rings", "boundary_sampling": "keep",
            "resolution": { "triangles": triangles }
        })
    };
    assert_eq!(app.solve(MINIMAL, &rings(100)).await["statistics"]["triangles"], 100);
    assert_eq!(refused(&app, &rings(101)).await, ["/resolution/triangles"]);
    let circle: Vec<[f64; 3]> = (0..200).map(|k| f64::from(k) / 31.8).map(|t| [t.cos(), t.sin(), 0.0]).collect();
    let few = json!({ "boundaries": [circle], "resolution": { "triangles": 50 } });
    assert_eq!(refused(&app, &few).await, ["/resolution/triangles"]);
}

#[tokio::test]
async fn the_clients_own_mesh_is_checked_and_used() {
    let app = TestApp::start().await;
    let request = example("own-mesh");
    let job = app.solve(MINIMAL, &request).await;
    assert_eq!((&job["statistics"]["initial_mesh"], &job["statistics"]["triangles"]), (&json!("given"), &json!(288)));
    assert_eq!(job["statistics"]["converged"], true);
    let mut wrong = request.clone();
    wrong["initial_mesh"]["triangles"][7] = json!([0, 1, 5000]);
    assert_eq!(refused(&app, &wrong).await, ["/initial_mesh/triangles/7"]);
    let mut wrong = request.clone();
    wrong["boundaries"][0][3][2] = json!(0.123);
    assert_eq!(refused(&app, &wrong).await, ["/initial_mesh"]);
    let mut wrong = request;
    wrong["initial_mesh"] = json!("sphere");
    assert_eq!(refused(&app, &wrong).await, ["/initial_mesh"]);
}

/// Returns a request with the mesh of a job as its initial mesh, in a GLB file. Options without effect on such a mesh
/// are left out.
async fn with_the_mesh_of(app: &TestApp, job: &Value, request: &Value) -> Value {
    let url = format!("{}?format=glb", job["links"]["mesh"].as_str().unwrap());
    let file = app.get(&url).await.bytes().await.unwrap();
    let mut with_file = request.clone();
    with_file["initial_mesh"] = json!({ "glb": base64::engine::general_purpose::STANDARD.encode(file) });
    with_file.as_object_mut().unwrap().remove("resolution");
    with_file
}

#[tokio::test]
async fn the_clients_own_mesh_can_be_a_glb_file() {
    let app = TestApp::start().await;
    let three = example("three-half-circles");
    let far = [[1e6, -2e6, 5.0], [1e6 + 3.0, -2e6, 6.1], [1e6 + 3.0, -2e6 + 3.0, 5.0], [1e6, -2e6 + 3.0, 6.1]];
    let far = json!({ "boundaries": [far], "units": "ft", "up": "y", "resolution": { "triangles": 500 } });
    for request in [example("own-mesh"), three, far] {
        let job = app.solve(MINIMAL, &request).await;
        let again = app.solve(MINIMAL, &with_the_mesh_of(&app, &job, &request).await).await;
        let (first, second) = (&job["statistics"], &again["statistics"]);
        assert_eq!((&second["initial_mesh"], &second["converged"]), (&json!("given"), &json!(true)), "{again:#}");
        assert_eq!((&first["vertices"], &first["triangles"]), (&second["vertices"], &second["triangles"]));
        let area = |statistics: &Value| statistics["area"].as_f64().unwrap();
        assert!((area(second) / area(first) - 1.0).abs() < 1e-7, "{} {}", area(first), area(second));
    }
}

#[tokio::test]
async fn a_wrong_file_is_refused_at_its_pointer() {
    let app = TestApp::start().await;
    let request = example("own-mesh");
    let job = app.solve(MINIMAL, &request).await;
    let right = with_the_mesh_of(&app, &job, &request).await;
    let with = |mesh: Value| {
        let mut wrong = request.clone();
        wrong["initial_mesh"] = mesh;
        wrong
    };
    let mut other_boundary = right.clone();
    other_boundary["boundaries"][0][3][2] = json!(0.123);
    let mut two_meshes = right.clone();
    two_meshes["initial_mesh"]["vertices"] = json!([[0, 0, 0], [1, 0, 0], [0, 1, 0]]);
    for (body, pointer, detail) in [
        (with(json!({ "glb": "%" })), "/initial_mesh/glb", "is not base64"),
        (with(json!({ "glb": "" })), "/initial_mesh/glb", "is not binary glTF"),
        (with(json!({ "glb": "Z2xURgIAAAAMAAAA" })), "/initial_mesh/glb", "is not binary glTF 2.0"),
        (other_boundary, "/initial_mesh/glb", "none of its boundary loops"),
        (two_meshes, "/initial_mesh/glb", "is only allowed without vertices and triangles"),
        (with(json!({ "triangles": [[0, 1, 2]] })), "/initial_mesh/vertices", "is required"),
        (with(json!({})), "/initial_mesh", "must have at least one of the members glb, triangles, vertices"),
    ] {
        let problem = problem(app.post(MINIMAL, &body).await, 422).await;
        assert_eq!(pointers(&problem), [pointer], "{problem:#}");
        let found = problem["errors"][0]["detail"].as_str().unwrap();
        assert!(found.contains(detail), "{found} instead of {detail}");
    }
    let small = TestApp::start_with(&[("PLATEAU_LIMITS__TRIANGLES", "200")]).await;
    let problem = problem(small.post(MINIMAL, &right).await, 413).await;
    assert_eq!(pointers(&problem), ["/initial_mesh/glb"]);
}

#[tokio::test]
async fn fixed_points_and_curves_are_vertices_of_the_mesh_exactly() {
    let app = TestApp::start().await;
    let request = example("ridge-rope");
    let job = app.solve(MINIMAL, &request).await;
    let obj = app.get(&format!("{}?format=obj", job["links"]["mesh"].as_str().unwrap())).await.text().await.unwrap();
    assert!(obj.lines().any(|line| line.split_whitespace().skip(1).map(str::parse).eq([Ok(5.0), Ok(5.0), Ok(3.2)])));
    assert_eq!(job["statistics"]["converged"], true, "{:#}", job["warnings"]);
    let mut wrong = request;
    wrong["constraints"]["polylines"] = json!([[[1, 1, 1], [1, 1, 1]]]);
    assert_eq!(refused(&app, &wrong).await, ["/constraints/polylines/0"]);
}

#[tokio::test]
async fn a_boundary_that_crosses_itself_in_its_plane_fails_with_the_reason() {
    let app = TestApp::start().await;
    let bow_tie = json!({ "boundaries": [[[0, 0, 0], [1, 1, 0], [1, 0, 0], [0, 1, 0]]] });
    let job: Value = app.post_waiting(MINIMAL, &bow_tie).await.json().await.unwrap();
    assert_eq!(job["status"], "failed");
    let error = job["error"].to_string();
    assert!(error.contains("self_intersecting_boundary") || error.contains("crosses"), "{error}");
    // The error points to the two sides that meet.
    assert_eq!(pointers(&job["error"]), ["/boundaries/0/0", "/boundaries/0/2"]);
}
