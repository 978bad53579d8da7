//! Cushions: several layers over one boundary with chambers between them. They are compared with closed forms, and
//! faulty inputs are refused.

use plateau_mesh::self_intersections::{self, Order};
use plateau_mesh::{DVec3, Error, Execution};
use plateau_minimal_surface::Resolution;
use plateau_tensile_structure::{
    Cable, CableMode, Chamber, Course, FilmPrestress, FilmStress, Options, Pressure, Structure, TensileStructure,
    WarpDirection, Weave, WeaveHold, check, solve,
};
use std::collections::BTreeMap;
use std::f64::consts::{PI, TAU};

const RADIUS: f64 = 5.0;

fn circle(count: usize) -> Vec<DVec3> {
    let at = |k: usize| TAU * k as f64 / count as f64;
    (0..count).map(|k| RADIUS * DVec3::new(at(k).cos(), at(k).sin(), 0.0)).collect()
}

fn square() -> Vec<DVec3> {
    [(0.0, 0.0), (10.0, 0.0), (10.0, 10.0), (0.0, 10.0)].map(|(x, y)| DVec3::new(x, y, 0.0)).to_vec()
}

fn cushion(boundary: Vec<DVec3>, tensions: &[f64], chambers: &[Pressure]) -> Structure {
    let layer = |&tension: &f64| FilmStress { prestress: FilmPrestress::Isotropic(tension), weight: 0.0 };
    Structure {
        boundaries: vec![boundary],
        layers: tensions.iter().map(layer).collect(),
        cables: Vec::new(),
        across_ends: Vec::new(),
        free_points: Vec::new(),
        sliding: Vec::new(),
        rings: Vec::new(),
        joints: Vec::new(),
        chambers: chambers.iter().enumerate().map(|(below, &holds)| Chamber { below, holds }).collect(),
        up: DVec3::Z,
    }
}

fn found(structure: &Structure, edge_length: f64) -> TensileStructure {
    let options = Options::new(Resolution::EdgeLength(edge_length));
    let result = solve(structure, &options, &Execution::default()).unwrap();
    let statistics = &result.statistics;
    assert!(statistics.converged && statistics.stability.is_some_and(|s| s.stable == Some(true)), "{statistics:?}");
    assert!(result.warnings.is_empty(), "{:?}", result.warnings);
    assert!(statistics.balance.unwrap().imbalance < 1e-9, "{:?}", statistics.balance);
    let check = self_intersections::check(&result.mesh, Order::Spatial, usize::MAX, &Execution::default());
    assert_eq!(check.unwrap().0.pairs, Some(0));
    result
}

/// The height, area and volume of the cap over the circle of a sphere with radius `sphere`.
fn cap(sphere: f64) -> [f64; 3] {
    let height = sphere - (sphere * sphere - RADIUS * RADIUS).sqrt();
    [height, TAU * sphere * height, PI * height * height * (3.0 * sphere - height) / 3.0]
}

/// The smallest and the largest height of each layer.
fn heights(result: &TensileStructure) -> Vec<(f64, f64)> {
    let mut first = 0;
    let mut heights = Vec::new();
    for layer in &result.statistics.layers {
        let triangles = &result.mesh.triangles[first..first + layer.triangles];
        first += layer.triangles;
        let all = || triangles.iter().flatten().map(|&v| result.mesh.vertices[v as usize].z);
        heights.push((all().fold(f64::INFINITY, f64::min), all().fold(f64::NEG_INFINITY, f64::max)));
    }
    assert_eq!(first, result.mesh.triangles.len());
    heights
}

/// The observed order of convergence of errors on a series of meshes, each with half the edge length of the one before.
fn order(errors: &[f64]) -> f64 {
    let n = errors.len() - 1;
    (errors[0] / errors[n]).abs().log2() / n as f64
}

const MESHES: [(usize, f64); 3] = [(24, 1.2), (48, 0.6), (96, 0.3)];

