//! Edges that slide on surfaces: contact angles and surfaces given as meshes are compared with closed forms, and wrong
//! arguments are refused.

use plateau_equilibrium::Support;
use plateau_equilibrium::support::{Cylinder, Mesh, Plane, Sphere, Torus};
use plateau_mesh::{DVec3, Error, Execution};
use plateau_minimal_surface::Resolution;
use plateau_tensile_structure::{
    BoundaryPoint, FilmPrestress, FilmStress, Options, Sliding, SlidingPart, Structure, TensileStructure, check, solve,
};
use std::collections::BTreeMap;
use std::f64::consts::{PI, TAU};
use std::sync::Arc;

fn circle(count: usize, radius: f64, height: f64) -> Vec<DVec3> {
    let at = |k: usize| TAU * k as f64 / count as f64;
    (0..count).map(|k| DVec3::new(radius * at(k).cos(), radius * at(k).sin(), height)).collect()
}

/// A film of tension 1 whose boundary of the number `boundary` slides on the support `on`, at a contact angle in
/// degrees. `None` stands for a right angle.
fn sliding(
    boundaries: Vec<Vec<DVec3>>,
    boundary: usize,
    on: impl Support + 'static,
    degrees: Option<f64>,
) -> Structure {
    let contact_angle = degrees.map(f64::to_radians);
    let layers = vec![FilmStress { prestress: FilmPrestress::Isotropic(1.0), weight: 0.0 }];
    Structure {
        sliding: vec![Sliding { part: SlidingPart::Boundary(boundary), on: Arc::new(on), contact_angle }],
        ..Structure::new(boundaries, layers)
    }
}

fn found(structure: &Structure, triangles: usize) -> TensileStructure {
    let options = Options::new(Resolution::Triangles(triangles));
    let result = solve(structure, &options, &Execution::default()).unwrap();
    let statistics = &result.statistics;
    assert!(statistics.converged && statistics.stability.is_some_and(|s| s.stable == Some(true)), "{statistics:?}");
    assert!(result.warnings.is_empty(), "{:?}", result.warnings);
    let balance = statistics.balance.unwrap();
    let unbalanced = balance.residual_force / balance.magnitudes;
    assert!(balance.imbalance < 1e-9 && unbalanced < 1e-9, "{balance:?}");
    result
}

fn on_edge(result: &TensileStructure, boundary: usize) -> impl Iterator<Item = DVec3> + '_ {
    result.boundaries[boundary].iter().map(|&v| result.mesh.vertices[v as usize])
}

/// Asserts that the errors of the area, of the edge's place and of the contact angle fall with the square of the edge
/// length, and that the error of the angle falls below 0.1 degrees. Errors below 1e-9 are exempt, because a right angle
/// is exact on every mesh.
fn assert_angle_and_order(results: &[(TensileStructure, f64)], degrees: f64, area: f64) {
    let mut errors = Vec::new();
    for (result, of_edge) in results {
        let (least, most) = result.statistics.contact_angle.unwrap();
        let off = [least, most].map(|angle| (angle.to_degrees() - degrees).abs());
        errors.push([result.statistics.area - area, *of_edge, off[0].max(off[1])]);
    }
    println!("{errors:?}");
    assert!(errors[2][2] < 0.1, "{errors:?}");
    for k in 0..3 {
        let order = (errors[0][k] / errors[2][k]).abs().log2() / 2.0;
        assert!(order > 1.7 || errors[0][k].abs() < 1e-9, "{k}: {order} {errors:?}");
    }
}

/// Three meshes by their number of points on a boundary and their number of triangles. Each has half the edge length of
/// the mesh before it.
const MESHES: [(usize, usize); 3] = [(32, 500), (64, 2000), (128, 8000)];

#[test]
fn a_half_catenoid_meets_a_plane_at_a_given_angle() {
    // The film is r = c cosh((z - z0) / c) with dr/dz = -cot θ on the plane z = 0. Hence z0 = c asinh(cot θ), and the
    // radius of the edge is c / sin θ.
    for (degrees, height) in [(60.0f64, 0.5), (110.0, 0.3), (90.0, 0.5)] {
        let start = -(1.0 / degrees.to_radians().tan()).asinh();
        let (mut low, mut neck): (f64, f64) = (0.55, 1.5);
        for _ in 0..80 {
            let middle: f64 = 0.5 * (low + neck);
            *(if middle * (height / middle + start).cosh() < 1.0 { &mut low } else { &mut neck }) = middle;
        }
        let share = |u: f64| PI * neck * neck * (u + 0.5 * (2.0 * u).sinh());
        let area = share(height / neck + start) - share(start);
        let radius = neck / degrees.to_radians().sin();
        let results = MESHES.map(|(count, triangles)| {
            let plane = Plane { point: DVec3::ZERO, normal: DVec3::Z };
            let boundaries = vec![circle(count, 1.0, height), circle(count, 0.9, 0.0)];
            let result = found(&sliding(boundaries, 1, plane, Some(degrees)), triangles);
            assert!(on_edge(&result, 1).all(|p| p.z.abs() < 1e-12));
            let off = on_edge(&result, 1).map(|p| p.length() - radius).fold(0.0, |a: f64, b| a.max(b.abs()));
            (result, off)
        });
        assert_angle_and_order(&results, degrees, area);
    }
}

