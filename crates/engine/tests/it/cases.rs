//! Regression tests: requests that are known to have given wrong results which looked right. Each is checked against
//! the right result.
//!
//! The requests are in `crates/engine/tests/cases`. References are closed forms, or Surface Evolver's results on the
//! same boundary.

use crate::{MOST_WORK, read, solve};
use plateau_engine::solved::{Signal, Unsolved};
use serde_json::Value;

fn body(name: &str) -> Vec<u8> {
    std::fs::read(format!("{}/tests/cases/{name}.json", env!("CARGO_MANIFEST_DIR"))).expect("a case")
}

/// Solves the request of a case. Returns its statistics and the codes of all its warnings.
fn solved(name: &str) -> (Value, Vec<String>) {
    solved_body(name, &body(name))
}

/// Same as [`solved`], for the body of a request. `name` appears in failure messages only.
fn solved_body(name: &str, body: &[u8]) -> (Value, Vec<String>) {
    let accepted = read(body).unwrap_or_else(|rejection| panic!("{name} is refused: {rejection:?}"));
    let solved = solve(&accepted).unwrap_or_else(|failed| panic!("{name}: {failed:?}"));
    let statistics = serde_json::from_str(&solved.statistics).expect("statistics are JSON");
    (statistics, solved.warnings.iter().map(|warning| warning.code.to_string()).collect())
}

fn has(warnings: &[String], code: &str) -> bool {
    warnings.iter().any(|warning| warning == code)
}

#[test]
fn a_fold_of_180_degrees_is_reported() {
    let (statistics, warnings) = solved("ruled_fold_180");
    assert_eq!(statistics["largest_fold_deg"], 180.0);
    assert!(has(&warnings, "folds"), "{warnings:?}");
}

/// Every bridge of a plane strip is convex, also of one that is folded flat upon itself.
#[test]
fn plane_strips_with_the_most_convex_bridges_are_returned_flat() {
    for (name, area) in [("ruled_plate_with_round_hole", 12.894_171), ("ruled_plane_arcs", 2.356_788)] {
        for secondary in [None, Some("minimal_bending_energy"), Some("minimal_mean_curvature_variation")] {
            let mut request: Value = serde_json::from_slice(&body(name)).unwrap();
            request.as_object_mut().unwrap().remove("secondary_objective");
            if let Some(secondary) = secondary {
                request["secondary_objective"] = secondary.into();
            }
            let (statistics, warnings) = solved_body(name, request.to_string().as_bytes());
            let found = statistics["area"].as_f64().unwrap();
            assert!((found - area).abs() < 1e-6, "{name} {secondary:?}: {found} for {area}");
            assert!(statistics["largest_fold_deg"].as_f64().unwrap() < 1e-5, "{name} {secondary:?}");
            assert_eq!(statistics["convex_bridge_ratio"], 1.0);
            assert!(warnings.is_empty(), "{name} {secondary:?}: {warnings:?}");
        }
    }
}

/// The directions at the bridge in the middle span 181.5 degrees, so that they reach beyond a half-plane by 0.75
/// degrees on either side. Symptom: the audit measured with 1 degree on one side only, and withheld the strip.
#[test]
fn solver_and_audit_allow_directions_beyond_the_half_plane_on_both_sides() {
    let request = serde_json::json!({
        "kind": "ruled_surface", "convexity_tolerance_deg": 1.0, "objective": "minimal_area",
        "directrices": [
            [[1, 0, 0], [0, 0, 0], [-0.999_657_324_975_557_3, -0.026_176_948_307_873_153, 0]],
            [[0.5, 1, 1], [0, 0, 1], [-0.5, 1, 1]]
        ],
    });
    let (statistics, _) = solved_body("a bridge within the tolerance", request.to_string().as_bytes());
    assert_eq!(statistics["convex_bridges"], 5);
    // A rail of 19 points with straight pieces and one of 324, as they came out of f32.
    solved("strip_withheld_by_one_bridge");
}

/// Two sections of a wind turbine's blade (IEA 15 MW), whose trailing edge is sharp.
#[test]
fn a_profiles_own_sharp_edge_is_no_fold_of_the_strip() {
    let (statistics, warnings) = solved("ruled_blade_sections");
    assert!(statistics["largest_fold_deg"].as_f64().unwrap() > 150.0);
    assert!(!has(&warnings, "folds"), "{warnings:?}");
}

