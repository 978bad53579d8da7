//! A table that bounds how far each film's area exceeds the least area of all oriented surfaces with its boundary, for
//! three budgets. Also a plot of the proven bounds for two rings.

use super::{boundaries, run};
use plateau_lower_bound as lower_bound;
use plateau_lower_bound::LowerBound;
use plateau_mesh::{DVec3, Execution};
use plateau_minimal_surface::{Method, MinimalSurface, Newton, Options, Resolution, TopologyRule};
use std::f64::consts::{PI, TAU};
use std::fmt::Write as _;

/// The budgets in nominal seconds of one core.
const SECONDS: [f64; 3] = [1.0, 10.0, 60.0];

pub fn run_all() {
    println!(
        "\n| boundary | area | gap, 1 s | gap, 10 s | gap, 60 s | tetrahedra |\n| --- | --- | --- | --- | --- | --- |"
    );
    for (name, loops) in cases() {
        let film = run(&loops, &Options::new(Resolution::Triangles(20_000)));
        let bounds = SECONDS.map(|seconds| certify(&loops, &film, seconds));
        let gaps = bounds.each_ref().map(|bound| gap(film.statistics.area, bound));
        let tetrahedra = bounds[2].fields.iter().map(|field| field.tetrahedra.len()).sum::<usize>();
        println!("| {name} | {:.6} | {} | {tetrahedra} |", film.statistics.area, gaps.join(" | "));
    }
}

/// Writes the plot of the proven bounds for two rings to `proven_range.svg` in a folder, and prints its values.
pub fn plot_rings(folder: &str) {
    println!("\n| gap of the rings | film | area | above the bound |\n| --- | --- | --- | --- |");
    let mut proven = Vec::new();
    for gap_between in [0.9, 0.95, 1.0, 1.05, 1.1, 1.15, 1.2, 1.25, 1.3] {
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
        proven.push([gap_between, bound.area, film.statistics.area]);
    }
    let path = format!("{folder}/proven_range.svg");
    if let Err(error) = std::fs::write(&path, plot(&proven)) {
        eprintln!("{path}: {error}");
        std::process::exit(1);
    }
}

/// Area of the stable catenoid between two circles of radius 1.
fn catenoid(gap: f64) -> f64 {
    // The waist c solves c cosh(gap / 2c) = 1. Newton's method converges to the larger root from its start at 1.
    let mut waist: f64 = 1.0;
    for _ in 0..60 {
        let (value, slope) = {
            let x = 0.5 * gap / waist;
            (waist * x.cosh() - 1.0, x.cosh() - x * x.sinh())
        };
        waist -= value / slope;
    }
    PI * waist * (gap + waist * (gap / waist).sinh())
}

