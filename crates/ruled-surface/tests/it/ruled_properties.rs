//! Motions, exchanges and scalings that must not change a ruled strip's values; promises of a solve; and extreme
//! inputs.

use crate::ruled::{self, GOALS, Random, STYLES, Style, random_case};
use plateau_mesh::{DVec3, Error, Execution, Interruption, Signal};
use plateau_ruled_surface::{
    Caps, DEFAULT_CONVEXITY_TOLERANCE as TOLERANCE, Direction, FlatPattern, Objective, Options, RuledSurface, Sampling,
    Secondary, Strip, Weights, estimate, solve,
};
use proptest::prelude::*;
use proptest::test_runner::RngSeed;
use std::cell::Cell;

fn solved(directrices: &[Vec<DVec3>], options: &Options) -> RuledSurface {
    solve(directrices, options, &Execution::default()).expect("a strip that can be solved")
}

fn options((objective, secondary): (Objective, Option<Secondary>), closed: bool) -> Options {
    Options { objective, secondary, closed, ..Options::default() }
}

/// Exponents of the unit of length in the value of the objective and in that of the secondary objective.
fn dimension(objective: Objective, secondary: Option<Secondary>) -> [i32; 2] {
    let own = match objective {
        Objective::MinimalArea => 2,
        Objective::MinimalMeanCurvatureVariation => 1,
        _ => 0,
    };
    [own, i32::from(secondary == Some(Secondary::MeanCurvatureVariation))]
}

fn close(a: f64, b: f64, tolerance: f64) -> bool {
    (a - b).abs() <= tolerance * a.abs().max(b.abs()).max(1e-3)
}

/// Rounds coordinates to whole multiples of 2^-20, so that an offset of 1e7 loses no digit.
fn on_a_grid(points: &[DVec3]) -> Vec<DVec3> {
    points.iter().map(|p| (*p * 1_048_576.0).round() / 1_048_576.0).collect()
}

fn turned(points: &[DVec3], axis: DVec3, angle: f64) -> Vec<DVec3> {
    points.iter().map(|&p| glam::DQuat::from_axis_angle(axis, angle) * p).collect()
}

fn property() -> ProptestConfig {
    ProptestConfig { cases: 60, rng_seed: RngSeed::Fixed(2005), failure_persistence: None, ..ProptestConfig::default() }
}

proptest! {
    #![proptest_config(property())]

    #[test]
    fn values_do_not_change_under_reversal_exchange_motion_and_scale(
        seed in any::<u64>(),
        closed in any::<bool>(),
        size in 1e-6f64..1e6,
        angle in 0.0f64..6.0,
    ) {
        let mut random = Random::new(seed);
        let case = random_case(&mut random, Style::Sensible, closed, 12);
        let (p, q) = (on_a_grid(&case.p), on_a_grid(&case.q));
        let axis = random.unit();
        let back = |points: &[DVec3]| points.iter().rev().copied().collect::<Vec<_>>();
        let scale = |points: &[DVec3], by: f64| points.iter().map(|&v| v * by).collect::<Vec<_>>();
        let offset = |points: &[DVec3]| points.iter().map(|&v| v + DVec3::splat(1e7)).collect::<Vec<_>>();
        for goal in GOALS {
            let options = options(goal, closed);
            let value = |p: Vec<DVec3>, q: Vec<DVec3>| {
                let figures = solved(&[p, q], &options).statistics;
                [figures.objective_value, figures.secondary_value.unwrap_or(0.0)]
            };
            let plain = value(p.clone(), q.clone());
            let power = dimension(goal.0, goal.1);
            let directed = goal.1 == Some(Secondary::MeanCurvatureVariation);
            let others = [
                ("reversed", value(back(&p), back(&q)), 1.0, 1e-9),
                ("exchanged", value(q.clone(), p.clone()), 1.0, 1e-9),
                ("turned", value(turned(&p, axis, angle), turned(&q, axis, angle)), 1.0, 1e-8),
                ("scaled", value(scale(&p, size), scale(&q, size)), size, 1e-8),
                ("moved", value(offset(&p), offset(&q)), 1.0, 1e-9),
            ];
            for (what, got, size, tolerance) in others {
                let expected = plain[0] * size.powi(power[0]);
                prop_assert!(close(got[0], expected, tolerance), "{what} {goal:?}: {got:?} {plain:?}");
                // The coupled curvature variation counts the step that enters a bridge, so it depends on the direction
                // of the path.
                if !(directed && what == "reversed") {
                    let expected = plain[1] * size.powi(power[1]);
                    prop_assert!(close(got[1], expected, tolerance), "{what} {goal:?}: {got:?} {plain:?}");
                }
            }
        }
    }

    #[test]
    fn a_planar_strip_stays_fully_convex_wherever_it_is(
        seed in any::<u64>(),
        angle in 0.0f64..6.0,
        closed in any::<bool>(),
    ) {
        let mut random = Random::new(seed);
        let axis = random.unit();
        let rail = |random: &mut Random, inner: f64| -> Vec<DVec3> {
            (0..random.whole(5, 30)).map(|k| {
                let along = f64::from(k as u32) * 0.2 + random.between(0.0, 0.1);
                let y = inner + random.between(-0.2, 0.2);
                if closed {
                    DVec3::new((1.0 + y) * along.cos(), (1.0 + y) * along.sin(), 0.0)
                } else {
                    DVec3::new(along, y, 0.0)
                }
            }).collect()
        };
        let (p, q) = (rail(&mut random, 0.0), rail(&mut random, 1.0));
        let there = |points: &[DVec3]| turned(points, axis, angle).into_iter().map(|v| v + 1e7).collect::<Vec<_>>();
        for goal in GOALS {
            let surface = solved(&[there(&p), there(&q)], &options(goal, closed));
            prop_assert_eq!(surface.statistics.convex_bridges, surface.statistics.bridges);
        }
    }
}

