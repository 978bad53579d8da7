//! Sparsity patterns of operators on the vertices of a mesh: the entries of a matrix and their positions.
//!
//! [`Pattern`] has one unknown per free vertex and knows the positions of the six off-diagonal entries of every
//! triangle. It serves harmonic maps, and films whose vertices move along their normals. [`BlockPattern`] has any
//! number of unknowns per vertex and elements of any number of vertices.

use super::SymmetricMatrix;
use std::ops::Range;

/// Marks a fixed vertex, which has no unknown.
pub const FIXED: u32 = u32::MAX;

/// Largest number of neighbours of a vertex for which a neighbour is found by counting the smaller numbers. Among more
/// neighbours it is found by bisection.
const FEW_NEIGHBOURS: usize = 16;

/// The sparsity pattern of operators with one unknown per free vertex of a mesh, and the positions of the entries of
/// each triangle.
#[derive(Clone, Debug)]
pub struct Pattern {
    pub free: FreeVertices,
    pub row_start: Vec<u32>,
    columns: Vec<u32>,
    /// For each triangle, the positions in `columns` of the entries (0,1), (1,2), (2,0), then of (1,0), (2,1), (0,2),
    /// by the corners of the triangle. [`FIXED`] if a vertex of the pair is fixed.
    pub slots: Vec<[u32; 6]>,
}

/// The free vertices and their numbers as unknowns.
#[derive(Clone, Debug)]
pub struct FreeVertices {
    /// For each vertex, the number of its unknown, or [`FIXED`].
    pub unknown: Vec<u32>,
    /// For each unknown, its vertex.
    pub vertex: Vec<u32>,
}

impl FreeVertices {
    #[inline]
    pub fn new(fixed: &[bool]) -> Self {
        let mut unknown = vec![FIXED; fixed.len()];
        let mut vertex = Vec::new();
        for (v, _) in fixed.iter().enumerate().filter(|(_, fixed)| !**fixed) {
            unknown[v] = vertex.len() as u32;
            vertex.push(v as u32);
        }
        Self { unknown, vertex }
    }
}

impl Pattern {
    /// Finds the pattern of a connectivity. O(triangles). Every vertex that is not fixed must be an interior vertex of
    /// a manifold.
    pub fn new(triangles: &[[u32; 3]], fixed: &[bool]) -> Self {
        let free = FreeVertices::new(fixed);
        let FreeVertices { unknown, vertex } = &free;
        // Each half-edge between two free vertices is one entry off the diagonal. Around an interior vertex every
        // neighbour is reached by exactly one outgoing half-edge.
        let mut row_start = vec![0u32; vertex.len() + 1];
        for row in 0..vertex.len() {
            row_start[row + 1] = 1;
        }
        for triangle in triangles {
            let rows = triangle.map(|v| unknown[v as usize]);
            for k in 0..3 {
                if rows[k] != FIXED && rows[(k + 1) % 3] != FIXED {
                    row_start[rows[k] as usize + 1] += 1;
                }
            }
        }
        for row in 0..vertex.len() {
            row_start[row + 1] += row_start[row];
        }
        let mut columns = vec![0u32; row_start[vertex.len()] as usize];
        let mut cursor: Vec<u32> = row_start[..vertex.len()].to_vec();
        for row in 0..vertex.len() {
            columns[cursor[row] as usize] = row as u32;
            cursor[row] += 1;
        }
        let mut slots = vec![[FIXED; 6]; triangles.len()];
        for (triangle, slots) in triangles.iter().zip(&mut slots) {
            let rows = triangle.map(|v| unknown[v as usize]);
            for k in 0..3 {
                let (from, to) = (rows[k], rows[(k + 1) % 3]);
                if from != FIXED && to != FIXED {
                    let slot = &mut cursor[from as usize];
                    columns[*slot as usize] = to;
                    slots[k] = *slot;
                    *slot += 1;
                }
            }
        }
        for (triangle, slots) in triangles.iter().zip(&mut slots) {
            let rows = triangle.map(|v| unknown[v as usize]);
            for k in 0..3 {
                if slots[k] != FIXED {
                    let (from, to) = (rows[k], rows[(k + 1) % 3] as usize);
                    let range = row_start[to] as usize..row_start[to + 1] as usize;
                    let offset = columns[range.clone()].iter().position(|&column| column == from);
                    slots[3 + k] = (range.start + offset.expect("both half-edges of an inner edge are present")) as u32;
                }
            }
        }
        Self { free, row_start, columns, slots }
    }

