//! Reasons why bytes are not an object that can be used.

/// Reason why bytes are not an object that can be used.
#[derive(Clone, Debug, PartialEq, Eq, thiserror::Error)]
pub enum Defect {
    /// The JSON object around the bytes is not one of rhino3dm's `Encode`.
    #[error("is not an openNURBS object: {0}")]
    Envelope(String),
    /// The bytes end within a value, or a length leads beyond the end.
    #[error("is a damaged openNURBS object: its bytes end too early")]
    Truncated,
    /// A checksum differs from that of the bytes.
    #[error("is a damaged openNURBS object: a checksum does not match")]
    Checksum,
    /// The bytes have another structure than openNURBS writes.
    #[error("is a damaged openNURBS object: {0}")]
    Structure(&'static str),
    /// The class or its version is not one that can be read.
    #[error("{0}")]
    Unsupported(String),
    /// The object is valid but cannot be used.
    #[error("{0}")]
    Unusable(&'static str),
    /// The object has more points than the caller allows.
    #[error("has more than the {0} points that this server accepts")]
    TooLarge(usize),
}
