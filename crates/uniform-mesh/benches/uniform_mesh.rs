//! Compares the time to make uniform meshes of a square with the time of spade, a Delaunay triangulation. Our solver
//! makes 1,000 to 1,000,000 nodes and measures the mesh. Spade is given these nodes and only triangulates them. Both
//! run on one core.
//!
//! `cargo bench -p plateau-uniform-mesh --bench uniform_mesh` measures with criterion. With `-- --record` it prints one
//! JSON line per case for `benches/results.jsonl` instead (the fastest of several runs; `ratio` is relative to spade's
//! time in the same run). With `-- --case OBJECTIVE NODES` it makes one mesh and prints its number of nodes;
//! `benches/uniform_mesh_peers.py` compares the processor time of this with Triangle's.

#![allow(
    clippy::disallowed_macros,
    clippy::disallowed_methods,
    clippy::disallowed_types,
    clippy::too_many_lines,
    reason = "a benchmark"
)]

use criterion::{BenchmarkId, Criterion};
use plateau_mesh::{DVec3, Execution};
use plateau_uniform_mesh::{Domain, Objective, Options, UniformMesh, solve};
use spade::{DelaunayTriangulation, Point2, Triangulation};
use std::hint::black_box;
use std::time::Instant;

/// Returns a square whose mesh with the target edge length 1 has about `nodes` nodes. The densities, in nodes per unit
/// of area, are measured.
fn square(nodes: usize, objective: Objective) -> Domain {
    let density = match objective {
        Objective::FewestNodes => 0.68,
        Objective::MostEqualEdges => 1.155,
    };
    let side = (nodes as f64 / density).sqrt();
    let outer = [[0.0, 0.0], [side, 0.0], [side, side], [0.0, side]].map(|[x, y]| DVec3::new(x, y, 0.0));
    Domain::Polygon { outer: outer.to_vec(), holes: Vec::new() }
}

fn mesh(domain: &Domain, objective: Objective) -> UniformMesh {
    solve(domain, &Options::new(1.0, objective), &Execution::default()).expect("a square can be meshed")
}

fn delaunay(points: Vec<Point2<f64>>) -> usize {
    let triangulation = DelaunayTriangulation::<Point2<f64>>::bulk_load(points).expect("a mesh's nodes are finite");
    triangulation.num_inner_faces()
}

/// The time of the fastest run, in seconds.
fn fastest<R>(runs: usize, mut work: impl FnMut() -> R) -> f64 {
    let once = |_| {
        let start = Instant::now();
        black_box(work());
        start.elapsed().as_secs_f64()
    };
    (0..runs).map(once).fold(f64::INFINITY, f64::min)
}

fn record() {
    for nodes in [1_000, 10_000, 100_000, 1_000_000] {
        for objective in Objective::ALL {
            let domain = square(nodes, objective);
            let runs = (300_000 / nodes).clamp(2, 20);
            let result = mesh(&domain, objective);
            let seconds = fastest(runs, || mesh(&domain, objective));
            let points: Vec<Point2<f64>> = result.mesh.vertices.iter().map(|p| Point2::new(p.x, p.y)).collect();
            let baseline = fastest(runs, || delaunay(points.clone()));
            println!(
                "{{\"bench\":\"uniform_mesh/{}\",\"nodes\":{},\"seconds\":{seconds:.4},\
                 \"baseline\":\"spade bulk load of the same \
                 nodes\",\"baseline_seconds\":{baseline:.4},\"ratio\":{:.3}}}",
                objective.name(),
                points.len(),
                seconds / baseline
            );
        }
    }
}

fn main() {
    let arguments: Vec<String> = std::env::args().collect();
    if let Some(k) = arguments.iter().position(|argument| argument == "--case") {
        let objective = Objective::ALL.into_iter().find(|o| arguments.get(k + 1).is_some_and(|name| name == o.name()));
        let nodes = arguments.get(k + 2).and_then(|nodes| nodes.parse().ok());
        let (Some(objective), Some(nodes)) = (objective, nodes) else {
            eprintln!("--case OBJECTIVE NODES");
            std::process::exit(2);
        };
        println!("{}", mesh(&square(nodes, objective), objective).statistics.nodes);
        return;
    }
    if std::env::args().any(|argument| argument == "--record") {
        return record();
    }
    let mut criterion = Criterion::default().configure_from_args();
    // `--test` only checks that every case runs, so small cases suffice.
    let sizes: &[usize] = if std::env::args().any(|argument| argument == "--test") {
        &[300]
    } else {
        &[1_000, 10_000, 100_000, 1_000_000]
    };
    let mut group = criterion.benchmark_group("uniform_mesh");
    group.sample_size(10);
    for &nodes in sizes {
        for objective in Objective::ALL {
            let domain = square(nodes, objective);
            let id = BenchmarkId::new(objective.name(), nodes);
            group.bench_with_input(id, &domain, |bench, domain| bench.iter(|| mesh(domain, objective)));
        }
    }
    group.finish();
    criterion.final_summary();
}
