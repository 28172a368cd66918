//! A first look: every row answers on a tetrahedron.
use onering::*;

#[test]
fn rows() {
    let faces = [[0, 1, 2], [0, 3, 1], [0, 2, 3], [1, 3, 2]];
    for strategy in Pairing::ALL {
        let m = CheL3::build(4, faces[..].into(), strategy).unwrap();
        assert_eq!(m.vertices().map(|v| m.one_ring(v).count()).sum::<usize>(), 12);
        assert_eq!(m.edge_count(), 6);
    }
    let m = DirectedEdgesMedium::from_faces(5, &[[0, 1, 2], [1, 0, 3], [0, 1, 4]]).unwrap();
    assert_eq!(m.to_faces(), [[0, 1, 2], [1, 0, 3], [0, 1, 4]]);
    for v in m.vertices() {
        eprintln!(
            "{v:?} {:?} {:?} {:?}",
            m.fans(v).collect::<Vec<_>>(),
            m.one_ring(v).collect::<Vec<_>>(),
            m.neighbours(v).collect::<Vec<_>>()
        );
    }
    for h in m.half_edges() {
        eprintln!("{h:?} {:?} {:?}", m.opposite(h), m.edge_fan(h).collect::<Vec<_>>());
    }
    assert!(CheL2::from_faces(5, &[[0, 1, 2], [0, 3, 4]]).unwrap_err().to_string().contains("vertex 0"));
}

#[test]
fn registry() {
    for e in registry::BACKENDS {
        println!("{} {:?} {}: {}", e.name, e.traits, e.bytes.per_triangle(), e.bytes);
    }
    assert_eq!(registry::BACKENDS[4].name, "che-l2-edge-table");
    assert_eq!(registry::BACKENDS[4].bytes.per_triangle(), 44);
}
