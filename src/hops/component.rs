//! The components with their inputs and outputs, as Grasshopper shows them.

use base64::Engine as _;
use plateau_forms::kind::Kind;
use serde_json::{Value, json};
use std::sync::LazyLock;

/// Type of an input or output in the words of Grasshopper.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Type {
    Boolean,
    Curve,
    Integer,
    Mesh,
    Number,
    Point,
    Text,
    Vector,
}

impl Type {
    /// Returns the name by which Hops finds the parameter of Grasshopper.
    #[must_use]
    pub fn name(self) -> &'static str {
        match self {
            Self::Boolean => "Boolean",
            Self::Curve => "Curve",
            Self::Integer => "Integer",
            Self::Mesh => "Mesh",
            Self::Number => "Number",
            Self::Point => "Point",
            Self::Text => "Text",
            Self::Vector => "Vector",
        }
    }

    /// Returns the .NET type of the values.
    #[must_use]
    pub fn result(self) -> &'static str {
        match self {
            Self::Boolean => "System.Boolean",
            Self::Curve => "Rhino.Geometry.Curve",
            Self::Integer => "System.Int32",
            Self::Mesh => "Rhino.Geometry.Mesh",
            Self::Number => "System.Double",
            Self::Point => "Rhino.Geometry.Point3d",
            Self::Text => "System.String",
            Self::Vector => "Rhino.Geometry.Vector3d",
        }
    }
}

/// An input. Grasshopper does not run a component while an input without a default has no value.
#[derive(Clone, Debug)]
pub struct Input {
    pub name: &'static str,
    nickname: &'static str,
    description: &'static str,
    pub of: Type,
    /// Smallest number of values of a list. `None` for an input that takes one value.
    pub at_least: Option<u32>,
    pub default: Option<Value>,
}

/// Part of a result that is geometry, or belongs to geometry item by item.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord)]
pub enum Geometry {
    Mesh,
    Area,
    Rulings,
    Outlines,
    Folds,
    FoldAngles,
    Members,
    MemberLengths,
    Cables,
    CableForces,
    Anchors,
    AnchorForces,
}

/// Source of an output's values.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Source {
    Geometry(Geometry),
    /// JSON Pointer into the job's statistics.
    Statistic(&'static str),
    /// All statistics as lines of text.
    Statistics,
    Job,
    Status,
    Progress,
}

#[derive(Clone, Debug)]
pub struct Output {
    pub name: &'static str,
    nickname: &'static str,
    description: &'static str,
    pub of: Type,
    pub source: Source,
}

/// Way to make a request of a component's inputs.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Recipe {
    MinimalSurface,
    FilmFromMesh,
    RuledStrip,
    UniformMesh,
    TensileStructure,
    PneumaticFilm,
    CableNet,
}

impl Recipe {
    const ALL: [Self; 7] = [
        Self::MinimalSurface,
        Self::FilmFromMesh,
        Self::RuledStrip,
        Self::UniformMesh,
        Self::TensileStructure,
        Self::PneumaticFilm,
        Self::CableNet,
    ];

    #[must_use]
    pub fn kind(self) -> Kind {
        match self {
            Self::MinimalSurface | Self::FilmFromMesh => Kind::MinimalSurface,
            Self::RuledStrip => Kind::RuledSurface,
            Self::UniformMesh => Kind::UniformMesh,
            Self::TensileStructure | Self::PneumaticFilm => Kind::TensileStructure,
            Self::CableNet => Kind::CableNet,
        }
    }

    fn name(self) -> &'static str {
        match self {
            Self::MinimalSurface => "minimal-surface",
            Self::FilmFromMesh => "film-from-mesh",
            Self::RuledStrip => "ruled-strip",
            Self::UniformMesh => "uniform-mesh",
            Self::TensileStructure => "tensile-structure",
            Self::PneumaticFilm => "pneumatic-film",
            Self::CableNet => "cable-net",
        }
    }

    fn title(self) -> &'static str {
        match self {
            Self::MinimalSurface => "Minimal Surface",
            Self::FilmFromMesh => "Film From Mesh",
            Self::RuledStrip => "Ruled Strip",
            Self::UniformMesh => "Uniform Mesh",
            Self::TensileStructure => "Tensile Structure",
            Self::PneumaticFilm => "Pneumatic Film",
            Self::CableNet => "Cable Net",
        }
    }

    fn description(self) -> &'static str {
        match self {
            Self::MinimalSurface => "Minimal surface that spans closed curves.",
            Self::FilmFromMesh => {
                "Minimal surface with the topology of a mesh and its naked edges as boundaries. Sheets may meet three by three."
            }
            Self::RuledStrip => "Best triangulated strip between two or more curves, with its flat pattern.",
            Self::UniformMesh => {
                "Mesh with as many equal edges as possible, of a planar region or of the minimal surface in closed curves."
            }
            Self::TensileStructure => "Film in equilibrium with cables along its edges between anchors.",
            Self::PneumaticFilm => "Film in equilibrium with a pressure or around a volume, on fixed edges.",
            Self::CableNet => "Net of cables in equilibrium that comes nearest to target forces and lengths.",
        }
    }
}

