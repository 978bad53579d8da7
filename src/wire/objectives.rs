//! Catalogue of the service: objectives, limits and example requests.

use crate::config::Config;
use plateau_engine::kind::{Kind, Objective};
use plateau_engine::kinds;
use schemars::{JsonSchema, Schema, SchemaGenerator};
use serde::Serialize;
use serde_json::Value;
use std::sync::LazyLock;

#[derive(Clone, Debug, Serialize, JsonSchema)]
pub struct ObjectiveList {
    pub objectives: Vec<Objective>,
}

#[must_use]
pub fn objectives() -> ObjectiveList {
    ObjectiveList { objectives: kinds::objectives() }
}

/// Limits of this server: of one request, of one key, and of all keys together. On a server without keys, the client's
/// address stands for the key.
#[derive(Clone, Debug, Serialize, JsonSchema)]
pub struct Limits {
    /// Largest size of a request's body in bytes.
    pub body_bytes: usize,
    /// Largest number of points of all polylines of a request, and of vertices of a cable net.
    pub points: usize,
    /// Largest number of triangles of a minimal surface, a uniform mesh or a tensile structure, and of edges of a cable
    /// net.
    pub triangles: usize,
    /// Largest number of cells of the grids of all strips of a ruled surface.
    pub grid_cells: u64,
    /// Largest `max_iterations`.
    pub iterations: u32,
    /// Time that a solver has, in milliseconds. After it the solver returns the best mesh that it has reached.
    pub deadline_ms: u64,
    /// Longest wait that `Prefer: wait` can ask for, in seconds.
    pub wait_max_s: u64,
    /// Largest number of requests of one batch.
    pub batch_requests: usize,
    /// Whether requests may name a `callback_url`.
    pub webhooks: bool,
    /// Number of jobs that may wait in the queue.
    pub queue_length: usize,
    /// Number of jobs of one key that may wait in the queue.
    pub queue_length_per_key: usize,
    /// Number of requests that one key may have open at once: event streams, waits, downloads and uploads.
    pub open_requests_per_key: usize,
    /// Number of finished jobs that are kept. If there are more, the keys with the most jobs lose their oldest ones.
    pub jobs_kept: u64,
    /// Number of bytes that the results of all finished jobs may take. If they take more, the keys with the largest
    /// results lose their oldest ones. 0 means no limit.
    pub bytes_kept: u64,
    /// Time in seconds after its end at which a job is removed with its mesh. 0 means never.
    pub retention_s: u64,
}

impl Limits {
    #[must_use]
    pub fn of(config: &Config) -> Self {
        Self {
            body_bytes: config.limits.body_bytes,
            points: config.limits.points,
            triangles: config.limits.triangles,
            grid_cells: config.limits.grid_cells,
            iterations: config.limits.iterations,
            deadline_ms: config.jobs.deadline_ms,
            wait_max_s: config.http.wait_max_s,
            batch_requests: config.limits.batch_requests,
            webhooks: !config.webhooks.secret_file.as_os_str().is_empty(),
            queue_length: config.jobs.queue_length,
            queue_length_per_key: config.owner_queue_length(),
            open_requests_per_key: config.open_requests(),
            jobs_kept: config.store.max_jobs,
            bytes_kept: config.store.max_bytes,
            retention_s: config.jobs.retention_s,
        }
    }
}

/// An example request.
#[derive(Clone, Debug, Serialize, JsonSchema)]
pub struct Example {
    pub name: &'static str,
    pub kind: Kind,
    pub title: &'static str,
    /// Request to post to the path of its kind.
    #[schemars(schema_with = "request_with_kind")]
    pub request: Value,
}

fn request_with_kind(_: &mut SchemaGenerator) -> Schema {
    schemars::json_schema!({ "$ref": "#/components/schemas/RequestWithKind" })
}

#[derive(Clone, Debug, Serialize, JsonSchema)]
pub struct ExampleSummary {
    pub name: &'static str,
    pub kind: Kind,
    pub title: &'static str,
}

#[derive(Clone, Debug, Serialize, JsonSchema)]
pub struct ExampleList {
    pub examples: Vec<ExampleSummary>,
}

