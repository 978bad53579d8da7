//! Rails that move within a tolerance for the optimum.

use crate::ruled::{GOALS, Random, Style, random_case};
use plateau_mesh::{DVec3, Error, Execution, Interruption, Signal};
use plateau_ruled_surface::{
    Caps, Direction, Objective, Options, RailEnds, RuledSurface, Sampling, Secondary, Weights, estimate, estimate_for,
    solve,
};
use std::cell::Cell;

fn solved(directrices: &[Vec<DVec3>], options: &Options) -> RuledSurface {
    solve(directrices, options, &Execution::default()).expect("a strip that can be solved")
}

fn within(tolerance: f64, (objective, secondary): (Objective, Option<Secondary>)) -> Options {
    Options { objective, secondary, rail_tolerance: Some(tolerance), ..Options::default() }
}

/// The value as a cost: the number of bridges that are not convex, then the value that decides among equals.
fn cost(surface: &RuledSurface, objective: Objective) -> (f64, f64) {
    let statistics = &surface.statistics;
    if objective == Objective::MaximalConvexity {
        let second = statistics.secondary_value.unwrap_or(statistics.bending_energy);
        return ((statistics.bridges - statistics.convex_bridges) as f64, second);
    }
    (statistics.objective_value, 0.0)
}

/// Two arcs of a cylinder that lean against each other, so that its rulings do not join points of equal number.
fn cylinder(m: usize, n: usize) -> [Vec<DVec3>; 2] {
    let arc = |count: usize, z: f64, lean: f64| -> Vec<DVec3> {
        let angle = |k: usize| std::f64::consts::PI * k as f64 / (count - 1) as f64;
        (0..count).map(angle).map(|t| DVec3::new(libm::cos(t), libm::sin(t), z + lean * libm::cos(t))).collect()
    };
    [arc(m, 0.0, 0.0), arc(n, 1.0, 0.2)]
}

fn noisy(rails: &[Vec<DVec3>; 2], distance: f64, seed: u64) -> [Vec<DVec3>; 2] {
    let mut random = Random::new(seed);
    rails.each_ref().map(|rail| {
        rail.iter().map(|&point| point + random.unit() * (distance * random.between(0.0, 1.0).cbrt())).collect()
    })
}

#[test]
fn a_cylinder_with_noise_comes_back_at_the_value_of_the_clean_one() {
    for (m, n, distance) in [(20, 20, 0.02), (31, 24, 0.003)] {
        let clean = cylinder(m, n);
        for (round, goal) in GOALS.into_iter().enumerate() {
            let given = noisy(&clean, distance, round as u64);
            let plain = Options { rail_tolerance: None, ..within(0.0, goal) };
            let (clean, before) = (solved(&clean, &plain), solved(&given, &plain));
            let found = [0.5, 1.0, 2.0].map(|share| solved(&given, &within(share * distance, goal)));
            let [of_clean, of_noisy] = [&clean, &before].map(|surface| cost(surface, goal.0));
            let now = found.each_ref().map(|surface| cost(surface, goal.0));
            println!("{goal:?} {m} {n} {distance}: clean {of_clean:.3?}, noisy {of_noisy:.3?}, moved {now:.3?}");
            // Nothing is better than 0.
            let is_better = now[1] < of_noisy || of_noisy == (0.0, 0.0);
            assert!(now[1].0 <= of_clean.0 && is_better, "{goal:?} {distance}: {now:?}");
            assert!(now.is_sorted_by(|a, b| a >= b), "{goal:?} {distance}: {now:?}");
            let rails = found[1].rails.expect("the rails moved");
            let [value, before] = [&found[1], &before].map(|surface| surface.statistics.objective_value);
            assert!(rails.moved_max <= distance && rails.before == before && rails.gain == (before - value).abs());
        }
    }
}

