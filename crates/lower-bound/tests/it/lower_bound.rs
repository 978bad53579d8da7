//! Tests of lower bounds of the area: they are never above a film's area, they are sharp on plane polygons, and a
//! separate program confirms them in exact arithmetic.

use crate::boundaries;
use plateau_lower_bound as lower_bound;
use plateau_lower_bound::{LowerBound, Mirror};
use plateau_mesh::{DVec3, Error, Execution, Interruption, Mesh, Signal};
use plateau_minimal_surface as minimal_surface;
use plateau_minimal_surface::{
    FreeTopology, Method, Newton, Options, PinkallPolthier, Resolution, TopologyRule, VertexRelaxation,
};
use std::f64::consts::TAU;
use std::fmt::Write as _;
use std::path::Path;
use std::process::Command;

fn film(loops: &[Vec<DVec3>], method: Method) -> Option<(Mesh, f64)> {
    let options = Options { method, ..Options::new(Resolution::Triangles(2000)) };
    let film = minimal_surface::solve(loops, &options, &Execution::default()).ok()?;
    Some((film.mesh, film.statistics.area))
}

fn options(gap: f64, seconds: f64) -> lower_bound::Options {
    lower_bound::Options::default().with_gap(gap).with_seconds(seconds)
}

fn bound(loops: &[Vec<DVec3>], film: &Mesh, seconds: f64) -> LowerBound {
    lower_bound::certify(loops, film, &options(1e-4, seconds), &Execution::default()).unwrap().unwrap()
}

#[test]
fn plane_polygons_have_their_own_area_as_bound() {
    // The last polygon is regular, so that the film lies in one plane of symmetry and crosses two others.
    for (k, (corners, wave)) in [(4, 0.4), (5, 0.4), (9, 0.4), (6, 0.0)].into_iter().enumerate() {
        // A star-shaped polygon in a tilted plane.
        let (u, v) = (DVec3::new(0.8, 0.1, 0.3).normalize(), DVec3::new(-0.2, 0.9, 0.1));
        let v = (v - u * u.dot(v)).normalize();
        let points: Vec<DVec3> = (0..corners)
            .map(|i| {
                let angle = TAU * i as f64 / corners as f64;
                let radius = 1.0 + wave * (3.0 * angle + k as f64).sin();
                (u * angle.cos() + v * angle.sin()) * radius + DVec3::new(5.0, -3.0, 2.0)
            })
            .collect();
        let exact: f64 = (0..corners).map(|i| 0.5 * points[i].cross(points[(i + 1) % corners]).dot(u.cross(v))).sum();
        let loops = [points];
        let (mesh, area) = film(&loops, Method::default()).unwrap();
        let found = bound(&loops, &mesh, 1.0);
        assert!(found.area <= exact && found.area <= area * (1.0 + 1e-12));
        assert!(found.area >= 0.999 * exact, "{corners} corners: {} of {exact}", found.area);
        assert!(found.slack.iter().all(|&slack| slack < 0.01));
        // The polygons are a kite, two stars whose only plane of symmetry is their own plane, and a regular polygon.
        assert_eq!(found.fields[0].mirrors.len(), [2, 1, 1, 3][k]);
    }
}

