//! Strips that are cut to fit, and pieces on sheets.

use crate::files::dxf_pairs;
use crate::patterns::{make, options, refused};
use crate::samples::{all, ring, ruled, wavy};
use plateau_archive::Archive;
use plateau_drawing::divide::of_result;
use plateau_drawing::figure::{Figure, Shape};
use plateau_drawing::label::corners;
use plateau_drawing::options::Layer;
use plateau_drawing::polygon;
use plateau_mesh::{DVec2, DVec3};
use plateau_ruled_surface::{Objective, Options};
use serde_json::Value;

/// Returns a strip of 2 x 12 m with waves, in metres.
fn long_strip() -> Archive {
    let stretched =
        |y: f64, phase: f64| wavy(41, y, phase).into_iter().map(|p| DVec3::new(6.0 * p.x, p.y, p.z)).collect();
    ruled(
        &[stretched(0.0, 0.0), stretched(1.0, 0.7)],
        &Options { objective: Objective::MinimalBendingEnergy, ..Options::default() },
    )
}

/// Returns a helical ramp of two and a half turns, whose pattern overlaps itself.
fn ramp() -> Archive {
    let rail = |radius: f64| -> Vec<DVec3> {
        let angle = |k: u32| 2.5 * std::f64::consts::TAU * f64::from(k) / 100.0;
        let point = |k: u32| DVec3::new(radius * angle(k).cos(), radius * angle(k).sin(), 0.02 * angle(k));
        (0..=100).map(point).collect()
    };
    ruled(&[rail(1.0), rail(1.5)], &Options::default())
}

fn figures(archive: &Archive, query: &str) -> Vec<Figure> {
    of_result(archive.contents(), &options(query)).unwrap()
}

fn area(figures: &[Figure]) -> f64 {
    figures.iter().map(|figure| polygon::area(&figure.cut)).sum()
}

/// Returns the numbers that are printed at the ends of pieces.
fn printed_mates(figures: &[Figure]) -> Vec<u32> {
    let text = |shape: &Shape| match shape {
        Shape::Text { text, .. } => text.strip_prefix("bridge ")?.parse().ok(),
        _ => None,
    };
    let mut numbers: Vec<u32> = figures.iter().flat_map(|figure| &figure.shapes).filter_map(text).collect();
    numbers.sort_unstable();
    numbers
}

#[test]
fn strips_are_cut_at_bridges_until_they_are_short_enough_and_mates_have_one_number() {
    let archive = long_strip();
    let whole = figures(&archive, "");
    assert_eq!((whole.len(), printed_mates(&whole)), (1, vec![]));
    for (query, longest) in [("max_length=3000", 3000.0), ("sheet=2500,1500", 2500.0), ("max_length=2400", 2400.0)] {
        let parts = figures(&archive, query);
        let length = |figure: &Figure| {
            let [low, high] = figure.bounds();
            (high - low).x
        };
        assert!(parts.iter().all(|part| length(part) <= longest * (1.0 + 1e-9)), "{query}");
        // No part is much shorter than allowed, except the last one.
        let shortest = parts[..parts.len() - 1].iter().map(length).fold(f64::INFINITY, f64::min);
        assert!(shortest > 0.5 * longest, "{query}: {shortest}");
        assert!((area(&parts) - area(&whole)).abs() < 1e-6, "{query}");
        assert_eq!(parts[1].name, "strip 1-2");
        // Both sides of each cut have its number, and the same cuts named by hand give the same pieces.
        let numbers = printed_mates(&parts);
        assert_eq!(numbers.len(), 2 * (parts.len() - 1), "{query}");
        assert!(numbers.chunks(2).all(|pair| pair[0] == pair[1]), "{numbers:?}");
        let cuts: Vec<String> = numbers.chunks(2).map(|pair| pair[0].to_string()).collect();
        let by_hand = figures(&archive, &format!("cut_at={}", cuts.join(",")));
        assert!(by_hand.iter().map(|part| &part.cut).eq(parts.iter().map(|part| &part.cut)), "{query}");
    }
    // The allowance counts.
    let wide = figures(&archive, "max_length=3000&allowance=100");
    let lengths = wide.iter().map(Figure::bounds).map(|[low, high]| (high - low).x);
    assert!(lengths.fold(0.0, f64::max) <= 3000.0 * (1.0 + 1e-9));
    // A closed strip opens where it is cut.
    let (_, duct) = all().remove(3);
    let (whole, parts) = (figures(&duct, ""), figures(&duct, "max_length=1500"));
    assert!(parts.len() > 2 && (area(&parts) - area(&whole)).abs() < 1e-6);
    assert_eq!(printed_mates(&parts).len(), 2 * parts.len());
}

