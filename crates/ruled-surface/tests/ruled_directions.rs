//! Which rails `Direction::Auto` reverses, and when the warning `opposite_directions` is given.

#![allow(clippy::disallowed_methods, clippy::disallowed_types, reason = "this is a test")]

mod ruled;

use plateau_mesh::random::SplitMix64;
use plateau_mesh::{DVec3, Execution};
use plateau_ruled_surface::{Direction, DirectionCriterion, Objective, Options, RuledSurface, Weights, solve};
use ruled::GOALS;
use ruled::pairs::{Pair, closed_pair, open_pair};

fn auto(closed: bool) -> Options {
    Options { closed, direction: Direction::Auto, ..Options::default() }
}

fn solved(rails: &[Vec<DVec3>], options: &Options) -> RuledSurface {
    solve(rails, options, &Execution::default()).expect("rails that can be joined")
}

fn back(points: &[DVec3]) -> Vec<DVec3> {
    points.iter().rev().copied().collect()
}

fn warns(surface: &RuledSurface) -> bool {
    surface.warnings.iter().any(|warning| warning.code == "opposite_directions")
}

/// 350 pairs of open rails and 150 of closed contours.
fn five_hundred_pairs() -> Vec<Pair> {
    let mut random = SplitMix64::new(2005);
    (0..500).map(|k| if k % 10 < 7 { open_pair(&mut random) } else { closed_pair(&mut random) }).collect()
}

/// For pairs of known direction, `Direction::Auto` reverses a rail exactly if one of the two was reversed before,
/// whatever the objective. With `Direction::AsGiven` only the reversed pairs get the warning.
#[test]
fn of_500_pairs_with_a_known_direction_none_is_reversed_wrongly() {
    for (k, Pair { name, closed, rails: [p, q] }) in five_hundred_pairs().into_iter().enumerate() {
        let ways = [
            ([p.clone(), q.clone()], false),
            ([p.clone(), back(&q)], true),
            ([back(&p), q.clone()], true),
            ([q.clone(), p.clone()], false),
        ];
        let (objective, secondary) = GOALS[k % GOALS.len()];
        for (number, (rails, runs_against)) in ways.iter().enumerate() {
            let case = format!("pair {k}, {name}, way {number}, {objective:?} {secondary:?}");
            let by_area = solved(rails, &auto(closed));
            assert_eq!(by_area.reversed, [false, *runs_against], "{case}");
            let by_objective = solved(rails, &Options { objective, secondary, ..auto(closed) });
            assert_eq!(by_objective.reversed, by_area.reversed, "{case}");
            assert_eq!(by_objective.direction_decided_by, by_area.direction_decided_by, "{case}");
            assert!(by_area.direction_decided_by[1] != Some(DirectionCriterion::Objective), "{case}");
            let as_given = solved(rails, &Options { closed, ..Options::default() });
            assert_eq!(warns(&as_given), *runs_against, "{case}");
        }
    }
}

/// If the second rail is reversed, the strip is a bow-tie: its area is the smaller one, but it folds by 169 degrees.
#[test]
fn rails_side_by_side_are_not_folded_into_a_bow_tie() {
    let rail = |count: usize, from: DVec3, to: DVec3| -> Vec<DVec3> {
        (0..count).map(|k| from.lerp(to, k as f64 / (count - 1) as f64)).collect()
    };
    for count in [2, 5, 21] {
        let rails = [
            rail(count, DVec3::ZERO, DVec3::X * 10.0),
            rail(count + count / 3, DVec3::Y * 3.0, DVec3::new(10.0, 3.0, 2.0)),
        ];
        for (objective, secondary) in GOALS {
            let surface = solved(&rails, &Options { objective, secondary, ..auto(false) });
            assert_eq!(surface.reversed, [false, false]);
            assert_eq!(surface.direction_decided_by, [None, Some(DirectionCriterion::Folds)]);
            let fold = surface.statistics.largest_fold.to_degrees();
            assert!(fold < 36.0, "{objective:?} {count}: {fold}");
            assert!(!warns(&surface), "{:?}", surface.warnings);
        }
        let crossed = solved(&[rails[0].clone(), back(&rails[1])], &Options::default());
        assert!((crossed.statistics.largest_fold.to_degrees() - 168.7).abs() < 0.5);
        assert!(warns(&crossed));
    }
}

#[test]
fn every_rail_of_a_stack_follows_the_one_before_it() {
    let mut random = SplitMix64::new(11);
    for closed in [false, true] {
        let Pair { rails: [first, _], .. } = if closed { closed_pair(&mut random) } else { open_pair(&mut random) };
        for flips in 0..32u32 {
            let rail = |k: u32| -> Vec<DVec3> {
                let moved: Vec<DVec3> =
                    first.iter().skip(k as usize % 2).map(|p| *p + f64::from(k) * DVec3::new(0.1, 0.5, 1.0)).collect();
                if k > 0 && flips >> (k - 1) & 1 == 1 { back(&moved) } else { moved }
            };
            let stack: Vec<Vec<DVec3>> = (0..6).map(rail).collect();
            let expected: Vec<bool> = (0..6).map(|k| k > 0 && flips >> (k - 1) & 1 == 1).collect();
            let surface = solved(&stack, &auto(closed));
            assert_eq!(surface.reversed, expected);
            assert_eq!(surface.mesh.vertices, stack.concat(), "vertices stay in the order of the input");
        }
    }
}

