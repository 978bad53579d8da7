//! Tests with faults that are put into results on purpose. The audit must find each fault, and none in the unchanged
//! result.

use crate::limits::Limits;
use crate::request::Request;
use crate::solved::{UnauditedResult, Unsolved, faults as faults_of};
use crate::source::no_jobs;
use plateau_archive::archive::{BRIDGES, CABLES, Contents};
use plateau_archive::{Archive, LineSet, Lines};
use plateau_mesh::random::SplitMix64;
use plateau_mesh::{DVec3, Execution, Interruption, Signal};
use serde_json::{Value, json};

type Fault = (&'static str, fn(&mut Contents, &mut Value));

fn request(value: &Value) -> Request {
    let limits = Limits {
        points: 100_000,
        triangles: 100_000,
        grid_cells: 100_000_000,
        iterations: 10_000,
        memory_bytes: 1 << 30,
    };
    let accepted = Request::read_with_kind(value, &no_jobs, &limits);
    accepted.unwrap_or_else(|rejection| panic!("refused: {rejection:?}")).request
}

fn with(draft: &UnauditedResult, fault: fn(&mut Contents, &mut Value)) -> UnauditedResult {
    let mut contents = draft.archive.contents().clone();
    let mut statistics: Value = serde_json::from_str(&draft.statistics).unwrap();
    fault(&mut contents, &mut statistics);
    let archive = Archive::new(contents).expect("the fault leaves a valid archive");
    UnauditedResult {
        statistics: statistics.to_string(),
        warnings: draft.warnings.clone(),
        archive,
        reproducible: true,
    }
}

/// Requires that the audit finds no fault in the unchanged result, and finds each fault of the list.
fn finds(value: &Value, faults: &[Fault]) {
    let request = request(value);
    let (draft, input) = request.draft();
    let exec = Execution::default();
    let faults_of =
        |draft: &UnauditedResult| faults_of(&draft.statistics, &draft.warnings, &draft.archive, input, &exec).unwrap();
    assert_eq!(faults_of(&draft), [], "{}", value["kind"]);
    for (name, fault) in faults {
        let found = faults_of(&with(&draft, *fault));
        assert!(!found.is_empty(), "{name} was missed");
        println!("{name}: {:?}", found[0]);
    }
}

fn set<'c>(contents: &'c mut Contents, name: &str) -> &'c mut LineSet {
    contents.line_sets.iter_mut().find(|set| set.name == name).expect("a line set")
}

fn segments<'c>(contents: &'c mut Contents, name: &str) -> &'c mut Vec<[u32; 2]> {
    match &mut set(contents, name).lines {
        Lines::Segments(pairs) => pairs,
        other => panic!("{other:?} are no segments"),
    }
}

fn remove_last<T>(list: &mut Vec<T>) {
    list.truncate(list.len() - 1);
}

fn add(statistics: &mut Value, pointer: &str, difference: f64) {
    let value = statistics.pointer_mut(pointer).expect("a stated figure");
    *value = match value.as_u64() {
        Some(count) if difference.fract() == 0.0 => json!((count as f64 + difference) as u64),
        _ => json!(value.as_f64().expect("a number") + difference),
    };
}

fn skew_square() -> Value {
    json!({
        "kind": "minimal_surface",
        "boundaries": [[[0, 0, 0], [0.5, 0, 0.2], [1, 0, 0.4], [1, 1, 0], [0, 1, 0.4]]],
        "resolution": { "triangles": 200 },
        "certify": { "gap": 0.05, "seconds": 0.2 }
    })
}

fn strips() -> Value {
    json!({
        "kind": "ruled_surface",
        "directrices": [
            [[0, 0, 0], [1, 0.1, 0.3], [2, 0, 0.1], [3, 0, 0.5], [4, 0.2, 0]],
            [[0, 1, 0.2], [1.5, 1.2, 0], [2.5, 1, 0.6], [4, 1, 0]],
            [[0, 2, 0], [2, 2.5, 0.4], [4, 2, 0.1]]
        ],
        "objective": "maximal_convexity",
        "secondary_objective": "minimal_bending_energy"
    })
}

