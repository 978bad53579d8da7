//! The two planar problems of Katoh, Ohsaki and Xu on a domain whose boundary nodes are placed; lengths in units of ℓ.

use super::Objective;
use super::increment::fill;
use super::lattice::{self, Boundary, Lattice, Placement};
use super::triangulation::{Border, Constraint, Tangle, Triangulation};
use crate::DVec2;
use crate::execution::{Execution, Interruption};

/// Boundary nodes and the loops through them, each with the domain on its left.
#[derive(Clone, Debug, Default)]
pub(super) struct Outline {
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

    /// Area inside the outer loop and outside the holes.
    pub fn area(&self) -> f64 {
        let twice: f64 = self
            .pieces()
            .iter()
            .map(|&(a, b)| (self.nodes[a as usize] - self.nodes[0]).perp_dot(self.nodes[b as usize] - self.nodes[0]))
            .sum();
        twice / 2.0
    }
}

/// A triangulated domain: the outline's nodes first, then the lattice's, then the inserted ones.
#[derive(Clone, Debug)]
pub(super) struct PlaneMesh {
    pub points: Vec<DVec2>,
    pub triangles: Vec<[u32; 3]>,
    pub lattice: Option<Placement>,
    /// Set if the deadline passed: the mesh is valid, but edges may still be longer than 2ℓ.
    pub interrupted: bool,
}

pub(super) enum Failure {
    Tangle(Tangle),
    Interrupted(Interruption),
}

impl From<Tangle> for Failure {
    fn from(tangle: Tangle) -> Self {
        Self::Tangle(tangle)
    }
}

impl From<Interruption> for Failure {
    fn from(interruption: Interruption) -> Self {
        Self::Interrupted(interruption)
    }
}

/// Meshes the domain. Progress runs over `span`.
///
/// # Errors
/// The outline's tangles, or the interruption. A passed deadline returns the valid mesh reached so far.
pub(super) fn mesh(
    outline: &Outline,
    objective: Objective,
    span: (f64, f64),
    execution: &Execution<'_>,
) -> Result<PlaneMesh, Failure> {
    let pieces = outline.pieces();
    let mut constraints: Vec<Constraint> =
        pieces.iter().map(|&(from, to)| Constraint { from, to, border: Border::Outline }).collect();
    execution.look(pieces.len() as u64)?;
    // Both problems start here: this is also what finds crossing outlines and holes on the wrong side.
    let mut region = Triangulation::build(outline.nodes.clone(), &constraints)?;
    let mut interrupted = false;
    let middle = span.0 + 0.4 * (span.1 - span.0);
    let lattice = match objective {
        Objective::FewestNodes => None,
        Objective::MostEqualEdges => {
            let boundary = Boundary { nodes: &outline.nodes, pieces: &pieces };
            let found = lattice::search(&boundary, (span.0, middle), execution);
            let found = match found {
                Ok(found) => found,
                Err(interruption) => {
                    interrupted |= deadline(Err(interruption))?;
                    None
                }
            };
            found.map(|placement| lattice::place(&boundary, placement))
        }
    };
    let fixed = outline.nodes.len() as u32;
    let Some(Lattice { placement, nodes, triangles, borders, .. }) = lattice else {
        let expected = expected_nodes(outline.area());
        if !interrupted {
            interrupted = deadline(fill(&mut region, expected, span, execution))?;
        }
        return Ok(PlaneMesh { points: region.points, triangles: region.corners, lattice: None, interrupted });
    };
    execution.look(nodes.len() as u64)?;
    // Only the lattice's border takes part in the rim; `outer` is a node's number in the whole mesh.
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
    Ok(PlaneMesh { points, triangles: all, lattice: Some(placement), interrupted })
}

/// Whether the deadline passed; a cancelled run is an error.
pub(super) fn deadline(result: Result<(), Interruption>) -> Result<bool, Interruption> {
    match result {
        Ok(()) => Ok(false),
        Err(Interruption::DeadlinePassed) => Ok(true),
        Err(Interruption::Cancelled) => Err(Interruption::Cancelled),
    }
}

/// How many nodes farthest-point insertion makes of an area in ℓ²: measured, about 0.70 to 0.75 a unit.
fn expected_nodes(area: f64) -> usize {
    (0.72 * area.max(0.0)) as usize
}
