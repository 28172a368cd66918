//! VRML97, and X3D in its classic encoding: the faces of all geometry nodes.
//!
//! - `IndexedFaceSet`, `IndexedTriangleSet`, `TriangleSet`, `IndexedTriangleStripSet` and `IndexedTriangleFanSet` are
//!   read in the order of the file, each once: a `USE` of a whole node adds nothing but a note. Each appends all points of its
//!   `Coordinate`, again for every node that names it by `USE`.
//! - Transforms are not applied, and with `ccw FALSE` corners stay in the order of the file (a
//!   [note](Triangles::notes) says so). The bodies of prototypes are passed over, and no `Inline` or other file is
//!   opened: a note counts each `Inline`, and as `ProtoInstance` each node of a type that a prototype before it names.
//! - Other geometry, such as `Box`, is skipped with a note, and so are faces of fewer than three corners and geometry
//!   without a `Coordinate`. Fields, nodes and scripts that have nothing to do with faces may hold anything, as long as
//!   brackets and quotation marks are in order.
//! - A negative number ends a face; after the last one it may be missing. Commas are blanks. Numbers are decimal, with
//!   `inf` and `nan`; indices are decimal integers. Any other word among them is an error, hexadecimal ones too.
//! - A `USE` refers to the last `DEF` of its name before it.

mod tokens;

use std::borrow::Cow;
use std::collections::HashSet;

use self::tokens::{Token, Tokens, Unclosed, begins_number};
use crate::memory::push;
use crate::scene::{Coordinates, Field, Node, Scene};
use crate::text::without_byte_order_mark;
use crate::{Error, Format, Place, Reason, Skipped, Triangles};

/// Whether a file says in its first line that it is VRML, of any version, or X3D.
pub(crate) fn begins_with_header(bytes: &[u8]) -> bool {
    let bytes = without_byte_order_mark(bytes);
    bytes.starts_with(b"#VRML V") || bytes.starts_with(b"#X3D V")
}

/// Reads the geometry of a VRML97 file, or of an X3D file in the classic encoding. Linear in its size.
///
/// Geometry nodes may share their points, so the mesh may be larger than the file, but by a limit: it may have up to
/// 4 vertices and faces for each byte of the file, or 65,536 in all.
///
/// # Errors
/// [`Error::Malformed`] with the line at fault: brackets or quotation marks without a counterpart; a `USE` for
/// coordinates of a name that no `Coordinate` before it has; points that are no multiple of three numbers; words that
/// are no number or no index; a corner that names no point; a mesh beyond that limit. [`Error::Unsupported`] for VRML
/// 1.0, and for more than 10,000 nodes within one another.
pub fn read(bytes: &[u8]) -> Result<Triangles, Error> {
    read_out_of(bytes, bytes.len() as u64)
}

/// [`read`], where the bytes come from so many in a file.
pub(crate) fn read_out_of(bytes: &[u8], input_bytes: u64) -> Result<Triangles, Error> {
    let bytes = without_byte_order_mark(bytes);
    let reader = Reader {
        tokens: Tokens::new(bytes),
        scene: Scene::new(bytes, input_bytes, Format::Vrml, true),
        open: Vec::new(),
        name: None,
        repeatable: HashSet::new(),
        prototypes: HashSet::new(),
    };
    if bytes.starts_with(b"#VRML V1.0") {
        return Err(reader.scene.unsupported(0, "VRML 1.0".to_owned()));
    }
    if !bytes.starts_with(b"#VRML V2.0") && !bytes.starts_with(b"#X3D V") {
        let expected = "VRML97 or classic X3D: it does not begin with `#VRML V2.0` or `#X3D V`";
        return Err(Error::malformed(Format::Vrml, Place::File, Reason::NotThisFormat { expected }));
    }
    reader.run()
}

/// A `{` or `[` that is not closed yet.
struct Open {
    role: Role,
    /// The field whose value is next.
    field: FieldName,
    /// Its byte.
    at: usize,
}

#[derive(Clone, Copy, PartialEq)]
enum Role {
    /// A geometry node, by its number in the scene.
    Geometry(usize),
    /// A Coordinate node, by its number in the scene.
    Coordinates(usize),
    Node,
    List,
}

#[derive(Clone, Copy, PartialEq)]
enum FieldName {
    Coord,
    Points,
    Index,
    Ccw,
    Other,
}

