//! Orientations of the boundary: in which directions a surface runs along its loops.

use super::symmetry::Mirrors;
use plateau_mesh::plane::polygon::doubled_area_vector;
use plateau_mesh::polyline::position_key;
use plateau_mesh::{DVec3, Mesh};

/// The loops in one orientation, or in a set of orientations in which the directions of some loops are left open.
#[derive(Clone, Debug)]
pub(super) struct Oriented {
    pub loops: Vec<Vec<DVec3>>,
    /// The loops in the coordinates of the mesh.
    pub placed: Vec<Vec<DVec3>>,
    pub mirrors: Mirrors,
    /// Numbers of the free loops, whose direction is left open. The field has no circulation around them, so that it
    /// bounds the area for either direction.
    pub free: Vec<usize>,
}

impl Oriented {
    /// Every orientation in which the last loop has the direction of the film's border. In the first of them all loops
    /// have the direction of the border.
    pub fn all(loops: &[Vec<DVec3>], own: &[bool], place: &impl Fn(DVec3) -> DVec3, middle: DVec3) -> Vec<Self> {
        let with_pattern = |pattern: u32| {
            let reversed = |k: usize| own[k] == (pattern >> k & 1 == 1);
            let mut oriented = Self::with(loops, reversed, place);
            oriented.mirrors = Mirrors::of(&oriented.placed, middle);
            oriented
        };
        (0..1 << (loops.len() - 1)).map(with_pattern).collect()
    }

    /// All orientations together: loop 0 has the direction of the film's border, and the other loops are free.
    pub fn open(loops: &[Vec<DVec3>], own: &[bool], place: &impl Fn(DVec3) -> DVec3, middle: DVec3) -> Self {
        let mut oriented = Self::with(loops, |k| !own[k], place);
        oriented.mirrors = Mirrors::in_every_orientation(&oriented.placed, middle);
        // The next loop whose direction will be fixed is last in the list.
        oriented.free = near_first(loops).into_iter().skip(1).rev().collect();
        oriented
    }

    fn with(loops: &[Vec<DVec3>], reversed: impl Fn(usize) -> bool, place: &impl Fn(DVec3) -> DVec3) -> Self {
        let oriented = |(k, points): (usize, &Vec<DVec3>)| -> Vec<DVec3> {
            if reversed(k) { points.iter().rev().copied().collect() } else { points.clone() }
        };
        let loops: Vec<Vec<DVec3>> = loops.iter().enumerate().map(oriented).collect();
        let placed: Vec<Vec<DVec3>> = loops.iter().map(|points| points.iter().map(|&p| place(p)).collect()).collect();
        Self { loops, placed, mirrors: Mirrors::default(), free: Vec::new() }
    }

    /// Fixes the direction of the next free loop, once in its present direction and once reversed. `None` if no loop is
    /// free.
    pub fn split(mut self) -> Option<[Self; 2]> {
        let number = self.free.pop()?;
        let mut other = self.clone();
        other.loops[number].reverse();
        other.placed[number].reverse();
        Some([self, other])
    }
}

/// The vector area: the integral of the unit normal over any surface that the loops bound. Its length is the bound that
/// a field of constant curl gives. For plane polygons this is the area itself.
pub(super) fn vector_area(loops: &[Vec<DVec3>]) -> DVec3 {
    0.5 * loops.iter().map(|points| doubled_area_vector(points)).sum::<DVec3>()
}

/// For each loop, whether the film's border runs along it in the loop's direction. `None` if the border does not run
/// along a loop in either direction. Bounds for the loops then do not apply to the film.
pub(super) fn own_orientation(loops: &[Vec<DVec3>], film: &Mesh) -> Option<Vec<bool>> {
    let border = Border::of(film);
    let direction = |points: &Vec<DVec3>| [true, false].into_iter().find(|&forward| border.runs_along(points, forward));
    loops.iter().map(direction).collect()
}

/// Cosine of the largest angle between an edge of the border and the segment of which the edge is a part. Edges that
/// begin at the same vertex and belong to other segments usually make larger angles. If several edges pass, the edge
/// with the smallest angle is taken.
const ALONG: f64 = 0.5;

