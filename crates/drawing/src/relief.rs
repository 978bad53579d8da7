//! Relief of bends that meet at a point of a rail: a circle that is cut out of the blank.
//!
//! The outline is a ring of points, so that a circle replaces the points inside it without a look at the others. Each
//! point is removed at most once, so that the reliefs of a whole strip take O(n log n) time.

use crate::columns::Columns;
use crate::parameters::Refused;
use crate::piece::{Edge, Piece};
use crate::polygon;
use plateau_mesh::DVec2;
use std::collections::BTreeMap;

/// A point in which several bends meet.
pub(crate) struct Fan {
    /// Middle of the opening that the bends leave at the point.
    pub(crate) centre: DVec2,
    /// Corners of the panels between the bends.
    pub(crate) corners: Vec<DVec2>,
}

/// Ratio of a relief circle to the opening that the circle takes. It is above 1, so that rounding decides nothing.
const WIDER: f64 = 1.001;
/// Longest chord error of a relief circle in millimetres: below the width of any cut.
const RELIEF_CHORD: f64 = 0.005;

/// Cuts circles of this radius out of the piece of a blank at the points in which bends meet, and ends its folds and
/// the sides of its zones there. With `only_overlaps` only those are cut at which the outline crosses itself, and each
/// is at least as large as the opening, so that both of its sides end on it. Otherwise an opening that reaches beyond
/// its circle stays as it is.
///
/// # Errors
/// Returns [`Refused::Unsuitable`] at `relief` for a circle that leaves nothing of the outline.
pub(crate) fn relieve(
    piece: &mut Piece,
    zones: &mut [[[DVec2; 2]; 2]],
    fans: &[Fan],
    radius: f64,
    only_overlaps: bool,
) -> Result<(), Refused> {
    let mut ring = Ring::new(&piece.outline, &piece.edges, fans);
    let mut circles: Vec<Circle> = Vec::new();
    for (number, fan) in fans.iter().enumerate() {
        let opening = fan.corners.iter().map(|corner| corner.distance(fan.centre)).fold(0.0, f64::max);
        if only_overlaps && !ring.overlaps_at(number) {
            continue;
        }
        let radius = if only_overlaps { radius.max(WIDER * opening) } else { radius };
        if opening >= radius {
            continue;
        }
        let circle = Circle { centre: fan.centre, radius };
        let Some(corner) = ring.corner(number) else { continue };
        if !ring.cut(corner, &circle) {
            let detail = format!("a circle of {radius} mm does not fit into {}", piece.name);
            return Err(Refused::unsuitable("relief", detail));
        }
        circles.push(circle);
    }
    (piece.outline, piece.edges) = ring.points();
    let columns =
        Columns::new(circles.iter().map(|circle| [-1.0, 1.0].map(|side| circle.centre.x + side * circle.radius)));
    for ends in piece.folds.iter_mut().map(|fold| &mut fold.ends).chain(zones.iter_mut().flatten()) {
        trim(ends, &circles, &columns);
    }
    Ok(())
}

struct Circle {
    centre: DVec2,
    radius: f64,
}

impl Circle {
    fn contains(&self, point: DVec2) -> bool {
        point.distance(self.centre) < self.radius
    }

    /// Returns the point at which the segment from a point outside to one inside enters the circle.
    fn entered(&self, outside: DVec2, inside: DVec2) -> Option<DVec2> {
        let (along, from) = (inside - outside, outside - self.centre);
        let (a, b, c) = (along.length_squared(), from.dot(along), from.length_squared() - self.radius * self.radius);
        let root = (b * b - a * c).max(0.0).sqrt();
        let at = (-b - root) / a;
        (0.0..=1.0).contains(&at).then(|| outside + along * at)
    }

    /// Returns the points of the circle from one of its points clockwise to another.
    fn arc(&self, enter: DVec2, leave: DVec2) -> Vec<DVec2> {
        let angle = |point: DVec2| libm::atan2(point.y - self.centre.y, point.x - self.centre.x);
        let mut sweep = angle(enter) - angle(leave);
        if sweep <= 0.0 {
            sweep += std::f64::consts::TAU;
        }
        let step = 2.0 * libm::acos(1.0 - (RELIEF_CHORD / self.radius).min(1.0));
        let steps = (sweep / step).ceil().clamp(2.0, 400.0);
        let between = (1..steps as usize).map(|k| {
            let (sine, cosine) = libm::sincos(angle(enter) - sweep * k as f64 / steps);
            self.centre + DVec2::new(cosine, sine) * self.radius
        });
        std::iter::once(enter).chain(between).chain([leave]).collect()
    }
}

/// A point of an outline with the edge that starts there.
#[derive(Clone, Copy)]
struct Corner {
    point: DVec2,
    edge: Edge,
    before: usize,
    next: usize,
    is_removed: bool,
    /// Number of the fan of which it is a corner.
    fan: Option<usize>,
}

/// A closed outline whose points can be replaced. The piece lies on its left.
struct Ring {
    corners: Vec<Corner>,
    /// For each fan its corners.
    of_fans: Vec<Vec<usize>>,
}

