//! Uniform meshes over HTTP: statistics, members in the glTF, and errors.

use crate::app::{MINIMAL, TestApp, UNIFORM, example, pointers, problem};
use serde_json::{Value, json};

fn square() -> Value {
    json!([[0, 0, 0], [10, 0, 0], [10, 10, 0], [0, 10, 0]])
}

#[tokio::test]
async fn the_mesh_of_a_square_has_the_rows_of_table_1_and_the_squares_points_first() {
    let app = TestApp::start().await;
    let body = json!({ "domain": { "polygon": square() }, "edge_length": 1, "objective": "most_equal_edges" });
    let job = app.solve(UNIFORM, &body).await;
    let statistics = &job["statistics"];
    assert_eq!(statistics["objective"], "most_equal_edges");
    assert_eq!(statistics["objective_value"], statistics["lattice_edges"]["count"]);
    assert_eq!((&statistics["out_of_range_edges"], &statistics["converged"]), (&json!(0), &json!(true)));
    let least = statistics["edge_lengths"]["min"].as_f64().unwrap();
    let most = statistics["edge_lengths"]["max"].as_f64().unwrap();
    assert!(least > 1.0 - 1e-9 && most < 2.0 + 1e-8, "{least} {most}");
    assert_eq!(statistics["stages"][0]["name"], "plane");
    assert_eq!(statistics["stages"][0]["lattice"]["distinct_lengths"], 1);
    let counts = statistics["valence_histogram"].as_array().unwrap().iter().map(|count| count.as_u64().unwrap());
    assert_eq!(counts.sum::<u64>(), statistics["nodes"].as_u64().unwrap());
    let obj = app.get(&format!("{}?format=obj", job["links"]["mesh"].as_str().unwrap())).await.text().await.unwrap();
    let first = obj.lines().filter(|line| line.starts_with("v ")).take(4).collect::<Vec<_>>();
    assert_eq!(first, ["v 0.0 0.0 0.0", "v 10.0 0.0 0.0", "v 10.0 10.0 0.0", "v 0.0 10.0 0.0"]);
}

#[tokio::test]
async fn warnings_have_their_figures_by_name() {
    let app = TestApp::start().await;
    let warning = |job: &Value, code: &str| -> Value {
        let warnings = job["warnings"].as_array().unwrap();
        warnings.iter().find(|warning| warning["code"] == code).unwrap_or_else(|| panic!("{job:#}")).clone()
    };
    // Corner 2 is 0.01 above the plane of the other three. The plane fitted to the outline passes each corner at a
    // quarter of this height.
    let mut polygon = square();
    polygon[2][2] = json!(0.01);
    let body = json!({ "domain": { "polygon": polygon }, "edge_length": 1, "objective": "most_equal_edges" });
    let projected = warning(&app.solve(UNIFORM, &body).await, "projected");
    let distance = projected["values"]["distance"].as_f64().unwrap();
    assert!((0.0024..0.0026).contains(&distance), "{projected}");

    let corners = json!([[0, 0, 0], [1, 0, 1], [1, 1, 0], [0, 1, 1]]);
    let body = json!({ "boundaries": [corners], "solver": "vertex_relaxation", "area_tolerance": 1e-2 });
    let job = app.solve(MINIMAL, &body).await;
    let residual = &job["statistics"]["residual"];
    assert_eq!(warning(&job, "not_minimal")["values"], json!({ "residual": residual, "tolerance": 1e-6 }));
}

#[tokio::test]
async fn members_have_their_lengths_and_lattice_and_rim_have_separate_materials() {
    let app = TestApp::start().await;
    let job = app.solve(UNIFORM, &example("latticed-roof")).await;
    let document = app.get_json(&format!("{}?format=gltf", job["links"]["mesh"].as_str().unwrap())).await;
    let statistics = &job["statistics"];
    let lattice = statistics["lattice_edges"]["count"].as_u64().unwrap();
    let rim = statistics["edges"].as_u64().unwrap() - lattice;
    let mut materials = Vec::new();
    for (name, count) in [("members lattice", lattice), ("members rim", rim)] {
        let mesh = document["meshes"].as_array().unwrap().iter().find(|mesh| mesh["name"] == name).expect(name);
        let primitive = &mesh["primitives"][0];
        // Mode 1 is LINES. Each member has two ends, and both carry the member's length.
        assert_eq!(primitive["mode"], 1);
        let lengths = &document["accessors"][primitive["attributes"]["_LENGTH"].as_u64().unwrap() as usize];
        assert_eq!(lengths["count"].as_u64().unwrap(), 2 * count);
        materials.push(primitive["material"].as_u64().unwrap());
    }
    assert_ne!(materials[0], materials[1]);
}

