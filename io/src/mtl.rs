//! Material libraries of OBJ files, read by the crate tobj.

use std::collections::HashMap;
use std::path::Path;

use tobj::Material;

use crate::beside::{self, Refusal};
use crate::error::quote;
use crate::{Error, Format, Place, Reason};

/// The largest library that is read, in bytes; they have a few thousand.
const LIMIT: u64 = 1 << 26;

/// The materials that an OBJ file uses, and those that its libraries define.
pub(crate) struct Libraries<'a> {
    folder: Option<&'a Path>,
    defined: HashMap<String, Material>,
    /// Names in order of first use, and the place of each.
    used: Vec<String>,
    places: HashMap<String, u32>,
    unread: Vec<Error>,
}

impl<'a> Libraries<'a> {
    /// Libraries are opened in `folder` only, or not at all.
    pub(crate) fn new(folder: Option<&'a Path>) -> Self {
        let (defined, places) = Default::default();
        Self { folder, defined, used: Vec::new(), places, unread: Vec::new() }
    }

    /// The number of the material of this name.
    pub(crate) fn use_material(&mut self, name: &[u8]) -> u32 {
        let name = String::from_utf8_lossy(name.trim_ascii()).into_owned();
        *self.places.entry(name).or_insert_with_key(|name| {
            self.used.push(name.clone());
            self.used.len() as u32 - 1
        })
    }

    /// Reads the libraries that a `mtllib` line names: one whose name may have blanks, or several.
    pub(crate) fn add(&mut self, names: &[u8]) {
        let Some(folder) = self.folder else { return };
        let names = String::from_utf8_lossy(names.trim_ascii()).into_owned();
        match beside::read(folder, &names, LIMIT) {
            Ok(bytes) => self.define(&names, &bytes),
            Err(_) => {
                names.split_ascii_whitespace().for_each(|name| match beside::read(folder, name, LIMIT) {
                    Ok(bytes) => self.define(name, &bytes),
                    Err(refusal) => self.unread.push(unread(name, refusal)),
                })
            }
        }
    }

    fn define(&mut self, name: &str, bytes: &[u8]) {
        match tobj::load_mtl_buf(&mut mended(bytes).as_bytes()) {
            Ok((materials, _)) => {
                self.defined.extend(materials.into_iter().map(|material| (material.name.clone(), material)));
            }
            Err(error) => {
                let problem = format!("library `{}`: {error}", quote(name.as_bytes()));
                self.unread.push(Error::malformed(Format::Obj, Place::File, Reason::Attributes { problem }));
            }
        }
    }

    /// The used materials, and why libraries could not be read.
    pub(crate) fn finish(mut self) -> (Vec<Material>, Vec<Error>) {
        let find = |name: String| {
            self.defined.remove(&name).unwrap_or_else(|| Material { name, ..Material::default() })
        };
        (self.used.into_iter().map(find).collect(), self.unread)
    }
}

fn unread(name: &str, refusal: Refusal) -> Error {
    match refusal {
        Refusal::Io(path, source) => Error::Io { path, named_in: None, source },
        Refusal::Uri(problem) => {
            let reason = Reason::Uri { uri: quote(name.as_bytes()), problem };
            Error::malformed(Format::Obj, Place::File, reason)
        }
    }
}

/// A library as tobj 4 can read it: it panics at a colour of fewer than three numbers, which the format
/// allows (one number stands for all three), and fails at other ways to write a colour.
fn mended(bytes: &[u8]) -> String {
    let text = String::from_utf8_lossy(bytes).replace('\r', "\n");
    text.lines().filter_map(mended_line).flat_map(|line| [line, "\n".to_owned()]).collect()
}

fn mended_line(line: &str) -> Option<String> {
    let words: Vec<&str> = line.split_whitespace().collect();
    match words[..] {
        [] => None,
        [first, ..] if first.starts_with('#') => None,
        ["Ka" | "Kd" | "Ks" | "Ke", ref numbers @ ..] if !numbers.iter().take(3).all(is_number) => None,
        [key @ ("Ka" | "Kd" | "Ks" | "Ke"), grey] => Some(format!("{key} {grey} {grey} {grey}")),
        ["Ka" | "Kd" | "Ks" | "Ke"] | ["Ka" | "Kd" | "Ks" | "Ke", _, _] => None,
        _ => Some(line.to_owned()),
    }
}

fn is_number(word: &&str) -> bool {
    word.parse::<f32>().is_ok()
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn colours_of_any_length_are_read() {
        let mut libraries = Libraries::new(None);
        libraries.define("a.mtl", b"#x\nnewmtl a b\r\nKd 0.5\rKa\nKs 1 2\nKe spectral x.rfl\nKs .1 .2 .3\n");
        assert_eq!([libraries.use_material(b" a b "), libraries.use_material(b"a b")], [0, 0]);
        let (materials, unread) = libraries.finish();
        assert!(unread.is_empty());
        assert_eq!(materials[0].diffuse, Some([0.5; 3]));
        assert_eq!(materials[0].specular, Some([0.1, 0.2, 0.3]));
        assert_eq!((materials[0].ambient, materials[0].emissive), (None, None));
    }
}