/// Plots the areas of the two films over the gap of the rings, and the range that is proven to contain the least area:
/// from the bound to the area of the better film.
fn plot(proven: &[[f64; 3]]) -> String {
    let (low, high) = (5.2, 7.6);
    let x = |gap: f64| 60.0 + (gap - 0.9) / 0.4 * 440.0;
    let y = |area: f64| 290.0 - (area - low) / (high - low) * 260.0;
    let mut svg = String::from(
        "<svg xmlns=\"http://www.w3.org/2000/svg\" viewBox=\"0 0 520 340\" width=\"520\" font-family=\"sans-serif\" \
         font-size=\"12\">\n<title>Two rings of radius 1: areas of the films, \
         and the proven range of the least area</title>\n\
         <rect width=\"520\" height=\"340\" fill=\"#fff\"/>\n",
    );
    for k in 0..=4 {
        let gap = 0.9 + 0.1 * f64::from(k);
        let at = x(gap);
        let _ = writeln!(svg, r##"<path d="M{at:.1} 30V290" stroke="#ddd"/>"##);
        let _ = writeln!(svg, r#"<text x="{at:.1}" y="306" text-anchor="middle">{gap:.1}</text>"#);
    }
    for k in 0..=4 {
        let area = 5.5 + 0.5 * f64::from(k);
        let at = y(area);
        let _ = writeln!(svg, r##"<path d="M60 {at:.1}H500" stroke="#ddd"/>"##);
        let _ = writeln!(svg, r#"<text x="52" y="{:.1}" text-anchor="end">{area:.1}</text>"#, at + 4.0);
    }
    let line = |points: &mut dyn Iterator<Item = [f64; 2]>| {
        let places: Vec<String> = points.map(|[gap, area]| format!("{:.1} {:.1}", x(gap), y(area))).collect();
        places.join("L")
    };
    let bottom = line(&mut proven.iter().map(|&[gap, bound, _]| [gap, bound]));
    let top = line(&mut proven.iter().rev().map(|&[gap, _, film]| [gap, film]));
    let _ = writeln!(svg, r##"<path d="M{bottom}L{top}Z" fill="#f4b183" stroke="none"/>"##);
    let _ = writeln!(svg, r##"<path d="M{bottom}" fill="none" stroke="#c55a11" stroke-width="1.5"/>"##);
    let smooth = line(&mut (0..=80).map(|k| 0.9 + 0.005 * f64::from(k)).map(|gap| [gap, catenoid(gap)]));
    let discs = line(&mut [[0.9, TAU], [1.3, TAU]].into_iter());
    for (path, colour) in [(smooth, "#2e75b6"), (discs, "#548235")] {
        let _ = writeln!(svg, r#"<path d="M{path}" fill="none" stroke="{colour}" stroke-width="1.5"/>"#);
    }
    for &[gap, bound, _] in proven {
        let _ = writeln!(svg, r##"<circle cx="{:.1}" cy="{:.1}" r="3" fill="#c55a11"/>"##, x(gap), y(bound));
    }
    for (text, at, colour) in [
        ("catenoid", [1.12, 7.05], "#2e75b6"),
        ("two discs", [0.91, 6.33], "#548235"),
        ("proven bound, and the range up to the better film", [1.03, 5.85], "#c55a11"),
    ] {
        let _ = writeln!(svg, r#"<text x="{:.1}" y="{:.1}" fill="{colour}">{text}</text>"#, x(at[0]), y(at[1]));
    }
    svg.push_str("<text x=\"280\" y=\"328\" text-anchor=\"middle\">gap of the rings</text>\n");
    svg.push_str("<text x=\"12\" y=\"20\">area</text>\n</svg>\n");
    svg
}

fn certify(loops: &[Vec<DVec3>], film: &MinimalSurface, seconds: f64) -> LowerBound {
    let options = lower_bound::Options::default().with_gap(1e-5).with_seconds(seconds);
    match lower_bound::certify(loops, &film.mesh, &options, &Execution::default()) {
        Ok(Some(bound)) => bound,
        Ok(None) | Err(_) => {
            eprintln!("no lower bound");
            std::process::exit(1);
        }
    }
}

fn gap(area: f64, bound: &LowerBound) -> String {
    format!("{:.3}%", 100.0 * (area / bound.area - 1.0))
}

fn cases() -> Vec<(&'static str, Vec<Vec<DVec3>>)> {
    let curve = |points: usize, at: &dyn Fn(f64) -> [f64; 3]| -> Vec<Vec<DVec3>> {
        vec![(0..points).map(|k| DVec3::from(at(TAU * k as f64 / points as f64))).collect()]
    };
    // Enneper's surface is stable up to radius 1. The larger the radius, the more its normal turns.
    let enneper = |radius: f64| {
        curve(96, &|t| {
            let (u, v) = (radius * t.cos(), radius * t.sin());
            [u - u.powi(3) / 3.0 + u * v * v, v - v.powi(3) / 3.0 + v * u * u, u * u - v * v]
        })
    };
    // A shear removes every plane of symmetry and changes little else.
    let sheared = |loops: Vec<Vec<DVec3>>| -> Vec<Vec<DVec3>> {
        let shear = |p: DVec3| p + DVec3::new(0.01 * p.y + 0.004 * p.z, 0.003 * p.z, 0.0);
        loops.iter().map(|points| points.iter().copied().map(shear).collect()).collect()
    };
    let trefoil = |t: f64| [t.sin() + 2.0 * (2.0 * t).sin(), t.cos() - 2.0 * (2.0 * t).cos(), -(3.0 * t).sin()];
    // A loop of two lobes with a narrow waist: its sides are a twentieth of the lobes' length apart.
    let nearly_touching = |t: f64| [1.5 * t.cos(), (0.05 + 0.6 * t.cos() * t.cos()) * t.sin(), 0.2 * (2.0 * t).sin()];
    vec![
        ("two rings of 48 points, gap 1", boundaries::rings(48, 1.0)),
        ("two rings of 96 points, gap 1", boundaries::rings(96, 1.0)),
        ("helicoid", vec![boundaries::helicoid()]),
        ("Scherk", vec![boundaries::scherk()]),
        ("skew quadrilateral", vec![boundaries::skew_quadrilateral(24)]),
        ("wavy loop", curve(96, &|t| [t.cos(), t.sin(), 0.2 * (3.0 * t).sin()])),
        ("Enneper, radius 0.5", enneper(0.5)),
        ("Enneper, radius 0.7", enneper(0.7)),
        ("Enneper, radius 0.8", enneper(0.8)),
        ("Enneper, radius 0.9", enneper(0.9)),
        ("Chen-Cai-Zheng's catenoid patch", vec![boundaries::catenoid()]),
        ("Enneper, radius 0.7, sheared", sheared(enneper(0.7))),
        ("Enneper, radius 0.9, sheared", sheared(enneper(0.9))),
        ("catenoid patch, sheared", sheared(vec![boundaries::catenoid()])),
        ("trefoil", curve(120, &trefoil)),
        ("loop that nearly touches itself", curve(120, &nearly_touching)),
    ]
}
