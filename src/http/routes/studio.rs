//! `GET /` and `GET /studio/{file}`: the studio, embedded into the binary.
//!
//! The page is written without a build step or a library: plain modules that the browser loads as they are, so that cargo
//! alone builds the service, what is reviewed is what is served, and nothing is fetched from anywhere else. Its files name
//! each other and the API relative to the page, so a proxy may put the service below a prefix.

use crate::http::negotiate::{entity_tag, none_match_hits};
use crate::http::problem::Failure;
use axum::extract::Path;
use axum::http::{HeaderMap, HeaderName, StatusCode, header};
use axum::response::{IntoResponse, Response};

const HTML: &str = "text/html; charset=utf-8";
const SCRIPT: &str = "text/javascript; charset=utf-8";

/// Only this service's own files and data; images may come from downloads that the page holds in memory.
const POLICY: &str = "default-src 'self'; img-src 'self' blob:; object-src 'none'; base-uri 'none'; form-action 'none'; frame-ancestors 'none'";

macro_rules! assets {
    ($($name:literal: $media_type:expr),* $(,)?) => {
        &[$(($name, $media_type, include_bytes!(concat!("../../../web/", $name)))),*]
    };
}

/// `(file of web/, media type, bytes)`.
const ASSETS: &[(&str, &str, &[u8])] = assets! {
    "index.html": HTML,
    "style.css": "text/css; charset=utf-8",
    "icon.svg": "image/svg+xml",
    "api.js": SCRIPT,
    "camera.js": SCRIPT,
    "dom.js": SCRIPT,
    "form.js": SCRIPT,
    "glb.js": SCRIPT,
    "handles.js": SCRIPT,
    "main.js": SCRIPT,
    "navigate.js": SCRIPT,
    "report.js": SCRIPT,
    "request.js": SCRIPT,
    "result.js": SCRIPT,
    "viewer.js": SCRIPT,
};

pub async fn page(headers: HeaderMap) -> Result<Response, Failure> {
    asset("index.html", &headers)
}

pub async fn file(Path(name): Path<String>, headers: HeaderMap) -> Result<Response, Failure> {
    asset(&name, &headers)
}

fn asset(name: &str, headers: &HeaderMap) -> Result<Response, Failure> {
    let found = ASSETS.iter().find(|(file, ..)| *file == name);
    let &(_, media_type, bytes) = found.ok_or_else(|| Failure::not_found("the studio has no such file"))?;
    let tag = entity_tag(bytes);
    let unchanged = none_match_hits(headers, &tag);
    let fields = [
        (header::CONTENT_TYPE, media_type.to_owned()),
        (header::ETAG, tag),
        // A new binary brings new files under the same names: ask each time, and mostly hear 304.
        (header::CACHE_CONTROL, "no-cache".to_owned()),
        (header::CONTENT_SECURITY_POLICY, POLICY.to_owned()),
        (header::X_CONTENT_TYPE_OPTIONS, "nosniff".to_owned()),
        (HeaderName::from_static("referrer-policy"), "no-referrer".to_owned()),
    ];
    Ok(if unchanged { (StatusCode::NOT_MODIFIED, fields).into_response() } else { (fields, bytes).into_response() })
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn every_file_of_the_folder_is_embedded() {
        let folder = concat!(env!("CARGO_MANIFEST_DIR"), "/web");
        let mut files: Vec<String> =
            std::fs::read_dir(folder).unwrap().map(|entry| entry.unwrap().file_name().into_string().unwrap()).collect();
        files.sort();
        let mut embedded: Vec<&str> = ASSETS.iter().map(|(name, ..)| *name).collect();
        embedded.sort_unstable();
        assert_eq!(files, embedded);
    }

    /// The page works offline: no file names another host (the SVG namespace is a name, not an address).
    #[test]
    fn no_file_names_another_host() {
        for (name, _, bytes) in ASSETS {
            let text = std::str::from_utf8(bytes).unwrap().replace("http://www.w3.org/2000/svg", "");
            assert!(!text.contains("http://") && !text.contains("https://") && !text.contains("\"//"), "{name}");
        }
    }
}
