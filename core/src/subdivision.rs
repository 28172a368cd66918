//! Finer triangles: Loop and midpoint subdivision, each face into four.
//!
//! Both give the same [`faces`](Subdivided::faces), and differ in where they put the vertices. What is a manifold stays
//! one, with one exception: faces over the same three vertices share their new vertices too, so that each edge between
//! these gets two faces from each. [`repair`](crate::repair()) drops such copies.
use crate::{Adjacency, BuildError, Handle, Map, NotFinite, edges, memory, not_finite, pairing, vector};
use alloc::vec::Vec;
use core::fmt;

mod rule;

use rule::Rules;

/// A mesh with four faces for each one before: what [`midpoint`] and [`loop_subdivision`] give.
#[derive(Clone, Debug, Default, PartialEq)]
#[non_exhaustive]
pub struct Subdivided {
    /// How many vertices there are: the old ones, then one for each edge.
    pub vertex_count: usize,
    /// Four for each old face, in its order: at its first, second and third corner, then the middle. Corner `k` of the
    /// first three is at the same place as in the old face.
    pub faces: Vec<[u32; 3]>,
    /// One position for each vertex.
    pub positions: Vec<[f32; 3]>,
    /// The two old vertices that each new vertex lies between, in the order of [`edges::each`].
    pub edge_vertices: Vec<[u32; 2]>,
}

impl Subdivided {
    /// The old face that new face `f` is a part of.
    pub fn face_source(&self, f: usize) -> usize {
        f / 4
    }

    /// The values of the old vertices, followed by those of the new ones, each made of those at the ends of its
    /// edge. O(vertices).
    ///
    /// # Panics
    /// If `values` has fewer than there were vertices.
    pub fn carry_vertices<T: Clone>(&self, values: &[T], between: impl Fn(&T, &T) -> T) -> Vec<T> {
        let old = self.vertex_count - self.edge_vertices.len();
        let new = self.edge_vertices.iter().map(|&[a, b]| between(&values[a as usize], &values[b as usize]));
        values[..old].iter().cloned().chain(new).collect()
    }

    /// The values of the old faces for the new ones. O(faces).
    pub fn carry_faces<T: Clone>(&self, values: &[T]) -> Vec<T> {
        values.iter().flat_map(|value| core::iter::repeat_n(value.clone(), 4)).collect()
    }
}

/// Why a mesh could not be divided.
#[derive(Clone, Debug, PartialEq, Eq)]
#[non_exhaustive]
pub enum SubdivisionError {
    /// More vertices or half-edges than handles can name would come out, or no memory for them.
    Limit(BuildError),
    /// A position is infinite or no number.
    NotFinite(NotFinite),
}

impl From<BuildError> for SubdivisionError {
    fn from(error: BuildError) -> Self {
        Self::Limit(error)
    }
}

impl From<NotFinite> for SubdivisionError {
    fn from(error: NotFinite) -> Self {
        Self::NotFinite(error)
    }
}

impl fmt::Display for SubdivisionError {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            Self::Limit(error) => error.fmt(f),
            Self::NotFinite(error) => error.fmt(f),
        }
    }
}

impl core::error::Error for SubdivisionError {}

/// Divides each face into four at the middles of its edges. The surface stays what it is.
///
/// # Arguments
/// Any mesh: all faces of an edge, however many, share its new vertex, and isolated vertices stay. `positions` has one
/// for each vertex.
///
/// # Returns
/// The faces, the positions, and where they come from: see [`Subdivided`].
///
/// # Complexity
/// O(vertices + faces); 4 bytes of scratch for each half-edge and each edge.
///
/// # Errors
/// [`SubdivisionError`], before memory is taken.
///
/// # Panics
/// If `positions` has fewer than there are vertices.
///
/// # Example
/// ```
/// # use onering::CheL1 as Mesh;
/// use onering_core::{FromFaces, subdivision};
/// let triangle = Mesh::from_faces(3, &[[0, 1, 2]])?;
/// let positions = vec![[0.0, 0.0, 0.0], [2.0, 0.0, 0.0], [0.0, 2.0, 0.0]].into();
/// let finer = subdivision::midpoint(&triangle, &positions)?;
/// assert_eq!(finer.faces, [[0, 3, 5], [3, 1, 4], [5, 4, 2], [3, 4, 5]]);
/// assert_eq!(finer.positions[4], [1.0, 1.0, 0.0]);
/// # Ok::<(), Box<dyn std::error::Error>>(())
/// ```
///
/// # Source
/// Standard; the first step of every scheme that divides triangles into four.
pub fn midpoint<M: Adjacency + ?Sized>(
    mesh: &M,
    positions: &Map<M::Vertex, [f32; 3]>,
) -> Result<Subdivided, SubdivisionError> {
    check(mesh, positions)?;
    let mut divided = divide(mesh)?;
    let middle = |a: &[f32; 3], b: &[f32; 3]| {
        vector::rounded(vector::times(0.5, vector::plus(vector::of(*a), vector::of(*b))))
    };
    divided.positions = divided.carry_vertices(positions.as_slice(), middle);
    Ok(divided)
}

