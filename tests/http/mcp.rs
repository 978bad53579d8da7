//! The tools for language models, at `POST /mcp` and on standard input and output.

use crate::access::new_key;
use crate::app::{TestApp, binary, example, problem, small_film};
use crate::hold::{self, Hold, until};
use crate::sources::enlargement;
use base64::Engine as _;
use reqwest::{Method, Response, StatusCode};
use serde_json::{Value, json};
use std::process::Stdio;
use tokio::io::{AsyncBufReadExt, AsyncReadExt, AsyncWriteExt, BufReader};

const ON: (&str, &str) = ("PLATEAU_HTTP__MCP", "true");

fn message(method: &str, params: Value) -> Value {
    json!({ "jsonrpc": "2.0", "id": 1, "method": method, "params": params })
}

fn call(tool: &str, arguments: &Value) -> Value {
    message("tools/call", json!({ "name": tool, "arguments": arguments }))
}

async fn post(app: &TestApp, key: Option<&str>, body: &Value) -> Response {
    let request = app.request(Method::POST, "/mcp").header("accept", "application/json, text/event-stream");
    let request = key.into_iter().fold(request, |request, key| request.bearer_auth(key));
    request.json(body).send().await.expect("an answer")
}

/// Calls a tool and returns its result.
async fn result_of(app: &TestApp, key: Option<&str>, tool: &str, arguments: &Value) -> Value {
    let response = post(app, key, &call(tool, arguments)).await;
    assert_eq!(response.status(), StatusCode::OK);
    let mut answer: Value = response.json().await.expect("JSON");
    assert!(answer["error"].is_null(), "{answer:#}");
    answer["result"].take()
}

/// Calls a tool that must succeed, and returns its result.
async fn succeed(app: &TestApp, tool: &str, arguments: &Value) -> Value {
    let result = result_of(app, None, tool, arguments).await;
    assert_eq!(result["isError"], false, "{result:#}");
    let text: Value = serde_json::from_str(result["content"][0]["text"].as_str().unwrap()).unwrap();
    assert_eq!(text, result["structuredContent"], "the text and the structured content differ");
    result
}

/// Calls a tool that must fail, and returns its text.
async fn fail(app: &TestApp, key: Option<&str>, tool: &str, arguments: &Value) -> String {
    let result = result_of(app, key, tool, arguments).await;
    assert_eq!(result["isError"], true, "{result:#}");
    result["content"][0]["text"].as_str().unwrap().to_owned()
}

/// Returns the width and height of the PNG file in a result's picture.
fn size_of_picture(result: &Value) -> (u32, u32) {
    let picture = result["content"].as_array().unwrap().iter().find(|part| part["type"] == "image").expect("a picture");
    assert_eq!(picture["mimeType"], "image/png");
    let bytes = base64::engine::general_purpose::STANDARD.decode(picture["data"].as_str().unwrap()).unwrap();
    let reader = png::Decoder::new(std::io::Cursor::new(bytes)).read_info().unwrap();
    (reader.info().width, reader.info().height)
}