#[test]
fn a_boundary_that_runs_out_and_back_names_the_points_that_it_passes_twice() {
    let pointers = |request: Value| -> Vec<String> {
        match read(request.to_string().as_bytes()) {
            Err(plateau_strict_json::rejection::Rejection::Invalid(errors)) => {
                errors.into_iter().map(|error| error.pointer).collect()
            }
            other => panic!("{other:?}"),
        }
    };
    let spike: Value = serde_json::from_slice(&body("film_spike")).unwrap();
    assert_eq!(pointers(spike), ["/boundaries/0/3", "/boundaries/0/4"]);
    let boundary = |extra: &[[f64; 3]]| -> Value {
        let corners = [[0.0, 0.0, 0.0], [0.5, 0.0, 0.2]].iter().chain(extra);
        let rest = [[1.0, 0.0, 0.4], [1.0, 1.0, 0.0], [0.0, 1.0, 0.4]];
        let points: Vec<[f64; 3]> = corners.chain(&rest).copied().collect();
        serde_json::json!({ "kind": "minimal_surface", "boundaries": [points] })
    };
    // A slit of two pieces, one ulp apart on the way back, and a side that overshoots a corner.
    let slit = [[0.5, 0.3, 0.25], [0.6, 0.6, 0.25], [0.5, 0.3, 0.25f64.next_up()], [0.5f64.next_up(), 0.0, 0.2]];
    assert_eq!(pointers(boundary(&slit)), ["/boundaries/0/3", "/boundaries/0/4", "/boundaries/0/5"]);
    assert_eq!(pointers(boundary(&[[1.5, 0.0, 0.6]])), ["/boundaries/0/2", "/boundaries/0/3"]);
    // A slit with a width has an inside and an outside.
    let open = [[0.5, 0.5, 0.25], [0.501, 0.0, 0.2]];
    read(boundary(&open).to_string().as_bytes()).unwrap_or_else(|rejection| panic!("{rejection:?}"));
}

/// The sides of these triangles differ so much that the longest gets points beside the shortest at every size.
#[test]
fn a_triangle_is_one_triangle_if_that_is_wanted() {
    let corners =
        [[[0.0, 0.0, 0.0], [1.0, 0.0, 0.0], [0.2, 0.1, 0.5]], [[-0.1, -1.0, -1.0], [0.0, 0.9, 0.2], [0.9, 0.1, 0.3]]];
    for corners in corners {
        for initial_mesh in ["auto", "planar", "disk", "rings"] {
            let request = serde_json::json!({
                "kind": "minimal_surface", "boundaries": [corners], "resolution": { "triangles": 1 },
                "initial_mesh": initial_mesh,
            });
            let (statistics, _) = solved_body(initial_mesh, request.to_string().as_bytes());
            assert_eq!((&statistics["triangles"], &statistics["vertices"]), (&1.into(), &3.into()), "{initial_mesh}");
        }
    }
}

/// Twelve radial cables of density 2 between rings of radii 1 and 6, with five hoops. With 2 F sin 15° = 2 s in a hoop,
/// radius k is 1 + 5 k / 6 - s k (6 - k) / 2, which is above 0 up to s = 2 / 3, F = 2.5759.
#[test]
fn a_hoop_that_no_net_has_is_refused_and_one_below_the_limit_is_found() {
    let mut request: Value = serde_json::from_slice(&body("net_hoop_too_strong")).unwrap();
    for force in [2.65, 3.0, 4.0, 10.0, 100.0] {
        request["cables"][0]["force"] = force.into();
        let accepted = read(request.to_string().as_bytes()).unwrap();
        let refused = solve(&accepted).unwrap_err();
        let Unsolved::Failed(error) = refused else { panic!("{refused:?}") };
        assert_eq!(error.kind, "/problems/targets-not-reached", "{force}: {error:?}");
        assert!(error.errors.iter().all(|error| error.pointer.starts_with("/edges/")), "{force}: {:?}", error.errors);
    }
    for force in [1.0, 2.0, 2.5] {
        request["cables"][0]["force"] = force.into();
        let (statistics, warnings) = solved_body("a hoop", request.to_string().as_bytes());
        let s = force * (std::f64::consts::PI / 12.0).sin();
        let radius = |k: f64| 1.0 + 5.0 * k / 6.0 - 0.5 * s * k * (6.0 - k);
        let least = (1..6).map(|k| radius(f64::from(k))).fold(f64::INFINITY, f64::min);
        let edge = 2.0 * least * (std::f64::consts::PI / 12.0).sin();
        let found = statistics["cables"][0]["edge_lengths"]["min"].as_f64().unwrap();
        assert!((found / edge - 1.0).abs() < 1e-3, "{force}: {found} for {edge}, {warnings:?}");
    }
}

