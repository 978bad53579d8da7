//! Isometric unrolling: a strip is a chain of triangles, so it flattens without changing an edge length.

use super::flat_strip::FlatStrip;
use super::overlap::overlaps;
use crate::graph::rails::Rails;
use plateau_mesh::error::Error;
use plateau_mesh::execution::Execution;
use plateau_mesh::{DVec2, DVec3};

/// Flattens an open strip along its bridges and looks for overlaps. O(bridges log bridges) for patterns that do not
/// fold over themselves many times.
pub(crate) fn unroll(
    strip: &Rails,
    path: &[[u32; 2]],
    triangles: &[[u32; 3]],
    execution: &Execution<'_>,
) -> Result<FlatStrip, Error> {
    let (p, q) = (&strip.p.points, &strip.q.points);
    let mut flat = FlatStrip {
        p: vec![DVec2::ZERO; p.len()],
        q: vec![DVec2::ZERO; q.len()],
        bridges: path.to_vec(),
        triangles: triangles.to_vec(),
        ..FlatStrip::default()
    };
    let length = p[0].distance(q[0]);
    let (mut a, mut b) = (DVec2::ZERO, DVec2::new(length, 0.0));
    (flat.p[0], flat.q[0]) = (a, b);
    let (mut direction, mut worst, mut longest) = (DVec2::X, 0.0f64, length);
    for (step, pair) in path.windows(2).enumerate() {
        let ([i, j], [next, other]) = (pair[0].map(|k| k as usize), pair[1].map(|k| k as usize));
        let by_p = next != i;
        let (from, to) = (p[i], q[j]);
        let new = if by_p { p[next] } else { q[other] };
        if b != a {
            direction = (b - a).normalize();
        }
        // The position of the new point is measured from the end of the bridge that lies on the same directrix. The
        // bank edge between these two points, which usually is the shortest side of the triangle, is then exact.
        let origin = if by_p { from } else { to };
        let (along, height) = split(new - origin, to - from);
        let place = (if by_p { a } else { b }) + direction * along - direction.perp() * height;
        for (end, flat_end) in [(from, a), (to, b)] {
            let true_length = new.distance(end);
            longest = longest.max(true_length);
            worst = worst.max((place.distance(flat_end) - true_length).abs());
        }
        if by_p {
            flat.p[next] = place;
            a = place;
        } else {
            flat.q[other] = place;
            b = place;
        }
        if step % 4096 == 4095 {
            execution.look(4096)?;
        }
    }
    flat.edge_length_error_max = if longest > 0.0 { worst / longest } else { 0.0 };
    flat.straighten(strip.unit);
    flat.self_overlap = overlaps(&flat, execution)?;
    Ok(flat)
}

/// Returns the component of a vector along a bridge, and the distance of the vector's end from the bridge's line.
fn split(v: DVec3, bridge: DVec3) -> (f64, f64) {
    let length = bridge.length();
    if length == 0.0 { (v.length(), 0.0) } else { (v.dot(bridge) / length, v.cross(bridge).length() / length) }
}
