//! Tests the default solver: convergence to surfaces that are known in closed form, and the limit areas of the five
//! reference polygons.

use crate::boundaries::{self, circle, patch, rings, skew_quadrilateral};
use plateau_equilibrium::form_finding::StopReason;
use plateau_mesh::{DVec3, Error, Execution, Interruption, Progress, Signal};
use plateau_minimal_surface::{BoundarySampling, Method, MinimalSurface, Options, Resolution, solve};
use std::cell::Cell;
use std::f64::consts::PI;

fn options(triangles: usize) -> Options {
    Options { tolerance: 1e-8, ..Options::new(Resolution::Triangles(triangles)) }
}

/// Solves, and checks the properties that every result must have: it converged, is stable, and is a manifold of the
/// right Euler characteristic without flipped triangles. Its boundary must be the given boundary, point by point and in
/// order.
fn solved(given: &[Vec<DVec3>], options: &Options) -> MinimalSurface {
    let surface = solve(given, options, &Execution::default()).unwrap();
    let statistics = &surface.statistics;
    assert!(statistics.converged && statistics.residual <= 1e-8, "{:?}", surface.warnings);
    assert_eq!(statistics.stop_reason, StopReason::Residual);
    assert_eq!((statistics.quality.flipped_triangles, statistics.quality.degenerate_triangles), (0, 0));
    let stability = statistics.stability.unwrap();
    assert_eq!((stability.stable, stability.morse_index), (Some(true), Some(0)));
    assert!(stability.lowest_eigenvalue > 0.0);
    let topology = surface.mesh.check().unwrap();
    assert_eq!((statistics.euler_characteristic, statistics.components), (2 - given.len() as i64, 1));
    assert_eq!(topology.euler_characteristic(), statistics.euler_characteristic);
    assert_eq!(topology.boundary_loops().len(), given.len());
    for ((points, vertices), boundary) in given.iter().zip(&surface.input_vertices).zip(&surface.boundaries) {
        assert!(points.iter().zip(vertices).all(|(&point, &v)| surface.mesh.vertices[v as usize] == point));
        let along: Vec<u32> = boundary.iter().copied().filter(|v| vertices.contains(v)).collect();
        assert_eq!(&along, vertices);
        for (k, &a) in boundary.iter().enumerate() {
            assert!(topology.is_boundary(a) && topology.are_adjacent(a, boundary[(k + 1) % boundary.len()]));
        }
    }
    let first = &surface.boundaries[0];
    assert_eq!(topology.to(topology.outgoing[first[0] as usize]), first[1], "oriented along the first boundary");
    surface
}

/// Solves at three resolutions, each with four times the triangles of the one before. The errors of area and distance
/// must fall with h².
fn converges(
    name: &str,
    exact_area: f64,
    boundary: impl Fn(usize) -> Vec<Vec<DVec3>>,
    distance: impl Fn(DVec3) -> f64,
) {
    let mut errors = Vec::new();
    for level in 0..3 {
        let surface = solved(&boundary(1 << level), &options(2000 << (2 * level)));
        let vertices = &surface.mesh.vertices;
        let far = vertices.iter().map(|&vertex| distance(vertex)).fold(0.0, f64::max);
        let mean_square = vertices.iter().map(|&vertex| distance(vertex).powi(2)).sum::<f64>() / vertices.len() as f64;
        let error = (surface.statistics.area - exact_area).abs() / exact_area;
        errors.push((surface.statistics.triangles as f64, error, mean_square.sqrt(), far));
    }
    // Order of convergence with respect to the number of triangles. The order 1 corresponds to h².
    let order = |coarse: f64, fine: f64, ratio: f64| (coarse / fine).ln() / ratio.ln();
    for pair in errors.windows(2) {
        let ratio = pair[1].0 / pair[0].0;
        assert!(order(pair[0].1, pair[1].1, ratio) > 0.85, "{name}: area {errors:?}");
        assert!(order(pair[0].2, pair[1].2, ratio) > 0.85, "{name}: distance {errors:?}");
    }
    // The largest distance depends on single vertices and scatters, so its order is taken over the whole range.
    assert!(order(errors[0].3, errors[2].3, errors[2].0 / errors[0].0) > 0.7, "{name}: largest distance {errors:?}");
    assert!(errors[2].1 < 1e-3 && errors[2].3 < 1e-2, "{name}: {errors:?}");
    println!("{name} (triangles, error of area, rms distance, largest distance): {errors:?}");
}

