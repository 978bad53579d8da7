//! Measures the stated figures of strips again, and compares.

use super::solve::SolverInput;
use super::statistics::LISTED_BRIDGES;
use crate::audit::comparison::Audit;
use crate::audit::figure::{Largest, Least, Measured, Sum};
use crate::audit::points;
use crate::audit::strip::{Figures, Rail, Strip, between};
use crate::audit::surface::{Sides, corners};
use plateau_archive::Lines;
use plateau_archive::archive::{BRIDGES, CONCAVE};
use plateau_mesh::DVec3;
use plateau_ruled_surface::{Caps, Objective, RailEnds, Secondary};

/// The figures of all strips together.
struct Total {
    area: Sum,
    twist: Sum,
    convex: [usize; 2],
    bending: Sum,
    curvature_variation: Sum,
    shortest: Option<Measured>,
    longest: Option<Measured>,
    fold: Option<Measured>,
    concave_fold: Option<Measured>,
}

/// The bridges that a result marks as not locally convex, while the strips are compared one after another.
struct Marks<'c> {
    /// For each bridge of the strips that are left, 1 if it is marked. Empty if the result marks none.
    left: &'c [f64],
    /// Number of the first bridge that is left.
    first: usize,
    /// Number of entries of the stated list that were compared.
    listed: usize,
}

impl<'c> Marks<'c> {
    fn new(audit: &Audit<'c>) -> Self {
        let bridges = audit.contents.line_sets.iter().find(|set| set.name == BRIDGES);
        let marks = bridges.and_then(|set| set.attributes.iter().find(|attribute| attribute.name == CONCAVE));
        Self { left: marks.map_or(&[], |attribute| &attribute.values), first: 0, listed: 0 }
    }

    /// Compares the marks of the next strip and the entries of the stated list for them.
    fn compare(&mut self, audit: &mut Audit, pointer: &str, figures: &Figures, bridges: &[[u32; 2]]) {
        let (own, left) = self.left.split_at(bridges.len().min(self.left.len()));
        let is_wrong = |k: usize, [certain, possible]: [bool; 2]| match own.get(k) {
            Some(1.0) => certain,
            Some(0.0) => !possible,
            _ => true,
        };
        let wrong = figures.convexity.iter().enumerate().find(|&(k, &convex)| is_wrong(k, convex));
        audit.require(
            wrong.is_none(),
            || format!("{pointer}: the bridges that are not locally convex are marked, and no others"),
            || wrong.map_or_else(String::new, |(k, _)| format!("bridge {k} differs")),
        );
        let marked = || own.iter().enumerate().filter(|&(_, &mark)| mark == 1.0).map(|(k, _)| k);
        audit.equal(&format!("{pointer}/convex_bridges"), bridges.len() - marked().count());
        let list = audit.value("/concave_bridges");
        for k in marked().take(LISTED_BRIDGES - self.listed) {
            let (number, ends) = (self.first + k, bridges[k].map(|vertex| vertex as usize));
            let fold = figures.fold_at(k).times(1f64.to_degrees());
            // Looking figures up by pointers takes longer than the rest of the audit of a strip, so that only the
            // pointers of a wrong entry are written.
            let stated = &list[self.listed];
            let is_right = stated["bridge"] == number
                && stated["vertices"].as_array().is_some_and(|stated| stated[..] == ends)
                && stated["fold_deg"].as_f64().is_some_and(|stated| fold.agrees_with(stated));
            if !is_right {
                let entry = format!("/concave_bridges/{}", self.listed);
                audit.equal(&format!("{entry}/bridge"), number);
                audit.equal(&format!("{entry}/vertices/0"), ends[0]);
                audit.equal(&format!("{entry}/vertices/1"), ends[1]);
                audit.figure(&format!("{entry}/fold_deg"), fold);
            }
            self.listed += 1;
        }
        (self.left, self.first) = (left, self.first + bridges.len());
    }
}

