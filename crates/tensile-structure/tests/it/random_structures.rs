//! Random structures, each solved from a good start and from bad starts, in which free parts are displaced. Nearly all
//! bad starts must end in the shape of the good start on the same mesh. No start may report that there is no
//! equilibrium where another start finds it.
//!
//! `PLATEAU_SEED` chooses the structures, `PLATEAU_STRUCTURES` their number, and `PLATEAU_FIRST` the number of the
//! first structure.

use glam::DQuat;
use plateau_equilibrium::Support;
use plateau_equilibrium::support::{Circle, Cylinder, Plane, Sphere, StraightLine};
use plateau_mesh::random::SplitMix64;
use plateau_mesh::{DVec3, Error, Execution};
use plateau_minimal_surface::Resolution;
use plateau_tensile_structure::{
    BoundaryPoint, Cable, CableMode, Chamber, Course, FilmPrestress, FilmStress, Options, Pressure, Ring, Sliding,
    SlidingPart, Structure, check, solve,
};
use std::f64::consts::TAU;
use std::sync::Arc;
use std::time::Instant;

type Random = SplitMix64;

fn direction(random: &mut Random) -> DVec3 {
    let height = random.between(-1.0, 1.0);
    let (sine, cosine) = random.between(0.0, TAU).sin_cos();
    let level = (1.0 - height * height).sqrt();
    DVec3::new(level * cosine, level * sine, height)
}

fn film(boundaries: Vec<Vec<DVec3>>) -> Structure {
    Structure::new(boundaries, vec![FilmStress { prestress: FilmPrestress::Isotropic(1.0), weight: 0.0 }])
}

fn cable(course: Course, mode: CableMode) -> Cable {
    Cable { name: "c".into(), course, mode, axial_stiffness: None, weight: 0.0 }
}

/// Returns for each side the half angle of the arc that its cable is to form. The half angles are well below the angles
/// of the corners, so that the arcs fit.
fn sides(random: &mut Random, corners: &[DVec3]) -> Vec<f64> {
    let count = corners.len();
    let angle = |k: usize| {
        let (a, b) = (corners[(k + count - 1) % count] - corners[k], corners[(k + 1) % count] - corners[k]);
        a.angle_between(b)
    };
    (0..count).map(|k| 0.5 * angle(k).min(angle((k + 1) % count)).min(2.4) * random.between(0.3, 0.85)).collect()
}

/// Returns a cable along side `k` that forms an arc of the half angle `half` under a film of tension 1.
fn side(random: &mut Random, k: usize, count: usize, chord: f64, half: f64) -> Cable {
    let force = 0.5 * chord / half.sin();
    let length = 2.0 * force * half;
    let stiffness = force * random.between(20.0, 500.0);
    let (mode, axial_stiffness) = match random.below(20) {
        0 | 1 => (CableMode::ForceDensity(force / length), None),
        2 | 3 => (CableMode::UnstressedLength(length / (1.0 + force / stiffness)), Some(stiffness)),
        4 => (CableMode::Sag(0.5 * chord * (0.5 * half).tan()), None),
        5 => (CableMode::Length(length), None),
        _ => (CableMode::Force(force), None),
    };
    let course = Course::Boundary { boundary: 0, from: k, to: (k + 1) % count };
    Cable { axial_stiffness, ..cable(course, mode) }
}

/// Returns a cable along each side of a polygon. The cables form arcs of the half angles `halves`.
fn cables(random: &mut Random, corners: &[DVec3], halves: &[f64]) -> Vec<Cable> {
    let count = corners.len();
    let chord = |k: usize| corners[k].distance(corners[(k + 1) % count]);
    (0..count).map(|k| side(random, k, count, chord(k), halves[k])).collect()
}

