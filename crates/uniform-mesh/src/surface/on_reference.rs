//! Uniform meshes of surfaces that cannot be flattened. They are meshed on the surface itself:
//!
//! 1. [`Net::remesh`]: triangles of about one edge length everywhere.
//! 2. The lattice group. A node that moves on a surface has two degrees of freedom, and there are three edges for each
//!    node, so that at most two thirds of the edges can have one given length. The group takes the edges nearest to ℓ
//!    that can be assigned to nodes, at most two to each node (one to a node on a curve). The lengths of the group are
//!    then a system with no more equations than unknowns.
//! 3. The paper's optimisation ([`refine`]): the nodes move on the surface to the least Σ (L - ℓ)² over the group, all
//!    other members within [ℓ, 2ℓ].
//! 4. Members that are still out of range are split or collapsed, and the nodes move again. The last move may take more
//!    steps.
//! 5. A member that is far out of range even then, without a reason in the boundary, is split or collapsed once more,
//!    and the nodes move again, because the best mesh of step 4 can still have such members. Members across a sharp
//!    corner may then be as short as the distance between its sides at 2ℓ.
//!
//! [`Objective::FewestNodes`] has no lattice group: all members are brought into [ℓ, 2ℓ], starting from the largest
//! triangles for which that is possible.

use super::move_nodes::{Effort, Moved, OnSurface, Sheet, TargetLength, refine};
use super::reference::{Bond, NodeLocation, Reference};
use super::remesh::{Meeting, Net, Size, longest_squared};
use crate::edges::edges;
use crate::options::Objective;
use crate::report::Why;
use plateau_mesh::execution::{Execution, Interruption};
use plateau_mesh::measure::{self, double_area_vector};
use plateau_mesh::topology::{next, previous};
use plateau_mesh::{DVec2, DVec3};

/// Target lengths of the remeshing for the fewest nodes and for the most equal edges, in ℓ.
///
/// The remeshing makes edges between 0.8 and 4/3 of the target. With a target of 1.45 they fill [ℓ, 2ℓ]; strongly
/// curved places take the shortest edges that the range allows. For the most equal edges the target exceeds ℓ, because
/// the edges outside the group are longer than those in it.
const FEWEST: Size = Size { largest: 1.45, least: 1.12, turn: 0.2 };
const EQUAL: Size = Size { largest: 1.06, least: 1.06, turn: 1.0 };
/// Maximum number of rounds that move the nodes and then split or collapse members out of range.
const ROUNDS: usize = 3;
/// Maximum number of rounds at the end that split or collapse members far out of range.
const REPAIRS: usize = 2;
/// Members outside this range, in ℓ, count as far out of range. A mesh with members outside [0.6 ℓ, 2.5 ℓ] is not
/// converged.
const FAR: (f64, f64) = (0.7, 2.3);
/// Maximum number of multiplier updates each time that the nodes move in the first [`ROUNDS`] rounds.
const BRIEF: usize = 2;
/// Longest displacement of a node in one step, in ℓ.
const LONGEST_STEP: f64 = 0.35;
/// Range of lengths, in ℓ, of the members that may belong to the lattice group.
const GROUP: std::ops::RangeInclusive<f64> = 0.7..=1.4;
/// Members outside this range, in ℓ, are split or collapsed. The next move of the nodes brings the others into [ℓ, 2ℓ].
const OUT: (f64, f64) = (0.98, 2.02);
/// Smallest altitude of a triangle after a move, as a fraction of its longest side, seen along the surface's normal.
/// Without this bound the moves would press nodes flat against the boundary.
const THINNEST: f64 = 0.12;
/// Length (in ℓ) and angle (radians) above which an edge along a curve is split, where the angle is the one opposite to
/// the edge. The edge cannot flip, because it lies on a curve. The opposite node may then merge with the new vertex.
const SEEN_WIDE: (f64, f64) = (1.5, 2.4);
/// Length of the queue from which on a search for a node with a free degree of freedom adds no more nodes to it.
const SEARCH: usize = 300;
/// Number of nodes that the searches visit between two looks at the caller's signal.
const NODES_PER_LOOK: u64 = 1 << 16;

impl Sheet for Reference {
    type Location = NodeLocation;

    fn effort(&self) -> Effort {
        Effort { attempts: 1, rounds: 6, iterations: 20, tolerance: 1e-4 }
    }

    fn evaluate(&self, place: NodeLocation) -> [DVec3; 3] {
        let point = self.point(place.spot);
        match place.bond {
            Bond::Free => {
                let (x, y) = self.facet_normal(place.spot).any_orthonormal_pair();
                [point, x, y]
            }
            Bond::Curve { curve, at } => [point, self.tangent(curve, at), DVec3::ZERO],
            Bond::Fixed(_) => [point, DVec3::ZERO, DVec3::ZERO],
        }
    }

