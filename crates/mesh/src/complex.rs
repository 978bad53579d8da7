//! Connectivity of triangles whose edges have one, two or more triangles. Finds the sheets, the curves where sheets end
//! or meet, and the points where such curves meet. This module does not use positions. If every edge of a mesh has at
//! most two triangles, the mesh is a manifold: see [`topology`](super::topology).

use crate::disjoint_sets::DisjointSets;
use std::collections::BTreeMap;
use std::fmt;

/// Sheets of triangles that may share edges.
#[derive(Clone, Debug)]
pub struct Complex {
    /// Corners of each triangle, oriented alike within each sheet.
    pub triangles: Vec<[u32; 3]>,
    /// The triangles of each sheet, in ascending order. Triangles belong to the same sheet if they are connected across
    /// edges of two triangles.
    pub sheets: Vec<Vec<u32>>,
    /// The kind of each vertex.
    pub kinds: Vec<VertexKind>,
    /// Every side of every triangle as (smaller end, larger end, 3 × triangle + corner), sorted. The sides of an edge
    /// are therefore next to each other.
    sides: Vec<(u32, u32, u32)>,
}

/// The position of a vertex in a complex.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum VertexKind {
    /// On the boundary: an edge of one triangle ends at the vertex.
    Boundary,
    /// Inside a sheet.
    Sheet,
    /// Inside a junction, which is a curve of edges of three or more triangles each. The array holds the two neighbours
    /// of the vertex on the junction.
    Junction([u32; 2]),
    /// A point where junctions meet.
    Point,
}

/// An edge with its triangles.
#[derive(Clone, Copy, Debug)]
pub struct Edge<'a> {
    /// The ends of the edge, the smaller number first.
    pub ends: [u32; 2],
    sides: &'a [(u32, u32, u32)],
}

impl Edge<'_> {
    /// Number of triangles that share the edge.
    #[must_use]
    #[inline]
    pub fn count(&self) -> usize {
        self.sides.len()
    }

    /// The triangles that share the edge.
    #[inline]
    pub fn triangles(&self) -> impl Iterator<Item = u32> {
        self.sides.iter().map(|&(_, _, side)| side / 3)
    }
}

/// Why triangles do not form a complex of sheets.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum ComplexDefect {
    /// A triangle names a vertex that does not exist.
    VertexOutOfRange {
        /// The triangle's number.
        triangle: usize,
    },
    /// A triangle names a vertex twice.
    RepeatedVertex {
        /// The triangle's number.
        triangle: usize,
    },
    /// Two triangles have the same corners.
    SameCorners {
        /// The triangle's number.
        triangle: usize,
        /// The number of the first triangle with these corners.
        first: usize,
    },
    /// The sheet of a triangle cannot be oriented.
    OneSided {
        /// The triangle's number.
        triangle: usize,
    },
    /// Sheets touch at a vertex where no junction ends or passes.
    TouchingSheets {
        /// The vertex's number.
        vertex: u32,
    },
    /// A junction ends at a vertex inside the complex.
    LooseJunction {
        /// The vertex's number.
        vertex: u32,
    },
    /// A vertex belongs to no triangle.
    IsolatedVertex {
        /// The vertex's number.
        vertex: u32,
    },
}

impl fmt::Display for ComplexDefect {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            Self::VertexOutOfRange { triangle } => write!(f, "triangle {triangle} names a vertex that does not exist"),
            Self::RepeatedVertex { triangle } => write!(f, "triangle {triangle} names a vertex twice"),
            Self::SameCorners { triangle, first } => {
                write!(f, "triangle {triangle} has the same corners as triangle {first}")
            }
            Self::OneSided { triangle } => {
                write!(f, "the sheet of triangle {triangle} is one-sided and cannot be oriented")
            }
            Self::TouchingSheets { vertex } => write!(f, "sheets touch at vertex {vertex} without a junction"),
            Self::LooseJunction { vertex } => write!(f, "a junction ends at vertex {vertex}, inside the film"),
            Self::IsolatedVertex { vertex } => write!(f, "vertex {vertex} belongs to no triangle"),
        }
    }
}

