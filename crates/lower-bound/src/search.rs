//! The search for the best field of one orientation, on meshes that are refined from level to level. A search in which
//! the directions of some loops are still free can be split into two searches.

use super::bisection::{BEST, BisectionMesh, CENTRAL};
use super::budget::{Budget, FILL_POWERS, MOST_ENTRIES, Size};
use super::conic::Level;
use super::hull::Hull;
use super::orientation::{Oriented, vector_area};
use super::space::Space;
use super::system::{System, error_of};
use glam::DVec4;
use plateau_mesh::sparse::Unsolved;
use plateau_mesh::{DVec3, Error, Execution, Progress};

/// Number of leaves of the first mesh.
const FIRST_LEAVES: usize = 600;
/// Largest number of Newton steps on a mesh.
const MOST_STEPS: u32 = 40;
/// The search continues on a finer mesh when the gap to the mesh's own optimum is at most this multiple of the gap to
/// the film's area. This accuracy suffices to see where the dual surface bends.
const CONVERGED: f64 = 1.0;
/// The same multiple if the budget allows no finer mesh, so that only steps on this mesh can use the rest of the
/// budget.
const CONVERGED_AT_LAST: f64 = 0.03;
/// While directions are free, a mesh is left when the gap to its own optimum is at most this fraction of the bound. The
/// searches for both directions begin with this bound.
const CONVERGED_WHILE_FREE: f64 = 0.1;
/// The leaves marked in one round of refinement contain this fraction of the total bend of the dual surface.
const MARKED_SHARE: f64 = 0.4;

/// Parts of the film, each given by a point in the coordinates of the mesh and the area of the part.
pub(super) type Samples = [(DVec3, f64)];

/// The area of the film in each leaf.
fn film_in_leaves(mesh: &BisectionMesh, film: &Samples) -> Vec<f64> {
    let mut areas = vec![0.0; mesh.leaf_count()];
    for &(point, area) in film {
        areas[mesh.locate(point).0 as usize] += area;
    }
    areas
}

/// Bisects the largest leaves that contain a part of the film, until there are [`FIRST_LEAVES`] leaves.
///
/// # Errors
/// An interruption by the caller.
pub(super) fn refine_first_mesh(mesh: &mut BisectionMesh, film: &Samples, exec: &Execution) -> Result<(), Error> {
    while mesh.leaf_count() < FIRST_LEAVES {
        exec.look(film.len() as u64)?;
        let area = film_in_leaves(mesh, film);
        let can_follow_film = |leaf: &usize| area[*leaf] > 0.0 && mesh.can_bisect(*leaf);
        let levels = (0..mesh.leaf_count()).filter(can_follow_film).map(|leaf| mesh.leaf_level(leaf));
        let Some(least) = levels.min() else { break };
        let marked: Vec<u32> = (0..mesh.leaf_count())
            .filter(|leaf| can_follow_film(leaf) && mesh.leaf_level(*leaf) == least)
            .map(|leaf| leaf as u32)
            .collect();
        mesh.bisect(&marked, exec)?;
    }
    Ok(())
}

/// The search for a bound of one orientation, or of several orientations together.
#[derive(Clone, Debug)]
pub(super) struct Search {
    pub oriented: Oriented,
    pub mesh: BisectionMesh,
    /// The circulation of the best field so far. At first this is a field of constant curl.
    pub bound: f64,
    /// Size of the last linear system. `None` before the first level.
    size: Option<Size>,
    /// Whether the mesh carries an iterate from which the next level can start.
    is_warm: bool,
    /// Whether no further level is possible.
    pub is_finished: bool,
}

impl Search {
    /// Starts from a field of constant curl. If loops are free, starts from the zero field instead, because a field of
    /// constant curl has a circulation around the free loops.
    pub fn new(oriented: Oriented, mut mesh: BisectionMesh) -> Self {
        let mut bound = 0.0;
        if oriented.free.is_empty() {
            let vector_area = vector_area(&oriented.placed);
            mesh.set_constant_curl(vector_area.normalize_or_zero());
            bound = vector_area.length();
        }
        Self { oriented, mesh, bound, size: None, is_warm: false, is_finished: false }
    }

    /// The searches for both directions of the next free loop, which begin with the field of this search. `None` if no
    /// loop is free, if this search has not run yet, or if the budget is too small for both.
    pub fn split(&self, budget: &Budget) -> Option<[Self; 2]> {
        let affords_both = 2.0 * self.size?.price(1) <= budget.left();
        let orientations = self.oriented.clone().split().filter(|_| affords_both)?;
        Some(orientations.map(|oriented| Self { oriented, size: None, is_warm: false, ..self.clone() }))
    }

