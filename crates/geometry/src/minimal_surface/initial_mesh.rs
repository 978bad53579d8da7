//! The mesh that a solver starts from. It settles the topology of the result and, with several minimal surfaces on one
//! boundary, which of them comes out.

mod rings;
mod strip;

use super::film::Film;
use super::{InitialMesh, Options};
use crate::{DVec3, Error, Execution};

/// Which initial mesh was built.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum InitialMeshKind {
    Rings,
}

impl InitialMeshKind {
    #[must_use]
    pub fn name(self) -> &'static str {
        match self {
            Self::Rings => "rings",
        }
    }
}

/// A film between the boundaries (centred, without equal neighbours), and how it was made.
///
/// Its triangles run along the first boundary in the boundary's own direction.
///
/// # Errors
/// [`Error::Input`] for a resolution that these boundaries cannot have; the interruptions of `exec`.
pub(super) fn build(
    boundaries: &[Vec<DVec3>],
    options: &Options,
    exec: &Execution,
) -> Result<(Film, InitialMeshKind), Error> {
    let film = match options.initial_mesh {
        InitialMesh::Auto | InitialMesh::Rings => rings::build(boundaries, options.resolution, exec)?,
    };
    Ok((film, InitialMeshKind::Rings))
}
