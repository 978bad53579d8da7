//! The flat pattern of a developable strip: what a cutter cuts and a folder folds.
//!
//! A strip of triangles unrolls isometrically, so each strip is one [`Piece`] in a plane of its own. The files show all
//! pieces on one sheet ([`Pattern::sheet`]): each in its own box, the boxes below one another.

use plateau_geometry::DVec2;

/// Every strip of a ruled surface, unrolled. Coordinates are in the client's unit.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Pattern {
    pub pieces: Vec<Piece>,
}

/// One unrolled strip.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Piece {
    /// Printed on the piece, e.g. `strip 1`.
    pub name: String,
    /// The contour to cut, closed, its first point not repeated; at least three points.
    pub outline: Vec<DVec2>,
    /// The bridges between the first and the last.
    pub folds: Vec<Fold>,
}

/// A fold line across a piece.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Fold {
    pub ends: [DVec2; 2],
    /// By how much to fold, degrees in [-180, 180]: positive is a mountain (a ridge seen from the side that the surface's
    /// normals point to), negative a valley, zero stays flat.
    pub angle_deg: f64,
}

/// Mountain, valley or flat: what the line types and layers of the files distinguish.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum FoldKind {
    Mountain,
    Valley,
    Flat,
}

impl Fold {
    /// Folds below a hundredth of a degree are flat: no bending brake knows them.
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
    /// Smallest and largest coordinates of the piece; outline and folds both count.
    fn bounds(&self) -> (DVec2, DVec2) {
        let points = self.outline.iter().copied().chain(self.folds.iter().flat_map(|fold| fold.ends));
        points.fold((DVec2::INFINITY, DVec2::NEG_INFINITY), |(low, high), point| (low.min(point), high.max(point)))
    }
}

/// All pieces laid out: the lower left corner is the origin, y points up.
#[derive(Clone, Debug, PartialEq)]
pub struct Sheet {
    pub pieces: Vec<Piece>,
    pub size: DVec2,
}

impl Pattern {
    /// Places the pieces on one sheet, the first at the top, a twentieth of the largest extent between neighbours.
    /// Pieces are moved, never turned or scaled.
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
