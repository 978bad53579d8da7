//! Curved domains (Katoh, Ohsaki and Xu, section 4): patches and films, meshed in the plane and carried back.
//!
//! 1. An auxiliary triangulation of the surface: n_u × n_v rectangles of the parameter square, two triangles each; a
//!    film's own triangles.
//! 2. [`flatten`](super::flatten) it.
//! 3. Place nodes along the flattened boundary and mesh its inside with the planar algorithm.
//! 4. Carry the inner nodes back by barycentric coordinates in the auxiliary triangles (eq. 2 and 3), and put them on
//!    the true surface.
//! 5. Move the inner nodes ([`move_nodes`](super::move_nodes)).
//!
//! Departures: the paper does not say how the boundary's nodes are placed. We divide each side (between corners) into
//! pieces that are equal along the surface, as many as keep every piece at ℓ or more both on the surface and in the
//! plane. Coordinates are relative to the surface's centre and in units of ℓ.

use super::flatten;
use super::nurbs::Nurbs;
use crate::edges::{edges, topology};
use crate::options::Options;
use crate::plane::mesh::Outline;
use crate::plane::sides::{Division, Sides, is_sharp, pieces};
use plateau_mesh::codes::WarningCode;
use plateau_mesh::error::{Error, InputError, Place, Step, Warning};
use plateau_mesh::execution::{Execution, Interruption};
use plateau_mesh::measure;
use plateau_mesh::plane::location::Locator;
use plateau_mesh::polyline::mean;
use plateau_mesh::topology::Topology;
use plateau_mesh::{DVec2, DVec3, Mesh};
use plateau_minimal_surface as minimal_surface;

/// Number of intervals of an auxiliary edge over which the length of a side is summed.
const SAMPLES: usize = 8;
/// Turn of a film's boundary, in radians, above which a boundary vertex is a corner.
const CORNER_TURN: f64 = std::f64::consts::FRAC_PI_6;
/// Edge length of a film's own mesh, in ℓ. It is short enough that the facets hardly change the lengths of members. The
/// edges are longer if the mesh would otherwise have more than [`FILM_TRIANGLES`] triangles.
pub(crate) const FILM_EDGE: f64 = 1.0 / 3.0;
/// Largest number of triangles of a film's own mesh.
pub(crate) const FILM_TRIANGLES: f64 = 60_000.0;

/// Number of pieces of a side that are measured between two looks at the caller's signal.
const PIECES_PER_LOOK: u64 = 4096;

/// The surface on which nodes move, as a map from a plane of parameters.
#[derive(Clone, Debug)]
pub(crate) enum Surface {
    /// The plane itself. Its parameters are coordinates.
    Plane,
    /// A patch. Its parameters are in \[0, 1\]². One of its sides may be a single point.
    Patch(Nurbs, Option<Pole>),
    /// A film, flat between its vertices. Its parameters are the coordinates of the flattened film.
    Film { mesh: Mesh, plane: Vec<DVec2>, locator: std::rc::Rc<Locator> },
}

impl Surface {
    /// Returns the point at these parameters, and its derivatives by the first and the second of them.
    pub fn evaluate(&self, p: DVec2) -> [DVec3; 3] {
        match self {
            Self::Plane => [p.extend(0.0), DVec3::X, DVec3::Y],
            Self::Patch(patch, _) => patch.evaluate(p),
            Self::Film { mesh, plane, locator } => {
                let (t, [wa, wb, wc]) = locator.find(p, plane, &mesh.triangles);
                let corners = mesh.triangles[t as usize];
                let [a, b, c] = mesh.corners(corners);
                let [pa, pb, pc] = corners.map(|v| plane[v as usize]);
                let (u, v) = (pb - pa, pc - pa);
                let (eu, ev, double) = (b - a, c - a, u.perp_dot(v));
                [a * wa + b * wb + c * wc, (eu * v.y - ev * u.y) / double, (ev * u.x - eu * v.x) / double]
            }
        }
    }

