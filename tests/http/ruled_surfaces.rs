//! Ruled surfaces over HTTP: every option has its effect, errors point to wrong values, and a strip of a hundred
//! million cells is solved, followed and cancelled.

use crate::app::{RULED, TestApp, large_strip, pointers, problem};
use crate::hold::until;
use crate::pairs::some_pairs;
use futures_util::StreamExt;
use reqwest::Method;
use serde_json::{Value, json};

fn strip() -> Value {
    json!({ "directrices": [
        [[0, 0, 0], [1, 0, 0.2], [2, 0, 0], [3, 0, 0.4], [4, 0, 0]],
        [[0, 1, 0], [1.3, 1, 0.3], [2.4, 1.1, 0.5], [4, 1, 0.1]],
    ] })
}

fn ring(count: usize, z: f64) -> Vec<[f64; 3]> {
    (0..count).map(|k| std::f64::consts::TAU * k as f64 / count as f64).map(|a| [a.cos(), a.sin(), z]).collect()
}

fn rings() -> Value {
    json!({ "directrices": [ring(12, 0.0), ring(9, 1.0)], "closed": true })
}

fn with(mut body: Value, fields: Value) -> Value {
    let fields = fields.as_object().expect("an object").clone();
    body.as_object_mut().expect("an object").extend(fields);
    body
}

fn number(statistics: &Value, field: &str) -> f64 {
    statistics[field].as_f64().unwrap_or_else(|| panic!("{field} in {statistics:#}"))
}

#[tokio::test]
async fn every_objective_is_best_in_its_own_column_of_the_comparison() {
    let app = TestApp::start().await;
    let normals = [vec![[0, 0, 1]; 5], vec![[0, 0, 1]; 4]];
    let body = with(strip(), json!({ "all_objectives": true, "normals": normals }));
    let statistics = app.solve(RULED, &body).await["statistics"].clone();
    let rows = statistics["comparison"].as_array().unwrap();
    let columns = [
        ("minimal_area", "area"),
        ("minimal_twist", "total_normal_twist"),
        ("minimal_bending_energy", "bending_energy"),
        ("minimal_mean_curvature_variation", "mean_curvature_variation"),
        ("minimal_normal_variation", "normal_variation"),
    ];
    assert_eq!(rows.len(), 8);
    for (objective, column) in columns {
        let own = rows.iter().find(|row| row["objective"] == objective).unwrap();
        assert!(rows.iter().all(|row| number(own, column) <= number(row, column) + 1e-12), "{objective}");
        // The same objective chosen alone gives the same result.
        let body = with(strip(), json!({ "objective": objective, "normals": normals }));
        let alone = app.solve(RULED, &body).await["statistics"].clone();
        assert_eq!((&alone["objective"], &alone["objective_value"]), (&json!(objective), &own["objective_value"]));
        assert_eq!(alone["objective_value"], alone[column]);
    }
    let convex = rows.iter().find(|row| row["objective"] == "maximal_convexity").unwrap();
    for secondary in ["minimal_bending_energy", "minimal_mean_curvature_variation"] {
        let body = with(strip(), json!({ "objective": "maximal_convexity", "secondary_objective": secondary }));
        let coupled = app.solve(RULED, &body).await["statistics"].clone();
        assert_eq!(coupled["convex_bridges"], convex["convex_bridges"]);
        assert!(coupled["secondary_value"].is_number());
    }
}

#[tokio::test]
async fn weights_make_a_sum_between_its_terms() {
    let app = TestApp::start().await;
    let area = number(&app.solve(RULED, &strip()).await["statistics"], "area");
    let weights = json!({ "minimal_area": 1, "minimal_bending_energy": 0.2 });
    let job = app.solve(RULED, &with(strip(), json!({ "objective": { "weights": weights } }))).await;
    let mixed = &job["statistics"];
    assert_eq!(mixed["objective"], "weighted");
    assert!(number(mixed, "area") >= area && number(mixed, "objective_value") >= 1.2 - 1e-12);
    let raw = json!({ "objective": { "weights": { "minimal_area": 2 }, "normalise": false } });
    let doubled = app.solve(RULED, &with(strip(), raw)).await;
    assert!((number(&doubled["statistics"], "objective_value") / area - 2.0).abs() < 1e-12);
}

