//! Cable nets: compared with closed forms and published figures, and the inputs that are refused.

use plateau_cable_net::{CableNet, Edge, Net, Options, StopReason, check, solve};
use plateau_mesh::{DVec3, Error, Execution, Interruption, Signal};
use std::cell::{Cell, RefCell};

/// A square net with sides of length `side` and `cells` cells along each side. The vertices are numbered row by row.
/// `edge` makes an edge from its ends and from whether it is on the rim.
fn grid(side: f64, cells: u32, edge: impl Fn([u32; 2], bool) -> Edge) -> Net {
    let mut net = Net::default();
    let number = |i: u32, j: u32| i * (cells + 1) + j;
    for i in 0..=cells {
        for j in 0..=cells {
            let at = |k: u32| side * f64::from(k) / f64::from(cells);
            net.vertices.push(DVec3::new(at(i), at(j), 0.0));
            if i < cells {
                net.edges.push(edge([number(i, j), number(i + 1, j)], j == 0 || j == cells));
            }
            if j < cells {
                net.edges.push(edge([number(i, j), number(i, j + 1)], i == 0 || i == cells));
            }
        }
    }
    net.supports = vec![number(0, 0), number(0, cells), number(cells, 0), number(cells, cells)];
    net
}

fn found(net: &Net, options: &Options) -> CableNet {
    let result = solve(net, options, &Execution::default()).unwrap();
    let scale = result.forces.iter().copied().fold(0.0, f64::max);
    assert!(result.residual_force < 1e-9 * scale && result.imbalance < 1e-12, "{result:?}");
    assert!(result.forces.iter().zip(&net.edges).all(|(force, edge)| (*force < 0.0) == edge.strut));
    result
}

#[test]
fn a_hypar_of_equal_densities_passes_through_the_mean_of_its_supports() {
    // The test of compas_fd: four supports, two of them lifted by 1. The free vertex must come to (0.5, 0.5, 0.5).
    let corners = [(0.0, 0.0, 0.0), (1.0, 0.0, 1.0), (1.0, 1.0, 0.0), (0.0, 1.0, 1.0)];
    let mut vertices: Vec<DVec3> = corners.map(|(x, y, z)| DVec3::new(x, y, z)).to_vec();
    vertices.push(DVec3::new(0.2, 0.7, 3.0));
    let edges = (0..4).map(|k| Edge { ends: [k, 4], density: Some(1.0), ..Edge::default() }).collect();
    let net = Net { vertices, edges, supports: vec![0, 1, 2, 3], loads: Vec::new() };
    let result = found(&net, &Options::default());
    assert!(result.vertices[4].distance(DVec3::splat(0.5)) < 1e-14);
    assert_eq!((result.stop_reason, result.loss), (StopReason::NoTargets, 0.0));
    // The reaction of each support is the force of its cable.
    assert!(result.reactions.iter().all(|reaction| (reaction.length() - 0.75f64.sqrt()).abs() < 1e-14));
}

#[test]
fn a_loaded_string_of_equal_densities_is_a_parabola() {
    // Equal weights at equal steps, so the sag is the bending moment of the loads over the density.
    let count = 20u32;
    let vertices: Vec<DVec3> = (0..=count).map(|k| DVec3::new(f64::from(k), 0.0, 0.0)).collect();
    let edges = (0..count).map(|k| Edge { ends: [k, k + 1], density: Some(5.0), ..Edge::default() }).collect();
    let loads = vec![DVec3::new(0.0, 0.0, -0.3); vertices.len()];
    let net = Net { vertices, edges, supports: vec![0, count], loads };
    let result = found(&net, &Options::default());
    for (k, p) in result.vertices.iter().enumerate() {
        let k = k as f64;
        let sag = 0.3 / 5.0 * 0.5 * k * (f64::from(count) - k);
        assert!((p.x - k).abs() < 1e-12 && (p.z + sag).abs() < 1e-12, "{p}");
    }
    let lift: f64 = result.reactions.iter().map(|reaction| reaction.z).sum();
    assert!((lift - 0.3 * 21.0).abs() < 1e-12);
}

