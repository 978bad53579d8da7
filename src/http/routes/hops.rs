//! `/hops`: components for Hops in Grasshopper, and the messages by which Hops runs them.
//!
//! A message becomes an ordinary request of the same owner, with the same checks. Every answer has the form that Hops
//! reads, errors too.

use crate::hops::answer::{Answer, Parts, geometry};
use crate::hops::component::{Action, Component, File, components, find, poll_name};
use crate::hops::recipe::{UncheckedRequest, draft};
use crate::hops::{HopsError, values};
use crate::http::access::Caller;
use crate::http::body;
use crate::http::parameters::{checked, pairs};
use crate::http::problem::Failure;
use crate::http::state::App;
use crate::jobs::JobsError;
use crate::jobs::submission::{Submitted, Submitter};
use crate::status::Status;
use crate::wire::job::{Job, JobKind};
use axum::Json;
use axum::body::Body;
use axum::extract::{Path, State};
use axum::http::{HeaderValue, Request, StatusCode, header};
use axum::response::{IntoResponse, Response};
use plateau_archive::Archive;
use plateau_drawing::{PatternOptions, ScheduleOptions};
use plateau_engine::kind::Kind;
use plateau_engine::limits::refuse_too_many_values;
use plateau_engine::report::SolveError;
use plateau_strict_json::rejection::{FieldError, Rejection};
use serde_json::Value;
use std::time::Duration;

pub async fn list(State(app): State<App>) -> Result<Json<Vec<Value>>, Failure> {
    check_enabled(&app)?;
    let base = &app.config.http.public_base_path;
    Ok(Json(components().iter().map(|component| component.description(base)).collect()))
}

pub async fn describe(State(app): State<App>, Path(name): Path<String>) -> Result<Json<Value>, Failure> {
    check_enabled(&app)?;
    let component = find(&name).map_err(Failure::not_found)?;
    Ok(Json(component.description(&app.config.http.public_base_path)))
}

fn check_enabled(app: &App) -> Result<(), Failure> {
    if app.config.http.hops {
        return Ok(());
    }
    Err(Failure::not_found("Hops is off on this server; the setting http.hops turns it on"))
}

pub async fn solve(State(app): State<App>, caller: Caller, request: Request<Body>) -> Result<Response, Failure> {
    check_enabled(&app)?;
    let received = body::read_json(&app, request).await?;
    refuse_too_many_values(&received.bytes, &app.config.limits.requests())?;
    let max_points = app.config.limits.points;
    let body = received.bytes.clone();
    let read = move || {
        let message = values::message(&body).map_err(|refusal| (None, refusal))?;
        let component = message.component;
        let refused = |refusal| (Some(component), refusal);
        let values = values::read(&message, max_points).map_err(refused)?;
        let made = match component.action {
            Action::Solve(recipe) | Action::Start(recipe) => Some(draft(recipe, &values, max_points).map_err(refused)?),
            Action::Poll(_) | Action::Read(_) => None,
        };
        Ok((component, values, made))
    };
    let read: Result<_, (Option<&Component>, HopsError)> = app.jobs.off_runtime(read).await?;
    drop(received);
    let (component, values, made) = match read {
        Ok(read) => read,
        Err((component, refusal)) => {
            let (failure, lines) = Failure::of_hops(refusal);
            let answer = match component {
                Some(component) => Answer::refused(component, lines),
                None => Answer::of_errors(lines),
            };
            return Ok(failure.to_hops(&answer));
        }
    };
    let run = Run { app: &app, caller: &caller, component, draft: made.as_ref() };
    let done = match component.action {
        Action::Solve(_) => run.solve().await,
        Action::Start(_) => run.start().await,
        Action::Poll(kind) => run.poll(kind, values.text("Job")).await,
        Action::Read(file) => run.read(file, values.text("Job"), values.text("Query")).await,
    };
    Ok(done.unwrap_or_else(|failure| {
        let line = |error: &FieldError| match &made {
            Some(draft) => draft.line(error),
            None if error.pointer.is_empty() => error.detail.clone(),
            None => format!("{}: {}", error.pointer, error.detail),
        };
        failure.to_hops(&Answer::refused(component, failure.lines(line)))
    }))
}

