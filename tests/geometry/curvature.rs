//! Curvature: Gauss and Bonnet on every mesh, and the analytic answers on solids.
use super::samples::{held, near};
use super::solids;
use onering::{Adjacency, FromFaces, Handle, Map, NotFinite, curvature, euler, measure};
use std::f64::consts::{FRAC_PI_2, PI, TAU};

/// Exact but for rounding, with boundary and with whatever defects.
pub fn gauss_bonnet<M: Adjacency + FromFaces>() {
    for sample in held::<M>() {
        let positions = sample.positions.clone().into();
        let defects = curvature::angle_defects(&sample.mesh, &positions).unwrap();
        let total: f64 = defects.as_slice().iter().sum();
        let expected = TAU * euler::euler_characteristic(&sample.mesh) as f64;
        assert!(near(total, expected, 1e-9), "{}: {total}, not {expected}", sample.name);
        let areas = curvature::mixed_areas(&sample.mesh, &positions).unwrap();
        let area = measure::area(&sample.mesh, &positions).unwrap();
        assert!(near(areas.as_slice().iter().sum(), area, 1e-9 * area), "{}", sample.name);
        assert!(areas.as_slice().iter().all(|&area| area >= 0.0), "{}", sample.name);
        for curvatures in
            [curvature::gaussian, curvature::mean].map(|of| of(&sample.mesh, &positions).unwrap())
        {
            assert!(curvatures.as_slice().iter().all(|k| k.is_finite()), "{}", sample.name);
        }
    }
    let triangle = M::from_faces(3, &[[0, 1, 2]]).unwrap();
    let broken = vec![[0.0; 3], [0.0; 3], [0.0, 0.0, f32::NAN]].into();
    for of in [curvature::angle_defects, curvature::mixed_areas, curvature::gaussian, curvature::mean] {
        assert_eq!(of(&triangle, &broken), Err(NotFinite { vertex: 2 }));
    }
}

/// Nothing inside; at the corners of the rim a quarter turn each.
pub fn flat<M: Adjacency + FromFaces>() {
    let plane = solids::plane(4, 3);
    let (mesh, positions) = (plane.build::<M>(), plane.positions());
    let defects = curvature::angle_defects(&mesh, &positions).unwrap();
    for (v, &defect) in &defects {
        let is_corner = [0, 3, 16, 19].contains(&v.index());
        assert!(near(defect, if is_corner { FRAC_PI_2 } else { 0.0 }, 1e-12), "{v:?}: {defect}");
    }
    for of in [curvature::gaussian, curvature::mean] {
        assert!(of(&mesh, &positions).unwrap().as_slice().iter().all(|k| k.abs() < 1e-12));
    }
    // Each vertex inside has the unit square around it.
    let areas = curvature::mixed_areas(&mesh, &positions).unwrap();
    assert!([5, 6, 9, 10, 13, 14].iter().all(|&v| near(areas.as_slice()[v], 1.0, 1e-12)));
}

/// The largest differences of both curvatures from what they should be.
fn errors<M: Adjacency + FromFaces>(solid: &solids::Solid, expected: impl Fn(usize) -> [f64; 2]) -> [f64; 2] {
    let (mesh, positions) = (solid.build::<M>(), solid.positions());
    let largest = |of: &Map<M::Vertex, f64>, i: usize| {
        of.iter().map(|(v, k)| (k - expected(v.index())[i]).abs()).fold(0.0, f64::max)
    };
    let gaussian = curvature::gaussian(&mesh, &positions).unwrap();
    let mean = curvature::mean(&mesh, &positions).unwrap();
    [largest(&gaussian, 0), largest(&mean, 1)]
}

pub fn sphere<M: Adjacency + FromFaces>() {
    let [coarse, fine] = [2, 3].map(|times| errors::<M>(&solids::sphere(times), |_| [1.0, 1.0]));
    for (coarse, fine) in coarse.into_iter().zip(fine) {
        assert!(coarse < 0.03 && fine < 0.4 * coarse, "{coarse} {fine}");
    }
    // From within it bends the other way.
    let mut turned = solids::sphere(2);
    turned.faces.iter_mut().for_each(|face| face.swap(0, 1));
    assert!(errors::<M>(&turned, |_| [1.0, -1.0]).iter().all(|&error| error < 0.03));
}

pub fn torus<M: Adjacency + FromFaces>() {
    let [coarse, fine] = [16, 32].map(|n| {
        let (torus, cosines) = solids::torus(3 * n, n);
        errors::<M>(&torus, |v| {
            let out = 2.0 + cosines[v];
            [cosines[v] / out, (out + cosines[v]) / (2.0 * out)]
        })
    });
    for (coarse, fine) in coarse.into_iter().zip(fine) {
        assert!(coarse < 0.1 && fine < 0.4 * coarse, "{coarse} {fine}");
    }
}

pub fn cylinder_and_cone<M: Adjacency + FromFaces>() {
    let rim = |v: usize| v.is_multiple_of(5) || v % 5 == 4;
    let expected = |v| if rim(v) { [0.0, 0.0] } else { [0.0, 0.25] };
    let [_, mean] = errors::<M>(&solids::cylinder(48, 4, 2.0), expected);
    assert!(mean < 0.002, "{mean}");
    let cylinder = solids::cylinder(48, 4, 2.0);
    let defects = curvature::angle_defects(&cylinder.build::<M>(), &cylinder.positions()).unwrap();
    assert!(defects.as_slice().iter().all(|defect| defect.abs() < 1e-5));
    // A cone of slant sqrt(2) unrolls to an angle of 2 pi / sqrt(2).
    let cone = solids::cone(200);
    let defects = curvature::angle_defects(&cone.build::<M>(), &cone.positions()).unwrap();
    assert!(near(defects.as_slice()[0], TAU * (1.0 - 0.5_f64.sqrt()), 1e-3));
    assert!(near(defects.as_slice().iter().sum(), 2.0 * PI, 1e-9));
}