struct Reader<'a> {
    tokens: Tokens<'a>,
    scene: Scene<'a>,
    open: Vec<Open>,
    /// What `DEF` calls the next node.
    name: Option<&'a [u8]>,
    /// The names of nodes that are or hold geometry.
    repeatable: HashSet<&'a [u8]>,
    /// The types that prototypes define.
    prototypes: HashSet<&'a [u8]>,
}

impl<'a> Reader<'a> {
    fn run(mut self) -> Result<Triangles, Error> {
        while let Some(token) = self.next()? {
            match token {
                Token::Word(word) => self.word(word)?,
                Token::Open(b'[') => self.list()?,
                Token::Open(_) => self.push(Role::Node)?,
                Token::Close(mark) => self.close(mark)?,
                Token::Text => {}
            }
        }
        match self.open.last() {
            None => self.scene.into_triangles(),
            Some(open) => {
                let mark = if open.role == Role::List { '[' } else { '{' };
                Err(self.unclosed(Unclosed { mark, at: open.at }))
            }
        }
    }

    fn word(&mut self, word: &'a [u8]) -> Result<(), Error> {
        if self.tokens.peek() == Some(b'{') {
            return self.node(word);
        }
        match word {
            b"DEF" => self.name = self.tokens.word(),
            b"USE" => self.reference()?,
            b"PROTO" | b"EXTERNPROTO" => self.prototype()?,
            _ => self.field_or_value(word),
        }
        Ok(())
    }

    /// A node begins: its `{` is the next token.
    fn node(&mut self, kind: &[u8]) -> Result<(), Error> {
        let at = self.tokens.last;
        let name = self.name.take();
        let node = Node::of(kind);
        if let Some(name) = name {
            self.define(name, node)?;
        }
        let role = match node {
            Node::Geometry(kind) => Role::Geometry(self.scene.add_geometry(kind, at)?),
            Node::Coordinates => Role::Coordinates(self.coordinates(name)?),
            Node::Unread(kind) => {
                self.scene.note(Skipped::Elements(kind.into()), 1, at);
                Role::Node
            }
            Node::Other if self.prototypes.contains(kind) => {
                self.scene.note_instance(at);
                Role::Node
            }
            Node::Container | Node::Other => Role::Node,
        };
        self.next()?;
        self.push(role)
    }

    /// `DEF`: the last one of a name holds.
    fn define(&mut self, name: &'a [u8], node: Node) -> Result<(), Error> {
        match node {
            Node::Geometry(_) | Node::Unread(_) | Node::Container => insert(&mut self.repeatable, name),
            Node::Coordinates | Node::Other => {
                self.repeatable.remove(name);
                Ok(())
            }
        }
    }

    /// A Coordinate node, which the geometry around it may be waiting for.
    fn coordinates(&mut self, name: Option<&'a [u8]>) -> Result<usize, Error> {
        let number = self.scene.add_coordinates(Field::default())?;
        if let Some(name) = name {
            self.scene.define(Cow::Borrowed(name), number)?;
        }
        if let Some(geometry) = self.geometry_before(FieldName::Coord) {
            self.scene.geometry(geometry).coordinates = Some(Coordinates::Node(number));
        }
        Ok(number)
    }

    /// `USE`: of coordinates, of a whole node, or of what does not matter.
    fn reference(&mut self) -> Result<(), Error> {
        let Some(name) = self.tokens.word() else { return Ok(()) };
        if self.repeatable.contains(name) {
            self.scene.note_repeated(self.tokens.last);
        }
        if let Some(geometry) = self.geometry_before(FieldName::Coord) {
            let number = self.scene.named(&Cow::Borrowed(name), self.tokens.last)?;
            self.scene.geometry(geometry).coordinates = Some(Coordinates::Node(number));
        }
        Ok(())
    }

