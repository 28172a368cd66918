//! Meshes to be written: polygons of all sizes, vertices without faces, numbers of all kinds.
#![allow(dead_code, reason = "each test uses a part of it")]

use onering_io::{Attribute, MeshRef, Triangles, Values};
use proptest::prelude::*;
use proptest::sample::Index;

/// What a [`MeshRef`] borrows from.
#[derive(Clone, Debug, Default)]
pub(crate) struct Mesh {
    pub(crate) positions: Vec<[f32; 3]>,
    pub(crate) faces: Vec<[u32; 3]>,
    pub(crate) polygon_starts: Option<Vec<u32>>,
}

impl Mesh {
    pub(crate) fn as_ref(&self) -> MeshRef<'_> {
        let mut mesh = MeshRef::new(&self.positions, &self.faces);
        mesh.polygon_starts = self.polygon_starts.as_deref();
        mesh
    }

    /// Panics unless the file had just this mesh, all numbers to the last bit, but for the payload of a NaN.
    pub(crate) fn assert_eq(&self, read: &Triangles) {
        assert_eq!(self.polygon_starts, read.polygon_starts);
        self.assert_eq_but_polygons(read);
    }

    pub(crate) fn assert_eq_but_polygons(&self, read: &Triangles) {
        assert_eq!(self.faces, read.faces);
        assert_eq!(bits(&self.positions), bits(&read.positions));
    }
}

/// Equal exactly where the numbers are the same; every NaN is one.
pub(crate) fn bits(positions: &[[f32; 3]]) -> Vec<[u32; 3]> {
    let bits = |x: f32| if x.is_nan() { f32::NAN.to_bits() } else { x.to_bits() };
    positions.iter().map(|position| position.map(bits)).collect()
}

/// Any bits, and often those at the edges.
pub(crate) fn any_number() -> impl Strategy<Value = f32> {
    let edges =
        vec![0.0, -0.0, f32::from_bits(1), -f32::MIN_POSITIVE, f32::MAX, f32::MIN, 0.1, f32::INFINITY];
    prop_oneof![
        any::<u32>().prop_map(f32::from_bits),
        prop::sample::select(edges),
        Just(f32::NAN),
        -1e3f32..1e3
    ]
}

pub(crate) fn finite_number() -> impl Strategy<Value = f32> {
    any_number().prop_map(|x| if x.is_finite() { x } else { 0.5 })
}

prop_compose! {
    /// Up to 12 vertices and as many polygons, now and then one of more than 255 corners.
    pub(crate) fn any_mesh(number: BoxedStrategy<f32>)(
        positions in prop::collection::vec(prop::array::uniform3(number), 0..12),
        polygons in prop::collection::vec(
            prop_oneof![
                6 => prop::collection::vec(any::<Index>(), 3..4),
                3 => prop::collection::vec(any::<Index>(), 4..9),
                1 => prop::collection::vec(any::<Index>(), 250..260),
            ],
            0..12,
        ),
    ) -> Mesh {
        let polygons = if positions.is_empty() { Vec::new() } else { polygons };
        let (mut faces, mut starts) = (Vec::new(), Vec::new());
        for polygon in polygons {
            let corner = |i: usize| polygon[i].index(positions.len()) as u32;
            starts.push(faces.len() as u32);
            faces.extend((2..polygon.len()).map(|i| [corner(0), corner(i - 1), corner(i)]));
        }
        let polygon_starts = (starts.len() < faces.len()).then_some(starts);
        Mesh { positions, faces, polygon_starts }
    }
}

/// Values of every kind, `count` of each.
#[derive(Clone, Debug)]
pub(crate) struct AllKinds {
    pub(crate) flags: Vec<bool>,
    pub(crate) labels: Vec<u32>,
    pub(crate) scalars: Vec<f32>,
}

impl AllKinds {
    /// Made from the numbers, over and over.
    pub(crate) fn of(numbers: &[u32], count: usize, number: impl Fn(u32) -> f32) -> Self {
        let numbers = || numbers.iter().copied().cycle().take(count);
        Self {
            flags: numbers().map(|n| n % 2 == 1).collect(),
            labels: numbers().collect(),
            scalars: numbers().map(number).collect(),
        }
    }

    pub(crate) fn attributes(&self) -> [Attribute<'_>; 3] {
        [
            Attribute { name: "height", values: Values::Scalars(&self.scalars) },
            Attribute { name: "component", values: Values::Labels(&self.labels) },
            Attribute { name: "on boundary", values: Values::Flags(&self.flags) },
        ]
    }
}

/// The two triangles of a square.
pub(crate) fn square() -> Mesh {
    Mesh {
        positions: vec![[0.0; 3], [1.0, 0.0, 0.0], [1.0, 1.0, 0.0], [0.0, 1.0, 0.0]],
        faces: vec![[0, 1, 2], [0, 2, 3]],
        polygon_starts: Some(vec![0]),
    }
}
