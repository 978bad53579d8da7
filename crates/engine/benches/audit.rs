//! Measures the time of the audit relative to that of the solve, and the most work and the longest time between two
//! checks of the cancel signal. Prints one line of JSON for each case. Times are in milliseconds; those of the solve
//! and of the audit are the fastest of several runs.
//!
//! ```text
//! cargo bench --package plateau-engine --bench audit
//! ```

#![allow(
    clippy::disallowed_macros,
    clippy::disallowed_methods,
    clippy::disallowed_types,
    clippy::too_many_lines,
    reason = "a benchmark"
)]

use plateau_engine::limits::Limits;
use plateau_engine::request::Request;
use plateau_engine::solved::Signal;
use plateau_engine::source::no_jobs;
use serde_json::{Value, json};
use std::cell::Cell;
use std::time::{Duration, Instant};

const LIMITS: Limits =
    Limits { points: 1_000_000, triangles: 1_000_000, grid_cells: 1 << 40, iterations: 10_000, memory_bytes: 1 << 40 };

/// Returns the request for the film of the example `tent`, with about this number of triangles.
fn tent(triangles: usize) -> Value {
    json!({
        "kind": "minimal_surface",
        "boundaries": [[[0, 0, 0], [8, 0, 3], [8, 8, 0], [0, 8, 3]]],
        "resolution": { "triangles": triangles }
    })
}

/// Returns the request for a ruled strip of least area between two wavy directrices of this number of points each.
fn strip(points: usize) -> Value {
    let rail = |y: f64, phase: f64| -> Vec<[f64; 3]> {
        let wave = |k: usize| libm::sin(7.0 * k as f64 / points as f64 + phase);
        (0..points).map(|k| [10.0 * k as f64 / points as f64, y + 0.3 * wave(k), wave(3 * k)]).collect()
    };
    json!({ "kind": "ruled_surface", "directrices": [rail(0.0, 0.0), rail(3.0, 1.0)], "objective": "minimal_area" })
}

/// Returns the shortest time of as many runs as fit into a second or two, three at least.
fn fastest(mut run: impl FnMut()) -> Duration {
    let started = Instant::now();
    let mut best = Duration::MAX;
    for round in 0..1_000 {
        if round >= 3 && started.elapsed() > Duration::from_secs(2) {
            break;
        }
        let begin = Instant::now();
        run();
        best = best.min(begin.elapsed());
    }
    best
}

/// Solves a request. Returns the largest number of elementary operations, and the longest time, between two checks of
/// the cancel signal.
fn between_looks(request: &Request) -> (u64, Duration) {
    let (last, longest) = (Cell::new(Instant::now()), Cell::new(Duration::ZERO));
    let signal = || {
        let now = Instant::now();
        longest.set(longest.get().max(now - last.replace(now)));
        Signal::Continue
    };
    let (_, work) = request.solve_and_count(&signal, &|_| {});
    (work, longest.get())
}

fn main() {
    let cases = [
        ("film 2,000 triangles", tent(2_000)),
        ("film 20,000 triangles", tent(20_000)),
        ("film 200,000 triangles", tent(200_000)),
        ("strip 100 by 100", strip(100)),
        ("strip 1000 by 1000", strip(1_000)),
    ];
    for (name, value) in cases {
        let request = Request::read_with_kind(&value, &no_jobs, &LIMITS).expect("a valid request").request;
        let solve = || request.solve(&|| Signal::Continue, &|_| {}).expect("a result");
        let solved = solve();
        assert_eq!(request.audit(&solved), 0);
        let whole = fastest(|| drop(solve()));
        let audit = fastest(|| assert_eq!(request.audit(&solved), 0));
        let milliseconds = |time: Duration| (time.as_secs_f64() * 1e6).round() / 1e3;
        let percent = 100.0 * audit.as_secs_f64() / (whole - audit).as_secs_f64();
        let (work, gap) = between_looks(&request);
        let row = json!({
            "case": name,
            "solve_and_audit_ms": milliseconds(whole),
            "audit_ms": milliseconds(audit),
            "percent_of_solve": (percent * 100.0).round() / 100.0,
            "work_between_looks": work,
            "between_looks_ms": milliseconds(gap)
        });
        println!("{row}");
    }
}
