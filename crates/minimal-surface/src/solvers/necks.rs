//! Decides whether a stable film exists, or whether only its mesh holds it together. A mesh of long edges holds a thin
//! neck at distances at which no minimal surface connects the boundaries.
//!
//! 1. The [margin](plateau_equilibrium::stability::Margin) m of the film is compared with the margin of the film whose
//!    edges are halved. Near the limit beyond which no film exists, m² is proportional to the distance from the limit,
//!    and the mesh moves the limit by a multiple of h². The margin of a mesh of edges of length zero is therefore the
//!    root of m_fine² - (m_coarse² - m_fine²) / 3.
//! 2. If this root is not far from the margin of the film, the mesh is fine enough and the film exists.
//! 3. Otherwise the mesh is refined where the film bends most in relation to its edges, which is at the neck. The mesh
//!    is also refined at a boundary in which a neck ends, if the edges there are as long as the boundary is wide,
//!    because the mesh is a cone there, whatever its margin. The film is solved on the refined mesh, and step 1 starts
//!    again.
//! 4. If the solver finds no film on the refined mesh, the film has collapsed. If the mesh may not be refined any
//!    further, the film exists if the radicand in step 1 is positive. If the radicand is not positive, but the margin
//!    of the film is not small, a copy of the film with halved edges is solved with new triangles. The film exists if
//!    the margin of this copy is nearly as large. The margin in step 1 may be too small, because the triangles in the
//!    spikes of a boundary are thin, and halving their edges leaves them thin.
//! 5. On a mesh whose edges at a boundary are as long as the boundary is wide, the solver may find no film although one
//!    exists. The initial mesh is then refined there, and solved again.

use plateau_mesh::film::Film;
use plateau_mesh::remesh::isotropic::graded;
use plateau_mesh::topology::NONE;
use plateau_mesh::{DVec3, measure, polyline};
use std::f64::consts::TAU;

// Tunables. The figures in docs/VALIDATION.md were obtained with these values.

/// A film exists without a further check if it has at least this margin and its edges turn by at most
/// [`COARSE_TURNING`]. In a film with one boundary the edges do not matter, because it has no neck. Between rings the
/// margin has this value at nine tenths of the largest distance.
const CALM: f64 = 0.6;
/// Largest turning of the normal along an edge (radians) of a film that exists without a further check. The edges of a
/// hexagonal neck turn further.
const COARSE_TURNING: f64 = 0.7;
/// A neck ends in a boundary if the normals along the boundary deviate from their mean by more than this (radians), or
/// would do so on a fine mesh. The normals of a plane film around a small hole do not deviate, so it has no neck.
const BENT: f64 = 0.3;
/// Largest length of an edge that ends at the boundary of a neck, as a fraction of the length of that boundary over 2
/// π. If an edge is longer, the mesh is refined there.
const COARSE_EDGE: f64 = 0.7;
/// A mesh is fine enough if halving its edges leaves at least this fraction of the film's margin.
const RESOLVED: f64 = 0.8;
/// Least margin of a film, and of the film whose edges are halved, if the latter is solved with new triangles.
pub(crate) const SAFE: f64 = 0.3;
/// Turning of the normal along an edge (radians) at which the first refinement aims. Each further round halves it. A
/// neck has about 2 π / 0.25 = 25 edges around it after the first round.
const FIRST_TURNING: f64 = 0.25;
/// Smallest turning of the normal along an edge (radians) at which a refinement aims. The mesh then moves the limit by
/// about a thousandth of the largest distance.
const LAST_TURNING: f64 = 0.06;
/// Largest number of triangles that a refinement may make, unless twice the number of the film is more.
const MOST_TRIANGLES: f64 = 40_000.0;
/// Largest number of triangles of a film that is solved again with half as long edges.
const MOST_HALVED: usize = 25_000;

/// The result of the comparison of a stable film with a finer one.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(crate) enum Look {
    /// The film exists, with this margin.
    Exists(f64),
    /// The mesh is too coarse to tell whether the film exists. The value is the margin of a mesh of edges of length
    /// zero, or `None` if the radicand in step 1 is not positive or the finer film was not found.
    Unresolved(Option<f64>),
}

/// Whether a film exists without a further check (see [`CALM`]).
pub(crate) fn is_calm(film: &Film, margin: f64) -> bool {
    let is_fine = || turnings(film).all(|(_, _, turning, _)| turning <= COARSE_TURNING) && has_fine_ends(film);
    margin >= CALM && (film.boundaries.len() == 1 || is_fine())
}

