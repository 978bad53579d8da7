//! How far each film is at most from the least area over all oriented surfaces with its boundary, for two budgets.

use super::{boundaries, run};
use plateau_geometry::lower_bound::{self, LowerBound};
use plateau_geometry::minimal_surface::{Method, MinimalSurface, Newton, Options, Resolution, TopologyRule};
use plateau_geometry::{DVec3, Execution};
use std::f64::consts::TAU;

/// The budgets in nominal seconds of one core.
const SECONDS: [f64; 2] = [1.0, 10.0];

pub fn run_all() {
    println!("\n| boundary | area | gap, 1 s | gap, 10 s |\n| --- | --- | --- | --- |");
    for (name, loops) in cases() {
        let film = run(&loops, &Options::new(Resolution::Triangles(20_000)));
        let gaps = SECONDS.map(|seconds| gap(film.statistics.area, &certify(&loops, &film, seconds)));
        println!("| {name} | {:.6} | {} | {} |", film.statistics.area, gaps[0], gaps[1]);
    }
    println!("\n| gap of the rings | film | area | above the bound |\n| --- | --- | --- | --- |");
    for gap_between in [0.9, 1.0, 1.05, 1.1, 1.2, 1.3] {
        let loops = boundaries::rings(96, gap_between);
        let method = Method::Newton(Newton { topology: TopologyRule::Best, ..Newton::default() });
        let film = run(&loops, &Options { method, ..Options::new(Resolution::Triangles(5_000)) });
        let bound = certify(&loops, &film, 10.0);
        for topology in film.statistics.spanning.iter().flat_map(|spanning| &spanning.topologies) {
            let name = if topology.films.len() == 1 { "connected" } else { "two discs" };
            match topology.area {
                Some(area) => println!("| {gap_between} | {name} | {area:.5} | {} |", gap(area, &bound)),
                None => println!("| {gap_between} | {name} | none | |"),
            }
        }
    }
}

fn certify(loops: &[Vec<DVec3>], film: &MinimalSurface, seconds: f64) -> LowerBound {
    let options = lower_bound::Options { gap: 1e-5, seconds };
    match lower_bound::certify(loops, &film.mesh, &options, &Execution::default()) {
        Ok(Some(bound)) => bound,
        Ok(None) | Err(_) => {
            eprintln!("no lower bound");
            std::process::exit(1);
        }
    }
}

fn gap(area: f64, bound: &LowerBound) -> String {
    format!("{:.2}%", 100.0 * (area / bound.area - 1.0))
}

fn cases() -> Vec<(&'static str, Vec<Vec<DVec3>>)> {
    let curve = |points: usize, at: &dyn Fn(f64) -> [f64; 3]| -> Vec<Vec<DVec3>> {
        vec![(0..points).map(|k| DVec3::from(at(TAU * k as f64 / points as f64))).collect()]
    };
    // Enneper's surface up to radius 0.9, where it is still the only film.
    let enneper = |t: f64| {
        let (u, v) = (0.9 * t.cos(), 0.9 * t.sin());
        [u - u.powi(3) / 3.0 + u * v * v, v - v.powi(3) / 3.0 + v * u * u, u * u - v * v]
    };
    let trefoil = |t: f64| [t.sin() + 2.0 * (2.0 * t).sin(), t.cos() - 2.0 * (2.0 * t).cos(), -(3.0 * t).sin()];
    // A loop of two lobes whose waists are a twentieth of their length apart.
    let nearly_touching = |t: f64| [1.5 * t.cos(), (0.05 + 0.6 * t.cos() * t.cos()) * t.sin(), 0.2 * (2.0 * t).sin()];
    vec![
        ("two rings, gap 1", boundaries::rings(96, 1.0)),
        ("helicoid", vec![boundaries::helicoid()]),
        ("Scherk", vec![boundaries::scherk()]),
        ("skew quadrilateral", vec![boundaries::skew_quadrilateral(24)]),
        ("wavy loop", curve(96, &|t| [t.cos(), t.sin(), 0.2 * (3.0 * t).sin()])),
        ("Enneper, radius 0.9", curve(96, &enneper)),
        ("trefoil", curve(120, &trefoil)),
        ("loop that nearly touches itself", curve(120, &nearly_touching)),
    ]
}
