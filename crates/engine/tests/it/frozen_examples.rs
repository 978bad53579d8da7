//! Checks that every example of `api/examples` gives the mesh and the statistics in `tests/frozen_examples.txt` of this
//! crate.
//!
//! The committed file has one row for each example: a hash of the mesh (bits of all coordinates, triangles) and the
//! statistics below with all their digits. Its first line names the instructions of the processor that it was written
//! on, because a fused multiply-add rounds only once. On other machines the solves are skipped, and the skip is
//! recorded. AVX-512 is not among the instructions, because the examples have the same bits with it and without it.
//! Its second line has the revision of the solvers and a digest of the rows, so that rows never change within one
//! revision. If a change is meant to change a row, raise `SOLVER_REVISION` in `crates/engine/src/lib.rs` by one, then
//! write the file again with
//!
//! ```text
//! UPDATE_FROZEN=1 cargo test -p plateau-engine --test it frozen_examples
//! ```
//!
//! and say in the commit message which figures changed and by how much. The test prints these changes. After a
//! conflict in a rebase do the same from the other side's file:
//! `git checkout --ours crates/engine/tests/frozen_examples.txt` takes the file of the branch that is rebased upon.
//!
//! The sines are those of the crate libm, so that the C library of a machine changes nothing. The kernels of faer
//! follow the vector instructions of the processor and round differently on another one.

use crate::skips::skipped;
use crate::{read, root};
use plateau_engine::SOLVER_REVISION;
use plateau_engine::solved::{Signal, Solved};
use serde_json::Value;
use sha2::{Digest, Sha256};
use std::collections::BTreeMap;
use std::path::{Path, PathBuf};

const FILE: &str = "crates/engine/tests/frozen_examples.txt";
const UPDATE: &str = "UPDATE_FROZEN=1 cargo test -p plateau-engine --test it frozen_examples";

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

/// Returns a description of the machine features that results depend on.
fn platform() -> String {
    #[cfg(target_arch = "x86_64")]
    let features = [("avx2", is_x86_feature_detected!("avx2")), ("fma", is_x86_feature_detected!("fma"))];
    #[cfg(not(target_arch = "x86_64"))]
    let features = [("", false); 0];
    let present: Vec<&str> = features.iter().filter(|(_, present)| *present).map(|(name, _)| *name).collect();
    format!("# {} {} {}", std::env::consts::OS, std::env::consts::ARCH, present.join(" "))
}

fn solved(file: &Path) -> Solved {
    let body = std::fs::read(file).expect("an example");
    let name = file.display();
    let accepted = read(&body).unwrap_or_else(|rejection| panic!("{name} is refused: {rejection:?}"));
    let solved = accepted.solve(&|| Signal::Continue, &|_| {});
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

fn digest(rows: &[&str]) -> String {
    let mut hash = Sha256::new();
    rows.iter().for_each(|row| hash.update(format!("{row}\n")));
    hash.finalize().iter().take(12).map(|byte| format!("{byte:02x}")).collect()
}

/// The committed file.
struct Frozen<'a> {
    /// The machine features that the rows were written with.
    platform: &'a str,
    /// The revision of the solvers that gave the rows.
    revision: u32,
    rows: Vec<&'a str>,
}

impl<'a> Frozen<'a> {
    /// Fails if the file is damaged or its rows were changed without its digest.
    fn read(text: &'a str) -> Result<Self, String> {
        let mut lines = text.lines();
        let platform = lines.next().unwrap_or_default();
        let second = lines.next().unwrap_or_default();
        let rows: Vec<&str> = lines.collect();
        let revision = second.strip_prefix("# revision ").and_then(|rest| rest.split_once(" of the solvers, rows "));
        match revision.and_then(|(revision, given)| Some((revision.parse().ok()?, given == digest(&rows)))) {
            Some((revision, true)) => Ok(Self { platform, revision, rows }),
            _ => Err(format!(
                "{FILE} was edited or merged by hand: {second:?} does not fit its rows. Take the committed file of the \
                 main branch, and write it again with {UPDATE}"
            )),
        }
    }

