//! Initial meshes: from boundaries alone (plane polygons, four corners, graded spacing), from the client's own mesh,
//! and with fixed points and curves. Also faulty inputs.

use crate::boundaries::{self, circle, helicoid, rings, sides};
use plateau_mesh::measure;
use plateau_mesh::polyline::{self, SAME_POINT};
use plateau_mesh::{DVec3, Error, Execution, Interruption, Mesh, Signal};
use plateau_minimal_surface::{
    BoundarySampling, Constraints, InitialMesh, Method, MinimalSurface, Newton, OnUnstable, Options, Resolution,
    TopologyRule, VertexRelaxation, solve,
};
use std::cell::Cell;
use std::f64::consts::TAU;

fn at(x: f64, y: f64, z: f64) -> DVec3 {
    DVec3::new(x, y, z)
}

fn flat(corners: &[(f64, f64)]) -> Vec<DVec3> {
    corners.iter().map(|&(x, y)| at(x, y, 0.0)).collect()
}

fn curve(points: usize, place: impl Fn(f64) -> DVec3) -> Vec<DVec3> {
    (0..points).map(|k| place(TAU * k as f64 / points as f64)).collect()
}

fn options(triangles: usize) -> Options {
    Options::new(Resolution::Triangles(triangles))
}

fn keep(triangles: usize) -> Options {
    Options { boundary_sampling: BoundarySampling::Keep, ..options(triangles) }
}

fn solved(given: &[Vec<DVec3>], options: &Options) -> MinimalSurface {
    let surface = solve(given, options, &Execution::default()).unwrap();
    valid(given, &surface);
    surface
}

/// Checks that the mesh is a manifold whose boundary loops are the given ones. The input points must be vertices in the
/// given order and at exactly their positions (merged points only nearly).
fn valid(given: &[Vec<DVec3>], surface: &MinimalSurface) {
    let topology = surface.mesh.check().unwrap();
    assert_eq!(topology.boundary_loops().len(), given.len());
    for (points, (vertices, boundary)) in given.iter().zip(surface.input_vertices.iter().zip(&surface.boundaries)) {
        for (point, &vertex) in points.iter().zip(vertices) {
            let there = surface.mesh.vertices[vertex as usize];
            let merged = surface.warnings.iter().any(|warning| warning.code == "merged_points");
            let near = merged && there.distance(*point) < SAME_POINT * polyline::radius(points);
            assert!(there == *point || near, "{point} {there}");
        }
        let own: Vec<u32> = boundary.iter().copied().filter(|v| vertices.contains(v)).collect();
        let mut expected = vertices.clone();
        expected.dedup();
        if expected.len() > 1 && expected.first() == expected.last() {
            expected.pop();
        }
        assert_eq!(own, expected, "the input's order along the boundary");
        for (k, &a) in boundary.iter().enumerate() {
            assert!(topology.are_adjacent(a, boundary[(k + 1) % boundary.len()]));
        }
    }
    let statistics = &surface.statistics;
    assert!(statistics.area.is_finite() && statistics.residual >= 0.0);
    if statistics.converged {
        assert_eq!((statistics.quality.flipped_triangles, statistics.quality.degenerate_triangles), (0, 0));
        assert!(surface.warnings.iter().all(|warning| warning.code != "not_converged"));
    } else {
        assert!(surface.warnings.iter().any(|warning| warning.code == "not_converged"));
    }
}

fn refused(given: &[Vec<DVec3>], options: &Options) -> String {
    let error = solve(given, options, &Execution::default()).unwrap_err();
    assert!(!matches!(error, Error::Interrupted(_)));
    error.to_string()
}

/// Places in the error for boundaries whose sides meet.
fn crossings(given: &[Vec<DVec3>]) -> Vec<String> {
    match solve(given, &options(100), &Execution::default()) {
        Err(Error::NoResult { places, .. }) => places.iter().map(|error| error.place.to_string()).collect(),
        other => panic!("expected crossing sides, got {other:?}"),
    }
}

/// Returns the points rotated about a skew axis and then moved by the offset.
fn moved(points: &[DVec3], offset: DVec3) -> Vec<DVec3> {
    let turn = glam::DQuat::from_axis_angle(at(1.0, 2.0, -0.7).normalize(), 1.1);
    points.iter().map(|&p| turn * p + offset).collect()
}

