//! `/hops`: descriptions of the components, and messages as Hops sends them.

use crate::access::new_key;
use crate::app::{MINIMAL, TestApp, example, small_film};
use crate::hold::until;
use crate::pairs::some_pairs;
use plateau::hops::envelope;
use plateau_mesh::DVec3;
use plateau_opennurbs::curve::Curve;
use plateau_opennurbs::{Mesh, Object, write};
use reqwest::{Method, Response, StatusCode};
use serde_json::{Value, json};

/// Returns the tree of an input with these values.
fn input(name: &str, items: &[(&str, String)]) -> Value {
    let items: Vec<Value> = items.iter().map(|(of, data)| json!({ "type": of, "data": data })).collect();
    json!({ "ParamName": name, "InnerTree": { "{0}": items } })
}

fn number(name: &str, value: impl Into<Value>) -> Value {
    input(name, &[("System.Double", value.into().to_string())])
}

fn text(name: &str, value: &str) -> Value {
    input(name, &[("System.String", Value::from(value).to_string())])
}

fn curves(name: &str, curves: &[Vec<[f64; 3]>]) -> Value {
    let item = |points: &Vec<[f64; 3]>| {
        let points: Vec<DVec3> = points.iter().copied().map(DVec3::from_array).collect();
        ("Rhino.Geometry.PolylineCurve", envelope::to_json(&write::polyline_curve(&points)))
    };
    input(name, &curves.iter().map(item).collect::<Vec<_>>())
}

fn points(name: &str, points: &[[f64; 3]]) -> Value {
    let item = |[x, y, z]: &[f64; 3]| ("Rhino.Geometry.Point3d", json!({ "X": x, "Y": y, "Z": z }).to_string());
    input(name, &points.iter().map(item).collect::<Vec<_>>())
}

/// Returns a message as Hops sends it, with the fields that only definitions of Grasshopper use.
fn message(pointer: &str, values: &[Value]) -> Value {
    json!({
        "absolutetolerance": 0.001, "angletolerance": 1.0, "modelunits": "Meters", "algo": null, "pointer": pointer,
        "cachesolve": true, "recursionlevel": 0, "values": values, "warnings": [], "errors": [],
    })
}

/// Returns a square with two lifted corners at survey coordinates, which repeats its first point.
fn square(height: f64) -> Vec<[f64; 3]> {
    let at = |x: f64, y: f64, z: f64| [1e6 + x, 2e6 + y, z];
    vec![at(0.1, 0.2, 0.0), at(1.1, 0.2, height), at(1.1, 1.2, 0.0), at(0.1, 1.2, height), at(0.1, 0.2, 0.0)]
}

impl TestApp {
    async fn hops(&self, pointer: &str, values: &[Value]) -> Response {
        self.post("/hops/solve", &message(pointer, values)).await
    }

    /// Runs a component, and fails unless it has outputs and no errors.
    async fn run(&self, pointer: &str, values: &[Value]) -> Value {
        let response = self.hops(pointer, values).await;
        assert_eq!(response.headers()["content-type"], "application/json");
        let status = response.status();
        let answer: Value = response.json().await.expect("JSON");
        assert_eq!(status, StatusCode::OK, "{answer:.2000}");
        assert_eq!(answer["errors"], json!([]));
        self.has_every_output(pointer, &answer).await;
        answer
    }

    /// Checks that an answer has the outputs of the component's description, in its order.
    async fn has_every_output(&self, name: &str, answer: &Value) {
        let described = self.get_json(&format!("/hops/{name}")).await;
        let names = |list: &Value, field: &str| -> Vec<String> {
            list.as_array().unwrap().iter().map(|entry| entry[field].as_str().unwrap().to_owned()).collect()
        };
        assert_eq!(names(&answer["values"], "ParamName"), names(&described["Outputs"], "Name"));
        for (tree, output) in answer["values"].as_array().unwrap().iter().zip(described["Outputs"].as_array().unwrap())
        {
            for item in tree["InnerTree"]["{0}"].as_array().unwrap() {
                assert_eq!(item["type"], output["ResultType"], "{}", tree["ParamName"]);
                let data = item["data"].as_str().unwrap();
                assert!(serde_json::from_str::<Value>(data).is_ok(), "{data}");
                // Hops removes the outer quotation marks of a text and reads no escapes in it.
                if item["type"] == "System.String" {
                    assert!(!data[1..data.len() - 1].contains(['"', '\\']), "{data}");
                }
            }
        }
    }

    /// Asserts that an answer has this status and every output, all empty, and returns its errors.
    async fn refused(&self, name: &str, response: Response, status: u16) -> Vec<String> {
        assert_eq!(response.status().as_u16(), status);
        let answer: Value = response.json().await.expect("JSON");
        self.has_every_output(name, &answer).await;
        assert!(answer["values"].as_array().unwrap().iter().all(|tree| tree["InnerTree"]["{0}"] == json!([])));
        assert_eq!(answer["warnings"], json!([]));
        errors(&answer)
    }
}

fn errors(answer: &Value) -> Vec<String> {
    serde_json::from_value(answer["errors"].clone()).unwrap()
}

/// Returns the data of all values of an output.
fn output(answer: &Value, name: &str) -> Vec<Value> {
    let tree = answer["values"].as_array().unwrap().iter().find(|tree| tree["ParamName"] == name).expect(name);
    let items = tree["InnerTree"]["{0}"].as_array().unwrap();
    items.iter().map(|item| serde_json::from_str(item["data"].as_str().unwrap()).unwrap()).collect()
}

