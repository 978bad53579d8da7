//! The API document: the committed, the printed and the served one are equal.

use crate::app::{TestApp, binary, root};
use reqwest::Method;
use serde_json::Value;

#[tokio::test]
async fn the_committed_document_equals_the_served_and_the_printed_one() {
    let committed = std::fs::read_to_string(root().join("api/openapi.json")).unwrap_or_default();
    let printed = String::from_utf8(binary().arg("openapi").output().await.unwrap().stdout).unwrap();
    assert!(
        committed == printed,
        "api/openapi.json is out of date; refresh it: cargo run -- openapi > api/openapi.json"
    );
    let app = TestApp::start().await;
    let served = app.get("/openapi.json").await.text().await.unwrap();
    assert!(served == printed);
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
    for path in ["/problems/{name}", "/docs/", "/docs/{file}", "/studio/{file}"] {
        assert!(document["paths"].get(path).is_some(), "{path} is not documented");
    }
}
