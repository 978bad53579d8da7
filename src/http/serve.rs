//! Accepts HTTP/1.1 connections. Their number is bounded, and clients have limited time to send headers.
//!
//! If the maximum number of connections is open, a new one replaces the connection that has been idle for longest. A
//! connection is idle while no request of it is being answered. A connection that has not sent its request's headers
//! yet counts as idle. If none is idle, the new connection is an extra one: its health checks are answered, and its
//! other requests wait for up to [`PATIENCE`] until another connection ends.

use crate::auth::Removal;
use crate::config::HttpConfig;
use crate::http::access::is_health;
use crate::http::open_requests::{NoConnection, OpenRequest};
use crate::http::pace::Paced;
use axum::Router;
use axum::body::{Body, Bytes};
use axum::extract::ConnectInfo;
use axum::http::{Request, Response};
use futures_util::FutureExt;
use hyper::body::{Body as HttpBody, Frame, Incoming, SizeHint};
use hyper::server::conn::http1;
use hyper::service::service_fn;
use hyper_util::rt::{TokioIo, TokioTimer};
use std::collections::HashMap;
use std::convert::Infallible;
use std::future::Future;
use std::net::SocketAddr;
use std::pin::Pin;
use std::sync::atomic::{AtomicBool, AtomicU64, Ordering};
use std::sync::{Arc, Mutex, MutexGuard, PoisonError};
use std::task::{Context, Poll, ready};
use std::time::Duration;
use tokio::net::{TcpListener, TcpStream};
use tokio::sync::{Notify, OwnedSemaphorePermit, Semaphore, watch};
use tower::ServiceExt;

/// Serves until `shutdown` completes. After that it accepts connections for another `http.shutdown_notice_ms`, so that
/// load balancers see the changed readiness. Open requests then get `http.shutdown_grace_ms` to end.
pub async fn serve(listener: TcpListener, router: Router, config: &HttpConfig, shutdown: impl Future<Output = ()>) {
    let connections = Connections::new(config, router);
    let notice = Duration::from_millis(config.shutdown_notice_ms);
    let closing = async {
        shutdown.await;
        tokio::time::sleep(notice).await;
    };
    tokio::select! {
        () = accept(&listener, &connections) => {}
        () = closing => {}
    }
    drop(listener);
    connections.close(Duration::from_millis(config.shutdown_grace_ms)).await;
}

/// Accepts connections for ever.
async fn accept(listener: &TcpListener, connections: &Connections) {
    loop {
        match listener.accept().await {
            Ok((stream, peer)) => {
                // This disables Nagle's algorithm, so that small answers are not delayed.
                let _ = stream.set_nodelay(true);
                let permit = connections.place().await;
                connections.start(stream, peer, permit);
            }
            Err(error) => {
                // The most likely cause is a lack of file descriptors, so other connections must close first.
                tracing::warn!(%error, "cannot accept a connection");
                tokio::time::sleep(Duration::from_millis(50)).await;
            }
        }
    }
}

/// Open connections of a listener.
struct Connections {
    http: http1::Builder,
    router: Router,
    /// Permits of the connections that may be open.
    permits: Arc<Semaphore>,
    max_open: u32,
    /// Permits of the extra connections.
    extra: Arc<Semaphore>,
    /// Lowest rate and period of [`Paced`].
    pace: (u64, Duration),
    open: Arc<Open>,
    closing: watch::Sender<bool>,
}

/// Permit of an open connection, which is given back when it is dropped.
#[derive(Debug)]
enum ConnectionPermit {
    Ordinary {
        _permit: OwnedSemaphorePermit,
    },
    /// Permit of a connection beyond the maximum number.
    Extra {
        _permit: OwnedSemaphorePermit,
    },
}

/// Activity of each open connection.
#[derive(Default)]
struct Open {
    connections: Mutex<HashMap<u64, Arc<Activity>>>,
    /// Number of times that a connection became idle. The connection with the lowest number has been idle for longest.
    clock: AtomicU64,
    became_idle: Notify,
}

/// Activity of a connection.
struct Activity {
    /// True until the first request arrives.
    fresh: AtomicBool,
    /// Value of [`Open::clock`] when the connection became idle, or [`BUSY`], or [`DISMISSED`].
    idle_since: AtomicU64,
    permit: Mutex<ConnectionPermit>,
    /// Wakes the connection's task when the connection has been dismissed.
    dismissed: Notify,
}

impl Activity {
    fn permit(&self) -> MutexGuard<'_, ConnectionPermit> {
        self.permit.lock().unwrap_or_else(PoisonError::into_inner)
    }

    fn is_extra(&self) -> bool {
        matches!(*self.permit(), ConnectionPermit::Extra { .. })
    }
}

