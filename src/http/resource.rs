//! A path of the server with its handlers and their entries in the API document, so that neither can exist without the
//! other.

use crate::http::state::App;
use axum::Router;
use axum::handler::Handler;
use axum::routing::{MethodRouter, delete, get, post};
use serde_json::{Map, Value};

/// A path, its handlers, and their entries in the API document.
#[derive(Debug)]
pub struct Resource {
    path: &'static str,
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
        self.with("get", get(handler), entry)
    }

    #[must_use]
    pub fn post<H: Handler<T, App>, T: 'static>(self, handler: H, entry: Value) -> Self {
        self.with("post", post(handler), entry)
    }

    #[must_use]
    pub fn delete<H: Handler<T, App>, T: 'static>(self, handler: H, entry: Value) -> Self {
        self.with("delete", delete(handler), entry)
    }

    fn with(mut self, method: &str, handler: MethodRouter<App>, entry: Value) -> Self {
        self.handlers = self.handlers.merge(handler);
        self.item.insert(method.into(), entry);
        self
    }

    /// Adds the handlers to a router.
    pub fn route(self, router: Router<App>) -> Router<App> {
        router.route(self.path, self.handlers)
    }

    /// Returns the path and its item in the API document.
    #[must_use]
    pub fn documented(self) -> (&'static str, Value) {
        (self.path, Value::Object(self.item))
    }
}
