//! Finds the film of least area over several boundaries: solves every way to span them and compares the areas.
//!
//! 1. Each non-empty set of boundaries is spanned by one connected film (a disc, an annulus, a sphere with holes). The
//!    default solver starts from each initial mesh (in a plane, in a disc, of rings between two boundaries) and
//!    descends from unstable surfaces. If it converges to a surface that does not hold or passes through itself, it
//!    also starts from each way to lay out the boundaries in the disc. For the film over all boundaries it does so
//!    whenever none holds, and also starts with each other boundary as the first. A film *holds* if it converged, is
//!    stable, is connected and has no flipped triangle. Of the films of a set that hold, the one of least area is
//!    taken. A film that passes through itself is taken only if all of them do. If none of the films over all boundaries
//!    holds, the same is done with a mesh of half as many triangles, and its film is refined and solved again. If a
//!    [cone](crate::cone) separates the boundaries of a set, the set is not tried, because no connected film spans it.
//! 2. A spanning topology is a partition of the boundaries with one connected film for each of its sets. Its area and
//!    its Morse index are the sums over the films. A partition with a set that does not hold is listed without an area.
//! 3. The partition of least area is returned. The statistics list the others. If many triangles are asked for, all
//!    partitions are compared on coarse meshes, and those near the least area again at the full size, from an initial
//!    mesh of the same kind as led to the coarse film. If this leads to no film that holds, the coarse film is refined
//!    and solved again. Partitions whose films pass through themselves or each other come after all others, whatever
//!    their area.
//! 4. If the connected film over two boundaries does not hold, the boundaries are moved together along the line of
//!    their centroids until a connected film holds. They are then moved apart again in steps, each of which starts from
//!    the film of the step before. If no film holds at a step, the step is halved. The result is the largest fraction
//!    of the gap at which a film holds, or the film itself if the full gap is reached. These films have coarse meshes,
//!    which hold a thin neck at gaps at which no film exists. The fraction is therefore found again by bisection with
//!    refined necks, from the last of these films that holds when it is refined.
//!
//! The films of one partition are solved independently. They may pass through each other, which is reported.

use super::nested;
use super::sets::{members, order_of, partitions, set_of, together};
use crate::cone;
use crate::estimate::estimate;
use crate::initial_mesh::{self, InitialMeshKind};
use crate::options::{InitialMesh, Method, Newton, OnUnstable, Options, Resolution, Solver, TopologyRule};
use crate::run::{ExtrapolatedArea, Run, SpanningComparison, SpanningTopology, Stability, StabilityMethod};
use crate::solved_film::SolvedFilm;
use crate::solvers::newton;
use plateau_equilibrium::form_finding::StopReason;
use plateau_mesh::codes::{Reason, WarningCode};
use plateau_mesh::crossing::films_cross;
use plateau_mesh::error::Warning;
use plateau_mesh::film::Film;
use plateau_mesh::remesh::isotropic::{BoundaryEdges, refine};
use plateau_mesh::self_intersections::{Order, self_intersections};
use plateau_mesh::{DVec3, Error, Execution, Interruption, Place, polyline};

// Tunables. The figures in docs/VALIDATION.md were obtained with these values.

/// Largest number of boundaries that [`TopologyRule::Best`] compares. For n boundaries there are 2ⁿ - 1 films to solve;
/// for six there are 203 partitions.
pub(crate) const MOST_BOUNDARIES: usize = 6;
/// Step of the fraction of a gap at which the search for the largest one ends. Half this value would cost about one more
/// solve. The error of the mesh is larger: between coaxial rings of 32 points and more the fraction is within 2% of that
/// of circles.
const GAP_RESOLUTION: f64 = 1e-3;
/// Largest number of linear solves of a film on the way whose neck is refined. A film that holds takes fewer, and a film
/// that does not hold would go on for several times as many.
const REFINED_SOLVES: u32 = 40;
/// Fraction of the gap by which the search goes back at first if a film does not hold with a refined neck. Each further
/// step is twice as long.
const FIRST_STEP_BACK: f64 = 0.03;
/// Largest number of times that the gap is halved in search of a first film that holds, down to 1/256 of the full gap.
const HALVINGS: u32 = 8;

/// Number of triangles of the coarse meshes on which topologies are compared if more than twice as many triangles are
/// asked for. The topologies near the least area are then solved at the full size. Boundaries of many points have
/// larger coarse meshes: at least twice [`TRIANGLES_PER_POINT`] triangles for each point.
const COMPARED_TRIANGLES: usize = 2_000;
/// Fraction by which an area may exceed the least one and still count as near it. The relative error of the area of a
/// mesh of [`COMPARED_TRIANGLES`] is about a tenth of this.
const CONTENDS: f64 = 5e-3;
/// Relative difference of areas below which two films count as equally large. It is above rounding.
const EQUAL_AREA: f64 = 1e-9;
/// Least number of triangles of a film for each of its boundary points, unless fewer are asked for in total.
const TRIANGLES_PER_POINT: usize = 3;
/// Safety factor on the tolerance of a film that spans only some of the boundaries. It is below 1 because the tolerance
/// is converted by the radius of the input points, while the film's residual is measured with the radius of its
/// boundary vertices, which differs a little.
const MARGIN: f64 = 0.5;
/// Lower bound of the factor on the tolerance of a film over some of the boundaries. The factor is the radius of these
/// boundaries over the radius of all. A smaller factor would ask for a residual below rounding.
const SMALLEST_PART: f64 = 1e-4;

