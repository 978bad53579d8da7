//! The arguments of a solve: the domain, the objective and the options.

use super::surface::nurbs::Nurbs;
use plateau_mesh::DVec3;

/// The region or surface to mesh.
#[derive(Clone, Debug, PartialEq)]
pub enum Domain {
    /// A planar polygon in space with holes. Loops may run in either direction and must not repeat their first point.
    /// Points stay exactly where they are given if they lie in the plane of `outer` up to rounding. If they are farther
    /// off the plane, but by at most a thousandth of the polygon's size (twice the largest distance of the points of
    /// `outer` from their mean), they are projected onto the plane, with the warning `projected`. The mesh faces the
    /// side from which `outer` runs counter-clockwise.
    Polygon {
        /// The outer boundary.
        outer: Vec<DVec3>,
        /// The boundaries of the holes.
        holes: Vec<Vec<DVec3>>,
    },
    /// A tensor-product Bézier patch. The triangles of its mesh face the direction u × v.
    Bezier {
        /// `control_points[i][j]`: i counts along u, j along v.
        control_points: Vec<Vec<DVec3>>,
    },
    /// An untrimmed NURBS patch.
    Nurbs(Nurbs),
    /// The minimal surface that spans these closed polygons. See [`plateau_minimal_surface`].
    Boundaries(Vec<Vec<DVec3>>),
}

/// Quantity that is optimised.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
#[cfg_attr(feature = "serde", derive(serde::Deserialize, serde::Serialize), serde(rename_all = "snake_case"))]
#[cfg_attr(feature = "schema", derive(schemars::JsonSchema), schemars(rename = "UniformMeshObjective"))]
pub enum Objective {
    /// Problem 1 of the paper: as few nodes as possible, every edge in [ℓ, 2ℓ].
    FewestNodes,
    /// Problem 2 of the paper: as many edges of length ℓ as possible, every other edge in [ℓ, 2ℓ].
    #[default]
    MostEqualEdges,
}

impl Objective {
    /// Every objective, in the order in which they are listed to users.
    pub const ALL: [Self; 2] = [Self::FewestNodes, Self::MostEqualEdges];

    /// The name in requests.
    #[must_use]
    pub fn name(self) -> &'static str {
        match self {
            Self::FewestNodes => "fewest_nodes",
            Self::MostEqualEdges => "most_equal_edges",
        }
    }

    /// The quantity that is minimised or maximised, and the meaning of `objective_value`.
    #[must_use]
    pub fn description(self) -> &'static str {
        match self {
            Self::FewestNodes => {
                "The number of nodes, every edge between ℓ and 2ℓ: farthest-point insertion, at most 16/3 of the \
                 optimum. The objective value is the number of nodes."
            }
            Self::MostEqualEdges => {
                "The number of edges of length ℓ, every other edge between ℓ and 2ℓ: an equilateral lattice where it \
                 fits best, farthest-point insertion with visibility in the rim. The objective value is the number of \
                 lattice edges."
            }
        }
    }

    /// The unit of the objective's value.
    #[must_use]
    pub fn unit(self) -> &'static str {
        "1"
    }

    /// The source of the formula in the literature.
    #[must_use]
    pub fn source(self) -> &'static str {
        match self {
            Self::FewestNodes => "Katoh, Ohsaki, Xu, section 2, problem 1",
            Self::MostEqualEdges => "Katoh, Ohsaki, Xu, section 3, problem 2",
        }
    }
}

/// How the nodes of a curved surface move after meshing.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub enum Optimise {
    /// The nodes stay where the mesh generator puts them.
    None,
    /// The inner nodes move on the surface so that Σ (L - ℓ)² over the lattice group becomes minimal. The transition
    /// zone between lattice and boundary is then rebuilt, unless it is [`Transition::Free`]. On a planar polygon the
    /// sum is already 0.
    #[default]
    Nodes,
    /// First does the same as [`Optimise::Nodes`]. Then, on polygons too, the inner nodes move until few different
    /// lengths suffice for all members. See [`UniformMesh::shared_lengths`](super::UniformMesh::shared_lengths).
    Lengths {
        /// Largest number of different lengths. Each member should be within half the length tolerance of one of them.
        /// If the search cannot reach that, the members are as near as it found.
        most: usize,
    },
}

/// Lengths that members outside the lattice group may take while the nodes move.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
#[cfg_attr(feature = "serde", derive(serde::Deserialize, serde::Serialize), serde(rename_all = "snake_case"))]
#[cfg_attr(feature = "schema", derive(schemars::JsonSchema), schemars(rename = "Rim"))]
pub enum Transition {
    /// The lengths stay in [ℓ, 2ℓ] wherever that is possible.
    #[default]
    Bounded,
    /// The members may take any length, as in the paper.
    Free,
}

/// The options of a solve.
#[derive(Clone, Debug, PartialEq)]
pub struct Options {
    /// The target edge length ℓ, in the caller's unit.
    pub edge_length: f64,
    /// The quantity that is minimised or maximised.
    pub objective: Objective,
    /// Lengths count as equal if they differ by no more than this, in the caller's unit. `None` stands for ℓ/1000.
    pub length_tolerance: Option<f64>,
    /// How the nodes move after meshing. On polygons only [`Optimise::Lengths`] moves nodes, because the lattice
    /// members already have the length ℓ.
    pub optimise: Optimise,
    /// The lengths that members outside the lattice group may take.
    pub transition: Transition,
    /// Number of rectangles of the auxiliary triangulation of a patch, along u and along v. 2 to 400 each.
    pub auxiliary_grid: [u32; 2],
}

impl Options {
    /// The default options for an edge length and an objective.
    #[must_use]
    pub fn new(edge_length: f64, objective: Objective) -> Self {
        Self {
            edge_length,
            objective,
            length_tolerance: None,
            optimise: Optimise::default(),
            transition: Transition::default(),
            auxiliary_grid: [15, 15],
        }
    }

    /// The given length tolerance, or its default.
    pub(super) fn tolerance(&self) -> f64 {
        self.length_tolerance.unwrap_or(self.edge_length / 1000.0)
    }
}
