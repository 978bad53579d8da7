//! The entry points: the estimate of the cost, the check of the arguments, and the solve.

use super::on_polygon::on_polygon;
use super::on_surface::{is_almost_flat, on_film, on_patch};
use super::options::{Domain, Objective, Optimise, Options};
use super::plane::polygon::{self, Polygon};
use super::report::UniformMesh;
use super::surface::auxiliary::{self, FILM_EDGE, FILM_TRIANGLES, film_area};
use super::surface::nurbs::Nurbs;
use plateau_mesh::error::{Error, InputError, Place};
use plateau_mesh::execution::Execution;
use plateau_mesh::polyline::LARGEST_COORDINATE;
use plateau_mesh::{DVec2, Estimate};

/// Largest number of nodes that a solve may ask for, because more nodes would not fit the indices.
const MOST_NODES: f64 = 5e7;

/// Memory of any solve besides that of its triangles, in bytes.
const BYTES_OF_SOLVE: f64 = 1e6;

/// Memory per point of a polygon, in bytes, for its triangulation and its sides. Measured: 480 to 600 bytes.
const BYTES_PER_POINT: f64 = 560.0;

/// Memory per rectangle of a patch's auxiliary grid, in bytes.
const BYTES_PER_RECTANGLE: f64 = 400.0;

/// Memory per triangle of the film that carries a lattice, in bytes, with its flattening. Measured: 1,170 bytes.
const BYTES_PER_FILM_TRIANGLE: f64 = 1_150.0;

/// Smallest number of triangles, by estimate, of a patch that is flattened to estimate its memory. The memory of fewer
/// does not matter.
const JUDGED_TRIANGLES: f64 = 3_000.0;

/// Returns the memory per triangle of a mesh, in bytes. On polygons the most equal edges need all lengths at once.
/// Measured, per estimated triangle: 125 to 155 bytes for fewest nodes on polygons and 190 to 220 for most equal edges;
/// 2,900 bytes on a high dome, which is meshed on the surface itself, for either. A patch that is flattened takes 270
/// to 280 bytes if its nodes stay, 730 to 920 for fewest nodes and 1,490 to 1,880 for most equal edges.
fn bytes_per_triangle(domain: &Domain, options: &Options, triangles: f64) -> f64 {
    let of_patch = |patch: &Nurbs| match (options.optimise, options.objective) {
        _ if triangles < JUDGED_TRIANGLES || !is_almost_flat(patch, options) => 3_000.0,
        (Optimise::None, _) => 300.0,
        (_, Objective::FewestNodes) => 950.0,
        (_, Objective::MostEqualEdges) => 1_850.0,
    };
    match (domain, options.objective) {
        (Domain::Polygon { .. }, Objective::FewestNodes) => 150.0,
        (Domain::Polygon { .. }, Objective::MostEqualEdges) => 220.0,
        (Domain::Boundaries(_), _) => 2_700.0,
        (Domain::Bezier { control_points }, _) => of_patch(&Nurbs::bezier(control_points.clone())),
        (Domain::Nurbs(patch), _) => of_patch(patch),
    }
}

/// Estimates the size of the result from above, in O(input). The number of triangles is twice Oler's bound on the
/// number of nodes. This bound is 1.2 to 1.6 times the actual number of nodes.
///
/// # Errors
/// The input errors that [`solve`] would report before meshing.
pub fn estimate(domain: &Domain, options: &Options) -> Result<Estimate, Error> {
    let triangles = 2.0 * most_nodes(domain, options)?;
    let a_triangle = bytes_per_triangle(domain, options, triangles);
    let beside = match domain {
        Domain::Polygon { outer, holes } => {
            let points = outer.len() + holes.iter().map(Vec::len).sum::<usize>();
            // The bound on the nodes has a node for each 2/3 ℓ of the sides. Thin polygons with long sides have fewer.
            let (_, perimeter) = polygon::extent(outer, holes)?;
            BYTES_PER_POINT * points as f64 - 1.5 * a_triangle * perimeter / options.edge_length
        }
        Domain::Bezier { .. } | Domain::Nurbs(_) => {
            BYTES_PER_RECTANGLE * f64::from(options.auxiliary_grid.iter().product::<u32>())
        }
        // The edges of the film are a fraction of the lattice's, until it has its largest number of triangles.
        Domain::Boundaries(_) => BYTES_PER_FILM_TRIANGLE * (triangles / (FILM_EDGE * FILM_EDGE)).min(FILM_TRIANGLES),
    };
    let bytes = BYTES_OF_SOLVE + beside + triangles * a_triangle;
    Ok(Estimate { triangles, cells: 0, bytes: bytes as u64 })
}

/// An upper bound on the number of nodes of the result.
fn most_nodes(domain: &Domain, options: &Options) -> Result<f64, Error> {
    check_options(options)?;
    match domain {
        Domain::Polygon { outer, holes } => {
            let (area, perimeter) = polygon::extent(outer, holes)?;
            Ok(packed_nodes(area, perimeter, options.edge_length))
        }
        Domain::Bezier { control_points } => {
            most_nodes_of_patch(&Nurbs::bezier(control_points.clone()), "bezier", options)
        }
        Domain::Nurbs(patch) => most_nodes_of_patch(patch, "nurbs", options),
        Domain::Boundaries(boundaries) => {
            for (k, boundary) in boundaries.iter().enumerate() {
                if let Some(i) =
                    boundary.iter().position(|p| !p.is_finite() || p.abs().max_element() > LARGEST_COORDINATE)
                {
                    let place = Place::field("domain").then("boundaries").at(k).at(i);
                    return Err(Error::input(place, "must be finite and below 1e50 in magnitude"));
                }
            }
            let perimeter: f64 = boundaries.iter().map(|points| plateau_mesh::polyline::length(points, true)).sum();
            Ok(packed_nodes(film_area(boundaries), perimeter, options.edge_length))
        }
    }
}

