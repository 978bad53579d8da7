//! Uniform meshes of planar polygons: checks every property that can be verified on a result, for random input.

use plateau_mesh::measure;
use plateau_mesh::random::SplitMix64;
use plateau_mesh::{DVec2, DVec3, Error, Execution};
use plateau_uniform_mesh::{Domain, Objective, Options, UniformMesh, Why, solve};
use proptest::prelude::*;
use proptest::test_runner::RngSeed;
use std::f64::consts::TAU;

fn flat(points: &[[f64; 2]]) -> Vec<DVec3> {
    points.iter().map(|&[x, y]| DVec3::new(x, y, 0.0)).collect()
}

fn polygon(points: &[[f64; 2]]) -> Domain {
    Domain::Polygon { outer: flat(points), holes: Vec::new() }
}

fn run(domain: &Domain, edge_length: f64, objective: Objective) -> Result<UniformMesh, Error> {
    solve(domain, &Options::new(edge_length, objective), &Execution::default())
}

/// Number of random cases: `usual`, a quarter of it in the first tier of `scripts/test`, ten times as many if
/// PLATEAU_LONG is set.
fn cases(usual: u32) -> u32 {
    match (std::env::var_os("PLATEAU_LONG").is_some(), crate::is_full()) {
        (true, _) => 10 * usual,
        (false, true) => usual,
        (false, false) => usual / 4,
    }
}

/// A random convex polygon with inner angles of 90° or more and sides in [1, 2]. The turning angles are chosen at
/// random. Side lengths that close the polygon are then found by alternating projections.
fn admissible(seed: u64) -> Vec<DVec2> {
    let mut random = SplitMix64::new(seed);
    loop {
        let k = 4 + (random.unit() * 36.0) as usize;
        let mut turns: Vec<f64> =
            (0..k).map(|_| -random.unit().max(1e-9).ln() - random.unit().max(1e-9).ln()).collect();
        let total: f64 = turns.iter().sum();
        turns.iter_mut().for_each(|turn| *turn *= TAU / total);
        if k == 4 {
            turns = vec![TAU / 4.0; 4];
        }
        if turns.iter().any(|&turn| turn > TAU / 4.0 + 1e-12) {
            continue;
        }
        let mut angle = random.between(0.0, 6.0);
        let directions: Vec<DVec2> = turns
            .iter()
            .map(|turn| {
                angle += turn;
                DVec2::from_angle(angle)
            })
            .collect();
        let mut lengths: Vec<f64> = (0..k).map(|_| random.between(1.05, 1.95)).collect();
        let (mut xx, mut xy, mut yy) = (0.0, 0.0, 0.0);
        for d in &directions {
            (xx, xy, yy) = (xx + d.x * d.x, xy + d.x * d.y, yy + d.y * d.y);
        }
        let determinant = xx * yy - xy * xy;
        for _ in 0..500 {
            let gap: DVec2 = directions.iter().zip(&lengths).map(|(d, l)| *d * *l).sum();
            let m = DVec2::new(yy * gap.x - xy * gap.y, xx * gap.y - xy * gap.x) / determinant;
            for (l, d) in lengths.iter_mut().zip(&directions) {
                *l -= d.dot(m);
            }
            if lengths.iter().all(|&l| l > 1.0 + 1e-6 && l < 2.0 - 1e-6) {
                let mut at = DVec2::ZERO;
                return directions
                    .iter()
                    .zip(&lengths)
                    .map(|(d, l)| {
                        at += *d * *l;
                        at
                    })
                    .collect();
            }
            lengths.iter_mut().for_each(|l| *l = l.clamp(1.0 + 1e-5, 2.0 - 1e-5));
        }
    }
}

fn area(polygon: &[DVec2]) -> f64 {
    let twice: f64 = (0..polygon.len()).map(|k| polygon[k].perp_dot(polygon[(k + 1) % polygon.len()])).sum();
    twice / 2.0
}

fn incircle(a: DVec2, b: DVec2, c: DVec2, d: DVec2) -> f64 {
    let (a, b, c) = (a - d, b - d, c - d);
    a.length_squared() * b.perp_dot(c) + b.length_squared() * c.perp_dot(a) + c.length_squared() * a.perp_dot(b)
}

