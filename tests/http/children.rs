//! Jobs that are solved in child processes. Their results are those of threads, and what happens to a child costs only
//! its own job.

use crate::app::{
    CABLE_NETS, MINIMAL, RULED, TENSILE, TestApp, UNIFORM, binary, endless_film, example, large_strip, problem,
    small_film,
};
use crate::hold::until;
use crate::sources::{ENLARGEMENTS, enlargement};
use reqwest::Method;
use rustix::process::{Pid, Signal, kill_process};
use serde_json::Value;
use std::collections::BTreeMap;
use std::path::Path;
use std::time::{Duration, Instant};
use tokio::process::Command;

/// Setting with which every job from the queue runs in a child.
const EVERY_JOB: (&str, &str) = ("PLATEAU_JOBS__THREAD_BYTES", "0");
const ONE_WORKER: (&str, &str) = ("PLATEAU_WORKERS", "1");
const STUBBORN: &str = "stubborn.minimal_surface";
/// Time in which a child must have ended. It takes some milliseconds, but the machine may be busy.
const SOON: Duration = Duration::from_secs(5);

/// Posts a request without waiting, so that even a small strip goes through the queue.
async fn post(app: &TestApp, path: &str, body: &Value) -> Value {
    app.post(path, body).await.json().await.unwrap()
}

/// Posts a request, and returns the job when it has ended.
async fn ended(app: &TestApp, path: &str, body: &Value) -> Value {
    app.ended(post(app, path, body).await).await
}

fn is_alive(id: u32) -> bool {
    // A killed process that its parent has not waited for is a zombie, which computes nothing.
    let stat = std::fs::read_to_string(format!("/proc/{id}/stat")).unwrap_or_default();
    !stat.is_empty() && !stat.contains(") Z ")
}

fn kill(id: u32) {
    kill_process(Pid::from_raw(id.cast_signed()).unwrap(), Signal::KILL).unwrap();
}

/// Checks that the server solves a job and has given up no thread.
async fn works(app: &TestApp) {
    let mut floor = example("floor-equal-members");
    floor["cache"] = "bypass".into();
    assert_eq!(ended(app, UNIFORM, &floor).await["status"], "succeeded");
    assert_eq!(app.get_json("/health/ready").await["unresponsive_solvers"], 0);
}

#[tokio::test]
async fn the_results_of_children_are_those_of_threads() {
    let requests = [
        (MINIMAL, small_film(0.3)),
        (RULED, large_strip(40)),
        (UNIFORM, example("floor-equal-members")),
        (TENSILE, example("four-point-sail")),
        (CABLE_NETS, example("cable-net-by-targets")),
    ];
    let (in_children, on_threads) = (TestApp::start_with(&[EVERY_JOB]).await, TestApp::start().await);
    for (path, body) in requests {
        let mut found = Vec::new();
        for app in [&in_children, &on_threads] {
            let job = ended(app, path, &body).await;
            assert_eq!(job["status"], "succeeded", "{job:#}");
            let mesh = app.get(&format!("{}?format=glb", job["links"]["mesh"].as_str().unwrap())).await;
            found.push((job["statistics"].clone(), job["warnings"].clone(), mesh.bytes().await.unwrap()));
            if path == MINIMAL {
                let larger = ended(app, ENLARGEMENTS, &enlargement(&job, 3.0)).await;
                found.push((larger["statistics"].clone(), larger["warnings"].clone(), Default::default()));
            }
        }
        let half = found.len() / 2;
        assert!(found[..half] == found[half..], "{path}");
    }
}

#[tokio::test]
async fn a_child_has_limits_a_group_and_no_environment_of_its_parent() {
    let app = TestApp::start_with(&[EVERY_JOB, ("PLATEAU_STORE__MAX_JOBS", "77")]).await;
    app.hold.at("claimed");
    let job = post(&app, MINIMAL, &small_film(0.1)).await;
    app.hold.reached("claimed", job["id"].as_str().unwrap()).await;
    let child = app.only_child().await;
    let read = |name: &str| std::fs::read_to_string(format!("/proc/{child}/{name}")).unwrap();
    let environment = read("environ");
    let names: Vec<&str> = environment.split_terminator('\0').map(|line| line.split('=').next().unwrap()).collect();
    assert!(!names.is_empty() && names.iter().all(|name| name.starts_with("PLATEAU_TEST") || name.contains("ARENA")));
    assert_eq!(read("oom_score_adj").trim(), "500");
    let group = read("stat").rsplit(") ").next().unwrap().split(' ').nth(2).unwrap().to_owned();
    assert_eq!(group, child.to_string(), "Ctrl-C must not reach it");
    let limits = read("limits");
    let line = limits.lines().find_map(|line| line.strip_prefix("Max address space")).unwrap();
    let soft: u64 = line.split_whitespace().next().unwrap().parse().expect("a limit");
    assert!((200 << 20..2 << 30).contains(&soft), "{soft}");
    app.hold.release("claimed");
    assert_eq!(app.ended(job).await["status"], "succeeded");
    until("the child is gone", async || app.children().is_empty()).await;
}