#[test]
fn plane_polygons_have_their_exact_area_and_no_flipped_triangle() {
    let star: Vec<(f64, f64)> = (0..10)
        .map(|k| {
            let (radius, angle) = (if k % 2 == 0 { 1.0 } else { 0.4 }, TAU * k as f64 / 10.0);
            (radius * angle.cos(), radius * angle.sin())
        })
        .collect();
    let star_area = 5.0 * 0.4 * (TAU / 10.0).sin();
    let square = flat(&[(0.0, 0.0), (1.0, 0.0), (1.0, 1.0), (0.0, 1.0)]);
    let l = flat(&[(0.0, 0.0), (2.0, 0.0), (2.0, 1.0), (1.0, 1.0), (1.0, 2.0), (0.0, 2.0)]);
    let u = flat(&[(0.0, 0.0), (3.0, 0.0), (3.0, 3.0), (2.6, 3.0), (2.6, 0.4), (0.4, 0.4), (0.4, 3.0), (0.0, 3.0)]);
    let hole = flat(&[(0.3, 0.3), (0.3, 0.6), (0.7, 0.7), (0.7, 0.2)]);
    let hole_area = 0.4 * 0.5 * (0.3 + 0.5);
    let cases = [
        (vec![square.clone()], 1.0),
        (vec![l], 3.0),
        (vec![flat(&star)], star_area),
        (vec![u], 9.0 - 2.2 * 2.6),
        (vec![square, hole], 1.0 - hole_area),
    ];
    for (loops, area) in cases {
        let tilted: Vec<Vec<DVec3>> = loops.iter().map(|points| moved(points, at(0.1, -0.2, 0.3))).collect();
        let relaxation = Method::VertexRelaxation(VertexRelaxation::default());
        for options in [options(700), keep(700), Options { method: relaxation, ..options(700) }] {
            let surface = solved(&tilted, &options);
            let statistics = &surface.statistics;
            assert!((statistics.area / area - 1.0).abs() < 1e-12, "{} for {area}", statistics.area);
            assert!(statistics.converged && statistics.initial_mesh.name() == "planar");
            assert_eq!(statistics.genus, Some(0));
        }
    }
}

#[test]
fn four_corners_are_enough() {
    let skew = [at(0.0, 0.0, 0.0), at(1.0, 0.0, 1.0), at(1.0, 1.0, 0.0), at(0.0, 1.0, 1.0)];
    let tent = [at(-1.0, -1.0, 0.6), at(1.0, -1.0, -0.6), at(1.0, 1.0, 0.6), at(-1.0, 1.0, -0.6)];
    for corners in [skew, tent] {
        for triangles in [100, 2_000, 50_000] {
            let surface = solved(&[corners.to_vec()], &options(triangles));
            let statistics = &surface.statistics;
            assert!(statistics.converged, "{}", statistics.residual);
            let reached = statistics.triangles as f64 / triangles as f64;
            assert!((reached - 1.0).abs() < 0.1, "{} of {triangles}", statistics.triangles);
            let smallest = statistics.quality.angles.0.to_degrees();
            assert!(smallest > 20.0, "{smallest} at {triangles}");
            assert_eq!(surface.mesh.vertices[..4], corners);
        }
    }
}

#[test]
fn long_skew_and_twisted_corners_have_good_triangles_too() {
    let cases: [(&str, [DVec3; 4]); 6] = [
        ("short and flat", [at(0.0, 0.0, 0.0), at(5.0, 0.0, 0.0), at(5.0, 1.0, 0.0), at(0.0, 1.0, 0.0)]),
        ("long and flat", [at(0.0, 0.0, 0.0), at(50.0, 0.0, 0.0), at(50.0, 1.0, 0.0), at(0.0, 1.0, 0.0)]),
        ("long and skew", [at(0.0, 0.0, 0.0), at(20.0, 0.0, 1.0), at(20.0, 1.0, 0.0), at(0.0, 1.0, 1.0)]),
        ("tall", [at(0.0, 0.0, 0.0), at(1.0, 0.0, 3.0), at(1.0, 1.0, 0.0), at(0.0, 1.0, 3.0)]),
        ("tall and long", [at(0.0, 0.0, 0.0), at(5.0, 0.0, 10.0), at(5.0, 1.0, 0.0), at(0.0, 1.0, 10.0)]),
        ("twisted", [at(0.0, 0.0, 0.0), at(10.0, 0.0, 0.0), at(10.0, 0.6, 0.8), at(0.0, 1.0, 0.0)]),
    ];
    for (name, corners) in cases {
        for triangles in [100, 2_000, 50_000] {
            let surface = solved(&[corners.to_vec()], &options(triangles));
            let statistics = &surface.statistics;
            let reached = statistics.triangles as f64 / triangles as f64;
            assert!(statistics.converged && (reached - 1.0).abs() <= 0.1, "{name}: {reached} of {triangles}");
            let smallest = statistics.quality.angles.0.to_degrees();
            assert!(smallest > 20.0, "{name}: {smallest} at {triangles}");
            assert_eq!(surface.mesh.vertices[..4], corners);
        }
    }
}

#[test]
fn a_mapped_disc_keeps_no_trace_of_its_circle() {
    for (length, height) in [(3.0, 0.3), (10.0, 1.0), (3.0, 3.0)] {
        let ellipse = curve(60, |t| at(length * t.cos(), t.sin(), height * (2.0 * t).cos()));
        for (sampling, least) in [(BoundarySampling::Refine, 20.0), (BoundarySampling::Keep, 9.0)] {
            let mapped = Options { initial_mesh: InitialMesh::Disk, boundary_sampling: sampling, ..options(2_000) };
            let statistics = solved(std::slice::from_ref(&ellipse), &mapped).statistics;
            let smallest = statistics.quality.angles.0.to_degrees();
            assert!(statistics.converged && smallest > least, "{length} {height} {sampling:?}: {smallest}");
        }
    }
}