/// Checks everything that must hold for any result on a planar domain of the given area (in the plane z = 0, facing
/// up).
fn check_valid(result: &UniformMesh, area: f64, edge_length: f64, loops: usize) {
    let topology = result.mesh.check().unwrap();
    assert_eq!(topology.boundary_loops().len(), loops);
    assert_eq!(topology.components(), 1);
    assert_eq!(topology.euler_characteristic(), 2 - loops as i64);
    let mut covered = 0.0;
    for &t in &result.mesh.triangles {
        let double = measure::double_area_vector(result.mesh.corners(t));
        assert!(double.z > 0.0 && double.x == 0.0 && double.y == 0.0);
        assert!(!measure::is_degenerate(result.mesh.corners(t)));
        covered += double.z / 2.0;
    }
    assert!((covered - area).abs() <= 1e-9 * area, "covers {covered} of {area}");
    let s = &result.statistics;
    assert_eq!((s.nodes, s.triangles), (result.mesh.vertices.len(), result.mesh.triangles.len()));
    assert_eq!((s.edges, s.edges), (result.members.len(), topology.edge_count()));
    assert_eq!(s.valence_histogram.iter().sum::<usize>(), s.nodes);
    assert_eq!(s.length_histogram.counts.iter().sum::<usize>(), s.edges);
    assert!(s.edge_lengths.max <= 2.0 * edge_length * (1.0 + 3e-9), "an edge of {}", s.edge_lengths.max / edge_length);
    let short = result.lengths.iter().filter(|&&l| l < edge_length * (1.0 - 2.1e-9)).count();
    assert_eq!(short, result.out_of_range.len());
    for (member, &length) in result.lengths.iter().enumerate() {
        if result.lattice_group[member] {
            assert!((length / edge_length - 1.0).abs() < 1e-9, "a lattice edge of {length}");
        }
    }
}

fn check_admissible(outline: &[DVec2], edge_length: f64, objective: Objective) -> UniformMesh {
    let outer: Vec<DVec3> = outline.iter().map(|p| (*p * edge_length).extend(0.0)).collect();
    let result = run(&Domain::Polygon { outer: outer.clone(), holes: Vec::new() }, edge_length, objective).unwrap();
    check_valid(&result, area(outline) * edge_length * edge_length, edge_length, 1);
    assert_eq!(result.out_of_range, []);
    assert!(result.statistics.edge_lengths.min >= edge_length * (1.0 - 1e-9));
    assert_eq!(result.mesh.vertices[..outer.len()], outer);
    // The factor 16/3 of theorem 2 must hold relative to a certified lower bound for any triangulation.
    let triangles = area(outline) / 3f64.sqrt();
    let boundary: f64 =
        (0..outline.len()).map(|k| (outline[k].distance(outline[(k + 1) % outline.len()]) / 2.0).ceil()).sum();
    let lower = (((triangles + boundary + 2.0) / 2.0 - 1e-9).ceil() as usize).max(outline.len());
    assert_eq!(result.statistics.node_lower_bound, Some(lower));
    assert!(3 * result.statistics.nodes <= 16 * lower, "{} nodes, at least {lower} needed", result.statistics.nodes);
    // There cannot be more nodes than fit with distances of at least ℓ (Oler).
    let perimeter: f64 = (0..outline.len()).map(|k| outline[k].distance(outline[(k + 1) % outline.len()])).sum();
    assert!(result.statistics.nodes as f64 <= 2.0 / 3f64.sqrt() * area(outline) + perimeter / 2.0 + 1.0 + 1e-9);
    if objective == Objective::FewestNodes {
        // The mesh is Delaunay: no circumcircle contains a node.
        let topology = result.mesh.check().unwrap();
        let at = |v: u32| result.mesh.vertices[v as usize].truncate() / edge_length;
        for h in 0..topology.twin.len() as u32 {
            let twin = topology.twin[h as usize];
            if twin != u32::MAX {
                let opposite = |h: u32| topology.from(plateau_mesh::topology::previous(h));
                let d = incircle(at(topology.from(h)), at(topology.to(h)), at(opposite(h)), at(opposite(twin)));
                assert!(d < 1e-9, "not Delaunay by {d}");
            }
        }
    }
    result
}

proptest! {
    #![proptest_config(ProptestConfig { failure_persistence: None, ..ProptestConfig::with_cases(cases(2000)) })]

    #[test]
    fn admissible_polygons_get_edges_between_l_and_2l(seed in any::<u64>(), scale in -2.0..3.0f64) {
        let outline = admissible(seed);
        for objective in Objective::ALL {
            check_admissible(&outline, 10f64.powf(scale), objective);
        }
    }
}