/// Closed curves of a few random waves. Every third boundary has two curves. Every second boundary has one or two
/// planes of symmetry, perpendicular to the axes or in another direction.
fn random_boundary(seed: u64) -> Vec<Vec<DVec3>> {
    let mut state = seed.wrapping_mul(0x9e37_79b9_7f4a_7c15) | 1;
    let mut noise = move || {
        state ^= state << 13;
        state ^= state >> 7;
        state ^= state << 17;
        (state >> 11) as f64 / (1u64 << 53) as f64 - 0.5
    };
    let loops = if seed.is_multiple_of(3) { 2 } else { 1 };
    (0..loops)
        .map(|k| {
            let waves: Vec<[f64; 6]> = (0..3).map(|_| std::array::from_fn(|_| 0.35 * noise())).collect();
            let mut offset = DVec3::new(0.2 * noise(), 0.2 * noise(), 0.9 * f64::from(k));
            let planes = if seed.is_multiple_of(2) { 1 + seed / 2 % 2 } else { 0 };
            if planes > 0 {
                offset.y = 0.0;
            }
            if planes > 1 {
                offset.x = 0.0;
            }
            (0..36)
                .map(|i| {
                    let t = TAU * f64::from(i) / 36.0;
                    let mut point = DVec3::new(t.cos(), t.sin(), 0.0) + offset;
                    for (n, w) in waves.iter().enumerate() {
                        let (sin, cos) = (t * (n + 1) as f64).sin_cos();
                        let odd = n % 2 == 0;
                        let [even, sine] = match planes {
                            0 => [DVec3::new(w[0], w[1], w[2]), DVec3::new(w[3], w[4], w[5])],
                            1 => [DVec3::new(w[0], 0.0, w[2]), DVec3::new(0.0, w[4], 0.0)],
                            // Odd multiples of t change x and y, and even multiples change z.
                            _ if odd => [DVec3::new(w[0], 0.0, 0.0), DVec3::new(0.0, w[4], 0.0)],
                            _ => [DVec3::new(0.0, 0.0, w[2]), DVec3::ZERO],
                        };
                        point += even * cos + sine * sin;
                    }
                    // Some boundaries are rounded like coordinates in files.
                    if seed.is_multiple_of(4) { (turned(point) * 1e4).round() * 1e-4 } else { point }
                })
                .collect()
        })
        .collect()
}

/// A point after a rotation and a displacement.
fn turned(p: DVec3) -> DVec3 {
    let x = DVec3::new(0.6, -0.3, 0.5).normalize();
    let y = x.cross(DVec3::new(0.1, 0.9, 0.2)).normalize();
    x * p.x + y * p.y + x.cross(y) * p.z + DVec3::new(30.0, -50.0, 12.0)
}

#[test]
fn no_film_has_less_area_than_the_bound() {
    let count = if std::env::var_os("PLATEAU_LONG").is_some() { 200 } else { 4 };
    let mut gaps = Vec::new();
    for seed in 1..=count {
        let loops = random_boundary(seed);
        let by_topology = |topology| Method::Newton(Newton { topology, ..Newton::default() });
        let solved: Vec<(Mesh, f64)> = [
            Method::default(),
            Method::VertexRelaxation(VertexRelaxation::default()),
            Method::PinkallPolthier(PinkallPolthier::default()),
            by_topology(TopologyRule::Free(FreeTopology::default())),
            by_topology(TopologyRule::Best),
        ]
        .into_iter()
        .filter_map(|method| film(&loops, method))
        .collect();
        let Some((mesh, least)) = solved.into_iter().min_by(|a, b| a.1.total_cmp(&b.1)) else {
            continue;
        };
        let found = bound(&loops, &mesh, 0.3);
        assert!(found.area > 0.0 && found.area <= least, "boundary {seed}: {} above {least}", found.area);
        assert_eq!(found.fields.len(), 1 << (loops.len() - 1));
        let planes = if seed.is_multiple_of(2) { 1 + (seed / 2 % 2) as usize } else { 0 };
        let field = &found.fields[0];
        assert_eq!((field.mirrors.len(), field.axes.is_some()), (planes, seed.is_multiple_of(4)), "boundary {seed}");
        gaps.push((1.0 - found.area / least, seed));
    }
    assert!(gaps.len() * 10 >= count as usize * 9, "films of only {} boundaries", gaps.len());
    gaps.sort_by(|a, b| a.0.total_cmp(&b.0));
    let [least, median, largest] = [0, gaps.len() / 2, gaps.len() - 1].map(|k| 100.0 * gaps[k].0);
    let worst: Vec<u64> = gaps.iter().rev().take(5).map(|gap| gap.1).collect();
    println!(
        "films of {} boundaries of {count}: gaps {least:.3}%, median {median:.3}%, {largest:.3}%; largest at {worst:?}",
        gaps.len()
    );
    // A bound that is true but far below the area would be useless.
    assert!(median < 10.0, "median gap {median}%");
}

