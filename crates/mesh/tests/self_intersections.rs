//! Compares the search for self-intersections with a brute-force method that decides every pair of triangles with exact
//! fractions.

#![allow(clippy::disallowed_methods, reason = "this is a test")]

use plateau_mesh::random::SplitMix64;
use plateau_mesh::self_intersections::{Order, SelfIntersections, self_intersections, surfaces_cross};
use plateau_mesh::{DVec3, Execution, Interruption, Signal};
use std::cell::Cell;

/// A random integer from `-reach` to `reach`.
fn whole(random: &mut SplitMix64, reach: i64) -> i64 {
    random.below(2 * reach as usize + 1) as i64 - reach
}

type Vector = [i128; 3];

/// A point with rational coordinates: `point` divided by the positive common denominator `over`.
#[derive(Clone, Copy, Debug)]
struct Fraction {
    point: Vector,
    over: i128,
}

fn minus(a: Vector, b: Vector) -> Vector {
    [0, 1, 2].map(|k| a[k] - b[k])
}
fn cross(a: Vector, b: Vector) -> Vector {
    [a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]]
}
fn dot(a: Vector, b: Vector) -> i128 {
    a[0] * b[0] + a[1] * b[1] + a[2] * b[2]
}
fn normal([a, b, c]: [Vector; 3]) -> Vector {
    cross(minus(b, a), minus(c, a))
}

/// Whether a point anywhere in space belongs to the closed triangle.
fn contains(triangle: [Vector; 3], at: Fraction) -> bool {
    let n = normal(triangle);
    let from = |corner: Vector| [0, 1, 2].map(|k| at.point[k] - at.over * corner[k]);
    dot(n, from(triangle[0])) == 0
        && (0..3).all(|k| dot(n, cross(minus(triangle[(k + 1) % 3], triangle[k]), from(triangle[k]))) >= 0)
}

/// All points that can be a corner of the intersection of two triangles.
fn candidates(one: [Vector; 3], other: [Vector; 3]) -> Vec<Fraction> {
    let mut found: Vec<Fraction> = one.iter().chain(&other).map(|&point| Fraction { point, over: 1 }).collect();
    // Points where an edge of one triangle passes through the plane of the other.
    for (edges, plane) in [(one, other), (other, one)] {
        let n = normal(plane);
        for k in 0..3 {
            let (p, q) = (edges[k], edges[(k + 1) % 3]);
            let (above, below) = (dot(n, minus(p, plane[0])), dot(n, minus(q, plane[0])));
            if above.signum() * below.signum() < 0 {
                let (over, sign) = ((above - below).abs(), (above - below).signum());
                found.push(Fraction { point: [0, 1, 2].map(|i| sign * (above * q[i] - below * p[i])), over });
            }
        }
    }
    // Points where two edges that lie in one plane meet.
    for k in 0..3 {
        for l in 0..3 {
            let (p, q, r, s) = (one[k], one[(k + 1) % 3], other[l], other[(l + 1) % 3]);
            let (u, v) = (minus(q, p), minus(s, r));
            let n = cross(u, v);
            if n != [0; 3] && dot(n, minus(r, p)) == 0 {
                let (over, along) = (dot(n, n), dot(cross(minus(r, p), v), n));
                found.push(Fraction { point: [0, 1, 2].map(|i| over * p[i] + along * u[i]), over });
            }
        }
    }
    found
}

fn is_between(at: Fraction, [a, b]: [Vector; 2]) -> bool {
    let from = |end: Vector| [0, 1, 2].map(|k| at.point[k] - at.over * end[k]);
    cross(from(a), from(b)) == [0; 3] && dot(from(a), from(b)) <= 0
}

/// Whether two triangles with an area meet in more than the corners that they share.
fn intersect(one: [Vector; 3], other: [Vector; 3]) -> bool {
    let shared: Vec<Vector> = one.iter().copied().filter(|corner| other.contains(corner)).collect();
    let is_shared = |at: &Fraction| match shared[..] {
        [] => false,
        [a] => [0, 1, 2].iter().all(|&k| at.point[k] == at.over * a[k]),
        [a, b] => is_between(*at, [a, b]),
        _ => false,
    };
    candidates(one, other).iter().any(|at| contains(one, *at) && contains(other, *at) && !is_shared(at))
}

struct Whole {
    vertices: Vec<[i64; 3]>,
    triangles: Vec<[u32; 3]>,
}