/// A sail with 3 to 8 corners and cables between them. One to three corners are free and held by stays, or by a mast
/// and stays, or slide on a line or surface. These corners are displaced.
fn sail(random: &mut Random, displaced: f64) -> (&'static str, Structure) {
    let count = 3 + random.below(6);
    let corner = |random: &mut Random, k: usize| {
        let angle = TAU * (k as f64 + random.between(-0.2, 0.2)) / count as f64;
        let radius = random.between(3.5, 6.5);
        DVec3::new(radius * angle.cos(), radius * angle.sin(), random.between(0.0, 3.5) * ((k + 1) % 2) as f64)
    };
    let mut corners: Vec<DVec3> = (0..count).map(|k| corner(random, k)).collect();
    let halves = sides(random, &corners);
    let mut structure = film(Vec::new());
    structure.cables = cables(random, &corners, &halves);
    let force = |k: usize| {
        let chord = corners[k].distance(corners[(k + 1) % count]);
        0.5 * chord / halves[k].sin()
    };
    let forces: Vec<f64> = (0..count).map(force).collect();
    let good = corners.clone();
    let released = 1 + random.below((count - 1).min(3));
    let first = random.below(count);
    let mut kinds = "stay";
    for i in 0..released {
        // Neighbouring corners are not both released if there are enough corners.
        let k = (first + i * if count >= 2 * released { 2 } else { 1 }) % count;
        let (before, here, after) = (good[(k + count - 1) % count], good[k], good[(k + 1) % count]);
        let pull =
            forces[(k + count - 1) % count] * (before - here).normalize() + forces[k] * (after - here).normalize();
        let outward = -pull.normalize();
        let push = displaced * 10.0 * random.between(0.5, 1.0) * direction(random);
        let point = BoundaryPoint { boundary: 0, point: k };
        let mut air: Vec<(DVec3, CableMode, bool)> = Vec::new();
        match random.below(20) {
            0..=6 => {
                let anchor = here + random.between(4.0, 10.0) * outward + 0.5 * direction(random);
                air.push((anchor, CableMode::Force(pull.length() * random.between(0.85, 1.1)), false));
            }
            7..=9 => {
                let turn = random.between(0.3, 0.8);
                for sign in [-1.0, 1.0] {
                    let towards = DQuat::from_axis_angle(DVec3::Z, sign * turn) * outward;
                    let mode = CableMode::Force(0.5 * pull.length() / turn.cos() * random.between(0.9, 1.1));
                    air.push((here + random.between(4.0, 10.0) * towards, mode, false));
                }
            }
            10..=13 => {
                kinds = "mast";
                let level = DVec3::new(outward.x, outward.y, 0.0).normalize();
                let base = here - random.between(2.0, 6.0) * DVec3::Z - random.between(0.0, 1.0) * level;
                for sign in [-1.0, 1.0] {
                    let towards = DQuat::from_axis_angle(DVec3::Z, sign * random.between(0.3, 0.8)) * level;
                    let mode = CableMode::Force(0.7 * pull.length() * random.between(0.9, 1.2));
                    air.push((base + random.between(5.0, 8.0) * towards, mode, false));
                }
                air.push((base, CableMode::Length(base.distance(here)), true));
            }
            _ => {
                kinds = "slides";
                let level = DVec3::new(outward.x, outward.y, 0.0).normalize();
                let along = level.cross(DVec3::Z);
                let radius = random.between(3.0, 8.0);
                let on: Arc<dyn Support> = match random.below(5) {
                    0 => {
                        Arc::new(StraightLine { point: here, direction: (along + 0.3 * direction(random)).normalize() })
                    }
                    1 => Arc::new(Circle { centre: here + radius * level, axis: DVec3::Z, radius }),
                    2 => Arc::new(Plane { point: here, normal: (outward + 0.2 * direction(random)).normalize() }),
                    3 => Arc::new(Sphere { centre: here + radius * outward, radius }),
                    _ => Arc::new(Cylinder { point: here + radius * level, axis: DVec3::Z, radius }),
                };
                corners[k] = on.nearest(on.nearest(here) + push);
                structure.sliding.push(Sliding { part: SlidingPart::Point(point), on, contact_angle: None });
            }
        }
        if !air.is_empty() {
            corners[k] += push;
            structure.free_points.push(point);
        }
        for (end, mode, is_mast) in air {
            let ends = [corners[k], end];
            structure.cables.push(cable(if is_mast { Course::Mast(ends) } else { Course::Air(ends) }, mode));
        }
    }
    structure.boundaries = vec![corners];
    (kinds, structure)
}