    /// Returns the corners of a triangle of parameters, each with its motion, with a corner at a pole
    /// [beside the others](Pole::beside).
    pub fn beside_pole(&self, triangle: [(DVec2, DVec2); 3]) -> [(DVec2, DVec2); 3] {
        match self {
            Self::Patch(_, Some(pole)) => pole.beside(triangle),
            _ => triangle,
        }
    }

    /// Returns the parameters of the surface that are nearest to `p`.
    pub fn restrict(&self, p: DVec2) -> DVec2 {
        match self {
            Self::Plane => p,
            Self::Patch(..) => p.clamp(DVec2::ZERO, DVec2::ONE),
            Self::Film { mesh, plane, locator } => {
                let (t, weights) = locator.find(p, plane, &mesh.triangles);
                mesh.triangles[t as usize].iter().zip(weights).map(|(&v, w)| plane[v as usize] * w).sum()
            }
        }
    }
}

/// A side of a patch that is a single point, such as the apex of a cone. All parameters along this side give the point,
/// so that a mean of parameters counts those of the point along the other axis only.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(crate) struct Pole {
    /// The axis along the side.
    along: usize,
    /// The parameter of the side on the other axis, 0 or 1.
    at: f64,
}

impl Pole {
    /// The sides u = 0, u = 1, v = 0 and v = 1 as poles.
    const SIDES: [Self; 4] = [
        Self { along: 1, at: 0.0 },
        Self { along: 1, at: 1.0 },
        Self { along: 0, at: 0.0 },
        Self { along: 0, at: 1.0 },
    ];

    fn is(self, p: DVec2) -> bool {
        p[1 - self.along] == self.at
    }

    /// The parameters of the single vertex of the side.
    fn parameters(self) -> DVec2 {
        let mut p = DVec2::splat(0.5);
        p[1 - self.along] = self.at;
        p
    }

    /// Returns the corners of a triangle of parameters, each with its motion. A corner at the pole is moved
    /// along the side to the middle of the other two corners, because the triangle has its right orientation there.
    pub fn beside(self, triangle: [(DVec2, DVec2); 3]) -> [(DVec2, DVec2); 3] {
        let mut moved = triangle;
        for k in 0..3 {
            let [(a, da), (b, db)] = [triangle[(k + 1) % 3], triangle[(k + 2) % 3]];
            if self.is(triangle[k].0) && !self.is(a) && !self.is(b) {
                moved[k].0[self.along] = 0.5 * (a[self.along] + b[self.along]);
                moved[k].1[self.along] = 0.5 * (da[self.along] + db[self.along]);
            }
        }
        moved
    }
}

/// Returns the mean of parameters with these weights, whose sum is 1.
pub(crate) fn weighted(pole: Option<Pole>, parameters: &[(DVec2, f64)]) -> DVec2 {
    let mut mean: DVec2 = parameters.iter().map(|&(p, w)| p * w).sum();
    if let Some(pole) = pole
        && parameters.iter().any(|&(p, _)| pole.is(p))
    {
        let others = || parameters.iter().filter(|&&(p, _)| !pole.is(p));
        let weight: f64 = others().map(|&(_, w)| w).sum();
        if weight > 0.0 {
            mean[pole.along] = others().map(|&(p, w)| p[pole.along] * w).sum::<f64>() / weight;
        }
    }
    mean
}

/// A patch with the parameters of the auxiliary vertices.
#[derive(Debug)]
struct Chart {
    patch: Nurbs,
    parameters: Vec<DVec2>,
    pole: Option<Pole>,
    /// Mean lengths of the two sides along u and of those along v.
    extent: DVec2,
}

/// A patch relative to its centre, in units of ℓ.
#[derive(Debug)]
pub(crate) struct Centred {
    pub centre: DVec3,
    /// ℓ in the caller's unit.
    pub unit: f64,
    pub patch: Nurbs,
}

impl Centred {
    pub fn of(patch: &Nurbs, unit: f64) -> Self {
        let points: Vec<DVec3> = patch.control_points.iter().flatten().copied().collect();
        let centre = mean(&points);
        Self { centre, unit, patch: patch.centred(centre, unit) }
    }
}

