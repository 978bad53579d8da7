//! Cloth by ASTM D6673.

use crate::files::dxf_pairs;
use crate::patterns::{make, pieces, refused};
use crate::samples::all;
use plateau_drawing::polygon;
use plateau_mesh::DVec2;

/// Returns the lists of pairs that begin with a pair of code 0, between two markers.
fn entities(pairs: &[(u16, String)]) -> Vec<&[(u16, String)]> {
    let starts: Vec<usize> = (0..pairs.len()).filter(|&k| pairs[k].0 == 0).collect();
    starts.windows(2).map(|pair| &pairs[pair[0]..pair[1]]).collect()
}

fn value(entity: &[(u16, String)], code: u16) -> &str {
    entity.iter().find(|(own, _)| *own == code).map_or("", |(_, value)| value.as_str())
}

fn number(entity: &[(u16, String)], code: u16) -> f64 {
    value(entity, code).parse().unwrap()
}

#[test]
fn each_piece_is_a_block_with_its_outline_on_layer_1() {
    for (name, archive) in all() {
        let file = make(&archive, "profile=astm-d6673&allowance=10&notches=150&angles=true").unwrap();
        let text = std::str::from_utf8(&file).unwrap();
        assert!(text.contains("$ACADVER\n  1\nAC1012\n") && !text.contains("INSUNITS") && !text.contains("LWPOLYLINE"));
        let pairs = dxf_pairs(&file);
        let all = entities(&pairs);
        let expected = pieces(&archive);
        let starts: Vec<usize> =
            (0..all.len()).filter(|&k| all[k][0].1 == "BLOCK" && !value(all[k], 2).starts_with('*')).collect();
        assert_eq!(starts.len(), expected.len(), "{name}");
        for (&start, piece) in starts.iter().zip(&expected) {
            let block = value(all[start], 2);
            assert_eq!(block, piece.name.to_uppercase().replace(' ', "_"));
            let end = (start..all.len()).find(|&k| all[k][0].1 == "ENDBLK").unwrap();
            let own = &all[start + 1..end];
            let on = |kind: &str, layer: &str| own.iter().filter(|e| e[0].1 == kind && value(e, 8) == layer).count();
            let outline = |layer: &str| -> Vec<DVec2> {
                let vertices = own.iter().filter(|e| e[0].1 == "VERTEX" && value(e, 8) == layer);
                vertices.map(|e| DVec2::new(number(e, 10), number(e, 20))).collect()
            };
            assert_eq!((on("POLYLINE", "1"), on("POLYLINE", "14"), on("LINE", "7")), (1, 1, 1), "{name} {block}");
            assert_eq!((outline("1"), outline("14")), (outline("84"), outline("87")));
            let sewn = polygon::area(&outline("14"));
            assert!((sewn - 1e6 * polygon::area(&piece.outline)).abs() < 1e-6, "{name} {block}");
            assert_eq!(on("POINT", "2") + on("POINT", "3"), outline("1").len());
            assert_eq!(on("LINE", "8"), piece.folds.len());
            let angles = own.iter().filter(|e| value(e, 8) == "8").map(|e| number(e, 1040));
            assert!(angles.eq(piece.folds.iter().map(|fold| fold.angle_deg)));
            // A notch points from the cut into the allowance of 10 mm and is 3 mm deep.
            let cut = outline("1");
            for notch in own.iter().filter(|e| e[0].1 == "POINT" && value(e, 8) == "4") {
                let (sine, cosine) = number(notch, 50).to_radians().sin_cos();
                let at = DVec2::new(number(notch, 10), number(notch, 20));
                assert!((number(notch, 30) - 3.0).abs() < 1e-9 && number(notch, 39) == 2.0);
                assert!(polygon::contains(&cut, at + DVec2::new(cosine, sine)), "{name} {block} {at}");
            }
            assert!(on("POINT", "4") > 0);
            let texts: Vec<&str> = own.iter().filter(|e| e[0].1 == "TEXT").map(|e| value(e, 1)).collect();
            assert!(texts.contains(&format!("PIECE NAME: {}", piece.name).as_str()), "{texts:?}");
            // Its texts are clear of the folds and of the grain.
            let lines: Vec<[DVec2; 2]> = own
                .iter()
                .filter(|e| e[0].1 == "LINE")
                .map(|e| [(10, 20), (11, 21)].map(|(x, y)| DVec2::new(number(e, x), number(e, y))))
                .collect();
            for row in own.iter().filter(|e| e[0].1 == "TEXT" && value(e, 8) == "1") {
                let (start, height) = (DVec2::new(number(row, 11), number(row, 21)), number(row, 40));
                let end = start + DVec2::new(plateau_drawing::label::width(value(row, 1), height), 0.0);
                let side = |a: DVec2, b: DVec2, c: DVec2| (b - a).perp_dot(c - a);
                let crosses = |[a, b]: &[DVec2; 2]| {
                    side(start, end, *a) * side(start, end, *b) < 0.0 && side(*a, *b, start) * side(*a, *b, end) < 0.0
                };
                assert!(!lines.iter().any(crosses), "{name} {block} {}", value(row, 1));
                assert!(polygon::contains(&cut, start) && polygon::contains(&cut, end), "{name} {block}");
            }
        }
        let inserts = all.iter().filter(|e| e[0].1 == "INSERT").map(|e| value(e, 2));
        assert!(inserts.eq(starts.iter().map(|&k| value(all[k], 2))));
        for text in ["UNITS: METRIC", "STYLE NAME: ruled surface", "ASTM/D13PROPOSAL 1 VERSION: D 6673-10"] {
            assert!(all.iter().any(|e| e[0].1 == "TEXT" && value(e, 1) == text && value(e, 8) == "1"), "{text}");
        }
        let used = all.iter().filter(|e| !matches!(e[0].1.as_str(), "BLOCK" | "ENDBLK")).map(|e| value(e, 8));
        let known = |layer: &str| {
            layer.is_empty() || matches!(layer, "1" | "2" | "3" | "4" | "7" | "8" | "14" | "15" | "84" | "87")
        };
        assert!(used.into_iter().all(known), "{name}");
    }
}

