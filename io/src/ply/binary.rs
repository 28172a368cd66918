//! Values as bytes.

use super::element::Element;
use super::malformed;
use super::role::Indices;
use super::rows::{self, FaceRows, FloatRows};
use super::scalar::{Integer, Scalar};
use super::source::Source;
use crate::polygons::Polygons;
use crate::{Error, Item, Place, Reason};

/// Polygons that are read one by one before the next ones are taken for triangles again.
const POLYGONS: usize = 64;

/// Numbers of the one byte order or the other.
#[derive(Clone)]
pub(super) struct Binary<'a, const BIG: bool> {
    bytes: &'a [u8],
    at: usize,
    /// Where the last value began.
    last: usize,
}

impl<'a, const BIG: bool> Binary<'a, BIG> {
    pub(super) fn new(bytes: &'a [u8], end: usize) -> Self {
        Self { bytes, at: end, last: end }
    }

    fn left(&self) -> &'a [u8] {
        &self.bytes[self.at..]
    }

    /// The next bytes, the lowest one first.
    #[inline(always)]
    fn take<const N: usize>(&mut self, item: Item) -> Result<[u8; N], Error> {
        match self.left().first_chunk() {
            Some(bytes) => {
                self.last = self.at;
                self.at += N;
                Ok(rows::little_endian::<N, BIG>(*bytes))
            }
            None => Err(self.too_short(N, item)),
        }
    }

    #[inline(always)]
    fn advance(&mut self, size: usize, item: Item) -> Result<(), Error> {
        if self.left().len() < size {
            return Err(self.too_short(size, item));
        }
        self.last = self.at;
        self.at += size;
        Ok(())
    }

    #[inline(always)]
    fn integer(&mut self, kind: Integer, item: Item) -> Result<i64, Error> {
        Ok(match kind {
            Integer::I8 => i8::from_le_bytes(self.take(item)?).into(),
            Integer::U8 => u8::from_le_bytes(self.take(item)?).into(),
            Integer::I16 => i16::from_le_bytes(self.take(item)?).into(),
            Integer::U16 => u16::from_le_bytes(self.take(item)?).into(),
            Integer::I32 => i32::from_le_bytes(self.take(item)?).into(),
            Integer::U32 => u32::from_le_bytes(self.take(item)?).into(),
        })
    }

    #[cold]
    fn too_short(&self, needed: usize, item: Item) -> Error {
        let (needed, available) = (needed as u64, self.left().len() as u64);
        malformed(Place::Byte(self.at), Reason::TooShort { item, needed, available })
    }
}

impl<const BIG: bool> Source for Binary<'_, BIG> {
    #[inline(always)]
    fn coordinate(&mut self, kind: Scalar, item: Item) -> Result<f32, Error> {
        Ok(match kind {
            Scalar::Integer(kind) => self.integer(kind, item)? as f32,
            Scalar::F32 => f32::from_le_bytes(self.take(item)?),
            Scalar::F64 => f64::from_le_bytes(self.take(item)?) as f32,
        })
    }

    #[inline(always)]
    fn index(&mut self, kind: Integer, item: Item) -> Result<i64, Error> {
        self.integer(kind, item)
    }

    #[inline(always)]
    fn length(&mut self, kind: Integer, of: Scalar, item: Item) -> Result<usize, Error> {
        let value = self.integer(kind, item)?;
        let Ok(length) = usize::try_from(value) else {
            let reason = Reason::BadWord { word: value.to_string(), expected: "the length of a list" };
            return Err(malformed(self.place(item), reason));
        };
        let size = length.saturating_mul(of.size());
        if self.left().len() < size { Err(self.too_short(size, item)) } else { Ok(length) }
    }

    #[inline(always)]
    fn skip(&mut self, kind: Scalar, item: Item) -> Result<(), Error> {
        self.advance(kind.size(), item)
    }

    #[inline(always)]
    fn skip_all(&mut self, count: usize, kind: Scalar, item: Item) -> Result<(), Error> {
        self.advance(count.saturating_mul(kind.size()), item)
    }

    fn spelled(&self, value: i64) -> String {
        value.to_string()
    }

    fn place(&mut self, item: Item) -> Place {
        Place::ByteIn { item, byte: self.last }
    }

    fn most_rows(&self, element: &Element<'_>) -> usize {
        self.left().len().checked_div(element.least_size()).unwrap_or(0)
    }

    fn rest(&mut self) -> (usize, Place) {
        (self.left().len(), Place::Byte(self.at))
    }

    fn vertices(&mut self, element: &Element<'_>, xyz: [usize; 3], out: &mut Vec<[f32; 3]>) -> usize {
        let Some(layout) = FloatRows::of(element, xyz) else { return 0 };
        let count = element.count.min(self.most_rows(element));
        let bytes = &self.left()[..count * layout.stride];
        layout.append::<BIG>(bytes, out);
        self.at += bytes.len();
        count
    }

    fn faces(
        &mut self,
        element: &Element<'_>,
        indices: Indices,
        rows: usize,
        vertices: u32,
        out: &mut Polygons,
    ) -> Result<usize, Error> {
        let Some(layout) = FaceRows::of(element, indices, vertices) else { return Ok(0) };
        let mut count = layout.triangles::<BIG>(self.left(), rows, out)?;
        self.at += count * layout.stride();
        let end = rows.min(count + POLYGONS);
        while count < end
            && let Some(size) = layout.polygon::<BIG>(self.left(), out)?
        {
            self.at += size;
            count += 1;
        }
        Ok(count)
    }

    fn skip_rows(&mut self, element: &Element<'_>) -> usize {
        let Some(stride) = element.stride() else { return 0 };
        let count = element.count.min(self.most_rows(element));
        self.at += count * stride;
        count
    }
}
