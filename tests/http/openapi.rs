//! The API document: the committed, the printed and the served one are equal.

use crate::app::{TestApp, binary, example, is_built, root};
use reqwest::Method;
use serde_json::{Value, json};

#[tokio::test]
async fn the_committed_document_equals_the_served_and_the_printed_one() {
    let path = root().join("api/openapi.json");
    let printed = String::from_utf8(binary().arg("openapi").output().await.unwrap().stdout).unwrap();
    if std::env::var_os("PLATEAU_WRITE").is_some() {
        std::fs::write(&path, without_test_kind(&printed)).unwrap();
    }
    let committed = std::fs::read_to_string(&path).unwrap_or_default();
    assert!(
        committed == without_test_kind(&printed),
        "api/openapi.json is out of date; refresh it: cargo run -- openapi > api/openapi.json, or run this test with \
         PLATEAU_WRITE=1"
    );
    let app = TestApp::start().await;
    let served = app.get("/openapi.json").await.text().await.unwrap();
    assert!(served == printed);
}

/// Returns a document as builds without the feature `test-hooks` print it, in which there is no kind `enlargement`.
fn without_test_kind(document: &str) -> String {
    fn names(value: &Value) -> bool {
        let of_kind = |text: &str| {
            let text = text.rsplit('/').next().unwrap_or_default();
            text == "enlargement" || text == "enlargements" || text == "JobSource" || text.starts_with("Enlargement")
        };
        let reference = value.as_object().filter(|map| map.len() == 1).and_then(|map| map.get("$ref")?.as_str());
        value.as_str().or(reference).is_some_and(of_kind)
    }
    fn remove(value: &mut Value) {
        match value {
            Value::Object(map) => {
                map.retain(|key, value| !names(&key.as_str().into()) && !names(value));
                map.values_mut().for_each(remove);
            }
            Value::Array(list) => {
                list.retain(|item| !names(item));
                list.iter_mut().for_each(remove);
            }
            _ => {}
        }
    }
    let mut document: Value = serde_json::from_str(document).expect("JSON");
    remove(&mut document);
    serde_json::to_string_pretty(&document).expect("JSON") + "\n"
}

/// The clients of Go and Java read a number without a format as one of 32 bits, and `bytes_kept` of the limits is
/// larger.
#[tokio::test]
async fn every_number_says_how_large_it_is() {
    fn walk(value: &Value, place: &str) {
        match value {
            Value::Object(map) => {
                let is = |name: &str| match map.get("type") {
                    Some(Value::Array(names)) => names.iter().any(|one| one == name),
                    one => one.is_some_and(|one| one == name),
                };
                let format = map.get("format").and_then(Value::as_str);
                assert!(!is("number") || format == Some("double"), "{place} may have 32 bits");
                let is_small = map.get("maximum").and_then(Value::as_i64).is_some_and(|it| it <= i32::MAX.into());
                assert!(!is("integer") || is_small || format == Some("int64"), "{place} may have 32 bits");
                let schemas = map.iter().filter(|(name, _)| !["example", "examples"].contains(&name.as_str()));
                schemas.for_each(|(name, value)| walk(value, &format!("{place}/{name}")));
            }
            Value::Array(list) => list.iter().enumerate().for_each(|(k, value)| walk(value, &format!("{place}/{k}"))),
            _ => {}
        }
    }
    walk(&TestApp::start().await.get_json("/openapi.json").await, "");
}

/// openapi-python-client cannot read a reference to a callback, and openapi-generator refuses two equal identifiers.
#[tokio::test]
async fn every_operation_contains_its_callback_with_an_identifier_of_its_own() {
    let document = TestApp::start().await.get_json("/openapi.json").await;
    let posts = document["paths"].as_object().unwrap().values().filter_map(|item| item.get("post"));
    let creates = posts.filter(|post| post["requestBody"].is_object());
    let mut found = 0;
    for post in creates {
        let message = &post["callbacks"]["ended"]["{$request.body#/callback_url}"]["post"];
        assert_eq!(message["operationId"], format!("{}Ended", post["operationId"].as_str().unwrap()));
        found += 1;
    }
    assert!(found >= 6 && document["components"].get("callbacks").is_none());
}

