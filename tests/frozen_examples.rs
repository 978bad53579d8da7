//! Checks that every example of `api/examples` gives the mesh and the statistics in `tests/frozen_examples.txt`.
//!
//! The committed file has one line for each example: a hash of the mesh (bits of all coordinates, triangles) and the
//! statistics below with all their digits. If a change is meant to change a line, write the file again with
//!
//! ```text
//! UPDATE_FROZEN=1 cargo test --test frozen_examples
//! ```
//!
//! and say in the commit message which figures changed and by how much. The test prints these changes.
//!
//! Results depend on the instructions of the processor, because a fused multiply-add rounds only once. The file's first
//! line names them. On other machines the test is skipped with a printed reason. A new C library may change the last
//! digits of sines and cosines, and thereby whole lines. In that case write the file again in a separate commit.

use plateau::config::LimitsConfig;
use plateau::jobs::progress::Signal;
use plateau::jobs::solve::{Solved, solve};
use plateau::wire::Request;
use serde_json::Value;
use sha2::{Digest, Sha256};
use std::collections::BTreeMap;
use std::path::{Path, PathBuf};

/// Statistics (JSON Pointers) that a line has if the example's kind has them.
const STATISTICS: [&str; 40] = [
    "/vertices",
    "/nodes",
    "/triangles",
    "/objective_value",
    "/secondary_value",
    "/area",
    "/residual",
    "/residual_full",
    "/converged",
    "/stop_reason",
    "/iterations",
    "/edges_swapped",
    "/components",
    "/euler_characteristic",
    "/stability/morse_index",
    "/stability/lowest_eigenvalue",
    "/extrapolated_area/area",
    "/mean_curvature/max",
    "/mean_curvature/rms",
    "/edge_lengths/mean",
    "/edge_lengths/std_dev",
    "/angles_deg/min",
    "/angles_deg/max",
    "/flipped_triangles",
    "/degenerate_triangles",
    "/junctions/residual",
    "/junctions/length",
    "/junctions/largest_deviation_deg",
    "/junctions/largest_deviation_at_ends_deg",
    "/junctions/mean_deviation_deg",
    "/junctions/morse_index",
    "/total_normal_twist",
    "/bending_energy",
    "/mean_curvature_variation",
    "/normal_variation",
    "/convex_bridges",
    "/flat_pattern/edge_length_error_max",
    "/equal_edges",
    "/distinct_lengths",
    "/lattice_edges/std_dev",
];

fn root() -> PathBuf {
    PathBuf::from(env!("CARGO_MANIFEST_DIR"))
}

/// Returns a description of the machine features that results depend on.
fn platform() -> String {
    #[cfg(target_arch = "x86_64")]
    let features = [
        ("avx2", is_x86_feature_detected!("avx2")),
        ("fma", is_x86_feature_detected!("fma")),
        ("avx512f", is_x86_feature_detected!("avx512f")),
    ];
    #[cfg(not(target_arch = "x86_64"))]
    let features = [("", false); 0];
    let present: Vec<&str> = features.iter().filter(|(_, present)| *present).map(|(name, _)| *name).collect();
    format!("# {} {} {}", std::env::consts::OS, std::env::consts::ARCH, present.join(" "))
}

fn solved(file: &Path) -> Solved {
    let body = std::fs::read(file).expect("an example");
    let name = file.display();
    let request = Request::read_with_kind(&body, &LimitsConfig::default())
        .unwrap_or_else(|rejection| panic!("{name} is refused: {rejection:?}"));
    let solved = solve(&request, &|| Signal::Continue, &|_| {});
    solved.unwrap_or_else(|unsolved| panic!("{name} fails: {unsolved:?}"))
}

/// Returns the `key=value` pairs of one example.
fn figures(solved: &Solved) -> Vec<(String, String)> {
    let mesh = &solved.archive.contents().mesh;
    let mut hash = Sha256::new();
    mesh.vertices.iter().flat_map(|p| p.to_array()).for_each(|c| hash.update(c.to_bits().to_le_bytes()));
    mesh.triangles.iter().flatten().for_each(|v| hash.update(v.to_le_bytes()));
    let digest: String = hash.finalize().iter().take(12).map(|byte| format!("{byte:02x}")).collect();
    let statistics: Value = serde_json::from_str(&solved.statistics).expect("statistics are JSON");
    let known = STATISTICS.iter().filter_map(|pointer| {
        let value = statistics.pointer(pointer).filter(|value| !value.is_null())?;
        Some(((*pointer)[1..].to_owned(), value.to_string().replace('"', "")))
    });
    std::iter::once(("mesh".to_owned(), digest)).chain(known).collect()
}

