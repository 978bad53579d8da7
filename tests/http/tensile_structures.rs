//! Tensile structures over HTTP: forces in statistics and glTF, warnings, and errors.

use crate::app::{TENSILE, TestApp, example, pointers, problem};
use serde_json::{Value, json};

fn square() -> Value {
    json!([[0, 0, 0], [10, 0, 0], [10, 10, 0], [0, 10, 0]])
}

fn edge(from: u32, extra: Value) -> Value {
    let mut cable = json!({ "along": { "from": from, "to": (from + 1) % 4 }, "mode": "force", "value": 10 });
    cable.as_object_mut().unwrap().extend(extra.as_object().unwrap().clone());
    cable
}

fn sail(extra: Value) -> Value {
    let cables: Vec<Value> = (0..4).map(|k| edge(k, json!({}))).collect();
    let mut body = json!({
        "boundaries": [square()], "film": { "tension": 1 }, "cables": cables, "resolution": { "triangles": 400 }
    });
    body.as_object_mut().unwrap().extend(extra.as_object().unwrap().clone());
    body
}

#[tokio::test]
async fn a_plane_sail_has_the_forces_that_were_asked_for_and_balanced_reactions() {
    let app = TestApp::start().await;
    let job = app.solve(TENSILE, &example("plane-sail")).await;
    let statistics = &job["statistics"];
    assert_eq!((&statistics["objective"], &statistics["converged"]), (&json!("equilibrium"), &json!(true)));
    assert_eq!(statistics["force_unit"], "kN");
    assert_eq!(statistics["cables"][0]["name"], "edge 1");
    let number = |value: &Value| value.as_f64().unwrap();
    // The cables are arcs of radius 10 over chords of length 10.
    assert!((number(&statistics["area"]) - 63.765571).abs() < 0.05, "{statistics}");
    for cable in statistics["cables"].as_array().unwrap() {
        assert!((number(&cable["force"]) - 10.0).abs() < 1e-6);
        assert!((number(&cable["length"]) - 10.471976).abs() < 1e-3);
        assert!((number(&cable["sag"]) - 1.339746).abs() < 1e-2);
    }
    assert_eq!(statistics["reactions"].as_array().unwrap().len(), 4);
    assert!(number(&statistics["balance"]["imbalance"]) < 1e-9);
    assert_eq!(statistics["stability"]["stable"], true);
    assert_eq!(job["warnings"], json!([]));
}

#[tokio::test]
async fn cables_and_reactions_are_lines_with_their_forces() {
    let app = TestApp::start().await;
    let job = app.solve(TENSILE, &example("four-point-sail")).await;
    let mesh = job["links"]["mesh"].as_str().unwrap();
    let document = app.get_json(&format!("{mesh}?format=gltf")).await;
    let named = |name: &str| {
        let meshes = document["meshes"].as_array().unwrap();
        meshes.iter().find(|mesh| mesh["name"] == name).unwrap_or_else(|| panic!("{name}"))["primitives"][0].clone()
    };
    for name in ["cables south", "cables east", "cables north", "cables west", "reactions"] {
        let primitive = named(name);
        assert_eq!(primitive["mode"], 1, "{name}");
        let forces = &document["accessors"][primitive["attributes"]["_FORCE"].as_u64().unwrap() as usize];
        let positions = &document["accessors"][primitive["attributes"]["POSITION"].as_u64().unwrap() as usize];
        assert_eq!(forces["count"], positions["count"], "{name}");
    }
    let reactions = &document["accessors"][named("reactions")["attributes"]["_FORCE"].as_u64().unwrap() as usize];
    assert_eq!(reactions["count"], 8);
    let node = document["nodes"].as_array().unwrap().iter().find(|node| node["name"] == "reactions").unwrap();
    assert_eq!(node["extras"]["_FORCE"]["unit"], "kN");
    let obj = app.get(&format!("{mesh}?format=obj")).await.text().await.unwrap();
    let vertices = obj.lines().filter(|line| line.starts_with("v ")).count() as u64;
    let largest = obj.lines().filter_map(|line| line.strip_prefix("l ")).flat_map(|line| line.split(' '));
    assert_eq!(largest.map(|index| index.parse::<u64>().unwrap()).max(), Some(vertices));
}

