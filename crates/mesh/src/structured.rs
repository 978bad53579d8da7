//! Films on structured grids whose exact surface is known, for the tests of the solvers.

use crate::DVec3;
use crate::film::Film;

/// A grid of `nu` x `nv` cells with alternating diagonals. `at` maps (0..=1, 0..=1) to space. The boundary is fixed.
pub fn patch(nu: usize, nv: usize, at: impl Fn(f64, f64) -> DVec3) -> Film {
    let index = |i: usize, j: usize| (i * (nv + 1) + j) as u32;
    let mut vertices = Vec::new();
    for i in 0..=nu {
        vertices.extend((0..=nv).map(|j| at(i as f64 / nu as f64, j as f64 / nv as f64)));
    }
    let mut triangles = Vec::new();
    for i in 0..nu {
        for j in 0..nv {
            let [a, b, c, d] = [index(i, j), index(i + 1, j), index(i + 1, j + 1), index(i, j + 1)];
            triangles.extend(if (i + j) % 2 == 0 { [[a, b, c], [a, c, d]] } else { [[a, b, d], [b, c, d]] });
        }
    }
    let mut rim: Vec<u32> = (0..nu).map(|i| index(i, 0)).collect();
    rim.extend((0..nv).map(|j| index(nu, j)));
    rim.extend((1..=nu).rev().map(|i| index(i, nv)));
    rim.extend((1..=nv).rev().map(|j| index(0, j)));
    Film::new(vertices, &triangles, vec![rim]).expect("a grid is a manifold")
}

/// Two circles of radius 1, `gap` apart, joined by a cylinder of `rings` strips of `2 n` triangles.
pub fn cylinder(n: usize, rings: usize, gap: f64) -> Film {
    let index = |i: usize, j: usize| (i * n + j % n) as u32;
    let mut vertices = Vec::new();
    for i in 0..=rings {
        let z = gap * (i as f64 / rings as f64 - 0.5);
        vertices.extend((0..n).map(|j| {
            let angle = std::f64::consts::TAU * j as f64 / n as f64;
            DVec3::new(libm::cos(angle), libm::sin(angle), z)
        }));
    }
    let mut triangles = Vec::new();
    for i in 0..rings {
        for j in 0..n {
            let [a, b, c, d] = [index(i, j), index(i, j + 1), index(i + 1, j + 1), index(i + 1, j)];
            triangles.extend(if (i + j) % 2 == 0 { [[a, b, c], [a, c, d]] } else { [[a, b, d], [b, c, d]] });
        }
    }
    let ring = |i: usize| (0..n).map(|j| index(i, j)).collect();
    Film::new(vertices, &triangles, vec![ring(0), ring(rings)]).expect("a cylinder is a manifold")
}

/// The helicoid x = u cos v, y = u sin v, z = v over u 2..10, v -1..10 (Chen, Cai, Zheng).
pub fn helicoid(u: f64, v: f64) -> DVec3 {
    let (u, v) = (2.0 + 8.0 * u, -1.0 + 11.0 * v);
    DVec3::new(u * libm::cos(v), u * libm::sin(v), v)
}

/// The catenoid x = cosh v cos u, … over |u| <= `sector` / 2, |v| <= `reach`.
pub fn catenoid(sector: f64, reach: f64) -> impl Fn(f64, f64) -> DVec3 {
    move |u, v| {
        let (u, v) = (sector * (u - 0.5), reach * (2.0 * v - 1.0));
        DVec3::new(libm::cosh(v) * libm::cos(u), libm::cosh(v) * libm::sin(u), v)
    }
}

/// Moves each free vertex to the mean of its neighbours, `sweeps` times, to make a fair start for a solver.
pub fn relax(film: &mut Film, sweeps: usize) {
    for _ in 0..sweeps {
        for v in 0..film.vertices.len() as u32 {
            if !film.fixed[v as usize] {
                let neighbours =
                    film.topology.outgoing_half_edges(v).map(|h| film.vertices[film.topology.to(h) as usize]);
                let (sum, count) = neighbours.fold((DVec3::ZERO, 0.0), |(sum, count), p| (sum + p, count + 1.0));
                film.vertices[v as usize] = sum / count;
            }
        }
    }
}

/// A k x k grid over the unit square, bent into a saddle of the given height, with its inner vertices moved at random.
#[cfg(test)]
pub(crate) fn shaken(k: usize, height: f64) -> Film {
    let at = |i: usize, j: usize| (i * (k + 1) + j) as u32;
    let mut state = 1u64;
    let mut noise = || {
        state = state.wrapping_mul(6_364_136_223_846_793_005).wrapping_add(1);
        (state >> 33) as f64 / 2f64.powi(31) - 0.5
    };
    let mut vertices = Vec::new();
    for i in 0..=k {
        for j in 0..=k {
            let inner = i > 0 && j > 0 && i < k && j < k;
            let shake = if inner { 0.8 / k as f64 } else { 0.0 };
            let (x, y) = (i as f64 / k as f64 + shake * noise(), j as f64 / k as f64 + shake * noise());
            vertices.push(DVec3::new(x, y, height * (x - 0.5) * (y - 0.5)));
        }
    }
    let triangles: Vec<[u32; 3]> = (0..k)
        .flat_map(|i| (0..k).map(move |j| (i, j)))
        .flat_map(|(i, j)| [[at(i, j), at(i + 1, j), at(i + 1, j + 1)], [at(i, j), at(i + 1, j + 1), at(i, j + 1)]])
        .collect();
    let mut boundary: Vec<u32> = (0..k).map(|i| at(i, 0)).collect();
    boundary.extend((0..k).map(|j| at(k, j)));
    boundary.extend((1..=k).rev().map(|i| at(i, k)));
    boundary.extend((1..=k).rev().map(|j| at(0, j)));
    Film::new(vertices, &triangles, vec![boundary]).unwrap()
}
