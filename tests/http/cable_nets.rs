//! Cable nets over HTTP: figures of published nets, statistics, files of every format, and errors.

use crate::app::{CABLE_NETS, TestApp, example, pointers, problem};
use reqwest::Method;
use serde_json::{Value, json};

fn number(value: &Value) -> f64 {
    value.as_f64().unwrap_or_else(|| panic!("{value} is no number"))
}

fn merged(mut body: Value, extra: &Value) -> Value {
    body.as_object_mut().unwrap().extend(extra.as_object().unwrap().clone());
    body
}

/// Returns the net of the test of compas_fd: four supports, two of them lifted by one, and a free vertex.
fn hypar(extra: Value) -> Value {
    let net = json!({
        "vertices": [[0, 0, 0], [1, 0, 1], [1, 1, 0], [0, 1, 1], [0.2, 0.7, 3]],
        "edges": [[0, 4], [1, 4], [2, 4], [3, 4]],
        "supports": [0, 1, 2, 3],
        "cables": [{ "force_density": 1 }],
    });
    merged(net, &extra)
}

#[tokio::test]
async fn a_hypar_of_equal_force_densities_passes_through_the_mean_of_its_supports() {
    let app = TestApp::start().await;
    let job = app.solve(CABLE_NETS, &hypar(json!({}))).await;
    let statistics = &job["statistics"];
    assert_eq!((&statistics["stop_reason"], &statistics["converged"]), (&json!("no_targets"), &json!(true)));
    let mesh = app.get_json(&format!("{}?format=json", job["links"]["mesh"].as_str().unwrap())).await;
    for coordinate in mesh["vertices"][4].as_array().unwrap() {
        assert!((number(coordinate) - 0.5).abs() < 1e-14, "{mesh}");
    }
    assert_eq!(mesh["triangles"], json!([]));
    // The reaction of each support is the force of its cable, the density times the length.
    for reaction in statistics["reactions"].as_array().unwrap() {
        let force: f64 = reaction["force"].as_array().unwrap().iter().map(|f| number(f).powi(2)).sum::<f64>().sqrt();
        assert!((force - 0.75f64.sqrt()).abs() < 1e-14, "{reaction}");
    }
    assert_eq!(job["warnings"], json!([]));
}

#[tokio::test]
async fn the_net_of_jax_fdm_reaches_its_forces_and_lengths() {
    let app = TestApp::start().await;
    let job = app.solve(CABLE_NETS, &example("cable-net-by-targets")).await;
    let statistics = &job["statistics"];
    assert_eq!((&statistics["objective"], &statistics["converged"]), (&json!("nearest_to_targets"), &json!(true)));
    assert_eq!(statistics["force_unit"], "kN");
    let [rim, inside] = [0, 1].map(|k| &statistics["cables"][k]);
    assert_eq!((&rim["name"], &rim["edges"]), (&json!("rim"), &json!(40)));
    assert_eq!((&inside["name"], &inside["edges"]), (&json!("inside"), &json!(180)));
    // jax_fdm reports forces of 19.998 to 20.002, lengths of 0.97 to 1.05 and a loss, the sum of the means of (F - 20)²
    // and of (L - 1)², of 0.000804. In this example a deviation of the forces counts 100 times as much, so its
    // objective value is an upper bound of the loss as jax_fdm defines it.
    assert!(number(&statistics["objective_value"]) < 0.000804, "{statistics}");
    assert!(number(&rim["force_min"]) >= 19.998 && number(&rim["force_max"]) <= 20.002, "{rim}");
    let lengths = &inside["edge_lengths"];
    assert!(number(&lengths["min"]) >= 0.964 && number(&lengths["max"]) <= 1.05, "{inside}");
    assert!(number(&inside["force_densities"]["min"]) >= 0.1, "{inside}");
    // The unstressed length of an edge is its length / (1 + force / EA), and all forces are nearly 20.
    let unstressed = number(&rim["unstressed_length"]);
    assert!((unstressed * (1.0 + 20.0 / 20_000.0) / number(&rim["length"]) - 1.0).abs() < 1e-6, "{rim}");
    assert!(inside["unstressed_length"].is_null());
    assert_eq!(statistics["reactions"].as_array().unwrap().len(), 4);
    assert!(number(&statistics["balance"]["imbalance"]) < 1e-6 && number(&statistics["residual"]) < 1e-6);
}

