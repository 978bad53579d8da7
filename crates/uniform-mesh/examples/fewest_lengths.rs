//! Counts the different lengths of lattices, with and without [`Optimise::Lengths`].
//!
//! `cargo run --release -p plateau-uniform-mesh --example fewest_lengths` prints the tables of
//! `docs/papers/katoh-ohsaki-xu.md`: the floor of that page at four edge lengths, 20 domains, and for the three smallest
//! the fewest lengths of all lattices that were tried. For these the lattice takes every direction of a side and 24
//! more, and 144 origins and every boundary node for each. The rim between it and the boundary is filled by farthest
//! points as the paper says, and the triangulations of the rim are searched whole, by branch and bound.

#![allow(
    clippy::disallowed_macros,
    clippy::disallowed_methods,
    clippy::disallowed_types,
    clippy::too_many_lines,
    reason = "an example"
)]

use plateau_mesh::{DVec2, DVec3, Execution};
use plateau_uniform_mesh::statistics::distinct_lengths;
use plateau_uniform_mesh::{Domain, Nurbs, Objective, Optimise, Options, UniformMesh, solve};
use std::collections::BTreeSet;
use std::f64::consts::{FRAC_PI_3, TAU};

/// Tolerance within which two lengths count as one, in ℓ.
const TOLERANCE: f64 = 0.01;
/// Tolerance for rounding, in ℓ.
const ROUNDING: f64 = 1e-9;

fn polygon(corners: &[[f64; 2]]) -> Domain {
    Domain::Polygon { outer: corners.iter().map(|&p| DVec2::from(p).extend(0.0)).collect(), holes: Vec::new() }
}

fn oval(corners: usize, half: [f64; 2]) -> Domain {
    let corner = |k: usize| (DVec2::from_angle(TAU * k as f64 / corners as f64) * DVec2::from(half)).to_array();
    polygon(&(0..corners).map(corner).collect::<Vec<_>>())
}

/// A Bézier roof of 4 × 4 control points over a rectangle.
fn roof(width: f64, depth: f64, heights: [[f64; 4]; 4]) -> Domain {
    let at = |i: usize, j: usize| DVec3::new(width * i as f64 / 3.0, depth * j as f64 / 3.0, heights[i][j]);
    Domain::Bezier { control_points: (0..4).map(|i| (0..4).map(|j| at(i, j)).collect()).collect() }
}

/// A part of a cylinder with a horizontal axis.
fn vault(radius: f64, angle: f64, length: f64) -> Domain {
    let half = angle / 2.0;
    let arc = [DVec2::from_angle(-half), DVec2::X / half.cos(), DVec2::from_angle(half)];
    let row = |p: &DVec2| [0.0, length].map(|y| DVec3::new(p.y * radius, y, p.x * radius)).to_vec();
    Domain::Nurbs(Nurbs {
        degrees: [2, 1],
        knots: [vec![0.0, 0.0, 0.0, 1.0, 1.0, 1.0], vec![0.0, 0.0, 1.0, 1.0]],
        control_points: arc.iter().map(row).collect(),
        weights: Some(vec![vec![1.0; 2], vec![half.cos(); 2], vec![1.0; 2]]),
    })
}

/// A square frame whose sides rise in `humps` humps, as the boundary of a film.
fn film(side: f64, height: f64, humps: f64) -> Domain {
    let corners = [[0.0, 0.0], [side, 0.0], [side, side], [0.0, side]].map(DVec2::from);
    let point = |k: usize| {
        let part = (k % 16) as f64 / 16.0;
        let rise = height * (humps * 0.5 * TAU * part).sin().powi(2);
        corners[k / 16].lerp(corners[(k / 16 + 1) % 4], part).extend(rise)
    };
    Domain::Boundaries(vec![(0..64).map(point).collect()])
}

const FLOOR: [[f64; 2]; 5] = [[0.0, 0.0], [30.0, 0.0], [36.0, 16.0], [20.0, 30.0], [-4.0, 22.0]];

