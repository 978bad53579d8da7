//! Meshes that are downloaded as JSON have the form that requests accept as an initial mesh.

use crate::sample;
use plateau_archive::formats::{Choices, MeshFormat, Origin};
use plateau_archive::units::{Unit, UpAxis};
use plateau_archive::{Archive, Contents, Lines};
use plateau_engine::mesh::{LineValues, Mesh, MeshLines};
use plateau_mesh::DVec3;

fn bits(vertices: &[DVec3]) -> Vec<[u64; 3]> {
    vertices.iter().map(|v| v.to_array().map(f64::to_bits)).collect()
}

fn written(format: MeshFormat, contents: &Contents, origin: Origin) -> Vec<u8> {
    let archive = Archive::new(contents.clone()).unwrap();
    format.encode_with(&archive, Choices { origin, ..Choices::default() }).unwrap()
}

#[test]
fn json_has_every_number_and_the_documented_form() {
    let full = sample::full();
    let contents = full.contents();
    let mesh: Mesh = serde_json::from_slice(&MeshFormat::Json.encode(&full).unwrap()).unwrap();
    assert_eq!((mesh.unit, mesh.up, mesh.origin), (Unit::Centimetre, UpAxis::Z, [0.0; 3]));
    let read: Vec<DVec3> = mesh.vertices.iter().map(|&vertex| DVec3::from_array(vertex)).collect();
    assert_eq!(bits(&read), bits(&contents.mesh.vertices));
    assert_eq!((&mesh.triangles, &mesh.input_vertices), (&contents.mesh.triangles, &contents.input_vertices));
    assert_eq!(
        mesh.attributes.mean_curvature.as_ref(),
        contents.at_vertices("mean_curvature").map(|known| &known.values)
    );
    let lines = |name: &str, paths: Vec<Vec<u32>>| MeshLines { name: name.into(), paths, arrows: vec![], values: None };
    let length = LineValues { name: "length".into(), unit: "cm".into(), values: vec![2.5, 0.125] };
    assert_eq!(
        mesh.lines,
        [
            lines("boundaries", vec![vec![0, 1, 2, 3, 0]]),
            lines("bridges", vec![vec![0, 4], vec![1, 4]]),
            MeshLines { values: Some(length), ..lines("members lattice", vec![vec![2, 4], vec![3, 4]]) },
            lines("directrices", vec![]),
        ]
    );
    // Arrows have their own ends, which move with the origin.
    let mut contents = contents.clone();
    let ends = vec![[[1.0, 2.0, 3.0], [4.0, 5.0, 6.5]]];
    contents.line_sets = vec![sample::line_set("reactions", Lines::Arrows(ends.clone()), vec![])];
    let read = |origin| -> Mesh { serde_json::from_slice(&written(MeshFormat::Json, &contents, origin)).unwrap() };
    assert_eq!(read(Origin::Given).lines[0].arrows, ends);
    let (moved, origin) = (read(Origin::Local).lines[0].arrows[0][1], contents.origin());
    assert_eq!(DVec3::from_array(moved), DVec3::new(4.0, 5.0, 6.5) - origin);
    let obj = String::from_utf8(written(MeshFormat::Obj, &contents, Origin::Local)).unwrap();
    assert!(obj.contains(&format!("\nv {:?} {:?} {:?}\n", moved[0], moved[1], moved[2])), "{obj}");
    let bare: Mesh = serde_json::from_slice(&MeshFormat::Json.encode(&sample::awkward()).unwrap()).unwrap();
    assert_eq!(bare.attributes.mean_curvature, None);
}
