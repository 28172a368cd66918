//! What an OBJ file says about the corners and faces: texture coordinates, normals, materials.
//! Needs the feature `tobj`.
//!
//! Everything is aligned with the [`Triangles::faces`](crate::Triangles::faces) that
//! [`obj::read`](crate::obj::read) gives for the same bytes: entry `f` of `corner_texcoords`,
//! `corner_normals` and `face_materials` belongs to face `f`, and of its three entries number `c` to corner
//! `c`. All triangles of one polygon have its material.
//!
//! Material libraries are read by the crate tobj, whose [`Material`] this is. Its OBJ reader is not used
//! but in the tests, as a second opinion: it cuts and renumbers the vertices, takes a line for a triangle,
//! stops at a continued line, and where some corners of a group have no normal it makes one up.

use std::path::Path;

pub use tobj::Material;

use crate::error::quote;
use crate::memory::push;
use crate::mtl::Libraries;
use crate::number::{f32_of, index_prefix};
use crate::text::Scanner;
use crate::{Error, Format, Place, Reason};

/// The lists of an OBJ file, and for each corner or face which entry is its own.
#[derive(Debug, Default)]
#[non_exhaustive]
pub struct Attributes {
    /// The `vt` lines in file order, `[u, v]`; a missing v is 0, a third number is dropped.
    pub texcoords: Vec<[f32; 2]>,
    /// The `vn` lines in file order, `[x, y, z]`, as they are: they need not have length 1.
    pub normals: Vec<[f32; 3]>,
    /// The materials that faces use, in order of first use. One that no library defines has its name only.
    pub materials: Vec<Material>,
    /// For each face, the indices of its corners into `texcoords`.
    pub corner_texcoords: Vec<[Option<u32>; 3]>,
    /// For each face, the indices of its corners into `normals`.
    pub corner_normals: Vec<[Option<u32>; 3]>,
    /// For each face, the index of its material in `materials`.
    pub face_materials: Vec<Option<u32>>,
    /// Why a library that the file names could not be read; the attributes are complete but for it.
    pub unread_libraries: Vec<Error>,
}

impl Attributes {
    /// The texture coordinates of corner `corner` (0, 1, 2) of face `face`, if the file gives any.
    pub fn texcoord(&self, face: usize, corner: usize) -> Option<[f32; 2]> {
        entry(&self.texcoords, &self.corner_texcoords, face, corner)
    }

    /// The normal at corner `corner` (0, 1, 2) of face `face`, if the file gives any.
    pub fn normal(&self, face: usize, corner: usize) -> Option<[f32; 3]> {
        entry(&self.normals, &self.corner_normals, face, corner)
    }

    /// The material of face `face`, if the file gives any.
    pub fn material(&self, face: usize) -> Option<&Material> {
        self.materials.get((*self.face_materials.get(face)?)? as usize)
    }
}

fn entry<T: Copy>(list: &[T], corners: &[[Option<u32>; 3]], face: usize, corner: usize) -> Option<T> {
    let index = (*corners.get(face)?.get(corner)?)?;
    list.get(index as usize).copied()
}

/// Reads the attributes in the OBJ file at `path`, with the material libraries that it names: files in its
/// own folder or below it; others are not opened. Linear in the size of the files.
///
/// # Errors
/// [`Error::Io`] if the OBJ file cannot be read; as [`read`] otherwise. A library that cannot be read is no
/// error: see [`Attributes::unread_libraries`].
pub fn load(path: impl AsRef<Path>) -> Result<Attributes, Error> {
    let path = path.as_ref();
    let bytes = crate::load::bytes_of(path)?;
    let libraries = Libraries::new(path.parent());
    Reader::new(&bytes, libraries).run().map_err(|error| error.in_file(path))
}

/// Reads the attributes in the bytes of an OBJ file. Libraries are not opened: materials have names only.
///
/// # Errors
/// [`Error::Malformed`] with the line at fault: a number that is none, a `vt` without a number or a `vn`
/// with fewer than three, a corner `a/b/c` of which `b` or `c` is 0 or names nothing in the file.
pub fn read(bytes: &[u8]) -> Result<Attributes, Error> {
    Reader::new(bytes, Libraries::new(None)).run()
}

struct Reader<'a> {
    scanner: Scanner<'a>,
    line: Place,
    libraries: Libraries<'a>,
    material: Option<u32>,
    out: Attributes,
    /// The line of each face, to name it when an index turns out to be too large.
    lines: Vec<Place>,
}

/// Texture coordinate and normal of a corner.
type Corner = [Option<u32>; 2];

impl<'a> Reader<'a> {
    fn new(bytes: &'a [u8], libraries: Libraries<'a>) -> Self {
        let (scanner, out) = (Scanner::new(bytes), Attributes::default());
        Self { scanner, line: Place::Line(1), libraries, material: None, out, lines: Vec::new() }
    }

