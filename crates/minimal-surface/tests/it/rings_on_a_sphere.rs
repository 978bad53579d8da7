//! Three to twelve rings that face outwards on a sphere. Their connected film is compared with the film to which their
//! convex hull relaxes.

use plateau_mesh::random::SplitMix64;
use plateau_mesh::self_intersections::{self, Order};
use plateau_mesh::{DVec3, Error, Execution, Mesh};
use plateau_minimal_surface::{InitialMesh, MinimalSurface, Options, Resolution, solve};
use robust::{Coord3D, orient3d};
use std::collections::BTreeMap;
use std::f64::consts::TAU;
use std::time::Instant;

/// Returns a random unit vector, uniform on the sphere.
fn direction(random: &mut SplitMix64) -> DVec3 {
    let (z, angle) = (random.between(-1.0, 1.0), TAU * random.unit());
    let r = (1.0 - z * z).sqrt();
    DVec3::new(r * angle.cos(), r * angle.sin(), z)
}

/// Returns rings of random points around random centres that repel each other. The angular radius of each ring is 0.95
/// of half the smallest angle from its centre to another centre.
fn configuration(random: &mut SplitMix64, rings: usize) -> Vec<Vec<DVec3>> {
    let mut centres: Vec<DVec3> = (0..rings).map(|_| direction(random)).collect();
    for round in 0..200 {
        let step = 0.2 / (1.0 + 0.05 * f64::from(round)) / rings as f64;
        let forces: Vec<DVec3> = centres
            .iter()
            .map(|&c| centres.iter().filter(|&&o| o != c).map(|&o| (c - o) / c.distance(o).max(0.05).powi(3)).sum())
            .collect();
        centres
            .iter_mut()
            .zip(forces)
            .for_each(|(c, force)| *c = (*c + step * force.clamp_length_max(2.0)).normalize());
    }
    let ring = |(k, &centre): (usize, &DVec3), random: &mut SplitMix64| {
        let others = (0..rings).filter(|&other| other != k);
        let nearest = others.map(|other| centre.angle_between(centres[other])).fold(f64::INFINITY, f64::min);
        let (sin, cos) = (0.95 * 0.5 * nearest).sin_cos();
        let (u, v) = centre.any_orthonormal_pair();
        let points = 30 + random.below(31);
        let (start, sense) = (TAU * random.unit(), if random.below(2) == 0 { 1.0 } else { -1.0 });
        let angle = |i: usize| start + sense * TAU * i as f64 / points as f64;
        (0..points).map(|i| cos * centre + sin * (angle(i).cos() * u + angle(i).sin() * v)).collect()
    };
    let mut boundaries: Vec<Vec<DVec3>> = centres.iter().enumerate().map(|entry| ring(entry, random)).collect();
    for k in (1..rings).rev() {
        boundaries.swap(k, random.below(k + 1));
    }
    boundaries
}

/// Returns the triangles of the convex hull, facing outwards. The hull starts as the tetrahedron of the points `first`,
/// and the other points are added one by one.
fn hull(points: &[DVec3], first: [u32; 4]) -> Vec<[u32; 3]> {
    let coord = |v: u32| {
        let p = points[v as usize];
        Coord3D { x: p.x, y: p.y, z: p.z }
    };
    let sees = |[a, b, c]: [u32; 3], p: u32| orient3d(coord(a), coord(b), coord(c), coord(p)) < 0.0;
    let [a, b, c, d] = first;
    let mut faces: Vec<[u32; 3]> = [[a, b, c, d], [a, b, d, c], [b, c, d, a], [c, a, d, b]]
        .map(|[a, b, c, opposite]| if sees([a, b, c], opposite) { [a, c, b] } else { [a, b, c] })
        .to_vec();
    for p in (0..points.len() as u32).filter(|p| !first.contains(p)) {
        let (seen, hidden): (Vec<[u32; 3]>, Vec<[u32; 3]>) = faces.iter().partition(|&&face| sees(face, p));
        let edges: Vec<[u32; 2]> = seen.iter().flat_map(|&[a, b, c]| [[a, b], [b, c], [c, a]]).collect();
        faces = hidden;
        faces.extend(edges.iter().filter(|&&[a, b]| !edges.contains(&[b, a])).map(|&[a, b]| [a, b, p]));
    }
    faces
}

