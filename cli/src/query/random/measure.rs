//! Takes the time of random queries on one structure.

use super::super::relation::Relation;
use super::sample::Sample;
use crate::on_backend::Work;
use crate::timing::{Clock, Timing};
use onering::{Handle, Incidence, VertexGraph, VertexId, relations};

/// One in so many queries is timed where each is a search of all faces.
pub(crate) const SEARCHED: usize = 100;

/// What to ask, and how often.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Plan<'a> {
    pub(crate) sample: &'a Sample,
    pub(crate) clock: Clock,
    /// Every which query is asked: 1 is all.
    pub(crate) step: usize,
}

/// All queries of one relation.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Asked {
    pub(crate) timing: Timing,
    /// How many elements a query lists, on average.
    pub(crate) results: f64,
}

/// By relation, in their order; `None` is what the structure cannot answer.
pub(crate) type AskedAll = Vec<Option<Asked>>;

/// The number of results, and a sum that they are needed for.
type Total = (usize, usize);

fn total<T>(results: impl IntoIterator<Item = T>, number: impl Fn(T) -> usize) -> Total {
    let add = |(count, sum): Total, result| (count + 1, sum.wrapping_add(number(result)));
    results.into_iter().fold((0, 0), add)
}

fn of<H: Handle>(results: impl IntoIterator<Item = H>) -> Total {
    total(results, Handle::index)
}

impl Plan<'_> {
    fn time<E: Copy>(&self, elements: &[E], ask: impl Fn(E) -> Total) -> Asked {
        let elements: Vec<E> = elements.iter().copied().step_by(self.step).collect();
        let all = || {
            elements.iter().fold((0, 0), |(count, sum): Total, &element| {
                let (c, s) = ask(element);
                (count + c, sum.wrapping_add(s))
            })
        };
        let results = all().0 as f64 / elements.len() as f64;
        Asked { timing: self.clock.time(all).scaled(self.step as f64), results }
    }
}

impl Work for Plan<'_> {
    type Output = AskedAll;

    fn on<M: Incidence>(self, mesh: &M) -> AskedAll {
        let Sample { vertices, sides, faces } = self.sample;
        let vertices: Vec<_> = vertices.iter().map(|&v| M::Vertex::new(v as usize)).collect();
        let face = |f: u32| M::Face::new(f as usize);
        let edges: Vec<_> = sides.iter().map(|&(f, k)| mesh.face_half_edges(face(f))[k]).collect();
        let faces: Vec<_> = faces.iter().map(|&f| face(f)).collect();
        let asked = |relation: &Relation| match relation {
            Relation::VertexVertices => self.time(&vertices, |v| of(relations::vertex_vertices(mesh, v))),
            Relation::VertexEdges => self.time(&vertices, |v| of(relations::vertex_edges(mesh, v))),
            Relation::VertexFaces => self.time(&vertices, |v| of(relations::vertex_faces(mesh, v))),
            Relation::EdgeVertices => self.time(&edges, |h| of(relations::edge_vertices(mesh, h))),
            Relation::EdgeEdges => self.time(&edges, |h| of(relations::edge_edges(mesh, h))),
            Relation::EdgeFaces => self.time(&edges, |h| of(relations::edge_faces(mesh, h))),
            Relation::FaceVertices => self.time(&faces, |f| of(relations::face_vertices(mesh, f))),
            Relation::FaceEdges => self.time(&faces, |f| of(relations::face_edges(mesh, f))),
            Relation::FaceFaces => self.time(&faces, |f| of(relations::face_faces(mesh, f))),
        };
        Relation::all().iter().map(|relation| Some(asked(relation))).collect()
    }
}

impl Plan<'_> {
    /// The six queries of TopTri on its own structure. `faces` are the mesh's, to be asked about by their vertices.
    pub(crate) fn on_graph(self, graph: &VertexGraph, faces: &[[u32; 3]]) -> AskedAll {
        let id = |v: u32| VertexId::new(v as usize);
        let corners = |f: u32| faces[f as usize].map(id);
        let vertices: Vec<_> = self.sample.vertices.iter().map(|&v| id(v)).collect();
        let edges: Vec<_> = self.sample.sides.iter().map(|&(f, k)| (corners(f), k)).collect();
        let edges: Vec<_> = edges.into_iter().map(|(face, k)| [face[k], face[(k + 1) % 3]]).collect();
        let cycles: Vec<_> = self.sample.faces.iter().map(|&f| corners(f)).collect();
        // Of an edge or a cycle the vertex that was found counts, the last.
        let asked = |relation: &Relation| match relation {
            Relation::VertexVertices => Some(self.time(&vertices, |v| of(graph.neighbours(v)))),
            Relation::VertexEdges => {
                Some(self.time(&vertices, |v| total(graph.vertex_edges(v), |[_, u]| u.index())))
            }
            Relation::VertexFaces => {
                Some(self.time(&vertices, |v| total(graph.vertex_faces(v), |[.., u]| u.index())))
            }
            Relation::EdgeEdges => {
                Some(self.time(&edges, |e| total(graph.adjacent_edges(e), |[_, u]| u.index())))
            }
            Relation::EdgeFaces => {
                Some(self.time(&edges, |e| total(graph.edge_faces(e), |[.., u]| u.index())))
            }
            Relation::FaceFaces => {
                Some(self.time(&cycles, |f| total(graph.adjacent_faces(f), |[.., u]| u.index())))
            }
            Relation::EdgeVertices | Relation::FaceVertices | Relation::FaceEdges => None,
        };
        Relation::all().iter().map(asked).collect()
    }
}
