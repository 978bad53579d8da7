//! The components with their inputs and outputs, as Grasshopper shows them.

use base64::Engine as _;
use plateau_engine::blocks::{self, Block, Input, Preset, Type};
use plateau_engine::kind::Kind;
use plateau_strict_json::explain::edit_distance;
use serde_json::{Value, json};
use std::sync::LazyLock;

/// Source of an output's values.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Source {
    Result(blocks::Source),
    /// All statistics as lines of text.
    Statistics,
    Job,
    Status,
    Progress,
    /// The lines of a file.
    Lines,
}

#[derive(Clone, Debug)]
pub struct Output {
    pub name: &'static str,
    nickname: &'static str,
    description: &'static str,
    pub of: Type,
    pub source: Source,
}

/// A block of a kind, whose inputs become a request.
#[derive(Clone, Copy, Debug)]
pub struct Recipe {
    pub kind: Kind,
    pub block: &'static Block,
}

impl Recipe {
    /// Returns the blocks of every kind.
    fn all() -> impl Iterator<Item = Self> {
        Kind::ALL.iter().flat_map(|&kind| kind.blocks().iter().map(move |block| Self { kind, block }))
    }
}

/// Part of a job's life that a component covers.
#[derive(Clone, Copy, Debug)]
pub enum Action {
    /// Starts a job and waits for its end.
    Solve(Recipe),
    /// Starts a job and returns its identifier.
    Start(Recipe),
    /// Shows the state of a job of this kind, and its result once there is one.
    Poll(Kind),
    /// Returns a file of a finished job as lines of text.
    Read(File),
}

/// A file that is made from a result on request.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum File {
    Pattern,
    Schedule,
}

#[derive(Clone, Debug)]
pub struct Component {
    /// Last part of the address.
    pub name: String,
    title: String,
    description: String,
    pub action: Action,
    pub inputs: Vec<Input>,
    pub outputs: Vec<Output>,
}

/// Returns all components.
#[must_use]
pub fn components() -> &'static [Component] {
    static COMPONENTS: LazyLock<Vec<Component>> = LazyLock::new(|| {
        let solving = Recipe::all().map(|recipe| Component {
            name: recipe.block.name.into(),
            title: recipe.block.title.into(),
            description: recipe.block.description.into(),
            action: Action::Solve(recipe),
            inputs: inputs(recipe.block),
            outputs: outputs(recipe.kind),
        });
        let starting = Recipe::all().map(|recipe| Component {
            name: format!("{}-start", recipe.block.name),
            title: format!("Start {}", recipe.block.title),
            description: format!(
                "{} Returns at once; {} shows the result.",
                recipe.block.description,
                poll_title(recipe.kind)
            ),
            action: Action::Start(recipe),
            inputs: inputs(recipe.block),
            outputs: vec![JOB],
        });
        let polling = Kind::ALL.iter().map(|&kind| Component {
            name: poll_name(kind),
            title: poll_title(kind),
            description: "Shows the state of a job that a Start component has begun, and its result once there is one."
                .into(),
            action: Action::Poll(kind),
            inputs: POLL_INPUTS.to_vec(),
            outputs: [vec![STATUS, PROGRESS], outputs(kind)].concat(),
        });
        solving.chain(starting).chain(polling).chain(reading()).collect()
    });
    &COMPONENTS
}

/// Returns the components that return files of finished jobs.
fn reading() -> [Component; 2] {
    let component = |name: &str, title: &str, description: &str, file, preset, query| Component {
        name: name.into(),
        title: title.into(),
        description: description.into(),
        action: Action::Read(file),
        inputs: vec![
            Input::required("Job", "J", Type::Text, "Identifier of a job that has succeeded."),
            Input::optional("Query", "Q", Preset::Text(preset), query),
        ],
        outputs: vec![LINES],
    };
    [
        component(
            "pattern",
            "Flat Pattern",
            "Flat pattern of a ruled strip as the text of an SVG or DXF file.",
            File::Pattern,
            "format=svg",
            "Parameters as in an address, such as format=dxf&thickness=2&profile=sheet-metal. GET /openapi.json \
             describes them at getPattern.",
        ),
        component(
            "schedule",
            "Schedule",
            "Members, nodes, bends, cables or supports of a result as a table (CSV), or its numbered members as DXF.",
            File::Schedule,
            "part=members",
            "Parameters as in an address: part=members, nodes, bends, cables or reactions, or format=dxf. \
             GET /openapi.json describes them at getSchedule.",
        ),
    ]
}

/// Returns the component that Hops names: by its last part, by its path, or by its whole address.
///
/// # Errors
/// Returns the text for a name that no component has. It names the component that was probably meant.
pub fn find(pointer: &str) -> Result<&'static Component, String> {
    /// Length of the longest name that is compared with the known ones, which are shorter than 30 characters.
    const LONGEST: usize = 60;
    let pointer = pointer.trim_end_matches('/');
    let name = pointer.rsplit('/').next().unwrap_or(pointer);
    components().iter().find(|component| component.name == name).ok_or_else(|| {
        let given = name.to_ascii_lowercase().replace('_', "-");
        let known = components().iter().filter(|_| given.len() <= LONGEST).map(|component| component.name.as_str());
        match known.map(|known| (edit_distance(&given, known), known)).min() {
            Some((steps, known)) if 4 * steps <= known.len() => {
                format!("no such component; did you mean {known}? GET /hops lists all")
            }
            _ => "no such component; GET /hops lists all".into(),
        }
    })
}

