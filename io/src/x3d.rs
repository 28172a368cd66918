//! X3D as XML: the faces of all geometry nodes.
//!
//! - `IndexedFaceSet`, `IndexedTriangleSet`, `TriangleSet`, `IndexedTriangleStripSet` and `IndexedTriangleFanSet` are
//!   read in the order of the file, each once: a `USE` of a whole node adds nothing but a note. Each appends all points of its
//!   `Coordinate`, again for every node that names it by `USE`.
//! - Transforms are not applied, and with `ccw="false"` corners stay in the order of the file (a
//!   [note](Triangles::notes) says so). The bodies of prototypes are passed over, and no `Inline` or other file is
//!   opened: a note counts each `ProtoInstance` and each `Inline`.
//! - Other geometry, such as `Box`, is skipped with a note, and so are faces of fewer than three corners and geometry
//!   without a `Coordinate`. Elements that have nothing to do with faces may hold anything that is well-formed.
//! - A negative number ends a face; after the last one it may be missing. Commas are blanks. Numbers are decimal, with
//!   `inf` and `nan`; indices are decimal integers. Any other word among them is an error.
//! - A `USE` refers to the `Coordinate` with its name, which may come later in the file; of several, to the last.
//! - Namespaces are not looked at: `x3d:Shape` is `Shape`.
//! - Text is UTF-8. Character references such as `&#10;` and the five entities of XML itself are resolved; a file that
//!   declares an entity, or names another one, is refused. A document type is not looked up.
//!
//! The crate `quick-xml` splits the document into tags and attributes, in place.

mod attributes;

use quick_xml::Reader as Xml;
use quick_xml::escape::unescape;
use quick_xml::events::{BytesDecl, BytesStart, Event};

use self::attributes::{Attributes, Fault, unknown_reference};
use crate::error::quote;
use crate::memory::push;
use crate::scene::{Coordinates, Kind, Node, Scene};
use crate::text::without_byte_order_mark;
use crate::{Error, Format, Place, Reason, Skipped, Triangles};

const NO_ROOT: &str = "X3D: its root element is not `X3D`";

/// Whether the first character is the `<` of an XML document.
pub(crate) fn looks_like_xml(bytes: &[u8]) -> bool {
    without_byte_order_mark(bytes).trim_ascii_start().first() == Some(&b'<')
}

/// Reads the geometry of an X3D document. Linear in its size; elements may lie in one another 10,000 deep.
///
/// Geometry nodes may share their points, so the mesh may be larger than the file, but by a limit: it may have up to
/// 4 vertices and faces for each byte of the file, or 65,536 in all.
///
/// # Errors
/// [`Error::Malformed`] with the line at fault: XML that is not well-formed, ends early or has another root than `X3D`;
/// an entity that XML does not define; a `USE` for coordinates of a name that no `Coordinate` has; points that are no
/// multiple of three numbers; words that are no number or no index; a corner that names no point; a mesh beyond that
/// limit. [`Error::Unsupported`] for declarations of entities, encodings other than UTF-8, and deeper documents.
pub fn read(bytes: &[u8]) -> Result<Triangles, Error> {
    read_out_of(bytes, bytes.len() as u64)
}

/// [`read`], where the bytes come from so many in a file.
pub(crate) fn read_out_of(bytes: &[u8], input_bytes: u64) -> Result<Triangles, Error> {
    let bytes = without_byte_order_mark(bytes);
    let scene = Scene::new(bytes, input_bytes, Format::X3d, false);
    if [&b"\xFF\xFE"[..], b"\xFE\xFF", b"<\0", b"\0<"].iter().any(|start| bytes.starts_with(start)) {
        return Err(scene.unsupported(0, "UTF-16 or UTF-32".to_owned()));
    }
    let text = str::from_utf8(bytes).map_err(|error| {
        let message = "it is not UTF-8".to_owned();
        scene.malformed(error.valid_up_to(), Reason::Xml { message })
    })?;
    Reader { text, scene, open: Vec::new(), has_root: false, hidden_from: None }.run()
}

