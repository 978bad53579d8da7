//! The client's own initial mesh: checks it, and numbers its vertices in the same way as all other initial meshes.

use super::pins::{Pin, Pins};
use plateau_mesh::edit::orient_along;
use plateau_mesh::error::InputError;
use plateau_mesh::film::Film;
use plateau_mesh::measure::is_degenerate;
use plateau_mesh::polyline::position_key;
use plateau_mesh::topology::{Defect, NONE, Topology};
use plateau_mesh::{DVec3, Error, Mesh, Place};

/// Largest distance of an additional boundary vertex from its segment, as a fraction of the length of the segment.
pub(crate) const ON_SEGMENT: f64 = 1e-9;

/// Builds a film from the client's mesh. The mesh must be an oriented manifold whose boundary loops are the boundaries.
/// Each loop must pass exactly through the points of its boundary in order, in either direction, and may have further
/// vertices on the segments. Every component must have a boundary. The points and segments of the constraints must be
/// vertices and edges of the mesh.
///
/// # Errors
/// [`Error::Input`] under `initial_mesh`, naming the vertices or triangles.
pub(super) fn build(mesh: &Mesh, boundaries: &[Vec<DVec3>], pins: &Pins) -> Result<Film, Error> {
    let place = || Place::field("initial_mesh");
    let refuse = |detail: &str| Error::input(place(), detail);
    let mut errors = Vec::new();
    for (k, vertex) in mesh.vertices.iter().enumerate() {
        if !vertex.is_finite() {
            InputError::new(place().then("vertices").at(k), "every coordinate must be a finite number")
                .add_to(&mut errors);
        }
    }
    for (k, triangle) in mesh.triangles.iter().enumerate() {
        let place = place().then("triangles").at(k);
        if triangle.iter().any(|&v| v as usize >= mesh.vertices.len()) {
            InputError::new(place, "names a vertex that does not exist").add_to(&mut errors);
        } else if is_degenerate(mesh.corners(*triangle)) {
            InputError::new(place, "has no area").add_to(&mut errors);
        }
    }
    if !errors.is_empty() {
        return Err(Error::Input(errors));
    }
    let topology = mesh.check().map_err(|defect| match defect {
        Defect::NonManifoldEdge { .. } if is_one_sided(&mesh.triangles) => {
            refuse("has one side only, as a Möbius band: no solver here takes a film that cannot be oriented")
        }
        defect => refuse(&format!("must be an oriented manifold: {defect}")),
    })?;
    let loops = topology.boundary_loops();
    if loops.len() != boundaries.len() {
        let detail = format!("has {} boundary loops, there are {} boundaries", loops.len(), boundaries.len());
        return Err(refuse(&detail));
    }
    let mut taken = vec![false; loops.len()];
    let mut matched: Vec<Matched> = Vec::with_capacity(boundaries.len());
    for (k, polygon) in boundaries.iter().enumerate() {
        let found = (0..loops.len()).filter(|&l| !taken[l]).find_map(|l| Some((l, follow(mesh, &loops[l], polygon)?)));
        let Some((l, vertices)) = found else {
            let detail = format!("none of its boundary loops runs through the points of boundary {k}");
            return Err(refuse(&detail));
        };
        taken[l] = true;
        matched.push(vertices);
    }
    if topology.components() > 1 && has_closed_part(&topology, mesh) {
        return Err(refuse("has a part without a boundary"));
    }
    // The points of the boundary polygons come first, then the other vertices in the order of the client's mesh.
    let mut number = vec![NONE; mesh.vertices.len()];
    let mut next = 0;
    let own = matched.iter().flat_map(|boundary| boundary.own.iter().map(|&at| boundary.vertices[at]));
    for vertex in own.chain(0..mesh.vertices.len() as u32) {
        if number[vertex as usize] == NONE {
            number[vertex as usize] = next;
            next += 1;
        }
    }
    let mut vertices = mesh.vertices.clone();
    mesh.vertices.iter().zip(&number).for_each(|(&p, &v)| vertices[v as usize] = p);
    let mut triangles: Vec<[u32; 3]> =
        mesh.triangles.iter().map(|triangle| triangle.map(|v| number[v as usize])).collect();
    let loops: Vec<Vec<u32>> =
        matched.iter().map(|boundary| boundary.vertices.iter().map(|&v| number[v as usize]).collect()).collect();
    orient_along(&mut triangles, &loops[0]);
    let mut film = Film::new(vertices, &triangles, loops).expect("renaming keeps a manifold");
    fix(&mut film, pins)?;
    Ok(film)
}

