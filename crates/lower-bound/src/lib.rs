//! Proves a lower bound of the area of *all* oriented surfaces with a given boundary, by duality: see [`certify`].
//!
//! ```
//! use plateau_lower_bound::{Options, certify};
//! use plateau_mesh::{DVec3, Execution, Mesh};
//!
//! // A unit square and its flat film.
//! let square = [(0.0, 0.0), (1.0, 0.0), (1.0, 1.0), (0.0, 1.0)].map(|(x, y)| DVec3::new(x, y, 0.0)).to_vec();
//! let film = Mesh::new(square.clone(), vec![[0, 1, 2], [0, 2, 3]]);
//! let options = Options::default().with_gap(0.01).with_seconds(0.2);
//! let bound = certify(&[square], &film, &options, &Execution::default())?.expect("a bound");
//! assert!(bound.area <= 1.0 && bound.area > 0.98);
//! # Ok::<(), plateau_mesh::Error>(())
//! ```
//!
//! # The theorem
//! Let Γ be closed polygons in a convex set H inside a box, and A a field on the box with |curl A| <= 1 in H. Then
//! every oriented surface S with boundary Γ has an area of at least ∮_Γ A·dl. For a surface inside H this follows from
//! Stokes' theorem: ∮_Γ A = ∫_S curl A·n <= area(S). A surface that leaves H cannot have less area, because the
//! nearest-point projection onto a convex set increases no length: it maps S to a surface in H with the same boundary
//! and no more area. The topology of S does not matter; "surface" may be read as integral current. The theorem does not
//! cover surfaces without an orientation (a Möbius film) and films with triple junctions. H is an intersection of
//! half-spaces (`hull`). |curl A| <= 1 is imposed in all tetrahedra except those that lie wholly outside one of the
//! half-spaces and farther from its plane than a small margin.
//!
//! A is piecewise polynomial with continuous tangential components (`element`). Mollification turns it into a smooth
//! field. The curl of this smooth field is an average of values of norm at most 1. Its integral along Γ tends to that
//! of A, because only the tangential component can matter where Γ runs inside a face or an edge. Stokes' theorem
//! therefore applies.
//!
//! # The computation
//! Every A gives a bound. The largest bound is the solution of a convex problem, which is dual to the problem of least
//! area. A call of [`certify`] takes these steps:
//!
//! 1. If the boundary has planes of symmetry, A is needed only on one side of each plane, and the box ends there
//!    (`symmetry`).
//! 2. The box is cut into tetrahedra by bisection (`bisection`), which are smaller near the film. Tetrahedra outside
//!    the convex set are left unconstrained (`hull`).
//! 3. A maximises ∮A under |curl A| <= 1 (`conic`). The multipliers of the constraint are the dual surface, and the
//!    mesh is refined where that surface bends inside a tetrahedron (`search`). Meshes are nested: each mesh starts
//!    with the best field of the mesh before and with an iterate near the central path. The systems are factorised in
//!    an order of nested dissection (`dissection`). The budget determines the sizes of the meshes (`budget`).
//! 4. At the end |curl A| and ∮A are computed with outward rounding (`proof`, `rigorous`), so that the bound is a
//!    theorem about the given polygons in f64.
//!
//! # Work instead of time
//! This crate uses no clock. The budget in seconds is converted to an amount of work by fixed rates. The same build
//! therefore gives the same bytes for the same arguments on processors with the same vector instructions. On other
//! processors the kernels of faer, which factorise the systems, round differently. The result is proven in any case. A
//! deadline of the caller only stops the search earlier.

#![forbid(unsafe_code)]
#![cfg_attr(test, allow(clippy::disallowed_methods, clippy::disallowed_types, clippy::disallowed_macros))]

mod bisection;
mod bound;
mod budget;
mod conic;
mod dissection;
mod element;
mod hull;
mod interval;
mod options;
mod orientation;
mod proof;
mod rigorous;
mod search;
mod space;
mod symmetry;
mod system;
#[cfg(test)]
mod tests;

pub use bound::{Field, LowerBound};
pub use options::{MOST_SECONDS, Options, check, memory_bytes};
pub use symmetry::{Axes, Mirror};

use bisection::BisectionMesh;
use budget::Budget;
use hull::Hull;
use options::{MOST_DIRECTED, MOST_SEARCHES};
use orientation::{Oriented, own_orientation, vector_area};
use plateau_mesh::execution::Interruption;
use plateau_mesh::{DVec3, Error, Execution, Mesh};
use search::{Samples, Search, refine_first_mesh};

