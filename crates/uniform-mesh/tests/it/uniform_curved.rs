//! Uniform meshes of strongly curved surfaces. The mesh must be close to its surface, or `converged` must be false and
//! the warning must give the reason.
//!
//! The campaign meshes a few random patches and films. With `PLATEAU_LONG=1` it meshes 300 patches and 100 films, with
//! `PLATEAU_LONG=76..100` only the cases with these numbers.

use plateau_mesh::measure;
use plateau_mesh::{DVec2, DVec3, Error, Execution};
use plateau_uniform_mesh::{Domain, Method, Nurbs, Objective, Options, OutOfRange, UniformMesh, Why, solve};
use std::f64::consts::TAU;
use std::ops::Range;
use std::time::Instant;

fn run(domain: &Domain, edge_length: f64, objective: Objective) -> Result<UniformMesh, Error> {
    solve(domain, &Options::new(edge_length, objective), &Execution::default())
}

/// Returns the first violated rule, among the rules for every result and those for a result with `converged`.
fn fault(result: &UniformMesh, edge_length: f64) -> Option<String> {
    let topology = match result.mesh.check() {
        Ok(topology) => topology,
        Err(defect) => return Some(defect.to_string()),
    };
    let fit = result.statistics.surface?;
    let lengths = result.statistics.edge_lengths;
    let angle = result.statistics.angles.0.to_degrees();
    let said = result.warnings.iter().any(|warning| warning.code == "not_converged");
    let converged = result.converged;
    let on_boundary = |edge: &&OutOfRange| {
        let [a, b] = result.members[edge.member];
        let runs = |from: u32, to: u32| topology.outgoing_half_edges(from).any(|h| topology.to(h) == to);
        runs(a, b) != runs(b, a)
    };
    let by_surface = |edge: &&OutOfRange| matches!(edge.why, Why::Curvature | Why::Optimised);
    let across = |edge: &&OutOfRange| matches!(edge.why, Why::SharpCorner | Why::Narrow);
    let mut across = result.out_of_range.iter().filter(across);
    let mut by_surface = result.out_of_range.iter().filter(by_surface);
    let rules = [
        (result.members.len() == topology.edge_count(), "members are not the edges"),
        (measure::degenerate_triangles(&result.mesh) == 0, "a degenerate triangle"),
        ((measure::area(&result.mesh) / fit.area - 1.0 - fit.area_error).abs() < 1e-9, "a wrong area error"),
        (said != converged, "converged and not_converged"),
        (!across.any(|edge| on_boundary(&edge)), "an edge along a side that a corner or the other side is blamed for"),
        (!converged || fit.area_error.abs() <= 0.01, "the area is off"),
        (!converged || fit.normal_deviation_max < 1.4, "a triangle is turned"),
        // Corners, short sides and narrow parts of the boundary may push an edge farther out of the range than the
        // curvature of the surface may.
        (!converged || by_surface.all(|edge| (0.6..=2.5).contains(&(edge.length / edge_length))), "edges out of range"),
        (
            !converged || (lengths.min >= 0.4 * edge_length && lengths.max <= 2.5 * edge_length),
            "an edge far out of range",
        ),
        (!converged || angle >= 5.0, "a needle"),
    ];
    let (_, what) = rules.into_iter().find(|(holds, _)| !holds)?;
    let (low, high) = (lengths.min / edge_length, lengths.max / edge_length);
    Some(format!("{what}: edges {low:.3} to {high:.3}, least angle {angle:.2}, {fit:?}, {:?}", result.warnings))
}

fn check(result: &UniformMesh, edge_length: f64) {
    assert!(result.statistics.surface.is_some());
    assert_eq!(fault(result, edge_length), None);
}

/// A full circle of radius 1 as a rational quadratic curve: its knots, control points and weights.
fn circle() -> (Vec<f64>, Vec<DVec2>, Vec<f64>) {
    let points = [[1, 0], [1, 1], [0, 1], [-1, 1], [-1, 0], [-1, -1], [0, -1], [1, -1], [1, 0]];
    let points = points.map(|[x, y]| DVec2::new(f64::from(x), f64::from(y))).to_vec();
    let knots = [0, 0, 0, 1, 1, 2, 2, 3, 3, 4, 4, 4].map(f64::from).to_vec();
    (knots, points, (0..9).map(|k| if k % 2 == 0 { 1.0 } else { 0.5f64.sqrt() }).collect())
}

