//! A solved surface: mesh, statistics and warnings, at the position of the caller's boundaries.

use super::curvature::Curvature;
use super::options::{Constraints, InitialMesh, Objective, Options, Resolution};
use super::request::Input;
use super::run::meets_its_rule;
use super::solved_film::SolvedFilm;
use super::statistics::{self, Facts, Origin, Statistics};
use super::touching_boundaries::{JoinedLoops, own_boundaries};
use plateau_equilibrium::stability::stability_warnings;
use plateau_mesh::codes::{Reason, WarningCode};
use plateau_mesh::error::Warning;
use plateau_mesh::film::Film;
use plateau_mesh::measure::Quality;
use plateau_mesh::polyline::position_key;
use plateau_mesh::{DVec3, Error, Mesh};

/// Largest relative difference between the requested and the actual resolution that gives no warning.
const RESOLUTION_TOLERANCE: f64 = 0.1;

/// The mesh vertices at the points of [`Constraints`], in the order of these points. Points that the solver added on
/// curves are not listed.
#[derive(Clone, Debug, Default, PartialEq, Eq)]
pub struct ConstraintVertices {
    /// The vertex of each fixed point.
    pub points: Vec<u32>,
    /// The vertex of each point of each fixed curve.
    pub polylines: Vec<Vec<u32>>,
}

/// A mesh that spans the boundaries, with its measurements and warnings.
#[derive(Clone, Debug, PartialEq)]
#[non_exhaustive]
pub struct MinimalSurface {
    /// The mesh. Its vertices are in this order: first the input points at exactly the given coordinates, boundary by
    /// boundary, with one vertex for equal neighbours; then points added on the boundaries; then the interior.
    pub mesh: Mesh,
    /// Each boundary as a loop of mesh vertices, in the direction of the input, with the added points. Where boundaries
    /// touch, each has a vertex of its own at the same place, and an edge of a loop may begin or end at the vertex of
    /// the other boundary.
    pub boundaries: Vec<Vec<u32>>,
    /// The vertex of each input point, boundary by boundary.
    pub input_vertices: Vec<Vec<u32>>,
    /// The vertex of each fixed point, and of each point of each fixed curve.
    pub constraints: ConstraintVertices,
    /// Mean curvature of each vertex: |area gradient| / (2/3 of the area of the triangles around the vertex), in
    /// 1/unit; 0 where the vertex is fixed.
    pub mean_curvature: Vec<f64>,
    /// The lowest mode of an unstable surface: a displacement of each vertex along the normal, scaled so that the
    /// largest has length 1. Moving along it in either direction lowers the area.
    /// 1. Moving along it in either direction lowers the area.
    pub unstable_mode: Option<Vec<DVec3>>,
    /// Figures of the surface and of the run.
    pub statistics: Statistics,
    /// Warnings about a solve that succeeded.
    pub warnings: Vec<Warning>,
}

/// A stable film counts as near its limit if its margin is below this. Between two rings of any radii the margin
/// reaches this value at 0.99 of the largest distance.
const NEAR_CRITICAL: f64 = 0.2;

/// Returns the warning that a stable film is near its limit, because it may not exist after a small change of the
/// boundary.
fn near_critical(statistics: &Statistics) -> Option<Warning> {
    let margin = statistics.stability?.margin.filter(|&margin| margin < NEAR_CRITICAL)?;
    let detail = format!(
        "the film is near its limit (margin {margin:.3}, where a flat film has 1 and a film that is about to collapse \
         0): with a slightly different boundary or a finer mesh it may collapse"
    );
    Some(Warning::new(WarningCode::NearCritical, detail).with("margin", margin))
}

/// Returns a warning if the solver met its own rule, but the residual of the film exceeds the tolerance by more than
/// rounding. Only films of least area are checked, because the other objectives do not lead to a minimal surface.
fn not_minimal(statistics: &Statistics, measured: &Curvature, tolerance: f64) -> Option<Warning> {
    let Statistics { objective, solver, stop_reason, residual, .. } = *statistics;
    let rule_met = meets_its_rule(solver, stop_reason, measured.residual_felt, tolerance);
    let is_missed = measured.residual_beyond_rounding > tolerance;
    (objective == Objective::MinimalArea && rule_met && is_missed).then(|| {
        let detail = format!(
            "the solver stopped by its own rule ({}) with a residual of {residual:.3e}, above the tolerance \
             {tolerance:.3e}: a smaller area_tolerance, or the solver auto, comes nearer to a minimal surface",
            stop_reason.name()
        );
        Warning::new(WarningCode::NotMinimal, detail).with("residual", residual).with("tolerance", tolerance)
    })
}

