//! Limits the number of requests that one client has open at once, so that the event streams, waits and downloads of
//! one client leave connections for others.

use axum::extract::ConnectInfo;
use axum::http::Extensions;
use std::collections::HashMap;
use std::net::{IpAddr, Ipv6Addr, SocketAddr};
use std::sync::{Arc, Mutex, MutexGuard, PoisonError};

/// Open requests of each client.
#[derive(Debug)]
pub struct OpenRequests {
    most: usize,
    taken: Mutex<HashMap<Arc<str>, usize>>,
}

/// Counts one open request of a client until it is dropped.
#[derive(Debug)]
pub struct OpenRequest {
    seats: Arc<OpenRequests>,
    client: Arc<str>,
}

/// Marks a request that came while the maximum number of connections was open, if no connection ended in time to make
/// room for it.
#[derive(Clone, Copy, Debug)]
pub struct NoConnection;

/// Returns a name for the address that a request came from. An IPv6 address stands for its network of 64 bits, because
/// one client may have all addresses in it.
#[must_use]
pub fn address(extensions: &Extensions) -> String {
    let ConnectInfo(peer) = match extensions.get::<ConnectInfo<SocketAddr>>() {
        Some(info) => info,
        None => return String::new(),
    };
    match peer.ip() {
        IpAddr::V6(address) if address.to_ipv4_mapped().is_none() => {
            Ipv6Addr::from_bits(address.to_bits() >> 64 << 64).to_string()
        }
        address => address.to_canonical().to_string(),
    }
}

impl OpenRequests {
    /// Creates seats, of which each client may take `most` at once.
    #[must_use]
    pub fn new(most: usize) -> Self {
        Self { most, taken: Mutex::default() }
    }

    /// Returns the number of requests that each client may have open.
    #[must_use]
    pub fn most(&self) -> usize {
        self.most
    }

    fn taken(&self) -> MutexGuard<'_, HashMap<Arc<str>, usize>> {
        self.taken.lock().unwrap_or_else(PoisonError::into_inner)
    }

    /// Returns a seat for this client, or `None` if the client already holds the maximum number of seats.
    pub fn take(self: &Arc<Self>, client: &str) -> Option<OpenRequest> {
        let client: Arc<str> = client.into();
        let mut taken = self.taken();
        let count = taken.entry(client.clone()).or_default();
        if *count >= self.most {
            return None;
        }
        *count += 1;
        Some(OpenRequest { seats: self.clone(), client })
    }
}

impl Drop for OpenRequest {
    fn drop(&mut self) {
        let mut taken = self.seats.taken();
        if let Some(count) = taken.get_mut(&self.client) {
            *count -= 1;
            if *count == 0 {
                taken.remove(&self.client);
            }
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_client_has_its_share_of_seats_and_leaves_the_rest_to_others() {
        let seats = Arc::new(OpenRequests::new(2));
        let (first, second) = (seats.take("alice"), seats.take("alice"));
        assert!(first.is_some() && second.is_some() && seats.take("alice").is_none());
        assert!(seats.take("bob").is_some());
        drop(first);
        assert!(seats.take("alice").is_some());
        drop(second);
        assert!(seats.taken().is_empty());
    }

    #[test]
    fn the_addresses_of_one_network_are_one_client() {
        let name = |peer: &str| {
            let mut extensions = Extensions::new();
            extensions.insert(ConnectInfo(peer.parse::<SocketAddr>().unwrap()));
            address(&extensions)
        };
        assert_eq!(name("[2001:db8::1]:80"), name("[2001:db8::ffff:1]:81"));
        assert_ne!(name("[2001:db8::1]:80"), name("[2001:db8:0:1::1]:80"));
        assert_eq!(name("[::ffff:10.0.0.1]:80"), name("10.0.0.1:80"));
        assert_ne!(name("10.0.0.1:80"), name("10.0.0.2:80"));
    }
}