fn circle(count: usize, radius: f64, height: f64) -> Vec<DVec3> {
    let at = |k: usize| TAU * k as f64 / count as f64;
    (0..count).map(|k| DVec3::new(radius * at(k).cos(), radius * at(k).sin(), height)).collect()
}

/// A film between a fixed ring and an edge that slides on a surface below it. The edge is displaced and has another
/// size than in equilibrium.
fn skirt(random: &mut Random, displaced: f64) -> (&'static str, Structure) {
    let count = [12, 20, 32, 48][random.below(4)];
    let height = random.between(0.2, 0.52);
    let upper: Vec<DVec3> = circle(count, 1.0, height)
        .into_iter()
        .enumerate()
        .map(|(k, p)| p + random.between(0.0, 0.12) * DVec3::Z * f64::from(u8::from(k % 3 == 0)))
        .collect();
    let on: Arc<dyn Support> = match random.below(3) {
        0 => Arc::new(Plane { point: DVec3::ZERO, normal: DVec3::new(0.15, 0.0, 1.0).normalize() }),
        1 => Arc::new(Sphere { centre: DVec3::new(0.0, 0.0, -8.0), radius: 8.0 }),
        _ => Arc::new(Cylinder { point: DVec3::new(0.0, 0.0, -6.0), axis: DVec3::X, radius: 6.0 }),
    };
    let scale = 1.1 * (1.0 + displaced * random.between(-0.8, 2.0));
    let level = direction(random) * DVec3::new(1.0, 1.0, 0.0);
    let shift = displaced * random.between(0.0, 0.8) * level;
    let lower = circle(count, scale, 0.0).into_iter().map(|p| on.nearest(p + shift)).collect();
    let sliding = vec![Sliding { part: SlidingPart::Boundary(1), on, contact_angle: None }];
    ("skirt", Structure { sliding, ..film(vec![upper, lower]) })
}

/// A curtain with a fixed upper edge, cables at its sides, and a lower edge that slides on a floor.
fn curtain(random: &mut Random, displaced: f64) -> (&'static str, Structure) {
    let (width, height) = (random.between(4.0, 8.0), random.between(2.0, 4.0));
    let y = 6.0 * displaced * random.between(0.5, 1.0) + 0.2;
    let upper = [DVec3::new(0.0, 0.0, height), DVec3::new(width, random.between(-1.0, 1.0), height)];
    let lower = [DVec3::new(width, y + random.between(0.0, 1.0), 0.0), DVec3::new(0.0, y, 0.0)];
    let boundary = vec![upper[0], upper[1], lower[0], lower[1]];
    let floor = || Arc::new(Plane { point: DVec3::ZERO, normal: DVec3::Z });
    let rail = |x: f64| Arc::new(StraightLine { point: DVec3::new(x, 0.0, 0.0), direction: DVec3::Y });
    let slide = |part: SlidingPart, on: Arc<dyn Support>| Sliding { part, on, contact_angle: None };
    let point = |point: usize| SlidingPart::Point(BoundaryPoint { boundary: 0, point });
    let sliding = vec![
        slide(SlidingPart::Edge { boundary: 0, from: 2, to: 3 }, floor()),
        slide(point(2), rail(width)),
        slide(point(3), rail(0.0)),
    ];
    let edge =
        |from: usize, to: usize, force: f64| cable(Course::Boundary { boundary: 0, from, to }, CableMode::Force(force));
    let cables = vec![edge(1, 2, height * random.between(1.0, 2.0)), edge(3, 0, height * random.between(1.0, 2.0))];
    ("curtain", Structure { sliding, cables, ..film(vec![boundary]) })
}

