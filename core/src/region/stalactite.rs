//! The faces of a stalactite, from one of its vertices.
use super::{Entry, Region, grown};
use crate::{Incidence, Map, NotFinite, normals, not_finite};

/// What [`stalactite()`] takes for the flank of a stalactite.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct StalactiteOptions {
    /// The angle with the horizontal, in degrees, from which on a face is steep. The flank of a stalactite is
    /// steep, and the roof is not.
    pub steep: f64,
}

impl Default for StalactiteOptions {
    /// Steep from 45 degrees on: where a face is nearer to a wall than to a roof.
    fn default() -> Self {
        Self { steep: 45.0 }
    }
}

/// The stalactite that a picked vertex belongs to.
///
/// The printed algorithm is a picture, and the text of the paper says only that adjacency finds "all the
/// triangles of the stalactite". This is the rule here:
///
/// 1. From the picked vertex down to the lowest neighbour, again and again, to the tip.
/// 2. The *cap*: the faces at the tip, and from those of them that are not steep on, as long as faces are not
///    steep. A tip is blunt, and as flat as the roof.
/// 3. The *flank*: from there on, as long as faces are steep. It ends where it turns into the roof.
///
/// Both only rise: a face is reached across an edge where its third vertex is not lower than both ends of the
/// edge, so that every vertex of the region is at the end of a path along edges that starts at a face at the
/// tip and never goes down, and a stalactite ends where the next one that has grown together with it begins.
/// Where no steep face is reached there is no stalactite, and only the faces at the tip are given.
///
/// # Arguments
/// The positions, z up, a vertex of the stalactite, and from which angle on a face is steep. Which side of the
/// faces is the outside makes no difference. A face without area is as steep as the one that it is reached
/// from.
///
/// # Returns
/// The region, from the tip up. None of an isolated vertex.
///
/// # Complexity
/// O(n log n) in the faces of the region and the way down, beside a check of all positions and a byte for each face
/// of the mesh.
///
/// # Errors
/// [`NotFinite`] where a coordinate is infinite or no number.
///
/// # Panics
/// If `positions` is shorter than the list of vertices, or the vertex out of range.
///
/// # Example
/// ```
/// # use onering::CheL2 as Mesh;
/// use onering_core::{FromFaces, Handle, Map, VertexId, region};
/// // A pyramid that hangs from a roof of which there is one face.
/// let mesh = Mesh::from_faces(6, &[[1, 0, 4], [2, 1, 4], [3, 2, 4], [0, 3, 4], [0, 1, 5]])?;
/// let corners = [[0.0, 0.0, 0.0], [1.0, 0.0, 0.0], [1.0, 1.0, 0.0], [0.0, 1.0, 0.0], [0.5, 0.5, -1.0], [0.5, -1.0, 0.0]];
/// let positions = Map::from(corners.to_vec());
/// let found = region::stalactite(&mesh, &positions, VertexId::new(4), &region::StalactiteOptions::default())?;
/// assert_eq!(found.faces().len(), 4);
/// assert_eq!(found.bounding_box(&positions), [[0.0, 0.0, -1.0], [1.0, 1.0, 0.0]]);
/// # Ok::<(), Box<dyn std::error::Error>>(())
/// ```
///
/// # Source
/// Figueiredo et al. (2014), section 6.2, Algorithm 3; the rule is ours.
pub fn stalactite<M: Incidence + ?Sized>(
    mesh: &M,
    positions: &Map<M::Vertex, [f32; 3]>,
    picked: M::Vertex,
    options: &StalactiteOptions,
) -> Result<Region<M::Face, M::Vertex>, NotFinite> {
    not_finite::positions(positions)?;
    let z = |v: M::Vertex| positions[v][2];
    let tip = lowest_below(mesh, picked, z);
    // A degenerate face may be there with two of its corners.
    let at_tip = grown(mesh, mesh.star(tip).map(|h| mesh.face(h)), |_, _| Entry::Refused);
    let cosine = libm::cos(options.steep.to_radians());
    let is_steep = |f| normals::face_normal(mesh, positions, f).map(|n| n[2].abs() <= cosine);
    let rises = |g| {
        let apex = z(mesh.origin(mesh.prev(g)));
        apex >= z(mesh.origin(g)) || apex >= z(mesh.target(g))
    };
    // Asked of a face alone, an edge of many faces is passed over once, not once for each of them.
    let entry = |is_admitted| if is_admitted { Entry::Granted } else { Entry::Refused };
    let flat_tip = at_tip.iter().copied().filter(|&f| is_steep(f) != Some(true));
    let cap = grown(mesh, flat_tip, |_, g| entry(rises(g) && is_steep(mesh.face(g)) != Some(true)));
    let start = at_tip.iter().copied().chain(cap);
    let all = grown(mesh, start, |_, g| entry(rises(g) && is_steep(mesh.face(g)) != Some(false)));
    let has_flank = all.iter().any(|&f| is_steep(f) == Some(true));
    Ok(Region::new(mesh, if has_flank { all } else { at_tip }))
}

/// From `v` to its lowest neighbour, as long as that is lower.
fn lowest_below<M: Incidence + ?Sized>(
    mesh: &M,
    mut v: M::Vertex,
    z: impl Fn(M::Vertex) -> f32,
) -> M::Vertex {
    loop {
        let lowest = mesh.neighbours(v).min_by(|&a, &b| z(a).total_cmp(&z(b)));
        match lowest {
            Some(u) if z(u) < z(v) => v = u,
            _ => return v,
        }
    }
}
