//! Positions and indices out of accessors. Every range is checked before a byte of the result is allocated.

use std::collections::BTreeSet;
use std::path::Path;

use ::gltf::json::accessor::{Accessor, ComponentType, GenericComponentType, IndexComponentType, Type};
use ::gltf::json::validation::Checked;

use super::buffers::Buffers;
use super::component::{is_unsigned, unsigned, vector};
use super::document::Document;
use super::origin::BufferKind;
use crate::memory::reserve;
use crate::{Error, Format, Item, Place, Reason};

/// Vertices and faces that a byte of input may give. Primitives may share an accessor, so a document may
/// stand for a mesh larger than itself: with k primitives on one list of vertices about k / 36 a byte. A
/// hostile one could ask for their product; this stops it.
const ELEMENTS_PER_BYTE: u64 = 16;
/// Vertices and faces that are allowed in any case.
const ELEMENTS_ALWAYS: u64 = 1 << 20;

/// A document with its buffers.
pub(super) struct Source<'a> {
    document: &'a Document,
    buffers: Buffers<'a>,
    pub(super) format: Format,
    input_bytes: u64,
}

/// Where the elements of an accessor lie: `count` of them, `stride` bytes apart, all within the buffer.
struct Layout {
    buffer: usize,
    start: usize,
    stride: usize,
    count: usize,
}

impl<'a> Source<'a> {
    pub(super) fn new(
        document: &'a Document,
        format: Format,
        bin: Option<&'a [u8]>,
        folder: Option<&'a Path>,
        input_bytes: u64,
    ) -> Self {
        let buffers = Buffers::new(&document.buffers, format, bin, folder);
        Self { document, buffers, format, input_bytes }
    }

    /// The kinds of the buffers that were read so far.
    pub(super) fn buffer_kinds(&self) -> BTreeSet<BufferKind> {
        self.buffers.kinds()
    }

    /// Refuses a mesh out of all proportion to the input.
    pub(super) fn check_proportion(&self, elements: u64, place: Place) -> Result<(), Error> {
        let bytes = self.input_bytes.saturating_add(self.buffers.loaded_bytes());
        if elements <= ELEMENTS_ALWAYS.max(bytes.saturating_mul(ELEMENTS_PER_BYTE)) {
            return Ok(());
        }
        Err(self.malformed(place, Reason::OutOfProportion { elements, bytes }))
    }

    /// How many elements an accessor says that it has.
    pub(super) fn count(&self, i: usize, place: Place) -> Result<u64, Error> {
        self.accessor(i, place).map(|accessor| accessor.count.0)
    }

    /// Whether any bytes stand behind accessor `i`.
    pub(super) fn has_data(&self, i: usize, place: Place) -> Result<bool, Error> {
        self.accessor(i, place).map(|accessor| accessor.buffer_view.is_some() || accessor.sparse.is_some())
    }

    /// Appends the positions in accessor `i`.
    pub(super) fn positions(&mut self, i: usize, place: Place, out: &mut Vec<[f32; 3]>) -> Result<(), Error> {
        let accessor = self.accessor(i, place)?;
        let component = self.component(accessor, i, place)?;
        if accessor.type_ != Checked::Valid(Type::Vec3) || component == ComponentType::U32 {
            return Err(self.bad(Item::Accessor(i), place, "positions must be VEC3 of floats"));
        }
        let quantised = self.document.extensions_required.iter().any(|name| name == "KHR_mesh_quantization");
        if component != ComponentType::F32 && !quantised {
            let problem = "positions other than floats need KHR_mesh_quantization";
            return Err(self.bad(Item::Accessor(i), place, problem));
        }
        let decode = |bytes: &[u8]| vector(bytes, component, accessor.normalized);
        self.elements(i, place, 3 * component.size(), decode, out)
    }

    /// The indices in accessor `i`.
    pub(super) fn indices(&mut self, i: usize, place: Place) -> Result<Vec<u32>, Error> {
        let accessor = self.accessor(i, place)?;
        let component = self.component(accessor, i, place)?;
        if accessor.type_ != Checked::Valid(Type::Scalar) || !is_unsigned(component) {
            return Err(self.bad(Item::Accessor(i), place, "indices must be SCALAR of unsigned integers"));
        }
        let mut out = Vec::new();
        self.elements(i, place, component.size(), |bytes| unsigned(bytes, component), &mut out)?;
        Ok(out)
    }

    /// Appends the elements of accessor `i`, each decoded from `size` bytes.
    fn elements<T: Copy + Default>(
        &mut self,
        i: usize,
        place: Place,
        size: usize,
        decode: impl Fn(&[u8]) -> T,
        out: &mut Vec<T>,
    ) -> Result<(), Error> {
        let accessor = self.accessor(i, place)?;
        let (first, count) = (out.len(), accessor.count.0);
        match accessor.buffer_view {
            Some(view) => {
                let offset = accessor.byte_offset.unwrap_or_default().0;
                let layout = self.layout(view.value(), offset, count, size, Item::Accessor(i), place)?;
                reserve(out, layout.count)?;
                out.extend(self.slices(&layout, size).map(&decode));
            }
            None => {
                // All zero, by the standard. No byte backs them, so the proportion is all that bounds them.
                self.check_proportion(count, place)?;
                reserve(out, count as usize)?;
                out.resize(first + count as usize, T::default());
            }
        }
        self.replace_sparse(i, place, size, decode, &mut out[first..])
    }

