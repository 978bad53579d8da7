//! Plane geometry that every kind of mesh is built from: the frame of a loop, how flat its points are, polygons,
//! constrained Delaunay triangulations, and the search for the triangle that holds a point.

pub mod flatness;
pub mod frame;
pub mod location;
pub mod polygon;
pub mod triangulation;