/// Halves every edge that has two triangles.
fn halved(mesh: &Mesh) -> Mesh {
    let sides = |[a, b, c]: [u32; 3]| [[a, b], [b, c], [c, a]];
    let key = |[a, b]: [u32; 2]| (a.min(b), a.max(b));
    let mut triangles_at: BTreeMap<(u32, u32), u32> = BTreeMap::new();
    mesh.triangles.iter().flat_map(|&t| sides(t)).for_each(|side| *triangles_at.entry(key(side)).or_default() += 1);
    let mut vertices = mesh.vertices.clone();
    let mut middle: BTreeMap<(u32, u32), u32> = BTreeMap::new();
    for (&(a, b), _) in triangles_at.iter().filter(|(_, count)| **count == 2) {
        middle.insert((a, b), vertices.len() as u32);
        vertices.push(0.5 * (vertices[a as usize] + vertices[b as usize]));
    }
    let mut triangles = Vec::new();
    for &triangle in &mesh.triangles {
        let at = |side: [u32; 2]| middle.get(&key(side)).copied();
        // The corners are rotated so that the sides that are halved come first.
        let turns = (0..3).map(|k| [triangle[k], triangle[(k + 1) % 3], triangle[(k + 2) % 3]]);
        let halves = |t: &[u32; 3]| sides(*t).map(|side| at(side).is_some());
        let [a, b, c] = turns.max_by_key(halves).unwrap();
        match sides([a, b, c]).map(at) {
            [Some(ab), Some(bc), Some(ca)] => triangles.extend([[a, ab, ca], [ab, b, bc], [ca, bc, c], [ab, bc, ca]]),
            [Some(ab), Some(bc), None] => triangles.extend([[ab, b, bc], [a, ab, bc], [a, bc, c]]),
            [Some(ab), None, None] => triangles.extend([[a, ab, c], [ab, b, c]]),
            _ => triangles.push([a, b, c]),
        }
    }
    Mesh { vertices, triangles }
}

/// Returns the film to which the convex hull relaxes. The caps of the hull, whose triangles have all corners on one
/// ring, are left out.
fn reference(boundaries: &[Vec<DVec3>]) -> MinimalSurface {
    let points: Vec<DVec3> = boundaries.iter().flatten().copied().collect();
    let ring: Vec<usize> = boundaries.iter().enumerate().flat_map(|(k, points)| vec![k; points.len()]).collect();
    let third = boundaries[0].len() as u32;
    let triangles = hull(&points, [0, third / 3, 2 * third / 3, third])
        .into_iter()
        .filter(|t| !t.iter().all(|&v| ring[v as usize] == ring[t[0] as usize]))
        .collect();
    let mesh = halved(&halved(&Mesh { vertices: points, triangles }));
    let count = mesh.triangles.len();
    let options = Options { initial_mesh: InitialMesh::Given(mesh), ..Options::new(Resolution::Triangles(count)) };
    solve(boundaries, &options, &Execution::default()).expect("the hull is a valid start")
}

#[derive(Default)]
struct Count {
    all: u32,
    found: u32,
    crossing: u32,
    seconds: f64,
}

#[test]
fn the_connected_film_of_rings_on_a_sphere_is_found() {
    // Configurations of 3 to 12 rings, in the first tier of `scripts/test` of 3 to 7.
    let configurations = match (std::env::var_os("PLATEAU_LONG").is_some(), crate::is_full()) {
        (true, _) => 200,
        (false, true) => 10,
        (false, false) => 5,
    };
    let mut random = SplitMix64::new(1);
    let mut counts: BTreeMap<usize, Count> = BTreeMap::new();
    for case in 0..configurations {
        let rings = 3 + case % 10;
        let boundaries = configuration(&mut random, rings);
        let expected = reference(&boundaries).statistics;
        let count = counts.entry(rings).or_default();
        let started = Instant::now();
        let solved: Result<MinimalSurface, Error> =
            solve(&boundaries, &Options::new(Resolution::Triangles(3000)), &Execution::default());
        count.seconds += started.elapsed().as_secs_f64();
        count.all += 1;
        let surface = solved.unwrap_or_else(|refused| panic!("case {case}, {rings} rings: {refused}"));
        let statistics = surface.statistics;
        let check = self_intersections::check(&surface.mesh, Order::Spatial, usize::MAX, &Execution::default());
        let pairs = check.unwrap().0.pairs.expect("all pairs are looked at");
        count.crossing += u32::from(pairs > 0);
        let is_film = statistics.converged && statistics.components == 1 && pairs == 0;
        let found = is_film && statistics.area < expected.area * 1.01;
        count.found += u32::from(found);
        if !found {
            println!(
                "case {case}, {rings} rings: area {} for {} ({}), {pairs} pairs, converged {}",
                statistics.area, expected.area, expected.converged, statistics.converged
            );
        }
    }
    for (rings, Count { all, found, crossing, seconds }) in &counts {
        let mean = seconds / f64::from(*all);
        println!("{rings} rings: {found} of {all} found, {crossing} cross themselves, {mean:.2} s each");
    }
    let (all, found) = counts.values().fold((0, 0), |(all, found), count| (all + count.all, found + count.found));
    assert!(f64::from(found) >= 0.95 * f64::from(all), "{found} of {all}");
}