impl Whole {
    fn brute_force(&self) -> u64 {
        let solid: Vec<[Vector; 3]> = self
            .triangles
            .iter()
            .map(|t| t.map(|v| self.vertices[v as usize].map(i128::from)))
            .filter(|&t| normal(t) != [0; 3])
            .collect();
        let mut pairs = 0;
        for k in 0..solid.len() {
            pairs += solid[..k].iter().filter(|&&other| intersect(solid[k], other)).count() as u64;
        }
        pairs
    }
    fn points(&self) -> Vec<DVec3> {
        self.vertices.iter().map(|v| DVec3::new(v[0] as f64, v[1] as f64, v[2] as f64)).collect()
    }
}

fn found(vertices: &[DVec3], triangles: &[[u32; 3]], order: Order) -> SelfIntersections {
    self_intersections(vertices, triangles, order, u64::MAX, &Execution::default()).unwrap()
}

/// Random triangles over a few points, many of which touch, overlap or repeat others.
fn soup(random: &mut SplitMix64) -> Whole {
    let count = 6 + random.below(20);
    let reach = 1 + random.below(6) as i64;
    let vertices = (0..count).map(|_| [whole(random, reach), whole(random, reach), whole(random, reach)]).collect();
    let triangles = (0..2 + random.below(30)).map(|_| [0; 3].map(|_: u32| random.below(count) as u32)).collect();
    Whole { vertices, triangles }
}

/// A net of squares, bent and folded, which is mostly embedded and may cross itself in places.
fn net(random: &mut SplitMix64) -> Whole {
    let (m, n) = (2 + random.below(5) as i64, 2 + random.below(5) as i64);
    let (noise, lift) = (random.below(4) as i64, random.below(12) as i64);
    let closed = random.below(3) == 0;
    let at = |i: i64, j: i64| {
        if closed {
            let ring = [[6, 0], [4, 4], [0, 6], [-4, 4], [-6, 0], [-4, -4], [0, -6], [4, -4]];
            let [x, y] = ring[(j % 8) as usize];
            [x, y, 5 * i]
        } else {
            [5 * i, 5 * j, 0]
        }
    };
    let columns = if closed { 8 } else { n };
    let mut vertices = Vec::new();
    for i in 0..m {
        for j in 0..columns {
            let [x, y, z] = at(i, j);
            vertices.push([x + whole(random, noise), y + whole(random, noise), z + whole(random, lift)]);
        }
    }
    let mut triangles = Vec::new();
    let number = |i: i64, j: i64| (i * columns + j % columns) as u32;
    for i in 0..m - 1 {
        for j in 0..if closed { columns } else { columns - 1 } {
            let [a, b, c, d] = [number(i, j), number(i + 1, j), number(i + 1, j + 1), number(i, j + 1)];
            triangles.extend([[a, b, c], [a, c, d]]);
        }
    }
    Whole { vertices, triangles }
}

/// Long thin triangles between two polylines, with fans.
fn strip(random: &mut SplitMix64) -> Whole {
    let (m, n) = (1 + random.below(16), 2 + random.below(16));
    let side = |random: &mut SplitMix64, count: usize, y: i64| -> Vec<[i64; 3]> {
        let noise = random.below(4) as i64;
        (0..count as i64)
            .map(|k| [2 * k + whole(random, noise), y + whole(random, noise), whole(random, noise)])
            .collect()
    };
    let mut vertices = side(random, m, 0);
    vertices.extend(side(random, n, 40));
    let (mut i, mut j) = (0, 0);
    let mut triangles = Vec::new();
    while i + 1 < m || j + 1 < n {
        if j + 1 == n || (i + 1 < m && random.below(2) == 0) {
            triangles.push([i as u32, i as u32 + 1, (m + j) as u32]);
            i += 1;
        } else {
            triangles.push([i as u32, (m + j + 1) as u32, (m + j) as u32]);
            j += 1;
        }
    }
    Whole { vertices, triangles }
}

