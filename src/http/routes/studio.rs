//! `GET /`: the studio.

use axum::http::header;
use axum::response::{IntoResponse, Response};

pub async fn page() -> Response {
    ([(header::CONTENT_TYPE, "text/html; charset=utf-8")], include_str!("../../../web/index.html")).into_response()
}
