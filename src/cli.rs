//! The command line: `plateau [serve] | worker | mcp | solve | openapi`.

use crate::app;
use crate::auth;
use crate::config::Config;
use crate::http::{openapi, parameters};
use crate::jobs::child;
use crate::telemetry;
use crate::threads::STACK_BYTES;
use crate::webhook::Secret;
use crate::wire::incoming::Incoming;
use clap::{Args, Parser, Subcommand};
use indicatif::{ProgressBar, ProgressStyle};
use plateau_archive::Archive;
use plateau_archive::formats::MeshFormat;
use plateau_drawing::{PatternOptions, Refused, ScheduleOptions, pattern, schedule};
use plateau_engine::report::Progress;
use plateau_engine::solved::{Signal, Unsolved};
use plateau_strict_json::rejection::{FieldError, MAX_ERRORS, Rejection};
use std::io::{Read, Write};
use std::net::{IpAddr, Ipv4Addr, Ipv6Addr, SocketAddr, TcpStream};
use std::path::PathBuf;
use std::process::ExitCode;
use std::time::Duration;
use toml::{Table, Value};

/// Form finding over HTTP: minimal surfaces and optimal ruled strips as glTF.
#[derive(Debug, Parser)]
#[command(name = "plateau", version, about)]
struct Cli {
    #[command(subcommand)]
    command: Option<Command>,
    #[command(flatten)]
    settings: Settings,
}

#[derive(Debug, Subcommand)]
enum Command {
    /// Answer HTTP requests and work on jobs (the default).
    Serve,
    /// Work on jobs of a shared database, without HTTP.
    Worker,
    /// Offer the service as tools for a language model (Model Context Protocol) on standard input and output, until the
    /// input ends. Meshes are served on a free port of this machine; --listen sets another address.
    #[cfg(feature = "mcp")]
    Mcp,
    /// Solve one request without a server, and print its statistics.
    Solve {
        /// File with the request as JSON, including its "kind". Use - for standard input.
        request: PathBuf,
        /// File to write; may be repeated. Its extension chooses the mesh's format (glb, gltf, obj, ply, stl), or it
        /// is a drawing or a schedule (svg, dxf, pdf, json, csv, or a zip of drawings).
        #[arg(short, long, required = true)]
        output: Vec<PathBuf>,
        /// Parameters of the drawing or of the schedule, as in the query of GET …/pattern or GET …/schedule, such as
        /// profile=cut&format=dxf. The extension is the format if they have none.
        #[arg(long, value_name = "QUERY")]
        with: Option<String>,
    },
    /// Check that the server at the configured address answers, for a container's health check. The exit status is 0 if
    /// it does.
    Health,
    /// Create API keys and print webhook secrets.
    Key {
        #[command(subcommand)]
        command: KeyCommand,
    },
    /// Print the OpenAPI document.
    Openapi,
    /// Solve the job that another process sends.
    #[command(name = child::COMMAND, hide = true)]
    Child,
}

#[derive(Debug, Subcommand)]
enum KeyCommand {
    /// Create a key. It is printed once, on standard output, with the line for the keys file.
    New {
        /// Name of the key in logs. Jobs posted with the key belong to this name.
        name: String,
    },
    /// Print the secret that signs messages to a key's callback URLs. The holder of the key needs it for a Standard
    /// Webhooks library.
    Webhooks {
        /// Name of the key. Omit it for a server without keys.
        name: Option<String>,
    },
}

