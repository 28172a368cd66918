//! The columns of [`Table`](crate::Table), made from a face list.
use crate::link::{Coded, Coding, Link};
use alloc::{borrow::Cow, vec::Vec};
use onering_core::{
    Adjacency, BuildError, FaceId, HalfEdgeId, Handle, Pairing, Slot, Topology, VertexId, boundary, corner,
    fans::{self, Fans},
    memory::{self, Spare},
    pairing::{self, Starts},
};

/// Records of irregular elements, one after the other: each its length, then its half-edges. Places are counted
/// from 0; Campagna et al. (1998) leave the first place empty and count from 1, which names them alike.
#[derive(Debug, Default)]
pub(crate) struct Records {
    pub(crate) words: Vec<u32>,
}

impl Records {
    fn new<'a>(records: impl Iterator<Item = &'a [HalfEdgeId]> + Clone) -> Result<Self, BuildError> {
        let mut words = memory::with_room(records.clone().map(|record| 1 + record.len()).sum())?;
        for record in records {
            words.push(record.len() as u32);
            words.extend(record.iter().map(|h| h.index() as u32));
        }
        Ok(Self { words })
    }

    /// Every record with its place.
    fn iter(&self) -> impl Iterator<Item = (usize, &[u32])> {
        let mut place = 0;
        core::iter::from_fn(move || {
            let at = place;
            (at < self.words.len()).then(|| {
                let record = record(&self.words, at);
                place += 1 + record.len();
                (at, record)
            })
        })
    }
}

/// The half-edges of the record at `place`.
#[inline]
pub(crate) fn record(words: &[u32], place: usize) -> &[u32] {
    &words[place + 1..][..words[place] as usize]
}

/// The words of a record as half-edges.
#[inline]
pub(crate) fn half_edges(record: &[u32]) -> impl ExactSizeIterator<Item = HalfEdgeId> + Clone {
    record.iter().map(|&h| HalfEdgeId::new(h as usize))
}

/// Links across edges and out of vertices, with the records that they may name.
#[derive(Debug)]
pub(crate) struct Links<K> {
    pub(crate) opposite: Vec<K>,
    pub(crate) edge_records: Records,
    pub(crate) outgoing: Vec<K>,
    pub(crate) vertex_records: Records,
}

impl<K> Default for Links<K> {
    fn default() -> Self {
        Self {
            opposite: Vec::new(),
            edge_records: Records::default(),
            outgoing: Vec::new(),
            vertex_records: Records::default(),
        }
    }
}

/// Pairs half-edges, finds the fans where `with_outgoing`, and puts what is irregular into records if `holds`.
pub(crate) fn links<K: Link>(
    vertex_count: usize,
    faces: &[[u32; 3]],
    pairing: Pairing,
    with_outgoing: bool,
    holds: bool,
    spare: &mut Spare,
) -> Result<Links<K>, BuildError> {
    let table = spare.table(3 * faces.len())?;
    let (paired, starts) = if with_outgoing {
        pairing::pair_with_starts(vertex_count, faces, pairing, table, spare)?
    } else {
        (pairing::pair_into(vertex_count, faces, pairing, table, spare)?, None)
    };
    let mut edge_records = Records::default();
    let opposite = if holds {
        edge_records = Records::new(paired.irregular.iter())?;
        paired.opposite
    } else {
        paired.refuse_irregular(faces)?
    };
    let (mut outgoing, mut vertex_records) = (Vec::new(), Records::default());
    if with_outgoing {
        let fans = fans_of(vertex_count, faces, &opposite, starts, spare)?;
        if holds {
            vertex_records = Records::new(fans.several.iter().map(|(_, starts)| &starts[..]))?;
            outgoing = into_links(fans.outgoing.into_vec());
            for ((place, _), (v, _)) in vertex_records.iter().zip(&fans.several) {
                outgoing[v.index()] = numbered(place)?;
            }
        } else {
            outgoing = into_links(fans.refuse_several()?.into_vec());
        }
    }
    let mut opposite: Vec<K> = into_links(opposite);
    for (place, record) in edge_records.iter() {
        for h in half_edges(record) {
            opposite[h.index()] = numbered(place)?;
        }
    }
    Ok(Links { opposite, edge_records, outgoing, vertex_records })
}

/// The fans of faces with opposites, before there is a mesh, where the pairing has not found their starts.
pub(crate) fn fans_of<'a>(
    vertex_count: usize,
    faces: &'a [[u32; 3]],
    opposite: &'a [Slot<HalfEdgeId>],
    starts: Starts,
    spare: &mut Spare,
) -> Result<Fans<impl Topology<Vertex = VertexId, HalfEdge = HalfEdgeId> + use<'a>>, BuildError> {
    match starts {
        Some(starts) => Ok(Fans { outgoing: starts.into(), several: Vec::new() }),
        None => fans::fans_into(&View { vertex_count, faces, opposite }, spare.room(vertex_count)?),
    }
}

