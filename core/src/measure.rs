//! Lengths, areas, the volume, and where a mesh lies. Sums are in `f64`.
//!
//! What is asked of one element is not checked: a position that is infinite or no number gives a result that is.
use crate::{
    Adjacency, Handle, Map, NotFinite, Topology, edges, not_finite, triangle,
    vector::{self, Vector},
};

/// The area of one face, in the square of the unit of the positions; 0 where its corners are on a line.
///
/// # Arguments
/// `positions`: of all vertices.
///
/// # Returns
/// Half the length of the cross product of two sides.
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
/// use onering_core::{FaceId, FromFaces, Handle, measure};
/// let mesh = Mesh::from_faces(3, &[[0, 1, 2]])?;
/// let positions = vec![[0.0, 0.0, 1.0], [4.0, 0.0, 1.0], [0.0, 3.0, 1.0]].into();
/// assert_eq!(measure::face_area(&mesh, &positions, FaceId::new(0)), 6.0);
/// # Ok::<(), onering_core::BuildError>(())
/// ```
pub fn face_area<M: Topology + ?Sized>(mesh: &M, positions: &Map<M::Vertex, [f32; 3]>, f: M::Face) -> f64 {
    triangle::area(triangle::of(mesh, positions, f))
}

/// The area of all faces, copies and both sides of folds included.
///
/// # Arguments
/// `positions`: of all vertices.
///
/// # Returns
/// The sum of [`face_area`] over the faces: 0 where there are none.
///
/// # Complexity
/// O(vertices + faces), without memory.
///
/// # Errors
/// [`NotFinite`]: a coordinate is infinite or no number. Panics if a position is missing.
///
/// # Example
/// ```
/// # use onering::CheL0 as Mesh;
/// use onering_core::{FromFaces, measure};
/// let square = Mesh::from_faces(4, &[[0, 1, 2], [0, 2, 3]])?;
/// let positions = vec![[0.0, 0.0, 0.0], [2.0, 0.0, 0.0], [2.0, 2.0, 0.0], [0.0, 2.0, 0.0]].into();
/// assert_eq!(measure::area(&square, &positions), Ok(4.0));
/// # Ok::<(), onering_core::BuildError>(())
/// ```
pub fn area<M: Topology + ?Sized>(mesh: &M, positions: &Map<M::Vertex, [f32; 3]>) -> Result<f64, NotFinite> {
    not_finite::positions(positions)?;
    Ok(mesh.faces().map(|f| face_area(mesh, positions, f)).sum())
}

/// The signed volume of the cones from the origin to all faces: the volume within, where the surface is closed and
/// its faces look outward, wherever the origin is.
///
/// It is summed from cones to a vertex of the mesh and moved to the origin after, which is the same number with
/// less lost: a small body far from the origin keeps its digits, as far as positions of `f32` have them.
///
/// # Arguments
/// `positions`: of all vertices.
///
/// # Returns
/// The volume, negative where faces look inward. Where the surface is open it depends on where the origin lies.
///
/// # Complexity
/// O(vertices + faces), without memory.
///
/// # Errors
/// [`NotFinite`]: a coordinate is infinite or no number. Panics if a position is missing.
///
/// # Example
/// ```
/// # use onering::CheL0 as Mesh;
/// use onering_core::{FromFaces, measure};
/// let corner = Mesh::from_faces(4, &[[0, 2, 1], [0, 1, 3], [1, 2, 3], [0, 3, 2]])?;
/// let positions = vec![[1.0, 1.0, 1.0], [2.0, 1.0, 1.0], [1.0, 2.0, 1.0], [1.0, 1.0, 2.0]].into();
/// assert_eq!(measure::signed_volume(&corner, &positions), Ok(1.0 / 6.0));
/// # Ok::<(), onering_core::BuildError>(())
/// ```
///
/// # Source
/// By the divergence theorem; C. Zhang and T. Chen, *Efficient feature extraction for 2D/3D objects in mesh
/// representation*, ICIP 2001.
pub fn signed_volume<M: Topology + ?Sized>(
    mesh: &M,
    positions: &Map<M::Vertex, [f32; 3]>,
) -> Result<f64, NotFinite> {
    not_finite::positions(positions)?;
    let Some(f) = mesh.faces().next() else { return Ok(0.0) };
    let [apex, ..] = triangle::of(mesh, positions, f);
    let (mut six_volumes, mut across) = (0.0, [0.0; 3]);
    for f in mesh.faces() {
        let triangle = triangle::of(mesh, positions, f);
        let normal = triangle::normal(triangle);
        six_volumes += vector::dot(vector::minus(triangle[0], apex), normal);
        across = vector::plus(across, normal);
    }
    // `across` is zero where the surface is closed.
    Ok((six_volumes + vector::dot(apex, across)) / 6.0)
}

