//! Measures the stated figures of a tensile structure again, and compares.

use super::solve::{HELD_EDGES, SolverInput};
use crate::audit::comparison::Audit;
use crate::audit::edges::Edges;
use crate::audit::figure::{Largest, Least, Measured, RELATIVE, Spread, Sum};
use crate::audit::points;
use crate::audit::surface::{Sides, Surface, corners};
use plateau_archive::archive::CABLES;
use plateau_archive::{Attribute, Lines};
use plateau_mesh::DVec3;
use plateau_tensile_structure::{CableMode, Chamber, FilmPrestress};
use std::collections::BTreeMap;

/// Largest allowed difference between the stated force of a cable and the mean force of its segments, relative to the
/// largest force of a segment. A given force is stated as given if the mean of the segments, whose forces balance the
/// film's mesh, differs from it by no more than half of this. Other stated forces are the mean itself.
const MEAN_FORCE: f64 = 2e-3;

impl SolverInput {
    pub(super) fn compare(&self, audit: &mut Audit) {
        let contents = audit.contents;
        let (vertices, triangles) = (&contents.mesh.vertices, &contents.mesh.triangles);
        audit.equal("/vertices", vertices.len());
        audit.equal("/triangles", triangles.len());
        let layers = self.structure.layers.len();
        audit.require(
            audit.entries("/layers") == layers,
            || "each layer has its figures".into(),
            || format!("{layers} layers"),
        );
        let whole = Surface::of(vertices, triangles, audit.step);
        if !audit.goes_on(triangles.len()) {
            return;
        }
        audit.figure("/area", whole.area.measured());
        let [smallest, largest] = whole.angles_deg();
        audit.figure("/angles_deg/min", smallest);
        audit.figure("/angles_deg/max", largest);
        audit.figure("/degenerate_triangles", Measured::count(whole.degenerate));
        let (mut first, mut flipped, mut lengths) = (0usize, [0; 2], Vec::new());
        for k in 0..layers {
            let count = audit.stated_count(&format!("/layers/{k}/triangles"));
            let own = triangles.get(first..first.saturating_add(count)).unwrap_or_default();
            first = first.saturating_add(count);
            let separate = (layers > 1).then(|| Surface::of(vertices, own, audit.step));
            if !audit.goes_on(own.len()) {
                return;
            }
            let layer = separate.as_ref().unwrap_or(&whole);
            audit.figure(&format!("/layers/{k}/area"), layer.area.measured());
            flipped = [0, 1].map(|i| flipped[i] + layer.flipped[i]);
            let edges = Edges::of(own, vertices.len());
            lengths.extend(edges.list.iter().map(|edge| length(vertices, edge.ends)));
            let oriented = edges.are_of_an_oriented_manifold();
            audit.require(oriented, || format!("layer {k} is an oriented manifold"), || "it is not".into());
            points::along_boundaries(audit, &edges, 1, false);
        }
        audit.require(first == triangles.len(), || "the layers have all triangles".into(), || first.to_string());
        audit.figure("/flipped_triangles", Measured::count(flipped));
        audit.spread("/edge_lengths", &Spread::of(&lengths, 2.0 * audit.step));
        self.compare_points(audit);
        let cables = self.compare_cables(audit);
        self.compare_energy(audit, whole.area.measured(), cables);
        self.compare_chambers(audit);
        self.compare_slope(audit);
        compare_balance(audit);
        compare_held_edges(audit);
    }

    /// Requires that each boundary has its vertices. If no point of the structure can move, each point must be at its
    /// vertex.
    fn compare_points(&self, audit: &mut Audit) {
        let contents = audit.contents;
        let lists = contents.input_vertices.len();
        let count = self.structure.boundaries.len();
        audit.require(lists == count, || "each boundary has its vertices".into(), || lists.to_string());
        // A structure in which nothing slides, moves or hangs on a cable keeps every point.
        let structure = &self.structure;
        let all_stay = structure.cables.is_empty() && structure.sliding.is_empty() && structure.rings.is_empty();
        if all_stay && structure.free_points.is_empty() {
            points::at_their_vertices(audit, structure.boundaries.iter().map(|points| &points[..]));
        }
    }