#[test]
fn two_equal_layers_are_a_lens() {
    // Tension 1 and pressure 0.2 give two caps of spheres of radius 10.
    let [height, area, volume] = cap(10.0);
    let mut errors = [Vec::new(), Vec::new(), Vec::new()];
    for (points, edge_length) in MESHES {
        let lens = found(&cushion(circle(points), &[1.0, 1.0], &[Pressure::Constant(0.2)]), edge_length);
        let chamber = lens.statistics.chambers[0];
        assert_eq!(chamber.pressure, 0.2);
        errors[0].push(lens.statistics.area - 2.0 * area);
        errors[1].push(chamber.volume - 2.0 * volume);
        // The same lens, with its volume given instead of its pressure.
        let by_volume = found(&cushion(circle(points), &[1.0, 1.0], &[Pressure::Volume(2.0 * volume)]), edge_length);
        let chamber = by_volume.statistics.chambers[0];
        assert!((chamber.volume / (2.0 * volume) - 1.0).abs() < 1e-9, "{chamber:?}");
        errors[2].push(chamber.pressure - 0.2);
        let [(_, top), (bottom, _)] = heights(&lens)[..] else { panic!() };
        let error = 0.08 * edge_length * edge_length;
        assert!((top - height).abs() < error && (bottom + height).abs() < error, "{top} {bottom} {height}");
        // The pressure acts on both layers, so the supports bear only the pull of the films.
        let balance = lens.statistics.balance.unwrap();
        assert!(balance.loads.length() < 1e-9 && balance.reactions.length() < 1e-9, "{balance:?}");
    }
    println!("{errors:?} {:?}", errors.each_ref().map(|errors| order(errors)));
    assert!(errors.iter().all(|errors| order(errors) > 1.7), "{errors:?}");
}

#[test]
fn layers_of_unequal_prestress_have_the_radii_of_their_own_tension() {
    // The radii 2 σ / p are 20 / 3 and 40 / 3.
    let (tensions, pressure) = ([1.0, 2.0], 0.3);
    let [upper, lower] = tensions.map(|tension| cap(2.0 * tension / pressure));
    let mut errors = [Vec::new(), Vec::new(), Vec::new(), Vec::new()];
    for (points, edge_length) in MESHES {
        let result = found(&cushion(circle(points), &tensions, &[Pressure::Constant(pressure)]), edge_length);
        let statistics = &result.statistics;
        errors[0].push(statistics.layers[0].area - upper[1]);
        errors[1].push(statistics.layers[1].area - lower[1]);
        errors[2].push(statistics.chambers[0].volume - upper[2] - lower[2]);
        let volume = Pressure::Volume(upper[2] + lower[2]);
        let by_volume = found(&cushion(circle(points), &tensions, &[volume]), edge_length);
        errors[3].push(by_volume.statistics.chambers[0].pressure - pressure);
        let [(_, top), (bottom, _)] = heights(&result)[..] else { panic!() };
        let error = 0.16 * edge_length * edge_length;
        assert!((top - upper[0]).abs() < error && (bottom + lower[0]).abs() < error, "{top} {bottom}");
        for (layer, tension) in statistics.layers.iter().zip(tensions) {
            let stress = layer.stress.unwrap();
            assert!(stress.min > 0.9 * tension && stress.max < 1.1 * tension, "{stress:?}");
        }
    }
    println!("{errors:?} {:?}", errors.each_ref().map(|errors| order(errors)));
    assert!(errors.iter().all(|errors| order(errors) > 1.7), "{errors:?}");
}

