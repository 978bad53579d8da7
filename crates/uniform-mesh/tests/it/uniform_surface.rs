//! Uniform meshes of patches and films: checks what must hold on any surface, surfaces with closed forms, and shared
//! lengths.

use plateau_mesh::measure;
use plateau_mesh::{DVec2, DVec3, Error, Execution, Interruption, Signal};
use plateau_uniform_mesh::{Domain, Method, Nurbs, Objective, Optimise, Options, Transition, UniformMesh, Why, solve};

fn run(domain: &Domain, options: &Options) -> Result<UniformMesh, Error> {
    solve(domain, options, &Execution::default())
}

fn options(edge_length: f64) -> Options {
    Options::new(edge_length, Objective::MostEqualEdges)
}

/// Control points of a lopsided roof on a skew plan, without any symmetry.
fn roof() -> Vec<Vec<DVec3>> {
    let heights = [[0.0, 9.0, 3.0, 0.0], [7.0, 31.0, 22.0, 5.0], [2.0, 18.0, 35.0, 8.0], [0.0, 4.0, 11.0, 0.0]];
    let at = |i: usize, j: usize| {
        let (u, v) = (i as f64 / 3.0, j as f64 / 3.0);
        DVec3::new(60.0 * u + 6.0 * v, 52.0 * v + 5.0 * u * v, heights[i][j])
    };
    (0..4).map(|i| (0..4).map(|j| at(i, j)).collect()).collect()
}

fn bezier(control_points: Vec<Vec<DVec3>>) -> Domain {
    Domain::Bezier { control_points }
}

/// A piece of a cylinder about the y axis: angles from 0 to `angle`, radius 40, length 60.
fn cylinder(angle: f64) -> Domain {
    let (half, radius) = (angle / 2.0, 40.0);
    let arc = [DVec2::X, DVec2::from_angle(half) / half.cos(), DVec2::from_angle(angle)];
    let row =
        |p: &DVec2| vec![DVec3::new(p.x * radius, 0.0, p.y * radius), DVec3::new(p.x * radius, 60.0, p.y * radius)];
    Domain::Nurbs(Nurbs {
        degrees: [2, 1],
        knots: [vec![0.0, 0.0, 0.0, 1.0, 1.0, 1.0], vec![0.0, 0.0, 1.0, 1.0]],
        control_points: arc.iter().map(row).collect(),
        weights: Some(vec![vec![1.0; 2], vec![half.cos(); 2], vec![1.0; 2]]),
    })
}

/// A square frame of side 60 with three humps of height 6 on every side, and `n` points per side.
fn frame(n: usize) -> Vec<DVec3> {
    let corners = [[0.0, 0.0], [60.0, 0.0], [60.0, 60.0], [0.0, 60.0]].map(DVec2::from);
    (0..4 * n)
        .map(|k| {
            let t = (k % n) as f64 / n as f64;
            let p = corners[k / n].lerp(corners[(k / n + 1) % 4], t);
            p.extend(6.0 * (3.0 * std::f64::consts::PI * t).sin().powi(2))
        })
        .collect()
}

/// Checks what must hold for every result: the mesh is a disc without degenerate or flipped triangles, and the
/// statistics fit the mesh.
fn check(result: &UniformMesh, edge_length: f64) {
    let topology = result.mesh.check().unwrap();
    assert_eq!((topology.boundary_loops().len(), topology.euler_characteristic(), topology.components()), (1, 1, 1));
    assert_eq!((measure::flipped_triangles(&result.mesh), measure::degenerate_triangles(&result.mesh)), (0, 0));
    assert_eq!(result.members.len(), topology.edge_count());
    for (&[a, b], &length) in result.members.iter().zip(&result.lengths) {
        let distance = result.mesh.vertices[a as usize].distance(result.mesh.vertices[b as usize]);
        assert!((distance - length).abs() < 1e-12 * edge_length);
    }
    let last = result.stages.last().unwrap();
    let (all, lattice) = (result.statistics.edge_lengths, result.statistics.lattice_edges);
    for (a, b) in [(last.all.lengths, all), (last.lattice.unwrap().lengths, lattice)] {
        assert!(a.count == b.count && (a.std_dev - b.std_dev).abs() < 1e-9 * edge_length);
        assert!((a.min - b.min).abs() < 1e-9 * edge_length && (a.max - b.max).abs() < 1e-9 * edge_length);
    }
    let out = result.lengths.iter().filter(|&&l| !(0.999_999_998..=2.000_000_004).contains(&(l / edge_length))).count();
    assert_eq!(out, result.out_of_range.len());
    assert!(result.out_of_range.iter().all(|edge| edge.why != Why::Unfinished));
}

