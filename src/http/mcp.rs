//! The service as tools for language models: the Model Context Protocol (MCP), on standard input and output and at
//! `POST /mcp`.
//!
//! The tools call `jobs` as the handlers of [`routes`](crate::http::routes) do, and jobs belong to the same owners. The
//! answer to a failed call is a result with the text of its problem document, because a model can read results. Only a
//! call that names no known tool is answered with a protocol error.

pub mod schemas;

use crate::config::HttpConfig;
use crate::http::body::Received;
use crate::http::parameters::{checked, pairs};
use crate::http::problem::Failure;
use crate::http::state::App;
use crate::jobs::JobsError;
use crate::jobs::submission::{Submitted, Submitter};
use crate::status::{CancelReason, Status};
use crate::wire::job::{Job, JobSummary};
use crate::wire::objectives::{self, Limits};
use axum::http::uri::Authority;
use base64::Engine as _;
use bytes::Bytes;
use plateau_archive::formats::{MeshFormat, picture};
use plateau_drawing::{PatternOptions, Refused, ScheduleOptions};
use plateau_engine::kind::Kind;
use plateau_engine::schema;
use plateau_strict_json::rejection::{FieldError, Rejection};
use rmcp::model::{
    CallToolRequestParams, CallToolResponse, CallToolResult, ContentBlock, Implementation, ListToolsResult,
    PaginatedRequestParams, ServerCapabilities, ServerConfig,
};
use rmcp::service::RequestContext;
use rmcp::transport::async_rw::AsyncRwTransport;
use rmcp::{ErrorData, RoleServer, ServerHandler, ServiceExt};
use schemas::{
    Arguments, CancelArguments, DescribeArguments, Description, File, GetArguments, LinkArguments, SolveArguments,
    StartArguments,
};
use serde::Serialize;
use serde_json::Value;
use std::net::{IpAddr, Ipv4Addr, Ipv6Addr, SocketAddr};
use std::sync::{Arc, Mutex, PoisonError};
use std::time::Duration;
use url::form_urlencoded;

/// Returns the text that a client may give its model before the first call.
fn instructions() -> String {
    let finds: Vec<&str> = Kind::ALL.iter().map(|kind| kind.finds()).collect();
    format!(
        "Plateau finds forms: {}. Call describe to see the kinds, and describe with a kind for its request's members \
         and an example. Then call solve, or start and get for requests that take minutes; cancel ends a job. link \
         gives the address of the mesh, the flat pattern, the schedule of parts or the certificate. Lengths are in the \
         request's unit, and angles are in degrees.",
        finds.join("; ")
    )
}

/// Number of bytes that an MCP message may have in addition to the request of its call.
pub const ENVELOPE_BYTES: usize = 64 << 10;

/// A message without the request of its call, and that request.
#[derive(Debug)]
pub struct Message {
    pub text: Vec<u8>,
    /// The member `request` of the arguments, as a body that [`jobs`](crate::jobs) takes.
    pub request: Option<Vec<u8>>,
}

impl Message {
    /// Takes the request out of a message and leaves its kind in it. The library, which parses messages on the threads
    /// of the async runtime, then has little to parse. The values that are parsed here are freed on return.
    ///
    /// # Errors
    /// Returns 400 for a text that is not JSON, and 413 if more than [`ENVELOPE_BYTES`] are left.
    pub fn read(body: &[u8]) -> Result<Self, Failure> {
        let mut message: Value = serde_json::from_slice(body)
            .map_err(|error| Failure::malformed(format!("the body is not JSON: {error}")))?;
        let mut request = None;
        if let Some(given) = message.pointer_mut("/params/arguments/request")
            && given.is_object()
        {
            request = Some(written(given)?);
            given.as_object_mut().into_iter().for_each(|members| members.retain(|name, _| name == "kind"));
        }
        let text = written(&message)?;
        if text.len() > ENVELOPE_BYTES {
            let detail = format!("a message may have at most {ENVELOPE_BYTES} bytes beside the request of its call");
            return Err(Failure::too_large(detail));
        }
        Ok(Self { text, request })
    }
}

/// The tools for one caller.
#[derive(Clone, Debug)]
pub struct Tools {
    app: App,
    /// Owner of the caller's jobs. `None` means all jobs.
    owner: Option<String>,
    /// Address of this server, to which the paths of links are added: `http://localhost:8080/plateau`.
    address: String,
    /// The request of the only call, if it was taken out of the message before the library parsed the message. It is
    /// taken from here when it is submitted, so that its memory is free while the call waits for the job.
    request: Arc<Mutex<Option<Received>>>,
}

