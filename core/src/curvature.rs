//! Curvature at vertices: the angle defect, and what it and the cotangent Laplacian say of the smooth surface.
//!
//! Defects are defined for every mesh, and their sum is always 2 pi times the Euler characteristic. Curvatures are
//! pointwise, and so only inside: they are 0 at the boundary, at isolated vertices, and where a vertex has other
//! than as many edges as faces.
use crate::{
    Adjacency, Map, NotFinite, Topology, edges,
    normals::{self, Weight},
    not_finite,
    triangle::{self, Triangle},
    vector::{self, Vector},
};
use core::f64::consts::PI;

/// The angle defect of each vertex: what the angles of its faces lack to the full turn, 2 pi minus their sum; at the
/// boundary, to the half turn, pi minus their sum. It is the Gaussian curvature of the vertex, not divided by area.
///
/// Both are pi (2 - edges + faces) minus the angles, with the edges and the faces at the vertex, and so it is defined
/// wherever several fans meet or an edge has three or more faces. The sum over all vertices is then
/// 2 pi [`euler_characteristic`](crate::euler::euler_characteristic) on every mesh (Gauss and Bonnet).
///
/// # Arguments
/// `positions`: of all vertices. Corners that coincide see each other at a right angle to the third, three as an
/// equilateral triangle, so that the angles of every face have the sum pi.
///
/// # Returns
/// The defects in radians; 0 at isolated vertices.
///
/// # Complexity
/// O(vertices + half-edges); 12 bytes for each vertex, of which 8 are the result.
///
/// # Errors
/// [`NotFinite`]: a coordinate is infinite or no number. Panics if a position is missing.
///
/// # Example
/// ```
/// # use onering::CheL1 as Mesh;
/// use onering_core::{FromFaces, curvature};
/// // A corner of a cube, without the faces that face away: three right angles in the middle.
/// let corner = Mesh::from_faces(4, &[[0, 1, 2], [0, 2, 3], [0, 3, 1]])?;
/// let positions = vec![[0.0, 0.0, 0.0], [1.0, 0.0, 0.0], [0.0, 1.0, 0.0], [0.0, 0.0, 1.0]].into();
/// let defects = curvature::angle_defects(&corner, &positions).unwrap();
/// let pi = std::f64::consts::PI;
/// assert!(defects.as_slice().iter().all(|defect| (defect - pi / 2.0).abs() < 1e-12));
/// # Ok::<(), onering_core::BuildError>(())
/// ```
///
/// # Source
/// M. Meyer, M. Desbrun, P. Schröder and A. H. Barr, *Discrete differential-geometry operators for triangulated
/// 2-manifolds*, Visualization and Mathematics III, 2003, section 4.
pub fn angle_defects<M: Adjacency + ?Sized>(
    mesh: &M,
    positions: &Map<M::Vertex, [f32; 3]>,
) -> Result<Map<M::Vertex, f64>, NotFinite> {
    not_finite::positions(positions)?;
    Ok(defects(mesh, positions, &edge_excess(mesh)))
}

/// The area that belongs to each vertex: the part of its faces that is nearer to it than to their other corners,
/// but that a face with an obtuse angle gives half of its area to that corner and a quarter to each other. All add
/// up to the area of the mesh.
///
/// # Arguments
/// `positions`: of all vertices.
///
/// # Returns
/// The areas; 0 at isolated vertices, and where all faces are degenerate.
///
/// # Complexity
/// O(vertices + faces); 8 bytes for each vertex, which are the result.
///
/// # Errors
/// [`NotFinite`]: a coordinate is infinite or no number. Panics if a position is missing.
///
/// # Example
/// ```
/// # use onering::CheL0 as Mesh;
/// use onering_core::{FromFaces, curvature};
/// let mesh = Mesh::from_faces(3, &[[0, 1, 2]])?;
/// let positions = vec![[0.0, 0.0, 0.0], [4.0, 0.0, 0.0], [2.0, 1.0, 0.0]].into();
/// let areas = curvature::mixed_areas(&mesh, &positions).unwrap();
/// assert_eq!(areas.as_slice(), [0.5, 0.5, 1.0]);
/// # Ok::<(), onering_core::BuildError>(())
/// ```
///
/// # Source
/// Meyer et al. (2003), as for [`angle_defects`], section 3.3: "mixed area", Fig. 4.
pub fn mixed_areas<M: Topology + ?Sized>(
    mesh: &M,
    positions: &Map<M::Vertex, [f32; 3]>,
) -> Result<Map<M::Vertex, f64>, NotFinite> {
    not_finite::positions(positions)?;
    let mut areas = Map::filled(mesh.vertex_count(), 0.0);
    each_corner(mesh, positions, mixed_shares, |v, share| areas[v] += share);
    Ok(areas)
}

