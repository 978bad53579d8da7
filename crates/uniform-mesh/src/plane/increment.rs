//! The algorithm INCREMENT: farthest-point insertion (Katoh, Ohsaki and Xu, section 2; for the rim, section 3).
//!
//! 1. The nodes on the boundary of the region are already placed (steps 1 and 2 of the paper).
//! 2. The point farthest from all nodes that it can see is the circumcentre of a constrained Delaunay triangle, among
//!    the circumcentres that are visible from their triangle. (In section 3 the distance to a hidden node is infinite.)
//! 3. Insert the farthest of these centres while its distance is ℓ or more.
//! 4. The result is a constrained Delaunay triangulation with every edge at most 2ℓ: a triangle whose centre is visible
//!    has a circumradius below ℓ (lemma 1), and the edges of a triangle whose centre is hidden behind a boundary edge
//!    are no longer than that edge (lemma 2). No edge at an inserted node is shorter than ℓ.
//!
//! Our departures:
//! - The paper rebuilds the Voronoi diagram. We keep a heap of the triangles' circumradii, and the triangulation
//!   changes only around the new node: O(n log n) in practice. A triangle's centre stays visible or stays hidden,
//!   because insertion adds no obstacles. A triangle with a hidden centre is therefore dropped when it is first taken
//!   from the heap.
//! - The threshold is ℓ(1 + 1e-9). A boundary edge of exactly 2ℓ makes flat triangles whose circumradius is ℓ up to
//!   rounding, with the centre on the edge. Inserting this centre would make a triangle without area.
//! - Radii are compared up to a relative difference of 2^-30, then by the triangle's number, so that rounding does not
//!   decide between the equal radii of symmetric input.

use plateau_mesh::DVec2;
use plateau_mesh::execution::{Execution, Interruption, Progress};
use plateau_mesh::plane::triangulation::{Sight, Triangulation};
use std::cmp::Reverse;
use std::collections::BinaryHeap;

/// A point is inserted only if its distance from all nodes exceeds ℓ by at least this, in ℓ. Edges may exceed 2ℓ by the
/// same factor.
pub(crate) const SLACK: f64 = 1e-9;

/// Number of triangles made or visited between two calls of [`Execution::look`].
const WORK_PER_LOOK: u64 = 4096;

/// Fills the region with nodes until every visible point is nearer than 1 + [`SLACK`] to some node (lengths in units of
/// ℓ).
///
/// `expected` is the expected number of new nodes. The reported progress runs from `from` to `to` while they are
/// inserted.
///
/// # Errors
/// The interruption. The triangulation is then valid, but not yet filled.
pub(crate) fn fill(
    region: &mut Triangulation,
    expected: usize,
    (from, to): (f64, f64),
    execution: &Execution<'_>,
) -> Result<(), Interruption> {
    let mut queue = Circumradii::default();
    let rank = |region: &Triangulation, t: u32| circumcentre(region.triangle(t)).1;
    let least = (1.0 + SLACK) * (1.0 + SLACK);
    for t in 0..region.corners.len() as u32 {
        queue.consider(t, rank(region, t), least);
    }
    let (mut star, mut work, mut inserted) = (Vec::new(), region.corners.len() as u64, 0u64);
    while let Some(t) = queue.pop() {
        let (centre, _) = circumcentre(region.triangle(t));
        let (sight, visited) = region.look_towards(t, centre);
        work += visited;
        if let Sight::In(t) = sight {
            star.clear();
            region.insert(t, centre, &mut star, Triangulation::is_not_delaunay);
            star.iter().for_each(|&t| queue.consider(t, rank(region, t), least));
            work += star.len() as u64;
            inserted += 1;
        }
        if work >= WORK_PER_LOOK {
            execution.look(std::mem::take(&mut work))?;
            let share = (inserted as f64 / expected.max(1) as f64).min(1.0);
            execution.report(Progress {
                fraction: from + (to - from) * share,
                phase: "increment",
                iteration: inserted,
                objective_value: None,
                residual: None,
            });
        }
    }
    execution.look(work)
}

/// The queue of triangles whose circumcentres may be inserted: largest circumradius first, then by number.
#[derive(Debug, Default)]
pub(crate) struct Circumradii {
    /// For each triangle, the rank of its entry in the heap, or 0 if it has none.
    ranks: Vec<u64>,
    heap: BinaryHeap<(u64, Reverse<u32>)>,
}

impl Circumradii {
    /// Queues a triangle by its squared circumradius if that is at least `least`, and cancels its earlier entry.
    pub fn consider(&mut self, t: u32, squared: f64, least: f64) {
        if self.ranks.len() <= t as usize {
            self.ranks.resize(t as usize + 1, 0);
        }
        // The bits of positive floats have the order of the floats. The lowest 22 of the 52 bits of the fraction are
        // dropped, because rounding decides them.
        let rank = if squared.is_finite() && squared >= least { squared.to_bits() >> 22 } else { 0 };
        self.ranks[t as usize] = rank;
        if rank > 0 {
            self.heap.push((rank, Reverse(t)));
        }
    }

    /// Takes the next triangle from the queue. Entries that a later entry has replaced are skipped.
    pub fn pop(&mut self) -> Option<u32> {
        // Ends because each pass takes an entry from the heap and adds none.
        while let Some((rank, Reverse(t))) = self.heap.pop() {
            if self.ranks[t as usize] == rank {
                self.ranks[t as usize] = 0;
                return Some(t);
            }
        }
        None
    }
}

/// The circumcentre and the squared circumradius of a triangle. Not finite if the triangle has no area.
fn circumcentre([a, b, c]: [DVec2; 3]) -> (DVec2, f64) {
    let (u, v) = (b - a, c - a);
    let (uu, vv) = (u.length_squared(), v.length_squared());
    let offset = DVec2::new(v.y * uu - u.y * vv, u.x * vv - v.x * uu) / (2.0 * u.perp_dot(v));
    (a + offset, offset.length_squared())
}
