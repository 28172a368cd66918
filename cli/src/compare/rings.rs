//! Rings of several levels around a vertex, timed.

use super::kernels::mix;
use crate::timing::{Clock, Timing};
use onering::Handle;
use onering::k_ring::KRing;
use onering::neighbours::Neighbours;

/// To how many levels rings go.
pub(crate) const LEVELS: usize = 4;

/// The rings of some vertices.
#[derive(Clone, Debug, Default)]
pub(crate) struct Rings {
    /// For the rings of all starts together, to 1, 2, ... levels.
    pub(crate) timings: Vec<Timing>,
    /// How many vertices are within 1, 2, ... edges of each start, itself left out.
    pub(crate) counts: Vec<[usize; LEVELS]>,
}

impl Rings {
    /// Searches from each start. The scratch is kept from one search to the next and is not timed.
    pub(crate) fn of<M: Neighbours>(mesh: &M, starts: &[u32], clock: &Clock) -> Self {
        let mut ring = KRing::new();
        let nodes: Vec<M::Node> = starts.iter().map(|&v| M::Node::new(v as usize)).collect();
        let mut search = |k| nodes.iter().map(|&v| ring.search(mesh, v, k).count(k)).sum::<usize>();
        let timings = (1..=LEVELS).map(|k| clock.time(|| search(k))).collect();
        let counts = nodes.iter().map(|&v| {
            let found = ring.search(mesh, v, LEVELS);
            std::array::from_fn(|k| found.count(k + 1))
        });
        Self { timings, counts: counts.collect() }
    }

    /// One number of all counts.
    pub(crate) fn checksum(&self) -> u64 {
        self.counts.as_flattened().iter().fold(0, |sum, &count| mix(sum as usize, count))
    }

    /// Vertices within 1, 2, ... edges, on average: Table 5 of Biscaro et al. (2016).
    pub(crate) fn means(&self) -> [f64; LEVELS] {
        let of = |k: usize| self.counts.iter().map(|counts| counts[k]).sum::<usize>() as f64;
        std::array::from_fn(|k| of(k) / self.counts.len() as f64)
    }
}
