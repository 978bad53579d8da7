//! A piece as it is drawn: shapes on layers, in millimetres, with y up.

use crate::columns::Columns;
use crate::label::{self, Spot};
use crate::metal::{self, Bend};
use crate::options::{Allowances, Layer, PatternOptions, Profile, Rotate};
use crate::parameters::Refused;
use crate::piece::{Edge, Fold, FoldKind, Piece, Seam, Side, bounds};
use crate::polygon::{self, NOTCH_DEPTH, NOTCH_HALF_WIDTH};
use plateau_mesh::DVec2;
use std::collections::{BTreeMap, BTreeSet};

/// A part of a drawing.
#[derive(Clone, Debug, PartialEq)]
pub enum Shape {
    /// A closed polygon.
    Polygon { layer: Layer, points: Vec<DVec2> },
    /// A straight line. Bend and fold lines have their angle in degrees.
    Line { layer: Layer, ends: [DVec2; 2], angle_deg: Option<f64> },
    /// A text around its middle.
    Text { layer: Layer, text: String, spot: Spot },
}

impl Shape {
    pub(crate) fn moved(&self, place: impl Fn(DVec2) -> DVec2) -> Self {
        self.placed(place, false)
    }

    /// Returns the shape moved by `place`, which also turns it counter-clockwise by 90 degrees if `is_turned`.
    pub(crate) fn placed(&self, place: impl Fn(DVec2) -> DVec2, is_turned: bool) -> Self {
        match self {
            Self::Polygon { layer, points } => {
                Self::Polygon { layer: *layer, points: points.iter().map(|&point| place(point)).collect() }
            }
            Self::Line { layer, ends, angle_deg } => {
                Self::Line { layer: *layer, ends: ends.map(place), angle_deg: *angle_deg }
            }
            Self::Text { layer, text, spot } => {
                let direction = if is_turned { label::readable(spot.direction.perp()) } else { spot.direction };
                let spot = Spot { at: place(spot.at), direction, ..*spot };
                Self::Text { layer: *layer, text: text.clone(), spot }
            }
        }
    }

    /// Adds the points that bound the shape.
    pub(crate) fn extent(&self, points: &mut Vec<DVec2>) {
        match self {
            Self::Polygon { points: own, .. } => points.extend(own),
            Self::Line { ends, .. } => points.extend(ends),
            Self::Text { text, spot, .. } => points.extend(label::corners(spot, text)),
        }
    }
}

/// A mark at a place of a seam. Both pieces at the seam have it.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Mark {
    pub at: DVec2,
    pub seam: Seam,
    pub arc_length: f64,
    /// Edge of the outline, and whether the mark is too near to a corner of the piece for a notch.
    edge: usize,
    at_corner: bool,
}

/// A fold or a bend of a figure.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct FoldLine {
    pub layer: Layer,
    pub ends: [DVec2; 2],
    pub angle_deg: f64,
    pub bridge: u32,
}

/// A piece with everything that is drawn of it.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Figure {
    pub name: String,
    /// Contour to cut.
    pub cut: Vec<DVec2>,
    /// The outline without allowances, if there are any.
    pub sew: Option<Vec<DVec2>>,
    pub lines: Vec<FoldLine>,
    pub marks: Vec<Mark>,
    pub shapes: Vec<Shape>,
}

/// Most marks of a pattern, and most texts. Files with more are not read by any machine or person.
pub const MOST_MARKS: usize = 20_000;

impl Figure {
    /// Returns the corners of the bounding box of the cut.
    #[must_use]
    pub fn bounds(&self) -> [DVec2; 2] {
        bounds(&self.cut)
    }

    /// Returns the number of bends. A bend of several hits counts once.
    #[must_use]
    pub fn bends(&self) -> usize {
        let mut bridges: Vec<u32> =
            self.lines.iter().filter(|line| line.layer != Layer::FoldFlat).map(|line| line.bridge).collect();
        bridges.dedup();
        bridges.len()
    }
}

