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

/// Returns true if more cases are to be run than in the first tier of `scripts/test`.
fn is_full() -> bool {
    ["PLATEAU_FULL", "PLATEAU_LONG"].into_iter().any(|name| std::env::var_os(name).is_some())
}
