//! What a list of triangles holds, defects and all: figures, names of the elements at fault, and a verdict.
//!
//! A face that names a vertex beyond the vertex count, or one vertex twice, is counted and otherwise left out.
//! Copies of a face stay in. Edges are undirected unless said otherwise.
//!
//! ```
//! use onering_core::defects::Defects;
//! let bowtie = Defects::of(5, &[[0, 1, 2], [0, 3, 4]])?;
//! assert_eq!((bowtie.components, bowtie.components_by_vertex, bowtie.boundary_loops), (2, 1, Some(2)));
//! assert_eq!(bowtie.lists.bowtie_vertices, [0]);
//! assert_eq!(bowtie.degrees.iter().collect::<Vec<_>>(), [(2, 4), (4, 1)]);
//! assert_eq!(bowtie.to_string(), "1 bowtie vertex");
//! # Ok::<(), onering_core::BuildError>(())
//! ```

mod boundary;
pub(crate) mod duplicates;
mod figures;
mod lists;
pub(crate) mod patches;
pub(crate) mod sheets;
pub(crate) mod triangles;
mod verdict;
mod vertices;

pub use figures::Figure;
pub use lists::DefectLists;
pub use triangles::MAX_FACES;
pub use verdict::Obstacle;

use crate::degrees::Degrees;
use crate::pairing::check_counts;
use crate::{BuildError, HalfEdgeId, Map, Topology, components, euler, umbrella};
use duplicates::Duplicates;
use lists::EdgeFaults;
use patches::Patches;
use sheets::Sheets;
use triangles::Triangles;
use vertices::Vertices;

/// The figures of a list of triangles, and the elements behind them in [`lists`](Self::lists).
#[derive(Clone, Debug, Default, PartialEq, Eq)]
#[non_exhaustive]
pub struct Defects {
    /// Faces that name a vertex beyond the vertex count; they are in no other figure.
    pub out_of_range_faces: usize,
    /// Faces that name a vertex twice; they are in no figure below.
    pub degenerate_faces: usize,
    /// Faces whose vertex set an earlier one has. They stay in all other figures.
    pub duplicate_faces: usize,
    /// Those of them that repeat the cyclic order of an earlier one.
    pub duplicate_faces_same_orientation: usize,
    /// Vertices in no face.
    pub isolated_vertices: usize,
    /// Undirected edges.
    pub edges: usize,
    /// Edges of exactly one face.
    pub boundary_edges: usize,
    /// Edges of three or more faces.
    pub nonmanifold_edges: usize,
    /// The most faces that an edge has.
    pub max_faces_per_edge: usize,
    /// Edges of exactly two faces that run the same way.
    pub inconsistent_edges: usize,
    /// Directed edges of two or more faces.
    pub repeated_halfedges: usize,
    /// Vertices of several fans: whose faces do not hang together by edges at the vertex.
    pub bowtie_vertices: usize,
    /// Vertices whose link is neither one path nor one cycle: bowties, and ends of edges of three or more faces.
    pub nonmanifold_vertices: usize,
    /// Components of the faces by shared edges.
    pub components: usize,
    /// Components of the faces by shared vertices.
    pub components_by_vertex: usize,
    /// V - E + F, without the isolated vertices.
    pub euler: i64,
    /// Components of the graph of the boundary edges.
    pub boundary_components: usize,
    /// Cycles of boundary edges, where fans are kept apart: a bowtie does not join two loops. `None` where a fan
    /// has other than 0 or 2 boundary edges, which only an edge of three or more faces can bring about.
    pub boundary_loops: Option<usize>,
    /// Components of the faces by edges of exactly two.
    pub patches: usize,
    /// Patches without a consistent orientation.
    pub nonorientable_patches: usize,
    /// Whether every patch has a consistent orientation.
    pub orientable: bool,
    /// The least number of faces to flip so that every orientable patch is consistent.
    pub min_flips: usize,
    /// Whether there are faces and no boundary edge.
    pub closed: bool,
    /// Whether there is no non-manifold vertex. Faces of either orientation may still meet.
    pub manifold: bool,
    /// The sum of the components' genera; only of what is manifold and orientable and has faces.
    pub genus: Option<usize>,
    /// The fewest edges at a vertex that is not isolated; 0 without faces.
    pub valence_min: usize,
    /// The most edges at a vertex.
    pub valence_max: usize,
    /// The most faces at a vertex.
    pub max_faces_per_vertex: usize,
    /// How many vertices have how many edges; 0 stands for the isolated ones.
    pub degrees: Degrees,
    /// The elements at fault, by name.
    pub lists: DefectLists,
}

