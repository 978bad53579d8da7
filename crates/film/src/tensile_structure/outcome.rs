//! A shape that was found: mesh, forces, figures and warnings, at the position of the caller's boundaries.

use super::form_finding::{Balance, Found};
use super::model::{Model, MovingRing, forces};
use super::options::{
    BoundaryPoint, CableMode, Chamber, Course, FilmPrestress, FilmStress, Ring, Structure, Weave, WeaveHold,
    cable_place, chord,
};
use super::ponding::{self, Ponding, Roof};
use crate::energy::PlaneStress;
use crate::equilibrium::{Freedom, Support};
use crate::minimal_surface::StopReason;
use plateau_mesh::error::{InputError, Warning};
use plateau_mesh::measure::{self, Spread, double_area_vector};
use plateau_mesh::self_intersections::{self, Order, SelfIntersectionCheck};
use plateau_mesh::{DVec3, Error, Execution, Mesh};

/// A support at one vertex: the end of a cable, or an anchor in the air.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Reaction {
    /// The vertex.
    pub vertex: u32,
    /// The point of the boundary, if it is one.
    pub point: Option<BoundaryPoint>,
    /// The force of the support on the structure.
    pub force: DVec3,
}

/// The supports along the fixed parts of a boundary together, without those of [`Reaction`].
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct EdgeReaction {
    /// The boundary.
    pub boundary: usize,
    /// The sum of the forces of the supports on the structure.
    pub force: DVec3,
}

/// A cable of the shape.
#[derive(Clone, Debug, PartialEq)]
pub struct CableResult {
    /// Its vertices from the first end to the last.
    pub vertices: Vec<u32>,
    /// The force in each segment.
    pub segment_forces: Vec<f64>,
    /// The mean force, weighted by length.
    pub force: f64,
    /// Length.
    pub length: f64,
    /// L0 = L / (1 + F / EA), if the axial stiffness is known.
    pub unstressed_length: Option<f64>,
    /// The largest distance from the chord between the ends.
    pub sag: f64,
    /// Whether it carries no force.
    pub slack: bool,
}

/// Principal stresses of the film over all triangles.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct Stress {
    /// The least principal stress, a force per length.
    pub min: f64,
    /// The largest principal stress.
    pub max: f64,
    /// The largest deviation of a principal stress from the required one, as a fraction of it. Of a woven film that of
    /// the stresses along warp and weft from those required at the same place.
    pub deviation: f64,
    /// The stresses of a woven film.
    pub weave: Option<WeaveStress>,
}

/// The stresses of a woven film along warp and weft.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct WeaveStress {
    /// What the required stresses hold constant.
    pub hold: WeaveHold,
    /// The stress along the warp.
    pub warp: StressRange,
    /// The stress along the weft.
    pub weft: StressRange,
    /// The weft's stress over the warp's.
    pub ratio: StressRange,
    /// The ratio that was asked for.
    pub required_ratio: f64,
    /// The root mean square over the film of the ratio over the required one, less 1.
    pub ratio_deviation_rms: f64,
    /// The root mean square over the film of both stresses over those required at the same place, less 1.
    pub deviation_rms: f64,
}

/// The least, the largest and the mean value over the film's area.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct StressRange {
    /// The least value.
    pub min: f64,
    /// The largest value.
    pub max: f64,
    /// The mean by area.
    pub mean: f64,
}

/// A layer of the shape. Its triangles follow those of the layers before it.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct LayerResult {
    /// Number of triangles.
    pub triangles: usize,
    /// Area.
    pub area: f64,
    /// Principal stresses; `None` if the forces could not be balanced.
    pub stress: Option<Stress>,
}

/// A chamber of the shape.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct ChamberResult {
    /// The pressure above that outside, given or found.
    pub pressure: f64,
    /// The volume up to the next layer, or up to fans from each boundary to its mean.
    pub volume: f64,
}

/// The sums of the forces.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct ForceBalance {
    /// The sum of all loads: weights and pressure.
    pub loads: DVec3,
    /// The sum of all reactions.
    pub reactions: DVec3,
    /// The sum of the reactions' magnitudes, support by support.
    pub magnitudes: f64,
    /// |loads + reactions| over the sum of the magnitudes.
    pub imbalance: f64,
    /// The largest force on a vertex that is not balanced.
    pub residual_force: f64,
}

/// The stability of the shape.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Stability {
    /// Whether the Morse index is 0: a true local minimum of the energy.
    pub stable: bool,
    /// Number of negative eigenvalues of the second variation.
    pub morse_index: usize,
    /// Lowest eigenvalue against the lumped mass, in 1/unit².
    pub lowest_eigenvalue: f64,
}

