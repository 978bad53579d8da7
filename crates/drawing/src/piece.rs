//! The flat pattern of a ruled surface: pieces with the outline to cut and the lines to fold.
//!
//! A strip of triangles unrolls isometrically, so each strip, or each part of a strip that is cut at bridges, is one
//! [`Piece`] in its own plane. A flat cap is a piece without folds. Every piece shows the front of the surface, the
//! side that the normals of the mesh point to.

use plateau_archive::Contents;
use plateau_archive::archive::{bridges_of, is_closed, strips_of};
use plateau_mesh::error::{Error, Place};
use plateau_mesh::measure::{self, double_area_vector};
use plateau_mesh::plane::frame::Frame;
use plateau_mesh::{DVec2, DVec3, Execution, Mesh};
use plateau_ruled_surface::{FlatPattern, FlatStrip};

/// All pieces of a ruled surface. Coordinates are in the client's unit.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Pattern {
    pub pieces: Vec<Piece>,
}

/// A piece in the plane.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Piece {
    /// Text printed on the piece, such as `strip 1`.
    pub name: String,
    /// Contour: a closed polygon of at least three points that runs counter-clockwise and does not repeat its first
    /// point.
    pub outline: Vec<DVec2>,
    /// For each point of the outline the edge that starts there.
    pub edges: Vec<Edge>,
    /// Fold lines: the bridges except the first and the last of the piece.
    pub folds: Vec<Fold>,
    /// Triangles of the piece in the order of the bridges, whose sides are the folds and the outline. A text that lies
    /// within one of them is clear of every line.
    pub panels: Vec<[DVec2; 3]>,
    /// The first and the last bridge of a strip, each with its ends on the first and on the second rail. A cap has
    /// none.
    pub ends: Option<[[DVec2; 2]; 2]>,
    /// Whether two triangles overlap in the plane.
    pub overlaps: bool,
}

/// A fold line across a piece.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Fold {
    /// The ends on the first and on the second rail.
    pub ends: [DVec2; 2],
    /// Fold angle in degrees, in [-180, 180]. A positive angle is a mountain (a ridge, seen from the side that the
    /// surface's normals point to), a negative angle is a valley, and zero stays flat.
    pub angle_deg: f64,
    /// Number of the bridge in the mesh, from 0.
    pub bridge: u32,
}

/// Side of a piece that an edge of the outline belongs to.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Side {
    /// The first rail.
    P,
    /// The second rail.
    Q,
    /// A bridge at an end of the piece.
    End,
}

/// An edge of a piece's outline.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Edge {
    pub side: Side,
    pub seam: Seam,
    /// Arc length along the seam at the start and at the end of the edge, in the client's unit.
    pub arc: [f64; 2],
}

/// A line in space at which two pieces meet, or at which the surface ends.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord)]
pub enum Seam {
    /// A rail, counted from 0. Arc lengths start at its vertex with the lowest number.
    Rail(u32),
    /// A bridge with this number. Arc lengths start at the first rail.
    Bridge(u32),
}

/// Kind of a fold. The line types and layers of the files depend on it.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum FoldKind {
    Mountain,
    Valley,
    Flat,
}

impl Fold {
    /// Returns the kind. Folds below a hundredth of a degree count as flat, because no bending brake resolves them.
    #[must_use]
    pub fn kind(&self) -> FoldKind {
        match self.angle_deg {
            angle if angle >= 0.01 => FoldKind::Mountain,
            angle if angle <= -0.01 => FoldKind::Valley,
            _ => FoldKind::Flat,
        }
    }
}

impl Piece {
    /// Returns the smallest and largest coordinates of the outline.
    #[must_use]
    pub fn bounds(&self) -> [DVec2; 2] {
        bounds(&self.outline)
    }

    /// Returns the piece in another unit.
    pub(crate) fn scaled(mut self, factor: f64) -> Self {
        self.move_points(|point| point * factor);
        self.edges.iter_mut().for_each(|edge| edge.arc = edge.arc.map(|arc| arc * factor));
        self
    }

