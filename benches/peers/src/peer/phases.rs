//! The phases of a build of ours, each through its public function, beside the same on bare arrays.

use super::floor::Faces;
use super::{Peer, least, timed};
use crate::heap;
use crate::mesh::{Mesh, mixed};
use crate::record::{CHECK, COPY, LINKS, PAIR, Run, Task};
use onering::{CheL1, FromFaces, Handle, Pairing, Slot, fans, pairing};

pub(super) const PHASES: &[Peer] =
    &[Peer { name: "phases of onering", run: ours }, Peer { name: "phases of a bare chain", run: bare }];

/// Pairing checks the faces once more, as it does in a build, where nothing else does.
fn ours(mesh: &Mesh) -> Result<Run, String> {
    let (vertex_count, faces) = (mesh.positions.len(), &mesh.faces[..]);
    let paired = CheL1::from_faces(vertex_count, faces).map_err(|error| error.to_string())?;
    let check = phase(CHECK, || pairing::check_faces(vertex_count, faces), |_| None)?;
    let pair = || pairing::pair(vertex_count, faces, Pairing::Auto);
    let (pair, growth) =
        heap::growth(|| phase(PAIR, pair, |paired| Some(sum(paired.opposite.iter().map(number)))));
    let links = || fans::fans(&paired);
    let links = phase(LINKS, links, |fans| Some(sum(fans.outgoing.as_slice().iter().map(number))))?;
    Ok(run(vec![copy(faces)?, check, pair?, links], mesh, growth.peak))
}

fn bare(mesh: &Mesh) -> Result<Run, String> {
    let faces = Faces::checked(mesh.positions.len(), &mesh.faces).ok_or("a vertex out of range")?;
    let answer = |numbers: &Vec<u32>| Some(sum(numbers.iter().copied()));
    let (pair, growth) = heap::growth(|| phase(PAIR, || Ok::<_, &str>(faces.chain()), answer));
    let opposite = faces.chain();
    let links = phase(LINKS, || faces.links(&opposite), answer)?;
    Ok(run(vec![copy(&mesh.faces)?, pair?, links], mesh, growth.peak))
}

/// Live are the opposites.
fn run(tasks: Vec<Task>, mesh: &Mesh, peak_bytes: usize) -> Run {
    Run { tasks, live_bytes: 12 * mesh.faces.len(), peak_bytes, elapsed: 0.0 }
}

fn copy(faces: &[[u32; 3]]) -> Result<Task, String> {
    phase(COPY, || Ok::<_, String>(faces.to_vec()), |_| None)
}

/// What is made is dropped after its time.
fn phase<T, E: ToString>(
    task: &str,
    work: impl Fn() -> Result<T, E>,
    answer: impl Fn(&T) -> Option<u64>,
) -> Result<Task, String> {
    let mut answered = Ok(None);
    let seconds = least(|| {
        let (made, seconds) = timed(&work);
        answered = made.map(|made| answer(&made));
        seconds
    });
    Ok(Task { task: task.into(), seconds, answer: answered.map_err(|error| error.to_string())? })
}

fn number(link: &Slot<impl Handle>) -> u32 {
    link.get().map_or(u32::MAX, |h| h.index() as u32)
}

/// Of a table, in its order.
fn sum(numbers: impl Iterator<Item = u32>) -> u64 {
    numbers.zip(0..).map(|(number, place)| mixed(place, number)).fold(0, u64::wrapping_add)
}
