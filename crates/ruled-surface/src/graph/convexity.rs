//! Local convexity of a bridge (definition 6, with the neighbour q_{j-1} that the definition leaves out). A bridge is
//! locally convex if it lies on the convex hull of itself and the neighbours of its end points. Equivalently, seen
//! along the bridge, the directions to the neighbours fit in a closed half-plane.
//!
//! A direction may lie outside the half-plane by `tolerance`, and in addition by the effect that rounding of the input
//! can have on the direction. With tolerance 0 the answer is exact (adaptive predicates on the input's own
//! coordinates).

use super::cell_counter::CellCounter;
use super::lanes::{Lanes, Vector};
use super::rails::{Rail, Rails};
use super::strip_arrays::{BandRows, StripArrays};
use super::sweep::{BitTable, Kernel, Region, Score, Seed, Workspace, sweep};
use super::weight::BridgeTriangle;
use plateau_mesh::DVec3;
use plateau_mesh::execution::Interruption;
use robust::{Coord, Coord3D, orient2d, orient3d};

/// The tolerance of the test for convexity.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(crate) enum ConvexityTest {
    Exact,
    /// The sine of the angle by which a direction may lie outside the half-plane.
    Within(f64),
}

impl ConvexityTest {
    /// Makes the test from an angle `tolerance` in radians. The test is exact if `tolerance` is 0.
    pub(crate) fn new(tolerance: f64) -> Self {
        if tolerance == 0.0 { Self::Exact } else { Self::Within(libm::sin(tolerance)) }
    }
}

/// Whether a bridge is locally convex; indices are cyclic on closed strips.
pub(crate) fn is_convex(rails: &Rails, [i, j]: [usize; 2], test: ConvexityTest) -> bool {
    let (i, j) = (i % rails.m(), j % rails.n());
    match test {
        ConvexityTest::Exact => is_convex_exactly(rails, i, j),
        ConvexityTest::Within(sine) => is_convex_within(rails, i, j, sine),
    }
}

fn neighbours(rails: &Rails, i: usize, j: usize) -> [Option<(bool, usize)>; 4] {
    let of_p = |before| rails.p.neighbour(i, before, rails.closed).map(|k| (true, k));
    let of_q = |before| rails.q.neighbour(j, before, rails.closed).map(|k| (false, k));
    [of_p(true), of_p(false), of_q(true), of_q(false)]
}

fn is_convex_exactly(rails: &Rails, i: usize, j: usize) -> bool {
    let (p, q) = (rails.p.raw[i], rails.q.raw[j]);
    let mut near = [DVec3::ZERO; 4];
    let mut count = 0;
    for (on_p, k) in neighbours(rails, i, j).into_iter().flatten() {
        let point = if on_p { rails.p.raw[k] } else { rails.q.raw[k] };
        if !collinear(p, q, point) || (p == q && point != p) {
            near[count] = point;
            count += 1;
        }
    }
    let near = &near[..count];
    if p == q {
        return is_on_hull(p, near);
    }
    let mut sign = [[0i8; 4]; 4];
    for a in 0..count {
        for b in a + 1..count {
            sign[a][b] = orientation(p, q, near[a], near[b]);
            sign[b][a] = -sign[a][b];
        }
    }
    fits_in_half_plane(count, |a, b| sign[a][b] >= 0, |a, b| sign[a][b] <= 0)
}

/// Whether there is a direction that has all others on its left, or all others on its right.
fn fits_in_half_plane(count: usize, left: impl Fn(usize, usize) -> bool, right: impl Fn(usize, usize) -> bool) -> bool {
    let others = |a: usize| (0..count).filter(move |&b| b != a);
    count <= 2 || (0..count).any(|a| others(a).all(|b| left(a, b)) || others(a).all(|b| right(a, b)))
}

/// Local convexity of a bridge whose end points coincide: the point is off the hull only if four neighbours surround
/// it.
fn is_on_hull(p: DVec3, near: &[DVec3]) -> bool {
    let &[a, b, c, d] = near else { return true };
    let signs = [orientation(p, b, c, d), -orientation(p, a, c, d), orientation(p, a, b, d), -orientation(p, a, b, c)];
    !(signs.iter().all(|&s| s > 0) || signs.iter().all(|&s| s < 0))
}

fn orientation(p: DVec3, q: DVec3, a: DVec3, b: DVec3) -> i8 {
    let coord = |v: DVec3| Coord3D { x: v.x, y: v.y, z: v.z };
    let determinant = orient3d(coord(p), coord(q), coord(a), coord(b));
    i8::from(determinant > 0.0) - i8::from(determinant < 0.0)
}

