//! A film whose sheets meet three by three along curves: its edges, its sheets, and what may move how.

use crate::error::InputError;
use crate::mesh::film::Film;
use crate::mesh::measure;
use crate::mesh::topology::Topology;
use crate::remesh::delaunay::{flip_to_delaunay, tangential_relaxation};
use crate::{DVec3, Error, Place};
use std::collections::BTreeMap;

/// How a vertex may move.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) enum Kind {
    /// On the boundary: not at all.
    Fixed,
    /// Inside a sheet: along its normal, while the area is minimised.
    Sheet,
    /// On a curve where three sheets meet, with its neighbours on the curve: across the curve.
    Junction([u32; 2]),
    /// Where such curves meet: anywhere.
    Point,
}

/// A film of triangles, at most three at an edge.
#[derive(Clone, Debug)]
pub(super) struct Sheets {
    pub vertices: Vec<DVec3>,
    /// Oriented alike within each sheet.
    pub triangles: Vec<[u32; 3]>,
    pub kinds: Vec<Kind>,
    /// Edges with three triangles, each smaller vertex first, sorted. They never change.
    pub junctions: Vec<[u32; 2]>,
    /// Edges with one triangle, in the direction of the triangle.
    pub boundary: Vec<[u32; 2]>,
    /// The triangles of each sheet, connected across edges of two triangles.
    pub sheets: Vec<Vec<usize>>,
}

/// Half-edges by undirected edge: (smaller, larger, triangle, corner), sorted.
fn edges(triangles: &[[u32; 3]]) -> Vec<(u32, u32, usize, usize)> {
    let mut edges: Vec<(u32, u32, usize, usize)> = triangles
        .iter()
        .enumerate()
        .flat_map(|(t, triangle)| {
            (0..3).map(move |k| {
                let (a, b) = (triangle[k], triangle[(k + 1) % 3]);
                (a.min(b), a.max(b), t, k)
            })
        })
        .collect();
    edges.sort_unstable();
    edges
}

/// Whether some edge has three triangles or more, so that the mesh is a film with junctions (or none at all).
pub(in super::super) fn has_junctions(triangles: &[[u32; 3]]) -> bool {
    edges(triangles).windows(3).any(|three| three.iter().all(|e| (e.0, e.1) == (three[0].0, three[0].1)))
}

impl Sheets {
    /// Reads a mesh.
    ///
    /// # Errors
    /// [`Error::Input`] under `initial_mesh`: an edge of four triangles, a sheet that cannot be oriented (a Möbius band), a
    /// vertex where sheets touch without a junction, a junction that ends inside the film, a vertex without a triangle.
    pub fn read(vertices: Vec<DVec3>, mut triangles: Vec<[u32; 3]>) -> Result<Self, Error> {
        let refused = |detail: String| Error::input(Place::field("initial_mesh"), detail);
        let refuse = |detail: String| Err(refused(detail));
        let count = vertices.len();
        let triangle_place = |t: usize| Place::field("initial_mesh").then("triangles").at(t);
        let mut errors = Vec::new();
        let mut seen = BTreeMap::new();
        for (t, triangle) in triangles.iter().enumerate() {
            let mut corners = *triangle;
            corners.sort_unstable();
            let first = *seen.entry(corners).or_insert(t);
            if first < t {
                errors.push(InputError::new(triangle_place(t), format!("has the same corners as triangle {first}")));
            }
            if triangle.iter().any(|&v| v as usize >= count) {
                errors.push(InputError::new(triangle_place(t), "names a vertex that does not exist"));
            } else if measure::is_degenerate(triangle.map(|v| vertices[v as usize])) {
                errors.push(InputError::new(triangle_place(t), "has no area"));
            }
        }
        for (v, _) in vertices.iter().enumerate().filter(|(_, vertex)| !vertex.is_finite()) {
            let place = Place::field("initial_mesh").then("vertices").at(v);
            errors.push(InputError::new(place, "every coordinate must be a finite number"));
        }
        if !errors.is_empty() {
            return Err(Error::Input(errors));
        }
        let all = edges(&triangles);
        let mut junctions = Vec::new();
        let mut neighbour: Vec<[Option<usize>; 3]> = vec![[None; 3]; triangles.len()];
        let mut on_boundary = vec![false; count];
        let mut along: Vec<Vec<u32>> = vec![Vec::new(); count];
        for group in all.chunk_by(|a, b| (a.0, a.1) == (b.0, b.1)) {
            let (a, b, t, k) = group[0];
            match group {
                [_] => [a, b].into_iter().for_each(|v| on_boundary[v as usize] = true),
                [_, (_, _, u, l)] => {
                    neighbour[t][k] = Some(3 * u + l);
                    neighbour[*u][*l] = Some(3 * t + k);
                }
                [_, _, _] => {
                    junctions.push([a, b]);
                    along[a as usize].push(b);
                    along[b as usize].push(a);
                }
                _ => {
                    return refuse(format!(
                        "{} triangles share the edge between the vertices {a} and {b}",
                        group.len()
                    ));
                }
            }
        }
        let sheets = orient(&mut triangles, &neighbour)
            .map_err(|t| refused(format!("the sheet of triangle {t} is one-sided and cannot be oriented")))?;
        let fans = fans(&triangles, &neighbour, count);
        let mut kinds = Vec::with_capacity(count);
        for v in 0..count {
            let kind = match (&along[v][..], on_boundary[v]) {
                (_, true) => Kind::Fixed,
                ([], false) => Kind::Sheet,
                (&[a, b], false) => Kind::Junction([a, b]),
                ([_], false) => return refuse(format!("a junction ends at vertex {v}, inside the film")),
                (_, false) => Kind::Point,
            };
            if fans[v] == 0 {
                return refuse(format!("vertex {v} belongs to no triangle"));
            }
            if kind == Kind::Sheet && fans[v] > 1 {
                return refuse(format!("sheets touch at vertex {v} without a junction"));
            }
            kinds.push(kind);
        }
        let boundary = (0..3 * triangles.len())
            .map(|h| [triangles[h / 3][h % 3], triangles[h / 3][(h % 3 + 1) % 3]])
            .filter(|&[a, b]| {
                let first = all.partition_point(|e| (e.0, e.1) < (a.min(b), a.max(b)));
                all.get(first + 1).is_none_or(|e| (e.0, e.1) != (a.min(b), a.max(b)))
            })
            .collect();
        let film = Self { vertices, triangles, kinds, junctions, boundary, sheets };
        film.check().map_err(refused)?;
        Ok(film)
    }

