//! The faces that the figures are about: those that name vertices of the mesh, three different ones.

use crate::{BuildError, FaceId, Handle, VertexId, memory};
use alloc::vec::Vec;
use core::ops::Range;

/// The most faces that a list may have, so that every half-edge has a `u32` number and one is left for "none".
pub const MAX_FACES: usize = (u32::MAX as usize - 1) / 3;

/// The proper triangles of a face list; what was left out is named.
pub(crate) struct Triangles {
    pub(crate) out_of_range: Vec<u32>,
    pub(crate) degenerate: Vec<u32>,
    /// Which face of the list each triangle is.
    pub(crate) source: Vec<u32>,
    /// The triangles, over vertex slots: `0..vertex_bound`.
    pub(crate) faces: Vec<[u32; 3]>,
    /// Arrays over the vertices need this length only; O(faces).
    pub(crate) vertex_bound: usize,
    /// The vertex of each slot, rising; `None` where a slot is a vertex.
    names: Option<Vec<u32>>,
}

impl Triangles {
    /// Sifts the list. O(faces), and O(faces log faces) where the vertex numbers are far above what so many
    /// faces can use; never O(vertex_count).
    pub(crate) fn sift(vertex_count: usize, faces: &[[u32; 3]]) -> Result<Self, BuildError> {
        let mut sifted = Self::empty(faces.len())?;
        for (f, face) in (0..).zip(faces) {
            let [a, b, c] = *face;
            if face.iter().any(|&v| v as usize >= vertex_count) {
                memory::push(&mut sifted.out_of_range, f)?;
            } else if a == b || b == c || c == a {
                memory::push(&mut sifted.degenerate, f)?;
            } else {
                sifted.source.push(f);
                sifted.faces.push(*face);
            }
        }
        sifted.compact()?;
        Ok(sifted)
    }

    fn empty(faces: usize) -> Result<Self, BuildError> {
        Ok(Self {
            out_of_range: Vec::new(),
            degenerate: Vec::new(),
            source: memory::with_room(faces)?,
            faces: memory::with_room(faces)?,
            vertex_bound: 0,
            names: None,
        })
    }

    /// Numbers the used vertices anew where arrays up to the greatest one would be out of proportion.
    fn compact(&mut self) -> Result<(), BuildError> {
        let corners = self.faces.as_flattened_mut();
        self.vertex_bound = corners.iter().max().map_or(0, |&v| v as usize + 1);
        if self.vertex_bound <= 2 * corners.len() {
            return Ok(());
        }
        let mut names = memory::collected(corners.iter().copied())?;
        names.sort_unstable();
        names.dedup();
        for v in corners {
            // Every corner is in the list that was made of the corners.
            *v = names.binary_search(v).unwrap_or_default() as u32;
        }
        self.vertex_bound = names.len();
        self.names = Some(names);
        Ok(())
    }

    /// Keeps the triangles that are not in `gone` (rising triangle numbers), in order.
    pub(crate) fn without(mut self, gone: &[FaceId]) -> Self {
        let mut gone = gone.iter().peekable();
        let mut kept = 0;
        for t in 0..self.faces.len() {
            if gone.next_if(|&&g| g.index() == t).is_none() {
                self.source[kept] = self.source[t];
                self.faces[kept] = self.faces[t];
                kept += 1;
            }
        }
        self.source.truncate(kept);
        self.faces.truncate(kept);
        self
    }

    /// The vertex that a slot stands for.
    pub(crate) fn vertex(&self, slot: VertexId) -> u32 {
        self.names.as_ref().map_or(slot.index() as u32, |names| names[slot.index()])
    }

    /// The faces of the list that these triangles are.
    pub(crate) fn sources(&self, triangles: &[FaceId]) -> Result<Vec<u32>, BuildError> {
        memory::collected(triangles.iter().map(|t| self.source[t.index()]))
    }

    /// The runs of vertices in `0..vertex_count` that no triangle uses.
    pub(crate) fn unused(
        &self,
        vertex_count: usize,
        used: impl Fn(VertexId) -> bool,
    ) -> Result<Vec<Range<usize>>, BuildError> {
        let mut runs = Vec::new();
        let mut next = 0;
        for slot in (0..self.vertex_bound).map(VertexId::new).filter(|&slot| used(slot)) {
            let v = self.vertex(slot) as usize;
            if next < v {
                memory::push(&mut runs, next..v)?;
            }
            next = v + 1;
        }
        if next < vertex_count {
            memory::push(&mut runs, next..vertex_count)?;
        }
        Ok(runs)
    }
}
