//! The solvers, each after its paper. They work on a film of the full size.

pub(super) mod chen_cai_zheng;
pub(super) mod dirichlet;
pub(super) mod liu_wang;
pub(super) mod necks;
pub(super) mod newton;
pub(super) mod pinkall_polthier;
pub(super) mod unfolding;
