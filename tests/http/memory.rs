//! The memory budget that all solvers of a process share.

use crate::app::{MINIMAL, TestApp, problem, small_film};
use reqwest::Method;
use serde_json::Value;

/// Returns a film that takes more than half of the budget that the test gives to all solvers.
fn large_film(height: f64) -> Value {
    let mut film = small_film(height);
    film["resolution"]["triangles"] = 20_000.into();
    film
}

/// Posts a film and returns the job.
async fn post(app: &TestApp, film: &Value) -> Value {
    let answer = app.post(MINIMAL, film).await;
    assert_eq!(answer.status(), 202);
    answer.json().await.unwrap()
}

async fn status(app: &TestApp, job: &Value) -> Value {
    app.get_json(job["links"]["self"].as_str().unwrap()).await["status"].clone()
}

/// Returns the number of bytes that the server says a film needs.
async fn needed_bytes(film: &Value) -> u64 {
    let app = TestApp::start_with(&[("PLATEAU_LIMITS__MEMORY_BYTES", "1"), ("PLATEAU_WORKERS", "0")]).await;
    let refused = problem(app.post(MINIMAL, film).await, 413).await;
    let detail = refused["errors"][0]["detail"].as_str().unwrap().to_owned();
    let words: Vec<&str> = detail.split(' ').collect();
    let mebibytes = words[words.iter().position(|word| *word == "MiB").unwrap() - 1];
    (mebibytes.parse::<u64>().unwrap() + 1) << 20
}

#[tokio::test]
async fn a_job_that_waits_for_memory_stays_queued_and_smaller_jobs_pass_it() {
    let (first, second) = (large_film(0.1), large_film(0.2));
    let budget = needed_bytes(&first).await.max(needed_bytes(&second).await).to_string();
    let app = TestApp::start_with(&[
        ("PLATEAU_WORKERS", "2"),
        ("PLATEAU_JOBS__MEMORY_BYTES", &budget),
        ("PLATEAU_LIMITS__MEMORY_BYTES", &budget),
    ])
    .await;
    app.hold.at("claimed");
    let first = post(&app, &first).await;
    app.hold.reached("claimed", first["id"].as_str().unwrap()).await;
    let second = post(&app, &second).await;
    // A small job gets past the second one. It needs the only other worker.
    let small = post(&app, &small_film(0.3)).await;
    app.hold.reached("claimed", small["id"].as_str().unwrap()).await;
    assert_eq!(status(&app, &second).await, "queued", "its deadline must not run");
    let cancel = app.request(Method::POST, small["links"]["cancel"].as_str().unwrap()).send().await.unwrap();
    assert_eq!(cancel.status(), 200);
    app.request(Method::POST, first["links"]["cancel"].as_str().unwrap()).send().await.unwrap();
    app.hold.reached("claimed", second["id"].as_str().unwrap()).await;
    app.hold.release("claimed");
    assert_eq!(app.ended(second).await["status"], "succeeded");
}

#[tokio::test]
async fn a_small_job_does_not_wait_for_long_ones() {
    let app = TestApp::start_with(&[("PLATEAU_JOBS__WORKERS", "1"), ("PLATEAU_JOBS__SMALL_WORKERS", "1")]).await;
    app.hold.at("claimed.minimal_surface");
    let long = post(&app, &large_film(0.1)).await;
    app.hold.reached("claimed", long["id"].as_str().unwrap()).await;
    let waiting = post(&app, &large_film(0.2)).await;
    let strip = app.solve(crate::app::RULED, &crate::app::example("two-rails")).await;
    assert_eq!(strip["status"], "succeeded");
    assert_eq!(status(&app, &waiting).await, "queued", "it is no small job");
    app.hold.release("claimed.minimal_surface");
}

/// Length of the bodies of [`no_body_takes_many_times_its_length_in_memory`] in bytes.
const BODY_BYTES: usize = 8 << 20;
/// Bytes that the server takes besides the parsed bodies, such as for buffers and for the schemas that explain errors.
const BESIDES: u64 = 48 << 20;

