//! The stresses of the film in the found shape.

use super::form_finding::Balance;
use super::model::Model;
use super::options::{FilmStress, Weave};
use super::shape::{LayerResult, Stress, StressRange, TriangleStress, WeaveStress};
use plateau_equilibrium::energy::PlaneStress;
use plateau_mesh::DVec3;
use plateau_mesh::measure::double_area_vector;

/// The stress F S Fᵀ / det F of a triangle that was deformed from its reference shape. F is the deformation gradient,
/// and S is the stress in the reference shape.
struct Deformed {
    /// The images F w and F f of the two principal directions of the reference stress S = σ_w w wᵀ + σ_f f fᵀ.
    images: [DVec3; 2],
    reference: PlaneStress,
    /// det F.
    stretch: f64,
}

impl Deformed {
    fn of(stress: PlaneStress, reference: [DVec3; 3], now: [DVec3; 3]) -> Self {
        let (a, b) = (reference[1] - reference[0], reference[2] - reference[0]);
        let normal = a.cross(b).normalize_or_zero();
        let along = stress.direction;
        let across = normal.cross(along);
        let ([a_along, b_along], [a_across, b_across]) = ([a, b].map(|e| e.dot(along)), [a, b].map(|e| e.dot(across)));
        let determinant = a_along * b_across - a_across * b_along;
        let (p, q) = (now[1] - now[0], now[2] - now[0]);
        let images = [(p * b_across - q * a_across) / determinant, (q * a_along - p * b_along) / determinant];
        Self { images, reference: stress, stretch: images[0].cross(images[1]).length() }
    }

    /// The normal stress in the direction of a unit vector of the triangle's plane.
    fn along(&self, direction: DVec3) -> f64 {
        let [w, f] = self.images.map(|image| image.dot(direction));
        (self.reference.along * w * w + self.reference.across * f * f) / self.stretch
    }

    /// The least and the largest principal stress. Their product equals the product of the principal stresses in the
    /// reference shape.
    fn principal(&self) -> (f64, f64) {
        let PlaneStress { along, across, .. } = self.reference;
        let [w, f] = self.images.map(DVec3::length_squared);
        let half = 0.5 * (along * w + across * f) / self.stretch;
        let root = (half * half - along * across).max(0.0).sqrt();
        (half - root, half + root)
    }
}

impl Deformed {
    /// The unit vector along the largest principal stress.
    fn direction(&self) -> DVec3 {
        let PlaneStress { along, across, .. } = self.reference;
        let [w, f] = self.images;
        let first = w.normalize_or_zero();
        let second = (f - first * first.dot(f)).normalize_or_zero();
        let (x, y) = (f.dot(first), f.dot(second));
        let shear = across * x * y;
        let difference = along * w.length_squared() + across * (x * x - y * y);
        let (sine, cosine) = libm::sincos(0.5 * libm::atan2(2.0 * shear, difference));
        cosine * first + sine * second
    }
}

/// The stress of each triangle of the balanced shape, one layer after the other.
pub(super) fn of_triangles(balance: &Balance, triangles: &[[u32; 3]], at: &[DVec3]) -> Vec<TriangleStress> {
    let of = |(triangle, own): (&[u32; 3], &PlaneStress)| {
        let [reference, now] = [&balance.reference[..], at].map(|at| triangle.map(|v| at[v as usize]));
        let found = Deformed::of(*own, reference, now);
        TriangleStress { principal: found.principal(), direction: found.direction() }
    };
    triangles.iter().zip(&balance.stresses).map(of).collect()
}

/// The range and the largest deviation of the stresses over all layers; `None` if no layer has stresses.
pub(super) fn of_all(layers: &[LayerResult]) -> Option<Stress> {
    let widen = |a: Stress, b: Stress| Stress {
        min: a.min.min(b.min),
        max: a.max.max(b.max),
        deviation: a.deviation.max(b.deviation),
        weave: a.weave,
    };
    layers.iter().filter_map(|layer| layer.stress).reduce(widen)
}

