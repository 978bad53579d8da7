//! The stored artefact: archives read back unchanged, and invalid bytes are refused safely.

use crate::sample;
use plateau_archive::{Archive, Attribute, Contents, Defect, Lines, Polyline};
use plateau_mesh::DVec3;
use proptest::prelude::*;
use sha2::{Digest, Sha256};

/// Appends a matching checksum, so that changes to the body are not refused by the checksum alone.
fn signed(mut body: Vec<u8>) -> Vec<u8> {
    let checksum = Sha256::digest(&body);
    body.extend_from_slice(&checksum);
    body
}

fn body(archive: &Archive) -> Vec<u8> {
    let mut bytes = archive.to_bytes().unwrap();
    bytes.truncate(bytes.len() - 32);
    bytes
}

#[test]
fn an_archive_reads_back_unchanged_and_has_the_same_bytes_again() {
    let archive = sample::full();
    let bytes = archive.to_bytes().unwrap();
    assert_eq!(Archive::from_bytes(&bytes).as_ref(), Ok(&archive));
    assert_eq!(Archive::from_bytes(&bytes).unwrap().to_bytes().unwrap(), bytes);
    let plain = Archive::new(sample::roof(1.0, DVec3::ZERO)).unwrap();
    assert_eq!(Archive::from_bytes(&plain.to_bytes().unwrap()), Ok(plain));
}

#[test]
fn coordinates_keep_every_bit() {
    let odd = [f64::MIN_POSITIVE / 8.0, -0.0, 0.1 + 0.2, 1e300, -1e-300, 500_123.456_789_012_3];
    let mut contents = sample::roof(1.0, DVec3::ZERO);
    contents.mesh.vertices[0] = DVec3::new(odd[0], odd[1], odd[2]);
    contents.mesh.vertices[1] = DVec3::new(odd[3], odd[4], odd[5]);
    let back = Archive::from_bytes(&Archive::new(contents).unwrap().to_bytes().unwrap()).unwrap();
    let read: Vec<u64> =
        back.contents().mesh.vertices[..2].iter().flat_map(|v| v.to_array()).map(f64::to_bits).collect();
    assert_eq!(read, odd.map(f64::to_bits));
}

/// Compares with files that this version wrote first, because stored results must stay readable for as long as the
/// version stays the same.
#[test]
fn the_bytes_of_this_version_are_frozen() {
    for (file, archive) in [("full", sample::full()), ("strip", Archive::new(sample::strip()).unwrap())] {
        let path = format!("{}/tests/archive-v1-{file}.bin", env!("CARGO_MANIFEST_DIR"));
        if std::env::var_os("PLATEAU_WRITE_ARCHIVES").is_some() {
            std::fs::write(&path, archive.to_bytes().unwrap()).unwrap();
        }
        let bytes = std::fs::read(&path).unwrap();
        assert_eq!(Archive::from_bytes(&bytes).as_ref(), Ok(&archive));
        assert!(archive.to_bytes().unwrap() == bytes, "{file}");
    }
}

#[test]
fn bridges_that_do_not_unroll_the_mesh_are_refused() {
    let with = |pairs: &[[u32; 2]]| {
        let mut contents = sample::strip();
        contents.line_sets[0].lines = Lines::Segments(pairs.to_vec());
        Archive::new(contents)
    };
    assert!(with(&[[0, 3], [1, 3], [1, 4], [2, 4]]).is_ok());
    for pairs in [
        [].as_slice(),
        &[[0, 3]],
        &[[0, 3], [1, 3], [1, 4]],
        &[[0, 3], [1, 3], [1, 3], [1, 4]],
        &[[0, 3], [1, 3], [1, 4], [2, 4], [0, 1]],
        &[[0, 3], [1, 3], [1, 4], [2, 4], [2, 3]],
    ] {
        assert!(matches!(with(pairs), Err(Defect::Contents(text)) if text.contains("bridges")), "{pairs:?}");
    }
    let mut far = sample::strip();
    far.mesh.vertices[2].x = 1e60;
    assert!(Archive::new(far).is_err());
    let mut none = sample::strip();
    none.line_sets.clear();
    assert!(Archive::new(none).is_err());
}

#[test]
fn foreign_other_version_truncated_and_changed_files_have_different_errors() {
    let bytes = sample::full().to_bytes().unwrap();
    assert_eq!(Archive::from_bytes(b""), Err(Defect::Magic));
    assert_eq!(Archive::from_bytes(b"glTF and so on"), Err(Defect::Magic));
    for version in [0, 2, 5] {
        let mut other = body(&sample::full());
        other[8] = version;
        assert_eq!(Archive::from_bytes(&signed(other)), Err(Defect::Version(version.into())));
    }
    for length in 8..bytes.len() {
        assert_eq!(Archive::from_bytes(&bytes[..length]), Err(Defect::Checksum), "cut to {length} bytes");
    }
    for at in 8..bytes.len() {
        let mut changed = bytes.clone();
        changed[at] ^= 0x10;
        assert_eq!(Archive::from_bytes(&changed), Err(Defect::Checksum), "byte {at} changed");
    }
}

