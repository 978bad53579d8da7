//! `/v1/jobs/{id}/mesh` and `/certificate`: files made from the stored mesh, with entity tags and ranges.

use crate::http::access::Caller;
use crate::http::entry::{BYTES, id_parameter, query_parameter, reference, representation};
use crate::http::negotiate::{Part, accepted, none_match_hits, part};
use crate::http::parameters::{checked, parameters};
use crate::http::problem::Failure;
use crate::http::state::App;
use crate::jobs::JobsError;
use crate::jobs::files::File;
use axum::body::Body;
use axum::extract::{Path, RawQuery, State};
use axum::http::{HeaderMap, HeaderValue, StatusCode, header};
use axum::response::{IntoResponse, Response};
use plateau_archive::Archive;
use plateau_archive::formats::{Choices, Colors, MeshFormat, Origin, Quantity};
use serde_json::{Value, json};
use std::ops::Range;

pub async fn mesh(
    State(app): State<App>,
    caller: Caller,
    Path(id): Path<String>,
    RawQuery(query): RawQuery,
    headers: HeaderMap,
) -> Result<Response, Failure> {
    let id = &checked(&id)?;
    let names = ["format", "origin", "lines", "encoding", "colors", "range"];
    let [format, origin, lines, encoding, quantity, range] = parameters(query.as_deref(), names)?;
    let formats = MeshFormat::ALL.map(|format| (format.name(), format.media_type()));
    let (chosen, media_type) = choose(format, &headers, &formats)?;
    let format = MeshFormat::ALL[chosen];
    let choices = choices(format, origin.as_deref(), lines.as_deref(), encoding.as_deref())?;
    let choices = Choices { colors: colors(format, quantity.as_deref(), range.as_deref())?, ..choices };
    let file = mesh_file(&app, &caller, id, format, choices).await?;
    Ok(answer(&headers, &file, media_type, &format!("{id}.{}", format.name())))
}

/// Makes the file of a succeeded job's mesh, or takes it from the cache.
pub async fn mesh_file(
    app: &App,
    caller: &Caller,
    id: &str,
    format: MeshFormat,
    choices: Choices,
) -> Result<File, Failure> {
    let default = choices == Choices::default();
    let name = if default { format.name().to_owned() } else { format!("{} {choices:?}", format.name()) };
    let encode = move |archive: &Archive| format.encode_with(archive, choices).map_err(JobsError::Unwritable);
    Ok(app.jobs.convert(id, caller.owner(), name, encode).await?)
}

const ORIGINS: [(&str, Origin); 2] = [("given", Origin::Given), ("local", Origin::Local)];

/// Reads the options of a file besides its format. An option that the format does not have is an error with the status
/// 422 instead of 400, because each value is valid by itself.
fn choices(
    format: MeshFormat,
    origin: Option<&str>,
    lines: Option<&str>,
    encoding: Option<&str>,
) -> Result<Choices, Failure> {
    let name = format.name();
    let origin = match origin {
        None => Origin::Automatic,
        Some(text) => {
            let found = ORIGINS.iter().find(|(name, _)| *name == text);
            found.map(|(_, origin)| *origin).ok_or_else(|| Failure::bad_query("origin must be one of given, local"))?
        }
    };
    let lines = match lines {
        None => true,
        Some("true") if !format.has_lines() => {
            return Err(Failure::unwritable(format!("lines must be false with {name}, which has no lines")));
        }
        Some("true") => true,
        Some("false") => false,
        Some(_) => return Err(Failure::bad_query("lines must be true or false")),
    };
    let ascii = match encoding {
        None => false,
        Some("ascii" | "binary") if format != MeshFormat::Ply => {
            return Err(Failure::unwritable(format!("encoding is only allowed with ply, not with {name}")));
        }
        Some("ascii") => true,
        Some("binary") => false,
        Some(_) => return Err(Failure::bad_query("encoding must be one of binary, ascii")),
    };
    // In a format without lines, both values of `lines` give the same file, so they share one entry of the cache.
    Ok(Choices { origin, lines: lines || !format.has_lines(), ascii, colors: None })
}