    fn are_upright(&self, triangles: &[[u32; 3]], at: &dyn Fn(u32) -> (NodeLocation, DVec3)) -> bool {
        triangles.iter().all(|t| self.is_upright(t.map(at)))
    }

    fn advance(&self, mesh: &Moved<'_, NodeLocation>, step: &[DVec2], to: &mut [NodeLocation]) -> f64 {
        let displaced = |k: usize, part: f64| {
            let here = mesh.moving[k];
            let step = step[k] * part;
            let step = step * (LONGEST_STEP / step.length().max(LONGEST_STEP));
            match here.bond {
                Bond::Free => {
                    let [_, x, y] = Sheet::evaluate(self, here);
                    NodeLocation { spot: self.walk(here.spot, x * step.x + y * step.y), ..here }
                }
                Bond::Curve { curve, at } => {
                    let at = (at + step.x).clamp(0.0, self.curves[curve as usize].length());
                    NodeLocation { spot: self.on_curve(curve, at), bond: Bond::Curve { curve, at } }
                }
                Bond::Fixed(_) => here,
            }
        };
        let mut parts = vec![1.0; to.len()];
        for (k, place) in to.iter_mut().enumerate() {
            *place = displaced(k, 1.0);
        }
        // A node whose step would flip a triangle takes a smaller part of the step, and at last no step.
        for part in [0.4, 0.1, 0.0, 0.0, 0.0] {
            let positions: Vec<DVec3> = to.iter().map(|place| self.point(place.spot)).collect();
            let located = |v: u32| match (v as usize).checked_sub(mesh.fixed) {
                Some(k) => (to[k], positions[k]),
                None => (mesh.standing[v as usize], self.point(mesh.standing[v as usize].spot)),
            };
            let turned: Vec<[u32; 3]> =
                mesh.triangles.iter().filter(|t| !self.is_upright(t.map(located))).copied().collect();
            if turned.is_empty() {
                break;
            }
            for v in turned.into_iter().flatten() {
                if let Some(k) = (v as usize).checked_sub(mesh.fixed)
                    && parts[k] > part
                {
                    parts[k] = part;
                    to[k] = displaced(k, part);
                }
            }
        }
        parts.iter().sum::<f64>() / parts.len() as f64
    }

    fn below(&self, corners: [NodeLocation; 3], middle: DVec3) -> (DVec3, DVec3) {
        let free: Vec<NodeLocation> = corners.into_iter().filter(|place| place.bond == Bond::Free).take(1).collect();
        let starts = if free.is_empty() { corners.to_vec() } else { free };
        let mut best = (f64::INFINITY, DVec3::ZERO, DVec3::ZERO);
        for start in starts.into_iter().flat_map(|place| self.sides(place.spot)) {
            let spot = self.foot(start, middle);
            let point = self.point(spot);
            let distance = point.distance(middle);
            if distance < best.0 {
                best = (distance, point, self.facet_normal(spot));
            }
        }
        (best.1, best.2)
    }
}

impl Reference {
    /// Whether the normal of a triangle agrees with the surface's normals at its corners, and its altitude is not below
    /// [`THINNEST`].
    fn is_upright(&self, corners: [(NodeLocation, DVec3); 3]) -> bool {
        let mean: DVec3 = corners.iter().map(|(place, _)| self.normal(place.spot)).sum();
        let corners = corners.map(|corner| corner.1);
        double_area_vector(corners).dot(mean) > THINNEST * longest_squared(corners) * mean.length()
    }
}