/// The net of jax_fdm's `cablenet.md`: a square of 10 m with 10 × 10 cells, and two opposite corners lifted by 5 m.
fn lifted(cells: u32) -> Net {
    let force_at_start = |rim: bool| if rim { 20.0 } else { 1.0 };
    let mut net = grid(10.0, cells, |ends, rim| Edge {
        ends,
        density: Some(force_at_start(rim) * f64::from(cells) / 10.0),
        held: false,
        strut: false,
        force: rim.then_some(20.0),
        length: (!rim).then_some(10.0 / f64::from(cells)),
    });
    for support in [0, 3] {
        net.vertices[net.supports[support] as usize].z = 5.0;
    }
    net
}

#[test]
fn the_net_of_jax_fdm_reaches_its_targets() {
    // The loss of jax_fdm is the mean of (F - 20)² over the rim and of (L - 1)² inside, so the relative deviation of
    // the forces counts 400 times. jax_fdm reports forces of 19.998 to 20.002, lengths of 0.97 to 1.05 and a loss of
    // 0.000804, with no density below 0.1.
    let net = lifted(10);
    let options = Options { force_weight: 400.0, least_density: 0.1, tolerance: 1e-9, ..Options::default() };
    let result = found(&net, &options);
    let range = |values: Vec<f64>| {
        (values.iter().copied().fold(f64::INFINITY, f64::min), values.iter().copied().fold(0.0, f64::max))
    };
    let of = |force: bool, values: &[f64]| {
        range(net.edges.iter().zip(values).filter(|(e, _)| e.force.is_some() == force).map(|(_, v)| *v).collect())
    };
    let (forces, lengths) = (of(true, &result.forces), of(false, &result.lengths));
    println!(
        "{} {} {forces:?} {lengths:?} {:?} {}",
        result.loss, result.iterations, result.stop_reason, result.gradient
    );
    assert!(result.loss < 0.000804, "{}", result.loss);
    assert!(forces.0 > 19.97 && forces.1 < 20.03 && lengths.0 > 0.959 && lengths.1 < 1.05, "{forces:?} {lengths:?}");
    assert!(result.densities.iter().all(|q| *q >= 0.1));
}

#[test]
fn a_fine_net_is_not_drawn_together_by_the_densities_that_it_begins_with() {
    // The inner cables start with ten times the force: the 19 cables that meet a side pull with 10 × 19 against the 20
    // of the rim. A fit that starts from these densities ends with lengths that deviate by 40 % in the mean (0.156 is
    // the mean of the squares).
    let mut net = lifted(20);
    for edge in net.edges.iter_mut().filter(|edge| edge.length.is_some()) {
        edge.density = edge.density.map(|q| 10.0 * q);
    }
    let options = Options { force_weight: 400.0, length_weight: 1e-4, least_density: 0.1, ..Options::default() };
    let result = found(&net, &options);
    println!("{} {} {:?} {}", result.loss, result.iterations, result.stop_reason, result.gradient);
    assert!(result.loss < 1e-4 * 0.002, "{}", result.loss);
    for ((edge, length), force) in net.edges.iter().zip(&result.lengths).zip(&result.forces) {
        assert!(edge.length.is_none_or(|target| (length / target - 1.0).abs() < 0.2), "{length}");
        assert!(edge.force.is_none_or(|target| (force / target - 1.0).abs() < 0.02), "{force}");
    }
}

#[test]
fn a_target_that_a_net_can_reach_is_reached() {
    // The forces of a net of unequal densities are the targets of a net that starts from equal densities.
    let mut net = lifted(4);
    for (k, edge) in net.edges.iter_mut().enumerate() {
        *edge = Edge { ends: edge.ends, density: Some(1.0 + 0.1 * (k % 7) as f64), ..Edge::default() };
    }
    let reference = found(&net, &Options::default());
    for (edge, force) in net.edges.iter_mut().zip(&reference.forces) {
        (edge.density, edge.force) = (Some(1.0), Some(*force));
    }
    let result = found(&net, &Options { tolerance: 1e-9, ..Options::default() });
    println!("{} {} {:?}", result.loss, result.iterations, result.stop_reason);
    for (force, wanted) in result.forces.iter().zip(&reference.forces) {
        assert!((force / wanted - 1.0).abs() < 1e-4, "{force} {wanted}");
    }
}

#[test]
fn a_shorter_load_path_is_found_when_it_is_asked_for() {
    let mut net = lifted(6);
    net.loads = vec![DVec3::new(0.0, 0.0, -0.5); net.vertices.len()];
    let options = Options { least_density: 0.01, ..Options::default() };
    let plain = found(&net, &options);
    let light = found(&net, &Options { load_path_weight: 1.0, ..options });
    println!("{} {}", plain.load_path, light.load_path);
    assert!(light.load_path < 0.9 * plain.load_path);
}