/// Proves a lower bound of the area of every oriented surface bounded by the loops. `film` is a surface that the loops
/// bound; it shows where the bound should be sharp.
///
/// With several loops the bound is the least over all their orientations. Returns `None` in three cases: the
/// coordinates are so large compared with the size of the loops that f64 has no digits left for the mesh, the film has
/// no area, or its border does not run along the loops.
///
/// # Errors
/// The [`Error::Input`] of [`check`], and [`Error::Interrupted`] if the caller cancels. A deadline ends the search with
/// the bound that is proven so far.
pub fn certify(
    loops: &[Vec<DVec3>],
    film: &Mesh,
    options: &Options,
    exec: &Execution,
) -> Result<Option<LowerBound>, Error> {
    check(loops, film, options)?;
    let axes = Axes::of(loops, exec)?;
    let place = |p: DVec3| symmetry::place(axes.as_ref(), p);
    let sample = |&triangle: &[u32; 3]| {
        let [a, b, c] = film.corners(triangle);
        (place((a + b + c) / 3.0), 0.5 * (b - a).cross(c - a).length())
    };
    let samples: Vec<(DVec3, f64)> = film.triangles.iter().map(sample).collect();
    let film_area: f64 = samples.iter().map(|(_, area)| area).sum();
    if !(film_area.is_finite() && film_area > 0.0) {
        return Ok(None);
    }
    let Some(own) = own_orientation(loops, film) else { return Ok(None) };
    let middle = place(symmetry::middle(loops));
    let orientations = match loops.len() {
        ..=MOST_DIRECTED => Oriented::all(loops, &own, &place, middle),
        _ => vec![Oriented::open(loops, &own, &place, middle)],
    };
    let Some((mut meshes, mesh_of)) = boxes(&orientations) else { return Ok(None) };
    let images: Vec<Vec<DVec3>> = meshes.iter().flat_map(|mesh| mesh.images(&orientations[0].placed)).collect();
    let normals: Vec<DVec3> = images.iter().map(|points| vector_area(std::slice::from_ref(points))).collect();
    let hull = Hull::around(&images, &normals, exec)?;
    for mesh in &mut meshes {
        refine_first_mesh(mesh, &samples as &Samples, exec)?;
    }
    let mut searches: Vec<Search> =
        orientations.into_iter().zip(mesh_of).map(|(oriented, k)| Search::new(oriented, meshes[k].clone())).collect();
    let mut budget = Budget::new(options, film_area);
    let interrupted = raise_the_least_bound(&mut searches, &hull, &mut budget, exec)?;
    let prove = |search: &Search| proof::prove(&search.mesh, &search.oriented, &hull, axes.as_ref());
    let Some(fields) = searches.iter().map(prove).collect::<Option<Vec<Field>>>() else { return Ok(None) };
    let (weakest, area) = fields
        .iter()
        .enumerate()
        .map(|(k, field)| (k, field.area_lower_bound))
        .fold((0, f64::INFINITY), |least, this| if this.1 < least.1 { this } else { least });
    Ok(Some(LowerBound {
        area,
        fields,
        iterations: budget.iterations,
        seconds: budget.spent,
        interrupted,
        slack: proof::slack(&searches[weakest].mesh, film, &hull, axes.as_ref()),
    }))
}

/// Returns the first meshes, and for each orientation the number of its mesh. Orientations with the same symmetries
/// share a mesh. `None` if f64 has no digits left for a mesh.
fn boxes(orientations: &[Oriented]) -> Option<(Vec<BisectionMesh>, Vec<usize>)> {
    let mut meshes: Vec<BisectionMesh> = Vec::new();
    let mut mesh_of: Vec<usize> = Vec::with_capacity(orientations.len());
    for oriented in orientations {
        let known = meshes.iter().position(|mesh| *mesh.mirrors() == oriented.mirrors);
        mesh_of.push(known.unwrap_or(meshes.len()));
        if known.is_none() {
            let points = oriented.placed.iter().flatten().copied();
            let mesh = BisectionMesh::around(points, oriented.mirrors).ok()?;
            if !(mesh.volume().is_finite() && mesh.volume() > 0.0) {
                return None;
            }
            meshes.push(mesh);
        }
    }
    Some((meshes, mesh_of))
}

/// Repeatedly continues the search with the least bound, because the least bound is the result, until the budget is
/// spent or the gap is reached. A search with free loops is split into the two directions of its next free loop.
/// Returns whether a deadline ended the work.
fn raise_the_least_bound(
    searches: &mut Vec<Search>,
    hull: &Hull,
    budget: &mut Budget,
    exec: &Execution,
) -> Result<bool, Error> {
    let mut storage = Vec::new();
    while let Some(number) = (0..searches.len()).min_by(|&a, &b| searches[a].bound.total_cmp(&searches[b].bound)) {
        if budget.is_reached_by(searches[number].bound) {
            break;
        }
        if searches.len() < MOST_SEARCHES
            && let Some([own, other]) = searches[number].split(budget)
        {
            searches[number] = own;
            searches.push(other);
            continue;
        }
        if searches[number].is_finished {
            break;
        }
        match searches[number].run_level(hull, budget, &mut storage, exec) {
            Ok(()) => {}
            Err(Error::Interrupted(Interruption::DeadlinePassed)) => return Ok(true),
            Err(error) => return Err(error),
        }
    }
    Ok(false)
}

/// Compiles and runs the example of the README with the other documentation tests.
#[cfg(doctest)]
#[doc = include_str!("../README.md")]
struct Readme;
