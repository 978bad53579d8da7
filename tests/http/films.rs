//! The options of minimal surfaces, each tested on a running server.

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
async fn every_solver_and_objective_runs_and_gives_its_stop_reason() {
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
    let staged = json!({ "solver": "vertex_relaxation",
        "processes": [{ "together": ["laplacian_fairing", "edge_swapping"] }, "area_minimising"],
        "fairing_tolerance": 1e-3, "resolution": { "triangles": 200 } });
    assert!(solved(&app, &tent, &staged).await["area"].as_f64().unwrap() < 67.2);
}

#[tokio::test]
async fn the_statistics_of_the_rings_have_an_extrapolated_area_and_a_morse_index() {
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
async fn rings_too_far_apart_have_no_connected_film_and_two_discs_are_best() {
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
    // The critical gap is 0.6627 of the diameter, which is 0.828 of this gap of 1.6.
    let fraction = spanning["largest_gap_fraction"].as_f64().unwrap();
    assert!((fraction - 2.0 * 0.6627 / 1.6).abs() < 0.02, "{fraction}");
}

#[tokio::test]
async fn impossible_processes_get_an_error_with_their_pointer() {
    let app = TestApp::start().await;
    let mut request = example("tent");
    request["solver"] = json!("vertex_relaxation");
    // Edge swapping may stand alone.
    request["processes"] = json!([{ "together": ["edge_swapping"] }]);
    assert!(solved(&app, &request, &json!({})).await["triangles"].as_u64() > Some(0));
    request["processes"] = json!(["ironing"]);
    assert_eq!(pointers(&problem(app.post(MINIMAL, &request).await, 422).await), ["/processes/0"]);
}

#[tokio::test]
async fn rings_of_radius_10_stay_connected_at_height_12_and_pinch_at_height_14() {
    let app = TestApp::start().await;
    // Area of two regular 36-gons in circles of radius 10.
    let two_discs = 3600.0 * 10f64.to_radians().sin();
    let near = solved(&app, &example("rings-12-free"), &json!({})).await;
    assert_eq!((&near["components"], &near["pinches"]), (&json!(1), &json!([])));
    assert!((near["area"].as_f64().unwrap() - 699.5).abs() < 1.0 && near["stability"]["stable"] == true);
    // The catenoid is the second of the two candidates, and it is stable.
    let best = solved(&app, &example("rings-12-best"), &json!({})).await;
    assert!((best["area"].as_f64().unwrap() - two_discs).abs() < 1e-3);
    let catenoid = &best["spanning"]["topologies"][1];
    assert_eq!((&catenoid["films"], &catenoid["stability"]["stable"]), (&json!([[0, 1]]), &json!(true)));
    assert!((catenoid["area"].as_f64().unwrap() - 699.5).abs() < 1.0);
    for name in ["rings-14-free", "rings-14-pinkall-polthier"] {
        let far = solved(&app, &example(name), &json!({})).await;
        assert_eq!((&far["components"], &far["degenerate_triangles"]), (&json!(2), &json!(0)), "{name}");
        assert!((far["area"].as_f64().unwrap() - two_discs).abs() < 1e-3, "{name}");
        let [pinch] = &far["pinches"].as_array().unwrap()[..] else { panic!("{}", far["pinches"]) };
        assert!(pinch["what"] == "split" && pinch["iteration"].as_u64().unwrap() > 0, "{pinch}");
        assert!((pinch["place"][2].as_f64().unwrap() - 7.0).abs() < 1.5, "{pinch}");
    }
    let best = solved(&app, &example("rings-14-best"), &json!({})).await;
    let spanning = &best["spanning"];
    assert_eq!((&best["components"], &spanning["connected_film_exists"]), (&json!(2), &json!(false)));
    assert_eq!(spanning["topologies"][1]["area"], json!(null));
    let fraction = spanning["largest_gap_fraction"].as_f64().unwrap();
    assert!((fraction - 0.6627 / 0.7).abs() < 0.005, "{fraction}");
}

#[tokio::test]
async fn the_candidate_of_least_area_is_returned_and_all_areas_are_listed() {
    let app = TestApp::start().await;
    for (name, candidates, films) in [
        // The rings stand symmetrically, so joining rings 0 and 1 gives the same area as joining rings 1 and 2.
        ("three-rings", 5, json!([[0, 1], [2]])),
        ("tetrahedron-loops", 15, json!([[0, 1, 2, 3]])),
        ("nested-loops", 2, json!([[0, 1]])),
    ] {
        let statistics = solved(&app, &example(name), &json!({})).await;
        let topologies = statistics["spanning"]["topologies"].as_array().unwrap();
        assert_eq!((topologies.len(), &topologies[0]["films"]), (candidates, &films), "{name}");
        let area = |k: usize| topologies[k]["area"].as_f64().unwrap_or(f64::INFINITY);
        assert!((1..candidates).all(|k| area(k - 1) <= area(k) * (1.0 + 1e-8)), "{name}");
        assert!((area(0) / statistics["area"].as_f64().unwrap() - 1.0).abs() < 1e-12, "{name}");
        assert!((0..candidates).all(|k| topologies[k]["chosen"] == (k == 0)), "{name}");
    }
}

#[tokio::test]
async fn a_film_with_a_triple_junction_can_be_downloaded_in_every_format() {
    let app = TestApp::start().await;
    let request = example("three-half-circles");
    let job = app.solve(MINIMAL, &request).await;
    let (statistics, junctions) = (&job["statistics"], &job["statistics"]["junctions"]);
    assert_eq!((&statistics["converged"], &statistics["components"]), (&json!(true), &json!(1)));
    assert_eq!(
        (&junctions["sheets"], &junctions["edges"], &junctions["morse_index"]),
        (&json!(3), &json!(16), &json!(0))
    );
    assert!((junctions["length"].as_f64().unwrap() - 2.0).abs() < 1e-9);
    assert!(junctions["largest_deviation_deg"].as_f64().unwrap() < 1e-6);
    let uneven = solved(&app, &example("three-half-circles-uneven"), &json!({})).await["junctions"].clone();
    assert!(uneven["largest_deviation_deg"].as_f64().unwrap() < 0.1, "{uneven}");
    let curve: Vec<usize> = serde_json::from_value(junctions["curves"][0].clone()).unwrap();
    assert_eq!(curve.len(), 17);
    let (vertices, triangles) =
        (statistics["vertices"].as_u64().unwrap() as usize, statistics["triangles"].as_u64().unwrap() as usize);
    let format = async |name: &str| {
        let path = format!("{}?format={name}", job["links"]["mesh"].as_str().unwrap());
        app.get(&path).await.bytes().await.unwrap()
    };
    // OBJ: the curve's vertices are on the diameter from pole to pole, and each occurs once.
    let obj = String::from_utf8(format("obj").await.to_vec()).unwrap();
    let positions: Vec<Vec<f64>> = obj
        .lines()
        .filter_map(|line| line.strip_prefix("v "))
        .map(|line| line.split_whitespace().map(|word| word.parse().unwrap()).collect())
        .collect();
    assert_eq!((positions.len(), obj.lines().filter(|line| line.starts_with("f ")).count()), (vertices, triangles));
    assert!(curve.iter().all(|&v| positions[v][0].abs() < 1e-6 && positions[v][1].abs() < 1e-6));
    let ply = format("ply").await;
    let header = String::from_utf8_lossy(&ply[..400.min(ply.len())]).into_owned();
    assert!(header.contains(&format!("element vertex {vertices}")) && header.contains(&format!("face {triangles}")));
    assert_eq!(format("stl").await.len(), 84 + 50 * triangles);
    // glTF: where three sheets meet, each sheet has its own vertex and normal. The junction is a separate line.
    let gltf: Value = serde_json::from_slice(&format("gltf").await).unwrap();
    let names: Vec<&Value> = gltf["nodes"].as_array().unwrap().iter().map(|node| &node["name"]).collect();
    assert_eq!(names, ["surface", "boundaries", "junctions"]);
    let surface = &gltf["meshes"][0]["primitives"][0];
    for attribute in ["POSITION", "NORMAL", "_MEAN_CURVATURE"] {
        let accessor = surface["attributes"][attribute].as_u64().unwrap() as usize;
        assert_eq!(gltf["accessors"][accessor]["count"], vertices + 2 * curve.len(), "{attribute}");
    }
    // The additional vertices along the junction have colours too.
    let colored: Value = serde_json::from_slice(&format("gltf&colors=mean_curvature").await).unwrap();
    let accessor = colored["meshes"][0]["primitives"][0]["attributes"]["COLOR_0"].as_u64().unwrap() as usize;
    assert_eq!(colored["accessors"][accessor]["count"], vertices + 2 * curve.len());
}

#[tokio::test]
async fn the_least_squares_have_a_tolerance_of_their_own() {
    let app = TestApp::start().await;
    let request = example("helicoid-liu-wang");
    let usual = solved(&app, &request, &json!({})).await;
    assert_eq!((&usual["converged"], &usual["stop_reason"]), (&json!(true), &json!("gradient")));
    let mut of_the_area = request.clone();
    of_the_area["area_tolerance"] = json!(1e-12);
    assert_eq!(pointers(&problem(app.post(MINIMAL, &of_the_area).await, 422).await), ["/area_tolerance"]);
    let sharper = solved(&app, &request, &json!({ "least_squares_tolerance": 1e-12 })).await;
    assert!(sharper["objective_value"].as_f64().unwrap() < 1e-3 * usual["objective_value"].as_f64().unwrap());
}
