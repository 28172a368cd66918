//! The arrays that every library gets, and the file in which they go from process to process.

use std::error::Error;
use std::fs::{self, File};
use std::io::{BufWriter, Write};
use std::path::Path;

/// Positions and faces of a mesh, and how many edges it has, so that whoever can may reserve them exactly.
#[derive(Debug, PartialEq)]
pub(crate) struct Mesh {
    pub(crate) positions: Vec<[f32; 3]>,
    pub(crate) faces: Vec<[u32; 3]>,
    pub(crate) edge_count: usize,
}

/// What every sweep has to find: the edges by a sort of all of them, not by a structure.
pub(crate) struct Rings {
    pub(crate) edge_count: usize,
    pub(crate) checksum: u64,
}

/// The neighbours of `v`, mixed into a sum that does not depend on their order. The C++ programs do the same.
#[inline(always)]
pub(crate) fn ring_sum(v: u32, ring: impl Iterator<Item = u32>) -> u64 {
    let key = u64::from(v).wrapping_mul(0x9E37_79B9_7F4A_7C15);
    ring.fold(0, |sum: u64, u| sum.wrapping_add(key ^ u64::from(u)))
}

impl Rings {
    pub(crate) fn of(faces: &[[u32; 3]]) -> Self {
        let sides = faces.iter().flat_map(|&[a, b, c]| [(a, b), (b, c), (c, a)]);
        let mut edges: Vec<u64> =
            sides.map(|(u, v)| u64::from(u.min(v)) << 32 | u64::from(u.max(v))).collect();
        edges.sort_unstable();
        edges.dedup();
        let both = |&edge: &u64| {
            let [u, v] = [(edge >> 32) as u32, edge as u32];
            ring_sum(u, [v].into_iter()).wrapping_add(ring_sum(v, [u].into_iter()))
        };
        let checksum = edges.iter().map(both).fold(0, u64::wrapping_add);
        Self { edge_count: edges.len(), checksum }
    }
}

impl Mesh {
    /// Numbers of vertices, faces and edges as `u64`, then positions and faces, all little-endian.
    pub(crate) fn write(&self, path: &Path) -> std::io::Result<()> {
        let mut out = BufWriter::new(File::create(path)?);
        for count in [self.positions.len(), self.faces.len(), self.edge_count] {
            out.write_all(&(count as u64).to_le_bytes())?;
        }
        out.write_all(bytemuck::cast_slice(&self.positions))?;
        out.write_all(bytemuck::cast_slice(&self.faces))?;
        out.flush()
    }

    pub(crate) fn read(path: &Path) -> Result<Self, Box<dyn Error>> {
        let bytes = fs::read(path)?;
        let (counts, arrays) = bytes.split_at_checked(24).ok_or("the file ends within its counts")?;
        let count = |i: usize| u64::from_le_bytes(counts[i * 8..][..8].try_into().expect("8 bytes")) as usize;
        let position_bytes = count(0).checked_mul(12).ok_or("too many positions")?;
        let (positions, faces) =
            arrays.split_at_checked(position_bytes).ok_or("the file ends within its positions")?;
        if Some(faces.len()) != count(1).checked_mul(12) {
            return Err("the number of faces is not that of the file".into());
        }
        Ok(Self {
            positions: bytemuck::pod_collect_to_vec(positions),
            faces: bytemuck::pod_collect_to_vec(faces),
            edge_count: count(2),
        })
    }
}
