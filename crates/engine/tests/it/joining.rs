//! Points that should be one: ends that a program computed with other rounding than the points at which they end.
//!
//! The requests of named cases are in `crates/engine/tests/cases`. The others are drawn by number.

use crate::{is_full, read};
use plateau_archive::Archive;
use plateau_engine::report::Warning;
use plateau_engine::solved::{Signal, Unsolved};
use plateau_mesh::random::SplitMix64;
use plateau_strict_json::rejection::Rejection;
use serde_json::{Value, json};

/// How a request ends.
enum End {
    /// Refused, or failed after the start: the pointers, and the texts of the error.
    Refused(Vec<String>, String),
    Solved(Box<(Value, Vec<Warning>, Archive)>),
}

fn end(request: &Value) -> End {
    let accepted = match read(request.to_string().as_bytes()) {
        Ok(accepted) => accepted,
        Err(Rejection::Invalid(errors) | Rejection::TooLarge(errors)) => {
            let texts: Vec<&str> = errors.iter().map(|error| error.detail.as_str()).collect();
            let texts = texts.join("; ");
            return End::Refused(errors.into_iter().map(|error| error.pointer).collect(), texts);
        }
        Err(Rejection::Malformed(detail)) => panic!("{detail}"),
    };
    match accepted.solve(&|| Signal::Continue, &|_| {}) {
        Ok(solved) => {
            let statistics = serde_json::from_str(&solved.statistics).expect("statistics are JSON");
            End::Solved(Box::new((statistics, solved.warnings, solved.archive)))
        }
        Err(Unsolved::Failed(failure)) => {
            assert!(!failure.is_of_the_audit(), "{} of {request}", failure.detail);
            let texts = failure.errors.iter().fold(failure.detail, |all, error| all + "; " + &error.detail);
            End::Refused(failure.errors.into_iter().map(|error| error.pointer).collect(), texts)
        }
        Err(other) => panic!("{other:?}"),
    }
}

fn case(name: &str) -> Value {
    let path = format!("{}/tests/cases/{name}.json", env!("CARGO_MANIFEST_DIR"));
    serde_json::from_slice(&std::fs::read(path).expect("a case")).expect("JSON")
}

fn solved(name: &str, request: &Value) -> (Value, Vec<Warning>, Archive) {
    match end(request) {
        End::Solved(solved) => *solved,
        End::Refused(pointers, texts) => panic!("{name}: {pointers:?} {texts}"),
    }
}

fn refused(request: &Value) -> (Vec<String>, String) {
    match end(request) {
        End::Refused(pointers, texts) => (pointers, texts),
        End::Solved(solved) => panic!("{:?}", solved.1),
    }
}

fn codes(warnings: &[Warning]) -> Vec<&str> {
    warnings.iter().map(|warning| warning.code.as_str()).collect()
}

fn number(statistics: &Value, pointer: &str) -> f64 {
    statistics.pointer(pointer).and_then(Value::as_f64).unwrap_or_else(|| panic!("{pointer} of {statistics}"))
}

#[test]
fn a_guy_one_rounding_beside_a_free_corner_pulls_the_corner() {
    let (statistics, warnings, archive) = solved("T4", &case("tensile/guy_off_by_1e-15"));
    assert!((number(&statistics, "/area") - 71.658).abs() < 0.01, "{}", statistics["area"]);
    assert_eq!(codes(&warnings), ["joined"]);
    assert_eq!((warnings[0].values["count"], warnings[0].values["distance"] < 1e-14), (1.0, true));
    assert_eq!(archive.contents().input_vertices[0].len(), 4);
    let (statistics, warnings, archive) = solved("T3", &case("tensile/guy_off_by_1e-9"));
    assert_eq!((&statistics["converged"], codes(&warnings)), (&json!(true), vec!["joined", "closing_corner"]));
    let corner = archive.contents().mesh.vertices[archive.contents().input_vertices[0][1] as usize];
    assert!(corner.distance(plateau_mesh::DVec3::new(11.340, -1.340, 3.186)) < 0.01, "{corner}");
}

