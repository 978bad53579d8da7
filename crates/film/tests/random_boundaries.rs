//! Random boundaries of awkward kinds. At least 95% of them must have a film that is converged and right; the others
//! are refused by name or not converged. Residual, Morse index and crossings of each film are computed here again.

#![allow(clippy::disallowed_macros, clippy::disallowed_methods, reason = "this is a test")]

use plateau_film::minimal_surface::{
    InitialMesh, Method, MinimalSurface, Newton, OnUnstable, Options, Resolution, solve,
};
use plateau_mesh::random::SplitMix64;
use plateau_mesh::self_intersections::{self, Order};
use plateau_mesh::{DVec3, Error, Execution, Mesh};
use robust::{Coord3D, orient3d};
use std::collections::BTreeMap;
use std::f64::consts::TAU;

/// A random vector in the cube of half edge `size` around the origin.
fn vector(random: &mut SplitMix64, size: f64) -> DVec3 {
    let mut any = || random.between(-1.0, 1.0);
    size * DVec3::new(any(), any(), any())
}

fn curve(points: usize, place: impl Fn(f64) -> DVec3) -> Vec<DVec3> {
    (0..points).map(|k| place(TAU * k as f64 / points as f64)).collect()
}

/// A loop that winds once, with a few random harmonics.
fn gentle(random: &mut SplitMix64, points: usize) -> Vec<DVec3> {
    let waves: Vec<(f64, DVec3, f64)> =
        (2..5).map(|k| (f64::from(k), vector(random, 0.25 / f64::from(k)), random.between(0.0, TAU))).collect();
    curve(points, |t| {
        let round = DVec3::new(t.cos(), t.sin(), 0.0);
        round + waves.iter().map(|(k, along, phase)| *along * (k * t + phase).sin()).sum::<DVec3>()
    })
}

/// Returns a mesh of Enneper's surface over a disc, and its boundary, both turned, moved and scaled at random. Up to a
/// disc of radius 1 the surface is the film of least area. Beyond, it is stationary with one direction in which the
/// area falls.
fn enneper(random: &mut SplitMix64) -> (Vec<DVec3>, Mesh) {
    let (around, rings) = (32 + 4 * random.below(6), 6 + random.below(5));
    let radius = if random.unit() < 0.3 { random.between(0.6, 0.9) } else { random.between(1.1, 1.4) };
    let (turned, scale) = (Rotation::random(random), 10f64.powf(random.between(-2.0, 2.0)));
    let offset = vector(random, scale);
    let place = |r: f64, angle: f64| {
        let (p, q) = (r * angle.cos(), r * angle.sin());
        let flat = DVec3::new(p - p.powi(3) / 3.0 + p * q * q, -q + q.powi(3) / 3.0 - p * p * q, p * p - q * q);
        offset + turned.of(flat) * scale
    };
    let mut mesh = Mesh::new(vec![place(0.0, 0.0)], Vec::new());
    for ring in 1..=rings {
        let r = radius * ring as f64 / rings as f64;
        mesh.vertices.extend(curve(around, |angle| place(r, angle)));
    }
    let at = |ring: usize, k: usize| if ring == 0 { 0 } else { (1 + (ring - 1) * around + k % around) as u32 };
    for k in 0..around {
        mesh.triangles.push([0, at(1, k), at(1, k + 1)]);
        for ring in 1..rings {
            let [a, b, c, d] = [at(ring, k), at(ring + 1, k), at(ring + 1, k + 1), at(ring, k + 1)];
            mesh.triangles.extend([[a, b, c], [a, c, d]]);
        }
    }
    (mesh.vertices[1 + (rings - 1) * around..].to_vec(), mesh)
}

/// A rotation, given by the images of the three axes.
struct Rotation([DVec3; 3]);

impl Rotation {
    fn random(random: &mut SplitMix64) -> Self {
        let first = vector(random, 1.0).normalize();
        let second = first.cross(vector(random, 1.0)).normalize();
        Self([first, second, first.cross(second)])
    }
    fn of(&self, p: DVec3) -> DVec3 {
        self.0[0] * p.x + self.0[1] * p.y + self.0[2] * p.z
    }
}

const KINDS: [&str; 9] =
    ["knot", "link", "noisy", "spiky", "near_duplicates", "offset", "scale", "corners", "given_enneper"];