#[test]
fn larger_admissible_polygons_with_split_sides() {
    let mut random = SplitMix64::new(7);
    for seed in 0..u64::from(cases(60)) {
        let scale = random.between(2.0, 20.0);
        let outline: Vec<DVec2> = admissible(seed).iter().map(|p| *p * scale).collect();
        for objective in Objective::ALL {
            let result = check_admissible(&outline, 1.0, objective);
            assert!(objective == Objective::FewestNodes || result.statistics.lattice_edges.count > 0);
        }
    }
}

/// A star-shaped polygon with random radii, which is concave and has sharp corners and short sides.
fn star(seed: u64, corners: usize) -> Vec<[f64; 2]> {
    let mut random = SplitMix64::new(seed);
    (0..corners)
        .map(|k| {
            let angle = TAU * (k as f64 + random.between(-0.4, 0.4)) / corners as f64;
            let radius = random.between(2.0, 14.0);
            [radius * angle.cos(), radius * angle.sin()]
        })
        .collect()
}

fn points(outline: &[[f64; 2]]) -> Vec<DVec2> {
    outline.iter().map(|&[x, y]| DVec2::new(x, y)).collect()
}

proptest! {
    #![proptest_config(ProptestConfig {
        failure_persistence: None,
        rng_seed: RngSeed::Fixed(5),
        ..ProptestConfig::with_cases(cases(150))
    })]

    #[test]
    fn concave_polygons_get_valid_meshes_without_long_edges(seed in any::<u64>(), corners in 4usize..30) {
        let outline = star(seed, corners);
        for objective in Objective::ALL {
            let result = run(&polygon(&outline), 1.0, objective).unwrap();
            check_valid(&result, area(&points(&outline)), 1.0, 1);
            prop_assert!(result.out_of_range.iter().all(|edge| edge.why != Why::Unfinished));
            // Only boundary nodes can be closer than ℓ.
            let inner = |v: u32| {
                let p = result.mesh.vertices[v as usize].truncate();
                points(&outline).iter().zip(points(&outline).iter().cycle().skip(1)).all(|(&a, &b)| {
                    let t = ((p - a).dot(b - a) / (b - a).length_squared()).clamp(0.0, 1.0);
                    p.distance(a + (b - a) * t) > 1e-9
                })
            };
            for edge in &result.out_of_range {
                prop_assert!(result.members[edge.member].iter().all(|&v| !inner(v)));
            }
        }
    }

    #[test]
    fn motions_and_scale_change_nothing_but_coordinates(
        seed in any::<u64>(), turn in 0.0..6.3f64, tilt in 0.0..3.1f64, exponent in -6i32..7, far in any::<bool>(),
    ) {
        let outline = star(seed, 9);
        let scale = 10f64.powi(exponent);
        // At 1e7 the input itself has lost digits. This moves the nodes by the same amount, but does not change the
        // connectivity.
        let shift = if far { DVec3::new(1e7, -2e7, 3e6) * scale } else { DVec3::ZERO };
        let tolerance = if far { 1e-6 } else { 1e-9 };
        let (axis_turn, axis_tilt) = (DVec2::from_angle(turn), DVec2::from_angle(tilt));
        let moved = |p: DVec3| {
            let p = axis_turn.rotate(p.truncate()).extend(p.z);
            let yz = axis_tilt.rotate(DVec2::new(p.y, p.z));
            DVec3::new(p.x, yz.x, yz.y) * scale + shift
        };
        let outer = flat(&outline);
        let image = Domain::Polygon { outer: outer.iter().map(|&p| moved(p)).collect(), holes: Vec::new() };
        for objective in Objective::ALL {
            let here = run(&polygon(&outline), 1.3, objective).unwrap();
            let there = run(&image, 1.3 * scale, objective).unwrap();
            if far && objective == Objective::MostEqualEdges {
                // A lattice through a corner has nodes exactly on the limit of its region, so the lost digits decide
                // which of them are kept. Their number changes little.
                let (a, b) = (here.statistics.lattice_edges.count as f64, there.statistics.lattice_edges.count as f64);
                prop_assert!((a - b).abs() <= 3.0 + 0.05 * a, "{a} {b} lattice edges");
                continue;
            }
            prop_assert_eq!(&here.mesh.triangles, &there.mesh.triangles);
            prop_assert_eq!(&here.lattice_group, &there.lattice_group);
            for (a, b) in here.lengths.iter().zip(&there.lengths) {
                prop_assert!((a * scale - b).abs() <= tolerance * scale, "{} {}", a, b / scale);
            }
        }
    }
}

