//! The elements behind the header.

use super::element::{Element, Kind};
use super::header::Header;
use super::malformed;
use super::role::{Indices, Role};
use super::source::Source;
use crate::error::quote;
use crate::memory::{push, reserve};
use crate::polygons::{Polygons, strip_triangle};
use crate::triangles::skip;
use crate::{Error, Item, Note, Place, Reason, Skipped, Triangles};

/// Rows that are read one by one before it is tried again to read many at once.
const ONE_BY_ONE: usize = 64;

pub(super) struct Body<'a, S> {
    header: &'a Header<'a>,
    source: S,
    positions: Vec<[f32; 3]>,
    polygons: Polygons,
    notes: Vec<Note>,
}

impl<'a, S: Source> Body<'a, S> {
    pub(super) fn new(header: &'a Header<'a>, source: S) -> Self {
        let notes = header.notes.clone();
        Self { header, source, positions: Vec::new(), polygons: Polygons::default(), notes }
    }

    pub(super) fn read(mut self) -> Result<Triangles, Error> {
        let mut strips = None;
        for element in &self.header.elements {
            match element.role {
                Role::Vertices(xyz) => self.vertices(element, xyz)?,
                Role::Faces(indices) => self.faces(element, indices)?,
                // They come after all faces, which may stand behind them.
                Role::Strips(indices) => {
                    strips = Some((self.source.clone(), element, indices));
                    self.skip(element)?;
                }
                Role::Other => self.skip(element)?,
            }
        }
        let rest = self.source.rest();
        if let Some((source, element, indices)) = strips {
            self.source = source;
            self.strips(element, indices)?;
        }
        self.finish(rest)
    }

    fn vertices(&mut self, element: &Element<'_>, xyz: [usize; 3]) -> Result<(), Error> {
        reserve(&mut self.positions, element.count.min(self.source.most_rows(element)))?;
        let first = self.source.vertices(element, xyz, &mut self.positions);
        for row in first..element.count {
            self.vertex(element, xyz, row)?;
        }
        Ok(())
    }

    #[inline(always)]
    fn vertex(&mut self, element: &Element<'_>, xyz: [usize; 3], row: usize) -> Result<(), Error> {
        let mut position = [0.0; 3];
        for (i, property) in element.properties.iter().enumerate() {
            match (property.kind, xyz.iter().position(|coordinate| *coordinate == i)) {
                (Kind::Scalar(kind), Some(axis)) => {
                    position[axis] = self.source.coordinate(kind, Item::Vertex(row))?;
                }
                (kind, _) => self.source.skip_property(kind, Item::Vertex(row))?,
            }
        }
        push(&mut self.positions, position)
    }

    fn faces(&mut self, element: &Element<'_>, indices: Indices) -> Result<(), Error> {
        self.polygons.reserve(element.count.min(self.source.most_rows(element)))?;
        let mut row = 0;
        while row < element.count {
            let (left, vertices) = (element.count - row, self.header.vertices);
            let at_once = self.source.faces(element, indices, left, vertices, &mut self.polygons)?;
            row += at_once;
            // After a run of rows there may be another; where there was none, not so soon.
            let end = if at_once > 0 { row } else { element.count.min(row + ONE_BY_ONE) };
            while row < end {
                self.face(element, indices, row)?;
                row += 1;
            }
        }
        Ok(())
    }

    #[inline(always)]
    fn face(&mut self, element: &Element<'_>, indices: Indices, row: usize) -> Result<(), Error> {
        for (i, property) in element.properties.iter().enumerate() {
            match property.kind {
                Kind::List { item, .. } if i == indices.property => {
                    let size = self.source.length(indices.length, item, Item::Face(row))?;
                    self.polygon(size, indices, Item::Face(row))?;
                }
                kind => self.source.skip_property(kind, Item::Face(row))?,
            }
        }
        Ok(())
    }

    #[inline(always)]
    fn polygon(&mut self, size: usize, indices: Indices, item: Item) -> Result<(), Error> {
        if size < 3 {
            let place = self.source.place(item);
            skip(&mut self.notes, Skipped::ShortFaces, 1, place);
            return (0..size).try_for_each(|_| self.source.index(indices.item, item).map(drop));
        }
        let mut polygon = self.polygons.open();
        for _ in 0..size {
            let index = self.source.index(indices.item, item)?;
            let corner = self.corner(index, item)?;
            self.polygons.corner(&mut polygon, corner)?;
        }
        self.polygons.close(polygon)
    }

    /// The vertex that the last value names.
    #[inline(always)]
    fn corner(&mut self, index: i64, item: Item) -> Result<u32, Error> {
        let vertices = self.header.vertices;
        match u32::try_from(index) {
            Ok(corner) if corner < vertices => Ok(corner),
            _ => {
                let reason = Reason::IndexOutOfRange {
                    index: self.source.spelled(index),
                    vertices: vertices as usize,
                };
                Err(malformed(self.source.place(item), reason))
            }
        }
    }

    fn strips(&mut self, element: &Element<'_>, indices: Indices) -> Result<(), Error> {
        for row in 0..element.count {
            let item = Item::Strip(row);
            for (i, property) in element.properties.iter().enumerate() {
                match property.kind {
                    Kind::List { item: of, .. } if i == indices.property => {
                        let size = self.source.length(indices.length, of, item)?;
                        self.strip(size, indices, item)?;
                    }
                    kind => self.source.skip_property(kind, item)?,
                }
            }
        }
        Ok(())
    }

    /// One list of strips, parted by negative indices.
    fn strip(&mut self, size: usize, indices: Indices, item: Item) -> Result<(), Error> {
        let mut last = [0; 2];
        let mut length = 0;
        for _ in 0..size {
            let index = self.source.index(indices.item, item)?;
            if index < 0 {
                self.end_strip(length, item);
                length = 0;
                continue;
            }
            let corner = self.corner(index, item)?;
            if length >= 2 {
                self.polygons.triangle(strip_triangle(last, corner, length - 2))?;
            }
            last = [last[1], corner];
            length += 1;
        }
        self.end_strip(length, item);
        Ok(())
    }

    fn end_strip(&mut self, length: usize, item: Item) {
        if matches!(length, 1 | 2) {
            let place = self.source.place(item);
            skip(&mut self.notes, Skipped::LooseCorners, length, place);
        }
    }

    fn skip(&mut self, element: &Element<'_>) -> Result<(), Error> {
        // So many rows of nothing: no loop, and no byte.
        if element.properties.is_empty() {
            return Ok(());
        }
        for row in self.source.skip_rows(element)..element.count {
            for property in &element.properties {
                self.source.skip_property(property.kind, element.item(row))?;
            }
        }
        Ok(())
    }

    fn finish(mut self, (bytes, place): (usize, Place)) -> Result<Triangles, Error> {
        // Last of all: a search among these notes for each short face could take long.
        for element in &self.header.elements {
            if matches!(element.role, Role::Other) && element.count > 0 {
                let what = Skipped::Elements(quote(element.name).into());
                push(&mut self.notes, Note { what, count: element.count, first: element.line })?;
            }
        }
        if bytes > 0 {
            push(&mut self.notes, Note { what: Skipped::TrailingBytes, count: bytes, first: place })?;
        }
        if self.polygons.faces().len() > u32::MAX as usize {
            return Err(malformed(Place::File, Reason::TooMany));
        }
        self.positions.shrink_to_fit();
        Ok(self.polygons.into_triangles(self.positions, self.notes))
    }
}
