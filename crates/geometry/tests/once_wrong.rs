//! Inputs that once gave a wrong result without a word, each with what is right.

use plateau_geometry::minimal_surface::{Method, MinimalSurface, Newton, Options, Resolution, TopologyRule, solve};
use plateau_geometry::{DVec3, Error, Execution};
use std::f64::consts::TAU;

fn ring(points: usize, radius: f64, height: f64) -> Vec<DVec3> {
    (0..points)
        .map(|k| {
            let (sine, cosine) = (TAU * k as f64 / points as f64).sin_cos();
            DVec3::new(radius * cosine, radius * sine, height)
        })
        .collect()
}

fn by_topology(topology: TopologyRule, triangles: usize) -> Options {
    let method = Method::Newton(Newton { topology, ..Newton::default() });
    Options { method, ..Options::new(Resolution::Triangles(triangles)) }
}

fn spanned(boundaries: &[Vec<DVec3>], options: &Options) -> Result<MinimalSurface, Error> {
    solve(boundaries, options, &Execution::default())
}

#[test]
fn without_a_connected_film_fixed_fails_and_names_the_topology() {
    for (triangles, heights) in
        [(500, vec![0.0, 1.5]), (3000, vec![0.0, 1.4]), (3000, vec![0.0, 4.0]), (2000, vec![0.0, 0.9, 2.4])]
    {
        let rings: Vec<Vec<DVec3>> = heights.iter().map(|&height| ring(48, 1.0, height)).collect();
        match spanned(&rings, &by_topology(TopologyRule::Fixed, triangles)) {
            Err(Error::NoResult { reason, detail, places }) => {
                assert_eq!(
                    (reason, places[0].place.to_string().as_str()),
                    ("no_connected_film", "/topology"),
                    "{detail}"
                );
            }
            Err(error) => panic!("{heights:?}: {error}"),
            Ok(surface) => panic!("{heights:?}: {} {:?}", surface.statistics.residual, surface.statistics.stop_reason),
        }
    }
}

#[test]
fn three_concentric_loops_in_a_plane_have_no_connected_film_and_that_is_said() {
    let loops = [ring(40, 1.0, 0.0), ring(60, 2.0, 0.0), ring(80, 3.0, 0.0)];
    match spanned(&loops, &by_topology(TopologyRule::Fixed, 2000)) {
        Err(Error::NoResult { reason, places, .. }) => {
            assert_eq!((reason, places[0].place.to_string().as_str()), ("no_connected_film", "/topology"));
        }
        other => panic!("{:?}", other.map(|surface| (surface.statistics.area, surface.statistics.flipped_triangles))),
    }
}
