//! The search for a strip of least area within a corridor of the grid finds the same area as a search of the whole
//! grid.

#![allow(clippy::disallowed_methods, reason = "this is a test")]

mod ruled;

use plateau_mesh::{DVec3, Execution};
use plateau_ruled_surface::{Objective, Options, Strip, estimate, estimate_for};
use ruled::Random;

fn area(a: DVec3, b: DVec3, c: DVec3) -> f64 {
    0.5 * (b - a).cross(c - a).length()
}

#[test]
fn a_square_whose_bridges_all_lean_forward_is_cheaper_by_p_first() {
    let mut random = Random::new(1);
    let mut seen = [0; 2];
    for _ in 0..200_000 {
        let [p, q] = [random.vector(1.0), random.vector(1.0)];
        let [after, next] = [p + random.vector(1.0) * 0.7, q + random.vector(1.0) * 0.7];
        let direction = (after - p).normalize() + (next - q).normalize();
        let leans = [(p, q), (after, q), (p, next), (after, next)].map(|(a, b)| direction.dot(b - a));
        let gain = area(p, after, q) + area(after, q, next) - area(p, q, next) - area(p, after, next);
        if leans.iter().all(|&lean| lean > 0.0) {
            assert!(gain <= 1e-12, "{gain} {p} {after} {q} {next}");
            seen[0] += 1;
        }
        if leans.iter().all(|&lean| lean < 0.0) {
            assert!(gain >= -1e-12, "{gain} {p} {after} {q} {next}");
            seen[1] += 1;
        }
    }
    assert!(seen[0] > 20_000 && seen[1] > 20_000, "{seen:?}");
}

/// Least area of an open strip, from a table over the whole grid.
fn least_area(p: &[DVec3], q: &[DVec3]) -> f64 {
    let mut row = vec![f64::INFINITY; q.len()];
    for i in 0..p.len() {
        for j in 0..q.len() {
            let above = if i > 0 { row[j] + area(p[i - 1], p[i], q[j]) } else { f64::INFINITY };
            let left = if j > 0 { row[j - 1] + area(p[i], q[j - 1], q[j]) } else { f64::INFINITY };
            row[j] = if i + j == 0 { 0.0 } else { above.min(left) };
        }
    }
    row[q.len() - 1]
}

/// Returns a polyline of `count` points with waves of the given height, unequal steps, and noise of the size `jagged`.
fn directrix(random: &mut Random, count: usize, offset: DVec3, height: f64, jagged: f64) -> Vec<DVec3> {
    let waves: Vec<(DVec3, f64)> =
        (1..6).map(|k| (random.vector(1.0) * height / f64::from(k), random.between(-1.0, 1.0) * 3.0)).collect();
    let mut u = 0.0;
    (0..count)
        .map(|_| {
            u += (1.2 + random.between(-1.0, 1.0)) / count as f64;
            let wave: DVec3 =
                waves.iter().enumerate().map(|(k, &(w, phase))| w * ((k + 1) as f64 * 3.0 * u + phase).sin()).sum();
            offset + DVec3::new(6.0 * u, 0.0, 0.0) + wave + random.vector(1.0) * jagged
        })
        .collect()
}

#[test]
fn nothing_is_lost_by_keeping_to_the_corridor() {
    let mut random = Random::new(2);
    let (mut visited, mut whole) = ([0; 2], [0; 2]);
    for case in 0..400 {
        let rough = case % 2;
        let height = [0.0, 0.3, 1.0, 3.0][case / 2 % 4];
        let jagged = [0.0, 0.02][rough];
        // The grid has enough cells for the search to look for a corridor.
        let count = |random: &mut Random| 150 + (21.0 * random.between(-1.0, 1.0)) as usize;
        let (m, n) = (count(&mut random), count(&mut random));
        let p = directrix(&mut random, m, DVec3::ZERO, height, jagged);
        let q = directrix(&mut random, n, DVec3::new(0.0, 1.0, 0.5), height, jagged);
        let strip = Strip::new(p.as_slice().into(), q.as_slice().into(), false).unwrap();
        let execution = Execution::default();
        whole[rough] += (m * n) as u64;
        let path = strip.optimal_path(Objective::MinimalArea, None, 0.0, &execution).unwrap();
        visited[rough] += execution.work();
        let reached = strip.statistics(&path, 0.0, &execution).unwrap().0.area;
        let least = least_area(&p, &q);
        assert!((reached - least).abs() <= 1e-12 * least, "case {case}: {reached}, least {least}");
    }
    // The corridors must leave out cells; otherwise the comparison above shows nothing.
    assert!(3 * visited[0] < 2 * whole[0], "{visited:?} of {whole:?}");
}

#[test]
fn smooth_directrices_leave_a_narrow_corridor() {
    let side = |phase: f64, y: f64| -> Vec<DVec3> {
        let point = |k: usize| {
            let u = k as f64 / 999.0;
            DVec3::new(10.0 * u, y + 0.3 * (9.0 * u + phase).sin(), 0.3 * (7.0 * u - phase).cos())
        };
        (0..1000).map(point).collect()
    };
    let (p, q) = (side(0.3, 0.0), side(1.9, 3.0));
    let strip = Strip::new(p.as_slice().into(), q.as_slice().into(), false).unwrap();
    let execution = Execution::default();
    strip.optimal_path(Objective::MinimalArea, None, 0.0, &execution).unwrap();
    assert!(execution.work() < 100_000, "{} of 1e6 cells", execution.work());
}

#[test]
fn a_strip_of_least_area_is_priced_by_its_corridor() {
    let side = |phase: f64, y: f64| -> Vec<DVec3> {
        let point = |k: usize| {
            let u = k as f64 / 1999.0;
            DVec3::new(10.0 * u, y + 0.3 * (9.0 * u + phase).sin(), 0.3 * (7.0 * u - phase).cos())
        };
        (0..2000).map(point).collect()
    };
    let rails = [side(0.3, 0.0), side(1.9, 3.0)];
    let execution = Execution::default();
    let of = |options: &Options| {
        let whole = estimate(&[2000, 2000], options).cells;
        (whole, estimate_for(&rails, options, &execution).unwrap().cells)
    };
    let (whole, visited) = of(&Options::default());
    assert!(whole == 4_000_000 && visited < 100_000, "{visited} of {whole}");
    let (whole, visited) = of(&Options { objective: Objective::MinimalTwist, ..Options::default() });
    assert_eq!(whole, visited);
}
