//! Compares bodies with closed forms and with finite differences.

use super::constraint::add_rank_one_products;
use super::support::{Circle, Cylinder, Mesh, Plane, Sphere, StraightLine, Torus};
use super::*;
use crate::energy::area::first_variation;
use crate::energy::cable::{Cable, Law};
use crate::energy::finite_differences::patch as bumpy_patch;
use crate::energy::length::{self, Stretch};
use crate::energy::{Length, Term, Volume, Weight};
use crate::motion::Motion;
use crate::normal_motion::NormalMotion;
use glam::DMat3;
use newton::{Equations, State};
use plateau_mesh::complex::{Complex, has_junctions};
use plateau_mesh::measure;
use plateau_mesh::sparse::LinearError;
use plateau_mesh::sparse::pattern::Pattern;
use plateau_mesh::structured::{catenoid, cylinder, patch};
use plateau_mesh::{DVec3, Execution};
use std::f64::consts::{PI, TAU};
use std::sync::Arc;

fn relaxed(body: &mut Body) -> Report {
    let settings = Settings { tolerance: 1e-10, ..Settings::default() };
    let report = body.relax(&settings, &Execution::default(), &mut |_, _| {}).unwrap();
    assert_eq!(report.outcome, Outcome::Converged, "{report:?}");
    report
}

/// Asserts that errors on meshes, each with half the edge length of the one before, fall to about a quarter from one to
/// the next.
fn assert_second_order(errors: &[f64]) {
    assert!(errors.windows(2).all(|pair| (3.6..4.4).contains(&(pair[0] / pair[1]).abs())), "{errors:?}");
}

/// A mesh of the unit disc with a vertex at the centre and `rings` rings of 6, 12, 18, … vertices. Returns the polar
/// coordinates (radius, angle) of the vertices, the centre first, and the triangles.
fn disc(rings: u32) -> (Vec<(f64, f64)>, Vec<[u32; 3]>) {
    let first = |ring: u32| if ring == 0 { 0 } else { 1 + 3 * ring * (ring - 1) };
    let mut places = vec![(0.0, 0.0)];
    let mut triangles = Vec::new();
    for ring in 1..=rings {
        let count = 6 * ring;
        let radius = f64::from(ring) / f64::from(rings);
        places.extend((0..count).map(|k| (radius, TAU * f64::from(k) / f64::from(count))));
        for sector in 0..6 {
            for k in 0..ring {
                let outer = |k: u32| first(ring) + (sector * ring + k) % count;
                let inner =
                    |k: u32| if ring == 1 { 0 } else { first(ring - 1) + (sector * (ring - 1) + k) % (count - 6) };
                triangles.push([inner(k), outer(k), outer(k + 1)]);
                if k + 1 < ring {
                    triangles.push([inner(k), outer(k + 1), inner(k + 1)]);
                }
            }
        }
    }
    (places, triangles)
}

/// Makes the body of the image of a disc under `at`. Also returns each boundary vertex together with its neighbours on
/// the boundary: the vertex before, the vertex, the vertex after.
fn disc_body(rings: u32, at: impl Fn(f64, f64) -> DVec3) -> (Body, Vec<[u32; 3]>) {
    let (places, triangles) = disc(rings);
    let complex = Complex::build(triangles, places.len()).unwrap();
    let body = Body::new(places.iter().map(|&(radius, angle)| at(radius, angle)).collect(), &complex, &[1.0]);
    let edge = 6 * rings;
    let first = body.vertices.len() as u32 - edge;
    let edge = (0..edge).map(|k| [first + (k + edge - 1) % edge, first + k, first + (k + 1) % edge]).collect();
    (body, edge)
}

#[test]
fn every_freedom_agrees_with_finite_differences_of_the_energy_along_its_motion() {
    let (vertices, triangles) = bumpy_patch();
    let complex = Complex::build(triangles.clone(), vertices.len()).unwrap();
    let mut body = Body::new(vertices, &complex, &[1.3]);
    let axis = DVec3::new(0.6, 0.0, 0.8);
    body.supports = vec![
        Arc::new(StraightLine { point: DVec3::ZERO, direction: axis }),
        Arc::new(Circle { centre: DVec3::new(-1.0, 0.5, 0.0), axis, radius: 2.0 }),
        Arc::new(Plane { point: DVec3::ZERO, normal: axis }),
        Arc::new(Sphere { centre: DVec3::new(0.0, -1.0, 0.3), radius: 2.5 }),
        Arc::new(Cylinder { point: DVec3::new(0.0, 1.0, -2.0), axis, radius: 1.5 }),
        Arc::new(Torus { centre: DVec3::new(1.0, 0.5, 0.2), axis, radius: 2.5, tube_radius: 1.2 }),
    ];
    let freedoms = [
        (5, Freedom::On(5)),
        (0, Freedom::On(0)),
        (1, Freedom::On(1)),
        (2, Freedom::On(2)),
        (3, Freedom::On(3)),
        (7, Freedom::On(4)),
        (4, Freedom::AcrossOn { support: 4, beside: [0, 8] }),
        (8, Freedom::AcrossOn { support: 3, beside: [4, 12] }),
        (11, Freedom::Across([7, 15])),
        (15, Freedom::Free),
        (12, Freedom::Together(0)),
        (13, Freedom::Together(0)),
        (14, Freedom::Together(0)),
    ];
    body.groups = vec![axis];
    for (v, freedom) in freedoms {
        body.freedoms[v] = freedom;
        if let Some(support) = freedom.support() {
            body.vertices[v] = body.supports[support as usize].nearest(body.vertices[v]);
        }
    }
    body.terms.push(Box::new(Volume { triangles, pressure: 0.4 }));
    body.terms.push(Box::new(Length { segments: vec![[0, 1], [1, 2], [7, 11], [11, 15]], tension: 0.9 }));
    let elastic = Law::Elastic { unstressed: 1.5, stiffness: 2.0 };
    body.terms.push(Box::new(Cable::new(vec![[3, 7], [7, 11], [11, 15]], elastic)));
    let edge = vec![[3, 7], [8, 12], [0, 4]];
    body.constraints.push(Constraint::value(Box::new(Length { segments: edge, tension: 1.0 }), 2.0));
    assert_eq!(body.check(), Ok(()));
    let state = Motion::new(&body).state(&body.vertices);
    assert_eq!(state.gradient.len(), 2 + 1 + 1 + 2 + 2 + 2 + 1 + 1 + 2 + 3 + 1 + 3);
    assert!(state.constraints[0].multiplier.abs() > 0.01);
    assert!(state.constraints.len() == 2 && state.constraints[1].compliance > 0.0);
    assert_agrees_with_finite_differences(&body, 2e-6);
}