/// A parsed value takes much more memory than its text. Whatever a body has, the server takes at most eight times its
/// length.
#[tokio::test]
async fn no_body_takes_many_times_its_length_in_memory() {
    let app = TestApp::start_with(&[("PLATEAU_WORKERS", "0")]).await;
    let filled = |start: &str, part: &dyn Fn(usize) -> String, end: &str| {
        let mut body = start.to_owned();
        for number in 0.. {
            if body.len() >= BODY_BYTES {
                break;
            }
            if number > 0 {
                body.push(',');
            }
            body.push_str(&part(number));
        }
        body + end
    };
    let same = |text: &'static str| move |_: usize| text.to_owned();
    let film = r#"{"boundaries":[[[0,0,0],[1,0,0],[1,1,0]]],"#;
    let members = |number: usize| format!("\"{number}\":1");
    let request = |body: &str| format!("{film}{body}");
    let deep = format!("{}{}", "[".repeat(100), "]".repeat(100));
    let (batches, hops) = ("/v1/batches", "/solve");
    let bodies: Vec<(&str, &str, String)> = vec![
        ("members of the metadata", MINIMAL, filled(&request("\"metadata\":{"), &members, "}}")),
        ("metadata in lists", MINIMAL, filled(&request("\"metadata\":{\"a\":["), &same("[]"), "]}}")),
        ("unknown members", MINIMAL, filled(film, &members, "}")),
        ("members of an unknown member", MINIMAL, filled(&request("\"a\":{"), &members, "}}")),
        ("deep lists", MINIMAL, filled(&request("\"a\":["), &|_| deep.clone(), "]}")),
        ("empty lists", MINIMAL, filled(r#"{"boundaries":["#, &same("[]"), "]}")),
        ("numbers", MINIMAL, filled(r#"{"boundaries":["#, &same("1"), "]}")),
        ("points", MINIMAL, filled(r#"{"boundaries":[["#, &same("[0,0,0]"), "]]}")),
        ("empty objects", MINIMAL, filled(r#"{"boundaries":["#, &same("{}"), "]}")),
        ("empty texts", MINIMAL, filled(&request("\"label\":["), &same("\"\""), "]}")),
        ("a long text", MINIMAL, format!("{film}\"label\":\"{}\"}}", "a".repeat(BODY_BYTES))),
        ("a list", MINIMAL, filled("[", &same("null"), "]")),
        ("white space", MINIMAL, format!("{film}{}\"label\":1}}", " ".repeat(BODY_BYTES))),
        ("numbers in place of requests", batches, filled(r#"{"requests":["#, &same("1"), "]}")),
        ("empty requests", batches, filled(r#"{"requests":["#, &same("{}"), "]}")),
        ("members of a batch", batches, filled("{", &members, "}")),
        (
            "members of a request of a batch",
            batches,
            filled(r#"{"requests":[{"kind":"minimal_surface","metadata":{"#, &members, "}}]}"),
        ),
        ("items of Hops", hops, filled(r#"{"values":[{"ParamName":"","InnerTree":{"a":["#, &same("{}"), "]}}]}")),
        ("values of Hops", hops, filled(r#"{"values":["#, &same(r#"{"ParamName":""}"#), "]}")),
    ];
    // The first request makes the schemas.
    problem(app.post(MINIMAL, &serde_json::json!({})).await, 422).await;
    // Without Hops its path does not exist, and the answer comes before the body is read.
    for (shape, path, body) in bodies.into_iter().filter(|&(_, path, _)| cfg!(feature = "hops") || path != hops) {
        let length = body.len() as u64;
        app.forget_peak();
        let before = app.memory();
        let post = app.request(Method::POST, path).header("content-type", "application/json").body(body);
        let answer = post.send().await.unwrap();
        assert!(answer.status().is_client_error(), "{shape}: {}", answer.status());
        let taken = app.peak_memory().saturating_sub(before);
        println!("{shape}: {:.1} times", taken as f64 / length as f64);
        assert!(taken <= 8 * length + BESIDES, "{shape}: {} MiB for {} MiB", taken >> 20, length >> 20);
    }
}

/// A request that is wrong in one place is explained although its values would take too much memory.
#[tokio::test]
async fn the_first_error_of_a_dense_body_is_named() {
    let app = TestApp::start_with(&[("PLATEAU_WORKERS", "0")]).await;
    let mut text = String::from(r#"{"boundaries":[["#);
    for number in 0..150_000 {
        text.push_str(&format!("[{},{},0],", number % 1000, number / 1000));
    }
    let wrong = |end: &str| format!("{text}{end}");
    for (end, pointer) in [
        (r#"[0,0,"x"]]]}"#, "/boundaries/0/150000/2"),
        (r#"[0,0,1]]],"resolution":{"triangles":"many"}}"#, "/resolution/triangles"),
        (r#"[0,0,1]]],"label":7}"#, "/label"),
    ] {
        let post = app.request(Method::POST, MINIMAL).header("content-type", "application/json").body(wrong(end));
        let refused = problem(post.send().await.unwrap(), 422).await;
        let pointers = crate::app::pointers(&refused);
        assert!(pointers.contains(&pointer), "{pointer}: {pointers:?}");
    }
}
