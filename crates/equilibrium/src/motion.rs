//! The equations of equilibrium of a body.

use super::body::Body;
use super::constraint::{ConstraintState, Determined, least_squares_multipliers};
use super::freedom::Freedom;
use super::newton::{Equations, State};
use super::residual::residual;
use glam::DMat3;
use plateau_mesh::sparse::SymmetricMatrix;
use plateau_mesh::sparse::pattern::BlockPattern;
use plateau_mesh::{DVec3, measure};
use std::ops::Range;

/// The equations of a body. Each vertex has one unknown for each independent direction in which it may move. The
/// vertices of a group move together and share one unknown.
#[derive(Debug)]
pub struct Motion<'a> {
    body: &'a Body,
    /// For each vertex the vertex whose unknowns it shares: itself, or the first vertex of its group.
    owner: Vec<u32>,
    pattern: BlockPattern,
    radius: f64,
}

/// The directions of all unknowns, vertex by vertex, with the force and the share of each vertex.
#[derive(Clone, Debug)]
pub struct Frame {
    pub directions: Vec<DVec3>,
    /// The gradient of the Lagrangian by the position of each vertex.
    pub gradient: Vec<DVec3>,
    /// For each vertex, the share of tension times size by which its force is divided in the
    /// [`residual`](super::residual).
    pub shares: Vec<f64>,
}

impl<'a> Motion<'a> {
    /// Sets up the equations of `body`, which must have passed [`Body::check`].
    pub fn new(body: &'a Body) -> Self {
        let mut first_of = vec![None; body.groups.len()];
        let owner_of = |(v, freedom): (usize, &Freedom)| match *freedom {
            Freedom::Together(group) => *first_of[group as usize].get_or_insert(v as u32),
            _ => v as u32,
        };
        let owner: Vec<u32> = body.freedoms.iter().enumerate().map(owner_of).collect();
        let count = |v: usize| if owner[v] as usize == v { body.unknowns(v) } else { 0 };
        let counts: Vec<u8> = (0..body.vertices.len()).map(count).collect();
        let pattern = BlockPattern::new(&counts, |couple| {
            let mut owners = Vec::new();
            let mut visit = |element: &[u32]| {
                owners.clear();
                owners.extend(element.iter().map(|&v| owner[v as usize]));
                couple(&owners);
            };
            body.quantities().for_each(|term| term.visit_elements(&mut visit));
        });
        Self { body, owner, pattern, radius: body.radius() }
    }

    /// The range of the unknowns of a vertex. All vertices of a group share the same range.
    fn unknowns(&self, v: u32) -> Range<usize> {
        self.pattern.unknowns(self.owner[v as usize])
    }

    fn directions(&self, vertices: &[DVec3]) -> Vec<DVec3> {
        let body = self.body;
        let normals = measure::normals(vertices, &body.triangles);
        let mut directions = Vec::with_capacity(self.pattern.order());
        for (v, freedom) in body.freedoms.iter().enumerate() {
            match *freedom {
                Freedom::Fixed => {}
                Freedom::Together(group) if self.owner[v] as usize == v => directions.push(body.groups[group as usize]),
                Freedom::Together(_) => {}
                Freedom::Normal => directions.push(normals[v]),
                Freedom::Across([a, b]) => {
                    let tangent = (vertices[b as usize] - vertices[a as usize]).normalize_or(DVec3::X);
                    directions.extend(<[DVec3; 2]>::from(tangent.any_orthonormal_pair()));
                }
                Freedom::On(support) => {
                    let support = &body.supports[support as usize];
                    directions.extend(&support.tangents(vertices[v])[..usize::from(support.dimension())]);
                }
                Freedom::AcrossOn { support, beside: [a, b] } => {
                    let [u, w] = body.supports[support as usize].tangents(vertices[v]);
                    let edge = vertices[b as usize] - vertices[a as usize];
                    directions.push((edge.dot(w) * u - edge.dot(u) * w).normalize_or(u));
                }
                Freedom::Free => directions.extend(DVec3::AXES),
            }
        }
        directions
    }

    /// Projects one vector per vertex on the directions of the unknowns. Returns one number per unknown; for the
    /// unknown of a group it is the sum over the vertices of the group.
    fn components(&self, directions: &[DVec3], vectors: &[DVec3]) -> Vec<f64> {
        let mut components = vec![0.0; directions.len()];
        for (v, vector) in vectors.iter().enumerate() {
            self.unknowns(v as u32).for_each(|k| components[k] += vector.dot(directions[k]));
        }
        components
    }

