//! Methods that improve the mesh of a surface. None of them moves a fixed vertex or removes a locked edge.

pub mod area_flips;
pub mod delaunay;
pub mod flips;
pub mod isotropic;
pub mod moving;
pub mod passes;
pub mod sheets;
pub mod sliding;
pub mod small_angles;
pub mod subdivision;
pub mod thin_triangles;
