//! Members and nodes of lattices and nets: lengths, kinds, and the directions of the members at each node.

use super::csv::{Cell, Table};
use super::request::ScheduleOptions;
use crate::parameters::Refused;
use plateau_archive::archive::CABLES;
use plateau_archive::units::UpAxis;
use plateau_archive::{Contents, Lines};
use plateau_mesh::DVec3;
use plateau_mesh::measure::{angle, double_area_vector};
use std::collections::BTreeMap;

/// Name of the line sets of members.
const MEMBERS: &str = "members";

/// Nodes with members between them.
#[derive(Clone, Debug)]
pub struct Lattice {
    pub nodes: Vec<DVec3>,
    /// Ends of each member, in the order of the line sets.
    pub members: Vec<[u32; 2]>,
    /// For each node its axis, a unit vector.
    pub axes: Vec<DVec3>,
    /// For each node the numbers of its members.
    pub at_nodes: Vec<Vec<u32>>,
}

fn sets(contents: &Contents) -> impl Iterator<Item = &[[u32; 2]]> {
    // The cables of a film are no lattice; those of a net are all that it has.
    let is_net = contents.mesh.triangles.is_empty();
    contents.line_sets.iter().filter_map(move |set| match &set.lines {
        Lines::Segments(pairs) if set.name == MEMBERS || (is_net && set.name == CABLES) => Some(pairs.as_slice()),
        _ => None,
    })
}

impl Lattice {
    /// Returns true if a result has members.
    #[must_use]
    pub fn is_in(contents: &Contents) -> bool {
        sets(contents).any(|pairs| !pairs.is_empty())
    }

    /// Returns the members of a result. A node's axis is the area-weighted normal of its triangles; in a net it is the
    /// sum of its members' directions, reversed. Where that sum vanishes, as in a plane, the axis points up.
    #[must_use]
    pub fn of(contents: &Contents) -> Self {
        let nodes = contents.mesh.vertices.clone();
        let members: Vec<[u32; 2]> = sets(contents).flatten().copied().collect();
        let mut at_nodes = vec![Vec::new(); nodes.len()];
        let mut sums = vec![DVec3::ZERO; nodes.len()];
        for (number, &[from, to]) in members.iter().enumerate() {
            at_nodes[from as usize].push(number as u32);
            at_nodes[to as usize].push(number as u32);
            let direction = (nodes[to as usize] - nodes[from as usize]).normalize_or_zero();
            sums[from as usize] -= direction;
            sums[to as usize] += direction;
        }
        if !contents.mesh.triangles.is_empty() {
            sums = vec![DVec3::ZERO; nodes.len()];
            for &triangle in &contents.mesh.triangles {
                let normal = double_area_vector(contents.mesh.corners(triangle));
                triangle.iter().for_each(|&vertex| sums[vertex as usize] += normal);
            }
        }
        let up = match contents.up {
            UpAxis::Z => DVec3::Z,
            UpAxis::Y => DVec3::Y,
        };
        // A sum of unit directions below this size is rounding. Area vectors are normalised by their largest.
        let largest = sums.iter().map(|sum| sum.length()).fold(0.0, f64::max);
        let axis = |sum: &DVec3| if sum.length() > 1e-9 * largest { sum.normalize() } else { up };
        let axes = sums.iter().map(axis).collect();
        Self { nodes, members, axes, at_nodes }
    }

    /// Returns the length of a member.
    #[must_use]
    pub fn length(&self, member: u32) -> f64 {
        let [from, to] = self.members[member as usize].map(|node| self.nodes[node as usize]);
        from.distance(to)
    }

    /// Returns the node at the other end of a member.
    fn other_end(&self, member: u32, node: usize) -> usize {
        let [from, to] = self.members[member as usize].map(|node| node as usize);
        if from == node { to } else { from }
    }