/// The first `quarters` quarters of the surface of revolution of a profile (radius, height) about the z axis.
fn revolved(quarters: usize, degree: usize, knots: &[f64], profile: &[DVec2], weights: &[f64]) -> Nurbs {
    let (around, points, across) = circle();
    let count = 2 * quarters + 1;
    let mut around: Vec<f64> = around[..count + 2].to_vec();
    around.push(around[count + 1]);
    let row = |c: &DVec2| profile.iter().map(|p| DVec3::new(p.x * c.x, p.x * c.y, p.y)).collect();
    Nurbs {
        degrees: [2, degree],
        knots: [around, knots.to_vec()],
        control_points: points[..count].iter().map(row).collect(),
        weights: Some(across[..count].iter().map(|a| weights.iter().map(|b| a * b).collect()).collect()),
    }
}

#[test]
fn closed_patches_and_poles_are_meshed() {
    let half = 0.5f64.sqrt();
    let arc = [[10.0, 0.0], [10.0, 10.0], [0.0, 10.0]].map(DVec2::from);
    let meridian = [[0.0, -10.0], [10.0, -10.0], [10.0, 0.0], [10.0, 10.0], [0.0, 10.0]].map(DVec2::from);
    let (knots, ring, weights) = circle();
    let ring: Vec<DVec2> = ring.iter().map(|p| DVec2::new(20.0 + 6.0 * p.x, 6.0 * p.y)).collect();
    let wall = [[10.0, 0.0], [10.0, 30.0]].map(DVec2::from);
    let cases = [
        // Name, patch, ℓ, Euler characteristic, boundary loops, area.
        (
            "octant",
            revolved(1, 2, &[0.0, 0.0, 0.0, 1.0, 1.0, 1.0], &arc, &[1.0, half, 1.0]),
            1.5,
            1,
            1,
            50.0 * TAU / 2.0,
        ),
        (
            "sphere",
            revolved(4, 2, &[0.0, 0.0, 0.0, 1.0, 1.0, 2.0, 2.0, 2.0], &meridian, &[1.0, half, 1.0, half, 1.0]),
            1.5,
            2,
            0,
            200.0 * TAU,
        ),
        ("tube", revolved(4, 1, &[0.0, 0.0, 1.0, 1.0], &wall, &[1.0, 1.0]), 2.0, 0, 2, 300.0 * TAU),
        ("torus", revolved(4, 2, &knots, &ring, &weights), 1.0, 0, 0, 120.0 * TAU * TAU),
    ];
    for (number, (name, patch, edge_length, euler, loops, area)) in cases.into_iter().enumerate() {
        // The first tier takes one objective for each patch.
        let objectives = if crate::is_full() { &Objective::ALL[..] } else { &Objective::ALL[number % 2..][..1] };
        for &objective in objectives {
            let result = run(&Domain::Nurbs(patch.clone()), edge_length, objective).unwrap();
            check(&result, edge_length);
            let fit = result.statistics.surface.unwrap();
            assert!(result.converged && fit.method == Method::OnSurface, "{name}: {:?}", result.warnings);
            assert!((fit.area / area - 1.0).abs() < 1e-3, "{name}: {} {area}", fit.area);
            let topology = result.mesh.check().unwrap();
            assert_eq!((topology.euler_characteristic(), topology.boundary_loops().len()), (euler, loops), "{name}");
            assert_eq!(measure::flipped_triangles(&result.mesh), 0, "{name}");
        }
    }
}

/// A bicubic patch of 30 × 30 with 7 × 7 control points, which lie alternately `height` above and below the plane z =
/// 0.
fn chequered(height: f64) -> Domain {
    let knots = vec![0.0, 0.0, 0.0, 0.0, 1.0, 2.0, 3.0, 4.0, 4.0, 4.0, 4.0];
    let at = |i: u32, j: u32| {
        let z = if (i + j).is_multiple_of(2) { height } else { -height };
        DVec3::new(5.0 * f64::from(i), 5.0 * f64::from(j), z)
    };
    Domain::Nurbs(Nurbs {
        degrees: [3, 3],
        knots: [knots.clone(), knots],
        control_points: (0..7).map(|i| (0..7).map(|j| at(i, j)).collect()).collect(),
        weights: None,
    })
}

#[test]
fn a_wavy_patch_ends_with_a_mesh_under_both_objectives() {
    for objective in Objective::ALL {
        check(&run(&chequered(8.0), 2.0, objective).unwrap(), 2.0);
    }
}