impl SpanningComparison {
    pub(crate) fn warnings(&self) -> Vec<Warning> {
        let mut warnings = Vec::new();
        if !self.connected_film_exists {
            let mut warning =
                Warning::new(WarningCode::NoConnectedFilm, "no film that connects all boundaries was found");
            if let Some(fraction) = self.largest_gap_fraction {
                warning.detail += &format!("; one would at up to {fraction:.3} of the gap between the two");
                warning = warning.with("largest_gap_fraction", fraction);
            }
            warnings.push(warning);
        }
        if self.topologies.first().is_some_and(|least| least.films_cross == Some(true)) {
            let detail =
                "the films of the least topology pass through each other or themselves; soap films would join there";
            warnings.push(Warning::new(WarningCode::FilmsCross, detail));
        }
        warnings
    }
}

/// Carries out steps 1 to 4 for centred boundaries. A disc over a single boundary is kept even if it does not hold
/// (over a knotted boundary, or after a deadline). A connected film over several boundaries is dropped if it does not
/// hold.
///
/// # Errors
/// [`Error::Input`] for more than [`MOST_BOUNDARIES`] boundaries, and the errors of the discs over single boundaries,
/// if no other film spans these.
pub(crate) fn solve(given: &[Vec<DVec3>], options: &Options, exec: &Execution) -> Result<SolvedFilm, Error> {
    let count = given.len();
    if count > MOST_BOUNDARIES {
        let detail = format!("best compares the films over at most {MOST_BOUNDARIES} boundaries");
        return Err(Error::input(Place::field("topology"), detail));
    }
    // The boundaries are sorted by shape, so that the order of the client's list does not change the films.
    let order = order_of(given);
    let boundaries: &[Vec<DVec3>] = &order.iter().map(|&k| given[k].clone()).collect::<Vec<_>>();
    let full = SpanningProblem::new(boundaries, options.clone());
    // The discs are solved first, so that there is a result if the rest is interrupted.
    let mut sets: Vec<u32> = (1..1 << count).collect();
    sets.sort_by_key(|set| (set.count_ones(), *set));
    let coarse = full.coarse();
    let share = if coarse.is_some() { 0.5 } else { 1.0 };
    let mut parts = exec.part([0.0, share], |exec| coarse.as_ref().unwrap_or(&full).parts(&sets, None, exec))?;
    let mut compared = parts.compared(&partitions(count), exec)?;
    // The partition into discs has an area unless a boundary bounds no disc.
    if let (None, Some(error)) = (compared[0].area, parts.without_disc.take()) {
        return Err(error);
    }
    let connected_film_exists = parts.films[(1 << count) - 1].is_some();
    let largest_gap_fraction = parts.largest_gap_fraction;
    if coarse.is_some() && !parts.interrupted {
        solve_contenders(&full, share, &mut compared, &mut parts, exec)?;
    }
    compared[0].chosen = true;
    let chosen: Vec<&SolvedFilm> =
        compared[0].films.iter().filter_map(|films| parts.films[set_of(films) as usize].as_ref()).collect();
    let as_given = |films: &[usize]| -> Vec<usize> { films.iter().map(|&k| order[k]).collect() };
    let films: Vec<(Vec<usize>, &SolvedFilm)> =
        compared[0].films.iter().map(|films| as_given(films)).zip(chosen.iter().copied()).collect();
    let film = together(given, &films)
        .ok_or_else(|| Error::no_result(Reason::InvalidMesh, "the films of the chosen topology do not fit together"))?;
    let mut run = Run::new(Solver::Newton);
    for part in &chosen {
        run.append(part.run.clone());
    }
    run.stop_reason = if parts.interrupted {
        StopReason::Deadline
    } else {
        let open = chosen.iter().map(|part| part.run.stop_reason).find(|&reason| reason != StopReason::Residual);
        open.unwrap_or(StopReason::Residual)
    };
    run.stability = compared[0].stability;
    run.extrapolated_area = extrapolated(&chosen);
    for topology in &mut compared {
        for films in &mut topology.films {
            *films = as_given(films);
            films.sort_unstable();
        }
        topology.films.sort_unstable();
    }
    run.spanning = Some(SpanningComparison { topologies: compared, connected_film_exists, largest_gap_fraction });
    let initial_area = chosen.iter().map(|part| part.initial_area).sum();
    Ok(SolvedFilm { film, kind: chosen[0].kind, arrangement: None, initial_area, run })
}