#[test]
fn a_boundary_finer_than_the_edge_length_is_graded_and_said_to_be() {
    let circle = curve(300, |t| at(t.cos(), t.sin(), 0.3 * (2.0 * t).cos()));
    for (initial_mesh, sampling) in
        [(InitialMesh::Auto, BoundarySampling::Keep), (InitialMesh::Disk, BoundarySampling::Refine)]
    {
        let options =
            Options { initial_mesh, boundary_sampling: sampling, ..Options::new(Resolution::EdgeLength(0.3)) };
        let surface = solved(std::slice::from_ref(&circle), &options);
        let statistics = &surface.statistics;
        assert!(statistics.quality.angles.0.to_degrees() > 20.0, "{}", statistics.quality.angles.0.to_degrees());
        assert!(statistics.triangles < 8_000, "{}", statistics.triangles);
        assert!(surface.warnings.iter().any(|warning| warning.code == "edge_length_missed"));
    }
}

#[test]
fn an_edge_length_is_met_between_three_loops() {
    let pants = [0.0, 1.0, 2.0].map(|k| {
        let (sin, cos) = (TAU * k / 3.0).sin_cos();
        curve(24, |t| at(0.5 * (cos - sin * t.cos()), 0.5 * (sin + cos * t.cos()), 0.5 * t.sin()))
    });
    for length in [0.1, 0.05] {
        let surface = solved(&pants, &Options::new(Resolution::EdgeLength(length)));
        let statistics = &surface.statistics;
        assert!(statistics.converged && statistics.initial_mesh.name() == "sphere_with_holes");
        let ratio = statistics.quality.edge_lengths.mean / length;
        assert!((ratio - 1.0).abs() < 0.1, "{length}: {ratio}");
    }
}

#[test]
fn spacing_from_a_thousandth_to_one_is_graded() {
    // The steps grow from 0.001 at angle 0 to at most 1 half way round, and fall again in the same way. The growth is
    // gradual or abrupt.
    for (growth, height) in [(1.15, 0.4), (1.15, 3.0), (3.0, 0.0), (1000.0, 0.4)] {
        let (mut half, mut step) = (vec![0.0f64], 0.001f64);
        while half[half.len() - 1] + step / 3.0 < TAU / 2.0 - 0.15 {
            half.push(half[half.len() - 1] + step / 3.0);
            step = (step * growth).min(1.0);
        }
        let back: Vec<f64> = half.iter().skip(1).rev().map(|angle| TAU - angle).collect();
        let place = |angle: f64| at(3.0 * angle.cos(), 3.0 * angle.sin(), height * (2.0 * angle).cos());
        let boundary: Vec<DVec3> = half.into_iter().chain(back).map(place).collect();
        for triangles in [3_000, 20_000] {
            let surface = solved(std::slice::from_ref(&boundary), &options(triangles));
            let smallest = surface.statistics.quality.angles.0.to_degrees();
            assert!(surface.statistics.converged);
            assert!(smallest > 20.0, "{growth} {height} {triangles}: {smallest}");
        }
    }
}

#[test]
fn every_resolution_is_met_within_a_tenth_on_every_kind_of_mesh() {
    let wavy = curve(60, |t| at(t.cos(), t.sin(), 0.3 * (3.0 * t).cos()));
    let pants = [0.0, 1.0, 2.0].map(|k| {
        let (sin, cos) = (TAU * k / 3.0).sin_cos();
        curve(24, |t| at(0.8 * cos - 0.5 * sin * t.cos(), 0.8 * sin + 0.5 * cos * t.cos(), 0.5 * t.sin()))
    });
    let cases = [
        (vec![wavy], "planar"),
        (vec![helicoid()], "disk"),
        (rings(40, 1.0), "annulus"),
        (pants.to_vec(), "sphere_with_holes"),
    ];
    for (given, kind) in cases {
        for wanted in [Resolution::Triangles(2500), Resolution::InteriorVertices(1300), Resolution::EdgeLength(0.0)] {
            if kind == "sphere_with_holes" && matches!(wanted, Resolution::EdgeLength(_)) {
                // Necks shrink during the solve, and so does the area from which the number of triangles is derived.
                continue;
            }
            let radius = given.iter().flatten().map(|p| p.length()).fold(0.0, f64::max);
            let wanted = match wanted {
                Resolution::EdgeLength(_) => Resolution::EdgeLength(0.05 * radius),
                other => other,
            };
            // Only the initial mesh is checked, so the solver may stop early.
            let options = Options { max_iterations: Some(4), ..Options::new(wanted) };
            let surface = solved(&given, &options);
            let statistics = &surface.statistics;
            assert_eq!(statistics.initial_mesh.name(), kind);
            let boundary: usize = surface.boundaries.iter().map(Vec::len).sum();
            let ratio = match wanted {
                Resolution::Triangles(count) => statistics.triangles as f64 / count as f64,
                Resolution::InteriorVertices(count) => (statistics.vertices - boundary) as f64 / count as f64,
                Resolution::EdgeLength(length) => statistics.quality.edge_lengths.mean / length,
            };
            assert!((ratio - 1.0).abs() < 0.1, "{kind} {wanted:?}: {ratio}");
            assert_eq!(statistics.euler_characteristic, 2 - given.len() as i64);
        }
    }
}