impl SolverInput {
    pub(super) fn compare(&self, audit: &mut Audit) {
        let contents = audit.contents;
        let triangles = &contents.mesh.triangles;
        audit.equal("/vertices", contents.mesh.vertices.len());
        if self.options.sampling.is_none() && !audit.warns("projected") {
            self.compare_places(audit);
        }
        let bridges = contents.line_sets.iter().find(|set| set.name == BRIDGES).map(|set| &set.lines);
        let bridges: &[[u32; 2]] = match bridges {
            Some(Lines::Segments(pairs)) => pairs,
            _ => &[],
        };
        audit.equal("/bridges", bridges.len());
        let rails = self.rails(audit);
        let strips = audit.entries("/strips");
        audit.require(
            strips + 1 == rails.len(),
            || format!("{} directrices make {} strips", rails.len(), rails.len() - 1),
            || strips.to_string(),
        );
        if !audit.goes_on(triangles.len()) {
            return;
        }
        let strips = strips.min(rails.len() - 1);
        if let Some((total, listed)) = self.compare_strips(audit, strips, bridges, &rails) {
            self.compare_sums(audit, &total, bridges.len(), &triangles[listed..]);
        }
    }

    /// Compares the vertices of the given points with the points, and how far they are stated to have moved.
    fn compare_places(&self, audit: &mut Audit) {
        let tolerance = self.options.rail_tolerance.unwrap_or(0.0);
        let ends_move = self.options.rail_ends == RailEnds::Free || self.options.closed;
        let allowed = |i: usize, count: usize| if ends_move || i > 0 && i + 1 < count { tolerance } else { 0.0 };
        let moves = points::near_their_vertices(audit, self.directrices.iter().map(|points| &points[..]), allowed);
        if self.options.rail_tolerance.is_none() {
            return;
        }
        let largest = moves.iter().map(|&(_, distance)| distance).fold(0.0, f64::max);
        audit.figure("/rails/moved_max", Measured::within(largest, audit.step));
        let stated = audit.stated_count("/rails/moved_max_vertex");
        let of_stated = moves.iter().find(|&&(v, _)| v as usize == stated);
        audit.require(
            of_stated.is_some_and(|&(_, distance)| distance >= largest - audit.step),
            || format!("vertex {stated} moved by {largest}"),
            || of_stated.map_or_else(|| "it has no point".into(), |&(_, distance)| distance.to_string()),
        );
    }

    /// Returns the vertices of the mesh with every point of the request in its own place.
    fn places(&self, audit: &Audit) -> Vec<DVec3> {
        let mut at = audit.contents.mesh.vertices.clone();
        for (points, numbers) in self.directrices.iter().zip(&audit.contents.input_vertices) {
            // In reverse, because merged points follow the point that keeps the vertex.
            for (&point, &v) in points.iter().zip(numbers).rev() {
                at[v as usize] = point;
            }
        }
        at
    }

