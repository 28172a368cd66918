//! Which vertices and faces are asked for: random, and the same at every run.

pub(crate) use crate::random::scramble;

use crate::random::Random;
use onering::{BuildError, Pairing, memory};

/// A list of triangles to build from.
#[derive(Clone, Debug)]
pub(crate) struct Soup {
    pub(crate) vertex_count: usize,
    pub(crate) faces: Vec<[u32; 3]>,
    /// Whether every backend holds it.
    pub(crate) is_clean: bool,
}

impl Soup {
    /// Whether searching all faces at every step takes no longer than on a regular mesh of a few times `limit`
    /// triangles. A random corner is at a vertex of d faces as often as there are d, and going around takes d
    /// searches: the sum of squares is 18 a triangle where each vertex has six faces.
    pub(crate) fn is_quick_to_search(&self, limit: usize) -> Result<bool, BuildError> {
        Ok(self.faces.len() <= limit && self.squared_degrees()? <= 60_u64.saturating_mul(limit as u64))
    }

    /// Whether to look around a vertex of each corner, and all that so many times, takes seconds at most, or is what a
    /// regular mesh of this size takes in any case.
    pub(crate) fn is_quick_to_look_around(&self, times: usize) -> Result<bool, BuildError> {
        Ok(self.squared_degrees()? <= 1_000_000_000 / times as u64 + 60 * self.faces.len() as u64)
    }

    /// The sum over all vertices of the square of their numbers of faces.
    fn squared_degrees(&self) -> Result<u64, BuildError> {
        let mut degrees = memory::filled(self.vertex_count, 0_u32)?;
        self.faces.as_flattened().iter().for_each(|&v| degrees[v as usize] += 1);
        Ok(degrees.iter().map(|&degree| u64::from(degree).pow(2)).sum())
    }
}

/// Random elements of a soup.
#[derive(Clone, Debug)]
pub(crate) struct Sample {
    /// Where rings start (Biscaro et al. 2016, 5.1.2, take 30 vertices).
    pub(crate) starts: Vec<u32>,
    /// Vertices whose one-ring is asked for.
    pub(crate) vertices: Vec<u32>,
    /// Faces whose neighbours across all three edges are asked for.
    pub(crate) faces: Vec<u32>,
}

/// Number of vertices that rings start from.
pub(crate) const STARTS: usize = 30;
/// Number of random queries of each kind.
pub(crate) const QUERIES: usize = 10_000;

impl Sample {
    /// A random choice, with repetition, of faces and of their corners: so no vertex is isolated, and one of high
    /// degree is as likely to be asked for as it is to be met. `soup` has faces.
    pub(crate) fn of(soup: &Soup, seed: u64) -> Self {
        let mut random = Random(seed);
        let corners = soup.faces.as_flattened();
        let mut vertices = |count| (0..count).map(|_| corners[random.below(corners.len())]).collect();
        let (starts, vertices) = (vertices(STARTS), vertices(QUERIES));
        let faces = (0..QUERIES).map(|_| random.below(soup.faces.len()) as u32).collect();
        Self { starts, vertices, faces }
    }
}

/// The strategies to time: the quadratic one only if asked.
pub(crate) fn strategies(with_quadratic: bool) -> impl Iterator<Item = Pairing> {
    Pairing::ALL.into_iter().filter(move |&pairing| with_quadratic || pairing != Pairing::Quadratic)
}

#[cfg(test)]
mod tests {
    use super::*;

    /// To look around the hub for each vertex of its rim takes the square of its faces.
    #[test]
    fn a_hub_is_looked_around_fewer_times_the_more_faces_it_has() {
        let cone = |sides: u32| {
            let faces = (0..sides).map(|side| [0, 1 + side, 1 + (side + 1) % sides]).collect();
            Soup { vertex_count: 1 + sides as usize, faces, is_clean: true }
        };
        let is_quick = |sides| [1, 4, 120].map(|times| cone(sides).is_quick_to_look_around(times).unwrap());
        let expected = [[true; 3], [true, true, false], [true, false, false], [false; 3]];
        assert_eq!([2_500, 10_000, 30_000, 40_000].map(is_quick), expected);
    }

    #[test]
    fn a_sample_is_the_same_each_time_and_within_bounds() {
        let soup = Soup { vertex_count: 9, faces: vec![[1, 2, 3], [3, 2, 7]], is_clean: true };
        let [one, two] = [1, 1].map(|seed| Sample::of(&soup, seed));
        assert_eq!((&one.starts, &one.faces), (&two.starts, &two.faces));
        assert!(one.vertices.iter().all(|v| [1, 2, 3, 7].contains(v)) && one.vertices.len() == QUERIES);
        assert!(one.faces.contains(&0) && one.faces.contains(&1) && one.faces.iter().all(|&f| f < 2));
        assert_ne!(one.vertices, Sample::of(&soup, 2).vertices);
    }
}
