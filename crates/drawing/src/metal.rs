//! The blank of a strip of thick sheet metal: panels, the bend zones between them, and their lines.
//!
//! At a bend of angle θ both panels end before the fold line by the setback, and a zone as wide as the bend allowance
//! joins them: θ (r + k t), where the neutral line lies k t from the inner skin (ANSI), or θ (r + k t / 2) in the
//! convention of DIN 6935. Panels are moved, but never turned, because the unbent sheet is flat.

use crate::options::{Convention, Metal, Relief, Skin};
use crate::parameters::Refused;
use crate::piece::{Edge, Fold, FoldKind, Piece, Seam, Side};
use crate::polygon;
use crate::relief::{self, Fan};
use plateau_mesh::DVec2;

/// The blank of a piece.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Blank {
    /// The piece with the outline of the blank. Its folds are the lines to bend about, with the angle of each hit.
    pub piece: Piece,
    /// For each bend the lines at which its zone begins and ends.
    pub zones: Vec<[[DVec2; 2]; 2]>,
    pub bends: Vec<Bend>,
}

/// A bend of a blank.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Bend {
    /// Whole angle in degrees, above 0 for a mountain.
    pub angle_deg: f64,
    /// Number of the bridge in the mesh.
    pub bridge: u32,
    /// Number of the panel before the bend.
    pub panel: usize,
    /// The sides of the two panels at the bend, before any relief.
    pub sides: [[DVec2; 2]; 2],
}

/// Returns the bend allowance of a bend of `angle` radians: the length of the neutral line in the bend.
#[must_use]
pub fn bend_allowance(metal: &Metal, angle: f64) -> f64 {
    let (r, t) = (metal.radius, metal.thickness);
    let neutral = match metal.convention {
        Convention::Ansi => metal.k.unwrap_or(ANSI_K) * t,
        Convention::Din => metal.k.unwrap_or_else(|| din_k(r, t)) * t / 2.0,
    };
    angle * (r + neutral)
}

/// The k-factor where none is given: a common value for mild steel bent in air.
const ANSI_K: f64 = 0.44;

/// Returns the k-factor of DIN 6935.
fn din_k(radius: f64, thickness: f64) -> f64 {
    (0.65 + 0.5 * libm::log10(radius / thickness)).min(1.0)
}

/// Returns the distance from the fold line of the mesh to the end of the flat panel at a bend of this angle in degrees,
/// above 0 for a mountain.
#[must_use]
pub fn setback(metal: &Metal, angle_deg: f64) -> f64 {
    let outer = metal.radius + metal.thickness;
    let to_skin = match (metal.skin, angle_deg > 0.0) {
        (Skin::Middle, _) => metal.radius + 0.5 * metal.thickness,
        // The outer skin of a bend is the front at a mountain, and the back in a valley.
        (Skin::Front, true) | (Skin::Back, false) => outer,
        (Skin::Front, false) | (Skin::Back, true) => metal.radius,
    };
    libm::tan(0.5 * angle_deg.abs().to_radians()) * to_skin
}

/// Most hits of one bend.
const MOST_HITS: f64 = 10_000.0;

/// Returns the least number of hits of θ/n each with r (1 - cos(θ / 2n)) at most the chord error.
#[must_use]
pub fn hits(metal: &Metal, angle: f64) -> Option<usize> {
    let Some(error) = metal.chord_error else { return Some(1) };
    if metal.radius <= 0.0 || error >= metal.radius {
        return Some(1);
    }
    let half = libm::acos(1.0 - error / metal.radius);
    let needed = (angle / (2.0 * half)).ceil().max(1.0);
    if needed > MOST_HITS {
        return None;
    }
    // The quotient may be rounded to either side of a whole number.
    let is_enough = |n: f64| metal.radius * (1.0 - libm::cos(angle / (2.0 * n))) <= error;
    let needed = if needed > 1.0 && is_enough(needed - 1.0) { needed - 1.0 } else { needed };
    Some(if is_enough(needed) { needed } else { needed + 1.0 } as usize)
}

