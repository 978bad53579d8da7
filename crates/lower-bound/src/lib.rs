//! How far a film is at most from the least area over *all* oriented surfaces with its boundary: a lower bound by
//! duality.
//!
//! # The theorem
//! Let Γ be closed polygons in a convex set H inside a box, and A a field on the box with |curl A| <= 1 in H. Every
//! oriented surface S with boundary Γ has an area of at least ∮_Γ A·dl: inside H by Stokes' theorem, ∮_Γ A = ∫_S curl
//! A·n <= area(S). A surface that leaves H does no better, because the nearest-point projection onto a convex set
//! lengthens nothing: it maps S to a surface in H with the same boundary and no more area. The topology of S plays no
//! part; "surface" may be read as integral current. Surfaces without an orientation (a Möbius film) and films with
//! triple junctions are outside of the theorem. H is an intersection of half-spaces (`hull`). |curl A| <= 1 is imposed
//! in all tetrahedra but those that lie beyond one of them, and at a distance.
//!
//! A is piecewise polynomial with continuous tangential components (`element`). Mollified, it becomes a smooth field
//! whose curl is an average of values of norm at most 1, and whose integral along Γ tends to that of A, since only the
//! tangential component can matter where Γ runs inside a face or an edge. So Stokes' theorem applies.
//!
//! # The computation
//! Every A gives a bound; the largest is the solution of a convex problem, dual to that of the least area. Where the
//! boundary has planes of symmetry, A need only be known on one side of each, and the box ends there (`symmetry`). The
//! box is cut into tetrahedra by bisection (`bisection`), finer where the film lies. A maximises ∮A under |curl A| <= 1
//! (`conic`); the multipliers of the constraint are the dual surface, and the mesh is refined where that surface bends
//! inside a tetrahedron. Meshes are nested, so every level takes over the best field of the one before, and an iterate
//! near the central path to start from. The systems are factorised in an order of nested dissection (`dissection`). At
//! the end |curl A| and ∮A are computed with outward rounding (`rigorous`): the bound is a theorem about the given
//! polygons in f64.
//!
//! # Work instead of time
//! This crate knows no clock. The budget in seconds is converted to work by fixed rates, so the same request always
//! gives the same bytes; a deadline of the caller only stops it earlier.

#![forbid(unsafe_code)]

mod bisection;
mod conic;
mod dissection;
mod element;
mod hull;
mod interval;
mod rigorous;
mod space;
mod symmetry;
mod system;
#[cfg(test)]
mod tests;

use bisection::{BEST, BisectionMesh, CENTRAL, VertexMap};
use conic::Level;
use glam::DVec4;
use hull::Hull;
use plateau_mesh::execution::Interruption;
use plateau_mesh::{DVec3, Error, Execution, Mesh, Progress};
use space::Space;
use symmetry::Mirrors;
pub use symmetry::{Frame, Mirror};
use system::{Stop, System};

/// Options of [`certify`].
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Options {
    /// The search ends once the film's area is at most this fraction above the bound.
    pub gap: f64,
    /// Nominal seconds of one core, converted to work by fixed rates.
    pub seconds: f64,
}

impl Default for Options {
    fn default() -> Self {
        Self { gap: 0.005, seconds: 2.0 }
    }
}

