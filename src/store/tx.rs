//! A transaction of either engine: statements, their parameters and their rows.
//!
//! Statements are written once for both engines, with parameters `$1`, `$2`, …. Two marks in a text are replaced:
//! `now_ms()` becomes the engine's expression for the database's own clock in milliseconds, and the comment
//! `/* skip locked */` becomes `FOR UPDATE SKIP LOCKED` on PostgreSQL. SQLite has one writer and needs no row locks.

use std::collections::BTreeSet;
use std::rc::Rc;

use rusqlite::types::{FromSql as FromSqlite, ToSqlOutput, Value as SqliteValue, ValueRef};

use super::postgres::{FromPostgres, PgRow, Session};
use super::{Result, StoreError};

const CLOCK: &str = "now_ms()";
const SQLITE_CLOCK: &str = "CAST(unixepoch('subsec') * 1000 AS INTEGER)";
const POSTGRES_CLOCK: &str = "(extract(epoch from clock_timestamp()) * 1000)::bigint";
const SKIP_LOCKED: &str = "/* skip locked */";

/// A transaction, or a connection that only reads.
#[derive(Debug)]
pub(super) struct Tx<'c> {
    connection: Connection<'c>,
    /// What follows from the transaction once it has committed.
    news: News,
}

#[derive(Debug)]
enum Connection<'c> {
    Sqlite(&'c rusqlite::Connection),
    Postgres(&'c mut Session),
}

/// What follows from a transaction that has committed.
#[derive(Debug, Default)]
pub(super) struct News {
    /// Jobs whose watchers are told.
    pub(super) jobs: BTreeSet<String>,
    /// True if a job may have become claimable.
    pub(super) work: bool,
    /// Result files that no row names any more.
    pub(super) unneeded_files: Vec<String>,
}

/// A parameter of a statement. `None` is NULL; the variant is the type, which PostgreSQL wants to know even of a NULL.
#[derive(Debug, Clone, Copy)]
pub(super) enum Value<'v> {
    Int(Option<i64>),
    Text(Option<&'v str>),
    Bytes(Option<&'v [u8]>),
}

impl From<i64> for Value<'_> {
    fn from(value: i64) -> Self {
        Self::Int(Some(value))
    }
}

impl From<Option<i64>> for Value<'_> {
    fn from(value: Option<i64>) -> Self {
        Self::Int(value)
    }
}

impl<'v> From<&'v str> for Value<'v> {
    fn from(value: &'v str) -> Self {
        Self::Text(Some(value))
    }
}

impl<'v> From<&'v String> for Value<'v> {
    fn from(value: &'v String) -> Self {
        Self::Text(Some(value))
    }
}

impl<'v> From<Option<&'v str>> for Value<'v> {
    fn from(value: Option<&'v str>) -> Self {
        Self::Text(value)
    }
}

impl<'v> From<&'v [u8]> for Value<'v> {
    fn from(value: &'v [u8]) -> Self {
        Self::Bytes(Some(value))
    }
}

impl<'v> From<&'v [u8; 32]> for Value<'v> {
    fn from(value: &'v [u8; 32]) -> Self {
        Self::Bytes(Some(value))
    }
}

impl<'v> From<Option<&'v [u8]>> for Value<'v> {
    fn from(value: Option<&'v [u8]>) -> Self {
        Self::Bytes(value)
    }
}

impl rusqlite::ToSql for Value<'_> {
    fn to_sql(&self) -> rusqlite::Result<ToSqlOutput<'_>> {
        Ok(ToSqlOutput::Borrowed(match self {
            Self::Int(Some(value)) => ValueRef::Integer(*value),
            Self::Text(Some(text)) => ValueRef::Text(text.as_bytes()),
            Self::Bytes(Some(bytes)) => ValueRef::Blob(bytes),
            Self::Int(None) | Self::Text(None) | Self::Bytes(None) => ValueRef::Null,
        }))
    }
}

impl<'c> Tx<'c> {
    pub(super) fn sqlite(connection: &'c rusqlite::Connection) -> Self {
        Self { connection: Connection::Sqlite(connection), news: News::default() }
    }

    pub(super) fn postgres(session: &'c mut Session) -> Self {
        Self { connection: Connection::Postgres(session), news: News::default() }
    }

