//! Pieces, cut contours and files of flat patterns.

use crate::samples::{all, ring, ruled};
use plateau_archive::Archive;
use plateau_archive::archive::{bridges_of, strips_of};
use plateau_drawing::figure::{Figure, figures};
use plateau_drawing::piece::{Pattern, Piece, Seam, Side};
use plateau_drawing::{PatternOptions, Refused, pattern, plain_dxf, plain_svg, polygon};
use plateau_mesh::{DVec2, DVec3};
use plateau_ruled_surface::Options;
use serde_json::Value;
use std::collections::BTreeMap;

pub fn options(query: &str) -> PatternOptions {
    read(query).unwrap()
}

fn read(query: &str) -> Result<PatternOptions, Refused> {
    let pairs = query.split('&').filter(|pair| !pair.is_empty());
    let pairs: Vec<(String, String)> =
        pairs.map(|pair| pair.split_once('=').unwrap()).map(|(name, value)| (name.into(), value.into())).collect();
    PatternOptions::read(&pairs)
}

pub fn pieces(archive: &Archive) -> Vec<Piece> {
    Pattern::of(archive.contents(), &[]).unwrap().pieces
}

/// Returns the parameters that a query is refused for.
pub fn refused(result: Result<Vec<u8>, Refused>) -> (bool, Vec<String>) {
    match result.map(|file| file.len()).unwrap_err() {
        Refused::BadQuery(errors) => (true, errors.into_iter().map(|error| error.parameter).collect()),
        Refused::Unsuitable(errors) => (false, errors.into_iter().map(|error| error.parameter).collect()),
        other => panic!("{other:?}"),
    }
}

pub fn make(archive: &Archive, query: &str) -> Result<Vec<u8>, Refused> {
    pattern(archive.contents(), &read(query)?)
}

/// Bends a piece about its fold lines and returns its panels in space. A positive angle bends away from the reader.
fn refolded(piece: &Piece) -> Vec<[DVec3; 3]> {
    let flat = |point: DVec2| point.extend(0.0);
    let (mut x, mut y, mut z, mut origin) = (DVec3::X, DVec3::Y, DVec3::Z, DVec3::ZERO);
    let mut panels = Vec::new();
    for (k, panel) in piece.panels.iter().enumerate() {
        if let Some(fold) = k.checked_sub(1).map(|k| piece.folds[k]) {
            let place = |point: DVec2| origin + x * point.x + y * point.y;
            let [from, to] = fold.ends.map(place);
            // The next panel lies beyond the fold. It turns about the fold's line, and down for a mountain.
            let middle = place((panel[0] + panel[1] + panel[2]) / 3.0);
            let axis = (to - from).normalize();
            let beyond = (middle - from).cross(axis).dot(z) > 0.0;
            let angle = fold.angle_deg.to_radians() * if beyond { 1.0 } else { -1.0 };
            let turn = |v: DVec3| {
                let (sine, cosine) = angle.sin_cos();
                v * cosine + axis.cross(v) * sine + axis * axis.dot(v) * (1.0 - cosine)
            };
            origin = from + turn(origin - from);
            (x, y, z) = (turn(x), turn(y), turn(z));
        }
        panels.push(panel.map(|point| origin + x * flat(point).x + y * flat(point).y));
    }
    panels
}

/// Largest difference between the distances of the corners of a refolded piece and those of the mesh, over the size.
pub fn refold_error(archive: &Archive, piece: &Piece, first: usize) -> f64 {
    let mesh = &archive.contents().mesh;
    let bridges = bridges_of(archive.contents()).unwrap();
    let folded = refolded(piece);
    // Triangles of the piece in the mesh: those between its bridges. Corners are compared by the pairs of panels.
    let closed = plateau_archive::archive::is_closed(archive.contents());
    let count = bridges.len();
    let mut worst: f64 = 0.0;
    let centre = |corners: [DVec3; 3]| (corners[0] + corners[1] + corners[2]) / 3.0;
    let solid: Vec<DVec3> = (0..folded.len())
        .map(|k| {
            let number = first + k;
            centre(mesh.corners(mesh.triangles[if closed { number % count } else { number }]))
        })
        .collect();
    let centres: Vec<DVec3> = folded.iter().map(|&corners| centre(corners)).collect();
    for a in 0..centres.len() {
        for b in 0..a {
            worst = worst.max((centres[a].distance(centres[b]) - solid[a].distance(solid[b])).abs());
        }
    }
    // Distances alone do not tell a shape from its mirror image, so the volume of four centres decides.
    let volume = |points: &[DVec3], [a, b, c, d]: [usize; 4]| {
        (points[b] - points[a]).cross(points[c] - points[a]).dot(points[d] - points[a])
    };
    let n = centres.len();
    let four = [0, n / 3, 2 * n / 3, n - 1];
    worst.max((volume(&centres, four) - volume(&solid, four)).abs())
}

