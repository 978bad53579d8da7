//! Liu and Wang's initial mesh: candidate points are barycentres of nested triangles around the loop's centroid, a
//! seeded choice picks n of them, and these and the loop are triangulated by Delaunay's criterion.

use super::polygon_domain::{PlaneLoop, domain_of, snapped};
use plateau_mesh::codes::Reason;
use plateau_mesh::film::Film;
use plateau_mesh::plane::polygon::contains;
use plateau_mesh::plane::triangulation::{Border, Constraint, triangles_inside};
use plateau_mesh::random::SplitMix64;
use plateau_mesh::topology::NONE;
use plateau_mesh::{DVec2, DVec3, Error, Execution, polyline};

/// A candidate vertex: its position in space and in the plane of the triangulation.
#[derive(Clone, Copy, Debug, PartialEq)]
struct Candidate {
    space: DVec3,
    plane: DVec2,
}

impl Candidate {
    fn barycentre([a, b, c]: [Self; 3]) -> Self {
        Self { space: (a.space + b.space + c.space) / 3.0, plane: snapped((a.plane + b.plane + c.plane) / 3.0) }
    }
}

/// Builds a film whose boundary is the given loop (vertices 0, 1, … in order) and which has `interior_vertices` further
/// vertices. The `seed` chooses these among Liu and Wang's candidates: the centroid of the loop; the barycentre of each
/// triangle between the centroid and a side of the loop; the barycentres of the three parts into which a barycentre
/// divides its triangle; and so on level by level, until there are at least `interior_vertices` candidates.
///
/// The triangulation is constrained Delaunay in the plane in which the loop encloses the largest area, if the image of
/// the loop is simple there. Otherwise it is made in a unit disc, on whose circle the loop is laid by arc length.
/// Candidates outside the image of a concave loop are left out. Departure from the paper: its indices leave out the
/// last side of the loop, but here this side gets candidates too.
///
/// # Errors
/// [`Error::NoResult`] with `no_room_for_interior_vertices` if ten levels of candidates do not hold enough, with
/// `no_initial_mesh` if the loop cannot be triangulated in either plane. O((m + n) log(m + n) + m n) for m loop points.
pub(crate) fn candidate_mesh(
    boundary: &[DVec3],
    interior_vertices: usize,
    seed: u64,
    execution: &Execution<'_>,
) -> Result<Film, Error> {
    let mut last = None;
    for domain in domain_of(boundary) {
        match triangulate(boundary, &domain, interior_vertices, seed, execution) {
            Ok(film) => return Ok(film),
            Err(error @ (Error::Interrupted(_) | Error::Input(_))) => return Err(error),
            Err(error) => last = Some(error),
        }
    }
    Err(last.unwrap_or_else(|| {
        Error::no_result(Reason::NoInitialMesh, "The loop has no triangulation in its best plane nor in a disk.")
    }))
}

fn triangulate(
    boundary: &[DVec3],
    domain: &PlaneLoop,
    interior_vertices: usize,
    seed: u64,
    execution: &Execution<'_>,
) -> Result<Film, Error> {
    let chosen = choose(candidates(boundary, domain, interior_vertices, execution)?, interior_vertices, seed);
    let points: Vec<DVec2> = domain.rim.iter().copied().chain(chosen.iter().map(|c| c.plane)).collect();
    let m = boundary.len() as u32;
    let sides: Vec<Constraint> =
        (0..m).map(|k| Constraint { from: k, to: (k + 1) % m, border: Border::Outline }).collect();
    let failed = |detail: &str| Error::no_result(Reason::NoInitialMesh, detail);
    let triangles =
        triangles_inside(&points, &sides).map_err(|_| failed("The loop's image crosses or touches itself."))?;
    execution.look(points.len() as u64)?;
    let vertices = boundary.iter().copied().chain(chosen.iter().map(|c| c.space)).collect();
    let rim: Vec<u32> = (0..m).collect();
    Film::new(vertices, &triangles, vec![rim])
        .filter(|film| film.topology.euler_characteristic() == 1 && is_only_boundary(film, m))
        .ok_or_else(|| failed("The loop's image does not bound one disk."))
}

/// Whether the boundary edges of the film are exactly those from vertex k to k + 1 of the first m vertices.
fn is_only_boundary(film: &Film, m: u32) -> bool {
    let topology = &film.topology;
    let mut count = 0;
    (0..topology.twin.len() as u32).filter(|&h| topology.twin[h as usize] == NONE).all(|h| {
        count += 1;
        topology.from(h) < m && topology.to(h) == (topology.from(h) + 1) % m
    }) && count == m
}

