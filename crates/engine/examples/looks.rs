//! Prints the longest processor times between two checks of the cancel signal by a solver, and the place of the second
//! check. A cancel takes at most as long as the longest of them. The arguments are a file with a request that names its
//! kind, and the number of triangles to ask for.

#![allow(
    clippy::disallowed_macros,
    clippy::disallowed_methods,
    clippy::disallowed_types,
    clippy::too_many_lines,
    reason = "an example"
)]

use plateau_engine::limits::Limits;
use plateau_engine::request::Request;
use plateau_engine::solved::Signal;
use std::backtrace::Backtrace;
use std::cell::{Cell, RefCell};
use std::collections::BTreeMap;
use std::time::Duration;

/// Pauses up to this length are not printed.
const SHORT: Duration = Duration::from_millis(50);

/// Returns the processor time of this thread, which does not depend on what else the machine does.
fn now() -> Duration {
    let text = std::fs::read_to_string("/proc/thread-self/schedstat").expect("Linux");
    Duration::from_nanos(text.split(' ').next().expect("a number").parse().expect("a number"))
}

fn main() {
    let mut arguments = std::env::args().skip(1);
    let file = arguments.next().expect("a file");
    let mut value: serde_json::Value = serde_json::from_slice(&std::fs::read(&file).expect("a file")).expect("JSON");
    if let Some(triangles) = arguments.next() {
        value["resolution"] = serde_json::json!({ "triangles": triangles.parse::<u32>().expect("a number") });
    }
    let limits = Limits {
        points: 1_000_000,
        triangles: 4_000_000,
        grid_cells: 100_000_000,
        iterations: 100_000,
        memory_bytes: 16 << 30,
    };
    let request = Request::read_with_kind(&value, &plateau_engine::source::no_jobs, &limits).expect("valid").request;
    let begun = now();
    let last = Cell::new(begun);
    let phase = RefCell::new(String::new());
    let pauses = RefCell::new(BTreeMap::<String, (usize, Duration)>::new());
    let note = |pause: Duration| {
        let trace = Backtrace::force_capture().to_string();
        let lines: Vec<&str> = trace.lines().map(str::trim).filter(|line| line.contains("crates/")).collect();
        let places: Vec<&str> =
            lines.iter().filter_map(|line| line.rsplit_once("crates/")).map(|(_, place)| place).collect();
        let key = format!("{} {}", phase.borrow(), places.get(2..9.min(places.len())).unwrap_or_default().join(" < "));
        let mut pauses = pauses.borrow_mut();
        let entry = pauses.entry(key).or_default();
        *entry = (entry.0 + 1, entry.1.max(pause));
    };
    let signal = || {
        let pause = now() - last.get();
        if pause > SHORT {
            note(pause);
        }
        last.set(now());
        Signal::Continue
    };
    let solved = request.solve(&signal, &|progress| drop(phase.replace(progress.phase)));
    println!("{} {:.1} s, after the last look {:?}", file, (now() - begun).as_secs_f64(), (now() - last.get()));
    drop(solved);
    let mut longest: Vec<_> = pauses.take().into_iter().collect();
    longest.sort_by_key(|(_, (_, pause))| std::cmp::Reverse(*pause));
    for (place, (count, pause)) in longest {
        println!("{pause:>9.0?} × {count:<4} {place}");
    }
}
