//! Structures that number vertices and faces anew: asked about the same elements, by the maps that come with them.

use super::kernels::Kernels;
use super::measure::{Depth, Measured, Plan};
use super::reference::Sides;
use super::sample::{Sample, Soup};
use crate::heap;

use onering::{BuildError, Footprint, Pairing, Renumbering, Sot};

/// The sorted opposite table. Its answers are checked against the list of faces in its own numbers.
pub(crate) fn sot(plan: &Plan<'_>) -> Result<Measured, BuildError> {
    let Soup { vertex_count, ref faces, .. } = *plan.soup;
    // What is kept is the table without the maps, which a caller may drop once attributes are carried over.
    let (mesh, growth) = heap::growth(|| Sot::encode(vertex_count, faces).map(|(mesh, _)| mesh));
    let mesh = mesh?;
    let (_, maps) = Sot::encode(vertex_count, faces)?;
    let (soup, sample) = (renumbered_soup(plan.soup, &maps), renumbered_sample(plan.sample, &maps));
    let mut measured = Measured { counted: growth.kept, peak: growth.peak, ..Measured::default() };
    measured.told = Some(mesh.heap_bytes());
    measured.unmatched = used_vertices(&soup) - mesh.matched_count();
    let build = plan.clock.time(|| Sot::encode(vertex_count, faces));
    measured.build.push((Pairing::Auto, build));
    let kernels = Kernels::new().topology().adjacency().incidence();
    measured.ask(&mesh, &kernels, &Plan { soup: &soup, sample: &sample, ..*plan });
    // Sums of numbers that nobody else has, but for the sizes of rings.
    let is_checked = matches!(plan.depth, Depth::All { .. });
    measured.expected =
        Some(if is_checked { Sides::of(&soup.faces).answers(&soup.faces) } else { Vec::new() });
    Ok(measured)
}

fn renumbered_soup(soup: &Soup, maps: &Renumbering) -> Soup {
    let face = |(&f, &first): (&u32, &u8)| {
        let mut face = soup.faces[f as usize].map(|v| maps.vertex_target[v as usize]);
        face.rotate_left(first.into());
        face
    };
    Soup { faces: maps.face_source.iter().zip(&maps.first_corner).map(face).collect(), ..*soup }
}

fn renumbered_sample(sample: &Sample, maps: &Renumbering) -> Sample {
    let mut face_target = vec![0; maps.face_source.len()];
    maps.face_source.iter().zip(0..).for_each(|(&f, target)| face_target[f as usize] = target);
    let carried = |numbers: &[u32], target: &[u32]| numbers.iter().map(|&n| target[n as usize]).collect();
    Sample {
        starts: carried(&sample.starts, &maps.vertex_target),
        vertices: carried(&sample.vertices, &maps.vertex_target),
        faces: carried(&sample.faces, &face_target),
    }
}

/// How many vertices are in a face.
fn used_vertices(soup: &Soup) -> usize {
    let mut is_used = vec![false; soup.vertex_count];
    soup.faces.as_flattened().iter().for_each(|&v| is_used[v as usize] = true);
    is_used.into_iter().filter(|&used| used).count()
}

#[cfg(test)]
mod tests {
    use super::*;

    /// Vertex 4 is isolated; the square has two vertices on one face only, and two faces for four vertices.
    #[test]
    fn the_maps_lead_to_the_same_elements() {
        let soup = Soup { vertex_count: 5, faces: vec![[0, 1, 2], [2, 3, 0]], is_clean: true };
        let (mesh, maps) = Sot::encode(5, &soup.faces).unwrap();
        let renumbered = renumbered_soup(&soup, &maps);
        assert_eq!((used_vertices(&soup), used_vertices(&renumbered), mesh.matched_count()), (4, 4, 2));
        let sample = Sample { starts: vec![1, 3], vertices: vec![4], faces: vec![0, 1] };
        let carried = renumbered_sample(&sample, &maps);
        assert_eq!(carried.vertices, [4]);
        for (old, new) in sample.faces.iter().zip(&carried.faces) {
            let back = renumbered.faces[*new as usize].map(|v| maps.vertex_source[v as usize]);
            let mut face = soup.faces[*old as usize];
            face.rotate_left(maps.first_corner[*new as usize].into());
            assert_eq!(back, face);
        }
    }
}
