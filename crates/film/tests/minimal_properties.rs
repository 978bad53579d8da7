//! Invariances of minimal surfaces: under motions and scalings of the boundary, and under another first point or
//! direction of the boundary's list.

#![allow(clippy::disallowed_methods, clippy::disallowed_types, reason = "this is a test")]

use glam::DQuat;
use plateau_film::minimal_surface::{Options, Resolution, Statistics, solve};
use plateau_mesh::{DVec3, Execution};
use proptest::prelude::*;
use std::f64::consts::TAU;

/// A closed curve without symmetry: a circle with a few waves in radius and height.
fn boundary() -> impl Strategy<Value = Vec<DVec3>> {
    let wave = || (-1.0..1.0f64, -1.0..1.0f64);
    (24usize..48, wave(), wave(), wave(), wave()).prop_map(|(points, in_2, in_3, up_2, up_3)| {
        let sum = |(a, b): (f64, f64), angle: f64| a * angle.cos() + b * angle.sin();
        (0..points)
            .map(|k| {
                let t = TAU * k as f64 / points as f64;
                let radius = 1.0 + 0.1 * sum(in_2, 2.0 * t) + 0.07 * sum(in_3, 3.0 * t);
                let height = 0.3 * sum(up_2, 2.0 * t) + 0.15 * sum(up_3, 3.0 * t) + 0.05 * t.sin();
                DVec3::new(radius * t.cos(), 0.8 * radius * t.sin(), height)
            })
            .collect()
    })
}

fn solved(boundary: &[DVec3]) -> Statistics {
    let options = Options { tolerance: 1e-8, ..Options::new(Resolution::Triangles(400)) };
    let surface = solve(&[boundary.to_vec()], &options, &Execution::default()).expect("a plain curve has a surface");
    let topology = surface.mesh.check().expect("a manifold");
    assert_eq!((topology.euler_characteristic(), topology.boundary_loops().len()), (1, 1));
    assert!(surface.input_vertices[0].iter().zip(boundary).all(|(&v, p)| surface.mesh.vertices[v as usize] == *p));
    surface.statistics
}

/// Compares areas in units of `scale²`. The area of the mesh may differ as much as between two meshes of this size. The
/// extrapolated area must agree more closely.
fn same(moved: &Statistics, plain: &Statistics, scale: f64, tolerance: f64) -> Result<(), TestCaseError> {
    prop_assert_eq!(moved.converged, plain.converged);
    let ratio = moved.area / (scale * scale) / plain.area;
    prop_assert!((ratio - 1.0).abs() < tolerance, "area {}", ratio);
    let limit = |statistics: &Statistics| statistics.extrapolated_area.map(|extrapolated| extrapolated.area);
    if let (Some(moved), Some(plain)) = (limit(moved), limit(plain)) {
        let ratio = moved / (scale * scale) / plain;
        prop_assert!((ratio - 1.0).abs() < 0.1 * tolerance, "extrapolated area {}", ratio);
    }
    let index = |statistics: &Statistics| statistics.stability.and_then(|stability| stability.morse_index);
    prop_assert_eq!(index(moved), index(plain));
    Ok(())
}

proptest! {
    #![proptest_config(ProptestConfig { cases: 12, ..ProptestConfig::default() })]

    #[test]
    fn place_turn_and_size(
        boundary in boundary(),
        axis in (-1.0..1.0f64, -1.0..1.0f64, -1.0..1.0f64),
        angle in 0.0..TAU,
        exponent in -6..=6i32,
    ) {
        let plain = solved(&boundary);
        prop_assert!(plain.converged);
        let axis = DVec3::new(axis.0, axis.1, axis.2).try_normalize().unwrap_or(DVec3::X);
        let turn = DQuat::from_axis_angle(axis, angle);
        let scale = 10f64.powi(exponent);
        let turned: Vec<DVec3> = boundary.iter().map(|&p| scale * (turn * p)).collect();
        same(&solved(&turned), &plain, scale, 2e-3)?;
        // Coordinates of 1e7 leave nine digits, so the residual cannot fall fully to its tolerance.
        let far: Vec<DVec3> = boundary.iter().map(|&p| p + DVec3::new(1e7, -1e7, 1e7)).collect();
        same(&solved(&far), &plain, 1.0, 2e-3)?;
    }

    #[test]
    fn start_and_direction_of_the_loop(boundary in boundary(), start in 0usize..24, reversed: bool) {
        let plain = solved(&boundary);
        let mut other = boundary;
        other.rotate_left(start);
        if reversed {
            other.reverse();
        }
        same(&solved(&other), &plain, 1.0, 4e-3)?;
    }
}