/// Returns the connected film over all boundaries that steps 1 and 3 find, or `None` if none holds. If the deadline
/// passes at the full size, the film of the coarse mesh is returned. The boundary loops of the film are in the given
/// order.
///
/// # Errors
/// [`Error::Interrupted`] on cancel, and at a deadline that passes before there is a film.
pub(crate) fn connected_film(
    boundaries: &[Vec<DVec3>],
    options: &Options,
    exec: &Execution,
) -> Result<Option<SolvedFilm>, Error> {
    // As in `solve`, so that both find the same films.
    let order = order_of(boundaries);
    let sorted: Vec<Vec<DVec3>> = order.iter().map(|&k| boundaries[k].clone()).collect();
    let whole = (1 << boundaries.len()) - 1;
    let part = |problem: &SpanningProblem, coarse: Option<&SolvedFilm>| match problem.part(whole, coarse, exec) {
        Ok(part) if spans(&part) => Ok(Some(part)),
        Ok(part) if part.run.stop_reason == StopReason::Deadline => Err(late()),
        Ok(_) | Err(Error::NoResult { .. } | Error::Input(_)) => Ok(None),
        Err(error) => Err(error),
    };
    let full = SpanningProblem::new(&sorted, options.clone());
    let coarse = full.coarse().map_or(Ok(None), |problem| part(&problem, None))?;
    let found = match (part(&full, coarse.as_ref()), coarse) {
        (Err(Error::Interrupted(Interruption::DeadlinePassed)), Some(mut coarse)) => {
            coarse.run.stop_reason = StopReason::Deadline;
            Some(coarse)
        }
        (found, _) => found?,
    };
    Ok(found.and_then(|part| together(boundaries, &[(order, &part)]).map(|film| SolvedFilm { film, ..part })))
}

/// Solves at the full size the topologies whose areas on the coarse meshes are within [`CONTENDS`] of the least one. If
/// none of these topologies holds at the full size, the topologies of next larger area follow, and so on. Afterwards
/// `parts` holds the films at the full size, and the topologies made of them come first in `compared`.
fn solve_contenders(
    full: &SpanningProblem,
    share: f64,
    compared: &mut Vec<SpanningTopology>,
    parts: &mut Parts,
    exec: &Execution,
) -> Result<(), Error> {
    let mut rest = compared.clone();
    while let Some(least) = rest.first().and_then(|topology| topology.area) {
        let crosses = |topology: &SpanningTopology| topology.films_cross == Some(true);
        let least_crosses = crosses(&rest[0]);
        let contends = |topology: &SpanningTopology| {
            crosses(topology) == least_crosses && topology.area.is_some_and(|area| area <= (1.0 + CONTENDS) * least)
        };
        let (contenders, others): (Vec<_>, Vec<_>) = rest.into_iter().partition(contends);
        rest = others;
        let contenders: Vec<Vec<u32>> =
            contenders.iter().map(|topology| topology.films.iter().map(|films| set_of(films)).collect()).collect();
        let mut sets: Vec<u32> = contenders.iter().flatten().copied().collect();
        sets.sort_by_key(|set| (set.count_ones(), *set));
        sets.dedup();
        let finer = match exec.part([share, 1.0], |exec| full.parts(&sets, Some(&*parts), exec)) {
            // The films of the coarse meshes remain.
            Err(Error::Interrupted(Interruption::DeadlinePassed)) => {
                parts.interrupted = true;
                return Ok(());
            }
            finer => finer?,
        };
        let mut found = finer.compared(&contenders, exec)?;
        if found[0].area.is_some() {
            let is_finer = |topology: &SpanningTopology| found.iter().any(|finer| finer.films == topology.films);
            compared.retain(|topology| !is_finer(topology));
            found.append(compared);
            (*compared, *parts) = (found, finer);
            return Ok(());
        }
        if finer.interrupted {
            parts.interrupted = true;
            return Ok(());
        }
    }
    Ok(())
}

/// Sums the extrapolated areas of films. `None` if a film has none. The area of a film without a free vertex counts as
/// exact.
fn extrapolated(films: &[&SolvedFilm]) -> Option<ExtrapolatedArea> {
    films.iter().try_fold(ExtrapolatedArea { area: 0.0, error_estimate: 0.0 }, |sum, part| {
        let exact = ExtrapolatedArea { area: part.film.area(), error_estimate: 0.0 };
        let has_moved = part.run.stop_reason != StopReason::NothingToMove;
        let found = if has_moved { part.run.extrapolated_area? } else { exact };
        let error_estimate = sum.error_estimate + found.error_estimate;
        Some(ExtrapolatedArea { area: sum.area + found.area, error_estimate })
    })
}

/// The films over sets of boundaries.
struct Parts {
    /// For each set of boundaries (see [`set_of`]) its film, or `None` if no film that holds was found. The disc over a
    /// single boundary is kept even if it does not hold.
    films: Vec<Option<SolvedFilm>>,
    interrupted: bool,
    /// The error of the first boundary that bounds no disc.
    without_disc: Option<Error>,
    largest_gap_fraction: Option<f64>,
}

