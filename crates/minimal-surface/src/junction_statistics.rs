//! Statistics that only films with junctions have.

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
    /// Number of vertices inside the film where junctions meet.
    pub points: usize,
    /// Total length of the junctions.
    pub length: f64,
    /// Largest net force of the sheets across a junction, per length of the junction. Dimensionless, because the
    /// surface tension is 1. It is 0 where the forces balance, and 1 for a single sheet.
    pub residual: f64,
    /// Angles between neighbouring facets around the junction edges, in radians.
    pub facet_angles: Spread,
    /// Angles between the forces of neighbouring sheets, in radians, at the vertices inside the junctions.
    pub sheet_angles: Spread,
    /// Largest deviation of [`Self::sheet_angles`] from 120°, in radians, over the vertices that are not next to an end
    /// of their junction. If every vertex is next to an end, over all vertices. If no junction has a vertex inside,
    /// over [`Self::facet_angles`].
    pub largest_deviation: f64,
    /// Largest deviation of [`Self::sheet_angles`] from 120°, in radians, over the vertices next to an end of their
    /// junction. There the deviation may hardly decrease on finer meshes. 0 if there are no such vertices.
    pub largest_deviation_at_ends: f64,
    /// Mean deviation from 120°, in radians, of all [`Self::sheet_angles`], or of [`Self::facet_angles`] if no junction
    /// has a vertex inside.
    pub mean_deviation: f64,
    /// Number of negative eigenvalues of the second variation. `None` if it was not computed. Also `None` if a number
    /// of junctions other than four meet in a point, because the second variation includes the motions of the point,
    /// but not its splitting.
    pub morse_index: Option<usize>,
}