#[tokio::test]
async fn each_wrong_value_gets_an_error_with_its_pointer() {
    let app = TestApp::start().await;
    let mut warped = square();
    warped[2][2] = json!(1);
    let bezier = json!({ "control_points": [[[0, 0, 0], [0, 5, 1]], [[5, 0, 1], [5, 5, 0]]] });
    let nurbs = |extra: Value| {
        let mut nurbs = json!({ "degrees": [1, 1], "knots": [[0, 0, 1, 1], [0, 0, 1, 1]],
            "control_points": bezier["control_points"] });
        nurbs.as_object_mut().unwrap().extend(extra.as_object().unwrap().clone());
        json!({ "nurbs": nurbs })
    };
    let with = |domain: Value| json!({ "domain": domain, "edge_length": 1 });
    let asks = |extra: Value| {
        let mut body = with(json!({ "polygon": square() }));
        body.as_object_mut().unwrap().extend(extra.as_object().unwrap().clone());
        body
    };
    let cases = [
        (json!({}), vec!["/domain", "/edge_length"]),
        (with(json!({})), vec!["/domain"]),
        (with(json!({ "holes": [square()] })), vec!["/domain"]),
        (with(json!({ "polygon": square(), "bezier": bezier })), vec!["/domain"]),
        (with(json!({ "bezier": bezier, "holes": [square()] })), vec!["/domain/holes"]),
        (with(json!({ "polygon": [[0, 0, 0], [1, 0, 0]] })), vec!["/domain/polygon"]),
        (with(json!({ "polygon": [[0, 0, 0], [1, 0, 0], [2, 0, 0]] })), vec!["/domain/polygon"]),
        (with(json!({ "polygon": warped })), vec!["/domain/polygon/0"]),
        (with(json!({ "boundaries": [[[0, 0, 0], [1, 1, 1], [0, 0, 0]]] })), vec!["/domain/boundaries/0"]),
        (with(nurbs(json!({ "trim_curves": [[[0, 0], [1, 0], [0, 1]]] }))), vec!["/domain/nurbs/trim_curves"]),
        (with(nurbs(json!({ "knots": [[0, 0, 1], [0, 0, 1, 1]] }))), vec!["/domain/nurbs/knots/0"]),
        (with(nurbs(json!({ "weights": [[1, 1], [1, 0]] }))), vec!["/domain/nurbs/weights/1/1"]),
        (asks(json!({ "edge_length": 0 })), vec!["/edge_length"]),
        (asks(json!({ "objective": "prettiest" })), vec!["/objective"]),
        (asks(json!({ "auxiliary_grid": [15, 1] })), vec!["/auxiliary_grid/1"]),
        (asks(json!({ "optimise": "lengths" })), vec!["/max_distinct_lengths"]),
        (asks(json!({ "max_distinct_lengths": 3 })), vec!["/max_distinct_lengths"]),
        (
            asks(json!({ "optimise": "lengths", "max_distinct_lengths": 3, "optimise_nodes": false })),
            vec!["/optimise_nodes", "/optimise"],
        ),
    ];
    for (body, expected) in cases {
        let problem = problem(app.post(UNIFORM, &body).await, 422).await;
        assert_eq!(pointers(&problem), expected, "{body}");
    }
    let problem = problem(app.post(UNIFORM, &asks(json!({ "edge_length": 1e-4 }))).await, 413).await;
    assert_eq!(pointers(&problem), ["/edge_length"]);
}

#[tokio::test]
async fn a_polygon_that_crosses_itself_fails_with_a_pointer() {
    let app = TestApp::start().await;
    let bow_tie = json!([[0, 0, 0], [4, 4, 0], [4, 0, 0], [0, 7, 0]]);
    let body = json!({ "domain": { "polygon": bow_tie }, "edge_length": 1 });
    let response = app.post_waiting(UNIFORM, &body).await;
    let job: Value = response.json().await.unwrap();
    assert_eq!(job["status"], "failed");
    let pointer = job["error"]["errors"][0]["pointer"].as_str().unwrap();
    assert!(pointer.starts_with("/domain/polygon/"), "{job}");
}

