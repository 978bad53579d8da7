//! Films with junctions, above all films between half-circles of wire from pole to pole of one sphere.

use super::super::options::{FreeTopology, InitialMesh, Newton, Resolution, TopologyRule};
use super::angles::{THIRD_OF_TURN, angles_around};
use super::wires::Rim;
use super::*;
use plateau_mesh::measure::Spread;

/// Returns the boundary loops and the mesh of sheets from the polar axis to half-circles at the given azimuths
/// (degrees). Each half-circle has `m` segments, and each sheet `n` rows of vertices from the axis. The axis is bent by
/// `bend`, as a fraction of the radius. There is a loop for each two neighbouring half-circles.
fn half_discs(azimuths_deg: &[f64], m: usize, n: usize, radius: f64, bend: DVec3) -> (Vec<Vec<DVec3>>, Mesh) {
    let angle = |i: usize| std::f64::consts::PI * i as f64 / m as f64;
    let pole = |sign: f64| DVec3::new(0.0, 0.0, sign * radius);
    let on_wire = |azimuth: f64, i: usize| match i {
        0 => pole(1.0),
        i if i == m => pole(-1.0),
        i => {
            radius
                * DVec3::new(
                    libm::sin(angle(i)) * libm::cos(azimuth),
                    libm::sin(angle(i)) * libm::sin(azimuth),
                    libm::cos(angle(i)),
                )
        }
    };
    let axis = |i: usize| DVec3::new(0.0, 0.0, radius * libm::cos(angle(i))) + bend * (radius * libm::sin(angle(i)));
    let mut vertices = vec![pole(1.0), pole(-1.0)];
    let first = vertices.len();
    vertices.extend((1..m).map(axis));
    let mut triangles = Vec::new();
    for azimuth in azimuths_deg.iter().map(|azimuth| azimuth.to_radians()) {
        let begin = vertices.len();
        for i in 1..m {
            for j in 1..=n {
                let point =
                    if j == n { on_wire(azimuth, i) } else { axis(i).lerp(on_wire(azimuth, i), j as f64 / n as f64) };
                vertices.push(point);
            }
        }
        let at = |i: usize, j: usize| match (i, j) {
            (0, _) => 0,
            (i, _) if i == m => 1,
            (i, 0) => (first + i - 1) as u32,
            (i, j) => (begin + (i - 1) * n + j - 1) as u32,
        };
        for j in 0..n {
            triangles.push([at(0, 0), at(1, j), at(1, j + 1)]);
            triangles.push([at(m, 0), at(m - 1, j + 1), at(m - 1, j)]);
            for i in 1..m - 1 {
                triangles.push([at(i, j), at(i + 1, j), at(i + 1, j + 1)]);
                triangles.push([at(i, j), at(i + 1, j + 1), at(i, j + 1)]);
            }
        }
    }
    let loops = azimuths_deg
        .windows(2)
        .map(|pair| {
            let down = (0..m).map(|i| on_wire(pair[0].to_radians(), i));
            let up = (1..=m).rev().map(|i| on_wire(pair[1].to_radians(), i));
            down.chain(up).collect()
        })
        .collect();
    (loops, Mesh::new(vertices, triangles))
}

fn solved(loops: &[Vec<DVec3>], mesh: &Mesh) -> MinimalSurface {
    let options = Options {
        initial_mesh: InitialMesh::Given(mesh.clone()),
        tolerance: 1e-8,
        ..Options::new(Resolution::Triangles(1))
    };
    crate::check(loops, &options).unwrap();
    crate::solve(loops, &options, &Execution::default()).unwrap()
}

fn deviation_deg(angles: &Spread) -> f64 {
    (angles.max - THIRD_OF_TURN).max(THIRD_OF_TURN - angles.min).to_degrees()
}

