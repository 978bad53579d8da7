//! Form finding of tensile structures: finds the shape in which the forces of prestressed films, cables, pressure and
//! weight balance.
//!
//! [`solve`] takes a [`Structure`] and a resolution and returns a mesh with the forces in its cables and at its
//! supports. A film with fixed boundaries and without cables or loads is a minimal surface. Every further effect adds a
//! term to one energy, a constraint, or a freedom of vertices in the [equilibrium core](plateau_equilibrium):
//!
//! ```text
//! E = Σ σ A + Σ T L + Σ (EA / 2 L0) (L - L0)²₊ - Σ p V + weights        volumes and lengths as constraints where given
//! ```
//!
//! ```
//! use plateau_minimal_surface::Resolution;
//! use plateau_tensile_structure::{
//!     Cable, CableMode, Course, FilmPrestress, FilmStress, Options, Structure, solve,
//! };
//! use plateau_mesh::{DVec3, Execution};
//!
//! // A plane sail: four corners, an edge cable of force 10 along each side, tension 1. Each edge is an arc of radius
//! // 10.
//! let corners = [(0.0, 0.0), (10.0, 0.0), (10.0, 10.0), (0.0, 10.0)].map(|(x, y)| DVec3::new(x, y, 0.0));
//! let cable = |k: usize| Cable {
//!     name: format!("edge {k}"),
//!     course: Course::Boundary { boundary: 0, from: k, to: (k + 1) % 4 },
//!     mode: CableMode::Force(10.0),
//!     axial_stiffness: None,
//!     weight: 0.0,
//! };
//! let film = FilmStress { prestress: FilmPrestress::Isotropic(1.0), weight: 0.0 };
//! let mut structure = Structure::new(vec![corners.to_vec()], vec![film]);
//! structure.cables = (0..4).map(cable).collect();
//! let sail = solve(&structure, &Options::new(Resolution::Triangles(500)), &Execution::default())?;
//! assert!(sail.statistics.converged);
//! assert!((sail.cables[0].length - 10.471976).abs() < 0.01);
//! # Ok::<(), plateau_mesh::Error>(())
//! ```
//!
//! Sources: Schek, *The force density method for form finding* (1974); Bletzinger, Ramm, *A general finite element
//! approach to the form finding of tensile structures by the updated reference strategy* (1999).

#![forbid(unsafe_code)]
#![cfg_attr(test, allow(clippy::disallowed_methods, clippy::disallowed_types, clippy::disallowed_macros))]
#![warn(missing_docs)]

mod catenary;
mod checks;
mod corners;
mod form_finding;
mod mixing;
mod model;
mod options;
mod outcome;
mod ponding;
mod reactions;
mod remeshing;
mod shape;
mod stress;
mod taut_start;
mod travel;
mod warnings;
mod weave;

pub use options::{
    BoundaryPoint, Cable, CableMode, Chamber, Course, FilmPrestress, FilmStress, Options, Pressure, Ring, Sliding,
    SlidingPart, Structure, WarpDirection, Weave, WeaveHold,
};
pub use ponding::Ponding;
pub use shape::{
    CableResult, ChamberResult, EdgeForce, EdgeReaction, ForceBalance, LayerResult, Reaction, Statistics, Stress,
    StressRange, TensileStructure, TriangleStress, WeaveStress,
};

use catenary::{Catenary, NoCatenary};
use form_finding::{Coarse, Found, Meshes};
use model::{FirstShape, Model};
use plateau_equilibrium::form_finding::StopReason;
use plateau_mesh::error::Step;
use plateau_mesh::{DVec3, Error, Estimate, Execution, InputError, Interruption, Place};
use plateau_minimal_surface::Resolution;

