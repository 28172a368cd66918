//! What fuzzing asks of onering, as plain functions: `targets/` calls them with the bytes that libFuzzer makes up,
//! `tests/replay.rs` with the files in `seeds/`, which takes no nightly compiler.
//!
//! - `cargo +nightly fuzz run obj fuzz/corpus/obj fuzz/seeds/obj -- -dict=fuzz/dictionaries/obj.dict -max_len=4096`
//!   looks for inputs that break a target; what it learns goes to `corpus/`, which stays out of the repository.
//! - `cargo +nightly fuzz tmin obj FILE` makes a finding small. It belongs in `seeds/obj/found-WHAT`, with the fix.
//! - `cargo test --manifest-path fuzz/Cargo.toml` replays the seeds, and the corpus where there is one. It also builds
//!   the targets, uninstrumented, with a C++ compiler for libFuzzer itself.
//!
//! Seeds of a reader whose name begins with `bad-` have to be refused, `found-` may be either, and all others are read.
//! `seeds/make.py` writes the binary ones. A target is a line in `TARGETS`, a file in `targets/` with its `[[bin]]`, and
//! a folder of seeds.

mod index_buffer;
mod reads;
#[allow(dead_code, reason = "shared with tests that use more of it")]
#[path = "../../tests/common/renumbered.rs"]
mod renumbered;
mod ring;
#[path = "../../tests/common/shapes.rs"]
mod shapes;
mod written;

pub use index_buffer::index_buffer;
pub use onering_io::Format;
pub use reads::{reads, reads_any};
pub use ring::ring;
pub use written::written;

/// A function that any bytes may go to, and that panics where a promise is broken.
pub type Target = fn(&[u8]);

/// Every target by its name.
pub const TARGETS: [(&str, Target); 12] = [
    ("obj", |bytes| reads(bytes, Format::Obj)),
    ("gltf", |bytes| reads(bytes, Format::Gltf)),
    ("glb", |bytes| reads(bytes, Format::Glb)),
    ("ply", |bytes| reads(bytes, Format::Ply)),
    ("stl", |bytes| reads(bytes, Format::Stl)),
    ("off", |bytes| reads(bytes, Format::Off)),
    ("x3d", |bytes| reads(bytes, Format::X3d)),
    ("vrml", |bytes| reads(bytes, Format::Vrml)),
    ("gzip", reads_any),
    ("ring", ring),
    ("written", written),
    ("index_buffer", index_buffer),
];

/// The format that the target of this name reads; `None` where it reads none, or any.
pub fn format_of(target: &str) -> Option<Format> {
    Format::of_name(target)
}
