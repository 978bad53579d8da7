//! Large results outside of the database: as files of a folder, or as objects of an S3-compatible bucket. Written whole and
//! durably before the row that names them commits, never changed, removed after the row is gone. A name holds job and attempt,
//! so no two writers ever share one; what is there without a row is left by a worker that died in between, and the sweep
//! removes it.
//!
//! The folder is not object_store's: that one does not sync what it writes.

use std::fmt;
use std::fs::{self, File};
use std::io::{self, Write};
use std::path::PathBuf;
use std::sync::Arc;
use std::time::{Duration, SystemTime};

use futures_util::TryStreamExt;
use object_store::aws::AmazonS3Builder;
use object_store::path::Path as ObjectPath;
use object_store::{ObjectStore, ObjectStoreExt, PutPayload, RetryConfig};

use super::engine::Result;
use super::{Store, StoreError};

/// What names a bucket instead of a folder.
const BUCKET_SCHEME: &str = "s3://";
/// Further attempts of a request to a bucket, and how long they may take together: what is told of a failure comes while the
/// worker still holds its lease.
const BUCKET_RETRIES: usize = 3;
const BUCKET_PATIENCE: Duration = Duration::from_secs(10);

/// Results of more bytes are named by their bytes alone, so that equal ones are kept once. The names of others begin with the
/// time, so that they come in order: an index over names without order costs a page in a random place for each, which is more
/// than a second copy of a small result now and then.
const NAMED_BY_TIME_BYTES: usize = 32 << 10;

/// A result that can be put into a row.
#[derive(Debug)]
pub(super) struct Prepared {
    /// Its name in the database: the same for other bytes never.
    pub(super) hash: [u8; 32],
    /// The file that holds the bytes; without one they belong into the row.
    pub(super) file: Option<String>,
}

#[derive(Debug, Clone)]
pub(super) enum Files {
    Folder(PathBuf),
    Bucket(Bucket),
}

#[derive(Clone)]
pub(super) struct Bucket {
    objects: Arc<dyn ObjectStore>,
    prefix: ObjectPath,
}

// What it holds knows credentials.
impl fmt::Debug for Bucket {
    fn fmt(&self, formatter: &mut fmt::Formatter<'_>) -> fmt::Result {
        formatter.debug_struct("Bucket").field("prefix", &self.prefix).finish_non_exhaustive()
    }
}

impl Bucket {
    /// `BUCKET/PREFIX`; region, endpoint and credentials come from the environment as for every client of S3 (`AWS_REGION`,
    /// `AWS_ENDPOINT_URL`, `AWS_ACCESS_KEY_ID`, `AWS_SECRET_ACCESS_KEY`, or the machine's role).
    fn open(place: &str) -> Result<Self> {
        let (name, prefix) = place.split_once('/').unwrap_or((place, ""));
        let unusable = |error: &dyn fmt::Display| StoreError::Url(format!("{BUCKET_SCHEME}{place}: {error}"));
        // Fails if the process has one already, which is as good.
        let _ = rustls::crypto::ring::default_provider().install_default();
        let retry =
            RetryConfig { max_retries: BUCKET_RETRIES, retry_timeout: BUCKET_PATIENCE, ..RetryConfig::default() };
        let objects = AmazonS3Builder::from_env().with_bucket_name(name).with_retry(retry).build();
        let objects: Arc<dyn ObjectStore> = Arc::new(objects.map_err(|error| unusable(&error))?);
        Ok(Self { objects, prefix: ObjectPath::parse(prefix).map_err(|error| unusable(&error))? })
    }

    fn path(&self, file: &str) -> ObjectPath {
        self.prefix.clone().join(file)
    }
}

impl From<object_store::Error> for StoreError {
    fn from(error: object_store::Error) -> Self {
        Self::Unavailable(format!("the bucket: {error}"))
    }
}

impl Files {
    /// A folder, created if missing, or `s3://BUCKET/PREFIX`.
    pub(super) fn open(place: &str) -> Result<Self> {
        if let Some(bucket) = place.strip_prefix(BUCKET_SCHEME) {
            return Bucket::open(bucket).map(Self::Bucket);
        }
        fs::create_dir_all(place)?;
        Ok(Self::Folder(place.into()))
    }

    pub(super) async fn read(&self, file: &str) -> Result<Vec<u8>> {
        match self {
            Self::Folder(folder) => {
                let path = folder.join(file);
                blocking(move || fs::read(path)).await
            }
            Self::Bucket(bucket) => Ok(bucket.objects.get(&bucket.path(file)).await?.bytes().await?.into()),
        }
    }

    async fn write(&self, file: &str, bytes: &[u8]) -> Result<()> {
        match self {
            Self::Folder(folder) => {
                let (folder, file, bytes) = (folder.clone(), file.to_owned(), bytes.to_vec());
                blocking(move || {
                    let unfinished = folder.join(format!("{file}.part"));
                    let written = write_synced(&unfinished, &bytes)
                        .and_then(|()| fs::rename(&unfinished, folder.join(&file)))
                        // The name itself is on disk once the folder is.
                        .and_then(|()| File::open(&folder)?.sync_all());
                    if written.is_err() {
                        let _ = fs::remove_file(&unfinished);
                    }
                    written
                })
                .await
            }
            Self::Bucket(bucket) => {
                bucket.objects.put(&bucket.path(file), PutPayload::from(bytes.to_vec())).await?;
                Ok(())
            }
        }
    }

