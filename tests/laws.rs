//! Checks the laws of docs/ARCHITECTURE.md by reading the source and the dependency tree.

mod source;

use source::Token;
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

/// Returns every source file of the geometry.
fn geometry() -> Vec<PathBuf> {
    GEOMETRY.iter().flat_map(|(name, _)| sources(&root().join("crates").join(name).join("src"))).collect()
}

/// Returns a file's lines without comments and without its unit tests.
fn code(path: &Path) -> Vec<String> {
    let text = std::fs::read_to_string(path).expect("a source file");
    source::text_without_tests(&text)
        .lines()
        .map(|line| line.split("//").next().unwrap_or_default().to_owned())
        .collect()
}

/// The crates of the geometry in their order, with the libraries that each may use. A crate may use only crates that
/// stand before it.
const GEOMETRY: [(&str, &[&str]); 8] = [
    ("mesh", &["faer", "glam", "libm", "robust", "spade"]),
    ("ruled-surface", &["plateau_mesh", "libm", "robust"]),
    ("equilibrium", &["plateau_mesh", "faer", "glam", "libm"]),
    ("minimal-surface", &["plateau_mesh", "plateau_equilibrium", "glam", "libm"]),
    ("tensile-structure", &["plateau_mesh", "plateau_equilibrium", "plateau_minimal_surface", "libm"]),
    ("cable-net", &["plateau_mesh", "glam", "libm"]),
    ("uniform-mesh", &["plateau_mesh", "plateau_minimal_surface", "libm"]),
    ("lower-bound", &["plateau_mesh", "glam", "libm"]),
];

/// Returns the first function of `f64` or of a vector in `code` whose last bit depends on the machine, because the
/// system's mathematical library computes it.
fn depends_on_the_machine(code: &str) -> Option<&'static str> {
    const FUNCTIONS: [&str; 27] = [
        "sin",
        "cos",
        "tan",
        "asin",
        "acos",
        "atan",
        "atan2",
        "sin_cos",
        "sinh",
        "cosh",
        "tanh",
        "asinh",
        "acosh",
        "atanh",
        "exp",
        "exp2",
        "exp_m1",
        "ln",
        "ln_1p",
        "log",
        "log2",
        "log10",
        "powf",
        "hypot",
        "cbrt",
        "angle_between",
        "to_angle",
    ];
    let calls = |name: &&str| code.contains(&format!(".{name}(")) || code.contains(&format!("f64::{name}"));
    let rest = ["from_angle(", "mul_add("].into_iter();
    FUNCTIONS.into_iter().find(calls).or_else(|| rest.into_iter().find(|name| code.contains(name)))
}

#[test]
fn results_have_the_same_bits_on_every_machine() {
    assert_eq!(depends_on_the_machine("let x = y.sin();"), Some("sin"));
    assert_eq!(depends_on_the_machine("angles.map(f64::cos)"), Some("cos"));
    assert_eq!(depends_on_the_machine("DVec2::from_angle(angle)"), Some("from_angle("));
    assert_eq!(depends_on_the_machine("libm::sin(y) + y.sqrt() + values.exponent"), None);
    for path in geometry().into_iter().chain(sources(&root().join("crates/forms/src"))) {
        for line in code(&path) {
            assert_eq!(depends_on_the_machine(&line), None, "{}: take it from libm: {line}", path.display());
        }
    }
}

/// Returns true if code names a crate of the geometry.
fn names_geometry(code: &str) -> bool {
    GEOMETRY.iter().any(|(name, _)| code.contains(&library(name)))
}

/// Returns the name by which code calls a crate of the geometry.
fn library(name: &str) -> String {
    format!("plateau_{}", name.replace('-', "_"))
}

