use super::bisection::{BEST, BisectionMesh, CENTRAL, EDGES, VertexMap};
use super::element::{Orientation, UNKNOWNS, basis_curls, integrals};
use super::orientation::vector_area;
use super::proof::scale_to_one;
use super::rigorous;
use super::space::Space;
use super::symmetry::Mirrors;
use plateau_mesh::{DVec3, Execution};
use std::f64::consts::TAU;

/// A deterministic sequence of numbers in [0, 1).
fn noise(seed: &mut u64) -> f64 {
    *seed = seed.wrapping_mul(6_364_136_223_846_793_005).wrapping_add(1_442_695_040_888_963_407);
    (*seed >> 11) as f64 / (1u64 << 53) as f64
}

fn ring() -> Vec<DVec3> {
    (0..7)
        .map(|k| f64::from(k) * 0.9)
        .map(|t| DVec3::new(libm::cos(t), libm::sin(t), 0.4 * libm::sin(2.0 * t)))
        .collect()
}

/// A mesh around a ring, in which random leaves are bisected in each of `rounds` rounds.
fn random_mesh(rounds: usize, seed: &mut u64) -> BisectionMesh {
    let mut mesh = BisectionMesh::around(ring().into_iter(), Mirrors::default()).unwrap();
    for _ in 0..rounds {
        let marked: Vec<u32> = (0..mesh.leaf_count() as u32).filter(|_| noise(seed) < 0.1).collect();
        mesh.bisect(&marked, &Execution::default()).unwrap();
    }
    mesh
}

/// Puts two random fields on the mesh.
fn randomise(mesh: &mut BisectionMesh, seed: &mut u64) {
    let space = Space::of(mesh);
    for which in [BEST, CENTRAL] {
        let field: Vec<f64> = (0..space.count()).map(|_| noise(seed) - 0.5).collect();
        let curl = space.curl(&field);
        mesh.nodal.iter_mut().zip(curl).for_each(|(nodal, curl)| nodal.curl[which] = curl);
        for (key, value) in space.edges.iter().zip(&field) {
            mesh.edges.get_mut(key).unwrap().circulation[which] = *value;
        }
    }
}

#[test]
fn bisected_leaves_fill_the_box_and_conform() {
    let mesh = random_mesh(6, &mut 1);
    assert!(mesh.leaf_count() > 1000);
    let mut volume = 0.0;
    let mut sides: VertexMap<[u32; 3], Vec<u32>> = VertexMap::default();
    for leaf in 0..mesh.leaf_count() {
        let vertices = mesh.leaf_vertices(leaf);
        let [a, b, c, d] = vertices.map(|v| mesh.vertices[v as usize]);
        let own = (b - a).cross(c - a).dot(d - a).abs() / 6.0;
        assert!((own / mesh.leaf_volume(leaf) - 1.0).abs() < 1e-9);
        volume += own;
        for k in 0..4 {
            let mut face: Vec<u32> = (0..4).filter(|&p| p != k).map(|p| vertices[p]).collect();
            face.sort_unstable();
            sides.entry([face[0], face[1], face[2]]).or_default().push(leaf as u32);
        }
    }
    assert!((volume / mesh.volume() - 1.0).abs() < 1e-9);
    let corners = mesh.corners();
    for (face, leaves) in &sides {
        let points = face.map(|v| mesh.vertices[v as usize]);
        let on_the_box =
            (0..3).any(|axis| corners.iter().any(|corner| points.iter().all(|point| point[axis] == corner[axis])));
        assert_eq!(leaves.len(), if on_the_box { 1 } else { 2 });
    }
}

#[test]
fn bisection_leaves_the_field_as_it_is() {
    let mut seed = 3;
    let mut mesh = random_mesh(1, &mut seed);
    randomise(&mut mesh, &mut seed);
    let circulation = |mesh: &BisectionMesh, which: usize| {
        let space = Space::of(mesh);
        let form = space.circulation(mesh, &[ring()]);
        space.field(mesh, which).iter().zip(form).map(|(a, b)| a * b).sum::<f64>()
    };
    let before = [BEST, CENTRAL].map(|which| circulation(&mesh, which));
    for _ in 0..4 {
        let marked: Vec<u32> = (0..mesh.leaf_count() as u32).filter(|_| noise(&mut seed) < 0.2).collect();
        mesh.bisect(&marked, &Execution::default()).unwrap();
    }
    let space = Space::of(&mesh);
    for which in [BEST, CENTRAL] {
        let curl = space.curl(&space.field(&mesh, which));
        let largest = curl.iter().flatten().map(|v| v.length()).fold(0.0, f64::max);
        for (nodal, curl) in mesh.nodal.iter().zip(&curl) {
            // The interpolated curl must equal the curl of the values on the new edges and faces.
            nodal.curl[which].iter().zip(curl).for_each(|(a, b)| assert!(a.distance(*b) < 1e-9 * largest));
        }
        assert!((circulation(&mesh, which) - before[which]).abs() < 1e-9 * before[which].abs().max(1.0));
    }
}

