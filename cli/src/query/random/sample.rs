//! Which elements are asked about: random, and the same for every structure.

use crate::random::Random;

/// Random elements of a list of faces.
#[derive(Debug)]
pub(crate) struct Sample {
    pub(crate) vertices: Vec<u32>,
    /// Faces, and which of their three sides.
    pub(crate) sides: Vec<(u32, usize)>,
    pub(crate) faces: Vec<u32>,
}

impl Sample {
    /// A choice, with repetition, of so many corners, sides and faces: so no vertex is isolated, and one of high degree
    /// is as likely to be asked about as it is to be met. There are faces.
    pub(crate) fn of(faces: &[[u32; 3]], count: usize, seed: u64) -> Self {
        let mut random = Random(seed);
        let corners = faces.as_flattened();
        Self {
            vertices: (0..count).map(|_| corners[random.below(corners.len())]).collect(),
            sides: (0..count).map(|_| (random.below(faces.len()) as u32, random.below(3))).collect(),
            faces: (0..count).map(|_| random.below(faces.len()) as u32).collect(),
        }
    }
}
