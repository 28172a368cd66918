//! Positions and indices out of accessors. Every range is checked before a byte of the result is allocated.

mod layout;

use std::collections::BTreeSet;
use std::path::Path;

use ::gltf::json::accessor::{Accessor, ComponentType, GenericComponentType, IndexComponentType, Type};
use ::gltf::json::validation::Checked;

use self::layout::Layout;
use super::buffers::Buffers;
use super::component::{is_unsigned, unsigned, vector};
use super::document::Document;
use super::origin::BufferKind;
use crate::memory::reserve;
use crate::{Error, Format, Item, Place, Reason, proportion};

/// A document with its buffers.
pub(super) struct Source<'a> {
    document: &'a Document,
    buffers: Buffers<'a>,
    pub(super) format: Format,
    input_bytes: u64,
}

/// The sparse part of an accessor.
struct Sparse {
    component: ComponentType,
    indices: Layout,
    values: Layout,
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

    /// Refuses a mesh out of all proportion to the document and the files that were read for it so far.
    pub(super) fn check_proportion(&self, elements: u64) -> Result<(), Error> {
        let bytes = self.input_bytes.saturating_add(self.buffers.file_bytes());
        proportion::check(elements, bytes).map_err(|reason| self.malformed(Place::File, reason))
    }

    /// How many elements an accessor says that it has.
    pub(super) fn count(&self, i: usize, place: Place) -> Result<u64, Error> {
        self.accessor(i, place).map(|accessor| accessor.count.0)
    }

    /// Whether any bytes stand behind accessor `i`.
    pub(super) fn has_data(&self, i: usize, place: Place) -> Result<bool, Error> {
        self.accessor(i, place).map(|accessor| accessor.buffer_view.is_some() || accessor.sparse.is_some())
    }

    /// Refuses accessor `i` where it cannot give positions. Reads its buffers, but no element.
    pub(super) fn check_positions(&mut self, i: usize, place: Place) -> Result<(), Error> {
        let component = self.position_component(i, place)?;
        self.check_ranges(i, place, 3 * component.size())
    }

    /// Refuses accessor `i` where it cannot give indices. Reads its buffers, but no element.
    pub(super) fn check_indices(&mut self, i: usize, place: Place) -> Result<(), Error> {
        let component = self.index_component(i, place)?;
        self.check_ranges(i, place, component.size())
    }

    /// Appends the positions in accessor `i`.
    pub(super) fn positions(&mut self, i: usize, place: Place, out: &mut Vec<[f32; 3]>) -> Result<(), Error> {
        let component = self.position_component(i, place)?;
        let normalized = self.accessor(i, place)?.normalized;
        self.elements(i, place, 3 * component.size(), |bytes| vector(bytes, component, normalized), out)
    }

    /// The indices in accessor `i`.
    pub(super) fn indices(&mut self, i: usize, place: Place) -> Result<Vec<u32>, Error> {
        let component = self.index_component(i, place)?;
        let mut out = Vec::new();
        self.elements(i, place, component.size(), |bytes| unsigned(bytes, component), &mut out)?;
        Ok(out)
    }

    fn position_component(&self, i: usize, place: Place) -> Result<ComponentType, Error> {
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
        Ok(component)
    }

    fn index_component(&self, i: usize, place: Place) -> Result<ComponentType, Error> {
        let accessor = self.accessor(i, place)?;
        let component = self.component(accessor, i, place)?;
        if accessor.type_ != Checked::Valid(Type::Scalar) || !is_unsigned(component) {
            return Err(self.bad(Item::Accessor(i), place, "indices must be SCALAR of unsigned integers"));
        }
        Ok(component)
    }

    fn check_ranges(&mut self, i: usize, place: Place, size: usize) -> Result<(), Error> {
        self.plain(i, place, size)?;
        self.sparse(i, place, size).map(drop)
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
        let (first, count) = (out.len(), self.count(i, place)? as usize);
        let plain = self.plain(i, place, size)?;
        reserve(out, count)?;
        match plain {
            Some(layout) => out.extend(self.slices(&layout, size).map(&decode)),
            // All zero, by the standard. No byte backs them: the proportion is all that bounds them.
            None => out.resize(first + count, T::default()),
        }
        let Some(sparse) = self.sparse(i, place, size)? else { return Ok(()) };
        let names = self.slices(&sparse.indices, sparse.component.size());
        for (name, new) in names.zip(self.slices(&sparse.values, size)) {
            let slot = out[first..].get_mut(unsigned(name, sparse.component) as usize);
            let problem = "it replaces an element beyond the last";
            *slot.ok_or_else(|| self.bad(Item::Sparse(i), place, problem))? = decode(new);
        }
        Ok(())
    }

    /// Where the elements of accessor `i` lie; `None` where no byte backs them.
    fn plain(&mut self, i: usize, place: Place, size: usize) -> Result<Option<Layout>, Error> {
        let accessor = self.accessor(i, place)?;
        let Some(view) = accessor.buffer_view else { return Ok(None) };
        let (offset, count) = (accessor.byte_offset.unwrap_or_default().0, accessor.count.0);
        self.layout(view.value(), offset, count, size, Item::Accessor(i), place).map(Some)
    }

    /// Where the elements lie that replace some of accessor `i`.
    fn sparse(&mut self, i: usize, place: Place, size: usize) -> Result<Option<Sparse>, Error> {
        let accessor = self.accessor(i, place)?;
        let Some(sparse) = &accessor.sparse else { return Ok(None) };
        let (item, count) = (Item::Sparse(i), sparse.count.0);
        let (indices, values) = (&sparse.indices, &sparse.values);
        let Checked::Valid(IndexComponentType(component)) = indices.component_type else {
            return Err(self.bad(item, place, "indices must be unsigned integers"));
        };
        // They would be work that the proportion does not see.
        if count > accessor.count.0 {
            return Err(self.bad(item, place, "it replaces more elements than there are"));
        }
        let width = component.size();
        let indices =
            self.layout(indices.buffer_view.value(), indices.byte_offset.0, count, width, item, place)?;
        let values =
            self.layout(values.buffer_view.value(), values.byte_offset.0, count, size, item, place)?;
        Ok(Some(Sparse { component, indices, values }))
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
