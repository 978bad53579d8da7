//! Every download format is read back by an independent reader in this test.

use crate::sample;
use crate::skips::skipped;
use plateau_archive::formats::{Choices, Colors, Error, MeshFormat, Origin, Quantity};
use plateau_archive::units::{Unit, UpAxis};
use plateau_archive::{Archive, Attribute, Contents, Lines};
use plateau_mesh::DVec3;
use serde_json::{Value, json};

/// Document and buffer of a GLB file.
struct Glb {
    document: Value,
    buffer: Vec<u8>,
}

fn word(bytes: &[u8], at: usize) -> u32 {
    u32::from_le_bytes(bytes[at..at + 4].try_into().unwrap())
}

impl Glb {
    fn of(archive: &Archive) -> Self {
        Self::with(archive, Choices::default())
    }

    fn with(archive: &Archive, choices: Choices) -> Self {
        let bytes = MeshFormat::Glb.encode_with(archive, choices).unwrap();
        imported(&bytes);
        assert_eq!((&bytes[..4], word(&bytes, 4), word(&bytes, 8) as usize), (&b"glTF"[..], 2, bytes.len()));
        let text = word(&bytes, 12) as usize;
        assert_eq!((&bytes[16..20], text % 4), (&b"JSON"[..], 0));
        let start = 20 + text + 8;
        assert_eq!(&bytes[start - 4..start], b"BIN\0");
        let document: Value = serde_json::from_slice(&bytes[20..20 + text]).unwrap();
        let buffer = bytes[start..].to_vec();
        assert_eq!(document["buffers"], json!([{ "byteLength": buffer.len() }]));
        assert_eq!(word(&bytes, start - 8) as usize, buffer.len());
        Self { document, buffer }
    }

    /// Returns the bytes of an accessor, `size` for each item.
    fn items(&self, accessor: &Value, size: usize) -> Vec<&[u8]> {
        let accessor = &self.document["accessors"][accessor.as_u64().unwrap() as usize];
        let view = &self.document["bufferViews"][accessor["bufferView"].as_u64().unwrap() as usize];
        let (start, length) =
            (view["byteOffset"].as_u64().unwrap() as usize, view["byteLength"].as_u64().unwrap() as usize);
        let items: Vec<_> = self.buffer[start..start + length].chunks(size).collect();
        assert_eq!((start % 4, items.len() as u64), (0, accessor["count"].as_u64().unwrap()));
        items
    }

    fn floats(&self, accessor: &Value) -> Vec<f32> {
        self.items(accessor, 4).iter().map(|item| f32::from_bits(word(item, 0))).collect()
    }

    fn vectors(&self, accessor: &Value) -> Vec<DVec3> {
        let component = |item: &[u8], c: usize| f64::from(f32::from_bits(word(item, 4 * c)));
        let items = self.items(accessor, 12);
        items.iter().map(|item| DVec3::new(component(item, 0), component(item, 1), component(item, 2))).collect()
    }

    fn indices(&self, accessor: &Value) -> Vec<u32> {
        self.items(accessor, 4).iter().map(|item| word(item, 0)).collect()
    }

    fn primitive(&self, mesh: usize) -> &Value {
        &self.document["meshes"][mesh]["primitives"][0]
    }

    fn translation(&self) -> DVec3 {
        let nodes = self.document["nodes"].as_array().unwrap();
        assert!(nodes.iter().all(|node| node["translation"] == nodes[0]["translation"]));
        DVec3::from_array(serde_json::from_value(nodes[0]["translation"].clone()).unwrap())
    }

    /// Returns the positions in metres with Y up, as a viewer with f64 would place them.
    fn world(&self) -> Vec<DVec3> {
        let positions = self.vectors(&self.primitive(0)["attributes"]["POSITION"]);
        positions.into_iter().map(|position| position + self.translation()).collect()
    }
}

/// Reads a file and its buffer with the importer of the crate gltf, which checks all references.
fn imported(file: &[u8]) -> (gltf::Document, Vec<u8>) {
    let gltf::Gltf { document, blob } = gltf::Gltf::from_slice(file).unwrap();
    let buffer = document.buffers().next().unwrap();
    let bytes = match buffer.source() {
        gltf::buffer::Source::Bin => blob.unwrap(),
        gltf::buffer::Source::Uri(uri) => base64_decoded(uri.split_once(";base64,").unwrap().1),
    };
    assert_eq!((document.buffers().len(), buffer.length()), (1, bytes.len()));
    (document, bytes)
}

fn archive(contents: Contents) -> Archive {
    Archive::new(contents).unwrap()
}

#[test]
fn glb_holds_the_mesh_in_metres_with_y_up() {
    let mut contents = sample::roof(250.0, DVec3::new(3.0, -5.0, 0.25));
    contents.unit = Unit::Centimetre;
    let expected: Vec<DVec3> = contents.mesh.vertices.iter().map(|v| DVec3::new(v.x, v.z, -v.y) * 0.01).collect();
    let glb = Glb::of(&archive(contents.clone()));
    for (found, expected) in glb.world().iter().zip(&expected) {
        assert!(found.distance(*expected) < 1e-6 * 2.5, "{found} instead of {expected}");
    }
    let indices = glb.indices(&glb.primitive(0)["indices"]);
    assert_eq!(indices, contents.mesh.triangles.concat());

    contents.up = UpAxis::Y;
    let expected = contents.mesh.vertices.iter().map(|v| *v * 0.01);
    for (found, expected) in Glb::of(&archive(contents.clone())).world().iter().zip(expected) {
        assert!(found.distance(expected) < 1e-6 * 2.5, "{found} instead of {expected}");
    }
}

