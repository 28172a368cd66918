//! The figures of a whole mesh: by the library, and as the oracle counted them.
use onering::{Adjacency, boundary, components, edges, euler, orientation, umbrella};
use serde_json::Value;

#[derive(Debug, PartialEq, Eq)]
pub struct Figures {
    pub edges: usize,
    pub boundary_edges: usize,
    pub euler: isize,
    pub components: usize,
    pub components_by_vertex: usize,
    pub boundary_loops: Option<usize>,
    pub is_closed: bool,
    pub is_manifold: bool,
    pub is_oriented: bool,
    pub is_orientable: bool,
    pub genus: Option<usize>,
}

impl Figures {
    pub fn of(mesh: &impl Adjacency) -> Self {
        Self {
            edges: edges::edge_count(mesh),
            boundary_edges: boundary::edge_count(mesh),
            euler: euler::euler_characteristic(mesh),
            components: components::components(mesh).count(),
            components_by_vertex: components::components_by_vertex(mesh).count(),
            boundary_loops: boundary::loops(mesh),
            is_closed: euler::is_closed(mesh),
            is_manifold: umbrella::is_manifold(mesh),
            is_oriented: orientation::is_oriented(mesh),
            is_orientable: orientation::is_orientable(mesh),
            genus: euler::genus(mesh),
        }
    }

    /// The `topology` of an entry of the manifest.
    pub fn from_json(figures: &Value) -> Self {
        let optional = |key: &str| figures[key].as_u64().map(|n| n as usize);
        let count = |key: &str| optional(key).unwrap();
        let flag = |key: &str| figures[key].as_bool().unwrap();
        Self {
            edges: count("edges"),
            boundary_edges: count("boundary_edges"),
            euler: figures["euler"].as_i64().unwrap() as isize,
            components: count("components"),
            components_by_vertex: count("components_by_vertex"),
            boundary_loops: optional("boundary_loops"),
            is_closed: flag("closed"),
            is_manifold: flag("manifold"),
            is_oriented: count("inconsistent_edges") == 0,
            is_orientable: flag("orientable"),
            genus: optional("genus"),
        }
    }
}