/// Whether the edges at the ends of all necks are short enough.
pub(crate) fn has_fine_ends(film: &Film) -> bool {
    let radius = neck_radii(film);
    let topology = &film.topology;
    (0..topology.twin.len() as u32).all(|h| {
        let (a, b) = (topology.from(h) as usize, topology.to(h) as usize);
        let longest = COARSE_EDGE * radius[a].min(radius[b]);
        (film.fixed[a] && film.fixed[b]) || film.vertices[a].distance(film.vertices[b]) <= longest
    })
}

/// Returns the target edge lengths of step 5, one for each vertex. Returns `None` if no boundary is narrow in
/// comparison with the edges that end at it, or if the mesh would have too many triangles.
pub(crate) fn sizes_at_narrow_ends(film: &Film) -> Option<Vec<f64>> {
    let longest = longest_free_edges(film);
    let mut sizes: Vec<f64> = longest.iter().map(|&length| if length > 0.0 { length } else { f64::INFINITY }).collect();
    let mut is_narrow = false;
    for boundary in &film.boundaries {
        let points: Vec<DVec3> = boundary.iter().map(|&v| film.vertices[v as usize]).collect();
        let own = polyline::length(&points, true) / TAU;
        if boundary.iter().any(|&v| longest[v as usize] > COARSE_EDGE * own) {
            is_narrow = true;
            boundary.iter().for_each(|&v| sizes[v as usize] = sizes[v as usize].min(FIRST_TURNING * own));
        }
    }
    if !is_narrow {
        return None;
    }
    graded(film, &mut sizes);
    is_affordable(film, &sizes).then_some(sizes)
}

/// Returns for each vertex of a boundary in which a neck ends the length of the boundary over 2 π, and infinity for all
/// other vertices. A film with one boundary has no neck that ends in it.
fn neck_radii(film: &Film) -> Vec<f64> {
    let mut radius = vec![f64::INFINITY; film.vertices.len()];
    if film.boundaries.len() < 2 {
        return radius;
    }
    let normals = measure::normals(&film.vertices, film.triangles());
    let longest = longest_free_edges(film);
    for boundary in &film.boundaries {
        let points: Vec<DVec3> = boundary.iter().map(|&v| film.vertices[v as usize]).collect();
        let own = polyline::length(&points, true) / TAU;
        // An edge of the length L at a boundary of the radius r replaces the neck by a cone of the slope rise / L. The
        // neck itself rises like ln(1 + L / r), so at the boundary its slope is larger than that of the cone by the
        // factor (L / r) / ln(1 + L / r).
        let reach = boundary.iter().map(|&v| longest[v as usize]).fold(0.0, f64::max) / own;
        let steeper = if reach > 0.0 { reach / libm::log1p(reach) } else { 1.0 };
        let sum: DVec3 = boundary.iter().map(|&v| normals[v as usize]).sum();
        // The normals around a cylinder add up to zero, so they have no mean direction.
        let has_mean = sum.length() > 0.5 * boundary.len() as f64;
        if has_mean && boundary.iter().all(|&v| steeper * measure::angle(normals[v as usize], sum) <= BENT) {
            continue;
        }
        boundary.iter().for_each(|&v| radius[v as usize] = own);
    }
    radius
}

/// Returns for each vertex the length of its longest edge with an end that can move.
pub(crate) fn longest_free_edges(film: &Film) -> Vec<f64> {
    let mut longest = vec![0.0f64; film.vertices.len()];
    let topology = &film.topology;
    for h in 0..topology.twin.len() as u32 {
        let (a, b) = (topology.from(h) as usize, topology.to(h) as usize);
        if !(film.fixed[a] && film.fixed[b]) {
            let length = film.vertices[a].distance(film.vertices[b]);
            longest[a] = longest[a].max(length);
            longest[b] = longest[b].max(length);
        }
    }
    longest
}