#[tokio::test]
async fn a_film_slides_on_a_ring_beam_and_states_the_force_along_its_edges() {
    let app = TestApp::start().await;
    let ring = |count: u32, radius: f64, height: f64| -> Vec<[f64; 3]> {
        let angle = |k: u32| f64::from(k) * std::f64::consts::TAU / f64::from(count);
        (0..count).map(|k| [radius * angle(k).cos(), radius * angle(k).sin(), height]).collect()
    };
    let body = json!({
        "boundaries": [ring(32, 1.3, 0.8), ring(32, 1.0, 0.0)],
        "film": { "tension": 2 },
        "supports": [{
            "boundary": 1,
            "on": { "torus": { "centre": [0, 0, -0.3], "axis": [0, 0, 5], "radius": 1, "tube_radius": 0.3 } }
        }],
        "resolution": { "triangles": 800 }
    });
    let job = app.solve(TENSILE, &body).await;
    let statistics = &job["statistics"];
    assert_eq!(statistics["converged"], true, "{job}");
    let number = |pointer: &str| statistics.pointer(pointer).and_then(Value::as_f64).unwrap();
    for pointer in ["/edge_reactions/0/force_per_length/min", "/edge_reactions/1/force_per_length/max"] {
        assert!((number(pointer) - 2.0).abs() < 0.02, "{pointer}: {statistics}");
    }
    assert!((number("/contact_angle_deg/max") - 90.0).abs() < 1e-3, "{statistics}");
    // The reactions have an arrow for each vertex of both held edges, and each segment of these edges has a force per
    // length.
    let mesh = app.get_json(&format!("{}?format=json", job["links"]["mesh"].as_str().unwrap())).await;
    let lines = |name: &str| mesh["lines"].as_array().unwrap().iter().find(|set| set["name"] == name).unwrap().clone();
    let (held, arrows) = (lines("held edges"), lines("reactions"));
    let count = held["paths"].as_array().unwrap().len();
    assert!(count >= 64 && arrows["arrows"].as_array().unwrap().len() == count, "{count} {arrows}");
    assert_eq!(held["values"]["name"], "force_per_length");
    assert_eq!(held["values"]["unit"], "kN/m");
}