impl Defects {
    /// Counts and names the defects of `faces` over the vertices `0..vertex_count`.
    ///
    /// Near-linear time and linear memory in the faces, whatever the vertex count.
    ///
    /// # Errors
    /// [`BuildError::OutOfMemory`], or [`BuildError::TooManyHalfEdges`] for more than [`MAX_FACES`] faces, a list of
    /// 17 GB; no list of faces is an error for what it holds.
    pub fn of(vertex_count: usize, faces: &[[u32; 3]]) -> Result<Self, BuildError> {
        // However many vertices: those that no face names take no memory, and have no handles.
        check_counts(0, faces.len(), 3 * MAX_FACES)?;
        let sheets = Sheets::join(Triangles::sift(vertex_count, faces)?)?;
        let mut defects = Self::default();
        defects.add_duplicates(&sheets)?;
        defects.add_edges(&sheets)?;
        let umbrella = umbrella::joined_by(&sheets, sheets.couples())?;
        defects.add_vertices(vertex_count, Vertices::of(&sheets, &umbrella)?, &sheets)?;
        defects.add_boundary(&sheets, &umbrella)?;
        drop(umbrella);
        defects.add_patches(&sheets)?;
        defects.add_surface(&sheets)?;
        let Triangles { out_of_range, degenerate, .. } = sheets.triangles;
        defects.out_of_range_faces = out_of_range.len();
        defects.degenerate_faces = degenerate.len();
        defects.lists.out_of_range_faces = out_of_range;
        defects.lists.degenerate_faces = degenerate;
        Ok(defects)
    }

    fn add_duplicates(&mut self, sheets: &Sheets) -> Result<(), BuildError> {
        let found = Duplicates::find(sheets)?;
        self.duplicate_faces = found.copies.len();
        self.duplicate_faces_same_orientation = found.same_orientation;
        self.lists.duplicate_faces = sheets.triangles.sources(&found.copies)?;
        Ok(())
    }

    fn add_edges(&mut self, sheets: &Sheets) -> Result<(), BuildError> {
        let faults = EdgeFaults::of(sheets)?;
        self.edges = sheets.edges().count();
        self.boundary_edges = sheets.alone().count();
        self.max_faces_per_edge = sheets.max_faces_per_edge();
        self.nonmanifold_edges = faults.nonmanifold.len();
        self.inconsistent_edges = faults.inconsistent.len();
        self.repeated_halfedges = faults.repeated.len();
        self.lists.nonmanifold_edges = faults.nonmanifold;
        self.lists.inconsistent_edges = faults.inconsistent;
        self.lists.repeated_halfedges = faults.repeated;
        Ok(())
    }

    fn add_vertices(
        &mut self,
        vertex_count: usize,
        vertices: Vertices,
        sheets: &Sheets,
    ) -> Result<(), BuildError> {
        let used = vertices.valence.as_slice().iter().filter(|&&n| n > 0);
        let used_count = used.clone().count();
        self.isolated_vertices = vertex_count - used_count;
        self.euler = used_count as i64 - self.edges as i64 + sheets.face_count() as i64;
        self.bowtie_vertices = vertices.bowties.len();
        self.nonmanifold_vertices = vertices.nonmanifold.len();
        self.manifold = vertices.nonmanifold.is_empty();
        self.degrees = Degrees::of(self.isolated_vertices, used.map(|&n| n as usize))?;
        self.valence_min = self.degrees.min().unwrap_or(0);
        self.valence_max = self.degrees.max().unwrap_or(0);
        self.max_faces_per_vertex = vertices.max_faces;
        self.lists.isolated_vertices = sheets.triangles.unused(vertex_count, |v| vertices.valence[v] > 0)?;
        self.lists.bowtie_vertices = vertices.bowties;
        self.lists.nonmanifold_vertices = vertices.nonmanifold;
        Ok(())
    }

    fn add_boundary(
        &mut self,
        sheets: &Sheets,
        umbrella: &Map<HalfEdgeId, HalfEdgeId>,
    ) -> Result<(), BuildError> {
        self.boundary_components = boundary::components(sheets)?;
        self.boundary_loops = boundary::loops(sheets, umbrella)?;
        self.closed = self.boundary_edges == 0 && sheets.face_count() > 0;
        Ok(())
    }

    fn add_patches(&mut self, sheets: &Sheets) -> Result<(), BuildError> {
        let patches = Patches::of(sheets)?;
        self.patches = patches.count;
        self.min_flips = patches.min_flips;
        self.nonorientable_patches = patches.nonorientable.len();
        self.orientable = patches.nonorientable.is_empty();
        self.lists.nonorientable_patches = sheets.triangles.sources(&patches.nonorientable)?;
        Ok(())
    }

    fn add_surface(&mut self, sheets: &Sheets) -> Result<(), BuildError> {
        self.components = components::joined_by(sheets, sheets.couples())?.count();
        self.components_by_vertex = components::joined_by_vertices(sheets)?.count();
        if self.manifold && self.orientable && sheets.face_count() > 0 {
            let genus = |loops| euler::genus_of(self.components, loops, self.euler as isize);
            self.genus = self.boundary_loops.and_then(genus);
        }
        Ok(())
    }
}
