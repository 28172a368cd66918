//! glTF 2.0, as JSON or as a GLB: the triangles of all meshes.
//!
//! - Meshes come in document order, each once, however often nodes show it. Transforms of nodes are not
//!   applied; nodes, scenes, materials and animations are not even looked at.
//! - Each primitive appends its whole `POSITION` accessor: nothing is shared or merged between primitives.
//! - Triangle lists, strips and fans are read, indexed or not; points and lines are skipped, with a
//!   [note](Triangles::notes).
//! - Sparse accessors, strides and quantised positions (`KHR_mesh_quantization`) are read. Coordinates
//!   other than `f32` become `f32`; where the accessor says `normalized`, they are scaled to -1 ..= 1 first.
//! - An extension in `extensionsRequired` that may change geometry is an error that names it.
//!
//! The document is read into the model of the crate `gltf`, `gltf::json`, by serde alone. Neither its
//! validation nor its GLB reader is run: version 1.4.1 indexes out of bounds, a panic, while it validates a
//! primitive whose `POSITION` names no accessor; it subtracts below zero where a GLB claims fewer than 12
//! bytes; and it refuses `KHR_mesh_quantization`. What an accessor names is checked here, as it is used.

mod accessor;
mod buffers;
mod component;
mod document;
mod glb;
mod narrow;
mod origin;
mod primitive;
mod writer;

use std::path::Path;

use self::accessor::Source;
use self::document::Document;
use self::primitive::Assembly;
use crate::error::quote;
use crate::load::Request;
use crate::text::without_byte_order_mark;
use crate::{Error, Format, Place, Reason, Triangles};

pub(crate) use self::writer::write as write_glb;

pub use self::origin::{BufferKind, Origin};

/// The first bytes of every GLB.
pub(crate) const MAGIC: &[u8] = b"glTF";

/// Required extensions that leave positions and faces of the meshes as they are: they concern materials,
/// textures, lights and nodes. `KHR_mesh_quantization` is the one that does, and it is read.
const HARMLESS: [&str; 7] = [
    "KHR_mesh_quantization",
    "KHR_lights_punctual",
    "KHR_xmp_json_ld",
    "KHR_node_visibility",
    "KHR_animation_pointer",
    "EXT_mesh_gpu_instancing",
    "EXT_lights_image_based",
];
const HARMLESS_BEGINNINGS: [&str; 3] = ["KHR_materials_", "KHR_texture_", "EXT_texture_"];

/// Reads a glTF document or a GLB, whichever it is, whose buffers are all in it.
///
/// # Errors
/// As [`read_beside`]; a buffer in another file is [`Reason::Uri`].
pub fn read(bytes: &[u8]) -> Result<Triangles, Error> {
    read_format(bytes, format_of(bytes), None, bytes.len() as u64)
}

/// Reads a glTF document or a GLB whose buffers may be files in `folder`, or below it.
///
/// Only relative names are followed, percent-decoded: no absolute path, no `..`, no scheme such as `http:`,
/// and no link that leads out of the folder. Of each file no more is read than the buffer's `byteLength`.
///
/// Primitives may share accessors, so the mesh may be larger than the input, but by a limit: it may have up to
/// 4 vertices and faces for each byte of the document and its files, or 65,536 in all. They are counted before
/// the first one is decoded, and take 12 bytes each; while the indices of a primitive are read, its faces take
/// 12 more. A hostile document may take 140 bytes for each of its own while it is read.
///
/// # Errors
/// [`Error::Malformed`] with the mesh and primitive, or the buffer, at fault: broken JSON or GLB chunks, an
/// element that does not exist, an accessor that leaves its bufferView or buffer, a corner that names no
/// vertex, a reference that is not followed, a mesh beyond that limit. [`Error::Unsupported`] for required extensions.
/// [`Error::Io`] names the buffer's file that could not be read.
pub fn read_beside(bytes: &[u8], folder: &Path) -> Result<Triangles, Error> {
    read_format(bytes, format_of(bytes), Some(folder), bytes.len() as u64)
}

pub(crate) fn read_request(bytes: &[u8], request: &Request<'_>) -> Result<Triangles, Error> {
    read_format(bytes, request.format, request.folder, request.input_bytes)
}

fn read_format(
    bytes: &[u8],
    format: Format,
    folder: Option<&Path>,
    input_bytes: u64,
) -> Result<Triangles, Error> {
    let malformed = |place, reason| Error::malformed(format, place, reason);
    let glb::Parts { json, bin } = match format {
        Format::Glb => glb::split(bytes)?,
        _ => glb::Parts { json: without_byte_order_mark(bytes), bin: None },
    };
    let document = Document::parse(json)
        .map_err(|error| malformed(Place::File, Reason::Json { message: message_of(&error) }))?;
    check_version(&document).map_err(|reason| malformed(Place::File, reason))?;
    if let Some(feature) = unsupported_extension(&document) {
        return Err(Error::Unsupported { format, path: None, place: Place::File, feature });
    }
    let mut assembly = Assembly::new(Source::new(&document, format, bin, folder, input_bytes));
    for (i, mesh) in document.meshes.iter().enumerate() {
        for (j, primitive) in mesh.primitives.iter().enumerate() {
            assembly.plan(primitive, Place::Primitive { mesh: i, primitive: j })?;
        }
    }
    assembly.finish()
}

/// What the JSON reader says, shortened where it quotes a long string.
fn message_of(error: &serde_json::Error) -> String {
    let message = error.to_string();
    match message.len() {
        0..=250 => message,
        _ => format!("{} at line {} column {}", quote(message.as_bytes()), error.line(), error.column()),
    }
}

fn format_of(bytes: &[u8]) -> Format {
    if bytes.starts_with(MAGIC) { Format::Glb } else { Format::Gltf }
}

/// Whether the first character is the `{` of a JSON object.
pub(crate) fn looks_like_json(bytes: &[u8]) -> bool {
    without_byte_order_mark(bytes).trim_ascii_start().first() == Some(&b'{')
}

fn check_version(document: &Document) -> Result<(), Reason> {
    if let Some(version) = document.asset.min_version.as_ref().filter(|version| !is_met(version)) {
        return Err(Reason::MinVersion { version: quote(version.as_bytes()) });
    }
    let version = &document.asset.version;
    if version == "2" || version.starts_with("2.") {
        return Ok(());
    }
    Err(Reason::Version { version: quote(version.as_bytes()) })
}

/// Whether a reader of version 2.0 will do.
fn is_met(min_version: &str) -> bool {
    let (major, minor) = min_version.split_once('.').unwrap_or((min_version, "0"));
    let numbers = major.parse::<u32>().ok().zip(minor.parse::<u32>().ok());
    numbers.is_some_and(|numbers| numbers <= (2, 0))
}

fn unsupported_extension(document: &Document) -> Option<String> {
    let is_harmless = |name: &str| {
        HARMLESS.contains(&name) || HARMLESS_BEGINNINGS.iter().any(|beginning| name.starts_with(beginning))
    };
    let name = document.extensions_required.iter().find(|name| !is_harmless(name))?;
    Some(quote(name.as_bytes()))
}
