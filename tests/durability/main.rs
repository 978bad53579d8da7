//! Several processes on one database, and what becomes of jobs when some of them die.

mod cluster;
mod instances;
mod kills;
#[path = "../postgres/mod.rs"]
mod postgres;
