//! Meshes that are made here, with positions: what commands work on where no file is named.

pub(crate) mod organ;
mod roof;
mod terrain;

use onering_io::Triangles;

/// A mesh that is made when it is needed.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Made {
    pub(crate) name: &'static str,
    pub(crate) mesh: fn() -> Triangles,
}

pub(crate) const ORGAN: Made = Made { name: "an organ (made here)", mesh: organ::mesh };
pub(crate) const ROOF: Made = Made { name: "roof of a cave (made here)", mesh: roof::mesh };
pub(crate) const TERRAIN: Made = Made { name: "hills and hollows (made here)", mesh: terrain::mesh };