#[test]
fn a_regular_hexagon_becomes_nothing_but_equilateral_triangles() {
    let corners: Vec<[f64; 2]> =
        (0..6).map(|k| TAU * f64::from(k) / 6.0).map(|a| [10.0 * a.cos(), 10.0 * a.sin()]).collect();
    let result = run(&polygon(&corners), 1.0, Objective::MostEqualEdges).unwrap();
    let s = &result.statistics;
    assert_eq!((s.nodes, s.triangles, s.edges), (331, 600, 930));
    assert_eq!((s.equal_edges, s.distinct_lengths, s.lattice_edges.count), (930, 1, 930));
    assert_eq!(s.valence_histogram, [0, 0, 0, 6, 54, 0, 271]);
}

#[test]
fn the_search_beats_a_placement_that_ignores_the_polygon() {
    // The square is rotated by 17°. The search must find the rows that are aligned with the square.
    let turn = DVec2::from_angle(0.3);
    let square = [[0.0, 0.0], [20.0, 0.0], [20.0, 20.0], [0.0, 20.0]].map(|p| turn.rotate(DVec2::from(p)).to_array());
    let result = run(&polygon(&square), 1.0, Objective::MostEqualEdges).unwrap();
    // 21 rows of alternately 21 and 20 nodes fit into the square. At least 19 rows of 20 and 19 nodes are far enough
    // from the boundary's nodes.
    assert!(result.statistics.lattice_edges.count >= 1090, "{}", result.statistics.lattice_edges.count);
}

#[test]
fn holes_are_respected_whatever_their_direction() {
    let outer = flat(&[[0.0, 0.0], [20.0, 0.0], [20.0, 15.0], [0.0, 15.0]]);
    let mut hole = flat(&[[5.0, 5.0], [9.0, 5.0], [9.0, 9.0], [5.0, 9.0]]);
    let second = flat(&[[13.0, 4.0], [16.0, 6.0], [14.0, 10.0]]);
    for _ in 0..2 {
        for objective in Objective::ALL {
            let domain = Domain::Polygon { outer: outer.clone(), holes: vec![hole.clone(), second.clone()] };
            let result = run(&domain, 1.0, objective).unwrap();
            let triangle = area(&points(&[[13.0, 4.0], [16.0, 6.0], [14.0, 10.0]]));
            check_valid(&result, 300.0 - 16.0 - triangle, 1.0, 3);
            let given: Vec<DVec3> = outer.iter().chain(&hole).chain(&second).copied().collect();
            assert_eq!(result.mesh.vertices[..given.len()], given);
            assert_eq!(result.input_vertices, (0..given.len() as u32).map(Some).collect::<Vec<_>>());
            if objective == Objective::MostEqualEdges {
                assert!(result.statistics.lattice_edges.count > 300);
            }
        }
        hole.reverse();
    }
}

#[test]
fn reasons_are_named() {
    let why = |outline: &[[f64; 2]], edge_length: f64| {
        let result = run(&polygon(outline), edge_length, Objective::FewestNodes).unwrap();
        check_valid(&result, area(&points(outline)), edge_length, 1);
        let mut reasons: Vec<Why> = result.out_of_range.iter().map(|edge| edge.why).collect();
        assert_eq!(result.warnings.iter().any(|w| w.code == "out_of_range"), !reasons.is_empty());
        reasons.sort_unstable();
        reasons.dedup();
        reasons
    };
    assert_eq!(why(&[[0.0, 0.0], [10.0, 0.0], [10.0, 10.0], [0.0, 10.0]], 1.0), []);
    assert_eq!(why(&[[0.0, 0.0], [10.0, 0.0], [10.0, 0.5], [0.0, 0.5]], 1.0), [Why::ShortSide, Why::Narrow]);
    assert_eq!(why(&[[0.0, 0.0], [10.0, 0.0], [10.0, 2.0]], 1.0), [Why::SharpCorner]);
    assert_eq!(
        why(&[[0.0, 0.0], [5.0, 0.0], [5.3, 0.4], [10.0, 5.0], [10.0, 10.0], [0.0, 10.0]], 1.0),
        [Why::ShortSide]
    );
    // Two rooms joined by a corridor that is narrower than ℓ and whose sides are longer than ℓ.
    let rooms = [
        [0.0, 0.0],
        [8.0, 0.0],
        [8.0, 3.7],
        [12.0, 3.7],
        [12.0, 0.0],
        [20.0, 0.0],
        [20.0, 8.0],
        [12.0, 8.0],
        [12.0, 4.3],
        [8.0, 4.3],
        [8.0, 8.0],
        [0.0, 8.0],
    ];
    assert_eq!(why(&rooms, 1.0), [Why::Narrow]);
}

