//! Objects of openNURBS: those that rhino3dm has encoded are read, those that this program writes are read again, and
//! damaged bytes are refused without a panic and without much memory or time.
//!
//! `objects.json` was written once with rhino3dm 8.35.0. It has each object with points that rhino3dm finds
//! on it. `PLATEAU_LONG=1` damages a hundred times as many objects. `PLATEAU_SEED` damages other bytes.

#![allow(
    clippy::disallowed_macros,
    clippy::disallowed_methods,
    clippy::disallowed_types,
    clippy::too_many_lines,
    reason = "tests"
)]
#![allow(unsafe_code, reason = "an allocator that counts is unsafe to implement")]

use plateau_mesh::DVec3;
use plateau_mesh::random::SplitMix64;
use plateau_opennurbs::curve::{Curve, Nurbs};
use plateau_opennurbs::{Defect, Mesh, Object, read, write};
use serde_json::Value;
use std::alloc::{GlobalAlloc, Layout, System};
use std::cell::Cell;
use std::collections::BTreeMap;
use std::panic::catch_unwind;
use std::time::{Duration, Instant};

/// Counts the bytes that a thread has allocated and not yet freed, and their peak.
struct Counting;

thread_local! {
    static ALLOCATED: Cell<(isize, isize)> = const { Cell::new((0, 0)) };
}

fn count(bytes: isize) {
    // Access fails while the thread ends, because its counter may already have been dropped.
    let _ = ALLOCATED.try_with(|allocated| {
        let (now, peak) = allocated.get();
        allocated.set((now + bytes, peak.max(now + bytes)));
    });
}

// SAFETY: every call is passed on to the system's allocator unchanged.
unsafe impl GlobalAlloc for Counting {
    unsafe fn alloc(&self, layout: Layout) -> *mut u8 {
        count(layout.size() as isize);
        // SAFETY: the caller keeps the promises of this function.
        unsafe { System.alloc(layout) }
    }
    unsafe fn dealloc(&self, pointer: *mut u8, layout: Layout) {
        count(-(layout.size() as isize));
        // SAFETY: the caller keeps the promises of this function.
        unsafe { System.dealloc(pointer, layout) }
    }
}

#[global_allocator]
static ALLOCATOR: Counting = Counting;

const MAX_POINTS: usize = 20_000;

fn fixtures() -> Value {
    serde_json::from_str(include_str!("objects.json")).unwrap()
}

/// Returns the members of one group of the fixtures.
fn group(name: &str) -> Vec<(String, Value)> {
    fixtures()[name].as_object().unwrap().clone().into_iter().collect()
}

fn points(value: &Value) -> Vec<DVec3> {
    let point = |point: &Value| DVec3::from_array(serde_json::from_value(point.clone()).unwrap());
    value.as_array().unwrap().iter().map(point).collect()
}

fn bytes(object: &Value) -> Vec<u8> {
    use base64::Engine as _;
    base64::engine::general_purpose::STANDARD.decode(object["data"].as_str().unwrap()).unwrap()
}

fn curve(object: &Value) -> Curve {
    match read::object(&bytes(object), MAX_POINTS) {
        Ok(Object::Curve(curve)) => curve,
        other => panic!("{other:?}"),
    }
}

fn mesh(object: &Value) -> Mesh {
    match read::object(&bytes(object), MAX_POINTS) {
        Ok(Object::Mesh(mesh)) => mesh,
        other => panic!("{other:?}"),
    }
}

fn distance(point: DVec3, polyline: &[DVec3]) -> f64 {
    let to_segment = |ends: &[DVec3]| {
        let along = ends[1] - ends[0];
        let fraction = ((point - ends[0]).dot(along) / along.length_squared().max(1e-300)).clamp(0.0, 1.0);
        point.distance(ends[0] + fraction * along)
    };
    polyline.windows(2).map(to_segment).fold(f64::INFINITY, f64::min)
}