/// The 20 domains with their names and edge lengths. The three smallest come first.
fn domains() -> Vec<(&'static str, Domain, f64)> {
    let plaza = Domain::Polygon {
        outer: [[0.0, 0.0], [24.0, 0.0], [24.0, 18.0], [0.0, 18.0]].map(|p| DVec2::from(p).extend(0.0)).to_vec(),
        holes: vec![[[8.0, 6.0], [15.0, 6.0], [15.0, 12.0], [8.0, 12.0]].map(|p| DVec2::from(p).extend(0.0)).to_vec()],
    };
    let gentle = [[0.0, 2.0, 2.0, 0.0], [3.0, 9.0, 9.0, 3.0], [3.0, 9.0, 9.0, 3.0], [0.0, 2.0, 2.0, 0.0]];
    let lopsided = [[0.0, 6.0, 2.0, 0.0], [5.0, 20.0, 14.0, 3.0], [1.0, 12.0, 22.0, 5.0], [0.0, 3.0, 7.0, 0.0]];
    let saddle = [[0.0, 4.0, 8.0, 12.0], [4.0, 5.0, 7.0, 8.0], [8.0, 7.0, 5.0, 4.0], [12.0, 8.0, 4.0, 0.0]];
    vec![
        ("square of side 3.6", polygon(&[[0.0, 0.0], [3.6, 0.0], [3.6, 3.6], [0.0, 3.6]]), 1.0),
        ("regular pentagon of radius 2.6", oval(5, [2.6, 2.6]), 1.0),
        ("hexagon, 5 by 4", oval(6, [2.5, 2.0]), 1.0),
        ("square of side 20", polygon(&[[0.0, 0.0], [20.0, 0.0], [20.0, 20.0], [0.0, 20.0]]), 2.0),
        ("rectangle, 30 by 11", polygon(&[[0.0, 0.0], [30.0, 0.0], [30.0, 11.0], [0.0, 11.0]]), 1.5),
        ("trapezium", polygon(&[[0.0, 0.0], [28.0, 0.0], [22.0, 14.0], [3.0, 14.0]]), 1.5),
        ("floor of the page", polygon(&FLOOR), 2.0),
        ("oval of 5 corners", oval(5, [20.0, 17.0]), 2.5),
        ("oval of 7 corners", oval(7, [20.0, 17.0]), 2.5),
        ("oval of 9 corners", oval(9, [20.0, 17.0]), 2.5),
        ("oval of 24 corners", oval(24, [16.0, 12.0]), 2.0),
        ("circle of 48 corners", oval(48, [12.0, 12.0]), 1.5),
        (
            "L-shaped floor",
            polygon(&[[0.0, 0.0], [24.0, 0.0], [24.0, 9.0], [11.0, 9.0], [11.0, 20.0], [0.0, 20.0]]),
            1.5,
        ),
        ("plaza with a courtyard", plaza, 1.5),
        ("vault over 69 degrees", vault(40.0, 1.2, 60.0), 5.0),
        ("vault over 92 degrees", vault(20.0, 1.6, 40.0), 3.0),
        ("gentle roof", roof(40.0, 30.0, gentle), 3.0),
        ("lopsided roof", roof(45.0, 40.0, lopsided), 4.0),
        ("saddle roof", roof(36.0, 36.0, saddle), 3.0),
        ("film in a frame with humps", film(40.0, 4.0, 3.0), 4.0),
    ]
}

fn run(domain: &Domain, edge_length: f64, optimise: Optimise, tolerance: f64) -> UniformMesh {
    let options = Options {
        optimise,
        length_tolerance: Some(tolerance * edge_length),
        ..Options::new(edge_length, Objective::MostEqualEdges)
    };
    solve(domain, &options, &Execution::default()).expect("the domains have meshes")
}

/// Number of lattice members whose length is ℓ up to rounding.
fn exact(mesh: &UniformMesh, edge_length: f64) -> usize {
    let lattice = mesh.lengths.iter().zip(&mesh.lattice_group).filter(|&(_, &is_lattice)| is_lattice);
    lattice.filter(|&(length, _)| (length / edge_length - 1.0).abs() <= ROUNDING).count()
}

fn boundary(mesh: &UniformMesh) -> usize {
    2 * mesh.mesh.vertices.len() - 2 - mesh.mesh.triangles.len()
}

