//! The pictures and tables of docs/VALIDATION.md on films: Liu-Wang, Bento-Cavalcanti, spanning topologies, triple junctions.
//!
//! `cargo run --release -p plateau-geometry --example validation_films -- docs/validation` writes the SVG files there and
//! prints the tables.

use plateau_geometry::minimal_surface::{
    InitialMesh, LinearSolver, MinimalSurface, Objective, Options, Resolution, Solver, Topology, solve,
};
use plateau_geometry::{DVec3, Execution, Mesh};
use std::f64::consts::{PI, TAU};
use std::fmt::Write;

fn main() {
    let folder = std::env::args().nth(1).unwrap_or_else(|| String::from("docs/validation"));
    let save = |name: &str, pictures: &[(&str, &Mesh)]| {
        let path = format!("{folder}/{name}.svg");
        if let Err(error) = std::fs::write(&path, row(pictures)) {
            eprintln!("{path}: {error}");
            std::process::exit(1);
        }
    };
    liu_wang(&save);
    bento_cavalcanti(&save);
    spanning(&save);
    triple(&save);
}

type Save<'a> = &'a dyn Fn(&str, &[(&str, &Mesh)]);

// Liu and Wang.

fn rim(r: impl Fn(f64, f64) -> DVec3, [u0, u1]: [f64; 2], [v0, v1]: [f64; 2], [nu, nv]: [u32; 2]) -> Vec<DVec3> {
    let at = |a: f64, b: f64, k: u32, n: u32| a + (b - a) * f64::from(k) / f64::from(n);
    let bottom = (0..nu).map(|k| r(at(u0, u1, k, nu), v0));
    let right = (0..nv).map(|k| r(u1, at(v0, v1, k, nv)));
    let top = (0..nu).map(|k| r(at(u1, u0, k, nu), v1));
    let left = (0..nv).map(|k| r(u0, at(v1, v0, k, nv)));
    bottom.chain(right).chain(top).chain(left).collect()
}

/// A boundary, its interior points, and the paper's measure of a point's error.
struct Case {
    name: String,
    boundary: Vec<DVec3>,
    interior: usize,
    error: Box<dyn Fn(DVec3) -> f64>,
}

fn relative(off: f64, coordinate: f64) -> f64 {
    if coordinate.abs() > 1.0 { off / coordinate.abs() } else { off }
}

fn cases() -> Vec<Case> {
    let mut cases = Vec::new();
    let b = 1.9;
    cases.push(Case {
        name: String::from("helicoid"),
        boundary: rim(|u, v| DVec3::new(u * v.cos(), u * v.sin(), b * v), [-2.0, 2.0], [-PI / 3.0, PI / 3.0], [7, 7]),
        interior: 20,
        error: Box::new(move |p| relative((p.y - p.x * (p.z / b).tan()).abs(), p.y)),
    });
    let b = 2.05;
    let catenoid = move |u: f64, v: f64| DVec3::new(b * u.cos() * v.cosh(), b * v, b * u.sin() * v.cosh());
    cases.push(Case {
        name: String::from("catenoid"),
        boundary: rim(catenoid, [PI / 6.0, 5.0 * PI / 6.0], [-0.7, 0.7], [6, 6]),
        interior: 25,
        error: Box::new(move |p| {
            let radius = b * (p.y / b).cosh();
            relative((p.z - (radius * radius - p.x * p.x).sqrt()).abs(), p.z)
        }),
    });
    for b in [0.4, 1.0, 4.9] {
        for (sides, interior) in [(5, 16), (6, 20), (8, 30)] {
            let height = move |x: f64, y: f64| ((b * y).cos() / (b * x).cos()).ln() / b;
            let reach = 0.3 * PI / b;
            cases.push(Case {
                name: format!("Scherk b = {b}, {} + {interior}", 4 * sides),
                boundary: rim(|x, y| DVec3::new(x, y, height(x, y)), [-reach, reach], [-reach, reach], [sides, sides]),
                interior,
                error: Box::new(move |p| relative((p.z - height(p.x, p.y)).abs(), p.z)),
            });
        }
    }
    cases
}

fn run(boundaries: &[Vec<DVec3>], options: &Options) -> MinimalSurface {
    match solve(boundaries, options, &Execution::default()) {
        Ok(surface) => surface,
        Err(error) => {
            eprintln!("{error}");
            std::process::exit(1);
        }
    }
}

