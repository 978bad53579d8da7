//! Measures Chen, Cai and Zheng's curvature of the default's films over forty counts of triangles.
//!
//! `cargo run --release -p plateau-minimal-surface --example curvature_sweep` solves the helicoid and the catenoid of
//! their Figs. 6 and 7 with 40 counts from 1,000 to 20,000, three splits of the points over the sides and both
//! samplings of the boundary: 480 films. It prints a table. `-- docs/validation/curvature_sweep.svg` also draws the
//! curvatures over the counts.

#![allow(
    clippy::disallowed_macros,
    clippy::disallowed_methods,
    clippy::disallowed_types,
    clippy::too_many_lines,
    reason = "an example"
)]

#[path = "../tests/it/boundaries/mod.rs"]
mod boundaries;

use plateau_mesh::{DVec3, Execution};
use plateau_minimal_surface::{BoundarySampling, Options, Resolution, solve};
use std::fmt::Write;

/// Number of counts of triangles.
const COUNTS: usize = 40;
/// Least and largest count.
const RANGE: [f64; 2] = [1_000.0, 20_000.0];
const SAMPLINGS: [(BoundarySampling, &str); 2] =
    [(BoundarySampling::Refine, "refine"), (BoundarySampling::Keep, "keep")];

/// A patch of the paper: its helicoid or its catenoid.
struct Patch {
    name: &'static str,
    /// The curvature that the paper prints for its own mesh of about 2,000 triangles.
    printed: f64,
    /// The splits of the points over the sides, each with its boundary.
    splits: Vec<(String, Vec<DVec3>)>,
}

struct Film {
    split: usize,
    sampling: usize,
    asked: usize,
    triangles: usize,
    curvature: f64,
    angle_deg: f64,
}

fn patches() -> [Patch; 2] {
    let helicoid = [[12, 12, 81, 81], [12, 12, 49, 113], [16, 16, 77, 77]];
    let catenoid = [[52, 26], [46, 32], [58, 20]];
    let sides = |[left, right, inner, outer]: [usize; 4]| format!("{left} and {right}, {inner} and {outer} intervals");
    [
        Patch {
            name: "helicoid",
            printed: 7e-4,
            splits: helicoid.map(|split| (sides(split), boundaries::helicoid_split(split))).into(),
        },
        Patch {
            name: "catenoid",
            printed: 4e-3,
            splits: catenoid
                .map(|[nu, nv]| (format!("{nu} and {nv} intervals"), boundaries::catenoid_split(nu, nv)))
                .into(),
        },
    ]
}

/// Solves a patch with every split, sampling and count.
fn films(patch: &Patch) -> Vec<Film> {
    let mut films = Vec::new();
    for (split, (_, boundary)) in patch.splits.iter().enumerate() {
        for (sampling, &(boundary_sampling, _)) in SAMPLINGS.iter().enumerate() {
            for k in 0..COUNTS {
                let part = k as f64 / (COUNTS - 1) as f64;
                let asked = (RANGE[0] * (RANGE[1] / RANGE[0]).powf(part)).round() as usize;
                let options = Options { boundary_sampling, ..Options::new(Resolution::Triangles(asked)) };
                let surface = solve(std::slice::from_ref(boundary), &options, &Execution::default()).expect("a film");
                let statistics = surface.statistics;
                films.push(Film {
                    split,
                    sampling,
                    asked,
                    triangles: statistics.triangles,
                    // The paper divides by the area of the whole ring, and the statistics by a third of it.
                    curvature: statistics.mean_curvature.max / 3.0,
                    angle_deg: statistics.quality.angles.0.to_degrees(),
                });
            }
        }
    }
    films
}

fn median(mut values: Vec<f64>) -> f64 {
    values.sort_by(f64::total_cmp);
    values[values.len() / 2]
}

fn table(patches: &[(Patch, Vec<Film>)]) {
    println!(
        "| surface | split | sampling | above the paper's curvature | largest | in the median, up to 3,000 triangles | \
         from 14,000 on | smallest angle |"
    );
    println!("| --- | --- | --- | --- | --- | --- | --- | --- |");
    for (patch, films) in patches {
        for (split, (name, _)) in patch.splits.iter().enumerate() {
            for (sampling, (_, sampled)) in SAMPLINGS.iter().enumerate() {
                let own = || films.iter().filter(|film| film.split == split && film.sampling == sampling);
                let above = own().filter(|film| film.curvature > patch.printed).count();
                let worst = own().max_by(|a, b| a.curvature.total_cmp(&b.curvature)).expect("forty films");
                let angle = own().map(|film| film.angle_deg).fold(f64::INFINITY, f64::min);
                let within = |range: std::ops::Range<usize>| {
                    median(own().filter(|film| range.contains(&film.asked)).map(|film| film.curvature).collect())
                };
                println!(
                    "| {} | {name} | `{sampled}` | {above} of {COUNTS} | {:.1e} at {} triangles | {:.1e} | {:.1e} | {angle:.1}° |",
                    patch.name,
                    worst.curvature,
                    worst.triangles,
                    within(0..3_000),
                    within(14_000..usize::MAX),
                );
            }
        }
    }
    let above = |(patch, films): &(Patch, Vec<Film>)| films.iter().filter(|f| f.curvature > patch.printed).count();
    let all: usize = patches.iter().map(|(_, films)| films.len()).sum();
    println!("| both | | | {} of {all} | | | | |", patches.iter().map(above).sum::<usize>());
}

