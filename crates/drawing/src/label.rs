//! Places of texts: inside a triangle of a piece, clear of every line, or beside the piece with a leader.

use plateau_mesh::DVec2;

/// Height of the smallest text, in millimetres.
const LEAST_HEIGHT: f64 = 2.0;
/// Height of the smallest text inside a piece, as a fraction of the height asked for. The default of 5 mm gives 2 mm.
const LEAST_INSIDE: f64 = 0.4;
/// Distance of two texts that stand side by side, as a multiple of their height.
const PITCH: f64 = 1.6;
/// Width of a character, as a multiple of the height of capitals: that of the widest common letter of Helvetica, so
/// that other fonts fit too.
const CHARACTER_WIDTH: f64 = 0.85;
/// Free space around a text, as a multiple of its height.
const MARGIN: f64 = 0.25;

/// A place for a text: its middle, its direction, and the height of its capitals.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Spot {
    pub at: DVec2,
    pub direction: DVec2,
    pub height: f64,
    /// Whether the text starts at the left end of its box instead of standing amid it. Lines of a list do.
    pub starts_left: bool,
}

impl Spot {
    /// Returns a place for a text that stands amid its box.
    #[must_use]
    pub fn amid(at: DVec2, direction: DVec2, height: f64) -> Self {
        Self { at, direction, height, starts_left: false }
    }

    /// Returns the point in the middle of the text's height at which a text of this place starts, if it starts left.
    pub(crate) fn start(&self, text: &str) -> DVec2 {
        self.at - self.direction * (0.5 * width(text, self.height))
    }
}

/// Returns the height below which a text stands beside the piece: whoever asks for large texts will see the drawing
/// reduced.
#[must_use]
pub fn least_inside(height: f64) -> f64 {
    LEAST_HEIGHT.max(LEAST_INSIDE * height).min(height)
}

/// Returns the height of upright texts side by side above a piece: the height asked for, or less if they would be wider
/// than the piece, but no less than 2 mm.
#[must_use]
pub fn height_beside(count: usize, width: f64, height: f64) -> f64 {
    (width / (PITCH * count.max(1) as f64)).max(LEAST_HEIGHT).min(height)
}

/// Returns the width of a text with this height.
#[must_use]
pub fn width(text: &str, height: f64) -> f64 {
    CHARACTER_WIDTH * height * text.chars().count() as f64
}

/// Returns the place for the largest text, up to `height`, whose base is parallel to the side from `base` to the next
/// corner of a triangle. Returns `None` unless the triangle lies above this side.
fn on_side(corners: [DVec2; 3], base: usize, text: &str, height: f64) -> Option<Spot> {
    let [a, b, c] = [corners[base], corners[(base + 1) % 3], corners[(base + 2) % 3]];
    let length = a.distance(b);
    let direction = (b - a).try_normalize()?;
    let (foot, altitude) = ((c - a).dot(direction), (c - a).dot(direction.perp()));
    if !(0.0..=length).contains(&foot) || altitude <= 0.0 {
        return None;
    }
    // The box of the text with its margins, at height 1. A box of this shape below the apex has the height h with
    // shape · h = length (1 - h / altitude).
    let [box_width, box_height] = [width(text, 1.0) + 2.0 * MARGIN, 1.0 + 2.0 * MARGIN];
    let shape = box_width / box_height;
    let largest = length * altitude / (shape * altitude + length) / box_height;
    let height = height.min(largest);
    let own = height * box_height;
    let middle = 0.5 * (foot * own / altitude + length - (length - foot) * own / altitude);
    let at = a + direction * middle + direction.perp() * (0.5 * own);
    Some(Spot::amid(at, readable(direction), height))
}

/// Turns a direction by 180 degrees if a text along it would be upside down.
pub(crate) fn readable(direction: DVec2) -> DVec2 {
    // A text that runs straight down would be read from the right; drawings are read from the left.
    let is_upside_down = direction.x < -1e-9 || (direction.x <= 1e-9 && direction.y < 0.0);
    if is_upside_down { -direction } else { direction }
}

