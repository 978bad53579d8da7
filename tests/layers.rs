//! Checks the arrows of the workspace: no crate uses a later crate, no file uses a later layer of its crate, no files
//! form a circle, and no module re-exports items of another module.
//!
//! The test reads the source. It takes every `use` declaration (grouped and nested ones too) and every path in the code
//! that starts with `crate::`, `super::`, `self::` or the name of a child module. Each names a file; that is an *arrow*
//! from the file in which it stands. A path that ends in a re-exported item leads to the file that defines the item.
//!
//! A re-export of a module's own descendants is its table of contents and no arrow. Items under `#[cfg(test)]` are not
//! read.

mod source;

use source::{Token, tokens_without_tests, word};
use std::collections::{BTreeMap, BTreeSet};
use std::path::{Path, PathBuf};

/// The crates in their order, and the files and folders of each, earliest layer first. A file belongs to the longest
/// entry that its path starts with. In a crate without entries only circles are faults.
const CRATES: [(&str, &[&str]); 13] = [
    (
        "mesh",
        &[
            "execution",
            "codes",
            "error",
            "estimate",
            "random",
            "order",
            "disjoint_sets",
            "lib",
            "axis_box",
            "polyline",
            "topology",
            "measure",
            "check",
            "complex",
            "edit",
            "cut",
            "film",
            "structured",
            "self_intersections",
            "crossing",
            "sparse",
            "plane",
            "remesh",
        ],
    ),
    (
        "equilibrium",
        &[
            "energy",
            "dense",
            "freedom",
            "support",
            "contact",
            "constraint",
            "body",
            "newton",
            "residual",
            "motion",
            "normal_motion",
            "v_cycle",
            "stability",
            "relax",
            "settling",
            "form_finding",
            "lib",
        ],
    ),
    (
        "minimal-surface",
        &[
            "options",
            "cone",
            "estimate",
            "initial_mesh/first_point",
            "request",
            "run",
            "curvature",
            "extrapolation",
            "harmonic",
            "initial_mesh",
            "kept_film",
            "solved_film",
            "touching_boundaries",
            "solvers",
            "drivers",
            "junction_statistics",
            "statistics",
            "outcome",
            "triple_junction",
            "lib",
        ],
    ),
    (
        "tensile-structure",
        &[
            "options",
            "checks",
            "catenary",
            "weave",
            "mixing",
            "model",
            "remeshing",
            "taut_start",
            "form_finding",
            "travel",
            "ponding",
            "shape",
            "stress",
            "reactions",
            "warnings",
            "outcome",
            "lib",
        ],
    ),
    ("cable-net", &["options", "shape", "loss", "step", "fitted", "fitting", "struts", "lib"]),
    ("ruled-surface", &["graph", "strip", "pattern", "stack", "lib"]),
    ("uniform-mesh", &[]),
    ("lower-bound", &[]),
    ("opennurbs", &[]),
    ("archive", &[]),
    (
        "forms",
        &[
            "rejection",
            "limits",
            "json",
            "bounds",
            "strict",
            "common",
            "resolution",
            "explain",
            "report",
            "mesh",
            "audit",
            "solved",
            "source",
            "checked",
            "blocks",
            "kind",
            "kinds",
            "components",
            "schema",
            "request",
            "lib",
        ],
    ),
    ("page", &[]),
    (SERVICE, &[]),
];

/// Name of the service in the list of crates. Its source is the folder `src` beside the crates.
const SERVICE: &str = "plateau";

/// A file of the crate: its path below `src` without `.rs`, and its text.
struct Source {
    path: String,
    text: String,
}

/// An arrow from one file to another that it uses.
type Arrow = (String, String);

/// A path of a `use` declaration: its segments, the name that it is bound to, and whether the declaration re-exports
/// it.
#[derive(Clone, Debug, PartialEq)]
struct Use {
    path: Vec<String>,
    name: String,
    exported: bool,
}

