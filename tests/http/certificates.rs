//! `certify`: the lower bound in the statistics, and its proof as a document that an independent program confirms.

use crate::app::{MINIMAL, TestApp, pointers, problem, root};
use serde_json::{Value, json};
use std::io::Write;
use std::process::{Command, Output, Stdio};

fn request() -> Value {
    let corners = [[0.0, 0.0, 0.0], [1.0, 0.0, 1.0], [1.0, 1.0, 0.0], [0.0, 1.0, 1.0]];
    json!({ "boundaries": [corners], "resolution": { "triangles": 400 }, "certify": { "gap": 0.02, "seconds": 0.2 } })
}

/// Runs the independent program on a proof.
fn check(proof: &[u8]) -> Output {
    let mut script = Command::new("python3")
        .arg(root().join("scripts/check_certificate.py"))
        .stdin(Stdio::piped())
        .stdout(Stdio::piped())
        .stderr(Stdio::piped())
        .spawn()
        .expect("python3 runs");
    script.stdin.take().unwrap().write_all(proof).unwrap();
    script.wait_with_output().unwrap()
}

#[tokio::test]
async fn a_certificate_is_stated_and_an_independent_program_confirms_it() {
    let app = TestApp::start().await;
    let job = app.solve(MINIMAL, &request()).await;
    let (statistics, certificate) = (&job["statistics"], &job["statistics"]["certificate"]);
    let (area, bound) = (statistics["area"].as_f64().unwrap(), certificate["area_lower_bound"].as_f64().unwrap());
    assert!(bound > 0.9 * area && bound <= area);
    assert!((certificate["gap"].as_f64().unwrap() - (area / bound - 1.0)).abs() < 1e-12);
    let statement = certificate["statement"].as_str().unwrap();
    assert!(statement.starts_with("No oriented surface of any topology with this boundary has an area below "));
    let proof = app.get(job["links"]["certificate"].as_str().unwrap()).await;
    assert_eq!(proof.status(), 200);
    assert_eq!(proof.headers()["content-type"], "application/json");
    let proof = proof.bytes().await.unwrap();
    // The quadrilateral has two planes of symmetry, through the diagonals of its plan, so the field has axes of its
    // own.
    let document: Value = serde_json::from_slice(&proof).unwrap();
    let field = &document["orientations"][0];
    assert_eq!(field["frame"]["axes"].as_array().unwrap().len(), 3);
    let signs: Vec<i64> =
        field["mirrors"].as_array().unwrap().iter().map(|mirror| mirror["sign"].as_i64().unwrap()).collect();
    assert_eq!(signs, [-1, -1]);
    let output = check(&proof);
    assert!(output.status.success(), "{}", String::from_utf8_lossy(&output.stdout));
    let ply = app.get(&format!("{}?format=ply", job["links"]["mesh"].as_str().unwrap())).await.bytes().await.unwrap();
    assert!(String::from_utf8_lossy(&ply[..400]).contains("property double lower_bound_slack"));
    let colored = app.get(&format!("{}?colors=lower_bound_slack", job["links"]["mesh"].as_str().unwrap())).await;
    assert_eq!(colored.status(), 200);
}

#[tokio::test]
async fn every_compared_topology_says_how_far_it_is_from_the_minimum() {
    let app = TestApp::start().await;
    let ring = |z: f64| -> Vec<[f64; 3]> {
        (0..16).map(|k| std::f64::consts::TAU * f64::from(k) / 16.0).map(|a| [a.cos(), a.sin(), z]).collect()
    };
    let request = json!({ "boundaries": [ring(0.0), ring(0.8)], "topology": "best", "resolution": { "triangles": 600 },
        "certify": { "seconds": 0.2 } });
    let statistics = app.solve(MINIMAL, &request).await["statistics"].clone();
    let bound = statistics["certificate"]["area_lower_bound"].as_f64().unwrap();
    let topologies = statistics["spanning"]["topologies"].as_array().unwrap();
    assert_eq!(topologies.len(), 2);
    for topology in topologies {
        let (area, gap) = (topology["area"].as_f64().unwrap(), topology["gap"].as_f64().unwrap());
        assert!((gap - (area / bound - 1.0)).abs() < 1e-12 && gap > 0.0);
    }
}