/// Number of connections beyond the maximum that may be open.
const EXTRA: usize = 64;
/// Time that a request on an extra connection waits until another connection ends. Health checks may wait as long if
/// all extra connections are waiting too.
const PATIENCE: Duration = Duration::from_secs(1);
/// Marks a connection that is answering a request.
const BUSY: u64 = u64::MAX;
/// Marks an idle connection that must close to make room for another one.
const DISMISSED: u64 = u64::MAX - 1;
/// Time limit for a dismissed connection to send the end of its last response, which may still be in a buffer.
const FLUSH_TIMEOUT: Duration = Duration::from_secs(1);
/// Size in bytes of a request's longest head, and of the part of an answer that waits for its client in memory.
const BUFFER_BYTES: usize = 128 << 10;
/// Size in bytes of the pieces in which hyper gets large bodies. A connection thus stays busy until all but the last
/// pieces are sent.
const PIECE_BYTES: usize = 64 << 10;

impl Open {
    fn connections(&self) -> MutexGuard<'_, HashMap<u64, Arc<Activity>>> {
        self.connections.lock().unwrap_or_else(PoisonError::into_inner)
    }

    fn tick(&self) -> u64 {
        self.clock.fetch_add(1, Ordering::Relaxed)
    }

    /// Dismisses the connection that has been idle for longest. Returns whether it is an extra one, or `None` if none
    /// is idle.
    fn dismiss_longest_idle(&self) -> Option<bool> {
        let connections = self.connections();
        loop {
            let since = |activity: &Arc<Activity>| activity.idle_since.load(Ordering::Relaxed);
            let idle =
                connections.values().map(|activity| (since(activity), activity)).filter(|(at, _)| *at < DISMISSED);
            let (at, activity) = idle.min_by_key(|(at, _)| *at)?;
            // If a request arrived in between, the loop chooses another connection.
            let dismissed = activity.idle_since.compare_exchange(at, DISMISSED, Ordering::Relaxed, Ordering::Relaxed);
            if dismissed.is_ok() {
                activity.dismissed.notify_one();
                return Some(activity.is_extra());
            }
        }
    }
}

impl Connections {
    fn new(config: &HttpConfig, router: Router) -> Self {
        let mut http = http1::Builder::new();
        http.timer(TokioTimer::new())
            .header_read_timeout(Duration::from_millis(config.header_timeout_ms))
            .max_buf_size(BUFFER_BYTES);
        let max_open = u32::try_from(config.connections).unwrap_or(u32::MAX).min(Semaphore::MAX_PERMITS as u32);
        Self {
            http,
            router,
            permits: Arc::new(Semaphore::new(max_open as usize)),
            max_open,
            extra: Arc::new(Semaphore::new(EXTRA)),
            pace: (config.answer_rate_bytes_per_s, Duration::from_millis(config.answer_rate_grace_ms)),
            open: Arc::default(),
            closing: watch::Sender::new(false),
        }
    }

    /// Waits for a place for one more connection. If none is free, dismisses the connection that has been idle for
    /// longest. If none is idle, the new connection is an extra one.
    async fn place(&self) -> ConnectionPermit {
        if let Ok(permit) = self.permits.clone().try_acquire_owned() {
            return ConnectionPermit::Ordinary { _permit: permit };
        }
        let mut permit = std::pin::pin!(self.permits.clone().acquire_owned());
        let mut extra = std::pin::pin!(self.extra.clone().acquire_owned());
        const OPEN: &str = "the semaphore is never closed";
        loop {
            let dismissed = self.open.dismiss_longest_idle();
            tokio::select! {
                biased;
                permit = &mut permit => return ConnectionPermit::Ordinary { _permit: permit.expect(OPEN) },
                extra = &mut extra, if dismissed != Some(false) => {
                    return ConnectionPermit::Extra { _permit: extra.expect(OPEN) };
                }
                () = self.open.became_idle.notified(), if dismissed.is_none() => {}
                // The dismissed connection may have received a request at the same moment, so another one is tried
                // after a while.
                () = tokio::time::sleep(FLUSH_TIMEOUT), if dismissed.is_some() => {}
            }
        }
    }

    /// Serves a connection of this peer in its own task.
    fn start(&self, stream: TcpStream, peer: SocketAddr, permit: ConnectionPermit) {
        let open = self.open.clone();
        let number = open.tick();
        let activity = Arc::new(Activity {
            fresh: AtomicBool::new(true),
            idle_since: AtomicU64::new(number),
            permit: Mutex::new(permit),
            dismissed: Notify::new(),
        });
        open.connections().insert(number, activity.clone());
        let router = self.router.clone();
        let service = {
            let (open, activity, permits) = (open.clone(), activity.clone(), self.permits.clone());
            service_fn(move |mut request: Request<Incoming>| {
                request.extensions_mut().insert(ConnectInfo(peer));
                activity.fresh.store(false, Ordering::Relaxed);
                activity.idle_since.store(BUSY, Ordering::Relaxed);
                let busy = Busy { open: open.clone(), activity: activity.clone() };
                let (router, permits) = (router.clone(), permits.clone());
                async move {
                    if !wait_for_place(&busy.activity, permits, request.uri().path()).await {
                        request.extensions_mut().insert(NoConnection);
                    }
                    answer(router, request, busy).await
                }
            })
        };
        let (bytes_per_s, period) = self.pace;
        let stream = Paced::new(stream, bytes_per_s, period);
        let connection = self.http.serve_connection(TokioIo::new(stream), service);
        let mut closing = self.closing.subscribe();
        tokio::spawn(async move {
            let mut connection = std::pin::pin!(connection);
            let (mut leaving, mut dismissed) = (false, false);
            loop {
                tokio::select! {
                    // A client that closes its connection is not an error.
                    _ = connection.as_mut() => break,
                    _ = closing.wait_for(|closing| *closing), if !leaving => {}
                    () = activity.dismissed.notified(), if !leaving => dismissed = true,
                    () = tokio::time::sleep(FLUSH_TIMEOUT), if dismissed => {
                        if activity.idle_since.load(Ordering::Relaxed) == BUSY {
                            dismissed = false;
                            continue;
                        }
                        break;
                    }
                }
                // A connection that has not sent a request is dropped, because hyper would wait for its first request
                // even during a graceful shutdown.
                if activity.fresh.load(Ordering::Relaxed) {
                    break;
                }
                // If a request is being answered, it is the last one of this connection.
                leaving = true;
                connection.as_mut().graceful_shutdown();
            }
            // This drops the permit, unless a request is still being answered.
            open.connections().remove(&number);
        });
    }

