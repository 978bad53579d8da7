//! Bodies of sheets and lines, and their equations of equilibrium.

use super::constraint::{Constraint, ConstraintState, Determined, least_squares_multipliers};
use super::freedom::Freedom;
use super::newton::{Direct, Equations, Outcome, Settings, State, iterate};
use super::residual::residual;
use super::stability::{self, Unknown, WithMargin};
use super::support::Support;
use crate::energy::{Area, Term};
use glam::DMat3;
use plateau_mesh::complex::{Complex, VertexKind};
use plateau_mesh::measure;
use plateau_mesh::sparse::pattern::BlockPattern;
use plateau_mesh::sparse::{LinearError, SymmetricMatrix};
use plateau_mesh::{DVec3, Execution, polyline};
use std::fmt;
use std::ops::Range;
use std::sync::Arc;

/// Largest distance of a vertex from its support, as a fraction of the radius of the body. Rounding of coordinates
/// needs about 1e-15.
const ON_SUPPORT: f64 = 1e-9;

/// A complex of triangles with a surface tension per sheet, further energies, and a freedom for each vertex.
#[derive(Debug)]
pub struct Body {
    /// Positions.
    pub vertices: Vec<DVec3>,
    /// The freedom of each vertex.
    pub freedoms: Vec<Freedom>,
    /// The lines and surfaces of [`Freedom::On`] and [`Freedom::AcrossOn`].
    pub supports: Vec<Arc<dyn Support>>,
    /// For each group of [`Freedom::Together`] the unit vector along which it moves.
    pub groups: Vec<DVec3>,
    /// The energies; [`Body::new`] begins with the sheets' areas.
    pub terms: Vec<Box<dyn Term>>,
    /// Quantities of the whole body that keep their values.
    pub constraints: Vec<Constraint>,
    triangles: Vec<[u32; 3]>,
    /// Edges where sheets end or meet, each with the mean of the surface tensions of its sheets.
    curves: Vec<([u32; 2], f64)>,
}

/// Why a body has no equations of equilibrium.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum BodyDefect {
    /// The lists of freedoms and vertices differ in length.
    Freedoms,
    /// A term, a constraint or a freedom names a vertex that does not exist.
    NoSuchVertex(u32),
    /// A freedom names a support that does not exist.
    NoSuchSupport(u32),
    /// A freedom names a group that does not exist.
    NoSuchGroup(u32),
    /// The vertex does not lie on its support.
    OffSupport(u32),
    /// A direction of the support of this number is no unit vector, or its radius is not positive.
    Support(u32),
    /// The direction of the group of this number is no unit vector.
    Group(u32),
    /// A direction of the term of this number is no unit vector.
    Term(usize),
    /// A constraint's target is zero or not finite.
    Target(usize),
}

impl fmt::Display for BodyDefect {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            Self::Freedoms => f.write_str("every vertex needs one freedom"),
            Self::NoSuchVertex(vertex) => write!(f, "vertex {vertex} does not exist"),
            Self::NoSuchSupport(support) => write!(f, "support {support} does not exist"),
            Self::NoSuchGroup(group) => write!(f, "group {group} does not exist"),
            Self::OffSupport(vertex) => write!(f, "vertex {vertex} does not lie on its support"),
            Self::Support(support) => {
                write!(f, "support {support} has a direction that is no unit vector, or no radius")
            }
            Self::Group(group) => write!(f, "the direction of group {group} is no unit vector"),
            Self::Term(term) => write!(f, "term {term} has a direction that is no unit vector"),
            Self::Target(constraint) => write!(f, "the target of constraint {constraint} must be finite and not zero"),
        }
    }
}

impl std::error::Error for BodyDefect {}