#[test]
fn the_layer_between_two_chambers_has_the_radius_of_their_difference() {
    // Pressures of 0.2 and 0.15 at a tension of 1 give the radii 10, 40 and 40 / 3. The middle layer bulges into the
    // lower chamber.
    let pressures = [0.2, 0.15];
    let [upper, middle, lower] = [10.0, 40.0, 40.0 / 3.0].map(cap);
    let volumes = [upper[2] + middle[2], lower[2] - middle[2]];
    let mut errors = [Vec::new(), Vec::new(), Vec::new(), Vec::new(), Vec::new()];
    for (points, edge_length) in MESHES {
        let result = found(&cushion(circle(points), &[1.0; 3], &pressures.map(Pressure::Constant)), edge_length);
        for k in 0..2 {
            errors[k].push(result.statistics.chambers[k].volume - volumes[k]);
        }
        errors[4].push(result.statistics.layers[1].area - middle[1]);
        let by_volume = found(&cushion(circle(points), &[1.0; 3], &volumes.map(Pressure::Volume)), edge_length);
        for k in 0..2 {
            errors[2 + k].push(by_volume.statistics.chambers[k].pressure - pressures[k]);
        }
        let (lowest, _) = heights(&result)[1];
        assert!((lowest + middle[0]).abs() < 0.02, "{lowest}");
    }
    println!("{errors:?} {:?}", errors.each_ref().map(|errors| order(errors)));
    assert!(errors.iter().all(|errors| order(errors) > 1.7), "{errors:?}");
    // The first chamber has a prescribed pressure, the second a prescribed volume.
    let mixed = [Pressure::Constant(0.2), Pressure::Volume(volumes[1])];
    let result = found(&cushion(circle(48), &[1.0; 3], &mixed), 0.6);
    assert!((result.statistics.chambers[1].pressure - 0.15).abs() < 2e-3, "{:?}", result.statistics.chambers);
}

#[test]
fn a_hall_of_two_layers_stands_on_the_ground() {
    // With 0.2 between the layers and 0.3 below the inner layer, the outer layer has the radius 10, the inner layer 20.
    let [outer, inner] = [10.0, 20.0].map(cap);
    let hall = found(&cushion(circle(96), &[1.0; 2], &[0.2, 0.3].map(Pressure::Constant)), 0.3);
    let [between, below] = hall.statistics.chambers[..] else { panic!() };
    assert!((between.volume / (outer[2] - inner[2]) - 1.0).abs() < 5e-3, "{between:?}");
    assert!((below.volume / inner[2] - 1.0).abs() < 5e-3, "{below:?}");
    // The ground bears the pressure on the opening: 0.2 from the outer layer and 0.3 - 0.2 from the inner layer.
    let opening = 0.5 * 96.0 * RADIUS * RADIUS * (TAU / 96.0).sin();
    let loads = hall.statistics.balance.unwrap().loads;
    assert!((loads.z / (0.3 * opening) - 1.0).abs() < 1e-9, "{loads} {}", 0.3 * opening);
}

/// Two fields joined by a neck that is narrower than an edge, so that a plane mesh has edges across the neck from
/// boundary to boundary.
fn dumbbell() -> Vec<DVec3> {
    let half = [(0.0, -2.0), (4.0, -2.0), (4.0, -0.3), (8.0, -0.3), (8.0, -2.0), (12.0, -2.0)];
    let other = half.iter().rev().map(|(x, y)| (*x, -y));
    half.iter().copied().chain(other).map(|(x, y)| DVec3::new(x, y, 0.0)).collect()
}

/// Asserts that every edge has two triangles: both of one layer inside, and one of each layer on the boundary.
fn assert_only_the_edge_is_shared(cushion: &TensileStructure) {
    let mut edges = BTreeMap::new();
    for &[a, b, c] in &cushion.mesh.triangles {
        for [a, b] in [[a, b], [b, c], [c, a]] {
            *edges.entry([a.min(b), a.max(b)]).or_insert(0) += 1;
        }
    }
    assert!(edges.values().all(|count| *count == 2), "an edge of both layers inside");
}