/// A surface with its auxiliary triangulation, before flattening.
#[derive(Debug)]
pub(crate) struct Auxiliary {
    centre: DVec3,
    unit: f64,
    pub mesh: Mesh,
    pub topology: Topology,
    /// `None` for a film.
    chart: Option<Chart>,
    /// The sides of each boundary loop as paths of auxiliary vertices, with the surface on the left.
    sides: Vec<Vec<Vec<u32>>>,
    /// Corners of a film: the auxiliary vertex, and its position in the caller's coordinates.
    pub exact: Vec<(u32, DVec3)>,
    /// For each input point the index of its auxiliary vertex.
    pub inputs: Vec<u32>,
    pub warnings: Vec<Warning>,
}

impl Auxiliary {
    /// Converts a point to the caller's coordinates.
    pub fn place(&self, p: DVec3) -> DVec3 {
        self.centre + p * self.unit
    }

    /// Makes the auxiliary triangulation of a patch, over `options.auxiliary_grid` rectangles. One side may be a single
    /// point. Returns `None` if the patch collapses elsewhere or closes on itself, because it cannot be laid into the
    /// plane then.
    pub fn of_patch(centred: &Centred, options: &Options) -> Option<Self> {
        let Centred { centre, unit, patch } = centred;
        let [nu, nv] = options.auxiliary_grid.map(|n| n as usize);
        let on_grid = |i: usize, j: usize| DVec2::new(i as f64 / nu as f64, j as f64 / nv as f64);
        let grid: Vec<DVec2> = (0..=nu).flat_map(|i| (0..=nv).map(move |j| on_grid(i, j))).collect();
        let points: Vec<DVec3> = grid.iter().map(|&p| patch.evaluate(p)[0]).collect();
        let tiny = 1e-9 * points.iter().map(|p| p.length()).fold(0.0, f64::max);
        let is_point = |pole: &Pole| {
            let mut side = grid.iter().zip(&points).filter(|(p, _)| pole.is(**p)).map(|(_, point)| point);
            side.next().is_some_and(|first| side.all(|point| point.distance(*first) <= tiny))
        };
        let mut poles = Pole::SIDES.into_iter().filter(is_point);
        let pole = poles.next();
        if poles.next().is_some() {
            return None;
        }
        let (mut vertices, mut parameters, mut numbers) = (Vec::new(), Vec::new(), Vec::new());
        let mut at_pole = None;
        for (&p, &point) in grid.iter().zip(&points) {
            let own = pole.filter(|pole| pole.is(p));
            let number = own.and(at_pole).unwrap_or(vertices.len() as u32);
            if number as usize == vertices.len() {
                vertices.push(point);
                parameters.push(own.map_or(p, Pole::parameters));
            }
            at_pole = own.map(|_| number).or(at_pole);
            numbers.push(number);
        }
        let vertex = |i: usize, j: usize| numbers[i * (nv + 1) + j];
        let triangles: Vec<[u32; 3]> = (0..nu)
            .flat_map(|i| (0..nv).map(move |j| (i, j)))
            .flat_map(|(i, j)| {
                [
                    [vertex(i, j), vertex(i + 1, j), vertex(i + 1, j + 1)],
                    [vertex(i, j), vertex(i + 1, j + 1), vertex(i, j + 1)],
                ]
            })
            .filter(|[a, b, c]| a != b && b != c && c != a)
            .collect();
        let mesh = Mesh::new(vertices, triangles);
        let topology = topology(mesh.vertices.clone(), &mesh.triangles).ok()?;
        let apart = |a: u32, b: u32| mesh.vertices[a as usize].distance(mesh.vertices[b as usize]);
        if edges(&topology).iter().any(|&[a, b]| apart(a, b) <= tiny) {
            return None;
        }
        let closed = (0..=nv).all(|j| apart(vertex(0, j), vertex(nu, j)) <= tiny)
            || (0..=nu).all(|i| apart(vertex(i, 0), vertex(i, nv)) <= tiny);
        if closed {
            return None;
        }
        let mut sides: Vec<Vec<u32>> = vec![
            (0..=nu).map(|i| vertex(i, 0)).collect(),
            (0..=nv).map(|j| vertex(nu, j)).collect(),
            (0..=nu).rev().map(|i| vertex(i, nv)).collect(),
            (0..=nv).rev().map(|j| vertex(0, j)).collect(),
        ];
        let [along_u, across] = [0, 1].map(|first| {
            // The lengths of opposite sides are averaged.
            let length = |side: &Vec<u32>| side.windows(2).map(|pair| apart(pair[0], pair[1])).sum::<f64>();
            0.5 * (length(&sides[first]) + length(&sides[first + 2]))
        });
        sides.retain(|side| side[0] != side[1]);
        let chart = Chart { patch: patch.clone(), parameters, pole, extent: DVec2::new(along_u, across) };
        Some(Self {
            centre: *centre,
            unit: *unit,
            mesh,
            topology,
            chart: Some(chart),
            sides: vec![sides],
            exact: Vec::new(),
            inputs: Vec::new(),
            warnings: Vec::new(),
        })
    }

