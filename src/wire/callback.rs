//! `GET /v1/jobs/{id}/callbacks` and `GET /v1/batches/{id}/callbacks`: what became of the message to a callback URL.

use schemars::JsonSchema;
use serde::Serialize;

/// Message to the callback URL of a job or batch.
#[derive(Clone, Debug, Serialize, JsonSchema)]
pub struct Callbacks {
    /// Null if the request named no URL.
    pub callback_url: Option<String>,
    /// True until the message has been delivered or given up.
    pub pending: bool,
    /// Time of the next attempt (RFC 3339, UTC). Null if it is not known yet or if there is none.
    pub next_attempt_at: Option<String>,
    /// Attempts so far, oldest first.
    pub deliveries: Vec<Delivery>,
}

/// An attempt to deliver a message.
#[derive(Clone, Debug, Serialize, JsonSchema)]
pub struct Delivery {
    /// Number of the attempt, counted from 1.
    pub attempt: u64,
    /// Time at which the attempt ended (RFC 3339, UTC).
    pub at: String,
    pub outcome: Outcome,
}

/// How an attempt ended: `delivered` if the receiver answered 2xx, `unwanted` if it answered 410, `failed` if the
/// attempt will be repeated, and `given_up` if it was the last.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Serialize, JsonSchema)]
#[serde(rename_all = "snake_case")]
#[schemars(rename = "DeliveryOutcome")]
pub enum Outcome {
    Delivered,
    Unwanted,
    Failed,
    GivenUp,
}