fn mesh(answer: &Value) -> Mesh {
    match envelope::from_json(&output(answer, "Mesh")[0].to_string(), 1_000_000) {
        Ok(Object::Mesh(mesh)) => mesh,
        other => panic!("{other:?}"),
    }
}

fn polyline(object: &Value) -> Vec<DVec3> {
    match envelope::from_json(&object.to_string(), 1_000_000) {
        Ok(Object::Curve(Curve::Polyline(points))) => points,
        other => panic!("{other:?}"),
    }
}

fn area(mesh: &Mesh) -> f64 {
    let at = |vertex: u32| mesh.vertices[vertex as usize];
    mesh.faces.iter().map(|&[a, b, c, _]| (at(b) - at(a)).cross(at(c) - at(a)).length() / 2.0).sum()
}

#[tokio::test]
async fn components_are_described_as_hops_reads_them() {
    let app = TestApp::start().await;
    let list = app.get_json("/hops").await;
    let mut names = Vec::new();
    for described in list.as_array().unwrap() {
        let uri = described["Uri"].as_str().unwrap();
        let response = app.get(uri).await;
        assert!(response.headers()["content-type"].to_str().unwrap().contains("json"));
        assert_eq!(response.json::<Value>().await.unwrap(), *described);
        for field in ["Name", "Nickname", "Description", "Category", "Subcategory", "Icon"] {
            assert!(described[field].as_str().is_some_and(|text| !text.is_empty()), "{uri}: {field}");
        }
        let parameters =
            || described["Inputs"].as_array().unwrap().iter().chain(described["Outputs"].as_array().unwrap());
        for parameter in parameters() {
            let of = parameter["ParamType"].as_str().unwrap();
            assert!(["Boolean", "Curve", "Integer", "Mesh", "Number", "Point", "Text", "Vector"].contains(&of));
            assert!(parameter["AtLeast"].as_i64() >= Some(1) && parameter["AtMost"].as_i64() >= Some(1));
        }
        // Grasshopper finds parameters by their names.
        for side in ["Inputs", "Outputs"] {
            let mut names: Vec<_> =
                described[side].as_array().unwrap().iter().map(|one| one["Name"].to_string()).collect();
            let count = names.len();
            names.sort();
            names.dedup();
            assert_eq!(names.len(), count, "{uri}: {side}");
        }
        names.push(uri.rsplit('/').next().unwrap().to_owned());
    }
    let solving = [
        "ruled-strip",
        "minimal-surface",
        "film-from-mesh",
        "uniform-mesh",
        "tensile-structure",
        "pneumatic-film",
        "cable-net",
        // Only builds for tests have this kind.
        "enlargement",
    ];
    let starting = solving.map(|name| format!("{name}-start"));
    let polling = ["ruled-strip", "minimal-surface", "uniform-mesh", "tensile-structure", "cable-net", "enlargement"]
        .map(|name| format!("{name}-poll"));
    let reading = ["pattern", "schedule"].map(str::to_owned);
    let solving = solving.map(str::to_owned).into_iter();
    let expected: Vec<String> = solving.chain(starting).chain(polling).chain(reading).collect();
    assert_eq!(names, expected);
    assert_eq!(app.get("/hops/nothing").await.status(), StatusCode::NOT_FOUND);
    // `solve` is not a component, so it has no description.
    assert_eq!(app.get("/hops/solve").await.status(), StatusCode::METHOD_NOT_ALLOWED);
}

/// Every input of this kind sets a field of its request, so `src/hops` needs no code for the kind.
#[tokio::test]
async fn a_kind_that_only_the_table_names_has_a_component() {
    let app = TestApp::start().await;
    let film = app.solve(MINIMAL, &small_film(0.3)).await;
    let id = film["id"].as_str().unwrap();
    let answer = app.run("enlargement", &[text("Source", id), number("Factor", 3.0)]).await;
    let area = film["statistics"]["area"].as_f64().unwrap();
    assert_eq!(output(&answer, "Area"), [json!(9.0 * area)]);
    assert_eq!(output(&answer, "Triangles"), [film["statistics"]["triangles"].clone()]);
    let missing = app.hops("enlargement", &[text("Source", "01J00000000000000000000000")]).await;
    let lines = app.refused("enlargement", missing, 404).await;
    assert_eq!(lines, ["Source: is not the identifier of a job"]);
}

#[tokio::test]
async fn a_minimal_surface_is_the_one_of_the_service_and_keeps_its_boundary_at_survey_coordinates() {
    let app = TestApp::start().await;
    let values = [curves("Boundaries", &[square(0.5)]), number("Triangles", 200)];
    let answer = app.run("minimal-surface", &values).await;
    // The job warns that STL files are relative to an origin, which does not concern Grasshopper.
    assert_eq!(answer["warnings"], json!([]));
    let mesh = mesh(&answer);
    for point in &square(0.5)[..4] {
        assert!(mesh.vertices.contains(&DVec3::from_array(*point)), "{point:?}");
    }
    let body = json!({
        "boundaries": [&square(0.5)[..4]], "resolution": { "triangles": 200 },
        "objective": "minimal_area", "topology": "fixed",
    });
    let job = app.solve(MINIMAL, &body).await;
    assert_eq!(job["warnings"][0]["code"], "far_from_zero");
    assert_eq!(output(&answer, "Area")[0], job["statistics"]["area"]);
    assert!((area(&mesh) / job["statistics"]["area"].as_f64().unwrap() - 1.0).abs() < 1e-9);
    assert_eq!(mesh.faces.len() as u64, job["statistics"]["triangles"]);
    assert_eq!(output(&answer, "Converged"), [true]);
    let lines = output(&answer, "Statistics");
    let line = format!("triangles: {}", mesh.faces.len());
    assert!(lines.contains(&line.as_str().into()), "{lines:?}");
    let id = output(&answer, "Job")[0].as_str().unwrap().to_owned();
    assert_eq!(app.get_json(&format!("/v1/jobs/{id}")).await["status"], "succeeded");
}

