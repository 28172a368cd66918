//! The files that are written and who reads them. A new format or library is a line here.

use crate::libraries as lib;
use crate::shape::{Answer, Shape};
use onering_io::{MeshRef, SaveOptions};
use std::error::Error;
use std::fs;
use std::io::{self, BufWriter, Write};
use std::path::{Path, PathBuf};

type Outcome<T> = Result<T, Box<dyn Error>>;

/// A kind of file.
pub(crate) struct File {
    pub(crate) name: &'static str,
    pub(crate) file_name: &'static str,
    pub(crate) write: fn(&Shape, &Path) -> Outcome<()>,
    /// Whether it is onering that writes it.
    pub(crate) is_ours: bool,
    pub(crate) readers: &'static [Reader],
}

/// A library that reads it.
pub(crate) struct Reader {
    pub(crate) library: &'static str,
    /// To arrays in memory; the number of triangles, so that nothing can be left out.
    pub(crate) read: fn(&Path) -> Outcome<usize>,
    /// The same, and what was found.
    pub(crate) answer: fn(&Path) -> Outcome<Answer>,
}

/// One line for each library: `read` and `answer` from a function that gives something with both.
macro_rules! readers {
    ($($library:literal $load:path),+ $(,)?) => { &[$(Reader {
        library: $library,
        read: |path| Ok(lib::Mesh::triangles(&$load(path)?)),
        answer: |path| Ok(lib::Mesh::answer(&$load(path)?)),
    }),+] };
}

pub(crate) const FILES: &[File] = &[
    File {
        name: "OBJ",
        file_name: "mesh.obj",
        write: six_decimals,
        is_ours: false,
        readers: readers!["onering" lib::onering, "tobj 4" lib::tobj, "mesh-loader 0.1" lib::mesh_loader],
    },
    File {
        name: "OBJ, shortest decimals",
        file_name: "mesh-short.obj",
        write: |mesh, path| save(mesh, path),
        is_ours: true,
        readers: readers!["onering" lib::onering],
    },
    File {
        name: "PLY binary",
        file_name: "mesh.ply",
        write: |mesh, path| save(mesh, path),
        is_ours: true,
        readers: readers![
            "onering" lib::onering,
            "ply-rs-bw 4, typed" lib::ply_rs_bw,
        ],
    },
    File {
        name: "PLY ASCII",
        file_name: "mesh-ascii.ply",
        write: |mesh, path| {
            let mut options = SaveOptions::default();
            options.ascii = true;
            Ok(options.save(path, MeshRef::new(&mesh.positions, &mesh.faces))?)
        },
        is_ours: true,
        readers: readers![
            "onering" lib::onering,
            "ply-rs-bw 4, typed" lib::ply_rs_bw,
        ],
    },
    File {
        name: "STL binary",
        file_name: "mesh.stl",
        write: |mesh, path| save(mesh, path),
        is_ours: true,
        readers: readers![
            "onering, not welded" lib::onering_corners,
            "stl_io 0.11, not welded" lib::stl_io_corners,
            "nom_stl 0.2, not welded" lib::nom_stl,
            "onering, welded" lib::onering,
            "stl_io 0.11, welded" lib::stl_io,
            "mesh-loader 0.1, not welded" lib::mesh_loader,
        ],
    },
    File {
        name: "STL ASCII",
        file_name: "mesh-ascii.stl",
        write: ascii_stl,
        is_ours: false,
        readers: readers![
            "onering, welded" lib::onering,
            "onering, not welded" lib::onering_corners,
            "stl_io 0.11, welded" lib::stl_io,
            "nom_stl 0.2, not welded" lib::nom_stl,
            "mesh-loader 0.1, not welded" lib::mesh_loader,
        ],
    },
    File {
        name: "OFF",
        file_name: "mesh.off",
        write: |mesh, path| save(mesh, path),
        is_ours: true,
        readers: readers!["onering" lib::onering],
    },
    File {
        name: "GLB",
        file_name: "mesh.glb",
        write: |mesh, path| save(mesh, path),
        is_ours: true,
        readers: readers!["onering" lib::onering, "gltf 1.4" lib::gltf],
    },
    File {
        name: "X3D",
        file_name: "mesh.x3d",
        write: x3d,
        is_ours: false,
        readers: readers!["onering" lib::onering],
    },
    File {
        name: "VRML97",
        file_name: "mesh.wrl",
        write: vrml,
        is_ours: false,
        readers: readers!["onering" lib::onering],
    },
    File {
        name: "PLY binary, gzip",
        file_name: "mesh.ply.gz",
        write: |mesh, path| save(mesh, path),
        is_ours: true,
        readers: readers!["onering" lib::onering],
    },
];

