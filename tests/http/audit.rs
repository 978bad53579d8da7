//! The audit of results before they are stored: if the stated figures are not those of the mesh, the job fails, and the
//! failure is logged and counted.
//!
//! The kind `enlargement`, which only builds for tests have, states a wrong area if the request asks for it.

use crate::app::TestApp;
use crate::sources::{ENLARGEMENTS, enlargement};
use serde_json::{Value, json};

#[tokio::test]
async fn a_figure_that_is_not_that_of_the_mesh_fails_the_job_and_is_counted() {
    let app = TestApp::start().await;
    let contour = |z: f64| json!([[0, 0, z], [2, 0, z], [2, 1, z], [0, 1, z]]);
    let stack = json!({ "directrices": [contour(0.0), contour(3.0)], "closed": true, "caps": "flat" });
    let stack = app.solve("/v1/ruled-surfaces", &stack).await;
    app.solve(ENLARGEMENTS, &enlargement(&stack, 2.0)).await;

    let mut wrong = enlargement(&stack, 2.0);
    wrong["stated_area_factor"] = json!(0.5);
    let posted: Value = app.post(ENLARGEMENTS, &wrong).await.json().await.expect("JSON");
    let job = app.ended(posted).await;
    assert_eq!((&job["status"], &job["statistics"]), (&"failed".into(), &Value::Null), "{job}");
    assert_eq!(job["error"]["type"], "/problems/audit-failed");
    let detail = job["error"]["detail"].as_str().expect("a detail");
    assert!(detail.contains("/area: stated 44"), "{detail}");
    assert!(detail.contains("measured 88"), "{detail}");
    assert!(job["links"]["mesh"].is_null(), "a withheld mesh has no link");
    let metrics = app.get("/metrics").await.text().await.expect("text");
    assert!(metrics.contains("\nplateau_audit_failures_total{kind=\"enlargement\"} 1\n"), "{metrics}");
}
