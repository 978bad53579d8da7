//! Finds the film of least area over several boundaries: solves every way to span them and compares the areas.
//!
//! 1. Each non-empty set of boundaries is spanned by one connected film (a disc, an annulus, a sphere with holes). The
//!    default solver solves it and leaves unstable surfaces. The film *holds* if it converged, is stable and has no
//!    flipped triangle.
//! 2. A spanning topology is a partition of the boundaries with one connected film for each of its sets. Its area and
//!    its Morse index are the sums over the films. A partition with a set that does not hold is listed without an area.
//! 3. The partition of least area is returned. The statistics list the others. If many triangles are asked for, all
//!    partitions are compared on coarse meshes, and those near the least area again at the full size. Partitions
//!    whose films pass through themselves or each other come after all others, whatever their area.
//! 4. If the connected film over two boundaries does not hold, the boundaries are moved together along the line of
//!    their centroids until one does. They are then moved apart in ever shorter steps, each from the last film. The
//!    result is the largest fraction of the gap at which a film holds, or the film itself if the full gap is reached.
//!
//! The films of one partition are solved independently. They may pass through each other, which is reported.

use super::free_topology;
use crate::minimal_surface::estimate::estimate;
use crate::minimal_surface::initial_mesh;
use crate::minimal_surface::options::{
    FreeTopology, Limits, Method, Newton, OnUnstable, Options, Resolution, Solver, TopologyRule,
};
use crate::minimal_surface::run::{Run, SpanningComparison, SpanningTopology, Stability, StabilityMethod, StopReason};
use crate::minimal_surface::solved_film::SolvedFilm;
use crate::minimal_surface::solvers::newton;
use plateau_mesh::crossing::films_cross;
use plateau_mesh::error::Warning;
use plateau_mesh::film::Film;
use plateau_mesh::self_intersections::{Order, self_intersections};
use plateau_mesh::{DVec3, Error, Execution, Interruption, Place, polyline};

// Tunables. The figures in docs/VALIDATION.md were obtained with these values.

/// Largest number of boundaries that [`TopologyRule::Best`] compares. For n boundaries there are 2ⁿ - 1 films to solve;
/// for six there are 203 partitions.
pub(crate) const MOST_BOUNDARIES: usize = 6;
/// Accuracy of the largest fraction of a gap at which a connected film holds. A smaller value takes more solves, about
/// one per halving.
const GAP_RESOLUTION: f64 = 1e-3;
/// Largest number of times that the gap is halved to find a first film. A larger value finds films over boundaries that
/// are further apart.
const HALVINGS: u32 = 8;

/// Number of triangles at which topologies are compared, if more are asked for. Those that come near the least area are
/// then solved at the full size. A larger value compares more exactly and takes longer.
const COMPARED_TRIANGLES: usize = 2_000;
/// Fraction by which areas may exceed the least one and still count as near it. The error of a mesh of
/// [`COMPARED_TRIANGLES`] is about a tenth of this.
const CONTENDS: f64 = 5e-3;
/// Least number of triangles of a film for each of its boundary points, unless fewer are asked for altogether.
const TRIANGLES_PER_POINT: usize = 3;
/// Fraction of the tolerance to which a film is solved that spans some of the boundaries only. The mean of a film's
/// boundary vertices, about which its radius is measured, differs a little from that of the points.
const MARGIN: f64 = 0.5;
/// Smallest radius of such a film that counts, as a fraction of that of all boundaries. A smaller one would ask for a
/// residual below rounding.
const SMALLEST_PART: f64 = 1e-4;

impl SpanningComparison {
    pub(crate) fn warnings(&self) -> Vec<Warning> {
        let mut warnings = Vec::new();
        if !self.connected_film_exists {
            let mut warning = Warning::new("no_connected_film", "no film that connects all boundaries was found");
            if let Some(fraction) = self.largest_gap_fraction {
                warning.detail += &format!("; one would at up to {fraction:.3} of the gap between the two");
                warning = warning.with("largest_gap_fraction", fraction);
            }
            warnings.push(warning);
        }
        if self.topologies.first().is_some_and(|least| least.films_cross) {
            let detail =
                "the films of the least topology pass through each other or themselves; soap films would join there";
            warnings.push(Warning::new("films_cross", detail));
        }
        warnings
    }
}

