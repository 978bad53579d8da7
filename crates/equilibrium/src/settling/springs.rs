//! The linear system of the springs that replace the energies of a body near its present shape.

use crate::body::Body;
use crate::freedom::Freedom;
use plateau_mesh::DVec3;
use plateau_mesh::sparse::SymmetricMatrix;
use plateau_mesh::sparse::pattern::BlockPattern;

/// Stiffness that is added to every diagonal entry, as a fraction of the largest one, because vertices that no spring
/// holds would make the matrix singular.
const LEAST_STIFFNESS: f64 = 1e-12;

/// The stiffness matrix H of the springs, in the unknowns of a body.
pub(super) struct Springs {
    basis: Basis,
    pattern: BlockPattern,
    pub matrix: SymmetricMatrix,
}

impl Springs {
    /// Assembles the springs of all terms and of the constraints. A spring of a constraint is multiplied by the
    /// negative of the constraint's multiplier, and left out if its stiffness is then negative. The positive part of
    /// the curvature of the supports is added; it is proportional to the forces `gradient`.
    pub fn new(body: &Body, at: &[DVec3], gradient: &[DVec3], multipliers: &[f64]) -> Self {
        let basis = Basis::new(body, at);
        let pattern = BlockPattern::new(&basis.counts, |couple| {
            let mut visit = |element: &[u32]| {
                let owners: Vec<u32> = element.iter().map(|&v| basis.owner[v as usize]).collect();
                couple(&owners);
            };
            body.quantities().for_each(|term| term.visit_elements(&mut visit));
        });
        let matrix = pattern.matrix();
        let mut springs = Self { basis, pattern, matrix };
        body.terms.iter().for_each(|term| term.visit_springs(at, &mut |a, b, k| springs.add(a, b, k)));
        for (constraint, multiplier) in body.constraints.iter().zip(multipliers) {
            constraint.quantity.visit_springs(at, &mut |a, b, k| springs.add(a, b, (-multiplier * k).max(0.0)));
        }
        springs.add_supports(body, at, gradient);
        let most = (0..springs.pattern.order()).map(|row| springs.matrix.diagonal(row).abs()).fold(0.0, f64::max);
        for row in 0..springs.pattern.order() {
            springs.matrix.values[springs.matrix.row_start[row] as usize] += LEAST_STIFFNESS * most;
        }
        springs
    }

    /// Adds a spring between two vertices.
    fn add(&mut self, a: u32, b: u32, stiffness: f64) {
        let Self { basis, pattern, matrix } = self;
        for (v, w, sign) in [(a, a, 1.0), (b, b, 1.0), (a, b, -1.0), (b, a, -1.0)] {
            let Some(position) = pattern.position(basis.owner[v as usize], basis.owner[w as usize]) else {
                continue;
            };
            let (own, other) = (basis.of(v), basis.of(w));
            for (i, u) in own.iter().enumerate() {
                for (j, w) in other.iter().enumerate() {
                    let cosine = if basis.scalar { 1.0 } else { u.dot(*w) };
                    matrix.values[position.at(i, j)] += sign * stiffness * cosine;
                }
            }
        }
    }

    /// Adds, at each vertex on a support, the positive semidefinite part of g · II, with the force g on the vertex and
    /// the second fundamental form II of the support.
    fn add_supports(&mut self, body: &Body, at: &[DVec3], gradient: &[DVec3]) {
        let values = &mut self.matrix.values;
        for (v, freedom) in body.freedoms.iter().enumerate() {
            let Some(number) = freedom.support() else { continue };
            let Some(position) = self.pattern.position(v as u32, v as u32) else { continue };
            let support = &body.supports[number as usize];
            let tangents = self.basis.of(v as u32);
            let curvature =
                |i: usize, j: usize| gradient[v].dot(support.second_fundamental_form(at[v], tangents[i], tangents[j]));
            if tangents.len() == 1 {
                values[position.at(0, 0)] += curvature(0, 0).max(0.0);
            } else {
                let positive = positive_part(curvature(0, 0), curvature(0, 1), curvature(1, 1));
                for i in 0..2 {
                    for j in 0..2 {
                        values[position.at(i, j)] += positive[i + j];
                    }
                }
            }
        }
    }

    /// Number of right-hand sides that represent one vector per vertex: 3 for x, y and z if the basis is scalar,
    /// otherwise 1.
    fn columns(&self) -> usize {
        if self.basis.scalar { 3 } else { 1 }
    }

    /// Total length of the right-hand sides that represent one vector per vertex.
    pub fn order(&self) -> usize {
        self.columns() * self.pattern.order()
    }

