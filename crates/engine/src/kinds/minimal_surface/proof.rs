//! The search for a lower bound of the area, its figures in words, and the document that proves the bound.

use super::certificate::{Certificate, CertifyOptions, Proof};
use super::statistics::MinimalStatistics;
use crate::common::Point;
use crate::solved::to_json;
use plateau_archive::Attribute;
use plateau_archive::archive::LOWER_BOUND_SLACK;
use plateau_lower_bound as lower_bound;
use plateau_lower_bound::{Field, LowerBound};
use plateau_mesh::codes::{Reason, WarningCode};
use plateau_mesh::error::Warning;
use plateau_mesh::{DVec3, Error, Execution};
use plateau_minimal_surface::MinimalSurface;
use serde::Serialize;

/// Returns an estimate of the memory in bytes that the search for a bound takes.
pub(super) fn memory_bytes(boundaries: usize, options: CertifyOptions) -> u64 {
    lower_bound::memory_bytes(boundaries, &options.into())
}

/// Searches for a lower bound of a film's area and adds its figures to the statistics. A film without a bound gets a
/// warning.
///
/// # Errors
/// Fails if the search is cancelled.
pub(super) fn search(
    boundaries: &[Vec<DVec3>],
    film: &mut MinimalSurface,
    options: CertifyOptions,
    statistics: &mut MinimalStatistics,
    exec: &Execution,
) -> Result<Proof, Error> {
    let mut without = |reason: &str| {
        let detail = format!("no lower bound was computed: {reason}");
        film.warnings.push(Warning::new(WarningCode::NoCertificate, detail));
        Ok(Proof::default())
    };
    if film.statistics.junctions.is_some() {
        return without("the film has triple junctions, and the bound holds for oriented surfaces only");
    }
    let Some(bound) = lower_bound::certify(boundaries, &film.mesh, &options.into(), exec)? else {
        return without(
            "the coordinates are too large for the boundary's size, the film has no area, or its border does not run \
             along the boundaries",
        );
    };
    statistics.certify(&bound)?;
    Ok(Proof {
        document: Some(to_json(&CertificateDocument::of(&bound))?),
        interrupted: bound.interrupted,
        slack: Some(Attribute { range: [0.0, 1.0], ..Attribute::new(LOWER_BOUND_SLACK, "", bound.slack) }),
    })
}

impl From<CertifyOptions> for lower_bound::Options {
    fn from(CertifyOptions { gap, seconds }: CertifyOptions) -> Self {
        Self::default().with_gap(gap.get()).with_seconds(seconds.get())
    }
}

impl MinimalStatistics {
    /// Adds the bound to the statistics, and for each compared topology the largest possible excess of its area over
    /// the least area.
    ///
    /// # Errors
    /// Returns the error of [`gap`].
    fn certify(&mut self, found: &LowerBound) -> Result<(), Error> {
        self.certificate = Some(Certificate::of(found, self.area)?);
        for topology in self.spanning.iter_mut().flat_map(|spanning| &mut spanning.topologies) {
            topology.gap = topology.solved.area.map_or(Ok(None), |area| gap(area, found.area))?;
        }
        Ok(())
    }
}

/// Gap, as a fraction of the bound, above which the statement adds that the film is not proven to be the global
/// minimum.
const LARGE_GAP: f64 = 0.05;

/// Largest difference, as a fraction of the bound, by which rounding and merged points can make an area less than the
/// bound.
const ROUNDED: f64 = 1e-6;

/// Returns the excess of an area over a bound, relative to the bound; `None` for a bound of 0.
///
/// # Errors
/// Fails with [`Error::NoResult`] if the area is below the bound by more than [`ROUNDED`]. Either the bound or the area
/// is wrong then, and there must be no result.
fn gap(area: f64, bound: f64) -> Result<Option<f64>, Error> {
    match area / bound - 1.0 {
        _ if bound <= 0.0 => Ok(None),
        gap if gap.is_finite() && gap >= -ROUNDED => Ok(Some(gap.max(0.0))),
        _ => Err(Error::no_result(Reason::Internal, format!("the area {area} is below the proven bound {bound}"))),
    }
}

/// Returns the result in words. `percent` is the largest possible excess of the film's area over the global minimum.
fn statement(bound: f64, percent: f64, is_large: bool) -> String {
    let proven = format!(
        "No oriented surface of any topology with this boundary has an area below {bound}; this film is at most \
         {percent}% above the global minimum."
    );
    if is_large { proven + " It is not proven that this film is the global minimum." } else { proven }
}