#[tokio::test]
async fn loads_and_reactions_sum_to_zero_and_loads_can_be_given_for_all_free_vertices() {
    let app = TestApp::start().await;
    let load = json!({ "loads": [{ "force": [0, 0, -2] }, { "vertices": [0, 4], "force": [0.5, 0, 0] }] });
    let job = app.solve(CABLE_NETS, &hypar(load)).await;
    let balance = &job["statistics"]["balance"];
    assert_eq!(balance["loads"], json!([1.0, 0.0, -2.0]));
    for axis in 0..3 {
        let sum = number(&balance["loads"][axis]) + number(&balance["reactions"][axis]);
        assert!(sum.abs() < 1e-12, "{balance}");
    }
    assert!(number(&balance["imbalance"]) < 1e-12);
}

#[tokio::test]
async fn a_net_is_lines_with_forces_in_every_format_that_has_lines() {
    let app = TestApp::start().await;
    let job = app.solve(CABLE_NETS, &hypar(json!({ "units": { "length": "mm", "force": "N" } }))).await;
    let mesh = job["links"]["mesh"].as_str().unwrap();
    let document = app.get_json(&format!("{mesh}?format=gltf")).await;
    let primitive = |name: &str| {
        let meshes = document["meshes"].as_array().unwrap();
        meshes.iter().find(|mesh| mesh["name"] == name).unwrap_or_else(|| panic!("{name}"))["primitives"][0].clone()
    };
    let count = |accessor: &Value| document["accessors"][accessor.as_u64().unwrap() as usize]["count"].clone();
    // The mode is POINTS (0) for the vertices, and LINES (1) for the other primitives.
    for (name, mode, ends) in [("vertices", 0, 5), ("cables 0", 1, 8), ("reactions", 1, 8)] {
        let primitive = primitive(name);
        assert_eq!((&primitive["mode"], count(&primitive["attributes"]["POSITION"])), (&json!(mode), json!(ends)));
        if mode == 1 {
            assert_eq!(count(&primitive["attributes"]["_FORCE"]), json!(ends), "{name}");
        }
    }
    assert!(document["meshes"].as_array().unwrap().iter().all(|mesh| mesh["name"] != "surface"));
    let node = document["nodes"].as_array().unwrap().iter().find(|node| node["name"] == "cables 0").unwrap();
    assert_eq!(node["extras"]["_FORCE"]["unit"], "N");
    let text = async |query: &str| app.get(&format!("{mesh}?{query}")).await.text().await.unwrap();
    let obj = text("format=obj").await;
    assert!(!obj.contains("o surface") && obj.contains("o cables 0\nl 1 5\nl 2 5\n"), "{obj}");
    let ply = text("format=ply&encoding=ascii").await;
    let header = "element face 0\nproperty list uchar uint vertex_indices\nelement edge 4\nproperty int vertex1\n\
                  property int vertex2\nproperty double force\nend_header\n";
    assert!(ply.contains(header), "{ply}");
    let last: Vec<f64> = ply.lines().last().unwrap().split(' ').map(|word| word.parse().unwrap()).collect();
    assert_eq!(last[..2], [3.0, 4.0]);
    assert!((last[2] - 0.75f64.sqrt()).abs() < 1e-14, "{ply}");
    let binary = app.get(&format!("{mesh}?format=ply")).await.bytes().await.unwrap();
    let end = binary.windows(11).position(|window| window == b"end_header\n").unwrap() + 11;
    assert_eq!(binary.len() - end, 5 * 24 + 4 * 16);
    let json = app.get_json(&format!("{mesh}?format=json")).await;
    assert_eq!(json["lines"][0]["paths"], json!([[0, 4], [1, 4], [2, 4], [3, 4]]));
    assert_eq!(json["lines"][0]["values"]["unit"], "N");
    assert_eq!(json["input_vertices"], json!([[0, 1, 2, 3, 4]]));
    let refused = problem(app.get(&format!("{mesh}?format=stl")).await, 422).await;
    assert!(refused["detail"].as_str().unwrap().contains("only lines"), "{refused}");
}

