//! One mesh to compare on: as it is, and repaired for the backends that cannot hold that.

use super::orders::{self, Ordered};
use super::record::{self, Named};
use super::reference::{self, Sides};
use super::sample::{Sample, Soup};
use onering::defects::Defects;
use onering::footprint::Counts;
use onering::memory;
use onering::repair::{RepairError, RepairOptions, repair};

/// A list of triangles with all that is needed to measure on it.
#[derive(Debug)]
pub(crate) struct Ready {
    pub(crate) soup: Soup,
    pub(crate) sample: Sample,
    pub(crate) counts: Counts,
    /// The same triangles in other orders, where those are wanted.
    pub(crate) others: Vec<Ordered>,
    /// What every backend should answer, where that is wanted.
    pub(crate) answers: Vec<(&'static str, u64)>,
}

/// What to choose and to make.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Wanted {
    /// Of what is random.
    pub(crate) seed: u64,
    /// Whether answers are to be compared, and the triangles to be measured in other orders as well.
    pub(crate) comparison: bool,
}

/// A mesh in the one or two states that it is measured in.
#[derive(Debug)]
pub(crate) struct Case {
    pub(crate) name: String,
    pub(crate) as_it_is: Ready,
    pub(crate) defects: String,
    pub(crate) repaired: Option<(Ready, record::Repair)>,
}

impl Case {
    /// `faces` are not empty.
    pub(crate) fn of(
        name: String,
        positions: &[[f32; 3]],
        faces: Vec<[u32; 3]>,
        wanted: Wanted,
    ) -> Result<Self, RepairError> {
        let vertex_count = positions.len();
        let defects = Defects::of(vertex_count, &faces)?;
        let is_clean = defects.is_clean();
        let soup = Soup { vertex_count, faces, is_clean };
        let repaired = if is_clean { None } else { repaired(&soup, positions, wanted)? };
        let as_it_is = Ready::of(soup, positions, wanted)?;
        Ok(Self { name, as_it_is, defects: defects.to_string(), repaired })
    }
}

/// `None` where no face is left.
fn repaired(
    soup: &Soup,
    positions: &[[f32; 3]],
    wanted: Wanted,
) -> Result<Option<(Ready, record::Repair)>, RepairError> {
    let mended = repair(soup.vertex_count, &soup.faces, &RepairOptions::default())?;
    if mended.faces.is_empty() {
        return Ok(None);
    }
    let steps = mended.to_string();
    let positions = memory::collected(mended.vertex_source.iter().map(|&v| positions[v as usize]))?;
    let soup = Soup { vertex_count: mended.vertex_count, faces: mended.faces, is_clean: true };
    let ready = Ready::of(soup, &positions, wanted)?;
    let repair = record::Repair {
        steps,
        vertices: ready.soup.vertex_count,
        triangles: ready.soup.faces.len(),
        edges: ready.counts.edges,
        auto_pairing: ready.choices(),
        random_vertices: ready.sample.starts.clone(),
    };
    Ok(Some((ready, repair)))
}

impl Ready {
    fn of(soup: Soup, positions: &[[f32; 3]], wanted: Wanted) -> Result<Self, RepairError> {
        let sides = Sides::of(&soup.faces)?;
        let counts = reference::counts(&soup, &sides)?;
        let answers = if wanted.comparison { sides.answers(&soup.faces) } else { Vec::new() };
        // They take more than the mesh.
        drop(sides);
        let sample = Sample::of(&soup, wanted.seed);
        let others = if wanted.comparison { orders::of(&soup, positions, wanted.seed)? } else { Vec::new() };
        Ok(Self { soup, sample, counts, others, answers })
    }

    /// How half-edges are paired where nobody chooses, by order.
    pub(crate) fn choices(&self) -> Named<String> {
        Named(orders::choices(&self.soup, &self.others))
    }
}
