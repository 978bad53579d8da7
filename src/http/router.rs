//! Every route on one screen.

use crate::app::App;
use crate::http::problem::Failure;
use crate::http::{auth, observe, routes};
use crate::jobs::Jobs;
use crate::wire::Kind;
use axum::Router;
use axum::extract::Request;
use axum::http::{HeaderName, HeaderValue, Method, Uri, header};
use axum::middleware;
use axum::response::Redirect;
use axum::routing::{get, post};
use metrics_exporter_prometheus::PrometheusHandle;
use std::sync::Arc;
use std::time::Duration;
use tower::util::MapRequest;
use tower_http::cors::{AllowOrigin, Any, CorsLayer};

pub fn router(app: App) -> Router {
    let own_metrics = !app.config.http.metrics_listen.is_empty();
    let origins = app.config.http.cors_origins.clone();
    let base: Arc<str> = app.config.http.public_base_path.as_str().into();
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
        .route("/v1/batches", post(routes::batches::submit))
        .route("/v1/batches/{id}", get(routes::batches::get).delete(routes::batches::delete))
        .route("/v1/batches/{id}/cancel", post(routes::batches::cancel))
        .route("/v1/batches/{id}/meshes", get(routes::batches::meshes))
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
    let routes = routes
        .layer(middleware::from_fn_with_state(app.clone(), auth::check_host))
        .layer(middleware::from_fn_with_state(base.clone(), observe::observe))
        .with_state(app);
    below(&base, routes)
}

/// The same routes below the public base path, for proxies that pass paths on as they are.
fn below(base: &Arc<str>, routes: Router) -> Router {
    if base.is_empty() {
        return routes;
    }
    // The studio's and the API page's files are named relative to a folder.
    let folder = format!("{base}/");
    let base = base.clone();
    let stripped = MapRequest::new(routes, move |mut request: Request| {
        *request.uri_mut() = without_base(&base, request.uri());
        request
    });
    Router::new().route(folder.trim_end_matches('/'), get(Redirect::permanent(&folder))).fallback_service(stripped)
}

/// The URI without the base path, if it has it.
fn without_base(base: &str, uri: &Uri) -> Uri {
    let rest = uri.path_and_query().and_then(|path| path.as_str().strip_prefix(base));
    let Some(rest) = rest.filter(|rest| rest.starts_with('/')) else { return uri.clone() };
    let mut parts = uri.clone().into_parts();
    parts.path_and_query = rest.parse().ok();
    Uri::from_parts(parts).unwrap_or_else(|_| uri.clone())
}

/// The listener of metrics alone.
pub fn metrics(jobs: Jobs, handle: PrometheusHandle) -> Router {
    let render = move || async move { routes::health::render(&jobs, &handle).await };
    Router::new().route("/metrics", get(render)).layer(middleware::from_fn_with_state(Arc::from(""), observe::observe))
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

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn only_whole_segments_are_taken_off() {
        let stripped = |uri: &str| without_base("/plateau", &uri.parse().unwrap()).to_string();
        assert_eq!(stripped("/plateau/v1/jobs?limit=1"), "/v1/jobs?limit=1");
        assert_eq!(stripped("/plateau/"), "/");
        assert_eq!(stripped("http://host/plateau/v1/jobs"), "http://host/v1/jobs");
        for other in ["/v1/jobs", "/plateaux/v1", "/", "/a/plateau/b"] {
            assert_eq!(stripped(other), other);
        }
    }
}
