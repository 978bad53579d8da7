//! URLs that are to be told of an end. The outbox is the row of the job or batch itself: a callback is due once its subject has
//! ended, and stays so until it is settled. It goes with its subject when that is removed or expires.

use std::time::Duration;

use super::engine::Result;
use super::sql::Value;
use super::{Store, milliseconds};

#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Subject {
    Job,
    Batch,
}

/// A callback that the claimer is to attempt.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct Callback {
    pub subject: Subject,
    /// Of the job or batch.
    pub id: String,
    pub owner: Option<String>,
    pub url: String,
    /// Attempts so far, this one included.
    pub attempts: i64,
}

impl Subject {
    fn table(self) -> &'static str {
        match self {
            Self::Job => "jobs",
            Self::Batch => "batches",
        }
    }

    /// What is true of a row whose callback may be attempted now.
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

impl Store {
    /// Takes a callback that is due, counting an attempt; nobody else is given it for `lease`. If the claimer dies it is due
    /// again then, so that a message may arrive twice but not never.
    pub async fn claim_callback(&self, lease: Duration) -> Result<Option<Callback>> {
        for subject in [Subject::Job, Subject::Batch] {
            let (table, due) = (subject.table(), subject.due());
            let any = format!("SELECT 1 FROM {table} WHERE {due} LIMIT 1");
            if self.inner.engine.row(&any, Vec::new()).await?.is_none() {
                continue;
            }
            let text = format!(
                "UPDATE {table} SET callback_attempts = callback_attempts + 1, callback_at = now_ms() + $1 \
                 WHERE id = (SELECT id FROM {table} WHERE {due} ORDER BY callback_at LIMIT 1 /* skip locked */) \
                 RETURNING id, owner, callback_url, callback_attempts"
            );
            let values: Vec<Value> = vec![milliseconds(lease).into()];
            let claimed = self
                .inner
                .engine
                .write(move |connection| {
                    let (text, values) = (text.clone(), values.clone());
                    Box::pin(async move {
                        let Some(row) = connection.row(&text, values).await? else { return Ok(None) };
                        let owner = row.text(1)?;
                        Ok(Some(Callback {
                            subject,
                            id: row.text(0)?,
                            owner: (!owner.is_empty()).then_some(owner),
                            url: row.text(2)?,
                            attempts: row.int(3)?,
                        }))
                    })
                })
                .await?;
            if claimed.is_some() {
                return Ok(claimed);
            }
        }
        Ok(None)
    }

    /// The callback was delivered, or is given up.
    pub async fn settle_callback(&self, callback: &Callback) -> Result<()> {
        let text = format!(
            "UPDATE {} SET callback_url = NULL WHERE id = $1 AND callback_attempts = $2",
            callback.subject.table()
        );
        self.change_callback(text, vec![callback.id.as_str().into(), callback.attempts.into()]).await
    }

    /// The attempt failed; the callback is due again after `pause`.
    pub async fn put_off_callback(&self, callback: &Callback, pause: Duration) -> Result<()> {
        let text = format!(
            "UPDATE {} SET callback_at = now_ms() + $3 WHERE id = $1 AND callback_attempts = $2",
            callback.subject.table()
        );
        let values = vec![callback.id.as_str().into(), callback.attempts.into(), milliseconds(pause).into()];
        self.change_callback(text, values).await
    }

    async fn change_callback(&self, text: String, values: Vec<Value>) -> Result<()> {
        self.inner
            .engine
            .write(move |connection| {
                let (text, values) = (text.clone(), values.clone());
                Box::pin(async move {
                    connection.execute(&text, values).await?;
                    Ok(())
                })
            })
            .await
    }
}
