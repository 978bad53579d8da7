//! Errors, and the places in the input that caused them.

use crate::codes::{Reason, WarningCode};
use crate::execution::Interruption;
use std::fmt;

/// A step of a [`Place`]: the name of a field or an index into a list.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Step {
    /// The field of this name.
    Field(&'static str),
    /// The entry of this number, from 0.
    Index(usize),
}

/// The place of a value in the input of a solver, for example `boundaries`, 0, 17.
///
/// Fields have the names of the solver's arguments and options. A caller translates a place to the names of its own
/// input.
#[derive(Clone, Debug, Default, PartialEq, Eq)]
pub struct Place(pub Vec<Step>);

impl Place {
    /// The field of this name.
    #[must_use]
    pub fn field(name: &'static str) -> Self {
        Self(vec![Step::Field(name)])
    }
    /// This place extended by an index.
    #[must_use]
    pub fn at(mut self, index: usize) -> Self {
        self.0.push(Step::Index(index));
        self
    }
    /// This place extended by a field.
    #[must_use]
    pub fn then(mut self, name: &'static str) -> Self {
        self.0.push(Step::Field(name));
        self
    }
}

impl fmt::Display for Place {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        for step in &self.0 {
            match step {
                Step::Field(name) => write!(f, "/{name}")?,
                Step::Index(index) => write!(f, "/{index}")?,
            }
        }
        Ok(())
    }
}

/// An input value that the solver cannot work with, and the reason. The value itself is not repeated.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct InputError {
    /// The place of the value.
    pub place: Place,
    /// Description of the fault.
    pub detail: String,
}

/// Largest number of errors that a check collects. Callers show at most 50, and a request may have a fault in each of a
/// million values, whose errors would take many times the memory of the request.
pub const MOST_ERRORS: usize = 51;

impl InputError {
    /// Adds this error to others, unless there are [`MOST_ERRORS`] already.
    pub fn add_to(self, errors: &mut Vec<Self>) {
        if errors.len() < MOST_ERRORS {
            errors.push(self);
        }
    }
    /// An error about the value at a place.
    pub fn new(place: Place, detail: impl Into<String>) -> Self {
        Self { place, detail: detail.into() }
    }
}

/// Why a solver returned no mesh.
#[derive(Clone, Debug, PartialEq, Eq)]
pub enum Error {
    /// The input does not meet the requirements in the documentation of the solver. The fault is found before the work
    /// starts wherever possible.
    Input(Vec<InputError>),
    /// The input is well formed, but no valid mesh could be made.
    NoResult {
        /// The reason.
        reason: Reason,
        /// Description of the fault in the geometry, and what to try.
        detail: String,
        /// The input values that caused the failure, if they are known.
        places: Vec<InputError>,
    },
    /// The caller asked to stop, or its deadline passed before there was a valid mesh.
    Interrupted(Interruption),
}

impl Error {
    /// An [`Error::Input`] about one value.
    pub fn input(place: Place, detail: impl Into<String>) -> Self {
        Self::Input(vec![InputError::new(place, detail)])
    }
    /// An [`Error::NoResult`] without places.
    pub fn no_result(reason: Reason, detail: impl Into<String>) -> Self {
        Self::NoResult { reason, detail: detail.into(), places: Vec::new() }
    }
}

impl From<Interruption> for Error {
    fn from(interruption: Interruption) -> Self {
        Self::Interrupted(interruption)
    }
}

impl fmt::Display for Error {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            Self::Input(errors) => {
                for (k, error) in errors.iter().enumerate() {
                    let separator = if k == 0 { "" } else { "; " };
                    write!(f, "{separator}{}: {}", error.place, error.detail)?;
                }
                Ok(())
            }
            Self::NoResult { reason, detail, .. } => write!(f, "{reason}: {detail}"),
            Self::Interrupted(Interruption::Cancelled) => f.write_str("cancelled"),
            Self::Interrupted(Interruption::DeadlinePassed) => f.write_str("the deadline passed"),
        }
    }
}

impl std::error::Error for Error {}

/// A fact about the input or the result that the caller should know although the solve succeeded.
#[derive(Clone, Debug, PartialEq)]
pub struct Warning {
    /// The code of the fact, for programs to read.
    pub code: WarningCode,
    /// Description of the fact, for people to read.
    pub detail: String,
    /// Figures of the description, by name. All are finite. Indices count from 0, and lengths are in the unit of the
    /// coordinates.
    pub values: Vec<(&'static str, f64)>,
}

impl Warning {
    /// A warning of this code.
    pub fn new(code: WarningCode, detail: impl Into<String>) -> Self {
        Self { code, detail: detail.into(), values: Vec::new() }
    }

    /// Adds a figure. A figure that is not finite is left out, because JSON cannot hold it.
    #[must_use]
    pub fn with(mut self, name: &'static str, value: f64) -> Self {
        if value.is_finite() {
            self.values.push((name, value));
        }
        self
    }

    /// Adds a count or an index.
    #[must_use]
    pub fn with_count(self, name: &'static str, count: usize) -> Self {
        self.with(name, count as f64)
    }

    /// Adds the coordinates `x`, `y` and `z` of a place.
    #[must_use]
    pub fn with_place(self, [x, y, z]: [f64; 3]) -> Self {
        self.with("x", x).with("y", y).with("z", z)
    }

    /// The warning that `count` points were merged with their neighbours. If the input has several directrices,
    /// `directrix` is the number of the directrix with these points.
    pub fn merged_points(count: usize, directrix: Option<usize>) -> Self {
        let place = directrix.map_or(String::new(), |k| format!("directrix {k}: "));
        let merged = if count == 1 {
            "1 point was merged with its neighbour, because the two are equal or nearly equal".to_owned()
        } else {
            format!("{count} points were merged with their neighbours, because they are equal or nearly equal")
        };
        let warning = Self::new(WarningCode::MergedPoints, place + &merged).with_count("count", count);
        directrix.into_iter().fold(warning, |warning, k| warning.with_count("directrix", k))
    }

    /// The warning that points were projected onto their plane. `what` names the points, and `distance` is the largest
    /// distance by which a point was moved.
    pub fn projected(what: &str, distance: f64) -> Self {
        let detail = format!(
            "{what} is not quite plane and was projected onto its plane: points were moved by up to {distance:.6e}, in \
             the unit of the coordinates"
        );
        Self::new(WarningCode::Projected, detail).with("distance", distance)
    }
}