#[test]
fn every_curve_of_rhino3dm_becomes_a_polyline_within_the_tolerance() {
    for (name, fixture) in group("curves") {
        let curve = curve(&fixture["object"]);
        let on_curve = points(&fixture["points"]);
        let rounding = 1e-9 * on_curve.iter().map(|point| point.length()).fold(1.0, f64::max);
        let mut before = 0;
        assert!(curve.default_tolerance() > 0.0);
        for tolerance in [1e-2, 1e-4, 1e-6] {
            let polyline = curve.points(tolerance, 1_000_000).unwrap();
            for &point in &on_curve {
                let off = distance(point, &polyline);
                assert!(off <= tolerance + rounding, "{name}: {off} with a tolerance of {tolerance}");
            }
            let ends = [polyline[0], *polyline.last().unwrap()];
            assert!(ends[0].distance(on_curve[0]) <= rounding && ends[1].distance(on_curve[24]) <= rounding, "{name}");
            let closed = ends[0].distance(ends[1]) <= rounding;
            assert_eq!(closed, fixture["closed"].as_bool().unwrap(), "{name}");
            assert!(polyline.windows(2).all(|pair| pair[0] != pair[1]), "{name}: a point twice");
            assert!(polyline.len() >= before, "{name}");
            before = polyline.len();
        }
    }
}

/// The points lie on the curve itself, and their number is about what the tolerance needs.
#[test]
fn a_circle_gets_as_many_points_as_its_tolerance_needs() {
    let curves = fixtures()["curves"].clone();
    let circle = |name: &str, centre: DVec3, tolerance: f64| {
        let polyline = curve(&curves[name]["object"]).points(tolerance, 1_000_000).unwrap();
        assert!(polyline.iter().all(|point| (point.distance(centre) - 2.0).abs() < 1e-8), "{name}");
        polyline.len()
    };
    let (near, far) = (DVec3::new(1.0, 2.0, 3.0), DVec3::new(1e6, 2e6, 3.0));
    // The angle of a chord is 2 acos(1 - tolerance / radius).
    assert_eq!(circle("circle", near, 1e-3), 101);
    assert_eq!(circle("circle", near, 10.0), 9);
    assert_eq!(circle("rational circle", far, 1e-3), 129);
    let tolerance = curve(&curves["circle"]["object"]).default_tolerance();
    assert_eq!(circle("circle", near, tolerance), 61);
}

#[test]
fn every_mesh_of_rhino3dm_is_read_exactly() {
    for (name, fixture) in group("meshes") {
        let mesh = mesh(&fixture["object"]);
        assert_eq!(mesh.vertices, points(&fixture["vertices"]), "{name}");
        let faces: Vec<[u32; 4]> = serde_json::from_value(fixture["faces"].clone()).unwrap();
        assert_eq!(mesh.faces, faces, "{name}");
        let few = read::object(&bytes(&fixture["object"]), mesh.vertices.len() - 1);
        assert_eq!(few, Err(Defect::TooLarge(mesh.vertices.len() - 1)), "{name}");
    }
}

#[test]
fn other_classes_are_named() {
    for (name, fixture) in group("others") {
        let Err(Defect::Unsupported(text)) = read::object(&bytes(&fixture), MAX_POINTS) else { panic!("{name}") };
        let name = name.trim_start_matches("NURBS ");
        assert_eq!(text, format!("is a {name}, and this server reads curves and meshes"));
    }
}

#[test]
fn what_is_written_is_read_again() {
    let far = |k: usize| DVec3::new(1e6 + 0.1 * k as f64, -2e6 + (k as f64).sin(), 1.0 / (k + 3) as f64);
    let line: Vec<DVec3> = (0..7).map(far).collect();
    assert_eq!(read::object(&write::polyline_curve(&line), 7), Ok(Object::Curve(Curve::Polyline(line))));
    // Indices take one, two or four bytes.
    for vertices in [3, 255, 256, 65_535, 65_536] {
        let points: Vec<DVec3> = (0..vertices).map(far).collect();
        let last = vertices as u32 - 1;
        let triangles = [[0, 1, 2], [last, 1, 0]];
        let read = read::object(&write::mesh(&points, &triangles), vertices).unwrap();
        assert_eq!(read, Object::Mesh(Mesh { vertices: points, faces: vec![[0, 1, 2, 2], [last, 1, 0, 0]] }));
    }
}