#[test]
fn identical_rails_are_said_to_give_empty_triangles() {
    let (statistics, warnings) = solved("ruled_identical");
    assert_eq!(statistics["area"], 0.0);
    assert!(has(&warnings, "empty_triangles"), "{warnings:?}");
}

#[test]
fn a_film_over_a_knot_crosses_itself_and_says_so() {
    let (statistics, warnings) = solved("film_trefoil");
    let pairs = statistics["self_intersections"].as_u64().unwrap();
    assert!((100..200).contains(&pairs), "{pairs}");
    assert!(has(&warnings, "self_intersections"), "{warnings:?}");
}

#[test]
fn a_loop_that_repeats_its_first_point_up_to_rounding_is_a_loop_without_it() {
    let (statistics, warnings) = solved("loop_sampled_with_its_end");
    assert_eq!(statistics["converged"], true);
    assert!((statistics["area"].as_f64().unwrap() - 3.398_85).abs() < 1e-3, "{}", statistics["area"]);
    assert!(has(&warnings, "merged_points"), "{warnings:?}");
}

#[test]
fn points_a_millionth_of_the_radius_apart_leave_a_film_that_converges() {
    let (statistics, warnings) = solved("near_dup_1e-06_along");
    assert_eq!(statistics["converged"], true, "{} {}", statistics["residual"], statistics["stop_reason"]);
    assert!((statistics["area"].as_f64().unwrap() - 3.261_83).abs() < 1e-3, "{}", statistics["area"]);
    assert!(!has(&warnings, "not_converged"), "{warnings:?}");
}

#[test]
fn a_boundary_of_many_points_needs_no_resolution() {
    let points: Vec<[f64; 3]> = (0..3000)
        .map(|k| std::f64::consts::TAU * f64::from(k) / 3000.0)
        .map(|angle| [angle.cos(), angle.sin(), 0.2 * (2.0 * angle).sin()])
        .collect();
    let request = serde_json::json!({"kind": "minimal_surface", "boundaries": [points]});
    let (statistics, warnings) = solved_body("3,000 points", request.to_string().as_bytes());
    let triangles = statistics["triangles"].as_u64().unwrap();
    assert!((9_000..15_000).contains(&triangles), "{triangles}");
    assert_eq!(statistics["converged"], true, "{warnings:?}");
}

#[test]
fn a_strip_is_accepted_by_the_cells_that_its_search_visits() {
    let rail = |phase: f64, y: f64| -> Vec<[f64; 3]> {
        let point = |k: u32| {
            let u = f64::from(k) / 49_999.0;
            [10.0 * u, y + 0.3 * (9.0 * u + phase).sin(), 0.3 * (7.0 * u - phase).cos()]
        };
        (0..50_000).map(point).collect()
    };
    let read_for = |objective: &str| {
        let request = serde_json::json!({
            "kind": "ruled_surface", "directrices": [rail(0.3, 0.0), rail(1.9, 3.0)], "objective": objective
        });
        read(request.to_string().as_bytes())
    };
    // The grid has 2.5e9 cells, more than are accepted. Least area visits a thousandth of them.
    read_for("minimal_area").unwrap_or_else(|rejection| panic!("{rejection:?}"));
    assert!(format!("{:?}", read_for("minimal_twist").unwrap_err()).contains("grid cells"));
}

