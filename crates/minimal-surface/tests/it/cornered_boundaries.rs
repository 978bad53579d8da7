//! Smallest angles of films over boundaries with corners, including re-entrant corners, from coarse to fine meshes. The
//! angles must not become smaller as the resolution becomes finer.
//!
//! All corners of these boundaries turn by less than 130 degrees in space, so that each leaves room for angles of 20
//! degrees. With `PLATEAU_LONG=1` the resolutions go up to 768,000 triangles. The table is printed.

use plateau_mesh::{DVec3, Execution, Mesh};
use plateau_minimal_surface::{MinimalSurface, Options, Resolution, solve};

fn corners(points: &[[f64; 3]]) -> Vec<DVec3> {
    points.iter().map(|&point| DVec3::from_array(point)).collect()
}

/// A loop around the z axis. Each point is given by its angle in degrees, its distance from the axis and its height.
fn around(points: impl Iterator<Item = (f64, f64, f64)>) -> Vec<DVec3> {
    points
        .map(|(degrees, radius, height)| {
            let (sine, cosine) = degrees.to_radians().sin_cos();
            DVec3::new(radius * cosine, radius * sine, height)
        })
        .collect()
}

fn boundaries() -> [(&'static str, Vec<Vec<DVec3>>); 10] {
    let t_roof = corners(&[
        [0.0, 2.0, 0.0],
        [0.0, 3.0, 1.0],
        [3.0, 3.0, 0.0],
        [3.0, 2.0, 1.0],
        [2.0, 2.0, 0.2],
        [2.0, 0.0, 0.0],
        [1.0, 0.0, 1.0],
        [1.0, 2.0, 0.8],
    ]);
    let l = corners(&[
        [0.0, 0.0, 0.0],
        [2.0, 0.0, 0.3],
        [2.0, 1.0, 0.0],
        [1.0, 1.0, 0.5],
        [1.0, 2.0, 0.0],
        [0.0, 2.0, 0.4],
    ]);
    let u = corners(&[
        [0.0, 0.0, 0.0],
        [3.0, 0.0, 0.5],
        [3.0, 2.0, 0.0],
        [2.0, 2.0, 0.4],
        [2.0, 1.0, -0.2],
        [1.0, 1.0, 0.3],
        [1.0, 2.0, 0.0],
        [0.0, 2.0, 0.5],
    ]);
    let cross = corners(&[
        [1.0, 0.0, 0.0],
        [2.0, 0.0, 0.4],
        [2.0, 1.0, 0.0],
        [3.0, 1.0, 0.4],
        [3.0, 2.0, 0.0],
        [2.0, 2.0, 0.4],
        [2.0, 3.0, 0.0],
        [1.0, 3.0, 0.4],
        [1.0, 2.0, 0.0],
        [0.0, 2.0, 0.4],
        [0.0, 1.0, 0.0],
        [1.0, 1.0, 0.4],
    ]);
    let star = around((0..10).map(|k| {
        let inner = f64::from(k % 2);
        (36.0 * f64::from(k), 2.0 - inner, 0.5 * inner)
    }));
    let notch = corners(&[
        [0.0, 0.0, 0.0],
        [4.0, 0.0, 0.5],
        [4.0, 3.0, 0.0],
        [3.0, 3.0, 0.4],
        [2.0, 1.5, 0.0],
        [1.0, 3.0, 0.3],
        [0.0, 3.0, 0.0],
    ]);
    let s = corners(&[
        [0.0, 0.0, 0.0],
        [2.0, 0.0, 0.5],
        [2.0, 1.0, 0.0],
        [3.0, 1.0, 0.4],
        [3.0, 3.0, 0.0],
        [1.0, 3.0, 0.6],
        [1.0, 2.0, 0.0],
        [0.0, 2.0, 0.3],
    ]);
    let cube = corners(&[
        [1.0, 0.0, 0.0],
        [1.0, 1.0, 0.0],
        [0.0, 1.0, 0.0],
        [0.0, 1.0, 1.0],
        [0.0, 0.0, 1.0],
        [1.0, 0.0, 1.0],
    ]);
    let square =
        |half: f64, height: f64| around((0..4).map(|k| (45.0 + 90.0 * f64::from(k), half * 2f64.sqrt(), height)));
    let stairs = corners(&[
        [0.0, 0.0, 0.0],
        [4.0, 0.0, 0.0],
        [4.0, 4.0, 1.0],
        [3.0, 4.0, 0.5],
        [3.0, 3.0, 1.0],
        [2.0, 3.0, 0.5],
        [2.0, 2.0, 1.0],
        [1.0, 2.0, 0.5],
        [1.0, 1.0, 1.0],
        [0.0, 1.0, 0.5],
    ]);
    [
        ("T", vec![t_roof]),
        ("L", vec![l]),
        ("U", vec![u]),
        ("cross", vec![cross]),
        ("star", vec![star]),
        ("notch", vec![notch]),
        ("S", vec![s]),
        ("cube's hexagon", vec![cube]),
        ("square with a raised hole", vec![square(2.0, 0.0), square(0.8, 0.6)]),
        ("stairs", vec![stairs]),
    ]
}

fn smallest_angle_deg(mesh: &Mesh) -> f64 {
    let at = |a: DVec3, b: DVec3, c: DVec3| (b - a).angle_between(c - a).to_degrees();
    let least = |t: &[u32; 3]| {
        let [a, b, c] = t.map(|v| mesh.vertices[v as usize]);
        at(a, b, c).min(at(b, c, a)).min(at(c, a, b))
    };
    mesh.triangles.iter().map(least).fold(f64::INFINITY, f64::min)
}

fn film(loops: &[Vec<DVec3>], triangles: usize) -> MinimalSurface {
    solve(loops, &Options::new(Resolution::Triangles(triangles)), &Execution::default()).unwrap()
}

#[test]
fn no_angle_falls_below_20_degrees_at_any_resolution() {
    let long = std::env::var_os("PLATEAU_LONG").is_some();
    let resolutions: &[usize] = match (long, crate::is_full()) {
        (true, _) => &[3_000, 12_000, 48_000, 192_000, 768_000],
        (false, true) => &[3_000, 12_000, 48_000],
        (false, false) => &[3_000, 12_000],
    };
    let mut narrow = Vec::new();
    for (name, loops) in boundaries() {
        for &count in resolutions {
            let start = std::time::Instant::now();
            let film = film(&loops, count);
            let seconds = start.elapsed().as_secs_f64();
            let (statistics, angle) = (&film.statistics, smallest_angle_deg(&film.mesh));
            let extrapolated = statistics
                .extrapolated_area
                .map_or("none".to_owned(), |e| format!("{:.6} ± {:.1e}", e.area, e.error_estimate));
            println!(
                "| {name} | {count} | {} | {angle:.1}° | {:.6} | {extrapolated} | {} | {seconds:.2} s |",
                film.mesh.triangles.len(),
                statistics.area,
                statistics.converged
            );
            let missed = (film.mesh.triangles.len() as f64 / count as f64 - 1.0).abs();
            if angle < 20.0 || !statistics.converged || missed > 0.1 {
                narrow.push(format!(
                    "{name} at {count}: {angle:.2}, converged {}, {missed:.3} off",
                    statistics.converged
                ));
            }
        }
    }
    assert!(narrow.is_empty(), "{narrow:#?}");
}
