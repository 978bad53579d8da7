//! Bounds on the mean curvature: the solvers go on until the film is within the bound, and say where it is not.

use plateau_mesh::{DVec3, Execution};
use plateau_minimal_surface::{
    Method, MinimalSurface, Newton, Options, PinkallPolthier, Resolution, TopologyRule, VertexRelaxation, solve,
};

fn saddle() -> Vec<DVec3> {
    let angles = (0..48).map(|k| std::f64::consts::TAU * f64::from(k) / 48.0);
    angles.map(|t| DVec3::new(t.cos(), t.sin(), 0.4 * (2.0 * t).cos())).collect()
}

fn film(method: Method, curvature_tolerance: Option<f64>) -> MinimalSurface {
    let options = Options { method, curvature_tolerance, ..Options::new(Resolution::Triangles(800)) };
    solve(&[saddle()], &options, &Execution::default()).unwrap()
}

fn within(method: &Method, fraction: f64) -> [MinimalSurface; 2] {
    let plain = film(method.clone(), None);
    let bound = fraction * plain.statistics.mean_curvature.max;
    let bounded = film(method.clone(), Some(bound));
    let found = bounded.statistics.mean_curvature.max;
    assert!(bounded.statistics.converged && found <= bound, "{method:?}: {found} of {bound}");
    [plain, bounded]
}

#[test]
fn the_default_solver_slides_on_until_the_film_is_within_the_bound() {
    for topology in [TopologyRule::Fixed, TopologyRule::Best] {
        let method = Method::Newton(Newton { topology, ..Newton::default() });
        let [plain, bounded] = within(&method, 0.5);
        assert_eq!(plain.mesh.triangles, bounded.mesh.triangles);
        assert!(bounded.statistics.area <= plain.statistics.area);
        assert!(bounded.statistics.quality.angles.0.to_degrees() >= 9.9);
        let rows = &bounded.statistics.history;
        assert!(rows.windows(2).all(|pair| pair[1].iteration == pair[0].iteration + 1));
        if let Some(spanning) = &bounded.statistics.spanning {
            let chosen = spanning.topologies.iter().find(|topology| topology.chosen).unwrap();
            assert!((chosen.area.unwrap() / bounded.statistics.area - 1.0).abs() < 1e-12);
        }
    }
}

#[test]
fn the_solvers_of_the_papers_go_on_beyond_their_area_tolerance() {
    let area_tolerance = 1e-4;
    for (method, fraction) in [
        (Method::VertexRelaxation(VertexRelaxation { area_tolerance, ..VertexRelaxation::default() }), 0.2),
        (Method::PinkallPolthier(PinkallPolthier { area_tolerance, ..PinkallPolthier::default() }), 0.9),
    ] {
        let [plain, bounded] = within(&method, fraction);
        assert!(plain.statistics.converged && bounded.statistics.iterations > plain.statistics.iterations);
    }
}

/// A bound that a film already keeps changes nothing.
#[test]
fn a_bound_that_is_kept_changes_nothing() {
    let plain = film(Method::default(), None);
    let bounded = film(Method::default(), Some(1.01 * plain.statistics.mean_curvature.max));
    assert_eq!((plain.mesh, plain.statistics), (bounded.mesh, bounded.statistics));
}

#[test]
fn a_film_that_cannot_be_within_the_bound_has_not_converged_and_says_so() {
    let plain = film(Method::default(), None);
    let bounded = film(Method::default(), Some(1e-9));
    assert!(plain.statistics.converged && !bounded.statistics.converged);
    assert!(bounded.statistics.mean_curvature.max <= plain.statistics.mean_curvature.max);
    let [warning] = &bounded.warnings[..] else { panic!("{:?}", bounded.warnings) };
    assert!(warning.code == "not_converged", "{warning:?}");
    assert!(warning.detail.contains("the largest mean curvature is"), "{}", warning.detail);
}

#[test]
fn a_smaller_bound_never_ends_at_a_larger_curvature() {
    let plain = film(Method::default(), None).statistics.mean_curvature.max;
    let bounds: Vec<f64> = (1..=24).map(|step| plain * 0.85f64.powi(step)).collect();
    let ends: Vec<f64> =
        bounds.iter().map(|&bound| film(Method::default(), Some(bound)).statistics.mean_curvature.max).collect();
    assert!(ends.windows(2).all(|pair| pair[1] <= pair[0]), "{bounds:?}: {ends:?}");
    assert!(ends[0] <= bounds[0] && ends[23] > bounds[23], "some bounds are met and some are not: {ends:?}");
}
