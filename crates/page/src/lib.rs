//! The crate `engine` as a WebAssembly module, for web pages and for Node.
//!
//! [`session::Session`] solves one request after the other and keeps the last result, from which it makes files. The
//! functions of the module that JavaScript calls (`exports`) only pass bytes to it. `js/plateau.mjs` calls them.

#![cfg_attr(test, allow(clippy::disallowed_methods, clippy::disallowed_types, clippy::disallowed_macros))]

pub mod session;

#[cfg(target_arch = "wasm32")]
mod exports;

#[cfg(doctest)]
#[doc = include_str!("../README.md")]
struct Readme;