#[test]
fn layers_come_apart_in_a_neck_that_is_narrower_than_an_edge() {
    // A long film of width b under a pressure p is an arc of radius σ / p and height b² p / (8 σ). Edges longer than
    // the width leave a single row of vertices in the neck.
    let arc = 0.6 * 0.6 * 0.1 / 8.0;
    for (edge_length, off) in [(2.0, 0.5), (1.0, 0.5), (0.2, 0.1)] {
        let cushion = found(&cushion(dumbbell(), &[1.0, 1.0], &[Pressure::Constant(0.1)]), edge_length);
        assert_only_the_edge_is_shared(&cushion);
        let [upper, _] = cushion.statistics.layers[..] else { panic!() };
        let triangles = &cushion.mesh.triangles[..upper.triangles];
        let places = triangles.iter().flatten().map(|&v| cushion.mesh.vertices[v as usize]);
        let height = places.filter(|p| (5.0..7.0).contains(&p.x)).map(|p| p.z).fold(0.0, f64::max);
        assert!((height / arc - 1.0).abs() < off, "{height} of {arc} with edges of {edge_length}");
    }
}

#[test]
fn layers_share_their_edge_and_nothing_else() {
    for edge_length in [2.5, 1.0] {
        let cushion = found(&cushion(square(), &[1.0, 1.0], &[Pressure::Constant(0.1)]), edge_length);
        assert_only_the_edge_is_shared(&cushion);
        let rim = &cushion.boundaries[0];
        assert!(rim.len() >= 4 && cushion.statistics.layers.iter().all(|layer| layer.triangles > 8));
        // The layers are mirror images of each other.
        let [(_, top), (bottom, _)] = heights(&cushion)[..] else { panic!() };
        assert!((top + bottom).abs() < 1e-6 * top && top > 0.3, "{top} {bottom}");
    }
}

#[test]
fn an_edge_cable_bears_the_pull_of_both_layers() {
    // At a small pressure the cushion is nearly plane, and its edges are arcs of radius T / (σ + σ) = 10.
    let cable = |k: usize| Cable {
        name: format!("edge {k}"),
        course: Course::Boundary { boundary: 0, from: k, to: (k + 1) % 4 },
        mode: CableMode::Force(20.0),
        axial_stiffness: None,
        weight: 0.0,
    };
    let mut structure = cushion(square(), &[1.0, 1.0], &[Pressure::Constant(1e-3)]);
    structure.cables = (0..4).map(cable).collect();
    let flat = found(&structure, 0.5);
    let sag = 10.0 - 75f64.sqrt();
    assert!((flat.cables[0].sag / sag - 1.0).abs() < 5e-3, "{} {sag}", flat.cables[0].sag);
    // When the cushion is inflated, the layers pull inwards less, because they leave the edge at an angle to the plane.
    structure.chambers[0].holds = Pressure::Constant(0.2);
    let inflated = found(&structure, 0.5);
    println!("{} {} {:?}", flat.cables[0].sag, inflated.cables[0].sag, inflated.statistics.chambers);
    assert!(inflated.cables[0].sag < 0.95 * sag, "{}", inflated.cables[0].sag);
    assert_eq!(inflated.reactions.len(), 4);
    let again = inflated.statistics.chambers[0].volume;
    structure.chambers[0].holds = Pressure::Volume(again);
    let by_volume = found(&structure, 0.5);
    assert!((by_volume.statistics.chambers[0].pressure / 0.2 - 1.0).abs() < 1e-3);
}

#[test]
fn a_heavy_layer_that_falls_through_the_one_below_is_reported() {
    let mut structure = cushion(circle(48), &[1.0, 1.0], &[Pressure::Constant(0.01)]);
    structure.layers[0].weight = 0.05;
    let options = Options::new(Resolution::EdgeLength(0.8));
    let result = solve(&structure, &options, &Execution::default()).unwrap();
    assert!(result.statistics.chambers[0].volume < 0.0, "{:?}", result.statistics.chambers);
    assert!(result.warnings.iter().any(|warning| warning.code == "layers_cross"), "{:?}", result.warnings);
    let load = result.statistics.balance.unwrap().loads.z / (0.05 * result.statistics.layers[0].area);
    assert!((load + 1.0).abs() < 1e-3, "{load}");
}

