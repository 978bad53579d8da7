//! The forces at the supports of the found shape, and their sums.

use super::form_finding::{Balance, Found};
use super::model::{Model, ModelCable, MovingRing};
use super::options::BoundaryPoint;
use super::shape::{EdgeForce, EdgeReaction, ForceBalance, Reaction, TriangleStress};
use plateau_equilibrium::{Freedom, Support};
use plateau_mesh::DVec3;
use plateau_mesh::measure::double_area_vector;
use std::collections::{BTreeMap, BTreeSet};

/// The support of a vertex.
#[derive(Clone, Copy, Debug)]
pub(super) enum Hold<'a> {
    Nothing,
    Fixed,
    Slides(&'a dyn Support),
    /// The vertex moves with the ring of this number, along the ring's axis alone.
    Guided(usize),
}

pub(super) fn holds(model: &Model) -> Vec<Hold<'_>> {
    let held = model.held().into_iter();
    let mut holds: Vec<Hold> = held.map(|held| if held { Hold::Fixed } else { Hold::Nothing }).collect();
    for &(v, freedom) in &model.sliding {
        if let Some(support) = freedom.support() {
            holds[v as usize] = Hold::Slides(&*model.supports[support as usize]);
        }
    }
    for (number, ring) in model.rings.iter().enumerate() {
        ring.vertices.iter().for_each(|&v| holds[v as usize] = Hold::Guided(number));
    }
    holds
}

/// For each ring the unbalanced force along its axis, divided by the number of its vertices.
fn unbalanced_of_rings(model: &Model, balance: &Balance) -> Vec<DVec3> {
    let of = |ring: &MovingRing| {
        let along: f64 = ring.vertices.iter().map(|&v| balance.forces[v as usize].dot(ring.axis)).sum();
        ring.axis * (along / ring.vertices.len() as f64)
    };
    model.rings.iter().map(of).collect()
}

/// The component of a force along a line or surface at one of its points.
fn along(support: &dyn Support, at: DVec3, force: DVec3) -> DVec3 {
    let tangents = support.tangents(at);
    tangents[..usize::from(support.dimension())].iter().map(|t| *t * t.dot(force)).sum()
}

pub(super) fn sums(model: &Model, balance: &Balance, holds: &[Hold], at: &[DVec3]) -> ForceBalance {
    let of_rings = unbalanced_of_rings(model, balance);
    let loads: DVec3 = balance.loads.iter().sum();
    let (mut reactions, mut magnitudes, mut residual_force) = (DVec3::ZERO, 0.0, 0.0f64);
    for (((&force, &contact), hold), &place) in balance.forces.iter().zip(&balance.contacts).zip(holds).zip(at) {
        let unbalanced = match *hold {
            Hold::Nothing => force,
            Hold::Fixed => DVec3::ZERO,
            Hold::Slides(support) => along(support, place, force + contact),
            Hold::Guided(ring) => of_rings[ring],
        };
        let reaction = force - unbalanced;
        reactions += reaction;
        magnitudes += reaction.length();
        residual_force = residual_force.max(unbalanced.length());
    }
    ForceBalance {
        loads,
        reactions,
        magnitudes,
        imbalance: (loads + reactions).length() / magnitudes.max(f64::MIN_POSITIVE),
        residual_force,
    }
}

/// Returns the least and the largest angle, in radians, between the film's pull on a sliding edge and the surface on
/// which the edge slides. At an edge with a given contact angle, the angle on the left of the edge is taken.
pub(super) fn contact_angles(model: &Model, balance: &Balance, holds: &[Hold], at: &[DVec3]) -> Option<(f64, f64)> {
    let mut range = None;
    for &(v, freedom) in &model.sliding {
        let (force, place) = (balance.forces[v as usize], at[v as usize]);
        let Hold::Slides(support) = holds[v as usize] else { continue };
        if support.dimension() != 2 || force == DVec3::ZERO {
            continue;
        }
        let tangential = along(support, place, force);
        let towards = match freedom {
            // `force` is the support's force on the film, which is opposite to the film's pull.
            Freedom::AcrossOn { beside: [a, b], .. } if model.at_contacts.contains(&v) => {
                let left = support.normal(place).cross(at[b as usize] - at[a as usize]);
                -tangential.dot(left.normalize_or_zero())
            }
            _ => tangential.length(),
        };
        let angle = libm::atan2((force - tangential).length(), towards);
        let (least, most) = range.unwrap_or((angle, angle));
        range = Some((angle.min(least), angle.max(most)));
    }
    range
}

/// The reactions of a shape.
#[derive(Default)]
pub(super) struct Reactions {
    /// Reactions of supports at single vertices.
    pub single: Vec<Reaction>,
    /// For each boundary the sum of the reactions along its edges.
    pub edges: Vec<EdgeReaction>,
    /// Reactions along edges, vertex by vertex.
    pub edge_supports: Vec<(u32, DVec3)>,
}