#[test]
fn the_angle_is_that_on_the_left_of_the_edge() {
    // Reversing the edge or the plane's normal replaces θ by 180° - θ.
    let shape = |reversed: bool, normal: DVec3, degrees: f64| {
        let mut edge = circle(48, 0.9, 0.0);
        if reversed {
            edge.reverse();
        }
        let plane = Plane { point: DVec3::ZERO, normal };
        let result = found(&sliding(vec![circle(48, 1.0, 0.3), edge], 1, plane, Some(degrees)), 600);
        result.statistics.area
    };
    let own = shape(false, DVec3::Z, 70.0);
    for (reversed, normal, degrees) in [(true, DVec3::Z, 110.0), (false, -DVec3::Z, 110.0), (true, -DVec3::Z, 70.0)] {
        let other = shape(reversed, normal, degrees);
        assert!((other / own - 1.0).abs() < 1e-6, "{own} {other}");
    }
    let other = shape(false, DVec3::Z, 110.0);
    assert!((other / own - 1.0).abs() > 1e-3, "{own} {other}");
}

#[test]
fn a_film_in_a_tube_climbs_the_wall_to_the_given_angle() {
    // The film between a ring of radius 0.6 and a tube of radius 1 is a catenoid with dr/dz = tan 60° at the wall, so
    // its waist is c = cos 60°. The angle above the edge is 120°.
    let (neck, inner) = (0.5f64, 0.6);
    let (from, to) = ((inner / neck).acosh(), (1.0 / neck).acosh());
    let height = neck * (to - from);
    let share = |u: f64| PI * neck * neck * (u + 0.5 * (2.0 * u).sinh());
    let results = MESHES.map(|(count, triangles)| {
        let tube = Cylinder { point: DVec3::ZERO, axis: DVec3::Z, radius: 1.0 };
        let boundaries = vec![circle(count, 1.0, 0.1), circle(count * 3 / 4, inner, 0.0)];
        let result = found(&sliding(boundaries, 0, tube, Some(120.0)), triangles);
        let off = on_edge(&result, 0).map(|p| p.z - height).fold(0.0, |a: f64, b| a.max(b.abs()));
        (result, off)
    });
    assert_angle_and_order(&results, 120.0, share(to) - share(from));
}

#[test]
fn a_catenoid_meets_a_ring_beam_of_round_tube_at_a_right_angle() {
    // The film is the catenoid r = cosh z from z = 0.8 down to z = 0.2, where its tangent passes through the centre of
    // the tube.
    let (from, to, tube_radius) = (0.2f64, 0.8f64, 0.4);
    let radius = from.cosh() - tube_radius * from.tanh();
    let centre = DVec3::Z * (from - tube_radius / from.cosh());
    let share = |z: f64| PI * (z + 0.5 * (2.0 * z).sinh());
    let results = MESHES.map(|(count, triangles)| {
        let beam = Torus { centre, axis: DVec3::Z, radius, tube_radius };
        // The edge starts on top of the tube.
        let boundaries = vec![circle(count, to.cosh(), to), circle(count, radius, centre.z + tube_radius)];
        let result = found(&sliding(boundaries, 1, beam, None), triangles);
        assert!(on_edge(&result, 1).all(|p| beam.nearest(p).distance(p) < 1e-12));
        let off = on_edge(&result, 1).map(|p| p.z - from).fold(0.0, |a: f64, b| a.max(b.abs()));
        (result, off)
    });
    let errors = results.map(|(result, off)| [result.statistics.area - (share(to) - share(from)), off]);
    println!("{errors:?}");
    for k in 0..2 {
        assert!((errors[0][k] / errors[2][k]).abs().log2() > 3.8, "{k}: {errors:?}");
    }
}

