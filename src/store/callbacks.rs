//! Callbacks: messages to callback URLs. The row of a job or batch is itself the outbox. Its message is due once the
//! job or batch has ended, and stays due until it is settled. If the row is removed or expires, the message is dropped.

use std::time::Duration;

use super::jobs::read_owner;
use super::tx::Tx;
use super::{Result, milliseconds};

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
    /// Number of attempts so far, including this one.
    pub attempts: i64,
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

/// Returns true if a callback may be attempted now.
pub(super) fn any_due(tx: &mut Tx<'_>) -> Result<bool> {
    for subject in Subject::ALL {
        if tx.exists(&format!("SELECT 1 FROM {} WHERE {} LIMIT 1", subject.table(), subject.due()), &[])? {
            return Ok(true);
        }
    }
    Ok(false)
}

/// Claims a callback that is due, counts an attempt, and keeps it from other claimers for the time `lease`. If the
/// claimer dies, the callback is due again after the lease. A message may therefore arrive twice, but it is not lost.
pub(super) fn claim(tx: &mut Tx<'_>, lease: Duration) -> Result<Option<Callback>> {
    for subject in Subject::ALL {
        let (table, due) = (subject.table(), subject.due());
        let text = format!(
            "UPDATE {table} SET callback_attempts = callback_attempts + 1, callback_at = now_ms() + $1 \
             WHERE id = (SELECT id FROM {table} WHERE {due} ORDER BY callback_at LIMIT 1 /* skip locked */) \
             RETURNING id, owner, callback_url, callback_attempts"
        );
        if let Some(row) = tx.row(&text, &[milliseconds(lease).into()])? {
            return Ok(Some(Callback {
                subject,
                id: row.get("id")?,
                owner: read_owner(&row)?,
                url: row.get("callback_url")?,
                attempts: row.get("callback_attempts")?,
            }));
        }
    }
    Ok(None)
}

/// Deletes a callback that was delivered or is given up.
pub(super) fn settle(tx: &mut Tx<'_>, callback: &Callback) -> Result<()> {
    let table = callback.subject.table();
    let text = format!("UPDATE {table} SET callback_url = NULL WHERE id = $1 AND callback_attempts = $2");
    tx.execute(&text, &[(&callback.id).into(), callback.attempts.into()]).map(|_| ())
}

/// Makes a callback due again after `pause`, because its attempt failed.
pub(super) fn put_off(tx: &mut Tx<'_>, callback: &Callback, pause: Duration) -> Result<()> {
    let table = callback.subject.table();
    let text = format!("UPDATE {table} SET callback_at = now_ms() + $3 WHERE id = $1 AND callback_attempts = $2");
    tx.execute(&text, &[(&callback.id).into(), callback.attempts.into(), milliseconds(pause).into()]).map(|_| ())
}
