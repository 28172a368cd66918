//! Large binary files, of which only a piece at a time is in memory.

use std::io::Read;

use onering_core::repair::Welder;

use super::{HEADER, MOST, RECORD, corner_of, corners_of, declared, has_binary_length, unwelded_faces};
use crate::Triangles;
use crate::memory::reserve;

/// Triangles of a piece: 200 KiB, which stay in the cache until they are welded.
const PIECE: usize = 4096;

/// Reads a binary file of this length as [`read`](super::read) would. `None` if that one is to read it, since it has
/// another length than it declares, its corners have to be sorted, it cannot be read, or memory ran out.
pub(crate) fn read(file: impl Read, length: u64, weld: bool) -> Option<Triangles> {
    read_pieces(file, length, weld, PIECE)
}

fn read_pieces(mut file: impl Read, length: u64, weld: bool, size: usize) -> Option<Triangles> {
    let mut header = [0; HEADER];
    file.read_exact(&mut header).ok()?;
    let count = usize::try_from(declared(&header)?).ok().filter(|count| *count <= MOST)?;
    if !has_binary_length(&header, length) {
        return None;
    }
    let mut faces = Vec::new();
    reserve(&mut faces, count).ok()?;
    let mut corners = Vec::new();
    let mut welder = None;
    match weld {
        true => welder = Some(Welder::new(3 * count).ok()?),
        false => reserve(&mut corners, count).ok()?,
    }
    let mut piece = vec![[0; RECORD]; size.min(count)];
    while faces.len() < count {
        let (start, left) = (faces.len(), count - faces.len());
        let records = &mut piece[..size.min(left)];
        file.read_exact(records.as_flattened_mut()).ok()?;
        match &mut welder {
            Some(welder) => {
                faces.resize(start + records.len(), [0; 3]);
                let targets = faces[start..].as_flattened_mut();
                let welded = welder.add(targets, |corner| corner_of(&records[corner / 3], corner % 3));
                welded.ok().filter(|welded| *welded)?;
            }
            None => {
                faces.extend(unwelded_faces(start..start + records.len()));
                corners.extend(records.iter().map(corners_of));
            }
        }
    }
    let mut positions = welder.map_or(corners.into_flattened(), Welder::into_positions);
    positions.shrink_to_fit();
    Some(Triangles::new(positions, faces))
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::Options;
    use proptest::prelude::*;

    /// A file of triangles with these corners.
    fn file(corners: &[[[f32; 3]; 3]]) -> Vec<u8> {
        let mut file = vec![b' '; HEADER - 4];
        file.extend((corners.len() as u32).to_le_bytes());
        for triangle in corners {
            file.extend([7; 12]);
            triangle.as_flattened().iter().for_each(|x| file.extend(x.to_le_bytes()));
            file.extend([9; 2]);
        }
        file
    }

    proptest! {
        #[test]
        fn pieces_give_what_the_whole_gives(
            corners in prop::collection::vec(prop::array::uniform3(prop::array::uniform3(-2i8..2)), 0..40),
            weld: bool,
            size in 1usize..50,
            cut in 0usize..200,
        ) {
            let file = file(&Vec::from_iter(corners.iter().map(|corners| corners.map(|p| p.map(f32::from)))));
            let whole = super::super::read(&file, &Options { weld_stl: weld }).unwrap();
            prop_assert_eq!(read_pieces(&file[..], file.len() as u64, weld, size), Some(whole));
            // Of another length, or shorter than was thought.
            let cut = &file[..file.len().saturating_sub(cut + 1)];
            prop_assert_eq!(read_pieces(cut, cut.len() as u64, weld, size), None);
            prop_assert_eq!(read_pieces(cut, file.len() as u64, weld, size), None);
        }
    }
}
