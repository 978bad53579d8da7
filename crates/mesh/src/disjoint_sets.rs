//! Disjoint sets of numbers (union-find with path halving).

/// A partition of the numbers `0..count` into disjoint sets. The smallest member of a set is its leader.
#[derive(Clone, Debug)]
pub struct DisjointSets(Vec<u32>);

impl DisjointSets {
    /// The partition in which each number is a set of its own.
    #[inline]
    pub fn new(count: usize) -> Self {
        Self((0..count as u32).collect())
    }

    /// The smallest member of a number's set.
    #[inline]
    pub fn leader(&mut self, mut k: u32) -> u32 {
        // At most as many steps as the set has members, because each number that is not a leader refers to a smaller
        // one.
        while self.0[k as usize] != k {
            self.0[k as usize] = self.0[self.0[k as usize] as usize];
            k = self.0[k as usize];
        }
        k
    }

    /// Unites the sets of two numbers.
    #[inline]
    pub fn join(&mut self, a: u32, b: u32) {
        let (a, b) = (self.leader(a), self.leader(b));
        self.0[a.max(b) as usize] = a.min(b);
    }

    /// Number of sets.
    #[inline]
    pub fn count(&self) -> usize {
        (0..).zip(&self.0).filter(|(k, leader)| *k == **leader).count()
    }
}