#[test]
fn bent_about_its_lines_the_pattern_is_the_strip() {
    for (name, archive) in all() {
        if name.contains("stack") {
            continue;
        }
        let pieces = pieces(&archive);
        let strip = &pieces[0];
        let bridges = bridges_of(archive.contents()).unwrap();
        let closed = plateau_archive::archive::is_closed(archive.contents());
        let first = if closed {
            let Some(Seam::Bridge(first)) =
                strip.edges.iter().find(|edge| edge.side == Side::End).map(|edge| edge.seam)
            else {
                panic!("{name}: no cut")
            };
            first as usize
        } else {
            0
        };
        assert_eq!(strip.panels.len() + usize::from(!closed), bridges.len(), "{name}");
        let error = refold_error(&archive, strip, first);
        assert!(error < 1e-9, "{name}: {error}");
        // Faults: an angle rounded to a tenth of a degree, a fold bent the other way, the angles of two folds swapped.
        let mut rounded = strip.clone();
        rounded.folds.iter_mut().for_each(|fold| fold.angle_deg = (10.0 * fold.angle_deg).round() / 10.0);
        assert!(refold_error(&archive, &rounded, first) > 1e-7, "{name}");
        let bent = strip.folds.iter().position(|fold| fold.angle_deg.abs() > 2.0).unwrap();
        let mut other_way = strip.clone();
        other_way.folds[bent].angle_deg *= -1.0;
        assert!(refold_error(&archive, &other_way, first) > 1e-4, "{name}");
        let mut swapped = strip.clone();
        let differs = |angle: f64| (angle - strip.folds[bent].angle_deg).abs() > 0.5;
        let next = strip.folds.iter().position(|fold| differs(fold.angle_deg)).unwrap();
        let angle = swapped.folds[bent].angle_deg;
        swapped.folds[bent].angle_deg = swapped.folds[next].angle_deg;
        swapped.folds[next].angle_deg = angle;
        assert!(refold_error(&archive, &swapped, first) > 1e-5, "{name}");
    }
}

#[test]
fn pieces_are_simple_counter_clockwise_and_have_the_area_of_the_mesh() {
    for (name, archive) in all() {
        let mesh = &archive.contents().mesh;
        let pieces = pieces(&archive);
        let expected = match name {
            "capped duct" | "capped duct upside down" => 3,
            "stack" | "closed stack" => 2,
            _ => 1,
        };
        assert_eq!(pieces.len(), expected, "{name}");
        let flat: f64 = pieces.iter().map(|piece| polygon::area(&piece.outline)).sum();
        let area = |t: &[u32; 3]| {
            let [a, b, c] = mesh.corners(*t);
            0.5 * (b - a).cross(c - a).length()
        };
        let solid: f64 = mesh.triangles.iter().map(area).sum();
        assert!((flat - solid).abs() < 1e-12 * solid, "{name}: {flat} {solid}");
        for piece in &pieces {
            assert_eq!(piece.edges.len(), piece.outline.len());
            assert!(polygon::crossing(&piece.outline).is_none() && !piece.overlaps, "{name} {}", piece.name);
            assert!(piece.panels.iter().all(|[a, b, c]| (*b - *a).perp_dot(*c - *a) > 0.0), "{name}");
            for (k, edge) in piece.edges.iter().enumerate() {
                let length = piece.outline[k].distance(piece.outline[(k + 1) % piece.outline.len()]);
                assert!(((edge.arc[1] - edge.arc[0]).abs() - length).abs() < 1e-12, "{name} {} {k}", piece.name);
            }
        }
    }
}