/// Input: a hole whose perimeter is below 3ℓ. Symptom: the walk along its sides went round without end.
#[test]
fn a_polygon_and_its_hole_may_be_much_smaller_than_the_edge_length() {
    let hole = flat(&[[0.4, 0.2], [0.2, 0.2], [0.2, 0.5], [0.4, 0.5]]);
    let outer = flat(&[[0.0, 0.0], [1.0, 0.0], [1.0, 0.45], [0.6, 0.45], [0.6, 0.9], [0.0, 0.9]]);
    for objective in [Objective::FewestNodes, Objective::MostEqualEdges] {
        for length in [1.0, 10.0, 1e11] {
            let domain = Domain::Polygon { outer: outer.clone(), holes: vec![hole.clone()] };
            let mesh = run(&domain, length, objective).unwrap();
            assert_eq!(mesh.statistics.nodes, 10);
        }
    }
}

#[test]
fn a_triangle_smaller_than_the_edge_length_is_one_triangle() {
    for objective in Objective::ALL {
        let result = run(&polygon(&[[0.0, 0.0], [1.0, 0.0], [0.0, 1.0]]), 50.0, objective).unwrap();
        assert_eq!((result.statistics.triangles, result.out_of_range.len()), (1, 3));
        assert!(result.out_of_range.iter().all(|edge| edge.why == Why::ShortSide));
        assert_eq!(result.warnings.iter().any(|w| w.code == "no_lattice"), objective == Objective::MostEqualEdges);
    }
}

/// The places that the input errors name.
fn places(domain: &Domain, edge_length: f64) -> Vec<String> {
    match run(domain, edge_length, Objective::MostEqualEdges) {
        Err(Error::Input(errors)) => errors.iter().map(|error| error.place.to_string()).collect(),
        other => panic!("expected an input error, got {other:?}"),
    }
}

#[test]
fn bad_input_is_named() {
    let square = [[0.0, 0.0], [4.0, 0.0], [4.0, 4.0], [0.0, 4.0]];
    for edge_length in [0.0, -1.0, f64::NAN, f64::INFINITY] {
        assert_eq!(places(&polygon(&square), edge_length), ["/edge_length"]);
    }
    assert_eq!(places(&polygon(&square), 1e-7), ["/edge_length"]);
    assert_eq!(places(&polygon(&[]), 1.0), ["/domain/polygon"]);
    assert_eq!(places(&polygon(&square[..2]), 1.0), ["/domain/polygon"]);
    assert_eq!(places(&polygon(&[[0.0, 0.0], [1.0, 0.0], [2.0, 0.0], [5.0, 0.0]]), 1.0), ["/domain/polygon"]);
    assert_eq!(
        places(&polygon(&[[0.0, 0.0], [1.0, f64::NAN], [f64::INFINITY, 0.0]]), 1.0),
        ["/domain/polygon/1", "/domain/polygon/2"]
    );
    assert_eq!(places(&polygon(&[[0.0, 0.0], [1e200, 0.0], [0.0, 1.0]]), 1.0), ["/domain/polygon/1"]);
    // Bow ties with equal halves, whose areas cancel out, and with unequal halves.
    let equal_halves = [[0.0, 0.0], [4.0, 4.0], [4.0, 0.0], [0.0, 4.0]];
    assert_eq!(places(&polygon(&equal_halves), 1.0), ["/domain/polygon/0"]);
    let refused = run(&polygon(&equal_halves), 1.0, Objective::MostEqualEdges).unwrap_err();
    assert!(refused.to_string().ends_with("the side from this point meets the side from point 2"), "{refused}");
    // A loop in space that does not cross itself, although its area vector is zero.
    let turns = (0..24).map(|k| f64::from(k) * TAU / 24.0);
    let outer = turns.map(|t| DVec3::new(t.cos(), (2.0 * t).sin(), (3.0 * t).sin())).collect();
    let in_space = Domain::Polygon { outer, holes: Vec::new() };
    let refused = run(&in_space, 0.1, Objective::MostEqualEdges).unwrap_err().to_string();
    assert!(refused.starts_with("/domain/polygon: ") && refused.contains("cancel out"), "{refused}");
    assert_eq!(places(&polygon(&[[0.0, 0.0], [4.0, 4.0], [4.0, 0.0], [0.0, 7.0]]), 1.0).len(), 2);
    // A corner on another side, at its middle and elsewhere; then two corners at one place.
    assert_eq!(places(&polygon(&[[0.0, 0.0], [8.0, 0.0], [8.0, 8.0], [4.0, 0.0], [0.0, 8.0]]), 1.0).len(), 2);
    assert_eq!(places(&polygon(&[[0.0, 0.0], [8.0, 0.0], [8.0, 8.0], [4.3, 0.0], [0.0, 8.0]]), 1.0).len(), 2);
    let pinched = [[0.0, 0.0], [4.0, 4.0], [8.0, 0.0], [8.0, 8.0], [4.0, 4.0], [0.0, 8.0]];
    assert_eq!(places(&polygon(&pinched), 1.0), ["/domain/polygon/1", "/domain/polygon/4"]);
    let hole = |points: &[[f64; 2]]| Domain::Polygon { outer: flat(&square), holes: vec![flat(points)] };
    assert_eq!(places(&hole(&[[5.0, 5.0], [6.0, 5.0], [6.0, 6.0]]), 1.0), ["/domain/holes/0"]);
    assert_eq!(places(&hole(&[[1.1, 1.1], [6.0, 1.3], [1.2, 2.0]]), 1.0).len(), 2);
    assert_eq!(places(&hole(&[[-1.0, -1.0], [9.0, -1.0], [9.0, 9.0], [-1.0, 9.0]]), 1.0).len(), 1);
    let nested = Domain::Polygon {
        outer: flat(&square),
        holes: vec![
            flat(&[[1.0, 1.0], [3.0, 1.0], [3.0, 3.0], [1.0, 3.0]]),
            flat(&[[1.5, 1.5], [2.0, 1.5], [2.0, 2.0]]),
        ],
    };
    assert_eq!(places(&nested, 1.0), ["/domain/holes/1"]);
}