fn boundaries(kind: &str, random: &mut SplitMix64) -> Vec<Vec<DVec3>> {
    let points = 20 + random.below(100);
    let mut one = gentle(random, points);
    match kind {
        "knot" => {
            let (p, q) = [(2.0, 3.0), (3.0, 2.0), (2.0, 5.0), (3.0, 4.0)][random.below(4)];
            let tube = random.between(0.2, 0.6);
            one = curve(60 + random.below(80), |t| {
                let r = 1.0 + tube * (q * t).cos();
                DVec3::new(r * (p * t).cos(), r * (p * t).sin(), tube * (q * t).sin())
            });
        }
        "link" => {
            let (shift, tilt) = (random.between(0.5, 1.5), random.between(0.0, 1.0));
            let other =
                curve(40, |t| DVec3::new(shift + t.cos(), tilt * t.sin(), t.sin() * (1.0 - tilt * tilt).sqrt()));
            return vec![one, other];
        }
        "noisy" => {
            let size = random.between(0.001, 0.5) * TAU / points as f64;
            one.iter_mut().for_each(|p| *p += vector(random, size));
        }
        "spiky" => {
            for _ in 0..1 + random.below(3) {
                let k = random.below(points);
                one[k] *= random.between(1.5, 8.0);
            }
        }
        "near_duplicates" => {
            for _ in 0..1 + random.below(4) {
                let k = random.below(one.len());
                let gap = 10f64.powf(random.between(-16.0, -3.0));
                let beside = one[k] + vector(random, 1.0).normalize() * gap;
                one.insert(k + 1, beside);
            }
        }
        "offset" => {
            let offset = vector(random, 1e7);
            one.iter_mut().for_each(|p| *p += offset);
        }
        "scale" => {
            let factor = 10f64.powf(random.between(-6.0, 6.0));
            one.iter_mut().for_each(|p| *p *= factor);
        }
        _ => {
            let corners = 4 + random.below(6);
            one = gentle(random, corners);
            one.iter_mut().for_each(|p| *p += vector(random, 0.2));
        }
    }
    vec![one]
}

/// Returns the boundaries of a kind, and the options of the solve. A stationary film that is given as a mesh must stay
/// as it is, also if it is unstable.
fn request(kind: &str, random: &mut SplitMix64) -> (Vec<Vec<DVec3>>, Options) {
    if kind != "given_enneper" {
        return (boundaries(kind, random), Options::new(Resolution::Triangles(1000)));
    }
    let (boundary, mesh) = enneper(random);
    let method = Method::Newton(Newton { on_unstable: OnUnstable::Report, ..Newton::default() });
    let options = Options { method, initial_mesh: InitialMesh::Given(mesh), ..Options::new(Resolution::Triangles(1)) };
    (vec![boundary], options)
}

/// Largest residual that is allowed if the boundary is more than 1000 radii away from the origin, because its
/// coordinates are rounded by more there.
const FAR_RESIDUAL: f64 = 1e-3;

/// Computes the residual: the largest normal part of the area gradient at a free vertex, over 2/3 of the area around
/// the vertex, times R.
fn residual(mesh: &Mesh, fixed: &[bool], radius: f64) -> f64 {
    let n = mesh.vertices.len();
    let (mut gradient, mut normal, mut area) = (vec![DVec3::ZERO; n], vec![DVec3::ZERO; n], vec![0.0; n]);
    for &t in &mesh.triangles {
        let p = t.map(|v| mesh.vertices[v as usize]);
        let twice = (p[1] - p[0]).cross(p[2] - p[0]);
        for k in 0..3 {
            let v = t[k] as usize;
            // The area of a triangle grows fastest when the vertex moves at right angles to the opposite edge. The
            // gradient has half the length of that edge.
            gradient[v] += 0.5 * twice.normalize().cross(p[(k + 2) % 3] - p[(k + 1) % 3]);
            normal[v] += twice;
            area[v] += 0.5 * twice.length();
        }
    }
    let at = |v: usize| {
        let force = gradient[v].dot(normal[v].normalize()).abs();
        // A force below the rounding of the coordinates counts as zero, because no other position would be better.
        if force < 32.0 * f64::EPSILON * radius { 0.0 } else { force / (2.0 * area[v] / 3.0) * radius }
    };
    (0..n).filter(|&v| !fixed[v]).map(at).fold(0.0, f64::max)
}