#[tokio::test]
async fn a_domain_needs_only_an_edge_length_and_units_do_not_change_the_statistics() {
    let app = TestApp::start().await;
    let in_metres = json!({ "domain": { "polygon": square() }, "edge_length": 2 });
    let in_feet = json!({ "domain": { "polygon": square() }, "edge_length": 2, "units": "ft", "up": "y" });
    let [metres, feet] = [app.solve(UNIFORM, &in_metres).await, app.solve(UNIFORM, &in_feet).await];
    assert_eq!(metres["statistics"], feet["statistics"]);
    assert_eq!(metres["statistics"]["objective"], "most_equal_edges");
}

/// Rebuilds Katoh, Ohsaki and Xu's Table 1 row by row on the committed roofs and film; `--nocapture` prints it. Their
/// optimisation takes the lattice group's deviation from 0.2780 to 0.1915 (0.69) and its range from 1.9929 to 1.0492
/// (0.53). It has 774 of 954 members in the group, and one member of the rim is stretched to 13.4. Our optimisation
/// must do as well with every rim member in [5, 10].
#[tokio::test]
async fn table_1_is_rebuilt_on_roofs_and_film() {
    let app = TestApp::start().await;
    for name in ["latticed-roof", "latticed-roof-steep", "latticed-film"] {
        let statistics = app.solve(UNIFORM, &example(name)).await["statistics"].clone();
        let rows = statistics["stages"].as_array().unwrap();
        let names: Vec<&str> = rows.iter().map(|row| row["name"].as_str().unwrap()).collect();
        assert_eq!(names, ["auxiliary_surface", "auxiliary_plane", "plane", "surface", "optimised_nodes"], "{name}");
        let figure = |row: &str, group: &str, field: &str| {
            let row = rows.iter().find(|candidate| candidate["name"] == row).unwrap();
            row[group][field].as_f64().unwrap()
        };
        println!("{name}");
        for (row, group) in names.iter().flat_map(|&row| [(row, "lattice"), (row, "all")]) {
            if group == "all" || !row.starts_with("auxiliary") {
                let [count, mean, min, max, deviation] =
                    ["count", "mean", "min", "max", "std_dev"].map(|field| figure(row, group, field));
                println!("  {row:18} {group:8} {count:6} {mean:8.4} {min:8.4} {max:8.4} {deviation:8.4}");
            }
        }
        let range = |row| figure(row, "lattice", "max") - figure(row, "lattice", "min");
        let (before, after) =
            (figure("surface", "lattice", "std_dev"), figure("optimised_nodes", "lattice", "std_dev"));
        let narrower = range("optimised_nodes") / range("surface");
        let share = figure("optimised_nodes", "lattice", "count") / figure("optimised_nodes", "all", "count");
        let planar_share = figure("plane", "lattice", "count") / figure("plane", "all", "count");
        let smallest_angle = statistics["angles_deg"]["min"].as_f64().unwrap();
        println!(
            "  deviation {:.4}, range {narrower:.4}, share {share:.4}, angles from {smallest_angle:.1}",
            after / before
        );
        assert!(before >= 0.28, "{name}: {before} is too even to begin with");
        assert!(after <= 0.69 * before && narrower <= 0.53, "{name}: {before} -> {after}, range {narrower}");
        assert!(share.min(planar_share) >= 774.0 / 954.0, "{name}: share {share}, in the plane {planar_share}");
        assert!((figure("plane", "lattice", "max") - 5.0).abs() < 1e-9 && figure("plane", "lattice", "std_dev") < 1e-9);
        if name == "latticed-roof" {
            assert!((925.0..=975.0).contains(&figure("optimised_nodes", "all", "count")), "about 950 members");
        }
        // No member is too long. Members below 5 occur only where the surface is too curved for the lattice.
        assert!(figure("optimised_nodes", "all", "max") <= 10.0 * (1.0 + 1e-8) && smallest_angle > 20.0, "{name}");
        let out = statistics["out_of_range"].as_array().unwrap();
        assert!(out.iter().all(|edge| edge["why"] == "curvature" && edge["length"].as_f64().unwrap() < 5.0), "{name}");
    }
}
