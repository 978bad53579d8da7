//! Checks the input of a stack, merges near neighbours of its directrices and resamples them.

use super::caps;
use super::moving::ladder::Freedom;
use super::options::{Caps, DirectionCriterion, Options, RailEnds};
use super::sampling::{self, Sampling};
use crate::graph::rails::{Given, Rails};
use crate::graph::weight::BendingLaw;
use crate::strip::check::{MOST_ERRORS, TOO_FEW_CLOSED, goal_errors, shape_errors, value_errors};
use crate::strip::objective::Objective;
use plateau_mesh::codes::WarningCode;
use plateau_mesh::error::{Error, InputError, Place, Warning};
use plateau_mesh::execution::{Execution, Interruption};
use plateau_mesh::{DVec3, polyline};
use std::borrow::Cow;

/// Largest number of samples of one directrix.
const MOST_SAMPLES: usize = 1 << 24;

/// A directrix ready to be solved.
#[derive(Clone, Debug)]
pub(crate) struct Directrix {
    pub(crate) points: Vec<DVec3>,
    tangents: Option<Vec<DVec3>>,
    normals: Option<Vec<DVec3>>,
    /// Index of the directrix's first point among the vertices of the mesh.
    pub(crate) offset: usize,
    /// For each input point the index of its point in `points`, in the order before any reversal.
    pub(crate) vertex_of: Vec<usize>,
    pub(crate) reversed: bool,
    pub(crate) direction_decided_by: Option<DirectionCriterion>,
}

impl Directrix {
    pub(crate) fn given(&self) -> Given<'_> {
        Given { points: &self.points, tangents: self.tangents.as_deref(), normals: self.normals.as_deref() }
    }
    pub(crate) fn reverse(&mut self) {
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
    /// Returns the index of the first input point that lies at or after the point `index`. The directrix must not be
    /// reversed.
    pub(crate) fn input_point(&self, index: usize) -> usize {
        self.vertex_of.iter().position(|&vertex| vertex >= index).unwrap_or(0)
    }
    pub(crate) fn vertex(&self, index: usize) -> u32 {
        let index = if self.reversed { self.points.len() - 1 - index } else { index };
        (self.offset + index) as u32
    }
}

#[derive(Clone, Debug)]
pub(crate) struct Prepared {
    pub(crate) closed: bool,
    pub(crate) bending: BendingLaw,
    pub(crate) directrices: Vec<Directrix>,
    pub(crate) warnings: Vec<Warning>,
}

impl Prepared {
    pub(crate) fn lengths(&self) -> Vec<usize> {
        self.directrices.iter().map(|d| d.points.len()).collect()
    }
    pub(crate) fn strip(&self, k: usize) -> Rails {
        let rails = Rails::new(self.directrices[k].given(), self.directrices[k + 1].given(), self.closed);
        Rails { bending: self.bending, ..rails }
    }
    pub(crate) fn strips(&self) -> Vec<Rails> {
        (0..self.directrices.len() - 1).map(|k| self.strip(k)).collect()
    }
}

/// Checks the input, merges near neighbours of the directrices and resamples them. `sampling` is the sampling of the
/// options, or `None` if only the checks are needed.
pub(crate) fn prepare(
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
    if errors.is_empty() {
        let excess = Freedom::new(directrices, options).and_then(Freedom::excess);
        errors.extend(excess.map(|detail| InputError::new(Place::field("rail_tolerance"), detail)));
    }
    if !errors.is_empty() {
        errors.truncate(MOST_ERRORS);
        return Err(Error::Input(errors));
    }
    let Options { closed, bending, .. } = *options;
    let mut prepared = Prepared { closed, bending, directrices: Vec::new(), warnings: Vec::new() };
    let mut offset = 0;
    for (k, points) in directrices.iter().enumerate() {
        let mut points = Cow::Borrowed(points);
        if options.caps == Caps::Flat && (k == 0 || k + 1 == directrices.len()) {
            match caps::project(&points, Place::field("directrices").at(k)) {
                Ok(None) => {}
                Ok(Some((projected, distance))) => {
                    prepared
                        .warnings
                        .push(Warning::projected(&format!("directrix {k}"), distance).with_count("directrix", k));
                    points = Cow::Owned(projected);
                }
                Err(error) => errors.push(error),
            }
        }
        let along = |values: &Option<Vec<Vec<DVec3>>>| values.as_ref().map(|values| values[k].clone());
        let (directrix, dropped) = clean(
            &points,
            along(&options.tangents),
            along(&options.normals),
            (options.closed, sampling),
            offset,
            execution,
        )?;
        if dropped > 0 {
            prepared.warnings.push(Warning::merged_points(dropped, Some(k)));
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
            let detail = format!("directrix {k} is a single point between two strips: the surface is pinched there");
            prepared.warnings.push(Warning::new(WarningCode::ApexInside, detail).with_count("directrix", k));
        }
        offset += count;
        prepared.directrices.push(directrix);
    }
    if u32::try_from(offset).is_err() {
        errors.push(InputError::new(Place::field("directrices"), "more points than a mesh can index"));
    }
    if errors.is_empty() { Ok(prepared) } else { Err(Error::Input(errors)) }
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
    if let Some(tolerance) = options.rail_tolerance {
        if !(tolerance.is_finite() && tolerance >= 0.0) {
            refuse(Place::field("rail_tolerance"), "must be finite and not negative");
        }
        if options.caps == Caps::Flat {
            refuse(
                Place::field("rail_tolerance"),
                "goes without caps, because points that move leave the planes of the end contours",
            );
        }
        if matches!(options.objective, Objective::Weighted(weights) if weights.normalise) {
            let detail = "needs a weighted sum whose terms are not normalised, because the optima by which they would \
                          be divided change with the rails";
            refuse(Place::field("rail_tolerance"), detail);
        }
    }
    if options.rail_ends == RailEnds::Fixed && options.closed {
        refuse(Place::field("rail_ends"), "closed directrices have no ends");
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

/// Merges near neighbours of one directrix, resamples it, and merges again, because samples of a polyline that turns
/// back can be equal. Returns the directrix and the number of input points that the first merge dropped.
fn clean(
    points: &[DVec3],
    tangents: Option<Vec<DVec3>>,
    normals: Option<Vec<DVec3>>,
    (closed, sampling): (bool, Option<Sampling>),
    offset: usize,
    execution: &Execution<'_>,
) -> Result<(Directrix, usize), Interruption> {
    let merged = polyline::merge_near_neighbours(points, closed);
    let dropped = merged.dropped();
    let pick = |values: Vec<DVec3>, source: &[usize]| source.iter().map(|&k| values[k]).collect::<Vec<_>>();
    let mut tangents = tangents.map(|t| pick(t, &merged.source));
    let mut normals = normals.map(|n| pick(n, &merged.source));
    let (mut points, mut vertex_of) = (merged.points, merged.vertex_of);
    if let Some(sampling) = sampling {
        let samples = sampling::sample(&points, closed, sampling, execution)?;
        let again = polyline::merge_near_neighbours(&samples.interpolate(&points), closed);
        vertex_of.iter_mut().for_each(|v| *v = again.vertex_of[samples.nearest[*v]]);
        tangents = tangents.map(|t| pick(samples.interpolate(&t), &again.source));
        normals = normals.map(|n| pick(samples.interpolate(&n), &again.source));
        points = again.points;
    }
    let directrix =
        Directrix { points, tangents, normals, offset, vertex_of, reversed: false, direction_decided_by: None };
    Ok((directrix, dropped))
}
