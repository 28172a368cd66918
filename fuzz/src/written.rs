//! What is written can be read, and is the same.
use onering_io::{Attribute, Format, MeshRef, Options, SaveOptions, Triangles, Values};

/// A mesh of the bytes, in every format that is written: four bytes a coordinate, one a corner.
pub fn written(bytes: &[u8]) {
    let &[vertices, choices, ref rest @ ..] = bytes else { return };
    let (coordinates, corners) = rest.split_at(rest.len().min(12 * usize::from(vertices % 32)));
    let number = |word: &[u8; 4]| f32::from_le_bytes(*word);
    let positions: Vec<[f32; 3]> =
        coordinates.as_chunks::<4>().0.as_chunks::<3>().0.iter().map(|p| p.each_ref().map(number)).collect();
    let count = positions.len().max(1);
    let corner = |byte: u8| u32::from(byte) % count as u32;
    let faces: Vec<[u32; 3]> = match positions.len() {
        0 => Vec::new(),
        _ => corners.as_chunks::<3>().0.iter().map(|face| face.map(corner)).collect(),
    };
    let labels: Vec<u32> = (0..positions.len() as u32).map(|v| v / 3).collect();
    let attributes = [Attribute { name: "part", values: Values::Labels(&labels) }];
    let mut mesh = MeshRef::new(&positions, &faces);
    if choices & 1 == 1 {
        mesh = mesh.with_vertex_attributes(&attributes);
    }
    let mut save = SaveOptions::default();
    save.ascii = choices & 2 == 2;
    Format::all().filter(|format| format.is_written()).for_each(|format| check(format, mesh, save));
}

fn check(format: Format, mesh: MeshRef<'_>, save: SaveOptions) {
    let mut file = Vec::new();
    if let Err(error) = save.write(&mut file, mesh, format) {
        // Of all formats only GLB refuses a mesh: it holds finite numbers only.
        assert_eq!(format, Format::Glb, "{error}");
        assert!(mesh.positions.as_flattened().iter().any(|x| !x.is_finite()), "{error}");
        return;
    }
    let mut options = Options::default();
    options.weld_stl = false;
    let read = options.read_as(&file, format).unwrap_or_else(|error| panic!("{format}: {error}"));
    let corners = |positions: &[[f32; 3]], faces: &[[u32; 3]]| -> Vec<_> {
        faces.as_flattened().iter().map(|&v| bits(positions[v as usize])).collect()
    };
    assert_eq!(corners(&read.positions, &read.faces), corners(mesh.positions, mesh.faces), "{format}");
    // STL has no vertices, and GLB without faces is a cloud of points, which is not read.
    if format != Format::Stl && !(format == Format::Glb && mesh.faces.is_empty()) {
        same(format, &read, mesh);
    }
}

fn same(format: Format, read: &Triangles, mesh: MeshRef<'_>) {
    assert_eq!(read.faces, mesh.faces, "{format}");
    assert!(read.positions.iter().map(|p| bits(*p)).eq(mesh.positions.iter().map(|p| bits(*p))), "{format}");
}

/// The bits of a position; text has one NaN only.
fn bits(position: [f32; 3]) -> [u32; 3] {
    position.map(|x| if x.is_nan() { f32::NAN.to_bits() } else { x.to_bits() })
}