/// Steps 1 to 4 for centred boundaries. A disc that does not hold (over a knotted boundary, or after a deadline) is
/// kept. A connected film that does not hold is dropped.
///
/// # Errors
/// [`Error::Input`] for more than [`MOST_BOUNDARIES`] boundaries, and the errors of the discs over single boundaries,
/// if no other film spans these.
pub(crate) fn solve(boundaries: &[Vec<DVec3>], options: &Options, exec: &Execution) -> Result<SolvedFilm, Error> {
    let count = boundaries.len();
    if count > MOST_BOUNDARIES {
        let detail = format!("best compares the films over at most {MOST_BOUNDARIES} boundaries");
        return Err(Error::input(Place::field("topology"), detail));
    }
    let full = SpanningProblem::new(boundaries, options.clone());
    // The discs are solved first, so that there is a result if the rest is interrupted.
    let mut sets: Vec<u32> = (1..1 << count).collect();
    sets.sort_by_key(|set| (set.count_ones(), *set));
    let points: usize = boundaries.iter().map(Vec::len).sum();
    let compared_at = COMPARED_TRIANGLES.max(2 * TRIANGLES_PER_POINT * points);
    let is_large = estimate(boundaries, options).triangles > 2.0 * compared_at as f64;
    let coarse = is_large.then(|| {
        let resolution = Resolution::Triangles(compared_at);
        SpanningProblem::new(boundaries, Options { resolution, ..options.clone() })
    });
    let share = if is_large { 0.5 } else { 1.0 };
    let mut parts = exec.part([0.0, share], |exec| coarse.as_ref().unwrap_or(&full).parts(&sets, exec))?;
    let mut compared = parts.compared(&partitions(count), exec)?;
    // The partition into discs has an area unless a boundary bounds no disc.
    if let (None, Some(error)) = (compared[0].area, parts.without_disc.take()) {
        return Err(error);
    }
    let connected_film_exists = parts.films[(1 << count) - 1].is_some();
    let largest_gap_fraction = parts.largest_gap_fraction;
    // The topologies whose areas differ by less than the error of the coarse meshes are solved at full size. If none of
    // their films holds there, the next ones are.
    let mut rest = if is_large && !parts.interrupted { compared.clone() } else { Vec::new() };
    while let Some(least) = rest.first().and_then(|topology| topology.area) {
        let crosses = rest[0].films_cross;
        let contends = |topology: &SpanningTopology| {
            topology.films_cross == crosses && topology.area.is_some_and(|area| area <= (1.0 + CONTENDS) * least)
        };
        let (contenders, others): (Vec<_>, Vec<_>) = rest.into_iter().partition(contends);
        rest = others;
        let contenders: Vec<Vec<u32>> =
            contenders.iter().map(|topology| topology.films.iter().map(|films| set_of(films)).collect()).collect();
        let mut sets: Vec<u32> = contenders.iter().flatten().copied().collect();
        sets.sort_by_key(|set| (set.count_ones(), *set));
        sets.dedup();
        let finer = exec.part([share, 1.0], |exec| full.parts(&sets, exec))?;
        let mut found = finer.compared(&contenders, exec)?;
        if found[0].area.is_some() {
            let is_finer = |topology: &SpanningTopology| found.iter().any(|finer| finer.films == topology.films);
            compared.retain(|topology| !is_finer(topology));
            found.append(&mut compared);
            (compared, parts) = (found, finer);
            break;
        }
        if finer.interrupted {
            parts.interrupted = true;
            break;
        }
    }
    compared[0].chosen = true;
    let chosen: Vec<&SolvedFilm> =
        compared[0].films.iter().filter_map(|films| parts.films[set_of(films) as usize].as_ref()).collect();
    let comparison = SpanningComparison { topologies: compared.clone(), connected_film_exists, largest_gap_fraction };
    let films: Vec<(&[usize], &SolvedFilm)> =
        compared[0].films.iter().map(Vec::as_slice).zip(chosen.iter().copied()).collect();
    let film = together(boundaries, &films)
        .ok_or_else(|| Error::no_result("invalid_mesh", "the films of the chosen topology do not fit together"))?;
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
    run.spanning = Some(comparison);
    let initial_area = chosen.iter().map(|part| part.initial_area).sum();
    Ok(SolvedFilm { film, kind: chosen[0].kind, initial_area, run })
}

/// The boundaries of a set as a number whose bits are the boundaries.
fn set_of(boundaries: &[usize]) -> u32 {
    boundaries.iter().map(|&boundary| 1 << boundary).sum()
}

