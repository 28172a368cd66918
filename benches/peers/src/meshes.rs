//! The meshes that all are measured on. A new one is a line here.

use crate::expected::Expected;
use crate::mesh::Mesh;
use crate::shared::{Placed, Random, icosphere, shuffled_with_positions};
use onering::repair::{RepairOptions, repair};
use std::error::Error;
use std::path::Path;

type Outcome<T> = Result<T, Box<dyn Error>>;

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
        let mut placed = match self.source {
            Source::Icosphere(levels) => icosphere(levels),
            Source::Grid(side) => grid(side),
            Source::File(name) => {
                let folder = folder.ok_or("no folder of meshes: --folder or ONERING_MESHES names one")?;
                repaired(onering::io::load(folder.join(name))?)?
            }
        };
        if self.is_shuffled {
            placed = shuffled_with_positions(&placed);
        }
        let (positions, faces) = (placed.0.into_vec(), placed.1);
        let queries = queries(positions.len());
        let expected = Expected::of(positions.len(), &faces, &queries);
        Ok((Mesh { positions, faces, queries, edge_count: expected.edge_count }, expected))
    }
}

/// What a file has, cut and oriented where it is no oriented manifold, which most structures would refuse.
fn repaired(triangles: onering::io::Triangles) -> Outcome<Placed> {
    let repaired = repair(triangles.positions.len(), &triangles.faces, &RepairOptions::default())?;
    let summary = repaired.to_string();
    if repaired.faces != triangles.faces {
        eprintln!("repaired: {summary}");
    }
    let positions = repaired.vertex_source.iter().map(|&v| triangles.positions[v as usize]).collect();
    Ok((positions, repaired.faces))
}

/// Row after row.
fn grid(side: u32) -> Placed {
    let positions = (0..side).flat_map(|y| (0..side).map(move |x| [x as f32, y as f32, 0.0])).collect();
    let quad = |a: u32| [[a, a + 1, a + side + 1], [a, a + side + 1, a + side]];
    let rows = 0..side - 1;
    let faces = rows.flat_map(|y| (0..side - 1).flat_map(move |x| quad(y * side + x))).collect();
    (positions, faces)
}

/// The vertices whose 4-rings are asked for: so many that they do not stay in the cache.
fn queries(vertex_count: usize) -> Vec<u32> {
    let mut random = Random::default();
    (0..vertex_count.min(10_000)).map(|_| random.below(vertex_count) as u32).collect()
}
