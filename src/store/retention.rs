//! The sweep: what expires, what is forgotten, and which results nobody needs any more. It works in small transactions
//! and rests after each for as long as that took, so that it never holds up other writes for long.

use std::collections::BTreeSet;
use std::time::{Duration, Instant};

use super::tx::{Row, Tx, Value};
use super::{Result, Store, batches, jobs, milliseconds, results};

/// Number of rows that one transaction of the sweep removes.
const SWEEP_STEP: i64 = 50;
/// Number of jobs that one transaction expires to get below the byte budget.
const EVICTION_STEP: i64 = 10;
/// Number of results without a job that one query looks for.
const ORPHANS_STEP: usize = 200;
/// Number of incremental-vacuum steps after a sweep that deleted rows, and the pages that each gives back.
const SHRINK_STEPS: usize = 20;
const SHRINK_PAGES: u32 = 50;
const LONGEST_REST: Duration = Duration::from_millis(100);

/// What a sweep did.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Default)]
pub struct Swept {
    /// Jobs that expired.
    pub expired: u64,
    /// Results that belonged to no job any more.
    pub artefacts: u64,
    /// Result files that no job ever took, because their worker died before it could say so.
    pub files: u64,
    /// Jobs whose lease had run out.
    pub recovered: usize,
}

/// Which jobs a step expires; at most `$1` of them.
#[derive(Debug, Clone)]
enum Choice {
    /// Those whose time is up.
    Due,
    /// Those that ended before the newest `max_jobs`: the first of them, by expiry and id.
    Surplus { expires_at: i64, id: String },
    /// Those with a result, oldest first.
    Oldest,
}

impl Choice {
    fn rows(&self, tx: &mut Tx<'_>, step: i64) -> Result<Vec<Row>> {
        let (condition, values): (&str, Vec<Value<'_>>) = match self {
            Self::Due => ("expires_at <= now_ms()", vec![step.into()]),
            Self::Surplus { expires_at, id } => (
                "expires_at <= $2 AND (expires_at < $2 OR id <= $3)",
                vec![step.into(), (*expires_at).into(), id.into()],
            ),
            Self::Oldest => ("artefact IS NOT NULL AND expires_at IS NOT NULL", vec![step.into()]),
        };
        let text = format!(
            "SELECT id, artefact FROM jobs WHERE {condition} ORDER BY expires_at, id LIMIT $1 /* skip locked */"
        );
        tx.rows(&text, &values)
    }
}

/// What one step expired.
#[derive(Debug)]
struct Expired {
    jobs: usize,
    /// Bytes of the results that no job has now.
    bytes: i64,
    /// Results that were removed.
    results: u64,
}

pub(super) async fn sweep(store: &Store) -> Result<Swept> {
    let mut swept = Swept { recovered: store.recover().await?, ..Swept::default() };
    expire_all(store, &Choice::Due, &mut swept).await?;
    let max_jobs = jobs::limit(store.options().max_jobs);
    if let Some(surplus) = store.read(move |tx| surplus(tx, max_jobs)).await? {
        expire_all(store, &surplus, &mut swept).await?;
    }
    store.write(batches::forget_empty).await?;
    forget(store).await?;
    if let Some(max_bytes) = store.options().max_bytes {
        evict(store, jobs::limit(max_bytes / 10 * 8), &mut swept).await?;
    }
    remove_orphans(store, &mut swept).await?;
    remove_files(store, &mut swept).await?;
    if swept.expired > 0 || swept.artefacts > 0 {
        for _ in 0..SHRINK_STEPS {
            let begun = Instant::now();
            store.write(shrink).await?;
            rest(begun).await;
        }
    }
    Ok(swept)
}

/// Lets other writes through for as long as one took.
async fn rest(begun: Instant) {
    tokio::time::sleep(begun.elapsed().min(LONGEST_REST)).await;
}