#[test]
fn a_tall_dome_has_no_needles() {
    let height = |i: usize, j: usize| if (1..3).contains(&i) && (1..3).contains(&j) { 100.0 } else { 0.0 };
    let at = |i: usize, j: usize| DVec3::new(10.0 * i as f64, 10.0 * j as f64, height(i, j));
    let dome = Domain::Bezier { control_points: (0..4).map(|i| (0..4).map(|j| at(i, j)).collect()).collect() };
    for objective in Objective::ALL {
        let result = run(&dome, 2.0, objective).unwrap();
        check(&result, 2.0);
        assert!(result.converged, "{:?}", result.warnings);
    }
}

/// The minimal surface over a polygon of twelve points on a cylinder of radius 10, alternately at the heights 15 and
/// -15.
fn saddle() -> Domain {
    let at = |k: u32| {
        let z = if k.is_multiple_of(2) { 15.0 } else { -15.0 };
        (DVec2::from_angle(TAU * f64::from(k) / 12.0) * 10.0).extend(z)
    };
    Domain::Boundaries(vec![(0..12).map(at).collect()])
}

#[test]
fn a_film_that_cannot_be_flattened_keeps_its_area() {
    for objective in Objective::ALL {
        let result = run(&saddle(), 1.0, objective).unwrap();
        check(&result, 1.0);
        let area = measure::area(&result.mesh);
        assert!(result.converged && (area / 678.2 - 1.0).abs() < 0.012, "{area} {:?}", result.warnings);
    }
}

#[test]
fn a_film_between_two_rings_keeps_its_area() {
    let ring = |z: f64| (0..60).map(|k| (DVec2::from_angle(TAU * f64::from(k) / 60.0) * 10.0).extend(z)).collect();
    for objective in Objective::ALL {
        let result = run(&Domain::Boundaries(vec![ring(-4.0), ring(4.0)]), 1.0, objective).unwrap();
        check(&result, 1.0);
        let area = measure::area(&result.mesh);
        assert!(result.converged && (area / 487.9 - 1.0).abs() < 0.01, "{area} {:?}", result.warnings);
    }
}

/// A random number generator that is independent of libraries, so that a seed always gives the same cases.
struct Random(u64);

impl Random {
    fn unit(&mut self) -> f64 {
        self.0 = self.0.wrapping_mul(6_364_136_223_846_793_005).wrapping_add(1_442_695_040_888_963_407);
        (self.0 >> 11) as f64 / (1u64 << 53) as f64
    }
    fn below(&mut self, bound: usize) -> usize {
        (self.unit() * bound as f64) as usize
    }
}

/// A random patch and an edge length. The spacing of the control points is half a wavelength, and their height is at
/// most one wavelength. The edge length is so small that no edge in range is longer than a tenth of the wavelength.
fn random_patch(seed: u64) -> (Domain, f64) {
    let mut random = Random(seed.wrapping_mul(0x9E37_79B9_7F4A_7C15));
    random.unit();
    let degrees = [1 + random.below(4), 1 + random.below(4)];
    let counts = degrees.map(|degree| degree + 1 + random.below(4));
    let wavelength = 20.0;
    let amplitude = wavelength * random.unit();
    let kind = random.below(3);
    let mut height = |i: usize, j: usize| match kind {
        0 if (i + j).is_multiple_of(2) => amplitude,
        0 => -amplitude,
        1 => amplitude * (2.0 * random.unit() - 1.0),
        _ if i.is_multiple_of(2) => amplitude,
        _ => -amplitude,
    };
    let mut control_points = Vec::new();
    for i in 0..counts[0] {
        control_points
            .push((0..counts[1]).map(|j| DVec3::new(10.0 * i as f64, 10.0 * j as f64, height(i, j))).collect());
    }
    let weights = (random.unit() < 0.4)
        .then(|| (0..counts[0]).map(|_| (0..counts[1]).map(|_| 0.5 + 1.5 * random.unit()).collect()).collect());
    let knots = |axis: usize| {
        let (degree, spans) = (degrees[axis], counts[axis] - degrees[axis]);
        let clamped = |value: usize| std::iter::repeat_n(value as f64, degree);
        clamped(0).chain((0..=spans).map(|k| k as f64)).chain(clamped(spans)).collect()
    };
    let edge_length = wavelength * (0.04 + 0.01 * random.unit());
    (Domain::Nurbs(Nurbs { degrees, knots: [knots(0), knots(1)], control_points, weights }), edge_length)
}

/// Symptom: an edge of length 0.50 ℓ along a side was attributed to a corner at the end of the side, so that the mesh
/// counted as `converged`. Patch 285 of the campaign had such an edge of length 0.32 ℓ beside a right angle.
#[test]
fn a_corner_is_no_reason_for_a_short_edge_along_a_side() {
    let (domain, edge_length) = random_patch(77);
    let result = run(&domain, 1.5 * edge_length, Objective::MostEqualEdges).unwrap();
    check(&result, 1.5 * edge_length);
    assert!(result.converged, "{:?}", result.warnings);
}

