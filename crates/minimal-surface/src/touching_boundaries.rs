//! Plane boundaries that touch at points. They are joined to loops that bound the film between them.

use super::initial_mesh::plane_of;
use super::options::{InitialMesh, Options};
use super::request::Input;
use super::solved_film::SolvedFilm;
use plateau_mesh::codes::Reason;
use plateau_mesh::error::InputError;
use plateau_mesh::film::Film;
use plateau_mesh::plane::touching::{Meeting, PointOf, meeting};
use plateau_mesh::polyline::{self, SAME_POINT, position_key};
use plateau_mesh::{DVec2, DVec3, Error, Execution, Mesh, Place};
use std::collections::BTreeMap;

/// The joined loops of boundaries that touch, and the input points that they consist of.
pub(super) struct JoinedLoops {
    /// The loops, without equal neighbours. Points that touch have the same coordinates.
    pub loops: Vec<Vec<DVec3>>,
    /// The number of each point of the loops. Input points keep their numbers. Points that were added where a point of
    /// another boundary lies on a side have the numbers that follow.
    numbers: Vec<u32>,
    /// The given position of each added point, by the bits of its centred position.
    given: BTreeMap<[u64; 3], DVec3>,
}

impl JoinedLoops {
    /// Joins boundaries that touch in one plane. Returns `None` if the boundaries do not lie in one plane or do not
    /// touch, or if the options ask for an initial mesh other than `auto` and `planar`. Also returns `None` if they
    /// cross and the result may have another topology than the initial mesh.
    ///
    /// # Errors
    /// `self_intersecting_boundary` if plane boundaries cross or share a piece of a side, and the result must have the
    /// topology of the initial mesh. The interruptions of `exec`.
    pub fn of(input: &Input, options: &Options, exec: &Execution) -> Result<Option<Self>, Error> {
        let boundaries = &input.centred;
        if boundaries.len() < 2 || !matches!(options.initial_mesh, InitialMesh::Auto | InitialMesh::Planar) {
            return Ok(None);
        }
        let Some(frame) = plane_of(boundaries) else { return Ok(None) };
        let flat: Vec<Vec<DVec2>> =
            boundaries.iter().map(|points| points.iter().map(|&p| frame.project(p)).collect()).collect();
        let radius = polyline::radius(&boundaries.concat());
        let joined = match meeting(&flat, SAME_POINT * radius, exec)? {
            Meeting::Apart => return Ok(None),
            Meeting::Crossing(sides) if options.keeps_topology() => return Err(crossing(sides)),
            Meeting::Crossing(_) => return Ok(None),
            Meeting::Touching(joined) => joined,
        };
        let firsts: Vec<usize> = boundaries
            .iter()
            .scan(0, |next, points| {
                *next += points.len();
                Some(*next - points.len())
            })
            .collect();
        let mut added = input.point_count() as u32;
        let mut loops = Self { loops: Vec::with_capacity(joined.len()), numbers: Vec::new(), given: BTreeMap::new() };
        for corners in joined {
            let position = |(k, i): PointOf| boundaries[k][i];
            loops.loops.push(corners.iter().map(|corner| position(corner.place)).collect());
            for corner in corners {
                let (k, i) = corner.source;
                loops.numbers.push(if corner.added { added } else { (firsts[k] + i) as u32 });
                if corner.added {
                    added += 1;
                    let (k, i) = corner.place;
                    loops.given.insert(position_key(boundaries[k][i]), input.given[k][i]);
                }
            }
        }
        Ok(Some(loops))
    }

    /// Renumbers the vertices of a film over the joined loops so that the vertices at the input points come first, in
    /// input order. Sets these vertices to exactly the centred points.
    pub fn restore(&self, solved: &mut SolvedFilm, input: &Input) {
        let film = &solved.film;
        let place: Vec<u32> =
            self.numbers.iter().copied().chain(self.numbers.len() as u32..film.vertices.len() as u32).collect();
        if let Some(mode) = &mut solved.run.unstable_mode {
            let before = mode.clone();
            before.iter().zip(&place).for_each(|(&direction, &v)| mode[v as usize] = direction);
        }
        solved.film = film.clone().renumbered(&place);
        solved
            .film
            .vertices
            .iter_mut()
            .zip(input.centred.iter().flatten())
            .for_each(|(vertex, &point)| *vertex = point);
    }