#[tokio::test]
async fn every_reference_resolves_and_every_response_is_described() {
    let app = TestApp::start().await;
    let document = app.get_json("/openapi.json").await;
    assert_eq!(document["openapi"], "3.1.0");
    fn walk(value: &Value, document: &Value) {
        match value {
            Value::Object(map) => {
                if let Some(reference) = map.get("$ref").and_then(Value::as_str) {
                    let pointer = reference.strip_prefix('#').expect("local references only");
                    assert!(document.pointer(pointer).is_some(), "{reference} leads nowhere");
                }
                map.values().for_each(|value| walk(value, document));
            }
            Value::Array(list) => list.iter().for_each(|value| walk(value, document)),
            _ => {}
        }
    }
    walk(&document, &document);
    for (path, methods) in document["paths"].as_object().unwrap() {
        for (method, operation) in methods.as_object().unwrap().iter().filter(|(name, _)| *name != "parameters") {
            for (status, response) in operation["responses"].as_object().unwrap() {
                let response =
                    response["$ref"].as_str().map_or(response, |reference| document.pointer(&reference[1..]).unwrap());
                assert!(response["description"].is_string(), "{method} {path} {status}");
            }
        }
    }
}

/// Checks that every documented path accepts exactly the documented methods, and that every parameter of a path is
/// described.
#[tokio::test]
async fn the_server_accepts_exactly_the_documented_methods() {
    let app = TestApp::start().await;
    let document = app.get_json("/openapi.json").await;
    for (path, item) in document["paths"].as_object().unwrap() {
        let item = item.as_object().unwrap();
        let mut documented: Vec<String> = item.keys().map(|method| method.to_uppercase()).collect();
        if item.contains_key("get") {
            documented.push("HEAD".into());
        }
        documented.sort();
        let concrete = path.split('/').map(|part| if part.starts_with('{') { "x" } else { part }).collect::<Vec<_>>();
        let response = app.request(Method::PATCH, &concrete.join("/")).send().await.unwrap();
        assert_eq!(response.status(), 405, "{path}");
        let mut allowed: Vec<&str> = response.headers()["allow"].to_str().unwrap().split(',').collect();
        allowed.sort_unstable();
        assert_eq!(allowed, documented, "{path}");
        for part in path.split('/').filter_map(|part| part.strip_prefix('{')) {
            let name = part.trim_end_matches('}');
            for operation in item.values() {
                let parameters = operation["parameters"].as_array().unwrap();
                let found = parameters.iter().any(|parameter| parameter["in"] == "path" && parameter["name"] == name);
                assert!(found, "{path}: {name} is not described");
            }
        }
    }
}

/// Checks that Hops gets errors in its own form.
async fn expect_answers_of_hops(app: &TestApp) {
    let message = app.request(Method::POST, "/solve").json(&serde_json::json!({})).send().await.unwrap();
    let answer: Value = message.json().await.unwrap();
    assert!(answer["errors"].is_array() && answer["values"].is_array(), "{answer}");
    let patched = app.request(Method::PATCH, "/solve").send().await.unwrap();
    assert_eq!(patched.status(), 405);
    let answer: Value = patched.json().await.unwrap();
    assert!(answer["errors"][0].as_str().unwrap().ends_with("the header Allow lists this path's methods"), "{answer}");
}

/// Checks that the document has every path of the API and no other path, although the server also answers for pages,
/// their files and other protocols.
#[tokio::test]
async fn the_document_describes_the_api_alone() {
    let app = TestApp::start().await;
    let document = app.get_json("/openapi.json").await;
    for path in document["paths"].as_object().unwrap().keys() {
        let of_api =
            path.starts_with("/v1/") || path.starts_with("/health/") || path == "/metrics" || path == "/problems";
        assert!(of_api, "{path} is no part of the API");
    }
    for path in ["/v1/jobs/{id}/mesh", "/health/live", "/health/ready", "/metrics"] {
        assert!(document["paths"].get(path).is_some(), "{path} is not documented");
    }
    let paths = ["/", "/docs/", "/docs/start.js", "/studio/studio.js", "/problems/not-found", "/hops", "/openapi.json"];
    for path in paths.into_iter().filter(|path| is_built(path)) {
        assert_eq!(app.get(path).await.status(), 200, "{path}");
    }
    if cfg!(feature = "hops") {
        expect_answers_of_hops(&app).await;
    }
    // A tag without an operation, or an operation without a tag of the list, is a group that a generator leaves empty.
    let mut used: Vec<&str> = document["paths"]
        .as_object()
        .unwrap()
        .values()
        .flat_map(|item| item.as_object().unwrap().values())
        .flat_map(|operation| operation["tags"].as_array().unwrap())
        .map(|tag| tag.as_str().unwrap())
        .collect();
    used.sort_unstable();
    used.dedup();
    let mut listed: Vec<&str> =
        document["tags"].as_array().unwrap().iter().map(|tag| tag["name"].as_str().unwrap()).collect();
    listed.sort_unstable();
    assert_eq!(used, listed);
}

