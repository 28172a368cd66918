//! Areas and volumes of solids, and of real meshes against their manifest.
use super::meshes::MESHES;
use super::samples::{all_near, near};
use super::solids;
use onering::vector;
use onering::{Adjacency, FromFaces, Map, NotFinite, SharedVertex, Topology, measure};
use std::f64::consts::{PI, TAU};

pub fn areas_and_volumes<M: Topology + FromFaces>() {
    let plane = solids::plane(3, 5);
    let (mesh, positions) = (plane.build::<M>(), plane.positions());
    assert_eq!(measure::area(&mesh, &positions), Ok(15.0));
    assert!(mesh.faces().all(|f| measure::face_area(&mesh, &positions, f) == 0.5));
    assert_eq!(measure::signed_volume(&mesh, &positions), Ok(0.0));
    let centroid = measure::centroid(&mesh, &positions).unwrap().unwrap();
    assert!(all_near(centroid, [1.5, 2.5, 0.0], 1e-12));
    assert_eq!(measure::bounding_box(&positions), Ok(Some([[0.0; 3], [3.0, 5.0, 0.0]])));
    // A sheet not through the origin is the base of a pyramid to it, of a volume below zero as it looks away.
    let raised = solids::plane(3, 5).moved([4.0, -2.0, 6.0]);
    let volume = measure::signed_volume(&raised.build::<M>(), &raised.positions()).unwrap();
    assert!(near(volume, 15.0 * 6.0 / 3.0, 1e-12));

    let cylinder = solids::cylinder(12, 3, 2.0);
    let area = measure::area(&cylinder.build::<M>(), &cylinder.positions()).unwrap();
    assert!(near(area, 12.0 * 4.0 * (PI / 12.0).sin(), 1e-5));

    let cone = solids::cone(9);
    let area = measure::area(&cone.build::<M>(), &cone.positions()).unwrap();
    let slant = (1.0 + (PI / 9.0).cos().powi(2)).sqrt();
    assert!(near(area, 9.0 * (PI / 9.0).sin() * slant, 1e-6));

    sphere_and_torus::<M>();
    nothing_and_no_number::<M>();
}

fn sphere_and_torus<M: Topology + FromFaces>() {
    let figures = |solid: &solids::Solid| {
        let (mesh, positions) = (solid.build::<M>(), solid.positions());
        [measure::area(&mesh, &positions).unwrap(), measure::signed_volume(&mesh, &positions).unwrap()]
    };
    // The error of a mesh that is inscribed falls to a quarter.
    let sphere = [2, 3]
        .map(|times| figures(&solids::sphere(times)))
        .map(|[a, v]| [2.0 * TAU - a, 2.0 / 3.0 * TAU - v]);
    let torus = [16, 32]
        .map(|n| figures(&solids::torus(2 * n, n).0))
        .map(|[a, v]| [2.0 * TAU * TAU - a, TAU * TAU - v]);
    for [coarse, fine] in [sphere, torus] {
        for (coarse, fine) in coarse.into_iter().zip(fine) {
            assert!(coarse > 0.0 && fine > 0.0 && (0.23..0.27).contains(&(fine / coarse)), "{coarse} {fine}");
        }
    }
    // Far from the origin, the volume is that of the coordinates as they are there, to the last digits.
    let near_origin = solids::sphere(2);
    let far = solids::sphere(2).moved([4096.0, -8192.0, 1024.0]);
    let back: Vec<_> = far.positions.iter().map(|p| [p[0] - 4096.0, p[1] + 8192.0, p[2] - 1024.0]).collect();
    let back = solids::Solid { positions: back, faces: near_origin.faces };
    assert!(near(figures(&far)[1], figures(&back)[1], 1e-10));
    // Turned inside out.
    let mut turned = back;
    let volume = figures(&turned)[1];
    turned.faces.iter_mut().for_each(|face| face.reverse());
    assert!(near(figures(&turned)[1], -volume, 1e-12));
}

