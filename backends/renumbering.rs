//! [`Renumbering`]: the maps to a structure that numbers vertices and faces anew.
use alloc::vec::Vec;
use onering_core::{HalfEdgeId, Handle, Topology};

/// The maps between the numbers of a list of faces and those of a structure that renumbers: what
/// [`Sot::encode`](crate::Sot::encode) and [`CompactStars::encode`](crate::CompactStars::encode) give beside it.
#[derive(Clone, Debug, Default, PartialEq, Eq)]
#[non_exhaustive]
pub struct Renumbering {
    /// For each vertex of the structure the one of the list that it was.
    pub vertex_source: Vec<u32>,
    /// For each vertex of the list the one of the structure that it is now.
    pub vertex_target: Vec<u32>,
    /// For each face of the structure the one of the list that it was.
    pub face_source: Vec<u32>,
    /// For each face of the structure the corner (0, 1 or 2) of the list's face that is now its first: by how many it
    /// was turned to the left.
    pub first_corner: Vec<u8>,
}

impl Renumbering {
    /// The values of the list's vertices (positions, colours, ...) in the order of the structure. O(vertices).
    ///
    /// # Panics
    /// If `values` has fewer than there are vertices.
    pub fn carry_vertices<T: Clone>(&self, values: &[T]) -> Vec<T> {
        self.vertex_source.iter().map(|&v| values[v as usize].clone()).collect()
    }

    /// The values of the list's faces in the order of the structure. O(faces).
    ///
    /// # Panics
    /// If `values` has fewer than there are faces.
    pub fn carry_faces<T: Clone>(&self, values: &[T]) -> Vec<T> {
        self.face_source.iter().map(|&f| values[f as usize].clone()).collect()
    }

    /// The half-edge of the list, where those of face `f` are `3f`, `3f + 1` and `3f + 2`, that `h` of `mesh` was, whose
    /// maps these are. What `face` and `face_half_edges` of the mesh take.
    ///
    /// # Panics
    /// If `h` is out of range. Of a gap between the half-edges of compact stars nothing may be asked.
    pub fn half_edge_source<M: Topology + ?Sized>(&self, mesh: &M, h: M::HalfEdge) -> HalfEdgeId {
        let f = mesh.face(h);
        let side = mesh.face_half_edges(f).into_iter().take_while(|&g| g != h).count();
        self.corner_source(f.index(), side)
    }

    /// The half-edge of the list that side 0, 1 or 2 of face `f` of the structure was.
    pub(crate) fn corner_source(&self, f: usize, side: usize) -> HalfEdgeId {
        let corner = (usize::from(self.first_corner[f]) + side) % 3;
        HalfEdgeId::new(3 * self.face_source[f] as usize + corner)
    }
}