    /// Removes a file that no row names; one that cannot be removed now is left to the next sweep.
    pub(super) async fn remove(&self, file: String) {
        let removed = match self {
            Self::Folder(folder) => {
                let path = folder.join(&file);
                blocking(move || fs::remove_file(path)).await
            }
            Self::Bucket(bucket) => bucket.objects.delete(&bucket.path(&file)).await.map_err(StoreError::from),
        };
        if let Err(error) = removed {
            tracing::warn!(%error, file, "removing a result file");
        }
    }

    /// Names of files last written longer ago than `age`.
    pub(super) async fn older_than(&self, age: Duration) -> Result<Vec<String>> {
        match self {
            Self::Folder(folder) => {
                let folder = folder.clone();
                blocking(move || {
                    let mut old = Vec::new();
                    for entry in fs::read_dir(folder)? {
                        let entry = entry?;
                        // A file that vanished meanwhile is somebody else's removal.
                        let Ok(modified) = entry.metadata().and_then(|metadata| metadata.modified()) else { continue };
                        if modified.elapsed().unwrap_or_default() >= age
                            && let Ok(name) = entry.file_name().into_string()
                        {
                            old.push(name);
                        }
                    }
                    Ok(old)
                })
                .await
            }
            Self::Bucket(bucket) => {
                // By the bucket's clock, which may differ from ours by less than `age`.
                let now_ms = jiff::Timestamp::now().as_millisecond();
                let age_ms = super::milliseconds(age);
                let prefix = Some(&bucket.prefix).filter(|prefix| !prefix.as_ref().is_empty());
                let objects: Vec<_> = bucket.objects.list(prefix).try_collect().await?;
                let old =
                    objects.into_iter().filter(|object| now_ms - object.last_modified.timestamp_millis() >= age_ms);
                // What lies deeper is nobody's of ours.
                let names = old.filter_map(|object| {
                    let name = object.location.filename()?.to_owned();
                    (bucket.path(&name) == object.location).then_some(name)
                });
                Ok(names.collect())
            }
        }
    }
}

/// A name that holds most of a hash, behind the milliseconds since 1970 by this process's clock, which only have to put names
/// near to each other that come about at the same time.
fn named_by_time(hash: [u8; 32]) -> [u8; 32] {
    let since_1970 = SystemTime::now().duration_since(SystemTime::UNIX_EPOCH).unwrap_or_default();
    let milliseconds = u64::try_from(since_1970.as_millis()).unwrap_or(u64::MAX).to_be_bytes();
    let mut name = hash;
    name[..6].copy_from_slice(&milliseconds[2..]);
    name
}

fn write_synced(path: &std::path::Path, bytes: &[u8]) -> io::Result<()> {
    let mut file = File::create(path)?;
    file.write_all(bytes)?;
    file.sync_all()
}

async fn blocking<T: Send + 'static>(work: impl FnOnce() -> io::Result<T> + Send + 'static) -> Result<T> {
    match tokio::task::spawn_blocking(work).await {
        Ok(result) => Ok(result?),
        Err(error) => Err(StoreError::Unavailable(error.to_string())),
    }
}

impl Store {
    /// Writes a result's file, if it is large.
    pub(super) async fn prepare(&self, id: &str, attempt: i64, bytes: &[u8], hash: [u8; 32]) -> Result<Prepared> {
        let file = match &self.inner.files {
            Some(files) if bytes.len() > self.inner.options.inline_bytes => {
                let file = format!("{id}-{attempt}");
                files.write(&file, bytes).await?;
                Some(file)
            }
            _ => None,
        };
        Ok(Prepared { hash: if bytes.len() > NAMED_BY_TIME_BYTES { hash } else { named_by_time(hash) }, file })
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[tokio::test]
    async fn a_bucket_gives_back_lists_and_removes_what_was_put_into_it() {
        let objects: Arc<dyn ObjectStore> = Arc::new(object_store::memory::InMemory::new());
        for prefix in ["", "results/of-ours"] {
            let bucket = Bucket { objects: objects.clone(), prefix: ObjectPath::parse(prefix).unwrap() };
            let files = Files::Bucket(bucket.clone());
            files.write("one-1", b"mesh").await.unwrap();
            files.write("two-1", b"other").await.unwrap();
            // Somebody else's, deeper.
            bucket.objects.put(&bucket.path("else").join("three-1"), PutPayload::from("theirs")).await.unwrap();
            assert_eq!(files.read("one-1").await.unwrap(), b"mesh");
            let mut names = files.older_than(Duration::ZERO).await.unwrap();
            names.sort();
            assert_eq!(names, ["one-1", "two-1"], "in {prefix:?}");
            assert!(files.older_than(Duration::from_secs(3600)).await.unwrap().is_empty());
            files.remove("one-1".into()).await;
            assert!(matches!(files.read("one-1").await, Err(StoreError::Unavailable(_))));
            assert_eq!(files.older_than(Duration::ZERO).await.unwrap(), ["two-1"]);
        }
    }

    #[test]
    fn a_bucket_does_not_show_what_it_holds() {
        let objects: Arc<dyn ObjectStore> = Arc::new(object_store::memory::InMemory::new());
        let shown = format!("{:?}", Bucket { objects, prefix: ObjectPath::parse("results").unwrap() });
        assert_eq!(shown, "Bucket { prefix: Path { raw: \"results\" }, .. }");
    }
}
