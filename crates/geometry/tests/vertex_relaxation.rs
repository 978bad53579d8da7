//! Chen, Cai, Zheng's own examples, and what their method promises on every boundary.

mod boundaries;

use plateau_geometry::minimal_surface::{
    BoundarySampling, InitialMesh, MinimalSurface, Options, Resolution, Solver, solve,
};
use plateau_geometry::{DVec3, Execution};

fn relax(triangles: usize) -> Options {
    Options {
        solver: Solver::VertexRelaxation,
        initial_mesh: InitialMesh::Rings,
        boundary_sampling: BoundarySampling::Keep,
        ..Options::new(Resolution::Triangles(triangles))
    }
}

fn solved(boundaries: &[Vec<DVec3>], options: &Options) -> MinimalSurface {
    let surface = solve(boundaries, options, &Execution::default()).unwrap();
    check(boundaries, &surface);
    surface
}

/// What every answer keeps: a manifold, the boundary exactly as given and in its order, sound figures.
fn check(given: &[Vec<DVec3>], surface: &MinimalSurface) {
    let topology = surface.mesh.check().unwrap();
    assert_eq!(topology.boundary_loops().len(), given.len());
    assert_eq!(surface.boundaries.len(), given.len());
    assert_eq!(surface.mean_curvature.len(), surface.mesh.vertices.len());
    for (points, vertices) in given.iter().zip(&surface.input_vertices) {
        for (point, &vertex) in points.iter().zip(vertices) {
            assert_eq!(*point, surface.mesh.vertices[vertex as usize]);
        }
    }
    let along: usize = surface.boundaries.iter().map(Vec::len).sum();
    assert!(surface.boundaries.iter().flatten().all(|&v| (v as usize) < along), "the boundary's vertices come first");
    for boundary in &surface.boundaries {
        for (k, &a) in boundary.iter().enumerate() {
            let b = boundary[(k + 1) % boundary.len()];
            assert!(topology.is_boundary(a) && topology.are_adjacent(a, b));
        }
    }
    let first = &surface.boundaries[0];
    let out = topology.outgoing[first[0] as usize];
    assert_eq!(topology.to(out), first[1], "the triangles run along the first boundary");
    let statistics = &surface.statistics;
    assert_eq!(statistics.triangles, surface.mesh.triangles.len());
    assert!(statistics.area <= statistics.initial_area * (1.0 + 1e-12));
}

#[test]
fn the_helicoid_with_186_points_and_2050_triangles() {
    let surface = solved(&[boundaries::helicoid()], &relax(2050));
    let statistics = &surface.statistics;
    assert_eq!((statistics.triangles, surface.boundaries[0].len()), (2050, 186));
    assert!((statistics.area / 535.0748 - 1.0).abs() < 1e-3, "area {}", statistics.area);
}

#[test]
fn the_catenoid_with_156_points_and_2040_triangles_is_the_other_surface() {
    let surface = solved(&[boundaries::catenoid()], &relax(2040));
    assert_eq!(surface.statistics.triangles, 2040);
    assert!((surface.statistics.area / 58.1637 - 1.0).abs() < 2e-3, "area {}", surface.statistics.area);
}