fn line(name: &str, figures: &[(String, String)]) -> String {
    let pairs: Vec<String> = figures.iter().map(|(key, value)| format!("{key}={value}")).collect();
    format!("{name} {}", pairs.join(" "))
}

/// Returns the differences between two lines of one example, by key, with the relative change of numbers.
fn differences(before: &str, now: &str) -> Vec<String> {
    let pairs = |line: &str| -> BTreeMap<String, String> {
        line.split(' ').skip(1).filter_map(|pair| pair.split_once('=')).map(|(k, v)| (k.into(), v.into())).collect()
    };
    let (before, now) = (pairs(before), pairs(now));
    let mut keys: Vec<&String> = before.keys().chain(now.keys()).collect();
    keys.sort();
    keys.dedup();
    let text = |value: Option<&String>| value.cloned().unwrap_or_else(|| "nothing".into());
    let differing = keys.into_iter().filter(|key| before.get(*key) != now.get(*key));
    differing
        .map(|key| {
            let (old, new) = (text(before.get(key)), text(now.get(key)));
            let relative = match (old.parse::<f64>(), new.parse::<f64>()) {
                (Ok(old), Ok(new)) if key != "mesh" => {
                    format!(" ({:+.1e})", (new - old) / old.abs().max(f64::MIN_POSITIVE))
                }
                _ => String::new(),
            };
            format!("{key}: {old} -> {new}{relative}")
        })
        .collect()
}

#[test]
fn every_example_gives_the_committed_mesh_and_statistics() {
    let golden = root().join("tests/frozen_examples.txt");
    let committed = std::fs::read_to_string(&golden).unwrap_or_default();
    let update = std::env::var_os("UPDATE_FROZEN").is_some();
    let mut lines = committed.lines();
    let written_on = lines.next().unwrap_or_default();
    if written_on != platform() && !update {
        println!("SKIPPED: frozen examples: written on \"{written_on}\", this machine is \"{}\"", platform());
        return;
    }
    let before: BTreeMap<&str, &str> =
        lines.filter_map(|line| line.split_once(' ').map(|(name, _)| (name, line))).collect();
    let mut files: Vec<PathBuf> = std::fs::read_dir(root().join("api/examples"))
        .expect("the folder of examples")
        .map(|entry| entry.expect("an entry").path())
        .collect();
    files.sort();
    let mut now = BTreeMap::new();
    for file in &files {
        let name = file.file_stem().expect("a file name").to_string_lossy().into_owned();
        now.insert(name.clone(), line(&name, &figures(&solved(file))));
    }
    let mut moved = Vec::new();
    for (name, line) in &now {
        match before.get(name.as_str()) {
            None => moved.push(format!("{name}: not in the file yet")),
            Some(old) if old != line => {
                let changes = differences(old, line);
                moved.push(format!("{name}:\n    {}", changes.join("\n    ")));
            }
            Some(_) => {}
        }
    }
    moved.extend(before.keys().filter(|name| !now.contains_key(**name)).map(|name| format!("{name}: example is gone")));
    if update {
        let text: String =
            std::iter::once(platform()).chain(now.into_values()).map(|line| format!("{line}\n")).collect();
        std::fs::write(&golden, text).expect("the file can be written");
        println!("{}", moved.join("\n"));
        return;
    }
    assert!(
        moved.is_empty(),
        "results changed; if that is intended, run UPDATE_FROZEN=1 cargo test --test frozen_examples and give the changes in the commit message:\n{}",
        moved.join("\n")
    );
}

#[test]
fn a_changed_figure_is_reported_with_its_relative_change() {
    let before = "rings mesh=00aa area=2.0 converged=true";
    assert_eq!(differences(before, before), Vec::<String>::new());
    let now = "rings mesh=00ab area=2.5 converged=true stop_reason=residual";
    let expected = ["area: 2.0 -> 2.5 (+2.5e-1)", "mesh: 00aa -> 00ab", "stop_reason: nothing -> residual"];
    assert_eq!(differences(before, now), expected);
}
