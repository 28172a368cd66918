//! Pairs half-edges with their opposites: the one construction step shared by all backends.
//!
//! Every strategy finds, for each half-edge, the *root* of its edge: the first half-edge in the list along the
//! same two vertices. All else follows from that, so all give the same result on every input.
mod chain;
mod check;
mod corners;
mod deal;
mod doubts;
mod hash;
mod joiner;
mod paper_hash;
mod partition;
mod quadratic;
mod sides;

use crate::{
    BuildError, HalfEdgeId, Slot,
    memory::{self, Spare},
};
use alloc::vec::Vec;
use core::fmt;

pub use check::{check_counts, check_faces, check_vertices};
pub use joiner::EdgeRecords;

/// How to find the half-edges that lie along the same edge.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, Hash)]
#[non_exhaustive]
pub enum Pairing {
    /// Looks at the input and takes the fastest for it: see [`Pairing::choose`].
    #[default]
    Auto,
    /// Compares each half-edge with all before it: "without hash" of Biscaro et al. (2016), Tables 3 and 4. O(n^2).
    Quadratic,
    /// The hash table of Biscaro et al. (2016), Eq. (7): `(10 v1 + v2) mod 3n` with chained entries. O(n) where the
    /// hash spreads, O(n^2) where it does not.
    PaperHash,
    /// A hash map from edge to half-edge (hashbrown with FxHash). O(n) expected, but not for chosen input.
    Hash,
    /// Lists of edges for each lower vertex, linked through the table of opposites itself. The fastest on a mesh where
    /// faces that are near in the mesh are near in the list. Goes over to `Partition` where lists get long, so it is never
    /// worse than that by more than a constant.
    Chain,
    /// Half-edges dealt into parts of the size of the cache by a vertex of theirs, and sorted there. O(n log(largest
    /// degree)), whatever the input; the fastest on a shuffled mesh.
    Partition,
}

impl Pairing {
    /// Every strategy there is, but for `Auto`.
    pub const ALL: [Pairing; 5] =
        [Self::Quadratic, Self::PaperHash, Self::Hash, Self::Partition, Self::Chain];

    /// The strategy that `Auto` takes for this input, by its counts and a sample of its faces. O(1).
    pub fn choose(vertex_count: usize, faces: &[[u32; 3]]) -> Pairing {
        // A table over the vertices would be larger than all else.
        let is_sparse = vertex_count > 3 * faces.len();
        if is_sparse || is_shuffled(faces) { Self::Partition } else { Self::Chain }
    }
}

impl fmt::Display for Pairing {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.write_str(match self {
            Self::Auto => "auto",
            Self::Quadratic => "quadratic",
            Self::PaperHash => "paper-hash",
            Self::Hash => "hash",
            Self::Chain => "chain",
            Self::Partition => "partition",
        })
    }
}

/// Whether consecutive faces are far apart, by a sample of them: most have fewer than two corners with near numbers.
/// One is not enough: around a vertex of huge degree every face has it.
fn is_shuffled(faces: &[[u32; 3]]) -> bool {
    const SAMPLES: usize = 256;
    const FAR: u32 = 1 << 10;
    let is_near = |pair: &&[[u32; 3]]| {
        pair[0].iter().filter(|u| pair[1].iter().any(|v| u.abs_diff(*v) < FAR)).count() >= 2
    };
    // Odd: a divided mesh has its faces in fours, and a step of whole fours would see the same one of each.
    let step = (faces.len() / SAMPLES) | 1;
    let sample = || faces.windows(2).step_by(step);
    sample().filter(is_near).count() < sample().count() / 2
}

/// Half-edges with their opposites, and the edges where there is no such thing.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Paired {
    /// For each half-edge `3f + k` of face `f`: the one that runs the other way along the same edge, where the
    /// edge has exactly two and they run in opposite directions.
    pub opposite: Vec<Slot<HalfEdgeId>>,
    /// The edges of three or more half-edges, or of two that run in the same direction.
    pub irregular: EdgeRecords,
    /// The strategy that found them: what `Auto` chose, and `Partition` where `Chain` gave up.
    pub taken: Pairing,
}