/// Flags take precedence over the environment, and the environment over the file. `config/default.toml` shows every
/// setting.
#[derive(Debug, Args)]
struct Settings {
    /// Address and port to listen on. Port 0 picks a free port.
    #[arg(long, global = true, env = "PLATEAU_LISTEN", value_name = "ADDR:PORT")]
    listen: Option<String>,
    /// Folder of the embedded store.
    #[arg(long, global = true, env = "PLATEAU_DATA", value_name = "DIR")]
    data: Option<String>,
    /// URL of the database (postgres://…). The default is SQLite in the data folder.
    #[arg(long, global = true, env = "PLATEAU_DATABASE", value_name = "URL", hide_env_values = true)]
    database: Option<String>,
    /// Number of solvers that run at once. The default is one for each core.
    #[arg(long, global = true, env = "PLATEAU_WORKERS", value_name = "N", allow_negative_numbers = true)]
    workers: Option<i64>,
    /// TOML file with settings.
    #[arg(long, global = true, env = "PLATEAU_CONFIG", value_name = "FILE")]
    config: Option<PathBuf>,
    /// Check whether the command could start with these settings, and exit. The database is not reached.
    #[arg(long, global = true)]
    check_config: bool,
}

impl Settings {
    fn load(&self, defaults: Config) -> Result<Config, String> {
        let mut flags = Table::new();
        let mut set = |section: &str, key: &str, value: Option<Value>| {
            if let Some(value) = value {
                let table = flags.entry(section).or_insert_with(|| Value::Table(Table::new()));
                if let Value::Table(table) = table {
                    table.insert(key.into(), value);
                }
            }
        };
        set("http", "listen", self.listen.clone().map(Value::String));
        set("store", "data", self.data.clone().map(Value::String));
        set("store", "database", self.database.clone().map(Value::String));
        set("jobs", "workers", self.workers.map(Value::Integer));
        // A variable that is not UTF-8 is skipped, because no setting of this program has such a name or value.
        let environment =
            std::env::vars_os().filter_map(|(name, value)| Some((name.into_string().ok()?, value.into_string().ok()?)));
        defaults.overlaid(self.config.as_ref(), environment, flags)
    }
}

fn role(command: &Command) -> app::Role {
    match command {
        Command::Worker => app::Role::Worker,
        #[cfg(feature = "mcp")]
        Command::Mcp => app::Role::Mcp,
        _ => app::Role::Serve,
    }
}

/// Exit status for wrong usage or configuration.
const USAGE: u8 = 2;

pub fn main() -> ExitCode {
    let cli = Cli::parse();
    if matches!(cli.command, Some(Command::Child)) {
        return child::run();
    }
    let defaults = match cli.command {
        #[cfg(feature = "mcp")]
        Some(Command::Mcp) => Config::of_mcp(),
        _ => Config::default(),
    };
    let config = match cli.settings.load(defaults) {
        Ok(config) => config,
        Err(message) => return fail(USAGE, &message),
    };
    if cli.settings.check_config {
        let role = cli.command.as_ref().map_or(app::Role::Serve, role);
        return match app::check(&config, role) {
            Ok(_) => {
                println!("the configuration is valid");
                ExitCode::SUCCESS
            }
            Err(message) => fail(USAGE, &message),
        };
    }
    match cli.command.unwrap_or(Command::Serve) {
        Command::Openapi => {
            // A reader that closes the pipe early (`| head`) is no failure.
            match std::io::stdout().write_all(openapi::text().as_bytes()) {
                Err(error) if error.kind() != std::io::ErrorKind::BrokenPipe => fail(1, &error.to_string()),
                _ => ExitCode::SUCCESS,
            }
        }
        Command::Health => health(config.http.listen),
        Command::Key { command: KeyCommand::New { name } } => new_key(&name),
        Command::Key { command: KeyCommand::Webhooks { name } } => webhook_secret(&config, name.as_deref()),
        Command::Solve { request, output, with } => solve_file(&config, &request, &output, with.as_deref()),
        command => {
            if let Err(message) = telemetry::init_logs(&config.log) {
                return fail(USAGE, &message);
            }
            if let Err(message) = app::check_address_space(&config) {
                return fail(1, &message);
            }
            let runtime =
                tokio::runtime::Builder::new_multi_thread().enable_all().thread_stack_size(STACK_BYTES).build();
            let runtime = match runtime {
                Ok(runtime) => runtime,
                Err(error) => return fail(1, &error.to_string()),
            };
            let role = role(&command);
            let ended = runtime.block_on(app::run(config, role));
            // A thread may still run a solver that does not answer. Another may wait for standard input, which nothing
            // can interrupt.
            runtime.shutdown_background();
            match ended {
                Ok(()) => ExitCode::SUCCESS,
                Err(app::StartError::Configuration(message)) => fail(USAGE, &message),
                Err(app::StartError::Failed(message)) => fail(1, &message),
            }
        }
    }
}