/// Part of a job's life that a component covers.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Action {
    /// Starts a job and waits for its end.
    Solve(Recipe),
    /// Starts a job and returns its identifier.
    Start(Recipe),
    /// Shows the state of a job of this kind, and its result once there is one.
    Poll(Kind),
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
        let solving = Recipe::ALL.into_iter().map(|recipe| Component {
            name: recipe.name().into(),
            title: recipe.title().into(),
            description: recipe.description().into(),
            action: Action::Solve(recipe),
            inputs: inputs(recipe),
            outputs: outputs(recipe.kind()),
        });
        let starting = Recipe::ALL.into_iter().map(|recipe| Component {
            name: format!("{}-start", recipe.name()),
            title: format!("Start {}", recipe.title()),
            description: format!(
                "{} Returns at once; {} shows the result.",
                recipe.description(),
                poll_title(recipe.kind())
            ),
            action: Action::Start(recipe),
            inputs: inputs(recipe),
            outputs: vec![JOB],
        });
        let polling = Kind::ALL.into_iter().map(|kind| Component {
            name: poll_name(kind),
            title: poll_title(kind),
            description: "Shows the state of a job that a Start component has begun, and its result once there is one."
                .into(),
            action: Action::Poll(kind),
            inputs: poll_inputs(),
            outputs: [vec![STATUS, PROGRESS], outputs(kind)].concat(),
        });
        solving.chain(starting).chain(polling).collect()
    });
    &COMPONENTS
}

/// Returns the component that Hops names: by its last part, by its path, or by its whole address.
#[must_use]
pub fn find(pointer: &str) -> Option<&'static Component> {
    let name = pointer.rsplit('/').next().unwrap_or(pointer);
    components().iter().find(|component| component.name == name)
}

/// Returns the name of the component that shows jobs of a kind.
#[must_use]
pub fn poll_name(kind: Kind) -> String {
    format!("{}-poll", family(kind).name())
}

fn poll_title(kind: Kind) -> String {
    format!("Poll {}", family(kind).title())
}

/// Returns the recipe after which the jobs of a kind are named.
fn family(kind: Kind) -> Recipe {
    match kind {
        Kind::MinimalSurface => Recipe::MinimalSurface,
        Kind::RuledSurface => Recipe::RuledStrip,
        Kind::UniformMesh => Recipe::UniformMesh,
        Kind::TensileStructure => Recipe::TensileStructure,
        Kind::CableNet => Recipe::CableNet,
    }
}

const fn required(
    name: &'static str,
    nickname: &'static str,
    of: Type,
    at_least: Option<u32>,
    description: &'static str,
) -> Input {
    Input { name, nickname, description, of, at_least, default: None }
}

fn optional(
    name: &'static str,
    nickname: &'static str,
    of: Type,
    default: impl Into<Value>,
    description: &'static str,
) -> Input {
    Input { name, nickname, description, of, at_least: None, default: Some(default.into()) }
}

/// Text of the input with which every field of a request can be given.
const OPTIONS: &str = "Further fields of the service's request as a JSON object, which replace those made of the other inputs. \
    Lists are appended. GET /openapi.json describes them.";
const TOLERANCE: &str = "Largest distance between a curve and the polyline that stands for it. Polylines are taken as they are. \
    0 means a two-thousandth of the diagonal of the curve's box.";

