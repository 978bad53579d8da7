//! Resolutions, the client's own initial mesh, fixed points and curves, and boundaries that cannot be spanned.

use crate::app::{MINIMAL, TestApp, example, pointers, problem};
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
    let rings = |triangles: u32| json!({ "boundaries": [square(0.5)], "initial_mesh": "rings", "boundary_sampling": "keep", "resolution": { "triangles": triangles } });
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
    // It says where: at the two sides that meet.
    assert_eq!(pointers(&job["error"]), ["/boundaries/0/0", "/boundaries/0/2"]);
}