    /// Runs a statement and returns its rows.
    pub(super) fn rows(&mut self, text: &str, values: &[Value<'_>]) -> Result<Vec<Row>> {
        match &mut self.connection {
            Connection::Sqlite(connection) => {
                let mut statement = prepared(connection, text, values)?;
                let names: Rc<[String]> = statement.column_names().into_iter().map(str::to_owned).collect();
                let mut rows = statement.raw_query();
                let mut read = Vec::new();
                while let Some(row) = rows.next()? {
                    let values = (0..names.len()).map(|column| row.get(column)).collect::<rusqlite::Result<_>>()?;
                    read.push(Row::Sqlite { names: Rc::clone(&names), values });
                }
                Ok(read)
            }
            Connection::Postgres(session) => {
                Ok(session.rows(&for_postgres(text), values)?.into_iter().map(Row::Postgres).collect())
            }
        }
    }

    /// Runs a statement that returns at most one row of interest.
    pub(super) fn row(&mut self, text: &str, values: &[Value<'_>]) -> Result<Option<Row>> {
        Ok(self.rows(text, values)?.into_iter().next())
    }

    /// Runs a SELECT that always returns a row.
    pub(super) fn one(&mut self, text: &str, values: &[Value<'_>]) -> Result<Row> {
        self.row(text, values)?.ok_or_else(|| StoreError::Internal(format!("no row from {text:?}")))
    }

    /// True if the statement returns a row.
    pub(super) fn exists(&mut self, text: &str, values: &[Value<'_>]) -> Result<bool> {
        Ok(self.row(text, values)?.is_some())
    }

    /// Runs a statement and returns how many rows it changed.
    pub(super) fn execute(&mut self, text: &str, values: &[Value<'_>]) -> Result<u64> {
        match &mut self.connection {
            Connection::Sqlite(connection) => Ok(prepared(connection, text, values)?.raw_execute()? as u64),
            Connection::Postgres(session) => session.execute(&for_postgres(text), values),
        }
    }

    /// Inserts a row: each column by its name, beside its value.
    pub(super) fn insert(&mut self, table: &str, columns: &[(&str, Value<'_>)]) -> Result<()> {
        let names: Vec<&str> = columns.iter().map(|(name, _)| *name).collect();
        let places: Vec<String> = (1..=columns.len()).map(|place| format!("${place}")).collect();
        let text = format!("INSERT INTO {table} ({}) VALUES ({})", names.join(", "), places.join(", "));
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

    /// The database's clock: milliseconds since 1970.
    pub(super) fn now_ms(&mut self) -> Result<i64> {
        self.one("SELECT now_ms() AS now", &[])?.get("now")
    }

    /// Tells whoever watches this job that it has changed.
    pub(super) fn changed(&mut self, id: &str) {
        self.news.jobs.insert(id.to_owned());
    }

    /// Tells workers that a job may be claimable.
    pub(super) fn work(&mut self) {
        self.news.work = true;
    }

    /// Removes a result file after the commit.
    pub(super) fn drop_file(&mut self, file: Option<String>) {
        self.news.unneeded_files.extend(file);
    }

    /// What follows from this transaction once it has committed.
    pub(super) fn into_news(self) -> News {
        self.news
    }

    pub(super) fn is_postgres(&self) -> bool {
        matches!(self.connection, Connection::Postgres(_))
    }
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

/// SQLite numbers its parameters `?1`; it would take `$1` for a name.
fn for_sqlite(text: &str) -> String {
    text.replace(CLOCK, SQLITE_CLOCK).replace('$', "?")
}

fn for_postgres(text: &str) -> String {
    text.replace(CLOCK, POSTGRES_CLOCK).replace(SKIP_LOCKED, "FOR UPDATE SKIP LOCKED")
}

/// A row of either engine; its columns are read by name.
#[derive(Debug)]
pub(super) enum Row {
    Sqlite { names: Rc<[String]>, values: Vec<SqliteValue> },
    Postgres(PgRow),
}

impl Row {
    /// The value of a column, as `i64`, `String`, `Vec<u8>`, or an `Option` of one of these.
    pub(super) fn get<T: FromSqlite + for<'r> FromPostgres<'r>>(&self, column: &str) -> Result<T> {
        let wrong = |why: &dyn std::fmt::Display| StoreError::Internal(format!("column {column}: {why}"));
        match self {
            Self::Sqlite { names, values } => {
                let place = names.iter().position(|name| name == column).ok_or_else(|| wrong(&"not in this row"))?;
                T::column_result(ValueRef::from(&values[place])).map_err(|error| wrong(&error))
            }
            Self::Postgres(row) => row.try_get(column).map_err(|error| wrong(&error)),
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn each_engine_gets_its_own_clock_and_locks() {
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