/// The field that proves a bound for one orientation of the boundary.
#[derive(Clone, Debug, PartialEq)]
pub struct Field {
    /// The boundary, oriented.
    pub loops: Vec<Vec<DVec3>>,
    /// Every oriented surface with this oriented boundary has at least this area.
    pub area_lower_bound: f64,
    /// The axes to which the following coordinates refer, if not to those of the loops.
    pub frame: Option<Frame>,
    /// Opposite corners of the box. The low one lies in the planes of symmetry.
    pub corners: [DVec3; 2],
    /// Planes at which the box and the field are reflected. The boundary lies in the box and its mirror images.
    pub mirrors: Vec<Mirror>,
    /// Corners of the tetrahedra.
    pub vertices: Vec<DVec3>,
    /// Vertices of each tetrahedron; the tetrahedra fill the box.
    pub tetrahedra: Vec<[u32; 4]>,
    /// The edges, i < j.
    pub edges: Vec<[u32; 2]>,
    /// The circulation along each edge, from i to j.
    pub edge_values: Vec<f64>,
    /// The faces, i < j < k.
    pub faces: Vec<[u32; 3]>,
    /// The coefficients of λk w_ij and λi w_jk of each face.
    pub face_values: Vec<[f64; 2]>,
    /// Outward directions of half-spaces that hold the boundary and its mirror images: d·x is at most the largest d·p
    /// of their points p.
    pub half_spaces: Vec<DVec3>,
    /// Tetrahedra that lie beyond one of these half-spaces, with its number. There the curl may have any length.
    pub unconstrained: Vec<[u32; 2]>,
}

/// A proven lower bound.
#[derive(Clone, Debug, PartialEq)]
pub struct LowerBound {
    /// No oriented surface of any topology with this boundary has a smaller area, if it runs along the loops in one of
    /// the orientations of `fields`.
    pub area: f64,
    /// A field for each orientation of the loops that differs by more than a reversal of all; the bound is the least
    /// of theirs.
    pub fields: Vec<Field>,
    /// Whether `fields` has all of these orientations, or (beyond [`MOST_LOOPS`]) the film's own alone.
    pub every_orientation: bool,
    /// The loops that the film runs along against their direction, if it runs along loop 0 in its direction.
    pub reversed_loops: Vec<usize>,
    /// Steps of Newton's method of all searches together.
    pub iterations: u32,
    /// Nominal seconds that the work amounts to.
    pub seconds: f64,
    /// Whether a deadline of the caller ended the search.
    pub interrupted: bool,
    /// 1 - |curl A · n| at each vertex of the film, 0 to 1, for the orientation with the least bound: where the bound
    /// is not tight.
    pub slack: Vec<f64>,
}

/// Loops up to which every orientation is searched: 32 of six.
pub const MOST_LOOPS: usize = 6;
/// Longest budget, nominal seconds.
pub const MOST_SECONDS: f64 = 600.0;

/// Leaves of the first mesh.
const FIRST_LEAVES: usize = 600;
/// Leaves of a mesh in terms of the mesh before, at most.
const GROWTH: f64 = 2.5;
/// Growth over several levels that is looked ahead to at most.
const MOST_GROWTH: f64 = 100.0;
/// A mesh that is not finer by this much is not worth a factorisation.
const LEAST_GROWTH: f64 = 1.15;
/// Steps on a mesh at most.
const MOST_STEPS: u32 = 40;
/// Steps that the budget must allow for on the finest mesh, whose bound would otherwise stay below that of the mesh
/// before: this number where half a percent is missing to the film's area, one more for each halving of what is
/// missing, and one more for each doubling of the leaves beyond [`FEW_LEAVES`], because a large mesh starts farther
/// from its optimum.
const STEPS: f64 = 6.0;
const FEW_LEAVES: f64 = 1e4;
/// Steps that are allowed for on a mesh that is left for a finer one.
const STEPS_BETWEEN: u32 = 4;
/// Most of these steps.
const MOST_STEPS_AHEAD: f64 = 24.0;
/// A mesh is left for a finer one once its own optimum is reached to this fraction of what is missing to the film's
/// area. That suffices to see where the dual surface bends.
const CONVERGED: f64 = 1.0;
/// The same where the budget allows no finer mesh, so that steps are all that the rest of it can be used for.
const CONVERGED_AT_LAST: f64 = 0.03;
/// Constrained tetrahedra and factor entries of the largest mesh; they limit the memory.
const MOST_LEAVES: f64 = 60e3;
const MOST_ENTRIES: f64 = 60e6;
/// Fraction of the indicator that the marked leaves of one round of refinement have together.
const MARKED_SHARE: f64 = 0.4;
/// Nominal seconds of a factorisation, per (entries of the factor)² / rows, and of its preparation per leaf. The rates
/// are fitted to the processor time on meshes of 600 to 60,000 leaves, on one core while the other one was idle.
const FACTORISATION_RATE: f64 = 1.25e-10;
const PREPARATION_RATE: f64 = 2e-5;
/// Nominal seconds of a step besides the factorisation, per entry of the factor and per leaf.
const SOLVE_RATE: f64 = 8e-9;
const ASSEMBLY_RATE: f64 = 6.5e-6;

