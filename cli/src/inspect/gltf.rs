//! What a glTF document holds besides the mesh. Only of documents that were read without an error.

use serde_json::Value;
use std::collections::BTreeSet;

/// How many primitives the mesh came from, and from what kinds of buffers.
#[derive(Clone, Debug, Default, PartialEq, Eq)]
pub(crate) struct Document {
    pub(crate) primitives: usize,
    pub(crate) buffers: BTreeSet<&'static str>,
}

impl Document {
    /// From the bytes of a glTF or GLB file.
    pub(crate) fn of(bytes: &[u8]) -> Self {
        let json = serde_json::from_slice(json_of(bytes)).unwrap_or(Value::Null);
        let mut document = Self::default();
        for primitive in items(&json["meshes"]).flat_map(|mesh| items(&mesh["primitives"])) {
            if is_read(primitive) {
                document.primitives += 1;
                document.add_accessor(&json, &primitive["attributes"]["POSITION"]);
                document.add_accessor(&json, &primitive["indices"]);
            }
        }
        document
    }

    fn add_accessor(&mut self, json: &Value, index: &Value) {
        let accessor = item(&json["accessors"], index);
        let sparse = &accessor["sparse"];
        for view in [accessor, &sparse["indices"], &sparse["values"]] {
            let view = item(&json["bufferViews"], &view["bufferView"]);
            let buffer = item(&json["buffers"], &view["buffer"]);
            if !buffer.is_null() {
                self.buffers.insert(kind(buffer["uri"].as_str()));
            }
        }
    }
}

fn kind(uri: Option<&str>) -> &'static str {
    match uri {
        None => "bin chunk",
        Some(uri) if uri.starts_with("data:") => "data uri",
        Some(_) => "external bin",
    }
}

/// Triangles, strips and fans, where they have positions.
fn is_read(primitive: &Value) -> bool {
    let mode = primitive["mode"].as_u64().unwrap_or(4);
    (4..=6).contains(&mode) && !primitive["attributes"]["POSITION"].is_null()
}

/// The JSON chunk of a GLB, which comes first; else the whole file, without the mark of UTF-8.
fn json_of(bytes: &[u8]) -> &[u8] {
    match bytes.strip_prefix(b"glTF") {
        None => bytes.strip_prefix(b"\xef\xbb\xbf").unwrap_or(bytes),
        Some(_) => {
            let length =
                bytes.get(12..16).and_then(|word| word.try_into().ok()).map_or(0, u32::from_le_bytes);
            bytes.get(20..).and_then(|rest| rest.get(..length as usize)).unwrap_or_default()
        }
    }
}

fn items(list: &Value) -> impl Iterator<Item = &Value> {
    list.as_array().into_iter().flatten()
}

fn item<'a>(list: &'a Value, index: &Value) -> &'a Value {
    let index = index.as_u64().map(|index| index as usize);
    index.and_then(|index| list.get(index)).unwrap_or(&Value::Null)
}