#[test]
fn three_half_circles_120_degrees_apart_carry_three_half_discs() {
    let radius = 2.0;
    for bend in [DVec3::new(0.3, -0.2, 0.0), DVec3::new(0.1, 0.5, 0.1)] {
        let mut shortfalls = Vec::new();
        for (m, n) in [(12, 4), (24, 8), (48, 16)] {
            let (loops, mesh) = half_discs(&[0.0, 120.0, 240.0], m, n, radius, bend);
            let surface = solved(&loops, &mesh);
            let statistics = &surface.statistics;
            let junctions = statistics.junctions.as_ref().unwrap();
            assert!(statistics.converged && statistics.initial_area > statistics.area, "{statistics:?}");
            assert_eq!((junctions.sheets, junctions.curves.len(), junctions.points), (3, 1, 0));
            assert_eq!((junctions.edges, junctions.curves[0].len()), (m, m + 1));
            // The result is three half-discs along a straight diameter, whatever the start.
            assert!((junctions.length - 2.0 * radius).abs() < 1e-9);
            let polygons = 1.5 * radius * radius * m as f64 * libm::sin(std::f64::consts::PI / m as f64);
            assert!((statistics.area - polygons).abs() < 1e-12 * polygons);
            assert!(deviation_deg(&junctions.facet_angles) < 1e-4 && deviation_deg(&junctions.sheet_angles) < 1e-4);
            assert_eq!((junctions.morse_index, statistics.components), (Some(0), 1));
            assert_eq!(statistics.euler_characteristic, 1);
            shortfalls.push(1.5 * std::f64::consts::PI * radius * radius - statistics.area);
            for (boundary, vertices) in loops.iter().zip(&surface.boundaries) {
                assert!(boundary.iter().zip(vertices).all(|(&p, &v)| surface.mesh.vertices[v as usize] == p));
            }
        }
        // The shortfall of the area is of second order in the length of the wire's segments.
        assert!(shortfalls.windows(2).all(|pair| (3.9..4.1).contains(&(pair[0] / pair[1]))), "{shortfalls:?}");
    }
}

/// Every second edge of the wires has a vertex in its middle that is not a point of the boundaries.
#[test]
fn further_vertices_on_the_wires_are_taken_as_they_are() {
    let (loops, mesh) = half_discs(&[0.0, 120.0, 240.0], 12, 4, 2.0, DVec3::new(0.3, -0.2, 0.0));
    let plain = solved(&loops, &mesh);
    let rim = Rim::of(&mesh);
    let mut halved = mesh.clone();
    let mut added = 0;
    for (k, &[a, b]) in rim.0.iter().filter(|[a, b]| a < b).enumerate().filter(|(k, _)| k % 2 == 0) {
        let middle = halved.vertices.len() as u32;
        halved.vertices.push(0.5 * (mesh.vertices[a as usize] + mesh.vertices[b as usize]));
        let t = halved.triangles.iter().position(|t| t.contains(&a) && t.contains(&b)).unwrap();
        let triangle = halved.triangles[t];
        halved.triangles[t] = triangle.map(|v| if v == a { middle } else { v });
        halved.triangles.push(triangle.map(|v| if v == b { middle } else { v }));
        added += 1;
        assert!(k < 36);
    }
    let surface = solved(&loops, &halved);
    assert_eq!((added, surface.mesh.vertices.len()), (18, mesh.vertices.len() + 18));
    assert!(surface.statistics.converged);
    assert!((surface.statistics.area - plain.statistics.area).abs() < 1e-9 * plain.statistics.area);
    for (boundary, points) in surface.boundaries.iter().zip(&loops) {
        assert!(boundary.len() > points.len());
    }
    for (numbers, points) in surface.input_vertices.iter().zip(&loops) {
        assert!(numbers.iter().zip(points).all(|(&v, &p)| surface.mesh.vertices[v as usize] == p));
    }
}

#[test]
fn half_circles_100_120_and_140_degrees_apart_still_meet_at_120() {
    let mut in_the_middle = Vec::new();
    for (m, n) in [(12, 4), (24, 8), (48, 16)] {
        for bend in [DVec3::ZERO, DVec3::new(0.2, 0.1, 0.0)] {
            let (loops, mesh) = half_discs(&[0.0, 100.0, 220.0], m, n, 2.0, bend);
            let surface = solved(&loops, &mesh);
            let junctions = surface.statistics.junctions.as_ref().unwrap();
            assert!(surface.statistics.converged && junctions.residual <= 1e-8);
            assert!(surface.statistics.area < 1.5 * std::f64::consts::PI * 4.0);
            assert!(junctions.length > 4.05 && junctions.morse_index == Some(0));
            assert!(junctions.largest_deviation.to_degrees() < 0.1, "{}", junctions.largest_deviation.to_degrees());
            assert!(junctions.mean_deviation.to_degrees() < 0.1, "{}", junctions.mean_deviation.to_degrees());
            // Near the poles the wires force other angles on the film.
            let at_ends = junctions.largest_deviation_at_ends.to_degrees();
            assert!(junctions.largest_deviation.to_degrees() < at_ends && at_ends < 0.3, "{at_ends}");
            if bend == DVec3::ZERO {
                in_the_middle.push(fitted_departure_deg(&surface, 1.0));
            }
        }
    }
    // The deviation from 120° is also measured by a method that does not use forces.
    assert!(
        in_the_middle.windows(2).all(|pair| pair[1] < 0.5 * pair[0]) && in_the_middle[2] < 0.1,
        "{in_the_middle:?}"
    );
}

