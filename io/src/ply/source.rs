//! What text and binary have in common: values one after the other.

use super::element::{Element, Kind};
use super::role::Indices;
use super::scalar::{Integer, Scalar};
use crate::polygons::Polygons;
use crate::{Error, Item, Place};

/// Values behind a header. `item` is the row that they belong to, for errors.
pub(super) trait Source: Clone {
    /// The next value as a coordinate, rounded once.
    fn coordinate(&mut self, kind: Scalar, item: Item) -> Result<f32, Error>;

    /// The next value as a vertex index, or as the end of a strip; cut to the range of `i64`.
    fn index(&mut self, kind: Integer, item: Item) -> Result<i64, Error>;

    /// The next value as the length of a list of such items. Where it can be told, they are all there.
    fn length(&mut self, kind: Integer, of: Scalar, item: Item) -> Result<usize, Error>;

    /// Steps over the next value.
    fn skip(&mut self, kind: Scalar, item: Item) -> Result<(), Error>;

    /// Steps over so many values.
    fn skip_all(&mut self, count: usize, kind: Scalar, item: Item) -> Result<(), Error>;

    /// The last value as the file spells it.
    fn spelled(&self, value: i64) -> String;

    /// Where the last value stands.
    fn place(&mut self, item: Item) -> Place;

    /// How many rows there can be at most in what is left.
    fn most_rows(&self, element: &Element<'_>) -> usize;

    /// How many bytes are left, and where.
    fn rest(&mut self) -> (usize, Place);

    /// Appends vertices from here on as long as that is faster than one by one: how many there were.
    fn vertices(&mut self, _: &Element<'_>, _: [usize; 3], _: &mut Vec<[f32; 3]>) -> usize {
        0
    }

    /// Appends at most `rows` faces from here on as long as that is faster than one by one: how many there were. All
    /// their corners are below `vertices`.
    fn faces(
        &mut self,
        _: &Element<'_>,
        _: Indices,
        _rows: usize,
        _vertices: u32,
        _: &mut Polygons,
    ) -> Result<usize, Error> {
        Ok(0)
    }

    /// Steps over rows from here on as long as that is faster than one by one: how many there were.
    fn skip_rows(&mut self, _: &Element<'_>) -> usize {
        0
    }

    /// Steps over a value or a list.
    #[inline(always)]
    fn skip_property(&mut self, kind: Kind, item: Item) -> Result<(), Error> {
        match kind {
            Kind::Scalar(scalar) => self.skip(scalar, item),
            Kind::List { length, item: of } => {
                let count = self.length(length, of, item)?;
                self.skip_all(count, of, item)
            }
        }
    }
}
