//! What became of a mesh, for people to read.

use super::change::Change;
use super::holds::Holds;
use super::target::Target;
use crate::{args, input};
use onering_io::{Format, MeshRef, Triangles};
use std::fmt::{self, Display};

/// A block of lines: from what to what, counts before and after, what was done, and what is lost.
#[derive(Debug)]
pub(crate) struct Summary {
    head: String,
    before: Counts,
    after: Counts,
    format: Format,
    done: Vec<(&'static str, String)>,
}

#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
struct Counts {
    vertices: usize,
    faces: usize,
    /// Of more than three corners.
    polygons: usize,
}

impl Counts {
    fn of(mesh: &Triangles) -> Self {
        let polygons = MeshRef::from(mesh).polygon_sizes().range(4..).map(|(_, count)| count).sum();
        Self { vertices: mesh.positions.len(), faces: mesh.faces.len(), polygons }
    }
}

impl Summary {
    /// Of a mesh as it was read.
    pub(crate) fn of(options: &args::Convert, mesh: &Triangles, format: Format, target: &Target) -> Self {
        let source = input::name_of(&options.input);
        let counts = Counts::of(mesh);
        let mut done: Vec<_> = mesh.notes.iter().map(|note| ("note", note.to_string())).collect();
        if target.loses_faces() {
            done.push(("lost", "vertex-graph holds vertices and edges only, no faces".into()));
        }
        Self {
            head: format!("{source} ({format}) -> {} ({})", target.name(), target.format()),
            before: counts,
            after: counts,
            format: target.format(),
            done,
        }
    }

    /// The mesh as it was written, and what was done to it.
    pub(crate) fn add_result(&mut self, mesh: &Triangles, change: &Change, holds: &Holds) {
        self.after = Counts::of(mesh);
        if let Some(count) = change.welded {
            self.done
                .push(("welded", counted(count, ["vertex", "vertices"]) + " at the position of another"));
        }
        if let Some(steps) = &change.repaired {
            self.done.push(("repaired", steps.clone()));
        }
        if let Some(holes) = &change.filled {
            self.done.push(("holes", holes.clone()));
        }
        if let Some(method) = change.reordered {
            self.done.push(("reordered", method.to_string()));
        }
        let format = self.format;
        if !holds.polygons && self.after.polygons > 0 {
            let polygons = counted(self.after.polygons, ["polygon was", "polygons were"]);
            self.done.push(("lost", format!("{format} holds triangles only: {polygons} cut")));
        }
        if !holds.isolated_vertices {
            let isolated = isolated(mesh);
            if isolated > 0 {
                let vertices = counted(isolated, ["vertex", "vertices"]);
                self.done
                    .push(("lost", format!("{format} holds vertices of faces only: {vertices} in none")));
            }
        }
        if !holds.equal_positions {
            let why = "vertices are numbered anew when it is read, those at equal positions as one";
            self.done.push(("lost", format!("{format} holds no vertices, but corners: {why}")));
        }
    }
}

fn isolated(mesh: &Triangles) -> usize {
    let mut is_used = vec![false; mesh.positions.len()];
    mesh.faces.as_flattened().iter().for_each(|&v| is_used[v as usize] = true);
    is_used.iter().filter(|used| !**used).count()
}

fn counted(count: usize, nouns: [&str; 2]) -> String {
    format!("{count} {}", nouns[usize::from(count != 1)])
}

impl Display for Summary {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        let Self { head, before, after, done, .. } = self;
        writeln!(f, "{head}")?;
        let counts = [
            ("vertices", before.vertices, after.vertices, ""),
            ("triangles", before.faces, after.faces, ""),
            ("polygons", before.polygons, after.polygons, ", of more than 3 corners"),
        ];
        for (name, before, after, what) in counts {
            match (before, after) {
                (0, 0) if name == "polygons" => {}
                _ if before == after => writeln!(f, "  {name:<11}{before}{what}")?,
                _ => writeln!(f, "  {name:<11}{before} -> {after}{what}")?,
            }
        }
        done.iter().try_for_each(|(name, what)| writeln!(f, "  {name:<11}{what}"))
    }
}