/// Figures of the shape and of the run.
#[derive(Clone, Debug, PartialEq)]
pub struct Statistics {
    /// σ A + Σ T L + …, a force times a length.
    pub energy: f64,
    /// Number of vertices, those of cables in the air included.
    pub vertices: usize,
    /// Number of triangles.
    pub triangles: usize,
    /// Area of all layers.
    pub area: f64,
    /// The layers in the order of the input.
    pub layers: Vec<LayerResult>,
    /// The chambers in the order of the input.
    pub chambers: Vec<ChamberResult>,
    /// How far the shape is from equilibrium, dimensionless.
    pub residual: f64,
    /// Whether the residual is at most the tolerance and no triangle is flipped or degenerate.
    pub converged: bool,
    /// Why form finding ended.
    pub stop_reason: StopReason,
    /// Number of linear solves.
    pub iterations: u32,
    /// Principal stresses of all layers; `None` if the forces could not be balanced.
    pub stress: Option<Stress>,
    /// Sums of the forces; `None` if the forces could not be balanced.
    pub balance: Option<ForceBalance>,
    /// The least and the largest angle between the film's pull on an edge that slides on a surface and that surface, in
    /// radians; in equilibrium a right angle, or the given one. `None` without such an edge.
    pub contact_angle: Option<(f64, f64)>,
    /// Stability, if it was found.
    pub stability: Option<Stability>,
    /// The least slope of a triangle against the horizontal, in radians.
    pub minimum_slope: f64,
    /// The centroid of the triangle with the least slope.
    pub flattest_place: DVec3,
    /// The water that stands on the film after rain; `None` if it runs off.
    pub ponding: Option<Ponding>,
    /// Lengths of the film's edges.
    pub edge_lengths: Spread,
    /// Smallest and largest inner angle, in radians.
    pub angles: (f64, f64),
    /// Number of flipped triangles.
    pub flipped_triangles: usize,
    /// Number of degenerate triangles.
    pub degenerate_triangles: usize,
    /// Pairs of triangles of the film that intersect.
    pub self_intersections: SelfIntersectionCheck,
}

/// A tensile structure in equilibrium.
#[derive(Clone, Debug, PartialEq)]
pub struct TensileStructure {
    /// Vertices: the input's points in input order, equal neighbours once, fixed ones at exactly the given coordinates;
    /// then the film's others; then those of cables in the air, which belong to no triangle.
    pub mesh: Mesh,
    /// Each boundary as a loop of vertices, in the input's direction, added points included.
    pub boundaries: Vec<Vec<u32>>,
    /// For each input point its vertex.
    pub input_vertices: Vec<Vec<u32>>,
    /// The cables in the order of the input.
    pub cables: Vec<CableResult>,
    /// Supports at single vertices.
    pub reactions: Vec<Reaction>,
    /// Supports along edges.
    pub edge_reactions: Vec<EdgeReaction>,
    /// For each ring that moves how far it has moved along its axis.
    pub ring_travels: Vec<f64>,
    /// Figures.
    pub statistics: Statistics,
    /// Facts that the caller should know although the solve went through.
    pub warnings: Vec<Warning>,
}

/// A cable counts as slack below this fraction of the film's tension times the cable's length. Rounding errors are far
/// below, and every force that holds an edge of the film is above 1/2.
const SLACK: f64 = 1e-9;
/// A structure counts as a mechanism if its lowest eigenvalue is below this, in units of 1/R². That of a plane film
/// between cables is about 1 to 10.
const MECHANISM: f64 = 1e-6;
/// Vertices that move by more than this fraction of the largest displacement of the lowest mode are named.
const MOVES: f64 = 0.5;
/// A woven film whose stresses deviate from the required ones by more than this (root mean square) gets a warning. On
/// the meshes of the examples the deviation that is the mesh's error alone is below 0.02.
const DEVIATES: f64 = 0.05;
/// An edge counts as beyond its mesh if a vertex is further from the mesh than this fraction of its rounding. The
/// rounding of a right-angled edge takes a vertex 0.14 of it away.
const BEYOND: f64 = 0.5;
/// Number of points that a message lists.
const LISTED: usize = 12;

/// The stress F S Fᵀ / det F of a triangle that was deformed from its reference shape.
struct Deformed {
    /// The images F w and F f of the directions of the reference stress S = σ_w w wᵀ + σ_f f fᵀ.
    images: [DVec3; 2],
    reference: PlaneStress,
    /// det F.
    stretch: f64,
}

