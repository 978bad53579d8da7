//! Measures the stated figures of a cable net again, and compares.

use super::Group;
use super::solve::SolverInput;
use crate::audit::comparison::Audit;
use crate::audit::figure::{Largest, Least, Measured, RELATIVE, Spread, Sum};
use crate::audit::points;
use plateau_archive::Lines;
use plateau_archive::archive::CABLES;
use plateau_mesh::DVec3;

/// Sum of the forces on one vertex, and the distance by which rounding may move it.
#[derive(Clone, Copy, Default)]
struct Forces {
    sum: DVec3,
    tolerance: f64,
}

impl SolverInput {
    pub(super) fn compare(&self, audit: &mut Audit) {
        let contents = audit.contents;
        let vertices = &contents.mesh.vertices;
        let count = vertices.len();
        audit.equal("/vertices", count);
        audit.equal("/edges", self.net.edges.len());
        audit.equal("/triangles", contents.mesh.triangles.len());
        self.compare_points(audit);
        if !audit.goes_on(self.net.edges.len()) {
            return;
        }

        let error = 2.0 * audit.step;
        let mut on_vertices: Vec<Forces> =
            (0..count).map(|v| Forces { sum: self.net.load(v), tolerance: 0.0 }).collect();
        let (mut lengths, mut load_path) = (Vec::new(), Sum::default());
        let mut largest: f64 = 0.0;
        let sets: Vec<_> = contents.line_sets.iter().filter(|set| set.name == CABLES).collect();
        let (stated_groups, found) = (self.groups.len(), sets.len());
        audit.require(found == stated_groups, || "each cable has its lines".into(), || found.to_string());
        for (k, (set, group)) in sets.iter().zip(&self.groups).enumerate() {
            let Lines::Segments(pairs) = &set.lines else { continue };
            let as_asked = pairs.len() == group.edges.len()
                && pairs.iter().zip(&group.edges).all(|(pair, &e)| *pair == self.net.edges[e].ends);
            audit.require(as_asked, || format!("cable {k} runs along its edges"), || "it does not".into());
            let forces = set.attributes.iter().find(|attribute| attribute.name == "force");
            let forces: &[f64] = forces.map_or(&[], |attribute| &attribute.values);
            let own: Vec<f64> =
                pairs.iter().map(|[a, b]| vertices[*a as usize].distance(vertices[*b as usize])).collect();
            for ((&[a, b], &force), &length) in pairs.iter().zip(forces).zip(&own) {
                let pull = (vertices[b as usize] - vertices[a as usize]) * (force / length);
                for (v, pull) in [(a, pull), (b, -pull)] {
                    let on = &mut on_vertices[v as usize];
                    on.sum += pull;
                    on.tolerance += RELATIVE * force.abs() + error * force.abs() / length;
                }
                load_path.add(force.abs() * length, force.abs() * error);
                largest = largest.max(force.abs());
            }
            self.compare_cable(audit, k, group, forces, &own);
            lengths.extend(own);
        }
        audit.spread("/edge_lengths", &Spread::of(&lengths, error));
        audit.figure("/load_path", load_path.measured());
        self.compare_balance(audit, &mut on_vertices, largest);
    }

    /// Requires that each support is at its position in the request.
    fn compare_points(&self, audit: &mut Audit) {
        let vertices = &audit.contents.mesh.vertices;
        let mut expected = vertices.clone();
        for &support in &self.net.supports {
            expected[support as usize] = self.net.vertices[support as usize];
        }
        points::at_their_vertices(audit, std::iter::once(&expected[..]));
    }

    fn compare_cable(&self, audit: &mut Audit, k: usize, group: &Group, forces: &[f64], lengths: &[f64]) {
        let error = 2.0 * audit.step;
        let (mut moment, mut length, mut unstressed) = (Sum::default(), Sum::default(), Sum::default());
        let (mut least, mut most) = (Least::NONE, Largest::NONE);
        let (mut shortest, mut longest) = (Least::NONE, Largest::NONE);
        let (mut thinnest, mut densest) = (Least::NONE, Largest::NONE);
        let mut deviations = [Largest::NONE; 2];
        for ((&e, &force), &own) in group.edges.iter().zip(forces).zip(lengths) {
            let edge = &self.net.edges[e];
            moment.add(force * own, force.abs() * error);
            length.add(own, error);
            if let Some(stiffness) = group.axial_stiffness {
                unstressed.add(own / (1.0 + force / stiffness), error);
            }
            least.add(force, RELATIVE * force.abs());
            most.add(force, RELATIVE * force.abs());
            shortest.add(own, RELATIVE * own + error);
            longest.add(own, RELATIVE * own + error);
            let density = force / own;
            let rounding = density.abs() * (RELATIVE + error / own);
            thinnest.add(density, rounding);
            densest.add(density, rounding);
            let targets = [(force, edge.force, 0.0), (own, edge.length, error)];
            for (largest, (value, target, error)) in deviations.iter_mut().zip(targets) {
                if let Some(target) = target {
                    let relative = value / target;
                    largest.add((relative - 1.0).abs(), RELATIVE * (1.0 + relative.abs()) + error / target);
                }
            }
        }
        let mut one = |name: &str, measured: Measured| audit.figure(&format!("/cables/{k}/{name}"), measured);
        let total = length.measured();
        let mean = moment.value / length.value;
        one("edges", Measured::within(forces.len() as f64, 0.0));
        one(
            "force",
            Measured::within(mean, mean.abs() * (2.0 * RELATIVE + 2.0 * error * forces.len() as f64 / length.value)),
        );
        one("force_min", least.measured());
        one("force_max", most.measured());
        one("length", total);
        if group.axial_stiffness.is_some_and(|stiffness| forces.iter().all(|force| 1.0 + force / stiffness > 0.0)) {
            one("unstressed_length", unstressed.measured());
        }
        one("edge_lengths/min", shortest.measured());
        one("edge_lengths/max", longest.measured());
        one("force_densities/min", thinnest.measured());
        one("force_densities/max", densest.measured());
        for (largest, name) in deviations.into_iter().zip(["force_deviation", "length_deviation"]) {
            if largest != Largest::NONE {
                one(name, largest.measured());
            }
        }
    }