#[test]
fn the_end_of_a_guide_beside_a_boundary_point_is_that_point() {
    for name in ["guide_off_by_rounding", "guide_off_by_1e-13"] {
        let (statistics, warnings, _) = solved(name, &case(name));
        assert!((number(&statistics, "/area") - 70.3194).abs() < 1e-3, "{name}: {}", statistics["area"]);
        assert_eq!((&statistics["converged"], codes(&warnings)), (&json!(true), vec!["joined"]), "{name}");
        assert!(number(&statistics, "/angles_deg/min") > 5.0, "{name}: {}", statistics["angles_deg"]);
    }
}

#[test]
fn a_guide_ends_on_a_side_without_a_point_there_and_the_numbering_of_the_points_stays() {
    let request = case("guide_to_a_side");
    let (statistics, warnings, archive) = solved("guide_to_a_side", &request);
    assert!((number(&statistics, "/area") - 70.3194).abs() < 1e-3, "{}", statistics["area"]);
    assert_eq!((&statistics["converged"], codes(&warnings)), (&json!(true), vec![]));
    let contents = archive.contents();
    assert_eq!(contents.input_vertices[0].len(), 4);
    for (&v, point) in contents.input_vertices[0].iter().zip(request["boundaries"][0].as_array().unwrap()) {
        assert_eq!(json!(contents.mesh.vertices[v as usize].to_array()), *point);
    }
    let mut kept = request;
    kept["boundary_sampling"] = json!("keep");
    kept["resolution"] = json!({ "triangles": 400 });
    let (pointers, texts) = refused(&kept);
    assert_eq!(pointers, ["/constraints/polylines/0/0", "/constraints/polylines/0/32"]);
    assert!(texts.contains("the segment from /boundaries/0/0 to /boundaries/0/1"), "{texts}");
}

#[test]
fn a_guide_along_sides_of_the_outline_changes_nothing() {
    let mut request = case("guide_along_sides");
    let (statistics, warnings, _) = solved("guide_along_sides", &request);
    assert!((number(&statistics, "/area") - 64.0).abs() < 1e-9, "{}", statistics["area"]);
    assert!(warnings.is_empty(), "{warnings:?}");
    // Both ends on one segment.
    request["constraints"]["polylines"] = json!([[[1, 0, 0], [3, 0, 0]]]);
    let (statistics, warnings, _) = solved("a guide on a part of a side", &request);
    assert!((number(&statistics, "/area") - 64.0).abs() < 1e-9 && warnings.is_empty(), "{warnings:?}");
}

#[test]
fn films_with_level_guides_and_flat_parts_are_not_withheld() {
    for (name, area) in [("guide_closed_level", 336.0), ("guide_closed_level_off_centre", 0.0), ("roof_half_flat", 0.0)]
    {
        let (statistics, warnings, _) = solved(name, &case(name));
        assert_eq!(statistics["converged"], true, "{name}: {warnings:?}");
        // The closed form for circles is 337.3. Polygons of 40 and 30 points span a little less.
        let found = number(&statistics, "/area");
        assert!(area == 0.0 || (found - area).abs() < 2.0, "{name}: {found}");
    }
}

