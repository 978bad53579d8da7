//! The triangulation of a patch: a grid of parameters that is fine enough for the patch's size and curvature, with
//! seams sewn up and poles merged.

use super::nurbs::{Nurbs, unit_normal};
use plateau_mesh::topology::{NONE, edge_key};
use plateau_mesh::{DVec2, DVec3, Mesh};

/// Constants of the triangulation of a patch.
struct Grid {
    /// Largest side of a cell, in ℓ. Half an edge is short enough to resolve the metric.
    side: f64,
    /// Largest angle between the normals at the ends of a cell's side, radians.
    turn: f64,
    /// Number of samples of the patch along each knot span, at which sides and angles are measured.
    samples: usize,
    /// Largest number of samples along one parameter.
    most_samples: usize,
    /// Range of the largest number of cells. Within this range the largest number is `cells_per_area` for each ℓ² of
    /// the surface. Fewer cells are made if they meet `side` and `turn`.
    cells: (f64, f64),
    cells_per_area: f64,
    /// Least number of cells along a parameter between two creases.
    fewest: usize,
}

const GRID: Grid = Grid {
    side: 0.5,
    turn: 0.2,
    samples: 16,
    most_samples: 640,
    cells: (40_000.0, 500_000.0),
    cells_per_area: 12.0,
    fewest: 4,
};

/// Distance up to which points coincide, as a fraction of the surface's size.
const COINCIDENT: f64 = 1e-9;

/// The parts of a triangulated patch.
pub(super) struct Tessellation {
    pub mesh: Mesh,
    pub parameters: Vec<[DVec2; 3]>,
    /// For each line that may be a crease, its edges. The smaller vertex of each edge comes first.
    pub lines: Vec<Vec<[u32; 2]>>,
    pub corners: Vec<u32>,
}

/// Returns the distinct knots along an axis, mapped to \[0, 1\], and for each whether the patch may have a crease
/// there.
fn distinct_knots(patch: &Nurbs, axis: usize) -> Vec<(f64, bool)> {
    let (knots, degree) = (&patch.knots[axis], patch.degrees[axis]);
    let (low, high) = (knots[degree], knots[knots.len() - degree - 1]);
    let mut distinct: Vec<(f64, usize)> = Vec::new();
    for &knot in knots.iter().filter(|&&knot| knot >= low && knot <= high) {
        match distinct.last_mut() {
            Some((last, count)) if *last == knot => *count += 1,
            _ => distinct.push((knot, 1)),
        }
    }
    distinct.iter().map(|&(knot, count)| ((knot - low) / (high - low), count >= degree)).collect()
}