#[test]
fn given_tangents_turn_round_with_their_rail() {
    let mut random = Random::new(41);
    for closed in [false, true] {
        for _ in 0..10 {
            let case = random_case(&mut random, Style::Sensible, closed, 12);
            let mut rails = vec![case.p, case.q];
            rails[1].reverse();
            let auto = Options {
                objective: Objective::MinimalTwist,
                direction: Direction::Auto,
                closed,
                ..Options::default()
            };
            let given = rails.iter().map(|rail| ruled::tangents(rail, closed)).collect();
            let (fitted, given) =
                (solved(&rails, &auto), solved(&rails, &Options { tangents: Some(given), ..auto.clone() }));
            assert_eq!(fitted.reversed, given.reversed);
            assert!(close(fitted.statistics.objective_value, given.statistics.objective_value, 1e-9));
        }
    }
}

#[test]
fn a_faceted_half_cylinder_folds_but_is_developable() {
    let arc = |z: f64| -> Vec<DVec3> {
        (0..=20).map(|k| std::f64::consts::PI * f64::from(k) / 20.0).map(|a| DVec3::new(a.cos(), a.sin(), z)).collect()
    };
    let coupled = (Objective::MaximalConvexity, Some(Secondary::BendingEnergy));
    let figures = solved(&[arc(0.0), arc(1.0)], &options(coupled, false)).statistics;
    assert_eq!(figures.convex_bridges, figures.bridges);
    assert!((figures.largest_fold.to_degrees() - 9.0).abs() < 1e-6);
    assert_eq!(figures.developability_deviation, 0.0);
}

#[test]
fn the_bridges_that_are_not_convex_are_listed_over_all_strips() {
    let (mut random, mut listed) = (Random::new(11), 0);
    for round in 0..40 {
        let closed = round % 2 == 1;
        let goal = GOALS[round % GOALS.len()];
        let case = random_case(&mut random, Style::Sensible, closed, 30);
        let above = case.p.iter().map(|&p| p + DVec3::new(0.3, 4.0, 0.7)).collect();
        let rails = [case.p, case.q, above];
        let surface = solved(&rails, &options(goal, closed));
        let mut expected = Vec::new();
        let mut first = 0;
        for (k, own) in surface.strips.iter().enumerate() {
            let strip = Strip::new(rails[k][..].into(), rails[k + 1][..].into(), closed).unwrap();
            let local = |v: u32, rail: usize| surface.directrices[rail].iter().position(|&own| own == v).unwrap();
            let is_convex = |&[a, b]: &[u32; 2]| strip.is_locally_convex([local(a, k), local(b, k + 1)], TOLERANCE);
            let bridges = &surface.bridges[first..first + own.bridges];
            let concave = bridges.iter().enumerate().filter(|(_, bridge)| !is_convex(bridge));
            expected.extend(concave.map(|(number, _)| (first + number) as u32));
            let own_folds = surface
                .concave_bridges
                .iter()
                .filter(|concave| (first..first + own.bridges).contains(&(concave.bridge as usize)));
            let largest = own_folds.map(|concave| concave.fold).fold(0.0, f64::max);
            assert_eq!(largest, own.developability_deviation);
            first += own.bridges;
        }
        let found: Vec<u32> = surface.concave_bridges.iter().map(|concave| concave.bridge).collect();
        assert_eq!(found, expected, "{goal:?}");
        listed += found.len();
    }
    assert!(listed > 500, "{listed}");
}

#[test]
fn the_default_tolerance_and_the_exact_answer_agree_on_strips_in_general_position() {
    let mut random = Random::new(31);
    for k in 0..400 {
        let case = random_case(&mut random, [Style::Anywhere, Style::Sensible][k % 2], k % 4 < 2, 9);
        let rails = [case.p, case.q];
        for goal in [GOALS[2], GOALS[5], GOALS[6]] {
            let tolerant = options(goal, case.closed);
            let exact = Options { convexity_tolerance: 0.0, ..tolerant.clone() };
            let (tolerant, exact) = (solved(&rails, &tolerant), solved(&rails, &exact));
            assert_eq!(
                (tolerant.bridges, tolerant.statistics),
                (exact.bridges, exact.statistics),
                "{goal:?} {rails:?}"
            );
        }
    }
}

