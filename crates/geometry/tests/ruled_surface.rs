//! Ruled strips whose answer is known by hand.

use plateau_geometry::ruled_surface::{Objective, Options, RuledSurface, solve};
use plateau_geometry::{DVec3, Execution};

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
