//! The meshes that all are measured on. A new one is a line here.

use crate::expected::Expected;
use crate::mesh::Mesh;
use onering::{CheL1, FromFaces, Map, VertexId, subdivision};
use std::error::Error;
use std::path::Path;

type Outcome<T> = Result<T, Box<dyn Error>>;
type Arrays = (Vec<[f32; 3]>, Vec<[u32; 3]>);

/// Where a mesh comes from.
#[derive(Clone, Copy)]
enum Source {
    /// An icosahedron divided so many times.
    Icosphere(usize),
    /// A square of so many vertices a side, each quad cut in two.
    Grid(u32),
    File(&'static str),
}

/// A mesh by name.
pub(crate) struct Named {
    pub(crate) name: &'static str,
    source: Source,
    is_shuffled: bool,
}

const fn named(name: &'static str, source: Source, is_shuffled: bool) -> Named {
    Named { name, source, is_shuffled }
}

const MESHES: &[Named] = &[
    named("stanford_bunny", Source::File("stanford_bunny.obj"), false),
    named("ico-82k", Source::Icosphere(6), false),
    named("ico-82k-shuffled", Source::Icosphere(6), true),
    named("mni152_isosurface_963k", Source::File("mni152_isosurface_963k.ply"), false),
    named("ico-1.3M", Source::Icosphere(8), false),
    named("ico-1.3M-shuffled", Source::Icosphere(8), true),
    named("ico-5.2M", Source::Icosphere(9), false),
    named("ico-5.2M-shuffled", Source::Icosphere(9), true),
    named("grid-10M", Source::Grid(2237), false),
    named("grid-10M-shuffled", Source::Grid(2237), true),
];

/// For seconds, not for figures.
const TINY: &[Named] = &[
    named("ico-320", Source::Icosphere(2), false),
    named("ico-320-shuffled", Source::Icosphere(2), true),
    named("grid-450", Source::Grid(16), false),
    named("grid-450-shuffled", Source::Grid(16), true),
];

/// Those of these names, or all.
pub(crate) fn asked(names: &[String], tiny: bool) -> Result<impl Iterator<Item = &'static Named>, String> {
    let all = if tiny { TINY } else { MESHES };
    if let Some(unknown) = names.iter().find(|name| all.iter().all(|mesh| mesh.name != **name)) {
        let known: Vec<_> = all.iter().map(|mesh| mesh.name).collect();
        return Err(format!("no mesh {unknown}: there are {}", known.join(", ")));
    }
    Ok(all.iter().filter(|mesh| names.is_empty() || names.iter().any(|name| name == mesh.name)))
}

impl Named {
    /// The mesh and what is to be found in it; the reason where a file is not there.
    pub(crate) fn make(&self, folder: Option<&Path>) -> Outcome<(Mesh, Expected)> {
        let (mut positions, mut faces) = match self.source {
            Source::Icosphere(levels) => icosphere(levels)?,
            Source::Grid(side) => grid(side),
            Source::File(name) => {
                let folder = folder.ok_or("no folder of meshes: --folder or ONERING_MESHES names one")?;
                let triangles = onering::io::load(folder.join(name))?;
                (triangles.positions, triangles.faces)
            }
        };
        if self.is_shuffled {
            shuffle_mesh(&mut positions, &mut faces);
        }
        let queries = queries(positions.len());
        let expected = Expected::of(positions.len(), &faces, &queries);
        Ok((Mesh { positions, faces, queries, edge_count: expected.edge_count }, expected))
    }
}

/// In the order in which subdivision makes it.
fn icosphere(levels: usize) -> Outcome<Arrays> {
    let t = (1.0 + 5_f32.sqrt()) / 2.0;
    let mut positions: Map<VertexId, [f32; 3]> = (0..12)
        .map(|i| {
            let [a, b] = [1.0 - (i & 1) as f32 * 2.0, t * (1.0 - (i >> 1 & 1) as f32 * 2.0)];
            [[a, b, 0.0], [0.0, a, b], [b, 0.0, a]][i >> 2]
        })
        .collect();
    let mut faces = icosahedron(positions.as_slice());
    for _ in 0..levels {
        let mesh = CheL1::from_faces(positions.len(), &faces)?;
        let finer = subdivision::loop_subdivision(&mesh, &positions)?;
        (positions, faces) = (finer.positions.into(), finer.faces);
    }
    Ok((positions.as_slice().to_vec(), faces))
}

/// All triples of corners that are near to each other, turned outward.
fn icosahedron(corners: &[[f32; 3]]) -> Vec<[u32; 3]> {
    let near = |a: [f32; 3], b: [f32; 3]| (0..3).map(|i| (a[i] - b[i]).powi(2)).sum::<f32>() < 4.5;
    let triples = (0..12).flat_map(|a| (a + 1..12).flat_map(move |b| (b + 1..12).map(move |c| [a, b, c])));
    let faces = triples.filter_map(|[a, b, c]: [usize; 3]| {
        let [p, q, r] = [a, b, c].map(|v| corners[v]);
        let outward = p[0] * (q[1] * r[2] - q[2] * r[1])
            + p[1] * (q[2] * r[0] - q[0] * r[2])
            + p[2] * (q[0] * r[1] - q[1] * r[0]);
        let face = if outward > 0.0 { [a, b, c] } else { [a, c, b] };
        (near(p, q) && near(q, r) && near(r, p)).then(|| face.map(|v| v as u32))
    });
    faces.collect()
}

/// Row after row.
fn grid(side: u32) -> Arrays {
    let positions = (0..side).flat_map(|y| (0..side).map(move |x| [x as f32, y as f32, 0.0])).collect();
    let quad = |a: u32| [[a, a + 1, a + side + 1], [a, a + side + 1, a + side]];
    let rows = 0..side - 1;
    let faces = rows.flat_map(|y| (0..side - 1).flat_map(move |x| quad(y * side + x))).collect();
    (positions, faces)
}

/// New numbers for all vertices, and all faces in a new order.
fn shuffle_mesh(positions: &mut Vec<[f32; 3]>, faces: &mut [[u32; 3]]) {
    let mut old: Vec<u32> = (0..positions.len() as u32).collect();
    shuffle(&mut old);
    let mut new = vec![0; old.len()];
    old.iter().zip(0..).for_each(|(&v, number)| new[v as usize] = number);
    *positions = old.iter().map(|&v| positions[v as usize]).collect();
    faces.iter_mut().for_each(|face| *face = face.map(|v| new[v as usize]));
    shuffle(faces);
}

fn shuffle<T>(things: &mut [T]) {
    let mut random = Random::new();
    for i in (1..things.len()).rev() {
        things.swap(i, random.below(i + 1));
    }
}

/// The vertices whose 4-rings are asked for: so many that they do not stay in the cache.
fn queries(vertex_count: usize) -> Vec<u32> {
    let mut random = Random::new();
    (0..vertex_count.min(10_000)).map(|_| random.below(vertex_count) as u32).collect()
}

/// Marsaglia's xorshift by a fixed seed: the same on every machine.
struct Random(u64);

impl Random {
    fn new() -> Self {
        Self(88172645463325252)
    }

    fn below(&mut self, limit: usize) -> usize {
        self.0 ^= self.0 << 13;
        self.0 ^= self.0 >> 7;
        self.0 ^= self.0 << 17;
        (self.0 % limit as u64) as usize
    }
}