#[tokio::test]
async fn messages_go_to_either_path_and_name_the_component_in_any_of_three_ways() {
    let app = TestApp::start().await;
    let values = [curves("Boundaries", &[square(0.4)]), number("Triangles", 100)];
    let address = format!("{}/hops/minimal-surface", app.url);
    let mut areas = Vec::new();
    // Beside an address that ends in a slash is the third path.
    for path in ["/solve", "/hops/solve", "/hops/minimal-surface/solve"] {
        let slash = format!("{address}/");
        let pointers = ["minimal-surface", "hops/minimal-surface", "/hops/minimal-surface", &address, &slash];
        for pointer in pointers {
            let response = app.post(path, &message(pointer, &values)).await;
            assert_eq!(response.status(), StatusCode::OK, "{path} {pointer}");
            areas.push(output(&response.json().await.unwrap(), "Area")[0].clone());
        }
    }
    areas.dedup();
    assert_eq!(areas.len(), 1);
    for path in ["/hops", "/hops/minimal-surface"] {
        assert_eq!(app.get_json(&format!("{path}/")).await, app.get_json(path).await);
    }
    assert_eq!(app.get("/hops/nothing/").await.status(), StatusCode::NOT_FOUND);
}

fn lines(answer: &Value) -> Vec<String> {
    output(answer, "Lines").iter().map(|line| line.as_str().unwrap().to_owned()).collect()
}

#[tokio::test]
async fn patterns_and_schedules_of_finished_jobs_come_as_lines() {
    let app = TestApp::start().await;
    let strip = app.solve("/v1/ruled-surfaces", &example("two-rails")).await;
    let id = strip["id"].as_str().unwrap();
    for (component, query) in [
        ("pattern", "format=svg"),
        ("pattern", "format=dxf&notches=100"),
        ("pattern", "profile=sheet-metal&thickness=0.01&radius=0.01&format=dxf"),
        ("schedule", "part=bends"),
    ] {
        let answer = app.run(component, &[text("Job", id), text("Query", query)]).await;
        let file = app.get(&format!("/v1/jobs/{id}/{component}?{query}")).await;
        assert_eq!(file.status(), StatusCode::OK, "{component} {query}");
        let file = file.text().await.unwrap();
        // Hops reads no escapes, so every quotation mark arrives as an apostrophe.
        let expected: Vec<String> = file.lines().map(|line| line.replace(['"', '\\'], "'")).collect();
        assert!(expected.len() > 2, "{file}");
        assert_eq!(lines(&answer), expected, "{component} {query}");
    }
    // Without a query, the default of the input counts.
    let svg = lines(&app.run("pattern", &[text("Job", id)]).await);
    assert!(svg.iter().any(|line| line.starts_with("<svg ")), "{svg:?}");
    let film = app.solve("/v1/minimal-surfaces", &small_film(0.3)).await;
    let film = film["id"].as_str().unwrap();
    let unknown = "0".repeat(26);
    for (component, id, query, status, expected) in [
        ("pattern", id, "profile=cut", 422, "Query: asks for a zip file"),
        ("pattern", id, "format=pdf", 422, "Query: asks for a pdf file"),
        ("pattern", id, "profile=paper", 400, "profile"),
        ("schedule", id, "part=walls", 400, "part"),
        ("pattern", film, "", 404, "pattern"),
        ("schedule", &unknown, "part=bends", 404, "no such job"),
    ] {
        let response = app.hops(component, &[text("Job", id), text("Query", query)]).await;
        let errors = app.refused(component, response, status).await;
        assert!(errors[0].contains(expected), "{component} {query}: {errors:?}");
    }
}

#[tokio::test]
async fn a_ruled_strip_has_a_flat_pattern_closed_or_not() {
    let app = TestApp::start().await;
    let rail = |y: f64, bend: f64| -> Vec<[f64; 3]> {
        (0..12).map(|k| f64::from(k) / 4.0).map(|x| [1e6 + x, y, bend * (x - 1.5).powi(2)]).collect()
    };
    let rails = [rail(0.0, 0.2), rail(1.0, -0.1), rail(2.0, 0.3)];
    let answer = app.run("ruled-strip", &[curves("Rails", &rails), text("Objective", "minimal_twist")]).await;
    let mesh = mesh(&answer);
    let outlines: Vec<_> = output(&answer, "Outlines").iter().map(polyline).collect();
    assert_eq!(outlines.len(), 2);
    // Unrolling keeps areas, and the outline is closed.
    let flat = |line: &Vec<DVec3>| line.windows(2).map(|pair| pair[0].cross(pair[1]).z).sum::<f64>().abs() / 2.0;
    assert!((outlines.iter().map(flat).sum::<f64>() / area(&mesh) - 1.0).abs() < 1e-9);
    assert!(outlines.iter().all(|line| line.first() == line.last() && line.iter().all(|point| point.z == 0.0)));
    let folds = output(&answer, "Folds");
    assert_eq!(folds.len(), output(&answer, "Fold Angles").len());
    assert_eq!(output(&answer, "Rulings").len(), folds.len() + 4);
    assert!(output(&answer, "Rulings").iter().map(polyline).all(|line| line.len() == 2 && line[0].x > 9e5));

    let ring = |z: f64, r: f64| -> Vec<[f64; 3]> {
        (0..=16)
            .map(|k| f64::from(k % 16) * std::f64::consts::TAU / 16.0)
            .map(|a| [r * a.cos(), r * a.sin(), z])
            .collect()
    };
    let values = [curves("Rails", &[ring(0.0, 1.0), ring(1.0, 0.8)]), number("Samples", 40)];
    let closed = app.run("ruled-strip", &values).await;
    assert_eq!((output(&closed, "Outlines").len(), output(&closed, "Rulings").len()), (1, 80));
    assert_eq!(output(&closed, "Folds").len(), 79);
}