/// Returns the name of the component that shows jobs of a kind.
#[must_use]
pub fn poll_name(kind: Kind) -> String {
    format!("{}-poll", kind.blocks()[0].name)
}

fn poll_title(kind: Kind) -> String {
    format!("Poll {}", kind.blocks()[0].title)
}

/// Description of the input `Options`, which can set any field of a request.
const OPTIONS: &str = "Further fields of the service's request as a JSON object, which replace those made of the other \
    inputs. Lists are appended. GET /openapi.json describes them.";
const TOLERANCE: &str = "Largest distance between a curve and the polyline that stands for it. Polylines are taken as \
    they are. 0 means a two-thousandth of the diagonal of the curve's box.";

fn inputs(block: &Block) -> Vec<Input> {
    let mut inputs = block.inputs.to_vec();
    if inputs.iter().any(|input| input.of == Type::Curve) {
        inputs.push(Input::optional("Tolerance", "Tol", Preset::Number(0.0), TOLERANCE));
    }
    inputs.push(Input::optional("Options", "Opt", Preset::Text("{}"), OPTIONS));
    inputs
}

const POLL_INPUTS: [Input; 2] = [
    Input::required("Job", "J", Type::Text, "Identifier from a Start component."),
    Input::optional(
        "Refresh",
        "R",
        Preset::Number(0.0),
        "Any number. Hops may repeat its last answer unless an input changes, so connect a counter or a timer.",
    ),
];

const fn output(
    name: &'static str,
    nickname: &'static str,
    of: Type,
    source: Source,
    description: &'static str,
) -> Output {
    Output { name, nickname, description, of, source }
}

const JOB: Output = output("Job", "J", Type::Text, Source::Job, "Identifier of the job.");
const STATUS: Output =
    output("Status", "St", Type::Text, Source::Status, "queued, running, succeeded, failed or cancelled.");
const PROGRESS: Output =
    output("Progress", "P", Type::Number, Source::Progress, "Fraction of the work that is done, from 0 to 1.");

const LINES: Output = output("Lines", "L", Type::Text, Source::Lines, "The file, line by line.");

const STATISTICS: Output = output("Statistics", "S", Type::Text, Source::Statistics, "All figures, one on each line.");

fn outputs(kind: Kind) -> Vec<Output> {
    let own = kind
        .outputs()
        .iter()
        .map(|own| output(own.name, own.nickname, own.of, Source::Result(own.source), own.description));
    own.chain([STATISTICS, JOB]).collect()
}

impl Component {
    /// Returns the description that Hops asks for. `base` is the base path of this server.
    #[must_use]
    pub fn description(&self, base: &str) -> Value {
        let inputs: Vec<Value> = self.inputs.iter().map(described).collect();
        let outputs: Vec<Value> = self.outputs.iter().map(Output::description).collect();
        let subcategory = match self.action {
            Action::Solve(_) => "Solve",
            Action::Start(_) | Action::Poll(_) => "Long jobs",
            Action::Read(_) => "Files",
        };
        json!({
            "Uri": format!("{base}/hops/{}", self.name),
            "Name": self.title,
            "Nickname": self.title,
            "Description": self.description,
            "Category": "Plateau",
            "Subcategory": subcategory,
            "Icon": icon(),
            "Inputs": inputs,
            "Outputs": outputs,
        })
    }
}

fn described(input: &Input) -> Value {
    // The largest number of 32 bits stands for no limit.
    let number = input.at_least.map_or((1, 1), |least| (least, i32::MAX));
    let mut description = parameter([input.name, input.nickname, input.description], input.of, number);
    if let Some(preset) = input.default {
        description["Default"] = preset.into();
    }
    description
}

impl Output {
    fn description(&self) -> Value {
        parameter([self.name, self.nickname, self.description], self.of, (1, i32::MAX))
    }
}

/// Returns the description of an input or output that has from `least` to `most` values.
fn parameter([name, nickname, description]: [&str; 3], of: Type, (least, most): (u32, i32)) -> Value {
    json!({
        "Name": name, "Nickname": nickname, "Description": description,
        "ParamType": parameter_type(of), "ResultType": result_type(of), "AtLeast": least, "AtMost": most,
    })
}

/// Returns the type of Grasshopper parameter that Hops creates for an input or output.
fn parameter_type(of: Type) -> &'static str {
    match of {
        Type::Boolean => "Boolean",
        Type::Curve => "Curve",
        Type::Integer => "Integer",
        Type::Mesh => "Mesh",
        Type::Number => "Number",
        Type::Point => "Point",
        Type::Text => "Text",
        Type::Vector => "Vector",
    }
}

/// Returns the .NET type of the values.
#[must_use]
pub fn result_type(of: Type) -> &'static str {
    match of {
        Type::Boolean => "System.Boolean",
        Type::Curve => "Rhino.Geometry.Curve",
        Type::Integer => "System.Int32",
        Type::Mesh => "Rhino.Geometry.Mesh",
        Type::Number => "System.Double",
        Type::Point => "Rhino.Geometry.Point3d",
        Type::Text => "System.String",
        Type::Vector => "Rhino.Geometry.Vector3d",
    }
}

/// Returns the icon of all components: a PNG of 24 × 24 pixels in base64.
fn icon() -> String {
    base64::engine::general_purpose::STANDARD.encode(include_bytes!("icon.png"))
}
