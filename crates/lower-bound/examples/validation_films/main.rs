//! Draws the pictures of films in docs/papers and docs/VALIDATION.md, and prints the tables of docs/VALIDATION.md on
//! triple junctions and lower bounds. The tables of docs/papers are printed by benches/papers/tables.py.
//!
//! `cargo run --release -p plateau-lower-bound --example validation_films -- docs/validation` writes the SVG files to
//! that folder and prints the tables. A word after the folder selects a part: `lower-bounds` (the gaps for three
//! budgets), `proven-range` (the plot of two rings) or `bento-cavalcanti` (the pictures of their figures).

#![allow(clippy::disallowed_macros, clippy::disallowed_methods, reason = "this is an example")]

mod bento_cavalcanti;
#[path = "../../../minimal-surface/tests/it/boundaries/mod.rs"]
mod boundaries;
mod chen_cai_zheng;
mod liu_wang;
mod lower_bounds;
mod picture;
mod spanning;
mod triple_junctions;

use picture::{Picture, row};
use plateau_mesh::{DVec3, Execution};
use plateau_minimal_surface::{MinimalSurface, Options, solve};
use std::f64::consts::TAU;

fn main() {
    let folder = std::env::args().nth(1).unwrap_or_else(|| String::from("docs/validation"));
    let save = |name: &str, pictures: &[Picture]| {
        let path = format!("{folder}/{name}.svg");
        if let Err(error) = std::fs::write(&path, row(pictures)) {
            eprintln!("{path}: {error}");
            std::process::exit(1);
        }
    };
    match std::env::args().nth(2).as_deref() {
        Some("lower-bounds") => return lower_bounds::run_all(),
        Some("proven-range") => return lower_bounds::plot_rings(&folder),
        Some("bento-cavalcanti") => return bento_cavalcanti::run_all(&save),
        _ => {}
    }
    chen_cai_zheng::run_all(&save);
    liu_wang::run_all(&save);
    bento_cavalcanti::run_all(&save);
    spanning::run_all(&save);
    triple_junctions::run_all(&save);
    lower_bounds::run_all();
    lower_bounds::plot_rings(&folder);
}

type Save<'a> = &'a dyn Fn(&str, &[Picture]);

fn run(boundaries: &[Vec<DVec3>], options: &Options) -> MinimalSurface {
    match solve(boundaries, options, &Execution::default()) {
        Ok(surface) => surface,
        Err(error) => {
            eprintln!("{error}");
            std::process::exit(1);
        }
    }
}

fn circle(n: usize, radius: f64, centre: DVec3, normal: DVec3) -> Vec<DVec3> {
    let (u, v) = normal.normalize().any_orthonormal_pair();
    (0..n).map(|k| TAU * k as f64 / n as f64).map(|t| centre + radius * (u * t.cos() + v * t.sin())).collect()
}

fn rings(heights: &[f64]) -> Vec<Vec<DVec3>> {
    heights.iter().map(|&z| circle(36, 10.0, DVec3::new(0.0, 0.0, z), DVec3::Z)).collect()
}