/// Returns the figures of all pieces, which are in millimetres.
///
/// # Errors
/// Returns [`Refused::Unsuitable`] if the options do not suit the pieces.
pub fn figures(pieces: &[Piece], options: &PatternOptions) -> Result<Vec<Figure>, Refused> {
    if let Some(spacing) = options.notches {
        let lengths = pieces.iter().flat_map(|piece| &piece.edges).map(|edge| (edge.arc[1] - edge.arc[0]).abs());
        let count = lengths.sum::<f64>() / spacing;
        if count > MOST_MARKS as f64 {
            let detail = format!("makes {count:.0} notches, more than {MOST_MARKS}");
            return Err(Refused::unsuitable("notches", detail));
        }
    }
    let texts: usize = pieces.iter().map(|piece| piece.folds.len()).sum();
    if options.angles && texts > MOST_MARKS {
        return Err(Refused::unsuitable("angles", format!("makes {texts} texts, more than {MOST_MARKS}")));
    }
    // Bridges at which two pieces were one.
    let mut at_bridges: BTreeMap<u32, BTreeSet<usize>> = BTreeMap::new();
    for (number, piece) in pieces.iter().enumerate() {
        for edge in &piece.edges {
            if let Seam::Bridge(bridge) = edge.seam {
                at_bridges.entry(bridge).or_default().insert(number);
            }
        }
    }
    let mates = at_bridges.into_iter().filter(|(_, pieces)| pieces.len() > 1).map(|(bridge, _)| bridge).collect();
    let mut figures: Vec<Figure> = Vec::with_capacity(pieces.len());
    let mut bends = 0;
    for piece in pieces {
        let figure = figure(piece, &mates, bends, options)?;
        bends += figure.bends();
        figures.push(figure);
    }
    Ok(figures)
}

/// Returns the figure of a piece. Its bends count from `first_bend`, as in the bend table.
fn figure(
    piece: &Piece,
    mates: &BTreeSet<u32>,
    first_bend: usize,
    options: &PatternOptions,
) -> Result<Figure, Refused> {
    if piece.overlaps && options.profile != Profile::Plain {
        let detail = format!("{} overlaps itself when it lies flat; name a bridge that divides it", piece.name);
        return Err(Refused::unsuitable("cut_at", detail));
    }
    let blank = options.metal.as_ref().map(|metal| metal::blank(piece, metal)).transpose()?;
    let piece = blank.as_ref().map_or(piece, |blank| &blank.piece);
    let marks = options.notches.map_or_else(Vec::new, |spacing| marks(piece, spacing));
    let (cut, sew) = contour(piece, &marks, options)?;
    let mut figure = Figure { name: piece.name.clone(), sew, marks, ..Figure::default() };
    let layer = |fold: &Fold| match (fold.kind(), blank.is_some()) {
        (FoldKind::Mountain, false) => Layer::FoldMountain,
        (FoldKind::Valley, false) => Layer::FoldValley,
        (FoldKind::Flat, false) => Layer::FoldFlat,
        // A hit may turn the sheet by less than a fold that counts as flat.
        (_, true) if fold.angle_deg < 0.0 => Layer::BendUp,
        (_, true) => Layer::BendDown,
    };
    let line =
        |fold: &Fold| FoldLine { layer: layer(fold), ends: fold.ends, angle_deg: fold.angle_deg, bridge: fold.bridge };
    figure.lines = piece.folds.iter().map(line).collect();
    figure.shapes.push(Shape::Polygon { layer: Layer::Cut, points: cut.clone() });
    figure.cut = cut;
    if options.profile == Profile::Cut {
        return Ok(figure);
    }
    if let Some(sew) = &figure.sew {
        figure.shapes.push(Shape::Polygon { layer: Layer::Sew, points: sew.clone() });
    }
    for line in &figure.lines {
        figure.shapes.push(Shape::Line { layer: line.layer, ends: line.ends, angle_deg: Some(line.angle_deg) });
    }
    for &ends in blank.iter().flat_map(|blank| &blank.zones).flatten() {
        figure.shapes.push(Shape::Line { layer: Layer::BendZone, ends, angle_deg: None });
    }
    let outline = &piece.outline;
    let notches: Vec<[DVec2; 2]> =
        figure.marks.iter().map(|mark| notch(outline, mark, piece, &options.allowances)).collect();
    for &ends in &notches {
        figure.shapes.push(Shape::Line { layer: Layer::Notch, ends, angle_deg: None });
    }
    let labels: Vec<Label> = match &blank {
        Some(blank) => (first_bend..).zip(&blank.bends).map(Label::of_bend).collect(),
        None => piece.folds.iter().enumerate().map(Label::of_fold).collect(),
    };
    // The circles of reliefs cut into the panels, and so may notches.
    let count = outline.len();
    let mut obstacles = notches;
    if blank.is_some() {
        obstacles.extend((0..count).map(|k| [outline[k], outline[(k + 1) % count]]));
    }
    let is_astm = options.profile == Profile::Astm;
    let has_grain = is_astm || options.stock.is_some_and(|stock| stock.rotate == Rotate::Half);
    if let Some(ends) = grain(&figure.cut).filter(|_| has_grain) {
        obstacles.push(ends);
        figure.shapes.push(Shape::Line { layer: Layer::Grain, ends, angle_deg: None });
    }
    let labels: Vec<Label> =
        labels.into_iter().filter(|_| options.angles).chain(Label::of_mates(piece, mates)).collect();
    let texts = texts(piece, &figure, &obstacles, &labels, options);
    figure.shapes.extend(texts);
    Ok(figure)
}

