//! Components for Hops, the part of Grasshopper that sends geometry to servers. A designer types the address of a
//! component, and Hops asks the server for its inputs and outputs.
//!
//! [`component`] lists the components, and [`values`] reads the values that Hops sends for their inputs. [`recipe`]
//! builds an API request from these values, which is handled like any other request. [`answer`] builds the component's
//! outputs from the result.
//!
//! The messages have the forms of `src/hops/RemoteDefinition.cs` and `src/compute.geometry/IO/Schema.cs` in the
//! repository mcneel/compute.rhino3d, and of the Python package ghhops-server.

pub mod answer;
pub mod component;
pub mod envelope;
pub mod recipe;
pub mod values;

/// Reason why a message of Hops is not a request of a component. Each line names an input.
#[derive(Clone, Debug, PartialEq, Eq)]
pub enum HopsError {
    /// The body is not a message of Hops.
    Malformed(String),
    /// No component has this name.
    Unknown(String),
    /// The inputs are not those of the component. Hops then requests the component's description again.
    Outdated(Vec<String>),
    /// Values of the inputs cannot be used.
    Invalid(Vec<String>),
}
