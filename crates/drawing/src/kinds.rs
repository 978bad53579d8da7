//! Kinds of pieces: how many different ones a shop has to make.

use crate::figure::Figure;
use plateau_mesh::DVec2;
use std::collections::BTreeMap;

/// Distance in millimetres up to which points of two pieces of one kind differ: below what a laser keeps.
const SAME_POINT: f64 = 0.01;
/// Difference in degrees up to which folds of one kind differ.
const SAME_ANGLE: f64 = 0.01;

/// Returns the number of kinds of pieces. Two pieces are of one kind if one can be moved and turned so that its cut and
/// its folds lie upon those of the other. Mirror images are of two kinds.
pub(crate) fn count(figures: &[Figure]) -> usize {
    // Kinds by their numbers of points and folds, and by the length around them in steps that congruent pieces differ
    // by at most.
    let mut kinds: BTreeMap<(usize, usize, i64), Vec<&Figure>> = BTreeMap::new();
    let mut count = 0;
    for figure in figures {
        let corners = figure.cut.len();
        let around: f64 = (0..corners).map(|k| figure.cut[k].distance(figure.cut[(k + 1) % corners])).sum();
        let step = (around / (2.0 * SAME_POINT * corners.max(1) as f64)).floor() as i64;
        let key = |step: i64| (corners, figure.lines.len(), step);
        let mut near = (-1..=1).filter_map(|k| kinds.get(&key(step + k))).flatten();
        if !near.any(|other| is_congruent(figure, other)) {
            kinds.entry(key(step)).or_default().push(figure);
            count += 1;
        }
    }
    count
}

/// Whether two pieces with the same numbers of points and folds are of one kind.
fn is_congruent(one: &Figure, other: &Figure) -> bool {
    let count = one.cut.len();
    let mean = |points: &[DVec2]| points.iter().sum::<DVec2>() / count.max(1) as f64;
    let centres = [mean(&one.cut), mean(&other.cut)];
    let side = |points: &[DVec2], k: usize| points[k % count].distance(points[(k + 1) % count]);
    // Only sides that are as long as the longest one can lie upon it, so that few shifts are tried.
    let longest =
        (0..count).map(|k| (k, side(&one.cut, k))).reduce(|best, own| if own.1 > best.1 { own } else { best });
    let Some((first, length)) = longest else { return true };
    let can_lie_upon = |shift: &usize| (side(&other.cut, first + shift) - length).abs() <= 2.0 * SAME_POINT;
    (0..count).filter(can_lie_upon).any(|shift| {
        let near_sides =
            (0..count).all(|k| (side(&one.cut, k) - side(&other.cut, k + shift)).abs() <= 2.0 * SAME_POINT);
        near_sides && {
            let pairs = || (0..count).map(|k| (one.cut[k] - centres[0], other.cut[(k + shift) % count] - centres[1]));
            // The turn that brings the points nearest to each other in the sum of squares.
            let turn: DVec2 = pairs().map(|(a, b)| DVec2::new(b.dot(a), b.perp_dot(a))).sum();
            let turn = turn.try_normalize().unwrap_or(DVec2::X);
            pairs().all(|(a, b)| a.distance(turn.rotate(b)) <= SAME_POINT) && {
                let place = |point: DVec2| centres[0] + turn.rotate(point - centres[1]);
                has_same_folds(one, other, place)
            }
        }
    })
}

/// Whether the folds of one piece lie upon those of the other, which run in the same or in the opposite order.
fn has_same_folds(one: &Figure, other: &Figure, place: impl Fn(DVec2) -> DVec2) -> bool {
    let folds = one.lines.len();
    let is_same = |k: usize, j: usize| {
        let (own, others) = (&one.lines[k], &other.lines[j]);
        let ends = others.ends.map(&place);
        let near = |[a, b]: [DVec2; 2]| {
            own.ends[0].distance(a) <= 2.0 * SAME_POINT && own.ends[1].distance(b) <= 2.0 * SAME_POINT
        };
        (own.angle_deg - others.angle_deg).abs() <= SAME_ANGLE && (near(ends) || near([ends[1], ends[0]]))
    };
    (0..folds).all(|k| is_same(k, k)) || (0..folds).all(|k| is_same(k, folds - 1 - k))
}