/// Largest fold that can be bent, in degrees. Beyond it the setback is many times the radius.
const SHARPEST: f64 = 175.0;

/// A flat panel between two bends or ends: its points along the two rails in the order of the strip, each with the seam
/// and the arc lengths of the edge to the next point.
struct Panel {
    chains: [Vec<(DVec2, Edge)>; 2],
}

impl Panel {
    /// Returns the first or the last point of each chain.
    fn side(&self, last: bool) -> [DVec2; 2] {
        [0, 1].map(|side| {
            let chain = &self.chains[side];
            chain[if last { chain.len() - 1 } else { 0 }].0
        })
    }
}

/// Returns the blank of a piece in millimetres.
///
/// # Errors
/// Returns [`Refused::Unsuitable`] at `radius` for a bend that is too sharp or has no room between its neighbours, at
/// `chord_error` for too many hits, and at `relief` for circles that do not fit.
pub fn blank(piece: &Piece, metal: &Metal) -> Result<Blank, Refused> {
    let Some(bridges) = piece.bridges() else {
        // A cap has no bends.
        return Ok(Blank { piece: piece.clone(), ..Blank::default() });
    };
    let first = bridges[0];
    let is_bend = |k: usize| k > 0 && k + 1 < bridges.len() && piece.folds[k - 1].kind() != FoldKind::Flat;
    let angle = |k: usize| piece.folds[k - 1].angle_deg;
    for k in (0..bridges.len()).filter(|&k| is_bend(k)) {
        if angle(k).abs() > SHARPEST {
            let bridge = piece.folds[k - 1].bridge;
            let detail = format!("the fold at bridge {bridge} is {:.2} degrees, more than {SHARPEST}", angle(k).abs());
            return Err(Refused::unsuitable("radius", detail));
        }
    }
    let setback = |k: usize| if is_bend(k) { setback(metal, angle(k)) } else { 0.0 };
    // Folds that stay flat divide no panel.
    let borders: Vec<usize> = (0..bridges.len()).filter(|&k| k == 0 || k + 1 == bridges.len() || is_bend(k)).collect();
    let mut rails = [Side::P, Side::Q].map(|side| rail_edges(piece, side, &bridges));
    let mut panels = Vec::with_capacity(borders.len() - 1);
    for pair in borders.windows(2) {
        let own = &bridges[pair[0]..=pair[1]];
        let panel = panel(own, [setback(pair[0]), setback(pair[1])], &mut rails).ok_or_else(|| {
            let names = pair.iter().filter(|&&k| is_bend(k)).map(|&k| piece.folds[k - 1].bridge.to_string());
            let detail = format!(
                "the bend zones at the bridges {} of {} leave nothing of the panel between them; give a smaller \
                 radius, or rails with fewer points",
                names.collect::<Vec<_>>().join(" and "),
                piece.name
            );
            Refused::unsuitable("radius", detail)
        })?;
        panels.push(panel);
    }
    // Displacement of each panel from its place in the piece: along the normal of every bend before it.
    let mut moves = vec![DVec2::ZERO];
    let bends = &borders[1..borders.len() - 1];
    for (number, &k) in bends.iter().enumerate() {
        let change = bend_allowance(metal, angle(k).abs().to_radians()) - 2.0 * setback(k);
        moves.push(moves[number] + across(&bridges, k) * change);
    }
    for (panel, moved) in panels.iter_mut().zip(&moves) {
        panel.chains.iter_mut().flatten().for_each(|(point, _)| *point += *moved);
    }
    let mut blank = bend_lines(piece, metal, &panels, bends)?;
    outline(&mut blank.piece, &panels, first);
    blank.piece.panels = panels.iter().flat_map(label_triangles).collect();
    blank.piece.ends = None;
    let radius = match metal.relief {
        Relief::None => None,
        Relief::Auto => Some(metal.radius + metal.thickness),
        Relief::Radius(radius) => Some(radius),
    };
    if let Some(radius) = radius {
        let fans = fans(&bridges, bends).into_iter().map(|(side, bend, between)| Fan {
            // The common point moves with each panel between the bends; the circle is around the middle.
            centre: between.clone().map(|panel| bridges[bend][side] + moves[panel]).sum::<DVec2>()
                / between.len() as f64,
            corners: between.map(|panel| panels[panel].chains[side][0].0).collect(),
        });
        relief::relieve(
            &mut blank.piece,
            &mut blank.zones,
            &fans.collect::<Vec<_>>(),
            radius,
            metal.relief == Relief::Auto,
        )?;
    }
    if polygon::crossing(&blank.piece.outline).is_some() {
        let name = &piece.name;
        return Err(Refused::unsuitable(
            "relief",
            if radius.is_some() {
                format!("the blank of {name} crosses itself; give another radius")
            } else {
                format!("bend zones of {name} overlap at a point of a rail; give relief=auto, or a smaller radius")
            },
        ));
    }
    Ok(blank)
}

