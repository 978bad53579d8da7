//! The lower bound of the area: its figures in the statistics, and the document that proves it.

use crate::common::Point;
use plateau_lower_bound as lower_bound;
use plateau_lower_bound::{Field, LowerBound};
use schemars::JsonSchema;
use serde::Serialize;

/// Above this gap the statement adds that the film is not proven to be the global minimum.
const LARGE_GAP: f64 = 0.05;

/// A proven lower bound of the area of all oriented surfaces with this boundary. With more than six boundaries it covers
/// only the surfaces that run along them in the directions of the film.
#[derive(Clone, Debug, Serialize, JsonSchema)]
pub struct Certificate {
    /// No oriented surface of any topology with this boundary has a smaller area, if it runs along the boundaries in
    /// directions that `every_orientation` and `reversed_loops` name.
    pub area_lower_bound: f64,
    /// The film's area is at most this fraction above the least area of these surfaces. Null if the bound is 0.
    pub gap: Option<f64>,
    /// Whether the bound covers every direction in which a surface can run along each boundary. If false, it covers the
    /// directions of the film only, and surfaces in other directions may have less area.
    pub every_orientation: bool,
    /// If `every_orientation` is false: numbers of the boundaries that the film runs along against the direction of the
    /// request, if it runs along boundary 0 in that direction. The bound covers these directions, and all of them
    /// reversed together. Null otherwise.
    pub reversed_loops: Option<Vec<usize>>,
    /// The surfaces for which the bound holds.
    pub scope: String,
    /// Number of nominal seconds to which the work of the search amounts. No clock is read, so that the result is the same
    /// on every machine.
    pub seconds: f64,
    pub iterations: u32,
    /// Number of tetrahedra of all fields together.
    pub tetrahedra: usize,
    /// Number of orientations of the loops for which a field was found.
    pub orientations: usize,
    /// The result in words.
    pub statement: String,
}

pub(super) fn gap(area: f64, bound: f64) -> Option<f64> {
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
            "No oriented surface of any topology with this boundary that runs along its loops in the directions of this \
             film ({}) has an area below {bound}; this film is at most {percent}% above the least area of these surfaces. \
             Surfaces that run along the loops in other directions may have less area.{unproven}",
            directions(&found.reversed_loops)
        );
    }
    let proven = format!(
        "No oriented surface of any topology with this boundary has an area below {bound}; this film is at most {percent}% \
         above the global minimum."
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
            "oriented surfaces (integral currents) of any topology bounded by exactly these polygons, {directions}. Films \
             without an orientation (Möbius bands) and films with triple junctions are not included."
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
        let frame =
            |of: lower_bound::Frame| Frame { origin: of.origin.to_array(), axes: of.axes.map(|axis| axis.to_array()) };
        let mirror = |of: &lower_bound::Mirror| Mirror { axis: ['x', 'y', 'z'][of.axis], at: of.at, sign: of.sign };
        let orientation = |field: &'a Field| Orientation {
            loops: field.loops.iter().map(|points| points.iter().map(|p| p.to_array()).collect()).collect(),
            area_lower_bound: field.area_lower_bound,
            frame: field.frame.map(frame),
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
