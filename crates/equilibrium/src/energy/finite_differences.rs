//! Compares the derivatives of every term with central differences.

use super::Term;
use glam::DMat3;
use plateau_mesh::DVec3;

const STEP: f64 = 1e-5;

/// Panics unless the gradient is the derivative of the value, and the second derivative that of the gradient. This is
/// tested at the positions `at` for each coordinate of each vertex, up to `tolerance`. The second derivative includes
/// its rank-one parts. Also panics if a block belongs to two vertices without a common element.
pub(crate) fn check(term: &dyn Term, at: &[DVec3], tolerance: f64) {
    let gradient = |at: &[DVec3]| {
        let mut gradient = vec![DVec3::ZERO; at.len()];
        term.add_gradient(at, &mut gradient);
        gradient
    };
    let here = gradient(at);
    let mut blocks = vec![vec![DMat3::ZERO; at.len()]; at.len()];
    term.add_second_derivative(at, 0.0, &mut |v, w, block| blocks[v as usize][w as usize] += block);
    let mut rank_one_parts: Vec<(f64, Vec<DVec3>)> = Vec::new();
    term.visit_rank_one_parts(at, &mut |stiffness, gradient| rank_one_parts.push((stiffness, gradient.to_vec())));
    let mut coupled = vec![vec![false; at.len()]; at.len()];
    term.visit_elements(&mut |element| {
        for &v in element {
            element.iter().for_each(|&w| coupled[v as usize][w as usize] = true);
        }
    });
    for v in 0..at.len() {
        for axis in 0..3 {
            let moved = |step: f64| {
                let mut at = at.to_vec();
                at[v][axis] += step;
                at
            };
            let (up, down) = (moved(STEP), moved(-STEP));
            let slope = (term.value(&up) - term.value(&down)) / (2.0 * STEP);
            assert!((slope - here[v][axis]).abs() < tolerance, "vertex {v} axis {axis}: {slope} {}", here[v][axis]);
            for (w, (up, down)) in gradient(&up).iter().zip(gradient(&down)).enumerate() {
                let measured = (*up - down) / (2.0 * STEP);
                let dense = rank_one_parts.iter().map(|(stiffness, part)| part[w] * (stiffness * part[v][axis]));
                let expected = blocks[w][v].col(axis) + dense.sum::<DVec3>();
                assert!((measured - expected).length() < tolerance, "{w} by {v} axis {axis}: {measured} {expected}");
                assert!(coupled[v][w] || blocks[w][v] == DMat3::ZERO, "{w} and {v} share no element");
            }
        }
    }
}

/// A bumpy patch of eighteen triangles.
pub(crate) fn patch() -> (Vec<DVec3>, Vec<[u32; 3]>) {
    let n = 4u32;
    let (mut vertices, mut triangles) = (Vec::new(), Vec::new());
    for k in 0..n * n {
        let (x, y) = (f64::from(k % n), f64::from(k / n));
        vertices.push(DVec3::new(x + 0.1 * libm::sin(3.0 * y), y, 0.2 * x * y + 0.15 * f64::from(k * k % 7)));
        if k % n + 1 < n && k / n + 1 < n {
            triangles.extend([[k, k + 1, k + n + 1], [k, k + n + 1, k + n]]);
        }
    }
    (vertices, triangles)
}

#[test]
fn area_length_and_volume() {
    let (vertices, triangles) = patch();
    check(&super::Area { triangles: triangles.clone(), tension: 1.7 }, &vertices, 1e-8);
    check(&super::Volume { triangles, pressure: 0.6 }, &vertices, 1e-8);
    check(&super::Length { segments: vec![[0, 1], [1, 2], [2, 6], [6, 7]], tension: 2.5 }, &vertices, 1e-8);
}

#[test]
fn the_shift_adds_a_semidefinite_part() {
    let (vertices, triangles) = patch();
    let terms: [&dyn Term; 2] =
        [&super::Area { triangles, tension: 1.0 }, &super::Length { segments: vec![[0, 1], [1, 2]], tension: 1.0 }];
    for term in terms {
        let direction: Vec<DVec3> =
            (0..vertices.len()).map(|k| DVec3::new(libm::sin(k as f64), 0.3, libm::cos(k as f64))).collect();
        let along = |shift: f64| {
            let mut sum = 0.0;
            term.add_second_derivative(&vertices, shift, &mut |v, w, block| {
                sum += direction[v as usize].dot(block * direction[w as usize]);
            });
            sum
        };
        assert!(along(1.0) > along(0.0));
        assert!((along(2.0) - along(1.0) - (along(1.0) - along(0.0))).abs() < 1e-9);
    }
}

#[test]
fn the_volume_of_a_tetrahedron_and_the_shares_of_an_area() {
    let vertices = vec![DVec3::ONE, DVec3::new(2.0, 1.0, 1.0), DVec3::new(1.0, 3.0, 1.0), DVec3::new(1.0, 1.0, 4.0)];
    let triangles = vec![[0, 2, 1], [0, 1, 3], [1, 2, 3], [2, 0, 3]];
    let volume = super::Volume { triangles: triangles.clone(), pressure: -1.0 };
    assert!((volume.value(&vertices) - 1.0).abs() < 1e-14, "1/6 of 1 · 2 · 3, wherever the origin is");
    let area = super::Area { triangles, tension: 3.0 };
    let mut shares = vec![0.0; 4];
    area.add_shares(&vertices, &mut shares);
    assert!((shares.iter().sum::<f64>() - area.value(&vertices)).abs() < 1e-12);
}
