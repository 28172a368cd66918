//! Values at vertices or faces, to be written beside a mesh.

use std::collections::HashSet;

/// A named value for each vertex or for each face of a mesh, such as its component or a height.
///
/// Files that can hold values hold every attribute under its name; where that is no word or is taken, under one that
/// is like it. Files that can hold colours show the first one as colours, which colour-blind eyes tell apart as well:
/// flags are vermilion where set and light grey elsewhere; labels have hues far from each other, a label the same
/// in every file; scalars go from dark violet to yellow (viridis) from the least to the largest finite value, and are
/// grey where they are NaN.
///
/// | format | values at vertices | values at faces |
/// |---|---|---|
/// | PLY | property `name`: flags `uchar`, labels `uint`, scalars `float`; `red`, `green`, `blue` | the same; faces are the triangles then, not the polygons |
/// | GLB | `_NAME`, as `f32`, so labels beyond 2^24 are rounded; `COLOR_0` | the same at three vertices of its own for each triangle |
/// | others | none | none |
///
/// In a GLB with both kinds, `COLOR_0` is the first one at the vertices.
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

/// The name as one word of ASCII letters, digits and underscores that does not begin with a digit.
pub(crate) fn word(name: &str) -> String {
    let safe = |c: char| if c.is_ascii_alphanumeric() { c } else { '_' };
    let start = if name.starts_with(|c: char| !c.is_ascii_digit()) { "" } else { "_" };
    start.chars().chain(name.chars().map(safe)).collect()
}

/// The names, with a number behind those that are taken or came before.
pub(crate) fn unique_names(names: impl IntoIterator<Item = String>, taken: &[&str]) -> Vec<String> {
    let mut seen: HashSet<String> = taken.iter().map(|name| (*name).into()).collect();
    let mut unique = |name: String| {
        let others = (2..).map(|n: usize| format!("{name}_{n}"));
        let free = std::iter::once(name.clone()).chain(others).find(|name| seen.insert(name.clone()));
        free.unwrap_or(name)
    };
    names.into_iter().map(&mut unique).collect()
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn names_become_words() {
        let words = ["height", "two words", "1st", "", "Höhe\n", "_a-b"].map(word);
        assert_eq!(words, ["height", "two_words", "_1st", "_", "H_he_", "_a_b"]);
    }

    #[test]
    fn names_become_unique() {
        let names = ["x", "a", "a", "a_2", "x", "b"].map(String::from);
        assert_eq!(unique_names(names, &["x"]), ["x_2", "a", "a_2", "a_2_2", "x_3", "b"]);
    }
}
