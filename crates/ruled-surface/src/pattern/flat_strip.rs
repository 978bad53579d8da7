//! A strip laid flat.

use plateau_mesh::DVec2;

/// A strip in the plane, or a part of one. Its lower left corner is at the origin, and its middle line runs roughly
/// along x.
#[derive(Clone, Debug, Default, PartialEq)]
#[non_exhaustive]
pub struct FlatStrip {
    /// Number of its strip in the stack.
    pub strip: usize,
    /// For each of `bridges` its number, counted from 0 over all strips. A closed strip that is cut at one bridge
    /// starts and ends with this bridge.
    pub numbers: Vec<u32>,
    /// The points of the first directrix, in order.
    pub p: Vec<DVec2>,
    /// The points of the second directrix, in order.
    pub q: Vec<DVec2>,
    /// The bridges from first to last, as pairs of an index into `p` and an index into `q`.
    pub bridges: Vec<[u32; 2]>,
    /// Triples of indices into the list of `p` followed by `q`. All triangles are counter-clockwise, so that the front
    /// of the strip, (p_i, p_{i+1}, q_j), faces up.
    pub triangles: Vec<[u32; 3]>,
    /// Largest |flat length - length| over all edges, divided by the longest edge.
    pub edge_length_error_max: f64,
    /// Whether two triangles overlap in the plane.
    pub self_overlap: bool,
    /// Extent along x.
    pub width: f64,
    /// Extent along y.
    pub height: f64,
}

impl FlatStrip {
    /// Returns the outline: along P, over the last bridge, back along Q.
    #[must_use]
    pub fn outline(&self) -> Vec<DVec2> {
        self.p.iter().chain(self.q.iter().rev()).copied().collect()
    }

    /// Turns the strip so that the line from the middle of the first bridge to that of the last lies along x, moves its
    /// lower left corner to the origin, and scales it by `unit`.
    pub(crate) fn straighten(&mut self, unit: f64) {
        let middle = |[i, j]: [u32; 2]| self.p[i as usize].midpoint(self.q[j as usize]);
        let along = match (self.bridges.first(), self.bridges.last()) {
            (Some(&first), Some(&last)) => middle(last) - middle(first),
            _ => DVec2::X,
        };
        let turn = if along.length() > 0.0 { along.normalize() } else { DVec2::X };
        let points = self.p.iter_mut().chain(&mut self.q);
        let (mut low, mut high) = (DVec2::INFINITY, DVec2::NEG_INFINITY);
        for point in points {
            *point = DVec2::new(point.dot(turn), turn.perp_dot(*point));
            (low, high) = (low.min(*point), high.max(*point));
        }
        for point in self.p.iter_mut().chain(&mut self.q) {
            *point = (*point - low) * unit;
        }
        (self.width, self.height) = ((high.x - low.x) * unit, (high.y - low.y) * unit);
    }
}
