//! The fans of every vertex, found over cells.
use super::cell::{Cell, Walk};
use crate::build::{fans_of, numbered};
use crate::link::CodedLink;
use alloc::vec::Vec;
use onering_core::{
    BuildError, FaceId, HalfEdgeId, Handle, Slot, VertexId,
    memory::{self, Spare},
    pairing::Starts,
};

/// Where in its fan a cell is. What comes first makes the better start.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord)]
pub(super) enum Place {
    /// Nothing lies across the half-edge out of the vertex: a walk from here is counter-clockwise.
    ClockwiseEnd,
    /// Nothing lies across the half-edge into it: only where faces disagree is no end of a fan better.
    OtherEnd,
    /// There are mates on both sides.
    Inside,
}

impl Place {
    const ALL: [Self; 3] = [Self::ClockwiseEnd, Self::OtherEnd, Self::Inside];

    #[inline]
    pub(super) fn of(cell: &Cell, i: usize) -> Self {
        if cell.across_out(i).is_none() {
            Self::ClockwiseEnd
        } else if cell.across_in(i).is_none() {
            Self::OtherEnd
        } else {
            Self::Inside
        }
    }
}

/// A fan that is not the first of its vertex, ordered as they are listed.
type Further = (VertexId, Place, FaceId);

/// For each vertex the start cell of its fan, or the place of its record; and the records, each its length and
/// then its start cells. O(faces); one byte of scratch for each half-edge where some vertex has several fans.
pub(super) fn find(vertex_count: usize, cells: &[Cell]) -> Result<(Vec<CodedLink>, Vec<u32>), BuildError> {
    let first = first_starts(vertex_count, cells)?;
    let walk = |(v, start): (usize, &Slot<FaceId>)| Walk::new(cells, VertexId::new(v), start.get());
    let seen: usize = first.iter().enumerate().map(|start| walk(start).count()).sum();
    let further = if seen == 3 * cells.len() { Vec::new() } else { further_starts(cells, &first)? };
    let records = records(&first, &further)?;
    // A link to a cell is written as a link to a half-edge of that number.
    let link = |start: &Slot<FaceId>| CodedLink::from(Slot::from(start.get().map(as_number)));
    let mut links = memory::collected(first.iter().map(link))?;
    let mut place = 0;
    for fans in further.chunk_by(|a, b| a.0 == b.0) {
        links[fans[0].0.index()] = numbered(place)?;
        place += 2 + fans.len();
    }
    Ok((links, records))
}

/// The same for faces that agree in orientation, found by their opposites: a fan is then what it is for all structures, and
/// its start is in the lowest face. The pairing may have found them; else they are in a table of `spare`.
pub(super) fn of_opposites(
    vertex_count: usize,
    faces: &[[u32; 3]],
    opposite: &[Slot<HalfEdgeId>],
    starts: Starts,
    spare: &mut Spare,
) -> Result<(Vec<CodedLink>, Vec<u32>), BuildError> {
    let fans = fans_of(vertex_count, faces, opposite, starts, spare)?;
    let face = |h: HalfEdgeId| FaceId::new(h.index() / 3);
    let link = |start: Slot<HalfEdgeId>| CodedLink::from(Slot::from(start.get().map(face).map(as_number)));
    let mut links: Vec<CodedLink> = fans.outgoing.into_vec().into_iter().map(link).collect(); // in place
    let mut records = memory::with_room(fans.several.iter().map(|(_, starts)| 1 + starts.len()).sum())?;
    for (v, starts) in &fans.several {
        links[v.index()] = numbered(records.len())?;
        records.push(starts.len() as u32);
        records.extend(starts.iter().map(|&h| face(h).index() as u32));
    }
    Ok((links, records))
}

fn as_number(f: FaceId) -> HalfEdgeId {
    HalfEdgeId::new(f.index())
}

/// The best start of each vertex: that of its first fan.
fn first_starts(vertex_count: usize, cells: &[Cell]) -> Result<Vec<Slot<FaceId>>, BuildError> {
    let mut first: Vec<Slot<FaceId>> = memory::filled(vertex_count, Slot::NONE)?;
    for (f, cell) in cells.iter().enumerate() {
        for (i, &v) in cell.vertices.iter().enumerate() {
            let best = first[v.index()].get().map(|g| {
                let cell = &cells[g.index()];
                Place::of(cell, cell.position(v))
            });
            if best.is_none_or(|best| Place::of(cell, i) < best) {
                first[v.index()] = Slot::some(FaceId::new(f));
            }
        }
    }
    Ok(first)
}

/// What the walks from the first starts do not see begins further fans.
fn further_starts(cells: &[Cell], first: &[Slot<FaceId>]) -> Result<Vec<Further>, BuildError> {
    let mut seen = memory::filled(3 * cells.len(), false)?;
    for (v, start) in first.iter().enumerate() {
        Walk::new(cells, VertexId::new(v), start.get()).for_each(|(h, _)| seen[h.index()] = true);
    }
    let mut further: Vec<Further> = Vec::new();
    for place in Place::ALL {
        for h in 0..seen.len() {
            let (cell, i) = (&cells[h / 3], h % 3);
            if seen[h] || Place::of(cell, i) != place {
                continue;
            }
            let (v, start) = (cell.vertices[i], FaceId::new(h / 3));
            Walk::new(cells, v, Some(start)).for_each(|(h, _)| seen[h.index()] = true);
            memory::push(&mut further, (v, place, start))?;
        }
    }
    further.sort_unstable();
    Ok(further)
}

fn records(first: &[Slot<FaceId>], further: &[Further]) -> Result<Vec<u32>, BuildError> {
    let by_vertex = || further.chunk_by(|a, b| a.0 == b.0);
    let mut words = memory::with_room(by_vertex().map(|fans| 2 + fans.len()).sum())?;
    for fans in by_vertex() {
        let starts = first[fans[0].0.index()].get().into_iter().chain(fans.iter().map(|fan| fan.2));
        words.push(1 + fans.len() as u32);
        words.extend(starts.map(|f| f.index() as u32));
    }
    Ok(words)
}
