//! Values at vertices or faces, to be written beside a mesh.

/// A named value for each vertex or for each face of a mesh, such as its component or a height. Files that can hold
/// colours show the first one as colours.
#[derive(Clone, Copy, Debug)]
pub struct Attribute<'a> {
    /// Its name in the file: a word of ASCII letters, digits and underscores is safe everywhere.
    pub name: &'a str,
    /// One value for each vertex, or for each face.
    pub values: Values<'a>,
}

/// The values of an [`Attribute`], by what they mean, which decides how they are coloured.
#[derive(Clone, Copy, Debug)]
#[non_exhaustive]
pub enum Values<'a> {
    /// Yes or no, such as being on the boundary.
    Flags(&'a [bool]),
    /// Numbers that name something, such as a component or the level of a ring.
    Labels(&'a [u32]),
    /// A scalar field, such as a height.
    Scalars(&'a [f32]),
}

impl Values<'_> {
    /// How many there are.
    pub fn len(&self) -> usize {
        match self {
            Self::Flags(flags) => flags.len(),
            Self::Labels(labels) => labels.len(),
            Self::Scalars(scalars) => scalars.len(),
        }
    }

    /// Whether there are none.
    pub fn is_empty(&self) -> bool {
        self.len() == 0
    }
}
