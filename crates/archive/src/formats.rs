//! Files that are made from a stored result. Each file of this folder writes one format.
//!
//! | format | axes and unit | numbers |
//! | --- | --- | --- |
//! | [`gltf`] (GLB, glTF JSON) | Y up, metres | f32 around an f64 origin |
//! | [`obj`], [`ply`] | the client's | f64, every digit |
//! | [`json`] | the client's | f64, every digit |
//! | [`stl`] | the client's | f32, around the mesh's middle if it is far from zero |
//!
//! `picture` draws a mesh as a small PNG, if the feature `pictures` is on.

mod choices;
pub mod colors;
mod error;
pub mod gltf;
pub mod json;
pub mod obj;
#[cfg(feature = "pictures")]
pub mod picture;
pub mod ply;
mod sheets;
pub mod stl;

pub use choices::{Choices, Origin};
pub use colors::{Colors, Quantity};
pub use error::Error;

use crate::archive::Archive;

/// Format in which a mesh can be downloaded.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub enum MeshFormat {
    Glb,
    Gltf,
    Obj,
    Ply,
    Stl,
    Json,
}

impl MeshFormat {
    pub const ALL: [Self; 6] = [Self::Glb, Self::Gltf, Self::Obj, Self::Ply, Self::Stl, Self::Json];

    /// Returns the short name, which is also the file's extension.
    #[must_use]
    pub fn name(self) -> &'static str {
        match self {
            Self::Glb => "glb",
            Self::Gltf => "gltf",
            Self::Obj => "obj",
            Self::Ply => "ply",
            Self::Stl => "stl",
            Self::Json => "json",
        }
    }

    #[must_use]
    pub fn media_type(self) -> &'static str {
        match self {
            Self::Glb => "model/gltf-binary",
            Self::Gltf => "model/gltf+json",
            Self::Obj => "model/obj",
            Self::Ply => "application/x-ply",
            Self::Stl => "model/stl",
            Self::Json => "application/vnd.plateau.mesh+json",
        }
    }

    #[must_use]
    pub fn from_name(name: &str) -> Option<Self> {
        Self::ALL.into_iter().find(|format| format.name() == name)
    }

    /// Returns true if files of this format have the lines along a mesh with triangles.
    #[must_use]
    pub fn has_lines(self) -> bool {
        !matches!(self, Self::Ply | Self::Stl)
    }

    /// Returns true if files of this format can have colours.
    #[must_use]
    pub fn has_colors(self) -> bool {
        matches!(self, Self::Glb | Self::Gltf | Self::Ply)
    }

    /// Writes the mesh in this format with the default choices.
    ///
    /// # Errors
    /// Returns the errors of [`MeshFormat::encode_with`].
    pub fn encode(self, archive: &Archive) -> Result<Vec<u8>, Error> {
        self.encode_with(archive, Choices::default())
    }

    /// Writes the mesh in this format. Time and memory are linear in the mesh's size.
    ///
    /// # Errors
    /// Returns [`Error`] if the format cannot hold this mesh (a coordinate exceeds f32, or the file exceeds the
    /// format's 4 GiB), or if the mesh lacks the quantity by which it is to be coloured.
    pub fn encode_with(self, archive: &Archive, choices: Choices) -> Result<Vec<u8>, Error> {
        match self {
            Self::Glb => gltf::to_glb(archive, choices),
            Self::Gltf => gltf::to_gltf_json(archive, choices),
            Self::Obj => Ok(obj::to_obj(archive, choices)),
            Self::Ply => ply::to_ply(archive, choices),
            Self::Stl => stl::to_stl(archive, choices),
            Self::Json => json::to_json(archive, choices),
        }
    }
}