/// Returns the largest deviation (degrees) from 120° at the vertices of the junction with |z| < `reach`. The tangent
/// planes are those of quadratic surfaces through the vertex. For each sheet a surface is fitted to the vertices of the
/// sheet in two rings of triangles.
fn fitted_departure_deg(surface: &MinimalSurface, reach: f64) -> f64 {
    let film = JunctionFilm::read(surface.mesh.vertices.clone(), surface.mesh.triangles.clone()).unwrap();
    let mut largest: f64 = 0.0;
    for v in 0..film.vertices.len() as u32 {
        let here = film.vertices[v as usize];
        let VertexKind::Junction(beside) = film.complex.kinds[v as usize] else { continue };
        if here.z.abs() >= reach {
            continue;
        }
        let tangent = film.tangent(beside);
        let conormals: Vec<DVec3> =
            film.complex.sheets.iter().map(|sheet| conormal(&film, sheet, v, tangent)).collect();
        let angles = angles_around(tangent, [conormals[0], conormals[1], conormals[2]]);
        largest = angles.iter().map(|angle| (angle.to_degrees() - 120.0).abs()).fold(largest, f64::max);
    }
    largest
}

fn conormal(film: &JunctionFilm, sheet: &[u32], v: u32, tangent: DVec3) -> DVec3 {
    let here = film.vertices[v as usize];
    let mut near = vec![v];
    for _ in 0..2 {
        let triangle = |t: u32| film.complex.triangles[t as usize];
        let touches = |t: &u32| triangle(*t).iter().any(|corner| near.contains(corner));
        let ring: Vec<u32> = sheet.iter().copied().filter(touches).flat_map(triangle).collect();
        near.extend(ring);
        near.sort_unstable();
        near.dedup();
    }
    let offsets: Vec<DVec3> =
        near.iter().map(|&w| film.vertices[w as usize] - here).filter(|d| *d != DVec3::ZERO).collect();
    let inward = offsets.iter().sum::<DVec3>().reject_from(tangent).normalize();
    let up = tangent.cross(inward);
    let size = offsets.iter().map(|offset| offset.length()).fold(0.0, f64::max);
    // The fitted heights are b r + c s² + d s r + e r² over the plane of tangent (s) and inward (r). There is no term
    // in s alone, because s is the direction of the junction at the vertex.
    let (mut matrix, mut right) = (glam::DMat4::ZERO, glam::DVec4::ZERO);
    for offset in offsets.iter().map(|offset| *offset / size) {
        let (s, r, height) = (offset.dot(tangent), offset.dot(inward), offset.dot(up));
        let row = glam::DVec4::new(r, s * s, s * r, r * r) / offset.length();
        matrix += glam::DMat4::from_cols(row.x * row, row.y * row, row.z * row, row.w * row);
        right += row * height / offset.length();
    }
    (inward + (matrix.inverse() * right).x * up).normalize()
}

#[test]
fn scale_and_motion_change_nothing() {
    let (loops, mesh) = half_discs(&[0.0, 100.0, 220.0], 12, 4, 1.0, DVec3::new(0.1, 0.2, 0.0));
    let reference = solved(&loops, &mesh);
    assert!(reference.statistics.converged);
    for (scale, shift) in [(1e6, DVec3::ZERO), (1e-6, DVec3::ZERO), (1.0, DVec3::new(1e7, -2e7, 3e7))] {
        let map = |p: DVec3| p.rotate_x(0.4).rotate_z(1.3) * scale + shift;
        let moved_loops: Vec<Vec<DVec3>> =
            loops.iter().map(|boundary| boundary.iter().map(|&p| map(p)).collect()).collect();
        let moved = Mesh::new(mesh.vertices.iter().map(|&p| map(p)).collect(), mesh.triangles.clone());
        let surface = solved(&moved_loops, &moved);
        let ratio = surface.statistics.area / (reference.statistics.area * scale * scale);
        // The tolerance is wide because coordinates of 3e7 are rounded by up to 4e-9.
        assert!((ratio - 1.0).abs() < 1e-6, "{ratio}");
    }
}

