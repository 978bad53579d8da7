//! Bend allowances, setbacks and blanks of sheet metal.

use crate::patterns::{make, options, pieces, refused};
use crate::samples::{all, ring, ruled};
use plateau_drawing::figure::{Shape, figures};
use plateau_drawing::metal::{Bend, Blank, bend_allowance, blank, hits, setback};
use plateau_drawing::options::{Convention, Layer, Metal, Relief, Skin};
use plateau_drawing::piece::{FoldKind, Piece};
use plateau_drawing::{Refused, polygon};
use plateau_mesh::{DVec2, DVec3};
use plateau_ruled_surface::{Objective, Options};

pub fn metal(radius: f64, thickness: f64, k: Option<f64>) -> Metal {
    Metal { thickness, radius, k, ..Metal::default() }
}

#[test]
fn allowances_and_deductions_are_those_of_the_tables() {
    // Angle, radius, thickness, k; bend allowance; twice the outside setback less the allowance.
    let rows = [
        (90.0, 1.0, 1.0, 0.5, 2.356_194, 1.643_806),
        (90.0, 2.0, 2.0, 0.33, 4.178_318, 3.821_682),
        (120.0, 2.0, 2.0, 0.4, 5.864_306, 7.992_100),
    ];
    for (angle, radius, thickness, k, allowance, deduction) in rows {
        let metal = Metal { skin: Skin::Front, ..metal(radius, thickness, Some(k)) };
        let found = bend_allowance(&metal, f64::to_radians(angle));
        assert!((found - allowance).abs() < 1e-6, "{found}");
        // A second route: the length of an arc at the neutral radius, summed over chords.
        let neutral = radius + k * thickness;
        let steps = 100_000;
        let chord = 2.0 * neutral * (0.5 * f64::to_radians(angle) / f64::from(steps)).sin();
        assert!((found - chord * f64::from(steps)).abs() < 1e-9);
        assert!((2.0 * setback(&metal, angle) - found - deduction).abs() < 1e-6);
        // The outside setback by another route: the tangents at both ends of the outer arc meet in the outer corner.
        let outer = radius + thickness;
        let (sine, cosine) = f64::to_radians(angle).sin_cos();
        let (start, end) = (DVec2::new(outer, 0.0), outer * DVec2::new(cosine, sine));
        let (along, back) = (DVec2::Y, DVec2::new(sine, -cosine));
        let corner = start + along * ((end - start).perp_dot(back) / along.perp_dot(back));
        assert!((corner.distance(start) - setback(&metal, angle)).abs() < 1e-12);
        assert!((corner.distance(start) + corner.distance(end) - found - deduction).abs() < 1e-6);
    }
    let din = Metal { convention: Convention::Din, skin: Skin::Front, ..metal(2.0, 2.0, None) };
    let found = bend_allowance(&din, f64::to_radians(90.0));
    assert!((found - 4.162_610).abs() < 1e-6, "{found}");
    assert!((found - 2.0 * setback(&din, 90.0) + 3.837_390).abs() < 1e-6);
    // DIN's factor is at most 1, and half of ANSI's for the same neutral line.
    let wide = Metal { convention: Convention::Din, ..metal(200.0, 2.0, None) };
    assert_eq!(bend_allowance(&wide, 1.0), 201.0);
    let both = [Convention::Ansi, Convention::Din].map(|convention| Metal { convention, ..metal(3.0, 2.0, Some(0.4)) });
    assert!((bend_allowance(&both[0], 1.0) - 3.8).abs() < 1e-15 && (bend_allowance(&both[1], 1.0) - 3.4).abs() < 1e-15);
    // The skins change places between a mountain and a valley.
    let skin = |skin: Skin, angle: f64| setback(&Metal { skin, ..metal(2.0, 1.0, None) }, angle);
    assert!((skin(Skin::Front, 90.0) - 3.0).abs() < 1e-15 && (skin(Skin::Front, -90.0) - 2.0).abs() < 1e-15);
    assert_eq!((skin(Skin::Back, 90.0), skin(Skin::Back, -90.0)), (skin(Skin::Front, -90.0), skin(Skin::Front, 90.0)));
    assert!((skin(Skin::Middle, 90.0) - 2.5).abs() < 1e-15);
}

