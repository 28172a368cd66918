//! Numbers that the model of the crate `gltf` cuts down to 32 bits in silence.
//!
//! Version 1.4.1 reads indices, modes and component types by `value as u32`, so that 2^32 names element 0.
//! What was cut cannot be told from the model afterwards. Hence the text is read a second time, only for
//! those of the numbers that are followed, and by serde's own `u32`, which refuses what does not fit and
//! says where. To look for long numbers without regard to their names would be no shorter, and would
//! refuse sizes, bounds and extras that are allowed to be large.

use serde::Deserialize;

/// Refuses a document that has such a number of 2^32 or more.
pub(super) fn check(json: &[u8]) -> Result<(), serde_json::Error> {
    serde_json::from_slice::<Document>(json).map(drop)
}

#[derive(Deserialize)]
#[serde(rename_all = "camelCase")]
#[expect(dead_code, reason = "that they can be read is all that is asked")]
struct Document {
    #[serde(default)]
    buffer_views: Vec<Reference>,
    #[serde(default)]
    accessors: Vec<Reference>,
    #[serde(default)]
    meshes: Vec<Mesh>,
}

/// A bufferView, an accessor, or the indices or values of a sparse one.
#[derive(Deserialize)]
#[serde(rename_all = "camelCase")]
#[expect(dead_code, reason = "as above")]
struct Reference {
    buffer: Option<u32>,
    buffer_view: Option<u32>,
    component_type: Option<u32>,
    sparse: Option<Box<Sparse>>,
}

#[derive(Deserialize)]
#[expect(dead_code, reason = "as above")]
struct Sparse {
    indices: Reference,
    values: Reference,
}

#[derive(Deserialize)]
#[expect(dead_code, reason = "as above")]
struct Mesh {
    primitives: Vec<Primitive>,
}

#[derive(Deserialize)]
#[expect(dead_code, reason = "as above")]
struct Primitive {
    attributes: Attributes,
    indices: Option<u32>,
    mode: Option<u32>,
}

#[derive(Deserialize)]
#[serde(rename_all = "UPPERCASE")]
#[expect(dead_code, reason = "as above")]
struct Attributes {
    position: Option<u32>,
}
