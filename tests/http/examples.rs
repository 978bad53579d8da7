//! Every example is solved, and its results are checked.

use crate::app::{TestApp, example, example_names, path_of, root};
use crate::skips::skipped;
use serde_json::Value;
use std::process::Command;

#[tokio::test]
async fn every_example_succeeds_and_can_be_downloaded_in_every_format() {
    let app = TestApp::start().await;
    let folder = tempfile::tempdir().unwrap();
    let mut files = Vec::new();
    for name in example_names() {
        let request = example(&name);
        let job = app.solve(path_of(request["kind"].as_str().unwrap()), &request).await;
        let has_surface = job["kind"] != "cable_net";
        assert_eq!(job["statistics"]["triangles"].as_u64().unwrap() > 0, has_surface, "{name}");
        // `converged` is null for strips, because their optimum is found in one pass.
        assert_ne!(job["statistics"]["converged"], false, "{name}: {}", job["warnings"]);
        for format in ["glb", "gltf", "obj", "ply", "stl"] {
            // STL has only triangles.
            if format == "stl" && !has_surface {
                continue;
            }
            let response = app.get(&format!("{}?format={format}", job["links"]["mesh"].as_str().unwrap())).await;
            assert_eq!(response.status(), 200, "{name} as {format}");
            let bytes = response.bytes().await.unwrap();
            assert!(bytes.len() > 100, "{name} as {format}");
            if matches!(format, "glb" | "gltf") {
                let path = folder.path().join(format!("{name}.{format}"));
                std::fs::write(&path, &bytes).unwrap();
                files.push(path);
            }
        }
    }
    // The Khronos validator checks that any viewer can read the files.
    let script = root().join("scripts/validate-gltf.mjs");
    if !root().join("scripts/node_modules/gltf-validator").exists() {
        skipped("Khronos validator of the examples", "npm has not installed gltf-validator in scripts");
        return;
    }
    let output = Command::new("node").arg(script).args(&files).output().expect("node runs");
    assert!(
        output.status.success(),
        "{}{}",
        String::from_utf8_lossy(&output.stdout),
        String::from_utf8_lossy(&output.stderr)
    );
}

#[tokio::test]
async fn the_helicoid_has_the_reference_area_and_keeps_its_186_points() {
    let app = TestApp::start().await;
    let request = example("helicoid");
    let job = app.solve("/v1/minimal-surfaces", &request).await;
    let statistics = &job["statistics"];
    let area = statistics["area"].as_f64().unwrap();
    assert!((area / 535.0748 - 1.0).abs() < 1e-3, "{area}");
    // The number of triangles is exact for `rings`, and within a tenth for the initial mesh that `auto` chooses.
    assert!((1845..=2255).contains(&statistics["triangles"].as_u64().unwrap()));
    assert_eq!((statistics["euler_characteristic"].as_i64(), statistics["converged"].as_bool()), (Some(1), Some(true)));
    // OBJ keeps the client's axes and every digit, so the first 186 vertices equal the given points exactly.
    let obj = app.get(&format!("{}?format=obj", job["links"]["mesh"].as_str().unwrap())).await.text().await.unwrap();
    let vertices: Vec<Vec<f64>> = obj
        .lines()
        .filter_map(|line| line.strip_prefix("v "))
        .map(|line| line.split_whitespace().map(|word| word.parse().unwrap()).collect())
        .collect();
    let given: Vec<Vec<f64>> =
        serde_json::from_value::<Vec<Vec<Vec<f64>>>>(request["boundaries"].clone()).unwrap().concat();
    assert_eq!(given.len(), 186);
    assert_eq!(vertices[..186], given[..]);
}

#[tokio::test]
async fn the_server_returns_the_examples_of_the_repository() {
    let app = TestApp::start().await;
    let list = app.get_json("/v1/examples").await;
    let mut names: Vec<&str> =
        list["examples"].as_array().unwrap().iter().map(|example| example["name"].as_str().unwrap()).collect();
    names.sort_unstable();
    assert_eq!(names, example_names());
    for name in names {
        let served: Value = app.get_json(&format!("/v1/examples/{name}")).await;
        assert_eq!(served["request"], example(name));
        assert_eq!(served["kind"], example(name)["kind"]);
    }
}
