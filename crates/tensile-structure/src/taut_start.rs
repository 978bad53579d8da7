//! Taut starts: starts of form finding that hardly depend on the given shape. Corners, joints and hubs are where the
//! cables alone would hold them.
//!
//! Without the film and with straight cables of given forces the energy is Σ F ℓ, which is convex. Each point in turn
//! moves to the mean of the other ends of its cables with the weights F / ℓ (Weiszfeld, *Sur le point pour lequel la
//! somme des distances de n points donnés est minimum*, 1937). Then it moves onto its support and to the distance that
//! the lengths of its masts prescribe. The film pulls corners further in, so that form finding with the film begins
//! from a wide, taut shape.
//!
//! A mast of given length between a joint and a hub is a flying mast: its two ends move together to where their cables
//! balance. The film pulls the ring around the hub towards the film's other edges, with at most its tension times the
//! ring's length. This largest pull is used, so that the ring begins lower than it ends. Form finding succeeds from
//! there, whereas a film that is drawn too high pinches off at the ring.
//!
//! A mast on a support can lean to several sides. In a second start these masts stand upright, however they are drawn.
//!
//! A corner that is drawn too far out closes, because its sides are long arcs whose ends turn towards each other. In a
//! third start the film pulls too, and each free corner begins drawn in. The film beside a corner is modelled as the
//! triangle of the corner and its two neighbours a and b, cut by the arcs of the two sides. Let σ be the film's
//! tension. A side of the chord c and the force F pulls the corner along the chord by √(F² - (σ c / 2)²). The triangle
//! pulls the corner towards the line ab by σ |ab| / 2, which is the derivative of the triangle's energy.

use super::options::{BoundaryPoint, Cable, CableMode, Course, SlidingPart, Structure, stretch};
use plateau_mesh::DVec3;
use plateau_mesh::polyline::{length, mean, position_key, radius};
use std::collections::BTreeMap;

/// Number of sweeps over all points. In the examples, 50 sweeps bring the corners closer to their final places than
/// 1e-3 of their span.
const SWEEPS: u32 = 300;
/// Length of the shortest cable, as a fraction of the structure's radius, in a start from which a film can be found.
const SHORTEST: f64 = 1e-2;
/// A taut start differs from the given one only if a point moves by more than this fraction of the structure's radius.
const LEAST_MOTION: f64 = 1e-6;

/// The forces that hold the points of a taut start.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(super) enum Held {
    /// The cables alone.
    Cables,
    /// The cables alone, and the tops of masts on supports stand upright above their feet.
    UprightMasts,
    /// The cables, and at free corners the film too.
    Film,
}

/// How a point is held.
#[derive(Clone, Copy, Debug, PartialEq)]
enum Hold {
    Fixed,
    Free,
    /// The point slides on the support of this number.
    Slides(usize),
    /// The point moves with the ring of this number, along the ring's axis.
    Guided(usize),
}

/// A straight cable or mast between two points.
#[derive(Clone, Copy, Debug)]
struct Link {
    ends: [usize; 2],
    force: f64,
    /// Distance between the two ends, if the cable or mast holds a length.
    length: Option<f64>,
    /// The film's pull on an edge cable, a force per length. It is 0 for all other links, and for edge cables too where
    /// the cables alone hold the points.
    film: f64,
}

impl Link {
    /// The component of the force along a chord of this length. An edge cable is an arc under the film's pull, so at
    /// its ends it pulls less along the chord than along the arc.
    fn along_chord(&self, chord: f64) -> f64 {
        let across = 0.5 * self.film * chord;
        self.force.signum() * (self.force * self.force - across * across).max(0.0).sqrt()
    }
}

/// The points at which cables and masts end, and the straight links between them.
struct Network<'a> {
    structure: &'a Structure,
    places: Vec<DVec3>,
    holds: Vec<Hold>,
    number: BTreeMap<[u64; 3], usize>,
    links: Vec<Link>,
    /// The free corners between two sides, each with its two neighbours. There are none where the cables alone hold the
    /// points.
    corners: Vec<[usize; 3]>,
    radius: f64,
}

