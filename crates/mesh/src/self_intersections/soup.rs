//! A mesh prepared for the search for self-intersections: its triangles as a list without connectivity, scaled, with
//! points of equal coordinates merged.

use super::predicates::plane_axes;
use crate::measure::power_of_two_above;
use crate::{DVec3, Execution, Interruption};

/// Number of triangles, vertices or pairs that are processed between two checks for a cancellation or deadline.
/// Processing them takes a few milliseconds at most.
pub(super) const LOOK: usize = 1 << 14;
/// Marks the absence of a vertex, triangle or label.
pub(super) const NONE: u32 = u32::MAX;
/// A triangle counts as facing a vertex normal if the cosine between the two normals, times the sine of the triangle's
/// angle at the vertex, exceeds this. Values near rounding (1e-15) are not safe.
const FACING: f64 = 1e-7;
/// Two edges at a vertex count as apart if the sine of the angle between them exceeds this.
const APART: f64 = 1e-11;
/// An edge in line with a ray counts as opposite to the ray if the cosine between them is below minus this. The edge is
/// then within the angle [`APART`] / [`OPPOSITE`] of the exact opposite direction. That angle must be well below
/// [`FACING`], the smallest angle of a triangle that counts as facing.
const OPPOSITE: f64 = 1e-3;
/// Placeholder normal of a triangle that has an area, but whose normal rounding makes uncertain. The vector is so short
/// that the triangle faces no direction.
const NO_NORMAL: DVec3 = DVec3::splat(f64::MIN_POSITIVE);

/// Triangles over points, without connectivity.
pub(super) struct Soup {
    /// The vertices, scaled by a power of two so that the largest coordinate is about 1. The scaling is exact, and no
    /// product of coordinates overflows or underflows.
    pub points: Vec<DVec3>,
    /// Factor that turns the scaled points back into the vertices.
    pub unit: f64,
    /// Corners of each triangle. Vertices with equal coordinates are replaced by the one with the lowest number.
    pub triangles: Vec<[u32; 3]>,
    /// Twice the area vector of each triangle, with a relative error below 1e-3. Exactly zero for a triangle without
    /// area, and [`NO_NORMAL`] for a triangle so thin that rounding makes its normal uncertain.
    pub normals: Vec<DVec3>,
}

impl Soup {
    pub fn new(vertices: &[DVec3], triangles: &[[u32; 3]], exec: &Execution<'_>) -> Result<Self, Interruption> {
        let largest = vertices.iter().fold(0.0f64, |largest, v| largest.max(v.abs().max_element()));
        let unit = power_of_two_above(largest);
        // Adding zero turns -0 into 0, so that equal coordinates have equal bits.
        let points: Vec<DVec3> = vertices.iter().map(|&v| v * unit.recip() + DVec3::ZERO).collect();
        let representative = representatives(&points, exec)?;
        let mut soup = Self { points, unit, triangles: Vec::new(), normals: Vec::new() };
        soup.triangles.reserve_exact(triangles.len());
        soup.normals.reserve_exact(triangles.len());
        for chunk in triangles.chunks(LOOK) {
            for triangle in chunk {
                let triangle = triangle.map(|v| representative[v as usize]);
                let corners = soup.corners(triangle);
                soup.triangles.push(triangle);
                soup.normals.push(
                    clear_normal(&corners)
                        .unwrap_or_else(|| if plane_axes(&corners).is_some() { NO_NORMAL } else { DVec3::ZERO }),
                );
            }
            exec.look(chunk.len() as u64)?;
        }
        Ok(soup)
    }

    /// The corners of a triangle.
    pub fn corners(&self, triangle: [u32; 3]) -> [DVec3; 3] {
        triangle.map(|v| self.points[v as usize])
    }

    /// For each vertex, the number of its triangles in the list if no two of these triangles can intersect, and zero if
    /// that is not certain. They cannot intersect if they form one fan, all face the sum of their normals, and the fan,
    /// seen along that sum, goes round the vertex at most once. Every triangle of the list must have an area.
    pub fn embedded_stars(&self, list: &[u32], exec: &Execution<'_>) -> Result<Vec<u32>, Interruption> {
        let mut start = vec![0u32; self.points.len() + 1];
        for &triangle in list {
            for v in self.triangles[triangle as usize] {
                start[v as usize + 1] += 1;
            }
        }
        exec.look(list.len() as u64)?;
        for v in 0..self.points.len() {
            start[v + 1] += start[v];
        }
        let mut incident = vec![0u32; start[self.points.len()] as usize];
        let mut cursor = start.clone();
        for &triangle in list {
            for (k, v) in self.triangles[triangle as usize].into_iter().enumerate() {
                let slot = &mut cursor[v as usize];
                incident[*slot as usize] = 3 * triangle + k as u32;
                *slot += 1;
            }
        }
        exec.look(list.len() as u64)?;
        let mut stars = vec![0; self.points.len()];
        let mut scratch = [Vec::new(), Vec::new()];
        let mut work = 0;
        for v in 0..self.points.len() {
            let corners = &incident[start[v] as usize..start[v + 1] as usize];
            if self.is_embedded(v, corners, &mut scratch) {
                stars[v] = corners.len() as u32;
            }
            work += 1 + corners.len();
            if work >= LOOK {
                exec.look(work as u64)?;
                work = 0;
            }
        }
        Ok(stars)
    }

