//! Liu and Wang's examples (their Figs. 6 to 9) by their formulas, beside Chen-Cai-Zheng's method and the default
//! solver.

use super::{Save, run};
use crate::picture::Picture;
use plateau_film::minimal_surface::{
    InitialMesh, LiuWang, Method, MinimalSurface, Options, Process, Resolution, VertexRelaxation,
};
use plateau_mesh::DVec3;
use std::f64::consts::{PI, TAU};

fn rim(r: impl Fn(f64, f64) -> DVec3, [u0, u1]: [f64; 2], [v0, v1]: [f64; 2], [nu, nv]: [u32; 2]) -> Vec<DVec3> {
    let at = |a: f64, b: f64, k: u32, n: u32| a + (b - a) * f64::from(k) / f64::from(n);
    let bottom = (0..nu).map(|k| r(at(u0, u1, k, nu), v0));
    let right = (0..nv).map(|k| r(u1, at(v0, v1, k, nv)));
    let top = (0..nu).map(|k| r(at(u1, u0, k, nu), v1));
    let left = (0..nv).map(|k| r(u0, at(v1, v0, k, nv)));
    bottom.chain(right).chain(top).chain(left).collect()
}

/// A boundary, its interior points, and the paper's measure of a point's error.
struct Case {
    name: String,
    boundary: Vec<DVec3>,
    interior: usize,
    error: Box<dyn Fn(DVec3) -> f64>,
    /// The paper's own mean errors, of its method and of its Chen-Cai-Zheng, where it prints them.
    printed: Option<[f64; 2]>,
}

fn relative(off: f64, coordinate: f64) -> f64 {
    if coordinate.abs() > 1.0 { off / coordinate.abs() } else { off }
}

/// Their Figs. 6 and 7: a helicoid and a catenoid, on ranges of ours. The first of each are those on which their ratios
/// appear.
fn surfaces() -> Vec<Case> {
    let mut cases = Vec::new();
    let b = 1.9;
    for (name, [from, to], turn) in [
        ("helicoid, u 0.5..2, v ±π/3", [0.5, 2.0], PI / 3.0),
        ("helicoid, u ±2, v ±π/3", [-2.0, 2.0], PI / 3.0),
        ("helicoid, u 0.5..2, v ±π/6", [0.5, 2.0], PI / 6.0),
    ] {
        cases.push(Case {
            name: String::from(name),
            boundary: rim(|u, v| DVec3::new(u * v.cos(), u * v.sin(), b * v), [from, to], [-turn, turn], [7, 7]),
            interior: 20,
            error: Box::new(move |p| relative((p.y - p.x * (p.z / b).tan()).abs(), p.y)),
            printed: Some([2.941e-3, 4.110e-3]),
        });
    }
    let b = 2.05;
    let catenoid = move |u: f64, v: f64| DVec3::new(b * u.cos() * v.cosh(), b * v, b * u.sin() * v.cosh());
    for (name, from, reach) in [
        ("catenoid, u π/4..3π/4, v ±0.4", PI / 4.0, 0.4),
        ("catenoid, u π/4..3π/4, v ±0.3", PI / 4.0, 0.3),
        ("catenoid, u π/6..5π/6, v ±0.7", PI / 6.0, 0.7),
    ] {
        cases.push(Case {
            name: String::from(name),
            boundary: rim(catenoid, [from, PI - from], [-reach, reach], [6, 6]),
            interior: 25,
            error: Box::new(move |p| {
                let radius = b * (p.y / b).cosh();
                relative((p.z - (radius * radius - p.x * p.x).sqrt()).abs(), p.z)
            }),
            printed: Some([9.192e-4, 1.412e-3]),
        });
    }
    cases
}

/// Their Fig. 8: nine sets of points on Scherk's surface, over |x|, |y| <= 0.3 π/b.
fn scherk() -> Vec<Case> {
    let mut cases = Vec::new();
    for b in [0.4, 1.0, 4.9] {
        for (sides, interior) in [(5, 16), (6, 20), (8, 30)] {
            let height = move |x: f64, y: f64| ((b * y).cos() / (b * x).cos()).ln() / b;
            let reach = 0.3 * PI / b;
            cases.push(Case {
                name: format!("Scherk b = {b}, {} + {interior}", 4 * sides),
                boundary: rim(|x, y| DVec3::new(x, y, height(x, y)), [-reach, reach], [-reach, reach], [sides, sides]),
                interior,
                error: Box::new(move |p| relative((p.z - height(p.x, p.y)).abs(), p.z)),
                printed: None,
            });
        }
    }
    cases
}

