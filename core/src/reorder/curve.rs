//! Orders along curves that fill space.
use super::radix::{KEY_BITS, sort};
use crate::{Handle, Map, NotFinite, not_finite, workers};
use alloc::vec::Vec;

/// Points whose keys are worth a thread.
const PIECE: usize = 1 << 14;

/// Cells along each axis, as a power of two.
const AXIS_BITS: u32 = KEY_BITS / 3;

/// The vertices in the order in which a Hilbert curve through their bounding cube comes by.
///
/// The cube has 2^16 cells along each axis; vertices in the same cell stay in the order that they had, which is all of
/// them where one is very far from the others. Two cells that follow one another along the curve share a side.
///
/// # Arguments
/// One position for each vertex.
///
/// # Returns
/// Every vertex, once: an order for [`reorder`](super::reorder).
///
/// # Complexity
/// O(vertices), by radix sort; 32 bytes of scratch for each. With the feature `parallel`, all threads find the keys.
///
/// # Errors
/// [`NotFinite`].
///
/// # Example
/// ```
/// use onering_core::{Handle, Map, VertexId, reorder};
/// let corners: Map<VertexId, _> = (0..8).map(|i| [1, 2, 4].map(|bit| (i & bit) as f32 / bit as f32)).collect();
/// let order = reorder::hilbert(&corners)?;
/// let differ = |a: VertexId, b: VertexId| (a.index() ^ b.index()).count_ones();
/// assert!(order.windows(2).all(|w| differ(w[0], w[1]) == 1)); // along an edge of the cube, each time
/// # Ok::<(), onering_core::NotFinite>(())
/// ```
///
/// # Source
/// Skilling, "Programming the Hilbert curve", AIP Conference Proceedings 707, 2004.
pub fn hilbert<V: Handle>(positions: &Map<V, [f32; 3]>) -> Result<Vec<V>, NotFinite> {
    along(positions, |cell| interleaved(transposed(cell)))
}

/// The vertices in Morton's order (Z order): by the bits of the three coordinates, taken in turns.
///
/// As [`hilbert`] otherwise. It takes less time to find, and sweeps over one-rings were as fast after it; but it jumps, so
/// that stretches of it (the vertices of one block of memory, of one thread) may lie in several places.
///
/// # Arguments
/// One position for each vertex.
///
/// # Returns
/// Every vertex, once: an order for [`reorder`](super::reorder).
///
/// # Complexity
/// O(vertices), by radix sort; 32 bytes of scratch for each. With the feature `parallel`, all threads find the keys.
///
/// # Errors
/// [`NotFinite`].
///
/// # Example
/// ```
/// use onering_core::{Handle, Map, VertexId, reorder};
/// let row: Map<VertexId, _> = vec![[3.0, 0.0, 0.0], [1.0, 0.0, 0.0], [2.0, 0.0, 0.0]].into();
/// assert_eq!(reorder::morton(&row)?, [1, 2, 0].map(VertexId::new));
/// # Ok::<(), onering_core::NotFinite>(())
/// ```
///
/// # Source
/// Morton, "A computer oriented geodetic data base and a new technique in file sequencing", IBM, 1966.
pub fn morton<V: Handle>(positions: &Map<V, [f32; 3]>) -> Result<Vec<V>, NotFinite> {
    along(positions, interleaved)
}

/// The vertices by the keys of their cells.
fn along<V: Handle>(
    positions: &Map<V, [f32; 3]>,
    key: impl Fn([u32; 3]) -> u64 + Sync,
) -> Result<Vec<V>, NotFinite> {
    not_finite::positions(positions)?;
    let points = positions.as_slice();
    let cell = cells(points);
    let size = points.len().div_ceil(workers::pieces(points.len(), PIECE)).max(1);
    let pieces = points.chunks(size).collect();
    let keys = workers::map(pieces, |piece| piece.iter().map(|&p| key(cell(p))).collect::<Vec<u64>>());
    let mut keyed: Vec<(u64, V)> = Vec::with_capacity(points.len());
    keyed.extend(keys.into_iter().flatten().zip(0..).map(|(key, v)| (key, V::new(v))));
    sort(&mut keyed);
    Ok(keyed.into_iter().map(|(_, v)| v).collect())
}