#[test]
fn the_helicoid() {
    let primitive = |u: f64| 0.5 * (u * (u * u + 1.0).sqrt() + u.asinh());
    let area = 11.0 * (primitive(10.0) - primitive(2.0));
    let distance = |p: DVec3| (p.y * p.z.cos() - p.x * p.z.sin()).abs() / (1.0 + p.x * p.x + p.y * p.y).sqrt();
    converges("helicoid", area, |k| vec![boundaries::helicoid_with(12 * k, 81 * k)], distance);
}

#[test]
fn the_catenoid_between_two_rings() {
    // The larger solution of c cosh(1 / 2c) = 1, which is the wider neck.
    let c = (0..200).fold(0.8, |c: f64, _| 1.0 / (0.5 / c).cosh());
    let area = PI * c * c * ((1.0 / c).sinh() + 1.0 / c);
    assert!((area - 5.991797).abs() < 1e-6);
    let distance = |p: DVec3| (p.x.hypot(p.y) - c * (p.z / c).cosh()).abs() / (p.z / c).cosh();
    converges("catenoid", area, |k| rings(48 * k, 1.0), distance);
}

#[test]
fn scherk() {
    let side = (-0.4 * PI, 0.4 * PI);
    let surface = |x: f64, y: f64| DVec3::new(x, y, (y.cos() / x.cos()).ln());
    let distance = |p: DVec3| {
        let grow = p.z.exp();
        let gradient = ((p.x.sin() * grow).powi(2) + p.y.sin().powi(2) + (p.x.cos() * grow).powi(2)).sqrt();
        (p.x.cos() * grow - p.y.cos()).abs() / gradient
    };
    converges("scherk", 11.72195, |k| vec![patch(surface, side, side, (16 * k, 16 * k))], distance);
}

/// Enneper's surface at the polar coordinates of its parameters.
fn enneper(radius: f64, angle: f64) -> DVec3 {
    let (p, q) = (radius * angle.cos(), radius * angle.sin());
    enneper_at(p, q)
}

fn enneper_at(p: f64, q: f64) -> DVec3 {
    DVec3::new(p - p.powi(3) / 3.0 + p * q * q, -q + q.powi(3) / 3.0 - p * p * q, p * p - q * q)
}

#[test]
fn enneper_below_its_stability_radius() {
    let radius = 0.8f64;
    let area = PI * (radius.powi(2) + radius.powi(4) + radius.powi(6) / 3.0);
    let rim = |n: usize| (0..n).map(|k| enneper(radius, 2.0 * PI * k as f64 / n as f64)).collect();
    // Finds the nearest point of the surface by the Gauss-Newton method in its parameters.
    let distance = |point: DVec3| {
        let (mut p, mut q) = (point.x, -point.y);
        for _ in 0..40 {
            let (a, b) = (1.0 - p * p + q * q, 2.0 * p * q);
            let (along_p, along_q) = (DVec3::new(a, -b, 2.0 * p), DVec3::new(b, -1.0 + q * q - p * p, -2.0 * q));
            let rest = point - enneper_at(p, q);
            let (e, f, g) = (along_p.dot(along_p), along_p.dot(along_q), along_q.dot(along_q));
            let (s, t) = (along_p.dot(rest), along_q.dot(rest));
            p += (g * s - f * t) / (e * g - f * f);
            q += (e * t - f * s) / (e * g - f * f);
        }
        point.distance(enneper_at(p, q))
    };
    converges("enneper", area, |k| vec![rim(64 * k)], distance);
}

#[test]
fn the_skew_quadrilateral_passes_through_its_centre() {
    // A rotation by 90° about the axis through the midpoints of both diagonals, followed by a reflection in the centre,
    // maps the quadrilateral to itself. Therefore the surface meets the axis in the centre.
    let polygon = skew_quadrilateral(1);
    let centre = polygon.iter().sum::<DVec3>() / 4.0;
    let mut errors = Vec::new();
    for triangles in [500, 2000, 8000] {
        let surface = solved(std::slice::from_ref(&polygon), &options(triangles));
        // Distance of the centre from the plane of the nearest triangle.
        let mesh = &surface.mesh;
        let middle = |t: &[u32; 3]| mesh.corners(*t).iter().sum::<DVec3>() / 3.0;
        let nearest = mesh
            .triangles
            .iter()
            .min_by(|a, b| middle(a).distance(centre).total_cmp(&middle(b).distance(centre)))
            .unwrap();
        let [a, b, c] = mesh.corners(*nearest);
        let gap = (centre - a).dot((b - a).cross(c - a).normalize()).abs();
        errors.push((surface.statistics.area - 0.639_630_8, gap));
    }
    assert!(errors[0].0 > 0.0 && errors[0].0 / errors[1].0 > 3.0 && errors[1].0 / errors[2].0 > 3.0, "{errors:?}");
    assert!(errors[2].0 < 1e-4 && errors.iter().all(|error| error.1 < 1e-3), "{errors:?}");
}

