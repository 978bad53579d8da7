//! The two passes of isotropic remeshing that change the connectivity of a mesh: one splits edges, the other collapses
//! edges. Both work on any [`Surface`].
//!
//! Source: Botsch, Kobbelt, *A Remeshing Approach to Multiresolution Modeling* (2004), section 4. The edges that a pass
//! splits share no triangle, and the edges that a pass collapses share no neighbourhood. The order of the edges decides
//! which of two neighbouring edges is changed, and the triangle list is rebuilt once per pass.

use crate::edit::may_collapse;
use crate::film::Film;
use crate::topology::{NONE, Topology};

/// A mesh whose connectivity may be changed.
pub trait Connected {
    /// The connectivity.
    fn topology(&self) -> &Topology;

    /// The connectivity, to be changed.
    fn topology_mut(&mut self) -> &mut Topology;
}

impl Connected for Film {
    fn topology(&self) -> &Topology {
        &self.topology
    }

    fn topology_mut(&mut self) -> &mut Topology {
        &mut self.topology
    }
}

/// A mesh whose vertices stand on a surface, as the passes see it.
pub trait Surface: Connected {
    /// A place on the surface at which a vertex may stand.
    type Place;

    /// Adds a vertex on the surface half way along an edge, and returns its number, which is the number of vertices
    /// before. `None`, without a new vertex, if the edge is not to be split.
    fn add_middle(&mut self, half_edge: u32) -> Option<u32>;

    /// Returns how an edge would collapse, without changing anything. `None` if the edge is not to be collapsed.
    fn planned_collapse(&self, half_edge: u32) -> Option<Collapse<Self::Place>>;

    /// Called for an edge whose planned collapse is left out because it would change the topology of the mesh.
    fn cannot_collapse(&mut self, _half_edge: u32) {}

    /// Whether the triangles around the ends of an edge keep their shape if the edge collapses like this.
    fn keeps_shape(&self, collapse: &Collapse<Self::Place>) -> bool;

    /// Puts the vertex that stays to its new place. The topology has already lost the other end of the edge.
    fn merge(&mut self, collapse: Collapse<Self::Place>);
}

/// The collapse of an edge.
#[derive(Clone, Copy, Debug)]
pub struct Collapse<P> {
    /// The end that is merged into the other one.
    pub leaves: u32,
    /// The end that stays.
    pub stays: u32,
    /// The new place of the end that stays.
    pub place: P,
    /// Whether the end that stays may move. If it does not, its other neighbours may take part in further collapses of
    /// the pass.
    pub moves: bool,
}

/// Splits edges in their order, where no triangle of an edge belongs to an edge that was split before. Each edge is
/// given by one of its half-edges. Returns the number of split edges.
///
/// # Panics
/// If [`Surface::add_middle`] returns a wrong number.
pub fn split_edges(surface: &mut impl Surface, edges: impl IntoIterator<Item = u32>) -> usize {
    let mut triangles = surface.topology().triangles().to_vec();
    let mut taken = vec![false; triangles.len()];
    let (mut vertices, mut count) = (surface.topology().outgoing.len(), 0);
    for h in edges {
        let topology = surface.topology();
        let twin = topology.twin[h as usize];
        let is_taken = |half: u32| half != NONE && taken[half as usize / 3];
        if is_taken(h) || is_taken(twin) {
            continue;
        }
        let Some(middle) = surface.add_middle(h) else { continue };
        let topology = surface.topology();
        for half in [h, twin] {
            if half != NONE {
                taken[half as usize / 3] = true;
                let (from, to, apex) = (topology.from(half), topology.to(half), topology.opposite(half));
                triangles[half as usize / 3] = [from, middle, apex];
                triangles.push([middle, to, apex]);
            }
        }
        (vertices, count) = (middle as usize + 1, count + 1);
    }
    if count > 0 {
        *surface.topology_mut() = Topology::build(&triangles, vertices).expect("splitting edges keeps a manifold");
    }
    count
}

/// Collapses the given edges one after the other. Each edge is given by one of its half-edges. An edge is skipped if
/// its neighbourhood has a vertex in common with that of an edge collapsed before, or if the
/// [link condition](may_collapse) or the shape of the triangles forbids the collapse. Returns the number of collapsed
/// edges. The removed triangles and vertices leave gaps in the topology ([`Topology::without_gaps`] closes them).
pub fn collapse_edges(surface: &mut impl Surface, edges: impl IntoIterator<Item = u32>) -> usize {
    let mut touched = vec![false; surface.topology().outgoing.len()];
    let mut count = 0;
    for h in edges {
        let topology = surface.topology();
        if topology.is_removed(h / 3) || [topology.from(h), topology.to(h)].iter().any(|&v| touched[v as usize]) {
            continue;
        }
        let Some(collapse) = surface.planned_collapse(h) else { continue };
        let (leaves, stays) = (collapse.leaves, collapse.stays);
        let beyond = collapse.moves.then(|| topology.neighbours(stays)).into_iter().flatten();
        let near: Vec<u32> = topology.neighbours(leaves).chain(beyond).chain([leaves, stays]).collect();
        if near.iter().any(|&v| touched[v as usize]) {
            continue;
        }
        if !may_collapse(topology, leaves, stays) {
            surface.cannot_collapse(h);
            continue;
        }
        if !surface.keeps_shape(&collapse) {
            continue;
        }
        near.into_iter().for_each(|v| touched[v as usize] = true);
        surface.topology_mut().collapse(stays, leaves);
        surface.merge(collapse);
        count += 1;
    }
    count
}
