//! The lists of a file that is read in parts, filled by all threads.

use std::mem::MaybeUninit;
use std::sync::atomic::{AtomicUsize, Ordering};

use super::Reader;
use super::numbering::settled;
use crate::Error;
use crate::memory::reserve;

/// Entries for which there is room at least. Room that is not used costs nothing but addresses.
const ROOM: usize = 1 << 18;

/// What becomes of the parts of a file, one behind the other.
#[derive(Default)]
pub(super) struct Lists {
    pub(super) positions: Vec<[f32; 3]>,
    pub(super) faces: Vec<[u32; 3]>,
    /// The first face of each polygon, once one of them is no triangle.
    pub(super) starts: Option<Vec<u32>>,
}

/// The least room that is to be made.
#[derive(Default)]
pub(super) struct Needed {
    positions: usize,
    faces: usize,
    starts: bool,
}

impl Needed {
    /// For this part.
    pub(super) fn by(part: &Reader) -> Self {
        let polygons = &part.polygons;
        let (positions, faces) = (part.positions.len(), polygons.faces().len());
        Self { positions, faces, starts: polygons.starts().is_some() }
    }
}

impl Lists {
    /// Makes room, most often as much as is filled, and has `fill` put parts there.
    pub(super) fn with_room<T>(
        &mut self,
        needed: &Needed,
        fill: impl FnOnce(&mut Rooms<'_>) -> T,
    ) -> Result<T, Error> {
        reserve(&mut self.positions, needed.positions.max(ROOM))?;
        reserve(&mut self.faces, needed.faces.max(ROOM))?;
        if self.starts.is_none() && needed.starts {
            let mut starts = Vec::new();
            reserve(&mut starts, self.faces.len())?;
            // Until now, each face was a polygon.
            starts.extend(0..self.faces.len() as u32);
            self.starts = Some(starts);
        }
        if let Some(starts) = &mut self.starts {
            reserve(starts, needed.faces.max(ROOM))?;
        }
        Ok(self.fill(fill))
    }

    #[expect(unsafe_code, reason = "only raw room can be filled by several threads without writing it twice")]
    fn fill<T>(&mut self, fill: impl FnOnce(&mut Rooms<'_>) -> T) -> T {
        let unfilled = AtomicUsize::new(0);
        let mut rooms = Rooms {
            positions: Room::behind(&mut self.positions),
            faces: Room::behind(&mut self.faces),
            starts: self.starts.as_mut().map(Room::behind),
            unfilled: &unfilled,
        };
        let result = fill(&mut rooms);
        let (positions, faces) = (rooms.positions.taken, rooms.faces.taken);
        let starts = rooms.starts.map(|room| room.taken);
        assert_eq!(unfilled.into_inner(), 0, "every share is filled");
        // SAFETY: `taken` is where the shares of each list end, all of which lie behind its elements, without gaps, and
        // were written as a whole.
        unsafe {
            self.positions.set_len(positions);
            self.faces.set_len(faces);
            if let Some((list, taken)) = self.starts.as_mut().zip(starts) {
                list.set_len(taken);
            }
        }
        result
    }
}

/// The room behind the elements of a list.
struct Room<'a, T> {
    left: &'a mut [MaybeUninit<T>],
    /// Elements before it: those of the list, and the shares that were taken.
    taken: usize,
}

impl<'a, T> Room<'a, T> {
    fn behind(list: &'a mut Vec<T>) -> Self {
        let taken = list.len();
        Self { left: list.spare_capacity_mut(), taken }
    }

    fn has(&self, count: usize) -> bool {
        count <= self.left.len()
    }

    /// The next `count`, which there are.
    fn take(&mut self, count: usize) -> &'a mut [MaybeUninit<T>] {
        let share;
        (share, self.left) = std::mem::take(&mut self.left).split_at_mut(count);
        self.taken += count;
        share
    }
}

/// Where the next parts go.
pub(super) struct Rooms<'a> {
    positions: Room<'a, [f32; 3]>,
    faces: Room<'a, [u32; 3]>,
    starts: Option<Room<'a, u32>>,
    /// Shares that were taken and are not filled.
    unfilled: &'a AtomicUsize,
}

impl<'a> Rooms<'a> {
    /// Whether corners can name the vertices of the next part: if not, no room is enough.
    pub(super) fn has_numbers(&self) -> bool {
        u32::try_from(self.positions.taken).is_ok()
    }

    /// The share of the next part of the file; `None` if it is larger than what is left, or there are no
    /// numbers for it.
    pub(super) fn take(&mut self, part: &Reader) -> Option<Share<'a>> {
        let polygons = &part.polygons;
        let starts = polygons.starts().map_or(polygons.faces().len(), <[u32]>::len);
        let has_starts = match &self.starts {
            Some(room) => room.has(starts),
            None => polygons.starts().is_none(),
        };
        if !has_starts || !self.positions.has(part.positions.len()) || !self.faces.has(polygons.faces().len())
        {
            return None;
        }
        let (vertices, first_face) = (u32::try_from(self.positions.taken).ok()?, self.faces.taken as u32);
        self.unfilled.fetch_add(1, Ordering::Relaxed);
        Some(Share {
            positions: self.positions.take(part.positions.len()),
            faces: self.faces.take(polygons.faces().len()),
            starts: self.starts.as_mut().map(|room| room.take(starts)),
            vertices,
            first_face,
            unfilled: self.unfilled,
        })
    }
}