impl std::error::Error for ComplexDefect {}

/// The sides of all triangles, each as the ends of its edge and the number of its half-edge, sorted.
fn sides(triangles: &[[u32; 3]]) -> Vec<(u32, u32, u32)> {
    let side = |t: usize, k: usize| {
        let (a, b) = (triangles[t][k], triangles[t][(k + 1) % 3]);
        (a.min(b), a.max(b), (3 * t + k) as u32)
    };
    let mut sides: Vec<_> = (0..triangles.len()).flat_map(|t| (0..3).map(move |k| side(t, k))).collect();
    sides.sort_unstable();
    sides
}

/// Whether some edge has three or more triangles.
#[must_use]
#[inline]
pub fn has_junctions(triangles: &[[u32; 3]]) -> bool {
    sides(triangles).windows(3).any(|three| three.iter().all(|side| (side.0, side.1) == (three[0].0, three[0].1)))
}

impl Complex {
    /// Finds the sheets, and reverses triangles until all triangles of a sheet have the same orientation. O(n log n).
    ///
    /// # Errors
    /// The first [`ComplexDefect`].
    pub fn build(mut triangles: Vec<[u32; 3]>, vertex_count: usize) -> Result<Self, ComplexDefect> {
        let mut seen = BTreeMap::new();
        for (triangle, &[a, b, c]) in triangles.iter().enumerate() {
            if [a, b, c].iter().any(|&v| v as usize >= vertex_count) {
                return Err(ComplexDefect::VertexOutOfRange { triangle });
            }
            if a == b || b == c || c == a {
                return Err(ComplexDefect::RepeatedVertex { triangle });
            }
            let mut corners = [a, b, c];
            corners.sort_unstable();
            let first = *seen.entry(corners).or_insert(triangle);
            if first < triangle {
                return Err(ComplexDefect::SameCorners { triangle, first });
            }
        }
        let sides = sides(&triangles);
        // For each side, the other side of the same edge if the edge has two triangles.
        let mut twin: Vec<Option<u32>> = vec![None; 3 * triangles.len()];
        let mut on_boundary = vec![false; vertex_count];
        let mut along: Vec<Vec<u32>> = vec![Vec::new(); vertex_count];
        for group in sides.chunk_by(|a, b| (a.0, a.1) == (b.0, b.1)) {
            let (a, b, side) = group[0];
            match group {
                [_] => [a, b].into_iter().for_each(|v| on_boundary[v as usize] = true),
                &[_, (_, _, other)] => {
                    twin[side as usize] = Some(other);
                    twin[other as usize] = Some(side);
                }
                _ => {
                    along[a as usize].push(b);
                    along[b as usize].push(a);
                }
            }
        }
        let sheets = orient(&mut triangles, &twin)?;
        let fans = fans(&triangles, &twin, vertex_count);
        let mut kinds = Vec::with_capacity(vertex_count);
        for (v, along) in along.iter().enumerate() {
            let vertex = v as u32;
            let kind = match (&along[..], on_boundary[v]) {
                (_, true) => VertexKind::Boundary,
                ([], false) => VertexKind::Sheet,
                (&[a, b], false) => VertexKind::Junction([a, b]),
                ([_], false) => return Err(ComplexDefect::LooseJunction { vertex }),
                (_, false) => VertexKind::Point,
            };
            if fans[v] == 0 {
                return Err(ComplexDefect::IsolatedVertex { vertex });
            }
            if kind == VertexKind::Sheet && fans[v] > 1 {
                return Err(ComplexDefect::TouchingSheets { vertex });
            }
            kinds.push(kind);
        }
        // The sides are collected again, because reversing a triangle renumbers its corners.
        let sides = self::sides(&triangles);
        Ok(Self { triangles, sheets, kinds, sides })
    }