    /// Solves for the minimal surface that spans the boundaries, and makes its auxiliary triangulation. Progress runs
    /// over `span`.
    ///
    /// # Errors
    /// The errors of [`minimal_surface::solve`], with places below /domain.
    pub fn of_film(
        boundaries: &[Vec<DVec3>],
        options: &Options,
        span: (f64, f64),
        execution: &Execution<'_>,
    ) -> Result<Self, Error> {
        let unit = options.edge_length;
        let film_options = film_options(boundaries, options);
        minimal_surface::check(boundaries, &film_options).map_err(below_domain)?;
        let film = execution
            .part_as("film", [span.0, span.1], |part| minimal_surface::solve(boundaries, &film_options, part))
            .map_err(below_domain)?;
        let topology = topology(film.mesh.vertices.clone(), &film.mesh.triangles)?;
        let centre = mean(&film.mesh.vertices);
        let mesh =
            Mesh::new(film.mesh.vertices.iter().map(|&p| (p - centre) / unit).collect(), film.mesh.triangles.clone());
        let inputs: Vec<u32> = film.input_vertices.iter().flatten().copied().collect();
        let mut given = vec![false; mesh.vertices.len()];
        for &v in &inputs {
            given[v as usize] = true;
        }
        let mut exact = Vec::new();
        let mut sides = Vec::new();
        for ring in topology.boundary_loops() {
            let n = ring.len();
            let position = |k: usize| mesh.vertices[ring[k % n] as usize];
            let turns = |k: usize| {
                measure::angle(position(k + n) - position(k + n - 1), position(k + 1) - position(k)) > CORNER_TURN
            };
            let mut corners: Vec<usize> = (0..n).filter(|&k| given[ring[k] as usize] && turns(k)).collect();
            if corners.is_empty() {
                // A smooth loop starts at its first input point.
                corners.push((0..n).filter(|&k| given[ring[k] as usize]).min_by_key(|&k| ring[k]).unwrap_or(0));
            }
            exact.extend(corners.iter().map(|&k| (ring[k], film.mesh.vertices[ring[k] as usize])));
            let count = corners.len();
            let paths = (0..count).map(|c| {
                let (from, to) = (corners[c], corners[(c + 1) % count]);
                let to = if to <= from { to + n } else { to };
                (from..=to).map(|k| ring[k % n]).collect()
            });
            sides.push(paths.collect());
        }
        let said = |w: Warning| match w.code {
            WarningCode::MergedPoints => w,
            code => Warning { values: w.values, ..Warning::new(WarningCode::Film, format!("{code}: {}", w.detail)) },
        };
        let warnings = film.warnings.into_iter().map(said).collect();
        Ok(Self { centre, unit, mesh, topology, chart: None, sides, exact, inputs, warnings })
    }

    /// Whether a side of the patch is a single point.
    pub fn has_pole(&self) -> bool {
        self.chart.as_ref().is_some_and(|chart| chart.pole.is_some())
    }