#[test]
fn a_point_off_the_plane_is_named_with_its_distance() {
    let mut outer = flat(&[[0.0, 0.0], [4.0, 0.0], [8.0, 0.0], [8.0, 8.0], [0.0, 8.0]]);
    outer[1].z = 1e-9;
    let planar = Domain::Polygon { outer: outer.clone(), holes: Vec::new() };
    let result = run(&planar, 1.0, Objective::MostEqualEdges).unwrap();
    assert_eq!(result.mesh.vertices[1], outer[1]);
    assert_eq!(result.warnings, []);
    outer[1].z = 0.5;
    let Err(Error::Input(errors)) = run(&Domain::Polygon { outer, holes: Vec::new() }, 1.0, Objective::FewestNodes)
    else {
        panic!("not refused")
    };
    assert_eq!(errors[0].place.to_string(), "/domain/polygon/1");
    // The plane passes through the mean of the five points.
    assert!(errors[0].detail.contains("this point is 2.99"), "{}", errors[0].detail);
    assert!(errors[0].detail.contains("off the plane"), "{}", errors[0].detail);
}

/// A roof of a city model, whose coordinates were rounded to a millimetre.
#[test]
fn a_roof_stored_to_a_millimetre_is_projected() {
    let roof = [
        [90446.49900000001, 435858.32, 4.829],
        [90448.85900000001, 435858.169, 4.829],
        [90451.04400000001, 435858.032, 4.829],
        [90451.17300000001, 435860.074, 6.569],
        [90446.615, 435860.363, 6.569],
        [90446.55900000001, 435859.64, 5.953],
    ];
    let domain = Domain::Polygon { outer: roof.map(DVec3::from).to_vec(), holes: Vec::new() };
    let result = run(&domain, 0.35, Objective::FewestNodes).unwrap();
    assert_eq!(result.warnings.len(), 1, "{:?}", result.warnings);
    let distance = projected_by(&result).expect("the warning");
    assert!((4e-4..6e-4).contains(&distance), "{distance}");
}

/// The distance that the warning `projected` states.
fn projected_by(result: &UniformMesh) -> Option<f64> {
    let warning = result.warnings.iter().find(|warning| warning.code == "projected")?;
    let distance = warning.detail.split("by up to ").nth(1)?.split(',').next()?;
    Some(distance.parse().expect("a number"))
}

