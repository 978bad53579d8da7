//! Warnings about directrices that may be a mistake: equal ones, ones that cross, and open ones that end where they
//! begin.

use super::prepare::Prepared;
use plateau_mesh::DVec3;
use plateau_mesh::codes::WarningCode;
use plateau_mesh::error::Warning;
use plateau_mesh::execution::{Execution, Interruption};
use plateau_mesh::polyline::contact::{MeetingSegments, Segments, first_contact};
use plateau_mesh::polyline::{SAME_POINT, radius};

/// Smallest number of points of an open directrix that is taken for a loop.
const LOOP_POINTS: usize = 4;
/// Largest number of directrices that a warning lists by index.
const MOST_LISTED: usize = 5;

/// Returns the warnings about the directrices as they were given, before any is reversed. O(n log n) in the number of
/// points.
pub(crate) fn warnings(prepared: &Prepared, execution: &Execution<'_>) -> Result<Vec<Warning>, Interruption> {
    let mut warnings = Vec::new();
    warnings.extend(unclosed(prepared));
    for k in 0..prepared.directrices.len() - 1 {
        let [p, q] = [k, k + 1].map(|k| prepared.directrices[k].points.as_slice());
        if p.len() < 2 || q.len() < 2 {
            continue;
        }
        let tolerance = SAME_POINT * radius(p).max(radius(q));
        let next = k + 1;
        if is_same(p, q, tolerance) {
            let detail =
                format!("directrices {k} and {next} are the same polyline, so the strip between them has no area");
            warnings.push(Warning::new(WarningCode::IdenticalDirectrices, detail).with_count("directrix", k));
        } else if let Some(contact) = meeting(p, q, prepared.closed, tolerance, execution)? {
            let [from, to] = [contact.first, contact.first + 1].map(|k| k % p.len());
            let [from, to] = [from, to].map(|index| prepared.directrices[k].input_point(index));
            let detail = format!(
                "directrices {k} and {next} cross or touch between the points {from} and {to} of directrix {k}: the \
                 strip is pinched there"
            );
            let warning = Warning::new(WarningCode::CrossingDirectrices, detail).with_count("directrix", k);
            warnings.push(warning.with_count("from", from).with_count("to", to));
        }
    }
    Ok(warnings)
}

/// Returns the warning about open directrices that end where they begin, if there are any.
fn unclosed(prepared: &Prepared) -> Option<Warning> {
    let is_loop = |points: &[DVec3]| {
        let ends = points[0].distance(points[points.len() - 1]);
        points.len() >= LOOP_POINTS && ends <= SAME_POINT * radius(points)
    };
    let directrices = prepared.directrices.iter().enumerate();
    let loops: Vec<String> =
        directrices.filter(|(_, directrix)| is_loop(&directrix.points)).map(|(k, _)| k.to_string()).collect();
    if prepared.closed || loops.is_empty() {
        return None;
    }
    let which = match loops.len() {
        1 => format!("directrix {} ends where it begins", loops[0]),
        count if count <= MOST_LISTED => format!("directrices {} end where they begin", loops.join(", ")),
        count => format!("{count} directrices, {} and others, end where they begin", loops[..MOST_LISTED].join(", ")),
    };
    let detail = format!(
        "{which}, and the strips are open: their flat patterns begin and end there. With closed each strip is joined to \
         itself, and its pattern is cut at the bridge of least fold, or at the bridge that cut_at names"
    );
    Some(Warning::new(WarningCode::UnclosedDirectrices, detail).with_count("count", loops.len()))
}

/// Whether two polylines have the same points in the same or the opposite order.
fn is_same(p: &[DVec3], q: &[DVec3], tolerance: f64) -> bool {
    let near = |(a, b): (&DVec3, &DVec3)| a.distance(*b) <= tolerance;
    p.len() == q.len() && (p.iter().zip(q).all(near) || p.iter().zip(q.iter().rev()).all(near))
}

