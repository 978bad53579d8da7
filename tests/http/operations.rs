//! Commands that `compose.yaml` and `docs/OPERATIONS.md` tell operators to run, run as they are written there.

use crate::app::{MINIMAL, TestApp, binary, root, small_film};
use crate::postgres::{Postgres, binaries};
use std::path::Path;
use std::process::Output;
use tokio::process::Command;

/// Runs commands in a shell that fails at the first unset variable. `path` is searched before the usual folders.
async fn run(commands: &str, folder: &Path, path: &str, environment: &[(&str, &str)]) -> Output {
    let mut shell = Command::new("sh");
    shell.env_clear().env("PATH", format!("{path}:/usr/local/bin:/usr/bin:/bin"));
    shell.args(["-euc", commands]).current_dir(folder).envs(environment.iter().copied()).output().await.unwrap()
}

fn text(bytes: &[u8]) -> String {
    String::from_utf8_lossy(bytes).into_owned()
}

/// Returns the commands at the beginning of `compose.yaml` that make the keys file, with the program in the place of
/// its container.
fn commands_of_the_keys() -> String {
    let compose = std::fs::read_to_string(root().join("compose.yaml")).unwrap();
    let commands = compose.lines().map_while(|line| line.strip_prefix('#')).filter_map(|line| line.strip_prefix("   "));
    // The commands with `chown` are left out, because they give the files to a user of the container.
    let of_keys = commands.filter(|command| command.contains("secrets/keys") && !command.starts_with("chown"));
    let commands = of_keys.collect::<Vec<_>>().join("\n");
    commands.replace("docker run --rm --network none plateau:latest", env!("CARGO_BIN_EXE_plateau"))
}

#[tokio::test]
async fn the_commands_of_compose_make_a_keys_file_with_which_the_server_starts() {
    let folder = tempfile::tempdir().unwrap();
    let made = run(&commands_of_the_keys(), folder.path(), "", &[]).await;
    let shown = text(&made.stderr);
    assert!(made.status.success(), "{shown}");
    let key = shown.lines().find_map(|line| line.strip_prefix("key for the client, shown only now: ")).expect("a key");
    let file = folder.path().join("secrets/keys/keys");
    let app = TestApp::start_with(&[("PLATEAU_AUTH__KEYS_FILE", file.to_str().unwrap())]).await;
    assert_eq!(app.get("/v1/jobs").await.status(), 401);
    let admitted = app.request(reqwest::Method::GET, "/v1/jobs").bearer_auth(key).send().await.unwrap();
    assert_eq!(admitted.status(), 200);
}

#[tokio::test]
async fn the_whole_line_that_key_new_prints_is_no_line_of_a_keys_file() {
    let folder = tempfile::tempdir().unwrap();
    let printed = text(&binary().args(["key", "new", "me"]).output().await.unwrap().stdout);
    let file = folder.path().join("keys");
    std::fs::write(&file, printed.lines().nth(1).expect("the second line")).unwrap();
    let check = binary().arg("--check-config").env("PLATEAU_AUTH__KEYS_FILE", &file).output().await.unwrap();
    assert_eq!(check.status.code(), Some(2));
    assert!(text(&check.stderr).contains("auth.keys_file"), "{}", text(&check.stderr));
}

/// Returns the blocks of shell commands below a heading of `docs/OPERATIONS.md`.
fn blocks_below(heading: &str) -> Vec<String> {
    let document = std::fs::read_to_string(root().join("docs/OPERATIONS.md")).unwrap();
    let section = document.split(&format!("\n## {heading}\n")).nth(1).expect("the heading");
    let section = section.split("\n## ").next().unwrap_or_default();
    let blocks = section.split("```sh\n").skip(1).map(|block| block.split("```").next().unwrap_or_default().to_owned());
    blocks.collect()
}

#[tokio::test]
async fn a_backup_of_postgresql_is_taken_and_restored_by_the_commands_of_the_document() {
    let Some(postgres) = Postgres::start() else { return };
    let programs = binaries().expect("a server runs").display().to_string();
    let blocks = blocks_below("Backup and restore");
    let block = |program: &str| blocks.iter().find(|block| block.starts_with(program)).expect(program);
    let (first, second) = (postgres.database().await, postgres.database().await);
    let mesh = async |app: &TestApp, path: &str| app.get(path).await.error_for_status().unwrap().bytes().await.unwrap();

    let app = TestApp::start_with(&[("PLATEAU_DATABASE", &first)]).await;
    let job = app.solve(MINIMAL, &small_film(0.3)).await;
    let path = job["links"]["mesh"].as_str().unwrap();
    let before = mesh(&app, path).await;
    let folder = tempfile::tempdir().unwrap();
    for (program, database) in [("pg_dump", &first), ("pg_restore", &second)] {
        let done = run(block(program), folder.path(), &programs, &[("PLATEAU_DATABASE", database)]).await;
        assert!(done.status.success(), "{program}: {}", text(&done.stderr));
    }
    drop(app);
    let app = TestApp::start_with(&[("PLATEAU_DATABASE", &second)]).await;
    assert_eq!(mesh(&app, path).await, before);
}
