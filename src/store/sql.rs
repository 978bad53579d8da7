//! One SQL text for two engines.
//!
//! Statements are written once, with `$1`-style parameters, which both engines take. Two marks in a text differ:
//! `now_ms()` becomes the engine's expression for the database's own clock in milliseconds, and the comment
//! `/* skip locked */` becomes `FOR UPDATE SKIP LOCKED` on PostgreSQL (SQLite has one writer and needs no lock).

use std::borrow::Cow;

use rusqlite::types::{ToSqlOutput, Value as SqliteValue, ValueRef};
use sqlx::postgres::PgRow;
use sqlx::{AssertSqlSafe, PgConnection, Row as _};

use super::StoreError;
use super::engine::Result;

const CLOCK: &str = "now_ms()";
const SQLITE_CLOCK: &str = "CAST(unixepoch('subsec') * 1000 AS INTEGER)";
const POSTGRES_CLOCK: &str = "(extract(epoch from clock_timestamp()) * 1000)::bigint";
const SKIP_LOCKED: &str = "/* skip locked */";

/// A parameter of a statement. The variants of `Option` carry the type that PostgreSQL wants even of a NULL.
#[derive(Debug, Clone)]
pub(super) enum Value {
    Int(i64),
    Text(String),
    OptionalText(Option<String>),
    Bytes(Vec<u8>),
    OptionalBytes(Option<Vec<u8>>),
}

impl From<i64> for Value {
    fn from(value: i64) -> Self {
        Self::Int(value)
    }
}

impl From<String> for Value {
    fn from(value: String) -> Self {
        Self::Text(value)
    }
}

impl From<&str> for Value {
    fn from(value: &str) -> Self {
        Self::Text(value.to_owned())
    }
}

impl From<Option<String>> for Value {
    fn from(value: Option<String>) -> Self {
        Self::OptionalText(value)
    }
}

impl From<&[u8]> for Value {
    fn from(value: &[u8]) -> Self {
        Self::Bytes(value.to_vec())
    }
}

impl rusqlite::ToSql for Value {
    fn to_sql(&self) -> rusqlite::Result<ToSqlOutput<'_>> {
        Ok(ToSqlOutput::Borrowed(match self {
            Self::Int(value) => ValueRef::Integer(*value),
            Self::Text(text) | Self::OptionalText(Some(text)) => ValueRef::Text(text.as_bytes()),
            Self::Bytes(bytes) | Self::OptionalBytes(Some(bytes)) => ValueRef::Blob(bytes),
            Self::OptionalText(None) | Self::OptionalBytes(None) => ValueRef::Null,
        }))
    }
}

/// A connection of either engine, inside a transaction or not. On SQLite a statement runs on the thread that polls it and has
/// ended at the first poll.
#[derive(Debug)]
pub(super) enum Connection<'c> {
    Sqlite(&'c mut rusqlite::Connection),
    Postgres(&'c mut PgConnection),
}

macro_rules! bind {
    ($text:expr, $values:expr) => {{
        let mut query = sqlx::query($text);
        for value in $values {
            query = match value {
                Value::Int(value) => query.bind(value),
                Value::Text(value) => query.bind(value),
                Value::OptionalText(value) => query.bind(value),
                Value::Bytes(value) => query.bind(value),
                Value::OptionalBytes(value) => query.bind(value),
            };
        }
        query
    }};
}

impl Connection<'_> {
    /// Runs a statement and returns its rows.
    pub(super) async fn rows(&mut self, text: &str, values: Vec<Value>) -> Result<Vec<Row>> {
        match self {
            Self::Sqlite(connection) => sqlite_rows(connection, text, &values),
            Self::Postgres(connection) => {
                let query = bind!(AssertSqlSafe(for_postgres(text)), values);
                Ok(query.fetch_all(&mut **connection).await?.into_iter().map(Row::Postgres).collect())
            }
        }
    }

    /// Runs a statement that returns at most one row of interest.
    pub(super) async fn row(&mut self, text: &str, values: Vec<Value>) -> Result<Option<Row>> {
        Ok(self.rows(text, values).await?.into_iter().next())
    }

    /// Runs a statement and returns how many rows it changed.
    pub(super) async fn execute(&mut self, text: &str, values: Vec<Value>) -> Result<u64> {
        match self {
            Self::Sqlite(connection) => Ok(prepared(connection, text, &values)?.raw_execute()? as u64),
            Self::Postgres(connection) => {
                let query = bind!(AssertSqlSafe(for_postgres(text)), values);
                Ok(query.execute(&mut **connection).await?.rows_affected())
            }
        }
    }
}

/// Runs a statement on SQLite and returns its rows.
pub(super) fn sqlite_rows(connection: &rusqlite::Connection, text: &str, values: &[Value]) -> Result<Vec<Row>> {
    let mut statement = prepared(connection, text, values)?;
    let columns = statement.column_count();
    let mut rows = statement.raw_query();
    let mut read = Vec::new();
    while let Some(row) = rows.next()? {
        read.push(Row::Sqlite((0..columns).map(|column| row.get(column)).collect::<rusqlite::Result<_>>()?));
    }
    Ok(read)
}