/// The Gaussian curvature of the surface at each vertex: the product of its two principal curvatures, positive on a
/// dome and negative on a saddle. [`angle_defects`] divided by [`mixed_areas`].
///
/// # Arguments
/// `positions`: of all vertices.
///
/// # Returns
/// The curvatures, in one over the square of the unit of the positions; 0 where the [module](self) says, and where
/// there is no area.
///
/// # Complexity
/// O(vertices + half-edges); 20 bytes for each vertex, of which 8 are the result.
///
/// # Errors
/// [`NotFinite`]: a coordinate is infinite or no number. Panics if a position is missing.
///
/// # Example
/// ```
/// # use onering::CheL1 as Mesh;
/// use onering_core::{FromFaces, curvature};
/// let octahedron = Mesh::from_faces(
///     6,
///     &[[0, 2, 4], [2, 1, 4], [1, 3, 4], [3, 0, 4], [2, 0, 5], [1, 2, 5], [3, 1, 5], [0, 3, 5]],
/// )?;
/// let axes = [[1.0, 0.0, 0.0], [-1.0, 0.0, 0.0], [0.0, 1.0, 0.0], [0.0, -1.0, 0.0], [0.0, 0.0, 1.0], [0.0, 0.0, -1.0]];
/// let gaussian = curvature::gaussian(&octahedron, &axes.to_vec().into()).unwrap();
/// // 4 pi over all of its area, where the sphere around it has 4 pi over 4 pi.
/// let pi = std::f64::consts::PI;
/// assert!(gaussian.as_slice().iter().all(|k| (k - 4.0 * pi / 48_f64.sqrt()).abs() < 1e-12));
/// # Ok::<(), onering_core::BuildError>(())
/// ```
///
/// # Source
/// Meyer et al. (2003), as for [`angle_defects`], equation 9.
pub fn gaussian<M: Adjacency + ?Sized>(
    mesh: &M,
    positions: &Map<M::Vertex, [f32; 3]>,
) -> Result<Map<M::Vertex, f64>, NotFinite> {
    let areas = mixed_areas(mesh, positions)?;
    let excess = edge_excess(mesh);
    let mut curvatures = defects(mesh, positions, &excess);
    for (v, curvature) in &mut curvatures {
        *curvature = if excess[v] == 0 && areas[v] > 0.0 { *curvature / areas[v] } else { 0.0 };
    }
    Ok(curvatures)
}

/// The mean curvature of the surface at each vertex: the mean of its two principal curvatures, positive where it
/// bends away from its normal, as a sphere does whose faces look outward.
///
/// It is half the length of the mean curvature normal: the cotangent Laplacian of the positions divided by
/// [`mixed_areas`]. Its sign is that of its direction along the area-weighted normal of the vertex. Degenerate
/// faces count for nothing.
///
/// # Arguments
/// `positions`: of all vertices.
///
/// # Returns
/// The curvatures, in one over the unit of the positions; 0 where the [module](self) says, and where there is no
/// area or no normal.
///
/// # Complexity
/// O(vertices + half-edges); 60 bytes for each vertex, of which 8 are the result.
///
/// # Errors
/// [`NotFinite`]: a coordinate is infinite or no number. Panics if a position is missing.
///
/// # Example
/// ```
/// # use onering::CheL1 as Mesh;
/// use onering_core::{FromFaces, curvature};
/// let octahedron = Mesh::from_faces(
///     6,
///     &[[0, 2, 4], [2, 1, 4], [1, 3, 4], [3, 0, 4], [2, 0, 5], [1, 2, 5], [3, 1, 5], [0, 3, 5]],
/// )?;
/// let axes = [[1.0, 0.0, 0.0], [-1.0, 0.0, 0.0], [0.0, 1.0, 0.0], [0.0, -1.0, 0.0], [0.0, 0.0, 1.0], [0.0, 0.0, -1.0]];
/// let mean = curvature::mean(&octahedron, &axes.to_vec().into()).unwrap();
/// // As the sphere around it.
/// assert!(mean.as_slice().iter().all(|h| (h - 1.0).abs() < 1e-12));
/// # Ok::<(), onering_core::BuildError>(())
/// ```
///
/// # Source
/// Meyer et al. (2003), as for [`angle_defects`], equation 8.
pub fn mean<M: Adjacency + ?Sized>(
    mesh: &M,
    positions: &Map<M::Vertex, [f32; 3]>,
) -> Result<Map<M::Vertex, f64>, NotFinite> {
    let areas = mixed_areas(mesh, positions)?;
    let normals = normals::vertex_normals(mesh, positions, Weight::Area)?;
    let excess = edge_excess(mesh);
    let mut laplacians = Map::filled(mesh.vertex_count(), [0.0; 3]);
    each_corner(mesh, positions, laplacian_shares, |v, share| {
        laplacians[v] = vector::plus(laplacians[v], share);
    });
    let curvature = |v| {
        if excess[v] != 0 || areas[v] == 0.0 || normals[v] == [0.0; 3] {
            return 0.0;
        }
        let length = length_of_any(laplacians[v]) / (4.0 * areas[v]);
        if vector::dot(laplacians[v], normals[v]) < 0.0 { -length } else { length }
    };
    Ok(mesh.vertices().map(curvature).collect())
}

