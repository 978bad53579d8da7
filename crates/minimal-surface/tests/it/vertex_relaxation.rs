//! The examples of Chen, Cai and Zheng, and the properties that their method has on every boundary.

use crate::boundaries;
use plateau_mesh::{DVec3, Execution, Mesh};
use plateau_minimal_surface::{
    BoundarySampling, InitialMesh, Method, MinimalSurface, Options, Process, Resolution, VertexRelaxation, solve,
};

fn relax(triangles: usize) -> Options {
    relax_with(VertexRelaxation::default(), triangles)
}

fn relax_with(method: VertexRelaxation, triangles: usize) -> Options {
    Options {
        method: Method::VertexRelaxation(method),
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

/// Checks a result: a manifold with exactly the given boundary, in its order, and valid statistics.
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

#[test]
fn the_two_tolerances_end_their_own_stages() {
    let iterations = |fairing: f64, area: f64| {
        let method =
            VertexRelaxation { fairing_tolerance: Some(fairing), area_tolerance: area, ..VertexRelaxation::default() };
        let history = solved(&[boundaries::scherk()], &relax_with(method, 800)).statistics.history;
        let last =
            |phase: &str| history.iter().filter(|row| row.phase == phase).map(|row| row.iteration).max().unwrap();
        (last("laplacian_fairing"), last("area_minimising") - last("laplacian_fairing"))
    };
    let (coarse, fine, longer) = (iterations(1e-2, 1e-4), iterations(1e-4, 1e-4), iterations(1e-2, 1e-6));
    assert!(fine.0 > coarse.0, "{coarse:?} {fine:?}");
    assert!(longer.0 == coarse.0 && longer.1 > coarse.1, "{coarse:?} {longer:?}");
}

#[test]
fn the_caller_may_name_another_order_of_the_processes() {
    let processes = Some(vec![vec![Process::AreaMinimising], vec![Process::LaplacianFairing, Process::EdgeSwapping]]);
    let method = VertexRelaxation { processes, ..VertexRelaxation::default() };
    let statistics = solved(&[boundaries::scherk()], &relax_with(method, 800)).statistics;
    let mut phases: Vec<&str> = statistics.history.iter().map(|row| row.phase).collect();
    phases.dedup();
    assert_eq!(phases, ["area_minimising", "laplacian_fairing"]);
}

#[test]
fn edges_are_swapped_alone_and_no_vertex_moves() {
    // A saddle over a square grid, all of whose diagonals run the same way.
    let n = 8u32;
    let at = |i: u32, j: u32| DVec3::new(f64::from(i), f64::from(j), 0.3 * (f64::from(i) - 3.5) * (f64::from(j) - 3.5));
    let vertices: Vec<DVec3> = (0..n).flat_map(|i| (0..n).map(move |j| at(i, j))).collect();
    let cells = (0..n - 1).flat_map(|i| (0..n - 1).map(move |j| i * n + j));
    let triangles = cells.flat_map(|k| [[k, k + n, k + n + 1], [k, k + n + 1, k + 1]]).collect();
    let last = n - 1;
    let sides = (0..last).map(|k| at(k, 0)).chain((0..last).map(|k| at(last, k)));
    let boundary = sides.chain((1..n).rev().map(|k| at(k, last))).chain((1..n).rev().map(|k| at(0, k))).collect();
    let processes = Some(vec![vec![Process::EdgeSwapping]]);
    let options = Options {
        initial_mesh: InitialMesh::Given(Mesh::new(vertices.clone(), triangles)),
        ..relax_with(VertexRelaxation { processes, ..VertexRelaxation::default() }, 98)
    };
    let surface = solve(&[boundary], &options, &Execution::default()).unwrap();
    let statistics = &surface.statistics;
    assert_eq!((statistics.stop_reason.name(), statistics.iterations), ("area_change", 1));
    assert_eq!(statistics.history.iter().map(|row| row.phase).collect::<Vec<_>>(), ["edge_swapping"]);
    assert!(statistics.edges_swapped > 0 && statistics.area < statistics.initial_area, "{statistics:?}");
    let stays = |p: &DVec3| vertices.iter().any(|given| given.distance(*p) < 1e-12);
    assert!(surface.mesh.vertices.len() == vertices.len() && surface.mesh.vertices.iter().all(stays));
}

#[test]
fn a_film_without_interior_vertices_swaps_its_edges() {
    // The rings of a narrow strip: each vertex lies on one of the two boundaries.
    let ring = |z: f64, turn: f64| -> Vec<DVec3> {
        (0..24)
            .map(|k| std::f64::consts::TAU * f64::from(k) / 24.0 + turn)
            .map(|t| DVec3::new(t.cos(), t.sin(), z + 0.3 * (2.0 * t).cos()))
            .collect()
    };
    let boundaries = [ring(0.0, 0.0), ring(0.3, 0.9)];
    let surface = solve(&boundaries, &relax(48), &Execution::default()).unwrap();
    assert_eq!(surface.mesh.vertices.len(), 48);
    assert!(surface.statistics.edges_swapped > 0, "{:?}", surface.statistics);
}

#[test]
fn two_contours_are_joined_as_in_their_ninth_figure() {
    let statistics = solved(&boundaries::rings(96, 1.0), &relax(1920)).statistics;
    assert_eq!((statistics.triangles, statistics.euler_characteristic), (1920, 0));
    assert!((statistics.area / 5.98944 - 1.0).abs() < 2e-3, "area {}", statistics.area);
}

#[test]
fn more_triangles_lower_the_area_as_in_their_tables() {
    for (boundary, limit) in [(boundaries::scherk(), 11.6147), (boundaries::skew_quadrilateral(16), 0.639_630_8)] {
        let level = |triangles| {
            let method =
                VertexRelaxation { area_tolerance: 1e-8, fairing_tolerance: Some(1e-4), ..VertexRelaxation::default() };
            solved(std::slice::from_ref(&boundary), &relax_with(method, triangles)).statistics
        };
        let (coarse, fine) = (level(400), level(1600));
        assert!(coarse.area > fine.area && fine.area > limit, "{} {} {limit}", coarse.area, fine.area);
        assert!(fine.area - limit < 0.6 * (coarse.area - limit));
    }
}

#[test]
fn a_start_that_crosses_itself_is_undone_as_in_their_fourth_figure() {
    // The loop has the shape of a banana and is bent in space. The segments from its points to their mean leave the
    // banana and cross its inner side.
    let (n, bend) = (96, 2.4);
    let boundary: Vec<DVec3> = (0..n)
        .map(|k| {
            let t = std::f64::consts::TAU * f64::from(k) / f64::from(n);
            let (angle, radius) = (bend * t.cos(), 3.0 + 0.7 * t.sin());
            DVec3::new(radius * angle.sin(), radius * angle.cos(), 0.4 * (2.0 * t).cos())
        })
        .collect();
    let method = VertexRelaxation { area_tolerance: 1e-8, ..VertexRelaxation::default() };
    let surface = solved(std::slice::from_ref(&boundary), &relax_with(method, 1500));
    let expected = solve(&[boundary], &Options::new(Resolution::Triangles(1500)), &Execution::default()).unwrap();
    let statistics = &surface.statistics;
    assert!(statistics.initial_area > 1.3 * statistics.area);
    assert_eq!((statistics.quality.flipped_triangles, statistics.quality.degenerate_triangles), (0, 0));
    assert!(
        (statistics.area / expected.statistics.area - 1.0).abs() < 0.01,
        "{} {}",
        statistics.area,
        expected.statistics.area
    );
}

/// The largest curvatures that the paper prints are 7e-4 for its helicoid and 4e-3 for its catenoid. With these counts
/// the default's films were above them by up to twice, because an angle kept single vertices in their places.
#[test]
fn the_default_is_below_the_curvatures_of_the_paper() {
    let [keep, refine] = [BoundarySampling::Keep, BoundarySampling::Refine];
    for (boundary, printed, boundary_sampling, triangles) in [
        (boundaries::catenoid(), 4e-3, refine, 4647),
        (boundaries::catenoid(), 4e-3, keep, 4304),
        (boundaries::catenoid_split(46, 32), 4e-3, refine, 4304),
        (boundaries::catenoid_split(58, 20), 4e-3, keep, 1000),
        (boundaries::helicoid(), 7e-4, keep, 5419),
        (boundaries::helicoid_split([12, 12, 49, 113]), 7e-4, refine, 9278),
    ] {
        let options = Options { boundary_sampling, ..Options::new(Resolution::Triangles(triangles)) };
        let statistics = solve(&[boundary], &options, &Execution::default()).unwrap().statistics;
        // The paper divides by the area of the whole ring, and the statistics by a third of it.
        let curvature = statistics.mean_curvature.max / 3.0;
        assert!(curvature <= printed, "{triangles}: {curvature:e}");
        assert!(statistics.quality.angles.0.to_degrees() >= 20.0, "{triangles}: {:?}", statistics.quality.angles);
    }
}
