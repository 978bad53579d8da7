//! Callbacks: messages to callback URLs. The row of a job or batch is itself the outbox. Its message is due once the
//! job or batch has ended, and stays due until it is settled. If the row is removed or expires, the message is dropped.
//! The row also has a line for each attempt, and keeps the URL of a settled message, so that it can be sent again.

use std::time::Duration;

use serde_json::json;

use super::tx::Tx;
use super::{Result, StoreError, milliseconds};

#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Subject {
    Job,
    Batch,
}

/// A callback that the claimer must attempt.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct Callback {
    pub subject: Subject,
    /// Identifier of the job or batch.
    pub id: String,
    pub owner: Option<String>,
    pub url: String,
    /// Host and port of the URL, as [`host_of`] returns them.
    pub host: String,
    /// Number of attempts since the message became due or was last sent again, including this one.
    pub attempts: i64,
    /// Number of all attempts so far. It tells this attempt from the others.
    number: i64,
}

impl Callback {
    /// Creates the first attempt of a callback that is in no store.
    #[cfg(test)]
    pub(crate) fn to(owner: Option<String>, url: &str) -> Self {
        let (id, url, host) = (String::new(), url.to_owned(), host_of(url));
        Self { subject: Subject::Job, id, owner, url, host, attempts: 1, number: 1 }
    }
}

/// How an attempt ended.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Delivery {
    Delivered,
    /// The attempt failed and will be repeated.
    Failed,
    /// The attempt failed and was the last.
    GivenUp,
    /// The receiver refused further attempts.
    Unwanted,
}

/// A line of the log of deliveries.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub struct Attempted {
    pub number: i64,
    pub at_ms: i64,
    pub delivery: Delivery,
}

/// State of the callback of a job or batch, with its attempts so far.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct CallbackRow {
    pub url: Option<String>,
    /// Time of the next attempt, or `None` if the message is settled. It is 0 until the message is claimed or sent
    /// again.
    pub next_ms: Option<i64>,
    /// Attempts so far, oldest first.
    pub attempted: Vec<Attempted>,
}

/// Owners and hosts whose callbacks are not claimed at present.
#[derive(Debug, Clone, Default, PartialEq, Eq)]
pub struct Busy {
    pub owners: Vec<Option<String>>,
    pub hosts: Vec<String>,
}

impl Delivery {
    pub const NAMES: [(Self, &str); 4] = [
        (Self::Delivered, "delivered"),
        (Self::Failed, "failed"),
        (Self::GivenUp, "given_up"),
        (Self::Unwanted, "unwanted"),
    ];

    #[must_use]
    pub fn name(self) -> &'static str {
        Self::NAMES.iter().find(|(delivery, _)| *delivery == self).map_or("", |(_, name)| name)
    }
}

/// Returns the host and port of a URL in lower case.
pub(super) fn host_of(url: &str) -> String {
    let authority = url.split_once("://").map_or(url, |(_, rest)| rest);
    authority.split(['/', '?', '#', '\\']).next().unwrap_or_default().to_lowercase()
}

impl Subject {
    const ALL: [Self; 2] = [Self::Job, Self::Batch];

    fn table(self) -> &'static str {
        match self {
            Self::Job => "jobs",
            Self::Batch => "batches",
        }
    }

    /// SQL condition for rows whose callback may be attempted now.
    fn due(self) -> &'static str {
        match self {
            Self::Job => "callback_url IS NOT NULL AND finished_at IS NOT NULL AND callback_at <= now_ms()",
            Self::Batch => {
                "callback_url IS NOT NULL AND callback_at <= now_ms() \
                 AND EXISTS (SELECT 1 FROM jobs WHERE batch = batches.id) \
                 AND NOT EXISTS (SELECT 1 FROM jobs WHERE batch = batches.id AND finished_at IS NULL)"
            }
        }
    }
}

/// SQL condition for rows whose owner and host are not busy. `$1` has the busy owners and `$2` the busy hosts, both as
/// JSON arrays of texts.
fn idle(tx: &Tx<'_>) -> String {
    let texts = |parameter: &str| match tx.is_postgres() {
        true => format!("SELECT jsonb_array_elements_text(CAST({parameter} AS jsonb))"),
        false => format!("SELECT value FROM json_each({parameter})"),
    };
    format!("owner NOT IN ({}) AND coalesce(callback_host, '') NOT IN ({})", texts("$1"), texts("$2"))
}

impl Busy {
    fn owners(&self) -> String {
        let column = self.owners.iter().map(|owner| owner.as_deref().unwrap_or_default());
        json!(column.collect::<Vec<&str>>()).to_string()
    }

    fn hosts(&self) -> String {
        json!(self.hosts).to_string()
    }
}

/// Returns true if a callback may be attempted now.
pub(super) fn any_due(tx: &mut Tx<'_>, busy: &Busy) -> Result<bool> {
    for subject in Subject::ALL {
        let text = format!("SELECT 1 FROM {} WHERE {} AND {} LIMIT 1", subject.table(), subject.due(), idle(tx));
        if tx.exists(&text, &[busy.owners().as_str().into(), busy.hosts().as_str().into()])? {
            return Ok(true);
        }
    }
    Ok(false)
}

