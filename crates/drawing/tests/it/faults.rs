//! Faults that are put into a pattern on purpose. Each check passes on the pattern as it is made, and fails on the fault.
//!
//! Five more lie beside the checks that catch them: an angle that is rounded, a fold that is bent the other way, and two
//! angles that are swapped (`patterns`), a mate that is 0.1% long (`patterns`), and a wrong bend allowance
//! (`sheet_metal`).

use crate::patterns::{figures_of, pieces, refold_error, seams};
use crate::samples::all;
use crate::sheet_metal::{metal, millimetres, unmade_error};
use plateau_archive::archive::bridges_of;
use plateau_drawing::figure::Figure;
use plateau_drawing::metal::{bend_allowance, blank};
use plateau_drawing::options::{Metal, Relief, Skin};
use plateau_drawing::piece::{Piece, Seam};
use plateau_mesh::DVec2;
use std::collections::BTreeMap;

/// Whether every mark of a seam is on all of its pieces.
fn marks_have_mates(figures: &[Figure], pieces: &[Piece]) -> bool {
    let mut at: BTreeMap<(Seam, u64), usize> = BTreeMap::new();
    for mark in figures.iter().flat_map(|figure| &figure.marks) {
        *at.entry((mark.seam, mark.arc_length.to_bits())).or_default() += 1;
    }
    let seams = seams(pieces);
    at.into_iter().all(|((seam, _), count)| count == seams[&seam].len())
}

#[test]
fn a_lost_notch_is_seen() {
    let mut seen = 0;
    for (name, archive) in all() {
        let pieces = pieces(&archive);
        let figures = figures_of(&archive, "notches=150");
        assert!(marks_have_mates(&figures, &pieces), "{name}");
        let shared = |seam: Seam| seams(&pieces)[&seam].len() > 1;
        for (number, figure) in figures.iter().enumerate() {
            let Some(lost) = figure.marks.iter().position(|mark| shared(mark.seam)) else { continue };
            let mut faulty = figures.clone();
            faulty[number].marks.remove(lost);
            assert!(!marks_have_mates(&faulty, &pieces), "{name} {}", figure.name);
            seen += 1;
        }
    }
    assert!(seen > 5, "{seen}");
}

/// Whether the sides of each piece are as long as its seams.
fn sides_are_seams(pieces: &[Piece]) -> bool {
    pieces.iter().all(|piece| {
        let count = piece.outline.len();
        let length = |k: usize| piece.outline[k].distance(piece.outline[(k + 1) % count]);
        piece.edges.len() == count
            && piece
                .edges
                .iter()
                .enumerate()
                .all(|(k, edge)| (length(k) - (edge.arc[1] - edge.arc[0]).abs()).abs() < 1e-12)
    })
}

#[test]
fn two_pieces_that_are_swapped_are_seen() {
    for (name, archive) in all() {
        let mut pieces = pieces(&archive);
        assert!(sides_are_seams(&pieces), "{name}");
        if pieces.len() > 1 {
            let first = pieces[0].outline.clone();
            pieces[0].outline = std::mem::replace(&mut pieces[1].outline, first);
            assert!(!sides_are_seams(&pieces), "{name}");
        }
    }
}

#[test]
fn a_piece_that_is_mirrored_is_seen() {
    for (name, archive) in all() {
        if name.contains("stack") || plateau_archive::archive::is_closed(archive.contents()) {
            continue;
        }
        let mut piece = pieces(&archive).remove(0);
        assert!(refold_error(&archive, &piece, 0) < 1e-9, "{name}");
        let mirror = |point: DVec2| DVec2::new(point.x, -point.y);
        piece.panels.iter_mut().for_each(|panel| *panel = panel.map(mirror));
        piece.folds.iter_mut().for_each(|fold| fold.ends = fold.ends.map(mirror));
        assert!(refold_error(&archive, &piece, 0) > 1e-4, "{name}");
    }
}

#[test]
fn a_setback_of_the_wrong_skin_is_seen() {
    let (_, archive) = all().remove(3);
    let front = Metal { skin: Skin::Front, relief: Relief::Auto, ..metal(1.0, 0.8, Some(0.4)) };
    let back = Metal { skin: Skin::Back, ..front };
    for piece in millimetres(&archive) {
        let allowance = |angle: f64| bend_allowance(&front, angle);
        let error = |made: &Metal| unmade_error(&piece, &blank(&piece, made).unwrap(), &front, allowance)[0];
        assert!(error(&front) < 1e-8 && error(&back) > 1e-2, "{} {}", error(&front), error(&back));
    }
}

/// Whether each fold is as long as the bridge whose number it has.
fn folds_are_bridges(archive: &plateau_archive::Archive, pieces: &[Piece]) -> bool {
    let bridges = bridges_of(archive.contents()).unwrap();
    let vertices = &archive.contents().mesh.vertices;
    pieces.iter().flat_map(|piece| &piece.folds).all(|fold| {
        let [a, b] = bridges[fold.bridge as usize].map(|vertex| vertices[vertex as usize]);
        (a.distance(b) - fold.ends[0].distance(fold.ends[1])).abs() < 1e-12
    })
}

#[test]
fn numbers_of_bridges_that_are_one_off_are_seen() {
    for (name, archive) in all() {
        let mut pieces = pieces(&archive);
        assert!(folds_are_bridges(&archive, &pieces), "{name}");
        let count = bridges_of(archive.contents()).unwrap().len() as u32;
        let folds = pieces.iter_mut().flat_map(|piece| &mut piece.folds);
        folds.for_each(|fold| fold.bridge = (fold.bridge + 1) % count);
        assert!(!folds_are_bridges(&archive, &pieces), "{name}");
    }
}