#[test]
fn each_objective_is_best_in_its_own_column() {
    let mut random = Random::new(11);
    for closed in [false, true] {
        for _ in 0..20 {
            let case = random_case(&mut random, Style::Sensible, closed, 12);
            let all =
                Options { all_objectives: true, closed, normals: Some(case.normals.to_vec()), ..Options::default() };
            let surface = solved(&[case.p, case.q], &all);
            let rows = surface.comparison.expect("a comparison was asked for");
            assert_eq!(rows.len(), 8);
            let least = |column: &dyn Fn(usize) -> f64, own: usize| {
                (0..rows.len())
                    .for_each(|k| assert!(column(own) <= column(k) + 1e-9 * column(k).abs() + 1e-12, "row {k}"));
            };
            least(&|k| rows[k].statistics.area, 0);
            least(&|k| rows[k].statistics.total_normal_twist, 1);
            least(&|k| -(rows[k].statistics.convex_bridges as f64), 2);
            least(&|k| rows[k].statistics.bending_energy, 3);
            least(&|k| rows[k].statistics.mean_curvature_variation, 4);
            least(&|k| rows[k].statistics.normal_variation.expect("normals were given"), 5);
            assert_eq!(rows[6].statistics.convex_bridges, rows[2].statistics.convex_bridges);
            assert_eq!(rows[7].statistics.convex_bridges, rows[2].statistics.convex_bridges);
        }
    }
}

#[test]
fn faces_agree_with_the_normals_they_were_given() {
    let rail = |y: f64| (0..9).map(|k| DVec3::new(f64::from(k), y, 0.0)).collect::<Vec<_>>();
    for up in [1.0, -1.0] {
        let normals = vec![vec![DVec3::Z * up; 9]; 2];
        let options =
            Options { objective: Objective::MinimalNormalVariation, normals: Some(normals), ..Options::default() };
        let surface = solved(&[rail(0.0), rail(1.0)], &options);
        assert!(surface.statistics.objective_value.abs() < 1e-12);
        for &t in &surface.mesh.triangles {
            let [a, b, c] = surface.mesh.corners(t);
            assert!((b - a).cross(c - a).z * up > 0.0);
        }
    }
}

#[test]
fn a_weighted_sum_with_one_term_is_that_objective_and_mixes_lie_between() {
    let mut random = Random::new(5);
    for closed in [false, true] {
        for _ in 0..10 {
            let case = random_case(&mut random, Style::Sensible, closed, 10);
            let rails = [case.p, case.q];
            let weighted =
                |weights: Weights| solved(&rails, &options((Objective::Weighted(weights), None), closed)).statistics;
            let own = |objective| solved(&rails, &options((objective, None), closed)).statistics;
            let area = own(Objective::MinimalArea).area;
            let bending = own(Objective::MinimalBendingEnergy).bending_energy;
            let plain = Weights { area: 3.0, normalise: false, ..Weights::default() };
            assert!(close(weighted(plain).objective_value, 3.0 * area, 1e-12));
            let normalised = Weights { bending_energy: 2.0, ..Weights::default() };
            let alone = weighted(normalised);
            assert!(close(alone.bending_energy, bending, 1e-9) && close(alone.objective_value, 2.0, 1e-9));
            let mix = Weights {
                area: 1.0,
                bending_energy: 0.2,
                twist: 0.1,
                mean_curvature_variation: 0.1,
                ..Weights::default()
            };
            let mixed = weighted(mix);
            assert!(mixed.area >= area * (1.0 - 1e-12) && mixed.bending_energy >= bending * (1.0 - 1e-12));
            // No other objective's optimum has a smaller sum.
            let [twist, curvature] = [own(Objective::MinimalTwist), own(Objective::MinimalMeanCurvatureVariation)];
            let sum = |s: plateau_ruled_surface::Statistics| {
                s.area / area
                    + 0.2 * s.bending_energy / bending
                    + 0.1 * s.total_normal_twist / twist.total_normal_twist
                    + 0.1 * s.mean_curvature_variation / curvature.mean_curvature_variation
            };
            assert!(close(sum(mixed), mixed.objective_value, 1e-9));
            for other in [own(Objective::MinimalArea), own(Objective::MinimalBendingEnergy), twist, curvature] {
                assert!(mixed.objective_value <= sum(other) * (1.0 + 1e-9));
            }
        }
    }
}

fn spiral_ramp(turns: f64) -> [Vec<DVec3>; 2] {
    let rail = |radius: f64| -> Vec<DVec3> {
        (0..200)
            .map(|k| std::f64::consts::TAU * turns * f64::from(k) / 199.0)
            .map(|a| DVec3::new(radius * a.cos(), radius * a.sin(), 0.02 * a))
            .collect()
    };
    [rail(1.0), rail(1.5)]
}