#[test]
fn two_rings_are_bounded_over_both_orientations() {
    let loops = boundaries::rings(24, 0.7);
    let (mesh, area) = film(&loops, Method::default()).unwrap();
    let found = bound(&loops, &mesh, 1.0);
    assert!(found.fields.len() == 2);
    let least = found.fields.iter().map(|field| field.area_lower_bound).fold(f64::INFINITY, f64::min);
    assert_eq!(found.area, least);
    assert!(found.area <= area && found.area > 0.9 * area, "{} of {area}", found.area);
}

/// Four pairs of near rings, which are far from each other, and a disc over each ring. All discs have the same
/// orientation.
fn pairs_of_rings() -> (Vec<Vec<DVec3>>, Mesh) {
    let ring = |k: usize| -> Vec<DVec3> {
        let at = DVec3::new(3.0 * (k / 2) as f64, 0.0, 0.2 * (k % 2) as f64);
        (0..12).map(|i| (TAU * f64::from(i) / 12.0).sin_cos()).map(|(s, c)| at + DVec3::new(c, s, 0.0)).collect()
    };
    let loops: Vec<Vec<DVec3>> = (0..8).map(ring).collect();
    let mut vertices = loops.concat();
    vertices.extend((0..8).map(|k| DVec3::new(3.0 * (k / 2) as f64, 0.0, 0.2 * (k % 2) as f64)));
    let fan = |k: u32| (0..12).map(move |i| [12 * k + i, 12 * k + (i + 1) % 12, 96 + k]);
    (loops, Mesh::new(vertices, (0..8).flat_map(fan).collect()))
}

/// The eight discs have a total area of 24. For other directions of the loops, four annuli with a total area of 4.94
/// span them.
#[test]
fn beyond_six_loops_the_bound_covers_every_orientation() {
    let (loops, film) = pairs_of_rings();
    let given = [(0.0, 0.0), (0.2, 1.0), (3.0, 3.5)];
    let number = if std::env::var_os("PLATEAU_FULL").is_some() { 3 } else { 2 };
    for (seconds, least) in given.into_iter().take(number) {
        let found = bound(&loops, &film, seconds);
        println!("{seconds} s: {} by {} fields, {:.2} s", found.area, found.fields.len(), found.seconds);
        assert!(found.area >= least && found.area <= 4.937, "{} in {seconds} s", found.area);
        assert!(found.seconds <= seconds + 0.05, "{} of {seconds}", found.seconds);
        // Checking the document of many fields in rational arithmetic takes minutes.
        if found.fields.len() > 8 {
            continue;
        }
        let (confirmed, message) = check(&json(&found, 1.0, 1.0), &format!("eight-{seconds}"));
        assert!(confirmed, "{message}");
        // Without its last field the document does not cover all orientations.
        let mut partial = found.clone();
        partial.fields.pop();
        let (confirmed, message) = check(&json(&partial, 1.0, 1.0), &format!("partial-{seconds}"));
        assert!(!confirmed && (partial.fields.is_empty() || message.contains("is missing")), "{message}");
    }
    // If a loop with a circulation is declared free, the field proves less than the document claims.
    let mut found = bound(&loops, &film, 0.2);
    let field = found.fields.iter_mut().find(|field| !field.free_loops.is_empty()).expect("a field with free loops");
    field.free_loops.push(0);
    let (confirmed, message) = check(&json(&found, 1.0, 1.0), "free");
    assert!(!confirmed, "{message}");
}

/// The bound of two squares says nothing about a film over one of them.
#[test]
fn a_film_whose_border_does_not_run_along_the_loops_has_no_bound() {
    let square = |z: f64| [(0.0, 0.0), (1.0, 0.0), (1.0, 1.0), (0.0, 1.0)].map(|(x, y)| DVec3::new(x, y, z)).to_vec();
    let loops = [square(0.0), square(9.0)];
    let mut film = Mesh::new(loops.concat(), vec![[0, 1, 2], [0, 2, 3]]);
    let certify = |film: &Mesh| lower_bound::certify(&loops, film, &options(0.0, 0.1), &Execution::default()).unwrap();
    assert_eq!(certify(&film), None);
    film.triangles.extend([[4, 6, 5], [4, 7, 6]]);
    assert_eq!(certify(&film).map(|bound| bound.fields.len()), Some(2));
    // The border cuts off a corner of a loop.
    film.triangles.pop();
    assert_eq!(certify(&film), None);
}