/// `(name, title, text of api/examples/NAME.json)`. Each file is a request with its `kind`. A test sends each.
const FILES: &[(&str, &str, &str)] = &[
    ("two-rails", "A strip between rails of three and two points", include_str!("../../api/examples/two-rails.json")),
    (
        "helicoid",
        "Chen-Cai-Zheng's helicoid patch, 186 boundary points, 2050 triangles",
        include_str!("../../api/examples/helicoid.json"),
    ),
    (
        "catenoid",
        "Chen-Cai-Zheng's catenoid patch, 156 boundary points, 2040 triangles",
        include_str!("../../api/examples/catenoid.json"),
    ),
    ("tent", "A tent over a square with one high corner", include_str!("../../api/examples/tent.json")),
    (
        "four-corners",
        "Four edges of a tetrahedron, given by their corners alone",
        include_str!("../../api/examples/four-corners.json"),
    ),
    (
        "ridge-rope",
        "A tent with a fixed ridge from corner to corner",
        include_str!("../../api/examples/ridge-rope.json"),
    ),
    ("own-mesh", "A film from the client's own initial mesh", include_str!("../../api/examples/own-mesh.json")),
    (
        "helicoid-relaxation",
        "Chen-Cai-Zheng's helicoid by their own rings and relaxation",
        include_str!("../../api/examples/helicoid-relaxation.json"),
    ),
    ("two-rings", "A film between two coaxial rings", include_str!("../../api/examples/two-rings.json")),
    (
        "rings-12-free",
        "Two rings at a distance of 0.6 of their diameter: the catenoid holds",
        include_str!("../../api/examples/rings-12-free.json"),
    ),
    (
        "rings-12-best",
        "The same rings: two discs have less area than their catenoid, which is stable",
        include_str!("../../api/examples/rings-12-best.json"),
    ),
    (
        "rings-11-proven",
        "Rings closer together: the two discs have the least area of all surfaces, proven up to 2%",
        include_str!("../../api/examples/rings-11-proven.json"),
    ),
    (
        "rings-14-free",
        "Two rings too far apart for a catenoid: the neck pinches, two discs are left",
        include_str!("../../api/examples/rings-14-free.json"),
    ),
    (
        "rings-14-best",
        "The same rings, every way to span them compared",
        include_str!("../../api/examples/rings-14-best.json"),
    ),
    (
        "rings-14-pinkall-polthier",
        "The same rings by Bento and Cavalcanti's own method (their Fig. 7)",
        include_str!("../../api/examples/rings-14-pinkall-polthier.json"),
    ),
    (
        "cut-cylinder",
        "A cylinder cut along a line, by Bento and Cavalcanti's own method (their Fig. 9)",
        include_str!("../../api/examples/cut-cylinder.json"),
    ),
    (
        "three-rings",
        "Three rings in a row, every way to span them compared",
        include_str!("../../api/examples/three-rings.json"),
    ),
    (
        "tetrahedron-loops",
        "Four loops on a tetrahedron's faces, every way to span them compared",
        include_str!("../../api/examples/tetrahedron-loops.json"),
    ),
    (
        "nested-loops",
        "A loop inside another in the plane, every way to span them compared",
        include_str!("../../api/examples/nested-loops.json"),
    ),
    (
        "three-half-circles",
        "Three half-discs that meet at 120° along a diameter, from a displaced start",
        include_str!("../../api/examples/three-half-circles.json"),
    ),
    (
        "three-half-circles-uneven",
        "Half-circles 100°, 120° and 140° apart: the sheets still meet at 120°",
        include_str!("../../api/examples/three-half-circles-uneven.json"),
    ),
    (
        "helicoid-liu-wang",
        "Liu and Wang's helicoid, 28 boundary and 20 interior points",
        include_str!("../../api/examples/helicoid-liu-wang.json"),
    ),
    (
        "scherk-relaxation",
        "Scherk's surface by Chen-Cai-Zheng's processes in a custom order, with both tolerances",
        include_str!("../../api/examples/scherk-relaxation.json"),
    ),
    (
        "wavy-strip",
        "A strip between a wave of 60 and a wave of 80 points",
        include_str!("../../api/examples/wavy-strip.json"),
    ),
    (
        "contour-stack",
        "Five closed contours with unequal numbers of points",
        include_str!("../../api/examples/contour-stack.json"),
    ),
    ("wang-tang-i", "Two wavy rails (Wang and Tang, example I)", include_str!("../../api/examples/wang-tang-i.json")),
    (
        "wang-tang-ii",
        "Two very different rails, coupled objectives (Wang and Tang, example II)",
        include_str!("../../api/examples/wang-tang-ii.json"),
    ),
    ("wang-tang-iii", "A ribbon (Wang and Tang, example III)", include_str!("../../api/examples/wang-tang-iii.json")),
    (
        "wang-tang-iv",
        "A wrinkled hem (Wang and Tang, example IV)",
        include_str!("../../api/examples/wang-tang-iv.json"),
    ),
    (
        "wang-tang-v",
        "A blend between two surfaces with given normals (Wang and Tang, example V)",
        include_str!("../../api/examples/wang-tang-v.json"),
    ),
    (
        "wang-tang-vi",
        "A flange on a sheet metal part (Wang and Tang, example VI)",
        include_str!("../../api/examples/wang-tang-vi.json"),
    ),
    (
        "latticed-roof",
        "A Bézier roof of about 950 members, lengths near 5 (Katoh, Ohsaki and Xu)",
        include_str!("../../api/examples/latticed-roof.json"),
    ),
    ("latticed-roof-steep", "A steeper Bézier roof", include_str!("../../api/examples/latticed-roof-steep.json")),
    (
        "latticed-film",
        "A film over a frame with humps, as a lattice",
        include_str!("../../api/examples/latticed-film.json"),
    ),
    (
        "latticed-roof-few-lengths",
        "A Bézier roof whose members are drawn towards twelve lengths",
        include_str!("../../api/examples/latticed-roof-few-lengths.json"),
    ),
    (
        "floor-fewest-nodes",
        "A convex polygon with as few nodes as possible",
        include_str!("../../api/examples/floor-fewest-nodes.json"),
    ),
    (
        "floor-equal-members",
        "The same polygon with as many equal members as possible",
        include_str!("../../api/examples/floor-equal-members.json"),
    ),
    (
        "courtyard",
        "A plaza with a courtyard and a re-entrant corner, as few nodes as possible",
        include_str!("../../api/examples/courtyard.json"),
    ),
    (
        "plane-sail",
        "A plane sail: four edge cables of one force, each an arc",
        include_str!("../../api/examples/plane-sail.json"),
    ),
    (
        "four-point-sail",
        "A sail between two low and two high points, its edge cables by force, sag, length and force density",
        include_str!("../../api/examples/four-point-sail.json"),
    ),
    (
        "inflated-disc",
        "A round film under pressure: a cap of a sphere",
        include_str!("../../api/examples/inflated-disc.json"),
    ),
    (
        "conic-tent",
        "A conic tent on a mast, with half the stress around it: edge cables, and a ring that the mast lifts",
        include_str!("../../api/examples/conic-tent.json"),
    ),
    (
        "flying-mast",
        "A tent whose mast stands on four stays between its corners",
        include_str!("../../api/examples/flying-mast.json"),
    ),
    (
        "ridge-and-valley",
        "A roof with a ridge cable between two valley cables, on edge cables between high and low points",
        include_str!("../../api/examples/ridge-and-valley.json"),
    ),
    (
        "air-hall",
        "An air hall under pressure in a net of hoop cables and a spine",
        include_str!("../../api/examples/air-hall.json"),
    ),
    (
        "cushion",
        "A cushion of constant volume: two films of different prestress over a hexagon, and the pressure between them",
        include_str!("../../api/examples/cushion.json"),
    ),
    (
        "film-on-a-plane",
        "A half catenoid that slides on a plane and meets it at a right angle",
        include_str!("../../api/examples/film-on-a-plane.json"),
    ),
    (
        "four-cables",
        "Four cables with given forces carry a load between two low and two high points",
        include_str!("../../api/examples/four-cables.json"),
    ),
    (
        "cable-net-by-targets",
        "A cable net between two low and two high points: forces of 20 kN on the rim, equal lengths inside",
        include_str!("../../api/examples/cable-net-by-targets.json"),
    ),
    (
        "vault",
        "A cylindrical vault (NURBS) whose members are drawn towards eight lengths",
        include_str!("../../api/examples/vault.json"),
    ),
];

/// Returns the examples in the order of the list. A build without certificates has none that asks for one.
#[must_use]
pub fn examples() -> &'static [Example] {
    static EXAMPLES: LazyLock<Vec<Example>> = LazyLock::new(|| {
        FILES
            .iter()
            .map(|&(name, title, text)| {
                let request: Value = serde_json::from_str(text).expect("an embedded example is JSON");
                let kind =
                    request["kind"].as_str().and_then(Kind::from_name).expect("an embedded example names its kind");
                Example { name, kind, title, request }
            })
            .filter(|example| cfg!(feature = "certificates") || example.request.get("certify").is_none())
            .collect()
    });
    &EXAMPLES
}

/// Returns the names of all examples, also of those that this build leaves out, because every build has the same API
/// document.
#[must_use]
pub fn example_names() -> Vec<&'static str> {
    FILES.iter().map(|&(name, ..)| name).collect()
}

#[must_use]
pub fn example_list() -> ExampleList {
    let summary = |example: &Example| ExampleSummary { name: example.name, kind: example.kind, title: example.title };
    ExampleList { examples: examples().iter().map(summary).collect() }
}