/// Returns a warning if a neck needed a finer mesh than was asked for.
fn refined(statistics: &Statistics, options: &Options) -> Option<Warning> {
    let Statistics { triangles, quality: Quality { edge_lengths, .. }, .. } = statistics;
    let asked = match options.resolution {
        Resolution::Triangles(count) => format!("{count} triangles were asked for"),
        Resolution::EdgeLength(length) => format!("edges of the length {length:.4e} were asked for"),
        Resolution::InteriorVertices(count) => format!("{count} interior vertices were asked for"),
    };
    statistics.refined.then(|| {
        let detail = format!(
            "the film bends so strongly at a neck that a coarse mesh does not show whether it exists: {asked}, and \
             with a finer mesh there it has {triangles} triangles and edges of the mean length {:.4e}",
            edge_lengths.mean
        );
        Warning::new(WarningCode::Refined, detail).with_count("triangles", *triangles)
    })
}

/// Returns a warning if the mean edge length differs from the requested edge length.
fn missed_edge_length(statistics: &Statistics, options: &Options) -> Option<Warning> {
    let Resolution::EdgeLength(length) = options.resolution else { return None };
    let mean = statistics.quality.edge_lengths.mean;
    let missed =
        (mean / length - 1.0).abs() > RESOLUTION_TOLERANCE && !matches!(options.initial_mesh, InitialMesh::Given(_));
    missed.then(|| {
        let why = if mean < length {
            "the boundary's own points are closer, or the film shrank on the way"
        } else {
            "the boundary's own segments are longer and must be kept, or the film grew on the way"
        };
        let detail = format!(
            "the mean edge is {mean:.4e} long, not {length:.4e}: {why}; ask for a number of triangles to be sure of it"
        );
        Warning::new(WarningCode::EdgeLengthMissed, detail).with("mean_edge_length", mean).with("edge_length", length)
    })
}

/// Returns a warning if the mesh has far fewer or far more triangles than were asked for.
fn missed_triangles(statistics: &Statistics, options: &Options) -> Option<Warning> {
    let Resolution::Triangles(count) = options.resolution else { return None };
    let triangles = statistics.triangles;
    let missed = (triangles as f64 / count as f64 - 1.0).abs() > RESOLUTION_TOLERANCE
        && !matches!(options.initial_mesh, InitialMesh::Given(_));
    missed.then(|| {
        let detail = format!(
            "the mesh has {triangles} triangles, not {count}: the boundary's own points ask for more, or thin \
             triangles were removed on the way"
        );
        let warning = Warning::new(WarningCode::TrianglesMissed, detail);
        warning.with_count("triangles", triangles).with_count("asked", count)
    })
}

/// Returns the fixed vertices, sorted by the bits of their (centred) coordinates.
fn fixed_places(film: &Film) -> Vec<([u64; 3], u32)> {
    let mut places: Vec<([u64; 3], u32)> = (0..film.vertices.len() as u32)
        .filter(|&v| film.fixed[v as usize])
        .map(|v| (position_key(film.vertices[v as usize]), v))
        .collect();
    places.sort_unstable();
    places
}

/// Sets the vertices of the constraints to exactly the given coordinates, and returns their numbers.
fn restore(mesh: &mut Mesh, fixed: &[([u64; 3], u32)], constraints: &Constraints, centre: DVec3) -> ConstraintVertices {
    let mut vertex = |&point: &DVec3| {
        let key = position_key(point - centre);
        let found = fixed.get(fixed.partition_point(|&(bits, _)| bits < key)).filter(|&&(bits, _)| bits == key);
        let &(_, vertex) = found?;
        mesh.vertices[vertex as usize] = point;
        Some(vertex)
    };
    ConstraintVertices {
        points: constraints.points.iter().filter_map(&mut vertex).collect(),
        polylines: constraints
            .polylines
            .iter()
            .map(|polyline| polyline.iter().filter_map(&mut vertex).collect())
            .collect(),
    }
}

/// A fixed point counts as holding the film if the pull of the film on the point exceeds this fraction of the largest
/// possible pull, which the triangles at the point would exert if all of them pulled in the same direction. If the film
/// passes smoothly through the point, the fraction is only about the film's curvature times the edge length.
const HOLDS: f64 = 0.1;

/// Returns the warning that single points hold the film. A smooth film would reach such a point by a thread of no area,
/// so the shape of the mesh around the point depends on the edge length.
fn held_points(mesh: &Mesh, points: &[u32]) -> Option<Warning> {
    if points.is_empty() {
        return None;
    }
    let mut places: Vec<u32> = points.to_vec();
    places.sort_unstable();
    places.dedup();
    let mut pulls = vec![(DVec3::ZERO, 0.0); places.len()];
    for &triangle in &mesh.triangles {
        for k in 0..3 {
            let Ok(place) = places.binary_search(&triangle[k]) else { continue };
            let corners = [triangle[k], triangle[(k + 1) % 3], triangle[(k + 2) % 3]];
            let [here, from, to] = corners.map(|v| mesh.vertices[v as usize]);
            let edge = to - from;
            let normal = edge.cross(here - from).normalize_or_zero();
            pulls[place].0 += normal.cross(edge);
            pulls[place].1 += edge.length();
        }
    }
    let count = pulls.iter().filter(|(pull, edges)| pull.length() > HOLDS * edges).count();
    let detail = format!(
        "{count} fixed points hold the film, but the area of a thread is zero: what the mesh shows around them shrinks \
         as the mesh gets finer. Give a small closed curve in place of a point that carries the film"
    );
    (count > 0).then(|| Warning::new(WarningCode::HeldPoints, detail).with_count("count", count))
}