impl Parts {
    /// Returns the partitions with their areas in this order: first those whose films do not cross, then those whose
    /// films do, each sorted by area, and last those without an area.
    fn compared(&self, partitions: &[Vec<u32>], exec: &Execution) -> Result<Vec<SpanningTopology>, Error> {
        let mut crosses_itself = Vec::with_capacity(self.films.len());
        for part in &self.films {
            let film = part.as_ref().map(|part| &part.film);
            crosses_itself.push(film.map_or(Ok(Some(false)), |film| film_crosses_itself(film, exec))?);
        }
        let mut compared: Vec<SpanningTopology> = Vec::with_capacity(partitions.len());
        for films in partitions {
            let mut films = films.clone();
            films.sort_by_key(|set| set.trailing_zeros());
            compared.push(compare(&films, &self.films, &crosses_itself, exec)?);
        }
        // The areas are rounded, so that the last bits do not decide the order of mirror images.
        let largest = compared.iter().filter_map(|topology| topology.area).fold(0.0, f64::max);
        let order = |a: &SpanningTopology, b: &SpanningTopology| {
            let key = |topology: &SpanningTopology| {
                topology.area.map_or(f64::INFINITY, |area| (area / largest * 1e9).round())
            };
            let crosses = |topology: &SpanningTopology| topology.area.is_some() && topology.films_cross == Some(true);
            let known = a.area.is_none().cmp(&b.area.is_none());
            let by_area = known.then(crosses(a).cmp(&crosses(b))).then(key(a).total_cmp(&key(b)));
            // Between equal areas the partition into more films comes first, because a connected film of the same area
            // consists of the separate films and of tubes without area between them.
            by_area.then(b.films.len().cmp(&a.films.len())).then(a.films.cmp(&b.films))
        };
        compared.sort_by(order);
        Ok(compared)
    }
}

/// Whether a film holds and is connected. A plane mesh over boundaries that lie side by side is not connected, because
/// it consists of discs.
fn spans(film: &SolvedFilm) -> bool {
    film.holds() && film.film.topology.components() == 1
}

/// Whether a film passes through itself. `None` if the deadline has cut the search short.
fn film_crosses_itself(film: &Film, exec: &Execution) -> Result<Option<bool>, Interruption> {
    unless_late(self_intersections(&film.vertices, film.triangles(), Order::Spatial, u64::MAX, exec))
        .map(|found| found.map(|found| found.pairs > 0))
}

/// The result of a search, or `None` if the deadline has cut the search short.
fn unless_late<T>(found: Result<T, Interruption>) -> Result<Option<T>, Interruption> {
    match found {
        Err(Interruption::DeadlinePassed) => Ok(None),
        found => found.map(Some),
    }
}

/// Three-valued "or": true if either value is true, `None` if neither is known to be true and one is unknown.
fn either(a: Option<bool>, b: Option<bool>) -> Option<bool> {
    if a == Some(true) || b == Some(true) { Some(true) } else { a.and(b) }
}

/// Computes the area, the stability and the crossings of one partition.
fn compare(
    films: &[u32],
    parts: &[Option<SolvedFilm>],
    crosses_itself: &[Option<bool>],
    exec: &Execution,
) -> Result<SpanningTopology, Error> {
    let held: Option<Vec<&SolvedFilm>> = films.iter().map(|&set| parts[set as usize].as_ref()).collect();
    let mut topology = SpanningTopology {
        films: films.iter().map(|&set| members(set)).collect(),
        area: None,
        stability: None,
        films_cross: films.iter().map(|&set| crosses_itself[set as usize]).fold(Some(false), either),
        chosen: false,
    };
    let Some(held) = held else { return Ok(topology) };
    topology.area = Some(held.iter().map(|part| part.film.area()).sum());
    topology.stability =
        held.iter().map(|part| part.run.stability).collect::<Option<Vec<Stability>>>().and_then(|all| {
            all.into_iter().reduce(|a, b| Stability {
                stable: a.stable.zip(b.stable).map(|(a, b)| a && b),
                morse_index: a.morse_index.zip(b.morse_index).map(|(a, b)| a + b),
                least_index: a.least_index + b.least_index,
                lowest_eigenvalue: a.lowest_eigenvalue.min(b.lowest_eigenvalue),
                margin: a.margin.zip(b.margin).map(|(a, b)| a.min(b)),
                // The combined method is the less certain of the two.
                method: if a.method == StabilityMethod::Inertia { b.method } else { a.method },
            })
        });
    for (k, part) in held.iter().enumerate() {
        for other in &held[k + 1..] {
            // After the deadline, crossings are no longer searched for. The areas are known already.
            let cross = unless_late(films_cross(&part.film, &other.film, exec))?;
            topology.films_cross = either(topology.films_cross, cross);
        }
    }
    Ok(topology)
}

/// Result of the search for the largest gap between two boundaries that a connected film spans.
enum LargestGap {
    Full(Box<SolvedFilm>),
    Fraction(f64),
    NotFound,
}

struct SpanningProblem<'a> {
    boundaries: &'a [Vec<DVec3>],
    options: Options,
    /// Length of all boundaries together.
    total: f64,
    /// Largest distance of a boundary point from the mean of all boundary points.
    radius: f64,
}

impl<'a> SpanningProblem<'a> {
    fn new(boundaries: &'a [Vec<DVec3>], options: Options) -> Self {
        let total = boundaries.iter().map(|boundary| polyline::length(boundary, true)).sum();
        Self { boundaries, options, total, radius: polyline::radius(&boundaries.concat()) }
    }