#[test]
fn the_crates_of_the_geometry_depend_on_numerics_and_on_earlier_crates_only() {
    for (number, (name, allowed)) in GEOMETRY.iter().enumerate() {
        let package = format!("plateau-{name}");
        let output = Command::new(env!("CARGO"))
            .args(["tree", "--package", &package, "--edges", "normal", "--depth", "1", "--prefix", "none"])
            .args(["--format", "{lib}", "--no-default-features"])
            .current_dir(root())
            .output()
            .expect("cargo tree runs");
        assert!(output.status.success(), "{}", String::from_utf8_lossy(&output.stderr));
        let found: BTreeSet<String> =
            String::from_utf8_lossy(&output.stdout).split_whitespace().map(str::to_owned).collect();
        let allowed = allowed.iter().map(|library| (*library).to_owned()).chain([library(name)]).collect();
        assert_eq!(found, allowed, "{package} may depend on these libraries only");
        let later: Vec<String> = GEOMETRY[number + 1..].iter().map(|(name, _)| library(name)).collect();
        assert!(!later.iter().any(|library| found.contains(library)), "{package} uses a later crate");
    }
}

#[test]
fn the_geometry_knows_no_clock_no_thread_and_no_file() {
    let forbidden =
        ["std::time", "std::thread", "std::fs", "std::net", "std::env", "std::io", "HashMap", "HashSet", "println!"];
    for path in geometry() {
        for (number, line) in code(&path).iter().enumerate() {
            for word in forbidden {
                let place = format!("{}:{}", path.display(), number + 1);
                assert!(
                    !line.contains(word),
                    "{place}: {word} is not allowed in the geometry, whose results depend only on arguments"
                );
            }
        }
    }
}

/// The reason for which a loop ends, as far as its source shows.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
enum Bound {
    /// The body looks at the signal, or calls something that may.
    Signal,
    /// The head compares a number that each pass raises or lowers.
    Count,
    /// A comment directly above the loop states the bound with the reason.
    Comment,
}

/// Returns true if a word is among tokens.
fn has(tokens: &[Token], name: &str) -> bool {
    tokens.iter().any(|token| source::word(Some(token)) == Some(name))
}

/// Returns the reason for which a loop ends, or `None` if the source shows none.
fn bound(found: &source::Loop) -> Option<Bound> {
    if ["look", "exec", "execution", "counter"].iter().any(|name| has(&found.body, name)) {
        return Some(Bound::Signal);
    }
    let counts = |step: &[&Token]| match step {
        [Token::Word(number), Token::Mark(sign), Token::Mark('='), Token::Mark('1'..='9'), Token::Mark(';')] => {
            let compared = if *sign == '+' { '<' } else { '>' };
            "+-".contains(*sign) && has(&found.head, number) && found.head.contains(&Token::Mark(compared))
        }
        _ => false,
    };
    // A pass that continues early may leave the step out.
    if !has(&found.body, "continue") && outermost(&found.body).windows(5).any(counts) {
        return Some(Bound::Count);
    }
    let comment = found.comment.to_lowercase();
    let says = |word: &str| comment.split(|c: char| !c.is_alphanumeric()).any(|found| found == word);
    ((comment.contains("at most") || says("ends")) && says("because")).then_some(Bound::Comment)
}

/// Returns the tokens that stand in no brackets, and the outermost brackets themselves.
fn outermost(tokens: &[Token]) -> Vec<&Token> {
    let mut depth = 0;
    let mut outer = Vec::new();
    for token in tokens {
        if matches!(token, Token::Mark(')' | ']' | '}')) {
            depth -= 1;
        }
        if depth == 0 {
            outer.push(token);
        }
        if matches!(token, Token::Mark('(' | '[' | '{')) {
            depth += 1;
        }
    }
    outer
}

