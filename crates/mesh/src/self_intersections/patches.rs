//! Patches of a surface. A patch is a connected piece of a few triangles, with its box, the cone of its normals, and
//! the patches on the other side of each of its edges.
//!
//! Most steps of the search for charts treat patches in place of triangles. Only the first step reads the triangles, in
//! one pass.

use super::boxes::{Order, sorted_along_curve};
use super::soup::{LOOK, NONE, clear_normal};
use crate::axis_box::AxisBox;
use crate::measure::power_of_two_above;
use crate::{DVec3, Execution, Interruption};
use std::ops::Range;

/// The blocks of triangles count as compact if the sum of the blocks' squared box diagonals is at most this multiple of
/// the sum of the triangles' squared box diagonals. The two sums are equal if the triangles of each block subdivide a
/// larger triangle of the same shape.
const COMPACT: f64 = 2.5;

/// Connected triangles that are stored one after the other in [`Patches::order`].
pub(super) struct Patch {
    /// The box of its triangles.
    pub extent: AxisBox,
    /// Unit vector along the sum of the triangles' area vectors.
    pub axis: DVec3,
    /// Largest angle between the axis and a normal in radians; infinite if a triangle has no certain normal.
    pub spread: f64,
    /// Where its triangles start in [`Patches::order`].
    first: u32,
    /// Where its edges start in [`Patches::edges`].
    first_edge: u32,
}

/// The patches of a mesh.
pub(super) struct Patches<'a> {
    mesh: Scaled<'a>,
    /// The patches in the order of their triangles and edges.
    pub list: Vec<Patch>,
    /// The numbers of the triangles, patch by patch.
    order: Vec<u32>,
    /// The ends of the half-edges whose opposite half-edge is missing or lies in another patch.
    pub edges: Vec<[u32; 2]>,
    /// For each of `edges` the number of its patch.
    pub owners: Vec<u32>,
    /// For each of `edges`, the patch of the half-edge on the other side. [`NONE`] unless exactly two half-edges lie
    /// along the edge.
    pub across: Vec<u32>,
}

/// A mesh with the power of two that scales its largest coordinate to about 1.
struct Scaled<'a> {
    vertices: &'a [DVec3],
    triangles: &'a [[u32; 3]],
    scale: f64,
}

impl Scaled<'_> {
    fn corners(&self, t: u32) -> [DVec3; 3] {
        self.triangles[t as usize].map(|v| self.vertices[v as usize] * self.scale)
    }
}

impl<'a> Patches<'a> {
    /// Divides a mesh into patches of at most `size` triangles. `size` must be at most 64.
    pub fn new(
        vertices: &'a [DVec3],
        triangles: &'a [[u32; 3]],
        order: Order,
        size: usize,
        exec: &Execution<'_>,
    ) -> Result<Self, Interruption> {
        let (low, high) =
            vertices.iter().fold((DVec3::INFINITY, DVec3::NEG_INFINITY), |(low, high), &v| (low.min(v), high.max(v)));
        let scale = power_of_two_above(low.abs().max(high.abs()).max_element()).recip();
        exec.look(vertices.len() as u64)?;
        let mesh = Scaled { vertices, triangles, scale };
        let whole = AxisBox { low: low * scale, high: high * scale };
        let order_given = (0..triangles.len() as u32).collect();
        let mut patches = Self {
            mesh,
            list: Vec::new(),
            order: order_given,
            edges: Vec::new(),
            owners: Vec::new(),
            across: Vec::new(),
        };
        // The given order is tried first, because triangles made by subdividing larger ones already form compact
        // blocks.
        if !patches.add_all(size, order == Order::Spatial, exec)? {
            patches.list.clear();
            patches.edges.clear();
            patches.owners.clear();
            patches.order = sorted_along_curve(|t| patches.mesh.corners(t), &patches.order, &whole, exec)?;
            patches.add_all(size, false, exec)?;
        }
        patches.find_neighbours(exec)?;
        Ok(patches)
    }

    /// The triangles of a patch.
    pub fn triangles(&self, patch: usize) -> &[u32] {
        let end = self.list.get(patch + 1).map_or(self.order.len(), |next| next.first as usize);
        &self.order[self.list[patch].first as usize..end]
    }

    /// The numbers of a patch's edges.
    pub fn edges_of(&self, patch: u32) -> Range<usize> {
        let end = self.list.get(patch as usize + 1).map_or(self.edges.len(), |next| next.first_edge as usize);
        self.list[patch as usize].first_edge as usize..end
    }

    /// The corners of a triangle, scaled.
    pub fn corners(&self, t: u32) -> [DVec3; 3] {
        self.mesh.corners(t)
    }

