//! PLY files written here: what is read, what is refused, and that no damage breaks the reader.

mod binary;
mod damage;
mod header;
mod random;
mod strips;
mod text;

use onering_io::{Error, Format, Place, Reason, Triangles, read_as};

const VERTICES: &str = "element vertex 4\nproperty float x\nproperty float y\nproperty float z\n";
const FACES: &str = "property list uchar int vertex_indices\n";
const POINTS: [[f32; 3]; 4] = [[0.0, 0.0, 0.0], [1.0, 0.0, 0.0], [1.0, 1.0, 0.0], [0.0, 1.0, 0.5]];
const POINT_LINES: &str = "0 0 0\n1 0 0\n1 1 0\n0 1 .5\n";

/// A text file of these declarations and this body.
fn text(declarations: &str, body: &str) -> String {
    format!("ply\nformat ascii 1.0\n{declarations}end_header\n{body}")
}

/// The four points, with faces as text.
fn faces(count: usize, lines: &str) -> String {
    text(&format!("{VERTICES}element face {count}\n{FACES}"), &format!("{POINT_LINES}{lines}"))
}

/// The same as little endian bytes.
fn binary(declarations: &str, body: &[u8]) -> Vec<u8> {
    let mut file = format!("ply\nformat binary_little_endian 1.0\n{declarations}end_header\n").into_bytes();
    file.extend(body);
    file
}

fn point_bytes() -> Vec<u8> {
    POINTS.iter().flatten().flat_map(|number| number.to_le_bytes()).collect()
}

fn read(file: impl AsRef<[u8]>) -> Triangles {
    read_as(file.as_ref(), Format::Ply).unwrap()
}

/// Where and why the file is refused; the error must be of one line.
fn refused(file: impl AsRef<[u8]>) -> (Place, Reason) {
    let error = read_as(file.as_ref(), Format::Ply).unwrap_err();
    assert!(!error.to_string().contains('\n'), "{error}");
    match error {
        Error::Malformed { format: Format::Ply, place, reason, .. } => (place, reason),
        error => panic!("{error}"),
    }
}