impl Deformed {
    fn of(stress: PlaneStress, reference: [DVec3; 3], now: [DVec3; 3]) -> Self {
        let (a, b) = (reference[1] - reference[0], reference[2] - reference[0]);
        let normal = a.cross(b).normalize_or_zero();
        let along = stress.direction;
        let across = normal.cross(along);
        let ([a_along, b_along], [a_across, b_across]) = ([a, b].map(|e| e.dot(along)), [a, b].map(|e| e.dot(across)));
        let determinant = a_along * b_across - a_across * b_along;
        let (p, q) = (now[1] - now[0], now[2] - now[0]);
        let images = [(p * b_across - q * a_across) / determinant, (q * a_along - p * b_along) / determinant];
        Self { images, reference: stress, stretch: images[0].cross(images[1]).length() }
    }

    /// The stress across a line at right angles to a unit vector of the triangle's plane.
    fn along(&self, direction: DVec3) -> f64 {
        let [w, f] = self.images.map(|image| image.dot(direction));
        (self.reference.along * w * w + self.reference.across * f * f) / self.stretch
    }

    /// The least and the largest principal stress. Their product is that of the reference stress's.
    fn principal(&self) -> (f64, f64) {
        let PlaneStress { along, across, .. } = self.reference;
        let [w, f] = self.images.map(DVec3::length_squared);
        let half = 0.5 * (along * w + across * f) / self.stretch;
        let root = (half * half - along * across).max(0.0).sqrt();
        (half - root, half + root)
    }
}

/// The stresses of all layers together.
fn of_all(layers: &[LayerResult]) -> Option<Stress> {
    let widen = |a: Stress, b: Stress| Stress {
        min: a.min.min(b.min),
        max: a.max.max(b.max),
        deviation: a.deviation.max(b.deviation),
        weave: a.weave,
    };
    layers.iter().filter_map(|layer| layer.stress).reduce(widen)
}

/// The stresses of a layer of the balanced shape, all required stresses those of the reference shape but of an isotropic
/// film the given tension. `first` is the number of the layer's first triangle.
fn stress(
    balance: &Balance,
    film: &FilmStress,
    model: &Model,
    first: usize,
    triangles: &[[u32; 3]],
    at: &[DVec3],
) -> Stress {
    let mut stress = Stress { min: f64::INFINITY, max: 0.0, deviation: 0.0, weave: None };
    let mut woven = WovenSums::default();
    for (triangle, own) in triangles.iter().zip(&balance.stresses[first..]) {
        let now = triangle.map(|v| at[v as usize]);
        let found = Deformed::of(*own, triangle.map(|v| balance.reference[v as usize]), now);
        let (least, most) = found.principal();
        (stress.min, stress.max) = (stress.min.min(least), stress.max.max(most));
        if let Some(field) = &model.stress_field {
            let normal = double_area_vector(now);
            let warp = field.required(triangle, at).direction;
            let weft = normal.normalize_or_zero().cross(warp);
            woven.add(0.5 * normal.length(), [found.along(warp), found.along(weft)], *own);
        }
    }
    match film.weave() {
        None => {
            let tension = film.mean();
            stress.deviation = (stress.max / tension - 1.0).abs().max((1.0 - stress.min / tension).abs());
        }
        Some(weave) => {
            stress.deviation = woven.largest_deviation;
            stress.weave = Some(woven.finish(weave));
        }
    }
    stress
}

/// Sums over the triangles of a woven film.
#[derive(Default)]
struct WovenSums {
    area: f64,
    warp: RangeAndSum,
    weft: RangeAndSum,
    ratio: RangeAndSum,
    squared_deviation: f64,
    largest_deviation: f64,
    squared_ratio_deviation: f64,
}

#[derive(Default)]
struct RangeAndSum {
    range: Option<(f64, f64)>,
    sum: f64,
}

impl RangeAndSum {
    fn add(&mut self, value: f64, weight: f64) {
        let (least, most) = self.range.unwrap_or((value, value));
        self.range = Some((least.min(value), most.max(value)));
        self.sum += weight * value;
    }

    fn finish(&self, area: f64) -> StressRange {
        let (min, max) = self.range.unwrap_or_default();
        StressRange { min, max, mean: self.sum / area }
    }
}

