//! Files made from results, and their cache. A stored mesh never changes, so a file made from it in one format is
//! the same for every reader, range request and revalidation.
//!
//! Small files are in memory. Others are unnamed files on disk, so that a slow reader occupies only one piece of its
//! file in memory. The cache drops the longest unused files. A file on disk that is still being read keeps its space
//! until its last reader has ended.

use super::JobsError;
use bytes::Bytes;
use futures_util::stream::{self, Stream};
use sha2::{Digest, Sha256};
use std::collections::HashMap;
use std::io::{self, Write};
use std::ops::Range;
use std::os::unix::fs::FileExt;
use std::path::PathBuf;
use std::sync::atomic::{AtomicU64, Ordering};
use std::sync::{Arc, Mutex, MutexGuard, PoisonError};
use tokio::sync::Semaphore;

/// Largest size in bytes of a file that is kept in memory. Readers of 4,096 different files of this size need 1 GiB.
const IN_MEMORY_BYTES: usize = 256 << 10;
/// Size in bytes of the pieces in which a file is read from disk.
const PIECE_BYTES: usize = 64 << 10;
/// Number of pieces that are read at once. Each needs a thread.
const READS: usize = 8;
/// Bytes counted for each file in memory besides its content, so that the budget also limits the number of files.
const OVERHEAD_BYTES: usize = 1024;

/// A file and a tag that identifies its content.
#[derive(Clone, Debug)]
pub struct File {
    content: Content,
    pub length: usize,
    /// Hash of the bytes, 32 hex digits.
    pub tag: Arc<str>,
    /// CRC-32 of the bytes.
    pub checksum: u32,
}

#[derive(Clone, Debug)]
enum Content {
    Memory(Bytes),
    Disk(Arc<OnDisk>),
}

/// An unnamed file. Its space is free again when it is dropped.
#[derive(Debug)]
struct OnDisk {
    file: std::fs::File,
    reads: Arc<Semaphore>,
    _space: Space,
}

/// Reserved disk space, which is returned when dropped.
#[derive(Debug)]
struct Space {
    used_bytes: Arc<AtomicU64>,
    bytes: u64,
}

impl Drop for Space {
    fn drop(&mut self) {
        self.used_bytes.fetch_sub(self.bytes, Ordering::Relaxed);
    }
}

impl File {
    /// Returns at most [`PIECE_BYTES`] bytes from the beginning of the range.
    async fn piece(&self, range: Range<usize>) -> io::Result<Bytes> {
        match &self.content {
            Content::Memory(bytes) => Ok(bytes.slice(range)),
            Content::Disk(disk) => {
                let (disk, length) = (disk.clone(), range.len().min(PIECE_BYTES));
                // Acquiring cannot fail, because the semaphore is never closed.
                let _permit = disk.reads.clone().acquire_owned().await;
                // Allocated here, because the allocator would keep memory for each thread that reads.
                let mut piece = vec![0; length];
                let read = move || disk.file.read_exact_at(&mut piece, range.start as u64).map(|()| Bytes::from(piece));
                tokio::task::spawn_blocking(read).await.map_err(io::Error::other)?
            }
        }
    }

    /// Returns the bytes of a range, which must lie within the file.
    pub fn stream(self, range: Range<usize>) -> impl Stream<Item = io::Result<Bytes>> + Send + 'static {
        stream::try_unfold((self, range), |(file, range)| async move {
            if range.is_empty() {
                return Ok(None);
            }
            let piece = file.piece(range.clone()).await?;
            let rest = range.start + piece.len()..range.end;
            Ok(Some((piece, (file, rest))))
        })
    }

    /// Returns all bytes, for answers that need them in memory.
    ///
    /// # Errors
    /// Returns [`JobsError::Unavailable`] if the disk cannot be read.
    pub async fn bytes(&self) -> Result<Bytes, JobsError> {
        let mut bytes = Vec::with_capacity(self.length);
        while bytes.len() < self.length {
            bytes.extend_from_slice(&self.piece(bytes.len()..self.length).await.map_err(unavailable)?);
        }
        Ok(bytes.into())
    }

    fn is_on_disk(&self) -> bool {
        matches!(self.content, Content::Disk(_))
    }

    /// Returns the number of bytes that the file counts for in the budget of the memory.
    fn counted_bytes(&self) -> usize {
        OVERHEAD_BYTES + if self.is_on_disk() { 0 } else { self.length }
    }
}

