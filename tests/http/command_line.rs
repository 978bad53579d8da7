//! The command line: solving without a server, printing the API document, and refusing wrong settings.

use crate::app::{binary, example, root};
use serde_json::{Value, json};

#[tokio::test]
async fn solve_writes_the_mesh_and_prints_the_statistics() {
    let folder = tempfile::tempdir().unwrap();
    for extension in ["glb", "gltf", "obj", "ply", "stl"] {
        let output = folder.path().join(format!("tent.{extension}"));
        let run = binary()
            .arg("solve")
            .arg(root().join("api/examples/tent.json"))
            .arg("-o")
            .arg(&output)
            .output()
            .await
            .unwrap();
        assert!(run.status.success(), "{}", String::from_utf8_lossy(&run.stderr));
        let statistics: Value = serde_json::from_slice(&run.stdout).unwrap();
        assert!(statistics["area"].as_f64().unwrap() > 60.0);
        assert!(std::fs::metadata(&output).unwrap().len() > 1000, "{extension}");
    }
}

#[tokio::test]
async fn the_command_line_and_the_server_give_the_same_bytes() {
    let app = crate::app::TestApp::start().await;
    let folder = tempfile::tempdir().unwrap();
    for name in ["wavy-strip", "two-rings"] {
        let output = folder.path().join("mesh.obj");
        let run = binary()
            .arg("solve")
            .arg(root().join(format!("api/examples/{name}.json")))
            .arg("-o")
            .arg(&output)
            .output()
            .await
            .unwrap();
        assert!(run.status.success());
        let request = example(name);
        let job = app.solve(crate::app::path_of(request["kind"].as_str().unwrap()), &request).await;
        let served =
            app.get(&format!("{}?format=obj", job["links"]["mesh"].as_str().unwrap())).await.bytes().await.unwrap();
        assert!(served == std::fs::read(&output).unwrap(), "{name}");
    }
}

#[tokio::test]
async fn solve_writes_the_drawings_and_schedules_of_the_server_beside_the_mesh() {
    let app = crate::app::TestApp::start().await;
    let folder = tempfile::tempdir().unwrap();
    let cases = [
        ("contour-stack", "profile=cut&format=dxf", &["zip", "obj"][..], "pattern"),
        ("two-rails", "angles=true&paper=a3&format=pdf", &["pdf"], "pattern"),
        ("wavy-strip", "angles=true", &["svg", "dxf"], "pattern"),
        ("two-rails", "part=bends", &["csv"], "schedule"),
        ("floor-fewest-nodes", "format=dxf", &["dxf"], "schedule"),
        ("four-cables", "part=cables", &["csv", "ply"], "schedule"),
    ];
    for (name, query, extensions, route) in cases {
        let request = example(name);
        let job = app.solve(crate::app::path_of(request["kind"].as_str().unwrap()), &request).await;
        let this = job["links"]["self"].as_str().unwrap();
        let outputs: Vec<_> = extensions.iter().map(|extension| folder.path().join(format!("a.{extension}"))).collect();
        let mut command = binary();
        command.arg("solve").arg(root().join(format!("api/examples/{name}.json"))).arg("--with").arg(query);
        for output in &outputs {
            command.arg("-o").arg(output);
        }
        let run = command.output().await.unwrap();
        assert!(run.status.success(), "{name}: {}", String::from_utf8_lossy(&run.stderr));
        for (extension, output) in extensions.iter().zip(&outputs) {
            let path = match *extension {
                "obj" | "ply" => format!("{this}/mesh?format={extension}"),
                "zip" => format!("{this}/{route}?{query}"),
                _ if query.contains("format=") => format!("{this}/{route}?{query}"),
                _ => format!("{this}/{route}?{query}&format={extension}"),
            };
            let served = app.get(&path).await;
            assert_eq!(served.status(), 200, "{path}");
            let (served, written) = (served.bytes().await.unwrap(), std::fs::read(output).unwrap());
            assert!(served == written && !written.is_empty(), "{name} {extension}");
        }
    }
    // Wrong parameters and extensions are refused before anything is solved.
    for (query, extension, text) in [
        ("kerf=-1", "svg", "kerf"),
        ("profile=cut", "svg", "must be zip"),
        ("format=dxf", "svg", "must be dxf"),
        ("part=rods", "csv", "part"),
    ] {
        let output = folder.path().join(format!("b.{extension}"));
        let request = root().join("api/examples/wavy-strip.json");
        let run = binary().arg("solve").arg(request).arg("--with").arg(query).arg("-o").arg(&output).output().await;
        let run = run.unwrap();
        let message = String::from_utf8_lossy(&run.stderr).into_owned();
        assert!(run.status.code() == Some(2) && message.contains(text) && !output.exists(), "{query}: {message}");
    }
}

