//! The memory that bodies of hostile shapes take while they are read. Each shape is a few bytes that repeat, so that a
//! parsed value would take up to fifty times as much memory as its text.

use crate::config::LimitsConfig;
#[cfg(feature = "hops")]
use crate::hops::{component::Action, recipe, values};
#[cfg(feature = "mcp")]
use crate::http::mcp::Message;
use crate::jobs::submission::hash_of_body;
use crate::wire::batch::BatchRequest;
use crate::wire::incoming::Incoming;
use plateau_engine::kind::Kind;
#[cfg(any(feature = "hops", feature = "mcp"))]
use plateau_engine::limits::refuse_too_many_values;
#[cfg(feature = "mcp")]
use plateau_engine::limits::refuse_too_much_as_values;
use plateau_engine::source::no_jobs;

/// Length of a body in bytes. In a shorter body the values may take 32 MiB, however few bytes it has.
const BODY_BYTES: usize = 8 << 20;
/// Memory that reading may take, relative to the length of the body, the body included.
const MOST: f64 = 8.0;

/// The part of the service that reads a body.
#[derive(Clone, Copy, Debug)]
enum Reader {
    /// The request of a kind.
    Kind(&'static str),
    Batch,
    /// A message of Hops.
    #[cfg(feature = "hops")]
    Hops,
    /// A message of the Model Context Protocol.
    #[cfg(feature = "mcp")]
    Mcp,
    /// The hash of a request with an idempotency key that begins with the result of a job.
    Hash,
}

impl Reader {
    /// Reads a body as the service does. Whether it is accepted does not matter here.
    fn read(self, body: &[u8]) {
        let limits = LimitsConfig::default();
        match self {
            Self::Kind(name) => drop(Incoming::read(Kind::from_name(name).unwrap(), body, &no_jobs, &limits)),
            Self::Batch => drop(BatchRequest::read(body, &no_jobs, &limits)),
            Self::Hash => drop(hash_of_body(body, &limits)),
            #[cfg(feature = "hops")]
            Self::Hops => {
                if refuse_too_many_values(body, &limits.requests()).is_err() {
                    return;
                }
                let Ok(message) = values::message(body) else { return };
                let Ok(values) = values::read(&message, limits.points) else { return };
                if let Action::Solve(recipe) = message.component.action {
                    drop(recipe::draft(recipe, &values, limits.points));
                }
            }
            #[cfg(feature = "mcp")]
            Self::Mcp => {
                let checks = [refuse_too_many_values(body, &limits.requests()), refuse_too_much_as_values(body)];
                if checks.iter().all(Result::is_ok) {
                    drop(Message::read(body));
                }
            }
        }
    }
}

/// A function that writes a body, because all bodies at once would take 500 MB.
type Body = Box<dyn Fn() -> String>;

/// A body of at least [`BODY_BYTES`] bytes that repeats a part, with commas between.
fn repeated(start: &str, part: impl Fn(usize) -> String + 'static, end: &'static str) -> Body {
    let start = start.to_owned();
    Box::new(move || {
        let mut body = start.clone() + &part(0);
        for number in 1.. {
            if body.len() >= BODY_BYTES {
                break;
            }
            body.push(',');
            body += &part(number);
        }
        body + end
    })
}

/// A body with this number of equal parts. A vector takes the most memory when it has just grown beyond a power
/// of two.
fn counted(start: &'static str, part: &'static str, count: usize, end: &'static str) -> Body {
    Box::new(move || format!("{start}{}{part}{end}", format!("{part},").repeat(count - 1)))
}

/// The name of a shape, who reads it, and the body.
type Bomb = (&'static str, Reader, Body);

const NET: &str = r#"{"vertices":[[0,0,0],[1,0,0]],"supports":[0],"edges":[[0,1]],"#;
const KNOTS: &str = r#"{"edge_length":1,"domain":{"nurbs":{"knots_u":["#;
const FILM: &str = r#"{"boundaries":[[[0,0,0],[1,0,0],[1,1,0]]],"#;

const CABLE_NET: Reader = Reader::Kind("cable_net");
const MINIMAL_SURFACE: Reader = Reader::Kind("minimal_surface");
const RULED_SURFACE: Reader = Reader::Kind("ruled_surface");
const TENSILE_STRUCTURE: Reader = Reader::Kind("tensile_structure");
const UNIFORM_MESH: Reader = Reader::Kind("uniform_mesh");

fn same(text: &'static str) -> impl Fn(usize) -> String {
    move |_| text.to_owned()
}

fn padded(text: &str, length: usize) -> impl Fn(usize) -> String + use<> {
    let text = format!("{text:<width$}", width = length - 1);
    move |_| text.clone()
}

fn member(number: usize) -> String {
    format!("\"{number}\":1")
}

fn deep(opening: &str, inner: &str, closing: &str) -> impl Fn(usize) -> String + use<> {
    let text = format!("{}{inner}{}", opening.repeat(100), closing.repeat(100));
    move |_| text.clone()
}

fn in_film(text: &str) -> String {
    format!("{FILM}{text}")
}

fn point(number: usize) -> String {
    format!("[{}.25,{}.5,0.125]", number % 1000, number / 1000)
}

fn of_films() -> Vec<Bomb> {
    vec![
        ("members of the metadata", MINIMAL_SURFACE, repeated(&in_film("\"metadata\":{"), member, "}}")),
        ("lists in the metadata", MINIMAL_SURFACE, repeated(&in_film("\"metadata\":{\"a\":["), same("[]"), "]}}")),
        (
            "objects in the metadata",
            MINIMAL_SURFACE,
            repeated(&in_film("\"metadata\":{\"a\":["), same("{\"\":0}"), "]}}"),
        ),
        ("unknown members", MINIMAL_SURFACE, repeated(FILM, member, "}")),
        ("members of an unknown member", MINIMAL_SURFACE, repeated(&in_film("\"a\":{"), member, "}}")),
        ("numbers of an unknown member", MINIMAL_SURFACE, repeated(&in_film("\"a\":["), same("1"), "]}")),
        ("deep lists", MINIMAL_SURFACE, repeated(&in_film("\"a\":["), deep("[", "", "]"), "]}")),
        ("deep objects", MINIMAL_SURFACE, repeated(&in_film("\"a\":["), deep("{\"a\":", "0", "}"), "]}")),
        ("lists that nothing closes", MINIMAL_SURFACE, Box::new(|| "[".repeat(BODY_BYTES))),
        ("empty boundaries", MINIMAL_SURFACE, repeated("{\"boundaries\":[", same("[]"), "]}")),
        ("numbers in place of boundaries", MINIMAL_SURFACE, repeated("{\"boundaries\":[", same("1"), "]}")),
        ("points of nothing", MINIMAL_SURFACE, repeated("{\"boundaries\":[[", same("[]"), "]]}")),
        ("points of zeros", MINIMAL_SURFACE, repeated("{\"boundaries\":[[", same("[0,0,0]"), "]]}")),
        ("points of nulls", MINIMAL_SURFACE, repeated("{\"boundaries\":[[", same("[null,null,null]"), "]]}")),
        ("objects in place of boundaries", MINIMAL_SURFACE, repeated("{\"boundaries\":[", same("{}"), "]}")),
        ("texts in place of a label", MINIMAL_SURFACE, repeated(&in_film("\"label\":["), same("\"\""), "]}")),
        ("a long label", MINIMAL_SURFACE, Box::new(|| format!("{FILM}\"label\":\"{}\"}}", "a".repeat(BODY_BYTES)))),
        (
            "escapes in a label",
            MINIMAL_SURFACE,
            Box::new(|| format!("{FILM}\"label\":\"{}\"}}", "\\u0041".repeat(BODY_BYTES / 6))),
        ),
        ("a long name", MINIMAL_SURFACE, Box::new(|| format!("{FILM}\"{}\":1}}", "a".repeat(BODY_BYTES)))),
        ("nulls in place of a request", MINIMAL_SURFACE, repeated("[", same("null"), "]")),
        ("white space", MINIMAL_SURFACE, Box::new(|| format!("{FILM}{}\"label\":1}}", " ".repeat(BODY_BYTES)))),
        (
            "long numbers",
            MINIMAL_SURFACE,
            repeated("{\"boundaries\":[[", same("0.000000000000000000000000000000000001"), "]]}"),
        ),
        ("a repeated name", MINIMAL_SURFACE, repeated(FILM, same("\"label\":1"), "}")),
    ]
}

/// Bodies that have just as many values as are read.
fn at_the_limits_of_the_count() -> Vec<Bomb> {
    vec![
        (
            "2^20 and one points of zeros",
            MINIMAL_SURFACE,
            counted("{\"boundaries\":[[", "[0,0,0]", (1 << 20) + 1, "]]}"),
        ),
        (
            "2^19 and one rails of a point",
            RULED_SURFACE,
            counted("{\"directrices\":[", "[[0,0,0]]", (1 << 19) + 1, "]}"),
        ),
        ("2^21 and one knots", UNIFORM_MESH, counted(KNOTS, "0", (1 << 21) + 1, "]}}}")),
        // These are just not refused before they are read.
        ("padded cables of a net", CABLE_NET, repeated(&format!("{NET}\"cables\":["), padded("{}", 56), "]}")),
        ("padded rails of a point", RULED_SURFACE, repeated("{\"directrices\":[", padded("[[0,0,0]]", 38), "]}")),
        (
            "padded supports",
            CABLE_NET,
            repeated("{\"vertices\":[[0,0,0],[1,0,0]],\"edges\":[[0,1]],\"supports\":[", padded("0", 4), "]}"),
        ),
        (
            "padded edges",
            CABLE_NET,
            repeated("{\"vertices\":[[0,0,0],[1,0,0]],\"supports\":[0],\"edges\":[", padded("[0,1]", 8), "]}"),
        ),
        (
            "padded triangles",
            MINIMAL_SURFACE,
            repeated(
                &in_film("\"initial_mesh\":{\"vertices\":[[0,0,0],[1,0,0],[1,1,0]],\"triangles\":["),
                padded("[0,0,0]", 12),
                "]}}",
            ),
        ),
        (
            "padded vertices of loads",
            CABLE_NET,
            repeated(&format!("{NET}\"loads\":[{{\"force\":[0,0,1],\"vertices\":["), padded("9", 4), "]}]}"),
        ),
        ("padded knots", UNIFORM_MESH, repeated(KNOTS, padded("0", 4), "]}}}")),
        ("padded points of zeros", MINIMAL_SURFACE, repeated("{\"boundaries\":[[", padded("[0,0,0]", 14), "]]}")),
        ("fixed points", MINIMAL_SURFACE, repeated(&in_film("\"constraints\":{\"points\":["), same("[0,0,0]"), "]}}")),
        (
            "as many points as are allowed",
            MINIMAL_SURFACE,
            Box::new(move || {
                let points: Vec<String> = (0..200_000).map(point).collect();
                format!("{{\"boundaries\":[[{}]],\"a\":\"{}\"}}", points.join(","), "a".repeat(BODY_BYTES / 2))
            }),
        ),
    ]
}

fn of_other_kinds() -> Vec<Bomb> {
    vec![
        ("single points as directrices", RULED_SURFACE, repeated("{\"directrices\":[", same("[[0,0,0]]"), "]}")),
        (
            "normals",
            RULED_SURFACE,
            repeated("{\"directrices\":[[[0,0,0],[1,0,0]],[[0,1,0],[1,1,0]]],\"normals\":[", same("[]"), "]}"),
        ),
        (
            "edges",
            CABLE_NET,
            repeated("{\"vertices\":[[0,0,0],[1,0,0]],\"supports\":[0],\"edges\":[", same("[0,1]"), "]}"),
        ),
        ("cables of a net", CABLE_NET, repeated(&format!("{NET}\"cables\":["), same("{}"), "]}")),
        (
            "loads of nothing",
            CABLE_NET,
            repeated(&format!("{NET}\"loads\":["), same("{\"vertices\":[0],\"force\":[0,0,0]}"), "]}"),
        ),
        (
            "supports",
            CABLE_NET,
            repeated("{\"vertices\":[[0,0,0],[1,0,0]],\"edges\":[[0,1]],\"supports\":[", same("0"), "]}"),
        ),
        (
            "cables of a film",
            TENSILE_STRUCTURE,
            repeated(&in_film("\"film\":{\"tension\":1},\"cables\":["), same("{}"), "]}"),
        ),
        (
            "joints",
            TENSILE_STRUCTURE,
            repeated(&in_film("\"film\":{\"tension\":1},\"joints\":["), same("[0,0,0]"), "]}"),
        ),
        (
            "holes of a polygon",
            UNIFORM_MESH,
            repeated(
                "{\"edge_length\":1,\"domain\":{\"polygon\":[[0,0,0],[1,0,0],[1,1,0]],\"holes\":[",
                same("[]"),
                "]}}",
            ),
        ),
        ("knots", UNIFORM_MESH, repeated(KNOTS, same("0"), "]}}}")),
    ]
}

fn of_batches_and_repeated_bodies() -> Vec<Bomb> {
    vec![
        ("empty requests", Reader::Batch, repeated("{\"requests\":[", same("{}"), "]}")),
        ("numbers in place of requests", Reader::Batch, repeated("{\"requests\":[", same("1"), "]}")),
        ("small requests", Reader::Batch, repeated("{\"requests\":[", same("{\"kind\":\"cable_net\"}"), "]}")),
        ("members of a batch", Reader::Batch, repeated("{", member, "}")),
        (
            "members of a request of a batch",
            Reader::Batch,
            repeated("{\"requests\":[{\"kind\":\"minimal_surface\",\"metadata\":{", member, "}}]}"),
        ),
        ("members of a repeated body", Reader::Hash, repeated("{", member, "}")),
        ("lists of a repeated body", Reader::Hash, repeated("[", same("[]"), "]")),
    ]
}

#[cfg(feature = "hops")]
fn of_hops() -> Vec<Bomb> {
    const MESSAGE: &str = "{\"pointer\":\"cable-net\",\"values\":[";
    const POINTS: &str = "{\"ParamName\":\"Supports\",\"InnerTree\":{\"{0}\":[";
    vec![
        ("empty values of Hops", Reader::Hops, repeated(&format!("{MESSAGE}{POINTS}"), same("{}"), "]}}]}")),
        ("nulls of Hops", Reader::Hops, repeated(&format!("{MESSAGE}{POINTS}"), same("{\"data\":\"null\"}"), "]}}]}")),
        ("texts of Hops", Reader::Hops, repeated(&format!("{MESSAGE}{POINTS}"), same("{\"data\":\"\"}"), "]}}]}")),
        ("unknown inputs of Hops", Reader::Hops, repeated(MESSAGE, same("{\"ParamName\":\"\"}"), "]}")),
    ]
}

#[cfg(feature = "mcp")]
fn of_mcp() -> Vec<Bomb> {
    const CALL: &str = "{\"jsonrpc\":\"2.0\",\"id\":1,\"method\":\"tools/call\",\"params\":{\"name\":\"solve\",\"arguments\":{\"request\":{";
    vec![
        ("members of a call", Reader::Mcp, repeated(CALL, member, "}}}}")),
        ("points of a call", Reader::Mcp, repeated(&format!("{CALL}\"boundaries\":[["), point, "]]}}}}")),
        (
            "a long text of a call",
            Reader::Mcp,
            Box::new(|| format!("{CALL}\"label\":\"{}\"}}}}}}}}", "a".repeat(BODY_BYTES))),
        ),
    ]
}

fn bombs() -> Vec<Bomb> {
    let mut bombs = of_films();
    bombs.extend(at_the_limits_of_the_count());
    bombs.extend(of_other_kinds());
    bombs.extend(of_batches_and_repeated_bodies());
    #[cfg(feature = "hops")]
    bombs.extend(of_hops());
    #[cfg(feature = "mcp")]
    bombs.extend(of_mcp());
    bombs
}

/// Returns the peak of the memory that is allocated while a body is read, with the body itself.
fn peak_bytes(reader: Reader, body: &str) -> u64 {
    allocation_counter::measure(|| reader.read(body.as_bytes())).bytes_max + body.len() as u64
}

#[test]
fn no_body_takes_many_times_its_length_while_it_is_read() {
    let bombs = bombs();
    assert!(bombs.len() >= 30);
    // The first bodies of each kind build the schemas, which stay.
    for (_, reader, _) in &bombs {
        reader.read(b"{}");
    }
    // The first tier takes a quarter of the shapes, because a body of 8 MiB is read for a second without optimisation.
    let step = if std::env::var_os("PLATEAU_FULL").is_some() { 1 } else { 4 };
    let mut above = Vec::new();
    for (name, reader, body) in bombs.into_iter().step_by(step) {
        let body = body();
        assert!(body.len() >= BODY_BYTES / 2, "{name}");
        let times = peak_bytes(reader, &body) as f64 / body.len() as f64;
        println!("{times:5.2}  {name} ({reader:?}, {} bytes)", body.len());
        if times > MOST {
            above.push(format!("{name}: {times:.2}"));
        }
    }
    assert!(above.is_empty(), "{above:#?}");
}
