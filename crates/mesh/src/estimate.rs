//! The cost of a solve, estimated before any of the work.

/// The size of a solve, so that a service can price a request or refuse it before the work.
///
/// Each kind of surface has a function `estimate` that returns this type and says how exact its figures are. A figure
/// is zero where the kind does not know it: only strips search grids.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct Estimate {
    /// Number of triangles of the result. It is not an integer, because a tiny edge length asks for more triangles than
    /// an integer can count.
    pub triangles: f64,
    /// Number of grid cells that the searches for strips visit.
    pub cells: u64,
    /// Number of bytes of memory at the peak of the solve, with the result and one copy of the result for a file.
    pub bytes: u64,
}