#[test]
fn crossing_guides_are_named_if_they_have_no_common_point() {
    let square = json!([[0, 0, 0], [4, 0, 0], [8, 0, 0], [8, 4, 0], [8, 8, 0], [4, 8, 0], [0, 8, 0], [0, 4, 0]]);
    let request = |one: Value, other: Value| {
        json!({ "kind": "minimal_surface", "boundaries": [square], "resolution": { "triangles": 300 },
                "constraints": { "polylines": [one, other] } })
    };
    // With a common point that is off by a rounding error, the guides meet there.
    let across = json!([[4, 0, 0], [4, 4, 1], [4, 8, 0]]);
    let off = request(across.clone(), json!([[0, 4, 0], [4, 4.000_000_000_001, 1], [8, 4, 0]]));
    let (statistics, warnings, _) = solved("crossing guides", &off);
    assert_eq!((&statistics["converged"], codes(&warnings)), (&json!(true), vec!["joined"]));
    // In plan only, and without a point at the crossing.
    for other in [json!([[0, 4, 0], [4, 4, 2], [8, 4, 0]]), json!([[0, 4, 0], [8, 4, 0]])] {
        let (pointers, texts) = refused(&request(across.clone(), other));
        let guides = |pointer: &String| pointer.starts_with("/constraints/polylines/");
        assert!(pointers.len() == 2 && pointers.iter().all(guides), "{pointers:?} {texts}");
        assert!(texts.contains("two curves meet"), "{texts}");
    }
    let mut concave = request(json!([[0, 0, 0], [8, 0, 0]]), json!([[0, 8, 0], [8, 8, 0]]));
    concave["boundaries"] = json!([[[0, 0, 0], [4, 3, 0], [8, 0, 0], [8, 8, 0], [0, 8, 0]]]);
    let (pointers, texts) = refused(&concave);
    assert_eq!(pointers[0], "/constraints/polylines/0/0", "{texts}");
}

#[test]
fn the_end_of_a_cable_across_lies_on_a_segment_and_other_cables_are_refused_there() {
    let edge = |k: u32| json!({ "along": { "from": k, "to": (k + 1) % 4 }, "value": 30 });
    let mut request = json!({
        "kind": "tensile_structure",
        "boundaries": [[[0, 0, 0], [10, 0, 4], [10, 10, 0], [0, 10, 4]]],
        "film": { "tension": 2 },
        "cables": [edge(0), edge(1), edge(2), edge(3), { "across": [[5, 0, 2], [5, 10, 2]], "value": 20 }],
        "resolution": { "triangles": 400 }
    });
    let (statistics, warnings, archive) = solved("a ridge", &request);
    assert_eq!((&statistics["converged"], codes(&warnings)), (&json!(true), vec![]), "{statistics}");
    assert_eq!(archive.contents().input_vertices[0].len(), 4);
    assert!(number(&statistics, "/cables/4/length") < 10.0, "{}", statistics["cables"][4]);
    request["cables"][4] = json!({ "points": [[5, 0, 2], [5, -5, 0]], "value": 20 });
    let (pointers, texts) = refused(&request);
    assert_eq!(pointers, ["/cables/4/points/0"]);
    assert!(texts.contains("the segment from /boundaries/0/0 to /boundaries/0/1"), "{texts}");
    request["cables"].as_array_mut().unwrap().pop();
    request["masts"] = json!([{ "points": [[5, 5, -3], [5, 0, 2]], "value": 8 }]);
    assert_eq!(refused(&request).0, ["/masts/0/points/1"]);
}

