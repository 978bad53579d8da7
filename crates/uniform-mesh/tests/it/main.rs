//! Tests of lattices on polygons, patches and films by the public interface of the crate.

mod once_wrong;
mod uniform_curved;
mod uniform_plane;
mod uniform_surface;
