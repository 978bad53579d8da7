//! The result of a search: the bound, and the fields that prove it.

use super::symmetry::{Axes, Mirror};
use plateau_mesh::DVec3;

/// The field that proves a bound for one orientation of the boundary, or for several.
#[derive(Clone, Debug, PartialEq)]
#[non_exhaustive]
pub struct Field {
    /// The loops of the boundary, oriented.
    pub loops: Vec<Vec<DVec3>>,
    /// Numbers of the loops whose direction is left open. The magnitude of the field's circulation around them is
    /// subtracted from the bound, so that the bound holds for either direction.
    pub free_loops: Vec<usize>,
    /// Every oriented surface with this oriented boundary has at least this area.
    pub area_lower_bound: f64,
    /// The axes of all following coordinates, if they differ from the axes of the loops.
    pub axes: Option<Axes>,
    /// Opposite corners of the box. The low corner lies in the planes of symmetry.
    pub corners: [DVec3; 2],
    /// Planes of symmetry, at which the box and the field are reflected. The boundary lies in the box and its mirror
    /// images.
    pub mirrors: Vec<Mirror>,
    /// Vertices of the tetrahedra.
    pub vertices: Vec<DVec3>,
    /// Vertices of each tetrahedron; the tetrahedra fill the box.
    pub tetrahedra: Vec<[u32; 4]>,
    /// The edges [i, j], i < j.
    pub edges: Vec<[u32; 2]>,
    /// The circulation along each edge, from i to j.
    pub edge_values: Vec<f64>,
    /// The faces [i, j, k], i < j < k.
    pub faces: Vec<[u32; 3]>,
    /// The coefficients of the basis functions λk w_ij and λi w_jk of each face, where w_ij = λi ∇λj - λj ∇λi and λ are
    /// the barycentric coordinates.
    pub face_values: Vec<[f64; 2]>,
    /// Outward directions d of half-spaces that contain the boundary and its mirror images. A half-space consists of
    /// the points x for which d·x is at most the largest d·p of a point p of the boundary or its mirror images.
    pub half_spaces: Vec<DVec3>,
    /// Tetrahedra that lie outside a half-space, each with the number of that half-space. The curl may have any length
    /// there.
    pub unconstrained: Vec<[u32; 2]>,
}

/// A proven lower bound.
#[derive(Clone, Debug, PartialEq)]
#[non_exhaustive]
pub struct LowerBound {
    /// No oriented surface with this boundary has a smaller area, whatever its topology, and in whichever direction it
    /// runs along each loop.
    pub area: f64,
    /// The fields that prove the bound. Each orientation of the loops belongs to one of the fields; reversing all loops
    /// counts as the same orientation. `area` is the least of the fields' bounds.
    pub fields: Vec<Field>,
    /// Total number of Newton steps in all searches.
    pub iterations: u32,
    /// The work that was done, in nominal seconds.
    pub seconds: f64,
    /// Whether a deadline of the caller ended the search.
    pub interrupted: bool,
    /// 1 - |curl A · n| at each vertex of the film, from 0 to 1, for the orientation with the least bound. Large values
    /// show where the bound is not tight.
    pub slack: Vec<f64>,
}
