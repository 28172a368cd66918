//! What meets at each vertex.

use super::edges::EdgeTable;
use super::fans::Fans;
use super::triangles::Triangles;
use alloc::vec;
use alloc::vec::Vec;

/// The figures of the vertices, and by slot what they are made of.
pub(crate) struct Vertices {
    pub(crate) used: Vec<bool>,
    pub(crate) used_count: usize,
    pub(crate) bowties: Vec<u32>,
    pub(crate) nonmanifold: Vec<u32>,
    pub(crate) valence_min: usize,
    pub(crate) valence_max: usize,
    pub(crate) max_faces: usize,
}

impl Vertices {
    /// Near-linear in the corners.
    pub(crate) fn of(edges: &EdgeTable, triangles: &Triangles, fans: &mut Fans) -> Self {
        let fan_counts = fans.counts(triangles);
        let (valence, singular) = valence(edges, triangles);
        let used: Vec<bool> = valence.iter().map(|&n| n > 0).collect();
        let slots = || 0..triangles.vertex_bound as u32;
        let bowtie = |slot: &u32| fan_counts[*slot as usize] > 1;
        let nonmanifold = |slot: &u32| bowtie(slot) || singular[*slot as usize];
        let name = |slot| triangles.vertex(slot);
        Self {
            used_count: used.iter().filter(|&&used| used).count(),
            bowties: slots().filter(bowtie).map(name).collect(),
            nonmanifold: slots().filter(nonmanifold).map(name).collect(),
            valence_min: valence.iter().filter(|&&n| n > 0).min().map_or(0, |&n| n as usize),
            valence_max: valence.iter().max().map_or(0, |&n| n as usize),
            max_faces: max_faces(triangles),
            used,
        }
    }
}

/// How many edges each slot has, and whether one of them has more than two triangles.
fn valence(edges: &EdgeTable, triangles: &Triangles) -> (Vec<u32>, Vec<bool>) {
    let mut valence = vec![0; triangles.vertex_bound];
    let mut singular = vec![false; triangles.vertex_bound];
    for edge in edges.iter(triangles) {
        let (a, b) = edge.ends();
        for slot in [a as usize, b as usize] {
            valence[slot] += 1;
            singular[slot] |= edge.sides.len() > 2;
        }
    }
    (valence, singular)
}

fn max_faces(triangles: &Triangles) -> usize {
    let mut faces = vec![0u32; triangles.vertex_bound];
    for &slot in &triangles.corners {
        faces[slot as usize] += 1;
    }
    faces.into_iter().max().unwrap_or(0) as usize
}
