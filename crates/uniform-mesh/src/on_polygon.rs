//! Meshes a planar polygon: from its points to a mesh with its statistics.

use super::edges::{edges, lengths, topology};
use super::measure::{Table, assemble, finish, is_in_range, lattice_group};
use super::on_surface::share;
use super::options::{Optimise, Options};
use super::plane::mesh::{self, Failure, Outline};
use super::plane::polygon::Polygon;
use super::plane::sides::Division;
use super::report::{UniformMesh, Why};
use super::surface::auxiliary::Surface;
use super::surface::move_nodes::OnSurface;
use plateau_mesh::error::{Error, InputError, Place};
use plateau_mesh::execution::Execution;
use plateau_mesh::plane::triangulation::InvalidConstraints;
use plateau_mesh::{DVec3, Mesh};

/// Meshes a planar polygon and computes the statistics.
pub(super) fn on_polygon(
    outer: &[DVec3],
    holes: &[Vec<DVec3>],
    options: &Options,
    execution: &Execution<'_>,
) -> Result<UniformMesh, Error> {
    let whole = Polygon::new(outer, holes, options.edge_length)?.joined(execution)?;
    let split = |&division: &Division| {
        let mut polygon = whole.clone();
        polygon.split(division);
        polygon
    };
    let mut polygons: Vec<Polygon> = Division::candidates(options.objective).iter().map(split).collect();
    polygons.dedup_by_key(|polygon| polygon.positions.len());
    let outlines: Vec<&Outline> = polygons.iter().map(|polygon| &polygon.outline).collect();
    let shares = matches!(options.optimise, Optimise::Lengths { .. });
    let (which, flat) = mesh::mesh(&outlines, options.objective, (0.0, if shares { 0.5 } else { 0.95 }), execution)
        .map_err(|failure| planar_error(failure, &polygons[0]))?;
    let polygon = polygons.swap_remove(which);
    let fixed = polygon.positions.len();
    let members = edges(&topology(flat.points.iter().map(|p| p.extend(0.0)).collect(), &flat.triangles)?);
    let lattice_group = lattice_group(&members, &flat);
    let mut table = Table::new(options);
    table.row("plane", &lengths(&members, |v| flat.points[v as usize].extend(0.0)), Some(&lattice_group));
    let mut points: Vec<DVec3> = flat.points.iter().map(|p| p.extend(0.0)).collect();
    let (mut triangles, mut members) = (flat.triangles, members);
    let (mut shared, mut interrupted) = (Vec::new(), flat.interrupted);
    if let Optimise::Lengths { most } = options.optimise
        && !interrupted
    {
        let mut nodes = OnSurface {
            surface: &Surface::Plane,
            parameters: flat.points.clone(),
            positions: points,
            fixed,
            triangles,
            members,
            lattice_group: lattice_group.clone(),
        };
        (shared, interrupted) = share(&mut nodes, most, &mut table, (0.5, 0.99), execution)?;
        (points, triangles, members) = (nodes.positions, nodes.triangles, nodes.members);
    }
    let mut vertices = polygon.positions.clone();
    vertices.extend(points[fixed..].iter().map(|&p| polygon.point(p.truncate())));
    let why = |member: usize| {
        let [a, b] = members[member].map(|v| flat.points[v as usize]);
        let length = a.distance(b);
        if is_in_range(length) {
            Why::Optimised
        } else {
            polygon.sides.why(members[member], length, &polygon.outline.nodes)
        }
    };
    let mesh = Mesh::new(vertices, triangles);
    let mut result = assemble(mesh, members.clone(), lattice_group, options, why);
    result.stages = table.stages;
    result.shared_lengths = shared;
    result.statistics.node_lower_bound = Some(polygon.node_lower_bound());
    result.input_vertices = polygon.input_vertices;
    finish(result, interrupted, None, polygon.warnings, options, execution)
}

fn planar_error(failure: Failure, polygon: &Polygon) -> Error {
    let crossing = "the polygon crosses or touches itself (or a hole) here";
    match failure {
        Failure::Interrupted(interruption) => Error::Interrupted(interruption),
        Failure::InvalidConstraints(InvalidConstraints::Coincident(a, b)) => Error::Input(vec![
            InputError::new(polygon.place_of(a), "coincides with another point: the boundary touches itself"),
            InputError::new(polygon.place_of(b), "coincides with another point: the boundary touches itself"),
        ]),
        Failure::InvalidConstraints(InvalidConstraints::Crossing { from, .. }) => {
            Error::input(polygon.place_of(from), crossing)
        }
        Failure::InvalidConstraints(InvalidConstraints::WrongSide { from, .. }) => {
            Error::input(polygon.ring_of(from), "does not lie inside the polygon, clear of the other holes")
        }
        Failure::InvalidConstraints(InvalidConstraints::OutOfRange) => {
            Error::input(Place::field("domain"), "coordinates are too large or too close together for this edge length")
        }
    }
}