    pub fn area(&self) -> f64 {
        self.triangles.iter().map(|&t| 0.5 * measure::double_area_vector(self.corners(t)).length()).sum()
    }

    pub fn corners(&self, triangle: [u32; 3]) -> [DVec3; 3] {
        triangle.map(|v| self.vertices[v as usize])
    }

    /// One sheet as a film of its own, its rim (boundary and junctions) fixed; for each of its vertices the number here.
    pub fn sheet(&self, triangles: &[usize]) -> Option<(Film, Vec<u32>)> {
        let mut numbers: Vec<u32> = triangles.iter().flat_map(|&t| self.triangles[t]).collect();
        numbers.sort_unstable();
        numbers.dedup();
        let own = |v: u32| numbers.binary_search(&v).unwrap_or_default() as u32;
        let local: Vec<[u32; 3]> = triangles.iter().map(|&t| self.triangles[t].map(own)).collect();
        let vertices = numbers.iter().map(|&v| self.vertices[v as usize]).collect();
        let mut film = Film::new(vertices, &local, Vec::new())?;
        film.fixed = numbers.iter().map(|&v| self.kinds[v as usize] != Kind::Sheet).collect();
        Some((film, numbers))
    }

    /// Spreads the vertices within the sheets and along the junctions, and flips edges within the sheets to Delaunay's.
    /// Returns the number of flips. A sheet that touches itself along a junction is left as it is.
    pub fn remesh(&mut self, rounds: u32) -> u64 {
        for _ in 0..rounds {
            for v in 0..self.kinds.len() {
                if let Kind::Junction([a, b]) = self.kinds[v] {
                    let (a, b) = (self.vertices[a as usize], self.vertices[b as usize]);
                    let tangent = (b - a).normalize_or_zero();
                    let here = self.vertices[v];
                    self.vertices[v] += 0.5 * tangent * tangent.dot(0.5 * (a + b) - here);
                }
            }
        }
        let mut flips = 0;
        for k in 0..self.sheets.len() {
            let Some((mut film, numbers)) = self.sheet(&self.sheets[k]) else { continue };
            tangential_relaxation(&mut film, rounds);
            flips += flip_to_delaunay(&mut film);
            for (&place, &triangle) in self.sheets[k].iter().zip(film.triangles()) {
                self.triangles[place] = triangle.map(|v| numbers[v as usize]);
            }
            for (position, &v) in film.vertices.iter().zip(&numbers) {
                if self.kinds[v as usize] == Kind::Sheet {
                    self.vertices[v as usize] = *position;
                }
            }
        }
        flips
    }

    /// Triangles of a sheet that point against their neighbourhood.
    pub fn flipped_triangles(&self) -> usize {
        let sheets = self.sheets.iter().filter_map(|sheet| self.sheet(sheet));
        sheets.map(|(film, _)| measure::flipped_triangles(&film.mesh())).sum()
    }

    /// The curves along which three sheets meet, each from end to end; a closed one ends with its first vertex.
    pub fn curves(&self) -> Vec<Vec<u32>> {
        let mut next: Vec<Vec<u32>> = vec![Vec::new(); self.vertices.len()];
        for &[a, b] in &self.junctions {
            next[a as usize].push(b);
            next[b as usize].push(a);
        }
        let ends = (0..self.vertices.len() as u32).filter(|&v| !matches!(self.kinds[v as usize], Kind::Junction(_)));
        let starts: Vec<u32> = ends.chain(0..self.vertices.len() as u32).collect();
        let mut curves = Vec::new();
        for start in starts {
            while let Some(first) = next[start as usize].pop() {
                let mut curve = vec![start];
                let (mut before, mut here) = (start, first);
                loop {
                    next[here as usize].retain(|&v| v != before);
                    curve.push(here);
                    if here == start || !matches!(self.kinds[here as usize], Kind::Junction(_)) {
                        break;
                    }
                    let Some(after) = next[here as usize].pop() else { break };
                    (before, here) = (here, after);
                }
                curves.push(curve);
            }
        }
        curves
    }

