//! The audit: measures every stated figure of a result again, from the arrays that the client gets.
//!
//! The measuring code shares nothing with the solvers. Each kind names its stated figures in its method
//! [`SolverInput::audit`](crate::solved::SolverInput::audit), and a result becomes a
//! [`Solved`](crate::solved::Solved) only if all of them agree. docs/audit.md has the tolerances.

pub(crate) mod comparison;
pub(crate) mod crossings;
pub(crate) mod curvature;
pub(crate) mod edges;
pub(crate) mod figure;
pub(crate) mod held;
pub(crate) mod points;
#[cfg(feature = "ruled-surface")]
pub(crate) mod strip;
pub(crate) mod surface;
pub(crate) mod topology;

#[cfg(test)]
mod tests;