/// Reads a use tree from `at`; returns where it ends.
fn use_tree(tokens: &[Token], mut at: usize, prefix: &[String], exported: bool, uses: &mut Vec<Use>) -> usize {
    let mut path = prefix.to_vec();
    loop {
        match tokens.get(at) {
            Some(Token::Word(segment)) => {
                path.push(segment.clone());
                at += 1;
            }
            Some(Token::PathSeparator) => at += 1,
            Some(Token::Mark('*')) => {
                path.push("*".into());
                at += 1;
            }
            Some(Token::Mark('{')) => {
                at += 1;
                while tokens.get(at) != Some(&Token::Mark('}')) && at < tokens.len() {
                    at = use_tree(tokens, at, &path, exported, uses);
                    if tokens.get(at) == Some(&Token::Mark(',')) {
                        at += 1;
                    }
                }
                return at + 1;
            }
            _ => break,
        }
        if word(tokens.get(at)) == Some("as") {
            let name = word(tokens.get(at + 1)).unwrap_or("_").to_owned();
            uses.push(Use { path, name, exported });
            return at + 2;
        }
    }
    if path.len() > 1 && path.last().is_some_and(|last| last == "self") {
        path.pop();
    }
    if let Some(name) = path.last().cloned() {
        uses.push(Use { path, name, exported });
    }
    at
}

/// Contents of a file: its use declarations, the paths in its code, its child modules.
#[derive(Debug, Default)]
struct Contents {
    uses: Vec<Use>,
    paths: Vec<Vec<String>>,
    children: BTreeSet<String>,
    test_children: Vec<String>,
}

fn read(text: &str) -> Contents {
    let (tokens, test_children) = tokens_without_tests(text);
    let mut contents = Contents { test_children, ..Contents::default() };
    let mut at = 0;
    while at < tokens.len() {
        match word(tokens.get(at)) {
            Some("use") => {
                let before = &tokens[at.saturating_sub(4)..at];
                let exported = word(tokens.get(at.wrapping_sub(1))) == Some("pub")
                    || (before.len() == 4 && word(before.first()) == Some("pub") && before[3] == Token::Mark(')'));
                at = use_tree(&tokens, at + 1, &[], exported, &mut contents.uses);
            }
            Some("mod") if tokens.get(at + 2) == Some(&Token::Mark(';')) => {
                contents.children.extend(word(tokens.get(at + 1)).map(str::to_owned));
                at += 2;
            }
            // The path of a visibility, `pub(in …)`, uses nothing.
            Some("in") if at > 1 && word(tokens.get(at - 2)) == Some("pub") => {
                at += tokens[at..].iter().take_while(|token| **token != Token::Mark(')')).count();
            }
            Some(first) if tokens.get(at + 1) == Some(&Token::PathSeparator) => {
                let mut path = vec![first.to_owned()];
                while tokens.get(at + 1) == Some(&Token::PathSeparator) {
                    let Some(segment) = word(tokens.get(at + 2)) else { break };
                    path.push(segment.to_owned());
                    at += 2;
                }
                // The path is read up to its last segment, so `a::b` inside `x::a::b` is not read as a path of its own.
                contents.paths.push(path);
                at += 1;
            }
            _ => at += 1,
        }
    }
    contents
}

/// The crate's modules: the contents of each file, by the segments of the module's path.
struct Modules {
    files: BTreeMap<Vec<String>, Contents>,
}

impl Modules {
    fn read(sources: &[Source]) -> Self {
        let segments = |path: &str| -> Vec<String> {
            if path == "lib" { Vec::new() } else { path.split('/').map(str::to_owned).collect() }
        };
        let mut files: BTreeMap<Vec<String>, Contents> =
            sources.iter().map(|source| (segments(&source.path), read(&source.text))).collect();
        // Files of test modules are tests.
        let tests: Vec<Vec<String>> = files
            .iter()
            .flat_map(|(path, contents)| {
                contents
                    .test_children
                    .iter()
                    .map(|child| [&path[..], std::slice::from_ref(child)].concat())
                    .collect::<Vec<_>>()
            })
            .collect();
        files.retain(|path, _| !tests.iter().any(|test| path.starts_with(test)));
        Self { files }
    }

