//! Which film is the least: every way to span two and more boundaries.

use super::{Save, circle, rings, run};
use crate::picture::Picture;
use plateau_film::minimal_surface::{FreeTopology, Method, Newton, Options, Resolution, TopologyRule};
use plateau_mesh::DVec3;

fn spanning(topology: TopologyRule, triangles: usize) -> Options {
    let method = Method::Newton(Newton { topology, ..Newton::default() });
    Options { method, ..Options::new(Resolution::Triangles(triangles)) }
}

pub fn run_all(save: Save) {
    let tetrahedron: Vec<Vec<DVec3>> = [(1.0, 1.0, 1.0), (1.0, -1.0, -1.0), (-1.0, 1.0, -1.0), (-1.0, -1.0, 1.0)]
        .iter()
        .map(|&(x, y, z)| DVec3::new(x, y, z).normalize())
        .map(|normal| circle(36, 0.6, 0.5 * normal, normal))
        .collect();
    let nested = vec![circle(48, 2.0, DVec3::ZERO, DVec3::Z), circle(24, 0.7, DVec3::new(0.4, 0.1, 0.0), DVec3::Z)];
    let cases = [
        ("two rings, height 12", "height 12: discs", rings(&[0.0, 12.0])),
        ("two rings, height 14", "height 14: discs", rings(&[0.0, 14.0])),
        ("three rings, 6 apart", "three in a row", rings(&[0.0, 6.0, 12.0])),
        ("four loops on a tetrahedron's faces", "tetrahedron", tetrahedron),
        ("a loop inside another", "nested", nested),
    ];
    println!("\n| boundaries | films over | area | stable | cross |\n| --- | --- | --- | --- | --- |");
    let mut least = Vec::new();
    for (title, _, boundaries) in &cases {
        let surface = run(boundaries, &spanning(TopologyRule::Best, 1500));
        if let Some(comparison) = &surface.statistics.spanning {
            for topology in &comparison.topologies {
                let area = topology.area.map_or(String::from("does not hold"), |area| format!("{area:.4}"));
                let stable = topology.stability.map_or("", |stability| if stability.stable { "yes" } else { "no" });
                let cross = if topology.films_cross { "yes" } else { "" };
                let films: Vec<String> = topology.films.iter().map(|film| format!("{film:?}")).collect();
                println!("| {title} | {} | {area} | {stable} | {cross} |", films.join(" "));
            }
            if let Some(fraction) = comparison.largest_gap_fraction {
                println!("| {title} | connected up to {fraction:.4} of the gap | | | |");
            }
        }
        // Coarser, for a small file.
        least.push(run(boundaries, &spanning(TopologyRule::Best, 500)).mesh);
    }
    let near = spanning(TopologyRule::Free(FreeTopology::default()), 500);
    let catenoid = run(&rings(&[0.0, 12.0]), &near).mesh;
    let mut pictures = vec![Picture::shaded("height 12, free", &catenoid)];
    pictures.extend(cases.iter().zip(&least).map(|(case, mesh)| Picture::shaded(case.1, mesh)));
    save("spanning_topologies", &pictures);
}