    /// Returns the bridges of a strip in order, from its first end to its last.
    pub(crate) fn bridges(&self) -> Option<Vec<[DVec2; 2]>> {
        let [first, last] = self.ends?;
        Some(std::iter::once(first).chain(self.folds.iter().map(|fold| fold.ends)).chain([last]).collect())
    }

    /// Returns the part between two of its `bridges`, turned as a piece of its own would be, to measure it. The part
    /// has no panels, and its seams are not those of the surface.
    pub(crate) fn part(&self, bridges: &[[DVec2; 2]], from: usize, to: usize) -> Self {
        let own = &bridges[from..=to];
        let middle = |[p, q]: [DVec2; 2]| p.midpoint(q);
        let along = (middle(own[own.len() - 1]) - middle(own[0])).try_normalize().unwrap_or(DVec2::X);
        let chain = |side: usize| {
            let mut points: Vec<DVec2> = own.iter().map(|bridge| bridge[side]).collect();
            points.dedup();
            points
        };
        let [p, q] = [chain(0), chain(1)];
        let edge = |side: Side, seam: Seam| Edge { side, seam, arc: [0.0; 2] };
        let mut edges = vec![edge(Side::P, Seam::Rail(0)); p.len() - 1];
        // The two ends differ, so that a blank can tell which is which.
        edges.push(edge(Side::End, Seam::Bridge(1)));
        edges.extend(vec![edge(Side::Q, Seam::Rail(0)); q.len() - 1]);
        edges.push(edge(Side::End, Seam::Bridge(0)));
        let mut part = Self {
            name: self.name.clone(),
            outline: p.into_iter().chain(q.into_iter().rev()).collect(),
            edges,
            folds: self.folds[from..to - 1].to_vec(),
            panels: Vec::new(),
            ends: Some([own[0], own[own.len() - 1]]),
            overlaps: false,
        };
        part.move_points(|point| DVec2::new(point.dot(along), along.perp_dot(point)));
        if crate::polygon::area(&part.outline) < 0.0 {
            part.reverse();
        }
        part
    }

    fn move_points(&mut self, place: impl Fn(DVec2) -> DVec2) {
        self.outline.iter_mut().for_each(|point| *point = place(*point));
        self.folds.iter_mut().for_each(|fold| fold.ends = fold.ends.map(&place));
        self.panels.iter_mut().for_each(|panel| *panel = panel.map(&place));
        self.ends = self.ends.map(|ends| ends.map(|bridge| bridge.map(&place)));
    }

    /// Lets the outline run the other way round.
    pub(crate) fn reverse(&mut self) {
        self.outline.reverse();
        // The edge that ended at a point starts there in the new order.
        let last = self.edges.pop();
        self.edges.reverse();
        self.edges.extend(last);
        self.edges.iter_mut().for_each(|edge| edge.arc.reverse());
    }
}

/// Returns the smallest and largest coordinates of points.
pub(crate) fn bounds(points: &[DVec2]) -> [DVec2; 2] {
    points.iter().fold([DVec2::INFINITY, DVec2::NEG_INFINITY], |[low, high], &point| [low.min(point), high.max(point)])
}

/// Layout of all pieces. The origin is the lower left corner, and y points up.
#[derive(Clone, Debug, PartialEq)]
pub struct Sheet {
    pub pieces: Vec<Piece>,
    pub size: DVec2,
}

impl Pattern {
    /// Returns the flat pattern of a stored result. Strips are cut at the bridges `cut_at`, which are counted over all
    /// strips from 0; a closed strip that none of them belongs to is cut at its bridge of least fold.
    ///
    /// # Errors
    /// Returns [`Missing::Surface`] unless the result is a ruled surface, and [`Missing::Bridge`] if a number names no
    /// bridge at which a strip can be cut.
    pub fn of(contents: &Contents, cut_at: &[u32]) -> Result<Self, Missing> {
        let bridges = bridges_of(contents).filter(|_| contents.unrolls).ok_or(Missing::Surface)?;
        let vertices = &contents.mesh.vertices;
        let closed = is_closed(contents);
        let execution = Execution::default();
        let flat = FlatPattern::of_bridges(vertices, bridges, closed, cut_at, &execution).map_err(|error| {
            // The archive's bridges were validated, so that only the cuts can be wrong.
            let Error::Input(errors) = error else { return Missing::Surface };
            match errors.first() {
                Some(error) if error.place == Place::field("cut_at") => Missing::Bridge(error.detail.clone()),
                _ => Missing::Surface,
            }
        })?;
        let stack = Stack { mesh: &contents.mesh, bridges, closed };
        let mut pieces = stack.strip_pieces(&flat);
        pieces.extend(stack.caps());
        Ok(Self { pieces })
    }

