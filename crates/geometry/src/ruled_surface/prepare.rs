//! Input checks, cleaning, sampling and direction; and from paths to one welded mesh.

use super::convexity::Test;
use super::lanes::Widest;
use super::objective::{Objective, Secondary};
use super::sampling::{self, Sampling};
use super::shortest_path::Pulse;
use super::solve_strip::{self, Goal};
use super::strip::{Given, Strip};
use super::unroll::{FlatPattern, unroll};
use super::warnings::{BENDING_CHECKED_UP_TO, CLOSED_BENDING_CHECKED_UP_TO};
use super::{Caps, Cost, Options, RuledSurface, Statistics};
use crate::error::{Error, InputError, Place, Warning};
use crate::execution::{Execution, Interruption};
use crate::polyline::LARGEST_COORDINATE;
use crate::{DVec3, Mesh, polyline};

/// Errors listed before the rest is left out.
const MOST_ERRORS: usize = 51;
/// Samples of one directrix.
const MOST_SAMPLES: usize = 1 << 24;
/// The largest convexity tolerance, radians: beyond it nothing is concave.
const LARGEST_TOLERANCE: f64 = std::f64::consts::FRAC_PI_4;

const TOO_FEW_CLOSED: &str = "a closed directrix needs three distinct points, or one (an apex)";

/// A directrix ready to be solved.
#[derive(Clone, Debug)]
pub(super) struct Directrix {
    pub(super) points: Vec<DVec3>,
    tangents: Option<Vec<DVec3>>,
    normals: Option<Vec<DVec3>>,
    /// Index of the first vertex.
    offset: usize,
    /// For each input point the index into `points` as they were before any reversal.
    vertex_of: Vec<usize>,
    pub(super) reversed: bool,
}

impl Directrix {
    fn given(&self) -> Given<'_> {
        Given { points: &self.points, tangents: self.tangents.as_deref(), normals: self.normals.as_deref() }
    }
    pub(super) fn reverse(&mut self) {
        self.points.reverse();
        if let Some(tangents) = &mut self.tangents {
            tangents.reverse();
            tangents.iter_mut().for_each(|t| *t = -*t);
        }
        if let Some(normals) = &mut self.normals {
            normals.reverse();
        }
        self.reversed = !self.reversed;
    }
    fn vertex(&self, index: usize) -> u32 {
        let index = if self.reversed { self.points.len() - 1 - index } else { index };
        (self.offset + index) as u32
    }
}

#[derive(Clone, Debug)]
pub(super) struct Prepared {
    pub(super) closed: bool,
    pub(super) directrices: Vec<Directrix>,
    pub(super) warnings: Vec<Warning>,
}

impl Prepared {
    pub(super) fn lengths(&self) -> Vec<usize> {
        self.directrices.iter().map(|d| d.points.len()).collect()
    }
    pub(super) fn strip(&self, k: usize) -> Strip {
        Strip::of_checked(self.directrices[k].given(), self.directrices[k + 1].given(), self.closed)
    }
    pub(super) fn strips(&self) -> Vec<Strip> {
        (0..self.directrices.len() - 1).map(|k| self.strip(k)).collect()
    }
}

/// Checks the input and makes it ready. `sampling` is the options' own, or none for the checks alone.
pub(super) fn prepare(
    directrices: &[Vec<DVec3>],
    options: &Options,
    sampling: Option<Sampling>,
    execution: &Execution<'_>,
) -> Result<Prepared, Error> {
    let mut errors = option_errors(directrices, options);
    let points: Vec<&[DVec3]> = directrices.iter().map(Vec::as_slice).collect();
    errors.extend(value_errors("directrices", &points));
    for (name, values) in [("normals", &options.normals), ("tangents", &options.tangents)] {
        if let Some(values) = values {
            let values: Vec<&[DVec3]> = values.iter().map(Vec::as_slice).collect();
            errors.extend(shape_errors(name, &values, &points));
            errors.extend(value_errors(name, &values));
        }
    }
    if !errors.is_empty() {
        errors.truncate(MOST_ERRORS);
        return Err(Error::Input(errors));
    }
    let mut prepared = Prepared { closed: options.closed, directrices: Vec::new(), warnings: Vec::new() };
    let mut offset = 0;
    for (k, points) in directrices.iter().enumerate() {
        let along = |values: &Option<Vec<Vec<DVec3>>>| values.as_ref().map(|values| values[k].clone());
        let (directrix, dropped) = clean(
            points,
            along(&options.tangents),
            along(&options.normals),
            (options.closed, sampling),
            offset,
            execution,
        )?;
        if dropped > 0 {
            prepared.warnings.push(Warning::new(
                "merged_points",
                format!("directrix {k}: {dropped} points equal to their neighbour were merged"),
            ));
        }
        let count = directrix.points.len();
        if options.closed && count == 2 {
            errors.push(InputError::new(Place::field("directrices").at(k), TOO_FEW_CLOSED));
        }
        if count == 1 && prepared.directrices.last().is_some_and(|before| before.points.len() == 1) {
            let detail = "two directrices of one point next to each other span nothing";
            errors.push(InputError::new(Place::field("directrices").at(k), detail));
        }
        if count == 1 && k > 0 && k + 1 < directrices.len() {
            prepared.warnings.push(Warning::new(
                "apex_inside",
                format!("directrix {k} is a single point between two strips: the surface is pinched there"),
            ));
        }
        offset += count;
        prepared.directrices.push(directrix);
    }
    if u32::try_from(offset).is_err() {
        errors.push(InputError::new(Place::field("directrices"), "more points than a mesh can index"));
    }
    if errors.is_empty() { Ok(prepared) } else { Err(Error::Input(errors)) }
}