#[test]
fn unrolling_keeps_lengths_and_sees_overlaps() {
    for (turns, overlaps) in [(0.9, false), (1.5, true)] {
        let pattern = solved(&spiral_ramp(turns), &Options::default()).flat_pattern;
        assert_eq!(pattern.self_overlap, overlaps, "{turns} turns");
        assert!(pattern.edge_length_error_max < 1e-12);
    }
    let mut random = Random::new(21);
    let mut seen = 0;
    for k in 0..200 {
        let case = random_case(&mut random, STYLES[k % STYLES.len()], false, 30);
        let rails = [case.p, case.q];
        let Ok(surface) = solve(&rails, &Options::default(), &Execution::default()) else { continue };
        seen += 1;
        let pattern = surface.flat_pattern;
        let strip = &pattern.strips[0];
        let flat = |v: u32| {
            let v = v as usize;
            if v < strip.p.len() { strip.p[v] } else { strip.q[v - strip.p.len()] }
        };
        let longest = surface.statistics.longest_bridge;
        for (&t, &solid) in strip.triangles.iter().zip(&surface.mesh.triangles) {
            let [a, b, c] = t.map(flat);
            assert!((b - a).perp_dot(c - a) >= -1e-12 * longest * longest, "the front faces up");
            for side in 0..3 {
                let (a, b) = (t[side], t[(side + 1) % 3]);
                let (c, d) = (solid[side] as usize, solid[(side + 1) % 3] as usize);
                let true_length = surface.mesh.vertices[c].distance(surface.mesh.vertices[d]);
                assert!((flat(a).distance(flat(b)) - true_length).abs() <= 1e-12 * longest.max(true_length));
            }
        }
    }
    assert!(seen > 150, "{seen}");
}

#[test]
fn bridges_alone_give_the_same_flat_pattern() {
    let mut random = Random::new(22);
    let mut seen = 0;
    for k in 0..120 {
        let (one, other) = (
            random_case(&mut random, STYLES[k % STYLES.len()], false, 30),
            random_case(&mut random, STYLES[(k + 1) % STYLES.len()], false, 20),
        );
        let apex = vec![one.p[0] + DVec3::new(0.3, -2.0, 0.7)];
        let stack = if k % 3 == 0 { vec![apex, one.p, one.q] } else { vec![one.p, one.q, other.q] };
        let direction = if k % 2 == 0 { Direction::Auto } else { Direction::AsGiven };
        let options = Options { direction, ..Options::default() };
        let Ok(surface) = solve(&stack, &options, &Execution::default()) else { continue };
        let again = of_bridges(&surface.mesh.vertices, &surface.bridges, false, &[]);
        assert_eq!(again.as_ref(), Ok(&surface.flat_pattern));
        seen += 1;
    }
    assert!(seen > 60, "{seen}");
    let points = [DVec3::ZERO, DVec3::X, DVec3::Y, DVec3::new(1.0, 1.0, 0.5)];
    for bridges in [[[0, 2], [0, 2]], [[0, 2], [1, 4]], [[0, 2], [1, 3]]] {
        assert!(matches!(of_bridges(&points, &bridges, false, &[]), Err(Error::Input(_))));
    }
}

fn of_bridges(points: &[DVec3], bridges: &[[u32; 2]], closed: bool, cuts: &[u32]) -> Result<FlatPattern, Error> {
    FlatPattern::of_bridges(points, bridges, closed, cuts, &Execution::default())
}

/// The frustum from radius 1 to 3 and height 4 unrolls to a sector with the angle 2π sin β, between the slants 1/sin β
/// and 3/sin β, where tan β = ½. A pyramid of n sides has the sector of its own edges: n times the apex angle of a
/// side.
#[test]
fn a_closed_frustum_unrolls_to_the_sector_of_its_cone() {
    let sine = 1.0 / 5f64.sqrt();
    let mut errors = Vec::new();
    for count in [48, 96, 192] {
        let ring = |radius: f64, z: f64| -> Vec<DVec3> {
            let angle = |k: usize| std::f64::consts::TAU * k as f64 / count as f64;
            (0..count).map(|k| DVec3::new(radius * angle(k).cos(), radius * angle(k).sin(), z)).collect()
        };
        let rings = [ring(1.0, 4.0), ring(3.0, 0.0)];
        let options = Options { closed: true, ..Options::default() };
        let surface = solved(&rings, &options);
        let pattern = &surface.flat_pattern;
        let [piece] = pattern.strips.as_slice() else { panic!("one piece") };
        assert!(!pattern.self_overlap && pattern.edge_length_error_max < 1e-12);
        assert_eq!(piece.numbers.len(), surface.bridges.len() + 1);
        assert_eq!((piece.p.len(), piece.q.len(), piece.strip), (count + 1, count + 1, 0));
        // The two ends are the same bridge, and their lines meet in the centre of the sector.
        assert_eq!(piece.numbers.first(), piece.numbers.last());
        let [start, end] = [0, count].map(|k| (piece.p[k], piece.q[k]));
        assert!((start.0.distance(start.1) - end.0.distance(end.1)).abs() < 1e-12);
        let straight = |k: usize| piece.q[k].distance(piece.q[k + 1]);
        let (edge, slant) = (straight(0), rings[1][0].distance(DVec3::new(0.0, 0.0, 6.0)));
        assert!((slant - 3.0 / sine).abs() < 1e-12);
        // A second route: the angle of a regular pyramid from its own edge and slant.
        let pyramid = 2.0 * count as f64 * (0.5 * edge / slant).asin();
        // The ends of the sector: the path may open within a side, at its diagonal, which spans less than a side.
        let spanned: f64 = piece.q.windows(2).map(|pair| 2.0 * (0.5 * pair[0].distance(pair[1]) / slant).asin()).sum();
        assert!((spanned - pyramid).abs() < 1e-12, "{spanned} {pyramid}");
        errors.push((pyramid - 2.809926).abs());
        let area = 0.5 * count as f64 * (pyramid / count as f64).sin() * (9.0 - 1.0) / (sine * sine);
        let flat = piece.triangles.iter().map(|t| {
            let [a, b, c] = t.map(|v| {
                let v = v as usize;
                if v < piece.p.len() { piece.p[v] } else { piece.q[v - piece.p.len()] }
            });
            0.5 * (b - a).perp_dot(c - a)
        });
        assert!((flat.sum::<f64>() - area).abs() < 1e-11 * area);
    }
    // The angle of the pyramid tends to the angle of the cone with the square of the number of sides.
    assert!((errors[0] / errors[2] - 16.0).abs() < 0.2 && errors[2] < 1e-3, "{errors:?}");
}

