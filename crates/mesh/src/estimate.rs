//! The cost of a solve, estimated before it starts.

/// The estimated size of a solve. A service can use it to price or refuse a request before any work is done.
///
/// Each kind of surface has a function `estimate` that returns this type and documents how exact its figures are. A
/// figure is zero if it does not apply to the kind of surface: only strips have grid cells.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct Estimate {
    /// Number of triangles of the result. It is not an integer, because a tiny edge length asks for more triangles than
    /// an integer can count.
    pub triangles: f64,
    /// Number of grid cells that the searches for strips visit.
    pub cells: u64,
    /// Peak memory of the solve in bytes, including the result and one copy of the result for a file.
    pub bytes: u64,
}
