//! Names of warnings and of reasons for failures. The names stay the same from version to version.

use std::fmt;

/// Declares an enumeration of names. The documentation comment of a variant is also the text that `meaning` returns.
macro_rules! names {
    ($(#[$attribute:meta])* $names:ident { $($(#[doc = $text:literal])+ $variant:ident = $name:literal,)+ }) => {
        $(#[$attribute])*
        #[derive(Clone, Copy, Debug, PartialEq, Eq, Hash, PartialOrd, Ord)]
        #[non_exhaustive]
        pub enum $names {
            $($(#[doc = $text])+ $variant,)+
        }

        impl $names {
            /// All variants, in the order of their names.
            pub const ALL: &[Self] = &[$(Self::$variant),+];

            /// Returns the name in snake case.
            #[must_use]
            pub const fn name(self) -> &'static str {
                match self {
                    $(Self::$variant => $name,)+
                }
            }

            /// Returns the meaning as a sentence without its full stop.
            #[must_use]
            pub fn meaning(self) -> &'static str {
                let text = match self {
                    $(Self::$variant => concat!($($text),+),)+
                };
                text.trim().trim_end_matches('.')
            }
        }

        impl fmt::Display for $names {
            fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
                f.write_str(self.name())
            }
        }

        impl PartialEq<&str> for $names {
            fn eq(&self, name: &&str) -> bool {
                self.name() == *name
            }
        }
    };
}

names! {
    /// The kind of fact that a [`Warning`](crate::error::Warning) reports. Names are in snake case.
    WarningCode {
        /// A directrix between two strips is a single point, so that the surface is pinched there: `directrix`.
        ApexInside = "apex_inside",
        /// An edge or a point has slid beyond the border of its support: `support`, `distance`.
        BeyondSupport = "beyond_support",
        /// The sides of a film nearly touch at a corner between cables: `boundary`, `point`, `angle_deg`, and
        /// `force_factor`, by which the forces of these cables would have to grow to open the corner to 5 degrees.
        ClosingCorner = "closing_corner",
        /// Neighbouring directrices cross or touch: `directrix`, and the points `from` and `to` of that directrix.
        CrossingDirectrices = "crossing_directrices",
        /// The mean edge length differs from the wanted one: `mean_edge_length`, `edge_length`.
        EdgeLengthMissed = "edge_length_missed",
        /// Triangles of a strip have no area: `strip`, `count`.
        EmptyTriangles = "empty_triangles",
        /// The mesh is so far from zero that an STL file cannot hold its coordinates and is relative to `origin`.
        FarFromZero = "far_from_zero",
        /// The film under a lattice has a warning. The detail begins with the code of that warning.
        Film = "film",
        /// The films of the least topology pass through each other or themselves.
        FilmsCross = "films_cross",
        /// Neighbouring triangles of a strip fold back, and its directrices have no such sharp corner: `strip`,
        /// `largest_fold_deg`.
        Folds = "folds",
        /// A single point does not hold a film, however finely it is meshed: `count`.
        HeldPoints = "held_points",
        /// Neighbouring directrices are the same polyline: `directrix`.
        IdenticalDirectrices = "identical_directrices",
        /// Points of the request were joined to others within the tolerance: `count`, and the largest `distance`.
        Joined = "joined",
        /// Other than four junctions meet in a point, which a soap film would split: `junctions`, `points`.
        JunctionPoint = "junction_point",
        /// A strip has a much larger area than the strip of minimal area: `strip`, `factor`.
        LargeArea = "large_area",
        /// A layer lies in front of the layer below it: `layer`, `volume`.
        LayersCross = "layers_cross",
        /// The members need more different lengths than were asked for: `lengths`, `deviation`.
        LengthsNotReached = "lengths_not_reached",
        /// Nothing resists a motion of the structure. The detail names the points that move.
        Mechanism = "mechanism",
        /// Equal or nearly equal neighbouring points were merged: `count`, and `directrix` if there are several.
        MergedPoints = "merged_points",
        /// A slightly different boundary or a finer mesh may have no such film: `margin`.
        NearCritical = "near_critical",
        /// An end lies near a point or a segment of the request to which it is not joined: `distance`.
        NearlyJoined = "nearly_joined",
        /// No lower bound was computed. The detail has the reason.
        NoCertificate = "no_certificate",
        /// No film that connects all boundaries was found: `largest_gap_fraction`, if a film connects nearer ones.
        NoConnectedFilm = "no_connected_film",
        /// No lattice edge fits into the domain.
        NoLattice = "no_lattice",
        /// The forces within the film could not be balanced, so that there are no reactions.
        NotBalanced = "not_balanced",
        /// The result does not meet the tolerance: `residual` of films and tensile structures, and for films also
        /// `tolerance`, `flipped_triangles` and `degenerate_triangles`.
        NotConverged = "not_converged",
        /// The solver met its own rule, but the film is no minimal surface to the tolerance: `residual`, `tolerance`.
        NotMinimal = "not_minimal",
        /// An objective of a blend can be brought to zero on a strip, so that its term is not divided by its optimum.
        NotNormalised = "not_normalised",
        /// Directrices run in opposite directions: `directrix`, the first of the two.
        OppositeDirections = "opposite_directions",
        /// Edges are outside the lengths that the lattice promises: `count`.
        OutOfRange = "out_of_range",
        /// A cable or a mast passes through the film: `cable` or `mast`, and the place `x`, `y`, `z`.
        PiercesFilm = "pierces_film",
        /// Water would stand on the film: `depth`, `x`, `y`, `z`.
        Ponding = "ponding",
        /// Points were projected onto their plane: `distance`.
        Projected = "projected",
        /// A neck needed a finer mesh than was asked for: `triangles`.
        Refined = "refined",
        /// The path of a closed strip runs all the way round a directrix at one point of the other: `strip`.
        RepeatedBridge = "repeated_bridge",
        /// Triangles cross or touch each other: `pairs`, and the place `x`, `y`, `z` of a crossing.
        SelfIntersections = "self_intersections",
        /// Two boundaries have a point in common: `boundary`, `point`.
        SharedPoints = "shared_points",
        /// A cable carries no force: `cable` of a structure, `count` of a net.
        SlackCable = "slack_cable",
        /// Rounding does not decide the sign of an eigenvalue, so that the index is null.
        StabilityUndecided = "stability_undecided",
        /// Warp and weft of a woven film have other stresses than required: `deviation_rms`.
        StressDeviates = "stress_deviates",
        /// A strip has much more bending energy than the strip that bends least: `strip`, `factor`.
        StronglyBent = "strongly_bent",
        /// Edges of a net miss a target by more than half: `count`.
        TargetsMissed = "targets_missed",
        /// The film came apart, and its topology is not that of the initial mesh: `pinches`.
        TopologyChanged = "topology_changed",
        /// The mesh has far fewer or more triangles than were asked for: `triangles`, `asked`.
        TrianglesMissed = "triangles_missed",
        /// Open directrices end where they begin: `count`.
        UnclosedDirectrices = "unclosed_directrices",
        /// The shape is stationary but no minimum: `morse_index`, or its lower bound if it is undecided.
        Unstable = "unstable",
    }
}

names! {
    /// Why a solver has no result. Names are in snake case.
    Reason {
        /// The boundary has no usable initial mesh.
        DegenerateBoundary = "degenerate_boundary",
        /// No equilibrium was found.
        EquilibriumNotFound = "equilibrium_not_found",
        /// The server failed.
        Internal = "internal",
        /// The solver produced an invalid mesh.
        InvalidMesh = "invalid_mesh",
        /// No minimal film connects the boundaries.
        NoConnectedFilm = "no_connected_film",
        /// The structure has no equilibrium.
        NoEquilibrium = "no_equilibrium",
        /// The boundary has no initial mesh.
        NoInitialMesh = "no_initial_mesh",
        /// The boundary is too small for the interior vertices.
        NoRoomForInteriorVertices = "no_room_for_interior_vertices",
        /// The surface cannot be flattened.
        NotFlattenable = "not_flattenable",
        /// The boundary crosses itself.
        SelfIntersectingBoundary = "self_intersecting_boundary",
        /// A cable would be slack.
        SlackCable = "slack_cable",
        /// No net meets the targets.
        TargetsNotReached = "targets_not_reached",
        /// The mesh is too large.
        TooLarge = "too_large",
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn names_are_sorted_and_in_snake_case_and_meanings_are_sentences() {
        let warnings = WarningCode::ALL.iter().map(|code| (code.name(), code.meaning()));
        let reasons = Reason::ALL.iter().map(|reason| (reason.name(), reason.meaning()));
        for names in [warnings.collect::<Vec<_>>(), reasons.collect()] {
            assert!(names.is_sorted_by(|a, b| a.0 < b.0), "{names:?}");
            for (name, meaning) in names {
                assert!(name.bytes().all(|byte| byte.is_ascii_lowercase() || byte == b'_'), "{name}");
                assert!(meaning.starts_with(char::is_uppercase) && !meaning.ends_with(['.', ' ']), "{name}: {meaning}");
            }
        }
    }
}
