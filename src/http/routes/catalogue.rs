//! The server's catalogue: objectives, limits, examples, the API document and the kinds of problems.

use crate::http::entry::{json_response, name_parameter, plain_get, reference, with_problems};
use crate::http::parameters::parameters;
use crate::http::problem::Failure;
use crate::http::state::App;
use crate::wire::job::failures;
use crate::wire::objectives::{self, Example, ExampleList, Limits, ObjectiveList};
use crate::wire::problems::{ProblemKind, ProblemList};
use axum::Json;
use axum::extract::{Path, RawQuery, State};
use axum::http::header;
use axum::response::{IntoResponse, Response};
use serde_json::{Value, json};
use std::fmt::Write;

pub async fn objectives() -> Json<ObjectiveList> {
    Json(objectives::objectives())
}

pub fn objectives_entry() -> Value {
    plain_get(
        "catalogue",
        "listObjectives",
        "Objectives that a request can choose",
        "application/json",
        &reference("ObjectiveList"),
    )
}

pub async fn limits(State(app): State<App>) -> Json<Limits> {
    Json(Limits::of(&app.config))
}

pub fn limits_entry() -> Value {
    plain_get(
        "catalogue",
        "getLimits",
        "Limits of this server for one request, for one key and for all keys",
        "application/json",
        &reference("Limits"),
    )
}

pub async fn examples() -> Json<ExampleList> {
    Json(objectives::example_list())
}

pub fn examples_entry() -> Value {
    plain_get(
        "catalogue",
        "listExamples",
        "Names and titles of the example requests",
        "application/json",
        &reference("ExampleList"),
    )
}

pub async fn example(Path(name): Path<String>) -> Result<Json<&'static Example>, Failure> {
    let found = objectives::examples().iter().find(|example| example.name == name);
    found.map(Json).ok_or_else(|| Failure::not_found("no example of this name; see GET /v1/examples"))
}

pub fn example_entry() -> Value {
    let names = objectives::example_names();
    json!({ "operationId": "getExample", "tags": ["catalogue"], "summary": "An example request",
        "parameters": [name_parameter("name", "Name of the example.", &names)],
        "responses": with_problems(json!({ "200": json_response("The request", "Example") }), &[("404", "NotFound")]) })
}

pub async fn openapi(State(app): State<App>, RawQuery(query): RawQuery) -> Result<Response, Failure> {
    parameters::<0>(query.as_deref(), [])?;
    let document = (app.document)(&app.config.http.public_base_path);
    Ok(([(header::CONTENT_TYPE, "application/json")], document).into_response())
}

/// Lists the kinds of problem documents and of failed jobs.
pub async fn problems() -> Json<ProblemList> {
    let kind = |name: &str| format!("/problems/{name}");
    let documents = Failure::KINDS.iter().map(|&(status, name, title)| ProblemKind {
        kind: kind(name),
        title: title.into(),
        status: Some(status),
    });
    let jobs = failures();
    let jobs = jobs.iter().map(|(name, title)| ProblemKind { kind: kind(name), title: (*title).into(), status: None });
    Json(ProblemList { problems: documents.chain(jobs).collect() })
}

pub fn problems_entry() -> Value {
    plain_get(
        "catalogue",
        "listProblems",
        "Kinds of problem documents and of failed jobs",
        "application/json",
        &reference("ProblemList"),
    )
}

/// Describes the `type` of a problem document or of a failed job's error.
pub async fn problem_kind(Path(name): Path<String>, RawQuery(query): RawQuery) -> Result<String, Failure> {
    parameters::<0>(query.as_deref(), [])?;
    let mut text = String::new();
    for (status, _, title) in Failure::KINDS.iter().filter(|(_, kind, _)| *kind == name) {
        // Writing to a string cannot fail.
        let _ = writeln!(text, "{status} {title}");
    }
    for (_, title) in failures().iter().filter(|(kind, _)| *kind == name) {
        let _ = writeln!(text, "failed job: {title}");
    }
    if text.is_empty() { Err(Failure::not_found("no such kind of problem")) } else { Ok(text) }
}
