//! Flat patterns and schedules over HTTP: formats, parameters and their errors.

use crate::app::{MINIMAL, RULED, TestApp, UNIFORM, example, problem, small_film};
use serde_json::{Value, json};

#[tokio::test]
async fn ruled_surfaces_have_a_flat_pattern_closed_ones_too() {
    let app = TestApp::start().await;
    let job = app.solve(RULED, &example("wavy-strip")).await;
    let flat = &job["statistics"]["flat_pattern"];
    assert!(flat["edge_length_error_max"].as_f64().unwrap() < 1e-12 && flat["width"].as_f64().unwrap() > 5.0, "{flat}");
    assert!(flat["cut_at"].is_null());
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
    let cut_at = closed["statistics"]["flat_pattern"]["cut_at"].as_array().unwrap().clone();
    let strips = closed["statistics"]["strips"].as_array().unwrap().len();
    assert_eq!(cut_at.len(), strips);
    let pattern = closed["links"]["pattern"].as_str().unwrap();
    let json: Value = app.get(&format!("{pattern}?format=json")).await.json().await.unwrap();
    let pieces = json["pieces"].as_array().unwrap();
    let named = |start: &str| pieces.iter().filter(|piece| piece["name"].as_str().unwrap().starts_with(start)).count();
    assert_eq!(named("strip"), strips);
    // The bridge that the statistics name gives the pattern without `cut_at`, and the next bridge gives another
    // pattern.
    let first = cut_at[0].as_u64().unwrap();
    let same: Value = app.get(&format!("{pattern}?format=json&cut_at={first}")).await.json().await.unwrap();
    assert_eq!(same, json);
    let other: Value = app.get(&format!("{pattern}?format=json&cut_at={}", first + 1)).await.json().await.unwrap();
    assert_ne!(other, json);
}

#[tokio::test]
async fn a_cut_profile_is_a_zip_and_wrong_parameters_are_named() {
    let app = TestApp::start().await;
    let job = app.solve(RULED, &example("wavy-strip")).await;
    let pattern = job["links"]["pattern"].as_str().unwrap();
    let zip = app.get(&format!("{pattern}?profile=cut&format=dxf&notches=100")).await;
    assert_eq!(zip.headers()["content-type"], "application/zip");
    assert!(zip.headers()["content-disposition"].to_str().unwrap().ends_with(".zip\""));
    assert!(zip.bytes().await.unwrap().starts_with(b"PK\x03\x04"));

    let wrong = problem(app.get(&format!("{pattern}?kerf=-1&radius=2")).await, 400).await;
    assert!(wrong["type"].as_str().unwrap().ends_with("/bad-query"), "{wrong}");
    let names: Vec<&Value> = wrong["errors"].as_array().unwrap().iter().map(|error| &error["parameter"]).collect();
    assert_eq!(names, [&json!("kerf"), &json!("radius")]);
    assert!(wrong["errors"][0].get("pointer").is_none());
    let unsuitable = problem(app.get(&format!("{pattern}?notches=0.01")).await, 422).await;
    assert!(unsuitable["type"].as_str().unwrap().ends_with("/unsuitable-pattern"), "{unsuitable}");
    assert_eq!(unsuitable["errors"][0]["parameter"], "notches");
}

#[tokio::test]
async fn schedules_are_tables_of_the_parts_that_a_result_has() {
    let app = TestApp::start().await;
    let job = app.solve(UNIFORM, &example("floor-fewest-nodes")).await;
    let schedule = format!("{}/schedule", job["links"]["self"].as_str().unwrap());
    let members = app.get(&format!("{schedule}?part=members&setback=0.01")).await;
    assert_eq!(members.headers()["content-type"], "text/csv");
    assert!(members.headers()["content-disposition"].to_str().unwrap().ends_with(".members.csv\""));
    let text = members.text().await.unwrap();
    let mut rows = text.split("\r\n").filter(|row| !row.is_empty());
    assert_eq!(rows.next(), Some("member,from,to,kind,length_m,setback_from_m,setback_to_m,cut_length_m"));
    let lengths: Vec<f64> = rows.map(|row| row.rsplit(',').next().unwrap().parse().unwrap()).collect();
    assert_eq!(json!(lengths.len()), job["statistics"]["edges"]);
    let mean = job["statistics"]["edge_lengths"]["mean"].as_f64().unwrap();
    let sum = (mean - 0.02) * lengths.len() as f64;
    assert!((lengths.iter().sum::<f64>() - sum).abs() < 1e-9 * sum);
    let space = app.get(&format!("{schedule}?format=dxf")).await;
    assert_eq!(space.headers()["content-type"], "image/vnd.dxf");

    let missing = problem(app.get(&format!("{schedule}?part=cables")).await, 404).await;
    assert!(missing["type"].as_str().unwrap().ends_with("/no-such-part"), "{missing}");
    assert!(missing["detail"].as_str().unwrap().contains("members, nodes"), "{missing}");
    let wrong = problem(app.get(&format!("{schedule}?part=members&radius=1")).await, 400).await;
    assert_eq!(wrong["errors"][0]["parameter"], "radius");
    let unsuitable = problem(app.get(&format!("{schedule}?part=members&setback=100")).await, 422).await;
    assert_eq!(unsuitable["errors"][0]["parameter"], "setback");
}