    /// The vertices at which sides meet.
    pub fn corners(&self) -> Vec<u32> {
        self.sides.iter().flatten().map(|side| side[0]).collect()
    }

    /// Returns the plane mesh from which flattening starts.
    ///
    /// # Errors
    /// [`Error::NoResult`] if a film has no plane embedding without flipped triangles.
    pub fn start(&self) -> Result<Vec<DVec2>, Error> {
        let Some(Chart { parameters, extent, .. }) = &self.chart else {
            return flatten::start(&self.mesh, &self.topology);
        };
        Ok(parameters.iter().map(|&p| p * *extent).collect())
    }

    /// Returns the surface on which the nodes move after the flattening.
    pub fn surface(&self, plane: &[DVec2], locator: &std::rc::Rc<Locator>) -> Surface {
        match &self.chart {
            Some(chart) => Surface::Patch(chart.patch.clone(), chart.pole),
            None => Surface::Film { mesh: self.mesh.clone(), plane: plane.to_vec(), locator: locator.clone() },
        }
    }

    /// Returns the parameters of a point of the flattened mesh (eq. 3).
    pub fn carry_back(&self, p: DVec2, plane: &[DVec2], locator: &Locator) -> DVec2 {
        let (t, weights) = locator.find(p, plane, &self.mesh.triangles);
        let (of, pole) = self.parameters(plane);
        let corners = self.mesh.triangles[t as usize];
        weighted(pole, &[0, 1, 2].map(|k| (of[corners[k] as usize], weights[k])))
    }

    /// The parameters of the auxiliary vertices, which for a film are their positions in the plane, and the pole.
    fn parameters<'a>(&'a self, plane: &'a [DVec2]) -> (&'a [DVec2], Option<Pole>) {
        self.chart.as_ref().map_or((plane, None), |chart| (&chart.parameters, chart.pole))
    }

    /// Divides the flattened boundary into nodes. The corners come first.
    ///
    /// # Errors
    /// The interruptions of `execution`.
    pub fn boundary(
        &self,
        plane: &[DVec2],
        surface: &Surface,
        division: Division,
        execution: &Execution<'_>,
    ) -> Result<Boundary, Interruption> {
        let mut boundary = Boundary::default();
        let mut node_of = vec![None; self.mesh.vertices.len()];
        let (parameters, pole) = self.parameters(plane);
        let parameter = |v: u32| parameters[v as usize];
        for &corner in self.sides.iter().flatten().map(|side| &side[0]) {
            node_of[corner as usize] = Some(boundary.outline.nodes.len() as u32);
            boundary.outline.nodes.push(plane[corner as usize]);
            boundary.parameters.push(parameter(corner));
            boundary.positions.push(self.mesh.vertices[corner as usize]);
        }
        boundary.corners = boundary.outline.nodes.len();
        boundary.exact =
            self.exact.iter().filter_map(|&(v, p)| node_of[v as usize].map(|node: u32| (node, p))).collect();
        boundary.input_vertices = self.inputs.iter().map(|&v| node_of[v as usize]).collect();
        boundary.sides = Sides::new(boundary.corners);
        for ring in &self.sides {
            let lines: Vec<Line> = ring.iter().map(|side| Line::new(side, plane, parameter, pole, surface)).collect();
            let mut counts: Vec<u32> = Vec::with_capacity(lines.len());
            for line in &lines {
                counts.push(line.pieces(surface, division, execution)?);
            }
            // A loop needs at least three nodes. Ends because each pass adds one.
            while counts.iter().sum::<u32>() < 3 {
                let longest = (0..counts.len()).max_by(|&a, &b| {
                    let piece = |k: usize| lines[k].length() / f64::from(counts[k]);
                    piece(a).total_cmp(&piece(b)).then(b.cmp(&a))
                });
                counts[longest.unwrap_or(0)] += 1;
            }
            let (mut nodes, mut sides) = (Vec::new(), Vec::new());
            for ((side, line), &count) in ring.iter().zip(&lines).zip(&counts) {
                let first = nodes.len();
                nodes.extend(node_of[side[0] as usize]);
                for k in 1..count {
                    let (p, q) = line.at(line.length() * f64::from(k) / f64::from(count));
                    nodes.push(boundary.outline.nodes.len() as u32);
                    boundary.outline.nodes.push(p);
                    boundary.parameters.push(q);
                    boundary.positions.push(surface.evaluate(q)[0]);
                }
                sides.push((first, line.length(), false));
            }
            let n = nodes.len();
            let node = |k: usize| boundary.outline.nodes[nodes[k % n] as usize];
            for k in 0..sides.len() {
                let end = sides.get(k + 1).map_or(n, |next: &(usize, f64, bool)| next.0);
                sides[k].2 = is_sharp(node(end) - node(end - 1), node(end + 1) - node(end));
            }
            boundary.sides.add_loop(&nodes, &sides);
            boundary.outline.loops.push(nodes);
        }
        Ok(boundary)
    }
}

