//! Any face list with any finite positions: nothing that is no number, or infinite, comes of them.
use super::distance::{is_sound, slow};
use super::random;
use onering::distance::{Dijkstra, straight};
use onering::neighbours::Neighbours;
use onering::normals::{Weight, vertex_normal, vertex_normals};
use onering::smoothing::{Options, SmoothingError, Weights, smooth};
use onering::*;
use proptest::num::f32::{NEGATIVE, NORMAL, POSITIVE, SUBNORMAL, ZERO};
use proptest::prelude::*;
use std::f64::consts::TAU;

/// All sizes that a coordinate can have, and few values, so that points coincide.
fn coordinate() -> impl Strategy<Value = f32> {
    prop_oneof![
        4 => -1.0..1.0_f32,
        3 => (-2..3_i8).prop_map(f32::from),
        2 => NORMAL | SUBNORMAL | ZERO | NEGATIVE | POSITIVE,
        1 => prop::sample::select(vec![f32::MAX, -f32::MAX, f32::MIN_POSITIVE, 1e-45, -1e-45, 1e-30]),
    ]
}

type Placed = (random::List, Vec<[f32; 3]>);

/// Faces in range, with a position for each vertex.
fn placed() -> impl Strategy<Value = Placed> {
    random::lists().prop_flat_map(|(n, mut faces)| {
        faces.retain(|face| face.iter().all(|&v| (v as usize) < n));
        let point = prop::array::uniform3(coordinate());
        (Just((n, faces)), prop::collection::vec(point, n))
    })
}

fn all_finite<H: Handle>(map: &Map<H, f64>) -> bool {
    map.as_slice().iter().all(|x| x.is_finite())
}

fn numbers<M: Incidence>(mesh: &M, positions: &Map<M::Vertex, [f32; 3]>) -> Result<(), TestCaseError> {
    let area = measure::area(mesh, positions).unwrap();
    prop_assert!(area.is_finite() && measure::signed_volume(mesh, positions).unwrap().is_finite());
    prop_assert!(measure::mean_edge_length(mesh, positions).unwrap().is_none_or(f64::is_finite));
    let centroid = measure::centroid(mesh, positions).unwrap();
    prop_assert!(centroid.is_none_or(|c| c.iter().all(|x| x.is_finite())));
    for weight in [Weight::Area, Weight::Angle] {
        let normals = vertex_normals(mesh, positions, weight).unwrap();
        for (v, &n) in &normals {
            let length = vector::length(n);
            prop_assert!(length == 0.0 || (length - 1.0).abs() < 1e-12, "{:?}", n);
            let one = vertex_normal(mesh, positions, v, weight).unwrap_or_default();
            prop_assert!(one.iter().all(|x| x.is_finite()));
        }
    }
    let defects = curvature::angle_defects(mesh, positions).unwrap();
    let expected = TAU * euler::euler_characteristic(mesh) as f64;
    prop_assert!((defects.as_slice().iter().sum::<f64>() - expected).abs() < 1e-6);
    let areas = curvature::mixed_areas(mesh, positions).unwrap();
    prop_assert!((areas.as_slice().iter().sum::<f64>() - area).abs() <= 1e-6 * area);
    prop_assert!(all_finite(&curvature::gaussian(mesh, positions).unwrap()));
    prop_assert!(all_finite(&curvature::mean(mesh, positions).unwrap()));
    Ok(())
}

/// Plain steps always end, within the box of what there was; with `mu` they end or say why not.
fn smooths<M: Adjacency>(mesh: &M, positions: &Map<M::Vertex, [f32; 3]>) -> Result<(), TestCaseError> {
    for weights in [Weights::Uniform, Weights::Cotangent] {
        for lambda in [0.3, 1.0] {
            let mut smoothed = positions.clone();
            let options = Options { weights, steps: 7, lambda, mu: None };
            smooth(mesh, &mut smoothed, |_| false, &options).unwrap();
            let [bounds, old] = [&smoothed, positions].map(|p| measure::bounding_box(p).unwrap());
            let Some(([low, high], [old_low, old_high])) = bounds.zip(old) else { continue };
            for i in 0..3 {
                let slack = 1e-6 * old_low[i].abs().max(old_high[i].abs());
                prop_assert!(low[i] >= old_low[i] - slack && high[i] <= old_high[i] + slack);
            }
        }
        let mut smoothed = positions.clone();
        match smooth(mesh, &mut smoothed, |_| false, &Options::taubin(weights, 9)) {
            Ok(()) => prop_assert!(measure::bounding_box(&smoothed).is_ok()),
            Err(error) => {
                prop_assert!(matches!(error, SmoothingError::NotFinite(_)));
                prop_assert_eq!(&smoothed, positions);
            }
        }
    }
    Ok(())
}

fn paths<G: Neighbours>(graph: &G, (list, positions): &Placed) -> Result<(), TestCaseError> {
    let (count, faces) = list;
    let positions: Map<G::Node, _> = positions.clone().into();
    let length = straight(&positions);
    let mut search = Dijkstra::new();
    for sources in (0..*count).map(|v| [v]).take(4) {
        let expected = slow(*count, faces, &sources, |a, b| length(G::Node::new(a), G::Node::new(b)));
        search.search(graph, sources.map(G::Node::new), &length).unwrap();
        for v in (0..*count).map(G::Node::new) {
            let (found, expected) = (search.distance(v), expected[v.index()]);
            prop_assert!(found == expected || (found - expected).abs() <= 1e-12 * expected);
            prop_assert!(is_sound(graph, &search, v, &sources, &length));
        }
    }
    Ok(())
}

proptest! {
    #![proptest_config(ProptestConfig { cases: 500, failure_persistence: None, ..ProptestConfig::default() })]

    #[test]
    fn numbers_of_numbers(placed in placed()) {
        let ((count, faces), positions) = &placed;
        // Searching holds degenerate faces as well.
        let searched = Searched::new(SharedVertex::from_faces(*count, faces).unwrap());
        numbers(&searched, &positions.clone().into())?;
        smooths(&searched, &positions.clone().into())?;
        if let Ok(mesh) = DirectedEdgesSmall::from_faces(*count, faces) {
            numbers(&mesh, &positions.clone().into())?;
            smooths(&mesh, &positions.clone().into())?;
        }
        if let Ok(mesh) = WingedEdge::from_faces(*count, faces) {
            numbers(&mesh, &positions.clone().into())?;
        }
    }

    #[test]
    fn paths_are_the_shortest(placed in placed()) {
        let ((count, faces), _) = &placed;
        paths(&VertexGraph::from_faces(*count, faces).unwrap(), &placed)?;
        if let Ok(mesh) = DirectedEdgesSmall::from_faces(*count, faces) {
            paths(&mesh, &placed)?;
        }
    }
}
