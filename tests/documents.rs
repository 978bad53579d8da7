//! Checks that every file that a document names exists, and that every link leads to a file and a heading: README
//! files, everything in `docs` and the comments of migrations. The changelog is left out, because it may name what is
//! gone.

use std::collections::BTreeSet;
use std::path::{Path, PathBuf};

/// Files of other projects that documents name.
const ELSEWHERE: [&str; 3] = ["cablenet.md", "src/hops/RemoteDefinition.cs", "HopsComponent.cs"];

/// Endings by which a word is recognised as the name of a file.
const ENDINGS: [&str; 17] = [
    "rs", "md", "py", "sql", "mjs", "ts", "toml", "jsonl", "txt", "json", "css", "html", "yml", "yaml", "sh", "cs",
    "png",
];

fn root() -> PathBuf {
    PathBuf::from(env!("CARGO_MANIFEST_DIR"))
}

/// Returns the files and folders of the project, relative to its root, without those that git ignores by name.
fn tree() -> BTreeSet<String> {
    let ignored = ["target", "node_modules", "__pycache__"];
    let mut paths = BTreeSet::new();
    let mut folders = vec![root()];
    while let Some(folder) = folders.pop() {
        for entry in std::fs::read_dir(&folder).expect("a folder") {
            let path = entry.expect("an entry").path();
            let name = path.file_name().expect("a name").to_string_lossy().into_owned();
            if name.starts_with('.') || ignored.contains(&name.as_str()) {
                continue;
            }
            let relative = path.strip_prefix(root()).expect("below the root").to_string_lossy().into_owned();
            paths.insert(relative);
            if path.is_dir() {
                folders.push(path);
            }
        }
    }
    paths
}

fn is_document(path: &str) -> bool {
    (path.ends_with(".md") && path != "CHANGELOG.md") || (path.starts_with("migrations/") && path.ends_with(".sql"))
}

/// Returns the alternatives of a word such as `src/{energy,equilibrium}`.
fn expanded(word: &str) -> Vec<String> {
    match word.split_once('{').and_then(|(before, rest)| Some((before, rest.split_once('}')?))) {
        Some((before, (inside, after))) if inside.contains(',') => {
            inside.split(',').flat_map(|one| expanded(&format!("{before}{one}{after}"))).collect()
        }
        _ => vec![word.to_owned()],
    }
}

/// Returns the words of a text that name a file by its ending, or anything in one of the project's folders.
fn named(text: &str, folders: &BTreeSet<&str>) -> BTreeSet<String> {
    let between = |c: char| c.is_whitespace() || "`()[]\"'<>;|=".contains(c);
    let words = text.split(between).map(|word| word.split('#').next().unwrap_or_default());
    let words = words.map(|word| word.trim_end_matches(['.', ',', ':', '/']));
    // URLs, paths of the service, options, variables and hidden files are not files of the project.
    let words = words.filter(|word| {
        !word.contains("://") && (word.starts_with("../") || !word.starts_with(['/', '-', '$', '.', '@']))
    });
    let is_path = |word: &String| {
        let name = word.rsplit('/').next().unwrap_or_default();
        let is_file = name.rsplit_once('.').is_some_and(|(stem, ending)| !stem.is_empty() && ENDINGS.contains(&ending));
        let is_below = word.split_once('/').is_some_and(|(first, _)| folders.contains(first));
        let is_plain = word.chars().all(|c| c.is_alphanumeric() || "./*_-+".contains(c));
        is_plain && (is_file || is_below)
    };
    words.flat_map(expanded).filter(is_path).collect()
}

/// Returns true if each part of a path matches the same part of a pattern, in which `*` stands for any characters of
/// one part.
fn fits(path: &[&str], pattern: &[&str]) -> bool {
    let part = |(name, pattern): (&&str, &&str)| match pattern.split_once('*') {
        None => name == pattern,
        Some((before, after)) => {
            name.len() >= before.len() + after.len() && name.starts_with(before) && name.ends_with(after)
        }
    };
    path.len() == pattern.len() && path.iter().zip(pattern).all(part)
}

/// Returns true if a word of a document names an existing path: relative to the document, or as the end of any path of
/// the project.
fn exists(word: &str, document: &str, tree: &BTreeSet<String>) -> bool {
    let mut parts: Vec<&str> = Path::new(document)
        .parent()
        .map_or(Vec::new(), |folder| folder.iter().map(|part| part.to_str().expect("a name in UTF-8")).collect());
    for part in word.split('/') {
        match part {
            ".." => drop(parts.pop()),
            _ => parts.push(part),
        }
    }
    let pattern: Vec<&str> = word.split('/').collect();
    tree.iter().any(|path| {
        let path: Vec<&str> = path.split('/').collect();
        let end = path.len().checked_sub(pattern.len()).map_or(&path[..0], |start| &path[start..]);
        fits(&path, &parts) || fits(end, &pattern)
    })
}