    /// Returns the text of the file with the rows of this revision. Fails if the rows changed, but the revision did
    /// not.
    fn written(&self, platform: &str, revision: u32, rows: &[&str]) -> Result<String, String> {
        if revision < self.revision || (revision == self.revision && rows != self.rows) {
            return Err(format!(
                "the results changed, so kept results must not be reused: raise SOLVER_REVISION in \
                 crates/engine/src/lib.rs to {}, then run {UPDATE}",
                self.revision + 1
            ));
        }
        let header = format!("{platform}\n# revision {revision} of the solvers, rows {}\n", digest(rows));
        Ok(rows.iter().fold(header, |text, row| text + row + "\n"))
    }
}

fn committed() -> String {
    std::fs::read_to_string(root().join(FILE)).expect("the committed file")
}

#[test]
fn the_rows_change_only_with_the_revision_of_the_solvers() {
    if std::env::var_os("UPDATE_FROZEN").is_some() {
        return;
    }
    let text = committed();
    let frozen = Frozen::read(&text).unwrap_or_else(|error| panic!("{error}"));
    assert_eq!(
        frozen.revision, SOLVER_REVISION,
        "{FILE} is of another revision than SOLVER_REVISION in crates/engine/src/lib.rs; write it again with {UPDATE}"
    );
}

#[test]
fn every_example_gives_the_committed_mesh_and_statistics() {
    let text = committed();
    let frozen = Frozen::read(&text).unwrap_or_else(|error| panic!("{error}"));
    let update = std::env::var_os("UPDATE_FROZEN").is_some();
    if frozen.platform != platform() && !update {
        let reason = format!("written on {:?}, this machine is {:?}", frozen.platform, platform());
        skipped("frozen examples", &reason);
        return;
    }
    let before: BTreeMap<&str, &str> =
        frozen.rows.iter().filter_map(|row| row.split_once(' ').map(|(name, _)| (name, *row))).collect();
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
    let moved = moved.join("\n");
    if update {
        println!("{moved}");
        let rows: Vec<&str> = now.values().map(String::as_str).collect();
        let text = frozen.written(&platform(), SOLVER_REVISION, &rows).unwrap_or_else(|error| panic!("{error}"));
        std::fs::write(root().join(FILE), text).expect("the file can be written");
        return;
    }
    assert!(
        moved.is_empty(),
        "results changed; if that is intended, raise SOLVER_REVISION in crates/engine/src/lib.rs, run {UPDATE} and give \
         the changes in the commit message:\n{moved}"
    );
}

#[test]
fn rows_are_not_written_again_within_one_revision() {
    let text =
        format!("# machine\n# revision 3 of the solvers, rows {}\nrings area=2.0\n", digest(&["rings area=2.0"]));
    let frozen = Frozen::read(&text).unwrap();
    let changed = ["rings area=2.5"];
    assert!(
        frozen
            .written("# machine", 3, &changed)
            .unwrap_err()
            .contains("raise SOLVER_REVISION in crates/engine/src/lib.rs to 4")
    );
    assert!(frozen.written("# machine", 2, &frozen.rows).is_err());
    assert_eq!(frozen.written("# machine", 3, &frozen.rows).unwrap(), text);
    let written = frozen.written("# machine", 4, &changed).unwrap();
    let again = Frozen::read(&written).unwrap();
    assert_eq!((again.revision, &again.rows[..]), (4, &changed[..]));
    assert!(Frozen::read(&text.replace("2.0", "2.5")).is_err(), "edited rows");
    assert!(Frozen::read(&text.replace("revision 3", "revision")).is_err(), "no revision");
    assert!(Frozen::read("").is_err(), "an empty file");
}

#[test]
fn a_changed_figure_is_reported_with_its_relative_change() {
    let before = "rings mesh=00aa area=2.0 converged=true";
    assert_eq!(differences(before, before), Vec::<String>::new());
    let now = "rings mesh=00ab area=2.5 converged=true stop_reason=residual";
    let expected = ["area: 2.0 -> 2.5 (+2.5e-1)", "mesh: 00aa -> 00ab", "stop_reason: nothing -> residual"];
    assert_eq!(differences(before, now), expected);
}
