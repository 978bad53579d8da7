//! The sweep: it expires jobs, deletes old expired identifiers and removes results without a job. It works in small
//! transactions and pauses after each for as long as the transaction took, so that it never delays other writes for
//! long.

use std::collections::BTreeSet;
use std::time::{Duration, Instant};

use super::handle::Store;
use super::jobs::drop_request;
use super::tx::{Row, Tx};
use super::value::Value;
use super::{Result, batches, limit, milliseconds, results};

/// Largest number of rows that one transaction of the sweep removes.
const SWEEP_STEP: i64 = 50;
/// Largest number of jobs that one transaction expires to get below the byte budget.
const EVICTION_STEP: i64 = 10;
/// Estimate of the space that the row of a job takes in an SQLite database beside its long texts, with its entries in
/// the indexes, in bytes. The size of the database is read again after the eviction, so an error costs another round at
/// most.
const ROW_BYTES: i64 = 700;
/// Estimate of the space that the identifier of an expired job takes in an SQLite database, in bytes.
const EXPIRED_BYTES: i64 = 200;
/// Largest number of results without a job that one query returns.
const ORPHANS_STEP: usize = 200;
/// Number of incremental-vacuum steps after a sweep that deleted rows.
const SHRINK_STEPS: usize = 20;
/// Number of pages that each incremental-vacuum step returns to the file system.
const SHRINK_PAGES: u32 = 50;
/// Upper bound of the pause after a transaction.
const MAX_PAUSE: Duration = Duration::from_millis(100);

/// Result of a sweep.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Default)]
pub struct Swept {
    /// Number of jobs that expired.
    pub expired: u64,
    /// Number of removed results that belonged to no job.
    pub artefacts: u64,
    /// Number of removed result files without a row, which were left by workers that died.
    pub files: u64,
    /// Number of jobs whose lease had run out.
    pub recovered: usize,
}

/// Selection of the jobs that a step expires. `$1` limits their number.
#[derive(Debug, Clone)]
enum Choice {
    /// Jobs whose time is up.
    Due,
    /// Finished jobs of an owner that exceed its part of `max_jobs`, oldest first. `expires_at` and `id` belong to the
    /// newest of these jobs.
    Surplus { owner: String, expires_at: i64, id: String },
    /// Finished jobs of an owner, or of all owners, oldest first.
    Oldest { owner: Option<String> },
}

impl Choice {
    fn rows(&self, tx: &mut Tx<'_>, step: i64) -> Result<Vec<Row>> {
        let (condition, values): (&str, Vec<Value<'_>>) = match self {
            Self::Due => ("expires_at <= now_ms()", vec![step.into()]),
            Self::Surplus { owner, expires_at, id } => (
                "owner = $4 AND expires_at <= $2 AND (expires_at < $2 OR id <= $3)",
                vec![step.into(), (*expires_at).into(), id.into(), owner.into()],
            ),
            Self::Oldest { owner } => (
                "expires_at IS NOT NULL AND ($2 = 1 OR owner = $3)",
                vec![step.into(), i64::from(owner.is_none()).into(), owner.as_deref().unwrap_or_default().into()],
            ),
        };
        let text = format!(
            "SELECT id, artefact, request_bytes, CAST(coalesce(length(statistics), 0) + coalesce(length(metadata), 0) \
             + coalesce(length(error), 0) + length(warnings) + length(history) AS BIGINT) AS text_bytes FROM jobs \
             WHERE {condition} ORDER BY expires_at, id LIMIT $1 /* skip locked */"
        );
        tx.rows(&text, &values)
    }
}

/// Result of one call of [`expire`].
#[derive(Debug)]
struct Expired {
    jobs: usize,
    /// Bytes of the requests, and of the results that no job has after this step.
    bytes: i64,
    /// Estimate of the bytes that this step, and the removal of these results, free in an SQLite database.
    space: i64,
    /// Number of results that were removed.
    results: u64,
}