    /// Lengths of all edges, each once.
    pub fn edge_lengths(&self) -> Vec<f64> {
        edges(&self.triangles)
            .chunk_by(|a, b| (a.0, a.1) == (b.0, b.1))
            .map(|group| self.vertices[group[0].0 as usize].distance(self.vertices[group[0].1 as usize]))
            .collect()
    }

    /// V - E + F.
    pub fn euler_characteristic(&self) -> i64 {
        let edge_count = edges(&self.triangles).chunk_by(|a, b| (a.0, a.1) == (b.0, b.1)).count();
        self.vertices.len() as i64 - edge_count as i64 + self.triangles.len() as i64
    }

    /// Parts that hang together, junctions included.
    pub fn components(&self) -> usize {
        let mut leader: Vec<u32> = (0..self.vertices.len() as u32).collect();
        fn find(leader: &mut [u32], v: u32) -> u32 {
            let mut root = v;
            while leader[root as usize] != root {
                root = leader[root as usize];
            }
            leader[v as usize] = root;
            root
        }
        for triangle in &self.triangles {
            for other in &triangle[1..] {
                let (a, b) = (find(&mut leader, triangle[0]), find(&mut leader, *other));
                leader[a.max(b) as usize] = a.min(b);
            }
        }
        (0..leader.len()).filter(|&v| leader[v] as usize == v).count()
    }

    /// Whether every sheet is an oriented manifold and the junctions are the edges they were.
    pub fn check(&self) -> Result<(), String> {
        for sheet in &self.sheets {
            let triangles: Vec<[u32; 3]> = sheet.iter().map(|&t| self.triangles[t]).collect();
            // A sheet may meet itself along a junction; its two rims are then one edge here, and only that is allowed.
            if let Err(defect) = Topology::build(&triangles, self.vertices.len())
                && self.sheets.len() > 1
            {
                return Err(format!("{defect:?}"));
            }
        }
        let now = edges(&self.triangles);
        let triple: Vec<[u32; 2]> = now
            .chunk_by(|a, b| (a.0, a.1) == (b.0, b.1))
            .filter(|group| group.len() == 3)
            .map(|group| [group[0].0, group[0].1])
            .collect();
        if triple == self.junctions { Ok(()) } else { Err(String::from("the junctions have changed")) }
    }
}

/// Turns triangles over until neighbours agree; the sheets, or a triangle that cannot be made to agree.
fn orient(triangles: &mut [[u32; 3]], neighbour: &[[Option<usize>; 3]]) -> Result<Vec<Vec<usize>>, usize> {
    let original = triangles.to_vec();
    let mut turned: Vec<Option<bool>> = vec![None; triangles.len()];
    let mut sheets = Vec::new();
    for start in 0..triangles.len() {
        if turned[start].is_some() {
            continue;
        }
        turned[start] = Some(false);
        let mut sheet = vec![start];
        let mut next = 0;
        while let Some(&t) = sheet.get(next) {
            next += 1;
            for k in 0..3 {
                let Some(other) = neighbour[t][k] else { continue };
                let (u, l) = (other / 3, other % 3);
                // Neighbours agree if they run along the edge in opposite directions.
                let alike = original[t][k] == original[u][l];
                let wanted = turned[t].map(|turned| turned != alike);
                match turned[u] {
                    None => {
                        turned[u] = wanted;
                        sheet.push(u);
                    }
                    agreed if agreed != wanted => return Err(u),
                    _ => {}
                }
            }
        }
        sheet.sort_unstable();
        sheets.push(sheet);
    }
    for (triangle, turned) in triangles.iter_mut().zip(turned) {
        if turned == Some(true) {
            triangle.swap(1, 2);
        }
    }
    Ok(sheets)
}

/// For each vertex the number of groups of triangles that hang together around it across edges of two.
fn fans(triangles: &[[u32; 3]], neighbour: &[[Option<usize>; 3]], count: usize) -> Vec<usize> {
    let mut around: Vec<Vec<usize>> = vec![Vec::new(); count];
    for (t, triangle) in triangles.iter().enumerate() {
        triangle.iter().for_each(|&v| around[v as usize].push(t));
    }
    (0..count)
        .map(|v| {
            let mut left = around[v].clone();
            let mut groups = 0;
            while let Some(t) = left.pop() {
                groups += 1;
                let mut stack = vec![t];
                while let Some(t) = stack.pop() {
                    for other in neighbour[t].iter().flatten() {
                        if let Some(place) = left.iter().position(|&u| u == other / 3) {
                            stack.push(left.swap_remove(place));
                        }
                    }
                }
            }
            groups
        })
        .collect()
}