#[test]
fn closed_strips_open_at_the_least_fold_or_where_they_are_told_and_further_cuts_divide_them() {
    let square = |z: f64| [[0.0, 0.0], [2.0, 0.0], [2.0, 1.0], [0.0, 1.0]].map(|[x, y]| DVec3::new(x, y, z)).to_vec();
    let surface = solved(&[square(0.0), square(1.0)], &Options { closed: true, ..Options::default() });
    let normal = |k: usize| {
        let [a, b, c] = surface.mesh.triangles[k % 8].map(|v| surface.mesh.vertices[v as usize]);
        (b - a).cross(c - a).normalize()
    };
    let flat: Vec<u32> = (0..8).filter(|&k| normal(k + 7).dot(normal(k)) > 0.9).map(|k| k as u32).collect();
    assert_eq!(flat.len(), 4, "the four diagonals");
    assert_eq!(surface.flat_pattern.strips[0].numbers[0], flat[0]);
    let cut = |cuts: &[u32]| of_bridges(&surface.mesh.vertices, &surface.bridges, true, cuts);
    for bridge in 0..8 {
        let pattern = cut(&[bridge]).unwrap();
        let expected: Vec<u32> = (0..=8).map(|k| (bridge + k) % 8).collect();
        assert_eq!(pattern.strips[0].numbers, expected);
        assert!(pattern.strips[0].triangles.len() == 8 && pattern.edge_length_error_max < 1e-12);
    }
    let pieces = cut(&[6, 1]).unwrap().strips;
    let numbers: Vec<&[u32]> = pieces.iter().map(|piece| piece.numbers.as_slice()).collect();
    assert_eq!(numbers, [[1, 2, 3, 4, 5, 6].as_slice(), &[6, 7, 0, 1]]);
    for cuts in [[8, 1], [2, 2]] {
        assert!(matches!(cut(&cuts), Err(Error::Input(_))), "{cuts:?}");
    }
    let open = solved(&[square(0.0), square(1.0)], &Options::default());
    let cut = |cuts: &[u32]| of_bridges(&open.mesh.vertices, &open.bridges, false, cuts);
    assert!(cut(&[0]).is_err() && cut(&[6]).is_err());
    assert_eq!(cut(&[3]).unwrap().strips.iter().map(|piece| piece.numbers.len()).collect::<Vec<_>>(), [4, 4]);
}

