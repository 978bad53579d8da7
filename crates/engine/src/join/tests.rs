//! Tests of joining without a solver.

use super::*;
use plateau_mesh::random::SplitMix64;

fn at(x: f64, y: f64, z: f64) -> DVec3 {
    DVec3::new(x, y, z)
}

/// A square with sides of 10. With a guide from its middle to a corner, the tolerance is 8.25e-6.
fn square() -> Vec<Vec<DVec3>> {
    vec![vec![at(0.0, 0.0, 0.0), at(10.0, 0.0, 0.0), at(10.0, 10.0, 0.0), at(0.0, 10.0, 0.0)]]
}

fn guide(number: usize, points: &[DVec3]) -> Member {
    Member { role: Role::Guide, list: "/constraints/polylines", number, field: "", points: points.to_vec() }
}

fn cable(number: usize, points: [DVec3; 2]) -> Member {
    Member { role: Role::Cable, list: "/cables", number, field: "/points", points: points.to_vec() }
}

fn joint(number: usize, point: DVec3) -> Member {
    Member { role: Role::Joint, list: "/joints", number, field: "", points: vec![point] }
}

/// Joins members over boundaries of which only point 1 of the first moves.
fn join_over(boundaries: &[Vec<DVec3>], members: Vec<Member>, tolerance: Option<f64>) -> Result<Joined, Rejection> {
    let mut moves: Vec<Vec<bool>> = boundaries.iter().map(|points| vec![false; points.len()]).collect();
    moves[0][1] = true;
    join(&Points { boundaries, moves, members, tolerance, on_segments: OnSegments::Joined })
}

fn joined(members: Vec<Member>) -> Joined {
    join_over(&square(), members, None).unwrap_or_else(|refused| panic!("{refused:?}"))
}

fn refused(result: Result<Joined, Rejection>) -> Vec<FieldError> {
    match result {
        Err(Rejection::Invalid(errors)) => errors,
        other => panic!("{other:?}"),
    }
}

fn codes(joined: &Joined) -> Vec<&str> {
    joined.notes.warnings.iter().map(|warning| warning.code.name()).collect()
}

#[test]
fn ends_within_the_tolerance_take_the_place_of_the_boundary_point_and_others_stay() {
    let corner = at(10.0, 10.0, 0.0);
    for (off, is_near) in [(2e-15, true), (1e-9, true), (8e-6, true), (9e-6, false)] {
        let end = corner + at(0.0, 0.0, off);
        let found = joined(vec![guide(0, &[at(5.0, 5.0, 1.0), end])]);
        assert_eq!(found.points[0][1], if is_near { corner } else { end }, "{off}");
        assert_eq!(codes(&found), if is_near { vec!["joined"] } else { vec!["nearly_joined"] }, "{off}");
        assert!(found.ends.is_empty());
    }
    let exact = joined(vec![guide(0, &[at(5.0, 5.0, 1.0), corner])]);
    assert_eq!((exact.points[0][1], codes(&exact)), (corner, vec![]));
    let far = joined(vec![guide(0, &[at(5.0, 5.0, 1.0), at(9.0, 9.0, 0.0)])]);
    assert_eq!((far.points[0][1], codes(&far)), (at(9.0, 9.0, 0.0), vec![]));
}

#[test]
fn the_tolerance_is_that_of_the_request_and_never_below_the_rounding_of_the_coordinates() {
    let corner = at(10.0, 10.0, 0.0);
    let with = |off: f64, tolerance: f64| {
        let end = corner - at(0.0, off, 0.0);
        let found = join_over(&square(), vec![guide(0, &[at(5.0, 5.0, 1.0), end])], Some(tolerance)).unwrap();
        found.points[0][1] == corner
    };
    assert!(with(0.1, 0.2) && !with(0.3, 0.2) && !with(1e-9, 1e-10) && with(2e-15, 0.0) && !with(1e-13, 0.0));
}

#[test]
fn a_point_near_two_is_refused_with_both_and_equal_bits_win() {
    let mut boundaries = square();
    let near = at(10.0, 3e-6, 0.0);
    boundaries[0].insert(2, near);
    let between = at(10.0, 1e-6, 0.0);
    let errors = refused(join_over(&boundaries, vec![guide(0, &[at(5.0, 5.0, 1.0), between])], None));
    assert_eq!((errors.len(), errors[0].pointer.as_str()), (1, "/constraints/polylines/0/1"));
    assert!(errors[0].detail.contains("/boundaries/0/1 and to /boundaries/0/2"), "{}", errors[0].detail);
    for own in [near, at(10.0, 0.0, 0.0)] {
        let found = join_over(&boundaries, vec![guide(0, &[at(5.0, 5.0, 1.0), own])], None).unwrap();
        assert_eq!((found.points[0][1], codes(&found)), (own, vec![]));
    }
    // A row of points, each near the next one.
    let row: Vec<DVec3> = (0..3).map(|k| at(5.0 + 5e-6 * f64::from(k), 5.0, 1.0)).collect();
    let members = row.iter().enumerate().map(|(k, &point)| guide(k, &[point, at(2.0, 2.0 + k as f64, 1.0)]));
    let errors = refused(join_over(&square(), members.collect(), None));
    assert!(errors[0].pointer.starts_with("/constraints/polylines/"), "{errors:?}");
}

#[test]
fn members_whose_ends_become_one_are_refused_at_both_ends_and_guides_of_more_points_close() {
    let (end, near) = (at(5.0, 5.0, 1.0), at(5.0, 5.0, 1.000_001));
    let errors = refused(join_over(&square(), vec![cable(3, [end, near])], None));
    let pointers: Vec<&str> = errors.iter().map(|error| error.pointer.as_str()).collect();
    assert_eq!(pointers, ["/cables/3/points/0", "/cables/3/points/1"]);
    assert_eq!(refused(join_over(&square(), vec![guide(0, &[end, near])], None)).len(), 2);
    let closed = joined(vec![guide(0, &[end, at(6.0, 5.0, 1.0), at(6.0, 6.0, 1.0), near])]);
    assert_eq!((closed.points[0][3], codes(&closed)), (end, vec!["joined"]));
}

