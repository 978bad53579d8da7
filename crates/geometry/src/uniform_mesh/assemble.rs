//! From a checked domain to a measured result: the order of the steps, and what each hands to the next.

use super::curved::{Auxiliary, Boundary, Surface};
use super::flatten::{self, Locator};
use super::lengths::{LengthsRow, share_lengths};
use super::plane::{self, Failure, Outline, PlaneMesh, deadline};
use super::polygon::Polygon;
use super::refine_on_surface::OnSurface;
use super::rim::fit;
use super::sides::Division;
use super::statistics::{self, Group, LengthHistogram, Stage};
use super::triangulation::Tangle;
use super::{Objective, Optimise, Options, OutOfRange, RANGE_TOLERANCE, Statistics, UniformMesh, Why};
use crate::error::{Error, InputError, Place, Warning};
use crate::execution::{Execution, Progress};
use crate::mesh::measure::{Spread, angle_range};
use crate::mesh::self_intersections::SelfIntersectionCheck;
use crate::mesh::topology::Topology;
use crate::{DVec3, Mesh};
use std::rc::Rc;

/// A planar polygon, meshed and measured.
pub(super) fn on_polygon(
    outer: &[DVec3],
    holes: &[Vec<DVec3>],
    options: &Options,
    execution: &Execution<'_>,
) -> Result<UniformMesh, Error> {
    let whole = Polygon::new(outer, holes, options.edge_length)?;
    let split = |&division: &Division| {
        let mut polygon = whole.clone();
        polygon.split(division);
        polygon
    };
    let mut polygons: Vec<Polygon> = Division::candidates(options.objective).iter().map(split).collect();
    polygons.dedup_by_key(|polygon| polygon.positions.len());
    let outlines: Vec<&Outline> = polygons.iter().map(|polygon| &polygon.outline).collect();
    let shares = matches!(options.optimise, Optimise::Lengths { .. });
    let (which, flat) = plane::mesh(&outlines, options.objective, (0.0, if shares { 0.5 } else { 0.95 }), execution)
        .map_err(|failure| planar_error(failure, &polygons[0]))?;
    let polygon = polygons.swap_remove(which);
    let fixed = polygon.positions.len();
    let members = flatten::edges(&topology(flat.points.iter().map(|p| p.extend(0.0)).collect(), &flat.triangles)?);
    let lattice_group = lattice_group(&members, &flat);
    let mut table = Table::new(options);
    table.row("plane", &lengths(&members, |v| flat.points[v as usize].extend(0.0)), Some(&lattice_group));
    let mut points: Vec<DVec3> = flat.points.iter().map(|p| p.extend(0.0)).collect();
    let (mut shared, mut interrupted) = (Vec::new(), flat.interrupted);
    if let Optimise::Lengths { most } = options.optimise
        && !interrupted
    {
        let mut nodes = OnSurface {
            surface: &Surface::Plane,
            parameters: flat.points.clone(),
            positions: points,
            fixed,
            triangles: flat.triangles.clone(),
            members: members.clone(),
            lattice_group: lattice_group.clone(),
        };
        (shared, interrupted) = share(&mut nodes, most, &mut table, (0.5, 0.99), execution)?;
        points = nodes.positions;
    }
    let mut vertices = polygon.positions.clone();
    vertices.extend(points[fixed..].iter().map(|&p| polygon.frame.point(p.truncate())));
    let why = |member: usize| {
        let [a, b] = members[member].map(|v| flat.points[v as usize]);
        let length = a.distance(b);
        if is_in_range(length) {
            Why::Optimised
        } else {
            polygon.sides.why(members[member], length, &polygon.outline.nodes)
        }
    };
    let mesh = Mesh::new(vertices, flat.triangles.clone());
    let mut result = assemble(mesh, members.clone(), lattice_group, options, why);
    result.stages = table.stages;
    result.shared_lengths = shared;
    result.statistics.node_lower_bound = Some(polygon.node_lower_bound());
    result.input_vertices = polygon.input_vertices;
    finish(result, interrupted, polygon.warnings, options, execution)
}