#[test]
fn integrals_and_curls_of_the_basis_obey_stokes() {
    let mut seed = 5;
    for vertices in [[3, 1, 2, 0], [0, 1, 2, 3], [7, 4, 9, 5]] {
        let corners: [DVec3; 4] =
            std::array::from_fn(|_| DVec3::new(noise(&mut seed), noise(&mut seed), noise(&mut seed)));
        let orientation = Orientation::of(vertices);
        let curls = basis_curls(corners, &orientation);
        let triangle: [[f64; 4]; 3] = std::array::from_fn(|_| {
            let weights: [f64; 4] = std::array::from_fn(|_| noise(&mut seed));
            weights.map(|w| w / weights.iter().sum::<f64>())
        });
        let point = |at: [f64; 4]| at.iter().zip(corners).map(|(&w, corner)| corner * w).sum::<DVec3>();
        let [a, b, c] = triangle.map(point);
        let area = 0.5 * (b - a).cross(c - a);
        let sides: [[f64; UNKNOWNS]; 3] =
            std::array::from_fn(|k| integrals(triangle[k], triangle[(k + 1) % 3], &orientation));
        let middle: [f64; 4] = std::array::from_fn(|p| triangle.iter().map(|at| at[p]).sum::<f64>() / 3.0);
        for unknown in 0..UNKNOWNS {
            let around: f64 = sides.iter().map(|side| side[unknown]).sum();
            // The curl is linear, so that its mean over the triangle is its value at the centroid.
            let mean = curls.iter().zip(middle).map(|(at, weight)| at[unknown] * weight);
            assert!((around - mean.sum::<DVec3>().dot(area)).abs() < 1e-12);
        }
    }
}

#[test]
fn a_located_point_is_the_mean_of_the_leaf_s_corners() {
    let mut seed = 7;
    let mesh = random_mesh(5, &mut seed);
    let [low, high] = mesh.corners();
    for _ in 0..200 {
        let point = low + (high - low) * DVec3::new(noise(&mut seed), noise(&mut seed), noise(&mut seed));
        let (leaf, at) = mesh.locate(point);
        assert!(at.iter().all(|&w| w >= 0.0));
        let corners = mesh.leaf_vertices(leaf as usize).map(|v| mesh.vertices[v as usize]);
        let found: DVec3 = corners.iter().zip(at).map(|(&corner, w)| corner * w).sum();
        assert!(found.distance(point) < 1e-12);
    }
    assert_eq!(EDGES.len(), 6);
}

#[test]
fn a_traced_segment_is_covered_once() {
    let mut seed = 9;
    let mesh = random_mesh(5, &mut seed);
    let points = ring();
    for (k, &from) in points.iter().enumerate() {
        let to = points[(k + 1) % points.len()];
        let pieces = mesh.trace(from, to);
        assert!(pieces.len() > 3);
        assert_eq!((pieces[0].range[0], pieces[pieces.len() - 1].range[1]), (0.0, 1.0));
        assert!(pieces.windows(2).all(|pair| pair[0].range[1] == pair[1].range[0]));
        for piece in pieces {
            let corners = mesh.leaf_vertices(piece.leaf as usize).map(|v| mesh.vertices[v as usize]);
            for (at, t) in [(piece.from, piece.range[0]), (piece.to, piece.range[1])] {
                let found: DVec3 = corners.iter().zip(at).map(|(&corner, w)| corner * w).sum();
                assert!(found.distance(from.lerp(to, t)) < 1e-12);
            }
        }
    }
}

