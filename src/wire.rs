//! The JSON of the service itself: jobs, batches, the catalogue, the fields of a request that concern its job, and the
//! component schemas of the API document. `plateau_engine` has the requests and their results.

pub mod batch;
pub mod callback;
pub mod components;
pub mod envelope;
mod glossary;
pub mod incoming;
pub mod job;
pub mod objectives;
pub mod problems;

#[cfg(test)]
mod wrong_values;
