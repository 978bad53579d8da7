//! `GET /docs/`: Swagger UI with this server's API document, embedded in the program so that it works offline.

use crate::http::assets::{self, Asset};
use crate::http::problem::Failure;
use axum::extract::Path;
use axum::http::HeaderMap;
use axum::response::{Redirect, Response};

/// Content-Security-Policy of the page, which loads only its own files and connects only to this server. Swagger UI's
/// style sheet has its icons in `data:` URLs.
const POLICY: &str = "default-src 'none'; script-src 'self'; style-src 'self'; img-src 'self' data:; \
    connect-src 'self'; base-uri 'none'; form-action 'none'; frame-ancestors 'none'";

macro_rules! assets {
    ($($name:literal: $media_type:literal),* $(,)?) => {
        &[$(Asset { name: $name, media_type: $media_type, bytes: include_bytes!(concat!("../docs/", $name)) }),*]
    };
}

const ASSETS: &[Asset] = assets! {
    "index.html": "text/html; charset=utf-8",
    "start.js": "text/javascript; charset=utf-8",
    "swagger-ui-bundle.js": "text/javascript; charset=utf-8",
    "swagger-ui.css": "text/css; charset=utf-8",
    "favicon-32x32.png": "image/png",
    "LICENSE": "text/plain; charset=utf-8",
    "NOTICE": "text/plain; charset=utf-8",
};

/// Redirects to the page with a slash at the end of its path, because the page names its files relative to its folder.
pub async fn redirect() -> Redirect {
    Redirect::to("docs/")
}

pub async fn page(headers: HeaderMap) -> Result<Response, Failure> {
    answer("index.html", &headers)
}

pub async fn file(Path(name): Path<String>, headers: HeaderMap) -> Result<Response, Failure> {
    answer(&name, &headers)
}

fn answer(name: &str, headers: &HeaderMap) -> Result<Response, Failure> {
    let found = ASSETS.iter().find(|asset| asset.name == name);
    let asset = found.ok_or_else(|| Failure::not_found("the API page has no such file"))?;
    Ok(assets::answer(asset, POLICY, headers))
}