/// The entries of the factor grow with this power of the leaves, without planes of symmetry and with them. Between the
/// last two meshes of 10 s the power was 1.2 to 1.3 and 1.3 to 1.5. Where it is assumed too small, the last mesh is so
/// fine that its steps end short of its optimum: with 1.3 in place of 1.5 the gaps of symmetrical boundaries after 10 s
/// were a tenth larger in the mean, and a half at most.
const FILL_POWERS: [f64; 2] = [1.3, 1.5];

/// Upper bound of the memory that [`certify`] takes.
#[must_use]
pub fn memory_bytes(loops: usize, options: &Options) -> u64 {
    let orientations = if loops <= MOST_LOOPS { 1u64 << loops.saturating_sub(1) } else { 1 };
    // A mesh of the first size takes 8 MB; the largest 1.2 GB, most of it the factor.
    let largest = (options.seconds.clamp(0.0, MOST_SECONDS) * 60e6).min(1.2e9) as u64;
    orientations * 8_000_000 + 50_000_000 + largest
}

/// The search for one orientation.
#[derive(Debug)]
struct Search {
    loops: Vec<Vec<DVec3>>,
    /// The loops in the mesh's frame.
    placed: Vec<Vec<DVec3>>,
    mesh: BisectionMesh,
    /// Circulation of the best field so far; at first that of a constant curl.
    bound: f64,
    /// Size of the last system.
    size: Option<Size>,
    /// Whether the mesh carries an iterate to start from.
    warm: bool,
    /// Whether no further level is possible.
    finished: bool,
}

/// Size of the linear system of a mesh.
#[derive(Clone, Copy, Debug)]
struct Size {
    /// Entries of the factor.
    entries: f64,
    rows: f64,
    /// Constrained leaves.
    leaves: f64,
    fill_power: f64,
}

impl Size {
    /// The size to be expected of a mesh with more leaves.
    fn grown(self, growth: f64) -> Self {
        let Self { entries, rows, leaves, fill_power } = self;
        Self {
            entries: entries * libm::pow(growth, fill_power),
            rows: rows * growth,
            leaves: leaves * growth,
            fill_power,
        }
    }

    /// Nominal seconds of a level of some steps.
    fn price(self, steps: u32) -> f64 {
        PREPARATION_RATE * self.leaves + f64::from(steps) * self.step_price()
    }

    fn step_price(self) -> f64 {
        let Self { entries, rows, leaves, .. } = self;
        FACTORISATION_RATE * entries * entries / rows + SOLVE_RATE * entries + ASSEMBLY_RATE * leaves
    }
}

/// The data and the budget that all searches share.
struct Budget<'a> {
    options: &'a Options,
    hull: &'a Hull,
    film_area: f64,
    samples: &'a [(DVec3, f64)],
    spent: f64,
    iterations: u32,
}