#[test]
fn a_body_of_wrong_length_with_a_matching_checksum_is_refused() {
    let body = body(&sample::full());
    for length in 12..body.len() {
        assert!(Archive::from_bytes(&signed(body[..length].to_vec())).is_err(), "cut to {length} bytes");
    }
    let longer = [body.as_slice(), &[0]].concat();
    assert!(matches!(Archive::from_bytes(&signed(longer)), Err(Defect::Bytes(_))));
}

#[test]
fn a_huge_count_is_refused_before_memory_is_allocated() {
    // Generator and title are empty, and unit and axis are the first values. The next number is a count of 2^62
    // vertices.
    let mut body = b"\x89PLATEAU\x01\0\0\0\0\0\0\0".to_vec();
    body.extend_from_slice(&[0xff; 8]);
    body.push(0x3f);
    assert!(matches!(Archive::from_bytes(&signed(body)), Err(Defect::Bytes(_))));
}

#[test]
fn the_error_for_invalid_contents_names_the_defect() {
    let line = |vertices: Vec<u32>| {
        let lines = Lines::Polylines(vec![Polyline { vertices, closed: false }]);
        vec![sample::line_set("boundaries", lines, vec![])]
    };
    let stress = |count: usize| Attribute::new("stress", "kN/m", vec![1.0; count]);
    let with = move |value: f64| vec![Attribute { values: vec![value; 4], ..stress(4) }];
    let range = move |low: f64, high: f64| vec![Attribute { range: [low, high], ..stress(4) }];
    let named = move |name: &str| vec![Attribute { name: name.into(), ..stress(4) }];
    type Change = Box<dyn Fn(&mut Contents)>;
    let cases: Vec<(&str, Change)> = vec![
        ("no triangle", Box::new(|c| c.mesh.triangles.clear())),
        ("not finite", Box::new(|c| c.mesh.vertices[3].y = f64::NAN)),
        ("triangle names", Box::new(|c| c.mesh.triangles[2][1] = 5)),
        ("differ in number", Box::new(move |c| c.vertex_attributes = vec![stress(4)])),
        ("differ in number", Box::new(move |c| c.triangle_attributes = vec![stress(5)])),
        (
            "differ in number",
            Box::new(move |c| {
                c.line_sets = vec![sample::line_set("ribs", Lines::Segments(vec![[0, 1]]), vec![stress(2)])]
            }),
        ),
        ("not finite", Box::new(move |c| c.triangle_attributes = with(f64::INFINITY))),
        ("not finite", Box::new(move |c| c.triangle_attributes = range(0.0, f64::NAN))),
        ("below its start", Box::new(move |c| c.triangle_attributes = range(1.0, 0.0))),
        ("not lower case", Box::new(move |c| c.triangle_attributes = named("Stress"))),
        ("not lower case", Box::new(move |c| c.triangle_attributes = named(""))),
        ("same name", Box::new(move |c| c.triangle_attributes = vec![stress(4), stress(4)])),
        ("line names", Box::new(move |c| c.line_sets = line(vec![0, 5]))),
        ("fewer than two", Box::new(move |c| c.line_sets = line(vec![0]))),
        ("input point", Box::new(|c| c.input_vertices = vec![vec![9]])),
        ("not JSON", Box::new(|c| c.statistics = "{".into())),
        ("not JSON", Box::new(|c| c.statistics = String::new())),
    ];
    for (expected, change) in cases {
        let mut contents = sample::roof(1.0, DVec3::ZERO);
        change(&mut contents);
        let defect = Archive::new(contents).unwrap_err();
        assert!(matches!(defect, Defect::Contents(text) if text.contains(expected)), "{expected}: {defect}");
    }
}

proptest! {
    /// Any bytes after a valid start and before a valid checksum are refused, or give an archive that reads back
    /// unchanged.
    #[test]
    fn any_payload_gives_an_archive_or_an_error(payload in prop::collection::vec(any::<u8>(), 0..400)) {
        let body = [b"\x89PLATEAU\x01\0\0\0".as_slice(), &payload].concat();
        if let Ok(archive) = Archive::from_bytes(&signed(body)) {
            prop_assert_eq!(Archive::from_bytes(&archive.to_bytes().unwrap()), Ok(archive));
        }
    }

    /// A valid archive with a few bytes overwritten reaches more of the reader than random bytes do.
    #[test]
    fn any_change_gives_an_archive_or_an_error(
        which in 0..2,
        changes in prop::collection::vec((any::<prop::sample::Index>(), any::<u8>()), 1..6),
    ) {
        let mut body = match which {
            0 => Archive::new(sample::strip()).unwrap().to_bytes().unwrap(),
            _ => sample::full().to_bytes().unwrap(),
        };
        body.truncate(body.len() - 32);
        for (at, value) in changes {
            let at = 12 + at.index(body.len() - 12);
            body[at] = value;
        }
        if let Ok(archive) = Archive::from_bytes(&signed(body)) {
            prop_assert_eq!(Archive::from_bytes(&archive.to_bytes().unwrap()), Ok(archive));
        }
    }
}