/// The border of a film: the directed sides of triangles whose opposite direction is no side of a triangle.
struct Border<'a> {
    vertices: &'a [DVec3],
    /// The vertices, sorted by the keys of their positions.
    places: Vec<([u64; 3], u32)>,
    /// The sides, sorted by their first vertex.
    sides: Vec<[u32; 2]>,
    /// The same sides reversed, sorted by their first vertex.
    backwards: Vec<[u32; 2]>,
}

impl<'a> Border<'a> {
    fn of(film: &'a Mesh) -> Self {
        let sides_of = |&[a, b, c]: &[u32; 3]| [[a, b], [b, c], [c, a]];
        let mut all: Vec<[u32; 2]> = film.triangles.iter().flat_map(sides_of).collect();
        all.sort_unstable();
        let sides: Vec<[u32; 2]> = all.iter().copied().filter(|&[a, b]| all.binary_search(&[b, a]).is_err()).collect();
        let mut backwards: Vec<[u32; 2]> = sides.iter().map(|&[a, b]| [b, a]).collect();
        backwards.sort_unstable();
        let keyed = |(v, &p): (usize, &DVec3)| (position_key(p), v as u32);
        let mut places: Vec<_> = film.vertices.iter().enumerate().map(keyed).collect();
        places.sort_unstable();
        Self { vertices: &film.vertices, places, sides, backwards }
    }

    /// Whether the sides lead from each point of a closed polygon to the next point. Points of the polygon that are not
    /// vertices of the film are skipped.
    fn runs_along(&self, points: &[DVec3], forward: bool) -> bool {
        let sides = if forward { &self.sides } else { &self.backwards };
        let is_vertex = |p: &DVec3| self.at(*p).next().is_some();
        let points: Vec<DVec3> = points.iter().copied().filter(is_vertex).collect();
        let Some(&start) = points.first() else { return false };
        let leads_round = |first: u32| {
            let (mut here, mut left) = (first, sides.len());
            (1..=points.len()).all(|k| {
                let target = points[k % points.len()];
                // Takes at most `sides.len()` steps, because each step lowers `left`. A walk that needs more steps
                // takes a side twice, so it does not run along the polygon.
                loop {
                    let Some(next) = self.towards(sides, here, target) else { return false };
                    here = next;
                    let Some(fewer) = left.checked_sub(1) else { return false };
                    left = fewer;
                    if position_key(self.vertices[here as usize]) == position_key(target) {
                        return true;
                    }
                }
            })
        };
        self.at(start).any(leads_round)
    }

    /// The vertices at a position.
    fn at(&self, point: DVec3) -> impl Iterator<Item = u32> {
        let key = position_key(point);
        let first = self.places.partition_point(|place| place.0 < key);
        self.places[first..].iter().take_while(move |place| place.0 == key).map(|place| place.1)
    }

    /// The end of the side that leads most directly from a vertex to a point.
    fn towards(&self, sides: &[[u32; 2]], from: u32, target: DVec3) -> Option<u32> {
        let here = self.vertices[from as usize];
        let way = (target - here).normalize_or_zero();
        let first = sides.partition_point(|side| side[0] < from);
        let ends = sides[first..].iter().take_while(|side| side[0] == from).map(|side| side[1]);
        let cosine = |end: u32| (self.vertices[end as usize] - here).normalize_or_zero().dot(way);
        ends.map(|end| (cosine(end), end)).filter(|of| of.0 > ALONG).max_by(|a, b| a.0.total_cmp(&b.0)).map(|of| of.1)
    }
}

/// Returns the order in which the search fixes the directions of the loops. Loop 0 is first. Each following loop is the
/// one whose centre is nearest to the centres before it, because a surface that joins a few loops joins neighbours.
pub(super) fn near_first(loops: &[Vec<DVec3>]) -> Vec<usize> {
    let centre = |points: &Vec<DVec3>| points.iter().sum::<DVec3>() / points.len() as f64;
    let centres: Vec<DVec3> = loops.iter().map(centre).collect();
    let mut order = vec![0];
    let mut distance: Vec<f64> = centres.iter().map(|c| c.distance(centres[0])).collect();
    // At most one pass per loop, because each pass adds one to the order.
    while order.len() < loops.len() {
        let left = (0..loops.len()).filter(|number| !order.contains(number));
        let Some(next) = left.min_by(|&a, &b| distance[a].total_cmp(&distance[b])) else { break };
        order.push(next);
        distance.iter_mut().zip(&centres).for_each(|(d, c)| *d = d.min(c.distance(centres[next])));
    }
    order
}