    /// Compares every strip. Returns the sums over the strips and the number of their triangles, which precede the
    /// triangles of the caps. Returns `None` if the bridges do not join the directrices or the audit was cancelled.
    fn compare_strips<'c>(
        &self,
        audit: &mut Audit<'c>,
        strips: usize,
        bridges: &[[u32; 2]],
        rails: &[Rail<'c>],
    ) -> Option<(Total, usize)> {
        let contents = audit.contents;
        let triangles = &contents.mesh.triangles;
        let (mut first_bridge, mut first_triangle) = (0usize, 0usize);
        let mut total: Option<Total> = None;
        let mut marks = Marks::new(audit);
        // Value of the objective of these bridges on the points in their own places.
        let is_moved = self.options.rail_tolerance.is_some() && self.options.sampling.is_none();
        let mut before = is_moved.then(|| Measured::within(0.0, 0.0));
        let places = before.map_or_else(Vec::new, |_| self.places(audit));
        for k in 0..strips {
            let pointer = format!("/strips/{k}");
            let count = audit.stated_count(&format!("{pointer}/bridges"));
            let own = bridges.get(first_bridge..first_bridge.saturating_add(count)).unwrap_or_default();
            first_bridge = first_bridge.saturating_add(own.len());
            let pair = [rails[k].clone(), rails[k + 1].clone()];
            let Some(strip) = self.strip(audit, own, pair).filter(|_| own.len() > 1) else {
                audit.require(
                    false,
                    || format!("the bridges of strip {k} join its directrices"),
                    || "they do not".into(),
                );
                return None;
            };
            audit.require(
                strip.follows_its_rails(),
                || format!("strip {k} passes every point of its directrices in order"),
                || "it does not".into(),
            );
            let steps = strip.steps();
            audit.equal(&format!("{pointer}/triangles"), steps);
            let listed = triangles.get(first_triangle..first_triangle + steps).unwrap_or_default();
            first_triangle += listed.len();
            let differs = (0..steps).find(|&t| {
                let (own, listed) = (strip.triangle(t), listed.get(t).copied().unwrap_or_default());
                !own.iter().all(|v| listed.contains(v)) || !listed.iter().all(|v| own.contains(v))
            });
            audit.require(
                differs.is_none(),
                || format!("the triangles of strip {k} lie between its bridges"),
                || differs.map_or_else(String::new, |t| format!("triangle {t} does not")),
            );
            let figures = strip.figures();
            if !audit.goes_on(own.len()) {
                return None;
            }
            self.compare_strip(audit, &pointer, &figures, own.len());
            marks.compare(audit, &pointer, &figures, own);
            if let Some(sum) = before {
                let figures = Strip { at: &places, ..strip }.figures();
                let variation = figures.normal_variation.map(|[one, _]| one.measured());
                before = self.objective(&figures, variation).map(|of_strip| sum.plus(of_strip));
            }
            add(&mut total, &figures);
        }
        if let (Some(bound), Some(stated)) = (before, audit.stated("/rails/before")) {
            // The value before is the best of all bridges, so that these are not better.
            let is_count = self.options.objective == Objective::MaximalConvexity;
            audit.require(
                if is_count { stated >= bound.low } else { stated <= bound.high },
                || "no bridges are better for the points in their own places than those of the value before".into(),
                || format!("{stated}, and {} of these bridges", bound.value),
            );
        }
        audit.require(
            first_bridge == bridges.len(),
            || "the strips have all bridges".into(),
            || format!("{first_bridge} of {}", bridges.len()),
        );
        let (listed, stated) = (marks.listed, audit.entries("/concave_bridges"));
        audit.require(
            stated == listed,
            || format!("{listed} bridges are listed as not locally convex"),
            || stated.to_string(),
        );
        audit.equal("/triangles", triangles.len());
        let without_caps = self.options.caps == Caps::None;
        audit.require(
            !without_caps || first_triangle == triangles.len(),
            || "the strips have all triangles".into(),
            || format!("{first_triangle} of {}", triangles.len()),
        );
        Some((total?, first_triangle))
    }

    /// Compares the figures of all strips together. The area includes the `caps`.
    fn compare_sums(&self, audit: &mut Audit, total: &Total, bridges: usize, caps: &[[u32; 3]]) {
        let contents = audit.contents;
        let convex = Measured::count(total.convex);
        let mut area = total.area;
        for &triangle in caps {
            let sides = Sides::of(corners(&contents.mesh.vertices, triangle));
            area.add(0.5 * sides.double_area, 0.5 * audit.step * sides.perimeter());
        }
        audit.figure("/area", area.measured());
        audit.figure("/total_normal_twist", total.twist.measured());
        audit.figure("/convex_bridges", convex);
        audit.figure("/convex_bridge_ratio", ratio(convex, bridges));
        audit.figure("/bending_energy", total.bending.measured());
        audit.figure("/mean_curvature_variation", total.curvature_variation.measured());
        let ranges = [
            ("/shortest_bridge", total.shortest),
            ("/longest_bridge", total.longest),
            ("/largest_fold_deg", total.fold.map(|fold| fold.times(1f64.to_degrees()))),
            ("/developability_deviation_deg", total.concave_fold.map(|fold| fold.times(1f64.to_degrees()))),
        ];
        for (pointer, measured) in ranges {
            if let Some(measured) = measured {
                audit.figure(pointer, measured);
            }
        }
        if let (Some(before), Some(value)) = (audit.stated("/rails/before"), audit.stated("/objective_value")) {
            let is_count = self.options.objective == Objective::MaximalConvexity;
            let gain = if is_count { value - before } else { before - value };
            audit.figure("/rails/gain", Measured::within(gain, 1e-9 * before.abs()));
            audit.require(gain >= 0.0, || "the rails moved for no worse value".into(), || gain.to_string());
        }
        for name in ["objective_value", "secondary_value", "normal_variation"] {
            let strips = 0..audit.entries("/strips");
            let of_strips = strips.map(|k| audit.stated(&format!("/strips/{k}/{name}")));
            let Some(sum) = of_strips.sum::<Option<f64>>() else { continue };
            audit.figure(&format!("/{name}"), Measured::within(sum, 1e-9 * sum.abs()));
        }
    }