#[test]
fn held_densities_stay_and_the_others_are_fitted() {
    // The rim of the lifted net keeps its density, and the lengths inside are fitted.
    let mut net = lifted(6);
    for edge in &mut net.edges {
        if edge.force.is_some() {
            (edge.density, edge.force, edge.held) = (Some(15.0), None, true);
        }
    }
    let plain = Net { edges: net.edges.iter().map(|edge| Edge { length: None, ..*edge }).collect(), ..net.clone() };
    let start = found(&plain, &Options { least_density: 0.1, ..Options::default() });
    let result = found(&net, &Options { least_density: 0.1, ..Options::default() });
    let held = net.edges.iter().zip(&result.densities).filter(|(edge, _)| edge.held);
    assert!(held.clone().count() == 24 && held.clone().all(|(_, q)| *q == 15.0));
    let deviation = |found: &CableNet| {
        let of = |(edge, length): (&Edge, &f64)| edge.length.map(|target| (length / target - 1.0).powi(2));
        net.edges.iter().zip(&found.lengths).filter_map(of).sum::<f64>()
    };
    assert!(deviation(&result) < 0.5 * deviation(&start), "{} {}", deviation(&result), deviation(&start));
    // If all densities are held, only the linear equations are solved, whatever the targets.
    net.edges.iter_mut().for_each(|edge| (edge.density, edge.held) = (edge.density.or(Some(1.0)), true));
    assert_eq!(found(&net, &Options::default()).stop_reason, StopReason::NoTargets);
}

#[test]
fn a_deadline_returns_the_net_of_the_last_step_in_equilibrium() {
    let net = lifted(6);
    let looks = Cell::new(0);
    let signal = || {
        looks.set(looks.get() + 1);
        if looks.get() > 4 { Signal::Deadline } else { Signal::Continue }
    };
    let options = Options { least_density: 0.1, ..Options::default() };
    let result = solve(&net, &options, &Execution::new(&signal, &|_| {})).unwrap();
    assert_eq!((result.stop_reason, result.converged()), (StopReason::Deadline, false));
    assert!(result.iterations > 0 && result.iterations < 5 && result.imbalance < 1e-12);
}

#[test]
fn a_caller_is_asked_between_the_factorisations_before_the_first_step() {
    // Solves a net for a caller who sends a signal from the given look on.
    let solve = |net: &Net, from: u32, signal: Signal| {
        let looks = Cell::new(0);
        let signal = || if looks.replace(looks.get() + 1) < from { Signal::Continue } else { signal };
        solve(net, &Options::default(), &Execution::new(&signal, &|_| {}))
    };
    let mut net = lifted(6);
    let late = solve(&net, 0, Signal::Deadline).unwrap();
    assert_eq!((late.stop_reason, late.iterations, late.converged()), (StopReason::Deadline, 0, false));
    assert!(late.imbalance < 1e-12, "{}", late.imbalance);
    // If all densities are held, the shape is the complete result, so that a deadline does not matter.
    net.edges.iter_mut().for_each(|edge| (edge.density, edge.held) = (edge.density.or(Some(1.0)), true));
    let complete = solve(&net, 0, Signal::Deadline).unwrap();
    assert_eq!((complete.stop_reason, complete.converged()), (StopReason::NoTargets, true));
    for from in [0, 1] {
        let cancelled = solve(&net, from, Signal::Cancel);
        assert_eq!(cancelled.unwrap_err(), Error::Interrupted(Interruption::Cancelled), "from look {from} on");
    }
}

#[test]
fn a_caller_is_asked_before_and_after_the_factorisation_of_a_step() {
    let (looks, at_reports) = (Cell::new(0), RefCell::new(Vec::new()));
    let signal = || {
        looks.set(looks.get() + 1);
        Signal::Continue
    };
    let report = |_| at_reports.borrow_mut().push(looks.get());
    let options = Options { least_density: 0.1, ..Options::default() };
    solve(&lifted(6), &options, &Execution::new(&signal, &report)).unwrap();
    let at_reports = at_reports.into_inner();
    assert!(at_reports.len() > 2, "{at_reports:?}");
    for step in at_reports.windows(2) {
        assert!(step[1] - step[0] >= 3, "{at_reports:?}");
    }
}

