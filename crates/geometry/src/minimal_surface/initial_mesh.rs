//! The mesh that a solver starts from. It settles the topology of the result and, with several minimal surfaces on one
//! boundary, which of them comes out.

mod lattice;
mod plane_mesh;
mod rings;
mod strip;

use super::film::Film;
use super::{InitialMesh, Objective, Options, Resolution, estimate_triangles, mean_curvature_lm};
use crate::{DVec3, Error, Execution, Place};

/// Which initial mesh was built.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum InitialMeshKind {
    Rings,
    Barycentres,
}

impl InitialMeshKind {
    #[must_use]
    pub fn name(self) -> &'static str {
        match self {
            Self::Rings => "rings",
            Self::Barycentres => "barycentres",
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
    let least_squares = options.objective == Objective::MinimalMeanCurvature && boundaries.len() == 1;
    if options.initial_mesh == InitialMesh::Barycentres || (options.initial_mesh == InitialMesh::Auto && least_squares)
    {
        return Ok((barycentres(boundaries, options, exec)?, InitialMeshKind::Barycentres));
    }
    let film = match options.initial_mesh {
        InitialMesh::Auto | InitialMesh::Barycentres | InitialMesh::Rings => {
            rings::build(boundaries, options.resolution, exec)?
        }
    };
    Ok((film, InitialMeshKind::Rings))
}

fn barycentres(boundaries: &[Vec<DVec3>], options: &Options, exec: &Execution) -> Result<Film, Error> {
    let [boundary] = boundaries else {
        return Err(Error::input(Place::field("initial_mesh"), "barycentres need exactly one boundary"));
    };
    let interior_vertices = match options.resolution {
        Resolution::InteriorVertices(count) => count,
        // A disk of m boundary points and n others has m + 2 n - 2 triangles.
        _ => ((estimate_triangles(boundaries, options) + 2.0 - boundary.len() as f64) / 2.0).round() as usize,
    };
    mean_curvature_lm::candidate_mesh(boundary, interior_vertices, options.seed, exec)
}