/// Compares the gradient and the second variation with differences of the Lagrangian along the motion of each unknown.
fn assert_agrees_with_finite_differences(body: &Body, tolerance: f64) {
    assert_eq!(body.check(), Ok(()));
    let motion = Motion::new(body);
    let state = motion.state(&body.vertices);
    let n = state.gradient.len();
    let mut matrix = motion.matrix();
    motion.second_variation(&body.vertices, &state, 0.0, &mut matrix);
    // The Lagrangian with fixed multipliers.
    let value = |moves: &[(usize, f64)]| {
        let mut step = vec![0.0; n];
        moves.iter().for_each(|&(k, by)| step[k] += by);
        let vertices = motion.moved(&body.vertices, &state, &step, 1.0);
        let energy: f64 = body.terms.iter().map(|term| term.value(&vertices)).sum();
        let held = body.constraints.iter().zip(&state.constraints);
        energy - held.map(|(own, state)| state.multiplier * own.quantity.value(&vertices)).sum::<f64>()
    };
    let h = 1e-4;
    for i in 0..n {
        let slope = (value(&[(i, h)]) - value(&[(i, -h)])) / (2.0 * h);
        assert!((slope - state.gradient[i]).abs() < 1e-6, "{i}: {slope} {}", state.gradient[i]);
        let mut row = vec![0.0; n];
        let (columns, values) = matrix.row(i);
        columns.iter().zip(values).for_each(|(&column, &value)| row[column as usize] = value);
        let mut unit = vec![0.0; n];
        unit[i] = 1.0;
        add_rank_one_products(&state.constraints, &unit, &mut row);
        for (j, expected) in row.iter().enumerate() {
            let at = |a: f64, b: f64| value(&[(i, a), (j, b)]);
            let second = (at(h, h) - at(h, -h) - at(-h, h) + at(-h, -h)) / (4.0 * h * h);
            assert!((second - expected).abs() < tolerance, "{i} {j}: {second} {expected}");
        }
    }
}

#[test]
fn edges_at_given_angles_and_edges_on_meshes_agree_with_finite_differences() {
    let (vertices, triangles) = bumpy_patch();
    let complex = Complex::build(triangles, vertices.len()).unwrap();
    // A bumpy mesh of triangles along the right side of the patch.
    let at = |k: u32| DVec3::new(2.9 + 0.2 * f64::from(k % 5), f64::from(k / 5) - 1.0, 0.3 * f64::from(k * k % 5));
    let wall: Vec<DVec3> = (0..30).map(at).collect();
    let cells = (0..24).filter(|k| k % 5 < 4).flat_map(|k| [[k, k + 1, k + 6], [k, k + 6, k + 5]]);
    let axis = DVec3::new(0.6, 0.0, 0.8);
    let supports: [Arc<dyn Support>; 3] = [
        Arc::new(Plane { point: DVec3::ZERO, normal: axis }),
        Arc::new(Sphere { centre: DVec3::new(0.0, -1.0, 0.3), radius: 2.5 }),
        Arc::new(Cylinder { point: DVec3::new(0.0, 1.0, -2.0), axis, radius: 1.5 }),
    ];
    for on in supports {
        let mut body = Body::new(vertices.clone(), &complex, &[1.3]);
        let mesh = Mesh::new(&wall, &cells.clone().collect::<Vec<_>>(), 1.1).unwrap();
        body.supports = vec![on, Arc::new(mesh)];
        for (v, freedom) in [
            (4, Freedom::AcrossOn { support: 0, beside: [0, 8] }),
            (8, Freedom::AcrossOn { support: 0, beside: [4, 12] }),
            (7, Freedom::AcrossOn { support: 1, beside: [3, 11] }),
            (11, Freedom::On(1)),
        ] {
            body.freedoms[v] = freedom;
            let support = &body.supports[freedom.support().unwrap() as usize];
            body.vertices[v] = support.nearest(body.vertices[v]);
        }
        let contact = ContactEnergy::new(&[0, 4, 8, 12], false, &*body.supports[0], 1.3, 0.8, &vertices).unwrap();
        body.terms.push(Box::new(contact));
        // The second derivatives along a mesh may jump within a step.
        assert_agrees_with_finite_differences(&body, 1e-4);
    }
}