#[test]
#[cfg(feature = "minimal-surface")]
fn every_fault_in_a_film_is_found() {
    let faults: [Fault; 13] = [
        ("a shifted boundary", |contents, _| {
            // Each point gets the position of its neighbour, as if the boundary's list began at another point.
            let numbers: Vec<usize> = contents.input_vertices[0].iter().map(|&v| v as usize).collect();
            let places: Vec<DVec3> = numbers.iter().map(|&v| contents.mesh.vertices[v]).collect();
            for (k, &v) in numbers.iter().enumerate() {
                contents.mesh.vertices[v] = places[(k + 1) % places.len()];
            }
        }),
        ("a lost triangle", |contents, _| remove_last(&mut contents.mesh.triangles)),
        ("a swapped figure", |_, statistics| {
            let lengths = statistics["edge_lengths"].clone();
            statistics["edge_lengths"]["mean"] = lengths["std_dev"].clone();
            statistics["edge_lengths"]["std_dev"] = lengths["mean"].clone();
        }),
        ("a stale gap", |_, statistics| add(statistics, "/certificate/gap", 1e-5)),
        ("a bound above the area", |_, statistics| add(statistics, "/certificate/area_lower_bound", 1.0)),
        ("an area of an earlier step", |_, statistics| {
            add(statistics, "/area", 1e-7);
            add(statistics, "/objective_value", 1e-7);
        }),
        ("a moved vertex", |contents, _| contents.mesh.vertices.last_mut().unwrap().z += 1e-3),
        ("a flipped triangle", |contents, _| contents.mesh.triangles[7].swap(1, 2)),
        ("a boundary that leaves a vertex out", |contents, _| match &mut set(contents, "boundaries").lines {
            Lines::Polylines(lines) => {
                lines[0].vertices.remove(2);
            }
            other => panic!("{other:?}"),
        }),
        ("another genus", |_, statistics| add(statistics, "/genus", 1.0)),
        ("a residual of another mesh", |_, statistics| statistics["residual"] = json!(0.01)),
        ("a curvature of another vertex", |contents, _| {
            let values = &mut contents.vertex_attributes[0].values;
            let v = values.iter().position(|&value| value > 1e-5).expect("a curvature above the tolerance");
            values[v] *= 1.5;
        }),
        ("points of the input at other vertices", |contents, _| contents.input_vertices[0].swap(0, 1)),
    ];
    finds(&skew_square(), &faults);
}

/// Returns a closed polygon of `count` points at the height `z`, with these radii along x and y.
#[cfg(feature = "minimal-surface")]
/// A film whose mean curvature is beyond the bound of its request has not converged.
#[test]
#[cfg(feature = "minimal-surface")]
fn a_film_that_misses_its_curvature_bound_and_states_otherwise_is_found() {
    let mut value = skew_square();
    value["certify"] = json!(false);
    value["curvature_tolerance"] = json!(1e-9);
    let faults: [Fault; 1] = [("a bound that is not kept", |_, statistics| statistics["converged"] = json!(true))];
    finds(&value, &faults);
}

fn oval(count: u32, centre: [f64; 2], radii: [f64; 2], z: f64) -> Vec<[f64; 3]> {
    let angles = (0..count).map(|k| std::f64::consts::TAU * f64::from(k) / f64::from(count));
    let place = |angle: f64| [centre[0] + radii[0] * libm::cos(angle), centre[1] + radii[1] * libm::sin(angle), z];
    angles.map(place).collect()
}

/// Draws a film with a level closed guide, whose inside is flat, or a roof that is flat on one side of a guide.
#[cfg(feature = "minimal-surface")]
fn film_with_a_flat_part(number: u64) -> Value {
    let random = &mut SplitMix64::new(number);
    let triangles = 400 + random.below(1200);
    let film = |boundary: Vec<[f64; 3]>, guide: Vec<[f64; 3]>| {
        json!({ "kind": "minimal_surface", "boundaries": [boundary], "constraints": { "polylines": [guide] },
                "resolution": { "triangles": triangles } })
    };
    if number % 3 == 2 {
        let (width, depth) = (random.between(2.0, 6.0), random.between(5.0, 10.0));
        let end = width + random.between(2.0, 6.0);
        let [front, back] = [random.between(0.5, 3.0), random.between(0.5, 3.0)];
        let roof = vec![
            [0.0, 0.0, 0.0],
            [width, 0.0, 0.0],
            [end, 0.0, front],
            [end, depth, back],
            [width, depth, 0.0],
            [0.0, depth, 0.0],
        ];
        return film(roof, vec![[width, 0.0, 0.0], [width, depth, 0.0]]);
    }
    let wide = [random.between(8.0, 12.0), random.between(8.0, 12.0)];
    let small = [random.between(1.5, 3.5), random.between(1.5, 3.5)];
    let place = [random.between(-1.2, 1.2), random.between(-1.2, 1.2)];
    let (outer, inner) = ([4, 6, 30, 50][random.below(4)], [3, 4, 12, 40][random.below(4)]);
    let mut guide = oval(inner, place, small, random.between(0.5, 2.0));
    guide.push(guide[0]);
    film(oval(outer, [0.0, 0.0], wide, 0.0), guide)
}

