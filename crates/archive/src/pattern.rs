//! The flat pattern of a developable strip, with the outline to cut and the lines to fold.
//!
//! A strip of triangles unrolls isometrically, so each strip is one [`Piece`] in its own plane. The files show all
//! pieces on one sheet ([`Pattern::sheet`]), one below the other.

use plateau_mesh::measure::{self, double_area_vector};
use plateau_mesh::{DVec2, DVec3, Execution, Mesh};
use plateau_ruled_surface::FlatPattern;

use super::archive::{Contents, bridges_of};

/// All strips of a ruled surface, unrolled. Coordinates are in the client's unit.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Pattern {
    pub pieces: Vec<Piece>,
}

/// An unrolled strip.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Piece {
    /// Text printed on the piece, such as `strip 1`.
    pub name: String,
    /// Contour to cut: a closed polygon of at least three points that does not repeat its first point.
    pub outline: Vec<DVec2>,
    /// Fold lines: the bridges except the first and the last.
    pub folds: Vec<Fold>,
}

/// A fold line across a piece.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Fold {
    pub ends: [DVec2; 2],
    /// Fold angle in degrees, in [-180, 180]. A positive angle is a mountain (a ridge, seen from the side that the
    /// surface's normals point to), a negative angle is a valley, and zero stays flat.
    pub angle_deg: f64,
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
    /// Returns the smallest and largest coordinates of the piece, including its folds.
    fn bounds(&self) -> (DVec2, DVec2) {
        let points = self.outline.iter().copied().chain(self.folds.iter().flat_map(|fold| fold.ends));
        points.fold((DVec2::INFINITY, DVec2::NEG_INFINITY), |(low, high), point| (low.min(point), high.max(point)))
    }
}

impl Contents {
    /// Returns the flat pattern, if there is one.
    #[must_use]
    pub fn flat_pattern(&self) -> Option<Pattern> {
        if !self.unrolls {
            return None;
        }
        // Unrolling cannot fail, because the archive's bridges were validated.
        let flat = FlatPattern::of_bridges(&self.mesh.vertices, bridges_of(self)?, &Execution::default()).ok()?;
        Some(unrolled(&flat, &self.mesh))
    }
}

/// Converts the flat strips to pieces with folds. The mesh's triangles must be in the order of the strips.
fn unrolled(flat: &FlatPattern, mesh: &Mesh) -> Pattern {
    let mut first = 0;
    let pieces = flat.strips.iter().enumerate().map(|(number, strip)| {
        let triangles = &mesh.triangles[first..first + strip.triangles.len()];
        first += strip.triangles.len();
        let normals: Vec<DVec3> =
            triangles.iter().map(|&triangle| double_area_vector(mesh.corners(triangle))).collect();
        let inner = strip.bridges.get(1..strip.bridges.len().saturating_sub(1)).unwrap_or_default();
        let folds = inner.iter().enumerate().map(|(k, &[i, j])| Fold {
            ends: [strip.p[i as usize], strip.q[j as usize]],
            angle_deg: fold_angle(mesh, [triangles[k], triangles[k + 1]], [normals[k], normals[k + 1]]).to_degrees(),
        });
        Piece { name: format!("strip {}", number + 1), outline: strip.outline(), folds: folds.collect() }
    });
    Pattern { pieces: pieces.collect() }
}

/// Returns the angle between the normals of two neighbouring triangles. It is positive at a ridge, seen from the side
/// that the normals point to.
fn fold_angle(mesh: &Mesh, [left, right]: [[u32; 3]; 2], normals: [DVec3; 2]) -> f64 {
    let angle = measure::angle(normals[0], normals[1]);
    let beyond = right.into_iter().find(|vertex| !left.contains(vertex)).unwrap_or(right[0]);
    let height = normals[0].dot(mesh.vertices[beyond as usize] - mesh.vertices[left[0] as usize]);
    if height > 0.0 { -angle } else { angle }
}

/// Layout of all pieces. The origin is the lower left corner, and y points up.
#[derive(Clone, Debug, PartialEq)]
pub struct Sheet {
    pub pieces: Vec<Piece>,
    pub size: DVec2,
}

impl Pattern {
    /// Places the pieces on one sheet, with the first at the top. The gap between neighbours is a twentieth of the
    /// largest extent. Pieces are moved, but never turned or scaled.
    #[must_use]
    pub fn sheet(&self) -> Sheet {
        let bounds: Vec<_> = self.pieces.iter().map(Piece::bounds).collect();
        let extent = bounds.iter().map(|(low, high)| (*high - *low).max_element()).fold(0.0, f64::max);
        let gap = extent / 20.0;
        let mut size = DVec2::ZERO;
        let mut pieces = Vec::with_capacity(self.pieces.len());
        for (piece, (low, high)) in self.pieces.iter().zip(&bounds).rev() {
            let bottom = if pieces.is_empty() { 0.0 } else { size.y + gap };
            let place = |point: DVec2| point - *low + DVec2::new(0.0, bottom);
            size = DVec2::new(size.x.max(high.x - low.x), bottom + high.y - low.y);
            pieces.push(Piece {
                name: piece.name.clone(),
                outline: piece.outline.iter().map(|&point| place(point)).collect(),
                folds: piece.folds.iter().map(|fold| Fold { ends: fold.ends.map(place), ..*fold }).collect(),
            });
        }
        pieces.reverse();
        Sheet { pieces, size }
    }
}