/// Sloped outlines with a hole, whose coordinates were rounded to a millimetre. They are given in metres and in
/// millimetres, near zero and at survey coordinates. They must be projected by the distance that the warning states,
/// and must then be plane.
#[test]
fn sloped_outlines_that_were_rounded_to_a_millimetre_are_projected_and_level_ones_are_not() {
    let mut random = SplitMix64::new(42);
    for case in 0..48 {
        let offset = [0.0, 1e6, 1e7][case % 3];
        let unit = [1.0, 1000.0][case / 3 % 2];
        let level = case % 8 == 7;
        let offset = DVec3::new(offset + 33.3, 0.4 * offset, if level { 12.0 } else { 0.3 * offset });
        let turn = if level {
            glam::DQuat::IDENTITY
        } else {
            let axis = DVec3::new(random.between(-1.0, 1.0), random.between(-1.0, 1.0), 0.3).normalize();
            glam::DQuat::from_axis_angle(axis, random.between(0.1, 1.4))
        };
        let rounded = |points: &[DVec2]| -> Vec<DVec3> {
            let place = |p: &DVec2| (offset + turn * p.extend(0.0)) * 1000.0;
            points.iter().map(|p| place(p).round() * (unit / 1000.0)).collect()
        };
        let outline: Vec<DVec2> = points(&star(case as u64, 5 + case % 17));
        let mut opening: Vec<DVec2> = (0..5).map(|k| 0.5 * DVec2::from_angle(f64::from(k) * TAU / 5.0)).collect();
        if case % 2 == 0 {
            opening.reverse();
        }
        let outer = rounded(&outline);
        let holes = vec![rounded(&opening)];
        let given: Vec<DVec3> = outer.iter().chain(&holes[0]).copied().collect();
        let largest = given.iter().fold(0.0f64, |m, p| m.max(p.abs().max_element()));
        let ulp = largest.next_up() - largest;
        let objective = Objective::ALL[case % 2];
        let result = run(&Domain::Polygon { outer, holes }, unit, objective).unwrap();
        let vertices = &result.mesh.vertices;
        let moved = given.iter().zip(vertices).map(|(a, b)| a.distance(*b)).fold(0.0, f64::max);
        match projected_by(&result) {
            None => assert!(level && moved == 0.0, "case {case}: {moved}"),
            Some(distance) => {
                assert!(!level && (distance - moved).abs() <= 1e-6 * moved + 8.0 * ulp, "{case}: {distance} {moved}");
                assert!(distance < 2e-3 * unit, "{case}: {distance}");
            }
        }
        // The mesh is plane, and its area is that of the outline up to the rounding of the corners.
        let doubled: DVec3 =
            result.mesh.triangles.iter().map(|&t| measure::double_area_vector(result.mesh.corners(t))).sum();
        let normal = doubled.normalize();
        let height = |p: &DVec3| (*p - vertices[0]).dot(normal).abs();
        let off = vertices.iter().map(height).fold(0.0, f64::max);
        assert!(off <= 8.0 * ulp + 1e-9 * unit, "case {case}: {off}");
        let perimeter: f64 = (0..outline.len()).map(|k| outline[k].distance(outline[(k + 1) % outline.len()])).sum();
        let exact = area(&outline) - area(&opening).abs();
        let measured = doubled.length() / 2.0 / (unit * unit);
        assert!((measured - exact).abs() < 1e-3 * (perimeter + 4.0), "{case}: {measured} of {exact}");
        // The projected outline is plane: it is meshed again without a warning, and its points keep their bits.
        let (outer, hole) = vertices[..given.len()].split_at(outline.len());
        let again = Domain::Polygon { outer: outer.to_vec(), holes: vec![hole.to_vec()] };
        let again = run(&again, unit, objective).unwrap();
        assert_eq!(projected_by(&again), None, "case {case}");
        assert_eq!(again.mesh.vertices[..given.len()], vertices[..given.len()], "case {case}");
    }
}

#[test]
fn repeated_points_are_merged_with_a_warning() {
    let outer = flat(&[[0.0, 0.0], [0.0, 0.0], [6.0, 0.0], [6.0, 6.0], [0.0, 6.0], [0.0, 0.0]]);
    let result = run(&Domain::Polygon { outer, holes: Vec::new() }, 1.0, Objective::FewestNodes).unwrap();
    assert_eq!(result.input_vertices, [0, 0, 1, 2, 3, 0].map(Some));
    assert_eq!(result.warnings[0].code, "merged_points");
}

