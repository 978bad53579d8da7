//! Measures the stated figures of a lattice again, and compares.

use super::solve::SolverInput;
use crate::audit::comparison::Audit;
use crate::audit::edges::Edges;
use crate::audit::figure::{Measured, Spread, Sum};
use crate::audit::points;
use crate::audit::surface::Surface;
use plateau_archive::Lines;
use plateau_mesh::DVec3;
use plateau_uniform_mesh::{Domain, Objective};

/// Tolerance for the bounds ℓ and 2 ℓ of the edge lengths, in ℓ. The rounding of the coordinates is added to it.
const RANGE: f64 = 2e-9;

impl SolverInput {
    pub(super) fn compare(&self, audit: &mut Audit) {
        let contents = audit.contents;
        let (vertices, triangles) = (&contents.mesh.vertices, &contents.mesh.triangles);
        let edges = Edges::of(triangles, vertices.len());
        audit.equal("/nodes", vertices.len());
        audit.equal("/triangles", triangles.len());
        audit.equal("/edges", edges.list.len());
        let oriented = edges.are_of_an_oriented_manifold();
        audit.require(oriented, || "the mesh is an oriented manifold".into(), || "it is not".into());

        let length = |[a, b]: [u32; 2]| vertices[a as usize].distance(vertices[b as usize]);
        let lengths: Vec<f64> = edges.list.iter().map(|edge| length(edge.ends)).collect();
        let error = 2.0 * audit.step;
        audit.spread("/edge_lengths", &Spread::of(&lengths, error));
        self.compare_members(audit, &edges, error);
        let surface = Surface::of(vertices, triangles, audit.step);
        if !audit.goes_on(triangles.len()) {
            return;
        }
        let [smallest, largest] = surface.angles_deg();
        audit.figure("/angles_deg/min", smallest);
        audit.figure("/angles_deg/max", largest);

        let (target, tolerance) = (self.options.edge_length, audit.stated("/length_tolerance").unwrap_or(f64::NAN));
        let error = error + 1e-9 * target;
        let equal = |by: f64| lengths.iter().filter(|&&length| (length - target).abs() <= tolerance + by).count();
        audit.figure("/equal_edges", Measured::count([equal(-error), equal(error)]));
        let mut sorted = lengths.clone();
        sorted.sort_unstable_by(f64::total_cmp);
        let distinct = [distinct(&sorted, tolerance + 2.0 * error), distinct(&sorted, tolerance - 2.0 * error)];
        audit.figure("/distinct_lengths", Measured::count(distinct));
        let outside = |by: f64| lengths.iter().filter(|&&l| l < target - by || l > 2.0 * target + 2.0 * by).count();
        let slack = RANGE * target + audit.step;
        let error = (2.0 * audit.step).min(0.5 * slack);
        audit.figure("/out_of_range_edges", Measured::count([outside(slack + error), outside(slack - error)]));
        let mut valences = vec![0usize; vertices.len()];
        edges.list.iter().flat_map(|edge| edge.ends).for_each(|v| valences[v as usize] += 1);
        let largest = valences.iter().copied().max().unwrap_or(0);
        for k in 0..=largest {
            audit.equal(&format!("/valence_histogram/{k}"), valences.iter().filter(|&&valence| valence == k).count());
        }
        audit.require(
            audit.entries("/valence_histogram") == largest + 1,
            || "the histogram of valences ends at the largest".into(),
            || largest.to_string(),
        );

        let area = surface.area.measured();
        match &self.domain {
            Domain::Polygon { outer, holes } => self.compare_polygon(audit, &edges, area, outer, holes),
            _ => {
                let stated = audit.stated("/surface/area").unwrap_or(f64::NAN);
                let error = 1e-9 + (area.high - area.value) / stated;
                audit.figure("/surface/area_error", Measured::within(area.value / stated - 1.0, error));
            }
        }
    }

