//! Reads JSON into types that accept exactly what their JSON Schemas accept, and explains what is refused.
//!
//! [`strict`] reads bytes or values into a type. The types refuse what their published schemas refuse, for which
//! [`bounds`] has numbers, texts and lists. [`json`] parses bytes into a value. Only what is refused is compared with
//! its schema (`explain`), so that every error has a JSON Pointer and a text that says what the value must be.

#![forbid(unsafe_code)]
#![cfg_attr(test, allow(clippy::disallowed_methods, clippy::disallowed_types, clippy::disallowed_macros))]

pub mod bounds;
#[cfg(feature = "explain")]
pub mod explain;
pub mod json;
pub mod rejection;
pub mod strict;

#[cfg(doctest)]
#[doc = include_str!("../README.md")]
struct Readme;
