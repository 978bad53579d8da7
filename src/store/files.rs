//! Large results outside of the database: as files of a folder, or as objects of an S3-compatible bucket. Written whole and
//! durably before the row that names them commits, never changed, removed after the row is gone. A name holds job and attempt,
//! so no two writers ever share one; what is there without a row is left by a worker that died in between, and the sweep
//! removes it.
//!
//! The folder is not object_store's: that one does not sync what it writes.

use std::fs::{self, File};
use std::io::{self, Write};
use std::path::PathBuf;
use std::time::{Duration, SystemTime};

#[cfg(feature = "s3")]
use super::bucket::Bucket;
use super::engine::Result;
use super::{Store, StoreError};

/// What names a bucket instead of a folder.
pub(super) const BUCKET_SCHEME: &str = "s3://";

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
    #[cfg(feature = "s3")]
    Bucket(Bucket),
}

impl Files {
    /// A folder, created if missing, or `s3://BUCKET/PREFIX`.
    pub(super) fn open(place: &str) -> Result<Self> {
        if let Some(bucket) = place.strip_prefix(BUCKET_SCHEME) {
            #[cfg(feature = "s3")]
            return Bucket::open(bucket).map(Self::Bucket);
            #[cfg(not(feature = "s3"))]
            return Err(StoreError::Url(format!(
                "{BUCKET_SCHEME}{bucket}: this program was built without support for buckets (cargo build --features s3)"
            )));
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
            #[cfg(feature = "s3")]
            Self::Bucket(bucket) => bucket.read(file).await,
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
            #[cfg(feature = "s3")]
            Self::Bucket(bucket) => bucket.write(file, bytes).await,
        }
    }

    /// Removes a file that no row names; one that cannot be removed now is left to the next sweep.
    pub(super) async fn remove(&self, file: String) {
        let removed = match self {
            Self::Folder(folder) => {
                let path = folder.join(&file);
                blocking(move || fs::remove_file(path)).await
            }
            #[cfg(feature = "s3")]
            Self::Bucket(bucket) => bucket.remove(&file).await,
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
            #[cfg(feature = "s3")]
            Self::Bucket(bucket) => bucket.older_than(age).await,
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