#[test]
fn a_body_of_normals_is_the_film_of_the_fast_path() {
    let film = patch(9, 7, catenoid(3.0, 0.9));
    let pattern = Pattern::new(film.triangles(), &film.fixed);
    let fast = NormalMotion { pattern: &pattern, triangles: film.triangles(), radius: film.radius() };
    let complex = Complex::build(film.triangles().to_vec(), film.vertices.len()).unwrap();
    let body = Body::new(film.vertices.clone(), &complex, &[1.0]);
    let general = Motion::new(&body);
    let (a, b) = (fast.state(&film.vertices), general.state(&film.vertices));
    assert!((a.energy - b.energy).abs() < 1e-13 * a.energy && (a.residual - b.residual).abs() < 1e-13);
    let close = |a: &[f64], b: &[f64]| a.len() == b.len() && a.iter().zip(b).all(|(a, b)| (a - b).abs() < 1e-13);
    assert!(close(&a.gradient, &b.gradient) && close(&a.mass, &b.mass));
    for shift in [0.0, 0.7] {
        let dense = |matrix: &plateau_mesh::sparse::SymmetricMatrix| {
            let n = matrix.order();
            let mut dense = vec![0.0; n * n];
            for row in 0..n {
                let (columns, values) = matrix.row(row);
                columns.iter().zip(values).for_each(|(&column, &value)| dense[row * n + column as usize] = value);
            }
            dense
        };
        let (mut scalar, mut blocks) = (fast.matrix(), general.matrix());
        fast.second_variation(&film.vertices, &a, shift, &mut scalar);
        general.second_variation(&film.vertices, &b, shift, &mut blocks);
        assert!(close(&dense(&scalar), &dense(&blocks)));
    }
}

/// A plane film between a fixed circle of radius 2 and a round hole of radius about `inner`. Also returns the loop of
/// segments around the hole.
fn holed(n: usize, inner: f64) -> (Body, Vec<[u32; 2]>) {
    let mut film = cylinder(n, n / 6, 1.0);
    let rings = n / 6;
    for (k, vertex) in film.vertices.iter_mut().enumerate() {
        let radius = inner + (2.0 - inner) * (k / n) as f64 / rings as f64;
        *vertex = DVec3::new(radius * vertex.x, radius * vertex.y, 0.0);
    }
    let complex = Complex::build(film.triangles().to_vec(), film.vertices.len()).unwrap();
    let mut body = Body::new(film.vertices, &complex, &[1.0]);
    let at = |k: usize| (k % n) as u32;
    for k in 0..n {
        body.freedoms[k] = Freedom::Across([at(k + n - 1), at(k + 1)]);
    }
    (body, (0..n).map(|k| [at(k), at(k + 1)]).collect())
}

#[test]
fn a_soap_film_against_an_elastic_loop() {
    // The film pulls the loop outward with σ per length, and the loop resists with T / r: EA (2 π r / L0 - 1) = σ r.
    let (stiffness, unstressed) = (3.0, TAU * 0.8);
    let exact = stiffness / (TAU * stiffness / unstressed - 1.0);
    let mut errors = Vec::new();
    for n in [24, 48, 96] {
        let (mut body, segments) = holed(n, 1.08);
        body.terms.push(Box::new(Cable::new(segments, Law::Elastic { unstressed, stiffness })));
        let report = relaxed(&mut body);
        assert_eq!(report.stability.unwrap().morse_index, Some(0));
        let radii: Vec<f64> = body.vertices[..n].iter().map(|p| p.length()).collect();
        assert!(radii.iter().all(|radius| (radius - radii[0]).abs() < 1e-9));
        errors.push(radii[0] - exact);
    }
    assert_second_order(&errors);
    assert!(errors[2].abs() < 1e-3 * exact);
}

#[test]
fn a_loop_too_soft_to_hold_the_film_has_no_equilibrium() {
    // If 2 π EA / L0 < σ, the energy falls for as long as the loop grows. Newton's method then finds no descent
    // direction, because the growth of the loop has no positive semidefinite part that a shift could multiply.
    let at = |radius: f64| {
        let (mut body, segments) = holed(24, radius);
        body.terms.push(Box::new(Cable::new(segments, Law::Elastic { unstressed: TAU * 0.8, stiffness: 0.7 })));
        body
    };
    let energies = [1.0, 1.3, 1.6, 1.9].map(|radius| at(radius).energy());
    assert!(energies.is_sorted_by(|before, after| before > after), "{energies:?}");
    let settings = Settings { max_steps: 60, ..Settings::default() };
    let report = at(1.0).relax(&settings, &Execution::default(), &mut |_, _| {}).unwrap();
    assert_eq!((report.outcome, report.stability), (Outcome::Refused(LinearError::Singular), None));
}