/// Checks that a case gives a connected film of this area, converged, without self-intersections and warnings.
fn is_connected_film(name: &str, area: f64) {
    let (statistics, warnings) = solved(name);
    let found = statistics["area"].as_f64().unwrap();
    assert!((found / area - 1.0).abs() < 5e-3, "{name}: {found} for {area}, {warnings:?}");
    assert_eq!(statistics["converged"], true);
    assert_eq!((&statistics["components"], &statistics["self_intersections"]), (&1.into(), &0.into()));
    assert!(warnings.is_empty(), "{name}: {warnings:?}");
}

#[test]
fn five_to_eight_rings_that_face_outwards_have_a_connected_film() {
    is_connected_film("loops_bipyr5_0.97_fixed", 3.718);
    is_connected_film("loops_cube_0.97_fixed", 3.760);
    // This search for the best of eight loops takes half a minute in a debug build.
    if crate::is_full() {
        is_connected_film("loops_octa_0.97_best", 2.140);
    }
}

#[test]
fn a_film_past_its_limit_is_refused_although_a_coarse_mesh_holds_it_and_one_before_it_is_said_to_be_near_it() {
    let past = body("film_ring_past_critical");
    let accepted = read(&past).expect("a valid request");
    let Err(failed) = solve(&accepted) else { panic!("no such film exists") };
    assert!(format!("{failed:?}").contains("connected"), "{failed:?}");
    // The distance of the rings is reduced from 1.002 to 0.996 of the largest one at which a connected film exists.
    let before = String::from_utf8(past).expect("JSON").replace("0.664", "0.66");
    let (statistics, warnings) = solved_body("the same before the limit", before.as_bytes());
    assert_eq!(statistics["stability"]["stable"], true);
    assert!(has(&warnings, "near_critical"), "{warnings:?}");
}

#[test]
fn the_extrapolated_area_at_a_notch_allows_for_what_finer_meshes_reach() {
    let (statistics, _) = solved("slit_3d_3000");
    let figure = |name: &str| statistics["extrapolated_area"][name].as_f64().unwrap();
    let (area, error) = (figure("area"), figure("error_estimate"));
    assert!(area - error <= 4.108_672 && area + error >= 4.108_0, "{area} {error}");
}

/// The outline lies in a plane to 1.3e-15. Exact arithmetic shows that sides 1 and 31 cross as seen from above, where
/// their heights differ by 4e-16.
#[test]
fn a_canopy_whose_sides_cross_is_refused_with_pointers_to_both() {
    let accepted = read(&body("film_canopy")).unwrap();
    let refused = solve(&accepted).unwrap_err();
    let Unsolved::Failed(error) = refused else { panic!("{refused:?}") };
    assert_eq!(error.kind, "/problems/self-intersecting-boundary");
    let pointers: Vec<&str> = error.errors.iter().map(|error| &error.pointer[..]).collect();
    assert_eq!(pointers, ["/boundaries/0/1", "/boundaries/0/31"]);
}

/// The request is a closed ruled surface between two loops of 69 points each, with flat caps.
#[test]
fn area_and_triangles_of_a_stack_are_those_of_its_mesh_caps_included() {
    let accepted = read(&body("ruled_caps")).unwrap();
    let solved = solve(&accepted).unwrap();
    let statistics: Value = serde_json::from_str(&solved.statistics).unwrap();
    let mesh = &solved.archive.contents().mesh;
    let of = |&t: &[u32; 3]| {
        let [a, b, c] = t.map(|v| mesh.vertices[v as usize]);
        0.5 * (b - a).cross(c - a).length()
    };
    let area: f64 = mesh.triangles.iter().map(of).sum();
    assert_eq!(statistics["triangles"], 272);
    assert_eq!(statistics["strips"][0]["triangles"], 138);
    assert!((statistics["area"].as_f64().unwrap() / area - 1.0).abs() < 1e-12, "{} and {area}", statistics["area"]);
    let strip = statistics["strips"][0]["area"].as_f64().unwrap();
    assert_eq!(statistics["objective_value"].as_f64(), Some(strip));
    assert!(strip < area);
}

#[test]
fn a_film_with_one_side_is_refused_in_words() {
    let refused = read(&body("moebius_own")).unwrap_err();
    assert!(format!("{refused:?}").contains("has one side only, as a Möbius band"), "{refused:?}");
}

