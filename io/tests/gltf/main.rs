//! glTF documents and GLB files, written here, and the real ones as the crate gltf reads them.

mod accessors;
mod buffers;
#[path = "../common/mod.rs"]
mod common;
mod documents;
mod primitives;
mod real;

use common::{document, glb, le_bytes};
use onering_io::{Error, Place, Reason, Triangles, gltf};

const SQUARE: [f32; 12] = [0.0, 0.0, 0.0, 1.0, 0.0, 0.0, 0.0, 1.0, 0.0, 1.0, 1.0, 0.0];
const POINTS: [[f32; 3]; 4] = [[0.0, 0.0, 0.0], [1.0, 0.0, 0.0], [0.0, 1.0, 0.0], [1.0, 1.0, 0.0]];
const PRIMITIVE: Place = Place::Primitive { mesh: 0, primitive: 0 };

/// The square's four positions, then six indices of 16 bits; `primitives` is JSON.
fn square(primitives: &str) -> Vec<u8> {
    with(
        primitives,
        r#"{"bufferView": 0, "componentType": 5126, "count": 4, "type": "VEC3"},
           {"bufferView": 1, "componentType": 5123, "count": 6, "type": "SCALAR"}"#,
    )
}

fn with(primitives: &str, accessors: &str) -> Vec<u8> {
    let members = format!(
        r#""meshes": [{{"primitives": [{primitives}]}}], "accessors": [{accessors}],
           "buffers": [{{"byteLength": 60}}],
           "bufferViews": [{{"buffer": 0, "byteLength": 48}},
                           {{"buffer": 0, "byteOffset": 48, "byteLength": 12}}]"#
    );
    glb(&document(&members), &square_bytes())
}

fn square_bytes() -> Vec<u8> {
    let indices = [0u16, 1, 2, 2, 1, 3].map(u16::to_le_bytes);
    [le_bytes(&SQUARE), indices.concat()].concat()
}

fn parse(bytes: &[u8]) -> Triangles {
    gltf::read(bytes).unwrap_or_else(|error| panic!("{error}"))
}

fn refusal(bytes: &[u8]) -> (Place, Reason) {
    match gltf::read(bytes) {
        Err(Error::Malformed { place, reason, .. }) => (place, reason),
        other => panic!("{other:?}"),
    }
}