impl Certificate {
    /// Returns the certificate of a film with this area.
    ///
    /// # Errors
    /// Fails with [`Error::NoResult`] if the area is below the bound.
    pub fn of(found: &LowerBound, area: f64) -> Result<Self, Error> {
        let scope = "oriented surfaces (integral currents) of any topology bounded by exactly these polygons, in \
                     whichever direction each loop is traversed. Films without an orientation (Möbius bands) and films \
                     with triple junctions are not included."
            .into();
        let bound = found.area;
        let gap = gap(area, bound)?;
        let statement = match gap {
            // The percentage is rounded up, so that the statement stays true.
            Some(gap) => statement(bound, (gap * 1e5).ceil() / 1e3, gap > LARGE_GAP),
            None => "No lower bound above 0 was found, so nothing is proven.".into(),
        };
        Ok(Self {
            area_lower_bound: bound,
            gap,
            scope,
            seconds: found.seconds,
            iterations: found.iterations,
            tetrahedra: found.fields.iter().map(|field| field.tetrahedra.len()).sum(),
            orientations: found.fields.len(),
            statement,
        })
    }
}

/// The coordinate system of a field.
#[derive(Clone, Debug, Serialize)]
struct FieldAxes {
    origin: Point,
    axes: [Point; 3],
}

/// A plane of symmetry of a field.
#[derive(Clone, Debug, Serialize)]
struct Mirror {
    axis: char,
    at: f64,
    sign: i8,
}

/// The vector field that proves the bound for one orientation of the boundary loops.
#[derive(Clone, Debug, Serialize)]
struct Orientation<'a> {
    loops: Vec<Vec<Point>>,
    free_loops: &'a [usize],
    area_lower_bound: f64,
    frame: Option<FieldAxes>,
    r#box: [Point; 2],
    mirrors: Vec<Mirror>,
    vertices: Vec<Point>,
    tetrahedra: &'a [[u32; 4]],
    edges: &'a [[u32; 2]],
    edge_values: &'a [f64],
    faces: &'a [[u32; 3]],
    face_values: &'a [[f64; 2]],
    half_spaces: Vec<Point>,
    unconstrained: &'a [[u32; 2]],
}

/// The proof, which `scripts/check_certificate.py` reads and confirms.
#[derive(Clone, Debug, Serialize)]
pub struct CertificateDocument<'a> {
    area_lower_bound: f64,
    orientations: Vec<Orientation<'a>>,
}

impl<'a> CertificateDocument<'a> {
    /// Returns the document of a lower bound.
    #[must_use]
    pub fn of(found: &'a LowerBound) -> Self {
        let field_axes = |axes: lower_bound::Axes| FieldAxes {
            origin: axes.origin.to_array(),
            axes: axes.directions.map(|direction| direction.to_array()),
        };
        let mirror = |of: &lower_bound::Mirror| Mirror { axis: ['x', 'y', 'z'][of.axis], at: of.at, sign: of.sign };
        let orientation = |field: &'a Field| Orientation {
            loops: field.loops.iter().map(|points| points.iter().map(|p| p.to_array()).collect()).collect(),
            free_loops: &field.free_loops,
            area_lower_bound: field.area_lower_bound,
            frame: field.axes.map(field_axes),
            r#box: field.corners.map(|corner| corner.to_array()),
            mirrors: field.mirrors.iter().map(mirror).collect(),
            vertices: field.vertices.iter().map(|vertex| vertex.to_array()).collect(),
            tetrahedra: &field.tetrahedra,
            edges: &field.edges,
            edge_values: &field.edge_values,
            faces: &field.faces,
            face_values: &field.face_values,
            half_spaces: field.half_spaces.iter().map(|direction| direction.to_array()).collect(),
            unconstrained: &field.unconstrained,
        };
        Self { area_lower_bound: found.area, orientations: found.fields.iter().map(orientation).collect() }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn an_area_below_its_bound_is_an_error_and_rounding_is_no_gap() {
        assert_eq!(gap(1.02, 1.0).unwrap(), Some(1.02 - 1.0));
        assert_eq!(gap(1.0 - 1e-9, 1.0).unwrap(), Some(0.0));
        assert_eq!(gap(1.0, 0.0).unwrap(), None);
        for area in [0.999_99, 0.0, f64::NAN] {
            assert!(matches!(gap(area, 1.0), Err(Error::NoResult { reason: Reason::Internal, .. })), "{area}");
        }
    }
}