    /// The module whose file defines what `path` names in the module `from`; `None` outside of the crate.
    fn resolve(&self, from: &[String], path: &[String], depth: usize) -> Option<Vec<String>> {
        let mut module = from.to_vec();
        let mut rest = path;
        match rest.first().map(String::as_str) {
            Some("crate") => {
                module.clear();
                rest = &rest[1..];
            }
            Some("self") => rest = &rest[1..],
            Some("super") => {
                while rest.first().is_some_and(|segment| segment == "super") {
                    module.pop();
                    rest = &rest[1..];
                }
            }
            Some(first) if self.files.get(from)?.children.contains(first) => {}
            _ => return None,
        }
        while let Some(segment) = rest.first() {
            let child = [&module[..], std::slice::from_ref(segment)].concat();
            if self.files.contains_key(&child) {
                module = child;
                rest = &rest[1..];
                continue;
            }
            // An item: defined here, or re-exported.
            let found = self.files.get(&module)?.uses.iter().find(|u| u.name == *segment && u.exported);
            if let Some(export) = found.filter(|_| depth < 8) {
                let path = [&export.path[..], &rest[1..]].concat();
                return self.resolve(&module, &path, depth + 1);
            }
            break;
        }
        Some(module)
    }
}

/// Every arrow between two files of the crate.
fn arrows(sources: &[Source]) -> BTreeSet<Arrow> {
    let modules = Modules::read(sources);
    let name = |module: &[String]| if module.is_empty() { "lib".to_owned() } else { module.join("/") };
    let mut arrows = BTreeSet::new();
    for (from, contents) in &modules.files {
        let used = contents.uses.iter().map(|u| (&u.path, u.exported));
        for (path, exported) in used.chain(contents.paths.iter().map(|path| (path, false))) {
            let Some(to) = modules.resolve(from, path, 0) else { continue };
            let own = to.starts_with(from);
            if to != *from && !(own && exported) {
                arrows.insert((name(from), name(&to)));
            }
        }
    }
    arrows
}

/// Re-exports of items that belong to another module of the crate or to another crate of the workspace. They hide an
/// arrow from readers. A module may re-export its own descendants.
fn foreign_re_exports(sources: &[Source]) -> Vec<String> {
    let modules = Modules::read(sources);
    let mut found = Vec::new();
    for (from, contents) in &modules.files {
        for exported in contents.uses.iter().filter(|u| u.exported) {
            let foreign = match modules.resolve(from, &exported.path, 0) {
                Some(to) => !to.starts_with(from),
                None => exported.path[0].starts_with("plateau_"),
            };
            if foreign {
                found.push(format!("{} re-exports {}", from.join("/"), exported.path.join("::")));
            }
        }
    }
    found
}

/// Imports of crates of the workspace that do not stand before `name` in `order`.
fn against_the_order(name: &str, order: &[&str], sources: &[Source]) -> Vec<String> {
    let earlier: BTreeSet<String> = order
        .iter()
        .take_while(|earlier| **earlier != name)
        .map(|earlier| format!("plateau_{}", earlier.replace('-', "_")))
        .collect();
    let modules = Modules::read(sources);
    let mut found = BTreeSet::new();
    for (file, contents) in &modules.files {
        let first = contents.uses.iter().map(|u| &u.path[0]).chain(contents.paths.iter().map(|path| &path[0]));
        for library in first.filter(|first| first.starts_with("plateau_") && !earlier.contains(*first)) {
            found.insert(format!("{} uses {library}, which does not stand before {name}", file.join("/")));
        }
    }
    found.into_iter().collect()
}

/// Returns the sets of files that reach each other by arrows. Each set is a circle, or several circles with common
/// files.
fn circles(arrows: &BTreeSet<Arrow>) -> Vec<Vec<String>> {
    let files: BTreeSet<&String> = arrows.iter().flat_map(|(from, to)| [from, to]).collect();
    let reached = |from: &String| {
        let mut seen = BTreeSet::new();
        let mut stack = vec![from.clone()];
        while let Some(file) = stack.pop() {
            for (_, to) in arrows.range((file.clone(), String::new())..).take_while(|(source, _)| *source == file) {
                if seen.insert(to.clone()) {
                    stack.push(to.clone());
                }
            }
        }
        seen
    };
    let reach: BTreeMap<&String, BTreeSet<String>> = files.iter().map(|file| (*file, reached(file))).collect();
    let mut circles: Vec<Vec<String>> = files
        .iter()
        .filter(|file| reach[**file].contains(**file))
        .map(|file| {
            let mut circle: Vec<String> =
                reach[*file].iter().filter(|other| reach[*other].contains(*file)).cloned().collect();
            circle.sort();
            circle
        })
        .collect();
    circles.sort();
    circles.dedup();
    circles
}