#[tokio::test]
async fn each_wrong_value_gets_an_error_with_its_pointer() {
    let app = TestApp::start().await;
    let cable = |extra: Value| hypar(json!({ "cables": [extra] }));
    let chain = |extra: Value| {
        let net = json!({
            "vertices": [[0, 0, 0], [1, 0, 0], [2, 0, 0], [3, 0, 0]], "edges": [[0, 1], [1, 2], [2, 3]],
            "supports": [0, 3], "cables": [{ "force": 1 }],
        });
        merged(net, &extra)
    };
    let cases = [
        (json!({}), vec!["/vertices", "/edges", "/supports"]),
        (hypar(json!({ "units": "kN" })), vec!["/units"]),
        (hypar(json!({ "units": { "length": "kN" } })), vec!["/units/length"]),
        (hypar(json!({ "units": { "force": "m" } })), vec!["/units/force"]),
        (hypar(json!({ "cables": [] })), vec!["/cables"]),
        (hypar(json!({ "cables": [{ "name": "a" }] })), vec!["/cables"]),
        (cable(json!({ "force": 0 })), vec!["/cables/0/force"]),
        (cable(json!({ "length": 0 })), vec!["/cables/0/length"]),
        (cable(json!({ "force_density": 1, "force": 1 })), vec!["/cables/0/force_density"]),
        (cable(json!({ "force": 1, "edges": [0, 4] })), vec!["/cables/0/edges/1"]),
        (cable(json!({ "force": 1, "edges": [0, 1, 0] })), vec!["/cables/0/edges/2"]),
        (hypar(json!({ "cables": [{ "force": 1 }, { "length": 1 }] })), vec!["/cables/1"]),
        (
            hypar(json!({ "cables": [{ "force": 1, "edges": [2] }, { "length": 1, "edges": [2] }] })),
            vec!["/cables/1/edges/0"],
        ),
        (cable(json!({ "name": "other", "force": 1 })), vec!["/cables/0/name"]),
        // Unknown vertices.
        (hypar(json!({ "supports": [0, 1, 2, 5] })), vec!["/supports/3"]),
        (hypar(json!({ "supports": [0, 1, 2, 0] })), vec!["/supports/3"]),
        (hypar(json!({ "edges": [[0, 4], [1, 4], [2, 4], [3, 5]] })), vec!["/edges/3/1"]),
        (hypar(json!({ "loads": [{ "vertices": [4, 5], "force": [0, 0, 1] }] })), vec!["/loads/0/vertices/1"]),
        (hypar(json!({ "loads": [{ "vertices": [4], "force": [0, 0] }] })), vec!["/loads/0/force"]),
        // Edges without length and repeated edges.
        (hypar(json!({ "edges": [[0, 4], [1, 4], [2, 4], [3, 3]] })), vec!["/edges/3"]),
        (hypar(json!({ "edges": [[0, 4], [1, 4], [2, 4], [3, 4], [4, 1]] })), vec!["/edges/4"]),
        (chain(json!({ "vertices": [[0, 0, 0], [1, 0, 0], [1, 0, 0], [3, 0, 0]] })), vec!["/edges/1"]),
        // A mechanism: vertices that no cables join to a support, and vertices that hang on a single cable.
        (chain(json!({ "edges": [[0, 3], [1, 2]], "cables": [{ "force": 1 }] })), vec!["/vertices/1", "/vertices/2"]),
        (chain(json!({ "supports": [0] })), vec!["/vertices/1", "/vertices/2", "/vertices/3"]),
        // An edge between two supports whose target length is not the distance of the supports.
        (chain(json!({ "supports": [0, 1, 3], "cables": [{ "length": 1.2 }] })), vec!["/cables/0/length"]),
        (chain(json!({ "supports": [0, 1, 3], "cables": [{ "length": 0.7 }] })), vec!["/cables/0/length"]),
        (hypar(json!({ "weights": { "force": -1 } })), vec!["/weights/force"]),
        (hypar(json!({ "least_force_density": -1 })), vec!["/least_force_density"]),
        (hypar(json!({ "tolerance": 2 })), vec!["/tolerance"]),
        (hypar(json!({ "vertices": [[0, 0, 0], [1, 0, 1], [1, 1, 0], [0, 1, 1], [0, 0, 1e60]] })), vec!["/vertices/4"]),
    ];
    for (body, expected) in cases {
        let refused = problem(app.post(CABLE_NETS, &body).await, 422).await;
        assert_eq!(pointers(&refused), expected, "{body}\n{refused:#}");
    }
    let slack = chain(json!({ "supports": [0, 1, 3], "cables": [{ "length": 1.2 }] }));
    let refused = problem(app.post(CABLE_NETS, &slack).await, 422).await;
    assert!(refused["errors"][0]["detail"].as_str().unwrap().contains("slack"), "{refused}");
}