    /// Places the pieces on one sheet, with the first at the top. The gap between neighbours is a twentieth of the
    /// largest extent. Pieces are moved, but never turned or scaled.
    #[must_use]
    pub fn sheet(&self) -> Sheet {
        let boxes: Vec<_> = self.pieces.iter().map(Piece::bounds).collect();
        let extent = boxes.iter().map(|[low, high]| (*high - *low).max_element()).fold(0.0, f64::max);
        let gap = extent / 20.0;
        let mut size = DVec2::ZERO;
        let mut pieces = Vec::with_capacity(self.pieces.len());
        for (piece, [low, high]) in self.pieces.iter().zip(&boxes).rev() {
            let bottom = if pieces.is_empty() { 0.0 } else { size.y + gap };
            let mut placed = piece.clone();
            placed.move_points(|point| point - *low + DVec2::new(0.0, bottom));
            size = DVec2::new(size.x.max(high.x - low.x), bottom + high.y - low.y);
            pieces.push(placed);
        }
        pieces.reverse();
        Sheet { pieces, size }
    }
}

/// Reason why a result has no such pattern.
#[derive(Clone, Debug, PartialEq, Eq)]
pub enum Missing {
    /// The result is no ruled surface.
    Surface,
    /// The detail says which bridge is no place for a cut.
    Bridge(String),
}

/// The strips of a mesh.
struct Stack<'a> {
    mesh: &'a Mesh,
    bridges: &'a [[u32; 2]],
    closed: bool,
}

/// A rail: its lowest vertex number, and the arc length at each vertex from there in the order of the numbers. A closed
/// rail has the length of the whole rail as a last entry.
struct Rail {
    first: u32,
    arc: Vec<f64>,
}

impl Rail {
    /// Returns the arc lengths at the ends of the edge between two neighbouring vertices. The edge that closes a rail
    /// ends at the rail's length.
    fn edge(&self, ends: [u32; 2]) -> [f64; 2] {
        let at = ends.map(|vertex| (vertex - self.first) as usize);
        let last = self.arc.len() - 1;
        match at {
            [from, to] if from.abs_diff(to) == 1 => [self.arc[from], self.arc[to]],
            [from, 0] => [self.arc[from], self.arc[last]],
            [_, to] => [self.arc[last], self.arc[to]],
        }
    }
}