/// The cell of each point in a grid over the bounding cube.
fn cells(points: &[[f32; 3]]) -> impl Fn([f32; 3]) -> [u32; 3] {
    let least = points.iter().fold([f64::INFINITY; 3], |a, p| [0, 1, 2].map(|i| a[i].min(p[i].into())));
    let most = points.iter().fold([f64::NEG_INFINITY; 3], |a, p| [0, 1, 2].map(|i| a[i].max(p[i].into())));
    let side = [0, 1, 2].map(|i| most[i] - least[i]).into_iter().fold(0.0, f64::max);
    let last = (1_u32 << AXIS_BITS) - 1;
    let scale = if side > 0.0 { f64::from(1_u32 << AXIS_BITS) / side } else { 0.0 };
    move |p| [0, 1, 2].map(|i| (((f64::from(p[i]) - least[i]) * scale) as u32).min(last))
}

/// The bits of the three in turns, the highest of the first foremost.
fn interleaved(cell: [u32; 3]) -> u64 {
    let [x, y, z] = cell.map(spread);
    x << 2 | y << 1 | z
}

/// Two zeros before each of the lower 16 bits.
fn spread(x: u32) -> u64 {
    let x = u64::from(x);
    let x = (x | x << 16) & 0x001f_0000_ff00_00ff;
    let x = (x | x << 8) & 0x100f_00f0_0f00_f00f;
    let x = (x | x << 4) & 0x10c3_0c30_c30c_30c3;
    (x | x << 2) & 0x1249_2492_4924_9249
}

/// The place along the curve, its bits dealt out to three words as [`interleaved`] collects them: Skilling's
/// "transpose". Each level of the grid turns and mirrors the cube of the levels below it, which are the lower bits.
fn transposed(mut x: [u32; 3]) -> [u32; 3] {
    for level in (1..AXIS_BITS).rev() {
        let below = (1 << level) - 1;
        for i in 0..3 {
            if x[i] >> level & 1 == 1 {
                x[0] ^= below;
            } else {
                let exchanged = (x[0] ^ x[i]) & below;
                x[0] ^= exchanged;
                x[i] ^= exchanged;
            }
        }
    }
    // From a Gray code to a number.
    x[1] ^= x[0];
    x[2] ^= x[1];
    let flips =
        (1..AXIS_BITS).filter(|level| x[2] >> level & 1 == 1).fold(0, |t, level| t ^ ((1 << level) - 1));
    x.map(|x| x ^ flips)
}

#[cfg(test)]
mod tests {
    use super::*;
    use alloc::vec;

    #[test]
    fn bits_in_turns() {
        for x in [0, 1, 0b1011, 0x8001, 0xffff, 0x5a3c] {
            let slow = (0..16).map(|bit| u64::from(x >> bit & 1) << (3 * bit)).sum();
            assert_eq!(spread(x), slow, "{x:x}");
        }
    }

    /// A cube of the lowest levels lies whole on one stretch of the curve, and each step goes to the next cell.
    #[test]
    fn the_curve_goes_from_cell_to_cell() {
        let side = 16;
        let corner = 5 * side;
        let mut cells = vec![];
        for k in 0..side * side * side {
            let cell = [k / (side * side), k / side % side, k % side].map(|c| corner + c);
            cells.push((interleaved(transposed(cell)), cell));
        }
        cells.sort_unstable();
        for w in cells.windows(2) {
            let steps: u32 = (0..3).map(|i| w[0].1[i].abs_diff(w[1].1[i])).sum();
            assert_eq!((w[1].0 - w[0].0, steps), (1, 1), "{w:?}");
        }
    }
}
