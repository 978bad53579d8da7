//! Checks and centres the boundaries of a request.

use super::initial_mesh::turned;
use super::options::{InitialMesh, Options, SegmentPoint};
use plateau_mesh::codes::WarningCode;
use plateau_mesh::error::{InputError, Step, Warning};
use plateau_mesh::polyline::{self, LARGEST_COORDINATE, Merged, SAME_POINT, merge_near_neighbours, position_key};
use plateau_mesh::{DVec3, Error, Place};

/// The boundaries without equal neighbours and with the points at which curves end on their segments, at their given
/// position and relative to their centre. The solver works with
/// the centred points, so that an offset of 1e7 costs no digits.
#[derive(Debug)]
pub(super) struct Input {
    pub centre: DVec3,
    pub given: Vec<Vec<DVec3>>,
    pub centred: Vec<Vec<DVec3>>,
    /// The vertex of each input point, boundary by boundary.
    pub vertices: Vec<Vec<u32>>,
    /// For each point of `given` the index of the input point on its boundary. For the end of a curve on a segment it
    /// is the point at which the segment begins.
    sources: Vec<Vec<usize>>,
    dropped: usize,
}

/// Smallest accepted distance between neighbours on a boundary, in the caller's unit. At smaller distances products of
/// six lengths would vanish.
const SMALLEST_DISTANCE: f64 = 1e-50;

/// Names the points that a closed boundary passes twice because it runs out and back on the same way. Such a spike or
/// slit has no width, so that the triangles on both sides of it have no area. `points` have no equal neighbours, and
/// `source` has the number of each in the input. Returns input points and explanations.
fn passed_twice(points: &[DVec3], source: &[usize]) -> Vec<(usize, String)> {
    let n = points.len();
    let tolerance = SAME_POINT * polyline::radius(points);
    let farthest = |from: DVec3| points.iter().copied().max_by(|a, b| a.distance(from).total_cmp(&b.distance(from)));
    let axis = farthest(points[0]).map_or(DVec3::X, |end| end - points[0]);
    if points.iter().all(|&p| (p - points[0]).reject_from(axis).length() <= tolerance) {
        // A boundary on one line has no inside at all, which is another error.
        return Vec::new();
    }
    let mut named = Vec::new();
    for tip in 0..n {
        let [before, after] = [(tip + n - 1) % n, (tip + 1) % n];
        let sides = [before, after].map(|k| points[k] - points[tip]);
        let [near, far] = if sides[0].length() <= sides[1].length() { [0, 1] } else { [1, 0] };
        let turns_back = sides[0].dot(sides[1]) > 0.0 && sides[near].reject_from(sides[far]).length() <= tolerance;
        if !turns_back {
            continue;
        }
        let detail = "the boundary turns back here on the way by which it came; a way out and back has no width, and \
                      no film spans it: leave it out, or move its two sides apart";
        named.push((source[tip], detail.to_owned()));
        let pair = |step: usize| [(tip + n - step) % n, (tip + step) % n];
        let is_equal = |&[a, b]: &[usize; 2]| a != b && points[a].distance(points[b]) <= tolerance;
        let pairs: Vec<[usize; 2]> = (1..=n / 2).map(pair).take_while(is_equal).collect();
        for &[a, b] in &pairs {
            named.push((source[b], format!("is passed twice: it is point {} once more", source[a])));
        }
        if pairs.is_empty() {
            let [near, far] = [near, far].map(|side| [before, after][side]);
            let (from, to) = (source[tip], source[far]);
            named.push((source[near], format!("is passed twice: it lies on the side between points {from} and {to}")));
        }
    }
    named
}

impl Input {
    pub fn read(boundaries: &[Vec<DVec3>], options: &Options) -> Result<Self, Error> {
        let mut errors = options.check();
        let place = || Place::field("boundaries");
        if boundaries.is_empty() {
            errors.push(InputError::new(place(), "needs at least one closed polygon"));
        }
        let mut given = Vec::with_capacity(boundaries.len());
        let mut vertices = Vec::with_capacity(boundaries.len());
        let mut sources = Vec::with_capacity(boundaries.len());
        let (mut first, mut dropped) = (0u32, 0);
        for (k, boundary) in boundaries.iter().enumerate() {
            for (i, point) in boundary.iter().enumerate() {
                if !(point.is_finite() && point.abs().max_element() <= LARGEST_COORDINATE) {
                    let detail = "every coordinate must be a finite number of magnitude at most 1e50";
                    errors.push(InputError::new(place().at(k).at(i), detail));
                }
            }
            let merged = merge_near_neighbours(boundary, true);
            dropped += merged.dropped();
            let ends: Vec<&SegmentPoint> = options.constraints.ends.iter().filter(|end| end.boundary == k).collect();
            let merged = if ends.is_empty() { merged } else { with_ends(merged, &ends) };
            let next = |i: usize| merged.points[(i + 1) % merged.points.len()];
            if let Some(i) = (0..merged.points.len()).find(|&i| merged.points[i].distance(next(i)) < SMALLEST_DISTANCE)
                && merged.points.len() > 1
            {
                let detail = "lies nearer than 1e-50 to its neighbour, too near to compute with";
                errors.push(InputError::new(place().at(k).at(merged.source[i]), detail));
            }
            let mut distinct: Vec<[f64; 3]> = merged.points.iter().map(|p| (*p + DVec3::ZERO).to_array()).collect();
            distinct.sort_by(|a, b| a.partial_cmp(b).unwrap_or(std::cmp::Ordering::Equal));
            distinct.dedup();
            if distinct.len() < 3 {
                errors.push(InputError::new(place().at(k), "needs at least three distinct points"));
            } else if !matches!(options.initial_mesh, InitialMesh::Given(_)) {
                let named = passed_twice(&merged.points, &merged.source).into_iter();
                errors.extend(named.map(|(i, detail)| InputError::new(place().at(k).at(i), detail)));
            }
            vertices.push(merged.vertex_of.iter().map(|&v| first + v as u32).collect());
            first += merged.points.len() as u32;
            given.push(merged.points);
            sources.push(merged.source);
        }
        // Two boundaries with the same points are refused. The film between them has no area, so no size of triangle
        // suits it.
        let mut seen = std::collections::BTreeMap::new();
        for (k, points) in given.iter().enumerate() {
            let mut keys: Vec<[u64; 3]> = points.iter().copied().map(position_key).collect();
            keys.sort_unstable();
            if let Some(first) = seen.get(&keys) {
                let detail = format!("runs through the same points as boundary {first}");
                errors.push(InputError::new(place().at(k), detail));
            } else {
                seen.insert(keys, k);
            }
        }
        if !errors.is_empty() {
            return Err(Error::Input(errors));
        }
        // The sum for the centre begins at a point of each boundary that depends only on the shape of the boundary.
        // Otherwise the rounding of the centre would depend on the points with which the lists begin, and remeshing
        // would then give other triangles.
        let centre = polyline::mean(&turned(&given).0.concat());
        let centred = given.iter().map(|points| points.iter().map(|&p| p - centre).collect()).collect();
        Ok(Self { centre, given, centred, vertices, sources, dropped })
    }