    /// Overwrites the elements that the sparse part of accessor `i` lists.
    fn replace_sparse<T>(
        &mut self,
        i: usize,
        place: Place,
        size: usize,
        decode: impl Fn(&[u8]) -> T,
        out: &mut [T],
    ) -> Result<(), Error> {
        let Some(sparse) = &self.accessor(i, place)?.sparse else { return Ok(()) };
        let item = Item::Sparse(i);
        let (indices, values) = (&sparse.indices, &sparse.values);
        let Checked::Valid(IndexComponentType(component)) = indices.component_type else {
            return Err(self.bad(item, place, "indices must be unsigned integers"));
        };
        let (count, width) = (sparse.count.0, component.size());
        let names =
            self.layout(indices.buffer_view.value(), indices.byte_offset.0, count, width, item, place)?;
        let news = self.layout(values.buffer_view.value(), values.byte_offset.0, count, size, item, place)?;
        for (name, new) in self.slices(&names, width).zip(self.slices(&news, size)) {
            let slot = out.get_mut(unsigned(name, component) as usize);
            *slot.ok_or_else(|| self.bad(item, place, "it replaces an element beyond the last"))? =
                decode(new);
        }
        Ok(())
    }

    /// Where `count` elements of `size` bytes lie in a bufferView, once that is known to be true.
    fn layout(
        &mut self,
        view: usize,
        offset: u64,
        count: u64,
        size: usize,
        item: Item,
        place: Place,
    ) -> Result<Layout, Error> {
        let views = &self.document.buffer_views;
        let buffer_view =
            views.get(view).ok_or_else(|| self.missing(Item::BufferView(view), views.len(), place))?;
        let buffer = buffer_view.buffer.value();
        if buffer >= self.buffers.count() {
            return Err(self.missing(Item::Buffer(buffer), self.buffers.count(), place));
        }
        let stride = buffer_view.byte_stride.map_or(0, |stride| stride.0 as u64);
        let stride = if stride == 0 { size as u64 } else { stride };
        if stride < size as u64 {
            return Err(self.bad(Item::BufferView(view), place, "elements overlap: byteStride is too small"));
        }
        let needed = match count {
            0 => 0,
            _ => (count - 1).saturating_mul(stride).saturating_add(offset).saturating_add(size as u64),
        };
        self.check_fits(item, needed, buffer_view.byte_length.0, place)?;
        self.buffers.load(buffer)?;
        let view_offset = buffer_view.byte_offset.unwrap_or_default().0;
        let available = self.buffers.bytes(buffer).len() as u64;
        self.check_fits(item, needed.saturating_add(view_offset), available, place)?;
        // All of these are at most `available`, or are not used where there is no element.
        let start = if count == 0 { 0 } else { (view_offset + offset) as usize };
        let stride = usize::try_from(stride).unwrap_or(usize::MAX);
        Ok(Layout { buffer, start, stride, count: count as usize })
    }

    /// The bytes of each element.
    fn slices(&self, layout: &Layout, size: usize) -> impl Iterator<Item = &[u8]> {
        let all = self.buffers.bytes(layout.buffer);
        // The last element may end before its stride does.
        let end = match layout.count {
            0 => layout.start,
            count => layout.start + (count - 1) * layout.stride + size,
        };
        all[layout.start..end].chunks(layout.stride).map(move |chunk| &chunk[..size])
    }

    fn accessor(&self, i: usize, place: Place) -> Result<&'a Accessor, Error> {
        let accessors = &self.document.accessors;
        accessors.get(i).ok_or_else(|| self.missing(Item::Accessor(i), accessors.len(), place))
    }

    fn component(&self, accessor: &Accessor, i: usize, place: Place) -> Result<ComponentType, Error> {
        match accessor.component_type {
            Checked::Valid(GenericComponentType(component)) => Ok(component),
            Checked::Invalid => Err(self.bad(Item::Accessor(i), place, "unknown componentType")),
        }
    }

    fn check_fits(&self, item: Item, needed: u64, available: u64, place: Place) -> Result<(), Error> {
        if needed <= available {
            return Ok(());
        }
        Err(self.malformed(place, Reason::TooShort { item, needed, available }))
    }

    fn missing(&self, item: Item, count: usize, place: Place) -> Error {
        self.malformed(place, Reason::NoSuchItem { item, count })
    }

    fn bad(&self, item: Item, place: Place, problem: &'static str) -> Error {
        self.malformed(place, Reason::BadItem { item, problem })
    }

    pub(super) fn malformed(&self, place: Place, reason: Reason) -> Error {
        Error::malformed(self.format, place, reason)
    }
}
