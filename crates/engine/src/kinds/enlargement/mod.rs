//! Enlargements of the mesh of a finished job. Only test builds have this kind. It shows how little a kind needs, and
//! that a kind may begin with the result of a job (docs/adding-a-kind.md).

mod audit;
mod solve;

pub use solve::EnlargementStatistics;

use crate::blocks::{self, Block, Input, Output, Preset, Type};
use crate::checked::{Checked, SourcedRequest, Types};
use crate::kind::{Entry, Kind, Objective, Units};
use crate::limits::Limits;
use crate::options::{Optioned, RequestOption};
use crate::source::{self, JobSource, Source};
use plateau_strict_json::bounds::{Positive, unwritten};
use plateau_strict_json::rejection::{FieldError, Rejection};
use schemars::JsonSchema;
use serde::{Deserialize, Serialize};

pub const KIND: Kind = Kind::of(&ENTRY);

static ENTRY: Entry = Entry {
    name: "enlargement",
    path: "/v1/enlargements",
    summary: "Enlarges the mesh of a finished job",
    finds: "enlarged meshes of finished jobs",
    units: Units::OfSource,
    blocks: &[Block {
        name: "enlargement",
        title: "Enlargement",
        description: "Mesh of a finished job, enlarged about the origin.",
        inputs: &[
            Input::required("Source", "S", Type::Text, "Identifier of a job that has succeeded.").to(source::POINTER),
            Input::optional("Factor", "F", Preset::Number(2.0), "Factor of every coordinate.").to("/factor"),
        ],
    }],
    outputs: &[
        blocks::MESH,
        blocks::AREA,
        Output::figure("/triangles", "Triangles", "T", Type::Integer, "Number of triangles."),
    ],
    objectives,
    types: Types::sourced::<EnlargementRequest>(),
};

/// A finished job and the factor by which its mesh is enlarged.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub struct EnlargementRequest {
    /// Optional here, because the path names the kind. `plateau solve` needs it.
    #[serde(default, skip_serializing_if = "unwritten")]
    pub kind: Option<EnlargementKind>,
    pub source: JobSource,
    /// Factor of every coordinate.
    #[serde(default = "default_factor")]
    pub factor: Positive,
    /// Factor of the stated area. Every value but 1 states an area that is not the mesh's.
    #[serde(default = "one")]
    pub stated_area_factor: Positive,
}

fn one() -> Positive {
    Positive::new(1.0)
}

fn default_factor() -> Positive {
    Positive::new(2.0)
}

#[derive(Clone, Copy, Debug, PartialEq, Serialize, Deserialize, JsonSchema)]
#[serde(rename_all = "snake_case")]
pub enum EnlargementKind {
    Enlargement,
}

impl Optioned for EnlargementRequest {
    const OPTIONS: &'static [RequestOption] =
        &[RequestOption::always("factor"), RequestOption::always("stated_area_factor")];

    fn choice(&self, _member: &str) -> &'static str {
        "same_form"
    }
}

impl SourcedRequest for EnlargementRequest {
    type Statistics = EnlargementStatistics;

    fn source(&self) -> &JobSource {
        &self.source
    }

    fn check(&self, source: &Source, limits: &Limits) -> Result<Checked, Rejection> {
        let triangles = source.archive().contents().mesh.triangles.len();
        if triangles == 0 {
            let detail = "is the identifier of a job without triangles";
            return Err(Rejection::Invalid(vec![FieldError::new(source::POINTER, detail)]));
        }
        if triangles > limits.triangles {
            let detail = format!("has a mesh of more triangles than are allowed ({})", limits.triangles);
            return Err(Rejection::TooLarge(vec![FieldError::new(source::POINTER, detail)]));
        }
        Ok(Checked {
            memory_bytes: source.memory_bytes(),
            quick: false,
            input: Box::new(solve::SolverInput {
                source: source.clone(),
                factor: self.factor.get(),
                stated: self.stated_area_factor.get(),
            }),
        })
    }
}

fn objectives() -> Vec<Objective> {
    vec![Objective {
        name: "same_form",
        kind: KIND,
        minimises: "deviation of each edge's length from the factor times its length in the source, which is 0",
        unit: "u",
        source: "Euclid, Elements VI, definition 1",
        options: Vec::new(),
    }]
}
