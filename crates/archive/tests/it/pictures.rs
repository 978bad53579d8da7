//! Pictures of results as PNG files, decoded again.

use crate::sample;
use plateau_archive::formats::picture;
use plateau_archive::units::UpAxis;
use plateau_archive::{Archive, Contents, Lines};
use plateau_mesh::{DVec3, Mesh};

fn archive(contents: Contents) -> Archive {
    Archive::new(contents).unwrap()
}

/// Returns the pixels of a picture, three bytes each.
fn pixels(archive: &Archive) -> Vec<[u8; 3]> {
    let file = picture::to_png(archive).unwrap();
    let mut reader = png::Decoder::new(std::io::Cursor::new(file)).read_info().unwrap();
    let mut bytes = vec![0; reader.output_buffer_size().unwrap()];
    let info = reader.next_frame(&mut bytes).unwrap();
    assert_eq!((info.width as usize, info.height as usize), (picture::WIDTH, picture::HEIGHT));
    assert_eq!(info.color_type, png::ColorType::Rgb);
    bytes.chunks_exact(3).map(|pixel| [pixel[0], pixel[1], pixel[2]]).collect()
}

const WHITE: [u8; 3] = [255; 3];

/// Returns the share of the pixels that are not white.
fn drawn(archive: &Archive) -> f64 {
    let pixels = pixels(archive);
    pixels.iter().filter(|&&pixel| pixel != WHITE).count() as f64 / pixels.len() as f64
}

#[test]
fn a_picture_shows_the_surface_and_its_lines_and_is_always_the_same() {
    let archive = sample::full();
    assert!(picture::to_png(&archive).unwrap() == picture::to_png(&archive).unwrap());
    let share = drawn(&archive);
    assert!((0.2..0.9).contains(&share), "{share}");
    let pixels = pixels(&archive);
    // The frame is empty, the surface is blue, and the boundary is nearly black.
    assert!(pixels[..picture::WIDTH].iter().all(|&pixel| pixel == WHITE));
    assert!(pixels.iter().any(|&[red, _, blue]| blue > 150 && blue - 20 > red), "no surface");
    assert!(pixels.iter().any(|pixel| pixel.iter().all(|&channel| channel < 60)), "no boundary");
}

#[test]
fn a_picture_does_not_depend_on_the_place_and_the_size_of_the_mesh() {
    let near = pixels(&archive(sample::roof(1.0, DVec3::ZERO)));
    for (scale, offset) in [(1024.0, DVec3::ZERO), (1.0, DVec3::splat(2f64.powi(20))), (2f64.powi(-900), DVec3::ZERO)] {
        let other = pixels(&archive(sample::roof(scale, offset)));
        // Far from the origin the coordinates are rounded, which may move an edge across the centre of a sample.
        let different = other.iter().zip(&near).filter(|(one, other)| one != other).count();
        assert!(different < 20, "{scale} {offset}: {different} pixels differ");
    }
    let mut turned = sample::roof(1.0, DVec3::ZERO);
    turned.up = UpAxis::Y;
    turned.mesh.vertices.iter_mut().for_each(|v| *v = DVec3::new(v.x, v.z, -v.y));
    assert!(pixels(&archive(turned)) == near);
}

#[test]
fn a_picture_of_a_degenerate_mesh_is_a_picture() {
    let of = |corners: [[f64; 3]; 3]| {
        let boundary = sample::line_set("boundaries", Lines::Segments(vec![[0, 1], [1, 2], [2, 2]]), vec![]);
        archive(Contents {
            mesh: Mesh::new(corners.map(DVec3::from_array).to_vec(), vec![[0, 1, 2], [0, 0, 0]]),
            line_sets: vec![boundary],
            statistics: "{}".into(),
            ..Contents::default()
        })
    };
    let (large, small) = (f64::MAX, f64::from_bits(1));
    assert_eq!(drawn(&of([[1.0; 3]; 3])), 0.0, "a point");
    assert_eq!(drawn(&of([[large; 3]; 3])), 0.0, "a point far away");
    assert!(drawn(&of([[0.0; 3], [1.0; 3], [2.0; 3]])) > 0.0, "a segment");
    assert!(drawn(&of([[0.0; 3], [0.0, 0.0, 1.0], [0.0, 0.0, 2.0]])) > 0.0, "an upright segment");
    assert!(drawn(&of([[-large, 0.0, 0.0], [large, 0.0, 0.0], [0.0, large, -large]])) > 0.01, "the largest triangle");
    drawn(&of([[0.0; 3], [small, 0.0, 0.0], [0.0, small, 0.0]]));
    // A segment along the viewer's direction is a single point.
    let along = [0.5 * 0.75f64.sqrt(), -0.75, 0.5];
    assert!(drawn(&of([[0.0; 3], along, along.map(|x| 2.0 * x)])) > 0.0, "a segment towards the viewer");
}

#[test]
fn the_work_of_a_picture_is_bounded() {
    let mut contents = sample::roof(1.0, DVec3::ZERO);
    contents.mesh.triangles = contents.mesh.triangles.repeat(50_000);
    let started = std::time::Instant::now();
    assert!(drawn(&archive(contents)) > 0.2);
    // Without the bound, these triangles take minutes.
    assert!(started.elapsed().as_secs() < 30, "{:?}", started.elapsed());
}
