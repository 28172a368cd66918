//! What a program may ask of its mesh, by a word at the shell: the traits that answer, and the kernel that is timed.

use super::kernels::Kernels;
use super::measure::Plan;
use super::rings::LEVELS;
use super::sample::{QUERIES, STARTS, Soup};
use crate::timing::Timing;
use clap::ValueEnum;

/// One kind of question.
#[derive(Clone, Copy, Debug, PartialEq, Eq, ValueEnum)]
pub(crate) enum Question {
    /// To build the structure: where meshes come and go
    Build,
    /// The vertices of every face
    Faces,
    /// The one-rings of random vertices
    Neighbours,
    /// The one-ring of every vertex
    Rings,
    /// All vertices within four edges of random vertices
    KRings,
    /// The faces around every vertex
    Stars,
    /// What lies across the edges of random faces
    Opposites,
    /// Which half-edges are on the boundary
    Boundaries,
    /// Names for edges, and each one once
    Edges,
    /// Names for boundary curves, and walks along them
    Curves,
}

impl Question {
    /// Its word at the shell.
    pub(crate) fn name(self) -> String {
        self.to_possible_value().map(|value| value.get_name().to_owned()).unwrap_or_default()
    }

    /// The traits of which one answers; none where every structure does.
    pub(crate) fn traits(self) -> &'static [&'static str] {
        match self {
            Self::Build => &[],
            Self::Faces => &["topology"],
            Self::Neighbours | Self::Rings | Self::KRings => &["incidence", "graph"],
            Self::Stars => &["incidence"],
            Self::Opposites | Self::Boundaries => &["adjacency"],
            Self::Edges => &["edge_map"],
            Self::Curves => &["boundaries"],
        }
    }

    /// What its time is told by: the nanoseconds to divide by, and the unit.
    pub(crate) fn unit(self, soup: &Soup) -> (f64, &'static str) {
        let [vertices, faces] = [soup.vertex_count, soup.faces.len()].map(|count| count as f64);
        match self {
            Self::Build | Self::Boundaries | Self::Edges | Self::Curves => (1e6, "ms"),
            Self::Faces => (faces, "ns/face"),
            Self::Rings | Self::Stars => (vertices, "ns/vertex"),
            Self::Neighbours => (QUERIES as f64, "ns/vertex"),
            Self::KRings => (1e3 * STARTS as f64, "us/ring"),
            Self::Opposites => (QUERIES as f64, "ns/face"),
        }
    }
}

impl<M> Kernels<M> {
    /// The time of one kind of question, on all that it is asked about; `None` for what the structure cannot answer, and
    /// for building, which asks nothing.
    pub(crate) fn time(&self, question: Question, mesh: &M, plan: &Plan<'_>) -> Option<Timing> {
        let (clock, sample) = (&plan.clock, plan.sample);
        let check = |name: &str| {
            // Where a word has two answers, the later is of the stronger trait.
            let (_, check) = self.checks.iter().rev().find(|(known, _)| *known == name)?;
            Some(clock.time(|| check(mesh)))
        };
        match question {
            Question::Build => None,
            Question::Faces => check("faces"),
            Question::Stars => check("star"),
            Question::Edges => check("edges"),
            Question::Boundaries | Question::Curves => check("boundary"),
            Question::Rings => self.sweep.map(|sweep| clock.time(|| sweep(mesh))),
            Question::KRings => {
                let rings = self.rings?(mesh, &sample.starts, clock);
                rings.timings.get(LEVELS - 1).copied()
            }
            Question::Neighbours => self.vertex_queries.map(|ask| clock.time(|| ask(mesh, &sample.vertices))),
            Question::Opposites => self.face_queries.map(|ask| clock.time(|| ask(mesh, &sample.faces))),
        }
    }
}