    /// Returns the unit direction of a member away from a node.
    fn direction(&self, member: u32, node: usize) -> DVec3 {
        (self.nodes[self.other_end(member, node)] - self.nodes[node]).normalize_or_zero()
    }

    /// Returns the number of the kind of each member, from 0 in the order of lengths. Lengths of one kind differ by at
    /// most the tolerance, and there are as few kinds as that allows.
    #[must_use]
    pub fn member_kinds(&self, tolerance: f64) -> Vec<usize> {
        let lengths: Vec<f64> = (0..self.members.len()).map(|member| self.length(member as u32)).collect();
        let mut order: Vec<usize> = (0..lengths.len()).collect();
        order.sort_by(|&one, &other| lengths[one].total_cmp(&lengths[other]));
        let mut kinds = vec![0; lengths.len()];
        let (mut kind, mut shortest) = (0, order.first().map_or(0.0, |&first| lengths[first]));
        for member in order {
            if lengths[member] - shortest > tolerance {
                (kind, shortest) = (kind + 1, lengths[member]);
            }
            kinds[member] = kind;
        }
        kinds
    }

    /// Returns two unit vectors at right angles to a node's axis. The first, `zero`, is the direction of the node's
    /// first member that is not along the axis, seen along the axis.
    fn frame(&self, node: usize) -> [DVec3; 2] {
        let axis = self.axes[node];
        let across = |member: &u32| {
            let direction = self.direction(*member, node);
            let across = direction - axis * axis.dot(direction);
            (across.length() > 1e-6).then(|| across.normalize())
        };
        let zero = self.at_nodes[node].iter().find_map(across).unwrap_or_else(|| axis.any_orthonormal_vector());
        [zero, axis.cross(zero)]
    }

    /// Returns the number of the kind of each node, from 0 in the order in which they first appear. Two nodes are of
    /// one kind if one can be turned about its axis so that the far ends of its members, taken at the mean length of
    /// all members, meet those of the other within the tolerance. A node and its mirror image are of two kinds.
    ///
    /// A node joins the first kind whose first node it meets within half of the tolerance, so that all nodes of a kind
    /// meet each other within the tolerance.
    #[must_use]
    pub fn node_kinds(&self, tolerance: f64) -> Vec<usize> {
        let count = self.members.len().max(1) as f64;
        let mean = (0..self.members.len()).map(|member| self.length(member as u32)).sum::<f64>() / count;
        let near = 0.5 * tolerance / mean.max(f64::MIN_POSITIVE);
        let mut firsts: Vec<Vec<DVec3>> = Vec::new();
        // Kinds by valence, by the sum of the heights of their members, and by the length of the sum of their
        // directions across the axis. Nodes that meet within `near` share both sums up to `valence · near`.
        let mut by_sums: BTreeMap<(usize, [i64; 2]), Vec<usize>> = BTreeMap::new();
        let step = near.max(1e-12);
        let mut kinds = Vec::with_capacity(self.nodes.len());
        for node in 0..self.nodes.len() {
            let star = self.star(node);
            let sum: DVec3 = star.iter().sum();
            let width = step * star.len().max(1) as f64;
            let bucket = [sum.z, libm::hypot(sum.x, sum.y)].map(|value| (value / width).floor() as i64);
            let near_buckets = (-1..=1).flat_map(|a| (-1..=1).map(move |b| [bucket[0] + a, bucket[1] + b]));
            let mut candidates: Vec<usize> =
                near_buckets.filter_map(|bucket| by_sums.get(&(star.len(), bucket))).flatten().copied().collect();
            candidates.sort_unstable();
            let found = candidates.into_iter().find(|&kind| meet(&firsts[kind], &star, near));
            kinds.push(found.unwrap_or_else(|| {
                firsts.push(star.clone());
                by_sums.entry((star.len(), bucket)).or_default().push(firsts.len() - 1);
                firsts.len() - 1
            }));
        }
        kinds
    }