impl<'a> Network<'a> {
    fn new(structure: &'a Structure, forces: &[f64]) -> Self {
        let all: Vec<DVec3> = structure.boundaries.iter().flatten().chain(&structure.joints).copied().collect();
        let (places, holds, links) = (Vec::new(), Vec::new(), Vec::new());
        let (number, corners) = (BTreeMap::new(), Vec::new());
        let mut network = Self { structure, places, holds, number, links, corners, radius: radius(&all) };
        for (k, ring) in structure.rings.iter().enumerate() {
            ring.hub.into_iter().for_each(|hub| network.set(hub, Hold::Guided(k)));
        }
        structure.joints.iter().for_each(|&joint| network.set(joint, Hold::Free));
        let point = |BoundaryPoint { boundary, point }: BoundaryPoint| structure.boundaries[boundary][point];
        structure.free_points.iter().for_each(|&free| network.set(point(free), Hold::Free));
        for (k, sliding) in structure.sliding.iter().enumerate() {
            if let SlidingPart::Point(own) = sliding.part {
                network.set(point(own), Hold::Slides(k));
            }
        }
        for (cable, &force) in structure.cables.iter().zip(forces) {
            let (ends, in_the_air) = match &cable.course {
                Course::Boundary { boundary, from, to } => {
                    let points = &structure.boundaries[*boundary];
                    ([points[*from], points[*to]], false)
                }
                Course::Across(points) => ([points[0], points[points.len() - 1]], false),
                Course::Air(ends) | Course::Mast(ends) => (*ends, true),
            };
            let ends = ends.map(|end| network.at(end));
            let (force, length) = match cable.mode {
                CableMode::Length(length) if in_the_air => (0.0, Some(length)),
                _ if cable.course.is_mast() => (-force, None),
                _ => (force, None),
            };
            network.links.push(Link { ends, force, length, film: 0.0 });
        }
        network.add_pulls_on_rings();
        network
    }

    /// Adds the pull of the film on each ring with a hub: along the ring's axis, towards the height of the other edges.
    fn add_pulls_on_rings(&mut self) {
        let structure = self.structure;
        for (ring, hub) in structure.rings.iter().filter_map(|ring| Some((ring, ring.hub?))) {
            let others = || structure.boundaries.iter().enumerate().filter(|(k, _)| *k != ring.boundary);
            let edges: Vec<DVec3> = others().flat_map(|(_, points)| points).copied().collect();
            if edges.is_empty() {
                continue;
            }
            let height = ring.axis.dot(mean(&edges) - hub);
            let ends = [self.at(hub), self.places.len()];
            self.places.push(hub + height * ring.axis);
            self.holds.push(Hold::Fixed);
            let around = length(&structure.boundaries[ring.boundary], true);
            self.links.push(Link { ends, force: structure.pull() * around, length: None, film: 0.0 });
        }
    }

    /// Returns the number of the point at a place, and adds a fixed point if there is none.
    fn at(&mut self, place: DVec3) -> usize {
        let next = self.places.len();
        let number = *self.number.entry(position_key(place)).or_insert(next);
        if number == next {
            self.places.push(place);
            self.holds.push(Hold::Fixed);
        }
        number
    }

    fn set(&mut self, place: DVec3, hold: Hold) {
        let number = self.at(place);
        self.holds[number] = hold;
    }

    /// Places the free top of each mast on a support upright above its foot, and fixes the top. Returns whether there
    /// is any mast of this kind.
    fn set_masts_upright(&mut self) -> bool {
        let up = self.structure.up;
        let mut any = false;
        for (cable, link) in self.structure.cables.iter().zip(&self.links) {
            let ends = link.ends;
            for [foot, top] in [ends, [ends[1], ends[0]]] {
                if cable.course.is_mast() && (self.holds[foot], self.holds[top]) == (Hold::Fixed, Hold::Free) {
                    let length = link.length.unwrap_or_else(|| self.places[foot].distance(self.places[top]));
                    self.places[top] = self.places[foot] + length * up;
                    self.holds[top] = Hold::Fixed;
                    any = true;
                    break;
                }
            }
        }
        any
    }

