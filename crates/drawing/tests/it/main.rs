//! Tests of the drawings, against closed forms and against the mesh that was drawn.

#![allow(clippy::disallowed_methods, clippy::disallowed_types, clippy::disallowed_macros)]

mod astm;
mod faults;
mod files;
mod patterns;
mod samples;
mod schedules;
mod sheet_metal;
mod sheets;