/// Whether the triangles form a surface that cannot be oriented: no edge has more than two triangles, and yet the
/// triangles cannot be turned so that neighbours run along their common edge in opposite directions.
fn is_one_sided(triangles: &[[u32; 3]]) -> bool {
    let mut sides: Vec<([u32; 2], usize, bool)> = Vec::with_capacity(3 * triangles.len());
    for (t, &[a, b, c]) in triangles.iter().enumerate() {
        sides.extend([[a, b], [b, c], [c, a]].map(|[a, b]| ([a.min(b), a.max(b)], t, a < b)));
    }
    sides.sort_unstable();
    if sides.windows(3).any(|three| three[0].0 == three[2].0) {
        return false;
    }
    let mut neighbours: Vec<Vec<(usize, bool)>> = vec![Vec::new(); triangles.len()];
    for pair in sides.windows(2).filter(|pair| pair[0].0 == pair[1].0) {
        let turns = pair[0].2 == pair[1].2;
        neighbours[pair[0].1].push((pair[1].1, turns));
        neighbours[pair[1].1].push((pair[0].1, turns));
    }
    let mut turned: Vec<Option<bool>> = vec![None; triangles.len()];
    for start in 0..triangles.len() {
        let mut stack = vec![(start, turned[start].unwrap_or(false))];
        // At most three new entries per triangle, because a triangle adds its neighbours only once, when its turn is
        // decided.
        while let Some((triangle, turn)) = stack.pop() {
            match turned[triangle] {
                Some(known) if known != turn => return true,
                Some(_) => {}
                None => {
                    turned[triangle] = Some(turn);
                    stack.extend(neighbours[triangle].iter().map(|&(next, turns)| (next, turn != turns)));
                }
            }
        }
    }
    false
}

/// A boundary loop in the direction of the polygon. `own` holds the positions in `vertices` of the polygon's points.
struct Matched {
    vertices: Vec<u32>,
    own: Vec<usize>,
}

/// Returns the vertices of the loop, starting at the first point of the polygon. `None` unless the loop passes through
/// all points of the polygon in order and its other vertices lie on the segments.
fn follow(mesh: &Mesh, vertices: &[u32], polygon: &[DVec3]) -> Option<Matched> {
    let n = vertices.len();
    let position = |k: usize| mesh.vertices[vertices[k] as usize];
    let starts = (0..n).filter(|&k| position(k) == polygon[0]);
    starts.flat_map(|start| [(start, false), (start, true)]).find_map(|(start, backwards)| {
        let index = |k: usize| if backwards { start + n - k } else { start + k } % n;
        let mut own = vec![0];
        for k in 1..n {
            let point = position(index(k));
            if own.len() < polygon.len() && point == polygon[own.len()] {
                own.push(k);
                continue;
            }
            let (a, b) = (polygon[own.len() - 1], polygon[own.len() % polygon.len()]);
            let along = b - a;
            let beside = along.cross(point - a).length() > ON_SEGMENT * along.length_squared();
            let part = along.dot(point - a) / along.length_squared();
            if beside || part <= 0.0 || part >= 1.0 {
                return None;
            }
        }
        (own.len() == polygon.len()).then(|| Matched { vertices: (0..n).map(|k| vertices[index(k)]).collect(), own })
    })
}

fn has_closed_part(topology: &Topology, mesh: &Mesh) -> bool {
    let mut reached = vec![false; mesh.triangles.len()];
    let mut stack: Vec<u32> =
        (0..topology.twin.len() as u32).filter(|&h| topology.twin[h as usize] == NONE).map(|h| h / 3).collect();
    // At most three new entries per triangle, because a triangle adds its neighbours only when it is first reached.
    while let Some(triangle) = stack.pop() {
        if std::mem::replace(&mut reached[triangle as usize], true) {
            continue;
        }
        for h in 3 * triangle..3 * triangle + 3 {
            if topology.twin[h as usize] != NONE {
                stack.push(topology.twin[h as usize] / 3);
            }
        }
    }
    reached.contains(&false)
}