#[test]
fn four_junctions_meet_in_a_point_inside_a_tetrahedron() {
    // The film is the cone over the six edges of a regular tetrahedron: six sheets and four junctions from the middle
    // to the corners, 109.47° apart.
    let corners =
        [(1.0, 1.0, 1.0), (1.0, -1.0, -1.0), (-1.0, 1.0, -1.0), (-1.0, -1.0, 1.0)].map(|(x, y, z)| DVec3::new(x, y, z));
    let n = 8;
    // The start has its middle displaced from the origin.
    let middle = DVec3::new(0.3, -0.2, 0.1);
    let mut vertices = vec![middle];
    let mut find = |p: DVec3| {
        let known = vertices.iter().position(|q| q.distance(p) < 1e-9);
        known.unwrap_or_else(|| {
            vertices.push(p);
            vertices.len() - 1
        }) as u32
    };
    let mut triangles = Vec::new();
    for a in 0..4 {
        for b in a + 1..4 {
            let at = |i: usize, j: usize| {
                middle + (corners[a] - middle) * (i as f64 / n as f64) + (corners[b] - middle) * (j as f64 / n as f64)
            };
            for i in 0..n {
                for j in 0..n - i {
                    triangles.push([at(i, j), at(i + 1, j), at(i, j + 1)].map(&mut find));
                    if i + j + 2 <= n {
                        triangles.push([at(i + 1, j), at(i + 1, j + 1), at(i, j + 1)].map(&mut find));
                    }
                }
            }
        }
    }
    let mesh = Mesh::new(vertices, triangles);
    // The points of the wire have exactly the coordinates of the mesh vertices, because boundary points are compared
    // bit by bit.
    let on_wire = |a: DVec3, b: DVec3, k: usize| {
        let p = a.lerp(b, k as f64 / n as f64);
        *mesh.vertices.iter().min_by(|x, y| x.distance(p).total_cmp(&y.distance(p))).unwrap()
    };
    let [p, q, r, s] = corners;
    let polygon = |cycle: &[DVec3]| -> Vec<DVec3> {
        let sides = cycle.iter().zip(cycle.iter().cycle().skip(1));
        sides.flat_map(|(&a, &b)| (0..n).map(move |k| (a, b, k))).map(|(a, b, k)| on_wire(a, b, k)).collect()
    };
    let surface = solved(&[polygon(&[p, q, r]), polygon(&[p, q, s]), polygon(&[p, r, s])], &mesh);
    let junctions = surface.statistics.junctions.as_ref().unwrap();
    assert!(surface.statistics.converged, "{:?}", surface.warnings);
    assert_eq!((junctions.sheets, junctions.curves.len(), junctions.points), (6, 4, 1));
    // The cone consists of six triangles from the centre to the edges: 6 · ½ |p × q|.
    let cone = 3.0 * p.cross(q).length();
    assert!((surface.statistics.area - cone).abs() < 1e-9 * cone, "{} {cone}", surface.statistics.area);
    assert!(junctions.largest_deviation.to_degrees() < 1e-3);
    let inside = surface.mesh.vertices.iter().map(|v| v.length()).fold(f64::INFINITY, f64::min);
    assert!(inside < 1e-8, "{inside}");
}

#[test]
fn what_is_no_such_film_is_refused() {
    let (loops, mesh) = half_discs(&[0.0, 120.0, 240.0], 6, 2, 1.0, DVec3::ZERO);
    let told = |loops: &[Vec<DVec3>], mesh: &Mesh| {
        let options = Options::new(Resolution::Triangles(1));
        let solved = solve(loops, &[], mesh, &options, &Execution::default());
        assert_eq!(check(loops, mesh, &options).unwrap_err(), *solved.as_ref().unwrap_err());
        match solved {
            Err(Error::Input(errors)) => format!("{}: {}", errors[0].place, errors[0].detail),
            other => panic!("{other:?}"),
        }
    };
    // The request has only one of the two loops, which covers two of the three wires.
    assert!(told(&loops[..1], &mesh).contains("such edges are no segment"));
    let mut moved = loops.clone();
    moved[0][2].x += 1e-3;
    assert!(told(&moved, &mesh).contains("no vertex at a point of boundary 0"));
    let mut bad = mesh.clone();
    bad.triangles[5][0] = 10_000;
    assert!(told(&loops, &bad).contains("does not exist"));
    // The mesh has a second copy of a triangle, whose edges look like a small junction.
    let mut bad = mesh.clone();
    let [a, b, c] = bad.triangles[5];
    bad.triangles.push([b, c, a]);
    assert!(told(&loops, &bad).ends_with("has the same corners as triangle 5"));
    let mut bad = mesh.clone();
    bad.vertices.push(DVec3::ONE);
    assert!(told(&loops, &bad).contains("belongs to no triangle"));
    // The mesh has a fourth sheet at the same junction.
    let (four, mesh) = half_discs(&[0.0, 90.0, 180.0, 270.0], 6, 2, 1.0, DVec3::ZERO);
    assert!(told(&four, &mesh).contains("4 triangles share the edge"));
    let options = Options {
        method: Method::Newton(Newton { topology: TopologyRule::Free(FreeTopology::default()), ..Newton::default() }),
        ..Options::new(Resolution::Triangles(1))
    };
    let refused = solve(&loops, &[], &mesh, &options, &Execution::default());
    assert!(matches!(refused, Err(Error::Input(errors)) if errors[0].place.to_string() == "/topology"));
}