    /// Compares each cable and mast, and returns Σ force · length over those with a prescribed force. The force of a mast
    /// counts as negative, because it pushes.
    fn compare_cables(&self, audit: &mut Audit) -> Sum {
        let contents = audit.contents;
        let vertices = &contents.mesh.vertices;
        let is_member = |name: &str| name == CABLES || name == "masts";
        let sets: Vec<_> = contents.line_sets.iter().filter(|set| is_member(&set.name)).collect();
        let expected = self.structure.cables.len();
        audit.require(sets.len() == expected, || "each cable has its lines".into(), || sets.len().to_string());
        let (mut cables, mut masts, mut total) = (0, 0, Sum::default());
        let step = audit.step;
        for (set, cable) in sets.iter().zip(&self.structure.cables) {
            let Lines::Segments(pairs) = &set.lines else { continue };
            let forces = set.attributes.iter().find(|attribute| attribute.name == "force");
            let forces: &[f64] = forces.map_or(&[], |attribute| &attribute.values);
            let is_mast = cable.course.is_mast();
            let (list, k) = if is_mast { ("masts", &mut masts) } else { ("cables", &mut cables) };
            let pointer = format!("/{list}/{k}");
            *k += 1;
            let (mut moment, mut sum) = (Sum::default(), Sum::default());
            let (mut least, mut most) = (Least::NONE, Largest::NONE);
            for (&pair, &force) in pairs.iter().zip(forces) {
                let own = length(vertices, pair);
                moment.add(force * own, force.abs() * 2.0 * audit.step);
                sum.add(own, 2.0 * audit.step);
                // The force of a cable with weight grows with the height. The force of a segment is that at its middle,
                // so that the forces at its ends differ by half the growth along it.
                let rise = (vertices[pair[1] as usize] - vertices[pair[0] as usize]).dot(self.structure.up).abs();
                let half = 0.5 * cable.weight * rise;
                let tolerance = RELATIVE * (force.abs() + half) + cable.weight * audit.step;
                least.add(force - half, tolerance);
                most.add(force + half, tolerance);
            }
            if let CableMode::Force(force) = cable.mode {
                let own = sum.measured().times(if is_mast { -force } else { force });
                total.add(own.value, (own.high - own.value).abs());
            }
            audit.figure(&format!("{pointer}/length"), sum.measured());
            let joined = pairs.windows(2).all(|pair| pair[0][1] == pair[1][0]);
            audit.require(joined, || format!("the segments of {pointer} follow each other"), || "they do not".into());
            let mean = moment.value / sum.value;
            let scale = least.measured().value.abs().max(most.measured().value.abs());
            audit.figure(&format!("{pointer}/force"), Measured::within(mean, MEAN_FORCE * scale));
            if is_mast {
                continue;
            }
            audit.figure(&format!("{pointer}/force_min"), least.measured());
            audit.figure(&format!("{pointer}/force_max"), most.measured());
            if let Some(stiffness) = cable.axial_stiffness {
                let stated = audit.stated(&format!("{pointer}/force")).unwrap_or(f64::NAN);
                let measured = sum.measured().times(1.0 / (1.0 + stated / stiffness));
                audit.figure(&format!("{pointer}/unstressed_length"), measured);
            }
            audit.figure(&format!("{pointer}/sag"), sag(vertices, pairs, step));
        }
        total
    }

    /// Compares the energy σ A + Σ F L of a film with isotropic tension σ between cables of prescribed forces F.
    /// Structures whose energy has other terms are skipped.
    fn compare_energy(&self, audit: &mut Audit, area: Measured, cables: Sum) {
        let structure = &self.structure;
        let [layer] = &structure.layers[..] else { return };
        let FilmPrestress::Isotropic(tension) = layer.prestress else { return };
        let plain = |mode: &CableMode| matches!(mode, CableMode::Force(_));
        let weightless = layer.weight == 0.0 && structure.cables.iter().all(|cable| cable.weight == 0.0);
        let simple = weightless
            && structure.cables.iter().all(|cable| plain(&cable.mode) && cable.axial_stiffness.is_none())
            && structure.sliding.iter().all(|sliding| sliding.contact_angle.is_none())
            && structure.chambers.is_empty()
            && structure.rings.is_empty();
        if simple {
            let (film, cables) = (area.times(tension), cables.measured());
            let tolerance = (film.high - film.value) + (cables.high - cables.value);
            audit.figure("/objective_value", Measured::within(film.value + cables.value, tolerance));
        }
    }

