//! What onering can compute of a mesh, to be written beside it.

use super::holds::Holds;
use crate::failure::Failure;
use crate::{args, input};
use onering::k_ring::KRing;
use onering::neighbours::Neighbours;
use onering::{
    BuildError, DirectedEdgesSmall, FaceId, FromFaces, Handle, VertexGraph, VertexId, boundary, components,
};
use onering_io::{Format, Triangles, Values};
use std::str::FromStr;

/// A value for each vertex. Components are told at vertices as well: formats that hold values at faces give up shared
/// vertices or polygons for them.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) enum Attribute {
    Components,
    Boundary,
    Valence,
    Ring(u32),
    Coordinate(usize),
}

/// What an attribute came to be on one mesh.
#[derive(Debug)]
pub(crate) struct Computed {
    name: String,
    column: Column,
}

#[derive(Debug, PartialEq)]
enum Column {
    Flags(Vec<bool>),
    Labels(Vec<u32>),
    Scalars(Vec<f32>),
}

/// The label of what has none: a vertex in no component, or that no ring reaches.
const NONE: u32 = u32::MAX;

impl Attribute {
    /// Every name, with what it stands for.
    pub(crate) const HELP: [(&'static str, &'static str); 5] = [
        (
            "components",
            "which component the faces of a vertex are in, by shared edges; where in several, the first",
        ),
        ("boundary", "whether a vertex is on an edge of one face only"),
        ("valence", "how many neighbours a vertex has"),
        ("ring=VERTEX", "how many edges a vertex is away from this one, counted from 0 as OUT has them"),
        ("x, y, z", "the coordinate of a vertex"),
    ];

    /// Its name in the file; CloudCompare knows scalar fields by the first word.
    fn name(self) -> String {
        match self {
            Self::Components => "component".into(),
            Self::Boundary => "boundary".into(),
            Self::Valence => "valence".into(),
            Self::Ring(v) => format!("ring_{v}"),
            Self::Coordinate(axis) => format!("scalar_{}", ["x", "y", "z"][axis]),
        }
    }

    fn compute(self, mesh: &Triangles) -> Result<Computed, String> {
        let Triangles { positions, faces, .. } = mesh;
        let vertex_count = positions.len();
        let column = match self {
            Self::Components => Column::Labels(first_components(vertex_count, faces)?),
            Self::Boundary => Column::Flags(boundary(vertex_count, faces)?),
            Self::Valence => Column::Labels(valences(vertex_count, faces)?),
            Self::Ring(v) => Column::Labels(ring(vertex_count, faces, v)?),
            Self::Coordinate(axis) => Column::Scalars(positions.iter().map(|p| p[axis]).collect()),
        };
        Ok(Computed { name: self.name(), column })
    }
}

impl FromStr for Attribute {
    type Err = String;

    fn from_str(word: &str) -> Result<Self, String> {
        match word {
            "components" => return Ok(Self::Components),
            "boundary" => return Ok(Self::Boundary),
            "valence" => return Ok(Self::Valence),
            _ => {}
        }
        if let Some(axis) = ["x", "y", "z"].iter().position(|axis| *axis == word) {
            return Ok(Self::Coordinate(axis));
        }
        if let Some(v) = word.strip_prefix("ring=") {
            return v.parse().map(Self::Ring).map_err(|_| format!("`{v}` is not the number of a vertex"));
        }
        let names = Self::HELP.map(|(name, _)| name);
        Err(format!("attributes are {}", names.join(", ")))
    }
}

impl Computed {
    pub(crate) fn as_attribute(&self) -> onering_io::Attribute<'_> {
        let values = match &self.column {
            Column::Flags(flags) => Values::Flags(flags),
            Column::Labels(labels) => Values::Labels(labels),
            Column::Scalars(scalars) => Values::Scalars(scalars),
        };
        onering_io::Attribute { name: &self.name, values }
    }
}

/// Refuses attributes that the format would leave out.
pub(crate) fn check(attributes: &[Attribute], format: Format, holds: &Holds) -> Result<(), Failure> {
    if attributes.is_empty() || holds.attributes {
        return Ok(());
    }
    let able = Format::all().filter(|format| Holds::of(*format).attributes);
    let able: Vec<String> = able.map(|format| format.to_string()).collect();
    let able = if able.is_empty() { "no format that is written".into() } else { able.join(", ") };
    Err(Failure::Usage(format!("{format} has no place for attributes; {able} can hold them")))
}

/// All that was asked for, each once.
pub(crate) fn compute(options: &args::Convert, mesh: &Triangles) -> Result<Vec<Computed>, Failure> {
    let asked = &options.attributes;
    let failure = |error| Failure::Output(format!("{}: {error}", input::name_of(&options.input)));
    let once = asked.iter().enumerate().filter(|(i, attribute)| !asked[..*i].contains(attribute));
    once.map(|(_, attribute)| attribute.compute(mesh).map_err(failure)).collect()
}