#[tokio::test]
async fn a_uniform_mesh_fills_an_outline_with_holes_or_a_film() {
    let app = TestApp::start().await;
    let rectangle = |low: f64, high: f64, z: f64| -> Vec<[f64; 3]> {
        vec![[low, low, 0.0], [high, low, z], [high, high, 0.0], [low, high, z], [low, low, 0.0]]
    };
    let boundaries = [rectangle(0.0, 10.0, 0.0), rectangle(4.0, 6.0, 0.0)];
    let plane = app.run("uniform-mesh", &[curves("Boundaries", &boundaries), number("Edge Length", 1.0)]).await;
    assert!((output(&plane, "Area")[0].as_f64().unwrap() - 96.0).abs() < 1e-9);
    assert!((area(&mesh(&plane)) - 96.0).abs() < 1e-9);
    let members: Vec<_> = output(&plane, "Members").iter().map(polyline).collect();
    let lengths = output(&plane, "Member Lengths");
    assert_eq!(members.len(), lengths.len());
    for (member, length) in members.iter().zip(&lengths) {
        assert!((member[0].distance(member[1]) - length.as_f64().unwrap()).abs() < 1e-9);
    }
    assert!(output(&plane, "Equal Edges")[0].as_u64() > Some(50));

    let values = [
        curves("Boundaries", &[rectangle(0.0, 10.0, 3.0)]),
        number("Edge Length", 1.5),
        input("Film", &[("System.Boolean", "true".into())]),
    ];
    let film = app.run("uniform-mesh", &values).await;
    assert!(mesh(&film).vertices.iter().any(|vertex| vertex.z > 1.0 && vertex.z < 2.0));
}

