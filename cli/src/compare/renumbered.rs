//! Structures that number vertices and faces anew: asked about the same elements, by the maps that come with them.

use super::kernels::Kernels;
use super::measure::{Depth, Measured, Plan};
use super::reference::Sides;
use super::rings::LEVELS;
use super::sample::{STARTS, Sample, Soup};
use crate::heap;
use onering::{BuildError, CompactStars, Footprint, Incidence, Pairing, Renumbering, Sot, memory};

/// The sorted opposite table. Every name of a vertex is looked for around it, and for rings all over again from each start
/// to each level: where one has very many faces, nothing is asked.
pub(crate) fn sot(plan: &Plan<'_>) -> Result<Measured, BuildError> {
    let is_quick = plan.soup.is_quick_to_look_around(STARTS * LEVELS)?;
    let kernels = if is_quick { kernels() } else { Kernels::new() };
    let (mesh, mut measured) = encoded(plan, Sot::encode, Sot::heap_bytes, &kernels)?;
    measured.unmatched = used_vertices(plan.soup)? - mesh.matched_count();
    Ok(measured)
}

/// Stars as differences. What lies opposite is looked for around a vertex: where one has very many faces, that is left
/// out.
pub(crate) fn compact_stars(plan: &Plan<'_>) -> Result<Measured, BuildError> {
    let mut kernels = kernels();
    let looking = ["edge_fan", "opposite", "boundary", "star"];
    if !plan.soup.is_quick_to_look_around(looking.len())? {
        kernels.checks.retain(|(name, _)| !looking.contains(name));
        kernels.face_queries = None;
    }
    let (_, measured) = encoded(plan, CompactStars::encode, CompactStars::heap_bytes, &kernels)?;
    Ok(measured)
}

fn kernels<M: Incidence>() -> Kernels<M> {
    Kernels::new().topology().adjacency().incidence()
}

type Encode<M> = fn(usize, &[[u32; 3]]) -> Result<(M, Renumbering), BuildError>;

/// The structure, and what it answered: that is checked against the list of faces in its own numbers.
fn encoded<M>(
    plan: &Plan<'_>,
    encode: Encode<M>,
    heap_bytes: fn(&M) -> usize,
    kernels: &Kernels<M>,
) -> Result<(M, Measured), BuildError> {
    let Soup { vertex_count, ref faces, .. } = *plan.soup;
    let (encoded, growth) = heap::growth(|| encode(vertex_count, faces));
    let (mesh, maps) = encoded?;
    let (soup, sample) = (renumbered_soup(plan.soup, &maps)?, renumbered_sample(plan.sample, &maps)?);
    // What is kept is the structure without the maps, which a caller may drop once attributes are carried over.
    let counted = growth.kept - heap::freed(maps);
    let mut measured = Measured { counted, peak: growth.peak, ..Measured::default() };
    measured.told = Some(heap_bytes(&mesh));
    if plan.depth.builds() {
        let build = plan.clock.time(|| encode(vertex_count, faces));
        measured.build.push((Pairing::Auto, build));
    }
    measured.ask(&mesh, kernels, &Plan { soup: &soup, sample: &sample, ..*plan })?;
    // Sums of numbers that nobody else has, but for the sizes of rings.
    let is_checked = matches!(plan.depth, Depth::All { .. });
    measured.expected =
        Some(if is_checked { Sides::of(&soup.faces)?.answers(&soup.faces) } else { Vec::new() });
    Ok((mesh, measured))
}

fn renumbered_soup(soup: &Soup, maps: &Renumbering) -> Result<Soup, BuildError> {
    let face = |(&f, &first): (&u32, &u8)| {
        let mut face = soup.faces[f as usize].map(|v| maps.vertex_target[v as usize]);
        face.rotate_left(first.into());
        face
    };
    let faces = memory::collected(maps.face_source.iter().zip(&maps.first_corner).map(face))?;
    Ok(Soup { faces, ..*soup })
}

fn renumbered_sample(sample: &Sample, maps: &Renumbering) -> Result<Sample, BuildError> {
    let mut face_target = memory::filled(maps.face_source.len(), 0)?;
    maps.face_source.iter().zip(0..).for_each(|(&f, target)| face_target[f as usize] = target);
    let carried = |numbers: &[u32], target: &[u32]| numbers.iter().map(|&n| target[n as usize]).collect();
    Ok(Sample {
        starts: carried(&sample.starts, &maps.vertex_target),
        vertices: carried(&sample.vertices, &maps.vertex_target),
        faces: carried(&sample.faces, &face_target),
    })
}

/// How many vertices are in a face.
fn used_vertices(soup: &Soup) -> Result<usize, BuildError> {
    let mut is_used = memory::filled(soup.vertex_count, false)?;
    soup.faces.as_flattened().iter().for_each(|&v| is_used[v as usize] = true);
    Ok(is_used.into_iter().filter(|&used| used).count())
}

#[cfg(test)]
mod tests {
    use super::*;

    /// Vertex 4 is isolated; the square has two vertices on one face only, and two faces for four vertices.
    fn square() -> Soup {
        Soup { vertex_count: 5, faces: vec![[0, 1, 2], [2, 3, 0]], is_clean: true }
    }

    #[test]
    fn matched_vertices_are_among_those_in_faces() {
        let (mesh, _) = Sot::encode(5, &square().faces).unwrap();
        assert_eq!((used_vertices(&square()).unwrap(), mesh.matched_count()), (4, 2));
    }

    #[test]
    fn the_maps_lead_to_the_same_elements() {
        let soup = square();
        let encode = [
            |soup: &Soup| Sot::encode(5, &soup.faces).unwrap().1,
            |soup: &Soup| CompactStars::encode(5, &soup.faces).unwrap().1,
        ];
        encode.iter().for_each(|encode| check(&soup, &encode(&soup)));
    }

    fn check(soup: &Soup, maps: &Renumbering) {
        let renumbered = renumbered_soup(soup, maps).unwrap();
        let sample = Sample { starts: vec![1, 3], vertices: vec![4], faces: vec![0, 1] };
        let carried = renumbered_sample(&sample, maps).unwrap();
        assert!(carried.vertices.iter().eq([&maps.vertex_target[4]]));
        for (old, new) in sample.faces.iter().zip(&carried.faces) {
            let back = renumbered.faces[*new as usize].map(|v| maps.vertex_source[v as usize]);
            let mut face = soup.faces[*old as usize];
            face.rotate_left(maps.first_corner[*new as usize].into());
            assert_eq!(back, face);
        }
    }
}
