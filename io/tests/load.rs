//! Files of any format, by content and by name.

use std::path::PathBuf;

use onering_io::{Error, Format, Place, Reason, bytes_of, load, read_at};

/// A folder of its own for each test, gone when the test ends.
struct Folder(PathBuf);

impl Folder {
    fn new(name: &str) -> Self {
        let path = std::env::temp_dir().join(format!("onering-load-{}-{name}", std::process::id()));
        std::fs::create_dir_all(&path).unwrap();
        Self(path)
    }

    fn file(&self, name: &str, bytes: &[u8]) -> PathBuf {
        let path = self.0.join(name);
        std::fs::write(&path, bytes).unwrap();
        path
    }
}

impl Drop for Folder {
    fn drop(&mut self) {
        let _ = std::fs::remove_dir_all(&self.0);
    }
}

#[test]
fn content_goes_before_the_extension() {
    let folder = Folder::new("content");
    for name in ["a.obj", "a.OBJ", "a", "a.txt", "a.glb"] {
        assert_eq!(load(folder.file(name, b"v 1 2 3\n")).unwrap().positions.len(), 1, "{name}");
    }
    let gltf = br#" {"asset": {"version": "2.0"}}"#;
    assert!(load(folder.file("b.obj", gltf)).is_ok());
    // What shows nothing goes by its extension.
    assert!(load(folder.file("empty.obj", b"")).is_ok());
    for (name, format) in [("empty.glb", Format::Glb), ("empty.gltf", Format::Gltf)] {
        let error = load(folder.file(name, b"")).unwrap_err();
        assert!(matches!(error, Error::Malformed { format: f, .. } if f == format), "{error}");
    }
}

#[test]
fn other_formats_are_refused_with_the_list_of_those_that_are_read() {
    let folder = Folder::new("other");
    let path = folder.file("a.step", b"ISO-10303-21;");
    let error = load(&path).unwrap_err();
    assert!(matches!(&error, Error::UnknownFormat { path: Some(p) } if *p == path));
    let extensions: Vec<String> =
        Format::all().flat_map(Format::extensions).map(|extension| format!(".{extension}")).collect();
    assert!(
        [".obj", ".gltf", ".x3d", ".wrl"].iter().all(|known| extensions.iter().any(|name| name == known))
    );
    let list = extensions.join(", ");
    let expected = format!("{}: not a known mesh format; supported are {list}", path.display());
    assert_eq!(error.to_string(), expected);
}

#[test]
fn errors_name_the_file_and_the_line() {
    let folder = Folder::new("errors");
    let path = folder.file("a.obj", b"v 0 0 0\nf 1 1 2\n");
    let error = load(&path).unwrap_err();
    assert!(matches!(error, Error::Malformed { place: Place::Line(2), .. }));
    assert_eq!(error.to_string(), format!("{}:2: face names vertex 2, but there are 1", path.display()));
    let unnamed = onering_io::read(b"v 0 0 0\nf 1 1 2\n").unwrap_err();
    assert_eq!(unnamed.to_string(), "OBJ line 2: face names vertex 2, but there are 1");
}

#[test]
fn what_is_no_file_is_named() {
    let folder = Folder::new("none");
    let error = load(&folder.0).unwrap_err();
    assert_eq!(error.to_string(), format!("{}: this is a directory, not a mesh file", folder.0.display()));
    let absent = folder.0.join("absent.obj");
    assert!(matches!(load(&absent).unwrap_err(), Error::Io { path, .. } if path == absent));
}

/// A device has no end, but for the null device.
#[cfg(unix)]
#[test]
fn devices_are_not_read() {
    let folder = Folder::new("device");
    let link = folder.0.join("zero.obj");
    std::os::unix::fs::symlink("/dev/zero", &link).unwrap();
    for path in [link.to_str().unwrap(), "/dev/zero"] {
        assert_eq!(
            load(path).unwrap_err().to_string(),
            format!("{path}: this is a device, which may have no end")
        );
    }
    assert_eq!(bytes_of("/dev/null").unwrap(), b"");
}

/// As a shell's `<(...)` gives it.
#[cfg(unix)]
#[test]
fn pipes_are_read_to_their_end() {
    use std::{io::Write, os::fd::AsRawFd};
    let (reader, mut writer) = std::io::pipe().unwrap();
    writer.write_all(b"v 1 2 3\n").unwrap();
    drop(writer);
    let mesh = load(format!("/dev/fd/{}", reader.as_raw_fd())).unwrap();
    assert_eq!(mesh.positions, [[1.0, 2.0, 3.0]]);
}

#[test]
fn a_buffer_that_is_missing_is_named_with_the_document_that_asks_for_it() {
    let folder = Folder::new("missing");
    let text =
        br#"{"asset": {"version": "2.0"}, "meshes": [{"primitives": [{"attributes": {"POSITION": 0}}]}],
        "buffers": [{"byteLength": 36, "uri": "a.bin"}], "bufferViews": [{"buffer": 0, "byteLength": 36}],
        "accessors": [{"bufferView": 0, "componentType": 5126, "count": 3, "type": "VEC3"}]}"#;
    let path = folder.file("a.gltf", text);
    let error = load(&path).unwrap_err();
    let beginning = format!("{}: {}: ", path.display(), folder.0.join("a.bin").display());
    assert!(error.to_string().starts_with(&beginning), "{error}");
    assert!(matches!(error, Error::Io { named_in: Some(document), .. } if document == path));
}