#[test]
fn odd_boundaries_converge_or_are_refused_with_the_reason() {
    let trefoil =
        curve(160, |t| at(t.sin() + 2.0 * (2.0 * t).sin(), t.cos() - 2.0 * (2.0 * t).cos(), -(3.0 * t).sin()));
    let near_touch = curve(160, |t| at(t.sin(), t.sin() * t.cos(), 0.01 * t.cos()));
    let spike = {
        let mut points = curve(60, |t| at(t.cos(), t.sin(), 0.1 * (2.0 * t).sin()));
        points[30] = at(-6.0, 0.01, 0.4);
        points
    };
    let duplicates = {
        let mut points = Vec::new();
        for p in curve(24, |t| at(t.cos(), t.sin(), 0.2 * (2.0 * t).cos())) {
            points.extend([p, p, p]);
        }
        points.push(points[0]);
        points
    };
    let collinear = sides(&[at(0.0, 0.0, 0.0), at(1.0, 0.0, 0.3), at(1.0, 1.0, 0.0), at(0.0, 1.0, 0.3)], 25);
    let far = moved(&curve(40, |t| at(t.cos(), t.sin(), 0.3 * (2.0 * t).cos())), at(1e7, -1e7, 1e7));
    let small: Vec<DVec3> = curve(40, |t| 1e-6 * at(t.cos(), t.sin(), 0.3 * (2.0 * t).cos()));
    let nearly_equal = {
        let mut points = curve(40, |t| at(t.cos(), t.sin(), 0.0));
        let point = points[7];
        points.insert(8, point + DVec3::splat(1e-13));
        points
    };
    for (name, boundary) in [
        ("trefoil", trefoil),
        ("near_touch", near_touch),
        ("spike", spike),
        ("duplicates", duplicates),
        ("collinear", collinear),
        ("far", far),
        ("small", small),
        ("nearly_equal", nearly_equal),
    ] {
        for options in [options(1500), keep(1500)] {
            match solve(std::slice::from_ref(&boundary), &options, &Execution::default()) {
                Ok(surface) => {
                    valid(std::slice::from_ref(&boundary), &surface);
                    assert!(surface.statistics.converged, "{name}: {:?}", surface.warnings);
                    if name == "duplicates" || name == "nearly_equal" {
                        assert!(surface.warnings.iter().any(|warning| warning.code == "merged_points"));
                    }
                }
                Err(error) => panic!("{name}: {error}"),
            }
        }
    }
}

#[test]
fn nearly_equal_points_are_merged_or_converge() {
    let reference = solved(&[curve(60, |t| at(t.cos(), t.sin(), 0.3 * (2.0 * t).cos()))], &options(1500));
    for exponent in 3..=16 {
        let gap = 10f64.powi(-exponent);
        // A point is added beside another, along the loop or off it, before the loop's first point or after its last.
        for direction in [at(0.0, 1.0, 0.0), at(0.6, 0.0, 0.8)] {
            for place in [0, 60] {
                let mut points = curve(60, |t| at(t.cos(), t.sin(), 0.3 * (2.0 * t).cos()));
                points.insert(place, points[0] - gap * direction);
                let surface = solved(&[points], &options(1500));
                let statistics = &surface.statistics;
                assert!(statistics.converged, "{exponent} {place}: {} {:?}", statistics.residual, surface.warnings);
                let change = statistics.area - reference.statistics.area;
                assert!(change.abs() < 0.1 * gap + 2e-3, "{exponent} {place}: {change}");
                let merged = surface.warnings.iter().any(|warning| warning.code == "merged_points");
                // A gap of 1e-9 is at the limit itself.
                assert!(merged == (exponent > 9) || exponent == 9, "{exponent}");
            }
        }
    }
}