/// The length, where the squares of coordinates might be beyond `f64`: along a face that is all but degenerate
/// cotangents have no bound.
fn length_of_any([x, y, z]: Vector) -> f64 {
    libm::hypot(libm::hypot(x, y), z)
}

/// The defects, by how many edges more than faces each vertex has.
fn defects<M: Topology + ?Sized>(
    mesh: &M,
    positions: &Map<M::Vertex, [f32; 3]>,
    excess: &Map<M::Vertex, i32>,
) -> Map<M::Vertex, f64> {
    let mut angles = Map::filled(mesh.vertex_count(), 0.0);
    each_corner(mesh, positions, |t| triangle::corners(t, triangle::angle), |v, angle| angles[v] += angle);
    for (v, angle) in &mut angles {
        *angle = PI * f64::from(2 - excess[v]) - *angle;
    }
    angles
}

/// How many edges more than faces each vertex has: none inside, one at the boundary of a manifold. Isolated vertices
/// are marked by 2, which makes their defect zero.
fn edge_excess<M: Adjacency + ?Sized>(mesh: &M) -> Map<M::Vertex, i32> {
    let mut excess = Map::filled(mesh.vertex_count(), 2);
    mesh.half_edges().for_each(|h| excess[mesh.origin(h)] = 0);
    mesh.half_edges().for_each(|h| excess[mesh.origin(h)] -= 1);
    for h in edges::each(mesh) {
        excess[mesh.origin(h)] += 1;
        excess[mesh.target(h)] += 1;
    }
    excess
}

/// Hands each corner what `shares` has for it.
fn each_corner<M: Topology + ?Sized, T>(
    mesh: &M,
    positions: &Map<M::Vertex, [f32; 3]>,
    shares: impl Fn(Triangle) -> [T; 3],
    mut give: impl FnMut(M::Vertex, T),
) {
    for f in mesh.faces() {
        let shares = shares(triangle::of(mesh, positions, f));
        mesh.face_vertices(f).into_iter().zip(shares).for_each(|(v, share)| give(v, share));
    }
}

/// The part of the area of a face that belongs to each corner.
fn mixed_shares(triangle @ [a, b, c]: Triangle) -> [f64; 3] {
    let cotangents @ [at_a, at_b, at_c] = triangle::corners(triangle, triangle::cotangent);
    if cotangents.iter().any(|&cotangent| cotangent < 0.0) {
        let area = triangle::area(triangle);
        return cotangents.map(|cotangent| if cotangent < 0.0 { area / 2.0 } else { area / 4.0 });
    }
    let square = |p, q| {
        let side = vector::minus(p, q);
        vector::dot(side, side)
    };
    let [ab, bc, ca] = [at_c * square(a, b), at_a * square(b, c), at_b * square(c, a)];
    [(ab + ca) / 8.0, (bc + ab) / 8.0, (ca + bc) / 8.0]
}

/// What a face adds to the sum of (cot + cot)(x - neighbour) at each corner x.
fn laplacian_shares(triangle @ [a, b, c]: Triangle) -> [Vector; 3] {
    let [at_a, at_b, at_c] = triangle::corners(triangle, triangle::cotangent);
    let [ab, bc, ca] = [
        vector::times(at_c, vector::minus(a, b)),
        vector::times(at_a, vector::minus(b, c)),
        vector::times(at_b, vector::minus(c, a)),
    ];
    [vector::minus(ab, ca), vector::minus(bc, ab), vector::minus(ca, bc)]
}
