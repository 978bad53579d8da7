//! What handlers share.

use crate::auth::Keys;
use crate::config::Config;
use crate::jobs::Jobs;
use metrics_exporter_prometheus::PrometheusHandle;
use std::sync::Arc;
use tokio::sync::Semaphore;

/// The state that every handler may use; clones share it.
#[derive(Clone, Debug)]
pub struct App {
    pub config: Arc<Config>,
    pub jobs: Jobs,
    pub metrics: PrometheusHandle,
    /// The budget for request bodies in flight.
    pub bodies: Arc<Semaphore>,
    pub keys: Arc<Keys>,
    /// The API document, as a server below this base path serves it.
    pub document: Arc<str>,
}
