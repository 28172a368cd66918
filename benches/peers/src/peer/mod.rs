//! The structures compared, each used as its documentation advises, at its fastest public way: one file a library.

#[cfg(feature = "alum")]
mod alum;
#[cfg(feature = "baby_shark")]
mod baby_shark;
mod floor;
#[cfg(feature = "halfedge")]
mod halfedge;
#[cfg(feature = "lox")]
mod lox;
mod onering;
#[cfg(feature = "parry3d")]
mod parry;
mod phases;
#[cfg(feature = "tri-mesh")]
mod tri_mesh;
mod walk;

use crate::heap;
use crate::mesh::Mesh;
use crate::record::{BUILD, FOUR_RING, RING, Run, Task};
use rustix::time::{ClockId, clock_gettime};
use std::hint::black_box;
use walk::Walk;

/// A library's structure, as far as it is compared.
trait Structure: Sized {
    /// The arrays as the library wants them, where it wants types of its own: not timed.
    type Input<'a>: From<&'a Mesh>;

    /// The structure, or why the library refuses.
    fn build(input: Self::Input<'_>) -> Result<Self, String>;
}

/// A structure by name.
pub(crate) struct Peer {
    pub(crate) name: &'static str,
    pub(crate) run: fn(&Mesh) -> Result<Run, String>,
}

/// All that are compiled in: onering's registry, then the others, then the phases of a build.
pub(crate) fn peers() -> impl Iterator<Item = &'static Peer> {
    onering::BACKENDS.iter().chain(OTHERS).chain(phases::PHASES)
}

#[cfg(feature = "lox")]
const fn built<S: Structure>(name: &'static str) -> Peer {
    Peer { name, run: run::<S> }
}

#[allow(dead_code, reason = "without the features there is none")]
const fn walked<S: Walk>(name: &'static str) -> Peer {
    Peer { name, run: run_and_walk::<S> }
}

const OTHERS: &[Peer] = &[
    #[cfg(feature = "lox")]
    built::<lox::NoRings<lox::SharedVertexMesh>>("lox shared vertex"),
    #[cfg(feature = "lox")]
    walked::<lox::Rings<lox::DirectedEdgeMesh>>("lox directed edge"),
    #[cfg(feature = "lox")]
    walked::<lox::Rings<lox::HalfEdgeMesh<lox::TriConfig>>>("lox half-edge"),
    #[cfg(feature = "alum")]
    walked::<alum::Mesh>("alum"),
    #[cfg(feature = "parry3d")]
    walked::<parry::Topology>("parry3d topology"),
    #[cfg(feature = "tri-mesh")]
    walked::<tri_mesh::Mesh>("tri-mesh"),
    #[cfg(feature = "baby_shark")]
    walked::<baby_shark::Mesh>("baby_shark"),
    #[cfg(feature = "halfedge")]
    walked::<halfedge::Mesh>("halfedge"),
];

/// A task is repeated until it has run so often, or for so many seconds, and the least time counts: caches are cold at
/// first, and an allocator keeps memory for a second or third build that it gave back to the system after the first.
const RUNS: usize = 5;
const LONG: f64 = 1.0;

fn run<S: Structure>(mesh: &Mesh) -> Result<Run, String> {
    build::<S>(mesh).map(|(_, run)| run)
}

/// The same, then walks what was built.
fn run_and_walk<S: Walk>(mesh: &Mesh) -> Result<Run, String> {
    let (structure, mut run) = build::<S>(mesh)?;
    let structure = black_box(structure);
    run.tasks.push(warm(RING, || structure.sweep()));
    let vertices = structure.by_index(mesh.positions.len());
    run.tasks.push(warm(FOUR_RING, || structure.four_rings(&vertices, &mesh.queries)));
    Ok(run)
}

fn build<S: Structure>(mesh: &Mesh) -> Result<(S, Run), String> {
    let (mut built, mut growth) = (None, None);
    let seconds = least(|| {
        built = None; // its memory is free for the next one
        let input: S::Input<'_> = mesh.into();
        let ((structure, seconds), grown) = heap::growth(|| timed(|| S::build(input)));
        (built, growth) = (Some(structure), Some(grown));
        seconds
    });
    let (built, growth) = built.zip(growth).ok_or("nothing was built")?;
    let task = Task { task: BUILD.into(), seconds, answer: None };
    let run = Run { tasks: vec![task], live_bytes: growth.kept, peak_bytes: growth.peak, elapsed: 0.0 };
    Ok((black_box(built?), run))
}

fn warm(task: &str, run: impl Fn() -> u64) -> Task {
    let mut answer = None;
    let seconds = least(|| {
        let (found, seconds) = timed(&run);
        answer = Some(found);
        seconds
    });
    Task { task: task.into(), seconds, answer }
}

/// The least of the times that `run` gives.
fn least(mut run: impl FnMut() -> f64) -> f64 {
    let (mut least, mut all) = (f64::INFINITY, 0.0);
    for _ in 0..RUNS {
        let seconds = run();
        (least, all) = (least.min(seconds), all + seconds);
        if all > LONG {
            break;
        }
    }
    least
}

/// Processor time of all threads of this process: others on the machine disturb it less than the clock.
fn timed<T>(run: impl FnOnce() -> T) -> (T, f64) {
    let start = seconds();
    let result = black_box(run());
    (result, seconds() - start)
}

fn seconds() -> f64 {
    let time = clock_gettime(ClockId::ProcessCPUTime);
    time.tv_sec as f64 + time.tv_nsec as f64 * 1e-9
}
