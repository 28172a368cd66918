//! Files that take the place of others, or leave them alone.

mod arbitrary;

use std::fs;
use std::io::{self, Write};
use std::path::{Path, PathBuf};
use std::sync::atomic::{AtomicUsize, Ordering};

use onering_io::{Error, Format, MeshRef, Place, Reason, Replacement, save, save_as, write};

/// A folder of its own for a test, gone with it.
struct Folder(PathBuf);

impl Folder {
    fn new() -> Self {
        static COUNT: AtomicUsize = AtomicUsize::new(0);
        let number = COUNT.fetch_add(1, Ordering::Relaxed);
        let path = std::env::temp_dir().join(format!("onering-write-{}-{number}", std::process::id()));
        fs::create_dir(&path).unwrap();
        Self(path)
    }

    fn file(&self, name: &str, content: &[u8]) -> PathBuf {
        let path = self.0.join(name);
        fs::write(&path, content).unwrap();
        path
    }

    /// The names in it, in order.
    fn names(&self) -> Vec<String> {
        let entries = fs::read_dir(&self.0).unwrap();
        let mut names: Vec<_> =
            entries.map(|entry| entry.unwrap().file_name().into_string().unwrap()).collect();
        names.sort();
        names
    }
}

impl Drop for Folder {
    fn drop(&mut self) {
        let _ = fs::remove_dir_all(&self.0);
    }
}

const OLD: &[u8] = b"what was there";

/// A mesh of `side` x `side` vertices, in so many triangles.
fn grid(side: u32) -> arbitrary::Mesh {
    let positions = (0..side * side).map(|i| [(i % side) as f32, (i / side) as f32, 0.1]).collect();
    let corners = (0..(side - 1) * (side - 1)).map(|i| i / (side - 1) * side + i % (side - 1));
    let faces = corners.flat_map(|a| [[a, a + 1, a + side], [a + 1, a + side + 1, a + side]]).collect();
    arbitrary::Mesh { positions, faces, polygon_starts: None }
}

fn bytes(mesh: MeshRef<'_>, format: Format) -> Vec<u8> {
    let mut file = Vec::new();
    write(&mut file, mesh, format).unwrap();
    file
}

fn written_formats() -> impl Iterator<Item = Format> {
    Format::all().filter(|format| format.is_written())
}

/// Takes a number of bytes, and then no more.
struct Full(usize);

impl Write for Full {
    fn write(&mut self, bytes: &[u8]) -> io::Result<usize> {
        let taken = bytes.len().min(self.0);
        self.0 -= taken;
        if taken == 0 { Err(io::ErrorKind::StorageFull.into()) } else { Ok(taken) }
    }

    fn flush(&mut self) -> io::Result<()> {
        Ok(())
    }
}

#[test]
fn a_disk_that_is_full_is_an_error_at_every_byte() {
    let mesh = arbitrary::square();
    for format in written_formats() {
        let whole = bytes(mesh.as_ref(), format).len();
        for room in 0..whole {
            match write(Full(room), mesh.as_ref(), format) {
                Err(Error::Write { path: None, source }) => {
                    assert_eq!(source.kind(), io::ErrorKind::StorageFull)
                }
                other => panic!("{format} with room for {room}: {other:?}"),
            }
        }
        assert!(write(Full(whole), mesh.as_ref(), format).is_ok());
    }
    // Beyond what the buffers hold.
    let mesh = grid(120);
    for format in written_formats() {
        let whole = bytes(mesh.as_ref(), format).len();
        for room in [whole / 2, 1 << 16, (1 << 16) + 1, whole - 1] {
            assert!(write(Full(room), mesh.as_ref(), format).is_err(), "{format} with room for {room}");
        }
    }
}

#[test]
fn a_replacement_that_is_dropped_leaves_no_trace() {
    let folder = Folder::new();
    let path = folder.file("a.obj", OLD);
    for length in 0..20 {
        let mut file = Replacement::create(&path).unwrap();
        file.write_all(&vec![b'x'; length]).unwrap();
        assert_eq!(folder.names().len(), 2);
        drop(file);
        assert_eq!((folder.names(), fs::read(&path).unwrap()), (vec!["a.obj".into()], OLD.into()));
    }
}

#[test]
fn a_panic_leaves_no_trace() {
    let folder = Folder::new();
    let path = folder.file("a.obj", OLD);
    let panicked = std::panic::catch_unwind(|| {
        let mut file = Replacement::create(&path).unwrap();
        file.write_all(b"half of it").unwrap();
        panic!("in the middle");
    });
    assert!(panicked.is_err());
    assert_eq!((folder.names(), fs::read(&path).unwrap()), (vec!["a.obj".into()], OLD.into()));
}