fn unavailable(error: io::Error) -> JobsError {
    tracing::error!(%error, "a file for a download cannot be stored or read");
    JobsError::Unavailable("this server has no disk space for the file; try again".into())
}

/// Hash of the stored result, and name of the conversion.
pub type Key = (Vec<u8>, String);

#[derive(Debug)]
pub struct FileCache {
    memory_bytes: usize,
    disk_bytes: u64,
    /// Folders for files on disk. The first one in which a file can be created is used.
    folders: Vec<PathBuf>,
    used_disk_bytes: Arc<AtomicU64>,
    /// Permits of the pieces that may be read at once.
    reads: Arc<Semaphore>,
    kept: Mutex<Kept>,
}

#[derive(Debug, Default)]
struct Kept {
    files: HashMap<Key, (File, u64)>,
    /// Sum of [`File::counted_bytes`].
    bytes: usize,
    /// Number of uses so far. The file with the oldest last use is dropped first.
    clock: u64,
}

impl Kept {
    /// Drops the longest unused file of those that `chosen` accepts. Returns false if there is none.
    fn drop_oldest(&mut self, chosen: impl Fn(&File) -> bool) -> bool {
        let candidates = self.files.iter().filter(|(_, (file, _))| chosen(file));
        let oldest = candidates.min_by_key(|(_, (_, used_at))| *used_at).map(|(key, _)| key.clone());
        let Some((file, _)) = oldest.and_then(|key| self.files.remove(&key)) else { return false };
        self.bytes -= file.counted_bytes();
        true
    }
}

impl FileCache {
    /// Returns a cache for `memory_bytes` of small files. All files on disk together take at most `disk_bytes`, except
    /// for a file that is the only one.
    #[must_use]
    pub fn new(memory_bytes: usize, disk_bytes: u64, folders: Vec<PathBuf>) -> Self {
        let (used_disk_bytes, reads) = (Arc::default(), Arc::new(Semaphore::new(READS)));
        Self { memory_bytes, disk_bytes, folders, used_disk_bytes, reads, kept: Mutex::default() }
    }