/// Eight rings stand in four pairs, and two of the rings are given clockwise. The film is eight discs that all run
/// counter-clockwise, with an area of 24. Four annuli have an area of 4.94, because they run along one ring of each
/// pair in the other direction. The bound must hold for the discs and for the annuli.
#[tokio::test]
async fn with_more_than_six_loops_the_bound_covers_every_direction() {
    let app = TestApp::start().await;
    let ring = |k: usize| -> Vec<[f64; 3]> {
        let (x, z) = (3.0 * (k / 2) as f64, 0.2 * (k % 2) as f64);
        let angles = (0..12).map(|i| std::f64::consts::TAU * f64::from(i) / 12.0);
        angles.map(|angle| [x + angle.cos(), angle.sin(), z]).collect()
    };
    let is_clockwise = |k: usize| k == 2 || k == 5;
    let mut boundaries: Vec<_> = (0..8).map(ring).collect();
    let mut vertices = boundaries.concat();
    vertices.extend((0..8).map(|k| [3.0 * (k / 2) as f64, 0.0, 0.2 * (k % 2) as f64]));
    let fan = |k: usize| (0..12).map(move |i| [12 * k + i, 12 * k + (i + 1) % 12, 96 + k]);
    let triangles: Vec<[usize; 3]> = (0..8).flat_map(fan).collect();
    boundaries.iter_mut().enumerate().filter(|(k, _)| is_clockwise(*k)).for_each(|(_, points)| points.reverse());
    let request = json!({ "boundaries": boundaries, "initial_mesh": { "vertices": vertices, "triangles": triangles },
        "certify": { "gap": 0, "seconds": 0.2 } });
    let job = app.solve(MINIMAL, &request).await;
    let (statistics, certificate) = (&job["statistics"], &job["statistics"]["certificate"]);
    let bound = certificate["area_lower_bound"].as_f64().unwrap();
    assert_eq!(statistics["components"].as_u64(), Some(8));
    assert!(bound > 1.0 && bound < 4.937, "{bound}");
    let statement = certificate["statement"].as_str().unwrap();
    assert!(statement.contains("above the global minimum. It is not proven"), "{statement}");
    let proof = app.get(job["links"]["certificate"].as_str().unwrap()).await.bytes().await.unwrap();
    let output = check(&proof);
    assert!(output.status.success(), "{}", String::from_utf8_lossy(&output.stderr));
    // Without one of its fields the document does not cover every orientation.
    let mut partial: Value = serde_json::from_slice(&proof).unwrap();
    partial["orientations"].as_array_mut().unwrap().pop();
    let output = check(&serde_json::to_vec(&partial).unwrap());
    assert!(String::from_utf8_lossy(&output.stderr).contains("an orientation of the loops is missing"));
}

#[tokio::test]
async fn without_certify_there_is_none_and_other_objectives_cannot_have_one() {
    let app = TestApp::start().await;
    let mut plain = request();
    plain["certify"] = json!(false);
    let job = app.solve(MINIMAL, &plain).await;
    assert_eq!(job["statistics"]["certificate"], Value::Null);
    assert!(job["links"].get("certificate").is_none(), "{}", job["links"]);
    problem(app.get(&format!("{}/certificate", job["links"]["self"].as_str().unwrap())).await, 404).await;
    let mut curvature = request();
    curvature["objective"] = json!("minimal_mean_curvature");
    let refused = problem(app.post(MINIMAL, &curvature).await, 422).await;
    assert_eq!(pointers(&refused), ["/certify"]);
    let mut wrong = request();
    wrong["certify"] = json!({ "gap": -1.0 });
    let refused = problem(app.post(MINIMAL, &wrong).await, 422).await;
    assert!(pointers(&refused)[0].starts_with("/certify"));
}