/// Proves a lower bound of the area of every oriented surface bounded by the loops; `film` is a surface that they
/// bound, and shows where the bound has to be sharp.
///
/// With several loops the bound is the least over all their orientations; beyond [`MOST_LOOPS`] it covers the film's
/// own orientation alone. `None` if the coordinates are so large for the loops' size that f64 has no digits left for
/// the mesh, or if the film has no area.
///
/// # Errors
/// [`Error::Interrupted`] on a cancel. A deadline ends the search with what is proven so far.
pub fn certify(
    loops: &[Vec<DVec3>],
    film: &Mesh,
    options: &Options,
    exec: &Execution,
) -> Result<Option<LowerBound>, Error> {
    let every_orientation = loops.len() <= MOST_LOOPS;
    let frame = Frame::of(loops, exec)?;
    let place = |p: DVec3| symmetry::place(frame.as_ref(), p);
    let samples: Vec<(DVec3, f64)> = film
        .triangles
        .iter()
        .map(|&triangle| {
            let [a, b, c] = film.corners(triangle);
            (place((a + b + c) / 3.0), 0.5 * (b - a).cross(c - a).length())
        })
        .collect();
    let film_area: f64 = samples.iter().map(|(_, area)| area).sum();
    if !(film_area.is_finite() && film_area > 0.0) {
        return Ok(None);
    }
    let patterns = if every_orientation { 1u32 << (loops.len() - 1) } else { 1 };
    let own = own_orientation(loops, film);
    let middle = place(symmetry::middle(loops));
    let oriented: Vec<Oriented> = (0..patterns)
        .map(|pattern| {
            // The first pattern is the film's own orientation.
            let oriented = |(k, points): (usize, &Vec<DVec3>)| {
                if own[k] == (pattern >> k & 1 == 1) { points.iter().rev().copied().collect() } else { points.clone() }
            };
            Oriented::of(loops.iter().enumerate().map(oriented).collect(), &place, middle)
        })
        .collect();
    // Orientations with the same symmetries start from the same mesh.
    let mut meshes: Vec<BisectionMesh> = Vec::new();
    let mut mesh_of: Vec<usize> = Vec::with_capacity(oriented.len());
    for of in &oriented {
        let known = meshes.iter().position(|mesh| *mesh.mirrors() == of.mirrors);
        mesh_of.push(known.unwrap_or(meshes.len()));
        if known.is_none() {
            let points = of.placed.iter().flatten().copied();
            let Ok(mesh) = BisectionMesh::around(points, of.mirrors) else { return Ok(None) };
            if !(mesh.volume().is_finite() && mesh.volume() > 0.0) {
                return Ok(None);
            }
            meshes.push(mesh);
        }
    }
    let images: Vec<Vec<DVec3>> = meshes.iter().flat_map(|mesh| mesh.images(&oriented[0].placed)).collect();
    let normals: Vec<DVec3> = images.iter().map(|points| vector_area(std::slice::from_ref(points))).collect();
    let hull = Hull::around(&images, &normals, exec)?;
    let mut budget = Budget { options, hull: &hull, film_area, samples: &samples, spent: 0.0, iterations: 0 };
    for mesh in &mut meshes {
        budget.first_mesh(mesh, exec)?;
    }
    let mut searches: Vec<Search> =
        oriented.into_iter().zip(mesh_of).map(|(of, k)| of.search(meshes[k].clone())).collect();
    let mut storage = Vec::new();
    let mut interrupted = false;
    loop {
        // The weakest orientation decides.
        let weakest = (0..searches.len()).min_by(|&a, &b| searches[a].bound.total_cmp(&searches[b].bound));
        let Some(weakest) = weakest.filter(|&k| !searches[k].finished && !budget.reached(searches[k].bound)) else {
            break;
        };
        match budget.level(&mut searches[weakest], &mut storage, exec) {
            Ok(()) => {}
            Err(Error::Interrupted(Interruption::DeadlinePassed)) => {
                interrupted = true;
                break;
            }
            Err(error) => return Err(error),
        }
    }
    drop(storage);
    let mut fields = Vec::with_capacity(searches.len());
    for search in &searches {
        let Some(field) = search.prove(&hull, frame.as_ref()) else { return Ok(None) };
        fields.push(field);
    }
    let (weakest, area) = fields
        .iter()
        .enumerate()
        .map(|(k, field)| (k, field.area_lower_bound))
        .fold((0, f64::INFINITY), |least, this| if this.1 < least.1 { this } else { least });
    let slack = searches[weakest].slack(film, &hull, frame.as_ref());
    let Budget { iterations, spent, .. } = budget;
    let reversed_loops = (0..loops.len()).filter(|&k| own[k] != own[0]).collect();
    let seconds = spent;
    Ok(Some(LowerBound { area, fields, every_orientation, reversed_loops, iterations, seconds, interrupted, slack }))
}

