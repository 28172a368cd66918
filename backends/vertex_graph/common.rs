//! Intersection of ascending lists.
use onering_core::VertexId;

/// What is in both of two ascending lists.
#[derive(Clone, Debug)]
pub(super) struct Common<'a> {
    short: &'a [VertexId],
    long: &'a [VertexId],
}

impl<'a> Common<'a> {
    #[inline]
    pub(super) fn new(a: &'a [VertexId], b: &'a [VertexId]) -> Self {
        let (short, long) = if a.len() <= b.len() { (a, b) } else { (b, a) };
        Self { short, long }
    }
}

impl Iterator for Common<'_> {
    type Item = VertexId;

    #[inline]
    fn next(&mut self) -> Option<VertexId> {
        while let [v, rest @ ..] = self.short {
            self.short = rest;
            self.long = from(self.long, *v);
            if self.long.first() == Some(v) {
                return Some(*v);
            }
        }
        None
    }
}

/// What an ascending list has from `v` on. O(log of what is skipped): a short list against that of a hub would
/// take time for the whole of the latter.
#[inline]
pub(super) fn from(list: &[VertexId], v: VertexId) -> &[VertexId] {
    let mut bound = 1;
    while bound < list.len() && list[bound - 1] < v {
        bound *= 2;
    }
    let unsure = bound / 2..bound.min(list.len());
    let start = unsure.start.min(unsure.end);
    &list[start + list[start..unsure.end].partition_point(|&w| w < v)..]
}
