//! What an element is to a mesh, by its name and its properties.

use super::element::{Element, Kind};
use super::malformed;
use super::scalar::Integer;
use crate::error::quote;
use crate::{Error, Reason};

#[derive(Clone, Copy, Debug)]
pub(super) enum Role {
    /// Holds which properties are x, y and z.
    Vertices([usize; 3]),
    Faces(Indices),
    Strips(Indices),
    Other,
}

/// The list that names vertices.
#[derive(Clone, Copy, Debug)]
pub(super) struct Indices {
    /// Which property it is.
    pub(super) property: usize,
    pub(super) length: Integer,
    pub(super) item: Integer,
}

impl Role {
    /// Faces and strips without indices are elements like any other.
    pub(super) fn of(element: &Element<'_>) -> Result<Self, Error> {
        Ok(match element.name {
            b"vertex" => Self::Vertices([
                coordinate(element, b"x")?,
                coordinate(element, b"y")?,
                coordinate(element, b"z")?,
            ]),
            b"face" => named(element).map_or(Ok(Self::Other), |i| indices(element, i).map(Self::Faces))?,
            b"tristrips" => {
                let list = named(element).or_else(|| first_list(element));
                list.map_or(Ok(Self::Other), |i| indices(element, i).map(Self::Strips))?
            }
            _ => Self::Other,
        })
    }
}

fn position(element: &Element<'_>, name: &[u8]) -> Option<usize> {
    element.properties.iter().position(|property| property.name == name)
}

fn coordinate(element: &Element<'_>, name: &'static [u8]) -> Result<usize, Error> {
    let i =
        position(element, name).ok_or_else(|| bad(element, name, "is missing: vertices need x, y and z"))?;
    match element.properties[i].kind {
        Kind::Scalar(_) => Ok(i),
        Kind::List { .. } => Err(bad(element, name, "is a list, but a coordinate is a number")),
    }
}

fn named(element: &Element<'_>) -> Option<usize> {
    position(element, b"vertex_indices").or_else(|| position(element, b"vertex_index"))
}

fn first_list(element: &Element<'_>) -> Option<usize> {
    element.properties.iter().position(|property| property.kind.scalar().is_none())
}

fn indices(element: &Element<'_>, i: usize) -> Result<Indices, Error> {
    let property = element.properties[i];
    let Kind::List { length, item } = property.kind else {
        return Err(bad(element, property.name, "is a number, but a face is a list of vertices"));
    };
    let floats = || bad(element, property.name, "is a list of floats, but vertices are named by integers");
    Ok(Indices { property: i, length, item: item.integer().ok_or_else(floats)? })
}

fn bad(element: &Element<'_>, name: &[u8], problem: &'static str) -> Error {
    malformed(element.line, Reason::Declaration { name: quote(name), problem })
}