    fn run(mut self) -> Result<Attributes, Error> {
        while !self.scanner.is_at_end() {
            self.line = Place::Line(self.scanner.line());
            match self.scanner.word() {
                Some(b"vt") => self.texcoord()?,
                Some(b"vn") => self.normal()?,
                Some(b"f" | b"fo") => self.face()?,
                Some(b"usemtl") => self.material = Some(self.libraries.use_material(self.scanner.rest())),
                Some(b"mtllib") => self.libraries.add(self.scanner.rest()),
                _ => {}
            }
            self.scanner.end_line();
        }
        self.check_range(&self.out.corner_texcoords, self.out.texcoords.len())?;
        self.check_range(&self.out.corner_normals, self.out.normals.len())?;
        (self.out.materials, self.out.unread_libraries) = self.libraries.finish();
        Ok(self.out)
    }

    fn texcoord(&mut self) -> Result<(), Error> {
        let u = self.number()?.ok_or_else(|| self.too_few(0))?;
        let v = self.number()?.unwrap_or_default();
        push(&mut self.out.texcoords, [u, v])
    }

    fn normal(&mut self) -> Result<(), Error> {
        let mut normal = [0.0; 3];
        for (found, coordinate) in normal.iter_mut().enumerate() {
            *coordinate = self.number()?.ok_or_else(|| self.too_few(found))?;
        }
        push(&mut self.out.normals, normal)
    }

    fn number(&mut self) -> Result<Option<f32>, Error> {
        let Some(word) = self.scanner.word() else { return Ok(None) };
        f32_of(word).map(Some).ok_or_else(|| self.malformed(Reason::BadNumber { word: quote(word) }))
    }

    fn face(&mut self) -> Result<(), Error> {
        let (mut first, mut previous) = (None, None);
        while let Some(word) = self.scanner.word() {
            let corner = self.corner(word)?;
            if let (Some(first), Some(previous)) = (first, previous) {
                self.triangle([first, previous, corner])?;
            }
            // The second corner is the first one with a previous.
            previous = first.and(Some(corner));
            first = first.or(Some(corner));
        }
        Ok(())
    }

    fn triangle(&mut self, corners: [Corner; 3]) -> Result<(), Error> {
        push(&mut self.out.corner_texcoords, corners.map(|[texcoord, _]| texcoord))?;
        push(&mut self.out.corner_normals, corners.map(|[_, normal]| normal))?;
        push(&mut self.out.face_materials, self.material)?;
        push(&mut self.lines, self.line)
    }

    fn corner(&self, word: &[u8]) -> Result<Corner, Error> {
        let mut parts = word.split(|byte| *byte == b'/').skip(1);
        let texcoord = self.index(parts.next(), self.out.texcoords.len(), word)?;
        let normal = self.index(parts.next(), self.out.normals.len(), word)?;
        match parts.next() {
            None => Ok([texcoord, normal]),
            Some(_) => Err(self.bad_index(word)),
        }
    }

    /// An index of a list that has `before` entries so far. Whether the list will have it is checked later.
    fn index(&self, part: Option<&[u8]>, before: usize, word: &[u8]) -> Result<Option<u32>, Error> {
        let Some(part) = part.filter(|part| !part.is_empty()) else { return Ok(None) };
        let parsed = index_prefix(part).filter(|(_, size, rest)| *size > 0 && rest.is_empty());
        let (negative, size, _) = parsed.ok_or_else(|| self.bad_index(word))?;
        let index = if negative { (before as u64).checked_sub(size) } else { Some(size - 1) };
        let index = index.and_then(|index| u32::try_from(index).ok());
        index.map(Some).ok_or_else(|| self.bad_index(word))
    }

    fn check_range(&self, corners: &[[Option<u32>; 3]], count: usize) -> Result<(), Error> {
        let is_bad = |face: &[Option<u32>; 3]| face.iter().flatten().any(|index| *index as usize >= count);
        match corners.iter().position(is_bad) {
            None => Ok(()),
            Some(face) => {
                let problem =
                    format!("a corner names a texture coordinate or normal beyond the {count} of the file");
                Err(Error::malformed(Format::Obj, self.lines[face], Reason::Attributes { problem }))
            }
        }
    }

    fn too_few(&self, found: usize) -> Error {
        self.malformed(Reason::Attributes { problem: format!("only {found} numbers") })
    }

    fn bad_index(&self, word: &[u8]) -> Error {
        self.malformed(Reason::BadIndex { word: quote(word) })
    }

    fn malformed(&self, reason: Reason) -> Error {
        Error::malformed(Format::Obj, self.line, reason)
    }
}
