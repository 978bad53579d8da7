//! HTTP: parses, asks `jobs`, answers. No business rule lives here, and only [`problem`] knows the status codes of failures.

pub mod auth;
pub mod body;
pub mod negotiate;
pub mod observe;
pub mod openapi;
pub mod problem;
pub mod router;
pub mod routes;
pub mod serve;