    /// Compares the volume of each chamber between two layers.
    fn compare_chambers(&self, audit: &mut Audit) {
        let contents = audit.contents;
        let mesh = &contents.mesh;
        let layers = self.structure.layers.len();
        let mut start = vec![0];
        for k in 0..layers {
            let count = audit.stated_count(&format!("/layers/{k}/triangles"));
            start.push((start[k] + count.min(mesh.triangles.len())).min(mesh.triangles.len()));
        }
        let origin = contents.origin();
        let volume = |walls: &mut Sum, corners: [DVec3; 3], sign: f64| {
            let sides = Sides::of(corners);
            let [a, b, c] = corners.map(|p| p - origin);
            let reach = a.length().max(b.length()).max(c.length());
            let rounding = audit.step * (sides.double_area + reach * sides.perimeter()) / 2.0;
            walls.add(sign * a.dot(b.cross(c)) / 6.0, rounding);
        };
        let mut volumes = Vec::new();
        for (number, &Chamber { below, .. }) in self.structure.chambers.iter().enumerate() {
            let mut walls = Sum::default();
            for &triangle in &mesh.triangles[start[below]..start[below + 1]] {
                volume(&mut walls, corners(&mesh.vertices, triangle), 1.0);
            }
            if below + 1 < layers {
                for &triangle in &mesh.triangles[start[below + 1]..start[below + 2]] {
                    volume(&mut walls, corners(&mesh.vertices, triangle), -1.0);
                }
            } else {
                // The chamber below the last layer is closed by fans to the mean of boundary points, which the result
                // does not contain. Its volume is not compared.
                continue;
            }
            volumes.push((number, walls.measured()));
        }
        for (k, measured) in volumes {
            audit.figure(&format!("/chambers/{k}/volume"), measured);
        }
    }

    fn compare_slope(&self, audit: &mut Audit) {
        let mesh = &audit.contents.mesh;
        let mut least = Least::NONE;
        for &triangle in &mesh.triangles {
            let sides = Sides::of(corners(&mesh.vertices, triangle));
            let normal = sides.double_area_vector;
            let slope = libm::atan2(normal.cross(self.structure.up).length(), normal.dot(self.structure.up).abs());
            least.add(slope, RELATIVE + audit.step / sides.altitude());
        }
        audit.figure("/minimum_slope_deg", least.measured().times(1f64.to_degrees()));
    }
}

/// Compares the stated sums of forces with each other and with the listed reactions.
fn compare_balance(audit: &mut Audit) {
    if audit.value("/balance").is_null() {
        return;
    }
    let vector = |audit: &Audit, pointer: &str| {
        let axis = |k: usize| audit.stated(&format!("{pointer}/{k}")).unwrap_or(f64::NAN);
        DVec3::new(axis(0), axis(1), axis(2))
    };
    let [loads, reactions] = ["/balance/loads", "/balance/reactions"].map(|pointer| vector(audit, pointer));
    let magnitudes = audit.stated("/balance/magnitudes").unwrap_or(f64::NAN);
    let imbalance = (loads + reactions).length() / magnitudes.max(f64::MIN_POSITIVE);
    audit.figure("/balance/imbalance", Measured::within(imbalance, RELATIVE));
    let (mut sum, mut count) = (DVec3::ZERO, 0);
    for list in ["/reactions", "/edge_reactions"] {
        for k in 0..audit.entries(list) {
            sum += vector(audit, &format!("{list}/{k}/force"));
            count += 1;
        }
    }
    // The force that is listed for a sliding part includes the component along its support, which the support does not
    // bear.
    let unbalanced =
        audit.stated("/balance/residual_force").unwrap_or(f64::NAN) * audit.contents.mesh.vertices.len() as f64;
    let off = (sum - reactions).length();
    audit.require(
        off <= RELATIVE * magnitudes + unbalanced,
        || format!("the {count} reactions listed add up to balance/reactions"),
        || format!("{off} is missing"),
    );
}