#[test]
fn impossible_inputs_name_the_reason() {
    let triangle = flat(&[(0.0, 0.0), (1.0, 0.0), (0.0, 1.0)]);
    let mut nan = triangle.clone();
    nan[1].y = f64::NAN;
    assert!(refused(&[triangle.clone(), nan], &options(100)).starts_with("/boundaries/1/1:"));
    let mut huge = triangle.clone();
    huge[2].x = 1e300;
    assert!(refused(&[huge], &options(100)).starts_with("/boundaries/0/2:"));
    // Products of these lengths underflow to 0. The walk along the rings must end all the same.
    let tiny: Vec<DVec3> = circle(36, 1e-299, 0.0);
    let options_of_rings = Options { initial_mesh: InitialMesh::Rings, ..keep(100) };
    assert!(refused(&[tiny.clone(), moved(&tiny, DVec3::Z)], &options_of_rings).starts_with("/boundaries/0/0:"));
    let far = vec![at(0.2, 0.2, 0.0), at(1e6, 0.3, 0.5), at(0.3, 0.2, 0.0)];
    let constraints = Constraints { polylines: vec![far], ..Constraints::default() };
    let skew = vec![at(0.0, 0.0, 0.0), at(1.0, 0.0, 0.3), at(1.0, 1.0, 0.0), at(0.0, 1.0, 0.3)];
    assert!(
        refused(&[skew], &Options { constraints, ..options(300) }).starts_with("/constraints/polylines/0: too long")
    );
    assert!(refused(&[], &options(100)).starts_with("/boundaries:"));
    let two = flat(&[(0.0, 0.0), (1.0, 0.0), (0.0, 0.0), (1.0, 0.0)]);
    assert!(refused(&[two], &options(100)).contains("three distinct"));
    let line = flat(&[(0.0, 0.0), (1.0, 0.0), (2.0, 0.0), (0.5, 0.0)]);
    assert!(refused(&[line], &options(100)).contains("one line"));
    let bow_tie = flat(&[(0.0, 0.0), (1.0, 1.0), (1.0, 0.0), (0.0, 1.0)]);
    assert!(refused(std::slice::from_ref(&bow_tie), &options(100)).starts_with("self_intersecting_boundary"));
    assert!(refused(&[moved(&bow_tie, at(3.0, 0.0, 1e3))], &options(100)).starts_with("self_intersecting_boundary"));
    // The first point is repeated. The places must be the indices in the input, not those after merging.
    let repeated = flat(&[(0.0, 0.0), (0.0, 0.0), (1.0, 1.0), (1.0, 0.0), (0.0, 1.0)]);
    assert_eq!(crossings(std::slice::from_ref(&repeated)), ["/boundaries/0/0", "/boundaries/0/3"]);
    let far = moved(&repeated, at(3.0, 0.0, 1e3));
    assert_eq!(crossings(&[far]), ["/boundaries/0/0", "/boundaries/0/3"]);
    assert!(refused(&[circle(200, 1.0, 0.0)], &options(50)).starts_with("/resolution"));
    assert!(
        refused(std::slice::from_ref(&triangle), &Options::new(Resolution::EdgeLength(-1.0)))
            .starts_with("/resolution/edge_length")
    );
    assert!(
        refused(std::slice::from_ref(&triangle), &Options::new(Resolution::EdgeLength(1e-9)))
            .starts_with("/resolution")
    );
    assert!(refused(std::slice::from_ref(&triangle), &options(usize::MAX)).starts_with("/resolution/triangles"));
    let bad = Options { tolerance: f64::NAN, ..options(100) };
    assert!(refused(&[triangle], &bad).starts_with("/tolerance"));
}

/// Describes a result in short: the kind of mesh and whether it converged, or the reason why there is none.
fn outcome(given: &[Vec<DVec3>], options: &Options, exec: &Execution) -> String {
    match solve(given, options, exec) {
        Ok(surface) => {
            valid(given, &surface);
            let kind = surface.statistics.initial_mesh.name();
            format!("{kind}, {}", if surface.statistics.converged { "converged" } else { "not converged" })
        }
        Err(Error::NoResult { reason, .. }) => reason.to_string(),
        Err(Error::Input(errors)) => errors[0].place.to_string(),
        Err(Error::Interrupted(_)) => panic!("nobody asked for it"),
    }
}

/// Input: one point of a circle moved by 1e6. Symptom: the rectangle around the spike was filled with lattice points,
/// for a minute without a look, in 3 GB. Rule: the number of lattice points is bounded.
#[test]
fn a_spike_of_a_million_costs_a_bounded_number_of_steps() {
    let outcomes = [DVec3::X, DVec3::Y, DVec3::Z, DVec3::ONE].map(|direction| {
        let mut boundary = curve(36, |t| 10.0 * at(t.cos(), t.sin(), 0.0));
        boundary[18] += 1e6 * direction;
        let exec = Execution::default();
        let outcome = outcome(&[boundary], &options(300), &exec);
        assert!(exec.work() < 50_000_000, "{} steps", exec.work());
        assert!(exec.largest_work_between_looks() < 5_000_000, "{}", exec.largest_work_between_looks());
        outcome
    });
    // Along y both sides of the spike lie within 1e-9 of its length, so that it is a way out and back.
    let expected = ["self_intersecting_boundary", "/boundaries/0/18", "disk, converged", "disk, not converged"];
    assert_eq!(outcomes, expected);
}