#[test]
fn a_bend_has_the_least_hits_within_the_chord_error() {
    for (angle, radius, error) in [(90.0, 10.0, 0.1), (30.0, 500.0, 0.05), (5.0, 2.0, 1.0), (170.0, 80.0, 0.02)] {
        let metal = Metal { chord_error: Some(error), ..metal(radius, 1.0, None) };
        let angle = f64::to_radians(angle);
        let chord_error = |n: usize| radius * (1.0 - (angle / (2 * n) as f64).cos());
        let expected = (1..).find(|&n| chord_error(n) <= error).unwrap();
        assert_eq!(hits(&metal, angle), Some(expected));
    }
    assert_eq!(hits(&Metal { chord_error: Some(1e-4), ..metal(1e5, 1.0, None) }, 3.0), None);
}

/// Returns two flat legs of this width, in millimetres, that meet at a right angle.
fn angle_profile(leg: f64, sign: f64) -> plateau_archive::Archive {
    let rail =
        |y: f64| [[0.0, 0.0], [leg, 0.0], [leg, -sign * leg]].map(|[x, z]| DVec3::new(1e-3 * x, y, 1e-3 * z)).to_vec();
    ruled(&[rail(0.0), rail(0.1)], &Options { objective: Objective::MinimalBendingEnergy, ..Options::default() })
}

#[test]
fn an_angle_profile_has_the_blank_of_the_text_books() {
    // A blank of 100 with a bend of 90 degrees, r 1, t 1, k 0.5 has legs of (100 - BA) / 2 = 48.821903.
    for (sign, skin) in [(1.0, Skin::Front), (-1.0, Skin::Back)] {
        let archive = angle_profile(48.821_903 + 2.0, sign);
        let [piece] = &millimetres(&archive)[..] else { panic!() };
        let metal = Metal { skin, ..metal(1.0, 1.0, Some(0.5)) };
        let blank = blank(piece, &metal).unwrap();
        let [low, high] = blank.piece.bounds();
        assert!(((high - low).x - 100.0).abs() < 1e-6, "{}", (high - low).x);
        assert!((polygon::area(&blank.piece.outline) - 100.0 * 100.0).abs() < 1e-3);
        let [bend] = blank.bends[..] else { panic!("{:?}", blank.bends) };
        assert!((bend.angle_deg - 90.0 * sign).abs() < 1e-9);
        // The line to bend about lies in the middle.
        let [line] = &blank.piece.folds[..] else { panic!() };
        assert!(line.ends.iter().all(|end| (end.x - low.x - 50.0).abs() < 1e-6));
        // The inner skin is shorter by twice the thickness; the middle lies between.
        let width = |skin: Skin| {
            let blank = plateau_drawing::metal::blank(piece, &Metal { skin, ..metal }).unwrap();
            let [low, high] = blank.piece.bounds();
            high.x - low.x
        };
        let other = if skin == Skin::Front { Skin::Back } else { Skin::Front };
        assert!((width(other) - width(skin) - 2.0).abs() < 1e-9);
        assert!((width(Skin::Middle) - width(skin) - 1.0).abs() < 1e-9);
    }
}

pub fn millimetres(archive: &plateau_archive::Archive) -> Vec<Piece> {
    let mut contents = archive.contents().clone();
    contents.mesh.vertices.iter_mut().for_each(|vertex| *vertex *= 1000.0);
    pieces(&plateau_archive::Archive::new(contents).unwrap())
}

