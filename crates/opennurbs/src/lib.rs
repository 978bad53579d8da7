//! Objects of openNURBS, the file format of Rhino: curves and meshes as one object each, without a file around them.
//! Hops, Rhino.Compute and rhino3dm exchange geometry in this form.
//!
//! An object is a chunk with the identifier of its class, the data of the class and an end mark. [`read`] takes
//! curves and meshes, and [`mod@write`] makes polyline curves and meshes. [`curve`] turns every curve into a polyline
//! within a tolerance.
//!
//! The layouts are those of openNURBS 8 for archives of version 60 (Rhino 6). Later versions read them too. They were
//! found in the sources of openNURBS and checked against rhino3dm by `scripts/check_hops.py`.

#![forbid(unsafe_code)]
#![cfg_attr(test, allow(clippy::disallowed_methods, clippy::disallowed_types, clippy::disallowed_macros))]

mod chunk;
pub mod curve;
mod defect;
pub mod read;
pub mod write;

use curve::Curve;
pub use defect::Defect;
use plateau_mesh::DVec3;

/// An object that was read.
#[derive(Clone, Debug, PartialEq)]
pub enum Object {
    Curve(Curve),
    Mesh(Mesh),
}

/// A mesh of triangles and quadrilaterals. The last two vertices of a triangle are equal.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Mesh {
    pub vertices: Vec<DVec3>,
    pub faces: Vec<[u32; 4]>,
}

/// Codes of chunks.
mod code {
    pub(super) const OBJECT: u32 = 0x0002_7ffa;
    pub(super) const CLASS_ID: u32 = 0x0002_fffb;
    pub(super) const CLASS_DATA: u32 = 0x0002_fffc;
    pub(super) const CLASS_END: u32 = 0x8002_7fff;
    pub(super) const ANONYMOUS: u32 = 0x4000_8000;
}

/// Identifiers of classes, in the byte order of the format.
mod class {
    /// Returns the identifier `4ED7D4xx-E947-11D3-BFE5-0010830122F0`, which most classes of geometry have.
    const fn geometry(last: u8) -> [u8; 16] {
        [last, 0xd4, 0xd7, 0x4e, 0x47, 0xe9, 0xd3, 0x11, 0xbf, 0xe5, 0x00, 0x10, 0x83, 0x01, 0x22, 0xf0]
    }

    pub(super) const LINE_CURVE: [u8; 16] = geometry(0xdb);
    pub(super) const NURBS_CURVE: [u8; 16] = geometry(0xdd);
    pub(super) const POLY_CURVE: [u8; 16] = geometry(0xe0);
    pub(super) const MESH: [u8; 16] = geometry(0xe4);
    pub(super) const POLYLINE_CURVE: [u8; 16] = geometry(0xe6);
    /// `CF33BE2A-09B4-11D4-BFFB-0010830122F0`.
    pub(super) const ARC_CURVE: [u8; 16] =
        [0x2a, 0xbe, 0x33, 0xcf, 0xb4, 0x09, 0xd4, 0x11, 0xbf, 0xfb, 0x00, 0x10, 0x83, 0x01, 0x22, 0xf0];

    /// First bytes and names of classes that cannot be read, for the text of an error.
    pub(super) const OTHERS: [([u8; 4], &str); 8] = [
        ([0xd8, 0xd4, 0xd7, 0x4e], "curve on a surface"),
        ([0xde, 0xd4, 0xd7, 0x4e], "surface"),
        ([0xc5, 0xdb, 0xb5, 0x60], "Brep"),
        ([0x75, 0x31, 0xf5, 0x36], "extrusion"),
        ([0xd9, 0xa4, 0x9b, 0xf0], "SubD"),
        ([0x1d, 0x1a, 0x10, 0xc3], "point"),
        ([0x47, 0xf3, 0x88, 0x24], "point cloud"),
        ([0xdf, 0x34, 0x47, 0x4c], "surface of revolution"),
    ];
}
