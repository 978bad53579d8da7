//! Flat patterns: the strips of an open surface in the plane.

pub(crate) mod flat_strip;
pub(crate) mod overlap;
pub(crate) mod unroll;

use crate::strip::Strip;
use flat_strip::FlatStrip;
use plateau_mesh::DVec3;
use plateau_mesh::error::{Error, Place};
use plateau_mesh::execution::Execution;
use unroll::unroll;

/// The strips of an open surface laid flat, each in its own coordinates.
#[derive(Clone, Debug, Default, PartialEq)]
#[non_exhaustive]
pub struct FlatPattern {
    /// The strips in the order of the stack.
    pub strips: Vec<FlatStrip>,
    /// Largest |flat length - length| over all edges, divided by the longest edge of its strip.
    pub edge_length_error_max: f64,
    /// Whether two triangles of one strip overlap in the plane: such a strip cannot be cut from one sheet.
    pub self_overlap: bool,
    /// The width of the widest strip, in the caller's unit.
    pub width: f64,
    /// The sum of the heights of all strips, in the caller's unit.
    pub height: f64,
}

impl FlatPattern {
    pub(crate) fn of(strips: Vec<FlatStrip>) -> Self {
        Self {
            edge_length_error_max: strips.iter().fold(0.0, |max, strip| strip.edge_length_error_max.max(max)),
            self_overlap: strips.iter().any(|strip| strip.self_overlap),
            width: strips.iter().fold(0.0, |max, strip| strip.width.max(max)),
            height: strips.iter().map(|strip| strip.height).sum(),
            strips,
        }
    }

    /// Returns the flat pattern of the open surface that these bridges span. The bridges are pairs of indices into
    /// `vertices`. They run from the first to the last of each strip, one strip after another, as
    /// [`solve`](crate::solve) returns them. The pattern then equals that of `solve` to the bit.
    ///
    /// # Errors
    /// [`Error::Input`] at `bridges` if they are not those of strips, at `directrices` for what [`Strip::new`] refuses;
    /// [`Error::Interrupted`].
    pub fn of_bridges(vertices: &[DVec3], bridges: &[[u32; 2]], execution: &Execution<'_>) -> Result<Self, Error> {
        let refuse = |detail: &str| Error::input(Place::field("bridges"), detail);
        if bridges.iter().flatten().any(|&vertex| vertex as usize >= vertices.len()) {
            return Err(refuse("must name vertices"));
        }
        let mut strips = Vec::new();
        for bridges in strips_of(bridges) {
            let mut path = vec![[0, 0]];
            let (mut p, mut q) = (vec![vertices[bridges[0][0] as usize]], vec![vertices[bridges[0][1] as usize]]);
            for pair in bridges.windows(2) {
                match (pair[0][0] == pair[1][0], pair[0][1] == pair[1][1]) {
                    (false, true) => p.push(vertices[pair[1][0] as usize]),
                    (true, false) => q.push(vertices[pair[1][1] as usize]),
                    _ => return Err(refuse("must not repeat a bridge")),
                }
                path.push([(p.len() - 1) as u32, (q.len() - 1) as u32]);
            }
            let strip = Strip::new(p.as_slice().into(), q.as_slice().into(), false)?;
            strips.push(unroll(&strip.0, &path, &strip.0.triangles_along(&path), execution)?);
        }
        Ok(Self::of(strips))
    }
}

/// Splits the bridges of a stack of open strips into those of each strip. Neighbouring bridges of one strip share an
/// end point.
pub fn strips_of(bridges: &[[u32; 2]]) -> impl Iterator<Item = &[[u32; 2]]> {
    bridges.chunk_by(|[p, q], [next, other]| p == next || q == other)
}

#[cfg(test)]
mod tests {
    use super::overlap::{TOLERANCE, runs_along_x, some_pair_overlaps};
    use super::*;
    use crate::strip::objective::Objective;

    #[test]
    fn a_strip_that_runs_along_x_has_no_pair_that_overlaps() {
        let rail = |count: usize, radius: f64, turns: f64, wave: f64| -> Vec<DVec3> {
            let point = |k: usize| {
                let u = k as f64 / (count - 1) as f64;
                let (sine, cosine) = libm::sincos(turns * std::f64::consts::TAU * u);
                let radius = radius + wave * libm::sin(9.0 * u);
                DVec3::new(radius * cosine, radius * sine, wave * libm::cos(7.0 * u + radius))
            };
            (0..count).map(point).collect()
        };
        let execution = Execution::default();
        let (mut plain, mut unclear, mut overlapping) = (0, 0, 0);
        for case in 0..300 {
            let (turns, wave) = (0.005 * f64::from(case + 5), 0.04 * f64::from(case % 7));
            let rails = [rail(23 + case as usize % 5, 2.0, turns, wave), rail(31, 1.5, turns, wave)];
            let strip = Strip::new(rails[0].as_slice().into(), rails[1].as_slice().into(), false).unwrap();
            let path = strip.optimal_path(Objective::MinimalArea, None, 0.0, &execution).unwrap();
            let flat = &unroll(&strip.0, &path, &strip.0.triangles_along(&path), &execution).unwrap();
            let tolerance = TOLERANCE * flat.width.max(flat.height);
            let overlaps = some_pair_overlaps(flat, tolerance, &execution).unwrap();
            if runs_along_x(flat, tolerance) {
                assert!(!overlaps, "case {case}");
                plain += 1;
            } else if overlaps {
                overlapping += 1;
            } else {
                unclear += 1;
            }
        }
        assert!(plain > 30 && overlapping > 30 && unclear > 0, "{plain} {unclear} {overlapping}");
    }
}