#[test]
fn the_five_reference_polygons() {
    let references = [
        ("helicoid", vec![boundaries::helicoid()], 535.0748),
        ("catenoid patch", vec![boundaries::catenoid()], 58.1637),
        ("scherk", vec![boundaries::scherk()], 11.6147),
        ("rings", rings(96, 1.0), 5.98944),
        ("skew quadrilateral", vec![skew_quadrilateral(16)], 0.639_630_8),
    ];
    for (name, polygons, limit) in references {
        let areas = [2000, 8000, 32000].map(|triangles| {
            let statistics = solved(&polygons, &options(triangles)).statistics;
            // The extrapolated area of the statistics, which large meshes may lack.
            assert!(statistics.extrapolated_area.is_some() || triangles > 10_000, "{name}");
            if let Some(extrapolated) = statistics.extrapolated_area {
                assert!((extrapolated.area / limit - 1.0).abs() < 1e-4, "{name} {triangles}: {extrapolated:?}");
                assert!(
                    (statistics.area - limit).abs() < 5.0 * extrapolated.error_estimate,
                    "{name}: {extrapolated:?}"
                );
            }
            (statistics.triangles as f64, statistics.area)
        });
        let errors = areas.map(|(_, area)| area - limit);
        assert!(errors[0] > errors[1] && errors[1] > errors[2], "{name}: {areas:?}");
        // Extrapolation in h², that is, in the inverse of the number of triangles.
        let [_, (n, coarse), (m, fine)] = areas;
        let extrapolated = fine - (coarse - fine) * n / (m - n);
        assert!((extrapolated / limit - 1.0).abs() < 3e-5, "{name}: {extrapolated} {areas:?}");
    }
}

#[test]
fn the_papers_polygons_kept_as_they_are() {
    for (polygons, limit) in [(vec![boundaries::helicoid()], 535.0748), (vec![boundaries::catenoid()], 58.1637)] {
        let options = Options { boundary_sampling: BoundarySampling::Keep, ..options(2050) };
        let surface = solved(&polygons, &options);
        assert_eq!(surface.boundaries[0].len(), polygons[0].len());
        assert!((surface.statistics.area / limit - 1.0).abs() < 4e-3, "{}", surface.statistics.area);
        let extrapolated = surface.statistics.extrapolated_area.unwrap();
        assert!((extrapolated.area / limit - 1.0).abs() < 4e-4, "{extrapolated:?}");
    }
}

#[test]
fn a_large_kept_polygon_is_solved_from_the_coarse_to_the_fine_with_all_its_points() {
    // 611 is prime, so no coarse polygon has edges that can all be halved down to the finest level.
    let polygons = vec![circle(611, 1.0, -0.5), circle(610, 1.0, 0.5)];
    let options = Options { boundary_sampling: BoundarySampling::Keep, ..options(20_000) };
    let surface = solved(&polygons, &options);
    assert_eq!(surface.boundaries.iter().map(Vec::len).collect::<Vec<_>>(), [611, 610]);
    assert!((surface.statistics.triangles as f64 / 20_000.0 - 1.0).abs() < 0.1);
    assert!((surface.statistics.area - 5.991797).abs() < 1e-3);
    assert!(surface.statistics.history.len() < 20);
}

#[test]
fn the_number_of_solves_does_not_grow_with_the_mesh() {
    let counts = [2_000, 20_000, 80_000].map(|triangles| {
        let surface = solved(&[boundaries::helicoid()], &options(triangles));
        let fine = surface.statistics.history.iter().rev().take_while(|row| row.phase == "newton").count();
        (surface.statistics.iterations, fine)
    });
    assert!(counts.iter().all(|(all, _)| *all <= 30), "{counts:?}");
}

#[test]
fn the_harmonic_map_of_a_plane_boundary_has_its_area_for_energy() {
    let options = Options { method: Method::Harmonic, ..options(2000) };
    let square = boundaries::sides(&[DVec3::ZERO, DVec3::X, DVec3::new(1.0, 1.0, 0.0), DVec3::Y], 4);
    let surface = solve(&[square], &options, &Execution::default()).unwrap();
    let statistics = &surface.statistics;
    assert!((statistics.objective_value - 1.0).abs() < 1e-12 && (statistics.area - 1.0).abs() < 1e-12);
    assert_eq!((statistics.stop_reason, statistics.iterations), (StopReason::Solved, 1));
}

