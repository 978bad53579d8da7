//! Two axum handlers with which the load benchmark compares the service. `/bare` parses the same body and answers bytes
//! of the same length. `/solve` also solves the request. Both neither queue nor store anything.
//!
//! Usage: bare_handler ADDRESS:PORT ANSWER-FILE

#![allow(clippy::disallowed_methods, reason = "this router has no API document")]

use axum::Router;
use axum::body::Bytes;
use axum::extract::State;
use axum::http::header;
use axum::response::IntoResponse;
use axum::routing::post;
use plateau::config::LimitsConfig;
use plateau::wire::incoming::Incoming;
use plateau_engine::kinds::ruled_surface;
use plateau_engine::solved::Signal;
use plateau_engine::source::no_jobs;
use std::error::Error;

/// Answer to every request: a finished job in the form that the service returns.
type Answer = Bytes;

async fn bare(State(answer): State<Answer>, body: Bytes) -> impl IntoResponse {
    let _: serde_json::Value = serde_json::from_slice(&body).expect("the benchmark posts JSON");
    ([(header::CONTENT_TYPE, "application/json")], answer)
}

async fn solved(State(answer): State<Answer>, body: Bytes) -> impl IntoResponse {
    let limits = LimitsConfig::default();
    let incoming =
        Incoming::read(ruled_surface::KIND, &body, &no_jobs, &limits).expect("the benchmark posts good requests");
    let solving = tokio::task::spawn_blocking(move || incoming.request.solve(&|| Signal::Continue, &|_| {}));
    let solved = solving.await.expect("no panic").expect("a result");
    assert!(solved.archive.to_bytes().is_ok_and(|bytes| !bytes.is_empty()));
    ([(header::CONTENT_TYPE, "application/json")], answer)
}

#[tokio::main]
async fn main() -> Result<(), Box<dyn Error>> {
    let arguments: Vec<String> = std::env::args().skip(1).collect();
    let [address, file] = &arguments[..] else { return Err("usage: bare_handler ADDRESS:PORT ANSWER-FILE".into()) };
    let answer: Answer = std::fs::read(file)?.into();
    let routes = Router::new().route("/bare", post(bare)).route("/solve", post(solved)).with_state(answer);
    let listener = tokio::net::TcpListener::bind(address).await?;
    axum::serve(listener, routes).await?;
    Ok(())
}