fn inputs(recipe: Recipe) -> Vec<Input> {
    let boundaries = required("Boundaries", "B", Type::Curve, Some(1), "Closed curves.");
    let triangles = || optional("Triangles", "T", Type::Integer, 2000, "Number of triangles.");
    let edge_length = || {
        optional(
            "Edge Length",
            "L",
            Type::Number,
            0.0,
            "Mean edge length in place of the number of triangles, unless 0.",
        )
    };
    let weight = || optional("Film Weight", "W", Type::Number, 0.0, "Weight of the film per area, against the z axis.");
    let tension = || optional("Film Tension", "S", Type::Number, 1.0, "Tension of the film, a force per length.");
    let mut inputs = match recipe {
        Recipe::MinimalSurface => vec![
            boundaries,
            triangles(),
            edge_length(),
            optional(
                "Objective",
                "O",
                Type::Text,
                "minimal_area",
                "minimal_area, minimal_dirichlet_energy or minimal_mean_curvature.",
            ),
            optional(
                "Topology",
                "G",
                Type::Text,
                "fixed",
                "fixed, free (necks may pinch) or best (the smallest of all ways to span the curves).",
            ),
        ],
        Recipe::FilmFromMesh => vec![
            required(
                "Mesh",
                "M",
                Type::Mesh,
                None,
                "Initial mesh. Equal vertices are joined, and quadrilaterals are split. Its naked edges stay where they are.",
            ),
            optional(
                "Objective",
                "O",
                Type::Text,
                "minimal_area",
                "minimal_area, minimal_dirichlet_energy or minimal_mean_curvature.",
            ),
        ],
        Recipe::RuledStrip => vec![
            required(
                "Rails",
                "R",
                Type::Curve,
                Some(2),
                "Curves in order. If all are closed, the strip is closed too.",
            ),
            optional(
                "Objective",
                "O",
                Type::Text,
                "minimal_area",
                "minimal_area, minimal_twist, maximal_convexity, minimal_bending_energy or minimal_mean_curvature_variation.",
            ),
            optional(
                "Samples",
                "N",
                Type::Integer,
                0,
                "Number of points along each rail, at equal distances. 0 takes the points that the tolerance gives.",
            ),
            optional(
                "Align",
                "A",
                Type::Boolean,
                true,
                "Whether a rail that runs against the one before it is reversed.",
            ),
        ],
        Recipe::UniformMesh => vec![
            required(
                "Boundaries",
                "B",
                Type::Curve,
                Some(1),
                "Closed curves: an outline and its holes in one plane or, with Film, the boundaries of a minimal surface.",
            ),
            required("Edge Length", "L", Type::Number, None, "Length of as many edges as possible."),
            optional("Film", "F", Type::Boolean, false, "Whether the minimal surface in the curves is meshed."),
            optional("Objective", "O", Type::Text, "most_equal_edges", "most_equal_edges or fewest_nodes."),
            optional("Lengths", "N", Type::Integer, 0, "Largest number of different member lengths. 0 sets no limit."),
        ],
        Recipe::TensileStructure => vec![
            boundaries,
            required(
                "Anchors",
                "A",
                Type::Point,
                Some(2),
                "Fixed points on the boundaries. A cable runs along the edge between neighbouring anchors. A boundary \
                    without anchors is fixed as a whole.",
            ),
            required("Cable Value", "C", Type::Number, None, "Value that the mode holds constant for every cable."),
            optional(
                "Cable Mode",
                "M",
                Type::Text,
                "force",
                "force, end_tension, horizontal_component, force_density, length or sag.",
            ),
            tension(),
            weight(),
            triangles(),
        ],
        Recipe::PneumaticFilm => vec![
            boundaries,
            optional(
                "Pressure",
                "P",
                Type::Number,
                0.0,
                "Force per area, towards the side from which the first boundary runs counter-clockwise.",
            ),
            optional("Volume", "V", Type::Number, 0.0, "Volume under the film in place of the pressure, unless 0."),
            tension(),
            weight(),
            triangles(),
        ],
        Recipe::CableNet => vec![
            required(
                "Cables",
                "C",
                Type::Curve,
                Some(1),
                "Lines and polylines. Each segment is an edge of the net, and equal points are joined.",
            ),
            required("Supports", "A", Type::Point, Some(1), "Points of the cables that do not move."),
            required("Cable Value", "V", Type::Number, None, "Target of every edge."),
            optional(
                "Cable Mode",
                "M",
                Type::Text,
                "force",
                "Meaning of the value: force, length (of each edge) or force_density.",
            ),
            optional("Load", "W", Type::Number, 0.0, "Weight on every point that is no support, against the z axis."),
        ],
    };
    if recipe != Recipe::FilmFromMesh {
        inputs.push(optional("Tolerance", "Tol", Type::Number, 0.0, TOLERANCE));
    }
    inputs.push(optional("Options", "Opt", Type::Text, "{}", OPTIONS));
    inputs
}

