//! The objectives: names, units, sources. Their formulas are in [`weight`](crate::graph::weight).

/// The quantity that a strip minimises (or, for [`MaximalConvexity`](Objective::MaximalConvexity), maximises).
#[derive(Clone, Copy, Debug, Default, PartialEq)]
#[non_exhaustive]
pub enum Objective {
    #[default]
    /// The sum of the areas of the triangles.
    MinimalArea,
    /// The sum of the normal twist over all bridges.
    MinimalTwist,
    /// The number of locally convex bridges, which is maximised. Among strips with the same number the bending energy
    /// over all bridges decides, then the area, so that a plane strip does not fold.
    MaximalConvexity,
    /// The sum of the bending energy over the interior bridges.
    MinimalBendingEnergy,
    /// The sum of the changes of the mean curvature vector from bridge to bridge.
    MinimalMeanCurvatureVariation,
    /// The sum over all bridges of the departure from given surface normals. Needs normals.
    MinimalNormalVariation,
    /// A weighted sum of the additive objectives, solved on the four-layer graph.
    Weighted(Weights),
}

/// Factors of a weighted sum. All are finite and not negative, and at least one is positive.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Weights {
    /// Factor of the area.
    pub area: f64,
    /// Factor of the normal twist.
    pub twist: f64,
    /// Factor of the bending energy.
    pub bending_energy: f64,
    /// Factor of the mean curvature variation.
    pub mean_curvature_variation: f64,
    /// Factor of the normal variation. Needs normals if positive.
    pub normal_variation: f64,
    /// Whether each term is divided by its own optimum on the strip, because the terms have different units.
    pub normalise: bool,
}

impl Default for Weights {
    fn default() -> Self {
        Self {
            area: 0.0,
            twist: 0.0,
            bending_energy: 0.0,
            mean_curvature_variation: 0.0,
            normal_variation: 0.0,
            normalise: true,
        }
    }
}

impl Weights {
    /// Each factor with its objective.
    #[must_use]
    pub fn terms(&self) -> [(Objective, f64); 5] {
        [
            (Objective::MinimalArea, self.area),
            (Objective::MinimalTwist, self.twist),
            (Objective::MinimalBendingEnergy, self.bending_energy),
            (Objective::MinimalMeanCurvatureVariation, self.mean_curvature_variation),
            (Objective::MinimalNormalVariation, self.normal_variation),
        ]
    }
}

/// Objective that decides among the strips with the most convex bridges. It is summed over the bridges that are not
/// convex.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
#[cfg_attr(feature = "serde", derive(serde::Deserialize, serde::Serialize), serde(rename_all = "snake_case"))]
#[cfg_attr(feature = "schema", derive(schemars::JsonSchema), schemars(rename = "SecondaryObjective"))]
pub enum Secondary {
    /// The bending energy at these bridges.
    #[cfg_attr(feature = "serde", serde(rename = "minimal_bending_energy"))]
    BendingEnergy,
    /// The steps of the mean curvature vector that enter these bridges.
    #[cfg_attr(feature = "serde", serde(rename = "minimal_mean_curvature_variation"))]
    MeanCurvatureVariation,
}

impl Secondary {
    /// All secondary objectives.
    pub const ALL: [Self; 2] = [Self::BendingEnergy, Self::MeanCurvatureVariation];

    /// The objective's name, in snake case.
    #[must_use]
    pub fn name(self) -> &'static str {
        match self {
            Self::BendingEnergy => Objective::MinimalBendingEnergy.name(),
            Self::MeanCurvatureVariation => Objective::MinimalMeanCurvatureVariation.name(),
        }
    }
}

impl Objective {
    /// The objectives that have a name of their own, in the order of Wang and Tang's section 3.
    pub const NAMED: [Self; 6] = [
        Self::MinimalArea,
        Self::MinimalTwist,
        Self::MaximalConvexity,
        Self::MinimalBendingEnergy,
        Self::MinimalMeanCurvatureVariation,
        Self::MinimalNormalVariation,
    ];