    fn kept(&self) -> MutexGuard<'_, Kept> {
        self.kept.lock().unwrap_or_else(PoisonError::into_inner)
    }

    /// Makes a file of `bytes`. Blocks while it is written.
    ///
    /// # Errors
    /// Returns [`JobsError::Unavailable`] if the disk, or the files' share of it, is full.
    pub fn file(&self, bytes: Vec<u8>) -> Result<File, JobsError> {
        let (length, checksum) = (bytes.len(), crc32fast::hash(&bytes));
        let tag: String = Sha256::digest(&bytes).iter().take(16).map(|byte| format!("{byte:02x}")).collect();
        let content = if length <= IN_MEMORY_BYTES {
            Content::Memory(bytes.into())
        } else {
            let space = self.reserve(length as u64).ok_or_else(|| {
                JobsError::Unavailable("the files that others download take up this server's space; try again".into())
            })?;
            let file = self.create().and_then(|mut file| file.write_all(&bytes).map(|()| file));
            let reads = self.reads.clone();
            Content::Disk(Arc::new(OnDisk { file: file.map_err(unavailable)?, reads, _space: space }))
        };
        Ok(File { content, length, tag: tag.into(), checksum })
    }

    fn create(&self) -> io::Result<std::fs::File> {
        let mut created = Err(io::ErrorKind::NotFound.into());
        for folder in &self.folders {
            created = tempfile::tempfile_in(folder);
            if created.is_ok() {
                break;
            }
        }
        created
    }

    /// Reserves disk space. Kept files are dropped to make room, longest unused first.
    fn reserve(&self, bytes: u64) -> Option<Space> {
        let mut kept = self.kept();
        loop {
            let used = self.used_disk_bytes.load(Ordering::Relaxed);
            if used == 0 || used + bytes <= self.disk_bytes {
                self.used_disk_bytes.fetch_add(bytes, Ordering::Relaxed);
                return Some(Space { used_bytes: self.used_disk_bytes.clone(), bytes });
            }
            if !kept.drop_oldest(File::is_on_disk) {
                return None;
            }
        }
    }

    pub fn get(&self, key: &Key) -> Option<File> {
        let mut kept = self.kept();
        kept.clock += 1;
        let now = kept.clock;
        kept.files.get_mut(key).map(|(file, used_at)| {
            *used_at = now;
            file.clone()
        })
    }

    /// Keeps a file. Other files are dropped to make room in memory, longest unused first.
    pub fn put(&self, key: Key, file: File) {
        let mut kept = self.kept();
        kept.clock += 1;
        let now = kept.clock;
        kept.bytes += file.counted_bytes();
        if let Some((replaced, _)) = kept.files.insert(key, (file, now)) {
            kept.bytes -= replaced.counted_bytes();
        }
        while kept.bytes > self.memory_bytes && kept.drop_oldest(|_| true) {}
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use futures_util::TryStreamExt;

    const LARGE: usize = 5 * PIECE_BYTES;

    fn files(memory_bytes: usize, disk_bytes: usize) -> FileCache {
        FileCache::new(memory_bytes, disk_bytes as u64, vec!["/nowhere".into(), std::env::temp_dir()])
    }

    fn key(name: &str) -> Key {
        (vec![1], name.to_owned())
    }

    #[test]
    fn the_longest_unused_file_is_dropped_first() {
        let files = files(10 * OVERHEAD_BYTES, 0);
        let file = || files.file(vec![0; 2 * OVERHEAD_BYTES]).unwrap();
        for name in ["glb", "obj", "ply"] {
            files.put(key(name), file());
        }
        assert!(files.get(&key("glb")).is_some());
        files.put(key("stl"), file());
        let there = ["glb", "obj", "ply", "stl"].map(|name| files.get(&key(name)).is_some());
        assert_eq!(there, [true, false, true, true]);
        // Replacing a file does not count its bytes twice.
        files.put(key("stl"), file());
        assert_eq!(files.kept().bytes, 9 * OVERHEAD_BYTES);
    }

    #[tokio::test]
    async fn a_large_file_is_read_from_disk_in_pieces() {
        let files = files(10 * OVERHEAD_BYTES, 2 * LARGE);
        let bytes: Vec<u8> = (0..LARGE + 7).map(|k| (k % 251) as u8).collect();
        let file = files.file(bytes.clone()).unwrap();
        assert!(file.is_on_disk());
        assert_eq!(file.checksum, crc32fast::hash(&bytes));
        assert!(file.bytes().await.unwrap() == bytes);
        let range = 5..LARGE + 6;
        let pieces: Vec<Bytes> = file.stream(range.clone()).try_collect().await.unwrap();
        assert!(pieces.iter().all(|piece| piece.len() <= PIECE_BYTES));
        assert!(pieces.concat() == bytes[range]);
    }

    #[test]
    fn a_file_on_disk_keeps_its_space_while_it_is_read() {
        let files = files(1 << 20, 2 * LARGE);
        let read = files.file(vec![0; LARGE]).unwrap();
        files.put(key("read"), read.clone());
        files.put(key("unread"), files.file(vec![0; LARGE]).unwrap());
        // The third file takes the place of the unread one, although the first one is the oldest.
        files.put(key("third"), files.file(vec![0; LARGE]).unwrap());
        assert!(files.get(&key("unread")).is_none());
        let (third, refused) = (files.get(&key("third")).unwrap(), files.file(vec![0; LARGE]));
        assert!(matches!(refused, Err(JobsError::Unavailable(_))), "both files are being read");
        drop((read, third));
        assert!(files.file(vec![0; LARGE]).is_ok());
        drop(files.file(vec![0; 10 * LARGE]).expect("the only file may be larger than the budget"));
    }
}