/// Computes the number of negative eigenvalues of the second derivatives of the area along the vertex normals, by
/// elimination of the dense matrix (Sylvester's law of inertia).
fn morse_index(mesh: &Mesh, fixed: &[bool]) -> usize {
    let mut normal = vec![DVec3::ZERO; mesh.vertices.len()];
    for &t in &mesh.triangles {
        let [a, b, c] = t.map(|v| mesh.vertices[v as usize]);
        t.iter().for_each(|&v| normal[v as usize] += (b - a).cross(c - a));
    }
    normal.iter_mut().for_each(|n| *n = n.normalize());
    let free: Vec<usize> = (0..fixed.len()).filter(|&v| !fixed[v]).collect();
    let row = |v: u32| free.binary_search(&(v as usize)).ok();
    let n = free.len();
    let mut matrix = vec![0.0; n * n];
    for &t in &mesh.triangles {
        let p = t.map(|v| mesh.vertices[v as usize]);
        let m = t.map(|v| normal[v as usize]);
        // `whole` is twice the area vector, p0 x p1 + p1 x p2 + p2 x p0. `first` are its derivatives with respect to
        // the three heights.
        let whole = (p[1] - p[0]).cross(p[2] - p[0]);
        let length = whole.length();
        let first = [0, 1, 2].map(|k: usize| m[k].cross(p[(k + 1) % 3] - p[(k + 2) % 3]));
        for i in 0..3 {
            for j in 0..3 {
                let (Some(a), Some(b)) = (row(t[i]), row(t[j])) else { continue };
                let mixed = match (j + 3 - i) % 3 {
                    0 => DVec3::ZERO,
                    1 => m[i].cross(m[j]),
                    _ => m[j].cross(m[i]),
                };
                let along = whole.dot(first[i]) * whole.dot(first[j]) / length.powi(3);
                matrix[a * n + b] += 0.5 * ((first[i].dot(first[j]) + whole.dot(mixed)) / length - along);
            }
        }
    }
    let mut negative = 0;
    for k in 0..n {
        let pivot = matrix[k * n + k];
        negative += usize::from(pivot < 0.0);
        let eliminating = matrix[k * n..(k + 1) * n].to_vec();
        for i in k + 1..n {
            let factor = matrix[i * n + k] / pivot;
            if factor != 0.0 {
                matrix[i * n + k..(i + 1) * n].iter_mut().zip(&eliminating[k..]).for_each(|(a, b)| *a -= factor * b);
            }
        }
    }
    negative
}

/// Whether two triangles without a common corner pierce each other.
fn is_crossed(mesh: &Mesh) -> bool {
    let coord = |p: DVec3| Coord3D { x: p.x, y: p.y, z: p.z };
    let volume = |a: DVec3, b: DVec3, c: DVec3, d: DVec3| orient3d(coord(a), coord(b), coord(c), coord(d));
    let corners = |t: &[u32; 3]| t.map(|v| mesh.vertices[v as usize]);
    let pierces = |e: &[DVec3; 3], [a, b, c]: [DVec3; 3]| {
        (0..3).any(|k| {
            let (p, q) = (e[k], e[(k + 1) % 3]);
            let turns = [volume(p, q, a, b), volume(p, q, b, c), volume(p, q, c, a)];
            volume(a, b, c, p) * volume(a, b, c, q) < 0.0
                && (turns.iter().all(|&t| t > 0.0) || turns.iter().all(|&t| t < 0.0))
        })
    };
    mesh.triangles.iter().enumerate().any(|(k, t)| {
        let one = corners(t);
        mesh.triangles[..k].iter().filter(|s| !s.iter().any(|v| t.contains(v))).any(|s| {
            let other = corners(s);
            let low = |t: &[DVec3; 3]| t[0].min(t[1]).min(t[2]);
            let high = |t: &[DVec3; 3]| t[0].max(t[1]).max(t[2]);
            low(&one).cmple(high(&other)).all()
                && low(&other).cmple(high(&one)).all()
                && (pierces(&one, other) || pierces(&other, one))
        })
    })
}

