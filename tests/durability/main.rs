//! Several processes on one database, some of which are killed or lose their connection to it.

mod boundaries;
mod cluster;
#[path = "../hold/mod.rs"]
mod hold;
mod instances;
mod kills;
mod lists;
mod outages;
#[path = "../postgres/mod.rs"]
mod postgres;
#[path = "../proxy/mod.rs"]
mod proxy;
#[path = "../skips/mod.rs"]
mod skips;