#[test]
fn capped_stacks_are_closed_bodies_that_point_outwards() {
    let ring = |count: usize, z: f64, turn: f64, reversed: bool| -> Vec<DVec3> {
        let mut points: Vec<DVec3> = (0..count)
            .map(|k| std::f64::consts::TAU * k as f64 / count as f64 + turn)
            .map(|a| DVec3::new((2.0 + (3.0 * a).cos()) * a.cos(), (2.0 + (3.0 * a).cos()) * a.sin(), z))
            .collect();
        if reversed {
            points.reverse();
        }
        points
    };
    for reversed in [false, true] {
        let stack = [ring(40, 0.0, 0.0, reversed), ring(31, 1.0, 0.5, reversed), ring(52, 2.0, 1.0, reversed)];
        let surface = solved(&stack, &Options { closed: true, caps: Caps::Flat, ..Options::default() });
        assert_eq!(surface.mesh.vertices.len(), 123, "caps add no vertices");
        let topology = surface.mesh.check().expect("a manifold");
        assert!(topology.boundary_loops().is_empty());
        assert_eq!(topology.euler_characteristic(), 2);
        let volume: f64 = surface
            .mesh
            .triangles
            .iter()
            .map(|&t| surface.mesh.corners(t))
            .map(|[a, b, c]| a.dot(b.cross(c)) / 6.0)
            .sum();
        // The area of the section is 9π/2 on the smooth curve, and a little less on its polygons.
        let section = 4.5 * std::f64::consts::PI;
        assert!(volume > 0.9 * 2.0 * section && volume < 2.0 * section, "{volume}");
    }
    // An apex closes its end without a cap.
    let cone = [ring(40, 0.0, 0.0, false), vec![DVec3::new(0.1, 0.2, 3.0)]];
    let surface = solved(&cone, &Options { closed: true, caps: Caps::Flat, ..Options::default() });
    assert_eq!(surface.mesh.check().expect("a manifold").euler_characteristic(), 2);
    // A bent end contour and one that crosses itself have no flat cap.
    let mut bent = ring(40, 0.0, 0.0, false);
    bent[3].z += 0.1;
    let mut crossed = ring(40, 0.0, 0.0, false);
    crossed.swap(3, 17);
    for (contour, place, detail) in
        [(bent, "/directrices/0/3", "this point is 9.23"), (crossed, "/directrices/0", "do not cross")]
    {
        let stack = [contour, ring(31, 1.0, 0.5, false)];
        let options = Options { closed: true, caps: Caps::Flat, ..Options::default() };
        let error = solve(&stack, &options, &Execution::default()).unwrap_err();
        let Error::Input(errors) = &error else { panic!("{error}") };
        assert_eq!(errors[0].place.to_string(), place, "{error}");
        assert!(errors[0].detail.contains(detail), "{error}");
    }
}

/// End contours in sloping planes whose coordinates were rounded, to a micrometre and to a millimetre.
#[test]
fn rounded_end_contours_are_projected_before_they_are_capped() {
    let ring = |count: usize, tilt: f64, height: f64, digit: f64| -> Vec<DVec3> {
        let point = |k: usize| {
            let angle = std::f64::consts::TAU * k as f64 / count as f64;
            let point = DVec3::new(500.0 * angle.cos(), 300.0 * angle.sin(), 0.0);
            let turned = glam::DQuat::from_rotation_y(tilt) * point + DVec3::new(0.0, 0.0, height);
            (turned / digit).round() * digit
        };
        (0..count).map(point).collect()
    };
    for digit in [1e-3, 1.0] {
        let middle = ring(30, 0.3, 300.0, digit);
        let stack = [ring(40, 0.1, 0.0, digit), middle.clone(), ring(51, 0.4, 600.0, digit)];
        let options = Options { closed: true, caps: Caps::Flat, ..Options::default() };
        let surface = solved(&stack, &options);
        let projected = |surface: &RuledSurface| -> Vec<String> {
            let of = surface.warnings.iter().filter(|warning| warning.code == "projected");
            of.map(|warning| warning.detail.clone()).collect()
        };
        let warnings = projected(&surface);
        assert_eq!(warnings.len(), 2, "{warnings:?}");
        assert!(warnings[0].starts_with("directrix 0 ") && warnings[1].starts_with("directrix 2 "), "{warnings:?}");
        assert_eq!(surface.mesh.check().expect("a manifold").euler_characteristic(), 2);
        let vertices = &surface.mesh.vertices;
        let moved = stack[0].iter().zip(vertices).map(|(a, b)| a.distance(*b)).fold(0.0, f64::max);
        assert!(moved > 0.1 * digit && moved < 2.0 * digit, "{moved}");
        let stated = warnings[0].split("by up to ").nth(1).and_then(|rest| rest.split(',').next());
        let stated: f64 = stated.and_then(|number| number.parse().ok()).expect("a distance");
        assert!((stated - moved).abs() < 1e-6 * moved + 1e-12, "{moved} {warnings:?}");
        assert_eq!(vertices[40..70], middle, "a contour without a cap stays");
        // A projected directrix is planar, so the second solve caps it without projecting.
        let again = [vertices[..40].to_vec(), middle, vertices[70..].to_vec()];
        let again = solved(&again, &options);
        assert_eq!(projected(&again), Vec::<String>::new());
        assert_eq!(again.mesh, surface.mesh);
    }
}

#[test]
fn sampling_follows_the_callers_rule() {
    // A right angle: 1 along x in ten points, then 3 along y in one segment.
    let mut rail: Vec<DVec3> = (0..=10).map(|k| DVec3::new(0.1 * f64::from(k), 0.0, 0.0)).collect();
    rail.push(DVec3::new(1.0, 3.0, 0.0));
    let other: Vec<DVec3> = rail.iter().map(|p| *p + DVec3::Z).collect();
    let sampled = |sampling| {
        let surface =
            solved(&[rail.clone(), other.clone()], &Options { sampling: Some(sampling), ..Options::default() });
        surface.directrices[0].iter().map(|&v| surface.mesh.vertices[v as usize]).collect::<Vec<_>>()
    };
    let by_length = sampled(Sampling::ArcLength { samples: 5 });
    let expected = [[0.0, 0.0], [1.0, 0.0], [1.0, 1.0], [1.0, 2.0], [1.0, 3.0]];
    assert!(by_length.iter().zip(expected).all(|(p, [x, y])| p.distance(DVec3::new(x, y, 0.0)) < 1e-12));
    let by_parameter = sampled(Sampling::Parameter { samples: 23 });
    assert_eq!(by_parameter.len(), 23);
    assert!(by_parameter[1].distance(DVec3::new(0.05, 0.0, 0.0)) < 1e-12);
    let by_height = sampled(Sampling::ChordHeight { samples: None, tolerance: 1e-9 });
    assert_eq!(by_height, [rail[0], rail[10], rail[11]]);
    assert_eq!(sampled(Sampling::ChordHeight { samples: Some(2), tolerance: 0.0 }).len(), 2);
}

