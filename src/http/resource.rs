//! A path of the server with its handlers. A handler of the API is added together with its entry in the API document,
//! so that neither can exist without the other.

use crate::http::negotiate::accepted;
use crate::http::problem::Failure;
use crate::http::state::App;
use axum::Router;
use axum::extract::{Request, State};
use axum::handler::Handler;
use axum::middleware::{Next, from_fn_with_state};
use axum::response::{IntoResponse, Response};
use axum::routing::{MethodRouter, delete, get, post};
use serde_json::{Map, Value};
use std::sync::Arc;
use url::form_urlencoded;

/// Query parameters and media types that an operation accepts, by its entry in the API document.
#[derive(Debug)]
struct Accepts {
    /// Names of the query parameters.
    parameters: Vec<String>,
    /// Media types of the answers. Empty if the operation does not negotiate, or negotiates by itself because a
    /// parameter takes precedence over `Accept`.
    media_types: Vec<String>,
}

impl Accepts {
    fn of(entry: &Value) -> Self {
        let declared = entry["parameters"].as_array().into_iter().flatten().filter(|one| one["in"] == "query");
        let parameters: Vec<String> = declared.filter_map(|one| one["name"].as_str()).map(str::to_owned).collect();
        // Monitoring systems send any `Accept`, and read no body.
        let negotiates = entry["tags"][0] != "operation" && !parameters.iter().any(|name| name == "format");
        let answers = ["200", "202"].map(|status| entry["responses"][status]["content"].as_object());
        let media_types = answers.into_iter().flatten().flat_map(|content| content.keys().cloned());
        let media_types = if negotiates { media_types.collect() } else { Vec::new() };
        Self { parameters, media_types }
    }
}

/// Returns whether an operation with this entry refuses clients that accept none of its media types.
#[must_use]
pub fn negotiates(entry: &Value) -> bool {
    !Accepts::of(entry).media_types.is_empty()
}

/// Refuses query parameters that the operation does not have, and clients that accept none of its media types.
async fn check(State(accepts): State<Arc<Accepts>>, request: Request, next: Next) -> Response {
    let Accepts { parameters, media_types } = &*accepts;
    let query = request.uri().query().unwrap_or_default();
    let unknown =
        form_urlencoded::parse(query.as_bytes()).any(|(name, _)| !parameters.iter().any(|known| *known == name));
    if unknown {
        return Failure::unknown_parameter(parameters).into_response();
    }
    let offered: Vec<&str> = media_types.iter().map(String::as_str).collect();
    if !offered.is_empty() && accepted(request.headers(), &offered).is_none() {
        let detail = format!("the offered media types are: {}", offered.join(", "));
        return Failure::not_acceptable(detail).into_response();
    }
    next.run(request).await
}

/// A path, its handlers, and their entries in the API document if they belong to the API.
#[derive(Debug)]
pub struct Resource {
    pub path: &'static str,
    handlers: MethodRouter<App>,
    /// The path's item in the API document.
    item: Map<String, Value>,
}

impl Resource {
    /// Creates a resource at a path in the syntax of axum and OpenAPI: `/v1/jobs/{id}`.
    #[must_use]
    pub fn at(path: &'static str) -> Self {
        Self { path, handlers: MethodRouter::new(), item: Map::new() }
    }

    #[must_use]
    pub fn get<H: Handler<T, App>, T: 'static>(self, handler: H, entry: Value) -> Self {
        self.with("get", get(handler), Some(entry))
    }

    #[must_use]
    pub fn post<H: Handler<T, App>, T: 'static>(self, handler: H, entry: Value) -> Self {
        self.with("post", post(handler), Some(entry))
    }

    #[must_use]
    pub fn delete<H: Handler<T, App>, T: 'static>(self, handler: H, entry: Value) -> Self {
        self.with("delete", delete(handler), Some(entry))
    }

    /// Adds the handler of a GET that is not part of the API: of a page, of a file, or of another protocol.
    #[must_use]
    pub fn get_beside_api<H: Handler<T, App>, T: 'static>(self, handler: H) -> Self {
        self.with("get", get(handler), None)
    }

    /// Adds the handler of another protocol's messages, which are not part of the API.
    #[cfg(any(feature = "hops", feature = "mcp"))]
    #[must_use]
    pub fn post_beside_api<H: Handler<T, App>, T: 'static>(self, handler: H) -> Self {
        self.with("post", post(handler), None)
    }

    fn with(mut self, method: &'static str, handler: MethodRouter<App>, entry: Option<Value>) -> Self {
        let handler = match &entry {
            Some(entry) => handler.route_layer(from_fn_with_state(Arc::new(Accepts::of(entry)), check)),
            None => handler,
        };
        self.handlers = self.handlers.merge(handler);
        self.item.extend(entry.map(|entry| (method.into(), entry)));
        self
    }

    /// Adds the handlers to a router.
    pub fn route(self, router: Router<App>) -> Router<App> {
        #[expect(clippy::disallowed_methods, reason = "the resource is the route's entry in the API document")]
        router.route(self.path, self.handlers)
    }

    /// Returns the path and its item in the API document. Returns `None` for a path that is no part of the API.
    #[must_use]
    pub fn documented(self) -> Option<(&'static str, Value)> {
        (!self.item.is_empty()).then_some((self.path, Value::Object(self.item)))
    }
}