#[test]
fn a_large_plane_boundary_is_exact() {
    // The coarse mesh is minimal before the first step, so the finer levels have nothing to correct.
    let corners = [DVec3::ZERO, DVec3::new(2.0, 0.0, 1.0), DVec3::new(2.0, 2.0, 2.0), DVec3::new(0.0, 2.0, 1.0)];
    let area = (corners[1] - corners[0]).cross(corners[3] - corners[0]).length();
    let surface = solved(&[corners.to_vec()], &options(40_000));
    assert!((surface.statistics.area / area - 1.0).abs() < 1e-12);
    assert!((surface.statistics.extrapolated_area.unwrap().area / area - 1.0).abs() < 1e-12);
}

#[test]
fn rings_near_the_critical_gap() {
    let surface = solved(&rings(96, 1.32), &options(4000));
    assert!(surface.statistics.stability.unwrap().lowest_eigenvalue < 1.5);
}

#[test]
fn offset_scale_and_rotation_change_nothing_but_themselves() {
    // The boundary has no symmetry, because rounding would otherwise choose between meshes that are equally good.
    let at =
        |angle: f64| DVec3::new(angle.cos(), 0.8 * (angle + 0.1).sin(), 0.3 * (2.0 * angle).cos() + 0.1 * angle.sin());
    let polygons = vec![(0..100).map(|k| at(2.0 * PI * k as f64 / 100.0)).collect::<Vec<_>>()];
    let plain = solved(&polygons, &options(6000)).statistics;
    let turn = glam::DQuat::from_axis_angle(DVec3::new(1.0, 2.0, -0.5).normalize(), 1.1);
    for (scale, offset) in [(1e-6, 0.0), (1e6, 0.0), (1.0, 1e7)] {
        let moved: Vec<Vec<DVec3>> = polygons
            .iter()
            .map(|polygon| polygon.iter().map(|&p| scale * (turn * p) + DVec3::splat(offset)).collect())
            .collect();
        let statistics = solved(&moved, &options(6000)).statistics;
        // Rounding may flip single edges of the initial mesh, which changes the area by less than 1e-7.
        let tolerance = if offset == 0.0 { 1e-7 } else { 1e-6 };
        let ratio = statistics.area / (scale * scale) / plain.area;
        assert!((ratio - 1.0).abs() < tolerance, "{scale} {offset}: {ratio}");
        let (own, moved) = (plain.stability.unwrap(), statistics.stability.unwrap());
        assert!((moved.lowest_eigenvalue * scale * scale / own.lowest_eigenvalue - 1.0).abs() < 1e-3);
    }
}

#[test]
fn a_deadline_at_any_look_leaves_the_whole_boundary_and_a_cancel_nothing() {
    let polygons = rings(160, 1.0);
    let looks_of_a_run = {
        let exec = Execution::default();
        solve(&polygons, &options(20_000), &exec).unwrap();
        exec.looks()
    };
    assert!(looks_of_a_run > 40);
    let mut meshes = 0;
    for k in 0..12 {
        let stop_at = looks_of_a_run * k / 12;
        for signal in [Signal::Deadline, Signal::Cancel] {
            let looks = Cell::new(0);
            let ask = || {
                looks.set(looks.get() + 1);
                if looks.get() > stop_at { signal } else { Signal::Continue }
            };
            let last = Cell::new(0.0);
            let report = |progress: Progress| {
                assert!(progress.fraction >= last.get() && progress.fraction <= 1.0);
                last.set(progress.fraction);
            };
            match solve(&polygons, &options(20_000), &Execution::new(&ask, &report)) {
                Err(Error::Interrupted(interruption)) => {
                    assert_eq!(interruption == Interruption::Cancelled, signal == Signal::Cancel);
                }
                Ok(surface) => {
                    assert_eq!(signal, Signal::Deadline);
                    assert_eq!(surface.statistics.stop_reason, StopReason::Deadline);
                    assert_eq!(surface.mesh.check().unwrap().boundary_loops().len(), 2);
                    for (points, vertices) in polygons.iter().zip(&surface.input_vertices) {
                        assert!(points.iter().zip(vertices).all(|(&p, &v)| surface.mesh.vertices[v as usize] == p));
                    }
                    meshes += 1;
                }
                Err(error) => panic!("{error}"),
            }
        }
    }
    assert!(meshes >= 4, "{meshes}");
}
