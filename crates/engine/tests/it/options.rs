//! Every option of every kind is sent with every choice of objective, solver, topology, initial mesh and domain. It
//! must give another result than the request without it, or be refused at its own place.
//!
//! The first tier tries the choices that begin each list; `PLATEAU_FULL=1` tries all of them.

use crate::{LIMITS, is_full, root};
use plateau_engine::kind::Kind;
use plateau_engine::request::Request;
use plateau_engine::solved::Signal;
use plateau_engine::source::no_jobs;
use plateau_strict_json::json;
use plateau_strict_json::rejection::Rejection;
use serde_json::{Value, json};
use std::collections::BTreeMap;
use std::f64::consts::PI;

/// Returns `base` with the members of `more`.
fn with(base: &Value, more: &Value) -> Value {
    let mut request = base.clone();
    for (name, member) in more.as_object().unwrap() {
        request[name] = member.clone();
    }
    request
}

/// Returns the result of a request as text, without the times, or the pointers of its errors.
fn outcome(request: &Value) -> Result<String, Vec<String>> {
    let pointers = |rejection| match rejection {
        Rejection::Invalid(errors) | Rejection::TooLarge(errors) => {
            errors.into_iter().map(|error| error.pointer).collect::<Vec<_>>()
        }
        Rejection::Malformed(detail) => panic!("{detail}"),
    };
    let value = json::parse(request.to_string().as_bytes()).unwrap();
    let accepted = Request::read_with_kind(&value, &no_jobs, &LIMITS).map_err(pointers)?;
    Ok(match accepted.request.solve(&|| Signal::Continue, &|_| {}) {
        Ok(solved) => format!("{}{:?}{:?}", solved.statistics, solved.warnings, solved.archive.contents().mesh),
        Err(error) => format!("{error:?}"),
    })
}

/// A ring of radius 1 about the z axis.
fn ring(count: usize, z: f64) -> Vec<[f64; 3]> {
    (0..count).map(|k| 2.0 * PI * k as f64 / count as f64).map(|t| [t.cos(), t.sin(), z]).collect()
}

/// Two rings, and a mesh between them near the unstable one of their two catenoids.
fn own_mesh() -> (Value, Value) {
    const COUNT: usize = 16;
    const ROWS: usize = 7;
    let (half, neck): (f64, f64) = (0.6, 0.35);
    let scale = (half / neck).cosh() * neck;
    let mut vertices = Vec::new();
    for row in 0..ROWS {
        let z = half * (2.0 * row as f64 / (ROWS - 1) as f64 - 1.0);
        let radius = if row == 0 || row + 1 == ROWS { 1.0 } else { (z / neck).cosh() * neck / scale };
        vertices.extend(ring(COUNT, z).into_iter().map(|[x, y, z]| [radius * x, radius * y, z]));
    }
    let mut triangles = Vec::new();
    for (row, k) in (0..ROWS - 1).flat_map(|row| (0..COUNT).map(move |k| (row, k))) {
        let [a, b] = [k, (k + 1) % COUNT].map(|k| row * COUNT + k);
        triangles.extend([[a, b, b + COUNT], [a, b + COUNT, a + COUNT]]);
    }
    let rings = json!([ring(COUNT, -half), ring(COUNT, half).into_iter().rev().collect::<Vec<_>>()]);
    (rings, json!({ "vertices": vertices, "triangles": triangles }))
}

