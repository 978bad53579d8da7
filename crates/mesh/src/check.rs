//! The check that every solver's mesh must pass. Tests run it after every operation.

use crate::Mesh;
use crate::topology::{Defect, NONE, Topology};

impl Mesh {
    /// Checks that the mesh is an oriented manifold (with or without boundary) with finite coordinates and without
    /// isolated vertices.
    ///
    /// The shape of the triangles is not checked: [`measure`](crate::measure) counts degenerate and flipped triangles.
    ///
    /// # Errors
    /// The first [`Defect`] found.
    pub fn check(&self) -> Result<Topology, Defect> {
        if let Some(vertex) = self.vertices.iter().position(|v| !v.is_finite()) {
            return Err(Defect::NotFinite { vertex: vertex as u32 });
        }
        let topology = Topology::build(&self.triangles, self.vertices.len())?;
        match topology.outgoing.iter().position(|&h| h == NONE) {
            Some(vertex) => Err(Defect::IsolatedVertex { vertex: vertex as u32 }),
            None => Ok(topology),
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::DVec3;

    #[test]
    fn isolated_vertices_and_infinite_ones_are_refused() {
        let corner = |x, y| DVec3::new(x, y, 0.0);
        let mut mesh = Mesh::new(vec![corner(0.0, 0.0), corner(1.0, 0.0), corner(0.0, 1.0)], vec![[0, 1, 2]]);
        assert!(mesh.check().is_ok());
        mesh.vertices.push(corner(5.0, 5.0));
        assert_eq!(mesh.check().unwrap_err(), Defect::IsolatedVertex { vertex: 3 });
        mesh.vertices[3].x = f64::NAN;
        assert_eq!(mesh.check().unwrap_err().to_string(), "vertex 3 has a coordinate that is not finite");
    }
}
