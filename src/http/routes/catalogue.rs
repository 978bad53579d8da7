//! What this server offers: objectives, limits, examples, the API document and its page.

use crate::app::App;
use crate::http::openapi;
use crate::http::problem::Failure;
use crate::wire::objectives::{self, Example, ExampleList, Limits, ObjectiveList};
use axum::Json;
use axum::extract::{Path, State};
use axum::http::header;
use axum::response::{IntoResponse, Redirect, Response};
use std::sync::{Arc, LazyLock};
use utoipa_swagger_ui::Config as SwaggerConfig;

pub async fn objectives() -> Json<ObjectiveList> {
    Json(objectives::objectives())
}

pub async fn limits(State(app): State<App>) -> Json<Limits> {
    Json(Limits::of(&app.config))
}

pub async fn examples() -> Json<ExampleList> {
    Json(objectives::example_list())
}

pub async fn example(Path(name): Path<String>) -> Result<Json<&'static Example>, Failure> {
    let found = objectives::examples().iter().find(|example| example.name == name);
    found.map(Json).ok_or_else(|| Failure::not_found("no example of this name; see GET /v1/examples"))
}

pub async fn openapi(State(app): State<App>) -> Response {
    let text = openapi::served_at(&app.config.http.public_base_path);
    ([(header::CONTENT_TYPE, "application/json")], text).into_response()
}

/// The page's files are named relative to it, so it lives one level down.
pub async fn docs() -> Redirect {
    Redirect::to("docs/")
}

pub async fn docs_file(Path(file): Path<String>) -> Result<Response, Failure> {
    docs_asset(&file)
}

pub async fn docs_index() -> Result<Response, Failure> {
    docs_asset("index.html")
}

fn docs_asset(file: &str) -> Result<Response, Failure> {
    static CONFIG: LazyLock<Arc<SwaggerConfig<'static>>> =
        // The validator badge would call home.
        LazyLock::new(|| {
            Arc::new(SwaggerConfig::from("../openapi.json").validator_url("none").try_it_out_enabled(true))
        });
    match utoipa_swagger_ui::serve(file, CONFIG.clone()) {
        Ok(Some(asset)) => Ok(([(header::CONTENT_TYPE, asset.content_type)], asset.bytes.into_owned()).into_response()),
        Ok(None) => Err(Failure::not_found("the API page has no such file")),
        Err(error) => Err(Failure::internal(error.to_string())),
    }
}

/// What a problem document's `type` points to.
pub async fn problem_kind(Path(name): Path<String>) -> Result<String, Failure> {
    let path = format!("/problems/{name}");
    let kinds = Failure::KINDS.iter().filter(|(_, kind, _)| *kind == path);
    let text: String = kinds.map(|(status, _, title)| format!("{status} {title}\n")).collect();
    if text.is_empty() { Err(Failure::not_found("no such kind of problem")) } else { Ok(text) }
}
