//! Files of drawings, read back.

use crate::patterns::{make, options, pieces};
use crate::samples::all;
use plateau_drawing::figure::Shape;
use plateau_drawing::options::Layer;
use plateau_drawing::polygon;
use plateau_mesh::DVec2;

/// Returns a DXF file as pairs of group code and value.
pub fn dxf_pairs(file: &[u8]) -> Vec<(u16, String)> {
    let text = std::str::from_utf8(file).unwrap();
    let lines: Vec<&str> = text.lines().collect();
    lines.chunks(2).map(|pair| (pair[0].trim().parse().unwrap(), pair[1].to_owned())).collect()
}

/// Returns the entities of a DXF file: kind, layer, and the numbers of codes 10, 11, 20 and 21.
fn entities(pairs: &[(u16, String)]) -> Vec<(String, String, Vec<f64>)> {
    let at = |code: u16, value: &str| pairs.iter().position(|(c, v)| *c == code && v == value).unwrap();
    let entities = &pairs[at(2, "ENTITIES")..at(2, "OBJECTS") - 1];
    let starts: Vec<usize> = (0..entities.len()).filter(|&i| entities[i].0 == 0).collect();
    let described = |range: &[usize]| {
        let fields = &entities[range[0]..range[1]];
        let layer = fields.iter().find(|(code, _)| *code == 8).map(|(_, layer)| layer.clone()).unwrap_or_default();
        let numbers = fields.iter().filter(|(c, _)| matches!(c, 10..=11 | 20..=21)).map(|(_, v)| v.parse().unwrap());
        (fields[0].1.clone(), layer, numbers.collect())
    };
    starts.windows(2).map(described).collect()
}