/// A square of side 10 whose four edges are arcs with the given sag inward. Also returns the segments of the edges.
fn sail(n: usize, sag: f64) -> (Body, Vec<[u32; 2]>) {
    let arc = |t: f64| {
        let radius = (25.0 + sag * sag) / (2.0 * sag);
        (radius * radius - (10.0 * t - 5.0) * (10.0 * t - 5.0)).sqrt() - (radius - sag)
    };
    // The edges of the square are arcs; inside, the displacements of opposite edges are interpolated (Coons patch). The
    // displacements vanish at the corners.
    let at = |u: f64, v: f64| {
        let (x, y) = (arc(v) * (1.0 - 2.0 * u), arc(u) * (1.0 - 2.0 * v));
        DVec3::new(10.0 * u + x, 10.0 * v + y, 0.0)
    };
    let film = patch(n, n, at);
    let complex = Complex::build(film.triangles().to_vec(), film.vertices.len()).unwrap();
    let mut body = Body::new(film.vertices, &complex, &[1.0]);
    let rim = &film.boundaries[0];
    let around = |k: usize| rim[k % rim.len()];
    for k in 0..rim.len() {
        if k % n != 0 {
            body.freedoms[rim[k] as usize] = Freedom::Across([around(k + rim.len() - 1), around(k + 1)]);
        }
    }
    let segments = (0..rim.len()).map(|k| [around(k), around(k + 1)]).collect();
    (body, segments)
}

#[test]
fn edge_cables_of_a_plane_sail_are_arcs_of_radius_tension_over_surface_tension() {
    // Issue 19: side 10, σ 1, T 10: sag 10 - √75, cable 10 π / 3 an edge, area 100 less four segments.
    let (sag, cable) = (10.0 - 75f64.sqrt(), 10.0 * PI / 3.0);
    let area = 100.0 - 4.0 * (50.0 * (PI / 3.0 - libm::sin(PI / 3.0)));
    assert!((area - 63.765571).abs() < 1e-6 && (sag - 1.339746).abs() < 1e-6 && (cable - 10.471976).abs() < 1e-6);
    let (mut sags, mut cables, mut areas) = (Vec::new(), Vec::new(), Vec::new());
    for n in [8, 16, 32] {
        let (mut body, segments) = sail(n, 1.25);
        let of = segments.clone();
        body.terms.push(Box::new(Length { segments, tension: 10.0 }));
        assert_eq!(relaxed(&mut body).stability.unwrap().morse_index, Some(0));
        let middle = body.vertices[n / 2 * (n + 1)];
        sags.push(middle.y - sag);
        cables.push(0.25 * of.iter().map(|&segment| length::length(segment, &body.vertices)).sum::<f64>() - cable);
        areas.push(body.terms[0].value(&body.vertices) - area);
        assert!(body.vertices.iter().all(|p| p.z.abs() < 1e-12));
    }
    [&sags, &cables, &areas].into_iter().for_each(|errors| assert_second_order(errors));
    let last = [sags[2] / sag, cables[2] / cable, areas[2] / area];
    assert!(last.iter().all(|error| error.abs() < 1e-3), "{last:?}");
}

/// Segments of energy ½ q L² whose force densities q are renewed so that the force becomes the target.
#[derive(Debug)]
struct TargetForce {
    segments: Vec<[u32; 2]>,
    densities: Vec<f64>,
    target: f64,
}

impl TargetForce {
    fn stretch(&self, k: usize, length: f64) -> Stretch {
        let q = self.densities[k];
        Stretch { energy: 0.5 * q * length * length, force: q * length, stiffness: q }
    }
}

impl Term for TargetForce {
    fn value(&self, at: &[DVec3]) -> f64 {
        let energy = |(k, &segment): (usize, &[u32; 2])| self.stretch(k, length::length(segment, at)).energy;
        self.segments.iter().enumerate().map(energy).sum()
    }

    fn add_gradient(&self, at: &[DVec3], gradient: &mut [DVec3]) {
        length::add_gradient(&self.segments, at, gradient, |k, length| self.stretch(k, length));
    }

    fn add_second_derivative(&self, at: &[DVec3], shift: f64, add: &mut dyn FnMut(u32, u32, DMat3)) {
        length::add_second_derivative(&self.segments, at, shift, add, |k, length| self.stretch(k, length));
    }

    fn visit_elements(&self, visit: &mut dyn FnMut(&[u32])) {
        self.segments.iter().for_each(|segment| visit(segment));
    }

    fn renew(&mut self, at: &[DVec3]) -> f64 {
        let mut change: f64 = 0.0;
        for (segment, density) in self.segments.iter().zip(&mut self.densities) {
            let renewed = self.target / length::length(*segment, at);
            change = change.max((renewed / *density - 1.0).abs());
            *density = renewed;
        }
        change
    }
}

