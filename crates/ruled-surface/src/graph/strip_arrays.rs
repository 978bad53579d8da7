//! The two directrices of a strip as arrays of numbers, in the order in which a sweep reads them.

use super::lanes::{Lanes, MOST_LANES, Vector};
use super::rails::{Rail, Rails};
use super::weight::{BendingLaw, BridgeTriangle};
use plateau_mesh::DVec3;

/// The strip as arrays of numbers for the sweep. Columns are stored backwards, so that the lanes of a skewed band (row
/// r one column behind row r - 1) read adjacent entries. `MARGIN` more entries at both ends hold finite numbers. Lanes
/// read these entries, but no path uses them.
#[derive(Debug)]
pub(crate) struct StripArrays {
    pub(crate) rows: usize,
    /// Number of columns: n on an open strip. It is 2n on a closed strip, where a path that starts in column j ends in
    /// column j + n.
    pub(crate) columns: usize,
    pub(crate) row: RailNumbers,
    pub(crate) column: RailNumbers,
    pub(crate) bending: BendingLaw,
}

/// Number of entries beyond either end of a row of numbers: the largest number of lanes that can lie beyond an end.
const MARGIN: usize = MOST_LANES;

/// Quantities along one directrix. Each component of a quantity is a row of `stride` numbers, and `numbers` holds all
/// rows one after the other.
#[derive(Debug)]
pub(crate) struct RailNumbers {
    stride: usize,
    numbers: Vec<f64>,
}

/// The points. This constant and the following ones are the first row of each quantity in a [`RailNumbers`].
pub(crate) const POINT: usize = 0;
/// The bank edge that ends at the point; zero where there is none.
pub(crate) const BANK: usize = 3;
pub(crate) const BANK_SQUARED: usize = 6;
pub(crate) const TANGENT: usize = 7;
pub(crate) const NORMAL: usize = 10;

impl RailNumbers {
    /// Stores the quantities in the order of `order`. Each item is the index of a point and whether a bank edge ends
    /// there.
    fn new(
        directrix: &Rail,
        order: impl ExactSizeIterator<Item = (usize, bool)> + Clone,
        closed: bool,
        with_tangents: bool,
    ) -> Self {
        let (stride, points, normals) = (order.len(), &directrix.points, &directrix.normals);
        let rows = match (with_tangents, normals.is_empty()) {
            (_, false) => NORMAL + 3,
            (true, true) => NORMAL,
            (false, true) => TANGENT,
        };
        let mut numbers = vec![0.0; rows * stride];
        let mut put = |row: usize, of: &mut dyn Iterator<Item = DVec3>| {
            let (x, rest) = numbers[row * stride..].split_at_mut(stride);
            let (y, rest) = rest.split_at_mut(stride);
            for (((x, y), z), v) in x.iter_mut().zip(y).zip(rest).zip(of) {
                [*x, *y, *z] = v.to_array();
            }
        };
        put(POINT, &mut order.clone().map(|(at, _)| points[at]));
        let bank = |(at, exists): (usize, bool)| match (exists, at) {
            (false, _) => DVec3::ZERO,
            (true, 0) => directrix.bank(0, 0, closed),
            (true, _) => points[at] - points[at - 1],
        };
        put(BANK, &mut order.clone().map(bank));
        if with_tangents {
            let tangents = directrix.tangents(closed);
            put(TANGENT, &mut order.clone().map(|(at, _)| tangents[at]));
        }
        if !normals.is_empty() {
            put(NORMAL, &mut order.clone().map(|(at, _)| normals[at]));
        }
        let (banks, squared) = numbers.split_at_mut(BANK_SQUARED * stride);
        for (k, squared) in squared[..stride].iter_mut().enumerate() {
            let component = |axis: usize| banks[(BANK + axis) * stride + k];
            *squared = DVec3::new(component(0), component(1), component(2)).length_squared();
        }
        Self { stride, numbers }
    }

    #[inline(always)]
    pub(crate) fn vector<V: Lanes>(&self, simd: V::Simd, row: usize, at: usize) -> Vector<V> {
        Vector::new(self.number(simd, row, at), self.number(simd, row + 1, at), self.number(simd, row + 2, at))
    }

    /// Loads the lanes that start at a position of a row. Tangents and normals are stored only for kernels that read
    /// them.
    #[inline(always)]
    pub(crate) fn number<V: Lanes>(&self, simd: V::Simd, row: usize, at: usize) -> V {
        let start = row * self.stride + at;
        V::load(simd, &self.numbers[start..start + V::WIDTH])
    }
}

/// Reads the lanes at one position of a rail, and at the position before it, from the first `ROWS` rows of the rail.
/// The bounds of all reads are checked when the window is made, because a check at each of the 22 reads of a step took
/// a twelfth of the time of a strip of least bending energy.
#[derive(Clone, Copy)]
struct Window<'a, V: Lanes, const ROWS: usize> {
    simd: V::Simd,
    /// At least `ROWS * stride` numbers, where `1 <= at` and `at + V::WIDTH <= stride`.
    numbers: &'a [f64],
    stride: usize,
    at: usize,
}