    /// The same boundaries with coarse meshes, if so many triangles are asked for that the coarse films come first.
    fn coarse(&self) -> Option<Self> {
        let points: usize = self.boundaries.iter().map(Vec::len).sum();
        let compared_at = COMPARED_TRIANGLES.max(2 * TRIANGLES_PER_POINT * points);
        (estimate(self.boundaries, &self.options).triangles > 2.0 * compared_at as f64)
            .then(|| self.with_triangles(compared_at))
    }

    /// The same boundaries with meshes of this many triangles.
    fn with_triangles(&self, triangles: usize) -> Self {
        let resolution = Resolution::Triangles(triangles);
        Self::new(self.boundaries, Options { resolution, ..self.options.clone() })
    }

    /// Carries out steps 1 and 4 for some sets, with the films that `coarse` has of them.
    fn parts(&self, sets: &[u32], coarse: Option<&Parts>, exec: &Execution) -> Result<Parts, Error> {
        let count = self.boundaries.len();
        let mut parts =
            Parts { films: vec![None; 1 << count], interrupted: false, without_disc: None, largest_gap_fraction: None };
        let share = 0.9 / sets.len() as f64;
        for (k, &set) in sets.iter().enumerate() {
            let share = [share * k as f64, share * (k + 1) as f64];
            let known = coarse.and_then(|coarse| coarse.films[set as usize].as_ref());
            match exec.part(share, |exec| self.part(set, known, exec)) {
                Ok(part) => {
                    parts.interrupted |= part.run.stop_reason == StopReason::Deadline;
                    parts.films[set as usize] = (set.count_ones() == 1 || spans(&part)).then_some(part);
                }
                Err(Error::Interrupted(Interruption::DeadlinePassed)) if set.count_ones() > 1 => {
                    parts.interrupted = true;
                }
                Err(error @ Error::NoResult { .. }) if set.count_ones() == 1 => {
                    parts.without_disc.get_or_insert(error);
                }
                // No initial mesh connects these boundaries (they touch, or the resolution is too coarse), so the set
                // has no film.
                Err(Error::NoResult { .. } | Error::Input(_)) if set.count_ones() > 1 => {}
                Err(error) => return Err(error),
            }
            if parts.interrupted && set.count_ones() > 1 {
                break;
            }
        }
        let whole = (1 << count) - 1;
        if count == 2 && sets.contains(&whole) && parts.films[whole as usize].is_none() && !parts.interrupted {
            match exec.part([0.9, 1.0], |exec| self.widest_gap(exec)) {
                Ok(LargestGap::Full(part)) => parts.films[whole as usize] = Some(*part),
                Ok(LargestGap::Fraction(fraction)) => parts.largest_gap_fraction = Some(fraction),
                Ok(LargestGap::NotFound) => {}
                Err(Error::Interrupted(Interruption::DeadlinePassed)) => parts.interrupted = true,
                Err(error) => return Err(error),
            }
        }
        Ok(parts)
    }

    /// The options for a set of boundaries. The set gets a share of the triangles in proportion to the length of its
    /// boundaries, but at least [`TRIANGLES_PER_POINT`] for each point, because a film has no mesh without enough
    /// triangles for its own points. The tolerance is scaled by the radius of the set, because the residual of the
    /// whole result is measured with the radius of all boundaries.
    fn options_for(&self, boundaries: &[Vec<DVec3>]) -> Options {
        let length: f64 = boundaries.iter().map(|boundary| polyline::length(boundary, true)).sum();
        let points: usize = boundaries.iter().map(Vec::len).sum();
        let share = |count: usize| {
            let by_length = (count as f64 * length / self.total).round() as usize;
            by_length.max((TRIANGLES_PER_POINT * points).min(count)).max(1)
        };
        let resolution = match self.options.resolution {
            Resolution::Triangles(count) => Resolution::Triangles(share(count)),
            Resolution::InteriorVertices(count) => Resolution::InteriorVertices(share(count)),
            length @ Resolution::EdgeLength(_) => length,
        };
        let method = Method::Newton(Newton { topology: TopologyRule::Fixed, on_unstable: OnUnstable::Descend });
        let smaller = (polyline::radius(&boundaries.concat()) / self.radius).clamp(SMALLEST_PART, 1.0);
        let tolerance = if smaller < 1.0 { MARGIN * smaller * self.options.tolerance } else { self.options.tolerance };
        Options { resolution, method, tolerance, ..self.options.clone() }
    }

    fn task(options: &Options, boundary_edges: BoundaryEdges, may_refine: bool) -> newton::Task {
        let (limits, slides) = (options.limits(), options.slides);
        let on_unstable = OnUnstable::Descend;
        newton::Task { limits, on_unstable, given: false, may_widen: true, may_refine, boundary_edges, slides }
    }