#[tokio::test]
#[expect(clippy::too_many_lines, reason = "a list of refused structures")]
async fn each_wrong_value_gets_an_error_with_its_pointer() {
    let app = TestApp::start().await;
    let cable = |extra: Value| sail(json!({ "cables": [edge(0, extra)] }));
    let woven = |extra: Value| {
        let mut film = json!({ "warp": 2, "weft": 1, "direction": { "parallel": [1, 0, 0] } });
        film.as_object_mut().unwrap().extend(extra.as_object().unwrap().clone());
        sail(json!({ "film": film }))
    };
    let circle: Vec<Value> = (0..32)
        .map(|k| f64::from(k) * std::f64::consts::TAU / 32.0)
        .map(|angle| json!([5.0 * angle.cos(), 5.0 * angle.sin(), 0]))
        .collect();
    let disc = |extra: Value| {
        let mut body = json!({ "boundaries": [circle], "film": { "tension": 1 } });
        body.as_object_mut().unwrap().extend(extra.as_object().unwrap().clone());
        body
    };
    let air = |extra: Value| {
        let mut cable = json!({ "points": [[0, 0, 5], [3, 0, 5]], "value": 1 });
        cable.as_object_mut().unwrap().extend(extra.as_object().unwrap().clone());
        sail(json!({ "cables": [cable] }))
    };
    // The sail on two corners turns about the line between them. The cables run from corner 0 to corner 2 and back.
    let half = |from: u32, to: u32| json!({ "along": { "from": from, "to": to }, "value": 10 });
    let turning = sail(json!({ "cables": [half(0, 2), half(2, 0)] }));
    let sliding =
        |on: Value| sail(json!({ "supports": [{ "along": { "from": 0, "to": 2 }, "on": on }], "cables": [] }));
    let floor = |triangles: Value, height: f64, rounding: f64| {
        let at = |x: i32, y: i32| json!([x, y, height]);
        let vertices = [at(-1, -1), at(11, -1), at(11, 11), at(-1, 11)];
        sliding(json!({ "mesh": { "vertices": vertices, "triangles": triangles, "rounding": rounding } }))
    };
    let meshed = |triangles: Value| floor(triangles, 0.0, 1.0);
    let leaning = |angle: f64| {
        let mut body = sliding(json!({ "plane": { "point": [0, 0, 0], "normal": [0, 0, 1] } }));
        body["supports"][0]["contact_angle_deg"] = json!(angle);
        body
    };
    let mut leaning_on_a_mesh = meshed(json!([[0, 1, 2], [0, 2, 3]]));
    leaning_on_a_mesh["supports"][0]["contact_angle_deg"] = json!(60);
    let beam = |tube_radius: f64, axis: Value| {
        sliding(json!({ "torus": { "centre": [0, 0, 0], "axis": axis, "radius": 2, "tube_radius": tube_radius } }))
    };
    let cases = [
        (beam(2.0, json!([0, 0, 1])), vec!["/supports/0/on/torus/tube_radius"]),
        (beam(0.0, json!([0, 0, 1])), vec!["/supports/0/on/torus/tube_radius"]),
        (beam(0.5, json!([0, 0, 0])), vec!["/supports/0/on/torus/axis"]),
        (beam(0.5, json!([0, 0, 2])), vec!["/boundaries/0/1"]),
        (turning, vec!["/boundaries/0/1", "/boundaries/0/3"]),
        (meshed(json!([])), vec!["/supports/0/on/mesh/triangles"]),
        (meshed(json!([[0, 1, 2], [0, 2, 4]])), vec!["/supports/0/on/mesh/triangles/1/2"]),
        (meshed(json!([[0, 1, 2], [0, 2, 2]])), vec!["/supports/0/on/mesh/triangles/1"]),
        (meshed(json!([[0, 1, 2], [2, 0, 3]])), vec!["/supports/0/on/mesh/triangles/1"]),
        (floor(json!([[0, 1, 2], [0, 2, 3]]), 0.0, 0.0), vec!["/supports/0/on/mesh/rounding"]),
        (floor(json!([[0, 1, 2], [0, 2, 3]]), 2.0, 1.0), vec!["/boundaries/0/1"]),
        (leaning_on_a_mesh, vec!["/supports/0/contact_angle_deg"]),
        (leaning(0.0), vec!["/supports/0/contact_angle_deg"]),
        (leaning(180.0), vec!["/supports/0/contact_angle_deg"]),
        (sliding(json!({ "plane": { "point": [0, 0, 1], "normal": [0, 0, 1] } })), vec!["/boundaries/0/1"]),
        (json!({}), vec!["/boundaries"]),
        (json!({ "boundaries": [[[0, 0, 0], [1, 0, 0], [1, 1, 0]]] }), vec!["/film"]),
        (cushion(json!({ "film": { "tension": 1 } })), vec!["/layers"]),
        (cushion(json!({ "layers": [{ "tension": 1 }] })), vec!["/layers"]),
        (cushion(json!({ "layers": [{ "tension": 1 }, {}] })), vec!["/layers/1/tension"]),
        (cushion(json!({ "layers": [{ "tension": 1 }, { "tension": 0 }] })), vec!["/layers/1/tension"]),
        (cushion(json!({ "pressure": 0.1 })), vec!["/pressure"]),
        (cushion(json!({ "chambers": [] })), vec!["/chambers"]),
        (cushion(json!({ "chambers": [{}] })), vec!["/chambers/0"]),
        (cushion(json!({ "chambers": [{ "volume": 1, "pressure": 1 }] })), vec!["/chambers/0"]),
        (cushion(json!({ "chambers": [{ "volume": 0 }] })), vec!["/chambers/0/volume"]),
        (cushion(json!({ "chambers": [{ "below": 2, "volume": 1 }] })), vec!["/chambers/0/below", "/chambers"]),
        (cushion(json!({ "chambers": [{ "pressure": 0.41 }] })), vec!["/chambers/0/pressure"]),
        (cushion(json!({ "chambers": [{ "pressure": -0.1 }] })), vec!["/chambers/0/pressure"]),
        (sail(json!({ "chambers": [{ "volume": 1 }] })), vec!["/chambers"]),
        (sail(json!({ "film": {} })), vec!["/film/tension"]),
        (sail(json!({ "film": { "tension": 0 } })), vec!["/film/tension"]),
        (sail(json!({ "film": { "tension": 1, "warp": 2 } })), vec!["/film/tension"]),
        (sail(json!({ "film": { "tension": 1, "hold": "ratio" } })), vec!["/film/tension"]),
        (sail(json!({ "film": { "warp": 2 } })), vec!["/film/weft", "/film/direction"]),
        (woven(json!({ "hold": "stress" })), vec!["/film/hold"]),
        (woven(json!({ "warp": -1 })), vec!["/film/warp"]),
        (woven(json!({ "weft": 1000 })), vec!["/film/weft"]),
        (woven(json!({ "direction": {} })), vec!["/film/direction"]),
        (woven(json!({ "direction": { "parallel": [0, 0, 0] } })), vec!["/film/direction/parallel"]),
        (
            woven(json!({ "direction": { "radial": { "point": [0, 0, 0], "axis": [0, 0, 0] } } })),
            vec!["/film/direction/radial/axis"],
        ),
        (woven(json!({ "direction": { "along": [[0, 0, 0], [0, 0, 0]] } })), vec!["/film/direction/along"]),
        (sail(json!({ "rings": [{ "boundary": 0, "axis": [0, 0, 0] }] })), vec!["/rings/0/axis"]),
        (sail(json!({ "rings": [{ "boundary": 1, "axis": [0, 0, 1] }] })), vec!["/rings/0/boundary"]),
        (sail(json!({ "rings": [{ "boundary": 0, "axis": [0, 0, 1] }] })), vec!["/rings/0/boundary"]),
        (sail(json!({ "joints": [[5, 5, 3]] })), vec!["/joints/0"]),
        (sail(json!({ "joints": [[0, 0, 0]] })), vec!["/joints/0"]),
        (sail(json!({ "masts": [{ "points": [[0, 0, 0], [0, 0, 5]], "value": 5 }] })), vec!["/masts/0/points"]),
        (sail(json!({ "masts": [{ "points": [[0, 0, 0], [0, 0, 5]], "value": 0 }] })), vec!["/masts/0/value"]),
        (
            sail(json!({ "masts": [{ "points": [[0, 0, 0], [0, 0, 5]], "value": 5, "mode": "sag" }] })),
            vec!["/masts/0/mode"],
        ),
        (sail(json!({ "film": { "tension": 1, "weight": -1 } })), vec!["/film/weight"]),
        (sail(json!({ "units": "m" })), vec!["/units"]),
        (sail(json!({ "units": { "length": "kN" } })), vec!["/units/length"]),
        (sail(json!({ "units": { "force": "m" } })), vec!["/units/force"]),
        (cable(json!({ "mode": "tension" })), vec!["/cables/0/mode"]),
        (cable(json!({ "value": 0 })), vec!["/cables/0/value"]),
        (cable(json!({ "points": [[0, 0, 5], [3, 0, 5]] })), vec!["/cables/0"]),
        (cable(json!({ "mode": "length", "value": 9.9 })), vec!["/cables/0/value"]),
        (cable(json!({ "mode": "unstressed_length", "value": 9.9 })), vec!["/cables/0/axial_stiffness"]),
        (cable(json!({ "along": { "boundary": 1, "from": 0, "to": 1 } })), vec!["/cables/0/along/boundary"]),
        (cable(json!({ "along": { "from": 0, "to": 4 } })), vec!["/cables/0/along/to"]),
        (cable(json!({ "along": { "from": 2, "to": 2 } })), vec!["/cables/0/along/to"]),
        (sail(json!({ "cables": [edge(0, json!({})), edge(0, json!({}))] })), vec!["/cables/1/along"]),
        (air(json!({ "mode": "sag" })), vec!["/cables/0/value"]),
        (air(json!({ "mode": "length", "value": 4 })), vec!["/cables/0/value"]),
        (air(json!({ "points": [[0, 0, 5], [0, 0, 5]] })), vec!["/cables/0/points"]),
        (sail(json!({ "free_points": [{ "point": 4 }] })), vec!["/free_points/0/point"]),
        (sail(json!({ "cables": [], "free_points": [{ "point": 1 }] })), vec!["/free_points/0"]),
        (sail(json!({ "pressure": 0.1 })), vec!["/pressure"]),
        (disc(json!({ "pressure": 0.1, "volume": 3 })), vec!["/volume"]),
        (disc(json!({ "pressure": 0.5 })), vec!["/pressure"]),
        (disc(json!({ "volume": 0 })), vec!["/volume"]),
        (disc(json!({ "resolution": { "edge_length": 1e-9 } })), vec!["/resolution"]),
    ];
    for (body, expected) in cases {
        let response = app.post(TENSILE, &body).await;
        let status = if expected == ["/resolution"] { 413 } else { 422 };
        assert_eq!(pointers(&problem(response, status).await), expected, "{body}");
    }
    // The error for a pressure that is too high names the limit, which is 2 σ / r for a disc.
    let refused = problem(app.post(TENSILE, &disc(json!({ "pressure": 0.5 }))).await, 422).await;
    assert!(refused["errors"][0]["detail"].as_str().unwrap().contains("0.40"), "{refused}");
}