/// Tests a roof ten thousand kilometres away and meshes of nearly any size. f32 loses at most a ten-millionth of the
/// size.
#[test]
fn glb_keeps_a_ten_millionth_of_the_size_wherever_the_mesh_is() {
    let far = DVec3::new(1e7, -1e7 + 0.125, 3e6);
    for (scale, offset) in [
        (1.0, far),
        (1e-25, DVec3::ZERO),
        (1e-3, far * 1e-3),
        (1e30, DVec3::splat(-1e30)),
        (1e7, far),
        (1.0, DVec3::ZERO),
    ] {
        let contents = sample::roof(scale, offset);
        let glb = Glb::of(&archive(contents.clone()));
        let origin =
            DVec3::from_array(serde_json::from_value(glb.document["asset"]["extras"]["origin"].clone()).unwrap());
        let translation = DVec3::new(origin.x, origin.z, -origin.y);
        assert_eq!(glb.translation(), translation, "the translation must equal the origin exactly");
        let positions = glb.vectors(&glb.primitive(0)["attributes"]["POSITION"]);
        for (found, vertex) in positions.iter().zip(&contents.mesh.vertices) {
            let expected = *vertex - origin;
            let expected = DVec3::new(expected.x, expected.z, -expected.y);
            assert!(found.distance(expected) < 1e-7 * scale, "scale {scale}: {found} instead of {expected}");
        }
    }
}

#[test]
fn glb_bounds_are_exactly_those_of_the_positions() {
    let glb = Glb::of(&archive(sample::roof(0.1, DVec3::new(1e7, 0.3, 0.7))));
    let accessor = &glb.primitive(0)["attributes"]["POSITION"];
    let positions = glb.vectors(accessor);
    let accessor = &glb.document["accessors"][accessor.as_u64().unwrap() as usize];
    let low = positions.iter().copied().fold(DVec3::INFINITY, DVec3::min);
    let high = positions.iter().copied().fold(DVec3::NEG_INFINITY, DVec3::max);
    assert_eq!((&accessor["min"], &accessor["max"]), (&json!(low.to_array()), &json!(high.to_array())));
}

/// Returns the roof with a triangle and its reverse, whose normals cancel, a triangle of no area, and a vertex without
/// a triangle. Also returns the index of the first of these vertices.
fn with_degenerate_parts(scale: f64) -> (Contents, usize) {
    let mut contents = sample::roof(scale, DVec3::ZERO);
    let apex = contents.mesh.vertices[4];
    let start = contents.mesh.vertices.len();
    let flat = [apex, apex + DVec3::X * scale, apex + DVec3::Z * scale, apex, apex, apex, DVec3::ZERO];
    contents.mesh.vertices.extend(flat);
    let triangles = [[0, 1, 2], [0, 2, 1], [3, 4, 5]];
    contents.mesh.triangles.extend(triangles.map(|t| t.map(|v| start as u32 + v)));
    (contents, start)
}

#[test]
fn glb_normals_have_unit_length_at_folds_slivers_and_loose_points() {
    for scale in [1.0, 1e-29, 1e37] {
        let (contents, start) = with_degenerate_parts(scale);
        let glb = Glb::of(&archive(contents));
        let normals = glb.vectors(&glb.primitive(0)["attributes"]["NORMAL"]);
        assert!(normals.iter().all(|normal| (normal.length() - 1.0).abs() < 1e-6), "{normals:?}");
        assert_eq!(normals[start], DVec3::Z, "the normal must be that of the folded triangle, in glTF's axes");
        assert_eq!(normals[start + 6], DVec3::Y, "the normal must point up if no triangle gives a direction");
        assert!(normals[0].y > 0.0, "the roof's normals must point up");
    }
}

#[test]
fn a_mesh_is_neutral_unless_colours_are_asked_for() {
    let mut contents = sample::full().contents().clone();
    contents.vertex_attributes.push(slack(vec![0.5; 5]));
    let glb = Glb::of(&archive(contents.clone()));
    for mesh in glb.document["meshes"].as_array().unwrap() {
        for primitive in mesh["primitives"].as_array().unwrap() {
            assert!(primitive["attributes"].get("COLOR_0").is_none(), "{primitive}");
        }
    }
    assert!(glb.document["asset"]["extras"].get("color_range").is_none());
    let attributes = &glb.primitive(0)["attributes"];
    assert!(attributes["_MEAN_CURVATURE"].is_u64() && attributes["_LOWER_BOUND_SLACK"].is_u64());
    let material = &glb.document["materials"][0];
    let surface = &material["pbrMetallicRoughness"];
    assert_eq!((&material["doubleSided"], &surface["metallicFactor"]), (&json!(true), &json!(0.0)));
    let base: [f64; 4] = serde_json::from_value(surface["baseColorFactor"].clone()).unwrap();
    assert!(base.iter().all(|&channel| channel > 0.5), "{base:?}");
    let ply = with(MeshFormat::Ply, &contents, Choices { ascii: true, ..Choices::default() });
    assert!(!String::from_utf8(ply).unwrap().contains("red"));
}

/// Returns the attribute of a proven lower bound.
fn slack(values: Vec<f64>) -> Attribute {
    Attribute { range: [0.0, 1.0], ..Attribute::new("lower_bound_slack", "", values) }
}

fn colors(quantity: Quantity, range: Option<f64>) -> Choices {
    Choices { colors: Some(Colors { quantity, range }), ..Choices::default() }
}

const BLUE: [u8; 4] = [0, 0, 255, 255];
const CYAN: [u8; 4] = [0, 255, 255, 255];
const GREEN: [u8; 4] = [0, 255, 0, 255];
const YELLOW: [u8; 4] = [255, 255, 0, 255];
const RED: [u8; 4] = [255, 0, 0, 255];

/// Returns the colours at the vertices of a primitive.
fn colors_of(glb: &Glb, mesh: usize) -> Vec<[u8; 4]> {
    let items = glb.items(&glb.primitive(mesh)["attributes"]["COLOR_0"], 4);
    items.into_iter().map(|item| item.try_into().unwrap()).collect()
}

