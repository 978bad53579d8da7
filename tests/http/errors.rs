//! Every class of error, as a problem document that points to the wrong value.

use crate::app::{MINIMAL, RULED, TestApp, example, large_strip, pointers, problem, small_film};
use reqwest::{Method, StatusCode, header};
use serde_json::{Value, json};

async fn rejected(app: &TestApp, path: &str, body: &Value) -> Vec<String> {
    let response = app.post(path, body).await;
    let problem = problem(response, 422).await;
    pointers(&problem).iter().map(|&pointer| pointer.to_owned()).collect()
}

async fn raw(app: &TestApp, body: impl Into<reqwest::Body>) -> reqwest::Response {
    app.request(Method::POST, MINIMAL).header(header::CONTENT_TYPE, "application/json").body(body).send().await.unwrap()
}

#[tokio::test]
async fn malformed_json_and_repeated_keys_are_400() {
    let app = TestApp::start().await;
    problem(raw(&app, "{").await, 400).await;
    problem(raw(&app, r#"{"boundaries":[],"boundaries":[]}"#).await, 400).await;
    problem(raw(&app, "[".repeat(100_000)).await, 400).await;
    problem(raw(&app, vec![0xff, 0xfe]).await, 400).await;
    problem(raw(&app, "").await, 400).await;
}

#[tokio::test]
async fn the_error_for_a_number_beyond_f64_has_its_pointer() {
    let app = TestApp::start().await;
    let problem = problem(raw(&app, r#"{"boundaries":[[[0,0,0],[1,0,0],[0,1e999,0]]]}"#).await, 422).await;
    assert_eq!(pointers(&problem), ["/boundaries/0/2/1"]);
}

#[tokio::test]
async fn each_wrong_value_of_a_body_gets_an_error_with_its_pointer() {
    let app = TestApp::start().await;
    let square = json!([[0, 0, 0], [1, 0, 0], [1, 1, 0], [0, 1, 0]]);
    let cases = [
        (json!({}), vec!["/boundaries"]),
        (json!([]), vec![""]),
        (json!({ "boundaries": [] }), vec!["/boundaries"]),
        (
            json!({ "boundaries": [[[0, 0], [1, 0, "x"], [1, 1, 0], [1, 1, 0, 0]]] }),
            vec!["/boundaries/0/0", "/boundaries/0/1/2", "/boundaries/0/3"],
        ),
        (json!({ "boundaries": [square], "colour": 1 }), vec!["/colour"]),
        (json!({ "boundaries": [square], "units": "furlong" }), vec!["/units"]),
        (json!({ "boundaries": [square], "objective": "prettiest" }), vec!["/objective"]),
        (json!({ "boundaries": [square], "resolution": {} }), vec!["/resolution"]),
        (json!({ "boundaries": [square], "resolution": { "triangles": 100, "edge_length": 1 } }), vec!["/resolution"]),
        (json!({ "boundaries": [square], "resolution": { "triangles": 2.5 } }), vec!["/resolution/triangles"]),
        (json!({ "boundaries": [square], "resolution": { "edge_length": 0 } }), vec!["/resolution/edge_length"]),
        (json!({ "boundaries": [square], "max_iterations": 5_000_000_000u64 }), vec!["/max_iterations"]),
        (json!({ "boundaries": [square], "kind": "ruled_surface" }), vec!["/kind"]),
        (json!({ "boundaries": [[[0, 0, 0], [1, 1, 1], [0, 0, 0], [1, 1, 1]]] }), vec!["/boundaries/0"]),
        (json!({ "boundaries": null }), vec!["/boundaries"]),
    ];
    for (body, expected) in cases {
        assert_eq!(rejected(&app, MINIMAL, &body).await, expected, "{body}");
    }
    let line = json!([[0, 0, 0], [1, 0, 0]]);
    let cases = [
        (json!({ "directrices": [line] }), vec!["/directrices"]),
        (json!({ "directrices": [line, []] }), vec!["/directrices/1"]),
        (json!({ "directrices": [line, [[0, 1, 0], [1, null, 0]]] }), vec!["/directrices/1/1/1"]),
        (json!({ "directrices": [line, line], "closed": 1 }), vec!["/closed"]),
    ];
    for (body, expected) in cases {
        assert_eq!(rejected(&app, RULED, &body).await, expected, "{body}");
    }
}

#[tokio::test]
async fn an_error_says_what_was_expected() {
    let app = TestApp::start().await;
    let square = json!([[0, 0, 0], [1, 0, 0], [1, 1, 0], [0, 1, 0]]);
    for (body, pointer, text) in [
        (json!({ "boundaries": [square], "units": "MM" }), "/units", "must be one of mm, cm, m, in, ft"),
        (
            json!({ "boundaries": [[[0, 0], [1, 0, 0], [0, 1, 0]]] }),
            "/boundaries/0/0",
            "must have three coordinates [x, y, z]; in the plane, z is 0",
        ),
        (
            json!({ "boundaries": [[{ "x": 0, "y": 0, "z": 0 }, [1, 0, 0], [0, 1, 0]]] }),
            "/boundaries/0/0",
            "must be a point or vector [x, y, z], such as [0, 0, 1.5]",
        ),
        (json!({ "boundaries": square }), "/boundaries", "lacks a level of brackets"),
        (
            json!({ "boundaries": [square],
                "initial_mesh": { "vertices": ["x", [1, 0, 0], [0, 1, 0]], "triangles": [[0, 1, 2]] } }),
            "/initial_mesh/vertices/0",
            "must be a point or vector [x, y, z]",
        ),
        (
            json!({ "boundaries": [square], "processes": [{ "together": [7] }] }),
            "/processes/0/together/0",
            "must be one of laplacian_fairing, area_minimising, edge_swapping",
        ),
        (
            json!({ "boundaries": [square], "resolutoin": 5 }),
            "/resolutoin",
            "is not a member of this object; did you mean resolution?",
        ),
    ] {
        let refused = problem(app.post(MINIMAL, &body).await, 422).await;
        assert_eq!(pointers(&refused), [pointer]);
        assert!(refused["errors"][0]["detail"].as_str().unwrap().contains(text), "{refused}");
        assert!(refused["detail"].as_str().unwrap().contains(text), "{refused}");
    }
    let nan = problem(raw(&app, r#"{"boundaries":[[[0,0,0],[1,0,0],[0,NaN,0]]]}"#).await, 422).await;
    assert_eq!(pointers(&nan), ["/boundaries/0/2/1"]);
    for (body, text) in [(&b"\xef\xbb\xbf{}"[..], "BOM"), (b"\xff\xfe{\0", "UTF-16"), (b"\x1f\x8b\x08", "gzip")] {
        let refused = problem(raw(&app, body).await, 400).await;
        assert!(refused["detail"].as_str().unwrap().contains(text), "{refused}");
    }
    let put = app.request(Method::PUT, "/v1/jobs/x").send().await.unwrap();
    let mut allowed: Vec<&str> = put.headers()["allow"].to_str().unwrap().split(',').map(str::trim).collect();
    allowed.sort_unstable();
    assert_eq!(allowed, ["DELETE", "GET", "HEAD"]);
    assert_eq!(problem(put, 405).await["detail"], "the header Allow lists this path's methods");
    let missing = problem(app.get("/v1/minimal-surface").await, 404).await;
    assert_eq!(
        missing["detail"],
        "no resource at this path; did you mean /v1/minimal-surfaces? GET /docs lists those of the API"
    );
    let far = problem(app.get("/v2/nothing/of/the/kind").await, 404).await;
    assert_eq!(far["detail"], "no resource at this path; GET /docs lists those of the API");
}

#[tokio::test]
async fn of_very_many_wrong_points_the_first_are_listed_and_the_rest_is_mentioned() {
    let app = TestApp::start().await;
    let rail = |wrong: usize, count: usize| -> Vec<Value> {
        (0..count).map(|k| if k < wrong { json!([k, 0]) } else { json!([k, 0, 0]) }).collect()
    };
    for (wrong, omitted) in [(100_000, true), (33, true), (1, false)] {
        let body = json!({ "directrices": [rail(wrong, 100_000), [[0, 1, 0], [1, 1, 0]]] });
        let refused = problem(app.post(RULED, &body).await, 422).await;
        let listed = refused["errors"].as_array().unwrap().len();
        let said = refused["errors_omitted"] == true;
        assert!(said == omitted || listed == wrong, "{wrong}: {listed} errors, omitted: {said}");
    }
}

#[tokio::test]
async fn values_are_never_echoed_and_errors_stop_at_fifty() {
    let app = TestApp::start().await;
    let points: Vec<Value> = (0..500).map(|_| json!([0, 0, "secret-text"])).collect();
    let response = app.post(MINIMAL, &json!({ "boundaries": [points] })).await;
    let problem = problem(response, 422).await;
    assert_eq!((problem["errors"].as_array().unwrap().len(), &problem["errors_omitted"]), (50, &json!(true)));
    assert!(!problem.to_string().contains("secret-text"));
}

#[tokio::test]
async fn too_large_is_413_by_bytes_points_triangles_and_cells() {
    let app = TestApp::start_with(&[
        ("PLATEAU_LIMITS__BODY_BYTES", "20000"),
        ("PLATEAU_LIMITS__POINTS", "150"),
        ("PLATEAU_LIMITS__TRIANGLES", "5000"),
        ("PLATEAU_LIMITS__GRID_CELLS", "1000"),
    ])
    .await;
    problem(raw(&app, " ".repeat(20_001)).await, 413).await;
    // A body without a declared length is refused as soon as it exceeds the limit.
    let chunks = futures_util::stream::iter((0..30).map(|_| Ok::<_, std::io::Error>(" ".repeat(1000))));
    problem(raw(&app, reqwest::Body::wrap_stream(chunks)).await, 413).await;
    let response = app.post(MINIMAL, &example("helicoid")).await;
    assert_eq!(pointers(&problem(response, 413).await), ["/boundaries"]);
    let mut film = small_film(0.5);
    film["resolution"] = json!({ "triangles": 5001 });
    assert_eq!(pointers(&problem(app.post(MINIMAL, &film).await, 413).await), ["/resolution/triangles"]);
    film["resolution"] = json!({ "edge_length": 1e-6 });
    assert_eq!(pointers(&problem(app.post(MINIMAL, &film).await, 413).await), ["/resolution"]);
    assert_eq!(pointers(&problem(app.post(RULED, &large_strip(40)).await, 413).await), ["/directrices"]);
}

#[tokio::test]
async fn another_media_type_or_any_encoding_is_415() {
    let app = TestApp::start().await;
    let post = |name, value| app.request(Method::POST, MINIMAL).header(name, value).body("{}").send();
    problem(post("content-type", "text/plain").await.unwrap(), 415).await;
    problem(post("content-type", "application/json; charset=latin1").await.unwrap(), 415).await;
    problem(post("x-nothing", "1").await.unwrap(), 415).await;
    let encoded = app.request(Method::POST, MINIMAL).header("content-encoding", "gzip").json(&small_film(0.1)).send();
    problem(encoded.await.unwrap(), 415).await;
    let utf8 = app.request(Method::POST, MINIMAL).header("content-type", "application/json; charset=UTF-8");
    let accepted = utf8.body(small_film(0.2).to_string()).send().await.unwrap();
    assert_eq!(accepted.status(), StatusCode::ACCEPTED);
}

#[tokio::test]
async fn unknown_paths_and_jobs_are_404_and_wrong_methods_405() {
    let app = TestApp::start().await;
    for path in [
        "/v2/jobs",
        "/v1/jobs/01J00000000000000000000000",
        "/v1/jobs/x",
        "/v1/jobs/01J00000000000000000000000/mesh",
        "/v1/examples/x",
        "/docs/x",
        "/problems/x",
    ] {
        problem(app.get(path).await, 404).await;
    }
    problem(app.request(Method::DELETE, "/v1/jobs/01J00000000000000000000000").send().await.unwrap(), 404).await;
    problem(app.request(Method::POST, "/v1/jobs/01J00000000000000000000000/cancel").send().await.unwrap(), 404).await;
    for (method, path, allowed) in
        [(Method::PUT, "/v1/jobs", "GET"), (Method::GET, MINIMAL, "POST"), (Method::POST, "/health/live", "GET")]
    {
        let response = app.request(method, path).send().await.unwrap();
        let allow = response.headers().get(header::ALLOW).map(|value| value.to_str().unwrap().to_owned());
        assert!(allow.as_deref().is_some_and(|allow| allow.contains(allowed)), "{path}: {allow:?}");
        problem(response, 405).await;
    }
}

#[tokio::test]
async fn invalid_queries_and_headers_are_400_and_unavailable_media_types_406() {
    let app = TestApp::start().await;
    for query in
        ["status=odd", "kind=odd", "limit=0", "limit=201", "limit=x", "cursor=x", "colour=1", "limit=1&limit=2"]
    {
        problem(app.get(&format!("/v1/jobs?{query}")).await, 400).await;
    }
    let job = app.solve(MINIMAL, &small_film(0.3)).await;
    let mesh = job["links"]["mesh"].as_str().unwrap();
    problem(app.get(&format!("{mesh}?format=fbx")).await, 400).await;
    problem(app.request(Method::GET, mesh).header("accept", "text/html").send().await.unwrap(), 406).await;
    let keyed = app.request(Method::POST, MINIMAL).header("idempotency-key", "a b").json(&small_film(0.3));
    problem(keyed.send().await.unwrap(), 400).await;
}

#[tokio::test]
async fn geometry_without_a_surface_is_422_or_a_failed_job_with_a_pointer() {
    let app = TestApp::start().await;
    // If a default value is wrong, the pointer ends at the missing member.
    let mut defaulted = example("helicoid");
    defaulted["initial_mesh"] = json!("rings");
    defaulted["boundaries"][0].as_array_mut().unwrap().pop();
    defaulted.as_object_mut().unwrap().remove("resolution");
    assert_eq!(pointers(&problem(app.post(MINIMAL, &defaulted).await, 422).await), ["/resolution"]);
    // Rings with an odd number of triangles are impossible (Chen-Cai-Zheng).
    let mut request = example("helicoid");
    request["initial_mesh"] = json!("rings");
    request["resolution"] = json!({ "triangles": 2051 });
    let response = app.post_waiting(MINIMAL, &request).await;
    if response.status() == 422 {
        assert_eq!(pointers(&problem(response, 422).await), ["/resolution/triangles"]);
    } else {
        let job: Value = response.json().await.unwrap();
        assert_eq!(job["status"], "failed");
        assert_eq!(job["error"]["errors"][0]["pointer"], "/resolution/triangles");
        let mesh = app.get(job["links"]["mesh"].as_str().unwrap()).await;
        problem(mesh, 409).await;
    }
}

/// Every operation of the API document refuses a query parameter that it does not have.
#[tokio::test]
async fn an_unknown_query_parameter_is_400_on_every_path() {
    let app = TestApp::start_with(&[("PLATEAU_WORKERS", "0")]).await;
    let document = app.get_json("/openapi.json").await;
    let mut tried = 0;
    for (path, item) in document["paths"].as_object().unwrap() {
        for method in item.as_object().unwrap().keys() {
            let method = Method::from_bytes(method.to_uppercase().as_bytes()).unwrap();
            let path = path.replace("{id}", "01J00000000000000000000000").replace("{name}", "tent");
            let answer = app.request(method.clone(), &format!("{path}?colour=blue")).send().await.unwrap();
            assert_eq!(answer.status(), 400, "{method} {path}");
            assert_eq!(problem(answer, 400).await["type"], "/problems/bad-query");
            tried += 1;
        }
    }
    assert!(tried > 25, "{tried}");
    for path in ["/openapi.json", "/problems/not-found"] {
        problem(app.get(&format!("{path}?a=1")).await, 400).await;
    }
    // A page's own query is not the server's.
    if cfg!(feature = "studio") {
        assert_eq!(app.get("/?example=tent").await.status(), 200);
    }
}

#[tokio::test]
async fn a_client_that_accepts_none_of_the_media_types_gets_406_and_submits_nothing() {
    let app = TestApp::start_with(&[("PLATEAU_WORKERS", "0")]).await;
    let job: Value = app.post(MINIMAL, &small_film(0.3)).await.json().await.unwrap();
    let (this, events) = (job["links"]["self"].as_str().unwrap(), job["links"]["events"].as_str().unwrap());
    let ask = async |method: Method, path: &str, accept: &str| {
        let request = app.request(method.clone(), path).header("accept", accept);
        let request = if method == Method::POST { request.json(&small_film(0.4)) } else { request };
        request.send().await.unwrap()
    };
    for path in [this, "/v1/jobs", "/v1/limits", "/v1/objectives", events] {
        problem(ask(Method::GET, path, "text/html").await, 406).await;
        problem(ask(Method::GET, path, "application/json;q=0, text/event-stream;q=0").await, 406).await;
    }
    for accept in ["text/html, */*;q=0.1", "application/*", "application/json"] {
        assert_eq!(ask(Method::GET, this, accept).await.status(), 200, "{accept}");
    }
    problem(ask(Method::POST, MINIMAL, "text/html").await, 406).await;
    assert_eq!(app.get_json("/v1/jobs").await["jobs"].as_array().unwrap().len(), 1);
    assert_eq!(ask(Method::POST, MINIMAL, "model/gltf-binary").await.status(), 202);
    assert_eq!(ask(Method::GET, "/health/ready", "text/html").await.status(), 200);
}

#[tokio::test]
async fn a_failed_post_for_a_mesh_leads_to_its_job_and_has_the_type_of_its_error() {
    let settings = [("PLATEAU_JOBS__DEADLINE_MS", "1"), ("PLATEAU_HTTP__PUBLIC_BASE_PATH", "/plateau")];
    let app = TestApp::start_with(&settings).await;
    app.hold.at("claimed");
    let post = app.request(Method::POST, MINIMAL).header("prefer", "wait=60").header("accept", "model/gltf-binary");
    let answer = post.json(&small_film(0.1)).send().await.unwrap();
    assert_eq!(answer.status(), 409);
    let location = answer.headers()["location"].to_str().unwrap().to_owned();
    assert_eq!(answer.headers()["link"], format!("<{location}>; rel=\"describedby\"").as_str());
    let problem: Value = answer.json().await.unwrap();
    let job = app.get_json(&location).await;
    assert_eq!(job["status"], "failed");
    for field in ["type", "title", "detail"] {
        assert_eq!(problem[field], job["error"][field], "{field}");
    }
    assert_eq!((&problem["type"], &problem["status"]), (&json!("/plateau/problems/deadline"), &json!(409)));
}