#[tokio::test]
async fn an_edge_slides_on_a_mesh_and_meets_a_plane_at_a_given_angle() {
    let app = TestApp::start().await;
    let solved = async |support: Value| {
        let mut body = example("film-on-a-plane");
        body["supports"][0].as_object_mut().unwrap().extend(support.as_object().unwrap().clone());
        let job = app.solve(TENSILE, &body).await;
        assert_eq!(job["statistics"]["converged"], true, "{job}");
        let number = |value: &Value| value.as_f64().unwrap();
        let angle = &job["statistics"]["contact_angle_deg"];
        (number(&job["statistics"]["area"]), number(&angle["min"]), number(&angle["max"]))
    };
    let (plane, ..) = solved(json!({})).await;
    // The same plane as a mesh of two triangles.
    let vertices = json!([[-9, -9, 0], [9, -9, 0], [9, 9, 0], [-9, 9, 0]]);
    let mesh = json!({ "vertices": vertices, "triangles": [[0, 1, 2], [0, 2, 3]], "rounding": 1 });
    let (area, least, most) = solved(json!({ "on": { "mesh": mesh } })).await;
    assert!((area / plane - 1.0).abs() < 1e-9, "{area} {plane}");
    assert!((least - 90.0).abs() < 1e-6 && (most - 90.0).abs() < 1e-6, "{least} {most}");
    // The edge runs counter-clockwise, so that the film leans inward at less than a right angle.
    let (area, least, most) = solved(json!({ "contact_angle_deg": 70 })).await;
    assert!((least - 70.0).abs() < 0.1 && (most - 70.0).abs() < 0.1, "{least} {most}");
    assert!((area / plane - 1.0).abs() > 0.01, "{area} {plane}");
}

