//! The parameters of a schedule.

use crate::options::{Kind, Parameter, PatternOptions, parameter};
use crate::parameters::{Refused, Values};

/// A table of a result.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Part {
    Members,
    Nodes,
    Bends,
    Cables,
    CableEdges,
    Reactions,
    EdgeReactions,
}

impl Part {
    pub const ALL: [Self; 7] =
        [Self::Members, Self::Nodes, Self::Bends, Self::Cables, Self::CableEdges, Self::Reactions, Self::EdgeReactions];

    #[must_use]
    pub fn name(self) -> &'static str {
        match self {
            Self::Members => "members",
            Self::Nodes => "nodes",
            Self::Bends => "bends",
            Self::Cables => "cables",
            Self::CableEdges => "cable_edges",
            Self::Reactions => "reactions",
            Self::EdgeReactions => "edge_reactions",
        }
    }
}

/// What a schedule is made of.
#[derive(Clone, Debug, PartialEq)]
pub enum Content {
    /// A table as CSV. Bends have the options of their pattern.
    Table(Part, Option<Box<PatternOptions>>),
    /// The numbered lattice or net as DXF.
    Space,
}

/// Options of a schedule. Lengths are in the client's unit.
#[derive(Clone, Debug, PartialEq)]
pub struct ScheduleOptions {
    pub content: Content,
    /// Length that each node takes from each of its members.
    pub setback: f64,
    /// Width of the members, from which the least setbacks follow.
    pub member_width: f64,
    /// Tolerance of the kinds of members and nodes.
    pub tolerance: f64,
}

/// Largest length that a parameter may have, in the client's unit.
const LARGEST: f64 = 1e9;

impl ScheduleOptions {
    /// Reads the parameters of a query.
    ///
    /// # Errors
    /// Returns [`Refused::BadQuery`] with every parameter that is unknown, given twice, wrong in itself, or not allowed
    /// with the others.
    pub fn read(given: &[(String, String)]) -> Result<Self, Refused> {
        let own = |name: &str| matches!(name, "part" | "format" | "setback" | "member_width" | "tolerance");
        let (own, others): (Vec<_>, Vec<_>) = given.iter().cloned().partition(|(name, _)| own(name));
        let mut values = Values::new(&own);
        let parts = Part::ALL.map(|part| (part.name(), part));
        let part = values.choice("part", &parts);
        let is_space = values.choice("format", &[("csv", false), ("dxf", true)]).unwrap_or(false);
        let length = 0.0..=LARGEST;
        let setback = values.number("setback", length.clone());
        let member_width = values.number("member_width", length.clone());
        let tolerance = values.number("tolerance", length);
        let has_kinds = is_space || matches!(part, Some(Part::Members | Part::Nodes));
        let lengths = [
            ("setback", setback.is_some(), part == Some(Part::Members)),
            ("member_width", member_width.is_some(), part == Some(Part::Members)),
            ("tolerance", tolerance.is_some(), has_kinds),
        ];
        if is_space && part.is_some() {
            values.refuse("part", "is not allowed with format=dxf, which has members and nodes");
        } else if !is_space && part.is_none() && own.iter().all(|(name, _)| name != "part") {
            values.refuse("part", format!("is required; it is one of {}", Part::ALL.map(Part::name).join(", ")));
        } else if is_space || part.is_some() {
            for (name, _, _) in lengths.iter().filter(|(_, is_given, is_used)| *is_given && !is_used) {
                values.refuse(name, "is not a parameter of this schedule");
            }
        }
        let bends = part == Some(Part::Bends);
        if !bends {
            for (name, _) in &others {
                values.refuse(name, "known parameters are: part, format, setback, member_width, tolerance");
            }
        }
        values.end()?;
        let content = match part {
            None => Content::Space,
            Some(part) => {
                let options = bends.then(|| PatternOptions::read(&others)).transpose()?;
                Content::Table(part, options.map(Box::new))
            }
        };
        Ok(Self {
            content,
            setback: setback.unwrap_or(0.0),
            member_width: member_width.unwrap_or(0.0),
            tolerance: tolerance.unwrap_or(1e-3),
        })
    }

    /// Returns the media type of the file.
    #[must_use]
    pub fn media_type(&self) -> &'static str {
        match self.content {
            Content::Space => "image/vnd.dxf",
            Content::Table(..) => "text/csv",
        }
    }

    /// Returns the extension of the file's name.
    #[must_use]
    pub fn extension(&self) -> &'static str {
        match self.content {
            Content::Space => "dxf",
            Content::Table(..) => "csv",
        }
    }

    /// Returns the name of the file without the identifier of its job.
    #[must_use]
    pub fn file_name(&self) -> String {
        match self.content {
            Content::Space => "members.dxf".into(),
            Content::Table(part, _) => format!("{}.csv", part.name()),
        }
    }
}

/// Every parameter of a schedule. Bends have those of the flat pattern too.
pub const PARAMETERS: &[Parameter] = &[
    parameter(
        "part",
        Kind::Choice(&["members", "nodes", "bends", "cables", "cable_edges", "reactions", "edge_reactions"]),
        "The table. `format=dxf` needs none.",
    ),
    parameter(
        "format",
        Kind::Choice(&["csv", "dxf"]),
        "`csv` (the default) is the table; `dxf` is the lattice or net in space, with the members on the layers of \
         their kinds and all numbers.",
    ),
    parameter(
        "setback",
        Kind::Number(0.0, LARGEST),
        "Members: length that a node takes from each of its members, in the client's unit. The default is 0.",
    ),
    parameter(
        "member_width",
        Kind::Number(0.0, LARGEST),
        "Members: width of the members in the client's unit. A setback is at least half of it over the tangent of half \
         the smallest angle at the node.",
    ),
    parameter(
        "tolerance",
        Kind::Number(0.0, LARGEST),
        "Tolerance of the kinds of members and nodes, in the client's unit. The default is 0.001.",
    ),
];