/// The loops in one orientation.
struct Oriented {
    loops: Vec<Vec<DVec3>>,
    /// In the mesh's frame.
    placed: Vec<Vec<DVec3>>,
    mirrors: Mirrors,
}

impl Oriented {
    fn of(loops: Vec<Vec<DVec3>>, place: &impl Fn(DVec3) -> DVec3, middle: DVec3) -> Self {
        let placed: Vec<Vec<DVec3>> = loops.iter().map(|points| points.iter().map(|&p| place(p)).collect()).collect();
        let mirrors = Mirrors::of(&placed, middle);
        Self { loops, placed, mirrors }
    }

    /// The search starts from a constant curl.
    fn search(self, mut mesh: BisectionMesh) -> Search {
        let Self { loops, placed, .. } = self;
        let vector_area = vector_area(&placed);
        mesh.set_constant_curl(vector_area.normalize_or_zero());
        let bound = vector_area.length();
        Search { loops, placed, mesh, bound, size: None, warm: false, finished: false }
    }
}

/// The integral of the unit normal over any surface that the loops bound. Its length is the bound that a field of
/// constant curl gives: the area itself for plane polygons.
fn vector_area(loops: &[Vec<DVec3>]) -> DVec3 {
    let origin = loops[0][0];
    let of = |points: &Vec<DVec3>| -> DVec3 {
        (0..points.len()).map(|k| (points[k] - origin).cross(points[(k + 1) % points.len()] - origin)).sum()
    };
    0.5 * loops.iter().map(of).sum::<DVec3>()
}

/// For each loop whether the film's triangles run along it in the loop's direction.
fn own_orientation(loops: &[Vec<DVec3>], film: &Mesh) -> Vec<bool> {
    let bits = |p: DVec3| (p + DVec3::ZERO).to_array().map(f64::to_bits);
    let mut first: VertexMap<u32, Vec<u32>> = VertexMap::default();
    for (t, triangle) in film.triangles.iter().enumerate() {
        for &v in triangle {
            first.entry(v).or_default().push(t as u32);
        }
    }
    let mut places: Vec<([u64; 3], u32)> =
        film.vertices.iter().enumerate().map(|(v, &p)| (bits(p), v as u32)).collect();
    places.sort_unstable();
    loops
        .iter()
        .map(|points| {
            // A triangle at the loop's first vertex whose edge leaves it along the first segment, or arrives along it.
            let vertex = places.get(places.partition_point(|place| place.0 < bits(points[0]))).map(|place| place.1);
            let along = (points[1] - points[0]).normalize_or_zero();
            let mut best = (0.0, true);
            for &t in vertex.and_then(|v| first.get(&v)).into_iter().flatten() {
                let triangle = film.triangles[t as usize];
                for k in 0..3 {
                    let (a, b) = (triangle[k], triangle[(k + 1) % 3]);
                    let forward = Some(a) == vertex;
                    if !forward && Some(b) != vertex {
                        continue;
                    }
                    let other = film.vertices[if forward { b } else { a } as usize];
                    let cosine = (other - points[0]).normalize_or_zero().dot(along);
                    // The boundary edge is the one along the segment; an interior edge runs both ways.
                    if cosine > best.0 + 1e-9 {
                        best = (cosine, forward);
                    }
                }
            }
            best.1
        })
        .collect()
}

