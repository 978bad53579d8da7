//! Remeshing of a structure while its corners and edges move.
//!
//! A stretch is a part of a boundary, or of a line across the film, along which the same cable and the same support
//! run. A boundary vertex is kept if the film is held there, if two stretches meet there, if a cable ends there, or if
//! the point moves by itself. All other boundary vertices move along their stretch. Any vertex inside a stretch may
//! become the vertex of an input point there, because only their order distinguishes the input points of a stretch.

use super::model::{Model, ModelCable};
use super::options::{Cable, Course, Pressure, SlidingPart, Structure};
use plateau_equilibrium::Freedom;
use plateau_mesh::execution::WORK_PER_TRIANGLE;
use plateau_mesh::remesh::delaunay::{flip_to_delaunay, tangential_relaxation};
use plateau_mesh::remesh::moving::{Curve, Kind, MovingFilm, Neck};
use plateau_mesh::{DVec3, Execution, Interruption};
use std::collections::{BTreeMap, BTreeSet};

/// Number of rounds of relaxation and edge flips that even out the triangles of the mesh on the last level.
const POLISHES: u32 = 4;
/// Largest acceptable angle of a triangle, in radians; it is 137°. A mesh with a larger angle is remeshed: that of a
/// travelling structure on the finest level, once Newton's method has converged on the mesh.
pub(super) const WORN_ANGLE: f64 = 2.4;
/// Minimum number of vertices inside a stretch.
const FEWEST: usize = 3;

/// The cable and the support that run along an edge of a boundary, if there are any.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
struct Along {
    cable: Option<usize>,
    support: Option<usize>,
}

/// The fineness of a remeshed film.
#[derive(Clone, Copy, Debug)]
pub(super) struct Fineness {
    /// Target edge length.
    pub size: f64,
    pub rounds: u32,
    /// Whether every point of the input gets a vertex of its own.
    pub all_points: bool,
}

/// The boundaries of a film and the lines across it, which remeshing preserves.
struct Outline {
    /// The kind of each vertex of the film.
    kinds: Vec<Kind>,
    curves: Vec<Curve>,
    /// For each stretch the number of the support on which it slides. Stretch 0 consists of all edges that are held.
    supports: Vec<Option<usize>>,
    /// For each stretch whether its vertices move along it.
    flexible: Vec<bool>,
}

impl Outline {
    /// Begins a stretch that moves, and returns its number.
    fn begin(&mut self, support: Option<usize>) -> u32 {
        self.supports.push(support);
        self.flexible.push(true);
        self.flexible.len() as u32 - 1
    }

    /// Adds a boundary loop. `along` holds the cable and the support of each of its edges. The vertices in `named` are
    /// kept.
    fn add_rim(&mut self, rim: &[u32], along: &[Along], named: &BTreeSet<u32>) {
        let count = rim.len();
        let is_kept = |k: usize| {
            let (before, after) = (along[(k + count - 1) % count], along[k]);
            before != after || after == Along::default() || named.contains(&rim[k])
        };
        let first = (0..count).find(|&k| is_kept(k)).unwrap_or(0);
        let mut curve = Curve { vertices: Vec::with_capacity(count), stretches: Vec::with_capacity(count) };
        let mut stretch = None;
        for k in (0..count).map(|k| (first + k) % count) {
            let kept = is_kept(k);
            let own = match stretch {
                Some(stretch) if !kept => stretch,
                _ if along[k] == Along::default() => 0,
                _ => self.begin(along[k].support),
            };
            stretch = Some(own);
            self.kinds[rim[k] as usize] = if kept { Kind::Kept } else { Kind::Along(own) };
            curve.vertices.push(rim[k]);
            curve.stretches.push(own);
        }
        self.curves.push(curve);
    }

    /// Adds a line across the film. `crossed` holds the inner vertices of the lines that were added before, and those
    /// of this line are added to it. A vertex where two lines cross is kept.
    fn add_line(&mut self, chain: &[u32], crossed: &mut BTreeSet<u32>) {
        let mut curve = Curve { vertices: chain.to_vec(), stretches: Vec::new() };
        let mut stretch = 0;
        for (k, &v) in chain.iter().enumerate() {
            let is_end = k == 0 || k + 1 == chain.len();
            let is_kept = is_end || self.kinds[v as usize] != Kind::Inside || crossed.contains(&v);
            if is_kept {
                stretch = self.begin(None);
            }
            if !is_end {
                self.kinds[v as usize] = if is_kept { Kind::Kept } else { Kind::Along(stretch) };
                crossed.insert(v);
            }
            if k + 1 < chain.len() {
                curve.stretches.push(stretch);
            }
        }
        self.curves.push(curve);
    }
}

