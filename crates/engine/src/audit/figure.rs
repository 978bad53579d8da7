//! Measured figures, each with the range of stated values that agree with it.

/// Relative error that a stated sum may have, as a fraction of the sum of the magnitudes of its terms.
pub(crate) const RELATIVE: f64 = 1e-9;

/// A measured figure. Every stated value from `low` to `high` agrees with it.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(crate) struct Measured {
    pub value: f64,
    pub low: f64,
    pub high: f64,
}

impl Measured {
    #[must_use]
    pub fn within(value: f64, tolerance: f64) -> Self {
        Self { value, low: value - tolerance, high: value + tolerance }
    }

    /// Returns a count with its range: from the number of items that certainly count to the number that counts if
    /// rounding favours them.
    #[must_use]
    pub fn count([certain, possible]: [usize; 2]) -> Self {
        Self { value: certain as f64, low: certain as f64, high: possible as f64 }
    }

    #[must_use]
    pub fn times(self, factor: f64) -> Self {
        Self { value: self.value * factor, low: self.low * factor, high: self.high * factor }
    }

    #[must_use]
    pub fn plus(self, other: Self) -> Self {
        Self { value: self.value + other.value, low: self.low + other.low, high: self.high + other.high }
    }

    /// Returns the figure with a range that is wider by `tolerance` on both sides.
    #[must_use]
    pub fn widened(self, tolerance: f64) -> Self {
        Self { value: self.value, low: self.low - tolerance, high: self.high + tolerance }
    }

    #[must_use]
    pub fn agrees_with(self, stated: f64) -> bool {
        self.low <= stated && stated <= self.high
    }
}

/// A sum whose tolerance grows with the magnitudes of its terms and with their sensitivity to rounded coordinates.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub(crate) struct Sum {
    pub value: f64,
    magnitude: f64,
    rounding: f64,
}

impl Sum {
    /// Adds a term that rounding of the coordinates changes by at most `rounding`.
    pub fn add(&mut self, term: f64, rounding: f64) {
        self.value += term;
        self.magnitude += term.abs();
        self.rounding += rounding;
    }

    pub fn add_sum(&mut self, other: Self) {
        self.value += other.value;
        self.magnitude += other.magnitude;
        self.rounding += other.rounding;
    }

    #[must_use]
    pub fn measured(self) -> Measured {
        Measured::within(self.value, RELATIVE * self.magnitude + self.rounding)
    }
}

/// The least of some values, each with its own tolerance. The range contains every least value that the tolerances
/// allow. A value that rounding cannot make the least does not widen the range.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(crate) struct Least(Option<Measured>);

impl Least {
    pub const NONE: Self = Self(None);

    pub fn add(&mut self, value: f64, tolerance: f64) {
        let new = Measured::within(value, tolerance);
        self.0 = Some(self.0.map_or(new, |old| Measured {
            value: old.value.min(new.value),
            low: old.low.min(new.low),
            high: old.high.min(new.high),
        }));
    }

    /// Returns the least value, or 0 without values.
    #[must_use]
    pub fn measured(self) -> Measured {
        self.0.unwrap_or(Measured::within(0.0, 0.0))
    }
}

/// The counterpart of [`Least`] for the largest value.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(crate) struct Largest(Least);

impl Largest {
    pub const NONE: Self = Self(Least::NONE);

    pub fn add(&mut self, value: f64, tolerance: f64) {
        self.0.add(-value, tolerance);
    }

    /// Returns the largest value, or 0 without values.
    #[must_use]
    pub fn measured(self) -> Measured {
        let Measured { value, low, high } = self.0.measured();
        Measured { value: 0.0 - value, low: 0.0 - high, high: 0.0 - low }
    }
}

/// Count, least, largest, mean and standard deviation of values that all have the same tolerance.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(crate) struct Spread {
    pub count: usize,
    pub min: Measured,
    pub mean: Measured,
    pub max: Measured,
    pub std_dev: Measured,
}

impl Spread {
    #[must_use]
    pub fn of(values: &[f64], tolerance: f64) -> Self {
        let count = values.len();
        if count == 0 {
            let zero = Measured::within(0.0, 0.0);
            return Self { count, min: zero, mean: zero, max: zero, std_dev: zero };
        }
        let mean = values.iter().sum::<f64>() / count as f64;
        let variance = values.iter().map(|value| (value - mean) * (value - mean)).sum::<f64>() / count as f64;
        let (min, max) = values
            .iter()
            .fold((f64::INFINITY, f64::NEG_INFINITY), |(min, max), &v| (f64::min(min, v), f64::max(max, v)));
        let tolerance = RELATIVE * max.abs().max(min.abs()) + tolerance;
        let within = |value| Measured::within(value, tolerance);
        Self { count, min: within(min), mean: within(mean), max: within(max), std_dev: within(variance.sqrt()) }
    }
}
