//! Tests of reading triangles from binary glTF files: what is read, and that every other file is refused with its
//! reason.

use plateau_archive::formats::{Choices, gltf};
use plateau_archive::glb::{GlbError, Triangles, read};
use plateau_archive::units::{Unit, UpAxis};
use plateau_archive::{Archive, Contents, LineSet, Lines};
use plateau_mesh::{DVec3, Mesh};
use proptest::prelude::*;
use serde_json::{Value, json};

/// Returns a file of a document and its buffer.
fn file(document: &Value, bin: &[u8]) -> Vec<u8> {
    let mut text = document.to_string().into_bytes();
    text.resize(text.len().next_multiple_of(4), b' ');
    let mut bytes = b"glTF\x02\0\0\0".to_vec();
    bytes.extend(((28 + text.len() + bin.len()) as u32).to_le_bytes());
    bytes.extend((text.len() as u32).to_le_bytes());
    bytes.extend(b"JSON");
    bytes.extend(text);
    bytes.extend((bin.len() as u32).to_le_bytes());
    bytes.extend(b"BIN\0");
    bytes.extend(bin);
    bytes
}

/// Returns the document and buffer of one triangle with indices of two bytes.
fn triangle() -> (Value, Vec<u8>) {
    let positions = [[0.0_f32, 0.0, 0.0], [1.0, 0.0, 0.0], [0.0, 2.0, 0.0]];
    let mut bin: Vec<u8> = positions.as_flattened().iter().flat_map(|x| x.to_le_bytes()).collect();
    bin.extend([0_u16, 1, 2, 0].iter().flat_map(|x| x.to_le_bytes()));
    let document = json!({
        "asset": { "version": "2.0" }, "scene": 0, "scenes": [{ "nodes": [0] }], "nodes": [{ "mesh": 0 }],
        "meshes": [{ "primitives": [{ "attributes": { "POSITION": 0 }, "indices": 1 }] }],
        "accessors": [
            { "bufferView": 0, "componentType": 5126, "type": "VEC3", "count": 3 },
            { "bufferView": 1, "componentType": 5123, "type": "SCALAR", "count": 3 },
        ],
        "bufferViews": [
            { "buffer": 0, "byteOffset": 0, "byteLength": 36 }, { "buffer": 0, "byteOffset": 36, "byteLength": 6 },
        ],
        "buffers": [{ "byteLength": 44 }],
    });
    (document, bin)
}

/// Reads one triangle after a change of its document, in metres with y up.
fn changed(change: impl FnOnce(&mut Value)) -> Result<Triangles, GlbError> {
    let (mut document, bin) = triangle();
    change(&mut document);
    read(&file(&document, &bin), Unit::Metre, UpAxis::Y, 100)
}

#[test]
fn a_written_file_is_read_back_in_every_unit_and_axis_within_its_rounding() {
    let corners = [[0.0, 0.0, 0.0], [1.0, 0.0, 0.1], [1.0, 1.0, 0.0], [0.0, 1.0, 0.1], [0.4, 0.6, 0.7]];
    for (unit, up, offset) in [
        (Unit::Metre, UpAxis::Z, DVec3::ZERO),
        (Unit::Millimetre, UpAxis::Y, DVec3::new(3.0, -5.0, 0.25)),
        (Unit::Foot, UpAxis::Z, DVec3::new(1e7, -1e7 + 0.125, 3e6)),
    ] {
        let vertices: Vec<DVec3> = corners.iter().map(|&corner| offset + DVec3::from_array(corner)).collect();
        let rim = Lines::Segments(vec![[0, 1]]);
        let contents = Contents {
            unit,
            up,
            mesh: Mesh::new(vertices.clone(), vec![[0, 1, 4], [1, 2, 4], [2, 3, 4], [3, 0, 4]]),
            line_sets: vec![LineSet { name: "rim".into(), group: String::new(), lines: rim, attributes: vec![] }],
            statistics: "{}".into(),
            ..Contents::default()
        };
        let archive = Archive::new(contents).unwrap();
        let Triangles { mesh, rounding } =
            read(&gltf::to_glb(&archive, Choices::default()).unwrap(), unit, up, 100).unwrap();
        assert_eq!(mesh.triangles, archive.contents().mesh.triangles);
        // Half a metre from the middle of the mesh, f32 is exact to 6e-8, and f64 to 4e-9 at ten thousand kilometres.
        assert!(rounding < 2e-6, "{rounding}");
        for (found, expected) in mesh.vertices.iter().zip(&vertices) {
            assert!(found.distance(*expected) <= rounding, "{found} instead of {expected}, rounding {rounding}");
        }
    }
}

#[test]
fn matrices_are_f64_and_apply_from_the_root_of_the_scene() {
    let far = 500_123.456_789;
    let turned = changed(|document| {
        document["scenes"][0]["nodes"] = json!([1]);
        document["nodes"] = json!([
            { "mesh": 0, "rotation": [0.0, 0.0, 0.5_f64.sqrt(), 0.5_f64.sqrt()], "scale": [2.0, 2.0, -2.0] },
            { "children": [0], "matrix": [1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1, 0, far, 0, 0, 1] },
        ]);
    })
    .unwrap();
    // A quarter turn about z takes x to y and y to -x. In a mirrored node the winding of the triangles is reversed.
    let expected = [DVec3::new(far, 0.0, 0.0), DVec3::new(far, 2.0, 0.0), DVec3::new(far - 4.0, 0.0, 0.0)];
    for (found, expected) in turned.mesh.vertices.iter().zip(&expected) {
        assert!(found.distance(*expected) < 1e-9, "{found} instead of {expected}");
    }
    assert_eq!(turned.mesh.triangles, [[0, 2, 1]]);
}