/// A small boundary far from the origin: its mirror images are rounded by more than the usual margin of the
/// half-spaces, which is a fraction of the boundary's size.
#[test]
fn half_spaces_of_small_boundaries_far_from_the_origin_hold() {
    for (size, shift) in [(2e-3, 1e7), (1.0, 1e9), (1e-6, 1e3)] {
        let shift = DVec3::new(shift, -0.7 * shift, 0.3 * shift);
        let place = |p: DVec3| p * size + shift;
        let loops: Vec<Vec<DVec3>> =
            boundaries::rings(8, 0.5).into_iter().map(|points| points.into_iter().map(place).collect()).collect();
        let (mesh, _) = film(&loops, Method::default()).unwrap();
        let found = lower_bound::certify(&loops, &mesh, &options(1e-4, 0.1), &Execution::default()).unwrap().unwrap();
        let (confirmed, message) = check(&json(&found, 1.0, 1.0), &format!("small-{size}"));
        assert!(confirmed, "{size}: {message}");
    }
}

#[test]
fn the_same_request_gives_the_same_bytes_and_an_offset_keeps_the_bound_true() {
    let loops = vec![boundaries::skew_quadrilateral(1)];
    let (mesh, area) = film(&loops, Method::default()).unwrap();
    let first = bound(&loops, &mesh, 0.4);
    assert_eq!(first, bound(&loops, &mesh, 0.4));
    assert!(first.area <= area && first.area > 0.95 * area);
    let shift = DVec3::new(1e7, -2e7, 3e6);
    let moved: Vec<Vec<DVec3>> = loops.iter().map(|points| points.iter().map(|&p| p + shift).collect()).collect();
    let mesh = Mesh::new(mesh.vertices.iter().map(|&p| p + shift).collect(), mesh.triangles);
    let found = bound(&moved, &mesh, 0.4);
    assert!(found.area <= area * (1.0 + 1e-8) && found.area > 0.95 * area);
}

#[test]
fn a_cancel_stops_the_search_and_a_deadline_keeps_what_is_proven() {
    let loops = vec![boundaries::skew_quadrilateral(1)];
    let (mesh, area) = film(&loops, Method::default()).unwrap();
    let looks = std::cell::Cell::new(0);
    let stop = |after: u32, how: Signal| {
        looks.set(0);
        let signal = || {
            looks.set(looks.get() + 1);
            if looks.get() > after { how } else { Signal::Continue }
        };
        let exec = Execution::new(&signal, &|_| {});
        lower_bound::certify(&loops, &mesh, &options(0.0, 5.0), &exec)
    };
    assert_eq!(stop(20, Signal::Cancel).err(), Some(Error::Interrupted(Interruption::Cancelled)));
    let found = stop(60, Signal::Deadline).unwrap().unwrap();
    assert!(found.iterations < 60 && found.area > 0.5 * area && found.area <= area);
}