#[test]
#[cfg(feature = "minimal-surface")]
fn films_with_flat_parts_are_right_and_their_faults_are_found() {
    let is_full = ["PLATEAU_FULL", "PLATEAU_LONG"].into_iter().any(|name| std::env::var_os(name).is_some());
    let faults: [Fault; 4] = [
        ("a flat vertex that is stated to be curved", |contents, _| {
            let values = &mut contents.vertex_attributes[0].values;
            let v = values.iter().rposition(|value| *value == 0.0).expect("a flat part");
            values[v] = 0.01;
        }),
        ("a curvature on a boundary", |contents, _| contents.vertex_attributes[0].values[0] = 0.1),
        ("a moved vertex", |contents, _| contents.mesh.vertices.last_mut().unwrap().z += 1e-2),
        ("a lost triangle", |contents, _| remove_last(&mut contents.mesh.triangles)),
    ];
    // Around a closed guide the curvature is above the tolerance.
    let of_curved: [Fault; 2] = [
        ("a curved vertex that is stated to be flat", |contents, _| {
            let values = &mut contents.vertex_attributes[0].values;
            let v = (0..values.len()).max_by(|&a, &b| values[a].total_cmp(&values[b])).expect("vertices");
            assert!(values[v] > 1e-5, "{}", values[v]);
            values[v] = 0.0;
        }),
        ("a mean over curved vertices only", |contents, statistics| {
            let count = |flat: bool| {
                let values = contents.vertex_attributes[0].values.iter();
                values.filter(|value| (**value == 0.0) == flat).count() as f64
            };
            let mean = statistics["mean_curvature"]["mean"].as_f64().expect("a number");
            statistics["mean_curvature"]["mean"] = json!(mean * (1.0 + count(true) / count(false)).max(1.5));
        }),
    ];
    for number in 0..if is_full { 60 } else { 6 } {
        let request = film_with_a_flat_part(number);
        println!("{number}: {request}");
        finds(&request, &faults);
        if number % 3 != 2 {
            finds(&request, &of_curved);
        }
    }
}

#[test]
#[cfg(feature = "minimal-surface")]
fn a_guide_that_leaves_the_mesh_is_found() {
    let mut request = film_with_a_flat_part(2);
    request["constraints"]["points"] = json!([[1.0, 2.0, 0.0]]);
    // The third point of the mesh that is on the guide but on no boundary was added between its two ends.
    fn inside(contents: &Contents) -> usize {
        let [from, to] = [1, 4].map(|k| contents.mesh.vertices[contents.input_vertices[0][k] as usize]);
        let is_on = |v: &usize| {
            let point = contents.mesh.vertices[*v];
            point.x == from.x && point.y > from.y && point.y < to.y
        };
        (0..contents.mesh.vertices.len()).filter(is_on).nth(2).expect("points on the guide")
    }
    let faults: [Fault; 3] = [
        ("a vertex beside its guide", |contents, _| {
            let v = inside(contents);
            contents.mesh.vertices[v].x += 1e-9;
        }),
        ("a curvature on a guide", |contents, _| {
            let v = inside(contents);
            contents.vertex_attributes[0].values[v] = 0.01;
        }),
        ("a fixed point that is no vertex", |contents, _| {
            let fixed = DVec3::new(1.0, 2.0, 0.0);
            let v = contents.mesh.vertices.iter().position(|vertex| *vertex == fixed).expect("the fixed point");
            contents.mesh.vertices[v].x += 1e-13;
        }),
    ];
    finds(&request, &faults);
}

