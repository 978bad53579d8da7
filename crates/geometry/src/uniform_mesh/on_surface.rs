//! A curved domain, from its auxiliary triangulation to a measured mesh.

use super::edges::{edges, lengths, topology};
use super::measure::{Table, assemble, finish, is_in_range, lattice_group};
use super::options::{Optimise, Options};
use super::plane::mesh::{self, Failure, Outline, deadline};
use super::plane::sides::Division;
use super::report::{LengthsRow, UniformMesh, Why};
use super::surface::auxiliary::{Auxiliary, Boundary};
use super::surface::flatten;
use super::surface::lengths::share_lengths;
use super::surface::move_nodes::OnSurface;
use super::surface::transition::fit;
use crate::error::Error;
use crate::execution::Execution;
use crate::plane::location::Locator;
use crate::{DVec3, Mesh};
use std::rc::Rc;

/// Steps 2 to 5 of [`auxiliary`](super::surface::auxiliary); `from` is the progress made so far.
pub(super) fn on_surface(
    auxiliary: &Auxiliary,
    from: f64,
    options: &Options,
    execution: &Execution<'_>,
) -> Result<UniformMesh, Error> {
    let shares = matches!(options.optimise, Optimise::Lengths { .. });
    let at = |part: f64| from + (1.0 - from) * part;
    let auxiliary_edges = edges(&auxiliary.topology);
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
    let meshed = mesh::mesh(&outlines, options.objective, (at(0.3), at(0.6)), execution);
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
        let (rebuilt, stopped) = fit(&mut nodes, options.transition, (at(0.6), at(middle)), execution);
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

/// [`share_lengths`] with its row of the table; the second value says whether the deadline passed.
pub(super) fn share(
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
