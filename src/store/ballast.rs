//! A file whose only purpose is to occupy disk space. On a full disk its space is needed in two ways. Accepted jobs
//! must be able to end, and the sweep must be able to run: the sweep writes before it frees space, and the write-ahead
//! log has to be copied into the database before its own space comes back. A quarter of the file is therefore given to
//! jobs, and the rest to the sweep alone, because jobs that took all of it would leave the disk full for ever. New jobs
//! are refused until the whole file is back.

use std::fs::{self, File, OpenOptions};
use std::io::{self, Write};
use std::path::{Path, PathBuf};
use std::sync::atomic::{AtomicU8, Ordering};

/// Value of `reserve`: the file has its whole size, for accepted jobs and for a sweep.
const WHOLE: u8 = 0;
/// Value of `reserve`: the file is shortened to the part for a sweep. Accepted jobs use the space that this freed.
const FOR_SWEEP: u8 = 1;
/// Value of `reserve`: there is no file, because a sweep runs, or because the disk is still full after a sweep.
const NOTHING: u8 = 2;

#[derive(Debug)]
pub(super) struct Ballast {
    path: PathBuf,
    bytes: u64,
    /// `WHOLE`, `FOR_SWEEP` or `NOTHING`.
    reserve: AtomicU8,
}

impl Ballast {
    /// Describes the ballast of the database file `database`. The ballast file is in the same folder. With `bytes` = 0
    /// there is no ballast.
    pub(super) fn new(database: &Path, bytes: u64) -> Self {
        let mut name = database.as_os_str().to_owned();
        name.push("-ballast");
        Self { path: name.into(), bytes, reserve: AtomicU8::new(WHOLE) }
    }

    /// Returns whether some of the file was given up, so that new jobs are to be refused.
    pub(super) fn is_given_up(&self) -> bool {
        self.reserve.load(Ordering::Relaxed) != WHOLE
    }

    /// Returns whether results are to be refused, because the space that is left is for a sweep.
    pub(super) fn is_gone(&self) -> bool {
        self.reserve.load(Ordering::Relaxed) == NOTHING
    }

    fn change(&self, from: u8, to: u8) -> bool {
        self.reserve.compare_exchange(from, to, Ordering::Relaxed, Ordering::Relaxed).is_ok()
    }

    /// Bytes of the file that only a sweep may use.
    fn for_sweep(&self) -> u64 {
        self.bytes / 4 * 3
    }

    /// Frees the part for accepted jobs.
    pub(super) fn give_up(&self) {
        if self.bytes == 0 || !self.change(WHOLE, FOR_SWEEP) {
            return;
        }
        tracing::error!(file = %self.path.display(),
            "the disk is full: shortened the ballast file; new jobs are refused");
        let cut = OpenOptions::new().write(true).open(&self.path).and_then(|file| file.set_len(self.for_sweep()));
        if let Err(error) = cut {
            tracing::error!(%error, file = %self.path.display(), "cannot shorten the ballast file");
        }
    }

    /// Frees the rest of a file that was given up in part, for a sweep. From here on results are refused until
    /// [`Ballast::restore`] finds space.
    pub(super) fn give_up_rest(&self) {
        if !self.change(FOR_SWEEP, NOTHING) {
            return;
        }
        if let Err(error) = fs::remove_file(&self.path) {
            tracing::error!(%error, file = %self.path.display(), "cannot remove the ballast file");
        }
    }

    /// Creates the file again if the disk has twice its size free: once for the file and once for new jobs. Otherwise
    /// creates the part for a sweep, if the disk has space for the whole file.
    pub(super) fn restore(&self) {
        if self.bytes == 0 || fs::metadata(&self.path).is_ok_and(|file| file.len() == self.bytes) {
            return;
        }
        let reserve = match self.write(2 * self.bytes, self.bytes) {
            Ok(()) => WHOLE,
            Err(error) => {
                let mib = (2 * self.bytes) >> 20;
                tracing::warn!(%error, "the disk has less than {mib} MiB of room; new jobs are refused");
                if self.write(self.bytes, self.for_sweep()).is_ok() { FOR_SWEEP } else { NOTHING }
            }
        };
        let before = self.reserve.swap(reserve, Ordering::Relaxed);
        if (before, reserve) == (NOTHING, WHOLE) {
            tracing::info!("the disk has room again");
        }
    }

    /// Writes `room` bytes to test that the disk has space for them, and then shortens the file to its first `kept`
    /// bytes. Leaves no file if a write fails.
    fn write(&self, room: u64, kept: u64) -> io::Result<()> {
        let written = File::create(&self.path).and_then(|mut file| {
            let zeros = vec![0; 1 << 20];
            let mut left = room;
            while left > 0 {
                let step = left.min(zeros.len() as u64);
                file.write_all(&zeros[..step as usize])?;
                left -= step;
            }
            // The file is not synced, because file systems allocate the space when it is written, and losing the file
            // in a crash does no harm.
            file.set_len(kept)
        });
        if written.is_err() {
            // Removal fails if the file was not created, which does no harm.
            let _ = fs::remove_file(&self.path);
        }
        written
    }
}
