//! Times minimal surfaces on one core, from the raw boundary to the finished statistics, including stability.
//!
//! `cargo bench -p plateau-minimal-surface --bench minimal_surface` measures 2k, 20k, 200k and 1M triangles.
//! - With `-- --case rings 200000` one case is solved three times (once from 500k on) and printed as a JSON line with
//!   the least processor time in seconds (on Linux; elsewhere elapsed time) and the peak memory of the process.
//! - With `-- --sliding` the patches of Chen, Cai and Zheng are solved with and without sliding vertices in turn, and
//!   the ratio of the two times is printed.
//!
//! `benches/minimal_surface_peers.py` runs the same cases with other programs.

#![allow(
    clippy::disallowed_macros,
    clippy::disallowed_methods,
    clippy::disallowed_types,
    clippy::too_many_lines,
    reason = "a benchmark"
)]

#[path = "../tests/it/boundaries/mod.rs"]
mod boundaries;

use criterion::{BenchmarkId, Criterion};
use plateau_mesh::{DVec3, Execution};
use plateau_minimal_surface::{MinimalSurface, Options, Resolution, solve};
use std::hint::black_box;
use std::time::{Duration, Instant};

/// Returns the boundary of a structured mesh of about this number of triangles. The boundary points have the spacing of
/// that mesh.
fn boundary(name: &str, triangles: f64) -> Option<Vec<Vec<DVec3>>> {
    match name {
        "helicoid" => {
            let along = (triangles / 2.0 * 5.0).sqrt().round();
            let across = (triangles / 2.0 / along).round();
            Some(vec![boundaries::helicoid_with(across as usize, along as usize)])
        }
        "rings" => {
            let strips = (triangles / 2.0 / std::f64::consts::TAU).sqrt().round();
            Some(boundaries::rings((triangles / 2.0 / strips).round() as usize, 1.0))
        }
        _ => None,
    }
}

fn solved(polygons: &[Vec<DVec3>], triangles: usize) -> MinimalSurface {
    let options = Options { tolerance: 1e-8, ..Options::new(Resolution::Triangles(triangles)) };
    let surface = solve(polygons, &options, &Execution::default()).expect("a plain boundary has a surface");
    assert!(surface.statistics.converged && surface.statistics.stability.is_some());
    surface
}

/// Returns the time that this process has spent on a processor, or the time since `start` where Linux's schedstat is
/// missing.
fn processor_time(start: Instant) -> Duration {
    let spent = std::fs::read_to_string("/proc/self/schedstat").ok();
    let nanoseconds = spent.and_then(|text| text.split_whitespace().next()?.parse().ok());
    nanoseconds.map_or_else(|| start.elapsed(), Duration::from_nanos)
}

fn peak_memory_mb() -> Option<f64> {
    let status = std::fs::read_to_string("/proc/self/status").ok()?;
    let line = status.lines().find(|line| line.starts_with("VmHWM:"))?;
    Some(line.split_whitespace().nth(1)?.parse::<f64>().ok()? / 1024.0)
}

fn case(name: &str, triangles: usize) {
    let polygons = boundary(name, triangles as f64).expect("helicoid or rings");
    let start = Instant::now();
    let (mut least, mut last) = (f64::INFINITY, None);
    for _ in 0..if triangles < 500_000 { 3 } else { 1 } {
        let before = processor_time(start);
        last = Some(solved(&polygons, triangles).statistics);
        least = least.min((processor_time(start) - before).as_secs_f64());
    }
    let statistics = last.expect("one run at least");
    let stability = statistics.stability.expect("checked in solved");
    println!(
        "{{\"bench\":\"minimal_surface\",\"problem\":\"{name}\",\"triangles\":{},\"seconds\":{least:.4},\
         \"iterations\":{},\
         \"area\":{:.9},\"residual\":{:.2e},\"morse_index\":{},\"lowest_eigenvalue\":{:.6},\"peak_mb\":{:.0}}}",
        statistics.triangles,
        statistics.iterations,
        statistics.area,
        statistics.residual,
        stability.morse_index.map_or_else(|| "null".to_owned(), |index| index.to_string()),
        stability.lowest_eigenvalue,
        peak_memory_mb().unwrap_or(f64::NAN),
    );
}

/// Prints the cost of sliding: the least processor time of films that slide over that of films that do not.
fn sliding() {
    for (name, polygon) in [("helicoid", boundaries::helicoid()), ("catenoid", boundaries::catenoid())] {
        for triangles in [2_000, 20_000] {
            let plain = Options { tolerance: 1e-8, ..Options::new(Resolution::Triangles(triangles)) };
            let ways = [Options { slides: false, ..plain.clone() }, plain];
            let mut least = [f64::INFINITY; 2];
            let start = Instant::now();
            for _ in 0..20 {
                for (options, least) in ways.iter().zip(&mut least) {
                    let before = processor_time(start);
                    black_box(solve(std::slice::from_ref(&polygon), options, &Execution::default()).expect("a film"));
                    *least = least.min((processor_time(start) - before).as_secs_f64());
                }
            }
            let [without, with] = least;
            println!(
                "{{\"bench\":\"sliding\",\"problem\":\"{name}\",\"triangles\":{triangles},\"seconds\":{with:.5},\
                 \"without\":{without:.5},\"ratio\":{:.3}}}",
                with / without
            );
        }
    }
}

fn main() {
    let arguments: Vec<String> = std::env::args().collect();
    if let Some(at) = arguments.iter().position(|argument| argument == "--case") {
        let triangles = arguments.get(at + 2).and_then(|count| count.parse().ok());
        let (Some(name), Some(triangles)) = (arguments.get(at + 1), triangles) else {
            eprintln!("--case needs a problem (helicoid, rings) and a number of triangles");
            std::process::exit(2);
        };
        return case(name, triangles);
    }
    if arguments.iter().any(|argument| argument == "--sliding") {
        return sliding();
    }
    let testing = arguments.iter().any(|argument| argument == "--test");
    let mut criterion = Criterion::default().configure_from_args().sample_size(10);
    let mut group = criterion.benchmark_group("minimal_surface");
    for name in ["helicoid", "rings"] {
        for triangles in if testing { vec![2_000] } else { vec![2_000, 20_000, 200_000, 1_000_000] } {
            let polygons = boundary(name, triangles as f64).expect("both are known");
            group.bench_with_input(BenchmarkId::new(name, triangles), &polygons, |bencher, polygons| {
                bencher.iter(|| black_box(solved(polygons, triangles)));
            });
        }
    }
    group.finish();
    criterion.final_summary();
}
