//! Numbered scripts that create and update the tables of both engines.
//!
//! A migration only adds columns and tables, so that an older version keeps working on a database that a newer one has
//! migrated.

use sha2::{Digest, Sha256};

use super::tx::Tx;
use super::{Result, StoreError};

const MIGRATIONS: [(i64, &str, &str); 2] = [
    (1, "tables", include_str!("../../migrations/0001_tables.sql")),
    (2, "kept requests", include_str!("../../migrations/0002_kept_requests.sql")),
];

/// SQL that takes the advisory lock, so that only one process at a time migrates a PostgreSQL database.
const LOCK: &str = "SELECT pg_advisory_xact_lock(7019839175)";
const CREATE_TABLE: &str = "CREATE TABLE IF NOT EXISTS migrations (version BIGINT PRIMARY KEY NOT NULL, \
     name TEXT NOT NULL, checksum BYTEA NOT NULL, applied_at TIMESTAMP NOT NULL DEFAULT CURRENT_TIMESTAMP)";

/// Runs the migrations that the database lacks. The caller commits or rolls back all of them together.
pub(super) fn migrate(tx: &mut Tx<'_>) -> Result<()> {
    if tx.is_postgres() {
        tx.script(LOCK)?;
    }
    tx.script(CREATE_TABLE)?;
    for (version, name, text) in MIGRATIONS {
        let checksum = Sha256::digest(text);
        match tx.row("SELECT checksum FROM migrations WHERE version = $1", &[version.into()])? {
            Some(row) if row.get::<Vec<u8>>("checksum")? == checksum.as_slice() => {}
            Some(_) => {
                let text = format!("migration {version} of this database differs from the one in this program");
                return Err(StoreError::Migration(text));
            }
            None => {
                tx.script(text).map_err(|error| StoreError::Migration(format!("{version}, {name}: {error}")))?;
                let checksum = checksum.as_slice().into();
                tx.insert("migrations", &[("version", version.into()), ("name", name.into()), ("checksum", checksum)])?;
            }
        }
    }
    Ok(())
}