#[test]
fn a_strip_that_overlaps_itself_is_cut() {
    let archive = ramp();
    for query in ["", "profile=cut", "format=json&allowance=10", "profile=sheet-metal&thickness=1&radius=1&relief=auto"]
    {
        let parts = figures(&archive, query);
        assert!(parts.len() > 2, "{query}: {}", parts.len());
        assert!(parts.iter().all(|part| polygon::crossing(&part.cut).is_none()), "{query}");
    }
    let mesh = &archive.contents().mesh;
    let solid: f64 =
        mesh.triangles.iter().map(|&t| mesh.corners(t)).map(|[a, b, c]| 0.5 * (b - a).cross(c - a).length()).sum();
    assert!((area(&figures(&archive, "")) - 1e6 * solid).abs() < 1e-3);
}

/// Returns the outlines of the pieces by sheet, from the JSON.
fn on_sheets(value: &Value) -> Vec<Vec<Vec<DVec2>>> {
    let mut sheets = vec![Vec::new(); value["sheets"].as_array().unwrap().len()];
    for piece in value["pieces"].as_array().unwrap() {
        let point = |p: &Value| DVec2::new(p[0].as_f64().unwrap(), p[1].as_f64().unwrap());
        let outline = piece["outline"].as_array().unwrap().iter().map(point).collect();
        sheets[piece["sheet"].as_u64().unwrap() as usize].push(outline);
    }
    sheets
}

/// Returns the smallest distance between the boxes of two pieces on one sheet, and the farthest reach beyond the sheet.
fn clearances(sheets: &[Vec<Vec<DVec2>>], size: DVec2) -> (f64, f64) {
    let (mut nearest, mut beyond) = (f64::INFINITY, f64::NEG_INFINITY);
    for pieces in sheets {
        let boxes: Vec<[DVec2; 2]> = pieces
            .iter()
            .map(|points| points.iter().fold([DVec2::INFINITY, -DVec2::INFINITY], |[a, b], p| [a.min(*p), b.max(*p)]))
            .collect();
        for (k, [low, high]) in boxes.iter().enumerate() {
            beyond = beyond.max((-*low).max_element()).max((*high - size).max_element());
            for [other_low, other_high] in &boxes[..k] {
                nearest = nearest.min((*low - *other_high).max(*other_low - *high).max_element());
            }
        }
    }
    (nearest, beyond)
}

#[test]
fn pieces_lie_on_sheets_with_their_gap_and_the_figures_say_how_much_is_used() {
    let archives = [long_strip(), ramp(), all().remove(4).1, all().remove(6).1];
    for archive in &archives {
        for (query, size, gap) in [
            ("sheet=2500,2000", DVec2::new(2500.0, 2000.0), 5.0),
            ("sheet=3000,2200&gap=40&rotate=free&allowance=10", DVec2::new(3000.0, 2200.0), 40.0),
            ("sheet=2400,1700&gap=0&kerf=2", DVec2::new(2400.0, 1700.0), 0.0),
        ] {
            let value: Value =
                serde_json::from_slice(&make(archive, &format!("format=json&{query}")).unwrap()).unwrap();
            let sheets = on_sheets(&value);
            let (nearest, beyond) = clearances(&sheets, size);
            assert!(nearest >= gap - 1e-6 && beyond <= 1e-5, "{query}: {nearest} {beyond}");
            assert!(sheets.iter().all(|pieces| !pieces.is_empty()));
            let area: f64 = sheets.iter().flatten().map(|outline| polygon::area(outline)).sum();
            let used = area / (size.x * size.y * sheets.len() as f64);
            assert!((value["utilisation"].as_f64().unwrap() - used).abs() < 1e-12, "{query}");
            assert_eq!(value["unplaced"], serde_json::json!([]));
            // A fault: a piece that is moved by a millimetre into its gap, or over its neighbour.
            let mut moved = sheets.clone();
            if let Some(pieces) = moved.iter_mut().find(|pieces| pieces.len() > 1) {
                let lift = pieces.len() - 1;
                let shift = pieces[0][0] - pieces[lift][0];
                pieces[lift].iter_mut().for_each(|point| *point += shift);
                assert!(clearances(&moved, size).0 < gap - 0.5, "{query}");
            }
        }
    }
    // Without sheets there are none.
    let value: Value = serde_json::from_slice(&make(&archives[0], "format=json").unwrap()).unwrap();
    let piece = &value["pieces"][0];
    assert_eq!((&value["sheets"], &value["utilisation"]), (&serde_json::json!([]), &Value::Null));
    assert_eq!((&piece["sheet"], &piece["turned_deg"]), (&Value::Null, &Value::Null));
}