    /// Every edge once, sorted by its ends.
    #[inline]
    pub fn edges(&self) -> impl Iterator<Item = Edge<'_>> {
        self.sides.chunk_by(|a, b| (a.0, a.1) == (b.0, b.1)).map(|sides| Edge { ends: [sides[0].0, sides[0].1], sides })
    }

    /// The junction edges, which have three or more triangles each, sorted.
    #[must_use]
    #[inline]
    pub fn junctions(&self) -> Vec<[u32; 2]> {
        self.edges().filter(|edge| edge.count() > 2).map(|edge| edge.ends).collect()
    }

    /// The junctions, along which sheets meet, as curves from end to end. A closed curve ends with its first vertex.
    #[must_use]
    pub fn curves(&self) -> Vec<Vec<u32>> {
        let inside = |v: u32| matches!(self.kinds[v as usize], VertexKind::Junction(_));
        let mut next: Vec<Vec<u32>> = vec![Vec::new(); self.kinds.len()];
        for [a, b] in self.junctions() {
            next[a as usize].push(b);
            next[b as usize].push(a);
        }
        let all = 0..self.kinds.len() as u32;
        let starts: Vec<u32> = all.clone().filter(|&v| !inside(v)).chain(all).collect();
        let mut curves = Vec::new();
        for start in starts {
            // At most one pass per junction edge at the vertex, because each pass takes one out of the list.
            while let Some(first) = next[start as usize].pop() {
                let mut curve = vec![start];
                let (mut before, mut here) = (start, first);
                // Ends because each pass takes an edge out of a list and adds none.
                loop {
                    next[here as usize].retain(|&v| v != before);
                    curve.push(here);
                    if here == start || !inside(here) {
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

    /// The Euler characteristic V - E + F.
    #[must_use]
    #[inline]
    pub fn euler_characteristic(&self) -> i64 {
        self.kinds.len() as i64 - self.edges().count() as i64 + self.triangles.len() as i64
    }

    /// Number of connected components. Sheets that meet at a junction belong to the same component.
    #[must_use]
    pub fn components(&self) -> usize {
        let mut sets = DisjointSets::new(self.kinds.len());
        for &[a, b, c] in &self.triangles {
            sets.join(a, b);
            sets.join(a, c);
        }
        sets.count()
    }
}

/// Reverses triangles until all triangles of a sheet have the same orientation, and returns the sheets.
fn orient(triangles: &mut [[u32; 3]], twin: &[Option<u32>]) -> Result<Vec<Vec<u32>>, ComplexDefect> {
    let original = triangles.to_vec();
    let mut turned: Vec<Option<bool>> = vec![None; triangles.len()];
    let mut sheets = Vec::new();
    for start in 0..triangles.len() {
        if turned[start].is_some() {
            continue;
        }
        turned[start] = Some(false);
        let mut sheet = vec![start as u32];
        let mut next = 0;
        // At most one pass per triangle, because a triangle is added only when its turn is decided, which happens once.
        while let Some(&t) = sheet.get(next) {
            let t = t as usize;
            next += 1;
            for k in 0..3 {
                let Some(other) = twin[3 * t + k] else { continue };
                let (u, l) = (other as usize / 3, other as usize % 3);
                // Neighbours have the same orientation if they run along the edge in opposite directions.
                let alike = original[t][k] == original[u][l];
                let wanted = turned[t].map(|turned| turned != alike);
                match turned[u] {
                    None => {
                        turned[u] = wanted;
                        sheet.push(u as u32);
                    }
                    agreed if agreed != wanted => return Err(ComplexDefect::OneSided { triangle: u }),
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

/// For each vertex, the number of its fans: groups of triangles around it that are connected across edges of two
/// triangles.
fn fans(triangles: &[[u32; 3]], twin: &[Option<u32>], vertex_count: usize) -> Vec<usize> {
    // The members of the sets are the corners of all triangles. Two triangles that share an edge share a corner at each
    // of its ends.
    let mut groups = DisjointSets::new(3 * triangles.len());
    for (side, other) in twin.iter().enumerate() {
        let Some(other) = other else { continue };
        let (t, u) = (side / 3, *other as usize / 3);
        for (k, v) in triangles[t].iter().enumerate() {
            if let Some(l) = triangles[u].iter().position(|w| w == v) {
                groups.join((3 * t + k) as u32, (3 * u + l) as u32);
            }
        }
    }
    let mut fans = vec![0; vertex_count];
    for (corner, &v) in triangles.iter().flatten().enumerate() {
        fans[v as usize] += usize::from(groups.leader(corner as u32) == corner as u32);
    }
    fans
}

#[cfg(test)]
mod tests {
    use super::*;

    /// Three half-discs that meet along the junction 0-1-2 between the poles 0 and 2. Each consists of two triangles.
    fn three_sheets() -> Vec<[u32; 3]> {
        (3..6).flat_map(|rim| [[0, 1, rim], [1, 2, rim]]).collect()
    }

    #[test]
    fn sheets_curves_and_places_of_three_sheets_on_a_junction() {
        let mut triangles = three_sheets();
        triangles[3].swap(0, 1);
        let complex = Complex::build(triangles, 6).unwrap();
        assert_eq!(complex.sheets, [[0, 1], [2, 3], [4, 5]]);
        assert_eq!(complex.triangles[3], [2, 4, 1], "the triangle that was turned is turned back");
        assert_eq!(complex.junctions(), [[0, 1], [1, 2]]);
        assert_eq!(complex.curves(), [[0, 1, 2]]);
        assert_eq!(complex.kinds[1], VertexKind::Junction([0, 2]));
        assert!([0, 2, 3, 4, 5].iter().all(|&v| complex.kinds[v] == VertexKind::Boundary));
        assert_eq!((complex.euler_characteristic(), complex.components()), (1, 1));
        let counts: Vec<usize> = complex.edges().map(|edge| edge.count()).collect();
        assert_eq!(counts.iter().sum::<usize>(), 18);
        assert_eq!(
            complex.edges().find(|edge| edge.ends == [0, 1]).unwrap().triangles().collect::<Vec<_>>(),
            [0, 2, 4]
        );
    }

    #[test]
    fn every_defect_is_named() {
        let build = |triangles: &[[u32; 3]], count| Complex::build(triangles.to_vec(), count).unwrap_err();
        assert_eq!(build(&[[0, 1, 9]], 3), ComplexDefect::VertexOutOfRange { triangle: 0 });
        assert_eq!(build(&[[0, 1, 1]], 3), ComplexDefect::RepeatedVertex { triangle: 0 });
        assert_eq!(build(&[[0, 1, 2], [1, 2, 0]], 3), ComplexDefect::SameCorners { triangle: 1, first: 0 });
        assert_eq!(build(&[[0, 1, 2]], 4), ComplexDefect::IsolatedVertex { vertex: 3 });
        // A Möbius band of five triangles.
        let band: Vec<[u32; 3]> = (0..5).map(|k| [k, (k + 1) % 5, (k + 2) % 5]).collect();
        assert!(matches!(build(&band, 5), ComplexDefect::OneSided { .. }));
        // Two tetrahedra without a common edge that share the vertex 0.
        let tetrahedron = |[a, b, c, d]: [u32; 4]| [[a, c, b], [a, b, d], [b, c, d], [c, a, d]];
        let two = [tetrahedron([0, 1, 2, 3]), tetrahedron([0, 4, 5, 6])].concat();
        assert_eq!(build(&two, 7), ComplexDefect::TouchingSheets { vertex: 0 });
        // Two tetrahedra that share the edge 0-1 alone: four triangles there, and no further junction at its ends.
        let two = [tetrahedron([0, 1, 2, 3]), tetrahedron([0, 1, 4, 5])].concat();
        assert_eq!(build(&two, 6), ComplexDefect::LooseJunction { vertex: 0 });
    }
}
