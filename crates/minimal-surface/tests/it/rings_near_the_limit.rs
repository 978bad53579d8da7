//! Two coaxial rings of radii 1 and r, at distances from half to twice the largest distance of a catenoid. Beyond the
//! largest distance no film may be called converged. Up to 0.99 of it no film may be lost.
//!
//! The rings are regular polygons, inscribed in circles. A film between them is compared with catenoids: beyond the
//! limit of the circumscribed circles there is no film, and below the limit of the inscribed circles there is a film.
//! `PLATEAU_LONG` runs the whole sweep.

use plateau_mesh::{DVec3, Error, Execution};
use plateau_minimal_surface::{MinimalSurface, Options, Resolution, solve};
use std::f64::consts::{PI, TAU};

fn ring(points: usize, radius: f64, height: f64, phase: f64) -> Vec<DVec3> {
    let angle = |k: usize| TAU * k as f64 / points as f64 + phase;
    (0..points).map(|k| DVec3::new(radius * angle(k).cos(), radius * angle(k).sin(), height)).collect()
}

/// Returns the largest distance between coaxial circles of radii R and r that a catenoid with the profile a cosh(z / a)
/// joins. The distance a (arcosh(R / a) + arcosh(r / a)) has a single maximum over the waist a, where its derivative
/// arcosh(R/a) + arcosh(r/a) - 1/√(1 - (a/R)²) - 1/√(1 - (a/r)²) changes its sign.
fn largest_distance(large: f64, small: f64) -> f64 {
    let reach = |a: f64| a * ((large / a).acosh() + (small / a).acosh());
    let slope = |a: f64| {
        let fall = |radius: f64| (radius / a).acosh() - 1.0 / (1.0 - (a / radius).powi(2)).sqrt();
        fall(large) + fall(small)
    };
    let (mut low, mut high) = (1e-9 * small, small * (1.0 - 1e-12));
    for _ in 0..200 {
        let middle = 0.5 * (low + high);
        *(if slope(middle) > 0.0 { &mut low } else { &mut high }) = middle;
    }
    reach(low)
}

#[test]
fn the_largest_distance_of_equal_rings_is_the_known_one() {
    assert!((largest_distance(1.0, 1.0) - 1.325_486_838_699).abs() < 1e-9);
}

struct Case {
    radius: f64,
    points: [usize; 2],
    triangles: usize,
    factor: f64,
}

impl Case {
    fn solved(&self) -> Result<MinimalSurface, Error> {
        let [large, small] = self.points;
        let shrunk = |points: usize| (PI / points as f64).cos();
        // Distances beyond the limit are multiples of that of the circumscribed circles. Distances below the limit are
        // multiples of that of the inscribed circles.
        let limit = if self.factor > 1.0 {
            largest_distance(1.0, self.radius)
        } else {
            largest_distance(shrunk(large), self.radius * shrunk(small))
        };
        let rings = [ring(large, 1.0, 0.0, 0.0), ring(small, self.radius, self.factor * limit, 0.1)];
        solve(&rings, &Options::new(Resolution::Triangles(self.triangles)), &Execution::default())
    }

    /// Solves the case and describes its fault, if it has one, in words.
    fn fault(&self) -> Option<String> {
        let start = std::time::Instant::now();
        let solved = self.solved();
        let told = match &solved {
            Err(error) => format!("{error}"),
            Ok(surface) => {
                let statistics = &surface.statistics;
                let codes: Vec<&str> = surface.warnings.iter().map(|warning| warning.code.name()).collect();
                let (reason, triangles) = (statistics.stop_reason.name(), statistics.triangles);
                format!("{reason} {triangles} triangles, {:?}, {codes:?}", statistics.stability)
            }
        };
        let holds = solved.is_ok_and(|surface| {
            surface.statistics.converged
                && surface.statistics.stability.is_some_and(|stability| stability.stable == Some(true))
        });
        let Self { radius, points, triangles, factor } = self;
        let line = format!("{radius} {points:?} {triangles} {factor} {:.1} s: {told}", start.elapsed().as_secs_f64());
        if std::env::var_os("PLATEAU_LONG").is_some() {
            println!("{line}");
        }
        (holds == (*factor > 1.0)).then_some(line)
    }
}

fn sweep(radii: &[f64], points: &[[usize; 2]], triangles: &[usize], factors: &[f64]) {
    let mut cases = Vec::new();
    for &radius in radii {
        for &points in points {
            for &triangles in triangles {
                cases.extend(factors.iter().map(|&factor| Case { radius, points, triangles, factor }));
            }
        }
    }
    let wrong: Vec<String> = cases.iter().filter_map(Case::fault).collect();
    assert!(wrong.is_empty(), "{} of {} wrong:\n{}", wrong.len(), cases.len(), wrong.join("\n"));
}

#[test]
fn beyond_the_largest_distance_nothing_converges_and_below_it_nothing_is_lost() {
    if std::env::var_os("PLATEAU_LONG").is_none() {
        // The first tier takes the distances next to the limit, where a fault shows first, and of the finer films those
        // between the most unequal rings.
        let first = |values: &'static [f64], number: usize| if crate::is_full() { values } else { &values[..number] };
        let factors = first(&[0.99, 1.01, 1.1, 0.7, 2.0], 2);
        sweep(&[1.0, 0.1], &[[48, 24]], &[300], factors);
        sweep(first(&[0.001, 0.1, 1.0], 1), &[[48, 24]], &[2000], factors);
        // With only 300 triangles the edges at the small ring are many times as long as the ring is wide.
        let radii = first(&[0.001, 0.005], 1);
        sweep(radii, &[[48, 24]], &[300], first(&[0.99, 0.98], 1));
        sweep(radii, &[[48, 24]], &[300], first(&[1.005, 1.5], 1));
        return;
    }
    let radii = [1.0, 0.5, 0.2, 0.1, 0.05, 0.02, 0.01, 0.005, 0.002, 0.001];
    let factors = [0.5, 0.7, 0.9, 0.95, 0.98, 0.99, 1.005, 1.01, 1.03, 1.1, 1.25, 1.5, 1.75, 2.0];
    sweep(&radii, &[[48, 24]], &[300, 600, 2000, 6000, 20_000], &factors);
    sweep(&radii, &[[40, 16], [96, 12]], &[600, 2000], &factors);
}
