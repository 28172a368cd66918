//! The faces that the figures are about: those that name vertices of the mesh, three different ones.

use alloc::vec::Vec;
use core::ops::Range;

/// The most faces that a list may have, so that every half-edge has a `u32` number and one is left for "none".
pub const MAX_FACES: usize = (u32::MAX as usize - 1) / 3;

/// The proper triangles of a face list, as corners; what was left out is named.
pub(crate) struct Triangles {
    pub(crate) out_of_range: Vec<u32>,
    pub(crate) degenerate: Vec<u32>,
    /// Which face of the list each triangle is.
    pub(crate) source: Vec<u32>,
    /// Three for each triangle, as vertex slots: `0..vertex_bound`.
    pub(crate) corners: Vec<u32>,
    /// Arrays over the vertices need this length only; O(faces).
    pub(crate) vertex_bound: usize,
    /// The vertex of each slot, rising; `None` where a slot is a vertex.
    names: Option<Vec<u32>>,
}

impl Triangles {
    /// Sifts the list. O(faces), and O(faces log faces) where the vertex numbers are far above what so many
    /// faces can use; never O(vertex_count).
    pub(crate) fn sift(vertex_count: usize, faces: &[[u32; 3]]) -> Self {
        let mut sifted = Self::empty(faces.len());
        for (f, face) in (0..).zip(faces) {
            let [a, b, c] = *face;
            if face.iter().any(|&v| v as usize >= vertex_count) {
                sifted.out_of_range.push(f);
            } else if a == b || b == c || c == a {
                sifted.degenerate.push(f);
            } else {
                sifted.source.push(f);
                sifted.corners.extend(face);
            }
        }
        sifted.compact();
        sifted
    }

    fn empty(faces: usize) -> Self {
        Self {
            out_of_range: Vec::new(),
            degenerate: Vec::new(),
            source: Vec::with_capacity(faces),
            corners: Vec::with_capacity(3 * faces),
            vertex_bound: 0,
            names: None,
        }
    }

    /// Numbers the used vertices anew where arrays up to the greatest one would be out of proportion.
    fn compact(&mut self) {
        self.vertex_bound = self.corners.iter().max().map_or(0, |&v| v as usize + 1);
        if self.vertex_bound <= 2 * self.corners.len() {
            return;
        }
        let mut names = self.corners.clone();
        names.sort_unstable();
        names.dedup();
        for v in &mut self.corners {
            // Every corner is in the list that was made of the corners.
            *v = names.binary_search(v).unwrap_or_default() as u32;
        }
        self.vertex_bound = names.len();
        self.names = Some(names);
    }

    /// How many triangles there are.
    pub(crate) fn count(&self) -> usize {
        self.source.len()
    }

    /// Keeps the triangles that are not in `gone` (rising triangle numbers), in order.
    pub(crate) fn without(mut self, gone: &[u32]) -> Self {
        let mut gone = gone.iter().peekable();
        let mut kept = 0;
        for t in 0..self.count() {
            if gone.next_if(|&&g| g as usize == t).is_none() {
                self.source[kept] = self.source[t];
                self.corners.copy_within(3 * t..3 * t + 3, 3 * kept);
                kept += 1;
            }
        }
        self.source.truncate(kept);
        self.corners.truncate(3 * kept);
        self
    }

    /// The vertex that a slot stands for.
    pub(crate) fn vertex(&self, slot: u32) -> u32 {
        self.names.as_ref().map_or(slot, |names| names[slot as usize])
    }

    /// The runs of vertices in `0..vertex_count` that no triangle uses. `used` is over the slots.
    pub(crate) fn unused(&self, vertex_count: usize, used: &[bool]) -> Vec<Range<usize>> {
        let mut runs = Vec::new();
        let mut next = 0;
        for slot in (0..self.vertex_bound as u32).filter(|&s| used[s as usize]) {
            let v = self.vertex(slot) as usize;
            if next < v {
                runs.push(next..v);
            }
            next = v + 1;
        }
        if next < vertex_count {
            runs.push(next..vertex_count);
        }
        runs
    }
}

/// The next corner of the same triangle; a half-edge runs from its corner to this one.
#[inline(always)]
pub(crate) const fn next(corner: u32) -> u32 {
    if corner % 3 == 2 { corner - 2 } else { corner + 1 }
}
