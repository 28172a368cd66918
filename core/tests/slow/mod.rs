//! The figures once more, by dictionaries and searches: slow, and nothing shared with what is tested.

use onering_core::defects::Figure;
use std::collections::{BTreeMap, BTreeSet, HashSet};

type Figures = BTreeMap<&'static str, Figure>;
type Edge = [u32; 2];

fn sorted<const N: usize>(mut x: [u32; N]) -> [u32; N] {
    x.sort();
    x
}

fn sides(face: [u32; 3]) -> [Edge; 3] {
    let [a, b, c] = face;
    [[a, b], [b, c], [c, a]]
}

/// How many components: repeated flooding from any node that is left.
fn components<T: Ord + Clone>(nodes: impl IntoIterator<Item = T>, near: impl Fn(&T) -> Vec<T>) -> usize {
    let mut left: BTreeSet<T> = nodes.into_iter().collect();
    let mut count = 0;
    while let Some(start) = left.pop_first() {
        count += 1;
        let mut stack = vec![start];
        while let Some(node) = stack.pop() {
            stack.extend(near(&node).into_iter().filter(|next| left.remove(next)));
        }
    }
    count
}

/// All figures of [`onering_core::defects::Defects`], from their definitions.
pub(crate) fn figures(vertex_count: usize, faces: &[[u32; 3]]) -> Figures {
    let mut r = Figures::new();
    let in_range: Vec<_> = faces.iter().filter(|f| f.iter().all(|&v| (v as usize) < vertex_count)).collect();
    let t: Vec<[u32; 3]> =
        in_range.iter().filter(|f| f.iter().collect::<HashSet<_>>().len() == 3).map(|&&f| f).collect();
    r.insert("out_of_range_faces", (faces.len() - in_range.len()).into());
    r.insert("degenerate_faces", (in_range.len() - t.len()).into());
    duplicates(&t, &mut r);
    let mut edges: BTreeMap<Edge, Vec<(usize, Edge)>> = BTreeMap::new();
    let mut stars: BTreeMap<u32, Vec<usize>> = BTreeMap::new();
    for (f, &face) in t.iter().enumerate() {
        for side in sides(face) {
            edges.entry(sorted(side)).or_default().push((f, side));
            stars.entry(side[0]).or_default().push(f);
        }
    }
    edge_figures(&edges, &mut r);
    link_figures(&t, &stars, &edges, &mut r);
    orientation(&t, &edges, &mut r);
    let count = |n: usize| n as i64;
    r.insert("isolated_vertices", (vertex_count - stars.len()).into());
    let euler = count(stars.len()) - count(edges.len()) + count(t.len());
    r.insert("euler", euler.into());
    let by_edge =
        |&f: &usize| sides(t[f]).iter().flat_map(|&s| edges[&sorted(s)].iter().map(|x| x.0)).collect();
    let by_vertex = |&f: &usize| t[f].iter().flat_map(|v| stars[v].clone()).collect();
    let whole = components(0..t.len(), by_edge);
    r.insert("components", whole.into());
    r.insert("components_by_vertex", components(0..t.len(), by_vertex).into());
    r.insert("closed", (!t.is_empty() && r["boundary_edges"] == Figure::Count(0)).into());
    let sound = r["manifold"] == Figure::Flag(true) && r["orientable"] == Figure::Flag(true) && !t.is_empty();
    let genus = match r["boundary_loops"] {
        Figure::Count(loops) if sound => Figure::Count((2 * whole as i128 - loops - i128::from(euler)) / 2),
        _ => Figure::Undefined,
    };
    r.insert("genus", genus);
    r
}

fn duplicates(t: &[[u32; 3]], r: &mut Figures) {
    let (mut sets, mut cycles) = (HashSet::new(), HashSet::new());
    let extra = t.iter().filter(|&&face| !sets.insert(sorted(face))).count();
    let cycle = |[a, b, c]: [u32; 3]| [[a, b, c], [b, c, a], [c, a, b]].into_iter().min();
    let same = t.iter().filter(|&&face| !cycles.insert(cycle(face))).count();
    r.insert("duplicate_faces", extra.into());
    r.insert("duplicate_faces_same_orientation", same.into());
}