    /// Adds the pull of the film, and moves each free corner halfway to the middle of its two neighbours. Returns
    /// whether there is a free corner.
    fn count_film(&mut self) -> bool {
        let pull = self.structure.pull();
        let sides = |cable: &Cable| match cable.course {
            Course::Boundary { boundary, from, to } => Some((boundary, from, to)),
            _ => None,
        };
        let all: Vec<_> = self.structure.cables.iter().map(sides).collect();
        for (k, side) in all.iter().enumerate() {
            let Some((boundary, _, corner)) = *side else { continue };
            self.links[k].film = pull;
            let follows = |other: &Option<(usize, usize, usize)>| {
                other.is_some_and(|(own, from, _)| own == boundary && from == corner)
            };
            let Some(next) = all.iter().position(follows) else { continue };
            let [before, here] = self.links[k].ends;
            let after = self.links[next].ends[1];
            if self.holds[here] == Hold::Free && before != after {
                self.corners.push([here, before, after]);
            }
        }
        for &[here, a, b] in &self.corners {
            let middle = 0.5 * (self.places[a] + self.places[b]);
            self.places[here] = self.places[here].midpoint(middle);
        }
        !self.corners.is_empty()
    }

    /// The force on a corner from the film's triangle between the corner and its two neighbours.
    fn film_on_corner(&self, [here, a, b]: [usize; 3]) -> DVec3 {
        let [here, a, b] = [here, a, b].map(|v| self.places[v]);
        0.5 * self.structure.pull() * a.distance(b) * (a - here).reject_from(b - a).normalize_or_zero()
    }

    /// Moves each point once, except fixed points.
    fn sweep(&mut self) {
        for v in 0..self.places.len() {
            if self.holds[v] == Hold::Fixed {
                continue;
            }
            let here = self.places[v];
            let (mut sum, mut weight) = (DVec3::ZERO, 0.0);
            let mut held = Vec::new();
            for link in self.links.iter().filter(|link| link.ends.contains(&v)) {
                let other = self.places[link.ends[usize::from(link.ends[0] == v)]];
                let length = here.distance(other).max(SHORTEST * self.radius);
                match link.length {
                    Some(wanted) => held.push((other, wanted)),
                    None if link.force >= 0.0 => {
                        let density = link.along_chord(length) / length;
                        sum += density * other;
                        weight += density;
                    }
                    // A mast pushes with a constant force.
                    None => sum += link.force / length * (other - here),
                }
            }
            sum += self
                .corners
                .iter()
                .filter(|corner| corner[0] == v)
                .map(|&corner| self.film_on_corner(corner))
                .sum::<DVec3>();
            if let Hold::Guided(ring) = self.holds[v] {
                sum += self.structure.rings[ring].force * self.structure.rings[ring].axis;
            }
            let mut place = if weight > 0.0 { sum / weight } else { here };
            match self.holds[v] {
                Hold::Guided(ring) => {
                    let axis = self.structure.rings[ring].axis;
                    place = here + axis * axis.dot(place - here);
                    for (other, length) in held {
                        place = along_to_length(here, place, axis, other, length);
                    }
                }
                Hold::Slides(k) => place = self.structure.sliding[k].on.nearest(place),
                Hold::Free | Hold::Fixed => {
                    for (other, length) in held {
                        place = other + length * (place - other).normalize_or(self.structure.up);
                    }
                }
            }
            if place.is_finite() {
                self.places[v] = place;
            }
        }
        self.fly();
    }

