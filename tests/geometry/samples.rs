//! The corpus of the laws, with positions.
use onering::conformance::{Flaw, corpus};
use onering::{BuildError, FromFaces};

/// A mesh of the corpus that `M` holds, with positions that have no order.
pub struct Sample<M> {
    pub name: String,
    pub mesh: M,
    pub positions: Vec<[f32; 3]>,
    pub faces: Vec<[u32; 3]>,
}

/// Every mesh of the corpus that `M` holds: with random positions, and with all vertices in one of two places.
pub fn held<M: FromFaces>() -> Vec<Sample<M>> {
    let mut samples = Vec::new();
    for case in corpus() {
        for places in [usize::MAX, 2] {
            match M::from_faces(case.vertices, &case.faces) {
                Ok(mesh) => samples.push(Sample {
                    name: format!("{} in {places} places", case.name),
                    mesh,
                    positions: (0..case.vertices).map(|v| place(v % places)).collect(),
                    faces: case.faces.clone(),
                }),
                Err(BuildError::OutOfMemory { .. }) => panic!("{}", case.name),
                Err(error) => assert!(case.refusal(&[]).is_some(), "{}: {error}", case.name),
            }
        }
    }
    let clean = corpus().iter().filter(|case| case.refusal(&[]).is_none()).count();
    assert!(samples.len() >= 2 * clean && clean > 5);
    samples
}

/// Every defect that any backend may hold is among the samples.
#[test]
fn every_flaw_is_held_by_some() {
    let found = corpus();
    assert!(Flaw::ALL.iter().all(|flaw| found.iter().any(|case| case.flaws.iter().any(|(f, _)| f == flaw))));
}

/// Coordinates without rhyme, between -4 and 4.
fn place(v: usize) -> [f32; 3] {
    [1, 2, 3].map(|k| (((v + 3) * 7919 * (2 * k + 1)) % 1013) as f32 / 127.0 - 4.0)
}

pub fn near(a: f64, b: f64, tolerance: f64) -> bool {
    (a - b).abs() <= tolerance
}

pub fn all_near(a: [f64; 3], b: [f64; 3], tolerance: f64) -> bool {
    (0..3).all(|i| near(a[i], b[i], tolerance))
}