#[test]
fn odd_inputs_are_answered_or_refused_but_never_break() {
    let line = |count: usize| (0..count).map(|k| DVec3::new(k as f64, 0.0, 0.0)).collect::<Vec<_>>();
    let bent = |count: usize| {
        (0..count).map(|k| DVec3::new(k as f64, (k * k) as f64 * 0.1, 0.3 * (k % 3) as f64)).collect::<Vec<_>>()
    };
    let by =
        |points: Vec<DVec3>, scale: f64, shift: f64| points.into_iter().map(|p| p * scale + shift).collect::<Vec<_>>();
    let mut doubled = bent(9);
    doubled.insert(4, doubled[4]);
    let mut returning = bent(6);
    returning.extend(bent(5).into_iter().rev());
    let corpus: Vec<[Vec<DVec3>; 2]> = vec![
        [line(6), by(line(6), 1.0, 0.5)],
        [line(6), line(6)],
        [line(2), line(2).into_iter().rev().collect()],
        [bent(7), bent(7)],
        [bent(7), doubled],
        [returning.clone(), line(4)],
        [line(1), bent(9)],
        [bent(3), bent(400)],
        [by(bent(8), 1.0, 1e7), by(line(5), 1.0, 1e7)],
        [by(bent(8), 1e-6, 0.0), by(line(5), 1e-6, 1e-6)],
        [by(bent(8), 1e-300, 0.0), by(line(5), 1e-300, 1e-300)],
        [by(bent(8), 1e98, 0.0), by(line(5), 1e98, 1e97)],
        [by(bent(8), 1.0, 1e100), by(line(5), 1.0, 1.0)],
        [by(bent(8), f64::MIN_POSITIVE / 16.0, 0.0), line(3)],
        [returning, bent(9).into_iter().rev().collect()],
    ];
    // A closed polygon of two points and coordinates beyond the largest are refused. Every other input has a solution.
    let is_refused = |k: usize, closed: bool| [11, 12].contains(&k) || (k == 2 && closed);
    for (k, rails) in corpus.iter().enumerate() {
        for closed in [false, true] {
            for goal in GOALS {
                match solve(rails, &options(goal, closed), &Execution::default()) {
                    Ok(surface) => {
                        assert!(!is_refused(k, closed), "{k} {closed}");
                        let s = surface.statistics;
                        let figures = [
                            s.area,
                            s.total_normal_twist,
                            s.bending_energy,
                            s.mean_curvature_variation,
                            s.objective_value,
                        ];
                        assert!(figures.iter().all(|v| v.is_finite()), "{k} {goal:?} {s:?}");
                        assert_eq!(surface.mesh.triangles.len(), s.triangles);
                        assert_eq!(surface.bridges.len(), s.bridges);
                    }
                    Err(Error::Input(errors)) => assert!(is_refused(k, closed) && !errors.is_empty(), "{k} {errors:?}"),
                    Err(other) => panic!("{k} {goal:?}: {other}"),
                }
            }
        }
    }
}

/// Input: one point at the largest coordinate. Weights that overflow must neither lead a closed search out of its grid
/// nor let it run on without end.
#[test]
fn one_point_at_the_largest_coordinate_breaks_no_search() {
    let ring = |n: usize, z: f64| -> Vec<DVec3> {
        let angles = (0..n).map(|k| std::f64::consts::TAU * k as f64 / n as f64);
        angles.map(|t| DVec3::new(2.0 * t.cos(), 2.0 * t.sin(), z)).collect()
    };
    for closed in [false, true] {
        for (objective, secondary) in GOALS {
            for axis in [DVec3::X, DVec3::Z, DVec3::ONE] {
                let (p, mut q) = (ring(36, 0.0), ring(48, 1.2));
                q[0] = 9.9e49 * axis;
                let strip = Strip::new(p.as_slice().into(), q.as_slice().into(), closed).expect("a valid strip");
                let path = strip.optimal_path(objective, secondary, 1e-8, &Execution::default());
                assert!(path.is_ok_and(|path| path.len() == if closed { 84 } else { 83 }), "{objective:?} {closed}");
            }
        }
    }
}

