//! The result of a search: the bound, and the fields that prove it.

use super::symmetry::{Axes, Mirror};
use plateau_mesh::DVec3;

/// The field that proves a bound for one orientation of the boundary, or for several.
#[derive(Clone, Debug, PartialEq)]
#[non_exhaustive]
pub struct Field {
    /// The boundary, oriented.
    pub loops: Vec<Vec<DVec3>>,
    /// Numbers of the loops of which the direction does not matter: the magnitude of the circulation around them is
    /// subtracted from the bound.
    pub free_loops: Vec<usize>,
    /// Every oriented surface with this oriented boundary has at least this area.
    pub area_lower_bound: f64,
    /// The axes of the following coordinates, if they differ from those of the loops.
    pub axes: Option<Axes>,
    /// Opposite corners of the box. The low corner lies in the planes of symmetry.
    pub corners: [DVec3; 2],
    /// Planes at which the box and the field are reflected. The boundary lies in the box and its mirror images.
    pub mirrors: Vec<Mirror>,
    /// Corners of the tetrahedra.
    pub vertices: Vec<DVec3>,
    /// Vertices of each tetrahedron; the tetrahedra fill the box.
    pub tetrahedra: Vec<[u32; 4]>,
    /// The edges [i, j], i < j.
    pub edges: Vec<[u32; 2]>,
    /// The circulation along each edge, from i to j.
    pub edge_values: Vec<f64>,
    /// The faces [i, j, k], i < j < k.
    pub faces: Vec<[u32; 3]>,
    /// The coefficients of λk w_ij and λi w_jk of each face, where w_ij = λi ∇λj - λj ∇λi.
    pub face_values: Vec<[f64; 2]>,
    /// Outward directions of half-spaces that contain the boundary and its mirror images: d·x is at most the largest
    /// d·p of their points p.
    pub half_spaces: Vec<DVec3>,
    /// Tetrahedra that lie beyond a half-space, each with the number of that half-space. There the curl may have any
    /// length.
    pub unconstrained: Vec<[u32; 2]>,
}

/// A proven lower bound.
#[derive(Clone, Debug, PartialEq)]
#[non_exhaustive]
pub struct LowerBound {
    /// No oriented surface of any topology with this boundary has a smaller area, in whichever direction it runs along
    /// each loop.
    pub area: f64,
    /// Each orientation of the loops belongs to one of the fields; reversing all loops gives the same orientation. The
    /// bound is the least of their bounds.
    pub fields: Vec<Field>,
    /// Number of steps of Newton's method of all searches together.
    pub iterations: u32,
    /// Nominal seconds to which the work amounts.
    pub seconds: f64,
    /// Whether a deadline of the caller ended the search.
    pub interrupted: bool,
    /// 1 - |curl A · n| at each vertex of the film, 0 to 1, for the orientation with the least bound. Where it is large
    /// the bound is not tight.
    pub slack: Vec<f64>,
}
