//! Colours of a mesh by a quantity of its result, from blue at 0 through green to red at the end of a scale.

use super::Error;
use crate::archive::{Contents, LineSet, Lines, SegmentValues};

/// Quantity that a mesh can be coloured by.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Quantity {
    /// Mean curvature at the vertices of minimal surfaces.
    MeanCurvature,
    /// Slack of the proven lower bound of the area, at the vertices of minimal surfaces with a certificate.
    LowerBoundSlack,
    /// Length of the members of uniform meshes.
    Length,
    /// Force of the cables and masts of tensile structures and cable nets.
    Force,
}

/// Colours that were asked for.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Colors {
    pub quantity: Quantity,
    /// Value that is red, in the quantity's unit: finite and above 0. `None` stands for the end of the
    /// scale that follows from the values.
    pub range: Option<f64>,
}

impl Quantity {
    pub const ALL: [Self; 4] = [Self::MeanCurvature, Self::LowerBoundSlack, Self::Length, Self::Force];

    #[must_use]
    pub fn name(self) -> &'static str {
        match self {
            Self::MeanCurvature => "mean_curvature",
            Self::LowerBoundSlack => "lower_bound_slack",
            Self::Length => "length",
            Self::Force => "force",
        }
    }

    #[must_use]
    pub fn from_name(name: &str) -> Option<Self> {
        Self::ALL.into_iter().find(|quantity| quantity.name() == name)
    }

    /// Returns the values at the vertices if the quantity is one of vertices and the mesh has it.
    pub(super) fn at_vertices(self, contents: &Contents) -> Option<&[f64]> {
        match self {
            Self::MeanCurvature => contents.mean_curvature.as_ref().map(|curvature| curvature.values.as_slice()),
            Self::LowerBoundSlack => contents.certificate.as_ref().map(|certificate| certificate.slack.as_slice()),
            Self::Length | Self::Force => None,
        }
    }

    /// Returns the values of a set of segments if they are of this quantity. Arrows keep their own colour, because the
    /// forces of reactions are of another magnitude than those of cables.
    pub(super) fn along(self, set: &LineSet) -> Option<&SegmentValues> {
        match &set.lines {
            Lines::Segments { values: Some(values), .. } if values.name == self.name() => Some(values),
            _ => None,
        }
    }

    fn is_in(self, contents: &Contents, line_sets: &[LineSet]) -> bool {
        self.at_vertices(contents).is_some() || line_sets.iter().any(|set| self.along(set).is_some())
    }
}

/// Colours in equal steps from low to high, in linear RGB.
pub(super) const STOPS: [[f64; 3]; 5] =
    [[0.0, 0.0, 1.0], [0.0, 1.0, 1.0], [0.0, 1.0, 0.0], [1.0, 1.0, 0.0], [1.0, 0.0, 0.0]];

/// Scale from the values of a quantity to colours.
pub(super) struct Scale {
    pub quantity: Quantity,
    /// Value that is red. Zero and smaller values are blue.
    pub max: f64,
    /// Unit of the values. Empty for plain numbers.
    pub unit: String,
}

/// Share of the vertices that are within the scale of the mean curvature, so that the few largest values, at the corners
/// of the boundary, do not decide about the colours of all others.
const WITHIN_SCALE: f64 = 0.95;

impl Scale {
    /// Returns the scale of a file with these line sets. Without a range, it ends at the 95th percentile of the mean
    /// curvature but not below its least range, at 1 for the slack, and at the largest length or force.
    ///
    /// # Errors
    /// Returns [`Error::NoQuantity`] if the file does not have the quantity.
    pub fn new(colors: Colors, contents: &Contents, line_sets: &[LineSet]) -> Result<Self, Error> {
        let Colors { quantity, range } = colors;
        if !quantity.is_in(contents, line_sets) {
            let offered = Quantity::ALL.into_iter().filter(|quantity| quantity.is_in(contents, line_sets));
            return Err(Error::NoQuantity { asked: quantity.name(), offered: offered.map(Quantity::name).collect() });
        }
        let along = || line_sets.iter().filter_map(|set| quantity.along(set));
        let largest = || along().flat_map(|values| &values.values).copied().fold(0.0, f64::max);
        let max = range.unwrap_or_else(|| match (&contents.mean_curvature, quantity) {
            (Some(curvature), Quantity::MeanCurvature) => {
                percentile(&curvature.values, WITHIN_SCALE).max(curvature.least_range)
            }
            (_, Quantity::LowerBoundSlack) => 1.0,
            _ => largest(),
        });
        let unit = match quantity {
            Quantity::MeanCurvature => format!("1/{}", contents.unit.symbol()),
            _ => along().next().map(|values| values.unit.clone()).unwrap_or_default(),
        };
        Ok(Self { quantity, max, unit })
    }

    /// Returns the colour of a value. If the scale is empty, the colour is blue.
    pub fn color(&self, value: f64) -> [u8; 4] {
        let steps = (STOPS.len() - 1) as f64;
        let position = if self.max > 0.0 { (value / self.max).clamp(0.0, 1.0) * steps } else { 0.0 };
        let low = (position.floor() as usize).min(STOPS.len() - 2);
        let fraction = position - low as f64;
        let channel = |c: usize| {
            let value = STOPS[low][c] + fraction * (STOPS[low + 1][c] - STOPS[low][c]);
            (255.0 * value).round() as u8
        };
        [channel(0), channel(1), channel(2), 255]
    }
}

/// Returns the smallest of the values that at least this share of them does not exceed, or 0 without values.
fn percentile(values: &[f64], share: f64) -> f64 {
    let mut sorted = values.to_vec();
    sorted.sort_unstable_by(f64::total_cmp);
    let rank = (share * sorted.len() as f64).ceil() as usize;
    sorted.get(rank.saturating_sub(1)).copied().unwrap_or(0.0)
}

#[cfg(test)]
mod tests {
    use super::percentile;

    #[test]
    fn the_percentile_is_a_value_that_the_share_does_not_exceed() {
        let values: Vec<f64> = (1..=100).rev().map(f64::from).collect();
        assert_eq!(percentile(&values, 0.95), 95.0);
        assert_eq!(percentile(&[3.0], 0.95), 3.0);
        assert_eq!(percentile(&[], 0.95), 0.0);
    }
}