/// Returns the warnings that follow from the figures of the film and of the run.
fn of_statistics(statistics: &Statistics, measured: &Curvature, options: &Options) -> Vec<Warning> {
    let mut warnings = Vec::new();
    if !statistics.pinches.is_empty() {
        let detail = format!(
            "the film came apart at {} places; its topology is not the initial mesh's",
            statistics.pinches.len()
        );
        warnings
            .push(Warning::new(WarningCode::TopologyChanged, detail).with_count("pinches", statistics.pinches.len()));
    }
    if let Some(spanning) = &statistics.spanning {
        warnings.extend(spanning.warnings());
    }
    match refined(statistics, options) {
        Some(warning) => warnings.push(warning),
        None => {
            warnings.extend(missed_edge_length(statistics, options));
            warnings.extend(missed_triangles(statistics, options));
        }
    }
    if !statistics.converged {
        warnings.push(statistics.not_converged(measured.residual_felt, options));
    }
    warnings.extend(not_minimal(statistics, measured, options.tolerance));
    if let Some(stability) = statistics.stability {
        warnings.extend(stability_warnings(stability.morse_index, stability.least_index, |index| {
            format!("the surface is stationary but no minimum ({index}): ask for on_unstable descend to leave it")
        }));
    }
    warnings.extend(near_critical(statistics));
    warnings
}

/// Moves the mesh back to the position of the input, brings its vertices into the documented order, and measures it.
pub(super) fn finish(
    input: Input,
    SolvedFilm { film, kind, initial_area, mut run, .. }: SolvedFilm,
    joined: Option<&JoinedLoops>,
    options: &Options,
) -> Result<MinimalSurface, Error> {
    run.pinches.iter_mut().for_each(|pinch| pinch.place += input.centre);
    let mut unstable_mode = run.unstable_mode.take();
    let film = match film.boundary_first(input.point_count()) {
        None => film,
        Some(place) => {
            unstable_mode = unstable_mode.map(|direction| {
                let mut moved = vec![DVec3::ZERO; direction.len()];
                direction.iter().zip(&place).for_each(|(&direction, &v)| moved[v as usize] = direction);
                moved
            });
            film.renumbered(&place)
        }
    };
    let topology = film.mesh().check().map_err(|defect| {
        Error::no_result(Reason::InvalidMesh, format!("the solver left a mesh that is no oriented manifold ({defect})"))
    })?;
    // The statistics are measured before the boundary points are set to the given coordinates. They hold for the
    // returned mesh only if every boundary point is already at its place.
    if let Some(k) = input.centred.iter().flatten().zip(&film.vertices).position(|(point, vertex)| point != vertex) {
        return Err(Error::no_result(Reason::InvalidMesh, format!("the solver moved boundary point {k} of the input")));
    }
    let measured = Curvature::of(&film);
    let rule_met = meets_its_rule(run.solver, run.stop_reason, measured.residual_felt, options.tolerance);
    let facts = Facts::of_film(&film, &topology, &measured);
    let statistics = statistics::collect(facts, rule_met, Origin { kind, initial_area, run }, options);
    let mut warnings = input.warnings();
    warnings.extend(of_statistics(&statistics, &measured, options));
    // Where joined boundaries touch, a loop of the film passes from one boundary to the other.
    let boundaries = match joined {
        Some(_) => own_boundaries(&film, &input.centred)?,
        None => film.boundaries.clone(),
    };
    let fixed = fixed_places(&film);
    let mut mesh = film.into_mesh();
    let centred = joined.map(|_| mesh.vertices.clone());
    for vertex in &mut mesh.vertices {
        *vertex += input.centre;
    }
    for (vertex, &point) in mesh.vertices.iter_mut().zip(input.given.iter().flatten()) {
        *vertex = point;
    }
    if let (Some(joined), Some(centred)) = (joined, &centred) {
        joined.place_added(&mut mesh, centred);
    }
    let constraints = restore(&mut mesh, &fixed, &options.constraints, input.centre);
    warnings.extend(held_points(&mesh, &constraints.points));
    Ok(MinimalSurface {
        mesh,
        boundaries,
        input_vertices: input.vertices,
        constraints,
        mean_curvature: measured.mean_curvature,
        unstable_mode,
        statistics,
        warnings,
    })
}
