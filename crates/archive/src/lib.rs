//! The stored form of a result, and the files that are made from its mesh.
//!
//! A solver's result is stored once, in f64, as an [`Archive`]. Every download is made from it, so that two formats of
//! one job never disagree. Every function here is pure: the same archive gives the same bytes.
//!
//! This crate does not know about kinds of requests, jobs or HTTP. It depends on `plateau-mesh` and on the division
//! of bridges into strips.

#![forbid(unsafe_code)]
#![cfg_attr(test, allow(clippy::disallowed_methods, clippy::disallowed_types, clippy::disallowed_macros))]

pub mod archive;
pub mod formats;
pub mod glb;
pub mod units;
pub mod zip;

pub use archive::{Archive, Attribute, Contents, Defect, LineSet, Lines, Polyline};
