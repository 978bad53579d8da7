//! Reads valid and invalid requests of 10, 1,000 and 200,000 points.
//!
//! `cargo bench -p plateau-engine --bench reading` measures with criterion. With `-- --case` it reads each request a
//! few times and prints the medians as one JSON line. The line also has the times of the first valid and the first
//! invalid request of the process. The latter includes compiling schemas.

#![allow(
    clippy::disallowed_macros,
    clippy::disallowed_methods,
    clippy::disallowed_types,
    clippy::too_many_lines,
    reason = "a benchmark"
)]

use criterion::{BenchmarkId, Criterion};
use plateau_engine::kinds::minimal_surface::KIND;
use plateau_engine::limits::Limits;
use plateau_engine::request::{CheckedRequest, Request};
use plateau_engine::source::no_jobs;
use plateau_strict_json::json;
use plateau_strict_json::rejection::Rejection;
use std::collections::BTreeMap;
use std::fmt::Write;
use std::hint::black_box;
use std::time::Instant;

const LIMITS: Limits = Limits {
    points: 1_000_000,
    triangles: 10_000_000,
    grid_cells: u64::MAX,
    iterations: 1_000_000,
    memory_bytes: u64::MAX,
};

/// Returns the JSON text of a minimal surface's request whose boundary loop has this number of points. If `right` is
/// false, the last coordinate is a string, so that the request is invalid.
fn body(points: usize, right: bool) -> String {
    let mut text = String::from("{\"resolution\":{\"triangles\":2000},\"boundaries\":[[");
    for k in 0..points {
        let angle = std::f64::consts::TAU * k as f64 / points as f64;
        let comma = if k == 0 { "" } else { "," };
        let _ = write!(text, "{comma}[{},{},{}]", angle.cos(), angle.sin(), (3.0 * angle).sin() / 5.0);
    }
    text + if right { "]]}" } else { ",[0,0,\"x\"]]]}" }
}

fn read(body: &[u8]) -> Result<CheckedRequest, Rejection> {
    match Request::read(KIND, body, &[], &no_jobs, &LIMITS) {
        Some((accepted, _)) => Ok(accepted),
        None => Request::from_value(KIND, &json::parse(body)?, &no_jobs, &LIMITS),
    }
}

fn cases() -> Vec<(String, String)> {
    let each = [10, 1_000, 200_000].into_iter().flat_map(|points| [(points, true), (points, false)]);
    let named = |(points, right): (usize, bool)| {
        (format!("{points} points, {}", if right { "right" } else { "wrong" }), body(points, right))
    };
    each.map(named).collect()
}

fn print_case() {
    let cases = cases();
    let milliseconds = |body: &str| {
        let start = Instant::now();
        let _ = black_box(read(body.as_bytes()));
        start.elapsed().as_secs_f64() * 1e3
    };
    let mut medians: BTreeMap<&str, f64> = BTreeMap::new();
    medians.insert("first request, right", milliseconds(&cases[0].1));
    medians.insert("first request, wrong", milliseconds(&cases[1].1));
    for (name, body) in &cases {
        let mut times: Vec<f64> =
            (0..if body.len() > 1_000_000 { 15 } else { 301 }).map(|_| milliseconds(body)).collect();
        times.sort_by(f64::total_cmp);
        medians.insert(name, times[times.len() / 2]);
    }
    println!("{}", serde_json::to_string(&medians).unwrap_or_default());
}

fn main() {
    if std::env::args().any(|argument| argument == "--case") {
        return print_case();
    }
    let mut criterion = Criterion::default().configure_from_args();
    let mut group = criterion.benchmark_group("reading");
    for (name, body) in cases() {
        group.bench_function(BenchmarkId::from_parameter(name), |bencher| bencher.iter(|| read(body.as_bytes())));
    }
    group.finish();
    criterion.final_summary();
}