/// Gives each panel of a blank the setbacks of `metal` back, and returns the largest difference of its sides from the
/// piece, and of the widths of the zones from `allowance`.
pub fn unmade_error(piece: &Piece, blank: &Blank, metal: &Metal, allowance: impl Fn(f64) -> f64) -> [f64; 2] {
    let mut errors = [0.0_f64; 2];
    for (zone, bend) in blank.zones.iter().zip(&blank.bends) {
        let [start, end] = *zone;
        let along = (start[1] - start[0]).normalize();
        for point in end {
            let width = along.perp_dot(point - start[0]).abs();
            errors[1] = errors[1].max((width - allowance(bend.angle_deg.abs().to_radians())).abs());
        }
    }
    let bend_at = |k: usize| blank.bends.iter().find(|bend| bend.panel == 2 * k + 1);
    // Panels between two bends that are one triangle, because no flat fold lies between them.
    let bridges: Vec<u32> = piece.folds.iter().map(|fold| fold.bridge).collect();
    for k in 0..blank.piece.panels.len() / 2 {
        // The sides at the bends before and after, moved out by their setbacks.
        let (Some(first), Some(second)) = (k.checked_sub(1).and_then(bend_at), bend_at(k)) else { continue };
        let place = |bend: &Bend| bridges.iter().position(|bridge| *bridge == bend.bridge).unwrap();
        if place(second) != place(first) + 1 {
            continue;
        }
        let triangle = piece.panels[place(second)];
        let before = (first.sides[1], setback(metal, first.angle_deg));
        let after = (second.sides[0], setback(metal, second.angle_deg));
        let corners = &blank.piece.panels[2 * k];
        let centre = corners.iter().sum::<DVec2>() / 3.0;
        let out = |(side, distance): ([DVec2; 2], f64)| {
            let along = (side[1] - side[0]).normalize();
            let normal = if (centre - side[0]).dot(along.perp()) > 0.0 { -along.perp() } else { along.perp() };
            (side[0] + normal * distance, along)
        };
        let meet = |(a, u): (DVec2, DVec2), (b, v): (DVec2, DVec2)| a + u * ((b - a).perp_dot(v) / u.perp_dot(v));
        let (first, second) = (out(before), out(after));
        let apex = meet(first, second);
        let panel = corners;
        let on = |point: &DVec2, (a, u): (DVec2, DVec2), distance: f64| {
            (u.perp_dot(*point - a).abs() - distance).abs() < 1e-9
        };
        let of_first = panel.iter().find(|p| on(p, first, before.1) && !on(p, second, after.1)).unwrap();
        let of_second = panel.iter().find(|p| on(p, second, after.1) && !on(p, first, before.1)).unwrap();
        let rail = (*of_first, (*of_second - *of_first).normalize());
        let whole = [apex, meet(first, rail), meet(second, rail)];
        let sides = |corners: &[DVec2; 3]| {
            let mut sides = [0, 1, 2].map(|k| corners[k].distance(corners[(k + 1) % 3]));
            sides.sort_by(f64::total_cmp);
            sides
        };
        let (found, expected) = (sides(&whole), sides(&triangle));
        (0..3).for_each(|k| errors[0] = errors[0].max((found[k] - expected[k]).abs()));
    }
    errors
}

#[test]
fn a_blank_bent_again_has_the_panels_of_the_strip_and_zones_as_wide_as_the_allowance() {
    let mut seen = 0;
    for (name, archive) in all() {
        for piece in millimetres(&archive).iter().filter(|piece| piece.ends.is_some()) {
            for skin in [Skin::Front, Skin::Middle, Skin::Back] {
                let metal = Metal { skin, relief: Relief::Auto, ..metal(1.0, 0.8, Some(0.4)) };
                let Ok(made) = blank(piece, &metal) else {
                    panic!("{name} {}: {:?}", piece.name, blank(piece, &metal))
                };
                let bends = piece.folds.iter().filter(|fold| fold.kind() != FoldKind::Flat).count();
                assert_eq!((made.bends.len(), made.zones.len()), (bends, bends));
                assert!(polygon::crossing(&made.piece.outline).is_none() && polygon::area(&made.piece.outline) > 0.0);
                let errors = unmade_error(piece, &made, &metal, |angle| bend_allowance(&metal, angle));
                assert!(errors[0] < 1e-8 && errors[1] < 1e-8, "{name} {} {errors:?}", piece.name);
                // A fault: the allowance of another k-factor.
                let wrong = unmade_error(piece, &made, &metal, |angle| angle * (1.0 + 0.44 * 0.8));
                assert!(wrong[1] > 1e-4);
                seen += 1;
            }
        }
    }
    assert!(seen > 20);
}