impl Body {
    /// A film: sheets of the given surface tensions (one for each of `complex.sheets`). The boundary is fixed, the
    /// vertices of junctions move across their curve, those where junctions meet move freely, all others along their
    /// normals. Vertices beyond those of the complex belong to no sheet (those of cables in the air) and move freely.
    ///
    /// # Panics
    /// If there are not as many tensions as sheets.
    #[must_use]
    pub fn new(vertices: Vec<DVec3>, complex: &Complex, tensions: &[f64]) -> Self {
        assert_eq!(complex.sheets.len(), tensions.len(), "one tension per sheet");
        let mut tension_of = vec![0.0; complex.triangles.len()];
        let mut terms: Vec<Box<dyn Term>> = Vec::new();
        for (sheet, &tension) in complex.sheets.iter().zip(tensions) {
            let triangles = sheet.iter().map(|&t| complex.triangles[t as usize]).collect();
            terms.push(Box::new(Area { triangles, tension }));
            sheet.iter().for_each(|&t| tension_of[t as usize] = tension);
        }
        let curves = complex
            .edges()
            .filter(|edge| edge.count() != 2)
            .map(|edge| {
                let sum: f64 = edge.triangles().map(|t| tension_of[t as usize]).sum();
                (edge.ends, sum / edge.count() as f64)
            })
            .collect();
        let freedom = |kind: &VertexKind| match *kind {
            VertexKind::Boundary => Freedom::Fixed,
            VertexKind::Sheet => Freedom::Normal,
            VertexKind::Junction(beside) => Freedom::Across(beside),
            VertexKind::Point => Freedom::Free,
        };
        let mut freedoms: Vec<Freedom> = complex.kinds.iter().map(freedom).collect();
        freedoms.resize(vertices.len(), Freedom::Free);
        let triangles = complex.triangles.clone();
        let (supports, groups, constraints) = (Vec::new(), Vec::new(), Vec::new());
        Self { vertices, freedoms, supports, groups, terms, constraints, triangles, curves }
    }

    /// Adds a film whose boundary vertices are vertices of the body already, with whatever freedom they have.
    /// `numbers[v]` is the number in the body of vertex v of the complex, which has no junctions. The vertices inside
    /// move along their normals.
    ///
    /// # Panics
    /// If a number is missing or names no vertex.
    pub fn add_film(&mut self, complex: &Complex, numbers: &[u32], tension: f64) {
        let own = |v: u32| numbers[v as usize];
        let triangles: Vec<[u32; 3]> = complex.triangles.iter().map(|triangle| triangle.map(own)).collect();
        let edges = complex.edges().filter(|edge| edge.count() == 1);
        self.curves.extend(edges.map(|edge| (edge.ends.map(own), tension)));
        for (kind, &number) in complex.kinds.iter().zip(numbers) {
            if *kind == VertexKind::Sheet {
                self.freedoms[number as usize] = Freedom::Normal;
            }
        }
        self.triangles.extend(&triangles);
        self.terms.push(Box::new(Area { triangles, tension }));
    }

    /// The triangles, oriented alike within each sheet.
    #[must_use]
    pub fn triangles(&self) -> &[[u32; 3]] {
        &self.triangles
    }

    /// The sum of all terms.
    #[must_use]
    pub fn energy(&self) -> f64 {
        self.terms.iter().map(|term| term.value(&self.vertices)).sum()
    }

    /// Lets every term renew its coefficients at the present positions. Returns the largest relative change.
    pub fn renew(&mut self) -> f64 {
        self.terms.iter_mut().map(|term| term.renew(&self.vertices)).fold(0.0, f64::max)
    }

    /// R: the largest distance of a fixed vertex from the mean of the fixed vertices; of all vertices where fewer than
    /// two are fixed.
    #[must_use]
    pub fn radius(&self) -> f64 {
        let fixed = self.freedoms.iter().zip(&self.vertices).filter(|(freedom, _)| **freedom == Freedom::Fixed);
        let mut points: Vec<DVec3> = fixed.map(|(_, &p)| p).collect();
        if points.len() < 2 {
            points.clone_from(&self.vertices);
        }
        let mean = polyline::mean(&points);
        points.iter().map(|p| p.distance(mean)).fold(0.0, f64::max)
    }

    /// Checks that the parts of the body fit together.
    ///
    /// # Errors
    /// The first [`BodyDefect`].
    pub fn check(&self) -> Result<(), BodyDefect> {
        let count = self.vertices.len();
        if self.freedoms.len() != count {
            return Err(BodyDefect::Freedoms);
        }
        let mut missing = None;
        let mut see = |vertices: &[u32]| {
            if let Some(&v) = vertices.iter().find(|&&v| v as usize >= count) {
                missing.get_or_insert(v);
            }
        };
        for term in self.quantities() {
            term.visit_elements(&mut see);
        }
        for freedom in &self.freedoms {
            if let Freedom::Across(beside) | Freedom::AcrossOn { beside, .. } = freedom {
                see(beside);
            }
        }
        if let Some(vertex) = missing {
            return Err(BodyDefect::NoSuchVertex(vertex));
        }
        for freedom in &self.freedoms {
            if let Freedom::Together(group) = *freedom
                && group as usize >= self.groups.len()
            {
                return Err(BodyDefect::NoSuchGroup(group));
            }
        }
        if let Some(support) = self.supports.iter().position(|support| !support.is_sound()) {
            return Err(BodyDefect::Support(support as u32));
        }
        if let Some(group) = self.groups.iter().position(|direction| !direction.is_normalized()) {
            return Err(BodyDefect::Group(group as u32));
        }
        if let Some(term) = self.terms.iter().position(|term| !term.has_unit_directions()) {
            return Err(BodyDefect::Term(term));
        }
        let radius = self.radius();
        for (v, (freedom, &here)) in self.freedoms.iter().zip(&self.vertices).enumerate() {
            let Some(number) = freedom.support() else { continue };
            let support = self.supports.get(number as usize).ok_or(BodyDefect::NoSuchSupport(number))?;
            if support.nearest(here).distance(here) > ON_SUPPORT * radius {
                return Err(BodyDefect::OffSupport(v as u32));
            }
        }
        let bad = |c: &Constraint| match c.by {
            Determined::Value(value) | Determined::Yielding { value, .. } => !value.is_finite() || value == 0.0,
            Determined::Condition(_) => false,
        };
        match self.constraints.iter().position(bad) {
            Some(constraint) => Err(BodyDefect::Target(constraint)),
            None => Ok(()),
        }
    }