impl RailNumbers {
    /// Panics if a lane lies beyond either end of a row, or if there are fewer than `ROWS` rows.
    #[inline(always)]
    fn window<V: Lanes, const ROWS: usize>(&self, simd: V::Simd, at: usize) -> Window<'_, V, ROWS> {
        let Self { stride, ref numbers } = *self;
        let inside = at >= 1 && at < stride && stride - at >= V::WIDTH;
        assert!(inside && numbers.len() >= ROWS.saturating_mul(stride));
        Window { simd, numbers, stride, at }
    }
}

impl<V: Lanes, const ROWS: usize> Window<'_, V, ROWS> {
    /// `BEFORE` is 0 for the window's position, and 1 for the position before it.
    #[inline(always)]
    fn vector<const BEFORE: usize>(&self, row: usize) -> Vector<V> {
        Vector::new(self.number::<BEFORE>(row), self.number::<BEFORE>(row + 1), self.number::<BEFORE>(row + 2))
    }

    #[allow(unsafe_code, reason = "a check of the bounds in the innermost loop")]
    #[inline(always)]
    fn number<const BEFORE: usize>(&self, row: usize) -> V {
        const { assert!(BEFORE <= 1) };
        assert!(row < ROWS);
        let start = row * self.stride + self.at - BEFORE;
        // SAFETY: `BEFORE <= at`, `row < ROWS` and `at + V::WIDTH <= stride`, so the range begins inside its row and
        // ends at `ROWS * stride` at the latest. `RailNumbers::window` has checked these bounds and that there are at
        // least `ROWS * stride` numbers.
        V::load(self.simd, unsafe { self.numbers.get_unchecked(start..start + V::WIDTH) })
    }
}

impl StripArrays {
    /// Objectives that read tangents need `with_tangents`.
    pub(crate) fn new(rails: &Rails, with_tangents: bool) -> Self {
        let (rows, n, closed) = (rails.m(), rails.n(), rails.closed);
        let columns = if closed { 2 * n } else { n };
        // Entry `rows` has the edge that leaves the last row. The entries after it are never used and only have to be
        // finite.
        let down = (0..rows + 2 * MARGIN).map(|k| {
            let index = if closed { k % rows } else { k.min(rows - 1) };
            (index, closed || (k > 0 && k < rows))
        });
        let back = (0..columns + 2 * MARGIN).rev().map(|k| {
            let c = k as isize - MARGIN as isize;
            let exists = closed || (c > 0 && c < columns as isize);
            let index = if closed {
                (c + (MARGIN * n) as isize) as usize % n
            } else {
                c.clamp(0, columns as isize - 1) as usize
            };
            (index, exists)
        });
        Self {
            rows,
            columns,
            row: RailNumbers::new(&rails.p, down, closed, with_tangents),
            column: RailNumbers::new(&rails.q, back, closed, with_tangents),
            bending: rails.bending,
        }
    }

    /// Position in a column array at which the lanes of step `t` start: lane r has column t - r.
    #[inline(always)]
    pub(crate) fn at(&self, t: usize) -> usize {
        self.columns + MARGIN - 1 - t
    }
}

/// The points of a band's rows, and the bank edges that arrive at these points and leave them.
#[derive(Clone, Copy)]
pub(crate) struct BandRows<V> {
    pub(crate) number: usize,
    point: Vector<V>,
    banks: [(Vector<V>, V); 2],
}

impl StripArrays {
    #[inline(always)]
    pub(crate) fn band_rows<V: Lanes>(&self, simd: V::Simd, band: usize) -> BandRows<V> {
        let (row, at) = (&self.row, band * V::WIDTH);
        BandRows {
            number: band,
            point: row.vector(simd, POINT, at),
            banks: [
                (row.vector(simd, BANK, at), row.number(simd, BANK_SQUARED, at)),
                (row.vector(simd, BANK, at + 1), row.number(simd, BANK_SQUARED, at + 1)),
            ],
        }
    }

    /// Returns the bridges of step `t`, their squared lengths and their four triangles: arriving by P, by Q, leaving by
    /// P, by Q.
    #[inline(always)]
    pub(crate) fn triangles<V: Lanes>(&self, rows: &BandRows<V>, t: usize) -> (Vector<V>, V, [BridgeTriangle<V>; 4]) {
        let (simd, at) = (rows.point.x.simd(), self.at(t));
        // The columns are stored backwards, so the entry before a column's entry belongs to the next column.
        let column: Window<'_, V, TANGENT> = self.column.window(simd, at);
        let bridge = column.vector::<0>(POINT).minus(rows.point);
        let squared = bridge.dot(bridge);
        let in_p = BridgeTriangle::new(rows.banks[0].0, rows.banks[0].1, bridge, squared);
        let in_q = BridgeTriangle::new(column.vector::<0>(BANK), column.number::<0>(BANK_SQUARED), bridge, squared);
        let out_p = BridgeTriangle::new(rows.banks[1].0, rows.banks[1].1, bridge, squared);
        let out_q = BridgeTriangle::new(column.vector::<1>(BANK), column.number::<1>(BANK_SQUARED), bridge, squared);
        (bridge, squared, [in_p, in_q, out_p, out_q])
    }
}
