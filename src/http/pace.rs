//! A stream that fails if its client takes the answers too slowly.

use std::io;
use std::pin::Pin;
use std::task::{Context, Poll, ready};
use std::time::Duration;
use tokio::io::{AsyncRead, AsyncWrite, ReadBuf};
use tokio::time::{Instant, Sleep, sleep};

/// A stream whose writes fail with `TimedOut` if its peer is slower than the lowest rate. Only the time counts in which
/// a write waits for the peer, so an event stream may be silent as long as it likes.
#[derive(Debug)]
pub struct Paced<S> {
    stream: S,
    period: Duration,
    /// Number of bytes that the peer must take in each period.
    least_bytes: u64,
    /// Time in the current period that writes have waited.
    waited: Duration,
    /// Number of bytes written in the current period.
    written: u64,
    /// Start of the wait of the current write, and the end of the period if the write waits that long.
    waiting: Option<(Instant, Pin<Box<Sleep>>)>,
}

impl<S> Paced<S> {
    /// Returns a stream with this lowest rate. At a rate of 0, writes never fail.
    pub fn new(stream: S, bytes_per_s: u64, period: Duration) -> Self {
        let least_bytes = (u128::from(bytes_per_s) * period.as_millis()).div_ceil(1000);
        let least_bytes = u64::try_from(least_bytes).unwrap_or(u64::MAX);
        Self { stream, period, least_bytes, waited: Duration::ZERO, written: 0, waiting: None }
    }

    /// Counts the bytes of a write and the time that it waited. Replaces its result by an error if the peer is too
    /// slow.
    fn note(&mut self, context: &mut Context<'_>, result: Poll<io::Result<usize>>) -> Poll<io::Result<usize>> {
        if self.least_bytes == 0 {
            return result;
        }
        match result {
            Poll::Ready(result) => {
                if let Some((since, _)) = self.waiting.take() {
                    self.waited += since.elapsed();
                }
                if let Ok(count) = result {
                    self.written += count as u64;
                }
                if self.waited >= self.period {
                    self.next_period()?;
                }
                Poll::Ready(result)
            }
            Poll::Pending => loop {
                let left = self.period.saturating_sub(self.waited);
                let (_, end) = self.waiting.get_or_insert_with(|| (Instant::now(), Box::pin(sleep(left))));
                ready!(end.as_mut().poll(context));
                self.waiting = None;
                self.next_period()?;
            },
        }
    }

    fn next_period(&mut self) -> io::Result<()> {
        if self.written < self.least_bytes {
            return Err(io::Error::new(io::ErrorKind::TimedOut, "the client takes the answer too slowly"));
        }
        (self.waited, self.written) = (Duration::ZERO, 0);
        Ok(())
    }
}

impl<S: AsyncRead + Unpin> AsyncRead for Paced<S> {
    fn poll_read(
        mut self: Pin<&mut Self>,
        context: &mut Context<'_>,
        buffer: &mut ReadBuf<'_>,
    ) -> Poll<io::Result<()>> {
        Pin::new(&mut self.stream).poll_read(context, buffer)
    }
}

impl<S: AsyncWrite + Unpin> AsyncWrite for Paced<S> {
    fn poll_write(mut self: Pin<&mut Self>, context: &mut Context<'_>, bytes: &[u8]) -> Poll<io::Result<usize>> {
        let result = Pin::new(&mut self.stream).poll_write(context, bytes);
        self.note(context, result)
    }

    fn poll_write_vectored(
        mut self: Pin<&mut Self>,
        context: &mut Context<'_>,
        parts: &[io::IoSlice<'_>],
    ) -> Poll<io::Result<usize>> {
        let result = Pin::new(&mut self.stream).poll_write_vectored(context, parts);
        self.note(context, result)
    }

    fn is_write_vectored(&self) -> bool {
        self.stream.is_write_vectored()
    }

    fn poll_flush(mut self: Pin<&mut Self>, context: &mut Context<'_>) -> Poll<io::Result<()>> {
        Pin::new(&mut self.stream).poll_flush(context)
    }

    fn poll_shutdown(mut self: Pin<&mut Self>, context: &mut Context<'_>) -> Poll<io::Result<()>> {
        Pin::new(&mut self.stream).poll_shutdown(context)
    }
}
