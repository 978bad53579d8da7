//! Descriptions of the operations, and an example of each JSON answer.
//!
//! The examples are answers of a server, in `examples.json` beside this file: an object of operations, each with an
//! object of statuses. `PLATEAU_WRITE=1 cargo test -p plateau --features s3,test-hooks --test http examples_of_its_answers`
//! writes it again.

use serde_json::Value;
use std::sync::LazyLock;

/// `(operationId, description)`. An operation whose entry has a description of its own is not listed.
const OPERATIONS: &[(&str, &str)] = &[
    ("getLive", "Needs no key. A container that does not answer should be restarted."),
    ("getReady", "Needs no key. A server that answers 503 should get no requests for the moment."),
    ("getMetrics", "Counters of this process and the length of the shared queue, in the format of Prometheus."),
    (
        "postBatch",
        "Each request names its `kind` and becomes a job of its own. If one of them is refused, none is accepted, and \
         the pointers of the errors begin with its place in `requests`.",
    ),
    ("getBatch", "With `Prefer: wait=N` the answer waits until every job has ended, at most N seconds."),
    ("deleteBatch", "The batch and its jobs are unknown afterwards."),
    ("getBatchCallbacks", "Shows the attempts to deliver the message, but not why the receiver refused it."),
    ("sendBatchCallbackAgain", "Sends the message even if it was delivered or given up before."),
    ("cancelBatch", "Jobs that have ended keep their results. Cancelling twice is the same as once."),
    (
        "getBatchMeshes",
        "Jobs without a mesh are left out. Jobs that have not ended are too, so wait for the batch first.",
    ),
    ("listExamples", "Each of them can be posted to the path of its kind as it is."),
    ("getExample", "`request` is the body to post to the path of its `kind`."),
    ("listJobs", "Lists the jobs of this key, page by page."),
    ("getJob", "With `Prefer: wait=N` the answer waits until the job has ended, at most N seconds."),
    ("deleteJob", "The job is unknown afterwards."),
    ("getJobCallbacks", "Shows the attempts to deliver the message, but not why the receiver refused it."),
    ("sendJobCallbackAgain", "Sends the message even if it was delivered or given up before."),
    (
        "cancelJob",
        "The job is cancelled at once, although its solver may need a moment to stop. Cancelling twice is the same as once.",
    ),
    (
        "getRequest",
        "The request can be posted again as it is. Members of the job, such as its label, are not part of it.",
    ),
    ("getSchedule", "Which parts a job has follows from its kind; 404 names them."),
    ("getCertificate", "A JSON document with the vector fields that prove the bound."),
    (
        "getEvents",
        "A client that reconnects with `Last-Event-ID` gets the changes of status that it missed and the latest progress.",
    ),
    (
        "getMesh",
        "Coordinates of OBJ, PLY, STL and JSON are in the request's unit and axes; glTF is in metres with y up.",
    ),
    ("getPattern", "Drawn true to scale in the request's unit, with cuts and folds on layers of their own."),
    ("getLimits", "Limits of this server, which its operator sets."),
    (
        "listObjectives",
        "Each objective has its formula, and the options that can act with it. A request with an option that does not \
         act is refused with 422.",
    ),
    ("listProblems", "The `type` of every problem document and of every failed job's `error`."),
];

/// Adds a description to an operation without one, and an example to each JSON answer without one.
pub fn complete(operation: &mut Value) {
    static EXAMPLES: LazyLock<Value> =
        LazyLock::new(|| serde_json::from_str(include_str!("examples.json")).unwrap_or_default());
    let id = operation["operationId"].as_str().unwrap_or_default().to_owned();
    if operation.get("description").is_none()
        && let Some((_, text)) = OPERATIONS.iter().find(|(name, _)| *name == id)
    {
        operation["description"] = (*text).into();
    }
    for (status, response) in operation["responses"].as_object_mut().into_iter().flatten() {
        let content = response.get_mut("content").and_then(|content| content.get_mut("application/json"));
        let example = EXAMPLES.get(&id).and_then(|of| of.get(status));
        if let (Some(content), Some(example)) = (content, example) {
            content["example"] = example.clone();
        }
    }
}
