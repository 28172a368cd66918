//! What every structure has to find, by a sort of all edges and searches in the sorted list: by no structure.

use crate::mesh::mixed;
use crate::record::{FOUR_RING, RING, Run};

/// The edges of a mesh, and the sums of its rings.
pub(crate) struct Expected {
    pub(crate) edge_count: usize,
    ring: u64,
    four_ring: u64,
}

impl Expected {
    pub(crate) fn of(vertex_count: usize, faces: &[[u32; 3]], queries: &[u32]) -> Self {
        let sides = faces.iter().flat_map(|&[a, b, c]| [(a, b), (b, c), (c, a)]);
        let mut directed: Vec<(u32, u32)> = sides.flat_map(|(u, v)| [(u, v), (v, u)]).collect();
        directed.sort_unstable();
        directed.dedup();
        let ring = directed.iter().map(|&(v, u)| mixed(v, u)).fold(0, u64::wrapping_add);
        let four_ring = four_rings(vertex_count, &directed, queries);
        Self { edge_count: directed.len() / 2, ring, four_ring }
    }

    /// The run, where its rings are these.
    pub(crate) fn check(&self, run: Run) -> Result<Run, String> {
        let is_wrong = |task: &str, expected: u64| {
            let mut answers = run.tasks.iter().filter(|other| other.task == task);
            answers.any(|task| task.answer != Some(expected))
        };
        if is_wrong(RING, self.ring) || is_wrong(FOUR_RING, self.four_ring) {
            return Err("its rings are not those of the faces".into());
        }
        Ok(run)
    }
}

/// Vertices within four edges of the queries.
fn four_rings(vertex_count: usize, directed: &[(u32, u32)], queries: &[u32]) -> u64 {
    let neighbours = |v: u32| {
        let from = directed.partition_point(|&(u, _)| u < v);
        directed[from..].iter().take_while(move |&&(u, _)| u == v).map(|&(_, u)| u)
    };
    let mut seen = vec![false; vertex_count];
    let mut sum = 0_u64;
    for &query in queries {
        let mut reached = vec![query];
        seen[query as usize] = true;
        let mut level = 0..1;
        for _ in 0..4 {
            for i in level.clone() {
                for u in neighbours(reached[i]) {
                    if !std::mem::replace(&mut seen[u as usize], true) {
                        reached.push(u);
                    }
                }
            }
            level = level.end..reached.len();
        }
        for &u in &reached {
            seen[u as usize] = false;
        }
        sum = reached[1..].iter().map(|&u| mixed(query, u)).fold(sum, u64::wrapping_add);
    }
    sum
}
