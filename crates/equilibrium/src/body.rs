//! A body: sheets of triangles and line elements with energies, freedoms and constraints.

use super::constraint::{Constraint, Determined};
use super::freedom::Freedom;
use super::support::Support;
use crate::energy::{Area, Term};
use plateau_mesh::complex::{Complex, VertexKind};
use plateau_mesh::{DVec3, polyline};
use std::fmt;
use std::sync::Arc;

/// Largest distance of a vertex from its support, as a fraction of the radius of the body. Rounding of coordinates
/// needs about 1e-15.
const ON_SUPPORT: f64 = 1e-9;

/// A complex of triangles with a surface tension per sheet, further energies, and a freedom for each vertex.
#[derive(Debug)]
pub struct Body {
    /// The position of each vertex.
    pub vertices: Vec<DVec3>,
    /// The freedom of each vertex.
    pub freedoms: Vec<Freedom>,
    /// The lines and surfaces to which [`Freedom::On`] and [`Freedom::AcrossOn`] refer.
    pub supports: Vec<Arc<dyn Support>>,
    /// The unit vector along which each group of [`Freedom::Together`] moves.
    pub groups: Vec<DVec3>,
    /// The energies. [`Body::new`] makes the areas of the sheets the first terms.
    pub terms: Vec<Box<dyn Term>>,
    /// Quantities of the whole body, such as a volume, that are kept at a value or whose multiplier is determined by an
    /// equation.
    pub constraints: Vec<Constraint>,
    pub(super) triangles: Vec<[u32; 3]>,
    /// Edges where a sheet ends or where more than two triangles meet, each with the mean surface tension of its
    /// triangles.
    pub(super) curves: Vec<([u32; 2], f64)>,
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
    /// The support of this number has a direction that is not a unit vector, or a radius that is not positive.
    Support(u32),
    /// The direction of the group of this number is not a unit vector.
    Group(u32),
    /// A direction of the term of this number is not a unit vector.
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
    /// A film: sheets of the given surface tensions, one for each of `complex.sheets`. Vertices of the boundary are
    /// fixed. Vertices inside a sheet move along their normals, vertices inside a junction move across its curve, and
    /// vertices where junctions meet move freely. Vertices with numbers beyond those of the complex belong to no sheet,
    /// such as those of cables in the air; they move freely.
    ///
    /// # Panics
    /// If the number of tensions differs from the number of sheets.
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

    /// Adds a film whose boundary vertices are already vertices of the body; they keep their freedom. `numbers[v]` is
    /// the number in the body of vertex v of the complex, which must have no junctions. The inner vertices of the film
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

    /// The energy of the body: the sum of all its terms.
    #[must_use]
    pub fn energy(&self) -> f64 {
        self.terms.iter().map(|term| term.value(&self.vertices)).sum()
    }

    /// Renews the coefficients of every term at the present positions ([`Term::renew`]). Returns the largest relative
    /// change.
    pub fn renew(&mut self) -> f64 {
        self.terms.iter_mut().map(|term| term.renew(&self.vertices)).fold(0.0, f64::max)
    }

    /// R: the largest distance of a fixed vertex from the mean of the fixed vertices. If fewer than two vertices are
    /// fixed, all vertices are used instead.
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

    /// Returns the terms of the body, followed by the quantities of its constraints.
    pub(super) fn quantities(&self) -> impl Iterator<Item = &dyn Term> {
        self.terms.iter().chain(self.constraints.iter().map(|constraint| &constraint.quantity)).map(|term| &**term)
    }

    /// Number of independent directions in which a vertex may move.
    pub(super) fn unknowns(&self, v: usize) -> u8 {
        match self.freedoms[v] {
            Freedom::Fixed => 0,
            Freedom::Normal | Freedom::AcrossOn { .. } | Freedom::Together(_) => 1,
            Freedom::Across(_) => 2,
            Freedom::On(support) => self.supports[support as usize].dimension(),
            Freedom::Free => 3,
        }
    }
}
