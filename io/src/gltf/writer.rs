//! A mesh as a GLB: one primitive, in one buffer, in a chunk of the file.

mod parts;

use std::io::{self, Write};

use serde_json::{Value, json};

use self::parts::{Data, Parts};
use super::MAGIC;
use crate::{Error, Format, MeshRef, Place, Reason};

const FLOAT: u32 = 5126;
const UNSIGNED_SHORT: u32 = 5123;
const UNSIGNED_INT: u32 = 5125;
const POINTS: u32 = 0;
const TRIANGLES: u32 = 4;
const ARRAY_BUFFER: u32 = 34962;
const ELEMENT_ARRAY_BUFFER: u32 = 34963;

/// The mesh as glTF has it.
///
/// - Faces name vertices, all of which are there; but where faces have values, which glTF has no place for, each face
///   has three vertices of its own instead.
/// - A mesh without faces is points, since glTF knows no empty list of triangles; one without vertices is a document
///   without meshes.
/// - The material is white, rough and seen from both sides: what a viewer takes by itself is metal.
pub(crate) fn write(mesh: &MeshRef<'_>, out: &mut dyn Write) -> io::Result<()> {
    let parts = Parts::of(mesh);
    let refused = |(place, reason)| io::Error::other(Error::malformed(Format::Glb, place, reason));
    // First, since the document asks for a walk over all positions.
    check_size(0, parts.bytes()).map_err(refused)?;
    let json = document(&parts).map_err(refused)?;
    let bytes = parts.bytes();
    let length = check_size(json.len() as u64, bytes).map_err(refused)?;
    out.write_all(MAGIC)?;
    [2, length, json.len() as u32].iter().try_for_each(|number| out.write_all(&number.to_le_bytes()))?;
    out.write_all(b"JSON")?;
    out.write_all(json.as_bytes())?;
    if bytes == 0 {
        return Ok(());
    }
    out.write_all(&(bytes as u32).to_le_bytes())?;
    out.write_all(b"BIN\0")?;
    parts.write_columns(out)
}

/// The length of a file of these chunks, if it can be said in 32 bits.
fn check_size(json: u64, bin: u64) -> Result<u32, (Place, Reason)> {
    let bytes = 12 + 8 + json + if bin > 0 { 8 + bin } else { 0 };
    let most = u64::from(u32::MAX);
    u32::try_from(bytes).map_err(|_| (Place::File, Reason::TooLarge { bytes, most }))
}

/// The JSON, filled up with spaces to a multiple of four.
fn document(parts: &Parts<'_>) -> Result<String, (Place, Reason)> {
    let mut document = json!({ "asset": { "version": "2.0", "generator": "onering" } });
    if parts.vertex_count() > 0 {
        let (views, accessors) = views_and_accessors(parts)?;
        let names = parts.columns.iter().enumerate();
        let attributes: Value = names.map(|(i, column)| (column.semantic.clone(), i)).collect();
        let mut primitive = json!({ "attributes": attributes, "material": 0 });
        primitive["mode"] = if parts.mesh.faces.is_empty() { POINTS } else { TRIANGLES }.into();
        if parts.has_indices() {
            primitive["indices"] = parts.columns.len().into();
        }
        document["scene"] = 0.into();
        document["scenes"] = json!([{ "nodes": [0] }]);
        document["nodes"] = json!([{ "mesh": 0 }]);
        document["meshes"] = json!([{ "primitives": [primitive] }]);
        let surface = json!({ "metallicFactor": 0.0, "roughnessFactor": 1.0 });
        document["materials"] = json!([{ "pbrMetallicRoughness": surface, "doubleSided": true }]);
        document["buffers"] = json!([{ "byteLength": parts.bytes() }]);
        document["bufferViews"] = views.into();
        document["accessors"] = accessors.into();
    }
    let mut text = document.to_string();
    text.extend(std::iter::repeat_n(' ', text.len().next_multiple_of(4) - text.len()));
    Ok(text)
}

/// One of each for each column, and for the indices.
fn views_and_accessors(parts: &Parts<'_>) -> Result<(Vec<Value>, Vec<Value>), (Place, Reason)> {
    let (mut views, mut accessors) = (Vec::new(), Vec::new());
    let mut start = 0;
    let mut view = |bytes: u64, target: u32| {
        views.push(json!({ "buffer": 0, "byteOffset": start, "byteLength": bytes, "target": target }));
        start += bytes;
    };
    for (i, column) in parts.columns.iter().enumerate() {
        view(parts.column_bytes(column), ARRAY_BUFFER);
        let count = parts.vertex_count();
        accessors.push(match &column.data {
            Data::Positions(positions) => {
                let [min, max] = parts.bounds(positions)?;
                json!({ "bufferView": i, "componentType": FLOAT, "count": count, "type": "VEC3",
                        "min": min, "max": max })
            }
            Data::Colours(_) => json!({ "bufferView": i, "componentType": UNSIGNED_SHORT,
                                        "normalized": true, "count": count, "type": "VEC4" }),
            Data::Values(_) => {
                parts.check_finite(i)?;
                json!({ "bufferView": i, "componentType": FLOAT, "count": count, "type": "SCALAR" })
            }
        });
    }
    if parts.has_indices() {
        view(parts.index_bytes(), ELEMENT_ARRAY_BUFFER);
        let (kind, count) = (parts.index_type().0, 3 * parts.mesh.faces.len());
        accessors.push(json!({ "bufferView": parts.columns.len(), "componentType": kind,
                               "count": count, "type": "SCALAR" }));
    }
    Ok((views, accessors))
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn sizes_beyond_32_bits_are_refused() {
        assert_eq!(check_size(4, 0), Ok(24));
        assert_eq!(check_size(4, u64::from(u32::MAX) - 35), Ok(u32::MAX - 3));
        let (bytes, most) = (1 << 32, u64::from(u32::MAX));
        assert_eq!(check_size(4, bytes - 32), Err((Place::File, Reason::TooLarge { bytes, most })));
    }
}