/// Input: halves of a duct whose ends are narrow panels. Symptom: the number of a bridge found no room clear of the
/// folds, and was left out at one of its two sides. Rule: each side of a cut has the number of its bridge.
#[test]
fn each_side_of_a_cut_has_the_number_of_its_bridge() {
    let mut numbers = 0;
    for (name, archive) in all() {
        for height in ["2", "25", "200"] {
            let query = format!("profile=astm-d6673&cut_at=2,5&allowance=10&text_height={height}");
            let Ok(file) = make(&archive, &query) else { continue };
            let pairs = dxf_pairs(&file);
            let texts: Vec<&str> = entities(&pairs)
                .iter()
                .filter(|e| e[0].1 == "TEXT" && value(e, 8) == "15" && value(e, 1).starts_with("bridge"))
                .map(|e| value(e, 1))
                .collect();
            let pair = |text: &&str| texts.iter().filter(|other| *other == text).count() == 2;
            assert!(!texts.is_empty() && texts.iter().all(pair), "{name} {height}: {texts:?}");
            numbers += texts.len();
        }
    }
    assert!(numbers >= 12, "{numbers}");
}

#[test]
fn what_cloth_has_no_use_for_is_refused() {
    let (_, archive) = all().remove(1);
    for (query, parameter) in [
        ("layers=cut:A", "layers"),
        ("format=svg", "format"),
        ("sheet=3000,1500", "sheet"),
        ("thickness=1", "thickness"),
    ] {
        let query = format!("profile=astm-d6673&{query}");
        assert_eq!(refused(make(&archive, &query)), (true, vec![parameter.to_owned()]), "{query}");
    }
    let zip = make(&archive, "profile=astm-d6673&split=pieces").unwrap();
    let text = String::from_utf8_lossy(&zip);
    assert!(text.contains("strip 2.dxf") && text.matches("\nINSERT\n").count() == 2);
}
