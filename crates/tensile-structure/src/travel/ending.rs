//! Endings without a shape: a vertex runs away, or a part of the structure closes or shrinks to nothing.

use crate::form_finding::{Ending, Run};
use crate::model::{Model, ModelCable};
use crate::options::{Course, Sliding, SlidingPart, cable_place};
use plateau_mesh::error::InputError;
use plateau_mesh::remesh::moving::Neck;
use plateau_mesh::{DVec3, Place};

/// A cable of given force counts as shrinking only if it is shorter than this fraction of the start's span. Until the
/// cable has shrunk to nothing or found its length, its forces cannot balance, so a failure of Newton's method in the
/// meantime is not counted.
const SHORT: f64 = 0.2;
/// A cable counts as shrinking if a round leaves it shorter than this fraction of its length before the round.
const SHRINKS: f64 = 0.97;
/// A cable that shrinks below this fraction of the start's span, round after round, counts as shrinking to nothing. A
/// cable in the air may be shorter by the factor [`SHORTER_IN_THE_AIR`], because it needs no vertices of the film. An
/// edge of a structure in equilibrium may be short too, so its length alone decides nothing.
const SHORTEST: f64 = 1e-2;
/// Factor on [`SHORTEST`] for cables in the air and masts.
const SHORTER_IN_THE_AIR: f64 = 0.1;
/// A cable counts as shrunk to nothing below this fraction of the length at which it counts as shrinking, whether it
/// shrinks or not.
const NOTHING: f64 = 1e-2;
/// Number of consecutive rounds in which a corner, a cable or a narrow place must go on closing before it counts as
/// closed.
const CLOSING: u32 = 10;
/// A corner below this angle, in degrees, may be closing. Sharp corners open again, so the angle alone decides nothing.
const CLOSES: f64 = 3.0;
/// A corner counts as closed if it stays below this angle, in degrees, for [`STAYS_CLOSED`] rounds.
const CLOSED: f64 = 0.2;
/// Number of consecutive rounds below [`CLOSED`] after which a corner counts as closed.
const STAYS_CLOSED: u32 = 3;
/// A vertex runs away if it is farther than this from the start's centre, in radii of the start.
const FAR: f64 = 20.0;

/// Figures that an attempt follows from round to round to see whether a part closes or shrinks to nothing.
pub(super) struct Watch {
    centre: DVec3,
    radius: f64,
    span: f64,
    area: f64,
    least_angle: f64,
    closing: u32,
    closed: u32,
    narrow: Option<Strait>,
    last_width: f64,
    pinching: u32,
    pub necks: u32,
    pub last_neck: Option<Neck>,
    /// A shape in equilibrium on the last level without a neck, as it was before its mesh was renewed.
    pub worn: Option<Model>,
    compressed: u32,
    /// For each cable its length in the last round, and the number of consecutive rounds in which it shrank.
    shrinking: Vec<(f64, u32)>,
    /// The length of the shortest cable of given force in the air.
    shortest: f64,
    /// Whether this cable is shrinking.
    pub shrinks: bool,
}

/// The narrowest place between two sides of the film.
#[derive(Clone, Copy)]
pub(super) struct Strait {
    /// The width divided by the distance from the nearest corner.
    ratio: f64,
    width: f64,
    place: DVec3,
}

