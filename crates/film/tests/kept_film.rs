//! Tests of a solved film that follows its boundary while the user drags the boundary.

#![allow(clippy::disallowed_methods, reason = "this is a test")]

use plateau_film::minimal_surface::{KeptFilm, Options, Resolution, solve};
use plateau_mesh::{DVec3, Execution};

/// A square with curved sides, one corner of which is raised by `height`.
fn square(height: f64) -> Vec<DVec3> {
    let corners = [DVec3::ZERO, DVec3::new(1.0, 0.0, 0.5), DVec3::new(1.0, 1.0, height), DVec3::new(0.0, 1.0, 0.5)];
    let side = |k: usize| {
        (0..8).map(move |i| {
            let t = f64::from(i) / 8.0;
            corners[k] + t * (corners[(k + 1) % 4] - corners[k]) + DVec3::Z * (0.2 * t * (1.0 - t))
        })
    };
    (0..4).flat_map(side).collect()
}

fn keep(boundaries: &[Vec<DVec3>], triangles: usize) -> KeptFilm {
    let options = Options::new(Resolution::Triangles(triangles));
    let exec = Execution::default();
    let surface = solve(boundaries, &options, &exec).unwrap();
    KeptFilm::new(&surface.mesh, &surface.boundaries, boundaries, &options, &exec).unwrap().unwrap()
}

fn distance(a: &[DVec3], b: &[DVec3]) -> f64 {
    a.iter().zip(b).map(|(a, b)| a.distance(*b)).fold(0.0, f64::max)
}

fn vertices(film: &KeptFilm) -> Vec<DVec3> {
    film.vertices().collect()
}

#[test]
fn a_moved_film_is_the_minimal_surface_of_its_boundary() {
    let mut film = keep(&[square(0.0)], 2000);
    let there = [square(0.3)];
    let moved = film.move_to(&there, &Execution::default()).unwrap().unwrap();
    let solved = solve(&there, &Options::new(Resolution::Triangles(2000)), &Execution::default()).unwrap();
    assert!(moved.residual <= 1e-4);
    assert!((moved.area / solved.statistics.area - 1.0).abs() < 1e-3, "{} {}", moved.area, solved.statistics.area);
    assert_eq!(vertices(&film)[..32], there[0][..]);
}

#[test]
fn the_way_to_a_place_does_not_matter() {
    let exec = Execution::default();
    let (mut straight, mut around) = (keep(&[square(0.0)], 2000), keep(&[square(0.0)], 2000));
    straight.move_to(&[square(0.2)], &exec).unwrap().unwrap();
    for height in [0.1, -0.2, -0.1, 0.05, 0.3, 0.2] {
        around.move_to(&[square(height)], &exec).unwrap().unwrap();
    }
    let apart = distance(&vertices(&straight), &vertices(&around));
    // The vertices follow the boundary step by step, so after a detour they lie elsewhere on the same surface.
    assert!(apart < 2e-3, "{apart}");
}

#[test]
fn a_turned_enlarged_and_far_film_moves_alike() {
    let exec = Execution::default();
    // A rotation by 0.7 about a slanted axis.
    let axis = DVec3::new(2.0, 3.0, 6.0) / 7.0;
    let (sine, cosine) = (0.7f64.sin(), 0.7f64.cos());
    let turn = |p: DVec3| cosine * p + sine * axis.cross(p) + (1.0 - cosine) * axis.dot(p) * axis;
    let mut film = keep(&[square(0.0)], 500);
    film.move_to(&[square(0.2)], &exec).unwrap().unwrap();
    let expected = vertices(&film);
    for (scale, offset, tolerance) in [(1.0, 1e7, 1e-7), (1e6, 0.0, 1e-9), (1e-6, 0.0, 1e-9)] {
        let offset = DVec3::new(offset, -offset, offset);
        let place = |point: DVec3| scale * turn(point) + offset;
        let placed = |height: f64| [square(height).into_iter().map(place).collect::<Vec<DVec3>>()];
        // The solved mesh itself is moved. A new solve at the other place might choose another mesh because of
        // rounding.
        let options = Options::new(Resolution::Triangles(500));
        let mut solved = solve(&[square(0.0)], &options, &exec).unwrap();
        solved.mesh.vertices.iter_mut().for_each(|vertex| *vertex = place(*vertex));
        let kept = KeptFilm::new(&solved.mesh, &solved.boundaries, &placed(0.0), &options, &exec);
        let mut film = kept.unwrap().unwrap();
        film.move_to(&placed(0.2), &exec).unwrap().unwrap();
        let expected: Vec<DVec3> = expected.iter().map(|&vertex| place(vertex)).collect();
        let apart = distance(&vertices(&film), &expected) / scale;
        assert!(apart < tolerance, "{scale} {offset}: {apart}");
    }
}

#[test]
fn a_film_that_cannot_follow_stays_where_it_is() {
    let exec = Execution::default();
    let mut film = keep(&[square(0.0)], 500);
    let before = vertices(&film);
    let fewer = square(0.0)[1..].to_vec();
    let mut across = square(0.0);
    across[16] = DVec3::new(0.1, 0.1, 0.0);
    let mut nowhere = square(0.0);
    nowhere[3].x = f64::NAN;
    for boundary in [fewer, across, nowhere] {
        assert_eq!(film.move_to(&[boundary], &exec), Ok(None));
        assert_eq!(vertices(&film), before);
    }
}