#[test]
fn wrong_values_are_named() {
    let good = vec![DVec3::ZERO, DVec3::X];
    let place = |directrices: &[Vec<DVec3>], options: &Options| match solve(directrices, options, &Execution::default())
    {
        Err(Error::Input(errors)) => errors[0].place.to_string(),
        other => panic!("not refused: {other:?}"),
    };
    let plain = Options::default();
    assert_eq!(place(std::slice::from_ref(&good), &plain), "/directrices");
    assert_eq!(place(&[good.clone(), vec![]], &plain), "/directrices/1");
    for wrong in [f64::NAN, f64::INFINITY, 1e101] {
        let rail = vec![DVec3::ZERO, DVec3::new(0.0, wrong, 0.0)];
        assert_eq!(place(&[good.clone(), rail], &plain), "/directrices/1/1/1");
    }
    assert_eq!(place(&[vec![DVec3::X], vec![DVec3::Y; 3]], &plain), "/directrices/1");
    let closed = Options { closed: true, ..Options::default() };
    assert_eq!(place(&[good.clone(), good.clone()], &closed), "/directrices/0");
    let variation = Options { objective: Objective::MinimalNormalVariation, ..Options::default() };
    assert_eq!(place(&[good.clone(), good.clone()], &variation), "/normals");
    let short = Options { normals: Some(vec![vec![DVec3::Z; 2], vec![DVec3::Z]]), ..Options::default() };
    assert_eq!(place(&[good.clone(), good.clone()], &short), "/normals/1");
    let secondary = Options { secondary: Some(Secondary::BendingEnergy), ..Options::default() };
    assert_eq!(place(&[good.clone(), good.clone()], &secondary), "/secondary_objective");
    let tolerance = Options { convexity_tolerance: -1.0, ..Options::default() };
    assert_eq!(place(&[good.clone(), good.clone()], &tolerance), "/convexity_tolerance");
    let weights = Weights { area: -1.0, ..Weights::default() };
    let weighted = Options { objective: Objective::Weighted(weights), ..Options::default() };
    assert_eq!(place(&[good.clone(), good.clone()], &weighted), "/objective/weights/minimal_area");
    let caps = Options { caps: Caps::Flat, ..Options::default() };
    assert_eq!(place(&[good.clone(), good], &caps), "/caps");
}

#[test]
fn a_solve_looks_often_reports_in_order_and_stops_when_asked() {
    let rail = |phase: f64, y: f64| -> Vec<DVec3> {
        (0..1500)
            .map(|k| f64::from(k) * 0.01)
            .map(|x| DVec3::new(x, y + (x + phase).sin(), (2.0 * x - phase).cos()))
            .collect()
    };
    let rails = [rail(0.0, 0.0), rail(1.0, 3.0)];
    for closed in [false, true] {
        // Closed strips take fewer points, because they need dozens of searches.
        let rails: Vec<Vec<DVec3>> = rails.iter().map(|r| if closed { r[..300].to_vec() } else { r.clone() }).collect();
        for goal in GOALS {
            let options = options(goal, closed);
            let (last, reports) = (Cell::new(0.0), Cell::new(0));
            let report = |progress: plateau_mesh::Progress| {
                assert!(progress.fraction >= last.get() && progress.fraction <= 1.0);
                last.set(progress.fraction);
                reports.set(reports.get() + 1);
            };
            let execution = Execution::new(&|| Signal::Continue, &report);
            solve(&rails, &options, &execution).expect("nothing stops it");
            assert_eq!(last.get(), 1.0);
            // The search for least area visits few cells of an open strip, so only few reports are expected.
            let least = if closed || options.objective == Objective::MinimalArea { 0 } else { 10 };
            assert!(reports.get() > least, "{goal:?}: {} reports", reports.get());
            assert!(execution.looks() > 1);
            assert!(execution.largest_work_between_looks() <= 1 << 18, "{}", execution.largest_work_between_looks());
            let looks = Cell::new(0);
            let stop = || {
                looks.set(looks.get() + 1);
                if looks.get() > execution.looks() / 2 { Signal::Cancel } else { Signal::Continue }
            };
            let stopped = solve(&rails, &options, &Execution::new(&stop, &|_| {}));
            assert_eq!(stopped, Err(Error::Interrupted(Interruption::Cancelled)));
        }
    }
}

#[test]
fn an_open_strip_is_priced_to_the_cell() {
    for (objective, most) in [
        (Objective::MinimalArea, 40),
        (Objective::MinimalBendingEnergy, 70),
        (Objective::MinimalMeanCurvatureVariation, 120),
    ] {
        let cost = estimate(&[10_000, 10_000], &Options { objective, ..Options::default() });
        // The cells of the search itself, and of the strip of least area with which it is compared.
        let searches = if objective == Objective::MinimalArea { 1 } else { 2 };
        assert_eq!(cost.cells, searches * 100_000_000);
        // 250 bytes for each of the 20,000 points, and 2 MB for the first of them, come on top of the search.
        let search = cost.bytes - 7_000_000;
        assert!(search > 12_500_000 && search < most << 20, "{objective:?}: {search}");
        assert_eq!(cost.triangles, 19_998.0);
    }
}
