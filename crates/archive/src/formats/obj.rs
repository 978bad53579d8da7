//! Wavefront OBJ in the client's axes and unit. Every number reads back as exactly the same f64.

use std::io::Write as _;

use super::{Choices, Origin};
use crate::archive::{Archive, Lines};
use plateau_mesh::DVec3;

/// Writes the vertices in archive order (OBJ counts from 1), one object `surface` of triangles if there are any, and
/// one object per line set.
#[must_use]
pub fn to_obj(archive: &Archive, choices: Choices) -> Vec<u8> {
    let contents = archive.contents();
    let shift = choices.shift(contents);
    let mut out = Vec::with_capacity(64 * contents.mesh.vertices.len() + 24 * contents.mesh.triangles.len());
    // Writing to a Vec cannot fail, so `put` handles no errors.
    macro_rules! put {
        ($($argument:tt)*) => { writeln!(out, $($argument)*).expect("writing to memory") };
    }
    put!("# {}", one_line(&contents.generator));
    put!("# unit {}, {} up", contents.unit.symbol(), contents.up.symbol());
    if choices.origin == Origin::Local {
        put!("# origin {:?} {:?} {:?}", shift.x, shift.y, shift.z);
    }
    for vertex in contents.mesh.vertices.iter().map(|&vertex| vertex - shift) {
        // `{:?}` gives the shortest text that reads back as the same f64, with an exponent if that is shorter.
        put!("v {:?} {:?} {:?}", vertex.x, vertex.y, vertex.z);
    }
    if !contents.mesh.triangles.is_empty() {
        put!("o surface");
    }
    for [a, b, c] in contents.mesh.triangles.iter().map(|t| t.map(from_one)) {
        put!("f {a} {b} {c}");
    }
    let mut count = contents.mesh.vertices.len() as u64;
    for set in choices.line_sets(contents) {
        if let Lines::Arrows(ends) = &set.lines {
            // The ends of arrows are further vertices. They follow those of the mesh, which keep their numbers.
            for end in ends.iter().flatten() {
                let [x, y, z] = (DVec3::from_array(*end) - shift).to_array();
                put!("v {x:?} {y:?} {z:?}");
            }
        }
        put!("o {}", one_line(&set.full_name()));
        match &set.lines {
            Lines::Polylines(polylines) => {
                for line in polylines {
                    let back = line.closed.then(|| line.vertices[0]);
                    let indices = line.vertices.iter().copied().chain(back).map(|v| from_one(v).to_string());
                    put!("l {}", indices.collect::<Vec<_>>().join(" "));
                }
            }
            Lines::Segments(pairs) => {
                for [a, b] in pairs.iter().map(|pair| pair.map(from_one)) {
                    put!("l {a} {b}");
                }
            }
            Lines::Arrows(ends) => {
                for _ in ends {
                    put!("l {} {}", count + 1, count + 2);
                    count += 2;
                }
            }
        }
    }
    out
}

fn from_one(index: u32) -> u64 {
    u64::from(index) + 1
}

/// Replaces control characters, so that a comment or name stays on one line.
pub(super) fn one_line(text: &str) -> String {
    text.replace(|c: char| c.is_control(), " ")
}