/// Returns the place of the largest text, up to `height`, inside a triangle that runs counter-clockwise. `side` limits
/// the choice to texts along one side, given by its first corner.
#[must_use]
pub fn inside(corners: [DVec2; 3], side: Option<usize>, text: &str, height: f64) -> Option<Spot> {
    let sides = side.map_or(0..3, |side| side..side + 1);
    let spots = sides.filter_map(|base| on_side(corners, base, text, height));
    spots.reduce(|best, spot| if spot.height > best.height { spot } else { best })
}

/// Returns the corners of the box of a text, without margins.
#[must_use]
pub fn corners(spot: &Spot, text: &str) -> [DVec2; 4] {
    let along = spot.direction * (0.5 * width(text, spot.height));
    let up = spot.direction.perp() * (0.5 * spot.height);
    [spot.at - along - up, spot.at + along - up, spot.at + along + up, spot.at - along + up]
}

/// Spreads places of upright texts along a line so that neighbours of this height have room, and moves them as little
/// as that allows: the places are in increasing order, and so are the results.
#[must_use]
pub fn spread(places: &[f64], height: f64) -> Vec<f64> {
    let distance = PITCH * height;
    // Groups of places that touch: where the first place of each comes to lie, and their number.
    let mut groups: Vec<(f64, usize)> = Vec::new();
    for &place in places {
        let mut group = (place, 1);
        while let Some(&(start, count)) = groups.last() {
            if start + count as f64 * distance <= group.0 {
                break;
            }
            groups.pop();
            let own = group.1 as f64;
            let wanted = group.0 - count as f64 * distance;
            group = ((start * count as f64 + wanted * own) / (count as f64 + own), count + group.1);
        }
        groups.push(group);
    }
    groups.iter().flat_map(|&(start, count)| (0..count).map(move |k| start + k as f64 * distance)).collect()
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_text_lies_inside_its_triangle_and_is_as_large_as_fits() {
        let triangle = [[0.0, 0.0], [90.0, 0.0], [30.0, 40.0]].map(DVec2::from_array);
        for text in ["a", "strip 12", "-123.45"] {
            let spot = inside(triangle, None, text, 100.0).unwrap();
            let margin = MARGIN * spot.height;
            let mut least = f64::INFINITY;
            for corner in corners(&spot, text) {
                for k in 0..3 {
                    let (a, b) = (triangle[k], triangle[(k + 1) % 3]);
                    least = least.min((b - a).perp_dot(corner - a) / a.distance(b));
                }
            }
            assert!(least > 0.0 && least <= margin + 1e-9, "{text} {spot:?} {least}");
            let limited = inside(triangle, None, text, 2.0).unwrap();
            assert_eq!(limited.height, 2.0);
        }
        // A text along a side keeps its margin from the side.
        let spot = inside(triangle, Some(0), "12.5", 100.0).unwrap();
        let (a, b) = (triangle[0], triangle[1]);
        let from_side = (b - a).perp_dot(spot.at - a) / a.distance(b);
        assert!((from_side - (0.5 + MARGIN) * spot.height).abs() < 1e-9);
        assert!(spot.direction.x > 0.0);
    }

    #[test]
    fn spread_places_keep_their_order_and_distance_and_move_least() {
        let places = [0.0, 1.0, 1.0, 10.0, 30.0];
        let spread = spread(&places, 2.0 / PITCH);
        assert!(spread.windows(2).all(|pair| pair[1] - pair[0] > 2.0 - 1e-12));
        assert_eq!(spread[3..], [10.0, 30.0]);
        let mean = |values: &[f64]| values.iter().sum::<f64>() / values.len() as f64;
        assert!((mean(&spread[..3]) - mean(&places[..3])).abs() < 1e-12);
    }
}