/// The options of a kind with values that are not their defaults, the choices, and the bodies with which they are sent.
struct Table {
    options: Vec<(&'static str, Vec<Value>)>,
    choices: Vec<Value>,
    bodies: Vec<Value>,
    /// Number of choices that the first tier tries.
    first: usize,
}

/// Options that are refused at another member, because that member is required or would have to change.
const ELSEWHERE: [(&str, &str); 7] = [
    ("caps", "/rail_tolerance"),
    ("optimise", "/max_distinct_lengths"),
    ("optimise_nodes", "/optimise"),
    ("solver", "/topology"),
    ("constraints", "/topology"),
    ("topology", "/initial_mesh"),
    ("initial_mesh", "/constraints"),
];

/// Checks a table, and returns the number of pairs that were refused and of those that gave another result.
fn check(kind: Kind, table: &Table) -> [usize; 2] {
    let mut counts = [0; 2];
    let mut idle = Vec::new();
    let choices = if is_full() { table.choices.len() } else { table.first };
    for choice in &table.choices[..choices] {
        let mut without = BTreeMap::new();
        for (name, values) in &table.options {
            if choice.get(name).is_some() {
                continue;
            }
            let pointer = format!("/{name}");
            let bodies = table.bodies.iter().enumerate();
            let acts = bodies.flat_map(|(k, body)| values.iter().map(move |value| (k, body, value))).any(
                |(k, body, value)| {
                    let mut base = with(&with(body, choice), &json!({ "kind": kind.name() }));
                    if base["initial_mesh"].is_object() {
                        base.as_object_mut().unwrap().remove("resolution");
                    }
                    let before = without.entry(k).or_insert_with(|| outcome(&base));
                    let Ok(before) = before else { return false };
                    match outcome(&with(&base, &json!({ *name: value }))) {
                        Err(places) => {
                            counts[0] += 1;
                            let named = |place: &String| {
                                place.starts_with(&pointer) || ELSEWHERE.contains(&(*name, place.as_str()))
                            };
                            assert!(places.iter().any(named), "{name} {choice}: {places:?}");
                            true
                        }
                        Ok(after) => {
                            counts[1] += 1;
                            after != *before
                        }
                    }
                },
            );
            // This option acts only if the film that was found is unstable, as the one of the own mesh is.
            let depends = *name == "on_unstable" && !choice["initial_mesh"].is_object();
            if !acts && !depends && without.values().any(Result::is_ok) {
                idle.push(format!("{} with {choice}", pointer));
            }
        }
        assert!(without.values().any(Result::is_ok), "no body takes {choice}: {without:?}");
    }
    assert!(idle.is_empty(), "nobody says that these change nothing:\n{}", idle.join("\n"));
    counts
}

fn kind(name: &str) -> Kind {
    Kind::from_name(name).unwrap()
}

#[test]
fn each_option_of_a_film_acts_or_is_refused() {
    let (rings, mesh) = own_mesh();
    let saddle: Vec<[f64; 3]> =
        (0..16).map(|k| PI * k as f64 / 8.0).map(|t| [t.cos(), t.sin(), 0.4 * (2.0 * t).cos()]).collect();
    let resolution = json!({ "triangles": 240 });
    let square = |z: f64| json!([[1, 0, z], [0, 1, z], [-1, 0, z], [0, -1, z]]);
    // With `resolution` among the options, the bodies have none, so films of the default size are left out.
    let table = Table {
        options: vec![
            ("solver", vec![json!("pinkall_polthier"), json!("vertex_relaxation")]),
            ("resolution", vec![json!({ "triangles": 300 })]),
            ("boundary_sampling", vec![json!("keep")]),
            ("initial_mesh", vec![json!("disk"), json!("planar"), json!("rings")]),
            ("constraints", vec![json!({ "points": [[0.1, 0.1, 0.1]] })]),
            ("topology", vec![json!("free"), json!("best")]),
            ("tolerance", vec![json!(0.5)]),
            ("curvature_tolerance", vec![json!(1e-6)]),
            ("area_tolerance", vec![json!(0.1)]),
            ("least_squares_tolerance", vec![json!(0.1)]),
            ("fairing_tolerance", vec![json!(0.1)]),
            ("processes", vec![json!(["area_minimising"])]),
            ("max_iterations", vec![json!(1)]),
            ("on_unstable", vec![json!("descend")]),
            ("linear_solver", vec![json!("conjugate_gradients")]),
            ("degenerate_angle_deg", vec![json!(20)]),
            ("seed", vec![json!(7), json!(8), json!(9)]),
            ("boundary_curvature", vec![json!(true)]),
            ("candidate_fairing", vec![json!(false)]),
            ("certify", vec![json!({ "seconds": 0.1 })]),
        ],
        choices: vec![
            json!({}),
            json!({ "objective": "minimal_dirichlet_energy" }),
            json!({ "objective": "minimal_mean_curvature" }),
            json!({ "solver": "vertex_relaxation" }),
            json!({ "solver": "pinkall_polthier" }),
            json!({ "topology": "free" }),
            json!({ "initial_mesh": mesh }),
            json!({ "solver": "newton" }),
            json!({ "topology": "best" }),
            json!({ "solver": "pinkall_polthier", "topology": "free" }),
            json!({ "initial_mesh": "rings" }),
            json!({ "initial_mesh": "barycentres" }),
            json!({ "initial_mesh": "disk", "solver": "vertex_relaxation" }),
            json!({ "initial_mesh": mesh, "solver": "pinkall_polthier" }),
            json!({ "initial_mesh": mesh, "objective": "minimal_mean_curvature" }),
            json!({ "initial_mesh": mesh, "objective": "minimal_dirichlet_energy" }),
            json!({ "initial_mesh": "barycentres", "objective": "minimal_mean_curvature" }),
        ],
        bodies: vec![
            json!({ "boundaries": [saddle] }),
            json!({ "boundaries": rings }),
            json!({ "boundaries": [ring(16, -0.8), ring(16, 0.8)] }),
            json!({ "boundaries": [square(0.0), square(0.6)] }),
        ],
        first: 7,
    };
    let with_resolution: Vec<Value> =
        table.bodies.iter().map(|body| with(body, &json!({ "resolution": resolution }))).collect();
    println!("{:?}", check(kind("minimal_surface"), &Table { bodies: with_resolution, ..table }));
}

#[test]
fn each_option_of_a_strip_acts_or_is_refused() {
    let rails = json!([[[0, 0, 0], [1, 0, 0.4], [2, 0, 0], [3, 0, 0.3]], [[0, 1, 0], [2, 1.5, 0.5], [3, 1, 0.1]]]);
    let tangents = json!([[[1, 0, 0], [1, 0, 0.3], [1, 0, 0], [1, 0, 0]], [[1, 0, 0], [1, 0.5, 0], [1, 0, 0]]]);
    let square = |z: f64, r: f64| json!([[r, r, z], [-r, r, z], [-r, -r, z + 0.3], [r, -r, z]]);
    let lobes = json!([square(0.0, 1.0), square(1.0, 0.7)]);
    let reversed = json!([[[0, 0, 0], [1, 0, 0.4], [2, 0, 0]], [[2, 1, 0.1], [1, 1.5, 0.5], [0, 1, 0]]]);
    let objectives = [
        "minimal_area",
        "maximal_convexity",
        "minimal_bending_energy",
        "minimal_twist",
        "minimal_mean_curvature_variation",
        "minimal_normal_variation",
    ];
    let mut choices: Vec<Value> = objectives.iter().map(|name| json!({ "objective": name })).collect();
    choices.extend(objectives[..5].iter().map(|name| json!({ "objective": name, "closed": true })));
    choices.push(json!({ "objective": { "weights": { "minimal_area": 1, "minimal_twist": 1 } } }));
    choices.truncate(12);
    let normal = choices.remove(5);
    choices.insert(1, json!({ "objective": "minimal_bending_energy", "rail_tolerance": 0.05 }));
    // Closed rails have no ends, which `rail_ends` could keep.
    choices.insert(2, json!({ "objective": "minimal_bending_energy", "rail_tolerance": 0.05, "closed": true }));
    let bodies =
        vec![json!({ "directrices": rails }), json!({ "directrices": lobes }), json!({ "directrices": reversed })];
    let options = vec![
        ("closed", vec![json!(true)]),
        ("secondary_objective", vec![json!("minimal_bending_energy"), json!("minimal_area"), json!("minimal_twist")]),
        ("convexity_tolerance_deg", vec![json!(45)]),
        ("bending", vec![json!("paper")]),
        ("direction", vec![json!("auto")]),
        ("caps", vec![json!("flat")]),
        ("tangents", vec![tangents]),
        ("all_objectives", vec![json!(true)]),
        ("sampling", vec![json!({ "by": "arc_length", "samples": 9 })]),
        ("rail_tolerance", vec![json!(0.02)]),
        ("rail_ends", vec![json!("fixed")]),
    ];
    let table = Table { options: options.clone(), choices, bodies, first: 4 };
    println!("{:?}", check(kind("ruled_surface"), &table));
    let rail = |y: f64, height: f64, phase: f64| -> Vec<[f64; 3]> {
        (0..9).map(f64::from).map(|x| [x, y, height * (1.3 * x + phase).sin()]).collect()
    };
    let upright = vec![[0, 0, 1]; 9];
    // The second strip folds by more than 90°, where `bending` acts.
    let given = [0.4, 3.0].map(|height| {
        json!({ "directrices": [rail(0.0, height, 0.0), rail(1.0, height, 0.9)], "normals": [upright, upright] })
    });
    let options = options
        .into_iter()
        .filter(|(name, _)| !["direction", "closed", "sampling", "tangents"].contains(name))
        .collect();
    println!(
        "{:?}",
        check(kind("ruled_surface"), &Table { options, choices: vec![normal], bodies: given.into(), first: 1 })
    );
}

#[test]
fn each_option_of_a_lattice_acts_or_is_refused() {
    let hill = |i: usize, j: usize| [5.0 * i as f64, 5.0 * j as f64, if (i, j) == (1, 1) { 9.0 } else { 0.0 }];
    let points: Vec<Vec<[f64; 3]>> = (0..3).map(|i| (0..3).map(|j| hill(i, j)).collect()).collect();
    let knots = [0, 0, 0, 1, 1, 1];
    let film = json!([[[0, 0, 0], [10, 0, 4], [10, 10, 0], [0, 10, 4]]]);
    let table = Table {
        options: vec![
            ("objective", vec![json!("fewest_nodes")]),
            ("optimise_nodes", vec![json!(false)]),
            ("optimise", vec![json!("lengths")]),
            ("max_distinct_lengths", vec![json!(3)]),
            ("length_tolerance", vec![json!(0.2)]),
            ("rim", vec![json!("free")]),
            ("auxiliary_grid", vec![json!([5, 5])]),
        ],
        choices: vec![
            json!({ "domain": { "polygon": [[0, 0, 0], [10, 0, 0], [12, 7, 0], [3, 9, 0]] } }),
            json!({ "domain": { "bezier": { "control_points": points } } }),
            json!({ "domain": { "nurbs": { "degrees": [2, 2], "knots": [knots, knots], "control_points": points } } }),
            json!({ "domain": { "boundaries": film } }),
            json!({ "domain": { "bezier": { "control_points": points } }, "optimise_nodes": false }),
            json!({ "domain": { "bezier": { "control_points": points } }, "objective": "fewest_nodes" }),
            json!({ "domain": { "bezier": { "control_points": points } }, "optimise": "lengths",
                    "max_distinct_lengths": 4 }),
            json!({ "domain": { "polygon": [[0, 0, 0], [10, 0, 0], [12, 7, 0], [3, 9, 0]] }, "optimise": "lengths",
                    "max_distinct_lengths": 4 }),
        ],
        bodies: vec![json!({ "edge_length": 1.5 }), json!({ "edge_length": 1.1 })],
        first: 2,
    };
    println!("{:?}", check(kind("uniform_mesh"), &table));
}

#[test]
fn each_option_of_a_net_acts_or_is_refused() {
    let net = |cable: Value| {
        json!({ "vertices": [[0, 0, 0], [4, 0, 1], [4, 4, 0], [0, 4, 1], [2, 1.5, 1]],
            "edges": [[0, 4], [1, 4], [2, 4], [3, 4]], "supports": [0, 1, 2, 3], "cables": [cable] })
    };
    let table = Table {
        options: vec![
            ("loads", vec![json!([{ "force": [0, 0, -1] }])]),
            (
                "weights",
                vec![json!({ "force": 7, "load_path": 0.1 }), json!({ "length": 7 }), json!({ "load_path": 3 })],
            ),
            ("least_force_density", vec![json!(5)]),
            ("tolerance", vec![json!(0.9)]),
            ("max_iterations", vec![json!(1)]),
        ],
        choices: vec![json!({})],
        bodies: vec![net(json!({ "force": 3 })), net(json!({ "length": 3, "force": 2 }))],
        first: 1,
    };
    println!("{:?}", check(kind("cable_net"), &table));
    for (cable, weight) in [("length", "force"), ("force", "length")] {
        let request = with(&net(json!({ cable: 3 })), &json!({ "kind": "cable_net", "weights": { weight: 1 } }));
        assert_eq!(outcome(&request), Err(vec![format!("/weights/{weight}")]));
    }
}

/// Edges can be swapped alone. The tolerances of the other processes then have no effect and are refused.
#[test]
fn a_stage_of_swapping_alone_takes_no_tolerance() {
    let saddle: Vec<[f64; 3]> =
        (0..16).map(|k| PI * k as f64 / 8.0).map(|t| [t.cos(), t.sin(), 0.4 * (2.0 * t).cos()]).collect();
    let request = |stages: Value, more: Value| {
        let base = json!({ "kind": "minimal_surface", "boundaries": [saddle], "solver": "vertex_relaxation",
            "resolution": { "triangles": 240 }, "processes": stages });
        outcome(&with(&base, &more))
    };
    let swapping = || json!(["edge_swapping"]);
    assert!(request(swapping(), json!({})).unwrap().contains("edge_swapping"));
    assert_eq!(request(swapping(), json!({ "area_tolerance": 0.1 })), Err(vec!["/area_tolerance".into()]));
    assert_eq!(request(swapping(), json!({ "fairing_tolerance": 0.1 })), Err(vec!["/fairing_tolerance".into()]));
    let fairing = || json!(["laplacian_fairing", "edge_swapping"]);
    assert!(request(fairing(), json!({ "area_tolerance": 0.1 })).is_ok());
    let both = json!({ "area_tolerance": 0.1, "fairing_tolerance": 0.1 });
    assert_eq!(request(fairing(), both), Err(vec!["/area_tolerance".into()]));
}

/// The catalogue lists an option for an objective only if some request with that objective takes it.
#[test]
fn the_catalogue_lists_the_options_of_each_objective() {
    let names = |objective: &str| {
        let found = kind("minimal_surface").objectives().into_iter().find(|other| other.name == objective).unwrap();
        found.options.into_iter().map(|option| (option.name, option.needs)).collect::<BTreeMap<_, _>>()
    };
    let [area, dirichlet, curvature] =
        ["minimal_area", "minimal_dirichlet_energy", "minimal_mean_curvature"].map(names);
    assert_eq!(
        dirichlet.keys().copied().collect::<Vec<_>>(),
        ["boundary_sampling", "constraints", "initial_mesh", "join_tolerance", "resolution", "seed"]
    );
    assert!(curvature["least_squares_tolerance"].is_empty() && !curvature.contains_key("solver"));
    assert!(!area.contains_key("least_squares_tolerance"));
    assert_eq!(json!(area["processes"]), json!([{ "solver": ["vertex_relaxation"] }]));
    assert_eq!(json!(area["linear_solver"]), json!([{ "solver": ["pinkall_polthier"] }, { "topology": ["free"] }]));
    let strip = kind("ruled_surface").objectives();
    let secondary =
        strip.iter().filter(|found| found.options.iter().any(|option| option.name == "secondary_objective"));
    assert_eq!(secondary.map(|found| found.name).collect::<Vec<_>>(), ["maximal_convexity"]);
}

/// Null and the empty list count as left out, as clients send them that were generated from the document.
#[test]
fn null_and_empty_lists_change_nothing() {
    let folder = root().join("api/examples");
    for name in ["two-rails", "tent", "floor-fewest-nodes", "inflated-disc", "four-cables"] {
        let request: Value =
            serde_json::from_slice(&std::fs::read(folder.join(format!("{name}.json"))).unwrap()).unwrap();
        let schema = plateau_engine::schema::request(kind(request["kind"].as_str().unwrap()));
        let members = schema["properties"].as_object().unwrap().keys();
        let value = json::parse(request.to_string().as_bytes()).unwrap();
        let text = |value: &Value| Request::read_with_kind(value, &no_jobs, &LIMITS).map(|accepted| accepted.text);
        let plain = text(&value).unwrap();
        for member in members.filter(|member| request.get(member.as_str()).is_none()) {
            let sent = with(&value, &json!({ member.as_str(): null }));
            assert_eq!(text(&sent).as_ref(), Ok(&plain), "{name} {member}");
        }
    }
    let tent = json!({ "kind": "minimal_surface", "boundaries": [[[0, 0, 0], [1, 0, 1], [1, 1, 0]]], "processes": [],
        "constraints": { "points": [], "polylines": null }, "resolution": { "triangles": 90, "edge_length": null } });
    assert!(outcome(&tent).is_ok());
    for (member, wrong) in [("seeds", json!(null)), ("seed", json!([])), ("boundaries", json!([]))] {
        assert_eq!(outcome(&with(&tent, &json!({ member: wrong }))), Err(vec![format!("/{member}")]));
    }
    let net = |vertices: Value| {
        json!({ "kind": "cable_net", "vertices": [[0, 0, 0], [4, 0, 1], [2, 1.5, 1]], "edges": [[0, 2], [1, 2]],
            "supports": [0, 1], "loads": [{ "force": [0, 0, -1], "vertices": vertices }], "cables": [{ "force": 3 }] })
    };
    assert!(outcome(&net(json!(null))).is_ok());
    assert_eq!(outcome(&net(json!([]))), Err(vec!["/loads/0/vertices".into()]));
}

/// The text of an accepted request is accepted as a request.
#[test]
fn the_text_of_an_accepted_request_can_be_sent_again() {
    for file in std::fs::read_dir(root().join("api/examples")).unwrap() {
        let value = json::parse(&std::fs::read(file.unwrap().path()).unwrap()).unwrap();
        let kind = kind(value["kind"].as_str().unwrap());
        let accepted = Request::from_value(kind, &value, &no_jobs, &LIMITS).unwrap_or_else(|error| panic!("{error:?}"));
        let again = json::parse(&accepted.text).unwrap();
        let again = Request::from_value(kind, &again, &no_jobs, &LIMITS).map(|accepted| accepted.text);
        assert_eq!(again.as_ref(), Ok(&accepted.text));
    }
}