#[tokio::test]
async fn every_tool_has_schemas_that_stand_alone_and_describe_lists_what_can_be_solved() {
    let app = TestApp::start_with(&[ON]).await;
    let answer: Value = post(&app, None, &message("tools/list", json!({}))).await.json().await.unwrap();
    let tools = answer["result"]["tools"].as_array().unwrap();
    let names: Vec<&str> = tools.iter().map(|tool| tool["name"].as_str().unwrap()).collect();
    assert_eq!(names, ["describe", "solve", "start", "get", "cancel", "link"]);
    for tool in tools {
        for schema in [&tool["inputSchema"], &tool["outputSchema"]] {
            assert_eq!(schema["type"], "object", "{tool:#}");
            jsonschema::validator_for(schema).expect("a valid schema without outer references");
        }
    }
    let described = &succeed(&app, "describe", &json!({ "whole": true })).await["structuredContent"];
    // There are five kinds, and one more that only builds for tests have.
    assert_eq!(described["kinds"].as_array().unwrap().len(), 6);
    assert_eq!(described["limits"], app.get_json("/v1/limits").await);
    assert_eq!(described["objectives"], app.get_json("/v1/objectives").await["objectives"]);
    for kind in ["ruled_surface", "minimal_surface", "uniform_mesh", "tensile_structure", "cable_net"] {
        let described = &succeed(&app, "describe", &json!({ "kind": kind, "whole": true })).await["structuredContent"];
        let request = &described["example"]["request"];
        assert_eq!(request["kind"], kind);
        let schema = jsonschema::validator_for(&described["request_schema"]).unwrap();
        assert!(schema.is_valid(request) && !schema.is_valid(&json!({ "kind": kind })), "{kind}");
        let solved = &succeed(&app, "solve", &json!({ "request": request })).await["structuredContent"];
        assert_eq!(solved["status"], "succeeded");
        let schema = jsonschema::validator_for(&described["statistics_schema"]).unwrap();
        assert!(schema.is_valid(&solved["statistics"]), "{kind}");
        let schema = jsonschema::validator_for(&tools[1]["outputSchema"]).unwrap();
        assert!(schema.is_valid(solved), "{kind}");
    }
    let helicoid = &succeed(&app, "describe", &json!({ "example": "helicoid" })).await["structuredContent"];
    assert_eq!(helicoid["example"]["request"], example("helicoid"));
}

/// A description of a kind took 9,000 tokens, at four characters a token.
#[tokio::test]
async fn a_description_is_short_unless_the_whole_is_wanted() {
    let app = TestApp::start_with(&[ON]).await;
    let length = |value: &Value| value.to_string().len();
    let described = &succeed(&app, "describe", &json!({})).await["structuredContent"];
    assert!(length(described) < 6_000, "{}", length(described));
    let kinds = described["kinds"].as_array().unwrap();
    let examples: Vec<&Value> = kinds.iter().flat_map(|kind| kind["examples"].as_array().unwrap()).collect();
    let listed = app.get_json("/v1/examples").await;
    assert_eq!(examples.len(), listed["examples"].as_array().unwrap().len());
    for kind in ["ruled_surface", "minimal_surface", "uniform_mesh", "tensile_structure", "cable_net"] {
        let described = &succeed(&app, "describe", &json!({ "kind": kind })).await["structuredContent"];
        assert!(length(described) < 10_000, "{kind}: {}", length(described));
        let whole = &succeed(&app, "describe", &json!({ "kind": kind, "whole": true })).await["structuredContent"];
        let (members, schema) = (described["members"].as_object().unwrap(), &whole["request_schema"]);
        let properties = schema["properties"].as_object().unwrap();
        assert!(members.len() == properties.len() && members.keys().all(|name| properties.contains_key(name)));
        for (name, text) in members {
            let is_required = schema["required"].as_array().unwrap().contains(&name.as_str().into());
            let text = text.as_str().unwrap();
            assert_eq!(text.starts_with("Required. "), is_required, "{kind} {name}: {text}");
            assert!(text.len() > 10 && text.ends_with('.'), "{kind} {name}: {text}");
        }
        let names = described["kinds"][0]["objectives"].as_array().unwrap().iter();
        assert!(names.eq(whole["objectives"].as_array().unwrap().iter().map(|objective| &objective["name"])));
    }
    let sail = &succeed(&app, "describe", &json!({ "kind": "tensile_structure" })).await["structuredContent"];
    assert!(sail["example"]["request"]["cables"][0]["along"].is_object(), "{sail:#}");
}

#[tokio::test]
async fn a_job_is_cancelled_by_its_owner_and_stays_cancelled() {
    let app = TestApp::start_with(&[ON]).await;
    app.hold.at("claimed");
    let started = succeed(&app, "start", &json!({ "request": example("two-rails") })).await["structuredContent"].take();
    let arguments = json!({ "id": started["id"] });
    let cancelled = succeed(&app, "cancel", &arguments).await["structuredContent"].take();
    assert_eq!((&cancelled["status"], &cancelled["cancelled_because"]), (&"cancelled".into(), &"client".into()));
    let again = succeed(&app, "cancel", &arguments).await["structuredContent"].take();
    assert_eq!(again["status"], "cancelled");
    assert!(fail(&app, None, "cancel", &json!({ "id": "0".repeat(26) })).await.contains("not-found"));
}