#[test]
fn targets_that_are_met_from_the_start_need_no_step() {
    let ends = [DVec3::new(-1.0, 0.0, 0.0), DVec3::new(1.0, 0.0, 0.0), DVec3::ZERO];
    let edge = |k: u32| Edge { ends: [k, 2], force: Some(1.0), length: Some(1.0), ..Edge::default() };
    let net = Net { vertices: ends.to_vec(), edges: vec![edge(0), edge(1)], supports: vec![0, 1], loads: Vec::new() };
    let result = found(&net, &Options::default());
    assert!(result.loss < 1e-24 && result.converged(), "{result:?}");
}

#[test]
fn scales_of_lengths_and_forces_change_nothing() {
    // The scales are powers of two, so that every product is exact and each step is the same.
    let net = lifted(6);
    let options = Options { least_density: 1e-3, ..Options::default() };
    let reference = found(&net, &options);
    let mut scaled = net.clone();
    scaled.vertices.iter_mut().for_each(|p| *p *= 1024.0);
    for edge in &mut scaled.edges {
        edge.density = edge.density.map(|q| 4.0 * q / 1024.0);
        edge.force = edge.force.map(|force| 4.0 * force);
        edge.length = edge.length.map(|length| 1024.0 * length);
    }
    let result = found(&scaled, &Options { least_density: 4.0 * 1e-3 / 1024.0, ..options });
    assert_eq!((result.loss, result.iterations), (reference.loss, reference.iterations));
}

#[test]
fn bad_nets_are_refused_by_the_place_of_the_value() {
    let refused = |change: &dyn Fn(&mut Net)| {
        let mut net = lifted(4);
        change(&mut net);
        match check(&net, &Options::default()) {
            Err(Error::Input(errors)) => errors[0].place.to_string(),
            other => panic!("{other:?}"),
        }
    };
    assert_eq!(refused(&|net| net.edges[3].force = Some(-1.0)), "/edges/3/force");
    assert_eq!(refused(&|net| net.edges[3].length = Some(0.0)), "/edges/3/length");
    assert_eq!(refused(&|net| net.edges[3].density = Some(f64::NAN)), "/edges/3/density");
    assert_eq!(refused(&|net| net.edges[2].ends = [7, 7]), "/edges/2/ends");
    assert_eq!(refused(&|net| net.edges[2].ends = [7, 99]), "/edges/2/ends/1");
    assert_eq!(refused(&|net| net.supports[1] = 99), "/supports/1");
    assert_eq!(refused(&|net| net.loads = vec![DVec3::ZERO; 3]), "/loads");
    assert_eq!(refused(&|net| net.vertices[5].y = f64::INFINITY), "/vertices/5");
    assert_eq!(refused(&|net| net.edges.clear()), "/edges");
    assert_eq!(refused(&|net| net.supports.clear()), "/vertices/0");
    let chain = |supports: &[u32], length: f64, loads: Vec<DVec3>| {
        let vertices = (0..4u32).map(|k| DVec3::new(f64::from(k), 0.0, 0.0)).collect();
        let edge = |k| Edge { ends: [k, k + 1], length: Some(length), ..Edge::default() };
        let net = Net { vertices, edges: (0..3).map(edge).collect(), supports: supports.to_vec(), loads };
        match check(&net, &Options::default()) {
            Ok(()) => Vec::new(),
            Err(Error::Input(errors)) => errors.iter().map(|error| error.place.to_string()).collect(),
            Err(other) => panic!("{other:?}"),
        }
    };
    // The free end of a chain is undetermined, and so are the vertices that hang on it, unless a load pulls at the end.
    assert_eq!(chain(&[0], 1.0, Vec::new()), ["/vertices/1", "/vertices/2", "/vertices/3"]);
    let pull = DVec3::new(1.0, 0.0, 0.0);
    assert_eq!(chain(&[0], 1.0, vec![DVec3::ZERO, DVec3::ZERO, DVec3::ZERO, pull]), Vec::<String>::new());
    // A cable between two supports has the length of its chord.
    assert_eq!(chain(&[0, 1, 3], 1.0, Vec::new()), Vec::<String>::new());
    assert_eq!(chain(&[0, 1, 3], 1.1, Vec::new()), ["/edges/0/length"]);
    assert_eq!(chain(&[0, 1, 3], 0.9, Vec::new()), ["/edges/0/length"]);
    assert_eq!(refused(&|net| net.vertices[8] = net.vertices[7]), "/edges/14");
    assert_eq!(refused(&|net| net.edges[4].ends = net.edges[3].ends), "/edges/4");
    assert_eq!(refused(&|net| (net.edges[4].density, net.edges[4].held) = (None, true)), "/edges/4/density");
    // A vertex without cables.
    assert_eq!(refused(&|net| net.vertices.push(DVec3::ZERO)), "/vertices/25");
}