    /// Runs one level: refines the mesh if the budget allows it, and iterates on the mesh. `storage` is memory that the
    /// factorisations reuse.
    ///
    /// # Errors
    /// An interruption by the caller.
    pub fn run_level(
        &mut self,
        hull: &Hull,
        budget: &mut Budget,
        storage: &mut Vec<f64>,
        exec: &Execution,
    ) -> Result<(), Error> {
        let is_first = self.size.is_none();
        if let Some(size) = self.size
            && let Some(next) = budget.next_leaves(size, self.bound)
        {
            let growth = next / size.leaves;
            self.mesh.refine((self.mesh.leaf_count() as f64 * growth) as usize, exec)?;
        }
        exec.look(self.mesh.leaf_count() as u64)?;
        let mut space = Space::within(&self.mesh, hull);
        if !space.is_a_ball() {
            // On the first mesh the constraint is imposed in all leaves instead. This is possible because the curl of
            // the starting field is constant and at most 1 everywhere.
            self.is_finished = !is_first;
            if self.is_finished {
                return Ok(());
            }
            space = Space::of(&self.mesh);
        }
        let Oriented { placed, free, .. } = &self.oriented;
        let directed = placed.iter().enumerate().filter(|(number, _)| !free.contains(number)).map(|(_, points)| points);
        let form = space.circulation(&self.mesh, directed);
        let held = free.iter().map(|&number| space.circulation(&self.mesh, [&placed[number]])).collect();
        exec.look(self.mesh.leaf_count() as u64)?;
        let mut system = System::of(&space, exec).map_err(error_of)?;
        let size = Size {
            entries: system.factor_entries() as f64,
            rows: system.rows() as f64,
            leaves: space.constrained.len() as f64,
            fill_power: FILL_POWERS[usize::from(self.mesh.mirrors().images() > 1)],
        };
        if !is_first && size.entries > 1.5 * MOST_ENTRIES {
            self.is_finished = true;
            return Ok(());
        }
        budget.spent += size.price(0);
        self.size = Some(size);
        let mut level = Level::new(&space, &self.mesh, &form, held, budget.film_area, self.is_warm);
        let ended = iterate(&mut level, &mut system, size, budget, storage, exec);
        self.is_finished = budget.next_leaves(size, level.best.bound).is_none();
        self.bound = level.best.bound;
        self.is_warm = !level.stalled;
        let currents: Vec<_> = (0..space.constrained.len()).map(|k| level.current(k)).collect();
        let (central, duals) = level.central();
        self.mesh.carry(&space, &[level.best.field, central], &currents, &duals);
        ended
    }
}

/// Makes Newton steps until the optimum is near enough, the budget is spent, or a step fails.
fn iterate(
    level: &mut Level,
    system: &mut System,
    size: Size,
    budget: &mut Budget,
    storage: &mut Vec<f64>,
    exec: &Execution,
) -> Result<(), Error> {
    for _ in 0..MOST_STEPS {
        let missing = budget.missing(level.best.bound);
        let is_last_mesh = budget.next_leaves(size, level.best.bound).is_none();
        let enough = if is_last_mesh { CONVERGED_AT_LAST } else { CONVERGED };
        let missing_here =
            if level.has_free_loops() { CONVERGED_WHILE_FREE * level.best.bound } else { enough * missing };
        let has_converged = level.stalled || level.gap() <= missing_here;
        let is_reached = budget.options.gap * level.best.bound >= missing;
        if has_converged || is_reached || budget.left() < size.step_price() {
            break;
        }
        match level.step(system, storage, exec) {
            Ok(()) => {}
            Err(Unsolved::Interrupted(interruption)) => return Err(interruption.into()),
            // The best field so far still proves its bound.
            Err(Unsolved::Refused(_)) => break,
        }
        budget.spent += size.step_price();
        budget.iterations += 1;
        exec.report(Progress {
            fraction: budget.fraction(),
            phase: "lower_bound",
            iteration: u64::from(budget.iterations),
            objective_value: Some(level.best.bound),
            residual: None,
        });
    }
    Ok(())
}

impl BisectionMesh {
    /// Stores the two fields of `fields` on the mesh. For the constrained leaves, also stores the dual surface
    /// (`currents`) and the dual vectors of the central field (`duals`).
    pub(super) fn carry(
        &mut self,
        space: &Space,
        fields: &[Vec<f64>; 2],
        currents: &[[DVec3; 4]],
        duals: &[[DVec4; 4]],
    ) {
        for (leaf, nodal) in self.nodal.iter_mut().enumerate() {
            nodal.curl = [BEST, CENTRAL].map(|which| space.curl_in(leaf, &fields[which]));
            // The dual surface does not reach leaves that are not constrained.
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

    /// Bisects the leaves in which the dual surface bends most, until there are about as many leaves as asked for.
    fn refine(&mut self, leaves: usize, exec: &Execution) -> Result<(), Error> {
        // Number of leaves that each marked leaf adds. It exceeds 1, because other leaves are bisected with the marked
        // one.
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
            self.bisect(&marked, exec)?;
            added = (self.leaf_count() - before) as f64 / marked.len() as f64;
        }
        Ok(())
    }
}
