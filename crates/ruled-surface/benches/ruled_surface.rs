//! Benchmark of the solver of ruled strips on one core against a plain scalar loop. The loop fills a table of f64 and a
//! table of back pointers of one byte each. Both sides include path recovery and allocation.
//!
//! `cargo bench -p plateau-ruled-surface --bench ruled_surface` measures; with `-- --record` it prints one JSON line a
//! case for `benches/results.jsonl` instead (the fastest of several runs, ns a cell, ratio to the scalar loop of the
//! same run).

#![allow(
    clippy::disallowed_macros,
    clippy::disallowed_methods,
    clippy::disallowed_types,
    clippy::too_many_lines,
    reason = "a benchmark"
)]

use criterion::{BenchmarkId, Criterion};
use plateau_mesh::{DVec3, Execution};
use plateau_ruled_surface::{Objective, Strip};
use std::hint::black_box;
use std::time::Instant;

/// Returns two smooth wavy directrices of `m` and `n` points.
fn wavy(m: usize, n: usize) -> [Vec<DVec3>; 2] {
    let wave = |u: f64, phase: f64| {
        (1..7).map(|k| 0.3 * (k as f64 * (std::f64::consts::PI * u + phase)).sin() / k as f64).sum::<f64>()
    };
    let side = |count: usize, phase: f64, y: f64, z: f64| {
        let point = |k: usize| {
            let u = k as f64 / (count - 1) as f64;
            DVec3::new(10.0 * u, y + wave(u, phase), z + wave(u, phase + 0.7))
        };
        (0..count).map(point).collect()
    };
    [side(m, 0.3, 0.0, 0.0), side(n, 1.9, 3.0, 1.0)]
}

/// Returns the directrices of [`wavy`] with every other point moved to one side. No bridge is certain to lean forward
/// or back (see `graph/corridor.rs`), so the path of least area needs the whole grid.
fn zigzag(m: usize, n: usize) -> [Vec<DVec3>; 2] {
    let mut strip = wavy(m, n);
    for side in &mut strip {
        for point in side.iter_mut().step_by(2) {
            point.y += 40.0 / m.max(n) as f64;
        }
    }
    strip
}

/// Two wavy rings.
fn rings(m: usize, n: usize) -> [Vec<DVec3>; 2] {
    let side = |count: usize, phase: f64, z: f64| {
        let point = |k: usize| {
            let u = std::f64::consts::TAU * k as f64 / count as f64;
            let radius = 3.0 + 0.5 * (3.0 * u + phase).sin() + 0.3 * (2.0 * u - phase).cos();
            DVec3::new(radius * (u + phase).cos(), radius * (u + phase).sin(), z)
        };
        (0..count).map(point).collect()
    };
    [side(m, 0.0, 0.0), side(n, 1.0, 0.8)]
}

/// The baseline: minimal area by a loop over all cells, with a table of f64 and a back pointer of one byte for each
/// cell.
fn scalar_area(p: &[DVec3], q: &[DVec3]) -> Vec<[u32; 2]> {
    let (m, n) = (p.len(), q.len());
    let mut table = vec![0.0f64; m * n];
    let mut back = vec![0u8; m * n];
    let area = |a: DVec3, b: DVec3, c: DVec3| 0.5 * (b - a).cross(c - a).length();
    for i in 0..m {
        for j in 0..n {
            if i == 0 && j == 0 {
                continue;
            }
            let mut best = f64::INFINITY;
            if i > 0 {
                best = table[(i - 1) * n + j] + area(p[i - 1], p[i], q[j]);
            }
            if j > 0 {
                let value = table[i * n + j - 1] + area(p[i], q[j], q[j - 1]);
                if value < best {
                    best = value;
                    back[i * n + j] = 1;
                }
            }
            table[i * n + j] = best;
        }
    }
    let (mut i, mut j) = (m - 1, n - 1);
    let mut path = vec![[i as u32, j as u32]];
    while i + j > 0 {
        if back[i * n + j] == 1 {
            j -= 1
        } else {
            i -= 1
        }
        path.push([i as u32, j as u32]);
    }
    path.reverse();
    path
}

fn solve(strip: &[Vec<DVec3>; 2], closed: bool, objective: Objective) -> Vec<[u32; 2]> {
    solve_counting(strip, closed, objective).0
}