#[test]
fn a_cone_of_eight_junctions_is_said_to_be_no_soap_film() {
    let (statistics, warnings) = solved("cube_cone2_4");
    assert!(statistics["junctions"]["morse_index"].is_null(), "{}", statistics["junctions"]);
    assert!(has(&warnings, "junction_point"), "{warnings:?}");
}

#[test]
fn angles_at_re_entrant_corners_do_not_fall_with_the_resolution() {
    let (statistics, warnings) = solved("film_T_roof_200000");
    assert_eq!(statistics["converged"], true, "{warnings:?}");
    assert!(statistics["angles_deg"]["min"].as_f64().unwrap() >= 20.0, "{}", statistics["angles_deg"]);
}

/// On a mesh with the same number of triangles, Surface Evolver finds an area of 3.686, with 8 flipped triangles.
#[test]
fn a_noisy_loop_that_leaves_flipped_triangles_is_not_called_converged() {
    let (statistics, warnings) = solved("film_gps_corr_4000");
    let (flipped, area) = (statistics["flipped_triangles"].as_u64().unwrap(), statistics["area"].as_f64().unwrap());
    assert!(flipped <= 8 && area < 3.69, "{flipped} flipped, area {area}");
    assert_eq!(statistics["converged"] == true, flipped == 0);
    assert!(flipped == 0 || has(&warnings, "not_converged"), "{warnings:?}");
}

/// Checks the uniform mesh of a case under an objective: no triangle crosses another, and its area is that of the
/// surface within a hundredth. A mesh that did not converge may miss the area, and then has a warning that says so.
fn is_faithful(name: &str, objective: &str, area: Option<f64>) {
    let mut request: Value = serde_json::from_slice(&body(name)).unwrap();
    request["objective"] = objective.into();
    let (statistics, warnings) = solved_body(name, request.to_string().as_bytes());
    let surface = &statistics["surface"];
    let name = format!("{name}, {objective}");
    assert_eq!(statistics["self_intersections"], 0, "{name}");
    assert_eq!(statistics["converged"] == true, !has(&warnings, "not_converged"), "{name}: {warnings:?}");
    let error = surface["area_error"].as_f64().unwrap();
    assert!(error.abs() < 0.01 || statistics["converged"] == false, "{name}: {surface}");
    if let Some(area) = area {
        let found = surface["area"].as_f64().unwrap();
        assert!((found / area - 1.0).abs() < 0.01, "{name}: {found}, not {area}");
        assert_eq!(statistics["converged"], true, "{name}: {warnings:?}");
        assert!(statistics["angles_deg"]["min"].as_f64().unwrap() > 5.0, "{name}: {}", statistics["angles_deg"]);
    }
}

#[test]
fn uniform_meshes_of_strongly_curved_surfaces_keep_their_area_or_say_that_they_do_not() {
    let objectives = ["fewest_nodes", "most_equal_edges"];
    for objective in &objectives[..if crate::is_full() { 2 } else { 1 }] {
        is_faithful("uni_panic_amp8_l2", objective, None);
        is_faithful("uni_saddle12", objective, Some(678.2));
        is_faithful("uni_rings", objective, Some(487.9));
        is_faithful("uni_dome_bezier_tall", objective, None);
    }
}

/// In a tilted plane the exact residual is 0, but rounding leaves small forces on the vertices.
#[test]
fn the_residual_is_that_of_the_mesh_down_to_rounding() {
    let corner = |x: f64, y: f64| [x, 0.8 * y + 0.1 * x, 0.3 * x - 0.7 * y];
    let square = [corner(0.1, 0.0), corner(1.3, 0.2), corner(1.1, 1.4), corner(-0.2, 0.9)];
    let request = serde_json::json!({
        "kind": "minimal_surface", "boundaries": [square], "resolution": {"triangles": 300}
    });
    let (statistics, _) = solved_body("a tilted square", request.to_string().as_bytes());
    let residual = statistics["residual"].as_f64().unwrap();
    assert!(residual > 0.0 && residual < 1e-9, "{residual}");
}