#[test]
fn bytes_at_hand_are_read_as_the_file_would_be() {
    let folder = Folder::new("bytes");
    for (name, bytes) in [("a.obj", &b"v 1 2 3\n"[..]), ("b.glb", b""), ("c.step", b"ISO")] {
        let path = folder.file(name, bytes);
        assert_eq!(bytes_of(&path).unwrap(), bytes);
        let [one, other] = [read_at(bytes, &path), load(&path)].map(|result| format!("{result:?}"));
        assert_eq!(one, other);
    }
}

/// Large OBJ and STL files are read in pieces: all is as if they had been in memory as a whole.
#[test]
fn large_files_are_read_as_their_bytes_would_be() {
    let folder = Folder::new("large");
    let obj = "v 0.25 -1e3 2\nv 1 1 1\nv 0 0 0\nf -1 -2 -3\nl 1 2\n".repeat(60_000);
    let mut stl = vec![0; 80];
    stl.extend(40_000u32.to_le_bytes());
    stl.extend(
        (0..40_000u32).flat_map(|i| (0..50).map(move |at| (i.wrapping_mul(77) >> (at % 5)) as u8 & 0x3F)),
    );
    let mut options = onering_io::Options::default();
    for (name, bytes) in [
        ("a.obj", obj.clone().into_bytes()),
        ("no.obj", (obj.clone() + "f 1 2 999999999\n").into_bytes()),
        ("bad.obj", (obj.clone() + "f 1 2 x\n" + &obj).into_bytes()),
        ("joined.obj", obj.replace("l 1", "l \\\n1").into_bytes()),
        ("returns.obj", obj.replace('\n', "\r").into_bytes()),
        ("comment.obj", ("# a\n".repeat(400_000) + &obj).into_bytes()),
        ("mark.obj", ("\u{FEFF}".to_owned() + &obj).into_bytes()),
        ("junk.obj", b"what is this\n".repeat(200_000)),
        ("short.stl", stl[..stl.len() - 1].to_vec()),
        ("long.stl", [&stl[..], b"more"].concat()),
        ("like-obj.stl", [b"v \n", &stl[3..]].concat()),
        ("a.stl", stl),
    ] {
        let path = folder.file(name, &bytes);
        for weld in [false, true] {
            options.weld_stl = weld;
            let [whole, pieces] = [options.read_at(&bytes, &path), options.load(&path)];
            assert_eq!(
                whole.is_ok(),
                !matches!(name, "no.obj" | "bad.obj" | "junk.obj" | "short.stl"),
                "{name}"
            );
            match (whole, pieces) {
                (Ok(whole), Ok(pieces)) => assert!(whole == pieces, "{name}"),
                (whole, pieces) => {
                    assert_eq!(whole.unwrap_err().to_string(), pieces.unwrap_err().to_string())
                }
            }
            let mut seen = Vec::new();
            if options.load_in_pieces(&path, |more| seen.extend_from_slice(more)).is_some() {
                assert!(seen == bytes, "{name}");
            } else {
                assert!(!matches!(name, "a.obj" | "joined.obj" | "mark.obj" | "a.stl"), "{name}");
            }
        }
    }
}

/// Each name of a file would be one more copy of it in memory, and one more reason for a larger mesh.
#[test]
fn a_file_with_many_names_is_read_and_counted_once() {
    let folder = Folder::new("names");
    folder.file("a.bin", &[0; 60_000]);
    // The second buffer is longer than the first one, the third shorter: all are there.
    let text = |count: usize| {
        format!(
            r#"{{"asset": {{"version": "2.0"}}, "meshes": [{{"primitives": [{{"attributes": {{"POSITION": 0}}}},
            {{"attributes": {{"POSITION": 1}}}}, {{"attributes": {{"POSITION": 2}}}},
            {{"attributes": {{"POSITION": 3}}, "indices": 4}}]}}],
            "buffers": [{{"byteLength": 36, "uri": "a.bin"}}, {{"byteLength": 60000, "uri": "./a.bin"}},
                {{"byteLength": 72, "uri": "%61.bin"}}],
            "bufferViews": [{{"buffer": 0, "byteLength": 36}}, {{"buffer": 1, "byteLength": 36}},
                {{"buffer": 2, "byteLength": 36}}],
            "accessors": [{{"bufferView": 0, "componentType": 5126, "count": 3, "type": "VEC3"}},
                {{"bufferView": 1, "componentType": 5126, "count": 3, "type": "VEC3"}},
                {{"bufferView": 2, "componentType": 5126, "count": 3, "type": "VEC3"}},
                {{"componentType": 5126, "count": {count}, "type": "VEC3"}},
                {{"bufferView": 0, "componentType": 5121, "count": 0, "type": "SCALAR"}}]}}"#
        )
    };
    // Three times three vertices and one face are not part of the count.
    let bytes = 60_000 + text(200_000).len();
    let most = 4 * bytes - 12;
    let path = folder.file("a.gltf", text(most).as_bytes());
    assert_eq!(load(&path).unwrap().positions.len(), most + 9);
    let path = folder.file("a.gltf", text(most + 1).as_bytes());
    let error = load(&path).unwrap_err();
    let expected = Reason::OutOfProportion { elements: 4 * bytes as u64 + 1, bytes: bytes as u64 };
    assert!(
        matches!(&error, Error::Malformed { place: Place::File, reason, .. } if *reason == expected),
        "{error}"
    );
}

#[test]
fn errors_play_no_tricks_on_a_terminal() {
    let error = onering_io::read("v \u{202E}\u{1B}[31m\u{2028} 0 0\n".as_bytes()).unwrap_err().to_string();
    assert_eq!(error, "OBJ line 1: `\u{FFFD}\u{FFFD}[31m\u{FFFD}` is not a number");
    let error = load("no\nsuch\u{202E}file").unwrap_err().to_string();
    assert!(error.starts_with("no\u{FFFD}such\u{FFFD}file: "), "{error}");
}
