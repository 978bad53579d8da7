//! Turns the JSON of a request into statistics and an archive.
//!
//! [`Body::read`](body::Body::read) reads the JSON strictly, [`Request::read`](request::Request::read) checks it, and
//! [`Request::solve`](request::Request::solve) runs the solver. Every error has a JSON Pointer, and a text that says what the
//! value must be ([`explain`]). The schemas that the service publishes are made from the same types
//! ([`components`]), and bodies are validated against them before serde reads them ([`schema`]). After the schema come
//! checks that a schema cannot express, such as too few distinct points. The last checks are the geometry's own.
//!
//! The crate knows no job, no store, no HTTP, no clock and no thread. The service, the command line and a web page are
//! its hosts.

#![forbid(unsafe_code)]

pub mod blocks;
pub mod body;
mod checked;
pub mod common;
pub mod components;
pub mod explain;
pub mod json;
pub mod kind;
pub mod kinds;
pub mod limits;
pub mod mesh;
pub mod rejection;
pub mod report;
pub mod request;
pub mod resolution;
pub mod schema;
pub mod solved;

#[cfg(doctest)]
#[doc = include_str!("../README.md")]
struct Readme;
