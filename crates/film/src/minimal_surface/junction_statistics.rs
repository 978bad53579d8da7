//! The figures of a film with junctions that other films do not have.

use plateau_mesh::measure::Spread;

/// Figures of a film with junctions.
#[derive(Clone, Debug, PartialEq)]
pub struct JunctionStatistics {
    /// Number of sheets: parts that are connected across edges of two triangles.
    pub sheets: usize,
    /// The curves along which three sheets meet, each as mesh vertices from end to end. A closed curve ends with its
    /// first vertex.
    pub curves: Vec<Vec<u32>>,
    /// Number of edges of three triangles.
    pub edges: usize,
    /// Number of vertices inside the film where such curves meet.
    pub points: usize,
    /// Length of all junctions.
    pub length: f64,
    /// Largest net force of the sheets across a junction, per length. It is 0 where the forces balance, and 1 for a
    /// single sheet. Dimensionless.
    pub residual: f64,
    /// Angles between neighbouring facets around the junction edges, in radians.
    pub facet_angles: Spread,
    /// Angles between the forces of neighbouring sheets at the inner vertices of the junctions, in radians.
    pub sheet_angles: Spread,
    /// Largest deviation of [`Self::sheet_angles`] from 120°, in radians, over the vertices that are not next to an end
    /// of their junction. If every vertex is next to an end, over all of them.
    pub largest_deviation: f64,
    /// Largest deviation at the vertices next to an end, where it may hardly decrease with the size of the mesh; 0 if
    /// there are none.
    pub largest_deviation_at_ends: f64,
    /// Mean deviation over all these vertices.
    pub mean_deviation: f64,
    /// Number of negative eigenvalues of the second variation. `None` if it was not computed, or if a number of
    /// junctions other than four meet in a point: the second variation includes the motions of the point, but not its
    /// splitting.
    pub morse_index: Option<usize>,
}