/// Returns a blank with the lines and zones of the bends at these bridges, between panels in their places. Its outline
/// is still that of the piece.
fn bend_lines(piece: &Piece, metal: &Metal, panels: &[Panel], bends: &[usize]) -> Result<Blank, Refused> {
    let mut blank = Blank { piece: Piece { folds: Vec::new(), ..piece.clone() }, ..Blank::default() };
    for (number, &k) in bends.iter().enumerate() {
        let (start, end) = (panels[number].side(true), panels[number + 1].side(false));
        let (angle, bridge) = (piece.folds[k - 1].angle_deg, piece.folds[k - 1].bridge);
        let Some(count) = hits(metal, angle.abs().to_radians()) else {
            let detail = format!("makes more than {MOST_HITS} hits of the bend at bridge {bridge}");
            return Err(Refused::unsuitable("chord_error", detail));
        };
        for hit in 0..count {
            let at = (hit as f64 + 0.5) / count as f64;
            let ends = [0, 1].map(|side| start[side].lerp(end[side], at));
            blank.piece.folds.push(Fold { ends, angle_deg: angle / count as f64, bridge });
        }
        blank.zones.push([start, end]);
        blank.bends.push(Bend { angle_deg: angle, bridge, panel: 2 * number + 1, sides: [start, end] });
    }
    Ok(blank)
}

/// Returns the unit vector at right angles to a bridge that points to the panel after it.
fn across(bridges: &[[DVec2; 2]], k: usize) -> DVec2 {
    let [p, q] = bridges[k];
    let normal = (q - p).perp().normalize_or_zero();
    let [next, other] = bridges[k + 1];
    if ((next - p) + (other - q)).dot(normal) < 0.0 { -normal } else { normal }
}

/// Returns the unit vector at right angles to a bridge that points away from the panel before it.
fn across_back(bridges: &[[DVec2; 2]], k: usize) -> DVec2 {
    let [p, q] = bridges[k];
    let normal = (q - p).perp().normalize_or_zero();
    let [before, other] = bridges[k - 1];
    if ((p - before) + (q - other)).dot(normal) < 0.0 { -normal } else { normal }
}

/// Returns the seam and the arc lengths of the edges on one side, in the order of the strip.
fn rail_edges(piece: &Piece, side: Side, bridges: &[[DVec2; 2]]) -> std::vec::IntoIter<(Seam, [f64; 2])> {
    let at = usize::from(side == Side::Q);
    let own = (0..piece.edges.len()).filter(|&k| piece.edges[k].side == side);
    let mut edges: Vec<(usize, Seam, [f64; 2])> = own.map(|k| (k, piece.edges[k].seam, piece.edges[k].arc)).collect();
    let starts_first = edges.first().is_some_and(|&(k, ..)| piece.outline[k] == bridges[0][at]);
    if !starts_first {
        edges.reverse();
        edges.iter_mut().for_each(|(_, _, arc)| arc.reverse());
    }
    edges.into_iter().map(|(_, seam, arc)| (seam, arc)).collect::<Vec<_>>().into_iter()
}