fn collinear(p: DVec3, q: DVec3, a: DVec3) -> bool {
    let flat = |u: usize, v: usize| {
        let coord = |point: DVec3| Coord { x: point[u], y: point[v] };
        orient2d(coord(p), coord(q), coord(a)) == 0.0
    };
    flat(0, 1) && flat(1, 2) && flat(2, 0)
}

fn is_convex_within(rails: &Rails, i: usize, j: usize, sine: f64) -> bool {
    let (bridge, rounding) = (Vector::<f64>::from(rails.bridge([i, j])), rails.rounding);
    let squared = bridge.dot(bridge);
    if squared.sqrt() <= rounding {
        return is_convex_exactly(rails, i, j);
    }
    let triangle = |side: &Rail, index: usize, step: usize| {
        let bank = side.bank(index, step, rails.closed);
        BridgeTriangle::new(Vector::<f64>::from(bank), bank.length_squared(), bridge, squared)
    };
    let triangles =
        [triangle(&rails.p, i, 0), triangle(&rails.q, j, 0), triangle(&rails.p, i, 1), triangle(&rails.q, j, 1)];
    fits_within(squared.sqrt(), &triangles, sine, rounding)
}

/// Whether the directions of the four bank edges at a bridge (arriving by P, by Q, leaving by P, by Q) fit in a
/// half-plane, with tolerance. A direction is ignored if its point is no further from the bridge's line than rounding,
/// or if the bank edge does not exist (zero vector).
#[inline(always)]
fn fits_within<V: Lanes>(length: V, triangles: &[BridgeTriangle<V>; 4], sine: f64, rounding: f64) -> V::Mask {
    let (rounding, zero) = (length.constant(rounding), length.constant(0.0));
    let nearest = rounding * length;
    let per_length = length.constant(2.0 * sine) / length;
    let far = [
        nearest.less(triangles[0].length),
        nearest.less(triangles[1].length),
        nearest.less(triangles[2].length),
        nearest.less(triangles[3].length),
    ];
    let near = [
        triangles[0].length.at_most(nearest),
        triangles[1].length.at_most(nearest),
        triangles[2].length.at_most(nearest),
        triangles[3].length.at_most(nearest),
    ];
    let mut fits = near[0] & near[1] & near[2] & near[3];
    // For each direction: whether all others lie to its left, and whether all lie to its right.
    let all = zero.at_most(zero);
    let (mut lefts, mut rights) = ([all; 4], [all; 4]);
    // The pairs are written out, because everything stays in registers if their indices are constants.
    macro_rules! pair {
        ($a:literal, $b:literal) => {
            let (first, second) = (&triangles[$a], &triangles[$b]);
            // `side` is the sine of the angle from direction a to direction b, times both distances from the bridge's
            // line, times the bridge's length. The direction of an arriving bank edge is the edge's opposite. The sign
            // of the sine may be wrong by the tolerance, and by rounding over distance for each of the two directions.
            let turn = second.bank.dot(first.normal);
            let side = if ($a < 2) == ($b < 2) { zero - turn } else { turn };
            let slack = per_length * first.length * second.length + rounding * (first.length + second.length);
            let (left, right) = ((zero - slack).at_most(side), side.at_most(slack));
            lefts[$a] = lefts[$a] & (left | near[$b]);
            rights[$a] = rights[$a] & (right | near[$b]);
            lefts[$b] = lefts[$b] & (right | near[$a]);
            rights[$b] = rights[$b] & (left | near[$a]);
        };
    }
    pair!(0, 1);
    pair!(0, 2);
    pair!(0, 3);
    pair!(1, 2);
    pair!(1, 3);
    pair!(2, 3);
    fits = fits | (far[0] & (lefts[0] | rights[0]));
    fits = fits | (far[1] & (lefts[1] | rights[1]));
    fits = fits | (far[2] & (lefts[2] | rights[2]));
    fits | (far[3] & (lefts[3] | rights[3]))
}

/// Returns which bridges of a path are locally convex: bit k is set if bridge k is. Lane k of `length` and of
/// `triangles` (arriving by P, by Q, leaving by P, by Q) belongs to bridge k.
#[inline(always)]
pub(crate) fn are_convex<V: Lanes>(
    rails: &Rails,
    bridges: &[[u32; 2]],
    test: ConvexityTest,
    length: V,
    triangles: &[BridgeTriangle<V>; 4],
) -> u32 {
    let (convex, exact) = match test {
        ConvexityTest::Exact => (0, (1 << bridges.len()) - 1),
        ConvexityTest::Within(sine) => (
            V::bits(fits_within(length, triangles, sine, rails.rounding)),
            V::bits(length.at_most(length.constant(rails.rounding))),
        ),
    };
    if exact == 0 { convex } else { exactly(rails, bridges, convex, exact) }
}