fn liu_wang(save: Save) {
    println!(
        "| surface | theirs | interior vertices only | Chen-Cai-Zheng | newton |\n| --- | --- | --- | --- | --- |"
    );
    for case in cases() {
        let mean = |surface: &MinimalSurface| {
            let interior = &surface.mesh.vertices[case.boundary.len()..];
            interior.iter().map(|&p| (case.error)(p)).sum::<f64>() / interior.len() as f64
        };
        let options = |seed: u64| Options {
            seed,
            initial_mesh: InitialMesh::Barycentres,
            ..Options::new(Resolution::InteriorVertices(case.interior))
        };
        let least_squares = |seed: u64, boundary_curvature: bool| Options {
            objective: Objective::MinimalMeanCurvature,
            boundary_curvature,
            ..options(seed)
        };
        // The initial points influence the solution: the middle one of nine choices.
        let middle = |options: &dyn Fn(u64) -> Options| {
            let mut means: Vec<f64> =
                (1..=9).map(|seed| mean(&run(std::slice::from_ref(&case.boundary), &options(seed)))).collect();
            means.sort_by(f64::total_cmp);
            means[4]
        };
        println!(
            "| {} | {:.2e} | {:.2e} | {:.2e} | {:.2e} |",
            case.name,
            middle(&|seed| least_squares(seed, true)),
            middle(&|seed| least_squares(seed, false)),
            middle(&|seed| Options { solver: Solver::VertexRelaxation, ..options(seed) }),
            middle(&|seed| Options { solver: Solver::Newton, ..options(seed) }),
        );
        if ["helicoid", "catenoid"].contains(&case.name.as_str()) {
            let start = Options { max_iterations: Some(1), area_tolerance: 1.0, ..least_squares(5, false) };
            let start = run(std::slice::from_ref(&case.boundary), &start).mesh;
            let theirs = run(std::slice::from_ref(&case.boundary), &least_squares(5, true)).mesh;
            let interior = run(std::slice::from_ref(&case.boundary), &least_squares(5, false)).mesh;
            save(
                &format!("liu_wang_{}", case.name),
                &[("one step", &start), ("all vertices count", &theirs), ("interior ones only", &interior)],
            );
        }
    }
    let membrane: Vec<DVec3> = (0..9)
        .map(|k| {
            let t = f64::from(k) * TAU / 9.0;
            let (reach, height) = if k % 3 == 0 { (5.0, 2.0) } else { (3.5, 0.0) };
            DVec3::new(reach * t.cos(), reach * t.sin(), height)
        })
        .collect();
    let options = |boundary_curvature| Options {
        objective: Objective::MinimalMeanCurvature,
        boundary_curvature,
        ..Options::new(Resolution::InteriorVertices(4))
    };
    let [theirs, interior] = [true, false].map(|all| run(std::slice::from_ref(&membrane), &options(all)));
    for (name, surface) in [("all vertices", &theirs), ("interior only", &interior)] {
        println!("membrane, {name}: mean of the mean curvatures {:.2e}", surface.statistics.mean_curvature.mean);
    }
    save("liu_wang_membrane", &[("all vertices count", &theirs.mesh), ("interior ones only", &interior.mesh)]);
}

// Bento and Cavalcanti.

fn circle(n: usize, radius: f64, centre: DVec3, normal: DVec3) -> Vec<DVec3> {
    let (u, v) = normal.normalize().any_orthonormal_pair();
    (0..n).map(|k| TAU * k as f64 / n as f64).map(|t| centre + radius * (u * t.cos() + v * t.sin())).collect()
}

fn rings(heights: &[f64]) -> Vec<Vec<DVec3>> {
    heights.iter().map(|&z| circle(36, 10.0, DVec3::new(0.0, 0.0, z), DVec3::Z)).collect()
}