    /// The triangles that have an area, in order.
    pub fn with_area(&self) -> Vec<u32> {
        (0..self.triangles.len() as u32).filter(|&t| self.normals[t as usize] != DVec3::ZERO).collect()
    }

    /// Whether the triangles around one vertex certainly do not intersect, by the conditions of
    /// [`embedded_stars`](Self::embedded_stars). `corners` holds 3 t + k for each triangle t whose corner k is the
    /// vertex.
    fn is_embedded(&self, vertex: usize, corners: &[u32], [after, before]: &mut [Vec<u32>; 2]) -> bool {
        let ends = |corner: u32| {
            let (triangle, k) = (self.triangles[corner as usize / 3], corner as usize % 3);
            (triangle[(k + 1) % 3], triangle[(k + 2) % 3])
        };
        // The neighbours that follow the vertex in its triangles, and those that precede it. In one fan every neighbour
        // is in both lists once, except the two ends of an open fan, which are in one list each.
        after.clear();
        before.clear();
        for &corner in corners {
            let (a, b) = ends(corner);
            after.push(a);
            before.push(b);
        }
        after.sort_unstable();
        before.sort_unstable();
        let repeats = |list: &[u32]| list.windows(2).any(|pair| pair[0] == pair[1]);
        if corners.is_empty() || repeats(after) || repeats(before) {
            return false;
        }
        let mut starts = after.iter().filter(|a| before.binary_search(a).is_err());
        let ray = starts.next().unwrap_or(&after[0]);
        if starts.next().is_some() {
            return false;
        }
        let centre = self.points[vertex];
        let normal: DVec3 = corners.iter().map(|&corner| self.normals[corner as usize / 3]).sum();
        let facing = normal.length();
        let direction = self.points[*ray as usize] - centre;
        let size = |v: DVec3| v.abs().element_sum();
        // Number of triangles through which the ray runs, including the triangle that it bounds on the right.
        let mut covered = 0;
        for &corner in corners {
            let (a, b) = ends(corner);
            let (to_a, to_b) = (self.points[a as usize] - centre, self.points[b as usize] - centre);
            let area = self.normals[corner as usize / 3];
            let is_facing = area.dot(normal) > FACING * size(to_a) * size(to_b) * facing;
            if !is_facing {
                return false;
            }
            // An edge opposite to the ray bounds no triangle that the ray runs through, because every triangle has an
            // angle below 180 degrees. The side of the ray's line on which this edge lies may be decided by rounding,
            // and is not needed.
            let is_opposite = |to: DVec3| {
                let along = direction.dot(to) - direction.dot(normal) * to.dot(normal) / (facing * facing);
                let sine = normal.dot(direction.cross(to));
                let scale = size(direction) * size(to);
                along < -OPPOSITE * scale && sine.abs() <= APART * facing * scale
            };
            if is_opposite(to_a) || is_opposite(to_b) {
                continue;
            }
            let side = |end: u32, to: DVec3| {
                let sine = if end == *ray { 0.0 } else { normal.dot(direction.cross(to)) };
                let certain = end == *ray || sine.abs() > APART * facing * size(direction) * size(to);
                certain.then_some(sine)
            };
            let (Some(right), Some(left)) = (side(a, to_a), side(b, to_b)) else { return false };
            covered += usize::from(right <= 0.0 && left > 0.0);
        }
        covered == 1
    }
}

/// Twice the area vector of a triangle, with a relative error below 1e-3. `None` if rounding leaves it uncertain
/// whether the triangle has an area.
pub(super) fn clear_normal(&[a, b, c]: &[DVec3; 3]) -> Option<DVec3> {
    let (u, v) = (b - a, c - a);
    let normal = u.cross(v);
    // A cross product well above rounding is not zero.
    (normal.length_squared() > 1e-24 * u.length_squared() * v.length_squared()).then_some(normal)
}

/// For each point, the lowest number of a point with the same coordinates.
fn representatives(points: &[DVec3], exec: &Execution<'_>) -> Result<Vec<u32>, Interruption> {
    // A hash table with open addressing, at most half full.
    let size = (2 * points.len()).next_power_of_two().max(2);
    let mut table = vec![NONE; size];
    let mut representative = Vec::with_capacity(points.len());
    for (k, point) in points.iter().enumerate() {
        let mixed = point.to_array().iter().fold(0u64, |hash, coordinate| {
            (hash.rotate_left(23) ^ coordinate.to_bits()).wrapping_mul(0x9e37_79b9_7f4a_7c15)
        });
        let mut slot = (mixed ^ mixed >> 29).wrapping_mul(0xbf58_476d_1ce4_e5b9) as usize >> 7 & (size - 1);
        let mut probes = 0;
        // Ends because half of the table is free.
        loop {
            let there = table[slot];
            if there == NONE {
                table[slot] = k as u32;
                representative.push(k as u32);
                break;
            }
            if points[there as usize] == *point {
                representative.push(there);
                break;
            }
            slot = (slot + 1) & (size - 1);
            // Points can be chosen so that most of them begin at the same slot.
            probes += 1;
            if probes % LOOK == 0 {
                exec.look(LOOK as u64)?;
            }
        }
        if k % LOOK == LOOK - 1 {
            exec.look(LOOK as u64)?;
        }
    }
    Ok(representative)
}
