//! Results, named by the hash of their bytes and shared by every job that has the same result. Small results are in the
//! row; large ones are in a file that the row names.

use std::time::Duration;

use super::tx::{Row, Tx};
use super::{Result, StoreError, limit, milliseconds};

/// A stored result.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct Artefact {
    /// Name of the result, which is equal only for equal bytes.
    pub hash: Vec<u8>,
    pub bytes: Vec<u8>,
    /// Time of the row's last change. A damaged result is discarded only if its row has not changed since it was read.
    pub(super) touched_at: i64,
}

/// A result that is ready to be stored in a row.
#[derive(Debug)]
pub(super) struct Prepared {
    /// Name of the result in the database, which differs for different bytes.
    pub(super) hash: [u8; 32],
    /// File that holds the bytes. If `None`, the bytes go into the row.
    pub(super) file: Option<String>,
}

/// Row of a stored result, whose bytes are in the row or in a file.
#[derive(Debug)]
pub(super) struct ResultRow {
    pub(super) hash: Vec<u8>,
    pub(super) touched_at: i64,
    pub(super) bytes: Option<Vec<u8>>,
    pub(super) file: Option<String>,
}

/// Returns the result of a succeeded job, or `None` for any other identifier.
pub(super) fn find(tx: &mut Tx<'_>, id: &str, owner: Option<&str>) -> Result<Option<ResultRow>> {
    let text = "SELECT hash, touched_at, body, file FROM jobs JOIN artefacts ON hash = artefact \
                WHERE id = $1 AND ($2 = '' OR owner = $2)";
    let row = tx.row(text, &[id.into(), owner.unwrap_or_default().into()])?;
    row.map(|row| read(&row)).transpose()
}

/// Returns the result with this name.
pub(super) fn named(tx: &mut Tx<'_>, name: &[u8]) -> Result<Option<ResultRow>> {
    let row = tx.row("SELECT hash, touched_at, body, file FROM artefacts WHERE hash = $1", &[name.into()])?;
    row.map(|row| read(&row)).transpose()
}

fn read(row: &Row) -> Result<ResultRow> {
    let found = ResultRow {
        hash: row.get("hash")?,
        touched_at: row.get("touched_at")?,
        bytes: row.get("body")?,
        file: row.get("file")?,
    };
    if found.bytes.is_none() && found.file.is_none() {
        return Err(StoreError::Internal("a result has no bytes".into()));
    }
    Ok(found)
}

/// Largest size in bytes of results whose names begin with the time. Their names are in order of time, because an index
/// over unordered names would write a page at a random place for each result. Larger results are named by their hash
/// alone, so that equal ones are kept only once.
const NAMED_BY_TIME_BYTES: usize = 32 << 10;

/// Length in bytes of the time at the beginning of a name.
const TIME_BYTES: usize = 6;

/// Returns true if two names belong to equal bytes. The times at the beginning of the names are ignored.
pub(super) fn have_equal_bytes(name: &[u8], other: &[u8]) -> bool {
    name.get(TIME_BYTES..) == other.get(TIME_BYTES..)
}

/// Returns the name of a result: the hash of its bytes, whose beginning is replaced by the time if the result is small.
pub(super) fn name(artefact: &[u8], hash: [u8; 32]) -> [u8; 32] {
    if artefact.len() > NAMED_BY_TIME_BYTES {
        return hash;
    }
    let since_1970 = std::time::SystemTime::now().duration_since(std::time::UNIX_EPOCH).unwrap_or_default();
    let milliseconds = u64::try_from(since_1970.as_millis()).unwrap_or(u64::MAX).to_be_bytes();
    let mut name = hash;
    name[..TIME_BYTES].copy_from_slice(&milliseconds[8 - TIME_BYTES..]);
    name
}

/// Stores the result of a success. If an equal result exists, it is replaced, because its bytes may be damaged.
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

/// Returns true if a row names this file.
pub(super) fn is_named(tx: &mut Tx<'_>, file: &str) -> Result<bool> {
    tx.exists("SELECT 1 FROM artefacts WHERE file = $1", &[file.into()])
}

/// Marks a result as recently used. Returns false if it does not exist.
pub(super) fn touch(tx: &mut Tx<'_>, hash: &[u8]) -> Result<bool> {
    Ok(tx.execute("UPDATE artefacts SET touched_at = now_ms() WHERE hash = $1", &[hash.into()])? > 0)
}

/// Keeps later equal requests from reusing a result whose bytes cannot be read.
pub(super) fn stop_sharing(tx: &mut Tx<'_>, hash: &[u8]) -> Result<()> {
    let text = "UPDATE jobs SET sharing = 'refused' WHERE artefact = $1 AND sharing = 'allowed'";
    tx.execute(text, &[hash.into()]).map(|_| ())
}

