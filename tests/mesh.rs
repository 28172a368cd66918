//! `Mesh` obeys the laws of every trait that the features ask for: CI runs this with none, with each preset, and
//! with all.
use onering::conformance::{self as laws, Case, Flaw};
use onering::{Mesh, Topology};

const NO_ROW: &[&str] = &["MateFace", "HalfEdgeMesh", "WingedEdge"];

/// What `Mesh` holds under these features.
fn holds() -> Vec<Flaw> {
    use Flaw::*;
    let mesh = std::any::type_name::<Mesh>();
    let is_row = !NO_ROW.iter().any(|name| mesh.ends_with(name));
    let any = |features: &[bool]| features.contains(&true);
    let holds_all = any(&[
        cfg!(feature = "hold-defects"),
        cfg!(feature = "adjacency-graph"),
        cfg!(feature = "mate-face") && is_row,
    ]);
    let is_incidence = cfg!(feature = "incidence")
        || any(&[cfg!(feature = "mate-face"), cfg!(feature = "half-edge"), cfg!(feature = "winged-edge")]);
    if holds_all {
        vec![NonManifoldEdge, SameDirection, SeveralFans]
    } else if cfg!(feature = "mate-face") {
        vec![SameDirection, SeveralFans]
    } else if is_incidence {
        vec![]
    } else if cfg!(feature = "adjacency") {
        vec![SeveralFans]
    } else {
        vec![Degenerate, NonManifoldEdge, SameDirection, SeveralFans]
    }
}

fn each(law: impl Fn(&Case, &Mesh)) {
    let holds = holds();
    for case in laws::corpus() {
        if let Some(mesh) = laws::build::<Mesh>(&case, &holds) {
            law(&case, &mesh);
        }
    }
}

#[test]
fn topology() {
    each(laws::topology);
    each(laws::from_faces);
    each(laws::footprint);
}

#[cfg(any(
    feature = "adjacency",
    feature = "mate-face",
    feature = "half-edge",
    feature = "winged-edge",
    feature = "adjacency-graph"
))]
#[test]
fn adjacency() {
    each(laws::adjacency);
}

#[cfg(any(
    feature = "incidence",
    feature = "mate-face",
    feature = "half-edge",
    feature = "winged-edge",
    feature = "adjacency-graph"
))]
#[test]
fn incidence() {
    each(laws::incidence);
    each(laws::graph);
}

#[cfg(any(feature = "edge-map", feature = "winged-edge"))]
#[test]
fn edge_map() {
    each(laws::edge_map);
}

#[cfg(feature = "boundary-curves")]
#[test]
fn boundaries() {
    each(laws::boundaries);
}

/// A preset alone is that structure, byte for byte; with no preset, `Mesh` is shared-vertex.
#[test]
fn one_preset_is_its_structure() {
    use onering::footprint::Footprint;
    let presets = [
        ("shared-vertex", cfg!(feature = "shared-vertex")),
        ("che-l0", cfg!(feature = "che-l0")),
        ("che-l1", cfg!(feature = "che-l1")),
        ("che-l2", cfg!(feature = "che-l2")),
        ("che-l2-edge-table", cfg!(feature = "che-l2-edge-table")),
        ("che-l3", cfg!(feature = "che-l3")),
        ("directed-edges-small", cfg!(feature = "directed-edges-small")),
        ("directed-edges-medium", cfg!(feature = "directed-edges-medium")),
        ("directed-edges-full", cfg!(feature = "directed-edges-full")),
        ("mate-face", cfg!(feature = "mate-face")),
        ("half-edge", cfg!(feature = "half-edge")),
        ("winged-edge", cfg!(feature = "winged-edge")),
        ("adjacency-graph", cfg!(feature = "adjacency-graph")),
    ];
    // Larger presets turn the smaller ones on that they contain: then the largest, the last, is meant.
    let on: Vec<_> = presets.iter().filter(|(_, on)| *on).map(|(name, _)| *name).collect();
    let family = |name: &str| name.split('-').next().map(str::to_owned);
    let one_family =
        on.windows(2).all(|two| family(two[0]) == family(two[1]) && two[0] != "che-l2-edge-table");
    let is_column_on = cfg!(feature = "store-next") && !cfg!(feature = "directed-edges-full");
    if !one_family || is_column_on {
        return;
    }
    let name = on.last().copied().unwrap_or("shared-vertex");
    let entry = onering::registry::BACKENDS.iter().find(|entry| entry.name == name).unwrap();
    assert_eq!(Mesh::BYTES, entry.bytes, "{name}");
    assert_eq!(Mesh::vertex_count(&onering::FromFaces::from_faces(7, &[]).unwrap()), 7);
}
