//! Every real mesh that is read: its defects are those that an independent program counted; after repair it is
//! manifold, with all area accounted for, and every backend takes it.
#[path = "common/real.rs"]
mod real;

use onering::defects::Defects;
use onering::neighbours::Neighbours;
use onering::repair::{RepairOptions, Repaired, repair, weld};
use onering::*;
use real::{MESHES, Real};
use serde_json::Value;
use std::collections::{BTreeMap, HashMap};
use std::sync::LazyLock;

#[test]
fn defects_are_those_of_the_manifest() {
    for Real { name, mesh, figures } in &*MESHES {
        compare(name, &Defects::of(mesh.positions.len(), &mesh.faces).unwrap(), &figures["topology"]);
        let welded = weld(&mesh.positions).unwrap();
        if figures["welded"].is_object() {
            let faces: Vec<_> =
                mesh.faces.iter().map(|face| face.map(|v| welded.target[v as usize])).collect();
            compare(name, &Defects::of(welded.source.len(), &faces).unwrap(), &figures["welded"]);
        } else {
            assert_eq!(welded.source.len(), mesh.positions.len(), "{name}: no two vertices share a position");
        }
    }
}

/// Every figure of the manifest must be there, and equal.
fn compare(name: &str, defects: &Defects, expected: &Value) {
    let found: BTreeMap<_, _> =
        defects.figures().map(|(figure, value)| (figure, value.to_string())).collect();
    for (figure, value) in expected.as_object().unwrap().iter().filter(|(figure, _)| *figure != "vertices") {
        assert_eq!(found.get(figure.as_str()), Some(&value.to_string()), "{name}: {figure}");
    }
}

/// A real mesh after repair: as it came, or welded before.
struct Mended {
    name: String,
    of: &'static Real,
    repaired: Repaired,
    /// By corner, the corner of the half-edge that runs back.
    opposite: Vec<Option<usize>>,
}

/// Every mesh as it came, and where that differs, welded.
static MENDED: LazyLock<Vec<Mended>> = LazyLock::new(|| {
    let ways = |real| [Some(Mended::new(real, false)), has_welds(real).then(|| Mended::new(real, true))];
    MESHES.iter().flat_map(ways).flatten().collect()
});

fn has_welds(real: &Real) -> bool {
    real.figures["welded"].is_object()
}

impl Mended {
    fn new(of: &'static Real, is_welded: bool) -> Self {
        let positions = &of.mesh.positions;
        let options = RepairOptions { weld: is_welded.then_some(&positions[..]) };
        let repaired = repair(positions.len(), &of.mesh.faces, &options).unwrap();
        let name = if is_welded { format!("{}, welded", of.name) } else { of.name.clone() };
        println!("{name}: {repaired}");
        let opposite = opposites(&name, &repaired.faces);
        Self { name, of, repaired, opposite }
    }

    fn build<M: FromFaces>(&self) -> M {
        let Repaired { vertex_count, faces, .. } = &self.repaired;
        M::from_faces(*vertex_count, faces).unwrap_or_else(|error| panic!("{}: {error}", self.name))
    }

    fn edge_count(&self) -> usize {
        let is_first = |c: usize| self.opposite[c].is_none_or(|o| c < o);
        (0..self.opposite.len()).filter(|&c| is_first(c)).count()
    }
}

/// By a dictionary of all sides. No two faces may have a side in the same direction.
fn opposites(name: &str, faces: &[[u32; 3]]) -> Vec<Option<usize>> {
    let sides = || faces.iter().flat_map(|&[a, b, c]| [[a, b], [b, c], [c, a]]);
    let corners: HashMap<_, _> = sides().zip(0..).collect();
    assert_eq!(corners.len(), 3 * faces.len(), "{name}: a side is there twice");
    sides().map(|[a, b]| corners.get(&[b, a]).copied()).collect()
}

#[test]
fn repaired_meshes_are_manifold_with_all_area_accounted_for() {
    for Mended { name, of, repaired, .. } in &*MENDED {
        let after = Defects::of(repaired.vertex_count, &repaired.faces).unwrap();
        assert!(after.manifold && after.is_clean() && after.duplicate_faces == 0, "{name}: {after}");
        let mesh = &of.mesh;
        let dropped = &repaired.dropped;
        assert_eq!(repaired.faces.len() + dropped.count(), mesh.faces.len(), "{name}");
        let gone = [&dropped.out_of_range, &dropped.degenerate, &dropped.duplicate].into_iter().flatten();
        let gone = area(&mesh.positions, gone.map(|&f| &mesh.faces[f as usize]));
        let kept = area(&repaired.carry_vertices(&mesh.positions), &repaired.faces);
        let total = area(&mesh.positions, &mesh.faces);
        assert!(close(kept + gone, total, 1e-9), "{name}: area {kept} + {gone} dropped, of {total}");
        // The manifest has the file's decimals in 64 bits, where the reader rounds to 32.
        assert!(close(total, of.figures["area"].as_f64().unwrap(), 1e-5), "{name}: area {total}");
    }
}

