//! Tickets for the event streams of browsers. `EventSource` cannot send an API key, so the page fetches a ticket with its
//! key and puts it into the address of the stream.
//!
//! A ticket has the form `NAME~TIME~CODE`: the name of the key, the time in seconds since 1970 at which the ticket expires,
//! and an HMAC-SHA256 of both and of the job's identifier in hex digits. It opens the event stream of this job and nothing
//! else. Every process on one database has the same secret, so a ticket of one process is valid at the others.

use super::{from_hex, hex};
use hmac::{Hmac, KeyInit, Mac};
use sha2::Sha256;
use std::time::{Duration, SystemTime, UNIX_EPOCH};

/// Time for which a ticket opens a stream. An open stream goes on after it. A shorter time makes a leaked address less
/// useful, and a longer one lets more broken streams reconnect by themselves.
const LIFETIME: Duration = Duration::from_secs(600);
const SEPARATOR: char = '~';

/// Issues and checks tickets.
pub struct Tickets {
    secret: Vec<u8>,
}

// Logs must not contain the secret.
impl std::fmt::Debug for Tickets {
    fn fmt(&self, formatter: &mut std::fmt::Formatter<'_>) -> std::fmt::Result {
        formatter.debug_struct("Tickets").finish_non_exhaustive()
    }
}

impl Tickets {
    #[must_use]
    pub fn new(secret: Vec<u8>) -> Self {
        Self { secret }
    }

    /// Returns a ticket for the events of a job, and the time at which it expires. `name` is the name of the caller's key,
    /// or empty on a server without keys.
    #[must_use]
    pub fn issue(&self, job: &str, name: &str, now: SystemTime) -> (String, SystemTime) {
        let expires_s = seconds(now + LIFETIME);
        let code = hex(&self.code(job, name, expires_s).finalize().into_bytes());
        let ticket = format!("{name}{SEPARATOR}{expires_s}{SEPARATOR}{code}");
        (ticket, UNIX_EPOCH + Duration::from_secs(expires_s))
    }

    /// Returns the name of the key that a valid ticket for the events of this job was issued to.
    #[must_use]
    pub fn check<'t>(&self, job: &str, ticket: &'t str, now: SystemTime) -> Option<&'t str> {
        let mut parts = ticket.split(SEPARATOR);
        let (name, expires_s, code) = (parts.next()?, parts.next()?, from_hex(parts.next()?)?);
        let expires_s = expires_s.parse().ok()?;
        // The comparison takes the same time wherever the codes differ.
        let genuine = parts.next().is_none() && self.code(job, name, expires_s).verify_slice(&code).is_ok();
        (genuine && seconds(now) < expires_s).then_some(name)
    }

    fn code(&self, job: &str, name: &str, expires_s: u64) -> Hmac<Sha256> {
        let mut code = Hmac::<Sha256>::new_from_slice(&self.secret).expect("HMAC takes keys of any length");
        code.update(format!("events{SEPARATOR}{job}{SEPARATOR}{name}{SEPARATOR}{expires_s}").as_bytes());
        code
    }
}

fn seconds(time: SystemTime) -> u64 {
    time.duration_since(UNIX_EPOCH).unwrap_or_default().as_secs()
}

#[cfg(test)]
mod tests {
    use super::*;

    const JOB: &str = "01J00000000000000000000000";

    #[test]
    fn a_ticket_is_valid_for_one_job_and_one_key_until_it_expires() {
        let (tickets, now) = (Tickets::new(b"secret".to_vec()), UNIX_EPOCH + Duration::from_secs(1_700_000_000));
        let (ticket, expires) = tickets.issue(JOB, "alice", now);
        assert_eq!(expires, now + LIFETIME);
        assert_eq!(tickets.check(JOB, &ticket, now), Some("alice"));
        assert_eq!(tickets.check(JOB, &ticket, expires - Duration::from_secs(1)), Some("alice"));
        assert_eq!(tickets.check(JOB, &ticket, expires), None);
        assert_eq!(tickets.check("01J00000000000000000000001", &ticket, now), None);
        assert_eq!(Tickets::new(b"other".to_vec()).check(JOB, &ticket, now), None);
        let (open, _) = tickets.issue(JOB, "", now);
        assert_eq!(tickets.check(JOB, &open, now), Some(""));
    }

    #[test]
    fn a_changed_ticket_is_refused() {
        let (tickets, now) = (Tickets::new(b"secret".to_vec()), UNIX_EPOCH + Duration::from_secs(1_700_000_000));
        let (ticket, _) = tickets.issue(JOB, "alice", now);
        for changed in [
            ticket.replace("alice", "bob"),
            ticket.replace("1700000600", "1700000601"),
            ticket.replace("1700000600", "x"),
            ticket[..ticket.len() - 1].to_owned(),
            format!("{ticket}~"),
            format!("{ticket}0"),
            "alice".into(),
            String::new(),
        ] {
            assert_eq!(tickets.check(JOB, &changed, now), None, "{changed}");
        }
    }
}