/// Steps 2 to 5 of [`curved`]; `from` is the progress made so far.
pub(super) fn on_surface(
    auxiliary: &Auxiliary,
    from: f64,
    options: &Options,
    execution: &Execution<'_>,
) -> Result<UniformMesh, Error> {
    let shares = matches!(options.optimise, Optimise::Lengths { .. });
    let at = |part: f64| from + (1.0 - from) * part;
    let auxiliary_edges = flatten::edges(&auxiliary.topology);
    let mut plane = auxiliary.start()?;
    execution.look(auxiliary_edges.len() as u64)?;
    let outcome = flatten::flatten(&auxiliary.mesh, &auxiliary_edges, &mut plane, (at(0.0), at(0.3)), execution);
    if let Some(interruption) = outcome.interrupted {
        return Err(Error::Interrupted(interruption));
    }
    let locator = Rc::new(Locator::new(&plane, &auxiliary.mesh.triangles));
    let surface = auxiliary.surface(&plane, &locator);
    let divided = |&division: &Division| auxiliary.boundary(&plane, &surface, division);
    let mut boundaries: Vec<Boundary> = Division::candidates(options.objective).iter().map(divided).collect();
    boundaries.dedup_by_key(|boundary| boundary.positions.len());
    let outlines: Vec<&Outline> = boundaries.iter().map(|boundary| &boundary.outline).collect();
    let meshed = plane::mesh(&outlines, options.objective, (at(0.3), at(0.6)), execution);
    let (which, flat) = meshed.map_err(|failure| {
        let detail = "the surface folds over itself when it is laid into the plane: split it into several";
        match failure {
            Failure::Interrupted(interruption) => Error::Interrupted(interruption),
            Failure::Tangle(_) => Error::no_result("not_flattenable", detail),
        }
    })?;
    let boundary = boundaries.swap_remove(which);
    let mut table = Table::new(options);
    table.row("auxiliary_surface", &lengths(&auxiliary_edges, |v| auxiliary.mesh.vertices[v as usize]), None);
    table.row("auxiliary_plane", &lengths(&auxiliary_edges, |v| plane[v as usize].extend(0.0)), None);

    let fixed = boundary.positions.len();
    let mut parameters = boundary.parameters.clone();
    parameters.extend(flat.points[fixed..].iter().map(|&p| auxiliary.carry_back(p, &plane, &locator)));
    let mut positions = boundary.positions.clone();
    positions.extend(parameters[fixed..].iter().map(|&p| surface.evaluate(p)[0]));
    let members = flatten::edges(&topology(positions.clone(), &flat.triangles)?);
    let lattice_group = lattice_group(&members, &flat);
    table.row("plane", &lengths(&members, |v| flat.points[v as usize].extend(0.0)), Some(&lattice_group));
    let surface = &surface;
    let mut nodes =
        OnSurface { surface, parameters, positions, fixed, triangles: flat.triangles, members, lattice_group };
    let mut before = nodes.lengths();
    table.row("surface", &before, Some(&nodes.lattice_group));
    let (mut shared, mut interrupted) = (Vec::new(), flat.interrupted);
    let (middle, end) = if shares { (0.7, 0.98) } else { (0.98, 0.98) };
    if options.optimise != Optimise::None && !interrupted {
        let (rebuilt, stopped) = fit(&mut nodes, options.rim, (at(0.6), at(middle)), execution);
        interrupted = deadline(stopped.map_or(Ok(()), Err))?;
        if rebuilt {
            before = nodes.lengths();
        }
        table.row("optimised_nodes", &nodes.lengths(), Some(&nodes.lattice_group));
    }
    if let Optimise::Lengths { most } = options.optimise
        && !interrupted
    {
        let span = (at(middle), at(end));
        (shared, interrupted) = share(&mut nodes, most, &mut table, span, execution)?;
    }

    let mut vertices: Vec<DVec3> = nodes.positions.iter().map(|&p| auxiliary.place(p)).collect();
    for &(node, p) in &boundary.exact {
        vertices[node as usize] = p;
    }
    let OnSurface { triangles, members, lattice_group, .. } = nodes;
    let why = |member: usize| {
        // Only what the boundary's own nodes do is the plane's doing: inserted nodes are clear of all others there.
        let ends = members[member].map(|v| boundary.outline.nodes.get(v as usize));
        let narrow = match ends {
            [Some(a), Some(b)] => Some(a.distance(*b)).filter(|&length| !is_in_range(length)),
            _ => None,
        };
        match narrow {
            Some(length) if length < 1.0 => boundary.sides.why(members[member], length, &boundary.outline.nodes),
            _ if flat.interrupted => Why::Unfinished,
            _ if is_in_range(before[member]) && !lattice_group[member] => Why::Optimised,
            _ => Why::Curvature,
        }
    };
    let mesh = Mesh::new(vertices, triangles);
    let mut result = assemble(mesh, members.clone(), lattice_group.clone(), options, why);
    result.stages = table.stages;
    result.shared_lengths = shared;
    result.input_vertices = boundary.input_vertices;
    finish(result, interrupted, auxiliary.warnings.clone(), options, execution)
}