/// Counts the films in which a property was compared that a solver could get wrong.
#[derive(Debug, Default)]
struct Compared {
    /// Films that cross themselves.
    crossed: u32,
    /// Films whose residual was computed here.
    residuals: u32,
    /// Films with a direction in which the area falls.
    unstable: u32,
}

/// Returns the word `right`, or describes the fault of a result in words.
fn verdict(given: &[Vec<DVec3>], solved: Result<MinimalSurface, Error>, compared: &mut Compared) -> String {
    let surface = match solved {
        Ok(surface) => surface,
        Err(Error::NoResult { reason, .. }) => return format!("refused: {reason}"),
        Err(Error::Input(errors)) => return format!("refused: {}", errors[0].place),
        Err(error) => return format!("error: {error}"),
    };
    let statistics = &surface.statistics;
    let crossed = is_crossed(&surface.mesh);
    compared.crossed += u32::from(crossed);
    let check = self_intersections::check(&surface.mesh, Order::Spatial, usize::MAX, &Execution::default());
    let (_, warning) = check.expect("nobody interrupts");
    // Only this direction is compared, because `is_crossed` does not count triangles that only touch.
    if crossed && warning.is_none() {
        return format!("crosses itself: {crossed}, which is not said");
    }
    if !statistics.converged {
        return format!("not converged: {}", statistics.stop_reason.name());
    }
    let mut fixed = vec![false; surface.mesh.vertices.len()];
    surface.boundaries.iter().flatten().for_each(|&v| fixed[v as usize] = true);
    let bounding: Vec<DVec3> =
        surface.boundaries.iter().flatten().map(|&v| surface.mesh.vertices[v as usize]).collect();
    let centre = bounding.iter().sum::<DVec3>() / bounding.len() as f64;
    let radius = bounding.iter().map(|p| p.distance(centre)).fold(0.0, f64::max);
    let centred = Mesh {
        vertices: surface.mesh.vertices.iter().map(|&p| p - centre).collect(),
        triangles: surface.mesh.triangles.clone(),
    };
    // The rounding of coordinates is proportional to the distance from the origin, and the error of a residual is this
    // rounding over the square of an edge length.
    let far = given.iter().flatten().map(|p| p.length()).fold(0.0, f64::max) > 1e3 * radius;
    let allowed = if far { FAR_RESIDUAL } else { 1e-5 };
    let own = residual(&centred, &fixed, radius);
    compared.residuals += 1;
    if own.is_nan() || own > allowed {
        return format!("converged with a residual of {own:.1e}");
    }
    let Some(stability) = statistics.stability else { return "converged with no index".into() };
    let own = morse_index(&centred, &fixed);
    compared.unstable += u32::from(own > 0);
    // The sign of a smaller eigenvalue is decided by rounding.
    let decided = (stability.lowest_eigenvalue * radius * radius).abs() > 0.1 * allowed;
    if Some(own) != stability.morse_index && decided {
        return format!("converged with an index of {own}, not {:?}", stability.morse_index);
    }
    "right".into()
}

#[test]
fn awkward_boundaries_have_a_right_film_or_are_refused_by_name() {
    let each = if std::env::var_os("PLATEAU_LONG").is_some() { 63 } else { 3 };
    let mut random = SplitMix64::new(4);
    let (mut counts, mut all, mut right): (BTreeMap<String, u32>, u32, u32) = Default::default();
    let mut compared = Compared::default();
    for case in 0..each {
        for kind in KINDS {
            let (given, options) = request(kind, &mut random);
            let verdict = verdict(&given, solve(&given, &options, &Execution::default()), &mut compared);
            all += 1;
            right += u32::from(verdict == "right");
            assert!(
                !verdict.starts_with("converged with") && !verdict.ends_with("not said"),
                "{kind} {case}: {verdict}"
            );
            *counts.entry(format!("{kind}: {verdict}")).or_default() += 1;
        }
    }
    counts.iter().for_each(|(what, count)| println!("{count:4} {what}"));
    println!("{compared:?}");
    assert!(f64::from(right) >= 0.95 * f64::from(all), "{right} of {all}");
    assert!(compared.crossed > 0 && compared.residuals > 0 && compared.unstable > 0, "{compared:?}");
}
