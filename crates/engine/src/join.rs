//! Joins the points of a request that should be one, before the request becomes the geometry's.
//!
//! Cables, masts, joints and guides are given by coordinates, and the geometry compares coordinates by their bits. A
//! program that computes a point twice may get two points that differ in the last bits. Such points become one here:
//! points within the tolerance of each other take the same place, and ends of curves on a segment of a boundary become
//! points of the boundary. Points of the boundaries stay where they are.

#[cfg(test)]
mod tests;

use plateau_mesh::axis_box::AxisBox;
use plateau_mesh::box_tree::BoxTree;
use plateau_mesh::codes::WarningCode;
use plateau_mesh::disjoint_sets::DisjointSets;
use plateau_mesh::error::Warning;
use plateau_mesh::polyline::{merge_near_neighbours, position_key, radius};
use plateau_mesh::{DVec3, Error, InputError, Place};
use plateau_minimal_surface::SegmentPoint;
use plateau_strict_json::rejection::{FieldError, MAX_ERRORS, Rejection};
use std::collections::{BTreeMap, BTreeSet};
use std::fmt;

/// Default of `join_tolerance`, as a fraction of the request's size. The size is the largest distance of a point from
/// the mean of all points.
const DEFAULT: f64 = 1e-6;
/// Lower bound of the tolerance, in units in the last place of the largest coordinate.
const ROUNDING: f64 = 8.0;
/// Distance up to which an end that is not joined gets the warning `nearly_joined`, as a fraction of the request's
/// size.
const NEAR: f64 = 1e-2;
/// A point is named in the warning `nearly_joined` in place of a nearer segment up to this multiple of the segment's
/// distance.
const POINT_RATHER: f64 = 2.0;
/// Maximum number of ends that get the warning `nearly_joined`. The last of these warnings counts the others.
const LISTED: usize = 10;
/// Maximum number of different places within the tolerance of a point. It bounds the work, because each visits the
/// others.
const MOST_NEAR: usize = 1000;

/// The part of a request to which points belong that are joined.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) enum Role {
    /// A fixed point of a film.
    FixedPoint,
    /// A joint, or the hub of a ring: a point in the air that no support holds.
    Joint,
    /// A fixed curve of a film. It may be closed, and its ends may lie on segments of the boundaries.
    Guide,
    /// A cable across a film. Its ends are points of the boundaries or lie on their segments.
    Across,
    /// A cable in the air.
    Cable,
    /// A mast.
    Mast,
}

/// Points of one part of a request.
#[derive(Clone, Debug)]
pub(crate) struct Member {
    pub role: Role,
    /// JSON Pointer of the list that has the part.
    pub list: &'static str,
    /// Number of the part in its list.
    pub number: usize,
    /// Rest of the pointer to the points or to the point, such as `/points`.
    pub field: &'static str,
    pub points: Vec<DVec3>,
}

/// Treatment of the ends of curves on segments of boundaries.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) enum OnSegments {
    /// They become points of the boundary.
    Joined,
    /// They are refused, because the boundary gets no further points.
    Refused,
    /// They stay as they are, because the client's own mesh has its vertices.
    Left,
}

/// The points of a request.
#[derive(Clone, Debug)]
pub(crate) struct Points<'a> {
    pub boundaries: &'a [Vec<DVec3>],
    /// For each point of the boundaries whether it can move, because no support holds it.
    pub moves: Vec<Vec<bool>>,
    pub members: Vec<Member>,
    /// `join_tolerance` of the request.
    pub tolerance: Option<f64>,
    pub on_segments: OnSegments,
}

/// The points of a request after joining.
#[derive(Clone, Debug)]
pub(crate) struct Joined {
    /// The points of each member.
    pub points: Vec<Vec<DVec3>>,
    /// The ends of curves on segments of the boundaries.
    pub ends: Vec<SegmentPoint>,
    pub notes: Notes,
}

