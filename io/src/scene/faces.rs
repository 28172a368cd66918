//! Corners of a geometry node to polygons and triangles.

use super::field::Numbers;
use crate::error::quote;
use crate::number::index_prefix;
use crate::polygons::{Polygons, strip_triangle};
use crate::{Error, Reason};

/// The corners of one geometry node.
pub(super) struct Corners<'a> {
    numbers: Numbers<'a>,
    /// The first of its vertices in the mesh, and how many there are.
    base: u32,
    count: u32,
}

/// An entry of a list of corners.
enum Corner {
    Vertex(u32),
    /// A negative number: the end of a face.
    End,
}

/// What a list of corners made no face of, and the byte where it was met first.
#[derive(Default)]
pub(super) struct Leftover {
    pub(super) count: usize,
    pub(super) first: usize,
}

impl Leftover {
    fn add(&mut self, count: usize, at: usize) {
        if self.count == 0 {
            self.first = at;
        }
        self.count += count;
    }
}

impl<'a> Corners<'a> {
    pub(super) fn new(numbers: Numbers<'a>, base: u32, count: u32) -> Self {
        Self { numbers, base, count }
    }

    /// `a b c d -1 ...`: the faces of fewer than three corners are left over.
    pub(super) fn polygons(mut self, out: &mut Polygons) -> Result<Leftover, Error> {
        let mut short = Leftover::default();
        let mut polygon = out.open();
        loop {
            let corner = self.next()?;
            if let Some(Corner::Vertex(vertex)) = corner {
                out.corner(&mut polygon, vertex)?;
                continue;
            }
            match polygon.size {
                0 => {}
                1 | 2 => short.add(1, self.numbers.at()),
                _ => out.close(polygon)?,
            }
            if corner.is_none() {
                return Ok(short);
            }
            polygon = out.open();
        }
    }

    /// `a b c d e f ...`: three corners each. Corners that make no triangle are left over.
    pub(super) fn triangles(mut self, out: &mut Polygons) -> Result<Leftover, Error> {
        let mut loose = Leftover::default();
        let mut triangle = [0; 3];
        let mut size = 0;
        while let Some(word) = self.numbers.next() {
            let Corner::Vertex(vertex) = self.corner(word)? else { return Err(self.out_of_range(word)) };
            triangle[size] = vertex;
            size += 1;
            if size == 3 {
                out.triangle(triangle)?;
                size = 0;
            }
        }
        loose.add(size, self.numbers.at());
        Ok(loose)
    }

    /// `a b c d ... -1 ...`: each corner from the third one on makes a triangle with two before it, which `join`
    /// tells, given the first corner of the run, the last two and how many triangles it has so far.
    pub(super) fn runs(
        mut self,
        join: fn(first: u32, last: [u32; 2], corner: u32, triangles: usize) -> [u32; 3],
        out: &mut Polygons,
    ) -> Result<Leftover, Error> {
        let mut loose = Leftover::default();
        let (mut first, mut last, mut size) = (0, [0; 2], 0);
        loop {
            match self.next()? {
                Some(Corner::Vertex(vertex)) => {
                    if size == 0 {
                        first = vertex;
                    }
                    if size >= 2 {
                        out.triangle(join(first, last, vertex, size - 2))?;
                    }
                    last = [last[1], vertex];
                    size += 1;
                }
                end => {
                    if (1..=2).contains(&size) {
                        loose.add(size, self.numbers.at());
                    }
                    if end.is_none() {
                        return Ok(loose);
                    }
                    size = 0;
                }
            }
        }
    }

    #[inline(always)]
    fn next(&mut self) -> Result<Option<Corner>, Error> {
        self.numbers.next().map(|word| self.corner(word)).transpose()
    }

    #[inline(always)]
    fn corner(&self, word: &[u8]) -> Result<Corner, Error> {
        match index_prefix(word) {
            Some((true, 1.., [])) => Ok(Corner::End),
            Some((_, index, [])) if index < u64::from(self.count) => {
                Ok(Corner::Vertex(self.base + index as u32))
            }
            Some((_, _, [])) => Err(self.out_of_range(word)),
            _ => Err(self.numbers.malformed(Reason::BadIndex { word: quote(word) })),
        }
    }

    #[cold]
    fn out_of_range(&self, word: &[u8]) -> Error {
        let vertices = self.count as usize;
        self.numbers.malformed(Reason::IndexOutOfRange { index: quote(word), vertices })
    }
}

pub(super) fn strip(_: u32, last: [u32; 2], corner: u32, triangles: usize) -> [u32; 3] {
    strip_triangle(last, corner, triangles)
}

pub(super) fn fan(first: u32, last: [u32; 2], corner: u32, _: usize) -> [u32; 3] {
    [first, last[1], corner]
}
