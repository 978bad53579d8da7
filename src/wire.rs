//! What the service says and hears beside the requests and results of `plateau_forms`: jobs, batches, the catalogue,
//! the fields of a request that concern its job, and the component schemas of the API document.

pub mod batch;
pub mod callback;
pub mod components;
pub mod envelope;
pub mod incoming;
pub mod job;
pub mod objectives;

#[cfg(test)]
mod wrong_values;