/// Returns the pieces at each seam that is no end of an open strip, with their lengths along it.
pub fn seams(pieces: &[Piece]) -> BTreeMap<Seam, Vec<f64>> {
    let mut seams: BTreeMap<Seam, Vec<f64>> = BTreeMap::new();
    for piece in pieces {
        let mut own: BTreeMap<(Seam, bool), f64> = BTreeMap::new();
        for (k, edge) in piece.edges.iter().enumerate() {
            let length = piece.outline[k].distance(piece.outline[(k + 1) % piece.outline.len()]);
            *own.entry((edge.seam, edge.side == Side::End && edge.arc[0] == 0.0)).or_default() += length;
        }
        own.into_iter().for_each(|((seam, _), length)| seams.entry(seam).or_default().push(length));
    }
    seams
}

#[test]
fn mates_have_equal_lengths_and_their_marks_lie_at_the_same_places_in_space() {
    let mut shared = 0;
    for (name, archive) in all() {
        let contents = archive.contents();
        let mut pieces = pieces(&archive);
        for (seam, lengths) in seams(&pieces) {
            shared += usize::from(lengths.len() == 2);
            let spread = lengths.iter().copied().fold(0.0, f64::max) - lengths.iter().copied().fold(f64::MAX, f64::min);
            assert!(spread < 1e-12, "{name} {seam:?} {lengths:?}");
        }
        // Every mark, carried back to the mesh by its panel, is the point of the rail at its arc length.
        let made = figures(&pieces, &options("notches=0.13")).unwrap();
        let rails = rails(&archive);
        for figure in &made {
            assert!(!figure.marks.is_empty());
            for mark in &figure.marks {
                let Seam::Rail(rail) = mark.seam else { continue };
                let expected = along(&rails[rail as usize], mark.arc_length);
                let number = made.iter().position(|other| other.name == figure.name).unwrap();
                let found = carried_back(contents, &pieces[number], mark.at);
                if let Some(found) = found {
                    assert!(found.distance(expected) < 1e-9, "{name} {} {mark:?}", figure.name);
                }
            }
        }
        // A fault: a mate that is 0.1% long.
        let longest = pieces.len() - 1;
        pieces[longest].outline.iter_mut().for_each(|point| *point *= 1.001);
        let found =
            seams(&pieces).into_values().any(|lengths| lengths.len() == 2 && (lengths[0] - lengths[1]).abs() > 1e-6);
        assert_eq!(found, pieces.len() > 1, "{name}");
    }
    assert!(shared > 8, "{shared}");
}

/// Returns the rails as closed or open polylines in the order of their vertices' numbers.
fn rails(archive: &Archive) -> Vec<Vec<DVec3>> {
    let contents = archive.contents();
    let closed = plateau_archive::archive::is_closed(contents);
    let bridges = bridges_of(contents).unwrap();
    let mut rails = Vec::new();
    for strip in strips_of(bridges) {
        let side = |side: usize| {
            let mut numbers: Vec<u32> = strip.iter().map(|bridge| bridge[side]).collect();
            numbers.sort_unstable();
            numbers.dedup();
            let mut points: Vec<DVec3> = numbers.iter().map(|&v| contents.mesh.vertices[v as usize]).collect();
            if closed && points.len() > 1 {
                points.push(points[0]);
            }
            points
        };
        if rails.is_empty() {
            rails.push(side(0));
        }
        rails.push(side(1));
    }
    rails
}

fn along(rail: &[DVec3], mut arc_length: f64) -> DVec3 {
    for pair in rail.windows(2) {
        let length = pair[0].distance(pair[1]);
        if arc_length <= length + 1e-12 {
            return pair[0].lerp(pair[1], arc_length / length);
        }
        arc_length -= length;
    }
    panic!("beyond the rail")
}