/// Prints a row for each case: mean errors, the middle one of nine seeded choices of interior points, because the
/// points influence the solution.
fn table(cases: &[Case], save: Option<Save>) {
    println!(
        "| surface | least squares | area, to 1e-4 | ratio | area, to 1e-9 | ratio | theirs | all rows | \
         Chen-Cai-Zheng | newton |"
    );
    println!("| --- | --- | --- | --- | --- | --- | --- | --- | --- | --- |");
    for case in cases {
        let mean = |surface: &MinimalSurface| {
            let interior = &surface.mesh.vertices[case.boundary.len()..];
            interior.iter().map(|&p| (case.error)(p)).sum::<f64>() / interior.len() as f64
        };
        let options = |seed: u64| Options {
            initial_mesh: InitialMesh::Barycentres { seed },
            ..Options::new(Resolution::InteriorVertices(case.interior))
        };
        let least_squares = |seed: u64, boundary_curvature: bool| Options {
            method: Method::LiuWang(LiuWang {
                boundary_curvature,
                // Without the boundary the objective vanishes at its minimum.
                tolerance: if boundary_curvature { 1e-6 } else { 1e-15 },
                ..LiuWang::default()
            }),
            ..options(seed)
        };
        let relaxation = |seed, area_tolerance, processes| Options {
            method: Method::VertexRelaxation(VertexRelaxation {
                area_tolerance,
                processes,
                ..VertexRelaxation::default()
            }),
            ..options(seed)
        };
        let area_alone = || Some(vec![vec![Process::AreaMinimising]]);
        let middle = |options: &dyn Fn(u64) -> Options| {
            let mut means: Vec<f64> =
                (1..=9).map(|seed| mean(&run(std::slice::from_ref(&case.boundary), &options(seed)))).collect();
            means.sort_by(f64::total_cmp);
            means[4]
        };
        let own = middle(&|seed| least_squares(seed, false));
        let [loose, area] = [1e-4, 1e-9].map(|tolerance| middle(&|seed| relaxation(seed, tolerance, area_alone())));
        let theirs = case.printed.map_or(String::new(), |[own, area]| format!("{:.3}", own / area));
        println!(
            "| {} | {own:.2e} | {loose:.2e} | {:.2} | {area:.2e} | {:.2} | {theirs} | {:.2e} | {:.2e} | {:.2e} |",
            case.name,
            own / loose,
            own / area,
            middle(&|seed| least_squares(seed, true)),
            middle(&|seed| relaxation(seed, 1e-6, None)),
            middle(&options),
        );
        let picture = [("helicoid, u ±2", "helicoid"), ("catenoid, u π/6", "catenoid")]
            .into_iter()
            .find(|(start, _)| case.name.starts_with(start));
        if let (Some(save), Some((_, name))) = (save, picture) {
            let once = LiuWang { tolerance: 1.0, boundary_curvature: false, ..LiuWang::default() };
            let start = Options { method: Method::LiuWang(once), max_iterations: Some(1), ..options(5) };
            let start = run(std::slice::from_ref(&case.boundary), &start).mesh;
            let theirs = run(std::slice::from_ref(&case.boundary), &least_squares(5, true)).mesh;
            let interior = run(std::slice::from_ref(&case.boundary), &least_squares(5, false)).mesh;
            save(
                &format!("liu_wang_{name}"),
                &[
                    Picture::shaded("one step", &start),
                    Picture::shaded("all vertices count", &theirs),
                    Picture::shaded("interior ones only", &interior),
                ],
            );
        }
    }
}

pub fn run_all(save: Save) {
    table(&surfaces(), Some(save));
    table(&scherk(), None);
    let membrane: Vec<DVec3> = (0..9)
        .map(|k| {
            let t = f64::from(k) * TAU / 9.0;
            let (reach, height) = if k % 3 == 0 { (5.0, 2.0) } else { (3.5, 0.0) };
            DVec3::new(reach * t.cos(), reach * t.sin(), height)
        })
        .collect();
    let options = |boundary_curvature| Options {
        method: Method::LiuWang(LiuWang { boundary_curvature, ..LiuWang::default() }),
        ..Options::new(Resolution::InteriorVertices(4))
    };
    let [theirs, interior] = [true, false].map(|all| run(std::slice::from_ref(&membrane), &options(all)));
    for (name, surface) in [("all vertices", &theirs), ("interior only", &interior)] {
        println!("membrane, {name}: mean of the mean curvatures {:.2e}", surface.statistics.mean_curvature.mean);
    }
    let pictures =
        [Picture::shaded("all vertices count", &theirs.mesh), Picture::shaded("interior ones only", &interior.mesh)];
    save("liu_wang_membrane", &pictures);
}
