//! Pictures and a table of three half-discs between the poles of a sphere, which meet along a curve.

use super::{Save, run};
use crate::picture::Picture;
use plateau_mesh::{DVec3, Mesh};
use plateau_minimal_surface::{InitialMesh, Options, Resolution};
use std::f64::consts::PI;

fn half_discs(azimuths_deg: [f64; 3], m: usize, n: usize, bend: DVec3) -> (Vec<Vec<DVec3>>, Mesh) {
    let angle = |i: usize| PI * i as f64 / m as f64;
    let on_wire = |azimuth: f64, i: usize| match i {
        0 => DVec3::Z,
        i if i == m => -DVec3::Z,
        i => DVec3::new(angle(i).sin() * azimuth.cos(), angle(i).sin() * azimuth.sin(), angle(i).cos()),
    };
    let axis = |i: usize| DVec3::Z * angle(i).cos() + bend * angle(i).sin();
    let mut vertices = vec![DVec3::Z, -DVec3::Z];
    vertices.extend((1..m).map(axis));
    let mut triangles = Vec::new();
    for azimuth in azimuths_deg.map(f64::to_radians) {
        let begin = vertices.len();
        for i in 1..m {
            vertices.extend((1..=n).map(|j| match j {
                j if j == n => on_wire(azimuth, i),
                j => axis(i).lerp(on_wire(azimuth, i), j as f64 / n as f64),
            }));
        }
        let at = |i: usize, j: usize| match (i, j) {
            (0, _) => 0,
            (i, _) if i == m => 1,
            (i, 0) => (1 + i) as u32,
            (i, j) => (begin + (i - 1) * n + j - 1) as u32,
        };
        for j in 0..n {
            triangles.push([at(0, 0), at(1, j), at(1, j + 1)]);
            triangles.push([at(m, 0), at(m - 1, j + 1), at(m - 1, j)]);
            for i in 1..m - 1 {
                triangles.push([at(i, j), at(i + 1, j), at(i + 1, j + 1)]);
                triangles.push([at(i, j), at(i + 1, j + 1), at(i, j + 1)]);
            }
        }
    }
    let loops = [0, 1]
        .map(|k| {
            let down = (0..m).map(|i| on_wire(azimuths_deg[k].to_radians(), i));
            let up = (1..=m).rev().map(|i| on_wire(azimuths_deg[k + 1].to_radians(), i));
            down.chain(up).collect()
        })
        .to_vec();
    (loops, Mesh::new(vertices, triangles))
}

pub fn run_all(save: Save) {
    println!(
        "\n| wires apart | segments | area / R² | 3π/2 - area / R² | junction length / R \
         | departure from 120°, degrees: largest, next to the poles, mean | facets, degrees | residuals |"
    );
    println!("| --- | --- | --- | --- | --- | --- | --- | --- |");
    let mut meshes = Vec::new();
    for (azimuths, bend) in
        [([0.0, 120.0, 240.0], DVec3::new(0.3, -0.2, 0.0)), ([0.0, 100.0, 220.0], DVec3::new(0.2, 0.1, 0.0))]
    {
        for (m, n) in [(12, 4), (24, 8), (48, 16), (96, 32)] {
            let (loops, mesh) = half_discs(azimuths, m, n, bend);
            let options = Options {
                initial_mesh: InitialMesh::Given(mesh.clone()),
                tolerance: 1e-8,
                ..Options::new(Resolution::Triangles(1))
            };
            let surface = run(&loops, &options);
            if let Some(junctions) = &surface.statistics.junctions {
                println!(
                    "| {}° {}° {}° | {m} | {:.6} | {:.6} | {:.6} | {:.1e}, {:.1e}, {:.1e} \
                     | {:.2} to {:.2} | {:.0e}, {:.0e} |",
                    azimuths[1] - azimuths[0],
                    azimuths[2] - azimuths[1],
                    360.0 - azimuths[2],
                    surface.statistics.area,
                    1.5 * PI - surface.statistics.area,
                    junctions.length,
                    junctions.largest_deviation.to_degrees(),
                    junctions.largest_deviation_at_ends.to_degrees(),
                    junctions.mean_deviation.to_degrees(),
                    junctions.facet_angles.min.to_degrees(),
                    junctions.facet_angles.max.to_degrees(),
                    surface.statistics.residual,
                    junctions.residual,
                );
            }
            if m == 12 {
                // The mesh is rotated so that the far sheet is visible.
                let turned = |mut mesh: Mesh| {
                    mesh.vertices.iter_mut().for_each(|vertex| *vertex = vertex.rotate_z(0.55));
                    mesh
                };
                meshes.extend([turned(mesh), turned(surface.mesh)]);
            }
        }
    }
    let titles = ["start, 120° apart", "film", "start, 100° 120° 140°", "film"];
    let pictures: Vec<Picture> = titles
        .into_iter()
        .zip(&meshes)
        .map(|(t, mesh)| Picture { translucent: true, ..Picture::shaded(t, mesh) })
        .collect();
    save("triple_junctions", &pictures);
}
