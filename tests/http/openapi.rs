//! The API document: committed, served and printed are one.

use crate::app::{TestApp, binary, root};
use serde_json::Value;

#[tokio::test]
async fn the_committed_document_is_the_one_that_is_served_and_printed() {
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
