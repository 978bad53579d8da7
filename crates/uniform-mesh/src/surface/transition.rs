//! Rebuilds the rim of a curved mesh on the surface itself.
//!
//! The edges of the rim that was made in the plane are within [ℓ, 2ℓ] in the plane. They do not fit where the surface
//! is stretched relative to the plane, and after the lattice has moved. Members then leave the range, and triangles
//! become needles that keep the lattice from moving.
//!
//! 1. Keep the boundary's nodes and the lattice group, and remove the nodes that INCREMENT put between them.
//! 2. Triangulate the region between them in the parameter plane, with the lattice's border as constraints. Then flip
//!    every edge whose two opposite angles *on the surface* add up to more than 180°, where the parameter plane allows
//!    it.
//! 3. INCREMENT with distances on the surface: while a triangle's circumradius there is ℓ or more, its circumcentre (by
//!    Newton's method on the true surface) becomes a node, if it is visible and clear of all others.
//! 4. Move all inner nodes again ([`refine`]), and repeat from 1 as long as lattice and rim together gain.
//!
//! This goes beyond the paper, which keeps the rim of the plane; its Table 1 has a member of 13.4 for ℓ = 5.

use super::auxiliary::Surface;
use super::move_nodes::{OnSurface, Sheet, TargetLength, refine};
use crate::edges::{edges, topology};
use crate::options::Transition as Freedom;
use crate::plane::increment::Circumradii;
use plateau_mesh::execution::{Execution, Interruption};
use plateau_mesh::measure;
use plateau_mesh::plane::triangulation::{Border, Constraint, Sight, Triangulation, side};
use plateau_mesh::topology::{NONE, edge_key};
use plateau_mesh::{DVec2, DVec3};

/// An edge flips if its opposite angles add up to more than 180° plus this angle, in radians.
const FLAT: f64 = 1e-7;
/// Least distance of a new node from all others, in ℓ. It is a little below 1, because the triangulation is only nearly
/// Delaunay, and because the nodes move afterwards, which evens out the lengths.
const CLEAR: f64 = 0.95;
/// Largest number of flips, for each half-edge of the triangulation. On a curved surface flips may otherwise not end.
const FLIPS_PER_EDGE: usize = 20;
/// Number of visited triangles and edges between two looks at the caller's signal.
const WORK_PER_LOOK: u64 = 4096;
/// Maximum number of times that the rim is rebuilt.
const REBUILDS: usize = 6;
/// Relative decrease of the misfit in a round below which the rebuilding ends.
const ENOUGH_GAIN: f64 = 1e-3;
/// Misfit per member at which the rebuilding ends. On a flat patch lengths are off only by rounding and by the
/// tolerance of the flattening.
const NO_MISFIT: f64 = 1e-12;
/// Weight of a rim member that is out of range, relative to a lattice member.
const RIM_WEIGHT: f64 = 10.0;

/// Moves the inner nodes ([`refine`]). Unless the rim is free, also rebuilds the rim for their new places, as long as
/// the misfit decreases. Returns whether members have changed, and the reason if the work ended early.
pub(crate) fn fit(
    nodes: &mut OnSurface<'_, Surface>,
    freedom: Freedom,
    (from, to): (f64, f64),
    execution: &Execution<'_>,
) -> (bool, Option<Interruption>) {
    let rounds = if freedom == Freedom::Free { 0 } else { REBUILDS };
    let part = |k: usize| from + (to - from) * k as f64 / (rounds + 1) as f64;
    let move_nodes = |nodes: &mut OnSurface<'_, Surface>, round: usize| {
        let rim = if freedom == Freedom::Free { TargetLength::Free } else { TargetLength::Within(1.0) };
        let target = |&lattice: &bool| if lattice { TargetLength::At(1.0) } else { rim };
        let targets: Vec<TargetLength> = nodes.lattice_group.iter().map(target).collect();
        refine(nodes, &targets, nodes.surface.effort(), "optimise_nodes", (part(round), part(round + 1)), execution)
    };
    let (mut rebuilt, mut interrupted) = (false, move_nodes(nodes, 0));
    let mut best = misfit(nodes);
    for round in 0..rounds {
        if interrupted.is_some() || best <= NO_MISFIT * nodes.members.len() as f64 {
            break;
        }
        let mut trial = match rebuild(nodes, execution) {
            Ok(Some(trial)) => trial,
            Ok(None) => break,
            Err(interruption) => return (rebuilt, Some(interruption)),
        };
        interrupted = move_nodes(&mut trial, round + 1);
        let there = misfit(&trial);
        if there >= best {
            break;
        }
        let gain = best - there;
        (*nodes, rebuilt, best) = (trial, true, there);
        if gain < ENOUGH_GAIN * best {
            break;
        }
    }
    (rebuilt, interrupted)
}