/// Whether a file is an entry, or lies in the folder of that name.
fn belongs(file: &str, entry: &str) -> bool {
    file == entry || file.strip_prefix(entry).is_some_and(|rest| rest.starts_with('/'))
}

/// The number of a file's layer.
fn layer(layers: &[&str], file: &str) -> Option<usize> {
    (0..layers.len()).filter(|&k| belongs(file, layers[k])).max_by_key(|&k| layers[k].len())
}

/// Returns a line for each arrow to a later layer, and for each arrow at a file that belongs to no layer.
fn running_back(arrows: &BTreeSet<Arrow>, layers: &[&str]) -> Vec<String> {
    let mut found = Vec::new();
    for (from, to) in arrows {
        match (layer(layers, from), layer(layers, to)) {
            (Some(source), Some(target)) if target > source => found.push(format!("{from} uses the later {to}")),
            (Some(_), Some(_)) => {}
            _ => found.push(format!("{from} or {to} belongs to no layer: add it to LAYERS")),
        }
    }
    found
}

fn root_of(name: &str) -> PathBuf {
    let workspace = Path::new(env!("CARGO_MANIFEST_DIR"));
    if name == SERVICE { workspace.join("src") } else { workspace.join("crates").join(name).join("src") }
}

fn sources(name: &str) -> Vec<Source> {
    let root = root_of(name);
    let (mut folders, mut sources) = (vec![root.clone()], Vec::new());
    while let Some(folder) = folders.pop() {
        for entry in std::fs::read_dir(folder).expect("a source folder") {
            let path = entry.expect("an entry").path();
            if path.is_dir() {
                folders.push(path);
            } else if path.extension().is_some_and(|extension| extension == "rs") {
                let below = path.strip_prefix(&root).expect("a path below src").with_extension("");
                // A folder's `mod.rs` is the folder's own file.
                let below = if below.ends_with("mod") { below.parent().expect("a folder").to_owned() } else { below };
                let text = std::fs::read_to_string(&path).expect("a source file");
                sources.push(Source { path: below.to_string_lossy().replace('\\', "/"), text });
            }
        }
    }
    sources.sort_by(|a, b| a.path.cmp(&b.path));
    sources
}

/// Everything that is wrong with the arrows of a crate, in words.
fn faults(arrows: &BTreeSet<Arrow>, layers: &[&str]) -> Vec<String> {
    let circles = circles(arrows).into_iter().map(|circle| format!("a circle: {}", circle.join(" <-> ")));
    let back = if layers.is_empty() { Vec::new() } else { running_back(arrows, layers) };
    back.into_iter().chain(circles).collect()
}

#[test]
fn no_crate_and_no_file_uses_a_later_one_and_no_files_form_a_circle() {
    let order = CRATES.map(|(name, _)| name);
    let mut found = Vec::new();
    for (name, layers) in CRATES {
        let sources = sources(name);
        let arrows = arrows(&sources);
        assert!(!arrows.is_empty(), "{name} has no arrow between files");
        let faults = faults(&arrows, layers)
            .into_iter()
            .chain(foreign_re_exports(&sources))
            .chain(against_the_order(name, &order, &sources));
        found.extend(faults.map(|fault| format!("{name}: {fault}")));
    }
    assert!(found.is_empty(), "{}", found.join("\n"));
}

#[test]
fn every_crate_of_the_workspace_has_its_place_in_the_order() {
    let folders = std::fs::read_dir(Path::new(env!("CARGO_MANIFEST_DIR")).join("crates")).expect("the crates");
    let found: BTreeSet<String> =
        folders.map(|entry| entry.expect("an entry").file_name().to_string_lossy().into_owned()).collect();
    let listed = CRATES.iter().map(|(name, _)| (*name).to_owned()).filter(|name| name != SERVICE).collect();
    assert_eq!(found, listed, "the folders of crates/, and the crates that CRATES in this file lists");
}