    /// Moves each flying mast as a whole, by the step of the cables at both ends. A mast flies if its length is given
    /// and both of its ends can move.
    fn fly(&mut self) {
        let moving = |v: usize| matches!(self.holds[v], Hold::Free | Hold::Guided(_));
        let flies = |link: &&Link| link.length.is_some() && link.ends.into_iter().all(moving);
        for [a, b] in self.links.iter().filter(flies).map(|link| link.ends).collect::<Vec<_>>() {
            let (mut sum, mut weight) = (DVec3::ZERO, 0.0);
            for link in self.links.iter().filter(|link| link.length.is_none() && link.force > 0.0) {
                for [own, other] in [link.ends, [link.ends[1], link.ends[0]]] {
                    if own == a || own == b {
                        let [here, there] = [own, other].map(|v| self.places[v]);
                        let density = link.force / here.distance(there).max(SHORTEST * self.radius);
                        sum += density * (there - here);
                        weight += density;
                    }
                }
            }
            let mut step = sum / weight.max(f64::MIN_POSITIVE);
            for v in [a, b] {
                if let Hold::Guided(ring) = self.holds[v] {
                    step = step.project_onto(self.structure.rings[ring].axis);
                }
            }
            if step.is_finite() {
                [a, b].into_iter().for_each(|v| self.places[v] += step);
            }
        }
    }

    /// Whether no cable has shrunk to almost nothing. Links that stand for the film's pull on a ring come after the
    /// cables and may be short.
    fn is_open(&self) -> bool {
        self.links.iter().take(self.structure.cables.len()).all(|link| {
            let [a, b] = link.ends.map(|v| self.places[v]);
            a.distance(b) > SHORTEST * self.radius
        })
    }

    /// Returns the structure with straight sides whose corners, joints and hubs are at the places of the network.
    fn straightened(&self) -> Structure {
        let moved = |place: DVec3| self.number.get(&position_key(place)).map_or(place, |&v| self.places[v]);
        let mut taut = self.structure.clone();
        for (boundary, points) in taut.boundaries.iter_mut().enumerate() {
            points.iter_mut().for_each(|point| *point = moved(*point));
            for cable in &self.structure.cables {
                if let Course::Boundary { boundary: own, from, to } = cable.course
                    && own == boundary
                {
                    let inner: Vec<usize> = stretch(points.len(), from, to).skip(1).collect();
                    let (first, last) = (points[from], points[to]);
                    for (i, &k) in inner.iter().enumerate() {
                        points[k] = first.lerp(last, (i + 1) as f64 / (inner.len() + 1) as f64);
                    }
                }
            }
        }
        for ring in &mut taut.rings {
            if let Some(hub) = ring.hub {
                let travel = moved(hub) - hub;
                taut.boundaries[ring.boundary].iter_mut().for_each(|point| *point += travel);
                ring.hub = Some(moved(hub));
            }
        }
        // Ends of cables follow the points and the segments of the boundaries on which they lie.
        for (end, given) in taut.across_ends.iter_mut().zip(&self.structure.across_ends) {
            let segment = |boundaries: &[Vec<DVec3>]| {
                let points = &boundaries[given.boundary];
                [points[given.segment], points[(given.segment + 1) % points.len()]]
            };
            let ([a, b], [from, to]) = (segment(&self.structure.boundaries), segment(&taut.boundaries));
            end.place = from.lerp(to, a.distance(given.place) / a.distance(b));
        }
        let ends = |of: &Structure| -> Vec<DVec3> {
            of.across_ends.iter().map(|end| end.place).chain(of.boundaries.iter().flatten().copied()).collect()
        };
        let (given, places) = (ends(self.structure), ends(&taut));
        let followed =
            |end: DVec3| given.iter().position(|place| *place == end).map_or_else(|| moved(end), |k| places[k]);
        taut.joints.iter_mut().for_each(|joint| *joint = moved(*joint));
        for cable in &mut taut.cables {
            match &mut cable.course {
                Course::Boundary { .. } => {}
                Course::Air(ends) | Course::Mast(ends) => *ends = ends.map(followed),
                Course::Across(points) => {
                    let ends = [points[0], points[points.len() - 1]];
                    let travel = 0.5 * (followed(ends[0]) + followed(ends[1]) - ends[0] - ends[1]);
                    let last = points.len() - 1;
                    for (k, point) in points.iter_mut().enumerate() {
                        *point = if k == 0 || k == last { followed(*point) } else { *point + travel };
                    }
                }
            }
        }
        taut
    }
}

