//! The parts of a glTF document that hold geometry, in the model of the crate `gltf`. Whatever else a
//! document has is skipped unread.

use ::gltf::json::{Accessor, Asset, Buffer, Mesh, buffer};
use serde::Deserialize;

use super::narrow;

/// Those fields of `gltf::json::Root` that are looked at. The whole `Root` refuses documents that are valid:
/// in version 1.4.1 a scene must list its nodes and an animation its target node. It also takes some hundred
/// bytes for each empty node or material.
#[derive(Deserialize)]
#[serde(rename_all = "camelCase")]
pub(super) struct Document {
    pub(super) asset: Asset,
    #[serde(default)]
    pub(super) extensions_required: Vec<String>,
    #[serde(default)]
    pub(super) buffers: Vec<Buffer>,
    #[serde(default)]
    pub(super) buffer_views: Vec<buffer::View>,
    #[serde(default)]
    pub(super) accessors: Vec<Accessor>,
    #[serde(default)]
    pub(super) meshes: Vec<Mesh>,
}

impl Document {
    pub(super) fn parse(json: &[u8]) -> Result<Self, serde_json::Error> {
        let document = serde_json::from_slice(json)?;
        narrow::check(json)?;
        Ok(document)
    }
}
