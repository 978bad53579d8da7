//! Dead loads: forces on vertices that keep their size and direction while the vertices move.

use super::Term;
use glam::DMat3;
use plateau_mesh::DVec3;

/// E = -Σ f · x.
#[derive(Clone, Debug, PartialEq)]
pub struct Load {
    /// The force on each vertex.
    pub forces: Vec<DVec3>,
}

impl Term for Load {
    fn value(&self, at: &[DVec3]) -> f64 {
        -self.forces.iter().zip(at).map(|(force, x)| force.dot(*x)).sum::<f64>()
    }

    fn add_gradient(&self, _at: &[DVec3], gradient: &mut [DVec3]) {
        gradient.iter_mut().zip(&self.forces).for_each(|(gradient, force)| *gradient -= *force);
    }

    fn add_second_derivative(&self, _at: &[DVec3], _shift: f64, _add: &mut dyn FnMut(u32, u32, DMat3)) {}

    fn visit_elements(&self, _visit: &mut dyn FnMut(&[u32])) {}
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::energy::finite_differences::{check, patch};

    #[test]
    fn the_derivatives_agree_with_finite_differences() {
        let (vertices, _) = patch();
        let forces = (0..vertices.len()).map(|k| DVec3::new(0.1 * k as f64, -0.3, 0.2)).collect();
        check(&Load { forces }, &vertices, 1e-8);
    }
}