/// A boundary that three reflections map to itself, and a mesh of one eighth of the box. Two of the reflections reverse
/// the boundary's direction.
fn symmetrical_mesh(rounds: usize, seed: &mut u64) -> (Vec<Vec<DVec3>>, BisectionMesh) {
    let ellipse = |k: u32| TAU * f64::from(k) / 40.0;
    let ellipse = |z: f64| -> Vec<DVec3> {
        (0..40)
            .map(ellipse)
            .map(|t| DVec3::new(1.3 * libm::cos(t), libm::sin(t), z + 0.2 * z * libm::cos(t).powi(2)))
            .collect()
    };
    let loops = vec![ellipse(-0.3), ellipse(0.3)];
    let mirrors = Mirrors::of(&loops, DVec3::ZERO);
    assert_eq!((mirrors.images(), mirrors.odd()), (8, 0b011));
    let mut mesh = BisectionMesh::around(loops.iter().flatten().copied(), mirrors).unwrap();
    for _ in 0..rounds {
        let marked: Vec<u32> = (0..mesh.leaf_count() as u32).filter(|_| noise(seed) < 0.1).collect();
        mesh.bisect(&marked, &Execution::default()).unwrap();
    }
    (loops, mesh)
}

#[test]
fn a_segment_is_traced_through_the_mirror_images() {
    let (loops, mesh) = symmetrical_mesh(4, &mut 29);
    let all: Vec<DVec3> = loops.concat();
    // Some of these chords pass through several planes of symmetry.
    for (k, (&from, &to)) in all.iter().zip(all.iter().cycle().skip(27)).enumerate() {
        let pieces = mesh.trace(from, to);
        assert_eq!((pieces[0].range[0], pieces[pieces.len() - 1].range[1]), (0.0, 1.0));
        assert!(pieces.windows(2).all(|pair| pair[0].range[1] == pair[1].range[0]), "segment {k}");
        for piece in pieces {
            let corners = mesh.leaf_vertices(piece.leaf as usize).map(|v| mesh.vertices[v as usize]);
            for (at, t) in [(piece.from, piece.range[0]), (piece.to, piece.range[1])] {
                let found: DVec3 = corners.iter().zip(at).map(|(&corner, w)| corner * w).sum();
                assert!(mesh.reflect(found, piece.flips).distance(from.lerp(to, t)) < 1e-12);
            }
        }
    }
}

/// The field that is found on one eighth of the box must prove, for the whole boundary, the bound that the search
/// states.
#[test]
fn the_optimum_of_one_side_is_proven_for_the_whole_boundary() {
    use super::conic::Level;
    use super::system::System;
    let (loops, mut mesh) = symmetrical_mesh(3, &mut 31);
    mesh.set_constant_curl(vector_area(&loops).normalize());
    let space = Space::of(&mesh);
    assert!(space.is_a_ball());
    let form = space.circulation(&mesh, &loops);
    let exec = Execution::default();
    let mut system = System::of(&space, &exec).unwrap();
    let mut level = Level::new(&space, &mesh, &form, Vec::new(), 9.0, false);
    let (mut storage, mut steps) = (Vec::new(), 0);
    while level.gap() > 1e-6 {
        assert!(steps < 25 && !level.stalled, "{}", level.gap());
        level.step(&mut system, &mut storage, &exec).unwrap();
        steps += 1;
    }
    let mut field = level.best.field.clone();
    assert!(scale_to_one(&space, &mut field));
    let proven = rigorous::least_area(&space, &mesh, &field, (&loops[..], &[]), None, 1e-7).unwrap();
    // A field of constant curl proves the length of the vector area. The optimum is a little larger, because the
    // ellipses are bent.
    let ellipses = vector_area(&loops).length();
    assert!(proven > ellipses && proven < 1.05 * ellipses, "{proven} and {ellipses}");
    assert!((proven / level.best.bound - 1.0).abs() < 1e-9, "{proven} and {}", level.best.bound);
    // The field has no tangential component in the two planes where it changes its sign.
    let mut vanishing = 0;
    for (edge, value) in space.edges.iter().zip(&field) {
        let planes = edge.iter().fold(0b111, |planes, &v| planes & mesh.planes_at(v));
        assert!(planes & 0b011 == 0 || *value == 0.0);
        vanishing += usize::from(planes & 0b011 != 0);
    }
    assert!(vanishing > 20, "{vanishing}");
}

#[test]
fn interval_results_contain_the_exact_ones() {
    use super::interval::Interval;
    let third = Interval::exactly(1.0) / Interval::exactly(3.0);
    assert!(third.low < third.high && third.low <= 1.0 / 3.0 && third.high >= 1.0 / 3.0);
    let one = third * Interval::exactly(3.0);
    assert!(one.low < 1.0 && one.high > 1.0);
    let two = Interval::exactly(2.0).sqrt().square();
    assert!(two.low < 2.0 && two.high > 2.0);
    let tiny = Interval::exactly(1.0) + Interval::exactly(1e-30);
    assert!(tiny.low <= 1.0 && tiny.high > 1.0);
}

