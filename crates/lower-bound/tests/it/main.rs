//! Tests of proven lower bounds by the public interface of the crate.

#[path = "../../../minimal-surface/tests/it/boundaries/mod.rs"]
mod boundaries;
mod lower_bound;