/// The structure that takes the most: all but faces that name a vertex twice.
fn adjacency(vertex_count: usize, faces: &[[u32; 3]]) -> Result<DirectedEdgesSmall, String> {
    DirectedEdgesSmall::from_faces(vertex_count, faces).map_err(|error| match error {
        BuildError::DegenerateFace { .. } => {
            format!("{error}, so that its edges are not defined: --repair drops such faces")
        }
        other => other.to_string(),
    })
}

/// Takes any list of faces.
fn graph(vertex_count: usize, faces: &[[u32; 3]]) -> Result<VertexGraph, String> {
    VertexGraph::from_faces(vertex_count, faces).map_err(|error| error.to_string())
}

/// The component of the first face of each vertex.
fn first_components(vertex_count: usize, faces: &[[u32; 3]]) -> Result<Vec<u32>, String> {
    let components = components::components(&adjacency(vertex_count, faces)?);
    let mut first = vec![NONE; vertex_count];
    for (f, face) in faces.iter().enumerate().rev() {
        let component = components.of(FaceId::new(f)) as u32;
        face.iter().for_each(|&v| first[v as usize] = component);
    }
    Ok(first)
}

fn boundary(vertex_count: usize, faces: &[[u32; 3]]) -> Result<Vec<bool>, String> {
    let mesh = adjacency(vertex_count, faces)?;
    Ok(boundary::vertices(&mesh).as_slice().to_vec())
}

fn valences(vertex_count: usize, faces: &[[u32; 3]]) -> Result<Vec<u32>, String> {
    let graph = graph(vertex_count, faces)?;
    Ok((0..vertex_count).map(|v| Neighbours::neighbours(&graph, VertexId::new(v)).count() as u32).collect())
}

fn ring(vertex_count: usize, faces: &[[u32; 3]], centre: u32) -> Result<Vec<u32>, String> {
    if centre as usize >= vertex_count {
        return Err(format!(
            "there is no vertex {centre} for the attribute `ring`: there are {vertex_count}"
        ));
    }
    let graph = graph(vertex_count, faces)?;
    let mut ring = KRing::new();
    ring.search(&graph, VertexId::new(centre as usize), usize::MAX);
    let mut levels = vec![NONE; vertex_count];
    for level in 0..=ring.levels() {
        ring.level(level).iter().for_each(|v| levels[v.index()] = level as u32);
    }
    Ok(levels)
}

#[cfg(test)]
mod tests {
    use super::*;

    /// A strip of two triangles, a triangle apart, and a vertex in none.
    const FACES: [[u32; 3]; 3] = [[0, 1, 2], [2, 1, 3], [4, 5, 6]];

    fn column(word: &str, faces: &[[u32; 3]]) -> Result<Column, String> {
        let positions = (0..8).map(|i| [i as f32, 0.5, -(i as f32)]).collect();
        let mesh = Triangles::new(positions, faces.to_vec());
        Attribute::from_str(word)?.compute(&mesh).map(|computed| computed.column)
    }

    #[test]
    fn labels_and_flags_by_hand() {
        let labels =
            |word: &str, values: &[u32]| assert_eq!(column(word, &FACES), Ok(Column::Labels(values.into())));
        labels("components", &[0, 0, 0, 0, 1, 1, 1, NONE]);
        labels("valence", &[2, 3, 3, 2, 2, 2, 2, 0]);
        labels("ring=0", &[0, 1, 1, 2, NONE, NONE, NONE, NONE]);
        let tetrahedron = [[0, 2, 1], [0, 1, 3], [1, 2, 3], [0, 3, 2], [4, 5, 6]];
        let flags = [0, 0, 0, 0, 1, 1, 1, 0].map(|flag| flag == 1);
        assert_eq!(column("boundary", &tetrahedron), Ok(Column::Flags(flags.into())));
        let heights = (0..8).map(|i| -(i as f32)).collect();
        assert_eq!(column("z", &FACES), Ok(Column::Scalars(heights)));
    }

    #[test]
    fn what_a_mesh_cannot_answer_is_said() {
        let degenerate = [[0, 0, 1]];
        for word in ["components", "boundary"] {
            let error = column(word, &degenerate).unwrap_err();
            assert!(error.starts_with("face 0 names vertex 0 twice, "), "{error}");
        }
        assert!(column("valence", &degenerate).is_ok());
        assert!(column("ring=8", &FACES).unwrap_err().contains("there are 8"));
        assert!(column("ring=-1", &FACES).unwrap_err().contains("`-1`"));
        assert!(column("colour", &FACES).unwrap_err().contains("boundary"));
    }
}