#[test]
fn a_plane_film_in_a_sphere_meets_it_at_the_angle_of_its_height() {
    // The plane z = 1 cuts the sphere of radius 2 at 60°, on the side of the pole. The ring lies in this plane and
    // holds the film there.
    let area = PI * (3.0 - 1.2 * 1.2);
    let results = MESHES.map(|(count, triangles)| {
        let sphere = Sphere { centre: DVec3::ZERO, radius: 2.0 };
        let edge = circle(count, (4.0f64 - 0.81).sqrt(), 0.9);
        let structure = sliding(vec![edge, circle(count, 1.2, 1.0)], 0, sphere, Some(60.0));
        let result = found(&structure, triangles);
        let off = on_edge(&result, 0).map(|p| p.z - 1.0).fold(0.0, |a: f64, b| a.max(b.abs()));
        (result, off)
    });
    assert_angle_and_order(&results, 60.0, area);
}

#[test]
fn an_edge_between_fixed_points_meets_a_plane_at_a_given_angle() {
    // The film hangs from the straight side y = 0 of a long strip and slides on the floor at the other side. It is
    // plane and leans by the angle `degrees`. Its ends are held in that plane.
    let degrees = 50.0f64;
    let (length, height) = (4.0, 1.0);
    let foot = height / degrees.to_radians().tan();
    let count = 20;
    let at = |k: usize| length * k as f64 / count as f64;
    let mut boundary: Vec<DVec3> = (0..=count).map(|k| DVec3::new(at(k), foot, 0.0)).collect();
    // The points inside the edge start away from their places.
    boundary[1..count].iter_mut().for_each(|p| p.y -= 0.2);
    boundary.extend([DVec3::new(length, 0.0, height), DVec3::new(0.0, 0.0, height)]);
    let plane = Plane { point: DVec3::ZERO, normal: DVec3::Z };
    // Seen from above, the film is on the right of the edge, at smaller y, where its angle with the floor is `degrees`.
    // The contact angle is measured on the left of the edge, where it is 180° - `degrees`.
    let mut structure = sliding(vec![boundary], 0, plane, Some(180.0 - degrees));
    structure.sliding[0].part = SlidingPart::Edge { boundary: 0, from: 0, to: count };
    let result = found(&structure, 600);
    let (least, most) = result.statistics.contact_angle.unwrap();
    println!("{} {}", least.to_degrees(), most.to_degrees());
    assert!((least.to_degrees() - 130.0).abs() < 0.1 && (most.to_degrees() - 130.0).abs() < 0.1);
    let area = length * height / degrees.to_radians().sin();
    assert!((result.statistics.area / area - 1.0).abs() < 1e-9, "{} {area}", result.statistics.area);
    // The pull of both sides and the forces that hold the angle add up to zero over all supports.
    let balance = result.statistics.balance.unwrap();
    assert!(balance.reactions.length() < 1e-9, "{balance:?}");
}

/// A mesh of the square [-2, 2]² as a plane grid, tilted about the x axis by a slope.
fn floor(cells: u32, slope: f64) -> (Vec<DVec3>, Vec<[u32; 3]>) {
    let at = |k: u32| 4.0 * f64::from(k) / f64::from(cells) - 2.0;
    let (mut vertices, mut triangles) = (Vec::new(), Vec::new());
    for j in 0..=cells {
        for i in 0..=cells {
            vertices.push(DVec3::new(at(i), at(j), slope * at(j)));
            if i < cells && j < cells {
                let k = j * (cells + 1) + i;
                triangles.extend([[k, k + 1, k + cells + 2], [k, k + cells + 2, k + cells + 1]]);
            }
        }
    }
    (vertices, triangles)
}

/// A mesh of the unit sphere: an icosahedron whose triangles are divided into four `times` times.
fn icosphere(times: u32) -> (Vec<DVec3>, Vec<[u32; 3]>) {
    let golden = 0.5 * (1.0 + 5f64.sqrt());
    let mut vertices = Vec::new();
    for (a, b) in [(1.0, golden), (-1.0, golden), (1.0, -golden), (-1.0, -golden)] {
        vertices.extend([DVec3::new(0.0, a, b), DVec3::new(a, b, 0.0), DVec3::new(b, 0.0, a)]);
    }
    vertices.iter_mut().for_each(|p| *p = p.normalize());
    let edge = vertices[0].distance(vertices[3]);
    let near = |a: usize, b: usize| vertices[a].distance(vertices[b]) < 1.01 * edge;
    let mut triangles = Vec::new();
    for a in 0..12 {
        for b in a + 1..12 {
            for c in b + 1..12 {
                if near(a, b) && near(b, c) && near(a, c) {
                    let outward = vertices[a].dot(vertices[b].cross(vertices[c])) > 0.0;
                    triangles.push(if outward { [a, b, c] } else { [a, c, b] }.map(|v| v as u32));
                }
            }
        }
    }
    for _ in 0..times {
        let mut middles = BTreeMap::new();
        let mut next = Vec::new();
        for [a, b, c] in triangles {
            let [ab, bc, ca] = [[a, b], [b, c], [c, a]].map(|[a, b]| {
                *middles.entry([a.min(b), a.max(b)]).or_insert_with(|| {
                    vertices.push((vertices[a as usize] + vertices[b as usize]).normalize());
                    vertices.len() as u32 - 1
                })
            });
            next.extend([[a, ab, ca], [ab, b, bc], [ca, bc, c], [ab, bc, ca]]);
        }
        triangles = next;
    }
    (vertices, triangles)
}

