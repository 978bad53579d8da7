//! Resampling a directrix before solving (section 2: uniformly in t, or adaptively by chordal height).

use plateau_mesh::DVec3;
use plateau_mesh::execution::{Execution, Interruption};
use plateau_mesh::order::TotalOrder;
use std::cmp::Reverse;
use std::collections::BinaryHeap;

/// How the points of a directrix are chosen from the given polyline.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Sampling {
    /// `samples` points at equal steps of t. t increases by 1 from each given point to the next.
    Parameter {
        /// Number of points.
        samples: usize,
    },
    /// `samples` points at equal distances along the polyline.
    ArcLength {
        /// Number of points.
        samples: usize,
    },
    /// A subset of the given points, chosen so that the polyline stays within `tolerance`. The point with the largest
    /// chordal height is added first, until the tolerance is met or there are `samples` points.
    ChordHeight {
        /// Largest number of points. `None` sets no limit.
        samples: Option<usize>,
        /// Largest distance of a left-out point from its chord, in the caller's unit.
        tolerance: f64,
    },
}

/// Resampled points: each lies on a segment of the input.
#[derive(Clone, Debug, PartialEq)]
pub(crate) struct Samples {
    /// For each sample the segment on which it lies and the fraction along the segment.
    pub(crate) places: Vec<(usize, f64)>,
    /// For each input point the index of the sample nearest to it along the polyline.
    pub(crate) nearest: Vec<usize>,
}

impl Samples {
    /// Returns values at the samples, interpolated linearly from the values at the input's points.
    pub(crate) fn interpolate(&self, values: &[DVec3]) -> Vec<DVec3> {
        self.places
            .iter()
            .map(|&(k, fraction)| {
                let next = values[(k + 1) % values.len()];
                if fraction == 0.0 { values[k] } else { values[k] * (1.0 - fraction) + next * fraction }
            })
            .collect()
    }
}

/// Upper bound of the number of points that sampling makes of `count` given ones.
pub(crate) fn count(count: usize, sampling: Option<Sampling>) -> usize {
    match sampling {
        _ if count < 2 => count,
        None | Some(Sampling::ChordHeight { samples: None, .. }) => count,
        Some(Sampling::Parameter { samples } | Sampling::ArcLength { samples }) => samples,
        Some(Sampling::ChordHeight { samples: Some(samples), .. }) => samples.min(count),
    }
}

/// Chooses the samples. Open directrices keep both ends, closed ones their first point. A directrix of a single point
/// stays as it is.
pub(crate) fn sample(
    points: &[DVec3],
    closed: bool,
    sampling: Sampling,
    execution: &Execution<'_>,
) -> Result<Samples, Interruption> {
    let count = points.len();
    if count < 2 {
        return Ok(Samples { places: vec![(0, 0.0); count], nearest: vec![0; count] });
    }
    match sampling {
        Sampling::Parameter { samples } => {
            let stations: Vec<f64> = (0..=count - usize::from(!closed)).map(|k| k as f64).collect();
            Ok(uniform(&stations, samples, closed))
        }
        Sampling::ArcLength { samples } => {
            let mut stations = vec![0.0];
            for k in 1..count + usize::from(closed) {
                stations.push(stations[k - 1] + points[k - 1].distance(points[k % count]));
            }
            Ok(uniform(&stations, samples, closed))
        }
        Sampling::ChordHeight { samples, tolerance } => by_chord_height(points, closed, samples, tolerance, execution),
    }
}

/// Returns samples at equal steps of `stations`, which increase along the polyline. On closed directrices the last
/// station belongs to the first point again.
fn uniform(stations: &[f64], samples: usize, closed: bool) -> Samples {
    let total = stations[stations.len() - 1];
    let steps = (if closed { samples } else { samples - 1 }) as f64;
    let mut places = Vec::with_capacity(samples);
    let mut segment = 0;
    for k in 0..samples {
        let station = total * (k as f64 / steps);
        while segment + 2 < stations.len() && stations[segment + 1] <= station {
            segment += 1;
        }
        let length = stations[segment + 1] - stations[segment];
        let fraction = if length > 0.0 { ((station - stations[segment]) / length).clamp(0.0, 1.0) } else { 0.0 };
        // A sample at a given point has fraction 0, so that it equals that point to the bit.
        places.push(if !closed && k + 1 == samples {
            (stations.len() - 1, 0.0)
        } else if fraction == 1.0 {
            (segment + 1, 0.0)
        } else {
            (segment, fraction)
        });
    }
    let points = stations.len() - usize::from(closed);
    let nearest = stations[..points]
        .iter()
        .map(|station| {
            let index = (station / total * steps).round() as usize;
            if closed { index % samples } else { index.min(samples - 1) }
        })
        .collect();
    Samples { places, nearest }
}

/// A stretch of the polyline between two kept points: the height of the point furthest from its chord, the index of its
/// first point, then the indices of its last point and of the furthest point.
type Chord = (TotalOrder, Reverse<usize>, [usize; 2]);

fn chord(points: &[DVec3], from: usize, to: usize) -> Chord {
    let (a, b) = (points[from], points[to % points.len()]);
    let chord = b - a;
    let squared = chord.length_squared();
    let (mut most, mut peak) = (0.0, from);
    for (k, point) in points.iter().enumerate().take(to).skip(from + 1) {
        let along = if squared > 0.0 { ((*point - a).dot(chord) / squared).clamp(0.0, 1.0) } else { 0.0 };
        let height = point.distance(a + chord * along);
        if height > most {
            (most, peak) = (height, k);
        }
    }
    (TotalOrder(most), Reverse(from), [to, peak])
}

/// Samples by chordal height. O(points · samples) at worst, O(points · log(samples)) on most curves.
fn by_chord_height(
    points: &[DVec3],
    closed: bool,
    samples: Option<usize>,
    tolerance: f64,
    execution: &Execution<'_>,
) -> Result<Samples, Interruption> {
    let count = points.len();
    let most = samples.unwrap_or(count).max(if closed { 3 } else { 2 });
    let mut kept = vec![false; count];
    kept[0] = true;
    let mut heap = BinaryHeap::new();
    if closed {
        // A closed polygon needs two points besides the first: the point furthest from the first one, and later the
        // point furthest from the chord between these two.
        let furthest = (1..count)
            .fold(1, |best, k| if points[k].distance(points[0]) > points[best].distance(points[0]) { k } else { best });
        kept[furthest] = true;
        heap.push(chord(points, 0, furthest));
        heap.push(chord(points, furthest, count));
    } else {
        kept[count - 1] = true;
        heap.push(chord(points, 0, count - 1));
    }
    let mut chosen = 2;
    while let Some((TotalOrder(height), Reverse(from), [to, peak])) = heap.pop() {
        let needed = height > tolerance || (closed && chosen < 3);
        if chosen >= most || !needed || peak == from {
            break;
        }
        kept[peak] = true;
        chosen += 1;
        execution.look((to - from) as u64)?;
        heap.push(chord(points, from, peak));
        heap.push(chord(points, peak, to));
    }
    let places: Vec<(usize, f64)> = (0..count).filter(|&k| kept[k]).map(|k| (k, 0.0)).collect();
    let nearest = (0..count)
        .map(|k| {
            let after = places.partition_point(|&(at, _)| at < k);
            let distance = |s: usize| places[s % places.len()].0.abs_diff(k);
            if after == places.len() || (after > 0 && distance(after - 1) <= distance(after)) {
                after - 1
            } else {
                after
            }
        })
        .collect();
    Ok(Samples { places, nearest })
}
