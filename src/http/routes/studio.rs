//! `GET /` and `GET /studio/{file}`: the studio, embedded in the program.
//!
//! The files come from `web/dist`, which `npm run build` in `web/` makes from the sources beside it. They are
//! committed, so that cargo alone builds the service, and a test builds them again and compares the bytes. The
//! WebAssembly modules come from `crates/page/js`, where `scripts/build-page` writes them. Nothing is loaded from
//! another host. The files name each other and the API relative to the page, so a proxy may put the service below a
//! path.

use crate::http::negotiate::{entity_tag, none_match_hits};
use crate::http::problem::Failure;
use crate::http::state::App;
use axum::extract::{Path, State};
use axum::http::{HeaderMap, HeaderName, StatusCode, header};
use axum::response::{IntoResponse, Response};

const HTML: &str = "text/html; charset=utf-8";
const SCRIPT: &str = "text/javascript; charset=utf-8";

/// Start of the Content-Security-Policy. It allows only this service's own files and data, images that the page holds
/// in memory for downloads, and the compilation of WebAssembly, which comes from the service's own files like all
/// scripts.
const POLICY: &str = "default-src 'self'; script-src 'self' 'wasm-unsafe-eval'; img-src 'self' blob:; \
    object-src 'none'; base-uri 'none'; form-action 'none'; frame-ancestors ";

/// Page that other sites may show in a frame. This is safe because the page only displays and changes nothing.
const EMBEDDED: &str = "embed.html";

macro_rules! assets {
    ($folder:literal, $($name:literal: $media_type:expr),* $(,)?) => {
        &[$(($name, $media_type, include_bytes!(concat!("../../../", $folder, "/", $name)))),*]
    };
}

/// Embedded files of `web/dist`, as `(name, media type, bytes)`.
const ASSETS: &[(&str, &str, &[u8])] = assets! {
    "web/dist",
    "index.html": HTML,
    "embed.html": HTML,
    "studio.js": SCRIPT,
    "chunk.js": SCRIPT,
    "later.js": SCRIPT,
    "worker.js": SCRIPT,
    "studio.css": "text/css; charset=utf-8",
    "icon.svg": "image/svg+xml",
    "inter.woff2": "font/woff2",
    "licences.txt": "text/plain; charset=utf-8",
    "thumbnails.webp": "image/webp",
};

/// WebAssembly modules of the solvers that run in the page. `shapes.wasm` has the solvers of films, strips and
/// lattices, and `structures.wasm` those of tensile structures and cable nets.
const MODULES: &[(&str, &str, &[u8])] = assets! {
    "crates/page/js",
    "shapes.wasm": "application/wasm",
    "structures.wasm": "application/wasm",
};

pub async fn page(State(app): State<App>, headers: HeaderMap) -> Result<Response, Failure> {
    asset(&app, "index.html", &headers)
}

pub async fn file(State(app): State<App>, Path(name): Path<String>, headers: HeaderMap) -> Result<Response, Failure> {
    asset(&app, &name, &headers)
}

fn asset(app: &App, name: &str, headers: &HeaderMap) -> Result<Response, Failure> {
    if !app.config.http.studio {
        return Err(Failure::not_found(
            "the studio is off on this server; the setting http.studio turns it on. GET /docs describes the API",
        ));
    }
    let found = ASSETS.iter().chain(MODULES).find(|(file, ..)| *file == name);
    let &(_, media_type, bytes) = found.ok_or_else(|| Failure::not_found("the studio has no such file"))?;
    let tag = entity_tag(bytes);
    let unchanged = none_match_hits(headers, &tag);
    let policy = format!("{POLICY}{}", if name == EMBEDDED { "*" } else { "'none'" });
    let fields = [
        (header::CONTENT_TYPE, media_type.to_owned()),
        (header::ETAG, tag),
        // A new version of the program has new files under the same names, so browsers must revalidate each time.
        (header::CACHE_CONTROL, "no-cache".to_owned()),
        (header::CONTENT_SECURITY_POLICY, policy),
        (header::X_CONTENT_TYPE_OPTIONS, "nosniff".to_owned()),
        (HeaderName::from_static("referrer-policy"), "no-referrer".to_owned()),
        // These two headers isolate the page, so that it may share memory with the worker of its solvers. A cancel then
        // ends a solver without ending the worker.
        (HeaderName::from_static("cross-origin-opener-policy"), "same-origin".to_owned()),
        (HeaderName::from_static("cross-origin-embedder-policy"), "require-corp".to_owned()),
    ];
    Ok(if unchanged { (StatusCode::NOT_MODIFIED, fields).into_response() } else { (fields, bytes).into_response() })
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn every_file_of_the_folder_is_embedded() {
        let folder = concat!(env!("CARGO_MANIFEST_DIR"), "/web/dist");
        let mut files: Vec<String> =
            std::fs::read_dir(folder).unwrap().map(|entry| entry.unwrap().file_name().into_string().unwrap()).collect();
        files.sort();
        let mut embedded: Vec<&str> = ASSETS.iter().map(|(name, ..)| *name).collect();
        embedded.sort_unstable();
        assert_eq!(files, embedded);
    }

    #[test]
    fn every_module_of_the_package_is_embedded() {
        let folder = concat!(env!("CARGO_MANIFEST_DIR"), "/crates/page/js");
        let names = std::fs::read_dir(folder).unwrap().map(|entry| entry.unwrap().file_name().into_string().unwrap());
        let mut modules: Vec<String> = names.filter(|name| name.ends_with(".wasm")).collect();
        modules.sort();
        let embedded: Vec<&str> = MODULES.iter().map(|(name, ..)| *name).collect();
        assert_eq!(modules, embedded);
    }

    /// Checks that the pages work offline. Names of XML namespaces and addresses in prose are not loaded.
    #[test]
    fn no_page_and_no_style_loads_from_another_host() {
        for (name, media_type, bytes) in ASSETS {
            if !media_type.starts_with("text/html") && !media_type.starts_with("text/css") {
                continue;
            }
            let text = std::str::from_utf8(bytes).unwrap();
            for start in ["src=\"http", "href=\"http", "src=\"//", "href=\"//", "url(http", "url(//", "@import"] {
                assert!(!text.contains(start), "{name} has {start}");
            }
        }
    }
}