fn bento_cavalcanti(save: Save) {
    println!(
        "\n| rings, height | rules | linear solver | steps | stopped by | components | area | degenerate triangles |"
    );
    println!("| --- | --- | --- | --- | --- | --- | --- | --- |");
    for (name, height, degenerate_angle, steps) in [
        ("bento_cavalcanti_6", 12.0, Some(1f64.to_radians()), [1, 3, 6, 200]),
        ("bento_cavalcanti_7", 14.0, Some(1f64.to_radians()), [8, 16, 20, 200]),
        ("bento_cavalcanti_8", 14.0, None, [8, 16, 20, 200]),
    ] {
        let options = |linear_solver, steps| Options {
            solver: Solver::PinkallPolthier,
            topology: Topology::Free,
            initial_mesh: InitialMesh::Rings,
            degenerate_angle,
            linear_solver,
            tolerance: 0.0,
            area_tolerance: if degenerate_angle.is_none() { 0.0 } else { 1e-6 },
            max_iterations: Some(steps),
            ..Options::new(Resolution::Triangles(576))
        };
        for linear_solver in LinearSolver::ALL {
            let statistics = run(&rings(&[0.0, height]), &options(linear_solver, 200)).statistics;
            println!(
                "| {height} | {} | {} | {} | {} | {} | {:.4} | {} |",
                if degenerate_angle.is_some() { "on" } else { "off" },
                linear_solver.name(),
                statistics.iterations,
                statistics.stop_reason.name(),
                statistics.components,
                statistics.area,
                statistics.degenerate_triangles,
            );
        }
        let meshes = steps.map(|steps| run(&rings(&[0.0, height]), &options(LinearSolver::Direct, steps)).mesh);
        let titles = steps.map(|steps| if steps == 200 { String::from("end") } else { format!("step {steps}") });
        let pictures: Vec<(&str, &Mesh)> = titles.iter().map(String::as_str).zip(&meshes).collect();
        save(name, &pictures);
    }
    let mut pictures = Vec::new();
    let (boundary, mesh) = cut_cylinder(36, 6, 20.0, 0.2);
    for steps in [1, 8, 16, 200] {
        let options = Options {
            solver: Solver::PinkallPolthier,
            topology: Topology::Free,
            initial_mesh: InitialMesh::Given(mesh.clone()),
            max_iterations: Some(steps),
            ..Options::new(Resolution::Triangles(1))
        };
        let surface = run(std::slice::from_ref(&boundary), &options);
        if steps == 200 {
            let s = &surface.statistics;
            println!(
                "cut cylinder: {} triangles of {}, Euler characteristic {}, area {:.3}, {} pinches",
                s.triangles,
                mesh.triangles.len(),
                s.euler_characteristic,
                s.area,
                s.pinches.len()
            );
        }
        pictures.push((format!("step {steps}"), surface.mesh));
    }
    let pictures: Vec<(&str, &Mesh)> = pictures.iter().map(|(title, mesh)| (title.as_str(), mesh)).collect();
    save("bento_cavalcanti_9", &pictures);
}

/// A cylinder cut along a line and opened by an angle: its one boundary loop, and its mesh.
fn cut_cylinder(n: u32, strips: u32, height: f64, opening: f64) -> (Vec<DVec3>, Mesh) {
    let at = |i: u32, j: u32| i * (strips + 1) + j;
    let point = |i: u32, j: u32| {
        let angle = 0.5 * opening + (TAU - opening) * f64::from(i) / f64::from(n);
        DVec3::new(10.0 * angle.cos(), 10.0 * angle.sin(), height * f64::from(j) / f64::from(strips))
    };
    let vertices = (0..=n).flat_map(|i| (0..=strips).map(move |j| point(i, j))).collect();
    let cells = (0..n).flat_map(|i| (0..strips).map(move |j| (i, j)));
    let triangles = cells
        .flat_map(|(i, j)| [[at(i, j), at(i + 1, j), at(i + 1, j + 1)], [at(i, j), at(i + 1, j + 1), at(i, j + 1)]])
        .collect();
    let boundary = (0..n)
        .map(|i| point(i, 0))
        .chain((0..strips).map(|j| point(n, j)))
        .chain((1..=n).rev().map(|i| point(i, strips)))
        .chain((1..=strips).rev().map(|j| point(0, j)))
        .collect();
    (boundary, Mesh::new(vertices, triangles))
}

// Spanning topologies.