#[tokio::test]
async fn a_sail_hangs_on_cables_between_its_anchors() {
    let app = TestApp::start().await;
    let sail = vec![[0.0, 0.0, 0.0], [10.0, 0.0, 4.0], [10.0, 10.0, 0.0], [0.0, 10.0, 4.0], [0.0, 0.0, 0.0]];
    // The last anchor lies inside an edge and becomes a point of the boundary.
    let anchors = [sail[0], sail[1], sail[2], sail[3], [5.0, 0.0, 2.0]];
    let values = [
        curves("Boundaries", std::slice::from_ref(&sail)),
        points("Anchors", &anchors),
        number("Cable Value", 12.0),
        number("Triangles", 300),
    ];
    let answer = app.run("tensile-structure", &values).await;
    let found = mesh(&answer);
    for anchor in anchors {
        assert!(found.vertices.contains(&DVec3::from_array(anchor)), "{anchor:?}");
    }
    let forces = output(&answer, "Cable Forces");
    assert_eq!(output(&answer, "Cables").len(), forces.len());
    assert!(forces.iter().all(|force| (force.as_f64().unwrap() - 12.0).abs() < 5e-3), "{forces:?}");
    assert_eq!(output(&answer, "Anchor Points").len(), 5);
    let total = output(&answer, "Anchor Forces").iter().fold(DVec3::ZERO, |total, force| {
        total + DVec3::new(force["X"].as_f64().unwrap(), force["Y"].as_f64().unwrap(), force["Z"].as_f64().unwrap())
    });
    assert!(total.length() < 1e-4, "{total}");

    // Cables of Options are added to those along the edges.
    let options = text("Options", r#"{"cables": [{"points": [[0, 0, 0], [-3, -3, -2]], "value": 5}]}"#);
    let more = app.run("tensile-structure", &[&values[..], &[options]].concat()).await;
    assert!(output(&more, "Cables").len() > output(&answer, "Cables").len());
    // An error in them is named by its place in Options.
    let options = text("Options", r#"{"cables": [{"points": [[0, 0, 0], [-3, -3, -2]], "value": -5}]}"#);
    let response = app.hops("tensile-structure", &[&values[..], &[options]].concat()).await;
    let errors = app.refused("tensile-structure", response, 422).await;
    assert!(errors[0].starts_with("Options /cables/0 /value: "), "{errors:?}");

    let dome = [curves("Boundaries", &[square(0.0)]), number("Pressure", 0.5), number("Triangles", 200)];
    let answer = app.run("pneumatic-film", &dome).await;
    assert!(mesh(&answer).vertices.iter().any(|vertex| vertex.z > 0.02));
    assert_eq!(output(&answer, "Pressure"), [0.5]);
}

#[tokio::test]
async fn a_cable_net_is_made_of_lines_that_share_points() {
    let app = TestApp::start().await;
    let middle = [0.2, 0.7, 3.0];
    // Two polylines cross in a vertex of both.
    let lines = [vec![[0.0, 0.0, 0.0], middle, [1.0, 1.0, 0.0]], vec![[1.0, 0.0, 1.0], middle, [0.0, 1.0, 1.0]]];
    let supports = [[0.0, 0.0, 0.0], [1.0, 1.0, 0.0], [1.0, 0.0, 1.0], [0.0, 1.0, 1.0]];
    let net = |supports: &[[f64; 3]]| {
        vec![
            curves("Cables", &lines),
            points("Supports", supports),
            number("Cable Value", 1.0),
            text("Cable Mode", "force_density"),
        ]
    };
    let answer = app.run("cable-net", &net(&supports)).await;
    let cables: Vec<_> = output(&answer, "Cables").iter().map(polyline).collect();
    assert_eq!(cables.len(), 4);
    assert!(cables.iter().all(|line| line.iter().any(|end| end.distance(DVec3::splat(0.5)) < 1e-12)), "{cables:?}");
    assert!(output(&answer, "Cable Forces").iter().all(|f| (f.as_f64().unwrap() - 0.75f64.sqrt()).abs() < 1e-12));
    assert_eq!(output(&answer, "Anchor Points").len(), 4);
    assert_eq!(output(&answer, "Converged"), [true]);
    let heavier = app.run("cable-net", &[net(&supports), vec![number("Load", 1.0)]].concat()).await;
    let low = output(&heavier, "Cables").iter().flat_map(polyline).map(|end| end.z).fold(1.0, f64::min);
    assert!(low.abs() < 1e-12 && output(&heavier, "Cables") != output(&answer, "Cables"), "{low}");
    // A support must be a point of the cables, and every vertex must be held.
    let response = app.hops("cable-net", &net(&[[9.0, 9.0, 9.0]])).await;
    let errors = app.refused("cable-net", response, 422).await;
    assert!(errors[0].starts_with("Supports[0]: is no point of the cables"), "{errors:?}");
    let response = app.hops("cable-net", &net(&supports[..1])).await;
    assert!(app.refused("cable-net", response, 422).await[0].starts_with("Cables"), "moves freely");
}

#[tokio::test]
async fn a_film_takes_its_topology_and_boundary_from_a_mesh() {
    let app = TestApp::start().await;
    // A tube of quadrilaterals between two squares. Every face has its own vertices, as meshes of Rhino often have.
    let corner = |k: usize, z: f64| {
        let (x, y) = [(1.0, 1.0), (-1.0, 1.0), (-1.0, -1.0), (1.0, -1.0)][k % 4];
        DVec3::new(x, y, z)
    };
    let mut vertices = Vec::new();
    let mut triangles = Vec::new();
    for k in 0..4 {
        for (low, high) in [(0.0, 0.3), (0.3, 0.6)] {
            let first = vertices.len() as u32;
            vertices.extend([corner(k, low), corner(k + 1, low), corner(k + 1, high), corner(k, high)]);
            triangles.extend([[first, first + 1, first + 2], [first, first + 2, first + 3]]);
        }
    }
    let tube = input("Mesh", &[("Rhino.Geometry.Mesh", envelope::to_json(&write::mesh(&vertices, &triangles)))]);
    let answer = app.run("film-from-mesh", &[tube]).await;
    let film = mesh(&answer);
    assert!(output(&answer, "Statistics").contains(&"boundary_loops: 2".into()));
    assert!((0..4).all(|k| film.vertices.contains(&corner(k, 0.0)) && film.vertices.contains(&corner(k, 0.6))));
    // A tetrahedron has no boundary.
    let closed =
        write::mesh(&[DVec3::ZERO, DVec3::X, DVec3::Y, DVec3::Z], &[[0, 2, 1], [0, 1, 3], [1, 2, 3], [2, 0, 3]]);
    let response = app.hops("film-from-mesh", &[input("Mesh", &[("", envelope::to_json(&closed))])]).await;
    let errors = app.refused("film-from-mesh", response, 422).await;
    assert_eq!(errors, ["Mesh: has no naked edges, and a film needs a boundary"]);
}

#[tokio::test]
async fn errors_name_the_input_and_every_output_is_there() {
    let app = TestApp::start().await;
    let good = curves("Boundaries", &[square(0.5)]);
    let mut open = square(0.5);
    open.pop();
    let mut infinite = square(0.5);
    infinite[1] = [f64::NAN; 3];
    let mesh = write::mesh(&[DVec3::ZERO, DVec3::X, DVec3::Y], &[[0, 1, 2]]);
    for (values, status, said) in [
        (vec![curves("Boundaries", &[square(0.5), open])], 422, "Boundaries[1]: must be closed, and its ends are 1"),
        (vec![curves("Boundaries", &[infinite])], 422, "Boundaries[0]: has a coordinate that is not a finite number"),
        (
            vec![input("Boundaries", &[("", envelope::to_json(&mesh))])],
            422,
            "Boundaries[0]: is a mesh, and must be a curve",
        ),
        (vec![input("Boundaries", &[("", "1".into())])], 422, "Boundaries[0]: is not an openNURBS object"),
        (vec![input("Boundaries", &[("", "null".into())])], 422, "Boundaries[0]: is null, so something upstream"),
        (
            vec![json!({ "ParamName": "Boundaries", "InnerTree": { "{0}": [null, { "data": null }] } })],
            422,
            "Boundaries[1]: is null, so something upstream",
        ),
        (
            vec![good.clone(), text("Options", r#"{"seed": 1}"#)],
            422,
            "Options /seed: has no effect in this request: it ",
        ),
        (vec![input("Boundaries", &[])], 422, "Boundaries: needs at least 1 values, and has 0"),
        (vec![good.clone(), number("Triangles", -5)], 422, "Triangles: "),
        (vec![good.clone(), number("Triangles", 1_000_000_000)], 413, "Triangles: is more than is allowed"),
        (vec![good.clone(), number("Triangles", 2.5)], 422, "Triangles: must be a whole number"),
        (vec![good.clone(), number("Edge Length", "NaN")], 422, "Edge Length: must be a finite number"),
        (vec![good.clone(), number("Edge Length", -1)], 422, "Edge Length: "),
        (vec![good.clone(), number("Tolerance", -1)], 422, "Tolerance: must be 0 or more"),
        (vec![good.clone(), text("Topology", "knotted")], 422, "Topology: "),
        (vec![good.clone(), text("Options", "[]")], 422, "Options: must be a JSON object"),
        (vec![good.clone(), text("Options", r#"{"sovler": 1}"#)], 422, "Options /sovler: "),
        (vec![good.clone(), text("Options", r#"{"constraints": {"points": [[1]]}}"#)], 422, "Options /constraints "),
        (vec![curves("Boundaries", &[vec![[0.0; 3], [1.0, 0.0, 0.0], [0.0; 3]]])], 422, "Boundaries[0]"),
    ] {
        let response = app.hops("minimal-surface", &values).await;
        let errors = app.refused("minimal-surface", response, status).await;
        assert!(errors.iter().any(|error| error.starts_with(said)), "{said}\n{errors:?}");
    }
    // The default of Topology would be refused with this objective, so that it is left out.
    app.run("minimal-surface", &[good.clone(), text("Objective", "minimal_dirichlet_energy")]).await;
    // The second curve is a hole of the first. It crosses itself like a bow tie.
    let outline = vec![[0.0; 3], [9.0, 0.0, 0.0], [9.0, 9.0, 0.0], [0.0, 9.0, 0.0], [0.0; 3]];
    let bow = vec![[2.0, 2.0, 0.0], [4.0, 4.0, 0.0], [4.0, 2.0, 0.0], [2.0, 4.5, 0.0], [2.0, 2.0, 0.0]];
    let values = [curves("Boundaries", &[outline, bow]), number("Edge Length", 1)];
    let errors = app.refused("uniform-mesh", app.hops("uniform-mesh", &values).await, 422).await;
    assert!(!errors.is_empty() && errors.iter().all(|error| error.starts_with("Boundaries[1]")), "{errors:?}");
    // Neither of the two anchors is on a boundary.
    let values = [good, points("Anchors", &[[1e6, 2e6, 9.0], [0.0; 3]]), number("Cable Value", 1)];
    let errors = app.refused("tensile-structure", app.hops("tensile-structure", &values).await, 422).await;
    assert!(errors[0].starts_with("Anchors[0]: is ") && errors[1].starts_with("Anchors[1]: is "), "{errors:?}");
}

/// Returns the unit of length of a component's job, which its glTF file names.
async fn units(app: &TestApp, answer: &Value) -> String {
    let id = output(answer, "Job")[0].as_str().unwrap().to_owned();
    let mesh = app.get_json(&format!("/v1/jobs/{id}/mesh?format=gltf")).await;
    mesh["asset"]["extras"]["unit"].as_str().unwrap().to_owned()
}

#[tokio::test]
async fn a_job_has_the_unit_of_the_document_unless_options_name_one() {
    let app = TestApp::start().await;
    let film = [curves("Boundaries", &[square(0.5)]), number("Triangles", 50)];
    let corners = &square(0.5)[..4];
    let sail = [film.to_vec(), vec![points("Anchors", corners), number("Cable Value", 12.0)]].concat();
    let rails = [curves("Rails", &[square(0.0)[..2].to_vec(), square(0.0)[2..4].to_vec()])];
    let run = async |pointer: &str, values: &[Value], unit: Value| {
        let mut message = message(pointer, values);
        match unit {
            Value::Null => drop(message.as_object_mut().unwrap().remove("modelunits")),
            unit => message["modelunits"] = unit,
        }
        app.post("/hops/solve", &message).await
    };
    for (name, unit) in [
        (json!("Millimeters"), "mm"),
        (json!("Centimeters"), "cm"),
        (json!("Meters"), "m"),
        (json!("Inches"), "in"),
        (json!("Feet"), "ft"),
        (json!("None"), "m"),
        (json!(""), "m"),
        (Value::Null, "m"),
    ] {
        for (component, values) in
            [("minimal-surface", &film[..]), ("tensile-structure", &sail[..]), ("ruled-strip", &rails[..])]
        {
            let response = run(component, values, name.clone()).await;
            assert_eq!(response.status(), StatusCode::OK, "{component} {name}");
            assert_eq!(units(&app, &response.json().await.unwrap()).await, unit, "{component} {name}");
        }
    }
    // Units in Options replace the document's unit. If Options name only the unit of forces, the document's unit of
    // length stays.
    for (component, values, options, unit) in [
        ("minimal-surface", &film[..], r#"{"units": "ft"}"#, "ft"),
        ("tensile-structure", &sail[..], r#"{"units": {"length": "in", "force": "lbf"}}"#, "in"),
        ("tensile-structure", &sail[..], r#"{"units": {"force": "N"}}"#, "mm"),
    ] {
        let values = [values, &[text("Options", options)]].concat();
        let response = run(component, &values, json!("Millimeters")).await;
        assert_eq!(units(&app, &response.json().await.unwrap()).await, unit, "{options}");
    }
    let miles = run("minimal-surface", &film, json!("Miles")).await;
    let errors = app.refused("minimal-surface", miles, 422).await;
    assert!(errors[0].starts_with("the document's unit is Miles, and must be Millimeters"), "{errors:?}");
    let named = [&film[..], &[text("Options", r#"{"units": "m"}"#)]].concat();
    let response = run("minimal-surface", &named, json!("Miles")).await;
    assert_eq!(units(&app, &response.json().await.unwrap()).await, "m");
}

/// Sends the pairs of the geometry's own test through Hops. The second rail must be reversed exactly if it runs against
/// the first.
#[tokio::test]
async fn rails_are_aligned_as_a_person_sees_them() {
    let app = TestApp::start().await;
    for (rails, runs_against, closed) in some_pairs() {
        // A closed curve repeats its first point.
        let repeat = |rail: &Vec<[f64; 3]>| rail.iter().chain(closed.then_some(&rail[0])).copied().collect();
        let rails: Vec<Vec<[f64; 3]>> = rails.iter().map(repeat).collect();
        let answer = app.run("ruled-strip", &[curves("Rails", &rails)]).await;
        let line = format!("reversed: false, {runs_against}");
        let lines = output(&answer, "Statistics");
        assert!(lines.contains(&line.as_str().into()), "{line} {lines:?} {rails:?}");
    }
}

/// Hops asks for the description again if the status is 500 and the first error is `Bad inputs`.
#[tokio::test]
async fn inputs_of_another_version_of_a_component_are_bad_inputs() {
    let app = TestApp::start().await;
    let good = curves("Boundaries", &[square(0.5)]);
    for (values, said) in [
        (vec![good, number("Density", 1)], "Density is not an input of this component"),
        (vec![], "Boundaries: is required"),
    ] {
        let response = app.hops("minimal-surface", &values).await;
        assert_eq!(response.status(), StatusCode::INTERNAL_SERVER_ERROR);
        assert_eq!(errors(&response.json().await.unwrap()), ["Bad inputs", said]);
    }
}

#[tokio::test]
async fn answers_to_other_messages_have_the_form_of_hops_too() {
    let app = TestApp::start().await;
    for (path, body, status) in [
        ("/solve", "{".to_owned(), 400),
        ("/solve", "[1]".to_owned(), 400),
        ("/hops/solve", "{}".to_owned(), 404),
        ("/solve", message("/hops/nothing", &[]).to_string(), 404),
    ] {
        let request = app.request(Method::POST, path).header("content-type", "application/json; charset=utf-8");
        let response = request.body(body).send().await.unwrap();
        assert_eq!(response.status().as_u16(), status);
        assert_eq!(response.headers()["content-type"], "application/json");
        let answer: Value = response.json().await.unwrap();
        assert_eq!((&answer["values"], &answer["warnings"]), (&json!([]), &json!([])));
        assert_eq!(errors(&answer).len(), 1, "{answer}");
    }
}

#[tokio::test]
async fn a_misspelt_component_is_told_the_right_one() {
    let app = TestApp::start().await;
    for (name, expected) in [
        ("minimal-surfaces", "no such component; did you mean minimal-surface? GET /hops lists all"),
        ("Minimal_Surface", "no such component; did you mean minimal-surface? GET /hops lists all"),
        ("cabel-net-pol", "no such component; did you mean cable-net-poll? GET /hops lists all"),
        ("sphere", "no such component; GET /hops lists all"),
    ] {
        let response = app.post("/hops/solve", &message(name, &[])).await;
        assert_eq!(errors(&response.json().await.unwrap()), [expected]);
        let described: Value = app.get(&format!("/hops/{name}")).await.json().await.unwrap();
        assert_eq!(described["detail"], expected);
    }
}

#[tokio::test]
async fn a_long_job_is_started_and_polled() {
    let app = TestApp::start().await;
    app.hold.at("first_progress");
    let values = [curves("Boundaries", &[square(0.5)]), number("Triangles", 100)];
    let started = app.run("minimal-surface-start", &values).await;
    let id = output(&started, "Job")[0].as_str().unwrap().to_owned();
    let poll = [text("Job", &id)];
    let running = app.hops("minimal-surface-poll", &poll).await;
    assert_eq!(running.status(), StatusCode::ACCEPTED);
    let running: Value = running.json().await.unwrap();
    app.has_every_output("minimal-surface-poll", &running).await;
    assert!(["queued", "running"].contains(&output(&running, "Status")[0].as_str().unwrap()));
    assert!(output(&running, "Mesh").is_empty() && output(&running, "Progress")[0].as_f64() < Some(1.0));
    assert_eq!(app.post(&format!("/v1/jobs/{id}/cancel"), &json!({})).await.status(), StatusCode::OK);
    let errors = app.refused("minimal-surface-poll", app.hops("minimal-surface-poll", &poll).await, 409).await;
    assert!(errors[0].contains("cancelled"), "{errors:?}");

    app.hold.release("first_progress");
    let job = app.solve(MINIMAL, &small_film(0.25)).await;
    let poll = [text("Job", job["id"].as_str().unwrap()), number("Refresh", 3)];
    let done = app.run("minimal-surface-poll", &poll).await;
    assert_eq!((output(&done, "Status"), output(&done, "Progress")), (vec!["succeeded".into()], vec![1.0.into()]));
    assert_eq!(mesh(&done).faces.len() as u64, job["statistics"]["triangles"]);
    let errors = app.refused("ruled-strip-poll", app.hops("ruled-strip-poll", &poll).await, 422).await;
    assert_eq!(errors, ["Job: is of another kind; use the component /hops/minimal-surface-poll"]);
    let unknown = app.hops("minimal-surface-poll", &[text("Job", "01ARZ3NDEKTSV4RRFFQ69G5FAV")]).await;
    assert_eq!(app.refused("minimal-surface-poll", unknown, 404).await.len(), 1);
}

/// Returns the status of the newest job.
async fn newest(app: &TestApp) -> String {
    app.get_json("/v1/jobs?limit=1").await["jobs"][0]["status"].as_str().unwrap_or_default().to_owned()
}

#[tokio::test]
async fn a_job_that_takes_too_long_or_is_abandoned_is_cancelled() {
    let app = TestApp::start_with(&[("PLATEAU_HTTP__HOPS_WAIT_S", "1")]).await;
    app.hold.at("claimed");
    let values = |height: f64| [curves("Boundaries", &[square(height)]), number("Triangles", 100)];
    let errors = app.refused("minimal-surface", app.hops("minimal-surface", &values(0.5)).await, 503).await;
    assert!(errors[0].contains("/hops/minimal-surface-start"), "{errors:?}");
    wait_for_cancel(&app).await;

    let patient = TestApp::start().await;
    patient.hold.at("claimed");
    let message = message("minimal-surface", &values(0.6));
    tokio::select! {
        answer = patient.request(Method::POST, "/solve").json(&message).send() => panic!("a held job: {answer:?}"),
        () = patient.submitted(1) => {}
    }
    wait_for_cancel(&patient).await;
}

async fn wait_for_cancel(app: &TestApp) {
    until("the job is cancelled", async || newest(app).await == "cancelled").await;
}

#[tokio::test]
async fn a_job_without_a_result_says_why() {
    let app = TestApp::start().await;
    // A cable with less force than the film's pull has no equilibrium.
    let sail = vec![[0.0, 0.0, 0.0], [10.0, 0.0, 4.0], [10.0, 10.0, 0.0], [0.0, 10.0, 4.0], [0.0, 0.0, 0.0]];
    let values = [
        curves("Boundaries", std::slice::from_ref(&sail)),
        points("Anchors", &sail[..4]),
        number("Cable Value", 0.1),
        number("Triangles", 100),
    ];
    let errors = app.refused("tensile-structure", app.hops("tensile-structure", &values).await, 422).await;
    assert!(!errors[0].is_empty() && !errors[0].starts_with(':'), "{errors:?}");
}

#[tokio::test]
async fn keys_come_in_the_header_of_hops_and_descriptions_need_none() {
    let secrets = tempfile::tempdir().unwrap();
    let (key, line) = new_key("studio").await;
    let file = secrets.path().join("keys");
    std::fs::write(&file, format!("{line}\n")).unwrap();
    let app = TestApp::start_with(&[("PLATEAU_AUTH__KEYS_FILE", file.to_str().unwrap())]).await;
    assert_eq!(app.get("/hops/minimal-surface").await.status(), StatusCode::OK);
    assert_eq!(app.get("/hops").await.status(), StatusCode::OK);
    let body = message("minimal-surface", &[curves("Boundaries", &[square(0.5)]), number("Triangles", 100)]);
    for path in ["/solve", "/hops/solve", "/hops/minimal-surface/solve"] {
        let refused = app.post(path, &body).await;
        assert_eq!(refused.status(), StatusCode::UNAUTHORIZED);
        assert_eq!(refused.headers()["www-authenticate"], "Bearer");
        let answer: Value = refused.json().await.unwrap();
        let expected = "Enter a key in Grasshopper under File > Preferences > Solver as the API key of Hops";
        assert!(errors(&answer)[0].contains(expected), "{answer}");
        let send =
            |name: &'static str, value: String| app.request(Method::POST, path).header(name, value).json(&body).send();
        let wrong = send("RhinoComputeKey", "wrong".into()).await.unwrap();
        assert_eq!(wrong.status(), StatusCode::UNAUTHORIZED);
        assert!(errors(&wrong.json().await.unwrap())[0].contains(expected));
        assert_eq!(send("RhinoComputeKey", key.clone()).await.unwrap().status(), StatusCode::OK);
        assert_eq!(send("authorization", format!("Bearer {key}")).await.unwrap().status(), StatusCode::OK);
    }
    let other = app.request(Method::GET, "/v1/jobs").header("RhinoComputeKey", &key).send().await.unwrap();
    assert_eq!(other.status(), StatusCode::UNAUTHORIZED);
    let own = app.request(Method::GET, "/v1/jobs").bearer_auth(&key).send().await.unwrap();
    assert!(!own.json::<Value>().await.unwrap()["jobs"].as_array().unwrap().is_empty());
}

#[tokio::test]
async fn hops_can_be_off_and_addresses_begin_with_the_base_path() {
    let off = TestApp::start_with(&[("PLATEAU_HTTP__HOPS", "false")]).await;
    assert_eq!(off.get("/hops").await.status(), StatusCode::NOT_FOUND);
    assert_eq!(off.get("/hops/minimal-surface").await.status(), StatusCode::NOT_FOUND);
    let answer: Value = off.post("/solve", &message("minimal-surface", &[])).await.json().await.unwrap();
    assert!(errors(&answer)[0].contains("http.hops"), "{answer}");
    let based = TestApp::start_with(&[("PLATEAU_HTTP__PUBLIC_BASE_PATH", "/form")]).await;
    assert_eq!(based.get_json("/form/hops/uniform-mesh").await["Uri"], "/form/hops/uniform-mesh");
    let body = message("uniform-mesh", &[curves("Boundaries", &[square(0.0)]), number("Edge Length", 0.3)]);
    assert_eq!(based.post("/form/hops/solve", &body).await.status(), StatusCode::OK);
}
