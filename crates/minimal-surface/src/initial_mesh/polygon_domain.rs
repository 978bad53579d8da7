//! Images of a boundary loop in the plane, in which it can be triangulated.

use plateau_mesh::plane::frame::Frame;
use plateau_mesh::plane::polygon::doubled_area_vector;
use plateau_mesh::{DVec2, DVec3, polyline};

/// The images of the loop's points in the plane, anticlockwise.
#[derive(Clone, Debug)]
pub(super) struct PlaneLoop {
    pub rim: Vec<DVec2>,
}

/// Returns the images of the loop that are worth trying, the best first: the projection onto the plane perpendicular to
/// the area vector of the loop, then the unit circle with the points at their fractions of arc length.
///
/// The projection is left out if the loop encloses no area. Only the triangulation finds out whether the projected loop
/// is simple.
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

/// Rounds to the nearest point of a fine grid. In symmetric loops four points lie on one circle, so that either
/// diagonal is Delaunay. Without the grid, the last bits, which depend on scale and position, would decide which one is
/// chosen.
pub(super) fn snapped(point: DVec2) -> DVec2 {
    const GRID: f64 = (1u64 << 32) as f64;
    (point * GRID).round() / GRID
}
