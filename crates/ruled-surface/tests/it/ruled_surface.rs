//! Ruled strips whose answer is known by hand.

use plateau_mesh::{DVec3, Execution};
use plateau_ruled_surface::{Direction, Objective, Options, RuledSurface, solve};

fn solved(directrices: &[Vec<DVec3>], options: &Options) -> RuledSurface {
    solve(directrices, options, &Execution::default()).expect("a strip that can be solved")
}

fn line(count: usize, length: f64, y: f64) -> Vec<DVec3> {
    (0..count).map(|k| DVec3::new(length * k as f64 / (count - 1) as f64, y, 0.0)).collect()
}

fn ring(count: usize, radius: f64, z: f64) -> Vec<DVec3> {
    let angle = |k: usize| std::f64::consts::TAU * k as f64 / count as f64;
    (0..count).map(|k| DVec3::new(radius * angle(k).cos(), radius * angle(k).sin(), z)).collect()
}

#[test]
fn a_strip_between_parallel_lines_has_their_area_and_no_bend() {
    let surface = solved(&[line(20, 10.0, 0.0), line(31, 10.0, 3.0)], &Options::default());
    assert!((surface.statistics.area - 30.0).abs() < 1e-12);
    assert_eq!(surface.statistics.triangles, 49);
    assert_eq!(surface.statistics.convex_bridges, surface.statistics.bridges);
    assert!(surface.statistics.bending_energy < 1e-20);
    assert!(surface.mesh.check().is_ok());
}

#[test]
fn a_contour_stack_welds_into_one_closed_strip_after_another() {
    let stack = [ring(30, 1.0, 0.0), ring(41, 1.2, 1.0), ring(1, 0.0, 2.0)];
    for objective in [Objective::MinimalArea, Objective::MinimalTwist, Objective::MinimalBendingEnergy] {
        let surface = solved(&stack, &Options { closed: true, objective, ..Options::default() });
        assert_eq!(surface.mesh.vertices.len(), 72);
        assert_eq!(surface.strips.iter().map(|s| s.triangles).collect::<Vec<_>>(), [71, 41]);
        let topology = surface.mesh.check().expect("a manifold");
        assert_eq!(topology.boundary_loops().len(), 1);
    }
}

fn has_warning(surface: &RuledSurface, code: &str) -> bool {
    surface.warnings.iter().any(|warning| warning.code == code)
}

/// Two straight rails that run in opposite directions in one plane: both ways to triangulate have the same area, and as
/// given the strip folds back onto itself.
#[test]
fn a_fold_of_half_a_turn_is_seen_and_auto_takes_the_direction_without_it() {
    let rails = [line(3, 2.0, 0.0), line(3, 2.0, 1.0).into_iter().rev().collect()];
    let as_given = solved(&rails, &Options::default());
    assert_eq!(as_given.statistics.largest_fold.to_degrees(), 180.0);
    assert!(
        has_warning(&as_given, "folds") && has_warning(&as_given, "opposite_directions"),
        "{:?}",
        as_given.warnings
    );
    let auto = solved(&rails, &Options { direction: Direction::Auto, ..Options::default() });
    assert_eq!(auto.reversed, [false, true]);
    assert!((auto.statistics.area - as_given.statistics.area).abs() < 1e-12);
    assert_eq!(auto.statistics.largest_fold, 0.0);
    let pattern = auto.flat_pattern;
    assert!((pattern.width - 2.0).abs() < 1e-12 && (pattern.height - 1.0).abs() < 1e-12, "{pattern:?}");
    assert!(auto.warnings.is_empty(), "{:?}", auto.warnings);
}

/// Both rails run back upon themselves, so that the two sides of their sharp edge lie in the same place. Any other sharp
/// edge of a profile is no fault of the strip.
#[test]
fn a_fold_of_half_a_turn_is_reported_where_the_rails_have_it_too() {
    let rail = |y: f64, last: f64| [[0.0, y], [1.0, y], [last, y]].map(|[x, y]| DVec3::new(x, y, 0.0)).to_vec();
    let folded = solved(&[rail(0.0, 0.2), rail(1.0, 0.2)], &Options::default());
    let warning = folded.warnings.iter().find(|warning| warning.code == "folds").expect("a warning");
    assert!(warning.detail.contains("by up to 180.0°; a fold of 180° lays one triangle upon"), "{}", warning.detail);
}

#[test]
fn triangles_without_area_are_reported() {
    let same = solved(&[line(200, 6.0, 0.0), line(200, 6.0, 0.0)], &Options::default());
    let warning = same.warnings.iter().find(|warning| warning.code == "empty_triangles").expect("a warning");
    assert!(warning.detail.contains("all 398"), "{}", warning.detail);
    // Rails that share their ends, as the halves of an eye, have an empty triangle there and are what was meant.
    let arc = |height: f64| -> Vec<DVec3> {
        let point = |k: usize| std::f64::consts::PI * k as f64 / 20.0;
        let middle = |k: usize| DVec3::new(point(k), height * point(k).sin(), 0.0);
        (0..=20).map(|k| if k == 0 || k == 20 { DVec3::X * point(k) } else { middle(k) }).collect()
    };
    assert!(!has_warning(&solved(&[arc(1.0), arc(-1.0)], &Options::default()), "empty_triangles"));
}

#[test]
fn a_closed_directrix_sampled_with_its_end_point_is_merged_there() {
    let with_its_end = |radius: f64, z: f64| -> Vec<DVec3> {
        let mut points = ring(40, radius, z);
        points.push(ring(40, radius, z)[0] + DVec3::Y * 1e-15);
        points
    };
    let surface =
        solved(&[with_its_end(1.0, 0.0), with_its_end(1.2, 1.0)], &Options { closed: true, ..Options::default() });
    assert_eq!(surface.statistics.triangles, 80);
    assert!(surface.warnings.iter().any(|warning| warning.code == "merged_points"), "{:?}", surface.warnings);
    assert_eq!(surface.input_vertices[1][40], surface.input_vertices[1][0]);
    assert!(surface.statistics.shortest_bridge > 1.0);
}

/// A tiny triangle at the origin beside a large one, in either order.
#[test]
fn a_tiny_directrix_keeps_the_digits_of_its_sides() {
    let triangle = |at: DVec3, size: f64| -> Vec<DVec3> {
        let corners = [[1.0, 0.1, 0.0], [-0.4, 0.9, 0.2], [-0.6, -0.8, -0.1]];
        corners.iter().map(|&corner| at + size * DVec3::from_array(corner)).collect()
    };
    let large = triangle(DVec3::new(0.3, 0.2, 1.0), 1.0);
    let tiny = triangle(DVec3::ZERO, 1e-12);
    let options = Options { closed: true, objective: Objective::MinimalTwist, ..Options::default() };
    let twist =
        |directrices: [&Vec<DVec3>; 2]| solved(&directrices.map(Vec::clone), &options).statistics.total_normal_twist;
    let (first, last) = (twist([&tiny, &large]), twist([&large, &tiny]));
    assert!((first / last - 1.0).abs() < 1e-12, "{first} and {last}");
}
