//! A PostgreSQL server for tests: a fresh cluster in a temporary folder, reachable only by its socket unless a test
//! starts it with other arguments.
//!
//! The programs come from `PLATEAU_POSTGRES_BIN` (a folder, which `scripts/test` sets if it had to fetch them), from
//! Debian's `/usr/lib/postgresql`, or from the PATH. If none has them, there is no server, and the
//! skip is recorded.

// Each test binary uses only a part of this module.
#![allow(dead_code)]

use crate::skips::skipped;
use std::fs;
use std::io::{BufRead, BufReader, Write};
use std::path::{Path, PathBuf};
use std::process::{Child, ChildStdin, ChildStdout, Command, Stdio};
use std::sync::Mutex;
use std::sync::atomic::{AtomicU32, Ordering};

/// A running server. The server stops and its data is removed when this value is dropped or when this process ends in
/// any way.
#[derive(Debug)]
pub struct Postgres {
    folder: PathBuf,
    /// The shell that stops the server when its standard input closes.
    guard: Child,
    commands: Mutex<Option<ChildStdin>>,
    answers: Mutex<BufReader<ChildStdout>>,
    databases: AtomicU32,
}

impl Postgres {
    /// Starts a server. If PostgreSQL is not installed, records a skip and returns `None`.
    pub fn start() -> Option<Self> {
        Self::start_with(|_| String::new())
    }

    /// Starts a server with further arguments, which `arguments` returns. It may put files into the server's folder.
    pub fn start_with(arguments: impl FnOnce(&Path) -> String) -> Option<Self> {
        if cfg!(not(feature = "postgres")) {
            skipped("PostgreSQL without its feature", "this build leaves it out");
            return None;
        }
        let Some(binaries) = binaries() else {
            skipped("PostgreSQL", "no `initdb` in PLATEAU_POSTGRES_BIN, /usr/lib/postgresql/*/bin or the PATH");
            return None;
        };
        let folder = tempfile::Builder::new().prefix("plateau-postgres-").tempdir().expect("a temporary folder").keep();
        let arguments = arguments(&folder);
        // PostgreSQL refuses to run as root, so root gives the folder to another user.
        let user = is_root().then(|| {
            let user = if id_of("postgres").is_some() { "postgres" } else { "nobody" };
            let lent = Command::new("chown").arg("-R").arg(user).arg(&folder).status().expect("chown runs").success();
            assert!(lent, "the folder can be given to {user}");
            user
        });
        let as_user = user.map_or(String::new(), |user| format!("setpriv --reuid {user} --clear-groups "));
        let script = format!(
            "cd {folder} || exit 1
            start() {{
                {as_user}{bin}/postgres -D {folder}/data -k {folder} -c listen_addresses= -c fsync=off \
                    -c max_connections=200 {arguments} >>{folder}/log 2>&1 </dev/null & pid=$!
                until {bin}/pg_isready -q -h {folder} || ! kill -0 $pid 2>/dev/null; do sleep 0.05; done
                echo started
            }}
            {as_user}{bin}/initdb -D {folder}/data -U postgres -A trust --no-sync >{folder}/log 2>&1 && start
            while read -r command; do
                case $command in
                    stop) kill -INT $pid; wait $pid; echo stopped ;;
                    start) start ;;
                esac
            done
            kill -INT $pid; wait $pid; rm -rf {folder}",
            folder = folder.display(),
            bin = binaries.display(),
        );
        let mut guard = Command::new("sh")
            .arg("-c")
            .arg(script)
            .stdin(Stdio::piped())
            .stdout(Stdio::piped())
            .spawn()
            .expect("a shell starts");
        let answers = Mutex::new(BufReader::new(guard.stdout.take().expect("a piped stdout")));
        let commands = Mutex::new(guard.stdin.take());
        let server = Self { folder, guard, commands, answers, databases: AtomicU32::new(0) };
        server.expect("started");
        Some(server)
    }

    /// Stops the server in fast mode: open transactions are rolled back.
    pub fn stop(&self) {
        self.say("stop");
        self.expect("stopped");
    }

    /// Starts a stopped server again with its data.
    pub fn start_again(&self) {
        self.say("start");
        self.expect("started");
    }

    fn say(&self, command: &str) {
        let mut commands = self.commands.lock().unwrap();
        writeln!(commands.as_mut().expect("open until dropped"), "{command}").expect("the shell listens");
    }

    fn expect(&self, answer: &str) {
        let mut line = String::new();
        self.answers.lock().unwrap().read_line(&mut line).expect("the shell answers");
        let log = || fs::read_to_string(self.folder.join("log")).unwrap_or_default();
        assert_eq!(line.trim_end(), answer, "PostgreSQL did not answer as expected: {}", log());
    }

    /// Creates an empty database and returns its URL.
    pub async fn database(&self) -> String {
        let name = format!("test{}", self.databases.fetch_add(1, Ordering::Relaxed));
        self.execute(&format!("CREATE DATABASE {name}")).await;
        self.url(&name)
    }

    /// Runs statements as the superuser, and returns the first column of their rows.
    pub async fn execute(&self, statements: &str) -> Vec<String> {
        let (folder, statements) = (self.folder.clone(), statements.to_owned());
        let run = move || {
            let mut config = postgres::Config::new();
            let mut client = config.user("postgres").dbname("postgres").host_path(folder).connect(postgres::NoTls)?;
            client.simple_query(&statements)
        };
        let answered = tokio::task::spawn_blocking(run).await.expect("nothing panics").expect("valid statements");
        let column = |message: &postgres::SimpleQueryMessage| match message {
            postgres::SimpleQueryMessage::Row(row) => row.get(0).map(str::to_owned),
            _ => None,
        };
        answered.iter().filter_map(column).collect()
    }

    fn url(&self, database: &str) -> String {
        format!("postgres://postgres@localhost/{database}?host={}", self.folder.display())
    }
}

impl Drop for Postgres {
    fn drop(&mut self) {
        drop(self.commands.lock().map(|mut commands| commands.take()));
        let _ = self.guard.wait();
    }
}

/// Returns the folder of PostgreSQL's programs.
pub fn binaries() -> Option<PathBuf> {
    let has_initdb = |folder: &PathBuf| folder.join("initdb").exists();
    let chosen = std::env::var_os("PLATEAU_POSTGRES_BIN").map(PathBuf::from);
    let mut debian: Vec<PathBuf> = fs::read_dir("/usr/lib/postgresql")
        .map(|versions| versions.flatten().map(|version| version.path().join("bin")).collect())
        .unwrap_or_default();
    debian.sort();
    let path = std::env::var_os("PATH").unwrap_or_default();
    chosen.into_iter().chain(debian.into_iter().rev()).chain(std::env::split_paths(&path)).find(has_initdb)
}

fn is_root() -> bool {
    fs::metadata("/proc/self").is_ok_and(|metadata| std::os::unix::fs::MetadataExt::uid(&metadata) == 0)
}

fn id_of(user: &str) -> Option<()> {
    let users = fs::read_to_string(Path::new("/etc/passwd")).ok()?;
    users.lines().any(|line| line.split(':').next() == Some(user)).then_some(())
}
