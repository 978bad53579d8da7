//! The options of minimal surfaces, each through the running server.

use crate::app::{MINIMAL, TestApp, example, pointers, problem};
use serde_json::{Value, json};

async fn solved(app: &TestApp, base: &Value, changes: &Value) -> Value {
    let mut request = base.clone();
    for (name, value) in changes.as_object().unwrap() {
        request[name] = value.clone();
    }
    app.solve(MINIMAL, &request).await["statistics"].clone()
}

#[tokio::test]
async fn every_solver_and_objective_runs_and_says_which_rule_stopped_it() {
    let app = TestApp::start().await;
    let rings = example("two-rings");
    let coarse = json!({ "triangles": 1000 });
    for solver in ["newton", "pinkall_polthier", "vertex_relaxation"] {
        let statistics =
            solved(&app, &rings, &json!({ "solver": solver, "resolution": coarse, "boundary_sampling": "refine" }))
                .await;
        assert_eq!(statistics["solver"], solver);
        assert!(
            (statistics["area"].as_f64().unwrap() / 5.98944 - 1.0).abs() < 3e-3,
            "{solver}: {}",
            statistics["area"]
        );
        assert!(statistics["stop_reason"].is_string() && !statistics["history"].as_array().unwrap().is_empty());
    }
    let dirichlet = solved(&app, &rings, &json!({ "objective": "minimal_dirichlet_energy" })).await;
    assert_eq!(dirichlet["objective"], "minimal_dirichlet_energy");
    let tent = example("tent");
    let curvature =
        json!({ "objective": "minimal_mean_curvature", "resolution": { "interior_vertices": 20 }, "seed": 3 });
    assert_eq!(solved(&app, &tent, &curvature).await["initial_mesh"], "barycentres");
    let staged = json!({ "solver": "vertex_relaxation", "processes": [["laplacian_fairing", "edge_swapping"], ["area_minimising"]],
        "fairing_tolerance": 1e-3, "resolution": { "triangles": 200 } });
    assert!(solved(&app, &tent, &staged).await["area"].as_f64().unwrap() < 67.2);
}

#[tokio::test]
async fn the_rings_carry_the_extrapolated_area_and_a_morse_index() {
    let app = TestApp::start().await;
    let statistics = solved(&app, &example("two-rings"), &json!({})).await;
    let (limit, error) = (&statistics["extrapolated_area"]["area"], &statistics["extrapolated_area"]["error_estimate"]);
    let off = (limit.as_f64().unwrap() - 5.98944).abs();
    assert!(off < 1e-4 && off < error.as_f64().unwrap(), "{limit} is off by {off}, estimated {error}");
    assert_eq!(
        (&statistics["stability"]["stable"], &statistics["stability"]["morse_index"]),
        (&json!(true), &json!(0))
    );
}

#[tokio::test]
async fn rings_too_far_apart_are_told_so_and_two_discs_are_the_best_film() {
    let app = TestApp::start().await;
    let ring = |z: f64| -> Vec<[f64; 3]> {
        (0..48).map(|k| std::f64::consts::TAU * f64::from(k) / 48.0).map(|a| [a.cos(), a.sin(), z]).collect()
    };
    let request =
        json!({ "boundaries": [ring(0.0), ring(1.6)], "topology": "best", "resolution": { "triangles": 800 } });
    let statistics = solved(&app, &request, &json!({})).await;
    assert_eq!(statistics["components"], 2);
    let spanning = &statistics["spanning"];
    assert_eq!(spanning["connected_film_exists"], false);
    // The critical gap over the diameter is 0.6627, so 0.828 of this gap of 1.6.
    let fraction = spanning["largest_gap_fraction"].as_f64().unwrap();
    assert!((fraction - 2.0 * 0.6627 / 1.6).abs() < 0.02, "{fraction}");
}

#[tokio::test]
async fn what_no_mesh_can_have_is_refused_by_name() {
    let app = TestApp::start().await;
    let mut request = example("tent");
    request["processes"] = json!([["edge_swapping"]]);
    request["solver"] = json!("vertex_relaxation");
    assert_eq!(pointers(&problem(app.post(MINIMAL, &request).await, 422).await), ["/processes/0"]);
    request["processes"] = json!([["ironing"]]);
    assert_eq!(pointers(&problem(app.post(MINIMAL, &request).await, 422).await), ["/processes/0/0"]);
}