/// Whether a length in ℓ lies in [1, 2], rounding allowed.
fn is_in_range(length: f64) -> bool {
    (1.0 - RANGE_TOLERANCE..=2.0 + RANGE_TOLERANCE).contains(&length)
}

/// The stages of a solve as they come; lengths arrive in ℓ.
struct Table {
    target: f64,
    tolerance: f64,
    stages: Vec<Stage>,
}

impl Table {
    fn new(options: &Options) -> Self {
        Self { target: options.edge_length, tolerance: options.tolerance(), stages: Vec::new() }
    }

    fn row(&mut self, name: &'static str, lengths: &[f64], lattice: Option<&[bool]>) {
        let group = |lengths: Vec<f64>| Group::of(&lengths, self.target, self.tolerance);
        let all: Vec<f64> = lengths.iter().map(|length| length * self.target).collect();
        let lattice = lattice.map(|lattice| {
            group(all.iter().zip(lattice).filter(|&(_, &member)| member).map(|(&length, _)| length).collect())
        });
        self.stages.push(Stage { name, all: group(all), lattice });
    }
}

/// [`share_lengths`] with its row of the table; the second value says whether the deadline passed.
fn share(
    nodes: &mut OnSurface<'_>,
    most: usize,
    table: &mut Table,
    span: (f64, f64),
    execution: &Execution<'_>,
) -> Result<(Vec<LengthsRow>, bool), Error> {
    let target = table.target;
    let (mut rows, stopped) = share_lengths(nodes, most, table.tolerance / target, span, execution);
    let interrupted = deadline(stopped.map_or(Ok(()), Err))?;
    for row in &mut rows {
        row.deviation *= target;
        row.deviation_before *= target;
    }
    table.row("shared_lengths", &nodes.lengths(), Some(&nodes.lattice_group));
    Ok((rows, interrupted))
}

/// The last words, the same for every domain.
fn finish(
    mut result: UniformMesh,
    interrupted: bool,
    first: Vec<Warning>,
    options: &Options,
    execution: &Execution<'_>,
) -> Result<UniformMesh, Error> {
    result.converged = !interrupted;
    result.warnings.splice(0..0, first);
    if interrupted {
        let detail = "the deadline passed: edges may be longer than 2ℓ, nodes not yet optimal";
        result.warnings.push(Warning::new("not_converged", detail));
    } else if options.objective == Objective::MostEqualEdges && result.statistics.lattice_edges.count == 0 {
        let detail = "no lattice edge fits: the domain is too narrow for this length";
        result.warnings.push(Warning::new("no_lattice", detail));
    }
    if let (Optimise::Lengths { most }, Some(row)) = (options.optimise, result.shared_lengths.last())
        && 2.0 * row.deviation > result.statistics.length_tolerance
    {
        let detail = format!("{most} lengths stand for all members to {:.6e} only, see shared_lengths", row.deviation);
        result.warnings.push(Warning::new("lengths_not_reached", detail));
    }
    execution.report(Progress {
        fraction: 1.0,
        phase: "done",
        iteration: result.statistics.nodes as u64,
        objective_value: Some(result.statistics.objective_value as f64),
        residual: None,
    });
    Ok(result)
}

/// The mesh's connectivity; a defect here is a defect of this module, reported rather than passed on.
pub(super) fn topology(vertices: Vec<DVec3>, triangles: &[[u32; 3]]) -> Result<Topology, Error> {
    Mesh::new(vertices, triangles.to_vec())
        .check()
        .map_err(|defect| Error::no_result("invalid_mesh", format!("the triangulation is not a manifold: {defect}")))
}

