//! Cache of files made from results, in memory up to a budget. A stored mesh never changes, so a file made from it in
//! one format is the same for every reader, range request and revalidation.

use bytes::Bytes;
use sha2::{Digest, Sha256};
use std::collections::HashMap;
use std::sync::{Arc, Mutex, MutexGuard, PoisonError};

/// A file and a tag that identifies its content.
#[derive(Clone, Debug)]
pub struct File {
    pub bytes: Bytes,
    /// Hash of the bytes, 32 hex digits.
    pub tag: Arc<str>,
}

impl File {
    #[must_use]
    pub fn new(bytes: Vec<u8>) -> Self {
        let digest = Sha256::digest(&bytes);
        let tag: String = digest.iter().take(16).map(|byte| format!("{byte:02x}")).collect();
        Self { bytes: bytes.into(), tag: tag.into() }
    }
}

/// Hash of the stored result, and name of the conversion.
pub type Key = (Vec<u8>, String);

#[derive(Debug)]
pub struct Files {
    budget_bytes: usize,
    kept: Mutex<Kept>,
}

#[derive(Debug, Default)]
struct Kept {
    files: HashMap<Key, (File, u64)>,
    bytes: usize,
    /// Number of uses so far. The file with the oldest last use is dropped first.
    clock: u64,
}

/// Bytes counted for each file besides its content, so that the budget also limits the number of files.
const OVERHEAD_BYTES: usize = 1024;

impl Files {
    #[must_use]
    pub fn new(budget_bytes: usize) -> Self {
        Self { budget_bytes, kept: Mutex::default() }
    }

    fn kept(&self) -> MutexGuard<'_, Kept> {
        self.kept.lock().unwrap_or_else(PoisonError::into_inner)
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

    /// Keeps a file unless it would take more than half of the budget. Other files are dropped to make room, longest
    /// unused first.
    pub fn put(&self, key: Key, file: File) {
        let size = file.bytes.len() + OVERHEAD_BYTES;
        if size > self.budget_bytes / 2 {
            return;
        }
        let mut kept = self.kept();
        kept.clock += 1;
        let now = kept.clock;
        if kept.files.insert(key, (file, now)).is_none() {
            kept.bytes += size;
        }
        while kept.bytes > self.budget_bytes {
            let oldest = kept.files.iter().min_by_key(|(_, (_, used_at))| *used_at).map(|(key, _)| key.clone());
            let Some((file, _)) = oldest.and_then(|key| kept.files.remove(&key)) else { break };
            kept.bytes -= file.bytes.len() + OVERHEAD_BYTES;
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn file(bytes: usize) -> File {
        File::new(vec![0; bytes])
    }

    #[test]
    fn the_longest_unused_file_is_dropped_first() {
        let files = Files::new(10 * OVERHEAD_BYTES);
        let key = |name: &str| (vec![1], name.to_owned());
        for name in ["glb", "obj", "ply"] {
            files.put(key(name), file(2 * OVERHEAD_BYTES));
        }
        assert!(files.get(&key("glb")).is_some());
        files.put(key("stl"), file(2 * OVERHEAD_BYTES));
        let there = ["glb", "obj", "ply", "stl"].map(|name| files.get(&key(name)).is_some());
        assert_eq!(there, [true, false, true, true]);
        // Replacing a file does not count its bytes twice.
        files.put(key("stl"), file(2 * OVERHEAD_BYTES));
        assert_eq!(files.kept().bytes, 9 * OVERHEAD_BYTES);
    }

    #[test]
    fn a_file_that_would_fill_the_budget_is_not_kept() {
        let files = Files::new(10 * OVERHEAD_BYTES);
        let key = (vec![1], "glb".to_owned());
        files.put(key.clone(), file(5 * OVERHEAD_BYTES));
        assert!(files.get(&key).is_none());
        assert_eq!(files.kept().bytes, 0);
    }
}