#[test]
fn force_densities_that_are_renewed_between_solves_reach_the_target_force() {
    let (mut body, segments) = sail(8, 1.25);
    let densities = vec![10.0 / 1.3; segments.len()];
    body.terms.push(Box::new(TargetForce { segments: segments.clone(), densities, target: 10.0 }));
    relaxed(&mut body);
    // The body is also in equilibrium with a cable that has this force throughout.
    *body.terms.last_mut().unwrap() = Box::new(Length { segments, tension: 10.0 });
    let residual = Motion::new(&body).state(&body.vertices).residual;
    assert!(residual < 1e-8, "{residual}");
}

/// A spherical cap over the unit circle, with the angle `angle` from its pole to its rim. All heights are raised by the
/// fraction `bulge`. Returns the body and its triangles.
fn cap(rings: u32, angle: f64, bulge: f64) -> (Body, Vec<[u32; 3]>) {
    let sphere = 1.0 / libm::sin(angle);
    let (body, _) = disc_body(rings, |radius, azimuth| {
        let polar = angle * radius;
        let r = sphere * libm::sin(polar);
        let rise = sphere * (libm::cos(polar) - libm::cos(angle)) * (1.0 + bulge);
        DVec3::new(r * libm::cos(azimuth), r * libm::sin(azimuth), rise)
    });
    let triangles = body.triangles().to_vec();
    (body, triangles)
}

#[test]
fn a_pressure_makes_a_cap_of_the_sphere_whose_radius_is_twice_the_tension_over_it() {
    // Issue 19, divided by 5: a disc of radius 1, σ 1, p 1: radius 2, height 2 - √3.
    let (height, area) = (2.0 - 3f64.sqrt(), 4.0 * PI * (2.0 - 3f64.sqrt()));
    let volume = PI / 3.0 * height * height * (6.0 - height);
    assert!((25.0 * area - 84.178721).abs() < 1e-6 && (125.0 * volume - 53.870818).abs() < 1e-6);
    let mut errors = [Vec::new(), Vec::new(), Vec::new()];
    for rings in [6, 12, 24] {
        let (mut body, triangles) = cap(rings, PI / 6.0, 0.05);
        body.terms.push(Box::new(Volume { triangles: triangles.clone(), pressure: 1.0 }));
        assert_eq!(relaxed(&mut body).stability.unwrap().morse_index, Some(0));
        errors[0].push(body.vertices[0].z - height);
        errors[1].push(body.terms[0].value(&body.vertices) - area);
        errors[2].push(Volume { triangles, pressure: -1.0 }.value(&body.vertices) - volume);
    }
    errors[1..].iter().for_each(|errors| assert_second_order(errors));
    // The height is that of the centre vertex alone. Its error need not be of second order, because the triangles
    // around it differ from those around all other vertices.
    assert!(errors[0].windows(2).all(|pair| pair[1].abs() < 0.5 * pair[0].abs()) && errors[0][2].abs() < 1e-4 * height);
}

#[test]
fn beyond_the_hemisphere_a_cap_is_stable_at_constant_volume_and_not_at_constant_pressure() {
    for (angle, at_constant_pressure) in [(0.3 * PI, 0), (0.7 * PI, 1)] {
        let pressure = 2.0 * libm::sin(angle);
        let (mut body, triangles) = cap(16, angle, 0.0);
        let enclosed = Volume { triangles: triangles.clone(), pressure: -1.0 };
        let target = enclosed.value(&body.vertices);
        body.constraints.push(Constraint::value(Box::new(enclosed), target));
        let report = relaxed(&mut body);
        assert_eq!(report.stability.unwrap().morse_index, Some(0));
        assert!(report.stability.unwrap().lowest_eigenvalue > 0.0);
        assert!((report.multipliers[0] - pressure).abs() < 0.02 * pressure, "{report:?} {pressure}");
        // The same surface, with the pressure that was found as a constant in place of the volume.
        body.constraints.clear();
        body.terms.push(Box::new(Volume { triangles, pressure: report.multipliers[0] }));
        let stationary = Settings { aim: Aim::Stationary, ..Settings::default() };
        let free = body.relax(&stationary, &Execution::default(), &mut |_, _| {}).unwrap();
        assert_eq!(free.outcome, Outcome::Converged);
        let stability = free.stability.unwrap();
        assert_eq!(stability.morse_index, Some(at_constant_pressure));
        assert_eq!(stability.lowest_eigenvalue < 0.0, at_constant_pressure > 0);
    }
}

#[test]
fn a_constraint_is_reached_from_a_start_that_does_not_meet_it() {
    let (mut body, triangles) = cap(10, 0.3 * PI, 0.0);
    let enclosed = Volume { triangles, pressure: -1.0 };
    let target = 1.3 * enclosed.value(&body.vertices);
    body.constraints.push(Constraint::value(Box::new(enclosed), target));
    relaxed(&mut body);
    let reached = body.constraints[0].quantity.value(&body.vertices);
    assert!((reached / target - 1.0).abs() < 1e-10);
    // The cap of that volume: h (3 + h²) π / 6 over the unit circle.
    let (mut low, mut high) = (0.0, 3.0);
    while high - low > 1e-12 {
        let height: f64 = 0.5 * (low + high);
        if height * (3.0 + height * height) * PI / 6.0 < target { low = height } else { high = height }
    }
    assert!((body.vertices[0].z - low).abs() < 0.02 * low);
}