/// rhino3dm writes the same bytes for a polyline whose parameter is the number of the point.
#[test]
fn a_polyline_has_the_bytes_that_rhino3dm_writes() {
    let fixture = &fixtures()["curves"]["polyline"];
    let Curve::Polyline(points) = curve(&fixture["object"]) else { panic!("a polyline") };
    assert_eq!(write::polyline_curve(&points), bytes(&fixture["object"]));
}

#[test]
fn damaged_objects_say_what_is_wrong() {
    let line = bytes(&fixtures()["curves"]["line"]["object"]);
    assert_eq!(read::object(&line[..line.len() - 1], 2), Err(Defect::Truncated));
    let mut flipped = line.clone();
    flipped[80] ^= 1;
    assert_eq!(read::object(&flipped, 2), Err(Defect::Checksum));
    assert_eq!(read::object(b"", 2), Err(Defect::Truncated));
    let mut infinite = line;
    infinite[57..65].copy_from_slice(&f64::INFINITY.to_le_bytes());
    assert!(read::object(&infinite, 2).unwrap_err().to_string().contains("not a finite number"));
}

#[test]
fn a_curve_that_needs_too_many_points_is_refused() {
    for name in ["rational circle", "circle", "polycurve", "degree 5"] {
        let curve = curve(&fixtures()["curves"][name]["object"]);
        assert_eq!(curve.points(1e-12, 1000), Err(Defect::TooLarge(1000)), "{name}");
        // A tolerance below the rounding of the coordinates still ends.
        assert!(curve.points(1e-300, 10_000).is_err(), "{name}");
    }
}

#[test]
fn invalid_nurbs_curves_are_refused() {
    let points = |weight: f64| vec![[0.0, 0.0, 0.0, 1.0], [1.0, 1.0, 0.0, weight], [2.0, 0.0, 0.0, 1.0]];
    let of = |knots: [f64; 4], weight: f64| Nurbs::new(2, knots.to_vec(), points(weight));
    let curve = Curve::Nurbs(of([0.0, 0.0, 1.0, 1.0], 1.0).unwrap());
    assert_eq!(curve.points(1.0, 10).unwrap(), [DVec3::ZERO, DVec3::new(2.0, 0.0, 0.0)]);
    for (knots, weight) in [
        ([0.0, 0.0, 1.0, 1.0], 0.0),
        ([0.0, 0.0, 1.0, 1.0], -1.0),
        ([0.0, 0.0, 1.0, 1.0], f64::NAN),
        ([0.0, 1.0, 0.0, 1.0], 1.0),
        ([0.0, 0.0, 0.0, 1.0], 1.0),
        ([0.0, 0.0, f64::INFINITY, 1.0], 1.0),
    ] {
        assert!(matches!(of(knots, weight), Err(Defect::Unusable(_))), "{knots:?} {weight}");
    }
}

/// Recomputes the checksum of an object without inner chunks, so that damage behind it is reached.
fn reseal(bytes: &mut [u8]) {
    // The object's head, the class's chunk, the head of the data, the data with its checksum, and the end mark.
    let (first, last) = (12 + 32 + 12, bytes.len().saturating_sub(12 + 4));
    if first < last {
        let checksum = crc32fast::hash(&bytes[first..last]);
        bytes[last..last + 4].copy_from_slice(&checksum.to_le_bytes());
    }
}

