//! Solves the two planar problems of Katoh, Ohsaki and Xu for a domain whose boundary nodes are placed. Lengths are in
//! units of ℓ.

use super::increment::fill;
use super::lattice::{self, Boundary, Lattice, Placement};
use crate::options::Objective;
use plateau_mesh::DVec2;
use plateau_mesh::execution::{Execution, Interruption};
use plateau_mesh::plane::polygon;
use plateau_mesh::plane::triangulation::{Border, Constraint, InvalidConstraints, Triangulation};

/// The boundary nodes and the loops through them. Each loop has the domain on its left.
#[derive(Clone, Debug, Default)]
pub(crate) struct Outline {
    pub nodes: Vec<DVec2>,
    pub loops: Vec<Vec<u32>>,
}

impl Outline {
    pub fn pieces(&self) -> Vec<(u32, u32)> {
        let closing = |nodes: &Vec<u32>| -> Vec<(u32, u32)> {
            nodes.iter().copied().zip(nodes.iter().copied().cycle().skip(1)).collect()
        };
        self.loops.iter().flat_map(closing).collect()
    }

    /// The area inside the outer loop and outside the holes.
    pub fn area(&self) -> f64 {
        let loops = self.loops.iter().map(|nodes| nodes.iter().map(|&v| self.nodes[v as usize]));
        loops.map(|points| polygon::doubled_area(points, self.nodes[0])).sum::<f64>() / 2.0
    }
}

/// A triangulated domain. The nodes of the outline come first, then those of the lattice, then the inserted nodes.
#[derive(Clone, Debug)]
pub(crate) struct PlaneMesh {
    pub points: Vec<DVec2>,
    pub triangles: Vec<[u32; 3]>,
    pub lattice: Option<Placement>,
    /// True if the deadline passed. The mesh is then valid, but edges may still be longer than 2ℓ.
    pub interrupted: bool,
}

pub(crate) enum Failure {
    InvalidConstraints(InvalidConstraints),
    Interrupted(Interruption),
}

impl From<InvalidConstraints> for Failure {
    fn from(tangle: InvalidConstraints) -> Self {
        Self::InvalidConstraints(tangle)
    }
}

impl From<Interruption> for Failure {
    fn from(interruption: Interruption) -> Self {
        Self::Interrupted(interruption)
    }
}

/// Meshes the domain. The `outlines` differ in how the sides are divided. The outline on which the most lattice edges
/// fit is used, or the first one if no lattice edge fits on any. Also returns the index of the outline that was used.
/// The reported progress runs over `span`.
///
/// # Errors
/// [`Failure::InvalidConstraints`] if the outline crosses itself, or [`Failure::Interrupted`]. If the deadline passes
/// after the region has been triangulated, the valid mesh that was reached is returned instead.
pub(crate) fn mesh(
    outlines: &[&Outline],
    objective: Objective,
    span: (f64, f64),
    execution: &Execution<'_>,
) -> Result<(usize, PlaneMesh), Failure> {
    // The triangulation without inner nodes also detects outlines that cross, and holes on the wrong side.
    let mut region = region(outlines[0], execution)?;
    let mut interrupted = false;
    let middle = span.0 + 0.4 * (span.1 - span.0);
    let mut best: Option<(usize, usize, Placement)> = None;
    if objective == Objective::MostEqualEdges {
        for (which, outline) in outlines.iter().enumerate() {
            let progress = |k: usize| span.0 + (middle - span.0) * k as f64 / outlines.len() as f64;
            let pieces = outline.pieces();
            let boundary = Boundary { nodes: &outline.nodes, pieces: &pieces };
            match lattice::search(&boundary, (progress(which), progress(which + 1)), execution) {
                Ok(Some((edges, placement))) => {
                    if best.is_none_or(|(most, ..)| edges > most) {
                        best = Some((edges, which, placement));
                    }
                }
                Ok(None) => {}
                Err(interruption) => {
                    interrupted |= deadline(Err(interruption))?;
                    break;
                }
            }
        }
    }
    let Some((_, which, placement)) = best else {
        let expected = expected_nodes(outlines[0].area());
        if !interrupted {
            interrupted = deadline(fill(&mut region, expected, span, execution))?;
        }
        let mesh = PlaneMesh { points: region.points, triangles: region.corners, lattice: None, interrupted };
        return Ok((0, mesh));
    };
    let outline = outlines[which];
    let (pieces, fixed) = (outline.pieces(), outline.nodes.len() as u32);
    let lattice = lattice::place(&Boundary { nodes: &outline.nodes, pieces: &pieces }, placement);
    let Lattice { nodes, triangles, borders, .. } = lattice;
    let mut constraints = outline_constraints(&pieces);
    interrupted |= deadline(execution.look(nodes.len() as u64))?;
    // Only the border nodes of the lattice take part in the triangulation of the rim. For each node of the rim, `outer`
    // holds its number in the whole mesh.
    let mut outer: Vec<u32> = (0..fixed).collect();
    let mut points = outline.nodes.clone();
    let mut rim_number = vec![u32::MAX; nodes.len()];
    let mut in_rim = |v: u32, points: &mut Vec<DVec2>| {
        if rim_number[v as usize] == u32::MAX {
            rim_number[v as usize] = points.len() as u32;
            points.push(nodes[v as usize]);
            outer.push(fixed + v);
        }
        rim_number[v as usize]
    };
    for c in &borders {
        let (from, to) = (in_rim(c.from, &mut points), in_rim(c.to, &mut points));
        constraints.push(Constraint { from, to, border: c.border });
    }
    region = Triangulation::build(points, &constraints)?;
    let rim_area = outline.area() - 0.25 * 3f64.sqrt() * triangles.len() as f64;
    if !interrupted {
        interrupted = deadline(fill(&mut region, expected_nodes(rim_area) / 3, (middle, span.1), execution))?;
    }
    let (inserted, rim_fixed) = (fixed + nodes.len() as u32, outer.len());
    outer.extend((0..(region.points.len() - rim_fixed) as u32).map(|k| inserted + k));
    let mut points = outline.nodes.clone();
    points.extend_from_slice(&nodes);
    points.extend_from_slice(&region.points[rim_fixed..]);
    let mut all: Vec<[u32; 3]> = triangles.iter().map(|t| t.map(|v| fixed + v)).collect();
    all.extend(region.corners.iter().map(|t| t.map(|v| outer[v as usize])));
    Ok((which, PlaneMesh { points, triangles: all, lattice: Some(placement), interrupted }))
}

fn outline_constraints(pieces: &[(u32, u32)]) -> Vec<Constraint> {
    pieces.iter().map(|&(from, to)| Constraint { from, to, border: Border::Outline }).collect()
}

/// Triangulates the domain without any inner node.
fn region(outline: &Outline, execution: &Execution<'_>) -> Result<Triangulation, Failure> {
    let pieces = outline.pieces();
    execution.look(pieces.len() as u64)?;
    Ok(Triangulation::build(outline.nodes.clone(), &outline_constraints(&pieces))?)
}

/// Whether the deadline passed.
///
/// # Errors
/// The run was cancelled.
pub(crate) fn deadline(result: Result<(), Interruption>) -> Result<bool, Interruption> {
    match result {
        Ok(()) => Ok(false),
        Err(Interruption::DeadlinePassed) => Ok(true),
        Err(Interruption::Cancelled) => Err(Interruption::Cancelled),
    }
}

/// Number of nodes that farthest-point insertion is expected to place on an area in ℓ². Measured were 0.70 to 0.75
/// nodes per ℓ².
fn expected_nodes(area: f64) -> usize {
    (0.72 * area.max(0.0)) as usize
}