#[tokio::test]
async fn links_lead_to_every_file_of_a_job() {
    let app = TestApp::start_with(&[ON]).await;
    let strip = succeed(&app, "solve", &json!({ "request": example("two-rails") })).await["structuredContent"].take();
    let mut film = small_film(0.7);
    film["kind"] = "minimal_surface".into();
    let has_certificate = cfg!(feature = "certificates");
    film["certify"] = has_certificate.into();
    let film = succeed(&app, "solve", &json!({ "request": film })).await["structuredContent"].take();
    for (job, arguments, format) in [
        (&strip, json!({ "file": "pattern" }), "svg"),
        (&strip, json!({ "file": "pattern", "format": "dxf" }), "dxf"),
        (&strip, json!({ "file": "pattern", "format": "dxf", "query": "profile=cut&kerf=0.2" }), "zip"),
        (&strip, json!({ "file": "schedule", "query": "part=bends" }), "csv"),
        (&film, json!({ "file": "certificate" }), "json"),
    ] {
        if arguments["file"] == "certificate" && !has_certificate {
            continue;
        }
        let mut arguments = arguments;
        arguments["id"] = job["id"].clone();
        let link = &succeed(&app, "link", &arguments).await["structuredContent"];
        assert_eq!(link["format"], format, "{arguments}");
        let file = app.client.get(link["url"].as_str().unwrap()).send().await.unwrap();
        assert_eq!(file.status(), StatusCode::OK, "{link:#}");
        let media_type = file.headers()["content-type"].to_str().unwrap();
        assert_eq!(media_type.split(';').next(), link["media_type"].as_str(), "{link:#}");
    }
    for (job, arguments, expected) in [
        (&film, json!({ "file": "pattern" }), "/file: this job has no pattern"),
        (&strip, json!({ "file": "certificate" }), "certif"),
        (&strip, json!({ "file": "pattern", "query": "profile=paper" }), "profile"),
        (&strip, json!({ "file": "schedule" }), "part: is required"),
        (&strip, json!({ "file": "pattern", "format": "glb" }), "format"),
        (&strip, json!({ "file": "mesh", "format": "fbx" }), "/format: must be one of glb, "),
        (&strip, json!({ "query": "kerf=1" }), "/query"),
        (&strip, json!({ "file": "shadow" }), "/file: must be one of mesh, pattern, schedule, certificate"),
    ] {
        let mut arguments = arguments;
        arguments["id"] = job["id"].clone();
        let text = fail(&app, None, "link", &arguments).await;
        assert!(text.contains(expected), "{arguments}: {text}");
    }
}

#[tokio::test]
async fn a_kind_that_only_the_table_names_is_described_and_solved() {
    let app = TestApp::start_with(&[ON]).await;
    let described =
        &succeed(&app, "describe", &json!({ "kind": "enlargement", "whole": true })).await["structuredContent"];
    assert_eq!(described["kinds"][0]["summary"], "Enlarges the mesh of a finished job");
    let film = app.solve("/v1/minimal-surfaces", &small_film(0.3)).await;
    let request = enlargement(&film, 2.0);
    assert!(jsonschema::validator_for(&described["request_schema"]).unwrap().is_valid(&request));
    let solved = &succeed(&app, "solve", &json!({ "request": request })).await["structuredContent"];
    assert_eq!(solved["status"], "succeeded");
    assert!(jsonschema::validator_for(&described["statistics_schema"]).unwrap().is_valid(&solved["statistics"]));
    let missing = enlargement(&json!({ "id": "01J00000000000000000000000" }), 2.0);
    let text = fail(&app, None, "solve", &json!({ "request": missing })).await;
    assert!(text.contains("/request/source/job"), "{text}");
}

