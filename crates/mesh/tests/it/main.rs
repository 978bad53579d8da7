//! Tests of meshes by the public interface of the crate.

mod self_intersections;
