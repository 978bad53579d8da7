//! Wires configuration, keys, store, jobs and HTTP together, starts them and shuts them down.

use crate::auth::Keys;
use crate::config::{Config, HttpConfig};
use crate::http::budget::Budget;
#[cfg(feature = "mcp")]
use crate::http::mcp;
use crate::http::open_requests::OpenRequests;
use crate::http::state::App;
use crate::http::{openapi, router, serve};
use crate::jobs::{self, Jobs, callbacks, counters, worker};
use crate::store::{Store, StoreError, StoreOptions, Swept, redacted};
use crate::telemetry;
use crate::threads::STACK_BYTES;
use crate::webhook::Sender;
use rustix::process::{Resource, Rlimit};
use std::net::SocketAddr;
use std::sync::Arc;
use std::time::{Duration, Instant};
use tokio::net::TcpListener;
use tokio::task::JoinHandle;

/// Role of this process.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Role {
    /// HTTP and workers.
    Serve,
    /// Workers only.
    Worker,
    /// HTTP, workers, and tools for a language model on standard input and output.
    Mcp,
}

/// Reason why the process did not start.
#[derive(Debug)]
pub enum StartError {
    Configuration(String),
    Failed(String),
}

/// Time to wait for a database server, which may start at the same time as this process.
const START_PATIENCE: Duration = Duration::from_secs(30);
/// Interval between two sweeps while the store takes jobs and results.
const SWEEP_INTERVAL: Duration = Duration::from_secs(60);
/// Interval between two sweeps while the store refuses jobs or results.
const URGENT_SWEEP_INTERVAL: Duration = Duration::from_secs(5);
/// Time since the last sweep after which another process takes over the task of sweeping.
const SWEEP_LEAD: Duration = Duration::from_secs(150);
/// Size of the ballast file, whose space is given up on a full disk: 8 MiB for the results of accepted jobs, and 24 MiB
/// for a sweep, which copies up to 16 MiB of the write-ahead log and writes a few megabytes.
const BALLAST_BYTES: u64 = 32 << 20;

