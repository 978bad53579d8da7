//! Paths that several modules must know.

/// Returns true for the paths to which Hops posts the values of a component: beside the component's address or, by
/// later versions, at the root of the host. Beside an address that ends in a slash is `/hops/minimal-surface/solve`.
#[must_use]
pub fn is_message_of_hops(path: &str) -> bool {
    let beside = || path.strip_prefix("/hops/")?.strip_suffix("/solve");
    let is_beside = || beside().is_some_and(|component| !component.is_empty() && !component.contains('/'));
    cfg!(feature = "hops") && (matches!(path, "/solve" | "/hops/solve") || is_beside())
}
