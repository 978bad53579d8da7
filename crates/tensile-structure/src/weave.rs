//! The stress field of a woven film.
//!
//! Warp and weft have the stresses m σ_w and m σ_f along two directions w and f of the film, with a common factor m
//! that varies over the film. Within the film the forces balance if
//!
//! ```text
//! div (m T) + q = 0          T = σ_w w wᵀ + σ_f f fᵀ, q the load within the film
//! ```
//!
//! On a surface of revolution with unequal stresses along and around it no constant m satisfies this. The factor m ∝
//! r^(k - 1) with the ratio k = σ_f / σ_w of hoop to meridian does, because (r m σ_w)' = m σ_f. In general the two
//! equations determine a vector field for the gradient of ln m, which need not be the gradient of a function. The
//! nearest gradient is taken. With the unbalanced force R = -(div (m T) + q) of the present m per area, ln m changes by
//! δ with
//!
//! ```text
//! ∫ |∇δ - (m T)⁻¹ R|² -> min          a Poisson equation with the cotangent Laplacian
//! ```
//!
//! The last solve of form finding removes the imbalance that remains. It moves vertices within the film. The statistics
//! state how much this changes the stresses.
//!
//! A cable on the film's edge or across it bears the film's pull along the cable, which changes the cable's force from
//! segment to segment. An isotropic film has no pull along a cable.

use super::options::{CableMode, WarpDirection, Weave, WeaveHold};
use plateau_equilibrium::energy::area::Facet;
use plateau_equilibrium::energy::dirichlet::laplacian;
use plateau_equilibrium::energy::length::length;
use plateau_equilibrium::energy::{PlaneStress, Prestress, Term};
use plateau_mesh::DVec3;
use plateau_mesh::sparse::pattern::{FIXED, Pattern};
use plateau_mesh::sparse::{LinearError, Symbolic};

/// Largest change of ln m in one renewal. The equation is linear, so a far start needs no more than a few renewals.
/// Without this bound the first renewals, on a shape that is far from the found one, overshoot.
pub(super) const LARGEST_CHANGE: f64 = 0.5;

/// The stresses of a woven film while form finding works on it. Positions are relative to the model's centre.
#[derive(Clone, Debug)]
pub(super) struct StressField {
    weave: Weave,
    /// ln m of each vertex.
    pub factors: Vec<f64>,
    /// A vertex of each connected part of the film. The Poisson equation determines δ up to a constant in each part, so
    /// δ is set to 0 at these vertices. After that m is scaled to the mean 1.
    anchors: Vec<u32>,
}

impl StressField {
    /// The field of constant stresses.
    pub fn new(weave: &Weave, centre: DVec3, triangles: &[[u32; 3]], vertices: usize) -> Self {
        let mut weave = weave.clone();
        match &mut weave.direction {
            WarpDirection::Radial { point, .. } => *point -= centre,
            WarpDirection::Parallel(_) => {}
            WarpDirection::Along(points) => points.iter_mut().for_each(|point| *point -= centre),
        }
        Self { weave, factors: vec![0.0; vertices], anchors: one_of_each_part(triangles, vertices) }
    }

    pub fn hold(&self) -> WeaveHold {
        self.weave.hold
    }

    /// The unit vector of the warp at a place, in the plane with this unit normal.
    fn warp(&self, place: DVec3, normal: DVec3) -> DVec3 {
        let project = |vector: DVec3| vector.reject_from_normalized(normal);
        let found = match &self.weave.direction {
            WarpDirection::Radial { point, axis } => project(axis.cross(place - *point)).cross(normal),
            WarpDirection::Parallel(vector) => project(*vector),
            WarpDirection::Along(points) => project(tangent_of_nearest(points, place)),
        };
        found.normalize_or(normal.any_orthonormal_vector())
    }

    /// The stress that is required in a triangle.
    pub fn required(&self, triangle: &[u32; 3], at: &[DVec3]) -> PlaneStress {
        let factor = libm::exp(triangle.iter().map(|&v| self.factors[v as usize]).sum::<f64>() / 3.0);
        let centroid = triangle.iter().map(|&v| at[v as usize]).sum::<DVec3>() / 3.0;
        let direction = self.warp(centroid, Facet::of(at, triangle).normal);
        PlaneStress { direction, along: factor * self.weave.warp, across: factor * self.weave.weft }
    }

