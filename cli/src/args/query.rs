//! `onering query`: what can be said of it.

use super::{EXIT_CODES, MeshFile, fail, formats};
use crate::on_backend;
use crate::query::{Id, Relation};
use clap::builder::PossibleValuesParser;
use onering_io::Format;
use std::path::PathBuf;

/// Ask for one of the nine relations between vertices, edges and faces, or take the time of random queries
///
/// With --relation and --id, prints a line for each id. Otherwise prints Table 7 of Figueiredo et al. (2014): the time
/// to load, to build, and of random queries of each relation, a column for each --backend. Without FILE, a terrain that
/// is made here.
///
/// Vertices and faces are named by their numbers in the mesh, from 0; after --weld or --repair, in what became of it.
/// Edges are named by their two vertices, `3-17`, or by a number: the sides of the faces are gone through in order,
/// and each edge that is met for the first time gets the next number, from 0, whatever the backend.
#[derive(Debug, clap::Args)]
#[command(after_help = EXIT_CODES)]
pub(crate) struct Query {
    /// A mesh file, also packed with gzip; `-` is standard input. Without one, a mesh that is made here
    #[arg(value_name = "FILE")]
    pub(crate) file: Option<PathBuf>,
    /// What to ask for; TopTri's names are taken as well
    #[arg(long, value_name = "RELATION", ignore_case = true, requires = "ids")]
    pub(crate) relation: Option<Relation>,
    /// Of which element: `17`, and of an edge also `3-17` or `3,17`; may be given several times
    #[arg(long = "id", value_name = "ID", requires = "relation")]
    pub(crate) ids: Vec<Id>,
    /// Take the time of so many random queries of each relation
    #[arg(long, value_name = "NUMBER", default_value_t = 10_000, conflicts_with = "relation",
          value_parser = clap::value_parser!(u32).range(1..=10_000_000))]
    pub(crate) random: u32,
    /// Choose the random elements
    #[arg(long, value_name = "NUMBER", default_value_t = 2014)]
    pub(crate) seed: u64,
    /// Time to spend on each figure, of three runs at least after one to warm up; 0 runs each once
    #[arg(long, value_name = "MILLISECONDS", default_value_t = 100)]
    pub(crate) budget: u64,
    /// The data structure to ask; may be given several times for random queries. `vertex-graph` answers the six queries
    /// of TopTri, with cycles of three edges for faces; `searched` is no structure: every answer is searched for;
    /// `all` is each that need not search
    #[arg(long = "backend", value_name = "NAME", value_delimiter = ',', default_value = on_backend::DEFAULT,
          value_parser = PossibleValuesParser::new(names()))]
    pub(crate) backends: Vec<String>,
    /// Print JSON: an object a line for each id, with coordinates, or one object of all that was measured
    #[arg(long)]
    pub(crate) json: bool,
    /// The format of FILE, whatever its name and its content
    #[arg(long, value_name = "FORMAT", ignore_case = true, value_parser = formats::parse_read())]
    pub(crate) from: Option<Format>,
    /// Make vertices at equal positions one, before all else
    #[arg(long)]
    pub(crate) weld: bool,
    /// Make it a manifold that every backend accepts, first
    #[arg(long)]
    pub(crate) repair: bool,
}

/// The bare graph, which is none of the names that work on meshes.
pub(crate) const GRAPH: &str = "vertex-graph";
const ALL: &str = "all";

fn names() -> impl Iterator<Item = &'static str> {
    on_backend::names().chain([GRAPH, ALL])
}

impl Query {
    /// Refuses what makes no sense.
    pub(super) fn check(&self) {
        if self.relation.is_some() && (self.backends.len() > 1 || self.is_all()) {
            fail("one --backend at a time answers --relation");
        }
    }

    fn is_all(&self) -> bool {
        self.backends.iter().any(|name| name == ALL)
    }

    /// The structures to ask, each once, and whether one that refuses the mesh is passed over.
    pub(crate) fn chosen(&self) -> (Vec<&str>, bool) {
        if self.is_all() {
            let quick = on_backend::names().filter(|name| !on_backend::searches(name));
            return (quick.chain([GRAPH]).collect(), true);
        }
        let mut names: Vec<&str> = Vec::new();
        for name in &self.backends {
            if !names.contains(&name.as_str()) {
                names.push(name);
            }
        }
        (names, false)
    }

    /// What is to be read.
    pub(crate) fn mesh_file(&self) -> MeshFile {
        let Self { file, from, weld, repair, .. } = self;
        MeshFile { file: file.clone(), from: *from, backend: String::new(), weld: *weld, repair: *repair }
    }
}
