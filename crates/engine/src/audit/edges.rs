//! The edges of a list of triangles and what they say about its topology.

/// An edge and its triangles.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) struct Edge {
    /// The two vertices, the smaller one first.
    pub ends: [u32; 2],
    /// Number of triangles that run along it from the smaller vertex to the larger one.
    pub forward: u32,
    /// Number of triangles that run along it the other way.
    pub backward: u32,
}

impl Edge {
    #[must_use]
    pub fn triangles(&self) -> u32 {
        self.forward + self.backward
    }
}

/// The edges of some triangles, sorted by their ends.
#[derive(Clone, Debug)]
pub(crate) struct Edges {
    pub list: Vec<Edge>,
    /// The edges whose smaller end is v are `list[first[v]..first[v + 1]]`.
    first: Vec<u32>,
}

impl Edges {
    /// Collects the edges of triangles over `count` vertices. O(vertices + triangles), apart from vertices with many
    /// triangles, whose edges are sorted.
    #[must_use]
    pub fn of(triangles: &[[u32; 3]], count: usize) -> Self {
        let sides = || triangles.iter().flat_map(|&[a, b, c]| [[a, b], [b, c], [c, a]]);
        let mut start = vec![0u32; count + 1];
        for [a, b] in sides() {
            start[a.min(b) as usize + 1] += 1;
        }
        for v in 0..count {
            start[v + 1] += start[v];
        }
        // An entry of `halves` is the larger end of a side, shifted left by one bit. The lowest bit tells whether the
        // side runs from its larger to its smaller end. 31 bits suffice for a vertex, because there is no memory for
        // more vertices.
        assert!(count <= 1 << 31, "the numbers of the vertices have 31 bits");
        let mut places = start.clone();
        let mut halves = vec![0u32; 3 * triangles.len()];
        for [a, b] in sides() {
            let place = &mut places[a.min(b) as usize];
            halves[*place as usize] = a.max(b) << 1 | u32::from(a > b);
            *place += 1;
        }
        let mut list = Vec::with_capacity(halves.len() / 2 + 1);
        let mut first = Vec::with_capacity(count + 1);
        for v in 0..count {
            first.push(list.len() as u32);
            let own = &mut halves[start[v] as usize..start[v + 1] as usize];
            own.sort_unstable();
            let mut end = None;
            for &half in &*own {
                if end != Some(half >> 1) {
                    end = Some(half >> 1);
                    list.push(Edge { ends: [v as u32, half >> 1], forward: 0, backward: 0 });
                }
                if let Some(edge) = list.last_mut() {
                    edge.backward += half & 1;
                    edge.forward += 1 - (half & 1);
                }
            }
        }
        first.push(list.len() as u32);
        Self { list, first }
    }

    /// Returns the edge between two vertices.
    #[must_use]
    pub fn between(&self, a: u32, b: u32) -> Option<&Edge> {
        let low = a.min(b) as usize;
        let own = &self.list[self.first[low] as usize..self.first[low + 1] as usize];
        own.binary_search_by_key(&a.max(b), |edge| edge.ends[1]).ok().map(|k| &own[k])
    }

    /// Returns whether each edge has one triangle, or two that run along it in opposite directions.
    #[must_use]
    pub fn are_of_an_oriented_manifold(&self) -> bool {
        self.list.iter().all(|edge| edge.forward <= 1 && edge.backward <= 1)
    }

    pub fn on_boundary(&self) -> impl Iterator<Item = &Edge> {
        self.list.iter().filter(|edge| edge.triangles() == 1)
    }
}

/// Connected components of vertices that edges join, as a union-find forest: each vertex refers to its parent, and the
/// smallest vertex of a component is its root.
#[derive(Clone, Debug)]
pub(crate) struct Components(Vec<u32>);

impl Components {
    #[must_use]
    pub fn of<'a>(edges: impl Iterator<Item = &'a Edge>, count: usize) -> Self {
        let mut sets = Self((0..count as u32).collect());
        for edge in edges {
            let [a, b] = edge.ends.map(|v| sets.root(v));
            sets.0[a.max(b) as usize] = a.min(b);
        }
        sets
    }

    fn root(&mut self, mut v: u32) -> u32 {
        while self.0[v as usize] != v {
            let above = self.0[v as usize];
            self.0[v as usize] = self.0[above as usize];
            v = above;
        }
        v
    }

    /// Returns the number of components whose smallest vertex `is_used` marks.
    #[must_use]
    pub fn count(&self, is_used: &[bool]) -> usize {
        self.0.iter().enumerate().filter(|&(v, &root)| root == v as u32 && is_used[v]).count()
    }
}
