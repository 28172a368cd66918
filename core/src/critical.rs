//! Minima, maxima and saddles of a scalar field.
//!
//! There are two readings of a field that has the same value at neighbours:
//!
//! - [`local_minima`] and [`local_maxima`] take a *plateau*, the vertices of one value that edges between them
//!   connect, as one: it is a minimum where no neighbour of it is lower, and its least vertex stands for it. A
//!   vertex without a neighbour of its value is a plateau of one.
//! - [`classify`], [`saddles`] and [`index`] take the vertex of the lower index as the lower of two of one
//!   value, so that there are no plateaus at all, and the figures add up to the Euler characteristic. On a
//!   plateau, that can make several minima, with saddles between them.
//!
//! Where no two neighbours have one value, both find the same minima and maxima. An isolated vertex is on no
//! surface, and is neither.
use crate::{Incidence, Map, NotFinite, not_finite, region, vector};
use alloc::vec::Vec;

mod link;
mod plateaus;

pub use link::{Kind, classify, index, saddles};

/// The local minima of a field: one vertex for each plateau that no neighbour is lower than.
///
/// # Arguments
/// A value for each vertex.
///
/// # Returns
/// The vertices, ascending. A boundary vertex is compared with the neighbours that it has. A plateau that is a
/// whole component is both a minimum and a maximum.
///
/// # Complexity
/// O(half-edges): the walk around a vertex ends at the first lower neighbour. One byte of scratch for each
/// vertex where some plateau has several vertices, and 4 for each that a flood of one reaches.
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
/// let strip = Mesh::from_faces(6, &[[0, 1, 2], [2, 1, 3], [2, 3, 4], [4, 3, 5]])?;
/// let minima = critical::local_minima(&strip, &Map::from(vec![5.0, 1.0, 1.0, 4.0, 3.0, 2.0]))?;
/// assert_eq!(format!("{minima:?}"), "[v1, v5]");
/// # Ok::<(), Box<dyn std::error::Error>>(())
/// ```
///
/// # Source
/// Figueiredo et al. (2014), section 6.1, where plateaus are not spoken of.
pub fn local_minima<M: Incidence + ?Sized>(
    mesh: &M,
    field: &Map<M::Vertex, f32>,
) -> Result<Vec<M::Vertex>, NotFinite> {
    not_finite::values(field)?;
    Ok(plateaus::extrema(mesh, |v, u| field[u] < field[v]))
}

/// The local maxima of a field: the minima of its negative.
///
/// # Arguments
/// A value for each vertex.
///
/// # Returns
/// The vertices, ascending, as [`local_minima`] gives them.
///
/// # Complexity
/// As for [`local_minima`].
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
/// let mesh = Mesh::from_faces(4, &[[0, 1, 2], [0, 2, 3]])?;
/// let maxima = critical::local_maxima(&mesh, &Map::from(vec![0.0, 2.0, 1.0, 2.0]))?;
/// assert_eq!(format!("{maxima:?}"), "[v1, v3]");
/// # Ok::<(), Box<dyn std::error::Error>>(())
/// ```
///
/// # Source
/// As for [`local_minima`].
pub fn local_maxima<M: Incidence + ?Sized>(
    mesh: &M,
    field: &Map<M::Vertex, f32>,
) -> Result<Vec<M::Vertex>, NotFinite> {
    not_finite::values(field)?;
    Ok(plateaus::extrema(mesh, |v, u| field[u] > field[v]))
}

/// The extremities of stalactites: the vertices that no neighbour is lower than, where the surface faces down.
///
/// # Arguments
/// The positions, z up, of a surface whose faces are counter-clockwise as seen from inside the cave.
///
/// # Returns
/// The vertices, ascending. The normal at a vertex is the sum of those of its faces, each as long as its area,
/// and points down where its z is negative. As in the paper, every vertex of a plateau is one where both hold
/// for it: [`local_minima`] of the heights has one for each plateau.
///
/// # Complexity
/// O(half-edges), without scratch.
///
/// # Errors
/// [`NotFinite`] where a coordinate is infinite or no number.
///
/// # Panics
/// If `positions` is shorter than the list of vertices.
///
/// # Example
/// ```
/// # use onering::CheL2 as Mesh;
/// use onering_core::{FromFaces, Map, critical};
/// // A pyramid that hangs from its square, seen from below.
/// let mesh = Mesh::from_faces(5, &[[1, 0, 4], [2, 1, 4], [3, 2, 4], [0, 3, 4]])?;
/// let corners = [[0.0, 0.0, 0.0], [1.0, 0.0, 0.0], [1.0, 1.0, 0.0], [0.0, 1.0, 0.0], [0.5, 0.5, -1.0]];
/// let tips = critical::stalactite_tips(&mesh, &Map::from(corners.to_vec()))?;
/// assert_eq!(format!("{tips:?}"), "[v4]");
/// # Ok::<(), Box<dyn std::error::Error>>(())
/// ```
///
/// # Source
/// Figueiredo et al. (2014), section 6.1, Algorithm 2.
pub fn stalactite_tips<M: Incidence + ?Sized>(
    mesh: &M,
    positions: &Map<M::Vertex, [f32; 3]>,
) -> Result<Vec<M::Vertex>, NotFinite> {
    not_finite::positions(positions)?;
    let is_lowest = |v| mesh.neighbours(v).all(|u| positions[v][2] <= positions[u][2]);
    let is_tip = |&v: &M::Vertex| is_lowest(v) && normal(mesh, positions, v)[2] < 0.0;
    Ok(mesh.vertices().filter(is_tip).collect())
}

/// The sum of the normals of the faces of `v`, each twice as long as its area.
fn normal<M: Incidence + ?Sized>(
    mesh: &M,
    positions: &Map<M::Vertex, [f32; 3]>,
    v: M::Vertex,
) -> vector::Vector {
    mesh.star(v).map(|h| region::normal(mesh, positions, mesh.face(h))).fold([0.0; 3], vector::plus)
}
