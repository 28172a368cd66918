//! Work that is written once and done on the structure that the user names.

use crate::args::MeshFile;
use crate::convert::Change;
use crate::failure::Failure;
use crate::input;
use onering::registry::BACKENDS;
use onering::{BuildError, FromFaces, Incidence, Searched, SharedVertex, WithOutgoing};
use onering_io::{Format, Options, Triangles};

/// The smallest that takes everything but degenerate faces.
pub(crate) const DEFAULT: &str = "directed-edges-small";

/// The papers' "no data structure": every answer is searched for among all faces.
pub(crate) const SEARCHED: &str = "searched";

/// What to do with a mesh, whatever its structure.
pub(crate) trait Work {
    type Output;
    fn on<M: Incidence>(self, mesh: &M) -> Self::Output;
}

/// The names that [`run`] takes: every backend that has faces, then [`SEARCHED`].
pub(crate) fn names() -> impl Iterator<Item = &'static str> {
    let with_faces = BACKENDS.iter().filter(|backend| backend.traits.contains(&"topology"));
    with_faces.map(|backend| backend.name).chain([SEARCHED])
}

/// Whether this one of [`names`] searches all faces for what lies across an edge.
pub(crate) fn searches(name: &str) -> bool {
    let row = BACKENDS.iter().find(|backend| backend.name == name);
    row.is_none_or(|backend| !backend.traits.contains(&"adjacency"))
}

/// The mesh of the command line, welded and repaired where that is asked for; `made` where no file is named.
pub(crate) fn read(options: &MeshFile, made: fn() -> Triangles) -> Result<Triangles, Failure> {
    read_with_format(options, made).map(|(mesh, _)| mesh)
}

/// As [`read`], with the format of the file where there is one.
pub(crate) fn read_with_format(
    options: &MeshFile,
    made: fn() -> Triangles,
) -> Result<(Triangles, Option<Format>), Failure> {
    let Some(path) = &options.file else { return Ok((made(), None)) };
    let bytes = input::bytes_of(path).map_err(Failure::Input)?;
    let (mut mesh, format) =
        input::mesh_in(&bytes, path, options.from, Options::default()).map_err(Failure::Input)?;
    Change::apply(options.weld, options.repair, &input::name_of(path), &mut mesh)?;
    Ok((mesh, Some(format)))
}

/// Builds the structure of this name, which is one of [`names`], and does the work on it. What a structure lacks is
/// added: a table of where to start around vertices, or a search.
pub(crate) fn run<W: Work>(name: &str, mesh: &Triangles, work: W) -> Result<W::Output, Failure> {
    build_and(name, mesh.positions.len(), &mesh.faces, work).map_err(|error| {
        Failure::Output(format!(
            "{name} cannot hold the mesh: {error} (--repair makes one that every backend holds)"
        ))
    })
}

/// Builds the type of a row, and adds what its traits lack to start from a vertex.
macro_rules! build {
    ([graph] $mesh:ty, $count:ident $faces:ident $work:ident) => {
        unreachable!("a graph without faces is none of the names")
    };
    ([topology] $mesh:ty, $count:ident $faces:ident $work:ident) => {
        $work.on(&Searched::new(<$mesh>::from_faces($count, $faces)?))
    };
    ([topology adjacency] $mesh:ty, $count:ident $faces:ident $work:ident) => {
        $work.on(&WithOutgoing::new(<$mesh>::from_faces($count, $faces)?)?)
    };
    ([$($has:ident)*] $mesh:ty, $count:ident $faces:ident $work:ident) => {
        $work.on(&<$mesh>::from_faces($count, $faces)?)
    };
}

macro_rules! build_and {
    ($($module:ident $name:literal $mesh:ty [$($has:ident)*] [$($holds:ident)*];)+) => {
        fn build_and<W: Work>(
            name: &str,
            vertex_count: usize,
            faces: &[[u32; 3]],
            work: W,
        ) -> Result<W::Output, BuildError> {
            Ok(match name {
                $($name => build!([$($has)*] $mesh, vertex_count faces work),)+
                _ => work.on(&Searched::new(SharedVertex::from_faces(vertex_count, faces)?)),
            })
        }
    };
}
onering::with_backends!(build_and);

#[cfg(test)]
mod tests {
    use super::*;

    struct Degrees;

    impl Work for Degrees {
        type Output = Vec<usize>;

        fn on<M: Incidence>(self, mesh: &M) -> Vec<usize> {
            mesh.vertices().map(|v| mesh.neighbours(v).count()).collect()
        }
    }

    #[test]
    fn every_name_does_the_work() {
        let square = Triangles::new(vec![[0.0; 3]; 4], vec![[0, 1, 2], [0, 2, 3]]);
        assert_eq!(names().count(), BACKENDS.len());
        for name in names() {
            assert_eq!(run(name, &square, Degrees).unwrap(), [3, 2, 3, 2], "{name}");
        }
    }

    #[test]
    fn a_refusal_names_the_backend_and_the_remedy() {
        let three = Triangles::new(vec![[0.0; 3]; 5], vec![[0, 1, 2], [1, 0, 3], [0, 1, 4]]);
        let Err(Failure::Output(message)) = run("che-l2", &three, Degrees) else { panic!() };
        assert!(message.starts_with("che-l2 cannot hold") && message.contains("--repair"), "{message}");
    }
}