/// Lengths of the members outside the lattice group.
fn rim(result: &UniformMesh) -> Vec<f64> {
    result.lengths.iter().zip(&result.lattice_group).filter(|&(_, &lattice)| !lattice).map(|(&l, _)| l).collect()
}

fn names(result: &UniformMesh) -> Vec<&str> {
    result.stages.iter().map(|stage| stage.name).collect()
}

#[test]
fn a_flat_patch_gives_what_its_polygon_gives() {
    let corners = [[0.0, 0.0], [40.0, 0.0], [40.0, 31.0], [0.0, 31.0]].map(|[x, y]| DVec3::new(x, y, 0.0));
    let patch = bezier(vec![vec![corners[0], corners[3]], vec![corners[1], corners[2]]]);
    for objective in Objective::ALL {
        let options = Options::new(3.0, objective);
        let on_patch = run(&patch, &options).unwrap();
        let on_polygon = run(&Domain::Polygon { outer: corners.to_vec(), holes: Vec::new() }, &options).unwrap();
        check(&on_patch, 3.0);
        // The search for the lattice's placement ends at one of several placements that are about equally good.
        // Rounding may decide at which one.
        let apart = on_patch.statistics.objective_value.abs_diff(on_polygon.statistics.objective_value);
        let allowed = if objective == Objective::MostEqualEdges { 6 } else { 0 };
        assert!(apart <= allowed, "{apart} of {}", on_patch.statistics.objective_value);
        assert!((measure::area(&on_patch.mesh) - 1240.0).abs() < 1e-6);
        assert!(on_patch.statistics.lattice_edges.std_dev < 1e-6 && on_patch.out_of_range.is_empty());
    }
}

#[test]
fn a_cylinder_unrolls_so_chords_deviate_by_the_square_of_the_length() {
    let deviation = |edge_length: f64| {
        // An auxiliary chord is shorter than its arc by 1/24 of the square of its angle.
        let options = Options { auxiliary_grid: [240, 4], optimise: Optimise::None, ..options(edge_length) };
        let result = run(&cylinder(1.6), &options).unwrap();
        check(&result, edge_length);
        assert_eq!(names(&result), ["auxiliary_surface", "auxiliary_plane", "plane", "surface"]);
        let (space, plane) = (result.stages[0].all.lengths, result.stages[1].all.lengths);
        assert!((space.mean - plane.mean).abs() < 1e-6 && (space.std_dev - plane.std_dev).abs() < 1e-6);
        for p in &result.mesh.vertices {
            assert!((p.x.hypot(p.z) - 40.0).abs() < 1e-9, "off the cylinder");
        }
        let lattice = result.statistics.lattice_edges;
        assert!(lattice.count > 200 && lattice.max <= edge_length * (1.0 + 1e-3));
        1.0 - lattice.mean / edge_length
    };
    let (coarse, fine) = (deviation(6.0), deviation(3.0));
    // An edge at the angle a to the hoops is shorter than its arc by cos⁴a ℓ²/24R². The mean of cos⁴a over the three
    // directions of the lattice is 3/8, whatever the lattice's angle is.
    let expected = |edge_length: f64| 0.375 * edge_length * edge_length / (24.0 * 1600.0);
    assert!((coarse / expected(6.0) - 1.0).abs() < 0.1 && (fine / expected(3.0) - 1.0).abs() < 0.1, "{coarse} {fine}");
    assert!((3.6..4.4).contains(&(coarse / fine)), "{coarse} {fine}");
}

