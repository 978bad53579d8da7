//! Pictures of the films in Liu and Wang's Figs. 6, 7 and 9.

use super::{Save, run};
use crate::picture::Picture;
use plateau_mesh::DVec3;
use plateau_minimal_surface::{InitialMesh, LiuWang, Method, Options, Resolution};
use std::f64::consts::{PI, TAU};

fn rim(r: impl Fn(f64, f64) -> DVec3, [u0, u1]: [f64; 2], [v0, v1]: [f64; 2], [nu, nv]: [u32; 2]) -> Vec<DVec3> {
    let at = |a: f64, b: f64, k: u32, n: u32| a + (b - a) * f64::from(k) / f64::from(n);
    let bottom = (0..nu).map(|k| r(at(u0, u1, k, nu), v0));
    let right = (0..nv).map(|k| r(u1, at(v0, v1, k, nv)));
    let top = (0..nu).map(|k| r(at(u1, u0, k, nu), v1));
    let left = (0..nv).map(|k| r(u0, at(v1, v0, k, nv)));
    bottom.chain(right).chain(top).chain(left).collect()
}

/// Saves pictures of three films: after one step of the least squares, with the curvatures of the boundary vertices in
/// the sum, and with the curvatures of the interior vertices alone.
fn picture(save: Save, name: &str, boundary: Vec<DVec3>, interior: usize) {
    let options = |tolerance: f64, boundary_curvature: bool, max_iterations: Option<u32>| Options {
        method: Method::LiuWang(LiuWang { boundary_curvature, tolerance, ..LiuWang::default() }),
        initial_mesh: InitialMesh::Barycentres { seed: 5 },
        max_iterations,
        ..Options::new(Resolution::InteriorVertices(interior))
    };
    let boundary = [boundary];
    let start = run(&boundary, &options(1.0, false, Some(1))).mesh;
    let theirs = run(&boundary, &options(1e-6, true, None)).mesh;
    // Without the boundary vertices the objective is zero at its minimum.
    let interior = run(&boundary, &options(1e-15, false, None)).mesh;
    save(
        &format!("liu_wang_{name}"),
        &[
            Picture::shaded("one step", &start),
            Picture::shaded("all vertices count", &theirs),
            Picture::shaded("interior ones only", &interior),
        ],
    );
}

pub fn run_all(save: Save) {
    let b = 1.9;
    let helicoid = |u: f64, v: f64| DVec3::new(u * v.cos(), u * v.sin(), b * v);
    picture(save, "helicoid", rim(helicoid, [-2.0, 2.0], [-PI / 3.0, PI / 3.0], [7, 7]), 20);
    let b = 2.05;
    let catenoid = |u: f64, v: f64| DVec3::new(b * u.cos() * v.cosh(), b * v, b * u.sin() * v.cosh());
    picture(save, "catenoid", rim(catenoid, [PI / 6.0, 5.0 * PI / 6.0], [-0.7, 0.7], [6, 6]), 25);
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
    let pictures =
        [Picture::shaded("all vertices count", &theirs.mesh), Picture::shaded("interior ones only", &interior.mesh)];
    save("liu_wang_membrane", &pictures);
}