/// Runs one sweep. The number of leases that were `recovered` before it is only passed on to the report.
pub(super) async fn sweep(store: &Store, recovered: usize) -> Result<Swept> {
    let mut swept = Swept { recovered, ..Swept::default() };
    expire_all(store, &Choice::Due, &mut swept).await?;
    let max_jobs = limit(store.options().max_jobs);
    for surplus in store.read(move |tx| surplus(tx, max_jobs)).await? {
        expire_all(store, &surplus, &mut swept).await?;
    }
    store.write(batches::forget_empty).await?;
    remove_lone_requests(store).await?;
    forget(store).await?;
    if let Some(max_bytes) = store.options().max_bytes {
        evict(store, limit(max_bytes / 10 * 8), &mut swept).await?;
    }
    remove_orphans(store, &mut swept).await?;
    remove_files(store, &mut swept).await?;
    if swept.expired > 0 || swept.artefacts > 0 {
        for _ in 0..SHRINK_STEPS {
            let begun = Instant::now();
            store.write(shrink).await?;
            pause_as_long_as(begun).await;
        }
    }
    Ok(swept)
}

/// Pauses for as long as the transaction that started at `begun` took, but at most [`MAX_PAUSE`], so that other writes
/// can run.
async fn pause_as_long_as(begun: Instant) {
    tokio::time::sleep(begun.elapsed().min(MAX_PAUSE)).await;
}

/// Returns the finished jobs that do not fit into `max_jobs`. Only the owners with the most jobs lose some, and all of
/// these owners keep the same number.
fn surplus(tx: &mut Tx<'_>, max_jobs: i64) -> Result<Vec<Choice>> {
    let counts =
        tx.rows("SELECT owner, count(*) AS jobs FROM jobs WHERE expires_at IS NOT NULL GROUP BY owner", &[])?;
    let counts: Vec<(String, i64)> =
        counts.iter().map(|row| Ok((row.get("owner")?, row.get("jobs")?))).collect::<Result<_>>()?;
    let kept = level(counts.iter().map(|(_, jobs)| *jobs).collect(), max_jobs);
    let mut surplus = Vec::new();
    for (owner, _) in counts.into_iter().filter(|(_, jobs)| *jobs > kept) {
        let text = "SELECT expires_at, id FROM jobs WHERE owner = $1 AND expires_at IS NOT NULL \
                    ORDER BY expires_at DESC, id DESC LIMIT 1 OFFSET $2";
        if let Some(row) = tx.row(text, &[(&owner).into(), kept.into()])? {
            surplus.push(Choice::Surplus { owner, expires_at: row.get("expires_at")?, id: row.get("id")? });
        }
    }
    Ok(surplus)
}

/// Returns the largest number such that the sum of the counts, each cut to this number, is at most `total`. If no count
/// has to be cut, returns the largest count or more.
fn level(mut counts: Vec<i64>, total: i64) -> i64 {
    counts.sort_unstable();
    let (mut left, mut owners) = (total, counts.len() as i64);
    for count in counts {
        if count > left / owners {
            return left / owners;
        }
        left -= count;
        owners -= 1;
    }
    i64::MAX
}

/// Expires some of the selected jobs, and removes the results that no job has afterwards.
fn expire(tx: &mut Tx<'_>, choice: &Choice, step: i64, orphan_age: Duration) -> Result<Expired> {
    let mut expired = Expired { jobs: 0, bytes: 0, space: 0, results: 0 };
    let mut orphans = BTreeSet::new();
    for row in choice.rows(tx, step)? {
        let id: String = row.get("id")?;
        // The row is deleted before its identifier is stored, because a full database has no space for the identifier
        // until the row is gone.
        let Some(removed) = tx.row("DELETE FROM jobs WHERE id = $1 RETURNING owner", &[(&id).into()])? else {
            continue;
        };
        let owner: String = removed.get("owner")?;
        let remember =
            "INSERT INTO expired_jobs (id, owner, expired_at) VALUES ($1, $2, now_ms()) ON CONFLICT DO NOTHING";
        tx.execute(remember, &[(&id).into(), (&owner).into()])?;
        tx.changed(&id);
        drop_request(tx, &id)?;
        let request_bytes: i64 = row.get("request_bytes")?;
        expired.jobs += 1;
        expired.bytes += request_bytes;
        expired.space += request_bytes;
        expired.space += ROW_BYTES - EXPIRED_BYTES + row.get::<i64>("text_bytes")?;
        orphans.extend(row.get::<Option<Vec<u8>>>("artefact")?);
    }
    for hash in orphans {
        if let Some((bytes, in_database)) = results::orphan_size(tx, &hash)? {
            expired.bytes += bytes;
            expired.space += if in_database { bytes } else { 0 };
            expired.results += u64::from(results::remove(tx, &hash, orphan_age)?);
        }
    }
    Ok(expired)
}

