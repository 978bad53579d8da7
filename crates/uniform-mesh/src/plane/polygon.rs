//! Prepares a planar polygon in space, with holes, for meshing: checks it, projects rounded points onto its plane,
//! converts it to plane coordinates in units of ℓ, and splits its long sides.

use super::mesh::Outline;
use super::sides::{Division, Sides, is_sharp, pieces};
use plateau_mesh::codes::WarningCode;
use plateau_mesh::error::{Error, InputError, Place, Warning};
use plateau_mesh::execution::{Execution, Signal};
use plateau_mesh::plane::flatness::Flatness;
use plateau_mesh::plane::frame::Frame;
use plateau_mesh::plane::polygon::doubled_area;
use plateau_mesh::plane::touching::{Meeting, PointOf, meeting};
use plateau_mesh::polyline::contact::{MeetingSegments, Segments, first_contact};
use plateau_mesh::polyline::{LARGEST_COORDINATE, Merged, SAME_POINT, mean, merge_near_neighbours};
use plateau_mesh::{DVec2, DVec3};
use std::cell::Cell;

/// Distance up to which points count as lying on one line and sides as meeting, as a fraction of the polygon's size. It
/// is used only to find out why a polygon has no area.
const TOUCHING: f64 = 1e-6;

/// A polygon that is ready to be meshed.
#[derive(Clone, Debug)]
pub(crate) struct Polygon {
    frame: Frame,
    /// ℓ, in the caller's unit.
    unit: f64,
    pub outline: Outline,
    /// The outline's nodes in space. The corners come first, exactly as given unless they were projected.
    pub positions: Vec<DVec3>,
    pub input_vertices: Vec<Option<u32>>,
    pub warnings: Vec<Warning>,
    pub sides: Sides,
    /// The corners of each loop, in the direction that has the domain on the left.
    corner_loops: Vec<Vec<u32>>,
    /// For each corner, the number of its loop and the index of its input point in the loop.
    sources: Vec<(usize, usize)>,
}

/// The place in the input of a point of loop `ring`. Loop 0 is the outer loop.
fn place(ring: usize, point: usize) -> Place {
    let domain = Place::field("domain");
    if ring == 0 { domain.then("polygon").at(point) } else { domain.then("holes").at(ring - 1).at(point) }
}

fn ring_place(ring: usize) -> Place {
    let domain = Place::field("domain");
    if ring == 0 { domain.then("polygon") } else { domain.then("holes").at(ring - 1) }
}