/// Meshes the surface. If the work ended early, the second value is the reason; the mesh is valid even then.
///
/// # Errors
/// The interruption, if it comes before there is a mesh of about the target length.
pub(crate) fn mesh<'a>(
    reference: &'a Reference,
    objective: Objective,
    optimise: bool,
    (from, to): (f64, f64),
    execution: &Execution<'_>,
) -> Result<(OnSurface<'a, Reference>, Option<Interruption>), Interruption> {
    let size = match objective {
        Objective::FewestNodes => FEWEST,
        Objective::MostEqualEdges => EQUAL,
    };
    let mut net = Net::new(reference, size);
    net.remesh(execution)?;
    let mut best = nodes(&mut net, objective, execution)?;
    if !optimise {
        return Ok((best, None));
    }
    // Copy of the net from which the best nodes came, as it was before its members were split or collapsed.
    let mut of_best = net.clone();
    let part = |k: usize| from + (to - from) * k as f64 / (ROUNDS + 1 + REPAIRS) as f64;
    let move_nodes = |nodes: &mut OnSurface<'a, Reference>, rounds: usize, k: usize| {
        let target = |&lattice: &bool| if lattice { TargetLength::At(1.0) } else { TargetLength::Within(1.0) };
        let targets: Vec<TargetLength> = nodes.lattice_group.iter().map(target).collect();
        let effort = Effort { rounds, ..reference.effort() };
        refine(nodes, &targets, effort, "optimise_nodes", (part(k), part(k + 1)), execution)
    };
    let move_repaired = |nodes: &mut OnSurface<'a, Reference>, k: usize| {
        let targets = reachable_targets(nodes);
        refine(nodes, &targets, reference.effort(), "optimise_nodes", (part(k), part(k + 1)), execution)
    };
    let mut least = f64::INFINITY;
    for round in 0..ROUNDS {
        let mut here = match nodes(&mut net, objective, execution) {
            Ok(here) => here,
            Err(interruption) => return Ok((best, Some(interruption))),
        };
        let interrupted = move_nodes(&mut here, BRIEF, round);
        let misfit = misfit(&here);
        if misfit < least {
            least = misfit;
            best = here.clone();
            of_best = net.clone();
        }
        if interrupted.is_some() {
            return Ok((best, interrupted));
        }
        net.put_all(&here.parameters);
        match mend(&mut net, OUT, execution) {
            Ok(true) => {}
            Ok(false) => break,
            Err(interruption) => return Ok((best, Some(interruption))),
        }
    }
    let mut interrupted = move_nodes(&mut best, reference.effort().rounds, ROUNDS);
    for repair in 0..REPAIRS {
        let far = far_members(&best);
        if far == 0 || interrupted.is_some() {
            break;
        }
        of_best.put_all(&best.parameters);
        match mend(&mut of_best, FAR, execution) {
            Ok(true) => {}
            Ok(false) => break,
            Err(interruption) => return Ok((best, Some(interruption))),
        }
        let mut here = match nodes(&mut of_best, objective, execution) {
            Ok(here) => here,
            Err(interruption) => return Ok((best, Some(interruption))),
        };
        interrupted = move_repaired(&mut here, ROUNDS + 1 + repair);
        if far_members(&here) >= far {
            break;
        }
        best = here;
    }
    Ok((best, interrupted))
}

/// Returns the target lengths of all members. A member across a sharp corner may be shorter than ℓ if the corner leaves
/// no more room. A target that no location of the nodes can reach would push the nodes towards the corner or away from
/// it.
fn reachable_targets(nodes: &OnSurface<'_, Reference>) -> Vec<TargetLength> {
    let target = |(&lattice, &ends): (&bool, &[u32; 2])| {
        let across = nodes.surface.apart_across(ends.map(|v| nodes.parameters[v as usize]));
        match across {
            _ if lattice => TargetLength::At(1.0),
            Some(apart) => TargetLength::Within((2.0 * apart).min(1.0)),
            None => TargetLength::Within(1.0),
        }
    };
    nodes.lattice_group.iter().zip(&nodes.members).map(target).collect()
}

/// Number of members that are far out of range without a reason in the boundary.
fn far_members(nodes: &OnSurface<'_, Reference>) -> usize {
    let is_far = |&(&ends, length): &(&[u32; 2], f64)| {
        let places = ends.map(|v| nodes.parameters[v as usize]);
        !(FAR.0..=FAR.1).contains(&length) && nodes.surface.why(places, length) == Why::Curvature
    };
    nodes.members.iter().zip(nodes.lengths()).filter(is_far).count()
}

/// Converts the net to nodes that move, with the lattice group that the present lengths give.
///
/// # Errors
/// The interruptions of `execution`.
fn nodes<'a>(
    net: &mut Net<'a>,
    objective: Objective,
    execution: &Execution<'_>,
) -> Result<OnSurface<'a, Reference>, Interruption> {
    net.sort();
    let members = edges(&net.topology);
    let fixed = net.places.iter().take_while(|place| matches!(place.bond, Bond::Fixed(_))).count();
    let mut nodes = OnSurface {
        surface: net.reference,
        parameters: net.places.clone(),
        positions: net.positions.clone(),
        fixed,
        triangles: net.topology.triangles().to_vec(),
        lattice_group: vec![false; members.len()],
        members,
    };
    if objective == Objective::MostEqualEdges {
        nodes.lattice_group = lattice_group(&nodes, execution)?;
    }
    Ok(nodes)
}