fn spanning(save: Save) {
    let tetrahedron: Vec<Vec<DVec3>> = [(1.0, 1.0, 1.0), (1.0, -1.0, -1.0), (-1.0, 1.0, -1.0), (-1.0, -1.0, 1.0)]
        .iter()
        .map(|&(x, y, z)| DVec3::new(x, y, z).normalize())
        .map(|normal| circle(36, 0.6, 0.5 * normal, normal))
        .collect();
    let nested = vec![circle(48, 2.0, DVec3::ZERO, DVec3::Z), circle(24, 0.7, DVec3::new(0.4, 0.1, 0.0), DVec3::Z)];
    let cases = [
        ("two rings, height 12", "rings_12", rings(&[0.0, 12.0])),
        ("two rings, height 14", "rings_14", rings(&[0.0, 14.0])),
        ("three rings, 6 apart", "row", rings(&[0.0, 6.0, 12.0])),
        ("four loops on a tetrahedron's faces", "tetrahedron", tetrahedron),
        ("a loop inside another", "nested", nested),
    ];
    println!("\n| boundaries | films over | area | stable | cross |\n| --- | --- | --- | --- | --- |");
    let mut least = Vec::new();
    for (title, _, boundaries) in &cases {
        let options = Options { topology: Topology::Best, ..Options::new(Resolution::Triangles(1500)) };
        let surface = run(boundaries, &options);
        if let Some(comparison) = &surface.statistics.spanning {
            for topology in &comparison.topologies {
                let area = topology.area.map_or(String::from("does not hold"), |area| format!("{area:.4}"));
                let stable = topology.stability.map_or("", |stability| if stability.stable { "yes" } else { "no" });
                let cross = if topology.films_cross { "yes" } else { "" };
                let films: Vec<String> = topology.films.iter().map(|film| format!("{film:?}")).collect();
                println!("| {title} | {} | {area} | {stable} | {cross} |", films.join(" "));
            }
            if let Some(fraction) = comparison.largest_gap_fraction {
                println!("| {title} | connected up to {fraction:.4} of the gap | | | |");
            }
        }
        least.push(surface.mesh);
    }
    let pictures: Vec<(&str, &Mesh)> = cases.iter().map(|case| case.1).zip(&least).collect();
    save("spanning_topologies", &pictures);
}

// Triple junctions.

