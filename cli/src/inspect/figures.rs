//! The figures of one file, under the names that the reports use.

use super::{digest, geometry, verdict};
use crate::input;
use onering::defects::{Defects, Figure};
use onering::repair::weld;
use onering::{BuildError, memory};
use onering_io::{Format, Options, Skipped, Triangles, gltf};
use serde::ser::{Error as _, Serialize, SerializeMap, Serializer};
use std::collections::BTreeMap;
use std::path::Path;

/// Everything that is said of a file; `null` where a figure has no meaning.
#[derive(Debug, serde::Serialize)]
pub(crate) struct Inspection {
    pub(crate) file: String,
    pub(crate) verdict: String,
    pub(crate) format: String,
    #[serde(skip_serializing_if = "Option::is_none")]
    pub(crate) primitives: Option<usize>,
    #[serde(skip_serializing_if = "Option::is_none")]
    pub(crate) gltf_buffers: Option<Vec<String>>,
    #[serde(skip_serializing_if = "Option::is_none")]
    pub(crate) skipped_faces: Option<usize>,
    #[serde(skip_serializing_if = "BTreeMap::is_empty")]
    pub(crate) ignored_elements: BTreeMap<String, usize>,
    #[serde(skip_serializing_if = "BTreeMap::is_empty")]
    pub(crate) skipped_primitives: BTreeMap<String, usize>,
    /// What the reader left out, in words.
    pub(crate) notes: Vec<String>,
    pub(crate) bytes: usize,
    pub(crate) sha256: String,
    pub(crate) vertices: usize,
    pub(crate) polygons: usize,
    pub(crate) polygon_sizes: BTreeMap<usize, usize>,
    pub(crate) triangles: usize,
    pub(crate) finite_coordinates: bool,
    pub(crate) bbox_min: Option<[f64; 3]>,
    pub(crate) bbox_max: Option<[f64; 3]>,
    pub(crate) area: Option<f64>,
    pub(crate) signed_volume: Option<f64>,
    /// How many vertices have so many edges.
    pub(crate) degree_histogram: BTreeMap<usize, usize>,
    pub(crate) topology: Topology,
    pub(crate) welded: Welded,
    pub(crate) tri_sha256: String,
    pub(crate) tri_canonical_sha256: String,
}

/// The figures of a face list.
#[derive(Debug)]
pub(crate) struct Topology {
    /// Only where it is not said elsewhere.
    pub(crate) vertices: Option<usize>,
    pub(crate) figures: Vec<(&'static str, Figure)>,
}

/// The figures once vertices at equal positions are one.
#[derive(Debug, serde::Serialize)]
#[serde(untagged)]
pub(crate) enum Welded {
    Same(&'static str),
    Other(Topology),
}

impl Inspection {
    /// Of a file, or of standard input, which is of this format where one is given.
    pub(crate) fn of(path: &Path, format: Option<Format>) -> Result<Self, String> {
        let format = format.filter(|_| input::is_standard(path));
        let mut seen = digest::Bytes::default();
        let in_pieces = input::in_pieces(path, format, Options::default(), |bytes| seen.add(bytes));
        let (mesh, format) = match in_pieces {
            Some(read) => read,
            None => {
                let bytes = input::bytes_of(path)?;
                seen = digest::Bytes::default();
                seen.add(&bytes);
                input::mesh_in(&bytes, path, format, Options::default())?
            }
        };
        let (length, sha256) = seen.finish();
        Ok(Self {
            file: input::name_of(path),
            format: format.to_string(),
            bytes: length,
            sha256,
            ..Self::of_mesh(&mesh).map_err(|error| format!("{}: {error}", input::name_of(path)))?
        })
    }