impl Polygon {
    /// Makes the polygon, and checks everything that needs no triangulation. The boundary has only corners until it is
    /// [`split`](Self::split).
    ///
    /// # Errors
    /// [`Error::Input`] if a point is not finite, if a loop has fewer than three distinct points, if the polygon has no
    /// area, or if a point lies off the plane.
    pub fn new(outer: &[DVec3], holes: &[Vec<DVec3>], edge_length: f64) -> Result<Self, Error> {
        let rings: Vec<&[DVec3]> = std::iter::once(outer).chain(holes.iter().map(Vec::as_slice)).collect();
        for (ring, points) in rings.iter().enumerate() {
            finite(ring, points)?;
        }
        let mut merged = merge(&rings)?;
        let frame = Frame::of_loop(&merged[0].points).ok_or_else(|| without_area(&merged[0]))?;
        let all = || merged.iter().flat_map(|m| &m.points).copied();
        let mut warnings = Vec::new();
        match Flatness::of(all(), &merged[0].points, &frame) {
            Flatness::Plane => {}
            Flatness::Near(distance) => {
                warnings.push(Warning::projected("the polygon", distance));
                let onto_plane = |points: &&[DVec3]| points.iter().map(|&point| frame.foot(point)).collect();
                let projected: Vec<Vec<DVec3>> = rings.iter().map(onto_plane).collect();
                merged = merge(&projected)?;
            }
            Flatness::Bent(departure) => {
                let sources = merged.iter().enumerate().flat_map(|(ring, m)| m.source.iter().map(move |&k| (ring, k)));
                let place = sources.map(|(ring, k)| place(ring, k)).nth(departure.point);
                let detail = departure.detail("the polygon is not planar");
                return Err(Error::input(place.unwrap_or_else(|| ring_place(0)), detail));
            }
        }
        let dropped: usize = merged.iter().map(|m| m.dropped()).sum();
        if dropped > 0 {
            let warning = Warning::new(WarningCode::MergedPoints, format!("{dropped} repeated points were merged"));
            warnings.push(warning.with_count("count", dropped));
        }

        let mut polygon = Self {
            frame,
            unit: edge_length,
            outline: Outline::default(),
            positions: Vec::new(),
            input_vertices: Vec::new(),
            warnings,
            sides: Sides::default(),
            corner_loops: Vec::new(),
            sources: Vec::new(),
        };
        let mut corner_loops = Vec::new();
        for (ring, m) in merged.iter().enumerate() {
            let first = polygon.positions.len() as u32;
            polygon.input_vertices.extend(m.vertex_of.iter().map(|&v| Some(first + v as u32)));
            polygon.sources.extend(m.source.iter().map(|&k| (ring, k)));
            polygon.positions.extend_from_slice(&m.points);
            let local = m.points.iter().map(|&p| frame.coordinates((p - frame.origin) / edge_length));
            polygon.outline.nodes.extend(local);
            let mut corners: Vec<u32> = (first..polygon.positions.len() as u32).collect();
            let nodes = &polygon.outline.nodes;
            let around = corners.iter().map(|&v| nodes[v as usize]);
            let turning = doubled_area(around, nodes[first as usize]);
            // The outer loop is counter-clockwise by the choice of the frame. A hole must run clockwise.
            if ring > 0 && turning > 0.0 {
                corners.reverse();
            }
            corner_loops.push(corners);
        }
        polygon.corner_loops = corner_loops;
        Ok(polygon)
    }

    /// Joins loops that touch at points. Afterwards each loop has the domain on its left.
    ///
    /// # Errors
    /// [`Error::Input`] if two sides cross or share more than a point, and the interruptions of `execution`.
    pub fn joined(mut self, execution: &Execution<'_>) -> Result<Self, Error> {
        let rings: Vec<Vec<u32>> = (0..self.corner_loops.len())
            .map(|ring| (0..self.sources.len() as u32).filter(|&v| self.sources[v as usize].0 == ring).collect())
            .collect();
        let position = |nodes: &[DVec2], v: u32| nodes[v as usize];
        let polygons: Vec<Vec<DVec2>> =
            rings.iter().map(|ring| ring.iter().map(|&v| position(&self.outline.nodes, v)).collect()).collect();
        let size = self.positions.iter().map(|p| p.distance(self.positions[0])).fold(0.0, f64::max) / self.unit;
        let node = |(ring, point): PointOf| rings[ring][point];
        match meeting(&polygons, SAME_POINT * size, execution)? {
            Meeting::Apart => {}
            Meeting::Crossing(sides) => {
                let [first, second] = sides.map(|side| self.place_of(node(side)));
                let detail = |other: &Place| format!("the side from this point meets the side from {other}");
                let [a, b] = [detail(&second), detail(&first)];
                return Err(Error::Input(vec![InputError::new(first, a), InputError::new(second, b)]));
            }
            Meeting::Touching(loops) => {
                self.corner_loops = Vec::with_capacity(loops.len());
                for corners in loops {
                    let mut joined = Vec::with_capacity(corners.len());
                    for corner in &corners {
                        let (source, place) = (node(corner.source), node(corner.place));
                        let there = position(&self.outline.nodes, place);
                        if corner.added {
                            joined.push(self.positions.len() as u32);
                            self.positions.push(self.positions[place as usize]);
                            self.outline.nodes.push(there);
                            self.sources.push(self.sources[source as usize]);
                        } else {
                            joined.push(source);
                            self.outline.nodes[source as usize] = there;
                        }
                    }
                    let is_outer = corners.iter().any(|corner| corner.source.0 == 0);
                    let around = joined.iter().map(|&v| position(&self.outline.nodes, v));
                    if !is_outer && doubled_area(around, position(&self.outline.nodes, joined[0])) > 0.0 {
                        joined.reverse();
                    }
                    self.corner_loops.push(joined);
                }
            }
        }
        Ok(self)
    }