fn half_discs(azimuths_deg: [f64; 3], m: usize, n: usize, bend: DVec3) -> (Vec<Vec<DVec3>>, Mesh) {
    let angle = |i: usize| PI * i as f64 / m as f64;
    let on_wire = |azimuth: f64, i: usize| match i {
        0 => DVec3::Z,
        i if i == m => -DVec3::Z,
        i => DVec3::new(angle(i).sin() * azimuth.cos(), angle(i).sin() * azimuth.sin(), angle(i).cos()),
    };
    let axis = |i: usize| DVec3::Z * angle(i).cos() + bend * angle(i).sin();
    let mut vertices = vec![DVec3::Z, -DVec3::Z];
    vertices.extend((1..m).map(axis));
    let mut triangles = Vec::new();
    for azimuth in azimuths_deg.map(f64::to_radians) {
        let begin = vertices.len();
        for i in 1..m {
            vertices.extend((1..=n).map(|j| match j {
                j if j == n => on_wire(azimuth, i),
                j => axis(i).lerp(on_wire(azimuth, i), j as f64 / n as f64),
            }));
        }
        let at = |i: usize, j: usize| match (i, j) {
            (0, _) => 0,
            (i, _) if i == m => 1,
            (i, 0) => (1 + i) as u32,
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
    let loops = [0, 1]
        .map(|k| {
            let down = (0..m).map(|i| on_wire(azimuths_deg[k].to_radians(), i));
            let up = (1..=m).rev().map(|i| on_wire(azimuths_deg[k + 1].to_radians(), i));
            down.chain(up).collect()
        })
        .to_vec();
    (loops, Mesh::new(vertices, triangles))
}

fn triple(save: Save) {
    println!(
        "\n| wires apart | segments | area / R² | 3π/2 - area / R² | junction length / R | largest and mean departure from 120°, degrees | residuals |"
    );
    println!("| --- | --- | --- | --- | --- | --- | --- |");
    let mut meshes = Vec::new();
    for (azimuths, bend) in
        [([0.0, 120.0, 240.0], DVec3::new(0.3, -0.2, 0.0)), ([0.0, 100.0, 220.0], DVec3::new(0.2, 0.1, 0.0))]
    {
        for (m, n) in [(12, 4), (24, 8), (48, 16)] {
            let (loops, mesh) = half_discs(azimuths, m, n, bend);
            let options = Options {
                initial_mesh: InitialMesh::Given(mesh.clone()),
                tolerance: 1e-8,
                ..Options::new(Resolution::Triangles(1))
            };
            let surface = run(&loops, &options);
            if let Some(junctions) = &surface.statistics.junctions {
                println!(
                    "| {}° {}° {}° | {m} | {:.6} | {:.6} | {:.6} | {:.2e}, {:.2e} | {:.0e}, {:.0e} |",
                    azimuths[1] - azimuths[0],
                    azimuths[2] - azimuths[1],
                    360.0 - azimuths[2],
                    surface.statistics.area,
                    1.5 * PI - surface.statistics.area,
                    junctions.length,
                    junctions.largest_deviation.to_degrees(),
                    junctions.mean_deviation.to_degrees(),
                    surface.statistics.residual,
                    junctions.residual,
                );
            }
            if m == 24 {
                meshes.extend([mesh, surface.mesh]);
            }
        }
    }
    let titles = ["start, 120° apart", "film", "start, 100° 120° 140°", "film"];
    let pictures: Vec<(&str, &Mesh)> = titles.into_iter().zip(&meshes).collect();
    save("triple_junctions", &pictures);
}

// Pictures.

/// Meshes side by side, each seen from the same oblique direction and filling its square, far triangles first.
fn row(pictures: &[(&str, &Mesh)]) -> String {
    const SIZE: f64 = 220.0;
    let (right, back, up) = (
        DVec3::new(0.89, -0.45, 0.0).normalize(),
        DVec3::new(0.42, 0.83, -0.36).normalize(),
        DVec3::new(0.16, 0.32, 0.93).normalize(),
    );
    let mut svg = String::new();
    let width = SIZE * pictures.len() as f64;
    let _ = writeln!(
        svg,
        r##"<svg xmlns="http://www.w3.org/2000/svg" viewBox="0 0 {width} {}" font-family="sans-serif" font-size="12"><rect width="100%" height="100%" fill="#fff"/>"##,
        SIZE + 20.0
    );
    for (k, (title, mesh)) in pictures.iter().enumerate() {
        let seen: Vec<(f64, f64, f64)> =
            mesh.vertices.iter().map(|v| (v.dot(right), -v.dot(up), v.dot(back))).collect();
        let bounds = |of: fn(&(f64, f64, f64)) -> f64| {
            seen.iter().map(of).fold((f64::INFINITY, f64::NEG_INFINITY), |(a, b), x| (a.min(x), b.max(x)))
        };
        let ((x0, x1), (y0, y1)) = (bounds(|p| p.0), bounds(|p| p.1));
        let scale = (SIZE - 20.0) / (x1 - x0).max(y1 - y0);
        let place = |v: u32| {
            let p = seen[v as usize];
            let x = SIZE * k as f64 + 0.5 * SIZE + (p.0 - 0.5 * (x0 + x1)) * scale;
            (x, 20.0 + 0.5 * SIZE + (p.1 - 0.5 * (y0 + y1)) * scale)
        };
        let mut order: Vec<&[u32; 3]> = mesh.triangles.iter().collect();
        let depth = |t: &[u32; 3]| t.iter().map(|&v| seen[v as usize].2).sum::<f64>();
        order.sort_by(|a, b| depth(b).total_cmp(&depth(a)));
        svg.push_str("<g stroke=\"#1b3a4b\" stroke-width=\".3\">\n");
        for triangle in order {
            let [a, b, c] = mesh.corners(*triangle);
            let normal = (b - a).cross(c - a).normalize_or_zero();
            let light = (55.0 + 40.0 * normal.dot(DVec3::new(0.4, -0.7, 0.6).normalize()).abs()).round();
            let [a, b, c] = triangle.map(|v| {
                let (x, y) = place(v);
                format!("{x:.1} {y:.1}")
            });
            let _ = writeln!(svg, r##"<path d="M{a}L{b} {c}z" fill="hsl(205,45%,{light}%)"/>"##);
        }
        let _ = writeln!(svg, r##"</g><text x="{:.0}" y="15">{title}</text>"##, SIZE * k as f64 + 8.0);
    }
    svg.push_str("</svg>\n");
    svg
}
