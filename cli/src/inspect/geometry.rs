//! What positions give: box, area, volume.

use onering::{FaceId, HalfEdgeId, Handle, NotFinite, Topology, VertexId, measure};
use onering_io::Triangles;

/// The figures of positions.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(crate) struct Geometry {
    pub(crate) bbox_min: [f32; 3],
    pub(crate) bbox_max: [f32; 3],
    /// Of all triangles, copies and both sides of folds included.
    pub(crate) area: f64,
    /// Of the cones from the origin to the triangles: the volume within, where the surface is closed.
    pub(crate) signed_volume: f64,
}

impl Geometry {
    /// Nothing where there are no positions.
    pub(crate) fn of(mesh: &Triangles) -> Result<Option<Self>, NotFinite> {
        let positions = mesh.positions.clone().into();
        let Some([bbox_min, bbox_max]) = measure::bounding_box(&positions)? else { return Ok(None) };
        let area = measure::area(&Faces(mesh), &positions)?;
        let signed_volume = measure::signed_volume(&Faces(mesh), &positions)?;
        Ok(Some(Self { bbox_min, bbox_max, area, signed_volume }))
    }
}

/// The triangles as they were read, whatever is wrong with them: no structure is built to look at each face once.
struct Faces<'a>(&'a Triangles);

impl Topology for Faces<'_> {
    type Vertex = VertexId;
    type HalfEdge = HalfEdgeId;
    type Face = FaceId;

    fn vertex_count(&self) -> usize {
        self.0.positions.len()
    }

    fn face_count(&self) -> usize {
        self.0.faces.len()
    }

    fn origin(&self, h: HalfEdgeId) -> VertexId {
        VertexId::new(self.0.faces.as_flattened()[h.index()] as usize)
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    const TETRAHEDRON: [[u32; 3]; 4] = [[0, 2, 1], [0, 1, 3], [1, 2, 3], [0, 3, 2]];

    #[test]
    fn a_tetrahedron_away_from_the_origin() {
        let positions = vec![[1.0, 1.0, 1.0], [3.0, 1.0, 1.0], [1.0, 3.0, 1.0], [1.0, 1.0, 3.0]];
        let found = Geometry::of(&Triangles::new(positions, TETRAHEDRON.to_vec())).unwrap().unwrap();
        assert_eq!((found.bbox_min, found.bbox_max), ([1.0; 3], [3.0; 3]));
        // Three right triangles of area 2, one of sides sqrt(8); a sixth of a cube of side 2.
        assert!((found.area - (6.0 + 12.0_f64.sqrt())).abs() < 1e-12);
        assert!((found.signed_volume - 8.0 / 6.0).abs() < 1e-12);
    }

    #[test]
    fn nothing_without_numbers() {
        let of = |positions: &[[f32; 3]]| Geometry::of(&Triangles::new(positions.to_vec(), Vec::new()));
        assert_eq!(of(&[]), Ok(None));
        assert_eq!(of(&[[0.0, f32::NAN, 0.0]]), Err(NotFinite { vertex: 0 }));
        assert!(of(&[[0.0; 3]]).unwrap().is_some_and(|found| found.area == 0.0));
    }
}