impl Model {
    /// The cable and the support of each edge of each boundary.
    fn parts(&self, structure: &Structure) -> Vec<Vec<Along>> {
        let mut parts: Vec<Vec<Along>> =
            self.boundaries().iter().map(|rim| vec![Along::default(); rim.len()]).collect();
        let mut mark = |boundary: usize, first: u32, last: u32, set: &dyn Fn(&mut Along)| {
            let rim = &self.boundaries()[boundary];
            let place = |v: u32| rim.iter().position(|&w| w == v).unwrap_or_default();
            let (mut k, end) = (place(first), place(last));
            // At most one pass per edge of the rim, because k goes around the rim once.
            loop {
                set(&mut parts[boundary][k]);
                k = (k + 1) % rim.len();
                if k == end {
                    break;
                }
            }
        };
        for (k, (cable, own)) in structure.cables.iter().zip(&self.cables).enumerate() {
            if let Course::Boundary { boundary, .. } = cable.course {
                let [from, to] = own.ends();
                mark(boundary, from, to, &|along| along.cable = Some(k));
            }
        }
        for (k, sliding) in structure.sliding.iter().enumerate() {
            match sliding.part {
                SlidingPart::Point(_) => {}
                SlidingPart::Edge { boundary, from, to } => {
                    let [first, last] = [from, to].map(|point| self.input_vertices[boundary][point]);
                    mark(boundary, first, last, &|along| along.support = Some(k));
                }
                SlidingPart::Boundary(boundary) => {
                    let first = self.boundaries()[boundary][0];
                    mark(boundary, first, first, &|along| along.support = Some(k));
                }
            }
        }
        parts
    }

    /// The boundary vertices that remeshing must keep although they may move: ends of cables, free points, sliding
    /// points and the ends of sliding edges.
    fn named(&self, structure: &Structure) -> BTreeSet<u32> {
        let ends = self.cables.iter().flat_map(ModelCable::ends);
        let points = structure.sliding.iter().filter_map(|sliding| match sliding.part {
            SlidingPart::Point(point) => Some(self.input_vertex(point)),
            SlidingPart::Edge { .. } | SlidingPart::Boundary(_) => None,
        });
        let edges = structure.sliding.iter().flat_map(|sliding| match sliding.part {
            SlidingPart::Edge { boundary, from, to } => {
                [from, to].map(|point| Some(self.input_vertices[boundary][point]))
            }
            SlidingPart::Point(_) | SlidingPart::Boundary(_) => [None; 2],
        });
        let films = self.films as u32;
        let all = ends.chain(self.free.iter().copied()).chain(points).chain(edges.flatten());
        all.filter(|&v| v < films).collect()
    }

    /// Remeshes the film. Returns the narrowest neck, if the film has any.
    pub fn remesh(
        &mut self,
        structure: &Structure,
        fineness: Fineness,
        exec: &Execution,
    ) -> Result<Option<Neck>, Interruption> {
        let Outline { kinds, curves, supports, flexible } = self.outline(structure);
        let inside = self.points_inside(&kinds, &curves, flexible.len());
        let points = |stretch: usize| if fineness.all_points { inside[stretch].len() } else { 0 };
        let fewest = (0..flexible.len()).map(|stretch| points(stretch).max(FEWEST)).collect();
        let before: Vec<u32> = (0..).zip(&kinds).filter(|(_, kind)| **kind == Kind::Kept).map(|(v, _)| v).collect();
        let film = self.layers[0].film.clone();
        let mut moving = MovingFilm { film, kinds, curves, flexible, fewest, named: before.clone() };
        moving.renew_curves();
        let onto = |stretch: u32, place: DVec3| match supports[stretch as usize] {
            Some(support) => self.supports[support].nearest(place),
            None => place,
        };
        let neck = moving.remesh(fineness.size, fineness.rounds, &onto, exec)?;
        if fineness.all_points {
            for _ in 0..POLISHES {
                exec.look(WORK_PER_TRIANGLE * moving.film.triangles().len() as u64)?;
                tangential_relaxation(&mut moving.film, 1);
                flip_to_delaunay(&mut moving.film, exec)?;
            }
        }
        let mut number: BTreeMap<u32, u32> = before.into_iter().zip(moving.named.iter().copied()).collect();
        // The points inside a stretch are spread evenly over its vertices.
        let mut present = vec![Vec::new(); moving.flexible.len()];
        for &v in moving.curves.iter().flat_map(|curve| &curve.vertices) {
            if let Kind::Along(stretch) = moving.kinds[v as usize] {
                present[stretch as usize].push(v);
            }
        }
        for (points, vertices) in inside.iter().zip(&present) {
            for (k, &point) in points.iter().enumerate() {
                number.insert(point, vertices[(2 * k + 1) * vertices.len() / (2 * points.len())]);
            }
        }
        self.take(structure, moving, |v| number.get(&v).copied());
        Ok(neck)
    }