/// Finds a point where two polylines cross or touch. A common end of two open polylines does not count, because there
/// an open strip comes to a point on purpose.
fn meeting(
    p: &[DVec3],
    q: &[DVec3],
    closed: bool,
    tolerance: f64,
    execution: &Execution<'_>,
) -> Result<Option<MeetingSegments>, Interruption> {
    let at_end = |points: &[DVec3], place: DVec3| {
        [points[0], points[points.len() - 1]].into_iter().any(|end| end.distance(place) <= 2.0 * tolerance)
    };
    let counts = |contact: &MeetingSegments| closed || !(at_end(p, contact.point) && at_end(q, contact.point));
    first_contact(&Segments::new(p, closed), &Segments::new(q, closed), tolerance, counts, execution)
}

#[cfg(test)]
mod tests {
    use crate::{Options, solve};
    use plateau_mesh::{DVec3, Execution, WarningCode};

    fn codes(directrices: &[&[[f64; 3]]], closed: bool) -> Vec<(WarningCode, String)> {
        let directrices: Vec<Vec<DVec3>> =
            directrices.iter().map(|points| points.iter().copied().map(DVec3::from).collect()).collect();
        let solved = solve(&directrices, &Options { closed, ..Options::default() }, &Execution::default()).unwrap();
        let named =
            [WarningCode::IdenticalDirectrices, WarningCode::CrossingDirectrices, WarningCode::UnclosedDirectrices];
        let warnings = solved.warnings.into_iter().filter(|warning| named.contains(&warning.code));
        warnings.map(|warning| (warning.code, warning.detail)).collect()
    }

    const RAIL: [[f64; 3]; 3] = [[0.0, 0.0, 0.0], [1.0, 0.0, 0.2], [2.0, 0.0, 0.0]];
    const OTHER: [[f64; 3]; 2] = [[0.0, 1.0, 0.0], [2.0, 1.0, 0.5]];

    #[test]
    fn ordinary_directrices_have_no_such_warning() {
        assert_eq!(codes(&[&RAIL, &OTHER], false), []);
        // Neither two arcs that meet at both ends nor an apex beside a rail gives a warning.
        let arc = [[0.0, 0.0, 0.0], [1.0, 1.0, 0.2], [2.0, 0.0, 0.0]];
        assert_eq!(codes(&[&RAIL, &arc], false), []);
        assert_eq!(codes(&[&RAIL, &[[1.0, 3.0, 0.0]]], false), []);
    }

    #[test]
    fn equal_directrices_are_named() {
        let back = [RAIL[2], RAIL[1], RAIL[0]];
        for same in [&RAIL, &back] {
            let found = codes(&[&RAIL, same], false);
            assert_eq!(found.len(), 1, "{found:?}");
            assert!(
                found[0].0 == "identical_directrices" && found[0].1.starts_with("directrices 0 and 1 are the same")
            );
        }
    }

    #[test]
    fn directrices_that_cross_are_told_where() {
        let across = [[0.5, -1.0, 0.1], [0.5, 0.5, 0.1], [2.0, 1.0, 0.0]];
        let found = codes(&[&OTHER, &RAIL, &across], false);
        assert_eq!(found.len(), 1, "{found:?}");
        let expected = "directrices 1 and 2 cross or touch between the points 0 and 1 of directrix 1: ";
        assert!(found[0].0 == "crossing_directrices" && found[0].1.starts_with(expected), "{found:?}");
    }

    #[test]
    fn loops_that_are_not_closed_are_named() {
        let square =
            |z: f64, size: f64| [[0.0, 0.0, z], [size, 0.0, z], [size, size, z], [0.0, size, z], [0.0, 0.0, z]];
        let (low, high) = (square(0.0, 1.0), square(1.0, 2.0));
        let found = codes(&[&low, &high], false);
        assert_eq!(found.len(), 1, "{found:?}");
        assert!(
            found[0].0 == "unclosed_directrices" && found[0].1.starts_with("directrices 0, 1 end where they begin")
        );
        assert!(found[0].1.contains("cut at the bridge of least fold"), "{}", found[0].1);
        assert_eq!(codes(&[&low, &high], true), []);
    }
}