/// A text at a line of a piece: the angle of a fold or of a bend, or the number of a bridge at which the piece was cut.
struct Label {
    text: String,
    /// Numbers of the panels before and after the fold.
    panels: [usize; 2],
    /// The side of each panel that runs along the fold.
    sides: [[DVec2; 2]; 2],
}

impl Label {
    fn of_fold((panel, fold): (usize, &Fold)) -> Self {
        Self { text: printed_angle(fold.angle_deg), panels: [panel, panel + 1], sides: [fold.ends; 2] }
    }

    fn of_bend((number, bend): (usize, &Bend)) -> Self {
        let text = format!("{number}: {}", printed_angle(bend.angle_deg));
        Self { text, panels: [bend.panel, bend.panel + 1], sides: bend.sides }
    }

    /// Returns the numbers of the bridges at the ends of a piece that another piece has too.
    fn of_mates(piece: &Piece, mates: &BTreeSet<u32>) -> Vec<Self> {
        let count = piece.outline.len();
        let label = |(k, edge): (usize, &Edge)| {
            let Seam::Bridge(bridge) = edge.seam else { return None };
            let side = [piece.outline[k], piece.outline[(k + 1) % count]];
            let has_side = |panel: &[DVec2; 3]| side.iter().all(|end| panel.contains(end));
            let panel = piece.panels.iter().position(has_side).unwrap_or(piece.panels.len());
            mates.contains(&bridge).then(|| Self {
                text: format!("bridge {bridge}"),
                panels: [panel; 2],
                sides: [side; 2],
            })
        };
        piece.edges.iter().enumerate().filter_map(label).collect()
    }
}

fn allowance(side: Side, allowances: &Allowances) -> f64 {
    match side {
        Side::P => allowances.p,
        Side::Q => allowances.q,
        Side::End => allowances.ends,
    }
}

/// Returns the marks at multiples of `spacing` along every seam of a piece.
fn marks(piece: &Piece, spacing: f64) -> Vec<Mark> {
    let count = piece.outline.len();
    let mut marks = Vec::new();
    // Distances along the outline from the last corner of the piece, and to the next one.
    let lengths: Vec<f64> = piece.edges.iter().map(|edge| (edge.arc[1] - edge.arc[0]).abs()).collect();
    let starts_chain = |k: usize| piece.edges[k].side != piece.edges[(k + count - 1) % count].side;
    let first = (0..count).find(|&k| starts_chain(k));
    let (mut from_corner, mut to_corner) = (vec![f64::INFINITY; count], vec![f64::INFINITY; count]);
    if let Some(first) = first {
        let mut along = 0.0;
        for k in (first..first + count).map(|k| k % count) {
            along = if starts_chain(k) { 0.0 } else { along };
            from_corner[k] = along;
            along += lengths[k];
        }
        along = 0.0;
        for k in (first..first + count).rev().map(|k| k % count) {
            to_corner[k] = along;
            along = if starts_chain(k) { 0.0 } else { along + lengths[k] };
        }
    }
    for (k, edge) in piece.edges.iter().enumerate() {
        let [from, to] = edge.arc;
        let (low, high) = (from.min(to), from.max(to));
        // Each place belongs to the edge that it ends or lies on, so that both pieces have the same places.
        let numbers = (low / spacing).floor() as u64 + 1..=(high / spacing).floor() as u64;
        let mut own: Vec<Mark> = numbers
            .map(|number| {
                let arc_length = number as f64 * spacing;
                let fraction = ((arc_length - from) / (to - from)).clamp(0.0, 1.0);
                let along = fraction * lengths[k];
                let corner = (from_corner[k] + along).min(to_corner[k] + lengths[k] - along);
                Mark {
                    at: piece.outline[k].lerp(piece.outline[(k + 1) % count], fraction),
                    seam: edge.seam,
                    arc_length,
                    edge: k,
                    at_corner: corner < NOTCH_HALF_WIDTH,
                }
            })
            .collect();
        if from > to {
            own.reverse();
        }
        marks.extend(own);
    }
    marks
}