/// Facts about joined points that the client gets with the result or with a failure.
#[derive(Clone, Debug, Default)]
pub(crate) struct Notes {
    pub warnings: Vec<Warning>,
    /// The ends that lie near a point to which they are not joined.
    pub nearly: Vec<InputError>,
}

impl Notes {
    /// Adds the ends that are nearly joined to an error, because they are its likely cause.
    #[must_use]
    pub fn added_to(&self, mut error: Error) -> Error {
        if let Error::Input(places) | Error::NoResult { places, .. } = &mut error {
            places.extend(self.nearly.iter().cloned());
        }
        error
    }
}

/// JSON Pointer of a point.
#[derive(Clone, Copy, Debug)]
struct Pointer {
    list: &'static str,
    number: usize,
    field: &'static str,
    point: Option<usize>,
}

impl fmt::Display for Pointer {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        write!(f, "{}/{}{}", self.list, self.number, self.field)?;
        self.point.map_or(Ok(()), |point| write!(f, "/{point}"))
    }
}

impl Pointer {
    fn place(&self) -> Place {
        let fields = self.list.split('/').filter(|field| !field.is_empty());
        let place = fields.fold(Place::default(), Place::then).at(self.number);
        let place = self.field.split('/').filter(|field| !field.is_empty()).fold(place, Place::then);
        self.point.map_or(place.clone(), |point| place.at(point))
    }

    fn of_boundary([boundary, point]: [usize; 2]) -> Self {
        Self { list: "/boundaries", number: boundary, field: "", point: Some(point) }
    }
}

/// A place at which a request has one point or several with equal bits.
#[derive(Clone, Copy, Debug)]
struct Site {
    place: DVec3,
    /// The first of the points.
    pointer: Pointer,
    on_boundary: bool,
    /// Whether the points can move: points of boundaries that no support holds, joints and hubs.
    moves: bool,
    /// Number of points of members.
    count: usize,
    /// Whether a joint or a hub is here.
    is_joint: bool,
    /// A site of the same cluster within the tolerance.
    link: Option<u32>,
}

/// A segment of a boundary without equal neighbouring points.
#[derive(Clone, Copy, Debug)]
struct Segment {
    boundary: usize,
    /// Numbers of the request's points at its ends.
    points: [usize; 2],
    ends: [DVec3; 2],
}

impl Segment {
    /// Returns the point of the segment that is nearest to a point, and its fraction of the segment.
    fn foot(&self, point: DVec3) -> (DVec3, f64) {
        let [a, b] = self.ends;
        let along = b - a;
        let fraction = (point - a).dot(along) / along.length_squared();
        (a + fraction.clamp(0.0, 1.0) * along, fraction)
    }

    fn shares_an_end(&self, other: &Self) -> bool {
        self.ends.iter().any(|end| other.ends.contains(end))
    }
}

impl fmt::Display for Segment {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        let [from, to] = self.points.map(|point| Pointer::of_boundary([self.boundary, point]));
        write!(f, "the segment from {from} to {to}")
    }
}

/// Points that become one.
#[derive(Clone, Copy, Debug)]
struct Cluster {
    /// The site whose place all take.
    anchor: u32,
    /// The common place, which is that of the anchor or a point of a segment.
    place: DVec3,
    /// The segment of a boundary on which the place lies.
    segment: Option<u32>,
    /// Whether a joint or a hub is among the points.
    has_joint: bool,
}

/// The points of a request while they are joined.
struct Joiner<'a> {
    request: &'a Points<'a>,
    /// `NEAR`, the tolerance and the rounding of the coordinates, as lengths.
    near: f64,
    tolerance: f64,
    rounding: f64,
    sites: Vec<Site>,
    /// The site of each point of each member.
    site_of: Vec<Vec<u32>>,
    /// The cluster of each site, by its leader.
    leader: Vec<u32>,
    clusters: BTreeMap<u32, Cluster>,
    segments: Vec<Segment>,
    errors: Vec<FieldError>,
}

