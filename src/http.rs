//! HTTP: parses requests, calls `jobs` and writes responses. [`mcp`] offers the same operations as tools. Business
//! rules belong to `jobs`, and only [`problem`] knows the status codes of failures.

pub mod access;
pub mod assets;
pub mod body;
pub mod budget;
pub mod compress;
pub mod entry;
#[cfg(feature = "mcp")]
pub mod mcp;
pub mod negotiate;
pub mod observe;
pub mod open_requests;
pub mod openapi;
pub mod pace;
pub mod parameters;
pub mod paths;
pub mod problem;
pub mod resource;
pub mod router;
pub mod routes;
pub mod serve;
pub mod state;