#[test]
fn every_loop_of_the_geometry_looks_at_the_signal_or_states_its_bound() {
    let bounds = |code: &str| -> Vec<Option<Bound>> { source::loops(code).iter().map(bound).collect() };
    for (code, expected) in [
        ("loop { exec.look(1)?; }", Bound::Signal),
        ("while open() { part(&mut state, execution)?; }", Bound::Signal),
        ("while k < n { list.push(k); k += 1; }", Bound::Count),
        ("while self.left > 0 { self.left -= 1; }", Bound::Count),
        ("// At most n passes, because each\n// takes one.\nwhile let Some(x) = list.pop() {}", Bound::Comment),
        ("// Ends because k falls.\nlet x = loop { step(); };", Bound::Comment),
    ] {
        assert_eq!(bounds(code), [Some(expected)], "{code}");
    }
    for code in [
        "loop { step(); }",
        "while let Some(x) = list.pop() { list.push(x); }",
        "while k < n { if odd { continue; } k += 1; }",
        "while k < n { if odd { k += 1; } }",
        "while k < n { k -= 1; }",
        "while level < high { level += 1.0; }",
        "while rest < n { counts[rest] += 1; }",
        "// Follows the boundary.\nloop { step(); }",
        "// Ends because k falls.\n\nloop { step(); }",
    ] {
        assert_eq!(bounds(code), [None::<Bound>], "{code}");
    }
    let mut found = Vec::new();
    for path in geometry().into_iter().filter(|path| !path.ends_with("tests.rs")) {
        let text = std::fs::read_to_string(&path).expect("a source file");
        let unbounded = source::loops(&text).into_iter().filter(|found| bound(found).is_none());
        found.extend(unbounded.map(|unbounded| format!("{}:{}", path.display(), unbounded.line)));
    }
    assert!(
        found.is_empty(),
        "let these loops look at the signal, or write above each `at most … because …` or `ends because …`:\n{}",
        found.join("\n")
    );
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
                    "{place}: use a Failure of http/problem.rs instead of a status code"
                );
            }
        }
    }
}

/// A source file of the service, with its path below `src` and its code.
struct Source {
    path: String,
    code: String,
}

/// Returns every source file of the service.
fn service() -> Vec<Source> {
    let folder = root().join("src");
    let source = |path: PathBuf| Source {
        path: path.strip_prefix(&folder).expect("a file of the service").to_string_lossy().into_owned(),
        code: code(&path).join("\n"),
    };
    sources(&folder).into_iter().map(source).collect()
}

/// Returns source files with the given paths and code, to test the checks themselves.
fn made_up(files: &[(&str, &str)]) -> Vec<Source> {
    files.iter().map(|(path, code)| Source { path: (*path).into(), code: (*code).into() }).collect()
}

impl Source {
    /// Returns the path of the file's module, such as `["http", "routes", "jobs"]`.
    fn module(&self) -> Vec<String> {
        self.path.trim_end_matches(".rs").split('/').map(str::to_owned).collect()
    }

    /// Returns the part of the service that the file belongs to.
    fn part(&self) -> String {
        self.module().swap_remove(0)
    }

    /// Returns every path of this crate that the code names, starting at the crate's root.
    fn named(&self) -> Vec<Vec<String>> {
        let mut named = Vec::new();
        for (at, word) in ["crate::", "super::"].iter().flat_map(|word| self.code.match_indices(word)) {
            let preceding = self.code[..at].chars().next_back().unwrap_or(' ');
            if preceding.is_alphanumeric() || preceding == '_' || preceding == ':' {
                continue;
            }
            let mut base = Vec::new();
            let mut rest = &self.code[at + word.len()..];
            if word == "super::" {
                base = self.module();
                base.pop();
                while let Some(further) = rest.strip_prefix("super::") {
                    base.pop();
                    rest = further;
                }
            }
            expand(base, rest, &mut named);
        }
        named
    }
}