/// Does steps 1 and 2 for the margin of a film and the margin of the film whose edges are halved `halvings` times.
/// `fine` is `None` if no finer film was found.
pub(crate) fn compare(coarse: f64, fine: Option<f64>, halvings: u32) -> Look {
    let Some(fine) = fine else { return Look::Unresolved(None) };
    let growth = f64::from(4u32.pow(halvings.min(12)));
    let limit = fine * fine - (coarse * coarse - fine * fine) / (growth - 1.0);
    // With one halving this is the condition fine >= RESOLVED coarse.
    let error = fine * fine - limit;
    if error <= (1.0 / (RESOLVED * RESOLVED) - 1.0) / 3.0 * fine * fine {
        return Look::Exists(limit.sqrt().min(fine));
    }
    Look::Unresolved((limit > 0.0).then(|| limit.sqrt()))
}

/// Does the last part of step 4 for the margin of a film and the margin of the film with half as long edges and new
/// triangles. `finer` is `None` if there is no such film.
pub(crate) fn confirm(margin: f64, finer: Option<f64>) -> Look {
    let safe = finer.filter(|&finer| finer >= SAFE && finer >= RESOLVED * margin);
    safe.map_or(Look::Unresolved(None), Look::Exists)
}

/// Returns for each vertex half the length of its longest edge with an end that can move. `None` if the film has more
/// than [`MOST_HALVED`] triangles.
pub(crate) fn halved_sizes(film: &Film) -> Option<Vec<f64>> {
    let half = |length: f64| if length > 0.0 { 0.5 * length } else { f64::INFINITY };
    (film.triangles().len() <= MOST_HALVED).then(|| longest_free_edges(film).into_iter().map(half).collect())
}

/// Returns the interior edges with an end that can move: both ends, the angle between the normals at the ends, and the
/// length.
fn turnings(film: &Film) -> impl Iterator<Item = (usize, usize, f64, f64)> + '_ {
    let normals = measure::normals(&film.vertices, film.triangles());
    let topology = &film.topology;
    (0..topology.twin.len() as u32).filter_map(move |h| {
        let (a, b) = (topology.from(h) as usize, topology.to(h) as usize);
        let twin = topology.twin[h as usize];
        let is_free = twin != NONE && twin > h && !(film.fixed[a] && film.fixed[b]);
        let length = film.vertices[a].distance(film.vertices[b]);
        (is_free && length > 0.0).then(|| (a, b, measure::angle(normals[a], normals[b]), length))
    })
}

/// Returns the target edge lengths of step 3, one for each vertex. They are chosen so that the normal turns along no
/// edge by more than an angle that falls from round to round. Returns `None` if the mesh may not be refined any
/// further.
pub(crate) fn finer_sizes(film: &Film) -> Option<Vec<f64>> {
    let mut curvature = vec![0.0f64; film.vertices.len()];
    let mut longest = vec![0.0f64; film.vertices.len()];
    let mut largest = 0.0f64;
    for (a, b, turning, length) in turnings(film) {
        largest = largest.max(turning);
        for v in [a, b] {
            curvature[v] = curvature[v].max(turning / length);
            longest[v] = longest[v].max(length);
        }
    }
    let mut aim = FIRST_TURNING;
    if has_fine_ends(film) {
        // At most three passes, because the angle halves from `FIRST_TURNING` to `LAST_TURNING`.
        while aim >= LAST_TURNING && aim > 0.6 * largest {
            aim *= 0.5;
        }
    }
    if aim < LAST_TURNING {
        return None;
    }
    let ends = neck_radii(film);
    let size = |v: usize| {
        let bend = if curvature[v] > 0.0 { aim / curvature[v] } else { f64::INFINITY };
        let own = if longest[v] > 0.0 { longest[v] } else { f64::INFINITY };
        own.min(bend).min(aim * ends[v])
    };
    let mut sizes: Vec<f64> = (0..film.vertices.len()).map(size).collect();
    graded(film, &mut sizes);
    is_affordable(film, &sizes).then_some(sizes)
}

/// Whether a mesh with these target edge lengths has at most the permitted number of triangles.
fn is_affordable(film: &Film, sizes: &[f64]) -> bool {
    let unit = 0.75f64.sqrt() / 2.0;
    let triangles = |triangle: &[u32; 3]| {
        let size = triangle.iter().map(|&v| sizes[v as usize]).sum::<f64>() / 3.0;
        let area = 0.5 * measure::double_area_vector(film.corners(*triangle)).length();
        (area / (unit * size * size)).max(1.0)
    };
    let count: f64 = film.triangles().iter().map(triangles).sum();
    count <= MOST_TRIANGLES.max(2.0 * film.triangles().len() as f64)
}