    /// The objective's name, in snake case; `weighted` for a weighted sum.
    #[must_use]
    pub fn name(&self) -> &'static str {
        match self {
            Self::MinimalArea => "minimal_area",
            Self::MinimalTwist => "minimal_twist",
            Self::MaximalConvexity => "maximal_convexity",
            Self::MinimalBendingEnergy => "minimal_bending_energy",
            Self::MinimalMeanCurvatureVariation => "minimal_mean_curvature_variation",
            Self::MinimalNormalVariation => "minimal_normal_variation",
            Self::Weighted(_) => "weighted",
        }
    }

    /// The minimised quantity, in words for people.
    #[must_use]
    pub fn minimises(&self) -> &'static str {
        match self {
            Self::MinimalArea => "the sum of the triangles' areas",
            Self::MinimalTwist => {
                "the sum over all bridges of 1 - n_p·n_q, the normals at the bridge's ends across its \
                 directrices' tangents"
            }
            Self::MaximalConvexity => "the number of bridges that are not locally convex (it maximises those that are)",
            Self::MinimalBendingEnergy => "the sum over interior bridges of A sin²θ / L², the bending of a thin sheet",
            Self::MinimalMeanCurvatureVariation => {
                "the sum of the changes ‖H_k - H_{k+1}‖ of the mean curvature vector from bridge to bridge"
            }
            Self::MinimalNormalVariation => {
                "the sum over all bridges of (1 - n_p·n̄_p) + (1 - n_q·n̄_q), the departure from given surface normals"
            }
            Self::Weighted(_) => {
                "a weighted sum of the additive objectives, each divided by its own optimum by default"
            }
        }
    }

    /// The unit of its value; `u` is the client's length unit.
    #[must_use]
    pub fn unit(&self) -> &'static str {
        match self {
            Self::MinimalArea => "u²",
            Self::MinimalMeanCurvatureVariation => "u",
            Self::MaximalConvexity => "bridges",
            Self::MinimalTwist | Self::MinimalBendingEnergy | Self::MinimalNormalVariation | Self::Weighted(_) => "1",
        }
    }

    /// The source of the formula in the literature.
    #[must_use]
    pub fn source(&self) -> &'static str {
        match self {
            Self::MinimalArea => "Wang and Tang, section 3.1, definition 3",
            Self::MinimalTwist => "Wang and Tang, section 3.2, eq. 4 and definition 5",
            Self::MaximalConvexity => "Wang and Tang, section 3.2, definition 6 (Frey 2004); q_{j-1} added",
            Self::MinimalBendingEnergy => "Wang and Tang, section 3.3, eq. 6 and 7; monotone beyond 90° by default",
            Self::MinimalMeanCurvatureVariation => {
                "Wang and Tang, section 3.4, eq. 8 to 10; summed over all consecutive bridges as in section 5.2"
            }
            Self::MinimalNormalVariation => "Wang and Tang, section 3.5, eq. 11 and 12; the better of both windings",
            Self::Weighted(_) => "Wang and Tang's objectives on the quadruple-layer graph of section 5.2",
        }
    }
}

/// An objective with its secondary objective.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(crate) struct Goal {
    pub(crate) objective: Objective,
    pub(crate) secondary: Option<Secondary>,
}

impl Goal {
    pub(crate) fn single(objective: Objective) -> Self {
        Self { objective, secondary: None }
    }

    /// The rows of Table 1: every named objective (the normal variation needs normals), then the couplings.
    pub(crate) fn all(normals: bool) -> impl Iterator<Item = Self> {
        let named = Objective::NAMED.into_iter().filter(move |&o| normals || o != Objective::MinimalNormalVariation);
        let coupled =
            Secondary::ALL.map(|secondary| Self { objective: Objective::MaximalConvexity, secondary: Some(secondary) });
        named.map(Self::single).chain(coupled)
    }

    /// Number of nodes for each bridge in the graph of the goal.
    pub(crate) fn layers(&self) -> u64 {
        match (self.objective, self.secondary) {
            (Objective::Weighted(_) | Objective::MinimalMeanCurvatureVariation, _)
            | (_, Some(Secondary::MeanCurvatureVariation)) => 4,
            // Maximal convexity ends its ties by the bending energy.
            (Objective::MinimalBendingEnergy | Objective::MaximalConvexity, _) => 2,
            _ => 1,
        }
    }

    pub(crate) fn windings(&self) -> u64 {
        if self.winding_matters() { 2 } else { 1 }
    }

    pub(crate) fn needs_normals(&self) -> bool {
        self.winding_matters()
    }

    /// Whether the weights of the graph use tangents.
    pub(crate) fn needs_tangents(&self) -> bool {
        match self.objective {
            Objective::MinimalTwist | Objective::MinimalNormalVariation => true,
            Objective::Weighted(weights) => weights.twist > 0.0 || weights.normal_variation > 0.0,
            _ => false,
        }
    }

    /// Whether the value changes if the triangles are wound in the opposite sense.
    pub(crate) fn winding_matters(&self) -> bool {
        match self.objective {
            Objective::MinimalNormalVariation => true,
            Objective::Weighted(weights) => weights.normal_variation > 0.0,
            _ => false,
        }
    }
}