#[tokio::test]
async fn a_started_job_can_be_got_with_its_picture_and_linked() {
    let app = TestApp::start_with(&[ON]).await;
    let mut request = small_film(0.7);
    request["kind"] = "minimal_surface".into();
    let started = succeed(&app, "start", &json!({ "request": request })).await["structuredContent"].take();
    assert!(started.get("statistics").is_none());
    let id = started["id"].as_str().unwrap();
    let got = succeed(&app, "get", &json!({ "id": id, "wait_s": 60 })).await;
    assert_eq!(size_of_picture(&got), (480, 360));
    assert_eq!(got["structuredContent"], app.get_json(&format!("/v1/jobs/{id}")).await);
    for format in ["glb", "gltf", "obj", "ply", "stl"] {
        let link = &succeed(&app, "link", &json!({ "id": id, "format": format })).await["structuredContent"];
        let url = link["url"].as_str().unwrap();
        assert!(url.starts_with(&app.url) && link["needs_key"] == false, "{link:#}");
        let mesh = app.client.get(url).send().await.unwrap();
        assert_eq!(mesh.status(), StatusCode::OK);
        assert_eq!(mesh.headers()["content-type"], link["media_type"].as_str().unwrap());
    }
    // A wait of 0 s asks for the state only.
    app.hold.at("claimed");
    let running = succeed(&app, "solve", &json!({ "request": example("two-rails"), "wait_s": 0 })).await;
    let state = running["structuredContent"]["status"].as_str().unwrap();
    assert!(["queued", "running"].contains(&state), "{state}");
    assert_eq!(running["content"].as_array().unwrap().len(), 1, "there is no picture yet");
    let id = running["structuredContent"]["id"].as_str().unwrap();
    assert!(fail(&app, None, "link", &json!({ "id": id })).await.contains("no-mesh"));
}

#[tokio::test]
async fn a_wrong_argument_is_named_by_its_pointer() {
    let app = TestApp::start_with(&[ON]).await;
    let film = |boundary: Value| json!({ "request": { "kind": "minimal_surface", "boundaries": [boundary] } });
    let unknown = "0".repeat(26);
    for (tool, arguments, expected) in [
        ("solve", film(json!([[0, 0, 0], [1, 0, "x"], [1, 1, 0]])), "/request/boundaries/0/1/2"),
        ("start", film(json!([[0, 0, 0]])), "/request/boundaries/0"),
        ("solve", json!({ "request": { "kind": "sphere" } }), "/request/kind: must be one of ruled_surface, "),
        ("solve", json!({ "request": {} }), "/request/kind: is required"),
        ("solve", json!({}), "/request: is required"),
        (
            "start",
            json!({ "request": { "kind": "uniform_mesh" }, "wait_s": 1 }),
            "/wait_s: is not a member of this object, whose members are request",
        ),
        ("solve", json!({ "request": { "kind": "uniform_mesh" }, "wait_s": -1 }), "/wait_s"),
        ("describe", json!({ "kind": "sphere" }), "/kind: must be one of ruled_surface, "),
        ("describe", json!({ "example": "sphere" }), "/example: must be one of two-rails, helicoid"),
        ("get", json!({ "id": 7 }), "/id"),
        ("get", json!({ "id": unknown }), "not-found"),
        ("get", json!({ "id": "../limits" }), "not-found"),
        ("link", json!({ "id": unknown, "file": "fbx" }), "/file: must be one of mesh, "),
        ("cancel", json!({ "id": 7 }), "/id"),
    ] {
        let text = fail(&app, None, tool, &arguments).await;
        assert!(text.contains(expected), "{tool} {arguments}: {text}");
    }
    let answer: Value = post(&app, None, &call("melt", &json!({}))).await.json().await.unwrap();
    let text = answer["error"]["message"].as_str().unwrap();
    assert!(text.contains("describe, solve, start, get, cancel, link"), "{text}");
}

