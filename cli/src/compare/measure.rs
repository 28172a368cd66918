//! Builds one backend, takes the time of its answers, and keeps the answers.

use super::kernels::Kernels;
use super::question::Question;
use super::rings::Rings;
use super::sample::{Sample, Soup, strategies};
use crate::heap;
use crate::timing::{Clock, Timing};
use onering::{BuildError, Footprint, FromFaces, Pairing, Searched, SharedVertex};

/// What to measure on.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Plan<'a> {
    pub(crate) soup: &'a Soup,
    pub(crate) sample: &'a Sample,
    pub(crate) clock: Clock,
    pub(crate) depth: Depth<'a>,
}

/// How much to measure.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) enum Depth<'a> {
    /// All, building by the quadratic search only if this says so.
    All { with_quadratic: bool },
    /// Building as the library does it of its own accord, and the sweep.
    Sweep,
    /// Building as the library does it of its own accord, and these.
    Only(&'a [Question]),
}

/// What was measured. `None` is what the backend cannot answer.
#[derive(Clone, Debug, Default)]
pub(crate) struct Measured {
    /// Bytes on the heap, as the allocator counts.
    pub(crate) counted: usize,
    /// The most bytes on the heap while it was built, the list of faces not included.
    pub(crate) peak: usize,
    /// Bytes on the heap, as the backend says.
    pub(crate) told: Option<usize>,
    /// Words in records of vertices.
    pub(crate) vertex_record_words: usize,
    /// Vertices in faces that have none of their own, where there is such a thing.
    pub(crate) unmatched: usize,
    /// The strategy that the library takes of its own accord first; empty where the depth asks for none.
    pub(crate) build: Vec<(Pairing, Timing)>,
    pub(crate) rings: Option<Rings>,
    pub(crate) sweep: Option<Timing>,
    pub(crate) vertex_queries: Option<Timing>,
    pub(crate) face_queries: Option<Timing>,
    /// The questions of [`Depth::Only`] that it can answer.
    pub(crate) asked: Vec<(Question, Timing)>,
    /// Answers by name, to compare.
    pub(crate) answers: Vec<(&'static str, u64)>,
    /// Where vertices and faces have other numbers: what the list of faces says in those.
    pub(crate) expected: Option<Vec<(&'static str, u64)>>,
}

impl Depth<'_> {
    /// Whether the time of building is wanted.
    pub(crate) fn builds(self) -> bool {
        match self {
            Self::Only(questions) => questions.contains(&Question::Build),
            Self::All { .. } | Self::Sweep => true,
        }
    }
}

/// Whether a smaller mesh, or more memory, would do: nothing is wrong with this one.
pub(crate) fn is_too_large(refusal: &BuildError) -> bool {
    use BuildError::{OutOfMemory, TooManyHalfEdges, TooManyRecords, TooManyVertices};
    matches!(
        refusal,
        OutOfMemory { .. } | TooManyVertices { .. } | TooManyHalfEdges { .. } | TooManyRecords { .. }
    )
}

/// A backend of the registry.
pub(crate) fn backend<M: FromFaces + Footprint>(
    plan: &Plan<'_>,
    kernels: &Kernels<M>,
) -> Result<Measured, BuildError> {
    let Soup { vertex_count, ref faces, .. } = *plan.soup;
    let build = |pairing| M::build(vertex_count, faces.into(), pairing);
    let (mesh, growth) = heap::growth(|| build(Pairing::Auto));
    let mesh = mesh?;
    let mut measured = Measured { counted: growth.kept, peak: growth.peak, ..Measured::default() };
    measured.told = Some(mesh.heap_bytes());
    measured.vertex_record_words = kernels.vertex_record_words.map_or(0, |words| words(&mesh));
    let mut pairings: Vec<Pairing> = plan.depth.builds().then_some(Pairing::Auto).into_iter().collect();
    if let Depth::All { with_quadratic } = plan.depth {
        pairings.extend(strategies(with_quadratic).filter(|_| kernels.pairs()));
    }
    for pairing in pairings {
        let is_quadratic = pairing == Pairing::Quadratic;
        let clock = if is_quadratic { plan.clock.of_quadratic() } else { plan.clock };
        measured.build.push((pairing, clock.time(|| build(pairing))));
    }
    measured.ask(&mesh, kernels, plan)?;
    Ok(measured)
}

/// No structure at all. Queries are so slow that only one in a hundred is asked.
pub(crate) fn searched(plan: &Plan<'_>) -> Result<Measured, BuildError> {
    const RARELY: usize = 100;
    let few = |all: &[u32]| all.iter().step_by(RARELY).copied().collect();
    let Sample { starts, vertices, faces } = plan.sample;
    let sample = Sample { starts: starts.clone(), vertices: few(vertices), faces: few(faces) };
    let mesh = Searched::new(SharedVertex::from_faces(plan.soup.vertex_count, &plan.soup.faces)?);
    let mut kernels = Kernels::new().topology().adjacency().incidence();
    // As slow as the sweep, which tells as much.
    kernels.checks.retain(|&(name, _)| name != "star");
    let mut measured = Measured::default();
    measured.ask(&mesh, &kernels, &Plan { sample: &sample, clock: plan.clock.of_quadratic(), ..*plan })?;
    for timing in [&mut measured.vertex_queries, &mut measured.face_queries].into_iter().flatten() {
        *timing = timing.scaled(RARELY as f64);
    }
    measured.answers.retain(|(name, _)| !name.ends_with("queries"));
    Ok(measured)
}

impl Measured {
    /// Puts all questions, those that are timed first.
    pub(crate) fn ask<M>(
        &mut self,
        mesh: &M,
        kernels: &Kernels<M>,
        plan: &Plan<'_>,
    ) -> Result<(), BuildError> {
        // The scratch of rings, which is all that questions take by the size of the mesh.
        heap::has_room(8 * (plan.soup.vertex_count + 1))?;
        if let Depth::Only(questions) = plan.depth {
            let ask = |&question: &Question| Some((question, kernels.time(question, mesh, plan)?));
            self.asked = questions.iter().filter_map(ask).collect();
            return Ok(());
        }
        let Sample { starts, vertices, faces } = plan.sample;
        let (clock, mut answers) = (plan.clock, Vec::new());
        let mut timed = |name: &'static str, ask: &dyn Fn() -> u64| {
            let mut answer = 0;
            let timing = clock.time(|| {
                answer = ask();
                answer
            });
            answers.push((name, answer));
            timing
        };
        self.sweep = kernels.sweep.map(|sweep| timed("sweep", &|| sweep(mesh)));
        if plan.depth == Depth::Sweep {
            answers.retain(|_| plan.soup.is_clean);
            self.answers = answers;
            return Ok(());
        }
        self.vertex_queries =
            kernels.vertex_queries.map(|query| timed("vertex_queries", &|| query(mesh, vertices)));
        self.face_queries = kernels.face_queries.map(|query| timed("face_queries", &|| query(mesh, faces)));
        // A bare graph has no first fan to walk around: its neighbours are the one-ring only on manifolds.
        answers.retain(|&(name, _)| plan.soup.is_clean || name == "face_queries");
        self.rings = kernels.rings.map(|rings| rings(mesh, starts, &clock));
        answers.extend(self.rings.as_ref().map(|rings| ("rings", rings.checksum())));
        answers.extend(kernels.checks.iter().map(|&(name, check)| (name, check(mesh))));
        self.answers = answers;
        Ok(())
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn what_is_too_large_is_told_from_what_is_wrong() {
        let too_many = BuildError::TooManyVertices { vertices: 9, limit: 8 };
        assert!([BuildError::OutOfMemory { bytes: 1 }, too_many].iter().all(is_too_large));
        assert!(!is_too_large(&BuildError::DegenerateFace { face: 0, vertex: 1 }));
    }
}