/// A message of Hops, and what is needed to answer it.
struct Run<'a> {
    app: &'a App,
    caller: &'a Caller,
    component: &'a Component,
    /// The request of a component that begins a job.
    draft: Option<&'a UncheckedRequest>,
}

impl Run<'_> {
    async fn solve(&self) -> Result<Response, Failure> {
        let job = self.begin(true).await?;
        if job.status.is_final() {
            return self.answer(job).await;
        }
        // Only this client knows the job, so the job is cancelled if the client goes away.
        let abandoned = self.app.jobs.cancel_on_drop(&job.id, self.caller.owner());
        let wait_s = self.app.config.http.hops_wait_s;
        let job = self.app.jobs.wait(&job.id, self.caller.owner(), Duration::from_secs(wait_s)).await?;
        if !job.status.is_final() {
            drop(abandoned);
            let start = format!("{}-start", self.component.name);
            let poll = self.draft.map_or_else(String::new, |draft| poll_name(draft.kind));
            return Err(Failure::unavailable(format!(
                "the job takes longer than the {wait_s} s for which this component waits, and was cancelled; use the \
                 components /hops/{start} and /hops/{poll}, or ask for a coarser mesh"
            )));
        }
        abandoned.keep();
        self.answer(job).await
    }

    async fn start(&self) -> Result<Response, Failure> {
        let job = self.begin(false).await?;
        Ok(respond(StatusCode::OK, &Answer::of_job(self.component, &job, &Parts::default())))
    }

    async fn poll(&self, kind: Kind, id: &str) -> Result<Response, Failure> {
        let job = self.app.jobs.get(&checked(id.trim())?, self.caller.owner()).await?;
        if job.kind != JobKind::Known(kind) {
            let detail = match &job.kind {
                JobKind::Known(other) => format!("is of another kind; use the component /hops/{}", poll_name(*other)),
                JobKind::Newer(_) => "is of a kind that this version of the server does not know".into(),
            };
            return Err(Rejection::Invalid(vec![FieldError::new("Job", detail)]).into());
        }
        if job.status.is_final() {
            return self.answer(job).await;
        }
        // Hops caches only answers with the status 200, so Hops will ask for the state of this job again.
        Ok(respond(StatusCode::ACCEPTED, &Answer::of_job(self.component, &job, &Parts::default())))
    }

    /// Answers with the lines of a file that is made from the result. `query` has the parameters of its address.
    async fn read(&self, file: File, id: &str, query: &str) -> Result<Response, Failure> {
        let id = &checked(id.trim())?;
        let given = pairs(Some(query.trim()));
        let owner = self.caller.owner();
        let file = match file {
            File::Pattern => {
                let options = PatternOptions::read(&given)?;
                if !matches!(options.extension(), "svg" | "dxf") {
                    // Hops reads no escapes in text, so JSON does not pass, and PDF and ZIP files are no text.
                    let detail = format!(
                        "asks for a {} file, which Hops cannot pass on; ask for svg or dxf, or fetch \
                         /v1/jobs/{id}/pattern?{}",
                        options.extension(),
                        query.trim()
                    );
                    return Err(Rejection::Invalid(vec![FieldError::new("Query", detail)]).into());
                }
                let key = format!("pattern {options:?}");
                let make = move |archive: &Archive| {
                    plateau_drawing::pattern(archive.contents(), &options).map_err(JobsError::NoDrawing)
                };
                self.app.jobs.convert(id, owner, key, make).await?
            }
            File::Schedule => {
                let options = ScheduleOptions::read(&given)?;
                let key = format!("schedule {options:?}");
                let make = move |archive: &Archive| {
                    plateau_drawing::schedule(archive.contents(), &options).map_err(JobsError::NoDrawing)
                };
                self.app.jobs.convert(id, owner, key, make).await?
            }
        };
        let bytes = file.bytes().await?;
        let text = String::from_utf8_lossy(&bytes);
        Ok(respond(StatusCode::OK, &Answer::of_lines(self.component, &text)))
    }

    async fn begin(&self, waited_for: bool) -> Result<Job, Failure> {
        let owner = self.caller.owner();
        self.app.jobs.check_room(owner).await?;
        let Some(draft) = self.draft else { return Err(Failure::internal("the component has no request")) };
        let body = draft.body();
        let limit = self.app.config.limits.body_bytes;
        if body.len() > limit {
            let text =
                format!("the request has more than the {limit} bytes that this server accepts; see GET /v1/limits");
            return Err(Rejection::TooLarge(vec![FieldError::new("", text)]).into());
        }
        let from = Submitter { owner: owner.map(str::to_owned), idempotency_key: None };
        match self.app.jobs.submit(draft.kind, body.into(), from, waited_for).await?.submitted {
            Submitted::Created(job) | Submitted::Existing(job) => Ok(job),
        }
    }

    /// Answers with a job that has ended.
    async fn answer(&self, job: Job) -> Result<Response, Failure> {
        if let Some(error) = &job.error {
            return Err(failed(error));
        }
        if job.status != Status::Succeeded {
            return Err(JobsError::NoMesh(job.status).into());
        }
        let convert = self
            .app
            .jobs
            .convert(&job.id, self.caller.owner(), "hops", |archive| geometry(archive).map_err(JobsError::Unwritable));
        let file = convert.await?.bytes().await?;
        Ok(respond(StatusCode::OK, &Answer::of_job(self.component, &job, &Parts::read(&file))))
    }
}

