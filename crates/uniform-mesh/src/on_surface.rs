//! Meshes a curved domain: from its auxiliary triangulation to a mesh with its statistics.

use super::edges::{edges, lengths, topology};
use super::measure::{Table, assemble, finish, is_in_range, lattice_group};
use super::options::{Optimise, Options};
use super::plane::mesh::{self, Failure, Outline, deadline};
use super::plane::sides::Division;
use super::report::{LengthsRow, Method, UniformMesh, Why};
use super::surface::auxiliary::{Auxiliary, Boundary, Centred};
use super::surface::deviation::{compare, shortfall};
use super::surface::flatten;
use super::surface::lengths::share_lengths;
use super::surface::move_nodes::{OnSurface, Sheet};
use super::surface::nurbs::Nurbs;
use super::surface::on_reference;
use super::surface::reference::{Bond, Reference};
use super::surface::transition::fit;
use plateau_mesh::codes::Reason;
use plateau_mesh::error::{Error, Place, Warning};
use plateau_mesh::execution::{Execution, Interruption};
use plateau_mesh::measure;
use plateau_mesh::plane::location::Locator;
use plateau_mesh::{DVec2, DVec3, Mesh};
use std::rc::Rc;

/// Largest strain of a flattening that is used: the root mean square of the relative changes of the auxiliary edges'
/// lengths. Beyond it the mesh is made on the surface itself, because a length of ℓ in the plane is then far from ℓ in
/// space.
const LARGEST_STRAIN: f64 = 0.25;
/// Largest strain of the flattening of a patch with a pole. A cone has less, because only the chords of its auxiliary
/// mesh are shorter than its arcs. Other patches with a pole are meshed on the surface itself, because the rim of a
/// flattened mesh cannot be made anew beside a pole.
const LARGEST_STRAIN_AT_A_POLE: f64 = 0.01;

/// Number of rectangles along u and v of the auxiliary mesh by which a patch is judged before it is solved.
const JUDGED_GRID: u32 = 10;
/// Largest relative change of an auxiliary edge's length up to which the flattened mesh is taken for good enough. Domes
/// with changes of 0.15 are meshed by flattening, and domes with 0.23 on the surface itself for the most equal edges.
const ALMOST_FLAT: f64 = 0.13;

/// Returns true if the mesh of this patch is certain to be made by flattening, which takes less memory than meshing on
/// the surface itself. The patch is flattened on a coarse auxiliary mesh, which takes some milliseconds.
pub(super) fn is_almost_flat(patch: &Nurbs, options: &Options) -> bool {
    let options = Options { auxiliary_grid: [JUDGED_GRID; 2], ..options.clone() };
    let Some(auxiliary) = Auxiliary::of_patch(&Centred::of(patch, options.edge_length), &options) else { return false };
    let auxiliary_edges = edges(&auxiliary.topology);
    let Ok(plane) = laid_flat(&auxiliary, &auxiliary_edges, &Execution::default()) else { return false };
    let strain = |&[a, b]: &[u32; 2]| {
        let in_space = auxiliary.mesh.vertices[a as usize].distance(auxiliary.mesh.vertices[b as usize]);
        (plane[a as usize].distance(plane[b as usize]) / in_space - 1.0).abs()
    };
    auxiliary_edges.iter().map(strain).fold(0.0, f64::max) <= ALMOST_FLAT
}

/// Meshes a NURBS patch and computes the statistics. `place` is the patch's place in the input.
pub(super) fn on_patch(
    patch: &Nurbs,
    place: &Place,
    options: &Options,
    execution: &Execution<'_>,
) -> Result<UniformMesh, Error> {
    patch.check(place)?;
    let centred = Centred::of(patch, options.edge_length);
    let area = centred.patch.area();
    if !(area.is_finite() && area > 0.0) {
        return Err(Error::input(place.clone(), "has no area"));
    }
    let auxiliary = Auxiliary::of_patch(&centred, options);
    let flat = auxiliary
        .as_ref()
        .map(|auxiliary| execution.part([0.0, 0.5], |part| flattened(auxiliary, area, options, part)));
    choose(flat, Vec::new(), options, execution, |part| {
        let reference = Reference::of_patch(&centred.patch, place)?;
        let to_caller = |p: DVec3| centred.centre + p * options.edge_length;
        on_reference(&reference, &[], &[], to_caller, options, part)
    })
}

