//! The catalogue: objectives, limits, pages and kinds of problems.

use crate::app::{TestApp, is_built};
use reqwest::header;

#[tokio::test]
async fn objectives_have_a_formula_a_unit_and_a_source() {
    let app = TestApp::start().await;
    let list = app.get_json("/v1/objectives").await;
    let objectives = list["objectives"].as_array().unwrap();
    for (kind, name) in [
        ("ruled_surface", "minimal_area"),
        ("minimal_surface", "minimal_area"),
        ("uniform_mesh", "fewest_nodes"),
        ("uniform_mesh", "most_equal_edges"),
        ("tensile_structure", "equilibrium"),
        ("cable_net", "nearest_to_targets"),
    ] {
        assert!(objectives.iter().any(|objective| objective["kind"] == kind && objective["name"] == name), "{kind}");
    }
    for objective in objectives {
        for field in ["minimises", "unit", "source"] {
            assert!(!objective[field].as_str().unwrap().is_empty(), "{objective}");
        }
    }
}

#[tokio::test]
async fn limits_are_the_configured_ones() {
    let app = TestApp::start_with(&[("PLATEAU_LIMITS__TRIANGLES", "4321"), ("PLATEAU_JOBS__QUEUE_LENGTH", "7")]).await;
    let limits = app.get_json("/v1/limits").await;
    assert_eq!((limits["triangles"].as_u64(), limits["queue_length"].as_u64()), (Some(4321), Some(7)));
    let names = ["queue_length_per_key", "open_requests_per_key", "jobs_kept", "bytes_kept"];
    let shares = names.map(|name| limits[name].as_u64());
    assert_eq!(
        shares,
        [Some(7), Some(1024), Some(100_000), Some(20 << 30)],
        "without keys one client may fill the queue"
    );
}

#[tokio::test]
async fn the_pages_load_nothing_from_other_hosts() {
    let app = TestApp::start().await;
    for path in ["/", "/docs"].into_iter().filter(|path| is_built(path)) {
        let response = app.get(path).await;
        assert_eq!(response.status(), 200, "{path}");
        assert!(response.headers()[header::CONTENT_TYPE].to_str().unwrap().starts_with("text/html"));
        let html = response.text().await.unwrap();
        assert!(
            !html.contains("src=\"http") && !html.contains("href=\"http"),
            "{path} loads something from another host"
        );
    }
    let script = app.get("/docs/start.js").await.text().await.unwrap();
    assert!(script.contains("../openapi.json") && script.contains("validatorUrl: \"none\""), "{script}");
    assert_eq!(app.get("/docs/swagger-ui-bundle.js").await.status(), 200);
    assert_eq!(app.get("/docs/missing.js").await.status(), 404);
}

#[tokio::test]
async fn every_response_has_the_headers_that_protect_browsers() {
    let app = TestApp::start().await;
    for path in ["/", "/docs/", "/docs/swagger-ui.css", "/studio/missing", "/openapi.json", "/problems/not-found", "/x"]
    {
        let headers = app.get(path).await.headers().clone();
        assert_eq!(headers["x-content-type-options"], "nosniff", "{path}");
        let policy = headers["content-security-policy"].to_str().unwrap();
        assert!(
            policy.starts_with("default-src 'none'") || policy.starts_with("default-src 'self'"),
            "{path}: {policy}"
        );
        // The studio compiles WebAssembly. No page may create scripts from text.
        let policy = policy.replace("'wasm-unsafe-eval'", "");
        assert!(!policy.contains("unsafe") && policy.contains("frame-ancestors 'none'"), "{path}: {policy}");
    }
}

#[tokio::test]
async fn the_address_in_a_problem_type_explains_it() {
    let app = TestApp::start().await;
    let missing = app.get("/nowhere").await.json::<serde_json::Value>().await.unwrap();
    let text = app.get(missing["type"].as_str().unwrap()).await.text().await.unwrap();
    assert!(text.starts_with("404"), "{text}");
}
