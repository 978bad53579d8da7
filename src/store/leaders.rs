//! Leases on periodic tasks. Of all processes that share the database, only the holder of a task's lease carries it
//! out.

use std::time::Duration;

use super::tx::Tx;
use super::{Result, milliseconds};

/// Takes or renews the lease on a task for the time `length`. Returns false if another process holds the lease. A lease
/// that ends later than `length` from now was taken by a clock that has since been set back, so it counts as free.
pub(super) fn take(tx: &mut Tx<'_>, task: &str, holder: &str, length: Duration) -> Result<bool> {
    let text = "INSERT INTO leaders (task, holder, held_until) VALUES ($1, $2, now_ms() + $3) \
                ON CONFLICT (task) DO UPDATE SET holder = excluded.holder, held_until = excluded.held_until \
                WHERE leaders.holder = excluded.holder OR leaders.held_until <= now_ms() \
                OR leaders.held_until > excluded.held_until";
    Ok(tx.execute(text, &[task.into(), holder.into(), milliseconds(length).into()])? > 0)
}

/// Gives up every task of a process.
pub(super) fn leave(tx: &mut Tx<'_>, holder: &str) -> Result<()> {
    tx.execute("DELETE FROM leaders WHERE holder = $1", &[holder.into()]).map(|_| ())
}
