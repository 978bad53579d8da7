//! Choices of a download in addition to the format of its file.

use plateau_mesh::DVec3;

use super::colors::Colors;
use crate::archive::{Contents, LineSet};

/// Point that the coordinates of a file are relative to.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, Hash)]
pub enum Origin {
    /// The client's zero, except in an STL file of a mesh that is too far from it for f32.
    #[default]
    Automatic,
    /// The client's zero.
    Given,
    /// The middle of the mesh's bounding box.
    Local,
}

/// Choices of a download in addition to its format.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Choices {
    pub origin: Origin,
    /// Whether the sets of lines (boundaries, cables, bridges) are written too. An STL file never has lines, and a PLY
    /// file has them only if the mesh has no triangles.
    pub lines: bool,
    /// Whether a PLY file is text.
    pub ascii: bool,
    /// Colours of a GLB, glTF or PLY file. `None` makes a neutral mesh.
    pub colors: Option<Colors>,
}

impl Default for Choices {
    fn default() -> Self {
        Self { origin: Origin::Automatic, lines: true, ascii: false, colors: None }
    }
}

impl Choices {
    /// Returns the vector that is subtracted from every coordinate.
    pub(super) fn shift(self, contents: &Contents) -> DVec3 {
        if self.origin == Origin::Local { contents.origin() } else { DVec3::ZERO }
    }

    pub(super) fn line_sets(self, contents: &Contents) -> &[LineSet] {
        if self.lines { &contents.line_sets } else { &[] }
    }
}
