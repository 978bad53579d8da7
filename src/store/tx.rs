//! A transaction of either engine, with its statements, parameters and rows.
//!
//! Statements are written once for both engines, with parameters `$1`, `$2`, …. Two marks in a text are replaced.
//! `now_ms()` becomes an expression for the database's own clock in milliseconds. The comment `/* skip locked */`
//! becomes `FOR UPDATE SKIP LOCKED` on PostgreSQL; SQLite has one writer and needs no row locks.

use std::collections::BTreeSet;
use std::rc::Rc;

use rusqlite::types::{FromSql as FromSqlite, Value as SqliteValue, ValueRef};

use super::session::{FromSql as FromPostgres, Row as PgRow, Session};
use super::value::Value;
use super::{Result, StoreError};
#[cfg(feature = "test-hooks")]
use crate::test_hooks::{FailurePoint, statement_fails};

const CLOCK: &str = "now_ms()";
const SQLITE_CLOCK: &str = "CAST(unixepoch('subsec') * 1000 AS INTEGER)";
const POSTGRES_CLOCK: &str = "(extract(epoch from clock_timestamp()) * 1000)::bigint";
const SKIP_LOCKED: &str = "/* skip locked */";

/// A transaction, or a connection that only reads.
#[derive(Debug)]
pub(super) struct Tx<'c> {
    connection: Connection<'c>,
    /// Actions to take after the transaction has been committed.
    after_commit: AfterCommit,
}

