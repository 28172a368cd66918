//! Which formats there are, and how one is recognised. A new format starts here.

use std::fmt;
use std::path::Path;

/// The file formats that this crate reads.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
#[non_exhaustive]
pub enum Format {
    /// Wavefront OBJ: text.
    Obj,
    /// glTF 2.0: JSON, with buffers in it or beside it.
    Gltf,
    /// glTF 2.0 in one binary file.
    Glb,
    /// Onering's own binary file. It is told from the others here, and read by `onering::ring`.
    Ring,
}

/// Every format with the extension that names it.
const ALL: [(Format, &str); 4] =
    [(Format::Obj, "obj"), (Format::Gltf, "gltf"), (Format::Glb, "glb"), (Format::Ring, "ring")];

impl Format {
    /// The format of a file, by its content first and its extension second: a GLB that was named `.obj`
    /// is read as a GLB. `None` if neither is known.
    pub fn of(path: &Path, bytes: &[u8]) -> Option<Self> {
        Self::of_content(bytes).or_else(|| Self::of_extension(path))
    }

    /// The format that the content shows: `glTF` at the very start is a GLB, a JSON object is a glTF, and
    /// text whose first word is an OBJ keyword is an OBJ. Reads at most as far as the first word that is
    /// in no comment.
    pub fn of_content(bytes: &[u8]) -> Option<Self> {
        if bytes.starts_with(crate::gltf::MAGIC) {
            Some(Self::Glb)
        } else if bytes.starts_with(&crate::ring::MAGIC) {
            Some(Self::Ring)
        } else if crate::gltf::looks_like_json(bytes) {
            Some(Self::Gltf)
        } else {
            crate::obj::begins_with_keyword(bytes).then_some(Self::Obj)
        }
    }

    /// The format that the extension names, in upper or lower case.
    pub fn of_extension(path: &Path) -> Option<Self> {
        let extension = path.extension()?.to_str()?;
        ALL.iter().find(|(_, name)| extension.eq_ignore_ascii_case(name)).map(|(format, _)| *format)
    }

    /// `.obj, .gltf, .glb`: what this crate reads itself.
    pub(crate) fn list() -> String {
        let read = ALL.iter().filter(|(format, _)| *format != Self::Ring);
        read.map(|(_, name)| format!(".{name}")).collect::<Vec<_>>().join(", ")
    }
}

impl fmt::Display for Format {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.write_str(match self {
            Self::Obj => "OBJ",
            Self::Gltf => "glTF",
            Self::Glb => "GLB",
            Self::Ring => "ring",
        })
    }
}