#[tokio::test]
async fn a_conic_tent_reports_its_weave_its_mast_and_its_ring() {
    let app = TestApp::start().await;
    let job = app.solve(TENSILE, &example("conic-tent")).await;
    let statistics = &job["statistics"];
    assert_eq!(statistics["converged"], true, "{job}");
    let number = |value: &Value| value.as_f64().unwrap();
    let weave = &statistics["stress"]["weave"];
    assert_eq!((&weave["hold"], &weave["required_ratio"]), (&json!("ratio"), &json!(0.5)));
    assert!((number(&weave["ratio"]["mean"]) - 0.5).abs() < 0.02, "{weave}");
    let mast = &statistics["masts"][0];
    assert_eq!((&mast["name"], &mast["mode"]), (&json!("mast"), &json!("length")));
    assert!((number(&mast["length"]) - 3.2).abs() < 1e-6 && number(&mast["force"]) > 1.0, "{mast}");
    assert!((number(&statistics["rings"][0]["travel"]) - 0.4).abs() < 1e-6, "{statistics}");
    assert!(number(&statistics["balance"]["imbalance"]) < 1e-9);
    assert_eq!(statistics["stability"], Value::Null);
    assert_eq!(statistics["self_intersections"], 0);
    let mesh = job["links"]["mesh"].as_str().unwrap();
    let document = app.get_json(&format!("{mesh}?format=gltf")).await;
    assert!(
        document["meshes"].as_array().unwrap().iter().any(|mesh| mesh["name"] == "masts mast"),
        "a line of its own"
    );
}

#[tokio::test]
async fn stresses_that_cannot_be_in_equilibrium_are_returned_with_a_warning() {
    let app = TestApp::start().await;
    let mut body = example("conic-tent");
    body["film"]["hold"] = json!("magnitudes");
    body["resolution"] = json!({ "triangles": 800 });
    let job = app.solve(TENSILE, &body).await;
    assert_eq!(job["warnings"][0]["code"], "stress_deviates", "{job}");
    assert!(job["statistics"]["stress"]["weave"]["deviation_rms"].as_f64().unwrap() > 0.05);
    assert!(job["statistics"]["balance"]["imbalance"].as_f64().unwrap() < 1e-9);
}

