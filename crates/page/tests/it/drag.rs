//! Tests of a session whose last result moves while the user drags points.

use plateau_engine::solved::Signal;
use plateau_page::session::{Ending, Session};
use serde_json::Value;

const STRIP: &str =
    r#"{"kind": "ruled_surface", "directrices": [[[0, 0, 0], [1, 0, 0], [2, 0, 0]], [[0, 1, 0], [2, 1, 1]]]}"#;

fn solve(session: &mut Session, request: &str) -> (Ending, Value) {
    let ending = session.solve(request.as_bytes(), &|| Signal::Continue, &|_| {});
    (ending, serde_json::from_slice(session.answer()).unwrap_or_default())
}

/// Returns the request for a square boundary of 4 x `side` points whose corner 2 is raised by `height`.
fn square(side: usize, height: f64, triangles: usize) -> String {
    let corners = [[0.0, 0.0, 0.0], [1.0, 0.0, 0.5], [1.0, 1.0, height], [0.0, 1.0, 0.5]];
    let boundary: Vec<[f64; 3]> = (0..4 * side)
        .map(|k| {
            let (a, b, t) = (corners[k / side], corners[(k / side + 1) % 4], (k % side) as f64 / side as f64);
            [0, 1, 2].map(|axis| a[axis] + t * (b[axis] - a[axis]))
        })
        .collect();
    let resolution = serde_json::json!({ "triangles": triangles });
    serde_json::json!({ "kind": "minimal_surface", "boundaries": [boundary], "resolution": resolution }).to_string()
}

fn drag(session: &mut Session, request: &str) -> (Ending, Value) {
    let ending = session.drag(request.as_bytes(), &|| Signal::Continue, &|_| {});
    (ending, serde_json::from_slice(session.answer()).unwrap_or_default())
}

#[test]
fn a_film_follows_a_drag_and_the_released_film_is_solved() {
    let mut session = Session::default();
    assert_eq!(drag(&mut session, &square(8, 0.0, 2000)).0, Ending::Solved);
    let triangles = session.triangles().to_vec();
    for step in 1..=20 {
        let (ending, answer) = drag(&mut session, &square(8, 0.02 * f64::from(step), 2000));
        assert_eq!(ending, Ending::Moved, "{step}: {answer}");
        assert!(answer["moved"]["residual"].as_f64().is_some_and(|residual| residual <= 1e-4), "{answer}");
    }
    assert_eq!((session.triangles(), session.vertices()[16].z), (&triangles[..], 0.4));
    assert_eq!(session.file("glb"), None);
    let (_, answer) = drag(&mut session, &square(8, 0.4, 2000));
    let preview = answer["moved"]["area"].as_f64().unwrap_or_default();
    let released = square(8, 0.4, 2000);
    let (ending, answer) = solve(&mut session, &released);
    let area = answer["statistics"]["area"].as_f64().unwrap_or_default();
    assert!(ending == Ending::Solved && (preview / area - 1.0).abs() < 1e-3, "{preview} {area}");
    let mut fresh = Session::default();
    solve(&mut fresh, &released);
    assert!(fresh.file("glb").is_some() && session.file("glb") == fresh.file("glb"));
}

#[test]
fn a_request_that_the_result_cannot_follow_is_solved() {
    let mut session = Session::default();
    solve(&mut session, &square(8, 0.0, 2000));
    // A request is solved if it has another number of points, another resolution or another unit than the last one, or
    // if it is of a kind whose results cannot follow a drag.
    assert_eq!(drag(&mut session, &square(9, 0.0, 2000)).0, Ending::Solved);
    assert_eq!(drag(&mut session, &square(9, 0.0, 1500)).0, Ending::Solved);
    let feet = square(9, 0.0, 1500).replacen('{', r#"{"units": "ft", "#, 1);
    assert_eq!(drag(&mut session, &feet).0, Ending::Solved);
    assert_eq!(drag(&mut session, STRIP).0, Ending::Solved);
    assert_eq!(drag(&mut session, STRIP).0, Ending::Solved);
    // If a corner is dragged across the film, triangles flip, so the request is solved instead of moved.
    solve(&mut session, &square(1, 0.0, 2000));
    let turned = square(1, 0.0, 2000).replace("[1.0,1.0,0.0]", "[0.2,0.2,0.0]");
    assert_eq!(drag(&mut session, &turned).0, Ending::Solved);
}

#[test]
fn a_refused_drag_leaves_no_result_and_a_cancelled_drag_leaves_the_film() {
    let mut session = Session::default();
    solve(&mut session, &square(8, 0.0, 2000));
    let before = session.vertices().to_vec();
    let moved = square(8, 0.1, 2000);
    assert_eq!(session.drag(moved.as_bytes(), &|| Signal::Cancel, &|_| {}), Ending::Cancelled);
    assert_eq!(session.vertices(), before);
    assert_eq!(drag(&mut session, &moved).0, Ending::Moved);
    let wrong = moved.replacen("0.0", "null", 1);
    let (ending, answer) = drag(&mut session, &wrong);
    assert_eq!((ending, answer["errors"][0]["pointer"].as_str()), (Ending::Refused, Some("/boundaries/0/0/0")));
    assert!(session.vertices().is_empty() && session.triangles().is_empty());
}