/// Input: two loops that differ in one point only. Symptom: the film between them grew fourfold each time the sizes
/// were examined, without end. Rule: the growth has a bound.
#[test]
fn loops_that_all_but_coincide_cost_a_bounded_number_of_steps() {
    let outcomes = [1e-300, 1e-20, 1e-12, 1e-9, 1e-6, 1e-3].map(|gap| {
        let mut given = vec![circle(96, 1.0, 0.0), circle(96, 1.0, 0.0)];
        given[1][55].z = gap;
        let exec = Execution::default();
        let outcome = outcome(&given, &keep(300), &exec);
        assert!(exec.work() < 50_000_000, "{gap}: {} steps", exec.work());
        outcome
    });
    // In the first four cases the loops lie in one plane and share sides there. In the others the film between the
    // loops is of no use.
    let [plane, space] = ["self_intersecting_boundary", "no_connected_film"];
    assert_eq!(outcomes, [plane, plane, plane, plane, space, space]);
}

#[test]
fn several_loops_however_they_lie_give_a_mesh_or_a_reason() {
    let nested = vec![circle(40, 1.0, 0.0), circle(40, 0.4, 0.0)];
    let surface = solved(&nested, &options(1000));
    assert_eq!((surface.statistics.initial_mesh.name(), surface.statistics.euler_characteristic), ("planar", 0));
    // Four pairs: linked, crossing in one plane, side by side, and the same loop twice.
    let linked = vec![circle(40, 1.0, 0.0), curve(40, |t| at(1.0 + t.cos(), 0.0, t.sin()))];
    let crossing = vec![circle(40, 1.0, 0.0), curve(40, |t| at(0.7 + t.cos(), t.sin(), 0.0))];
    let beside = vec![circle(40, 1.0, 0.0), curve(40, |t| at(5.0 + t.cos(), t.sin(), 0.0))];
    let twice = vec![circle(40, 1.0, 0.0), circle(40, 1.0, 0.0)];
    let outcomes = [linked, crossing, beside, twice].map(|given| outcome(&given, &options(800), &Execution::default()));
    let expected = ["annulus, converged", "self_intersecting_boundary", "no_connected_film", "/boundaries/1"];
    assert_eq!(outcomes, expected);
}

#[test]
fn the_clients_own_mesh_is_the_start_and_the_unstable_catenoid_is_reported() {
    // The exact catenoid over Chen, Cai, Zheng's patch is an unstable critical point.
    let (nu, nv, sector) = (52usize, 26usize, 3.0 * std::f64::consts::PI / 5.0);
    let place = |i: usize, j: usize| {
        let u = -sector + 2.0 * sector * i as f64 / nu as f64;
        let v = -2.0 + 4.0 * j as f64 / nv as f64;
        at(v.cosh() * u.cos(), v.cosh() * u.sin(), v)
    };
    let number = |i: usize, j: usize| (i * (nv + 1) + j) as u32;
    let mut mesh = Mesh::default();
    for i in 0..=nu {
        mesh.vertices.extend((0..=nv).map(|j| place(i, j)));
    }
    // The vertices on the boundary must have exactly the positions of the request.
    let boundary = boundaries::catenoid();
    let rim: Vec<u32> = (0..nu)
        .map(|i| number(i, 0))
        .chain((0..nv).map(|j| number(nu, j)))
        .chain((1..=nu).rev().map(|i| number(i, nv)))
        .chain((1..=nv).rev().map(|j| number(0, j)))
        .collect();
    rim.iter().zip(&boundary).for_each(|(&v, &point)| mesh.vertices[v as usize] = point);
    for i in 0..nu {
        for j in 0..nv {
            let [a, b, c, d] = [number(i, j), number(i + 1, j), number(i + 1, j + 1), number(i, j + 1)];
            mesh.triangles.extend(if (i + j) % 2 == 0 { [[a, b, c], [a, c, d]] } else { [[a, b, d], [b, c, d]] });
        }
    }
    let from_catenoid = Options { initial_mesh: InitialMesh::Given(mesh), ..keep(1) };
    let surface = solved(std::slice::from_ref(&boundary), &from_catenoid);
    let statistics = &surface.statistics;
    assert_eq!((statistics.initial_mesh.name(), statistics.triangles), ("given", 2 * nu * nv));
    let stability = statistics.stability.unwrap();
    assert!(statistics.converged && stability.morse_index == Some(1), "{stability:?}");
    assert_eq!(stability.stable, Some(false));
    assert!((statistics.area - 58.98).abs() < 0.1, "{}", statistics.area);
    assert!(surface.warnings.iter().any(|warning| warning.code == "unstable"));
    // Moving along the lowest mode in either direction lowers the area. The descent ends at the stable surface.
    let unstable_mode = surface.unstable_mode.as_ref().unwrap();
    assert!(surface.boundaries[0].iter().all(|&v| unstable_mode[v as usize] == DVec3::ZERO));
    for step in [0.05, -0.05] {
        let mut moved = surface.mesh.clone();
        moved.vertices.iter_mut().zip(unstable_mode).for_each(|(vertex, &direction)| *vertex += step * direction);
        assert!(measure::area(&moved) < statistics.area);
    }
    let descending = Method::Newton(Newton { on_unstable: OnUnstable::Descend, ..Newton::default() });
    let left = solved(std::slice::from_ref(&boundary), &Options { method: descending, ..from_catenoid.clone() });
    assert!(left.statistics.converged && left.unstable_mode.is_none());
    assert_eq!(left.statistics.stability.unwrap().stable, Some(true));
    assert!((left.statistics.area - 58.16).abs() < 0.2, "{}", left.statistics.area);
    // With the default initial mesh the solver finds the stable surface. A result can be the initial mesh of another
    // request.
    let stable = solved(std::slice::from_ref(&boundary), &keep(2040));
    assert_eq!(stable.statistics.stability.unwrap().morse_index, Some(0));
    assert!((stable.statistics.area - 58.16).abs() < 0.1);
    let again = Options { initial_mesh: InitialMesh::Given(stable.mesh.clone()), ..keep(1) };
    let again = solved(&[boundary], &again);
    assert!((again.statistics.area - stable.statistics.area).abs() < 1e-6);
}