/// A film between a polygon with edge cables and a ring with a hub. A mast holds up the hub; it stands on the ground,
/// or on a joint that hangs on cables (a flying mast). The ring, its hub and the joint are displaced.
fn tent(random: &mut Random, displaced: f64) -> (&'static str, Structure) {
    let count = 4 + random.below(4);
    let flying = random.below(2) == 0;
    let corners: Vec<DVec3> = circle(count, 6.0, 0.0)
        .into_iter()
        .map(|p| p * random.between(0.85, 1.15) + random.between(0.0, 1.0) * DVec3::Z)
        .collect();
    let halves = sides(random, &corners);
    let mut structure = film(Vec::new());
    structure.cables = cables(random, &corners, &halves);
    let height = random.between(0.8, 1.8);
    let rise = 6.0 * displaced * random.between(-0.8, 1.0);
    let mut ring = circle(16, random.between(0.6, 1.2), height + rise);
    ring.reverse();
    let hub = DVec3::new(0.0, 0.0, height + rise);
    structure.rings = vec![Ring { boundary: 1, axis: DVec3::Z, force: 0.0, hub: Some(hub) }];
    let foot = if flying {
        let foot = DVec3::new(0.0, 0.0, -1.0) + displaced * 6.0 * random.between(0.3, 1.0) * direction(random);
        structure.joints = vec![foot];
        for &corner in &corners {
            structure.cables.push(cable(Course::Air([foot, corner]), CableMode::Force(random.between(9.0, 16.0))));
        }
        foot
    } else {
        DVec3::new(0.0, 0.0, -2.0)
    };
    let length = if flying { height + 1.0 } else { height + 2.0 };
    structure.cables.push(cable(Course::Mast([foot, hub]), CableMode::Length(length)));
    structure.boundaries = vec![corners, ring];
    (if flying { "flying mast" } else { "mast and ring" }, structure)
}

/// A film that encloses a volume: a tube of given volume between two rings, or a film over a ring under pressure.
fn closed(random: &mut Random, displaced: f64) -> (&'static str, Structure) {
    if random.below(2) == 0 {
        let height = random.between(0.35, 0.55);
        let radius = random.between(0.9, 1.1);
        let mut boundaries = vec![circle(32, 1.0, -height), circle(32, radius, height)];
        boundaries[1].reverse();
        let cylinder = 0.5 * TAU * height * (1.0 + radius * radius);
        let chambers = vec![Chamber { below: 0, holds: Pressure::Volume(cylinder * random.between(0.5, 1.1)) }];
        return ("volume", Structure { chambers, ..film(boundaries) });
    }
    let boundary: Vec<DVec3> = circle(24, 4.0, 0.0)
        .into_iter()
        .map(|p| p * random.between(0.9, 1.1) + random.between(0.0, 0.5) * DVec3::Z)
        .collect();
    let middle = DVec3::new(0.0, 0.0, 0.3) + 4.0 * displaced * direction(random);
    let mut structure = film(vec![boundary.clone()]);
    if random.below(2) == 0 {
        let points = vec![boundary[0], middle, boundary[12]];
        structure.cables = vec![cable(Course::Across(points), CableMode::Force(random.between(4.0, 12.0)))];
    }
    let pressure = random.between(-0.25, 0.25);
    structure.chambers = vec![Chamber { below: 0, holds: Pressure::Constant(pressure) }];
    ("pressure", structure)
}

