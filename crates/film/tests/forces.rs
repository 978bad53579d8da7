//! The forces that are reported for tensile structures: at the ends of cables, at clamped edges, and in every triangle.

#![allow(clippy::disallowed_macros, reason = "this is a test")]

use plateau_film::minimal_surface::Resolution;
use plateau_film::tensile_structure::{
    Cable, CableMode, Course, FilmPrestress, FilmStress, Options, Ring, Structure, TensileStructure, WarpDirection,
    Weave, WeaveHold, solve,
};
use plateau_mesh::{DVec3, Error, Execution};

fn film(corners: &[(f64, f64, f64)], weight: f64) -> Structure {
    let corners = corners.iter().map(|&(x, y, z)| DVec3::new(x, y, z)).collect();
    Structure::new(vec![corners], vec![FilmStress { prestress: FilmPrestress::Isotropic(1.0), weight }])
}

fn cable(course: Course, mode: CableMode, weight: f64) -> Cable {
    Cable { name: "cable".into(), course, mode, axial_stiffness: None, weight }
}

fn found(structure: &Structure, triangles: usize) -> TensileStructure {
    solve(structure, &Options::new(Resolution::Triangles(triangles)), &Execution::default()).unwrap()
}

#[test]
fn the_largest_force_of_a_heavy_cable_is_that_at_its_upper_end() {
    let ends = [DVec3::new(0.0, 3.0, 6.0), DVec3::new(10.0, 3.0, 9.0)];
    let hanging = cable(Course::Air(ends), CableMode::Sag(1.5), 0.8);
    let plain = film(&[(0.0, 0.0, 0.0), (1.0, 0.0, 0.0), (1.0, 1.0, 0.0), (0.0, 1.0, 0.0)], 0.0);
    for triangles in [200, 800] {
        let result = found(&Structure { cables: vec![hanging.clone()], ..plain.clone() }, triangles);
        let (least, largest) = result.cables[0].force_range;
        let at_the_top = result.reactions.iter().map(|reaction| reaction.force.length()).fold(0.0, f64::max);
        println!("{largest} {at_the_top} {:?}", result.cables[0].segment_forces.last());
        assert!((largest / at_the_top - 1.0).abs() < 1e-4, "{largest} {at_the_top}");
        assert!(
            largest > *result.cables[0].segment_forces.last().unwrap() && least < result.cables[0].segment_forces[0]
        );
        // From the lowest to the highest point, the force grows by the weight per length times the height.
        let lowest =
            result.mesh.vertices.iter().skip(4).map(|p| p.z).filter(|z| *z > 1.0).fold(f64::INFINITY, f64::min);
        assert!((largest - least - 0.8 * (9.0 - lowest)).abs() < 2e-2, "{largest} {least} {lowest}");
    }
}

#[test]
fn the_end_of_a_cable_at_a_clamped_edge_bears_the_cable_alone() {
    let outline =
        [(0.0, 0.0, 0.0), (10.0, 0.0, 0.0), (10.0, 5.0, 0.0), (10.0, 10.0, 0.0), (0.0, 10.0, 0.0), (0.0, 5.0, 0.0)];
    let course = Course::Across(vec![DVec3::new(0.0, 5.0, 0.0), DVec3::new(10.0, 5.0, 0.0)]);
    for triangles in [100, 1600] {
        let plain = film(&outline, 0.0);
        let cables = vec![cable(course.clone(), CableMode::Force(5.0), 0.0)];
        let result = found(&Structure { cables, ..plain }, triangles);
        let force = |x: f64| {
            let at = |vertex: u32| result.mesh.vertices[vertex as usize];
            let reaction = result.reactions.iter().find(|reaction| at(reaction.vertex) == DVec3::new(x, 5.0, 0.0));
            reaction.expect("a reaction at each end").force
        };
        assert!(force(0.0).distance(DVec3::new(-5.0, 0.0, 0.0)) < 1e-9, "{}", force(0.0));
        assert!(force(10.0).distance(DVec3::new(5.0, 0.0, 0.0)) < 1e-9, "{}", force(10.0));
        // The edge bears the film's pull, whose sum around a plane square is zero.
        let [edge] = &result.edge_reactions[..] else { panic!("{:?}", result.edge_reactions) };
        assert!(edge.force.length() < 1e-9, "{}", edge.force);
    }
}

