//! Mean curvature and residual of a film, from the gradient of its area.

use super::comparison::Audit;
use super::figure::{Largest, Measured};
use super::surface::Surface;
use plateau_archive::archive::MEAN_CURVATURE;

/// Relative error that a stated curvature or residual may have.
const RELATIVE: f64 = 0.1;

/// Mean curvature at one vertex, and how far rounding of the coordinates changes it, in 1/unit.
#[derive(Clone, Copy, Debug)]
struct AtVertex {
    full: f64,
    normal: f64,
    tolerance: f64,
}

/// Compares the residuals and curvatures of a film without junctions. Its free vertices are those that `is_fixed` does
/// not mark.
pub(crate) fn compare(audit: &mut Audit, surface: &Surface, is_fixed: &[bool], radius: f64, tolerance: f64) {
    let rounding = audit.step;
    let found: Vec<AtVertex> = surface
        .rings
        .iter()
        .map(|ring| {
            // The mass of a vertex is a third of the area of its ring.
            let double_mass = ring.double_area / 3.0;
            let full = ring.gradient.length() / double_mass;
            let normal = ring.gradient.dot(ring.normal.normalize_or_zero()).abs() / double_mass;
            if ring.is_degenerate {
                // At the corner of a triangle without area the curvature consists of rounding errors. The infinite
                // tolerance makes the audit accept any stated value.
                return AtVertex { full: 0.0, normal: 0.0, tolerance: f64::INFINITY };
            }
            AtVertex { full, normal, tolerance: rounding * ring.steepness * ring.steepness }
        })
        .collect();
    let free = || found.iter().zip(is_fixed).filter(|(_, fixed)| !**fixed).map(|(at, _)| at);
    let count = free().count();
    let (mut residual, mut full) = (Largest::NONE, Largest::NONE);
    let (mut sum, mut squares, mut error, mut square_error) = (0.0, 0.0, 0.0, 0.0);
    for at in free() {
        let own = RELATIVE * at.full + at.tolerance;
        residual.add(at.normal, RELATIVE * at.normal + at.tolerance);
        full.add(at.full, own);
        sum += at.full;
        squares += at.full * at.full;
        error += own;
        square_error += own * own;
    }
    let scale = 1.0 / count.max(1) as f64;
    let below = tolerance.max(radius * rounding * scale);
    audit.figure_or_below("/residual", residual.measured().times(radius), below);
    audit.figure_or_below("/residual_full", full.measured().times(radius), below);
    let curvature_below = if radius > 0.0 { below / radius } else { 0.0 };
    audit.figure_or_below("/mean_curvature/max", full.measured(), curvature_below);
    audit.figure_or_below("/mean_curvature/mean", Measured::within(sum * scale, error * scale), curvature_below);
    let rms = Measured::within((squares * scale).sqrt(), (square_error * scale).sqrt());
    audit.figure_or_below("/mean_curvature/rms", rms, curvature_below);
    let Some(stated) = audit.contents.at_vertices(MEAN_CURVATURE) else {
        audit.require(false, || "the mesh has its mean curvature".into(), || "it has none".into());
        return;
    };
    for (v, (at, &stated)) in found.iter().zip(&stated.values).enumerate() {
        let measured = if is_fixed[v] {
            Measured::within(0.0, 0.0)
        } else {
            Measured::within(at.full, RELATIVE * at.full + at.tolerance + curvature_below)
        };
        audit.attribute(|| format!("{MEAN_CURVATURE} of vertex {v}"), stated, measured);
    }
}