#[test]
fn energies_that_cancel_do_not_stall_a_body() {
    // Two lines along a fixed edge have large energies of opposite signs, which together cancel the energy of the
    // sheet. The total energy is zero and therefore does not show how much a step gains.
    let film = patch(12, 12, |u, v| DVec3::new(u, v, 0.3 * (u - v) * (u + v - 1.0)));
    let complex = Complex::build(film.triangles().to_vec(), film.vertices.len()).unwrap();
    let mut body = Body::new(film.vertices, &complex, &[1.0]);
    relaxed(&mut body);
    let length = body.vertices[0].distance(body.vertices[1]);
    for energy in [1e6, -1e6 - body.energy()] {
        body.terms.push(Box::new(Length { segments: vec![[0, 1]], tension: energy / length }));
    }
    assert!(body.energy().abs() < 1e-9, "{}", body.energy());
    for v in 0..body.vertices.len() {
        if body.freedoms[v] == Freedom::Normal {
            body.vertices[v].z += 1e-6 * libm::sin(v as f64);
        }
    }
    relaxed(&mut body);
}

#[test]
fn the_index_of_a_film_that_moves_freely_is_undecided_at_every_size() {
    // A plane film whose edge moves along its normals moves as a whole without resistance. In the finer film a vertex's
    // share of area is below 2e-3 R². A small multiple of the mass therefore does not make up for the pivot that
    // vanishes.
    for n in [4, 32] {
        for size in [1e-3, 1.0, 1e3] {
            let film = patch(n, n, |u, v| size * DVec3::new(u, v, 0.3 * u));
            let complex = Complex::build(film.triangles().to_vec(), film.vertices.len()).unwrap();
            let mut body = Body::new(film.vertices, &complex, &[1.0]);
            body.freedoms.fill(Freedom::Normal);
            let report = relaxed(&mut body);
            let stability = report.stability.unwrap();
            assert_eq!((stability.morse_index, stability.least_index), (None, 0));
            assert!((stability.lowest_eigenvalue * size * size).abs() < 1e-9, "{stability:?}");
            assert!(report.lowest_mode.unwrap().iter().all(|motion| (motion.length() - 1.0).abs() < 1e-6));
        }
    }
}

#[test]
fn a_mode_that_has_not_the_symmetry_of_the_start_is_found() {
    // A cylinder of radius 1 and length L at constant volume is unstable beyond L = 2 π (Plateau). The unstable mode is
    // sin(2 π z / L), whose eigenvalue is (2 π / L)² - 1. The mesh and a constant height are symmetric under half a
    // turn about a horizontal axis, but this mode changes its sign.
    let length = 7.0;
    let film = cylinder(32, 36, length);
    let complex = Complex::build(film.triangles().to_vec(), film.vertices.len()).unwrap();
    let triangles = film.triangles().to_vec();
    let mut body = Body::new(film.vertices, &complex, &[1.0]);
    let enclosed = Volume { triangles, pressure: -1.0 };
    let target = enclosed.value(&body.vertices);
    body.constraints.push(Constraint::value(Box::new(enclosed), target));
    let stationary = Settings { aim: Aim::Stationary, ..Settings::default() };
    let report = body.relax(&stationary, &Execution::default(), &mut |_, _| {}).unwrap();
    assert_eq!(report.outcome, Outcome::Converged);
    let stability = report.stability.unwrap();
    let expected = (TAU / length).powi(2) - 1.0;
    assert_eq!(stability.morse_index, Some(1));
    assert!((stability.lowest_eigenvalue / expected - 1.0).abs() < 0.05, "{stability:?} {expected}");
}

#[test]
fn a_body_whose_constraints_leave_no_motion_has_no_modes() {
    let corners = [(1.0, 1.0), (-1.0, 1.0), (-1.0, -1.0), (1.0, -1.0)].map(|(x, y)| DVec3::new(x, y, 0.0));
    let mut vertices = corners.to_vec();
    // The start is below the equilibrium, so that a step is needed.
    vertices.push(DVec3::new(0.0, 0.0, 0.4));
    let triangles = vec![[0, 1, 4], [1, 2, 4], [2, 3, 4], [3, 0, 4]];
    let complex = Complex::build(triangles.clone(), 5).unwrap();
    let mut body = Body::new(vertices, &complex, &[1.0]);
    body.constraints.push(Constraint::value(Box::new(Volume { triangles, pressure: -1.0 }), 2.0 / 3.0));
    let report = relaxed(&mut body);
    assert_eq!((report.stability, report.lowest_mode), (None, None));
}

