//! An elastic line: a cable that resists stretching and goes slack when it is shorter than its unstressed length.
//!
//! ```text
//! E = Σ (EA / 2 L0) (L - L0)²₊          φ' = (EA / L0) (L - L0)₊          φ'' = EA / L0 where L > L0, else 0
//! ```
//!
//! Source: the strain energy of a truss element with engineering strain (Hooke's law); derivatives by
//! [`length`](super::length).

use super::Term;
use super::length::{self, Stretch};
use glam::DMat3;
use plateau_mesh::DVec3;

/// E = Σ (EA / 2 L0) (L - L0)²₊ over the segments.
#[derive(Clone, Debug, PartialEq)]
pub(crate) struct ElasticLine {
    pub segments: Vec<[u32; 2]>,
    /// L0 of each segment.
    pub unstressed: Vec<f64>,
    /// EA, a force.
    pub stiffness: f64,
}

impl ElasticLine {
    fn stretch(&self, k: usize, length: f64) -> Stretch {
        let per_length = self.stiffness / self.unstressed[k];
        let beyond = length - self.unstressed[k];
        if beyond > 0.0 {
            Stretch { energy: 0.5 * per_length * beyond * beyond, force: per_length * beyond, stiffness: per_length }
        } else {
            Stretch { energy: 0.0, force: 0.0, stiffness: 0.0 }
        }
    }
}

impl Term for ElasticLine {
    fn value(&self, at: &[DVec3]) -> f64 {
        let energy = |(k, &segment): (usize, &[u32; 2])| self.stretch(k, length::length(segment, at)).energy;
        self.segments.iter().enumerate().map(energy).sum()
    }

    fn add_gradient(&self, at: &[DVec3], gradient: &mut [DVec3]) {
        length::add_gradient(&self.segments, at, gradient, |k, length| self.stretch(k, length));
    }

    fn add_second_derivative(&self, at: &[DVec3], shift: f64, add: &mut dyn FnMut(u32, u32, DMat3)) {
        length::add_second_derivative(&self.segments, at, shift, add, |k, length| self.stretch(k, length));
    }

    fn visit_elements(&self, visit: &mut dyn FnMut(&[u32])) {
        self.segments.iter().for_each(|segment| visit(segment));
    }

    fn add_shares(&self, at: &[DVec3], shares: &mut [f64]) {
        length::add_shares(&self.segments, at, shares, |k, length| self.stretch(k, length).force);
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::energy::finite_differences::{check, patch};

    #[test]
    fn the_derivatives_agree_with_finite_differences_taut_and_slack() {
        let (vertices, _) = patch();
        let segments = vec![[0, 1], [1, 2], [2, 6], [6, 7]];
        // The second segment is slack.
        let line = ElasticLine { segments, unstressed: vec![0.5, 3.0, 0.9, 0.7], stiffness: 4.0 };
        assert!(length::length([1, 2], &vertices) < 3.0 && line.stretch(1, 2.9).force == 0.0);
        check(&line, &vertices, 1e-8);
    }
}