#[test]
fn areas_read_back_from_dxf_and_svg_are_those_of_the_pieces_in_square_millimetres() {
    for (name, archive) in all() {
        let expected: Vec<f64> = pieces(&archive).iter().map(|piece| 1e6 * polygon::area(&piece.outline)).collect();
        let pairs = dxf_pairs(&make(&archive, "format=dxf").unwrap());
        let units = pairs.iter().position(|(_, value)| value == "$INSUNITS").unwrap();
        assert_eq!(pairs[units + 1], (70, "4".into()));
        let cuts: Vec<f64> = entities(&pairs)
            .iter()
            .filter(|(kind, layer, _)| kind == "LWPOLYLINE" && layer == "CUT")
            .map(|(_, _, numbers)| {
                let points: Vec<DVec2> = numbers.chunks(2).map(|pair| DVec2::new(pair[0], pair[1])).collect();
                polygon::area(&points)
            })
            .collect();
        // The contours in the operators of the PDF: moves and lines up to the operator that closes the path.
        let pdf = make(&archive, "format=pdf").unwrap();
        let pdf = String::from_utf8_lossy(&pdf).into_owned();
        assert!(pdf.contains("q 2.834645669291339 0 0 2.834645669291339 0 0 cm"), "72 points are 25.4 mm");
        let (mut in_pdf, mut path): (Vec<f64>, Vec<DVec2>) = (Vec::new(), Vec::new());
        for line in pdf.lines() {
            let words: Vec<&str> = line.split(' ').collect();
            match words.as_slice() {
                [x, y, operator @ ("m" | "l")] => {
                    if *operator == "m" {
                        path.clear();
                    }
                    path.push(DVec2::new(x.parse().unwrap(), y.parse().unwrap()));
                }
                ["s"] => in_pdf.push(polygon::area(&path)),
                _ => {}
            }
        }
        assert_eq!(in_pdf.len(), expected.len(), "{name}");
        assert!(in_pdf.iter().zip(&expected).all(|(one, other)| (one - other).abs() < 1e-6), "{name} {in_pdf:?}");
        let svg = String::from_utf8(make(&archive, "").unwrap()).unwrap();
        let paths: Vec<f64> = svg
            .lines()
            .filter_map(|line| line.strip_prefix(r#"<path class="cut" d="M"#)?.strip_suffix(r#"Z"/>"#))
            .map(|path| {
                let point = |pair: &str| {
                    let (x, y) = pair.split_once(',').unwrap();
                    DVec2::new(x.parse().unwrap(), -y.parse::<f64>().unwrap())
                };
                polygon::area(&path.split('L').map(point).collect::<Vec<_>>())
            })
            .collect();
        assert_eq!((cuts.len(), paths.len()), (expected.len(), expected.len()), "{name}");
        for (k, &area) in expected.iter().enumerate() {
            assert!(
                (cuts[k] - area).abs() < 1e-6 && (paths[k] - area).abs() < 1e-6,
                "{name} {area} {cuts:?} {paths:?}"
            );
        }
    }
}

/// A reader refuses a file if two objects have the same handle, or if the seed would lead to that.
#[test]
fn dxf_handles_are_unique_and_below_the_seed() {
    let (_, archive) = all().remove(4);
    let pairs = dxf_pairs(&make(&archive, "format=dxf&angles=true&notches=100&allowance=10").unwrap());
    let seed_at = pairs.iter().position(|(_, value)| value == "$HANDSEED").unwrap();
    let hex = |text: &str| u32::from_str_radix(text, 16).unwrap();
    let seed = hex(&pairs[seed_at + 1].1);
    let mut handles: Vec<u32> =
        pairs.iter().skip(seed_at + 2).filter(|(code, _)| matches!(code, 5 | 105)).map(|(_, v)| hex(v)).collect();
    assert!(handles.iter().all(|&handle| handle < seed));
    let count = handles.len();
    handles.sort_unstable();
    handles.dedup();
    assert_eq!(handles.len(), count);
    // Every entity lies on a layer of the table.
    let layers: Vec<&String> =
        pairs.windows(5).filter(|five| five[0].1 == "AcDbLayerTableRecord").map(|five| &five[1].1).collect();
    for (kind, layer, _) in entities(&pairs) {
        assert!(layers.contains(&&layer), "{kind} {layer}");
    }
}

#[test]
fn the_same_result_and_query_give_the_same_bytes() {
    for query in [
        "angles=true",
        "format=dxf&notches=90",
        "format=json&notches=90",
        "format=pdf&paper=a3",
        "profile=cut&format=dxf&kerf=0.1",
    ] {
        let files = [(); 2].map(|()| make(&all().remove(3).1, query).unwrap());
        assert_eq!(files[0], files[1], "{query}");
    }
}

/// Returns the names of the tiles that something is drawn on, or that lie inside a piece.
fn used_tiles(archive: &plateau_archive::Archive, tile: DVec2, [columns, rows]: [usize; 2]) -> Vec<String> {
    let options = options("format=pdf");
    let figures = plateau_drawing::divide::of_result(archive.contents(), &options).unwrap();
    let drawing = plateau_drawing::drawing::stacked(&figures, &options, "", "");
    let shapes: Vec<&Shape> = drawing.groups.iter().flat_map(|group| &group.shapes).collect();
    let ring = |points: &[DVec2]| (0..points.len()).map(|k| [points[k], points[(k + 1) % points.len()]]).collect();
    let is_used = |low: DVec2| {
        let middle = low + 0.5 * tile;
        shapes.iter().any(|shape| {
            let (edges, is_cut): (Vec<[DVec2; 2]>, _) = match shape {
                Shape::Polygon { layer, points } => {
                    (ring(points), *layer == Layer::Cut && polygon::contains(points, middle))
                }
                Shape::Line { ends, .. } => (vec![*ends], false),
                Shape::Text { text, spot, .. } => (ring(&plateau_drawing::label::corners(spot, text)), false),
            };
            is_cut || edges.iter().any(|&edge| enters(edge, [low, low + tile]))
        })
    };
    let mut names = Vec::new();
    for (row, column) in (0..rows).flat_map(|row| (0..columns).map(move |column| (row, column))) {
        if is_used(DVec2::new(column as f64, (rows - 1 - row) as f64) * tile) {
            names.push(format!("(row {} of {rows}, column {} of {columns})", row + 1, column + 1));
        }
    }
    names
}

/// Whether a segment enters a box, after Liang and Barsky.
fn enters([a, b]: [DVec2; 2], [low, high]: [DVec2; 2]) -> bool {
    let (mut from, mut to) = (0.0_f64, 1.0_f64);
    let along = b - a;
    for (start, step, low, high) in [(a.x, along.x, low.x, high.x), (a.y, along.y, low.y, high.y)] {
        if step == 0.0 {
            if start < low || start > high {
                return false;
            }
            continue;
        }
        let (one, other) = ((low - start) / step, (high - start) / step);
        from = from.max(one.min(other));
        to = to.min(one.max(other));
    }
    from <= to
}

#[test]
fn tiles_cover_the_drawing_and_join_at_their_frames() {
    let (_, archive) = all().remove(4);
    let whole = String::from_utf8_lossy(&make(&archive, "format=pdf").unwrap()).into_owned();
    let size = |text: &str| -> Vec<f64> {
        let at = text.find("/MediaBox [").unwrap();
        let text = &text[at + 11..at + text[at..].find(']').unwrap()];
        text.split(' ').map(|number| number.parse::<f64>().unwrap() * 25.4 / 72.0).collect()
    };
    let page = size(&whole);
    for (paper, width, height) in [("a4", 210.0, 297.0), ("a3", 297.0, 420.0)] {
        let tiled = make(&archive, &format!("format=pdf&paper={paper}")).unwrap();
        let tiled = String::from_utf8_lossy(&tiled).into_owned();
        let own = size(&tiled);
        assert!((own[2] - width).abs() < 1e-4 && (own[3] - height).abs() < 1e-4, "{own:?}");
        let count = |drawing: f64, tile: f64| ((drawing - 20.0) / (tile - 20.0) - 1e-6).ceil() as usize;
        let (columns, rows) = (count(page[2], width), count(page[3], height));
        let names = used_tiles(&archive, DVec2::new(width, height) - 20.0, [columns, rows]);
        assert_eq!(tiled.matches("/Type /Page\n").count(), names.len());
        assert!(names.iter().all(|name| tiled.contains(name)) && names.len() < columns * rows, "{names:?}");
        // A line that crosses frames has the same slope on each tile: its start moves by whole tiles.
        let starts = |text: &str| -> Vec<DVec2> {
            let dash = text.lines().filter(|line| line.starts_with("0.69 0 0.13 RG"));
            dash.map(|line| line.split(' ').collect::<Vec<_>>())
                .map(|words| {
                    let m = words.iter().position(|word| *word == "m").unwrap();
                    DVec2::new(words[m - 2].parse().unwrap(), words[m - 1].parse().unwrap())
                })
                .collect()
        };
        let reference = starts(&whole);
        let found = starts(&tiled);
        assert!(found.len() >= reference.len() && !reference.is_empty());
        for start in found {
            let near = |one: &DVec2| {
                let steps = (*one - start) / DVec2::new(width - 20.0, height - 20.0);
                (steps - steps.round()).abs().max_element() < 1e-9
            };
            assert!(reference.iter().any(near), "{start}");
        }
    }
}