/// Which members are edges of the lattice: of length ℓ in the plane between two lattice points.
fn lattice_group(members: &[[u32; 2]], flat: &PlaneMesh) -> Vec<bool> {
    let on_lattice: Vec<bool> =
        flat.points.iter().map(|&p| flat.lattice.is_some_and(|placement| placement.carries(p))).collect();
    members
        .iter()
        .map(|&[a, b]| {
            let (a, b) = (a as usize, b as usize);
            on_lattice[a] && on_lattice[b] && (flat.points[a].distance(flat.points[b]) - 1.0).abs() < 1e-6
        })
        .collect()
}

fn lengths(edges: &[[u32; 2]], at: impl Fn(u32) -> DVec3) -> Vec<f64> {
    edges.iter().map(|&[a, b]| at(a).distance(at(b))).collect()
}

fn planar_error(failure: Failure, polygon: &Polygon) -> Error {
    let crossing = "the polygon crosses or touches itself (or a hole) here";
    match failure {
        Failure::Interrupted(interruption) => Error::Interrupted(interruption),
        Failure::Tangle(Tangle::Coincident(a, b)) => Error::Input(vec![
            InputError::new(polygon.place_of(a), "coincides with another point: the boundary touches itself"),
            InputError::new(polygon.place_of(b), "coincides with another point: the boundary touches itself"),
        ]),
        Failure::Tangle(Tangle::Crossing { from, .. }) => Error::input(polygon.place_of(from), crossing),
        Failure::Tangle(Tangle::WrongSide { from, .. }) => {
            Error::input(polygon.ring_of(from), "does not lie inside the polygon, clear of the other holes")
        }
        Failure::Tangle(Tangle::OutOfRange) => {
            Error::input(Place::field("domain"), "coordinates are too large or too close together for this edge length")
        }
    }
}

/// Measures a finished mesh.
fn assemble(
    mesh: Mesh,
    members: Vec<[u32; 2]>,
    lattice_group: Vec<bool>,
    options: &Options,
    why: impl Fn(usize) -> Why,
) -> UniformMesh {
    let target = options.edge_length;
    let tolerance = options.tolerance();
    let at = |v: u32| mesh.vertices[v as usize];
    let lengths: Vec<f64> = members.iter().map(|&[a, b]| at(a).distance(at(b))).collect();
    // Coordinates far from the origin carry lengths only to their own rounding.
    let largest = mesh.vertices.iter().map(|v| v.abs().max_element()).fold(0.0, f64::max);
    let slack = RANGE_TOLERANCE * target + 8.0 * f64::EPSILON * largest;
    let out_of_range: Vec<OutOfRange> = lengths
        .iter()
        .enumerate()
        .filter(|&(_, &length)| length < target - slack || length > 2.0 * (target + slack))
        .map(|(member, &length)| OutOfRange { member, length, why: why(member) })
        .collect();
    let all = Group::of(&lengths, target, tolerance);
    let lattice = lengths.iter().zip(&lattice_group).filter(|&(_, &member)| member).map(|(&length, _)| length);
    let lattice_edges = Spread::of(lattice);
    let statistics = Statistics {
        objective_value: match options.objective {
            Objective::FewestNodes => mesh.vertices.len(),
            Objective::MostEqualEdges => lattice_edges.count,
        },
        nodes: mesh.vertices.len(),
        triangles: mesh.triangles.len(),
        edges: members.len(),
        edge_lengths: all.lengths,
        lattice_edges,
        equal_edges: all.equal_edges,
        distinct_lengths: all.distinct_lengths,
        length_tolerance: tolerance,
        out_of_range_edges: out_of_range.len(),
        angles: angle_range(&mesh),
        length_histogram: LengthHistogram::of(&lengths, target),
        valence_histogram: statistics::valences(&members, mesh.vertices.len()),
        node_lower_bound: None,
        self_intersections: SelfIntersectionCheck::default(),
    };
    let mut warnings = Vec::new();
    if !out_of_range.is_empty() {
        let mut reasons: Vec<&str> = out_of_range.iter().map(|edge| edge.why.name()).collect();
        reasons.sort_unstable();
        reasons.dedup();
        let detail = format!("{} edges are outside [ℓ, 2ℓ]: {}", out_of_range.len(), reasons.join(", "));
        warnings.push(Warning::new("out_of_range", detail));
    }
    UniformMesh {
        mesh,
        members,
        lattice_group,
        lengths,
        statistics,
        stages: Vec::new(),
        shared_lengths: Vec::new(),
        out_of_range,
        input_vertices: Vec::new(),
        converged: true,
        warnings,
    }
}