/// Half a cone of the radius 6 and the height 8, with its apex at the end of v.
fn half_cone() -> Nurbs {
    let half = 0.5f64.sqrt();
    let around = [[6.0, 0.0], [6.0, 6.0], [0.0, 6.0], [-6.0, 6.0], [-6.0, 0.0]].map(DVec2::from);
    let apex = DVec3::new(0.0, 0.0, 8.0);
    Nurbs {
        degrees: [2, 1],
        knots: [vec![0.0, 0.0, 0.0, 0.5, 0.5, 1.0, 1.0, 1.0], vec![0.0, 0.0, 1.0, 1.0]],
        control_points: around.iter().map(|p| vec![p.extend(0.0), apex]).collect(),
        weights: Some([1.0, half, 1.0, half, 1.0].map(|weight| vec![weight; 2]).to_vec()),
    }
}

#[test]
fn a_cone_with_its_apex_unrolls() {
    // Unrolled, the half cone is a sector of the radius 10 and the angle 108 degrees.
    let cone = half_cone();
    let result = run(&Domain::Nurbs(cone.clone()), &options(1.2)).unwrap();
    check(&result, 1.2);
    let statistics = &result.statistics;
    let fit = statistics.surface.as_ref().unwrap();
    assert!(result.converged && fit.method == Method::Flattened, "{:?}", result.warnings);
    assert!((fit.area / (30.0 * std::f64::consts::PI) - 1.0).abs() < 2e-3, "{}", fit.area);
    let lattice = result.lattice_group.iter().filter(|group| **group).count();
    let equal = result.lengths.iter().filter(|&&length| (length / 1.2 - 1.0).abs() < 1e-3).count();
    assert!(equal >= lattice && lattice > 100, "{equal} equal, {lattice} in the lattice");
    // The same with the apex at the other end of v, and at the ends of u.
    let mut turned = cone;
    turned.control_points.iter_mut().for_each(|row| row.reverse());
    for transposed in [false, true] {
        if transposed {
            let Nurbs { degrees, knots, control_points, weights } = turned;
            let columns = |i: usize| control_points.iter().map(|row| row[i]).collect::<Vec<_>>();
            let control_points = vec![columns(0), columns(1)];
            let weights = weights.map(|rows| vec![rows.iter().map(|row| row[0]).collect::<Vec<_>>(); 2]);
            let [u, v] = knots;
            turned = Nurbs { degrees: [degrees[1], degrees[0]], knots: [v, u], control_points, weights };
        }
        let other = run(&Domain::Nurbs(turned.clone()), &options(1.2)).unwrap();
        check(&other, 1.2);
        assert!(other.converged, "{:?}", other.warnings);
    }
}

