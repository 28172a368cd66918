//! Files that something happened to: each is an error, whatever byte it is.
use crate::file_of;
use crate::seal::{seal, seal_head, sections};
use onering::ring::File;
use onering::{CheL2, FromFaces, HalfEdgeMesh, conformance};
use onering_io::{Error, Format};

fn small() -> CheL2 {
    CheL2::from_faces(4, &[[0, 1, 2], [2, 1, 3]]).unwrap()
}

fn refused(bytes: &[u8], what: &str) -> String {
    match File::from_bytes(bytes) {
        Err(error @ Error::Malformed { format: Format::Ring, .. }) => error.to_string(),
        other => panic!("{what}: {other:?}"),
    }
}

macro_rules! every_byte {
    ($($name:ident $text:literal $mesh:ty [$($has:ident)*] [$($holds:ident)*];)+) => {$(
        #[test]
        fn $name() {
            let torus = conformance::torus(3, 3);
            for (vertices, faces) in [(4, &[[0, 1, 2], [2, 1, 3]][..]), (9, &torus)] {
                let bytes = file_of(&<$mesh>::from_faces(vertices, faces).unwrap());
                for at in 0..bytes.len() {
                    for change in [0x01, 0x10, 0x80, 0xFF] {
                        let mut bytes = bytes.clone();
                        bytes[at] ^= change;
                        refused(&bytes, &format!("byte {at} ^ {change}"));
                    }
                    refused(&bytes[..at], &format!("{at} bytes"));
                }
                refused(&[&bytes[..], &[0]].concat(), "one byte more");
                refused(&[&bytes[..], &[0; 64]].concat(), "64 bytes more");
            }
        }
    )+};
}
onering::with_backends!(every_byte);

#[test]
fn foreign_files() {
    for bytes in
        [&b""[..], b"v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\n", b"glTF", b"\x89PNG\r\n\x1a\n", &[0; 4096]]
    {
        let error = refused(bytes, "foreign");
        assert_eq!(error, "ring byte 0: header: this is no .ring file");
    }
    let error = onering_io::read(&file_of(&small())).unwrap_err();
    assert!(matches!(error, Error::Unsupported { format: Format::Ring, .. }), "{error:?}");
}

/// A head with good checksums may say anything.
#[test]
fn heads_that_contradict_themselves() {
    let good = file_of(&small());
    let with = |at: usize, bytes: &[u8]| {
        let mut changed = good.clone();
        changed[at..at + bytes.len()].copy_from_slice(bytes);
        if changed[40..44] == good[40..44] {
            seal_head(&mut changed);
        }
        refused(&changed, &format!("{bytes:?} at {at}"))
    };
    assert!(with(8, &[2]).contains("version 2"));
    assert!(with(12, &[1, 2, 3, 4]).contains("not little-endian"));
    assert!(with(16, &u64::MAX.to_le_bytes()).contains("should have 18446744073709551615 bytes"));
    for count in [u64::MAX, u64::from(u32::MAX) + 1, 1 << 63] {
        assert!(with(24, &count.to_le_bytes()).contains("too many vertices"));
        assert!(with(32, &count.to_le_bytes()).contains("too many faces"));
    }
    assert!(with(40, &u32::MAX.to_le_bytes()).contains("4294967295 sections"));
    assert!(with(40, &64u32.to_le_bytes()).contains("64 sections"));
    with(40, &0u32.to_le_bytes());
    with(40, &1u32.to_le_bytes());
    with(44, &[1]);
    with(48, &[0; 64]);
    with(48, b"CheL2\0");
    with(112, &[1]);
    let table = sections(&good);
    let (first, second) = (&table[0], &table[1]);
    with(first.entry, &[0; 24]);
    let name: Vec<u8> = good[first.entry..first.entry + 24].to_vec();
    assert!(with(second.entry, &name).contains("same name"));
    with(first.entry + 24, &0u32.to_le_bytes());
    with(first.entry + 24, &7u32.to_le_bytes());
    with(first.entry + 28, &[1]);
    for offset in [0, first.offset, second.offset + 4, second.offset + 64, usize::MAX, usize::MAX - 63] {
        assert!(with(second.entry + 32, &(offset as u64).to_le_bytes()).contains("does not begin"));
    }
    for length in [u64::MAX, u64::MAX - second.offset as u64, u64::MAX - 63, 1 << 62, good.len() as u64] {
        assert!(with(second.entry + 40, &length.to_le_bytes()).contains("after the file"));
    }
    with(second.entry + 40, &0u64.to_le_bytes());
    with(second.entry + 56, &[1]);
}

/// Counts that handles could name, but for which the columns do not suffice.
#[test]
fn counts_without_columns() {
    for (at, count) in [(24, u32::MAX), (24, 5), (24, 3), (32, u32::MAX), (32, 3), (32, 0), (32, 1431655765)]
    {
        let mut bytes = file_of(&small());
        bytes[at..at + 4].copy_from_slice(&count.to_le_bytes());
        seal(&mut bytes);
        if let Ok(file) = File::from_bytes(&bytes) {
            let error = file.mesh::<CheL2>().unwrap_err();
            assert!(matches!(error, Error::Malformed { format: Format::Ring, .. }), "{error:?}");
        }
    }
}

#[test]
fn another_structure() {
    let bytes = file_of(&small());
    let file = File::from_bytes(&bytes).unwrap();
    let error = file.mesh::<HalfEdgeMesh>().unwrap_err().to_string();
    assert_eq!(error, "ring byte 48: header: the structure is che-l2, not half-edge");
}

/// A section that nobody asks for is left alone: what another program keeps beside a mesh.
#[test]
fn a_section_of_another_program() {
    let mut bytes = file_of(&small());
    let positions = sections(&bytes).into_iter().find(|section| section.name == "positions").unwrap();
    bytes[positions.entry..positions.entry + 9].copy_from_slice(b"colours\0\0");
    seal(&mut bytes);
    let file = File::from_bytes(&bytes).unwrap();
    assert_eq!(file.positions(), None);
    file.mesh::<CheL2>().unwrap();
}