#[test]
fn a_plane_given_as_a_mesh_gives_the_plane_s_answer() {
    for slope in [0.0, 0.2] {
        let normal = DVec3::new(0.0, -slope, 1.0).normalize();
        let plane = Plane { point: DVec3::ZERO, normal };
        let edge: Vec<DVec3> = circle(48, 0.9, 0.0).iter().map(|&p| plane.nearest(p)).collect();
        let boundaries = || vec![circle(48, 1.0, 0.5), edge.clone()];
        let exact = found(&sliding(boundaries(), 1, plane, None), 800);
        for (cells, rounding) in [(1, 0.3), (7, 0.1), (20, 0.5)] {
            let (vertices, triangles) = floor(cells, slope);
            let mesh = Mesh::new(&vertices, &triangles, rounding).unwrap();
            let own = found(&sliding(boundaries(), 1, mesh, None), 800);
            assert_eq!(own.mesh.triangles, exact.mesh.triangles);
            let apart = own.mesh.vertices.iter().zip(&exact.mesh.vertices).map(|(a, b)| a.distance(*b));
            let largest = apart.fold(0.0, f64::max);
            assert!(largest < 1e-9, "{cells} {rounding}: {largest}");
        }
    }
}

#[test]
fn an_edge_that_slides_beyond_the_border_of_its_mesh_is_reported() {
    // In equilibrium the edge has a radius of 0.85, but the mesh reaches only to 0.7 from the axis.
    let (vertices, triangles) = floor(8, 0.0);
    let vertices: Vec<DVec3> = vertices.iter().map(|p| *p * 0.35).collect();
    let mesh = Mesh::new(&vertices, &triangles, 0.25).unwrap();
    let structure = sliding(vec![circle(32, 1.0, 0.5), circle(32, 0.5, 0.0)], 1, mesh, None);
    let options = Options::new(Resolution::EdgeLength(0.2));
    let result = solve(&structure, &options, &Execution::default()).unwrap();
    let codes: Vec<&str> = result.warnings.iter().map(|warning| warning.code.name()).collect();
    assert_eq!(codes, ["beyond_support"], "{:?}", result.warnings);
}

#[test]
fn a_sphere_given_as_a_mesh_comes_nearer_to_the_sphere_s_answer_with_the_square_of_its_edges() {
    let edge = circle(60, (1.0f64 - 0.09).sqrt(), 0.3);
    let boundaries = || vec![circle(60, 1.8, 0.8), edge.clone()];
    let sphere = Sphere { centre: DVec3::ZERO, radius: 1.0 };
    let exact = found(&sliding(boundaries(), 1, sphere, None), 2000);
    let mut errors = Vec::new();
    for times in [2, 3, 4] {
        let (vertices, triangles) = icosphere(times);
        let length = vertices[triangles[0][0] as usize].distance(vertices[triangles[0][1] as usize]);
        let mesh = Mesh::new(&vertices, &triangles, 2.5 * length).unwrap();
        let own = found(&sliding(boundaries(), 1, mesh, None), 2000);
        // The heights of the edges are compared, because the vertices of the two films stand at different places along
        // the edge, which is a level circle.
        let height =
            |of: &TensileStructure| on_edge(of, 1).map(|place| place.z).sum::<f64>() / on_edge(of, 1).count() as f64;
        let apart = (height(&own) - height(&exact)).abs();
        let (least, most) = own.statistics.contact_angle.unwrap();
        println!("{times} {length} {apart} {} {}", least.to_degrees(), most.to_degrees());
        assert!((least.to_degrees() - 90.0).abs() < 0.1 && (most.to_degrees() - 90.0).abs() < 0.1);
        errors.push([apart, (own.statistics.area - exact.statistics.area).abs()]);
    }
    println!("{errors:?}");
    for k in 0..2 {
        let order = (errors[0][k] / errors[2][k]).log2() / 2.0;
        assert!(order > 1.7, "{order} {errors:?}");
    }
    assert!(errors[2][0] < 0.01, "{errors:?}");
}

