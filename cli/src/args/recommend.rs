//! `onering recommend`: what can be said of it.

use super::{EXIT_CODES, MeshFile};
use crate::compare::question::Question;
use crate::recommend::{Size, within_noise};

/// Say which structure to take for a mesh, by what is measured on it here and now
#[derive(Debug, clap::Args)]
#[command(long_about = about(), after_help = EXIT_CODES)]
pub(crate) struct Recommend {
    #[command(flatten)]
    pub(crate) mesh: MeshFile,
    /// The most memory there is: `500M`, `1.5G`, `64MiB`; K, M and G are powers of 1000, Ki, Mi and Gi of 1024. What has
    /// to fit is the most that building takes, the list of faces it builds from, and positions of 12 bytes each
    #[arg(long, value_name = "SIZE")]
    pub(crate) memory: Option<Size>,
    /// What the program will ask for
    #[arg(long, value_name = "WHAT", value_enum, value_delimiter = ',', default_value = "rings")]
    pub(crate) queries: Vec<Question>,
    /// The mesh will not change, and its vertices and faces may get other numbers: `sot` and `compact-stars` are
    /// candidates as well
    #[arg(long)]
    pub(crate) renumber: bool,
    /// Choose the random vertices and faces
    #[arg(long, value_name = "NUMBER", default_value_t = 2016)]
    pub(crate) seed: u64,
    /// Time to spend on each figure, in three rounds of three runs at least after one to warm up; 0 runs each once
    #[arg(long, value_name = "MILLISECONDS", default_value_t = 40)]
    pub(crate) budget: u64,
    /// Print one JSON object
    #[arg(long)]
    pub(crate) json: bool,
}

impl Recommend {
    /// What is asked for twice counts once.
    pub(super) fn check(&mut self) {
        let all = std::mem::take(&mut self.queries);
        for question in all {
            if !self.queries.contains(&question) {
                self.queries.push(question);
            }
        }
    }
}

fn about() -> String {
    format!(
        "Say which structure to take for a mesh, by what is measured on it here and now\n\n\
         Those are passed over that lack a trait that is asked for, that cannot hold the mesh, or that do not fit in the \
         memory. Of the others it is the one with the least time, by the geometric mean over what is asked for; where \
         some are {} of it, the smallest of those. A mesh that none of them holds is repaired first, and the report says \
         so.",
        within_noise()
    )
}