#[test]
#[cfg(feature = "ruled-surface")]
fn every_fault_in_strips_is_found() {
    let faults: [Fault; 17] = [
        ("a triangle beside its bridges", |contents, _| contents.mesh.triangles.swap(1, 4)),
        ("a moved point", |contents, _| contents.mesh.vertices[3].x += 1e-12),
        ("a fold of another strip", |_, statistics| add(statistics, "/strips/0/largest_fold_deg", 1e-4)),
        ("a fold of the whole", |_, statistics| add(statistics, "/largest_fold_deg", 1e-4)),
        ("a developability of the whole", |_, statistics| add(statistics, "/developability_deviation_deg", 1e-4)),
        ("one convex bridge more", |_, statistics| {
            add(statistics, "/strips/1/convex_bridges", 1.0);
            add(statistics, "/convex_bridges", 1.0);
        }),
        ("a concave bridge without its mark", |contents, _| {
            let marks = &mut set(contents, BRIDGES).attributes[0].values;
            let k = marks.iter().position(|&mark| mark == 1.0).expect("a concave bridge");
            marks[k] = 0.0;
        }),
        ("a mark at another bridge", |contents, _| set(contents, BRIDGES).attributes[0].values[0] = 1.0),
        ("no marks", |contents, _| set(contents, BRIDGES).attributes.clear()),
        ("a listed bridge of other vertices", |_, statistics| {
            add(statistics, "/concave_bridges/0/vertices/1", 1.0);
        }),
        ("a fold of another bridge", |_, statistics| add(statistics, "/concave_bridges/0/fold_deg", 1e-4)),
        ("a list without its last bridge", |_, statistics| {
            remove_last(statistics["concave_bridges"].as_array_mut().expect("a list"));
        }),
        ("a twist without a bridge", |_, statistics| add(statistics, "/strips/0/total_normal_twist", 1e-6)),
        ("a bending without a bridge", |_, statistics| add(statistics, "/strips/0/bending_energy", 1e-6)),
        ("a curvature without a bridge", |_, statistics| add(statistics, "/strips/1/mean_curvature_variation", 1e-6)),
        ("a secondary value of all bridges", |_, statistics| {
            let all = statistics["strips"][0]["bending_energy"].clone();
            statistics["strips"][0]["secondary_value"] = all;
        }),
        ("a directrix off the mesh", |contents, _| match &mut set(contents, "directrices").lines {
            Lines::Polylines(lines) => lines[0].vertices.swap(0, 2),
            other => panic!("{other:?}"),
        }),
    ];
    let mut request = strips();
    finds(&request, &faults);
    // An archive itself refuses bridges that do not fit its triangles, in open and in closed strips.
    request["directrices"] =
        json!([[[0, 0, 0], [2, 0, 0], [1, 2, 0]], [[0, 0, 1], [2, 0, 1.2], [2, 2, 1], [0, 2, 1.1]]]);
    request["closed"] = json!(true);
    let accepted = self::request(&request);
    let (draft, _) = accepted.draft();
    for lose in [
        |contents: &mut Contents| remove_last(segments(contents, BRIDGES)),
        |contents: &mut Contents| remove_last(&mut contents.mesh.triangles),
    ] {
        let mut contents = draft.archive.contents().clone();
        lose(&mut contents);
        assert!(Archive::new(contents).is_err());
    }
}

#[test]
#[cfg(feature = "ruled-surface")]
fn every_fault_in_rails_that_moved_is_found() {
    let mut moving = strips();
    moving["rail_tolerance"] = json!(0.05);
    moving["secondary_objective"] = Value::Null;
    finds(
        &moving,
        &[("fewer convex bridges before", |_, statistics| {
            add(statistics, "/rails/before", -100.0);
            add(statistics, "/rails/gain", 100.0);
        })],
    );
    moving["objective"] =
        json!({ "weights": { "minimal_area": 1, "minimal_bending_energy": 0.1 }, "normalise": false });
    let faults: [Fault; 5] = [
        ("a larger move", |_, statistics| add(statistics, "/rails/moved_max", 1e-6)),
        ("another vertex", |_, statistics| {
            let vertex = &mut statistics["rails"]["moved_max_vertex"];
            *vertex = json!(if *vertex == 2 { 6 } else { 2 });
        }),
        ("a gain of other values", |_, statistics| add(statistics, "/rails/gain", 1e-6)),
        ("a worse value before", |_, statistics| {
            add(statistics, "/rails/before", 100.0);
            add(statistics, "/rails/gain", 100.0);
        }),
        ("a value of other weights", |_, statistics| {
            for pointer in ["/strips/0/objective_value", "/objective_value", "/rails/gain"] {
                add(statistics, pointer, if pointer == "/rails/gain" { -1e-6 } else { 1e-6 });
            }
        }),
    ];
    finds(&moving, &faults);
    // The result of a request is compared with requests that let the points move less.
    let accepted = request(&moving);
    let (draft, _) = accepted.draft();
    for (member, value) in [("rail_tolerance", json!(0.04)), ("rail_ends", json!("fixed"))] {
        let mut stricter = moving.clone();
        stricter[member] = value;
        let stricter = request(&stricter);
        let (_, input) = stricter.draft();
        let found =
            faults_of(&draft.statistics, &draft.warnings, &draft.archive, input, &Execution::default()).unwrap();
        assert!(found.iter().any(|fault| fault.figure.ends_with("is at its vertex")), "{member}: {found:?}");
    }
}

