//! The kind of a vertex, by which part of its link is lower.
//!
//! All vertices are in one strict order, by value and then by index. With it, adding vertices from the lowest
//! up with the edges and faces to lower ones, each edge and each face comes with its highest vertex: so the
//! indices sum to the Euler characteristic on any mesh at all.
use crate::{Handle, Incidence, Map, NotFinite, not_finite, star};
use alloc::vec::Vec;

/// What a vertex is to a field.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub enum Kind {
    /// It has no neighbours.
    Isolated,
    /// The surface goes down on one side and up on the other.
    Regular,
    /// All neighbours are higher.
    Minimum,
    /// All neighbours are lower.
    Maximum,
    /// Passes meet: the lower part of its link has more than one piece.
    Saddle {
        /// Number of pieces but one: 1 for a pass between two hills, 2 for a monkey saddle.
        multiplicity: usize,
    },
}

/// Number of pieces that vertex `v` adds to what is lower, less the number of passes that it closes: 1 for a
/// minimum and for a maximum inside the surface, minus the multiplicity for a saddle, 0 for a regular vertex.
///
/// # Arguments
/// A value for each vertex, and a vertex. Of two vertices of one value, that of the lower index is lower.
///
/// # Returns
/// 1 - (lower neighbours) + (edges of the link with both ends lower). Summed over all vertices that are not
/// isolated, this is the [Euler characteristic](crate::euler::euler_characteristic) of any mesh, manifold or
/// not. A maximum on the boundary has 0: what is lower only grows there. An isolated vertex has 1.
///
/// # Complexity
/// O(degree).
///
/// # Panics
/// If `field` is shorter than the list of vertices, or `v` out of range. Values that are no number are not
/// looked for.
///
/// # Example
/// ```
/// # use onering::CheL2 as Mesh;
/// use onering_core::{FromFaces, Map, Topology, critical};
/// let tetrahedron = Mesh::from_faces(4, &[[0, 1, 2], [0, 3, 1], [0, 2, 3], [1, 3, 2]])?;
/// let field = Map::from(vec![0.0, 1.0, 2.0, 3.0]);
/// let indices = tetrahedron.vertices().map(|v| critical::index(&tetrahedron, &field, v));
/// assert_eq!(indices.collect::<Vec<_>>(), [1, 0, 0, 1]);
/// # Ok::<(), onering_core::BuildError>(())
/// ```
///
/// # Source
/// Banchoff, "Critical points and curvature for embedded polyhedra" (1967).
pub fn index<M: Incidence + ?Sized>(mesh: &M, field: &Map<M::Vertex, f32>, v: M::Vertex) -> isize {
    let is_lower = |u| is_lower(field, u, v);
    let vertices = mesh.neighbours(v).filter(|&u| is_lower(u)).count();
    let edges = star::link(mesh, v).filter(|&h| is_lower(mesh.origin(h)) && is_lower(mesh.target(h))).count();
    1 - vertices as isize + edges as isize
}

/// Whether `u` comes before `v`.
fn is_lower<V: Handle>(field: &Map<V, f32>, u: V, v: V) -> bool {
    field[u] < field[v] || field[u] == field[v] && u < v
}

/// The kind of every vertex.
///
/// # Arguments
/// A value for each vertex. Of two vertices of one value, that of the lower index is lower.
///
/// # Returns
/// The kinds. On a closed manifold, minima - saddles (each by its multiplicity) + maxima is the Euler
/// characteristic; with a boundary, that holds where the maxima on the boundary are left out. There the lower
/// part of the link decides what is a saddle, so the saddles of a field and of its negative can differ. Where
/// the mesh is no manifold, a vertex that has neighbours on both sides is a saddle where its [`index`] is
/// negative, and else regular.
///
/// # Complexity
/// O(half-edges).
///
/// # Errors
/// [`NotFinite`] where a value is infinite or no number.
///
/// # Panics
/// If `field` is shorter than the list of vertices.
///
/// # Example
/// ```
/// # use onering::CheL2 as Mesh;
/// use onering_core::{FromFaces, Map, critical::{self, Kind}};
/// // Down, up, down, up around vertex 0.
/// let wheel = Mesh::from_faces(5, &[[0, 1, 2], [0, 2, 3], [0, 3, 4], [0, 4, 1]])?;
/// let kinds = critical::classify(&wheel, &Map::from(vec![0.0, -1.0, 1.0, -1.0, 1.0]))?;
/// assert_eq!(kinds.as_slice()[0], Kind::Saddle { multiplicity: 1 });
/// # Ok::<(), Box<dyn std::error::Error>>(())
/// ```
///
/// # Source
/// Banchoff (1967), as for [`index`]; the order of Edelsbrunner, Harer and Zomorodian (2003).
pub fn classify<M: Incidence + ?Sized>(
    mesh: &M,
    field: &Map<M::Vertex, f32>,
) -> Result<Map<M::Vertex, Kind>, NotFinite> {
    not_finite::values(field)?;
    Ok(mesh.vertices().map(|v| kind(mesh, field, v)).collect())
}

fn kind<M: Incidence + ?Sized>(mesh: &M, field: &Map<M::Vertex, f32>, v: M::Vertex) -> Kind {
    let (mut has_lower, mut has_higher) = (false, false);
    for u in mesh.neighbours(v) {
        *(if is_lower(field, u, v) { &mut has_lower } else { &mut has_higher }) = true;
    }
    match (has_lower, has_higher) {
        (false, false) => Kind::Isolated,
        (false, true) => Kind::Minimum,
        (true, false) => Kind::Maximum,
        (true, true) => match index(mesh, field, v) {
            index if index < 0 => Kind::Saddle { multiplicity: index.unsigned_abs() },
            _ => Kind::Regular,
        },
    }
}

/// The saddles of a field, each with its multiplicity.
///
/// # Arguments
/// A value for each vertex. Of two vertices of one value, that of the lower index is lower.
///
/// # Returns
/// The vertices that [`classify`] calls saddles, ascending.
///
/// # Complexity
/// O(half-edges), without scratch.
///
/// # Errors
/// [`NotFinite`] where a value is infinite or no number.
///
/// # Panics
/// If `field` is shorter than the list of vertices.
///
/// # Example
/// ```
/// # use onering::CheL2 as Mesh;
/// use onering_core::{FromFaces, Map, critical};
/// let wheel = Mesh::from_faces(5, &[[0, 1, 2], [0, 2, 3], [0, 3, 4], [0, 4, 1]])?;
/// let saddles = critical::saddles(&wheel, &Map::from(vec![0.0, -1.0, 1.0, -1.0, 1.0]))?;
/// assert_eq!(format!("{saddles:?}"), "[(v0, 1)]");
/// # Ok::<(), Box<dyn std::error::Error>>(())
/// ```
///
/// # Source
/// As for [`classify`].
pub fn saddles<M: Incidence + ?Sized>(
    mesh: &M,
    field: &Map<M::Vertex, f32>,
) -> Result<Vec<(M::Vertex, usize)>, NotFinite> {
    not_finite::values(field)?;
    let saddle = |v| match kind(mesh, field, v) {
        Kind::Saddle { multiplicity } => Some((v, multiplicity)),
        _ => None,
    };
    Ok(mesh.vertices().filter_map(saddle).collect())
}
