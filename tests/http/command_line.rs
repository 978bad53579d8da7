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
        (vec!["solve", "x.json", "-o", "x.fbx"], vec![], "extension"),
    ];
    for (arguments, environment, named) in cases {
        let run = binary().args(&arguments).envs(environment).current_dir(folder.path()).output().await.unwrap();
        let message = String::from_utf8_lossy(&run.stderr);
        assert_eq!(run.status.code(), Some(2), "{arguments:?}: {message}");
        assert!(message.contains(named), "{arguments:?}: {message}");
    }
}

#[tokio::test]
async fn a_valid_configuration_passes_its_check() {
    let run =
        binary().arg("--check-config").arg("--config").arg(root().join("config/default.toml")).output().await.unwrap();
    assert!(run.status.success());
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