#[tokio::test]
async fn mcp_is_behind_the_same_checks_as_every_other_resource() {
    let secrets = tempfile::tempdir().unwrap();
    let ((alice, first), (bob, second)) = (new_key("alice").await, new_key("bob").await);
    let file = secrets.path().join("keys");
    std::fs::write(&file, format!("{first}\n{second}\n")).unwrap();
    let file = file.display().to_string();
    let keys = ("PLATEAU_AUTH__KEYS_FILE", file.as_str());
    let app = TestApp::start_with(&[ON, keys]).await;
    let list = message("tools/list", json!({}));
    problem(post(&app, None, &list).await, 401).await;
    problem(post(&app, Some("plateau_0"), &list).await, 401).await;
    assert_eq!(post(&app, Some(&alice), &list).await.status(), StatusCode::OK);

    // A job belongs to the key that submitted it.
    let mut request = small_film(0.5);
    request["kind"] = "minimal_surface".into();
    let solved = result_of(&app, Some(&alice), "solve", &json!({ "request": request })).await;
    assert_eq!(solved["structuredContent"]["status"], "succeeded", "{solved:#}");
    let id = &solved["structuredContent"]["id"];
    for tool in ["get", "cancel", "link"] {
        assert!(fail(&app, Some(&bob), tool, &json!({ "id": id })).await.contains("not-found"));
        let own = result_of(&app, Some(&alice), tool, &json!({ "id": id })).await;
        assert_eq!(own["isError"], false, "{own:#}");
    }
    let link = result_of(&app, Some(&alice), "link", &json!({ "id": id })).await;
    assert_eq!(link["structuredContent"]["needs_key"], true);

    let with = |name: &'static str, value: &'static str| {
        let request = app.request(Method::POST, "/mcp").header("accept", "application/json, text/event-stream");
        request.bearer_auth(&alice).header(name, value).json(&list).send()
    };
    problem(with("host", "evil.example").await.unwrap(), 421).await;
    problem(with("origin", "https://evil.example").await.unwrap(), 403).await;
    let response = with("x-forwarded-proto", "https").await.unwrap();
    assert_eq!(response.status(), StatusCode::OK);
}

#[tokio::test]
async fn mcp_is_off_by_default_and_its_faults_are_problem_documents() {
    let app = TestApp::start().await;
    let list = message("tools/list", json!({}));
    let off = problem(post(&app, None, &list).await, 404).await;
    assert!(off["detail"].as_str().unwrap().contains("http.mcp"), "{off}");

    let app = TestApp::start_with(&[ON, ("PLATEAU_LIMITS__BODY_BYTES", "10000")]).await;
    let request = || app.request(Method::POST, "/mcp").header("accept", "application/json, text/event-stream");
    let json = || request().header("content-type", "application/json");
    problem(json().body("{").send().await.unwrap(), 400).await;
    problem(json().body("[1]").send().await.unwrap(), 400).await;
    problem(request().header("content-type", "text/plain").body("{}").send().await.unwrap(), 415).await;
    problem(app.request(Method::POST, "/mcp").json(&list).send().await.unwrap(), 406).await;
    problem(json().body("x".repeat(20_000)).send().await.unwrap(), 413).await;
    let allowed = app.get("/mcp").await;
    assert_eq!((allowed.status().as_u16(), allowed.headers()["allow"].to_str().unwrap()), (405, "POST"));
}

/// A session with `plateau mcp`.
struct Session {
    child: tokio::process::Child,
    input: tokio::process::ChildStdin,
    output: tokio::io::Lines<BufReader<tokio::process::ChildStdout>>,
    hold: Hold,
    folder: tempfile::TempDir,
}

impl Session {
    async fn open() -> Self {
        let folder = tempfile::tempdir().unwrap();
        let hold = Hold::new(&folder.path().join("hold"));
        let mut child = binary()
            .args(["mcp", "--data"])
            .arg(folder.path().join("data"))
            .env(hold::VARIABLE, &hold.folder)
            .env("PLATEAU_LOG__LEVEL", "warn")
            .stdin(Stdio::piped())
            .stdout(Stdio::piped())
            .stderr(Stdio::piped())
            .spawn()
            .unwrap();
        let output = BufReader::new(child.stdout.take().unwrap()).lines();
        let mut session = Self { input: child.stdin.take().unwrap(), output, child, hold, folder };
        let client = json!({ "name": "test", "version": "1" });
        let initialize = json!({ "protocolVersion": "2025-06-18", "capabilities": {}, "clientInfo": client });
        let opened = session.ask(&message("initialize", initialize)).await;
        assert_eq!(opened["result"]["serverInfo"]["name"], "plateau", "{opened:#}");
        assert!(opened["result"]["instructions"].as_str().unwrap().contains("describe"));
        session.send(&json!({ "jsonrpc": "2.0", "method": "notifications/initialized" })).await;
        session
    }