/// Returns the depth of a notch on a side with this allowance: it ends at the sewing line.
fn depth(allowance: f64) -> f64 {
    if allowance > 0.0 { allowance.min(NOTCH_DEPTH) } else { NOTCH_DEPTH }
}

/// Returns the contour to cut, and the outline if the contour lies outside it.
pub(crate) fn contour(
    piece: &Piece,
    marks: &[Mark],
    options: &PatternOptions,
) -> Result<(Vec<DVec2>, Option<Vec<DVec2>>), Refused> {
    let distances: Vec<f64> = piece.edges.iter().map(|edge| allowance(edge.side, &options.allowances)).collect();
    let has_allowance = distances.iter().any(|&distance| distance > 0.0);
    let refuse = |parameter: &str, reason: &str| {
        Err(Refused::unsuitable(parameter, format!("the cut of {} {reason}", piece.name)))
    };
    let Some((mut cut, edges)) = polygon::offset(&piece.outline, &distances) else {
        return refuse("allowance", "vanishes");
    };
    if has_allowance && !piece.overlaps && polygon::crossing(&cut).is_some() {
        return refuse("allowance", "crosses itself; give a smaller allowance");
    }
    let sew = has_allowance.then(|| piece.outline.clone());
    if options.profile == Profile::Cut {
        let places = places(&cut, &edges, marks, piece, &options.allowances);
        if !places.is_empty() {
            cut = match polygon::notched(&cut, &places, NOTCH_HALF_WIDTH) {
                Ok(cut) => cut,
                Err(_) => return refuse("notches", "has no room for them: a notch is 2 mm wide"),
            };
            if polygon::crossing(&cut).is_some() {
                return refuse("notches", "is too narrow for notches of 3 mm");
            }
        }
    }
    if options.kerf > 0.0 {
        let half = vec![0.5 * options.kerf; cut.len()];
        let notches = if options.profile == Profile::Cut { marks.len() } else { 0 };
        match polygon::offset(&cut, &half) {
            Some((moved, _)) if notches > 0 && moved.len() < cut.len() => {
                return refuse("kerf", "closes a notch or an edge; give a smaller kerf");
            }
            Some((moved, _)) if piece.overlaps || polygon::crossing(&moved).is_none() => cut = moved,
            _ => return refuse("kerf", "crosses itself; give a smaller kerf"),
        }
    }
    Ok((cut, sew))
}

/// Returns the places of notches on a contour whose edges lie outside those of the outline.
fn places(
    cut: &[DVec2],
    edges: &[usize],
    marks: &[Mark],
    piece: &Piece,
    allowances: &Allowances,
) -> Vec<polygon::Notch> {
    let mut places: Vec<polygon::Notch> = Vec::with_capacity(marks.len());
    // Edges of the contour by the edge of the outline that they belong to.
    let mut by_edge: Vec<(usize, usize)> = edges.iter().copied().enumerate().map(|(k, edge)| (edge, k)).collect();
    by_edge.sort_unstable();
    for mark in marks.iter().filter(|mark| !mark.at_corner) {
        let [from, to] = [mark.edge, mark.edge + 1].map(|edge| by_edge.partition_point(|(own, _)| *own < edge));
        // An edge of the outline that vanished has none on the contour; a neighbour takes its marks.
        let around = if from < to { from..to } else { from.saturating_sub(1)..(from + 1).min(by_edge.len()) };
        let candidates = by_edge[around].iter().map(|&(_, k)| k);
        let nearest = candidates.map(|k| {
            let (a, b) = (cut[k], cut[(k + 1) % cut.len()]);
            let fraction = ((mark.at - a).dot(b - a) / (b - a).length_squared()).clamp(0.0, 1.0);
            (mark.at.distance(a.lerp(b, fraction)), k, fraction)
        });
        let found = nearest.min_by(|one, other| one.0.total_cmp(&other.0));
        if let Some((_, edge, fraction)) = found {
            let depth = depth(allowance(piece.edges[mark.edge].side, allowances));
            places.push(polygon::Notch { edge, fraction, depth });
        }
    }
    places.sort_by(|one, other| one.edge.cmp(&other.edge).then(one.fraction.total_cmp(&other.fraction)));
    places
}