/// Divides each face into four and smooths: repeated, the surface approaches one that is twice continuously
/// differentiable but at vertices of other than six neighbours, where its tangent plane is continuous.
///
/// With `a`, `b` the ends of an edge and `c`, `d` the far vertices of its two faces, the edge's new vertex is at
/// `3/8 (a + b) + 1/8 (c + d)`. A vertex of `n` neighbours moves to `(1 - n w) v + w (sum of neighbours)`, `w =
/// (5/8 - (3/8 + cos(2 pi / n) / 4)^2) / n`: Loop's own weights, not Warren's.
///
/// An edge that has not two faces (on the boundary, or three and more) is a crease: its new vertex is its middle, and a
/// vertex on two creases goes to `1/8 a + 3/4 v + 1/8 b`, so that a crease becomes a cubic B-spline, whatever lies
/// beside it. A vertex on one crease or on more than two, and one whose faces hang together in several
/// [umbrellas](crate::umbrella), is a corner and stays where it is; so do isolated ones. Orientation is not asked for.
///
/// # Arguments
/// Any mesh; `positions` has one for each vertex.
///
/// # Returns
/// The faces, the positions, and where they come from: see [`Subdivided`].
///
/// # Complexity
/// O(vertices + faces), but for nearly linear umbrellas; 16 bytes of scratch for each half-edge and 64 for each vertex.
///
/// # Errors
/// [`SubdivisionError`], counts before memory is taken.
///
/// # Panics
/// If `positions` has fewer than there are vertices.
///
/// # Example
/// ```
/// # use onering::CheL1 as Mesh;
/// use onering_core::{FromFaces, subdivision};
/// let octahedron =
///     [[0, 2, 4], [2, 1, 4], [1, 3, 4], [3, 0, 4], [2, 0, 5], [1, 2, 5], [3, 1, 5], [0, 3, 5]];
/// let [x, y, z] = [[1.0, 0.0, 0.0], [0.0, 1.0, 0.0], [0.0, 0.0, 1.0]];
/// let positions = vec![x, x.map(|c| -c), y, y.map(|c| -c), z, z.map(|c| -c)].into();
/// let finer = subdivision::loop_subdivision(&Mesh::from_faces(6, &octahedron)?, &positions)?;
/// assert_eq!((finer.vertex_count, finer.faces.len()), (18, 32));
/// assert_eq!(finer.positions[0], [0.515625, 0.0, 0.0]); // 1 - 4 w, with w = (5/8 - 9/64) / 4
/// # Ok::<(), Box<dyn std::error::Error>>(())
/// ```
///
/// # Source
/// Loop, "Smooth subdivision surfaces based on triangles", thesis, University of Utah, 1987; creases and corners after
/// Hoppe, DeRose, Duchamp, Halstead, Jin, McDonald, Schweitzer, Stuetzle, "Piecewise smooth surface reconstruction",
/// SIGGRAPH 1994.
pub fn loop_subdivision<M: Adjacency + ?Sized>(
    mesh: &M,
    positions: &Map<M::Vertex, [f32; 3]>,
) -> Result<Subdivided, SubdivisionError> {
    check(mesh, positions)?;
    let mut divided = divide(mesh)?;
    let mut rules = Rules::of(mesh)?;
    let mut moved: Vec<[f32; 3]> = memory::with_room(divided.vertex_count)?;
    moved.resize(mesh.vertex_count(), [0.0; 3]);
    for h in edges::each(mesh) {
        moved.push(vector::rounded(rules.add_edge(mesh, positions, h)));
    }
    for v in mesh.vertices() {
        moved[v.index()] = vector::rounded(rules.moved(v, vector::of(positions[v])));
    }
    divided.positions = moved;
    Ok(divided)
}

fn check<M: Adjacency + ?Sized>(
    mesh: &M,
    positions: &Map<M::Vertex, [f32; 3]>,
) -> Result<(), SubdivisionError> {
    const LIMIT: usize = u32::MAX as usize - 1;
    let vertices = mesh.vertex_count().saturating_add(edges::edge_count(mesh));
    pairing::check_counts(vertices, mesh.face_count().saturating_mul(4), LIMIT)?;
    Ok(not_finite::positions(positions)?)
}

/// The faces over the old and the new vertices, without positions.
fn divide<M: Adjacency + ?Sized>(mesh: &M) -> Result<Subdivided, BuildError> {
    let old = mesh.vertex_count() as u32;
    let edges = edges::edge_map(mesh);
    let number = |v: M::Vertex| v.index() as u32;
    let ends = |h| [number(mesh.origin(h)), number(mesh.target(h))];
    let edge_vertices = memory::collected(edges.iter().map(|(_, h)| ends(h)))?;
    let mut faces = memory::with_room(4 * mesh.face_count())?;
    for f in mesh.faces() {
        let [a, b, c] = mesh.face_vertices(f).map(number);
        let [ab, bc, ca] = mesh.face_half_edges(f).map(|h| old + edges.edge(h).index() as u32);
        faces.extend([[a, ab, ca], [ab, b, bc], [ca, bc, c], [ab, bc, ca]]);
    }
    let vertex_count = mesh.vertex_count() + edge_vertices.len();
    Ok(Subdivided { vertex_count, faces, positions: Vec::new(), edge_vertices })
}