/// Meshes the minimal surface of these boundaries and computes the statistics.
pub(super) fn on_film(
    boundaries: &[Vec<DVec3>],
    options: &Options,
    execution: &Execution<'_>,
) -> Result<UniformMesh, Error> {
    let auxiliary = Auxiliary::of_film(boundaries, options, (0.0, 0.4), execution)?;
    let area = measure::area(&auxiliary.mesh);
    let flat = execution.part([0.4, 0.7], |part| flattened(&auxiliary, area, options, part));
    choose(Some(flat), auxiliary.warnings.clone(), options, execution, |part| {
        let reference = Reference::of_film(auxiliary.mesh.clone(), auxiliary.topology.clone(), &auxiliary.corners());
        on_reference(&reference, &auxiliary.exact, &auxiliary.inputs, |p| auxiliary.place(p), options, part)
    })
}

/// Chooses the mesh to return: the mesh made by flattening if it is good enough or if the deadline cut it short,
/// otherwise the mesh made on the surface itself.
fn choose(
    flat: Option<Result<(UniformMesh, bool), Error>>,
    warnings: Vec<Warning>,
    options: &Options,
    execution: &Execution<'_>,
    on_surface: impl FnOnce(&Execution) -> Result<(UniformMesh, bool), Error>,
) -> Result<UniformMesh, Error> {
    let flat = match flat {
        Some(Err(Error::Interrupted(interruption))) => return Err(Error::Interrupted(interruption)),
        Some(Ok((result, interrupted))) => {
            if interrupted || shortfall(&result, options).is_none() {
                return finish(result, interrupted, None, warnings, options, execution);
            }
            Some(result)
        }
        Some(Err(_)) | None => None,
    };
    let (result, interrupted) = match (execution.part([0.7, 0.99], on_surface), flat) {
        (Ok(made), _) => made,
        (Err(Error::Interrupted(Interruption::Cancelled)), _) => return Err(Interruption::Cancelled.into()),
        // No mesh could be made on the surface itself, so the mesh made by flattening is returned with its faults.
        (Err(error), Some(flat)) => (flat, matches!(error, Error::Interrupted(_))),
        (Err(error), None) => return Err(error),
    };
    let shortfall = shortfall(&result, options);
    finish(result, interrupted, shortfall, warnings, options, execution)
}

/// Meshes the domain on the surface itself. The second value says whether the deadline cut the work short. `exact`
/// holds vertices of the reference with their exact positions in the caller's coordinates. `inputs` holds the vertices
/// of the input's points. `at` maps a position to the caller's coordinates.
fn on_reference(
    reference: &Reference,
    exact: &[(u32, DVec3)],
    inputs: &[u32],
    at: impl Fn(DVec3) -> DVec3,
    options: &Options,
    execution: &Execution<'_>,
) -> Result<(UniformMesh, bool), Error> {
    let shares = matches!(options.optimise, Optimise::Lengths { .. });
    let optimise = options.optimise != Optimise::None;
    let end = if shares { 0.6 } else { 1.0 };
    let (mut nodes, stopped) = on_reference::mesh(reference, options.objective, optimise, (0.0, end), execution)?;
    let mut interrupted = deadline(stopped.map_or(Ok(()), Err))?;
    let mut table = Table::new(options);
    let stage = if optimise { "optimised_nodes" } else { "surface" };
    table.row(stage, &nodes.lengths(), Some(&nodes.lattice_group));
    let mut shared = Vec::new();
    if let Optimise::Lengths { most } = options.optimise
        && !interrupted
    {
        (shared, interrupted) = share(&mut nodes, most, &mut table, (end, 1.0), execution)?;
    }
    let surface_fit = compare(&nodes, reference.area, options.edge_length, Method::OnSurface);
    let mut vertices: Vec<DVec3> = nodes.positions.iter().map(|&p| at(p)).collect();
    let corner = |v: u32| nodes.parameters[..nodes.fixed].iter().position(|place| place.bond == Bond::Fixed(v));
    for &(v, position) in exact {
        if let Some(node) = corner(v) {
            vertices[node] = position;
        }
    }
    let input_vertices = inputs.iter().map(|&v| corner(v).map(|node| node as u32)).collect();
    let lengths = nodes.lengths();
    let OnSurface { triangles, members, lattice_group, parameters, .. } = nodes;
    let ends: Vec<[u32; 2]> = members.clone();
    let why = |member: usize| reference.why(ends[member].map(|v| parameters[v as usize]), lengths[member]);
    let mut result = assemble(Mesh::new(vertices, triangles), members, lattice_group, options, why);
    result.stages = table.stages;
    result.shared_lengths = shared;
    result.input_vertices = input_vertices;
    result.statistics.surface = Some(surface_fit);
    Ok((result, interrupted))
}

