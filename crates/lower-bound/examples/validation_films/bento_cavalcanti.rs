//! Pictures of the films in Bento and Cavalcanti's Figs. 6 to 9. Fig. 8 is solved without their rules.

use super::{Save, rings, run};
use crate::picture::Picture;
use plateau_mesh::{DVec3, Mesh};
use plateau_minimal_surface::{InitialMesh, Method, Options, PinkallPolthier, Resolution};
use std::f64::consts::TAU;

pub fn run_all(save: Save) {
    for (name, height, degenerate_angle, steps) in [
        ("bento_cavalcanti_6", 12.0, Some(1f64.to_radians()), [1, 3, 6, 200]),
        ("bento_cavalcanti_7", 14.0, Some(1f64.to_radians()), [8, 16, 20, 200]),
        ("bento_cavalcanti_8", 14.0, None, [8, 16, 20, 200]),
    ] {
        let options = |steps| Options {
            method: Method::PinkallPolthier(PinkallPolthier {
                area_tolerance: if degenerate_angle.is_none() { 0.0 } else { 1e-6 },
                degenerate_angle,
                cut_necks: true,
                ..PinkallPolthier::default()
            }),
            initial_mesh: InitialMesh::Rings,
            tolerance: 0.0,
            max_iterations: Some(steps),
            ..Options::new(Resolution::Triangles(576))
        };
        let meshes = steps.map(|steps| run(&rings(&[0.0, height]), &options(steps)).mesh);
        save(name, &pictures(steps, &meshes));
    }
    let (boundary, mesh) = cut_cylinder(24, 4, 16.0, 0.2);
    let steps = [1, 8, 16, 200];
    let meshes = steps.map(|steps| {
        let options = Options {
            method: Method::PinkallPolthier(PinkallPolthier { cut_necks: true, ..PinkallPolthier::default() }),
            initial_mesh: InitialMesh::Given(mesh.clone()),
            max_iterations: Some(steps),
            ..Options::new(Resolution::Triangles(1))
        };
        run(std::slice::from_ref(&boundary), &options).mesh
    });
    save("bento_cavalcanti_9", &pictures(steps, &meshes));
}

/// Makes the pictures of the films after these numbers of steps. A run ends after 200 steps at the latest.
fn pictures(steps: [u32; 4], meshes: &[Mesh; 4]) -> Vec<Picture<'_>> {
    let title = |steps| if steps == 200 { String::from("end") } else { format!("step {steps}") };
    steps.into_iter().zip(meshes).map(|(steps, mesh)| Picture::shaded(title(steps), mesh)).collect()
}

/// A cylinder that is cut along a line and opened by an angle. Returns its only boundary loop, and its mesh.
fn cut_cylinder(n: u32, strips: u32, height: f64, opening: f64) -> (Vec<DVec3>, Mesh) {
    let at = |i: u32, j: u32| i * (strips + 1) + j;
    let point = |i: u32, j: u32| {
        let angle = 0.5 * opening + (TAU - opening) * f64::from(i) / f64::from(n);
        DVec3::new(10.0 * angle.cos(), 10.0 * angle.sin(), height * f64::from(j) / f64::from(strips))
    };
    let vertices = (0..=n).flat_map(|i| (0..=strips).map(move |j| point(i, j))).collect();
    let cells = (0..n).flat_map(|i| (0..strips).map(move |j| (i, j)));
    let triangles = cells
        .flat_map(|(i, j)| [[at(i, j), at(i + 1, j), at(i + 1, j + 1)], [at(i, j), at(i + 1, j + 1), at(i, j + 1)]])
        .collect();
    let boundary = (0..n)
        .map(|i| point(i, 0))
        .chain((0..strips).map(|j| point(n, j)))
        .chain((1..=n).rev().map(|i| point(i, strips)))
        .chain((1..=strips).rev().map(|j| point(0, j)))
        .collect();
    (boundary, Mesh::new(vertices, triangles))
}
