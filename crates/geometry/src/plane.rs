//! Plane geometry that every kind of mesh is built from: the frame of a loop, how flat its points are, polygons,
//! constrained Delaunay triangulations, and the search for the triangle that holds a point.

pub(crate) mod flatness;
pub(crate) mod frame;
pub(crate) mod location;
pub(crate) mod polygon;
pub(crate) mod triangulation;