    /// Sets the vertices that were added on the boundaries to exactly the input points at the same places. `mesh` is at
    /// the position of the input. `centred` are its vertices relative to the centre.
    pub fn place_added(&self, mesh: &mut Mesh, centred: &[DVec3]) {
        for (vertex, &point) in mesh.vertices.iter_mut().zip(centred) {
            if let Some(&given) = self.given.get(&position_key(point)) {
                *vertex = given;
            }
        }
    }
}

/// Returns each boundary of the input as a loop of vertices along the border edges of a film over joined loops. The
/// first vertices of the film must be the points of the boundaries, in order.
///
/// # Errors
/// `invalid_mesh` if the border does not lead from each point to the next one.
pub(super) fn own_boundaries(film: &Film, boundaries: &[Vec<DVec3>]) -> Result<Vec<Vec<u32>>, Error> {
    let position = |v: u32| film.vertices[v as usize];
    let key = |v: u32| position_key(position(v));
    // The edges of the border in both directions, sorted by the position of their first vertex, and the vertices of the
    // border, sorted by their position.
    let mut edges: Vec<([u64; 3], u32)> = Vec::new();
    let mut vertices: Vec<([u64; 3], u32)> = Vec::new();
    for rim in &film.boundaries {
        for (k, &v) in rim.iter().enumerate() {
            let next = rim[(k + 1) % rim.len()];
            edges.extend([(key(v), next), (key(next), v)]);
            vertices.push((key(v), v));
        }
    }
    edges.sort_unstable();
    vertices.sort_unstable();
    let from = |list: &[([u64; 3], u32)], place: [u64; 3]| -> Vec<u32> {
        let start = list.partition_point(|entry| entry.0 < place);
        list[start..].iter().take_while(|entry| entry.0 == place).map(|entry| entry.1).collect()
    };
    let points = boundaries.iter().map(Vec::len).sum::<usize>() as u32;
    let mut is_taken = vec![false; film.vertices.len()];
    let mut first = 0;
    let mut own = Vec::with_capacity(boundaries.len());
    for boundary in boundaries {
        let count = boundary.len() as u32;
        let mut rim = Vec::new();
        for k in 0..count {
            let (mut here, target) = (first + k, first + (k + 1) % count);
            rim.push(here);
            // The number of passes is bounded, because no boundary has more edges than the border.
            for _ in 0..edges.len() {
                let way = (position(target) - position(here)).normalize_or_zero();
                let cosine = |v: u32| (position(v) - position(here)).normalize_or_zero().dot(way);
                let ends = from(&edges, key(here)).into_iter().map(|v| (cosine(v), v));
                let Some((_, next)) = ends.max_by(|a, b| a.0.total_cmp(&b.0)) else { break };
                if key(next) == key(target) {
                    here = target;
                    break;
                }
                // If several vertices lie at this place, this boundary takes an added vertex that no boundary has taken
                // yet, because the input points at the place belong to other boundaries.
                let is_own = |v: &u32| *v >= points && !is_taken[*v as usize];
                here = from(&vertices, key(next)).into_iter().find(is_own).unwrap_or(next);
                is_taken[here as usize] = true;
                rim.push(here);
            }
            if here != target {
                let detail = format!("the film's border does not lead from point {k} of a boundary to the next one");
                return Err(Error::no_result(Reason::InvalidMesh, detail));
            }
        }
        first += count;
        own.push(rim);
    }
    Ok(own)
}

fn crossing([first, second]: [PointOf; 2]) -> Error {
    let place = |(k, i): PointOf, (l, j): PointOf| {
        let detail = format!("the side from this point meets the side from point {j} of boundary {l}");
        InputError::new(Place::field("boundaries").at(k).at(i), detail)
    };
    Error::NoResult {
        reason: Reason::SelfIntersectingBoundary,
        detail: "the boundaries lie in one plane and cross there, or share a piece of a side, so that they bound no \
                 region; move the points apart, or ask for topology best if each boundary has a film of its own"
            .into(),
        places: vec![place(first, second), place(second, first)],
    }
}
