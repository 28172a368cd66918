//! What every reader promises, for any bytes.
use onering_io::{Error, Format, Triangles, obj, obj_attributes, read, read_as, read_in_pieces};
use std::mem::take;

/// Reads the bytes as this format.
pub fn reads(bytes: &[u8], format: Format) {
    check(bytes, || read_as(bytes, format), most_bytes(bytes, Some(format)));
    if format == Format::Obj {
        attributes(bytes);
    }
    in_pieces(bytes, format);
}

/// A large file is read in pieces, wherever their borders lie, to the same mesh; or as a whole, where that says what is
/// wrong with it. A packed one is not.
fn in_pieces(bytes: &[u8], format: Format) {
    if bytes.starts_with(&[0x1F, 0x8B, 8]) {
        return;
    }
    let whole = read_as(bytes, format).ok();
    for size in [1, 3, 8, 61] {
        match (read_in_pieces(bytes, format, size), &whole) {
            (Some(mesh), Some(whole)) => same(mesh, whole.clone()),
            (Some(_), None) => panic!("what is refused as a whole is read in pieces of {size}"),
            (None, whole) => assert!(format != Format::Obj || whole.is_none(), "not in pieces of {size}"),
        }
    }
}

/// Reads the bytes as what they look like.
pub fn reads_any(bytes: &[u8]) {
    check(bytes, || read(bytes), most_bytes(bytes, Format::of_content(bytes)));
}

fn check(bytes: &[u8], read: impl Fn() -> Result<Triangles, Error>, most: usize) {
    match (read(), read()) {
        (Ok(mesh), Ok(again)) => {
            holds_together(&mesh);
            let size = size_of_val(&mesh.positions[..])
                + size_of_val(&mesh.faces[..])
                + mesh.polygon_starts.as_ref().map_or(0, |starts| size_of_val(&starts[..]));
            assert!(size <= most, "{size} bytes from {}", bytes.len());
            same(mesh, again);
        }
        (Err(error), Err(again)) => {
            let message = error.to_string();
            assert!(!message.is_empty() && !message.contains(char::is_control), "{message:?}");
            assert_eq!(message, again.to_string());
        }
        (first, second) => panic!("{:?}, and again: {:?}", first.err(), second.err()),
    }
}

/// The bound on the result that `onering_io::load` states; the widest where the format is not known.
fn most_bytes(bytes: &[u8], format: Option<Format>) -> usize {
    let is_packed = bytes.starts_with(&[0x1F, 0x8B, 8]);
    let unpacked = if is_packed { (100 * bytes.len()).max(16 << 20) } else { bytes.len() };
    match format {
        Some(Format::Stl) => 2 * unpacked,
        Some(Format::Obj | Format::Off) => 6 * unpacked,
        Some(Format::Ply) => 16 * unpacked,
        Some(Format::Gltf | Format::Glb) => (48 * unpacked).max(800_000),
        _ => (54 * unpacked).max(900_000),
    }
}

/// Corners name positions, and the polygons are the faces in order.
fn holds_together(mesh: &Triangles) {
    let count = mesh.positions.len();
    assert!(mesh.faces.as_flattened().iter().all(|&corner| (corner as usize) < count));
    let cut = mesh.polygon_sizes.iter().map(|(&corners, &polygons)| polygons * (corners - 2)).sum::<usize>();
    assert_eq!(cut, mesh.faces.len(), "{:?}", mesh.polygon_sizes);
    assert!(mesh.polygon_sizes.values().all(|&polygons| polygons > 0), "{:?}", mesh.polygon_sizes);
    let mut sizes = mesh.polygon_sizes.clone();
    let (mut end, mut polygons) = (0, 0);
    for (p, polygon) in mesh.polygons().enumerate() {
        assert!(polygon.start == end && polygon.end > end, "polygon {p} is {polygon:?} after {end}");
        assert_eq!(mesh.polygon(polygon.start), Some(p));
        assert_eq!(mesh.polygon(polygon.end - 1), Some(p));
        let left = sizes.get_mut(&(polygon.len() + 2)).expect("a polygon of that size");
        *left = left.checked_sub(1).expect("one more polygon of that size");
        (end, polygons) = (polygon.end, p + 1);
    }
    assert_eq!((end, polygons), (mesh.faces.len(), mesh.polygon_count()));
    assert_eq!(mesh.polygon(end), None);
    for note in &mesh.notes {
        let line = note.to_string();
        assert!(note.count > 0 && !line.contains(char::is_control), "{line:?}");
    }
}

/// Bit by bit: a NaN is not equal to itself.
fn same(mut first: Triangles, mut second: Triangles) {
    let bits = |mesh: &mut Triangles| take(&mut mesh.positions).into_iter().map(|p| p.map(f32::to_bits));
    assert!(bits(&mut first).eq(bits(&mut second)));
    assert_eq!(first, second);
}

/// The attributes of an OBJ file belong to the faces that are read without them.
fn attributes(bytes: &[u8]) {
    let (Ok(found), Ok(mesh)) = (obj_attributes::read(bytes), obj::read(bytes)) else { return };
    let lengths = [found.corner_texcoords.len(), found.corner_normals.len(), found.face_materials.len()];
    assert_eq!(lengths, [mesh.faces.len(); 3]);
    let in_range = |corner: &Option<u32>, count| corner.is_none_or(|at| (at as usize) < count);
    assert!(found.corner_texcoords.as_flattened().iter().all(|at| in_range(at, found.texcoords.len())));
    assert!(found.corner_normals.as_flattened().iter().all(|at| in_range(at, found.normals.len())));
    assert!(found.face_materials.iter().all(|at| in_range(at, found.materials.len())));
}