impl Budget<'_> {
    fn reached(&self, bound: f64) -> bool {
        bound * (1.0 + self.options.gap) >= self.film_area
    }

    fn left(&self) -> f64 {
        self.options.seconds.min(MOST_SECONDS) - self.spent
    }

    /// Area of the film in each leaf.
    fn film_in_leaves(&self, mesh: &BisectionMesh) -> Vec<f64> {
        let mut area = vec![0.0; mesh.leaf_count()];
        for &(point, of) in self.samples {
            area[mesh.locate(point).0 as usize] += of;
        }
        area
    }

    /// Bisects the largest leaves that hold a part of the film until there are enough.
    fn first_mesh(&self, mesh: &mut BisectionMesh, exec: &Execution) -> Result<(), Error> {
        while mesh.leaf_count() < FIRST_LEAVES {
            exec.look(self.samples.len() as u64)?;
            let area = self.film_in_leaves(mesh);
            let held = |leaf: &usize| area[*leaf] > 0.0 && mesh.can_bisect(*leaf);
            let Some(least) = (0..mesh.leaf_count()).filter(held).map(|leaf| mesh.leaf_level(leaf)).min() else {
                break;
            };
            let marked: Vec<u32> = (0..mesh.leaf_count())
                .filter(|leaf| held(leaf) && mesh.leaf_level(*leaf) == least)
                .map(|leaf| leaf as u32)
                .collect();
            mesh.bisect(&marked);
        }
        Ok(())
    }

    /// Constrained leaves of the next mesh after one with this bound, if the rest of the budget allows for a finer one.
    ///
    /// The finest mesh that the budget affords is found first, together with the meshes on the way to it, so that
    /// nothing of the budget is left over that is too little for one more mesh.
    fn next_leaves(&self, size: Size, bound: f64) -> Option<f64> {
        let missing = (1.0 - bound / self.film_area).max(f64::MIN_POSITIVE);
        let steps = |leaves: f64| {
            let more = libm::log2(0.005 / missing).ceil().max(0.0) + libm::log2(leaves / FEW_LEAVES).ceil().max(0.0);
            (STEPS + more).min(MOST_STEPS_AHEAD) as u32
        };
        // The growth is shared out evenly among the fewest levels that do not grow more than they should.
        let levels = |growth: f64| (libm::log(growth) / libm::log(GROWTH)).ceil().max(1.0);
        let affordable = |growth: f64| {
            let levels = levels(growth);
            let between = |k: u32| size.grown(libm::pow(growth, f64::from(k) / levels)).price(STEPS_BETWEEN);
            let finest = size.grown(growth);
            finest.leaves <= MOST_LEAVES
                && finest.entries <= MOST_ENTRIES
                && (1..levels as u32).map(between).sum::<f64>() + finest.price(steps(finest.leaves)) <= self.left()
        };
        let mut growth = MOST_GROWTH;
        while growth >= LEAST_GROWTH {
            if affordable(growth) {
                return Some((size.leaves * libm::pow(growth, 1.0 / levels(growth))).floor());
            }
            growth *= 0.97;
        }
        None
    }

    /// Refines the search's mesh and iterates on it.
    fn level(&mut self, search: &mut Search, storage: &mut Vec<f64>, exec: &Execution) -> Result<(), Error> {
        let first = search.size.is_none();
        if let Some(size) = search.size
            && let Some(next) = self.next_leaves(size, search.bound)
        {
            let growth = next / size.leaves;
            search.mesh.refine((search.mesh.leaf_count() as f64 * growth) as usize, exec)?;
        }
        let Search { placed, mesh, bound, size: last_size, warm, finished, .. } = search;
        exec.look(mesh.leaf_count() as u64)?;
        let mut space = Space::within(mesh, self.hull);
        if !space.is_a_ball() {
            // On the first mesh the curl is constant, and bounded everywhere as well.
            *finished = !first;
            if *finished {
                return Ok(());
            }
            space = Space::of(mesh);
        }
        let form = space.circulation(mesh, placed);
        exec.look(mesh.leaf_count() as u64)?;
        let mut system = System::of(&space, exec)?;
        let size = Size {
            entries: system.factor_entries() as f64,
            rows: system.rows() as f64,
            leaves: space.constrained.len() as f64,
            fill_power: FILL_POWERS[usize::from(mesh.mirrors().images() > 1)],
        };
        if !first && size.entries > 1.5 * MOST_ENTRIES {
            *finished = true;
            return Ok(());
        }
        self.spent += size.price(0);
        *last_size = Some(size);
        let mut level = Level::new(&space, mesh, &form, self.film_area, *warm);
        let a_step = size.step_price();
        let mut interrupted = Ok(());
        let missing = |bound: f64| (self.film_area - bound).max(0.0);
        for _ in 0..MOST_STEPS {
            let finer = self.next_leaves(size, level.best.bound).is_some();
            let enough = if finer { CONVERGED } else { CONVERGED_AT_LAST };
            let converged = level.stalled || level.gap() <= enough * missing(level.best.bound);
            if converged || self.options.gap * level.best.bound >= missing(level.best.bound) || self.left() < a_step {
                break;
            }
            match level.step(&mut system, storage, exec) {
                Ok(()) => {}
                Err(Stop::Interrupted(interruption)) => {
                    interrupted = Err(interruption);
                    break;
                }
                // The best field so far proves its bound all the same.
                Err(Stop::Failed(_)) => break,
            }
            self.spent += a_step;
            self.iterations += 1;
            exec.report(Progress {
                fraction: (self.spent / self.options.seconds.min(MOST_SECONDS)).min(1.0),
                phase: "lower_bound",
                iteration: u64::from(self.iterations),
                objective_value: Some(level.best.bound),
                residual: None,
            });
        }
        *finished = self.next_leaves(size, level.best.bound).is_none();
        *bound = level.best.bound;
        *warm = !level.stalled;
        let currents: Vec<_> = (0..space.constrained.len()).map(|k| level.current(k)).collect();
        let (central, duals) = level.central();
        mesh.carry(&space, &[level.best.field, central], &currents, &duals);
        interrupted.map_err(Error::from)
    }
}