#[tokio::test]
async fn direction_sampling_caps_and_an_apex_have_their_effect() {
    let app = TestApp::start().await;
    let mut reversed = strip();
    reversed["directrices"][1].as_array_mut().unwrap().reverse();
    let warned = app.solve(RULED, &reversed).await;
    assert!(warned["warnings"].as_array().unwrap().iter().any(|w| w["code"] == "opposite_directions"), "{warned:#}");
    let auto = app.solve(RULED, &with(reversed, json!({ "direction": "auto" }))).await;
    assert_eq!(auto["statistics"]["reversed"], json!([false, true]));
    assert_eq!(auto["statistics"]["direction_decided_by"], json!([null, "folds"]));
    let straight = app.solve(RULED, &strip()).await;
    assert_eq!(straight["statistics"]["direction_decided_by"], json!([null, null]));
    assert_eq!(straight["warnings"], json!([]));
    assert!((number(&auto["statistics"], "area") / number(&straight["statistics"], "area") - 1.0).abs() < 1e-12);
    assert!(straight["statistics"]["flat_pattern"]["edge_length_error_max"].as_f64().unwrap() < 1e-12);

    for (sampling, triangles) in [
        (json!({ "samples": 9, "by": "arc_length" }), 16),
        (json!({ "samples": 12, "by": "parameter" }), 22),
        (json!({ "samples": 3, "by": "chord_height", "tolerance": 0 }), 4),
        (json!({ "by": "chord_height", "tolerance": 10 }), 2),
    ] {
        let job = app.solve(RULED, &with(strip(), json!({ "sampling": sampling }))).await;
        assert_eq!(job["statistics"]["triangles"], triangles, "{sampling}");
    }

    let body = json!({ "directrices": [ring(12, 0.0), ring(17, 1.0), [[0, 0, 2]]], "closed": true, "caps": "flat" });
    let statistics = app.solve(RULED, &body).await["statistics"].clone();
    let triangles: Vec<u64> =
        statistics["strips"].as_array().unwrap().iter().map(|s| s["triangles"].as_u64().unwrap()).collect();
    assert_eq!(triangles, [29, 17]);
    assert_eq!(statistics["flat_pattern"]["cut_at"].as_array().unwrap().len(), 2);
}

/// Solves the pairs of the geometry's own test, whose directions are known. The second rail must be reversed exactly if
/// it runs against the first, and the statistics must name the rule that decided this.
#[tokio::test]
async fn directions_are_those_that_a_person_sees() {
    let app = TestApp::start().await;
    for (rails, runs_against, closed) in some_pairs() {
        let body = json!({ "directrices": rails, "closed": closed });
        let as_given = app.solve(RULED, &body).await;
        let warns = as_given["warnings"].as_array().unwrap().iter().any(|w| w["code"] == "opposite_directions");
        assert_eq!(warns, runs_against, "{body}");
        let auto = app.solve(RULED, &with(body.clone(), json!({ "direction": "auto" }))).await;
        assert_eq!(auto["statistics"]["reversed"], json!([false, runs_against]), "{body}");
        let decided_by = auto["statistics"]["direction_decided_by"][1].as_str().unwrap();
        assert!(if closed { decided_by == "area_vectors" } else { ["folds", "ends"].contains(&decided_by) }, "{body}");
    }
}

