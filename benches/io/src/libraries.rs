//! The libraries compared, each used as its documentation advises, at its fastest public way.

use crate::shape::Answer;
use onering_io::Options;
use ply_rs_bw::parser::{Parser, Reader};
use ply_rs_bw::ply::{BeginList, PropertyAccess};
use std::error::Error;
use std::fs::{self, File};
use std::io::BufReader;
use std::path::Path;

type Outcome<T> = Result<T, Box<dyn Error>>;

/// What a library loaded.
pub(crate) trait Mesh {
    fn triangles(&self) -> usize;
    fn answer(&self) -> Answer;
}

pub(crate) fn onering(path: &Path) -> Outcome<onering_io::Triangles> {
    Ok(onering_io::load(path)?)
}

/// STL as it is in the file: three vertices a triangle.
pub(crate) fn onering_corners(path: &Path) -> Outcome<onering_io::Triangles> {
    let mut options = Options::default();
    options.weld_stl = false;
    Ok(options.load(path)?)
}

impl Mesh for onering_io::Triangles {
    fn triangles(&self) -> usize {
        self.faces.len()
    }

    fn answer(&self) -> Answer {
        Answer::of_indexed(&self.positions, &self.faces)
    }
}

pub(crate) fn tobj(path: &Path) -> Outcome<Vec<tobj::Model>> {
    let options = tobj::LoadOptions { triangulate: true, ..Default::default() };
    Ok(tobj::load_obj(path, &options)?.0)
}

impl Mesh for Vec<tobj::Model> {
    fn triangles(&self) -> usize {
        self.iter().map(|model| model.mesh.indices.len() / 3).sum()
    }

    fn answer(&self) -> Answer {
        Answer::of(self.iter().flat_map(|model| {
            let positions = model.mesh.positions.as_chunks::<3>().0;
            model.mesh.indices.iter().map(|&v| positions[v as usize])
        }))
    }
}

pub(crate) fn mesh_loader(path: &Path) -> Outcome<mesh_loader::Scene> {
    Ok(mesh_loader::Loader::default().load(path)?)
}

impl Mesh for mesh_loader::Scene {
    fn triangles(&self) -> usize {
        self.meshes.iter().map(|mesh| mesh.faces.len()).sum()
    }

    fn answer(&self) -> Answer {
        let corners = |mesh: &'_ mesh_loader::Mesh| {
            let corners: Vec<_> =
                mesh.faces.as_flattened().iter().map(|&v| mesh.vertices[v as usize]).collect();
            corners
        };
        Answer::of(self.meshes.iter().flat_map(corners))
    }
}

/// Into structs of our own, refilled: its element that can hold anything takes twenty times as long.
pub(crate) fn ply_rs_bw(path: &Path) -> Outcome<(Vec<PlyVertex>, Vec<PlyFace>)> {
    let mut reader = Reader::new(BufReader::new(File::open(path)?));
    let (vertices, faces) = (Parser::<PlyVertex>::new(), Parser::<PlyFace>::new());
    let header = vertices.read_header(&mut reader)?;
    let element = |name: &str| header.elements.get(name).ok_or("no such element");
    Ok((
        vertices.read_payload_for_element(&mut reader, element("vertex")?, &header)?,
        faces.read_payload_for_element(&mut reader, element("face")?, &header)?,
    ))
}

pub(crate) struct PlyVertex([f32; 3]);

impl PropertyAccess for PlyVertex {
    fn new() -> Self {
        Self([0.0; 3])
    }

    fn set_float(&mut self, name: &str, value: f32) -> ply_rs_bw::ply::PropertyAccessResult {
        let axis = match name {
            "x" => 0,
            "y" => 1,
            _ => 2,
        };
        self.0[axis] = value;
        ply_rs_bw::ply::PropertyAccessResult::Set
    }
}

#[derive(Default)]
pub(crate) struct PlyFace {
    signed: Vec<i32>,
    unsigned: Vec<u32>,
}

impl PropertyAccess for PlyFace {
    fn new() -> Self {
        Self::default()
    }

    fn begin_list_int(&mut self, _: &str, _: usize) -> BeginList<'_, i32> {
        BeginList::Fill(&mut self.signed)
    }

    fn begin_list_uint(&mut self, _: &str, _: usize) -> BeginList<'_, u32> {
        BeginList::Fill(&mut self.unsigned)
    }
}

impl Mesh for (Vec<PlyVertex>, Vec<PlyFace>) {
    fn triangles(&self) -> usize {
        self.1.len()
    }

    fn answer(&self) -> Answer {
        let corners = |face: &'_ PlyFace| {
            let signed = face.signed.iter().map(|&v| v as usize);
            signed.chain(face.unsigned.iter().map(|&v| v as usize)).collect::<Vec<_>>()
        };
        Answer::of(self.1.iter().flat_map(corners).map(|v| self.0[v].0))
    }
}

/// Merges corners through a hash table.
pub(crate) fn stl_io(path: &Path) -> Outcome<stl_io::IndexedMesh> {
    Ok(stl_io::read_stl(&mut BufReader::new(File::open(path)?))?)
}

impl Mesh for stl_io::IndexedMesh {
    fn triangles(&self) -> usize {
        self.faces.len()
    }

    fn answer(&self) -> Answer {
        let corners = self.faces.iter().flat_map(|face| face.vertices).map(|v| &self.vertices[v]);
        Answer::of(corners.map(|v| [v[0], v[1], v[2]]))
    }
}

pub(crate) fn stl_io_corners(path: &Path) -> Outcome<Vec<stl_io::Triangle>> {
    let mut file = BufReader::new(File::open(path)?);
    Ok(stl_io::create_stl_reader(&mut file)?.collect::<Result<_, _>>()?)
}

impl Mesh for Vec<stl_io::Triangle> {
    fn triangles(&self) -> usize {
        self.len()
    }

    fn answer(&self) -> Answer {
        Answer::of(self.iter().flat_map(|triangle| triangle.vertices).map(|v| [v[0], v[1], v[2]]))
    }
}

pub(crate) fn nom_stl(path: &Path) -> Outcome<nom_stl::Mesh> {
    let mut file = BufReader::new(File::open(path)?);
    nom_stl::parse_stl(&mut file).map_err(|error| format!("{error:?}").into())
}

impl Mesh for nom_stl::Mesh {
    fn triangles(&self) -> usize {
        nom_stl::Mesh::triangles(self).len()
    }

    fn answer(&self) -> Answer {
        Answer::of(nom_stl::Mesh::triangles(self).iter().flat_map(|triangle| triangle.vertices()))
    }
}

/// Positions and indices through its accessors; the document is validated.
pub(crate) fn gltf(path: &Path) -> Outcome<(Vec<[f32; 3]>, Vec<u32>)> {
    let bytes = fs::read(path)?;
    let document = gltf::Gltf::from_slice(&bytes)?;
    let (mut positions, mut indices) = (Vec::new(), Vec::new());
    for primitive in document.meshes().flat_map(|mesh| mesh.primitives()) {
        let reader = primitive.reader(|_| document.blob.as_deref());
        positions.extend(reader.read_positions().ok_or("no positions")?);
        indices.extend(reader.read_indices().ok_or("no indices")?.into_u32());
    }
    Ok((positions, indices))
}

impl Mesh for (Vec<[f32; 3]>, Vec<u32>) {
    fn triangles(&self) -> usize {
        self.1.len() / 3
    }

    fn answer(&self) -> Answer {
        Answer::of(self.1.iter().map(|&v| self.0[v as usize]))
    }
}