fn fail(status: u8, message: &str) -> ExitCode {
    eprintln!("plateau: {message}");
    ExitCode::from(status)
}

fn health(listen: SocketAddr) -> ExitCode {
    const PATIENCE: Duration = Duration::from_secs(3);
    let address = match listen.ip() {
        IpAddr::V4(ip) if ip.is_unspecified() => IpAddr::V4(Ipv4Addr::LOCALHOST),
        IpAddr::V6(ip) if ip.is_unspecified() => IpAddr::V6(Ipv6Addr::LOCALHOST),
        ip => ip,
    };
    let ask = || -> std::io::Result<String> {
        let mut stream = TcpStream::connect_timeout(&SocketAddr::new(address, listen.port()), PATIENCE)?;
        stream.set_read_timeout(Some(PATIENCE))?;
        stream.set_write_timeout(Some(PATIENCE))?;
        stream.write_all(b"GET /health/live HTTP/1.1\r\nHost: localhost\r\nConnection: close\r\n\r\n")?;
        let mut answer = String::new();
        stream.read_to_string(&mut answer)?;
        Ok(answer)
    };
    match ask() {
        Ok(answer) if answer.starts_with("HTTP/1.1 200 ") => ExitCode::SUCCESS,
        Ok(answer) => fail(1, &format!("{address}: {}", answer.lines().next().unwrap_or("no answer"))),
        Err(error) => fail(1, &format!("{address}: {error}")),
    }
}

fn new_key(name: &str) -> ExitCode {
    if !auth::is_key_name(name) {
        return fail(USAGE, "NAME must have 1 to 64 letters, digits, dots, dashes or underscores");
    }
    match auth::new_key() {
        Ok((key, digest)) => {
            println!("key for the client, shown only now: {key}");
            println!("line for auth.keys_file:            {name} {digest}");
            ExitCode::SUCCESS
        }
        Err(message) => fail(1, &message),
    }
}

fn webhook_secret(config: &Config, name: Option<&str>) -> ExitCode {
    match Secret::load(&config.webhooks) {
        Ok(Some(secret)) => {
            secret.of(name).iter().for_each(|secret| println!("{secret}"));
            ExitCode::SUCCESS
        }
        Ok(None) => fail(USAGE, "webhooks.secret_file is not set: webhooks are off"),
        Err(message) => fail(USAGE, &message),
    }
}

/// A file that `solve` writes.
enum File {
    Mesh(MeshFormat),
    Drawing(Vec<(String, String)>),
}

impl File {
    /// Returns the file with this extension. `query` has the parameters of drawings and schedules.
    fn with(extension: &str, query: Option<&str>) -> Result<Self, String> {
        let mut given = parameters::pairs(query);
        let format = given.iter().find(|(name, _)| name == "format").map(|(_, format)| format.clone());
        let is_mesh = MeshFormat::from_name(extension).filter(|_| format.as_deref() != Some(extension));
        if let Some(format) = is_mesh {
            return Ok(Self::Mesh(format));
        }
        if format.is_none() && extension != "zip" {
            given.push(("format".into(), extension.into()));
        }
        // A wrong query is refused before anything is solved. The result decides between pattern and schedule.
        let pattern = PatternOptions::read(&given).map(|options| options.extension());
        let schedule = ScheduleOptions::read(&given).map(|options| options.extension());
        let is_schedule = given.iter().any(|(name, _)| name == "part");
        let made = if is_schedule { schedule } else { pattern.or_else(|refused| schedule.map_err(|_| refused)) };
        match made {
            Ok(made) if made == extension => Ok(Self::Drawing(given)),
            Ok(made) => Err(format!("the extension must be {made} with these parameters")),
            Err(refused) => Err(refused.to_string()),
        }
    }

