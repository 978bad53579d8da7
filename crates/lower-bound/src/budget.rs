//! The budget of a search, in nominal seconds that stand for an amount of work, and the sizes of the meshes that it
//! affords.

use super::options::Options;

/// Largest growth of the number of leaves from one mesh to the next.
pub(super) const GROWTH: f64 = 2.5;
/// Largest growth of the number of leaves over several meshes that is planned ahead.
const MOST_GROWTH: f64 = 100.0;
/// Least growth for which a finer mesh is made. A smaller growth gains less than further steps on the present mesh.
const LEAST_GROWTH: f64 = 1.15;
/// Least number of Newton steps on the finest mesh, if it has at most [`FEW_LEAVES`] leaves and the bound is half a
/// percent below the film's area. With fewer steps its bound would stay below that of the mesh before. Each halving of
/// the distance to the film's area adds a step. Each doubling of the leaves adds a step too, because a large mesh
/// starts farther from its optimum.
pub(super) const STEPS: f64 = 6.0;
pub(super) const FEW_LEAVES: f64 = 1e4;
/// Number of steps that are planned on a mesh that is not the finest.
pub(super) const STEPS_BETWEEN: u32 = 4;
/// Largest number of steps that are planned on the finest mesh.
const MOST_STEPS_AHEAD: f64 = 24.0;
/// Largest number of constrained tetrahedra of a mesh, and of entries of its factor. They limit the memory to 1.2 GB.
const MOST_LEAVES: f64 = 60e3;
pub(super) const MOST_ENTRIES: f64 = 60e6;
/// Nominal seconds of a factorisation, per (entries of the factor)² / rows, and of its preparation per leaf. The rates
/// are fitted to the processor time on meshes of 600 to 60,000 leaves, on one core while the other one was idle.
const FACTORISATION_RATE: f64 = 1.25e-10;
const PREPARATION_RATE: f64 = 2e-5;
/// Nominal seconds of a step besides the factorisation, per entry of the factor and per leaf, fitted to the same runs.
const SOLVE_RATE: f64 = 8e-9;
const ASSEMBLY_RATE: f64 = 6.5e-6;

/// Exponents of the growth of the factor's entries with the number of leaves, without and with planes of symmetry.
/// Between the last two meshes of 10 s they were 1.2 to 1.3 and 1.3 to 1.5. If the exponent is too small, the last mesh
/// is too fine and its steps end before its optimum: with 1.3 in place of 1.5 the gaps of symmetrical boundaries after
/// 10 s were larger by a tenth on average, and by half at most.
pub(super) const FILL_POWERS: [f64; 2] = [1.3, 1.5];

/// Size of the linear system of a mesh.
#[derive(Clone, Copy, Debug)]
pub(super) struct Size {
    /// Entries of the factor.
    pub entries: f64,
    pub rows: f64,
    /// Constrained leaves.
    pub leaves: f64,
    /// The exponent of the mesh, from [`FILL_POWERS`].
    pub fill_power: f64,
}

impl Size {
    /// The expected size of a mesh with `growth` times as many leaves.
    pub fn grown(self, growth: f64) -> Self {
        let Self { entries, rows, leaves, fill_power } = self;
        Self {
            entries: entries * libm::pow(growth, fill_power),
            rows: rows * growth,
            leaves: leaves * growth,
            fill_power,
        }
    }

    /// The cost of the preparation of a mesh and of a number of steps on it, in nominal seconds.
    pub fn price(self, steps: u32) -> f64 {
        PREPARATION_RATE * self.leaves + f64::from(steps) * self.step_price()
    }

    /// The cost of a step, in nominal seconds.
    pub fn step_price(self) -> f64 {
        let Self { entries, rows, leaves, .. } = self;
        FACTORISATION_RATE * entries * entries / rows + SOLVE_RATE * entries + ASSEMBLY_RATE * leaves
    }
}

/// The budget of all searches, and the area that they try to reach.
#[derive(Debug)]
pub(super) struct Budget<'a> {
    pub options: &'a Options,
    /// Area of the film. A bound exceeds it by rounding at most.
    pub film_area: f64,
    /// The budget spent so far, in nominal seconds.
    pub spent: f64,
    /// Number of Newton steps made so far.
    pub iterations: u32,
}

impl<'a> Budget<'a> {
    pub fn new(options: &'a Options, film_area: f64) -> Self {
        Self { options, film_area, spent: 0.0, iterations: 0 }
    }

    /// Whether a bound is as near to the film's area as the options ask for.
    pub fn is_reached_by(&self, bound: f64) -> bool {
        bound * (1.0 + self.options.gap) >= self.film_area
    }

    /// The film's area minus a bound, or zero if this is negative.
    pub fn missing(&self, bound: f64) -> f64 {
        (self.film_area - bound).max(0.0)
    }

    /// The rest of the budget, in nominal seconds.
    pub fn left(&self) -> f64 {
        self.options.budget_s() - self.spent
    }

    /// Part of the budget that was spent, 0 to 1.
    pub fn fraction(&self) -> f64 {
        (self.spent / self.options.budget_s()).min(1.0)
    }

    /// Returns the number of constrained leaves of the next mesh, or `None` if the rest of the budget affords no finer
    /// mesh. `size` and `bound` are those of the present mesh.
    ///
    /// The finest affordable mesh is found first, together with the intermediate meshes. The next mesh is the first of
    /// these. The budget therefore does not end with a remainder that is too small for one more mesh.
    pub fn next_leaves(&self, size: Size, bound: f64) -> Option<f64> {
        let missing = (1.0 - bound / self.film_area).max(f64::MIN_POSITIVE);
        let steps = |leaves: f64| {
            let more = libm::log2(0.005 / missing).ceil().max(0.0) + libm::log2(leaves / FEW_LEAVES).ceil().max(0.0);
            (STEPS + more).min(MOST_STEPS_AHEAD) as u32
        };
        // The growth is divided evenly among as few meshes as possible such that none grows by more than GROWTH.
        let meshes = |growth: f64| (libm::log(growth) / libm::log(GROWTH)).ceil().max(1.0);
        let is_affordable = |growth: f64| {
            let meshes = meshes(growth);
            let between = |k: u32| size.grown(libm::pow(growth, f64::from(k) / meshes)).price(STEPS_BETWEEN);
            let finest = size.grown(growth);
            finest.leaves <= MOST_LEAVES
                && finest.entries <= MOST_ENTRIES
                && (1..meshes as u32).map(between).sum::<f64>() + finest.price(steps(finest.leaves)) <= self.left()
        };
        let mut growth = MOST_GROWTH;
        // Ends because the growth falls by 3 % in each pass.
        while growth >= LEAST_GROWTH {
            if is_affordable(growth) {
                return Some((size.leaves * libm::pow(growth, 1.0 / meshes(growth))).floor());
            }
            growth *= 0.97;
        }
        None
    }
}