/// Returns the point of the mesh that a point of a strip's outline became, by the panel that has it on its boundary.
fn carried_back(contents: &plateau_archive::Contents, piece: &Piece, at: DVec2) -> Option<DVec3> {
    if !piece.name.starts_with("strip 1") {
        return None;
    }
    let first = match piece.edges.iter().find(|edge| edge.side == Side::End)?.seam {
        Seam::Bridge(number) if plateau_archive::archive::is_closed(contents) => number as usize,
        _ => 0,
    };
    let count = piece.panels.len();
    for (k, [a, b, c]) in piece.panels.iter().enumerate() {
        let area = (*b - *a).perp_dot(*c - *a);
        let weights = [(*b - at).perp_dot(*c - at), (*c - at).perp_dot(*a - at), (*a - at).perp_dot(*b - at)];
        if weights.iter().all(|&weight| weight > -1e-12) {
            let triangle = contents.mesh.triangles[(first + k) % count.max(1)];
            let solid = contents.mesh.corners(triangle);
            // The corners of the panel in the order of the triangle: equal side lengths tell which is which.
            for turn in 0..3 {
                for flip in [false, true] {
                    let order = |k: usize| (turn + if flip { 3 - k } else { k }) % 3;
                    let flat = [*a, *b, *c];
                    let same = (0..3).all(|k| {
                        let (p, q) = (order(k), order(k + 1));
                        (flat[k].distance(flat[(k + 1) % 3]) - solid[p].distance(solid[q])).abs() < 1e-9
                    });
                    if same {
                        return Some((0..3).map(|k| solid[order(k)] * (weights[k] / area)).sum());
                    }
                }
            }
        }
    }
    None
}

#[test]
fn an_allowance_is_a_mitred_offset_of_each_edge_by_its_own_distance() {
    // A rectangle of 2000 x 1000 mm: the offset has the closed form (2000 + 2 e) (1000 + p + q).
    let rails = [[0.0, 0.0], [0.0, 1.0]].map(|[_, y]| vec![DVec3::new(0.0, y, 0.0), DVec3::new(2.0, y, 0.0)]);
    let archive = ruled(&rails, &Options::default());
    let query = "format=json&allowance_p=10&allowance_q=20&allowance_ends=5";
    let value: Value = serde_json::from_slice(&make(&archive, query).unwrap()).unwrap();
    let piece = &value["pieces"][0];
    assert_eq!((&piece["size"]["width"], &piece["size"]["height"]), (&2010.0.into(), &1030.0.into()));
    let points = |name: &str| -> Vec<DVec2> {
        let list = piece[name].as_array().unwrap();
        list.iter().map(|p| DVec2::new(p[0].as_f64().unwrap(), p[1].as_f64().unwrap())).collect()
    };
    let (cut, sew) = (points("outline"), points("sew"));
    assert!((polygon::area(&cut) - 2010.0 * 1030.0).abs() < 1e-6);
    assert!((polygon::area(&sew) - 2e6).abs() < 1e-6 && sew[0] == DVec2::new(5.0, 10.0), "{sew:?}");
    // Half of the kerf lies outside the outline on every side.
    let value: Value = serde_json::from_slice(&make(&archive, "format=json&kerf=0.2").unwrap()).unwrap();
    assert!((value["pieces"][0]["size"]["width"].as_f64().unwrap() - 2000.2).abs() < 1e-9);
    // A convex piece with the allowance a on all sides has the area A + a L + a² Σ tan(turn/2), by Steiner's formula
    // with mitres.
    let duct = all().remove(3).1;
    let piece = &pieces(&duct)[0];
    let cap = &pieces(&all().remove(4).1)[2];
    assert_eq!(cap.name, "cap 2");
    for (piece, convex) in [(cap, true), (piece, false)] {
        let a = 0.01;
        let count = piece.outline.len();
        let (moved, _) = polygon::offset(&piece.outline, &vec![a; count]).unwrap();
        assert!(polygon::crossing(&moved).is_none());
        let edge = |k: usize| piece.outline[(k + 1) % count] - piece.outline[k % count];
        let perimeter: f64 = (0..count).map(|k| edge(k).length()).sum();
        let turns: f64 = (0..count).map(|k| (0.5 * edge(k).angle_to(edge(k + 1))).tan()).sum();
        let expected = polygon::area(&piece.outline) + a * perimeter + a * a * turns;
        assert!(!convex || moved.len() == count);
        assert!((polygon::area(&moved) - expected).abs() < 1e-12, "{} {expected}", polygon::area(&moved));
    }
}