    /// The energy of the film with the shape `at` as its reference.
    pub fn prestress(&self, triangles: &[[u32; 3]], at: &[DVec3]) -> Prestress {
        Prestress::plane(triangles, |t| self.required(&triangles[t], at), at)
    }

    /// Renews m from the balance of the film at these positions, with `loads` on its vertices. `inside` marks the
    /// vertices that only the film and the loads pull. Returns the largest change of ln m that the balance asks for,
    /// which may exceed the change that is made.
    ///
    /// # Errors
    /// A [`LinearError`] for a degenerate film.
    pub fn renew(
        &mut self,
        triangles: &[[u32; 3]],
        at: &[DVec3],
        loads: &[DVec3],
        inside: &[bool],
    ) -> Result<f64, LinearError> {
        let mut forces = vec![DVec3::ZERO; at.len()];
        self.prestress(triangles, at).add_gradient(at, &mut forces);
        forces.iter_mut().zip(loads).for_each(|(force, load)| *force -= *load);
        let facets: Vec<Facet> = triangles.iter().map(|triangle| Facet::of(at, triangle)).collect();
        let mut areas = vec![0.0; at.len()];
        for (triangle, facet) in triangles.iter().zip(&facets) {
            triangle.iter().for_each(|&v| areas[v as usize] += facet.double_area / 6.0);
        }
        let mut fixed = vec![false; self.factors.len()];
        self.anchors.iter().for_each(|&v| fixed[v as usize] = true);
        let pattern = Pattern::of_complex(triangles, &fixed);
        let (mut matrix, mut unused) = (pattern.matrix(), Vec::new());
        laplacian(&pattern, at, at, triangles, &mut matrix, &mut unused);
        let mut change = vec![0.0; pattern.free.vertex.len()];
        for (triangle, facet) in triangles.iter().zip(&facets) {
            let known: Vec<DVec3> = triangle
                .iter()
                .filter(|&&v| inside[v as usize])
                .map(|&v| forces[v as usize] / areas[v as usize])
                .collect();
            let Some(share) = (!known.is_empty()).then(|| 1.0 / known.len() as f64) else { continue };
            let unbalanced = share * known.into_iter().sum::<DVec3>();
            let PlaneStress { direction, along, across } = self.required(triangle, at);
            let other = facet.normal.cross(direction);
            let wanted = direction * (unbalanced.dot(direction) / along) + other * (unbalanced.dot(other) / across);
            for (corner, &v) in triangle.iter().enumerate() {
                let row = pattern.free.unknown[v as usize];
                if row != FIXED {
                    // The gradient of a triangle's area by a corner is the area times the gradient of its hat function.
                    change[row as usize] += facet.gradient(corner).dot(wanted);
                }
            }
        }
        Symbolic::analyse(&matrix, None)?.factorise(&matrix)?.solve(&mut change)?;
        let before = self.factors.clone();
        for (&v, change) in pattern.free.vertex.iter().zip(&change) {
            self.factors[v as usize] += change;
        }
        let (mut total, mut weighted) = (0.0, 0.0);
        for (triangle, facet) in triangles.iter().zip(&facets) {
            total += facet.double_area;
            weighted +=
                facet.double_area * triangle.iter().map(|&v| libm::exp(self.factors[v as usize])).sum::<f64>() / 3.0;
        }
        let mean = libm::log(weighted / total);
        let largest = |factors: &[f64]| factors.iter().zip(&before).map(|(a, b)| (a - b).abs()).fold(0.0, f64::max);
        self.factors.iter_mut().for_each(|factor| *factor -= mean);
        let found = largest(&self.factors);
        if found > LARGEST_CHANGE {
            let share = LARGEST_CHANGE / found;
            self.factors
                .iter_mut()
                .zip(&before)
                .for_each(|(factor, before)| *factor = before + share * (*factor - before));
        }
        Ok(found)
    }

    /// Sets every m to 1, so that the stresses of warp and weft are the given ones.
    pub fn make_constant(&mut self) {
        self.factors.fill(0.0);
    }
}