#[tokio::test]
async fn only_large_jobs_and_further_attempts_run_in_children() {
    let short_lease = ("PLATEAU_JOBS__LEASE_MS", "1000");
    let app = TestApp::start_with(&[ONE_WORKER, short_lease]).await;
    app.hold.at("claimed");
    let small = post(&app, MINIMAL, &small_film(0.1)).await;
    app.hold.reached("claimed", small["id"].as_str().unwrap()).await;
    assert!(app.children().is_empty());
    let mut film = small_film(0.2);
    film["resolution"]["triangles"] = 20_000.into();
    let large = post(&app, MINIMAL, &film).await;
    let app = TestApp::start_in(app.kill().await, &[("PLATEAU_WORKERS", "2"), short_lease]).await;
    for job in [&small, &large] {
        app.hold.reached("claimed", job["id"].as_str().unwrap()).await;
    }
    assert_eq!(app.children().len(), 2);
    app.hold.release("claimed");
    for job in [small, large] {
        assert_eq!(app.ended(job).await["status"], "succeeded");
    }
}

#[tokio::test]
async fn a_child_is_started_from_the_running_file_although_an_upgrade_replaced_it() {
    let program = Path::new(env!("CARGO_TARGET_TMPDIR")).join("replaced");
    let _ = std::fs::remove_file(&program);
    std::fs::hard_link(env!("CARGO_BIN_EXE_plateau"), &program).unwrap();
    let mut command = Command::new(&program);
    command.env_clear().kill_on_drop(true);
    let app = TestApp::start_program(command, tempfile::tempdir().unwrap(), &[EVERY_JOB]).await;
    std::fs::remove_file(&program).unwrap();
    std::fs::write(&program, "no program").unwrap();
    works(&app).await;
    std::fs::remove_file(&program).unwrap();
}

#[tokio::test]
async fn a_child_that_misbehaves_costs_only_its_own_job() {
    let app = TestApp::start_with(&[EVERY_JOB, ONE_WORKER]).await;
    let expected = BTreeMap::from([
        ("allocate", "memory-limit"),
        ("abort", "solver-crashed"),
        ("overflow", "solver-crashed"),
        ("rubbish", "solver-crashed"),
    ]);
    for (number, (misbehaviour, kind)) in expected.into_iter().enumerate() {
        let hold = format!("{misbehaviour}.minimal_surface");
        app.hold.at(&hold);
        let job = ended(&app, MINIMAL, &small_film(0.1 + number as f64)).await;
        app.hold.release(&hold);
        assert_eq!(job["error"]["type"], format!("/problems/{kind}"), "{misbehaviour}: {job:#}");
        let overflowed = job["error"]["detail"].as_str().unwrap().contains("overflowed its stack");
        assert_eq!(overflowed, misbehaviour == "overflow");
        assert_eq!(app.get(&format!("/problems/{kind}")).await.status(), 200);
        works(&app).await;
    }
}

#[tokio::test]
async fn a_cancel_ends_a_stubborn_child_at_once() {
    let app = TestApp::start_with(&[EVERY_JOB, ONE_WORKER]).await;
    app.hold.at(STUBBORN);
    let job = post(&app, MINIMAL, &small_film(0.1)).await;
    let child = app.only_child().await;
    let cancelled = Instant::now();
    let cancel = app.request(Method::POST, job["links"]["cancel"].as_str().unwrap()).send().await.unwrap();
    assert_eq!(cancel.json::<Value>().await.unwrap()["status"], "cancelled");
    until("the child is gone", async || !is_alive(child)).await;
    println!("after the cancel: {:?}", cancelled.elapsed());
    assert!(cancelled.elapsed() < SOON);
    works(&app).await;
    problem(app.get(&format!("{}/mesh", job["links"]["self"].as_str().unwrap())).await, 409).await;
}