/// The misfit: half the sum of the squared distances of lattice members from ℓ and of rim members from [ℓ, 2ℓ], in ℓ.
/// The squares of rim members have the weight [`RIM_WEIGHT`].
fn misfit(nodes: &OnSurface<'_, Surface>) -> f64 {
    let lengths = nodes.lengths();
    let term = |(&length, &lattice): (&f64, &bool)| {
        let off = if lattice { length - 1.0 } else { (1.0 - length).max(length - 2.0).max(0.0) };
        0.5 * off * off * if lattice { 1.0 } else { RIM_WEIGHT }
    };
    lengths.iter().zip(&nodes.lattice_group).map(term).sum()
}

/// Returns the same lattice with a new rim, or `None` where the parameter plane does not allow one.
///
/// # Errors
/// The interruption. The mesh has not changed then.
pub(crate) fn rebuild<'a>(
    nodes: &OnSurface<'a, Surface>,
    execution: &Execution<'_>,
) -> Result<Option<OnSurface<'a, Surface>>, Interruption> {
    execution.look(nodes.triangles.len() as u64)?;
    // The triangulation needs a plane in which a pole is a side.
    if matches!(nodes.surface, Surface::Patch(_, Some(_))) {
        return Ok(None);
    }
    let core = Core::of(nodes);
    let parameters: Vec<DVec2> = core.nodes.iter().map(|&v| nodes.parameters[v as usize]).collect();
    let positions: Vec<DVec3> = core.nodes.iter().map(|&v| nodes.positions[v as usize]).collect();
    // The triangulation gets only the nodes on constraints, not the nodes inside the lattice.
    let mut part: Vec<u32> = (0..nodes.fixed as u32).collect();
    let mut number = vec![NONE; core.nodes.len()];
    for (k, n) in number.iter_mut().enumerate().take(nodes.fixed) {
        *n = k as u32;
    }
    for v in core.constraints.iter().flat_map(|c| [c.from, c.to]) {
        if number[v as usize] == NONE {
            number[v as usize] = part.len() as u32;
            part.push(v);
        }
    }
    let constraints: Vec<Constraint> = core
        .constraints
        .iter()
        .map(|c| Constraint { from: number[c.from as usize], to: number[c.to as usize], ..*c })
        .collect();
    let points = part.iter().map(|&v| parameters[v as usize]).collect();
    let Ok(flat) = Triangulation::build(points, &constraints) else { return Ok(None) };
    let mut rim =
        Rim { flat, positions: part.iter().map(|&v| positions[v as usize]).collect(), surface: nodes.surface, work: 0 };
    rim.flip_all(execution)?;
    rim.fill(execution)?;
    let upright = |t: u32| {
        let [a, b, c] = rim.flat.triangle(t);
        side(a, b, c) > 0.0
    };
    // If a centre was inserted on an edge that may not flip, a triangle has no area.
    if !(0..rim.flat.corners.len() as u32).all(upright) {
        return Ok(None);
    }

    let inserted = core.nodes.len() as u32;
    part.extend((0..(rim.positions.len() - part.len()) as u32).map(|k| inserted + k));
    let fixed_count = part.iter().filter(|&&v| v < inserted).count();
    let mut result = OnSurface {
        surface: nodes.surface,
        parameters,
        positions,
        fixed: nodes.fixed,
        triangles: core.triangles,
        members: Vec::new(),
        lattice_group: Vec::new(),
    };
    result.parameters.extend_from_slice(&rim.flat.points[fixed_count..]);
    result.positions.extend_from_slice(&rim.positions[fixed_count..]);
    result.triangles.extend(rim.flat.corners.iter().map(|t| t.map(|v| part[v as usize])));
    let Ok(topology) = topology(result.positions.clone(), &result.triangles) else { return Ok(None) };
    result.members = edges(&topology);
    let in_group = |&edge: &[u32; 2]| core.group.binary_search(&edge_key(edge)).is_ok();
    result.lattice_group = result.members.iter().map(in_group).collect();
    if result.lattice_group.iter().filter(|&&lattice| lattice).count() != core.group.len() {
        return Ok(None);
    }
    Ok(Some(result))
}

/// The part of the mesh that stays: boundary nodes and the lattice group. Its nodes are numbered anew.
struct Core {
    /// For each node its index in the old mesh. Boundary nodes come first.
    nodes: Vec<u32>,
    triangles: Vec<[u32; 3]>,
    constraints: Vec<Constraint>,
    /// The edges of the lattice group, each with its smaller end first. Sorted.
    group: Vec<[u32; 2]>,
}

