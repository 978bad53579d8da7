//! Delaunay flips and smoothing for sheets that meet along junctions. Applies the steps of
//! [`delaunay`](super::delaunay) to each sheet.

use super::delaunay::{flip_to_delaunay, tangential_relaxation};
use crate::codes::Reason;
use crate::complex::{Complex, VertexKind};
use crate::film::Film;
use crate::measure;
use crate::{DVec3, Error, Execution};

/// Fraction of the way to the middle between its two neighbours that a junction vertex moves in one round. With 1 or
/// more the vertices oscillate.
const SPREAD: f64 = 0.5;

/// Returns a sheet as a film whose border (boundary and junctions) is fixed, and the number in the complex of each
/// vertex of the film. `None` if the sheet touches itself along a junction.
fn sheet(vertices: &[DVec3], complex: &Complex, triangles: &[u32]) -> Option<(Film, Vec<u32>)> {
    let corners = || triangles.iter().map(|&t| complex.triangles[t as usize]);
    let mut numbers: Vec<u32> = corners().flatten().collect();
    numbers.sort_unstable();
    numbers.dedup();
    let own = |v: u32| numbers.binary_search(&v).unwrap_or_default() as u32;
    let local: Vec<[u32; 3]> = corners().map(|triangle| triangle.map(own)).collect();
    let mut film = Film::new(numbers.iter().map(|&v| vertices[v as usize]).collect(), &local, Vec::new())?;
    film.fixed = numbers.iter().map(|&v| complex.kinds[v as usize] != VertexKind::Sheet).collect();
    Some((film, numbers))
}

/// Evens out the spacing of the vertices within the sheets and along the junctions, and flips edges within the sheets
/// until they are Delaunay. Returns the number of flips. A sheet that touches itself along a junction is left
/// unchanged.
///
/// # Errors
/// [`Error::Interrupted`]; the complex is then valid. [`Error::NoResult`] with the defect of the complex that the flips
/// produced. This error is not expected, because a flip keeps its sheet a manifold.
pub fn even_out(vertices: &mut [DVec3], complex: &mut Complex, rounds: u32, exec: &Execution) -> Result<u64, Error> {
    for _ in 0..rounds {
        for v in 0..vertices.len() {
            if let VertexKind::Junction([a, b]) = complex.kinds[v] {
                let (a, b) = (vertices[a as usize], vertices[b as usize]);
                let tangent = (b - a).normalize_or_zero();
                let here = vertices[v];
                vertices[v] += SPREAD * tangent * tangent.dot(0.5 * (a + b) - here);
            }
        }
    }
    let mut flips = 0;
    let mut triangles = complex.triangles.clone();
    for numbers_of_triangles in &complex.sheets {
        let Some((mut film, numbers)) = sheet(vertices, complex, numbers_of_triangles) else { continue };
        tangential_relaxation(&mut film, rounds);
        flips += flip_to_delaunay(&mut film, exec)?;
        for (&place, &triangle) in numbers_of_triangles.iter().zip(film.triangles()) {
            triangles[place as usize] = triangle.map(|v| numbers[v as usize]);
        }
        for (position, &v) in film.vertices.iter().zip(&numbers) {
            if complex.kinds[v as usize] == VertexKind::Sheet {
                vertices[v as usize] = *position;
            }
        }
    }
    if flips > 0 {
        *complex = Complex::build(triangles, vertices.len())
            .map_err(|defect| Error::no_result(Reason::InvalidMesh, defect.to_string()))?;
    }
    Ok(flips)
}

/// Number of triangles whose normal points against the normals of their vertices in their sheet.
pub fn flipped_triangles(vertices: &[DVec3], complex: &Complex) -> usize {
    let sheets = complex.sheets.iter().filter_map(|triangles| sheet(vertices, complex, triangles));
    sheets.map(|(film, _)| measure::flipped_triangles(&film.mesh())).sum()
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_fin_on_a_strip_is_evened_out_and_its_junction_stays() {
        // Three strips of 2 x 6 quadrilaterals between z = 0 and z = 3 that meet at the z axis. The heights of the rows
        // are uneven.
        let height = |i: usize| 3.0 * (i as f64 / 6.0).powi(2);
        let mut vertices: Vec<DVec3> = (0..=6).map(|i| DVec3::new(0.0, 0.0, height(i))).collect();
        let mut triangles = Vec::new();
        for sheet in 0..3 {
            let first = vertices.len();
            let angle = std::f64::consts::TAU * f64::from(sheet) / 3.0;
            for i in 0..=6 {
                vertices.extend((1..=2).map(|j| {
                    let r = 0.5 * f64::from(j);
                    DVec3::new(r * libm::cos(angle), r * libm::sin(angle), height(i))
                }));
            }
            let at = |i: usize, j: usize| if j == 0 { i as u32 } else { (first + 2 * i + j - 1) as u32 };
            for i in 0..6 {
                for j in 0..2 {
                    // The vertices on the axis will move up relative to the outer ones, so that this diagonal becomes
                    // the longer one.
                    triangles.push([at(i, j), at(i + 1, j), at(i, j + 1)]);
                    triangles.push([at(i + 1, j), at(i + 1, j + 1), at(i, j + 1)]);
                }
            }
        }
        let mut complex = Complex::build(triangles, vertices.len()).unwrap();
        let (junctions, boundary) = (complex.junctions(), vertices.clone());
        let step = |vertices: &[DVec3]| {
            let steps: Vec<f64> = (0..6).map(|i| vertices[i + 1].z - vertices[i].z).collect();
            steps.iter().copied().fold(0.0, f64::max) / steps.iter().copied().fold(f64::INFINITY, f64::min)
        };
        let before = step(&vertices);
        let flips = even_out(&mut vertices, &mut complex, 8, &Execution::default()).unwrap();
        assert!(flips > 0 && step(&vertices) < 0.3 * before, "{flips} {} {before}", step(&vertices));
        assert_eq!(complex.junctions(), junctions);
        assert_eq!(flipped_triangles(&vertices, &complex), 0);
        for (v, kind) in complex.kinds.iter().enumerate() {
            assert!(*kind != VertexKind::Boundary || vertices[v] == boundary[v]);
        }
    }
}