    /// The scaled position of a vertex.
    pub fn point(&self, vertex: u32) -> DVec3 {
        self.mesh.vertices[vertex as usize] * self.mesh.scale
    }

    /// Number of edges that bound one triangle, or more than two.
    pub fn bare_edges(&self) -> usize {
        self.across.iter().filter(|&&across| across == NONE).count()
    }

    /// Divides all triangles into patches, block by block. Returns false if the blocks must be compact and are not.
    fn add_all(&mut self, size: usize, must_be_compact: bool, exec: &Execution<'_>) -> Result<bool, Interruption> {
        let mut block = Block::default();
        let (mut of_blocks, mut of_triangles) = (0.0, 0.0);
        self.list.reserve(self.order.len() / size + 1);
        for start in (0..self.order.len()).step_by(size) {
            let end = (start + size).min(self.order.len());
            block.read(&self.mesh, &self.order[start..end]);
            of_blocks += block.extent().size_squared();
            of_triangles += block.triangles.iter().map(|triangle| triangle.extent.size_squared()).sum::<f64>();
            if block.pairing.pieces > 1 {
                self.order[start..end].copy_from_slice(&block.by_piece());
            }
            let mut first = start;
            for piece in 0..block.pairing.pieces {
                let number = self.list.len() as u32;
                let first_edge = self.edges.len();
                self.edges.extend(block.edges_of(piece));
                self.owners.resize(self.edges.len(), number);
                let (patch, count) = block.patch(piece);
                self.list.push(Patch { first: first as u32, first_edge: first_edge as u32, ..patch });
                first += count;
            }
            if end / LOOK > start / LOOK || end == self.order.len() {
                exec.look(LOOK as u64)?;
                if must_be_compact && of_blocks > COMPACT * of_triangles {
                    return Ok(false);
                }
            }
        }
        Ok(true)
    }

    /// Fills in `across`.
    fn find_neighbours(&mut self, exec: &Execution<'_>) -> Result<(), Interruption> {
        // Each edge is listed at its end with the lower number. The number of the other end is the sorting key.
        let mut start = vec![0u32; self.mesh.vertices.len() + 1];
        for chunk in self.edges.chunks(LOOK) {
            chunk.iter().for_each(|[a, b]| start[*a.min(b) as usize + 1] += 1);
            exec.look(chunk.len() as u64)?;
        }
        let mut sum = 0;
        for slot in &mut start {
            sum += *slot;
            *slot = sum;
        }
        let mut around = vec![0u64; self.edges.len()];
        for (e, [a, b]) in self.edges.iter().enumerate() {
            // The slots of a vertex are filled from the last to the first.
            let slot = &mut start[*a.min(b) as usize + 1];
            *slot -= 1;
            around[*slot as usize] = u64::from(*a.max(b)) << 32 | e as u64;
            if e % LOOK == LOOK - 1 {
                exec.look(LOOK as u64)?;
            }
        }
        // Entry v + 1 now holds the first slot of vertex v.
        start.remove(0);
        start.push(around.len() as u32);
        self.across = vec![NONE; self.edges.len()];
        let mut work = 0;
        for range in start.windows(2) {
            let around = &mut around[range[0] as usize..range[1] as usize];
            around.sort_unstable();
            for same in around.chunk_by(|a, b| a >> 32 == b >> 32) {
                if let [one, other] = *same {
                    let [one, other] = [one as u32 as usize, other as u32 as usize];
                    if self.edges[one][0] == self.edges[other][1] {
                        self.across[one] = self.owners[other];
                        self.across[other] = self.owners[one];
                    }
                }
            }
            work += 1 + around.len();
            if work >= LOOK {
                exec.look(work as u64)?;
                work = 0;
            }
        }
        Ok(())
    }
}

/// A triangle of a block.
struct BlockTriangle {
    number: u32,
    extent: AxisBox,
    /// Twice the area vector. Zero if rounding makes it uncertain.
    normal: DVec3,
}

/// Consecutive triangles of the order, which are divided into connected pieces.
#[derive(Default)]
struct Block {
    triangles: Vec<BlockTriangle>,
    /// The ends of the half-edges 3 k, 3 k + 1 and 3 k + 2 of triangle k.
    edges: Vec<[u32; 2]>,
    pairing: Pairing,
}

impl Block {
    fn read(&mut self, mesh: &Scaled, numbers: &[u32]) {
        self.triangles.clear();
        self.edges.clear();
        for &number in numbers {
            let [a, b, c] = mesh.triangles[number as usize];
            self.edges.extend([[a, b], [b, c], [c, a]]);
            let corners = mesh.corners(number);
            let normal = clear_normal(&corners).unwrap_or(DVec3::ZERO);
            self.triangles.push(BlockTriangle { number, extent: AxisBox::around(corners), normal });
        }
        // Blocks that come from the same subdivision have the same pairs, so the pairs of the last block are tried
        // first.
        if !self.pairing.holds(&self.edges) {
            self.pairing = Pairing::new(&self.edges);
        }
    }