#[test]
fn a_half_catenoid_slides_on_a_plane() {
    // A catenoid between a ring of radius 1 at height 1/2 and the plane: c cosh(1 / 2c) = 1, area π c (h + c sinh(2h /
    // c) / 2).
    let mut neck: f64 = 0.85;
    for _ in 0..50 {
        neck = 1.0 / libm::cosh(0.5 / neck);
    }
    let area = PI * neck * (0.5 + 0.5 * neck * libm::sinh(1.0 / neck));
    let (mut necks, mut areas) = (Vec::new(), Vec::new());
    for n in [24, 48, 96] {
        let mut film = cylinder(n, n / 8, 0.5);
        film.vertices.iter_mut().for_each(|p| p.z += 0.25);
        film.vertices.iter_mut().take(n).for_each(|p| p.z = 0.0);
        let complex = Complex::build(film.triangles().to_vec(), film.vertices.len()).unwrap();
        let mut body = Body::new(film.vertices, &complex, &[1.0]);
        body.supports = vec![Arc::new(Plane { point: DVec3::ZERO, normal: DVec3::Z })];
        for k in 0..n {
            let beside = [((k + n - 1) % n) as u32, ((k + 1) % n) as u32];
            body.freedoms[k] = Freedom::AcrossOn { support: 0, beside };
        }
        assert_eq!(relaxed(&mut body).stability.unwrap().morse_index, Some(0));
        assert!(body.vertices[..n].iter().all(|p| p.z == 0.0));
        necks.push(body.vertices[0].length() - neck);
        areas.push(body.energy() - area);
    }
    assert_second_order(&necks);
    assert_second_order(&areas);
}

#[test]
fn a_disc_inside_a_sphere_is_unstable_through_the_spheres_curvature() {
    // -Δu = λ u with ∂u/∂n = u on the unit circle: u = I0(k ρ), k I1(k) = I0(k), λ = -k². Without the curvature λ would
    // be 0.
    let bessel = |order: i32, k: f64| {
        let mut term = (0.5 * k).powi(order);
        let mut sum = 0.0;
        for m in 1..40 {
            sum += term;
            term *= 0.25 * k * k / (f64::from(m) * f64::from(m + order));
        }
        sum
    };
    let (mut low, mut high) = (1.0, 2.0);
    while high - low > 1e-13 {
        let k = 0.5 * (low + high);
        if k * bessel(1, k) < bessel(0, k) { low = k } else { high = k }
    }
    let mut errors = Vec::new();
    for rings in [8, 16, 32] {
        let (mut body, edge) =
            disc_body(rings, |radius, angle| DVec3::new(radius * libm::cos(angle), radius * libm::sin(angle), 0.0));
        body.supports = vec![Arc::new(Sphere { centre: DVec3::ZERO, radius: 1.0 })];
        for [before, v, after] in edge {
            body.freedoms[v as usize] = Freedom::AcrossOn { support: 0, beside: [before, after] };
        }
        let stationary = Settings { aim: Aim::Stationary, ..Settings::default() };
        let report = body.relax(&stationary, &Execution::default(), &mut |_, _| {}).unwrap();
        assert_eq!(report.outcome, Outcome::Converged);
        let stability = report.stability.unwrap();
        // The sphere can turn about its centre together with the disc, which gives two motions without resistance.
        assert_eq!((stability.morse_index, stability.least_index), (None, 1));
        errors.push(stability.lowest_eigenvalue + low * low);
    }
    assert_second_order(&errors);
}

#[test]
fn three_cables_meet_at_120_degrees_and_a_point_on_a_circle_finds_the_nearest_place() {
    let ends = [DVec3::new(0.0, 0.0, 0.0), DVec3::new(3.0, 0.0, 0.5), DVec3::new(1.0, 2.0, -0.4)];
    let mut vertices = ends.to_vec();
    vertices.push(DVec3::new(0.9, 1.1, 0.8));
    let nothing = Complex::build(Vec::new(), 0).unwrap();
    let mut body = Body::new(vertices.clone(), &nothing, &[]);
    body.freedoms[..3].fill(Freedom::Fixed);
    body.terms.push(Box::new(Length { segments: vec![[0, 3], [1, 3], [2, 3]], tension: 2.0 }));
    assert_eq!(relaxed(&mut body).stability.unwrap().morse_index, Some(0));
    let towards = |k: usize| (ends[k] - body.vertices[3]).normalize();
    for k in 0..3 {
        assert!((towards(k).dot(towards((k + 1) % 3)) + 0.5).abs() < 1e-9);
    }
    // A cable from a point in the plane of a circle to the circle. The circle's nearest point is on the line through
    // the centre.
    let circle = Arc::new(Circle { centre: DVec3::ZERO, axis: DVec3::Z, radius: 1.0 });
    let mut body = Body::new(vec![DVec3::new(3.0, 4.0, 0.0), DVec3::new(0.0, 1.0, 0.0)], &nothing, &[]);
    body.supports = vec![circle];
    body.freedoms = vec![Freedom::Fixed, Freedom::On(0)];
    body.terms.push(Box::new(Length { segments: vec![[0, 1]], tension: 1.0 }));
    assert_eq!(relaxed(&mut body).stability.unwrap().morse_index, Some(0));
    assert!(body.vertices[1].distance(DVec3::new(0.6, 0.8, 0.0)) < 1e-9);
}

