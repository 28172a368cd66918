//! The nine relations by their names.

use clap::ValueEnum;

/// What is to be listed of what.
#[derive(Clone, Copy, Debug, PartialEq, Eq, ValueEnum)]
pub(crate) enum Relation {
    /// The neighbours of a vertex: vGetAdjacentVertices
    #[value(alias = "vGetAdjacentVertices")]
    VertexVertices,
    /// The edges at a vertex: vGetIncidentEdges
    #[value(alias = "vGetIncidentEdges")]
    VertexEdges,
    /// The faces at a vertex: vGetIncidentFaces
    #[value(alias = "vGetIncidentFaces")]
    VertexFaces,
    /// The two ends of an edge
    EdgeVertices,
    /// The edges that share an end with an edge: eGetAdjacentEdges
    #[value(alias = "eGetAdjacentEdges")]
    EdgeEdges,
    /// The faces along an edge: eGetIncidentFaces
    #[value(alias = "eGetIncidentFaces")]
    EdgeFaces,
    /// The three vertices of a face
    FaceVertices,
    /// The three edges of a face
    FaceEdges,
    /// The faces across the edges of a face: fGetAdjacentFaces
    #[value(alias = "fGetAdjacentFaces")]
    FaceFaces,
}

/// What a relation is of.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) enum Kind {
    Vertex,
    Edge,
    Face,
}

impl Relation {
    pub(crate) fn all() -> &'static [Self] {
        Self::value_variants()
    }

    /// Its name on the command line.
    pub(crate) fn name(self) -> &'static str {
        match self {
            Self::VertexVertices => "vertex-vertices",
            Self::VertexEdges => "vertex-edges",
            Self::VertexFaces => "vertex-faces",
            Self::EdgeVertices => "edge-vertices",
            Self::EdgeEdges => "edge-edges",
            Self::EdgeFaces => "edge-faces",
            Self::FaceVertices => "face-vertices",
            Self::FaceEdges => "face-edges",
            Self::FaceFaces => "face-faces",
        }
    }

    /// Its name in TopTri (Figueiredo et al. 2014, Table 1), which has six of the nine.
    pub(crate) fn in_toptri(self) -> Option<&'static str> {
        match self {
            Self::VertexVertices => Some("vGetAdjacentVertices"),
            Self::VertexEdges => Some("vGetIncidentEdges"),
            Self::VertexFaces => Some("vGetIncidentFaces"),
            Self::EdgeEdges => Some("eGetAdjacentEdges"),
            Self::EdgeFaces => Some("eGetIncidentFaces"),
            Self::FaceFaces => Some("fGetAdjacentFaces"),
            Self::EdgeVertices | Self::FaceVertices | Self::FaceEdges => None,
        }
    }

    /// The kind of the element that is asked about.
    pub(crate) fn of(self) -> Kind {
        match self {
            Self::VertexVertices | Self::VertexEdges | Self::VertexFaces => Kind::Vertex,
            Self::EdgeVertices | Self::EdgeEdges | Self::EdgeFaces => Kind::Edge,
            Self::FaceVertices | Self::FaceEdges | Self::FaceFaces => Kind::Face,
        }
    }

    /// Whether edges are asked about or listed.
    pub(crate) fn is_about_edges(self) -> bool {
        self.of() == Kind::Edge || matches!(self, Self::VertexEdges | Self::FaceEdges)
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn names_are_those_of_the_command_line() {
        assert_eq!(Relation::all().len(), 9);
        for &relation in Relation::all() {
            let value = relation.to_possible_value().unwrap();
            assert_eq!(value.get_name(), relation.name());
            assert!(relation.in_toptri().is_none_or(|name| value.matches(name, false)), "{relation:?}");
        }
        assert_eq!(Relation::all().iter().filter_map(|relation| relation.in_toptri()).count(), 6);
    }
}