/// Repeats the test exactly for the bridges whose bits are set in `exact`.
#[cold]
fn exactly(rails: &Rails, bridges: &[[u32; 2]], mut convex: u32, exact: u32) -> u32 {
    for (lane, &[i, j]) in bridges.iter().enumerate() {
        if exact >> lane & 1 == 1 {
            convex = convex & !(1 << lane) | u32::from(is_convex_exactly(rails, i as usize, j as usize)) << lane;
        }
    }
    convex
}

/// Marks every bridge that is not locally convex, in a table that a sweep can read.
pub(crate) fn concave_bridges<V: Lanes>(
    rails: &Rails,
    (arrays, simd): (&StripArrays, V::Simd),
    test: ConvexityTest,
    counter: &mut CellCounter<'_, '_>,
) -> Result<BitTable, Interruption> {
    let (m, n, columns) = (rails.m(), rails.n(), arrays.columns);
    let region = Region::full(m, 0, columns - 1);
    if let ConvexityTest::Within(sine) = test {
        let mut workspace = Workspace::default();
        let map = ConcavityMap { simd, rails, arrays, sine };
        sweep::<V, _>(&map, columns, &region, (0, 0, Seed::Open), &mut workspace, counter)?;
        return Ok(workspace.table);
    }
    let mut table = BitTable::default();
    table.lay_out(&region, 1, V::WIDTH);
    for i in 0..m {
        for block in (0..n).step_by(4096) {
            let end = n.min(block + 4096);
            for j in block..end {
                if !is_convex_exactly(rails, i, j) {
                    table.set([i, j]);
                    if columns > n {
                        table.set([i, j + n]);
                    }
                }
            }
            // An exact test takes as long as a dozen cells of a sweep, but counts as one cell of the progress.
            counter.add((end - block) as u64)?;
        }
    }
    Ok(table)
}

/// A kernel that follows no paths. In place of back pointers its sweep stores one bit for each bridge: whether the
/// bridge is concave.
struct ConcavityMap<'a, S> {
    simd: S,
    rails: &'a Rails,
    arrays: &'a StripArrays,
    sine: f64,
}

impl<V: Lanes> Kernel<V> for ConcavityMap<'_, V::Simd> {
    const LAYERS: usize = 1;
    const CARRY: usize = 1;
    type Band = (usize, BandRows<V>);
    type State = ();
    #[inline(always)]
    fn simd(&self) -> V::Simd {
        self.simd
    }
    #[inline(always)]
    fn band(&self, band: usize) -> Self::Band {
        (band, self.arrays.band_rows(self.simd, band))
    }
    #[inline(always)]
    fn blank(&self) {}
    #[inline(always)]
    fn step(&self, (band, rows): &Self::Band, (): &mut (), _: &[f64], t: usize) -> u32 {
        let (_, squared, triangles) = self.arrays.triangles(rows, t);
        let length = squared.sqrt();
        let all = (1 << V::WIDTH) - 1;
        let concave = all & !V::bits(fits_within(length, &triangles, self.sine, self.rails.rounding));
        let vanishing = V::bits(length.at_most(length.constant(self.rails.rounding)));
        if vanishing == 0 { concave } else { self.without_length(band * V::WIDTH, t, concave, vanishing) }
    }
    #[inline(always)]
    fn keep(&self, (): &(), _: usize, _: &mut [f64]) {}
    fn unreached(&self, _: &mut [f64]) {}
    fn source(&self, _: usize, _: Seed, _: &mut [f64]) {}
    fn end(&self, _: &[f64], _: usize) -> Score {
        Score::WORST
    }
}

impl<S> ConcavityMap<'_, S> {
    /// Tests the bridges without length exactly, because they have no direction.
    #[cold]
    fn without_length(&self, first_row: usize, t: usize, mut concave: u32, vanishing: u32) -> u32 {
        let (m, n) = (self.rails.m(), self.rails.n());
        for lane in (0..32).filter(|lane| vanishing >> lane & 1 == 1) {
            // Lanes beyond the grid are never read.
            if first_row + lane < m && t >= lane {
                let bit = u32::from(!is_convex_exactly(self.rails, first_row + lane, (t - lane) % n));
                concave = concave & !(1 << lane) | bit << lane;
            }
        }
        concave
    }
}