    /// Does the same as [`new`](Self::new), but allows free vertices on a boundary and on junctions, where edges belong
    /// to one or to more than two triangles.
    #[inline]
    pub fn of_complex(triangles: &[[u32; 3]], fixed: &[bool]) -> Self {
        let free = FreeVertices::new(fixed);
        let counts: Vec<u8> = fixed.iter().map(|&fixed| u8::from(!fixed)).collect();
        let blocks = BlockPattern::new(&counts, |couple| triangles.iter().for_each(|triangle| couple(triangle)));
        let slot = |v: u32, w: u32| blocks.position(v, w).map_or(FIXED, |position| position.at(0, 0) as u32);
        let six = |&[a, b, c]: &[u32; 3]| [slot(a, b), slot(b, c), slot(c, a), slot(b, a), slot(c, b), slot(a, c)];
        let slots = triangles.iter().map(six).collect();
        let SymmetricMatrix { row_start, columns, .. } = blocks.matrix();
        Self { free, row_start, columns, slots }
    }

    /// A zero matrix of this pattern.
    #[inline]
    pub fn matrix(&self) -> SymmetricMatrix {
        SymmetricMatrix {
            row_start: self.row_start.clone(),
            columns: self.columns.clone(),
            values: vec![0.0; self.columns.len()],
        }
    }
}

/// The sparsity pattern of an operator with any number of unknowns per vertex. Two vertices are coupled if they share
/// an element.
#[derive(Clone, Debug)]
pub struct BlockPattern {
    /// Vertex v owns the unknowns `start[v]..start[v + 1]`.
    start: Vec<u32>,
    /// For each unknown, the position where its row begins.
    row_start: Vec<u32>,
    /// The neighbours of vertex v that have unknowns are `neighbour[first[v]..first[v + 1]]`, ascending. The second
    /// number of a neighbour is the number of columns before its own columns in each row of v.
    first: Vec<u32>,
    neighbour: Vec<(u32, u32)>,
}

/// The position of the block of two vertices in a matrix.
#[derive(Clone, Copy, Debug)]
pub struct BlockPosition {
    /// The position where the rows of the first vertex begin, and the number of entries of each row.
    row: u32,
    length: u32,
    /// Number of columns before the block. `None` for the block of a vertex with itself, where the diagonal entry comes
    /// first in each row.
    before: Option<u32>,
}

impl BlockPosition {
    /// The position of the entry for unknown i of the first vertex and unknown j of the second.
    #[inline]
    pub fn at(self, i: usize, j: usize) -> usize {
        let row = self.row as usize + i * self.length as usize;
        match self.before {
            Some(before) => row + before as usize + j,
            None if i == j => row,
            None => row + j + usize::from(j < i),
        }
    }
}

impl BlockPattern {
    /// Finds the pattern. `counts` holds the number of unknowns of each vertex. `elements` must call its argument with
    /// the vertices of each element.
    pub fn new(counts: &[u8], elements: impl FnOnce(&mut dyn FnMut(&[u32]))) -> Self {
        let mut start = vec![0u32; counts.len() + 1];
        for (v, &count) in counts.iter().enumerate() {
            start[v + 1] = start[v] + u32::from(count);
        }
        let mut pairs: Vec<[u32; 2]> = Vec::new();
        elements(&mut |element| {
            for &v in element {
                for &w in element {
                    if v != w && counts[v as usize] > 0 && counts[w as usize] > 0 {
                        pairs.push([v, w]);
                    }
                }
            }
        });
        // The pairs are grouped by their first vertex: the second vertices of the pairs of v are `ends[at[v]..at[v +
        // 1]]`. Sorting these short lists takes a fraction of the time of sorting all pairs at once.
        let mut at = vec![0usize; counts.len() + 1];
        pairs.iter().for_each(|&[v, _]| at[v as usize + 1] += 1);
        for v in 0..counts.len() {
            at[v + 1] += at[v];
        }
        let (mut ends, mut next) = (vec![0u32; pairs.len()], at.clone());
        for &[v, w] in &pairs {
            ends[next[v as usize]] = w;
            next[v as usize] += 1;
        }
        let (mut first, mut row_start) = (vec![0u32], vec![0u32]);
        let mut neighbour: Vec<(u32, u32)> = Vec::new();
        for (v, &count) in counts.iter().enumerate() {
            let own = &mut ends[at[v]..at[v + 1]];
            own.sort_unstable();
            let mut before = u32::from(count);
            for own in own.chunk_by(|a, b| a == b) {
                let to = own[0];
                neighbour.push((to, before));
                before += u32::from(counts[to as usize]);
            }
            first.push(neighbour.len() as u32);
            for _ in 0..count {
                row_start.push(row_start[row_start.len() - 1] + before);
            }
        }
        Self { start, row_start, first, neighbour }
    }