/// Returns the parameters of the lines of a tensor-product grid, and the indices of the lines that may be creases.
fn lines(patch: &Nurbs) -> ([Vec<f64>; 2], [Vec<usize>; 2]) {
    let spans = [0, 1].map(|axis| distinct_knots(patch, axis));
    let samples: [Vec<f64>; 2] = [0, 1].map(|axis| {
        let count = spans[axis].len() - 1;
        let each = GRID.samples.min(GRID.most_samples / count).max(1);
        let mut all: Vec<f64> = spans[axis]
            .windows(2)
            .flat_map(|pair| (0..each).map(move |k| pair[0].0 + (pair[1].0 - pair[0].0) * k as f64 / each as f64))
            .collect();
        all.push(1.0);
        all
    });
    // Points and derivatives at the samples. Normals follow from them below; a pole has no normal.
    let evaluated: Vec<Vec<[DVec3; 3]>> =
        samples[0].iter().map(|&u| samples[1].iter().map(|&v| patch.evaluate(DVec2::new(u, v))).collect()).collect();
    let largest = [1, 2].map(|k| evaluated.iter().flatten().map(|sample| sample[k].length()).fold(0.0, f64::max));
    let at: Vec<Vec<(DVec3, Option<DVec3>)>> = evaluated
        .iter()
        .map(|row| row.iter().map(|&[p, du, dv]| (p, unit_normal(du, dv, largest))).collect())
        .collect();
    let (nu, nv) = (samples[0].len(), samples[1].len());
    let area: f64 = (1..nu)
        .flat_map(|i| (1..nv).map(move |j| (i, j)))
        .map(|(i, j)| 0.5 * (at[i][j].0 - at[i - 1][j - 1].0).cross(at[i - 1][j].0 - at[i][j - 1].0).length())
        .sum();
    let need = |a: (DVec3, Option<DVec3>), b: (DVec3, Option<DVec3>)| {
        let turn = match (a.1, b.1) {
            (Some(a), Some(b)) => a.distance(b),
            _ => 0.0,
        };
        (a.0.distance(b.0) / GRID.side).max(turn / GRID.turn)
    };
    let along_u = (1..nu).map(|i| (0..nv).map(|j| need(at[i - 1][j], at[i][j])).fold(0.0, f64::max)).collect();
    let along_v = (1..nv).map(|j| (0..nu).map(|i| need(at[i][j - 1], at[i][j])).fold(0.0, f64::max)).collect();
    let needs: [Vec<f64>; 2] = [along_u, along_v];
    let most = (GRID.cells_per_area * area).clamp(GRID.cells.0, GRID.cells.1);
    let wanted: f64 = needs.iter().map(|need| need.iter().sum::<f64>()).product();
    let scale = (most / wanted).sqrt().min(1.0);
    let mut creases: [Vec<usize>; 2] = Default::default();
    let grid = [0, 1].map(|axis| {
        let mut grid = vec![0.0];
        let mut from = 0;
        for &(knot, may_crease) in &spans[axis][1..] {
            if !may_crease && knot < 1.0 {
                continue;
            }
            let to = samples[axis].partition_point(|&t| t < knot);
            let need = &needs[axis][from..to];
            let total = need.iter().sum::<f64>() * scale;
            let fewest = GRID.fewest.min(GRID.most_samples / spans[axis].len()).max(1);
            let count = (total.ceil() as usize).max(fewest);
            // Each cell gets an equal share of the sum of the needs. The need may be zero where the derivatives vanish,
            // hence the small constant.
            let least = 1e-6 * total.max(1e-6) / need.len() as f64;
            let weights: Vec<f64> = need.iter().map(|need| need * scale + least).collect();
            let sum: f64 = weights.iter().sum();
            let (mut passed, mut k) = (0.0, 0);
            for line in 1..count {
                let target = sum * line as f64 / count as f64;
                while k + 1 < weights.len() && passed + weights[k] < target {
                    passed += weights[k];
                    k += 1;
                }
                let (low, high) = (samples[axis][from + k], samples[axis][from + k + 1]);
                grid.push(low + (high - low) * ((target - passed) / weights[k]).clamp(0.0, 1.0));
            }
            grid.push(knot);
            creases[axis].push(grid.len() - 1);
            from = to;
        }
        grid
    });
    (grid, creases)
}