/// Joins the points of a request. O(n log n) in the number of points.
///
/// # Errors
/// Fails if a point is within the tolerance of two that stay apart, and if the two ends of a cable, a mast or a curve
/// become one. Fails if a cable in the air or a mast ends on a segment of a boundary, or if a curve does where the
/// boundaries get no further points.
pub(crate) fn join(request: &Points<'_>) -> Result<Joined, Rejection> {
    let given: Vec<Vec<DVec3>> = request.members.iter().map(|member| member.points.clone()).collect();
    let all: Vec<DVec3> = request.boundaries.iter().chain(&given).flatten().copied().collect();
    let size = radius(&all);
    if given.is_empty() || !size.is_finite() {
        return Ok(Joined { points: given, ends: Vec::new(), notes: Notes::default() });
    }
    let largest = all.iter().map(|point| point.abs().max_element()).fold(0.0, f64::max);
    let rounding = ROUNDING * (largest.next_up() - largest);
    let tolerance = request.tolerance.unwrap_or(DEFAULT * size).max(rounding);
    let mut joiner = Joiner {
        request,
        near: NEAR * size,
        tolerance,
        rounding,
        sites: Vec::new(),
        site_of: Vec::new(),
        leader: Vec::new(),
        clusters: BTreeMap::new(),
        segments: Vec::new(),
        errors: Vec::new(),
    };
    joiner.collect();
    let sites: Vec<AxisBox> = joiner.sites.iter().map(|site| AxisBox::around([site.place])).collect();
    let sites = BoxTree::new(&sites);
    joiner.cluster(&sites);
    let segments: Vec<AxisBox> = joiner.segments.iter().map(|segment| AxisBox::around(segment.ends)).collect();
    let segments = BoxTree::new(&segments);
    joiner.join_to_segments(&segments);
    joiner.refuse_closed_members();
    let nearly = joiner.nearly_joined(&sites, &segments);
    if !joiner.errors.is_empty() {
        joiner.errors.truncate(MAX_ERRORS + 1);
        return Err(Rejection::Invalid(joiner.errors));
    }
    Ok(joiner.joined(nearly))
}

