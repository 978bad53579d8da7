//! Records the tests, or the parts of tests, that cannot run on this machine. `cargo test` captures what a passing test
//! prints, so that a skip would look like a pass. `scripts/test` counts the lines of the file instead.

use std::fs::OpenOptions;
use std::io::Write as _;

/// Environment variable that names the file of skips.
const FILE: &str = "PLATEAU_SKIPS";

/// Adds the line `what: reason` to the file that `PLATEAU_SKIPS` names, if it is set, and prints it.
///
/// `what` is a key of `tests/allowed-skips.txt`, so that it has no path, number or name of this machine.
///
/// # Panics
/// Panics if the file cannot be written, because the skip would be lost.
pub fn skipped(what: &str, reason: &str) {
    let line = format!("{what}: {reason}\n");
    eprint!("SKIPPED: {line}");
    if let Some(path) = std::env::var_os(FILE) {
        // Several test programs may write at once. A single write at the end of the file keeps each line whole.
        let file = OpenOptions::new().create(true).append(true).open(&path);
        let written = file.and_then(|mut file| file.write_all(line.as_bytes()));
        written.unwrap_or_else(|error| panic!("{FILE}={}: {error}", path.display()));
    }
}