/// Input: a point above a plane square. Symptom: a spike one triangle wide, converged and without a warning.
#[test]
fn a_point_that_holds_the_film_is_named() {
    let square = vec![at(0.0, 0.0, 0.0), at(8.0, 0.0, 0.0), at(8.0, 8.0, 0.0), at(0.0, 8.0, 0.0)];
    let warns = |height: f64| {
        let constraints = Constraints { points: vec![at(4.0, 4.0, height)], ..Constraints::default() };
        let surface = solved(std::slice::from_ref(&square), &Options { constraints, ..options(500) });
        surface.warnings.iter().any(|warning| warning.code == "held_points")
    };
    assert!(warns(1.0) && !warns(0.0));
}

#[test]
fn fixed_points_and_curves_are_vertices_and_edges_exactly() {
    let wavy = curve(48, |t| at(t.cos(), t.sin(), 0.2 * (2.0 * t).cos()));
    let pole = at(0.1, -0.35, -0.02);
    let ridge = vec![wavy[4], at(0.45, 0.3, 0.3), at(0.0, 0.55, 0.25), wavy[15]];
    let constraints = Constraints { points: vec![pole], polylines: vec![ridge.clone()], ..Constraints::default() };
    let offset = at(1e5, 2e5, -3e5);
    let shift = |points: &[DVec3]| points.iter().map(|&p| p + offset).collect::<Vec<_>>();
    for given in [helicoid(), shift(&wavy)] {
        let is_wavy = given.len() == 48;
        let constraints = if is_wavy {
            Constraints { points: shift(&[pole]), polylines: vec![shift(&ridge)], ..Constraints::default() }
        } else {
            // A point and a curve away from the surface, the curve across the helicoid's strip.
            Constraints {
                points: vec![at(0.3, -7.0, 4.8)],
                polylines: vec![vec![at(4.0, 0.5, 0.4), at(6.0, 0.6, 0.6), at(8.0, 0.9, 0.3)]],
                ..Constraints::default()
            }
        };
        for sampling in [BoundarySampling::Refine, BoundarySampling::Keep] {
            let options = Options { constraints: constraints.clone(), boundary_sampling: sampling, ..options(2200) };
            let surface = solved(std::slice::from_ref(&given), &options);
            let topology = surface.mesh.check().unwrap();
            assert_eq!(surface.constraints.points.len(), 1);
            assert_eq!(surface.mesh.vertices[surface.constraints.points[0] as usize], constraints.points[0]);
            let line = &surface.constraints.polylines[0];
            assert_eq!(line.len(), constraints.polylines[0].len());
            for (k, &v) in line.iter().enumerate() {
                assert_eq!(surface.mesh.vertices[v as usize], constraints.polylines[0][k]);
                assert_eq!(surface.mean_curvature[v as usize], 0.0);
            }
            // From each point of the curve, a straight chain of edges leads to the next point.
            for pair in line.windows(2) {
                let (mut here, goal) = (pair[0], surface.mesh.vertices[pair[1] as usize]);
                let start = surface.mesh.vertices[pair[0] as usize];
                for _ in 0..200 {
                    if here == pair[1] {
                        break;
                    }
                    let ahead = topology.outgoing_half_edges(here).flat_map(|h| [topology.to(h), topology.opposite(h)]);
                    let from = surface.mesh.vertices[here as usize];
                    here = ahead
                        .filter(|&v| {
                            let p = surface.mesh.vertices[v as usize];
                            let beside = (p - start).cross(goal - start).length() / (goal - start).length_squared();
                            beside < 1e-8 && (p - goal).length() < (from - goal).length() * (1.0 - 1e-9)
                        })
                        .min_by(|&a, &b| {
                            let far = |v: u32| surface.mesh.vertices[v as usize].distance(from);
                            far(a).total_cmp(&far(b))
                        })
                        .expect("the curve's next vertex");
                }
                assert_eq!(here, pair[1]);
            }
            assert!(surface.statistics.converged, "{:?}", surface.warnings);
        }
    }
    let outside =
        Options { constraints: Constraints { points: vec![at(9.0, 9.0, 0.0)], ..constraints }, ..options(800) };
    assert!(refused(&[circle(40, 1.0, 0.0)], &outside).starts_with("/constraints"));
}