/// Claims a callback that is due, counts an attempt, and keeps it from other claimers for the time `lease`. If the
/// claimer dies, the callback is due again after the lease. A message may therefore arrive twice, but it is not lost.
pub(super) fn claim(tx: &mut Tx<'_>, lease: Duration, busy: &Busy) -> Result<Option<Callback>> {
    for subject in Subject::ALL {
        let (table, due, idle) = (subject.table(), subject.due(), idle(tx));
        let text = format!(
            "UPDATE {table} SET callback_attempts = callback_attempts + 1, callback_at = now_ms() + $3 \
             WHERE id = (SELECT id FROM {table} WHERE {due} AND {idle} ORDER BY callback_at LIMIT 1 /* skip locked */) \
             RETURNING id, owner, callback_url, callback_attempts, callback_attempts - callback_base AS attempts"
        );
        let values = [busy.owners(), busy.hosts()];
        if let Some(row) = tx.row(&text, &[(&values[0]).into(), (&values[1]).into(), milliseconds(lease).into()])? {
            let url: String = row.get("callback_url")?;
            return Ok(Some(Callback {
                subject,
                id: row.get("id")?,
                owner: row.owner()?,
                host: host_of(&url),
                url,
                attempts: row.get("attempts")?,
                number: row.get("callback_attempts")?,
            }));
        }
    }
    Ok(None)
}

/// SQL that adds a line to the log. `$3` is the outcome.
const LOGGED: &str = "deliveries = deliveries || callback_attempts || ' ' || now_ms() || ' ' || $3 || '\n'";

/// Settles a callback that was delivered or is given up.
pub(super) fn settle(tx: &mut Tx<'_>, callback: &Callback, delivery: Delivery) -> Result<()> {
    let table = callback.subject.table();
    let text = format!(
        "UPDATE {table} SET callback_url = NULL, callback_sent = callback_url, {LOGGED} \
         WHERE id = $1 AND callback_attempts = $2 AND callback_url IS NOT NULL"
    );
    tx.execute(&text, &[(&callback.id).into(), callback.number.into(), delivery.name().into()]).map(|_| ())
}

/// Makes a callback due again after `pause`, because its attempt failed.
pub(super) fn put_off(tx: &mut Tx<'_>, callback: &Callback, pause: Duration) -> Result<()> {
    let table = callback.subject.table();
    let text =
        format!("UPDATE {table} SET callback_at = now_ms() + $4, {LOGGED} WHERE id = $1 AND callback_attempts = $2");
    let failed = Delivery::Failed.name();
    let values = [(&callback.id).into(), callback.number.into(), failed.into(), milliseconds(pause).into()];
    tx.execute(&text, &values).map(|_| ())
}

/// Returns the callback of a job or batch, or `None` if there is no such job or batch.
pub(super) fn find(tx: &mut Tx<'_>, subject: Subject, id: &str, owner: Option<&str>) -> Result<Option<CallbackRow>> {
    let text = format!(
        "SELECT callback_url, callback_sent, callback_at, deliveries FROM {} WHERE id = $1 AND ($2 = '' OR owner = $2)",
        subject.table()
    );
    let Some(row) = tx.row(&text, &[id.into(), owner.unwrap_or_default().into()])? else { return Ok(None) };
    let (due, sent): (Option<String>, Option<String>) = (row.get("callback_url")?, row.get("callback_sent")?);
    let next_ms = due.is_some().then(|| row.get("callback_at")).transpose()?;
    let log: String = row.get("deliveries")?;
    let read = |line: &str| {
        let unreadable = || StoreError::Internal(format!("unreadable line of deliveries {line:?}"));
        attempted(line).ok_or_else(unreadable)
    };
    Ok(Some(CallbackRow { url: due.or(sent), next_ms, attempted: log.lines().map(read).collect::<Result<_>>()? }))
}

fn attempted(line: &str) -> Option<Attempted> {
    let mut words = line.split(' ');
    let (number, at_ms, name) = (words.next()?.parse().ok()?, words.next()?.parse().ok()?, words.next()?);
    let delivery = Delivery::NAMES.iter().find(|(_, known)| *known == name)?.0;
    Some(Attempted { number, at_ms, delivery })
}

/// Makes the callback of a job or batch due at once. A settled callback gets all of its attempts again. Returns false
/// if there is no callback.
pub(super) fn send_again(tx: &mut Tx<'_>, subject: Subject, id: &str, owner: Option<&str>) -> Result<bool> {
    let text = format!(
        "UPDATE {} SET callback_at = now_ms(), callback_base = CASE WHEN callback_url IS NULL THEN callback_attempts \
         ELSE callback_base END, callback_url = coalesce(callback_url, callback_sent) \
         WHERE id = $1 AND ($2 = '' OR owner = $2) AND coalesce(callback_url, callback_sent) IS NOT NULL",
        subject.table()
    );
    Ok(tx.execute(&text, &[id.into(), owner.unwrap_or_default().into()])? > 0)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn the_host_of_a_url_has_its_port_and_no_path() {
        for (url, host) in [
            ("https://Example.org/hook?a=b", "example.org"),
            ("https://example.org:8443", "example.org:8443"),
            ("https://example.org?a=/b", "example.org"),
            ("https://[::1]:9/x", "[::1]:9"),
        ] {
            assert_eq!(host_of(url), host, "{url}");
        }
    }
}
