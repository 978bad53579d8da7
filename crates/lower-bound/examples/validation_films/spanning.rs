//! Pictures of films with the least area among all topologies that span two or more boundaries.

use super::{Save, circle, rings, run};
use crate::picture::Picture;
use plateau_mesh::{DVec3, Mesh};
use plateau_minimal_surface::{FreeTopology, Method, Newton, Options, Resolution, TopologyRule};

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
        ("height 12: discs", rings(&[0.0, 12.0])),
        ("height 14: discs", rings(&[0.0, 14.0])),
        ("three in a row", rings(&[0.0, 6.0, 12.0])),
        ("tetrahedron", tetrahedron),
        ("nested", nested),
    ];
    let best = |(_, boundaries): &(&str, Vec<Vec<DVec3>>)| run(boundaries, &spanning(TopologyRule::Best, 500)).mesh;
    let least: Vec<Mesh> = cases.iter().map(best).collect();
    let near = spanning(TopologyRule::Free(FreeTopology::default()), 500);
    let catenoid = run(&rings(&[0.0, 12.0]), &near).mesh;
    let mut pictures = vec![Picture::shaded("height 12, free", &catenoid)];
    pictures.extend(cases.iter().zip(&least).map(|(case, mesh)| Picture::shaded(case.0, mesh)));
    save("spanning_topologies", &pictures);
}