/// Where a part goes.
pub(super) struct Share<'a> {
    positions: &'a mut [MaybeUninit<[f32; 3]>],
    faces: &'a mut [MaybeUninit<[u32; 3]>],
    starts: Option<&'a mut [MaybeUninit<u32>]>,
    /// How many there are before.
    vertices: u32,
    first_face: u32,
    unfilled: &'a AtomicUsize,
}

impl Share<'_> {
    /// Fills all of it; `false` if a corner that is counted back names no vertex.
    ///
    /// # Panics
    /// If this is not the share of a part of such counts: some of it would never be written.
    pub(super) fn fill(self, part: &Reader) -> bool {
        let face_count = part.polygons.faces().len();
        let start_count = part.polygons.starts().map_or(face_count, <[u32]>::len);
        assert_eq!(self.faces.len(), face_count, "faces of another part");
        assert!(
            self.starts.as_ref().is_none_or(|places| places.len() == start_count),
            "polygons of another part"
        );
        self.positions.write_copy_of_slice(&part.positions);
        let (_, mut exist) = settled(part.lowest_skipped, self.vertices);
        for (place, face) in self.faces.iter_mut().zip(part.polygons.faces()) {
            place.write(face.map(|corner| {
                let (corner, exists) = settled(corner, self.vertices);
                exist &= exists;
                corner
            }));
        }
        let start = |face: u32| self.first_face.wrapping_add(face);
        match (self.starts, part.polygons.starts()) {
            (Some(places), Some(of_part)) => places.iter_mut().zip(of_part).for_each(|(place, face)| {
                place.write(start(*face));
            }),
            (Some(places), None) => places.iter_mut().zip(0..).for_each(|(place, face)| {
                place.write(start(face));
            }),
            (None, _) => {}
        }
        self.unfilled.fetch_sub(1, Ordering::Relaxed);
        exist
    }
}

#[cfg(test)]
mod tests {
    use super::super::numbering::Numbering;
    use super::*;

    fn part(text: &str) -> Reader {
        let mut reader = Reader::new(Numbering::of_part());
        reader.lines(text.as_bytes()).unwrap();
        reader
    }

    /// Puts a part behind the others, with as much room as it needs.
    fn put(lists: &mut Lists, text: &str) -> bool {
        let part = part(text);
        lists.with_room(&Needed::by(&part), |rooms| rooms.take(&part).unwrap().fill(&part)).unwrap()
    }

    #[test]
    fn parts_stand_behind_each_other() {
        let mut lists = Lists::default();
        assert!(put(&mut lists, "v 0 0 0\nv 1 1 1\nf 1 2 3\n"));
        assert_eq!(lists.starts, None);
        assert!(put(&mut lists, "v 2 2 2\nf -1 -2 -3 4\nf 1 2 3\n"));
        assert!(put(&mut lists, "f -1 2 3\n"));
        assert_eq!(lists.positions, [[0.0; 3], [1.0; 3], [2.0; 3]]);
        assert_eq!(lists.faces, [[0, 1, 2], [2, 1, 0], [2, 0, 3], [0, 1, 2], [2, 1, 2]]);
        assert_eq!(lists.starts, Some(vec![0, 1, 3, 4]));
        assert!(!put(&mut lists, "f -1 -2 -4\n"));
        assert!(!put(&mut lists, "f -4\n"));
    }

    #[test]
    #[should_panic(expected = "faces of another part")]
    fn a_share_is_filled_by_its_own_part() {
        let (mut lists, part_of_one, other) = (Lists::default(), part("f 1 2 3\n"), part("\n"));
        let fill = |rooms: &mut Rooms<'_>| rooms.take(&part_of_one).unwrap().fill(&other);
        let _ = lists.with_room(&Needed::by(&part_of_one), fill);
    }

    #[test]
    fn what_is_larger_than_the_room_is_refused() {
        let mut lists = Lists::default();
        let (large, square) = (part(&"v 0 0 0\n".repeat(3 * ROOM)), part("f 1 2 3 4\n"));
        let refused = |rooms: &mut Rooms<'_>| rooms.take(&large).is_none() && rooms.take(&square).is_none();
        assert!(lists.with_room(&Needed::default(), refused).unwrap());
        assert!(lists.positions.is_empty());
    }

    #[test]
    fn vertices_run_out_of_numbers() {
        let unfilled = AtomicUsize::new(0);
        for (taken, has_numbers) in [(u32::MAX as usize, true), (1 << 32, false)] {
            let positions = Room { left: &mut [], taken };
            let faces = Room { left: &mut [], taken: 0 };
            let mut rooms = Rooms { positions, faces, starts: None, unfilled: &unfilled };
            assert_eq!(rooms.has_numbers(), has_numbers);
            let empty = part("\n");
            assert_eq!(rooms.take(&empty).is_some_and(|share| share.fill(&empty)), has_numbers);
        }
    }
}