#[test]
fn nodes_stay_on_the_true_surface_while_they_move() {
    // A piece of the outside of a torus, 1 radian wide in both directions. It is exactly a rational patch, and curved
    // in both directions.
    let (half, big, small) = (0.5f64, 60.0, 25.0);
    let arc = [DVec2::from_angle(-half), DVec2::X / half.cos(), DVec2::from_angle(half)];
    let weights = [1.0, half.cos(), 1.0];
    let at = |i: usize, j: usize| {
        let r = big + small * arc[j].x;
        DVec3::new(r * arc[i].x, r * arc[i].y, small * arc[j].y)
    };
    let patch = Domain::Nurbs(Nurbs {
        degrees: [2, 2],
        knots: [vec![0.0, 0.0, 0.0, 1.0, 1.0, 1.0], vec![0.0, 0.0, 0.0, 1.0, 1.0, 1.0]],
        control_points: (0..3).map(|i| (0..3).map(|j| at(i, j)).collect()).collect(),
        weights: Some((0..3).map(|i| (0..3).map(|j| weights[i] * weights[j]).collect()).collect()),
    });
    let result = run(&patch, &options(3.0)).unwrap();
    check(&result, 3.0);
    for p in &result.mesh.vertices {
        let off = DVec2::new(p.x.hypot(p.y) - big, p.z).length() - small;
        assert!(off.abs() < 1e-9, "off the torus by {off}");
    }
    let [surface, optimised] = [3, 4].map(|k: usize| result.stages[k].lattice.unwrap().lengths.std_dev);
    assert!(optimised < 0.8 * surface, "{surface} {optimised}");
}

#[test]
fn the_rim_stays_within_its_bounds_unless_it_is_free() {
    let bounded = run(&bezier(roof()), &options(4.0)).unwrap();
    check(&bounded, 4.0);
    assert!(rim(&bounded).iter().all(|&l| (4.0 * (1.0 - 1e-8)..=8.0 * (1.0 + 1e-8)).contains(&l)));
    let before = bounded.stages[3].lattice.unwrap().lengths;
    let after = bounded.stages[4].lattice.unwrap().lengths;
    assert!(after.std_dev < 0.8 * before.std_dev);
    let free = run(&bezier(roof()), &Options { transition: Transition::Free, ..options(4.0) }).unwrap();
    check(&free, 4.0);
    let squares = |result: &UniformMesh| -> f64 {
        let lattice = result.lengths.iter().zip(&result.lattice_group).filter(|&(_, &lattice)| lattice);
        lattice.map(|(l, _)| (l - 4.0) * (l - 4.0)).sum()
    };
    assert!(squares(&free) <= squares(&bounded) * (1.0 + 1e-6));
    assert!(rim(&free).iter().any(|&l| !(4.0..=8.0).contains(&l)));
    let rim_out = free.out_of_range.iter().filter(|edge| !free.lattice_group[edge.member]);
    assert!(rim_out.into_iter().any(|edge| edge.why == Why::Optimised));
    assert!(bounded.out_of_range.iter().all(|edge| edge.why == Why::Curvature));
}

#[test]
fn a_rim_that_the_surface_bends_out_of_range_is_made_anew() {
    // The roof is so steep that some members of the rim that was made in the plane become shorter than ℓ or longer than
    // 2ℓ, and its triangles shrink to needles when the lattice moves.
    let steep: Vec<Vec<DVec3>> =
        roof().into_iter().map(|row| row.into_iter().map(|p| p.with_z(1.6 * p.z)).collect()).collect();
    for objective in Objective::ALL {
        let result = run(&bezier(steep.clone()), &Options::new(4.0, objective)).unwrap();
        check(&result, 4.0);
        let before = result.stages[3].all.lengths;
        assert!(before.min < 3.6 || before.max > 8.4, "{before:?}");
        assert!(rim(&result).iter().all(|&l| (4.0 * (1.0 - 1e-8)..=8.0 * (1.0 + 1e-8)).contains(&l)));
        assert!(result.statistics.angles.0.to_degrees() > 15.0, "{}", result.statistics.angles.0.to_degrees());
        // The lattice members are the same as in the plane. Only their nodes have moved.
        if objective == Objective::MostEqualEdges {
            assert_eq!(result.stages[2].lattice.unwrap().lengths.count, result.statistics.lattice_edges.count);
        }
    }
}

#[test]
fn fewest_nodes_on_a_patch_brings_every_member_into_range() {
    let result = run(&bezier(roof()), &Options::new(4.0, Objective::FewestNodes)).unwrap();
    check(&result, 4.0);
    assert_eq!(result.out_of_range, []);
    assert!(result.stages[3].all.lengths.min < 4.0 || result.stages[3].all.lengths.max > 8.0);
}