#[test]
fn reliefs_are_circles_at_the_points_where_bends_meet() {
    let (_, archive) = all().remove(3);
    for piece in millimetres(&archive) {
        let plain = metal(1.0, 1.0, Some(0.4));
        let none = blank(&piece, &plain).unwrap().piece;
        let auto = blank(&piece, &Metal { relief: Relief::Auto, ..plain }).unwrap().piece;
        let wide = blank(&piece, &Metal { relief: Relief::Radius(30.0), ..plain }).unwrap().piece;
        // The zones do not overlap with the mesh in the middle of the sheet, so that `auto` cuts nothing.
        assert_eq!(auto, none);
        let lost = polygon::area(&none.outline) - polygon::area(&wide.outline);
        // Each circle takes less than its area, and bends meet in the four corners of the rectangle and elsewhere.
        assert!(lost > 4.0 * 100.0 && lost < 20.0 * std::f64::consts::PI * 900.0, "{lost}");
        assert!(polygon::crossing(&wide.outline).is_none());
        // With the mesh on the outer skin they overlap.
        let front = Metal { skin: Skin::Front, ..plain };
        let Err(Refused::Unsuitable(errors)) = blank(&piece, &front) else { panic!("zones overlap") };
        assert_eq!(errors[0].parameter, "relief");
        let relieved = blank(&piece, &Metal { relief: Relief::Auto, ..front }).unwrap().piece;
        assert!(polygon::crossing(&relieved.outline).is_none());
        for fold in &wide.folds {
            for end in fold.ends {
                let on_edge = (0..wide.outline.len()).any(|k| {
                    let (a, b) = (wide.outline[k], wide.outline[(k + 1) % wide.outline.len()]);
                    (b - a).perp_dot(end - a).abs() < 0.05 * a.distance(b) + 1e-9
                        && a.distance(end) <= a.distance(b) + 0.1
                });
                assert!(on_edge, "a bend line ends on the outline: {end}");
            }
        }
    }
}