#[tokio::test]
async fn a_cable_of_given_length_that_would_be_slack_fails_by_its_pointer() {
    let app = TestApp::start().await;
    let body = json!({
        "boundaries": [[[0, 0, 0], [5, 0, 0], [10, 0, 0], [10, 10, 0], [5, 10, 0], [0, 10, 0]]],
        "film": { "tension": 1 }, "resolution": { "triangles": 300 },
        "cables": [{ "name": "valley", "across": [[5, 0, 0], [5, 10, 0]], "mode": "length", "value": 11 }]
    });
    let posted = app.post(TENSILE, &body).await;
    let job = app.ended(posted.json().await.unwrap()).await;
    assert_eq!((&job["status"], &job["error"]["type"]), (&json!("failed"), &json!("/problems/slack-cable")), "{job}");
    assert_eq!(job["error"]["errors"][0]["pointer"], "/cables/0/value");
    assert!(job["error"]["detail"].as_str().unwrap().contains("valley"), "{job}");
}

/// Returns a cushion of two films over a square of side 10. A film of tension 1 over this square holds a pressure
/// difference of at most 0.4: the tension times the perimeter, divided by the area.
fn cushion(changes: Value) -> Value {
    let mut body = json!({
        "boundaries": [[[0, 0, 0], [10, 0, 0], [10, 10, 0], [0, 10, 0]]],
        "layers": [{ "tension": 1 }, { "tension": 1 }], "chambers": [{ "below": 0, "volume": 30 }],
        "resolution": { "triangles": 300 }
    });
    for (name, value) in changes.as_object().unwrap() {
        body[name] = value.clone();
    }
    body
}

#[tokio::test]
async fn a_cushion_keeps_its_volume_and_has_a_pressure() {
    let app = TestApp::start().await;
    let job = app.solve(TENSILE, &example("cushion")).await;
    assert_eq!(job["warnings"], json!([]), "{job}");
    let statistics = &job["statistics"];
    assert_eq!(statistics["converged"], true, "{statistics}");
    let chamber = &statistics["chambers"][0];
    assert!((chamber["volume"].as_f64().unwrap() - 24.0).abs() < 1e-6, "{chamber}");
    assert!(chamber["pressure"].as_f64().unwrap() > 0.1, "{chamber}");
    assert_eq!((&statistics["pressure"], &statistics["volume"]), (&chamber["pressure"], &chamber["volume"]));
    let layers = statistics["layers"].as_array().unwrap();
    let count: u64 = layers.iter().map(|layer| layer["triangles"].as_u64().unwrap()).sum();
    assert_eq!((layers.len(), Some(count)), (2, statistics["triangles"].as_u64()));
    let stress = |k: usize| layers[k]["stress"]["max"].as_f64().unwrap();
    assert!(stress(0) > 1.1 && stress(1) < 0.9, "{layers:?}");
    assert!(statistics["balance"]["imbalance"].as_f64().unwrap() < 1e-9);
    assert_eq!(statistics["self_intersections"], 0);
}

#[tokio::test]
async fn a_film_in_which_water_stands_has_its_depth_and_a_warning() {
    let app = TestApp::start().await;
    let job = app.solve(TENSILE, &sail(json!({ "cables": [], "film": { "tension": 1, "weight": 0.001 } }))).await;
    assert_eq!(job["warnings"][0]["code"], "ponding", "{job}");
    let statistics = &job["statistics"];
    assert!(statistics["minimum_slope_deg"].as_f64().unwrap() < 5.0);
    assert_eq!(statistics["minimum_slope_at"].as_array().unwrap().len(), 3);
    // The weight w lowers the middle of a plane square of side a = 10 and tension σ by 0.0737 w a² / σ. The triangles
    // in its corners stay dry.
    let ponding = &statistics["ponding"];
    assert!((ponding["depth"].as_f64().unwrap() - 0.00737).abs() < 2e-4, "{ponding}");
    assert!((ponding["area"].as_f64().unwrap() - 100.0).abs() < 2.0, "{ponding}");
    assert_eq!(ponding["at"].as_array().unwrap().len(), 3);
    assert!(ponding["volume"].as_f64().unwrap() > 0.3 * 0.737, "{ponding}");
}

#[tokio::test]
async fn a_structure_without_an_equilibrium_fails_and_names_its_cables() {
    let app = TestApp::start().await;
    let cables: Vec<Value> = (0..4).map(|k| edge(k, json!({ "value": 3 }))).collect();
    let posted = app.post(TENSILE, &sail(json!({ "cables": cables }))).await;
    let job = app.ended(posted.json().await.unwrap()).await;
    assert_eq!(job["status"], "failed");
    assert_eq!(job["error"]["type"], "/problems/no-equilibrium");
    assert_eq!(job["error"]["errors"][3]["pointer"], "/cables/3/value");
}