impl BisectionMesh {
    /// Keeps the two fields, and for the constrained leaves the dual surface and the dual vectors of the central field.
    fn carry(&mut self, space: &Space, fields: &[Vec<f64>; 2], currents: &[[DVec3; 4]], duals: &[[DVec4; 4]]) {
        for (leaf, nodal) in self.nodal.iter_mut().enumerate() {
            nodal.curl = [BEST, CENTRAL].map(|which| space.curl_in(leaf, &fields[which]));
            // The dual surface does not reach the others.
            nodal.current = [DVec3::ZERO; 4];
        }
        for ((&leaf, current), dual) in space.constrained.iter().zip(currents).zip(duals) {
            let nodal = &mut self.nodal[leaf as usize];
            (nodal.current, nodal.dual) = (*current, *dual);
        }
        for (k, key) in space.edges.iter().enumerate() {
            if let Some(edge) = self.edges.get_mut(key) {
                edge.circulation = [BEST, CENTRAL].map(|which| fields[which][k]);
            }
        }
    }

    /// Bisects the leaves in which the dual surface bends most, until there are about as many as asked for.
    fn refine(&mut self, leaves: usize, exec: &Execution) -> Result<(), Error> {
        // Leaves that a marked leaf adds, because others are bisected with it.
        let mut added = 2.0;
        while self.leaf_count() < leaves {
            exec.look(self.leaf_count() as u64)?;
            let bend = |leaf: usize| {
                let current = self.nodal[leaf].current;
                current.iter().map(|y| y.length()).sum::<f64>() - current.iter().copied().sum::<DVec3>().length()
            };
            let bends: Vec<f64> = (0..self.leaf_count()).map(bend).collect();
            let mut order: Vec<u32> = (0..self.leaf_count() as u32).collect();
            order.retain(|&leaf| self.can_bisect(leaf as usize));
            order.sort_by(|&a, &b| bends[b as usize].total_cmp(&bends[a as usize]).then(a.cmp(&b)));
            let total: f64 = bends.iter().sum();
            let before = self.leaf_count();
            let most = ((leaves - before) as f64 / added) as usize + 1;
            let mut sum = 0.0;
            let marked: Vec<u32> = order
                .into_iter()
                .take(most)
                .take_while(|&leaf| {
                    let more = sum <= MARKED_SHARE * total;
                    sum += bends[leaf as usize];
                    more
                })
                .collect();
            if marked.is_empty() {
                break;
            }
            self.bisect(&marked);
            added = (self.leaf_count() - before) as f64 / marked.len() as f64;
        }
        Ok(())
    }
}