/// Runs until the process is told to stop (SIGTERM, Ctrl-C). In the role [`Role::Mcp`] it also stops when standard
/// input ends.
///
/// # Errors
/// Fails if a setting is invalid, or if the store cannot be opened or an address cannot be bound.
pub async fn run(config: Config, role: Role) -> Result<(), StartError> {
    let (keys, webhooks) = check(&config, role).map_err(StartError::Configuration)?;
    let config = Arc::new(Config { http: with_descriptors(config.http, role), ..config });
    warn_without_keys(&keys, &config);
    let (keys, address) = (Arc::new(keys), config.http.listen);
    // Jobs and results belong to their clients, so no other user of this machine may read the files of this process.
    rustix::process::umask(rustix::fs::Mode::RWXG | rustix::fs::Mode::RWXO);
    let metrics = telemetry::init_metrics().map_err(StartError::Failed)?;
    counters::start_at_zero();
    let store = open_store(&config).await?;
    let listener = match role {
        Role::Worker => None,
        Role::Serve | Role::Mcp => {
            let bound = TcpListener::bind(address).await;
            Some(bound.map_err(|error| StartError::Failed(format!("http.listen {address}: {error}")))?)
        }
    };
    let jobs = Jobs::new(store.clone(), config.clone(), webhooks)
        .map_err(|error| StartError::Failed(format!("starting the threads for conversions: {error}")))?;
    let own_metrics = !config.http.metrics_listen.is_empty();
    if own_metrics {
        let address = &config.http.metrics_listen;
        let bound = TcpListener::bind(address).await;
        let listener = bound.map_err(|error| StartError::Failed(format!("http.metrics_listen {address}: {error}")))?;
        let routes = router::metrics(jobs.clone(), metrics.clone());
        let (config, jobs) = (config.clone(), jobs.clone());
        tokio::spawn(async move { serve::serve(listener, routes, &config.http, jobs.shutdown()).await });
    }
    let count = jobs.solvers();
    jobs.spawn_workers();
    let tasks = [
        tokio::spawn(callbacks::run(jobs.clone())),
        tokio::spawn(telemetry::keep_up(metrics.clone())),
        tokio::spawn(worker::make_room(jobs.clone())),
        tokio::spawn(sweep(store.clone())),
        tokio::spawn(follow_keys(keys.clone())),
    ];
    let stopping = jobs.clone();
    tokio::spawn(async move {
        stop_signal().await;
        tracing::info!("shutting down");
        stopping.shut_down();
    });
    if let Some(listener) = listener {
        let address = listener.local_addr().map_err(|error| StartError::Failed(error.to_string()))?;
        match role {
            // Standard output belongs to the protocol.
            Role::Mcp => eprintln!("listening on http://{address}"),
            Role::Serve | Role::Worker => println!("listening on http://{address}"),
        }
        log_doors(&config.http, address, count, role);
        let (http, limits) = (&config.http, &config.limits);
        let bodies = Budget::new(http.bodies_in_flight_bytes, http.bodies_share_percent, limits.body_bytes);
        let seats = Arc::new(OpenRequests::new(config.open_requests()));
        let (own_config, own_jobs, bodies) = (config.clone(), jobs.clone(), Arc::new(bodies));
        let document = openapi::served_at;
        let app = App { config: own_config, jobs: own_jobs, metrics, bodies, seats, keys, document };
        #[cfg(feature = "mcp")]
        let tools = (role == Role::Mcp).then(|| tokio::spawn(mcp::serve_stdio(app.clone(), address)));
        let until_input_ends = async {
            #[cfg(feature = "mcp")]
            if let Some(tools) = tools {
                // The task fails only if it panics. The process stops then too.
                let _ = tools.await;
                jobs.shut_down();
            }
        };
        let serving = serve::serve(listener, router::router(app), &config.http, jobs.shutdown());
        tokio::join!(serving, until_input_ends);
    }
    jobs.idle().await;
    // If shutdown interrupts a webhook attempt, another process repeats it.
    tasks.iter().for_each(JoinHandle::abort);
    store.close().await;
    Ok(())
}

/// Warns of a file for keys that has none, because a server on a loopback address then serves everybody.
fn warn_without_keys(keys: &Keys, config: &Config) {
    if keys.file_is_empty() {
        tracing::warn!(
            file = %config.auth.keys_file.display(),
            "auth.keys_file has no keys: every client may do everything until a key is added"
        );
    }
}

/// Logs where the service can be reached, and which of its doors are shut.
fn log_doors(http: &HttpConfig, address: SocketAddr, workers: usize, role: Role) {
    if http.studio {
        tracing::info!(%address, workers, "open http://{address}/ in a browser");
    } else {
        tracing::info!(%address, workers, "the studio is off (http.studio)");
    }
    if !http.hops {
        tracing::info!("Hops is off (http.hops)");
    }
    if !http.mcp && role == Role::Serve {
        tracing::info!("MCP over HTTP is off (http.mcp)");
    }
}

async fn follow_keys(keys: Arc<Keys>) {
    tokio::join!(keys.follow_file(), keys.forget());
}

