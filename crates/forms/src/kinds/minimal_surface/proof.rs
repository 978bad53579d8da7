//! The search for a lower bound of the area, its figures in words, and the document that proves the bound.

use super::certificate::{Certificate, CertifyOptions, Proof};
use super::statistics::MinimalStatistics;
use crate::common::Point;
use crate::solved::to_json;
use plateau_archive::Attribute;
use plateau_archive::archive::LOWER_BOUND_SLACK;
use plateau_film::minimal_surface::MinimalSurface;
use plateau_lower_bound as lower_bound;
use plateau_lower_bound::{Field, LowerBound};
use plateau_mesh::error::Warning;
use plateau_mesh::{DVec3, Error, Execution};
use serde::Serialize;

/// Returns the memory that the search for a bound takes.
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
        film.warnings.push(Warning::new("no_certificate", detail));
        Ok(Proof::default())
    };
    if film.statistics.junctions.is_some() {
        return without("the film has triple junctions, and the bound holds for oriented surfaces only");
    }
    let Some(bound) = lower_bound::certify(boundaries, &film.mesh, &options.into(), exec)? else {
        return without("the coordinates are too large for the boundary's size, or the film has no area");
    };
    statistics.certify(&bound);
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
    /// Adds the bound, and how far each compared topology is from the least area at most. Another topology may run
    /// along the loops in other directions than the film, so that it is compared only with a bound for every
    /// orientation.
    fn certify(&mut self, found: &LowerBound) {
        self.certificate = Some(Certificate::of(found, self.area));
        if found.every_orientation {
            for topology in self.spanning.iter_mut().flat_map(|spanning| &mut spanning.topologies) {
                topology.gap = topology.area.and_then(|area| gap(area, found.area));
            }
        }
    }
}

/// Above this gap the statement adds that the film is not proven to be the global minimum.
const LARGE_GAP: f64 = 0.05;

fn gap(area: f64, bound: f64) -> Option<f64> {
    Some(area / bound - 1.0).filter(|gap| bound > 0.0 && gap.is_finite()).map(|gap| gap.max(0.0))
}

/// Returns the directions in words.
fn directions(reversed: &[usize]) -> String {
    let numbers: Vec<String> = reversed.iter().map(ToString::to_string).collect();
    match numbers.len() {
        0 => "all as in the request, or all reversed".into(),
        1 => format!("number {} against the request and the others as in it, or all reversed", numbers[0]),
        _ => format!("numbers {} against the request and the others as in it, or all reversed", numbers.join(", ")),
    }
}

/// Returns the result in words. The film is at most `percent` above the least area of the surfaces that are covered.
fn statement(found: &LowerBound, percent: f64, is_large: bool) -> String {
    let bound = found.area;
    let unproven = " It is not proven that this film is the global minimum.";
    if !found.every_orientation {
        return format!(
            "No oriented surface of any topology with this boundary that runs along its loops in the directions of \
             this film ({}) has an area below {bound}; this film is at most {percent}% above the least area of these \
             surfaces. Surfaces that run along the loops in other directions may have less area.{unproven}",
            directions(&found.reversed_loops)
        );
    }
    let proven = format!(
        "No oriented surface of any topology with this boundary has an area below {bound}; this film is at most \
         {percent}% above the global minimum."
    );
    if is_large { proven + unproven } else { proven }
}

impl Certificate {
    /// Returns the certificate of a film with this area.
    #[must_use]
    pub fn of(found: &LowerBound, area: f64) -> Self {
        let directions = if found.every_orientation {
            "in whichever direction each loop is traversed".into()
        } else {
            format!("with the loops in the directions of the film ({})", directions(&found.reversed_loops))
        };
        let scope = format!(
            "oriented surfaces (integral currents) of any topology bounded by exactly these polygons, {directions}. \
             Films without an orientation (Möbius bands) and films with triple junctions are not included."
        );
        let bound = found.area;
        let gap = gap(area, bound);
        let statement = match gap {
            // The percentage is rounded up, so that the statement stays true.
            Some(gap) => statement(found, (gap * 1e5).ceil() / 1e3, gap > LARGE_GAP),
            None => "No lower bound above 0 was found, so nothing is proven.".into(),
        };
        Self {
            area_lower_bound: bound,
            gap,
            every_orientation: found.every_orientation,
            reversed_loops: (!found.every_orientation).then(|| found.reversed_loops.clone()),
            scope,
            seconds: found.seconds,
            iterations: found.iterations,
            tetrahedra: found.fields.iter().map(|field| field.tetrahedra.len()).sum(),
            orientations: found.fields.len(),
            statement,
        }
    }
}

/// The axes of a field.
#[derive(Clone, Debug, Serialize)]
struct Frame {
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

/// The field for one orientation of the loops.
#[derive(Clone, Debug, Serialize)]
struct Orientation<'a> {
    loops: Vec<Vec<Point>>,
    area_lower_bound: f64,
    frame: Option<Frame>,
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
    every_orientation: bool,
    orientations: Vec<Orientation<'a>>,
}

impl<'a> CertificateDocument<'a> {
    /// Returns the document of a lower bound.
    #[must_use]
    pub fn of(found: &'a LowerBound) -> Self {
        let frame = |axes: lower_bound::Axes| Frame {
            origin: axes.origin.to_array(),
            axes: axes.directions.map(|direction| direction.to_array()),
        };
        let mirror = |of: &lower_bound::Mirror| Mirror { axis: ['x', 'y', 'z'][of.axis], at: of.at, sign: of.sign };
        let orientation = |field: &'a Field| Orientation {
            loops: field.loops.iter().map(|points| points.iter().map(|p| p.to_array()).collect()).collect(),
            area_lower_bound: field.area_lower_bound,
            frame: field.axes.map(frame),
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
        Self {
            area_lower_bound: found.area,
            every_orientation: found.every_orientation,
            orientations: found.fields.iter().map(orientation).collect(),
        }
    }
}
