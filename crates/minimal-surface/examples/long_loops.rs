//! Measures the processor time of films in boundary loops of many points.
//!
//! `cargo run --release -p plateau-minimal-surface --example long_loops` prints the table of `docs/VALIDATION.md`. Two
//! optional arguments follow `--`: the number of points of each loop (default 50,000), and a word that selects the
//! loops whose name contains it. Times are processor times of this process (on Linux; elsewhere elapsed time).

#![allow(
    clippy::disallowed_macros,
    clippy::disallowed_methods,
    clippy::disallowed_types,
    clippy::too_many_lines,
    reason = "an example"
)]

use plateau_mesh::random::SplitMix64;
use plateau_mesh::{DVec2, DVec3, Execution};
use plateau_minimal_surface::{BoundarySampling, Options, Resolution, solve};
use std::f64::consts::TAU;
use std::time::Instant;

/// Processor time of this process in seconds. If the system does not report it, the time elapsed since `start`.
fn processor_seconds(start: Instant) -> f64 {
    let spent = std::fs::read_to_string("/proc/self/schedstat").ok();
    let nanoseconds = spent.and_then(|text| text.split_whitespace().next()?.parse::<f64>().ok());
    nanoseconds.map_or_else(|| start.elapsed().as_secs_f64(), |nanoseconds| nanoseconds * 1e-9)
}

fn main() {
    let mut arguments = std::env::args().skip(1);
    let points: usize = arguments.next().and_then(|count| count.parse().ok()).unwrap_or(50_000);
    let wanted = arguments.next().unwrap_or_default();
    let mut random = SplitMix64::new(50);
    let mut circle = |radius: f64, height: f64, place: &dyn Fn(f64) -> (f64, f64)| -> Vec<DVec3> {
        let side = TAU / points as f64;
        let mut noise = |size: f64| size * side * (random.unit() - 0.5);
        let at = |k: usize| {
            let angle = TAU * k as f64 / points as f64;
            let (r, z) = place(angle);
            (DVec2::from_angle(angle) * (r + noise(radius))).extend(z + noise(height))
        };
        (0..points).map(at).collect()
    };
    let loops = [
        ("circle", circle(0.0, 0.0, &|_| (1.0, 0.0))),
        ("noisy circle", circle(0.6, 0.0, &|_| (1.0, 0.0))),
        ("plane star", circle(0.0, 0.0, &|angle| (1.0 + 0.5 * (7.0 * angle).cos(), 0.0))),
        ("star with dents", circle(0.0, 0.0, &|angle| (1.0 + 0.5 * (7.0 * angle).cos().abs(), 0.0))),
        ("wavy loop", circle(0.0, 0.0, &|angle| (1.0, 0.4 * (3.0 * angle).sin()))),
        ("noisy wavy loop", circle(0.6, 0.6, &|angle| (1.0, 0.4 * (3.0 * angle).sin()))),
        ("loop that winds", circle(0.0, 0.0, &|angle| (1.0 + 0.3 * (40.0 * angle).cos(), 0.3 * (40.0 * angle).sin()))),
    ];
    println!("| loop of {points} points | asked for | triangles | time | work for each point | residual | ended |");
    println!("| --- | --- | --- | --- | --- | --- | --- |");
    for (name, boundary) in loops.iter().filter(|(name, _)| name.contains(&wanted)) {
        for (asked, sampling) in
            [(2, BoundarySampling::Refine), (2, BoundarySampling::Keep), (8, BoundarySampling::Keep)]
        {
            let start = Instant::now();
            let before = processor_seconds(start);
            let plain = Options::new(Resolution::Triangles(asked * points));
            let options = Options { boundary_sampling: sampling, tolerance: 1e-6, ..plain };
            let execution = Execution::default();
            let result = solve(std::slice::from_ref(boundary), &options, &execution);
            let seconds = processor_seconds(start) - before;
            let work = execution.work() as f64 / points as f64;
            let (triangles, residual, ended) = match &result {
                Ok(film) => {
                    let statistics = &film.statistics;
                    (film.mesh.triangles.len(), statistics.residual, statistics.stop_reason.name().to_owned())
                }
                Err(error) => (0, f64::NAN, error.to_string()),
            };
            println!(
                "| {name} | {} {sampling:?} | {triangles} | {seconds:.2} s | {work:.0} | {residual:.1e} | {ended} |",
                asked * points
            );
        }
    }
}