#[test]
fn the_same_net_gives_the_same_bits_and_looks_at_the_caller() {
    let net = lifted(6);
    let options = Options { least_density: 0.1, ..Options::default() };
    let [a, b] = [0, 1].map(|_| solve(&net, &options, &Execution::default()).unwrap());
    assert_eq!(a, b);
    let cancel = Execution::new(&|| Signal::Cancel, &|_| {});
    let cancelled = solve(&net, &Options::default(), &cancel);
    assert_eq!(cancelled.unwrap_err(), Error::Interrupted(Interruption::Cancelled));
}

/// Returns a prism of three struts: a fixed triangle of radius 1, a second triangle above it that begins turned by
/// `turn` degrees, and cables of force 1 between them. Each lower vertex has a cable to one upper vertex, and a strut
/// to the upper vertex that follows a third of a turn later.
fn triplex(turn: f64) -> Net {
    let third = |k: u32, turn: f64, z: f64| {
        let angle = (120.0 * f64::from(k) + turn).to_radians();
        DVec3::new(libm::cos(angle), libm::sin(angle), z)
    };
    let mut vertices: Vec<DVec3> = (0..3).map(|k| third(k, 0.0, 0.0)).collect();
    vertices.extend((0..3).map(|k| third(k, turn, 1.4)));
    let mut edges = Vec::new();
    for k in 0..3 {
        let above = |by: u32| 3 + (k + by) % 3;
        edges.push(Edge { ends: [above(0), above(1)], length: Some(3.0f64.sqrt()), ..Edge::default() });
        edges.push(Edge { ends: [k, above(0)], force: Some(1.0), ..Edge::default() });
        edges.push(Edge { ends: [k, above(1)], strut: true, length: Some(2.5), ..Edge::default() });
    }
    Net { vertices, edges, supports: vec![0, 1, 2], loads: Vec::new() }
}

#[test]
fn the_prism_of_three_struts_is_twisted_by_thirty_degrees() {
    for turn in [-20.0, 0.0, 10.0, 60.0] {
        let net = triplex(turn);
        let result = found(&net, &Options::default());
        println!("{turn}: {} {} {:?} {:?}", result.loss, result.iterations, result.stop_reason, result.forces);
        assert!(result.converged() && result.loss < 1e-16, "{turn}: {result:?}");
        for k in 3..6 {
            let p = result.vertices[k];
            let twist = libm::atan2(p.y, p.x).to_degrees() - 120.0 * (k - 3) as f64;
            assert!(((twist - 30.0 + 540.0).rem_euclid(360.0) - 180.0).abs() < 1e-6, "{turn}: {twist}");
            assert!((p.truncate().length() - 1.0).abs() < 1e-6);
        }
        // The force density of a strut is the opposite of that of its cable, and its length is the wanted one.
        for (edge, (length, q)) in net.edges.iter().zip(result.lengths.iter().zip(&result.densities)) {
            assert!(
                !edge.strut || (length - 2.5).abs() < 1e-8 && (q + result.densities[1]).abs() < 1e-6,
                "{length} {q}"
            );
        }
    }
}