/// Returns the range of the principal stresses in a layer of the balanced shape, and their largest relative deviation.
/// In a woven film the stresses along warp and weft are compared with those required in the reference shape. In an
/// isotropic film the principal stresses are compared with the given tension. `first` is the number of the layer's
/// first triangle.
pub(super) fn stress(
    balance: &Balance,
    film: &FilmStress,
    model: &Model,
    first: usize,
    triangles: &[[u32; 3]],
    at: &[DVec3],
) -> Stress {
    let mut stress = Stress { min: f64::INFINITY, max: 0.0, deviation: 0.0, weave: None };
    let mut woven = WovenSums::default();
    for (triangle, own) in triangles.iter().zip(&balance.stresses[first..]) {
        let now = triangle.map(|v| at[v as usize]);
        let found = Deformed::of(*own, triangle.map(|v| balance.reference[v as usize]), now);
        let (least, most) = found.principal();
        (stress.min, stress.max) = (stress.min.min(least), stress.max.max(most));
        if let Some(field) = &model.stress_field {
            let normal = double_area_vector(now);
            let warp = field.required(triangle, at).direction;
            let weft = normal.normalize_or_zero().cross(warp);
            woven.add(0.5 * normal.length(), [found.along(warp), found.along(weft)], *own);
        }
    }
    match film.weave() {
        None => {
            let tension = film.mean();
            stress.deviation = (stress.max / tension - 1.0).abs().max((1.0 - stress.min / tension).abs());
        }
        Some(weave) => {
            stress.deviation = woven.largest_deviation;
            stress.weave = Some(woven.finish(weave));
        }
    }
    stress
}

/// Sums, weighted by area, and ranges over the triangles of a woven film: of the stresses along warp and weft, of the
/// ratio weft / warp, and of the deviations from the required values.
#[derive(Default)]
struct WovenSums {
    area: f64,
    warp: RangeAndSum,
    weft: RangeAndSum,
    ratio: RangeAndSum,
    squared_deviation: f64,
    largest_deviation: f64,
    squared_ratio_deviation: f64,
}

#[derive(Default)]
struct RangeAndSum {
    range: Option<(f64, f64)>,
    sum: f64,
}

impl RangeAndSum {
    fn add(&mut self, value: f64, weight: f64) {
        let (least, most) = self.range.unwrap_or((value, value));
        self.range = Some((least.min(value), most.max(value)));
        self.sum += weight * value;
    }

    fn finish(&self, area: f64) -> StressRange {
        let (min, max) = self.range.unwrap_or_default();
        StressRange { min, max, mean: self.sum / area }
    }
}

impl WovenSums {
    fn add(&mut self, area: f64, [warp, weft]: [f64; 2], required: PlaneStress) {
        let deviations = [warp / required.along - 1.0, weft / required.across - 1.0];
        let ratio = (weft / warp) / (required.across / required.along) - 1.0;
        self.area += area;
        self.warp.add(warp, area);
        self.weft.add(weft, area);
        self.ratio.add(weft / warp, area);
        self.squared_deviation += area * 0.5 * deviations.map(|d| d * d).iter().sum::<f64>();
        self.squared_ratio_deviation += area * ratio * ratio;
        self.largest_deviation = deviations.into_iter().map(f64::abs).fold(self.largest_deviation, f64::max);
    }

    fn finish(&self, weave: &Weave) -> WeaveStress {
        WeaveStress {
            hold: weave.hold,
            warp: self.warp.finish(self.area),
            weft: self.weft.finish(self.area),
            ratio: self.ratio.finish(self.area),
            required_ratio: weave.weft / weave.warp,
            ratio_deviation_rms: (self.squared_ratio_deviation / self.area).sqrt(),
            deviation_rms: (self.squared_deviation / self.area).sqrt(),
        }
    }
}