impl WovenSums {
    fn add(&mut self, area: f64, [warp, weft]: [f64; 2], required: PlaneStress) {
        let deviations = [warp / required.along - 1.0, weft / required.across - 1.0];
        let ratio = (weft / warp) / (required.across / required.along) - 1.0;
        self.area += area;
        self.warp.add(warp, area);
        self.weft.add(weft, area);
        self.ratio.add(weft / warp, area);
        self.squared_deviation += area * 0.5 * deviations.map(|d| d * d).iter().sum::<f64>();
        self.squared_ratio_deviation += area * ratio * ratio;
        self.largest_deviation = deviations.into_iter().map(f64::abs).fold(self.largest_deviation, f64::max);
    }

    fn finish(&self, weave: &Weave) -> WeaveStress {
        WeaveStress {
            hold: weave.hold,
            warp: self.warp.finish(self.area),
            weft: self.weft.finish(self.area),
            ratio: self.ratio.finish(self.area),
            required_ratio: weave.weft / weave.warp,
            ratio_deviation_rms: (self.squared_ratio_deviation / self.area).sqrt(),
            deviation_rms: (self.squared_deviation / self.area).sqrt(),
        }
    }
}

/// The names of cables whose force cannot hold a plane edge: an arc of radius F / σ does not reach across the chord.
fn weak_cables(structure: &Structure) -> Vec<InputError> {
    let [FilmStress { prestress: FilmPrestress::Isotropic(tension), .. }] = structure.layers[..] else {
        return Vec::new();
    };
    let weak = |(k, cable): (usize, &super::options::Cable)| {
        let CableMode::Force(force) = cable.mode else { return None };
        if !matches!(cable.course, Course::Boundary { .. }) {
            return None;
        }
        let least = 0.5 * tension * chord(structure, cable)?;
        (force < least).then(|| {
            let detail = format!("holds no plane edge of this film: half the tension times the chord is {least:.6}");
            InputError::new(cable_place(structure, k).then("value"), detail)
        })
    };
    structure.cables.iter().enumerate().filter_map(weak).collect()
}

fn no_equilibrium(structure: &Structure) -> Error {
    let places = weak_cables(structure);
    let detail = if places.is_empty() {
        "no shape in equilibrium was reached: the film collapses or bulges without end; try larger cable forces, a \
         smaller pressure, or supports nearer to each other"
    } else {
        "no shape in equilibrium was reached: the film pulls the edge cables in without end; give them larger forces"
    };
    Error::NoResult { reason: "no_equilibrium", detail: detail.into(), places }
}

/// A cable of given length or shape that would have to push.
fn pushing_cable(structure: &Structure, model: &Model, found: &Found, at: &[DVec3]) -> Option<Error> {
    let mean = |(term, &further): (&crate::energy::Cable, &f64)| forces(term, further, at).0;
    let is_cable = |k: &usize| !structure.cables[*k].course.is_mast();
    let all = model.cables.iter().zip(&found.length_forces).map(mean).enumerate();
    let pushes = all.filter(|(_, force)| *force < 0.0).map(|(k, _)| k).find(is_cable);
    // An elastic cable may be slack; a cable of given length may not, because its length is not reached.
    let of_length = |k: &usize| matches!(structure.cables[*k].mode, CableMode::Length(_));
    let k = pushes.or_else(|| found.slack.iter().copied().find(of_length))?;
    let place = InputError::new(
        cable_place(structure, k).then("value"),
        "is longer than the film pulls it: the cable would be slack",
    );
    let detail = format!("cable {} would be slack at this length", structure.cables[k].name);
    Some(Error::NoResult { reason: "slack_cable", detail, places: vec![place] })
}