/// The films over sets of boundaries.
struct Parts {
    /// For each set its film, if one holds. A disc need not hold.
    films: Vec<Option<SolvedFilm>>,
    interrupted: bool,
    /// Why a boundary bounds no disc.
    without_disc: Option<Error>,
    largest_gap_fraction: Option<f64>,
}

impl Parts {
    /// The partitions with their areas, the least one first.
    fn compared(&self, partitions: &[Vec<u32>], exec: &Execution) -> Result<Vec<SpanningTopology>, Error> {
        let mut crosses_itself = Vec::with_capacity(self.films.len());
        for part in &self.films {
            let film = part.as_ref().map(|part| &part.film);
            crosses_itself.push(film.map_or(Ok(false), |film| film_crosses_itself(film, exec))?);
        }
        let mut compared: Vec<SpanningTopology> = Vec::with_capacity(partitions.len());
        for films in partitions {
            let mut films = films.clone();
            films.sort_by_key(|set| set.trailing_zeros());
            compared.push(compare(&films, &self.films, &crosses_itself, exec)?);
        }
        // The areas are rounded, so that the last bits do not decide between mirror images.
        let largest = compared.iter().filter_map(|topology| topology.area).fold(0.0, f64::max);
        let order = |a: &SpanningTopology, b: &SpanningTopology| {
            let key = |topology: &SpanningTopology| {
                topology.area.map_or(f64::INFINITY, |area| (area / largest * 1e9).round())
            };
            let crosses = |topology: &SpanningTopology| topology.area.is_some() && topology.films_cross;
            let known = a.area.is_none().cmp(&b.area.is_none());
            let by_area = known.then(crosses(a).cmp(&crosses(b))).then(key(a).total_cmp(&key(b)));
            by_area.then(a.films.len().cmp(&b.films.len())).then(a.films.cmp(&b.films))
        };
        compared.sort_by(order);
        Ok(compared)
    }
}

/// Whether a film meets itself. Past the deadline that is not looked for any more.
fn film_crosses_itself(film: &Film, exec: &Execution) -> Result<bool, Interruption> {
    match self_intersections(&film.vertices, film.triangles(), Order::Spatial, u64::MAX, exec) {
        Err(Interruption::DeadlinePassed) => Ok(false),
        found => Ok(found?.pairs > 0),
    }
}

/// Areas, stability and crossings of one partition.
fn compare(
    films: &[u32],
    parts: &[Option<SolvedFilm>],
    crosses_itself: &[bool],
    exec: &Execution,
) -> Result<SpanningTopology, Error> {
    let held: Option<Vec<&SolvedFilm>> = films.iter().map(|&set| parts[set as usize].as_ref()).collect();
    let mut topology = SpanningTopology {
        films: films.iter().map(|&set| members(set)).collect(),
        area: None,
        stability: None,
        films_cross: films.iter().any(|&set| crosses_itself[set as usize]),
        chosen: false,
    };
    let Some(held) = held else { return Ok(topology) };
    topology.area = Some(held.iter().map(|part| part.film.area()).sum());
    topology.stability =
        held.iter().map(|part| part.run.stability).collect::<Option<Vec<Stability>>>().and_then(|all| {
            all.into_iter().reduce(|a, b| Stability {
                stable: a.stable && b.stable,
                morse_index: a.morse_index + b.morse_index,
                lowest_eigenvalue: a.lowest_eigenvalue.min(b.lowest_eigenvalue),
                // The combined method is the less certain one.
                method: if a.method == StabilityMethod::Inertia { b.method } else { a.method },
            })
        });
    for (k, part) in held.iter().enumerate() {
        for other in &held[k + 1..] {
            // After the deadline, crossings are no longer searched for. The areas are known already.
            topology.films_cross |= match films_cross(&part.film, &other.film, exec) {
                Err(Interruption::DeadlinePassed) => false,
                cross => cross?,
            };
        }
    }
    Ok(topology)
}

fn members(set: u32) -> Vec<usize> {
    (0..32).filter(|&boundary| set & (1 << boundary) != 0).collect()
}

/// Every partition of `count` boundaries. A set is a number whose bits are the boundaries.
fn partitions(count: usize) -> Vec<Vec<u32>> {
    let mut result = vec![Vec::new()];
    for boundary in 0..count {
        let bit = 1u32 << boundary;
        result = result
            .into_iter()
            .flat_map(|partition: Vec<u32>| {
                let joined = (0..partition.len()).map({
                    let partition = partition.clone();
                    move |k| {
                        let mut partition = partition.clone();
                        partition[k] |= bit;
                        partition
                    }
                });
                let alone = std::iter::once([partition, vec![bit]].concat());
                joined.chain(alone).collect::<Vec<_>>()
            })
            .collect();
    }
    result
}