#[test]
fn a_film_is_meshed_and_its_corners_stay_where_they_are() {
    let boundary = frame(24);
    let result = run(&Domain::Boundaries(vec![boundary.clone()]), &options(4.0)).unwrap();
    check(&result, 4.0);
    assert_eq!(names(&result), ["auxiliary_surface", "auxiliary_plane", "plane", "surface", "optimised_nodes"]);
    for (k, vertex) in result.input_vertices.iter().enumerate() {
        // Points where the frame turns sharply are kept too.
        assert!(vertex.is_some() || k % 24 != 0, "input point {k}");
        if let Some(vertex) = vertex {
            assert_eq!(result.mesh.vertices[*vertex as usize], boundary[k]);
        }
    }
    // All boundary nodes lie on the frame.
    for v in &result.mesh.check().unwrap().boundary_loops()[0] {
        let p = result.mesh.vertices[*v as usize];
        let off = boundary.iter().zip(boundary.iter().cycle().skip(1)).map(|(&a, &b)| {
            let t = ((p - a).dot(b - a) / (b - a).length_squared()).clamp(0.0, 1.0);
            p.distance(a.lerp(b, t))
        });
        assert!(off.fold(f64::INFINITY, f64::min) < 1e-9);
    }
    let [surface, optimised] = [3, 4].map(|k: usize| result.stages[k].lattice.unwrap().lengths);
    assert!(optimised.std_dev < 0.69 * surface.std_dev, "{} {}", surface.std_dev, optimised.std_dev);
    assert!(result.warnings.iter().all(|w| w.code != "film"), "{:?}", result.warnings);
}

#[test]
fn a_film_between_two_rings_becomes_a_ring() {
    let ring = |radius: f64, z: f64| -> Vec<DVec3> {
        let angle = |k: usize| std::f64::consts::TAU * k as f64 / 48.0;
        (0..48).map(|k| (DVec2::from_angle(angle(k)) * radius).extend(z)).collect()
    };
    let film = Domain::Boundaries(vec![ring(30.0, 0.0), ring(12.0, 6.0)]);
    let result = run(&film, &options(3.0)).unwrap();
    let topology = result.mesh.check().unwrap();
    assert_eq!((topology.boundary_loops().len(), topology.euler_characteristic()), (2, 0));
    assert_eq!(measure::flipped_triangles(&result.mesh), 0);
    assert!(result.statistics.lattice_edges.count > 300);
}

#[test]
fn shared_lengths_get_closer_the_more_there_are_and_closer_than_sorting_alone() {
    for domain in [
        bezier(roof()),
        Domain::Polygon {
            outer: roof()[0].iter().chain(roof()[3].iter().rev()).map(|p| p.with_z(0.0)).collect(),
            holes: vec![],
        },
    ] {
        let options =
            Options { optimise: Optimise::Lengths { most: 12 }, length_tolerance: Some(1e-3), ..options(4.0) };
        let result = run(&domain, &options).unwrap();
        check(&result, 4.0);
        let rows = &result.shared_lengths;
        assert_eq!(rows.iter().map(|row| row.lengths).collect::<Vec<_>>(), [1, 2, 3, 4, 6, 8, 12]);
        for pair in rows.windows(2) {
            assert!(pair[1].deviation < pair[0].deviation, "{rows:?}");
        }
        assert!(rows.iter().all(|row| row.deviation <= row.deviation_before));
        assert!(rows[6].deviation < 0.9 * rows[6].deviation_before, "{rows:?}");
        // The mesh has the member lengths of the last row.
        assert_eq!(result.stages.last().unwrap().name, "shared_lengths");
        let within = 2.0 * rows[6].deviation * (1.0 + 1e-9);
        assert!(plateau_uniform_mesh::statistics::distinct_lengths(&result.lengths, within) <= 12);
        assert!(result.warnings.iter().any(|w| w.code == "lengths_not_reached"));
    }
}

