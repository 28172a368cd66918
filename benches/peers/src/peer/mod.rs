//! The structures compared, each used as its documentation advises, at its fastest public way: one file a library.

#[cfg(feature = "alum")]
mod alum;
#[cfg(feature = "baby_shark")]
mod baby_shark;
#[cfg(feature = "halfedge")]
mod halfedge;
#[cfg(feature = "lox")]
mod lox;
mod onering;
#[cfg(feature = "parry3d")]
mod parry;
#[cfg(feature = "tri-mesh")]
mod tri_mesh;

use crate::heap;
use crate::mesh::Mesh;
use rustix::time::{ClockId, clock_gettime};
use serde::{Deserialize, Serialize};
use std::hint::black_box;

/// A library's structure, as far as it is compared.
trait Structure: Sized {
    /// The arrays as the library wants them, where it wants types of its own: not timed.
    type Input<'a>: From<&'a Mesh>;

    /// The structure, or why the library refuses.
    fn build(input: Self::Input<'_>) -> Result<Self, String>;

    /// The sum of [`ring_sum`](crate::mesh::ring_sum) over all vertices, where rings can be walked.
    fn sweep(&self) -> Option<u64>;
}

/// What one process tells of one structure.
#[derive(Clone, Copy, Debug, Deserialize, Serialize)]
pub(crate) struct Run {
    pub(crate) build_seconds: f64,
    pub(crate) sweep_seconds: Option<f64>,
    pub(crate) checksum: Option<u64>,
    pub(crate) live_bytes: usize,
    pub(crate) peak_bytes: usize,
}

/// A structure by name.
pub(crate) struct Peer {
    pub(crate) name: &'static str,
    pub(crate) run: fn(&Mesh) -> Result<Run, String>,
}

const fn peer<S: Structure>(name: &'static str) -> Peer {
    Peer { name, run: run::<S> }
}

/// All that are compiled in: onering's registry, then the others.
pub(crate) fn peers() -> impl Iterator<Item = &'static Peer> {
    onering::BACKENDS.iter().chain(OTHERS)
}

const OTHERS: &[Peer] = &[
    #[cfg(feature = "lox")]
    peer::<lox::NoRings<lox::SharedVertexMesh>>("lox shared vertex"),
    #[cfg(feature = "lox")]
    peer::<lox::Rings<lox::DirectedEdgeMesh>>("lox directed edge"),
    #[cfg(feature = "lox")]
    peer::<lox::Rings<lox::HalfEdgeMesh<lox::TriConfig>>>("lox half-edge"),
    #[cfg(feature = "alum")]
    peer::<alum::Mesh>("alum"),
    #[cfg(feature = "parry3d")]
    peer::<parry::Topology>("parry3d topology"),
    #[cfg(feature = "tri-mesh")]
    peer::<tri_mesh::Mesh>("tri-mesh"),
    #[cfg(feature = "baby_shark")]
    peer::<baby_shark::Mesh>("baby_shark"),
    #[cfg(feature = "halfedge")]
    peer::<halfedge::Mesh>("halfedge"),
];

/// Runs longer than this are not repeated: cold caches and page tables are lost in them.
const LONG: f64 = 1.0;

fn run<S: Structure>(mesh: &Mesh) -> Result<Run, String> {
    let first = once::<S>(mesh)?;
    if first.build_seconds + first.sweep_seconds.unwrap_or(0.0) > LONG { Ok(first) } else { once::<S>(mesh) }
}

fn once<S: Structure>(mesh: &Mesh) -> Result<Run, String> {
    let input: S::Input<'_> = mesh.into();
    let start = seconds();
    let (built, growth) = heap::growth(|| S::build(input));
    let build_seconds = seconds() - start;
    let structure = black_box(built?);
    let first = structure.sweep();
    let start = seconds();
    let checksum = black_box(&structure).sweep();
    let sweep_seconds = checksum.map(|_| seconds() - start);
    if checksum != first {
        return Err("two sweeps found different rings".into());
    }
    Ok(Run { build_seconds, sweep_seconds, checksum, live_bytes: growth.kept, peak_bytes: growth.peak })
}

/// Processor time of all threads of this process: others on the machine disturb it less than the clock.
fn seconds() -> f64 {
    let time = clock_gettime(ClockId::ProcessCPUTime);
    time.tv_sec as f64 + time.tv_nsec as f64 * 1e-9
}
