//! Compresses long answers with gzip for clients that accept it.

use axum::Router;
use axum::body::Body;
use axum::http::{Extensions, HeaderMap, HeaderValue, Response, StatusCode, Version, header};
use tower::util::MapResponseLayer;
use tower_http::CompressionLevel;
use tower_http::compression::CompressionLayer;
use tower_http::compression::predicate::{Predicate, SizeAbove};

/// Smallest length in bytes of an answer that is compressed. A shorter answer takes a few packets either way, and
/// compressing it takes longer than sending it.
const LEAST_BYTES: u64 = 8192;

/// Media types that are compressed. Event streams are left out, because each event is sent at once. Pictures, fonts and
/// ZIP files are left out, because they are compressed already.
const COMPRESSED: [&str; 13] = [
    "application/json",
    "application/problem+json",
    "application/vnd.plateau.mesh+json",
    "application/x-ply",
    "application/octet-stream",
    "application/wasm",
    "image/svg+xml",
    "image/vnd.dxf",
    "model/gltf+json",
    "model/gltf-binary",
    "model/obj",
    "model/stl",
    "text/",
];

/// Compresses the answers of these routes.
pub fn compressed<S: Clone + Send + Sync + 'static>(routes: Router<S>) -> Router<S> {
    let layer = CompressionLayer::new().quality(CompressionLevel::Fastest);
    let worthwhile = SizeAbove::new(LEAST_BYTES)
        .and(|_: StatusCode, _: Version, headers: &HeaderMap, _: &Extensions| is_compressed(headers));
    routes.layer(layer.compress_when(worthwhile)).layer(MapResponseLayer::new(weaken_tag))
}

fn is_compressed(headers: &HeaderMap) -> bool {
    let media_type = headers.get(header::CONTENT_TYPE).and_then(|value| value.to_str().ok()).unwrap_or_default();
    media_type != "text/event-stream" && COMPRESSED.iter().any(|known| media_type.starts_with(known))
}

/// Makes the entity tag of a compressed answer weak. A strong tag identifies exact bytes: with a strong tag, a client
/// that has a part of the compressed file could request the rest and get bytes of the uncompressed file.
fn weaken_tag(mut response: Response<Body>) -> Response<Body> {
    let headers = response.headers_mut();
    let tag = headers.get(header::ETAG).and_then(|tag| tag.to_str().ok()).filter(|tag| !tag.starts_with("W/"));
    let weak = tag.and_then(|tag| HeaderValue::from_str(&format!("W/{tag}")).ok());
    if let Some(weak) = weak.filter(|_| headers.contains_key(header::CONTENT_ENCODING)) {
        headers.insert(header::ETAG, weak);
    }
    response
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn meshes_texts_and_json_are_compressed_and_streams_and_pictures_are_not() {
        let of = |media_type: &str| {
            let value = HeaderValue::from_str(media_type).unwrap();
            is_compressed(&HeaderMap::from_iter([(header::CONTENT_TYPE, value)]))
        };
        for media_type in ["application/json", "model/stl", "text/html; charset=utf-8", "image/svg+xml"] {
            assert!(of(media_type), "{media_type}");
        }
        for media_type in ["text/event-stream", "application/zip", "image/png", "font/woff2", ""] {
            assert!(!of(media_type), "{media_type}");
        }
        assert!(!is_compressed(&HeaderMap::new()));
    }
}