    /// Compares the groups of members with the edges of the mesh, and their stated lengths with the measured ones.
    fn compare_members(&self, audit: &mut Audit, edges: &Edges, error: f64) {
        let contents = audit.contents;
        let vertices = &contents.mesh.vertices;
        let mut total = 0;
        for set in contents.line_sets.iter().filter(|set| set.name == "members") {
            let Lines::Segments(pairs) = &set.lines else { continue };
            total += pairs.len();
            let stray = pairs.iter().find(|[a, b]| edges.between(*a, *b).is_none());
            audit.require(
                stray.is_none(),
                || format!("the members of the group {} are edges of the mesh", set.group),
                || format!("{stray:?} is none"),
            );
            let lengths: Vec<f64> =
                pairs.iter().map(|[a, b]| vertices[*a as usize].distance(vertices[*b as usize])).collect();
            for attribute in set.attributes.iter().filter(|attribute| attribute.name == "length") {
                for (k, (&stated, &length)) in attribute.values.iter().zip(&lengths).enumerate() {
                    let measured = Measured::within(length, 1e-9 * length + error);
                    audit.attribute(|| format!("length of member {k} of the group {}", set.group), stated, measured);
                }
            }
            if set.group == "lattice" {
                audit.equal("/lattice_edges/count", pairs.len());
                audit.spread("/lattice_edges", &Spread::of(&lengths, error));
                let objective = match self.options.objective {
                    Objective::FewestNodes => vertices.len(),
                    Objective::MostEqualEdges => pairs.len(),
                };
                audit.equal("/objective_value", objective);
            }
        }
        audit.require(total == edges.list.len(), || "every edge is a member of one group".into(), || total.to_string());
    }

    /// Compares a mesh of a polygon with the polygon: its points, its area, and the length of its sides.
    fn compare_polygon(&self, audit: &mut Audit, edges: &Edges, area: Measured, outer: &[DVec3], holes: &[Vec<DVec3>]) {
        let contents = audit.contents;
        if audit.warns("projected") {
            return;
        }
        points::at_their_vertices(audit, std::iter::once(outer).chain(holes.iter().map(|hole| &hole[..])));
        let vertices = &contents.mesh.vertices;
        let mut rim = Sum::default();
        for edge in edges.on_boundary() {
            let [a, b] = edge.ends.map(|v| vertices[v as usize]);
            rim.add(a.distance(b), 2.0 * audit.step);
        }
        let mut sides = Sum::default();
        let mut enclosed = Sum::default();
        for (k, polygon) in std::iter::once(outer).chain(holes.iter().map(|hole| &hole[..])).enumerate() {
            let next = |i: usize| polygon[(i + 1) % polygon.len()];
            for (i, &point) in polygon.iter().enumerate() {
                sides.add(point.distance(next(i)), 2.0 * audit.step);
            }
            // Twice the area vector, summed over the triangles of a fan from the first point.
            let twice: DVec3 = (0..polygon.len()).map(|i| (polygon[i] - polygon[0]).cross(next(i) - polygon[0])).sum();
            enclosed.add(if k == 0 { 0.5 } else { -0.5 } * twice.length(), audit.step * sides.value);
        }
        let (rim, sides, enclosed) = (rim.measured(), sides.measured(), enclosed.measured());
        audit.require(
            rim.low <= sides.high && sides.low <= rim.high,
            || format!("the border of the mesh is as long as the sides of the polygon, {}", sides.value),
            || rim.value.to_string(),
        );
        audit.require(
            area.low <= enclosed.high && enclosed.low <= area.high,
            || format!("the mesh has the area of the polygon, {}", enclosed.value),
            || area.value.to_string(),
        );
    }
}

/// Returns the smallest number of distinct lengths, if lengths that differ by at most `tolerance` count as equal.
/// `sorted` is in increasing order.
fn distinct(sorted: &[f64], tolerance: f64) -> usize {
    let (mut kinds, mut limit) = (0, f64::NEG_INFINITY);
    for &length in sorted {
        if length > limit {
            kinds += 1;
            limit = length + tolerance;
        }
    }
    kinds
}