#[test]
fn equal_vertices_become_one() {
    let twice = changed(|document| {
        document["scenes"][0]["nodes"] = json!([0, 1]);
        document["nodes"] = json!([{ "mesh": 0 }, { "mesh": 0, "translation": [1, 0, 0] }]);
    })
    .unwrap();
    assert_eq!((twice.mesh.vertices.len(), twice.mesh.triangles), (5, vec![[0, 1, 2], [1, 3, 4]]));
}

#[test]
fn the_reason_for_refusing_a_file_names_the_place() {
    type Change = fn(&mut Value);
    let cases: [(&str, Change); 22] = [
        ("requires the extension KHR_draco", |d| d["extensionsRequired"] = json!(["KHR_draco_mesh_compression"])),
        ("no scene 3", |d| d["scene"] = json!(3)),
        ("names the node 7", |d| d["scenes"][0]["nodes"] = json!([7])),
        ("node 0 at two places", |d| d["scenes"][0]["nodes"] = json!([0, 0])),
        ("node 0 at two places", |d| d["nodes"][0]["children"] = json!([0])),
        ("names the mesh 5", |d| d["nodes"][0]["mesh"] = json!(5)),
        ("strips or fans in primitive 0 of mesh 0", |d| d["meshes"][0]["primitives"][0]["mode"] = json!(5)),
        ("strips or fans in primitive 0 of mesh 0", |d| d["meshes"][0]["primitives"][0]["mode"] = json!(99)),
        ("no triangles", |d| d["meshes"][0]["primitives"][0]["mode"] = json!(1)),
        ("no positions in primitive 0", |d| d["meshes"][0]["primitives"][0]["attributes"] = json!({ "NORMAL": 0 })),
        ("names the accessor 9", |d| d["meshes"][0]["primitives"][0]["indices"] = json!(9)),
        ("wrong number of components", |d| d["meshes"][0]["primitives"][0]["indices"] = json!(0)),
        ("names the vertex 2 of 2", |d| d["accessors"][0]["count"] = json!(2)),
        ("2 corners of triangles", |d| d["accessors"][1]["count"] = json!(2)),
        ("accessor 0 that are not f32", |d| d["accessors"][0]["componentType"] = json!(5120)),
        ("accessor 0, which is sparse", |d| d["accessors"][0]["type"] = json!("VEC9")),
        ("accessor 0 with more items", |d| d["accessors"][0]["count"] = json!(4)),
        ("accessor 0 with more items", |d| d["accessors"][0]["count"] = json!(u64::MAX)),
        ("accessor 1 with more items", |d| d["bufferViews"][1]["byteOffset"] = json!(40)),
        ("accessor 0 with more items", |d| d["bufferViews"][0]["byteStride"] = json!(4)),
        ("outside of the file's own buffer", |d| d["buffers"][0]["uri"] = json!("file:///etc/passwd")),
        ("not finite at vertex 1 of primitive 0", |_| {}),
    ];
    for (expected, change) in cases {
        let (mut document, mut bin) = triangle();
        if expected.starts_with("not finite") {
            bin[12..16].copy_from_slice(&f32::INFINITY.to_le_bytes());
        }
        change(&mut document);
        match read(&file(&document, &bin), Unit::Metre, UpAxis::Y, 100) {
            Err(GlbError::Invalid(detail)) if detail.contains(expected) => {}
            other => panic!("{expected}: {other:?}"),
        }
    }
    assert_eq!(read(&file(&triangle().0, &triangle().1), Unit::Metre, UpAxis::Y, 2), Err(GlbError::TooLarge));
    let nodes: Vec<Value> = (1..=100).map(|k| json!({ "children": [k] })).chain([json!({ "mesh": 0 })]).collect();
    let deep = changed(|document| document["nodes"] = json!(nodes));
    assert!(matches!(deep, Err(GlbError::Invalid(detail)) if detail.contains("below more than 64")));
    let wide = changed(|document| document["extras"] = json!(vec![json!({}); 100_000]));
    assert!(matches!(wide, Err(GlbError::Invalid(detail)) if detail.contains("more than 100000 objects")));
}

proptest! {
    /// Files that are cut or changed at a few bytes are refused or read, without a panic and within bounds. Half of the
    /// changes are to the buffer alone, because few changes of a document leave it readable.
    #[test]
    fn any_change_gives_a_mesh_or_a_refusal(
        in_buffer: bool,
        changes in prop::collection::vec((any::<prop::sample::Index>(), any::<u8>()), 0..6),
        length in any::<prop::sample::Index>(),
    ) {
        let (document, bin) = triangle();
        let mut bytes = file(&document, &bin);
        for (at, value) in changes {
            let first = if in_buffer { bytes.len() - bin.len() } else { 0 };
            let at = first + at.index(bytes.len() - first);
            bytes[at] = value;
        }
        for bytes in [&bytes[..], &bytes[..length.index(bytes.len())]] {
            if let Ok(Triangles { mesh, .. }) = read(bytes, Unit::Metre, UpAxis::Z, 100) {
                prop_assert!(mesh.triangles.iter().flatten().all(|&v| (v as usize) < mesh.vertices.len()));
            }
        }
    }
}
