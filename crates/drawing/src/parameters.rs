//! Parameters of queries, as text, with errors that name them.

use std::fmt;

/// A parameter of a query that is refused.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct ParameterError {
    /// Name of the parameter.
    pub parameter: String,
    /// What is wrong, and what is allowed.
    pub detail: String,
}

impl ParameterError {
    pub(crate) fn new(parameter: &str, detail: impl Into<String>) -> Self {
        Self { parameter: parameter.into(), detail: detail.into() }
    }
}

/// Reason why a file is not made.
#[derive(Clone, Debug, PartialEq, Eq)]
pub enum Refused {
    /// A value is wrong in itself.
    BadQuery(Vec<ParameterError>),
    /// A value does not suit this result.
    Unsuitable(Vec<ParameterError>),
    /// The result has no flat pattern.
    NoPattern,
    /// The result has no such schedule. The names are those of the schedules that it has.
    NoPart(Vec<&'static str>),
    /// The file would exceed what its format can hold.
    TooLarge(&'static str),
}

impl Refused {
    pub(crate) fn unsuitable(parameter: &str, detail: impl Into<String>) -> Self {
        Self::Unsuitable(vec![ParameterError::new(parameter, detail)])
    }
}

impl fmt::Display for Refused {
    fn fmt(&self, formatter: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            Self::BadQuery(errors) | Self::Unsuitable(errors) => {
                let text: Vec<String> =
                    errors.iter().map(|error| format!("{}: {}", error.parameter, error.detail)).collect();
                formatter.write_str(&text.join("; "))
            }
            Self::NoPattern => formatter.write_str("only ruled surfaces have a flat pattern"),
            Self::NoPart(parts) if parts.is_empty() => formatter.write_str("this result has no schedules"),
            Self::NoPart(parts) => write!(formatter, "this result has the parts {}", parts.join(", ")),
            Self::TooLarge(format) => write!(formatter, "the file is too large for {format}"),
        }
    }
}

/// Values of a query, each taken by its reader once. What is left at the end is unknown.
#[derive(Debug)]
pub(crate) struct Values<'a> {
    given: &'a [(String, String)],
    known: Vec<&'static str>,
    errors: Vec<ParameterError>,
}

impl<'a> Values<'a> {
    pub(crate) fn new(given: &'a [(String, String)]) -> Self {
        Self { given, known: Vec::new(), errors: Vec::new() }
    }

    pub(crate) fn refuse(&mut self, parameter: &str, detail: impl Into<String>) {
        self.errors.push(ParameterError::new(parameter, detail));
    }

    pub(crate) fn text(&mut self, name: &'static str) -> Option<&'a str> {
        self.known.push(name);
        let mut values = self.given.iter().filter(|(given, _)| given == name).map(|(_, value)| value.as_str());
        let first = values.next();
        if values.next().is_some() {
            self.refuse(name, "is given twice");
        }
        first
    }

    /// Whether a parameter was not given.
    pub(crate) fn is_missing(&self, name: &str) -> bool {
        self.given.iter().all(|(given, _)| given != name)
    }

    pub(crate) fn number(&mut self, name: &'static str, range: std::ops::RangeInclusive<f64>) -> Option<f64> {
        let text = self.text(name)?;
        match text.parse::<f64>() {
            Ok(number) if range.contains(&number) => Some(number),
            _ => {
                self.refuse(name, format!("must be a number from {} to {}", range.start(), range.end()));
                None
            }
        }
    }

    pub(crate) fn choice<T: Copy>(&mut self, name: &'static str, choices: &[(&str, T)]) -> Option<T> {
        let text = self.text(name)?;
        let found = choices.iter().find(|(choice, _)| *choice == text).map(|(_, value)| *value);
        if found.is_none() {
            let names: Vec<&str> = choices.iter().map(|(choice, _)| *choice).collect();
            self.refuse(name, format!("must be one of {}", names.join(", ")));
        }
        found
    }

    /// Returns all errors, or nothing if every given parameter was read and is right.
    pub(crate) fn end(mut self) -> Result<(), Refused> {
        for (name, _) in self.given {
            if !self.known.contains(&name.as_str()) {
                self.errors.push(ParameterError::new(name, format!("known parameters are: {}", self.known.join(", "))));
            }
        }
        if self.errors.is_empty() { Ok(()) } else { Err(Refused::BadQuery(self.errors)) }
    }
}
