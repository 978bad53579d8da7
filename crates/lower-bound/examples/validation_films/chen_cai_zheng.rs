//! Chen, Cai, Zheng's Figs. 4 and 6 to 9 and their Tables 1 and 2.

use super::{Save, boundaries, run};
use crate::picture::Picture;
use plateau_film::minimal_surface::{
    BoundarySampling, InitialMesh, Method, MinimalSurface, Options, Process, Resolution, Statistics, VertexRelaxation,
};
use plateau_mesh::DVec3;
use std::f64::consts::TAU;

fn relax(triangles: usize, method: VertexRelaxation) -> Options {
    Options {
        method: Method::VertexRelaxation(method),
        initial_mesh: InitialMesh::Rings,
        boundary_sampling: BoundarySampling::Keep,
        ..Options::new(Resolution::Triangles(triangles))
    }
}

/// The mesh after step 1 (with its edges swapped), after step 2 and after step 3.
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

/// Sweeps in a phase of that name.
fn sweeps(statistics: &Statistics, phase: &str) -> u32 {
    let rows = || statistics.history.iter().map(|row| (row.phase == phase, row.iteration));
    let last = rows().filter(|row| row.0).map(|row| row.1).max().unwrap_or(0);
    let before = rows().filter(|row| !row.0 && row.1 < last).map(|row| row.1).max().unwrap_or(0);
    last - before.min(last)
}

/// The curvature that the paper prints: over the whole ring's area, a third of ours.
fn theirs(surface: &MinimalSurface) -> f64 {
    surface.statistics.mean_curvature.max / 3.0
}

fn image<'a>(title: &str, surface: &'a MinimalSurface, red: f64) -> Picture<'a> {
    let title = format!("{title}, curvature, red {red:.1e}");
    Picture { title, mesh: &surface.mesh, figures: Some((&surface.mean_curvature, red)), translucent: false }
}

pub fn run_all(save: Save) {
    println!(
        "| surface | ε₁ = ε₂ | area after step 1 | step 2: area, sweeps, largest curvature | step 3 \
         | limit of the polygon | theirs after step 2, 3 |"
    );
    println!("| --- | --- | --- | --- | --- | --- | --- |");
    for (name, boundary, triangles, limit, printed) in [
        ("helicoid", boundaries::helicoid(), 2050, 535.0748, "536.17, 0.1; 536.07, 0.0007"),
        ("catenoid", boundaries::catenoid(), 2040, 58.1637, "58.95, 0.23; 58.2, 0.004"),
    ] {
        // Their 0.01 is an area, our tolerances are parts of the area.
        for (tolerance, shown) in [(0.01 / limit, "0.01"), (1e-6, "1e-6 of the area"), (1e-9, "1e-9 of the area")] {
            let boundary = std::slice::from_ref(&boundary);
            let [first, second, third] = steps(boundary, triangles, tolerance);
            let row = |surface: &MinimalSurface, phase: &str| {
                format!(
                    "{:.3}, {}, {:.1e}",
                    surface.statistics.area,
                    sweeps(&surface.statistics, phase),
                    theirs(surface)
                )
            };
            println!(
                "| {name}, {} points, {triangles} triangles | {shown} | {:.2} | {} | {} | {limit} | {printed} |",
                boundary[0].len(),
                first.statistics.area,
                row(&second, "laplacian_fairing"),
                row(&third, "area_minimising"),
            );
            if shown == "1e-6 of the area" {
                // Both images have the same range: nine tenths of the vertices before step 3 are below it.
                let mut sorted = second.mean_curvature.clone();
                sorted.sort_by(f64::total_cmp);
                let red = sorted[sorted.len() * 9 / 10];
                save(
                    &format!("chen_cai_zheng_{name}"),
                    &[
                        Picture::shaded("step 1", &first.mesh),
                        image("step 2", &second, red),
                        image("step 3", &third, red),
                    ],
                );
            }
        }
    }
    levels(save);
    orders();
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

/// Repeats their Tables 1 and 2 with the same numbers of points and triangles. They print no coordinates.
fn levels(save: Save) {
    println!("\n| boundary | triangles | area | largest curvature | residual |\n| --- | --- | --- | --- | --- |");
    for (name, boundary, counts) in [
        ("160 points", loop_of(160, 1.6, 3.0, 0.5), [800, 2400]),
        ("97 points", loop_of(97, 18.0, 2.0, 5.0), [485, 1455]),
    ] {
        let films = counts.map(|count| {
            let options = relax(count, VertexRelaxation { area_tolerance: 1e-9, ..VertexRelaxation::default() });
            let surface = run(std::slice::from_ref(&boundary), &options);
            println!(
                "| {name} | {} | {:.4} | {:.1e} | {:.1e} |",
                surface.statistics.triangles,
                surface.statistics.area,
                theirs(&surface),
                surface.statistics.residual,
            );
            (count, surface)
        });
        let pictures: Vec<Picture> = films
            .iter()
            .map(|(count, surface)| Picture::shaded(format!("{name}, {count} triangles"), &surface.mesh))
            .collect();
        save(&format!("chen_cai_zheng_{}", name.replace(' ', "_")), &pictures);
    }
}

/// The processes in other orders, on Scherk's surface.
fn orders() {
    use Process::{AreaMinimising, EdgeSwapping, LaplacianFairing};
    println!("\n| order of the processes | sweeps | area | largest curvature |\n| --- | --- | --- | --- |");
    for (name, stages) in [
        ("theirs", None),
        ("area + swapping", Some(vec![vec![AreaMinimising, EdgeSwapping]])),
        ("fairing + swapping", Some(vec![vec![LaplacianFairing, EdgeSwapping]])),
        (
            "area + swapping, then fairing + swapping",
            Some(vec![vec![AreaMinimising, EdgeSwapping], vec![LaplacianFairing, EdgeSwapping]]),
        ),
        ("fairing, area, swapping in one stage", Some(vec![vec![LaplacianFairing, AreaMinimising, EdgeSwapping]])),
    ] {
        let method = VertexRelaxation { processes: stages, ..VertexRelaxation::default() };
        let surface = run(&[boundaries::scherk()], &relax(800, method));
        println!(
            "| {name} | {} | {:.4} | {:.1e} |",
            surface.statistics.iterations,
            surface.statistics.area,
            theirs(&surface)
        );
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
    println!("\n| start | area at first | film |\n| --- | --- | --- |");
    for (name, contours, triangles) in [
        ("crossing", vec![banana], 960),
        ("two_contours", vec![super::circle(72, 1.2, DVec3::ZERO, DVec3::Z), upper], 1152),
    ] {
        let [first, _, film] = steps(&contours, triangles, 1e-8);
        println!("| {name} | {:.3} | {:.3} |", first.statistics.initial_area, film.statistics.area);
        save(
            &format!("chen_cai_zheng_{name}"),
            &[Picture::shaded("initial mesh", &first.mesh), Picture::shaded("film", &film.mesh)],
        );
    }
}