/// Result of the search for the largest gap between two boundaries that a connected film spans.
enum Widest {
    Full(Box<SolvedFilm>),
    Fraction(f64),
    NotFound,
}

struct SpanningProblem<'a> {
    boundaries: &'a [Vec<DVec3>],
    options: Options,
    /// Length of all boundaries together.
    total: f64,
    /// Largest distance of their points from the mean.
    radius: f64,
}

impl<'a> SpanningProblem<'a> {
    fn new(boundaries: &'a [Vec<DVec3>], options: Options) -> Self {
        let total = boundaries.iter().map(|boundary| polyline::length(boundary, true)).sum();
        Self { boundaries, options, total, radius: polyline::radius(&boundaries.concat()) }
    }

    /// Steps 1 and 4 for some sets.
    fn parts(&self, sets: &[u32], exec: &Execution) -> Result<Parts, Error> {
        let count = self.boundaries.len();
        let mut parts =
            Parts { films: vec![None; 1 << count], interrupted: false, without_disc: None, largest_gap_fraction: None };
        let share = 0.9 / sets.len() as f64;
        for (k, &set) in sets.iter().enumerate() {
            let share = [share * k as f64, share * (k + 1) as f64];
            match exec.part(share, |exec| self.part(set, exec)) {
                Ok(part) => {
                    parts.interrupted |= part.run.stop_reason == StopReason::Deadline;
                    parts.films[set as usize] = (set.count_ones() == 1 || part.holds()).then_some(part);
                }
                Err(Error::Interrupted(Interruption::DeadlinePassed)) if set.count_ones() > 1 => {
                    parts.interrupted = true;
                }
                Err(error @ Error::NoResult { .. }) if set.count_ones() == 1 => {
                    parts.without_disc.get_or_insert(error);
                }
                // No initial mesh connects these boundaries (they touch, or the resolution is too coarse): there is no
                // such film.
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
                Ok(Widest::Full(part)) => parts.films[whole as usize] = Some(*part),
                Ok(Widest::Fraction(fraction)) => parts.largest_gap_fraction = Some(fraction),
                Ok(Widest::NotFound) | Err(Error::Interrupted(Interruption::DeadlinePassed)) => {}
                Err(error) => return Err(error),
            }
        }
        Ok(parts)
    }

    /// The options for a set of boundaries: its share of the resolution is that of its length, and at least
    /// [`TRIANGLES_PER_POINT`], because a film without enough triangles for its own points has no mesh. Its tolerance
    /// is that of the whole film, whose residual is measured by the radius of all boundaries.
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

    fn task(limits: Limits) -> newton::Task {
        newton::Task { limits, on_unstable: OnUnstable::Descend, given: false, may_widen: true }
    }

    /// Step 1 for one set.
    fn part(&self, set: u32, exec: &Execution) -> Result<SolvedFilm, Error> {
        let boundaries: Vec<Vec<DVec3>> = members(set).into_iter().map(|k| self.boundaries[k].clone()).collect();
        self.connected(&boundaries, exec)
    }

    fn connected(&self, boundaries: &[Vec<DVec3>], exec: &Execution) -> Result<SolvedFilm, Error> {
        let options = self.options_for(boundaries);
        let (start, kind) = initial_mesh::build(boundaries, &options, exec)?;
        let start = start.refined(exec)?;
        let (mut film, initial_area) = (start.clone(), start.area());
        let run = newton::run(&mut film, Self::task(options.limits()), exec)?;
        let solved = SolvedFilm { film, kind, initial_area, run };
        if solved.holds() || !lie_side_by_side(boundaries) {
            return Ok(solved);
        }
        // Triangles that are long for the gap fold over. The rules of the free topology remove the thin ones first.
        let mut film = start;
        let euler = film.topology.euler_characteristic();
        let run = free_topology::run(&mut film, &FreeTopology::default(), options.limits(), false, exec)?;
        let is_connected = film.topology.components() == 1 && film.topology.euler_characteristic() == euler;
        let found = SolvedFilm { film, run, ..solved.clone() };
        Ok(if is_connected && found.holds() { found } else { solved })
    }