    /// The boundaries and the lines across the film as curves of stretches, boundaries first.
    fn outline(&self, structure: &Structure) -> Outline {
        let named = self.named(structure);
        let film = &self.layers[0].film;
        let mut outline = Outline {
            kinds: vec![Kind::Inside; film.vertices.len()],
            curves: Vec::new(),
            supports: vec![None],
            flexible: vec![false],
        };
        for (rim, along) in film.boundaries.iter().zip(&self.parts(structure)) {
            outline.add_rim(rim, along, &named);
        }
        let mut crossed = BTreeSet::new();
        for (cable, own) in structure.cables.iter().zip(&self.cables) {
            if matches!(cable.course, Course::Across(_)) {
                outline.add_line(&own.chain, &mut crossed);
            }
        }
        outline
    }

    /// For each stretch the input points inside it, in the order along the boundary. Where a later line crosses an
    /// earlier one, the crossing vertex is kept but lies inside a stretch of the earlier line, because its edges stay
    /// one stretch.
    fn points_inside(&self, kinds: &[Kind], curves: &[Curve], stretches: usize) -> Vec<Vec<u32>> {
        let mut inside = vec![Vec::new(); stretches];
        for (points, rim) in self.input_vertices.iter().zip(curves) {
            let place: BTreeMap<u32, usize> = rim.vertices.iter().enumerate().map(|(k, &v)| (v, k)).collect();
            let mut own: Vec<u32> = points.clone();
            own.sort_unstable_by_key(|v| place.get(v));
            own.dedup();
            for v in own {
                if let Kind::Along(stretch) = kinds[v as usize] {
                    inside[stretch as usize].push(v);
                }
            }
        }
        inside
    }

    /// Replaces the film by the remeshed one. `number` gives the new number of every old film vertex that the model
    /// refers to.
    fn take(&mut self, structure: &Structure, moving: MovingFilm, number: impl Fn(u32) -> Option<u32>) {
        let (old, new) = (self.films as u32, moving.film.vertices.len() as u32);
        let renumbered = |v: u32| if v >= old { v - old + new } else { number(v).unwrap_or(0) };
        let boundaries = moving.film.boundaries.len();
        self.layers[0].film = moving.film;
        self.layers[0].numbers = (0..new).collect();
        self.films = new as usize;
        self.input_vertices.iter_mut().flatten().for_each(|v| *v = renumbered(*v));
        self.free.iter_mut().for_each(|v| *v = renumbered(*v));
        for (structure, ring) in structure.rings.iter().zip(&mut self.rings) {
            let mut vertices = self.layers[0].film.boundaries[structure.boundary].clone();
            vertices.extend(structure.hub.and_then(|_| ring.vertices.last()).map(|&hub| renumbered(hub)));
            ring.vertices = vertices;
        }
        let mut lines = moving.curves.into_iter().skip(boundaries);
        for k in 0..self.cables.len() {
            let chain = &self.cables[k].chain;
            let chain = match structure.cables[k].course {
                Course::Boundary { boundary, .. } => {
                    let ends = self.cables[k].ends().map(renumbered);
                    self.between(boundary, ends)
                }
                Course::Across(_) => lines.next().map(|curve| curve.vertices).unwrap_or_default(),
                Course::Air(_) | Course::Mast(_) => chain.iter().map(|&v| renumbered(v)).collect(),
            };
            self.cables[k].set_chain(chain);
        }
        self.renew_sliding(structure);
        self.renew_stress_field(structure);
    }

    fn renew_sliding(&mut self, structure: &Structure) {
        let mut sliding = Vec::new();
        for (number, part) in (0u32..).zip(&structure.sliding) {
            let (vertices, closed) = match part.part {
                SlidingPart::Point(point) => {
                    sliding.push((self.input_vertex(point), Freedom::On(number)));
                    continue;
                }
                SlidingPart::Edge { boundary, from, to } => {
                    let ends = [from, to].map(|point| self.input_vertices[boundary][point]);
                    (self.between(boundary, ends), false)
                }
                SlidingPart::Boundary(boundary) => (self.boundaries()[boundary].clone(), true),
            };
            let count = vertices.len();
            for k in if closed { 0..count } else { 1..count - 1 } {
                let beside = [vertices[(k + count - 1) % count], vertices[(k + 1) % count]];
                sliding.push((vertices[k], Freedom::AcrossOn { support: number, beside }));
            }
        }
        self.sliding = sliding;
    }

