//! Several processes on one database, some of which are killed.

mod cluster;
#[path = "../hold/mod.rs"]
mod hold;
mod instances;
mod kills;
#[path = "../postgres/mod.rs"]
mod postgres;
