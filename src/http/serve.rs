//! Accepts HTTP/1.1 connections. Their number is bounded, and clients have limited time to send headers.
//!
//! If the maximum number of connections is open, a new one replaces the connection that has been idle for longest. A
//! connection is idle while no request of it is being answered. A connection that has not sent its request's headers
//! yet counts as idle.

use crate::config::HttpConfig;
use axum::Router;
use axum::body::{Body, Bytes};
use axum::extract::ConnectInfo;
use axum::http::{Request, Response};
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
                let permit = connections.permit().await;
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
    /// One permit for each connection that may be open.
    permits: Arc<Semaphore>,
    max_open: u32,
    open: Arc<Open>,
    closing: watch::Sender<bool>,
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
    /// Wakes the connection's task when the connection has been dismissed.
    dismissed: Notify,
}

/// Marks a connection that is answering a request.
const BUSY: u64 = u64::MAX;
/// Marks an idle connection that must close to make room for another one.
const DISMISSED: u64 = u64::MAX - 1;
/// Time that a dismissed connection has to send the end of its last response, which may still be in a buffer.
const FLUSH_TIMEOUT: Duration = Duration::from_secs(1);
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

    /// Dismisses the connection that has been idle for longest. Returns false if none is idle.
    fn dismiss_longest_idle(&self) -> bool {
        let connections = self.connections();
        loop {
            let since = |activity: &Arc<Activity>| activity.idle_since.load(Ordering::Relaxed);
            let idle =
                connections.values().map(|activity| (since(activity), activity)).filter(|(at, _)| *at < DISMISSED);
            let Some((at, activity)) = idle.min_by_key(|(at, _)| *at) else { return false };
            // If a request arrived in between, the loop chooses another connection.
            let dismissed = activity.idle_since.compare_exchange(at, DISMISSED, Ordering::Relaxed, Ordering::Relaxed);
            if dismissed.is_ok() {
                activity.dismissed.notify_one();
                return true;
            }
        }
    }
}

impl Connections {
    fn new(config: &HttpConfig, router: Router) -> Self {
        let mut http = http1::Builder::new();
        http.timer(TokioTimer::new()).header_read_timeout(Duration::from_millis(config.header_timeout_ms));
        let max_open = u32::try_from(config.connections).unwrap_or(u32::MAX).min(Semaphore::MAX_PERMITS as u32);
        Self {
            http,
            router,
            permits: Arc::new(Semaphore::new(max_open as usize)),
            max_open,
            open: Arc::default(),
            closing: watch::Sender::new(false),
        }
    }

    /// Waits for a permit for one more connection. If none is free, dismisses the connection that has been idle for
    /// longest.
    async fn permit(&self) -> OwnedSemaphorePermit {
        if let Ok(permit) = self.permits.clone().try_acquire_owned() {
            return permit;
        }
        let mut permit = std::pin::pin!(self.permits.clone().acquire_owned());
        loop {
            let dismissed = self.open.dismiss_longest_idle();
            tokio::select! {
                permit = &mut permit => return permit.expect("the semaphore is never closed"),
                () = self.open.became_idle.notified(), if !dismissed => {}
                // The dismissed connection may have received a request at the same moment, so another one is tried
                // after a while.
                () = tokio::time::sleep(FLUSH_TIMEOUT), if dismissed => {}
            }
        }
    }

    /// Serves a connection of this peer in its own task.
    fn start(&self, stream: TcpStream, peer: SocketAddr, permit: OwnedSemaphorePermit) {
        let open = self.open.clone();
        let number = open.tick();
        let activity = Arc::new(Activity {
            fresh: AtomicBool::new(true),
            idle_since: AtomicU64::new(number),
            dismissed: Notify::new(),
        });
        open.connections().insert(number, activity.clone());
        let router = self.router.clone();
        let service = {
            let (open, activity) = (open.clone(), activity.clone());
            service_fn(move |mut request: Request<Incoming>| {
                request.extensions_mut().insert(ConnectInfo(peer));
                activity.fresh.store(false, Ordering::Relaxed);
                activity.idle_since.store(BUSY, Ordering::Relaxed);
                let busy = Busy { open: open.clone(), activity: activity.clone() };
                answer(router.clone(), request, busy)
            })
        };
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
                // hyper would wait for the first request of a connection that has not sent one.
                if activity.fresh.load(Ordering::Relaxed) {
                    break;
                }
                // If a request is being answered, it is the last one of this connection.
                leaving = true;
                connection.as_mut().graceful_shutdown();
            }
            open.connections().remove(&number);
            drop(permit);
        });
    }

    /// Ends idle connections at once, and other connections after their current request. After `grace` the rest is
    /// dropped.
    async fn close(&self, grace: Duration) {
        self.closing.send_replace(true);
        if tokio::time::timeout(grace, self.permits.acquire_many(self.max_open)).await.is_err() {
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

async fn answer(router: Router, request: Request<Incoming>, busy: Busy) -> Result<Response<Answering>, Infallible> {
    let response = router.oneshot(request).await?;
    Ok(response.map(|body| Answering { body, rest: Bytes::new(), _busy: busy }))
}

/// Body of a response, in pieces. The connection is busy until hyper has taken all of it.
struct Answering {
    body: Body,
    /// Part of the body's last frame that hyper has not taken yet.
    rest: Bytes,
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
            match ready!(Pin::new(&mut self.body).poll_frame(context)) {
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
