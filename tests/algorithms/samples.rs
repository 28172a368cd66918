//! Small meshes with figures counted by hand.
use super::shapes::{MOEBIUS, Random, TETRAHEDRON, grid};
use onering::FromFaces;

/// A mesh, and what is known of it by construction.
pub struct Sample {
    pub name: String,
    pub vertex_count: usize,
    pub faces: Vec<[u32; 3]>,
    /// Whether it is a manifold whose faces agree: every backend holds it.
    pub is_clean: bool,
    /// Euler characteristic, components, boundary loops, genus.
    pub known: Option<(isize, usize, Option<usize>, Option<usize>)>,
}

/// Every sample that `M` holds, which has to be every clean one.
pub fn held<M: FromFaces>() -> impl Iterator<Item = (Sample, M)> {
    all().into_iter().filter_map(|sample| match M::from_faces(sample.vertex_count, &sample.faces) {
        Ok(mesh) => Some((sample, mesh)),
        Err(error) => {
            assert!(!sample.is_clean, "{}: {error}", sample.name);
            None
        }
    })
}

type Known = (isize, usize, Option<usize>, Option<usize>);

fn sample(name: &str, is_clean: bool, isolated: usize, faces: &[[u32; 3]], known: Known) -> Sample {
    let used = faces.as_flattened().iter().max().map_or(0, |&v| v as usize + 1);
    Sample {
        name: name.into(),
        vertex_count: used + isolated,
        faces: faces.into(),
        is_clean,
        known: Some(known),
    }
}

const PROJECTIVE_PLANE: [[u32; 3]; 10] = [
    [0, 1, 2],
    [0, 2, 3],
    [0, 3, 4],
    [0, 4, 5],
    [0, 5, 1],
    [1, 2, 4],
    [2, 3, 5],
    [3, 4, 1],
    [4, 5, 2],
    [5, 1, 3],
];

/// The torus of seven vertices.
fn torus_7() -> Vec<[u32; 3]> {
    (0..7).flat_map(|i| [[0, 1, 3], [0, 3, 2]].map(|f| f.map(|k| (i + k) % 7))).collect()
}

/// The faces without those of these quads of a grid.
fn without(mut faces: Vec<[u32; 3]>, quads: &[usize]) -> Vec<[u32; 3]> {
    let mut quad = 0..;
    faces.retain(|_| !quads.contains(&(quad.next().unwrap() / 2)));
    faces
}

/// Two tori joined where each lost a face.
fn double_torus() -> Vec<[u32; 3]> {
    let other = |v: u32| [0, 3, 7, 1, 8, 9, 10][v as usize];
    let [a, b] = [torus_7(), torus_7().into_iter().map(|f| f.map(other)).collect()];
    a.into_iter().skip(1).chain(b.into_iter().skip(1)).collect()
}

fn shifted(faces: &[[u32; 3]], by: u32) -> impl Iterator<Item = [u32; 3]> {
    faces.iter().map(move |f| f.map(|v| v + by))
}

fn clean() -> Vec<Sample> {
    let parts: Vec<_> = TETRAHEDRON.into_iter().chain(shifted(&torus_7(), 6)).chain([[14, 15, 16]]).collect();
    let holes = without(grid(7, 8, [false, false], false).1, &[9, 12, 13, 30]);
    let torus = grid(4, 5, [true, true], false).1;
    vec![
        sample("nothing", true, 0, &[], (0, 0, Some(0), None)),
        sample("vertices alone", true, 3, &[], (0, 0, Some(0), None)),
        sample("triangle", true, 0, &[[0, 1, 2]], (1, 1, Some(1), Some(0))),
        sample("tetrahedron", true, 0, &TETRAHEDRON, (2, 1, Some(0), Some(0))),
        sample("pillow", true, 0, &[[0, 1, 2], [0, 2, 1]], (2, 1, Some(0), Some(0))),
        sample("disc", true, 0, &grid(3, 4, [false, false], false).1, (1, 1, Some(1), Some(0))),
        sample("tube", true, 2, &grid(3, 5, [false, true], false).1, (0, 1, Some(2), Some(0))),
        sample("torus of seven", true, 0, &torus_7(), (0, 1, Some(0), Some(1))),
        sample("torus", true, 0, &torus, (0, 1, Some(0), Some(1))),
        sample("torus with two holes", true, 0, &without(torus.clone(), &[0, 12]), (-2, 1, Some(2), Some(1))),
        sample("double torus", true, 0, &double_torus(), (-2, 1, Some(0), Some(2))),
        sample("disc with three holes", true, 0, &holes, (-2, 1, Some(4), Some(0))),
        sample("three parts", true, 4, &parts, (3, 3, Some(1), Some(1))),
    ]
}

fn unclean() -> Vec<Sample> {
    let mut turned = grid(4, 5, [true, true], false).1;
    turned.iter_mut().step_by(3).for_each(|f| f.swap(1, 2));
    let hourglass: Vec<_> = TETRAHEDRON.into_iter().chain(shifted(&TETRAHEDRON, 3)).collect();
    let on_an_edge = |v: u32| [0, 1, 4, 5][v as usize];
    let two_on_an_edge: Vec<_> =
        TETRAHEDRON.into_iter().chain(TETRAHEDRON.map(|f| f.map(on_an_edge))).collect();
    let pinched = without(grid(6, 6, [false, false], false).1, &[7, 14]);
    let five = (2..7).map(|v| if v % 2 == 0 { [0, 1, v] } else { [1, 0, v] }).collect::<Vec<_>>();
    vec![
        sample("bowtie", false, 0, &[[0, 1, 2], [0, 3, 4]], (1, 2, Some(2), None)),
        sample("hourglass", false, 0, &hourglass, (3, 2, Some(0), None)),
        sample("holes that touch", false, 0, &pinched, (-1, 1, Some(2), None)),
        sample("moebius", false, 0, &MOEBIUS, (0, 1, Some(1), None)),
        sample("klein", false, 0, &grid(4, 5, [true, true], true).1, (0, 1, Some(0), None)),
        sample("projective plane", false, 0, &PROJECTIVE_PLANE, (1, 1, Some(0), None)),
        sample("torus turned in part", false, 0, &turned, (0, 1, Some(0), Some(1))),
        sample("two that disagree", false, 0, &[[0, 1, 2], [0, 1, 3]], (1, 1, Some(1), Some(0))),
        sample("same face twice", false, 0, &[[0, 1, 2], [1, 2, 0]], (2, 1, Some(0), Some(0))),
        sample("three on an edge", false, 0, &[[0, 1, 2], [1, 0, 3], [0, 1, 4]], (1, 1, None, None)),
        sample("five on an edge", false, 1, &five, (1, 1, None, None)),
        sample("tetrahedra on an edge", false, 0, &two_on_an_edge, (3, 1, Some(0), None)),
    ]
}

/// Triangles thrown at few vertices: every defect but a repeated vertex.
fn soup(seed: u32) -> Sample {
    let mut random = Random(seed.into());
    let mut random = |below: u32| random.below(below as usize) as u32;
    let vertex_count = 5 + random(20);
    let triangles = (0..4 + random(30)).map(|_| [(); 3].map(|()| random(vertex_count)));
    let faces = triangles.filter(|[a, b, c]| a != b && b != c && c != a).collect();
    let name = format!("soup {seed}");
    Sample { name, vertex_count: vertex_count as usize, faces, is_clean: false, known: None }
}

pub fn all() -> Vec<Sample> {
    clean().into_iter().chain(unclean()).chain((0..60).map(soup)).collect()
}
