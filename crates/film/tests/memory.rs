//! The memory that form finding takes must be below its estimate. Each case is measured in a process of its own,
//! because the peak memory of a process never falls.

#![allow(clippy::disallowed_macros, clippy::disallowed_methods, reason = "this is a test")]

use plateau_film::cable_net::{Edge, Net, Options, estimate, solve};
use plateau_mesh::{DVec3, Execution};
use std::process::Command;

/// Environment variable that names the case for the process to measure.
const CASE: &str = "PLATEAU_TEST_MEMORY_CASE";

/// Returns the peak of this process's resident memory in bytes.
fn peak() -> Option<u64> {
    let status = std::fs::read_to_string("/proc/self/status").ok()?;
    let line = status.lines().find(|line| line.starts_with("VmHWM:"))?;
    Some(line.split_whitespace().nth(1)?.parse::<u64>().ok()? * 1024)
}

/// The nets of the cases, by name. All forces have the same target.
fn net(name: &str) -> Net {
    let (columns, rows, layers): (u32, u32, u32) = match name {
        "squares" => (100, 100, 1),
        "bricks" => (115, 115, 1),
        "space" => (20, 20, 20),
        _ => panic!("no net is called {name}"),
    };
    // In a wall of bricks every second vertical edge is missing, so that a vertex has three edges.
    let is_joined = |i: u32, j: u32, axis: u32| name != "bricks" || axis != 1 || (i + j).is_multiple_of(2);
    let mut net = Net::default();
    let number = |i: u32, j: u32, k: u32| (k * rows + j) * columns + i;
    for k in 0..layers {
        for j in 0..rows {
            for i in 0..columns {
                let own = number(i, j, k);
                let wave = 0.3 * f64::from(i * 7 % 5) + 0.2 * f64::from(j * 3 % 7);
                net.vertices.push(DVec3::new(f64::from(i), f64::from(j), f64::from(k) + wave));
                if [(i, columns), (j, rows)].iter().any(|&(at, count)| at == 0 || at + 1 == count) {
                    net.supports.push(own);
                }
                let others = [(i + 1 < columns, 1), (j + 1 < rows, columns), (k + 1 < layers, columns * rows)];
                for (axis, (inside, step)) in (0u32..).zip(others) {
                    if inside && is_joined(i, j, axis) {
                        net.edges.push(Edge { ends: [own, own + step], force: Some(1.0), ..Edge::default() });
                    }
                }
            }
        }
    }
    net
}

/// Measures how much the peak grows while a net is solved, and compares it with the estimate. Does nothing unless the
/// environment names a case.
#[test]
fn a_net_in_a_process_of_its_own() {
    let Ok(name) = std::env::var(CASE) else { return };
    let net = net(&name);
    let options = Options { max_iterations: Some(3), least_density: 1e-6, ..Options::default() };
    let before = peak();
    solve(&net, &options, &Execution::default()).expect("a net");
    let taken = peak().zip(before).map(|(after, before)| after - before);
    println!("{} edges, {} vertices: {taken:?} of {}", net.edges.len(), net.vertices.len(), estimate(&net).bytes);
    if let Some(taken) = taken {
        let per_edge = taken / net.edges.len() as u64;
        println!("{per_edge} bytes per edge");
        assert!(taken <= estimate(&net).bytes, "{name}: {taken} bytes, {per_edge} per edge");
    }
}

#[test]
fn a_net_takes_less_memory_than_its_estimate() {
    for name in ["squares", "bricks", "space"] {
        let this_test = std::env::current_exe().unwrap();
        let mut child = Command::new(this_test);
        child.args(["--exact", "--nocapture", "a_net_in_a_process_of_its_own"]).env(CASE, name);
        let output = child.output().unwrap();
        println!("{name}: {}", String::from_utf8_lossy(&output.stdout));
        assert!(output.status.success(), "{name}: {}", String::from_utf8_lossy(&output.stderr));
    }
}