/// Returns the kind and the structure of a seed. `displaced` is the displacement of its free parts as a fraction of its
/// span.
fn structure(seed: u64, displaced: f64) -> (&'static str, Structure) {
    let mut random = SplitMix64::new(seed);
    match random.below(20) {
        0..=10 => sail(&mut random, displaced),
        11..=13 => skirt(&mut random, displaced),
        14 => curtain(&mut random, displaced),
        15..=17 => tent(&mut random, displaced),
        _ => closed(&mut random, displaced),
    }
}

struct Ended {
    area: f64,
    energy: f64,
    travels: Vec<f64>,
    iterations: u32,
    angles: (f64, f64),
}

fn ended(structure: &Structure, triangles: usize) -> Result<Ended, String> {
    match solve(structure, &Options::new(Resolution::Triangles(triangles)), &Execution::default()) {
        Ok(shape)
            if shape.statistics.converged && shape.statistics.stability.is_none_or(|s| s.stable == Some(true)) =>
        {
            let statistics = &shape.statistics;
            let angles = (statistics.quality.angles.0.to_degrees(), statistics.quality.angles.1.to_degrees());
            Ok(Ended {
                area: statistics.area,
                energy: statistics.energy,
                travels: shape.ring_travels.clone(),
                iterations: statistics.iterations,
                angles,
            })
        }
        Ok(shape) => Err(format!("not converged or unstable: {:?}", shape.statistics.stop_reason)),
        Err(Error::NoResult { reason, detail, places }) => Err(format!("{reason}: {detail} {places:?}")),
        Err(error) => Err(format!("{error:?}")),
    }
}

/// Lower bound of the relative error that is assumed of an area on a mesh of 2,700 triangles. On coarser meshes the
/// bound grows in inverse proportion to the number of triangles.
const FLOOR: f64 = 2e-4;

#[test]
fn bad_starts_end_in_the_shape_of_the_good_one_on_every_mesh() {
    let number = |name: &str| std::env::var(name).ok().and_then(|text| text.parse::<u64>().ok());
    let long = std::env::var_os("PLATEAU_LONG").is_some();
    let count = number("PLATEAU_STRUCTURES").unwrap_or(if long { 200 } else { 8 });
    let seed = number("PLATEAU_SEED").unwrap_or(1);
    let first = number("PLATEAU_FIRST").unwrap_or(0);
    let meshes: &[usize] = if long { &[300, 900, 2700] } else { &[300, 900] };
    let (mut good, mut known, mut bad, mut alike, mut others, mut denied) = (0, 0, 0, 0, 0, 0);
    let mut times: Vec<f64> = Vec::new();
    for k in first..first + count {
        let seed = seed.wrapping_mul(1_000_003).wrapping_add(k);
        let (kind, own) = structure(seed, 0.0);
        let shapes: Vec<Result<Ended, String>> = meshes.iter().map(|&triangles| ended(&own, triangles)).collect();
        good += shapes.len();
        let finest = shapes.iter().rev().find_map(|shape| shape.as_ref().ok()).map(|shape| shape.area);
        for (shape, triangles) in shapes.iter().zip(meshes) {
            match shape {
                Ok(_) => known += 1,
                Err(error) => {
                    if finest.is_some() && error.contains("no_equilibrium") {
                        denied += 1;
                    }
                    println!("{seed} {kind} {triangles}: good start: {error}");
                }
            }
        }
        let Some(finest) = finest else { continue };
        for displaced in [0.25, 0.5] {
            let (_, far) = structure(seed, displaced);
            if let Err(error) = check(&far, &Options::new(Resolution::Triangles(300))) {
                println!("{seed} {kind} {displaced}: refused: {error:?}");
                continue;
            }
            for (shape, &triangles) in shapes.iter().zip(meshes) {
                let Ok(shape) = shape else { continue };
                let own = 2.0 * (shape.area / finest - 1.0).abs().max(FLOOR * f64::from(2700 / triangles as u32));
                bad += 1;
                let start = Instant::now();
                let result = ended(&far, triangles);
                let seconds = start.elapsed().as_secs_f64();
                times.push(seconds);
                match result {
                    Ok(other) if (other.area / shape.area - 1.0).abs() <= own => {
                        alike += 1;
                        if seconds > 5.0 || other.angles.1 > 150.0 {
                            println!(
                                "{seed} {kind} {displaced} {triangles}: {seconds:.1} s, {} solves, angles {:.0} {:.0}",
                                other.iterations, other.angles.0, other.angles.1
                            );
                        }
                    }
                    Ok(other) => {
                        others += 1;
                        println!(
                            "{seed} {kind} {displaced} {triangles}: another shape: {} for {}, error {own:.1e}, \
                             energy {} for {}, rings travel {:?} and {:?}",
                            other.area, shape.area, other.energy, shape.energy, other.travels, shape.travels
                        );
                    }
                    Err(error) => {
                        denied += usize::from(error.contains("no_equilibrium"));
                        println!("{seed} {kind} {displaced} {triangles}: {error}");
                    }
                }
            }
        }
    }
    times.sort_unstable_by(f64::total_cmp);
    let time = |share: f64| times.get((share * times.len() as f64) as usize).copied().unwrap_or(0.0);
    println!(
        "good starts {known} of {good}, bad starts {alike} of {bad}, another stable shape {others}, denied {denied}, \
         seconds {:.2} {:.2} {:.2}",
        time(0.5),
        time(0.9),
        time(0.999)
    );
    assert!(known as f64 >= 0.6 * good as f64, "{known} of {good}");
    // Not all shapes need to agree, because masts that lean the other way and cables of given length have several
    // stable shapes.
    let least = if long { 0.9 } else { 0.97 };
    assert!(f64::from(alike) >= least * f64::from(bad), "{alike} of {bad}");
    assert_eq!(denied, 0);
}