impl Joiner<'_> {
    /// Collects the sites, the points first that the boundaries have after merging, and the segments.
    fn collect(&mut self) {
        let Points { boundaries, moves, members, .. } = self.request;
        let mut number: BTreeMap<[u64; 3], u32> = BTreeMap::new();
        let mut dropped = Vec::new();
        for (k, points) in boundaries.iter().enumerate() {
            let merged = merge_near_neighbours(points, true);
            for (&place, &source) in merged.points.iter().zip(&merged.source) {
                let next = self.sites.len() as u32;
                let site = *number.entry(position_key(place)).or_insert(next);
                if site == next {
                    self.sites.push(Site {
                        place,
                        pointer: Pointer::of_boundary([k, source]),
                        on_boundary: true,
                        moves: false,
                        count: 0,
                        is_joint: false,
                        link: None,
                    });
                }
                self.sites[site as usize].moves |= moves[k][source];
            }
            let count = merged.points.len();
            for j in (0..count).filter(|_| count > 1) {
                let ends = [j, (j + 1) % count];
                self.segments.push(Segment {
                    boundary: k,
                    points: ends.map(|j| merged.source[j]),
                    ends: ends.map(|j| merged.points[j]),
                });
            }
            if merged.dropped() > 0 {
                let kept = points.iter().zip(&merged.vertex_of).map(|(&point, &j)| (point, merged.points[j]));
                dropped.extend(kept);
            }
        }
        // A point that was merged into its neighbour stands for the neighbour.
        for (point, kept) in dropped {
            let site = number[&position_key(kept)];
            number.entry(position_key(point)).or_insert(site);
        }
        for member in members {
            let mut own = Vec::with_capacity(member.points.len());
            for (i, &place) in member.points.iter().enumerate() {
                let next = self.sites.len() as u32;
                let site = *number.entry(position_key(place)).or_insert(next);
                if site == next {
                    self.sites.push(Site {
                        place,
                        pointer: member.pointer(i),
                        on_boundary: false,
                        moves: false,
                        count: 0,
                        is_joint: false,
                        link: None,
                    });
                }
                let found = &mut self.sites[site as usize];
                found.count += 1;
                found.is_joint |= member.role == Role::Joint;
                found.moves |= member.role == Role::Joint;
                own.push(site);
            }
            self.site_of.push(own);
        }
    }

    fn refuse(&mut self, pointer: Pointer, detail: impl fmt::Display) {
        self.errors.push(FieldError::new(pointer.to_string(), detail.to_string()));
    }

    /// Unites sites within the tolerance of each other, and finds the place of each cluster: a point of a boundary, or
    /// else the place that most of its points have. Joints come before other points, and earlier points before later
    /// ones.
    fn cluster(&mut self, tree: &BoxTree) {
        let count = self.sites.len();
        let mut sets = DisjointSets::new(count);
        // The point of a boundary within the tolerance of each site.
        let mut beside: Vec<Option<u32>> = vec![None; count];
        for k in 0..count as u32 {
            let site = self.sites[k as usize];
            if site.on_boundary {
                continue;
            }
            let (mut visited, mut link) = (0, site.link);
            let mut near: [Option<u32>; 2] = [None; 2];
            let (sites, tolerance) = (&self.sites, self.tolerance);
            tree.visit(site.place, tolerance, &mut |other| {
                let away = sites[other as usize].place.distance(site.place);
                if other == k || away > tolerance {
                    return tolerance;
                }
                visited += 1;
                if sites[other as usize].on_boundary {
                    let free = if near[0].is_none() { 0 } else { 1 };
                    near[free] = Some(other);
                } else {
                    sets.join(k, other);
                    link = Some(other);
                }
                if visited > MOST_NEAR || near[1].is_some() { -1.0 } else { tolerance }
            });
            self.sites[k as usize].link = link;
            beside[k as usize] = near[0];
            if let [Some(a), Some(b)] = near {
                let [a, b] = [a.min(b), a.max(b)].map(|other| self.sites[other as usize].pointer);
                self.refuse_between(site.pointer, a, b);
            } else if visited > MOST_NEAR {
                let detail = format!("has more than {MOST_NEAR} points within join_tolerance ({:.2e})", self.tolerance);
                self.refuse(site.pointer, detail);
            }
        }
        self.leader = (0..count as u32).map(|k| sets.leader(k)).collect();
        let mut anchors: BTreeMap<u32, u32> = BTreeMap::new();
        let rank = |site: &Site| (site.on_boundary, site.count, site.is_joint);
        for k in 0..count as u32 {
            let own = beside[k as usize].unwrap_or(k);
            let anchor = anchors.entry(self.leader[k as usize]).or_insert(own);
            if rank(&self.sites[own as usize]) > rank(&self.sites[*anchor as usize]) {
                *anchor = own;
            }
        }
        for k in 0..count {
            let anchor = self.sites[anchors[&self.leader[k]] as usize];
            let site = self.sites[k];
            let is_apart = anchor.place.distance(site.place) > self.tolerance;
            let has_other = beside[k].is_some_and(|other| self.sites[other as usize].place != anchor.place);
            if (is_apart || has_other) && self.errors.is_empty() {
                let linked = if has_other { beside[k] } else { site.link };
                let other = self.sites[linked.map_or(k, |other| other as usize)].pointer;
                self.refuse_between(site.pointer, other, anchor.pointer);
            }
        }
        for (leader, anchor) in anchors {
            let place = self.sites[anchor as usize].place;
            self.clusters.insert(leader, Cluster { anchor, place, segment: None, has_joint: false });
        }
        for k in (0..count).filter(|&k| self.sites[k].is_joint) {
            if let Some(cluster) = self.clusters.get_mut(&self.leader[k]) {
                cluster.has_joint = true;
            }
        }
    }

    fn refuse_between(&mut self, pointer: Pointer, a: Pointer, b: Pointer) {
        let detail = format!(
            "is to be joined to {a} and to {b}, within join_tolerance ({:.2e}), and these are different points: give \
             exactly the coordinates of the one that is meant, or a smaller join_tolerance",
            self.tolerance
        );
        self.refuse(pointer, detail);
    }

    fn cluster_of(&self, site: u32) -> &Cluster {
        &self.clusters[&self.leader[site as usize]]
    }

    /// Returns whether a site becomes a point of a boundary, which may lie on a segment.
    fn is_on_boundary(&self, site: u32) -> bool {
        let cluster = self.cluster_of(site);
        cluster.segment.is_some() || self.sites[cluster.anchor as usize].on_boundary
    }

    /// Returns whether a site becomes a point to which a cable in the air is tied: a point of the request's boundaries,
    /// a joint or a hub.
    fn is_tied(&self, site: u32) -> bool {
        let cluster = self.cluster_of(site);
        cluster.has_joint || self.sites[cluster.anchor as usize].on_boundary
    }

    /// Returns the segment that is nearest to a point, with its number and distance, among those that `counts` accepts.
    fn nearest_segment(
        &self,
        tree: &BoxTree,
        point: DVec3,
        within: f64,
        counts: impl Fn(&Segment) -> bool,
    ) -> Option<(u32, f64)> {
        let mut best: Option<(u32, f64)> = None;
        tree.visit(point, within, &mut |k| {
            let segment = &self.segments[k as usize];
            let away = segment.foot(point).0.distance(point);
            let is_nearer = best.is_none_or(|(number, least)| away < least || (away == least && k < number));
            if away <= within && is_nearer && counts(segment) {
                best = Some((k, away));
            }
            best.map_or(within, |(_, least)| least)
        });
        best
    }

    /// Finds the ends that lie on segments of boundaries. Ends of curves become points of the boundary, or are refused
    /// like those of cables in the air and masts.
    fn join_to_segments(&mut self, tree: &BoxTree) {
        if self.request.on_segments == OnSegments::Left {
            return;
        }
        for (m, member) in self.request.members.iter().enumerate() {
            for i in self.ends(m) {
                let site = self.site_of[m][i];
                let is_straight = matches!(member.role, Role::Cable | Role::Mast);
                if if is_straight { self.is_tied(site) } else { self.is_on_boundary(site) } {
                    continue;
                }
                let place = self.cluster_of(site).place;
                let Some((k, away)) = self.nearest_segment(tree, place, self.tolerance, |_| true) else { continue };
                let (segment, pointer) = (self.segments[k as usize], member.pointer(i));
                let apart = |other: &Segment| !other.shares_an_end(&segment);
                if let Some((other, _)) = self.nearest_segment(tree, place, self.tolerance, apart) {
                    let detail = format!(
                        "lies on {segment} and on {}, within join_tolerance ({:.2e}): add the point to the one that is \
                         meant, or give a smaller join_tolerance",
                        self.segments[other as usize], self.tolerance
                    );
                    self.refuse(pointer, detail);
                    continue;
                }
                let (foot, fraction) = segment.foot(place);
                let end = if fraction < 0.5 { 0 } else { 1 };
                if foot.distance(segment.ends[end]) <= self.tolerance {
                    let other = Pointer::of_boundary([segment.boundary, segment.points[end]]);
                    self.refuse(
                        pointer,
                        format!("lies on {segment} and beside its end {other}: give exactly this point"),
                    );
                    continue;
                }
                let refusal = match member.role {
                    Role::Cable => Some("a cable in the air ends at a point of the boundary"),
                    Role::Mast => Some("a mast ends at a point of the boundary"),
                    _ if self.request.on_segments == OnSegments::Refused => Some("boundary_sampling keep adds none"),
                    _ => None,
                };
                if let Some(why) = refusal {
                    let detail = format!(
                        "lies on {segment}, where the boundary has no point, and {why}: add the point to the boundary"
                    );
                    self.refuse(pointer, detail);
                    continue;
                }
                let leader = self.leader[site as usize];
                if let Some(cluster) = self.clusters.get_mut(&leader) {
                    cluster.segment = Some(k);
                    cluster.place = if away <= self.rounding { place } else { foot };
                }
            }
        }
    }

    /// Returns the numbers of the points at which a member ends. A closed curve has none.
    fn ends(&self, m: usize) -> Vec<usize> {
        let (member, own) = (&self.request.members[m], &self.site_of[m]);
        let last = own.len() - 1;
        match member.role {
            Role::FixedPoint | Role::Joint => Vec::new(),
            Role::Guide if self.leader[own[0] as usize] == self.leader[own[last] as usize] => Vec::new(),
            Role::Guide | Role::Across | Role::Cable | Role::Mast => vec![0, last],
        }
    }

    /// Refuses members whose two ends become one although they are two points. A guide of four or more points is then
    /// closed.
    fn refuse_closed_members(&mut self) {
        for (member, own) in self.request.members.iter().zip(&self.site_of) {
            let last = own.len() - 1;
            let places = [0, last].map(|i| self.cluster_of(own[i]).place);
            let is_closed_guide = member.role == Role::Guide && last > 2;
            if own[0] == own[last] || places[0] != places[1] || is_closed_guide {
                continue;
            }
            let pointers = [member.pointer(0), member.pointer(last)];
            for [this, other] in [pointers, [pointers[1], pointers[0]]] {
                let detail = format!(
                    "becomes the same point as the other end, {other}, within join_tolerance ({:.2e}): give a smaller \
                     join_tolerance",
                    self.tolerance
                );
                self.errors.push(FieldError::new(this.to_string(), detail));
            }
        }
    }

    /// Returns the warnings about ends that lie near a point or a segment but are not joined. Refuses the ends of
    /// cables across the film that are not on a boundary.
    fn nearly_joined(&mut self, sites: &BoxTree, segments: &BoxTree) -> Notes {
        let mut notes = Notes::default();
        for (m, member) in self.request.members.iter().enumerate() {
            for i in self.ends(m) {
                let (site, pointer) = (self.site_of[m][i], member.pointer(i));
                let is_joined = match member.role {
                    Role::Guide => self.is_on_boundary(site) || self.is_shared(site),
                    Role::Across => self.is_on_boundary(site),
                    _ => self.is_tied(site),
                };
                if is_joined {
                    continue;
                }
                let near = self.nearest_neighbour(m, i, sites, segments);
                let Some((other, away)) = near else { continue };
                if member.role == Role::Across {
                    let detail = format!(
                        "must be a point of the boundaries or lie on one of their segments; {other} is {away:.2e} \
                         away, more than join_tolerance ({:.2e})",
                        self.tolerance
                    );
                    self.refuse(pointer, detail);
                    continue;
                }
                let detail = format!(
                    "lies {away:.2e} from {other} and is not joined to it, because this is more than join_tolerance \
                     ({:.2e}); give both the same coordinates if they are to be one",
                    self.tolerance
                );
                let warning = Warning::new(WarningCode::NearlyJoined, format!("{pointer} {detail}"));
                notes.warnings.push(warning.with("distance", away));
                notes.nearly.push(InputError::new(pointer.place(), detail));
            }
        }
        let more = notes.warnings.len().saturating_sub(LISTED);
        notes.warnings.truncate(LISTED);
        notes.nearly.truncate(LISTED);
        if let Some(last) = notes.warnings.last_mut().filter(|_| more > 0) {
            last.detail += &format!("; {more} more ends lie near a point to which they are not joined");
        }
        notes
    }

    /// Returns whether other points of the request take the same place as this site.
    fn is_shared(&self, site: u32) -> bool {
        let Site { count, link, .. } = self.sites[site as usize];
        count > 1 || link.is_some()
    }

    /// Returns the name and the distance of the point or segment that is nearest to an end and to which the end could
    /// be joined, if there is any near it. A cable in the air and a mast, whose end is a support, could be joined to
    /// points that move; a curve could be joined to any point but its own.
    fn nearest_neighbour(&self, m: usize, i: usize, sites: &BoxTree, segments: &BoxTree) -> Option<(String, f64)> {
        let (member, own) = (&self.request.members[m], &self.site_of[m]);
        let (place, last) = (self.sites[own[i] as usize].place, own.len() - 1);
        let other_end = own[last - i];
        let anchor = |site: u32| self.cluster_of(site).anchor;
        let is_curve = matches!(member.role, Role::Guide | Role::Across);
        // A curve that comes back to its beginning is almost closed.
        let chord = place.distance(self.sites[other_end as usize].place);
        let comes_back = chord < 0.5 * plateau_mesh::polyline::length(&member.points, false);
        let excluded: BTreeSet<u32> = if is_curve {
            own.iter().filter(|&&site| !(comes_back && site == other_end)).map(|&site| anchor(site)).collect()
        } else {
            [own[i], other_end].map(anchor).into()
        };
        let mut best: Option<(u32, f64)> = None;
        sites.visit(place, self.near, &mut |k| {
            let site = &self.sites[k as usize];
            let away = site.place.distance(place);
            let may_join = match member.role {
                Role::Across => site.on_boundary,
                Role::Guide => true,
                _ => site.moves,
            };
            let is_nearer = best.is_none_or(|(number, least)| away < least || (away == least && k < number));
            if may_join && away <= self.near && is_nearer && !excluded.contains(&anchor(k)) {
                best = Some((k, away));
            }
            best.map_or(self.near, |(_, least)| least)
        });
        let segment = (is_curve && self.request.on_segments == OnSegments::Joined)
            .then(|| self.nearest_segment(segments, place, self.near, |_| true))
            .flatten();
        match (best, segment) {
            (Some((k, away)), nearer) if nearer.is_none_or(|(_, least)| away <= POINT_RATHER * least) => {
                Some((self.sites[k as usize].pointer.to_string(), away))
            }
            (_, Some((k, away))) => Some((self.segments[k as usize].to_string(), away)),
            (_, None) => None,
        }
    }

    /// Returns the points at their common places, the ends on segments, and the warnings.
    fn joined(&self, mut notes: Notes) -> Joined {
        let (mut count, mut largest) = (0, 0.0f64);
        let mut points = Vec::with_capacity(self.site_of.len());
        for (member, own) in self.request.members.iter().zip(&self.site_of) {
            let mut places = Vec::with_capacity(own.len());
            for (&given, &site) in member.points.iter().zip(own) {
                let place = self.cluster_of(site).place;
                let is_moved = place != given;
                count += usize::from(is_moved);
                largest = largest.max(place.distance(given));
                places.push(if is_moved { place } else { given });
            }
            points.push(places);
        }
        let on_segment = |cluster: &Cluster| {
            let segment = &self.segments[cluster.segment? as usize];
            let [first, _] = segment.points;
            Some(SegmentPoint { boundary: segment.boundary, segment: first, place: cluster.place })
        };
        let ends = self.clusters.values().filter_map(on_segment).collect();
        if count > 0 {
            let (what, are) = if count == 1 { ("point", "was") } else { ("points", "were") };
            let detail = format!(
                "{count} {what} of the request {are} joined to others within join_tolerance ({:.2e}), and moved there \
                 by up to {largest:.2e}",
                self.tolerance
            );
            let joined = Warning::new(WarningCode::Joined, detail);
            notes.warnings.insert(0, joined.with_count("count", count).with("distance", largest));
        }
        Joined { points, ends, notes }
    }
}

impl Member {
    fn pointer(&self, point: usize) -> Pointer {
        let Self { list, number, field, .. } = *self;
        let is_point = matches!(self.role, Role::FixedPoint | Role::Joint);
        Pointer { list, number, field, point: (!is_point).then_some(point) }
    }
}