    /// Warnings about the boundaries themselves.
    pub fn warnings(&self) -> Vec<Warning> {
        let merged = (self.dropped > 0).then(|| Warning::merged_points(self.dropped, None));
        let shared = self.shared().map(|([k, i], detail)| {
            let detail = format!("point {i} of boundary {k} {detail}");
            Warning::new(WarningCode::SharedPoints, detail).with_count("boundary", k).with_count("point", i)
        });
        merged.into_iter().chain(shared).collect()
    }

    /// Returns the first point that two boundaries have in common, with an explanation for the caller. The place is
    /// that of the point on the later boundary.
    pub fn shared_point(&self) -> Option<InputError> {
        let ([k, i], detail) = self.shared()?;
        Some(InputError::new(Place::field("boundaries").at(k).at(i), detail))
    }

    /// Returns the first shared point and an explanation for the caller. The point is given by the later boundary and
    /// its number there.
    fn shared(&self) -> Option<([usize; 2], String)> {
        let mut owners = std::collections::BTreeMap::new();
        let (mut first, mut count) = (None, 0);
        for (k, points) in self.given.iter().enumerate() {
            for (i, point) in points.iter().enumerate() {
                let &mut (owner, number) = owners.entry(position_key(*point)).or_insert((k, i));
                if owner != k {
                    count += 1;
                    first.get_or_insert([(owner, number), (k, i)]);
                }
            }
        }
        let [(owner, number), (k, i)] = first?;
        let others = if count > 1 { format!(" ({} more are shared)", count - 1) } else { String::new() };
        let detail = format!(
            "is also point {} of boundary {owner}{others}: the mesh has a vertex for each boundary there, so the film \
             only touches itself",
            self.sources[owner][number]
        );
        Some(([k, self.sources[k][i]], detail))
    }

    /// Returns the error with the numbers of points in the input. The given error has the numbers of the points that
    /// are left after merging.
    pub fn placed_as_given(&self, mut error: Error) -> Error {
        if let Error::NoResult { places, .. } | Error::Input(places) = &mut error {
            for place in places {
                if let [Step::Field("boundaries"), Step::Index(k), Step::Index(i)] = &mut place.place.0[..] {
                    *i = self.sources[*k][*i];
                }
            }
        }
        error
    }

    /// Returns the error with the first point that two boundaries share, because this point may be the reason why no
    /// mesh was found.
    pub fn with_shared_point(shared: Option<InputError>, mut error: Error) -> Error {
        if let Error::NoResult { places, .. } = &mut error {
            places.extend(shared);
        }
        error
    }

    pub fn point_count(&self) -> usize {
        self.given.iter().map(Vec::len).sum()
    }
}

/// Adds the ends of curves to a boundary, each between the two points of its segment.
fn with_ends(merged: Merged, ends: &[&SegmentPoint]) -> Merged {
    let mut on_segment: Vec<Vec<DVec3>> = vec![Vec::new(); merged.points.len()];
    for end in ends {
        if let Some(&vertex) = merged.vertex_of.get(end.segment) {
            on_segment[vertex].push(end.place);
        }
    }
    let mut with = Merged { points: Vec::new(), vertex_of: Vec::new(), source: Vec::new() };
    let mut place = Vec::with_capacity(merged.points.len());
    for ((&point, &source), mut own) in merged.points.iter().zip(&merged.source).zip(on_segment) {
        own.sort_by(|a, b| a.distance(point).total_cmp(&b.distance(point)));
        own.dedup();
        place.push(with.points.len());
        with.source.extend(std::iter::repeat_n(source, 1 + own.len()));
        with.points.push(point);
        with.points.extend(own);
    }
    with.vertex_of = merged.vertex_of.iter().map(|&vertex| place[vertex]).collect();
    with
}
