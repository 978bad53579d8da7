//! Wang and Tang's experiments on our own stand-ins for their examples I to VI (they print no coordinates).
//!
//! - `cargo run --release -p plateau-ruled-surface --example wang_tang -- table` prints Table 1, every objective a row;
//! - `... -- request I` (to `VI`) prints the example as a request of the service (api/examples/).

#![allow(
    clippy::disallowed_macros,
    clippy::disallowed_methods,
    clippy::disallowed_types,
    clippy::too_many_lines,
    reason = "an example"
)]

use plateau_mesh::{DVec3, Execution};
use plateau_ruled_surface::{Comparison, Objective, Options, Secondary, solve};
use std::f64::consts::{PI, TAU};
use std::fmt::Write;

struct Example {
    name: &'static str,
    closed: bool,
    /// The objective that Wang and Tang's figure of this example shows.
    objective: Objective,
    secondary: Option<Secondary>,
    directrices: Vec<Vec<DVec3>>,
    normals: Option<Vec<Vec<DVec3>>>,
}

/// Points of a curve at equal steps of the parameter. Coordinates are rounded to six decimals, so that the printed
/// requests have the same numbers.
fn curve(count: usize, from: f64, to: f64, at: impl Fn(f64) -> [f64; 3]) -> Vec<DVec3> {
    (0..count)
        .map(|k| from + (to - from) * k as f64 / (count - 1) as f64)
        .map(|t| (DVec3::from_array(at(t)) * 1e6).round() / 1e6)
        .collect()
}

fn examples() -> Vec<Example> {
    let two = |p: Vec<DVec3>, q: Vec<DVec3>| vec![p, q];
    let outward = |count: usize, a: f64, b: f64| {
        curve(count, 0.0, TAU, |u| DVec3::new(u.cos() / a, u.sin() / b, 0.2).normalize().to_array())
    };
    let flange = |above: f64| {
        curve(140, 0.0, 1.0, move |t| {
            let c = DVec3::new(8.0 * t, 2.0 * (TAU * t).sin() + (5.0 * PI * t).cos(), 0.5 * (3.0 * PI * t).sin());
            (c + above * DVec3::new(0.4 * (4.0 * t).sin(), 0.3 * (6.0 * t).cos(), 1.0).normalize()).to_array()
        })
    };
    vec![
        Example {
            name: "I",
            closed: false,
            objective: Objective::MinimalArea,
            secondary: None,
            directrices: two(
                curve(60, 0.0, 1.0, |t| [10.0 * t, 0.8 * (TAU * t).sin(), 0.6 * (3.0 * PI * t).cos()]),
                curve(60, 0.0, 1.0, |t| [10.0 * t, 4.0 + 0.5 * (3.0 * PI * t).sin(), 0.8 * (2.5 * PI * t).sin()]),
            ),
            normals: None,
        },
        Example {
            name: "II",
            closed: false,
            objective: Objective::MaximalConvexity,
            secondary: Some(Secondary::BendingEnergy),
            directrices: two(
                curve(134, 0.0, 1.0, |t| [14.0 * t, 1.5 * (6.0 * PI * t).sin(), 1.2 * (5.0 * PI * t).cos()]),
                curve(134, 0.0, 1.0, |t| [14.0 * t, 5.0 + 1.2 * (TAU * t + 1.0).sin(), 1.6 * (7.0 * PI * t).sin()]),
            ),
            normals: None,
        },
        Example {
            name: "III",
            closed: false,
            objective: Objective::MinimalBendingEnergy,
            secondary: None,
            directrices: two(
                curve(251, 0.0, 6.0 * PI, |t| [t.cos(), t.sin(), 0.25 * t + 0.05 * (3.0 * t).sin()]),
                curve(251, 0.0, 6.0 * PI, |t| {
                    [1.1 * (t + 0.4).cos(), 1.1 * (t + 0.4).sin(), 0.25 * t + 0.6 + 0.1 * (2.0 * t).sin()]
                }),
            ),
            normals: None,
        },
        Example {
            name: "IV",
            closed: false,
            objective: Objective::MaximalConvexity,
            secondary: Some(Secondary::BendingEnergy),
            directrices: two(
                curve(193, 0.0, PI, |t| [t.cos(), t.sin(), 0.0]),
                curve(193, 0.0, PI, |t| {
                    let radius = 1.02 + 0.008 * (16.0 * t).sin();
                    [radius * t.cos(), radius * t.sin(), -0.05 + 0.01 * (16.0 * t).cos()]
                }),
            ),
            normals: None,
        },
        Example {
            name: "V",
            closed: false,
            objective: Objective::MinimalNormalVariation,
            secondary: None,
            directrices: two(
                curve(111, 0.0, TAU, |t| [3.0 * t.cos(), 2.0 * t.sin(), 0.1 * (2.0 * t).sin()]),
                curve(111, 0.0, TAU, |t| [2.4 * t.cos(), 1.8 * t.sin(), 2.0 + 0.3 * (3.0 * t).cos()]),
            ),
            normals: Some(vec![outward(111, 3.0, 2.0), outward(111, 2.4, 1.8)]),
        },
        Example {
            name: "VI",
            closed: false,
            objective: Objective::MinimalBendingEnergy,
            secondary: None,
            directrices: two(flange(0.0), flange(0.7)),
            normals: None,
        },
    ]
}