#[test]
fn glb_colours_run_from_blue_to_red_over_the_stated_range() {
    let mut contents = sample::roof(1.0, DVec3::ZERO);
    contents.unit = Unit::Millimetre;
    contents.vertex_attributes = vec![Attribute::new("mean_curvature", "1/mm", vec![0.0, 0.5, 1.0, 1.5, 2.0])];
    let archive = archive(contents);
    let of_range = |range| Glb::with(&archive, colors(Quantity::MeanCurvature, range));
    let glb = of_range(None);
    let stated = |glb: &Glb| glb.document["asset"]["extras"]["color_range"].clone();
    let scale = stated(&glb);
    assert_eq!((&scale["quantity"], &scale["unit"]), (&json!("mean_curvature"), &json!("1/mm")));
    assert_eq!((&scale["min"], &scale["max"]), (&json!(0.0), &json!(2.0)));
    assert_eq!(scale["stops"].as_array().unwrap().len(), 5);
    assert_eq!(scale, glb.document["scenes"][0]["extras"]["color_range"]);
    assert_eq!(glb.floats(&glb.primitive(0)["attributes"]["_MEAN_CURVATURE"]), [0.0, 500.0, 1000.0, 1500.0, 2000.0]);
    assert_eq!(colors_of(&glb, 0), [BLUE, CYAN, GREEN, YELLOW, RED]);
    assert_eq!(glb.document["materials"][0]["pbrMetallicRoughness"]["baseColorFactor"], json!([1.0, 1.0, 1.0, 1.0]));

    // Values beyond the range are red.
    let glb = of_range(Some(1.0));
    assert_eq!(stated(&glb)["max"], json!(1.0));
    assert_eq!(colors_of(&glb, 0), [BLUE, GREEN, RED, RED, RED]);
    assert_eq!(colors_of(&of_range(Some(4.0)), 0)[4], GREEN);
}

#[test]
fn the_default_scale_of_the_curvature_ends_at_its_95th_percentile_but_not_below_the_least_range() {
    let mut contents = sample::roof(1.0, DVec3::ZERO);
    let apex = contents.mesh.vertices[4];
    contents.mesh.vertices.resize(100, apex);
    let values: Vec<f64> = (1..=100).rev().map(f64::from).collect();
    let mut found = |values, least_range| {
        let curvature = Attribute::new("mean_curvature", "1/m", values).ending_at_percentile(0.95, least_range);
        contents.vertex_attributes = vec![curvature];
        let glb = Glb::with(&archive(contents.clone()), colors(Quantity::MeanCurvature, None));
        (glb.document["asset"]["extras"]["color_range"]["max"].as_f64().unwrap(), colors_of(&glb, 0))
    };
    let (max, all) = found(values.clone(), 1.0);
    assert_eq!((max, all.iter().filter(|&&color| color == RED).count()), (95.0, 6));
    assert_eq!(found(values, 200.0).0, 200.0);
    // Values far below the least range stay blue, and zero curvature causes no division by zero.
    for (values, least_range) in [(vec![1e-12; 100], 1.0), (vec![0.0; 100], 0.0)] {
        let (max, all) = found(values, least_range);
        assert!(max == least_range && all.iter().all(|&color| color == BLUE), "{all:?}");
    }
}

#[test]
fn lines_and_slack_have_colours_too() {
    let mut contents = sample::full().contents().clone();
    contents.vertex_attributes.push(slack(vec![0.0, 0.25, 0.5, 0.75, 1.0]));
    let full = archive(contents.clone());
    let tight = Glb::with(&full, colors(Quantity::LowerBoundSlack, None));
    assert_eq!(colors_of(&tight, 0), [BLUE, CYAN, GREEN, YELLOW, RED]);

    // The members of the sample have the lengths 2.5 and 0.125. Each line has its colour at both ends.
    let length = Glb::with(&full, colors(Quantity::Length, Some(0.25)));
    assert_eq!(colors_of(&length, 3), [RED, RED, GREEN, GREEN]);
    assert!(length.primitive(0)["attributes"].get("COLOR_0").is_none());
    let scale = &length.document["asset"]["extras"]["color_range"];
    assert_eq!((&scale["quantity"], &scale["unit"]), (&json!("length"), &json!("cm")));
    let largest = Glb::with(&full, colors(Quantity::Length, None));
    assert_eq!(largest.document["asset"]["extras"]["color_range"]["max"], json!(2.5));

    // Values below zero are blue, and the arrows of reactions keep their own colour.
    let forces = |values: Vec<f64>| vec![Attribute::new("force", "kN", values)];
    let arrow = [[0.0; 3], [0.0, 0.0, 1.0]];
    contents.line_sets = vec![
        sample::line_set("cables", Lines::Segments(vec![[0, 4], [1, 4]]), forces(vec![4.0, -1.0])),
        sample::line_set("masts", Lines::Segments(vec![[2, 4]]), forces(vec![2.0])),
        sample::line_set("reactions", Lines::Arrows(vec![arrow]), forces(vec![100.0])),
    ];
    let force = Glb::with(&archive(contents), colors(Quantity::Force, None));
    assert_eq!(colors_of(&force, 1), [RED, RED, BLUE, BLUE]);
    assert_eq!(colors_of(&force, 2), [GREEN, GREEN]);
    assert!(force.primitive(3)["attributes"].get("COLOR_0").is_none());
    assert_eq!(force.document["asset"]["extras"]["color_range"]["unit"], "kN");
}

/// Returns the sample strip, whose bridges have these marks.
fn marked_strip(concave: [f64; 4]) -> Archive {
    let mut contents = sample::strip();
    contents.line_sets[0].attributes =
        vec![Attribute { range: [0.0, 1.0], ..Attribute::new("concave", "", concave.to_vec()) }];
    archive(contents)
}

/// Returns the colour of each triangle of the surface, whose three vertices must agree.
fn colors_of_triangles(glb: &Glb) -> Vec<[u8; 4]> {
    let at_vertices = colors_of(glb, 0);
    let indices = glb.indices(&glb.primitive(0)["indices"]);
    let one = |triangle: &[u32]| {
        let [a, b, c] = [0, 1, 2].map(|k| at_vertices[triangle[k] as usize]);
        assert!(a == b && b == c, "{a:?} {b:?} {c:?}");
        a
    };
    indices.chunks(3).map(one).collect()
}