/// Meshes the domain by flattening: steps 2 to 5 of [`auxiliary`](super::surface::auxiliary). The second value says
/// whether the deadline cut the work short.
fn flattened(
    auxiliary: &Auxiliary,
    area: f64,
    options: &Options,
    execution: &Execution<'_>,
) -> Result<(UniformMesh, bool), Error> {
    let shares = matches!(options.optimise, Optimise::Lengths { .. });
    let auxiliary_edges = edges(&auxiliary.topology);
    let plane = laid_flat(auxiliary, &auxiliary_edges, execution)?;
    let locator = Rc::new(Locator::new(&plane, &auxiliary.mesh.triangles));
    let surface = auxiliary.surface(&plane, &locator);
    let mut boundaries: Vec<Boundary> = Vec::new();
    for &division in Division::candidates(options.objective) {
        boundaries.push(auxiliary.boundary(&plane, &surface, division, execution)?);
    }
    boundaries.dedup_by_key(|boundary| boundary.positions.len());
    let outlines: Vec<&Outline> = boundaries.iter().map(|boundary| &boundary.outline).collect();
    let meshed = mesh::mesh(&outlines, options.objective, (0.3, 0.6), execution);
    let (which, flat) = meshed.map_err(|failure| {
        let detail = "the surface folds over itself when it is laid into the plane: split it into several";
        match failure {
            Failure::Interrupted(interruption) => Error::Interrupted(interruption),
            Failure::InvalidConstraints(_) => Error::no_result(Reason::NotFlattenable, detail),
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
    let members = edges(&topology(positions.clone(), &flat.triangles)?);
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
        let (rebuilt, stopped) = fit(&mut nodes, options.transition, (0.6, middle), execution);
        interrupted = deadline(stopped.map_or(Ok(()), Err))?;
        if rebuilt {
            before = nodes.lengths();
        }
        table.row("optimised_nodes", &nodes.lengths(), Some(&nodes.lattice_group));
    }
    if let Optimise::Lengths { most } = options.optimise
        && !interrupted
    {
        let span = (middle, end);
        (shared, interrupted) = share(&mut nodes, most, &mut table, span, execution)?;
    }

    let surface_fit = compare(&nodes, area, options.edge_length, Method::Flattened);
    let mut vertices: Vec<DVec3> = nodes.positions.iter().map(|&p| auxiliary.place(p)).collect();
    for &(node, p) in &boundary.exact {
        vertices[node as usize] = p;
    }
    let OnSurface { triangles, members, lattice_group, .. } = nodes;
    let why = |member: usize| {
        short_in_plane(&boundary, members[member]).unwrap_or(match member {
            _ if flat.interrupted => Why::Unfinished,
            _ if is_in_range(before[member]) && !lattice_group[member] => Why::Optimised,
            _ => Why::Curvature,
        })
    };
    let mut result = assemble(Mesh::new(vertices, triangles), members.clone(), lattice_group.clone(), options, why);
    result.stages = table.stages;
    result.shared_lengths = shared;
    result.input_vertices = boundary.input_vertices;
    result.statistics.surface = Some(surface_fit);
    Ok((result, interrupted))
}

/// Flattens the auxiliary triangulation.
///
/// # Errors
/// [`Error::NoResult`] (`not_flattenable`) if the distortion is too large; the interruptions of `execution`.
fn laid_flat(auxiliary: &Auxiliary, edges: &[[u32; 2]], execution: &Execution<'_>) -> Result<Vec<DVec2>, Error> {
    let mut plane = auxiliary.start()?;
    execution.look(edges.len() as u64)?;
    let outcome = flatten::flatten(&auxiliary.mesh, edges, &mut plane, (0.0, 0.3), execution);
    if let Some(interruption) = outcome.interrupted {
        return Err(Error::Interrupted(interruption));
    }
    let strain = (2.0 * outcome.energy / edges.len() as f64).sqrt();
    let largest = if auxiliary.has_pole() { LARGEST_STRAIN_AT_A_POLE } else { LARGEST_STRAIN };
    if strain.is_nan() || strain > largest {
        let detail = "the surface cannot be laid into the plane with a bounded distortion";
        return Err(Error::no_result(Reason::NotFlattenable, detail));
    }
    Ok(plane)
}

/// The reason why a member between two boundary nodes is shorter than ℓ in the plane. `None` if it is not shorter. Only
/// these members can be short in the plane, because inserted nodes keep a distance of ℓ from all others.
fn short_in_plane(boundary: &Boundary, member: [u32; 2]) -> Option<Why> {
    let [a, b] = member.map(|v| boundary.outline.nodes.get(v as usize));
    let length = a?.distance(*b?);
    let why = || match boundary.sides.why(member, length, &boundary.outline.nodes) {
        // A sharp corner does not shorten the edges along its sides.
        Why::SharpCorner | Why::Narrow if boundary.sides.are_on_one(member) => Why::Curvature,
        why => why,
    };
    (length < 1.0 && !is_in_range(length)).then(why)
}

/// Runs [`share_lengths`] and adds its stage to the table. The second value says whether the deadline passed.
pub(super) fn share<S: Sheet>(
    nodes: &mut OnSurface<'_, S>,
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