/// Measures the shape and moves it back to the position of the input.
pub(super) fn finish(
    model: Model,
    found: Found,
    structure: &Structure,
    exec: &Execution,
) -> Result<TensileStructure, Error> {
    let gave_up = matches!(found.stop_reason, StopReason::Stalled | StopReason::Collapsed);
    if !found.residual.is_finite() || (gave_up && !(found.is_shape() && model.flipped() == 0)) {
        return Err(no_equilibrium(structure));
    }
    let at = model.vertices();
    if let Some(error) = pushing_cable(structure, &model, &found, &at) {
        return Err(error);
    }
    let film = model.mesh();
    let triangles = film.triangles.clone();
    let (layers, edge_lengths) = measure_layers(&model, &found, structure, &at)?;
    let cables = cables(&model, &found, structure, &at);
    let (flipped, degenerate) = (model.flipped(), measure::degenerate_triangles(&film));
    let (minimum_slope, flattest_place) = flattest(&triangles, &at, structure.up);
    let (rims, folds) = (model.boundaries(), &model.layers[0].film.locked);
    let ponding = ponding::find(&Roof { triangles: &triangles, at: &at, rims, folds, up: structure.up }, exec)?;
    let chamber =
        |(chamber, &pressure): (&Chamber, &f64)| ChamberResult { pressure, volume: model.volume(chamber.below, &at) };
    let chambers = structure.chambers.iter().zip(&found.pressures).map(chamber).collect();
    let mesh = Mesh::new(at.iter().map(|p| *p + model.centre).collect(), triangles.clone());
    let (self_intersections, crossings) = self_intersections::check(&mesh, Order::Spatial, usize::MAX, exec)?;
    let holds = holds(&model);
    let balance = found.balance.as_ref().map(|balance| sums(&model, balance, &holds, &at));
    let (reactions, edge_reactions) = reactions(&model, &found, &holds);
    let statistics = Statistics {
        energy: found.energy,
        vertices: at.len(),
        triangles: triangles.len(),
        area: measure::area(&film),
        stress: of_all(&layers),
        layers,
        chambers,
        residual: found.residual,
        converged: found.stop_reason == StopReason::Residual && flipped == 0 && degenerate == 0,
        stop_reason: found.stop_reason,
        iterations: found.iterations,
        balance,
        contact_angle: found.balance.as_ref().and_then(|balance| contact_angles(&model, balance, &holds, &at)),
        stability: found.stability.map(|stability| Stability {
            stable: stability.morse_index == 0,
            morse_index: stability.morse_index,
            lowest_eigenvalue: stability.lowest_eigenvalue,
        }),
        minimum_slope,
        flattest_place: flattest_place + model.centre,
        ponding: ponding.map(|ponding| Ponding { place: ponding.place + model.centre, ..ponding }),
        edge_lengths,
        angles: measure::angle_range(&film),
        flipped_triangles: flipped,
        degenerate_triangles: degenerate,
        self_intersections,
    };
    let mut warnings = model.warnings.clone();
    warnings.extend(warn(&model, &found, structure, &statistics, &cables));
    warnings.extend(crossings);
    let mut vertices = mesh.vertices;
    for (points, numbers) in structure.boundaries.iter().zip(&model.input_vertices) {
        // Backwards, so that of merged points the first gives the place.
        for (&point, &v) in points.iter().zip(numbers).rev() {
            if holds[v as usize] == Hold::Fixed {
                vertices[v as usize] = point;
            }
        }
    }
    let travel = |(ring, moving): (&Ring, &MovingRing)| {
        let start = structure.boundaries[ring.boundary][0];
        (vertices[model.input_vertices[ring.boundary][0] as usize] - start).dot(moving.axis)
    };
    let ring_travels = structure.rings.iter().zip(&model.rings).map(travel).collect();
    Ok(TensileStructure {
        mesh: Mesh::new(vertices, triangles),
        boundaries: model.boundaries().to_vec(),
        input_vertices: model.input_vertices,
        cables,
        reactions,
        edge_reactions,
        ring_travels,
        statistics,
        warnings,
    })
}

/// The figures of each layer, and the lengths of the edges of all.
fn measure_layers(
    model: &Model,
    found: &Found,
    structure: &Structure,
    at: &[DVec3],
) -> Result<(Vec<LayerResult>, Spread), Error> {
    let (mut layers, mut lengths, mut first) = (Vec::new(), Vec::new(), 0);
    for (layer, film) in model.layers.iter().zip(&structure.layers) {
        let mesh = layer.film.mesh();
        let topology = mesh.check().map_err(|defect| Error::no_result("invalid_mesh", defect.to_string()))?;
        lengths.extend(measure::edge_lengths(&mesh, &topology));
        let triangles: Vec<[u32; 3]> = layer.triangles().collect();
        let of_balance = |balance| stress(balance, film, model, first, &triangles, at);
        let stress = found.balance.as_ref().map(of_balance);
        layers.push(LayerResult { triangles: triangles.len(), area: measure::area(&mesh), stress });
        first += triangles.len();
    }
    Ok((layers, Spread::of(lengths.into_iter())))
}

/// The least slope of a triangle against the horizontal, in radians, and the centroid of the first triangle that has
/// it.
fn flattest(triangles: &[[u32; 3]], at: &[DVec3], up: DVec3) -> (f64, DVec3) {
    let (mut least, mut place) = (f64::INFINITY, DVec3::ZERO);
    for corners in triangles.iter().map(|triangle| triangle.map(|v| at[v as usize])) {
        let normal = double_area_vector(corners).normalize_or_zero();
        let slope = libm::atan2(normal.cross(up).length(), normal.dot(up).abs());
        if slope < least {
            (least, place) = (slope, corners.iter().sum::<DVec3>() / 3.0);
        }
    }
    (least, place)
}

