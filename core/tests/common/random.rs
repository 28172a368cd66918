//! Random lists of triangles, as bad as they come.

use super::grid;
use proptest::prelude::*;

/// Fewer than `below` vertices and many faces, so that every edge is crowded; here and there an index too high.
pub(crate) fn crowds(below: u32) -> impl Strategy<Value = (usize, Vec<[u32; 3]>)> {
    (3..below).prop_flat_map(|n| {
        let vertex = prop_oneof![100 => 0..n, 1 => n..n + 2];
        (Just(n as usize), prop::collection::vec(prop::array::uniform3(vertex), 0..41))
    })
}

/// Part of a grid of any kind, some faces flipped and some vertices pinched together: seams, slits and folds.
pub(crate) fn crumpled() -> impl Strategy<Value = (usize, Vec<[u32; 3]>)> {
    (3u32..9, 3u32..9, any::<[bool; 2]>(), any::<bool>()).prop_flat_map(|(n, m, wrap, flip)| {
        let (vertices, faces) = grid(n, m, wrap, flip);
        let fates = prop::collection::vec(0u8..10, faces.len());
        let pinch = prop::collection::vec((0..vertices as u32, 0..vertices as u32), 0..8);
        (Just(vertices), Just(faces), fates, pinch).prop_map(|(vertices, faces, fates, pinch)| {
            let moved = |v| pinch.iter().find(|p| p.0 == v).map_or(v, |p| p.1);
            let kept = faces.iter().zip(fates).filter(|&(_, fate)| fate > 0);
            let flipped = kept.map(|(&[a, b, c], fate)| if fate == 1 { [a, c, b] } else { [a, b, c] });
            (vertices, flipped.map(|face| face.map(moved)).collect())
        })
    })
}