#[test]
#[cfg(feature = "uniform-mesh")]
fn every_fault_in_a_lattice_is_found() {
    let request = json!({
        "kind": "uniform_mesh",
        "domain": { "polygon": [[0, 0, 0], [20, 0, 0], [22, 14, 0], [3, 15, 0]] },
        "edge_length": 2.0,
        "objective": "most_equal_edges"
    });
    let faults: [Fault; 10] = [
        ("a lost triangle", |contents, _| remove_last(&mut contents.mesh.triangles)),
        ("a moved corner", |contents, _| contents.mesh.vertices[1].x += 1e-9),
        ("a moved node", |contents, _| contents.mesh.vertices.last_mut().unwrap().y += 1e-4),
        ("a flipped triangle", |contents, _| contents.mesh.triangles[3].swap(0, 1)),
        ("a member that is no edge", |contents, _| segments(contents, "members")[0][1] ^= 1),
        ("a length of another member", |contents, _| set(contents, "members").attributes[0].values[2] += 1e-6),
        ("one equal edge more", |_, statistics| add(statistics, "/equal_edges", 1.0)),
        ("one length more", |_, statistics| add(statistics, "/distinct_lengths", 1.0)),
        ("one edge out of range more", |_, statistics| add(statistics, "/out_of_range_edges", 1.0)),
        ("a valence of another mesh", |_, statistics| add(statistics, "/valence_histogram/6", 1.0)),
    ];
    finds(&request, &faults);
}

#[test]
#[cfg(feature = "cable-net")]
fn every_fault_in_a_net_is_found() {
    let request = json!({
        "kind": "cable_net",
        "vertices": [[0, 0, 0], [2, 0, 1], [2, 2, 0], [0, 2, 1], [1, 1, 0]],
        "edges": [[0, 4], [1, 4], [2, 4], [3, 4]],
        "supports": [0, 1, 2, 3],
        "loads": [{ "vertices": [4], "force": [0, 0, -1] }],
        "cables": [
            { "name": "one", "edges": [0, 1], "force_density": 2.0, "axial_stiffness": 1000 },
            { "name": "second", "edges": [2, 3], "force": 3.0 }
        ]
    });
    let faults: [Fault; 11] = [
        ("a moved support", |contents, _| contents.mesh.vertices[0].x += 1e-12),
        ("a moved vertex", |contents, _| contents.mesh.vertices[4].z += 1e-6),
        ("a force of another edge", |contents, _| set(contents, CABLES).attributes[0].values[0] *= 1.001),
        ("a cable between other vertices", |contents, _| segments(contents, CABLES)[0] = [2, 4]),
        ("a reaction without the load", |_, statistics| add(statistics, "/reactions/1/force/2", 0.25)),
        ("a balance of another net", |_, statistics| add(statistics, "/balance/reactions/0", 1e-6)),
        ("unbalanced forces", |_, statistics| add(statistics, "/balance/residual_force", 1e-6)),
        ("a length of another cable", |_, statistics| add(statistics, "/cables/1/length", 1e-6)),
        ("an unstressed length of another cable", |_, statistics| add(statistics, "/cables/0/unstressed_length", 1e-6)),
        ("a load path without an edge", |_, statistics| add(statistics, "/load_path", 1e-6)),
        ("a loss of an earlier step", |_, statistics| add(statistics, "/objective_value", 1e-6)),
    ];
    finds(&request, &faults);
}