/// Generates the candidates level by level, until at least `wanted` of them lie inside the domain.
fn candidates(
    boundary: &[DVec3],
    domain: &PlaneLoop,
    wanted: usize,
    execution: &Execution<'_>,
) -> Result<Vec<Candidate>, Error> {
    let corner = |k: usize| Candidate { space: boundary[k], plane: domain.rim[k] };
    let m = boundary.len();
    let centre =
        Candidate { space: polyline::mean(boundary), plane: snapped(domain.rim.iter().sum::<DVec2>() / m as f64) };
    let mut found = Vec::new();
    if contains(&domain.rim, centre.plane) {
        found.push(centre);
    }
    let mut triangles: Vec<[Candidate; 3]> = (0..m).map(|k| [corner(k), corner((k + 1) % m), centre]).collect();
    for _ in 0..10 {
        if found.len() >= wanted {
            break;
        }
        let mut parts = Vec::with_capacity(3 * triangles.len());
        for (k, &[a, b, c]) in triangles.iter().enumerate() {
            let middle = Candidate::barycentre([a, b, c]);
            if contains(&domain.rim, middle.plane) {
                found.push(middle);
            }
            parts.extend([[a, b, middle], [a, c, middle], [b, c, middle]]);
            if k % 256 == 255 {
                execution.look((256 * m) as u64)?;
            }
        }
        drop_repeated(&mut found);
        triangles = parts;
    }
    if found.len() < wanted {
        let detail = format!("Only {} candidate points lie inside the boundary; ask for fewer.", found.len());
        return Err(Error::NoResult { reason: Reason::NoRoomForInteriorVertices, detail, places: Vec::new() });
    }
    Ok(found)
}

/// Removes each candidate whose position in the plane repeats that of an earlier candidate, because two triangles of a
/// symmetric loop may share a barycentre. The tolerance is absolute, because the domain lies in the unit disc.
/// The order of generation is kept, because it does not depend on the position of the loop in space.
fn drop_repeated(found: &mut Vec<Candidate>) {
    const SAME: f64 = 1e-9;
    let mut order: Vec<usize> = (0..found.len()).collect();
    order.sort_by(|&a, &b| found[a].plane.x.total_cmp(&found[b].plane.x).then(a.cmp(&b)));
    let mut repeated = vec![false; found.len()];
    for (place, &a) in order.iter().enumerate() {
        let near = order[place + 1..].iter().take_while(|&&b| found[b].plane.x - found[a].plane.x <= SAME);
        for &b in near {
            if !repeated[a] && !repeated[b] && (found[a].plane.y - found[b].plane.y).abs() <= SAME {
                repeated[a.max(b)] = true;
            }
        }
    }
    let mut repeated = repeated.into_iter();
    found.retain(|_| !repeated.next().unwrap_or(false));
}

/// Chooses `count` candidates and keeps them in their order. Each subset of this size is equally likely over the seeds.
fn choose(candidates: Vec<Candidate>, count: usize, seed: u64) -> Vec<Candidate> {
    let mut seeded = SplitMix64::new(seed);
    let mut order: Vec<usize> = (0..candidates.len()).collect();
    for k in 0..count {
        order.swap(k, k + seeded.below(candidates.len() - k));
    }
    order.truncate(count);
    order.sort_unstable();
    order.into_iter().map(|k| candidates[k]).collect()
}

#[cfg(test)]
mod tests {
    use super::*;

    fn ring(n: usize, height: impl Fn(f64) -> f64) -> Vec<DVec3> {
        (0..n)
            .map(|k| {
                let t = k as f64 * std::f64::consts::TAU / n as f64;
                DVec3::new(libm::cos(t), libm::sin(t), height(t))
            })
            .collect()
    }

    #[test]
    fn counts_are_exact_and_the_boundary_comes_first() {
        for (m, n) in [(28, 20), (24, 25), (9, 4), (3, 0), (12, 300)] {
            let boundary = ring(m, |t| 0.2 * libm::cos(3.0 * t));
            let mesh = candidate_mesh(&boundary, n, 1, &Execution::default()).unwrap();
            assert_eq!((mesh.vertices.len(), mesh.triangles().len()), (m + n, m + 2 * n - 2));
            assert_eq!(mesh.vertices[..m], boundary);
        }
    }

    #[test]
    fn the_seed_decides_and_nothing_else() {
        let boundary = ring(20, |_| 0.0);
        let with = |seed| candidate_mesh(&boundary, 12, seed, &Execution::default()).unwrap();
        assert_eq!(with(7).mesh(), with(7).mesh());
        assert_ne!(with(7).vertices, with(8).vertices);
    }

    #[test]
    fn a_loop_without_a_simple_projection_is_triangulated_in_the_disk() {
        // A trefoil: every projection crosses itself.
        let boundary: Vec<DVec3> = (0..60)
            .map(|k| {
                let t = f64::from(k) * std::f64::consts::TAU / 60.0;
                DVec3::new(
                    libm::sin(t) + 2.0 * libm::sin(2.0 * t),
                    libm::cos(t) - 2.0 * libm::cos(2.0 * t),
                    -libm::sin(3.0 * t),
                )
            })
            .collect();
        let mesh = candidate_mesh(&boundary, 30, 1, &Execution::default()).unwrap();
        assert_eq!(mesh.topology.euler_characteristic(), 1);
    }

    #[test]
    fn a_concave_loop_keeps_its_candidates_inside() {
        let corners = [(0.0, 0.0), (3.0, 0.0), (3.0, 3.0), (2.6, 3.0), (2.6, 0.4), (0.4, 0.4), (0.4, 3.0), (0.0, 3.0)];
        let boundary: Vec<DVec3> = corners.iter().map(|&(x, y)| DVec3::new(x, y, 0.1 * x)).collect();
        let mesh = candidate_mesh(&boundary, 10, 3, &Execution::default()).unwrap();
        let area: f64 = mesh
            .triangles()
            .iter()
            .map(|&t| {
                let [a, b, c] = mesh.corners(t);
                0.5 * (b - a).cross(c - a).z
            })
            .sum();
        assert!((area - (9.0 - 2.2 * 2.6)).abs() < 1e-12);
    }
}
