//! Isometric unrolling: a strip is a chain of triangles, so it flattens without changing an edge length.

use super::prepare::triangles_of;
use super::strip::Strip;
use crate::error::{Error, Place};
use crate::execution::Execution;
use crate::{DVec2, DVec3};

/// The strips of an open surface laid flat, each in its own coordinates.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct FlatPattern {
    pub strips: Vec<FlatStrip>,
    /// Largest |flat length - length| over all edges, divided by the longest edge of its strip.
    pub edge_length_error_max: f64,
    /// Whether two triangles of one strip overlap in the plane: such a strip cannot be cut from one sheet.
    pub self_overlap: bool,
    /// Of the strips side by side along y, in the caller's unit: the widest one, and all heights together.
    pub width: f64,
    pub height: f64,
}

/// One strip in the plane, its lower left corner at the origin, its longer extent mostly along x.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct FlatStrip {
    /// The two directrices' points, in order.
    pub p: Vec<DVec2>,
    pub q: Vec<DVec2>,
    /// Index pairs into `p` and `q`, first to last.
    pub bridges: Vec<[u32; 2]>,
    /// Index triples into `p` followed by `q`, all counter-clockwise: the strip's front, (p_i, p_{i+1}, q_j), faces up.
    pub triangles: Vec<[u32; 3]>,
    pub edge_length_error_max: f64,
    pub self_overlap: bool,
    pub width: f64,
    pub height: f64,
}

impl FlatStrip {
    /// The outline: along P, over the last bridge, back along Q.
    #[must_use]
    pub fn outline(&self) -> Vec<DVec2> {
        self.p.iter().chain(self.q.iter().rev()).copied().collect()
    }
}

impl FlatPattern {
    pub(super) fn of(strips: Vec<FlatStrip>) -> Self {
        Self {
            edge_length_error_max: strips.iter().fold(0.0, |max, strip| strip.edge_length_error_max.max(max)),
            self_overlap: strips.iter().any(|strip| strip.self_overlap),
            width: strips.iter().fold(0.0, |max, strip| strip.width.max(max)),
            height: strips.iter().map(|strip| strip.height).sum(),
            strips,
        }
    }

    /// The flat pattern of the open surface that these bridges span: pairs of `vertices`, first to last, one strip after
    /// another, as [`solve`](super::solve) gives them, and the same pattern to the bit.
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
            strips.push(unroll(&strip, &path, &triangles_of(&strip, &path), execution)?);
        }
        Ok(Self::of(strips))
    }
}

/// The bridges of a stack of open strips, strip by strip: within a strip one end stays from each bridge to the next.
pub fn strips_of(bridges: &[[u32; 2]]) -> impl Iterator<Item = &[[u32; 2]]> {
    bridges.chunk_by(|[p, q], [next, other]| p == next || q == other)
}

/// Flattens an open strip along its bridges and looks for overlaps. O(bridges log bridges) for patterns that are not folded
/// over themselves many times.
pub(super) fn unroll(
    strip: &Strip,
    path: &[[u32; 2]],
    triangles: &[[u32; 3]],
    execution: &Execution<'_>,
) -> Result<FlatStrip, Error> {
    let (p, q) = (&strip.p.points, &strip.q.points);
    let mut flat = FlatStrip {
        p: vec![DVec2::ZERO; p.len()],
        q: vec![DVec2::ZERO; q.len()],
        bridges: path.to_vec(),
        triangles: triangles.to_vec(),
        ..FlatStrip::default()
    };
    let length = p[0].distance(q[0]);
    let (mut a, mut b) = (DVec2::ZERO, DVec2::new(length, 0.0));
    (flat.p[0], flat.q[0]) = (a, b);
    let (mut direction, mut worst, mut longest) = (DVec2::X, 0.0f64, length);
    for (step, pair) in path.windows(2).enumerate() {
        let ([i, j], [next, other]) = (pair[0].map(|k| k as usize), pair[1].map(|k| k as usize));
        let by_p = next != i;
        let (from, to) = (p[i], q[j]);
        let new = if by_p { p[next] } else { q[other] };
        if b != a {
            direction = (b - a).normalize();
        }
        // From the end whose bank edge this is: the new bank edge, which is mostly the shortest side, is exact then.
        let origin = if by_p { from } else { to };
        let (along, height) = split(new - origin, to - from);
        let place = (if by_p { a } else { b }) + direction * along - direction.perp() * height;
        for (end, flat_end) in [(from, a), (to, b)] {
            let true_length = new.distance(end);
            longest = longest.max(true_length);
            worst = worst.max((place.distance(flat_end) - true_length).abs());
        }
        if by_p {
            flat.p[next] = place;
            a = place;
        } else {
            flat.q[other] = place;
            b = place;
        }
        if step % 4096 == 4095 {
            execution.look(4096)?;
        }
    }
    flat.edge_length_error_max = if longest > 0.0 { worst / longest } else { 0.0 };
    flat.straighten(strip.unit);
    flat.self_overlap = super::overlap::overlaps(&flat, execution)?;
    Ok(flat)
}

/// A vector's part along a bridge and its distance from the bridge's line.
fn split(v: DVec3, bridge: DVec3) -> (f64, f64) {
    let length = bridge.length();
    if length == 0.0 { (v.length(), 0.0) } else { (v.dot(bridge) / length, v.cross(bridge).length() / length) }
}

impl FlatStrip {
    /// Turns the line from the first bridge's middle to the last one's along x, moves the corner to the origin, scales.
    fn straighten(&mut self, unit: f64) {
        let middle = |[i, j]: [u32; 2]| self.p[i as usize].midpoint(self.q[j as usize]);
        let along = match (self.bridges.first(), self.bridges.last()) {
            (Some(&first), Some(&last)) => middle(last) - middle(first),
            _ => DVec2::X,
        };
        let turn = if along.length() > 0.0 { along.normalize() } else { DVec2::X };
        let points = self.p.iter_mut().chain(&mut self.q);
        let (mut low, mut high) = (DVec2::INFINITY, DVec2::NEG_INFINITY);
        for point in points {
            *point = DVec2::new(point.dot(turn), turn.perp_dot(*point));
            (low, high) = (low.min(*point), high.max(*point));
        }
        for point in self.p.iter_mut().chain(&mut self.q) {
            *point = (*point - low) * unit;
        }
        (self.width, self.height) = ((high.x - low.x) * unit, (high.y - low.y) * unit);
    }
}
