//! Large results as files of a folder: written whole and synced before the row that names them commits, never changed,
//! removed after the row is gone. A name holds job and attempt, so no two writers ever share one; a file without a row
//! is left by a worker that died in between, and the sweep removes it.

use std::fs::{self, File};
use std::io::{self, Write};
use std::path::{Path, PathBuf};
use std::time::Duration;

use sha2::{Digest, Sha256};

use super::engine::Result;
use super::{Store, StoreError};

/// A result that can be put into a row.
#[derive(Debug)]
pub(super) struct Prepared {
    pub(super) hash: [u8; 32],
    /// The file that holds the bytes; without one they belong into the row.
    pub(super) file: Option<String>,
}

#[derive(Debug, Clone)]
pub(super) struct Files {
    folder: PathBuf,
}

impl Files {
    pub(super) fn open(folder: &Path) -> Result<Self> {
        fs::create_dir_all(folder)?;
        Ok(Self { folder: folder.to_owned() })
    }

    pub(super) async fn read(&self, file: &str) -> Result<Vec<u8>> {
        let path = self.folder.join(file);
        blocking(move || fs::read(path)).await
    }

    async fn write(&self, file: &str, bytes: &[u8]) -> Result<()> {
        let (folder, file, bytes) = (self.folder.clone(), file.to_owned(), bytes.to_vec());
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

    /// Removes a file that no row names; one that cannot be removed now is left to the next sweep.
    pub(super) async fn remove(&self, file: String) {
        let path = self.folder.join(&file);
        match blocking(move || fs::remove_file(path)).await {
            Ok(()) => {}
            Err(error) => tracing::warn!(%error, file, "removing a result file"),
        }
    }

    /// Names of files last written longer ago than `age`.
    pub(super) async fn older_than(&self, age: Duration) -> Result<Vec<String>> {
        let folder = self.folder.clone();
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
}

fn write_synced(path: &Path, bytes: &[u8]) -> io::Result<()> {
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
    /// Hashes a result and, if it is large, writes its file.
    pub(super) async fn prepare(&self, id: &str, attempt: i64, bytes: &[u8]) -> Result<Prepared> {
        let hash = Sha256::digest(bytes).into();
        let file = match &self.inner.files {
            Some(files) if bytes.len() > self.inner.options.inline_bytes => {
                let file = format!("{id}-{attempt}");
                files.write(&file, bytes).await?;
                Some(file)
            }
            _ => None,
        };
        Ok(Prepared { hash, file })
    }
}