fn is_found(seed: u64, displaced: f64, triangles: usize) -> Ended {
    let (kind, own) = structure(seed, displaced);
    ended(&own, triangles).unwrap_or_else(|error| panic!("{kind}: {error}"))
}

#[test]
fn the_force_of_a_cable_of_given_sag_does_not_swing_to_and_fro() {
    // A larger force of the cable of given sag moves a corner on stays outwards, where the sag then needs a smaller
    // force.
    let [near, far] = [0.25, 0.5].map(|displaced| is_found(3_000_043, displaced, 900));
    assert!((far.area / near.area - 1.0).abs() < 1e-3, "{} for {}", far.area, near.area);
    assert!(near.iterations < 200 && far.iterations < 200, "{} and {} solves", near.iterations, far.iterations);
}

#[test]
fn a_ring_on_a_flying_mast_that_is_drawn_too_high_comes_down() {
    // The mast is 2.38 long, and the drawing shows it 6.6 long. The drawn film is so high that it pinches off at the
    // ring.
    let [good, far] = [0.0, 0.5].map(|displaced| is_found(3_000_021, displaced, 900));
    assert!((far.area / good.area - 1.0).abs() < 3e-3, "{} for {}", far.area, good.area);
}

#[test]
fn newtons_method_waits_while_the_rounds_come_nearer_slowly() {
    // A mast of given length holds a corner. The movement of the corner in each round is 92% of that in the round
    // before.
    let [good, far] = [0.0, 0.25].map(|displaced| is_found(773_401_320_239, displaced, 900));
    assert!((far.area / good.area - 1.0).abs() < 4e-3, "{} for {}", far.area, good.area);
}

#[test]
fn a_corner_that_closes_far_out_is_found_further_in() {
    // The drawing shows the corner 3.9 away from its place in equilibrium. On the way there, and where the cables alone
    // hold it, the sides of the corner are such long arcs that the corner closes.
    let [good, far] = [0.0, 0.5].map(|displaced| is_found(175_023_525_079, displaced, 900));
    assert!((far.area / good.area - 1.0).abs() < 4e-3, "{} for {}", far.area, good.area);
}