#[test]
fn shared_lengths_stop_at_the_first_number_that_is_close_enough() {
    let asked = Options { optimise: Optimise::Lengths { most: 24 }, length_tolerance: Some(0.6), ..options(4.0) };
    let result = run(&bezier(roof()), &asked).unwrap();
    let last = result.shared_lengths.last().unwrap();
    assert!(2.0 * last.deviation <= 0.6 && last.lengths < 24);
    assert!(result.statistics.distinct_lengths <= last.lengths);
    assert!(result.warnings.iter().all(|w| w.code != "lengths_not_reached"));
}

/// A planar polygon.
fn polygon(corners: &[[f64; 2]]) -> Domain {
    Domain::Polygon { outer: corners.iter().map(|p| DVec3::new(p[0], p[1], 0.0)).collect(), holes: vec![] }
}

/// An oval of `n` corners.
fn oval(n: usize) -> Domain {
    let corner = |k: usize| DVec2::from_angle(std::f64::consts::TAU * k as f64 / n as f64) * DVec2::new(20.0, 17.0);
    polygon(&(0..n).map(|k| corner(k).to_array()).collect::<Vec<_>>())
}

/// The nodes of a mesh before and after its lengths are shared.
fn plain_and_shared(domain: &Domain, edge_length: f64, most: usize, tolerance: f64) -> [UniformMesh; 2] {
    [Optimise::Nodes, Optimise::Lengths { most }].map(|optimise| {
        let options = Options { optimise, length_tolerance: Some(tolerance), ..options(edge_length) };
        let result = run(domain, &options).unwrap();
        check(&result, edge_length);
        result
    })
}

#[test]
fn shared_lengths_make_neither_number_worse_and_leave_exact_members_exact() {
    let floor = polygon(&[[0.0, 0.0], [30.0, 0.0], [36.0, 16.0], [20.0, 30.0], [-4.0, 22.0]]);
    let cases = [
        (floor.clone(), 2.0, 12, 0.02),
        (floor, 2.0, 12, 0.002),
        (polygon(&[[0.0, 0.0], [20.0, 0.0], [20.0, 20.0], [0.0, 20.0]]), 2.0, 4, 0.02),
        (oval(5), 2.5, 8, 0.025),
        (oval(7), 2.5, 8, 0.025),
        (oval(9), 2.5, 8, 0.025),
        (cylinder(1.2), 5.0, 8, 0.05),
        (bezier(roof()), 5.0, 12, 0.05),
        (bezier(roof()), 5.0, 12, 0.2),
        (Domain::Boundaries(vec![frame(8)]), 6.0, 10, 0.1),
    ];
    let (mut fewer, mut number) = (0, 0);
    for (case, (domain, edge_length, most, tolerance)) in
        cases.iter().enumerate().step_by(if crate::is_full() { 1 } else { 2 })
    {
        number += 1;
        let [plain, shared] = plain_and_shared(domain, *edge_length, *most, *tolerance);
        let (before, after) = (&plain.statistics, &shared.statistics);
        assert!(after.distinct_lengths <= before.distinct_lengths, "{case}: {before:?} {after:?}");
        assert!(after.out_of_range_edges <= before.out_of_range_edges, "{case}: {before:?} {after:?}");
        let exact = |mesh: &UniformMesh, member: usize| {
            mesh.lattice_group[member] && (mesh.lengths[member] / edge_length - 1.0).abs() < 1e-9
        };
        for member in (0..plain.members.len()).filter(|&member| exact(&plain, member)) {
            assert!(exact(&shared, member), "{case}: {} {}", plain.lengths[member], shared.lengths[member]);
        }
        fewer += usize::from(after.distinct_lengths < before.distinct_lengths);
    }
    assert!(2 * fewer >= number, "{fewer} of {number}");
}

