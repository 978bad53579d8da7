//! Plane images of a boundary loop in which a triangulation can be made.

use plateau_mesh::plane::frame::Frame;
use plateau_mesh::plane::polygon::doubled_area_vector;
use plateau_mesh::{DVec2, DVec3, polyline};

/// The images of the loop's points, anticlockwise.
#[derive(Clone, Debug)]
pub(super) struct PlaneLoop {
    pub rim: Vec<DVec2>,
}

/// The images to try, the best first: in the plane across the area vector of the loop, then on the unit circle by arc
/// length.
///
/// The first is left out if the loop encloses no area. The triangulation finds out whether it is simple.
pub(super) fn domain_of(boundary: &[DVec3]) -> Vec<PlaneLoop> {
    let centre = polyline::mean(boundary);
    let m = boundary.len();
    let offset: Vec<DVec3> = boundary.iter().map(|p| *p - centre).collect();
    let area_vector = doubled_area_vector(boundary);
    let reach2 = offset.iter().map(|p| p.length_squared()).fold(0.0, f64::max);
    let mut domains = Vec::new();
    if area_vector.length() > 1e-6 * reach2 {
        let normal = area_vector.normalize();
        // The direction u turns with the loop. The vectors u, v, normal are right-handed, so the loop runs
        // anticlockwise.
        let farthest = (0..m).fold(0, |best, k| {
            let reach = |k: usize| offset[k].reject_from_normalized(normal).length_squared();
            if reach(k) > reach(best) * (1.0 + 1e-9) { k } else { best }
        });
        let u = offset[farthest].reject_from_normalized(normal).normalize();
        let frame = Frame { origin: centre, x: u, y: normal.cross(u), normal };
        let scale = 1.0 / reach2.sqrt();
        domains.push(PlaneLoop { rim: boundary.iter().map(|&p| snapped(frame.project(p) * scale)).collect() });
    }
    let total = polyline::length(boundary, true);
    let mut walked = 0.0;
    let mut rim = Vec::with_capacity(m);
    for k in 0..m {
        let angle = walked / total * std::f64::consts::TAU;
        rim.push(snapped(DVec2::new(libm::cos(angle), libm::sin(angle))));
        walked += boundary[k].distance(boundary[(k + 1) % m]);
    }
    domains.push(PlaneLoop { rim });
    domains
}

/// The nearest point of a fine grid. Symmetric loops put four points on one circle. The grid keeps the last bits, which
/// depend on scale and position, from deciding which diagonal is chosen.
pub(super) fn snapped(point: DVec2) -> DVec2 {
    const GRID: f64 = (1u64 << 32) as f64;
    (point * GRID).round() / GRID
}