    /// Returns the unit directions of a node's members in its frame, counter-clockwise about the axis.
    fn star(&self, node: usize) -> Vec<DVec3> {
        let (axis, [zero, across]) = (self.axes[node], self.frame(node));
        let local = |member: &u32| {
            let direction = self.direction(*member, node);
            DVec3::new(direction.dot(zero), direction.dot(across), direction.dot(axis))
        };
        let mut star: Vec<DVec3> = self.at_nodes[node].iter().map(local).collect();
        star.sort_by(|one, other| libm::atan2(one.y, one.x).total_cmp(&libm::atan2(other.y, other.x)));
        star
    }
}

/// Whether one star can be turned about z so that it meets another within a distance.
fn meet(one: &[DVec3], other: &[DVec3], near: f64) -> bool {
    if one.len() != other.len() {
        return false;
    }
    (0..one.len().max(1)).any(|shift| {
        let pairs = || one.iter().enumerate().map(|(k, first)| (*first, other[(k + shift) % other.len()]));
        // The turn that brings the second star nearest to the first in the sum of squares.
        let (sine, cosine) = pairs().fold((0.0, 0.0), |(sine, cosine), (a, b)| {
            (sine + (b.x * a.y - b.y * a.x), cosine + (b.x * a.x + b.y * a.y))
        });
        let length = libm::hypot(sine, cosine);
        let (sine, cosine) = if length > 0.0 { (sine / length, cosine / length) } else { (0.0, 1.0) };
        pairs().all(|(a, b)| {
            let turned = DVec3::new(b.x * cosine - b.y * sine, b.x * sine + b.y * cosine, b.z);
            a.distance(turned) <= near
        })
    })
}

/// Returns the table of members. A setback is at least half the width of the members over the tangent of half the
/// smallest angle to another member at the node, which is where members of this width meet.
pub(super) fn members(lattice: &Lattice, contents: &Contents, options: &ScheduleOptions) -> Result<Table, Refused> {
    let unit = contents.unit.symbol();
    let columns = [
        "member".to_owned(),
        "from".to_owned(),
        "to".to_owned(),
        "kind".to_owned(),
        format!("length_{unit}"),
        format!("setback_from_{unit}"),
        format!("setback_to_{unit}"),
        format!("cut_length_{unit}"),
    ];
    let kinds = lattice.member_kinds(options.tolerance);
    let at_nodes = setbacks(lattice, options);
    let mut table = Table::new(&columns);
    for (number, &[from, to]) in lattice.members.iter().enumerate() {
        let length = lattice.length(number as u32);
        let setbacks = [from, to].map(|node| {
            // A node has its members in increasing order.
            let place = lattice.at_nodes[node as usize].partition_point(|&member| (member as usize) < number);
            at_nodes[node as usize][place]
        });
        let cut = length - setbacks[0] - setbacks[1];
        if cut <= 0.0 {
            let parameter = if options.setback > 0.0 { "setback" } else { "member_width" };
            let detail = format!("leaves nothing of member {number}, which is {length:?} {unit} long");
            return Err(Refused::unsuitable(parameter, detail));
        }
        table.row(&[
            Cell::Count(number),
            Cell::Count(from as usize),
            Cell::Count(to as usize),
            Cell::Count(kinds[number]),
            Cell::Number(length),
            Cell::Number(setbacks[0]),
            Cell::Number(setbacks[1]),
            Cell::Number(cut),
        ]);
    }
    Ok(table)
}

/// Returns for each node the least setback of each of its members, in the order in which the node has them.
fn setbacks(lattice: &Lattice, options: &ScheduleOptions) -> Vec<Vec<f64>> {
    let setback = |least: f64| {
        let needed = if least.is_finite() { 0.5 * options.member_width / libm::tan(0.5 * least) } else { 0.0 };
        options.setback.max(needed)
    };
    let at_node = |node: usize| {
        let members = &lattice.at_nodes[node];
        if options.member_width == 0.0 {
            return vec![options.setback; members.len()];
        }
        let directions: Vec<DVec3> = members.iter().map(|&member| lattice.direction(member, node)).collect();
        least_angles(&directions).into_iter().map(setback).collect()
    };
    (0..lattice.nodes.len()).map(at_node).collect()
}