/// Reads the quantity by which the mesh is coloured, and the range of its scale. Whether the mesh has this quantity is
/// checked when the file is made.
fn colors(format: MeshFormat, quantity: Option<&str>, range: Option<&str>) -> Result<Option<Colors>, Failure> {
    let range = match range {
        None => None,
        Some(text) => {
            let number = text.parse().ok().filter(|&number: &f64| number.is_finite() && number > 0.0);
            Some(number.ok_or_else(|| Failure::bad_query("range must be a number above 0"))?)
        }
    };
    let Some(name) = quantity else {
        return match range {
            None => Ok(None),
            Some(_) => Err(Failure::unwritable("range is only allowed with colors, whose scale it ends")),
        };
    };
    let quantity = Quantity::from_name(name).ok_or_else(|| {
        Failure::bad_query(format!("colors must be one of {}", Quantity::ALL.map(Quantity::name).join(", ")))
    })?;
    if !format.has_colors() {
        let with: Vec<&str> = MeshFormat::ALL.iter().filter(|format| format.has_colors()).map(|f| f.name()).collect();
        let detail = format!("colors is only allowed with {}, not with {}", with.join(", "), format.name());
        return Err(Failure::unwritable(detail));
    }
    Ok(Some(Colors { quantity, range }))
}

pub fn mesh_entry() -> Value {
    let formats = MeshFormat::ALL.map(|format| (format.name(), format.media_type()));
    let problems = [&FILE_PROBLEMS[..], &[("422", "Invalid")]].concat();
    let (format, mut responses) = representation(&formats, "glb", "The mesh", &problems);
    responses["200"]["content"][MeshFormat::Json.media_type()]["schema"] = reference("Mesh");
    let origin = query_parameter(
        "origin",
        "Point that the coordinates are relative to: the request's zero (`given`) or `origin` of the job's statistics \
         (`local`). The default is `given`, except for STL files of meshes that are too far from zero for 32-bit \
         numbers.",
        json!({ "type": "string", "enum": ORIGINS.map(|(name, _)| name) }),
    );
    let lines = query_parameter(
        "lines",
        "Whether the file has the lines along the mesh (boundaries, directrices, bridges, members). The default is \
         true. PLY and STL never have lines.",
        json!({ "type": "boolean" }),
    );
    let encoding = query_parameter(
        "encoding",
        "Whether a PLY file is binary or text. The default is `binary`. Other formats have no choice.",
        json!({ "type": "string", "enum": ["binary", "ascii"] }),
    );
    let colors = query_parameter(
        "colors",
        "Quantity that a GLB, glTF or PLY file is coloured by, from blue at 0 to red. Without it, the mesh is neutral. \
         Minimal surfaces have `mean_curvature`, and `lower_bound_slack` if they have a certificate. In GLB and glTF, \
         the members of uniform meshes have `length`, and cables have `force`. Strips have `convexity`: a triangle is \
         red between two bridges that are not locally convex, green beside one, and blue otherwise; in GLB and glTF, \
         such a bridge is red and the others are blue.",
        json!({ "type": "string", "enum": Quantity::ALL.map(Quantity::name) }),
    );
    let range = query_parameter(
        "range",
        "Value that `colors` shows in red, in the unit of the job's statistics. The default is the 95th percentile of \
         the mean curvature but at least 0.01/R, where R is the radius of the boundary; 1 for the slack and the \
         convexity; and the largest length or force. GLB and glTF state the scale in `extras.color_range`.",
        json!({ "type": "number", "format": "double", "exclusiveMinimum": 0 }),
    );
    json!({ "operationId": "getMesh", "tags": ["jobs"], "summary": "The mesh as GLB, glTF, OBJ, PLY, STL or JSON",
        "parameters": [id_parameter("job"), format, origin, lines, encoding, colors, range], "responses": responses })
}

/// Problems that any file made from a job's mesh may have.
pub const FILE_PROBLEMS: [(&str, &str); 6] = [
    ("400", "BadRequest"),
    ("404", "NotFound"),
    ("406", "NotAcceptable"),
    ("409", "NoMesh"),
    ("410", "Gone"),
    ("503", "Unavailable"),
];

/// The formats of a certificate, with their media types.
const CERTIFICATE_FORMATS: [(&str, &str); 1] = [("json", "application/json")];

pub async fn certificate(
    State(app): State<App>,
    caller: Caller,
    Path(id): Path<String>,
    RawQuery(query): RawQuery,
    headers: HeaderMap,
) -> Result<Response, Failure> {
    let id = &checked(&id)?;
    let [format] = parameters(query.as_deref(), ["format"])?;
    let (_, media_type) = choose(format, &headers, &CERTIFICATE_FORMATS)?;
    let proof = |archive: &Archive| {
        let proof = archive.contents().proof.as_ref().ok_or(JobsError::NoCertificate)?;
        Ok(proof.clone().into_bytes())
    };
    let file = app.jobs.convert(id, caller.owner(), "certificate", proof).await?;
    Ok(answer(&headers, &file, media_type, &format!("{id}.certificate.json")))
}

