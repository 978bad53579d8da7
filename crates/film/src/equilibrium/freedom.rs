//! The ways in which a vertex may move.

/// The directions in which a vertex may move. There is one unknown for each direction.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub enum Freedom {
    /// Not at all.
    #[default]
    Fixed,
    /// Along the area-weighted normal of its triangles: one unknown. This is for vertices inside a sheet, where sliding
    /// within the sheet hardly changes the area and would ruin the triangles.
    Normal,
    /// Across the curve through it, which runs from the first of these vertices to the second: two unknowns. This is
    /// for vertices inside a junction or a cable.
    Across([u32; 2]),
    /// On the support of this number: one unknown on a curve, two on a surface.
    On(u32),
    /// On a surface, across the edge of the film that runs from the first of these vertices to the second: one unknown.
    /// This is for an edge that slides on a surface, where sliding along the edge hardly changes the area and would
    /// ruin the triangles.
    AcrossOn {
        /// The number of the support.
        support: u32,
        /// The neighbours on the film's edge.
        beside: [u32; 2],
    },
    /// Along the direction of the group of this number, by the same distance as all other vertices of the group: one
    /// unknown for the whole group. This is for a rigid ring that is guided along its axis.
    Together(u32),
    /// Anywhere: three unknowns.
    Free,
}

impl Freedom {
    /// The number of the vertex's support.
    #[must_use]
    pub fn support(self) -> Option<u32> {
        match self {
            Self::On(support) | Self::AcrossOn { support, .. } => Some(support),
            Self::Fixed | Self::Normal | Self::Across(_) | Self::Together(_) | Self::Free => None,
        }
    }
}
