//! Regions: faces grown from a seed.
use crate::{Adjacency, Handle, Map, Topology, measure, relations};
use alloc::{collections::BTreeMap, vec::Vec};

mod stalactite;

pub use stalactite::{StalactiteOptions, stalactite};

/// A set of faces, and the vertices that they have: what [`grow`] and [`stalactite()`] give.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Region<F, V> {
    faces: Vec<F>,
    vertices: Vec<V>,
}

impl<F: Handle, V: Handle> Region<F, V> {
    /// The region of these faces, each given once. O(n log n).
    fn new<M: Topology<Face = F, Vertex = V> + ?Sized>(mesh: &M, faces: Vec<F>) -> Self {
        let mut vertices: Vec<V> = faces.iter().flat_map(|&f| mesh.face_vertices(f)).collect();
        vertices.sort_unstable();
        vertices.dedup();
        Self { faces, vertices }
    }

    /// The faces, each once, in the order in which they were reached.
    pub fn faces(&self) -> &[F] {
        &self.faces
    }

    /// The vertices of the faces, each once, ascending.
    pub fn vertices(&self) -> &[V] {
        &self.vertices
    }

    /// The area of the faces, in the unit of the positions squared. O(faces of the region).
    pub fn area<M>(&self, mesh: &M, positions: &Map<V, [f32; 3]>) -> f64
    where
        M: Topology<Face = F, Vertex = V> + ?Sized,
    {
        self.faces.iter().map(|&f| measure::face_area(mesh, positions, f)).sum()
    }

    /// The least and the largest coordinates. Of a region without faces, infinity and minus infinity: a box
    /// that has nothing in it. O(vertices of the region).
    pub fn bounding_box(&self, positions: &Map<V, [f32; 3]>) -> [[f32; 3]; 2] {
        let nothing = [[f32::INFINITY; 3], [f32::NEG_INFINITY; 3]];
        self.vertices.iter().map(|&v| positions[v]).fold(nothing, |[min, max], p| {
            [0, 1].map(|side| [0, 1, 2].map(|i| if side == 0 { min[i].min(p[i]) } else { max[i].max(p[i]) }))
        })
    }
}

/// The faces that are reached from seeds across edges, as far as a predicate lets them.
///
/// # Arguments
/// The first faces, which are in the region whatever the predicate says, and the predicate. It is asked
/// `admits(h, g)` for two half-edges along one edge, `h` of a face in the region and `g` of one that is not
/// yet: may the region go on from the one face to the other? It can be asked of one face from several sides,
/// until it says so.
///
/// # Returns
/// The region, breadth first. It goes on across edges of three and more faces, and across faces that disagree
/// in orientation, if it may.
///
/// # Complexity
/// O(n log n) in the faces of the region and in how often the predicate is asked: at most three times of a face, and at
/// an edge of three and more faces for each pair of one in the region and one that stays outside. One byte of scratch
/// for each face of the mesh, and a list of the faces along each such edge.
///
/// # Panics
/// If a seed is out of range.
///
/// # Example
/// ```
/// # use onering::CheL1 as Mesh;
/// use onering_core::{FaceId, FromFaces, Handle, Topology, region};
/// let strip = Mesh::from_faces(6, &[[0, 1, 2], [2, 1, 3], [2, 3, 4], [4, 3, 5]])?;
/// let seed = FaceId::new(0);
/// let region = region::grow(&strip, [seed], |_, g| strip.face(g) != FaceId::new(2));
/// assert_eq!(region.faces(), [FaceId::new(0), FaceId::new(1)]);
/// assert_eq!(region.vertices().len(), 4);
/// # Ok::<(), onering_core::BuildError>(())
/// ```
///
/// # Source
/// The growth by adjacency of Figueiredo et al. (2014), section 6.2, with the condition left to the caller.
pub fn grow<M: Adjacency + ?Sized>(
    mesh: &M,
    seeds: impl IntoIterator<Item = M::Face>,
    mut admits: impl FnMut(M::HalfEdge, M::HalfEdge) -> bool,
) -> Region<M::Face, M::Vertex> {
    let entry = |h, g| if admits(h, g) { Entry::Granted } else { Entry::RefusedFromHere };
    Region::new(mesh, grown(mesh, seeds, entry))
}

/// What becomes of a face across an edge from the region.
enum Entry {
    Granted,
    /// It may be asked about again, from another face along the edge.
    RefusedFromHere,
    /// Refused across this edge, whichever face of it asks.
    Refused,
}

/// The faces of [`grow`].
fn grown<M: Adjacency + ?Sized>(
    mesh: &M,
    seeds: impl IntoIterator<Item = M::Face>,
    mut entry: impl FnMut(M::HalfEdge, M::HalfEdge) -> Entry,
) -> Vec<M::Face> {
    let mut is_in: Map<M::Face, bool> = Map::filled(mesh.face_count(), false);
    let mut faces: Vec<M::Face> = Vec::new();
    for f in seeds {
        if !core::mem::replace(&mut is_in[f], true) {
            faces.push(f);
        }
    }
    // Of each edge of three and more faces, who may still be let in: were all its faces passed by from each of them,
    // their square would be the time.
    let mut outside: BTreeMap<M::HalfEdge, Vec<M::HalfEdge>> = BTreeMap::new();
    let mut next = 0;
    while let Some(&f) = faces.get(next) {
        next += 1;
        for h in mesh.face_half_edges(f) {
            let mut stays_outside = |g: M::HalfEdge| {
                if is_in[mesh.face(g)] {
                    return false;
                }
                let entry = entry(h, g);
                if matches!(entry, Entry::Granted) {
                    is_in[mesh.face(g)] = true;
                    faces.push(mesh.face(g));
                }
                matches!(entry, Entry::RefusedFromHere)
            };
            let mut others = mesh.edge_fan(h).skip(1);
            match (others.next(), others.next()) {
                (Some(g), None) => {
                    stays_outside(g);
                }
                (Some(_), Some(_)) => {
                    let fan = || mesh.edge_fan(h).collect();
                    let outside = outside.entry(relations::edge(mesh, h)).or_insert_with(fan);
                    outside.retain(|&g| stays_outside(g));
                }
                (None, _) => {}
            }
        }
    }
    faces
}