fn nothing_and_no_number<M: Topology + FromFaces>() {
    let nothing = M::from_faces(0, &[]).unwrap();
    let none = Map::default();
    assert_eq!(measure::area(&nothing, &none), Ok(0.0));
    assert_eq!(measure::signed_volume(&nothing, &none), Ok(0.0));
    assert_eq!(measure::centroid(&nothing, &none), Ok(None));
    assert_eq!(measure::bounding_box::<M::Vertex>(&none), Ok(None));
    let triangle = M::from_faces(3, &[[0, 1, 2]]).unwrap();
    let line = vec![[0.0; 3], [1.0, 0.0, 0.0], [2.0, 0.0, 0.0]].into();
    assert_eq!(measure::centroid(&triangle, &line), Ok(None));
    let broken = vec![[0.0; 3], [1.0, f32::NAN, 0.0], [f32::INFINITY, 0.0, 0.0]].into();
    let error = NotFinite { vertex: 1 };
    assert_eq!(measure::area(&triangle, &broken), Err(error.clone()));
    assert_eq!(measure::signed_volume(&triangle, &broken), Err(error.clone()));
    assert_eq!(measure::centroid(&triangle, &broken), Err(error.clone()));
    assert_eq!(measure::bounding_box(&broken), Err(error));
}

pub fn edges_count_once<M: Adjacency + FromFaces>() {
    // 3 x 6 along, 5 x 4 up, 15 diagonals.
    let plane = solids::plane(3, 5);
    let (mesh, positions) = (plane.build::<M>(), plane.positions());
    let mean = measure::mean_edge_length(&mesh, &positions).unwrap().unwrap();
    assert!(near(mean, (38.0 + 15.0 * 2_f64.sqrt()) / 53.0, 1e-12));
    for h in mesh.half_edges() {
        let ends = [mesh.origin(h), mesh.target(h)].map(|v| vector::of(positions[v]));
        let straight = vector::length(vector::minus(ends[0], ends[1]));
        assert!(near(measure::edge_length(&mesh, &positions, h), straight, 1e-12));
    }
    let nothing = M::from_faces(2, &[]).unwrap();
    assert_eq!(measure::mean_edge_length(&nothing, &vec![[0.0; 3]; 2].into()), Ok(None));
    assert!(measure::mean_edge_length(&nothing, &vec![[f32::NAN; 3]; 2].into()).is_err());
    // Three faces on an edge of length 1, and six edges of length sqrt(2).
    if let Ok(book) = M::from_faces(5, &[[0, 1, 2], [1, 0, 3], [0, 1, 4]]) {
        let s = 1.75_f32.sqrt();
        let positions =
            vec![[-0.5, 0.0, 0.0], [0.5, 0.0, 0.0], [0.0, s, 0.0], [0.0, -s, 0.0], [0.0, 0.0, s]].into();
        let mean = measure::mean_edge_length(&book, &positions).unwrap().unwrap();
        assert!(near(mean, (1.0 + 6.0 * 2_f64.sqrt()) / 7.0, 1e-6));
    }
}

/// The manifest has the file's decimals in 64 bits, where the reader rounds to 32.
pub fn real<M: Topology + FromFaces>() {
    for real in &*MESHES {
        let Ok(mesh) = M::from_faces(real.mesh.positions.len(), &real.mesh.faces) else { continue };
        let positions = real.mesh.positions.clone().into();
        let expected = |figure: &str| real.figures[figure].as_f64().unwrap();
        let area = measure::area(&mesh, &positions).unwrap();
        assert!(near(area, expected("area"), 1e-5 * area), "{}: {area}", real.name);
        let [low, high] = measure::bounding_box(&positions).unwrap().unwrap();
        let extent = low.iter().chain(&high).fold(0.0_f64, |extent, &x| extent.max(f64::from(x).abs()));
        let volume = measure::signed_volume(&mesh, &positions).unwrap();
        let tolerance = 1e-6 * area * extent;
        assert!(near(volume, expected("signed_volume"), tolerance), "{}: {volume}", real.name);
        // From the origin, as the manifest has it, of these coordinates.
        let six = |f| {
            let [a, b, c] = mesh.face_vertices(f).map(|v| vector::of(positions[v]));
            vector::dot(a, vector::cross(b, c))
        };
        let plain = mesh.faces().map(six).sum::<f64>() / 6.0;
        assert!(near(volume, plain, 1e-9 * area * extent), "{}: {volume} {plain}", real.name);
    }
}

#[test]
fn every_real_mesh_is_measured() {
    let held = |real: &&super::meshes::Real| {
        SharedVertex::from_faces(real.mesh.positions.len(), &real.mesh.faces).is_ok()
    };
    assert_eq!(MESHES.iter().filter(held).count(), MESHES.len());
}