impl Core {
    fn of(nodes: &OnSurface<'_, Surface>) -> Self {
        let mut kept: Vec<bool> = (0..nodes.positions.len()).map(|v| v < nodes.fixed).collect();
        let lattice =
            || nodes.members.iter().zip(&nodes.lattice_group).filter(|&(_, &lattice)| lattice).map(|(m, _)| m);
        for &v in lattice().flatten() {
            kept[v as usize] = true;
        }
        let mut number = vec![NONE; kept.len()];
        let mut list = Vec::new();
        for v in (0..kept.len() as u32).filter(|&v| kept[v as usize]) {
            number[v as usize] = list.len() as u32;
            list.push(v);
        }
        let mut group: Vec<[u32; 2]> =
            lattice().map(|&[a, b]| edge_key([number[a as usize], number[b as usize]])).collect();
        group.sort_unstable();
        // The directed edges of all triangles. An edge is on the boundary if its reverse is not among them.
        let mut directed: Vec<[u32; 2]> =
            nodes.triangles.iter().flat_map(|&[a, b, c]| [[a, b], [b, c], [c, a]]).collect();
        directed.sort_unstable();
        let outline = |a: u32, b: u32| directed.binary_search(&[b, a]).is_err();
        let (mut triangles, mut constraints) = (Vec::new(), Vec::new());
        let mut sides: Vec<[u32; 2]> = Vec::new();
        for &t in &nodes.triangles {
            let edges = [[t[0], t[1]], [t[1], t[2]], [t[2], t[0]]];
            let new = t.map(|v| number[v as usize]);
            let all_lattice = edges.iter().all(|&[a, b]| {
                !outline(a, b) && group.binary_search(&edge_key([number[a as usize], number[b as usize]])).is_ok()
            });
            if all_lattice {
                triangles.push(new);
                sides.extend([[new[0], new[1]], [new[1], new[2]], [new[2], new[0]]].map(edge_key));
            }
            for [a, b] in edges.into_iter().filter(|&[a, b]| outline(a, b)) {
                let (from, to) = (number[a as usize], number[b as usize]);
                constraints.push(Constraint { from, to, border: Border::Outline });
            }
        }
        sides.sort_unstable();
        let mut on_outline: Vec<[u32; 2]> = constraints.iter().map(|c| edge_key([c.from, c.to])).collect();
        on_outline.sort_unstable();
        for &[from, to] in &group {
            let count = sides.partition_point(|s| *s <= [from, to]) - sides.partition_point(|s| *s < [from, to]);
            let border = match count {
                0 => Border::Slit,
                1 => Border::Lattice,
                _ => continue,
            };
            if on_outline.binary_search(&[from, to]).is_err() {
                constraints.push(Constraint { from, to, border });
            }
        }
        Self { nodes: list, triangles, constraints, group }
    }
}

/// The region between boundary and lattice: a triangulation of the parameter plane with positions on the surface.
struct Rim<'a> {
    flat: Triangulation,
    positions: Vec<DVec3>,
    surface: &'a Surface,
    work: u64,
}

