//! Liu and Wang's examples (their Figs. 6 to 9) by their formulas, beside Chen-Cai-Zheng's method and the default
//! solver.

use super::{Save, run};
use crate::picture::Picture;
use plateau_geometry::DVec3;
use plateau_geometry::minimal_surface::{
    InitialMesh, LiuWang, Method, MinimalSurface, Options, Resolution, VertexRelaxation,
};
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
}

fn relative(off: f64, coordinate: f64) -> f64 {
    if coordinate.abs() > 1.0 { off / coordinate.abs() } else { off }
}

fn cases() -> Vec<Case> {
    let mut cases = Vec::new();
    let b = 1.9;
    cases.push(Case {
        name: String::from("helicoid"),
        boundary: rim(|u, v| DVec3::new(u * v.cos(), u * v.sin(), b * v), [-2.0, 2.0], [-PI / 3.0, PI / 3.0], [7, 7]),
        interior: 20,
        error: Box::new(move |p| relative((p.y - p.x * (p.z / b).tan()).abs(), p.y)),
    });
    let b = 2.05;
    let catenoid = move |u: f64, v: f64| DVec3::new(b * u.cos() * v.cosh(), b * v, b * u.sin() * v.cosh());
    for (name, from, reach) in [("catenoid", PI / 6.0, 0.7), ("catenoid, smaller patch", PI / 4.0, 0.3)] {
        cases.push(Case {
            name: String::from(name),
            boundary: rim(catenoid, [from, PI - from], [-reach, reach], [6, 6]),
            interior: 25,
            error: Box::new(move |p| {
                let radius = b * (p.y / b).cosh();
                relative((p.z - (radius * radius - p.x * p.x).sqrt()).abs(), p.z)
            }),
        });
    }
    for b in [0.4, 1.0, 4.9] {
        for (sides, interior) in [(5, 16), (6, 20), (8, 30)] {
            let height = move |x: f64, y: f64| ((b * y).cos() / (b * x).cos()).ln() / b;
            let reach = 0.3 * PI / b;
            cases.push(Case {
                name: format!("Scherk b = {b}, {} + {interior}", 4 * sides),
                boundary: rim(|x, y| DVec3::new(x, y, height(x, y)), [-reach, reach], [-reach, reach], [sides, sides]),
                interior,
                error: Box::new(move |p| relative((p.z - height(p.x, p.y)).abs(), p.z)),
            });
        }
    }
    cases
}

pub fn run_all(save: Save) {
    println!(
        "| surface | theirs | interior vertices only | Chen-Cai-Zheng, ε = 0.01 | Chen-Cai-Zheng, 1e-6 | newton |"
    );
    println!("| --- | --- | --- | --- | --- | --- |");
    for case in cases() {
        let mean = |surface: &MinimalSurface| {
            let interior = &surface.mesh.vertices[case.boundary.len()..];
            interior.iter().map(|&p| (case.error)(p)).sum::<f64>() / interior.len() as f64
        };
        let options = |seed: u64| Options {
            initial_mesh: InitialMesh::Barycentres { seed },
            ..Options::new(Resolution::InteriorVertices(case.interior))
        };
        let least_squares = |seed: u64, boundary_curvature: bool| Options {
            method: Method::LiuWang(LiuWang { boundary_curvature, ..LiuWang::default() }),
            ..options(seed)
        };
        let relaxation = |seed, area_tolerance| Options {
            method: Method::VertexRelaxation(VertexRelaxation { area_tolerance, ..VertexRelaxation::default() }),
            ..options(seed)
        };
        // Chen, Cai, Zheng's own 0.01 is an area.
        let loose = 0.01 / run(std::slice::from_ref(&case.boundary), &options(1)).statistics.area;
        // The initial points influence the solution: the middle one of nine choices.
        let middle = |options: &dyn Fn(u64) -> Options| {
            let mut means: Vec<f64> =
                (1..=9).map(|seed| mean(&run(std::slice::from_ref(&case.boundary), &options(seed)))).collect();
            means.sort_by(f64::total_cmp);
            means[4]
        };
        println!(
            "| {} | {:.2e} | {:.2e} | {:.2e} | {:.2e} | {:.2e} |",
            case.name,
            middle(&|seed| least_squares(seed, true)),
            middle(&|seed| least_squares(seed, false)),
            middle(&|seed| relaxation(seed, loose)),
            middle(&|seed| relaxation(seed, 1e-6)),
            middle(&options),
        );
        if ["helicoid", "catenoid"].contains(&case.name.as_str()) {
            let once = LiuWang { tolerance: 1.0, boundary_curvature: false, ..LiuWang::default() };
            let start = Options { method: Method::LiuWang(once), max_iterations: Some(1), ..options(5) };
            let start = run(std::slice::from_ref(&case.boundary), &start).mesh;
            let theirs = run(std::slice::from_ref(&case.boundary), &least_squares(5, true)).mesh;
            let interior = run(std::slice::from_ref(&case.boundary), &least_squares(5, false)).mesh;
            save(
                &format!("liu_wang_{}", case.name),
                &[
                    Picture::shaded("one step", &start),
                    Picture::shaded("all vertices count", &theirs),
                    Picture::shaded("interior ones only", &interior),
                ],
            );
        }
    }
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