/// Returns a line for each word of a document that looks like a file's name and names no file.
fn missing(documents: &[(String, String)], tree: &BTreeSet<String>) -> Vec<String> {
    let folders: BTreeSet<&str> = tree.iter().filter_map(|path| Some(path.split_once('/')?.0)).collect();
    let of = |(document, text): &(String, String)| -> Vec<String> {
        let words = named(text, &folders).into_iter();
        words
            .filter(|word| !ELSEWHERE.contains(&word.as_str()) && !exists(word, document, tree))
            .map(|word| format!("{document} names {word}"))
            .collect()
    };
    documents.iter().flat_map(of).collect()
}

#[test]
fn every_path_that_a_document_names_exists() {
    let tree = tree();
    let read = |path: &String| (path.clone(), std::fs::read_to_string(root().join(path)).expect("a document"));
    let documents: Vec<(String, String)> = tree.iter().filter(|path| is_document(path)).map(read).collect();
    assert!(documents.len() > 20, "{} documents", documents.len());
    let missing = missing(&documents, &tree);
    assert!(missing.is_empty(), "there is no such file:\n{}", missing.join("\n"));
    for other in ELSEWHERE {
        assert!(documents.iter().any(|(_, text)| text.contains(other)), "no document names {other} any more");
    }
}

#[test]
fn a_path_that_does_not_exist_is_found_in_any_form() {
    let tree: BTreeSet<String> =
        ["docs", "docs/a.md", "src", "src/store", "src/store/jobs.rs", "src/http", "api", "api/one-thing.json"]
            .map(str::to_owned)
            .into();
    let found = |text: &str| missing(&[("docs/a.md".into(), text.into())], &tree);
    let right = "See `src/store/jobs.rs`, `store/jobs.rs`, jobs.rs. [this](../src/store/jobs.rs#L3), \
        `src/{store,http}/`, `api/one-*.json`, https://example.org/b.md, `/v1/jobs.json`, `.hidden/c.md`, 3.5 or \
        and/or.";
    assert_eq!(found(right), Vec::<String>::new());
    for wrong in ["src/store/queue.rs", "queue.rs", "../src/none.rs", "src/none", "api/two-*.json", "ore/jobs.rs"] {
        assert_eq!(found(&format!("-- The order: see `{wrong}`.")), [format!("docs/a.md names {wrong}")]);
    }
    assert_eq!(found("`src/{store,none}`"), ["docs/a.md names src/none"]);
}

/// Returns the targets of the links and pictures of a document, `[text](target)`, without those outside the project.
fn links(text: &str) -> Vec<&str> {
    let targets =
        text.match_indices("](").filter_map(|(at, _)| text[at + 2..].split_once(')').map(|(target, _)| target));
    targets.filter(|target| !target.contains("://") && !target.contains(char::is_whitespace)).collect()
}

/// Returns the names by which a document's headings are linked: small letters, digits and hyphens for spaces.
fn anchors(text: &str) -> BTreeSet<String> {
    let headings =
        text.lines().filter_map(|line| line.strip_prefix('#').map(|rest| rest.trim_start_matches('#').trim()));
    let letter = |c: char| match c {
        ' ' => Some('-'),
        '-' | '_' => Some(c),
        _ => c.is_alphanumeric().then(|| c.to_lowercase().next().unwrap_or(c)),
    };
    headings.map(|heading| heading.chars().filter_map(letter).collect()).collect()
}

/// Returns the links of a document that lead to no file or to no heading of it.
fn broken(document: &str, text: &str, read: &dyn Fn(&str) -> Option<String>) -> Vec<String> {
    let leads = |target: &&str| {
        let (file, heading) = target.split_once('#').unwrap_or((target, ""));
        let mut parts: Vec<&str> = document.split('/').collect();
        if !file.is_empty() {
            parts.pop();
        }
        for part in file.split('/').filter(|part| !part.is_empty() && *part != ".") {
            match part {
                ".." => drop(parts.pop()),
                _ => parts.push(part),
            }
        }
        read(&parts.join("/")).is_some_and(|text| heading.is_empty() || anchors(&text).contains(heading))
    };
    links(text)
        .into_iter()
        .filter(|target| !leads(target))
        .map(|target| format!("{document} links to {target}"))
        .collect()
}