/// What is wrong with an objective and what goes with it.
pub(super) fn goal_errors(
    objective: Objective,
    secondary: Option<Secondary>,
    convexity_tolerance: f64,
    has_normals: bool,
) -> Vec<InputError> {
    let mut errors = Vec::new();
    let mut refuse = |place: Place, detail: &str| errors.push(InputError::new(place, detail));
    if !(0.0..=LARGEST_TOLERANCE).contains(&convexity_tolerance) {
        refuse(Place::field("convexity_tolerance"), "must lie between 0 and 45 degrees");
    }
    if secondary.is_some() && objective != Objective::MaximalConvexity {
        refuse(Place::field("secondary_objective"), "goes with the objective maximal_convexity only");
    }
    let weights = match objective {
        Objective::Weighted(weights) => weights.terms().to_vec(),
        _ => Vec::new(),
    };
    for (objective, weight) in &weights {
        if !(weight.is_finite() && *weight >= 0.0) {
            refuse(Place::field("objective").then("weights").then(objective.name()), "must be finite and not negative");
        }
    }
    if !weights.is_empty() && weights.iter().all(|&(_, weight)| weight == 0.0) {
        refuse(Place::field("objective").then("weights"), "at least one weight must be positive");
    }
    if (Goal { objective, secondary }).needs_normals() && !has_normals {
        refuse(Place::field("normals"), "minimal_normal_variation needs surface normals along the directrices");
    }
    errors
}

fn option_errors(directrices: &[Vec<DVec3>], options: &Options) -> Vec<InputError> {
    let mut errors = Vec::new();
    if directrices.len() < 2 {
        errors.push(InputError::new(Place::field("directrices"), "a ruled surface needs two or more directrices"));
    }
    errors.extend(goal_errors(
        options.objective,
        options.secondary,
        options.convexity_tolerance,
        options.normals.is_some(),
    ));
    let mut refuse = |place: Place, detail: &str| errors.push(InputError::new(place, detail));
    if options.caps == Caps::Flat && !options.closed {
        refuse(Place::field("caps"), "flat caps close the ends of closed directrices only");
    }
    if let Some(sampling) = options.sampling {
        let least = if options.closed { 3 } else { 2 };
        let samples = match sampling {
            Sampling::Parameter { samples } | Sampling::ArcLength { samples } => Some(samples),
            Sampling::ChordHeight { samples, tolerance } => {
                if !(tolerance.is_finite() && tolerance >= 0.0) {
                    refuse(Place::field("sampling").then("tolerance"), "must be finite and not negative");
                }
                samples
            }
        };
        if samples.is_some_and(|samples| samples < least) {
            refuse(Place::field("sampling").then("samples"), "must leave two points, three on closed directrices");
        }
        if samples.is_some_and(|samples| samples > MOST_SAMPLES) {
            refuse(Place::field("sampling").then("samples"), "must not exceed 16,777,216");
        }
    }
    errors
}

fn value_errors(name: &'static str, lists: &[&[DVec3]]) -> Vec<InputError> {
    let mut errors = Vec::new();
    for (k, list) in lists.iter().enumerate() {
        if list.is_empty() {
            errors.push(InputError::new(Place::field(name).at(k), "must not be empty"));
        }
        for (index, point) in list.iter().enumerate() {
            for axis in 0..3 {
                let (finite, small) = (point[axis].is_finite(), point[axis].abs() <= LARGEST_COORDINATE);
                if !(finite && small) && errors.len() < MOST_ERRORS {
                    let detail = if finite { "must not exceed 1e50" } else { "must be finite" };
                    errors.push(InputError::new(Place::field(name).at(k).at(index).at(axis), detail));
                }
            }
        }
    }
    errors
}

