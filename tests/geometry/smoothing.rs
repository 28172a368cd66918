//! Smoothing: by its definition, and what it does to shapes.
use super::samples::{all_near, held, near};
use super::solids;
use onering::smoothing::{Options, SmoothingError, Weights, smooth};
use onering::vector::{self, Vector};
use onering::{Adjacency, FromFaces, Handle, Map, NotFinite, measure};
use std::collections::BTreeMap;

/// One step from the list of faces: every edge with the corners that face it.
fn slow(faces: &[[u32; 3]], positions: &[[f32; 3]], weights: Weights, lambda: f64) -> Vec<Vector> {
    let at = |v: u32| vector::of(positions[v as usize]);
    let mut facing = BTreeMap::<[u32; 2], Vec<u32>>::new();
    for &[a, b, c] in faces {
        for [p, q, apex] in [[a, b, c], [b, c, a], [c, a, b]] {
            facing.entry([p.min(q), p.max(q)]).or_default().push(apex);
        }
    }
    let weight = |[p, q]: [u32; 2], apexes: &[u32]| match weights {
        Weights::Uniform => 1.0,
        Weights::Cotangent => {
            let cotangent = |&apex: &u32| {
                let (u, v) = (vector::minus(at(p), at(apex)), vector::minus(at(q), at(apex)));
                let across = vector::length(vector::cross(u, v));
                if across > 0.0 { vector::dot(u, v) / across } else { 0.0 }
            };
            apexes.iter().map(cotangent).sum::<f64>().max(0.0)
        }
    };
    let moved = |v: u32| {
        let edges = || facing.iter().filter(move |(ends, _)| ends.contains(&v));
        let (mut sum, mut total) = ([0.0; 3], 0.0);
        for (ends, apexes) in edges() {
            let weight = weight(*ends, apexes);
            let u = ends[0] + ends[1] - v;
            sum = vector::plus(sum, vector::times(weight, at(u)));
            total += weight;
        }
        if total == 0.0 || edges().any(|(_, apexes)| apexes.len() == 1) {
            return at(v);
        }
        vector::plus(vector::times(1.0 - lambda, at(v)), vector::times(lambda / total, sum))
    };
    (0..positions.len() as u32).map(moved).collect()
}

const WEIGHTS: [Weights; 2] = [Weights::Uniform, Weights::Cotangent];

pub fn by_definition<M: Adjacency + FromFaces>() {
    for sample in held::<M>() {
        for weights in WEIGHTS {
            let options = Options { weights, steps: 1, lambda: 0.7, mu: None };
            let mut positions = sample.positions.clone().into();
            smooth(&sample.mesh, &mut positions, |_| false, &options).unwrap();
            let expected = slow(&sample.faces, &sample.positions, weights, 0.7);
            for ((v, &p), q) in positions.iter().zip(expected) {
                assert!(all_near(vector::of(p), q, 1e-5), "{} {v:?} {weights:?}: {p:?} {q:?}", sample.name);
            }
        }
    }
    refusals::<M>();
}

fn refusals<M: Adjacency + FromFaces>() {
    let cone = solids::cone(5);
    let mesh = cone.build::<M>();
    let run = |positions: &mut Map<M::Vertex, _>, lambda, mu| {
        smooth(&mesh, positions, |_| false, &Options { lambda, mu, ..Options::default() })
    };
    let mut positions = cone.positions();
    for lambda in [0.0, -0.5, 1.1, f64::INFINITY] {
        assert_eq!(run(&mut positions, lambda, None), Err(SmoothingError::Lambda(lambda)));
    }
    assert!(matches!(run(&mut positions, f64::NAN, None), Err(SmoothingError::Lambda(_))));
    for (lambda, mu) in [(0.5, -0.5), (0.5, 0.6), (0.9, -1.0), (0.5, f64::NEG_INFINITY)] {
        assert_eq!(run(&mut positions, lambda, Some(mu)), Err(SmoothingError::Mu { lambda, mu }));
    }
    assert_eq!(positions, cone.positions());
    let mut broken = cone.positions();
    broken.as_mut_slice()[3][1] = f32::NAN;
    assert_eq!(run(&mut broken, 0.5, None), Err(SmoothingError::NotFinite(NotFinite { vertex: 3 })));
}

/// A vertex that was pushed out of a plane comes back to it; the rim and what the caller keeps do not move.
pub fn plane_stays<M: Adjacency + FromFaces>() {
    for weights in WEIGHTS {
        let mut plane = solids::plane(6, 6);
        plane.positions[24][2] = 1.0;
        plane.positions[32][2] = 0.5;
        let mut positions = plane.positions();
        let options = Options { weights, steps: 300, ..Options::default() };
        smooth(&plane.build::<M>(), &mut positions, |v: M::Vertex| v.index() == 32, &options).unwrap();
        let [pushed, kept] = [24, 32].map(|v| positions.as_slice()[v]);
        assert!(kept == plane.positions[32] && (0.0..0.4).contains(&pushed[2]), "{weights:?}");
        for (v, p) in plane.positions.iter().enumerate() {
            let is_rim = [0, 6].contains(&(v / 7)) || [0, 6].contains(&(v % 7));
            assert!(!is_rim || positions.as_slice()[v] == *p, "{weights:?} {v}");
        }
    }
    // By cotangents a plane of uneven triangles is as it should be, and stays.
    let mut plane = solids::plane(4, 4);
    plane.positions.iter_mut().for_each(|p| p[0] += 0.03 * p[0] * p[0] - 0.2 * p[1]);
    let (mesh, mut positions) = (plane.build::<M>(), plane.positions());
    let options = Options { weights: Weights::Cotangent, steps: 5, ..Options::default() };
    smooth(&mesh, &mut positions, |_| false, &options).unwrap();
    let same = |(p, q): (&[f32; 3], &[f32; 3])| all_near(vector::of(*p), vector::of(*q), 1e-5);
    assert!(positions.as_slice().iter().zip(&plane.positions).all(same));
}

pub fn sphere_shrinks_unless_told_not_to<M: Adjacency + FromFaces>() {
    let sphere = solids::sphere(2);
    let mesh = sphere.build::<M>();
    let volume = |positions: &Map<M::Vertex, _>| measure::signed_volume(&mesh, positions).unwrap();
    let before = volume(&sphere.positions());
    for weights in WEIGHTS {
        let run = |options: &Options| {
            let mut positions = sphere.positions();
            smooth(&mesh, &mut positions, |_| false, options).unwrap();
            // It stays round, but that vertices of five neighbours move at another pace.
            let radii = positions.as_slice().iter().map(|&p| vector::length(vector::of(p)));
            let (least, most) = radii.fold((f64::MAX, 0.0_f64), |(a, b), r| (a.min(r), b.max(r)));
            assert!(most / least < 1.04, "{least} {most}");
            volume(&positions) / before
        };
        let plain = run(&Options { weights, steps: 20, lambda: 0.33, mu: None });
        let taubin = run(&Options::taubin(weights, 20));
        assert!(plain < 0.8 && near(taubin, 1.0, 0.03), "{weights:?}: {plain} {taubin}");
    }
}
