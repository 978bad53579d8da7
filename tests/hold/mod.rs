//! Holds jobs at a stage, so that no test depends on how long a solver takes. `src/test_hooks.rs` has the other side.

#![allow(dead_code, reason = "not every test uses every function")]

use std::path::{Path, PathBuf};
use std::time::{Duration, Instant};

/// Variable that tells a server the folder of its holds.
pub const VARIABLE: &str = "PLATEAU_TEST_HOLD_DIR";

/// Folder of the holds of one server, or of several servers on one database.
pub struct Hold {
    pub folder: PathBuf,
}

impl Hold {
    /// Makes the folder if it does not exist. Otherwise its holds stay, and the marks of a killed server are removed.
    pub fn new(folder: &Path) -> Self {
        std::fs::create_dir_all(folder).expect("a folder");
        let hold = Self { folder: folder.into() };
        hold.remove("held.");
        hold
    }

    /// Holds every job that reaches the stage, until [`release`](Self::release). The stage is `claimed`,
    /// `first_progress`, `half` or `storing`. `half.ruled_surface` holds jobs of one kind only.
    pub fn at(&self, stage: &str) {
        if !cfg!(feature = "test-hooks") {
            panic!("this test holds jobs, so it needs --features test-hooks");
        }
        std::fs::write(self.folder.join(stage), []).expect("the hold is written");
    }

    pub fn release(&self, stage: &str) {
        std::fs::remove_file(self.folder.join(stage)).expect("the hold is removed");
    }

    /// Removes every hold, and the marks of a killed server.
    pub fn release_all(&self) {
        self.remove("");
    }

    pub fn is_held(&self, stage: &str, id: &str) -> bool {
        self.folder.join(format!("held.{stage}.{id}")).exists()
    }

    /// Waits until the job is held at the stage.
    pub async fn reached(&self, stage: &str, id: &str) {
        until(&format!("job {id} is held at {stage}"), async || self.is_held(stage, id)).await;
    }

    /// Waits until this number of jobs is held at the stage.
    pub async fn reached_by(&self, stage: &str, count: usize) {
        let start = format!("held.{stage}.");
        until(&format!("{count} jobs are held at {stage}"), async || self.files(&start).len() >= count).await;
    }

    fn files(&self, start: &str) -> Vec<PathBuf> {
        let entries = std::fs::read_dir(&self.folder).expect("the folder").map(|entry| entry.expect("an entry"));
        let named = entries.filter(|entry| entry.file_name().to_string_lossy().starts_with(start));
        named.map(|entry| entry.path()).collect()
    }

    fn remove(&self, start: &str) {
        for file in self.files(start) {
            // A server may remove its own mark at the same time.
            let _ = std::fs::remove_file(file);
        }
    }
}

/// Returns the child processes of a process, which solve its large jobs.
pub fn children_of(id: u32) -> Vec<u32> {
    let entries = std::fs::read_dir("/proc").expect("procfs").filter_map(Result::ok);
    let ids = entries.filter_map(|entry| entry.file_name().to_str()?.parse::<u32>().ok());
    // A process may end while the folder is read. Its name is in parentheses, and a state and its parent follow.
    let parent = |child: u32| -> Option<u32> {
        let stat = std::fs::read_to_string(format!("/proc/{child}/stat")).ok()?;
        stat.rsplit(") ").next()?.split(' ').nth(1)?.parse().ok()
    };
    ids.filter(|child| parent(*child) == Some(id)).collect()
}

/// Waits until the condition holds. Fails after a time that no step takes on any machine.
pub async fn until(what: &str, condition: impl AsyncFn() -> bool) {
    let started = Instant::now();
    while !condition().await {
        assert!(started.elapsed() < Duration::from_secs(300), "never seen: {what}");
        // Pause between two checks of the condition.
        tokio::time::sleep(Duration::from_millis(5)).await;
    }
}