fn area<'a>(positions: &[[f32; 3]], faces: impl IntoIterator<Item = &'a [u32; 3]>) -> f64 {
    faces.into_iter().map(|face| triangle_area(face.map(|v| positions[v as usize].map(f64::from)))).sum()
}

fn triangle_area([a, b, c]: [[f64; 3]; 3]) -> f64 {
    let to = |p: [f64; 3]| [p[0] - a[0], p[1] - a[1], p[2] - a[2]];
    let (u, v) = (to(b), to(c));
    let cross = [u[1] * v[2] - u[2] * v[1], u[2] * v[0] - u[0] * v[2], u[0] * v[1] - u[1] * v[0]];
    cross.map(|x| x * x).iter().sum::<f64>().sqrt() / 2.0
}

fn close(a: f64, b: f64, tolerance: f64) -> bool {
    (a - b).abs() <= tolerance * a.abs().max(b.abs())
}

/// Laws in linear time; those of the conformance suite compare every half-edge with every other.
mod laws {
    use super::*;

    pub(super) fn topology<M: Topology>(mesh: &M, case: &Mended) {
        assert_eq!(mesh.vertex_count(), case.repaired.vertex_count, "{}", case.name);
        assert_eq!(mesh.to_faces(), case.repaired.faces, "{}", case.name);
    }

    pub(super) fn adjacency<M: Adjacency>(mesh: &M, case: &Mended) {
        let sides: Vec<_> = mesh.faces().flat_map(|f| mesh.face_half_edges(f)).collect();
        for (&h, opposite) in sides.iter().zip(&case.opposite) {
            assert_eq!(mesh.opposite(h), opposite.map(|c| sides[c]), "{} {h:?}", case.name);
            assert_eq!(mesh.is_boundary(h), opposite.is_none(), "{} {h:?}", case.name);
        }
    }

    /// Every vertex has one fan, which starts at the boundary if there is one; all fans together are all half-edges.
    pub(super) fn incidence<M: Incidence>(mesh: &M, case: &Mended) {
        let mut seen = Map::filled(mesh.half_edge_bound(), false);
        for v in mesh.vertices() {
            let at = || format!("{} {v:?}", case.name);
            let (mut faces, mut open) = (0, 0);
            for h in mesh.star(v) {
                assert!(mesh.origin(h) == v && !std::mem::replace(&mut seen[h], true), "{} {h:?}", at());
                (faces, open) = (faces + 1, open + usize::from(mesh.is_boundary(h)));
            }
            assert!(open <= 1 && mesh.fans(v).count() == faces.min(1), "{}: one fan", at());
            assert_eq!(mesh.outgoing(v).is_some_and(|h| mesh.is_boundary(h)), open == 1, "{}", at());
            assert_eq!(mesh.one_ring(v).count(), faces + open, "{}: the ring", at());
        }
        assert!(mesh.half_edges().all(|h| seen[h]), "{}", case.name);
        graph(mesh, case);
    }

    pub(super) fn graph<M: Neighbours>(mesh: &M, case: &Mended) {
        let degrees: usize = (0..mesh.node_count()).map(|v| mesh.neighbours(M::Node::new(v)).count()).sum();
        assert_eq!(degrees, 2 * case.edge_count(), "{}", case.name);
    }

    pub(super) fn edge_map<M: EdgeMap>(mesh: &M, case: &Mended) {
        assert_eq!(mesh.edge_count(), case.edge_count(), "{}", case.name);
        for e in mesh.edges() {
            let h = mesh.half_edge(e);
            let opposite = mesh.opposite(h).unwrap_or(h);
            assert_eq!([h, opposite].map(|h| mesh.edge(h)), [e; 2], "{} {h:?}", case.name);
        }
    }

    pub(super) fn boundaries<M: Boundaries>(mesh: &M, case: &Mended) {
        let mut on_curves = 0;
        for c in mesh.curves() {
            let curve: Vec<_> = mesh.curve(c).collect();
            assert!(
                curve.iter().all(|&h| mesh.is_boundary(h) && mesh.curve_of(h) == Some(c)),
                "{}",
                case.name
            );
            let follows = |(&h, &g)| mesh.target(h) == mesh.origin(g);
            assert!(curve.iter().zip(curve.iter().cycle().skip(1)).all(follows), "{} {c:?}", case.name);
            on_curves += curve.len();
        }
        assert_eq!(on_curves, case.opposite.iter().filter(|o| o.is_none()).count(), "{}", case.name);
    }
}

macro_rules! takes_every_repaired_mesh {
    ($($name:ident $text:literal $mesh:ty [$($has:ident)*] [$($holds:ident)*];)+) => {$(
        #[test]
        fn $name() {
            for case in &*MENDED {
                let mesh: $mesh = case.build();
                $(laws::$has(&mesh, case);)*
            }
        }
    )+};
}
onering::with_backends!(takes_every_repaired_mesh);
