//! The pieces of a result. Strips are cut at bridges if they overlap themselves, do not fit a sheet, or are too long.

use crate::figure::{Figure, contour, figures};
use crate::metal;
use crate::options::{PatternOptions, Rotate, Stock};
use crate::parameters::Refused;
use crate::piece::{FoldKind, Missing, Pattern, Piece, Seam, Side};
use crate::polygon;
use plateau_archive::Contents;
use plateau_archive::archive::is_closed;
use plateau_mesh::DVec2;
use std::collections::BTreeSet;

/// Part of a size by which a piece may exceed a limit, because of rounding.
const ROUNDING: f64 = 1e-9;
/// Most triangles of the shortest part that is tried. The first triangle of a strip whose rails share their ends has no
/// area.
const SHORTEST: usize = 8;

/// Returns the figures of a result's flat pattern in millimetres.
///
/// # Errors
/// Returns [`Refused::NoPattern`] unless the result is a ruled surface, and [`Refused::Unsuitable`] if the options do
/// not suit it.
pub fn of_result(contents: &Contents, options: &PatternOptions) -> Result<Vec<Figure>, Refused> {
    let pieces = |cut_at: &[u32]| -> Result<Vec<Piece>, Refused> {
        let pattern = Pattern::of(contents, cut_at).map_err(|missing| match missing {
            Missing::Surface => Refused::NoPattern,
            Missing::Bridge(detail) => Refused::unsuitable("cut_at", detail),
        })?;
        let millimetres = contents.unit.millimetres();
        Ok(pattern.pieces.into_iter().map(|piece| piece.scaled(millimetres)).collect())
    };
    let whole = pieces(&options.cut_at)?;
    let mut numbers = cuts(&whole, is_closed(contents), options)?;
    if numbers.is_empty() {
        return figures(&whole, options);
    }
    numbers.extend(&options.cut_at);
    figures(&pieces(&numbers.into_iter().collect::<Vec<u32>>())?, options)
}

/// Returns the numbers of the bridges at which pieces in millimetres have to be cut. Each part reaches as far as it
/// fits, and ends at a bridge that stays flat if its last quarter has one. A closed strip that is cut anywhere is also
/// cut at the bridge at which it is open.
///
/// # Errors
/// Returns [`Refused::Unsuitable`] at `sheet` or `max_length` for a cap or a triangle that does not fit, and at the
/// parameter of any other value that does not suit a piece.
fn cuts(pieces: &[Piece], closed: bool, options: &PatternOptions) -> Result<BTreeSet<u32>, Refused> {
    let mut cuts = BTreeSet::new();
    let is_limited = options.stock.is_some() || options.max_length.is_some();
    for piece in pieces {
        if !piece.overlaps && (!is_limited || is_within(size(piece, options)?, options)) {
            continue;
        }
        let Some(bridges) = piece.bridges() else {
            return Err(too_large(&piece.name, size(piece, options)?, options));
        };
        let last = bridges.len() - 1;
        let mut from = 0;
        while from < last {
            let to = furthest(piece, &bridges, from, options)?;
            if to < last {
                cuts.insert(piece.folds[to - 1].bridge);
            }
            from = to;
        }
        if closed {
            cuts.extend(piece.edges.iter().filter(|edge| edge.side == Side::End).filter_map(|edge| match edge.seam {
                Seam::Bridge(number) => Some(number),
                Seam::Rail(_) => None,
            }));
        }
    }
    Ok(cuts)
}

/// Returns the width and the height of a piece's cut.
fn size(piece: &Piece, options: &PatternOptions) -> Result<DVec2, Refused> {
    let blank = options.metal.as_ref().map(|metal| metal::blank(piece, metal)).transpose()?;
    let piece = blank.as_ref().map_or(piece, |blank| &blank.piece);
    let (cut, _) = contour(piece, &[], options)?;
    let [low, high] = crate::piece::bounds(&cut);
    Ok(high - low)
}

