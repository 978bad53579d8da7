//! Step 2: halves every edge, and places the new boundary vertices on the input polygons.

use super::plan::Plan;
use plateau_mesh::DVec3;
use plateau_mesh::film::Film;
use plateau_mesh::remesh::subdivision::subdivided_inside;

/// The places of the film's boundary vertices on the input polygons. A place is the index of an input point, or a
/// number between two indices for a point between them on the segment.
#[derive(Debug)]
pub(super) struct BoundaryPlaces<'a> {
    polygons: &'a [Vec<DVec3>],
    may_add: bool,
    /// Number of refinements that were made.
    pub level: u32,
    /// Whether the last refinement added no input point, so that the boundary polygon stayed the same.
    pub same_polygon: bool,
    /// For each boundary loop of the film, the places of its vertices on the polygon, in order.
    places: Vec<Vec<f64>>,
}

impl<'a> BoundaryPlaces<'a> {
    /// Finds the places of the boundary vertices of a coarse film. A vertex that was added on a coarse edge that skips
    /// input points is moved to one of the skipped points. `None` if more vertices were added on such an edge than it
    /// skips points, or if two of these vertices would get the same point.
    pub fn new(film: &mut Film, plan: &Plan, polygons: &'a [Vec<DVec3>], may_add: bool) -> Option<Self> {
        let mut places = Vec::with_capacity(polygons.len());
        let mut first = 0u32;
        for ((polygon, kept), boundary) in polygons.iter().zip(&plan.kept).zip(&film.boundaries) {
            let count = kept.len() as u32;
            let mut on_polygon = Vec::with_capacity(boundary.len());
            let is_kept = |v: u32| (first..first + count).contains(&v);
            if boundary.first().is_none_or(|&v| v != first) {
                return None;
            }
            let mut k = 0;
            // Ends because each pass raises k by one or more.
            while k < boundary.len() {
                let edge = (boundary[k] - first) as usize;
                let added = boundary[k + 1..].iter().take_while(|&&v| !is_kept(v)).count();
                let start = f64::from(kept[edge]);
                let end = kept.get(edge + 1).map_or(f64::from(kept[0]) + polygon.len() as f64, |&end| f64::from(end));
                let skipped = (end - start) as usize - 1;
                on_polygon.push(start);
                let (a, b) = (point_at(polygon, start), point_at(polygon, end));
                for j in 1..=added {
                    let vertex = boundary[k + j] as usize;
                    let along = b - a;
                    let part = ((film.vertices[vertex] - a).dot(along) / along.length_squared()).clamp(0.0, 1.0);
                    let mut place = start + (end - start) * part;
                    if skipped > 0 {
                        place = place.round();
                        film.vertices[vertex] = point_at(polygon, place);
                    }
                    if place <= on_polygon[on_polygon.len() - 1] || place >= end {
                        return None;
                    }
                    on_polygon.push(place);
                }
                k += 1 + added;
            }
            places.push(on_polygon);
            first += count;
        }
        Some(Self { polygons, may_add, level: 0, same_polygon: false, places })
    }

