//! Joins half-edges to the root of their edge, and keeps what does not pair.
use super::{Paired, Pairing};
use crate::{BuildError, HalfEdgeId, Handle, Slot, corner, memory};
use alloc::vec::Vec;

/// Half-edges of irregular edges: one record an edge.
#[derive(Clone, Debug, Default, PartialEq, Eq)]
pub struct EdgeRecords {
    half_edges: Vec<HalfEdgeId>,
    ends: Vec<u32>,
}

impl EdgeRecords {
    /// The records, by their first half-edge; each is ascending.
    pub fn iter(&self) -> impl Iterator<Item = &[HalfEdgeId]> + Clone {
        let starts = core::iter::once(0).chain(self.ends.iter().copied());
        starts.zip(&self.ends).map(|(start, &end)| &self.half_edges[start as usize..end as usize])
    }

    /// Number of records.
    pub fn len(&self) -> usize {
        self.ends.len()
    }

    /// Whether there is none.
    pub fn is_empty(&self) -> bool {
        self.ends.is_empty()
    }

    /// The error of the edge that went wrong at the lowest half-edge.
    pub(super) fn first_error(&self, faces: &[[u32; 3]], allow_two: bool) -> Option<BuildError> {
        let refused = self.iter().filter(|record| record.len() > 2 || !allow_two);
        // Two that run alike are at fault with the second; more than two are with the third, whichever way they run.
        let culprit = |record: &[HalfEdgeId]| record[if record.len() == 2 { 1 } else { 2 }];
        let record = refused.min_by_key(|record| culprit(record))?;
        let face = |h: HalfEdgeId| h.index() / 3;
        let h = record[0].index();
        let (a, b) = (corner::origin(faces, h), corner::target(faces, h));
        Some(if record.len() == 2 {
            BuildError::SameDirection { vertices: [a, b], faces: [face(record[0]), face(record[1])] }
        } else {
            let (vertices, face) = ([a.min(b), a.max(b)], face(culprit(record)));
            BuildError::NonManifoldEdge { vertices, faces: record.len(), face }
        })
    }
}

/// (root, half-edge) of what does not pair.
pub(super) type Extra = Vec<(HalfEdgeId, HalfEdgeId)>;

/// Collects what a strategy finds.
pub(super) struct Joiner<'a> {
    faces: &'a [[u32; 3]],
    opposite: Vec<Slot<HalfEdgeId>>,
    extra: Extra,
}

impl<'a> Joiner<'a> {
    /// Nothing is joined, whatever `table` held.
    pub(super) fn new(faces: &'a [[u32; 3]], mut table: Vec<Slot<HalfEdgeId>>) -> Self {
        table.fill(Slot::NONE);
        Self::with(faces, table)
    }

    /// For a strategy that has joined pairs by itself.
    pub(super) fn with(faces: &'a [[u32; 3]], opposite: Vec<Slot<HalfEdgeId>>) -> Self {
        Self { faces, opposite, extra: Vec::new() }
    }

    /// What `h` was joined to.
    pub(super) fn opposite(&self, h: HalfEdgeId) -> Option<HalfEdgeId> {
        self.opposite[h.index()].get()
    }

    /// Forgets what `h` was joined to.
    pub(super) fn part(&mut self, h: usize) {
        self.opposite[h] = Slot::NONE;
    }

    /// `h` lies along the same edge as `root`, the first half-edge there.
    #[inline]
    pub(super) fn join(&mut self, root: usize, h: usize) -> Result<(), BuildError> {
        let (r, s) = (HalfEdgeId::new(root), HalfEdgeId::new(h));
        let is_opposite = corner::origin(self.faces, root) != corner::origin(self.faces, h);
        if is_opposite && self.opposite[root].get().is_none() {
            self.pair(root, h);
            Ok(())
        } else {
            memory::push(&mut self.extra, (r, s))
        }
    }

    /// `h` is the first to run back along the edge of `root`.
    #[inline(always)]
    pub(super) fn pair(&mut self, root: usize, h: usize) {
        self.opposite[root] = Slot::some(HalfEdgeId::new(h));
        self.opposite[h] = Slot::some(HalfEdgeId::new(root));
    }

    /// Half-edges that lie along the edge of a root and do not pair, found by a strategy.
    pub(super) fn add(&mut self, extra: Extra) -> Result<(), BuildError> {
        if self.extra.is_empty() {
            self.extra = extra;
        } else {
            memory::reserve(&mut self.extra, extra.len())?;
            self.extra.extend(extra);
        }
        Ok(())
    }

    pub(super) fn finish(mut self, taken: Pairing) -> Result<Paired, BuildError> {
        self.extra.sort_unstable();
        let by_root = || self.extra.chunk_by(|a, b| a.0 == b.0);
        // Beside what did not pair, each record has its root, and perhaps a partner.
        let most = self.extra.len() + 2 * by_root().count();
        let mut irregular =
            EdgeRecords { half_edges: memory::with_room(most)?, ends: memory::with_room(by_root().count())? };
        for group in by_root() {
            let root = group[0].0;
            let start = irregular.half_edges.len();
            irregular.half_edges.push(root);
            // The pair that was joined before the edge turned out to have more.
            if let Some(partner) = self.opposite[root.index()].get() {
                self.opposite[root.index()] = Slot::NONE;
                self.opposite[partner.index()] = Slot::NONE;
                irregular.half_edges.push(partner);
            }
            irregular.half_edges.extend(group.iter().map(|&(_, h)| h));
            irregular.half_edges[start..].sort_unstable();
            irregular.ends.push(irregular.half_edges.len() as u32);
        }
        Ok(Paired { opposite: self.opposite, irregular, taken })
    }
}