#[test]
fn a_made_up_import_against_the_order_and_a_made_up_re_export_are_named() {
    let source = |path: &str, text: &str| Source { path: path.into(), text: text.into() };
    let film = [
        source("lib", "mod energy; mod store; pub use energy::Energy; pub use plateau_mesh::Mesh;"),
        source("energy", "#[cfg(test)] mod t { use plateau_forms::kind::Kind; } use plateau_archive::units::Unit;"),
        source("store", "pub use batches::Row; pub(crate) use crate::energy::Term; mod batches;"),
        source("store/batches", "fn f() -> plateau_mesh::Mesh { plateau_film::g() }"),
    ];
    assert_eq!(
        against_the_order("film", &["mesh", "film", "archive", "forms"], &film),
        [
            "energy uses plateau_archive, which does not stand before film",
            "store/batches uses plateau_film, which does not stand before film"
        ]
    );
    assert_eq!(foreign_re_exports(&film), [" re-exports plateau_mesh::Mesh", "store re-exports crate::energy::Term"]);
}

#[test]
fn code_after_a_test_module_is_read() {
    let text = "use a::b;\n#[cfg(test)]\nmod tests {\n    const OPEN: &str = \"{\";\n}\nuse c::d;\n";
    let kept = source::text_without_tests(text);
    assert_eq!(kept.lines().map(str::trim_end).collect::<Vec<_>>(), ["use a::b;", "", "", "", "", "use c::d;"]);
    let paths: Vec<String> = read(text).uses.into_iter().map(|u| u.path.join("::")).collect();
    assert_eq!(paths, ["a::b", "c::d"]);
}

fn made_up(files: &[(&str, &str)]) -> BTreeSet<Arrow> {
    let source = |(path, text): &(&str, &str)| Source { path: (*path).into(), text: (*text).into() };
    arrows(&files.iter().map(source).collect::<Vec<_>>())
}

fn arrow(from: &str, to: &str) -> Arrow {
    (from.into(), to.into())
}

#[test]
fn arrows_are_found_in_grouped_and_nested_uses_in_inline_paths_and_through_re_exports() {
    let found = made_up(&[
        ("lib", "mod a; mod b; mod c; pub use a::{Item, deep::Other as Renamed};"),
        ("a", "pub mod deep; pub struct Item; pub use deep::Other;"),
        ("a/deep", "pub struct Other; // use crate::c::Nothing;"),
        ("b", "use crate::{Item, c::{self, D}}; pub(in super::super) fn f() -> &'static str { \"crate::a::deep\" }"),
        (
            "c",
            "fn f<'a>(x: &'a str) { crate::Renamed; super::b::f(); let c = ':'; } #[cfg(test)] mod t { use crate::a; }",
        ),
    ]);
    let expected = [arrow("b", "a"), arrow("b", "c"), arrow("c", "a/deep"), arrow("c", "b")];
    assert_eq!(found, BTreeSet::from(expected));
}

#[test]
fn a_made_up_arrow_to_a_later_layer_is_named() {
    let arrows = made_up(&[
        ("lib", "mod mesh; mod remesh;"),
        ("mesh", "fn f() { crate::remesh::g(); }"),
        ("remesh", "use crate::mesh::f;"),
    ]);
    assert_eq!(running_back(&arrows, &["mesh", "remesh", "lib"]), ["mesh uses the later remesh"]);
    assert_eq!(running_back(&arrows, &["mesh"]).len(), 2);
    assert!(running_back(&BTreeSet::from([arrow("remesh/thin", "mesh")]), &["mesh", "remesh"]).is_empty());
}

#[test]
fn a_made_up_circle_is_named() {
    let arrows = made_up(&[
        ("lib", "mod solver; mod statistics; mod film;"),
        ("solver", "mod step; use crate::film::Film; use step::go; pub fn run() {}"),
        ("solver/step", "use super::run;"),
        ("film", "use crate::{statistics};"),
        ("statistics", "use super::film::*;"),
    ]);
    assert_eq!(circles(&arrows), [vec!["film", "statistics"], vec!["solver", "solver/step"]]);
    // A module's re-exports of its own children are no arrows.
    let contents = made_up(&[
        ("lib", "mod sparse;"),
        ("sparse", "mod cg; pub use cg::solve; pub struct Matrix;"),
        ("sparse/cg", "use super::Matrix;"),
    ]);
    assert!(circles(&contents).is_empty());
}
