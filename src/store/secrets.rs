//! Random bytes that all processes on one database share.

use super::Result;
use super::tx::Tx;

/// Returns the bytes of this name, if any process has stored some.
pub(super) fn find(tx: &mut Tx<'_>, name: &str) -> Result<Option<Vec<u8>>> {
    let row = tx.row("SELECT value FROM secrets WHERE name = $1", &[name.into()])?;
    row.map(|row| row.get("value")).transpose()
}

/// Stores the bytes unless another process was first, and returns those that are stored.
pub(super) fn keep(tx: &mut Tx<'_>, name: &str, fresh: &[u8]) -> Result<Vec<u8>> {
    let text = "INSERT INTO secrets (name, value) VALUES ($1, $2) ON CONFLICT DO NOTHING";
    tx.execute(text, &[name.into(), fresh.into()])?;
    tx.one("SELECT value FROM secrets WHERE name = $1", &[name.into()])?.get("value")
}
