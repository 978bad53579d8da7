//! Flat patterns: the strips of a surface in the plane.

pub(crate) mod flat_strip;
pub(crate) mod overlap;
pub(crate) mod unroll;

use crate::strip::Strip;
use flat_strip::FlatStrip;
use plateau_mesh::DVec3;
use plateau_mesh::error::{Error, Place};
use plateau_mesh::execution::Execution;
use plateau_mesh::measure::{angle, double_area_vector};
use unroll::unroll;

/// The strips of a surface laid flat, each piece in its own coordinates.
#[derive(Clone, Debug, Default, PartialEq)]
#[non_exhaustive]
pub struct FlatPattern {
    /// The pieces in the order of the stack. A strip that is cut has several, in the order of their bridges.
    pub strips: Vec<FlatStrip>,
    /// Largest |flat length - length| over all edges, divided by the longest edge of its piece.
    pub edge_length_error_max: f64,
    /// Whether two triangles of one piece overlap in the plane: such a piece cannot be cut from one sheet.
    pub self_overlap: bool,
    /// The width of the widest piece, in the caller's unit.
    pub width: f64,
    /// The sum of the heights of all pieces, in the caller's unit.
    pub height: f64,
}

/// Folds that differ by less than this angle in radians count as equal where the bridge of least fold is looked for.
/// Folds that are equal by symmetry differ by rounding, about 1e-15; a press brake is set to about 1e-3.
const EQUAL_FOLD: f64 = 1e-9;

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

    /// Returns the flat pattern of the surface that these bridges span. The bridges are pairs of indices into
    /// `vertices`. They run from the first to the last of each strip, one strip after another, as
    /// [`solve`](crate::solve) returns them. The pattern then equals that of `solve` to the bit.
    ///
    /// `cut_at` has numbers of bridges, counted from 0 over all strips, at which strips are cut. A closed strip opens
    /// at its first cut. Without one it opens at the bridge of least fold, the one with the lowest number among equals.
    /// Every other cut divides a strip into pieces.
    ///
    /// # Errors
    /// [`Error::Input`] at `bridges` if they are not those of strips, at `cut_at` for numbers that name no bridge, an
    /// end of an open strip, or a bridge twice, at `directrices` for what [`Strip::new`] refuses;
    /// [`Error::Interrupted`].
    pub fn of_bridges(
        vertices: &[DVec3],
        bridges: &[[u32; 2]],
        closed: bool,
        cut_at: &[u32],
        execution: &Execution<'_>,
    ) -> Result<Self, Error> {
        let refuse = |field: &'static str, detail: &str| Error::input(Place::field(field), detail);
        if bridges.iter().flatten().any(|&vertex| vertex as usize >= vertices.len()) {
            return Err(refuse("bridges", "must name vertices"));
        }
        let mut cuts = cut_at.to_vec();
        cuts.sort_unstable();
        if cuts.windows(2).any(|pair| pair[0] == pair[1]) {
            return Err(refuse("cut_at", "must not name a bridge twice"));
        }
        if let Some(&last) = cuts.last().filter(|&&last| last as usize >= bridges.len()) {
            return Err(refuse("cut_at", &format!("must name bridges below {}, not {last}", bridges.len())));
        }
        let mut strips = Vec::new();
        let mut first = 0;
        for (number, own) in strips_of(bridges).enumerate() {
            let numbers = first..first + own.len() as u32;
            let [from, to] = [numbers.start, numbers.end].map(|end| cuts.partition_point(|&cut| cut < end));
            let mut own_cuts: Vec<u32> = cuts[from..to].to_vec();
            let (start, length) = if closed {
                let opening = own_cuts.first().copied();
                (opening.unwrap_or_else(|| first + least_fold(vertices, own)), own.len() as u32)
            } else {
                (first, own.len() as u32 - 1)
            };
            let is_end = |cut: &u32| !closed && (*cut == first || *cut + 1 == numbers.end);
            if own_cuts.iter().any(is_end) {
                return Err(refuse("cut_at", "must not name an end of an open strip"));
            }
            // Positions along the strip, counted from its start.
            own_cuts.iter_mut().for_each(|cut| *cut -= start);
            own_cuts.retain(|&cut| cut != 0);
            own_cuts.push(length);
            let mut from = 0;
            for to in own_cuts {
                let path = (from..=to).map(|k| first + (start - first + k) % own.len() as u32).collect();
                strips.push(piece(vertices, bridges, number, path, execution)?);
                from = to;
            }
            first = numbers.end;
        }
        Ok(Self::of(strips))
    }
}

/// Returns the position of the bridge of a closed strip whose triangles enclose the smallest angle. Of bridges with
/// equal folds it is the first.
fn least_fold(vertices: &[DVec3], bridges: &[[u32; 2]]) -> u32 {
    let count = bridges.len();
    let normal = |k: usize| {
        let ([p, q], [next, other]) = (bridges[k], bridges[(k + 1) % count]);
        let third = if next == p { other } else { next };
        double_area_vector([p, third, q].map(|vertex| vertices[vertex as usize]))
    };
    let normals: Vec<DVec3> = (0..count).map(normal).collect();
    let folds: Vec<f64> = (0..count).map(|k| angle(normals[(k + count - 1) % count], normals[k])).collect();
    let least = folds.iter().copied().fold(f64::INFINITY, f64::min);
    folds.iter().position(|&fold| fold <= least + EQUAL_FOLD).unwrap_or_default() as u32
}

/// Unrolls the part of a strip that has the bridges with these numbers, in order.
fn piece(
    vertices: &[DVec3],
    bridges: &[[u32; 2]],
    strip: usize,
    numbers: Vec<u32>,
    execution: &Execution<'_>,
) -> Result<FlatStrip, Error> {
    let refuse = |detail: &str| Error::input(Place::field("bridges"), detail);
    let own: Vec<[u32; 2]> = numbers.iter().map(|&number| bridges[number as usize]).collect();
    let mut path = vec![[0, 0]];
    let (mut p, mut q) = (vec![vertices[own[0][0] as usize]], vec![vertices[own[0][1] as usize]]);
    for pair in own.windows(2) {
        match (pair[0][0] == pair[1][0], pair[0][1] == pair[1][1]) {
            (false, true) => p.push(vertices[pair[1][0] as usize]),
            (true, false) => q.push(vertices[pair[1][1] as usize]),
            _ => return Err(refuse("each bridge must share one end with the next one")),
        }
        path.push([(p.len() - 1) as u32, (q.len() - 1) as u32]);
    }
    let whole = Strip::new(p.as_slice().into(), q.as_slice().into(), false)?;
    let mut flat = unroll(&whole.0, &path, &whole.0.triangles_along(&path), execution)?;
    (flat.strip, flat.numbers) = (strip, numbers);
    Ok(flat)
}

/// Splits the bridges of a stack of strips into those of each strip. Neighbouring bridges of one strip share an
/// end point.
fn strips_of(bridges: &[[u32; 2]]) -> impl Iterator<Item = &[[u32; 2]]> {
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