/// A request, and the pointer of a point of it that is moved.
type Design = (Value, &'static str);

/// Draws a tent or a film with an end that should be joined.
fn design(random: &mut SplitMix64) -> Design {
    let scale = [1.0, 0.01, 250.0][random.below(3)];
    let size = |random: &mut SplitMix64, low: f64, high: f64| scale * random.between(low, high);
    let (w, d) = (size(random, 8.0, 12.0), size(random, 8.0, 12.0));
    let heights: Vec<f64> = (0..4).map(|k| size(random, 3.0, 4.0) * f64::from(k % 2)).collect();
    let corner = |k: usize| [[0.0, 0.0], [w, 0.0], [w, d], [0.0, d]][k];
    let corners: Vec<[f64; 3]> = (0..4).map(|k| [corner(k)[0], corner(k)[1], heights[k]]).collect();
    let tension = 1.0 / scale;
    let edge = |k: usize| json!({ "along": { "from": k, "to": (k + 1) % 4 }, "value": 12 });
    let mut tent = json!({
        "kind": "tensile_structure", "boundaries": [corners], "film": { "tension": tension },
        "cables": [edge(0), edge(1), edge(2), edge(3)], "resolution": { "triangles": 150 }
    });
    let out = |k: usize, by: f64, z: f64| {
        let sign = |x: f64| if x > 0.0 { 1.0 } else { -1.0 };
        [corners[k][0] + by * sign(corner(k)[0]), corners[k][1] + by * sign(corner(k)[1]), z]
    };
    let guide = |points: Value, more: Value| {
        let side = [[0.0, 0.0, 0.0], [0.5 * w, 0.0, 0.0], [w, 0.0, 0.0], [w, 0.5 * d, 0.0]];
        let other = [[w, d, 0.0], [0.5 * w, d, 0.0], [0.0, d, 0.0], [0.0, 0.5 * d, 0.0]];
        let outline = [side, other].concat();
        json!({ "kind": "minimal_surface", "boundaries": [outline], "resolution": { "triangles": 250 },
                "constraints": { "polylines": [points, more] } })
    };
    let arch = |random: &mut SplitMix64| -> Vec<[f64; 3]> {
        let rise = scale * random.between(0.5, 2.0);
        let count = 3 + random.below(6);
        (0..=count)
            .map(|k| {
                let t = k as f64 / count as f64;
                [0.5 * w, t * d, if k % count == 0 { 0.0 } else { rise * (4.0 * t * (1.0 - t)) }]
            })
            .collect()
    };
    let cables = tent["cables"].as_array_mut().expect("a list");
    match random.below(7) {
        // Two guys hold a free corner.
        0 => {
            cables.push(json!({ "points": [corners[1], out(1, 3.0 * scale, heights[1])], "value": 20 }));
            cables.push(json!({ "points": [corners[1], out(1, 0.5 * scale, 0.0)], "value": 4 }));
            tent["free_points"] = json!([{ "point": 1 }]);
            (tent, ["/cables/4/points/0", "/cables/5/points/0"][random.below(2)])
        }
        // A mast and two guys hold a free corner.
        1 => {
            cables.push(json!({ "points": [corners[1], out(1, 4.0 * scale, 0.0)], "value": 25 }));
            tent["masts"] = json!([{ "points": [[w, 0.0, 0.0], corners[1]], "value": heights[1] }]);
            tent["free_points"] = json!([{ "point": 1 }]);
            (tent, "/masts/0/points/1")
        }
        // A joint between three guys.
        2 => {
            let joint = out(1, 2.0 * scale, heights[1]);
            cables.push(json!({ "points": [corners[1], joint], "value": 20 }));
            cables.push(json!({ "points": [joint, out(1, 5.0 * scale, 0.0)], "value": 14 }));
            let aside = [joint[0] + 4.0 * scale, joint[1] + 2.0 * scale, 0.0];
            cables.push(json!({ "points": [aside, joint], "value": 14 }));
            tent["free_points"] = json!([{ "point": 1 }]);
            tent["joints"] = json!([joint]);
            (tent, ["/joints/0", "/cables/5/points/0", "/cables/6/points/1"][random.below(3)])
        }
        // A ridge between two corners.
        3 => {
            let middle = [0.5 * w, 0.5 * d, 0.5 * (heights[1] + heights[3])];
            cables.push(json!({ "across": [corners[1], middle, corners[3]], "value": 8 }));
            (tent, ["/cables/4/across/0", "/cables/4/across/2"][random.below(2)])
        }
        // Two cables across that meet.
        4 => {
            let middle = [0.5 * w, 0.5 * d, 2.0 * scale];
            cables.push(json!({ "across": [corners[1], middle, corners[3]], "value": 8 }));
            cables.push(json!({ "across": [corners[0], middle, corners[2]], "value": 8 }));
            (tent, "/cables/5/across/1")
        }
        // An arch between two points of the boundary.
        5 => {
            let points = arch(random);
            let last = if random.below(2) == 0 { 0 } else { points.len() - 1 };
            let mut film = guide(json!(points), json!(null));
            film["constraints"]["polylines"].as_array_mut().expect("a list").pop();
            (film, Box::leak(format!("/constraints/polylines/0/{last}").into_boxed_str()))
        }
        // Two arches with a common point.
        _ => {
            let points: Vec<[f64; 3]> =
                (0..=4).map(|k| f64::from(k) / 4.0).map(|t| [0.5 * w, t * d, scale * 4.0 * t * (1.0 - t)]).collect();
            let other = [[0.0, 0.5 * d, 0.0], points[2], [w, 0.5 * d, 0.0]];
            let moved = ["/constraints/polylines/1/0", "/constraints/polylines/1/1"][random.below(2)];
            (guide(json!(points), json!(other)), moved)
        }
    }
}

/// Returns the points of a request, at any depth.
fn points(value: &Value, found: &mut Vec<plateau_mesh::DVec3>) {
    match value {
        Value::Array(list) if list.len() == 3 && list.iter().all(Value::is_number) => {
            let axis = |k: usize| list[k].as_f64().unwrap_or_default();
            found.push(plateau_mesh::DVec3::new(axis(0), axis(1), axis(2)));
        }
        Value::Array(list) => list.iter().for_each(|entry| points(entry, found)),
        Value::Object(members) => members.values().for_each(|member| points(member, found)),
        _ => {}
    }
}

/// Moves the point at a pointer by a distance in a random direction; 0 stands for one unit in the last place.
fn moved(request: &Value, pointer: &str, by: f64, random: &mut SplitMix64) -> Value {
    let mut all = Vec::new();
    points(request, &mut all);
    let size = plateau_mesh::polyline::radius(&all);
    let mut request = request.clone();
    let point = request.pointer_mut(pointer).expect("a point").as_array_mut().expect("three numbers");
    let direction = plateau_mesh::DVec3::new(random.unit() - 0.5, random.unit() - 0.5, random.unit() - 0.5);
    for (axis, step) in direction.normalize().to_array().into_iter().enumerate() {
        let here = point[axis].as_f64().expect("a number");
        point[axis] = json!(if by == 0.0 { here.next_up() } else { here + by * size * step });
    }
    request
}

fn bits(archive: &Archive) -> (Vec<[u64; 3]>, Vec<[u32; 3]>) {
    let mesh = &archive.contents().mesh;
    (mesh.vertices.iter().map(|vertex| vertex.to_array().map(f64::to_bits)).collect(), mesh.triangles.clone())
}

#[test]
fn moved_ends_give_the_same_mesh_or_are_refused_by_name_and_farther_ones_are_named() {
    let count = if is_full() { 400 } else { 14 };
    let mut ends = std::collections::BTreeMap::new();
    for k in 0..count {
        let random = &mut SplitMix64::new(k);
        let (request, pointer) = design(random);
        let member = pointer.rsplit_once('/').map_or(pointer, |(member, _)| member);
        let (statistics, warnings, at_its_place) = solved(&format!("{k} {request}"), &request);
        assert!(!codes(&warnings).contains(&"joined"), "{k}: {warnings:?}");
        assert_eq!(statistics["converged"], true, "{k}: {warnings:?} {request}");
        for by in [0.0, 1e-12, 1e-9, 1e-7] {
            let request = moved(&request, pointer, by, random);
            match end(&request) {
                End::Solved(solved) => {
                    let (_, warnings, archive) = *solved;
                    assert!(bits(&archive) == bits(&at_its_place), "{k} by {by}: {request}");
                    assert_eq!(codes(&warnings)[0], "joined", "{k} by {by}: {warnings:?}");
                    *ends.entry("joined").or_insert(0) += 1;
                }
                End::Refused(pointers, texts) => {
                    assert!(pointers.iter().any(|own| own.starts_with(member)), "{k} by {by}: {pointers:?} {texts}");
                    *ends.entry("refused by name").or_insert(0) += 1;
                }
            }
        }
        // Only ends are named if they are near a point.
        let is_inner = ["/across/1", "/polylines/1/1"].iter().any(|inner| pointer.ends_with(inner));
        for by in [1e-4, 1e-3].into_iter().filter(|_| !is_inner) {
            let request = moved(&request, pointer, by, random);
            match end(&request) {
                End::Solved(solved) => {
                    assert!(codes(&solved.1).contains(&"nearly_joined"), "{k} by {by}: {:?} {request}", solved.1);
                    *ends.entry("nearly, with a warning").or_insert(0) += 1;
                }
                End::Refused(_, texts) => {
                    let is_named = texts.contains("not joined to it") || texts.contains("more than join_tolerance");
                    assert!(is_named, "{k} by {by}: {texts} {request}");
                    *ends.entry("nearly, named in the error").or_insert(0) += 1;
                }
            }
        }
    }
    println!("{count} designs: {ends:?}");
}

#[test]
fn points_of_slits_and_near_double_points_of_boundaries_stay_apart() {
    let count = if is_full() { 50 } else { 5 };
    for k in 0..count {
        let random = &mut SplitMix64::new(1000 + k);
        let width = 10f64.powf(-random.between(5.0, 8.5));
        let (x, depth) = (random.between(3.0, 7.0), random.between(2.0, 6.0));
        // A slit from the lower side, whose two rims are `width` apart, and a guide from each rim.
        let boundary = json!([
            [0.0, 0.0, 0.0],
            [x - width, 0.0, 0.0],
            [x - width, 0.5 * depth, 0.2],
            [x, depth, 0.4],
            [x + width, 0.5 * depth, 0.2],
            [x + width, 0.0, 0.0],
            [10.0, 0.0, 0.0],
            [10.0, 10.0, 0.0],
            [0.0, 10.0, 0.0]
        ]);
        let left = json!([[x - width, 0.5 * depth, 0.2], [1.0, 0.5 * depth, 0.3]]);
        let right = json!([[x + width, 0.5 * depth, 0.2], [9.0, 0.5 * depth, 0.3]]);
        let request = json!({ "kind": "minimal_surface", "boundaries": [boundary], "resolution": { "triangles": 300 },
                              "constraints": { "polylines": [left, right] } });
        if let End::Solved(solved) = end(&request) {
            let (_, warnings, archive) = *solved;
            assert!(!codes(&warnings).contains(&"joined"), "{k}: {warnings:?}");
            let contents = archive.contents();
            for (&v, point) in contents.input_vertices[0].iter().zip(request["boundaries"][0].as_array().unwrap()) {
                assert_eq!(json!(contents.mesh.vertices[v as usize].to_array()), *point, "{k}");
            }
        }
        // An end between the two rims belongs to neither.
        let mut between = request.clone();
        between["constraints"]["polylines"][0][0][0] = json!(x);
        match end(&between) {
            End::Refused(pointers, texts) if width < 2e-6 => {
                assert_eq!(pointers, ["/constraints/polylines/0/0"], "{k}: {texts}");
                assert!(texts.contains("/boundaries/0/2") && texts.contains("/boundaries/0/4"), "{texts}");
            }
            End::Refused(..) => {}
            // In a slit wider than the tolerance of 9e-6 the end is a place of its own, to which a film can be drawn.
            End::Solved(solved) => {
                assert!(width > 9e-6, "{k}: {width}");
                let codes = codes(&solved.1);
                assert!(codes.contains(&"nearly_joined") && !codes.contains(&"joined"), "{k}: {codes:?}");
            }
        }
    }
}
