//! Numbered scripts that create and update the tables of both engines.
//!
//! A migration only adds columns and tables, so that an older version keeps working on a database that a newer one has
//! migrated. The table of applied migrations has the name and the columns of the library sqlx, because existing
//! databases have them.

use sha2::{Digest, Sha384};

use super::tx::Tx;
use super::{Result, StoreError};

const MIGRATIONS: [(i64, &str, &str); 10] = [
    (1, "jobs", include_str!("../../migrations/0001_jobs.sql")),
    (2, "batches and callbacks", include_str!("../../migrations/0002_batches_and_callbacks.sql")),
    (3, "sharing and leases", include_str!("../../migrations/0003_sharing_and_leases.sql")),
    (4, "labels and series", include_str!("../../migrations/0004_labels_and_series.sql")),
    (5, "secrets", include_str!("../../migrations/0005_secrets.sql")),
    (6, "summaries", include_str!("../../migrations/0006_summaries.sql")),
    (7, "leaders", include_str!("../../migrations/0007_leaders.sql")),
    (8, "deliveries", include_str!("../../migrations/0008_deliveries.sql")),
    (9, "memory of jobs", include_str!("../../migrations/0009_memory_of_jobs.sql")),
    (10, "lists", include_str!("../../migrations/0010_lists.sql")),
];

/// SQL that takes the advisory lock, so that only one process at a time migrates a PostgreSQL database.
const LOCK: &str = "SELECT pg_advisory_xact_lock(7019839175)";
const CREATE_TABLE: &str = "CREATE TABLE IF NOT EXISTS _sqlx_migrations (version BIGINT PRIMARY KEY, \
     description TEXT NOT NULL, installed_on TIMESTAMP NOT NULL DEFAULT CURRENT_TIMESTAMP, \
     success BOOLEAN NOT NULL, checksum BYTEA NOT NULL, execution_time BIGINT NOT NULL)";

/// Runs the migrations that the database lacks. The caller commits or rolls back all of them together.
pub(super) fn migrate(tx: &mut Tx<'_>) -> Result<()> {
    if tx.is_postgres() {
        tx.script(LOCK)?;
    }
    tx.script(CREATE_TABLE)?;
    for (version, name, text) in MIGRATIONS {
        let checksum = Sha384::digest(text);
        let known = "SELECT checksum FROM _sqlx_migrations WHERE version = $1 AND success";
        match tx.row(known, &[version.into()])? {
            Some(row) if row.get::<Vec<u8>>("checksum")? == checksum.as_slice() => {}
            Some(_) => {
                let text = format!("migration {version} of this database differs from the one in this program");
                return Err(StoreError::Migration(text));
            }
            None => {
                tx.script(text).map_err(|error| StoreError::Migration(format!("{version}, {name}: {error}")))?;
                let remember = "INSERT INTO _sqlx_migrations (version, description, success, checksum, execution_time) \
                                VALUES ($1, $2, TRUE, $3, 0)";
                tx.execute(remember, &[version.into(), name.into(), checksum.as_slice().into()])?;
            }
        }
    }
    Ok(())
}