fn poll_inputs() -> Vec<Input> {
    vec![
        required("Job", "J", Type::Text, None, "Identifier from a Start component."),
        optional(
            "Refresh",
            "R",
            Type::Number,
            0.0,
            "Any number. Hops may repeat its last answer unless an input changes, so connect a counter or a timer.",
        ),
    ]
}

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

fn outputs(kind: Kind) -> Vec<Output> {
    let geometry =
        |part, name, nickname, of, description| output(name, nickname, of, Source::Geometry(part), description);
    let figure =
        |pointer, name, nickname, of, description| output(name, nickname, of, Source::Statistic(pointer), description);
    let mesh = geometry(Geometry::Mesh, "Mesh", "M", Type::Mesh, "The mesh, with vertices in double precision.");
    let area = "Area of the mesh.";
    let surface = match kind {
        // A net has neither triangles nor an area.
        Kind::CableNet => Vec::new(),
        // The statistics of a uniform mesh have no area.
        Kind::UniformMesh => vec![mesh, geometry(Geometry::Area, "Area", "A", Type::Number, area)],
        _ => vec![mesh, figure("/area", "Area", "A", Type::Number, area)],
    };
    let cables = |cables, description| {
        let forces = "Force in each of them.";
        vec![
            geometry(Geometry::Cables, "Cables", "Ca", Type::Curve, cables),
            geometry(Geometry::CableForces, "Cable Forces", "F", Type::Number, forces),
            geometry(Geometry::Anchors, "Anchor Points", "AP", Type::Point, description),
            geometry(
                Geometry::AnchorForces,
                "Anchor Forces",
                "AF",
                Type::Vector,
                "Force of each of these supports on the structure.",
            ),
        ]
    };
    let converged = figure("/converged", "Converged", "C", Type::Boolean, "Whether the solver reached its tolerance.");
    let own = match kind {
        Kind::MinimalSurface => vec![converged],
        Kind::RuledSurface => vec![
            geometry(Geometry::Rulings, "Rulings", "R", Type::Curve, "Lines between the rails."),
            geometry(Geometry::Outlines, "Outlines", "O", Type::Curve, "Outlines of the flat pattern in the xy plane."),
            geometry(Geometry::Folds, "Folds", "F", Type::Curve, "Folds of the flat pattern."),
            geometry(
                Geometry::FoldAngles,
                "Fold Angles",
                "FA",
                Type::Number,
                "Angle of each fold in degrees, positive for a mountain fold.",
            ),
        ],
        Kind::UniformMesh => vec![
            geometry(Geometry::Members, "Members", "E", Type::Curve, "Edges of the mesh, those of the lattice first."),
            geometry(Geometry::MemberLengths, "Member Lengths", "L", Type::Number, "Length of each member."),
            figure("/equal_edges", "Equal Edges", "N", Type::Integer, "Number of members of the edge length."),
        ],
        Kind::TensileStructure => [
            vec![converged, figure("/pressure", "Pressure", "P", Type::Number, "Pressure, given or found.")],
            cables("Segments of the cables.", "Supports at the ends of cables."),
        ]
        .concat(),
        Kind::CableNet => [
            vec![converged, figure("/objective_value", "Loss", "L", Type::Number, "Deviation from the targets.")],
            cables("Edges of the net.", "The supports."),
        ]
        .concat(),
    };
    let statistics = output("Statistics", "S", Type::Text, Source::Statistics, "All figures, one on each line.");
    [surface, own, vec![statistics, JOB]].concat()
}

impl Component {
    /// Returns the description that Hops asks for. `base` is the base path of this server.
    #[must_use]
    pub fn description(&self, base: &str) -> Value {
        let inputs: Vec<Value> = self.inputs.iter().map(Input::description).collect();
        let outputs: Vec<Value> = self.outputs.iter().map(Output::description).collect();
        let subcategory = match self.action {
            Action::Solve(_) => "Solve",
            Action::Start(_) | Action::Poll(_) => "Long jobs",
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

impl Input {
    fn description(&self) -> Value {
        // The largest number of 32 bits stands for no limit.
        let number = self.at_least.map_or((1, 1), |least| (least, i32::MAX));
        let mut description = parameter([self.name, self.nickname, self.description], self.of, number);
        if let Some(default) = &self.default {
            description["Default"] = default.clone();
        }
        description
    }
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
        "ParamType": of.name(), "ResultType": of.result(), "AtLeast": least, "AtMost": most,
    })
}

/// Returns the icon of all components: a PNG of 24 × 24 pixels in base64.
fn icon() -> String {
    base64::engine::general_purpose::STANDARD.encode(include_bytes!("icon.png"))
}