    async fn send(&mut self, message: &Value) {
        self.input.write_all(format!("{message}\n").as_bytes()).await.unwrap();
    }

    async fn ask(&mut self, message: &Value) -> Value {
        self.send(message).await;
        serde_json::from_str(&self.output.next_line().await.unwrap().expect("an answer")).expect("only JSON")
    }
}

#[tokio::test]
async fn a_session_on_standard_input_solves_and_ends_in_order_with_its_input() {
    let mut session = Session::open().await;
    let solved = session.ask(&call("solve", &json!({ "request": example("helicoid") }))).await["result"].take();
    assert_eq!(solved["structuredContent"]["status"], "succeeded", "{solved:#}");
    assert_eq!(size_of_picture(&solved), (480, 360));
    let id = &solved["structuredContent"]["id"];
    let link = session.ask(&call("link", &json!({ "id": id, "format": "ply" }))).await["result"].take();
    let url = link["structuredContent"]["url"].as_str().unwrap();
    let mesh = crate::app::client().get(url).send().await.unwrap();
    assert_eq!(mesh.status(), StatusCode::OK);
    assert!(mesh.bytes().await.unwrap().starts_with(b"ply\n"));
    let refused = session.ask(&call("solve", &json!({ "request": { "kind": "minimal_surface" } }))).await;
    assert!(refused["result"]["content"][0]["text"].as_str().unwrap().contains("/request/boundaries: is required"));

    let Session { mut child, input, mut output, folder: _folder, .. } = session;
    drop(input);
    assert!(child.wait().await.unwrap().success());
    assert_eq!(output.next_line().await.unwrap(), None, "nothing else may be on standard output");
    let mut log = String::new();
    child.stderr.take().unwrap().read_to_string(&mut log).await.unwrap();
    assert!(log.contains("listening on http://127.0.0.1:"), "{log}");
}

#[tokio::test]
async fn a_session_ends_at_sigterm_although_its_input_is_open() {
    let mut session = Session::open().await;
    let id = session.child.id().unwrap().to_string();
    assert!(tokio::process::Command::new("kill").args(["-TERM", &id]).status().await.unwrap().success());
    assert!(session.child.wait().await.unwrap().success());
}

#[tokio::test]
async fn a_cancelled_call_cancels_its_job() {
    let mut session = Session::open().await;
    session.hold.at("claimed");
    session.send(&call("solve", &json!({ "request": example("two-rails") }))).await;
    let log = session.child.stderr.take().unwrap();
    let address = BufReader::new(log).lines().next_line().await.unwrap().unwrap();
    let url = format!("{}/v1/jobs", address.strip_prefix("listening on ").unwrap());
    let client = crate::app::client();
    let status_is = async |status: &str| {
        let list: Value = client.get(&url).send().await.unwrap().json().await.unwrap();
        list["jobs"][0]["status"] == status
    };
    until("the job runs", async || status_is("running").await).await;
    let params = json!({ "requestId": 1, "reason": "the user pressed Esc" });
    session.send(&json!({ "jsonrpc": "2.0", "method": "notifications/cancelled", "params": params })).await;
    until("the job is cancelled", async || status_is("cancelled").await).await;
}

#[tokio::test]
async fn a_session_refuses_keys_because_its_links_carry_none() {
    let (_, line) = new_key("alice").await;
    let folder = tempfile::tempdir().unwrap();
    let file = folder.path().join("keys");
    std::fs::write(&file, format!("{line}\n")).unwrap();
    let mut command = binary();
    command.arg("mcp").arg("--data").arg(folder.path()).env("PLATEAU_AUTH__KEYS_FILE", &file);
    let run = command.stdin(Stdio::null()).output().await.unwrap();
    assert_eq!(run.status.code(), Some(2));
    assert!(run.stdout.is_empty() && String::from_utf8_lossy(&run.stderr).contains("auth.keys_file"));
}