/// Returns the line of a notch: from the contour to the sewing line, or into the piece where there is no allowance.
fn notch(outline: &[DVec2], mark: &Mark, piece: &Piece, allowances: &Allowances) -> [DVec2; 2] {
    let direction = (outline[(mark.edge + 1) % outline.len()] - outline[mark.edge]).normalize_or_zero();
    let inwards = direction.perp();
    let distance = allowance(piece.edges[mark.edge].side, allowances);
    if distance > 0.0 {
        let outer = mark.at - inwards * distance;
        [outer, outer + inwards * depth(distance)]
    } else {
        [mark.at, mark.at + inwards * NOTCH_DEPTH]
    }
}

/// Returns an angle as it is printed: with two digits after the point.
pub(crate) fn printed_angle(angle_deg: f64) -> String {
    let text = format!("{angle_deg:.2}");
    if text == "-0.00" { "0.00".into() } else { text }
}

/// Returns the name of a piece and the angles of its folds, inside the piece where a text fits, otherwise beside it.
fn texts(
    piece: &Piece,
    figure: &Figure,
    obstacles: &[[DVec2; 2]],
    labels: &[Label],
    options: &PatternOptions,
) -> Vec<Shape> {
    let least = label::least_inside(options.text_height);
    let columns = Columns::new(obstacles.iter().map(|[from, to]| [from.x.min(to.x), from.x.max(to.x)]));
    let clear = |spot: &Spot, text: &str| {
        let corners = label::corners(spot, text);
        let [low, high] = bounds(&corners);
        let mut near = columns.near(low.x, high.x).map(|number| obstacles[number]);
        !near.any(|[from, to]| crosses_box(&corners, from, to))
    };
    let mut shapes = Vec::new();
    let mut taken = vec![false; piece.panels.len()];
    // A panel of sheet metal has two triangles, which overlap, and room for one text.
    let take = |taken: &mut [bool], panel: usize| {
        taken[panel] = true;
        if let Some(other) = taken.get_mut(panel ^ 1).filter(|_| options.metal.is_some()) {
            *other = true;
        }
    };
    let mut put = |text: &str, spot: Spot| shapes.push(Shape::Text { layer: Layer::Text, text: text.into(), spot });
    let spots = piece.panels.iter().enumerate().filter_map(|(k, &panel)| {
        let spot = label::inside(panel, None, &piece.name, options.text_height)?;
        (spot.height >= least && clear(&spot, &piece.name)).then_some((k, spot))
    });
    // Of panels with room for the whole height the largest has the name.
    let area = |k: usize| {
        let [a, b, c] = piece.panels[k];
        (b - a).perp_dot(c - a)
    };
    let is_better =
        |one: &(usize, Spot), other: &(usize, Spot)| (one.1.height, area(one.0)) > (other.1.height, area(other.0));
    let name = spots.reduce(|best, spot| if is_better(&spot, &best) { spot } else { best }).map(|(k, spot)| {
        take(&mut taken, k);
        spot
    });
    if let Some(spot) = name {
        put(&piece.name, spot);
    }
    let mut beside: Vec<(DVec2, String)> = Vec::new();
    for label in labels {
        let text = &label.text;
        let free = |&(panel, _): &(usize, [DVec2; 2])| panel < taken.len() && !taken[panel];
        let beside_fold = label.panels.into_iter().zip(label.sides).filter(free);
        let spots = beside_fold.filter_map(|(panel, own)| {
            let corners = piece.panels[panel];
            let side = (0..3).find(|&side| {
                let ends = [corners[side], corners[(side + 1) % 3]];
                ends == own || ends == [own[1], own[0]]
            })?;
            let spot = label::inside(corners, Some(side), text, options.text_height)?;
            (spot.height >= least && clear(&spot, text)).then_some((panel, spot))
        });
        let best = spots.reduce(|best, spot| if spot.1.height > best.1.height { spot } else { best });
        match best {
            Some((panel, spot)) => {
                take(&mut taken, panel);
                put(text, spot);
            }
            // Cloth has no leaders, so that the number of a bridge stands at its edge, also across folds.
            None if options.profile == Profile::Astm && label.panels[0] == label.panels[1] => {
                put(text, at_edge(label.sides[0], &figure.cut, text, options.text_height));
            }
            None => {
                // The texts beside a piece stand above it, so that the leader starts at the upper end.
                let [p, q] = [0, 1].map(|end| label.sides[0][end].midpoint(label.sides[1][end]));
                beside.push((if p.y > q.y { p } else { q }, text.clone()));
            }
        }
    }
    shapes.extend(texts_beside(piece, figure, beside, name.is_none(), options));
    shapes
}