/// Returns the optimal path, and the number of grid cells that were visited to find it.
fn solve_counting([p, q]: &[Vec<DVec3>; 2], closed: bool, objective: Objective) -> (Vec<[u32; 2]>, u64) {
    let strip = Strip::new(p.as_slice().into(), q.as_slice().into(), closed).expect("a valid strip");
    let execution = Execution::default();
    let path = strip.optimal_path(objective, None, 0.0, &execution).expect("nothing interrupts it");
    (path, execution.work())
}

const OBJECTIVES: [Objective; 3] =
    [Objective::MinimalArea, Objective::MinimalBendingEnergy, Objective::MinimalMeanCurvatureVariation];

fn measure(criterion: &mut Criterion) {
    let mut group = criterion.benchmark_group("ruled_strip");
    group.sample_size(10);
    for size in [1000, 3000] {
        let strip = wavy(size, size);
        group.bench_function(BenchmarkId::new("scalar_baseline_area", size), |b| {
            b.iter(|| scalar_area(black_box(&strip[0]), black_box(&strip[1])))
        });
        for objective in OBJECTIVES {
            group.bench_function(BenchmarkId::new(objective.name(), size), |b| {
                b.iter(|| solve(black_box(&strip), false, objective))
            });
        }
    }
    let whole = zigzag(1000, 1000);
    group.bench_function("whole_grid_minimal_area/1000", |b| {
        b.iter(|| solve(black_box(&whole), false, Objective::MinimalArea))
    });
    let closed = rings(1000, 1000);
    group.bench_function("closed_minimal_area/1000", |b| {
        b.iter(|| solve(black_box(&closed), true, Objective::MinimalArea))
    });
    group.finish();
}

/// Returns the processor time of this thread in seconds, so that other processes do not affect the measurement. Where
/// Linux does not provide it, returns the seconds since `started`.
fn now(started: Instant) -> f64 {
    let text = std::fs::read_to_string("/proc/thread-self/schedstat").ok();
    let used = text.and_then(|text| text.split(' ').next()?.parse::<f64>().ok());
    used.map_or_else(|| started.elapsed().as_secs_f64(), |nanoseconds| nanoseconds * 1e-9)
}

/// Returns the seconds of one run. It averages over many runs, because the kernel counts in ticks of some milliseconds.
fn seconds(work: impl Fn() -> Vec<[u32; 2]>) -> f64 {
    let started = Instant::now();
    let before = now(started);
    for runs in 1.. {
        black_box(work());
        let used = now(started) - before;
        if used > 0.1 {
            return used / f64::from(runs);
        }
    }
    unreachable!("time goes on")
}

fn record() {
    let closed = rings(1000, 1000);
    for (size, rounds) in [(1000usize, 9), (3000, 9), (10_000, 5)] {
        let (strip, whole) = (wavy(size, size), zigzag(size, size));
        let mut cases: Vec<_> =
            OBJECTIVES.iter().map(|&objective| ("ruled_strip", &strip, false, objective, f64::INFINITY)).collect();
        cases.push(("ruled_strip_zigzag", &whole, false, Objective::MinimalArea, f64::INFINITY));
        if size == 1000 {
            cases.extend(OBJECTIVES.iter().map(|&o| ("ruled_strip_closed", &closed, true, o, f64::INFINITY)));
        }
        // The baseline and the cases run in turns, so that other load on the machine slows both alike. The fastest run
        // of each counts.
        let mut baseline = f64::INFINITY;
        for _ in 0..rounds {
            baseline = baseline.min(seconds(|| scalar_area(&strip[0], &strip[1])));
            for (_, strip, closed, objective, fastest) in &mut cases {
                *fastest = fastest.min(seconds(|| solve(strip, *closed, *objective)));
            }
        }
        let cells = (size * size) as f64;
        for (name, strip, closed, objective, fastest) in cases {
            let visited = solve_counting(strip, closed, objective).1 as f64;
            println!(
                "{{\"bench\":\"{name}/{}\",\"size\":{size},\"ms\":{:.3},\"cells_visited_ratio\":{:.4},\
                 \"ns_per_visit\":{:.3},\"baseline\":\"scalar_area, open\",\
                 \"baseline_ns_per_cell\":{:.3},\"ratio\":{:.3}}}",
                objective.name(),
                fastest * 1e3,
                visited / cells,
                fastest / visited * 1e9,
                baseline / cells * 1e9,
                baseline / fastest
            );
        }
    }
}

fn main() {
    if std::env::args().any(|argument| argument == "--record") {
        record();
    } else {
        let mut criterion = Criterion::default().configure_from_args();
        measure(&mut criterion);
        criterion.final_summary();
    }
}