    /// Returns the rails: the directrices in the order and direction in which the strips run along them.
    fn rails<'c>(&self, audit: &Audit<'c>) -> Vec<Rail<'c>> {
        let contents = audit.contents;
        let mut lines = points::polylines(contents, "directrices").into_iter();
        let rail = |(k, numbers): (usize, &'c Vec<u32>)| {
            let is_apex = numbers.iter().all(|v| v == &numbers[0]);
            let vertices = if is_apex { &numbers[..1] } else { lines.next().unwrap_or_default() };
            // A directrix that was reversed has falling vertex numbers.
            let is_reversed = audit.value("/reversed")[k] == true;
            let given = |vectors: &Option<Vec<Vec<DVec3>>>, sign: f64| -> Vec<DVec3> {
                let Some(vectors) = vectors.as_ref().and_then(|vectors| vectors.get(k)) else { return Vec::new() };
                let index = |v: &u32| numbers.iter().position(|number| number == v);
                let vector = |v: &u32| index(v).and_then(|i| vectors.get(i).copied());
                vertices.iter().map(|v| sign * vector(v).unwrap_or_default().normalize_or_zero()).collect()
            };
            let tangents = given(&self.options.tangents, if is_reversed { -1.0 } else { 1.0 });
            Rail { vertices, tangents, normals: given(&self.options.normals, 1.0) }
        };
        contents.input_vertices.iter().enumerate().map(rail).collect()
    }

    fn strip<'c>(&self, audit: &Audit<'c>, bridges: &[[u32; 2]], rails: [Rail<'c>; 2]) -> Option<Strip<'c>> {
        // The vertex numbers of a rail are consecutive, rising or falling.
        let position = |rail: &Rail, v: u32| {
            let vertices = rail.vertices;
            let index = v.abs_diff(*vertices.first()?) as usize;
            (vertices.get(index) == Some(&v)).then_some(index)
        };
        let pair = |&[p, q]: &[u32; 2]| Some([position(&rails[0], p)?, position(&rails[1], q)?]);
        let bridges = bridges.iter().map(pair).collect::<Option<Vec<_>>>()?;
        let tolerance = self.options.convexity_tolerance;
        let at = &audit.contents.mesh.vertices;
        Some(Strip {
            at,
            rails,
            closed: self.options.closed,
            bridges,
            convexity_tolerance: tolerance,
            bending: self.options.bending,
            step: audit.step,
        })
    }

    fn compare_strip(&self, audit: &mut Audit, pointer: &str, figures: &Figures, bridges: usize) {
        let convex = Measured::count(figures.convex);
        // The result does not contain the tangents and normals of resampled directrices. Figures that depend on them
        // are not compared.
        let has_vectors = self.options.tangents.is_some() || self.options.normals.is_some();
        let resampled = has_vectors && self.options.sampling.is_some();
        let mut one = |name: &str, measured: Measured| audit.figure(&format!("{pointer}/{name}"), measured);
        one("area", figures.area.measured());
        if !resampled {
            one("total_normal_twist", figures.twist.measured());
        }
        one("convex_bridges", convex);
        one("convex_bridge_ratio", ratio(convex, bridges));
        one("bending_energy", figures.bending.measured());
        one("mean_curvature_variation", figures.curvature_variation.measured());
        one("largest_fold_deg", figures.fold.measured().times(1f64.to_degrees()));
        one("developability_deviation_deg", concave_fold(figures).times(1f64.to_degrees()));
        one("shortest_bridge", figures.shortest.measured());
        one("longest_bridge", figures.longest.measured());
        let variation = figures.normal_variation.filter(|_| !resampled).map(|both| {
            let stated = audit.stated(&format!("{pointer}/normal_variation")).unwrap_or(f64::NAN);
            let [one, other] = both.map(Sum::measured);
            if other.agrees_with(stated) { other } else { one }
        });
        if let Some(variation) = variation {
            audit.figure(&format!("{pointer}/normal_variation"), variation);
        }
        let objective = self.objective(figures, variation).filter(|_| !resampled || !self.needs_tangents());
        if let Some(objective) = objective {
            audit.figure(&format!("{pointer}/objective_value"), objective);
        }
        let secondary = self.options.secondary.map(|secondary| match secondary {
            Secondary::BendingEnergy => between(figures.concave_bending),
            Secondary::MeanCurvatureVariation => between(figures.concave_curvature),
        });
        if let Some(secondary) = secondary {
            audit.figure(&format!("{pointer}/secondary_value"), secondary);
        }
    }
}

