//! Algorithms that take a scalar field, here the third coordinate: extrema, contours, regions.
use super::List;
use onering::critical::{self, Kind};
use onering::region::{self, StalactiteOptions};
use onering::*;
use std::collections::HashSet;

/// The field, and positions with it; `None` where they are not all finite, which every algorithm then says.
fn field<V: Handle>(list: &List) -> (Map<V, f32>, Map<V, [f32; 3]>) {
    (list.positions.iter().map(|p| p[2]).collect(), list.positions.iter().copied().collect())
}

pub(super) fn adjacency<M: Adjacency>(mesh: &M, list: &List) {
    let (field, _) = field(list);
    let levels: Vec<f32> = list.positions.iter().take(6).map(|p| p[2]).chain([0.25, 0.75]).collect();
    match contours::contours(mesh, &field, &levels) {
        Ok(lines) => contours_cross_each_face_once(mesh, &field, &levels, &lines),
        Err(NotFinite { vertex }) => assert!(!list.positions[vertex][2].is_finite()),
    }
    let Some(first) = mesh.faces().next() else { return };
    let parts = components::components(mesh);
    let grown = region::grow(mesh, [first, first], |_, _| true);
    assert_eq!(grown.faces().iter().collect::<HashSet<_>>().len(), grown.faces().len());
    assert_eq!(grown.faces().len(), parts.sizes()[parts.of(first)]);
    assert!(grown.faces().iter().all(|&f| parts.of(f) == parts.of(first)));
    let odd = region::grow(mesh, [first], |h, g| {
        assert!(g != h && relations::edge(mesh, g) == relations::edge(mesh, h));
        mesh.face(g).index() % 2 == 1
    });
    assert!(odd.faces().iter().skip(1).all(|f| f.index() % 2 == 1));
}

fn contours_cross_each_face_once<M: Adjacency>(
    mesh: &M,
    field: &Map<M::Vertex, f32>,
    levels: &[f32],
    found: &contours::Contours<M::HalfEdge>,
) {
    let mut pieces = 0;
    for line in found.lines() {
        pieces += line.segment_count();
        for crossing in line.crossings {
            assert!((0.0..=1.0).contains(&crossing.t), "{crossing:?}");
            let ends = [mesh.origin(crossing.half_edge), mesh.target(crossing.half_edge)].map(|v| field[v]);
            assert!((ends[0] < line.level) != (ends[1] < line.level), "{ends:?} at {}", line.level);
        }
        let faces: HashSet<_> = line.crossings.iter().map(|c| mesh.face(c.half_edge)).collect();
        assert_eq!(faces.len(), line.segment_count(), "a line goes through a face once");
        let is_end = |c: &contours::Crossing<_>| mesh.edge_fan(c.half_edge).count() != 2;
        let inner = &line.crossings[usize::from(!line.is_closed)..]
            [..line.segment_count() - usize::from(!line.is_closed)];
        assert!(inner.iter().all(|c| !is_end(c)));
        assert!(
            line.is_closed
                || [line.crossings.first(), line.crossings.last()].into_iter().flatten().all(is_end)
        );
    }
    let mut levels: Vec<f32> = levels.iter().copied().filter(|level| level.is_finite()).collect();
    levels.sort_by(f32::total_cmp);
    levels.dedup();
    let is_crossed = |f: &M::Face, level: f32| {
        let below = mesh.face_vertices(*f).into_iter().filter(|&v| field[v] < level).count();
        below == 1 || below == 2
    };
    let crossed = levels.iter().map(|&level| mesh.faces().filter(|f| is_crossed(f, level)).count());
    assert_eq!(pieces, crossed.sum::<usize>());
}

