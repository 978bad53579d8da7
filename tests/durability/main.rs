//! Several processes on one database, some of which are killed.

mod cluster;
mod instances;
mod kills;
#[path = "../postgres/mod.rs"]
mod postgres;