/// The minimal surface over a closed curve, which is a circle plus three random harmonics in space, and an edge length.
fn random_film(seed: u64) -> (Domain, f64) {
    let mut random = Random(seed.wrapping_mul(0xD134_2543_DE82_EF95));
    random.unit();
    let waves: Vec<[f64; 4]> =
        (2..5).map(|k| [f64::from(k), 1.5 * random.unit(), 4.0 * random.unit(), TAU * random.unit()]).collect();
    let at = |k: u32| {
        let angle = TAU * f64::from(k) / 120.0;
        let sum = |which: usize| waves.iter().map(|w| w[which] * (w[0] * angle + w[3]).sin()).sum::<f64>();
        (DVec2::from_angle(angle) * (10.0 + sum(1))).extend(sum(2))
    };
    (Domain::Boundaries(vec![(0..120).map(at).collect()]), 0.8 + 0.4 * random.unit())
}

/// The numbers of the cases that `PLATEAU_LONG` asks for: a range "first..end", or all numbers for any single number.
fn asked_for() -> Option<Range<u64>> {
    let value = std::env::var("PLATEAU_LONG").ok()?;
    let number = |text: &str| text.parse().expect("PLATEAU_LONG is 1 or a range as 76..100");
    Some(value.split_once("..").map_or(0..u64::MAX, |(first, end)| number(first)..number(end)))
}

/// Meshes cases of one kind under both objectives: the cases that `PLATEAU_LONG` asks for, otherwise the first `few` of
/// `cases`. Fails if `few` is not 0 and no case runs, unless `PLATEAU_LONG` is set.
fn campaign(make: impl Fn(u64) -> (Domain, f64), cases: Range<u64>, few: u64) {
    let asked = asked_for();
    let long = asked.is_some();
    let asked = asked.unwrap_or(cases.start..cases.start + few);
    let (mut runs, mut refused, mut unconverged, mut faults) = (0, 0, 0, Vec::new());
    for seed in cases.start.max(asked.start)..cases.end.min(asked.end) {
        let (domain, edge_length) = make(seed);
        for objective in Objective::ALL {
            runs += 1;
            let clock = Instant::now();
            match run(&domain, edge_length, objective) {
                Ok(result) => {
                    if let Some(fault) = fault(&result, edge_length) {
                        faults.push(format!("{seed} {}: {fault}", objective.name()));
                    }
                    unconverged += usize::from(!result.converged);
                    if long {
                        let seconds = clock.elapsed().as_secs_f64();
                        let said = if result.converged { &[][..] } else { &result.warnings[..] };
                        let fit = result.statistics.surface.expect("a curved domain is compared with its surface");
                        println!(
                            "{seed} {} {} nodes {seconds:.2} s {:?} area {:+.5} {said:?}",
                            objective.name(),
                            result.statistics.nodes,
                            fit.method,
                            fit.area_error
                        );
                    }
                }
                Err(error) => {
                    refused += 1;
                    println!("{seed} {}: {error}", objective.name());
                }
            }
        }
    }
    let counts = format!("{runs} runs, {refused} refused, {unconverged} not converged, faults: {faults:#?}");
    println!("{counts}");
    assert!(runs > 0 || long || few == 0, "no case ran");
    assert!(faults.is_empty() && 20 * refused <= runs && 10 * unconverged <= runs, "{counts}");
}

/// Makes one test for each part of the campaign, so that the parts run in parallel. In the first tier of `scripts/test`
/// only the part that begins with case 0 runs a case.
macro_rules! campaigns {
    ($($name:ident: $make:ident, $cases:expr;)*) => {
        $(
            #[test]
            fn $name() {
                campaign($make, $cases, u64::from(crate::is_full() || $cases.start == 0));
            }
        )*
    };
}

campaigns! {
    random_patches_keep_their_promises_1: random_patch, 0..60;
    random_patches_keep_their_promises_2: random_patch, 60..120;
    random_patches_keep_their_promises_3: random_patch, 120..180;
    random_patches_keep_their_promises_4: random_patch, 180..240;
    random_patches_keep_their_promises_5: random_patch, 240..300;
    random_films_keep_their_promises_1: random_film, 0..34;
    random_films_keep_their_promises_2: random_film, 34..67;
    random_films_keep_their_promises_3: random_film, 67..100;
}
