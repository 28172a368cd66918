//! Meshes that are made here, with positions: what commands work on where no file is named.

pub(crate) mod organ;
pub(crate) mod roof;
pub(crate) mod terrain;
