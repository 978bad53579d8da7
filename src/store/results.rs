//! Results by the hash of their bytes, shared by every job that has the same: small ones in the row, large ones in a
//! file that the row names.

use std::time::Duration;

use super::jobs::limit;
use super::tx::Tx;
use super::{Result, StoreError, milliseconds};

/// A stored result.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct Artefact {
    /// Names `bytes`: equal for equal bytes only.
    pub hash: Vec<u8>,
    pub bytes: Vec<u8>,
    /// Changes whenever the row does, so that only the damaged bytes that somebody looked at are discarded.
    pub(super) touched_at: i64,
}

/// A result that can be put into a row.
#[derive(Debug)]
pub(super) struct Prepared {
    /// Its name in the database: never the same for other bytes.
    pub(super) hash: [u8; 32],
    /// The file that holds the bytes; without one they belong into the row.
    pub(super) file: Option<String>,
}

/// The row of a job's result.
#[derive(Debug)]
pub(super) struct ResultRow {
    pub(super) hash: Vec<u8>,
    pub(super) touched_at: i64,
    pub(super) bytes: Option<Vec<u8>>,
    pub(super) file: Option<String>,
}

/// The result of a job that succeeded; `None` for any other id.
pub(super) fn find(tx: &mut Tx<'_>, id: &str, owner: Option<&str>) -> Result<Option<ResultRow>> {
    let text = "SELECT hash, touched_at, body, file FROM jobs JOIN artefacts ON hash = artefact \
                WHERE id = $1 AND ($2 = '' OR owner = $2)";
    let Some(row) = tx.row(text, &[id.into(), owner.unwrap_or_default().into()])? else { return Ok(None) };
    let found = ResultRow {
        hash: row.get("hash")?,
        touched_at: row.get("touched_at")?,
        bytes: row.get("body")?,
        file: row.get("file")?,
    };
    if found.bytes.is_none() && found.file.is_none() {
        return Err(StoreError::Internal(format!("the result of job {id} has no bytes")));
    }
    Ok(Some(found))
}

/// Results of more bytes are named by their bytes alone, so that equal ones are kept once. The names of others begin with
/// the time, so that they come in order: an index over names without order costs a page in a random place for each.
const NAMED_BY_TIME_BYTES: usize = 32 << 10;

/// The name of a result whose bytes have this hash.
pub(super) fn name(artefact: &[u8], hash: [u8; 32]) -> [u8; 32] {
    if artefact.len() > NAMED_BY_TIME_BYTES {
        return hash;
    }
    let since_1970 = std::time::SystemTime::now().duration_since(std::time::UNIX_EPOCH).unwrap_or_default();
    let milliseconds = u64::try_from(since_1970.as_millis()).unwrap_or(u64::MAX).to_be_bytes();
    let mut name = hash;
    name[..6].copy_from_slice(&milliseconds[2..]);
    name
}

/// Stores a success's result. An equal one that is there already is replaced, because nobody has looked whether its
/// bytes are still sound.
pub(super) fn keep(tx: &mut Tx<'_>, result: &Prepared, artefact: &[u8]) -> Result<()> {
    let text = "INSERT INTO artefacts (hash, size, touched_at, file, body) VALUES ($1, $2, now_ms(), $3, $4) \
                ON CONFLICT (hash) DO UPDATE SET file = excluded.file, body = excluded.body, touched_at = CASE \
                WHEN artefacts.touched_at < excluded.touched_at THEN excluded.touched_at \
                ELSE artefacts.touched_at + 1 END";
    let body = result.file.is_none().then_some(artefact);
    let size = limit(artefact.len() as u64);
    if let Some(row) = tx.row("SELECT file FROM artefacts WHERE hash = $1", &[(&result.hash).into()])? {
        tx.drop_file(row.get("file")?);
    }
    tx.execute(text, &[(&result.hash).into(), size.into(), result.file.as_deref().into(), body.into()]).map(|_| ())
}

/// Marks a result as just taken. False if it is not there.
pub(super) fn touch(tx: &mut Tx<'_>, hash: &[u8]) -> Result<bool> {
    Ok(tx.execute("UPDATE artefacts SET touched_at = now_ms() WHERE hash = $1", &[hash.into()])? > 0)
}

/// Keeps later equal requests from taking a result whose bytes cannot be had.
pub(super) fn stop_sharing(tx: &mut Tx<'_>, hash: &[u8]) -> Result<()> {
    let text = "UPDATE jobs SET sharing = 'refused' WHERE artefact = $1 AND sharing = 'allowed'";
    tx.execute(text, &[hash.into()]).map(|_| ())
}

/// Removes a damaged result, unless it has changed since it was read, and keeps later equal requests from taking it.
pub(super) fn discard(tx: &mut Tx<'_>, hash: &[u8], touched_at: i64) -> Result<()> {
    let text = "DELETE FROM artefacts WHERE hash = $1 AND touched_at = $2 RETURNING file";
    let Some(row) = tx.row(text, &[hash.into(), touched_at.into()])? else { return Ok(()) };
    tx.drop_file(row.get("file")?);
    stop_sharing(tx, hash)
}

/// Removes a result that no job has, unless one took it lately: that job may not be visible yet. False if it stays.
pub(super) fn remove(tx: &mut Tx<'_>, hash: &[u8], orphan_age: Duration) -> Result<bool> {
    let text = "DELETE FROM artefacts WHERE hash = $1 AND touched_at <= now_ms() - $2 \
                AND NOT EXISTS (SELECT 1 FROM jobs WHERE artefact = $1) RETURNING file";
    let Some(row) = tx.row(text, &[hash.into(), milliseconds(orphan_age).into()])? else { return Ok(false) };
    tx.drop_file(row.get("file")?);
    Ok(true)
}

/// The size of a result that no job has; `None` if one has it.
pub(super) fn orphan_size(tx: &mut Tx<'_>, hash: &[u8]) -> Result<Option<i64>> {
    let text = "SELECT size FROM artefacts WHERE hash = $1 AND NOT EXISTS (SELECT 1 FROM jobs WHERE artefact = $1)";
    tx.row(text, &[hash.into()])?.map(|row| row.get("size")).transpose()
}

/// Names of results that no job has, in order, after `last`. Indexes alone answer this: a result's row is long.
pub(super) fn orphans(tx: &mut Tx<'_>, last: &[u8], most: i64) -> Result<Vec<Vec<u8>>> {
    let text = "SELECT hash FROM artefacts WHERE hash > $1 AND NOT EXISTS (SELECT 1 FROM jobs WHERE artefact = hash) \
                ORDER BY hash LIMIT $2";
    tx.rows(text, &[last.into(), most.into()])?.iter().map(|row| row.get("hash")).collect()
}

/// Bytes of the results that jobs have.
pub(super) fn bytes_in_use(tx: &mut Tx<'_>) -> Result<i64> {
    let text = "SELECT CAST(coalesce(sum(size), 0) AS BIGINT) AS total FROM artefacts \
                WHERE EXISTS (SELECT 1 FROM jobs WHERE artefact = hash)";
    tx.one(text, &[])?.get("total")
}

/// Every file that a row names.
pub(super) fn files(tx: &mut Tx<'_>) -> Result<Vec<String>> {
    tx.rows("SELECT file FROM artefacts WHERE file IS NOT NULL", &[])?.iter().map(|row| row.get("file")).collect()
}