fn main() {
    println!("| ℓ | boundary nodes | members | lengths of the lattice alone | with `lengths` | per boundary node |");
    println!("| --- | --- | --- | --- | --- | --- |");
    for edge_length in [2.0, 1.0, 0.5, 0.25] {
        let domain = polygon(&FLOOR);
        let alone = run(&domain, edge_length, Optimise::Nodes, 1e-6);
        let [few, many] = [run(&domain, edge_length, Optimise::Lengths { most: 1 }, 1e-6), alone];
        let [few, many, rim, members] =
            [few.statistics.distinct_lengths, many.statistics.distinct_lengths, boundary(&many), many.members.len()];
        println!("| {edge_length} | {rim} | {members} | {many} | {few} | {:.2} |", few as f64 / rim as f64);
    }
    println!();
    println!(
        "| domain | ℓ | members | asked for | lengths | out of range | exact | lengths with `lengths` | out of range | \
         exact |"
    );
    println!("|{}", " --- |".repeat(10));
    let mut small = Vec::new();
    let mut fewer = 0;
    for (k, (name, domain, edge_length)) in domains().into_iter().enumerate() {
        let alone = run(&domain, edge_length, Optimise::Nodes, TOLERANCE);
        let most = (alone.statistics.distinct_lengths / 3).max(2);
        let shared = run(&domain, edge_length, Optimise::Lengths { most }, TOLERANCE);
        let cells = |mesh: &UniformMesh| {
            let statistics = &mesh.statistics;
            let exact = exact(mesh, edge_length);
            format!("{} | {} | {exact}", statistics.distinct_lengths, statistics.out_of_range_edges)
        };
        let members = alone.members.len();
        println!("| {name} | {edge_length} | {members} | {most} | {} | {} |", cells(&alone), cells(&shared));
        fewer += usize::from(shared.statistics.distinct_lengths < alone.statistics.distinct_lengths);
        if k < 3 {
            small.push((name, alone, shared));
        }
    }
    println!("\nFewer lengths on {fewer} of 20 domains.\n");
    println!("| domain | lattice alone | with `lengths` | fewest of the lattices tried | lattices | cut short |");
    println!("| --- | --- | --- | --- | --- | --- |");
    for (name, alone, shared) in small {
        let outline = alone.mesh.check().expect("a mesh").boundary_loops()[0].clone();
        let nodes: Vec<DVec2> = outline.iter().map(|&v| alone.mesh.vertices[v as usize].truncate()).collect();
        let [few, many] = [shared, alone].map(|mesh| mesh.statistics.distinct_lengths);
        let Fewest { lengths, placements, cut_short } = fewest(&nodes);
        println!("| {name} | {many} | {few} | {lengths} | {placements} | {cut_short} |");
    }
}

/// Result of the search over all lattices.
struct Fewest {
    lengths: usize,
    placements: usize,
    /// Number of placements whose triangulations were not all searched.
    cut_short: usize,
}

/// Returns the fewest lengths of a convex domain with these boundary nodes, counter-clockwise, for ℓ = 1.
fn fewest(nodes: &[DVec2]) -> Fewest {
    let sides = || nodes.iter().zip(nodes.iter().cycle().skip(1));
    let mut angles: Vec<f64> = sides().map(|(a, b)| (*b - *a).to_angle().rem_euclid(FRAC_PI_3)).collect();
    angles.extend((0..24).map(|k| FRAC_PI_3 * f64::from(k) / 24.0));
    let mut found = Fewest { lengths: usize::MAX, placements: 0, cut_short: 0 };
    for angle in angles {
        let [along, across] = [angle, angle + FRAC_PI_3].map(DVec2::from_angle);
        let grid = (0..144).map(|k| along * (f64::from(k % 12) / 12.0) + across * (f64::from(k / 12) / 12.0));
        for origin in grid.chain(nodes.iter().copied()) {
            found.placements += 1;
            let mut rim = Rim::new(nodes, origin, [along, across]);
            rim.search(&mut found.lengths);
            found.cut_short += usize::from(rim.steps >= STEPS);
        }
    }
    found
}

/// Maximum number of triangles that are tried for one placement.
const STEPS: usize = 300_000;

/// A domain with its lattice and the inserted nodes, and a triangulation of its rim that is being built.
struct Rim {
    points: Vec<DVec2>,
    edges: Vec<[usize; 2]>,
    /// Directed edges that still need a triangle on their left.
    open: BTreeSet<[usize; 2]>,
    /// Directed edges with a triangle on their left, or outside the domain.
    closed: BTreeSet<[usize; 2]>,
    lengths: Vec<f64>,
    steps: usize,
}

fn cross(a: DVec2, b: DVec2, c: DVec2) -> f64 {
    (b - a).perp_dot(c - a)
}

impl Rim {
    fn new(outline: &[DVec2], origin: DVec2, [along, across]: [DVec2; 2]) -> Self {
        let count = outline.len();
        let sides = || (0..count).map(|k| [k, (k + 1) % count]);
        let is_inside = |p: DVec2| sides().all(|[a, b]| cross(outline[a], outline[b], p) > ROUNDING);
        let is_clear = |p: DVec2| {
            outline.iter().all(|node| node.distance(p) >= 1.0 - ROUNDING)
                && sides().all(|[a, b]| (outline[a] - p).dot(outline[b] - p) > 0.0)
        };
        let reach = outline.iter().map(|node| node.distance(origin)).fold(0.0, f64::max).ceil() as i32 * 2;
        let mut lattice: Vec<DVec2> = (-reach..=reach)
            .flat_map(|i| (-reach..=reach).map(move |j| origin + along * f64::from(i) + across * f64::from(j)))
            .filter(|&p| is_inside(p) && is_clear(p))
            .collect();
        let near = |a: DVec2, b: DVec2| (a.distance(b) - 1.0).abs() < 1e-6;
        let all = lattice.clone();
        lattice.retain(|&p| all.iter().any(|&q| near(p, q)));
        let mut points = outline.to_vec();
        points.extend_from_slice(&lattice);
        let mut edges: Vec<[usize; 2]> = sides().collect();
        let mut rim = Self {
            open: sides().collect(),
            closed: sides().map(|[a, b]| [b, a]).collect(),
            points: Vec::new(),
            edges: Vec::new(),
            lengths: Vec::new(),
            steps: 0,
        };
        for a in count..points.len() {
            for b in (count..points.len()).filter(|&b| near(points[a], points[b])) {
                let is_apex = |c: &usize| {
                    let c = points[*c];
                    near(points[a], c) && near(points[b], c) && cross(points[a], points[b], c) > 0.0
                };
                let list = if (count..points.len()).any(|c| is_apex(&c)) { &mut rim.closed } else { &mut rim.open };
                list.insert([a, b]);
                if a < b {
                    edges.push([a, b]);
                }
            }
        }
        // Ends because the inserted points keep a distance of ℓ from each other in a bounded domain.
        while let Some(p) = farthest(&points, is_inside) {
            points.push(p);
        }
        rim.lengths = edges.iter().map(|&[a, b]| points[a].distance(points[b])).collect();
        (rim.points, rim.edges) = (points, edges);
        rim
    }