pub fn certificate_entry() -> Value {
    let description = "The field that proves the lower bound of the area: tetrahedra and the field's values on them";
    let (format, responses) = representation(&CERTIFICATE_FORMATS, "json", description, &FILE_PROBLEMS);
    json!({ "operationId": "getCertificate", "tags": ["jobs"],
        "summary": "The proof of a minimal surface's `area_lower_bound`, for a check by another program",
        "parameters": [id_parameter("job"), format], "responses": responses })
}

/// Returns the index of the chosen format and the media type of the answer. The query's `format` takes precedence over
/// `Accept`. Without both, the first format is chosen. A client that accepts only [`BYTES`] gets that media type.
pub fn choose(
    format: Option<String>,
    headers: &HeaderMap,
    formats: &[(&str, &'static str)],
) -> Result<(usize, &'static str), Failure> {
    let Some(name) = format else {
        let offered: Vec<&'static str> = formats.iter().map(|(_, media_type)| *media_type).chain([BYTES]).collect();
        let chosen = accepted(headers, &offered)
            .ok_or_else(|| Failure::not_acceptable(format!("the offered media types are: {}", offered.join(", "))))?;
        return Ok((if chosen == formats.len() { 0 } else { chosen }, offered[chosen]));
    };
    let chosen = formats.iter().position(|(known, _)| *known == name).ok_or_else(|| {
        let names: Vec<&str> = formats.iter().map(|(name, _)| *name).collect();
        Failure::bad_query(format!("format must be one of {}", names.join(", ")))
    })?;
    let media_type = formats[chosen].1;
    let as_bytes = accepted(headers, &[media_type, BYTES]) == Some(1);
    Ok((chosen, if as_bytes { BYTES } else { media_type }))
}

/// Answers with the file, with a range of it, or with 304.
pub fn answer(headers: &HeaderMap, file: &File, media_type: &'static str, name: &str) -> Response {
    let tag = format!("\"{}\"", file.tag);
    let length = file.length;
    let mut response = if none_match_hits(headers, &tag) {
        StatusCode::NOT_MODIFIED.into_response()
    } else {
        match part(headers, length, &tag) {
            Part::Whole => bytes_of(file, 0..length),
            Part::Range(range) => {
                let content_range = format!("bytes {}-{}/{length}", range.start, range.end - 1);
                let mut response = bytes_of(file, range);
                *response.status_mut() = StatusCode::PARTIAL_CONTENT;
                insert(&mut response, header::CONTENT_RANGE, &content_range);
                response
            }
            Part::Unsatisfiable => {
                let failure = Failure::range_not_satisfiable(format!("the file has {length} bytes"));
                let mut response = failure.into_response();
                insert(&mut response, header::CONTENT_RANGE, &format!("bytes */{length}"));
                return response;
            }
        }
    };
    if response.status() != StatusCode::NOT_MODIFIED {
        insert(&mut response, header::ACCEPT_RANGES, "bytes");
    }
    describe(&mut response, &tag, media_type, name);
    response
}

/// Returns a response with a range of a file's bytes.
pub fn bytes_of(file: &File, range: Range<usize>) -> Response {
    let length = HeaderValue::from(range.len());
    let mut response = Response::new(Body::from_stream(file.clone().stream(range)));
    response.headers_mut().insert(header::CONTENT_LENGTH, length);
    response
}

/// Sets the headers of a response with a file, or of a 304.
pub fn describe(response: &mut Response, tag: &str, media_type: &str, name: &str) {
    if response.status() != StatusCode::NOT_MODIFIED {
        insert(response, header::CONTENT_TYPE, media_type);
        insert(response, header::CONTENT_DISPOSITION, &format!("attachment; filename=\"{name}\""));
    }
    insert(response, header::ETAG, tag);
    insert(response, header::VARY, "Accept");
    // A job's mesh never changes, but the server checks at each request who may read it.
    insert(response, header::CACHE_CONTROL, "private, no-cache");
}

fn insert(response: &mut Response, name: header::HeaderName, value: &str) {
    if let Ok(value) = HeaderValue::from_str(value) {
        response.headers_mut().insert(name, value);
    }
}