/// Returns for each unit vector the smallest angle to another one. The vectors are sorted along x, and each is compared
/// with its neighbours on both sides until x alone differs by more than the nearest one found.
fn least_angles(directions: &[DVec3]) -> Vec<f64> {
    let mut order: Vec<usize> = (0..directions.len()).collect();
    order.sort_by(|&one, &other| directions[one].x.total_cmp(&directions[other].x));
    let mut least = vec![f64::INFINITY; directions.len()];
    for (place, &k) in order.iter().enumerate() {
        let own = directions[k];
        let mut nearest = f64::INFINITY;
        let mut compare = |other: usize| {
            let is_near = (directions[other].x - own.x).abs() <= nearest;
            if is_near {
                nearest = nearest.min(own.distance(directions[other]));
                least[k] = least[k].min(angle(own, directions[other]));
            }
            is_near
        };
        let _ = order[..place].iter().rev().all(|&other| compare(other));
        let _ = order[place + 1..].iter().all(|&other| compare(other));
    }
    least
}

/// Returns the table of nodes, with one row for each member at each node. The azimuth runs counter-clockwise about the
/// axis from `zero`, and the elevation is the angle above the plane at right angles to the axis. The twist is the angle
/// about the member, seen from the node along it, from the node's axis to the mean of the axes at both ends.
pub(super) fn nodes(lattice: &Lattice, contents: &Contents, options: &ScheduleOptions) -> Table {
    let unit = contents.unit.symbol();
    let mut columns = vec!["node".to_owned(), "kind".to_owned()];
    columns.extend(["x", "y", "z"].map(|axis| format!("{axis}_{unit}")));
    let plain = ["axis_x", "axis_y", "axis_z", "zero_x", "zero_y", "zero_z", "member", "to"];
    columns.extend(plain.map(str::to_owned));
    columns.extend(["azimuth_deg", "elevation_deg", "twist_deg"].map(str::to_owned));
    let kinds = lattice.node_kinds(options.tolerance);
    let mut table = Table::new(&columns);
    for (node, &kind) in kinds.iter().enumerate() {
        let (at, axis, [zero, across]) = (lattice.nodes[node], lattice.axes[node], lattice.frame(node));
        for &member in &lattice.at_nodes[node] {
            let to = lattice.other_end(member, node);
            let direction = lattice.direction(member, node);
            let azimuth = libm::atan2(direction.dot(across), direction.dot(zero)).to_degrees();
            // atan2 keeps all digits near the axis, where an arc sine loses half of them.
            let height = direction.dot(axis);
            let elevation = libm::atan2(height, (direction - axis * height).length()).to_degrees();
            let mut cells = vec![Cell::Count(node), Cell::Count(kind)];
            cells.extend([at, axis, zero].iter().flat_map(|v| v.to_array()).map(Cell::Number));
            cells.extend([Cell::Count(member as usize), Cell::Count(to)]);
            let twist = twist(direction, axis, lattice.axes[to]).to_degrees();
            cells.extend([azimuth, elevation, twist].map(Cell::Number));
            table.row(&cells);
        }
    }
    table
}

/// Returns the angle about a member's direction from one axis to the mean of two, each seen along the member.
fn twist(direction: DVec3, axis: DVec3, other: DVec3) -> f64 {
    let across = |v: DVec3| (v - direction * v.dot(direction)).normalize_or_zero();
    let (own, mean) = (across(axis), across(axis) + across(other));
    libm::atan2(own.cross(mean).dot(direction), own.dot(mean))
}