/// Returns what is left of the panel between the first and the last of these bridges with these setbacks, or `None` if
/// nothing is left on a rail.
fn panel(
    bridges: &[[DVec2; 2]],
    setbacks: [f64; 2],
    rails: &mut [std::vec::IntoIter<(Seam, [f64; 2])>; 2],
) -> Option<Panel> {
    let (first, last) = (bridges[0], bridges[bridges.len() - 1]);
    // Lines through the two bridges, moved into the panel, with their normals into what is left.
    let line = |bridge: [DVec2; 2], normal: DVec2, setback: f64| (bridge[0] + normal * setback, normal);
    let lines = [
        line(first, across(bridges, 0), setbacks[0]),
        line(last, -across_back(bridges, bridges.len() - 1), setbacks[1]),
    ];
    let height = |(at, normal): (DVec2, DVec2), point: DVec2| (point - at).dot(normal);
    let mut chains: [Vec<(DVec2, Edge)>; 2] = [Vec::new(), Vec::new()];
    for side in [0, 1] {
        let mut whole: Vec<(DVec2, Edge)> = Vec::new();
        let own = [Side::P, Side::Q][side];
        for pair in bridges.windows(2).filter(|pair| pair[0][side] != pair[1][side]) {
            let (seam, arc) = rails[side].next().unwrap_or((Seam::Rail(0), [0.0; 2]));
            whole.push((pair[0][side], Edge { side: own, seam, arc }));
        }
        let end_edge = whole.last().map_or(Edge { side: own, seam: Seam::Rail(0), arc: [0.0; 2] }, |(_, edge)| Edge {
            arc: [edge.arc[1]; 2],
            ..*edge
        });
        whole.push((last[side], end_edge));
        if whole.len() == 1 {
            // Both bridges end in this point.
            let at = if setbacks == [0.0; 2] { last[side] } else { crossing_of(lines)? };
            chains[side].push((at, end_edge));
            continue;
        }
        if setbacks[0] > 0.0 {
            whole = behind(whole, |point| height(lines[0], point))?;
        }
        if setbacks[1] > 0.0 {
            whole = before(whole, |point| height(lines[1], point))?;
        }
        chains[side] = whole;
    }
    // The order along both rails is that of the piece.
    let [p, q] = &chains;
    let turned = |a: DVec2, b: DVec2, c: DVec2| (b - a).perp_dot(c - a);
    let ends = [p[0].0, p[p.len() - 1].0, q[q.len() - 1].0, q[0].0];
    let area = turned(ends[0], ends[1], ends[2]) + turned(ends[0], ends[2], ends[3]);
    let whole = turned(first[0], last[0], last[1]) + turned(first[0], last[1], first[1]);
    (area * whole > 0.0).then_some(Panel { chains })
}

/// Returns the intersection of two lines given by a point and a normal.
fn crossing_of([(one, normal), (other, second)]: [(DVec2, DVec2); 2]) -> Option<DVec2> {
    let sine = normal.perp_dot(second);
    (sine.abs() > 1e-12).then(|| {
        let along = normal.perp();
        one + along * ((other - one).dot(second) / along.dot(second))
    })
}

/// Returns the part of a chain after the first place at which a height rises above 0.
fn behind(chain: Vec<(DVec2, Edge)>, height: impl Fn(DVec2) -> f64) -> Option<Vec<(DVec2, Edge)>> {
    let k = (0..chain.len() - 1).find(|&k| height(chain[k].0) <= 0.0 && height(chain[k + 1].0) > 0.0)?;
    let (low, high) = (height(chain[k].0), height(chain[k + 1].0));
    let at = -low / (high - low);
    let (start, edge) = chain[k];
    let arc = [edge.arc[0] + (edge.arc[1] - edge.arc[0]) * at, edge.arc[1]];
    let first = (start.lerp(chain[k + 1].0, at), Edge { arc, ..edge });
    Some(std::iter::once(first).chain(chain.into_iter().skip(k + 1)).collect())
}

