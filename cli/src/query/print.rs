//! Answers as text and as JSON.

use super::element::{EdgeNumbers, Element};
use super::relation::Relation;
use onering_io::Triangles;
use serde::Serialize;
use std::fmt;

impl fmt::Display for Element {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            Self::Vertex(number) | Self::Face(number) => write!(f, "{number}"),
            Self::Edge([a, b]) => write!(f, "{a}-{b}"),
            Self::Cycle([a, b, c]) => write!(f, "{a}-{b}-{c}"),
        }
    }
}

/// `vertex-edges 17: 3-17 17-20`
pub(crate) fn line(relation: Relation, of: Element, results: &[Element]) -> String {
    let words: String = results.iter().map(|result| format!(" {result}")).collect();
    format!("{} {of}:{}\n", relation.name(), if words.is_empty() { " none" } else { &words })
}

/// One answer in the shape of its JSON.
#[derive(Debug, Serialize)]
struct Answer<'a> {
    backend: &'a str,
    relation: &'static str,
    toptri: Option<&'static str>,
    of: Described,
    results: Vec<Described>,
}

/// An element, with the vertices that it has and where they are. A position that is no number is `null`.
#[derive(Debug, Default, Serialize)]
struct Described {
    #[serde(skip_serializing_if = "Option::is_none")]
    vertex: Option<u32>,
    #[serde(skip_serializing_if = "Option::is_none")]
    edge: Option<u32>,
    #[serde(skip_serializing_if = "Option::is_none")]
    face: Option<u32>,
    #[serde(skip_serializing_if = "Vec::is_empty")]
    vertices: Vec<u32>,
    positions: Vec<[f32; 3]>,
}

/// One JSON object on a line.
pub(crate) fn json(
    backend: &str,
    relation: Relation,
    (of, results): (Element, &[Element]),
    mesh: &Triangles,
    edges: Option<&EdgeNumbers>,
) -> serde_json::Result<String> {
    let described = |element| Described::of(element, mesh, edges);
    let answer = Answer {
        backend,
        relation: relation.name(),
        toptri: relation.in_toptri(),
        of: described(of),
        results: results.iter().map(|&result| described(result)).collect(),
    };
    Ok(serde_json::to_string(&answer)? + "\n")
}

impl Described {
    fn of(element: Element, mesh: &Triangles, edges: Option<&EdgeNumbers>) -> Self {
        let at = |vertices: &[u32]| vertices.iter().map(|&v| mesh.positions[v as usize]).collect();
        let with =
            |vertices: &[u32]| Self { vertices: vertices.into(), positions: at(vertices), ..Self::default() };
        match element {
            Element::Vertex(v) => Self { vertex: Some(v), positions: at(&[v]), ..Self::default() },
            Element::Edge(ends) => Self { edge: edges.and_then(|edges| edges.number(ends)), ..with(&ends) },
            Element::Face(f) => Self { face: Some(f), ..with(&mesh.faces[f as usize]) },
            Element::Cycle(vertices) => with(&vertices),
        }
    }
}