/// Returns the text of a file of the project; empty for folders and pictures; `None` if there is none.
fn contents(path: &str) -> Option<String> {
    let path = root().join(path);
    path.exists().then(|| std::fs::read_to_string(path).unwrap_or_default())
}

#[test]
fn every_link_of_a_document_leads_to_a_file_and_a_heading() {
    let documents: Vec<String> = tree().into_iter().filter(|path| is_document(path)).collect();
    let text = |path: &String| contents(path).expect("a document");
    let count: usize = documents.iter().map(|path| links(&text(path)).len()).sum();
    assert!(count > 100, "{count} links");
    let broken: Vec<String> = documents.iter().flat_map(|path| broken(path, &text(path), &contents)).collect();
    assert!(broken.is_empty(), "these links lead nowhere:\n{}", broken.join("\n"));
}

#[test]
fn a_link_that_leads_nowhere_is_found() {
    let read = |path: &str| match path {
        "docs/a.md" => Some("# A\n## How far, at most: `x`?\n".to_owned()),
        "src" | "docs/b.svg" => Some(String::new()),
        _ => None,
    };
    let right = "[a](../docs/a.md#how-far-at-most-x) [b](#a) ![b](b.svg) [c](https://example.org/c.md) [d](../src) \
                 f(x)[1](no link";
    assert_eq!(broken("docs/a.md", right, &read), Vec::<String>::new());
    for wrong in ["c.md", "a.md#how-far", "#b", "../b.svg"] {
        assert_eq!(broken("docs/a.md", &format!("[x]({wrong})"), &read), [format!("docs/a.md links to {wrong}")]);
    }
}

/// `scripts/check_tables.py` runs the commands of these lines and compares what they print with the tables below them.
#[test]
fn every_paper_says_which_command_prints_its_tables() {
    let pages: Vec<String> =
        tree().into_iter().filter(|path| path.starts_with("docs/papers/") && path != "docs/papers/README.md").collect();
    assert_eq!(pages.len(), 5, "{pages:?}");
    for page in pages {
        let text = contents(&page).expect("a page");
        let table = text.find("\n| --- |").unwrap_or_else(|| panic!("{page} has no table"));
        let paper = page.trim_start_matches("docs/papers/").trim_end_matches(".md");
        let command = format!("\nRebuilt by `python3 benches/papers/tables.py {paper}`");
        let stated = text.find(&command).unwrap_or_else(|| panic!("{page} does not name its command"));
        assert!(stated < table, "{page} has a table before its command");
    }
}

/// Returns the functions that the tables under "The way of a request and back" name, each with the files of its row. A
/// row without a file continues the one above.
fn functions_of_the_way(document: &str) -> Vec<(String, Vec<String>)> {
    let section = document.split("\n## ").find(|section| section.starts_with("The way of a request and back"));
    let (mut files, mut found) = (Vec::new(), Vec::new());
    for line in section.expect("the section").lines().filter(|line| line.starts_with("| ")) {
        let quoted = |cell: &str| cell.split('`').skip(1).step_by(2).map(str::to_owned).collect::<Vec<_>>();
        let cells: Vec<&str> = line.split('|').collect();
        let (own, functions) = (quoted(cells[1]), quoted(cells[2]));
        if !own.is_empty() {
            files = own;
        }
        found.extend(functions.into_iter().map(|function| (function, files.clone())));
    }
    found
}

#[test]
fn every_function_of_the_way_of_a_request_stands_in_a_file_of_its_row() {
    let document = std::fs::read_to_string(root().join("docs/ARCHITECTURE.md")).expect("the document");
    let functions = functions_of_the_way(&document);
    assert!(functions.len() > 100, "{} functions", functions.len());
    for (function, files) in functions {
        let name = function.rsplit("::").next().unwrap_or_default();
        let stands_in = |file: &String| {
            let path = root().join(if file.starts_with("crates/") { file.clone() } else { format!("src/{file}") });
            let path = if path.is_dir() { path.with_extension("rs") } else { path };
            let source = std::fs::read_to_string(&path).unwrap_or_else(|error| panic!("{}: {error}", path.display()));
            let declares = |word: &str| {
                let after = |(at, _)| source[at + word.len()..].chars().next();
                source.match_indices(word).any(|place| after(place).is_none_or(|c| !c.is_alphanumeric() && c != '_'))
            };
            declares(&format!("fn {name}")) || declares(&format!("struct {name}"))
        };
        assert!(files.iter().any(stands_in), "no function {function} in {files:?}");
    }
}