/// Returns the part of a chain before the last place at which a height falls below 0.
fn before(mut chain: Vec<(DVec2, Edge)>, height: impl Fn(DVec2) -> f64) -> Option<Vec<(DVec2, Edge)>> {
    let k = (0..chain.len() - 1).rev().find(|&k| height(chain[k].0) > 0.0 && height(chain[k + 1].0) <= 0.0)?;
    let (high, low) = (height(chain[k].0), height(chain[k + 1].0));
    let at = high / (high - low);
    let end = chain[k].0.lerp(chain[k + 1].0, at);
    let edge = &mut chain[k].1;
    edge.arc[1] = edge.arc[0] + (edge.arc[1] - edge.arc[0]) * at;
    let last = (end, Edge { arc: [edge.arc[1]; 2], ..*edge });
    chain.truncate(k + 1);
    chain.push(last);
    Some(chain)
}

/// Returns two triangles of a panel for texts: one at its first side, one at its last.
fn label_triangles(panel: &Panel) -> [[DVec2; 3]; 2] {
    let [first, last] = [false, true].map(|end| panel.side(end));
    let turned = |[a, b, c]: [DVec2; 3]| (b - a).perp_dot(c - a);
    let larger = |side: [DVec2; 2], other: [DVec2; 2]| {
        let triangles = other.map(|corner| [side[0], side[1], corner]);
        let [a, b, c] =
            if turned(triangles[0]).abs() >= turned(triangles[1]).abs() { triangles[0] } else { triangles[1] };
        if turned([a, b, c]) < 0.0 { [a, c, b] } else { [a, b, c] }
    };
    [larger(first, last), larger(last, first)]
}

/// Returns the points of rails in which several bends meet: the side, a bridge that ends there, and the numbers of the
/// panels between the bends.
fn fans(bridges: &[[DVec2; 2]], bends: &[usize]) -> Vec<(usize, usize, std::ops::Range<usize>)> {
    let mut fans = Vec::new();
    for side in [0, 1] {
        let mut number = 0;
        for group in bends.chunk_by(|&one, &next| bridges[one][side] == bridges[next][side]) {
            if group.len() > 1 {
                fans.push((side, group[0], number + 1..number + group.len()));
            }
            number += group.len();
        }
    }
    fans
}

/// Replaces the outline of a piece by that of its panels and the zones between them.
fn outline(piece: &mut Piece, panels: &[Panel], first: [DVec2; 2]) {
    let end_edges: Vec<Edge> = piece.edges.iter().filter(|edge| edge.side == Side::End).copied().collect();
    let is_first = |edge: &&Edge| {
        let k = piece.edges.iter().position(|own| own == *edge).unwrap_or_default();
        let ends = [piece.outline[k], piece.outline[(k + 1) % piece.outline.len()]];
        ends.contains(&first[0]) && ends.contains(&first[1])
    };
    let first_end = end_edges.iter().find(is_first).copied();
    let last_end = end_edges.iter().find(|edge| Some(**edge) != first_end).copied();
    let mut chains: [Vec<(DVec2, Edge)>; 2] = [Vec::new(), Vec::new()];
    for (side, chain) in chains.iter_mut().enumerate() {
        for &(point, edge) in panels.iter().flat_map(|panel| &panel.chains[side]) {
            match chain.last_mut() {
                Some((at, before)) if *at == point => *before = edge,
                _ => chain.push((point, edge)),
            }
        }
    }
    let [mut p, q] = chains;
    // Along P, over the last bridge, back along Q, over the first bridge.
    if let (Some(end), Some(at)) = (last_end, p.last_mut()) {
        at.1 = Edge { arc: [end.arc[0].min(end.arc[1]), end.arc[0].max(end.arc[1])], ..end };
    }
    let mut back: Vec<(DVec2, Edge)> = Vec::with_capacity(q.len());
    for k in (0..q.len()).rev() {
        let edge = match k.checked_sub(1).map(|before| q[before].1) {
            Some(edge) => Edge { arc: [edge.arc[1], edge.arc[0]], ..edge },
            None => first_end.map_or(q[0].1, |end| Edge { arc: [end.arc[0].max(end.arc[1]), 0.0], ..end }),
        };
        back.push((q[k].0, edge));
    }
    p.extend(back);
    (piece.outline, piece.edges) = p.into_iter().unzip();
    if polygon::area(&piece.outline) < 0.0 {
        piece.reverse();
    }
}
