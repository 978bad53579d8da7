//! `GET /` and `GET /studio/{file}`: the studio, embedded in the program.
//!
//! The files come from `web/dist`, which `npm run build` in `web/` makes from the sources beside it. They are
//! committed, so that cargo alone builds the service, and a test builds them again and compares the bytes. Nothing is
//! loaded from another host. The files name each other and the API relative to the page, so a proxy may put the service
//! below a path.

use crate::http::negotiate::{entity_tag, none_match_hits};
use crate::http::problem::Failure;
use axum::extract::Path;
use axum::http::{HeaderMap, HeaderName, StatusCode, header};
use axum::response::{IntoResponse, Response};

const HTML: &str = "text/html; charset=utf-8";

/// Start of the Content-Security-Policy. It allows only this service's own files and data, and images that the page
/// holds in memory for downloads.
const POLICY: &str = "default-src 'self'; img-src 'self' blob:; object-src 'none'; base-uri 'none'; form-action 'none'; frame-ancestors ";

/// Page that other sites may show in a frame. This is safe because the page only displays and changes nothing.
const EMBEDDED: &str = "embed.html";

macro_rules! assets {
    ($($name:literal: $media_type:expr),* $(,)?) => {
        &[$(($name, $media_type, include_bytes!(concat!("../../../web/dist/", $name)))),*]
    };
}

/// Embedded files, as `(file of web/dist/, media type, bytes)`.
const ASSETS: &[(&str, &str, &[u8])] = assets! {
    "index.html": HTML,
    "embed.html": HTML,
    "studio.js": "text/javascript; charset=utf-8",
    "studio.css": "text/css; charset=utf-8",
    "icon.svg": "image/svg+xml",
    "inter.woff2": "font/woff2",
    "licences.txt": "text/plain; charset=utf-8",
    "thumbnails.webp": "image/webp",
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
    let policy = format!("{POLICY}{}", if name == EMBEDDED { "*" } else { "'none'" });
    let fields = [
        (header::CONTENT_TYPE, media_type.to_owned()),
        (header::ETAG, tag),
        // A new version of the program has new files under the same names, so browsers must revalidate each time.
        (header::CACHE_CONTROL, "no-cache".to_owned()),
        (header::CONTENT_SECURITY_POLICY, policy),
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
        let folder = concat!(env!("CARGO_MANIFEST_DIR"), "/web/dist");
        let mut files: Vec<String> =
            std::fs::read_dir(folder).unwrap().map(|entry| entry.unwrap().file_name().into_string().unwrap()).collect();
        files.sort();
        let mut embedded: Vec<&str> = ASSETS.iter().map(|(name, ..)| *name).collect();
        embedded.sort_unstable();
        assert_eq!(files, embedded);
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