/// Finds the shape of a structure in equilibrium.
///
/// The result depends only on the arguments. It is the same to the byte on processors with the same vector
/// instructions. If the structure is moved or scaled, the result moves and scales with it, up to rounding. If the
/// iterations or the time are used up before the residual reaches the tolerance, the shape is returned with `converged:
/// false` and the warning `not_converged`.
///
/// # Errors
/// [`Error::Input`] if a check of the arguments fails; [`Error::NoResult`] if there is no equilibrium near the
/// boundaries or no mesh; [`Error::Interrupted`] on cancellation, or if the deadline passes before there is a mesh.
pub fn solve(structure: &Structure, options: &Options, exec: &Execution) -> Result<TensileStructure, Error> {
    check(structure, options)?;
    let (model, found) = if remeshing::travels(structure) {
        travel(structure, options, exec)?
    } else {
        let (model, found) = on_its_mesh(structure, options, exec)?;
        let stands = found.is_shape() && model.flipped() == 0;
        if remeshing::may_travel(structure) && found.gave_up() && !stands {
            travel(structure, options, exec)?
        } else {
            (model, found)
        }
    };
    outcome::finish(model, found, structure, exec)
}

/// A mesh is too coarse if its mean edge length is at least this multiple of the required edge length.
const TOO_COARSE: f64 = 1.15;
/// Upper bound of the number of triangles of the finer mesh, as a multiple of the number of the coarse mesh.
const MOST_FINER: f64 = 4.0;

/// Number of triangles for each boundary point of the coarse mesh from which a second search starts. The coarse mesh
/// has all points, and a mesh with fewer triangles has hardly any vertex inside.
const COARSE_TRIANGLES_PER_POINT: f64 = 3.0;

/// Finds the shape on the initial mesh. The film may become much larger than its boundaries suggest, and the edges of
/// its mesh then become longer than the required length. In this case the shape is found once more on a finer mesh.
fn on_its_mesh(structure: &Structure, options: &Options, exec: &Execution) -> Result<(Model, Found), Error> {
    let find = |options: &Options, exec: &Execution| find_from_starts(structure, options, exec);
    let Resolution::EdgeLength(edge) = options.resolution else { return find(options, exec) };
    let (model, found) = exec.part([0.0, 0.5], |exec| find(options, exec))?;
    let ratio = model.mean_edge() / edge;
    if !found.is_shape() || ratio < TOO_COARSE {
        return Ok((model, found));
    }
    let triangles = model.layers[0].film.triangles().len() as f64 * (ratio * ratio).min(MOST_FINER);
    let finer = Options { resolution: Resolution::Triangles(triangles as usize), ..*options };
    exec.part([0.5, 1.0], |exec| find(&finer, exec))
}

/// A search for the shape of a woven film.
type Search<'a> = &'a dyn Fn(&Execution) -> Result<(Model, Found), Error>;

/// Finds the shape on the initial mesh. If the search does not converge for a woven film, two other searches follow.
/// The first starts from the surface of straight lines between two boundaries, because a harmonic map narrows to a neck
/// that unequal stresses do not have. The second travels, because the edges of a sail with sharp corners move so far
/// that the triangles of the initial mesh become too thin.
fn find_from_starts(structure: &Structure, options: &Options, exec: &Execution) -> Result<(Model, Found), Error> {
    let find = |first_shape: FirstShape, exec: &Execution| {
        let mut model = exec
            .part_as("initial_mesh", [0.0, 0.1], |exec| Model::build(structure, options, 1.0, first_shape, exec))
            .map_err(|error| placed(structure, error))?;
        let run = |exec: &Execution| form_finding::run(&mut model, structure, options, Meshes::Kept, exec);
        let found = exec.part([0.1, 1.0], run)?;
        Ok::<_, Error>((model, found))
    };
    let is_woven = structure.weave().is_some();
    let share = if is_woven { 0.5 } else { 1.0 };
    let first = exec.part([0.0, share], |exec| find(FirstShape::Harmonic, exec))?;
    let converged = |(model, found): &(Model, Found)| found.stop_reason == StopReason::Residual && model.flipped() == 0;
    let is_used_up = options.max_iterations.is_some() && first.1.stop_reason == StopReason::MaxIterations;
    if !is_woven || converged(&first) || is_used_up || first.1.stop_reason == StopReason::Deadline {
        return Ok(first);
    }
    let ruled = |exec: &Execution| find(FirstShape::Ruled, exec);
    let travelling = |exec: &Execution| travel(structure, options, exec);
    let others: [Option<Search>; 2] = [
        (structure.boundaries.len() == 2).then_some(&ruled),
        remeshing::travels_if_woven(structure).then_some(&travelling),
    ];
    for other in others.into_iter().flatten() {
        match exec.part([share, 1.0], other) {
            Ok(other) if converged(&other) => return Ok(other),
            Ok(_) | Err(Error::NoResult { .. } | Error::Input(_)) => {}
            Err(Error::Interrupted(Interruption::DeadlinePassed)) => break,
            Err(error) => return Err(error),
        }
    }
    Ok(first)
}