    /// Returns the displacement of each vertex in `motion`, which has one number per unknown. The displacements are
    /// scaled so that the largest has length 1.
    pub fn displacements(&self, state: &State<Frame>, motion: &[f64]) -> Vec<DVec3> {
        let of = |v: usize| self.unknowns(v as u32).map(|k| motion[k] * state.frame.directions[k]).sum();
        let moved: Vec<DVec3> = (0..self.body.vertices.len()).map(of).collect();
        let largest = moved.iter().map(|d| d.length()).fold(f64::MIN_POSITIVE, f64::max);
        moved.into_iter().map(|d| d / largest).collect()
    }

    /// Lists, for each vertex that can move, its number, the length of the gradient's part along its directions, and
    /// its share. The residual is computed from the length and the share.
    pub fn unbalanced_forces<'s>(&'s self, state: &'s State<Frame>) -> impl Iterator<Item = (usize, f64, f64)> + 's {
        // The unknowns of a group belong to its first vertex, whose share is that of the whole group.
        let free = (0..state.frame.shares.len()).filter(|&v| !self.pattern.unknowns(v as u32).is_empty());
        free.map(|v| {
            let along = &state.gradient[self.pattern.unknowns(v as u32)];
            (v, along.iter().map(|g| g * g).sum::<f64>().sqrt(), state.frame.shares[v])
        })
    }

    fn shares(&self, vertices: &[DVec3]) -> (Vec<f64>, Vec<f64>) {
        let mut shares = vec![0.0; vertices.len()];
        self.body.terms.iter().for_each(|term| term.add_shares(vertices, &mut shares));
        let mut curve = vec![0.0; vertices.len()];
        for &([a, b], tension) in &self.body.curves {
            let half = 0.5 * tension * vertices[a as usize].distance(vertices[b as usize]);
            curve[a as usize] += half;
            curve[b as usize] += half;
        }
        let scale = |(share, curve): (&f64, &f64)| share.max(0.5 * self.radius * curve);
        let mut scales: Vec<f64> = shares.iter().zip(&curve).map(scale).collect();
        for (v, &owner) in self.owner.iter().enumerate() {
            if owner as usize != v {
                scales[owner as usize] += scales[v];
            }
        }
        (shares, scales)
    }
}