#[tokio::test]
async fn limits_are_checked_before_the_work() {
    let limits = [("PLATEAU_LIMITS__POINTS", "4"), ("PLATEAU_LIMITS__ITERATIONS", "50")];
    let app = TestApp::start_with(&limits).await;
    let refused = problem(app.post(CABLE_NETS, &hypar(json!({}))).await, 413).await;
    assert_eq!(pointers(&refused), ["/vertices"]);
    let app = TestApp::start_with(&[("PLATEAU_LIMITS__TRIANGLES", "3"), ("PLATEAU_LIMITS__ITERATIONS", "50")]).await;
    let refused = problem(app.post(CABLE_NETS, &hypar(json!({}))).await, 413).await;
    assert_eq!(pointers(&refused), ["/edges"]);
    let app = TestApp::start_with(&[("PLATEAU_LIMITS__ITERATIONS", "50")]).await;
    let refused = problem(app.post(CABLE_NETS, &hypar(json!({ "max_iterations": 51 }))).await, 413).await;
    assert_eq!(pointers(&refused), ["/max_iterations"]);
}

/// Returns a net whose targets leave an edge slack. Two edges with target force 1 and target length 1 pull the free
/// vertex to the middle between their supports, where the third edge has no force.
fn pulled(extra: Value) -> Value {
    let net = json!({
        "vertices": [[-1, 0, 0], [1, 0, 0], [0, 1, 0], [0, 0, 0.1]], "edges": [[0, 3], [1, 3], [2, 3]],
        "supports": [0, 1, 2],
        "cables": [{ "name": "straight", "edges": [0, 1], "force": 1, "length": 1 }, { "name": "loose", "edges": [2] }],
    });
    merged(net, &extra)
}

#[tokio::test]
async fn a_cable_that_the_targets_leave_slack_is_named() {
    let app = TestApp::start().await;
    let posted = app.post(CABLE_NETS, &pulled(json!({}))).await;
    let job = app.ended(posted.json().await.unwrap()).await;
    assert_eq!((&job["status"], &job["error"]["type"]), (&json!("failed"), &json!("/problems/slack-cable")), "{job:#}");
    assert_eq!(job["error"]["errors"], json!([{ "pointer": "/edges/2", "detail": "would be slack" }]));
    // With a least force density the cable stays in tension, and a warning says so.
    let job = app.solve(CABLE_NETS, &pulled(json!({ "least_force_density": 0.05 }))).await;
    assert_eq!(job["warnings"][0]["code"], "slack_cable", "{job:#}");
    assert_eq!(job["statistics"]["cables"][1]["slack_edges"], 1);
    assert!((number(&job["statistics"]["cables"][1]["force_densities"]["min"]) / 0.05 - 1.0).abs() < 1e-2);
}