    fn extent(&self) -> AxisBox {
        self.triangles.iter().fold(AxisBox::EMPTY, |whole, triangle| whole.with(&triangle.extent))
    }

    fn members(&self, piece: u8) -> impl Iterator<Item = &BlockTriangle> {
        self.triangles
            .iter()
            .zip(&self.pairing.piece)
            .filter(move |(_, of)| **of == piece)
            .map(|(triangle, _)| triangle)
    }

    /// The numbers of the triangles, piece by piece.
    fn by_piece(&self) -> Vec<u32> {
        (0..self.pairing.pieces).flat_map(|piece| self.members(piece).map(|triangle| triangle.number)).collect()
    }

    /// The half-edges of a piece that have no opposite half-edge in the same block.
    fn edges_of(&self, piece: u8) -> impl Iterator<Item = [u32; 2]> {
        let piece_of = |h: u8| self.pairing.piece[h as usize / 3];
        self.pairing.single.iter().filter(move |&&h| piece_of(h) == piece).map(|&h| self.edges[h as usize])
    }

    /// Makes the patch of a piece, and returns it with the number of its triangles. The caller sets `first` and
    /// `first_edge`.
    fn patch(&self, piece: u8) -> (Patch, usize) {
        let (mut extent, mut sum, mut count) = (AxisBox::EMPTY, DVec3::ZERO, 0);
        for triangle in self.members(piece) {
            extent = extent.with(&triangle.extent);
            sum += triangle.normal;
            count += 1;
        }
        let axis = sum.normalize_or_zero();
        let mut least = 1.0f64;
        for triangle in self.members(piece) {
            let along = triangle.normal.dot(axis);
            let is_in_front = along > 0.0;
            least = least.min(if is_in_front { along * along / triangle.normal.length_squared() } else { -1.0 });
        }
        let spread = if least > 0.0 { libm::acos(least.sqrt()) } else { f64::INFINITY };
        (Patch { extent, axis, spread, first: 0, first_edge: 0 }, count)
    }
}

/// Pairs the opposite half-edges of a block: two half-edges that run along the same edge in opposite directions.
#[derive(Default)]
struct Pairing {
    /// Pairs of opposite half-edges.
    pairs: Vec<[u8; 2]>,
    /// The half-edges without an opposite half-edge in the block.
    single: Vec<u8>,
    /// For each triangle, the number of its connected piece.
    piece: Vec<u8>,
    pieces: u8,
}

impl Pairing {
    fn new(edges: &[[u32; 2]]) -> Self {
        let mut keyed: Vec<(u64, u8)> =
            (0..).zip(edges).map(|(h, [a, b])| (u64::from(*a.min(b)) << 32 | u64::from(*a.max(b)), h)).collect();
        keyed.sort_unstable();
        let mut pairing = Self { piece: vec![u8::MAX; edges.len() / 3], ..Self::default() };
        let mut twins = vec![u8::MAX; edges.len()];
        for same in keyed.chunk_by(|a, b| a.0 == b.0) {
            match *same {
                [(_, one), (_, other)] if edges[one as usize][0] == edges[other as usize][1] => {
                    pairing.pairs.push([one, other]);
                    twins[one as usize] = other;
                    twins[other as usize] = one;
                }
                _ => pairing.single.extend(same.iter().map(|&(_, h)| h)),
            }
        }
        pairing.single.sort_unstable();
        let mut stack = Vec::new();
        for seed in 0..pairing.piece.len() {
            if pairing.piece[seed] != u8::MAX {
                continue;
            }
            pairing.piece[seed] = pairing.pieces;
            stack.push(seed);
            // At most one pass per triangle, because each triangle gets its piece once and is added then.
            while let Some(k) = stack.pop() {
                for &twin in twins[3 * k..3 * k + 3].iter().filter(|&&twin| twin != u8::MAX) {
                    let next = twin as usize / 3;
                    if pairing.piece[next] == u8::MAX {
                        pairing.piece[next] = pairing.pieces;
                        stack.push(next);
                    }
                }
            }
            pairing.pieces += 1;
        }
        pairing
    }

    /// Whether every pair is also a pair of opposite half-edges in another block of as many triangles.
    fn holds(&self, edges: &[[u32; 2]]) -> bool {
        let is_pair = |&[one, other]: &[u8; 2]| {
            let [[a, b], [c, d]] = [edges[one as usize], edges[other as usize]];
            a == d && b == c
        };
        3 * self.piece.len() == edges.len() && self.pairs.iter().all(is_pair)
    }
}
