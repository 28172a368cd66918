//! Which vertex an index names.

/// In a part of a file, of which nobody knows yet how many vertices come before it, there are so many: corners that
/// are counted back can be told from others, and be put right later.
#[cfg(feature = "parallel")]
const SUPPOSED: u32 = 1 << 31;

/// What the corners of a face are made of at one point of a file.
#[derive(Clone, Copy, Debug)]
pub(super) struct Numbering {
    /// How many vertices there are so far.
    vertices: u64,
    /// Corners that are not counted back are below.
    limit: u32,
    /// Corners that are counted back are not.
    least: u32,
}

impl Numbering {
    /// From the beginning of a file in which a corner may name `limit` vertices.
    pub(super) fn of_file(limit: u32) -> Self {
        Self { vertices: 0, limit, least: 0 }
    }

    #[cfg(feature = "parallel")]
    pub(super) fn of_part() -> Self {
        Self { vertices: SUPPOSED.into(), limit: SUPPOSED / 2, least: SUPPOSED / 2 }
    }

    /// The same, after as many vertices.
    #[inline(always)]
    pub(super) fn after(self, vertices: usize) -> Self {
        Self { vertices: self.vertices + vertices as u64, ..self }
    }

    /// How many vertices a corner may name.
    pub(super) fn limit(self) -> u32 {
        self.limit
    }

    /// The corner that an index above 0 names; `None` if it may not.
    #[inline(always)]
    pub(super) fn absolute(self, index: u64) -> Option<u32> {
        let corner = index.wrapping_sub(1);
        (corner < u64::from(self.limit)).then_some(corner as u32)
    }

    /// The corner that an index below 0 names, `back` from the next vertex; `None` if there is none.
    #[inline(always)]
    pub(super) fn back(self, back: u64) -> Option<u32> {
        let corner = self.vertices.checked_sub(back)?;
        let exists = 0 < back && u64::from(self.least) <= corner;
        u32::try_from(corner).ok().filter(|_| exists)
    }
}

/// The right corner for one of a part, now that the number of vertices before it is known; with `false` if it is one
/// that is counted back and names none of them.
#[cfg(feature = "parallel")]
#[inline(always)]
pub(super) fn settled(corner: u32, before: u32) -> (u32, bool) {
    let least = SUPPOSED - before.min(SUPPOSED);
    let is_back = corner >= SUPPOSED / 2;
    let corner_back = corner.wrapping_add(before).wrapping_sub(SUPPOSED);
    (if is_back { corner_back } else { corner }, !is_back || corner >= least)
}