async fn expire_some(store: &Store, choice: &Choice, step: i64, swept: &mut Swept) -> Result<Expired> {
    let (choice, orphan_age) = (choice.clone(), store.options().orphan_age);
    let expired = store.write(move |tx| expire(tx, &choice, step, orphan_age)).await?;
    swept.expired += expired.jobs as u64;
    swept.artefacts += expired.results;
    Ok(expired)
}

async fn expire_all(store: &Store, choice: &Choice, swept: &mut Swept) -> Result<()> {
    loop {
        let begun = Instant::now();
        // The loop ends only at 0, because a smaller number than a step may mean that another instance has locked some
        // rows.
        if expire_some(store, choice, SWEEP_STEP, swept).await?.jobs == 0 {
            return Ok(());
        }
        pause_as_long_as(begun).await;
    }
}

/// Deletes the identifiers of jobs that expired long ago.
async fn forget(store: &Store) -> Result<()> {
    let age = milliseconds(store.options().expired_retention);
    let oldest = "DELETE FROM expired_jobs WHERE id IN (SELECT id FROM expired_jobs \
                  WHERE expired_at < now_ms() - $1 ORDER BY expired_at LIMIT $2)";
    loop {
        let begun = Instant::now();
        let forgotten = store.write(move |tx| tx.execute(oldest, &[age.into(), SWEEP_STEP.into()])).await?;
        if forgotten < SWEEP_STEP.unsigned_abs() {
            return Ok(());
        }
        pause_as_long_as(begun).await;
    }
}

/// Expires the oldest jobs of the owners with the largest results and requests until those of the remaining jobs, and
/// on SQLite the database itself, take at most `max_bytes`.
async fn evict(store: &Store, max_bytes: i64, swept: &mut Swept) -> Result<()> {
    loop {
        // These queries scan all results, so they do not run after every step.
        let mut surplus = store.read(results::bytes_in_use).await?.saturating_sub(max_bytes);
        let mut space = store.read(database_bytes).await?.saturating_sub(max_bytes);
        if surplus <= 0 && space <= 0 {
            return Ok(());
        }
        forget_beyond(store, max_bytes / 10 / EXPIRED_BYTES).await?;
        // The owner with the largest results and requests gives up jobs until another owner has as much.
        let (owner, mut ahead) = match store.read(results::largest_owner).await? {
            Some((owner, ahead)) => (Some(owner), ahead.max(1)),
            None => (None, i64::MAX),
        };
        while ahead > 0 && (surplus > 0 || space > 0) {
            let begun = Instant::now();
            let choice = Choice::Oldest { owner: owner.clone() };
            let expired = expire_some(store, &choice, EVICTION_STEP, swept).await?;
            ahead = ahead.saturating_sub(expired.bytes.max(1));
            if expired.jobs == 0 {
                return Ok(());
            }
            surplus -= expired.bytes;
            space -= expired.space;
            pause_as_long_as(begun).await;
        }
    }
}

/// Returns the size in bytes of the pages that an SQLite database uses, without the results that no job has. Those
/// results are removed when they are older than `orphan_age`. Returns 0 on PostgreSQL, whose size has no limit.
fn database_bytes(tx: &mut Tx<'_>) -> Result<i64> {
    if tx.is_postgres() {
        return Ok(0);
    }
    let text = "SELECT (page_count - freelist_count) * page_size \
                - (SELECT coalesce(sum(size), 0) FROM artefacts WHERE file IS NULL \
                   AND NOT EXISTS (SELECT 1 FROM jobs WHERE artefact = hash)) AS used \
                FROM pragma_page_count, pragma_freelist_count, pragma_page_size";
    tx.one(text, &[])?.get("used")
}

