//! Turns the JSON of a request into statistics and an archive.
//!
//! [`Request::read`](request::Request::read) reads the bytes of a valid request straight into its type and checks it,
//! and [`Request::solve`](request::Request::solve) runs the solver. The types refuse what their published schemas
//! refuse (`plateau-strict-json`). After them come checks that a schema cannot express, such as too few distinct
//! points. The last checks are the geometry's own. Only a request that is refused becomes a JSON value and is compared
//! with its schema (`components`, `schema`), so that every error has a JSON Pointer and a text that says what the value
//! must be. Without the feature `explain` only the first wrong value is named.
//!
//! The crate does not know about jobs, stores, HTTP, clocks or threads. These belong to its hosts: the service, the
//! command line and a web page.

#![forbid(unsafe_code)]
#![cfg_attr(test, allow(clippy::disallowed_methods, clippy::disallowed_types, clippy::disallowed_macros))]
// Code that several kinds or features share is unused in a build with a few of them.
#![cfg_attr(
    not(all(
        feature = "cable-net",
        feature = "certificates",
        feature = "minimal-surface",
        feature = "ruled-surface",
        feature = "tensile-structure",
        feature = "uniform-mesh"
    )),
    allow(dead_code, unused_imports, unused_macros, unused_mut, unused_variables)
)]

mod audit;
pub mod blocks;
mod checked;
pub mod common;
#[cfg(feature = "explain")]
pub mod components;
#[cfg(any(feature = "minimal-surface", feature = "tensile-structure"))]
mod join;
pub mod kind;
pub mod kinds;
pub mod limits;
pub mod mesh;
pub mod options;
pub mod report;
pub mod request;
#[cfg(any(feature = "minimal-surface", feature = "tensile-structure"))]
pub mod resolution;
#[cfg(feature = "explain")]
pub mod schema;
pub mod solved;
pub mod source;

/// Revision of everything that makes a result of a request: the solvers, the defaults of requests, the statistics and
/// the warnings. Raise it by one with every change after which some request has another result, even if
/// `tests/frozen_examples.txt` does not show it: a host that keeps results then solves the request anew instead of
/// returning the result that it kept. `tests/it/frozen_examples.rs` fails if its rows change and the revision does not.
pub const SOLVER_REVISION: u32 = 22;

#[cfg(doctest)]
#[doc = include_str!("../README.md")]
struct Readme;
