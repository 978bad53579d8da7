//! The sides of a domain: into how many pieces each side is split, and why an edge between boundary nodes is too short.

use crate::options::Objective;
use crate::report::Why;
use plateau_mesh::DVec2;

/// Relative tolerance for rounding when counting how many times ℓ fits into a side.
const WHOLE: f64 = 1e-10;
/// Distance along the boundary, in ℓ, above which two nodes are certainly more than 3ℓ apart in spite of rounding.
const CLEARLY_APART: f64 = 3.0 + 1e-6;

/// How long the pieces are into which a side of 2ℓ or more is split.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) enum Division {
    /// Pieces as near to ℓ as possible. If the directions of the boundary fit those of the lattice, the lattice
    /// continues up to the boundary.
    Short,
    /// Pieces of at most √2 ℓ wherever possible, so that no inserted node falls into the diametral circle of a piece.
    /// If the boundary runs across the lattice, the lattice nodes may be nearer to the boundary than with short pieces.
    Long,
}

impl Division {
    /// The divisions that are tried for an objective.
    pub fn candidates(objective: Objective) -> &'static [Self] {
        match objective {
            Objective::FewestNodes => &[Self::Long],
            Objective::MostEqualEdges => &[Self::Short, Self::Long],
        }
    }
}

/// Number of pieces into which a side of the given length (in ℓ) is split.
pub(crate) fn pieces(length: f64, division: Division) -> u32 {
    // A side shorter than 2ℓ is not split. A side of exactly 2ℓ is split into two members.
    let most = (length * (1.0 + WHOLE)).floor().max(1.0);
    match division {
        _ if length < 2.0 * (1.0 - WHOLE) => 1,
        Division::Short => most as u32,
        Division::Long => (length / std::f64::consts::SQRT_2).ceil().min(most) as u32,
    }
}

/// Whether the inner angle between two consecutive sides is below 90°. The first side has the direction `edge` and the
/// next has the direction `after`, with the domain on the left.
pub(crate) fn is_sharp(edge: DVec2, after: DVec2) -> bool {
    edge.perp_dot(after) > 0.0 && edge.dot(after) < 0.0
}

/// A side of the domain, from corner to corner.
#[derive(Clone, Copy, Debug)]
struct Side {
    /// The corner where the side starts.
    start: u32,
    /// Length in ℓ.
    length: f64,
    /// The next side in the loop, with the domain on the left.
    next: u32,
    /// Whether the inner angle at the end of the side is below 90°.
    sharp_end: bool,
    /// The sides of the loop are `begin..end`.
    begin: u32,
    end: u32,
    /// Total length of all sides before this side, in ℓ.
    passed: f64,
}

/// All sides, and for each boundary node the two sides on which it lies (`stands`). At a corner these are the side
/// before and the side after the corner. At any other node both are the same side.
#[derive(Clone, Debug, Default)]
pub(crate) struct Sides {
    sides: Vec<Side>,
    stands: Vec<[u32; 2]>,
}

impl Sides {
    /// An empty list of sides. The corners are the first nodes of the boundary.
    pub fn new(corners: usize) -> Self {
        Self { sides: Vec::new(), stands: vec![[u32::MAX; 2]; corners] }
    }

    /// Adds a loop through `nodes`. Each of its sides is given as (index in `nodes` of its first node, length in ℓ,
    /// whether its end is sharp).
    pub fn add_loop(&mut self, nodes: &[u32], sides: &[(usize, f64, bool)]) {
        let first = self.sides.len() as u32;
        let after = |k: usize| first + ((k + 1) % sides.len()) as u32;
        let last = first + sides.len() as u32;
        for (k, &(start, length, sharp_end)) in sides.iter().enumerate() {
            let here = first + k as u32;
            let end = sides.get(k + 1).map_or(nodes.len(), |next| next.0);
            for &node in &nodes[start..end] {
                if self.stands.len() <= node as usize {
                    self.stands.resize(node as usize + 1, [u32::MAX; 2]);
                }
                self.stands[node as usize] = [here; 2];
            }
            let passed = self.sides.last().map_or(0.0, |side| side.passed + side.length);
            let (start, next) = (nodes[start], after(k));
            self.sides.push(Side { start, length, next, sharp_end, begin: first, end: last, passed });
        }
        for (k, &(start, ..)) in sides.iter().enumerate() {
            let before = first + ((k + sides.len() - 1) % sides.len()) as u32;
            self.stands[nodes[start] as usize][0] = before;
        }
    }

