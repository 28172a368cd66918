//! Laws of [`Incidence`].
use super::{graph::same_neighbours, iteration::all};
use crate::{
    Handle, Incidence,
    conformance::{Case, slow::Slow},
};
use alloc::{collections::BTreeSet, format, string::String, vec::Vec};

/// Laws of [`Incidence`]: a star is all half-edges out of a vertex, in fans, open ones first; the ring goes round
/// the first; and neighbours are those that a search finds.
///
/// Where two faces run along an edge of the vertex in the same direction, a backend may end the fan there, as turns
/// across opposites do, or go on into the face beyond.
pub fn incidence<T: Incidence>(case: &Case, mesh: &T) {
    let slow = Slow::of(mesh);
    for v in mesh.vertices() {
        let at = format!("{}: {v:?}", case.name);
        let around = Around { at, mesh, slow: &slow, v };
        let runs = around.runs();
        around.fans(&runs);
        around.ring(&runs);
        around.neighbours();
    }
}

struct Around<'a, T: Incidence> {
    at: String,
    mesh: &'a T,
    slow: &'a Slow<T::HalfEdge>,
    v: T::Vertex,
}

impl<T: Incidence> Around<'_, T> {
    /// The star, cut where a fan starts. Half-edges are named by their place in the search.
    fn runs(&self) -> Vec<Vec<usize>> {
        let (at, mesh, v) = (&self.at, self.mesh, self.v);
        let starts = all(at, || mesh.fans(v));
        let star = all(at, || mesh.star(v));
        assert_eq!(mesh.outgoing(v), starts.first().copied(), "{at}: outgoing starts the first fan");
        assert_eq!(mesh.outgoing(v), star.first().copied(), "{at}: outgoing starts the star");
        let out = self.slow.names(self.slow.out_of(v.index()));
        assert_eq!(star.len(), out.len(), "{at}: star has each face once");
        assert_eq!(star.iter().copied().collect::<BTreeSet<_>>(), out, "{at}: star");
        let mut runs: Vec<Vec<usize>> = Vec::new();
        for h in star {
            if starts.get(runs.len()) == Some(&h) {
                runs.push(Vec::new());
            }
            let place = self.slow.sides.iter().position(|side| side.name == h);
            runs.last_mut().expect("a star begins with a fan").extend(place);
        }
        assert_eq!(runs.len(), starts.len(), "{at}: every fan is in the star, in the order of fans");
        runs
    }

    fn has_same_direction(&self) -> bool {
        let edges = |i: usize| [i, self.slow.sides[i].prev];
        let out = self.slow.out_of(self.v.index());
        out.into_iter().flat_map(edges).any(|i| self.slow.is_same_direction(i))
    }

    fn fans(&self, runs: &[Vec<usize>]) {
        let (at, v) = (&self.at, self.v.index());
        let sets = |of: &[Vec<usize>]| {
            of.iter().map(|fan| BTreeSet::from_iter(fan.clone())).collect::<BTreeSet<_>>()
        };
        if sets(runs) != sets(&self.slow.fans(v)) {
            assert!(self.has_same_direction(), "{at}: fans {runs:?}");
            assert_eq!(sets(runs), sets(&self.slow.fans_across_edges(v)), "{at}: fans across edges");
            self.each_touches_the_next(runs);
            return;
        }
        for pair in runs.iter().flat_map(|run| run.windows(2)) {
            assert_eq!(self.slow.ccw(pair[0]), Some(pair[1]), "{at}: a fan is counter-clockwise");
        }
        let open: Vec<bool> = runs.iter().map(|run| self.slow.opposite(run[0]).is_none()).collect();
        assert!(open.is_sorted_by(|a, b| a >= b), "{at}: open fans come first");
        for (run, &open) in runs.iter().zip(&open) {
            let comes_round = self.slow.ccw(run[run.len() - 1]) == Some(run[0]);
            assert_eq!(comes_round, !open, "{at}: an open fan starts at its clockwise end");
        }
    }

    fn each_touches_the_next(&self, runs: &[Vec<usize>]) {
        for pair in runs.iter().flat_map(|run| run.windows(2)) {
            assert!(self.slow.touch(pair[0], pair[1]), "{}: a fan goes from face to face", self.at);
        }
    }

    fn ring(&self, runs: &[Vec<usize>]) {
        let ring = all(&self.at, || self.mesh.one_ring(self.v));
        let ring: Vec<usize> = ring.into_iter().map(Handle::index).collect();
        let first: &[usize] = runs.first().map_or(&[], |run| run);
        let sides = &self.slow.sides;
        if self.has_same_direction() {
            let ends = |i: usize| [sides[i].to, sides[sides[i].prev].from];
            let vertices: BTreeSet<usize> = first.iter().flat_map(|&i| ends(i)).collect();
            assert_eq!(ring.len(), vertices.len(), "{}: one_ring has each vertex once", self.at);
            assert_eq!(BTreeSet::from_iter(ring), vertices, "{}: one_ring", self.at);
            return;
        }
        let lead = first.first().filter(|&&i| self.slow.opposite(i).is_none()).map(|&i| sides[i].to);
        let expected = lead.into_iter().chain(first.iter().map(|&i| sides[sides[i].prev].from));
        assert_eq!(ring, Vec::from_iter(expected), "{}: one_ring, face by face", self.at);
    }

    fn neighbours(&self) {
        let (mesh, v) = (self.mesh, self.v);
        let found = all(&self.at, || mesh.neighbours(v));
        same_neighbours(&self.at, &self.slow.neighbours(v.index()), found);
    }
}