/// Returns the place of a text along the middle of an edge, inside the piece. It is no longer than the edge.
fn at_edge([from, to]: [DVec2; 2], cut: &[DVec2], text: &str, height: f64) -> Spot {
    let height = height.min(0.8 * from.distance(to) / label::width(text, 1.0));
    let middle = from.midpoint(to);
    let inwards = (to - from).perp().normalize_or_zero() * (0.8 * height);
    let at = if polygon::contains(cut, middle + inwards) { middle + inwards } else { middle - inwards };
    Spot::amid(at, label::readable((to - from).normalize_or_zero()), height)
}

/// Returns the texts that do not fit into a piece: angles with the ends of their folds, and the name.
fn texts_beside(
    piece: &Piece,
    figure: &Figure,
    mut beside: Vec<(DVec2, String)>,
    has_name: bool,
    options: &PatternOptions,
) -> Vec<Shape> {
    let mut shapes = Vec::new();
    let [low, high] = figure.bounds();
    let height = options.text_height;
    // Angles that do not fit stand above the piece, upright, each with a leader to the upper end of its fold.
    beside.sort_by(|one, other| one.0.x.total_cmp(&other.0.x));
    let upright = label::height_beside(beside.len(), high.x - low.x, height);
    let columns = label::spread(&beside.iter().map(|(at, _)| at.x).collect::<Vec<_>>(), upright);
    let row = high.y + 2.0 * height;
    let mut top = row;
    for ((end, text), column) in beside.iter().zip(columns) {
        let length = label::width(text, upright);
        let foot = DVec2::new(column, row);
        let spot = Spot::amid(foot + DVec2::new(0.0, 0.5 * length + 0.5 * upright), DVec2::Y, upright);
        shapes.push(Shape::Line { layer: Layer::Mark, ends: [*end, foot], angle_deg: None });
        shapes.push(Shape::Text { layer: Layer::Text, text: text.clone(), spot });
        top = top.max(foot.y + length + upright);
    }
    if has_name {
        // The leader ends in the middle of the largest panel.
        let area = |panel: &[DVec2; 3]| (panel[1] - panel[0]).perp_dot(panel[2] - panel[0]);
        let largest = piece.panels.iter().max_by(|one, other| area(one).total_cmp(&area(other)));
        let target = largest.map_or(low.midpoint(high), |[a, b, c]| (*a + *b + *c) / 3.0);
        let half = 0.5 * label::width(&piece.name, height);
        let at = DVec2::new(low.x + half, top + 2.0 * height);
        let spot = Spot::amid(at, DVec2::X, height);
        let start = DVec2::new(target.x.clamp(at.x - half, at.x + half), at.y - 0.8 * height);
        shapes.push(Shape::Line { layer: Layer::Mark, ends: [start, target], angle_deg: None });
        shapes.push(Shape::Text { layer: Layer::Text, text: piece.name.clone(), spot });
    }
    shapes
}

/// Number of heights at which a grain line is tried.
const GRAIN_HEIGHTS: usize = 9;

/// Returns a line along x inside a polygon: the middle half of its longest chord among some heights.
fn grain(cut: &[DVec2]) -> Option<[DVec2; 2]> {
    let [low, high] = bounds(cut);
    let chords = (1..=GRAIN_HEIGHTS).flat_map(|k| {
        let y = low.y + (high.y - low.y) * k as f64 / (GRAIN_HEIGHTS + 1) as f64;
        polygon::chords(cut, y).into_iter().map(move |chord| chord.map(|x| DVec2::new(x, y)))
    });
    let length = |[from, to]: [DVec2; 2]| to.x - from.x;
    let longest = chords.reduce(|best, chord| if length(chord) > length(best) { chord } else { best })?;
    Some([0.25, 0.75].map(|at| longest[0].lerp(longest[1], at)))
}

/// Whether a segment meets a convex box.
pub(crate) fn crosses_box(corners: &[DVec2; 4], from: DVec2, to: DVec2) -> bool {
    let axes = [corners[1] - corners[0], corners[2] - corners[1], (to - from).perp()];
    axes.iter().all(|axis| {
        let span = |points: &[DVec2]| {
            points
                .iter()
                .map(|point| point.dot(*axis))
                .fold((f64::INFINITY, f64::NEG_INFINITY), |(low, high), at| (low.min(at), high.max(at)))
        };
        let ((low, high), (other_low, other_high)) = (span(corners), span(&[from, to]));
        low <= other_high && other_low <= high
    })
}