    /// Splits the sides into pieces. The length of each piece is in [ℓ, 2ℓ] if its side is at least ℓ long.
    pub fn split(&mut self, division: Division) {
        self.sides = Sides::new(self.positions.len());
        for corners in &self.corner_loops {
            let count = corners.len();
            let mut nodes = Vec::new();
            let mut sides = Vec::new();
            for k in 0..count {
                let (a, b) = (corners[k] as usize, corners[(k + 1) % count] as usize);
                let c = corners[(k + 2) % count] as usize;
                let (p, q) = (self.outline.nodes[a], self.outline.nodes[b]);
                let edge = q - p;
                let first = nodes.len();
                nodes.push(a as u32);
                let (from, to) = (self.positions[a], self.positions[b]);
                let pieces = pieces(edge.length(), division);
                for piece in 1..pieces {
                    let part = f64::from(piece) / f64::from(pieces);
                    nodes.push(self.positions.len() as u32);
                    self.positions.push(from + (to - from) * part);
                    self.outline.nodes.push(p + edge * part);
                }
                let sharp_end = is_sharp(edge, self.outline.nodes[c] - q);
                sides.push((first, edge.length(), sharp_end));
            }
            self.sides.add_loop(&nodes, &sides);
            self.outline.loops.push(nodes);
        }
    }

    /// The point in space that has the plane coordinates `p`, which are in units of ℓ.
    pub fn point(&self, p: DVec2) -> DVec3 {
        self.frame.origin + self.frame.direction(p) * self.unit
    }

    /// The place in the input of the point at a boundary node. For a node inside a side, the place of the point at
    /// which the side starts.
    pub fn place_of(&self, node: u32) -> Place {
        let corner =
            if (node as usize) < self.sources.len() { node as usize } else { self.sides.start_of(node) as usize };
        let (ring, point) = self.sources[corner.min(self.sources.len() - 1)];
        place(ring, point)
    }

    /// The place in the input of the loop to which a boundary node belongs.
    pub fn ring_of(&self, node: u32) -> Place {
        let ring = self.outline.loops.iter().position(|nodes| nodes.contains(&node)).unwrap_or(0);
        ring_place(ring)
    }

    /// Lower bound of the number of nodes of any triangulation of the domain with every edge at most 2ℓ. A triangle
    /// covers at most √3 ℓ², and a side of length L needs ⌈L/2ℓ⌉ pieces. Euler's formula turns both numbers into a
    /// number of nodes.
    pub fn node_lower_bound(&self) -> usize {
        let boundary: f64 = self.sides.lengths().map(|length| (length / 2.0 - 1e-9).ceil().max(1.0)).sum();
        let holes = self.outline.loops.len() as f64 - 1.0;
        let nodes = (self.outline.area() / 3f64.sqrt() + boundary + 2.0 - 2.0 * holes) / 2.0;
        ((nodes - 1e-9).ceil().max(0.0) as usize).max(self.sides.lengths().count())
    }
}