    /// Step 1 for one set, or step 3 if coarse meshes have a film over the set.
    fn part(&self, set: u32, coarse: Option<&SolvedFilm>, exec: &Execution) -> Result<SolvedFilm, Error> {
        let boundaries: Vec<Vec<DVec3>> = members(set).into_iter().map(|k| self.boundaries[k].clone()).collect();
        let Some(coarse) = coarse else {
            return match cone::part(&boundaries, exec)? {
                Some(parted) => Err(cone::refusal(&parted)),
                None => self.least_or_refined(&boundaries, exec),
            };
        };
        match self.connected(&boundaries, &start_of(coarse.kind), coarse.arrangement, true, exec) {
            Ok(film) if spans(&film) || !spans(coarse) || film.run.stop_reason == StopReason::Deadline => Ok(film),
            Ok(_) | Err(Error::NoResult { .. } | Error::Input(_)) => self.refined(&boundaries, coarse, exec),
            Err(error) => Err(error),
        }
    }

    /// Step 1 for boundaries that no cone separates.
    fn least_or_refined(&self, boundaries: &[Vec<DVec3>], exec: &Execution) -> Result<SolvedFilm, Error> {
        let least = match self.least(boundaries, exec) {
            Err(error @ Error::Interrupted(_)) => return Err(error),
            least => least,
        };
        let ends = |film: &SolvedFilm| spans(film) || film.run.stop_reason == StopReason::Deadline;
        let is_whole = boundaries.len() > 1 && boundaries.len() == self.boundaries.len();
        if !is_whole || least.as_ref().is_ok_and(ends) {
            return least;
        }
        // Where a film is a narrow strip, the starts lead to the film at some sizes of the mesh and not at others.
        let triangles = estimate(self.boundaries, &self.options).triangles / 2.0;
        let found = match self.with_triangles(triangles as usize).least(boundaries, exec) {
            Ok(coarse) if spans(&coarse) => self.refined(boundaries, &coarse, exec),
            found => found,
        };
        match found {
            Err(error @ Error::Interrupted(_)) => Err(error),
            Ok(film) if ends(&film) => Ok(film),
            _ => least,
        }
    }

    /// Refines the film of a coarse mesh to the wanted edge length and solves it again. Shorter edges at necks stay.
    fn refined(&self, boundaries: &[Vec<DVec3>], coarse: &SolvedFilm, exec: &Execution) -> Result<SolvedFilm, Error> {
        let options = self.options_for(boundaries);
        let mut film = coarse.film.clone();
        let initial_area = film.area();
        let of_count = |triangles: usize| (initial_area / (0.75f64.sqrt() / 2.0 * triangles as f64)).sqrt();
        let length = match options.resolution {
            Resolution::Triangles(count) => of_count(count),
            Resolution::InteriorVertices(count) => of_count(2 * count),
            Resolution::EdgeLength(length) => length,
        };
        let sizes = vec![length; film.vertices.len()];
        refine(&mut film, sizes, newton::REFINING_PASSES, options.boundary_edges(), exec)?;
        let mut run = newton::run(&mut film, Self::task(&options, options.boundary_edges(), true), exec)?;
        run.refined |= coarse.run.refined;
        Ok(SolvedFilm { film, initial_area, run, ..coarse.clone() })
    }

    /// Returns the film of least area among those from all initial meshes. Films that hold come first, and among these
    /// the films that do not pass through themselves.
    fn least(&self, boundaries: &[Vec<DVec3>], exec: &Execution) -> Result<SolvedFilm, Error> {
        let first = self.connected(boundaries, &InitialMesh::Auto, None, true, exec)?;
        if boundaries.len() == 1 {
            return Ok(first);
        }
        let rank = |film: &SolvedFilm| -> Result<(bool, bool), Interruption> {
            let holds = spans(film);
            Ok((!holds, holds && film_crosses_itself(&film.film, exec)? == Some(true)))
        };
        let mut least = (rank(&first)?, first);
        let mut tried = vec![least.1.kind];
        let otherwise = [InitialMesh::Disk, InitialMesh::Planar, InitialMesh::Rings].map(|start| (start, None, None));
        // Several boundaries can be laid out in the plane in several ways. If the most likely layout gives a surface
        // that does not hold or passes through itself, another layout may give a film. If the first solve does not
        // converge, nearly always there is no film, and each solve takes as long. The other layouts are then tried only
        // for the film over all boundaries. Such a film depends much on its start, so the least of all is taken.
        let has_converged = least.1.run.stop_reason == StopReason::Residual;
        let is_whole = boundaries.len() == self.boundaries.len();
        let layouts = if has_converged || is_whole { initial_mesh::arrangements(boundaries) } else { 0 };
        let layouts = (0..layouts).map(|k| (InitialMesh::Disk, Some(k), None));
        let orders = if is_whole { other_orders(boundaries.len()) } else { Vec::new() };
        let orders = orders.into_iter().map(|order| (InitialMesh::Auto, None, Some(order)));
        // Whether the least film comes from a chosen layout or another order.
        let mut is_chosen = false;
        for (start, arrangement, order) in otherwise.into_iter().chain(layouts).chain(orders) {
            let chooses = arrangement.is_some() || order.is_some();
            let is_needless = if chooses {
                least.0 == (false, false) && (has_converged || !is_chosen)
            } else {
                tried.iter().any(|&kind| is_of_kind(&start, kind))
            };
            if is_needless || least.1.run.stop_reason == StopReason::Deadline {
                continue;
            }
            let next = match &order {
                Some(order) => self.in_other_order(boundaries, order, exec),
                None => self.connected(boundaries, &start, arrangement, true, exec).map(Some),
            };
            let next = match next {
                Ok(Some(next)) => next,
                Ok(None) | Err(Error::NoResult { .. } | Error::Input(_)) => continue,
                Err(Error::Interrupted(Interruption::DeadlinePassed)) if spans(&least.1) => break,
                Err(error) => return Err(error),
            };
            tried.push(next.kind);
            let rank = rank(&next)?;
            let is_less = next.film.area() < (1.0 - EQUAL_AREA) * least.1.film.area();
            if rank < least.0 || (rank == least.0 && is_less) {
                least = (rank, next);
                is_chosen = chooses;
            }
        }
        Ok(least.1)
    }