    pub fn lengths(&self) -> impl Iterator<Item = f64> + '_ {
        self.sides.iter().map(|side| side.length)
    }

    /// The corner where the side of a node starts. For a corner this is the corner itself.
    pub fn start_of(&self, node: u32) -> u32 {
        self.sides[self.stands[node as usize][1] as usize].start
    }

    /// Whether both ends of an edge, which are boundary nodes, lie on the same side.
    pub fn are_on_one(&self, [a, b]: [u32; 2]) -> bool {
        self.stands[a as usize].iter().any(|s| self.stands[b as usize].contains(s))
    }

    /// Total length of the sides after `from` and before `to`, with the domain on the left. `None` if the two sides are
    /// on different loops.
    fn between(&self, from: u32, to: u32) -> Option<f64> {
        let Side { begin, end, passed, length, .. } = self.sides[from as usize];
        if !(begin..end).contains(&to) {
            return None;
        }
        let ahead = self.sides[to as usize].passed - (passed + length);
        let (first, last) = (self.sides[begin as usize], self.sides[end as usize - 1]);
        Some(if to > from { ahead } else { ahead + last.passed + last.length - first.passed })
    }

    /// Why an edge in the plane is outside [ℓ, 2ℓ]. `length` is its length in ℓ, and `nodes` holds all boundary nodes.
    pub fn why(&self, edge: [u32; 2], length: f64, nodes: &[DVec2]) -> Why {
        let [Some(&a), Some(&b)] = edge.map(|v| self.stands.get(v as usize)) else { return Why::Unfinished };
        if length > 1.0 {
            return Why::Unfinished;
        }
        let side = |s: u32| self.sides[s as usize];
        let short = |s: u32| side(s).length < 1.0;
        if a.iter().any(|s| b.contains(s) && short(*s)) {
            return Why::ShortSide;
        }
        for (a, b) in [(a, b), (b, a)] {
            if a.iter().any(|&s| side(s).sharp_end && b.contains(&side(s).next)) {
                return Why::SharpCorner;
            }
        }
        // A short side is the reason if it lies on the way between the nodes along the boundary and this way is less
        // than 3ℓ.
        let position = |v: u32| nodes[v as usize];
        for (from, to) in [(edge[0], edge[1]), (edge[1], edge[0])] {
            let first = self.stands[from as usize][1];
            // A node farther away is skipped at once. The walk below would not reach it, but could take many steps
            // where many sides are short.
            let is_near = |&s: &u32| self.between(first, s).is_some_and(|way| way <= CLEARLY_APART);
            if !self.stands[to as usize].iter().any(is_near) {
                continue;
            }
            let mut s = first;
            let (mut way, mut shorter) = (position(from).distance(position(side(side(s).next).start)), short(s));
            // At most one pass per side of the loop, because the walk also stops where it started.
            while way < 3.0 {
                s = side(s).next;
                shorter |= short(s);
                if self.stands[to as usize].contains(&s) {
                    if shorter && way + position(side(s).start).distance(position(to)) < 3.0 {
                        return Why::ShortSide;
                    }
                    break;
                }
                // The walk has gone once around a loop that is shorter than 3ℓ.
                if s == first {
                    break;
                }
                way += side(s).length;
            }
        }
        Why::Narrow
    }
}
