//! Polygons of any size, cut into fans of triangles as they are read.

use std::collections::BTreeMap;

use crate::memory::{push, reserve};
use crate::{Error, Note, Triangles};

/// Faces so far, and what is to be told of the polygons that they were cut from.
#[derive(Debug, Default)]
pub(crate) struct Polygons {
    faces: Vec<[u32; 3]>,
    /// `small[n]` polygons of n corners; the larger ones are in `large`.
    small: [usize; 8],
    large: BTreeMap<usize, usize>,
    /// The first face of each polygon, from the first one on that is no triangle.
    starts: Option<Vec<u32>>,
}

/// The triangle that a corner of a strip makes with the last two before it. Every other one is turned, so that all wind
/// alike.
#[inline(always)]
pub(crate) fn strip_triangle(last: [u32; 2], corner: u32, triangles_before: usize) -> [u32; 3] {
    match triangles_before % 2 {
        0 => [last[0], last[1], corner],
        _ => [last[1], last[0], corner],
    }
}

/// A polygon of which some corners were read.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Open {
    start: usize,
    first: u32,
    previous: u32,
    /// How many corners were read.
    pub(crate) size: usize,
}

impl Polygons {
    pub(crate) fn faces(&self) -> &[[u32; 3]] {
        &self.faces
    }

    /// The first face of each polygon, if one of them is no triangle.
    #[cfg(feature = "parallel")]
    pub(crate) fn starts(&self) -> Option<&[u32]> {
        self.starts.as_deref()
    }

    /// Begins a polygon. One of fewer than three corners need not be closed: it has no face.
    #[inline(always)]
    pub(crate) fn open(&self) -> Open {
        Open { start: self.faces.len(), first: 0, previous: 0, size: 0 }
    }

    /// The next corner of a polygon: from the third one on, each is a face.
    #[inline(always)]
    pub(crate) fn corner(&mut self, polygon: &mut Open, corner: u32) -> Result<(), Error> {
        match polygon.size {
            0 => polygon.first = corner,
            1 => {}
            _ => push(&mut self.faces, [polygon.first, polygon.previous, corner])?,
        }
        polygon.previous = corner;
        polygon.size += 1;
        Ok(())
    }

    /// Ends a polygon of three corners or more.
    #[inline(always)]
    pub(crate) fn close(&mut self, polygon: Open) -> Result<(), Error> {
        match self.small.get_mut(polygon.size) {
            Some(count) => *count += 1,
            None => *self.large.entry(polygon.size).or_default() += 1,
        }
        if let Some(starts) = &mut self.starts {
            return push(starts, polygon.start as u32);
        }
        if polygon.size == 3 { Ok(()) } else { self.start_all_so_far(polygon.start) }
    }

    /// A polygon that was a triangle from the start.
    #[inline(always)]
    pub(crate) fn triangle(&mut self, corners: [u32; 3]) -> Result<(), Error> {
        let start = self.faces.len();
        push(&mut self.faces, corners)?;
        self.close(Open { start, first: corners[0], previous: corners[2], size: 3 })
    }

    /// Room for `more` faces.
    pub(crate) fn reserve(&mut self, more: usize) -> Result<(), Error> {
        reserve(&mut self.faces, more)
    }

    /// As many polygons that were triangles from the start.
    #[inline(always)]
    pub(crate) fn triangles(
        &mut self,
        triangles: impl ExactSizeIterator<Item = [u32; 3]>,
    ) -> Result<(), Error> {
        let (start, count) = (self.faces.len(), triangles.len());
        if let Some(starts) = &mut self.starts {
            reserve(starts, count)?;
            starts.extend((start..start + count).map(|face| face as u32));
        }
        reserve(&mut self.faces, count)?;
        self.faces.extend(triangles);
        self.small[3] += count;
        Ok(())
    }

    #[cold]
    fn start_all_so_far(&mut self, start: usize) -> Result<(), Error> {
        let mut starts = Vec::new();
        reserve(&mut starts, start + 1)?;
        starts.extend(0..=start as u32);
        self.starts = Some(starts);
        Ok(())
    }

    /// Forgets all polygons and keeps the memory of their faces.
    #[cfg(feature = "parallel")]
    pub(crate) fn clear(&mut self) {
        let mut faces = std::mem::take(&mut self.faces);
        faces.clear();
        *self = Self { faces, ..Self::default() };
    }

    /// Counts polygons that come behind these; their faces are kept elsewhere.
    #[cfg(feature = "parallel")]
    pub(crate) fn count(&mut self, part: &Self) {
        self.small.iter_mut().zip(part.small).for_each(|(count, more)| *count += more);
        part.large.iter().for_each(|(size, more)| *self.large.entry(*size).or_default() += more);
    }

    /// The faces of the polygons that were counted, and the first one of each, if not all are triangles.
    #[cfg(feature = "parallel")]
    pub(crate) fn put_lists(&mut self, faces: Vec<[u32; 3]>, starts: Option<Vec<u32>>) {
        (self.faces, self.starts) = (faces, starts);
    }

    pub(crate) fn into_triangles(mut self, positions: Vec<[f32; 3]>, notes: Vec<Note>) -> Triangles {
        self.faces.shrink_to_fit();
        self.starts.iter_mut().for_each(Vec::shrink_to_fit);
        let small = self.small.into_iter().enumerate().filter(|(_, count)| *count > 0);
        self.large.extend(small);
        Triangles {
            positions,
            faces: self.faces,
            polygon_sizes: self.large,
            polygon_starts: self.starts,
            notes,
            gltf: None,
        }
    }
}