/// Speaks MCP on standard input and output until the input ends or a shutdown begins. `listening` is the address at
/// which this process serves meshes.
pub async fn serve_stdio(app: App, listening: SocketAddr) {
    let jobs = app.jobs.clone();
    let longest = app.config.limits.body_bytes.saturating_add(ENVELOPE_BYTES);
    let address = address(&app.config.http, "http", &reachable(listening).to_string());
    let (reader, writer) = rmcp::transport::stdio_pipes();
    let transport = AsyncRwTransport::new_server(reader, writer).with_max_line_length(longest);
    let starting = Tools { app, owner: None, address, request: Arc::default() }.serve(transport);
    let service = tokio::select! {
        started = starting => match started {
            Ok(service) => service,
            Err(error) => return tracing::warn!(%error, "the client did not open a session"),
        },
        () = jobs.shutdown() => return,
    };
    let stop = service.cancellation_token();
    let mut ended = std::pin::pin!(service.waiting());
    tokio::select! {
        _ = &mut ended => {}
        () = jobs.shutdown() => {
            stop.cancel();
            let _ = ended.await;
        }
    }
}

/// Returns the address at which a client on this machine reaches a listener.
fn reachable(listening: SocketAddr) -> SocketAddr {
    let ip = match listening.ip() {
        IpAddr::V4(ip) if ip.is_unspecified() => IpAddr::V4(Ipv4Addr::LOCALHOST),
        IpAddr::V6(ip) if ip.is_unspecified() => IpAddr::V6(Ipv6Addr::LOCALHOST),
        ip => ip,
    };
    SocketAddr::new(ip, listening.port())
}

fn address(http: &HttpConfig, scheme: &str, authority: &str) -> String {
    format!("{scheme}://{authority}{}", http.public_base_path)
}

impl Tools {
    /// Returns the tools for a message. `host` is the authority that the client used, `scheme` is `http` or `https`, and
    /// `request` is what [`Message::read`] took out of the message.
    #[must_use]
    pub fn of_message(
        app: App,
        owner: Option<&str>,
        (scheme, host): (&str, Option<&str>),
        request: Option<Received>,
    ) -> Self {
        let host = host.and_then(|host| host.parse::<Authority>().ok());
        let host = host.map_or_else(|| reachable(app.config.http.listen).to_string(), |host| host.to_string());
        let address = address(&app.config.http, scheme, &host);
        Self { owner: owner.map(str::to_owned), address, app, request: Arc::new(Mutex::new(request)) }
    }

    fn describe(&self, arguments: &Value) -> Result<CallToolResult, Failure> {
        let DescribeArguments { kind, example, whole } = schema::read(arguments)?;
        let wanted = |kind_of: Kind| kind.is_none_or(|kind| kind == kind_of);
        let mut objectives = objectives::objectives().objectives;
        objectives.retain(|objective| wanted(objective.kind));
        let mut examples = objectives::example_list().examples;
        examples.retain(|example| wanted(example.kind));
        let example = match (example, kind) {
            (Some(name), _) => Some(named_example(&name)?),
            (None, Some(kind)) => short_example(kind),
            (None, None) => None,
        };
        let of_schema = kind.filter(|_| whole);
        complete(
            &Description {
                kinds: Kind::ALL.iter().copied().filter(|&kind| wanted(kind)).map(Into::into).collect(),
                limits: Limits::of(&self.app.config),
                members: kind.map(schemas::members),
                objectives: whole.then_some(objectives),
                examples: whole.then_some(examples),
                request_schema: of_schema.map(schemas::request),
                statistics_schema: of_schema.map(|kind| Value::Object(schema::statistics(kind))),
                example,
            },
            Vec::new(),
        )
    }

    async fn solve(&self, arguments: Value, context: RequestContext<RoleServer>) -> Result<CallToolResult, Failure> {
        let SolveArguments { request, wait_s } = read(arguments)?;
        let job = self.begin(request, wait_s > 0).await?;
        if job.status.is_final() {
            return self.answer(job).await;
        }
        let job = tokio::select! {
            job = self.app.jobs.wait(&job.id, self.owner(), self.granted(wait_s)) => job?,
            // The caller has cancelled the call or has gone away.
            () = context.ct.cancelled() => {
                self.app.jobs.cancel(&job.id, self.owner(), CancelReason::Disconnected).await?
            },
        };
        self.answer(job).await
    }

    async fn start(&self, arguments: Value) -> Result<CallToolResult, Failure> {
        let StartArguments { request } = read(arguments)?;
        let job = self.begin(request, false).await?;
        complete(&JobSummary::from(job), Vec::new())
    }

    async fn get(&self, arguments: Value) -> Result<CallToolResult, Failure> {
        let GetArguments { id, wait_s } = read(arguments)?;
        let id = checked(&id)?;
        let job = match wait_s {
            0 => self.app.jobs.get(&id, self.owner()).await?,
            wait_s => self.app.jobs.wait(&id, self.owner(), self.granted(wait_s)).await?,
        };
        self.answer(job).await
    }