    fn field_or_value(&mut self, word: &[u8]) {
        let Some(Open { role, field, .. }) = self.open.last_mut() else { return };
        let is_value = begins_number(word[0]);
        match (*role, *field) {
            (Role::Geometry(geometry), FieldName::Ccw) => {
                self.scene.geometry(geometry).is_clockwise = word == b"FALSE";
                *field = FieldName::Other;
            }
            (Role::Geometry(_) | Role::Coordinates(_), FieldName::Points | FieldName::Index) if is_value => {
                let numbers = Field::new(self.tokens.end_numbers());
                self.set_numbers(numbers);
            }
            (Role::Geometry(geometry), _) => {
                *field = match word {
                    b"coord" => FieldName::Coord,
                    b"ccw" => FieldName::Ccw,
                    _ if word == self.scene.geometry(geometry).kind.index_field().as_bytes() => {
                        FieldName::Index
                    }
                    _ => FieldName::Other,
                }
            }
            (Role::Coordinates(_), _) if word == b"point" => *field = FieldName::Points,
            _ => *field = FieldName::Other,
        }
    }

    /// A `[` was read. Lists of numbers are stepped over as a whole.
    fn list(&mut self) -> Result<(), Error> {
        let is_wanted = self.open.last().is_some_and(|open| {
            let is_number_field = matches!(open.field, FieldName::Points | FieldName::Index);
            is_number_field && open.role != Role::List
        });
        if !is_wanted && !self.tokens.peek().is_some_and(begins_number) {
            return self.push(Role::List);
        }
        let range = self.tokens.end_list().map_err(|unclosed| self.unclosed(unclosed))?;
        if is_wanted {
            self.set_numbers(Field::new(range));
        }
        Ok(())
    }

    /// The numbers of the points or of the corners of the innermost node.
    fn set_numbers(&mut self, numbers: Field) {
        let Some(open) = self.open.last_mut() else { return };
        open.field = FieldName::Other;
        match open.role {
            Role::Geometry(geometry) => self.scene.geometry(geometry).index = numbers,
            Role::Coordinates(number) => self.scene.set_points(number, numbers),
            Role::Node | Role::List => {}
        }
    }

    /// Steps over a prototype: its name, its interface, and its body or the address of it.
    fn prototype(&mut self) -> Result<(), Error> {
        if let Some(name) = self.tokens.word() {
            insert(&mut self.prototypes, name)?;
        }
        for _ in 0..2 {
            if matches!(self.tokens.peek(), Some(b'[' | b'{')) {
                self.skip_brackets()?;
            }
        }
        Ok(())
    }

    /// Steps over a `[` or `{`, what is in it, and its counterpart.
    fn skip_brackets(&mut self) -> Result<(), Error> {
        let mut first = None;
        let mut depth = 0usize;
        while let Some(token) = self.next()? {
            match token {
                Token::Open(mark) => {
                    first.get_or_insert((mark, self.tokens.last));
                    depth += 1;
                }
                Token::Close(_) if depth <= 1 => return Ok(()),
                Token::Close(_) => depth -= 1,
                Token::Word(_) | Token::Text => {}
            }
        }
        let (mark, at) = first.unwrap_or((b'{', self.tokens.last));
        Err(self.unclosed(Unclosed { mark: mark.into(), at }))
    }

    fn push(&mut self, role: Role) -> Result<(), Error> {
        let at = self.tokens.last;
        self.scene.check_depth(self.open.len(), at)?;
        push(&mut self.open, Open { role, field: FieldName::Other, at })
    }

    fn close(&mut self, mark: u8) -> Result<(), Error> {
        let is_list = |open: Open| open.role == Role::List;
        match self.open.pop().map(is_list) {
            Some(is_list) if is_list == (mark == b']') => Ok(()),
            _ => Err(self.unclosed(Unclosed { mark: mark.into(), at: self.tokens.last })),
        }
    }

    /// The geometry node that is innermost, if this field of it was named last.
    fn geometry_before(&self, field: FieldName) -> Option<usize> {
        match self.open.last()? {
            Open { role: Role::Geometry(geometry), field: named, .. } if *named == field => Some(*geometry),
            _ => None,
        }
    }

    fn next(&mut self) -> Result<Option<Token<'a>>, Error> {
        self.tokens.next().map_err(|unclosed| self.unclosed(unclosed))
    }

    fn unclosed(&self, Unclosed { mark, at }: Unclosed) -> Error {
        self.scene.malformed(at, Reason::Unbalanced { mark })
    }
}

fn insert<'a>(names: &mut HashSet<&'a [u8]>, name: &'a [u8]) -> Result<(), Error> {
    let bytes = names.len().saturating_mul(size_of::<&[u8]>());
    names.try_reserve(1).map_err(|_| Error::OutOfMemory { path: None, bytes })?;
    names.insert(name);
    Ok(())
}