/// Finds the shape on a sequence of meshes that become finer. If none is found from the usual coarse mesh, and the
/// boundary has so many points that this mesh has hardly any vertex inside, the search starts again from a finer one.
fn travel(structure: &Structure, options: &Options, exec: &Execution) -> Result<(Model, Found), Error> {
    let points: usize = structure.boundaries.iter().map(Vec::len).sum();
    let denser = COARSE_TRIANGLES_PER_POINT * points as f64;
    if denser <= travel::COARSE {
        return travel_from(travel::COARSE, structure, options, exec);
    }
    match exec.part([0.0, 0.5], |exec| travel_from(travel::COARSE, structure, options, exec)) {
        Ok((model, found)) if found.is_shape() || !found.gave_up() => Ok((model, found)),
        Err(Error::Interrupted(reason)) => Err(Error::Interrupted(reason)),
        _ => exec.part([0.5, 1.0], |exec| travel_from(denser, structure, options, exec)),
    }
}

/// Finds the shape on a sequence of meshes, the first of which has this number of triangles. Each mesh is remeshed
/// while the structure moves.
fn travel_from(
    coarse: f64,
    structure: &Structure,
    options: &Options,
    exec: &Execution,
) -> Result<(Model, Found), Error> {
    let count =
        plateau_minimal_surface::estimate(&structure.boundaries, &model::start_options(structure, options)).triangles;
    let (start, share) = if count > coarse {
        let resolution = Resolution::Triangles(coarse as usize);
        (Options { resolution, ..*options }, (coarse / count).sqrt())
    } else {
        (*options, 1.0)
    };
    let mut model = exec
        .part_as("initial_mesh", [0.0, 0.1], |exec| Model::build(structure, &start, share, FirstShape::Harmonic, exec))
        .map_err(|error| placed(structure, error))?;
    let coarse = Coarse { count, options: start, share };
    let run = |exec: &Execution| form_finding::run(&mut model, structure, options, Meshes::Travelling(coarse), exec);
    let found = exec.part([0.1, 1.0], run)?;
    Ok((model, found))
}

/// Checks the arguments of [`solve`] without solving. The time is linear in the number of points.
///
/// # Errors
/// The [`Error::Input`] that [`solve`] would return for these arguments.
pub fn check(structure: &Structure, options: &Options) -> Result<(), Error> {
    checks::check(structure, options)?;
    check_catenaries(structure)?;
    let start = model::start_options(structure, options);
    plateau_minimal_surface::check(&structure.boundaries, &start).map_err(|error| placed(structure, error))
}

/// Refuses a heavy cable in the air between two supports if no catenary has the value that the cable's mode prescribes.
fn check_catenaries(structure: &Structure) -> Result<(), Error> {
    let hubs: Vec<DVec3> = structure.rings.iter().filter_map(|ring| ring.hub).collect();
    let joined = |end: &DVec3| {
        structure.boundaries.iter().flatten().chain(&structure.joints).chain(&hubs).any(|point| point == end)
    };
    let too_small = |(k, cable): (usize, &Cable)| {
        let Course::Air(ends) = cable.course else { return None };
        if ends.iter().any(joined) {
            return None;
        }
        let place = || options::cable_place(structure, k);
        if catenary::are_plumb(ends, structure.up) {
            return plumb_refusal(structure, cable, ends, place());
        }
        let NoCatenary { bound } = Catenary::find(cable, ends, structure.up).err()?;
        let detail =
            format!("must be at least {bound:.6}: no cable of this weight hangs between these points with less");
        Some(InputError::new(place().then("value"), detail))
    };
    let errors: Vec<InputError> = structure.cables.iter().enumerate().filter_map(too_small).collect();
    if errors.is_empty() { Ok(()) } else { Err(Error::Input(errors)) }
}