/// Pairs the half-edges of `faces`. Beyond the result, on a mesh without irregular edges, `Chain` takes 12 bytes a
/// vertex, `Partition` 30 a face (half of that above some 7 million) and some 12 more for each half-edge of the largest
/// part, `PaperHash` 24 a face, `Hash` some 40 to 80 a face, and `Quadratic` nothing. `Auto` is one of the first two.
///
/// # Errors
/// [`BuildError::VertexOutOfRange`] or [`BuildError::DegenerateFace`] for the lowest such face; more vertices or
/// half-edges than handles can name; [`BuildError::OutOfMemory`].
pub fn pair(vertex_count: usize, faces: &[[u32; 3]], pairing: Pairing) -> Result<Paired, BuildError> {
    check_counts(vertex_count, faces.len(), u32::MAX as usize - 1)?;
    pair_into(vertex_count, faces, pairing, memory::zeroed(3 * faces.len())?, &mut Spare::default())
}

/// The same into a table that there is: it becomes [`Paired::opposite`], of whatever length it was and whatever it held.
/// Scratch is taken from `spare` where it has some, and that of `Chain` is given back.
///
/// # Errors
/// As for [`pair`].
pub fn pair_into(
    vertex_count: usize,
    faces: &[[u32; 3]],
    pairing: Pairing,
    table: Vec<Slot<HalfEdgeId>>,
    spare: &mut Spare,
) -> Result<Paired, BuildError> {
    Ok(pair_as(vertex_count, faces, pairing, table, false, spare)?.0)
}

/// For each vertex the start of its fan, as [`Fans::outgoing`](crate::fans::Fans::outgoing) has it; nothing where they are
/// still to be looked for.
pub type Starts = Option<Vec<Slot<HalfEdgeId>>>;

/// As [`pair_into`], and the starts of fans, where pairing finds them by the way: `Partition`, where no edge is irregular and
/// no vertex has several fans. They are in a table of `spare`. `Partition` then takes 42 bytes a face (half of that above
/// some 5 million) and some 12 for each corner of the largest part, with 28 more for each around a vertex of more than 32
/// faces.
///
/// # Errors
/// As for [`pair`].
pub fn pair_with_starts(
    vertex_count: usize,
    faces: &[[u32; 3]],
    pairing: Pairing,
    table: Vec<Slot<HalfEdgeId>>,
    spare: &mut Spare,
) -> Result<(Paired, Starts), BuildError> {
    pair_as(vertex_count, faces, pairing, table, true, spare)
}

fn pair_as(
    vertex_count: usize,
    faces: &[[u32; 3]],
    pairing: Pairing,
    mut table: Vec<Slot<HalfEdgeId>>,
    wants_starts: bool,
    spare: &mut Spare,
) -> Result<(Paired, Starts), BuildError> {
    check_counts(vertex_count, faces.len(), u32::MAX as usize - 1)?;
    memory::resize(&mut table, 3 * faces.len(), Slot::NONE)?;
    check_faces(vertex_count, faces)?;
    let chosen = if pairing == Pairing::Auto { Pairing::choose(vertex_count, faces) } else { pairing };
    let paired = match chosen {
        Pairing::Chain => return chain::pair(vertex_count, faces, table, wants_starts, spare),
        Pairing::Partition | Pairing::Auto => {
            return partition::pair(vertex_count, faces, table, wants_starts, spare);
        }
        Pairing::Quadratic => quadratic::pair(faces, table),
        Pairing::PaperHash => paper_hash::pair(faces, table),
        Pairing::Hash => hash::pair(faces, table),
    };
    Ok((paired?, None))
}

impl Paired {
    /// The opposites, for a backend that holds no irregular edge.
    ///
    /// # Errors
    /// [`BuildError::NonManifoldEdge`] or [`BuildError::SameDirection`], for the first face that is at fault.
    pub fn refuse_irregular(self, faces: &[[u32; 3]]) -> Result<Vec<Slot<HalfEdgeId>>, BuildError> {
        match self.irregular.first_error(faces, false) {
            Some(error) => Err(error),
            None => Ok(self.opposite),
        }
    }

    /// This, for a backend that holds two faces that run along an edge in the same direction, but no edge of
    /// three or more.
    ///
    /// # Errors
    /// [`BuildError::NonManifoldEdge`], for the first face that is at fault.
    pub fn refuse_non_manifold(self, faces: &[[u32; 3]]) -> Result<Self, BuildError> {
        match self.irregular.first_error(faces, true) {
            Some(error) => Err(error),
            None => Ok(self),
        }
    }
}