/// The boundary's nodes in the plane, in the parameters and on the surface.
#[derive(Debug, Default)]
pub(crate) struct Boundary {
    pub outline: Outline,
    pub parameters: Vec<DVec2>,
    pub positions: Vec<DVec3>,
    pub sides: Sides,
    pub exact: Vec<(u32, DVec3)>,
    pub input_vertices: Vec<Option<u32>>,
    corners: usize,
}

/// Returns the point at a fraction of the way from `a` to `b`. A coordinate that both share is kept exactly, so that
/// nodes on a straight side of a patch are exactly collinear and span no triangle.
fn between(a: DVec2, b: DVec2, part: f64) -> DVec2 {
    a + (b - a) * part
}

/// Returns the parameters of two neighbours on a side of a patch. The parameters of a pole are those on the same line.
fn beside_pole(pole: Option<Pole>, [mut a, mut b]: [DVec2; 2]) -> [DVec2; 2] {
    match pole {
        Some(pole) if pole.is(a) => a[pole.along] = b[pole.along],
        Some(pole) if pole.is(b) => b[pole.along] = a[pole.along],
        _ => {}
    }
    [a, b]
}

/// Samples of a side: the length along the surface from the side's start, the position in the plane, and the
/// parameters.
struct Line {
    samples: Vec<(f64, DVec2, DVec2)>,
}

impl Line {
    fn new(
        side: &[u32],
        plane: &[DVec2],
        parameter: impl Fn(u32) -> DVec2,
        pole: Option<Pole>,
        surface: &Surface,
    ) -> Self {
        let mut samples: Vec<(f64, DVec2, DVec2)> = Vec::with_capacity(SAMPLES * side.len());
        let (mut way, mut last) = (0.0, None::<DVec3>);
        let segments = side.len() - 1;
        for k in 0..=segments * SAMPLES {
            let (segment, part) = ((k / SAMPLES).min(segments - 1), k - (k / SAMPLES).min(segments - 1) * SAMPLES);
            let part = part as f64 / SAMPLES as f64;
            let (a, b) = (side[segment], side[segment + 1]);
            let p = between(plane[a as usize], plane[b as usize], part);
            let [from, to] = beside_pole(pole, [parameter(a), parameter(b)]);
            let q = between(from, to, part);
            let here = surface.evaluate(q)[0];
            way += last.map_or(0.0, |last| last.distance(here));
            last = Some(here);
            samples.push((way, p, q));
        }
        Self { samples }
    }

    fn length(&self) -> f64 {
        self.samples.last().map_or(0.0, |sample| sample.0)
    }

    /// Returns the position in the plane and the parameters at a length along the surface.
    fn at(&self, way: f64) -> (DVec2, DVec2) {
        let k = self.samples.partition_point(|sample| sample.0 < way).clamp(1, self.samples.len() - 1);
        let ((w0, p0, q0), (w1, p1, q1)) = (self.samples[k - 1], self.samples[k]);
        let part = if w1 > w0 { ((way - w0) / (w1 - w0)).clamp(0.0, 1.0) } else { 0.0 };
        (between(p0, p1, part), between(q0, q1, part))
    }

