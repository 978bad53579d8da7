//! Times the cable net of jax_fdm's `cablenet.md`: a square of side 10 with two opposite corners lifted by 5. The
//! targets are forces of 20 on the rim and equal lengths inside. No force density may fall below 0.1.
//!
//! `cargo bench -p plateau-cable-net --bench cable_net` measures with criterion. With `-- --case CELLS` one net is
//! fitted once, and its figures are printed as one JSON line. `benches/cable_net_peers.py` compares these figures with
//! jax_fdm's.

#![allow(
    clippy::disallowed_macros,
    clippy::disallowed_methods,
    clippy::disallowed_types,
    clippy::too_many_lines,
    reason = "a benchmark"
)]

use criterion::{BenchmarkId, Criterion};
use plateau_cable_net::{CableNet, Edge, Net, Options, solve};
use plateau_mesh::{DVec3, Execution};
use std::hint::black_box;
use std::time::Instant;

fn net(cells: u32) -> Net {
    let number = |i: u32, j: u32| i * (cells + 1) + j;
    let size = 10.0 / f64::from(cells);
    let corners = [number(0, 0), number(0, cells), number(cells, 0), number(cells, cells)];
    let mut net = Net { supports: corners.to_vec(), ..Net::default() };
    for i in 0..=cells {
        for j in 0..=cells {
            let lift = if (i, j) == (0, 0) || (i, j) == (cells, cells) { 5.0 } else { 0.0 };
            net.vertices.push(DVec3::new(size * f64::from(i), size * f64::from(j), lift));
            let mut join = |other: u32, rim: bool| {
                let (force, length) = (rim.then_some(20.0), (!rim).then_some(size));
                net.edges.push(Edge { ends: [number(i, j), other], force, length, ..Edge::default() });
            };
            if i < cells {
                join(number(i + 1, j), j == 0 || j == cells);
            }
            if j < cells {
                join(number(i, j + 1), i == 0 || i == cells);
            }
        }
    }
    // The start is that of the example: force densities that give the target forces, or a force of 1, at the lengths of
    // the lifted grid.
    for edge in &mut net.edges {
        let [a, b] = edge.ends.map(|v| net.vertices[v as usize]);
        edge.density = Some(edge.force.unwrap_or(1.0) / a.distance(b));
    }
    net
}

/// Fits the net to jax_fdm's loss, which is the sum of the mean of (F - 20)² and of the mean of (L - size)². The
/// weights are the squares of the targets, because this solver's loss has the relative deviations (F / 20 - 1)² and
/// (L / size - 1)².
fn fit(net: &Net, size: f64) -> CableNet {
    let options = Options { force_weight: 400.0, length_weight: size * size, least_density: 0.1, ..Options::default() };
    solve(net, &options, &Execution::default()).expect("the net has a shape")
}

fn print_case(cells: u32) {
    let net = net(cells);
    let start = Instant::now();
    let found = fit(&net, 10.0 / f64::from(cells));
    let seconds = start.elapsed().as_secs_f64();
    let range = |rim: bool, values: &[f64]| {
        let of = net.edges.iter().zip(values).filter(|(edge, _)| edge.force.is_some() == rim).map(|(_, value)| *value);
        (of.clone().fold(f64::INFINITY, f64::min), of.fold(0.0, f64::max))
    };
    let (forces, lengths) = (range(true, &found.forces), range(false, &found.lengths));
    println!(
        "{{\"bench\":\"cable_net\",\"cells\":{cells},\"edges\":{},\"seconds\":{seconds:.4},\"iterations\":{},\
         \"loss\":{:.6e},\
         \"force\":[{:.4},{:.4}],\"length\":[{:.4},{:.4}]}}",
        net.edges.len(),
        found.iterations,
        found.loss,
        forces.0,
        forces.1,
        lengths.0,
        lengths.1
    );
}

fn main() {
    let arguments: Vec<String> = std::env::args().collect();
    if let Some(cells) = arguments.iter().position(|argument| argument == "--case").and_then(|k| arguments.get(k + 1)) {
        return print_case(cells.parse().expect("a number of cells"));
    }
    let mut criterion = Criterion::default().configure_from_args().sample_size(10);
    let mut group = criterion.benchmark_group("cable_net");
    for cells in [10, 40] {
        let net = net(cells);
        group.bench_with_input(BenchmarkId::from_parameter(cells), &net, |bencher, net| {
            bencher.iter(|| black_box(fit(net, 10.0 / f64::from(cells))));
        });
    }
    group.finish();
    criterion.final_summary();
}