#[test]
fn the_tree_and_the_brute_force_agree_on_a_thousand_meshes() {
    let long = if std::env::var_os("PLATEAU_LONG").is_some() { 20 } else { 1 };
    let mut random = SplitMix64::new(16);
    let (mut without, mut with) = ([0; 3], [0; 3]);
    for case in 0..1000 * long {
        let kind = case % 3;
        let mesh = match kind {
            0 => soup(&mut random),
            1 => net(&mut random),
            _ => strip(&mut random),
        };
        let expected = mesh.brute_force();
        // The mesh is checked in three forms: as it is, then reflected, scaled and moved without rounding, and with
        // every vertex stored twice.
        let points = mesh.points();
        let moved: Vec<DVec3> = points.iter().map(|p| DVec3::new(-p.z, p.x, p.y) * 0.125 + 1e6).collect();
        let twice: Vec<DVec3> = points.iter().chain(&points).copied().collect();
        let split: Vec<[u32; 3]> =
            mesh.triangles.iter().enumerate().map(|(k, t)| t.map(|v| v + (k % 2 * points.len()) as u32)).collect();
        for order in [Order::AsGiven, Order::Spatial] {
            for (points, triangles) in [(&points, &mesh.triangles), (&moved, &mesh.triangles), (&twice, &split)] {
                let found = found(points, triangles, order);
                assert!(found.complete);
                assert_eq!(found.pairs, expected, "case {case} {order:?}: {points:?} {triangles:?}");
                assert_eq!(found.place.is_some(), expected > 0);
            }
        }
        if expected == 0 { without[kind] += 1 } else { with[kind] += 1 }
    }
    // Each kind has meshes with intersections and meshes without.
    assert!(without.iter().chain(&with).all(|&count| count > 15), "{without:?} {with:?}");
}

/// A fan whose rim wanders around its vertex, or stays on one side of it.
fn fan(random: &mut SplitMix64) -> Whole {
    let (count, reach) = (66 + random.below(40), [40, 400][random.below(2)]);
    let (noise, shift, turns) =
        (random.below(reach / 8) as i64, random.below(reach) as i64, 0.3 + random.between(0.0, 2.0));
    let rise = random.between(-1.0, 1.0);
    let mut vertices = vec![[1, -2, 3]];
    for k in 0..=count {
        let angle = turns * std::f64::consts::TAU * k as f64 / count as f64;
        let at = [angle.cos(), angle.sin(), rise * angle / 6.0].map(|x| (reach as f64 * x) as i64);
        vertices.push([
            at[0] + whole(random, noise),
            at[1] + whole(random, noise),
            at[2] + shift + whole(random, noise),
        ]);
    }
    Whole { vertices, triangles: (1..=count as u32).map(|k| [0, k, k + 1]).collect() }
}

#[test]
fn the_arcs_of_a_large_fan_find_the_pairs_of_the_brute_force() {
    let mut random = SplitMix64::new(45);
    let (mut without, mut with) = (0, 0);
    for case in 0..60 {
        let mesh = fan(&mut random);
        let expected = mesh.brute_force();
        for order in [Order::AsGiven, Order::Spatial] {
            let found = found(&mesh.points(), &mesh.triangles, order);
            assert_eq!(found.pairs, expected, "case {case} {order:?}: {:?}", mesh.vertices);
        }
        if expected == 0 { without += 1 } else { with += 1 }
    }
    assert!(without > 5 && with > 20, "{without} {with}");
}

/// A flat sheet, and a wavy sheet at a distance above it. The wavy sheet is also moved sideways, so that none of its
/// edges lies above an edge of the flat sheet.
fn two_planes(distance: f64) -> (Vec<DVec3>, Vec<[u32; 3]>) {
    let n = 60u32;
    let mut vertices = Vec::new();
    for sheet in 0..2 {
        for i in 0..=n {
            for j in 0..=n {
                let (x, y) = (f64::from(i) / f64::from(n), f64::from(j) / f64::from(n));
                vertices.push(if sheet == 0 {
                    DVec3::new(x, y, 0.0)
                } else {
                    DVec3::new(x + 0.0041, y + 0.0057, distance + 0.3 * (7.0 * x).sin() * (5.0 * y).cos())
                });
            }
        }
    }
    let mut triangles = Vec::new();
    for sheet in 0..2 {
        let at = |i: u32, j: u32| sheet * (n + 1) * (n + 1) + i * (n + 1) + j;
        for i in 0..n {
            for j in 0..n {
                triangles
                    .extend([[at(i, j), at(i + 1, j), at(i + 1, j + 1)], [at(i, j), at(i + 1, j + 1), at(i, j + 1)]]);
            }
        }
    }
    (vertices, triangles)
}