impl Stack<'_> {
    /// Returns the rail of the strip with these bridges on one side (0 or 1).
    fn rail(&self, bridges: &[[u32; 2]], side: usize) -> Rail {
        let numbers = bridges.iter().map(|bridge| bridge[side]);
        let (first, last) = numbers.fold((u32::MAX, 0), |(low, high), number| (low.min(number), high.max(number)));
        let point = |vertex: u32| self.mesh.vertices[vertex as usize];
        let mut arc = vec![0.0];
        let mut along = 0.0;
        for vertex in first..last {
            along += point(vertex).distance(point(vertex + 1));
            arc.push(along);
        }
        if self.closed && first < last {
            arc.push(along + point(last).distance(point(first)));
        }
        Rail { first, arc }
    }

    fn strip_pieces(&self, flat: &FlatPattern) -> Vec<Piece> {
        let mut starts = vec![(0, 0)];
        for own in strips_of(self.bridges) {
            let (bridge, triangle) = starts[starts.len() - 1];
            starts.push((bridge + own.len(), triangle + own.len() - usize::from(!self.closed)));
        }
        let mut pieces = Vec::with_capacity(flat.strips.len());
        for parts in flat.strips.chunk_by(|one, next| one.strip == next.strip) {
            let number = parts[0].strip;
            let (first_bridge, first_triangle) = starts[number];
            let (next_bridge, next_triangle) = starts[number + 1];
            let own = &self.bridges[first_bridge..next_bridge];
            let triangles = &self.mesh.triangles[first_triangle..next_triangle];
            let rails = [self.rail(own, 0), self.rail(own, 1)];
            for (part, strip) in parts.iter().enumerate() {
                let suffix = if parts.len() > 1 { format!("-{}", part + 1) } else { String::new() };
                pieces.push(Piece {
                    name: format!("strip {}{suffix}", number + 1),
                    ..self.strip_piece(strip, triangles, first_bridge, &rails)
                });
            }
        }
        pieces
    }

    /// Returns the piece of a flat strip. `triangles` are those of the whole strip, whose bridges start at
    /// `first_bridge`.
    fn strip_piece(&self, strip: &FlatStrip, triangles: &[[u32; 3]], first_bridge: usize, rails: &[Rail; 2]) -> Piece {
        let place = |number: u32| number as usize - first_bridge;
        let normal = |triangle: usize| double_area_vector(self.mesh.corners(triangles[triangle]));
        let count = strip.bridges.len();
        let inner = 1..count.saturating_sub(1);
        let folds = inner.map(|k| {
            let [i, j] = strip.bridges[k];
            let pair = [place(strip.numbers[k - 1]), place(strip.numbers[k])];
            let angle = fold_angle(self.mesh, pair.map(|triangle| triangles[triangle]), pair.map(normal));
            Fold {
                ends: [strip.p[i as usize], strip.q[j as usize]],
                angle_deg: angle.to_degrees(),
                bridge: strip.numbers[k],
            }
        });
        // The vertices of the mesh that the points of the piece became.
        let mut vertices = [Vec::with_capacity(strip.p.len()), Vec::with_capacity(strip.q.len())];
        for (ends, &number) in strip.bridges.iter().zip(&strip.numbers) {
            for side in [0, 1] {
                if ends[side] as usize == vertices[side].len() {
                    vertices[side].push(self.bridges[number as usize][side]);
                }
            }
        }
        let [p, q] = &vertices;
        let rail = |side: usize, ends: [u32; 2]| Edge {
            side: [Side::P, Side::Q][side],
            seam: Seam::Rail((strip.strip + side) as u32),
            arc: rails[side].edge(ends),
        };
        let end = |k: usize, forwards: bool| {
            let [i, j] = strip.bridges[k];
            let length = strip.p[i as usize].distance(strip.q[j as usize]);
            let arc = if forwards { [0.0, length] } else { [length, 0.0] };
            Edge { side: Side::End, seam: Seam::Bridge(strip.numbers[k]), arc }
        };
        let mut edges: Vec<Edge> = p.windows(2).map(|pair| rail(0, [pair[0], pair[1]])).collect();
        edges.push(end(count - 1, true));
        edges.extend(q.windows(2).rev().map(|pair| rail(1, [pair[1], pair[0]])));
        edges.push(end(0, false));
        let corner = |v: u32| {
            let v = v as usize;
            if v < strip.p.len() { strip.p[v] } else { strip.q[v - strip.p.len()] }
        };
        let bridge_at = |k: usize| {
            let [i, j] = strip.bridges[k];
            [strip.p[i as usize], strip.q[j as usize]]
        };
        let mut piece = Piece {
            name: String::new(),
            outline: strip.outline(),
            edges,
            folds: folds.collect(),
            panels: strip.triangles.iter().map(|triangle| triangle.map(corner)).collect(),
            ends: Some([bridge_at(0), bridge_at(count - 1)]),
            overlaps: strip.self_overlap,
        };
        // The flat triangles have the orientation (p_i, p_{i+1}, q_j). The mesh may have the other one.
        let first =
            strip.triangles[0].map(|v| if (v as usize) < p.len() { p[v as usize] } else { q[v as usize - p.len()] });
        if !is_rotation(first, triangles[place(strip.numbers[0])]) {
            piece.move_points(|point| DVec2::new(point.x, strip.height - point.y));
            piece.reverse();
            piece.panels.iter_mut().for_each(|panel| panel.swap(1, 2));
        }
        piece
    }

    /// Returns the flat caps: the triangles that follow those of the strips. Each cap fills the first or the last rail.
    fn caps(&self) -> Vec<Piece> {
        let strips: Vec<&[[u32; 2]]> = strips_of(self.bridges).collect();
        let (Some(first), Some(last)) = (strips.first(), strips.last()) else { return Vec::new() };
        let own: usize = strips.iter().map(|strip| strip.len() - usize::from(!self.closed)).sum();
        let rest = self.mesh.triangles.get(own..).unwrap_or_default();
        let sides = [(self.rail(first, 0), 0), (self.rail(last, 1), strips.len() as u32)];
        let mut pieces = Vec::new();
        for (rail, number) in sides {
            let count = rail.arc.len().saturating_sub(1) as u32;
            let range = rail.first..rail.first + count;
            let triangles: Vec<[u32; 3]> =
                rest.iter().copied().filter(|t| t.iter().all(|v| range.contains(v))).collect();
            if triangles.is_empty() {
                continue;
            }
            pieces.push(Piece { name: format!("cap {}", pieces.len() + 1), ..self.cap(&triangles, &rail, number) });
        }
        pieces
    }

    fn cap(&self, triangles: &[[u32; 3]], rail: &Rail, number: u32) -> Piece {
        let count = rail.arc.len() as u32 - 1;
        let mut contour: Vec<u32> = (rail.first..rail.first + count).collect();
        let area: DVec3 = triangles.iter().map(|&triangle| double_area_vector(self.mesh.corners(triangle))).sum();
        let at = |vertex: u32| self.mesh.vertices[vertex as usize];
        let origin = at(rail.first);
        let around: DVec3 = contour.windows(2).map(|pair| (at(pair[0]) - origin).cross(at(pair[1]) - origin)).sum();
        if around.dot(area) < 0.0 {
            contour.reverse();
        }
        let points: Vec<DVec3> = contour.iter().map(|&vertex| at(vertex)).collect();
        let frame = Frame::of_loop(&points).unwrap_or_else(|| Frame::with_normal(area.normalize_or_zero()));
        let flat = |vertex: u32| frame.coordinates(at(vertex) - origin);
        let outline: Vec<DVec2> = contour.iter().map(|&vertex| flat(vertex)).collect();
        let edge = |k: usize| Edge {
            side: Side::P,
            seam: Seam::Rail(number),
            arc: rail.edge([contour[k], contour[(k + 1) % contour.len()]]),
        };
        let edges = (0..contour.len()).map(edge).collect();
        let panels = triangles.iter().map(|triangle| triangle.map(flat)).collect();
        let mut piece = Piece { outline, edges, panels, ..Piece::default() };
        let [low, _] = piece.bounds();
        piece.move_points(|point| point - low);
        piece
    }
}

/// Whether two triples are the same up to a rotation.
fn is_rotation(one: [u32; 3], other: [u32; 3]) -> bool {
    (0..3).any(|k| [other[k], other[(k + 1) % 3], other[(k + 2) % 3]] == one)
}

/// Returns the angle between the normals of two neighbouring triangles. It is positive at a ridge, seen from the side
/// that the normals point to.
fn fold_angle(mesh: &Mesh, [left, right]: [[u32; 3]; 2], normals: [DVec3; 2]) -> f64 {
    let angle = measure::angle(normals[0], normals[1]);
    let beyond = right.into_iter().find(|vertex| !left.contains(vertex)).unwrap_or(right[0]);
    let height = normals[0].dot(mesh.vertices[beyond as usize] - mesh.vertices[left[0] as usize]);
    if height > 0.0 { -angle } else { angle }
}
