//! The routes of the service and the checks in front of them.

use crate::http::problem::Failure;
use crate::http::resource::Resource;
#[cfg(feature = "hops")]
use crate::http::routes::hops;
#[cfg(feature = "mcp")]
use crate::http::routes::mcp;
#[cfg(feature = "studio")]
use crate::http::routes::studio;
use crate::http::routes::{batches, catalogue, docs, drawings, events, health, jobs, mesh, submit};
use crate::http::state::App;
use crate::http::{access, compress, observe};
use crate::jobs::Jobs;
use axum::Router;
use axum::extract::Request;
use axum::http::{HeaderName, HeaderValue, Method, Uri, header};
use axum::middleware;
use axum::response::Redirect;
use axum::routing::get;
use metrics_exporter_prometheus::PrometheusHandle;
use plateau_engine::kind::Kind;
use plateau_strict_json::explain::edit_distance;
use std::sync::{Arc, LazyLock};
use std::time::Duration;
use tower::util::MapRequest;
use tower_http::cors::{AllowOrigin, Any, CorsLayer};

/// Returns every path with its handlers, and the entries in the API document of those that belong
/// to the API: `/v1`, the health checks and the metrics. `with_metrics` adds `/metrics`.
#[must_use]
pub fn resources(with_metrics: bool) -> Vec<Resource> {
    let mut resources: Vec<Resource> = Kind::ALL.iter().copied().map(submit::resource).collect();
    resources.extend([
        Resource::at("/v1/jobs").get(jobs::list, jobs::list_entry()),
        Resource::at("/v1/jobs/{id}").get(jobs::get, jobs::get_entry()).delete(jobs::delete, jobs::delete_entry()),
        Resource::at("/v1/jobs/{id}/request").get(jobs::request, jobs::request_entry()),
        Resource::at("/v1/jobs/{id}/cancel").post(jobs::cancel, jobs::cancel_entry()),
        Resource::at("/v1/jobs/{id}/callbacks")
            .get(jobs::callbacks, jobs::callbacks_entry())
            .post(jobs::send_callback_again, jobs::send_callback_again_entry()),
        Resource::at("/v1/jobs/{id}/mesh").get(mesh::mesh, mesh::mesh_entry()),
        Resource::at("/v1/jobs/{id}/certificate").get(mesh::certificate, mesh::certificate_entry()),
        Resource::at("/v1/jobs/{id}/pattern").get(drawings::pattern, drawings::pattern_entry()),
        Resource::at("/v1/jobs/{id}/schedule").get(drawings::schedule, drawings::schedule_entry()),
        Resource::at("/v1/jobs/{id}/events").get(events::events, events::events_entry()),
        Resource::at("/v1/batches").post(batches::post, batches::post_entry()),
        Resource::at("/v1/batches/{id}")
            .get(batches::get, batches::get_entry())
            .delete(batches::delete, batches::delete_entry()),
        Resource::at("/v1/batches/{id}/cancel").post(batches::cancel, batches::cancel_entry()),
        Resource::at("/v1/batches/{id}/callbacks")
            .get(batches::callbacks, batches::callbacks_entry())
            .post(batches::send_callback_again, batches::send_callback_again_entry()),
        Resource::at("/v1/batches/{id}/meshes").get(batches::meshes, batches::meshes_entry()),
        Resource::at("/v1/objectives").get(catalogue::objectives, catalogue::objectives_entry()),
        Resource::at("/v1/limits").get(catalogue::limits, catalogue::limits_entry()),
        Resource::at("/v1/examples").get(catalogue::examples, catalogue::examples_entry()),
        Resource::at("/v1/examples/{name}").get(catalogue::example, catalogue::example_entry()),
        Resource::at("/health/live").get(health::live, health::live_entry()),
        Resource::at("/health/ready").get(health::ready, health::ready_entry()),
        Resource::at("/openapi.json").get_beside_api(catalogue::openapi),
        Resource::at("/problems").get(catalogue::problems, catalogue::problems_entry()),
        Resource::at("/problems/{name}").get_beside_api(catalogue::problem_kind),
        Resource::at("/docs").get_beside_api(docs::redirect),
        Resource::at("/docs/").get_beside_api(docs::page),
        Resource::at("/docs/{file}").get_beside_api(docs::file),
    ]);
    #[cfg(feature = "mcp")]
    resources.push(Resource::at("/mcp").post_beside_api(mcp::post));
    #[cfg(feature = "hops")]
    resources.extend([
        Resource::at("/hops").get_beside_api(hops::list),
        Resource::at("/hops/").get_beside_api(hops::list),
        Resource::at("/hops/{name}").get_beside_api(hops::describe),
        Resource::at("/hops/{name}/").get_beside_api(hops::describe),
        Resource::at("/hops/solve").post_beside_api(hops::solve),
        // The message for a component whose address ends in a slash.
        Resource::at("/hops/{name}/solve").post_beside_api(hops::solve),
        Resource::at("/solve").post_beside_api(hops::solve),
    ]);
    #[cfg(feature = "studio")]
    resources.extend([
        Resource::at("/").get_beside_api(studio::page),
        Resource::at("/studio/{file}").get_beside_api(studio::file),
    ]);
    if with_metrics {
        resources.push(Resource::at("/metrics").get(health::metrics, health::metrics_entry()));
    }
    resources
}

