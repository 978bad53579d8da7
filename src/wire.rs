//! The JSON of the service itself: jobs, batches, the catalogue, the fields of a request that concern its job, and the
//! component schemas of the API document. `plateau_engine` has the requests and their results.

pub mod batch;
pub mod callback;
pub mod components;
pub mod envelope;
pub mod incoming;
pub mod job;
pub mod objectives;

#[cfg(test)]
mod wrong_values;