/// Compares the forces per length along held edges with the stresses of the triangles beside them. Each triangle pulls
/// with S ν = σ₂ ν + (σ₁ - σ₂) (d · ν) d, where σ₁ and σ₂ are its principal stresses, d is the direction of σ₁, and ν
/// is the unit vector in its plane that points out of it at right angles to the edge.
fn compare_held_edges(audit: &mut Audit) {
    let contents = audit.contents;
    let Some(set) = contents.line_sets.iter().find(|set| set.name == HELD_EDGES) else { return };
    let Lines::Segments(pairs) = &set.lines else { return };
    let vertices = &contents.mesh.vertices;
    let key = |[v, w]: [u32; 2]| [v.min(w), v.max(w)];
    let mut is_on_edge = vec![false; vertices.len()];
    pairs.iter().flatten().for_each(|&v| is_on_edge[v as usize] = true);
    // Force per length of each held edge, and its tolerance.
    let mut pulls: BTreeMap<[u32; 2], (DVec3, f64)> =
        pairs.iter().map(|&pair| (key(pair), (DVec3::ZERO, 0.0))).collect();
    let stresses = ["stress_min", "stress_max", "stress_max_x", "stress_max_y", "stress_max_z"];
    let stresses = stresses.map(|name| contents.triangle_attributes.iter().find(|attribute| attribute.name == name));
    let at = |attribute: Option<&Attribute>, k: usize| {
        attribute.and_then(|attribute| attribute.values.get(k).copied()).unwrap_or(f64::NAN)
    };
    for (t, triangle) in contents.mesh.triangles.iter().enumerate() {
        for k in 0..3 {
            let [from, to, third] = [0, 1, 2].map(|i| triangle[(k + i) % 3]);
            if !is_on_edge[from as usize] || !is_on_edge[to as usize] {
                continue;
            }
            let Some((pull, tolerance)) = pulls.get_mut(&key([from, to])) else { continue };
            let [a, b, c] = [from, to, third].map(|v| vertices[v as usize]);
            let out = (a - c).reject_from(b - a).normalize_or_zero();
            let [least, most, x, y, z] = stresses.map(|attribute| at(attribute, t));
            let direction = DVec3::new(x, y, z);
            *pull += least * out + (most - least) * direction.dot(out) * direction;
            *tolerance += most.abs() * (RELATIVE + 4.0 * audit.step / Sides::of([a, b, c]).altitude());
        }
    }
    let attributes = ["force_per_length", "force_per_length_x", "force_per_length_y", "force_per_length_z"];
    let stated = attributes.map(|name| set.attributes.iter().find(|attribute| attribute.name == name));
    for (k, &pair) in pairs.iter().enumerate() {
        let (pull, tolerance) = pulls[&key(pair)];
        let measured = [pull.length(), pull.x, pull.y, pull.z];
        for (attribute, value) in stated.iter().zip(measured) {
            let own = at(*attribute, k);
            audit.attribute(|| format!("{HELD_EDGES}, segment {k}"), own, Measured::within(value, tolerance));
        }
    }
    let Some(Lines::Polylines(rims)) = contents.line_sets.first().map(|set| &set.lines) else { return };
    for k in 0..audit.entries("/edge_reactions") {
        let boundary = audit.stated_count(&format!("/edge_reactions/{k}/boundary"));
        let rim = rims.get(boundary).map_or(&[][..], |rim| &rim.vertices);
        let own = (0..rim.len()).filter_map(|i| pulls.get(&key([rim[i], rim[(i + 1) % rim.len()]])));
        let (mut least, mut most) = (Least::NONE, Largest::NONE);
        for (pull, tolerance) in own {
            least.add(pull.length(), *tolerance);
            most.add(pull.length(), *tolerance);
        }
        let pointer = format!("/edge_reactions/{k}/force_per_length");
        if !audit.value(&pointer).is_null() {
            audit.figure(&format!("{pointer}/min"), least.measured());
            audit.figure(&format!("{pointer}/max"), most.measured());
        }
    }
}

/// Returns the largest distance of a cable from the chord between its ends. Next to the vertex farthest from the chord,
/// the cable is followed by the parabola through this vertex and its two neighbours. Where rounding decides which vertex
/// is the farthest, the range has the crests of all of them.
fn sag(vertices: &[DVec3], pairs: &[[u32; 2]], step: f64) -> Measured {
    let (Some(&[first, _]), Some(&[_, last])) = (pairs.first(), pairs.last()) else {
        return Measured::within(0.0, 0.0);
    };
    let start = vertices[first as usize];
    let chord = vertices[last as usize] - start;
    let along = chord.normalize_or_zero();
    // The place along the chord and the distance from it, for each vertex in order.
    let from_chord = |v: u32| {
        let offset = vertices[v as usize] - start;
        let place = offset.dot(along);
        [place, (offset - place * along).length()]
    };
    let places: Vec<[f64; 2]> = std::iter::once(first).chain(pairs.iter().map(|&[_, v]| v)).map(from_chord).collect();
    let tolerance = RELATIVE * chord.length() + 8.0 * step;
    let farthest = places.iter().map(|place| place[1]).fold(0.0, f64::max);
    let mut crests = Measured { value: farthest, low: f64::INFINITY, high: f64::NEG_INFINITY };
    for k in (0..places.len()).filter(|&k| places[k][1] >= farthest - tolerance) {
        let crest = match k.checked_sub(1).and_then(|before| places.get(before..=k + 1)) {
            Some(&[a, b, c]) => crest(a, b, c),
            _ => places[k][1],
        };
        crests.value = crests.value.max(crest);
        crests.low = crests.low.min(crest);
        crests.high = crests.high.max(crest);
    }
    crests.widened(tolerance)
}

/// Returns the largest value of the parabola through three points, or the middle value if the points do not surround a
/// largest one.
fn crest([xa, ya]: [f64; 2], [x, y]: [f64; 2], [xc, yc]: [f64; 2]) -> f64 {
    let (left, right) = ((y - ya) / (x - xa), (yc - y) / (xc - x));
    let bend = (left - right) / (xc - xa);
    let slope = (left * (xc - x) + right * (x - xa)) / (xc - xa);
    if x > xa && xc > x && bend > 0.0 { y + slope * slope / (4.0 * bend) } else { y }
}

fn length(vertices: &[DVec3], [a, b]: [u32; 2]) -> f64 {
    vertices[a as usize].distance(vertices[b as usize])
}