#[test]
fn a_strut_bears_what_statics_says() {
    // A mast on a fixed foot, held by three stays of force 2.
    let foot = DVec3::ZERO;
    let anchors = [0.0f64, 120.0, 240.0]
        .map(|angle| DVec3::new(3.0 * libm::cos(angle.to_radians()), 3.0 * libm::sin(angle.to_radians()), 0.0));
    let mut vertices = vec![foot, DVec3::new(0.2, 0.1, 3.5)];
    vertices.extend(anchors);
    let mut edges = vec![Edge { ends: [0, 1], strut: true, length: Some(4.0), ..Edge::default() }];
    edges.extend((2..5).map(|k| Edge { ends: [k, 1], force: Some(2.0), ..Edge::default() }));
    let net = Net { vertices, edges, supports: vec![0, 2, 3, 4], loads: Vec::new() };
    let result = found(&net, &Options { tolerance: 1e-12, ..Options::default() });
    // By symmetry the mast stands upright, and bears the vertical parts of the three stays' forces.
    let top = result.vertices[1];
    assert!(top.distance(DVec3::new(0.0, 0.0, 4.0)) < 1e-6, "{top} {result:?}");
    assert!((result.forces[0] + 3.0 * 2.0 * 0.8).abs() < 1e-6, "{:?}", result.forces);
    // Under a load the mast bears more, and the targets are still met.
    let loads = vec![DVec3::ZERO, DVec3::new(0.0, 0.0, -1.5), DVec3::ZERO, DVec3::ZERO, DVec3::ZERO];
    let result = found(&Net { loads, ..net }, &Options { tolerance: 1e-12, ..Options::default() });
    assert!((result.forces[0] + 3.0 * 2.0 * 0.8 + 1.5).abs() < 1e-6, "{:?}", result.forces);
}

#[test]
fn targets_that_no_net_meets_fail_and_name_the_edges_that_grow() {
    // Two cables of force 1 cannot bear a load of 3, because 2 F cos α = 3 needs F > 1.5.
    let vertices = vec![DVec3::new(-1.0, 0.0, 0.0), DVec3::new(1.0, 0.0, 0.0), DVec3::new(0.0, 0.0, -0.5)];
    let net = |force: f64| Net {
        vertices: vertices.clone(),
        edges: (0..2).map(|k| Edge { ends: [k, 2], force: Some(force), ..Edge::default() }).collect(),
        supports: vec![0, 1],
        loads: vec![DVec3::ZERO, DVec3::ZERO, DVec3::new(0.0, 0.0, -3.0)],
    };
    for force in [0.5, 1.0, 1.4, 1.49] {
        match solve(&net(force), &Options::default(), &Execution::default()) {
            Err(Error::NoResult { reason, places, .. }) => {
                let named: Vec<String> = places.iter().map(|place| place.place.to_string()).collect();
                assert_eq!((reason.name(), named), ("targets_not_reached", vec!["/edges/0".into(), "/edges/1".into()]));
            }
            other => panic!("{force}: {other:?}"),
        }
    }
    // A force that is large enough is reached, even if the net hangs deep.
    for force in [1.6, 1.501] {
        let result = found(&net(force), &Options::default());
        assert!((result.forces[0] / force - 1.0).abs() < 1e-6 && !result.missed.contains(&true), "{result:?}");
    }
}

#[test]
fn an_edge_that_misses_a_target_by_more_than_half_is_marked() {
    // In a straight string both halves have the same force, so no net meets both targets.
    let vertices = vec![DVec3::ZERO, DVec3::new(1.0, 0.0, 0.0), DVec3::new(2.0, 0.0, 0.0)];
    let edge = |k: u32, force: f64| Edge { ends: [k, k + 1], force: Some(force), ..Edge::default() };
    let net = Net { vertices, edges: vec![edge(0, 1.0), edge(1, 5.0)], supports: vec![0, 2], loads: Vec::new() };
    let result = found(&net, &Options::default());
    assert_eq!(result.missed, [false, true], "{:?}", result.forces);
    assert!(result.converged() && (result.forces[1] / 5.0 - 1.0).abs() > 0.5, "{:?}", result.forces);
}

#[test]
fn a_net_at_survey_coordinates_is_balanced_as_far_as_they_allow() {
    let mut net = lifted(10);
    let options = Options { least_density: 0.1, ..Options::default() };
    let reference = found(&net, &options);
    let far = DVec3::new(512_345.5, 5_412_345.75, 290.25);
    net.vertices.iter_mut().for_each(|p| *p += far);
    let result = solve(&net, &options, &Execution::default()).unwrap();
    let largest = result.forces.iter().copied().fold(0.0, f64::max);
    // Coordinates near 5e6 are multiples of 1e-9, and the densities are about 20, so the balance cannot be exact.
    println!("{} {}", result.residual_force / largest, result.loss / reference.loss - 1.0);
    assert!(result.residual_force < 2e-8 * largest, "{}", result.residual_force / largest);
    assert!((result.loss / reference.loss - 1.0).abs() < 1e-6);
    for (p, q) in result.vertices.iter().zip(&reference.vertices) {
        assert!((*p - far).distance(*q) < 1e-6);
    }
}