#[test]
fn a_cancel_is_seen_at_every_look_and_a_deadline_leaves_a_valid_mesh() {
    let given = [helicoid()];
    let total = Cell::new(0u64);
    let count = || {
        total.set(total.get() + 1);
        Signal::Continue
    };
    let quiet = |_| {};
    let exec = Execution::new(&count, &quiet);
    solve(&given, &options(3000), &exec).unwrap();
    assert!(exec.largest_work_between_looks() < 2_000_000, "{}", exec.largest_work_between_looks());
    let total = total.get();
    for stop in (0..total).step_by((total / 12).max(1) as usize) {
        let looks = Cell::new(0u64);
        let at_stop = |signal| {
            looks.set(looks.get() + 1);
            if looks.get() > stop { signal } else { Signal::Continue }
        };
        let cancel = || at_stop(Signal::Cancel);
        let error = solve(&given, &options(3000), &Execution::new(&cancel, &quiet)).unwrap_err();
        assert_eq!(error, Error::Interrupted(Interruption::Cancelled));
        assert_eq!(looks.get(), stop + 1, "nothing is asked after a cancel");
        looks.set(0);
        let deadline = || at_stop(Signal::Deadline);
        match solve(&given, &options(3000), &Execution::new(&deadline, &quiet)) {
            Ok(surface) => valid(&given, &surface),
            Err(error) => assert_eq!(error, Error::Interrupted(Interruption::DeadlinePassed)),
        }
    }
}

#[test]
fn triangles_face_the_side_from_which_the_first_boundary_runs_counter_clockwise() {
    for reversed in [false, true] {
        let mut boundary = flat(&[(0.0, 0.0), (1.0, 0.0), (1.0, 1.0), (0.0, 1.0)]);
        if reversed {
            boundary.reverse();
        }
        let surface = solved(&[boundary], &options(200));
        let normals = measure::vertex_normals(&surface.mesh);
        assert!(normals.iter().all(|n| (n.z - if reversed { -1.0 } else { 1.0 }).abs() < 1e-12));
    }
}

#[test]
fn loops_that_share_a_point_are_told_so() {
    let square = flat(&[(0.0, 0.0), (1.0, 0.0), (1.0, 1.0), (0.0, 1.0)]);
    let above = vec![at(1.0, 1.0, 0.0), at(2.0, 1.0, 1.0), at(2.0, 2.0, 1.0), at(1.0, 2.0, 1.0)];
    let method = Method::Newton(Newton { topology: TopologyRule::Best, ..Newton::default() });
    let apart = Options { method, ..options(100) };
    let surface = solve(&[square.clone(), above.clone()], &apart, &Execution::default()).unwrap();
    let shared: Vec<_> = surface.warnings.iter().filter(|warning| warning.code == "shared_points").collect();
    assert_eq!(shared.len(), 1, "{:?}", surface.warnings);
    assert!(
        shared[0].detail.starts_with("point 0 of boundary 1 is also point 2 of boundary 0: "),
        "{}",
        shared[0].detail
    );
    // A film that has to connect the loops fails, and the error names the shared point too.
    assert_eq!(crossings(&[square.clone(), above]), ["/topology", "/boundaries/1/0"]);
    let below = moved(&square, at(0.0, 0.0, 9.0));
    let surface = solve(&[square, below], &apart, &Execution::default()).unwrap();
    assert!(surface.warnings.iter().all(|warning| warning.code != "shared_points"));
}

/// Input: a boundary of 50,000 points. Symptom: 17 s, because the mesh was laid out eleven times, at first with ten
/// times the wanted triangles, and each thin triangle was examined once for every change around it. Rule: the work is
/// proportional to the number of points.
#[test]
fn a_long_loop_takes_work_in_proportion_to_its_points() {
    let points = 6_000;
    let star = curve(points, |angle| {
        let radius = 1.0 + 0.5 * (7.0 * angle).cos();
        at(radius * angle.cos(), radius * angle.sin(), 0.0)
    });
    let execution = Execution::default();
    let surface = solve(std::slice::from_ref(&star), &options(2 * points), &execution).unwrap();
    valid(&[star], &surface);
    let work = execution.work() as f64 / points as f64;
    assert!(surface.statistics.converged && work < 1_500.0, "{work}");
}