fn is_within(size: DVec2, options: &PatternOptions) -> bool {
    let is_short = options.max_length.is_none_or(|length| size.x <= length * (1.0 + ROUNDING));
    is_short && options.stock.is_none_or(|stock| fits(size, &stock))
}

/// Whether a box fits a sheet.
pub(crate) fn fits(size: DVec2, stock: &Stock) -> bool {
    let room = stock.size * (1.0 + ROUNDING);
    let lies = |size: DVec2| size.cmple(room).all();
    lies(size) || stock.rotate == Rotate::Free && lies(DVec2::new(size.y, size.x))
}

/// Returns the last bridge of the part that starts at bridge `from` of a piece. Tries parts of 1, 2, 4, … triangles,
/// then halves the interval between the longest that fits and the first that does not.
fn furthest(piece: &Piece, bridges: &[[DVec2; 2]], from: usize, options: &PatternOptions) -> Result<usize, Refused> {
    let last = bridges.len() - 1;
    let (mut good, mut bad, mut step) = (None, None, 1);
    while bad.is_none() && good != Some(last) {
        let to = (from + step).min(last);
        if part_fits(piece, bridges, [from, to], options)? {
            good = Some(to);
        } else if good.is_some() || step >= SHORTEST || to == last {
            bad = Some(to);
        }
        step *= 2;
    }
    let Some(mut good) = good else {
        let bridge = if from > 0 { Some(piece.folds[from - 1].bridge) } else { None };
        let name = match bridge {
            Some(bridge) => format!("{} beside bridge {bridge}", piece.name),
            None => format!("{} beside its first bridge", piece.name),
        };
        return Err(too_large(&name, size(&piece.part(bridges, from, from + 1), options)?, options));
    };
    let mut bad = bad.unwrap_or(good + 1);
    while good + 1 < bad {
        let middle = good.midpoint(bad);
        if part_fits(piece, bridges, [from, middle], options)? {
            good = middle;
        } else {
            bad = middle;
        }
    }
    if good == last {
        return Ok(last);
    }
    let quarter = good - (good - from) / 4;
    for to in (quarter.max(from + 1)..=good).rev() {
        if piece.folds[to - 1].kind() == FoldKind::Flat {
            return Ok(if part_fits(piece, bridges, [from, to], options)? { to } else { good });
        }
    }
    Ok(good)
}

/// Whether the part between two bridges does not overlap itself and is small enough. A part whose allowance or kerf
/// crosses itself does not fit either.
fn part_fits(
    piece: &Piece,
    bridges: &[[DVec2; 2]],
    [from, to]: [usize; 2],
    options: &PatternOptions,
) -> Result<bool, Refused> {
    let part = piece.part(bridges, from, to);
    let mut outline = part.outline.clone();
    outline.dedup();
    if outline.first() == outline.last() {
        outline.pop();
    }
    if polygon::crossing(&outline).is_some() {
        return Ok(false);
    }
    match size(&part, options) {
        Ok(size) => Ok(is_within(size, options)),
        Err(Refused::Unsuitable(errors))
            if errors.iter().all(|error| matches!(error.parameter.as_str(), "allowance" | "kerf")) =>
        {
            Ok(false)
        }
        Err(refused) => Err(refused),
    }
}

/// Returns the error for a piece of this size, which cannot be cut any further.
fn too_large(name: &str, size: DVec2, options: &PatternOptions) -> Refused {
    let [length, width] = size.to_array();
    if let Some(stock) = options.stock.filter(|stock| !fits(size, stock)) {
        let [sheet_length, sheet_width] = stock.size.to_array();
        return Refused::unsuitable(
            "sheet",
            format!(
                "{sheet_length} mm x {sheet_width} mm is too small for {name}, which is {length:.2} mm long and \
                 {width:.2} mm wide"
            ),
        );
    }
    Refused::unsuitable("max_length", format!("{name} is {length:.2} mm long and cannot be cut shorter"))
}