#[test]
fn triangles_between_concave_bridges_are_red() {
    let strip = marked_strip([0.0, 1.0, 1.0, 0.0]);
    let contents = strip.contents();
    let asked = colors(Quantity::Convexity, None);
    let glb = Glb::with(&strip, asked);
    assert_eq!(colors_of_triangles(&glb), [GREEN, RED, GREEN]);
    assert_eq!(colors_of(&glb, 1), [BLUE, BLUE, RED, RED, RED, RED, BLUE, BLUE]);
    assert_eq!(glb.floats(&glb.primitive(1)["attributes"]["_CONCAVE"]), [0.0, 0.0, 1.0, 1.0, 1.0, 1.0, 0.0, 0.0]);
    let scale = &glb.document["asset"]["extras"]["color_range"];
    assert_eq!((&scale["quantity"], &scale["min"], &scale["max"]), (&json!("convexity"), &json!(0.0), &json!(1.0)));

    // The vertices of the mesh come first. The copies have their places and normals, so the shading is the same.
    let plain = Glb::of(&strip);
    assert!(plain.primitive(0)["attributes"].get("COLOR_0").is_none());
    let at = |glb: &Glb, name: &str| glb.vectors(&glb.primitive(0)["attributes"][name]);
    let (places, normals) = (at(&plain, "POSITION"), at(&plain, "NORMAL"));
    assert_eq!(
        (at(&glb, "POSITION")[..5].to_vec(), at(&glb, "NORMAL")[..5].to_vec()),
        (places.clone(), normals.clone())
    );
    let [corners, original] = [&glb, &plain].map(|glb| glb.indices(&glb.primitive(0)["indices"]));
    for (corner, original) in corners.into_iter().zip(original) {
        let (corner, original) = (corner as usize, original as usize);
        assert_eq!(at(&glb, "POSITION")[corner], places[original]);
        assert_eq!(at(&glb, "NORMAL")[corner], normals[original]);
    }
    assert_eq!(at(&glb, "POSITION").len(), 8, "three vertices lie between two colours");

    // The range makes a triangle with one concave bridge red too. Convex strips are blue. Without lines the triangles
    // keep their colours.
    assert_eq!(colors_of_triangles(&Glb::with(&strip, colors(Quantity::Convexity, Some(0.5)))), [RED; 3]);
    assert_eq!(colors_of_triangles(&Glb::with(&marked_strip([0.0; 4]), asked)), [BLUE; 3]);
    let without_lines = Glb::with(&strip, Choices { lines: false, ..asked });
    assert_eq!(colors_of_triangles(&without_lines), [GREEN, RED, GREEN]);

    // PLY has the same vertices, triangles and colours.
    let ply = String::from_utf8(with(MeshFormat::Ply, contents, Choices { ascii: true, ..asked })).unwrap();
    let (header, body) = ply.split_once("end_header\n").unwrap();
    assert!(header.contains("element vertex 8\n") && header.contains("element face 3\n"), "{header}");
    let rows: Vec<Vec<f64>> =
        body.lines().map(|row| row.split(' ').map(|number| number.parse().unwrap()).collect()).collect();
    for (row, color) in rows.iter().zip(colors_of(&glb, 0)) {
        assert_eq!(row[3..], color.map(f64::from)[..3]);
    }
    for (row, vertex) in rows.iter().zip(&contents.mesh.vertices) {
        assert_eq!(row[..3], vertex.to_array());
    }
    let faces: Vec<f64> = rows[8..].iter().flat_map(|row| row[1..].to_vec()).collect();
    assert_eq!(faces, glb.indices(&glb.primitive(0)["indices"]).into_iter().map(f64::from).collect::<Vec<_>>());
}

#[test]
fn a_quantity_that_the_file_does_not_have_is_an_error_that_names_those_it_has() {
    let refused = |format: MeshFormat, archive: &Archive, choices| match format.encode_with(archive, choices) {
        Err(error @ Error::NoQuantity { .. }) => error.to_string(),
        other => panic!("{other:?}"),
    };
    let (full, bare) = (sample::full(), archive(sample::roof(1.0, DVec3::ZERO)));
    let force = colors(Quantity::Force, None);
    assert_eq!(
        refused(MeshFormat::Glb, &full, force),
        "this file has no force to be coloured by; it has mean_curvature, length"
    );
    assert_eq!(
        refused(MeshFormat::Gltf, &bare, force),
        "this file has no force to be coloured by; it has none of the quantities"
    );
    let convexity = colors(Quantity::Convexity, None);
    assert_eq!(
        refused(MeshFormat::Glb, &full, convexity),
        "this file has no convexity to be coloured by; it has mean_curvature, length"
    );
    assert_eq!(
        refused(MeshFormat::Ply, &marked_strip([0.0; 4]), force),
        "this file has no force to be coloured by; it has convexity"
    );
    // The quantities of lines are missing in a file without lines. They are missing in PLY too,
    // whose colours are at vertices.
    let length = colors(Quantity::Length, None);
    let only = "this file has no length to be coloured by; it has mean_curvature";
    assert_eq!(refused(MeshFormat::Glb, &full, Choices { lines: false, ..length }), only);
    assert_eq!(refused(MeshFormat::Ply, &full, length), only);
}