#[tokio::test]
async fn a_stubborn_child_is_killed_after_its_deadline_and_others_return_what_they_have() {
    let patience = ("PLATEAU_JOBS__UNRESPONSIVE_MS", "200");
    let app = TestApp::start_with(&[EVERY_JOB, ONE_WORKER, patience, ("PLATEAU_JOBS__DEADLINE_MS", "300")]).await;
    app.hold.at(STUBBORN);
    let job = ended(&app, MINIMAL, &small_film(0.1)).await;
    assert_eq!(job["error"]["type"], "/problems/unresponsive", "{job:#}");
    let app = TestApp::start_with(&[EVERY_JOB, ONE_WORKER, ("PLATEAU_JOBS__DEADLINE_MS", "50")]).await;
    app.hold.at("claimed");
    let job = ended(&app, MINIMAL, &small_film(0.2)).await;
    assert_eq!(job["error"]["type"], "/problems/deadline", "{job:#}");
    let app = TestApp::start_with(&[EVERY_JOB, ONE_WORKER, ("PLATEAU_JOBS__DEADLINE_MS", "3000")]).await;
    let job = ended(&app, MINIMAL, &endless_film(0.1)).await;
    assert!(job["status"] == "succeeded" || job["error"]["type"] == "/problems/deadline", "{job:#}");
    until("the child is gone", async || app.children().is_empty()).await;
}

#[tokio::test]
async fn the_progress_of_a_child_is_seen() {
    let app = TestApp::start_with(&[EVERY_JOB, ONE_WORKER]).await;
    app.hold.at("half");
    let job = post(&app, MINIMAL, &small_film(0.1)).await;
    let this = job["links"]["self"].as_str().unwrap().to_owned();
    let fraction = async || app.get_json(&this).await["progress"]["fraction"].as_f64().unwrap();
    until("half of the work is done", async || fraction().await >= 0.5).await;
    assert_eq!(app.get_json(&this).await["status"], "running");
    app.hold.release("half");
    assert_eq!(app.ended(job).await["status"], "succeeded");
}

#[tokio::test]
async fn nothing_is_solved_for_a_server_that_was_killed() {
    let app = TestApp::start_with(&[EVERY_JOB, ("PLATEAU_WORKERS", "2")]).await;
    app.hold.at("stubborn.uniform_mesh");
    post(&app, UNIFORM, &example("floor-equal-members")).await;
    app.only_child().await;
    app.hold.at("first_progress.minimal_surface");
    let endless = post(&app, MINIMAL, &endless_film(0.1)).await;
    app.hold.reached("first_progress", endless["id"].as_str().unwrap()).await;
    app.hold.release("first_progress.minimal_surface");
    let children = app.children();
    assert_eq!(children.len(), 2);
    let folder = app.kill().await;
    let killed = Instant::now();
    until("the children are gone", async || children.iter().all(|child| !is_alive(*child))).await;
    println!("after the kill: {:?}", killed.elapsed());
    assert!(killed.elapsed() < SOON);
    drop(folder);
}

#[tokio::test]
async fn a_child_that_was_killed_counts_as_an_attempt() {
    for (attempts_max, status) in [("2", "succeeded"), ("1", "failed")] {
        let settings = [EVERY_JOB, ONE_WORKER, ("PLATEAU_JOBS__ATTEMPTS_MAX", attempts_max)];
        let app = TestApp::start_with(&settings).await;
        app.hold.at("half");
        let job = post(&app, MINIMAL, &small_film(0.1)).await;
        app.hold.reached("half", job["id"].as_str().unwrap()).await;
        kill(app.only_child().await);
        app.hold.release("half");
        let job = app.ended(job).await;
        assert_eq!(job["status"], status, "{job:#}");
        if status == "failed" {
            assert_eq!(job["error"]["type"], "/problems/worker-lost");
        }
        works(&app).await;
    }
}

#[tokio::test]
async fn sigterm_hands_the_job_of_a_stubborn_child_back() {
    let app = TestApp::start_with(&[EVERY_JOB, ONE_WORKER, ("PLATEAU_HTTP__SHUTDOWN_GRACE_MS", "100")]).await;
    app.hold.at(STUBBORN);
    let job = post(&app, MINIMAL, &small_film(0.1)).await;
    app.only_child().await;
    let (status, folder) = app.stop().await;
    assert_eq!(status.code(), Some(0));
    let app = TestApp::start_program(binary(), folder, &[EVERY_JOB, ("PLATEAU_JOBS__ATTEMPTS_MAX", "1")]).await;
    app.hold.release_all();
    assert_eq!(app.ended(app.get_json(job["links"]["self"].as_str().unwrap()).await).await["status"], "succeeded");
}