/// An element that is not closed yet.
struct Open {
    /// Its geometry, by its number in the scene.
    geometry: Option<usize>,
    /// Its byte.
    at: usize,
}

struct Reader<'a> {
    text: &'a str,
    scene: Scene<'a>,
    open: Vec<Open>,
    has_root: bool,
    /// The depth of the prototype that the elements are in.
    hidden_from: Option<usize>,
}

impl<'a> Reader<'a> {
    fn run(mut self) -> Result<Triangles, Error> {
        let mut xml = Xml::from_str(self.text);
        loop {
            let at = xml.buffer_position() as usize;
            let event = xml
                .read_event()
                .map_err(|error| self.scene.malformed(xml.error_position() as usize, xml_error(&error)))?;
            match event {
                Event::Start(tag) => {
                    let geometry = self.element(&tag, at)?;
                    push(&mut self.open, Open { geometry, at })?;
                }
                Event::Empty(tag) => {
                    self.element(&tag, at)?;
                    self.leave();
                }
                Event::End(_) => {
                    self.open.pop();
                    self.leave();
                }
                Event::Text(text) => self.text_outside(text.trim_ascii().is_empty(), at)?,
                Event::CData(_) => self.text_outside(false, at)?,
                Event::GeneralRef(reference) => self.reference(&reference, at)?,
                Event::DocType(declaration) => self.document_type(&declaration, at)?,
                Event::Decl(declaration) => self.declaration(&declaration, at)?,
                Event::Comment(_) | Event::PI(_) => {}
                Event::Eof => return self.end(),
            }
        }
    }

    /// An element begins at byte `at`: its geometry.
    fn element(&mut self, tag: &BytesStart<'_>, at: usize) -> Result<Option<usize>, Error> {
        self.scene.check_depth(self.open.len(), at)?;
        let name = tag.name();
        // Its text lies in the file as it stands, behind the `<`.
        let inner = self.text.get(at + 1..at + 1 + tag.len()).unwrap_or_default();
        let attributes = Attributes::of(inner, name.0.len(), at + 1);
        let local = name.local_name().into_inner();
        if self.open.is_empty() {
            self.root(local, at)?;
        }
        let attributes = attributes.map_err(|fault| self.fault(fault))?;
        if self.hidden_from.is_some() {
            return Ok(None);
        }
        if matches!(local, "ProtoDeclare" | "ExternProtoDeclare") {
            self.hidden_from = Some(self.open.len());
            return Ok(None);
        }
        match Node::of(local.as_bytes()) {
            Node::Geometry(_) | Node::Unread(_) | Node::Container if attributes.used.is_some() => {
                self.scene.note_repeated(at);
                Ok(None)
            }
            Node::Geometry(kind) => self.geometry(kind, &attributes, at).map(Some),
            Node::Unread(name) => {
                self.scene.note(Skipped::Elements(name.into()), 1, at);
                Ok(None)
            }
            Node::Coordinates => self.coordinates(&attributes).map(|()| None),
            Node::Container | Node::Other => Ok(None),
        }
    }

    fn root(&mut self, name: &str, at: usize) -> Result<(), Error> {
        if self.has_root {
            let message = "there is more than one root element".to_owned();
            return Err(self.scene.malformed(at, Reason::Xml { message }));
        }
        if name != "X3D" {
            return Err(self.scene.malformed(at, Reason::NotThisFormat { expected: NO_ROOT }));
        }
        self.has_root = true;
        Ok(())
    }

    fn geometry(&mut self, kind: Kind, attributes: &Attributes<'a>, at: usize) -> Result<usize, Error> {
        let number = self.scene.add_geometry(kind, at)?;
        let index = match kind {
            Kind::Faces => attributes.coord_index,
            _ => attributes.index,
        };
        if let Some(index) = index {
            self.scene.geometry(number).index = index.field().map_err(|fault| self.fault(fault))?;
        }
        self.scene.geometry(number).is_clockwise = attributes.ccw.is_some_and(|ccw| ccw.is_false());
        Ok(number)
    }

