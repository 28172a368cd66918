//! Attributes live beside the topology, never in it.
use crate::{Handle, handle::Handles};
use alloc::vec::{self, Vec};
use core::{iter, marker::PhantomData, ops, slice};

/// One value for each element of one kind, indexed by its handle.
///
/// ```
/// use onering_core::{Handle, Map, VertexId};
/// let mut height: Map<VertexId, f32> = Map::from_fn(3, |v: VertexId| v.index() as f32);
/// height[VertexId::new(1)] += 0.5;
/// assert_eq!(height.iter().map(|(_, z)| z).sum::<f32>(), 3.5);
/// for (v, z) in &mut height {
///     *z -= v.index() as f32;
/// }
/// assert_eq!(height.as_slice(), [0.0, 0.5, 0.0]);
/// ```
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Map<H, T> {
    cells: Vec<T>,
    kind: PhantomData<fn(H)>,
}

impl<H: Handle, T> Map<H, T> {
    /// A map made by calling `f` for each handle with an index below `count`, in order.
    pub fn from_fn(count: usize, f: impl FnMut(H) -> T) -> Self {
        (0..count).map(H::new).map(f).collect()
    }

    /// A map that holds `value` for each handle with an index below `count`.
    pub fn filled(count: usize, value: T) -> Self
    where
        T: Clone,
    {
        Vec::from_iter(core::iter::repeat_n(value, count)).into()
    }

    /// Number of values: the bound of the handles that it can be asked for.
    pub fn len(&self) -> usize {
        self.cells.len()
    }

    /// Whether there is no value at all.
    pub fn is_empty(&self) -> bool {
        self.cells.is_empty()
    }

    /// The value of `h`, or `None` where the map ends before it.
    pub fn get(&self, h: H) -> Option<&T> {
        self.cells.get(h.index())
    }

    /// Every handle with its value, in order.
    pub fn iter(&self) -> impl ExactSizeIterator<Item = (H, &T)> + DoubleEndedIterator {
        self.into_iter()
    }

    /// Every handle with its value to write to, in order.
    pub fn iter_mut(&mut self) -> impl ExactSizeIterator<Item = (H, &mut T)> + DoubleEndedIterator {
        self.into_iter()
    }

    /// Makes room for handles below `count`: new ones get `value`, those from `count` on lose theirs.
    pub fn resize(&mut self, count: usize, value: T)
    where
        T: Clone,
    {
        self.cells.resize(count, value);
    }

    /// The values in order of their handles.
    pub fn as_slice(&self) -> &[T] {
        &self.cells
    }

    /// The values in order of their handles, to write to.
    pub fn as_mut_slice(&mut self) -> &mut [T] {
        &mut self.cells
    }

    /// The values in order of their handles, without a copy.
    pub fn into_vec(self) -> Vec<T> {
        self.cells
    }
}

impl<'a, H: Handle, T> IntoIterator for &'a Map<H, T> {
    type Item = (H, &'a T);
    type IntoIter = iter::Zip<Handles<H>, slice::Iter<'a, T>>;

    fn into_iter(self) -> Self::IntoIter {
        Handles::below(self.len()).zip(&self.cells)
    }
}

impl<'a, H: Handle, T> IntoIterator for &'a mut Map<H, T> {
    type Item = (H, &'a mut T);
    type IntoIter = iter::Zip<Handles<H>, slice::IterMut<'a, T>>;

    fn into_iter(self) -> Self::IntoIter {
        Handles::below(self.len()).zip(&mut self.cells)
    }
}

impl<H: Handle, T> IntoIterator for Map<H, T> {
    type Item = (H, T);
    type IntoIter = iter::Zip<Handles<H>, vec::IntoIter<T>>;

    fn into_iter(self) -> Self::IntoIter {
        Handles::below(self.len()).zip(self.cells)
    }
}

impl<H, T> From<Vec<T>> for Map<H, T> {
    fn from(cells: Vec<T>) -> Self {
        Self { cells, kind: PhantomData }
    }
}

impl<H, T> Default for Map<H, T> {
    fn default() -> Self {
        Vec::new().into()
    }
}

impl<H, T> FromIterator<T> for Map<H, T> {
    fn from_iter<I: IntoIterator<Item = T>>(values: I) -> Self {
        Vec::from_iter(values).into()
    }
}

impl<H: Handle, T> ops::Index<H> for Map<H, T> {
    type Output = T;

    #[inline(always)]
    fn index(&self, h: H) -> &T {
        &self.cells[h.index()]
    }
}

impl<H: Handle, T> ops::IndexMut<H> for Map<H, T> {
    #[inline(always)]
    fn index_mut(&mut self, h: H) -> &mut T {
        &mut self.cells[h.index()]
    }
}