    fn bytes(&self, archive: &Archive) -> Result<Vec<u8>, String> {
        let contents = archive.contents();
        let text = |refused: Refused| refused.to_string();
        match self {
            Self::Mesh(format) => format.encode(archive).map_err(|error| error.to_string()),
            Self::Drawing(given) if contents.unrolls && given.iter().all(|(name, _)| name != "part") => {
                PatternOptions::read(given).and_then(|options| pattern(contents, &options)).map_err(text)
            }
            Self::Drawing(given) => {
                ScheduleOptions::read(given).and_then(|options| schedule(contents, &options)).map_err(text)
            }
        }
    }
}

fn solve_file(config: &Config, request: &PathBuf, outputs: &[PathBuf], with: Option<&str>) -> ExitCode {
    let mut files = Vec::new();
    for output in outputs {
        let extension = output.extension().and_then(|extension| extension.to_str()).unwrap_or_default();
        match File::with(extension, with) {
            Ok(file) => files.push((output, file)),
            Err(message) => return fail(USAGE, &format!("{}: {message}", output.display())),
        }
    }
    let mut body = Vec::new();
    let read = if request.as_os_str() == "-" {
        std::io::stdin().read_to_end(&mut body).map(|_| ())
    } else {
        std::fs::read(request).map(|bytes| body = bytes)
    };
    if let Err(error) = read {
        return fail(USAGE, &format!("{}: {error}", request.display()));
    }
    let request = match Incoming::read_with_kind(&body, &config.limits) {
        Ok(incoming) => incoming.request,
        Err(rejection) => return fail(1, &rejection_text(&rejection)),
    };
    let bar = ProgressBar::new(1000);
    if let Ok(style) = ProgressStyle::with_template("{bar:30} {percent:>3}% {elapsed} {msg}") {
        bar.set_style(style);
    }
    let report = |progress: Progress| {
        bar.set_position((progress.fraction * 1000.0) as u64);
        bar.set_message(format!("{} {}", progress.phase, progress.iteration));
    };
    let solved = request.solve(&|| Signal::Continue, &report);
    bar.finish_and_clear();
    let solved = match solved {
        Ok(solved) => solved,
        Err(Unsolved::Cancelled) => return fail(1, "cancelled"),
        Err(Unsolved::Failed(error)) => {
            let message = format!("{}: {}", error.title, error.detail);
            return fail(1, &format!("{}\ntype: {}", lines(&message, &error.errors), error.kind));
        }
    };
    for warning in &solved.warnings {
        eprintln!("warning: {}: {}", warning.code, warning.detail);
    }
    for (output, file) in files {
        let written = file.bytes(&solved.archive);
        let written = written.and_then(|bytes| std::fs::write(output, bytes).map_err(|error| error.to_string()));
        if let Err(message) = written {
            return fail(1, &format!("{}: {message}", output.display()));
        }
    }
    let statistics: serde_json::Value = serde_json::from_str(&solved.statistics).unwrap_or_default();
    let text = serde_json::to_string_pretty(&statistics).unwrap_or_default();
    match writeln!(std::io::stdout(), "{text}") {
        Ok(()) => ExitCode::SUCCESS,
        Err(error) => fail(1, &error.to_string()),
    }
}

fn rejection_text(rejection: &Rejection) -> String {
    match rejection {
        Rejection::Malformed(detail) => format!("the request is not well-formed JSON: {detail}"),
        Rejection::Invalid(errors) | Rejection::TooLarge(errors) => lines("the request is invalid:", errors),
    }
}

/// Returns the message, followed by one line for each offending value.
fn lines(message: &str, errors: &[FieldError]) -> String {
    let mut text = message.to_owned();
    for FieldError { pointer, detail } in errors.iter().take(MAX_ERRORS) {
        let pointer = if pointer.is_empty() { "/" } else { pointer };
        text.push_str(&format!("\n  {pointer}: {detail}"));
    }
    text
}
