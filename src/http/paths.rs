//! Paths that several modules must know.

/// Returns true for the paths to which Hops posts the values of a component: beside the component's address or, by
/// later versions, at the root of the host.
#[must_use]
pub fn is_message_of_hops(path: &str) -> bool {
    cfg!(feature = "hops") && matches!(path, "/solve" | "/hops/solve")
}