#[test]
fn what_the_arguments_show_is_refused_by_its_place() {
    let options = Options::new(Resolution::Triangles(200));
    let places = |structure: &Structure| match check(structure, &options) {
        Err(Error::Input(errors)) => errors.iter().map(|error| error.place.to_string()).collect::<Vec<_>>(),
        other => panic!("{other:?}"),
    };
    let with = |chambers: &[Pressure]| cushion(circle(64), &[1.0, 1.0, 1.0], chambers);
    let sound = [Pressure::Constant(0.2), Pressure::Volume(20.0)];
    assert!(check(&with(&sound), &options).is_ok());
    let changed = |change: &dyn Fn(&mut Structure)| {
        let mut structure = with(&sound);
        change(&mut structure);
        places(&structure)
    };
    assert_eq!(changed(&|s| s.layers.clear()), ["/layers"]);
    assert_eq!(changed(&|s| s.layers[1].prestress = FilmPrestress::Isotropic(-1.0)), ["/layers/1/tension"]);
    assert_eq!(changed(&|s| s.layers[2].weight = f64::NAN), ["/layers/2/weight"]);
    let weave = Weave { warp: 1.0, weft: 2.0, direction: WarpDirection::Parallel(DVec3::X), hold: WeaveHold::Ratio };
    assert_eq!(changed(&|s| s.layers[0].prestress = FilmPrestress::Woven(weave.clone())), ["/layers/0/warp"]);
    assert_eq!(changed(&|s| s.chambers[1].below = 3), ["/chambers/1/below", "/chambers"]);
    assert_eq!(changed(&|s| s.chambers[1].below = 0), ["/chambers/1/below", "/chambers"]);
    assert_eq!(changed(&|s| s.chambers.truncate(1)), ["/chambers"]);
    assert_eq!(changed(&|s| s.chambers[1].holds = Pressure::Volume(0.0)), ["/chambers/1/volume"]);
    assert_eq!(changed(&|s| s.chambers[0].holds = Pressure::Constant(f64::NAN)), ["/chambers/0/pressure"]);
    // The pressure limit of the upper layer is 2 σ / r = 0.4.
    let limit = changed(&|s| s.chambers[0].holds = Pressure::Constant(0.41));
    assert_eq!(limit, ["/chambers/0/pressure"]);
    // The middle layer is above its limit, because the difference of the two pressures, 0.49, acts on it.
    assert_eq!(places(&with(&[0.39, -0.1].map(Pressure::Constant))), ["/chambers/1/pressure"]);
    let two = |pressure: f64| cushion(circle(64), &[1.0, 1.0], &[Pressure::Constant(pressure)]);
    assert_eq!(places(&two(0.0)), ["/chambers/0/pressure"]);
    assert_eq!(places(&two(-0.1)), ["/chambers/0/pressure"]);
    // At these pressures two of the three layers would coincide.
    assert_eq!(places(&with(&[0.1, 0.2].map(Pressure::Constant))), ["/chambers/0/pressure"]);
    assert_eq!(places(&with(&[0.2, 0.1].map(Pressure::Constant))), ["/chambers/1/pressure"]);
    // The space between two layers is closed whatever their edge is. The space below the last layer is closed only if
    // its edge is fixed.
    let mut hangs = cushion(square(), &[1.0, 1.0], &[0.1, 0.15].map(Pressure::Constant));
    let course = Course::Boundary { boundary: 0, from: 0, to: 1 };
    let mode = CableMode::Force(20.0);
    hangs.cables.push(Cable { name: "edge".into(), course, mode, axial_stiffness: None, weight: 0.0 });
    assert_eq!(places(&hangs), ["/chambers/1/pressure"]);
    hangs.chambers.truncate(1);
    assert!(check(&hangs, &options).is_ok());
    hangs.cables[0].course = Course::Across(vec![hangs.boundaries[0][0], hangs.boundaries[0][2]]);
    assert_eq!(places(&hangs), ["/cables/0/across"]);
}