#[tokio::test]
async fn the_error_for_an_invalid_request_has_its_pointer() {
    let folder = tempfile::tempdir().unwrap();
    let (request, output) = (folder.path().join("request.json"), folder.path().join("x.glb"));
    std::fs::write(
        &request,
        json!({ "kind": "minimal_surface", "boundaries": [[[0, 0, 0], [1, 0, "x"], [1, 1, 0]]] }).to_string(),
    )
    .unwrap();
    let run = binary().arg("solve").arg(&request).arg("-o").arg(&output).output().await.unwrap();
    assert_eq!(run.status.code(), Some(1));
    assert!(String::from_utf8_lossy(&run.stderr).contains("/boundaries/0/1/2"));
    std::fs::write(&request, "{}").unwrap();
    let run = binary().arg("solve").arg(&request).arg("-o").arg(&output).output().await.unwrap();
    assert!(String::from_utf8_lossy(&run.stderr).contains("/kind"));
    assert!(!output.exists());
}

#[tokio::test]
async fn wrong_usage_and_configuration_exit_with_2_and_name_the_setting() {
    let folder = tempfile::tempdir().unwrap();
    let file = folder.path().join("plateau.toml");
    std::fs::write(&file, "[jobs]\nqueue = 1\n").unwrap();
    let config = file.to_str().unwrap().to_owned();
    type Case<'a> = (Vec<&'a str>, Vec<(&'a str, &'a str)>, &'a str);
    let cases: Vec<Case> = vec![
        (vec!["fly"], vec![], "fly"),
        (vec!["--listen", "nowhere"], vec![], "listen"),
        (vec!["--config", &config], vec![], "queue"),
        (vec!["--workers", "-1"], vec![], "workers"),
        (vec![], vec![("PLATEAU_JOBS__DEADLINE_MS", "soon")], "PLATEAU_JOBS__DEADLINE_MS"),
        (vec![], vec![("PLATEAU_LISTEN", "1.2.3.4")], "listen"),
        (vec!["--database", "mysql://x"], vec![], "store.database"),
        (vec!["solve", "x.json", "-o", "x.fbx"], vec![], "x.fbx"),
    ];
    for (arguments, environment, named) in cases {
        let run = binary().args(&arguments).envs(environment).current_dir(folder.path()).output().await.unwrap();
        let message = String::from_utf8_lossy(&run.stderr);
        assert_eq!(run.status.code(), Some(2), "{arguments:?}: {message}");
        assert!(message.contains(named), "{arguments:?}: {message}");
    }
}

#[cfg(all(feature = "studio", feature = "hops"))]
#[tokio::test]
async fn a_valid_configuration_passes_its_check() {
    let run =
        binary().arg("--check-config").arg("--config").arg(root().join("config/default.toml")).output().await.unwrap();
    assert!(run.status.success());
}