#[test]
fn sheets_that_pass_through_each_other_are_found_with_a_place_on_both() {
    let (vertices, triangles) = two_planes(0.1);
    let crossing = found(&vertices, &triangles, Order::Spatial);
    let place = crossing.place.expect("they cross");
    assert!(crossing.pairs > 100 && place.z.abs() < 1e-12);
    assert!((0.1 + 0.3 * (7.0 * (place.x - 0.0041)).sin() * (5.0 * (place.y - 0.0057)).cos()).abs() < 0.01, "{place}");
    let half = triangles.len() / 2;
    let cross =
        |a: &[[u32; 3]], b: &[[u32; 3]]| surfaces_cross((&vertices, a), (&vertices, b), &Execution::default()).unwrap();
    assert!(cross(&triangles[..half], &triangles[half..]));
    assert!(!cross(&triangles[..half], &triangles[..half]), "lying in one plane is not crossing");
    let (apart, _) = two_planes(0.31);
    assert_eq!(found(&apart, &triangles, Order::Spatial), SelfIntersections { complete: true, ..Default::default() });
}

#[test]
fn a_large_fan_and_a_long_strip_take_little_more_than_linear_work() {
    let work = |vertices: &[DVec3], triangles: &[[u32; 3]]| {
        let execution = Execution::default();
        let found = self_intersections(vertices, triangles, Order::AsGiven, u64::MAX, &execution).unwrap();
        assert_eq!(found.pairs, 0);
        assert!(execution.largest_work_between_looks() <= 1 << 18);
        execution.work() as f64 / triangles.len() as f64
    };
    let cone = |count: u32| {
        let ring = (0..count).map(|k| std::f64::consts::TAU * f64::from(k) / f64::from(count));
        let mut vertices = vec![DVec3::Z];
        vertices.extend(ring.map(|a| DVec3::new(a.cos(), a.sin(), 0.0)));
        let triangles: Vec<[u32; 3]> = (0..count).map(|k| [0, 1 + k, 1 + (k + 1) % count]).collect();
        work(&vertices, &triangles)
    };
    assert!(cone(20_000) < 2.0 * cone(1_000) + 10.0, "{} {}", cone(1_000), cone(20_000));
    // A spiral ramp around one vertex: no plane through that vertex has all triangles on one side.
    let spiral = |count: u32| {
        let angle = |k: u32| 9.0 * f64::from(k) / f64::from(count);
        let rim = (0..=count).map(|k| DVec3::new(angle(k).cos(), angle(k).sin(), 0.2 * angle(k)));
        let vertices: Vec<DVec3> = std::iter::once(DVec3::ZERO).chain(rim).collect();
        let triangles: Vec<[u32; 3]> = (1..=count).map(|k| [0, k, k + 1]).collect();
        work(&vertices, &triangles)
    };
    assert!(spiral(20_000) < 2.0 * spiral(1_000) + 10.0, "{} {}", spiral(1_000), spiral(20_000));
    // A ramp of about two turns with slanted bridges, a thousand times as long as wide.
    let ramp = |count: u32| {
        let rail = |radius: f64, turn: f64| -> Vec<DVec3> {
            let angle = |k: u32| 12.0 * f64::from(k) / f64::from(count);
            (0..count)
                .map(|k| DVec3::new(radius * (angle(k) + turn).cos(), radius * (angle(k) + turn).sin(), angle(k)))
                .collect()
        };
        let vertices = [rail(1.0, 0.0), rail(3.0, 0.5)].concat();
        let triangles: Vec<[u32; 3]> =
            (0..count - 1).flat_map(|k| [[k, k + 1, count + k], [k + 1, count + k + 1, count + k]]).collect();
        work(&vertices, &triangles)
    };
    assert!(ramp(20_000) < 2.0 * ramp(1_000) + 10.0, "{} {}", ramp(1_000), ramp(20_000));
}

#[test]
fn a_search_stops_when_asked_and_gives_up_when_its_work_is_used_up() {
    let (vertices, triangles) = two_planes(0.1);
    let looks = Cell::new(0);
    let stop = || {
        looks.set(looks.get() + 1);
        if looks.get() > 5 { Signal::Cancel } else { Signal::Continue }
    };
    let stopped = self_intersections(&vertices, &triangles, Order::Spatial, u64::MAX, &Execution::new(&stop, &|_| {}));
    assert_eq!(stopped, Err(Interruption::Cancelled));
    // Many sheets in one place: every pair of boxes meets.
    let piled: Vec<[u32; 3]> = (0..4000).map(|_| triangles[0]).collect();
    let given_up = self_intersections(&vertices, &piled, Order::AsGiven, 100_000, &Execution::default()).unwrap();
    assert!(!given_up.complete && given_up.pairs > 0 && given_up.pairs < 4000 * 3999 / 2, "{given_up:?}");
}