    async fn cancel(&self, arguments: Value) -> Result<CallToolResult, Failure> {
        let CancelArguments { id } = read(arguments)?;
        let job = self.app.jobs.cancel(&checked(&id)?, self.owner(), CancelReason::Client).await?;
        complete(&JobSummary::from(job), Vec::new())
    }

    async fn link(&self, arguments: Value) -> Result<CallToolResult, Failure> {
        let arguments: LinkArguments = read(arguments)?;
        let job = self.app.jobs.get(&checked(&arguments.id)?, self.owner()).await?;
        if job.status != Status::Succeeded {
            return Err(JobsError::NoMesh(job.status).into());
        }
        let (path, query, format, media_type) = file_of(&job, &arguments)?;
        // The job's links begin with the base path, and so does the address.
        let path = path.strip_prefix(&self.app.config.http.public_base_path).unwrap_or(&path);
        let mark = if query.is_empty() { "" } else { "?" };
        let url = format!("{}{path}{mark}{query}", self.address);
        complete(&schemas::Link { url, format, media_type, needs_key: self.app.keys.required() }, Vec::new())
    }

    fn owner(&self) -> Option<&str> {
        self.owner.as_deref()
    }

    /// Returns the wait that a caller asks for, limited to this server's maximum.
    fn granted(&self, wait_s: u64) -> Duration {
        Duration::from_secs(wait_s.min(self.app.config.http.wait_max_s))
    }

    /// Submits a request that names its kind. Pointers of errors begin at the tool's arguments.
    async fn begin(&self, request: Value, waited_for: bool) -> Result<Job, Failure> {
        const POINTER: &str = "/request";
        let kind = request["kind"].as_str().and_then(Kind::from_name);
        // The schema of the arguments requires a known kind.
        let kind = kind.ok_or_else(|| Failure::internal("a request without a kind passed its schema"))?;
        let taken = self.request.lock().unwrap_or_else(PoisonError::into_inner).take();
        let body = match taken {
            Some(received) => Bytes::from_owner(received),
            None => written(&request)?.into(),
        };
        drop(request);
        let limit = self.app.config.limits.body_bytes;
        if body.len() > limit {
            let detail = format!("has more than the {limit} bytes that this server accepts; see limits of describe");
            return Err(Rejection::TooLarge(vec![FieldError::new(POINTER, detail)]).into());
        }
        let from = Submitter { owner: self.owner.clone(), idempotency_key: None };
        match self.app.jobs.submit(kind, body, from, waited_for).await {
            Ok(accepted) => match accepted.submitted {
                Submitted::Created(job) | Submitted::Existing(job) => Ok(job),
            },
            Err(error) => Err(error.within(POINTER).into()),
        }
    }

    /// Returns the result of a call about a job, with a picture if the job has succeeded.
    async fn answer(&self, job: Job) -> Result<CallToolResult, Failure> {
        let mut further = Vec::new();
        if job.status == Status::Succeeded {
            let drawn = self
                .app
                .jobs
                .convert(&job.id, self.owner(), "png", |archive| picture::to_png(archive).map_err(JobsError::Internal));
            let picture = async { drawn.await?.bytes().await };
            match picture.await {
                Ok(bytes) => {
                    let data = base64::engine::general_purpose::STANDARD.encode(&bytes);
                    further.push(ContentBlock::image(data, "image/png"));
                }
                Err(error) => {
                    further.push(ContentBlock::text(format!("There is no picture. {}", Failure::from(error))))
                }
            }
        }
        let mut result = complete(&job, further)?;
        result.is_error = Some(job.status == Status::Failed);
        Ok(result)
    }
}

/// Reads a tool's arguments and frees their JSON values.
fn read<T: Arguments>(arguments: Value) -> Result<T, Failure> {
    Ok(schema::read(&arguments)?)
}