/// Returns hard requests of every kind, in addition to the files of cases.
fn hard_cases() -> Vec<(String, Value)> {
    let ring = |n: usize, x: f64, z: f64, radius: f64| -> Vec<[f64; 3]> {
        let angles = (0..n).map(|k| std::f64::consts::TAU * k as f64 / n as f64);
        angles.map(|angle| [x + radius * angle.cos(), radius * angle.sin(), z]).collect()
    };
    let film =
        |boundaries: Vec<Vec<[f64; 3]>>| serde_json::json!({"kind": "minimal_surface", "boundaries": boundaries});
    let mut best = film((0..4).map(|k| ring(24, 0.9 * f64::from(k % 2), 0.4 * f64::from(k / 2), 1.0)).collect());
    best["topology"] = "best".into();
    let mut pairs = film((0..8).map(|k| ring(12, 3.0 * f64::from(k / 2), 0.2 * f64::from(k % 2), 1.0)).collect());
    pairs["topology"] = "free".into();
    pairs["certify"] = serde_json::json!({"gap": 0, "seconds": 0.3});
    let fan = serde_json::json!({
        "kind": "ruled_surface", "closed": true,
        "directrices": [ring(3, 0.0, 0.0, 1e-3), ring(7_500, 0.3, 1.0, 1.0)],
    });
    let lattice = serde_json::json!({
        "kind": "uniform_mesh", "objective": "most_equal_edges", "edge_length": 0.02,
        "domain": {"polygon": ring(64, 0.0, 0.0, 1.0), "holes": [ring(24, 0.5, 0.0, 0.2), ring(24, -0.5, 0.0, 0.2)]},
    });
    let grid = 40;
    let vertices: Vec<[f64; 3]> = (0..grid * grid).map(|v| [f64::from(v % grid), f64::from(v / grid), 0.0]).collect();
    let edges: Vec<[i32; 2]> = (0..grid * grid)
        .flat_map(|v| {
            let right = (v % grid + 1 < grid).then_some([v, v + 1]);
            right.into_iter().chain((v / grid + 1 < grid).then_some([v, v + grid]))
        })
        .collect();
    let net = serde_json::json!({
        "kind": "cable_net", "vertices": vertices, "supports": [0, grid - 1, grid * grid - grid, grid * grid - 1],
        "cables": [{"name": "all", "edges": (0..edges.len()).collect::<Vec<_>>(), "force_density": 1.0}],
        "loads": [{"vertices": (0..grid * grid).collect::<Vec<_>>(), "force": [0, 0, -0.1]}], "edges": edges,
    });
    let sail = serde_json::json!({
        "kind": "tensile_structure", "boundaries": [[[0, 0, 0], [10, 0, 4], [10, 10, 0], [0, 10, 4]]],
        "film": {"tension": 2}, "resolution": {"triangles": 20_000},
        "cables": (0..4).map(|k| serde_json::json!({
            "name": format!("edge {k}"), "along": {"from": k, "to": (k + 1) % 4}, "mode": "force", "value": 30
        })).collect::<Vec<_>>(),
    });
    [("best", best), ("pairs", pairs), ("fan", fan), ("lattice", lattice), ("net", net), ("sail", sail)]
        .map(|(name, value)| (name.to_owned(), value))
        .into()
}

/// A solver cannot be cancelled while it works without a check of the signal.
#[test]
fn no_solver_works_for_long_without_a_look_at_the_signal() {
    // The first tier looks at the files where another test solves them, and leaves out the case that takes seconds.
    let folders: &[&str] = if crate::is_full() { &["tests/cases", "tests/cases/tensile"] } else { &[] };
    let files = folders.iter().flat_map(|folder| {
        let folder = format!("{}/{folder}", env!("CARGO_MANIFEST_DIR"));
        std::fs::read_dir(folder).expect("the cases").map(|entry| entry.expect("a case").path())
    });
    let mut cases: Vec<(String, Value)> = files
        .filter(|path| path.is_file())
        .map(|path| {
            let value = serde_json::from_slice(&std::fs::read(&path).expect("a case")).expect("JSON");
            (path.file_stem().unwrap_or_default().to_string_lossy().into_owned(), value)
        })
        .collect();
    cases.sort_by(|a, b| a.0.cmp(&b.0));
    cases.extend(hard_cases());
    if !crate::is_full() {
        cases.retain(|(name, _)| name != "best");
    }
    let mut kinds = std::collections::BTreeSet::new();
    for (name, value) in cases {
        let body = value.to_string();
        let Ok(accepted) = read(body.as_bytes()) else { continue };
        let last = std::cell::Cell::new(std::time::Instant::now());
        let longest = std::cell::Cell::new(0.0f64);
        let signal = || {
            let now = std::time::Instant::now();
            longest.set(longest.get().max(now.duration_since(last.replace(now)).as_secs_f64()));
            Signal::Continue
        };
        let (result, work) = accepted.solve_and_count(&signal, &|_| {});
        println!("{name}: {work} between two looks, {:.0} ms at most", 1e3 * longest.get());
        assert!(work <= MOST_WORK, "{name}: {work}");
        if result.is_ok() {
            kinds.insert(value["kind"].to_string());
        }
    }
    assert_eq!(kinds.len(), 5, "kinds of which a case was solved: {kinds:?}");
}