fn damage(bytes: &mut Vec<u8>, other: &[u8], random: &mut SplitMix64) {
    const WORDS: [u32; 10] = [0, 1, 2, 3, 0x7fff_ffff, 0x8000_0000, 0xffff_ffff, 0x0002_7ffa, 0x4000_8000, 1 << 24];
    const NUMBERS: [f64; 8] = [0.0, -0.0, 1e-300, 1e300, f64::NAN, f64::INFINITY, -1.0, 1e15];
    let mut below = |count: usize| (random.next_u64() % count.max(1) as u64) as usize;
    let at = below(bytes.len());
    let operation = below(8);
    match operation {
        0 => bytes.truncate(at),
        1 => bytes[at] ^= 1 << below(8),
        2 => bytes[at] = below(256) as u8,
        3 if at + 4 <= bytes.len() => bytes[at..at + 4].copy_from_slice(&WORDS[below(10)].to_le_bytes()),
        4 if at + 8 <= bytes.len() => bytes[at..at + 8].copy_from_slice(&NUMBERS[below(8)].to_le_bytes()),
        5 => {
            bytes.remove(at);
        }
        6 => {
            let from = below(other.len());
            let piece = &other[from..(from + below(64)).min(other.len())];
            bytes.splice(at..at, piece.iter().copied());
        }
        _ => {
            let end = (at + below(64)).min(bytes.len());
            bytes.copy_within(at..end, at / 2);
        }
    }
}

#[test]
fn damaged_bytes_are_refused_without_a_panic_and_without_much_memory_or_time() {
    let objects: Vec<Vec<u8>> = ["curves", "meshes"]
        .iter()
        .flat_map(|name| group(name))
        .map(|(_, fixture)| bytes(&fixture["object"]))
        .collect();
    let rounds = if std::env::var_os("PLATEAU_LONG").is_some() { 2_000_000 } else { 20_000 };
    let seed = std::env::var("PLATEAU_SEED").ok().and_then(|text| text.parse().ok()).unwrap_or(20_261_122);
    let mut random = SplitMix64::new(seed);
    let mut seen = BTreeMap::new();
    for round in 0..rounds {
        let mut pick = || &objects[(random.next_u64() % objects.len() as u64) as usize];
        let (mut bytes, other) = (pick().clone(), pick());
        for _ in 0..=random.next_u64() % 3 {
            if !bytes.is_empty() {
                damage(&mut bytes, other, &mut random);
            }
        }
        if random.next_u64().is_multiple_of(2) {
            reseal(&mut bytes);
        }
        let started = Instant::now();
        ALLOCATED.with(|allocated| allocated.set((0, 0)));
        let outcome = catch_unwind(|| match read::object(&bytes, MAX_POINTS) {
            Ok(Object::Curve(curve)) => match curve.points(curve.default_tolerance(), MAX_POINTS) {
                Ok(points) if points.iter().all(|point| point.is_finite()) => "curve",
                Ok(_) => "not finite",
                Err(_) => "needs too many points",
            },
            Ok(Object::Mesh(mesh)) => {
                let exists = |&vertex: &u32| (vertex as usize) < mesh.vertices.len();
                if mesh.faces.iter().flatten().all(exists) { "mesh" } else { "no such vertex" }
            }
            Err(Defect::Checksum) => "checksum",
            Err(Defect::Truncated) => "truncated",
            Err(_) => "refused",
        });
        let peak = ALLOCATED.with(Cell::get).1;
        let shown = || bytes.iter().map(|byte| format!("{byte:02x}")).collect::<String>();
        let Ok(outcome) = outcome else { panic!("round {round}: a panic\n{}", shown()) };
        assert!(outcome != "no such vertex", "round {round}: {outcome}\n{}", shown());
        assert!(started.elapsed() < Duration::from_secs(5), "round {round}: too slow\n{}", shown());
        // Twenty thousand points of a curve take half a megabyte, and a growing list twice that.
        let most = 2 << 20;
        assert!(peak < most + 8 * bytes.len() as isize, "round {round}: {peak} bytes\n{}", shown());
        *seen.entry(outcome).or_insert(0) += 1;
    }
    println!("{seen:?}");
    for outcome in ["curve", "mesh", "checksum", "truncated", "refused"] {
        assert!(seen.get(outcome).is_some_and(|&times| times > rounds / 1000), "too few: {seen:?}");
    }
}