#[test]
fn the_force_per_length_along_held_edges_is_the_films_pull() {
    // A plane film: the warp pulls at the two sides that are perpendicular to x, the weft at the other two.
    let weave =
        Weave { warp: 3.0, weft: 1.0, direction: WarpDirection::Parallel(DVec3::X), hold: WeaveHold::Magnitudes };
    let layers = vec![FilmStress { prestress: FilmPrestress::Woven(weave), weight: 0.0 }];
    let corners = [(0.0, 0.0), (4.0, 0.0), (4.0, 2.0), (0.0, 2.0)].map(|(x, y)| DVec3::new(x, y, 0.0));
    let result = found(&Structure::new(vec![corners.to_vec()], layers), 200);
    assert_eq!(result.edge_forces.len(), result.boundaries[0].len());
    let mut sum = DVec3::ZERO;
    for force in &result.edge_forces {
        let [a, b] = force.segment.map(|v| result.mesh.vertices[v as usize]);
        let middle = 0.5 * (a + b) - DVec3::new(2.0, 1.0, 0.0);
        let expected = if a.x == b.x { 3.0 * middle.x.signum() * DVec3::X } else { middle.y.signum() * DVec3::Y };
        assert!(force.per_length.distance(expected) < 1e-9, "{force:?} {expected}");
        sum += force.per_length.abs() * a.distance(b);
    }
    assert!(sum.distance(DVec3::new(12.0, 8.0, 0.0)) < 1e-9, "{sum}");
    let (least, most) = result.edge_reactions[0].per_length.unwrap();
    assert!((least - 1.0).abs() < 1e-9 && (most - 3.0).abs() < 1e-9);
    // A film of tension 1 over a square pulls with 1 on its fixed sides. The side along which a cable runs is no part
    // of the fixed edge.
    let mut two = film(&[(0.0, 0.0, 0.0), (8.0, 0.0, 0.0), (8.0, 8.0, 0.0), (0.0, 8.0, 0.0)], 0.0);
    two.cables = vec![cable(Course::Boundary { boundary: 0, from: 0, to: 1 }, CableMode::Force(9.0), 0.0)];
    let one = found(&two, 200);
    assert!(one.edge_reactions[0].per_length.is_some_and(|(least, most)| least > 0.99 && most < 1.01));
    let on_cable = |v: u32| one.cables[0].vertices.contains(&v);
    assert!(one.edge_forces.iter().all(|force| !force.segment.iter().all(|&v| on_cable(v))));
}

#[test]
fn all_reactions_balance_in_their_sum_and_in_their_moments() {
    // A mast lifts a ring that is off the centre of a skew frame. One side of the frame is a cable.
    let circle = |k: u32| DVec3::new(1.0 + libm::cos(f64::from(k) * 0.5), 0.5 - libm::sin(f64::from(k) * 0.5), 1.0);
    let hub = DVec3::new(1.0, 0.5, 1.0);
    let mut structure = film(&[(-5.0, -5.0, 0.0), (5.0, -4.0, 1.0), (6.0, 5.0, 0.0), (-5.0, 6.0, -1.0)], 0.0);
    structure.boundaries.push((0..12).map(circle).collect());
    structure.rings = vec![Ring { boundary: 1, axis: DVec3::Z, force: 0.0, hub: Some(hub) }];
    let mast = Course::Mast([DVec3::new(1.0, 0.5, -3.0), hub]);
    structure.cables = vec![
        cable(Course::Boundary { boundary: 0, from: 1, to: 2 }, CableMode::Force(15.0), 0.0),
        cable(mast, CableMode::Length(4.5), 0.0),
    ];
    let result = found(&structure, 1000);
    let at = |v: u32| result.mesh.vertices[v as usize];
    let single = result.reactions.iter().map(|reaction| (reaction.vertex, reaction.force));
    let all: Vec<(u32, DVec3)> = single.chain(result.edge_supports.iter().copied()).collect();
    let sum = all.iter().map(|(_, force)| *force).sum::<DVec3>();
    let moment = all.iter().map(|(v, force)| at(*v).cross(*force)).sum::<DVec3>();
    let magnitudes: f64 = all.iter().map(|(_, force)| force.length()).sum();
    println!("{sum} {moment} {magnitudes}");
    assert!(sum.length() < 1e-9 * magnitudes && moment.length() < 1e-8 * magnitudes, "{sum} {moment}");
    // The ring's guide bears a moment and a force across its axis.
    let guide = result.edge_reactions.iter().find(|edge| edge.boundary == 1).unwrap();
    assert!(guide.force.truncate().length() > 1e-3 && guide.force.z.abs() < 1e-6, "{guide:?}");
}

