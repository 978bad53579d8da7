//! Tests of tensile structures by the public interface of the crate.

mod cushions;
mod forces;
mod random_structures;
mod sliding_edges;
mod tensile_structures;
mod travelling;