    fn crosses(&self, [a, b]: [usize; 2]) -> bool {
        let at = |v: usize| self.points[v];
        self.edges.iter().any(|&[c, d]| {
            ![c, d].iter().any(|v| [a, b].contains(v))
                && cross(at(a), at(b), at(c)) * cross(at(a), at(b), at(d)) < 0.0
                && cross(at(c), at(d), at(a)) * cross(at(c), at(d), at(b)) < 0.0
        })
    }

    /// Tries every triangle on the first open edge. `best` is lowered to the fewest lengths of a whole triangulation.
    fn search(&mut self, best: &mut usize) {
        let used = distinct_lengths(&self.lengths, TOLERANCE);
        if used >= *best || self.steps >= STEPS {
            return;
        }
        let Some(&[a, b]) = self.open.first() else {
            *best = used;
            return;
        };
        for c in 0..self.points.len() {
            self.steps += 1;
            let [pa, pb, pc] = [a, b, c].map(|v| self.points[v]);
            if c == a || c == b || cross(pa, pb, pc) <= ROUNDING {
                continue;
            }
            let is_within = |&p: &DVec2| {
                [[pa, pb], [pb, pc], [pc, pa]].iter().all(|&[p0, p1]| cross(p0, p1, p) >= -ROUNDING)
                    && ![pa, pb, pc].contains(&p)
            };
            let sides = [[b, c], [c, a]];
            let length = |[v, w]: [usize; 2]| self.points[v].distance(self.points[w]);
            let is_allowed = |&side: &[usize; 2]| {
                self.open.contains(&side)
                    || !self.closed.contains(&side)
                        && (1.0 - ROUNDING..=2.0 + ROUNDING).contains(&length(side))
                        && !self.crosses(side)
            };
            if self.points.iter().any(is_within) || !sides.iter().all(is_allowed) {
                continue;
            }
            let before = (self.open.clone(), self.closed.clone(), self.edges.len());
            self.open.remove(&[a, b]);
            self.closed.insert([a, b]);
            for [v, w] in sides {
                if !self.open.remove(&[v, w]) {
                    self.open.insert([w, v]);
                    self.edges.push([v, w]);
                    self.lengths.push(self.points[v].distance(self.points[w]));
                }
                self.closed.insert([v, w]);
            }
            self.search(best);
            (self.open, self.closed) = (before.0, before.1);
            self.edges.truncate(before.2);
            self.lengths.truncate(before.2);
        }
    }
}

/// Returns the point inside the domain that is farthest from all points, if that distance is ℓ or more.
fn farthest(points: &[DVec2], is_inside: impl Fn(DVec2) -> bool) -> Option<DVec2> {
    let mut best: Option<(f64, DVec2)> = None;
    for (i, &a) in points.iter().enumerate() {
        for (j, &b) in points.iter().enumerate().skip(i + 1) {
            for &c in &points[j + 1..] {
                let (u, v) = (b - a, c - a);
                let doubled = 2.0 * u.perp_dot(v);
                if doubled.abs() < ROUNDING {
                    continue;
                }
                let from = DVec2::new(
                    v.y * u.length_squared() - u.y * v.length_squared(),
                    u.x * v.length_squared() - v.x * u.length_squared(),
                ) / doubled;
                let (radius, centre) = (from.length(), a + from);
                if radius >= 1.0
                    && best.is_none_or(|(most, _)| radius > most + ROUNDING)
                    && is_inside(centre)
                    && points.iter().all(|p| p.distance(centre) >= radius - ROUNDING)
                {
                    best = Some((radius, centre));
                }
            }
        }
    }
    best.map(|(_, centre)| centre)
}
