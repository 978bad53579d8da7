//! Pictures of the films in Chen, Cai and Zheng's Figs. 4 and 6 to 9.

use super::{Save, boundaries, run};
use crate::picture::Picture;
use plateau_mesh::DVec3;
use plateau_minimal_surface::{
    BoundarySampling, InitialMesh, Method, MinimalSurface, Options, Process, Resolution, VertexRelaxation,
};
use std::f64::consts::TAU;

fn relax(triangles: usize, method: VertexRelaxation) -> Options {
    Options {
        method: Method::VertexRelaxation(method),
        initial_mesh: InitialMesh::Rings,
        boundary_sampling: BoundarySampling::Keep,
        ..Options::new(Resolution::Triangles(triangles))
    }
}

/// The mesh after step 1 of their method (with its edges swapped), after step 2, and after step 3.
fn steps(boundaries: &[Vec<DVec3>], triangles: usize, area_tolerance: f64) -> [MinimalSurface; 3] {
    let fairing = vec![vec![Process::LaplacianFairing, Process::EdgeSwapping]];
    let method = VertexRelaxation { area_tolerance, ..VertexRelaxation::default() };
    let options = relax(triangles, method.clone());
    [
        Options { max_iterations: Some(0), ..options.clone() },
        relax(triangles, VertexRelaxation { processes: Some(fairing), ..method }),
        options,
    ]
    .map(|options| run(boundaries, &options))
}

fn image<'a>(title: &str, surface: &'a MinimalSurface, red: f64) -> Picture<'a> {
    let title = format!("{title}, curvature, red {red:.1e}");
    Picture { title, mesh: &surface.mesh, figures: Some((&surface.mean_curvature, red)), translucent: false }
}

pub fn run_all(save: Save) {
    for (name, boundary, triangles) in
        [("helicoid", boundaries::helicoid(), 2050), ("catenoid", boundaries::catenoid(), 2040)]
    {
        let [first, second, third] = steps(&[boundary], triangles, 1e-6);
        // Both images have the same range of colours. Red is the curvature that nine tenths of the vertices do not
        // exceed after step 2.
        let mut sorted = second.mean_curvature.clone();
        sorted.sort_by(f64::total_cmp);
        let red = sorted[sorted.len() * 9 / 10];
        save(
            &format!("chen_cai_zheng_{name}"),
            &[Picture::shaded("step 1", &first.mesh), image("step 2", &second, red), image("step 3", &third, red)],
        );
    }
    levels(save);
    starts(save);
}

fn loop_of(points: u32, radius: f64, lobes: f64, height: f64) -> Vec<DVec3> {
    (0..points)
        .map(|k| TAU * f64::from(k) / f64::from(points))
        .map(|t| {
            let r = radius * (1.0 + 0.15 * (2.0 * t).cos());
            DVec3::new(r * t.cos(), r * t.sin(), height * (lobes * t).cos())
        })
        .collect()
}

/// The levels of detail of their Tables 1 and 2.
fn levels(save: Save) {
    for (name, boundary, counts) in [
        ("160 points", loop_of(160, 1.6, 3.0, 0.5), [800, 2400]),
        ("97 points", loop_of(97, 18.0, 2.0, 5.0), [485, 1455]),
    ] {
        let boundary = [boundary];
        let films = counts.map(|count| {
            let options = relax(count, VertexRelaxation { area_tolerance: 1e-9, ..VertexRelaxation::default() });
            (count, run(&boundary, &options))
        });
        let pictures: Vec<Picture> = films
            .iter()
            .map(|(count, surface)| Picture::shaded(format!("{name}, {count} triangles"), &surface.mesh))
            .collect();
        save(&format!("chen_cai_zheng_{}", name.replace(' ', "_")), &pictures);
    }
}

/// A boundary whose rings cross themselves (their Fig. 4), and two contours (Fig. 9).
fn starts(save: Save) {
    let banana: Vec<DVec3> = (0..96)
        .map(|k| TAU * f64::from(k) / 96.0)
        .map(|t| {
            let (angle, radius) = (2.4 * t.cos(), 3.0 + 0.7 * t.sin());
            DVec3::new(radius * angle.sin(), 0.4 * (2.0 * t).cos(), radius * angle.cos())
        })
        .collect();
    let mut upper = loop_of(72, 1.0, 2.0, 0.25);
    upper.iter_mut().for_each(|p| *p += DVec3::new(0.3, 0.0, 0.8));
    for (name, contours, triangles) in [
        ("crossing", vec![banana], 960),
        ("two_contours", vec![super::circle(72, 1.2, DVec3::ZERO, DVec3::Z), upper], 1152),
    ] {
        let [first, _, film] = steps(&contours, triangles, 1e-8);
        save(
            &format!("chen_cai_zheng_{name}"),
            &[Picture::shaded("initial mesh", &first.mesh), Picture::shaded("film", &film.mesh)],
        );
    }
}
