//! One mesh of the corpus, and what is known of it.
use super::slow::{FaceList, Slow};
use crate::{BuildError, FromFaces};
use alloc::vec::Vec;

/// What can be wrong with a face list.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Flaw {
    /// A face names a vertex that does not exist. No backend holds that.
    OutOfRange,
    /// A face names one vertex more than once.
    Degenerate,
    /// Three or more half-edges lie along one edge.
    NonManifoldEdge,
    /// Two half-edges run along one edge in the same direction.
    SameDirection,
    /// The faces of a vertex form more than one fan.
    SeveralFans,
}

impl Flaw {
    /// Every flaw, in the order in which a face list is looked at.
    pub const ALL: [Flaw; 5] =
        [Self::OutOfRange, Self::Degenerate, Self::NonManifoldEdge, Self::SameDirection, Self::SeveralFans];

    /// The name of a flaw in the registry of backends, such as `several_fans`.
    pub fn name(self) -> &'static str {
        match self {
            Self::OutOfRange => "out_of_range",
            Self::Degenerate => "degenerate",
            Self::NonManifoldEdge => "non_manifold_edge",
            Self::SameDirection => "same_direction",
            Self::SeveralFans => "several_fans",
        }
    }

    /// The flaws with these names. Panics where there is none of that name.
    pub fn named(names: &[&str]) -> Vec<Flaw> {
        let named = |name| Self::ALL.into_iter().find(|flaw| flaw.name() == name);
        names.iter().map(|&name| named(name).unwrap_or_else(|| panic!("no flaw is called {name}"))).collect()
    }
}

/// A face list, with what was counted by hand.
#[derive(Clone, Debug)]
pub struct Case {
    /// For the message of a broken law.
    pub name: &'static str,
    /// Number of vertices.
    pub vertices: usize,
    /// Three vertices each.
    pub faces: Vec<[u32; 3]>,
    /// Number of undirected edges: of pairs of different vertices that are the ends of a side.
    pub edges: usize,
    /// Number of boundary curves; `None` where an irregular edge interrupts them.
    pub curves: Option<usize>,
    /// What is wrong, with the error of a backend that holds all before it in this list but not this.
    pub flaws: Vec<(Flaw, BuildError)>,
}

impl Case {
    /// A face list with nothing wrong but what is then added.
    pub(super) fn new(
        name: &'static str,
        vertices: usize,
        faces: &[[u32; 3]],
        edges: usize,
        curves: impl Into<Option<usize>>,
    ) -> Self {
        Self { name, vertices, faces: faces.into(), edges, curves: curves.into(), flaws: Vec::new() }
    }

    /// A face list whose elements are counted by slow search, for laws on meshes made at random. Its vertices have
    /// to be in range; what is wrong with it is left open.
    pub fn counted(name: &'static str, vertices: usize, faces: Vec<[u32; 3]>) -> Self {
        let slow = Slow::of(&FaceList { vertices, faces: &faces });
        let (edges, curves) = (slow.edges().len(), Some(slow.curve_count()));
        Self { name, vertices, faces, edges, curves, flaws: Vec::new() }
    }

    /// The error of a backend that holds no flaws but these.
    pub fn refusal(&self, holds: &[Flaw]) -> Option<&BuildError> {
        self.flaws.iter().find(|(flaw, _)| !holds.contains(flaw)).map(|(_, error)| error)
    }

    /// Adds a flaw that comes after those before it.
    pub(super) fn with(mut self, flaw: Flaw, error: BuildError) -> Self {
        self.flaws.push((flaw, error));
        self
    }
}

/// The mesh of `case`, or `None` where a backend that holds these flaws has to refuse it.
///
/// Panics where the backend decides otherwise, or gives another error than it should.
pub fn build<M: FromFaces>(case: &Case, holds: &[Flaw]) -> Option<M> {
    match (M::from_faces(case.vertices, &case.faces), case.refusal(holds)) {
        (Ok(mesh), None) => Some(mesh),
        (Err(error), Some(expected)) if error == *expected => None,
        (Ok(_), Some(expected)) => panic!("{}: accepted, where the error is: {expected}", case.name),
        (Err(error), expected) => panic!("{}: refused with {error:?}, expected {expected:?}", case.name),
    }
}
