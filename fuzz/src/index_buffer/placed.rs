//! Algorithms that take positions: what is finite stays finite, and what is filled is closed.
use super::List;
use onering::holes::{FillOptions, fill};
use onering::normals::{Weight, vertex_normals};
use onering::smoothing::{Options, Weights, smooth};
use onering::spring::{self, Simulation, SpringError, Stiffness};
use onering::*;
use std::f64::consts::TAU;

fn is_finite(list: &List) -> bool {
    list.positions.as_flattened().iter().all(|x| x.is_finite())
}

fn positions<V: Handle>(list: &List) -> Map<V, [f32; 3]> {
    list.positions.iter().copied().collect()
}

pub(super) fn topology<M: Topology>(mesh: &M, list: &List) {
    let positions: Map<M::Vertex, _> = positions(list);
    for &p in &list.positions {
        let nearest = nearest::nearest_vertex(&positions, vector::of(p));
        let is_asked = p.iter().all(|x| x.is_finite());
        let first = list.positions.iter().position(|q| is_asked && *q == p);
        assert_eq!(nearest.map(Handle::index), first, "{p:?}");
    }
    let (Ok(area), Ok(volume)) = (measure::area(mesh, &positions), measure::signed_volume(mesh, &positions))
    else {
        assert!(!is_finite(list) && vertex_normals(mesh, &positions, Weight::Area).is_err());
        return;
    };
    assert!(area.is_finite() && volume.is_finite());
    let centroid = measure::centroid(mesh, &positions).expect("finite positions");
    assert!(centroid.is_none_or(|p| p.iter().all(|x| x.is_finite())));
    for weight in [Weight::Area, Weight::Angle] {
        let normals = vertex_normals(mesh, &positions, weight).expect("finite positions");
        let is_unit = |n: &[f64; 3]| *n == [0.0; 3] || (vector::length(*n) - 1.0).abs() < 1e-12;
        assert!(normals.as_slice().iter().all(is_unit));
    }
}

pub(super) fn adjacency<M: Adjacency>(mesh: &M, list: &List, defects: &Defects) {
    let positions: Map<M::Vertex, _> = positions(list);
    if !is_finite(list) {
        assert!(subdivision::midpoint(mesh, &positions).is_err());
        assert!(fill(mesh, &positions, &FillOptions::default()).is_err());
        assert!(curvature::mean(mesh, &positions).is_err());
        assert!(smooth(mesh, &mut positions.clone(), |_| false, &Options::default()).is_err());
        return;
    }
    curvatures(mesh, &positions, defects);
    subdivides(mesh, &positions, defects);
    smooths(mesh, &positions);
    for (optimal_edges, weigh_folds) in [(128, true), (128, false), (0, false)] {
        let mut options = FillOptions::default();
        (options.optimal_edges, options.weigh_folds) = (optimal_edges, weigh_folds);
        fills(mesh, &positions, &options, defects);
    }
}

fn curvatures<M: Adjacency>(mesh: &M, positions: &Map<M::Vertex, [f32; 3]>, defects: &Defects) {
    let sum: f64 =
        curvature::angle_defects(mesh, positions).expect("finite positions").as_slice().iter().sum();
    assert!((sum - TAU * defects.euler as f64).abs() < 1e-6, "{sum}");
    for of in [curvature::gaussian, curvature::mean] {
        let values = of(mesh, positions).expect("finite positions");
        assert!(values.as_slice().iter().all(|x| x.is_finite()));
    }
}

fn subdivides<M: Adjacency>(mesh: &M, positions: &Map<M::Vertex, [f32; 3]>, defects: &Defects) {
    for subdivide in [subdivision::midpoint, subdivision::loop_subdivision] {
        let fine = subdivide(mesh, positions).expect("few faces, and finite positions");
        assert_eq!(fine.vertex_count, mesh.vertex_count() + defects.edges);
        assert_eq!((fine.faces.len(), fine.positions.len()), (4 * mesh.face_count(), fine.vertex_count));
        assert!(fine.positions.as_flattened().iter().all(|x| x.is_finite()));
        let after = Defects::of(fine.vertex_count, &fine.faces).expect("few faces");
        assert_eq!((after.out_of_range_faces, after.degenerate_faces), (0, 0));
        assert_eq!(after.components_by_vertex, defects.components_by_vertex);
        assert_eq!(after.isolated_vertices, defects.isolated_vertices);
        if defects.duplicate_faces == 0 {
            assert_eq!((after.euler, after.manifold), (defects.euler, defects.manifold));
            assert_eq!(after.boundary_edges, 2 * defects.boundary_edges);
        }
    }
}