#[test]
fn few_steps_reach_the_optimum_and_the_gap_bounds_what_is_missing() {
    use super::conic::Level;
    use super::system::System;
    let mut mesh = random_mesh(3, &mut 11);
    mesh.set_constant_curl(DVec3::Z);
    let space = Space::of(&mesh);
    let form = space.circulation(&mesh, &[ring()]);
    let mut system = System::of(&space, &Execution::default()).unwrap();
    let mut level = Level::new(&space, &mesh, &form, Vec::new(), 4.0, false);
    let mut storage = Vec::new();
    let mut seen = Vec::new();
    while level.gap() > 1e-6 {
        assert!(seen.len() < 20, "gaps {seen:?}");
        level.step(&mut system, &mut storage, &Execution::default()).unwrap();
        seen.push((level.best.bound, level.gap()));
    }
    let (optimum, _) = seen[seen.len() - 1];
    assert!(optimum > 1.01 * seen[0].0 && seen.is_sorted_by(|a, b| a.0 <= b.0));
    for (bound, gap) in &seen {
        assert!(bound + gap >= optimum, "{bound} and {gap} for {optimum}");
    }
}

/// The leaf of every point of the convex hull must be constrained, and more than a tenth of all leaves must not be.
#[test]
fn leaves_that_meet_the_convex_hull_are_constrained() {
    use super::hull::Hull;
    let mut seed = 19;
    let mesh = random_mesh(6, &mut seed);
    let points = ring();
    let space = Space::within(&mesh, &Hull::around(std::slice::from_ref(&points), &[], &Execution::default()).unwrap());
    assert!(space.constrained.len() < mesh.leaf_count() * 9 / 10, "{} constrained", space.constrained.len());
    for k in 0..20_000 {
        // The points are vertices of the ring, and points of triangles between its vertices.
        let mut vertex = || points[(noise(&mut seed) * points.len() as f64) as usize];
        let (a, b, c) = (vertex(), vertex(), vertex());
        let (s, t) = (noise(&mut seed), noise(&mut seed));
        let point = if k % 2 == 0 { a } else { a + (b - a) * s + (c - b) * (s * t) };
        let (leaf, _) = mesh.locate(point);
        assert!(space.constrained.binary_search(&leaf).is_ok(), "leaf {leaf} holds {point}");
    }
}

#[test]
fn leaves_apart_are_no_ball() {
    let mesh = random_mesh(3, &mut 23);
    let apart = |leaf: &u32| mesh.leaf_vertices(*leaf as usize).iter().all(|v| !mesh.leaf_vertices(0).contains(v));
    let other = (0..mesh.leaf_count() as u32).find(apart).unwrap();
    let is_a_ball = |leaves: Vec<u32>| {
        let mut space = Space::of(&mesh);
        space.constrain(leaves);
        space.is_a_ball()
    };
    assert!(Space::of(&mesh).is_a_ball() && is_a_ball(vec![0]));
    assert!(!is_a_ball(vec![0, other]));
}

/// Without the constraints outside the hull, the optimum must not be smaller.
#[test]
fn the_optimum_within_the_hull_is_not_below_that_in_the_box() {
    use super::conic::Level;
    use super::hull::Hull;
    use super::system::System;
    let mut mesh = random_mesh(3, &mut 11);
    mesh.set_constant_curl(DVec3::Z);
    let optimum = |space: Space| {
        let form = space.circulation(&mesh, &[ring()]);
        let mut system = System::of(&space, &Execution::default()).unwrap();
        let mut level = Level::new(&space, &mesh, &form, Vec::new(), 4.0, false);
        let mut steps = 0;
        while level.gap() > 1e-7 {
            assert!(steps < 25 && !level.stalled);
            level.step(&mut system, &mut Vec::new(), &Execution::default()).unwrap();
            steps += 1;
        }
        (level.best.bound, system.rows())
    };
    let hull = Hull::around(&[ring()], &[], &Execution::default()).unwrap();
    let ((in_box, rows), (within, fewer)) = (optimum(Space::of(&mesh)), optimum(Space::within(&mesh, &hull)));
    assert!(fewer < rows && within > in_box - 1e-6, "{within} with {fewer} rows for {in_box} with {rows}");
}