    /// Returns the number of pieces into which a side is divided. It is smaller than the division asks for if a chord
    /// would otherwise be shorter than ℓ in the plane or in space.
    ///
    /// # Errors
    /// The interruptions of `execution`.
    fn pieces(&self, surface: &Surface, division: Division, execution: &Execution<'_>) -> Result<u32, Interruption> {
        let mut count = pieces(self.length(), division);
        // Middle of the piece that was too short, as a fraction of the line. At a sharp bend a piece stays too short
        // for many counts, so the piece there is measured first.
        let mut bend = 0.0;
        let mut work = 0;
        // Ends because each pass removes a piece. Together the passes measure at most count² pieces.
        while count > 1 {
            let node = |k: u32| {
                let (p, q) = self.at(self.length() * f64::from(k) / f64::from(count));
                (p, surface.evaluate(q)[0])
            };
            let is_short = |k: &u32| {
                let (from, to) = (node(*k), node(*k + 1));
                let is_long = from.0.distance(to.0).min(from.1.distance(to.1)) >= 1.0;
                !is_long
            };
            let there = (bend * f64::from(count)) as u32;
            let found = Some(there).filter(is_short).or_else(|| (0..count).find(is_short));
            work += 1 + u64::from(found.filter(|&short| short != there).unwrap_or(0));
            if work >= PIECES_PER_LOOK {
                execution.look(std::mem::take(&mut work))?;
            }
            let Some(short) = found else { break };
            bend = (f64::from(short) + 0.5) / f64::from(count);
            count -= 1;
        }
        Ok(count)
    }
}

/// Returns the options for the solver of minimal surfaces.
fn film_options(boundaries: &[Vec<DVec3>], options: &Options) -> minimal_surface::Options {
    let unit = options.edge_length;
    let target = unit * FILM_EDGE.max((film_area(boundaries) / (unit * unit) * 2.31 / FILM_TRIANGLES).sqrt());
    // Flattening needs even triangles more than the least area.
    minimal_surface::Options {
        slides: false,
        ..minimal_surface::Options::new(minimal_surface::Resolution::EdgeLength(target))
    }
}

/// Runs the checks of the film's solver on the boundaries, before any work.
///
/// # Errors
/// The errors of [`minimal_surface::check`]. Errors in the boundaries have places below /domain; all others are at
/// /edge_length, from which the solver's resolution follows.
pub(crate) fn check_film(boundaries: &[Vec<DVec3>], options: &Options) -> Result<(), Error> {
    minimal_surface::check(boundaries, &film_options(boundaries, options)).map_err(below_domain)
}

/// Converts the places of the film solver's errors to places in this module's input.
fn below_domain(error: Error) -> Error {
    let below = |errors: Vec<InputError>| {
        let below = |e: InputError| {
            let steps = std::iter::once(Step::Field("domain")).chain(e.place.0.iter().copied()).collect();
            // The caller gave no resolution. It follows from the edge length, so that is the place of the error.
            let place = if e.place.0.first() == Some(&Step::Field("boundaries")) {
                Place(steps)
            } else {
                Place::field("edge_length")
            };
            InputError::new(place, e.detail)
        };
        errors.into_iter().map(below).collect()
    };
    match error {
        Error::Input(errors) => Error::Input(below(errors)),
        Error::NoResult { reason, detail, places } => Error::NoResult { reason, detail, places: below(places) },
        Error::Interrupted(interruption) => Error::Interrupted(interruption),
    }
}

/// Upper bound of the least area of a film: the area of the fans from each boundary to its mean.
pub(crate) fn film_area(boundaries: &[Vec<DVec3>]) -> f64 {
    let fan = |points: &Vec<DVec3>| -> f64 {
        let centre = mean(points);
        let around = points.iter().zip(points.iter().cycle().skip(1));
        around.map(|(&a, &b)| 0.5 * (a - centre).cross(b - centre).length()).sum()
    };
    boundaries.iter().map(fan).sum()
}