/// Marks the vertices of the constraints as fixed and their edges as locked. Fails if the mesh lacks any of them.
fn fix(film: &mut Film, pins: &Pins) -> Result<(), Error> {
    let mut known: Vec<([u64; 3], u32)> =
        film.vertices.iter().enumerate().map(|(v, &point)| (position_key(point), v as u32)).collect();
    known.sort_unstable();
    let vertex = |point: DVec3| {
        let key = position_key(point);
        known.get(known.partition_point(|&(bits, _)| bits < key)).filter(|&&(bits, _)| bits == key).map(|&(_, v)| v)
    };
    let missing = |detail: &str| Error::input(Place::field("constraints"), detail);
    let inner: Option<Vec<u32>> = pins.points.iter().map(|&point| vertex(point)).collect();
    let Some(inner) = inner else { return Err(missing("a fixed point is not a vertex of the initial mesh")) };
    let mut locked = Vec::with_capacity(pins.edges.len());
    for edge in &pins.edges {
        let [a, b] = edge.map(|pin| match pin {
            Pin::Boundary(k) => k,
            Pin::Inner(k) => inner[k as usize],
        });
        if !film.topology.are_adjacent(a, b) {
            return Err(missing("a fixed curve's segment is not an edge of the initial mesh"));
        }
        locked.push([a.min(b), a.max(b)]);
    }
    locked.sort_unstable();
    locked.dedup();
    film.locked = locked;
    inner.into_iter().for_each(|v| film.fixed[v as usize] = true);
    Ok(())
}

#[cfg(test)]
mod tests {
    use super::*;

    fn square() -> (Mesh, Vec<DVec3>) {
        let at = |x, y| DVec3::new(x, y, 0.0);
        let corners = vec![at(0.0, 0.0), at(1.0, 0.0), at(1.0, 1.0), at(0.0, 1.0)];
        // The centre comes first, and there is an additional vertex on the first side.
        let mut vertices = vec![at(0.5, 0.5), at(0.5, 0.0)];
        vertices.extend(&corners);
        let rim = [2u32, 1, 3, 4, 5];
        let triangles = (0..5).map(|k| [rim[k], rim[(k + 1) % 5], 0]).collect();
        (Mesh::new(vertices, triangles), corners)
    }

    #[test]
    fn the_boundary_is_found_in_either_direction_with_further_vertices_on_it() {
        let (mesh, corners) = square();
        for reversed in [false, true] {
            let mut polygon = corners.clone();
            if reversed {
                polygon.reverse();
            }
            let film = build(&mesh, std::slice::from_ref(&polygon), &Pins::default()).unwrap();
            assert_eq!(film.vertices[..4], polygon);
            assert_eq!(film.boundaries[0].len(), 5);
            let first = film.boundaries[0][0];
            assert_eq!(film.topology.to(film.topology.outgoing[first as usize]), film.boundaries[0][1]);
        }
    }

    #[test]
    fn what_is_wrong_is_named() {
        let (mesh, corners) = square();
        let place = |mesh: &Mesh, boundaries: &[Vec<DVec3>]| match build(mesh, boundaries, &Pins::default()) {
            Err(Error::Input(errors)) => format!("{}: {}", errors[0].place, errors[0].detail),
            other => panic!("{other:?}"),
        };
        let mut moved = corners.clone();
        moved[2].z = 0.1;
        assert!(place(&mesh, &[moved]).contains("points of boundary 0"));
        assert!(place(&mesh, &[corners.clone(), corners.clone()]).contains("1 boundary loops, there are 2"));
        let mut bad = mesh.clone();
        bad.triangles[3] = [4, 5, 99];
        assert!(place(&bad, std::slice::from_ref(&corners)).starts_with("/initial_mesh/triangles/3"));
        let mut bad = mesh.clone();
        bad.vertices[0].x = f64::NAN;
        assert!(place(&bad, std::slice::from_ref(&corners)).starts_with("/initial_mesh/vertices/0"));
        let mut bad = mesh.clone();
        bad.triangles.push([2, 1, 0]);
        assert!(place(&bad, std::slice::from_ref(&corners)).contains("manifold"));
        let mut bad = mesh;
        bad.vertices[0] = bad.vertices[1];
        assert!(place(&bad, &[corners]).contains("no area"));
    }
}