#[tokio::test]
async fn a_configuration_that_cannot_start_fails_its_check_and_names_the_setting() {
    let folder = tempfile::tempdir().unwrap();
    let (file, keys) = (folder.path().join("file"), folder.path().join("keys"));
    std::fs::write(&file, "no keys\n").unwrap();
    std::fs::write(&keys, format!("me {}\n", "0".repeat(64))).unwrap();
    let [file, keys] = [&file, &keys].map(|path| path.to_str().unwrap());
    let below_file = format!("{file}/data");
    type Case<'a> = (&'a [&'a str], &'a [(&'a str, &'a str)], &'a str);
    let cases: [Case; 13] = [
        (&["--listen", "0.0.0.0:0"], &[], "http.listen"),
        (&["worker", "--workers", "0"], &[], "jobs.workers"),
        (&[], &[("PLATEAU_JOBS__UNRESPONSIVE_MAX", "0")], "jobs.unresponsive_max"),
        (&["mcp"], &[("PLATEAU_AUTH__KEYS_FILE", keys)], "auth.keys"),
        (&[], &[("PLATEAU_AUTH__KEYS_FILE", file)], "auth.keys_file"),
        (&[], &[("PLATEAU_AUTH__KEYS_FILE", "/nowhere")], "auth.keys_file"),
        (&[], &[("PLATEAU_WEBHOOKS__SECRET_FILE", "/nowhere")], "webhooks.secret_file"),
        (&[], &[("PLATEAU_LOG__LEVEL", "loud=x=y")], "log.level"),
        (&["--database", "mysql://x"], &[], "store.database"),
        (&["--database", "postgres://me@db:x/plateau"], &[], "store.database"),
        (&["--database", "postgres://me@db/plateau?sslmode=maybe"], &[], "sslmode"),
        (&["--database", "postgres://me@db/plateau?sslrootcert=/nowhere&sslmode=verify-full"], &[], "sslrootcert"),
        (&["--data", below_file.as_str()], &[], "store.database"),
    ];
    for (arguments, environment, named) in cases {
        let is_here = |word: &str, has_part: bool| has_part || !arguments.iter().any(|each| each.starts_with(word));
        if !is_here("mcp", cfg!(feature = "mcp")) || !is_here("postgres:", cfg!(feature = "postgres")) {
            continue;
        }
        let mut command = binary();
        let run = command.args(arguments).arg("--check-config").envs(environment.iter().copied());
        let run = run.current_dir(folder.path()).output().await.unwrap();
        let message = String::from_utf8_lossy(&run.stderr);
        assert_eq!(run.status.code(), Some(2), "{arguments:?} {environment:?}: {message}");
        assert!(message.contains(named), "{arguments:?} {environment:?}: {message}");
    }
    let unchanged = std::fs::read_dir(folder.path()).unwrap().count();
    assert_eq!(unchanged, 2, "the check creates nothing");
    let database = match cfg!(feature = "postgres") {
        true => "postgres://me@db/plateau?sslmode=prefer",
        false => "sqlite://plateau.sqlite",
    };
    let database = ("PLATEAU_DATABASE", database);
    let public = [("PLATEAU_AUTH__KEYS_FILE", keys), ("PLATEAU_LISTEN", "0.0.0.0:0"), database];
    let run = binary().arg("--check-config").envs(public).current_dir(folder.path()).output().await.unwrap();
    assert!(run.status.success(), "{}", String::from_utf8_lossy(&run.stderr));
}

#[tokio::test]
async fn only_the_user_of_the_server_can_read_its_files() {
    use std::os::unix::fs::PermissionsExt;
    let folder = tempfile::tempdir().unwrap();
    std::fs::set_permissions(folder.path(), std::fs::Permissions::from_mode(0o755)).unwrap();
    let app = crate::app::TestApp::start_in(folder, &[("PLATEAU_STORE__INLINE_BYTES", "0")]).await;
    app.solve(crate::app::MINIMAL, &crate::app::small_film(0.1)).await;
    let (mut folders, mut files) = (vec![app.folder.path().join("data")], Vec::new());
    let mut at = 0;
    while let Some(folder) = folders.get(at).cloned() {
        for entry in std::fs::read_dir(folder).unwrap().map(Result::unwrap) {
            if entry.file_type().unwrap().is_dir() { &mut folders } else { &mut files }.push(entry.path());
        }
        at += 1;
    }
    assert!(folders.len() >= 2 && files.len() >= 3, "{folders:?} {files:?}");
    for (paths, mode) in [(folders, 0o700), (files, 0o600)] {
        for path in paths {
            let found = std::fs::metadata(&path).unwrap().permissions().mode() & 0o777;
            assert_eq!(found, mode, "{} is {found:o}", path.display());
        }
    }
}

#[cfg(not(feature = "s3"))]
#[tokio::test]
async fn a_program_without_bucket_support_refuses_a_bucket() {
    let folder = tempfile::tempdir().unwrap();
    let mut command = binary();
    command
        .env("PLATEAU_STORE__RESULTS", "s3://bucket/prefix")
        .args(["--listen", "127.0.0.1:0", "--data"])
        .arg(folder.path());
    let run = command.output().await.unwrap();
    assert_eq!(run.status.code(), Some(2));
    let message = String::from_utf8_lossy(&run.stderr).into_owned();
    assert!(message.contains("store.results") && message.contains("--features s3"), "{message}");
}