/// The upper bound of [`most_nodes`] for a patch. Its area and perimeter are measured on a grid and increased by a
/// tenth, because chords are shorter than arcs.
fn most_nodes_of_patch(patch: &Nurbs, field: &'static str, options: &Options) -> Result<f64, Error> {
    patch.check(&Place::field("domain").then(field))?;
    let n = 24;
    let point = |i: usize, j: usize| patch.evaluate(DVec2::new(i as f64, j as f64) / n as f64)[0];
    let (mut area, mut perimeter) = (0.0, 0.0);
    for i in 0..n {
        for j in 0..n {
            area += 0.5 * (point(i + 1, j + 1) - point(i, j)).cross(point(i, j + 1) - point(i + 1, j)).length();
        }
        for (a, b) in [((i, 0), (i + 1, 0)), ((i, n), (i + 1, n)), ((0, i), (0, i + 1)), ((n, i), (n, i + 1))] {
            perimeter += point(a.0, a.1).distance(point(b.0, b.1));
        }
    }
    Ok(packed_nodes(1.1 * area, 1.1 * perimeter, options.edge_length))
}

/// Upper bound on the number of nodes with distances of at least ℓ in a domain. Oler, *An inequality in the geometry of
/// numbers*, 1961: at most 2/√3 A/ℓ² + P/2ℓ + 1 such points fit. More is added, because the number of pieces of each
/// side is rounded up.
fn packed_nodes(area: f64, perimeter: f64, edge_length: f64) -> f64 {
    2.0 / 3f64.sqrt() * area / (edge_length * edge_length) + 1.5 * perimeter / edge_length + 4.0
}

fn check_options(options: &Options) -> Result<(), Error> {
    let mut errors = Vec::new();
    if !(1.0 / LARGEST_COORDINATE..=LARGEST_COORDINATE).contains(&options.edge_length) {
        errors.push(InputError::new(Place::field("edge_length"), "must be positive, between 1e-50 and 1e50"));
    }
    for (axis, &cells) in options.auxiliary_grid.iter().enumerate() {
        if !(2..=400).contains(&cells) {
            errors.push(InputError::new(Place::field("auxiliary_grid").at(axis), "must lie between 2 and 400"));
        }
    }
    if let Optimise::Lengths { most } = options.optimise
        && !(1..=1000).contains(&most)
    {
        errors.push(InputError::new(Place::field("max_distinct_lengths"), "must lie between 1 and 1000"));
    }
    if options.length_tolerance.is_some_and(|tolerance| !(tolerance >= 0.0 && tolerance.is_finite())) {
        errors.push(InputError::new(Place::field("length_tolerance"), "must be zero or positive"));
    }
    if errors.is_empty() { Ok(()) } else { Err(Error::Input(errors)) }
}

/// Checks the arguments of [`solve`], including planarity, without meshing. The time is linear in the size of the
/// arguments.
///
/// # Errors
/// The [`Error::Input`] that [`solve`] would return before meshing. A boundary that passes this check may still cross
/// itself.
pub fn check(domain: &Domain, options: &Options) -> Result<(), Error> {
    let nodes = most_nodes(domain, options)?;
    match domain {
        Domain::Polygon { outer, holes } => drop(Polygon::new(outer, holes, options.edge_length)?),
        Domain::Boundaries(boundaries) => auxiliary::check_film(boundaries, options)?,
        Domain::Bezier { .. } | Domain::Nurbs(_) => {}
    }
    if nodes > MOST_NODES {
        let detail = format!("asks for up to {nodes:.3e} nodes; at most {MOST_NODES:.0e} are possible");
        return Err(Error::input(Place::field("edge_length"), detail));
    }
    Ok(())
}

/// Meshes the domain.
///
/// On convex polygons with inner angles of 90° or more and sides of ℓ or more, every edge has a length in [ℓ, 2ℓ], up
/// to a relative error of 2e-9. On any other valid polygon no edge is longer than 2ℓ, and edges shorter than ℓ are
/// listed with the reason. Calls `execution.look` after every few thousand triangles and every lattice placement. O(n
/// log n) in practice.
///
/// # Errors
/// [`Error::Input`] if a value is not finite, if the edge length asks for more than 5e7 nodes, if a polygon has no
/// area, is not planar, crosses itself or touches itself, or if a hole is outside. [`Error::Interrupted`] if the solve
/// was cancelled, or if the deadline passed before there was a valid mesh. If the deadline passes later, the mesh
/// reached so far is returned with `converged` false.
pub fn solve(domain: &Domain, options: &Options, execution: &Execution<'_>) -> Result<UniformMesh, Error> {
    check(domain, options)?;
    match domain {
        Domain::Polygon { outer, holes } => on_polygon(outer, holes, options, execution),
        Domain::Bezier { control_points } => {
            let place = Place::field("domain").then("bezier");
            on_patch(&Nurbs::bezier(control_points.clone()), &place, options, execution)
        }
        Domain::Nurbs(patch) => on_patch(patch, &Place::field("domain").then("nurbs"), options, execution),
        Domain::Boundaries(boundaries) => on_film(boundaries, options, execution),
    }
}