/// Fails if the limit of the address space leaves no room for the threads of this process. A thread that cannot be
/// started, or a heap that cannot be extended, would end the process later without a word about the cause.
///
/// # Errors
/// Returns a message that names the limit.
pub fn check_address_space(config: &Config) -> Result<(), String> {
    /// Address space that the allocator reserves for a thread, in bytes.
    const HEAP_BYTES: u64 = 64 << 20;
    /// Threads with small stacks: those of the store, of the clock and of name lookups.
    const SMALL_THREADS: u64 = 16;
    /// The program, its libraries and the cache of files.
    const PROGRAM_BYTES: u64 = 256 << 20;
    let Some(limit) = rustix::process::getrlimit(Resource::As).current else { return Ok(()) };
    let cores = std::thread::available_parallelism().map_or(1, std::num::NonZero::get);
    // Each core has a thread of the runtime, and there is one more converter than cores.
    let solvers = config.jobs.workers.unwrap_or(cores) + config.small_workers();
    let threads = (2 * cores.max(2) + 1 + solvers) as u64;
    let needed = threads * (STACK_BYTES as u64 + HEAP_BYTES) + SMALL_THREADS * HEAP_BYTES / 2 + PROGRAM_BYTES;
    if limit >= needed {
        return Ok(());
    }
    Err(format!(
        "the limit of the address space (ulimit -v) is {} MiB, and the threads of this process need {} MiB: raise it, set \
         jobs.workers, or limit the memory by a control group instead",
        limit >> 20,
        needed.div_ceil(1 << 20)
    ))
}

/// File descriptors of a process besides those of its connections: the store's, the cached files', the logs', and those
/// of messages to callback URLs.
const OTHER_DESCRIPTORS: u64 = 200;

/// Raises the limit of file descriptors as far as the connections need and the system allows. If that is not enough,
/// returns settings with fewer connections.
fn with_descriptors(http: HttpConfig, role: Role) -> HttpConfig {
    if role == Role::Worker {
        return http;
    }
    let needed = (http.connections as u64).saturating_add(OTHER_DESCRIPTORS);
    let limit = rustix::process::getrlimit(Resource::Nofile);
    // The absence of a limit is `None`.
    let Some(soft) = limit.current.filter(|soft| *soft < needed) else { return http };
    let raised = limit.maximum.map_or(needed, |hard| hard.min(needed)).max(soft);
    let set = rustix::process::setrlimit(Resource::Nofile, Rlimit { current: Some(raised), ..limit });
    let available = if set.is_ok() { raised } else { soft };
    if available >= needed {
        return http;
    }
    // At least half of the descriptors stay for connections, however few there are.
    let connections = available.saturating_sub(OTHER_DESCRIPTORS).max(available / 2).max(1) as usize;
    tracing::warn!(
        descriptors = available,
        needed,
        connections,
        "the limit of file descriptors (ulimit -n) is too low for http.connections; fewer connections are taken"
    );
    HttpConfig { connections: connections.min(http.connections), ..http }
}

/// Checks all settings on which a start depends, without changing anything and without reaching the database. Returns
/// the keys and the sender of messages, which are read from files.
///
/// # Errors
/// Returns a message that names the setting.
pub fn check(config: &Config, role: Role) -> Result<(Keys, Option<Sender>), String> {
    let (keys, address) = (Keys::load(&config.auth)?, config.http.listen);
    telemetry::filter(&config.log)?;
    Store::check_places(&config.database_url(), &config.store.results)
        .map_err(|error| format!("store.database or store.results: {error}"))?;
    if role == Role::Worker && config.jobs.workers == Some(0) && config.small_workers() == 0 {
        return Err("jobs.workers is 0: this process would do nothing".into());
    }
    if role == Role::Mcp && keys.required() {
        return Err(
            "plateau mcp serves one user, whose links carry no key: remove auth.keys and auth.keys_file, or use the \
             setting http.mcp of plateau serve"
                .into(),
        );
    }
    if role != Role::Worker && !keys.required() && !address.ip().is_loopback() && !config.auth.open_without_keys {
        return Err(format!(
            "http.listen {address} is open to others: configure auth.keys or auth.keys_file, or set \
             auth.open_without_keys"
        ));
    }
    Ok((keys, Sender::load(&config.webhooks)?))
}