fn save(mesh: &Shape, path: &Path) -> Outcome<()> {
    Ok(onering_io::save(path, MeshRef::new(&mesh.positions, &mesh.faces))?)
}

/// As other programs write OBJ: six decimals each.
fn six_decimals(mesh: &Shape, path: &Path) -> Outcome<()> {
    lines(path, |out| {
        for [x, y, z] in &mesh.positions {
            writeln!(out, "v {x:.6} {y:.6} {z:.6}")?;
        }
        mesh.faces.iter().try_for_each(|[a, b, c]| writeln!(out, "f {} {} {}", a + 1, b + 1, c + 1))
    })
}

fn ascii_stl(mesh: &Shape, path: &Path) -> Outcome<()> {
    lines(path, |out| {
        writeln!(out, "solid sheet")?;
        for face in &mesh.faces {
            writeln!(out, "facet normal 0 0 1\n outer loop")?;
            for [x, y, z] in face.map(|v| mesh.positions[v as usize]) {
                writeln!(out, "  vertex {x} {y} {z}")?;
            }
            writeln!(out, " endloop\nendfacet")?;
        }
        writeln!(out, "endsolid sheet")
    })
}

fn x3d(mesh: &Shape, path: &Path) -> Outcome<()> {
    lines(path, |out| {
        write!(out, "<X3D version='3.3'><Scene><Shape>\n<IndexedFaceSet coordIndex='")?;
        mesh.faces.iter().try_for_each(|[a, b, c]| write!(out, "{a} {b} {c} -1 "))?;
        write!(out, "'>\n<Coordinate point='")?;
        mesh.positions.iter().try_for_each(|[x, y, z]| write!(out, "{x} {y} {z}, "))?;
        writeln!(out, "'/>\n</IndexedFaceSet></Shape></Scene></X3D>")
    })
}

fn vrml(mesh: &Shape, path: &Path) -> Outcome<()> {
    lines(path, |out| {
        writeln!(out, "#VRML V2.0 utf8\nShape {{ geometry IndexedFaceSet {{ coord Coordinate {{ point [")?;
        mesh.positions.iter().try_for_each(|[x, y, z]| writeln!(out, "{x} {y} {z},"))?;
        writeln!(out, "] }} coordIndex [")?;
        mesh.faces.iter().try_for_each(|[a, b, c]| writeln!(out, "{a}, {b}, {c}, -1,"))?;
        writeln!(out, "] }} }}")
    })
}

fn lines(path: &Path, write: impl FnOnce(&mut BufWriter<fs::File>) -> io::Result<()>) -> Outcome<()> {
    let mut out = BufWriter::new(fs::File::create(path)?);
    write(&mut out)?;
    Ok(out.flush()?)
}

/// A folder of our own, which goes with all that is in it.
pub(crate) struct Folder(PathBuf);

impl Folder {
    pub(crate) fn create(parent: &Path) -> io::Result<Self> {
        let path = parent.join(format!("onering-bench-io-{}", std::process::id()));
        fs::create_dir_all(&path)?;
        Ok(Self(path))
    }

    pub(crate) fn path(&self) -> &Path {
        &self.0
    }
}

impl Drop for Folder {
    fn drop(&mut self) {
        let _ = fs::remove_dir_all(&self.0);
    }
}
