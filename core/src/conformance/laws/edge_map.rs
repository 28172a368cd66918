//! Laws of [`EdgeMap`].
use super::iteration::all;
use crate::{
    EdgeMap, Handle,
    conformance::{Case, slow::Slow},
};
use alloc::{format, vec::Vec};

/// Laws of [`EdgeMap`]: there are as many edges as counted, each has a half-edge along it, and two half-edges have the
/// same edge where they have the same ends.
pub fn edge_map<T: EdgeMap>(case: &Case, mesh: &T) {
    let name = case.name;
    assert_eq!(mesh.edge_count(), case.edges, "{name}: edge_count");
    let indices: Vec<_> = all(name, || mesh.edges()).into_iter().map(Handle::index).collect();
    assert_eq!(indices, Vec::from_iter(0..case.edges), "{name}: edges");
    for e in mesh.edges() {
        let h = mesh.half_edge(e);
        assert_eq!(mesh.edge(h), e, "{name}: {h:?} is along {e:?}");
        assert_eq!(mesh.edge_vertices(e), [mesh.origin(h), mesh.target(h)], "{name}: ends of {e:?}");
    }
    for side in Slow::of(mesh).sides {
        let h = side.name;
        let e = mesh.edge(h);
        let at = format!("{name}: {h:?} along {e:?}");
        assert!(e.index() < case.edges, "{at}: in range");
        assert!(mesh.edge_fan(mesh.half_edge(e)).any(|g| g == h), "{at}: in the fan of its half-edge");
        assert!(mesh.edge_fan(h).all(|g| mesh.edge(g) == e), "{at}: so is its whole fan");
    }
}