/// Computes the reactions of the shape. `edge_forces` is the result of [`edge_forces`].
pub(super) fn reactions(model: &Model, found: &Found, holds: &[Hold], edge_forces: &[Vec<EdgeForce>]) -> Reactions {
    let Some(balance) = &found.balance else { return Reactions::default() };
    let held = |v: u32| !matches!(holds[v as usize], Hold::Nothing);
    let mut single = vec![false; holds.len()];
    let ends = model.cables.iter().flat_map(ModelCable::ends);
    let points = model.sliding.iter().filter(|(_, freedom)| matches!(freedom, Freedom::On(_))).map(|(v, _)| *v);
    for v in ends.chain(points) {
        single[v as usize] = held(v) && !matches!(holds[v as usize], Hold::Guided(_));
    }
    let at = model.vertices();
    let ends = clamped_ends(model, balance, holds, &at);
    // Where a cable ends at a clamped edge, the reaction at the vertex bears the cable and that of the edge the film.
    let of_point = |v: u32| ends.get(&v).copied().unwrap_or(balance.forces[v as usize]);
    let of_edge = |v: u32| {
        let all = balance.forces[v as usize];
        if single[v as usize] { ends.get(&v).map_or(DVec3::ZERO, |cables| all - *cables) } else { all }
    };
    let point_of = |vertex: u32| {
        let of = |(boundary, numbers): (usize, &Vec<u32>)| {
            let point = numbers.iter().position(|&v| v == vertex)?;
            Some(BoundaryPoint { boundary, point })
        };
        model.input_vertices.iter().enumerate().find_map(of)
    };
    let single_reactions = (0..holds.len() as u32)
        .filter(|&v| single[v as usize])
        .map(|vertex| Reaction { vertex, point: point_of(vertex), force: of_point(vertex) })
        .collect();
    let mut result = Reactions { single: single_reactions, ..Reactions::default() };
    for (boundary, (rim, forces)) in model.boundaries().iter().zip(edge_forces).enumerate() {
        let own: Vec<(u32, DVec3)> = if let Some(Hold::Guided(number)) = rim.first().map(|&v| holds[v as usize]) {
            // The hub passes its force on to the ring.
            model.rings[number].vertices.iter().map(|&v| (v, balance.forces[v as usize])).collect()
        } else {
            let borne = rim.iter().filter(|&&v| held(v) && (!single[v as usize] || ends.contains_key(&v)));
            borne.map(|&v| (v, of_edge(v))).collect()
        };
        if own.is_empty() {
            continue;
        }
        let magnitudes = forces.iter().map(|force| force.per_length.length());
        let per_length = magnitudes.map(|size| (size, size)).reduce(|a, b| (a.0.min(b.0), a.1.max(b.1)));
        result.edges.push(EdgeReaction { boundary, force: own.iter().map(|(_, force)| *force).sum(), per_length });
        result.edge_supports.extend(own);
    }
    result
}

/// For each boundary the force per length of the supports along each held segment on which no cable runs. `stresses`
/// holds the stress of each of the `triangles`. If it is empty, there are no forces.
pub(super) fn edge_forces(
    model: &Model,
    holds: &[Hold],
    triangles: &[[u32; 3]],
    stresses: &[TriangleStress],
    at: &[DVec3],
) -> Vec<Vec<EdgeForce>> {
    let key = |[v, w]: [u32; 2]| [v.min(w), v.max(w)];
    let mut pulls: BTreeMap<[u32; 2], DVec3> = BTreeMap::new();
    let held = |v: u32| !matches!(holds[v as usize], Hold::Nothing);
    for (triangle, stress) in triangles.iter().zip(stresses) {
        let sides = [0, 1, 2].map(|k| [triangle[k], triangle[(k + 1) % 3]]);
        for side in sides.into_iter().filter(|&[v, w]| held(v) && held(w)) {
            let normal = double_area_vector(triangle.map(|v| at[v as usize])).normalize_or_zero();
            let [from, to] = side.map(|v| at[v as usize]);
            let outward = (to - from).cross(normal).normalize_or_zero();
            let (along, across) = (stress.direction, normal.cross(stress.direction));
            let pull =
                stress.principal.1 * along.dot(outward) * along + stress.principal.0 * across.dot(outward) * across;
            *pulls.entry(key(side)).or_insert(DVec3::ZERO) += pull;
        }
    }
    let on_cables = on_chains(model);
    let of_rim = |rim: &Vec<u32>| {
        let segments = (0..rim.len()).map(|k| [rim[k], rim[(k + 1) % rim.len()]]);
        let own = segments.filter(|segment| !on_cables.contains(&key(*segment)));
        own.filter_map(|segment| Some(EdgeForce { segment, per_length: *pulls.get(&key(segment))? })).collect()
    };
    model.boundaries().iter().map(of_rim).collect()
}

/// The segments of all cables, each with its lower vertex number first.
fn on_chains(model: &Model) -> BTreeSet<[u32; 2]> {
    let pairs = model.cables.iter().flat_map(|cable| cable.chain.windows(2));
    pairs.map(|pair| [pair[0].min(pair[1]), pair[0].max(pair[1])]).collect()
}

/// For each vertex at which cables end on a clamped edge, the force of the support on these cables alone, without the
/// film.
fn clamped_ends(model: &Model, balance: &Balance, holds: &[Hold], at: &[DVec3]) -> BTreeMap<u32, DVec3> {
    let along = on_chains(model);
    let mut clamped = vec![false; holds.len()];
    for rim in model.boundaries() {
        for (k, &v) in rim.iter().enumerate() {
            let w = rim[(k + 1) % rim.len()];
            let both = [v, w].iter().all(|&v| matches!(holds[v as usize], Hold::Fixed));
            if both && !along.contains(&[v.min(w), v.max(w)]) {
                (clamped[v as usize], clamped[w as usize]) = (true, true);
            }
        }
    }
    let mut forces = BTreeMap::new();
    for (ModelCable { chain, term: cable, .. }, segments) in model.cables.iter().zip(&balance.cable_forces) {
        let [Some(&first), Some(&last)] = [segments.first(), segments.last()] else { continue };
        let count = chain.len();
        for (end, next, force) in [(chain[0], chain[1], first), (chain[count - 1], chain[count - 2], last)] {
            if clamped[end as usize] {
                let segment = at[next as usize] - at[end as usize];
                let weight = cable.up * (0.5 * cable.weight * segment.length());
                *forces.entry(end).or_insert(DVec3::ZERO) += weight - force * segment.normalize_or_zero();
            }
        }
    }
    forces
}
