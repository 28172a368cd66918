//! What a comparison found, in the shape of its JSON.

use crate::machine::Machine;
use crate::timing::Timing;
use serde::ser::{Serialize, SerializeMap, Serializer};

/// A whole run.
#[derive(Debug, serde::Serialize)]
pub(crate) struct Run {
    pub(crate) version: &'static str,
    /// What was said at the shell.
    pub(crate) command: String,
    /// When it began, in UTC.
    pub(crate) date: String,
    pub(crate) machine: Machine,
    pub(crate) settings: Settings,
    /// How to read the figures.
    pub(crate) notes: &'static [&'static str],
    pub(crate) meshes: Vec<Mesh>,
    /// Meshes of growing size, where a page is written.
    pub(crate) growth: Option<Growth>,
    pub(crate) unread: Vec<Unread>,
}

#[derive(Debug, serde::Serialize)]
pub(crate) struct Settings {
    pub(crate) seed: u64,
    pub(crate) budget_ms: u64,
    pub(crate) quadratic_up_to_triangles: usize,
    pub(crate) ring_starts: usize,
    pub(crate) random_queries: usize,
}

/// A file that could not be read.
#[derive(Debug, serde::Serialize)]
pub(crate) struct Unread {
    pub(crate) file: String,
    pub(crate) error: String,
}

/// One mesh, and every backend on it.
#[derive(Debug, serde::Serialize)]
pub(crate) struct Mesh {
    pub(crate) name: String,
    pub(crate) vertices: usize,
    pub(crate) triangles: usize,
    pub(crate) edges: usize,
    /// Where rings start.
    pub(crate) random_vertices: Vec<u32>,
    /// What some backends cannot hold.
    pub(crate) defects: String,
    /// How half-edges are paired where nobody chooses, by the order of vertices and faces.
    pub(crate) auto_pairing: Named<String>,
    /// What was done to the mesh for those, and what it became.
    pub(crate) repair: Option<Repair>,
    pub(crate) backends: Vec<Backend>,
    /// Answers that differ. Empty, or a structure is wrong.
    pub(crate) mismatches: Vec<String>,
}

#[derive(Clone, Debug, serde::Serialize)]
pub(crate) struct Repair {
    pub(crate) steps: String,
    pub(crate) vertices: usize,
    pub(crate) triangles: usize,
    pub(crate) edges: usize,
    pub(crate) auto_pairing: Named<String>,
    /// Where rings start on the mesh that it became, whose vertices have other numbers.
    pub(crate) random_vertices: Vec<u32>,
}

/// One backend on one mesh. `null` is what it cannot answer, or what would take too long.
#[derive(Debug, serde::Serialize)]
pub(crate) struct Backend {
    pub(crate) name: &'static str,
    pub(crate) traits: &'static [&'static str],
    pub(crate) holds: &'static [&'static str],
    /// `as it is`, `repaired`, or `not built`.
    pub(crate) mesh: &'static str,
    /// Why it could not hold the mesh as it is.
    pub(crate) refusal: Option<String>,
    pub(crate) memory: Option<Memory>,
    pub(crate) build: Named<Option<Timing>>,
    pub(crate) rings: Vec<Ring>,
    pub(crate) sweep: Option<Sweep>,
    /// Of all queries together.
    pub(crate) random_vertex_queries: Option<Timing>,
    pub(crate) random_face_queries: Option<Timing>,
    /// Building and sweeping where vertices and faces come in another order; `null` where there is none.
    pub(crate) orders: Named<Option<InOrder>>,
    /// Sums over answers, in hexadecimal.
    pub(crate) checksums: Named<String>,
}

#[derive(Debug, serde::Serialize)]
pub(crate) struct Memory {
    /// In V, E, T, B and words of records.
    pub(crate) formula: String,
    /// `null` where the order of vertices matters as well.
    pub(crate) formula_bytes: Option<usize>,
    pub(crate) counted_bytes: usize,
    pub(crate) peak_bytes: usize,
    pub(crate) formula_bytes_per_triangle: Option<f64>,
    pub(crate) counted_bytes_per_triangle: f64,
    pub(crate) peak_bytes_per_triangle: f64,
}

/// All rings of one level.
#[derive(Debug, serde::Serialize)]
pub(crate) struct Ring {
    pub(crate) level: usize,
    /// Vertices within so many edges, the first one left out, on average over the random vertices.
    pub(crate) vertices: f64,
    /// For the ring of one vertex with all levels up to this one.
    #[serde(flatten)]
    pub(crate) timing: Timing,
}

#[derive(Clone, Copy, Debug, serde::Serialize)]
pub(crate) struct Sweep {
    pub(crate) ns_per_vertex: f64,
    pub(crate) timing: Timing,
}

/// The mesh in another order.
#[derive(Clone, Copy, Debug, serde::Serialize)]
pub(crate) struct InOrder {
    /// With the pairing that the library takes of its own accord.
    pub(crate) build: Timing,
    pub(crate) sweep: Option<Sweep>,
}

/// Building and sweeping spheres of growing size.
#[derive(Debug, serde::Serialize)]
pub(crate) struct Growth {
    pub(crate) mesh: &'static str,
    pub(crate) triangles: Vec<usize>,
    pub(crate) backends: Vec<Grown>,
}

/// One backend, a point for each size.
#[derive(Debug, serde::Serialize)]
pub(crate) struct Grown {
    pub(crate) name: &'static str,
    pub(crate) points: Vec<InOrder>,
}

/// A map in the order of its list.
#[derive(Clone, Debug)]
pub(crate) struct Named<T>(pub(crate) Vec<(String, T)>);

impl<T> Named<Option<T>> {
    /// Puts a value in its place, where there is a place of this name.
    pub(crate) fn set(&mut self, name: &str, value: T) {
        if let Some((_, place)) = self.0.iter_mut().find(|(known, _)| known == name) {
            *place = Some(value);
        }
    }
}

impl<T: Serialize> Serialize for Named<T> {
    fn serialize<S: Serializer>(&self, serializer: S) -> Result<S::Ok, S::Error> {
        let mut map = serializer.serialize_map(Some(self.0.len()))?;
        self.0.iter().try_for_each(|(name, value)| map.serialize_entry(name, value))?;
        map.end()
    }
}
