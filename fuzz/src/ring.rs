//! `.ring` files: any bytes are an error or a mesh, and a mesh obeys the laws over its own faces.
#[allow(dead_code, reason = "shared with tests that use more of it")]
#[path = "../../tests/ring/seal.rs"]
mod seal;

use onering::conformance::{self as laws, Case};
use onering::ring::{self, File};
use onering::*;

/// Faces of the mesh that is changed: few, so that a run takes less than a millisecond.
const FACES: usize = 8;

/// Bytes that begin as a file does are opened as they are. Others choose a structure, a mesh of some faces, and words of
/// its file to change before it gets the checksums that belong to it.
pub fn ring(bytes: &[u8]) {
    if bytes.starts_with(&onering_io::ring::MAGIC) {
        return open(bytes);
    }
    let &[backend, faces, ref rest @ ..] = bytes else { return };
    let backend = registry::BACKENDS[usize::from(backend) % registry::BACKENDS.len()].name;
    let (corners, changes) = rest.split_at(rest.len().min(3 * (1 + usize::from(faces) % FACES)));
    let faces: Vec<_> =
        corners.as_chunks::<3>().0.iter().map(|face| face.map(|v| u32::from(v % 8))).collect();
    let Some(Ok(mesh)) = ring::build(backend, 8, faces.into()) else { return };
    let mut file = Vec::new();
    ring::write(&mut file, &*mesh, None).expect("a vector takes everything");
    change(&mut file, changes);
    open(&file);
}

/// Each three bytes put a word in some place: a small number, or one from the end of its range.
fn change(file: &mut [u8], changes: &[u8]) {
    let table = seal::sections(file);
    let places: Vec<_> = table.iter().flat_map(|s| (s.offset..s.offset + s.length).step_by(4)).collect();
    for &[low, high, value] in changes.as_chunks::<3>().0.iter().filter(|_| !places.is_empty()) {
        let at = places[usize::from(u16::from_le_bytes([low, high])) % places.len()];
        let word = i32::from(value as i8) as u32;
        file[at..at + 4].copy_from_slice(&word.to_le_bytes());
    }
    seal::seal(file);
}

macro_rules! open {
    ($($name:ident $text:literal $mesh:ty [$($has:ident)*] [$($holds:ident)*];)+) => {
        fn open(bytes: &[u8]) {
            let Ok(file) = File::from_bytes(bytes) else { return };
            match file.backend() {
                $($text => if let Ok(mesh) = file.mesh::<$mesh>() {
                    open!(@ mesh $($has)*);
                },)+
                _ => {}
            }
            let _ = ring::triangles(&file);
        }
    };
    (@ $mesh:ident graph) => {
        for v in $mesh.vertices() {
            assert!($mesh.neighbours(v).all(|u| $mesh.has_edge(u, v)));
        }
        assert_eq!($mesh.edges().count(), $mesh.edge_count());
    };
    (@ $mesh:ident $($has:ident)*) => {
        // The laws compare with searches, which take the square of the size.
        if $mesh.vertex_count().max($mesh.face_count()) <= 16 {
            let case = Case::counted("fuzzed", $mesh.vertex_count(), $mesh.to_faces());
            $(laws::$has(&case, &$mesh);)*
        }
    };
}
with_backends!(open);