    /// Compares the reactions, the balance of loads and reactions, and the unbalanced forces on the free vertices.
    fn compare_balance(&self, audit: &mut Audit, on_vertices: &mut [Forces], largest_force: f64) {
        let loads: DVec3 = (0..on_vertices.len()).map(|v| self.net.load(v)).sum();
        let load_scale: f64 = (0..on_vertices.len()).map(|v| self.net.load(v).length()).sum();
        let (mut reactions, mut magnitudes, mut tolerance) = (DVec3::ZERO, 0.0, RELATIVE * load_scale);
        for (k, &support) in self.net.supports.iter().enumerate() {
            // A support that is listed twice bears its force once.
            let Forces { sum, tolerance: own } = std::mem::take(&mut on_vertices[support as usize]);
            for axis in 0..3 {
                audit.figure(&format!("/reactions/{k}/force/{axis}"), Measured::within(-sum[axis], own));
            }
            reactions -= sum;
            magnitudes += sum.length();
            tolerance += own;
        }
        let mut unbalanced = Largest::NONE;
        on_vertices.iter().for_each(|on| unbalanced.add(on.sum.length(), on.tolerance));
        for axis in 0..3 {
            audit.figure(&format!("/balance/loads/{axis}"), Measured::within(loads[axis], RELATIVE * load_scale));
            audit.figure(&format!("/balance/reactions/{axis}"), Measured::within(reactions[axis], tolerance));
        }
        audit.figure("/balance/magnitudes", Measured::within(magnitudes, tolerance));
        let imbalance = (loads + reactions).length() / magnitudes.max(f64::MIN_POSITIVE);
        let relative = RELATIVE + 2.0 * tolerance / magnitudes.max(f64::MIN_POSITIVE);
        audit.figure("/balance/imbalance", Measured::within(imbalance, relative));
        audit.figure("/balance/residual_force", unbalanced.measured());
        audit.figure("/residual", unbalanced.measured().times(1.0 / largest_force));
        self.compare_loss(audit);
    }

    /// Compares the loss, unless the load path has a weight. The load path counts relative to its value at the start,
    /// which the result does not contain.
    fn compare_loss(&self, audit: &mut Audit) {
        let options = &self.options;
        if options.load_path_weight > 0.0 {
            return;
        }
        let contents = audit.contents;
        let at = &contents.mesh.vertices;
        let mut sums = [(0.0, 0.0, 0usize); 2];
        for (set, group) in contents.line_sets.iter().filter(|set| set.name == CABLES).zip(&self.groups) {
            let Some(forces) = set.attributes.iter().find(|attribute| attribute.name == "force") else { continue };
            for (&e, &force) in group.edges.iter().zip(&forces.values) {
                let edge = &self.net.edges[e];
                let length = at[edge.ends[0] as usize].distance(at[edge.ends[1] as usize]);
                let targets = [(force, edge.force, 0.0), (length, edge.length, 2.0 * audit.step)];
                for (sum, (value, target, error)) in sums.iter_mut().zip(targets) {
                    let Some(target) = target else { continue };
                    let miss = value / target - 1.0;
                    let rounding = RELATIVE * (1.0 + miss.abs()) + error / target;
                    sum.0 += miss * miss;
                    sum.1 += (2.0 * miss.abs() + rounding) * rounding;
                    sum.2 += 1;
                }
            }
        }
        let weights = [options.force_weight, options.length_weight];
        let (mut loss, mut tolerance) = (0.0, 0.0);
        for ((sum, error, count), weight) in sums.into_iter().zip(weights) {
            loss += weight * sum / count.max(1) as f64;
            tolerance += weight * error / count.max(1) as f64;
        }
        audit.figure("/objective_value", Measured::within(loss, RELATIVE * loss + tolerance));
    }
}
