//! Colours of a mesh by a quantity of its result, from blue at the low end of a scale through green to red at the high
//! end.

use super::Error;
use crate::archive::{Attribute, BRIDGES, CONCAVE, Contents, LOWER_BOUND_SLACK, LineSet, Lines, MEAN_CURVATURE};

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
    /// Local convexity of the bridges of strips: 0 at convex bridges and 1 at the others. A triangle has the mean of
    /// its two bridges, so a region between bridges that are not convex is red, as in Wang and Tang's Fig. 11.
    Convexity,
}

/// The quantity by which a file is coloured, and its scale.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Colors {
    pub quantity: Quantity,
    /// Value that is shown in red, in the quantity's unit: finite and above 0. With `None`, the scale follows from the
    /// values.
    pub range: Option<f64>,
}

impl Quantity {
    pub const ALL: [Self; 5] = [Self::MeanCurvature, Self::LowerBoundSlack, Self::Length, Self::Force, Self::Convexity];

    #[must_use]
    pub fn name(self) -> &'static str {
        match self {
            Self::MeanCurvature => MEAN_CURVATURE,
            Self::LowerBoundSlack => LOWER_BOUND_SLACK,
            Self::Length => "length",
            Self::Force => "force",
            Self::Convexity => "convexity",
        }
    }

    /// Returns the name of the attribute that has the values.
    fn attribute(self) -> &'static str {
        if self == Self::Convexity { CONCAVE } else { self.name() }
    }

    #[must_use]
    pub fn from_name(name: &str) -> Option<Self> {
        Self::ALL.into_iter().find(|quantity| quantity.name() == name)
    }

    /// Returns the values of the quantity at the vertices, if the mesh has them.
    pub(super) fn at_vertices(self, contents: &Contents) -> Option<&Attribute> {
        contents.at_vertices(self.attribute())
    }

    /// Returns the values of the quantity for a set of segments, if it has them. Arrows keep their own colour, because
    /// the forces of reactions are of another magnitude than those of cables.
    pub(super) fn along(self, set: &LineSet) -> Option<&Attribute> {
        let is_this = |attribute: &&Attribute| attribute.name == self.attribute();
        set.attributes.iter().find(is_this).filter(|_| matches!(set.lines, Lines::Segments(_)))
    }

    /// Returns the pairs of vertices of the bridges and their values, if the triangles take their colours from bridges.
    fn at_bridges(self, contents: &Contents) -> Option<(&[[u32; 2]], &Attribute)> {
        let bridges = contents.line_sets.iter().find(|set| self == Self::Convexity && set.name == BRIDGES)?;
        let Lines::Segments(pairs) = &bridges.lines else { return None };
        Some((pairs, self.along(bridges)?))
    }

    /// Returns a value for each triangle, if triangles are coloured and not vertices: the mean over the two bridges of
    /// the triangle, and 0 for the triangles of caps, which have no bridges. O(n log n).
    pub(super) fn at_triangles(self, contents: &Contents) -> Option<Vec<f64>> {
        let (pairs, attribute) = self.at_bridges(contents)?;
        let sorted = |[a, b]: [u32; 2]| [a.min(b), a.max(b)];
        let mut bridges: Vec<([u32; 2], f64)> =
            pairs.iter().map(|&pair| sorted(pair)).zip(attribute.values.iter().copied()).collect();
        bridges.sort_unstable_by_key(|&(pair, _)| pair);
        let value = |pair: [u32; 2]| {
            let found = bridges.binary_search_by_key(&sorted(pair), |&(pair, _)| pair);
            found.map_or(0.0, |k| bridges[k].1)
        };
        let of_triangle = |&[a, b, c]: &[u32; 3]| 0.5 * (value([a, b]) + value([b, c]) + value([c, a]));
        Some(contents.mesh.triangles.iter().map(of_triangle).collect())
    }

    /// Returns the values of the quantity at the vertices, for the triangles, and for each line set that has them.
    fn all_in<'a>(self, contents: &'a Contents, line_sets: &'a [LineSet]) -> impl Iterator<Item = &'a Attribute> {
        let on_surface = self.at_vertices(contents).or_else(|| Some(self.at_bridges(contents)?.1));
        on_surface.into_iter().chain(line_sets.iter().filter_map(move |set| self.along(set)))
    }
}

/// Colours in equal steps from low to high, in linear RGB.
pub(super) const STOPS: [[f64; 3]; 5] =
    [[0.0, 0.0, 1.0], [0.0, 1.0, 1.0], [0.0, 1.0, 0.0], [1.0, 1.0, 0.0], [1.0, 0.0, 0.0]];

/// Scale from the values of a quantity to colours.
pub(super) struct Scale {
    pub quantity: Quantity,
    /// Largest value that is shown in blue.
    pub min: f64,
    /// Least value that is shown in red.
    pub max: f64,
    /// Unit of the values. Empty for plain numbers.
    pub unit: String,
}

impl Scale {
    /// Returns the scale of a file with these line sets. Without a range, it covers 0 and the ranges of the quantity in
    /// the file. With a range, it starts at 0.
    ///
    /// # Errors
    /// Returns [`Error::NoQuantity`] if the file does not have the quantity.
    pub fn new(colors: Colors, contents: &Contents, line_sets: &[LineSet]) -> Result<Self, Error> {
        let Colors { quantity, range } = colors;
        let known = || quantity.all_in(contents, line_sets);
        let Some(first) = known().next() else {
            let offered = Quantity::ALL.into_iter().filter(|other| other.all_in(contents, line_sets).next().is_some());
            return Err(Error::NoQuantity { asked: quantity.name(), offered: offered.map(Quantity::name).collect() });
        };
        let (min, max) = match range {
            Some(max) => (0.0, max),
            None => known()
                .fold((0.0, 0.0), |(min, max), attribute| (attribute.range[0].min(min), attribute.range[1].max(max))),
        };
        Ok(Self { quantity, min, max, unit: first.unit.clone() })
    }

    /// Returns the colour of a value. If the scale is empty, the colour is blue.
    pub fn color(&self, value: f64) -> [u8; 4] {
        let steps = (STOPS.len() - 1) as f64;
        let length = self.max - self.min;
        let position = if length > 0.0 { ((value - self.min) / length).clamp(0.0, 1.0) * steps } else { 0.0 };
        let low = (position.floor() as usize).min(STOPS.len() - 2);
        let fraction = position - low as f64;
        let channel = |c: usize| {
            let value = STOPS[low][c] + fraction * (STOPS[low + 1][c] - STOPS[low][c]);
            (255.0 * value).round() as u8
        };
        [channel(0), channel(1), channel(2), 255]
    }
}