#[test]
fn the_budget_limits_the_work_and_progress_never_falls() {
    let loops = vec![boundaries::skew_quadrilateral(1)];
    let (mesh, _) = film(&loops, Method::default()).unwrap();
    let mut bounds = Vec::new();
    for seconds in [0.0, 0.1, 0.5] {
        let fractions = std::cell::RefCell::new(Vec::new());
        let report = |progress: plateau_mesh::Progress| fractions.borrow_mut().push(progress.fraction);
        let exec = Execution::new(&|| Signal::Continue, &report);
        let budget = options(0.0, seconds);
        let found = lower_bound::certify(&loops, &mesh, &budget, &exec).unwrap().unwrap();
        // The first mesh is prepared even if that exceeds the budget a little.
        assert!(found.seconds <= seconds + 0.05, "{} of {seconds}", found.seconds);
        let fractions = fractions.borrow();
        assert!(fractions.is_sorted() && fractions.iter().all(|fraction| (0.0..=1.0).contains(fraction)));
        assert_eq!(fractions.len(), found.iterations as usize);
        // At most a few milliseconds of work may lie between two calls of `look`.
        assert!(exec.largest_work_between_looks() < 500_000, "{}", exec.largest_work_between_looks());
        bounds.push(found.area);
    }
    assert!(bounds[0] > 0.0 && bounds.is_sorted(), "{bounds:?}");
    let memory = |loops, seconds| lower_bound::memory_bytes(loops, &options(0.0, seconds));
    assert!(memory(1, 0.1) < memory(1, 10.0) && memory(1, 1.0) < memory(5, 1.0));
    assert!(memory(6, 1e9) < 2_000_000_000);
}

/// The certificate as the service writes it.
fn json(found: &LowerBound, edge_scale: f64, bound_scale: f64) -> String {
    let points = |points: &[DVec3]| format!("{:?}", points.iter().map(|p| p.to_array()).collect::<Vec<_>>());
    let mut out = format!("{{\"area_lower_bound\":{:?},\"orientations\":[", found.area * bound_scale);
    for (k, field) in found.fields.iter().enumerate() {
        let loops: Vec<String> = field.loops.iter().map(|of| points(of)).collect();
        let edge_values: Vec<f64> = field.edge_values.iter().map(|value| value * edge_scale).collect();
        let face_values: Vec<[f64; 2]> =
            field.face_values.iter().map(|of| of.map(|value| value * edge_scale)).collect();
        let mirror = |of: &Mirror| {
            format!("{{\"axis\":\"{}\",\"at\":{:?},\"sign\":{}}}", ["x", "y", "z"][of.axis], of.at, of.sign)
        };
        let frame = field.axes.map_or("null".into(), |axes| {
            format!("{{\"origin\":{:?},\"axes\":{}}}", axes.origin.to_array(), points(&axes.directions))
        });
        let mirrors: Vec<String> = field.mirrors.iter().map(mirror).collect();
        write!(
            out,
            "{}{{\"loops\":[{}],\"free_loops\":{:?},\"area_lower_bound\":{:?},\
             \"frame\":{frame},\"box\":{},\"mirrors\":[{}],\
             \"vertices\":{},\"tetrahedra\":{:?},\"edges\":{:?},\
             \"edge_values\":{edge_values:?},\"faces\":{:?},\"face_values\":{face_values:?},\"half_spaces\":{},\
             \"unconstrained\":{:?}}}",
            if k == 0 { "" } else { "," },
            loops.join(","),
            field.free_loops,
            field.area_lower_bound * bound_scale,
            points(&field.corners),
            mirrors.join(","),
            points(&field.vertices),
            field.tetrahedra,
            field.edges,
            field.faces,
            points(&field.half_spaces),
            field.unconstrained,
        )
        .unwrap();
    }
    out + "]}"
}

fn check(certificate: &str, name: &str) -> (bool, String) {
    let path = std::env::temp_dir().join(format!("plateau-certificate-{}-{name}.json", std::process::id()));
    std::fs::write(&path, certificate).unwrap();
    let script = Path::new(env!("CARGO_MANIFEST_DIR")).join("../../scripts/check_certificate.py");
    let output = Command::new("python3").arg(script).arg(&path).output().expect("python3 runs");
    std::fs::remove_file(&path).unwrap();
    (output.status.success(), String::from_utf8_lossy(&output.stderr).into_owned())
}

