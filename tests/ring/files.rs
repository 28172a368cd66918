//! Files on disk: read, mapped, replaced.
use onering::ring::{self, File};
use onering::{CheL2, CheL3, FromFaces, Topology, conformance};
use onering_io::Error;
use std::fs;
use std::path::PathBuf;

fn folder(name: &str) -> PathBuf {
    let folder = PathBuf::from(env!("CARGO_TARGET_TMPDIR")).join("ring").join(name);
    let _ = fs::remove_dir_all(&folder);
    fs::create_dir_all(&folder).unwrap();
    folder
}

fn positions(count: usize) -> Vec<[f32; 3]> {
    (0..count).map(|v| [v as f32, 1.0, f32::NAN]).collect()
}

#[test]
fn read_and_mapped() {
    let path = folder("read_and_mapped").join("torus.ring");
    let built = CheL2::from_faces(12, &conformance::torus(4, 3)).unwrap();
    ring::save(&path, &built, Some(&positions(12))).unwrap();
    let case = conformance::Case::counted("torus", 12, conformance::torus(4, 3));
    let check = |file: &File| {
        let mesh = file.mesh::<CheL2>().unwrap();
        conformance::incidence(&case, &mesh);
        conformance::edge_map(&case, &mesh);
        let found = bytemuck::cast_slice::<[f32; 3], u8>(file.positions().unwrap());
        assert_eq!(found, bytemuck::cast_slice::<[f32; 3], u8>(&positions(12)));
        assert_eq!(format!("{mesh:?}"), format!("{built:?}"));
    };
    check(&File::read(&path).unwrap());
    #[cfg(feature = "mmap")]
    {
        #[expect(unsafe_code, reason = "the file is of this test alone")]
        // SAFETY: nobody else knows the file, and it is not written to.
        let (open, trusted) = unsafe { (File::open(&path), File::open_trusted(&path)) };
        check(&open.unwrap());
        check(&trusted.unwrap());
    }
}

#[test]
fn save_replaces_whole_files() {
    let folder = folder("save_replaces_whole_files");
    let path = folder.join("mesh.ring");
    let small = CheL3::from_faces(3, &[[0, 1, 2]]).unwrap();
    ring::save(&path, &small, None).unwrap();
    let before = fs::read(&path).unwrap();
    let error = ring::save(&path, &small, Some(&positions(2))).unwrap_err();
    assert!(matches!(&error, Error::Write { path: Some(named), .. } if *named == path), "{error:?}");
    assert_eq!(fs::read(&path).unwrap(), before);
    let open = File::read(&path).unwrap();
    ring::save(&path, &CheL3::from_faces(4, &[[0, 1, 2], [2, 1, 3]]).unwrap(), None).unwrap();
    assert_eq!(open.mesh::<CheL3>().unwrap().to_faces(), [[0, 1, 2]]);
    assert_eq!(File::read(&path).unwrap().mesh::<CheL3>().unwrap().to_faces().len(), 2);
    assert_eq!(fs::read_dir(&folder).unwrap().count(), 1, "something was left behind");
    assert!(ring::save(&folder, &small, None).is_err());
    assert!(ring::save(folder.join("none").join("mesh.ring"), &small, None).is_err());
}

#[test]
fn what_is_no_file_of_ours() {
    let folder = folder("what_is_no_file_of_ours");
    let text = folder.join("text.ring");
    fs::write(&text, "v 0 0 0\n").unwrap();
    let error = File::read(&text).unwrap_err().to_string();
    assert!(error.ends_with("text.ring: byte 0: header: this is no .ring file"), "{error}");
    for path in [folder.join("none.ring"), folder.clone()] {
        assert!(matches!(File::read(&path), Err(Error::Io { .. })), "{}", path.display());
    }
    let whole = folder.join("whole.ring");
    ring::save(&whole, &CheL2::from_faces(3, &[[0, 1, 2]]).unwrap(), None).unwrap();
    let error = onering_io::load(&whole).unwrap_err().to_string();
    assert!(error.contains("to be opened with `onering::ring`"), "{error}");
    let bytes = fs::read(&whole).unwrap();
    for length in [0, 1, 8, 127, 128, bytes.len() - 1] {
        fs::write(&text, &bytes[..length]).unwrap();
        assert!(matches!(File::read(&text), Err(Error::Malformed { .. })), "{length}");
        #[cfg(feature = "mmap")]
        #[expect(unsafe_code, reason = "the file is of this test alone")]
        // SAFETY: nobody else knows the file, and it is not written to while it is open.
        unsafe {
            assert!(File::open(&text).is_err());
            assert!(File::open_trusted(&text).is_err());
        }
    }
}