fn edge_figures(edges: &BTreeMap<Edge, Vec<(usize, Edge)>>, r: &mut Figures) {
    let with = |wanted: &dyn Fn(usize) -> bool| edges.values().filter(|s| wanted(s.len())).count();
    r.insert("edges", edges.len().into());
    r.insert("boundary_edges", with(&|n| n == 1).into());
    r.insert("nonmanifold_edges", with(&|n| n > 2).into());
    r.insert("max_faces_per_edge", edges.values().map(Vec::len).max().unwrap_or(0).into());
    let inconsistent = edges.values().filter(|s| s.len() == 2 && s[0].1 == s[1].1).count();
    r.insert("inconsistent_edges", inconsistent.into());
    let mut directed: BTreeMap<Edge, usize> = BTreeMap::new();
    edges.values().flatten().for_each(|&(_, side)| *directed.entry(side).or_default() += 1);
    r.insert("repeated_halfedges", directed.values().filter(|&&n| n > 1).count().into());
    let mut degree: BTreeMap<u32, usize> = BTreeMap::new();
    edges.keys().flatten().for_each(|&v| *degree.entry(v).or_default() += 1);
    r.insert("valence_min", degree.values().min().copied().unwrap_or(0).into());
    r.insert("valence_max", degree.values().max().copied().unwrap_or(0).into());
    let boundary: Vec<Edge> = edges.iter().filter(|(_, s)| s.len() == 1).map(|(&e, _)| e).collect();
    let touching = |e: &Edge| boundary.iter().filter(|b| b.iter().any(|v| e.contains(v))).copied().collect();
    r.insert("boundary_components", components(boundary.clone(), touching).into());
}

/// Goes by the link of every vertex: the graph of the edges across from it.
fn link_figures(
    t: &[[u32; 3]],
    stars: &BTreeMap<u32, Vec<usize>>,
    edges: &BTreeMap<Edge, Vec<(usize, Edge)>>,
    r: &mut Figures,
) {
    let (mut bowties, mut nonmanifold, mut clear) = (0usize, 0usize, true);
    let mut follows: BTreeMap<Edge, Vec<Edge>> = BTreeMap::new();
    for (&v, star) in stars {
        let mut link: BTreeMap<u32, Vec<u32>> = BTreeMap::new();
        for &f in star {
            let [a, b] = [0, 1, 2].map(|k| t[f][k]).into_iter().filter(|&x| x != v).collect::<Vec<_>>()[..]
            else {
                unreachable!("a proper triangle at v has two other vertices")
            };
            link.entry(a).or_default().push(b);
            link.entry(b).or_default().push(a);
        }
        let fans = components(link.keys().copied(), |x| link[x].clone());
        bowties += usize::from(fans > 1);
        nonmanifold += usize::from(fans > 1 || link.values().any(|n| n.len() > 2));
        while let Some((&start, _)) = link.first_key_value() {
            let (mut stack, mut leaves) = (vec![start], vec![]);
            while let Some(x) = stack.pop() {
                let Some(near) = link.remove(&x) else { continue };
                leaves.extend((near.len() == 1).then_some(sorted([v, x])));
                stack.extend(near);
            }
            clear &= leaves.is_empty() || leaves.len() == 2;
            if let [a, b] = leaves[..] {
                follows.entry(a).or_default().push(b);
                follows.entry(b).or_default().push(a);
            }
        }
    }
    let boundary = edges.iter().filter(|(_, s)| s.len() == 1).map(|(&e, _)| e);
    let loops = clear.then(|| components(boundary, |e| follows[e].clone()));
    r.insert("bowtie_vertices", bowties.into());
    r.insert("nonmanifold_vertices", nonmanifold.into());
    r.insert("manifold", (nonmanifold == 0).into());
    r.insert("boundary_loops", loops.into());
    r.insert("max_faces_per_vertex", stars.values().map(Vec::len).max().unwrap_or(0).into());
}

/// Floods each patch with signs.
fn orientation(t: &[[u32; 3]], edges: &BTreeMap<Edge, Vec<(usize, Edge)>>, r: &mut Figures) {
    let mut sign: Vec<Option<bool>> = vec![None; t.len()];
    let (mut patches, mut torn, mut flips) = (0usize, 0usize, 0usize);
    for start in 0..t.len() {
        if sign[start].is_some() {
            continue;
        }
        sign[start] = Some(false);
        let (mut stack, mut signs, mut sound) = (vec![(start, false)], [0, 0], true);
        while let Some((f, s)) = stack.pop() {
            signs[usize::from(s)] += 1;
            for side in sides(t[f]) {
                let [x, y] = edges[&sorted(side)][..] else { continue };
                let (g, wanted) = (if x.0 == f { y.0 } else { x.0 }, s ^ (x.1 == y.1));
                match sign[g] {
                    Some(is) => sound &= is == wanted,
                    None => {
                        sign[g] = Some(wanted);
                        stack.push((g, wanted));
                    }
                }
            }
        }
        patches += 1;
        torn += usize::from(!sound);
        flips += if sound { signs[0].min(signs[1]) } else { 0 };
    }
    r.insert("patches", patches.into());
    r.insert("nonorientable_patches", torn.into());
    r.insert("orientable", (torn == 0).into());
    r.insert("min_flips", flips.into());
}