#[test]
fn a_larger_tolerance_is_never_worse() {
    let mut random = Random::new(68);
    for (round, goal) in GOALS.into_iter().chain(GOALS).enumerate() {
        let closed = round >= GOALS.len();
        let case = random_case(&mut random, Style::Sensible, closed, 9);
        let rails = [case.p, case.q];
        let mut last = None;
        for tolerance in [0.0, 1e-9, 1e-4, 0.01, 0.011, 0.05, 0.07, 0.2] {
            for rail_ends in [RailEnds::Free, RailEnds::Fixed] {
                if closed && rail_ends == RailEnds::Fixed {
                    continue;
                }
                let options = Options { closed, rail_ends, ..within(tolerance, goal) };
                let found = solved(&rails, &options);
                let mut largest = (0.0, 0);
                for (points, numbers) in rails.iter().zip(&found.input_vertices) {
                    for (k, (&place, &vertex)) in points.iter().zip(numbers).enumerate() {
                        let distance = found.mesh.vertices[vertex as usize].distance(place);
                        let stays = rail_ends == RailEnds::Fixed && (k == 0 || k + 1 == points.len());
                        assert!(distance <= if stays { 0.0 } else { tolerance }, "{distance} of {tolerance}");
                        if distance > largest.0 {
                            largest = (distance, vertex);
                        }
                    }
                }
                let moved = found.rails.expect("the rails moved");
                assert_eq!((moved.moved_max, moved.moved_max_vertex), largest);
                if rail_ends == RailEnds::Free {
                    let cost = cost(&found, goal.0);
                    assert!(last.is_none_or(|last| cost <= last), "{goal:?} {tolerance}: {cost:?} after {last:?}");
                    last = Some(cost);
                }
            }
        }
        let plain = solved(&rails, &Options { closed, rail_tolerance: None, ..within(0.0, goal) });
        let none = solved(&rails, &Options { closed, ..within(0.0, goal) });
        assert_eq!((&plain.mesh, &plain.bridges), (&none.mesh, &none.bridges));
        assert!(last.expect("a cost") < cost(&plain, goal.0), "{goal:?}");
    }
}

#[test]
fn stacks_samples_reversed_rails_and_apexes_move() {
    let mut random = Random::new(3);
    for closed in [false, true] {
        let case = random_case(&mut random, Style::Sensible, closed, 9);
        let above = case.q.iter().rev().map(|&q| q + DVec3::new(0.1, 2.0, 0.3)).collect();
        let rails = [case.p, case.q, above, vec![DVec3::new(0.5, 5.0, 0.2)]];
        let plain = Options {
            objective: Objective::MinimalBendingEnergy,
            closed,
            direction: Direction::Auto,
            sampling: Some(Sampling::ArcLength { samples: 8 }),
            all_objectives: true,
            ..Options::default()
        };
        let (before, found) =
            (solved(&rails, &plain), solved(&rails, &Options { rail_tolerance: Some(0.05), ..plain.clone() }));
        let moved = found.rails.expect("the rails moved");
        assert_eq!((moved.before, moved.gain > 0.0), (before.statistics.objective_value, true));
        assert_eq!((&found.reversed, &found.input_vertices), (&before.reversed, &before.input_vertices));
        assert!(found.reversed.contains(&true));
        let moves = found.mesh.vertices.iter().zip(&before.mesh.vertices).map(|(at, place)| at.distance(*place));
        assert_eq!(moves.fold(0.0, f64::max), moved.moved_max);
        assert!(moved.moved_max <= 0.05);
        let row = &found.comparison.expect("a comparison")[3];
        assert_eq!(row.statistics.objective_value, found.statistics.objective_value);
    }
}

#[test]
fn motions_scale_and_exchange_change_the_value_by_little() {
    let [p, q] = noisy(&cylinder(15, 12), 0.03, 5);
    for goal in
        [(Objective::MinimalArea, None), (Objective::MinimalBendingEnergy, None), (Objective::MinimalTwist, None)]
    {
        let value = |rails: [Vec<DVec3>; 2], tolerance: f64| {
            solved(&rails, &within(tolerance, goal)).statistics.objective_value
        };
        let expected = value([p.clone(), q.clone()], 0.03);
        let turn = glam::DQuat::from_axis_angle(DVec3::new(0.6, 0.0, 0.8), 1.1);
        let turned = [&p, &q].map(|rail| rail.iter().map(|&v| turn * v + DVec3::new(3.0, -2.0, 7.0)).collect());
        let large = [&p, &q].map(|rail| rail.iter().map(|&v| 1000.0 * v).collect());
        let unit = if goal.0 == Objective::MinimalArea { 1e6 } else { 1.0 };
        let found = [value(turned, 0.03), value([q.clone(), p.clone()], 0.03), value(large, 30.0) / unit];
        println!("{goal:?}: {expected} {found:?}");
        assert!(
            found.iter().all(|value| (value - expected).abs() <= 1e-3 * expected),
            "{goal:?}: {expected} {found:?}"
        );
        assert_eq!(value([p.clone(), q.clone()], 0.03), expected);
    }
}