#[tokio::test]
async fn repeated_points_are_merged_with_a_warning_and_mapped() {
    let app = TestApp::start().await;
    let mut body = strip();
    let repeated = body["directrices"][0][2].clone();
    body["directrices"][0].as_array_mut().unwrap().insert(2, repeated);
    let job = app.solve(RULED, &body).await;
    assert!(job["warnings"].as_array().unwrap().iter().any(|warning| warning["code"] == "merged_points"));
    assert_eq!(job["statistics"]["area"], app.solve(RULED, &strip()).await["statistics"]["area"]);
    let mesh = app.get_json(&format!("{}?format=gltf", job["links"]["mesh"].as_str().unwrap())).await;
    let text = mesh.to_string();
    assert!(text.contains("\"input_vertices\":[[0,1,2,2,3,4],[5,6,7,8]]"), "{}", &text[..text.len().min(2000)]);
}

#[tokio::test]
async fn wrong_values_get_an_error_with_their_pointer() {
    let app = TestApp::start().await;
    let cases = [
        (json!({ "directrices": [[[0, 0, 0], [1, 0, 0]]] }), "/directrices"),
        (json!({ "directrices": [[[0, 0, 0]], [[1, 0, 0]]] }), "/directrices/1"),
        (json!({ "directrices": [[[0, 0, 0], [1, 0, 0]], []] }), "/directrices/1"),
        (with(strip(), json!({ "objective": "prettiest" })), "/objective"),
        (with(strip(), json!({ "objective": "minimal_normal_variation" })), "/normals"),
        (
            with(strip(), json!({ "objective": { "weights": { "maximal_convexity": 1 } } })),
            "/objective/weights/maximal_convexity",
        ),
        (
            with(strip(), json!({ "objective": { "weights": { "minimal_area": -1 } } })),
            "/objective/weights/minimal_area",
        ),
        (with(strip(), json!({ "objective": { "weights": {} } })), "/objective/weights"),
        (with(strip(), json!({ "secondary_objective": "minimal_bending_energy" })), "/secondary_objective"),
        (with(strip(), json!({ "convexity_tolerance_deg": -1 })), "/convexity_tolerance_deg"),
        (with(strip(), json!({ "convexity_tolerance_deg": 46 })), "/convexity_tolerance_deg"),
        (with(strip(), json!({ "caps": "flat" })), "/caps"),
        (with(strip(), json!({ "normals": [[[0, 0, 1]], [[0, 0, 1]]] })), "/normals/0"),
        (with(strip(), json!({ "sampling": { "by": "arc_length" } })), "/sampling/samples"),
        (with(strip(), json!({ "sampling": { "by": "chord_height" } })), "/sampling/tolerance"),
        (with(strip(), json!({ "sampling": { "by": "parameter", "samples": 1 } })), "/sampling/samples"),
        (
            with(strip(), json!({ "sampling": { "by": "parameter", "samples": 5, "tolerance": 1 } })),
            "/sampling/tolerance",
        ),
        (with(strip(), json!({ "rail_tolerance": -0.1 })), "/rail_tolerance"),
        (with(strip(), json!({ "rail_tolerance": 1 })), "/rail_tolerance"),
        (
            with(strip(), json!({ "rail_tolerance": 0.1, "objective": { "weights": { "minimal_area": 1 } } })),
            "/rail_tolerance",
        ),
        (with(strip(), json!({ "rail_ends": "fixed" })), "/rail_ends"),
        (with(rings(), json!({ "rail_ends": "fixed", "rail_tolerance": 0.1 })), "/rail_ends"),
        (with(rings(), json!({ "caps": "flat", "rail_tolerance": 0.1 })), "/rail_tolerance"),
    ];
    for (body, pointer) in cases {
        let problem = problem(app.post(RULED, &body).await, 422).await;
        assert_eq!(pointers(&problem)[0], pointer, "{body}");
    }
    let huge = with(strip(), json!({ "sampling": { "by": "parameter", "samples": 10_000_000 } }));
    assert_eq!(pointers(&problem(app.post(RULED, &huge).await, 413).await), ["/sampling/samples"]);
    // The search of these rails is allowed, but not the searches for rails that move.
    let moving = with(large_strip(10_000), json!({ "rail_tolerance": 0.01 }));
    assert_eq!(pointers(&problem(app.post(RULED, &moving).await, 413).await), ["/rail_tolerance"]);
    let mut bent = ring(12, 0.0);
    bent[3][2] = 0.5;
    let capped = json!({ "directrices": [bent, ring(9, 1.0)], "closed": true, "caps": "flat" });
    assert_eq!(pointers(&problem(app.post(RULED, &capped).await, 422).await), ["/directrices/0/3"]);
    // Errors that only the solver can find are errors of the job.
    let mut crossed = ring(12, 0.0);
    crossed.swap(3, 7);
    let body = json!({ "directrices": [crossed, ring(9, 1.0)], "closed": true, "caps": "flat" });
    let job: Value = app.post_waiting(RULED, &body).await.json().await.unwrap();
    assert_eq!(
        (job["status"].as_str(), job["error"]["errors"][0]["pointer"].as_str()),
        (Some("failed"), Some("/directrices/0"))
    );
}