    /// Moves the body to the nearest equilibrium and analyses its stability there. `record` receives the energy and the
    /// residual after every step.
    ///
    /// Terms that renew their coefficients do so after each solve, and the next solve follows, until no coefficient
    /// changes by more than the tolerance or the steps are used up.
    ///
    /// # Errors
    /// The first [`BodyDefect`]; nothing moves then.
    pub fn relax(
        &mut self,
        settings: &Settings,
        exec: &Execution,
        record: &mut dyn FnMut(f64, f64),
    ) -> Result<Report, BodyDefect> {
        self.check()?;
        let mut left = settings.max_steps;
        let count_of_constraints = self.constraints.len();
        loop {
            let mut vertices = self.vertices.clone();
            let motion = Motion::new(self);
            let mut taken = 0;
            let mut count = |energy: f64, residual: f64| {
                taken += 1;
                record(energy, residual);
            };
            let (report, solved) = match Direct::new(motion.matrix()) {
                Err(error) => {
                    let state = motion.state(&vertices);
                    (Report::new(Outcome::Refused(error), count_of_constraints, &state, None), false)
                }
                Ok(mut direct) => {
                    let round = Settings { max_steps: left, ..*settings };
                    let (outcome, state) = iterate(&mut vertices, &motion, &mut direct, &round, exec, &mut count);
                    let solved = outcome == Outcome::Converged;
                    let analysed = if solved {
                        stability::analyse(&vertices, &motion, &state, &mut direct, WithMargin::No, exec)
                    } else {
                        Ok(None)
                    };
                    let report = match analysed {
                        Ok(variation) => {
                            let found = variation.as_ref().map(|variation| Stability {
                                morse_index: variation.morse_index.decided(),
                                least_index: variation.morse_index.least,
                                lowest_eigenvalue: variation.lowest.eigenvalue,
                            });
                            let lowest_mode =
                                variation.map(|variation| motion.displacements(&state, &variation.lowest.vector));
                            Report { lowest_mode, ..Report::new(outcome, count_of_constraints, &state, found) }
                        }
                        Err(Unknown::Refused(_)) => Report::new(outcome, count_of_constraints, &state, None),
                        Err(Unknown::Interrupted(interruption)) => {
                            Report::new(Outcome::Interrupted(interruption), count_of_constraints, &state, None)
                        }
                    };
                    (report, solved)
                }
            };
            drop(motion);
            self.vertices = vertices;
            left = left.saturating_sub(taken);
            if !solved || self.renew() <= settings.tolerance {
                return Ok(report);
            }
            if left == 0 {
                return Ok(Report { outcome: Outcome::StepsUsed, ..report });
            }
        }
    }

    /// Runs one solve of [`relax`](Self::relax), without the check, the renewal and the stability. Also returns the
    /// state that was reached. `kept` has the symbolic factorisation and the storage of the last solve, which are used
    /// again if the pattern is the same, and gets those of this one.
    ///
    /// # Errors
    /// [`LinearError::TooLarge`].
    pub(crate) fn solve_once(
        &mut self,
        settings: &Settings,
        exec: &Execution,
        record: &mut dyn FnMut(f64, f64),
        kept: &mut Option<Direct>,
    ) -> Result<(Outcome, State<Frame>), LinearError> {
        let mut vertices = self.vertices.clone();
        let motion = Motion::new(self);
        let matrix = motion.matrix();
        if let Err(interruption) = exec.look(motion.work()) {
            return Ok((Outcome::Interrupted(interruption), motion.state(&vertices)));
        }
        let mut direct = match kept.take() {
            Some(last) if last.matrix.has_pattern_of(&matrix) => last,
            _ => Direct::new(matrix)?,
        };
        let solved = iterate(&mut vertices, &motion, &mut direct, settings, exec, record);
        drop(motion);
        *kept = Some(direct);
        self.vertices = vertices;
        Ok(solved)
    }