#[test]
fn fixed_and_free_find_the_connected_film_that_best_finds() {
    let cases = [
        ("spiky_loops_fixed", 0.4906),
        ("spiky_loops_fixed_2000", 4.096),
        ("spiky_loops_fixed_5000", 3.228),
        ("three_spiky_loops_fixed", 8.4285),
        ("loops_of_111_points_free", 1.8227),
    ];
    for (name, area) in cases {
        let (statistics, warnings) = solved(name);
        let found = statistics["area"].as_f64().unwrap();
        assert!((found / area - 1.0).abs() < 1e-3, "{name}: {found} for {area}, {warnings:?}");
        assert_eq!((&statistics["converged"], &statistics["components"]), (&true.into(), &1.into()), "{name}");
    }
}

#[test]
fn best_finds_the_connected_film_that_fixed_finds() {
    // A strip of triangles between the two loops of the first case has the area 2.497, so that a connected film of less
    // area exists. The discs have 13.34. The films of the others are found on coarser meshes, and at the full size only
    // from these. Their discs have 10.06 and 10.80 and cross. The first tier leaves out the last case, which takes long.
    let cases =
        [("spiky_loops_that_cross_best", 2.195), ("spiky_loops_best_5000", 3.8555), ("spiky_loops_best_4000", 3.228)];
    for (name, area) in cases.into_iter().take(if crate::is_full() { 3 } else { 2 }) {
        let (statistics, warnings) = solved(name);
        let found = statistics["area"].as_f64().unwrap();
        assert!((found / area - 1.0).abs() < 1e-3, "{name}: {found} for {area}, {warnings:?}");
        assert_eq!((&statistics["converged"], &statistics["components"]), (&true.into(), &1.into()), "{name}");
        assert_eq!(statistics["spanning"]["connected_film_exists"], true, "{name}");
    }
}

#[test]
fn the_largest_gap_is_that_of_the_catenoid() {
    // The largest catenoid between circles of radius 1 and r has the height max c (acosh(1 / c) + acosh(r / c)).
    // The first tier takes the coarse film, on which the neck is the hardest to see.
    let cases = [("rings_past_critical_300", 0.6803), ("rings_past_critical_2000", 0.4580)];
    for (name, fraction) in cases.into_iter().take(if crate::is_full() { 2 } else { 1 }) {
        let (statistics, _) = solved(name);
        let found = statistics["spanning"]["largest_gap_fraction"].as_f64().unwrap();
        assert!((found / fraction - 1.0).abs() < 0.02, "{name}: {found} for {fraction}");
    }
}

#[test]
fn a_scan_whose_boundary_turns_to_and_fro_has_no_flipped_triangle() {
    let (statistics, warnings) = solved("scan_of_500_points");
    assert_eq!((&statistics["converged"], &statistics["flipped_triangles"]), (&true.into(), &0.into()), "{warnings:?}");
}

#[test]
fn a_net_with_a_limit_of_steps_is_fitted() {
    // The loss of the start is 0.974. SciPy's least squares end at 0.0087.
    let (statistics, _) = solved("net_of_given_lengths");
    let loss = statistics["objective_value"].as_f64().unwrap();
    assert!(loss < 0.01, "{loss}");
}