#[test]
fn offsets_and_scales_change_nothing_but_rounding_on_a_mesh_and_at_an_angle() {
    let (vertices, triangles) = icosphere(2);
    let shape = |offset: f64, scale: f64, on_mesh: bool| {
        let place = |p: &DVec3| *p * scale + DVec3::splat(offset);
        let boundaries = [circle(40, 1.8, 0.8), circle(40, 1.0, 0.0)];
        let boundaries = boundaries.iter().map(|points| points.iter().map(place).collect()).collect();
        let vertices: Vec<DVec3> = vertices.iter().map(place).collect();
        let sphere = Sphere { centre: DVec3::splat(offset), radius: scale };
        let mesh = || Mesh::new(&vertices, &triangles, 0.5 * scale).unwrap();
        let structure =
            if on_mesh { sliding(boundaries, 1, mesh(), None) } else { sliding(boundaries, 1, sphere, Some(80.0)) };
        found(&structure, 800).statistics.area / (scale * scale)
    };
    for on_mesh in [true, false] {
        let own = shape(0.0, 1.0, on_mesh);
        // The scales are powers of two, because these change no digit.
        for (offset, scale) in [(1e6, 1.0), (0.0, 131_072.0), (0.0, 1.0 / 131_072.0)] {
            let other = shape(offset, scale, on_mesh);
            assert!((other / own - 1.0).abs() < 1e-7, "{on_mesh} {offset} {scale}: {own} {other}");
        }
    }
}

#[test]
fn what_the_arguments_show_is_refused_by_its_place() {
    let options = Options::new(Resolution::Triangles(200));
    let refused = |structure: &Structure| match check(structure, &options) {
        Err(Error::Input(errors)) => errors.iter().map(|error| error.place.to_string()).collect::<Vec<_>>(),
        other => panic!("{other:?}"),
    };
    let boundaries = || vec![circle(32, 1.0, 0.5), circle(32, 0.9, 0.0)];
    let plane = Plane { point: DVec3::ZERO, normal: DVec3::Z };
    let at = |degrees: f64| sliding(boundaries(), 1, plane, Some(degrees));
    assert!(check(&at(60.0), &options).is_ok());
    for degrees in [0.0, 180.0, -30.0, 200.0, f64::NAN] {
        assert_eq!(refused(&at(degrees)), ["/supports/0/contact_angle_deg"], "{degrees}");
    }
    let changed = |change: &dyn Fn(&mut Structure)| {
        let mut structure = at(60.0);
        change(&mut structure);
        refused(&structure)
    };
    let angle = ["/supports/0/contact_angle_deg"];
    // A contact angle on a torus is refused, because the area beside an edge on a torus has no closed form.
    let beam = Torus { centre: DVec3::Z * -0.1, axis: DVec3::Z, radius: 0.9, tube_radius: 0.1 };
    assert_eq!(changed(&|s| s.sliding[0].on = Arc::new(beam)), angle);
    assert_eq!(changed(&|s| s.layers[0].weight = 0.1), angle);
    let point = SlidingPart::Point(BoundaryPoint { boundary: 1, point: 2 });
    assert_eq!(changed(&|s| s.sliding[0].part = point), angle);
    let (vertices, triangles) = floor(8, 0.0);
    let mesh = |rounding: f64| Mesh::new(&vertices, &triangles, rounding).unwrap();
    assert_eq!(changed(&|s| s.sliding[0].on = Arc::new(mesh(0.5))), angle);
    // A point that is not on the mesh, and a point beyond its border, are refused.
    let mut structure = sliding(boundaries(), 1, mesh(0.1), None);
    assert!(check(&structure, &options).is_ok());
    structure.boundaries[1][3].z = 0.11;
    structure.boundaries[1][7].x = 2.2;
    assert_eq!(refused(&structure), ["/boundaries/1/3", "/boundaries/1/7"]);
    structure.boundaries[1][3].z = f64::NAN;
    assert_eq!(refused(&structure)[0], "/boundaries/1/3");
    // A rounding that reaches too many triangles is refused.
    let (vertices, triangles) = floor(80, 0.0);
    let structure = sliding(boundaries(), 1, Mesh::new(&vertices, &triangles, 3.0).unwrap(), None);
    assert_eq!(refused(&structure), ["/supports/0/on/mesh/rounding"]);
}
