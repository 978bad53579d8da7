//! Makes one welded mesh from the paths of a stack's strips.

use super::options::Options;
use super::prepare::{Directrix, Prepared};
use super::surface::RuledSurface;
use crate::graph::rails::Rails;
use crate::pattern::FlatPattern;
use crate::strip::statistics::Statistics;
use plateau_mesh::Mesh;
use plateau_mesh::error::Error;
use plateau_mesh::execution::Execution;

/// Welds all strips into one mesh. The caller fills in the statistics, the bridges that are not convex, the
/// comparison and the warnings.
pub(crate) fn assemble(
    prepared: &Prepared,
    strips: &[Rails],
    paths: &[Vec<[u32; 2]>],
    options: &Options,
    execution: &Execution<'_>,
) -> Result<RuledSurface, Error> {
    let mut vertices = Vec::new();
    for directrix in &prepared.directrices {
        let points = directrix.points.iter().copied();
        if directrix.reversed { vertices.extend(points.rev()) } else { vertices.extend(points) }
    }
    let mut triangles = Vec::with_capacity(2 * vertices.len());
    let mut bridges = Vec::with_capacity(2 * vertices.len());
    for (k, (strip, path)) in strips.iter().zip(paths).enumerate() {
        let local = strip.triangles_along(path);
        let (p, q) = (&prepared.directrices[k], &prepared.directrices[k + 1]);
        let m = strip.m() as u32;
        let vertex = |v: u32| if v < m { p.vertex(v as usize) } else { q.vertex((v - m) as usize) };
        triangles.extend(local.iter().map(|t| t.map(vertex)));
        bridges.extend(path.iter().map(|&[i, j]| [p.vertex(i as usize), q.vertex(j as usize)]));
    }
    let vertices_of = |directrix: &Directrix| (0..directrix.points.len()).map(|k| directrix.vertex(k)).collect();
    let input = |d: &Directrix| d.vertex_of.iter().map(|&v| (d.offset + v) as u32).collect();
    let flat_pattern = FlatPattern::of_bridges(&vertices, &bridges, options.closed, &[], execution)?;
    Ok(RuledSurface {
        mesh: Mesh::new(vertices, triangles),
        bridges,
        directrices: prepared.directrices.iter().map(vertices_of).collect(),
        input_vertices: prepared.directrices.iter().map(input).collect(),
        reversed: prepared.directrices.iter().map(|d| d.reversed).collect(),
        direction_decided_by: prepared.directrices.iter().map(|d| d.direction_decided_by).collect(),
        statistics: Statistics::default(),
        strips: Vec::new(),
        concave_bridges: Vec::new(),
        comparison: None,
        rails: None,
        flat_pattern,
        warnings: Vec::new(),
    })
}
