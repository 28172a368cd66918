//! Normals: of solids, and by their definition on every mesh of the corpus.
use super::samples::{all_near, held};
use super::solids;
use onering::normals::{Weight, face_normal, vertex_normal, vertex_normals};
use onering::vector::{self, Vector};
use onering::{FromFaces, Handle, Incidence, Map, NotFinite, Topology};

const WEIGHTS: [Weight; 2] = [Weight::Area, Weight::Angle];

pub fn of_solids<M: Topology + FromFaces>() {
    let plane = solids::plane(3, 2);
    let (mesh, positions) = (plane.build::<M>(), plane.positions());
    assert!(mesh.faces().all(|f| face_normal(&mesh, &positions, f) == Some([0.0, 0.0, 1.0])));
    for weight in WEIGHTS {
        let normals = vertex_normals(&mesh, &positions, weight).unwrap();
        assert!(normals.iter().all(|(_, &n)| all_near(n, [0.0, 0.0, 1.0], 1e-15)));

        // The farther out, the nearer a sphere's normal is to its position.
        let errors = [2, 3].map(|times| {
            let sphere = solids::sphere(times);
            let normals = vertex_normals(&sphere.build::<M>(), &sphere.positions(), weight).unwrap();
            let off = |(v, &n): (M::Vertex, _)| {
                vector::length(vector::minus(n, vector::of(sphere.positions[v.index()])))
            };
            normals.iter().map(off).fold(0.0, f64::max)
        });
        assert!(errors[0] < 0.03 && errors[1] < 0.51 * errors[0], "{weight:?} {errors:?}");

        let cone = solids::cone(7);
        let normals = vertex_normals(&cone.build::<M>(), &cone.positions(), weight).unwrap();
        assert!(all_near(normals.as_slice()[0], [0.0, 0.0, 1.0], 1e-6));
    }
    cube_corner::<M>();
}

/// Three right angles, of which one is cut in two: by angle that makes no difference, by area it does.
fn cube_corner<M: Topology + FromFaces>() {
    let mesh = M::from_faces(6, &[[0, 1, 5], [0, 5, 2], [0, 2, 3], [0, 3, 1]]).unwrap();
    let (x, y, z) = ([1.0, 0.0, 0.0], [0.0, 1.0, 0.0], [0.0, 0.0, 1.0]);
    let positions: Map<M::Vertex, _> = vec![[0.0; 3], x, y, z, [9.0; 3], [1.0, 1.0, 0.0]].into();
    let by_angle = vertex_normals(&mesh, &positions, Weight::Angle).unwrap();
    assert!(all_near(by_angle.as_slice()[0], [1.0 / 3_f64.sqrt(); 3], 1e-12));
    let by_area = vertex_normals(&mesh, &positions, Weight::Area).unwrap();
    assert!(all_near(
        by_area.as_slice()[0],
        [1.0 / 6_f64.sqrt(), 1.0 / 6_f64.sqrt(), 2.0 / 6_f64.sqrt()],
        1e-12
    ));
    assert_eq!(by_area.as_slice()[4], [0.0; 3]);
    let broken = vec![[f32::INFINITY; 3]; 6].into();
    assert_eq!(vertex_normals(&mesh, &broken, Weight::Area), Err(NotFinite { vertex: 0 }));
}

/// The sum over all corners of all faces that name the vertex, written apart from the library: angles by the arc cosine.
fn slow(faces: &[[u32; 3]], positions: &[[f32; 3]], v: usize, weight: Weight) -> Vector {
    let mut sum = [0.0; 3];
    for face in faces {
        for k in (0..3).filter(|&k| face[k] as usize == v) {
            let [at, p, q] = [k, k + 1, k + 2].map(|k| vector::of(positions[face[k % 3] as usize]));
            let (u, w) = (vector::minus(p, at), vector::minus(q, at));
            let across = vector::cross(u, w);
            let (length, sides) = (vector::length(across), vector::length(u) * vector::length(w));
            if length > 0.0 {
                let angle = (vector::dot(u, w) / sides).clamp(-1.0, 1.0).acos();
                let factor = if weight == Weight::Area { 1.0 } else { angle / length };
                sum = vector::plus(sum, vector::times(factor, across));
            }
        }
    }
    sum
}

fn agrees(found: Vector, sum: Vector) -> bool {
    let length = vector::length(sum);
    // Faces that cancel each other leave what rounding leaves.
    if length < 1e-9 {
        found == [0.0; 3] || (vector::length(found) - 1.0).abs() < 1e-12
    } else {
        all_near(found, vector::times(1.0 / length, sum), 1e-6)
    }
}

pub fn by_definition<M: Topology + FromFaces>() {
    for sample in held::<M>() {
        let positions = sample.positions.clone().into();
        for weight in WEIGHTS {
            let normals = vertex_normals(&sample.mesh, &positions, weight).unwrap();
            for (v, &n) in &normals {
                let sum = slow(&sample.faces, &sample.positions, v.index(), weight);
                assert!(agrees(n, sum), "{} {v:?} {weight:?}: {n:?} {sum:?}", sample.name);
            }
        }
    }
}

pub fn one_by_one<M: Incidence + FromFaces>() {
    for sample in held::<M>() {
        let positions = sample.positions.clone().into();
        for weight in WEIGHTS {
            for v in sample.mesh.vertices() {
                let n = vertex_normal(&sample.mesh, &positions, v, weight);
                let sum = slow(&sample.faces, &sample.positions, v.index(), weight);
                assert!(agrees(n.unwrap_or_default(), sum), "{} {v:?} {weight:?}", sample.name);
                assert!(sum == [0.0; 3] || n.is_some(), "{} {v:?} {weight:?}", sample.name);
            }
        }
    }
}
