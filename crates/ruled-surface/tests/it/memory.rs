//! The memory that a strip takes is below its estimate. A process of its own measures each case, because the peak of a
//! process never falls.

use crate::skips::skipped;
use plateau_mesh::{DVec3, Execution};
use plateau_ruled_surface::{Options, estimate, solve};
use std::process::Command;

/// Environment variable for the measuring process: the number of points of the strip, then `closed` or `normals` or
/// both if the strip has these properties.
const CASE: &str = "PLATEAU_TEST_MEMORY_CASE";

/// Returns the peak of this process's resident memory in bytes.
fn peak() -> Option<u64> {
    let status = std::fs::read_to_string("/proc/self/status").ok()?;
    let line = status.lines().find(|line| line.starts_with("VmHWM:"))?;
    Some(line.split_whitespace().nth(1)?.parse::<u64>().ok()? * 1024)
}

/// Fails if the peak grows by more than the estimate while a strip is solved for all objectives. Does nothing unless
/// the variable [`CASE`] is set.
#[test]
fn a_strip_in_a_process_of_its_own() {
    let Ok(case) = std::env::var(CASE) else { return };
    let points: u32 = case.split(' ').next().and_then(|points| points.parse().ok()).expect("a number of points");
    let (closed, has_normals) = (case.contains("closed"), case.contains("normals"));
    let wave = |height: f64| {
        let at = |k: u32| {
            let t = std::f64::consts::TAU * f64::from(k) / f64::from(points);
            let radius = 3.0 + 0.5 * height * libm::sin(5.0 * t);
            DVec3::new(radius * libm::cos(t), radius * libm::sin(t), height + 0.3 * libm::cos(3.0 * t))
        };
        (0..points).map(at).collect::<Vec<_>>()
    };
    let directrices = [wave(0.5), wave(1.5)];
    let upright = |points: &Vec<DVec3>| vec![DVec3::Z; points.len()];
    let normals = has_normals.then(|| directrices.iter().map(upright).collect());
    let options = Options { all_objectives: true, closed, normals, ..Options::default() };
    let estimate = estimate(&[points as usize; 2], &options).bytes;
    let before = peak();
    let found = solve(&directrices, &options, &Execution::default()).expect("a strip");
    let Some(taken) = peak().zip(before).map(|(after, before)| after - before) else {
        return skipped("memory of a strip", "this system has no /proc/self/status with VmHWM");
    };
    drop(found);
    println!("{taken} bytes of {estimate}");
    assert!(taken <= estimate, "{case}: {taken} bytes of {estimate}");
}

#[test]
fn strips_of_all_objectives_take_less_memory_than_the_estimate() {
    let cases = ["1000 closed normals", "4000 normals", "1000", "4000 closed", "8000"];
    for case in &cases[..if crate::is_full() { cases.len() } else { 2 }] {
        let mut child = Command::new(std::env::current_exe().unwrap());
        child.args(["--exact", "--nocapture", "memory::a_strip_in_a_process_of_its_own"]).env(CASE, case);
        let output = child.output().unwrap();
        let said = String::from_utf8_lossy(&output.stdout);
        println!("{case}: {said}");
        assert!(output.status.success(), "{case}: {}", String::from_utf8_lossy(&output.stderr));
        // A test program that has no test of this name succeeds too.
        assert!(said.contains("1 passed"), "{case}: {said}");
    }
}
