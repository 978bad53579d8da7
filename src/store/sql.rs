//! One SQL text for two engines.
//!
//! Statements are written once, with `$1`-style parameters, which both engines take. Two marks in a text differ:
//! `now_ms()` becomes the engine's expression for the database's own clock in milliseconds, and the comment
//! `/* skip locked */` becomes `FOR UPDATE SKIP LOCKED` on PostgreSQL (SQLite has one writer and needs no lock).

use std::borrow::Cow;

use sqlx::postgres::PgRow;
use sqlx::sqlite::SqliteRow;
use sqlx::{AssertSqlSafe, PgConnection, Row as _, SqliteConnection};

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

/// A connection of either engine, inside a transaction or not.
#[derive(Debug)]
pub(super) enum Connection<'c> {
    Sqlite(&'c mut SqliteConnection),
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
    pub(super) async fn rows(&mut self, text: &str, values: Vec<Value>) -> sqlx::Result<Vec<Row>> {
        Ok(match self {
            Self::Sqlite(connection) => bind!(AssertSqlSafe(for_sqlite(text)), values)
                .fetch_all(&mut **connection)
                .await?
                .into_iter()
                .map(Row::Sqlite)
                .collect(),
            Self::Postgres(connection) => bind!(AssertSqlSafe(for_postgres(text)), values)
                .fetch_all(&mut **connection)
                .await?
                .into_iter()
                .map(Row::Postgres)
                .collect(),
        })
    }

    /// Runs a statement that returns at most one row of interest.
    pub(super) async fn row(&mut self, text: &str, values: Vec<Value>) -> sqlx::Result<Option<Row>> {
        Ok(self.rows(text, values).await?.into_iter().next())
    }

    /// Runs a statement and returns how many rows it changed.
    pub(super) async fn execute(&mut self, text: &str, values: Vec<Value>) -> sqlx::Result<u64> {
        Ok(match self {
            Self::Sqlite(connection) => {
                bind!(AssertSqlSafe(for_sqlite(text)), values).execute(&mut **connection).await?.rows_affected()
            }
            Self::Postgres(connection) => {
                bind!(AssertSqlSafe(for_postgres(text)), values).execute(&mut **connection).await?.rows_affected()
            }
        })
    }
}

fn for_sqlite(text: &str) -> String {
    text.replace(CLOCK, SQLITE_CLOCK)
}

fn for_postgres(text: &str) -> String {
    text.replace(CLOCK, POSTGRES_CLOCK).replace(SKIP_LOCKED, "FOR UPDATE SKIP LOCKED")
}

/// A row of either engine; columns by position.
pub(super) enum Row {
    Sqlite(SqliteRow),
    Postgres(PgRow),
}

macro_rules! column {
    ($row:expr, $index:expr) => {
        match $row {
            Row::Sqlite(row) => row.try_get_unchecked($index),
            Row::Postgres(row) => row.try_get($index),
        }
    };
}

impl Row {
    pub(super) fn int(&self, index: usize) -> sqlx::Result<i64> {
        column!(self, index)
    }

    pub(super) fn optional_int(&self, index: usize) -> sqlx::Result<Option<i64>> {
        column!(self, index)
    }

    pub(super) fn text(&self, index: usize) -> sqlx::Result<String> {
        column!(self, index)
    }

    pub(super) fn optional_text(&self, index: usize) -> sqlx::Result<Option<String>> {
        column!(self, index)
    }

    pub(super) fn bytes(&self, index: usize) -> sqlx::Result<Vec<u8>> {
        column!(self, index)
    }

    pub(super) fn optional_bytes(&self, index: usize) -> sqlx::Result<Option<Vec<u8>>> {
        column!(self, index)
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
        let text = "SELECT now_ms() FROM jobs /* skip locked */";
        assert_eq!(for_sqlite(text), format!("SELECT {SQLITE_CLOCK} FROM jobs /* skip locked */"));
        assert_eq!(for_postgres(text), format!("SELECT {POSTGRES_CLOCK} FROM jobs FOR UPDATE SKIP LOCKED"));
    }
}
