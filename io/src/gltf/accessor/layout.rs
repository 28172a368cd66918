//! Where the elements of accessors lie in the buffers.

use super::Source;
use crate::{Error, Item, Place, Reason};

/// Where the elements of an accessor lie: `count` of them, `stride` bytes apart, all within the buffer.
pub(super) struct Layout {
    buffer: usize,
    start: usize,
    stride: usize,
    count: usize,
}

impl Source<'_> {
    /// Where `count` elements of `size` bytes lie in a bufferView, once that is known to be true.
    pub(super) fn layout(
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
    pub(super) fn slices(&self, layout: &Layout, size: usize) -> impl Iterator<Item = &[u8]> {
        let all = self.buffers.bytes(layout.buffer);
        // The last element may end before its stride does.
        let end = match layout.count {
            0 => layout.start,
            count => layout.start + (count - 1) * layout.stride + size,
        };
        all[layout.start..end].chunks(layout.stride).map(move |chunk| &chunk[..size])
    }

    fn check_fits(&self, item: Item, needed: u64, available: u64, place: Place) -> Result<(), Error> {
        if needed <= available {
            return Ok(());
        }
        Err(self.malformed(place, Reason::TooShort { item, needed, available }))
    }
}