#[test]
fn points_in_the_air_take_the_place_that_most_of_them_have() {
    let (place, off) = (at(13.0, -3.0, 4.0), at(13.0, -3.0, 4.000_000_1));
    let anchors = [at(20.0, -9.0, 0.0), at(20.0, 1.0, 0.0), at(10.0, 0.0, 0.0)];
    for wrong in 0..4 {
        let own = |k: usize| if k == wrong { off } else { place };
        let cables = anchors.iter().enumerate().map(|(k, &anchor)| cable(k, [own(k), anchor]));
        let found = joined(cables.chain([joint(0, own(3))]).collect());
        assert!((0..4).all(|k| found.points[k][0] == place), "{wrong}: {:?}", found.points);
        assert_eq!((codes(&found), found.notes.warnings[0].values[0]), (vec!["joined"], ("count", 1.0)));
    }
    // A joint at a boundary's point takes its place, where the geometry refuses it.
    assert_eq!(joined(vec![joint(0, at(10.0, 0.0, 1e-7))]).points[0], [at(10.0, 0.0, 0.0)]);
}

#[test]
fn ends_on_segments_are_points_of_the_boundary_for_curves_and_refused_for_cables_in_the_air() {
    let across = |points: [DVec3; 2]| Member { role: Role::Across, field: "/across", ..cable(0, points) };
    let found = joined(vec![across([at(4.0, 0.0, 0.0), at(6.0, 10.0, 1e-6)])]);
    assert_eq!(found.points[0], [at(4.0, 0.0, 0.0), at(6.0, 10.0, 0.0)]);
    let ends: Vec<(usize, DVec3)> = found.ends.iter().map(|end| (end.segment, end.place)).collect();
    assert_eq!(ends, [(0, at(4.0, 0.0, 0.0)), (2, at(6.0, 10.0, 0.0))]);
    assert_eq!(codes(&found), ["joined"]);
    let errors = refused(join_over(&square(), vec![cable(2, [at(4.0, 0.0, 0.0), at(4.0, -5.0, 0.0)])], None));
    assert_eq!((errors.len(), errors[0].pointer.as_str()), (1, "/cables/2/points/0"));
    assert!(errors[0].detail.contains("the segment from /boundaries/0/0 to /boundaries/0/1"), "{}", errors[0].detail);
    // A cable across that ends beside the boundary is refused with the nearest point.
    let errors = refused(join_over(&square(), vec![across([at(0.0, 0.0, 1e-3), at(6.0, 10.0, 0.0)])], None));
    assert_eq!(errors[0].pointer, "/cables/0/across/0");
    assert!(errors[0].detail.contains("/boundaries/0/0 is 1.00e-3 away"), "{}", errors[0].detail);
}

#[test]
fn ends_near_points_that_move_are_named_and_two_supports_never() {
    // Point 1 of the boundary moves, and point 2 does not.
    let beside = |corner: DVec3| joined(vec![cable(0, [corner + at(0.0, 0.0, 1e-3), at(5.0, -8.0, -3.0)])]);
    let found = beside(at(10.0, 0.0, 0.0));
    assert_eq!(codes(&found), ["nearly_joined"]);
    let detail = &found.notes.warnings[0].detail;
    assert!(detail.starts_with("/cables/0/points/0 lies 1.00e-3 from /boundaries/0/1 "), "{detail}");
    assert_eq!(found.notes.nearly[0].place.to_string(), "/cables/0/points/0");
    assert!(codes(&beside(at(10.0, 10.0, 0.0))).is_empty());
    // The support of a short cable is near the point to which the cable itself is tied.
    let short = joined(vec![cable(0, [at(10.0, 0.0, 0.0), at(10.03, -0.03, 0.0)])]);
    assert!(codes(&short).is_empty(), "{:?}", short.notes.warnings);
}

#[test]
fn near_points_of_boundaries_stay_where_they_are() {
    let random = &mut SplitMix64::new(11);
    for _ in 0..50 {
        // A slit whose rims are from 1e-8 to 1e-6 apart, with the ends of two guides on its rims.
        let width = 10f64.powf(-random.between(6.0, 8.0));
        let (x, depth) = (random.between(3.0, 7.0), random.between(2.0, 6.0));
        let rims = [at(x - width, depth, 0.0), at(x + width, depth, 0.0)];
        let tip = at(x, depth + 1.0, 0.0);
        let mut outline =
            vec![at(0.0, 0.0, 0.0), at(x - width, 0.0, 0.0), rims[0], tip, rims[1], at(x + width, 0.0, 0.0)];
        outline.extend([at(10.0, 0.0, 0.0), at(10.0, 10.0, 0.0), at(0.0, 10.0, 0.0)]);
        let guides = rims.map(|rim| vec![rim, at(x, 9.0, 1.0)]);
        let members = vec![guide(0, &guides[0]), guide(1, &guides[1])];
        let found = join_over(&[outline.clone()], members, None).unwrap();
        assert_eq!((found.points, found.ends.len()), (guides.to_vec(), 0));
        assert!(found.notes.warnings.is_empty());
        let errors = refused(join_over(&[outline], vec![guide(0, &[at(x, depth, 0.0), at(x, 9.0, 1.0)])], None));
        assert!(errors[0].detail.contains("/boundaries/0/2 and to /boundaries/0/4"), "{errors:?}");
    }
}
