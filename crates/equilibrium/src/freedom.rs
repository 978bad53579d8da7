//! The ways in which a vertex may move.

/// The directions in which a vertex may move. There is one unknown for each direction.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub enum Freedom {
    /// In no direction.
    #[default]
    Fixed,
    /// Along the area-weighted normal of its triangles: one unknown. This is for vertices inside a sheet, where sliding
    /// within the sheet hardly changes the area and would ruin the triangles.
    Normal,
    /// At right angles to the curve on which it lies: two unknowns. The curve's direction there is from the first of
    /// these vertices to the second. This is for vertices inside a junction or a cable.
    Across([u32; 2]),
    /// Along the tangents of the support of this number: one unknown on a curve, two on a surface.
    On(u32),
    /// On a surface, at right angles to the edge of the film: one unknown. The edge's direction is from the first
    /// vertex of `beside` to the second. This is for an edge that slides on a surface, where sliding along the edge
    /// hardly changes the area and would ruin the triangles.
    AcrossOn {
        /// The number of the support.
        support: u32,
        /// The two neighbours of the vertex on the edge of the film.
        beside: [u32; 2],
    },
    /// Along the direction of the group of this number, by the same distance as all other vertices of the group. The
    /// whole group has one unknown. This is for a rigid ring that is guided along its axis.
    Together(u32),
    /// In every direction: three unknowns.
    Free,
}

impl Freedom {
    /// The number of the support on which the vertex moves, if any.
    #[must_use]
    pub fn support(self) -> Option<u32> {
        match self {
            Self::On(support) | Self::AcrossOn { support, .. } => Some(support),
            Self::Fixed | Self::Normal | Self::Across(_) | Self::Together(_) | Self::Free => None,
        }
    }
}