    fn of_mesh(mesh: &Triangles) -> Result<Self, BuildError> {
        let Triangles { positions, faces, .. } = mesh;
        let geometry = geometry::Geometry::of(mesh);
        let finite_coordinates = geometry.is_ok();
        let geometry = geometry.ok().flatten();
        let defects = Defects::of(positions.len(), faces)?;
        let welded_defects = welded_defects(mesh)?;
        // A glTF file has 32-bit floats and no decimals: each is exactly the number that is there.
        let number = if mesh.gltf.is_some() { f64::from } else { shortest };
        let mut inspection = Self {
            file: String::new(),
            format: String::new(),
            primitives: mesh.gltf.as_ref().map(|origin| origin.primitives),
            gltf_buffers: mesh.gltf.as_ref().map(buffers),
            skipped_faces: None,
            ignored_elements: BTreeMap::new(),
            skipped_primitives: BTreeMap::new(),
            notes: mesh.notes.iter().map(ToString::to_string).collect(),
            bytes: 0,
            sha256: String::new(),
            vertices: positions.len(),
            polygons: mesh.polygon_count(),
            polygon_sizes: mesh.polygon_sizes.clone(),
            triangles: faces.len(),
            finite_coordinates,
            bbox_min: geometry.map(|g| g.bbox_min.map(number)),
            bbox_max: geometry.map(|g| g.bbox_max.map(number)),
            area: geometry.map(|g| g.area),
            signed_volume: geometry.map(|g| g.signed_volume),
            degree_histogram: defects.degrees.iter().collect(),
            verdict: verdict::of(&defects, welded_defects.as_ref().map(|(_, defects)| defects)),
            topology: Topology::of(&defects, None),
            welded: Welded::of(welded_defects.as_ref()),
            tri_sha256: digest::of_faces(faces),
            tri_canonical_sha256: digest::of_canonical(faces),
        };
        inspection.add_notes(mesh);
        Ok(inspection)
    }

    fn add_notes(&mut self, mesh: &Triangles) {
        for note in &mesh.notes {
            let (list, key) = match &note.what {
                Skipped::ShortFaces => {
                    self.skipped_faces = Some(note.count);
                    continue;
                }
                Skipped::Elements(keyword) => (&mut self.ignored_elements, keyword.to_string()),
                Skipped::PrimitiveMode(mode) => (&mut self.skipped_primitives, mode.to_string()),
                Skipped::UnknownModes => (&mut self.skipped_primitives, "unknown mode".into()),
                Skipped::NoPositions => (&mut self.skipped_primitives, "no POSITION".into()),
                _ => continue,
            };
            *list.entry(key).or_default() += note.count;
        }
    }
}

/// The number with the fewest decimals that rounds to `x`: most often what a file of decimals has.
fn shortest(x: f32) -> f64 {
    x.to_string().parse().unwrap_or(f64::from(x))
}

impl Topology {
    fn of(defects: &Defects, vertices: Option<usize>) -> Self {
        // No reader gives a face that names no vertex.
        let figures = defects.figures().filter(|&(name, _)| name != "out_of_range_faces").collect();
        Self { vertices, figures }
    }
}

impl Welded {
    fn of(welded: Option<&(usize, Defects)>) -> Self {
        match welded {
            None => Self::Same("same as topology (no two vertices share a position)"),
            Some((vertices, defects)) => Self::Other(Topology::of(defects, Some(*vertices))),
        }
    }
}

/// Vertices and defects once vertices at equal positions are one; `None` where no two are.
fn welded_defects(mesh: &Triangles) -> Result<Option<(usize, Defects)>, BuildError> {
    let welded = weld(&mesh.positions)?;
    let vertices = welded.source.len();
    if vertices == mesh.positions.len() {
        return Ok(None);
    }
    let faces = mesh.faces.iter().map(|face| face.map(|v| welded.target[v as usize]));
    let faces = memory::collected(faces)?;
    Ok(Some((vertices, Defects::of(vertices, &faces)?)))
}

fn buffers(of: &gltf::Origin) -> Vec<String> {
    of.buffers.iter().map(ToString::to_string).collect()
}

/// A map in the order of the figures.
impl Serialize for Topology {
    fn serialize<S: Serializer>(&self, serializer: S) -> Result<S::Ok, S::Error> {
        let mut map = serializer.serialize_map(None)?;
        if let Some(vertices) = self.vertices {
            map.serialize_entry("vertices", &vertices)?;
        }
        for (name, figure) in &self.figures {
            match *figure {
                Figure::Count(count) => {
                    map.serialize_entry(name, &i64::try_from(count).map_err(S::Error::custom)?)?;
                }
                Figure::Flag(flag) => map.serialize_entry(name, &flag)?,
                Figure::Undefined => map.serialize_entry(name, &())?,
            }
        }
        map.end()
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn coordinates_are_decimals_or_exact_as_the_file_has_them() {
        let exact = 4_891.903_808_593_75;
        let positions = vec![[exact as f32, 0.1, -0.0]];
        let decimal = Triangles { positions, ..Triangles::default() };
        let binary = Triangles { gltf: Some(gltf::Origin::default()), ..decimal.clone() };
        let of = |mesh: &Triangles| Inspection::of_mesh(mesh).unwrap().bbox_max;
        assert_eq!(of(&decimal), Some([4_891.904, 0.1, 0.0]));
        assert_eq!(of(&binary), Some([exact, f64::from(0.1_f32), 0.0]));
    }
}