impl Ring {
    fn new(outline: &[DVec2], edges: &[Edge], fans: &[Fan]) -> Self {
        let count = outline.len();
        let corner = |k: usize| Corner {
            point: outline[k],
            edge: edges[k],
            before: (k + count - 1) % count,
            next: (k + 1) % count,
            is_removed: false,
            fan: None,
        };
        let mut corners: Vec<Corner> = (0..count).map(corner).collect();
        // The corners of the fans are copies of the outline's points.
        let key = |point: DVec2| point.to_array().map(f64::to_bits);
        let places: BTreeMap<[u64; 2], usize> =
            outline.iter().enumerate().rev().map(|(k, &point)| (key(point), k)).collect();
        let mut of_fans = vec![Vec::new(); fans.len()];
        for (number, fan) in fans.iter().enumerate() {
            for place in fan.corners.iter().filter_map(|&corner| places.get(&key(corner))) {
                corners[*place].fan = Some(number);
                of_fans[number].push(*place);
            }
        }
        Self { corners, of_fans }
    }

    /// Returns a corner of a fan that is still there.
    fn corner(&self, fan: usize) -> Option<usize> {
        self.of_fans[fan].iter().copied().find(|&corner| !self.corners[corner].is_removed)
    }

    /// Whether the outline crosses itself at the mouth of the opening of a fan.
    fn overlaps_at(&self, fan: usize) -> bool {
        let Some(corner) = self.corner(fan) else { return false };
        // The corners follow each other around the outline. The mouth has two edges more on both sides: across the last
        // zone, and along the rail.
        let is_own = |corner: &usize| self.corners[*corner].fan == Some(fan);
        let around = |step: fn(&Corner) -> usize| {
            let mut at = corner;
            std::iter::from_fn(move || {
                at = step(&self.corners[at]);
                Some(at)
            })
        };
        let length = self.of_fans[fan].len();
        let side = |step: fn(&Corner) -> usize| {
            let own = around(step).take(length).take_while(is_own).count();
            around(step).take(own + 2).map(|corner| self.corners[corner].point).collect::<Vec<_>>()
        };
        let mut mouth = side(|corner| corner.before);
        mouth.reverse();
        mouth.push(self.corners[corner].point);
        mouth.extend(side(|corner| corner.next));
        polygon::chain_meets_itself(&mouth)
    }

    /// Replaces the points inside a circle around a corner by the circle. Returns false if the outline lies in the
    /// circle but for one point or less.
    fn cut(&mut self, corner: usize, circle: &Circle) -> bool {
        let is_inside = |corner: usize| circle.contains(self.corners[corner].point);
        let (mut from, mut to) = (corner, corner);
        while is_inside(from) {
            from = self.corners[from].before;
            if from == corner {
                return false;
            }
        }
        while is_inside(to) {
            to = self.corners[to].next;
        }
        if from == to {
            return false;
        }
        let point = |corner: usize| self.corners[corner].point;
        let (first, last) = (self.corners[from].next, self.corners[to].before);
        let enter = circle.entered(point(from), point(first));
        let leave = circle.entered(point(to), point(last));
        let (Some(enter), Some(leave)) = (enter, leave) else { return false };
        // Clockwise, because the piece lies on the left.
        let arc = circle.arc(enter, leave);
        let [starting, ending] = [from, last].map(|corner| {
            let edge = self.corners[corner].edge;
            Edge { arc: [edge.arc[1]; 2], ..edge }
        });
        let mut at = first;
        while at != to {
            self.corners[at].is_removed = true;
            at = self.corners[at].next;
        }
        let mut before = from;
        for (k, &point) in arc.iter().enumerate() {
            let edge = if k + 1 < arc.len() { starting } else { ending };
            let new = self.corners.len();
            self.corners.push(Corner { point, edge, before, next: to, is_removed: false, fan: None });
            self.corners[before].next = new;
            before = new;
        }
        self.corners[to].before = before;
        true
    }

    /// Returns the outline and its edges.
    fn points(&self) -> (Vec<DVec2>, Vec<Edge>) {
        let Some(first) = self.corners.iter().position(|corner| !corner.is_removed) else {
            return (Vec::new(), Vec::new());
        };
        let mut at = first;
        let around = std::iter::from_fn(|| {
            let own = &self.corners[at];
            at = own.next;
            Some((own.point, own.edge))
        });
        let count = self.corners.iter().filter(|corner| !corner.is_removed).count();
        around.take(count).unzip()
    }
}

/// Ends a line on the circles that contain an end of the line, one circle after the other.
fn trim(ends: &mut [DVec2; 2], circles: &[Circle], columns: &Columns) {
    let mut from = 0;
    loop {
        let of_end = |end: &DVec2| {
            let end = *end;
            columns.near(end.x, end.x).filter(move |&number| number >= from && circles[number].contains(end)).min()
        };
        let Some(number) = ends.iter().filter_map(of_end).min() else { return };
        let circle = &circles[number];
        for end in [0, 1] {
            if circle.contains(ends[end]) {
                ends[end] = circle.entered(ends[1 - end], ends[end]).unwrap_or(ends[end]);
            }
        }
        from = number + 1;
    }
}