#[test]
fn an_offset_drops_edges_that_vanish_and_cuts_long_mitres_off() {
    // A step of 0.1 in the upper side of a square vanishes in an offset by 1.
    let step = [[0.0, 0.0], [10.0, 0.0], [10.0, 10.0], [5.0, 10.0], [5.1, 9.9], [0.0, 9.9]].map(DVec2::from_array);
    let (moved, edges) = polygon::offset(&step, &[1.0; 6]).unwrap();
    assert!(polygon::crossing(&moved).is_none() && moved.len() < 8, "{moved:?} {edges:?}");
    assert!((polygon::area(&moved) - 12.0 * 12.0).abs() < 1.0);
    // A corner of 10 degrees has a mitre of 1 / sin 5°, which is cut off at four times the distance.
    let needle = [[0.0, 0.0], [100.0, 0.0], [100.0, 100.0 * 10f64.to_radians().tan()]].map(DVec2::from_array);
    let (moved, _) = polygon::offset(&needle, &[1.0; 3]).unwrap();
    assert_eq!(moved.len(), 4);
    let reach = moved.iter().map(|point| point.length()).filter(|&length| length < 50.0).fold(0.0, f64::max);
    assert!((4.0..4.5).contains(&reach), "{reach}");
}

#[test]
fn notches_lie_in_the_cut_line_and_a_lost_one_shows_in_the_area() {
    for (name, archive) in all() {
        let plain = figures_of(&archive, "profile=cut&format=dxf");
        let notched = figures_of(&archive, "profile=cut&format=dxf&notches=150");
        for (plain, notched) in plain.iter().zip(&notched) {
            assert!(polygon::crossing(&notched.cut).is_none(), "{name}");
            // A notch on a straight edge takes a triangle of 2 x 3 mm; one at a corner a little more or less.
            let lost = polygon::area(&plain.cut) - polygon::area(&notched.cut);
            let count = (lost / 3.0).round() as usize;
            let corners = notched.marks.len() - count;
            assert!(
                count > 0 && corners <= 4 && (lost - 3.0 * count as f64).abs() < 0.15 * count as f64,
                "{name} {lost}"
            );
        }
        // Both pieces at a shared seam have the same marks.
        let mut at: BTreeMap<(Seam, u64), usize> = BTreeMap::new();
        for mark in notched.iter().flat_map(|figure| &figure.marks) {
            *at.entry((mark.seam, mark.arc_length.to_bits())).or_default() += 1;
        }
        let pieces = pieces(&archive);
        for (seam, lengths) in seams(&pieces) {
            let counts: Vec<usize> = at.iter().filter(|((own, _), _)| *own == seam).map(|(_, &count)| count).collect();
            assert!(counts.iter().all(|&count| count == lengths.len()), "{name} {seam:?} {counts:?}");
            assert_eq!(counts.len(), (1000.0 * lengths[0] / 150.0) as usize, "{name} {seam:?}");
        }
    }
}

pub fn figures_of(archive: &Archive, query: &str) -> Vec<Figure> {
    let millimetres: Vec<Piece> = {
        // Pieces in millimetres, as the files have them: the same surface in this unit.
        let mut contents = archive.contents().clone();
        contents.mesh.vertices.iter_mut().for_each(|vertex| *vertex *= 1000.0);
        pieces(&Archive::new(contents).unwrap())
    };
    figures(&millimetres, &options(query)).unwrap()
}