impl Rim<'_> {
    fn look(&mut self, execution: &Execution<'_>) -> Result<(), Interruption> {
        if self.work < WORK_PER_LOOK { Ok(()) } else { execution.look(std::mem::take(&mut self.work)) }
    }

    fn flip_all(&mut self, execution: &Execution<'_>) -> Result<(), Interruption> {
        let mut stack: Vec<u32> = (0..3 * self.flat.corners.len() as u32).collect();
        let mut left = FLIPS_PER_EDGE * stack.len();
        while let Some(half_edge) = stack.pop() {
            self.work += 1;
            self.look(execution)?;
            if self.flat.twin_of(half_edge) == NONE || left == 0 || !is_bent(&self.flat, &self.positions, half_edge) {
                continue;
            }
            left -= 1;
            let [t, s] = self.flat.flip(half_edge);
            stack.extend([3 * t, 3 * t + 2, 3 * s, 3 * s + 1]);
        }
        Ok(())
    }

    /// Fills the region by the algorithm INCREMENT, with distances measured on the surface.
    fn fill(&mut self, execution: &Execution<'_>) -> Result<(), Interruption> {
        let mut queue = Circumradii::default();
        for t in 0..self.flat.corners.len() as u32 {
            queue.consider(t, self.squared_circumradius(t), 1.0);
        }
        let mut star = Vec::new();
        while let Some(t) = queue.pop() {
            self.work += 1;
            self.look(execution)?;
            let Some(centre) = self.centre(t) else { continue };
            let (sight, visited) = self.flat.look_towards(t, centre);
            self.work += visited;
            let Sight::In(holder) = sight else { continue };
            let position = self.surface.evaluate(centre)[0];
            if !position.is_finite() || !self.is_clear(holder, position) {
                continue;
            }
            let corners = self.flat.triangle(holder);
            // A node on a constraint would leave a triangle without area.
            if (0..3).any(|k| {
                side(corners[k], corners[(k + 1) % 3], centre) <= 0.0
                    && self.flat.twin_of(3 * holder + k as u32) == NONE
            }) {
                continue;
            }
            star.clear();
            self.positions.push(position);
            let positions = &self.positions;
            self.flat.insert(holder, centre, &mut star, |flat, half_edge| is_bent(flat, positions, half_edge));
            star.iter().for_each(|&t| queue.consider(t, self.squared_circumradius(t), 1.0));
            self.work += star.len() as u64;
        }
        execution.look(std::mem::take(&mut self.work))
    }

    fn squared_circumradius(&self, t: u32) -> f64 {
        let [a, b, c] = self.flat.corners[t as usize].map(|v| self.positions[v as usize]);
        let (u, v) = (b - a, c - a);
        // R = abc / 4A.
        let product = u.length_squared() * v.length_squared() * (c - b).length_squared();
        product / (4.0 * u.cross(v).length_squared())
    }

    /// Returns the parameters of the point of the surface that is equally far from the three corners of a triangle.
    fn centre(&self, t: u32) -> Option<DVec2> {
        let corners = self.flat.corners[t as usize];
        let [a, b, c] = corners.map(|v| self.positions[v as usize]);
        let (aa, bb, cc) = ((c - b).length_squared(), (a - c).length_squared(), (b - a).length_squared());
        let weights = [aa * (bb + cc - aa), bb * (cc + aa - bb), cc * (aa + bb - cc)];
        let total: f64 = weights.iter().sum();
        let points = self.flat.triangle(t);
        let mut p: DVec2 = points.iter().zip(weights).map(|(&q, w)| q * (w / total)).sum();
        // Newton's method on two equations: half the difference of the squared distances to two corners is zero. The
        // equations are linear in the point's position in space.
        for _ in 0..4 {
            let q = self.surface.restrict(p);
            let [x, du, dv] = self.surface.evaluate(q);
            let row = |e: DVec3, end: DVec3| (du.dot(e), dv.dot(e), (x - (a + end) / 2.0).dot(e));
            let ((m11, m12, r1), (m21, m22, r2)) = (row(b - a, b), row(c - a, c));
            let determinant = m11 * m22 - m12 * m21;
            let step = DVec2::new(r1 * m22 - r2 * m12, r2 * m11 - r1 * m21) / determinant;
            if !step.is_finite() {
                return None;
            }
            p = q - step;
        }
        // A point outside the range of the parameters lies behind the boundary, so it is refused.
        (p.is_finite() && self.surface.restrict(p).distance(p) <= 1e-9 * p.length().max(1.0)).then_some(p)
    }

    /// Whether a point is far enough ([`CLEAR`]) from all nodes near it. Only triangles near the point that are
    /// connected to `start` are searched.
    fn is_clear(&mut self, start: u32, position: DVec3) -> bool {
        let mut seen = vec![start];
        let mut next = 0;
        // At most one pass per triangle, because each is added once.
        while next < seen.len() {
            let t = seen[next] as usize;
            next += 1;
            let mut near = next == 1;
            for &v in &self.flat.corners[t] {
                let distance = self.positions[v as usize].distance(position);
                if distance < CLEAR {
                    return false;
                }
                near |= distance < 2.0;
            }
            for &twin in self.flat.twin[t].iter().filter(|&&twin| near && twin != NONE) {
                if !seen.contains(&(twin / 3)) {
                    seen.push(twin / 3);
                }
            }
        }
        self.work += seen.len() as u64;
        true
    }
}

/// Whether the angles opposite to an edge, on the surface, add up to more than 180° and the edge can be flipped in the
/// plane.
fn is_bent(flat: &Triangulation, positions: &[DVec3], half_edge: u32) -> bool {
    let corners = flat.around(half_edge);
    let [a, b, c, d] = corners.map(|v| positions[v as usize]);
    let angle = |at: DVec3| measure::angle(a - at, b - at);
    if angle(c) + angle(d) <= std::f64::consts::PI + FLAT {
        return false;
    }
    let [a, b, c, d] = corners.map(|v| flat.points[v as usize]);
    side(a, d, c) > 0.0 && side(d, b, c) > 0.0
}
