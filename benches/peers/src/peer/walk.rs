//! What is asked of every structure that can be walked from a vertex: one-rings and 4-rings.

use super::Structure;
use crate::mesh::mixed;

/// How many rings around a vertex are searched.
pub(super) const LEVELS: usize = 4;

/// A structure that gives the neighbours of a vertex.
pub(super) trait Walk: Structure {
    /// The library's own handle.
    type Vertex: Copy;

    /// All that there are.
    fn vertices(&self) -> impl Iterator<Item = Self::Vertex>;

    /// Its number in the arrays.
    fn index(v: Self::Vertex) -> u32;

    /// Calls `visit` with every neighbour of `v`, in the fastest way that the library has.
    fn ring(&self, v: Self::Vertex, visit: impl FnMut(Self::Vertex));

    /// The one-rings of all vertices, as one sum.
    fn sweep(&self) -> u64 {
        let mut sum = 0_u64;
        for v in self.vertices() {
            let number = Self::index(v);
            self.ring(v, |u| sum = sum.wrapping_add(mixed(number, Self::index(u))));
        }
        sum
    }

    /// The handle of each vertex; not timed.
    fn by_index(&self, vertex_count: usize) -> Vec<Option<Self::Vertex>> {
        let mut vertices = vec![None; vertex_count];
        self.vertices().for_each(|v| vertices[Self::index(v) as usize] = Some(v));
        vertices
    }

    /// The vertices within four edges of each of `queries`, as one sum. No library but onering has a function for it:
    /// this searches level by level, with the number of the last search at each vertex that it reached.
    fn four_rings(&self, vertices: &[Option<Self::Vertex>], queries: &[u32]) -> u64 {
        let mut stamps = vec![0_u32; vertices.len()];
        let mut reached = Vec::new();
        let mut sum = 0_u64;
        for (&query, search) in queries.iter().zip(1..) {
            let Some(centre) = vertices[query as usize] else { continue };
            stamps[query as usize] = search;
            reached.clear();
            reached.push(centre);
            let mut level = 0..1;
            for _ in 0..LEVELS {
                for i in level.clone() {
                    let v = reached[i];
                    self.ring(v, |u| {
                        let stamp = &mut stamps[Self::index(u) as usize];
                        if *stamp != search {
                            *stamp = search;
                            reached.push(u);
                        }
                    });
                }
                level = level.end..reached.len();
            }
            for &u in &reached[1..] {
                sum = sum.wrapping_add(mixed(query, Self::index(u)));
            }
        }
        sum
    }
}