#[test]
fn bend_lines_have_layers_by_direction_and_their_zones_beside_them() {
    let (_, archive) = all().remove(0);
    let options = options("profile=sheet-metal&thickness=1&radius=2&chord_error=0.01&format=dxf");
    let pieces = millimetres(&archive);
    let made = figures(&pieces, &options).unwrap();
    for line in &made[0].lines {
        assert_eq!(line.layer, if line.angle_deg < 0.0 { Layer::BendUp } else { Layer::BendDown });
    }
    let zones =
        made[0].shapes.iter().filter(|shape| matches!(shape, Shape::Line { layer: Layer::BendZone, .. })).count();
    let bends = pieces[0].folds.iter().filter(|fold| fold.kind() != FoldKind::Flat);
    assert_eq!(zones, 2 * bends.clone().count());
    for bend in bends {
        let hits: Vec<f64> =
            made[0].lines.iter().filter(|line| line.bridge == bend.bridge).map(|line| line.angle_deg).collect();
        assert!((hits.iter().sum::<f64>() - bend.angle_deg).abs() < 1e-12);
    }
    let svg = String::from_utf8(make(&archive, "profile=sheet-metal&thickness=1").unwrap()).unwrap();
    assert!(svg.contains(r#"class="bend_up" data-angle-deg=""#) && svg.contains(">bend 0: strip 1, bridge 1,"));
}

#[test]
fn bends_without_room_are_refused_by_their_parameter() {
    let (_, archive) = all().remove(3);
    for (query, parameter) in [
        ("profile=sheet-metal&thickness=1&radius=2000", "radius"),
        ("profile=sheet-metal&thickness=1&radius=1&skin=front", "relief"),
    ] {
        assert_eq!(refused(make(&archive, query)), (false, vec![parameter.to_owned()]), "{query}");
    }
    // The panels of a metre have room for the setbacks at 174 and at 176 degrees, but above 175 nothing is bent.
    let folded = |angle: f64| {
        let (sine, cosine) = angle.to_radians().sin_cos();
        let rail = |y: f64| [[0.0, 0.0], [1.0, 0.0], [1.0 + cosine, sine]].map(|[x, z]| DVec3::new(x, y, z)).to_vec();
        make(&ruled(&[rail(0.0), rail(1.0)], &Options::default()), "profile=sheet-metal&thickness=1")
    };
    assert!(folded(174.0).is_ok());
    assert_eq!(refused(folded(176.0)), (false, vec!["radius".to_owned()]));
}

/// The panels of a closed prism of eight sides end where its setbacks do: below the radius at which a side has no flat
/// part left there is a blank, and above it there is none.
#[test]
fn bend_zones_that_leave_nothing_of_a_panel_are_refused_from_the_radius_on_at_which_they_meet() {
    let closed = Options { closed: true, objective: Objective::MinimalBendingEnergy, ..Options::default() };
    let prism = ruled(&[ring(8, 0.5, 0.0, 0.0), ring(8, 0.5, 1.0, 0.0)], &closed);
    // A side of 1000 sin(22.5°) mm has two setbacks tan(22.5°) (r + t / 2).
    let eighth = 22.5_f64.to_radians();
    let limit = 1000.0 * eighth.sin() / (2.0 * eighth.tan()) - 0.5;
    for (radius, is_made) in [(limit - 0.01, true), (limit + 0.01, false)] {
        let made = make(&prism, &format!("profile=sheet-metal&thickness=1&radius={radius}&angles=false"));
        match made {
            Ok(_) => assert!(is_made, "{radius}"),
            refusal => assert_eq!((is_made, refused(refusal)), (false, (false, vec!["radius".to_owned()])), "{radius}"),
        }
    }
}

/// The development of a corner of the square: the cone over a quarter of the circle, by the rule of Simpson. Returns
/// its angle at the corner and its area.
fn corner_cone() -> [f64; 2] {
    let at = |turn: f64| DVec3::new(0.6 * turn.cos() - 1.0, 0.6 * turn.sin() - 1.0, 1.5);
    let along = |turn: f64| 0.6 * DVec3::new(-turn.sin(), turn.cos(), 0.0);
    let twice_area = |turn: f64| at(turn).cross(along(turn)).length();
    let angle = |turn: f64| twice_area(turn) / at(turn).length_squared();
    let steps = 1000;
    let step = std::f64::consts::FRAC_PI_2 / f64::from(steps);
    let weight = |k: i32| if k == 0 || k == steps { 1.0 } else { f64::from(2 + 2 * (k % 2)) };
    let sum =
        |of: &dyn Fn(f64) -> f64| (0..=steps).map(|k| weight(k) * of(f64::from(k) * step)).sum::<f64>() * step / 3.0;
    [sum(&angle), 0.5 * sum(&twice_area)]
}

#[test]
fn a_square_to_round_tends_to_its_four_cones_and_triangles() {
    // Square of side 2 to a circle of radius 0.6 at height 1.5: the area is 9.316352. By another route it is that of
    // four cones and of four triangles, each over a side of the square.
    let [angle, area] = corner_cone();
    assert!((angle - 0.505_840).abs() < 1e-6, "{angle}");
    let whole = 4.0 * (area + 0.5 * 2.0 * f64::hypot(0.4, 1.5));
    assert!((whole - 9.316_352).abs() < 1e-6, "{whole}");
    let mut errors = Vec::new();
    let mut angles = Vec::new();
    for count in [32, 64, 128] {
        let square = [[-1.0, -1.0], [1.0, -1.0], [1.0, 1.0], [-1.0, 1.0]].map(|[x, y]| DVec3::new(x, y, 0.0)).to_vec();
        let options = Options { closed: true, objective: Objective::MinimalBendingEnergy, ..Options::default() };
        let archive = ruled(&[square, ring(count, 0.6, 1.5, 0.0)], &options);
        let area: f64 = pieces(&archive).iter().map(|piece| polygon::area(&piece.outline)).sum();
        errors.push((area - 9.316_352).abs());
        // The folds at each corner of the square: the longest and the shortest are the slants of the cone, and the
        // angle between the outer ones is that of the cone.
        let mut corners: Vec<Vec<[DVec2; 2]>> = Vec::new();
        let [piece] = &pieces(&archive)[..] else { panic!("one piece") };
        let bridges = piece.folds.iter().map(|fold| fold.ends);
        for ends in bridges {
            match corners.last_mut() {
                Some(fan) if fan[0][0] == ends[0] => fan.push(ends),
                _ => corners.push(vec![ends]),
            }
        }
        // The strip is cut at one of the bridges, so that the fan of this bridge is in two parts.
        for fan in corners.iter().filter(|fan| fan.len() == count / 4 + 1) {
            let length = |[p, q]: &[DVec2; 2]| p.distance(*q);
            let longest = fan.iter().map(length).fold(0.0, f64::max);
            let shortest = fan.iter().map(length).fold(f64::INFINITY, f64::min);
            assert!((longest - 1.846_619).abs() < 1e-6 && (shortest - 1.706_735).abs() < 1e-6, "{longest} {shortest}");
            let direction = |[p, q]: [DVec2; 2]| q - p;
            angles.push((count, direction(fan[0]).angle_to(direction(fan[fan.len() - 1])).abs()));
        }
    }
    assert!(errors[2] < 2e-3 && errors[0] / errors[1] > 3.0 && errors[1] / errors[2] > 3.0, "{errors:?}");
    let worst = |count: usize| {
        let own = angles.iter().filter(|(own, _)| *own == count).map(|(_, found)| (found - angle).abs());
        own.reduce(f64::max).expect("a whole fan")
    };
    assert!(worst(128) < 1e-4 && worst(64) / worst(128) > 3.0, "{angles:?}");
}
