//! What a header declares.

use super::role::Role;
use super::scalar::{Integer, Scalar};
use crate::{Item, Place};

/// So many rows, each with a value for every property.
#[derive(Debug)]
pub(super) struct Element<'a> {
    pub(super) name: &'a [u8],
    pub(super) count: usize,
    pub(super) properties: Vec<Property<'a>>,
    pub(super) role: Role,
    /// Its position in the header.
    pub(super) index: usize,
    /// The line that declares it.
    pub(super) line: Place,
}

#[derive(Clone, Copy, Debug)]
pub(super) struct Property<'a> {
    pub(super) name: &'a [u8],
    pub(super) kind: Kind,
}

#[derive(Clone, Copy, Debug)]
pub(super) enum Kind {
    Scalar(Scalar),
    List { length: Integer, item: Scalar },
}

impl Element<'_> {
    /// One row, as errors name it.
    pub(super) fn item(&self, row: usize) -> Item {
        match self.role {
            Role::Vertices(_) => Item::Vertex(row),
            Role::Faces(_) => Item::Face(row),
            Role::Strips(_) => Item::Strip(row),
            Role::Other => Item::Row { element: self.index, row },
        }
    }

    /// Bytes of a binary row; `None` where it has a list.
    pub(super) fn stride(&self) -> Option<usize> {
        fixed_size(&self.properties)
    }

    /// Bytes of a binary row whose lists are all empty.
    pub(super) fn least_size(&self) -> usize {
        self.properties.iter().map(|property| property.kind.least_size()).sum()
    }
}

/// Bytes of the values of these properties; `None` where one is a list.
pub(super) fn fixed_size(properties: &[Property<'_>]) -> Option<usize> {
    properties.iter().map(|property| property.kind.scalar().map(Scalar::size)).sum()
}

impl Kind {
    pub(super) fn scalar(self) -> Option<Scalar> {
        match self {
            Self::Scalar(scalar) => Some(scalar),
            Self::List { .. } => None,
        }
    }

    fn least_size(self) -> usize {
        match self {
            Self::Scalar(scalar) => scalar.size(),
            Self::List { length, .. } => length.size(),
        }
    }
}