#[test]
fn bodies_whose_parts_do_not_fit_are_named() {
    let body = || {
        let film = patch(3, 3, |u, v| DVec3::new(u, v, 0.0));
        let complex = Complex::build(film.triangles().to_vec(), film.vertices.len()).unwrap();
        Body::new(film.vertices, &complex, &[1.0])
    };
    let refused = |change: &dyn Fn(&mut Body)| {
        let mut body = body();
        change(&mut body);
        let before = body.vertices.clone();
        let refused = body.relax(&Settings::default(), &Execution::default(), &mut |_, _| {}).unwrap_err();
        assert_eq!(body.vertices, before);
        refused
    };
    assert_eq!(body().check(), Ok(()));
    assert_eq!(refused(&|body| body.freedoms.truncate(3)), BodyDefect::Freedoms);
    assert_eq!(refused(&|body| body.freedoms[0] = Freedom::On(0)), BodyDefect::NoSuchSupport(0));
    let line = || Length { segments: vec![[0, 99]], tension: 1.0 };
    assert_eq!(refused(&|body| body.terms.push(Box::new(line()))), BodyDefect::NoSuchVertex(99));
    assert_eq!(refused(&|body| body.freedoms[5] = Freedom::Across([0, 77])), BodyDefect::NoSuchVertex(77));
    let plane = Arc::new(Plane { point: DVec3::Z, normal: DVec3::Z });
    let off = |body: &mut Body| {
        body.supports.push(plane.clone());
        body.freedoms[2] = Freedom::On(0);
    };
    assert_eq!(refused(&off), BodyDefect::OffSupport(2));
    let long = Arc::new(Plane { point: DVec3::ZERO, normal: 2.0 * DVec3::Z });
    assert_eq!(refused(&|body| body.supports.push(long.clone())), BodyDefect::Support(0));
    let flat = Arc::new(Sphere { centre: DVec3::ZERO, radius: 0.0 });
    assert_eq!(refused(&|body| body.supports.push(flat.clone())), BodyDefect::Support(0));
    // The tube is as thick as the ring's radius, so the torus touches itself on its axis.
    let spindle = Arc::new(Torus { centre: DVec3::ZERO, axis: DVec3::Z, radius: 1.0, tube_radius: 1.0 });
    assert_eq!(refused(&|body| body.supports.push(spindle.clone())), BodyDefect::Support(0));
    assert_eq!(refused(&|body| body.groups.push(DVec3::ZERO)), BodyDefect::Group(0));
    // A direction of length 2 would double the weight of the film.
    let heavy = |body: &mut Body| {
        let weight = Weight::new(body.triangles().to_vec(), 1.0, 2.0 * DVec3::Z, &body.vertices);
        body.terms.push(Box::new(weight));
    };
    assert_eq!(refused(&heavy), BodyDefect::Term(1));
    let quantity = || Box::new(Length { segments: vec![[0, 1]], tension: 1.0 });
    let zero = |body: &mut Body| body.constraints.push(Constraint::value(quantity(), 0.0));
    assert_eq!(refused(&zero), BodyDefect::Target(0));
}

#[test]
fn junctions_of_a_complex_may_move_across_their_curve() {
    // Three coarse sheets, of two triangles each, meet on a line from z = 0 to z = 2. The middle of the line is off the
    // axis.
    let ends = [DVec3::ZERO, DVec3::new(0.2, 0.1, 1.0), DVec3::new(0.0, 0.0, 2.0)];
    let outer = |k: u32| DVec3::new(libm::cos(TAU * f64::from(k) / 3.0), libm::sin(TAU * f64::from(k) / 3.0), 1.0);
    let mut vertices = ends.to_vec();
    vertices.extend((0..3).map(outer));
    let triangles: Vec<[u32; 3]> = (3..6).flat_map(|rim| [[0, 1, rim], [1, 2, rim]]).collect();
    assert!(has_junctions(&triangles));
    let complex = Complex::build(triangles.clone(), 6).unwrap();
    let mut body = Body::new(vertices.clone(), &complex, &[1.0; 3]);
    assert_eq!(body.freedoms[1], Freedom::Across([0, 2]));
    assert_eq!(relaxed(&mut body).stability.unwrap().morse_index, Some(0));
    assert!(body.vertices[1].distance(DVec3::Z) < 1e-9);
    // A sheet of tension 1.5 pulls harder than the other two together do at angles of 120°, so the line moves towards
    // that sheet.
    let mut body = Body::new(vertices, &complex, &[1.5, 1.0, 1.0]);
    relaxed(&mut body);
    assert!(body.vertices[1].x > 0.05 && body.vertices[1].y.abs() < 1e-9);
    // The gradient at the middle vertex, worked out here from the first variation of each sheet.
    let normals = measure::normals(&body.vertices, &triangles);
    let fixed = [true, false, true, true, true, true];
    let free = plateau_mesh::sparse::pattern::FreeVertices::new(&fixed);
    let mut sum = 0.0;
    for (sheet, tension) in [(0, 1.5), (2, 1.0), (4, 1.0)] {
        let along: Vec<DVec3> = normals.iter().map(|_| DVec3::X).collect();
        sum += tension * first_variation(&free, &body.vertices, &triangles[sheet..sheet + 2], &along).gradient[0];
    }
    assert!(sum.abs() < 1e-9);
}

#[test]
fn the_merit_of_a_film_is_its_energy() {
    let film = cylinder(12, 3, 0.8);
    let pattern = Pattern::new(film.triangles(), &film.fixed);
    let fast = NormalMotion { pattern: &pattern, triangles: film.triangles(), radius: film.radius() };
    let state: State<Vec<DVec3>> = fast.state(&film.vertices);
    assert_eq!(state.energy.to_bits(), film.area().to_bits());
}