/// Calls `check` with every object of a document and the path to it.
fn for_each_object(value: &Value, path: &str, check: &mut impl FnMut(&str, &serde_json::Map<String, Value>)) {
    match value {
        Value::Object(map) => {
            check(path, map);
            map.iter().for_each(|(key, value)| for_each_object(value, &format!("{path}/{key}"), check));
        }
        Value::Array(list) => {
            list.iter()
                .enumerate()
                .for_each(|(index, value)| for_each_object(value, &format!("{path}/{index}"), check));
        }
        _ => {}
    }
}

/// Checks several rules. Each excludes a form on which a client generator failed.
#[tokio::test]
async fn the_schemas_have_only_forms_that_generators_take() {
    let app = TestApp::start().await;
    let document = app.get_json("/openapi.json").await;
    let schemas = &document["components"]["schemas"];
    for_each_object(schemas, "", &mut |path, schema| {
        if path.ends_with("/properties") {
            return;
        }
        assert!(!schema.contains_key("default"), "{path}: openapi-typescript makes a field with a default required");
        assert!(schema.get("items").is_none_or(Value::is_object), "{path}: openapi-python-client takes no true");
        assert!(!schema.contains_key("const"), "{path}: a list with one value is clearer to openapi-generator");
        assert!(!schema.contains_key("anyOf"), "{path}: clients of typescript-fetch lose the parts of an anyOf");
        if let Some(parts) = schema.get("oneOf").and_then(Value::as_array) {
            let objects = parts.iter().filter(|part| {
                let name = part["$ref"].as_str().and_then(|reference| reference.rsplit('/').next());
                name.is_some_and(|name| schemas[name]["type"] == "object")
            });
            let is_tagged = schema.get("discriminator").is_some_and(|tag| tag["propertyName"] == "kind");
            assert!(objects.count() < 2 || is_tagged, "{path}: a union without a discriminator");
        }
    });
    for name in
        ["Point", "Polyline", "Polygon", "MinimalSurfaceObjective", "RuledSurfaceObjective", "MinimalSurfaceJob"]
    {
        assert!(schemas.get(name).is_some(), "{name}");
    }
    let boundaries = &schemas["MinimalSurfaceRequest"]["properties"]["boundaries"];
    assert_eq!(boundaries["items"]["$ref"], "#/components/schemas/Polygon");
    let units = &schemas["MinimalSurfaceRequest"]["properties"]["units"];
    assert_eq!((&units["x-default"], &schemas["Units"]["enum"][0]), (&"m".into(), &"mm".into()));
    let statistics = &schemas["UniformMeshJob"]["properties"]["statistics"]["oneOf"];
    assert_eq!(statistics[0]["$ref"], "#/components/schemas/UniformStatistics");
    let answer = &document["paths"]["/v1/uniform-meshes"]["post"]["responses"]["200"]["content"]["application/json"];
    assert_eq!(answer["schema"]["$ref"], "#/components/schemas/UniformMeshJob");
}

/// Optional members may be null, although the document does not name null as their default.
#[tokio::test]
async fn null_is_accepted_where_the_document_says_so() {
    let app = TestApp::start().await;
    let body = serde_json::json!({
        "kind": null, "callback_url": null, "fairing_tolerance": null, "processes": null, "max_iterations": null,
        "boundaries": [[[0, 0, 0], [1, 0, 0], [0, 1, 1]]],
    });
    assert_eq!(app.post("/v1/minimal-surfaces", &body).await.status(), 202);
}

/// Returns an answer with at most two items in each list of objects or lists, and three in each other list.
fn shortened(answer: &Value) -> Value {
    match answer {
        Value::Array(items) => {
            let nested = items.first().is_some_and(|item| item.is_object() || item.is_array());
            items.iter().take(if nested { 2 } else { 3 }).map(shortened).collect()
        }
        Value::Object(members) => members.iter().map(|(name, member)| (name.clone(), shortened(member))).collect(),
        other => other.clone(),
    }
}