/// The newest of the ended jobs that are too many; `None` if there are none.
fn surplus(tx: &mut Tx<'_>, max_jobs: i64) -> Result<Option<Choice>> {
    let text = "SELECT expires_at, id FROM jobs WHERE expires_at IS NOT NULL ORDER BY expires_at DESC, id DESC \
                LIMIT 1 OFFSET $1";
    let Some(row) = tx.row(text, &[max_jobs.into()])? else { return Ok(None) };
    Ok(Some(Choice::Surplus { expires_at: row.get("expires_at")?, id: row.get("id")? }))
}

/// Moves some of the chosen jobs to the expired ones and removes the results that no job has then.
fn expire(tx: &mut Tx<'_>, choice: &Choice, step: i64, orphan_age: Duration) -> Result<Expired> {
    let mut expired = Expired { jobs: 0, bytes: 0, results: 0 };
    let mut orphans = BTreeSet::new();
    for row in choice.rows(tx, step)? {
        let id: String = row.get("id")?;
        let remember = "INSERT INTO expired_jobs (id, owner, expired_at) \
                        SELECT id, owner, now_ms() FROM jobs WHERE id = $1 ON CONFLICT DO NOTHING";
        tx.execute(remember, &[(&id).into()])?;
        tx.execute("DELETE FROM jobs WHERE id = $1", &[(&id).into()])?;
        tx.changed(&id);
        expired.jobs += 1;
        orphans.extend(row.get::<Option<Vec<u8>>>("artefact")?);
    }
    for hash in orphans {
        if let Some(bytes) = results::orphan_size(tx, &hash)? {
            expired.bytes += bytes;
            expired.results += u64::from(results::remove(tx, &hash, orphan_age)?);
        }
    }
    Ok(expired)
}

async fn expire_some(store: &Store, choice: &Choice, step: i64, swept: &mut Swept) -> Result<(usize, i64)> {
    let (choice, orphan_age) = (choice.clone(), store.options().orphan_age);
    let expired = store.write(move |tx| expire(tx, &choice, step, orphan_age)).await?;
    swept.expired += expired.jobs as u64;
    swept.artefacts += expired.results;
    Ok((expired.jobs, expired.bytes))
}

async fn expire_all(store: &Store, choice: &Choice, swept: &mut Swept) -> Result<()> {
    loop {
        let begun = Instant::now();
        // Fewer than a step may only say that another instance has locked some.
        if expire_some(store, choice, SWEEP_STEP, swept).await?.0 == 0 {
            return Ok(());
        }
        rest(begun).await;
    }
}

/// Forgets jobs that expired long ago.
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
        rest(begun).await;
    }
}

/// Expires the oldest jobs until the results of the others have no more than these bytes.
async fn evict(store: &Store, max_bytes: i64, swept: &mut Swept) -> Result<()> {
    loop {
        // All results are looked through for this, so not after every step.
        let mut surplus = store.read(results::bytes_in_use).await?.saturating_sub(max_bytes);
        if surplus <= 0 {
            return Ok(());
        }
        while surplus > 0 {
            let begun = Instant::now();
            let (count, bytes) = expire_some(store, &Choice::Oldest, EVICTION_STEP, swept).await?;
            if count == 0 {
                return Ok(());
            }
            surplus -= bytes;
            rest(begun).await;
        }
    }
}

/// Removes results that no job has: of jobs that were deleted, or that expired when the result was young.
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
            rest(begun).await;
        }
        match orphans.last() {
            Some(hash) if orphans.len() == ORPHANS_STEP => last.clone_from(hash),
            _ => return Ok(()),
        }
    }
}

/// Removes files that no row names and that are too old to belong to a transaction under way.
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

/// Gives pages that nothing uses any more back to the file system. PostgreSQL does so by itself.
fn shrink(tx: &mut Tx<'_>) -> Result<()> {
    if !tx.is_postgres() {
        tx.rows(&format!("PRAGMA incremental_vacuum({SHRINK_PAGES})"), &[])?;
    }
    Ok(())
}
