//! Flips edges one after the other until a condition holds for no edge.

use super::passes::Connected;
use crate::topology::{next, previous};
use crate::{Execution, Interruption};

/// Largest number of flips of one call, as a multiple of the number of edges. On curved surfaces flips can undo each
/// other, and flips that lower an energy can be many.
const FLIPS_PER_EDGE: usize = 10;
/// Number of visited edges between two calls of [`Execution::look`]. Visiting them takes about 20 ms.
const LOOK_EVERY: u64 = 100_000;

/// Flips edges for which `wants` holds, until there are none or the largest number of flips is reached. Returns the
/// number of flips.
///
/// All edges are visited once, and afterwards only those around a flipped edge.
///
/// # Errors
/// The interruption. The film is valid in that case too.
pub fn flip_where<M: Connected>(
    mesh: &mut M,
    wants: impl Fn(&M, u32) -> bool,
    exec: &Execution,
) -> Result<u64, Interruption> {
    let count = mesh.topology().twin.len() as u32;
    let mut queue: Vec<u32> = (0..count).rev().filter(|&h| mesh.topology().twin[h as usize] > h).collect();
    let mut queued = vec![false; count as usize];
    queue.iter().for_each(|&h| queued[h as usize] = true);
    let limit = (FLIPS_PER_EDGE * queue.len()) as u64;
    let (mut flips, mut visited) = (0, 0);
    while let Some(h) = queue.pop() {
        queued[h as usize] = false;
        visited += 1;
        if visited % LOOK_EVERY == 0 {
            exec.look(LOOK_EVERY)?;
        }
        if flips >= limit {
            break;
        }
        if !wants(mesh, h) || !mesh.topology().can_flip(h) {
            continue;
        }
        let topology = mesh.topology_mut();
        topology.flip(h);
        flips += 1;
        let twin = topology.twin[h as usize];
        for around in [next(h), previous(h), next(twin), previous(twin)] {
            let edge = around.min(topology.twin[around as usize]);
            if !queued[edge as usize] {
                queued[edge as usize] = true;
                queue.push(edge);
            }
        }
    }
    Ok(flips)
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::Signal;
    use crate::structured::shaken;

    #[test]
    fn flips_that_undo_each_other_end_at_the_limit() {
        let mut film = shaken(12, 0.0);
        let edges = film.topology.twin.iter().enumerate().filter(|&(h, &twin)| twin as usize > h).count();
        let flips = flip_where(&mut film, |_, _| true, &Execution::default()).unwrap();
        assert_eq!(flips, (FLIPS_PER_EDGE * edges) as u64);
        film.mesh().check().unwrap();
    }

    #[test]
    fn flips_look_at_the_signal() {
        let mut film = shaken(100, 0.0);
        for (signal, interruption) in
            [(Signal::Cancel, Interruption::Cancelled), (Signal::Deadline, Interruption::DeadlinePassed)]
        {
            let asked = || signal;
            let exec = Execution::new(&asked, &|_| {});
            assert_eq!(flip_where(&mut film, |_, _| true, &exec), Err(interruption));
            film.mesh().check().unwrap();
        }
    }
}
