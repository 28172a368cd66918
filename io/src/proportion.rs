//! How large a mesh may be for the size of its file, where a file can name the same data many times.

use crate::Reason;

/// Vertices and faces that a byte of input may give. Several primitives may share a list of vertices, so a document
/// may stand for a mesh larger than itself: in glTF, k primitives, one for each material, on one list of V vertices
/// and 2 V faces are k V + 2 V elements out of 24 V bytes, or 44 V with normals and texture coordinates. This leaves
/// room for about a hundred materials; a hostile document asks for thousands.
const ELEMENTS_PER_BYTE: u64 = 4;
/// Vertices and faces that are allowed in any case.
const ELEMENTS_ALWAYS: u64 = 1 << 16;

/// Refuses so many vertices and faces, counted together, out of so many bytes of input.
pub(crate) fn check(elements: u64, bytes: u64) -> Result<(), Reason> {
    if elements <= ELEMENTS_ALWAYS.max(bytes.saturating_mul(ELEMENTS_PER_BYTE)) {
        return Ok(());
    }
    Err(Reason::OutOfProportion { elements, bytes })
}