impl Search {
    /// The field scaled to |curl A| <= 1, and its circulation, both with outward rounding.
    fn prove(&self, hull: &Hull, frame: Option<&Frame>) -> Option<Field> {
        let space = Space::within(&self.mesh, hull);
        let mut field = space.field(&self.mesh, BEST);
        if !scale_to_one(&space, &mut field) {
            return None;
        }
        let margin = 0.5 * hull.margin;
        let area_lower_bound = rigorous::least_area(&space, &self.mesh, &field, &self.loops, frame, margin)?.max(0.0);
        let (edge_values, faces) = field.split_at(space.edges.len());
        let (half_spaces, unconstrained) = hull.beyond(&space.corners);
        Some(Field {
            loops: self.loops.clone(),
            area_lower_bound,
            frame: frame.copied(),
            corners: self.mesh.corners(),
            mirrors: self.mesh.mirrors().planes(self.mesh.corners()[0]),
            vertices: self.mesh.vertices.clone(),
            tetrahedra: (0..self.mesh.leaf_count()).map(|leaf| self.mesh.leaf_vertices(leaf)).collect(),
            edge_values: edge_values.to_vec(),
            face_values: faces.chunks_exact(2).map(|pair| [pair[0], pair[1]]).collect(),
            edges: space.edges,
            faces: space.faces,
            half_spaces,
            unconstrained,
        })
    }

    fn slack(&self, film: &Mesh, hull: &Hull, frame: Option<&Frame>) -> Vec<f64> {
        let mut normals = vec![DVec3::ZERO; film.vertices.len()];
        for &triangle in &film.triangles {
            let [a, b, c] = film.corners(triangle);
            let area = (b - a).cross(c - a);
            triangle.iter().for_each(|&v| normals[v as usize] += area);
        }
        let constrained = Space::within(&self.mesh, hull).constrained;
        let curls = constrained.iter().flat_map(|&leaf| self.mesh.nodal[leaf as usize].curl[BEST]);
        let largest = curls.map(DVec3::length).fold(0.0, f64::max);
        let at = |(point, normal): (&DVec3, DVec3)| {
            let point = symmetry::place(frame, *point);
            let normal = frame.map_or(normal, |frame| frame.turn(normal));
            let (leaf, weights) = self.mesh.locate(point);
            let curls = self.mesh.nodal[leaf as usize].curl[BEST];
            let curl: DVec3 = curls.iter().zip(weights).map(|(&curl, weight)| curl * weight).sum();
            let normal = normal.normalize_or_zero() * self.mesh.flips(point);
            let along = if largest > 0.0 { curl.dot(normal).abs() / largest } else { 0.0 };
            (1.0 - along).clamp(0.0, 1.0)
        };
        film.vertices.iter().zip(normals).map(at).collect()
    }
}

/// Scales a field so that interval arithmetic proves |curl A| <= 1; a field without a curl stays.
fn scale_to_one(space: &Space, field: &mut [f64]) -> bool {
    for margin in [1e-14, 1e-13, 1e-11, 1e-8] {
        let largest = rigorous::largest_curl(space, field);
        if largest <= 1.0 && (largest == 0.0 || largest > 1.0 - 1e-9) {
            return true;
        }
        if !largest.is_finite() || largest == 0.0 {
            return largest == 0.0;
        }
        let factor = (1.0 - margin) / largest;
        field.iter_mut().for_each(|value| *value *= factor);
    }
    rigorous::largest_curl(space, field) <= 1.0
}

/// The example of the README is compiled and run with the others.
#[cfg(doctest)]
#[doc = include_str!("../README.md")]
struct Readme;
