//! The phases of a build as bare as they get: unchecked, for oriented manifolds alone. What onering takes beyond this is
//! the price of checks, of defects, and of any order of faces.

const NONE: u32 = u32::MAX;

#[inline(always)]
fn next(h: u32) -> u32 {
    if h % 3 == 2 { h - 2 } else { h + 1 }
}

#[inline(always)]
fn prev(h: u32) -> u32 {
    if h.is_multiple_of(3) { h + 2 } else { h - 1 }
}

/// Faces whose indices are known to be in range.
pub(super) struct Faces<'a> {
    origin: &'a [u32],
    vertex_count: usize,
}

impl<'a> Faces<'a> {
    pub(super) fn checked(vertex_count: usize, faces: &'a [[u32; 3]]) -> Option<Self> {
        let origin = faces.as_flattened();
        let is_in_range = origin.iter().all(|&v| (v as usize) < vertex_count);
        is_in_range.then_some(Self { origin, vertex_count })
    }

    /// The opposite of each half-edge. Those without one yet are a list for each lower vertex, linked through the result
    /// itself; the next half-edge of the edge takes it out.
    pub(super) fn chain(&self) -> Vec<u32> {
        let mut first = vec![NONE; self.vertex_count];
        let mut opposite: Vec<u32> = Vec::with_capacity(self.origin.len());
        let (first, cell, origin) = (first.as_mut_ptr(), opposite.as_mut_ptr(), self.origin.as_ptr());
        // SAFETY: all vertices are below the length of `first`, and all half-edges below that of `origin` and `cell`; a
        // cell is written when its half-edge comes, and only those that came are in lists.
        unsafe {
            for start in (0..self.origin.len() as u32).step_by(3) {
                for h in start..start + 3 {
                    let (from, to) = (*origin.add(h as usize), *origin.add(next(h) as usize));
                    let open = first.add(from.min(to) as usize);
                    let mut link = open;
                    loop {
                        let g = *link;
                        if g == NONE {
                            *cell.add(h as usize) = *open;
                            *open = h;
                            break;
                        }
                        if *origin.add(g as usize) == to && *origin.add(next(g) as usize) == from {
                            *link = *cell.add(g as usize);
                            *cell.add(g as usize) = h;
                            *cell.add(h as usize) = g;
                            break;
                        }
                        link = cell.add(g as usize);
                    }
                }
            }
            for v in 0..self.vertex_count {
                let mut h = *first.add(v);
                while h != NONE {
                    h = cell.add(h as usize).replace(NONE);
                }
            }
            opposite.set_len(self.origin.len());
        }
        opposite
    }

    /// Where to start around each vertex: the half-edge at the boundary, else the least. An error where a vertex has
    /// several fans: half-edges that come before both their neighbours, as every start does, are counted by turning.
    pub(super) fn links(&self, opposite: &[u32]) -> Result<Vec<u32>, &'static str> {
        assert_eq!(self.origin.len(), opposite.len());
        let mut first = vec![NONE; self.vertex_count];
        let mut is_single = true;
        for h in 0..opposite.len() as u32 {
            // SAFETY: half-edges are below the length of `opposite`, vertices below that of `first`.
            unsafe {
                let across = *opposite.get_unchecked(h as usize);
                let after = *opposite.get_unchecked(prev(h) as usize);
                if across != NONE && (h > next(across) || h > after) {
                    continue;
                }
                let first = first.get_unchecked_mut(*self.origin.get_unchecked(h as usize) as usize);
                is_single &= *first == NONE;
                if *first == NONE || across == NONE {
                    *first = h;
                }
            }
        }
        if is_single || self.reached(opposite, &first) == opposite.len() {
            Ok(first)
        } else {
            Err("a vertex of several fans")
        }
    }

    /// How many half-edges the fans of these starts have.
    fn reached(&self, opposite: &[u32], first: &[u32]) -> usize {
        let fan = |start: u32| {
            let (mut h, mut count) = (start, 0);
            while h != NONE {
                count += 1;
                h = opposite[prev(h) as usize];
                if h == start {
                    break;
                }
            }
            count
        };
        first.iter().map(|&start| fan(start)).sum()
    }
}
