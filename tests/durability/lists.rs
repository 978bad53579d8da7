//! Lists of jobs by kind and status read an index, and no rows of other jobs.

use crate::postgres::Postgres;
use crate::proxy::Proxy;
use plateau::status::Status;
use plateau::store::{Filter, Store, StoreOptions};

/// SQL that inserts 40,000 jobs of four owners. A list by kind and status returns few of them.
const FILLING: &str = "INSERT INTO jobs (id, kind, owner, status, attempt, sequence, turn, created_at, body_hash, \
                       content_hash, sharing, history, warnings, statistics) \
                       SELECT lpad(n::text, 26, '0'), \
                       CASE WHEN n % 1000 = 0 THEN 'ruled_surface' ELSE 'minimal_surface' END, 'owner' || n % 4, \
                       CASE WHEN n % 500 = 0 THEN 'failed' ELSE 'succeeded' END, 1, 1, n, n, '', '', 'refused', '', \
                       '[]', repeat('x', 500) FROM generate_series(1, 40000) n";

/// Returns the plan of a statement of a list as PostgreSQL makes it for these values.
fn plan(client: &mut ::postgres::Client, statement: &str, values: &str) -> Vec<String> {
    client.batch_execute(&format!("PREPARE list AS {statement}")).unwrap();
    let rows = client.simple_query(&format!("EXPLAIN EXECUTE list ({values})")).unwrap();
    client.batch_execute("DEALLOCATE list").unwrap();
    let line = |row: &::postgres::SimpleQueryMessage| match row {
        ::postgres::SimpleQueryMessage::Row(row) => row.get(0).map(str::to_owned),
        _ => None,
    };
    rows.iter().filter_map(line).collect()
}

/// An instruction of SQLite's program for a statement: its name and its first two parameters.
type Instruction = (String, i64, i64);

fn program(connection: &rusqlite::Connection, statement: &str) -> Vec<Instruction> {
    let mut explained = connection.prepare(&format!("EXPLAIN {statement}")).unwrap();
    let (mut rows, mut program) = (explained.raw_query(), Vec::new());
    while let Some(row) = rows.next().unwrap() {
        program.push((row.get("opcode").unwrap(), row.get("p1").unwrap(), row.get("p2").unwrap()));
    }
    program
}

#[tokio::test(flavor = "multi_thread", worker_threads = 2)]
async fn a_list_by_kind_and_status_reads_only_the_rows_that_it_returns() {
    let Some(server) = Postgres::start() else { return };
    let url = server.database().await;
    let proxy = Proxy::start(&url);
    let store = Store::open(&proxy.url(), StoreOptions::default()).await.unwrap();
    let folder = tempfile::tempdir().unwrap();
    let path = folder.path().join("plateau.sqlite");
    Store::open(&format!("sqlite://{}", path.display()), StoreOptions::default()).await.unwrap().close().await;
    for (owner, index, values) in [
        (Some("owner0"), "jobs_by_owner", "100, 'owner0', 'ruled_surface', 'failed'"),
        (None, "jobs_by_id", "100, 'ruled_surface', 'failed'"),
    ] {
        let filter = Filter {
            owner: owner.map(str::to_owned),
            kind: Some("ruled_surface".into()),
            statuses: vec![Status::Failed],
            ..Filter::default()
        };
        proxy.forget();
        store.list(filter, 99, None).await.unwrap();
        let seen = proxy.seen();
        let mut lists =
            seen.iter().map(|boundary| &boundary.statement).filter(|text| text.contains("ORDER BY id DESC"));
        let statement = lists.next().expect("the statement of the list").clone();

        // Both engines run the same text.
        let connection = rusqlite::Connection::open(&path).unwrap();
        let table = "SELECT rootpage FROM sqlite_schema WHERE name = 'jobs'";
        let table: i64 = connection.query_row(table, [], |row| row.get(0)).unwrap();
        let program = program(&connection, &statement);
        let opened = program.iter().find(|(name, _, page)| name == "OpenRead" && *page == table);
        let cursor = opened.expect("the table is opened").1;
        let read = program.iter().position(|(name, from, _)| name == "Column" && *from == cursor).expect("a column");
        let compared = program.iter().rposition(|(name, ..)| name == "Ne").expect("a comparison");
        assert!(compared < read, "SQLite reads a row before it has compared kind and status: {program:#?}");

        let (url, explained) = (url.clone(), statement.clone());
        let plan = move || {
            let (server, folder) = url.split_once("?host=").unwrap();
            let mut config = ::postgres::Config::new();
            config.user("postgres").dbname(server.rsplit_once('/').unwrap().1).host_path(folder);
            let mut client = config.connect(::postgres::NoTls).unwrap();
            client.batch_execute(&format!("TRUNCATE jobs; {FILLING}; ANALYZE jobs")).unwrap();
            plan(&mut client, &explained, values)
        };
        let plan = tokio::task::spawn_blocking(plan).await.unwrap().join("\n");
        let condition = plan.lines().find(|line| line.contains("Index Cond:")).unwrap_or_default();
        let by_index = plan.contains(index) && condition.contains("kind") && condition.contains("status");
        assert!(by_index && !plan.contains("Seq Scan") && !plan.contains("Filter:"), "{statement}\n{plan}");
    }
}
