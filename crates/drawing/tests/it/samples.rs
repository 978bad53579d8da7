//! Stored results of ruled surfaces.

use plateau_archive::units::Unit;
use plateau_archive::{Archive, Contents, LineSet, Lines, Polyline};
use plateau_mesh::{DVec3, Execution};
use plateau_ruled_surface::{Caps, Objective, Options, solve};

/// Returns the result of a ruled surface between rails, in metres.
pub fn ruled(rails: &[Vec<DVec3>], options: &Options) -> Archive {
    let surface = solve(rails, options, &Execution::default()).unwrap();
    let rails = surface.directrices.iter().filter(|rail| rail.len() > 1);
    let rails = rails.map(|rail| Polyline { vertices: rail.clone(), closed: options.closed }).collect();
    let set = |name: &str, lines: Lines| LineSet { name: name.into(), group: String::new(), lines, attributes: vec![] };
    Archive::new(Contents {
        generator: "plateau test".into(),
        title: "ruled surface".into(),
        unit: Unit::Metre,
        mesh: surface.mesh,
        line_sets: vec![set("directrices", Lines::Polylines(rails)), set("bridges", Lines::Segments(surface.bridges))],
        statistics: "{}".into(),
        unrolls: true,
        ..Contents::default()
    })
    .unwrap()
}

/// Returns a regular polygon.
pub fn ring(count: usize, radius: f64, z: f64, turn: f64) -> Vec<DVec3> {
    let angle = |k: usize| std::f64::consts::TAU * (k as f64 + turn) / count as f64;
    (0..count).map(|k| DVec3::new(radius * angle(k).cos(), radius * angle(k).sin(), z)).collect()
}

/// Returns a rail with waves.
pub fn wavy(count: usize, y: f64, phase: f64) -> Vec<DVec3> {
    let point = |k: usize| {
        let u = k as f64 / (count - 1) as f64;
        DVec3::new(2.0 * u, y + 0.1 * (5.0 * u + phase).sin(), 0.2 * (6.0 * u + phase).cos())
    };
    (0..count).map(point).collect()
}

/// Returns open and closed stacks: of one and of two strips, with an apex, with caps, and one whose triangles are
/// turned over because the caps have to face outwards.
pub fn all() -> Vec<(&'static str, Archive)> {
    let bending = Options { objective: Objective::MinimalBendingEnergy, ..Options::default() };
    let closed = Options { closed: true, ..bending.clone() };
    let capped = Options { caps: Caps::Flat, ..closed.clone() };
    let duct = || {
        let rectangle = [[0.0, 0.0], [12.0, 0.0], [12.0, 5.0], [0.0, 5.0]];
        let rectangle = rectangle.map(|[x, y]| 0.1 * DVec3::new(x - 6.0, y - 2.5, 0.0)).to_vec();
        [rectangle, ring(16, 0.3, 1.0, 0.5)]
    };
    let reversed: Vec<Vec<DVec3>> = duct().into_iter().rev().collect();
    vec![
        ("wavy", ruled(&[wavy(13, 0.0, 0.0), wavy(9, 1.0, 0.7)], &bending)),
        ("stack", ruled(&[wavy(13, 0.0, 0.0), wavy(9, 1.0, 0.7), wavy(11, 2.0, 1.5)], &bending)),
        ("fan", ruled(&[vec![DVec3::new(1.0, -1.0, 0.5)], wavy(9, 1.0, 0.7)], &bending)),
        ("duct", ruled(&duct(), &closed)),
        ("capped duct", ruled(&duct(), &capped)),
        ("capped duct upside down", ruled(&reversed, &capped)),
        ("closed stack", ruled(&[ring(12, 0.5, 0.0, 0.0), ring(9, 0.7, 1.0, 0.3), ring(14, 0.4, 1.8, 0.1)], &closed)),
        ("cone", ruled(&[ring(12, 0.5, 0.0, 0.0), vec![DVec3::new(0.05, 0.0, 1.0)]], &closed)),
    ]
}
