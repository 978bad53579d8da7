//! Sample archives for the export tests, with every kind of content, at any position and size.

use plateau_archive::units::{Unit, UpAxis};
use plateau_archive::{Archive, Attribute, Contents, LineSet, Lines, Polyline};
use plateau_mesh::{DVec3, Mesh};

/// Returns a roof of four triangles over a unit square, with its apex off the centre, scaled and moved.
pub fn roof(scale: f64, offset: DVec3) -> Contents {
    let corners = [[0.0, 0.0, 0.0], [1.0, 0.0, 0.1], [1.0, 1.0, 0.0], [0.0, 1.0, 0.1], [0.4, 0.6, 0.7]];
    let vertices = corners.iter().map(|&corner| offset + scale * DVec3::from_array(corner)).collect();
    Contents {
        generator: "plateau test".into(),
        title: "roof".into(),
        unit: Unit::Metre,
        up: UpAxis::Z,
        mesh: Mesh::new(vertices, vec![[0, 1, 4], [1, 2, 4], [2, 3, 4], [3, 0, 4]]),
        input_vertices: vec![vec![0, 1, 1, 2, 3]],
        statistics: r#"{"area":1.25,"converged":true}"#.into(),
        ..Contents::default()
    }
}

/// Returns a line set without a group.
pub fn line_set(name: &str, lines: Lines, attributes: Vec<Attribute>) -> LineSet {
    LineSet { name: name.into(), group: String::new(), lines, attributes }
}

/// Returns a strip of three triangles, which can be unrolled.
#[allow(dead_code, reason = "not every test that takes samples unrolls one")]
pub fn strip() -> Contents {
    let points = [[0.0, 0.0, 0.0], [1.0, 0.0, 0.5], [2.0, 0.0, 0.0], [0.0, 1.0, 0.0], [2.0, 1.5, 0.25]];
    let bridges = Lines::Segments(vec![[0, 3], [1, 3], [1, 4], [2, 4]]);
    Contents {
        generator: "plateau test".into(),
        title: "strip".into(),
        mesh: Mesh::new(points.map(DVec3::from_array).to_vec(), vec![[0, 1, 3], [1, 4, 3], [1, 2, 4]]),
        input_vertices: vec![vec![0, 1, 2], vec![3, 4]],
        line_sets: vec![line_set("bridges", bridges, vec![])],
        statistics: "{}".into(),
        unrolls: true,
        ..Contents::default()
    }
}

/// Returns the roof in centimetres with every part of an archive filled in.
pub fn full() -> Archive {
    let mut contents = roof(250.0, DVec3::new(3.0, -5.0, 0.25));
    contents.unit = Unit::Centimetre;
    contents.title = "roof <of> \"four\" & more — é\nx".into();
    contents.vertex_attributes = vec![Attribute::new("mean_curvature", "1/cm", vec![0.0, 0.0, 0.0, 0.0, 0.02])];
    contents.triangle_attributes = vec![Attribute::new("ply", "", vec![1.0, 1.0, 2.0, 2.0])];
    let boundary = Polyline { vertices: vec![0, 1, 2, 3], closed: true };
    let members = LineSet {
        group: "lattice".into(),
        ..line_set(
            "members",
            Lines::Segments(vec![[2, 4], [3, 4]]),
            vec![Attribute::new("length", "cm", vec![2.5, 0.125]), Attribute::new("strain", "", vec![0.0, 0.5])],
        )
    };
    contents.line_sets = vec![
        line_set("boundaries", Lines::Polylines(vec![boundary]), vec![]),
        line_set("bridges", Lines::Segments(vec![[0, 4], [1, 4]]), vec![]),
        members,
        line_set("directrices", Lines::Polylines(Vec::new()), vec![]),
    ];
    Archive::new(contents).expect("the sample is sound")
}

/// Returns a mesh whose coordinates have awkward shortest texts: many digits, exponents, a signed zero, and a large
/// offset.
pub fn awkward() -> Archive {
    let mut contents = roof(1.0, DVec3::new(500_123.456_789_012_3, 1e7 / 3.0, -0.1));
    contents.mesh.vertices[0] = DVec3::new(f64::MIN_POSITIVE / 8.0, -0.0, 0.1 + 0.2);
    contents.mesh.vertices[1] = DVec3::new(1e300, -1e-300, 123_456_789.012_345_67);
    Archive::new(contents).expect("the sample is sound")
}