/// The types of failed jobs that show a defect of the server instead of a fault of the request. Hops is answered with
/// the status 500.
const DEFECTS: [&str; 8] = [
    "audit-failed",
    "internal",
    "invalid-mesh",
    "memory-limit",
    "solver-crashed",
    "solver-panicked",
    "unresponsive",
    "worker-lost",
];

/// Returns the failure for a job that has failed. Only a defect of the server is a server's error.
fn failed(error: &SolveError) -> Failure {
    let detail = format!("{}: {}", error.title, error.detail);
    let kind = error.kind.trim_start_matches("/problems/");
    if DEFECTS.contains(&kind) {
        return Failure::internal(detail);
    }
    let mut errors = error.errors.clone();
    // The detail is added only if it does not just repeat an error.
    let said = error.errors.iter().any(|one| error.detail.contains(&one.detail));
    if !said {
        errors.insert(0, FieldError::new("", detail));
    }
    Failure::invalid("").with_errors(errors)
}

fn respond(status: StatusCode, answer: &Answer<'_>) -> Response {
    let json = HeaderValue::from_static("application/json");
    (status, [(header::CONTENT_TYPE, json)], answer.to_json()).into_response()
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::wire::job::failures;

    fn status(kind: &str) -> StatusCode {
        let kind = format!("/problems/{kind}");
        let error = SolveError { kind, title: "The title".into(), detail: "the detail".into(), errors: Vec::new() };
        failed(&error).into_response().status()
    }

    #[test]
    fn a_defect_of_the_server_has_the_status_500() {
        let known: Vec<String> = failures().into_iter().map(|(name, _)| name).collect();
        for kind in DEFECTS {
            assert!(known.iter().any(|name| name == kind), "{kind} is no type of a failed job");
            assert_eq!(status(kind), StatusCode::INTERNAL_SERVER_ERROR, "{kind}");
        }
    }

    #[test]
    fn a_fault_of_the_request_has_the_status_422() {
        for kind in ["refused", "deadline", "invalid-geometry", "no-equilibrium", "no-connected-film"] {
            assert_eq!(status(kind), StatusCode::UNPROCESSABLE_ENTITY, "{kind}");
        }
    }
}