#[test]
fn moving_rails_look_often_and_stop_when_asked() {
    let rails = noisy(&cylinder(400, 300), 0.01, 9);
    let options = within(0.01, (Objective::MinimalBendingEnergy, None));
    let last = Cell::new(0.0);
    let report = |progress: plateau_mesh::Progress| {
        assert!(progress.fraction >= last.get() && progress.fraction <= 1.0);
        last.set(progress.fraction);
    };
    let looks = Cell::new(0);
    let stop = || {
        looks.set(looks.get() + 1);
        if looks.get() > 200 { Signal::Cancel } else { Signal::Continue }
    };
    let execution = Execution::new(&stop, &report);
    assert_eq!(solve(&rails, &options, &execution), Err(Error::Interrupted(Interruption::Cancelled)));
    assert_eq!(looks.get(), 201);
    assert!(execution.largest_work_between_looks() <= 1 << 18, "{}", execution.largest_work_between_looks());
}

#[test]
fn tolerances_that_cannot_be_served_are_named() {
    let rails = cylinder(9, 7);
    let place = |options: &Options| match solve(&rails, options, &Execution::default()) {
        Err(Error::Input(errors)) => errors[0].place.to_string(),
        other => panic!("not refused: {other:?}"),
    };
    let area = (Objective::MinimalArea, None);
    for tolerance in [-1.0, f64::NAN, f64::INFINITY, 1.0] {
        assert_eq!(place(&within(tolerance, area)), "/rail_tolerance");
    }
    let closed = Options { closed: true, ..within(0.1, area) };
    assert_eq!(place(&Options { caps: Caps::Flat, ..closed.clone() }), "/rail_tolerance");
    assert_eq!(place(&Options { rail_ends: RailEnds::Fixed, ..closed }), "/rail_ends");
    let weights = Weights { area: 1.0, twist: 0.5, ..Weights::default() };
    let weighted = |weights| within(0.05, (Objective::Weighted(weights), None));
    assert_eq!(place(&weighted(weights)), "/rail_tolerance");
    let plain = solved(&rails, &weighted(Weights { normalise: false, ..weights }));
    assert!(plain.rails.expect("the rails moved").gain > 0.0);
}

#[test]
fn the_estimate_grows_with_the_tolerance_and_does_not_depend_on_the_unit() {
    let rails = cylinder(40, 30);
    let large = rails.each_ref().map(|rail| rail.iter().map(|&v| 1000.0 * v).collect::<Vec<_>>());
    let twist = (Objective::MinimalTwist, None);
    let cells = |rails: &[Vec<DVec3>], tolerance: f64| {
        estimate_for(rails, &within(tolerance, twist), &Execution::default()).expect("an estimate").cells
    };
    let [plain, small, middle, most] = [0.0, 0.001, 0.05, 0.25].map(|tolerance| cells(&rails, tolerance));
    assert!(plain < small && small < middle && middle < most, "{plain} {small} {middle} {most}");
    assert_eq!(middle, cells(&large, 50.0));
    assert!(most <= estimate(&[40, 30], &within(0.0, twist)).cells);
    // A solve reports its work in the same unit.
    let execution = Execution::default();
    solve(&noisy(&rails, 0.05, 3), &within(0.05, twist), &execution).expect("a strip");
    println!("{middle} cells estimated, {} visited", execution.work());
    assert!(execution.work() <= middle, "{}", execution.work());
}