#[test]
fn a_direction_does_not_depend_on_place_size_order_or_start() {
    let mut random = SplitMix64::new(23);
    let number = |random: &mut SplitMix64| random.between(-2.0, 2.0);
    let mut seen = [0; 4];
    for k in 0..400 {
        let closed = k % 2 == 0;
        let mut rail = |count: usize| -> Vec<DVec3> {
            (0..count).map(|_| DVec3::new(number(&mut random), number(&mut random), number(&mut random))).collect()
        };
        let (p, q) = (rail(3 + k % 5), rail(3 + k % 7));
        let decided = |p: &[DVec3], q: &[DVec3]| {
            let surface = solved(&[p.to_vec(), q.to_vec()], &auto(closed));
            (surface.reversed[1], surface.direction_decided_by[1])
        };
        let plain = decided(&p, &q);
        let turn = glam::DQuat::from_euler(glam::EulerRot::XYZ, 0.3 + k as f64, 1.1, -0.7);
        let of = |points: &[DVec3], map: &dyn Fn(DVec3) -> DVec3| points.iter().map(|&v| map(v)).collect::<Vec<_>>();
        let motions: [&dyn Fn(DVec3) -> DVec3; 4] = [&|v| turn * v, &|v| v + 1e7, &|v| v * 1e6, &|v| v * 1e-6];
        for motion in motions {
            assert_eq!(decided(&of(&p, motion), &of(&q, motion)), plain, "{k}");
        }
        assert_eq!(decided(&q, &p), plain, "{k}");
        assert_eq!(decided(&back(&p), &back(&q)), plain, "{k}");
        // A reversed rail is turned back. If the objective finds both ways equal, each may stay as given.
        let other = decided(&p, &back(&q));
        assert_eq!(other.1, plain.1, "{k}");
        assert!(other.0 != plain.0 || (!plain.0 && plain.1 == Some(DirectionCriterion::Objective)), "{k}");
        if closed {
            let mut turned = q.clone();
            turned.rotate_left(2);
            assert_eq!(decided(&p, &turned), plain, "{k}");
        }
        seen[plain.1.expect("something decides") as usize] += 1;
    }
    assert!(seen.iter().all(|&count| count > 0), "{seen:?}");
}

/// Two nearly straight rails that cross at a right angle in the plan. Neither direction folds more than the other, and
/// all ends are equally near.
#[test]
fn the_objective_decides_where_nothing_else_does() {
    let rail = |a: DVec3, b: DVec3| (0..=10).map(|k| a.lerp(b, f64::from(k) / 10.0)).collect::<Vec<_>>();
    let bent = |z: f64| DVec3::new(0.0, 0.0, z);
    let mut p = rail(DVec3::new(-5.0, 0.0, 0.0), DVec3::new(5.0, 0.0, 0.0));
    p[2] += DVec3::new(0.0, 0.7, 0.4);
    let mut q = rail(DVec3::new(0.0, -5.0, 3.0), DVec3::new(0.0, 5.0, 3.0));
    q[2] += bent(0.9);
    let ways = [[p.clone(), q.clone()], [p.clone(), back(&q)]];
    for (objective, secondary) in GOALS {
        let options = Options { objective, secondary, ..Options::default() };
        let best = ways.iter().map(|way| solved(way, &options).statistics.objective_value);
        let best =
            if objective == Objective::MaximalConvexity { best.fold(0.0, f64::max) } else { best.fold(1e9, f64::min) };
        for way in &ways {
            let surface = solved(way, &Options { direction: Direction::Auto, ..options.clone() });
            assert_eq!(surface.direction_decided_by[1], Some(DirectionCriterion::Objective));
            assert!((surface.statistics.objective_value - best).abs() <= 1e-9 * best, "{objective:?}");
            assert!(!warns(&solved(way, &options)));
        }
    }
}

#[test]
fn an_apex_has_no_direction() {
    let rail: Vec<DVec3> = (0..9).map(|k| DVec3::new(f64::from(k), f64::from(k % 3), 0.0)).collect();
    let stack = [rail.clone(), vec![DVec3::new(4.0, 2.0, 5.0)], back(&rail)];
    for closed in [false, true] {
        let surface = solved(&stack, &auto(closed));
        assert_eq!((surface.reversed, surface.direction_decided_by), (vec![false; 3], vec![None; 3]));
    }
}