fn label(row: &Comparison) -> String {
    let name = row.objective.name().replace('_', " ");
    match row.secondary {
        Some(secondary) => format!("{name} + {}", secondary.name().replace('_', " ")),
        None => name,
    }
}

fn table() -> String {
    let mut text = String::from(
        "| example | objective | area | normal twist | convex bridges | bending energy \
         | curvature variation | normal variation |\n\
         | --- | --- | --- | --- | --- | --- | --- | --- |\n",
    );
    for example in examples() {
        let options = Options {
            closed: example.closed,
            all_objectives: true,
            normals: example.normals.clone(),
            ..Options::default()
        };
        let surface = solve(&example.directrices, &options, &Execution::default()).expect("the examples can be solved");
        for row in surface.comparison.expect("the comparison was asked for") {
            let s = row.statistics;
            let variation = s.normal_variation.map_or_else(|| "N/A".to_owned(), |v| format!("{v:.2}"));
            writeln!(
                text,
                "| {} | {} | {:.2} | {:.2} | {}/{} | {:.2} | {:.2} | {variation} |",
                example.name,
                label(&row),
                s.area,
                s.total_normal_twist,
                s.convex_bridges,
                s.bridges,
                s.bending_energy,
                s.mean_curvature_variation,
            )
            .expect("writing to a string");
        }
    }
    text
}

fn request(name: &str) -> Option<String> {
    let example = examples().into_iter().find(|example| example.name == name)?;
    let lists = |lists: &[Vec<DVec3>]| {
        let list = |points: &Vec<DVec3>| {
            let points: Vec<String> = points.iter().map(|p| format!("[{}, {}, {}]", p.x, p.y, p.z)).collect();
            format!("[{}]", points.join(", "))
        };
        format!("[{}]", lists.iter().map(list).collect::<Vec<_>>().join(", "))
    };
    let secondary = example.secondary.map_or_else(|| "null".to_owned(), |s| format!("\"{}\"", s.name()));
    let normals = example.normals.as_deref().map_or_else(String::new, |n| format!(", \"normals\": {}", lists(n)));
    Some(format!(
        "{{\"kind\": \"ruled_surface\", \"objective\": \"{}\", \"secondary_objective\": {secondary}, \"closed\": {}, \
         \"all_objectives\": true, \"directrices\": {}{normals}}}\n",
        example.objective.name(),
        example.closed,
        lists(&example.directrices),
    ))
}

fn main() {
    let arguments: Vec<String> = std::env::args().skip(1).collect();
    let text = match arguments.iter().map(String::as_str).collect::<Vec<_>>()[..] {
        ["table"] => Some(table()),
        ["request", name] => request(name),
        _ => None,
    };
    match text {
        Some(text) => print!("{text}"),
        None => {
            eprintln!("usage: wang_tang table | request I..VI");
            std::process::exit(2);
        }
    }
}
