//! A path of the server with its handlers. A handler of the API is added together with its entry in the API document,
//! so that neither can exist without the other.

use crate::http::state::App;
use axum::Router;
use axum::handler::Handler;
use axum::routing::{MethodRouter, delete, get, post};
use serde_json::{Map, Value};

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