/// The centre of mass of the surface, as a sheet of the same thickness everywhere.
///
/// # Arguments
/// `positions`: of all vertices.
///
/// # Returns
/// The mean of the middles of all faces, weighted by area; `None` where there is no area.
///
/// # Complexity
/// O(vertices + faces), without memory.
///
/// # Errors
/// [`NotFinite`]: a coordinate is infinite or no number. Panics if a position is missing.
///
/// # Example
/// ```
/// # use onering::CheL0 as Mesh;
/// use onering_core::{FromFaces, measure};
/// let mesh = Mesh::from_faces(3, &[[0, 1, 2]])?;
/// let positions = vec![[0.0, 0.0, 1.0], [3.0, 0.0, 1.0], [0.0, 6.0, 1.0]].into();
/// assert_eq!(measure::centroid(&mesh, &positions), Ok(Some([1.0, 2.0, 1.0])));
/// # Ok::<(), onering_core::BuildError>(())
/// ```
pub fn centroid<M: Topology + ?Sized>(
    mesh: &M,
    positions: &Map<M::Vertex, [f32; 3]>,
) -> Result<Option<Vector>, NotFinite> {
    not_finite::positions(positions)?;
    let (mut area, mut moment) = (0.0, [0.0; 3]);
    for f in mesh.faces() {
        let triangle @ [a, b, c] = triangle::of(mesh, positions, f);
        let of_face = triangle::area(triangle);
        area += of_face;
        moment = vector::plus(moment, vector::times(of_face / 3.0, vector::plus(vector::plus(a, b), c)));
    }
    Ok((area > 0.0).then(|| moment.map(|x| x / area)))
}

/// The least and the largest of each coordinate, over all vertices, isolated ones included.
///
/// # Arguments
/// `positions`: of all vertices, or of some.
///
/// # Returns
/// The two corners of the box; `None` where there are no positions.
///
/// # Complexity
/// O(vertices), without memory.
///
/// # Errors
/// [`NotFinite`]: a coordinate is infinite or no number.
///
/// # Example
/// ```
/// use onering_core::{Map, VertexId, measure};
/// let positions: Map<VertexId, _> = vec![[0.0, 5.0, 1.0], [3.0, 4.0, 1.0]].into();
/// assert_eq!(measure::bounding_box(&positions), Ok(Some([[0.0, 4.0, 1.0], [3.0, 5.0, 1.0]])));
/// ```
pub fn bounding_box<V: Handle>(positions: &Map<V, [f32; 3]>) -> Result<Option<[[f32; 3]; 2]>, NotFinite> {
    not_finite::positions(positions)?;
    let Some(&first) = positions.as_slice().first() else { return Ok(None) };
    let bound = |choose: fn(f32, f32) -> f32| {
        positions.as_slice().iter().fold(first, |a, b| [0, 1, 2].map(|i| choose(a[i], b[i])))
    };
    Ok(Some([bound(f32::min), bound(f32::max)]))
}

/// The length of the edge of one half-edge.
///
/// # Arguments
/// `positions`: of all vertices.
///
/// # Returns
/// The distance of its two ends.
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
/// use onering_core::{FromFaces, HalfEdgeId, Handle, measure};
/// let mesh = Mesh::from_faces(3, &[[0, 1, 2]])?;
/// let positions = vec![[0.0, 0.0, 1.0], [4.0, 0.0, 1.0], [0.0, 3.0, 1.0]].into();
/// assert_eq!(measure::edge_length(&mesh, &positions, HalfEdgeId::new(1)), 5.0);
/// # Ok::<(), onering_core::BuildError>(())
/// ```
pub fn edge_length<M: Topology + ?Sized>(
    mesh: &M,
    positions: &Map<M::Vertex, [f32; 3]>,
    h: M::HalfEdge,
) -> f64 {
    vector::length(vector::minus(
        vector::of(positions[mesh.target(h)]),
        vector::of(positions[mesh.origin(h)]),
    ))
}

/// The mean length of all edges, each counted once however many faces it has.
///
/// # Arguments
/// `positions`: of all vertices.
///
/// # Returns
/// The mean; `None` where there are no edges.
///
/// # Complexity
/// O(vertices + half-edges), without memory.
///
/// # Errors
/// [`NotFinite`]: a coordinate is infinite or no number. Panics if a position is missing.
///
/// # Example
/// ```
/// # use onering::CheL1 as Mesh;
/// use onering_core::{FromFaces, measure};
/// let mesh = Mesh::from_faces(3, &[[0, 1, 2]])?;
/// let positions = vec![[0.0, 0.0, 1.0], [4.0, 0.0, 1.0], [0.0, 3.0, 1.0]].into();
/// assert_eq!(measure::mean_edge_length(&mesh, &positions), Ok(Some(4.0)));
/// # Ok::<(), onering_core::BuildError>(())
/// ```
pub fn mean_edge_length<M: Adjacency + ?Sized>(
    mesh: &M,
    positions: &Map<M::Vertex, [f32; 3]>,
) -> Result<Option<f64>, NotFinite> {
    not_finite::positions(positions)?;
    let add = |(count, sum), h| (count + 1, sum + edge_length(mesh, positions, h));
    let (count, sum) = edges::each(mesh).fold((0_usize, 0.0), add);
    Ok((count > 0).then(|| sum / count as f64))
}