/// On these polygons the whole lattice fits, and all members have the length ℓ.
#[test]
fn a_lattice_of_one_length_is_met_and_stays() {
    let height = 0.75f64.sqrt();
    let at =
        |corners: &[[f64; 2]]| polygon(&corners.iter().map(|[i, j]| [i + 0.5 * j, height * j]).collect::<Vec<_>>());
    for domain in [
        at(&[[0.0, 0.0], [6.0, 0.0], [6.0, 4.0], [0.0, 4.0]]),
        at(&[[0.0, 0.0], [5.0, 0.0], [0.0, 5.0]]),
        at(&[[3.0, 0.0], [6.0, 0.0], [6.0, 3.0], [3.0, 6.0], [0.0, 6.0], [0.0, 3.0]]),
        at(&[[0.0, 0.0], [8.0, 0.0], [5.0, 3.0], [0.0, 3.0]]),
        at(&[[2.0, 0.0], [6.0, 0.0], [6.0, 2.0], [3.0, 5.0], [0.0, 5.0], [0.0, 2.0]]),
    ] {
        let [plain, shared] = plain_and_shared(&domain, 1.0, 1, 1e-6);
        assert_eq!((plain.statistics.distinct_lengths, shared.statistics.distinct_lengths), (1, 1));
        assert_eq!(plain.mesh, shared.mesh);
        assert!(shared.warnings.iter().all(|w| w.code != "lengths_not_reached"));
    }
}

#[test]
fn motions_and_scale_leave_the_figures_alone() {
    let here = run(&bezier(roof()), &options(4.0)).unwrap();
    let (turn, tilt) = (DVec2::from_angle(0.7), DVec2::from_angle(-1.1));
    for (scale, shift) in [(1.0, DVec3::new(1e5, -3e5, 2e4)), (1e6, DVec3::ZERO), (1e-6, DVec3::ZERO)] {
        let moved = |p: DVec3| {
            let p = turn.rotate(p.truncate()).extend(p.z);
            let yz = tilt.rotate(DVec2::new(p.y, p.z));
            DVec3::new(p.x, yz.x, yz.y) * scale + shift
        };
        let net = roof().into_iter().map(|row| row.into_iter().map(moved).collect()).collect();
        let there = run(&bezier(net), &options(4.0 * scale)).unwrap();
        assert_eq!(here.mesh.triangles, there.mesh.triangles);
        let (a, b) = (here.statistics.lattice_edges, there.statistics.lattice_edges);
        assert!((a.std_dev * scale / b.std_dev - 1.0).abs() < 1e-4, "{} {}", a.std_dev, b.std_dev / scale);
    }
}

#[test]
fn runs_are_equal_to_the_byte() {
    for domain in [bezier(roof()), Domain::Boundaries(vec![frame(12)])] {
        let mesh = || run(&domain, &options(5.0)).expect("a mesh");
        assert_eq!(mesh(), mesh());
    }
}

fn places(domain: &Domain, options: &Options) -> Vec<String> {
    match run(domain, options) {
        Err(Error::Input(errors)) => errors.iter().map(|error| error.place.to_string()).collect(),
        other => panic!("expected an input error, got {other:?}"),
    }
}

