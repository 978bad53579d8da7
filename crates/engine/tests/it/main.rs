//! Tests of requests from their JSON to their statistics and archives.

#![allow(
    clippy::disallowed_macros,
    clippy::disallowed_methods,
    clippy::disallowed_types,
    clippy::too_many_lines,
    reason = "tests"
)]

mod cases;
mod closed_forms;
mod exported_meshes;
mod frozen_examples;
mod joining;
mod mutated_requests;
mod options;
#[path = "../../../archive/tests/it/sample.rs"]
mod sample;
#[path = "../../../../tests/skips/mod.rs"]
mod skips;
mod tensile_cases;

use plateau_engine::limits::Limits;
use plateau_engine::request::Request;
use plateau_engine::solved::{Signal, Solved, Unsolved};
use plateau_engine::source::no_jobs;
use plateau_strict_json::json;
use plateau_strict_json::rejection::Rejection;
use std::path::{Path, PathBuf};

/// Limits of a server with default settings.
const LIMITS: Limits = Limits {
    points: 200_000,
    triangles: 2_000_000,
    grid_cells: 2_000_000_000,
    iterations: 1_000_000,
    memory_bytes: 4 << 30,
};

/// Reads a request that names its own kind.
fn read(body: &[u8]) -> Result<Request, Rejection> {
    Request::read_with_kind(&json::parse(body)?, &no_jobs, &LIMITS).map(|accepted| accepted.request)
}

/// Largest allowed number of elementary operations between two checks of the cancel signal. `cargo bench -p
/// plateau-engine --bench audit` prints how long the work between two checks takes.
const MOST_WORK: u64 = 2_000_000;

/// Solves a request, and demands that its solver asks for the signal often enough.
fn solve(request: &Request) -> Result<Solved, Unsolved> {
    let (result, work) = request.solve_and_count(&|| Signal::Continue, &|_| {});
    assert!(work <= MOST_WORK, "{work} operations between two looks at the signal");
    result
}

/// Returns the folder of the repository.
fn root() -> PathBuf {
    Path::new(env!("CARGO_MANIFEST_DIR")).join("../..")
}

/// Returns true if more cases are to be run than in the first tier of `scripts/test`.
fn is_full() -> bool {
    ["PLATEAU_FULL", "PLATEAU_LONG"].into_iter().any(|name| std::env::var_os(name).is_some())
}