    /// The vertices of a boundary loop from `first` to `last`, both included.
    fn between(&self, boundary: usize, [first, last]: [u32; 2]) -> Vec<u32> {
        let rim = &self.boundaries()[boundary];
        let place = |v: u32| rim.iter().position(|&w| w == v).unwrap_or_default();
        let count = (place(last) + rim.len() - place(first)) % rim.len();
        (0..=count).map(|k| rim[(place(first) + k) % rim.len()]).collect()
    }

    /// Renumbers the vertices so that the input points come first, in their order, and rotates every boundary loop so
    /// that it begins with its first input point.
    pub fn order_input_first(&mut self, structure: &Structure) {
        let count = self.films;
        let mut place = vec![u32::MAX; count];
        let mut next = 0;
        let rims = self.boundaries().iter().flatten();
        for &v in self.input_vertices.iter().flatten().chain(rims) {
            if place[v as usize] == u32::MAX {
                place[v as usize] = next;
                next += 1;
            }
        }
        for own in &mut place {
            if *own == u32::MAX {
                *own = next;
                next += 1;
            }
        }
        let renumbered = |v: u32| place.get(v as usize).copied().unwrap_or(v);
        let film = self.layers[0].film.clone().renumbered(&place);
        self.layers[0].film = film;
        let points = self.input_vertices.iter_mut().flatten();
        let rings = self.rings.iter_mut().flat_map(|ring| &mut ring.vertices);
        points
            .chain(&mut self.free)
            .chain(self.cables.iter_mut().flat_map(|cable| &mut cable.chain))
            .chain(rings)
            .for_each(|v| *v = renumbered(*v));
        for (points, rim) in self.input_vertices.iter().zip(&mut self.layers[0].film.boundaries) {
            let first = points.first().and_then(|first| rim.iter().position(|v| v == first)).unwrap_or(0);
            rim.rotate_left(first);
        }
        for cable in &mut self.cables {
            let chain = std::mem::take(&mut cable.chain);
            cable.set_chain(chain);
        }
        self.renew_sliding(structure);
        let factors = self.stress_field.take().map(|field| field.factors);
        self.renew_stress_field(structure);
        if let (Some(field), Some(factors)) = (&mut self.stress_field, factors) {
            factors.into_iter().zip(&place).for_each(|(factor, &v)| field.factors[v as usize] = factor);
        }
    }
}

/// Whether the structure can be remeshed while it moves: a single layer without contact angles. The layers of a cushion
/// share their edges, and no springs bound the energy of an edge with a contact angle from above.
fn can_be_remeshed(structure: &Structure) -> bool {
    structure.layers.len() == 1 && structure.sliding.iter().all(|sliding| sliding.contact_angle.is_none())
}

/// Whether an edge, a corner or a ring moves, or a tube has a given volume.
fn moves(structure: &Structure) -> bool {
    let by_volume = structure.chambers.iter().any(|chamber| matches!(chamber.holds, Pressure::Volume(_)));
    let at_edge = |cable: &Cable| matches!(cable.course, Course::Boundary { .. });
    structure.cables.iter().any(at_edge)
        || !structure.sliding.is_empty()
        || !structure.free_points.is_empty()
        || !structure.rings.is_empty()
        || by_volume && structure.boundaries.len() > 1
}

/// Whether form finding may travel to the shape of an isotropic film.
pub(super) fn may_travel(structure: &Structure) -> bool {
    can_be_remeshed(structure) && structure.weave().is_none()
}

/// Whether form finding begins on a coarse mesh. This is so for an isotropic film with parts that move. A film whose
/// edges are held keeps its initial mesh as long as that leads to a shape, because on this mesh the error falls more
/// evenly with the edge length.
pub(super) fn travels(structure: &Structure) -> bool {
    may_travel(structure) && moves(structure)
}

/// Whether form finding travels if a woven film is not found on its initial mesh. A woven film keeps this mesh first,
/// because it has no energy that falls from round to round.
pub(super) fn travels_if_woven(structure: &Structure) -> bool {
    can_be_remeshed(structure) && structure.weave().is_some() && moves(structure)
}
