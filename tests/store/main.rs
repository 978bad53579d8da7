//! Tests of the store: its promises on both engines, and faults of the network between it and PostgreSQL.

mod contract;
mod faults;
#[path = "../postgres/mod.rs"]
mod postgres;
#[path = "../proxy/mod.rs"]
mod proxy;
#[path = "../skips/mod.rs"]
mod skips;
