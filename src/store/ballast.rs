//! A file whose only purpose is to occupy disk space. When the disk is full, the file is deleted, so that accepted jobs
//! can end and the sweep can run, which writes before it frees space. New jobs are refused until the file is back.

use std::fs::{self, File};
use std::io::{self, Write};
use std::path::{Path, PathBuf};
use std::sync::atomic::{AtomicBool, Ordering};

#[derive(Debug)]
pub(super) struct Ballast {
    path: PathBuf,
    bytes: u64,
    given_up: AtomicBool,
}

impl Ballast {
    /// Describes the ballast of a database, whose file is beside the database's. With `bytes` = 0 there is no ballast.
    pub(super) fn new(database: &Path, bytes: u64) -> Self {
        let mut name = database.as_os_str().to_owned();
        name.push("-ballast");
        Self { path: name.into(), bytes, given_up: AtomicBool::new(false) }
    }

    pub(super) fn is_given_up(&self) -> bool {
        self.given_up.load(Ordering::Relaxed)
    }

    /// Deletes the file to make space.
    pub(super) fn give_up(&self) {
        if self.bytes == 0 || self.given_up.swap(true, Ordering::Relaxed) {
            return;
        }
        tracing::error!(file = %self.path.display(), "the disk is full: deleted the ballast file; new jobs are refused");
        if let Err(error) = fs::remove_file(&self.path) {
            tracing::error!(%error, file = %self.path.display(), "cannot remove the ballast file");
        }
    }

    /// Creates the file again if the disk has twice its size free: once for the file and once for new jobs.
    pub(super) fn restore(&self) {
        if self.bytes == 0 || fs::metadata(&self.path).is_ok_and(|file| file.len() == self.bytes) {
            return;
        }
        let written = self.write();
        if written.is_err() {
            // Removal fails if the file was not created, which does no harm.
            let _ = fs::remove_file(&self.path);
        }
        let failed_before = self.given_up.swap(written.is_err(), Ordering::Relaxed);
        match written {
            Ok(()) if failed_before => tracing::info!("the disk has room again"),
            Ok(()) => {}
            Err(error) => {
                let mib = (2 * self.bytes) >> 20;
                tracing::warn!(%error, "the disk has less than {mib} MiB of room; new jobs are refused");
            }
        }
    }

    fn write(&self) -> io::Result<()> {
        let mut file = File::create(&self.path)?;
        let zeros = vec![0; 1 << 20];
        let mut left = 2 * self.bytes;
        while left > 0 {
            let step = left.min(zeros.len() as u64);
            file.write_all(&zeros[..step as usize])?;
            left -= step;
        }
        // The file is not synced, because file systems allocate the space when it is written, and losing the file in a
        // crash does no harm.
        file.set_len(self.bytes)
    }
}
