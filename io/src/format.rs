//! Which formats there are, how one is recognised, read and written. A new format is a variant and a row here, and
//! a file of its own.

use std::fmt;
use std::io::{self, Write};
use std::path::Path;

use crate::load::Request;
use crate::{Error, MeshRef, SaveOptions, Triangles, gltf, obj, off, ply, ring, stl, vrml, x3d};

/// The file formats that this crate knows.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
#[non_exhaustive]
pub enum Format {
    /// Wavefront OBJ: text.
    Obj,
    /// glTF 2.0: JSON, with buffers in it or beside it.
    Gltf,
    /// glTF 2.0 in one binary file.
    Glb,
    /// Stanford PLY: a text header, then text or binary.
    Ply,
    /// X3D as XML.
    X3d,
    /// VRML97, and X3D in the classic encoding: text.
    Vrml,
    /// STL: triangles with corners of their own, binary or text.
    Stl,
    /// OFF: text.
    Off,
    /// Onering's own binary file of a structure. It is told from the others here, and read by `onering::ring`.
    Ring,
}

/// How a mesh is written in a format. The mesh has been checked; what else the format cannot hold is an [`Error`]
/// within the [`io::Error`].
pub(crate) type Writer = fn(&MeshRef<'_>, &mut dyn Write, SaveOptions) -> io::Result<()>;

struct Row {
    format: Format,
    name: &'static str,
    /// In lower case; the first one is that of new files.
    extensions: &'static [&'static str],
    /// Whether a file begins like one of this format. The first row that says so has it.
    begins: fn(&[u8]) -> bool,
    read: fn(&[u8], &Request<'_>) -> Result<Triangles, Error>,
    write: Option<Writer>,
}

/// Every format. Those with a mark of their own at the start come first, those that are guessed last.
const ROWS: &[Row] = &[
    Row {
        format: Format::Glb,
        name: "GLB",
        extensions: &["glb"],
        begins: |bytes| bytes.starts_with(gltf::MAGIC),
        read: gltf::read_request,
        write: Some(|mesh, out, _| gltf::write_glb(mesh, out)),
    },
    Row {
        format: Format::Ring,
        name: "ring",
        extensions: &["ring"],
        begins: |bytes| bytes.starts_with(&ring::MAGIC),
        read: |_, _| Err(ring::unsupported()),
        write: None,
    },
    // A binary STL begins with anything, such as an OBJ keyword; that its length fits by chance is out of the question.
    Row {
        format: Format::Stl,
        name: "STL",
        extensions: &["stl"],
        begins: stl::looks_like_stl,
        read: |bytes, request| stl::read(bytes, &request.options),
        write: Some(|mesh, out, _| stl::write(mesh, out)),
    },
    Row {
        format: Format::Ply,
        name: "PLY",
        extensions: &["ply"],
        begins: ply::begins_with_mark,
        read: |bytes, _| ply::read(bytes),
        write: Some(ply::write),
    },
    Row {
        format: Format::Gltf,
        name: "glTF",
        extensions: &["gltf"],
        begins: gltf::looks_like_json,
        read: gltf::read_request,
        write: None,
    },
    Row {
        format: Format::X3d,
        name: "X3D",
        extensions: &["x3d"],
        begins: x3d::looks_like_xml,
        read: |bytes, request| x3d::read_out_of(bytes, request.input_bytes),
        write: None,
    },
    // Before OBJ, whose comments begin with `#` as well.
    Row {
        format: Format::Vrml,
        name: "VRML",
        extensions: &["wrl", "vrml", "x3dv"],
        begins: vrml::begins_with_header,
        read: |bytes, request| vrml::read_out_of(bytes, request.input_bytes),
        write: None,
    },
    Row {
        format: Format::Off,
        name: "OFF",
        extensions: &["off"],
        begins: off::begins_with_keyword,
        read: |bytes, _| off::read(bytes),
        write: Some(|mesh, out, _| off::write(mesh, out)),
    },
    Row {
        format: Format::Obj,
        name: "OBJ",
        extensions: &["obj"],
        begins: obj::begins_with_keyword,
        read: |bytes, _| obj::read(bytes),
        write: Some(|mesh, out, _| obj::write(mesh, out)),
    },
];

impl Format {
    /// Every format, in the order in which they are tried on a file.
    pub fn all() -> impl ExactSizeIterator<Item = Self> {
        ROWS.iter().map(|row| row.format)
    }

    /// The format of a file, by its content first and its extension second: a GLB that was named `.obj`
    /// is read as a GLB. `None` if neither is known.
    pub fn of(path: &Path, bytes: &[u8]) -> Option<Self> {
        Self::of_content(bytes).or_else(|| Self::of_extension(path))
    }

    /// The format that the content shows, such as `glTF` at the very start for a GLB, or text whose first word is
    /// an OBJ keyword. Reads at most as far as the first word that is in no comment.
    pub fn of_content(bytes: &[u8]) -> Option<Self> {
        ROWS.iter().find(|row| (row.begins)(bytes)).map(|row| row.format)
    }

    /// The format that the extension names, in upper or lower case; `.gz` behind it is passed over.
    pub fn of_extension(path: &Path) -> Option<Self> {
        let extension = path.extension()?.to_str()?;
        if extension.eq_ignore_ascii_case("gz") {
            let inner = Path::new(path.file_stem()?);
            return inner.extension().and_then(|_| Self::of_extension(inner));
        }
        Self::of_name(extension)
    }

    /// The format with this extension, without its dot, in upper or lower case.
    pub fn of_name(extension: &str) -> Option<Self> {
        let has = |row: &&Row| row.extensions.iter().any(|known| extension.eq_ignore_ascii_case(known));
        ROWS.iter().find(has).map(|row| row.format)
    }

    /// The extensions that name the format, in lower case and without a dot; the first is that of new files.
    pub fn extensions(self) -> &'static [&'static str] {
        self.row().extensions
    }

    /// Whether [`save`](crate::save) can write it.
    pub fn is_written(self) -> bool {
        self.row().write.is_some()
    }

    pub(crate) fn read(self, bytes: &[u8], request: &Request<'_>) -> Result<Triangles, Error> {
        (self.row().read)(bytes, request)
    }

    pub(crate) fn writer(self) -> Option<Writer> {
        self.row().write
    }

    /// `.obj, .gltf, .glb`
    pub(crate) fn list() -> String {
        let all: Vec<String> =
            ROWS.iter().flat_map(|row| row.extensions).map(|name| format!(".{name}")).collect();
        all.join(", ")
    }

    /// The first extension of each format that is written: `.obj, .ply`
    pub(crate) fn list_written() -> String {
        let written = ROWS.iter().filter(|row| row.write.is_some());
        let all: Vec<String> = written.map(|row| format!(".{}", row.extensions[0])).collect();
        all.join(", ")
    }

    fn row(self) -> &'static Row {
        ROWS.iter().find(|row| row.format == self).unwrap_or(&ROWS[0])
    }
}

impl fmt::Display for Format {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.write_str(self.row().name)
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn every_extension_names_its_format() {
        for row in ROWS {
            assert_eq!(ROWS.iter().filter(|other| other.format == row.format).count(), 1);
            for extension in row.extensions {
                let upper = format!("a.{}", extension.to_uppercase());
                assert_eq!(Format::of_extension(Path::new(&upper)), Some(row.format));
                assert_eq!(Format::of_extension(Path::new(&(upper + ".gz"))), Some(row.format));
            }
        }
        assert_eq!(Format::of_extension(Path::new("obj")), None);
        assert_eq!(Format::of_extension(Path::new("a.gz.gz")), None);
    }
}