#[test]
fn glb_lines_are_separate_nodes() {
    let archive = sample::full();
    let glb = Glb::of(&archive);
    let nodes = glb.document["nodes"].as_array().unwrap();
    let names: Vec<_> = nodes.iter().map(|node| node["name"].as_str().unwrap()).collect();
    assert_eq!(names, ["surface", "boundaries", "bridges", "members lattice"], "an empty set must have no node");
    assert_eq!(glb.document["scenes"][0]["nodes"], json!([0, 1, 2, 3]));

    let strip = glb.primitive(1);
    assert_eq!((&strip["mode"], glb.indices(&strip["indices"])), (&json!(3), vec![0, 1, 2, 3, 0]));
    assert_eq!(strip["attributes"]["POSITION"], glb.primitive(0)["attributes"]["POSITION"]);
    let lines = glb.primitive(2);
    assert_eq!((&lines["mode"], glb.indices(&lines["indices"])), (&json!(1), vec![0, 4, 1, 4]));
    let members = glb.primitive(3);
    assert_eq!(members["mode"], json!(1));
    assert_eq!(glb.floats(&members["attributes"]["_LENGTH"]), [2.5, 2.5, 0.125, 0.125]);
    assert_eq!(nodes[3]["extras"], json!({ "_LENGTH": { "unit": "cm" }, "_STRAIN": { "unit": "" } }));
    let ends = glb.vectors(&members["attributes"]["POSITION"]);
    let positions = glb.vectors(&glb.primitive(0)["attributes"]["POSITION"]);
    assert_eq!(ends, [positions[2], positions[4], positions[3], positions[4]]);
}

#[test]
fn glb_extras_have_the_statistics_and_the_vertices_of_the_input() {
    let glb = Glb::of(&sample::full());
    let extras = &glb.document["asset"]["extras"];
    assert_eq!(extras["statistics"], json!({ "area": 1.25, "converged": true }));
    assert_eq!(extras["input_vertices"], json!([[0, 1, 1, 2, 3]]));
    assert_eq!((&extras["unit"], &extras["up"]), (&json!("cm"), &json!("z")));
}

#[test]
fn gltf_json_is_the_same_document_with_the_buffer_embedded() {
    let archive = sample::full();
    let glb = Glb::of(&archive);
    let mut document: Value = serde_json::from_slice(&MeshFormat::Gltf.encode(&archive).unwrap()).unwrap();
    let uri = document["buffers"][0]["uri"].take();
    let text = uri.as_str().unwrap().strip_prefix("data:application/octet-stream;base64,").unwrap().to_owned();
    assert_eq!(base64_decoded(&text), glb.buffer);
    document["buffers"][0].as_object_mut().unwrap().remove("uri");
    assert_eq!(document, glb.document);
}

/// Returns the values of a custom attribute, such as `MEAN_CURVATURE`.
fn custom(primitive: &gltf::Primitive<'_>, name: &str, buffer: &[u8]) -> Option<Vec<f32>> {
    let accessor = primitive.get(&gltf::Semantic::Extras(name.into()))?;
    Some(gltf::accessor::Iter::new(accessor, |_| Some(buffer)).unwrap().collect())
}

#[test]
fn the_importer_of_the_crate_gltf_reads_every_file_back() {
    let mut net = sample::full().contents().clone();
    net.mesh.triangles.clear();
    net.triangle_attributes.clear();
    net.line_sets[1].name = "cables".into();
    let mut proven = sample::full().contents().clone();
    proven.vertex_attributes.push(slack(vec![0.0, 0.25, 0.5, 0.75, 1.0]));
    let far = sample::roof(1.0, DVec3::new(1e7, -1e7 + 0.125, 3e6));
    for contents in [net, proven, far, with_degenerate_parts(1.0).0] {
        let archive = archive(contents.clone());
        let colored = contents.at_vertices("mean_curvature").is_some();
        for (format, colored) in [(MeshFormat::Glb, false), (MeshFormat::Gltf, false), (MeshFormat::Glb, colored)] {
            let choices = if colored { colors(Quantity::MeanCurvature, Some(0.02)) } else { Choices::default() };
            let (document, buffer) = imported(&format.encode_with(&archive, choices).unwrap());
            let mut nodes = document.default_scene().unwrap().nodes();
            let mesh = nodes.next().unwrap().mesh().unwrap();
            let primitive = mesh.primitives().next().unwrap();
            let reader = primitive.reader(|_| Some(&buffer));
            let (origin, metres) = (contents.origin(), contents.unit.metres());
            let positions: Vec<[f32; 3]> = reader.read_positions().unwrap().collect();
            let expected = contents.mesh.vertices.iter().map(|&vertex| {
                let local = (vertex - origin) * metres;
                [local.x as f32, local.z as f32, -local.y as f32]
            });
            assert_eq!(positions, expected.collect::<Vec<_>>());
            if contents.mesh.triangles.is_empty() {
                assert_eq!((primitive.mode(), mesh.name()), (gltf::mesh::Mode::Points, Some("vertices")));
            } else {
                let indices: Vec<u32> = reader.read_indices().unwrap().into_u32().collect();
                assert_eq!(
                    (primitive.mode(), indices),
                    (gltf::mesh::Mode::Triangles, contents.mesh.triangles.concat())
                );
                assert_eq!(reader.read_normals().unwrap().len(), positions.len());
            }
            let expected = |name: &str, unit: f64| {
                let known = contents.at_vertices(name)?;
                Some(known.values.iter().map(|value| (value / unit) as f32).collect::<Vec<_>>())
            };
            assert_eq!(custom(&primitive, "MEAN_CURVATURE", &buffer), expected("mean_curvature", metres));
            assert_eq!(custom(&primitive, "LOWER_BOUND_SLACK", &buffer), expected("lower_bound_slack", 1.0));
            let red = reader.read_colors(0).map(|colors| colors.into_rgba_u8().last());
            assert_eq!(red, colored.then_some(Some(RED)));
            for set in contents.line_sets.iter().filter(|set| set.name != "directrices") {
                let mesh = nodes.next().unwrap().mesh().unwrap();
                assert_eq!(mesh.name(), Some(set.full_name().as_str()));
                let line = mesh.primitives().next().unwrap();
                let reader = line.reader(|_| Some(&buffer));
                let indices: Option<Vec<u32>> = reader.read_indices().map(|indices| indices.into_u32().collect());
                match &set.lines {
                    Lines::Polylines(_) => assert_eq!(indices, Some(vec![0, 1, 2, 3, 0])),
                    Lines::Segments(pairs) if set.attributes.is_empty() => assert_eq!(indices, Some(pairs.concat())),
                    _ => {
                        assert_eq!(custom(&line, "LENGTH", &buffer), Some(vec![2.5, 2.5, 0.125, 0.125]));
                        assert_eq!(custom(&line, "STRAIN", &buffer), Some(vec![0.0, 0.0, 0.5, 0.5]));
                    }
                }
            }
            assert!(nodes.next().is_none());
        }
    }
    let parts = [("one".to_owned(), sample::full()), ("two".to_owned(), archive(sample::roof(1.0, DVec3::ZERO)))];
    let (document, _) = imported(&plateau_archive::formats::gltf::to_glb_scene("batch", &parts).unwrap());
    let names =
        document.default_scene().unwrap().nodes().map(|node| (node.name().unwrap().to_owned(), node.children().len()));
    assert_eq!(names.collect::<Vec<_>>(), [("one".to_owned(), 4), ("two".to_owned(), 1)]);
}

