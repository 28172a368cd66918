//! Normals of faces and vertices.
//!
//! A normal has length 1 and looks to the side from which the face is counter-clockwise. Where there is none to speak
//! of, the functions for one element say `None`, and the map for all vertices holds the zero vector: at an isolated
//! vertex, where all faces are degenerate, and where faces cancel each other out (a fold, or two that disagree in
//! orientation). Any mesh is taken: all faces of a vertex count, whatever fan they are in.
use crate::{
    Incidence, Map, NotFinite, Topology, not_finite,
    triangle::{self, Triangle},
    vector::{self, Vector},
};

/// How much the normal of a face counts at its vertices. A degenerate face has none, and counts nothing.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub enum Weight {
    /// By its area: the cheapest, and the least disturbed by thin faces.
    #[default]
    Area,
    /// By its angle at the vertex, so that the normal does not depend on how a flat part is cut into triangles:
    /// G. Thürmer and C. A. Wüthrich, *Computing vertex normals from polygonal facets*, Journal of Graphics Tools
    /// 3(1), 1998.
    Angle,
}

impl Weight {
    /// What the face adds to the normals of its corners.
    fn shares(self, triangle: Triangle) -> [Vector; 3] {
        let normal = triangle::normal(triangle);
        match self {
            Self::Area => [normal; 3],
            Self::Angle => {
                let normal = vector::direction(normal).unwrap_or_default();
                triangle::corners(triangle, triangle::angle).map(|angle| vector::times(angle, normal))
            }
        }
    }
}

/// The normal of one face.
///
/// # Arguments
/// `positions`: of all vertices.
///
/// # Returns
/// A vector of length 1; `None` where the corners are on a line, or one is infinite or no number.
///
/// # Complexity
/// O(1).
///
/// # Panics
/// If a position is missing.
///
/// # Example
/// ```
/// # use onering::CheL0 as Mesh;
/// use onering_core::{FaceId, FromFaces, Handle, normals};
/// let mesh = Mesh::from_faces(3, &[[0, 1, 2]])?;
/// let positions = vec![[0.0, 0.0, 1.0], [4.0, 0.0, 1.0], [0.0, 3.0, 1.0]].into();
/// assert_eq!(normals::face_normal(&mesh, &positions, FaceId::new(0)), Some([0.0, 0.0, 1.0]));
/// # Ok::<(), onering_core::BuildError>(())
/// ```
pub fn face_normal<M: Topology + ?Sized>(
    mesh: &M,
    positions: &Map<M::Vertex, [f32; 3]>,
    f: M::Face,
) -> Option<Vector> {
    vector::direction(triangle::normal(triangle::of(mesh, positions, f)))
}

/// The normal of one vertex.
///
/// # Arguments
/// `positions`: of all vertices. `weight`: how much each face counts.
///
/// # Returns
/// The direction of the weighted sum of the normals of all faces of `v`; `None` where that is zero, or a position is
/// infinite or no number.
///
/// # Complexity
/// O(degree).
///
/// # Panics
/// If a position is missing.
///
/// # Example
/// ```
/// # use onering::CheL2 as Mesh;
/// use onering_core::{FromFaces, Handle, VertexId, normals::{self, Weight}};
/// let mesh = Mesh::from_faces(4, &[[0, 1, 2]])?;
/// let positions = vec![[0.0, 0.0, 1.0], [4.0, 0.0, 1.0], [0.0, 3.0, 1.0], [0.0; 3]].into();
/// let normal = |v| normals::vertex_normal(&mesh, &positions, VertexId::new(v), Weight::Area);
/// assert_eq!((normal(0), normal(3)), (Some([0.0, 0.0, 1.0]), None));
/// # Ok::<(), onering_core::BuildError>(())
/// ```
///
/// # Source
/// See [`Weight`].
pub fn vertex_normal<M: Incidence + ?Sized>(
    mesh: &M,
    positions: &Map<M::Vertex, [f32; 3]>,
    v: M::Vertex,
    weight: Weight,
) -> Option<Vector> {
    let share = |h| {
        // From `v` on, so that its own share is the first.
        let corners = [h, mesh.next(h), mesh.prev(h)].map(|h| vector::of(positions[mesh.origin(h)]));
        weight.shares(corners)[0]
    };
    vector::direction(mesh.star(v).map(share).fold([0.0; 3], vector::plus))
}

/// The normals of all vertices, by one pass over the faces.
///
/// # Arguments
/// `positions`: of all vertices. `weight`: how much each face counts.
///
/// # Returns
/// For each vertex what [`vertex_normal`] gives, but for rounding, and zero where that is `None`.
///
/// # Complexity
/// O(vertices + faces); 24 bytes for each vertex, which are the result.
///
/// # Errors
/// [`NotFinite`]: a coordinate is infinite or no number. Panics if a position is missing.
///
/// # Example
/// ```
/// # use onering::CheL0 as Mesh;
/// use onering_core::{FromFaces, normals::{self, Weight}};
/// let mesh = Mesh::from_faces(4, &[[0, 1, 2]])?;
/// let positions = vec![[0.0, 0.0, 1.0], [4.0, 0.0, 1.0], [0.0, 3.0, 1.0], [0.0; 3]].into();
/// let normals = normals::vertex_normals(&mesh, &positions, Weight::Angle).unwrap();
/// assert_eq!(normals.as_slice()[2..], [[0.0, 0.0, 1.0], [0.0; 3]]);
/// # Ok::<(), onering_core::BuildError>(())
/// ```
///
/// # Source
/// See [`Weight`].
pub fn vertex_normals<M: Topology + ?Sized>(
    mesh: &M,
    positions: &Map<M::Vertex, [f32; 3]>,
    weight: Weight,
) -> Result<Map<M::Vertex, Vector>, NotFinite> {
    not_finite::positions(positions)?;
    let mut normals = summed(mesh, positions, |triangle| weight.shares(triangle));
    normals.iter_mut().for_each(|(_, sum)| *sum = vector::direction(*sum).unwrap_or_default());
    Ok(normals)
}

/// For each vertex, the sum of what each face has for that corner.
fn summed<M: Topology + ?Sized>(
    mesh: &M,
    positions: &Map<M::Vertex, [f32; 3]>,
    shares: impl Fn(Triangle) -> [Vector; 3],
) -> Map<M::Vertex, Vector> {
    let mut sums = Map::filled(mesh.vertex_count(), [0.0; 3]);
    for f in mesh.faces() {
        let shares = shares(triangle::of(mesh, positions, f));
        for (v, share) in mesh.face_vertices(f).into_iter().zip(shares) {
            sums[v] = vector::plus(sums[v], share);
        }
    }
    sums
}
