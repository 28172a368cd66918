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
        let first: &[usize] = runs.first().map_or(&[], |run| run);
        if around.has_fans_across_opposites(&runs) {
            around.fans_across_opposites(&runs);
            around.ring_across_opposites(first);
        } else {
            around.fans_across_edges(&runs);
            around.ring_across_edges(first);
        }
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
        assert_eq!(mesh.has_several_fans(v), starts.len() > 1, "{at}: has_several_fans");
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

    fn has_fans_across_opposites(&self, runs: &[Vec<usize>]) -> bool {
        sets(runs) == sets(&self.slow.fans(self.v.index()))
    }

    fn fans_across_opposites(&self, runs: &[Vec<usize>]) {
        let at = &self.at;
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

    fn ring_across_opposites(&self, first: &[usize]) {
        let sides = &self.slow.sides;
        let lead = first.first().filter(|&&i| self.slow.opposite(i).is_none()).map(|&i| sides[i].to);
        let expected = lead.into_iter().chain(first.iter().map(|&i| sides[sides[i].prev].from));
        assert_eq!(self.one_ring(), Vec::from_iter(expected), "{}: one_ring, face by face", self.at);
    }

    /// Only where two faces disagree may a fan be another than turns across opposites give.
    fn fans_across_edges(&self, runs: &[Vec<usize>]) {
        let (at, v) = (&self.at, self.v.index());
        let mut edges = self.slow.out_of(v).into_iter().flat_map(|i| self.edges(i));
        assert!(edges.any(|i| self.slow.is_same_direction(i)), "{at}: fans {runs:?}");
        assert_eq!(sets(runs), sets(&self.slow.fans_across_edges(v)), "{at}: fans across edges");
        for pair in runs.iter().flat_map(|run| run.windows(2)) {
            assert!(self.slow.touch(pair[0], pair[1]), "{at}: a fan goes from face to face");
        }
    }

    fn ring_across_edges(&self, first: &[usize]) {
        let (at, ring, sides) = (&self.at, self.one_ring(), &self.slow.sides);
        let is_closed = first.iter().flat_map(|&i| self.edges(i)).all(|i| sides[i].along.len() == 2);
        assert_eq!(ring.len(), first.len() + usize::from(!is_closed), "{at}: one_ring {ring:?}");
        let rim = |i: usize| BTreeSet::from([sides[i].to, sides[sides[i].prev].from]);
        // A ring that is closed may begin with either vertex of its first face.
        let spans = |turn: usize| {
            let corner = |k: usize| ring[(k + turn) % ring.len()];
            first.iter().enumerate().all(|(k, &i)| rim(i) == BTreeSet::from([corner(k), corner(k + 1)]))
        };
        let begins = spans(0) || is_closed && spans(ring.len() - 1);
        assert!(begins, "{at}: one_ring {ring:?}: two in a row are of one face");
    }

    /// The two sides at the vertex of the face of `i`, a half-edge out of it.
    fn edges(&self, i: usize) -> [usize; 2] {
        [i, self.slow.sides[i].prev]
    }

    fn one_ring(&self) -> Vec<usize> {
        let ring = all(&self.at, || self.mesh.one_ring(self.v));
        ring.into_iter().map(Handle::index).collect()
    }

    fn neighbours(&self) {
        let (mesh, v) = (self.mesh, self.v);
        let found = all(&self.at, || mesh.neighbours(v));
        same_neighbours(&self.at, &self.slow.neighbours(v.index()), found);
    }
}

fn sets(of: &[Vec<usize>]) -> BTreeSet<BTreeSet<usize>> {
    of.iter().map(|fan| fan.iter().copied().collect()).collect()
}
