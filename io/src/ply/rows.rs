//! The layouts that nearly all binary files have, many rows at a time.

use super::element::{Element, Kind, fixed_size};
use super::role::Indices;
use super::scalar::{Integer, Scalar};
use crate::Error;
use crate::polygons::Polygons;

/// Triangles that are checked and then copied: so few that they are still in the cache when they are copied.
const BLOCK: usize = 1024;

/// The same bytes, the lowest one first.
#[inline(always)]
pub(super) fn little_endian<const N: usize, const BIG: bool>(mut bytes: [u8; N]) -> [u8; N] {
    if BIG {
        bytes.reverse();
    }
    bytes
}

/// Three numbers of 32 bits.
// `map` and `from_fn` are calls here, not unrolled loops: they take twice the time.
#[inline(always)]
fn three<const BIG: bool>(bytes: &[u8; 12]) -> [u32; 3] {
    let word = |at| word::<BIG>(bytes, at);
    [word(0), word(4), word(8)]
}

#[inline(always)]
fn word<const BIG: bool>(bytes: &[u8], at: usize) -> u32 {
    u32::from_le_bytes(little_endian::<4, BIG>([bytes[at], bytes[at + 1], bytes[at + 2], bytes[at + 3]]))
}

/// The twelve bytes of a row from `at` on.
#[inline(always)]
fn twelve(row: &[u8], at: usize) -> &[u8; 12] {
    row[at..].first_chunk().unwrap_or(&[0; 12])
}

/// Vertices without lists, whose coordinates are all `f32`.
pub(super) struct FloatRows {
    pub(super) stride: usize,
    xyz: [usize; 3],
}

impl FloatRows {
    pub(super) fn of(element: &Element<'_>, xyz: [usize; 3]) -> Option<Self> {
        let stride = element.stride()?;
        let is_float = |i: &usize| matches!(element.properties[*i].kind, Kind::Scalar(Scalar::F32));
        let offset = |i: usize| fixed_size(&element.properties[..i]).unwrap_or_default();
        xyz.iter().all(is_float).then(|| Self { stride, xyz: xyz.map(offset) })
    }

    /// Appends the vertices of whole rows.
    pub(super) fn append<const BIG: bool>(&self, bytes: &[u8], out: &mut Vec<[f32; 3]>) {
        let floats = |[x, y, z]: [u32; 3]| [f32::from_bits(x), f32::from_bits(y), f32::from_bits(z)];
        let rows = bytes.chunks_exact(self.stride);
        let [x, y, z] = self.xyz;
        if (y, z) == (x + 4, x + 8) {
            out.extend(rows.map(|row| floats(three::<BIG>(twelve(row, x)))));
        } else {
            out.extend(
                rows.map(|row| floats([word::<BIG>(row, x), word::<BIG>(row, y), word::<BIG>(row, z)])),
            );
        }
    }
}

/// Faces with one list, of `uchar` length and of indices of 32 bits.
pub(super) struct FaceRows {
    /// Bytes before the list, and behind it.
    before: usize,
    after: usize,
    /// What all corners are below.
    limit: u32,
}

impl FaceRows {
    pub(super) fn of(element: &Element<'_>, indices: Indices, vertices: u32) -> Option<Self> {
        let before = fixed_size(&element.properties[..indices.property])?;
        let after = fixed_size(&element.properties[indices.property + 1..])?;
        let limit = match indices.item {
            Integer::U32 => vertices,
            // Read as `u32`, a negative index is beyond the positive ones.
            Integer::I32 => vertices.min(1 << 31),
            _ => return None,
        };
        (indices.length == Integer::U8).then_some(Self { before, after, limit })
    }

    pub(super) fn stride(&self) -> usize {
        self.before + 13 + self.after
    }

    /// Appends triangles up to the first row that is none, or names no vertex: at most `rows`. How many there were.
    pub(super) fn triangles<const BIG: bool>(
        &self,
        bytes: &[u8],
        rows: usize,
        out: &mut Polygons,
    ) -> Result<usize, Error> {
        let stride = self.stride();
        let mut count = 0;
        for block in bytes.chunks(BLOCK * stride) {
            let fits = block.chunks_exact(stride).take(rows - count);
            let whole = fits.len();
            let good = fits.take_while(|row| self.is_good::<BIG>(row)).count();
            out.triangles(block.chunks_exact(stride).take(good).map(|row| self.corners::<BIG>(row)))?;
            count += good;
            if good < whole || whole < BLOCK {
                break;
            }
        }
        Ok(count)
    }

    /// Appends the polygon of the first row: how many bytes the row has. `None` where it is to be looked at more closely:
    /// it ends too early, has fewer than three corners, or names no vertex.
    #[inline(always)]
    pub(super) fn polygon<const BIG: bool>(
        &self,
        bytes: &[u8],
        out: &mut Polygons,
    ) -> Result<Option<usize>, Error> {
        let Some((&size, rest)) = bytes.get(self.before..).and_then(<[u8]>::split_first) else {
            return Ok(None);
        };
        let length = 4 * usize::from(size);
        if size < 3 || rest.len() < length + self.after {
            return Ok(None);
        }
        let (corners, _) = rest[..length].as_chunks::<4>();
        if corners.iter().any(|corner| word::<BIG>(corner, 0) >= self.limit) {
            return Ok(None);
        }
        let mut polygon = out.open();
        for corner in corners {
            out.corner(&mut polygon, word::<BIG>(corner, 0))?;
        }
        out.close(polygon)?;
        Ok(Some(self.before + 1 + length + self.after))
    }

    #[inline(always)]
    fn is_good<const BIG: bool>(&self, row: &[u8]) -> bool {
        let [a, b, c] = self.corners::<BIG>(row);
        row[self.before] == 3 && a.max(b).max(c) < self.limit
    }

    #[inline(always)]
    fn corners<const BIG: bool>(&self, row: &[u8]) -> [u32; 3] {
        three::<BIG>(twelve(row, self.before + 1))
    }
}
