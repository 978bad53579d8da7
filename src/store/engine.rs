//! The database of a store, which is SQLite or PostgreSQL.

use std::sync::Arc;

use super::tx::{AfterCommit, Tx};
use super::{Result, postgres, sqlite};

#[derive(Debug)]
pub(super) enum Engine {
    Sqlite(sqlite::Database),
    Postgres(Arc<postgres::Database>),
}

impl Engine {
    pub(super) async fn write<T: Send + 'static>(
        &self,
        work: impl Fn(&mut Tx<'_>) -> Result<T> + Send + 'static,
    ) -> Result<(T, AfterCommit)> {
        match self {
            Self::Sqlite(database) => database.write(work).await,
            Self::Postgres(database) => database.write(work).await,
        }
    }

    pub(super) async fn read<T: Send + 'static>(
        &self,
        work: impl Fn(&mut Tx<'_>) -> Result<T> + Send + 'static,
    ) -> Result<T> {
        match self {
            Self::Sqlite(database) => database.read(work).await,
            Self::Postgres(database) => database.read(work).await,
        }
    }
}
