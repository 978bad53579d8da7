//! Reasons why a mesh cannot be written in a format.

/// Reason why a mesh cannot be written in a format.
#[derive(Clone, Debug, PartialEq, Eq, thiserror::Error)]
pub enum Error {
    /// A coordinate is outside the range of f32 (STL, glTF), or the mesh is so small that its vertices coincide in f32.
    #[error("the mesh does not fit into {format}'s 32-bit coordinates: {detail}; OBJ and PLY hold every digit")]
    OutOfRange { format: &'static str, detail: &'static str },
    /// The values cannot be written, which valid archives never cause.
    #[error("the mesh cannot be written as {format}")]
    Unwritable { format: &'static str },
    /// The mesh has only lines, and files of this format have only triangles.
    #[error(
        "a {format} file has only triangles, and this result has only lines; GLB, glTF, OBJ, PLY and JSON have them"
    )]
    NoTriangles { format: &'static str },
    /// The file has no values of the quantity that it is to be coloured by.
    #[error("this file has no {asked} to be coloured by; it has {}", listed(offered))]
    NoQuantity { asked: &'static str, offered: Vec<&'static str> },
    /// The file would exceed the format's 32-bit lengths.
    #[error("this is more than the 4 GiB that a {format} file can hold")]
    TooLarge { format: &'static str },
}

fn listed(names: &[&str]) -> String {
    if names.is_empty() { "none of the quantities".into() } else { names.join(", ") }
}