impl Run<'_> {
    pub(super) fn watch(&self) -> Watch {
        let at = self.model.vertices();
        let centre = plateau_mesh::polyline::mean(&at);
        let radius = at.iter().map(|p| p.distance(centre)).fold(0.0, f64::max);
        let (low, high) = at.iter().fold((DVec3::INFINITY, DVec3::NEG_INFINITY), |(l, h), p| (l.min(*p), h.max(*p)));
        Watch {
            centre,
            radius,
            span: low.distance(high),
            area: self.model.layers[0].film.area(),
            least_angle: f64::INFINITY,
            closing: 0,
            closed: 0,
            narrow: None,
            last_width: f64::INFINITY,
            pinching: 0,
            necks: 0,
            last_neck: None,
            worn: None,
            compressed: 0,
            shrinking: vec![(f64::INFINITY, 0); self.structure.cables.len()],
            shortest: f64::INFINITY,
            shrinks: false,
        }
    }

    /// The ending of the attempt if the present shape shows that it cannot succeed; `None` if the attempt goes on.
    pub(super) fn ending(&self, watch: &mut Watch, edge: f64) -> Option<Ending> {
        let at = self.model.vertices();
        let place = |p: DVec3| {
            let DVec3 { x, y, z } = p + self.model.centre;
            format!("({x:.4}, {y:.4}, {z:.4})")
        };
        let distances = at.iter().map(|p| p.distance(watch.centre)).enumerate();
        let (v, distance) = distances.max_by(|a, b| a.1.total_cmp(&b.1))?;
        if distance.is_nan() || distance > FAR * watch.radius {
            let detail = format!(
                "a vertex runs away: it is at {}, {:.0} times the radius of the start from its centre",
                place(at[v]),
                distance / watch.radius
            );
            let own = self.place_of(v as u32).map(|place| InputError::new(place, "runs away"));
            return Some(Ending::RunsAway(detail, own));
        }
        if let Some(ending) = self.corner(watch, &at, &place) {
            return Some(ending);
        }
        self.narrowest(watch, &at, edge);
        if watch.pinching >= CLOSING
            && let Some(strait) = watch.narrow
        {
            let detail = format!("the film pinches off: it is {:.3e} wide near {}", strait.width, place(strait.place));
            return Some(Ending::Collapses(detail, None));
        }
        if watch.necks >= 6
            && let Some(neck) = watch.last_neck
        {
            return Some(self.pinched(neck));
        }
        let mut shortest = f64::INFINITY;
        for (k, cable) in self.structure.cables.iter().enumerate() {
            let length = self.model.cables[k].term.length(&at);
            if matches!(cable.course, Course::Air(_)) && !self.model.holds_length(k) {
                shortest = shortest.min(length);
            }
            let in_the_air = matches!(cable.course, Course::Air(_) | Course::Mast(_));
            let least = watch.span * SHORTEST * if in_the_air { SHORTER_IN_THE_AIR } else { 1.0 };
            let (last, rounds) = watch.shrinking[k];
            let rounds = if length < (SHRINKS * last).min(least) { rounds + 1 } else { 0 };
            watch.shrinking[k] = (length, rounds);
            if (rounds >= CLOSING || length < NOTHING * least) && !self.model.holds_length(k) {
                let detail = format!("cable {} shrinks to nothing: its length is {length:.3e}", cable.name);
                // The error names the end of the cable if that end moves, because its place is wrong, not the cable.
                let end = self.model.cables[k].ends().into_iter().find_map(|v| self.place_of(v));
                let own = match end {
                    Some(end) => InputError::new(end, format!("moves to the other end of cable {}", cable.name)),
                    None => InputError::new(cable_place(self.structure, k), "shrinks to nothing"),
                };
                return Some(Ending::Collapses(detail, Some(own)));
            }
        }
        watch.shrinks = shortest < (SHRINKS * watch.shortest).min(SHORT * watch.span);
        watch.shortest = shortest;
        let area = self.model.layers[0].film.area();
        if area < 1e-4 * watch.area {
            return Some(Ending::Collapses(format!("the film shrinks to an area of {area:.3e}"), None));
        }
        if self.structure.has_heavy_layers() {
            let weights = self.model.weights(self.structure, &at);
            let least = self.model.triangles().iter().map(|t| weights[0].tension(t, &at)).fold(0.0, f64::min);
            let tension = self.structure.layers[0].mean() + least;
            watch.compressed = if tension <= 0.0 { watch.compressed + 1 } else { 0 };
            if watch.compressed >= 5 {
                let detail = format!(
                    "the film's lowest part would be in compression: its weight leaves a tension of {tension:.4}"
                );
                let own = InputError::new(Place::field("film").then("weight"), "is more than the tension bears");
                return Some(Ending::Collapses(detail, Some(own)));
            }
        }
        None
    }

    /// The ending of a film that closes at a neck.
    pub(super) fn pinched(&self, neck: Neck) -> Ending {
        let DVec3 { x, y, z } = neck.place + self.model.centre;
        let girth = neck.girth;
        Ending::Collapses(
            format!("the film pinches off at a neck of girth {girth:.4} near ({x:.4}, {y:.4}, {z:.4})"),
            None,
        )
    }

    /// The ending of a film that closes at a corner; `None` if it does not close.
    fn corner(&self, watch: &mut Watch, at: &[DVec3], place: &dyn Fn(DVec3) -> String) -> Option<Ending> {
        let mut angles = vec![0.0; at.len()];
        for triangle in self.model.layers[0].film.triangles() {
            for k in 0..3 {
                let [a, b, c] = [0, 1, 2].map(|i| at[triangle[(k + i) % 3] as usize]);
                angles[triangle[k] as usize] += libm::atan2((b - a).cross(c - a).length(), (b - a).dot(c - a));
            }
        }
        let corners = self.model.corners();
        let &(v, boundary, point) =
            corners.iter().min_by(|a, b| angles[a.0 as usize].total_cmp(&angles[b.0 as usize]))?;
        let angle = angles[v as usize].to_degrees();
        watch.closing = if angle < CLOSES && angle <= 1.02 * watch.least_angle { watch.closing + 1 } else { 0 };
        watch.closed = if angle < CLOSED { watch.closed + 1 } else { 0 };
        watch.least_angle = angle;
        (watch.closing >= CLOSING || watch.closed >= STAYS_CLOSED).then(|| {
            let detail = format!(
                "the film closes at point {point} of boundary {boundary}, at {}: its sides meet at {angle:.2} degrees",
                place(at[v as usize])
            );
            // If the corner is a support, it has not moved: the other end of a side has moved too far.
            let ends = self.model.cables.iter().map(ModelCable::ends);
            let other = |[a, b]: [u32; 2]| if a == v { Some(b) } else { (b == v).then_some(a) };
            let own = self
                .place_of(v)
                .or_else(|| ends.filter_map(other).find_map(|end| self.place_of(end)))
                .unwrap_or_else(|| Place::field("boundaries").at(boundary).at(point));
            Ending::Collapses(detail, Some(InputError::new(own, "the film closes at this point or beside it")))
        })
    }

    /// Returns the place in the input of a vertex that can move: a joint, a hub, a free point or a sliding point.
    /// `None` for other vertices.
    fn place_of(&self, v: u32) -> Option<Place> {
        let structure = self.structure;
        let hubs = structure.rings.iter().enumerate().filter(|(_, ring)| ring.hub.is_some());
        let in_the_air = (v as usize).checked_sub(self.model.films);
        let joined = hubs.map(|(k, _)| Place::field("rings").at(k));
        let mut joined = joined.chain((0..structure.joints.len()).map(|k| Place::field("joints").at(k)));
        let free = || self.model.free.iter().position(|&own| own == v).map(|k| Place::field("free_points").at(k));
        let is_here = |point| self.model.input_vertex(point) == v;
        let slides = |sliding: &Sliding| matches!(sliding.part, SlidingPart::Point(point) if is_here(point));
        let sliding = || structure.sliding.iter().position(slides).map(|k| Place::field("supports").at(k));
        match in_the_air {
            Some(k) => joined.nth(k),
            None => free().or_else(sliding),
        }
    }

    /// Finds the narrowest chord, which is an inner edge between two boundary vertices, relative to its distance from
    /// the nearest corner. Follows its width in `watch`. Chords between held vertices are left out: they are as narrow
    /// as the frame, and the film does not close there.
    fn narrowest(&self, watch: &mut Watch, at: &[DVec3], edge: f64) {
        let topology = &self.model.layers[0].film.topology;
        let held = self.model.held();
        let kept: Vec<DVec3> = self.model.corners().iter().map(|corner| at[corner.0 as usize]).collect();
        let mut narrow = None::<Strait>;
        for h in 0..topology.twin.len() as u32 {
            let (a, b) = (topology.from(h), topology.to(h));
            if topology.twin[h as usize] <= h
                || topology.hinge(h).is_none()
                || !topology.is_boundary(a)
                || !topology.is_boundary(b)
                || held[a as usize] && held[b as usize]
            {
                continue;
            }
            let middle = 0.5 * (at[a as usize] + at[b as usize]);
            let distance = kept.iter().map(|p| p.distance(middle)).fold(watch.span, f64::min);
            let width = at[a as usize].distance(at[b as usize]);
            if distance > 1.5 * edge && narrow.is_none_or(|known| width / distance < known.ratio) {
                narrow = Some(Strait { ratio: width / distance, width, place: middle });
            }
        }
        let thin = narrow.filter(|strait| strait.ratio < 0.03 && strait.width < 0.15 * edge);
        let goes_on = thin.is_some_and(|strait| strait.width <= 1.05 * watch.last_width);
        watch.pinching = if goes_on { watch.pinching + 1 } else { 0 };
        watch.last_width = thin.map_or(f64::INFINITY, |strait| strait.width);
        watch.narrow = narrow;
    }

    /// The ending of an attempt in which no step keeps the mesh valid.
    pub(super) fn stuck(&self, watch: &Watch) -> Ending {
        let narrow = watch.narrow.filter(|strait| strait.ratio < 0.03);
        if watch.least_angle < CLOSES {
            let detail = format!("the film closes at a corner: its sides meet at {:.2} degrees", watch.least_angle);
            return Ending::Collapses(detail, None);
        }
        match narrow {
            Some(strait) => {
                let DVec3 { x, y, z } = strait.place + self.model.centre;
                let detail =
                    format!("the film pinches off: it is {:.3e} wide near ({x:.4}, {y:.4}, {z:.4})", strait.width);
                Ending::Collapses(detail, None)
            }
            None => Ending::NotFound("no step of the form finding keeps the mesh whole".into()),
        }
    }
}