/// Merges repeated neighbouring points in each loop.
fn merge(rings: &[impl AsRef<[DVec3]>]) -> Result<Vec<Merged>, Error> {
    let merged: Vec<_> = rings.iter().map(|points| merge_near_neighbours(points.as_ref(), true)).collect();
    let short = merged.iter().enumerate().filter(|(_, merged)| merged.points.len() < 3);
    let errors: Vec<_> =
        short.map(|(ring, _)| InputError::new(ring_place(ring), "needs at least three distinct points")).collect();
    if errors.is_empty() { Ok(merged) } else { Err(Error::Input(errors)) }
}

/// Number of calls of [`Execution::look`] after which the search for a crossing ends: a quarter of a million pairs of
/// boxes, or about 0.1 s. Without this limit, a zigzag whose boxes all overlap would take time proportional to the
/// square of its number of points. [`Polygon::new`] also checks requests before they are queued, and must be fast.
const MOST_LOOKS: u32 = 64;

/// The error for an outer loop whose area vector is zero. Either all its points lie on one line, or its parts cancel
/// out. In a bow-tie, which crosses itself, the parts cancel out.
fn without_area(outer: &Merged) -> Error {
    let points = &outer.points;
    let count = points.len();
    let size = points.iter().map(|p| p.distance(points[0])).fold(0.0, f64::max);
    let farthest = points.iter().copied().max_by(|a, b| a.distance(points[0]).total_cmp(&b.distance(points[0])));
    let along = farthest.map_or(DVec3::X, |p| (p - points[0]) / size);
    if points.iter().all(|p| (*p - points[0]).cross(along).length() <= TOUCHING * size) {
        return Error::input(ring_place(0), "encloses no area: all points lie on one line");
    }
    let segments = Segments::new(points, true);
    let are_apart =
        |contact: &MeetingSegments| contact.first + 1 < contact.second && (contact.second + 1) % count != contact.first;
    let looks = Cell::new(0);
    let signal = || {
        looks.set(looks.get() + 1);
        if looks.get() > MOST_LOOKS { Signal::Cancel } else { Signal::Continue }
    };
    let limited = Execution::new(&signal, &|_| {});
    match first_contact(&segments, &segments, TOUCHING * size, are_apart, &limited) {
        Ok(Some(contact)) => {
            let [first, second] = [contact.first, contact.second].map(|k| outer.source[k]);
            let detail =
                format!("the polygon crosses itself: the side from this point meets the side from point {second}");
            Error::input(place(0, first), detail)
        }
        _ => Error::input(ring_place(0), "encloses no area: parts of it run in opposite senses and cancel out"),
    }
}

/// Returns the area (of the outer loop minus the holes) and the total length of all loops, in the caller's unit. The
/// area of a loop is half the length of its doubled area vector.
///
/// # Errors
/// [`Error::Input`] if a point is not finite.
pub(crate) fn extent(outer: &[DVec3], holes: &[Vec<DVec3>]) -> Result<(f64, f64), Error> {
    let (mut area, mut perimeter) = (0.0, 0.0);
    for (ring, points) in std::iter::once(outer).chain(holes.iter().map(Vec::as_slice)).enumerate() {
        finite(ring, points)?;
        let centre = mean(points);
        let around = || points.iter().zip(points.iter().cycle().skip(1));
        let doubled: DVec3 = around().map(|(&a, &b)| (a - centre).cross(b - centre)).sum();
        area += if ring == 0 { doubled.length() } else { -doubled.length() } / 2.0;
        perimeter += around().map(|(a, b)| a.distance(*b)).sum::<f64>();
    }
    Ok((area.max(0.0), perimeter))
}

fn finite(ring: usize, points: &[DVec3]) -> Result<(), Error> {
    let bad = |p: &DVec3| !p.is_finite() || p.abs().max_element() > LARGEST_COORDINATE;
    let errors: Vec<_> = (0..points.len())
        .filter(|&k| bad(&points[k]))
        .map(|k| InputError::new(place(ring, k), "must be finite and below 1e50 in magnitude"))
        .collect();
    if errors.is_empty() { Ok(()) } else { Err(Error::Input(errors)) }
}
