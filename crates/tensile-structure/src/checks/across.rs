//! Refuses cables across the film that cross each other without meeting.

use super::super::options::{Course, Structure, cable_place};
use plateau_mesh::error::InputError;
use plateau_mesh::polyline::contact::{Segments, first_contact};
use plateau_mesh::{DVec3, Execution, polyline};

/// Two cables meet if their distance is below this fraction of the boundary's radius.
const MEETS: f64 = 1e-9;

/// Place along a boundary: the number of a point or of a segment, and the distance from its first point.
type Along = (usize, f64);

/// Refuses two cables across a film with one boundary if their ends alternate along the boundary and the cables do not
/// meet in space. The cables must then cross on the film, but nothing says where they are joined.
pub(super) fn check_crossings(structure: &Structure, errors: &mut Vec<InputError>) {
    let [boundary] = &structure.boundaries[..] else { return };
    let place = |point: &DVec3| {
        let on_segment = || structure.across_ends.iter().find(|end| end.place == *point).map(|end| end.segment);
        let number = boundary.iter().position(|own| own == point).or_else(on_segment)?;
        Some((number, boundary.get(number)?.distance(*point)))
    };
    let lines: Vec<(usize, &[DVec3], [Along; 2])> = structure
        .cables
        .iter()
        .enumerate()
        .filter_map(|(k, cable)| match &cable.course {
            Course::Across(points) => Some((k, &points[..], [place(points.first()?)?, place(points.last()?)?])),
            Course::Boundary { .. } | Course::Air(_) | Course::Mast(_) => None,
        })
        .collect();
    let near = MEETS * polyline::radius(boundary);
    for (i, (k, points, ends)) in lines.iter().enumerate() {
        for (other, others, other_ends) in &lines[..i] {
            let inside = |end: Along| (other_ends[0] < end) != (other_ends[1] < end);
            let common = ends.iter().any(|end| other_ends.contains(end));
            if !common && inside(ends[0]) != inside(ends[1]) && !meet(points, others, near) {
                let detail =
                    format!("crosses cable {other} without meeting it: give both a common point where they are joined");
                errors.push(InputError::new(cable_place(structure, *k).then("across"), detail));
                break;
            }
        }
    }
}

/// Whether two polylines come nearer to each other than the distance `near`.
fn meet(a: &[DVec3], b: &[DVec3], near: f64) -> bool {
    let [a, b] = [a, b].map(|points| Segments::new(points, false));
    first_contact(&a, &b, near, |_| true, &Execution::default()).is_ok_and(|found| found.is_some())
}