fn base64_decoded(text: &str) -> Vec<u8> {
    let digit = |c: u8| match c {
        b'A'..=b'Z' => u32::from(c - b'A'),
        b'a'..=b'z' => u32::from(c - b'a') + 26,
        b'0'..=b'9' => u32::from(c - b'0') + 52,
        b'+' => 62,
        b'/' => 63,
        _ => 0,
    };
    let mut out: Vec<u8> = text
        .as_bytes()
        .chunks(4)
        .flat_map(|four| four.iter().fold(0, |bits, &c| bits << 6 | digit(c)).to_be_bytes()[1..].to_vec())
        .collect();
    out.truncate(out.len() - text.bytes().filter(|&c| c == b'=').count());
    out
}

#[test]
fn coordinates_beyond_f32_are_refused_by_f32_formats_only() {
    for (scale, offset) in [(1e39, DVec3::ZERO), (1e308, DVec3::ZERO), (1e-40, DVec3::ZERO)] {
        let archive = archive(sample::roof(scale, offset));
        for format in [MeshFormat::Glb, MeshFormat::Gltf] {
            assert!(matches!(format.encode(&archive), Err(Error::OutOfRange { format: "glTF", .. })), "{scale}");
        }
        assert!(MeshFormat::Obj.encode(&archive).is_ok() && MeshFormat::Ply.encode(&archive).is_ok());
    }
    let archive = archive(sample::roof(1.0, DVec3::X * 1e39));
    let given = MeshFormat::Stl.encode_with(&archive, choices(Origin::Given));
    assert!(matches!(given, Err(Error::OutOfRange { format: "STL", .. })));
    assert!(MeshFormat::Stl.encode(&archive).is_ok(), "the mesh is written around its middle");
}

fn bits(vertices: &[DVec3]) -> Vec<[u64; 3]> {
    vertices.iter().map(|v| v.to_array().map(f64::to_bits)).collect()
}

#[test]
fn obj_reads_back_to_the_same_bits() {
    let archive = sample::awkward();
    let text = String::from_utf8(MeshFormat::Obj.encode(&archive).unwrap()).unwrap();
    let mut vertices = Vec::new();
    let mut triangles = Vec::new();
    for line in text.lines() {
        let mut words = line.split(' ');
        match words.next() {
            Some("v") => vertices.push(DVec3::from_slice(&words.map(|w| w.parse().unwrap()).collect::<Vec<f64>>())),
            Some("f") => triangles.push(words.map(|w| w.parse::<u32>().unwrap() - 1).collect::<Vec<_>>()),
            _ => {}
        }
    }
    assert_eq!(bits(&vertices), bits(&archive.contents().mesh.vertices));
    assert_eq!(triangles.concat(), archive.contents().mesh.triangles.concat());
}

#[test]
fn obj_has_the_line_sets_and_each_text_on_one_line() {
    let text = String::from_utf8(MeshFormat::Obj.encode(&sample::full()).unwrap()).unwrap();
    assert!(text.starts_with("# plateau test\n# unit cm, z up\nv "), "{text}");
    assert!(
        text.contains("\no boundaries\nl 1 2 3 4 1\no bridges\nl 1 5\nl 2 5\no members lattice\nl 3 5\nl 4 5\n"),
        "{text}"
    );
    let known = ["#", "v", "o", "f", "l"];
    assert!(text.lines().all(|line| known.contains(&line.split(' ').next().unwrap())), "{text}");
}

#[test]
fn ply_reads_back_to_the_same_bits() {
    let archive = sample::awkward();
    let bytes = MeshFormat::Ply.encode(&archive).unwrap();
    let end = bytes.windows(11).position(|w| w == b"end_header\n").unwrap() + 11;
    let header = std::str::from_utf8(&bytes[..end]).unwrap();
    assert_eq!(
        header,
        "ply\nformat binary_little_endian 1.0\ncomment plateau test\ncomment unit m, z up\nelement vertex 5\n\
         property double x\nproperty double y\nproperty double z\nelement face 4\n\
         property list uchar uint vertex_indices\nend_header\n"
    );
    let (vertices, faces) = bytes[end..].split_at(5 * 24);
    let vertices: Vec<DVec3> = vertices
        .chunks(24)
        .map(|v| DVec3::from_slice(&v.chunks(8).map(|x| f64::from_le_bytes(x.try_into().unwrap())).collect::<Vec<_>>()))
        .collect();
    assert_eq!(bits(&vertices), bits(&archive.contents().mesh.vertices));
    let faces: Vec<_> = faces.chunks(13).map(|f| (f[0], [word(f, 1), word(f, 5), word(f, 9)])).collect();
    let expected: Vec<_> = archive.contents().mesh.triangles.iter().map(|&t| (3, t)).collect();
    assert_eq!(faces, expected);
}

