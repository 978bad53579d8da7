//! State that the handlers share.

use crate::auth::Keys;
use crate::config::Config;
use crate::http::budget::Budget;
use crate::http::open_requests::OpenRequests;
use crate::jobs::Jobs;
use metrics_exporter_prometheus::PrometheusHandle;
use std::sync::Arc;

/// State that every handler may use. Clones share it.
#[derive(Clone, Debug)]
pub struct App {
    pub config: Arc<Config>,
    pub jobs: Jobs,
    pub metrics: PrometheusHandle,
    /// Budget for request bodies that are being read.
    pub bodies: Arc<Budget>,
    /// Limits of the requests that each client has open.
    pub seats: Arc<OpenRequests>,
    pub keys: Arc<Keys>,
    /// Returns the API document as a server below a base path serves it. The document is made at the first call,
    /// because making its schemas takes longer than everything else at the start of the process.
    pub document: fn(&str) -> String,
}