/// Returns the path, the query, the format and the media type of a file. Parameters that the server would refuse are
/// refused here.
fn file_of(job: &Job, arguments: &LinkArguments) -> Result<(String, String, String, &'static str), Failure> {
    let LinkArguments { file, format, query, .. } = arguments;
    let refused = |argument: &str, detail: String| Rejection::Invalid(vec![FieldError::new(argument, detail)]);
    let mut given = pairs(query.as_deref());
    if let Some(format) = format {
        given.retain(|(name, _)| name != "format");
        given.insert(0, ("format".into(), format.clone()));
    }
    let written = || form_urlencoded::Serializer::new(String::new()).extend_pairs(&given).finish();
    match file {
        File::Pattern => {
            let none = || refused("/file", format!("this job has no pattern; {}", Refused::NoPattern));
            let path = job.links.pattern.clone().ok_or_else(none)?;
            let options = PatternOptions::read(&given)?;
            Ok((path, written(), options.extension().into(), options.media_type()))
        }
        File::Schedule => {
            let options = ScheduleOptions::read(&given)?;
            let path = format!("{}/schedule", job.links.this);
            Ok((path, written(), options.extension().into(), options.media_type()))
        }
        File::Mesh | File::Certificate if query.is_some() => {
            Err(refused("/query", "only a pattern and a schedule have further parameters".into()).into())
        }
        File::Mesh => {
            let name = format.as_deref().unwrap_or(MeshFormat::Glb.name());
            let names = MeshFormat::ALL.map(MeshFormat::name).join(", ");
            let known = MeshFormat::from_name(name);
            let format = known.ok_or_else(|| refused("/format", format!("must be one of {names}")))?;
            let path = job.links.mesh.clone().ok_or(JobsError::NoMesh(job.status))?;
            Ok((path, format!("format={}", format.name()), format.name().into(), format.media_type()))
        }
        File::Certificate if format.as_deref().is_some_and(|format| format != "json") => {
            Err(refused("/format", "must be json for a certificate".into()).into())
        }
        File::Certificate => {
            let path = job.links.certificate.clone().ok_or(JobsError::NoCertificate)?;
            Ok((path, "format=json".into(), "json".into(), "application/json"))
        }
    }
}

/// Returns the example that shows the form of a kind's requests in the least of a model's context: the shortest one, or
/// the shortest with a cable along an edge where the kind has such cables, because most requests with cables need them.
fn short_example(kind: Kind) -> Option<&'static objectives::Example> {
    let has_edge_cable = |request: &Value| {
        request["cables"].as_array().is_some_and(|cables| cables.iter().any(|cable| cable.get("along").is_some()))
    };
    let of_kind = objectives::examples().iter().filter(|example| example.kind == kind);
    of_kind.min_by_key(|example| (!has_edge_cable(&example.request), example.request.to_string().len()))
}

fn named_example(name: &str) -> Result<&'static objectives::Example, Failure> {
    let examples = objectives::examples();
    examples.iter().find(|example| example.name == name).ok_or_else(|| {
        let names: Vec<&str> = examples.iter().map(|example| example.name).collect();
        let detail = format!("must be one of {}", names.join(", "));
        Rejection::Invalid(vec![FieldError::new("/example", detail)]).into()
    })
}

fn written(value: &Value) -> Result<Vec<u8>, Failure> {
    serde_json::to_vec(value).map_err(|error| Failure::internal(error.to_string()))
}

/// Returns a result as structured content and as the same JSON in a text, followed by further content.
fn complete(result: &impl Serialize, further: Vec<ContentBlock>) -> Result<CallToolResult, Failure> {
    let value = serde_json::to_value(result).map_err(|error| Failure::internal(error.to_string()))?;
    let mut result = CallToolResult::structured(value);
    result.content.extend(further);
    Ok(result)
}

impl ServerHandler for Tools {
    fn get_info(&self) -> ServerConfig {
        let name = Implementation::new("plateau", env!("CARGO_PKG_VERSION")).with_title("Plateau");
        ServerConfig::new(ServerCapabilities::builder().enable_tools().build())
            .with_server_info(name)
            .with_instructions(instructions())
    }

    async fn list_tools(
        &self,
        _: Option<PaginatedRequestParams>,
        _: RequestContext<RoleServer>,
    ) -> Result<ListToolsResult, ErrorData> {
        Ok(ListToolsResult::with_all_items(schemas::tools().to_vec()))
    }

    async fn call_tool(
        &self,
        request: CallToolRequestParams,
        context: RequestContext<RoleServer>,
    ) -> Result<CallToolResponse, ErrorData> {
        let arguments = Value::Object(request.arguments.unwrap_or_default());
        let result = match &*request.name {
            schemas::DESCRIBE => self.describe(&arguments),
            schemas::SOLVE => self.solve(arguments, context).await,
            schemas::START => self.start(arguments).await,
            schemas::GET => self.get(arguments).await,
            schemas::CANCEL => self.cancel(arguments).await,
            schemas::LINK => self.link(arguments).await,
            _ => {
                let names: Vec<&str> = schemas::tools().iter().map(|tool| &*tool.name).collect();
                let detail = format!("there is no tool of this name; the tools are: {}", names.join(", "));
                return Err(ErrorData::invalid_params(detail, None));
            }
        };
        let failed = |failure: Failure| CallToolResult::error(vec![ContentBlock::text(failure.to_string())]);
        Ok(result.unwrap_or_else(failed).into())
    }
}