/// Adds every path of a use tree: `b::{c, d::e}` below `base` means `base::b::c` and `base::b::d::e`. Returns the text
/// after the tree.
fn expand<'a>(mut base: Vec<String>, mut rest: &'a str, paths: &mut Vec<Vec<String>>) -> &'a str {
    loop {
        rest = rest.trim_start();
        if let Some(mut list) = rest.strip_prefix('{') {
            loop {
                list = list.trim_start().trim_start_matches(',').trim_start();
                if let Some(after) = list.strip_prefix('}') {
                    return after;
                }
                if list.is_empty() {
                    return list;
                }
                let after = expand(base.clone(), list, paths);
                // Text that is not a name is skipped.
                list = if after.len() == list.len() {
                    &list[list.chars().next().map_or(0, char::len_utf8)..]
                } else {
                    after
                };
            }
        }
        let length = rest.find(|c: char| !c.is_alphanumeric() && c != '_').unwrap_or(rest.len());
        if length > 0 {
            base.push(rest[..length].to_owned());
            rest = &rest[length..];
        }
        match rest.strip_prefix("::") {
            Some(further) if length > 0 => rest = further,
            _ => {
                paths.push(base);
                return rest;
            }
        }
    }
}

/// Returns the files that name a crate of the geometry.
fn know_geometry(files: &[Source]) -> Vec<&str> {
    files.iter().filter(|file| names_geometry(&file.code)).map(|file| file.path.as_str()).collect()
}

#[test]
fn the_service_knows_no_crate_of_the_geometry() {
    let offences = made_up(&[
        ("jobs/worker.rs", "use plateau_forms::kind::Kind;\nuse plateau_mesh::Signal;"),
        ("cli.rs", "fn f() -> Kind { plateau_minimal_surface::solve() }"),
        ("jobs/batch.rs", "use plateau_forms::kind::Kind;"),
    ]);
    assert_eq!(know_geometry(&offences), ["jobs/worker.rs", "cli.rs"]);
    assert_eq!(know_geometry(&service()), [""; 0], "plateau_forms turns requests into results for the service");
}

/// Returns files that add a route without its entry in the API document.
fn route_past_the_document(files: &[Source]) -> Vec<&str> {
    let allowed = ["http/resource.rs", "http/router.rs"];
    let adds_route = |file: &&Source| [".route(", "axum::routing"].iter().any(|word| file.code.contains(word));
    files
        .iter()
        .filter(|file| !allowed.contains(&file.path.as_str()))
        .filter(adds_route)
        .map(|file| file.path.as_str())
        .collect()
}

#[test]
fn routes_come_with_their_entry_in_the_document() {
    let offences = made_up(&[
        ("http/routes/jobs.rs", "router.route(\"/v1/hidden\", get(list))"),
        ("http/resource.rs", "router.route(self.path, self.handlers)"),
    ]);
    assert_eq!(route_past_the_document(&offences), ["http/routes/jobs.rs"]);
    assert_eq!(route_past_the_document(&service()), [""; 0], "add a Resource to http/router.rs");
    let router = service().into_iter().find(|file| file.path == "http/router.rs").expect("the router");
    let direct = router.code.matches(".route(").count();
    assert_eq!(
        direct, 3,
        "the only routes here belong to the resources, the base path's redirect and the metrics listener"
    );
}

/// Returns the types of failed jobs' errors that the code names, without the path before them.
fn types(code: &str) -> BTreeSet<String> {
    let name = |rest: &str| rest.trim_start().trim_start_matches('"').split('"').next().map(str::to_owned);
    ["SolveError::new(", "failure(", "\"/problems/"]
        .iter()
        .flat_map(|word| code.split(word).skip(1))
        .filter_map(name)
        .filter(|name| name.bytes().all(|byte| byte.is_ascii_lowercase() || byte == b'-'))
        .collect()
}