pub(super) fn incidence<M: Incidence>(mesh: &M, list: &List, defects: &Defects) {
    let (field, positions) = field(list);
    let Ok(kinds) = critical::classify(mesh, &field) else {
        assert!(field.as_slice().iter().any(|x| !x.is_finite()));
        assert!(critical::local_minima(mesh, &field).is_err() && critical::saddles(mesh, &field).is_err());
        return;
    };
    let used = mesh.vertices().filter(|&v| kinds[v] != Kind::Isolated);
    let indices: isize = used.map(|v| critical::index(mesh, &field, v)).sum();
    assert_eq!(indices as i64, defects.euler);
    let saddles = critical::saddles(mesh, &field).expect("finite values");
    assert!(saddles.iter().all(|&(v, multiplicity)| kinds[v] == Kind::Saddle { multiplicity }));
    assert_eq!(saddles.len(), kinds.iter().filter(|(_, kind)| matches!(kind, Kind::Saddle { .. })).count());
    assert_eq!(critical::local_minima(mesh, &field), Ok(minima(mesh, &field)));
    let negative = field.iter().map(|(_, z)| -z).collect();
    assert_eq!(critical::local_maxima(mesh, &field), Ok(minima(mesh, &negative)));
    if critical::stalactite_tips(mesh, &positions).is_ok() {
        mesh.vertices().take(4).for_each(|v| stalactite_hangs_together(mesh, &positions, v));
    }
}

/// By a search from each vertex over its plateau.
fn minima<M: Incidence>(mesh: &M, field: &Map<M::Vertex, f32>) -> Vec<M::Vertex> {
    let is_minimum = |&v: &M::Vertex| {
        let mut plateau = vec![v];
        let mut next = 0;
        while let Some(&u) = plateau.get(next) {
            next += 1;
            for w in mesh.neighbours(u) {
                if field[w] < field[v] || field[w] == field[v] && w < v {
                    return false;
                }
                if field[w] == field[v] && !plateau.contains(&w) {
                    plateau.push(w);
                }
            }
        }
        mesh.neighbours(v).next().is_some()
    };
    mesh.vertices().filter(is_minimum).collect()
}

fn stalactite_hangs_together<M: Incidence>(mesh: &M, positions: &Map<M::Vertex, [f32; 3]>, v: M::Vertex) {
    let found =
        region::stalactite(mesh, positions, v, &StalactiteOptions::default()).expect("finite positions");
    let faces: HashSet<_> = found.faces().iter().copied().collect();
    assert_eq!(faces.len(), found.faces().len());
    assert_eq!(faces.is_empty(), mesh.star(v).next().is_none());
    assert!(found.area(mesh, positions).is_finite());
    // From the faces at the tip on, all others are across an edge from one before.
    let Some(lowest) = found.vertices().iter().map(|&v| positions[v][2]).min_by(f32::total_cmp) else {
        return;
    };
    let tip = |f: &M::Face| mesh.face_vertices(*f).into_iter().any(|v| positions[v][2] == lowest);
    let reached = |f: &M::Face| {
        mesh.face_half_edges(*f)
            .into_iter()
            .any(|h| mesh.edge_fan(h).skip(1).any(|g| faces.contains(&mesh.face(g))))
    };
    assert!(found.faces().iter().all(|f| tip(f) || reached(f)));
}

pub(super) fn of_any_faces<M: Incidence>(mesh: &M, list: &List) {
    let (field, positions) = field(list);
    if positions.as_slice().as_flattened().iter().any(|x| !x.is_finite()) {
        return;
    }
    let _ = (critical::classify(mesh, &field), critical::stalactite_tips(mesh, &positions));
    assert_eq!(critical::local_minima(mesh, &field), Ok(minima(mesh, &field)));
    let levels: Vec<f32> = field.as_slice().iter().copied().take(4).collect();
    let lines = contours::contours(mesh, &field, &levels).expect("finite values");
    assert!(lines.lines().all(|line| line.length(mesh, &positions).is_finite()));
    for v in mesh.vertices() {
        let found = region::stalactite(mesh, &positions, v, &StalactiteOptions { steep: 30.0 });
        let found = found.expect("finite positions");
        assert_eq!(found.faces().iter().collect::<HashSet<_>>().len(), found.faces().len());
    }
}
