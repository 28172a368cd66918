//! What keeps a mesh from being held by every backend, in words.

use super::Defects;
use core::fmt;

/// A kind of defect that some backend cannot hold, with how many there are.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
#[non_exhaustive]
pub enum Obstacle {
    /// Faces that name no vertex of the mesh.
    OutOfRangeFaces(usize),
    /// Faces that name a vertex twice.
    DegenerateFaces(usize),
    /// Edges of three or more faces.
    NonmanifoldEdges(usize),
    /// Edges whose two faces run the same way.
    InconsistentEdges(usize),
    /// Vertices of several fans.
    BowtieVertices(usize),
}

impl Obstacle {
    /// How many there are; at least one in what [`Defects::obstacles`] gives.
    pub fn count(self) -> usize {
        let (Self::OutOfRangeFaces(n)
        | Self::DegenerateFaces(n)
        | Self::NonmanifoldEdges(n)
        | Self::InconsistentEdges(n)
        | Self::BowtieVertices(n)) = self;
        n
    }
}

impl fmt::Display for Obstacle {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        let (kind, one, many) = match self {
            Self::OutOfRangeFaces(_) => ("out-of-range", "face", "faces"),
            Self::DegenerateFaces(_) => ("degenerate", "face", "faces"),
            Self::NonmanifoldEdges(_) => ("non-manifold", "edge", "edges"),
            Self::InconsistentEdges(_) => ("inconsistent", "edge", "edges"),
            Self::BowtieVertices(_) => ("bowtie", "vertex", "vertices"),
        };
        let noun = if self.count() == 1 { one } else { many };
        write!(f, "{} {kind} {noun}", self.count())
    }
}

impl Defects {
    /// Whether every backend accepts the mesh: no out-of-range and no degenerate face, every edge with at most
    /// two faces, in opposite directions, every vertex with at most one fan.
    ///
    /// Isolated vertices do no harm, nor do two copies of a face back to back: they are a closed surface.
    pub fn is_clean(&self) -> bool {
        self.obstacles().next().is_none()
    }

    /// What keeps some backend from accepting the mesh; nothing where it [is clean](Self::is_clean).
    pub fn obstacles(&self) -> impl Iterator<Item = Obstacle> + use<> {
        let all = [
            Obstacle::OutOfRangeFaces(self.out_of_range_faces),
            Obstacle::DegenerateFaces(self.degenerate_faces),
            Obstacle::NonmanifoldEdges(self.nonmanifold_edges),
            Obstacle::InconsistentEdges(self.inconsistent_edges),
            Obstacle::BowtieVertices(self.bowtie_vertices),
        ];
        all.into_iter().filter(|obstacle| obstacle.count() > 0)
    }
}

/// The verdict in one line: `clean: every backend accepts it`, or the obstacles.
impl fmt::Display for Defects {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        if self.is_clean() {
            return f.write_str("clean: every backend accepts it");
        }
        for (i, obstacle) in self.obstacles().enumerate() {
            write!(f, "{}{obstacle}", if i == 0 { "" } else { ", " })?;
        }
        Ok(())
    }
}