/// For each segment of a cable the force that the film's pull along the cable adds. `pull` is the derivative of the
/// film's energy and loads by each vertex. The mean of the added forces over the cable's length is 0. If the cable's
/// mode prescribes the force at the first end, the added force in the first segment is 0 instead.
pub(super) fn pulls_along(chain: &[u32], mode: CableMode, pull: &[DVec3], at: &[DVec3]) -> Vec<f64> {
    let place = |k: usize| at[chain[k] as usize];
    let mut forces = vec![0.0];
    for k in 1..chain.len() - 1 {
        // The segments pull the vertex by F_k t_k - F_(k-1) t_(k-1), which balances the film's derivative.
        let tangent = (place(k + 1) - place(k - 1)).normalize_or_zero();
        forces.push(forces[k - 1] + pull[chain[k] as usize].dot(tangent));
    }
    let lengths: Vec<f64> = chain.windows(2).map(|pair| length([pair[0], pair[1]], at)).collect();
    let mean = match mode {
        CableMode::EndTension(_) | CableMode::HorizontalComponent(_) => 0.0,
        _ => {
            let total: f64 = lengths.iter().sum();
            forces.iter().zip(&lengths).map(|(force, length)| force * length).sum::<f64>() / total
        }
    };
    forces.into_iter().map(|force| force - mean).collect()
}

/// The vertex with the lowest number in each connected part of the film.
fn one_of_each_part(triangles: &[[u32; 3]], vertices: usize) -> Vec<u32> {
    let mut lowest: Vec<u32> = (0..vertices as u32).collect();
    let find = |lowest: &mut Vec<u32>, mut v: u32| {
        // Ends because a vertex that is not the lowest of its part refers to a lower one.
        while lowest[v as usize] != v {
            lowest[v as usize] = lowest[lowest[v as usize] as usize];
            v = lowest[v as usize];
        }
        v
    };
    for &[a, b, c] in triangles {
        for (v, w) in [(a, b), (b, c)] {
            let (v, w) = (find(&mut lowest, v), find(&mut lowest, w));
            lowest[v.max(w) as usize] = v.min(w);
        }
    }
    (0..vertices as u32).filter(|&v| lowest[v as usize] == v).collect()
}

/// The unit tangent of a polyline at its point that is nearest to a place. Between the middles of two segments it turns
/// from the direction of the first to that of the second.
fn tangent_of_nearest(points: &[DVec3], place: DVec3) -> DVec3 {
    let segments = points.len() - 1;
    let direction = |k: usize| (points[k + 1] - points[k]).normalize_or_zero();
    let nearest = |k: usize| {
        let span = points[k + 1] - points[k];
        let share = ((place - points[k]).dot(span) / span.length_squared()).clamp(0.0, 1.0);
        (k, share, place.distance_squared(points[k] + share * span))
    };
    let nearer = |a: (usize, f64, f64), b: (usize, f64, f64)| if b.2 < a.2 { b } else { a };
    let (k, share, _) = (0..segments).map(nearest).reduce(nearer).unwrap_or((0, 0.0, 0.0));
    let other = if share < 0.5 { k.saturating_sub(1) } else { (k + 1).min(segments - 1) };
    let weight = (share - 0.5).abs();
    (direction(k) * (1.0 - weight) + direction(other) * weight).normalize_or(direction(k))
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn the_tangent_of_a_polyline_turns_from_middle_to_middle() {
        let points = [DVec3::ZERO, DVec3::X, DVec3::new(1.0, 1.0, 0.0)];
        let at = |x: f64, y: f64| tangent_of_nearest(&points, DVec3::new(x, y, 3.0));
        assert!(at(0.5, -1.0).distance(DVec3::X) < 1e-12);
        assert!(at(2.0, 0.5).distance(DVec3::Y) < 1e-12);
        assert!(at(1.0, 0.0).distance(DVec3::new(0.5, 0.5, 0.0).normalize()) < 1e-12);
        assert!(at(-5.0, 0.0).distance(DVec3::X) < 1e-12, "beyond an end the direction of its segment");
    }

    #[test]
    fn each_part_of_a_film_has_one_anchor() {
        assert_eq!(one_of_each_part(&[[0, 1, 2], [2, 1, 3], [4, 5, 6]], 7), [0, 4]);
    }
}