fn prepared<'c>(
    connection: &'c rusqlite::Connection,
    text: &str,
    values: &[Value],
) -> Result<rusqlite::CachedStatement<'c>> {
    let mut statement = connection.prepare_cached(&for_sqlite(text))?;
    // As PostgreSQL, which is told of every value, a statement need not use them all.
    for (index, value) in (1..=statement.parameter_count()).zip(values) {
        statement.raw_bind_parameter(index, value)?;
    }
    Ok(statement)
}

/// SQLite numbers `?1`; a `$1` would be a name to it.
fn for_sqlite(text: &str) -> String {
    text.replace(CLOCK, SQLITE_CLOCK).replace('$', "?")
}

fn for_postgres(text: &str) -> String {
    text.replace(CLOCK, POSTGRES_CLOCK).replace(SKIP_LOCKED, "FOR UPDATE SKIP LOCKED")
}

/// A row of either engine; columns by position.
pub(super) enum Row {
    Sqlite(Vec<SqliteValue>),
    Postgres(PgRow),
}

macro_rules! column {
    ($row:expr, $index:expr, $($value:pat => $read:expr),+) => {
        match $row {
            Row::Sqlite(values) => match &values[$index] {
                $($value => Ok($read),)+
                value => Err(unexpected($index, value)),
            },
            Row::Postgres(row) => Ok(row.try_get($index)?),
        }
    };
}

fn unexpected(column: usize, value: &SqliteValue) -> StoreError {
    StoreError::Internal(format!("column {column} is unexpectedly {}", value.data_type()))
}

impl Row {
    pub(super) fn int(&self, index: usize) -> Result<i64> {
        column!(self, index, SqliteValue::Integer(value) => *value)
    }

    pub(super) fn optional_int(&self, index: usize) -> Result<Option<i64>> {
        column!(self, index, SqliteValue::Integer(value) => Some(*value), SqliteValue::Null => None)
    }

    pub(super) fn text(&self, index: usize) -> Result<String> {
        column!(self, index, SqliteValue::Text(text) => text.clone())
    }

    pub(super) fn optional_text(&self, index: usize) -> Result<Option<String>> {
        column!(self, index, SqliteValue::Text(text) => Some(text.clone()), SqliteValue::Null => None)
    }

    pub(super) fn bytes(&self, index: usize) -> Result<Vec<u8>> {
        column!(self, index, SqliteValue::Blob(bytes) => bytes.clone())
    }

    pub(super) fn optional_bytes(&self, index: usize) -> Result<Option<Vec<u8>>> {
        column!(self, index, SqliteValue::Blob(bytes) => Some(bytes.clone()), SqliteValue::Null => None)
    }
}

/// `url` without its password, wherever it stands, for logs and errors.
pub fn redacted(url: &str) -> Cow<'_, str> {
    const PARAMETER: &str = "password=";
    if let Some(start) = url.find(PARAMETER).map(|at| at + PARAMETER.len()) {
        let end = url[start..].find('&').map_or(url.len(), |length| start + length);
        return Cow::Owned(format!("{}***{}", without_user_password(&url[..start]), &url[end..]));
    }
    without_user_password(url)
}

fn without_user_password(url: &str) -> Cow<'_, str> {
    let Some((scheme, rest)) = url.split_once("://") else { return Cow::Borrowed(url) };
    let authority_end = rest.find(['/', '?']).unwrap_or(rest.len());
    let Some(at) = rest[..authority_end].rfind('@') else { return Cow::Borrowed(url) };
    let Some(colon) = rest[..at].find(':') else { return Cow::Borrowed(url) };
    Cow::Owned(format!("{scheme}://{}:***{}", &rest[..colon], &rest[at..]))
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_password_is_not_shown() {
        assert_eq!(redacted("postgres://me:secret@db:5432/plateau"), "postgres://me:***@db:5432/plateau");
        assert_eq!(redacted("postgres://me:a@b@db/plateau"), "postgres://me:***@db/plateau");
        assert_eq!(redacted("postgres://db/plateau?user=a:b@c"), "postgres://db/plateau?user=a:b@c");
        assert_eq!(redacted("postgres://a:b@db/x?password=c&host=d"), "postgres://a:***@db/x?password=***&host=d");
        assert_eq!(redacted("sqlite:///data/plateau.db"), "sqlite:///data/plateau.db");
    }

    #[test]
    fn each_engine_gets_its_own_clock_and_locks() {
        let text = "SELECT now_ms() + $2 FROM jobs /* skip locked */";
        assert_eq!(for_sqlite(text), format!("SELECT {SQLITE_CLOCK} + ?2 FROM jobs /* skip locked */"));
        assert_eq!(for_postgres(text), format!("SELECT {POSTGRES_CLOCK} + $2 FROM jobs FOR UPDATE SKIP LOCKED"));
    }
}