#[tokio::test]
async fn a_strip_of_a_hundred_million_cells_is_solved_followed_and_cancelled() {
    let app = TestApp::start_with(&[("PLATEAU_JOBS__PROGRESS_INTERVAL_MS", "10"), ("PLATEAU_WORKERS", "1")]).await;
    let body = with(large_strip(10_000), json!({ "objective": "minimal_bending_energy" }));
    let stages = ["first_progress", "half"];
    stages.iter().for_each(|stage| app.hold.at(stage));
    let job: Value = app.post(RULED, &body).await.json().await.unwrap();
    let mut stream = app.get(job["links"]["events"].as_str().unwrap()).await.bytes_stream();
    let mut text = String::new();
    for (number, stage) in stages.into_iter().enumerate() {
        app.hold.reached(stage, job["id"].as_str().unwrap()).await;
        // Each stage comes after a further report of progress.
        while text.matches("event: progress").count() <= number {
            text.push_str(std::str::from_utf8(&stream.next().await.expect("more events").unwrap()).unwrap());
        }
        app.hold.release(stage);
    }
    while let Some(chunk) = stream.next().await {
        text.push_str(std::str::from_utf8(&chunk.unwrap()).unwrap());
    }
    let data: Vec<Value> = text
        .lines()
        .filter_map(|line| line.strip_prefix("data: "))
        .map(|data| serde_json::from_str(data).expect("JSON"))
        .collect();
    let last = data.last().expect("events");
    assert_eq!((last["status"].as_str(), last["statistics"]["triangles"].as_u64()), (Some("succeeded"), Some(19_998)));
    assert_eq!(last["statistics"]["vertices"], 20_000);
    let fractions: Vec<f64> = data.iter().filter_map(|event| event["progress"]["fraction"].as_f64()).collect();
    let on_the_way = fractions.iter().filter(|&&fraction| fraction > 0.0 && fraction < 1.0).count();
    assert!(on_the_way >= 1 && fractions.is_sorted(), "{fractions:?}");

    // The second job is cancelled after its first report of progress, when most of its work is still to be done.
    app.hold.at("first_progress");
    let body = with(large_strip(10_000), json!({ "objective": "minimal_mean_curvature_variation" }));
    let job: Value = app.post(RULED, &body).await.json().await.unwrap();
    app.hold.reached("first_progress", job["id"].as_str().unwrap()).await;
    let answer = app.request(Method::POST, job["links"]["cancel"].as_str().unwrap()).send().await.unwrap();
    assert_eq!(answer.json::<Value>().await.unwrap()["status"], "cancelled");
    let idle = async || app.get("/metrics").await.text().await.unwrap().contains("plateau_jobs_running 0");
    until("the solver has stopped", idle).await;
}
