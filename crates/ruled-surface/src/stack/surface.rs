//! The result of a solve.

use super::moving::MovedRails;
use super::options::DirectionCriterion;
use crate::pattern::FlatPattern;
use crate::strip::objective::{Objective, Secondary};
use crate::strip::statistics::{ConcaveBridge, Statistics};
use plateau_mesh::Mesh;
use plateau_mesh::error::Warning;

/// A triangulated stack of strips.
#[derive(Clone, Debug, PartialEq)]
#[non_exhaustive]
pub struct RuledSurface {
    /// The vertices are the directrices' points, directrix by directrix. The triangles come strip by strip along the
    /// path, then those of the caps.
    pub mesh: Mesh,
    /// Vertex pairs, strip by strip, from the first bridge to the last.
    pub bridges: Vec<[u32; 2]>,
    /// The vertices of each directrix, in the direction in which its strips run through it.
    pub directrices: Vec<Vec<u32>>,
    /// For each input point the index of its vertex. Merged points share a vertex; a resampled point names the nearest
    /// vertex along the directrix.
    pub input_vertices: Vec<Vec<u32>>,
    /// Which directrices [`Direction::Auto`](crate::Direction::Auto) reversed.
    pub reversed: Vec<bool>,
    /// For each directrix the criterion that decided its direction. `None` for the first directrix, for a directrix
    /// beside an apex, and if the directions are as given.
    pub direction_decided_by: Vec<Option<DirectionCriterion>>,
    /// Figures of the whole stack. Its numbers of triangles and its area include the caps; the other figures do not.
    pub statistics: Statistics,
    /// Figures of each strip.
    pub strips: Vec<Statistics>,
    /// The bridges that are not locally convex, in the order of [`bridges`](Self::bridges).
    pub concave_bridges: Vec<ConcaveBridge>,
    /// Table 1: the figures of the optimum of each objective, if
    /// [`Options::all_objectives`](crate::Options::all_objectives) is set.
    pub comparison: Option<Vec<Comparison>>,
    /// How far the points moved, if [`Options::rail_tolerance`](crate::Options::rail_tolerance) lets them.
    pub rails: Option<MovedRails>,
    /// The flat pattern. Closed strips are cut at their bridge of least fold.
    pub flat_pattern: FlatPattern,
    /// Facts about the input or the result that the caller should know.
    pub warnings: Vec<Warning>,
}

/// A row of Table 1.
#[derive(Clone, Debug, PartialEq)]
#[non_exhaustive]
pub struct Comparison {
    /// The objective that was minimised.
    pub objective: Objective,
    /// The secondary objective that decided among its optima.
    pub secondary: Option<Secondary>,
    /// Figures of the whole stack for that optimum.
    pub statistics: Statistics,
}
