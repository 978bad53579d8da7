//! The alerts and the dashboard of `deploy` name metrics and labels that a server has.

use crate::app::{RULED, TestApp, example};
use std::collections::{BTreeMap, BTreeSet};

const RULES: &str = include_str!("../../deploy/prometheus-rules.yml");
const DASHBOARD: &str = include_str!("../../deploy/grafana-dashboard.json");

/// A series of the metrics, or a selector of series: a name, and the values of labels.
#[derive(Clone, Debug, PartialEq, Eq, PartialOrd, Ord)]
struct Series {
    name: String,
    labels: BTreeMap<String, String>,
}

fn is_part_of_a_name(character: char) -> bool {
    character.is_ascii_alphanumeric() || character == '_'
}

/// Reads a series, or a selector, at the beginning of a text. In a selector `label=~"a|b"` stands for one series for
/// each of the values. Labels that Prometheus itself adds are left out.
fn series(text: &str) -> Vec<Series> {
    let name: String = text.chars().take_while(|character| is_part_of_a_name(*character)).collect();
    let rest = &text[name.len()..];
    let braces = rest.strip_prefix('{').and_then(|inside| inside.split_once('}')).map_or("", |(inside, _)| inside);
    let mut found = vec![Series { name, labels: BTreeMap::new() }];
    let mut parts = braces.split('"');
    while let (Some(label), Some(value)) = (parts.next(), parts.next()) {
        let label = label.trim_matches(|character: char| !is_part_of_a_name(character));
        if ["instance", "job"].contains(&label) {
            continue;
        }
        let with = |one: &Series, value: &str| {
            let mut labels = one.labels.clone();
            labels.insert(label.to_owned(), value.to_owned());
            Series { name: one.name.clone(), labels }
        };
        found = found.iter().flat_map(|one| value.split('|').map(|value| with(one, value))).collect();
    }
    found
}

/// Returns the selectors of all expressions in a text.
fn selectors(text: &str) -> BTreeSet<Series> {
    let mut found = BTreeSet::new();
    for prefix in ["plateau_", "process_"] {
        for (at, _) in text.match_indices(prefix) {
            if !text[..at].ends_with(is_part_of_a_name) {
                found.extend(series(&text[at..]));
            }
        }
    }
    found
}

/// Returns the labels by which the expressions of a text group, and those that its annotations name. Labels that
/// Prometheus itself adds are left out.
fn labels(text: &str) -> BTreeSet<&str> {
    let grouped = text.split("by (").skip(1).filter_map(|rest| rest.split_once(')'));
    let grouped = grouped.flat_map(|(inside, _)| inside.split(',').map(str::trim));
    let named = text.split("$labels.").skip(1).filter_map(|rest| rest.split(|end| !is_part_of_a_name(end)).next());
    grouped.chain(named).filter(|label| !["instance", "job"].contains(label)).collect()
}

/// Returns the alerts, each with its annotations, and the expressions of the dashboard.
fn expressions() -> Vec<String> {
    let alerts = RULES.split("- alert:").skip(1).map(str::to_owned);
    let dashboard: serde_json::Value = serde_json::from_str(DASHBOARD).unwrap();
    let panels = dashboard["panels"].as_array().unwrap();
    let targets = panels.iter().flat_map(|panel| panel["targets"].as_array().unwrap());
    alerts.chain(targets.map(|target| target["expr"].as_str().unwrap().to_owned())).collect()
}

#[test]
fn selectors_are_read_with_their_labels() {
    let text = r#"rate(plateau_a_total{job="x", kind=~"b|c", status="503"}[5m]) > 0.9 * process_b"#;
    let read: Vec<String> = selectors(text)
        .iter()
        .map(|one| format!("{} {:?}", one.name, one.labels.values().collect::<Vec<_>>()))
        .collect();
    assert_eq!(read, [r#"plateau_a_total ["b", "503"]"#, r#"plateau_a_total ["c", "503"]"#, "process_b []"]);
    let text = "sum by (kind, le) (a) / sum by (instance) (b)\nsummary: \"{{ $labels.type }} of {{ $labels.job }}\"";
    assert_eq!(labels(text), ["kind", "le", "type"].into());
}

#[tokio::test]
async fn every_metric_of_the_alerts_and_the_dashboard_exists() {
    let app = TestApp::start_with(&[("PLATEAU_WORKERS", "1"), ("PLATEAU_STORE__MAX_JOBS", "1000")]).await;
    let job = app.solve(RULED, &example("two-rails")).await;
    app.get(&format!("{}/mesh", job["links"]["self"].as_str().unwrap())).await;
    app.get("/health/ready").await;
    let metrics = app.get("/metrics").await.text().await.unwrap();
    let present: BTreeSet<Series> = metrics.lines().filter(|line| !line.starts_with('#')).flat_map(series).collect();
    let expressions = expressions();
    let mut asked = BTreeSet::new();
    for expression in &expressions {
        let selectors = selectors(expression);
        for label in labels(expression) {
            let of_expression = |one: &&Series| selectors.iter().any(|selector| selector.name == one.name);
            let has = present.iter().filter(of_expression).any(|one| one.labels.contains_key(label));
            assert!(has || selectors.is_empty(), "no series of {expression} has the label {label}");
        }
        asked.extend(selectors);
    }
    assert!(asked.len() > 20, "{asked:#?}");
    for one in &asked {
        let mut wanted = one.clone();
        // A healthy server has no series with a status of 500 or above.
        if one.labels.get("status").is_some_and(|status| status.starts_with('5')) {
            wanted.labels.insert("status".into(), "200".into());
        }
        let exists = present.iter().any(|series| {
            series.name == wanted.name
                && wanted.labels.iter().all(|(label, value)| series.labels.get(label) == Some(value))
        });
        assert!(exists, "no server has {one:?}");
    }
    // Each alert on an increase has its series before the first increase, with every kind.
    for name in ["plateau_audit_failures_total", "plateau_auth_failures_total"] {
        assert!(present.iter().any(|series| series.name == name), "{name}");
    }
}
