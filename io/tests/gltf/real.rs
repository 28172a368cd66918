//! The real files, as the crate gltf reads them.

#[test]
fn real_files_agree_with_the_crate_gltf() {
    let Some((folder, entries)) = crate::common::meshes() else { return };
    let read = entries.iter().filter(|entry| ["glTF", "GLB"].contains(&entry["format"].as_str().unwrap()));
    for entry in read {
        let (name, path) = crate::common::path_of(&folder, entry);
        let (theirs, ours) = (their_positions(&path), onering_io::load(&path).unwrap().positions);
        if let Some(theirs) = theirs {
            assert!(ours == theirs, "{name}");
        }
    }
}

/// The positions by the crate gltf; `None` where a buffer is neither the BIN chunk nor a plain file.
fn their_positions(path: &std::path::Path) -> Option<Vec<[f32; 3]>> {
    let theirs = ::gltf::Gltf::open(path).unwrap();
    let buffer = |buffer: ::gltf::Buffer<'_>| match buffer.source() {
        ::gltf::buffer::Source::Bin => theirs.blob.clone(),
        ::gltf::buffer::Source::Uri(uri) => std::fs::read(path.with_file_name(uri)).ok(),
    };
    let buffers: Vec<Vec<u8>> = theirs.buffers().map(buffer).collect::<Option<_>>()?;
    let primitives = theirs.meshes().flat_map(|mesh| mesh.primitives());
    let positions = primitives.flat_map(|primitive| {
        let reader = primitive.reader(|buffer| buffers.get(buffer.index()).map(Vec::as_slice));
        reader.read_positions().unwrap().collect::<Vec<_>>()
    });
    Some(positions.collect())
}