/// Returns an answer of a server to each operation with a JSON answer, by operation and status.
async fn answers(app: &TestApp) -> Value {
    let mut found = json!({});
    let mut note = |operation: &str, status: u16, answer: Value| {
        // A shortened request would not be valid.
        let answer = if ["getExample", "getRequest"].contains(&operation) { answer } else { shortened(&answer) };
        found[operation][status.to_string()] = answer;
    };
    for (operation, path) in [
        ("getLive", "/health/live"),
        ("getReady", "/health/ready"),
        ("getLimits", "/v1/limits"),
        ("listObjectives", "/v1/objectives"),
        ("listExamples", "/v1/examples"),
        ("getExample", "/v1/examples/four-corners"),
        ("listProblems", "/problems"),
    ] {
        note(operation, 200, app.get_json(path).await);
    }
    for (operation, path, name) in [
        ("postRuledSurface", "/v1/ruled-surfaces", "two-rails"),
        ("postMinimalSurface", "/v1/minimal-surfaces", "four-corners"),
        ("postUniformMesh", "/v1/uniform-meshes", "floor-fewest-nodes"),
        ("postTensileStructure", "/v1/tensile-structures", "inflated-disc"),
        ("postCableNet", "/v1/cable-nets", "four-cables"),
    ] {
        let mut request = example(name);
        if request.get("resolution").is_some() {
            request["resolution"] = json!({ "triangles": 200 });
        }
        request["label"] = json!("an example");
        let accepted = app.post(path, &request).await;
        let status = accepted.status().as_u16();
        let job: Value = accepted.json().await.unwrap();
        if status == 202 {
            note(operation, 202, job.clone());
        }
        let this = job["links"]["self"].as_str().unwrap().to_owned();
        let ended = app.ended(job).await;
        if operation == "postMinimalSurface" {
            note("getJob", 200, app.get_json(&this).await);
            note("getRequest", 200, app.get_json(&format!("{this}/request")).await);
            note("cancelJob", 200, ended.clone());
            let callbacks = app.get_json(&format!("{this}/callbacks")).await;
            note("getJobCallbacks", 200, callbacks.clone());
            note("sendJobCallbackAgain", 202, callbacks);
        }
        note(operation, 200, ended);
    }
    note("listJobs", 200, app.get_json("/v1/jobs?limit=2").await);
    let with_kind = |name: &str| -> Value { example(name) };
    let batch = json!({ "requests": [with_kind("two-rails"), with_kind("four-cables")] });
    let accepted = app.post("/v1/batches", &batch).await;
    let batch: Value = accepted.json().await.unwrap();
    note("postBatch", 202, batch.clone());
    let this = batch["links"]["self"].as_str().unwrap().to_owned();
    let waiting = app.request(Method::GET, &this).header("prefer", "wait=60").send().await.unwrap();
    let ended: Value = waiting.json().await.unwrap();
    for operation in ["postBatch", "getBatch", "cancelBatch"] {
        note(operation, 200, ended.clone());
    }
    let callbacks = app.get_json(&format!("{this}/callbacks")).await;
    note("getBatchCallbacks", 200, callbacks.clone());
    note("sendBatchCallbackAgain", 202, callbacks);
    found
}

/// Every operation has a description, and every JSON answer an example that satisfies its schema. The examples are
/// answers of a server.
#[tokio::test]
async fn every_operation_is_described_and_has_examples_of_its_answers() {
    let app = TestApp::start().await;
    if std::env::var_os("PLATEAU_WRITE").is_some() {
        let text = serde_json::to_string_pretty(&answers(&app).await).unwrap() + "\n";
        std::fs::write(root().join("src/http/openapi/examples.json"), text).unwrap();
    }
    let document = app.get_json("/openapi.json").await;
    let (mut lacking, mut checked) = (Vec::new(), 0);
    for (path, item) in document["paths"].as_object().unwrap() {
        for (method, operation) in item.as_object().unwrap() {
            if operation["description"].as_str().is_none_or(str::is_empty) {
                lacking.push(format!("{method} {path} has no description"));
            }
            for (status, response) in operation["responses"].as_object().unwrap() {
                let content = &response["content"]["application/json"];
                let schema = &content["schema"];
                if !status.starts_with('2')
                    || schema.is_null()
                    || schema["format"] == "binary"
                    || path.contains("enlargement")
                {
                    continue;
                }
                let schema = json!({ "allOf": [schema], "components": document["components"] });
                match jsonschema::validator_for(&schema).unwrap().validate(&content["example"]) {
                    Ok(()) => checked += 1,
                    Err(error) => {
                        lacking.push(format!("{method} {path} {status}: {error} at {}", error.instance_path()))
                    }
                }
            }
        }
    }
    assert!(lacking.is_empty(), "{}\nPLATEAU_WRITE=1 writes the examples again", lacking.join("\n"));
    assert!(checked > 25, "{checked}");
}