    /// Halves every edge that can be halved. Also returns for each new vertex the ends of the edge that it halves.
    pub fn refine(&mut self, film: &Film) -> (Film, Vec<[u32; 2]>) {
        let old = film.vertices.len();
        // The boundary edges, each with the smaller vertex first, and the place at which each is halved.
        let mut edges: Vec<([u32; 2], Option<f64>)> = Vec::new();
        for ((boundary, places), polygon) in film.boundaries.iter().zip(&self.places).zip(self.polygons) {
            for k in 0..boundary.len() {
                let next = (k + 1) % boundary.len();
                let wrap = if next == 0 { polygon.len() as f64 } else { 0.0 };
                let ends = [boundary[k].min(boundary[next]), boundary[k].max(boundary[next])];
                edges.push((ends, self.middle(places[k], places[next] + wrap)));
            }
        }
        edges.sort_unstable_by_key(|(ends, _)| *ends);
        self.same_polygon = edges.iter().all(|(_, place)| place.is_none_or(|place| place.fract() != 0.0));
        let place_of = |a: u32, b: u32| {
            let found = edges.binary_search_by_key(&[a.min(b), a.max(b)], |(ends, _)| *ends);
            found.ok().and_then(|k| edges[k].1)
        };
        let (topology, midpoints) = if edges.iter().all(|(_, place)| place.is_some()) {
            film.topology.subdivided()
        } else {
            subdivided_inside(&film.topology, &film.vertices, |a, b| place_of(a, b).is_some())
        };
        let mut vertices = Vec::with_capacity(old + midpoints.len());
        vertices.extend_from_slice(&film.vertices);
        vertices.extend(midpoints.iter().map(|&[a, b]| 0.5 * (film.vertices[a as usize] + film.vertices[b as usize])));
        let mut fixed = film.fixed.clone();
        fixed.resize(vertices.len(), false);
        let mut middle_of: Vec<([u32; 2], u32)> = Vec::with_capacity(edges.len());
        for (k, &[a, b]) in midpoints.iter().enumerate() {
            if film.fixed[a as usize] && film.fixed[b as usize] && place_of(a, b).is_some() {
                fixed[old + k] = true;
                middle_of.push(([a.min(b), a.max(b)], (old + k) as u32));
            }
        }
        middle_of.sort_unstable();
        let mut boundaries = Vec::with_capacity(film.boundaries.len());
        for ((boundary, places), polygon) in film.boundaries.iter().zip(&mut self.places).zip(self.polygons) {
            let (mut vertices_along, mut places_along) = (Vec::new(), Vec::new());
            for k in 0..boundary.len() {
                let (a, b) = (boundary[k], boundary[(k + 1) % boundary.len()]);
                vertices_along.push(a);
                places_along.push(places[k]);
                if let (Ok(at), Some(place)) =
                    (middle_of.binary_search_by_key(&[a.min(b), a.max(b)], |(ends, _)| *ends), place_of(a, b))
                {
                    let vertex = middle_of[at].1;
                    vertices[vertex as usize] = point_at(polygon, place);
                    vertices_along.push(vertex);
                    places_along.push(place);
                }
            }
            *places = places_along;
            boundaries.push(vertices_along);
        }
        self.level += 1;
        (Film { vertices, topology, fixed, locked: Vec::new(), boundaries }, midpoints)
    }

    /// The place at which an edge between two places is halved: the middle one of the input points between them. If
    /// there is no input point between them, it is the middle of the edge, or `None` if no points may be added.
    fn middle(&self, start: f64, end: f64) -> Option<f64> {
        let (lowest, highest) = (start.floor() + 1.0, end.ceil() - 1.0);
        if lowest <= highest {
            Some((0.5 * (start + end)).round().clamp(lowest, highest))
        } else {
            self.may_add.then_some(0.5 * (start + end))
        }
    }

    /// Renumbers the vertices into the documented order: input points, points added on the boundaries, interior
    /// vertices.
    ///
    /// A boundary loop begins at the first point that the coarse mesh keeps, which need not be point 0. The loop is
    /// therefore rotated to begin at point 0 of its polygon. Returns `None` if point 0 is not a vertex of the film. On
    /// the last level every input point is a vertex.
    pub fn input_points_first(&mut self, mut film: Film) -> Option<Film> {
        for ((boundary, places), polygon) in film.boundaries.iter_mut().zip(&mut self.places).zip(self.polygons) {
            let count = polygon.len() as f64;
            let first = places.iter().position(|place| place % count == 0.0)?;
            boundary.rotate_left(first);
            places.rotate_left(first);
        }
        const UNPLACED: u32 = u32::MAX;
        let mut place = vec![UNPLACED; film.vertices.len()];
        let mut next = 0u32;
        for input_points in [true, false] {
            for (boundary, places) in film.boundaries.iter().zip(&self.places) {
                let chosen = boundary.iter().zip(places).filter(|(_, place)| (place.fract() == 0.0) == input_points);
                for (&vertex, _) in chosen {
                    place[vertex as usize] = next;
                    next += 1;
                }
            }
        }
        for place in place.iter_mut().filter(|place| **place == UNPLACED) {
            *place = next;
            next += 1;
        }
        Some(film.renumbered(&place))
    }
}

/// The point at a place on a closed polygon. At an integer place it is exactly an input point.
fn point_at(polygon: &[DVec3], place: f64) -> DVec3 {
    let n = polygon.len();
    let index = place.floor() as usize;
    let (a, b) = (polygon[index % n], polygon[(index + 1) % n]);
    match place.fract() {
        0.0 => a,
        fraction => a + fraction * (b - a),
    }
}