fn smooths<M: Adjacency>(mesh: &M, positions: &Map<M::Vertex, [f32; 3]>) {
    for weights in [Weights::Uniform, Weights::Cotangent] {
        let mut smoothed = positions.clone();
        let options = Options { weights, steps: 3, ..Options::default() };
        smooth(mesh, &mut smoothed, |_| false, &options).expect("no vertex leaves the box");
        let boxes = [&smoothed, positions].map(|p| measure::bounding_box(p).expect("finite positions"));
        let [Some([low, high]), Some([least, most])] = boxes else { continue };
        for i in 0..3 {
            let slack = 1e-6 * least[i].abs().max(most[i].abs());
            assert!(low[i] >= least[i] - slack && high[i] <= most[i] + slack);
        }
    }
}

fn fills<M: Adjacency>(
    mesh: &M,
    positions: &Map<M::Vertex, [f32; 3]>,
    options: &FillOptions,
    before: &Defects,
) {
    let filled = fill(mesh, positions, options).expect("finite positions");
    let curves = boundary::curves(mesh);
    assert_eq!(filled.filled.len() + filled.left.len(), curves.len());
    let all = [mesh.to_faces(), filled.faces].concat();
    let after = Defects::of(mesh.vertex_count(), &all).expect("few faces");
    let sides: usize = filled.filled.iter().map(|c| boundary::Curve::new(mesh, c.start).count()).sum();
    assert_eq!(after.boundary_edges, before.boundary_edges - sides);
    assert_eq!(after.nonmanifold_edges, before.nonmanifold_edges);
    assert_eq!(after.inconsistent_edges, before.inconsistent_edges);
    assert_eq!((after.degenerate_faces, after.out_of_range_faces), (0, 0));
    assert_eq!(after.duplicate_faces, before.duplicate_faces);
}

pub(super) fn incidence<M: Incidence>(mesh: &M, list: &List) {
    let positions: Map<M::Vertex, _> = positions(list);
    let fixed: Vec<_> = mesh.vertices().take(2).collect();
    let options =
        spring::Options { fixed, stiffness: Stiffness::OverLength(1.5), damping: 0.25, ..Default::default() };
    let mut simulation = match Simulation::new(mesh, &positions, &options) {
        Ok(simulation) => simulation,
        Err(SpringError::Position(NotFinite { vertex })) => {
            return assert!(list.positions[vertex].iter().any(|x| !x.is_finite()));
        }
        Err(SpringError::ZeroLength { vertices: [a, b] }) => {
            return assert!(a < b && list.positions[a] == list.positions[b]);
        }
        Err(error) => return assert!(matches!(error, SpringError::Stiffness { .. }), "{error}"),
    };
    let Some(v) = mesh.vertices().next_back() else { return };
    simulation.push(v, [1.0, -2.0, 0.5], usize::MAX).expect("a finite force");
    let total = simulation.loads().as_slice().iter().fold([0.0; 3], |sum, &f| vector::plus(sum, f));
    assert!(vector::length(vector::minus(total, [1.0, -2.0, 0.5])) < 1e-9, "{total:?}");
    match simulation.solve(1e-6, 30) {
        Ok(solved) => {
            assert!(solved.residual <= 1e-6);
            assert!(simulation.displacements().as_slice().as_flattened().iter().all(|x| x.is_finite()));
        }
        Err(error) => {
            assert!(
                matches!(error, SpringError::Unsupported { .. } | SpringError::NotConverged { .. }),
                "{error}"
            );
        }
    }
    let step = simulation.stable_step();
    if step.is_finite() {
        (0..3).for_each(|_| simulation.step(step / 2.0));
    }
}

pub(super) fn of_any_faces<M: Incidence>(mesh: &M, list: &List) {
    incidence(mesh, list);
    if !is_finite(list) {
        return;
    }
    let positions: Map<M::Vertex, _> = positions(list);
    smooths(mesh, &positions);
    for of in [curvature::angle_defects, curvature::gaussian, curvature::mean] {
        let values = of(mesh, &positions).expect("finite positions");
        assert!(values.as_slice().iter().all(|x| x.is_finite()));
    }
    for subdivide in [subdivision::midpoint, subdivision::loop_subdivision] {
        let fine = subdivide(mesh, &positions).expect("few faces, and finite positions");
        assert!(fine.positions.as_flattened().iter().all(|x| x.is_finite()));
    }
    let filled = fill(mesh, &positions, &FillOptions::default()).expect("finite positions");
    assert!(filled.faces.as_flattened().iter().all(|&v| (v as usize) < list.vertices));
}