    /// A Coordinate element: the first one in a geometry element has its points, or names another that has.
    fn coordinates(&mut self, attributes: &Attributes<'a>) -> Result<(), Error> {
        let parent = self.open.last().and_then(|open| open.geometry);
        let waiting = parent.filter(|parent| self.scene.geometry(*parent).coordinates.is_none());
        if attributes.def.is_none() && waiting.is_none() {
            return Ok(());
        }
        let points = attributes.point.map(|points| points.field()).transpose();
        let points = points.map_err(|fault| self.fault(fault))?.unwrap_or_default();
        let number = self.scene.add_coordinates(points)?;
        if let Some(def) = attributes.def {
            let name = def.name().map_err(|fault| self.fault(fault))?;
            self.scene.define(name, number)?;
        }
        let coordinates = match attributes.used {
            None => Coordinates::Node(number),
            Some(used) => Coordinates::Named(used.name().map_err(|fault| self.fault(fault))?, used.at),
        };
        if let Some(parent) = waiting {
            self.scene.geometry(parent).coordinates = Some(coordinates);
        }
        Ok(())
    }

    /// An element has ended.
    fn leave(&mut self) {
        self.hidden_from = self.hidden_from.filter(|depth| *depth < self.open.len());
    }

    fn text_outside(&self, is_blank: bool, at: usize) -> Result<(), Error> {
        if is_blank || !self.open.is_empty() {
            return Ok(());
        }
        let message = "there is text outside the root element".to_owned();
        Err(self.scene.malformed(at, Reason::Xml { message }))
    }

    /// A reference in text: no text matters, but it has to be one of XML's own.
    fn reference(&self, name: &str, at: usize) -> Result<(), Error> {
        let reference = format!("&{name};");
        unescape(&reference)
            .map_err(|error| self.scene.malformed(at, unknown_reference(&reference, &error)))?;
        self.text_outside(false, at)
    }

    /// `<!DOCTYPE ...>`: what it refers to is not opened.
    fn document_type(&self, declaration: &str, at: usize) -> Result<(), Error> {
        match memchr::memmem::find(declaration.as_bytes(), b"<!ENTITY") {
            None => Ok(()),
            Some(_) => Err(self.scene.unsupported(at, "entities of its own (<!ENTITY)".to_owned())),
        }
    }

    /// `<?xml ...?>`: its encoding.
    fn declaration(&self, declaration: &BytesDecl<'_>, at: usize) -> Result<(), Error> {
        let Some(encoding) = declaration.encoding() else { return Ok(()) };
        let encoding = encoding.map_err(|error| self.scene.malformed(at, xml_error(&error)))?;
        if ["UTF-8", "UTF8", "US-ASCII", "ASCII"].iter().any(|known| encoding.eq_ignore_ascii_case(known)) {
            return Ok(());
        }
        Err(self.scene.unsupported(at, format!("the encoding {}", quote(encoding.as_bytes()))))
    }

    fn end(self) -> Result<Triangles, Error> {
        if let Some(Open { at, .. }) = self.open.last() {
            let tag = &self.scene.bytes[*at + 1..];
            let length = tag.iter().position(|byte| byte.is_ascii_whitespace() || *byte == b'>');
            let name = quote(&tag[..length.unwrap_or(tag.len())]);
            let message = format!("`<{name}>` is never closed");
            return Err(self.scene.malformed(*at, Reason::Xml { message }));
        }
        if !self.has_root {
            return Err(Error::malformed(
                Format::X3d,
                Place::File,
                Reason::NotThisFormat { expected: NO_ROOT },
            ));
        }
        self.scene.into_triangles()
    }

    fn fault(&self, fault: Fault) -> Error {
        match fault {
            Fault::At(at, reason) => self.scene.malformed(at, reason),
            Fault::Other(error) => error,
        }
    }
}

/// What the XML reader says, shortened where it quotes a long name.
fn xml_error(error: &dyn std::fmt::Display) -> Reason {
    let message = error.to_string().replace(char::is_control, "\u{FFFD}");
    let message = if message.len() <= 250 { message } else { quote(message.as_bytes()) };
    Reason::Xml { message }
}