async fn open_store(config: &Config) -> Result<Store, StartError> {
    if config.store.database.is_empty() {
        let folder = &config.store.data;
        std::fs::create_dir_all(folder)
            .map_err(|error| StartError::Failed(format!("store.data {}: {error}", folder.display())))?;
    }
    let results = &config.store.results;
    let embedded = config.database_url().starts_with("sqlite:");
    let results = match (results.is_empty(), embedded) {
        (false, _) => Some(results.clone()),
        (true, true) => Some(config.store.data.join("results").display().to_string()),
        (true, false) => None,
    };
    let forever_s = 100 * 365 * 24 * 3600;
    let retention_s = if config.jobs.retention_s == 0 { forever_s } else { config.jobs.retention_s };
    let options = StoreOptions {
        queue_limit: config.jobs.queue_length as u64,
        owner_queue_limit: config.owner_queue_length() as u64,
        max_attempts: config.jobs.attempts_max,
        unread_patience: Duration::from_secs(config.jobs.unread_s),
        lease: Duration::from_millis(config.jobs.lease_ms),
        retention: Duration::from_secs(retention_s),
        max_jobs: config.store.max_jobs,
        max_bytes: (config.store.max_bytes > 0).then_some(config.store.max_bytes),
        results,
        inline_bytes: config.store.inline_bytes,
        connections: config.store.connections,
        result_version: jobs::result_version(),
        ballast_bytes: if embedded { BALLAST_BYTES } else { 0 },
        note_failed: counters::note_failed,
        ..StoreOptions::default()
    };
    let given_up = Instant::now() + START_PATIENCE;
    loop {
        match Store::open(&config.database_url(), options.clone()).await {
            Ok(store) => return Ok(store),
            Err(StoreError::Url(message)) => {
                return Err(StartError::Configuration(format!("store.database or store.results: {message}")));
            }
            Err(error @ StoreError::Refused(_)) => {
                return Err(StartError::Configuration(format!("store.database: {error}")));
            }
            Err(error) if embedded || !error.may_pass() || Instant::now() > given_up => {
                return Err(StartError::Failed(format!("store: {error}")));
            }
            Err(error) => {
                tracing::warn!(%error, database = %redacted(&config.database_url()), "waiting for the database");
                tokio::time::sleep(Duration::from_millis(500)).await;
            }
        }
    }
}

/// Sweeps the store every minute, and every 5 s while the store refuses jobs or results, unless another process on the
/// same database sweeps it. Looks for lost leases at least three times within the length of a lease, because a longer
/// pause between two such looks counts as an outage of the database.
async fn sweep(store: Store) {
    let mut swept_at = None;
    loop {
        let interval = if store.check_room_for_results().is_err() { URGENT_SWEEP_INTERVAL } else { SWEEP_INTERVAL };
        if swept_at.is_none_or(|at: Instant| at.elapsed() >= interval) {
            swept_at = Some(Instant::now());
            let swept = match store.leads_the_sweep(SWEEP_LEAD).await {
                Ok(true) => store.sweep().await,
                Ok(false) => Ok(Swept::default()),
                Err(error) => Err(error),
            };
            match swept {
                Ok(swept) if swept.expired + swept.artefacts + swept.recovered as u64 > 0 => {
                    tracing::info!(swept.expired, swept.artefacts, swept.recovered, "swept");
                }
                Ok(_) => {}
                Err(error) => tracing::warn!(%error, "cannot sweep the store"),
            }
            if interval == URGENT_SWEEP_INTERVAL {
                store.probe_results().await;
            }
        }
        tokio::time::sleep(URGENT_SWEEP_INTERVAL.min(store.options().lease / 3)).await;
        if let Err(error) = store.recover().await {
            tracing::warn!(%error, "cannot look for lost leases");
        }
    }
}

async fn stop_signal() {
    let interrupt = tokio::signal::ctrl_c();
    #[cfg(unix)]
    {
        use tokio::signal::unix::{SignalKind, signal};
        match signal(SignalKind::terminate()) {
            Ok(mut terminate) => {
                tokio::select! { _ = interrupt => {}, _ = terminate.recv() => {} }
            }
            Err(error) => {
                tracing::warn!(%error, "cannot listen for SIGTERM");
                let _ = interrupt.await;
            }
        }
    }
    #[cfg(not(unix))]
    {
        let _ = interrupt.await;
    }
}
