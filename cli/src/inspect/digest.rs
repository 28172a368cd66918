//! SHA-256 of triangles: two readers agree on a mesh where these are the same.

use sha2::{Digest, Sha256};

/// Of bytes, as they come.
#[derive(Default)]
pub(crate) struct Bytes {
    length: usize,
    hash: Sha256,
}

impl Bytes {
    pub(crate) fn add(&mut self, bytes: &[u8]) {
        self.length += bytes.len();
        self.hash.update(bytes);
    }

    /// How many there were, and their digest in hexadecimal.
    pub(crate) fn finish(self) -> (usize, String) {
        (self.length, hex(self.hash))
    }
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
    }

    #[test]
    fn bytes_come_in_pieces() {
        let mut bytes = Bytes::default();
        bytes.add(b"ab");
        bytes.add(b"c");
        let digest = "ba7816bf8f01cfea414140de5dae2223b00361a396177a9cb410ff61f20015ad";
        assert_eq!(bytes.finish(), (3, digest.into()));
    }
}