    fn quantities(&self) -> impl Iterator<Item = &dyn Term> {
        self.terms.iter().chain(self.constraints.iter().map(|constraint| &constraint.quantity)).map(|term| &**term)
    }

    fn unknowns(&self, v: usize) -> u8 {
        match self.freedoms[v] {
            Freedom::Fixed => 0,
            Freedom::Normal | Freedom::AcrossOn { .. } | Freedom::Together(_) => 1,
            Freedom::Across(_) => 2,
            Freedom::On(support) => self.supports[support as usize].dimension(),
            Freedom::Free => 3,
        }
    }
}

/// The stability of an equilibrium.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Stability {
    /// Number of negative eigenvalues of the second variation on the constraints' tangent space; 0 for a local minimum.
    /// `None` if rounding does not decide the sign of an eigenvalue.
    pub morse_index: Option<usize>,
    /// Number of eigenvalues that are negative beyond rounding.
    pub least_index: usize,
    /// Lowest eigenvalue against the lumped mass, in 1/unit².
    pub lowest_eigenvalue: f64,
}

/// How [`Body::relax`] ended.
#[derive(Clone, Debug, PartialEq)]
pub struct Report {
    /// Why the iteration ended.
    pub outcome: Outcome,
    /// The sum of all terms.
    pub energy: f64,
    /// The dimensionless residual, which the tolerance bounds.
    pub residual: f64,
    /// Per constraint its multiplier: for a volume the pressure, for a length the force.
    pub multipliers: Vec<f64>,
    /// `None` where the body has no unknowns, did not converge, or is too degenerate to factorise.
    pub stability: Option<Stability>,
    /// The displacement of each vertex in the mode of the lowest eigenvalue, scaled so that the largest has length 1.
    /// `None` where the stability is unknown.
    pub lowest_mode: Option<Vec<DVec3>>,
}

impl Report {
    fn new(outcome: Outcome, constraints: usize, state: &State<Frame>, stability: Option<Stability>) -> Self {
        // The rows of the terms' rank-one parts follow those of the constraints.
        let multipliers = state.constraints[..constraints].iter().map(|constraint| constraint.multiplier).collect();
        Self { outcome, energy: state.energy, residual: state.residual, multipliers, stability, lowest_mode: None }
    }
}

/// The equations of a body. Each vertex has one unknown for each independent direction in which it may move.
#[derive(Debug)]
pub(crate) struct Motion<'a> {
    body: &'a Body,
    /// For each vertex the vertex whose unknowns it shares: itself, or the first vertex of its group.
    owner: Vec<u32>,
    pattern: BlockPattern,
    radius: f64,
}

/// The directions of all unknowns, vertex by vertex, and the forces that the supports bear.
#[derive(Clone, Debug)]
pub(crate) struct Frame {
    pub directions: Vec<DVec3>,
    /// Per vertex the gradient of the Lagrangian.
    pub gradient: Vec<DVec3>,
    /// Per vertex the share by which its force is divided for the [`residual`](super::residual).
    pub shares: Vec<f64>,
}

impl<'a> Motion<'a> {
    /// The body must have passed its check.
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

    /// The unknowns of a vertex, which are those of all vertices of its group.
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

    /// Projects one vector per vertex on the directions of the unknowns. Returns one number per unknown; the unknown of
    /// a group sums over its vertices.
    fn components(&self, directions: &[DVec3], vectors: &[DVec3]) -> Vec<f64> {
        let mut components = vec![0.0; directions.len()];
        for (v, vector) in vectors.iter().enumerate() {
            self.unknowns(v as u32).for_each(|k| components[k] += vector.dot(directions[k]));
        }
        components
    }

    /// The displacement of each vertex in a motion given as one number per unknown, scaled so that the largest has
    /// length 1.
    fn displacements(&self, state: &State<Frame>, motion: &[f64]) -> Vec<DVec3> {
        let of = |v: usize| self.unknowns(v as u32).map(|k| motion[k] * state.frame.directions[k]).sum();
        let moved: Vec<DVec3> = (0..self.body.vertices.len()).map(of).collect();
        let largest = moved.iter().map(|d| d.length()).fold(f64::MIN_POSITIVE, f64::max);
        moved.into_iter().map(|d| d / largest).collect()
    }

    /// For each vertex that can move: its number, the length of the gradient's part along its directions, and its
    /// share. The residual is computed from the last two.
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
