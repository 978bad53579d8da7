//! Every route on one screen.

use crate::app::App;
use crate::http::problem::Failure;
use crate::http::{auth, observe, routes};
use crate::jobs::Jobs;
use crate::wire::Kind;
use axum::Router;
use axum::http::{HeaderName, HeaderValue, Method, Uri, header};
use axum::middleware;
use axum::routing::{get, post};
use metrics_exporter_prometheus::PrometheusHandle;
use std::time::Duration;
use tower_http::cors::{AllowOrigin, Any, CorsLayer};

pub fn router(app: App) -> Router {
    let own_metrics = !app.config.http.metrics_listen.is_empty();
    let origins = app.config.http.cors_origins.clone();
    let routes = Router::new()
        .route(Kind::RuledSurface.path(), post(routes::submit::ruled_surface))
        .route(Kind::MinimalSurface.path(), post(routes::submit::minimal_surface))
        .route(Kind::UniformMesh.path(), post(routes::submit::uniform_mesh))
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
        .route("/", get(routes::studio::page))
        .merge(if own_metrics { Router::new() } else { Router::new().route("/metrics", get(routes::health::metrics)) })
        .route("/studio/{file}", get(routes::studio::file))
        .fallback(|uri: Uri| async move {
            Failure::not_found(format!("no resource at this path ({} bytes long)", uri.path().len()))
        })
        .method_not_allowed_fallback(|| async { Failure::method_not_allowed("see the Allow header") })
        // Outermost last: observed, then checked for its host, then CORS (whose preflight needs no key), then for its key.
        .layer(middleware::from_fn_with_state(app.clone(), auth::authenticate));
    // Without origins there is no CORS, and OPTIONS is a method like any other.
    let routes = if origins.is_empty() { routes } else { routes.layer(cors(&origins)) };
    routes
        .layer(middleware::from_fn_with_state(app.clone(), auth::check_host))
        .layer(middleware::from_fn(observe::observe))
        .with_state(app)
}

/// The listener of metrics alone.
pub fn metrics(jobs: Jobs, handle: PrometheusHandle) -> Router {
    let render = move || async move { routes::health::render(&jobs, &handle).await };
    Router::new().route("/metrics", get(render)).layer(middleware::from_fn(observe::observe))
}

/// What pages of other origins may do: everything a client may, if the operator named their origin.
fn cors(origins: &[String]) -> CorsLayer {
    let layer = CorsLayer::new();
    let layer = if origins.iter().any(|origin| origin == "*") {
        layer.allow_origin(Any)
    } else {
        layer.allow_origin(AllowOrigin::list(origins.iter().filter_map(|origin| HeaderValue::from_str(origin).ok())))
    };
    layer
        .allow_methods([Method::GET, Method::POST, Method::DELETE])
        .allow_headers([
            header::ACCEPT,
            header::AUTHORIZATION,
            header::CONTENT_TYPE,
            header::IF_NONE_MATCH,
            header::RANGE,
            HeaderName::from_static("idempotency-key"),
            HeaderName::from_static("last-event-id"),
            HeaderName::from_static("prefer"),
            observe::REQUEST_ID,
        ])
        .expose_headers([
            header::LOCATION,
            header::RETRY_AFTER,
            header::ETAG,
            routes::submit::PREFERENCE_APPLIED,
            observe::REQUEST_ID,
        ])
        .max_age(Duration::from_secs(3600))
}