    /// Solves all boundaries in another order. The loops of the returned film are in the usual order.
    fn in_other_order(
        &self,
        boundaries: &[Vec<DVec3>],
        order: &[usize],
        exec: &Execution,
    ) -> Result<Option<SolvedFilm>, Error> {
        let listed: Vec<Vec<DVec3>> = order.iter().map(|&k| boundaries[k].clone()).collect();
        let solved = self.connected(&listed, &InitialMesh::Auto, None, true, exec)?;
        let film = together(boundaries, &[(order.to_vec(), &solved)]);
        Ok(film.map(|film| SolvedFilm { film, ..solved }))
    }

    fn connected(
        &self,
        boundaries: &[Vec<DVec3>],
        initial_mesh: &InitialMesh,
        arrangement: Option<usize>,
        may_refine: bool,
        exec: &Execution,
    ) -> Result<SolvedFilm, Error> {
        let options = Options { initial_mesh: initial_mesh.clone(), ..self.options_for(boundaries) };
        if let Some(solved) = nested::solve(boundaries, &options, arrangement, OnUnstable::Descend, exec)? {
            return Ok(solved);
        }
        let (start, kind) = initial_mesh::build(boundaries, &options, arrangement, exec)?;
        let mut film = start.refined(exec)?;
        let initial_area = film.area();
        // Widening would move the bridges of a narrow strip away from the corners that they join.
        let is_narrow = kind == InitialMeshKind::Rings && *initial_mesh != InitialMesh::Rings;
        let task = Self::task(&options, options.boundary_edges(), may_refine);
        let run = newton::run(&mut film, newton::Task { may_widen: !is_narrow, ..task }, exec)?;
        Ok(SolvedFilm { film, kind, arrangement, initial_area, run })
    }

    /// Step 4.
    ///
    /// # Errors
    /// [`Error::Interrupted`] on cancel and at a deadline, because the fraction is known only in the end.
    fn widest_gap(&self, exec: &Execution) -> Result<LargestGap, Error> {
        let [first, second] = self.boundaries else { return Ok(LargestGap::NotFound) };
        let gap = polyline::mean(second) - polyline::mean(first);
        let size = self.boundaries.iter().flatten().map(|p| p.length()).fold(0.0, f64::max);
        if gap.length() <= 1e-9 * size {
            return Ok(LargestGap::NotFound);
        }
        let at = |fraction: f64| -> Vec<Vec<DVec3>> {
            vec![first.clone(), second.iter().map(|&p| p - gap * (1.0 - fraction)).collect()]
        };
        let mut held = Vec::new();
        for halving in 1..=HALVINGS {
            let fraction = 0.5f64.powi(halving as i32);
            match self.connected(&at(fraction), &InitialMesh::Auto, None, false, exec) {
                Ok(part) if spans(&part) => {
                    held.push((fraction, part));
                    break;
                }
                Ok(part) if part.run.stop_reason == StopReason::Deadline => return Err(late()),
                Ok(_) | Err(Error::NoResult { .. } | Error::Input(_)) => {}
                Err(error) => return Err(error),
            }
        }
        let Some((fraction, _)) = held.last() else { return Ok(LargestGap::NotFound) };
        let mut step = 0.5 * (1.0 - fraction);
        while let Some((fraction, part)) = held.last()
            && step > 0.5 * GAP_RESOLUTION
        {
            let tried = f64::min(fraction + step, 1.0);
            let may_refine = tried >= 1.0;
            let next = self.moved(part, gap * (tried - fraction), may_refine, None, exec)?;
            if next.run.stop_reason == StopReason::Deadline {
                return Err(late());
            }
            if spans(&next) && tried >= 1.0 {
                let mut part = next;
                // The steps accumulated rounding errors: the boundary is set to the exact input points.
                for (loop_, points) in part.film.boundaries.clone().iter().zip(self.boundaries) {
                    if loop_.len() == points.len() {
                        loop_.iter().zip(points).for_each(|(&v, &p)| part.film.vertices[v as usize] = p);
                    }
                }
                return Ok(LargestGap::Full(Box::new(part)));
            }
            if spans(&next) {
                held.push((tried, next));
            } else {
                step *= 0.5;
            }
        }
        self.refined_fraction(held, gap, exec)
    }