    /// Ends idle connections at once, and other connections after their current request. After `grace` the rest is
    /// dropped.
    async fn close(&self, grace: Duration) {
        self.closing.send_replace(true);
        let all = async {
            // Acquiring cannot fail, because the semaphores are never closed.
            let _ = self.permits.acquire_many(self.max_open).await;
            let _ = self.extra.acquire_many(EXTRA as u32).await;
        };
        if tokio::time::timeout(grace, all).await.is_err() {
            tracing::warn!("some requests were still open after the grace time");
        }
    }
}

/// Marks a connection as busy until it is dropped.
struct Busy {
    open: Arc<Open>,
    activity: Arc<Activity>,
}

impl Drop for Busy {
    fn drop(&mut self) {
        self.activity.idle_since.store(self.open.tick(), Ordering::Relaxed);
        self.open.became_idle.notify_one();
    }
}

/// Waits until an extra connection can become an ordinary one, unless its request is a health check. Returns false if
/// no other connection ends within [`PATIENCE`].
async fn wait_for_place(activity: &Activity, permits: Arc<Semaphore>, path: &str) -> bool {
    // The path may begin with the base path of this server.
    let last_part = path.rfind("/health/").map_or(path, |at| &path[at..]);
    if !activity.is_extra() || is_health(last_part) {
        return true;
    }
    match tokio::time::timeout(PATIENCE, permits.acquire_owned()).await {
        Ok(Ok(permit)) => *activity.permit() = ConnectionPermit::Ordinary { _permit: permit },
        Ok(Err(_)) | Err(_) => return false,
    }
    true
}

async fn answer(router: Router, request: Request<Incoming>, busy: Busy) -> Result<Response<Answering>, Infallible> {
    let mut response = router.oneshot(request).await?;
    let (seat, removal) = (response.extensions_mut().remove(), response.extensions_mut().remove());
    Ok(response.map(|body| Answering { body, rest: Bytes::new(), removal, _seat: seat, _busy: busy }))
}

/// Body of a response, in pieces. The connection is busy until hyper has taken all of it.
struct Answering {
    body: Body,
    /// Part of the body's last frame that hyper has not taken yet.
    rest: Bytes,
    /// Completes when the client's key is removed. The body then ends with an error.
    removal: Option<Removal>,
    _seat: Option<Arc<OpenRequest>>,
    _busy: Busy,
}

impl HttpBody for Answering {
    type Data = Bytes;
    type Error = axum::Error;

    fn poll_frame(
        mut self: Pin<&mut Self>,
        context: &mut Context<'_>,
    ) -> Poll<Option<Result<Frame<Bytes>, axum::Error>>> {
        if self.rest.is_empty() {
            let next = Pin::new(&mut self.body).poll_frame(context);
            if next.is_pending()
                && let Some(removal) = &mut self.removal
                && removal.poll_unpin(context).is_ready()
            {
                return Poll::Ready(Some(Err(axum::Error::new("the key was removed"))));
            }
            match ready!(next) {
                Some(Ok(frame)) => match frame.into_data() {
                    Ok(data) => self.rest = data,
                    Err(frame) => return Poll::Ready(Some(Ok(frame))),
                },
                other => return Poll::Ready(other),
            }
        }
        let length = self.rest.len().min(PIECE_BYTES);
        let piece = self.rest.split_to(length);
        Poll::Ready(Some(Ok(Frame::data(piece))))
    }

    fn is_end_stream(&self) -> bool {
        self.rest.is_empty() && self.body.is_end_stream()
    }

    fn size_hint(&self) -> SizeHint {
        let (rest, mut hint) = (self.rest.len() as u64, self.body.size_hint());
        if let Some(upper) = hint.upper() {
            hint.set_upper(upper + rest);
        }
        hint.set_lower(hint.lower() + rest);
        hint
    }
}
