//! Every route on one screen.

use crate::app::App;
use crate::http::problem::Failure;
use crate::http::{observe, routes};
use crate::wire::Kind;
use axum::Router;
use axum::http::Uri;
use axum::middleware;
use axum::routing::{get, post};

pub fn router(app: App) -> Router {
    Router::new()
        .route(Kind::RuledSurface.path(), post(routes::submit::ruled_surface))
        .route(Kind::MinimalSurface.path(), post(routes::submit::minimal_surface))
        .route("/v1/jobs", get(routes::jobs::list))
        .route("/v1/jobs/{id}", get(routes::jobs::get).delete(routes::jobs::delete))
        .route("/v1/jobs/{id}/cancel", post(routes::jobs::cancel))
        .route("/v1/jobs/{id}/mesh", get(routes::mesh::mesh))
        .route("/v1/jobs/{id}/pattern", get(routes::mesh::pattern))
        .route("/v1/jobs/{id}/events", get(routes::jobs::events))
        .route("/v1/objectives", get(routes::catalogue::objectives))
        .route("/v1/limits", get(routes::catalogue::limits))
        .route("/v1/examples", get(routes::catalogue::examples))
        .route("/v1/examples/{name}", get(routes::catalogue::example))
        .route("/openapi.json", get(routes::catalogue::openapi))
        .route("/docs", get(routes::catalogue::docs))
        .route("/docs/", get(routes::catalogue::docs_index))
        .route("/docs/{*file}", get(routes::catalogue::docs_file))
        .route("/problems/{name}", get(routes::catalogue::problem_kind))
        .route("/health/live", get(routes::health::live))
        .route("/health/ready", get(routes::health::ready))
        .route("/metrics", get(routes::health::metrics))
        .route("/", get(routes::studio::page))
        .route("/studio/{file}", get(routes::studio::file))
        .fallback(|uri: Uri| async move {
            Failure::not_found(format!("no resource at this path ({} bytes long)", uri.path().len()))
        })
        .method_not_allowed_fallback(|| async { Failure::method_not_allowed("see the Allow header") })
        .layer(middleware::from_fn(observe::observe))
        .with_state(app)
}