/// Returns which members belong to the lattice group: the edges nearest to ℓ that can be assigned to nodes. A node gets
/// at most as many edges as it has degrees of freedom.
///
/// # Errors
/// The interruptions of `execution`.
fn lattice_group(nodes: &OnSurface<'_, Reference>, execution: &Execution<'_>) -> Result<Vec<bool>, Interruption> {
    let lengths = nodes.lengths();
    let mut order: Vec<usize> = (0..lengths.len()).filter(|&m| GROUP.contains(&lengths[m])).collect();
    order.sort_by(|&a, &b| (lengths[a] - 1.0).abs().total_cmp(&(lengths[b] - 1.0).abs()).then(a.cmp(&b)));
    let mut left: Vec<u8> = nodes
        .parameters
        .iter()
        .map(|place| match place.bond {
            Bond::Free => 2,
            Bond::Curve { .. } => 1,
            Bond::Fixed(_) => 0,
        })
        .collect();
    // For each node, the members that are assigned to it.
    let mut serves: Vec<Vec<usize>> = vec![Vec::new(); left.len()];
    let mut group = vec![false; lengths.len()];
    let mut seen = vec![0u32; left.len()];
    let mut work = 0;
    for (turn, member) in order.into_iter().enumerate() {
        let turn = turn as u32 + 1;
        // A breadth-first search from the member's ends finds a node with a free degree of freedom. Each member on the
        // way is assigned to the next node.
        let mut queue: Vec<(u32, Option<usize>, usize)> =
            nodes.members[member].iter().map(|&v| (v, None, member)).collect();
        queue.iter().for_each(|&(v, ..)| seen[v as usize] = turn);
        let mut next = 0;
        // Ends because no node is added to the queue twice.
        let found = loop {
            let Some(&(v, ..)) = queue.get(next) else { break None };
            if left[v as usize] > 0 {
                break Some(next);
            }
            if queue.len() < SEARCH {
                for &m in &serves[v as usize] {
                    let [a, b] = nodes.members[m];
                    let other = if a == v { b } else { a };
                    if seen[other as usize] != turn {
                        seen[other as usize] = turn;
                        queue.push((other, Some(next), m));
                    }
                }
            }
            next += 1;
        };
        work += queue.len() as u64;
        if work >= NODES_PER_LOOK {
            execution.look(std::mem::take(&mut work))?;
        }
        let Some(mut at) = found else { continue };
        left[queue[at].0 as usize] -= 1;
        // Ends because each entry of the queue refers to an earlier one.
        loop {
            let (v, before, m) = queue[at];
            serves[v as usize].push(m);
            let Some(before) = before else { break };
            serves[queue[before].0 as usize].retain(|&other| other != m);
            at = before;
        }
        group[member] = true;
    }
    Ok(group)
}

/// The misfit: half the sum of the squared distances of lattice members from ℓ and of the other members from [ℓ, 2ℓ],
/// where the squares of the other members have the weight 10.
fn misfit(nodes: &OnSurface<'_, Reference>) -> f64 {
    let term = |(&length, &lattice): (&f64, &bool)| {
        let off = if lattice { length - 1.0 } else { (1.0 - length).max(length - 2.0).max(0.0) };
        0.5 * off * off * if lattice { 1.0 } else { 10.0 }
    };
    nodes.lengths().iter().zip(&nodes.lattice_group).map(term).sum()
}

/// Splits members that are longer than the given range, collapses shorter ones, and flips edges. Returns whether the
/// triangles changed.
///
/// # Errors
/// The interruption.
fn mend(net: &mut Net<'_>, (shortest, longest): (f64, f64), execution: &Execution<'_>) -> Result<bool, Interruption> {
    let count = |net: &Net<'_>| net.topology.twin.len() as u32;
    let before = net.topology.triangles().to_vec();
    let seen_wide = |h: u32| {
        let corners = [h, next(h), previous(h)].map(|h| net.positions[net.topology.from(h) as usize]);
        let [a, b, apex] = corners;
        net.curve_of(net.topology.from(h), net.topology.to(h)).is_some()
            && a.distance(b) > SEEN_WIDE.0
            && measure::angle(a - apex, b - apex) > SEEN_WIDE.1
    };
    let too_long = |&h: &u32| net.length(h) > longest || seen_wide(h);
    let mut long: Vec<u32> = (0..count(net)).filter(too_long).collect();
    long.sort_by(|&a, &b| net.length(b).total_cmp(&net.length(a)).then(a.cmp(&b)));
    net.split_edges(&long);
    let mut short: Vec<u32> = (0..count(net)).filter(|&h| net.length(h) < shortest).collect();
    short.sort_by(|&a, &b| net.length(a).total_cmp(&net.length(b)).then(a.cmp(&b)));
    short.truncate(short.len().min(net.places.len() / 50 + 1));
    net.collapse_edges(&short, Meeting::Middle, 1.9);
    net.flip_to_delaunay(execution)?;
    Ok(net.topology.triangles() != before)
}