/// Deletes the oldest identifiers of expired jobs if there are more than `kept`, so that they leave room for jobs.
async fn forget_beyond(store: &Store, kept: i64) -> Result<()> {
    let oldest = "DELETE FROM expired_jobs WHERE id IN (SELECT id FROM expired_jobs ORDER BY expired_at LIMIT $1)";
    let count = |tx: &mut Tx<'_>| tx.one("SELECT count(*) AS count FROM expired_jobs", &[])?.get("count");
    let mut surplus: i64 = store.read(count).await?;
    surplus -= kept;
    while surplus > 0 {
        let begun = Instant::now();
        let step = surplus.min(SWEEP_STEP);
        store.write(move |tx| tx.execute(oldest, &[step.into()])).await?;
        surplus -= step;
        pause_as_long_as(begun).await;
    }
    Ok(())
}

/// Removes results without a job. Their jobs were deleted, or expired when the result was younger than `orphan_age`.
async fn remove_orphans(store: &Store, swept: &mut Swept) -> Result<()> {
    let orphan_age = store.options().orphan_age;
    let mut last = Vec::new();
    loop {
        let after = last.clone();
        let orphans = store.read(move |tx| results::orphans(tx, &after, ORPHANS_STEP as i64)).await?;
        for some in orphans.chunks(SWEEP_STEP as usize) {
            let (begun, some) = (Instant::now(), some.to_vec());
            let remove = move |tx: &mut Tx<'_>| {
                some.iter().try_fold(0, |count, hash| Ok(count + u64::from(results::remove(tx, hash, orphan_age)?)))
            };
            swept.artefacts += store.write(remove).await?;
            pause_as_long_as(begun).await;
        }
        match orphans.last() {
            Some(hash) if orphans.len() == ORPHANS_STEP => last.clone_from(hash),
            _ => return Ok(()),
        }
    }
}

/// Removes requests without a job. An older version on the same database expires jobs without their requests.
async fn remove_lone_requests(store: &Store) -> Result<()> {
    let lone = "SELECT job_id FROM requests WHERE NOT EXISTS (SELECT 1 FROM jobs WHERE id = job_id) LIMIT $1";
    loop {
        let rows = move |tx: &mut Tx<'_>| {
            let rows = tx.rows(lone, &[SWEEP_STEP.into()])?;
            rows.iter().map(|row| row.get("job_id")).collect::<Result<Vec<String>>>()
        };
        let ids = store.read(rows).await?;
        if ids.is_empty() {
            return Ok(());
        }
        let begun = Instant::now();
        store.write(move |tx| ids.iter().try_for_each(|id| drop_request(tx, id))).await?;
        pause_as_long_as(begun).await;
    }
}

/// Removes files that no row names and that are too old to belong to a running transaction.
async fn remove_files(store: &Store, swept: &mut Swept) -> Result<()> {
    let Some(files) = store.files() else { return Ok(()) };
    let old = files.older_than(store.options().orphan_age).await?;
    let known: BTreeSet<String> = store.read(results::files).await?.into_iter().collect();
    for file in old.into_iter().filter(|file| !known.contains(file)) {
        files.remove(file).await;
        swept.files += 1;
    }
    Ok(())
}

/// Returns every unused page of an SQLite database to the file system. A full disk needs all of them, and cannot wait
/// for later sweeps.
pub(super) async fn shrink_all(store: &Store) -> Result<()> {
    while store.read(|tx| tx.exists("SELECT 1 FROM pragma_freelist_count WHERE freelist_count > 0", &[])).await? {
        store.write(shrink).await?;
    }
    Ok(())
}

/// Returns some unused pages to the file system. PostgreSQL does this by itself.
fn shrink(tx: &mut Tx<'_>) -> Result<()> {
    if !tx.is_postgres() {
        tx.rows(&format!("PRAGMA incremental_vacuum({SHRINK_PAGES})"), &[])?;
    }
    Ok(())
}

#[cfg(test)]
mod tests {
    use super::level;

    #[test]
    fn the_owners_with_the_most_jobs_are_cut_to_the_same_number() {
        for (counts, total, kept) in [
            (&[100][..], 10, 10),
            (&[3, 100], 10, 7),
            (&[3, 4, 100, 100], 27, 10),
            (&[100, 100], 11, 5),
            (&[0, 1], 0, 0),
        ] {
            assert_eq!(level(counts.to_vec(), total), kept, "{counts:?} {total}");
        }
        assert!(level(vec![3, 4], 7) >= 4 && level(vec![], 7) > 0);
    }
}