/// The same table in another coding, in place.
fn into_links<K: Link>(slots: Vec<Slot<HalfEdgeId>>) -> Vec<K> {
    slots.into_iter().map(K::from).collect()
}

pub(crate) fn numbered<K: Link>(number: usize) -> Result<K, BuildError> {
    let limit = Coded::MAX_HALF_EDGES;
    K::numbered(number).ok_or(BuildError::TooManyRecords { words: number, limit })
}

impl<K: Link> Links<K> {
    /// The least half-edge along the edge of `h`. Not after curves were named.
    fn least(&self, h: usize) -> usize {
        let link = self.opposite[h];
        let first = link.number().map(|place| record(&self.edge_records.words, place)[0] as usize);
        first.or_else(|| link.half_edge().map(Handle::index)).map_or(h, |g| g.min(h))
    }

    /// The least half-edge of each edge, ascending.
    pub(crate) fn edge_list(&self, spare: &mut Spare) -> Result<Vec<HalfEdgeId>, BuildError> {
        let is_least = |&h: &usize| self.least(h) == h;
        let half_edges = 0..self.opposite.len();
        let mut list = spare.room(half_edges.clone().filter(is_least).count())?;
        list.extend(half_edges.filter(is_least).map(HalfEdgeId::new));
        Ok(list)
    }

    /// The edge of each half-edge, as its place in the list.
    pub(crate) fn edge_index(&self, spare: &mut Spare) -> Result<Vec<onering_core::EdgeId>, BuildError> {
        let mut index: Vec<onering_core::EdgeId> = spare.table(self.opposite.len())?;
        let mut count = 0;
        for h in 0..self.opposite.len() {
            let least = self.least(h);
            if least == h {
                index[h] = Handle::new(count);
                count += 1;
            } else {
                index[h] = index[least];
            }
        }
        Ok(index)
    }

    /// The start of each boundary curve; the links of boundary half-edges then name their curve, and those of
    /// irregular edges count on from there.
    pub(crate) fn name_curves(&mut self, faces: &[[u32; 3]]) -> Result<Vec<HalfEdgeId>, BuildError> {
        let view = View { vertex_count: 0, faces, opposite: &self.opposite };
        let starts = boundary::try_curves(&view)?;
        let mut named = Vec::new();
        for (k, &start) in starts.iter().enumerate() {
            for h in boundary::Curve::new(&view, start) {
                memory::push(&mut named, (h, k))?;
            }
        }
        if !self.edge_records.words.is_empty() {
            for link in &mut self.opposite {
                if let Some(place) = link.number() {
                    *link = numbered(starts.len() + place)?;
                }
            }
        }
        for (h, k) in named {
            self.opposite[h.index()] = numbered(k)?;
        }
        Ok(starts)
    }
}

/// Faces and links as a mesh, before there is one.
struct View<'a, K> {
    /// Not asked for along the boundary.
    vertex_count: usize,
    faces: &'a [[u32; 3]],
    opposite: &'a [K],
}

impl<K> Topology for View<'_, K> {
    type Vertex = VertexId;
    type HalfEdge = HalfEdgeId;
    type Face = FaceId;

    fn vertex_count(&self) -> usize {
        self.vertex_count
    }

    fn face_count(&self) -> usize {
        self.faces.len()
    }

    fn origin(&self, h: HalfEdgeId) -> VertexId {
        VertexId::new(corner::origin(self.faces, h.index()) as usize)
    }
}

impl<K: Link> Adjacency for View<'_, K> {
    fn opposite(&self, h: HalfEdgeId) -> Option<HalfEdgeId> {
        self.opposite[h.index()].half_edge()
    }

    fn is_boundary(&self, h: HalfEdgeId) -> bool {
        let link = self.opposite[h.index()];
        link.half_edge().is_none() && link.number().is_none()
    }
}

/// The faces as a column of origins: the same memory where it is ours.
pub(crate) fn into_origins(
    faces: Cow<'_, [[u32; 3]]>,
    spare: &mut Spare,
) -> Result<Vec<VertexId>, BuildError> {
    let words = match faces {
        Cow::Owned(faces) => faces.into_flattened(),
        Cow::Borrowed(faces) => {
            let mut words = spare.room(3 * faces.len())?;
            words.extend_from_slice(faces.as_flattened());
            words
        }
    };
    Ok(bytemuck::cast_vec(words))
}

/// The faces as a column of targets: the same memory, each face turned by one, where it is ours.
pub(crate) fn into_targets(
    faces: Cow<'_, [[u32; 3]]>,
    spare: &mut Spare,
) -> Result<Vec<VertexId>, BuildError> {
    let mut vertices = into_origins(faces, spare)?;
    vertices.as_chunks_mut::<3>().0.iter_mut().for_each(|face| face.rotate_left(1));
    Ok(vertices)
}

/// A column of targets beside one of origins.
pub(crate) fn targets(faces: &[[u32; 3]], spare: &mut Spare) -> Result<Vec<VertexId>, BuildError> {
    into_targets(Cow::Borrowed(faces), spare)
}