/// With the same budget, the gap must be smaller if the boundary is symmetrical, whatever the direction of its planes
/// is.
#[test]
fn planes_of_symmetry_sharpen_the_bound() {
    let saddle = |bend: f64| -> Vec<DVec3> {
        (0..48)
            .map(|k| (TAU * f64::from(k) / 48.0).sin_cos())
            .map(|(sine, cosine)| DVec3::new(cosine + bend * sine, sine, 0.8 * (cosine * cosine - sine * sine)))
            .collect()
    };
    let gap = |points: Vec<DVec3>, mirrors: &[i8], turned: bool| {
        let loops = [points];
        let (mesh, area) = film(&loops, Method::default()).unwrap();
        let found = bound(&loops, &mesh, 0.3);
        let mut signs: Vec<i8> = found.fields[0].mirrors.iter().map(|mirror| mirror.sign).collect();
        signs.sort_unstable();
        assert_eq!((&signs[..], found.fields[0].axes.is_some()), (mirrors, turned));
        let (confirmed, message) = check(&json(&found, 1.0, 1.0), &format!("saddle-{}-{turned}", mirrors.len()));
        assert!(confirmed, "{message}");
        // The slack is small on both sides of the planes, so that the mean over the vertices is small.
        let slack = found.slack.iter().sum::<f64>() / found.slack.len() as f64;
        assert!(slack < 0.05, "{slack}");
        area / found.area - 1.0
    };
    let without = gap(saddle(0.01), &[], false);
    let across_the_axes = gap(saddle(0.0), &[-1, -1], false);
    let in_any_direction = gap(saddle(0.0).into_iter().map(turned).collect(), &[-1, -1], true);
    assert!(
        across_the_axes < 0.6 * without && in_any_direction < 0.6 * without,
        "{across_the_axes}, {in_any_direction}, {without}"
    );
}

/// Far from the origin, coordinates are coarse, and the position of a plane of symmetry is too.
#[test]
fn symmetrical_boundaries_far_from_the_origin_are_proven() {
    let shift = DVec3::new(1e9, -2e9, 3e8);
    let loops: Vec<Vec<DVec3>> =
        boundaries::rings(8, 0.5).into_iter().map(|points| points.into_iter().map(|p| p + shift).collect()).collect();
    let (mesh, area) = film(&loops, Method::default()).unwrap();
    let found = bound(&loops, &mesh, 0.1);
    assert_eq!(found.fields.iter().map(|field| field.mirrors.len()).collect::<Vec<_>>(), [3, 3]);
    assert!(found.area < area * (1.0 + 1e-6) && found.area > 0.95 * area, "{} of {area}", found.area);
    let (confirmed, message) = check(&json(&found, 1.0, 1.0), "far");
    assert!(confirmed, "{message}");
}