#[test]
fn a_mesh_that_is_refused_leaves_the_old_file() {
    let folder = Folder::new();
    let path = folder.file("a.glb", OLD);
    let reason = |result| match result {
        Err(Error::Malformed { path: Some(_), place, reason, .. }) => (place, reason),
        other => panic!("{other:?}"),
    };
    let beyond = Reason::IndexOutOfRange { index: "1".into(), vertices: 1 };
    assert_eq!(reason(save(&path, MeshRef::new(&[[0.0; 3]], &[[0, 0, 1]]))), (Place::Face(0), beyond));
    let not_finite = Reason::NotFinite { what: "position".into() };
    assert_eq!(reason(save(&path, MeshRef::new(&[[f32::NAN; 3]], &[]))), (Place::Vertex(0), not_finite));
    assert!(matches!(save_as(&path, MeshRef::default(), Format::Gltf), Err(Error::ReadOnly { .. })));
    assert_eq!((folder.names(), fs::read(&path).unwrap()), (vec!["a.glb".into()], OLD.into()));
}

#[test]
fn folders_and_what_is_not_there_are_errors_that_name_the_file() {
    let folder = Folder::new();
    fs::create_dir(folder.0.join("folder.obj")).unwrap();
    folder.file("file", OLD);
    let mesh = arbitrary::square();
    for name in ["folder.obj", "no such folder/a.obj", "file/a.obj"] {
        let path = folder.0.join(name);
        match save(&path, mesh.as_ref()) {
            Err(error @ Error::Write { .. }) => {
                assert!(error.to_string().starts_with(&*path.to_string_lossy()), "{error}")
            }
            other => panic!("{name}: {other:?}"),
        }
        assert_eq!(folder.names(), ["file", "folder.obj"]);
    }
    assert!(fs::read_dir(folder.0.join("folder.obj")).unwrap().next().is_none());
    assert!(save_as(Path::new(""), mesh.as_ref(), Format::Obj).is_err());
    assert!(save_as(Path::new("/"), mesh.as_ref(), Format::Obj).is_err());
}

#[test]
fn two_runs_at_once_leave_one_of_two_files() {
    let folder = Folder::new();
    let path = folder.0.join("a.ply");
    let meshes = [grid(40), grid(41)];
    let files = meshes.each_ref().map(|mesh| bytes(mesh.as_ref(), Format::Ply));
    save(&path, meshes[0].as_ref()).unwrap();
    std::thread::scope(|scope| {
        for mesh in &meshes {
            scope.spawn(|| (0..20).for_each(|_| save(&path, mesh.as_ref()).unwrap()));
        }
        scope.spawn(|| (0..100).for_each(|_| assert!(files.contains(&fs::read(&path).unwrap()))));
    });
    assert!(files.contains(&fs::read(&path).unwrap()));
    assert_eq!(folder.names(), ["a.ply"]);
}

#[test]
fn names_may_be_as_long_as_the_system_has_them() {
    let folder = Folder::new();
    let name = "a".repeat(251) + ".obj";
    save(folder.0.join(&name), arbitrary::square().as_ref()).unwrap();
    assert_eq!(folder.names(), [name]);
}

#[cfg(unix)]
mod unix {
    use std::os::unix::fs::{PermissionsExt, symlink};
    use std::process::Command;

    use super::*;

    #[test]
    fn permissions_stay() {
        let folder = Folder::new();
        let path = folder.file("a.obj", OLD);
        for mode in [0o600, 0o755, 0o666] {
            fs::set_permissions(&path, fs::Permissions::from_mode(mode)).unwrap();
            let file = Replacement::create(&path).unwrap();
            for name in folder.names() {
                let now = fs::metadata(folder.0.join(&name)).unwrap().permissions().mode();
                assert_eq!(now & 0o7777, mode, "{name} before there is something in it");
            }
            file.finish().unwrap();
            assert_eq!(fs::metadata(&path).unwrap().permissions().mode() & 0o7777, mode);
        }
    }

    #[test]
    fn a_file_that_may_not_be_written_is_not_replaced() {
        let folder = Folder::new();
        let path = folder.file("a.obj", OLD);
        fs::set_permissions(&path, fs::Permissions::from_mode(0o444)).unwrap();
        // The superuser may write it all the same.
        let allowed = fs::File::options().write(true).open(&path).is_ok();
        assert_eq!(save(&path, arbitrary::square().as_ref()).is_ok(), allowed);
        assert_eq!(fs::read(&path).unwrap() != OLD, allowed);
        assert_eq!(folder.names(), ["a.obj"]);
    }

