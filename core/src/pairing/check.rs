//! What is looked at before anything is built.
use crate::BuildError;

/// Whether there are handles for so many vertices and faces. `limit` is the most half-edges that the links of a
/// backend can name: 2^32 - 2 for plain links, 2^31 - 1 for coded ones.
///
/// # Errors
/// [`BuildError::TooManyVertices`], [`BuildError::TooManyHalfEdges`].
pub fn check_counts(vertex_count: usize, face_count: usize, limit: usize) -> Result<(), BuildError> {
    const MAX_VERTICES: usize = u32::MAX as usize;
    if vertex_count > MAX_VERTICES {
        return Err(BuildError::TooManyVertices { vertices: vertex_count, limit: MAX_VERTICES });
    }
    let half_edges = face_count.saturating_mul(3);
    if half_edges > limit {
        return Err(BuildError::TooManyHalfEdges { half_edges, limit });
    }
    Ok(())
}

/// Whether every face names three vertices that exist.
///
/// # Errors
/// [`BuildError::VertexOutOfRange`] for the lowest face that does not.
pub fn check_vertices(vertex_count: usize, faces: &[[u32; 3]]) -> Result<(), BuildError> {
    let largest = faces.as_flattened().iter().copied().max();
    if largest.is_none_or(|v| (v as usize) < vertex_count) {
        return Ok(());
    }
    let errors = faces.iter().enumerate().find_map(|(face, f)| out_of_range(face, f, vertex_count));
    errors.map_or(Ok(()), Err)
}

/// Whether every face names three different vertices that exist.
///
/// # Errors
/// [`BuildError::VertexOutOfRange`] or [`BuildError::DegenerateFace`] for the lowest face that does not.
pub fn check_faces(vertex_count: usize, faces: &[[u32; 3]]) -> Result<(), BuildError> {
    // One comparison for all three: the loop runs without a branch until something is wrong.
    let is_good = |f: &[u32; 3]| {
        let [a, b, c] = *f;
        (a.max(b).max(c) as usize) < vertex_count && (a != b) & (b != c) & (c != a)
    };
    let Some(face) = faces.iter().position(|f| !is_good(f)) else { return Ok(()) };
    let [a, b, c] = faces[face];
    let twice = if a == b || a == c { a } else { b };
    let degenerate = BuildError::DegenerateFace { face, vertex: twice };
    Err(out_of_range(face, &[a, b, c], vertex_count).unwrap_or(degenerate))
}

fn out_of_range(face: usize, vertices: &[u32; 3], vertex_count: usize) -> Option<BuildError> {
    let vertex = *vertices.iter().find(|&&v| v as usize >= vertex_count)?;
    Some(BuildError::VertexOutOfRange { face, vertex, vertex_count })
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn counts_are_checked_at_the_limit_of_each_coding() {
        let plain = u32::MAX as usize - 1;
        let coded = i32::MAX as usize;
        assert_eq!(check_counts(u32::MAX as usize, plain / 3, plain), Ok(()));
        assert_eq!(check_counts(0, coded / 3, coded), Ok(()));
        let half_edges = 3 * (coded / 3 + 1);
        assert_eq!(
            check_counts(0, coded / 3 + 1, coded),
            Err(BuildError::TooManyHalfEdges { half_edges, limit: coded })
        );
        assert!(check_counts(0, plain / 3 + 1, plain).is_err());
        assert!(check_counts(0, usize::MAX, plain).is_err());
        assert!(matches!(
            check_counts(u32::MAX as usize + 1, 0, plain),
            Err(BuildError::TooManyVertices { .. })
        ));
    }

    #[test]
    fn the_lowest_face_at_fault_is_named() {
        let faces = [[0, 1, 2], [1, 1, 2], [0, 1, 9]];
        assert_eq!(check_faces(3, &faces), Err(BuildError::DegenerateFace { face: 1, vertex: 1 }));
        let out_of_range = BuildError::VertexOutOfRange { face: 2, vertex: 9, vertex_count: 3 };
        assert_eq!(check_vertices(3, &faces), Err(out_of_range));
        assert_eq!(check_vertices(10, &faces), Ok(()));
    }
}