#[test]
fn an_independent_program_confirms_the_certificate_and_refuses_a_false_one() {
    let loops = boundaries::rings(6, 0.5);
    let (mesh, _) = film(&loops, Method::default()).unwrap();
    let found = bound(&loops, &mesh, 0.2);
    let (confirmed, message) = check(&json(&found, 1.0, 1.0), "true");
    assert!(confirmed, "{message}");
    // A field that is too large, so that |curl A| exceeds 1.
    let (confirmed, message) = check(&json(&found, 1.0 + 1e-12, 1.0), "curl");
    assert!(!confirmed && message.contains("|curl A|"), "{message}");
    // A bound that was rounded up.
    let (confirmed, message) = check(&json(&found, 1.0, 1.0 + 1e-12), "bound");
    assert!(!confirmed && message.contains("circulation"), "{message}");
    // A tetrahedron that meets the hull of the boundary is declared to lie outside a half-space.
    let mut unbound = found.clone();
    let field = &mut unbound.fields[0];
    let beyond: Vec<u32> = field.unconstrained.iter().map(|pair| pair[0]).collect();
    assert!(beyond.len() > 10 && beyond.len() < field.tetrahedra.len() / 2, "{} unconstrained", beyond.len());
    let within = (0..field.tetrahedra.len() as u32).find(|tetrahedron| !beyond.contains(tetrahedron)).unwrap();
    field.unconstrained.push([within, 0]);
    let (confirmed, message) = check(&json(&unbound, 1.0, 1.0), "half-space");
    assert!(!confirmed && message.contains("does not lie beyond"), "{message}");
    // The field of two rings is reflected at three planes. Three false documents follow: a reflection is declared to
    // keep the sign, a plane is displaced, and the field has a tangential component in a plane.
    assert_eq!(found.fields[0].mirrors.iter().map(|mirror| mirror.sign).collect::<Vec<_>>(), [-1, -1, -1]);
    let mut turned = found.clone();
    turned.fields[0].mirrors[1].sign = 1;
    let (confirmed, message) = check(&json(&turned, 1.0, 1.0), "sign");
    assert!(!confirmed && message.contains("circulation"), "{message}");
    let mut displaced = found.clone();
    displaced.fields[0].mirrors[2].at += 1e-9;
    let (confirmed, message) = check(&json(&displaced, 1.0, 1.0), "plane");
    assert!(!confirmed && message.contains("plane of symmetry"), "{message}");
    let mut tangential = found.clone();
    let field = &mut tangential.fields[0];
    let in_the_plane = |[a, b]: &[u32; 2]| [a, b].iter().all(|&&v| field.vertices[v as usize].x == field.corners[0].x);
    let edge = field.edges.iter().position(in_the_plane).unwrap();
    field.edge_values[edge] = 1e-300;
    let (confirmed, message) = check(&json(&tangential, 1.0, 1.0), "tangential");
    assert!(!confirmed && message.contains("tangential part"), "{message}");
    // Axes that are too short, so that they shrink the boundary.
    let mut shrunk = found.clone();
    let directions = [DVec3::X * (1.0 - 1e-6), DVec3::Y, DVec3::Z];
    shrunk.fields[0].axes = Some(lower_bound::Axes { origin: DVec3::ZERO, directions });
    let (confirmed, message) = check(&json(&shrunk, 1.0, 1.0), "frame");
    assert!(!confirmed && message.contains("circulation"), "{message}");
    // A document without one of the tetrahedra.
    let mut holed = found;
    holed.fields[0].tetrahedra.pop();
    let (confirmed, message) = check(&json(&holed, 1.0, 1.0), "hole");
    assert!(!confirmed && message.contains("volume"), "{message}");
}

#[test]
fn input_that_no_search_can_use_is_refused_and_named() {
    let square = [(0.0, 0.0), (1.0, 0.0), (1.0, 1.0), (0.0, 1.0)].map(|(x, y)| DVec3::new(x, y, 0.0)).to_vec();
    let film = Mesh::new(square.clone(), vec![[0, 1, 2], [0, 2, 3]]);
    let refused = |loops: &[Vec<DVec3>], film: &Mesh, options: &lower_bound::Options| {
        lower_bound::certify(loops, film, options, &Execution::default()).unwrap_err().to_string()
    };
    let usual = options(0.01, 0.2);
    assert_eq!(refused(&[], &film, &usual), "/loops: needs one closed polygon or more");
    let two = [square.clone(), square[..2].to_vec()];
    assert_eq!(refused(&two, &film, &usual), "/loops/1: has 2 points, and a closed polygon has three or more");
    let mut infinite = square.clone();
    infinite[2].y = f64::INFINITY;
    let detail = "is (1, inf, 0), and every coordinate must be a finite number";
    assert_eq!(refused(std::slice::from_ref(&infinite), &film, &usual), format!("/loops/0/2: {detail}"));
    let loops = [square.clone()];
    let of_infinite = Mesh::new(infinite, film.triangles.clone());
    assert_eq!(refused(&loops, &of_infinite, &usual), format!("/film/vertices/2: {detail}"));
    let dangling = Mesh::new(square, vec![[0, 1, 2], [0, 2, 4]]);
    let detail = "/film/triangles/1: has the vertices [0, 2, 4], and the film has 4";
    assert_eq!(refused(&loops, &dangling, &usual), detail);
    for (name, options) in [("gap", options(-0.1, 1.0)), ("seconds", options(0.0, f64::NAN))] {
        let told = refused(&loops, &film, &options);
        let value = if name == "gap" { "-0.1" } else { "NaN" };
        let expected = format!("/options/{name}: is {value}, and must be a finite number, not negative");
        assert_eq!(told, expected);
    }
}