/// Nested dissection must order every row exactly once, and give a smaller factor than approximate minimum degree.
#[test]
fn dissection_leaves_a_small_factor() {
    use super::dissection::NONE;
    use super::system::System;
    let mesh = random_mesh(6, &mut 13);
    let space = Space::of(&mesh);
    let system = System::of(&space, &Execution::default()).unwrap();
    let mut order = system.order.clone();
    order.sort_unstable();
    assert!(order.iter().copied().eq(0..system.rows() as u32) && !order.contains(&NONE));
    let by_degree = plateau_mesh::sparse::Symbolic::analyse(&system.matrix, None).unwrap().factor_entries();
    assert!(system.factor_entries() < by_degree * 8 / 10, "{} and {by_degree}", system.factor_entries());
}

/// The iterate that a mesh hands on to a finer mesh must be nearer to the optimum there than the usual start, and must
/// lead to the optimum.
#[test]
fn a_finer_mesh_starts_from_the_iterate_of_the_coarser_one() {
    use super::conic::Level;
    use super::system::System;
    let exec = Execution::default();
    let mut mesh = random_mesh(2, &mut 17);
    mesh.set_constant_curl(DVec3::Z);
    // Returns the gaps before each step, and the last state.
    let solve = |mesh: &BisectionMesh, warm: bool| {
        let space = Space::of(mesh);
        let form = space.circulation(mesh, &[ring()]);
        let mut system = System::of(&space, &exec).unwrap();
        let mut level = Level::new(&space, mesh, &form, Vec::new(), 4.0, warm);
        let mut gaps = vec![level.gap()];
        while level.gap() > 1e-5 {
            assert!(gaps.len() < 30 && !level.stalled, "{gaps:?}");
            level.step(&mut system, &mut Vec::new(), &exec).unwrap();
            gaps.push(level.gap());
        }
        let (central, duals) = level.central();
        (gaps, [level.best.field, central], duals, level.best.bound)
    };
    let (_, fields, duals, coarse) = solve(&mesh, false);
    let space = Space::of(&mesh);
    let currents = vec![[DVec3::ZERO; 4]; mesh.leaf_count()];
    mesh.carry(&space, &fields, &currents, &duals);
    let all: Vec<u32> = (0..mesh.leaf_count() as u32).collect();
    mesh.bisect(&all, &Execution::default()).unwrap();
    let (cold, _, _, from_centre) = solve(&mesh, false);
    let (warm, _, _, from_iterate) = solve(&mesh, true);
    assert!(warm[0] < 0.5 * cold[0], "{warm:?} and {cold:?}");
    assert!((from_iterate - from_centre).abs() < 1e-5 && from_iterate > coarse);
}

/// For every budget, the planned meshes must use nearly all of it, and none may grow by more than the largest growth.
#[test]
fn the_meshes_are_planned_for_the_whole_budget() {
    use super::Options;
    use super::budget::{Budget, FEW_LEAVES, FILL_POWERS, GROWTH, STEPS, STEPS_BETWEEN, Size};
    for (seconds, fill_power) in
        [0.5, 1.0, 1.5, 2.0, 3.0, 4.0, 6.0, 8.0, 10.0, 15.0].map(|s| FILL_POWERS.map(|power| (s, power))).concat()
    {
        let options = Options::default().with_gap(0.0).with_seconds(seconds);
        let mut budget = Budget::new(&options, 1.0);
        // The size of the first system of two rings.
        let mut size = Size { entries: 240_000.0, rows: 3_240.0, leaves: 600.0, fill_power };
        let mut meshes = 1;
        budget.spent = size.price(STEPS_BETWEEN);
        while let Some(next) = budget.next_leaves(size, 0.995) {
            let Size { leaves, .. } = size;
            assert!(next <= leaves * GROWTH && meshes < 10, "{next} leaves after {leaves} in {seconds} s");
            size = size.grown(next / leaves);
            meshes += 1;
            budget.spent += size.price(STEPS_BETWEEN);
        }
        // The finest mesh has more steps than the others.
        let steps = (STEPS + libm::log2(size.leaves / FEW_LEAVES).ceil().max(0.0)) as u32;
        budget.spent += size.price(steps) - size.price(STEPS_BETWEEN);
        let used = budget.spent / seconds;
        assert!((0.8..=1.001).contains(&used), "{used} of {seconds} s for {size:?}");
    }
}