#[test]
fn every_reason_for_a_failed_job_is_in_the_catalogue() {
    assert_eq!(
        types(r#"SolveError::new("deadline", "late", errors); "type": "/problems/worker-lost", "/problems/{name}""#),
        BTreeSet::from(["deadline".into(), "worker-lost".into()])
    );
    let known: BTreeSet<String> = plateau::wire::job::failures().into_iter().map(|(name, _)| name).collect();
    let check = |path: &str, kind: &str| {
        assert!(known.contains(kind), "{path}: {kind} is in no list of FAILURES");
    };
    for path in sources(&root().join("crates/forms/src")) {
        types(&code(&path).join("\n")).iter().for_each(|kind| check(&path.display().to_string(), kind));
    }
    for file in service().iter().filter(|file| ["jobs", "store", "wire"].contains(&file.part().as_str())) {
        types(&file.code).iter().for_each(|kind| check(&file.path, kind));
    }
}

#[test]
fn the_arrows_between_modules_are_the_committed_ones() {
    let mut arrows = BTreeSet::new();
    for file in service() {
        let from = file.part();
        if matches!(from.as_str(), "lib" | "main") {
            continue;
        }
        let named = file.named().into_iter().filter_map(|path| path.into_iter().next());
        for to in named.filter(|to| *to != from) {
            arrows.insert(format!("{from} -> {to}"));
        }
        let crates = GEOMETRY.iter().map(|(name, _)| *name).chain(["archive", "forms", "opennurbs"]);
        for name in crates.filter(|name| file.code.contains(&library(name))) {
            arrows.insert(format!("{from} -> crates/{name}"));
        }
    }
    let found: String = arrows.iter().map(|arrow| format!("{arrow}\n")).collect();
    let committed = std::fs::read_to_string(root().join("tests/arrows.txt")).unwrap_or_default();
    assert!(
        found == committed,
        "the arrows between modules changed. If that is meant, say why in docs/ARCHITECTURE.md and commit \
         tests/arrows.txt as:\n{found}"
    );
}

/// Largest width of a line, in characters. `rustfmt.toml` has the same number, but rustfmt wraps neither comments nor
/// strings.
const WIDTH: usize = 120;

/// Words with which no comment begins, because the reader cannot know yet what they refer to.
const FORBIDDEN_FIRST_WORDS: [&str; 6] = ["What", "One", "Such", "So", "As", "Nor"];

/// Returns the lines that are too wide, and the paragraphs of comments that begin with a forbidden word, by the number
/// of the line. `published` has the texts of the API document, whose words and line breaks belong to the contract:
/// generated clients repeat them.
fn unreadable(text: &str, published: &str) -> Vec<String> {
    let mut found = Vec::new();
    let is_published = |comment: &str| published.contains(&comment.replace('"', "\\\""));
    let (mut begins, mut is_code) = (true, false);
    for (number, line) in text.lines().enumerate() {
        let mut report = |fault: String| found.push(format!("{}: {fault}", number + 1));
        let comment = line.trim_start().strip_prefix("//").map(|rest| rest.trim_start_matches(['/', '!']).trim());
        if line.chars().count() > WIDTH && !comment.is_some_and(is_published) {
            report(format!("{} columns", line.chars().count()));
        }
        let Some(comment) = comment else {
            (begins, is_code) = (true, false);
            continue;
        };
        is_code ^= comment.starts_with("```");
        let first = comment.split(|c: char| !c.is_alphanumeric()).next().unwrap_or_default();
        if begins && !is_code && FORBIDDEN_FIRST_WORDS.contains(&first) && !is_published(comment) {
            report(comment.to_owned());
        }
        begins = comment.is_empty();
    }
    found
}

#[test]
fn lines_fit_and_comments_begin_with_their_subject() {
    let wide = format!("/// {}\n", "é".repeat(116)) + &format!("    // {}", "x".repeat(114));
    assert_eq!(unreadable(&wide, ""), ["2: 121 columns"]);
    assert_eq!(unreadable(&wide, &"x".repeat(114)), [""; 0]);
    let text = "/// What it is.\n///\n/// As before.\n// One more\n// Such\nfn f() {\n    //! Once.\n}\n// One row.\n";
    assert_eq!(unreadable(text, "\"One row.\""), ["1: What it is.", "3: As before."]);
    assert_eq!(unreadable("/// Code:\n///\n/// ```\n///\n/// One::of()\n/// ```\n", ""), [""; 0]);
    let published = std::fs::read_to_string(root().join("api/openapi.json")).expect("the API document");
    let mut found = Vec::new();
    for path in ["crates", "src", "tests", "examples"].iter().flat_map(|folder| sources(&root().join(folder))) {
        let text = std::fs::read_to_string(&path).expect("a source file");
        found.extend(unreadable(&text, &published).into_iter().map(|fault| format!("{}:{fault}", path.display())));
    }
    assert!(found.is_empty(), "wrap these lines, and begin comments with their subject:\n{}", found.join("\n"));
}

/// Largest number of lines of a file without its tests, and of a function. A longer one has more than one subject.
const FILE_LINES: usize = 600;
const FUNCTION_LINES: usize = 80;

/// Returns the functions that are too long, with their lengths, and the length of a file that is too long.
fn too_long(text: &str) -> Vec<String> {
    let text = source::text_without_tests(text);
    let lines: Vec<&str> = text.trim_end().lines().collect();
    let mut found = Vec::new();
    if lines.len() > FILE_LINES {
        found.push(format!("{} lines", lines.len()));
    }
    for (start, line) in lines.iter().enumerate() {
        let own = line.trim_start();
        let qualifies = |word: &&str| word.starts_with("pub") || ["in", "const", "async", "unsafe"].contains(word);
        let mut words = own.split_whitespace().skip_while(|word| qualifies(word) || word.ends_with(')'));
        let (Some("fn"), Some(name)) = (words.next(), words.next()) else { continue };
        // A function without a body ends with a semicolon, and one of a single line with a brace.
        let head_end = lines[start..].iter().position(|line| line.ends_with([';', '{', '}'])).unwrap_or(0) + start;
        let closing = format!("{}}}", &line[..line.len() - own.len()]);
        if lines[head_end].ends_with('{')
            && let Some(end) = lines[head_end..].iter().position(|line| *line == closing)
            && head_end + end - start >= FUNCTION_LINES
        {
            let name = name.split(['(', '<']).next().unwrap_or_default();
            found.push(format!("{}: {name} has {} lines", start + 1, head_end + end - start + 1));
        }
    }
    found
}

#[test]
fn files_and_functions_have_one_subject() {
    let function =
        |head: &str, length: usize| format!("    {head} {{\n{}    }}\n", "        x();\n".repeat(length - 2));
    assert_eq!(too_long(&function("pub(in crate::a) fn f<T>(t: T)", 80)), [""; 0]);
    assert_eq!(too_long(&function("pub(in crate::a) fn f<T>(t: T)", 81)), ["1: f has 81 lines"]);
    let trait_function = "    fn f(\n        &self,\n    );\n".to_owned() + &function("const fn g()", 90);
    assert_eq!(too_long(&trait_function), ["4: g has 90 lines"]);
    let tested = "fn f() {}\n".repeat(600) + "#[cfg(test)]\nmod tests {\n    fn g() {}\n}\n";
    assert_eq!(too_long(&tested), [""; 0]);
    assert_eq!(too_long(&"fn f() {}\n".repeat(601)), ["601 lines"]);
    let field = "S {\n    #[cfg(test)]\n    order,\n    rows,\n}";
    assert!(source::text_without_tests(field).ends_with("          \n    rows,\n}"));
    let mut found = Vec::new();
    for path in ["crates", "src"].iter().flat_map(|folder| sources(&root().join(folder))) {
        let is_code = path.components().any(|part| part.as_os_str() == "src") && !path.ends_with("tests.rs");
        if is_code {
            let text = std::fs::read_to_string(&path).expect("a source file");
            found.extend(too_long(&text).into_iter().map(|fault| format!("{}:{fault}", path.display())));
        }
    }
    assert!(found.is_empty(), "divide these by their subjects:\n{}", found.join("\n"));
}