    /// Appends to `into` the right-hand sides that represent one vector per vertex: the vectors' components along the
    /// unknowns.
    pub fn reduce(&self, vectors: &[DVec3], into: &mut Vec<f64>) {
        let Self { basis, pattern, .. } = self;
        let (start, order) = (into.len(), pattern.order());
        into.resize(start + self.order(), 0.0);
        for (v, vector) in vectors.iter().enumerate() {
            let unknowns = pattern.unknowns(basis.owner[v]);
            if basis.scalar {
                for k in unknowns {
                    (0..3).for_each(|c| into[start + c * order + k] += vector[c]);
                }
            } else {
                unknowns.zip(basis.of(v as u32)).for_each(|(k, towards)| into[start + k] += vector.dot(*towards));
            }
        }
    }

    /// Returns the displacement of each vertex, given the solution for the right-hand sides of
    /// [`reduce`](Self::reduce).
    pub fn displacements(&self, solution: &[f64]) -> Vec<DVec3> {
        let Self { basis, pattern, .. } = self;
        let order = pattern.order();
        let of = |v: usize| {
            let unknowns = pattern.unknowns(basis.owner[v]);
            if basis.scalar {
                unknowns.map(|k| DVec3::from_array([0, 1, 2].map(|c| solution[c * order + k]))).sum()
            } else {
                unknowns.zip(basis.of(v as u32)).map(|(k, towards)| solution[k] * *towards).sum()
            }
        };
        (0..basis.owner.len()).map(of).collect()
    }
}

/// The unknowns of a body during the settling, and their directions.
struct Basis {
    /// Whether every vertex that is not fixed moves in all directions. Each of these vertices then has one scalar
    /// unknown, and the system is solved for x, y and z with the same factor.
    scalar: bool,
    counts: Vec<u8>,
    /// For each vertex the vertex whose unknowns it shares: itself, or the first vertex of its group.
    owner: Vec<u32>,
    start: Vec<u32>,
    directions: Vec<DVec3>,
}

impl Basis {
    fn new(body: &Body, at: &[DVec3]) -> Self {
        let moves_anywhere = |freedom: &Freedom| {
            matches!(freedom, Freedom::Fixed | Freedom::Normal | Freedom::Across(_) | Freedom::Free)
        };
        let scalar = body.freedoms.iter().all(moves_anywhere);
        let mut first_of = vec![None; body.groups.len()];
        let owner: Vec<u32> = (0u32..)
            .zip(&body.freedoms)
            .map(|(v, freedom)| match *freedom {
                Freedom::Together(group) => *first_of[group as usize].get_or_insert(v),
                _ => v,
            })
            .collect();
        let (mut counts, mut start, mut directions) = (Vec::new(), vec![0], Vec::new());
        for (v, freedom) in body.freedoms.iter().enumerate() {
            match *freedom {
                Freedom::Fixed => {}
                Freedom::Normal | Freedom::Across(_) | Freedom::Free if scalar => directions.push(DVec3::ZERO),
                Freedom::Normal | Freedom::Across(_) | Freedom::Free => directions.extend(DVec3::AXES),
                Freedom::On(number) | Freedom::AcrossOn { support: number, .. } => {
                    let support = &body.supports[number as usize];
                    directions.extend(&support.tangents(at[v])[..usize::from(support.dimension())]);
                }
                Freedom::Together(group) if owner[v] as usize == v => directions.push(body.groups[group as usize]),
                Freedom::Together(_) => {}
            }
            counts.push((directions.len() - start[v] as usize) as u8);
            start.push(directions.len() as u32);
        }
        Self { scalar, counts, owner, start, directions }
    }

    fn of(&self, v: u32) -> &[DVec3] {
        let owner = self.owner[v as usize] as usize;
        &self.directions[self.start[owner] as usize..self.start[owner + 1] as usize]
    }
}

/// Returns the entries (0, 0), (0, 1) and (1, 1) of the positive semidefinite part of the symmetric matrix whose
/// entries at these places are a, b and c.
fn positive_part(a: f64, b: f64, c: f64) -> [f64; 3] {
    let (mean, half) = (0.5 * (a + c), (0.25 * (a - c) * (a - c) + b * b).sqrt());
    let (low, high) = (mean - half, mean + half);
    // If both are of one sign, they may be equal up to rounding, and the quotient below would be 0 / 0. On a sphere they
    // are equal.
    if low >= 0.0 || high <= 0.0 {
        let whole = f64::from(u8::from(low >= 0.0));
        return [whole * a, whole * b, whole * c];
    }
    // The positive part is `high` times the projector onto the eigenvector of `high`, (M - low) / (high - low).
    let factor = high.max(0.0) / (high - low);
    [factor * (a - low), factor * b, factor * (c - low)]
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn the_positive_part_of_a_multiple_of_the_identity_is_itself_or_zero() {
        for b in [0.0, 1e-20, -1e-17] {
            assert_eq!(positive_part(-2.0, b, -2.0), [0.0; 3], "b = {b}");
            assert_eq!(positive_part(2.0, b, 2.0), [2.0, b, 2.0], "b = {b}");
        }
    }
}