#[test]
fn ply_has_the_mean_curvature_and_the_colours_of_gltf() {
    let full = sample::full();
    let split = |choices| {
        let bytes = MeshFormat::Ply.encode_with(&full, choices).unwrap();
        let end = bytes.windows(11).position(|w| w == b"end_header\n").unwrap() + 11;
        (String::from_utf8(bytes[..end].to_vec()).unwrap(), bytes[end..].to_vec())
    };
    let (header, body) = split(Choices::default());
    assert!(
        header.contains("\nproperty double z\nproperty double mean_curvature\nproperty float quality\nelement face")
    );
    assert_eq!(body.len(), 5 * 36 + 4 * 13);
    let last = &body[4 * 36..5 * 36];
    assert_eq!(f64::from_le_bytes(last[24..32].try_into().unwrap()), 0.02);
    assert_eq!(f32::from_le_bytes(last[32..36].try_into().unwrap()), 0.02);

    let choices = colors(Quantity::MeanCurvature, Some(0.03));
    let (header, body) = split(choices);
    assert!(header.contains("quality\nproperty uchar red\nproperty uchar green\nproperty uchar blue\nelement face"));
    assert_eq!(body.len(), 5 * 39 + 4 * 13);
    let of_glb = colors_of(&Glb::with(&full, choices), 0);
    assert_ne!(of_glb[4], RED);
    assert_eq!(body[4 * 39 + 36..5 * 39], of_glb[4][..3]);
}

#[test]
fn the_slack_of_a_lower_bound_is_in_glb_and_ply() {
    let known = vec![0.0, 0.25, 0.5, 0.75, 1.0];
    let mut contents = sample::full().contents().clone();
    contents.vertex_attributes.push(slack(known.clone()));
    let glb = Glb::of(&archive(contents.clone()));
    let values = glb.items(&glb.primitive(0)["attributes"]["_LOWER_BOUND_SLACK"], 4);
    let values: Vec<f64> = values.iter().map(|x| f32::from_le_bytes(x[..].try_into().unwrap()).into()).collect();
    assert_eq!(values, known);
    let text = with(MeshFormat::Ply, &contents, Choices { ascii: true, ..Choices::default() });
    let text = String::from_utf8(text).unwrap();
    let rows = text.split_once("property double lower_bound_slack\nelement face 4\n").unwrap().1.lines().skip(2);
    let values: Vec<f64> = rows.take(5).map(|row| row.rsplit(' ').next().unwrap().parse().unwrap()).collect();
    assert_eq!(values, known);
    let bytes = with(MeshFormat::Ply, &contents, Choices::default());
    let end = bytes.windows(11).position(|w| w == b"end_header\n").unwrap() + 11;
    assert_eq!(bytes.len(), end + 5 * 44 + 4 * 13);
    assert_eq!(f64::from_le_bytes(bytes[end + 44 + 36..end + 88].try_into().unwrap()), 0.25);
}

fn with(format: MeshFormat, contents: &Contents, choices: Choices) -> Vec<u8> {
    format.encode_with(&archive(contents.clone()), choices).unwrap()
}

fn choices(origin: Origin) -> Choices {
    Choices { origin, ..Choices::default() }
}

#[test]
fn ply_as_text_reads_back_to_the_same_bits() {
    for contents in [sample::awkward().contents().clone(), sample::full().contents().clone()] {
        let text = with(MeshFormat::Ply, &contents, Choices { ascii: true, ..Choices::default() });
        let text = String::from_utf8(text).unwrap();
        let (header, body) = text.split_once("end_header\n").unwrap();
        assert!(header.starts_with("ply\nformat ascii 1.0\n"), "{header}");
        let columns = header.lines().filter(|line| line.starts_with("property ") && !line.contains("list")).count();
        let rows: Vec<Vec<f64>> =
            body.lines().map(|line| line.split(' ').map(|word| word.parse().unwrap()).collect()).collect();
        let (vertices, faces) = rows.split_at(contents.mesh.vertices.len());
        assert!(vertices.iter().all(|row| row.len() == columns));
        let read: Vec<DVec3> = vertices.iter().map(|row| DVec3::from_slice(row)).collect();
        assert_eq!(bits(&read), bits(&contents.mesh.vertices));
        if let Some(curvature) = contents.at_vertices("mean_curvature") {
            assert_eq!(vertices.iter().map(|row| row[3]).collect::<Vec<_>>(), curvature.values);
        }
        let triangles: Vec<[u32; 3]> = faces.iter().map(|row| [1, 2, 3].map(|k| row[k] as u32)).collect();
        assert_eq!(triangles, contents.mesh.triangles);
    }
}

/// A roof of one metre, a thousand kilometres away.
fn far_roof() -> Contents {
    sample::roof(1.0, DVec3::new(1e6, -5e6, 300.0))
}

#[test]
fn every_format_can_be_relative_to_the_middle_of_the_mesh() {
    let contents = far_roof();
    let origin = contents.origin();
    let expected: Vec<DVec3> = contents.mesh.vertices.iter().map(|&vertex| vertex - origin).collect();
    let local = |format| with(format, &contents, choices(Origin::Local));
    let mesh: Value = serde_json::from_slice(&local(MeshFormat::Json)).unwrap();
    assert_eq!(mesh["origin"], json!(origin.to_array()));
    assert_eq!(mesh["vertices"], json!(expected.iter().map(DVec3::to_array).collect::<Vec<_>>()));
    let obj = String::from_utf8(local(MeshFormat::Obj)).unwrap();
    let first = expected[0];
    assert!(obj.contains(&format!("\nv {:?} {:?} {:?}\n", first.x, first.y, first.z)), "{obj}");
    assert!(obj.contains(&format!("\n# origin {:?} {:?} {:?}\n", origin.x, origin.y, origin.z)), "{obj}");
    let ply = local(MeshFormat::Ply);
    let end = ply.windows(11).position(|w| w == b"end_header\n").unwrap() + 11;
    let comment = format!("\ncomment origin {:?} {:?} {:?}\n", origin.x, origin.y, origin.z);
    assert!(std::str::from_utf8(&ply[..end]).unwrap().contains(&comment));
    assert_eq!(f64::from_le_bytes(ply[end..end + 8].try_into().unwrap()), first.x);
    let gltf: Value = serde_json::from_slice(&local(MeshFormat::Gltf)).unwrap();
    assert_eq!(gltf["nodes"][0]["translation"], json!([0.0, 0.0, 0.0]));
    assert_eq!(gltf["asset"]["extras"]["origin"], json!(origin.to_array()));
}

