//! Memory that this process may use: the limit of its container or the memory of the machine.

use std::fs;
use std::path::Path;

/// Returns the smallest of the memory limits of this process's control groups and the machine's memory, in bytes.
/// Returns `None` if none of them can be read, as outside Linux.
pub fn limit_bytes() -> Option<u64> {
    limit_below(Path::new("/"))
}

/// Same as [`limit_bytes`], with the files below `root`.
fn limit_below(root: &Path) -> Option<u64> {
    let read = |path: &str| fs::read_to_string(root.join(path.trim_start_matches('/'))).ok();
    let machine = read("proc/meminfo").and_then(|text| {
        let line = text.lines().find_map(|line| line.strip_prefix("MemTotal:"))?;
        Some(line.split_whitespace().next()?.parse::<u64>().ok()? * 1024)
    });
    // Control groups of version 2 have one hierarchy, whose line is `0::PATH`. Those of version 1 have a line that
    // names the memory controller. Inside a container the path may lead outside of what is mounted, so every folder
    // from the path up to the top is tried.
    let groups = read("proc/self/cgroup").unwrap_or_default();
    let mut limits: Vec<u64> = machine.into_iter().collect();
    for line in groups.lines() {
        let mut fields = line.splitn(3, ':').skip(1);
        let (top, file) = match fields.next() {
            Some("") => ("sys/fs/cgroup", "memory.max"),
            Some(controllers) if controllers.split(',').any(|name| name == "memory") => {
                ("sys/fs/cgroup/memory", "memory.limit_in_bytes")
            }
            _ => continue,
        };
        let path = Path::new(fields.next().unwrap_or_default().trim_start_matches('/'));
        for folder in path.ancestors() {
            let limit = Path::new(top).join(folder).join(file);
            // A group without a limit has the text `max`.
            limits.extend(limit.to_str().and_then(read).and_then(|text| text.trim().parse::<u64>().ok()));
        }
    }
    limits.into_iter().min()
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn the_least_limit_of_the_container_and_the_machine_counts() {
        let folder = tempfile::tempdir().unwrap();
        let root = folder.path();
        let write = |path: &str, text: &str| {
            let path = root.join(path);
            fs::create_dir_all(path.parent().unwrap()).unwrap();
            fs::write(path, text).unwrap();
        };
        assert_eq!(limit_below(root), None);
        write("proc/meminfo", "MemFree:  1 kB\nMemTotal:       8000 kB\n");
        assert_eq!(limit_below(root), Some(8_192_000));
        write("proc/self/cgroup", "0::/a/b\n");
        write("sys/fs/cgroup/a/b/memory.max", "max\n");
        assert_eq!(limit_below(root), Some(8_192_000));
        write("sys/fs/cgroup/a/memory.max", "4000000\n");
        assert_eq!(limit_below(root), Some(4_000_000));
        // A container sees its own group at the top.
        write("sys/fs/cgroup/memory.max", "3000000\n");
        assert_eq!(limit_below(root), Some(3_000_000));
        write("proc/self/cgroup", "5:cpu:/x\n4:memory,hugetlb:/docker/1\n");
        assert_eq!(limit_below(root), Some(8_192_000));
        write("sys/fs/cgroup/memory/docker/1/memory.limit_in_bytes", "9223372036854771712\n");
        assert_eq!(limit_below(root), Some(8_192_000));
        write("sys/fs/cgroup/memory/memory.limit_in_bytes", "2000000\n");
        assert_eq!(limit_below(root), Some(2_000_000));
    }
}