#[test]
fn a_zip_of_cut_lines_has_one_closed_polygon_a_file() {
    let (_, archive) = all().remove(4);
    let bytes = make(&archive, "profile=cut&format=dxf").unwrap();
    let text = String::from_utf8_lossy(&bytes);
    for name in ["strip 1.dxf", "cap 1.dxf", "cap 2.dxf"] {
        assert_eq!(text.matches(name).count(), 2, "{name} in a header and in the directory");
    }
    assert_eq!(text.matches("LWPOLYLINE").count(), 3);
    assert!(!text.contains("\nTEXT\n") && !text.contains("\nLINE\n") && !text.contains("FOLD"));
    assert_eq!(bytes, make(&archive, "profile=cut&format=dxf").unwrap());
    let svg = String::from_utf8(make(&archive, "profile=cut&layers=cut:LASER&split=pieces").unwrap_or_default());
    assert_eq!(svg.unwrap(), "", "split is refused");
    let svg = make(&archive, "profile=cut&layers=cut:LASER").unwrap();
    assert_eq!(String::from_utf8_lossy(&svg).matches(r#"<path class="LASER""#).count(), 3);
}

#[test]
fn lines_carry_their_angles_in_all_digits() {
    for (name, archive) in all() {
        let value: Value = serde_json::from_slice(&make(&archive, "format=json").unwrap()).unwrap();
        let lines = |piece: &Value| piece["lines"].as_array().unwrap().clone();
        let angles: Vec<f64> = value["pieces"]
            .as_array()
            .unwrap()
            .iter()
            .flat_map(lines)
            .map(|line| line["angle_deg"].as_f64().unwrap())
            .collect();
        let svg = String::from_utf8(make(&archive, "angles=true").unwrap()).unwrap();
        let dxf = String::from_utf8(make(&archive, "format=dxf").unwrap()).unwrap();
        for angle in &angles {
            assert!(svg.contains(&format!(r#"data-angle-deg="{angle:?}""#)), "{name}");
            assert!(dxf.contains(&format!("1001\nPLATEAU\n1040\n{angle:?}\n")), "{name}");
            let printed = format!("{angle:.2}").replace("-0.00", "0.00");
            assert!(svg.contains(&format!(">{printed}</text>")), "{name} {printed}");
        }
        let folds: usize = pieces(&archive).iter().map(|piece| piece.folds.len()).sum();
        assert_eq!(angles.len(), folds);
    }
}

#[test]
fn texts_lie_clear_of_every_line() {
    use plateau_drawing::figure::Shape;
    use plateau_drawing::label::corners;
    for (name, archive) in all() {
        let plain = figures_of(&archive, "angles=true&notches=200&allowance=8");
        // With the grain.
        let on_sheets = figures_of(&archive, "angles=true&notches=200&sheet=100000,100000");
        for figure in plain.into_iter().chain(on_sheets) {
            let (mut texts, mut lines): (Vec<[DVec2; 4]>, Vec<[DVec2; 2]>) = (Vec::new(), Vec::new());
            for shape in &figure.shapes {
                match shape {
                    Shape::Text { text, spot, .. } => texts.push(corners(spot, text)),
                    Shape::Line { ends, .. } => lines.push(*ends),
                    Shape::Polygon { points, .. } => {
                        lines.extend((0..points.len()).map(|k| [points[k], points[(k + 1) % points.len()]]));
                    }
                }
            }
            assert_eq!(texts.len(), figure.lines.len() + 1);
            for (k, text) in texts.iter().enumerate() {
                let sides = |text: &[DVec2; 4]| (0..4).map(|k| [text[k], text[(k + 1) % 4]]).collect::<Vec<_>>();
                let mut others: Vec<[DVec2; 2]> = lines.clone();
                others.extend(texts[..k].iter().flat_map(sides));
                for [a, b] in sides(text) {
                    for &[c, d] in &others {
                        let side = |p: DVec2, q: DVec2, r: DVec2| (q - p).perp_dot(r - p);
                        let crosses = side(a, b, c) * side(a, b, d) < 0.0 && side(c, d, a) * side(c, d, b) < 0.0;
                        assert!(!crosses, "{name} {}: text {k} at {a} meets {c} {d}", figure.name);
                    }
                }
            }
        }
    }
}

/// Whoever asks for large texts will see the drawing reduced, so that no text is much smaller.
#[test]
fn texts_beside_a_piece_are_as_high_as_asked_where_there_is_room() {
    use plateau_drawing::figure::Shape;
    let mut beside = 0;
    for (name, archive) in all() {
        for height in [3.0, 5.0, 20.0, 60.0, 200.0] {
            for figure in figures_of(&archive, &format!("angles=true&text_height={height}")) {
                let [low, high] = figure.bounds();
                let mut rows: Vec<f64> = Vec::new();
                for shape in &figure.shapes {
                    let Shape::Text { spot, .. } = shape else { continue };
                    if polygon::contains(&figure.cut, spot.at) {
                        assert!(spot.height >= f64::max(2.0, 0.4 * height).min(height), "{name} {height} {spot:?}");
                    } else if spot.direction == DVec2::Y {
                        rows.push(spot.height);
                    }
                }
                beside += rows.len();
                let fits = (high.x - low.x) / (1.6 * rows.len().max(1) as f64);
                let expected = if fits >= height { height } else { fits.max(2.0) };
                assert!(rows.iter().all(|row| (row - expected).abs() < 1e-9), "{name} {height} {rows:?} {expected}");
            }
        }
    }
    assert!(beside > 20, "{beside}");
}

#[test]
fn bad_values_are_named() {
    let (_, archive) = all().remove(1);
    let bad = [
        ("profile=paper", "profile"),
        ("format=png", "format"),
        ("profile=cut&format=pdf", "format"),
        ("profile=cut&angles=true", "angles"),
        ("profile=cut&text_height=4", "text_height"),
        ("text_height=0", "text_height"),
        ("text_height=nan", "text_height"),
        ("notches=-5", "notches"),
        ("notches=inf", "notches"),
        ("allowance=-1", "allowance"),
        ("allowance_p=x", "allowance_p"),
        ("kerf=-0.1", "kerf"),
        ("cut_at=-1", "cut_at"),
        ("cut_at=1,,2", "cut_at"),
        ("layers=cut", "layers"),
        ("layers=fold:X", "layers"),
        ("layers=cut:A,cut:B", "layers"),
        ("layers=cut:A%0A0", "layers"),
        ("radius=3", "radius"),
        ("profile=sheet-metal", "thickness"),
        ("profile=sheet-metal&thickness=2&radius=0.9", "radius"),
        ("paper=a4", "paper"),
        ("format=pdf&paper=a5", "paper"),
        ("colour=red", "colour"),
        ("kerf=1&kerf=2", "kerf"),
    ];
    for (query, parameter) in bad {
        assert_eq!(refused(make(&archive, query)), (true, vec![parameter.to_owned()]), "{query}");
    }
    let unsuitable = [
        ("notches=0.1", "notches"),
        // Millions of them.
        ("notches=0.001", "notches"),
        ("notches=1.9&profile=cut", "notches"),
        ("format=pdf&paper=a4&text_height=500", "paper"),
        ("cut_at=99", "cut_at"),
        ("cut_at=0", "cut_at"),
        ("profile=cut&notches=100&kerf=4", "kerf"),
    ];
    for (query, parameter) in unsuitable {
        assert_eq!(refused(make(&archive, query)), (false, vec![parameter.to_owned()]), "{query}");
    }
    // Nine tenths of a ring: the allowances of the two ends meet.
    let rail = |radius: f64| -> Vec<DVec3> {
        let angle = |k: u32| 0.9 * std::f64::consts::TAU * f64::from(k) / 60.0;
        (0..=60).map(|k| DVec3::new(radius * angle(k).cos(), radius * angle(k).sin(), 0.0)).collect()
    };
    let horseshoe = ruled(&[rail(1.0), rail(1.5)], &Options::default());
    assert!(make(&horseshoe, "allowance=100").is_ok());
    assert_eq!(refused(make(&horseshoe, "allowance=400")), (false, vec!["allowance".to_owned()]));
    let film = Archive::new(plateau_archive::Contents {
        mesh: plateau_mesh::Mesh::new(ring(3, 1.0, 0.0, 0.0), vec![[0, 1, 2]]),
        statistics: "{}".into(),
        ..plateau_archive::Contents::default()
    });
    assert_eq!(make(&film.unwrap(), ""), Err(Refused::NoPattern));
}

#[test]
fn the_described_parameters_are_those_that_are_read() {
    let unknown = PatternOptions::read(&[("colour".into(), "red".into())]).unwrap_err();
    let Refused::BadQuery(errors) = unknown else { panic!("{unknown:?}") };
    let names: Vec<&str> = plateau_drawing::options::PARAMETERS.iter().map(|parameter| parameter.name).collect();
    assert_eq!(errors[0].detail, format!("known parameters are: {}", names.join(", ")));
}

#[test]
fn a_plain_pattern_is_that_of_a_query_with_a_format_only() {
    for (name, archive) in all() {
        assert_eq!(plain_svg(archive.contents()), make(&archive, "format=svg"), "{name}");
        assert_eq!(plain_dxf(archive.contents()), make(&archive, "format=dxf"), "{name}");
    }
}
