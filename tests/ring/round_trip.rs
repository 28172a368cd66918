//! Corpus x registry: a mesh that was written and opened obeys the laws, and has the columns that it had.
use crate::{file_of, laws};
use onering::columns::{Columns, FromColumns};
use onering::conformance::{self, Flaw};
use onering::ring::{self, File};
use std::borrow::Cow;

/// The columns as bytes.
fn taken_apart(mesh: &impl Columns) -> Vec<(&'static str, usize, Vec<u8>)> {
    mesh.columns().iter().map(|c| (c.name, c.element_size, c.bytes.to_vec())).collect()
}

macro_rules! round_trips {
    ($($name:ident $text:literal $mesh:ty [$($has:ident)*] [$($holds:ident)*];)+) => {$(
        #[test]
        fn $name() {
            assert_eq!(<$mesh>::backend_name(), $text);
            let holds = Flaw::named(&[$(stringify!($holds)),*]);
            for case in conformance::corpus() {
                let Some(built) = conformance::build::<$mesh>(&case, &holds) else { continue };
                built.validate().unwrap_or_else(|invalid| panic!("{}: {invalid}", case.name));
                let bytes = file_of(&built);
                let file = File::from_bytes(&bytes).unwrap();
                assert_eq!((file.backend(), file.vertex_count()), ($text, case.vertices));
                assert_eq!(file.positions().unwrap().len(), case.vertices);
                let mesh = file.mesh::<$mesh>().unwrap_or_else(|error| panic!("{}: {error}", case.name));
                laws!(&case, &mesh, $($has)*);
                laws!(&case, &mesh.clone(), $($has)*);
                assert_eq!(taken_apart(&mesh), taken_apart(&built), "{}", case.name);
                let owned = file.owned_mesh::<$mesh>().unwrap();
                drop(file);
                laws!(&case, &owned, $($has)*);
                conformance::footprint(&case, &owned);

                let by_name = ring::build($text, case.vertices, Cow::Borrowed(&case.faces)).unwrap().unwrap();
                assert_eq!(file_of(&*by_name), bytes, "{}", case.name);
                let file = File::from_bytes(&bytes).unwrap();
                match ring::triangles(&file) {
                    Ok(triangles) => assert_eq!(triangles.faces, case.faces),
                    Err(error) => {
                        assert_eq!($text, "vertex-graph");
                        assert!(error.to_string().contains("which has no faces"), "{error}");
                    }
                }
            }
        }
    )+};
}
onering::with_backends!(round_trips);

#[test]
fn a_mesh_without_positions() {
    let mesh = onering::FromFaces::from_faces(4, &[[0, 1, 2], [2, 1, 3]]).unwrap();
    let mesh: onering::CheL2 = mesh;
    let mut bytes = Vec::new();
    ring::write(&mut bytes, &mesh, None).unwrap();
    let file = File::from_bytes(&bytes).unwrap();
    assert_eq!(file.positions(), None);
    assert_eq!(ring::faces(&file).unwrap(), [[0, 1, 2], [2, 1, 3]]);
    let error = ring::triangles(&file).unwrap_err().to_string();
    assert!(error.contains("section `positions`: is missing"), "{error}");
}

#[test]
fn what_the_features_select() {
    let mesh: onering::Mesh = onering::FromFaces::from_faces(3, &[[0, 1, 2]]).unwrap();
    let bytes = file_of(&mesh);
    let file = File::from_bytes(&bytes).unwrap();
    assert_eq!(onering::Topology::to_faces(&file.mesh::<onering::Mesh>().unwrap()), [[0, 1, 2]]);
}

#[test]
fn positions_are_for_vertices() {
    let mesh: onering::CheL2 = onering::FromFaces::from_faces(3, &[[0, 1, 2]]).unwrap();
    let error = ring::write(&mut Vec::new(), &mesh, Some(&[[0.0; 3]; 2])).unwrap_err();
    assert_eq!(error.kind(), std::io::ErrorKind::InvalidInput);
}