/// Input: aerofoils that both run counter-clockwise, with a sharp trailing edge. The strip folds there by up to 170
/// degrees in either direction, and a comparison of the strips of least area wrongly reversed one of them.
#[test]
fn contours_with_a_sharp_edge_are_compared_by_their_area_vectors() {
    let aerofoil = |count: usize, chord: f64, turn: f64, place: DVec3| -> Vec<DVec3> {
        let half = count / 2;
        let point = |k: usize| {
            // From the trailing edge over the upper side to the nose and back below.
            let angle = std::f64::consts::PI * k as f64 / half as f64;
            let (x, side) = (0.5 * (1.0 + angle.cos()), angle.sin().signum());
            let y = 0.6 * (0.2969 * x.sqrt() - 0.126 * x - 0.3516 * x * x + 0.2843 * x.powi(3) - 0.1036 * x.powi(4));
            let (x, y) = (chord * (x - 0.25), chord * (side * y + 0.04 * (1.0 - x) * x));
            place + DVec3::new(x * turn.cos() - y * turn.sin(), x * turn.sin() + y * turn.cos(), 0.0)
        };
        (0..2 * half).map(point).collect()
    };
    let (root, tip) = (aerofoil(68, 1.0, 0.0, DVec3::ZERO), aerofoil(50, 0.4, 0.3, DVec3::new(0.6, 0.2, 4.0)));
    for objective in [Objective::MinimalArea, Objective::MinimalTwist] {
        let options = Options { objective, closed: true, ..Options::default() };
        assert!(!warns(&solved(&[root.clone(), tip.clone()], &options)));
        assert!(warns(&solved(&[root.clone(), back(&tip)], &options)));
        let automatic = Options { direction: Direction::Auto, ..options };
        for (tip, is_reversed) in [(tip.clone(), false), (back(&tip), true)] {
            let surface = solved(&[root.clone(), tip], &automatic);
            assert_eq!(surface.reversed, [false, is_reversed]);
            assert_eq!(surface.direction_decided_by[1], Some(DirectionCriterion::AreaVectors));
        }
    }
}

/// Contours without an area vector (figures of eight) and at right angles to each other are compared by their strips.
#[test]
fn contours_without_a_common_side_are_compared_by_their_strips() {
    let eight = |count: usize, z: f64| -> Vec<DVec3> {
        let angle = |k: usize| std::f64::consts::TAU * (k as f64 + 0.3) / count as f64;
        (0..count).map(|k| DVec3::new(angle(k).cos(), (2.0 * angle(k)).sin(), z)).collect()
    };
    let ring = |count: usize, x: DVec3, y: DVec3, place: DVec3| -> Vec<DVec3> {
        let angle = |k: usize| std::f64::consts::TAU * k as f64 / count as f64;
        (0..count).map(|k| place + angle(k).cos() * x + angle(k).sin() * y).collect()
    };
    let bend = [ring(24, DVec3::X, DVec3::Y, DVec3::ZERO), ring(30, DVec3::Z, DVec3::Y, DVec3::new(3.0, 0.0, 3.0))];
    for rails in [[eight(40, 0.0), eight(56, 0.6)], bend] {
        let there = solved(&rails, &auto(true));
        let back_again = solved(&[rails[0].clone(), back(&rails[1])], &auto(true));
        assert_ne!(there.direction_decided_by[1], Some(DirectionCriterion::AreaVectors));
        assert_ne!(there.reversed[1], back_again.reversed[1]);
        assert!((there.statistics.area / back_again.statistics.area - 1.0).abs() < 1e-9);
    }
}

/// The comparison of all objectives, weighted sums and normals all follow the direction that was chosen.
#[test]
fn comparisons_normals_and_weights_go_with_the_direction() {
    let mut random = SplitMix64::new(3);
    for _ in 0..10 {
        let Pair { rails: [p, q], .. } = open_pair(&mut random);
        let normals = vec![vec![DVec3::Z; p.len()], vec![DVec3::Z; q.len()]];
        let weights = Weights { area: 1.0, bending_energy: 0.1, normal_variation: 0.1, ..Weights::default() };
        for objective in [Objective::MinimalArea, Objective::Weighted(weights), Objective::MinimalNormalVariation] {
            let options =
                Options { objective, normals: Some(normals.clone()), all_objectives: true, ..Options::default() };
            let right = solved(&[p.clone(), q.clone()], &options);
            let automatic = Options { direction: Direction::Auto, ..options };
            let turned = solved(&[p.clone(), back(&q)], &automatic);
            assert_eq!(turned.reversed, [false, true]);
            let rows = [&right, &turned].map(|surface| surface.comparison.clone().expect("it was asked for"));
            for (one, other) in rows[0].iter().zip(&rows[1]) {
                let (one, other) = (one.statistics.objective_value, other.statistics.objective_value);
                assert!((one - other).abs() <= 1e-9 * one.abs().max(1.0), "{one} {other}");
            }
        }
    }
}
