//! The database of a store, which is SQLite or PostgreSQL.

use std::sync::Arc;

use super::{postgres, sqlite};

#[derive(Debug)]
pub(super) enum Engine {
    Sqlite(sqlite::Database),
    Postgres(Arc<postgres::Database>),
}