/// Refuses a cable between two supports, one above the other, if a part of the cable would have to push or if its mode
/// does not determine its force.
fn plumb_refusal(structure: &Structure, cable: &Cable, ends: [DVec3; 2], place: Place) -> Option<InputError> {
    let force = catenary::plumb_force(cable, ends, structure.up);
    match force {
        Some(Ok(_)) => None,
        Some(Err(NoCatenary { bound })) => {
            let side = if matches!(cable.mode, CableMode::UnstressedLength(_)) { "less" } else { "more" };
            let detail = format!(
                "must be {side} than {bound:.6}: the lowest part of this cable, which hangs straight down, would push"
            );
            Some(InputError::new(place.then("value"), detail))
        }
        None if cable.weight > 0.0 || matches!(cable.mode, CableMode::HorizontalComponent(_)) => {
            let detail = "is not offered for a cable between points one above the other, which hangs straight; give a \
                          force, a force density or the unstressed length";
            Some(InputError::new(place.then("mode"), detail))
        }
        None => None,
    }
}

/// Translates the places in an error of the initial mesh to places in the structure. In the initial mesh the cables
/// across the film are constraint polylines; in the structure they are cables.
fn placed(structure: &Structure, mut error: Error) -> Error {
    let across = |cable: &(usize, &Cable)| matches!(cable.1.course, Course::Across(_));
    let numbers: Vec<usize> = structure.cables.iter().enumerate().filter(across).map(|(k, _)| k).collect();
    let (Error::Input(errors) | Error::NoResult { places: errors, .. }) = &mut error else { return error };
    for InputError { place: Place(steps), .. } in errors {
        *steps = match &steps[..] {
            [Step::Field("constraints"), Step::Field("polylines"), Step::Index(k), rest @ ..] => {
                let cable = numbers.get(*k).copied().unwrap_or_default();
                let own = [Step::Field("cables"), Step::Index(cable), Step::Field("across")];
                own.iter().chain(rest).copied().collect()
            }
            [Step::Field("constraints"), ..] => vec![Step::Field("cables")],
            _ => continue,
        };
    }
    error
}

/// Estimated memory per triangle of the film, in bytes. Most of it is the matrix factor, which has three unknowns at
/// every vertex. Sails, woven sails, cushions and inflated films took 2,450 to 3,650 bytes at 20,000 and 60,000 triangles.
const BYTES_PER_TRIANGLE: f64 = 4_000.0;
/// Estimated memory besides that of the triangles, in bytes.
const BYTES_OF_SOLVE: f64 = 2e6;
/// Estimated memory per triangle of a mesh on which an edge slides, in bytes: the triangle and its share of the search
/// tree.
const BYTES_PER_SUPPORT_TRIANGLE: usize = 200;

/// Estimates the number of triangles of the result and the memory that solving takes. The number of triangles is that
/// of the initial mesh over the boundaries ([`plateau_minimal_surface::estimate`]), times the number of layers.
#[must_use]
pub fn estimate(structure: &Structure, options: &Options) -> Estimate {
    let start = plateau_minimal_surface::estimate(&structure.boundaries, &model::start_options(structure, options));
    let triangles = start.triangles * structure.layers.len() as f64;
    let size = |sliding: &Sliding| BYTES_PER_SUPPORT_TRIANGLE * sliding.on.extent().map_or(0, |extent| extent.size());
    let supports: usize = structure.sliding.iter().map(size).sum();
    Estimate { triangles, bytes: (BYTES_OF_SOLVE + triangles * BYTES_PER_TRIANGLE) as u64 + supports as u64, ..start }
}

/// Compiles and runs the example of the README as a doc test.
#[cfg(doctest)]
#[doc = include_str!("../README.md")]
struct Readme;