/// Draws the curvature over the count of triangles, both on logarithmic scales.
fn picture(patches: &[(Patch, Vec<Film>)]) -> String {
    const COLOURS: [&str; 3] = ["#2166ac", "#b2182b", "#1b7837"];
    const SIZE: [f64; 2] = [460.0, 320.0];
    let mut svg = format!(
        r#"<svg xmlns="http://www.w3.org/2000/svg" viewBox="0 0 {} {}" font-family="sans-serif" font-size="11">"#,
        2.0 * SIZE[0],
        SIZE[1]
    );
    svg.push_str("<rect width=\"100%\" height=\"100%\" fill=\"white\"/>\n");
    for (panel, (patch, films)) in patches.iter().enumerate() {
        let [low, high] = [1e-4, 2e-2];
        let left = panel as f64 * SIZE[0];
        let x = |count: f64| left + 50.0 + (SIZE[0] - 70.0) * (count / 900.0).ln() / (24_000f64 / 900.0).ln();
        let y = |value: f64| SIZE[1] - 40.0 - (SIZE[1] - 80.0) * (value / low).ln() / (high / low).ln();
        let mut text = |at: [f64; 2], anchor: &str, text: &str| {
            let _ = writeln!(svg, r#"<text x="{:.1}" y="{:.1}" text-anchor="{anchor}">{text}</text>"#, at[0], at[1]);
        };
        text([left + 50.0, 20.0], "start", &format!("{}: largest curvature over triangles", patch.name));
        for count in [1_000.0, 2_000.0, 5_000.0, 10_000.0, 20_000.0] {
            text([x(count), SIZE[1] - 22.0], "middle", &format!("{count}"));
        }
        for (value, shown) in [(1e-4, "1e-4"), (1e-3, "1e-3"), (1e-2, "1e-2")] {
            text([left + 44.0, y(value) + 4.0], "end", shown);
        }
        text([left + SIZE[0] - 22.0, y(patch.printed) - 4.0], "end", &format!("the paper: {:.0e}", patch.printed));
        for (split, (name, _)) in patch.splits.iter().enumerate() {
            let row = SIZE[1] - 46.0 - 12.0 * (patch.splits.len() - 1 - split) as f64;
            let _ = writeln!(
                svg,
                r#"<text x="{:.1}" y="{row:.1}" fill="{}" font-size="9">{name}</text>"#,
                left + 54.0,
                COLOURS[split]
            );
        }
        let _ = writeln!(
            svg,
            r##"<path d="M{:.1} {:.1}H{:.1}" stroke="#777" stroke-dasharray="4 3"/><path d="M{:.1} 30V{:.1}H{:.1}" fill="none" stroke="black"/>"##,
            left + 50.0,
            y(patch.printed),
            left + SIZE[0] - 20.0,
            left + 50.0,
            SIZE[1] - 40.0,
            left + SIZE[0] - 20.0
        );
        for film in films {
            let (colour, fill) = (COLOURS[film.split], if film.sampling == 0 { COLOURS[film.split] } else { "none" });
            let _ = writeln!(
                svg,
                r#"<circle cx="{:.1}" cy="{:.1}" r="2.2" fill="{fill}" stroke="{colour}"/>"#,
                x(film.triangles as f64),
                y(film.curvature.clamp(low, high))
            );
        }
    }
    let _ = writeln!(
        svg,
        r#"<text x="{}" y="{}" text-anchor="middle">full: boundary_sampling refine; hollow: keep</text>"#,
        SIZE[0],
        SIZE[1] - 6.0
    );
    svg.push_str("</svg>");
    svg
}

fn main() {
    let solved = patches().map(|patch| {
        let films = films(&patch);
        (patch, films)
    });
    table(&solved);
    if let Some(path) = std::env::args().nth(1) {
        std::fs::write(path, picture(&solved)).expect("the folder exists");
    }
}
