//! A mesh in other orders of its vertices and faces: order matters more than structure.

use super::sample::Soup;
use crate::heap;
use crate::random::Random;
use onering::reorder::{Reordering, morton, reorder, reorder_both};
use onering::{BuildError, FromFaces, Map, Pairing, SharedVertex, Topology, VertexId, memory};

/// As it came.
pub(crate) const GIVEN: &str = "given";
/// Vertices and faces at random.
pub(crate) const SHUFFLED: &str = "shuffled";
/// What was shuffled, put in order again along a Morton curve.
pub(crate) const REORDERED: &str = "reordered";

/// The same triangles in another order.
#[derive(Debug)]
pub(crate) struct Ordered {
    pub(crate) name: &'static str,
    pub(crate) soup: Soup,
}

/// The mesh shuffled, and that reordered; the latter only where all positions are numbers.
pub(crate) fn of(soup: &Soup, positions: &[[f32; 3]], seed: u64) -> Result<Vec<Ordered>, BuildError> {
    let Reordering { faces, vertex_source, .. } = shuffled(&soup.mesh()?, seed)?;
    let positions = memory::collected(vertex_source.iter().map(|&v| positions[v as usize]))?.into();
    let in_order = |name, faces| Ordered { name, soup: Soup { faces, ..*soup } };
    let shuffled = in_order(SHUFFLED, faces);
    let reordered = reordered(&shuffled.soup, &positions)?.map(|faces| in_order(REORDERED, faces));
    Ok([shuffled].into_iter().chain(reordered).collect())
}

/// The strategy that pairing takes of its own accord in each order, the given one first.
pub(crate) fn choices(soup: &Soup, others: &[Ordered]) -> Vec<(String, String)> {
    let choice = |soup: &Soup| Pairing::choose(soup.vertex_count, &soup.faces).to_string();
    let others = others.iter().map(|other| (other.name.to_owned(), choice(&other.soup)));
    std::iter::once((GIVEN.to_owned(), choice(soup))).chain(others).collect()
}

fn shuffled(mesh: &SharedVertex, seed: u64) -> Result<Reordering, BuildError> {
    let mut random = Random(seed);
    let vertices = random.permutation(mesh.vertex_count())?;
    let faces = random.permutation(mesh.face_count())?;
    // Places and sources of both, and the faces.
    heap::has_room(8 * (mesh.vertex_count() + mesh.face_count()) + 12 * mesh.face_count())?;
    Ok(reorder_both(mesh, &vertices, &faces))
}

/// The faces along the curve; `None` where some position is no number.
fn reordered(soup: &Soup, positions: &Map<VertexId, [f32; 3]>) -> Result<Option<Vec<[u32; 3]>>, BuildError> {
    // Keys with their vertices, twice to be sorted, and some counters; then the order.
    heap::has_room(36 * positions.len() + (1 << 16))?;
    let Ok(order) = morton(positions) else { return Ok(None) };
    let mesh = soup.mesh()?;
    // Places, starts and sources; faces, first under the new numbers, then in their order; and their sources.
    heap::has_room(12 * (mesh.vertex_count() + 1) + (12 + 12 + 4) * mesh.face_count())?;
    Ok(Some(reorder(&mesh, &order).faces))
}

impl Soup {
    fn mesh(&self) -> Result<SharedVertex, BuildError> {
        SharedVertex::from_faces(self.vertex_count, &self.faces)
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::default_mesh;

    #[test]
    fn shuffling_is_for_one_strategy_and_reordering_for_the_other() {
        let [_, _, (_, made)] = default_mesh::all();
        let soup = Soup { vertex_count: made.positions.len(), faces: made.faces, is_clean: true };
        let others = of(&soup, &made.positions, 5).unwrap();
        assert_eq!([SHUFFLED, REORDERED], [0, 1].map(|i| others[i].name));
        let choices = choices(&soup, &others);
        assert_eq!([0, 1, 2].map(|i| choices[i].1.as_str()), ["chain", "partition", "chain"]);
    }

    #[test]
    fn each_order_has_the_same_mesh() {
        let soup = Soup { vertex_count: 5, faces: vec![[0, 1, 2], [0, 2, 3], [2, 1, 4]], is_clean: true };
        let positions = [[0.0, 0.0, 0.0], [1.0, 0.0, 0.0], [1.0, 1.0, 0.0], [0.0, 1.0, 0.0], [2.0, 0.0, 0.0]];
        let degrees = |soup: &Soup| {
            let mut degrees = [0; 5];
            soup.faces.as_flattened().iter().for_each(|&v| degrees[v as usize] += 1);
            degrees.sort_unstable();
            degrees
        };
        let others = of(&soup, &positions, 7).unwrap();
        assert!(others.len() == 2 && others.iter().all(|other| degrees(&other.soup) == degrees(&soup)));
        let without_place = [[f32::NAN; 3]; 5];
        assert_eq!(of(&soup, &without_place, 7).unwrap().len(), 1);
    }
}