    /// The unknowns of a vertex.
    #[inline]
    pub fn unknowns(&self, v: u32) -> Range<usize> {
        self.start[v as usize] as usize..self.start[v as usize + 1] as usize
    }

    /// Number of unknowns.
    #[inline]
    pub fn order(&self) -> usize {
        self.row_start.len() - 1
    }

    /// A zero matrix of this pattern, the diagonal first in each row.
    pub fn matrix(&self) -> SymmetricMatrix {
        let mut columns = Vec::with_capacity(self.row_start[self.order()] as usize);
        for v in 0..self.start.len() as u32 - 1 {
            let own = self.unknowns(v);
            for row in own.clone() {
                columns.push(row as u32);
                columns.extend(own.clone().filter(|&column| column != row).map(|column| column as u32));
                for &(other, _) in &self.neighbour[self.first[v as usize] as usize..self.first[v as usize + 1] as usize]
                {
                    columns.extend(self.unknowns(other).map(|column| column as u32));
                }
            }
        }
        let values = vec![0.0; columns.len()];
        SymmetricMatrix { row_start: self.row_start.clone(), columns, values }
    }

    /// The position of the block of two vertices. `None` if one of them has no unknown, or if they share no element.
    #[inline]
    pub fn position(&self, v: u32, w: u32) -> Option<BlockPosition> {
        let own = self.unknowns(v);
        if own.is_empty() {
            return None;
        }
        let row = self.row_start[own.start];
        let length = self.row_start[own.start + 1] - row;
        if v == w {
            return Some(BlockPosition { row, length, before: None });
        }
        let neighbours = &self.neighbour[self.first[v as usize] as usize..self.first[v as usize + 1] as usize];
        // Counting takes no branch that depends on the neighbours, whereas a binary search takes one at every halving.
        // Such branches are rarely predicted correctly, because the neighbours differ from vertex to vertex.
        let at = if neighbours.len() <= FEW_NEIGHBOURS {
            neighbours.iter().map(|&(other, _)| usize::from(other < w)).sum()
        } else {
            neighbours.partition_point(|&(other, _)| other < w)
        };
        let &(other, before) = neighbours.get(at)?;
        (other == w).then_some(BlockPosition { row, length, before: Some(before) })
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::random::SplitMix64;
    use std::collections::BTreeSet;

    #[test]
    fn blocks_stand_where_the_columns_of_their_unknowns_do() {
        let mut random = SplitMix64::new(3);
        // Vertex 0 is the middle of a fan. It has more than `FEW_NEIGHBOURS` neighbours, so that bisection is tested
        // too.
        let counts: Vec<u8> = (0..60).map(|v| if v == 0 { 3 } else { random.below(4) as u8 }).collect();
        let mut elements: Vec<[u32; 3]> = (1..59).map(|k| [0, k, k + 1]).collect();
        elements.extend((0..30).map(|_| [0; 3].map(|_: u32| random.below(60) as u32)));
        let pattern = BlockPattern::new(&counts, |visit| elements.iter().for_each(|element| visit(element)));
        let coupled: BTreeSet<[u32; 2]> =
            elements.iter().flat_map(|e| e.iter().flat_map(|&v| e.iter().map(move |&w| [v, w]))).collect();
        let matrix = pattern.matrix();
        let (mut blocks, mut entries) = (0, BTreeSet::new());
        for v in 0..60 {
            for w in 0..60 {
                let has_block =
                    counts[v as usize] > 0 && counts[w as usize] > 0 && (v == w || coupled.contains(&[v, w]));
                let position = pattern.position(v, w);
                assert_eq!(position.is_some(), has_block, "{v} {w}");
                let Some(position) = position else { continue };
                blocks += 1;
                for (i, row) in pattern.unknowns(v).enumerate() {
                    for (j, column) in pattern.unknowns(w).enumerate() {
                        let at = position.at(i, j);
                        assert_eq!(matrix.columns[at] as usize, column, "{v} {w} {i} {j}");
                        let range = matrix.row_start[row] as usize..matrix.row_start[row + 1] as usize;
                        assert!(range.contains(&at) && entries.insert(at));
                    }
                }
            }
        }
        assert!(blocks > 200 && entries.len() == matrix.columns.len(), "{blocks}");
        assert!(matrix.has_pattern_of(&matrix.clone()) && !matrix.has_pattern_of(&SymmetricMatrix::default()));
    }
}
