//! `Mesh` obeys the laws of every trait that the features ask for: CI runs this with none, with each preset, and
//! with all.
use onering::conformance::{self as laws, Case, Flaw};
use onering::footprint::Footprint;
use onering::registry::{BACKENDS, Entry};
use onering::{Mesh, Topology};

const NO_ROW: &[&str] = &["MateFace", "HalfEdgeMesh", "WingedEdge"];

/// What `Mesh` holds under these features.
fn holds() -> Vec<Flaw> {
    use Flaw::*;
    let mesh = std::any::type_name::<Mesh>();
    let is_row = !NO_ROW.iter().any(|name| mesh.ends_with(name));
    let any = |features: &[bool]| features.contains(&true);
    let is_incidence = any(&[
        cfg!(feature = "incidence"),
        cfg!(feature = "mate-face"),
        cfg!(feature = "half-edge"),
        cfg!(feature = "winged-edge"),
        cfg!(feature = "adjacency-graph"),
    ]);
    let is_adjacency = cfg!(feature = "adjacency") || is_incidence;
    // What one preset of a union holds, the union holds; a row holds all three or none.
    let holds_all = any(&[
        cfg!(feature = "hold-defects"),
        cfg!(feature = "adjacency-graph"),
        cfg!(feature = "mate-face") && is_row,
        any(&[cfg!(feature = "shared-vertex"), cfg!(feature = "che-l0")]) && is_adjacency,
        cfg!(feature = "che-l1") && is_incidence,
    ]);
    if holds_all {
        vec![NonManifoldEdge, SameDirection, SeveralFans]
    } else if cfg!(feature = "mate-face") {
        vec![SameDirection, SeveralFans]
    } else if is_incidence {
        vec![]
    } else if is_adjacency {
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

/// The laws of each trait, run where one of these features asks for it, and what is on.
macro_rules! traits {
    ($($name:ident: $($feature:literal)+ => $($law:ident)+;)+) => {
        $(#[cfg(any($(feature = $feature),+))]
        #[test]
        fn $name() {
            $(each(laws::$law);)+
        }
        )+

        const TESTED: &[(&str, bool)] = &[("topology", true), $((stringify!($name), cfg!(any($(feature = $feature),+)))),+];
    };
}
traits! {
    adjacency: "adjacency" "mate-face" "half-edge" "winged-edge" "adjacency-graph" => adjacency;
    incidence: "incidence" "mate-face" "half-edge" "winged-edge" "adjacency-graph" => incidence graph;
    edge_map: "edge-map" "winged-edge" => edge_map;
    boundaries: "boundary-curves" => boundaries;
}

/// A preset alone is that structure, byte for byte; with no preset, `Mesh` is shared-vertex. A union has the traits of
/// each, and takes no less than each that is a row.
#[test]
fn presets_are_their_structures() {
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
    let contains = |large: &str, small: &str| match large {
        "che-l2-edge-table" | "che-l3" => small == "che-l2",
        "directed-edges-medium" => small == "directed-edges-small",
        "directed-edges-full" => ["directed-edges-small", "directed-edges-medium"].contains(&small),
        _ => false,
    };
    let is_one =
        on.split_last().is_none_or(|(last, others)| others.iter().all(|other| contains(last, other)));
    let is_column_on = cfg!(feature = "store-next") && !cfg!(feature = "directed-edges-full");
    let base = if on.is_empty() { vec!["shared-vertex"] } else { on };
    base.iter().for_each(|name| is_part(&entry(name)));
    if is_one && !is_column_on {
        let name = base[base.len() - 1];
        assert_eq!(Mesh::BYTES, entry(name).bytes, "{name}");
    }
    assert_eq!(Mesh::vertex_count(&onering::FromFaces::from_faces(7, &[]).unwrap()), 7);
}

fn entry(name: &str) -> Entry {
    *BACKENDS.iter().find(|entry| entry.name == name).unwrap()
}

fn is_part(preset: &Entry) {
    for name in preset.traits {
        assert!(TESTED.contains(&(name, true)), "{}: {name}", preset.name);
    }
    // A hand-written structure gives way to a row with its traits.
    let is_row = !["mate-face", "half-edge", "winged-edge", "adjacency-graph"].contains(&preset.name);
    if is_row {
        let (mesh, part) = (Mesh::BYTES, preset.bytes);
        assert!(mesh.face >= part.face && mesh.vertex >= part.vertex, "{}: {mesh} of {part}", preset.name);
        // Edges are named by a sorted list, 4 E, or by a table over half-edges.
        assert!(mesh.per_triangle() >= part.per_triangle(), "{}: {mesh} of {part}", preset.name);
        assert!(mesh.curve >= part.curve, "{}: {mesh} of {part}", preset.name);
    }
}