fn shape_errors(name: &'static str, values: &[&[DVec3]], directrices: &[&[DVec3]]) -> Vec<InputError> {
    if values.len() != directrices.len() {
        return vec![InputError::new(Place::field(name), "must have as many lists as there are directrices")];
    }
    let pairs = values.iter().zip(directrices).enumerate();
    pairs
        .filter(|(_, (values, points))| values.len() != points.len())
        .map(|(k, _)| {
            InputError::new(Place::field(name).at(k), "must have as many vectors as the directrix has points")
        })
        .collect()
}

/// What is wrong with the two directrices of a single strip.
pub(super) fn strip_errors(sides: [Given<'_>; 2], closed: bool) -> Vec<InputError> {
    let points = sides.map(|side| side.points);
    let mut errors = value_errors("directrices", &points);
    for (name, values) in [("normals", sides.map(|s| s.normals)), ("tangents", sides.map(|s| s.tangents))] {
        match values {
            [None, None] => {}
            [Some(p), Some(q)] => {
                errors.extend(shape_errors(name, &[p, q], &points));
                errors.extend(value_errors(name, &[p, q]));
            }
            _ => errors.push(InputError::new(Place::field(name), "must be given for both directrices or for neither")),
        }
    }
    if points.iter().all(|side| side.len() == 1) {
        errors.push(InputError::new(Place::field("directrices").at(1), "two single points span nothing"));
    }
    for (k, side) in points.iter().enumerate() {
        if closed && side.len() == 2 {
            errors.push(InputError::new(Place::field("directrices").at(k), TOO_FEW_CLOSED));
        }
    }
    errors
}

/// Merges equal neighbours, samples, merges again (samples of a polyline that turns back can be equal).
fn clean(
    points: &[DVec3],
    tangents: Option<Vec<DVec3>>,
    normals: Option<Vec<DVec3>>,
    (closed, sampling): (bool, Option<Sampling>),
    offset: usize,
    execution: &Execution<'_>,
) -> Result<(Directrix, usize), Interruption> {
    let merged = polyline::merge_equal_neighbours(points, closed);
    let dropped = merged.dropped();
    let pick = |values: Vec<DVec3>, source: &[usize]| source.iter().map(|&k| values[k]).collect::<Vec<_>>();
    let mut tangents = tangents.map(|t| pick(t, &merged.source));
    let mut normals = normals.map(|n| pick(n, &merged.source));
    let (mut points, mut vertex_of) = (merged.points, merged.vertex_of);
    if let Some(sampling) = sampling {
        let samples = sampling::sample(&points, closed, sampling, execution)?;
        let again = polyline::merge_equal_neighbours(&samples.interpolate(&points), closed);
        vertex_of.iter_mut().for_each(|v| *v = again.vertex_of[samples.nearest[*v]]);
        tangents = tangents.map(|t| pick(samples.interpolate(&t), &again.source));
        normals = normals.map(|n| pick(samples.interpolate(&n), &again.source));
        points = again.points;
    }
    Ok((Directrix { points, tangents, normals, offset, vertex_of, reversed: false }, dropped))
}

/// Reverses each directrix in turn where that gives the strip before it the better optimum. A strip's optimum depends on the
/// directions of its two directrices relative to each other only, so going from strip to strip is optimal for the stack.
pub(super) fn choose_directions(
    prepared: &mut Prepared,
    goal: Goal,
    test: Test,
    lanes: Widest,
    pulse: &mut Pulse<'_, '_>,
) -> Result<(), Error> {
    for k in 1..prepared.directrices.len() {
        let mut value = |prepared: &Prepared| -> Result<(f64, f64), Error> {
            let strip = prepared.strip(k - 1);
            let solved = solve_strip::solve_all(&[strip], goal, test, lanes, pulse, &mut Vec::new())?;
            let Statistics { objective_value, secondary_value, .. } = solved.statistics[0];
            let sign = if goal.objective == Objective::MaximalConvexity { -1.0 } else { 1.0 };
            Ok((sign * objective_value, secondary_value.unwrap_or(0.0)))
        };
        let as_given = value(prepared)?;
        prepared.directrices[k].reverse();
        let reversed = value(prepared)?;
        // Equal but for rounding (a straight directrix, an apex): as given.
        let margin = |value: f64| 1e-9 * value.abs();
        let better = reversed.0 < as_given.0 - margin(as_given.0)
            || (reversed.0 <= as_given.0 + margin(as_given.0) && reversed.1 < as_given.1 - margin(as_given.1));
        if !better {
            prepared.directrices[k].reverse();
        }
    }
    Ok(())
}

/// The welded mesh of all strips; figures are filled in by the caller.
pub(super) fn assemble(
    prepared: &Prepared,
    strips: &[Strip],
    paths: &[Vec<[u32; 2]>],
    options: &Options,
    execution: &Execution<'_>,
) -> Result<RuledSurface, Error> {
    let mut vertices = Vec::new();
    for directrix in &prepared.directrices {
        let points = directrix.points.iter().copied();
        if directrix.reversed { vertices.extend(points.rev()) } else { vertices.extend(points) }
    }
    let mut triangles = Vec::with_capacity(2 * vertices.len());
    let mut bridges = Vec::with_capacity(2 * vertices.len());
    let mut flat = Vec::new();
    for (k, (strip, path)) in strips.iter().zip(paths).enumerate() {
        let local = triangles_of(strip, path);
        let (p, q) = (&prepared.directrices[k], &prepared.directrices[k + 1]);
        let m = strip.m() as u32;
        let vertex = |v: u32| if v < m { p.vertex(v as usize) } else { q.vertex((v - m) as usize) };
        triangles.extend(local.iter().map(|t| t.map(vertex)));
        bridges.extend(path.iter().map(|&[i, j]| [p.vertex(i as usize), q.vertex(j as usize)]));
        if !strip.closed {
            flat.push(unroll(strip, path, &local, execution)?);
        }
    }
    let of = |directrix: &Directrix| (0..directrix.points.len()).map(|k| directrix.vertex(k)).collect();
    let input = |d: &Directrix| d.vertex_of.iter().map(|&v| (d.offset + v) as u32).collect();
    Ok(RuledSurface {
        mesh: Mesh::new(vertices, triangles),
        bridges,
        directrices: prepared.directrices.iter().map(of).collect(),
        input_vertices: prepared.directrices.iter().map(input).collect(),
        reversed: prepared.directrices.iter().map(|d| d.reversed).collect(),
        statistics: Statistics::default(),
        strips: Vec::new(),
        comparison: None,
        flat_pattern: (!options.closed).then(|| FlatPattern::of(flat)),
        warnings: Vec::new(),
    })
}

/// The triangles along a path; vertices are P's points, then Q's.
pub(super) fn triangles_of(strip: &Strip, path: &[[u32; 2]]) -> Vec<[u32; 3]> {
    let (m, n, count) = (strip.m() as u32, strip.n() as u32, path.len());
    let steps = if strip.closed { count } else { count - 1 };
    (0..steps)
        .map(|k| {
            let ([i, j], [next, other]) = (path[k], path[(k + 1) % count]);
            let by_p = m > 1 && (n == 1 || next != i);
            if by_p { [i, next, m + j] } else { [i, m + other, m + j] }
        })
        .collect()
}

/// What a stack of directrices with so many points takes.
pub(super) fn cost(lengths: &[usize], options: &Options) -> Cost {
    let goal = Goal { objective: options.objective, secondary: options.secondary };
    let mut goals = vec![goal];
    if let Objective::Weighted(weights) = options.objective
        && weights.normalise
    {
        goals.extend(weights.terms().iter().filter(|(_, weight)| *weight > 0.0).map(|&(o, _)| Goal::single(o)));
    }
    let mut total = Cost::default();
    for pair in lengths.windows(2) {
        if pair[0].min(pair[1]) < 2 {
            continue;
        }
        let (m, n) = (pair[0] as u64, pair[1] as u64);
        let directions = if options.direction == super::Direction::Auto { 3 } else { 1 };
        let (mut cells, mut bytes) = (0u64, 0u64);
        let mut add = |goal: &Goal, times: u64| {
            let (layers, windings) = (goal.layers(), goal.windings());
            let convexity = if goal.objective == Objective::MaximalConvexity { m * n } else { 0 };
            let searches = match (options.closed, layers) {
                (false, _) => 1,
                (true, 1) => u64::from(n.ilog2()) + 2,
                (true, _) => 2 * (u64::from(n.ilog2()) + 2),
            };
            let columns = if options.closed { 2 * n } else { n };
            cells += times * (windings * searches * m * n + convexity);
            let grid = (m + 4) * (columns + 64);
            bytes = bytes.max(grid * layers / 8 + if convexity > 0 { grid / 8 } else { 0 } + 400 * (m + columns));
        };
        for goal in &goals {
            add(goal, directions);
        }
        // What the warnings compare with.
        if goal.objective != Objective::MinimalArea {
            add(&Goal::single(Objective::MinimalArea), 1);
        }
        let limit = if options.closed { CLOSED_BENDING_CHECKED_UP_TO } else { BENDING_CHECKED_UP_TO };
        if m * n <= limit as u64 {
            add(&Goal::single(Objective::MinimalBendingEnergy), 1);
        }
        if options.all_objectives {
            Goal::all(options.normals.is_some()).for_each(|goal| add(&goal, 1));
        }
        total.cells += cells;
        total.bytes = total.bytes.max(bytes);
    }
    total
}