    #[test]
    fn links_stay_and_what_they_lead_to_is_written() {
        let folder = Folder::new();
        fs::create_dir(folder.0.join("sub")).unwrap();
        folder.file("sub/old.obj", OLD);
        let mesh = arbitrary::square();
        let expected = bytes(mesh.as_ref(), Format::Obj);
        for (link, to) in
            [("a.obj", "sub/old.obj"), ("b.obj", "a.obj"), ("c.obj", "sub/new.obj"), ("d.obj", "c.obj")]
        {
            let path = folder.0.join(link);
            symlink(to, &path).unwrap();
            save(&path, mesh.as_ref()).unwrap();
            assert_eq!(fs::read_link(&path).unwrap(), Path::new(to));
            assert_eq!(fs::read(&path).unwrap(), expected);
            fs::write(&path, OLD).unwrap();
        }
        fs::remove_file(folder.0.join("sub/new.obj")).unwrap();
        save(folder.0.join("d.obj"), mesh.as_ref()).unwrap();
        assert_eq!(fs::read(folder.0.join("sub/new.obj")).unwrap(), expected);
        symlink("round.obj", folder.0.join("round.obj")).unwrap();
        assert!(save(folder.0.join("round.obj"), mesh.as_ref()).is_err());
        assert_eq!(folder.names(), ["a.obj", "b.obj", "c.obj", "d.obj", "round.obj", "sub"]);
    }

    #[test]
    fn what_a_killed_run_left_is_stepped_over() {
        let folder = Folder::new();
        let left: Vec<_> = (0..200).map(|n| format!(".onering-{}-{n}.tmp", std::process::id())).collect();
        left.iter().for_each(|name| drop(folder.file(name, OLD)));
        save(folder.0.join("a.obj"), arbitrary::square().as_ref()).unwrap();
        assert!(left.iter().all(|name| fs::read(folder.0.join(name)).unwrap() == OLD));
        assert_eq!(folder.names().len(), 201);
    }

    /// Not for Unix as such: `/dev/full` is there on Linux and FreeBSD.
    #[test]
    fn a_device_is_written_to_and_its_errors_are_told() {
        if !Path::new("/dev/full").exists() {
            return;
        }
        let mesh = arbitrary::square();
        for format in written_formats() {
            let error = save_as("/dev/full", mesh.as_ref(), format).unwrap_err();
            assert!(matches!(error, Error::Write { path: Some(_), .. }), "{error}");
            save_as("/dev/null", mesh.as_ref(), format).unwrap();
        }
    }

    const CHILD: &str = "ONERING_SAVE_IN_CHILD";

    /// What the process does that may not write large files; a test that does nothing where it was not asked for.
    #[test]
    fn in_child() {
        let Some(folder) = std::env::var_os(CHILD) else { return };
        for name in ["a.obj", "a.ply", "a.glb", "a.ply.gz"] {
            let error = save(Path::new(&folder).join(name), grid(100).as_ref()).unwrap_err();
            match error {
                Error::Write { source, .. } => assert_eq!(source.kind(), io::ErrorKind::FileTooLarge),
                other => panic!("{name}: {other:?}"),
            }
        }
        save(Path::new(&folder).join("small.obj"), arbitrary::square().as_ref()).unwrap();
    }

    /// The system's own refusal in the middle of a file, whoever runs the test.
    #[test]
    fn a_file_that_grows_too_large_leaves_the_old_one() {
        let folder = Folder::new();
        let names = ["a.glb", "a.obj", "a.ply", "a.ply.gz"];
        names.iter().for_each(|name| drop(folder.file(name, OLD)));
        // A block or two of 512 or 1024 bytes. Ignored, the signal leaves the error of the call.
        let limited = r#"trap '' XFSZ; ulimit -f 2; exec "$0" --exact unix::in_child --nocapture"#;
        let child = Command::new("sh")
            .args(["-c", limited])
            .arg(std::env::current_exe().unwrap())
            .env(CHILD, &folder.0)
            .output()
            .unwrap();
        assert!(child.status.success(), "{}", String::from_utf8_lossy(&child.stderr));
        assert!(String::from_utf8_lossy(&child.stdout).contains("1 passed"));
        for name in names {
            assert_eq!(fs::read(folder.0.join(name)).unwrap(), OLD, "{name}");
        }
        assert_eq!(folder.names(), ["a.glb", "a.obj", "a.ply", "a.ply.gz", "small.obj"]);
    }
}

/// What `/dev/stdout` leads to where standard output was redirected: others write to it as well.
#[cfg(target_os = "linux")]
#[test]
fn an_open_file_by_another_name_is_not_replaced() {
    use std::os::fd::AsRawFd;
    let path = std::env::temp_dir().join(format!("onering-descriptor-{}.obj", std::process::id()));
    std::fs::write(&path, "old").unwrap();
    let file = std::fs::File::open(&path).unwrap();
    let mesh = onering_io::Triangles::new(vec![[0.0; 3]], Vec::new());
    for list in ["/dev/fd", "/proc/self/fd"] {
        let name = format!("{list}/{}", file.as_raw_fd());
        let error = onering_io::save_as(&name, &mesh, onering_io::Format::Obj).unwrap_err().to_string();
        assert!(error.starts_with(&name) && error.contains("not replaced"), "{error}");
    }
    let content = std::fs::read_to_string(&path).unwrap();
    std::fs::remove_file(&path).unwrap();
    assert_eq!(content, "old");
}
