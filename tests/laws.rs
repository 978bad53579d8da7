//! The laws of docs/ARCHITECTURE.md, kept by looking at the source and the dependency tree.

use std::collections::BTreeSet;
use std::path::{Path, PathBuf};
use std::process::Command;

fn root() -> PathBuf {
    PathBuf::from(env!("CARGO_MANIFEST_DIR"))
}

fn sources(folder: &Path) -> Vec<PathBuf> {
    let mut files = Vec::new();
    let mut folders = vec![folder.to_path_buf()];
    while let Some(folder) = folders.pop() {
        for entry in std::fs::read_dir(&folder).expect("a source folder") {
            let path = entry.expect("an entry").path();
            if path.is_dir() {
                folders.push(path);
            } else if path.extension().is_some_and(|extension| extension == "rs") {
                files.push(path);
            }
        }
    }
    files.sort();
    files
}

/// A file's lines without comments and without what follows its unit tests.
fn code(path: &Path) -> Vec<String> {
    let text = std::fs::read_to_string(path).expect("a source file");
    text.lines()
        .take_while(|line| line.trim() != "#[cfg(test)]")
        .map(|line| line.split("//").next().unwrap_or_default().to_owned())
        .collect()
}

#[test]
fn the_geometry_crate_depends_on_nothing_but_numerics() {
    let output = Command::new(env!("CARGO"))
        .args([
            "tree",
            "--package",
            "plateau-geometry",
            "--edges",
            "normal",
            "--depth",
            "1",
            "--prefix",
            "none",
            "--format",
            "{lib}",
        ])
        .current_dir(root())
        .output()
        .expect("cargo tree runs");
    assert!(output.status.success(), "{}", String::from_utf8_lossy(&output.stderr));
    let found: BTreeSet<String> =
        String::from_utf8_lossy(&output.stdout).split_whitespace().map(str::to_owned).collect();
    let allowed = BTreeSet::from(["plateau_geometry", "faer", "glam", "robust", "spade"].map(str::to_owned));
    let strangers: Vec<_> = found.difference(&allowed).collect();
    assert!(strangers.is_empty(), "the geometry crate may depend on numerics only, not on {strangers:?}");
}

#[test]
fn the_geometry_crate_knows_no_clock_no_thread_and_no_file() {
    let forbidden =
        ["std::time", "std::thread", "std::fs", "std::net", "std::env", "std::io", "HashMap", "HashSet", "println!"];
    for path in sources(&root().join("crates/geometry/src")) {
        for (number, line) in code(&path).iter().enumerate() {
            for word in forbidden {
                let place = format!("{}:{}", path.display(), number + 1);
                assert!(
                    !line.contains(word),
                    "{place}: {word} has no place in the geometry crate (results depend on nothing but arguments)"
                );
            }
        }
    }
}

#[test]
fn only_problem_rs_knows_the_status_codes_of_failures() {
    let successes = ["OK", "ACCEPTED", "NO_CONTENT", "NOT_MODIFIED", "PARTIAL_CONTENT"];
    for path in sources(&root().join("src")) {
        if path.ends_with("http/problem.rs") {
            continue;
        }
        for (number, line) in code(&path).iter().enumerate() {
            for rest in line.split("StatusCode::").skip(1) {
                let name: String = rest.chars().take_while(|c| c.is_ascii_uppercase() || *c == '_').collect();
                let place = format!("{}:{}", path.display(), number + 1);
                assert!(
                    name.is_empty() || successes.contains(&name.as_str()),
                    "{place}: say it with a Failure of http/problem.rs"
                );
            }
        }
    }
}

/// The module that a file of the service belongs to: the first part of its path.
fn module(path: &Path) -> String {
    let relative = path.strip_prefix(root().join("src")).expect("a file of the service");
    let first = relative.components().next().expect("a file name").as_os_str().to_string_lossy();
    first.trim_end_matches(".rs").to_owned()
}

#[test]
fn the_arrows_between_modules_are_the_committed_ones() {
    let mut arrows = BTreeSet::new();
    for path in sources(&root().join("src")) {
        let from = module(&path);
        if matches!(from.as_str(), "lib" | "main") {
            continue;
        }
        for line in code(&path) {
            let targets = line
                .split("crate::")
                .skip(1)
                .map(|rest| rest.chars().take_while(|c| c.is_ascii_alphanumeric() || *c == '_').collect::<String>());
            for to in targets.filter(|to| *to != from && !to.is_empty()) {
                arrows.insert(format!("{from} -> {to}"));
            }
            if line.contains("plateau_geometry") {
                arrows.insert(format!("{from} -> geometry"));
            }
        }
    }
    let found: String = arrows.iter().map(|arrow| format!("{arrow}\n")).collect();
    let committed = std::fs::read_to_string(root().join("tests/arrows.txt")).unwrap_or_default();
    assert!(
        found == committed,
        "the arrows between modules changed. If that is meant, say why in docs/ARCHITECTURE.md and commit tests/arrows.txt as:\n{found}"
    );
}
