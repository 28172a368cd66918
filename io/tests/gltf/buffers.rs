//! Buffers in data URIs and in files.

use crate::common::document;
use onering_io::gltf::{self, BufferKind};
use onering_io::{Error, Place, Reason};

/// A document whose one buffer, of 36 bytes, is where `uri` says.
fn triangle_at(uri: &str) -> String {
    document(&format!(
        r#""meshes": [{{"primitives": [{{"attributes": {{"POSITION": 0}}}}]}}],
           "buffers": [{{"byteLength": 36, "uri": "{uri}"}}], "bufferViews": [{{"buffer": 0, "byteLength": 36}}],
           "accessors": [{{"bufferView": 0, "componentType": 5126, "count": 3, "type": "VEC3"}}]"#
    ))
}

#[test]
fn buffers_come_from_data_uris() {
    let zeros = "A".repeat(48);
    let read = |uri: String| gltf::read(triangle_at(&uri).as_bytes());
    let mesh = read(format!("data:application/octet-stream;base64,{zeros}")).unwrap();
    assert_eq!(mesh.faces, [[0, 1, 2]]);
    assert!(mesh.gltf.unwrap().buffers.into_iter().eq([BufferKind::DataUri]));
    assert!(read(format!("data:;base64,{zeros}AA==")).is_ok());
    for (uri, problem) in [
        (format!("data:;base64,{}", &zeros[..44]), "buffer 0 needs 36 bytes, but there are 33"),
        (format!("data:;base64,{}*", &zeros[..47]), "the data URI is not base64"),
        (format!("data:,{zeros}"), "only data URIs in base64 are read"),
        ("data:".into(), "the data URI has no comma"),
        ("a.bin".into(), "bytes in memory have no folder"),
    ] {
        let error = read(uri).unwrap_err();
        assert!(matches!(error, Error::Malformed { place: Place::Buffer(0), .. }), "{error}");
        assert!(error.to_string().contains(problem), "{error}");
    }
}

#[test]
fn buffers_come_from_files_of_the_same_folder_only() {
    let folder = std::env::temp_dir().join(format!("onering-gltf-{}", std::process::id()));
    std::fs::create_dir_all(folder.join("inner/sub dir")).unwrap();
    std::fs::write(folder.join("inner/sub dir/a.bin"), [0; 40]).unwrap();
    std::fs::write(folder.join("outside.bin"), [0; 40]).unwrap();
    let inner = folder.join("inner");
    #[cfg(unix)]
    std::os::unix::fs::symlink("../outside.bin", inner.join("link.bin")).unwrap();
    let read = |uri: &str| gltf::read_beside(triangle_at(uri).as_bytes(), &inner);
    let good = read("sub%20dir/a.bin");
    let bad = [
        "../outside.bin",
        "%2e%2e/outside.bin",
        "/etc/passwd",
        "file:///etc/passwd",
        "http://a/b",
        "link.bin",
    ];
    let bad = bad.map(|uri| (uri, read(uri)));
    let (folder_itself, absent) = (read("sub%20dir"), read("absent.bin"));
    std::fs::remove_dir_all(&folder).unwrap();
    let good = good.unwrap();
    assert_eq!(good.positions.len(), 3);
    assert!(good.gltf.unwrap().buffers.into_iter().eq([BufferKind::File]));
    for (uri, result) in bad {
        let error = result.unwrap_err();
        let refused = matches!(error, Error::Malformed { reason: Reason::Uri { .. }, .. });
        assert!(refused || cfg!(not(unix)) && uri == "link.bin", "{uri}: {error}");
    }
    assert!(folder_itself.unwrap_err().to_string().contains("not a regular file"));
    assert!(matches!(absent.unwrap_err(), Error::Io { path, .. } if path.ends_with("absent.bin")));
}
