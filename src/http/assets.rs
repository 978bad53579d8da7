//! Files that are embedded in the program and served to browsers: the pages and the files that they load.

use crate::http::negotiate::{entity_tag, none_match_hits};
use axum::body::Body;
use axum::http::{HeaderMap, HeaderName, HeaderValue, Response, StatusCode, header};
use axum::response::IntoResponse;

/// An embedded file.
#[derive(Debug)]
pub struct Asset {
    pub name: &'static str,
    pub media_type: &'static str,
    pub bytes: &'static [u8],
}

/// Answers with a file, or with 304 if the client already has it. `policy` is the page's Content-Security-Policy.
pub fn answer(asset: &Asset, policy: &'static str, headers: &HeaderMap) -> Response<Body> {
    let tag = entity_tag(asset.bytes);
    let unchanged = none_match_hits(headers, &tag);
    let fields = [
        (header::CONTENT_TYPE, asset.media_type.to_owned()),
        (header::ETAG, tag),
        // A new version of the program has new files under the same names, so browsers must revalidate each time.
        (header::CACHE_CONTROL, "no-cache".to_owned()),
        (header::CONTENT_SECURITY_POLICY, policy.to_owned()),
        (HeaderName::from_static("referrer-policy"), "no-referrer".to_owned()),
    ];
    if unchanged { (StatusCode::NOT_MODIFIED, fields).into_response() } else { (fields, asset.bytes).into_response() }
}

/// Content-Security-Policy of a response that is not a page: the browser may show it, but loads and runs nothing.
const NOT_A_PAGE: HeaderValue = HeaderValue::from_static("default-src 'none'; frame-ancestors 'none'");

/// Adds the headers that every response has. Browsers must not guess its type, and a response without its own policy
/// loads and runs nothing.
pub fn protect(headers: &mut HeaderMap) {
    headers.insert(header::X_CONTENT_TYPE_OPTIONS, HeaderValue::from_static("nosniff"));
    headers.entry(header::CONTENT_SECURITY_POLICY).or_insert(NOT_A_PAGE);
}
