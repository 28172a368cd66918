//! Vertices and faces in another order, polygons kept together.

use clap::ValueEnum;
use onering::reorder::{
    Reordering, breadth_first, hilbert, morton, reorder, reorder_both, reverse_cuthill_mckee,
};
use onering::{BuildError, FaceId, FromFaces, Handle, Map, SharedVertex, VertexGraph, VertexId};
use onering_io::Triangles;
use std::fmt::{self, Display};

/// How to put the vertices in order.
#[derive(Clone, Copy, Debug, PartialEq, Eq, ValueEnum)]
pub(crate) enum Method {
    /// Along a Hilbert curve, by position
    Hilbert,
    /// Along a Morton curve (Z order), by position
    Morton,
    /// Level by level, from the first vertex of each component
    BreadthFirst,
    /// Reverse Cuthill-McKee: numbers of neighbours differ little
    CuthillMckee,
}

impl Display for Method {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.write_str(match self {
            Self::Hilbert => "along a Hilbert curve",
            Self::Morton => "along a Morton curve",
            Self::BreadthFirst => "breadth first",
            Self::CuthillMckee => "by reverse Cuthill-McKee",
        })
    }
}

/// Puts the vertices in order, and the faces by their least vertices: whole polygons, where there are such.
pub(super) fn apply(method: Method, mesh: &mut Triangles) -> Result<(), String> {
    let failed = |error: BuildError| error.to_string();
    let order = vertices(method, mesh)?;
    let soup = SharedVertex::from_faces(mesh.positions.len(), &mesh.faces).map_err(failed)?;
    let new = match &mesh.polygon_starts {
        None => reorder(&soup, &order),
        Some(_) => {
            let (faces, starts) = by_polygons(mesh, &order);
            mesh.polygon_starts = Some(starts);
            reorder_both(&soup, &order, &faces)
        }
    };
    mesh.positions = new.carry_vertices(&mesh.positions);
    let Reordering { faces, .. } = new;
    mesh.faces = faces;
    Ok(())
}

fn vertices(method: Method, mesh: &Triangles) -> Result<Vec<VertexId>, String> {
    let positions = || Map::from(mesh.positions.clone());
    let graph =
        || VertexGraph::from_faces(mesh.positions.len(), &mesh.faces).map_err(|error| error.to_string());
    match method {
        Method::Hilbert => hilbert(&positions()).map_err(|error| error.to_string()),
        Method::Morton => morton(&positions()).map_err(|error| error.to_string()),
        Method::BreadthFirst => Ok(breadth_first(&graph()?)),
        Method::CuthillMckee => Ok(reverse_cuthill_mckee(&graph()?)),
    }
}

/// The faces polygon by polygon, in the order of the least new vertex of each; and where each begins then.
fn by_polygons(mesh: &Triangles, order: &[VertexId]) -> (Vec<FaceId>, Vec<u32>) {
    let mut number = vec![0; order.len()];
    (0_u32..).zip(order).for_each(|(new, v)| number[v.index()] = new);
    let least = |face: usize| mesh.faces[face].map(|v| number[v as usize]).into_iter().min();
    let mut polygons: Vec<_> =
        mesh.polygons().map(|faces| (faces.clone().filter_map(least).min(), faces)).collect();
    polygons.sort_by_key(|(least, _)| *least);
    let (mut faces, mut starts) = (Vec::with_capacity(mesh.faces.len()), Vec::with_capacity(polygons.len()));
    for (_, polygon) in polygons {
        starts.push(faces.len() as u32);
        faces.extend(polygon.map(FaceId::new));
    }
    (faces, starts)
}
