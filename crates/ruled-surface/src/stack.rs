//! A stack of directrices, in which every neighbouring pair bounds one strip: input, directions, points that move, the
//! welded mesh, warnings.

pub(crate) mod assemble;
pub(crate) mod caps;
pub(crate) mod direction;
pub(crate) mod estimate;
pub(crate) mod meetings;
pub(crate) mod moving;
pub(crate) mod options;
pub(crate) mod prepare;
pub(crate) mod sampling;
pub(crate) mod surface;
pub(crate) mod warnings;
