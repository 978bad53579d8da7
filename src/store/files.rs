//! Large results outside of the database, in a folder or a bucket. A file is written completely and durably before the
//! row that names it is committed. It is never changed, and it is removed after the row is gone. Its name contains the
//! job and the attempt, so two writers never share a file. A file without a row was left by a worker that died in
//! between, and the sweep removes it.
//!
//! This module writes folders itself, because the library that writes buckets does not sync files to disk.

use std::fs::{self, File};
use std::io::{self, Write};
use std::path::{Path, PathBuf};
use std::time::Duration;

#[cfg(feature = "s3")]
use super::bucket::Bucket;
use super::{Result, StoreError};

/// Prefix of a setting that names a bucket instead of a folder.
pub(super) const BUCKET_SCHEME: &str = "s3://";
/// Prefix of the file that is written and removed to test whether results can be stored.
const PROBE: &str = "probe";

#[derive(Debug, Clone)]
pub(super) enum ResultStorage {
    Folder(PathBuf),
    #[cfg(feature = "s3")]
    Bucket(Bucket),
}

impl ResultStorage {
    /// Opens a folder, which is created if missing, or `s3://BUCKET/PREFIX`.
    pub(super) fn open(place: &str) -> Result<Self> {
        Self::check(place)?;
        #[cfg(feature = "s3")]
        if let Some(bucket) = place.strip_prefix(BUCKET_SCHEME) {
            return Bucket::open(bucket).map(Self::Bucket);
        }
        fs::create_dir_all(place)?;
        Ok(Self::Folder(place.into()))
    }

    /// Fails if `place` is a bucket and this program was built without support for buckets.
    pub(super) fn check(place: &str) -> Result<()> {
        if cfg!(feature = "s3") || !place.starts_with(BUCKET_SCHEME) {
            return Ok(());
        }
        Err(StoreError::Url(format!(
            "{place}: this program was built without support for buckets (cargo build --features s3)"
        )))
    }

    /// Returns the bytes of a file, or `None` if it does not exist.
    pub(super) async fn read(&self, file: &str) -> Result<Option<Vec<u8>>> {
        match self {
            Self::Folder(folder) => {
                let path = folder.join(file);
                let read = move || match fs::read(path) {
                    Err(error) if error.kind() == io::ErrorKind::NotFound => Ok(None),
                    read => read.map(Some),
                };
                blocking(read).await
            }
            #[cfg(feature = "s3")]
            Self::Bucket(bucket) => bucket.read(file).await,
        }
    }

    pub(super) async fn write(&self, file: &str, bytes: &[u8]) -> Result<()> {
        match self {
            Self::Folder(folder) => {
                let (folder, file, bytes) = (folder.clone(), file.to_owned(), bytes.to_vec());
                blocking(move || write_into(&folder, &file, &bytes)).await
            }
            #[cfg(feature = "s3")]
            Self::Bucket(bucket) => bucket.write(file, bytes).await,
        }
    }

    /// Tests whether results can be stored, by writing and removing a small file.
    pub(super) async fn probe(&self) -> Result<()> {
        // Each name is used only once, because other processes may probe the same storage at the same time. A process
        // number would not be unique, because it is 1 in every container.
        let file = format!("{PROBE}-{}", ulid::Ulid::generate());
        self.write(&file, b"probe").await?;
        self.remove(file).await;
        Ok(())
    }

    /// Removes a file that no row names. If that fails, the next sweep tries again.
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
            tracing::warn!(%error, file, "cannot remove a result file");
        }
    }

    /// Returns the names of files that were last written longer ago than `age`.
    pub(super) async fn older_than(&self, age: Duration) -> Result<Vec<String>> {
        match self {
            Self::Folder(folder) => {
                let folder = folder.clone();
                blocking(move || old_files(&folder, age)).await
            }
            #[cfg(feature = "s3")]
            Self::Bucket(bucket) => bucket.older_than(age).await,
        }
    }
}

fn write_into(folder: &Path, file: &str, bytes: &[u8]) -> io::Result<()> {
    let unfinished = folder.join(format!("{file}.part"));
    let write = || {
        let mut written = File::create(&unfinished)?;
        written.write_all(bytes)?;
        written.sync_all()?;
        fs::rename(&unfinished, folder.join(file))?;
        // The new name is durable only after the folder has been synced.
        File::open(folder)?.sync_all()
    };
    let written = write();
    if written.is_err() {
        // Removal fails if the file was not created, which does no harm.
        let _ = fs::remove_file(&unfinished);
    }
    written
}

fn old_files(folder: &Path, age: Duration) -> io::Result<Vec<String>> {
    let mut old = Vec::new();
    for entry in fs::read_dir(folder)? {
        let entry = entry?;
        // A file that disappeared meanwhile was removed by another process.
        let Ok(modified) = entry.metadata().and_then(|metadata| metadata.modified()) else { continue };
        if modified.elapsed().unwrap_or_default() >= age
            && let Ok(name) = entry.file_name().into_string()
        {
            old.push(name);
        }
    }
    Ok(old)
}

async fn blocking<T: Send + 'static>(work: impl FnOnce() -> io::Result<T> + Send + 'static) -> Result<T> {
    match tokio::task::spawn_blocking(work).await {
        Ok(result) => Ok(result?),
        Err(error) => Err(StoreError::Unavailable(error.to_string())),
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[tokio::test(flavor = "multi_thread", worker_threads = 2)]
    async fn many_probes_of_one_storage_do_not_disturb_each_other() {
        let folder = tempfile::tempdir().unwrap();
        let place = folder.path().display().to_string();
        let probes: Vec<_> = (0..32)
            .map(|_| {
                let files = ResultStorage::open(&place).unwrap();
                tokio::spawn(async move { files.probe().await })
            })
            .collect();
        for probe in probes {
            probe.await.unwrap().unwrap();
        }
        assert_eq!(fs::read_dir(folder.path()).unwrap().count(), 0);
    }
}
