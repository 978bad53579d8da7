//! Better meshes of a surface as it is. None of these moves a fixed vertex or removes a locked edge.

pub(crate) mod area_flips;
pub(crate) mod delaunay;
mod flips;
pub(crate) mod isotropic;
pub(crate) mod sheets;
pub(crate) mod small_angles;
pub(crate) mod subdivision;
pub(crate) mod thin_triangles;
