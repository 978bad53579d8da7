//! Measures which share of the time of a whole solve the check for self-intersections takes, for films, strips and
//! uniform meshes.
//!
//! `cargo run --release -p plateau-uniform-mesh --example self_intersection_cost` prints the table of
//! `docs/VALIDATION.md`. A number after `--` leaves out the meshes with more triangles than that. Times are processor
//! times of this process (on Linux; elsewhere elapsed times), the least of three runs, or of one run for half a million
//! triangles or more. The check is timed on the finished mesh, and repeated on small meshes, because the clock ticks
//! only every few milliseconds.

#![allow(
    clippy::disallowed_macros,
    clippy::disallowed_methods,
    clippy::disallowed_types,
    clippy::too_many_lines,
    reason = "an example"
)]

use plateau_mesh::self_intersections::{Order, self_intersections};
use plateau_mesh::{DVec3, Execution, Mesh};
use plateau_minimal_surface as minimal_surface;
use plateau_ruled_surface as ruled_surface;
use plateau_uniform_mesh as uniform_mesh;
use std::f64::consts::TAU;
use std::time::Instant;

fn circle(points: usize, place: impl Fn(f64) -> DVec3) -> Vec<DVec3> {
    (0..points).map(|k| place(TAU * k as f64 / points as f64)).collect()
}

/// Processor time of this process in seconds. If it is not available, the time since `start`.
fn processor_seconds(start: Instant) -> f64 {
    let spent = std::fs::read_to_string("/proc/self/schedstat").ok();
    let nanoseconds = spent.and_then(|text| text.split_whitespace().next()?.parse::<f64>().ok());
    nanoseconds.map_or_else(|| start.elapsed().as_secs_f64(), |nanoseconds| nanoseconds * 1e-9)
}

/// Prints a row of the table: the least times of a solve and of a check of its mesh.
fn row(name: &str, triangles: usize, order: Order, solve: impl Fn() -> Mesh) {
    let start = Instant::now();
    let (mut whole, mut check, mut pairs, mut count) = (f64::INFINITY, f64::INFINITY, 0, 0);
    for _ in 0..if triangles < 500_000 { 3 } else { 1 } {
        let before = processor_seconds(start);
        let mesh = solve();
        let between = processor_seconds(start);
        count = mesh.triangles.len();
        let repeats = 1 + 1_000_000 / count;
        for _ in 0..repeats {
            let found = self_intersections(&mesh.vertices, &mesh.triangles, order, u64::MAX, &Execution::default());
            pairs = found.expect("nothing interrupts it").pairs;
        }
        let after = processor_seconds(start);
        whole = whole.min(between - before);
        check = check.min((after - between) / repeats as f64);
    }
    println!("| {name} | {count} | {whole:.3} s | {check:.4} s | {:.1}% | {pairs} |", 100.0 * check / whole);
}

fn film(boundaries: &[Vec<DVec3>], triangles: usize) -> Mesh {
    use minimal_surface::{Options, Resolution, solve};
    let options = Options { tolerance: 1e-8, ..Options::new(Resolution::Triangles(triangles)) };
    solve(boundaries, &options, &Execution::default()).expect("a plain boundary has a film").mesh
}

fn main() {
    let most = std::env::args().nth(1).and_then(|count| count.parse().ok()).unwrap_or(1_000_000);
    println!("| mesh | triangles | solve | check | share | pairs |");
    println!("| --- | --- | --- | --- | --- | --- |");
    for triangles in [2_000, 20_000, 200_000, 1_000_000].into_iter().filter(|&count| count <= most) {
        let points = (triangles as f64 * 0.5 * TAU).sqrt().round() as usize;
        let ring = |z: f64| circle(points, |angle| DVec3::new(angle.cos(), angle.sin(), z));
        row("film between two rings", triangles, Order::Spatial, || film(&[ring(0.0), ring(1.0)], triangles));
        let wavy = circle(points, |angle| DVec3::new(angle.cos(), angle.sin(), 0.4 * (3.0 * angle).sin()));
        row("film in a wavy loop", triangles, Order::Spatial, || film(std::slice::from_ref(&wavy), triangles));
    }
    for points in [500, 5_000, 50_000].into_iter().filter(|&count| 2 * count <= most) {
        use ruled_surface::{Objective, Options, solve};
        let rail = |shift: f64| -> Vec<DVec3> {
            let at = |k: usize| 10.0 * k as f64 / points as f64;
            (0..points).map(|k| DVec3::new(at(k), 3.0 * shift + (at(k) + shift).sin(), (1.3 * at(k)).cos())).collect()
        };
        let rails = [rail(0.0), rail(1.0)];
        let strip = |objective| {
            solve(&rails, &Options { objective, ..Options::default() }, &Execution::default()).expect("a strip").mesh
        };
        row("strip of least area", 2 * points, Order::AsGiven, || strip(Objective::MinimalArea));
        if points <= 5_000 {
            row("strip of least twist", 2 * points, Order::AsGiven, || strip(Objective::MinimalTwist));
        }
    }
    {
        use ruled_surface::{Options, solve};
        let strip = |rails: &[Vec<DVec3>; 2], closed: bool| {
            solve(rails, &Options { closed, ..Options::default() }, &Execution::default()).expect("a strip").mesh
        };
        // A strip between a helix and its axis. Its fans have no direction that all their triangles face.
        let axis: Vec<DVec3> = (0..3).map(|k| DVec3::X * (5.0 * f64::from(k))).collect();
        let at = |k: u32| 10.0 * f64::from(k) / 7_499.0;
        let helix = (0..7_500).map(|k| DVec3::new(at(k), (3.0 * at(k)).cos(), (3.0 * at(k)).sin())).collect();
        let fans = [axis, helix];
        row("fans of 3 and 7,500 points", 7_501, Order::AsGiven, || strip(&fans, false));
        let rings = [0.0, 1.0].map(|z| circle(1_000, |angle| DVec3::new(angle.cos(), angle.sin(), z)));
        row("closed strip of 1,000 and 1,000 points", 2_000, Order::AsGiven, || strip(&rings, true));
    }
    for nodes in [1_000, 10_000, 100_000].into_iter().filter(|&count| 2 * count <= most) {
        use uniform_mesh::{Domain, Objective, Options, solve};
        let side = (nodes as f64).sqrt();
        let square = [[0.0, 0.0], [side, 0.0], [side, side], [0.0, side]].map(|[x, y]| DVec3::new(x, y, 0.0)).to_vec();
        for objective in Objective::ALL {
            let domain = Domain::Polygon { outer: square.clone(), holes: Vec::new() };
            let name = format!("uniform mesh of a square, `{}`", objective.name());
            let mesh = || solve(&domain, &Options::new(1.0, objective), &Execution::default()).expect("a mesh").mesh;
            row(&name, nodes, Order::Spatial, mesh);
        }
    }
}
