//! What a structure answers.

use super::element::Element;
use super::relation::Relation;
use crate::on_backend::Work;
use onering::{Handle, Incidence, Topology, VertexGraph, VertexId, relations};

/// A relation to ask for of several elements, each of the kind that the relation is of, and in the mesh.
#[derive(Debug)]
pub(crate) struct Ask<'a> {
    pub(crate) relation: Relation,
    pub(crate) of: &'a [Element],
}

impl Work for Ask<'_> {
    type Output = Vec<Vec<Element>>;

    fn on<M: Incidence>(self, mesh: &M) -> Self::Output {
        self.of.iter().map(|&element| on_mesh(mesh, self.relation, element)).collect()
    }
}

fn vertex<V: Handle>(v: V) -> Element {
    Element::Vertex(v.index() as u32)
}

fn face<F: Handle>(f: F) -> Element {
    Element::Face(f.index() as u32)
}

fn edge<M: Topology>(mesh: &M, h: M::HalfEdge) -> Element {
    Element::edge(relations::edge_vertices(mesh, h).map(|v| v.index() as u32))
}

fn on_mesh<M: Incidence>(mesh: &M, relation: Relation, element: Element) -> Vec<Element> {
    match element {
        Element::Vertex(v) => of_vertex(mesh, relation, M::Vertex::new(v as usize)),
        Element::Face(f) => of_face(mesh, relation, M::Face::new(f as usize)),
        Element::Edge([a, _]) => {
            let mut at_end = relations::vertex_edges(mesh, M::Vertex::new(a as usize));
            let along = at_end.find(|&h| edge(mesh, h) == element);
            along.map_or(Vec::new(), |h| of_edge(mesh, relation, h))
        }
        Element::Cycle(_) => Vec::new(),
    }
}

fn of_vertex<M: Incidence>(mesh: &M, relation: Relation, v: M::Vertex) -> Vec<Element> {
    match relation {
        Relation::VertexVertices => relations::vertex_vertices(mesh, v).map(vertex).collect(),
        Relation::VertexEdges => relations::vertex_edges(mesh, v).map(|h| edge(mesh, h)).collect(),
        _ => relations::vertex_faces(mesh, v).map(face).collect(),
    }
}

fn of_edge<M: Incidence>(mesh: &M, relation: Relation, h: M::HalfEdge) -> Vec<Element> {
    match relation {
        Relation::EdgeVertices => relations::edge_vertices(mesh, h).map(vertex).into(),
        Relation::EdgeEdges => relations::edge_edges(mesh, h).map(|h| edge(mesh, h)).collect(),
        _ => relations::edge_faces(mesh, h).map(face).collect(),
    }
}

fn of_face<M: Incidence>(mesh: &M, relation: Relation, f: M::Face) -> Vec<Element> {
    match relation {
        Relation::FaceVertices => relations::face_vertices(mesh, f).map(vertex).into(),
        Relation::FaceEdges => relations::face_edges(mesh, f).map(|h| edge(mesh, h)).into(),
        _ => relations::face_faces(mesh, f).map(face).collect(),
    }
}

impl Ask<'_> {
    /// The answers of the bare graph: faces are asked about by their vertices, and cycles come for them. The relation
    /// is one of the six of TopTri.
    pub(crate) fn on_graph(self, graph: &VertexGraph, faces: &[[u32; 3]]) -> Vec<Vec<Element>> {
        self.of.iter().map(|&element| on_graph(graph, self.relation, element, faces)).collect()
    }
}

fn on_graph(graph: &VertexGraph, relation: Relation, of: Element, faces: &[[u32; 3]]) -> Vec<Element> {
    let id = |v: u32| VertexId::new(v as usize);
    let edge = |e: [VertexId; 2]| Element::edge(e.map(|v| v.index() as u32));
    let cycle = |f: [VertexId; 3]| Element::Cycle(f.map(|v| v.index() as u32));
    match (relation, of) {
        (Relation::VertexVertices, Element::Vertex(v)) => graph.neighbours(id(v)).map(vertex).collect(),
        (Relation::VertexEdges, Element::Vertex(v)) => graph.vertex_edges(id(v)).map(edge).collect(),
        (_, Element::Vertex(v)) => graph.vertex_faces(id(v)).map(cycle).collect(),
        (Relation::EdgeEdges, Element::Edge(e)) => graph.adjacent_edges(e.map(id)).map(edge).collect(),
        (_, Element::Edge(e)) => graph.edge_faces(e.map(id)).map(cycle).collect(),
        (_, Element::Face(f)) => graph.adjacent_faces(faces[f as usize].map(id)).map(cycle).collect(),
        (_, Element::Cycle(f)) => graph.adjacent_faces(f.map(id)).map(cycle).collect(),
    }
}