/// Returns the service: every resource, behind the checks that apply to all of them.
pub fn router(app: App) -> Router {
    let own_metrics = !app.config.http.metrics_listen.is_empty();
    let origins = app.config.http.cors_origins.clone();
    let base: Arc<str> = app.config.http.public_base_path.as_str().into();
    let routes = resources(!own_metrics)
        .into_iter()
        .fold(Router::new(), |router, resource| resource.route(router))
        .fallback(async |request: Request| nothing_at(request.uri().path()))
        .method_not_allowed_fallback(async || Failure::method_not_allowed("the header Allow lists this path's methods"))
        // The last layer is the outermost. A request is first observed, and then its host is checked. Then CORS answers
        // preflights, which need no key. Then foreign pages are refused, and last the key is checked.
        .layer(middleware::from_fn_with_state(app.clone(), access::authenticate))
        .layer(middleware::from_fn_with_state(app.clone(), access::refuse_foreign_pages));
    let routes = if app.config.http.compression { compress::compressed(routes) } else { routes };
    // Without allowed origins there is no CORS layer, and OPTIONS is handled like any other method.
    let routes = if origins.is_empty() { routes } else { routes.layer(cors(&origins)) };
    let routes = routes
        .layer(middleware::from_fn_with_state(app.clone(), access::check_host))
        .layer(middleware::from_fn_with_state(base.clone(), observe::observe))
        .with_state(app);
    mount_below(&base, routes)
}

/// Returns the failure for a path without a resource. It names the path that was probably meant.
fn nothing_at(path: &str) -> Failure {
    const LISTED: &str = "GET /docs lists those of the API";
    /// Length of the longest path that is compared with the known ones, which are shorter than 30 characters.
    const LONGEST: usize = 60;
    static KNOWN: LazyLock<Vec<&str>> = LazyLock::new(|| {
        resources(true).into_iter().map(|resource| resource.path).filter(|path| !path.contains('{')).collect()
    });
    let given = path.trim_end_matches('/').to_ascii_lowercase().replace('_', "-");
    let known = KNOWN.iter().filter(|_| given.len() <= LONGEST);
    let nearest = known.map(|known| (edit_distance(&given, known), known)).min();
    Failure::not_found(match nearest {
        // People leave out the version, or write the kind in the singular.
        Some((steps, known)) if 4 * steps <= known.len() => {
            format!("no resource at this path; did you mean {known}? {LISTED}")
        }
        _ => format!("no resource at this path; {LISTED}"),
    })
}

/// Mounts the routes below the public base path too, for proxies that pass paths on unchanged.
fn mount_below(base: &Arc<str>, routes: Router) -> Router {
    if base.is_empty() {
        return routes;
    }
    // The studio and the API page name their files relative to a folder, so the base path needs a slash at its end.
    let folder = format!("{base}/");
    let base = base.clone();
    let stripped = MapRequest::new(routes, move |mut request: Request| {
        *request.uri_mut() = without_base(&base, request.uri());
        request
    });
    #[expect(clippy::disallowed_methods, reason = "a redirect is no part of the API")]
    Router::new().route(folder.trim_end_matches('/'), get(Redirect::permanent(&folder))).fallback_service(stripped)
}

/// Returns the URI without the base path, if the URI has it.
fn without_base(base: &str, uri: &Uri) -> Uri {
    let rest = uri.path_and_query().and_then(|path| path.as_str().strip_prefix(base));
    let Some(rest) = rest.filter(|rest| rest.starts_with('/')) else { return uri.clone() };
    let mut parts = uri.clone().into_parts();
    parts.path_and_query = rest.parse().ok();
    Uri::from_parts(parts).unwrap_or_else(|_| uri.clone())
}

/// Returns the routes of the separate listener for metrics.
pub fn metrics(jobs: Jobs, handle: PrometheusHandle) -> Router {
    let render = move || async move { health::render(&jobs, &handle).await };
    #[expect(clippy::disallowed_methods, reason = "this listener has no API document")]
    Router::new().route("/metrics", get(render)).layer(middleware::from_fn_with_state(Arc::from(""), observe::observe))
}

/// Allows pages of the configured origins everything that other clients may do.
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
            HeaderName::from_static("traceparent"),
            HeaderName::from_static("tracestate"),
            observe::REQUEST_ID,
        ])
        .expose_headers([
            header::CONTENT_DISPOSITION,
            header::CONTENT_RANGE,
            header::LOCATION,
            header::LINK,
            header::RETRY_AFTER,
            header::ETAG,
            access::RATE_LIMIT,
            access::RATE_LIMIT_POLICY,
            submit::PREFERENCE_APPLIED,
            observe::REQUEST_ID,
        ])
        .max_age(Duration::from_secs(3600))
}

#[cfg(test)]
mod tests {
    use super::*;

    /// The pages, their files, and the paths of Hops and other protocols are not part of the API.
    #[test]
    fn the_api_document_has_exactly_the_api() {
        for resource in resources(true) {
            let path = resource.path;
            let of_api =
                path.starts_with("/v1/") || path.starts_with("/health/") || ["/metrics", "/problems"].contains(&path);
            assert_eq!(resource.documented().is_some(), of_api, "{path}");
        }
    }

    #[test]
    fn only_whole_segments_of_the_base_path_are_removed() {
        let stripped = |uri: &str| without_base("/plateau", &uri.parse().unwrap()).to_string();
        assert_eq!(stripped("/plateau/v1/jobs?limit=1"), "/v1/jobs?limit=1");
        assert_eq!(stripped("/plateau/"), "/");
        assert_eq!(stripped("http://host/plateau/v1/jobs"), "http://host/v1/jobs");
        for other in ["/v1/jobs", "/plateaux/v1", "/", "/a/plateau/b"] {
            assert_eq!(stripped(other), other);
        }
    }
}
