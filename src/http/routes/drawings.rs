//! `/v1/jobs/{id}/pattern` and `/schedule`: drawings and tables made from the stored result.

use crate::http::access::Caller;
use crate::http::entry::{BYTES, id_parameter, query_parameter, representation};
use crate::http::negotiate::accepted;
use crate::http::parameters::{checked, pairs};
use crate::http::problem::Failure;
use crate::http::routes::mesh::{FILE_PROBLEMS, answer, choose};
use crate::http::state::App;
use crate::jobs::JobsError;
use axum::extract::{Path, RawQuery, State};
use axum::http::HeaderMap;
use axum::response::Response;
use plateau_drawing::options::{self, Parameter};
use plateau_drawing::{Format, PatternOptions, ScheduleOptions, schedule as schedules};
use serde_json::{Value, json};

const ZIP: &str = "application/zip";

pub async fn pattern(
    State(app): State<App>,
    caller: Caller,
    Path(id): Path<String>,
    RawQuery(query): RawQuery,
    headers: HeaderMap,
) -> Result<Response, Failure> {
    let id = &checked(&id)?;
    let mut given = pairs(query.as_deref());
    if !given.iter().any(|(name, _)| matches!(name.as_str(), "format" | "profile" | "split")) {
        // The client's media types choose the format, unless the query does.
        let formats = Format::ALL.map(|format| (format.name(), format.media_type()));
        let (chosen, _) = choose(None, &headers, &formats)?;
        given.push(("format".into(), Format::ALL[chosen].name().into()));
    }
    let options = PatternOptions::read(&given)?;
    let media_type = options.media_type();
    let as_bytes = accepted(&headers, &[media_type, BYTES]) == Some(1);
    let name = format!("{id}.{}", options.extension());
    let key = format!("pattern {options:?}");
    let make = move |archive: &plateau_archive::Archive| {
        plateau_drawing::pattern(archive.contents(), &options).map_err(JobsError::NoDrawing)
    };
    let file = app.jobs.convert(id, caller.owner(), key, make).await?;
    Ok(answer(&headers, &file, if as_bytes { BYTES } else { media_type }, &name))
}

pub fn pattern_entry() -> Value {
    let mut formats = Format::ALL.map(|format| (format.name(), format.media_type())).to_vec();
    formats.push(("zip", ZIP));
    let problems = [&FILE_PROBLEMS[..], &[("422", "Unsuitable")]].concat();
    let (_, responses) = representation(&formats, "svg", "The flat pattern, true to scale", &problems);
    let parameters = described(options::PARAMETERS);
    json!({ "operationId": "getPattern", "tags": ["jobs"],
        "summary": "The flat pattern of a ruled surface as SVG, DXF, PDF or JSON",
        "parameters": parameters, "responses": responses })
}

/// Returns the entries of the parameters of a query, after that of the job.
fn described(parameters: &[Parameter]) -> Vec<Value> {
    let entry = |parameter: &Parameter| query_parameter(parameter.name, parameter.description, parameter.schema());
    std::iter::once(id_parameter("job")).chain(parameters.iter().map(entry)).collect()
}

pub async fn schedule(
    State(app): State<App>,
    caller: Caller,
    Path(id): Path<String>,
    RawQuery(query): RawQuery,
    headers: HeaderMap,
) -> Result<Response, Failure> {
    let id = &checked(&id)?;
    let options = ScheduleOptions::read(&pairs(query.as_deref()))?;
    let media_type = options.media_type();
    let as_bytes = accepted(&headers, &[media_type, BYTES]) == Some(1);
    let name = format!("{id}.{}", options.file_name());
    let key = format!("schedule {options:?}");
    let make = move |archive: &plateau_archive::Archive| {
        plateau_drawing::schedule(archive.contents(), &options).map_err(JobsError::NoDrawing)
    };
    let file = app.jobs.convert(id, caller.owner(), key, make).await?;
    Ok(answer(&headers, &file, if as_bytes { BYTES } else { media_type }, &name))
}

pub fn schedule_entry() -> Value {
    let formats = [("csv", "text/csv"), ("dxf", "image/vnd.dxf")];
    let problems = [&FILE_PROBLEMS[..], &[("422", "Unsuitable")]].concat();
    let (_, responses) = representation(&formats, "csv", "The table, or the numbered lattice in space", &problems);
    let of_bends = options::PARAMETERS.iter().filter(|parameter| parameter.name != "format").copied();
    let parameters: Vec<Parameter> = schedules::PARAMETERS.iter().copied().chain(of_bends).collect();
    json!({ "operationId": "getSchedule", "tags": ["jobs"],
        "summary": "Members, nodes, bends, cables or supports as CSV, or the numbered members as DXF",
        "parameters": described(&parameters), "responses": responses })
}
