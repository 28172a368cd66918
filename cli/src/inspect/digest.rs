//! SHA-256 of triangles: two readers agree on a mesh where these are the same.

use sha2::{Digest, Sha256};

/// Of bytes, in hexadecimal.
pub(crate) fn of_bytes(bytes: &[u8]) -> String {
    hex(Sha256::new().chain_update(bytes))
}

/// Of triangles in order, each three little-endian `u32`.
pub(crate) fn of_faces(faces: &[[u32; 3]]) -> String {
    let mut hash = Sha256::new();
    for corner in faces.as_flattened() {
        hash.update(corner.to_le_bytes());
    }
    hex(hash)
}

/// The same whatever the order of the triangles and wherever each begins: each in the least of its three
/// rotations, then sorted.
pub(crate) fn of_canonical(faces: &[[u32; 3]]) -> String {
    let least = |&[a, b, c]: &[u32; 3]| [a, b, c].min([b, c, a]).min([c, a, b]);
    let mut faces: Vec<[u32; 3]> = faces.iter().map(least).collect();
    faces.sort_unstable();
    of_faces(&faces)
}

fn hex(hash: Sha256) -> String {
    hash.finalize().iter().map(|byte| format!("{byte:02x}")).collect()
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn orientation_counts_but_not_order() {
        let one = of_canonical(&[[3, 1, 2], [5, 6, 4]]);
        assert_eq!(one, of_faces(&[[1, 2, 3], [4, 5, 6]]));
        assert_eq!(one, of_canonical(&[[6, 4, 5], [1, 2, 3]]));
        assert_ne!(one, of_canonical(&[[6, 4, 5], [1, 3, 2]]));
        assert_eq!(of_bytes(b""), "e3b0c44298fc1c149afbf4c8996fb92427ae41e4649b934ca495991b7852b855");
    }
}