#[test]
fn a_clockwise_polygon_faces_the_other_way() {
    let mut outer = flat(&[[0.0, 0.0], [6.0, 0.0], [6.0, 6.0], [0.0, 6.0]]);
    outer.reverse();
    let result = run(&Domain::Polygon { outer, holes: Vec::new() }, 1.0, Objective::MostEqualEdges).unwrap();
    assert!(result.mesh.triangles.iter().all(|&t| measure::double_area_vector(result.mesh.corners(t)).z < 0.0));
}

#[test]
fn runs_are_equal_to_the_byte() {
    let outline = star(3, 12);
    for objective in Objective::ALL {
        let mesh = || run(&polygon(&outline), 0.3, objective).expect("a mesh");
        assert_eq!(mesh(), mesh());
    }
}

#[test]
fn progress_rises_and_looks_are_frequent() {
    let square = polygon(&[[0.0, 0.0], [60.0, 0.0], [60.0, 60.0], [0.0, 60.0]]);
    for objective in Objective::ALL {
        let seen = std::cell::RefCell::new(Vec::new());
        let report = |progress: plateau_mesh::Progress| seen.borrow_mut().push(progress.fraction);
        let execution = Execution::new(&|| plateau_mesh::Signal::Continue, &report);
        solve(&square, &Options::new(0.3, objective), &execution).unwrap();
        let seen = seen.borrow();
        assert!(seen.len() > 20 && seen.windows(2).all(|pair| pair[0] <= pair[1]) && *seen.last().unwrap() == 1.0);
        // 10^7 units of work take about a second, so this bound is far below the 50 ms that are promised between two
        // calls of `look`.
        assert!(execution.largest_work_between_looks() <= 150_000, "{}", execution.largest_work_between_looks());
    }
}

#[test]
fn a_cancelled_run_returns_nothing_and_a_late_one_what_it_has() {
    use plateau_mesh::{Interruption, Signal};
    let square = polygon(&[[0.0, 0.0], [60.0, 0.0], [60.0, 60.0], [0.0, 60.0]]);
    for objective in Objective::ALL {
        for stop_at in [0u64, 1, 2, 5, 40] {
            for signal in [Signal::Cancel, Signal::Deadline] {
                let looks = std::cell::Cell::new(0);
                let ask = || {
                    looks.set(looks.get() + 1);
                    if looks.get() > stop_at { signal } else { Signal::Continue }
                };
                match solve(&square, &Options::new(0.2, objective), &Execution::new(&ask, &|_| {})) {
                    Err(Error::Interrupted(Interruption::Cancelled)) => assert_eq!(signal, Signal::Cancel),
                    Err(Error::Interrupted(Interruption::DeadlinePassed)) => {
                        assert_eq!((signal, stop_at), (Signal::Deadline, 0))
                    }
                    Ok(result) => {
                        assert_eq!(signal, Signal::Deadline);
                        assert!(!result.converged && result.warnings.iter().any(|w| w.code == "not_converged"));
                        assert!(measure::flipped_triangles(&result.mesh) == 0);
                        assert!((measure::area(&result.mesh) - 3600.0).abs() < 1e-6);
                        assert!(result.out_of_range.iter().all(|edge| edge.why == Why::Unfinished));
                    }
                    Err(other) => panic!("{other}"),
                }
            }
        }
    }
}

#[test]
fn a_deadline_at_any_look_after_the_first_returns_a_valid_mesh() {
    // The sides are no multiples of the edge length, so that several ways to divide them are compared.
    let outline = polygon(&[[0.0, 0.0], [5.3, 0.4], [6.1, 3.7], [1.2, 4.6]]);
    let options = Options::new(0.5, Objective::MostEqualEdges);
    let run = |most: u64| {
        let looks = std::cell::Cell::new(0);
        let ask = || {
            looks.set(looks.get() + 1);
            if looks.get() > most { plateau_mesh::Signal::Deadline } else { plateau_mesh::Signal::Continue }
        };
        (solve(&outline, &options, &Execution::new(&ask, &|_| {})), looks.get())
    };
    let (whole, looks) = run(u64::MAX);
    assert!(whole.expect("a mesh").converged && looks > 100, "{looks} looks");
    for most in (1..looks).step_by(looks.div_ceil(200) as usize).chain(looks - 20..looks) {
        let (result, _) = run(most);
        let result = result.unwrap_or_else(|error| panic!("after {most} of {looks} looks: {error}"));
        assert!(measure::flipped_triangles(&result.mesh) == 0, "after {most} looks");
    }
}
