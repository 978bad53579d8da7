//! Measures the stated figures of a film again, and compares.

use super::solve::SolverInput;
use crate::audit::comparison::Audit;
use crate::audit::edges::Edges;
use crate::audit::figure::{Measured, Spread};
use crate::audit::surface::Surface;
use crate::audit::{curvature, held, points, topology};
use plateau_mesh::DVec3;
use plateau_mesh::polyline;
use plateau_minimal_surface::Objective;

impl SolverInput {
    pub(super) fn compare(&self, audit: &mut Audit) {
        let contents = audit.contents;
        let (vertices, triangles) = (&contents.mesh.vertices, &contents.mesh.triangles);
        let has_junctions = !audit.value("/junctions").is_null();
        let edges = Edges::of(triangles, vertices.len());
        if !audit.goes_on(triangles.len()) {
            return;
        }
        audit.equal("/vertices", vertices.len());
        audit.equal("/triangles", triangles.len());
        topology::compare(audit, &edges, has_junctions);
        points::at_their_vertices(audit, self.boundaries.iter().map(|points| &points[..]));
        points::along_boundaries(audit, &edges, 1, true);

        let surface = Surface::of(vertices, triangles, audit.step);
        if !audit.goes_on(triangles.len()) {
            return;
        }
        let area = surface.area.measured();
        audit.figure("/area", area);
        self.compare_objective(audit, area);
        let lengths: Vec<f64> = edges.list.iter().map(|edge| length(vertices, edge.ends)).collect();
        audit.spread("/edge_lengths", &Spread::of(&lengths, 2.0 * audit.step));
        let [smallest, largest] = surface.angles_deg();
        audit.figure("/angles_deg/min", smallest);
        audit.figure("/angles_deg/max", largest);
        audit.figure("/degenerate_triangles", Measured::count(surface.degenerate));
        if !audit.goes_on(edges.list.len()) {
            return;
        }
        if !has_junctions {
            audit.figure("/flipped_triangles", Measured::count(surface.flipped));
        }

        let boundaries = points::polylines(contents, "boundaries");
        let mut is_fixed = vec![false; vertices.len()];
        boundaries.iter().flat_map(|rim| rim.iter()).for_each(|&v| is_fixed[v as usize] = true);
        let rim: Vec<DVec3> = boundaries.iter().flat_map(|rim| rim.iter()).map(|&v| vertices[v as usize]).collect();
        let constraints = &self.options.constraints;
        if !constraints.is_empty() {
            held::mark(audit, &edges, &constraints.points, &constraints.polylines, &mut is_fixed);
            if !audit.goes_on(edges.list.len()) {
                return;
            }
        }
        // At a junction of three sheets the film's normal is not defined.
        if !has_junctions {
            curvature::compare(audit, &surface, &is_fixed, polyline::radius(&rim), self.options.tolerance);
        }
        if has_junctions {
            let joined: Vec<_> = edges.list.iter().filter(|edge| edge.triangles() > 2).collect();
            audit.equal("/junctions/edges", joined.len());
            let total =
                Spread::of(&joined.iter().map(|e| length(vertices, e.ends)).collect::<Vec<_>>(), 2.0 * audit.step);
            audit.figure("/junctions/length", total.mean.times(total.count as f64));
        }
        self.compare_certificate(audit, area);
        self.compare_curvature_bound(audit);
    }

    /// A film that states that it converged is within the request's bound on the mean curvature. The stated curvature
    /// has been compared with the mesh before.
    fn compare_curvature_bound(&self, audit: &mut Audit) {
        let bound = self.options.curvature_tolerance;
        let (Some(bound), Some(largest)) = (bound, audit.stated("/mean_curvature/max")) else { return };
        let is_kept = *audit.value("/converged") != true || largest <= bound;
        audit.require(is_kept, || format!("the mean curvature is at most {bound}"), || format!("{largest}"));
    }

    fn compare_objective(&self, audit: &mut Audit, area: Measured) {
        match self.options.method.objective() {
            Objective::MinimalArea => audit.figure("/objective_value", area),
            // The Dirichlet energy of a map is at least the area of its image. It cannot be measured again, because the
            // result does not contain the map's domain.
            Objective::MinimalDirichletEnergy => {
                audit.figure("/objective_value", Measured { high: f64::INFINITY, ..area });
            }
            Objective::MinimalMeanCurvature => {
                audit.figure("/objective_value", Measured { value: 0.0, low: 0.0, high: f64::INFINITY });
            }
        }
        let Some(topologies) = audit.value("/spanning/topologies").as_array() else { return };
        for k in (0..topologies.len()).filter(|&k| topologies[k]["chosen"] == true) {
            audit.figure(&format!("/spanning/topologies/{k}/area"), area);
        }
    }

    fn compare_certificate(&self, audit: &mut Audit, area: Measured) {
        let Some(bound) = audit.stated("/certificate/area_lower_bound").filter(|bound| *bound > 0.0) else { return };
        let gap = |area: f64| (area / bound - 1.0).max(0.0);
        audit.figure(
            "/certificate/gap",
            Measured { value: gap(area.value), low: gap(area.low), high: gap(area.high).next_up() },
        );
        // A proven bound is at most the area of every surface with this boundary.
        let above = area.high >= bound;
        audit.require(above, || "the area is at least the proven bound".into(), || format!("{}", area.value));
    }
}

fn length(vertices: &[DVec3], [a, b]: [u32; 2]) -> f64 {
    vertices[a as usize].distance(vertices[b as usize])
}