#[derive(Debug)]
enum Connection<'c> {
    Sqlite(&'c rusqlite::Connection),
    #[cfg_attr(not(feature = "postgres"), expect(dead_code, reason = "such a build has no sessions"))]
    Postgres(&'c mut Session),
}

/// Actions to take after a transaction has been committed.
#[derive(Debug, Default)]
pub(super) struct AfterCommit {
    /// Jobs whose watchers must be notified.
    pub(super) jobs: BTreeSet<String>,
    /// True if a job may have become claimable.
    pub(super) work: bool,
    /// Result files that no row names any more.
    pub(super) unneeded_files: Vec<String>,
}

impl<'c> Tx<'c> {
    pub(super) fn sqlite(connection: &'c rusqlite::Connection) -> Self {
        Self { connection: Connection::Sqlite(connection), after_commit: AfterCommit::default() }
    }

    #[cfg(feature = "postgres")]
    pub(super) fn postgres(session: &'c mut Session) -> Self {
        Self { connection: Connection::Postgres(session), after_commit: AfterCommit::default() }
    }

    /// Runs a statement and returns its rows.
    pub(super) fn rows(&mut self, text: &str, values: &[Value<'_>]) -> Result<Vec<Row>> {
        match &mut self.connection {
            Connection::Sqlite(connection) => {
                #[cfg(feature = "test-hooks")]
                fail_if_asked(connection, text, FailurePoint::Before)?;
                let mut statement = prepared(connection, text, values)?;
                let names: Rc<[String]> = statement.column_names().into_iter().map(str::to_owned).collect();
                let mut rows = statement.raw_query();
                let mut read = Vec::new();
                while let Some(row) = rows.next()? {
                    let values = (0..names.len()).map(|column| row.get(column)).collect::<rusqlite::Result<_>>()?;
                    read.push(Row::Sqlite { names: Rc::clone(&names), values });
                }
                #[cfg(feature = "test-hooks")]
                fail_if_asked(connection, text, FailurePoint::After)?;
                Ok(read)
            }
            Connection::Postgres(session) => {
                Ok(session.rows(&for_postgres(text), values)?.into_iter().map(Row::Postgres).collect())
            }
        }
    }

    /// Runs a statement and returns its first row, if any.
    pub(super) fn row(&mut self, text: &str, values: &[Value<'_>]) -> Result<Option<Row>> {
        Ok(self.rows(text, values)?.into_iter().next())
    }

    /// Runs a SELECT that always returns a row.
    pub(super) fn one(&mut self, text: &str, values: &[Value<'_>]) -> Result<Row> {
        self.row(text, values)?.ok_or_else(|| StoreError::Internal(format!("no row from {text:?}")))
    }

    /// Returns true if the statement returns a row.
    pub(super) fn exists(&mut self, text: &str, values: &[Value<'_>]) -> Result<bool> {
        Ok(self.row(text, values)?.is_some())
    }

    /// Runs a statement and returns the number of rows that it changed.
    pub(super) fn execute(&mut self, text: &str, values: &[Value<'_>]) -> Result<u64> {
        match &mut self.connection {
            Connection::Sqlite(connection) => {
                #[cfg(feature = "test-hooks")]
                fail_if_asked(connection, text, FailurePoint::Before)?;
                let changed = prepared(connection, text, values)?.raw_execute()? as u64;
                #[cfg(feature = "test-hooks")]
                fail_if_asked(connection, text, FailurePoint::After)?;
                Ok(changed)
            }
            Connection::Postgres(session) => session.execute(&for_postgres(text), values),
        }
    }

    /// Inserts a row. Each column is given by its name and value.
    pub(super) fn insert(&mut self, table: &str, columns: &[(&str, Value<'_>)]) -> Result<()> {
        let names: Vec<&str> = columns.iter().map(|(name, _)| *name).collect();
        let parameters: Vec<String> = (1..=columns.len()).map(|number| format!("${number}")).collect();
        let text = format!("INSERT INTO {table} ({}) VALUES ({})", names.join(", "), parameters.join(", "));
        let values: Vec<Value<'_>> = columns.iter().map(|(_, value)| *value).collect();
        self.execute(&text, &values).map(|_| ())
    }

    /// Runs a script of several statements without parameters.
    pub(super) fn script(&mut self, text: &str) -> Result<()> {
        match &mut self.connection {
            Connection::Sqlite(connection) => Ok(connection.execute_batch(text)?),
            Connection::Postgres(session) => session.script(text),
        }
    }

    /// Returns the database's clock in milliseconds since 1970.
    pub(super) fn now_ms(&mut self) -> Result<i64> {
        self.one("SELECT now_ms() AS now", &[])?.get("now")
    }

    /// Notifies the watchers of this job after the commit.
    pub(super) fn changed(&mut self, id: &str) {
        self.after_commit.jobs.insert(id.to_owned());
    }

    /// Notifies the workers after the commit that a job may be claimable.
    pub(super) fn work_available(&mut self) {
        self.after_commit.work = true;
    }

    /// Removes a result file after the commit.
    pub(super) fn drop_file(&mut self, file: Option<String>) {
        self.after_commit.unneeded_files.extend(file);
    }

    /// Returns the actions to take after the transaction has been committed.
    pub(super) fn into_after_commit(self) -> AfterCommit {
        self.after_commit
    }

    pub(super) fn is_postgres(&self) -> bool {
        matches!(self.connection, Connection::Postgres(_))
    }
}

/// Fails if a test has asked for a failure of this statement of SQLite.
#[cfg(feature = "test-hooks")]
pub(super) fn fail_if_asked(connection: &rusqlite::Connection, text: &str, point: FailurePoint) -> Result<()> {
    // A transaction has ended after its COMMIT.
    let in_transaction = !connection.is_autocommit() || text == "COMMIT";
    if statement_fails(text, point, in_transaction) {
        return Err(StoreError::Unavailable("a test asked for this failure".into()));
    }
    Ok(())
}

fn prepared<'c>(
    connection: &'c rusqlite::Connection,
    text: &str,
    values: &[Value<'_>],
) -> Result<rusqlite::CachedStatement<'c>> {
    let mut statement = connection.prepare_cached(&for_sqlite(text))?;
    // PostgreSQL allows parameters that the text does not use, so SQLite has to allow them too.
    for (index, value) in (1..=statement.parameter_count()).zip(values) {
        statement.raw_bind_parameter(index, value)?;
    }
    Ok(statement)
}

/// Converts a statement for SQLite, which numbers its parameters `?1` and would read `$1` as a name.
fn for_sqlite(text: &str) -> String {
    text.replace(CLOCK, SQLITE_CLOCK).replace('$', "?")
}

fn for_postgres(text: &str) -> String {
    text.replace(CLOCK, POSTGRES_CLOCK).replace(SKIP_LOCKED, "FOR UPDATE SKIP LOCKED")
}

/// A row of either engine. Columns are read by name.
#[derive(Debug)]
pub(super) enum Row {
    Sqlite { names: Rc<[String]>, values: Vec<SqliteValue> },
    Postgres(PgRow),
}

impl Row {
    /// Returns the value of a column as `i64`, `String`, `Vec<u8>`, or an `Option` of one of these.
    pub(super) fn get<T: FromSqlite + for<'r> FromPostgres<'r>>(&self, column: &str) -> Result<T> {
        let unreadable = |reason: &dyn std::fmt::Display| StoreError::Internal(format!("column {column}: {reason}"));
        match self {
            Self::Sqlite { names, values } => {
                let index =
                    names.iter().position(|name| name == column).ok_or_else(|| unreadable(&"not in this row"))?;
                T::column_result(ValueRef::from(&values[index])).map_err(|error| unreadable(&error))
            }
            Self::Postgres(row) => row.try_get(column).map_err(|error| unreadable(&error)),
        }
    }

    /// Returns the owner. The column holds an empty text for a job or batch without an owner.
    pub(super) fn owner(&self) -> Result<Option<String>> {
        let owner: String = self.get("owner")?;
        Ok((!owner.is_empty()).then_some(owner))
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn the_marks_become_the_clock_and_the_locks_of_each_engine() {
        let text = "SELECT now_ms() + $2 FROM jobs /* skip locked */";
        assert_eq!(for_sqlite(text), format!("SELECT {SQLITE_CLOCK} + ?2 FROM jobs /* skip locked */"));
        assert_eq!(for_postgres(text), format!("SELECT {POSTGRES_CLOCK} + $2 FROM jobs FOR UPDATE SKIP LOCKED"));
    }

    #[test]
    fn a_column_is_read_by_its_name_and_type() {
        let connection = rusqlite::Connection::open_in_memory().unwrap();
        let mut tx = Tx::sqlite(&connection);
        let row = tx.one("SELECT $1 AS text, $2 AS missing, $3 AS number", &["a".into(), Value::Text(None), 7.into()]);
        let row = row.unwrap();
        assert_eq!(row.get::<String>("text").unwrap(), "a");
        assert_eq!(row.get::<Option<String>>("missing").unwrap(), None);
        assert_eq!(row.get::<i64>("number").unwrap(), 7);
        for (column, error) in [("other", "not in this row"), ("text", "Invalid type"), ("missing", "Invalid type")] {
            let Err(StoreError::Internal(text)) = row.get::<i64>(column) else { panic!("{column}") };
            assert!(text.contains(column) && text.contains(error), "{text}");
        }
    }
}