impl Equations for Motion<'_> {
    type Frame = Frame;

    const LOWEST_MODE_HAS_ONE_SIGN: bool = false;

    fn state(&self, vertices: &[DVec3]) -> State<Frame> {
        let body = self.body;
        let directions = self.directions(vertices);
        let mut gradient = vec![DVec3::ZERO; vertices.len()];
        body.terms.iter().for_each(|term| term.add_gradient(vertices, &mut gradient));
        let (own_shares, shares) = self.shares(vertices);
        let mut mass = vec![0.0; directions.len()];
        for (v, &share) in own_shares.iter().enumerate() {
            self.unknowns(v as u32).for_each(|k| mass[k] += share);
        }
        let mut along = self.components(&directions, &gradient);
        let quantities: Vec<Vec<DVec3>> = body
            .constraints
            .iter()
            .map(|constraint| {
                let mut gradient = vec![DVec3::ZERO; vertices.len()];
                constraint.quantity.add_gradient(vertices, &mut gradient);
                gradient
            })
            .collect();
        let borders: Vec<Vec<f64>> = quantities.iter().map(|gradient| self.components(&directions, gradient)).collect();
        let multipliers = least_squares_multipliers(&along, &borders, &mass);
        for ((border, quantity), multiplier) in borders.iter().zip(&quantities).zip(&multipliers) {
            along.iter_mut().zip(border).for_each(|(along, border)| *along -= multiplier * border);
            gradient.iter_mut().zip(quantity).for_each(|(gradient, quantity)| *gradient -= multiplier * *quantity);
        }
        let mut constraints: Vec<ConstraintState> = body
            .constraints
            .iter()
            .zip(borders)
            .zip(multipliers)
            .map(|((constraint, gradient), multiplier)| {
                let excess = |target: f64| constraint.quantity.value(vertices) - target;
                let mut yields = 0.0;
                let (excess, scale, condition) = match &constraint.by {
                    Determined::Value(target) => (excess(*target), target.abs(), None),
                    Determined::Yielding { value, compliance } => {
                        yields = *compliance;
                        (excess(*value) + compliance * multiplier, value.abs(), None)
                    }
                    Determined::Condition(condition) => {
                        let (value, by_multiplier) = condition.value(vertices, multiplier);
                        let mut by_positions = vec![DVec3::ZERO; vertices.len()];
                        condition.add_gradient(vertices, multiplier, &mut by_positions);
                        let by_unknowns = self.components(&directions, &by_positions);
                        (value, condition.scale(vertices), Some((by_unknowns, by_multiplier)))
                    }
                };
                ConstraintState { excess, scale, multiplier, gradient, condition, compliance: yields }
            })
            .collect();
        for term in &body.terms {
            term.visit_rank_one_parts(vertices, &mut |stiffness, gradient| {
                let gradient = self.components(&directions, gradient);
                constraints.push(ConstraintState::rank_one_part(stiffness, gradient));
            });
        }
        let yielding: f64 = constraints.iter().map(|c| 0.5 * c.compliance * c.multiplier * c.multiplier).sum();
        let values: Vec<f64> = body.terms.iter().map(|term| term.value(vertices)).collect();
        let energy = values.iter().sum::<f64>() + yielding;
        let magnitude = values.iter().map(|value| value.abs()).sum::<f64>() + yielding.abs();
        let frame = Frame { directions, gradient, shares };
        let mut state = State { frame, energy, magnitude, gradient: along, mass, residual: 0.0, constraints };
        let unmet = state.constraints.iter().map(|c| c.excess.abs() / c.scale).fold(0.0, f64::max);
        state.residual =
            residual(self.unbalanced_forces(&state).map(|(_, force, share)| (force, share)), self.radius).max(unmet);
        state
    }

    fn second_variation(&self, vertices: &[DVec3], state: &State<Frame>, shift: f64, matrix: &mut SymmetricMatrix) {
        let Frame { directions, gradient, .. } = &state.frame;
        matrix.values.fill(0.0);
        let values = &mut matrix.values;
        let mut add = |factor: f64, v: u32, w: u32, block: DMat3| {
            let Some(position) = self.pattern.position(self.owner[v as usize], self.owner[w as usize]) else { return };
            let (own, other) = (&directions[self.unknowns(v)], &directions[self.unknowns(w)]);
            for (j, &towards) in other.iter().enumerate() {
                let force = block * towards;
                for (i, direction) in own.iter().enumerate() {
                    values[position.at(i, j)] += factor * direction.dot(force);
                }
            }
        };
        for term in &self.body.terms {
            term.add_second_derivative(vertices, shift, &mut |v, w, block| add(1.0, v, w, block));
        }
        for (constraint, state) in self.body.constraints.iter().zip(&state.constraints) {
            let quantity = &constraint.quantity;
            quantity.add_second_derivative(vertices, 0.0, &mut |v, w, block| add(-state.multiplier, v, w, block));
        }
        for (v, freedom) in self.body.freedoms.iter().enumerate() {
            let Some(support) = freedom.support() else { continue };
            let Some(position) = self.pattern.position(v as u32, v as u32) else { continue };
            let support = &self.body.supports[support as usize];
            let tangents = &directions[self.pattern.unknowns(v as u32)];
            for (i, &u) in tangents.iter().enumerate() {
                for (j, &w) in tangents.iter().enumerate() {
                    values[position.at(i, j)] += gradient[v].dot(support.second_fundamental_form(vertices[v], u, w));
                }
            }
        }
    }

    fn matrix(&self) -> SymmetricMatrix {
        self.pattern.matrix()
    }

    fn moved(&self, vertices: &[DVec3], state: &State<Frame>, step: &[f64], fraction: f64) -> Vec<DVec3> {
        let move_one = |(v, &vertex): (usize, &DVec3)| {
            let own = self.unknowns(v as u32);
            let moved = vertex + own.map(|k| fraction * step[k] * state.frame.directions[k]).sum::<DVec3>();
            match self.body.freedoms[v].support() {
                Some(support) => self.body.supports[support as usize].nearest(moved),
                None => moved,
            }
        };
        vertices.iter().enumerate().map(move_one).collect()
    }

    fn triangles(&self) -> &[[u32; 3]] {
        &self.body.triangles
    }

    fn radius(&self) -> f64 {
        self.radius
    }

    fn work(&self) -> u64 {
        // Assembling the 3 × 3 blocks of a triangle takes about as long as visiting forty triangles.
        40 * self.body.triangles.len() as u64
    }
}
