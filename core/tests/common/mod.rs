//! Small meshes whose figures are known by hand, from the literature or by formula.

pub(crate) mod random;
#[path = "../../../tests/common/shapes.rs"]
mod shapes;

pub(crate) use shapes::{TETRAHEDRON, grid};

/// Name, vertex count, faces and the figures it must have.
pub(crate) type Case = (&'static str, usize, Vec<[u32; 3]>, &'static str);

/// The tetrahedron and a second one, where `second` gives the vertices of its corners.
fn two_tetrahedra(second: [u32; 4]) -> Vec<[u32; 3]> {
    let second = TETRAHEDRON.map(|face| face.map(|v| second[v as usize]));
    TETRAHEDRON.into_iter().chain(second).collect()
}

pub(crate) fn corpus() -> Vec<Case> {
    let mut corpus = pieces();
    corpus.extend(surfaces());
    corpus.extend(singular());
    corpus
}

fn pieces() -> Vec<Case> {
    let tetrahedron = || TETRAHEDRON.to_vec();
    let mut flipped = tetrahedron();
    flipped[0].swap(1, 2);
    vec![
        (
            "empty",
            0,
            vec![],
            "edges=0 components=0 euler=0 closed=false boundary_loops=0 manifold=true genus=null",
        ),
        ("points only", 5, vec![], "isolated_vertices=5 components=0 euler=0 orientable=true"),
        (
            "triangle",
            3,
            vec![[0, 1, 2]],
            "edges=3 boundary_edges=3 boundary_loops=1 euler=1 genus=0 valence_min=2 max_faces_per_vertex=1",
        ),
        (
            "tetrahedron",
            4,
            tetrahedron(),
            "edges=6 boundary_edges=0 euler=2 components=1 genus=0 closed=true manifold=true orientable=true \
             inconsistent_edges=0 boundary_loops=0 valence_min=3 valence_max=3 min_flips=0 isolated_vertices=0",
        ),
        (
            "tetrahedron, one flipped",
            4,
            flipped,
            "inconsistent_edges=3 min_flips=1 orientable=true repeated_halfedges=3 genus=0",
        ),
        ("tetrahedron, isolated vertices", 6, tetrahedron(), "isolated_vertices=2 euler=2"),
        (
            "degenerate and duplicate",
            4,
            vec![[0, 1, 1], [0, 1, 2], [1, 2, 0], [2, 1, 0], [3, 3, 3]],
            "degenerate_faces=2 duplicate_faces=2 duplicate_faces_same_orientation=1 isolated_vertices=1 \
             nonmanifold_edges=3 max_faces_per_edge=3",
        ),
        (
            "pillow",
            3,
            vec![[0, 1, 2], [0, 2, 1]],
            "duplicate_faces=1 duplicate_faces_same_orientation=0 boundary_edges=0 euler=2 genus=0 manifold=true \
             inconsistent_edges=0 closed=true",
        ),
        (
            "out of range",
            3,
            vec![[0, 1, 3], [0, 1, 2], [u32::MAX; 3]],
            "out_of_range_faces=2 degenerate_faces=0 edges=3 components=1",
        ),
    ]
}

fn surfaces() -> Vec<Case> {
    let case = |name, (vertices, faces), want| (name, vertices, faces, want);
    // The real projective plane with six vertices, as the halved icosahedron.
    let rp2 = [[0, 1, 4], [0, 1, 5], [0, 2, 3], [0, 2, 5], [0, 3, 4], [1, 2, 3], [1, 2, 4], [1, 3, 5]];
    let rp2 = rp2.into_iter().chain([[2, 4, 5], [3, 4, 5]]).collect();
    vec![
        case(
            "torus",
            grid(20, 15, [true, true], false),
            "edges=900 boundary_edges=0 euler=0 genus=1 components=1 closed=true manifold=true orientable=true \
             inconsistent_edges=0 valence_min=6 valence_max=6",
        ),
        case(
            "open grid",
            grid(20, 15, [false, false], false),
            "boundary_edges=70 boundary_loops=1 boundary_components=1 euler=1 genus=0 orientable=true closed=false",
        ),
        case(
            "cylinder",
            grid(20, 15, [true, false], false),
            "boundary_edges=40 boundary_loops=2 euler=0 genus=0 orientable=true",
        ),
        case(
            "Moebius strip",
            grid(20, 4, [true, false], true),
            "boundary_edges=40 boundary_loops=1 euler=0 orientable=false nonorientable_patches=1 manifold=true \
             genus=null inconsistent_edges=4 closed=false",
        ),
        case(
            "Klein bottle",
            grid(20, 15, [true, true], true),
            "boundary_edges=0 boundary_loops=0 euler=0 orientable=false manifold=true closed=true \
             inconsistent_edges=15",
        ),
        (
            "projective plane",
            6,
            rp2,
            "euler=1 boundary_edges=0 orientable=false edges=15 manifold=true closed=true",
        ),
    ]
}

fn singular() -> Vec<Case> {
    vec![
        (
            "bowtie",
            5,
            vec![[0, 1, 2], [0, 3, 4]],
            "bowtie_vertices=1 nonmanifold_vertices=1 components=2 components_by_vertex=1 boundary_loops=2 \
             boundary_components=1 boundary_edges=6 nonmanifold_edges=0 euler=1 manifold=false",
        ),
        (
            "two tetrahedra at a vertex",
            7,
            two_tetrahedra([0, 4, 5, 6]),
            "bowtie_vertices=1 nonmanifold_vertices=1 components=2 components_by_vertex=1 euler=3 boundary_edges=0 \
             nonmanifold_edges=0",
        ),
        (
            "two tetrahedra at an edge",
            6,
            two_tetrahedra([0, 1, 4, 5]),
            "nonmanifold_edges=1 nonmanifold_vertices=2 bowtie_vertices=0 components=1 patches=2 boundary_edges=0 \
             max_faces_per_edge=4 euler=3",
        ),
        (
            "two tetrahedra at a face",
            5,
            two_tetrahedra([0, 1, 2, 4]),
            "duplicate_faces=1 duplicate_faces_same_orientation=1 nonmanifold_edges=3 components=1",
        ),
        (
            "three faces on an edge",
            5,
            vec![[0, 1, 2], [1, 0, 3], [0, 1, 4]],
            "nonmanifold_edges=1 nonmanifold_vertices=2 bowtie_vertices=0 boundary_edges=6 boundary_loops=null \
             boundary_components=1 components=1 max_faces_per_edge=3 euler=1 inconsistent_edges=0 \
             repeated_halfedges=1 patches=3 orientable=true",
        ),
    ]
}