/// Triangulates a patch over a grid, sews up seams and merges poles. Returns `None` if an edge that is not at a pole
/// has no length.
pub(super) fn tessellate(patch: &Nurbs) -> Option<Tessellation> {
    let ([us, vs], creases) = lines(patch);
    let (nu, nv) = (us.len() - 1, vs.len() - 1);
    let points: Vec<DVec3> = us
        .iter()
        .flat_map(|&u| vs.iter().map(move |&v| (u, v)))
        .map(|(u, v)| patch.evaluate(DVec2::new(u, v))[0])
        .collect();
    let index = |i: usize, j: usize| i * (nv + 1) + j;
    let tiny = COINCIDENT * points.iter().map(|p| p.length()).fold(0.0, f64::max);
    let same = |a: (usize, usize), b: (usize, usize)| points[index(a.0, a.1)].distance(points[index(b.0, b.1)]) <= tiny;
    let closed = [(0..=nv).all(|j| same((0, j), (nu, j))), (0..=nu).all(|i| same((i, 0), (i, nv)))];
    // The sides u = 0, u = 1, v = 0, v = 1.
    let pole = [
        (0..=nv).all(|j| same((0, 0), (0, j))),
        (0..=nv).all(|j| same((nu, 0), (nu, j))),
        (0..=nu).all(|i| same((0, 0), (i, 0))),
        (0..=nu).all(|i| same((0, nv), (i, nv))),
    ];
    let representative = |i: usize, j: usize| {
        // Poles come first: the row of a pole is one point, whether or not the patch closes across it.
        let j = if (i == 0 && pole[0]) || (i == nu && pole[1]) { 0 } else { j };
        let i = if (j == 0 && pole[2]) || (j == nv && pole[3]) { 0 } else { i };
        let i = if i == nu && closed[0] && !pole[1] { 0 } else { i };
        let j = if j == nv && closed[1] && !pole[3] { 0 } else { j };
        index(i, j)
    };
    let mut number = vec![NONE; points.len()];
    let mut vertices = Vec::new();
    for i in 0..=nu {
        for j in 0..=nv {
            let k = representative(i, j);
            if number[k] == NONE {
                number[k] = vertices.len() as u32;
                vertices.push(points[k]);
            }
        }
    }
    let vertex = |i: usize, j: usize| number[representative(i, j)];
    let (mut triangles, mut parameters) = (Vec::new(), Vec::new());
    let apart = |a: u32, b: u32| vertices[a as usize].distance(vertices[b as usize]);
    for i in 0..nu {
        for j in 0..nv {
            let corners = [(i, j), (i + 1, j), (i + 1, j + 1), (i, j + 1)];
            let numbers = corners.map(|(i, j)| vertex(i, j));
            let places = corners.map(|(i, j)| DVec2::new(us[i], vs[j]));
            let middle = 0.5 * (places[0] + places[2]);
            // At a pole every parameter along its side gives the same point. A triangle there gets the parameter in the
            // middle of the cell.
            let parameters_at = |(i, j): (usize, usize), place: DVec2| {
                let x = if (j == 0 && pole[2]) || (j == nv && pole[3]) { middle.x } else { place.x };
                let y = if (i == 0 && pole[0]) || (i == nu && pole[1]) { middle.y } else { place.y };
                DVec2::new(x, y)
            };
            // The cell is cut along its shorter diagonal. At a pole only one triangle is left.
            let straight = apart(numbers[0], numbers[2]) <= apart(numbers[1], numbers[3]) * (1.0 + 1e-9);
            let halves = if straight { [[0, 1, 2], [0, 2, 3]] } else { [[0, 1, 3], [1, 2, 3]] };
            for half in halves {
                let triangle = half.map(|k| numbers[k]);
                if triangle[0] == triangle[1] || triangle[1] == triangle[2] || triangle[2] == triangle[0] {
                    continue;
                }
                if (0..3).any(|k| apart(triangle[k], triangle[(k + 1) % 3]) <= tiny) {
                    return None;
                }
                triangles.push(triangle);
                parameters.push(half.map(|k| parameters_at(corners[k], places[k])));
            }
        }
    }
    let mut candidates = Vec::new();
    for &i in &creases[0] {
        candidates.push((0..nv).map(|j| edge_key([vertex(i, j), vertex(i, j + 1)])).collect());
    }
    for &j in &creases[1] {
        candidates.push((0..nu).map(|i| edge_key([vertex(i, j), vertex(i + 1, j)])).collect());
    }
    let corners = vec![vertex(0, 0), vertex(nu, 0), vertex(nu, nv), vertex(0, nv)];
    Some(Tessellation { mesh: Mesh::new(vertices, triangles), parameters, lines: candidates, corners })
}