#[test]
fn stresses_cables_and_weights_balance_at_every_free_vertex() {
    let weight = 0.05;
    let mut sail = film(&[(0.0, 0.0, 0.0), (8.0, 0.0, 3.0), (8.0, 8.0, 0.0), (0.0, 8.0, 3.0)], weight);
    sail.cables = (0..4)
        .map(|k| {
            let course = Course::Boundary { boundary: 0, from: k, to: (k + 1) % 4 };
            cable(course, CableMode::Force(9.0), 0.1)
        })
        .collect();
    let result = found(&sail, 600);
    let at = &result.mesh.vertices;
    let mut forces = vec![DVec3::ZERO; at.len()];
    for (triangle, stress) in result.mesh.triangles.iter().zip(&result.stresses) {
        let corners = triangle.map(|v| at[v as usize]);
        let double = (corners[1] - corners[0]).cross(corners[2] - corners[0]);
        let normal = double.normalize();
        let across = normal.cross(stress.direction);
        for k in 0..3 {
            let edge = 0.5 * normal.cross(corners[(k + 2) % 3] - corners[(k + 1) % 3]);
            let pull = stress.principal.1 * stress.direction.dot(edge) * stress.direction
                + stress.principal.0 * across.dot(edge) * across;
            forces[triangle[k] as usize] -= pull + DVec3::Z * (weight * double.length() / 6.0);
        }
    }
    let mut is_free = vec![true; at.len()];
    for cable in &result.cables {
        for (pair, force) in cable.vertices.windows(2).zip(&cable.segment_forces) {
            let [a, b] = [pair[0] as usize, pair[1] as usize];
            let segment = at[b] - at[a];
            forces[a] += *force * segment.normalize() - DVec3::Z * (0.05 * segment.length());
            forces[b] -= *force * segment.normalize() + DVec3::Z * (0.05 * segment.length());
        }
        is_free[cable.vertices[0] as usize] = false;
    }
    assert_eq!(result.stresses.len(), result.mesh.triangles.len());
    let worst = forces.iter().zip(&is_free).filter(|(_, free)| **free).map(|(force, _)| force.length());
    let worst = worst.fold(0.0, f64::max);
    println!("{worst}");
    assert!(worst < 1e-9, "{worst}");
}

#[test]
fn a_film_whose_weight_takes_its_tension_fails_and_names_it() {
    // The film stands upright and is 20 high, so the tension at the bottom is 1 - 0.2 × 10 = -1.
    let corners = [(0.0, 0.0, 0.0), (4.0, 0.0, 0.0), (4.0, 0.0, 20.0), (0.0, 0.0, 20.0)];
    let solved =
        |weight: f64| solve(&film(&corners, weight), &Options::new(Resolution::Triangles(800)), &Execution::default());
    match solved(0.2) {
        Err(Error::NoResult { reason, places, detail }) => {
            assert_eq!(
                (reason.name(), places[0].place.to_string()),
                ("no_equilibrium", "/film".to_owned()),
                "{detail}"
            );
        }
        other => panic!("{other:?}"),
    }
    let least = solved(0.09).unwrap().statistics.stress.unwrap().min;
    assert!(least > 0.1 && least < 0.2, "{least}");
}