/// What holds a vertex.
#[derive(Clone, Copy, Debug, PartialEq)]
enum Hold<'a> {
    Nothing,
    Fixed,
    Slides(&'a Support),
    /// Moves with the ring of this number, along its axis alone.
    Guided(usize),
}

fn holds(model: &Model) -> Vec<Hold<'_>> {
    let fixed = model.fixed().into_iter();
    let mut holds: Vec<Hold> = fixed.map(|fixed| if fixed { Hold::Fixed } else { Hold::Nothing }).collect();
    for chain in &model.chains {
        for &v in chain.get(1..chain.len() - 1).unwrap_or_default() {
            holds[v as usize] = Hold::Nothing;
        }
    }
    model.free.iter().for_each(|&v| holds[v as usize] = Hold::Nothing);
    for &(v, freedom) in &model.sliding {
        if let Some(support) = freedom.support() {
            holds[v as usize] = Hold::Slides(&model.supports[support as usize]);
        }
    }
    for (number, ring) in model.rings.iter().enumerate() {
        ring.vertices.iter().for_each(|&v| holds[v as usize] = Hold::Guided(number));
    }
    holds
}

/// For each ring the part of the forces on it along its axis, in equal shares for its vertices: what is not balanced.
fn unbalanced_of_rings(model: &Model, balance: &Balance) -> Vec<DVec3> {
    let of = |ring: &MovingRing| {
        let along: f64 = ring.vertices.iter().map(|&v| balance.forces[v as usize].dot(ring.axis)).sum();
        ring.axis * (along / ring.vertices.len() as f64)
    };
    model.rings.iter().map(of).collect()
}

/// The part of a force along a line or surface.
fn along(support: &Support, at: DVec3, force: DVec3) -> DVec3 {
    let tangents = support.tangents(at);
    tangents[..usize::from(support.dimension())].iter().map(|t| *t * t.dot(force)).sum()
}

fn sums(model: &Model, balance: &Balance, holds: &[Hold], at: &[DVec3]) -> ForceBalance {
    let of_rings = unbalanced_of_rings(model, balance);
    let loads: DVec3 = balance.loads.iter().sum();
    let (mut reactions, mut magnitudes, mut residual_force) = (DVec3::ZERO, 0.0, 0.0f64);
    for (((&force, &contact), hold), &place) in balance.forces.iter().zip(&balance.contacts).zip(holds).zip(at) {
        let unbalanced = match *hold {
            Hold::Nothing => force,
            Hold::Fixed => DVec3::ZERO,
            Hold::Slides(support) => along(support, place, force + contact),
            Hold::Guided(ring) => of_rings[ring],
        };
        let reaction = force - unbalanced;
        reactions += reaction;
        magnitudes += reaction.length();
        residual_force = residual_force.max(unbalanced.length());
    }
    ForceBalance {
        loads,
        reactions,
        magnitudes,
        imbalance: (loads + reactions).length() / magnitudes.max(f64::MIN_POSITIVE),
        residual_force,
    }
}

/// The angles between the film's pull on a sliding edge and the surface on which it slides, least and largest. Where an
/// angle is given it is that on the left of the edge.
fn contact_angles(model: &Model, balance: &Balance, holds: &[Hold], at: &[DVec3]) -> Option<(f64, f64)> {
    let mut range = None;
    for &(v, freedom) in &model.sliding {
        let (force, place) = (balance.forces[v as usize], at[v as usize]);
        let Hold::Slides(support) = holds[v as usize] else { continue };
        if support.dimension() != 2 || force == DVec3::ZERO {
            continue;
        }
        let tangential = along(support, place, force);
        let towards = match freedom {
            // The support's force on the film is against the film's pull.
            Freedom::AcrossOn { beside: [a, b], .. } if model.at_contacts.contains(&v) => {
                let left = support.normal(place).cross(at[b as usize] - at[a as usize]);
                -tangential.dot(left.normalize_or_zero())
            }
            _ => tangential.length(),
        };
        let angle = libm::atan2((force - tangential).length(), towards);
        let (least, most) = range.unwrap_or((angle, angle));
        range = Some((angle.min(least), angle.max(most)));
    }
    range
}