    /// Returns the largest fraction of the gap at which a film holds whose neck is refined. `held` has the films on the
    /// way that were not refined, in ascending order of their fractions. Their coarse meshes hold a thin neck at gaps
    /// at which no film exists.
    fn refined_fraction(
        &self,
        mut held: Vec<(f64, SolvedFilm)>,
        gap: DVec3,
        exec: &Execution,
    ) -> Result<LargestGap, Error> {
        let solves = Some(REFINED_SOLVES);
        let (mut above, mut back) = (1.0, FIRST_STEP_BACK);
        let mut found = None;
        while let Some((fraction, part)) = held.pop() {
            let refined = self.moved(&part, DVec3::ZERO, true, solves, exec)?;
            if refined.run.stop_reason == StopReason::Deadline {
                return Err(late());
            }
            if spans(&refined) {
                found = Some((fraction, refined));
                break;
            }
            above = fraction;
            let kept = held.partition_point(|(own, _)| *own <= fraction - back);
            held.truncate(kept.max(1));
            back *= 2.0;
        }
        let Some((mut fraction, mut part)) = found else { return Ok(LargestGap::NotFound) };
        while above - fraction > GAP_RESOLUTION {
            let tried = 0.5 * (fraction + above);
            let next = self.moved(&part, gap * (tried - fraction), true, solves, exec)?;
            if next.run.stop_reason == StopReason::Deadline {
                return Err(late());
            }
            if spans(&next) {
                (fraction, part) = (tried, next);
            } else {
                above = tried;
            }
        }
        Ok(LargestGap::Fraction(fraction))
    }

    /// Moves the second of a film's two boundaries by `shift` and solves the film again, by at most `solves` linear solves
    /// if this is less than the caller's limit. If `may_refine` is set, a mesh that is too coarse for the neck is refined.
    fn moved(
        &self,
        part: &SolvedFilm,
        shift: DVec3,
        may_refine: bool,
        solves: Option<u32>,
        exec: &Execution,
    ) -> Result<SolvedFilm, Error> {
        let mut film = moved_apart(&part.film, shift);
        let mut task = Self::task(&self.options, BoundaryEdges::Kept, may_refine);
        task.limits.max_iterations = task.limits.max_iterations.into_iter().chain(solves).min();
        let run = newton::run(&mut film, task, exec)?;
        Ok(SolvedFilm { film, run, ..part.clone() })
    }
}

/// The orders, besides the usual one, in which the connected film over all boundaries is tried: each other boundary
/// comes first once. A film may be found in one order only, because the initial mesh depends on the order: the first of
/// equally long boundaries becomes the outer circle of the plane layout.
fn other_orders(count: usize) -> Vec<Vec<usize>> {
    let with_first = |first: usize| std::iter::once(first).chain((0..count).filter(|&k| k != first)).collect();
    (1..count).map(with_first).collect()
}

/// Whether the choice `start` leads to an initial mesh of this kind.
fn is_of_kind(start: &InitialMesh, kind: InitialMeshKind) -> bool {
    match start {
        InitialMesh::Planar => kind == InitialMeshKind::Planar,
        InitialMesh::Rings => kind == InitialMeshKind::Rings,
        _ => matches!(kind, InitialMeshKind::Disk | InitialMeshKind::Annulus | InitialMeshKind::SphereWithHoles),
    }
}

/// The choice of initial mesh that leads to this kind.
fn start_of(kind: InitialMeshKind) -> InitialMesh {
    match kind {
        InitialMeshKind::Planar => InitialMesh::Planar,
        InitialMeshKind::Rings => InitialMesh::Rings,
        InitialMeshKind::Disk | InitialMeshKind::Annulus | InitialMeshKind::SphereWithHoles => InitialMesh::Disk,
        InitialMeshKind::Barycentres | InitialMeshKind::Given => InitialMesh::Auto,
    }
}

fn late() -> Error {
    Error::Interrupted(Interruption::DeadlinePassed)
}

/// Moves the second of a film's two boundaries by `shift`. An interior vertex at the distances d and e from the first
/// and the second boundary moves by `shift` times d / (d + e).
fn moved_apart(film: &Film, shift: DVec3) -> Film {
    let mut moved = film.clone();
    let mut part = vec![None; film.vertices.len()];
    for (boundary, loop_) in film.boundaries.iter().enumerate() {
        loop_.iter().for_each(|&v| part[v as usize] = Some(boundary as f64));
    }
    let distance = |p: DVec3, boundary: &[u32]| {
        let squared = |&v: &u32| film.vertices[v as usize].distance_squared(p);
        boundary.iter().map(squared).fold(f64::INFINITY, f64::min).sqrt()
    };
    for (vertex, part) in moved.vertices.iter_mut().zip(part) {
        let part = part.unwrap_or_else(|| {
            let (first, second) = (distance(*vertex, &film.boundaries[0]), distance(*vertex, &film.boundaries[1]));
            first / (first + second)
        });
        *vertex += shift * part;
    }
    moved
}