#[test]
fn stl_of_a_far_mesh_is_relative_to_its_middle_unless_asked_otherwise() {
    let contents = far_roof();
    let corner = |bytes: &[u8]| f32::from_bits(word(bytes, 84 + 12));
    let (first, origin) = (contents.mesh.vertices[0].x, contents.origin().x);
    assert!(contents.is_far_from_zero());
    assert_eq!(corner(&with(MeshFormat::Stl, &contents, Choices::default())), (first - origin) as f32);
    assert_eq!(corner(&with(MeshFormat::Stl, &contents, choices(Origin::Given))), first as f32);
    let near = sample::roof(1.0, DVec3::new(100.0, 0.0, 0.0));
    assert!(!near.is_far_from_zero());
    assert_eq!(corner(&with(MeshFormat::Stl, &near, Choices::default())), 100.0);
    assert_eq!(corner(&with(MeshFormat::Stl, &near, choices(Origin::Local))), -0.5);
}

#[test]
fn lines_can_be_left_out() {
    let without = Choices { lines: false, ..Choices::default() };
    let full = sample::full();
    let gltf: Value = serde_json::from_slice(&MeshFormat::Gltf.encode_with(&full, without).unwrap()).unwrap();
    assert_eq!((gltf["nodes"].as_array().unwrap().len(), gltf["meshes"].as_array().unwrap().len()), (1, 1));
    let obj = String::from_utf8(MeshFormat::Obj.encode_with(&full, without).unwrap()).unwrap();
    assert!(!obj.contains("\nl ") && obj.contains("\nf 1 2 5\n"), "{obj}");
    let mesh: Value = serde_json::from_slice(&MeshFormat::Json.encode_with(&full, without).unwrap()).unwrap();
    assert_eq!(mesh["lines"], json!([]));
}

/// Blender drops the extras of the asset and keeps those of scenes and nodes.
#[test]
fn scene_and_surface_have_extras_too() {
    let glb = Glb::of(&sample::full());
    let (asset, scene) = (&glb.document["asset"]["extras"], &glb.document["scenes"][0]["extras"]);
    for name in ["origin", "unit", "up", "title", "statistics"] {
        assert_eq!(asset[name], scene[name], "{name}");
    }
    let surface = &glb.document["nodes"][0]["extras"];
    let origin = ["origin_x", "origin_y", "origin_z"].map(|name| surface[name].clone());
    assert_eq!((&json!(origin), &surface["unit"]), (&asset["origin"], &asset["unit"]));
    // Assimp ends when it copies a node whose extras have a list or an object.
    assert!(surface.as_object().unwrap().values().all(|value| !value.is_array() && !value.is_object()));
}

#[test]
fn stl_holds_each_triangle_with_its_normal() {
    for scale in [1.0, 1e-30, 1e30] {
        let archive = archive(sample::roof(scale, DVec3::ZERO));
        let bytes = MeshFormat::Stl.encode(&archive).unwrap();
        assert!(!bytes.starts_with(b"solid"));
        assert_eq!((bytes.len(), word(&bytes, 80)), (84 + 4 * 50, 4));
        for (facet, &triangle) in bytes[84..].chunks(50).zip(&archive.contents().mesh.triangles) {
            let vectors: Vec<DVec3> = facet[..48]
                .chunks(12)
                .map(|v| DVec3::from_slice(&[0, 4, 8].map(|at| f64::from(f32::from_bits(word(v, at))))))
                .collect();
            let corners = archive.contents().mesh.corners(triangle);
            assert_eq!(vectors[1..], corners.map(|c| DVec3::from_array(c.to_array().map(|x| f64::from(x as f32)))));
            let expected = ((corners[1] - corners[0]) / scale).cross((corners[2] - corners[0]) / scale).normalize();
            assert!(vectors[0].distance(expected) < 1e-6, "{} instead of {expected}", vectors[0]);
        }
    }
}

#[test]
fn the_khronos_validator_finds_neither_errors_nor_warnings() {
    let folder = std::path::Path::new(env!("CARGO_TARGET_TMPDIR")).join("gltf");
    std::fs::create_dir_all(&folder).unwrap();
    let far = sample::roof(1.0, DVec3::new(1e7, -1e7 + 0.1, 3e6));
    let archives =
        [("everything", sample::full()), ("far", archive(far)), ("odd-places", archive(with_degenerate_parts(1.0).0))];
    for (name, archive) in archives {
        for format in [MeshFormat::Glb, MeshFormat::Gltf] {
            let bytes = format.encode(&archive).unwrap();
            imported(&bytes);
            std::fs::write(folder.join(format!("{name}.{}", format.name())), bytes).unwrap();
        }
    }
    for quantity in [Quantity::MeanCurvature, Quantity::Length] {
        let bytes = MeshFormat::Glb.encode_with(&sample::full(), colors(quantity, None)).unwrap();
        std::fs::write(folder.join(format!("{}.glb", quantity.name())), bytes).unwrap();
    }
    let strip = marked_strip([0.0, 1.0, 1.0, 0.0]);
    let bytes = MeshFormat::Glb.encode_with(&strip, colors(Quantity::Convexity, None)).unwrap();
    std::fs::write(folder.join("convexity.glb"), bytes).unwrap();
    let scripts = std::path::Path::new(env!("CARGO_MANIFEST_DIR")).join("../../scripts");
    if !scripts.join("node_modules/gltf-validator").exists() {
        skipped("Khronos validator of the formats", "npm has not installed gltf-validator in scripts");
        return;
    }
    let output =
        std::process::Command::new("node").arg(scripts.join("validate-gltf.mjs")).arg(&folder).output().unwrap();
    assert!(output.status.success(), "{}", String::from_utf8_lossy(&output.stdout));
}

#[test]
fn every_format_can_be_looked_up_by_its_name() {
    for format in MeshFormat::ALL {
        assert_eq!(MeshFormat::from_name(format.name()), Some(format));
    }
    assert_eq!(MeshFormat::from_name("GLB"), None);
}