fn reactions(model: &Model, found: &Found, holds: &[Hold]) -> (Vec<Reaction>, Vec<EdgeReaction>) {
    let Some(balance) = &found.balance else { return (Vec::new(), Vec::new()) };
    let held = |v: u32| holds[v as usize] != Hold::Nothing;
    let mut single = vec![false; holds.len()];
    let ends = model.chains.iter().flat_map(|chain| [chain[0], chain[chain.len() - 1]]);
    let points = model.sliding.iter().filter(|(_, freedom)| matches!(freedom, Freedom::On(_))).map(|(v, _)| *v);
    for v in ends.chain(points) {
        single[v as usize] = held(v) && !matches!(holds[v as usize], Hold::Guided(_));
    }
    let point_of = |vertex: u32| {
        let of = |(boundary, numbers): (usize, &Vec<u32>)| {
            let point = numbers.iter().position(|&v| v == vertex)?;
            Some(BoundaryPoint { boundary, point })
        };
        model.input_vertices.iter().enumerate().find_map(of)
    };
    let reactions = (0..holds.len() as u32)
        .filter(|&v| single[v as usize])
        .map(|vertex| Reaction { vertex, point: point_of(vertex), force: balance.forces[vertex as usize] })
        .collect();
    let edges = model.boundaries().iter().enumerate().filter_map(|(boundary, rim)| {
        if let Some(Hold::Guided(number)) = rim.first().map(|&v| holds[v as usize]) {
            // The hub passes its force on to the ring.
            let force = model.rings[number].vertices.iter().map(|&v| balance.forces[v as usize]).sum();
            return Some(EdgeReaction { boundary, force });
        }
        let borne = || rim.iter().filter(|&&v| held(v) && !single[v as usize]);
        let force = borne().map(|&v| balance.forces[v as usize]).sum();
        borne().next().map(|_| EdgeReaction { boundary, force })
    });
    (reactions, edges.collect())
}

fn cables(model: &Model, found: &Found, structure: &Structure, at: &[DVec3]) -> Vec<CableResult> {
    let one = |(k, cable): (usize, &super::options::Cable)| {
        let term = &model.cables[k];
        let segment_forces = match &found.balance {
            Some(balance) => balance.cable_forces[k].clone(),
            None => (0..term.segments.len()).map(|s| term.force(s, at) + found.length_forces[k]).collect(),
        };
        let length = term.length(at);
        let mut force = forces(term, found.length_forces[k], at).0;
        if model.stress_field.is_some() {
            let moment = |(s, force): (usize, &f64)| force * crate::energy::length::length(term.segments[s], at);
            force = segment_forces.iter().enumerate().map(moment).sum::<f64>() / length;
        }
        let largest = segment_forces.iter().copied().fold(0.0, f64::max);
        CableResult {
            vertices: model.chains[k].clone(),
            force,
            length,
            unstressed_length: cable.axial_stiffness.map(|stiffness| length / (1.0 + force / stiffness)),
            sag: term.sag(at),
            slack: !cable.course.is_mast() && largest <= SLACK * structure.pull() * length,
            segment_forces,
        }
    };
    structure.cables.iter().enumerate().map(one).collect()
}