#[tokio::test]
async fn a_net_that_collapses_fails_and_names_its_edges() {
    let app = TestApp::start().await;
    let ring = json!({
        "vertices": [[0, 0, 0], [1, 0, 0], [0, 1, 0]], "edges": [[0, 1], [1, 2], [2, 0]], "supports": [0],
        "cables": [{ "force_density": 1 }],
    });
    let posted = app.post(CABLE_NETS, &ring).await;
    let job = app.ended(posted.json().await.unwrap()).await;
    assert_eq!(
        (&job["status"], &job["error"]["type"]),
        (&json!("failed"), &json!("/problems/no-equilibrium")),
        "{job:#}"
    );
    assert_eq!(pointers(&job["error"]), ["/edges/0", "/edges/1", "/edges/2"]);
}

#[tokio::test]
async fn a_net_whose_iterations_are_used_up_is_in_equilibrium_and_says_so() {
    let app = TestApp::start().await;
    let request = merged(example("cable-net-by-targets"), &json!({ "max_iterations": 2 }));
    let job = app.solve(CABLE_NETS, &request).await;
    assert_eq!(job["statistics"]["stop_reason"], "max_iterations");
    assert_eq!(
        (&job["statistics"]["converged"], &job["warnings"][0]["code"]),
        (&json!(false), &json!("not_converged"))
    );
    assert!(number(&job["statistics"]["balance"]["imbalance"]) < 1e-9);
}

#[tokio::test]
async fn a_job_of_a_net_can_be_cancelled() {
    let app = TestApp::start().await;
    // A grid of 120 × 120 cells, which takes the solver many seconds.
    let (cells, mut vertices, mut edges) = (120, Vec::new(), Vec::new());
    for i in 0..=cells {
        for j in 0..=cells {
            let v = i * (cells + 1) + j;
            vertices.push(json!([i, j, (i * j) % 7]));
            if i < cells {
                edges.push(json!([v, v + cells + 1]));
            }
            if j < cells {
                edges.push(json!([v, v + 1]));
            }
        }
    }
    let last = cells * (cells + 1);
    let net = json!({
        "vertices": vertices, "edges": edges, "supports": [0, cells, last, last + cells],
        "cables": [{ "length": 1 }], "tolerance": 0,
    });
    let response = app.post(CABLE_NETS, &net).await;
    assert_eq!(response.status(), 202);
    let job: Value = response.json().await.unwrap();
    let cancel = job["links"]["cancel"].as_str().unwrap();
    let cancelled: Value = app.request(Method::POST, cancel).send().await.unwrap().json().await.unwrap();
    assert_eq!(cancelled["status"], "cancelled");
}

/// Returns a net of two cables with the target force `force`, which carry a load between two supports.
fn loaded(force: f64) -> Value {
    json!({
        "units": { "length": "m", "force": "kN" }, "vertices": [[-1, 0, 0], [1, 0, 0], [0, 0, -0.5]],
        "edges": [[0, 2], [1, 2]], "supports": [0, 1], "cables": [{ "name": "a", "force": force }],
        "loads": [{ "vertices": [2], "force": [0, 0, -3] }],
    })
}

#[tokio::test]
async fn targets_that_no_net_meets_fail_and_name_the_edges() {
    let app = TestApp::start().await;
    let posted = app.post(CABLE_NETS, &loaded(1.0)).await;
    let job = app.ended(posted.json().await.unwrap()).await;
    assert_eq!(
        (&job["status"], &job["error"]["type"]),
        (&json!("failed"), &json!("/problems/targets-not-reached")),
        "{job:#}"
    );
    assert_eq!(pointers(&job["error"]), ["/edges/0", "/edges/1"]);
    // 2 F cos = 3: a force above 1.5 bears the load.
    let job = app.solve(CABLE_NETS, &loaded(2.5)).await;
    assert!((number(&job["statistics"]["cables"][0]["force"]) - 2.5).abs() < 1e-6, "{job:#}");
}