/// Returns the point at the distance `length` from `other` on the line through `place` along the axis, on the side of
/// `other` on which `here` is. Returns `place` if the whole line is farther away.
fn along_to_length(here: DVec3, place: DVec3, axis: DVec3, other: DVec3, length: f64) -> DVec3 {
    let (across, along) = ((place - other).reject_from_normalized(axis), axis.dot(here - other));
    let squared = length * length - across.length_squared();
    if squared <= 0.0 {
        return place;
    }
    other + across + axis * squared.sqrt().copysign(along)
}

/// Returns the structure with straight sides. Its corners, joints and hubs stand where they are in equilibrium under
/// the forces that `held` names; `forces` are those of the cables.
///
/// Returns `None` if nothing moves or a cable shrinks to nothing. Returns `None` too if masts are to stand upright and
/// there are none, or if the film is to hold corners and none is free.
pub(super) fn taut(structure: &Structure, forces: &[f64], held: Held) -> Option<Structure> {
    let mut network = Network::new(structure, forces);
    let before = network.places.clone();
    let applies = match held {
        Held::Cables => true,
        Held::UprightMasts => network.set_masts_upright(),
        Held::Film => network.count_film(),
    };
    if !applies {
        return None;
    }
    for _ in 0..SWEEPS {
        network.sweep();
    }
    let moves = |(a, b): (&DVec3, &DVec3)| a.distance(*b) > LEAST_MOTION * network.radius;
    if !network.is_open() || !before.iter().zip(&network.places).any(moves) {
        return None;
    }
    Some(network.straightened())
}

/// Returns the structure with straight sides whose corners on supports have moved away from `ends`, the places to which
/// they slid in an attempt that failed: each corner is as far from its given place, on the other side of that place,
/// but at most half the length of its shorter side away. The corners are in the order of the supports. Returns `None`
/// if no corner slides or none has moved.
///
/// The film pulls a corner towards both of its neighbours, so that the corner may have an unstable place between two
/// stable ones. On one side of the unstable place the film may close, although an equilibrium exists on the other.
pub(super) fn slid_back(structure: &Structure, forces: &[f64], ends: &[DVec3]) -> Option<Structure> {
    let mut network = Network::new(structure, forces);
    let corners: Vec<(usize, usize)> = (structure.sliding.iter().enumerate())
        .filter_map(|(k, sliding)| match sliding.part {
            SlidingPart::Point(BoundaryPoint { boundary, point }) => {
                Some((k, *network.number.get(&position_key(structure.boundaries[boundary][point]))?))
            }
            SlidingPart::Edge { .. } | SlidingPart::Boundary(_) => None,
        })
        .collect();
    let before = network.places.clone();
    for (&(k, v), end) in corners.iter().zip(ends) {
        let sides = network.links.iter().filter(|link| link.ends.contains(&v));
        let shortest = sides.map(|link| link.ends.map(|end| before[end])).map(|[a, b]| a.distance(b));
        let step = (before[v] - *end).clamp_length_max(0.5 * shortest.fold(f64::INFINITY, f64::min));
        network.places[v] = structure.sliding[k].on.nearest(before[v] + step);
    }
    let moves = |(a, b): (&DVec3, &DVec3)| a.distance(*b) > LEAST_MOTION * network.radius;
    before.iter().zip(&network.places).any(moves).then(|| network.straightened())
}