#[test]
fn a_piece_is_turned_only_where_its_grain_may_be() {
    // 2000 x 400 mm, for sheets of 500 x 2100 mm.
    let rail = |y: f64| vec![DVec3::new(0.0, y, 0.0), DVec3::new(2.0, y, 0.0)];
    let archive = ruled(&[rail(0.0), rail(0.4)], &Options::default());
    let json = |query: &str| -> Value { serde_json::from_slice(&make(&archive, query).unwrap()).unwrap() };
    let free = json("format=json&sheet=500,2100&rotate=free");
    assert_eq!((free["pieces"][0]["turned_deg"].as_f64(), free["pieces"].as_array().unwrap().len()), (Some(90.0), 1));
    assert_eq!(free["sheets"][0]["size"], serde_json::json!({ "width": 400.0, "height": 2000.0 }));
    assert_eq!(refused(make(&archive, "sheet=500,2100")), (false, vec!["sheet".into()]));
    // The texts of a turned piece are read from below or from the right, and the grain is not drawn.
    let svg = String::from_utf8(make(&archive, "sheet=500,2100&rotate=free").unwrap()).unwrap();
    assert!(svg.contains("rotate(-90.0)") && !svg.contains(r#"class="grain""#), "{svg}");
    let svg = String::from_utf8(make(&archive, "sheet=2100,500").unwrap()).unwrap();
    assert!(svg.contains(r#"class="grain""#) && svg.contains(r#"<path class="sheet""#));
    assert!(svg.contains(">sheets: 1 of 2100 x 500 mm, 76.2 % used<"), "{svg}");
}

#[test]
fn the_grain_runs_along_the_sheet_inside_each_piece_and_texts_are_clear_of_it() {
    for archive in [long_strip(), ramp(), all().remove(4).1] {
        for figure in figures(&archive, "sheet=2500,2000&angles=true") {
            let grain: Vec<[DVec2; 2]> = figure
                .shapes
                .iter()
                .filter_map(|shape| match shape {
                    Shape::Line { layer: Layer::Grain, ends, .. } => Some(*ends),
                    _ => None,
                })
                .collect();
            let [[from, to]] = grain[..] else { panic!("{}: {grain:?}", figure.name) };
            assert!(from.y == to.y && from.x < to.x);
            let inside = |part: u32| polygon::contains(&figure.cut, from.lerp(to, f64::from(part) / 20.0));
            assert!((0..=20).all(inside), "{}", figure.name);
            for shape in &figure.shapes {
                let Shape::Text { text, spot, .. } = shape else { continue };
                let corners = corners(spot, text);
                let side = |a: DVec2, b: DVec2, c: DVec2| (b - a).perp_dot(c - a);
                for k in 0..4 {
                    let (a, b) = (corners[k], corners[(k + 1) % 4]);
                    let crosses =
                        side(a, b, from) * side(a, b, to) < 0.0 && side(from, to, a) * side(from, to, b) < 0.0;
                    assert!(!crosses, "{}: {text}", figure.name);
                }
            }
        }
    }
}

#[test]
fn cut_lines_on_sheets_are_one_file_a_sheet_of_the_sheets_size() {
    let archive = long_strip();
    let value: Value = serde_json::from_slice(&make(&archive, "format=json&sheet=2500,1200").unwrap()).unwrap();
    let count = value["sheets"].as_array().unwrap().len();
    let pieces = value["pieces"].as_array().unwrap().len();
    assert!(count > 1 && pieces > 4);
    let bytes = make(&archive, "profile=cut&sheet=2500,1200").unwrap();
    let text = String::from_utf8_lossy(&bytes);
    assert_eq!((text.matches("<svg ").count(), text.matches(r#"<path class="cut""#).count()), (count, pieces));
    assert!(text.contains("sheet 2.svg") && !text.contains(r#"class="sheet""#));
    // A margin of 2% of the larger side is around the sheet.
    assert_eq!(text.matches(r#"width="2600.0mm" height="1300.0mm""#).count(), count);
    let dxf = make(&archive, "format=dxf&sheet=2500,1200").unwrap();
    let pairs = dxf_pairs(&dxf);
    assert_eq!(pairs.iter().filter(|pair| **pair == (8, "SHEET".to_owned())).count(), count);
}

#[test]
fn equal_pieces_are_one_kind_and_mirror_images_are_two() {
    let kinds = |archive: &Archive, query: &str| -> u64 {
        let value: Value = serde_json::from_slice(&make(archive, query).unwrap()).unwrap();
        value["kinds"].as_u64().unwrap()
    };
    // Three flat strips between lines at equal distances, then one of another width.
    let line = |y: f64| vec![DVec3::new(0.0, y, 0.0), DVec3::new(2.0, y, 0.0)];
    let options = Options::default();
    assert_eq!(kinds(&ruled(&[0.0, 1.0, 2.0, 3.0].map(line), &options), "format=json"), 1);
    assert_eq!(kinds(&ruled(&[0.0, 1.0, 2.0, 3.1].map(line), &options), "format=json"), 2);
    // A strip between two strips that are its mirror images: trapezoids without any symmetry of their own.
    let shape = |y: f64, shift: f64| vec![DVec3::new(shift, y, 0.0), DVec3::new(3.0 + 0.5 * shift, y, 0.0)];
    let mirrored = [shape(0.0, 0.0), shape(1.0, 1.0), shape(2.0, 0.0)];
    assert_eq!(kinds(&ruled(&mirrored, &options), "format=json"), 2);
    let turned = [shape(0.0, 0.0), shape(1.0, 1.0), shape(2.0, 2.0)];
    assert_eq!(kinds(&ruled(&turned, &options), "format=json"), 2, "the second is narrower");
    // A regular duct of twelve sides, cut into equal parts.
    let closed = Options { closed: true, objective: Objective::MinimalBendingEnergy, ..Options::default() };
    let duct = ruled(&[ring(12, 0.5, 0.0, 0.0), ring(12, 0.5, 1.0, 0.0)], &closed);
    assert_eq!(kinds(&duct, "format=json&cut_at=0,8,16"), 1);
    assert_eq!(kinds(&duct, "format=json&cut_at=0,8,14"), 3);
}

#[test]
fn sheets_that_do_not_suit_are_named() {
    let archive = long_strip();
    for query in ["sheet=1000", "sheet=0,5", "sheet=1e9,5", "sheet=-3,5", "sheet=nan,5", "sheet=3000,1500,2"] {
        assert_eq!(refused(make(&archive, query)), (true, vec!["sheet".into()]), "{query}");
    }
    for (query, parameter) in [
        ("gap=5", "gap"),
        ("rotate=free", "rotate"),
        ("sheet=3000,1500&gap=-1", "gap"),
        ("sheet=3000,1500&rotate=90", "rotate"),
        ("sheet=3000,1500&split=pieces", "split"),
        ("max_length=0", "max_length"),
    ] {
        assert_eq!(refused(make(&archive, query)), (true, vec![parameter.into()]), "{query}");
    }
    // A sheet that is smaller than the strip is wide, one that is shorter than a triangle, and a cap, which is not cut.
    for (query, parameter) in
        [("sheet=3000,500", "sheet"), ("sheet=100,2000", "sheet"), ("max_length=50", "max_length")]
    {
        assert_eq!(refused(make(&archive, query)), (false, vec![parameter.into()]), "{query}");
    }
    let (_, capped) = all().remove(4);
    assert_eq!(refused(make(&capped, "max_length=700")), (false, vec!["max_length".into()]));
    assert_eq!(refused(make(&capped, "sheet=1100,2000")), (false, vec!["sheet".into()]));
    // A wrong radius is refused as such, not taken for a reason to cut at every bend.
    let metal = "profile=sheet-metal&thickness=1&radius=2000&sheet=3000,2000";
    assert_eq!(refused(make(&capped, metal)), (false, vec!["radius".into()]));
}

#[test]
fn folds_of_180_degrees_are_named_on_the_drawing() {
    let rail = |y: f64| [[0.0, 0.0], [1.0, 0.0], [0.2, 0.0]].map(|[x, z]| DVec3::new(x, y, z)).to_vec();
    let svg = make(&ruled(&[rail(0.0), rail(1.0)], &Options::default()), "").unwrap();
    let svg = String::from_utf8(svg).unwrap();
    assert!(svg.contains(">warning: strip 1, bridge "), "{svg}");
    let svg = make(&long_strip(), "").unwrap();
    assert!(!String::from_utf8(svg).unwrap().contains("warning"));
}