#[test]
#[cfg(feature = "tensile-structure")]
fn every_fault_in_a_tensile_structure_is_found() {
    let cable = |k: u32| {
        let along = json!({ "from": k, "to": (k + 1) % 4 });
        json!({ "name": format!("edge {k}"), "along": along, "mode": "force", "value": 30 })
    };
    let request = json!({
        "kind": "tensile_structure",
        "boundaries": [[[0, 0, 0], [10, 0, 4], [10, 10, 0], [0, 10, 4]]],
        "film": { "tension": 2 },
        "cables": [cable(0), cable(1), cable(2), cable(3)],
        "resolution": { "triangles": 200 }
    });
    let faults: [Fault; 11] = [
        ("a lost triangle", |contents, _| {
            remove_last(&mut contents.mesh.triangles);
            contents.triangle_attributes.iter_mut().for_each(|attribute| remove_last(&mut attribute.values));
        }),
        ("a moved vertex", |contents, _| contents.mesh.vertices.last_mut().unwrap().z += 1e-3),
        ("an area of an earlier step", |_, statistics| add(statistics, "/area", 1e-6)),
        ("triangles of another layer", |_, statistics| add(statistics, "/layers/0/triangles", 1.0)),
        ("an energy of an earlier step", |_, statistics| add(statistics, "/objective_value", 0.1)),
        ("a length of another cable", |_, statistics| add(statistics, "/cables/2/length", 1e-6)),
        ("a force of another cable", |_, statistics| add(statistics, "/cables/1/force_max", 1e-5)),
        ("a sag of another cable", |_, statistics| add(statistics, "/cables/1/sag", 1e-5)),
        ("a reaction that is not listed", |_, statistics| add(statistics, "/reactions/0/force/2", 1.0)),
        ("a balance of another shape", |_, statistics| add(statistics, "/balance/imbalance", 1e-6)),
        ("a slope of another triangle", |_, statistics| add(statistics, "/minimum_slope_deg", 1e-3)),
    ];
    finds(&request, &faults);
}

#[test]
#[cfg(feature = "tensile-structure")]
fn every_fault_in_the_forces_along_a_held_edge_is_found() {
    let request = json!({
        "kind": "tensile_structure",
        "boundaries": [[[0, 0, 0], [10, 0, 4], [10, 10, 0], [0, 10, 4]]],
        "film": { "warp": 2, "weft": 1, "direction": { "parallel": [1, 0, 0] } },
        "resolution": { "triangles": 200 }
    });
    let faults: [Fault; 4] = [
        ("a force per length of another edge", |contents, _| {
            set(contents, "held edges").attributes[0].values[3] += 1e-6;
        }),
        ("a force per length to another side", |contents, _| {
            set(contents, "held edges").attributes[2].values[0] += 1e-6;
        }),
        ("a least force of another boundary", |_, statistics| {
            add(statistics, "/edge_reactions/0/force_per_length/min", 1e-6);
        }),
        ("a largest force of another boundary", |_, statistics| {
            add(statistics, "/edge_reactions/0/force_per_length/max", 1e-6);
        }),
    ];
    finds(&request, &faults);
}

#[test]
#[cfg(feature = "ruled-surface")]
fn a_result_with_a_fault_is_withheld_and_the_error_names_the_figure() {
    let request = request(&strips());
    let (draft, input) = request.draft();
    let wrong = with(&draft, |_, statistics| add(statistics, "/area", 1.0));
    let exec = Execution::default();
    let Err(Unsolved::Failed(error)) = wrong.audited(input, &exec) else { panic!("should have failed") };
    assert_eq!(error.kind, "/problems/audit-failed");
    assert!(error.is_of_the_audit() && error.detail.contains("/area: stated "), "{}", error.detail);
    assert!(draft.audited(input, &exec).is_ok());
}

#[test]
#[cfg(feature = "minimal-surface")]
fn a_cancel_ends_the_audit_and_a_deadline_does_not() {
    let request = request(&skew_square());
    let (draft, input) = request.draft();
    for (signal, cancels) in [(Signal::Cancel, true), (Signal::Deadline, false)] {
        let signal = || signal;
        let exec = Execution::new(&signal, &|_| {});
        let found = faults_of(&draft.statistics, &draft.warnings, &draft.archive, input, &exec);
        assert_eq!(found, if cancels { Err(Interruption::Cancelled) } else { Ok(Vec::new()) });
    }
}
