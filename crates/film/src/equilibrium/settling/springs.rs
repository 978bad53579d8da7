//! The springs that replace the energies of a body at its present shape, as a linear system.

use crate::equilibrium::body::Body;
use crate::equilibrium::freedom::Freedom;
use plateau_mesh::DVec3;
use plateau_mesh::sparse::SymmetricMatrix;
use plateau_mesh::sparse::pattern::BlockPattern;

/// Added to the diagonal, as a fraction of its largest entry, for vertices that nothing holds.
const LEAST_STIFFNESS: f64 = 1e-12;

/// The matrix H of the springs along the unknowns of a body.
pub(super) struct Springs {
    basis: Basis,
    pattern: BlockPattern,
    pub matrix: SymmetricMatrix,
}

impl Springs {
    /// The springs of all terms, those of constraints with their `multipliers`, and the positive part of the curvature
    /// of supports under the forces `gradient`.
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

    /// Adds the positive part of the curvature of the supports.
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

    /// Number of right-hand sides that one vector per vertex makes.
    fn columns(&self) -> usize {
        if self.basis.scalar { 3 } else { 1 }
    }

    /// Length of the right-hand sides that one vector per vertex makes.
    pub fn order(&self) -> usize {
        self.columns() * self.pattern.order()
    }

    /// Appends the components of one vector per vertex along the unknowns.
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

    /// The displacement of each vertex in a solution.
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

/// The directions of the unknowns of a settling body.
struct Basis {
    /// Whether every vertex that moves does so in all directions. It then has one unknown, which is solved for x, y and
    /// z with the same factor.
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

/// The entries (0, 0), (0, 1) and (1, 1) of the positive part of the symmetric matrix with these entries a, b and c.
fn positive_part(a: f64, b: f64, c: f64) -> [f64; 3] {
    let (mean, half) = (0.5 * (a + c), (0.25 * (a - c) * (a - c) + b * b).sqrt());
    let (low, high) = (mean - half, mean + half);
    if low >= 0.0 || half == 0.0 {
        let whole = f64::from(u8::from(low >= 0.0));
        return [whole * a, whole * b, whole * c];
    }
    // The positive part is high times the projector (M - low) / (high - low) on the eigenvector of high.
    let factor = high.max(0.0) / (high - low);
    [factor * (a - low), factor * b, factor * (c - low)]
}