fn warn(
    model: &Model,
    found: &Found,
    structure: &Structure,
    statistics: &Statistics,
    cables: &[CableResult],
) -> Vec<Warning> {
    let mut warnings = Vec::new();
    for (k, (cable, result)) in structure.cables.iter().zip(cables).enumerate() {
        if result.slack {
            let detail = format!("cable {} carries no force: it is longer than the shape needs", cable.name);
            warnings.push(Warning::new("slack_cable", detail).with_count("cable", k));
        }
    }
    if !statistics.converged {
        let detail = format!(
            "the residual is {:.1e} ({}): forces and lengths are not those of an equilibrium",
            statistics.residual,
            statistics.stop_reason.name()
        );
        warnings.push(Warning::new("not_converged", detail).with("residual", statistics.residual));
    } else if statistics.balance.is_none() {
        let detail =
            "the forces within the film could not be balanced, so there are no reactions; try another resolution";
        warnings.push(Warning::new("not_balanced", detail));
    }
    warnings.extend(beyond_their_mesh(model));
    if let Some(weave) = statistics.stress.and_then(|stress| stress.weave)
        && weave.deviation_rms > DEVIATES
    {
        let warning = Warning::new("stress_deviates", deviating_stress(&weave, structure));
        warnings.push(warning.with("deviation_rms", weave.deviation_rms));
    }
    if let Some(Ponding { depth, place: DVec3 { x, y, z }, .. }) = statistics.ponding {
        let detail = format!(
            "water would stand up to {depth:.4} deep on the film, deepest at ({x:.4}, {y:.4}, {z:.4}), because it cannot \
             run off over an edge; its weight would deepen the hollow (ponding)"
        );
        warnings.push(Warning::new("ponding", detail).with("depth", depth).with_place([x, y, z]));
    }
    for (chamber, ChamberResult { volume, .. }) in structure.chambers.iter().zip(&statistics.chambers) {
        let next = chamber.below + 1;
        if next < structure.layers.len() && *volume <= 0.0 {
            let detail = format!(
                "layer {next} lies in front of layer {}: the volume between them is {volume:.4}, and they do not press on \
                 each other here as they would in fact; change the pressures",
                chamber.below
            );
            warnings.push(Warning::new("layers_cross", detail).with_count("layer", next).with("volume", *volume));
        }
    }
    if let Some(stability) = statistics.stability {
        let radius = plateau_mesh::polyline::radius(&model.mesh().vertices);
        if (stability.lowest_eigenvalue * radius * radius).abs() < MECHANISM {
            warnings.push(Warning::new("mechanism", mechanism(model, found)));
        } else if !stability.stable {
            let detail = format!(
                "the shape is in equilibrium but no minimum of the energy (Morse index {}): it would leave it",
                stability.morse_index
            );
            warnings.push(Warning::new("unstable", detail).with_count("morse_index", stability.morse_index));
        }
    }
    warnings
}

/// A warning for each mesh beyond whose border an edge has slid.
fn beyond_their_mesh(model: &Model) -> Vec<Warning> {
    let at = model.vertices();
    let beyond = |(number, support): (usize, &Support)| {
        let Support::Mesh { surface, origin } = support else { return None };
        let own = model.sliding.iter().filter(|(_, freedom)| freedom.support() == Some(number as u32));
        let farthest = own.map(|(v, _)| surface.distance(at[*v as usize] - *origin)).fold(0.0, f64::max);
        (farthest > BEYOND * surface.rounding()).then(|| {
            let detail = format!(
                "the edge on the mesh of support {number} has slid up to {farthest:.6} beyond the mesh, which goes on flat \
                 there; make the mesh larger"
            );
            Warning::new("beyond_support", detail).with_count("support", number).with("distance", farthest)
        })
    };
    model.supports.iter().enumerate().filter_map(beyond).collect()
}

/// The stresses of a woven film that differ from the required ones.
fn deviating_stress(weave: &WeaveStress, structure: &Structure) -> String {
    let required = |of: fn(&Weave) -> f64| structure.weave().map_or(0.0, of);
    let (warp, weft) = (required(|weave| weave.warp), required(|weave| weave.weft));
    let (cause, remedy) = match weave.hold {
        WeaveHold::Magnitudes => (
            format!("no film of this shape is in equilibrium with {warp} along the warp and {weft} along the weft"),
            "with hold: ratio both vary by a common factor",
        ),
        WeaveHold::Ratio => (
            format!("no film of this shape is in equilibrium with the ratio {:.3} everywhere", weave.required_ratio),
            "try other directions or a ratio nearer to 1",
        ),
    };
    format!(
        "{cause}; the returned forces balance with {:.4} to {:.4} along the warp and {:.4} to {:.4} along the weft, \
         which deviates by {:.1} % (root mean square); {remedy}",
        weave.warp.min,
        weave.warp.max,
        weave.weft.min,
        weave.weft.max,
        100.0 * weave.deviation_rms
    )
}

/// Which points move freely.
fn mechanism(model: &Model, found: &Found) -> String {
    let mode = found.lowest_mode.as_deref().unwrap_or_default();
    let moves = |v: u32| mode.get(v as usize).is_some_and(|d| d.length() > MOVES);
    let mut points = Vec::new();
    for (boundary, numbers) in model.input_vertices.iter().enumerate() {
        points.extend(
            numbers.iter().enumerate().filter(|(_, v)| moves(**v)).map(|(k, _)| format!("/boundaries/{boundary}/{k}")),
        );
    }
    let count = (0..mode.len() as u32).filter(|&v| moves(v)).count();
    let named = if points.is_empty() {
        "none of them a point of the boundaries".to_owned()
    } else {
        format!("among them {}", points.iter().take(LISTED).cloned().collect::<Vec<_>>().join(", "))
    };
    format!("the structure moves freely: nothing resists a motion of {count} vertices, {named}; add supports or cables")
}