    /// Step 4.
    fn widest_gap(&self, exec: &Execution) -> Result<Widest, Error> {
        let [first, second] = self.boundaries else { return Ok(Widest::NotFound) };
        let gap = polyline::mean(second) - polyline::mean(first);
        let size = self.boundaries.iter().flatten().map(|p| p.length()).fold(0.0, f64::max);
        if gap.length() <= 1e-9 * size {
            return Ok(Widest::NotFound);
        }
        let at = |fraction: f64| -> Vec<Vec<DVec3>> {
            vec![first.clone(), second.iter().map(|&p| p - gap * (1.0 - fraction)).collect()]
        };
        let mut held = None;
        for halving in 1..=HALVINGS {
            let fraction = 0.5f64.powi(halving as i32);
            match self.connected(&at(fraction), exec) {
                Ok(part) if part.holds() => {
                    held = Some((fraction, part));
                    break;
                }
                Ok(part) if part.run.stop_reason == StopReason::Deadline => return Ok(Widest::NotFound),
                Ok(_) | Err(Error::NoResult { .. } | Error::Input(_)) => {}
                Err(error) => return Err(error),
            }
        }
        let Some((mut fraction, mut part)) = held else { return Ok(Widest::NotFound) };
        let mut step = 0.5 * (1.0 - fraction);
        while step > 0.5 * GAP_RESOLUTION {
            let tried = f64::min(fraction + step, 1.0);
            let mut film = moved_apart(&part.film, gap * (tried - fraction));
            let run = newton::run(&mut film, Self::task(self.options.limits()), exec)?;
            if run.stop_reason == StopReason::Deadline {
                break;
            }
            let next = SolvedFilm { film, run, ..part.clone() };
            if next.holds() {
                (fraction, part) = (tried, next);
                if fraction >= 1.0 {
                    // The steps accumulated rounding errors: the boundary is set to the exact input points.
                    for (loop_, points) in part.film.boundaries.clone().iter().zip(self.boundaries) {
                        if loop_.len() == points.len() {
                            loop_.iter().zip(points).for_each(|(&v, &p)| part.film.vertices[v as usize] = p);
                        }
                    }
                    return Ok(Widest::Full(Box::new(part)));
                }
            } else {
                step *= 0.5;
            }
        }
        Ok(Widest::Fraction(fraction))
    }
}

/// Whether two boundaries are everywhere nearer to each other than their own points are.
fn lie_side_by_side(boundaries: &[Vec<DVec3>]) -> bool {
    let [first, second] = boundaries else { return false };
    let edge = polyline::length(first, true) / first.len() as f64;
    let is_near = |point: &DVec3| second.iter().any(|other| other.distance(*point) < edge);
    first.iter().all(is_near)
}

/// The film with its second boundary moved by `shift`. Every other vertex moves by the fraction that its distances to
/// the two boundaries give.
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

/// Joins several films into one. The input points of the boundaries come first, in input order, then the other vertices
/// film by film.
fn together(boundaries: &[Vec<DVec3>], films: &[(&[usize], &SolvedFilm)]) -> Option<Film> {
    let mut first = Vec::with_capacity(boundaries.len());
    let mut count = 0u32;
    for boundary in boundaries {
        first.push(count);
        count += boundary.len() as u32;
    }
    let mut vertices: Vec<DVec3> = boundaries.iter().flatten().copied().collect();
    let mut fixed = vec![true; vertices.len()];
    let (mut triangles, mut loops, mut locked) = (Vec::new(), vec![Vec::new(); boundaries.len()], Vec::new());
    for (set, part) in films {
        let film = &part.film;
        let own: usize = set.iter().map(|&k| boundaries[k].len()).sum();
        let mut renamed: Vec<u32> = set
            .iter()
            .flat_map(|&k| (0..boundaries[k].len() as u32).map(|i| i + first[k]).collect::<Vec<_>>())
            .collect();
        for v in own..film.vertices.len() {
            renamed.push(vertices.len() as u32);
            vertices.push(film.vertices[v]);
            fixed.push(film.fixed[v]);
        }
        triangles.extend(film.triangles().iter().map(|t| t.map(|v| renamed[v as usize])));
        for (&boundary, loop_) in set.iter().zip(&film.boundaries) {
            loops[boundary] = loop_.iter().map(|&v| renamed[v as usize]).collect();
        }
        locked.extend(film.locked.iter().map(|&[a, b]| {
            let (a, b) = (renamed[a as usize], renamed[b as usize]);
            [a.min(b), a.max(b)]
        }));
    }
    locked.sort_unstable();
    let mut film = Film::new(vertices, &triangles, loops)?;
    (film.fixed, film.locked) = (fixed, locked);
    Some(film)
}