/// Removes a damaged result unless it has changed since it was read, and keeps later equal requests from reusing it.
pub(super) fn discard(tx: &mut Tx<'_>, hash: &[u8], touched_at: i64) -> Result<()> {
    let text = "DELETE FROM artefacts WHERE hash = $1 AND touched_at = $2 RETURNING file";
    let Some(row) = tx.row(text, &[hash.into(), touched_at.into()])? else { return Ok(()) };
    tx.drop_file(row.get("file")?);
    stop_sharing(tx, hash)
}

/// Returns the SQL condition for a result that belongs to no job and is the source of no waiting request. `name` is SQL
/// for the result's name.
fn orphaned(name: &str) -> String {
    format!(
        "NOT EXISTS (SELECT 1 FROM jobs WHERE artefact = {name}) \
         AND NOT EXISTS (SELECT 1 FROM requests WHERE source = {name})"
    )
}

/// Removes a result without a job. A recently used result stays, because the job that uses it may not be visible yet.
/// Returns false if the result stays.
pub(super) fn remove(tx: &mut Tx<'_>, hash: &[u8], orphan_age: Duration) -> Result<bool> {
    let text = format!(
        "DELETE FROM artefacts WHERE hash = $1 AND touched_at <= now_ms() - $2 AND {} RETURNING file",
        orphaned("$1")
    );
    let Some(row) = tx.row(&text, &[hash.into(), milliseconds(orphan_age).into()])? else { return Ok(false) };
    tx.drop_file(row.get("file")?);
    Ok(true)
}

/// Returns the size of a result without a job and whether its bytes are in the database, or `None` if a job has the
/// result.
pub(super) fn orphan_size(tx: &mut Tx<'_>, hash: &[u8]) -> Result<Option<(i64, bool)>> {
    let text = format!("SELECT size, file FROM artefacts WHERE hash = $1 AND {}", orphaned("$1"));
    let Some(row) = tx.row(&text, &[hash.into()])? else { return Ok(None) };
    Ok(Some((row.get("size")?, row.get::<Option<String>>("file")?.is_none())))
}

/// Returns the names of results without a job, in order, after `last`. The query reads only indexes, because the rows
/// of results are long.
pub(super) fn orphans(tx: &mut Tx<'_>, last: &[u8], max_count: i64) -> Result<Vec<Vec<u8>>> {
    let text = format!("SELECT hash FROM artefacts WHERE hash > $1 AND {} ORDER BY hash LIMIT $2", orphaned("hash"));
    tx.rows(&text, &[last.into(), max_count.into()])?.iter().map(|row| row.get("hash")).collect()
}

/// Returns the total size in bytes of the results that belong to jobs and of the requests of finished jobs. Requests of
/// other jobs are not counted, because no job that expires makes room for them.
pub(super) fn bytes_in_use(tx: &mut Tx<'_>) -> Result<i64> {
    let text = "SELECT CAST((SELECT coalesce(sum(size), 0) FROM artefacts \
                WHERE EXISTS (SELECT 1 FROM jobs WHERE artefact = hash)) \
                + (SELECT coalesce(sum(request_bytes), 0) FROM jobs WHERE expires_at IS NOT NULL) AS BIGINT) AS total";
    tx.one(text, &[])?.get("total")
}

/// Returns the owner whose finished jobs have the largest results and requests, and by how many bytes they exceed those
/// of the next owner. Returns `None` if no job has finished.
pub(super) fn largest_owner(tx: &mut Tx<'_>) -> Result<Option<(String, i64)>> {
    let text = "SELECT owner, CAST(sum(bytes) AS BIGINT) AS total FROM (\
                SELECT owner, sum(request_bytes) AS bytes FROM jobs WHERE expires_at IS NOT NULL GROUP BY owner \
                UNION ALL SELECT owner, sum(size) AS bytes \
                FROM (SELECT DISTINCT owner, artefact FROM jobs \
                WHERE artefact IS NOT NULL AND expires_at IS NOT NULL) AS own \
                JOIN artefacts ON hash = artefact GROUP BY owner) AS parts \
                GROUP BY owner ORDER BY total DESC LIMIT 2";
    let rows = tx.rows(text, &[])?;
    let Some(largest) = rows.first() else { return Ok(None) };
    let next: i64 = rows.get(1).map_or(Ok(0), |row| row.get("total"))?;
    Ok(Some((largest.get("owner")?, largest.get::<i64>("total")? - next)))
}

/// Returns the name of every file that a row names.
pub(super) fn files(tx: &mut Tx<'_>) -> Result<Vec<String>> {
    tx.rows("SELECT file FROM artefacts WHERE file IS NOT NULL", &[])?.iter().map(|row| row.get("file")).collect()
}