#[tokio::test]
async fn a_missed_target_is_a_warning_that_names_the_edge() {
    let app = TestApp::start().await;
    let string = json!({
        "vertices": [[0, 0, 0], [1, 0, 0], [2, 0, 0]], "edges": [[0, 1], [1, 2]], "supports": [0, 2],
        "cables": [{ "edges": [0], "force": 1 }, { "edges": [1], "force": 5 }],
    });
    let job = app.solve(CABLE_NETS, &string).await;
    assert_eq!(job["warnings"][0]["code"], "targets_missed", "{job:#}");
    assert!(job["warnings"][0]["detail"].as_str().unwrap().ends_with(": /edges/1"), "{job:#}");
}

#[tokio::test]
async fn a_net_has_as_many_cables_as_edges() {
    let app = TestApp::start().await;
    // A string of 1,501 edges, each of which is a cable with its own target.
    let count = 1501;
    let vertices: Vec<Value> = (0..=count).map(|k| json!([k, 0, 0])).collect();
    let edges: Vec<Value> = (0..count).map(|k| json!([k, k + 1])).collect();
    let cables: Vec<Value> = (0..count).map(|k| json!({ "edges": [k], "force": 3, "length": 1 })).collect();
    let net = json!({ "vertices": vertices, "edges": edges, "supports": [0, count], "cables": cables });
    let job = app.solve(CABLE_NETS, &net).await;
    assert_eq!(job["statistics"]["cables"].as_array().unwrap().len(), count);
    assert!(number(&job["statistics"]["objective_value"]) < 1e-12, "{}", job["statistics"]["objective_value"]);
}

/// Returns a mast on its foot with three stays of force 2 and a load on its top.
fn stayed(mast: Value) -> Value {
    json!({
        "vertices": [[0, 0, 0], [0.2, 0.1, 3.5], [3, 0, 0], [-1.5, 2.598076211353316, 0],
            [-1.5, -2.598076211353316, 0]],
        "edges": [[0, 1], [2, 1], [3, 1], [4, 1]], "supports": [0, 2, 3, 4],
        "cables": [merged(json!({ "name": "mast", "edges": [0] }), &mast), { "name": "stays", "force": 2 }],
        "loads": [{ "vertices": [1], "force": [0, 0, -1.5] }], "tolerance": 1e-12,
    })
}

#[tokio::test]
async fn a_strut_has_a_negative_force() {
    let app = TestApp::start().await;
    // Upright and 4 high, the mast bears 3 × 2 × 4/5 of the stays and 1.5 of the load.
    for mast in [json!({ "strut": true, "length": 4 }), json!({ "force": -6.3, "length": 4, "axial_stiffness": 1000 })]
    {
        let job = app.solve(CABLE_NETS, &stayed(mast.clone())).await;
        let found = &job["statistics"]["cables"][0];
        assert!((number(&found["force"]) + 6.3).abs() < 1e-5, "{mast}: {found:#}");
        assert!((number(&found["length"]) - 4.0).abs() < 1e-5, "{mast}: {found:#}");
        if mast.get("force").is_some() {
            assert!((number(&found["unstressed_length"]) - 4.0 / (1.0 - 0.0063)).abs() < 1e-4, "{found:#}");
        }
    }
    let refused = problem(app.post(CABLE_NETS, &stayed(json!({ "strut": true, "force": 6.3 }))).await, 422).await;
    assert_eq!(pointers(&refused), ["/cables/0/force"]);
    let refused = problem(app.post(CABLE_NETS, &stayed(json!({ "force": 0 }))).await, 422).await;
    assert_eq!(pointers(&refused), ["/cables/0/force"]);
}