impl SolverInput {
    /// Returns the value of the objective, or `None` if the result does not determine it.
    fn objective(&self, figures: &Figures, variation: Option<Measured>) -> Option<Measured> {
        let sums = [figures.area, figures.twist, figures.bending, figures.curvature_variation];
        let [area, twist, bending, curvature_variation] = sums.map(Sum::measured);
        match self.options.objective {
            Objective::MinimalArea => Some(area),
            Objective::MinimalTwist => Some(twist),
            Objective::MaximalConvexity => Some(Measured::count(figures.convex)),
            Objective::MinimalBendingEnergy => Some(bending),
            Objective::MinimalMeanCurvatureVariation => Some(curvature_variation),
            Objective::MinimalNormalVariation => variation,
            // The result does not contain the optima by which the terms of a normalised sum are divided.
            Objective::Weighted(weights) if !weights.normalise => {
                let measured = [Some(area), Some(twist), Some(bending), Some(curvature_variation), variation];
                let terms = weights.terms().map(|(_, weight)| weight).into_iter().zip(measured);
                let mut sum = Measured::within(0.0, 0.0);
                for (weight, term) in terms.filter(|&(weight, _)| weight > 0.0) {
                    sum = sum.plus(term?.times(weight));
                }
                Some(sum)
            }
            _ => None,
        }
    }

    /// Whether the objective depends on tangents, which the result does not contain for resampled directrices.
    fn needs_tangents(&self) -> bool {
        match self.options.objective {
            Objective::MinimalTwist | Objective::MinimalNormalVariation => true,
            Objective::Weighted(weights) => weights.twist > 0.0 || weights.normal_variation > 0.0,
            _ => false,
        }
    }
}

fn ratio(convex: Measured, bridges: usize) -> Measured {
    convex.times(1.0 / bridges.max(1) as f64).widened(1e-12)
}

/// Returns the largest fold at bridges that are not convex. Its range also covers the bridges whose convexity rounding
/// decides.
fn concave_fold(figures: &Figures) -> Measured {
    let [certain, possible] = figures.concave_fold.map(Largest::measured);
    Measured { value: certain.value, low: certain.low.min(possible.low), high: possible.high.max(certain.high) }
}

fn add(total: &mut Option<Total>, figures: &Figures) {
    let larger = |old: Option<Measured>, new: Measured| {
        Some(old.map_or(new, |old| Measured {
            value: old.value.max(new.value),
            low: old.low.max(new.low),
            high: old.high.max(new.high),
        }))
    };
    let total = total.get_or_insert(Total {
        area: Sum::default(),
        twist: Sum::default(),
        convex: [0; 2],
        bending: Sum::default(),
        curvature_variation: Sum::default(),
        shortest: None,
        longest: None,
        fold: None,
        concave_fold: None,
    });
    total.area.add_sum(figures.area);
    total.twist.add_sum(figures.twist);
    total.convex = [0, 1].map(|k| total.convex[k] + figures.convex[k]);
    total.bending.add_sum(figures.bending);
    total.curvature_variation.add_sum(figures.curvature_variation);
    total.longest = larger(total.longest, figures.longest.measured());
    total.fold = larger(total.fold, figures.fold.measured());
    total.concave_fold = larger(total.concave_fold, concave_fold(figures));
    let shortest = figures.shortest.measured();
    total.shortest = Some(total.shortest.map_or(shortest, |old| {
        let mut least = Least::NONE;
        for figure in [old, shortest] {
            least.add(figure.value, figure.high - figure.value);
        }
        least.measured()
    }));
}