#[test]
fn bad_input_is_named() {
    let mut net = roof();
    net[1][2].y = f64::NAN;
    assert_eq!(places(&bezier(net), &options(4.0)), ["/domain/bezier/control_points/1/2"]);
    let mut net = roof();
    net[2].pop();
    assert_eq!(places(&bezier(net), &options(4.0)), ["/domain/bezier/control_points/2"]);
    assert_eq!(
        places(&bezier(roof()), &Options { auxiliary_grid: [1, 4000], ..options(4.0) }),
        ["/auxiliary_grid/0", "/auxiliary_grid/1"]
    );
    let lengths = |most| Options { optimise: Optimise::Lengths { most }, ..options(4.0) };
    assert_eq!(places(&bezier(roof()), &lengths(0)), ["/max_distinct_lengths"]);
    let boundaries = |boundary: Vec<DVec3>| Domain::Boundaries(vec![frame(6), boundary]);
    assert_eq!(places(&Domain::Boundaries(vec![]), &options(4.0)), ["/domain/boundaries"]);
    assert_eq!(places(&boundaries(vec![DVec3::X, DVec3::Y]), &options(4.0)), ["/domain/boundaries/1"]);
    assert_eq!(
        places(&boundaries(vec![DVec3::X, DVec3::Y * f64::NAN, DVec3::Z]), &options(4.0)),
        ["/domain/boundaries/1/1"]
    );
    assert_eq!(places(&bezier(roof()), &options(1e-6)), ["/edge_length"]);
}

#[test]
fn surfaces_that_cannot_be_laid_flat_are_refused_or_meshed_validly() {
    // A patch that passes through itself, a very narrow patch, a very tall patch, and edge lengths larger than the
    // patch.
    let mut twisted = roof();
    twisted[3].reverse();
    let mut needle = roof();
    needle.iter_mut().flatten().for_each(|p| p.y *= 1e-3);
    let mut tower = roof();
    tower[1][1].z = 2000.0;
    for (net, edge_length) in [(twisted, 4.0), (needle, 4.0), (tower, 4.0), (roof(), 400.0), (roof(), 60.0)] {
        match run(&bezier(net), &options(edge_length)) {
            Ok(result) => {
                result.mesh.check().unwrap();
                assert_eq!(measure::degenerate_triangles(&result.mesh), 0);
                assert!(result.mesh.vertices.iter().all(|p| p.is_finite()));
            }
            Err(Error::NoResult { reason, .. }) => assert_eq!(reason, "not_flattenable"),
            Err(other) => panic!("{other}"),
        }
    }
}

#[test]
fn progress_rises_and_stopping_is_obeyed() {
    // Seven or thirteen solves for each domain: the first tier takes a third of the members.
    let (edge_length, parts) = if crate::is_full() { (4.0, 12) } else { (7.0, 8) };
    for domain in [bezier(roof()), Domain::Boundaries(vec![frame(parts)])] {
        let asked = Options { optimise: Optimise::Lengths { most: 3 }, ..options(edge_length) };
        let seen = std::cell::RefCell::new(Vec::new());
        let report = |progress: plateau_mesh::Progress| seen.borrow_mut().push(progress.fraction);
        let execution = Execution::new(&|| Signal::Continue, &report);
        solve(&domain, &asked, &execution).unwrap();
        let seen = seen.borrow();
        assert!(seen.windows(2).all(|pair| pair[0] <= pair[1]) && *seen.last().unwrap() == 1.0);
        let total = execution.looks();
        let moments = [0, total / 2, total - 2, total / 8, total / 4, 3 * total / 4];
        for &stop_at in &moments[..if crate::is_full() { moments.len() } else { 3 }] {
            for signal in [Signal::Cancel, Signal::Deadline] {
                let looks = std::cell::Cell::new(0);
                let ask = || {
                    looks.set(looks.get() + 1);
                    if looks.get() > stop_at { signal } else { Signal::Continue }
                };
                match solve(&domain, &asked, &Execution::new(&ask, &|_| {})) {
                    Err(Error::Interrupted(Interruption::Cancelled)) => assert_eq!(signal, Signal::Cancel),
                    Err(Error::Interrupted(Interruption::DeadlinePassed)) => assert_eq!(signal, Signal::Deadline),
                    Ok(result) => {
                        assert_eq!(signal, Signal::Deadline);
                        assert!(!result.converged);
                        result.mesh.check().unwrap();
                        assert_eq!(measure::flipped_triangles(&result.mesh), 0);
                    }
                    Err(other) => panic!("{other}"),
                }
            }
        }
    }
}
